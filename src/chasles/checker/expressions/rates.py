"""Derivatives of what was read, by a symbol, as polynomials again: the checker takes them by itself."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.sparse import ONE, ZERO, Polynomial, number, variable

if TYPE_CHECKING:
    from chasles.checker.expressions.expressions import Expressions

MOST_RATES = 20
"""Nothing is differentiated more often."""


class Derivatives:
    """Differentiates polynomials in the variables of a reading; all functions of symbols are smooth."""

    def __init__(self, reading: Expressions) -> None:
        self.reading = reading
        self._known: dict[tuple[int, Any], Polynomial] = {}

    def __call__(self, value: Polynomial, time: Any) -> Polynomial:
        """The derivative by a symbol."""
        total = ZERO
        for place, partial in value.partials().items():
            if (place, time) not in self._known:
                self._known[place, time] = self.reading.normal(self._speed(place, time))
            total += partial * self._known[place, time]
        return self.reading.normal(total)

    def _speed(self, place: int, time: Any) -> Polynomial:
        reading = self.reading
        if place in reading.atoms:
            return self._of_atom(reading.atoms[place], time)
        if place in reading.inverses:
            return -variable(place, 2) * self(reading.inverses[place], time)
        if place in reading.words:
            square = reading.squares[place]
            slope = self(square, time)
            return slope * reading.inverse(square) * variable(place) * number(Fraction(1, 2)) if slope else ZERO
        if place in reading.calls:
            return self._of_call(place, time)
        for monomial, (unit, cosine, sine) in reading.circles.items():
            if place in cosine.places | sine.places:
                turning = self(Polynomial({monomial: 1}), time) * number(unit)
                return cosine * turning if place in sine.places else -sine * turning
        raise AssertionError(reading.names[place])

    def _of_call(self, place: int, time: Any) -> Polynomial:
        """The rate of the value of a function."""
        function, arguments = self.reading.calls[place]
        speeds = [self(argument, time) for argument in arguments]
        if not any(speeds):
            return ZERO
        if function == "arc":
            (y, x), (up, right) = arguments, speeds
            return (x * up - y * right) * self.reading.inverse(self.reading.normal(x * x + y * y))
        if function == "exp":
            return variable(place) * speeds[0]
        slope = speeds[0] * self.reading.inverse(arguments[0])
        return slope if function == "log" else slope * arguments[1] * variable(place)

    def _of_atom(self, e: Any, time: Any) -> Polynomial:
        if e == time:
            return ONE
        function = e.expr if isinstance(e, sympy.Derivative) else e
        moves = isinstance(function, AppliedUndef) and time in function.args
        return self.reading.atom(sympy.Derivative(e, time)) if moves else ZERO
