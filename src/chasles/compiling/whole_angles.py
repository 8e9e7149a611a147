"""An angle that is a product, a power or a sum as one symbol: SymPy spreads its powers and terms among others."""

from __future__ import annotations

from collections.abc import Iterable
from math import floor

import sympy

from chasles.compiling.variables import Substitution

ANGLE, ROOT = (sympy.Dummy(name, dummy_index=k, real=True) for k, name in enumerate(("angle", "root")))
"""The symbol in place of the angle meanwhile, and that for one that is a multiple of a root."""


class WholeAngle:
    """Expressions in a symbol for an angle: (a b)^-2 is a^-2 b^-2 to SymPy, and a - b - sin(a - b) has three terms."""

    def __init__(self, angle: sympy.Expr) -> None:
        self._angle = angle.primitive()[1]
        factors = sympy.Mul.make_args(self._angle)
        self._number = sympy.Mul(*(factor for factor in factors if factor.is_number))
        self._powers = dict(factor.as_base_exp() for factor in factors if not factor.is_number)
        self._terms = self._angle.as_coefficients_dict() if angle.is_Add else {}
        self.symbol = ROOT if sympy.S.Half in self._powers.values() else ANGLE
        self._done: dict[sympy.Basic, sympy.Basic] = {self._angle: self.symbol}

    def occurs_in(self, parts: Iterable[sympy.Basic]) -> bool:
        """Whether one of them is zero where the angle is, as far as it is seen."""
        if self._terms:
            return any(part.is_Add and self._sum(part) != part for part in parts)
        known = all(exponent.is_Rational for exponent in self._powers.values())
        return known and any(self._powers.get(part, sympy.S.Zero) > 0 for part in parts)

    def of(self, expression: sympy.Basic) -> sympy.Basic:
        """The expression, in which the angle is a symbol where it occurs as a whole."""
        found = self._done.get(expression)
        if found is None:
            parts = [self.of(part) for part in expression.args]
            found = expression.func(*parts) if parts != list(expression.args) else expression
            if isinstance(found, sympy.Mul | sympy.Pow) and not self._terms:
                found = self._product(found)
            elif isinstance(found, sympy.Add) and self._terms:
                found = self._sum(found)
            self._done[expression] = found
        return found

    def back(self, expression: sympy.Basic) -> sympy.Basic:
        """The expression with the angle again."""
        return Substitution({self.symbol: self._angle}).of(expression)

    def _product(self, product: sympy.Expr) -> sympy.Expr:
        """With the powers of the angle that it is divided by, or else those that are in it."""
        powers = dict(factor.as_base_exp() for factor in sympy.Mul.make_args(product))
        exponents = [(powers.get(base, sympy.S.Zero), exponent) for base, exponent in self._powers.items()]
        if not all(exponent.is_Rational for exponent, _ in exponents):
            return product
        # Where the angle vanishes one of these does.
        power = min((floor(exponent / whole) for exponent, whole in exponents if whole > 0), default=0)
        others = [base ** (-power * exponent) for base, exponent in self._powers.items()]
        return sympy.Mul(product, (self.symbol / self._number) ** power, *others) if power else product

    def _sum(self, total: sympy.Expr) -> sympy.Expr:
        """With the multiple of the angle whose terms are all in it."""
        terms = total.as_coefficients_dict()
        multiples = {terms.get(term, sympy.S.Zero) / number for term, number in self._terms.items()}
        if len(multiples) > 1 or 0 in multiples:
            return total
        [multiple] = multiples
        rest = [number * term for term, number in terms.items() if term not in self._terms]
        return sympy.Add(multiple * self.symbol, *rest)
