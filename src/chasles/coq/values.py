"""The values of all that a statement is about, at a point and as functions of time, spelled for Coq."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cached_property
from typing import Any

from chasles import vocabulary as w
from chasles.checker.reading import PolynomialProblem
from chasles.checker.refutation import Value, bound_in, completed, quotient_at
from chasles.checker.sparse import Polynomial, Rejected, exponents, packed, variable
from chasles.checker.witness import value_at
from chasles.coq.expressions import Unsaid
from chasles.coq.functions import MOVING, NUMBER, OVER, TIME, MotionThrough
from chasles.coq.polynomials import literal, multiple, spelled
from chasles.coq.statement import CoqStatement

Angle = tuple[w.Symbol, Fraction, str]
"""An angle, of which multiple the cosine and sine are known, and the name of its value."""


class PointValues:
    """PointValues for the symbols and rates of a statement, by name; raises `Unsaid` where there are none.

    With `at_rest` no rate is other than zero.
    """

    def __init__(self, said: CoqStatement, at: Mapping[str, Any], at_rest: bool = False) -> None:
        if said.integrals:
            raise Unsaid("a point with a body")
        try:
            self.reading = reading = PolynomialProblem(said.problem, at)
        except Rejected as reason:
            raise Unsaid(str(reason)) from reason
        self.nodes: dict[str, w.Node] = {name: node for node, name in said.names.symbols.items()}
        self.nodes |= {name: node for node, name in said.names.rates.items()}
        words = (node for node in said.nodes if isinstance(node, w.Call | w.Norm))
        try:
            known = [reading(node) for node in (*self.nodes.values(), *words)]
            places = {place for rows in known for row in rows for entry in row for place in entry.places}
            resting = {name: Fraction(0) for name, place in reading.places.items() if at_rest and self._is_rate(place)}
            self.point = completed(reading, self._free_ones(at) | dict(at) | resting, bound_in(reading, places))
        except (ArithmeticError, Rejected) as reason:
            raise Unsaid(str(reason)) from reason
        self.angles: dict[int, Angle] = {}
        for place, what in enumerate(reading.variables):
            if what[0] == "cos":
                self.angles[place] = (what[1], what[2], f"{said.names.symbol(what[1])}'")
            if what[0] == "cos" and place not in self.point:
                self.point |= {place: (Fraction(1), 0), place + 1: (Fraction(0), 0)}
        self.motion = MotionThrough(reading, self.point)
        if at_rest and any(self.motion(entry) for node in said.names.rates for row in reading(node) for entry in row):
            raise Unsaid("a point through which something moves")
        stated = (each for each in reading.vanishing.values() if each.places <= self.point.keys())
        if at_rest and any(value_at(each, self.point) for each in stated):
            raise Unsaid("a point at which something is determined by what moves")

    def _free_ones(self, at: Mapping[str, Any]) -> dict[str, Fraction]:
        """One for each quantity or norm that is not zero, and of which the point says nothing."""
        names = {place: name for name, place in self.reading.places.items()}
        given = {self.reading.places.get(name) for name in at}
        found = {}
        for node in (node for h in self.reading.problem.hypotheses for node in h.nonvanishing):
            of = node.of if isinstance(node, w.Norm) else node
            entries = [entry for each in (node, of) for row in self.reading(each) for entry in row]
            for place, name in names.items():
                alone = entries[0].terms == {packed(place): 1}
                if alone and given.isdisjoint(place for entry in entries for place in entry.places):
                    found[name] = Fraction(1)
        return found

    def _is_rate(self, place: int) -> bool:
        what = self.reading.variables[place]
        return bool(what[0] == "entry" and what[2] > 0)

    def at_once(self, node: w.Node) -> list[list[Value]]:
        """The entries of an expression at the point."""
        try:
            return [[quotient_at(self.reading, entry, self.point) for entry in row] for row in self.reading(node)]
        except (ArithmeticError, LookupError, Rejected) as reason:
            raise Unsaid("a quantity without a rational value") from reason

    def is_constant(self, node: w.Node) -> bool:
        """Whether it has the same value at all times."""
        try:
            return not any(MOVING & self.motion(entry).places for row in self.reading(node) for entry in row)
        except Unsaid:
            return False

    @property
    def has_pi(self) -> bool:
        """Whether angles are given in units of pi: beside pi, or where there are several."""
        bare = [self.reading.places.get(symbol.name) in self.point for symbol, *_ in self.angles.values()]
        return self.reading.places.get("pi") in self.point or sum(bare) > 1

    def number(self, value: Value) -> str:
        """A value: a rational number, or a polynomial in pi or in an angle."""
        bare = next((place for place, (_, power) in self.point.items() if power), None)
        places = {self.reading.places[angle.name]: name for angle, _, name in self.angles.values()}
        name = "PI" if self.has_pi else places.get(bare, "PI") if bare is not None else "PI"
        terms = [rational(number) + f" * {name} ^ {power}" * (power > 0) for power, number in value.items()]
        return f"({' + '.join(terms) or '0'})"

    def in_time(self, node: w.Node) -> str:
        """An expression at the instant t."""
        entries = [[self.entry(entry) for entry in row] for row in self.reading(node)]
        return entries[0][0] if node.shape == (1, 1) else literal(entries)

    def entry(self, entry: Polynomial) -> str:
        """An entry at the instant t: if not a rational function of time, then made of such functions."""
        try:
            return self._rational(entry)
        except Unsaid:
            return spelled(entry, self._variable)

    def _rational(self, entry: Polynomial) -> str:
        angle = next((name for at, (*_, name) in self.angles.items() if entry == self._bare(at)), "")
        return self._function(self.motion(entry), angle)

    def _function(self, function: Polynomial, angle: str = "") -> str:
        """A function of time, that has the value of an angle at the instant 0 if one is named."""
        terms = []
        parts: dict[int, dict[tuple[int, int], Fraction]] = {0: {}}
        for monomial, c in function.terms.items():
            powers = dict(exponents(monomial))
            part = parts.setdefault(powers.get(OVER, 0), {})
            part[powers.get(TIME, 0), powers.get(NUMBER, 0)] = Fraction(c, function.below)
        for below, part in sorted(parts.items()):
            top = max((t for t, _ in part), default=0)
            *others, text = (self.number({x: c for (t, x), c in part.items() if t == k}) for k in range(top + 1))
            if angle:
                *others, text = (angle, *others[1:], *[text] * bool(others))
            for other in reversed(others):
                text = f"({other} + t * {text})"
            terms.append(f"{text} / {self._below} ^ {below}" if below else text)
        return f"({' + '.join(terms)})" if len(terms) > 1 else terms[0]

    @cached_property
    def _below(self) -> str:
        return f"(1 + ({' + '.join(f'{self._function(each)} ^ 2' for each in self.motion.turn)}))"

    def _bare(self, place: int) -> Polynomial:
        """The angle itself, of which the variable at a place is the cosine."""
        return self.reading(self.angles[place][0])[0][0]

    def _variable(self, place: int) -> str:
        match self.reading.variables[place]:
            case ("entry", *_):
                return self._rational(variable(place))
            case ("cos" | "sin" as function, _, Fraction() as unit):
                angle = self._rational(self._bare(place - (function == "sin")))
                return f"({function} {multiple(angle, unit)})"
            case ("norm", w.Node() as of):
                return f"(norm {self.in_time(of)})"
            case ("inverse", int() as k):
                return f"(1 / {self.entry(self.reading.nonzero[k])})"
        raise Unsaid("a point with a body")

    def of_angles(self, entry: Polynomial) -> str:
        """A polynomial in cosines and sines, in terms of the angles' values."""

        def of_angle(place: int) -> str:
            function = self.reading.variables[place][0]
            _, unit, name = self.angles[place - (function == "sin")]
            return f"({function} {multiple(name, unit)})"

        return spelled(entry, of_angle)


def rational(number: Fraction) -> str:
    """A rational number."""
    text = str(abs(number)).replace("/", " / ")
    return f"({text})" if number >= 0 else f"(- ({text}))"
