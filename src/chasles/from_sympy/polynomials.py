"""Polynomials of a context, factored by SymPy and written in words or in SymPy's spelling."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from fractions import Fraction
from math import gcd, lcm
from typing import Any

import sympy

from chasles.algebra.rings import Polynomial
from chasles.from_sympy.reader import multiplied
from chasles.problems.context import Context
from chasles.problems.variables import Variable
from chasles.vocabulary import Call, Node, Number, Power, Scale, Sum, Symbol

MOST_TERMS = 80
MOST_VARIABLES = 2
"""In more variables, factoring can take SymPy minutes: only squares and single variables are split off there."""
Key = frozenset[tuple[tuple[tuple[str, int], ...], Fraction]]
Factors = list[tuple[Polynomial, int]]


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
    gens = sympy.symbols(f"x:{len(places)}")
    packed = {tuple(e[k] >> squared[k] for k in places): sympy.Rational(c.numerator, c.denominator) for e, c in terms}
    whole = sympy.Poly.from_dict(packed, *gens)
    monomials, rest = whole.terms_gcd()
    content, factors = rest.factor_list() if len(rest.free_symbols) <= MOST_VARIABLES else rest.sqf_list()
    factors += [(sympy.Poly(gen, *gens), power) for gen, power in zip(gens, monomials, strict=True) if power]
    size = Fraction(int(content.p), int(content.q))
    sign = 1 if size > 0 else -1
    found: Factors = []
    for factor, power in factors:
        unpacked = {}
        for exponents, coefficient in factor.terms():
            spread = [0] * len(ring.names)
            for place, exponent in zip(places, exponents, strict=True):
                spread[place] = int(exponent) << squared[place]
            unpacked[tuple(spread)] = Fraction(int(coefficient.p), int(coefficient.q))
        first = min(unpacked, key=lambda e: sorted((ring.names[k], x) for k, x in enumerate(e) if x))
        flip = -1 if unpacked[first] < 0 else 1
        sign *= flip if power % 2 else 1
        values = unpacked.values()
        unit = Fraction(gcd(*(c.numerator for c in values)), lcm(*(c.denominator for c in values)))
        size *= unit ** int(power)
        found.append((ring.from_terms({e: flip * c / unit for e, c in unpacked.items()}), int(power)))
    return sign, abs(size), found


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
