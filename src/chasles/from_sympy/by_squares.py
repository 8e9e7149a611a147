"""What is given contradicts itself, because squares with weights of at least zero add up to a negative number.

Weights are products of what has a sign, squares those of monomials, of differences of two and of slopes of what is
given: a linear program says which (A. A. Ahmadi and A. Majumdar, DSOS and SDSOS optimization, 2019; J.-L. Krivine,
1964).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import partial
from itertools import combinations, combinations_with_replacement
from math import prod
from operator import add

from chasles.algebra.cones import vanishing
from chasles.algebra.groebner import Basis, completed
from chasles.algebra.rings import Exponents, Polynomial, Ring
from chasles.algebra.work_limit import OutOfTime, remaining, within
from chasles.from_sympy.certificates import SquaresAgainst
from chasles.from_sympy.contradiction import known_signs
from chasles.from_sympy.question import Question
from chasles.problems.context import build
from chasles.problems.divisors import UndeclaredDivisor
from chasles.problems.variables import Untreatable
from chasles.prover.certifying import certified
from chasles.prover.decide import open_entries
from chasles.verdict import Undecided, Verdict

EFFORT = 2e6
"""The work that the search for squares may take, in products of terms."""
MOST_MONOMIALS, MOST_CANDIDATES, MOST_VARIABLES, LARGEST_DEGREE = 16, 400, 9, 6
Signs = Mapping[int, tuple[int, bool]]
"""By the place of a variable its sign, and whether it cannot vanish."""
Weighed = tuple[Polynomial, Polynomial, bool]
"""What is not negative, what is squared, and whether the product cannot vanish."""


def by_squares(decide: Callable[[Question], Verdict]) -> Callable[[Question], Verdict]:
    """The decision that looks for such squares first."""
    return lambda question: decide(question) if (found := _refuted_by_squares(question)) is None else found


def _refuted_by_squares(question: Question) -> Verdict | None:
    """The verdict that the claim follows, as nothing satisfies what is given; None where it follows by itself."""
    try:
        with within(min(EFFORT, remaining() / 4)):
            context = build(question.problem)
            entries = open_entries(context)
            basis = completed(context.basis, EFFORT / 4)
            if all(basis.reduce(entry.ratio.numerator)[1] == 0 for entry in entries):
                return None
            stated = [generator.polynomial for generator in context.generators]
            found = _impossible(context.field.ring, basis, stated, known_signs(question, context))
    except (OutOfTime, Untreatable, UndeclaredDivisor) as error:
        return Undecided(str(error))
    if found is None or question.search.write is None:
        return Undecided("no sum of squares was found that contradicts what is given")
    for entry in entries:
        entry.cofactors = dict(found.cofactors)
    write = partial(question.search.write, impossible=found)
    witness = question.search.witness(context, ()) or {}
    return question.answered(certified(context, (), (), entries, question.own, witness, write))


def _impossible(ring: Ring, basis: Basis, stated: list[Polynomial], signs: Signs) -> SquaresAgainst | None:
    degree = max((sum(e) for polynomial in stated for e, _ in ring.terms(polynomial)), default=0)
    places = [k for k in range(len(ring.names)) if any(ring.degrees(polynomial)[k] for polynomial in stated)]
    if len(places) > MOST_VARIABLES or degree > LARGEST_DEGREE:
        return None
    slopes = [slope for polynomial in stated for slope in _slopes(ring, polynomial)]
    for most, half, more in ((2, 1, 0), (1, 2, 0), (3, 1, 0), (2, (degree + 1) // 2, 0), (2, 1, 1)):
        weighed = _weighed(ring, places, signs, most, half, max(degree, 2) + more)
        weighed += [(ring.constant(Fraction(1)), slope, False) for slope in slopes]
        if len(weighed) <= MOST_CANDIDATES and (found := _combined(ring, basis, weighed)):
            return found
    return None


def _slopes(ring: Ring, polynomial: Polynomial) -> list[Polynomial]:
    """The slopes of what vanishes by variables of degree two: the square of one is the discriminant."""
    return [ring.derivative(polynomial, k) for k, degree in enumerate(ring.degrees(polynomial)) if degree == 2]


def _weighed(ring: Ring, places: list[int], signs: Signs, most: int, half: int, degree: int) -> list[Weighed]:
    """Squares up to a degree: so many factors at most with a sign, times monomials of half a degree, or two of them."""
    size, one = len(ring.names), Fraction(1)
    roots = list(_monomials(size, places, half))
    bases = [{root: one} for root in roots]
    for root, other in combinations(roots, 2) if len(roots) <= MOST_MONOMIALS else ():
        either = any(e % 2 and k not in signs for k, e in enumerate(map(add, root, other)))
        bases += [{root: one, other: side * one} for side in ((-1, 1) if either else (-1,))]
    found = []
    for weight in _monomials(size, [k for k in places if k in signs], most):
        side = prod(signs[k][0] ** e for k, e in enumerate(weight) if e)
        sure = all(signs[k][1] for k, e in enumerate(weight) if e)
        factor = ring.from_terms({weight: Fraction(side)})
        fitting = (base for base in bases if sum(weight) + 2 * max(map(sum, base)) <= degree)
        found += [(factor, ring.from_terms(base), sure and not any(map(any, base))) for base in fitting]
    return sorted(found, key=lambda weighed: not weighed[2])


def _monomials(size: int, places: list[int], degree: int) -> Iterator[Exponents]:
    for d in range(degree + 1):
        for chosen in combinations_with_replacement(places, d):
            yield tuple(chosen.count(k) for k in range(size))


def _combined(ring: Ring, basis: Basis, weighed: list[Weighed]) -> SquaresAgainst | None:
    """Such squares that add up to what vanishes, one of which does not; None if there are none."""
    different: dict[frozenset[tuple[Exponents, Fraction]], Weighed] = {}
    for factor, base, sure in weighed:
        left = ring.terms(basis.reduce(factor * base * base)[1])
        different.setdefault(frozenset(left), (factor, base, sure))
    chosen = list(different.values())
    weights = vanishing([dict(left) for left in different], {k for k, each in enumerate(chosen) if each[2]})
    if weights is None:
        return None
    squares = [(ring.constant(weights[k]) * chosen[k][0], chosen[k][1]) for k in sorted(weights)]
    total = ring.constant(Fraction(0))
    for factor, base in squares:
        total = total + factor * base * base
    return SquaresAgainst(squares, basis.reduce(total)[0])
