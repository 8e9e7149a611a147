"""Exercise 3.3: the surface swept by all lines that meet three given lines."""

from chasles.derivations.exercises.calculations.quadrics import PARAMETER, kind_of, signature_of, transversal
from chasles.derivations.exercises.three_lines import (
    ANSWERS,
    KINDS,
    M,
    constant_part,
    determinant_of_M,
    determinant_of_quadric,
    e1,
    e2,
    e3,
    g,
    h,
    half_gradient,
    in_directions,
    linear_part,
    locus_is_a_quadric,
    moments,
    mu_12,
    mu_23,
    mu_31,
    mutual_moments,
    p1,
    p2,
    p3,
    quadratic_part,
    triple,
    two_moments,
    whole,
    with_opposite_equation,
)
from chasles.derivations.notation import p

from chasles.exact.evaluate import Value
from chasles.exact.numbers import is_zero, sign
from chasles.exercises.data import DataError
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Curve, Line, Picture, Point
from chasles.exercises.worksheet import Worksheet
from chasles.statements.exercise import Datum, Exercise, ListOf, Tuple, vector_shape
from chasles.vocabulary import (
    det,
    inverse,
    number,
    over,
)

KIND = (
    "What surface is it, if no two of the lines are in one plane? The determinant of the 4 x 4 matrix is positive, and "
    "f vanishes at real points: two of the matrix's eigenvalues are positive and two are negative, and the surface is "
    "ruled. It is a hyperboloid of one sheet where det M is not zero, and a hyperbolic paraboloid where all three "
    "lines are parallel to one plane. Of M, two eigenvalues are positive if det M < 0, two are negative if det M > 0."
)


def solve(sheet: Worksheet) -> str:
    """The three claims hold for all lines; then numbers."""
    for k, (point, way, (a, e)) in enumerate(zip((p1, p2, p3), (e1, e2, e3), sheet["lines"], strict=True), 1):
        if not any(e):
            raise DataError(f"lines[{k}], direction: expected a vector other than zero")
        sheet.given({point: a, way: e}, f"Line {k}.")
    sheet.step(locus_is_a_quadric.says, cites=(locus_is_a_quadric,))
    for part in (*moments, quadratic_part, linear_part, constant_part, *mutual_moments):
        sheet.compute(part)
    turn = sheet.show(triple, "The triple product of the directions.")
    det_M, det_M4 = determinants(sheet)
    kind, signature = kind_of(sheet.value(whole)), signature_of(sheet.value(M))
    sheet.step(KIND)
    sheet.step("For these lines, by ranks and signs:", ("kind", kind), ("signs of the eigenvalues", signature))
    centre, f_centre = None, None
    surface = locus_is_a_quadric.right
    if not is_zero(det_M):
        centre = sheet.show(-over(1, 2) * inverse(M) @ g, "Its centre, where the gradient vanishes.", named="centre")
        f_centre = sheet.show(surface, "There f has the value", at={p: centre})
    wording = {
        "h > 0": sign(sheet.value(h)) > 0,
        "det(M) is not zero": not is_zero(det_M),
        "M is singular, as the hint says": is_zero(det_M),
        "det(M) < 0": sign(det_M) < 0,
        "M has two positive and one negative eigenvalues": signature == (2, 1),
    }
    sheet.step(
        "What the exercise says of such surfaces. It cannot hold for all: -f describes the same surface as f, with -M "
        "for M and -h for h, and det(-M) = -det(M); nor does h > 0 choose between them, as h changes with the origin.",
        *wording.items(),
        cites=(determinant_of_M,),
    )
    zero = sheet.value(number(0))
    for k, (a, e) in enumerate(sheet["lines"], 1):
        sheet.check((sheet.value(surface, {p: a + PARAMETER * e}), zero), f"Every point of line {k} satisfies f = 0.")
    sheet.check((det(whole), determinant_of_quadric.right), "The determinant of the 4 x 4 matrix, directly.")
    mu = {f"mu{k}": sheet.value(m) for k, m in ((12, mu_12), (23, mu_23), (31, mu_31))}
    sheet.answer(M=sheet.value(M), g=sheet.value(g), h=sheet.value(h), det_M=det_M, det_M4=det_M4, triple=turn, **mu)
    sheet.answer(signature_M=[zero + s for s in signature], kind=kind, centre=centre, f_centre=f_centre)
    sheet.answer(wording=wording)
    sheet.picture = picture(sheet["lines"])
    return "degenerate" if is_zero(det_M4) else "quadric"


def determinants(sheet: Worksheet) -> tuple[Value, Value]:
    """Those of M and of the 4 x 4 matrix, from what these are as seen along the three lines."""
    sheet.state(in_directions)
    says = (
        "Determinants of both sides: that of a product is the product, so that on the left it is the triple product "
        "squared times det M, and on the right (triple/2)^3 2 mu_12 mu_23 mu_31. The triple product cancels; where it "
        "vanishes, both sides of what is left are polynomials that are equal nearby. So det M vanishes if two of the "
        "lines are in one plane, or all three are parallel to one; and not else."
    )
    det_M = sheet.compute(determinant_of_M, says)
    sheet.state(half_gradient)
    sheet.state(two_moments)
    says = (
        "The 4 x 4 matrix, seen along the three lines from P_1, has these two as its blocks, and a zero in the corner, "
        "as P_1 is on the surface. Expanded, its determinant is (triple/4)^2 (mu_12 mu_31)^2 times the square of the "
        "last sum: triple^2 (mu_12 mu_23 mu_31)^2 / 16. It is triple^2 times that of the matrix itself, as before. So "
        "the quadric is degenerate if two of the lines are in one plane, and not else."
    )
    return det_M, sheet.show(determinant_of_quadric.right, says, named="determinant of the 4 x 4 matrix")


def picture(lines: list[tuple[Value, Value]]) -> Picture:
    """The three lines, and some that meet them all."""
    drawn = [Curve((a - 2 * e, a + 2 * e), f"line {k}") for k, (a, e) in enumerate(lines, 1)]
    (a, e), *others = lines
    starts = [a + quarter * e / 4 for quarter in range(-8, 9)]
    swept = [Line(start, way) for start in starts if any(way := transversal(start, others))]
    marks = [Point(a, f"P{k}") for k, (a, _) in enumerate(lines, 1)]
    return Picture("Lines that meet three lines", (*swept, *drawn, *marks))


def instance(draw: Draw) -> dict[str, Value]:
    """Three lines, anyhow."""
    return {"lines": [[*draw.written(a=draw.vector(), e=draw.vector()).values()] for _ in range(3)]}


exercise = Exercise(
    "3.3",
    "All lines that meet three lines",
    asked=(
        "Show that the lines that meet three given lines sweep a quadric, and find it.",
        "Show when its matrix M is not singular, and what kind of surface it is.",
    ),
    data=(
        Datum(
            "lines",
            ListOf(Tuple((("point", vector_shape()), ("direction", vector_shape()))), 3, 3),
            [[[1, 0, 0], [0, 1, 1]], [[0, 1, 0], [-1, 0, 1]], [[-1, 0, 0], [0, -1, 1]]],
            "three lines: a point of each and its direction",
        ),
    ),
    statuses=("quadric", "degenerate"),
    assumptions=("Directions are used as they are given, of whatever length.",),
    stand_ins={"lines": "The book gives no lines; three rulings of the hyperboloid X^2 + Y^2 - Z^2 = 1 stand in."},
    solve=solve,
    instance=instance,
    answers=ANSWERS,
    synonyms=KINDS,
    alternatives=with_opposite_equation,
)
