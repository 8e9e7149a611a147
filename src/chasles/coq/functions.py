"""The motion through a point: functions of time that have there the values and the rates of the point.

Most are polynomials in time. What is a unit vector or a rotation is turned, by Cayley's formula with a polynomial: then
it is so at all times.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property, reduce
from math import factorial

from chasles import vocabulary as w
from chasles.checker.determinants import Matrix
from chasles.checker.reading import Reading
from chasles.checker.refutation import Value, quotient_at
from chasles.checker.sparse import Polynomial, Rejected, exponents, variable
from chasles.checker.witness import Point
from chasles.coq.expressions import Unsaid

Function = dict[tuple[int, int, int], Fraction]
"""By exponents: a polynomial in time, the one transcendental number of a point, and one over `MotionThrough.below`."""
Vector = list[Function]
TURNED = ("unit", "rotation", "orthonormal")


class MotionThrough:
    """What a reading's polynomials are as functions of time; raises `Unsaid` if they are no such functions."""

    def __init__(self, reading: Reading, point: Point) -> None:
        self._reading, self._point = reading, point
        self._known: dict[int, Function] = {}
        self._waiting: set[int] = set()
        self.turn: Vector = [{}, {}, {}]
        self._turn()

    @cached_property
    def below(self) -> Function:
        """What is divided by: one and the square of a polynomial vector, by which something is turned."""
        return reduce(_plus, (_times(each, each) for each in self.turn), _number(1))

    def __call__(self, polynomial: Polynomial) -> Function:
        """The function; empty if it is zero."""
        total: Function = {}
        for monomial, coefficient in polynomial.terms.items():
            product = _number(Fraction(coefficient, polynomial.below))
            for place, exponent in exponents(monomial):
                for _ in range(exponent):
                    product = _times(product, self._at(place))
            total = _plus(total, product)
        return total

    def _at(self, place: int) -> Function:
        if place not in self._known:
            if place in self._waiting:
                raise Unsaid("a motion that is said by its own rate")
            self._waiting.add(place)
            try:
                self._known[place] = self._variable(place)
            finally:
                self._waiting.discard(place)
        return self._known[place]

    def _variable(self, place: int) -> Function:
        """A variable as a function: the integral of its rate, or what stays as it is."""
        now = {(0, x, 0): c for x, c in self._value(place).items()}
        rate = self._rate(place)
        if any(d for *_, d in rate):
            raise Unsaid("a motion that is no polynomial in time")
        return now | {(t + 1, x, 0): c / (t + 1) for (t, x, _), c in rate.items()}

    def _rate(self, place: int) -> Function:
        made_of: Matrix = []
        match self._reading.variables[place]:
            case ("entry", w.Symbol() as of, int() as order, int() as i, int() as j):
                node = _rated(of, order + 1)
                if not of.constant and (node in self._reading.rules or (of, order + 1, i, j) in self._places):
                    return self(self._reading(node)[i][j])
            case ("cos" | "sin", w.Symbol() as angle, _):
                made_of = self._reading(angle)
            case ("norm", w.Node() as of):
                made_of = self._reading(of)
            case ("inverse", int() as k):
                made_of = [[self._reading.nonzero[k]]]
        if any(t or d for row in made_of for entry in row for t, _, d in self(entry)):
            raise Unsaid("a motion that is no polynomial in time")
        return {}

    @property
    def _places(self) -> dict[tuple[object, ...], int]:
        """Where the entries of symbols and of their rates are."""
        return {what[1:]: place for place, what in enumerate(self._reading.variables) if what[0] == "entry"}

    def _value(self, place: int) -> Value:
        """The value at the point; zero for what it leaves out since nothing depends on it."""
        if self._reading.variables[place][0] == "entry" and place not in self._point:
            return {}
        try:
            return quotient_at(self._reading, variable(place), self._point)
        except (ArithmeticError, LookupError, Rejected) as reason:
            raise Unsaid("a quantity without a value") from reason

    def _turn(self) -> None:
        """The unit vector or rotation that moves is turned as its rates at the point say."""
        reading = self._reading
        groups = [h.subjects for h in reading.problem.hypotheses if h.kind in TURNED]
        for group in groups:
            free = all(isinstance(each, w.Symbol) and each not in reading.rules for each in group)
            orders = [what[2] for what in reading.variables if what[0] == "entry" and what[1] in group]
            top = max((k for k in orders if any(map(any, self._columns(group, k)))), default=0) if free else 0
            if not top:
                continue
            if any(self.turn):
                raise Unsaid("two that turn")
            columns = self._columns(group, 0)
            for order in range(1, top + 1):
                found = _derived([_turned(column, self.turn) for column in columns], order, self.turn)
                axis: Vector = [{}, {}, {}]
                for column, given, made in zip(columns, self._columns(group, order), found, strict=True):
                    lacking = [_less(a, _at_once(b)) for a, b in zip(given, made, strict=True)]
                    axis = [_plus(a, b) for a, b in zip(axis, _crossed(column, lacking), strict=True)]
                factor = Fraction(1, 2 * factorial(order) * (2 if len(columns) > 1 else 1))
                more = [{(order, x, 0): c * factor for (_, x, _), c in each.items()} for each in axis]
                self.turn = [_plus(a, b) for a, b in zip(self.turn, more, strict=True)]
            self._keep(group, [_turned(column, self.turn) for column in columns], max(orders))

    def _columns(self, group: tuple[w.Node, ...], order: int) -> list[Vector]:
        """The columns of what is turned, or of their rates, at the point."""
        found = []
        for each in group:
            places = [[(each, order, i, j) for i in range(3)] for j in range(each.shape[1])]
            for column in places:
                values = [self._value(self._places[at]) if at in self._places else {} for at in column]
                found.append([{(0, x, 0): c for x, c in value.items()} for value in values])
        return found

    def _keep(self, group: tuple[w.Node, ...], columns: list[Vector], top: int) -> None:
        for order in range(top + 1):
            found = iter(_derived(columns, order, self.turn))
            for each in group:
                for j in range(each.shape[1]):
                    for i, function in enumerate(next(found)):
                        if (each, order, i, j) in self._places:
                            self._known[self._places[each, order, i, j]] = function


