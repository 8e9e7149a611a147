"""The motion through a point: functions of time that have there the values and the rates of the point.

Most are polynomials in time. What is a unit vector or a rotation is turned, by Cayley's formula with a polynomial: then
it is so at all times.
"""

from __future__ import annotations

from fractions import Fraction
from functools import reduce
from math import factorial
from operator import add

from chasles import vocabulary as w
from chasles.checker.reading import PolynomialProblem
from chasles.checker.refutation import Value, quotient_at
from chasles.checker.sparse import ZERO, Matrix, Polynomial, Rejected, exponents, number, packed, variable
from chasles.checker.witness import Point
from chasles.coq.expressions import Unsaid
from chasles.statements.rules import rated

TIME, NUMBER, OVER = range(3)
"""A function is a polynomial in time, the one transcendental number of a point, and one over what is divided by.

That is one and the square of the polynomial vector by which something is turned.
"""
MOVING = {TIME, OVER}
Vector = list[Polynomial]
TURNED = ("unit", "rotation", "orthonormal")


class MotionThrough:
    """What a reading's polynomials are as functions of time; raises `Unsaid` if they are no such functions."""

    def __init__(self, reading: PolynomialProblem, point: Point) -> None:
        self._reading, self._point = reading, point
        self._known: dict[int, Polynomial] = {}
        self._waiting: set[int] = set()
        self.turn: Vector = [ZERO] * 3
        self._turn()

    def __call__(self, polynomial: Polynomial) -> Polynomial:
        """The function; zero if it is so at all times."""
        total = ZERO
        for monomial, coefficient in polynomial.terms.items():
            product = number(Fraction(coefficient, polynomial.below))
            for place, exponent in exponents(monomial):
                for _ in range(exponent):
                    product *= self._at(place)
            total += product
        return total

    def _at(self, place: int) -> Polynomial:
        if place not in self._known:
            if place in self._waiting:
                raise Unsaid("a motion that is said by its own rate")
            self._waiting.add(place)
            try:
                self._known[place] = self._variable(place)
            finally:
                self._waiting.discard(place)
        return self._known[place]

    def _variable(self, place: int) -> Polynomial:
        """A variable as a function: the integral of its rate, or what stays as it is."""
        now, rate = self._now(place), self._rate(place)
        if OVER in rate.places:
            raise Unsaid("a motion that is no polynomial in time")
        grown = (
            Polynomial({m + 1: c}, rate.below * (dict(exponents(m)).get(TIME, 0) + 1)) for m, c in rate.terms.items()
        )
        return reduce(add, grown, now)

    def _rate(self, place: int) -> Polynomial:
        made_of: Matrix = []
        match self._reading.variables[place]:
            case ("entry", w.Symbol() as of, int() as order, int() as i, int() as j):
                node = rated(of, order + 1)
                if not of.constant and (node in self._reading.rules or (of, order + 1, i, j) in self._places):
                    return self(self._reading(node)[i][j])
            case ("cos" | "sin", w.Symbol() as angle, _):
                made_of = self._reading(angle)
            case ("norm", w.Node() as of):
                made_of = self._reading(of)
            case ("inverse", int() as k):
                made_of = [[self._reading.nonzero[k]]]
        if any(MOVING & self(entry).places for row in made_of for entry in row):
            raise Unsaid("a motion that is no polynomial in time")
        return ZERO

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

    def _now(self, place: int) -> Polynomial:
        """The value at the point as a function that stays as it is."""
        parts = (number(c) * variable(NUMBER, x) for x, c in self._value(place).items())
        return reduce(add, parts, ZERO)

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
                axis: Vector = [ZERO] * 3
                for column, given, made in zip(columns, self._columns(group, order), found, strict=True):
                    lacking = [a - _at_once(b) for a, b in zip(given, made, strict=True)]
                    axis = list(map(add, axis, _crossed(column, lacking)))
                factor = Polynomial({order: 1}, 2 * factorial(order) * (2 if len(columns) > 1 else 1))
                self.turn = [turn + each * factor for turn, each in zip(self.turn, axis, strict=True)]
            self._keep(group, [_turned(column, self.turn) for column in columns], max(orders))

    def _columns(self, group: tuple[w.Node, ...], order: int) -> list[Vector]:
        """The columns of what is turned, or of their rates, at the point."""
        places, columns = self._places, [(each, j) for each in group for j in range(each.shape[1])]
        entries = [[places.get((each, order, i, j)) for i in range(3)] for each, j in columns]
        return [[ZERO if at is None else self._now(at) for at in column] for column in entries]

    def _keep(self, group: tuple[w.Node, ...], columns: list[Vector], top: int) -> None:
        for order in range(top + 1):
            found = iter(_derived(columns, order, self.turn))
            for each, j in ((of, k) for of in group for k in range(of.shape[1])):
                for i, function in enumerate(next(found)):
                    if (each, order, i, j) in self._places:
                        self._known[self._places[each, order, i, j]] = function


def _turned(column: Vector, turn: Vector) -> Vector:
    """Cayley's formula: v + 2 (s x v + s x (s x v)) / (1 + s . s)."""
    once, twice = _crossed(turn, column), number(2) * variable(OVER)
    return [v + twice * (a + b) for v, a, b in zip(column, once, _crossed(turn, once), strict=True)]


def _derived(columns: list[Vector], order: int, turn: Vector) -> list[Vector]:
    """The rates of some order."""
    speed = reduce(add, (number(2) * each * _rate_of(each, ZERO) for each in turn))
    for _ in range(order):
        columns = [[_rate_of(function, speed) for function in column] for column in columns]
    return columns


def _rate_of(function: Polynomial, speed: Polynomial) -> Polynomial:
    """The derivative, `speed` being that of what is divided by."""
    by = function.partials()
    return by.get(TIME, ZERO) - by.get(OVER, ZERO) * variable(OVER, 2) * speed


def _at_once(function: Polynomial) -> Polynomial:
    """The value at the instant 0, where what is divided by is one."""
    powers = ((dict(exponents(monomial)), c) for monomial, c in function.terms.items())
    parts = (Polynomial({packed(NUMBER, at.get(NUMBER, 0)): c}, function.below) for at, c in powers if TIME not in at)
    return reduce(add, parts, ZERO)


def _crossed(one: Vector, other: Vector) -> Vector:
    return [one[i - 2] * other[i - 1] - one[i - 1] * other[i - 2] for i in range(3)]
