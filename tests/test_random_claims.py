"""Claims made up at random: whatever the prover says of them is held against exact values at points of our own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from random import Random

import pytest

from chasles.prover.decide import decide_problem
from chasles.statements import (
    Claim,
    Hypothesis,
    Problem,
    nonzero,
    orthonormal,
    perpendicular,
    problem_of,
    rotation,
    unit,
)
from chasles.verdict import Fails, Holds, HoldsUnder, IllFormed
from chasles.vocabulary import (
    CPM,
    Identity,
    Misfit,
    Negative,
    Node,
    Number,
    Zero,
    children,
    cos,
    cross,
    det,
    dot,
    norm,
    rate,
    rebuilt,
    scalar,
    sin,
    square,
    tr,
    vect,
    vector,
)

from .exact_words import Broken, Words, number_of
from .explanations import completions

a, b, e, u, v, w = (vector(name, name, "a vector") for name in "abeuvw")
x, y, phi = (scalar(name, name, "a scalar") for name in ("x", "y", "phi"))
Q, M = (square(name, name, "a matrix") for name in "QM")
one, zero = Identity(3), Zero(3, 1)
ASSUMED = (
    unit(e),
    rotation(Q),
    perpendicular(a, b),
    orthonormal(u, v, w),
    nonzero(x),
    nonzero(1 - cos(phi), "phi != 0"),
)

# Each line is the same thing twice, where the hypotheses hold.
TWINS: tuple[tuple[Node, Node], ...] = (
    (cross(a, b), -cross(b, a)),
    (cross(a, b), CPM(a) @ b),
    (cross(a, cross(b, e)), dot(a, e) * b - dot(a, b) * e),
    (dot(a, b), Number(Fraction(0))),
    (dot(e, e), Number(Fraction(1))),
    (norm(e) ** 2, Number(Fraction(1))),
    (norm(cross(a, b)) ** 2, norm(a) ** 2 * norm(b) ** 2),
    (CPM(e) @ CPM(e), e @ e.T - one),
    (CPM(e) ** 2 @ CPM(e), -CPM(e)),
    (Q.T @ Q, one),
    (Q @ CPM(a) @ Q.T, CPM(Q @ a)),
    (det(Q), Number(Fraction(1))),
    (Q @ cross(a, b), cross(Q @ a, Q @ b)),
    (cross(u, v), w),
    (u @ u.T + v @ v.T + w @ w.T, one),
    (dot(u, cross(v, w)), dot(u, u)),
    (cos(phi) ** 2 + sin(phi) ** 2, Number(Fraction(1))),
    (sin(2 * phi), 2 * sin(phi) * cos(phi)),
    (sin(phi) ** 2 / (1 - cos(phi)), 1 + cos(phi)),
    (x * y / x, y),
    (vect(M), -vect(M.T)),
    (vect(CPM(a)), a),
    (tr(M), tr(M.T)),
    (M + M.T, (M + M.T).T),
    (det(M.T), det(M)),
)
RATES: tuple[tuple[Node, Node], ...] = (
    (dot(rate(e), e), Number(Fraction(0)) * dot(rate(e), e)),
    (rate(Q).T @ Q, -(Q.T @ rate(Q))),
    (dot(rate(a), b), -dot(a, rate(b))),
    (rate(cos(phi)), -(sin(phi) * rate(phi))),
    (rate(cross(a, b)), cross(rate(a), b) + cross(a, rate(b))),
    (rate(y / x), rate(y) / x - y * rate(x) / x**2),
    (rate(w), cross(rate(u), v) + cross(u, rate(v))),
    (rate(CPM(e) @ CPM(e)), rate(e) @ e.T + e @ rate(e).T),
)
VECTORS: tuple[Node, ...] = (a, b, e, u, v, w, Q @ a, cross(a, e), x * e, M @ b, cos(phi) * u)
SCALARS: tuple[Node, ...] = (x, y, Number(Fraction(2)), cos(phi), dot(a, e), 1 / x)
CLAIMS = 150


def shuffled(node: Node, draw: Random) -> Node:
    """The expression with terms and scalars in another place; the value is the same."""
    parts = tuple(shuffled(part, draw) for part in children(node))
    node = rebuilt(node, parts) if parts else node
    if node.shape == (3, 1) and draw.random() < 0.15:
        other = draw.choice(VECTORS[:6])
        return draw.choice((one @ node, node + zero, Negative(-node), node + other - other))
    return node


def embedded(left: Node, right: Node, draw: Random) -> tuple[Node, Node]:
    """Both sides within the same larger expression."""
    for _ in range(draw.randint(0, 2)):
        wrap = partial(draw.choice(wraps(left)), draw.choice(VECTORS), draw.choice(SCALARS))
        left, right = wrap(left), wrap(right)
    return left, right


def wraps(node: Node) -> tuple[Callable[[Node, Node, Node], Node], ...]:
    """Larger expressions that contain another vector, another scalar, and then the expression itself."""
    if node.is_scalar:
        return (lambda v, s, x: x * s, lambda v, s, x: x + x * s, lambda v, s, x: x * v)
    if node.shape == (3, 1):
        return (
            lambda v, s, x: cross(x, v),
            lambda v, s, x: dot(x, v),
            lambda v, s, x: s * x - v,
            lambda v, s, x: Q @ x,
        )
    return (lambda v, s, x: x @ v, lambda v, s, x: x.T, lambda v, s, x: tr(x), lambda v, s, x: M @ x)


def made_up(draw: Random) -> Claim:
    """A claim that may or may not be true: one of the twins, embedded, perhaps with a hypothesis too few or a slip."""
    while True:
        twins = draw.choice(TWINS if draw.random() < 0.7 else RATES)
        assumed = ASSUMED if draw.random() < 0.6 else draw.sample(ASSUMED, len(ASSUMED) - 1)
        try:
            left, right = (shuffled(side, draw) for side in embedded(*twins, draw))
            if draw.random() < 0.3:
                right = draw.choice((right + right, -right, right - left, right * x))
            return Claim("1", left, right, assuming=tuple(assumed))
        except Misfit:
            continue


def points(problem: Problem, draw: Random) -> Iterator[dict[str, Fraction]]:
    """Points of our own that satisfy the hypotheses: vectors, triads and rotations turn with spins of their own."""
    while True:
        values: dict[str, list[list[Fraction]]] = {}
        for symbol in (a, b, e, u, v, w, x, y, phi, Q, M):
            rows, columns = symbol.shape
            values[symbol.name] = [[number(draw) for _ in range(columns)] for _ in range(rows)]
            values[f"{symbol.name}_dot"] = [[number(draw) for _ in range(columns)] for _ in range(rows)]
        for names in (("Q",), ("u", "v", "w"), ("e",)):
            turned, spun = turning(draw)
            for k, name in enumerate(names):
                take = slice(0, 3) if name == "Q" else slice(k, k + 1)
                values[name] = [row[take] for row in turned]
                values[f"{name}_dot"] = [row[take] for row in spun]
        perpendicular_pair(values, draw)
        point = {"cos(phi)": Fraction(0), "sin(phi)": Fraction(0)}
        t = number(draw)
        point["cos(phi)"], point["sin(phi)"] = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        for name, rows in values.items():
            for i, row in enumerate(rows):
                for j, value in enumerate(row):
                    index = "" if len(rows) == 1 else f"_{i + 1}" if len(row) == 1 else f"_{i + 1}{j + 1}"
                    point[name + index] = value
        del point["phi"]
        try:
            Words(problem, point).require()
        except Broken:
            continue
        yield point


def number(draw: Random) -> Fraction:
    return Fraction(draw.randint(-6, 6), draw.randint(1, 3))


def turning(draw: Random) -> tuple[list[list[Fraction]], list[list[Fraction]]]:
    """A rotation by Cayley's formula with its rate."""
    p, q, r = (number(draw) for _ in range(3))
    below = 1 + p * p + q * q + r * r
    rows = [
        [1 + p * p - q * q - r * r, 2 * (p * q - r), 2 * (p * r + q)],
        [2 * (p * q + r), 1 - p * p + q * q - r * r, 2 * (q * r - p)],
        [2 * (p * r - q), 2 * (q * r + p), 1 - p * p - q * q + r * r],
    ]
    matrix = [[entry / below for entry in row] for row in rows]
    k, m, n = (number(draw) for _ in range(3))
    spin = [[Fraction(0), -n, m], [n, Fraction(0), -k], [-m, k, Fraction(0)]]
    rate_ = [[sum((spin[i][h] * matrix[h][j] for h in range(3)), Fraction(0)) for j in range(3)] for i in range(3)]
    return matrix, rate_


