"""The field in which exact numbers are computed: rationals, the roots that occur in them, and independent elements.

Roots are given by one primitive element, so that zero has one form. Pi, symbols and whatever else is no root of small
degree are independent elements: a number that vanishes for all their values is zero; another is told from zero by an
enclosure, or the question is declined.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache, reduce
from math import gcd
from operator import add, mul
from typing import Any

import sympy as sp
from sympy.polys.domains import QQ

from chasles.exact.numbers import NotDecided
from chasles.exact.separation import degree_of

MOST_TURNS = 24
"""Sines of larger denominators than pi / MOST_TURNS are independent elements: their degree as roots is too large."""
MOST_DEGREE = 12
"""Of the field: factoring a polynomial over a larger one takes minutes."""


class NumberField:
    """The least field with some exact numbers in it; `roots` and `free` are what it is made of."""

    def __init__(self, *values: Any) -> None:
        atoms = dict.fromkeys(atom for value in values for atom in _atoms(sp.sympify(value)))
        self.roots = tuple(sorted((atom for atom in atoms if _is_small_root(atom)), key=str))
        self.free = tuple(sorted((atom for atom in atoms if atom not in self.roots), key=str))
        self.algebraic, self._of_roots = _algebraic(self.roots)
        self._symbols = {atom: sp.Symbol(f"free_{place}") for place, atom in enumerate(self.free)}
        self.domain = self.algebraic.frac_field(*self._symbols.values()) if self.free else self.algebraic
        self._elements: dict[sp.Expr, Any] = {}

    def __call__(self, value: Any) -> Any:
        """The element that an exact number, or SymPy expression, stands for."""
        expression = sp.sympify(value)
        if expression not in self._elements:
            self._elements[expression] = self._read(expression)
        return self._elements[expression]

    def _read(self, value: sp.Expr) -> Any:
        match value:
            case sp.Rational():
                return self.domain.convert(QQ(value.p, value.q))
            case sp.Add():
                return reduce(add, map(self, value.args))
            case sp.Mul():
                return reduce(mul, map(self, value.args))
            case sp.cot():
                return self.domain.one / self(sp.tan(value.args[0]))
            case _ if value in self._symbols:
                return self.domain.from_sympy(self._symbols[value])
            case sp.Pow(exp=sp.Rational(q=1)):
                return self(value.base) ** int(value.exp)
            case sp.Pow(exp=sp.Rational(p=p)) if p != 1:
                return self(sp.Pow(value.base, sp.Rational(1, value.exp.q))) ** int(p)
        if value in self._of_roots:
            element = self._of_roots[value]
            return self.domain.convert_from(element, self.algebraic) if self.free else element
        return reduce(mul, (self(root) for root in _prime_roots(value)))

    def expression(self, element: Any) -> sp.Expr:
        """The element as a SymPy expression, roots of numbers multiplied out."""
        if not self.free:
            return sp.expand(self.domain.to_sympy(element))
        back = {symbol: atom for atom, symbol in self._symbols.items()}
        above, below = (sp.expand(self.domain.to_sympy(part)) for part in (element.numer, element.denom))
        return (above / below).xreplace(back)


@lru_cache(maxsize=200)
def _algebraic(roots: tuple[sp.Expr, ...]) -> tuple[Any, dict[sp.Expr, Any]]:
    """The extension of the rationals by some roots, and what each of these is in it; NotDecided for a large one."""
    if (degree := degree_of(roots)) > MOST_DEGREE:
        raise NotDecided(
            f"roots that occur here are numbers of degree up to {degree}, and {MOST_DEGREE} can be handled"
        )
    domain = QQ.algebraic_field(*roots) if roots else QQ
    return domain, {root: domain.from_sympy(root) for root in roots}


def _prime_roots(value: sp.Expr) -> tuple[sp.Expr, ...]:
    """The square root of an integer as those of its prime factors; another root as it is."""
    match value:
        case sp.Pow(base=sp.Integer(), exp=sp.Rational(p=1, q=2)) if value.base > 1:
            return tuple(sp.sqrt(prime) for prime in sp.factorint(value.base, multiple=True))
    return (value,)


def _atoms(value: sp.Expr) -> Iterator[sp.Expr]:
    """Whatever the four operations do not take apart."""
    match value:
        case sp.Rational():
            return
        case sp.Add() | sp.Mul():
            for part in value.args:
                yield from _atoms(part)
        case sp.Pow(exp=sp.Rational(q=1)):
            yield from _atoms(value.base)
        case sp.Pow(exp=sp.Rational()):
            yield from _prime_roots(sp.Pow(value.base, sp.Rational(1, value.exp.q)))
        case sp.cot():
            yield sp.tan(value.args[0])
        case _:
            yield value


def _is_small_root(atom: sp.Expr) -> bool:
    """Whether the atom is a root of rational numbers, or of such, or the sine of a simple part of a turn."""
    match atom:
        case sp.Rational():
            return True
        case sp.Add() | sp.Mul():
            return all(map(_is_small_root, atom.args))
        case sp.Pow(exp=sp.Rational()):
            return _is_small_root(atom.base)
        case sp.cos() | sp.sin() | sp.tan():
            turns = atom.args[0] / sp.pi
            return bool(turns.is_Rational) and turns.q // gcd(int(turns.q), 2) <= MOST_TURNS
        case _:
            return False
