"""Exact rational points that satisfy a problem's hypotheses, simple ones first.

Hypotheses are satisfied by parametrisation (see `rational`), rates of rotations by an angular velocity, conditions by
the values that they determine, norms by moving a free vector until its norm is rational.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from math import prod
from random import Random

from chasles.algebra.localization import Ratio
from chasles.algebra.rings import Polynomial
from chasles.algebra.values import divided
from chasles.checker.witness import QUARTERS, root_of
from chasles.evaluation.matrices import Matrix
from chasles.points.adjustment import adjusted
from chasles.points.evaluation import Point, evaluate, ratio_at, satisfies
from chasles.points.quadrics import on_quadrics
from chasles.points.rational import CIRCLE, Numbers, SimpleRandom, circle, free
from chasles.points.satisfying import bind, in_order
from chasles.problems.context import Context
from chasles.statements import Hypothesis
from chasles.vocabulary import Node, Symbol

ATTEMPTS = 400
SIMPLE_ATTEMPTS = 8


def sample(
    context: Context,
    solved: dict[str, tuple[Polynomial, Polynomial]],
    *,
    simple: bool = True,
    attempts: int = ATTEMPTS,
) -> Iterator[Point]:
    """Points that satisfy the hypotheses, the norms and the conditions, simple ones first, in so many attempts.

    `solved` gives numerator and denominator of each variable that the conditions determine.
    """
    draw = Random(0)
    for attempt in range(0 if simple else SIMPLE_ATTEMPTS, attempts):
        point = _try(context, solved, draw, attempt)
        if point is not None and (satisfies(context, point) or (not solved and adjusted(context, point))):
            yield point


def plain(context: Context, solved: dict[str, tuple[Polynomial, Polynomial]], attempts: int) -> Iterator[Point]:
    """Different points that satisfy the same, of axes, quarter turns, zeros and ones where that is possible."""
    draw = SimpleRandom(0)
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
    values, bound = _drawn(context, context.active, draw, rich)
    point: Point = {}
    for variable in context.variables:
        if variable.kind == "entry" and variable.symbol is not None and variable.name not in solved:
            point[variable.name] = values[variable.symbol, variable.order][variable.row][variable.column]
    _angles(context, point, draw, rich)
    _moments(context, point, draw, rich)
    bound |= on_quadrics(context, point, bound, draw, rich)
    return _finish(context, solved, point, bound, draw, rich)


def _drawn(
    context: Context, hypotheses: Iterable[Hypothesis], draw: Random, rich: bool
) -> tuple[dict[tuple[Symbol, int], Numbers], set[Symbol]]:
    """Values of the symbols and their rates, and the symbols that are bound by a hypothesis."""
    values: dict[tuple[Symbol, int], Numbers] = {}
    orders: dict[Symbol, int] = {}
    for variable in context.variables:
        if variable.kind == "entry" and variable.symbol is not None:
            orders[variable.symbol] = max(orders.get(variable.symbol, 0), variable.order)
    bound: set[Symbol] = set()
    for hypothesis in in_order(hypotheses):
        bound |= bind(hypothesis, orders, values, draw, rich)
    for symbol, highest in orders.items():
        for order in range(highest + 1):
            if (symbol, order) not in values:
                values[symbol, order] = free(symbol.shape, draw, rich)
    return values, bound


def _moments(context: Context, point: Point, draw: Random, rich: bool) -> None:
    """Moments of a few elements that satisfy the hypotheses, so that they are those of some body or collection."""
    moments = [variable for variable in context.variables if variable.kind == "moment"]
    if not moments:
        return
    named = {name for variable in moments for name, _ in variable.factors}
    entries = [v for v in context.variables if v.kind == "entry" and v.name in named]
    elements = []
    for _ in range(8 if rich else draw.randint(1, 4)):
        values, _ = _drawn(context, context.problem.hypotheses, draw, rich)
        element = {v.name: values[v.symbol, v.order][v.row][v.column] for v in entries if v.symbol is not None}
        elements.append(element | {name: Fraction(draw.randint(1, 3)) for name in context.densities})
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
            quarters = abs(quarters) if variable.symbol in context.problem.nonnegative else quarters
            cosine, sine = QUARTERS[quarters % 4]
            point[variable.symbol.name] = Fraction(quarters, 2) / context.unfold.coordinates.unit(variable.symbol)
        else:
            cosine, sine = circle(draw) if rich else draw.choice(CIRCLE)
            if variable.symbol.name in point:
                point[variable.symbol.name] = Fraction(1)
                cosine, sine = (cosine, sine) if sine or cosine < 0 else CIRCLE[1]
        point[variable.name] = cosine
        point["sin" + variable.name.removeprefix("cos")] = sine
    if "pi" in context.field.ring.names:
        point["pi"] = Fraction(1)


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
            if variable.node is not None and not give_norm(
                context, variable.node, variable.name, point, bound, draw, rich
            ):
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


def give_norm(
    context: Context, node: Node, name: str, point: Point, bound: set[Symbol], draw: Random, rich: bool
) -> bool:
    """Give a norm its value, moving a free vector to make it rational if need be."""
    rows = context.unfold(node)
    value = [_rational(context, row[0], point) for row in rows]
    root = root_of(sum((x * x for x in value), Fraction(0)))
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