def perpendicular_pair(values: dict[str, list[list[Fraction]]], draw: Random) -> None:
    """Make b normal to a by its last entry, and its rate fit."""
    if draw.random() < 0.3:
        values["b"], values["b_dot"] = [[Fraction(0)]] * 3, [[Fraction(0)]] * 3
        return
    one_, other, one_rate, other_rate = (values[name] for name in ("a", "b", "a_dot", "b_dot"))
    if not one_[2][0]:
        one_[2][0] = Fraction(1)
    other[2][0] = -(one_[0][0] * other[0][0] + one_[1][0] * other[1][0]) / one_[2][0]
    rest = sum((one_rate[i][0] * other[i][0] for i in range(3)), Fraction(0))
    rest += one_[0][0] * other_rate[0][0] + one_[1][0] * other_rate[1][0]
    other_rate[2][0] = -rest / one_[2][0]


def judged(claim: Claim, draw: Random) -> str:
    """The verdict's name, once it has been held against the values."""
    problem = problem_of(claim)
    verdict = decide_problem(problem, claim.assuming)
    if isinstance(verdict, Holds | HoldsUnder):
        needed = problem_with(problem, verdict.needs)
        for _, point in zip(range(3), points(needed, draw), strict=False):
            left, right = Words(needed, point).sides(claim.left, claim.right)
            assert left == right, f"{claim.left} = {claim.right} is said to hold under {verdict.needs}: {point}"
    elif isinstance(verdict, Fails):
        shown = verdict.counterexample
        words = next(completions(problem, shown))
        i, j = shown.entry
        left, right = (side[i - 1][j - 1] for side in words.sides(claim.left, claim.right))
        assert left != right, f"{claim.left} = {claim.right}: {shown}"
        assert (left, right) == (number_of(shown.left), number_of(shown.right)), shown
    else:
        assert isinstance(verdict, IllFormed), f"{claim.left} = {claim.right}: {verdict}"
        assert all(symbol in verdict.reason for symbol in ("divides by",))
    return verdict.name


