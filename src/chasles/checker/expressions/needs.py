"""Does a verdict say all that it needs? What a proof divides by, roots of what, and which equations it uses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from functools import reduce
from operator import mul

from chasles.checker.expressions.algebra import constant, primitive
from chasles.checker.expressions.asked import Asked
from chasles.checker.expressions.factoring import Terms, quotient
from chasles.checker.expressions.reading_of_proof import Proven, Spoken
from chasles.checker.expressions.signs import is_nonnegative, is_positive, may_vanish
from chasles.checker.sparse import ONE, ZERO, Polynomial, Rejected, variable

RELATIONS = (" != 0", " > 0", " >= 0")
"""How a need that is no equation ends."""


def require_needs(
    stated: Iterable[str], asked: Asked, reading: Proven, divisors: Iterable[int], used: Iterable[str]
) -> None:
    """Every divisor, domain and equation used is stated, and nothing is of which the question does not speak.

    `divisors` are the places of inverses. Raises `Rejected` if not.
    """
    stated = list(stated)
    texts = {item.text for item in asked.given} | {f"{e} is zero" for e in reading.atoms.values() if e.is_zero}
    texts.update(asked.real)
    for text in (*used, *reading.substituted, *asked.real):
        if text not in stated:
            raise Rejected(f"the proof uses {text}, and the verdict does not say so")
    said = [_SaidNeed(reading, text) for text in stated if text not in texts]
    for place in divisors:
        if may_vanish(reading, reading.inverses[place]) and not _is_excluded(reading, place, said):
            spelled = min(reading.divided.get(place, {reading.names[place]}))
            raise Rejected(f"the proof needs {spelled} != 0, and the verdict does not say so")
    for domain in reading.domains:
        if not any(one.allows(domain) for one in said):
            raise Rejected("a root is real only where something is not negative of which the verdict does not speak")
    for value, odd, sign in list(reading.functions.positives):
        if not (any(one.implies(value) for one in said) or _is_said(said, odd, sign)):
            raise Rejected("a logarithm is real only where something is positive of which the verdict does not speak")
    factors = {terms for _, odd, _ in reading.functions.positives for terms in odd}
    for one in said:
        if not (
            any(map(one.bears_on, list(reading.inverses)))
            or any(map(one.allows, reading.domains))
            or any(odd <= factors for odd, _ in one.signs)
            or (one.relation == " != 0" and constant(one.polynomial))
            or ((reading.calls or one.relation == " >= 0") and is_positive(reading, one.polynomial))
        ):
            raise Rejected(f"the verdict needs {one.text}, of which the question does not speak")


def _is_said(said: list[_SaidNeed], odd: frozenset[Terms], sign: int) -> bool:
    """Whether a product is said to be positive, or each of its factors to have a sign."""
    known = [signs for one in said for signs in one.signs]
    single = {terms: s for factors, s in known if len(factors) == 1 for terms in factors}
    return (odd, sign) in known or (odd <= single.keys() and reduce(mul, map(single.get, odd), sign) > 0)


def _is_excluded(reading: Proven, place: int, said: list[_SaidNeed]) -> bool:
    """Whether something is a product, up to a root, of what is said not to vanish, or a factor of it."""
    if any(one.excludes(place) for one in said):
        return True
    polynomials = [one.polynomial for one in said if one.relation != " >= 0" and constant(one.polynomial) is None]
    polynomials += [reading.normal(polynomial * polynomial) for polynomial in polynomials]
    for product in _times_roots(reading, reading.inverses[place]):
        rest = product
        for polynomial in polynomials:
            while constant(rest) is None and (left := quotient(rest, polynomial)) is not None:
                rest = left
        if any(quotient(polynomial, rest) is not None for polynomial in (ONE, *polynomials)):
            return True
        if rest is not product and not may_vanish(reading, rest):
            return True
    return False


def _times_roots(reading: Proven, base: Polynomial) -> list[Polynomial]:
    """It, and its products with the roots in it."""
    return [base, *(reading.normal(base * variable(place)) for place in sorted(base.places & reading.words))]


class _SaidNeed:
    """One of the needs: that something does not vanish, or is not negative."""

    def __init__(self, reading: Proven, text: str) -> None:
        self.reading, self.text = reading, text
        self.relation = next((relation for relation in RELATIONS if text.endswith(relation)), "")
        if not self.relation:
            raise Rejected(f"the verdict needs {text}, of which the question does not speak")
        self.spelled = text.removesuffix(self.relation)
        self._polynomial: Polynomial | None = None

    @property
    def polynomial(self) -> Polynomial:
        """What the need is about, or something of the same sign, with nothing divided by."""
        if self._polynomial is None:
            value = [ZERO, *self._values()][-1]
            unsigned = self.relation == " != 0"
            self._polynomial = self.reading.cleared(value)[0] if unsigned else self.reading.undivided(value)
        return self._polynomial

    @property
    def signs(self) -> list[tuple[frozenset[Terms], int]]:
        """Factors of what is said to be positive, and its sign where these are: all of them, those of any sign."""
        found = []
        for value in self._values() if self.relation == " > 0" else ():
            odd, sign = self.reading.functions.signs(value)
            open_ = frozenset(terms for terms in odd if not is_nonnegative(self.reading, Polynomial(dict(terms))))
            found += [(odd, sign), (open_, sign)]
        return found

    def implies(self, value: Polynomial) -> bool:
        """Whether something is more by a number than what is said not to be negative."""
        rests = [constant(self.reading.normal(value - least)) for least in self._values() if self.relation != " != 0"]
        return any(rest is not None and rest > 0 for rest in rests)

    def _values(self) -> Iterator[Polynomial]:
        """What the need is about: in its quantities, and in the roots of which these are powers."""
        places = self.reading.atoms.items()
        plain = {str(e): variable(place) for place, e in places}
        rooted = {str(e): self.reading.atom(e) for _, e in places} if self.reading.rooted else {}
        for named in filter(None, (plain, rooted)):
            known, positives = set(self.reading.inverses), list(self.reading.functions.positives)
            with suppress(Rejected):
                value = Spoken(self.reading, named)(self.spelled)
                if known == set(self.reading.inverses):
                    yield value
            # What the need itself is about is not what makes it needed.
            self.reading.functions.positives[:] = positives

    def excludes(self, place: int) -> bool:
        """Whether it says that what a variable is the inverse of does not vanish."""
        if self.relation == " >= 0" or self.spelled in self.reading.divided.get(place, ()):
            return self.relation != " >= 0"
        return bool(self.polynomial) and quotient(self.polynomial, self.reading.inverses[place]) is not None

    def bears_on(self, place: int) -> bool:
        """Whether it excludes what a variable is the inverse of, or is about a factor of that."""
        if self.excludes(place):
            return True
        products = _times_roots(self.reading, self.reading.inverses[place])
        about = constant(self.polynomial) is None and self.relation != " >= 0"
        return about and any(quotient(product, self.polynomial) is not None for product in products)

    def allows(self, domain: Polynomial) -> bool:
        """Whether it says that something is not negative."""
        if self.relation == " != 0" or not self.polynomial:
            return False
        (scale, base), (wanted, other) = primitive(self.polynomial), primitive(domain)
        return base.terms == other.terms and scale * wanted > 0
