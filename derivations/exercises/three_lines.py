"""What Exercise 3.3 states: the quadric of all lines that meet three lines, and its determinants."""

from chasles.derivations.notation import p

from chasles.exact.evaluate import Value
from chasles.exact.numbers import sign
from chasles.exercises.worksheet import Worksheet
from chasles.statements import Claim, Definition
from chasles.statements.exercise import Answer, Else, Record, Scalar, Truth, Word, matrix_shape, vector_shape
from chasles.vocabulary import (
    LENGTH,
    Node,
    column,
    cross,
    det,
    dot,
    matrix,
    number,
    over,
    paren,
    row,
    scalar,
    square,
    vector,
)

p1, p2, p3 = (vector(f"p_{k}", f"p_{k}", f"position of a point of line {k}", LENGTH) for k in (1, 2, 3))
e1, e2, e3 = (vector(f"e_{k}", f"e_{k}", f"direction of line {k}, of any length") for k in (1, 2, 3))
n1, n2, n3 = (vector(f"n_{k}", f"n_{k}", f"moment of line {k} about the origin", LENGTH) for k in (1, 2, 3))
m1, m2, m3 = (vector(f"m_{k}", f"m_{k}", f"moment of line {k} about P", LENGTH) for k in (1, 2, 3))
mu_12, mu_23, mu_31 = (scalar(f"mu_{k}", rf"\mu_{{{k}}}", f"moment of lines {k}", LENGTH) for k in (12, 23, 31))
M = square("M", "M", "matrix of the quadric", LENGTH)
g = vector("g", "g", "linear part of the quadric", LENGTH**2)
h = scalar("h", "h", "constant of the quadric", LENGTH**3)
triple = det(row(e1, e2, e3))
whole = matrix((M, over(1, 2) * g), (over(1, 2) * g.T, h))


def _symmetric(n: Node, c: Node) -> Node:
    return n @ c.T + c @ n.T


moments = tuple(
    Definition("Ex 3.3", n, cross(a, e), part=k, says=f"The moment of line {k} about the origin.")
    for k, (n, a, e) in enumerate(((n1, p1, e1), (n2, p2, e2), (n3, p3, e3)), 1)
)
moments_about_p = tuple(
    Definition("Ex 3.3", m, cross(a - p, e), part=k, says=f"The moment of line {k} about P.")
    for k, (m, a, e) in enumerate(((m1, p1, e1), (m2, p2, e2), (m3, p3, e3)), 4)
)
mutual_moments = tuple(
    Definition("Ex 3.3", mu, dot(cross(a - b, d), e), part=k, says="The moment of one line about another.")
    for k, (mu, a, b, d, e) in enumerate(((mu_12, p1, p2, e1, e2), (mu_23, p2, p3, e2, e3), (mu_31, p3, p1, e3, e1)), 7)
)
c23, c31, c12 = cross(e2, e3), cross(e3, e1), cross(e1, e2)
quadratic_part = Definition(
    "Ex 3.3", M, over(1, 2) * paren(_symmetric(n1, c23) + _symmetric(n2, c31) + _symmetric(n3, c12)), part=10,
    says="The matrix of the quadric.",
)  # fmt: skip
linear_part = Definition(
    "Ex 3.3", g, -cross(e1, cross(n2, n3)) - cross(e2, cross(n3, n1)) - cross(e3, cross(n1, n2)), part=11,
    says="Its linear part.",
)  # fmt: skip
constant_part = Definition("Ex 3.3", h, dot(n1, cross(n2, n3)), part=12, says="Its constant.")
_parts = (*moments, quadratic_part, linear_part, constant_part)

gradient = M @ p1 + over(1, 2) * g
of_2_by_3, of_3_by_2 = dot(cross(p2 - p1, e2), e3), dot(cross(p3 - p1, e3), e2)

locus_is_a_quadric = Claim(
    "Ex 3.3", dot(m1, cross(m2, m3)), p.T @ M @ p + g.T @ p + h, part=13, given=(*_parts, *moments_about_p),
    says="A line through P meets all three lines if their moments about P are normal to it, hence lie in one plane.",
)  # fmt: skip
determinant_of_M = Claim(
    "Ex 3.3", det(M), over(1, 4) * triple * mu_12 * mu_23 * mu_31, part=14, given=(*_parts, *mutual_moments),
    says="det M vanishes if two of the lines are in one plane, or all three are parallel to one; and not else.",
)  # fmt: skip
determinant_of_quadric = Claim(
    "Ex 3.3", det(whole), over(1, 16) * paren(mu_12 * mu_23 * mu_31) ** 2, part=15, given=(*_parts, *mutual_moments),
    says="The quadric is degenerate if two of the lines are in one plane, and not else.",
)  # fmt: skip

