"""The exact values of polynomials and fractions at a point, and whether a point satisfies all that is known."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from chasles.algebra.localization import Ratio
from chasles.algebra.rings import Polynomial
from chasles.algebra.values import InPi, Value, divided, is_zero
from chasles.algebra.work_limit import spend
from chasles.problems.context import Context
from chasles.statements import Hypothesis

Point = dict[str, Fraction]
Term = tuple[tuple[int, int], tuple[tuple[str, int], ...], int]


def evaluate(context: Context, polynomial: Polynomial, point: Point) -> Value:
    """The polynomial's exact value; every variable that occurs in it must have a value.

    Numerators and denominators are multiplied on their own: a fraction in lowest terms after each step takes longer.
    """
    terms = terms_of(context, polynomial)
    spend(len(terms))
    total: dict[int, tuple[int, int]] = {}
    for coefficient, factors, power in terms:
        above, below = coefficient
        for name, exponent in factors:
            value = point[name]
            numerator = value.numerator
            if not numerator:
                break
            above *= numerator**exponent
            below *= value.denominator**exponent
        else:
            one, other = total.get(power, (0, 1))
            total[power] = (one + above, below) if other == below else (one * below + above * other, other * below)
    return {power: Fraction(above, below) for power, (above, below) in total.items() if above}


def terms_of(context: Context, polynomial: Polynomial) -> list[Term]:
    """The polynomial's terms, read once: sampling evaluates the same few polynomials again and again.

    Each is a coefficient as numerator and denominator, the names of what it multiplies with their exponents, and the
    power of pi or of an angle.
    """
    known = context.terms.get(id(polynomial))
    if known is None:
        names, transcendental = context.field.ring.names, context.transcendental
        terms = [
            (
                coefficient.as_integer_ratio(),
                tuple((names[place], exponent) for place, exponent in enumerate(exponents) if exponent),
                sum(exponents[place] for place in transcendental),
            )
            for exponents, coefficient in context.field.ring.terms(polynomial)
        ]
        known = context.terms[id(polynomial)] = (polynomial, terms)
    return known[1]


def ratio_at(context: Context, ratio: Ratio, point: Point) -> Value | None:
    """The exact value of a fraction; None where its denominator is not a single power."""
    below = context.field.power_product(ratio.denominator)
    return divided(evaluate(context, ratio.numerator, point), evaluate(context, below, point))


def satisfies(context: Context, point: Point) -> bool:
    """Whether every generator and condition vanishes at the point and no nonzero factor does."""
    vanishing = (*context.generators, *context.conditions)
    return (
        all(is_zero(evaluate(context, g.polynomial, point)) for g in vanishing)
        and all(not is_zero(evaluate(context, factor, point)) for _, factor in context.nonzero)
        and all(_is_positive(context, h, point) for h in context.active if h.kind == "positive")
    )


def _is_positive(context: Context, hypothesis: Hypothesis, point: Point) -> bool:
    """Whether the quantity is positive, given that an angle or pi in it is."""
    value = ratio_at(context, context.unfold(hypothesis.subjects[0])[0][0], point)
    return value is not None and all(coefficient > 0 for coefficient in value.values())


def measured(context: Context, point: Mapping[str, Any]) -> dict[str, Any]:
    """The point with its angles as multiples of pi, where pi measures them."""
    angles = {context.variables[place].name for place in context.transcendental if context.pi_measures}
    return {
        name: InPi(value) if name in angles and isinstance(value, Fraction) else value for name, value in point.items()
    }