def problem_with(problem: Problem, needs: tuple[str, ...]) -> Problem:
    """The problem with no more hypotheses than a verdict needs."""
    kept: tuple[Hypothesis, ...] = tuple(h for h in problem.hypotheses if h.text in needs)
    return Problem(problem.goals, problem.rules, problem.conditions, problem.unknowns, kept)


@pytest.mark.sampled(6)
@pytest.mark.parametrize("seed", range(CLAIMS // 15))
def test_what_is_said_of_random_claims_is_so(seed: int) -> None:
    draw = Random(seed)
    counted = Counter(judged(made_up(draw), draw) for _ in range(15))
    assert counted["fails"]
    assert counted["holds"] + counted["holds-under"]


def test_the_values_would_notice_a_wrong_verdict() -> None:
    draw = Random(1)
    problem = problem_of(Claim("1", dot(e, e), Number(Fraction(1)), assuming=(unit(e),)))
    assert all(
        Words(problem, p).value(dot(e, e)) == [[1]] for _, p in zip(range(5), points(problem, draw), strict=False)
    )
    bare = problem_with(problem, ())
    assert isinstance(decide_problem(bare), Fails)
    with pytest.raises(Broken, match="not satisfied"):
        Words(problem, {"e_1": Fraction(1), "e_2": Fraction(1), "e_3": Fraction(0)}).require()
