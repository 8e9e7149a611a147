"""Angles: sums of rational multiples of atoms, of products of atoms such as omega*t, and of pi."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import reduce
from typing import Any

import sympy

from chasles.checker.expressions.quantities import is_atom
from chasles.from_sympy.atoms import QuantityNames
from chasles.from_sympy.opening import excerpt
from chasles.problems.variables import Untreatable
from chasles.vocabulary import Node, Number, Scale, Sum, Symbol

LARGEST_MULTIPLE = 10_000


class Angles:
    """Splits the arguments of sines and cosines into terms; products of atoms become words of their own."""

    def __init__(self, atoms: QuantityNames) -> None:
        self.atoms = atoms
        self.products: dict[Symbol, dict[Symbol, int]] = {}
        self.met: set[Symbol] = set()
        self._words: dict[Any, Symbol] = {}

    def __call__(self, argument: Any) -> tuple[Node | None, Any, Any]:
        """The part without pi in words (None if there is none), and the cosine and sine of the part with pi.

        Raises `Untreatable` if the argument is no angle, or if SymPy knows no square roots for that part.
        """
        multiples: dict[Symbol, Fraction] = {}
        turn = sympy.S.Zero
        for term in _terms(argument):
            multiple, rest = term.as_coeff_Mul()
            if not multiple.is_Rational or rest == 1 or max(abs(multiple.p), multiple.q) > LARGEST_MULTIPLE:
                raise _no_angle(argument)
            if rest is sympy.pi:
                turn += term
                continue
            word = self._word(rest, argument)
            multiples[word] = multiples.get(word, Fraction(0)) + Fraction(int(multiple.p), int(multiple.q))
        cosine, sine = sympy.cos(turn), sympy.sin(turn)
        if cosine.has(sympy.cos, sympy.sin) or sine.has(sympy.cos, sympy.sin):
            raise Untreatable(f"cos({turn}) is not treated: SymPy does not write it in square roots")
        parts: list[Node] = [Scale(Number(q), word) if q != 1 else word for word, q in multiples.items() if q]
        angle = None if not parts else reduce(lambda one, other: Sum((one, other)), parts)
        return angle, cosine, sine

    def _word(self, rest: Any, argument: Any) -> Symbol:
        if is_atom(rest):
            self.met.add(self.atoms.word(rest))
            return self.atoms.word(rest)
        if rest not in self._words:
            powers = rest.as_powers_dict()
            if not all(is_atom(base) and power.is_Integer and power.is_positive for base, power in powers.items()):
                raise _no_angle(argument)
            factors = {self.atoms.word(base): int(power) for base, power in powers.items()}
            self._words[rest] = word = self.atoms.fresh(str(rest), rest)
            self.products[word] = factors
        return self._words[rest]


def _terms(argument: Any) -> Iterator[Any]:
    """The terms of a sum, and of the sums that stand unevaluated in it."""
    for term in sympy.Add.make_args(sympy.expand(argument)):
        if isinstance(term, sympy.Add):
            yield from _terms(term)
        else:
            yield term


def _no_angle(argument: Any) -> Untreatable:
    return Untreatable(
        f"{excerpt(argument)} is no angle: an angle is a sum of rational multiples of real symbols, "
        f"of products of them, and of pi, none above {LARGEST_MULTIPLE}"
    )
