"""Polynomials with some of their variables given exact values."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from chasles.algebra.rings import Polynomial, Ring
from chasles.algebra.surds import SurdSum
from chasles.algebra.work_limit import STEP, check, spend

BATCH, TERM = 1000, 10
"""After so many terms the work is counted; what one counts as, in products."""
Monomial = tuple[tuple[int, int], ...]
Sparse = Sequence[tuple[Monomial, Fraction]]
Partial = dict[Monomial, SurdSum]
ONE = SurdSum.rational(1)


def sparse(ring: Ring, polynomial: Polynomial) -> Sparse:
    """The terms, each with the variables that occur in it and their exponents."""
    return [(tuple((k, e) for k, e in enumerate(exps) if e), c) for exps, c in ring.terms(polynomial)]


def degree(partial: Partial) -> int:
    """The total degree in the variables that have no value."""
    return max((sum(e for _, e in monomial) for monomial in partial), default=0)


def _times(one: Partial, other: Partial) -> Partial:
    total: Partial = {}
    for left, a in one.items():
        for right, b in other.items():
            powers = dict(left)
            for place, exponent in right:
                powers[place] = powers.get(place, 0) + exponent
            monomial = tuple(sorted(powers.items()))
            total[monomial] = total.get(monomial, SurdSum({})) + a * b
    return {monomial: value for monomial, value in total.items() if not value.is_zero}


class Values:
    """The values that variables have so far, by place, and the `forms` of those that follow from variables without."""

    def __init__(self) -> None:
        self.rational: dict[int, Fraction] = {}
        self.irrational: dict[int, SurdSum] = {}
        self.forms: dict[int, Partial] = {}

    def copy(self) -> Values:
        """The same values, to be tried with others."""
        other = Values()
        other.rational, other.irrational = dict(self.rational), dict(self.irrational)
        other.forms = dict(self.forms)
        return other

    def __contains__(self, place: int) -> bool:
        return place in self.rational or place in self.irrational

    def __getitem__(self, place: int) -> SurdSum:
        return self.irrational[place] if place in self.irrational else SurdSum.rational(self.rational[place])

    def __setitem__(self, place: int, value: SurdSum | Fraction) -> None:
        exact = value.as_rational if isinstance(value, SurdSum) else value
        if exact is not None:
            self.rational[place] = exact
        elif isinstance(value, SurdSum):
            self.irrational[place] = value

    def follow(self, place: int, form: Partial) -> None:
        """From here on, the variable is this polynomial in others."""
        self.forms[place] = form
        self.settle()

    def settle(self) -> None:
        """Put what is known by now into the forms; a form without unknowns becomes a value."""
        for place in list(self.forms):
            form = self._put_in(self.forms.pop(place))
            if all(monomial == () for monomial in form):
                self[place] = form.get((), SurdSum({}))
            else:
                self.forms[place] = form

    def into(self, terms: Sparse) -> Partial:
        """The polynomial with these values put in."""
        gathered: dict[Monomial, dict[Monomial, Fraction]] = {}
        for count, (monomial, factor) in enumerate(terms):
            if count % BATCH == 0:
                spend(STEP + TERM * min(BATCH, len(terms) - count))
            coefficient = factor
            free: list[tuple[int, int]] = []
            awkward: list[tuple[int, int]] = []
            for place, exponent in monomial:
                if place in self.rational:
                    value = self.rational[place]
                    coefficient *= value if exponent == 1 else value**exponent
                elif place in self.irrational:
                    awkward.append((place, exponent))
                else:
                    free.append((place, exponent))
            if coefficient:
                into = gathered.setdefault(tuple(free), {})
                into[tuple(awkward)] = into.get(tuple(awkward), Fraction(0)) + coefficient
        found = {free: self._folded(parts) for free, parts in gathered.items()}
        partial = {free: value for free, value in found.items() if not value.is_zero}
        following = any(place in self.forms for monomial in partial for place, _ in monomial)
        return self._put_in(partial) if following else partial

    def _folded(self, parts: dict[Monomial, Fraction]) -> SurdSum:
        total = SurdSum({})
        for monomial, coefficient in parts.items():
            term = SurdSum.rational(coefficient)
            for place, exponent in monomial:
                term = term * self.irrational[place] ** exponent
            total = total + term
        return total

    def _put_in(self, partial: Partial) -> Partial:
        """A polynomial with values and forms put in."""
        total: Partial = {}
        for monomial, coefficient in partial.items():
            check()
            term: Partial = {(): coefficient}
            for place, exponent in monomial:
                base: Partial = {(): self[place]} if place in self else self.forms.get(place, {((place, 1),): ONE})
                for _ in range(exponent):
                    term = _times(term, base)
            for key, value in term.items():
                total[key] = total.get(key, SurdSum({})) + value
        return {key: value for key, value in total.items() if not value.is_zero}

    def of(self, terms: Sparse) -> SurdSum:
        """The value of a polynomial all of whose variables have values."""
        return self.into(terms).get((), SurdSum({}))
