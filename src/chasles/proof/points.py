"""Exact rational points that satisfy a problem's hypotheses, simple ones first.

Unit vectors are stereographic, cosine and sine Pythagorean, rotations come from quaternions, rates from spins;
conditions are satisfied by what they determine, norms by moving a free vector until its norm is rational.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import reduce
from math import comb, isqrt, prod
from random import Random

from chasles.proof.adjustment import adjusted
from chasles.proof.context import Context
from chasles.proof.evaluation import Point, evaluate, ratio_at, satisfies
from chasles.proof.plain_draw import PlainDraw
from chasles.proof.ratios import Ratio
from chasles.proof.rings import Polynomial
from chasles.proof.unfold import Matrix
from chasles.proof.values import divided
from chasles.statements import Hypothesis
from chasles.vocabulary import Node, Symbol

__all__ = ["Point", "evaluate", "plain", "ratio_at", "sample", "satisfies"]

Numbers = list[list[Fraction]]

ATTEMPTS = 400
SIMPLE_ATTEMPTS = 8
AXES = ((0, 0, 1), (1, 0, 0), (0, 1, 0))
UNIT_VECTORS = tuple(
    tuple(Fraction(k, d) for k in numbers)
    for *numbers, d in (
        (0, 0, 1, 1), (1, 0, 0, 1), (0, 1, 0, 1), (0, 3, 4, 5), (3, 0, 4, 5), (4, 3, 0, 5), (1, 2, 2, 3), (2, 1, -2, 3),
        (2, -2, 1, 3), (2, 3, 6, 7), (-6, 2, 3, 7), (4, 4, 7, 9),
    )
)  # fmt: skip
CIRCLE = tuple(
    (Fraction(c, d), Fraction(s, d))
    for c, s, d in (
        (0, 1, 1),
        (3, 4, 5),
        (-1, 0, 1),
        (4, 3, 5),
        (0, -1, 1),
        (-3, 4, 5),
        (5, 12, 13),
        (-4, -3, 5),
        (8, 15, 17),
    )
)
QUARTERS = tuple((Fraction(c), Fraction(s)) for c, s in ((1, 0), (0, 1), (-1, 0), (0, -1)))
PYTHAGOREAN = (
    (0, 0, 1, 1),
    (1, 2, 2, 3),
    (0, 3, 4, 5),
    (2, 1, 2, 3),
    (2, -1, 2, 3),
    (2, 3, 6, 7),
    (1, -2, 2, 3),
    (4, 4, 7, 9),
)


def sample(
    context: Context, solved: dict[str, tuple[Polynomial, Polynomial]], *, simple: bool = True
) -> Iterator[Point]:
    """Points that satisfy the hypotheses, the norms and the conditions, simple ones first, until a number of attempts.

    `solved` gives numerator and denominator of each variable that the conditions determine.
    """
    draw = Random(0)
    for attempt in range(0 if simple else SIMPLE_ATTEMPTS, ATTEMPTS):
        point = _try(context, solved, draw, attempt)
        if point is not None and (satisfies(context, point) or (not solved and adjusted(context, point))):
            yield point


def plain(context: Context, solved: dict[str, tuple[Polynomial, Polynomial]], attempts: int) -> Iterator[Point]:
    """Different points that satisfy the same, of axes, quarter turns, zeros and ones where that is possible."""
    draw = PlainDraw(0)
    seen: set[tuple[tuple[str, Fraction], ...]] = set()
    for _ in range(attempts):
        point = _try(context, solved, draw, 0)
        key = None if point is None else tuple(point.items())
        if point is None or key is None or key in seen:
            continue
        seen.add(key)
        if satisfies(context, point) or (not solved and adjusted(context, point)):
            yield point


def _try(
    context: Context, solved: dict[str, tuple[Polynomial, Polynomial]], draw: Random, attempt: int
) -> Point | None:
    rich = attempt >= SIMPLE_ATTEMPTS
    values: dict[tuple[Symbol, int], Numbers] = {}
    orders: dict[Symbol, int] = {}
    for variable in context.variables:
        if variable.kind == "entry" and variable.symbol is not None:
            orders[variable.symbol] = max(orders.get(variable.symbol, 0), variable.order)
    bound: set[Symbol] = set()
    for hypothesis in context.active:
        bound |= _bind(hypothesis, orders, values, draw, rich)
    for symbol, highest in orders.items():
        for order in range(highest + 1):
            if (symbol, order) not in values:
                values[symbol, order] = _free(symbol.shape, draw, rich)
    point: Point = {}
    for variable in context.variables:
        if variable.kind == "entry" and variable.symbol is not None and variable.name not in solved:
            point[variable.name] = values[variable.symbol, variable.order][variable.row][variable.column]
    _angles(context, point, draw, rich)
    _moments(context, point, draw, rich)
    return _finish(context, solved, point, bound, draw, rich)


def _moments(context: Context, point: Point, draw: Random, rich: bool) -> None:
    """Moments of a body of a few elements of unit volume and positive density, so that they are those of some body."""
    moments = [variable for variable in context.variables if variable.kind == "moment"]
    if not moments:
        return
    names = dict.fromkeys(name for variable in moments for name, _ in variable.factors)
    reach = 4 if rich else 1
    elements = [
        {name: Fraction(draw.randint(*((1, 3) if name in context.densities else (-reach, reach)))) for name in names}
        for _ in range(8 if rich else draw.randint(1, 4))
    ]
    for variable in moments:
        for element in elements:
            powers = (element[name] ** exponent for name, exponent in variable.factors)
            point[variable.name] = point.get(variable.name, Fraction(0)) + prod(powers, start=Fraction(1))


def _angles(context: Context, point: Point, draw: Random, rich: bool) -> None:
    """Rational cosines and sines; quarter turns where pi measures the angle too."""
    for variable in context.variables:
        if variable.kind != "cos" or variable.symbol is None:
            continue
        if context.pi_measures:
            quarters = draw.choice((1, 2, -1, 3, -2, 5))
            cosine, sine = QUARTERS[quarters % 4]
            point[variable.symbol.name] = Fraction(quarters, 2) / context.unfold.unit(variable.symbol)
        else:
            cosine, sine = _circle(draw) if rich else draw.choice(CIRCLE)
            if variable.symbol.name in point:
                point[variable.symbol.name] = Fraction(1)
                cosine, sine = (cosine, sine) if sine or cosine < 0 else CIRCLE[1]
        point[variable.name] = cosine
        point["sin" + variable.name.removeprefix("cos")] = sine
    if "pi" in context.field.ring.names:
        point["pi"] = Fraction(1)


def _circle(draw: Random) -> tuple[Fraction, Fraction]:
    t = Fraction(draw.randint(-7, 7), draw.randint(1, 5))
    return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)


def _free(shape: tuple[int, int], draw: Random, rich: bool) -> Numbers:
    rows, columns = shape
    if not rich and columns == 1 and rows == 3:
        axis = draw.choice([*AXES, (0, 0, 0), (1, 1, 0), (1, 2, 0), (1, 0, 1), (1, 2, 3)])
        return [[Fraction(x)] for x in axis]
    reach = 5 if rich else 2
    return [[Fraction(draw.randint(-reach, reach)) for _ in range(columns)] for _ in range(rows)]


def _spin(numbers: Numbers, spin: list[Fraction]) -> Numbers:
    """Spin x each column."""
    x, y, z = spin
    skew = [[Fraction(0), -z, y], [z, Fraction(0), -x], [-y, x, Fraction(0)]]
    return [
        [sum((skew[i][k] * numbers[k][j] for k in range(3)), Fraction(0)) for j in range(len(numbers[0]))]
        for i in range(3)
    ]


def _plus(one: Numbers, other: Numbers) -> Numbers:
    return [[a + b for a, b in zip(row, line, strict=True)] for row, line in zip(one, other, strict=True)]


def _turning(numbers: Numbers, order: int, draw: Random, rich: bool) -> list[Numbers]:
    """The values and rates of something that turns: x, w x x, w' x x + w x (w x x) and so on, by Leibniz's rule."""
    rates = [numbers]
    spins = [[row[0] for row in _free((3, 1), draw, rich)] for _ in range(max(order, 2))]
    for reached in range(order):
        parts = [_spin(rates[reached - k], [comb(reached, k) * x for x in spins[k]]) for k in range(reached + 1)]
        rates.append(reduce(_plus, parts))
    return rates


def _bind(
    hypothesis: Hypothesis,
    orders: dict[Symbol, int],
    values: dict[tuple[Symbol, int], Numbers],
    draw: Random,
    rich: bool,
) -> set[Symbol]:
    """Give the subjects of a hypothesis values that satisfy it."""
    subjects = [s for s in hypothesis.subjects if isinstance(s, Symbol)]
    match hypothesis.kind:
        case "unit":
            (vector,) = subjects
            if (vector, 0) not in values:
                rates = _turning([[x] for x in _unit_vector(draw, rich)], orders.get(vector, 0), draw, rich)
                values |= {(vector, k): rate for k, rate in enumerate(rates)}
        case "rotation":
            (matrix,) = subjects
            rates = _turning(_rotation(draw, rich), orders.get(matrix, 0), draw, rich)
            values |= {(matrix, k): rate for k, rate in enumerate(rates)}
        case "half_turn":
            (matrix,) = subjects
            rates = _turning(_half_turn(draw, rich), orders.get(matrix, 0), draw, rich)
            values |= {(matrix, k): rate for k, rate in enumerate(rates)}
        case "orthonormal":
            order = max(orders.get(s, 0) for s in subjects)
            rates = _turning(_rotation(draw, rich), order, draw, rich)
            for j, vector in enumerate(subjects):
                values |= {(vector, k): [[row[j]] for row in rate] for k, rate in enumerate(rates)}
        case "positive":
            (quantity,) = subjects
            values[quantity, 0] = [[Fraction(draw.randint(1, 5))]]
        case "definite":
            (matrix,) = subjects
            for k in range(orders.get(matrix, 0) + 1):
                values[matrix, k] = _definite(matrix.shape[0], draw, rich)
        case "symmetric":
            (matrix,) = subjects
            if (matrix, 0) in values:
                values[matrix, 0] = _half_turn(draw, rich)
                return set(subjects)
            for k in range(orders.get(matrix, 0) + 1):
                m = _free(matrix.shape, draw, rich)
                values[matrix, k] = [[m[min(i, j)][max(i, j)] for j in range(len(m))] for i in range(len(m))]
        case "perpendicular":
            return _perpendicular(subjects, values, draw, rich)
        case _:
            return set()
    return set(subjects)


def _definite(size: int, draw: Random, rich: bool) -> Numbers:
    """A symmetric, positive-definite matrix: a diagonal one, or 1 + G^T G."""
    if not rich:
        return [[Fraction(draw.randint(1, 3) if i == j else 0) for j in range(size)] for i in range(size)]
    g = _free((size, size), draw, rich)
    return [[sum((row[i] * row[j] for row in g), Fraction(int(i == j))) for j in range(size)] for i in range(size)]


def _perpendicular(
    subjects: list[Symbol], values: dict[tuple[Symbol, int], Numbers], draw: Random, rich: bool
) -> set[Symbol]:
    one, other = subjects
    values.setdefault((one, 0), _free((3, 1), draw, rich))
    values[other, 0] = _spin(_free((3, 1), draw, rich), [row[0] for row in values[one, 0]])
    return {one, other}


def _unit_vector(draw: Random, rich: bool) -> tuple[Fraction, ...]:
    if not rich:
        return draw.choice(UNIT_VECTORS)
    a, b = (Fraction(draw.randint(-4, 4), draw.randint(1, 3)) for _ in range(2))
    below = 1 + a * a + b * b
    return 2 * a / below, 2 * b / below, (below - 2) / below


def _rotation(draw: Random, rich: bool) -> Numbers:
    """A rotation from a quaternion of integers; half of them have rational Euler-Rodrigues parameters too."""
    reach = 3 if rich else 1
    while True:
        x, y, z, w = (Fraction(draw.randint(-reach, reach)) for _ in range(4))
        if rich and draw.randint(0, 1):
            w, sine = draw.choice(CIRCLE)
            x, y, z = (sine * entry for entry in draw.choice(UNIT_VECTORS))
        if total := x * x + y * y + z * z + w * w:
            break
    rows = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
    return [[Fraction(entry, total) for entry in row] for row in rows]


def _half_turn(draw: Random, rich: bool) -> Numbers:
    """A symmetric rotation other than the identity."""
    u = _unit_vector(draw, rich)
    return [[2 * u[i] * u[j] - (i == j) for j in range(3)] for i in range(3)]


def _finish(
    context: Context,
    solved: dict[str, tuple[Polynomial, Polynomial]],
    point: Point,
    bound: set[Symbol],
    draw: Random,
    rich: bool,
) -> Point | None:
    """Norms, then what the conditions determine; None if a norm cannot be made rational or an atom vanishes."""
    try:
        for variable in context.variables:
            if variable.node is not None and not _norm(context, variable.node, variable.name, point, bound, draw, rich):
                return None
        for name, (numerator, denominator) in solved.items():
            quotient = divided(evaluate(context, numerator, point), evaluate(context, denominator, point))
            if quotient is None or set(quotient) - {0}:
                return None
            point[name] = quotient.get(0, Fraction(0))
        for variable in context.variables:
            if variable.kind == "norm" and variable.name not in point:
                return None
    except KeyError:
        return None
    return point


def _norm(context: Context, node: Node, name: str, point: Point, bound: set[Symbol], draw: Random, rich: bool) -> bool:
    """Give a norm its value, moving a free vector to make it rational if need be."""
    rows = context.unfold(node)
    value = [_rational(context, row[0], point) for row in rows]
    root = _root(sum((x * x for x in value), Fraction(0)))
    if root is None or root == 0:
        *numbers, size = draw.choice(PYTHAGOREAN)
        scale = Fraction(draw.randint(1, 3) if rich else 1)
        target = [scale * k for k in numbers]
        if not _move(context, rows, value, target, point, bound):
            if root is None:
                return False
        else:
            root = scale * size
    point[name] = root if root is not None else Fraction(0)
    return True


def _move(
    context: Context, rows: Matrix, value: list[Fraction], target: list[Fraction], point: Point, bound: set[Symbol]
) -> bool:
    """Shift a free vector so that the expression takes the target value; False if none moves it one to one."""
    if len(value) != 3:
        return False
    for symbol in dict.fromkeys(v.symbol for v in context.variables if v.kind == "entry" and v.order == 0):
        if symbol is None or symbol in bound or symbol.shape != (3, 1):
            continue
        names = [f"{symbol.name}_{i + 1}" for i in range(3)]
        if any(name not in point for name in names):
            continue
        for sign in (1, -1):
            moved = dict(point)
            for name, have, want in zip(names, value, target, strict=True):
                moved[name] += sign * (want - have)
            if [_rational(context, row[0], moved) for row in rows] == target:
                point.update(moved)
                return True
    return False


def _rational(context: Context, ratio: Ratio, point: Point) -> Fraction:
    value = ratio_at(context, ratio, point)
    if value is None or set(value) - {0}:
        raise KeyError("not a rational number")
    return value.get(0, Fraction(0))


def _root(square: Fraction) -> Fraction | None:
    """The rational square root, if there is one."""
    above, below = isqrt(square.numerator), isqrt(square.denominator)
    return Fraction(above, below) if above * above == square.numerator and below * below == square.denominator else None