KINDS = {
    "hyperboloid of one sheet": "one-sheet hyperboloid",
    "one-sheeted hyperboloid": "one-sheet hyperboloid",
    "single-sheet hyperboloid": "one-sheet hyperboloid",
    "paraboloid": "hyperbolic paraboloid",
    "two planes": "two intersecting planes",
    "plane": "one plane, counted twice",
    "double plane": "one plane, counted twice",
}
_SENTENCES = (
    "h > 0",
    "det(M) is not zero",
    "M is singular, as the hint says",
    "det(M) < 0",
    "M has two positive and one negative eigenvalues",
)
ANSWERS = (
    Answer("M", matrix_shape(), "of f(p) = p^T M p + g^T p + h, by rows; f = m_1 . (m_2 x m_3), or -f throughout"),
    Answer("g", vector_shape(), "the linear part of f"),
    Answer("h", Scalar(), "the constant of f"),
    Answer("det_M", Scalar(), "the determinant of M"),
    Answer("det_M4", Scalar(), "the determinant of the 4 x 4 matrix [[M, g/2], [g^T/2, h]]"),
    Answer("triple", Scalar(), "e_1 . (e_2 x e_3), of the directions as they are given"),
    *(
        Answer(f"mu{i}{j}", Scalar(), f"[(p_{i} - p_{j}) x e_{i}] . e_{j}, of the directions as they are given")
        for i, j in (("1", "2"), ("2", "3"), ("3", "1"))
    ),
    Answer("signature_M", vector_shape(2), "how many eigenvalues of M are positive, and how many negative"),
    Answer(
        "kind",
        Word(
            (
                "one-sheet hyperboloid",
                "hyperbolic paraboloid",
                "two intersecting planes",
                "two parallel planes",
                "one plane, counted twice",
                "no point",
                "all of space",
                "cone or cylinder",
            )
        ),
        "the kind of the surface",
    ),
    Answer("centre", Else(vector_shape()), "the centre of the surface; null where M is singular"),
    Answer("f_centre", Else(Scalar()), "f there; null where M is singular"),
    Answer("wording", Record(_SENTENCES, Truth()), "whether what the book says holds of this f"),
)


def with_opposite_equation(sheet: Worksheet, given: dict[str, Value]) -> list[dict[str, Value]]:
    """With -f for f, which is zero on the same surface, and all that follows."""
    right = sheet.answers
    signature = list(reversed(right["signature_M"]))
    turned = {name: -right[name] for name in ("M", "g", "h", "det_M")}
    truths = (
        sign(turned["h"]) > 0,
        right["wording"][_SENTENCES[1]],
        right["wording"][_SENTENCES[2]],
        sign(turned["det_M"]) < 0,
        signature == [2, 1],
    )
    center = right["f_centre"]
    turned["f_centre"] = center if center is None else -center
    return [turned | {"signature_M": signature, "wording": dict(zip(_SENTENCES, truths, strict=True))}]


in_directions = Claim(
    "Ex 3.3", row(e1, e2, e3).T @ M @ row(e1, e2, e3),
    over(1, 2) * triple * matrix((number(0), mu_12, mu_31), (mu_12, number(0), mu_23), (mu_31, mu_23, number(0))),
    part=16, given=(*_parts, *mutual_moments),
    says="Seen along the three directions, M has zeros on its diagonal: f vanishes all along each line.",
)  # fmt: skip
half_gradient = Claim(
    "Ex 3.3", row(e1, e2, e3).T @ gradient,
    over(1, 2) * column(number(0), mu_12 * of_3_by_2, -mu_31 * of_2_by_3), part=17, given=(*_parts, *mutual_moments),
    says="Half the gradient at P_1, seen along the three directions: the moments about P_1, multiplied out.",
)  # fmt: skip
two_moments = Claim(
    "Ex 3.3", of_2_by_3 + of_3_by_2, mu_23, part=18, given=mutual_moments,
    says="The moments in it add up to one.",
)  # fmt: skip
