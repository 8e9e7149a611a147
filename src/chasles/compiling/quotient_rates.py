"""How does a quotient change where what it divides is part of what it divides by? So that nothing cancels.

Of q = a/b the rate is (a' - q b')/b, which loses its digits where q hardly changes, as x/(1 + x) for a large x. With
sums of the same terms t, a = sum alpha t and b = sum beta t, the slope by t is (alpha b - beta a)/b^2, from which the
term itself drops out; and so it does from (b - x^2)/b^(3/2), the slope of x/sqrt(b).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from fractions import Fraction
from functools import reduce
from math import prod

from chasles.lowering.builder import Builder
from chasles.lowering.program import Op

Terms = dict[int, Fraction]
"""Numbers by the steps that they are multiplied with."""
Multiple = tuple[int, Fraction]
"""A step that is a number times a product, and that number."""
_MOST_TERMS = 8
"""Longer sums are differentiated as they are."""


def rate_of_quotient(
    build: Builder, number: int, changing: Collection[int]
) -> tuple[list[tuple[int, int]], int | None]:
    """The slopes of a quotient by steps that it is made of, and by what they are to be divided."""
    a, b = build.step(number).operands
    _, factors = _factors(build, b)
    hyperbolic = [k for k in factors if build.step(k).function == "cosh"]
    if a in changing or len(hyperbolic) != len(factors):
        return _slopes(build, number, changing), b
    # Where they overflow the quotient is zero, and so is its slope.
    args = [(build.step(k).operands[0], factors[k]) for k in hyperbolic]
    by = [build.multiply(build.constant(-times), build.function("tanh", arg)) for arg, times in args]
    return [(arg, build.multiply(number, slope)) for (arg, _), slope in zip(args, by, strict=True)], None


def _slopes(build: Builder, number: int, changing: Collection[int]) -> list[tuple[int, int]]:
    """The slopes, each times what is divided by."""
    a, b = build.step(number).operands
    root = build.step(b).op is Op.SQUARE_ROOT
    radicand = build.step(b).operands[0] if root else b
    known: dict[tuple[int, ...], Multiple] = {}
    below, above = _terms(build, radicand, known), _terms(build, a, known)
    if not root and any(term in above for term in below if term in changing):
        sides = _by_term(build, above, below, number)
        return [(term, slope) for term, slope in sides if term in changing]
    number_above, factors = _factors(build, a)
    for term in below if len(below) > 1 else ():
        number_in_term, own = _factors(build, term)
        varied = term
        if root:
            # Of a square it is the slope by what is squared.
            varied, number_in_term = min(own, default=term), Fraction(1)
            own = Counter([varied]) if own == Counter([varied, varied]) else Counter()
        if own and own <= factors and varied in changing:
            by_others = build.divide(a, build.add(radicand, radicand)) if root else number
            rest = {other: times for other, times in below.items() if other != term}
            left = [build.constant(number_above / number_in_term), *(factors - own).elements()]
            slopes = [(varied, reduce(build.multiply, left, _share(build, rest, radicand)))]
            slopes += [(t, build.negate(_multiple(build, times, by_others))) for t, times in rest.items()]
            others = [(f, [*left[:k], *left[k + 1 :]]) for k, f in enumerate(left)]
            return slopes + [(f, reduce(build.multiply, those, varied)) for f, those in others]
    return [(a, build.one), (b, build.negate(number))]


def _by_term(build: Builder, above: Terms, below: Terms, quotient: int) -> Iterator[tuple[int, int]]:
    for term in {**above, **below}:
        alpha, beta = above.get(term, Fraction(0)), below.get(term, Fraction(0))
        if not alpha:
            yield term, build.negate(_multiple(build, beta, quotient))
        elif not beta:
            yield term, build.constant(alpha)
        else:
            both = {**above, **below}
            left = {t: alpha * below.get(t, Fraction(0)) - beta * above.get(t, Fraction(0)) for t in both if t != term}
            yield term, build.divide(_sum(build, left), build.step(quotient).operands[1])


def _share(build: Builder, terms: Terms, of: int) -> int:
    """What part of it the terms are; beside a constant each for itself, as a scale is taken out of each alone."""
    if build.one not in terms:
        return build.divide(_sum(build, terms), of)
    return _sum(build, {build.divide(term, of): times for term, times in terms.items()})


def _sum(build: Builder, terms: Terms) -> int:
    return reduce(build.add, (_multiple(build, times, term) for term, times in terms.items()), build.zero)


def _multiple(build: Builder, times: Fraction, step: int) -> int:
    return build.multiply(build.constant(times), step)


def _terms(build: Builder, number: int, known: dict[tuple[int, ...], Multiple]) -> Terms:
    """The terms of a sum, in those that are known if they are multiples; a long one is a term of its own."""
    found: Terms = {}
    waiting = [(number, Fraction(1))]
    while waiting:
        inner, times = waiting.pop()
        step = build.step(inner)
        if step.op in (Op.ADD, Op.SUBTRACT):
            a, b = step.operands
            waiting += [(b, times if step.op is Op.ADD else -times), (a, times)]
        else:
            own, factors = _factors(build, inner)
            term, its = known.setdefault(
                tuple(sorted(factors.elements())), (inner if factors else build.one, own if factors else Fraction(1))
            )
            found[term] = found.get(term, Fraction(0)) + times * own / its
        if len(found) + len(waiting) > _MOST_TERMS:
            return {number: Fraction(1)}
    return found


def _factors(build: Builder, number: int) -> tuple[Fraction, Counter[int]]:
    """A number, and the steps that are multiplied with it."""
    step, value = build.step(number), build.value(number)
    if value is not None:
        return value, Counter()
    if step.op not in (Op.MULTIPLY, Op.NEGATE):
        return Fraction(1), Counter([number])
    sides = [_factors(build, k) for k in step.operands]
    times = Fraction(-1 if step.op is Op.NEGATE else 1)
    return times * prod(n for n, _ in sides), sum((own for _, own in sides), Counter[int]())
