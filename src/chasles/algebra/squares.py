"""Polynomials as sums of squares, without search: each product is shared among the squares that are there already.

The Gram matrix over the roots of the squares that occur with a positive coefficient is unique for quadratic forms, and
a good guess for others; completing squares (Lagrange's reduction) says exactly whether it is positive-semidefinite.
Source: Gram matrices of sums of squares (Choi, Lam and Reznick 1995), without the semidefinite program.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from fractions import Fraction
from typing import TypeVar

_K = TypeVar("_K")
Exponents = tuple[int, ...]
Square = tuple[Fraction, Exponents, dict[Exponents, Fraction]]
"""A positive number, a product of variables that are not negative, and what is squared."""
MOST = 80
"""So many roots are looked at at most."""


def sum_of_squares(terms: Mapping[Exponents, Fraction], nonnegative: Collection[int]) -> list[Square] | None:
    """Squares whose sum is the polynomial; None if none are found. Variables at some places are `nonnegative`."""
    even = {_doubled(exponents, nonnegative): c for exponents, c in terms.items() if c}
    roots = [
        tuple(e // 2 for e in m) for m, c in sorted(even.items(), reverse=True) if c > 0 and not any(e % 2 for e in m)
    ]
    if len(roots) > MOST:
        return None
    gram: dict[Exponents, dict[Exponents, Fraction]] = {root: {} for root in roots}
    for monomial, coefficient in even.items():
        half = tuple(e // 2 for e in monomial)
        if coefficient > 0 and tuple(2 * e for e in half) == monomial:
            gram[half][half] = coefficient
            continue
        pairs = [root for root in roots if (other := _less(monomial, root)) in gram and other != root]
        if not pairs:
            return None
        for root in pairs:
            gram[root][_less(monomial, root)] = coefficient / len(pairs)
    rows = by_lagrange(gram)
    if rows is None:
        return None
    squares: list[Square] = []
    for root, pivot, row in rows:
        odd = tuple(e % 2 if k in nonnegative else 0 for k, e in enumerate(root))
        squares.append((pivot, odd, {_halved(_less(other, odd), nonnegative): entry for other, entry in row.items()}))
    return squares


def by_lagrange(gram: dict[_K, dict[_K, Fraction]]) -> list[tuple[_K, Fraction, dict[_K, Fraction]]] | None:
    """Squares of linear forms whose sum is the quadratic form, each with its factor; None if it is negative somewhere.

    The matrix is used up.
    """
    squares = []
    while gram:
        root, row = next(iter(gram.items()))
        pivot = row.get(root, Fraction(0))
        if pivot < 0 or (pivot == 0 and any(row.values())):
            return None
        del gram[root]
        if pivot == 0:
            continue
        others = [other for other, entry in row.items() if entry and other != root]
        for other in others:
            for another in others:
                gram[other][another] = gram[other].get(another, Fraction(0)) - row[other] * row[another] / pivot
            gram[other].pop(root, None)
        squares.append((root, pivot, {other: entry / pivot for other, entry in row.items() if entry}))
    return squares


def _doubled(exponents: Exponents, places: Collection[int]) -> Exponents:
    """The exponents where a variable at one of the places is the square of another."""
    return tuple(2 * e if k in places else e for k, e in enumerate(exponents))


def _halved(exponents: Exponents, places: Collection[int]) -> Exponents:
    return tuple(e // 2 if k in places else e for k, e in enumerate(exponents))


def _less(one: Exponents, other: Exponents) -> Exponents:
    return tuple(a - b for a, b in zip(one, other, strict=True))
