"""Where a sum of squares times what is not negative vanishes, each term does: what follows for real numbers alone."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy

from chasles.from_sympy.exponents import may_be_factored
from chasles.from_sympy.opening import atoms_of
from chasles.from_sympy.positivity import Terms, is_definite, sum_of_squares

MOST_TERMS = 30
"""Longer polynomials are not factored."""


@dataclass(frozen=True, slots=True)
class SquaresGiven:
    """An equation given, by the label that the checker has for it, times a factor is a sum of squares with weights."""

    label: str
    factor: Any
    squares: tuple[tuple[Any, Any], ...]

    @property
    def vanishing(self) -> list[Any]:
        """What is squared, times its weight where that may vanish, too."""
        return [base if weight.is_positive else weight * base for weight, base in self.squares]


def squares_in(label: str, difference: Any) -> Iterator[SquaresGiven]:
    """The sums of squares among the factors of what is given to vanish, multiplied by the square of the others."""
    atoms = sorted(set(atoms_of(difference)), key=str)
    if not atoms or not difference.is_polynomial(*atoms) or len(sympy.Add.make_args(difference)) > MOST_TERMS:
        return
    if not may_be_factored(difference):
        return
    polynomial = sympy.Poly(difference, *atoms)
    if polynomial.is_zero:
        return
    if not polynomial.get_domain().is_QQ and not polynomial.get_domain().is_ZZ:
        return
    weights = [place for place, atom in enumerate(atoms) if atom.is_nonnegative]
    possible = {place for place in weights if not atoms[place].is_positive}
    single = [factor for factor, power in polynomial.factor_list()[1] if power == 1]
    for factor in dict.fromkeys((polynomial, *single)):
        other = polynomial.exquo(factor)
        for sign in (1, -1):
            terms = {m: Fraction(sign * int(c.p), int(c.q)) for m, c in factor.terms()}
            found = [] if is_definite(terms) else _weighed(terms, weights)
            told = (any(map(any, base)) or any(m[k] for m in weight for k in possible) for weight, base in found)
            if len(found) > 1 and all(told):
                squares = [tuple(_exact(part, atoms) for part in pair) for pair in found]
                yield SquaresGiven(label, (other * sign).as_expr(), tuple((w, s * other.as_expr()) for w, s in squares))


def _weighed(terms: Terms, nonnegative: list[int]) -> list[tuple[Terms, Terms]]:
    """Squares with their weights: numbers, times what is not negative if every term is a square times such."""
    odd = {m: tuple(power % 2 if k in nonnegative else 0 for k, power in enumerate(m)) for m in terms}
    rest = {m: tuple(a - b for a, b in zip(m, odd[m], strict=True)) for m in terms}
    if all(c > 0 and not any(power % 2 for power in rest[m]) for m, c in terms.items()):
        return [({odd[m]: c}, {tuple(power // 2 for power in rest[m]): Fraction(1)}) for m, c in terms.items()]
    nothing = tuple(0 for _ in next(iter(terms)))
    return [({nothing: weight}, base) for weight, base in sum_of_squares(terms)]


def _exact(terms: Terms, atoms: list[Any]) -> Any:
    found = {m: sympy.Rational(c.numerator, c.denominator) for m, c in terms.items()}
    return sympy.Poly.from_dict(found, *atoms).as_expr()
