"""Groebner bases of hypotheses, each new generator with its cofactors on the stated ones.

Buchberger's algorithm (1965; J. Symb. Comput. 41, 2006) with his first criterion, coprime leading terms, and a budget.
The hypotheses of the book hardly ever need it: they are declared so that they are a basis already. Equations that give
a variable as a polynomial in others are substituted before any division.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from heapq import heapify, heappop, heappush
from math import inf

from chasles.algebra.modular import MODULUS, Span, combination
from chasles.algebra.normal_form import leads_of, reduce_by
from chasles.algebra.rings import Exponents, Polynomial, Ring
from chasles.algebra.work_limit import OutOfTime, afford, spend, within

Explicit = tuple[int, int, Polynomial]
"""The place of an equation, the place of a variable, and the variable less its value."""
Combination = dict[int, Polynomial]


def explicit(ring: Ring, equations: Sequence[Polynomial], places: Iterable[int]) -> list[Explicit]:
    """The equations in which the variable that ranks highest occurs alone, in one term: not in each other's values.

    Only those at the given places are looked at.
    """
    found: list[Explicit] = []
    for k in places:
        equation = equations[k]
        terms = ring.terms(equation)
        place = min((j for exponents, _ in terms for j, e in enumerate(exponents) if e), default=None)
        own = [(sum(exponents), c) for exponents, c in terms if place is not None and exponents[place]]
        if place is not None and len(terms) > 1 and len(own) == 1 and own[0][0] == 1:
            taken = any(place == other or ring.degrees(known)[place] for _, other, known in found)
            if not taken and not any(ring.degrees(equation)[other] for _, other, _ in found):
                found.append((k, place, equation * ring.constant(Fraction(1) / own[0][1])))
    return found


def put_in(ring: Ring, polynomial: Polynomial, values: Sequence[Explicit]) -> tuple[dict[int, Polynomial], Polynomial]:
    """The polynomial with these values put in, and the cofactors of the equations."""
    cofactors: dict[int, Polynomial] = {}
    for k, place, equation in values:
        while polynomial != 0 and ring.degrees(polynomial)[place]:
            lowered = {
                tuple(e - (j == place) for j, e in enumerate(exponents)): c
                for exponents, c in ring.terms(polynomial)
                if exponents[place]
            }
            cofactor = ring.from_terms(lowered)
            afford(len(lowered) * len(equation))
            polynomial = polynomial - cofactor * equation
            cofactors = plus(cofactors, {k: cofactor})
    return cofactors, polynomial


def plus(one: Combination, other: Combination) -> Combination:
    """The sum of two combinations; what vanishes in it is kept."""
    return one | {k: one[k] + cofactor if k in one else cofactor for k, cofactor in other.items()}


@dataclass(frozen=True, slots=True)
class Basis:
    """Generators, and each of them as a combination of the stated hypotheses.

    Of `explicit` ones, which give a variable as a polynomial in others, the values are put in first.
    """

    ring: Ring
    generators: tuple[Polynomial, ...]
    origins: tuple[Combination, ...]
    complete: bool
    explicit: tuple[Explicit, ...] = ()
    _leads: list[Exponents] = field(default_factory=list, compare=False, repr=False)

    def reduce(self, polynomial: Polynomial) -> tuple[Combination, Polynomial]:
        """Cofactors on the stated hypotheses, and the remainder."""
        if self.explicit:
            known, polynomial = put_in(self.ring, polynomial, self.explicit)
            others, remainder = self.without({k for k, _, _ in self.explicit}).reduce(polynomial)
            cofactors = plus(folded(known, self.origins), others)
            return {k: c for k, c in cofactors.items() if c != 0}, remainder
        if not self._leads:
            self._leads.extend(leads_of(self.ring, self.generators))
        cofactors, remainder = reduce_by(self.ring, polynomial, self.generators, self._leads)
        return folded(cofactors, self.origins), remainder

    def without(self, places: Collection[int]) -> Basis:
        """The generators that are not at these places."""
        kept = [k for k in range(len(self.generators)) if k not in places]
        chosen = tuple(self.generators[k] for k in kept), tuple(self.origins[k] for k in kept)
        return Basis(self.ring, *chosen, complete=False)

    def remainders(self) -> Iterator[tuple[Polynomial, Combination]]:
        """What the others leave of each generator, if anything, as a combination of the stated hypotheses."""
        for k, generator in enumerate(self.generators):
            cofactors, remainder = self.without({k}).reduce(generator)
            if remainder != 0:
                yield remainder, plus(self.origins[k], {place: -cofactor for place, cofactor in cofactors.items()})


def folded(cofactors: Combination, origins: tuple[Combination, ...]) -> Combination:
    """Cofactors on generators, rewritten as cofactors on the stated hypotheses."""
    total: Combination = {}
    for place, cofactor in cofactors.items():
        for origin, factor in origins[place].items():
            term = cofactor * factor
            total[origin] = total[origin] + term if origin in total else term
    return {k: c for k, c in total.items() if c != 0}


def combined(ring: Ring, polynomial: Polynomial, generators: Sequence[Polynomial]) -> Combination | None:
    """Rational numbers as cofactors, with which the generators add up to a polynomial; None if there are none.

    They are found modulo a prime, and count if they are right; what alone has some term has none of them.
    """
    if len(polynomial) > sum(map(len, generators)):
        return None  # some term of it is in none of them
    terms = [dict(ring.terms(each)) for each in (*generators, polynomial)]
    occurs = Counter(e for each in terms for e in each)
    while alone := [each for each in terms[:-1] if any(occurs[e] == 1 for e in each)]:
        for each in alone:
            occurs.subtract([*each])
            each.clear()
    if any(occurs[e] == 1 for e in terms[-1]) or any(c.denominator % MODULUS == 0 for t in terms for c in t.values()):
        return None
    places = {exponents: k for k, exponents in enumerate(dict.fromkeys(e for each in terms for e in each))}
    columns = [[0] * len(places) for _ in terms]
    for column, each in zip(columns, terms, strict=True):
        for exponents, c in each.items():
            column[places[exponents]] = c.numerator * pow(c.denominator, -1, MODULUS) % MODULUS
    span = Span()
    chosen = [k for k, column in enumerate(columns[:-1]) if span.add(column)]
    found = combination([columns[k] for k in chosen], columns[-1]) if chosen else None
    if found is None:
        return None
    cofactors = {k: ring.constant(c) for k, c in zip(chosen, found, strict=True) if c}
    rest = polynomial
    for k, cofactor in cofactors.items():
        rest = rest - cofactor * generators[k]
    return cofactors if rest == 0 else None


def stated(ring: Ring, hypotheses: tuple[Polynomial, ...], *, complete: bool, values: Collection[int] = ()) -> Basis:
    """The hypotheses themselves as generators; explicit ones among those at the places `values` are put in first."""
    one = ring.constant(Fraction(1))
    origins = tuple({k: one} for k in range(len(hypotheses)))
    return Basis(ring, hypotheses, origins, complete, tuple(explicit(ring, hypotheses, values)))


def completed(basis: Basis, products: float = inf) -> Basis:
    """A Groebner basis of the same ideal, as far as so much work goes; `complete` says whether it is one.

    Raises `OutOfTime` where what surrounds it allows no more.
    """
    generators, origins = list(basis.generators), list(basis.origins)
    complete = True
    try:
        with within(products):
            _complete(basis.ring, generators, origins)
    except OutOfTime:
        spend(0)
        if products == inf:
            raise
        complete = False
    return Basis(basis.ring, tuple(generators), tuple(origins), complete)


def _complete(ring: Ring, generators: list[Polynomial], origins: list[Combination]) -> None:
    """Add remainders of S-polynomials to the generators until all of these reduce to zero."""
    leads = [ring.leading(g) for g in generators]
    pairs = [(_degree(leads, (i, j)), i, j) for j in range(len(generators)) for i in range(j)]
    heapify(pairs)
    while pairs:
        _, i, j = heappop(pairs)
        if not any(a and b for a, b in zip(leads[i][0], leads[j][0], strict=True)):
            continue
        left, right = _cofactors(ring, leads[i], leads[j])
        difference = left * generators[i] - right * generators[j]
        if difference == 0:
            continue
        cofactors, remainder = reduce_by(ring, difference, generators, [lead for lead, _ in leads])
        if remainder == 0:
            continue
        combination = plus({i: left, j: -right}, {place: -cofactor for place, cofactor in cofactors.items()})
        origins.append(folded(combination, tuple(origins)))
        generators.append(remainder)
        leads.append(ring.leading(remainder))
        last = len(generators) - 1
        for k in range(last):
            heappush(pairs, (_degree(leads, (k, last)), k, last))


def _degree(leads: list[tuple[tuple[int, ...], Fraction]], pair: tuple[int, int]) -> int:
    return sum(map(max, leads[pair[0]][0], leads[pair[1]][0]))


def _cofactors(
    ring: Ring, one: tuple[tuple[int, ...], Fraction], other: tuple[tuple[int, ...], Fraction]
) -> tuple[Polynomial, Polynomial]:
    """The factors of an S-polynomial: they bring two leading terms to their least common multiple."""
    least = tuple(map(max, one[0], other[0]))
    left = tuple(a - b for a, b in zip(least, one[0], strict=True))
    right = tuple(a - b for a, b in zip(least, other[0], strict=True))
    return ring.from_terms({left: 1 / one[1]}), ring.from_terms({right: 1 / other[1]})
