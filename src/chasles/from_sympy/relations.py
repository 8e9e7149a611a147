"""Relations between the numbers of a question: a remainder vanishes if the coefficients in it are numbers that do."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import sympy

from chasles.algebra.rings import Polynomial
from chasles.from_sympy.constants import is_algebraic, vanishes
from chasles.from_sympy.polynomials import as_sympy
from chasles.from_sympy.question import Question
from chasles.problems.context import Context, build, difference
from chasles.problems.generators import entries


def relations(question: Question, meanings: Mapping[Any, Any]) -> list[Any]:
    """Numbers that vanish, by which the two sides are equal; none if they are not. `meanings` are those of symbols."""
    origins = {word: origin.xreplace(meanings) for word, origin in question.origins.items()}
    if all(_is_plain(origin) for origin in origins.values() if is_algebraic(origin)):
        return []
    context = build(question.problem)
    symbols = [(place, variable.symbol) for place, variable in enumerate(context.variables)]
    numeric = [place for place, symbol in symbols if symbol is not None and is_algebraic(origins.get(symbol))]
    claims = [ratio.numerator for goal in context.problem.goals for _, _, ratio in entries(difference(context, goal))]
    reduced = [context.basis.reduce(claim)[1] for claim in claims]
    for polynomials in (claims, reduced) if any(claim != 0 for claim in reduced) else ():
        coefficients = [c for polynomial in polynomials for c in _coefficients(context, polynomial, numeric)]
        found = list(dict.fromkeys(as_sympy(question.origins, context, c) for c in coefficients))
        if all(vanishes(number.xreplace(meanings)) for number in found):
            return found
    return []


def _is_plain(number: Any) -> bool:
    """Whether a number is the square root of an integer, which the prover knows as it is."""
    return (
        isinstance(number, sympy.Pow) and isinstance(number.base, sympy.Integer) and number.exp == sympy.Rational(1, 2)
    )


def _coefficients(context: Context, polynomial: Polynomial, numeric: list[int]) -> list[Polynomial]:
    """The coefficients of the products of what is no number, numbers being in the places given."""
    ring = context.field.ring
    found: dict[tuple[int, ...], dict[tuple[int, ...], Fraction]] = {}
    for exponents, coefficient in ring.terms(polynomial):
        inside = tuple(e if place in numeric else 0 for place, e in enumerate(exponents))
        outside = tuple(0 if place in numeric else e for place, e in enumerate(exponents))
        found.setdefault(outside, {})[inside] = coefficient
    return [ring.from_terms(terms) for terms in found.values()]