def _rated(of: w.Node, order: int) -> w.Node:
    for _ in range(order):
        of = w.Rate(of)
    return of


def _turned(column: Vector, turn: Vector) -> Vector:
    """Cayley's formula: v + 2 (s x v + s x (s x v)) / (1 + s . s)."""
    once = _crossed(turn, column)
    more = [_times({(0, 0, 1): Fraction(2)}, _plus(a, b)) for a, b in zip(once, _crossed(turn, once), strict=True)]
    return [_plus(a, b) for a, b in zip(column, more, strict=True)]


def _derived(columns: list[Vector], order: int, turn: Vector) -> list[Vector]:
    """The rates of some order."""
    speed = _times(_number(2), reduce(_plus, (_times(each, _rate_of(each, {})) for each in turn), {}))
    for _ in range(order):
        columns = [[_rate_of(function, speed) for function in column] for column in columns]
    return columns


def _rate_of(function: Function, speed: Function) -> Function:
    """The derivative, `speed` being that of what is divided by."""
    total: Function = {}
    for (t, x, d), c in function.items():
        here = {(t - 1, x, d): c * t} if t else {}
        total = _plus(total, _plus(here, _times({(t, x, d + 1): -c * d}, speed) if d else {}))
    return total


def _at_once(function: Function) -> Function:
    """The value at the instant 0, where what is divided by is one."""
    return reduce(_plus, ({(0, x, 0): c} for (t, x, _), c in function.items() if not t), {})


def _crossed(one: Vector, other: Vector) -> Vector:
    return [_less(_times(one[i - 2], other[i - 1]), _times(one[i - 1], other[i - 2])) for i in range(3)]


def _number(value: Fraction | int) -> Function:
    return {(0, 0, 0): Fraction(value)}


def _plus(one: Function, other: Function) -> Function:
    total = {key: one.get(key, Fraction(0)) + other.get(key, Fraction(0)) for key in {**one, **other}}
    return {key: value for key, value in total.items() if value}


def _less(one: Function, other: Function) -> Function:
    return _plus(one, {key: -value for key, value in other.items()})


def _times(one: Function, other: Function) -> Function:
    total: Function = {}
    for (t, x, d), a in one.items():
        total = _plus(total, {(t + u, x + y, d + e): a * b for (u, y, e), b in other.items()})
    return total
