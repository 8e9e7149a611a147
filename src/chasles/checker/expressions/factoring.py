"""Polynomials by their factors, as far as these are known, for the checker."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt, prod

from chasles.checker.expressions.algebra import constant, primitive
from chasles.checker.sparse import MOST_POWER, ZERO, Polynomial, exponents, packed

Terms = frozenset[tuple[int, int]]


def root_of_square(polynomial: Polynomial) -> Polynomial | None:
    """A polynomial of which this is the square, term by term from the top; None if it is none."""
    root, rest = ZERO, polynomial
    lead = 0
    while rest:
        top = max(rest.terms)
        c, pairs = Fraction(rest.terms[top], rest.below), exponents(top)
        if not root:
            above, below = isqrt(max(c.numerator, 0)), isqrt(c.denominator)
            if Fraction(above * above, below * below) != c or any(power % 2 for _, power in pairs):
                return None
            term = Polynomial({top // 2: above}, below)
            lead = top // 2
        else:
            if not divides(lead, top) or top >= 2 * lead:
                return None
            c /= 2 * Fraction(root.terms[lead], root.below)
            term = Polynomial({top - lead: c.numerator}, c.denominator)
        root, rest = root + term, rest - term * (root + root + term)
    return root


def terms_of(polynomial: Polynomial) -> Terms:
    """The same for all multiples."""
    return frozenset((polynomial if constant(polynomial) is not None else primitive(polynomial)[1]).terms.items())


def quotient(polynomial: Polynomial, divisor: Polynomial) -> Polynomial | None:
    """The polynomial over another, if that divides it: terms are taken in the order of their packed exponents."""
    below = _at_whole_numbers(divisor)
    if below and _at_whole_numbers(polynomial) % below:
        return None  # By Gauss's lemma the quotient of primitive polynomials is whole where both are.
    lead = max(divisor.terms)
    total, rest = ZERO, polynomial
    while rest:
        top = max(rest.terms)
        if not divides(lead, top):
            return None
        c = Fraction(rest.terms[top] * divisor.below, divisor.terms[lead] * rest.below)
        part = Polynomial({top - lead: c.numerator}, c.denominator)
        total, rest = total + part, rest - part * divisor
    return total


def divides(one: int, other: int) -> bool:
    """Whether a product of powers divides another: then no bit of the guard is borrowed from."""
    guard = sum(packed(place, MOST_POWER + 1) for place, _ in exponents(one))
    return (other | guard) - one & guard == guard


def _at_whole_numbers(polynomial: Polynomial) -> int:
    """The value of the primitive part at a point."""
    terms = primitive(polynomial)[1].terms.items()
    return sum(c * prod((2 * place + 3) ** power for place, power in exponents(m)) for m, c in terms)
