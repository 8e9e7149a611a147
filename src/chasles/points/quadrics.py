"""Rational points on what equations between expressions describe: each equation is solved for symbols still free.

An equation of second degree is a quadric: from one rational point of it, a line in any direction meets it in another
(stereographic projection). What gives a symbol in terms of others is left to adjustment.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import prod

from chasles.algebra.values import is_zero
from chasles.checker.witness import root_of
from chasles.points.evaluation import Point, evaluate, terms_of
from chasles.points.rational import RationalRandom
from chasles.problems.context import Context
from chasles.problems.generators import Generator
from chasles.vocabulary import PI, Symbol

Terms = Sequence[tuple[Fraction, Mapping[int, int]]]
"""Coefficients, each with the exponents of the unknowns that it multiplies."""
ATTEMPTS = 12
SIMPLE = tuple(map(Fraction, (0, 0, 0, 1, -1, 2)))


def on_quadrics(context: Context, point: Point, bound: set[Symbol], draw: RationalRandom) -> set[Symbol]:
    """Move free symbols so that equations between expressions hold, one after the other; the symbols that are tied."""
    tied: set[Symbol] = set()
    for generator in context.generators:
        if generator.hypothesis is None or not generator.hypothesis.free or generator.order:
            continue
        places = {k for k, power in enumerate(context.field.ring.degrees(generator.polynomial)) if power}
        if any(context.variables[k].name not in point for k in places):
            continue
        movable = {k for k in places if _may_move(context, k, bound)}
        if _gives_a_symbol(_terms(context, generator, movable, point)):
            continue
        own = {k for k in movable if context.variables[k].symbol not in tied}
        if own and not is_zero(evaluate(context, generator.polynomial, point)):
            found = _solved(_terms(context, generator, own, point), sorted(own), draw)
            point.update({context.variables[k].name: value for k, value in found.items()})
        tied |= {symbol for k in places if (symbol := context.variables[k].symbol) is not None}
    return tied


def _gives_a_symbol(terms: Terms) -> bool:
    """Whether an unknown occurs in one term alone, by itself."""
    occurring = Counter(k for _, powers in terms for k in powers)
    return any(powers == {k: 1} and occurring[k] == 1 for _, powers in terms for k in powers)


def _may_move(context: Context, place: int, bound: set[Symbol]) -> bool:
    variable = context.variables[place]
    return variable.kind == "entry" and variable.symbol not in bound | {PI} and place not in context.transcendental


def _terms(context: Context, generator: Generator, own: set[int], point: Point) -> Terms:
    """The equation in its unknowns; all else has its value at the point."""
    unknown = {context.variables[k].name: k for k in own}
    found = []
    for coefficient, factors, _ in terms_of(context, generator.polynomial):
        values = (point[name] ** power for name, power in factors if name not in unknown)
        known = prod(values, start=Fraction(*coefficient))
        if known:
            found.append((known, {unknown[name]: power for name, power in factors if name in unknown}))
    return found


def _solved(terms: Terms, places: Sequence[int], draw: RationalRandom) -> dict[int, Fraction]:
    """Values of the unknowns that solve the equation; none if none are found."""
    degree = max((sum(powers.values()) for _, powers in terms), default=0)
    for _ in range(ATTEMPTS):
        values = {k: Fraction(draw.randint(-3, 3)) if degree == 1 else draw.choice(SIMPLE) for k in places}
        for place in draw.sample(places, len(places)):
            for root in _roots(*_along(terms, {**values, place: Fraction(0)}, {place: Fraction(1)})):
                found = {**values, place: root}
                return _reflected(terms, found, draw) if draw.rich and degree == 2 else found
    return {}


def _reflected(terms: Terms, base: dict[int, Fraction], draw: RationalRandom) -> dict[int, Fraction]:
    """The other point of a quadric on a line through one of its points; that point if there is none."""
    for _ in range(ATTEMPTS):
        direction = {k: Fraction(draw.randint(-4, 4)) for k in base}
        line = _along(terms, base, direction)
        if line[2]:
            return {k: value - line[1] / line[2] * direction[k] for k, value in base.items()}
    return base


def _along(terms: Terms, base: Mapping[int, Fraction], direction: Mapping[int, Fraction]) -> list[Fraction]:
    """The coefficients of the equation's left side along a line, that of the lowest power first."""
    total: list[Fraction] = [Fraction(0)] * 3
    for coefficient, powers in terms:
        product = [coefficient]
        for place, power in powers.items():
            for _ in range(power):
                product = _times(product, base[place], direction.get(place, Fraction(0)))
        total += [Fraction(0)] * (len(product) - len(total))
        for k, c in enumerate(product):
            total[k] += c
    return total


def _times(polynomial: list[Fraction], constant: Fraction, slope: Fraction) -> list[Fraction]:
    if not slope:
        return [c * constant for c in polynomial]
    shifted = [Fraction(0), *(c * slope for c in polynomial)]
    return [c * constant + s for c, s in zip([*polynomial, Fraction(0)], shifted, strict=True)]


def _roots(*coefficients: Fraction) -> Iterator[Fraction]:
    """The rational roots of a polynomial of at most second degree that is not constant."""
    c, b, a, *higher = coefficients
    if any(higher) or not (a or b):
        return
    if not a:
        yield -c / b
        return
    root = root_of(b * b - 4 * a * c)
    if root is not None:
        yield from dict.fromkeys(((-b + root) / (2 * a), (-b - root) / (2 * a)))
