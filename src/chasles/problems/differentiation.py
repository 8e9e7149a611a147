"""Time derivatives of fractions of polynomials, from the rates of the variables by product and quotient rule."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from chasles.algebra.localization import Localization, Ratio, joined
from chasles.algebra.rings import Polynomial
from chasles.evaluation.matrices import each, product, transposed
from chasles.problems.coordinates import Coordinates
from chasles.problems.divisors import Divisors
from chasles.problems.moments import BodyMoments
from chasles.problems.variables import Unlisted, Untreatable, Variable
from chasles.statements.rules import rated
from chasles.vocabulary import Node, Norm, Rate, plain


class Differentiation:
    """The derivation over one field's variables: `entries` unfolds an expression, `rules` say what one is put for."""

    def __init__(
        self,
        field: Localization,
        variables: tuple[Variable, ...],
        coordinates: Coordinates,
        rules: Mapping[Node, Node],
        moments: BodyMoments,
        divisors: Divisors,
        entries: Callable[[Node], list[list[Ratio]]],
    ) -> None:
        self.field = field
        self.variables = variables
        self.coordinates = coordinates
        self.rules = rules
        self.moments = moments
        self.divisors = divisors
        self.entries = entries
        self._known: dict[int, Ratio] = {}
        self._sought: set[int] = set()

    def forget(self) -> None:
        """Find the rates anew from here on: a symbol has been determined."""
        self._known.clear()

    def __call__(self, ratio: Ratio) -> Ratio:
        """The time derivative of a fraction, by the quotient rule over its denominator."""
        total = self.of_polynomial(ratio.numerator)
        total = Ratio(self.field, total.numerator, joined(total.denominator, ratio.denominator))
        for place, power in enumerate(ratio.denominator):
            if power:
                below = [0] * (place + 1)
                below[place] = 1
                change = self.of_polynomial(self.field.nonzero[place]) * ratio
                change = change.divided(Fraction(1), tuple(below)) * self.field.constant(power)
                total = total - change
        return total

    def of_polynomial(self, polynomial: Polynomial) -> Ratio:
        """The time derivative of a polynomial in the variables, by the chain rule."""
        total = self.field.constant(0)
        ring = self.field.ring
        for place, degree in enumerate(ring.degrees(polynomial)):
            if degree > 0:
                total = total + self.field.ratio(ring.derivative(polynomial, place)) * self._of_variable(place)
        return total

    def _of_variable(self, place: int) -> Ratio:
        if place not in self._known:
            if place in self._sought:
                raise Untreatable(f"the rate of {self.variables[place].name} is said by itself: leave out a rule")
            self._sought.add(place)
            try:
                self._known[place] = self._find(self.variables[place])
            finally:
                self._sought.remove(place)
        return self._known[place]

    def _find(self, variable: Variable) -> Ratio:
        symbol = variable.symbol
        if variable.kind == "norm":
            return self._of_norm(variable)
        if variable.kind == "moment":
            return self.moments.integral(self.of_polynomial(self.moments.integrand(variable.factors)))
        assert symbol is not None
        if symbol.constant:
            return self.field.constant(0)
        if variable.kind == "entry":
            node = rated(symbol, variable.order + 1)
            if node in self.rules:
                return self.entries(self.rules[node])[variable.row][variable.column]
            rate = self.coordinates.entry(symbol, variable.order + 1, variable.row, variable.column)
            if rate is None:
                raise Unlisted(f"a condition determines {plain(symbol)}, and speaks of its rate")
            return rate
        speed = self.entries(Rate(symbol))[0][0] * self.field.constant(self.coordinates.unit(symbol))
        cosine, sine = self.coordinates.circular(symbol)
        return -(sine * speed) if variable.kind == "cos" else cosine * speed

    def _of_norm(self, variable: Variable) -> Ratio:
        """d|x| = x . dx / |x|."""
        assert variable.node is not None
        value = self.entries(variable.node)
        change: Ratio = product(transposed(value), each(value, self))[0][0]
        constant, exponents = self.divisors(Norm(variable.node))
        return change.divided(constant, exponents)
