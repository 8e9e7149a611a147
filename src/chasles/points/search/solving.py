"""Values that satisfy equations: what is linear is eliminated, other equations are solved one at a time.

From a point with small coordinates a quadric is left through a second point on a line: rational coordinates stay
rational. What is not found at one draw is tried again at another.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from random import Random

from chasles.algebra.surds import Key, SurdSum, square_root
from chasles.points.search.values import Partial, Values, degree

Draw = Callable[[int], Fraction]
TRIES = 60
HALF = 0.5


def unknowns(partials: Sequence[Partial]) -> list[int]:
    """The places of the variables that have no value."""
    return sorted({k for partial in partials for monomial in partial for k, _ in monomial})


def eliminable(partials: Sequence[Partial]) -> list[tuple[int, Partial]]:
    """Variables that an equation determines as polynomials in others: they occur in one of its terms, alone."""
    found: list[tuple[int, Partial]] = []
    for partial in partials:
        for place in unknowns([partial]):
            occurring = [monomial for monomial in partial if any(k == place for k, _ in monomial)]
            inverse = partial[occurring[0]].inverse() if occurring == [((place, 1),)] else None
            if inverse is not None:
                rest = {m: -c * inverse for m, c in partial.items() if m != ((place, 1),)}
                found.append((place, rest))
    return found


def solve_one(partial: Partial, draw: Draw, random: Random, plain: bool) -> dict[int, SurdSum] | None:
    """Values of unknowns of one equation that satisfy it, if some are found; `plain` asks for simple ones."""
    places = unknowns([partial])
    common = [k for k in places if all(any(place == k for place, _ in monomial) for monomial in partial)]
    if common and (len(partial) == 1 or random.random() < HALF):
        return {random.choice(common): SurdSum({})}
    linear = [k for k in places if all(e == 1 for monomial in partial for place, e in monomial if place == k)]
    if linear:
        return _for_one(partial, random.choice(linear), places, draw, random)
    if degree(partial) == 2:
        found = _on_quadric(partial, places, random, plain)
        if found is not None:
            return found
    return _for_one(partial, random.choice(places), places, draw, random) or _small(partial, places, random)


def _for_one(partial: Partial, target: int, places: list[int], draw: Draw, random: Random) -> dict[int, SurdSum] | None:
    """Draw all unknowns but one, and solve a linear or quadratic equation for that."""
    solution = {k: SurdSum.rational(draw(k)) for k in places if k != target}
    values = Values()
    for k, value in solution.items():
        values[k] = value
    powers = [SurdSum({})] * 3
    for monomial, coefficient in partial.items():
        exponent = dict(monomial).get(target, 0)
        if exponent > 2:
            return None
        rest = tuple(pair for pair in monomial if pair[0] != target)
        powers[exponent] = powers[exponent] + coefficient * values.of([(rest, Fraction(1))])
    root = _quadratic(powers, random)
    if root is None:
        return None
    solution[target] = root if isinstance(root, SurdSum) else SurdSum.rational(draw(target))
    return solution


def _quadratic(powers: list[SurdSum], random: Random) -> SurdSum | bool | None:
    """A real solution of a quadratic equation; True if every number is one, None if none is found."""
    c, b, a = powers
    if a.is_zero:
        if b.is_zero:
            return True if c.is_zero else None
        inverse = b.inverse()
        return None if inverse is None else -c * inverse
    inverse = (a + a).inverse()
    discriminant = (b * b - a * c * SurdSum.rational(4)).as_rational
    root = None if discriminant is None else square_root(discriminant)
    if inverse is None or root is None:
        return None
    return (random.choice((root, -root)) - b) * inverse


def _small(partial: Partial, places: list[int], random: Random) -> dict[int, SurdSum] | None:
    """Small integers that satisfy the equation."""
    for trial in range(TRIES):
        reach = 1 if trial < TRIES // 2 else 3
        point = {k: random.randint(-reach, reach) for k in places}
        if _at(partial, point).is_zero:
            return {k: SurdSum.rational(x) for k, x in point.items()}
    return None


def _on_quadric(partial: Partial, places: list[int], random: Random, plain: bool) -> dict[int, SurdSum] | None:
    """A point of a quadric: a small one, or where a line through a small one meets the quadric again."""
    start = _small(partial, places, random)
    if start is None or plain:
        return start
    point = {k: value.as_rational or Fraction(0) for k, value in start.items()}
    way = {k: Fraction(random.randint(-3, 3)) for k in places}
    ahead = _at(partial, {k: point[k] + way[k] for k in places})
    behind = _at(partial, {k: point[k] - way[k] for k in places})
    # Along the line the polynomial is t (slope + curve t), for it vanishes at t = 0.
    slope, curve = (
        (ahead - behind) * SurdSum.rational(Fraction(1, 2)),
        (ahead + behind) * SurdSum.rational(Fraction(1, 2)),
    )
    inverse = curve.inverse()
    t = None if inverse is None else (-slope * inverse).as_rational
    if t is None:
        return start
    return {k: SurdSum.rational(point[k] + t * way[k]) for k in places}


def _at(partial: Partial, point: Mapping[int, Fraction | int]) -> SurdSum:
    total: dict[Key, Fraction] = {}
    for monomial, coefficient in partial.items():
        size: Fraction | int = 1
        for place, exponent in monomial:
            size *= point[place] ** exponent
        for key, part in coefficient.terms.items() if size else ():
            total[key] = total.get(key, Fraction(0)) + part * size
    return SurdSum({key: part for key, part in total.items() if part})
