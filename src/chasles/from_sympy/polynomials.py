"""Polynomials of a context, factored by SymPy and written in words or in SymPy's spelling."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from fractions import Fraction
from math import gcd, lcm, prod
from operator import sub
from typing import Any

import sympy

from chasles.algebra.rings import Exponents, Polynomial, make_ring
from chasles.from_sympy.reader import multiplied
from chasles.problems.context import Context
from chasles.problems.variables import Variable
from chasles.vocabulary import Call, Node, Number, Power, Scale, Sum, Symbol

MOST_TERMS = 80
MOST_VARIABLES = 2
"""In more variables, factoring can take SymPy minutes: only squares and single variables are split off there."""
Key = frozenset[tuple[tuple[tuple[str, int], ...], Fraction]]
Factors = list[tuple[Polynomial, int]]
Terms = dict[Exponents, Fraction]


def key_of(context: Context, polynomial: Polynomial) -> Key:
    """The polynomial in the names of its variables, the same in every ring."""
    names = context.field.ring.names
    return frozenset(
        (tuple(sorted((names[k], e) for k, e in enumerate(exponents) if e)), coefficient)
        for exponents, coefficient in context.field.ring.terms(polynomial)
    )


def factored(context: Context, polynomial: Polynomial, roots: Collection[str] = ()) -> tuple[int, Fraction, Factors]:
    """Sign, size and factors with their powers, none of them a square; irreducible ones if it is in few variables.

    The factors have integers without common factors as coefficients; where only squares occur of one of the `roots`,
    they are polynomials in that square.
    """
    ring = context.field.ring
    terms = ring.terms(polynomial)
    squared = [name in roots and all(e[k] % 2 == 0 for e, _ in terms) for k, name in enumerate(ring.names)]
    places = [k for k in range(len(ring.names)) if any(exponents[k] for exponents, _ in terms)]
    if not places or len(terms) > MOST_TERMS:
        constant = terms[0][1] if not places else Fraction(1)
        return (1 if constant > 0 else -1), abs(constant), [] if not places else [(polynomial, 1)]
    packed = {tuple(e[k] >> squared[k] for k in places): coefficient for e, coefficient in terms}
    lowest = [min(exponents) for exponents in zip(*packed, strict=True)]
    rest = {tuple(map(sub, e, lowest)): coefficient for e, coefficient in packed.items()}
    factors = _irreducible(rest) if sum(map(any, zip(*rest, strict=True))) <= MOST_VARIABLES else _square_free(rest)
    alone = [tuple(int(k == place) for k in range(len(places))) for place in range(len(places))]
    factors += [({gen: Fraction(1)}, power) for gen, power in zip(alone, lowest, strict=True) if power]
    first_term = max(rest)
    size = rest[first_term] / prod((factor[max(factor)] ** power for factor, power in factors), start=Fraction(1))
    sign = 1 if size > 0 else -1
    found: Factors = []
    for factor, power in factors:
        unpacked = {}
        for exponents, coefficient in factor.items():
            spread = [0] * len(ring.names)
            for place, exponent in zip(places, exponents, strict=True):
                spread[place] = exponent << squared[place]
            unpacked[tuple(spread)] = coefficient
        first = min(unpacked, key=lambda e: sorted((ring.names[k], x) for k, x in enumerate(e) if x))
        flip = -1 if unpacked[first] < 0 else 1
        sign *= flip if power % 2 else 1
        values = unpacked.values()
        unit = Fraction(gcd(*(c.numerator for c in values)), lcm(*(c.denominator for c in values)))
        size *= unit**power
        found.append((ring.from_terms({e: flip * c / unit for e, c in unpacked.items()}), power))
    return sign, abs(size), found


def _irreducible(terms: Terms) -> list[tuple[Terms, int]]:
    """The factors of a polynomial given by its terms, up to a number."""
    if not any(map(any, terms)):
        return []
    gens = sympy.symbols(f"x:{len(next(iter(terms)))}")
    rationals = {e: sympy.Rational(c.numerator, c.denominator) for e, c in terms.items()}
    _, factors = sympy.Poly.from_dict(rationals, *gens).factor_list()
    return [
        ({tuple(map(int, e)): Fraction(int(c.p), int(c.q)) for e, c in factor.terms()}, int(power))
        for factor, power in factors
    ]


def _square_free(terms: Terms) -> list[tuple[Terms, int]]:
    """The product of the factors of each power of a polynomial given by its terms, up to a number."""
    ring = make_ring(map(str, range(len(next(iter(terms))))))
    return [(dict(ring.terms(factor)), power) for factor, power in ring.square_free(ring.from_terms(terms))]


def as_node(context: Context, polynomial: Polynomial) -> Node:
    """The polynomial in words."""
    terms = []
    for exponents, coefficient in sorted(context.field.ring.terms(polynomial), reverse=True):
        factors: list[Node] = [] if coefficient == 1 and any(exponents) else [Number(coefficient)]
        for variable, exponent in zip(context.variables, exponents, strict=True):
            if exponent:
                base = _variable_node(context, variable)
                factors.append(base if exponent == 1 else Power(base, exponent))
        terms.append(multiplied(factors))
    if not terms:
        return Number(Fraction(0))
    return terms[0] if len(terms) == 1 else Sum(tuple(terms))


def _variable_node(context: Context, variable: Variable) -> Node:
    assert variable.symbol is not None
    if variable.kind == "entry":
        return variable.symbol
    unit = context.unfold.coordinates.unit(variable.symbol)
    return Call(variable.kind, variable.symbol if unit == 1 else Scale(Number(unit), variable.symbol))


def as_sympy(origins: Mapping[Symbol, Any], context: Context, polynomial: Polynomial) -> Any:
    """The polynomial in SymPy's spelling."""
    terms = []
    for exponents, coefficient in context.field.ring.terms(polynomial):
        term = sympy.Rational(coefficient.numerator, coefficient.denominator)
        for variable, exponent in zip(context.variables, exponents, strict=True):
            if exponent and variable.symbol is not None:
                origin = origins[variable.symbol]
                if variable.kind != "entry":
                    origin = getattr(sympy, variable.kind)(origin * context.unfold.coordinates.unit(variable.symbol))
                term = term * origin**exponent
        terms.append(term)
    return sympy.Add(*terms)
