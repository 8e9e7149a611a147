"""Exact rational points that satisfy a problem's hypotheses, simple ones first.

Hypotheses are satisfied by parametrisation (see `rational`), rates of rotations by an angular velocity, conditions by
the values that they determine, norms by moving a free vector until its norm is rational.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from math import prod

from chasles.algebra.rings import Polynomial
from chasles.algebra.values import divided
from chasles.checker.witness import QUARTERS, root_of
from chasles.evaluation.matrices import Matrix
from chasles.points.adjustment import adjusted
from chasles.points.evaluation import Point, evaluate, ratio_at, satisfies
from chasles.points.quadrics import on_quadrics
from chasles.points.rational import CIRCLE, Numbers, RationalRandom, SimpleRandom
from chasles.points.satisfying import SatisfyingValues, in_order
from chasles.problems.context import Context
from chasles.statements import Hypothesis
from chasles.vocabulary import Node, Symbol

ATTEMPTS = 400
SIMPLE_ATTEMPTS = 8
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
Determined = dict[str, tuple[Polynomial, Polynomial]]
"""Numerator and denominator of each variable that the conditions determine."""


def sample(context: Context, solved: Determined, *, simple: bool = True, attempts: int = ATTEMPTS) -> Iterator[Point]:
    """Points that satisfy the hypotheses, the norms and the conditions, simple ones first, in so many attempts."""
    draw = RationalRandom(0)
    for attempt in range(0 if simple else SIMPLE_ATTEMPTS, attempts):
        draw.rich = attempt >= SIMPLE_ATTEMPTS
        point = _Attempt(context, solved, draw).point()
        if point is not None and _satisfies(context, solved, point):
            yield point


def plain(context: Context, solved: Determined, attempts: int) -> Iterator[Point]:
    """Different points that satisfy the same, of axes, quarter turns, zeros and ones where that is possible."""
    draw = SimpleRandom(0)
    seen: set[tuple[tuple[str, Fraction], ...]] = set()
    for _ in range(attempts):
        point = _Attempt(context, solved, draw).point()
        key = None if point is None else tuple(point.items())
        if point is None or key is None or key in seen:
            continue
        seen.add(key)
        if _satisfies(context, solved, point):
            yield point


def _satisfies(context: Context, solved: Determined, point: Point) -> bool:
    """Whether the point satisfies all that is known; one that is not, is moved where nothing is determined."""
    return satisfies(context, point) or (not solved and adjusted(context, point))


class _Attempt:
    """One attempt to draw a point."""

    def __init__(self, context: Context, solved: Determined, draw: RationalRandom) -> None:
        self.context, self.solved, self.draw = context, solved, draw
        self.found: Point = {}

    def point(self) -> Point | None:
        """The point; None if a norm cannot be made rational or an atom vanishes."""
        values, self.bound = self._drawn(self.context.active)
        for variable in self.context.variables:
            if variable.kind == "entry" and variable.symbol is not None and variable.name not in self.solved:
                entries = values[variable.symbol, variable.order]
                self.found[variable.name] = entries[variable.row][variable.column]
        self._angles()
        self._moments()
        self.bound |= on_quadrics(self.context, self.found, self.bound, self.draw)
        try:
            return self.found if self._finished() else None
        except KeyError:
            return None

    def _drawn(self, hypotheses: Iterable[Hypothesis]) -> tuple[dict[tuple[Symbol, int], Numbers], set[Symbol]]:
        """Values of the symbols and their rates, and the symbols that are bound by a hypothesis."""
        orders: dict[Symbol, int] = {}
        for variable in self.context.variables:
            if variable.kind == "entry" and variable.symbol is not None:
                orders[variable.symbol] = max(orders.get(variable.symbol, 0), variable.order)
        satisfying = SatisfyingValues(self.draw, orders)
        bound: set[Symbol] = set()
        for hypothesis in in_order(hypotheses):
            bound |= satisfying.bind(hypothesis)
        values = satisfying.values
        for symbol, highest in orders.items():
            for order in range(highest + 1):
                if (symbol, order) not in values:
                    values[symbol, order] = self.draw.free(symbol.shape)
        return values, bound

    def _moments(self) -> None:
        """Moments of a few elements that satisfy the hypotheses, so that they are those of some body or collection."""
        context, draw = self.context, self.draw
        moments = [variable for variable in context.variables if variable.kind == "moment"]
        if not moments:
            return
        named = {name for variable in moments for name, _ in variable.factors}
        entries = [v for v in context.variables if v.kind == "entry" and v.name in named]
        elements = []
        for _ in range(8 if draw.rich else draw.randint(1, 4)):
            values, _ = self._drawn(context.problem.hypotheses)
            element = {v.name: values[v.symbol, v.order][v.row][v.column] for v in entries if v.symbol is not None}
            elements.append(element | {name: Fraction(draw.randint(1, 3)) for name in context.densities})
        for variable in moments:
            for element in elements:
                powers = (element[name] ** exponent for name, exponent in variable.factors)
                known = self.found.get(variable.name, Fraction(0))
                self.found[variable.name] = known + prod(powers, start=Fraction(1))

    def _angles(self) -> None:
        """Rational cosines and sines; quarter turns where pi measures the angle too."""
        context, draw, point = self.context, self.draw, self.found
        for variable in context.variables:
            if variable.kind != "cos" or variable.symbol is None:
                continue
            if context.pi_measures:
                quarters = draw.choice((1, 2, -1, 3, -2, 5))
                quarters = abs(quarters) if variable.symbol in context.problem.nonnegative else quarters
                cosine, sine = QUARTERS[quarters % 4]
                point[variable.symbol.name] = Fraction(quarters, 2) / context.unfold.coordinates.unit(variable.symbol)
            else:
                cosine, sine = draw.circle()
                if variable.symbol.name in point:
                    point[variable.symbol.name] = Fraction(1)
                    cosine, sine = (cosine, sine) if sine or cosine < 0 else CIRCLE[1]
            point[variable.name] = cosine
            point["sin" + variable.name.removeprefix("cos")] = sine
        if "pi" in context.field.ring.names:
            point["pi"] = Fraction(1)

    def _finished(self) -> bool:
        """Give norms their values, then what the conditions determine; False where that cannot be."""
        context, point = self.context, self.found
        for variable in context.variables:
            if variable.node is not None and not self._norm(variable.node, variable.name):
                return False
        for name, (numerator, denominator) in self.solved.items():
            quotient = divided(evaluate(context, numerator, point), evaluate(context, denominator, point))
            if quotient is None or set(quotient) - {0}:
                return False
            point[name] = quotient.get(0, Fraction(0))
        return all(variable.name in point for variable in context.variables if variable.kind == "norm")

    def _norm(self, node: Node, name: str) -> bool:
        """Give a norm its value, moving a free vector to make it rational if need be."""
        rows = self.context.unfold(node)
        value = self._at(rows, self.found)
        root = root_of(sum((x * x for x in value), Fraction(0)))
        if root is None or root == 0:
            *numbers, size = self.draw.choice(PYTHAGOREAN)
            scale = Fraction(self.draw.randint(1, 3) if self.draw.rich else 1)
            if self._move(rows, value, [scale * k for k in numbers]):
                root = scale * size
            elif root is None:
                return False
        self.found[name] = root if root is not None else Fraction(0)
        return True

    def _move(self, rows: Matrix, value: list[Fraction], target: list[Fraction]) -> bool:
        """Shift a free vector so that the expression takes the target value; False if none moves it one to one."""
        if len(value) != 3:
            return False
        for symbol in dict.fromkeys(v.symbol for v in self.context.variables if v.kind == "entry" and v.order == 0):
            if symbol is None or symbol in self.bound or symbol.shape != (3, 1):
                continue
            names = [f"{symbol.name}_{i + 1}" for i in range(3)]
            if any(name not in self.found for name in names):
                continue
            for sign in (1, -1):
                moved = dict(self.found)
                for name, have, want in zip(names, value, target, strict=True):
                    moved[name] += sign * (want - have)
                if self._at(rows, moved) == target:
                    self.found.update(moved)
                    return True
        return False

    def _at(self, rows: Matrix, point: Point) -> list[Fraction]:
        """The rational values of a column at a point. Raises KeyError where one is none."""
        found = []
        for row in rows:
            value = ratio_at(self.context, row[0], point)
            if value is None or set(value) - {0}:
                raise KeyError("not a rational number")
            found.append(value.get(0, Fraction(0)))
        return found
