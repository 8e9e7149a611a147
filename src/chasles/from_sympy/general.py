"""More general questions: into how many parts half a turn is to be divided, and which symbols are alike.

Numbers may be related: a remainder vanishes if the coefficients in it are numbers that do.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from fractions import Fraction
from math import lcm
from typing import Any

import sympy

from chasles.algebra.rings import Polynomial
from chasles.checker.expressions.defined_functions import defined_by
from chasles.checker.expressions.generalised import Generalised
from chasles.checker.expressions.readings import CIRCULAR, MOST_PARTS
from chasles.checker.sparse import Rejected
from chasles.from_sympy.constants import is_algebraic, vanishes
from chasles.from_sympy.enclosures import Enclosures
from chasles.from_sympy.opening import atoms_of
from chasles.from_sympy.polynomials import as_sympy
from chasles.from_sympy.question import Question
from chasles.problems.context import Context, build, difference
from chasles.problems.generators import entries
from chasles.problems.variables import Untreatable


class General(Generalised):
    """Rewrites the expressions of a question; `facts` are what the symbols satisfy."""

    def __init__(self, expressions: Iterable[Any]) -> None:
        self.expressions = list(expressions)
        super().__init__(self.expressions, self._parts(), {str(s) for e in self.expressions for s in e.free_symbols})
        self.facts: list[Any] = [_minimal(self.parts, self.cosine)] if self.parts else []

    @property
    def meanings(self) -> dict[Any, Any]:
        """What the symbols stand for."""
        return {symbol: meaning for meaning, symbol in self.symbols.items()}

    def alike(self) -> Iterator[tuple[Any, Any, Any]]:
        """Symbols, each with what multiple of an earlier one it seems to be, by their values at one point."""
        meanings = {symbol: meaning for symbol, meaning in self.meanings.items() if not defined_by(meaning)}
        if not any(meaning.free_symbols for meaning in meanings.values()) or len(meanings) < 2:
            return
        atoms = sorted({atom for meaning in meanings.values() for atom in atoms_of(meaning)}, key=str)
        values = Enclosures({atom: sympy.Rational(*map(sympy.prime, (50 + k, 90 + k))) for k, atom in enumerate(atoms)})
        first: dict[Any, Any] = {}
        for symbol, meaning in meanings.items():
            with suppress(Rejected):
                known = (other for other in first if meaning.free_symbols)
                found = ((other, ratio) for other in known if (ratio := _ratio(values, meaning, first[other])))
                if (same := next(found, None)) is not None:
                    yield symbol, same[1], same[0]
                elif values(meaning).sign:
                    first[symbol] = meaning

    def _parts(self) -> int:
        """Into how many parts half a turn is to be divided; 0 if SymPy writes all cosines in roots."""
        calls = {call for e in self.expressions for call in e.atoms(*CIRCULAR)}
        turns = {_turn(call.args[0]) for call in calls}
        if all(map(_in_roots, turns)):
            return 0
        parts = lcm(*(part.denominator for turn in turns for part in (turn, turn - Fraction(1, 2))))
        if parts > MOST_PARTS:
            raise Untreatable(f"angles that are multiples of pi/{parts} are not treated: no finer than pi/{MOST_PARTS}")
        return parts


def _ratio(values: Enclosures, one: Any, other: Any) -> Any:
    """The fraction that the quotient of two expressions seems to be; None for any other."""
    above, below = (enclosed.low + enclosed.high for enclosed in map(values, (one, other)))
    near = sympy.Rational(Fraction(above, below).limit_denominator(MOST_PARTS))
    return near if near != 0 and not values(one - near * other).sign else None


def _turn(argument: Any) -> Fraction:
    """The rational multiple of pi in a sum."""
    multiple = sympy.expand(argument).as_coefficients_dict().get(sympy.pi, sympy.S.Zero)
    return Fraction(int(multiple.p), int(multiple.q))


def _in_roots(turn: Fraction) -> bool:
    angle = sympy.Rational(turn.numerator, turn.denominator) * sympy.pi
    return not any(value.has(sympy.cos, sympy.sin) for value in (sympy.cos(angle), sympy.sin(angle)))


def _minimal(parts: int, cosine: Any) -> Any:
    """The minimal polynomial of cos(pi/n): the cyclotomic one of order 2 n is palindromic in z and 1/z."""
    z = sympy.Symbol("z")
    coefficients = sympy.Poly(sympy.cyclotomic_poly(2 * parts, z), z).all_coeffs()
    half = len(coefficients) // 2
    terms = (2 * coefficients[half - k] * sympy.chebyshevt(k, cosine) for k in range(1, half + 1))
    return sympy.expand(coefficients[half] + sympy.Add(*terms))


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
