"""Integrals over a body as unknown numbers, one for each product of what differs from element to element.

The integral is linear, and nothing else is used of it: what is decided holds for every body.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from chasles.algebra.localization import Localization, Ratio
from chasles.algebra.rings import Polynomial
from chasles.problems.scanning import differs
from chasles.problems.variables import Factors, Untreatable, Variable, moment_name
from chasles.vocabulary import Node, Symbol


class BodyMoments:
    """The moments that a ring has variables for, and those that it `lacks` until `lacks` is None.

    While some may be lacking, a number stands in for each of them, so that all can be found by unfolding everything.
    """

    def __init__(
        self, field: Localization, variables: Sequence[Variable], running: frozenset[Symbol], rules: Mapping[Node, Node]
    ) -> None:
        self.lacks: dict[Factors, None] | None = {}
        self._field = field
        self._names = [variable.name for variable in variables]
        entries = [(k, v) for k, v in enumerate(variables) if v.kind == "entry" and v.symbol in running]
        self._running = [k for k, v in sorted(entries, key=_density_first)]
        self._hidden = {k for k, v in enumerate(variables) if running and _hides(v, running, rules)}
        self._place = {v.factors: k for k, v in enumerate(variables) if v.kind == "moment"}

    def integral(self, integrand: Ratio) -> Ratio:
        """The integral of an expression; raises `Untreatable` if it is no polynomial in the running variables."""
        ring, running = self._field.ring, set(self._running)
        nonzero = [factor for factor, power in zip(self._field.nonzero, integrand.denominator, strict=False) if power]
        looked_at = [(integrand.numerator, self._hidden), *((factor, self._hidden | running) for factor in nonzero)]
        if any(exponents[k] for p, refused in looked_at for exponents, _ in ring.terms(p) for k in refused):
            raise Untreatable("what is integrated is no polynomial in what differs from element to element")
        parts: dict[Factors, dict[tuple[int, ...], Fraction]] = {}
        for exponents, coefficient in ring.terms(integrand.numerator):
            factors = tuple((self._names[k], exponents[k]) for k in self._running if exponents[k])
            rest = tuple(0 if k in running else exponent for k, exponent in enumerate(exponents))
            parts.setdefault(factors, {})[rest] = coefficient
        total = ring.constant(Fraction(0))
        for factors, terms in parts.items():
            total = total + ring.from_terms(terms) * self._moment(factors)
        return Ratio(self._field, total, integrand.denominator)

    def integrand(self, factors: Factors) -> Polynomial:
        """The product of variables of which a moment is the integral."""
        ring = self._field.ring
        product = ring.constant(Fraction(1))
        for name, exponent in factors:
            for _ in range(exponent):
                product = product * ring.generators[self._names.index(name)]
        return product

    def _moment(self, factors: Factors) -> Polynomial:
        ring = self._field.ring
        if factors in self._place:
            return ring.generators[self._place[factors]]
        if self.lacks is None:
            raise Untreatable(f"{moment_name(factors)} came up too late to be given a variable")
        self.lacks[factors] = None
        return ring.constant(Fraction(1 + len(self.lacks)))


def _hides(variable: Variable, running: frozenset[Symbol], rules: Mapping[Node, Node]) -> bool:
    """Whether the variable is a function, other than a polynomial, of what differs from element to element."""
    if variable.kind == "norm" and variable.node is not None:
        return differs(variable.node, running, rules)
    return variable.kind in ("cos", "sin") and variable.symbol in running


def _density_first(entry: tuple[int, Variable]) -> tuple[bool, str]:
    _, variable = entry
    assert variable.symbol is not None
    return not variable.symbol.is_scalar, variable.name
