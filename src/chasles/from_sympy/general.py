"""More general questions: arguments of cosines become symbols, and numbers become symbols with an equation.

cos(x**2), cos(1) and cos(sqrt(k/m)*t) are cosines of some angle, and cos(k*pi/n) is the Chebyshev polynomial T_k of
cos(pi/n). Whatever holds for all values of the symbols holds for these.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from math import lcm
from typing import Any

import sympy

from chasles.checker.expressions.switches import visible_sign
from chasles.from_sympy.constants import is_algebraic
from chasles.from_sympy.divisors import CIRCULAR
from chasles.from_sympy.opening import excerpt, is_atom
from chasles.problems.variables import Untreatable

LARGEST = 90
"""Half a turn is divided into at most so many parts."""


class General:
    """Rewrites the expressions of a question; `meanings` says what the symbols stand for, `facts` what they satisfy.

    `roots` are equations between powers of symbols and numbers, `met` the expressions that symbols stand for, and
    `parts` is n where cos(pi/n) is one.
    """

    def __init__(self, expressions: Iterable[Any]) -> None:
        self.expressions = list(expressions)
        self.meanings: dict[Any, Any] = {}
        self.facts: list[Any] = []
        self.roots: list[tuple[Any, Any]] = []
        self._taken = {str(s) for e in self.expressions for s in e.free_symbols}
        self.parts = self._parts()
        if self.parts:
            self._cosine = self._symbol(sympy.cos(sympy.pi / self.parts))
            self.facts.append(_minimal(self.parts, self._cosine))
        powers = {power for e in self.expressions for power in e.atoms(sympy.Pow)}
        self._rooted = all(map(is_numeric, powers))
        self._known: dict[Any, Any] = {}

    def __call__(self, e: Any) -> Any:
        """The expression in the symbols."""
        if not e.has(*CIRCULAR, sympy.Pow):
            return e
        if e not in self._known:
            self._known[e] = self._written(e)
        return self._known[e]

    def _written(self, e: Any) -> Any:
        if type(e) in CIRCULAR:
            return self._circular(e)
        if is_atom(e):
            return e
        return self._root(e) if self._rooted and is_root_of_number(e) else e.func(*map(self, e.args))

    def _root(self, e: Any) -> Any:
        """A root of a positive number is a symbol, whose power is the number."""
        degree = int(e.exp.q)
        meaning = e.base ** sympy.Rational(1, degree)
        symbol = next((known for known, other in self.meanings.items() if other == meaning), None)
        if symbol is None:
            symbol = self._symbol(meaning, positive=True)
            self.roots.append((symbol**degree, self(e.base)))
        return symbol ** int(e.exp.p)

    @property
    def met(self) -> list[Any]:
        """What symbols stand for that has to be defined."""
        return [meaning for meaning in self.meanings.values() if meaning.free_symbols]

    def alike(self) -> Iterator[tuple[Any, Any, Any]]:
        """Symbols, each with what multiple of an earlier one it seems to be."""
        first: dict[Any, tuple[Any, Any]] = {}
        for symbol, meaning in self.meanings.items():
            multiple, rest = _canonical(meaning).as_coeff_Mul()
            known, other = first.setdefault(rest, (symbol, multiple))
            if known != symbol and meaning.free_symbols and (ratio := multiple / other).is_Rational:
                yield symbol, ratio, known

    def _circular(self, e: Any) -> Any:
        above, below = CIRCULAR[type(e)]
        rest, turn = sympy.S.Zero, sympy.S.Zero
        for term in sympy.Add.make_args(sympy.expand(e.args[0])):
            multiple, factor = term.as_coeff_Mul()
            if factor is sympy.pi:
                turn += multiple
            else:
                rest += multiple * (factor if _is_product(factor) else self._symbol(factor))
        if not self.parts:
            return type(e)(rest + turn * sympy.pi)
        if below and rest != 0:
            raise Untreatable(f"{excerpt(e)} is not treated: what it divides by would be lost")
        parts = {"": sympy.S.One, "cos": self._turned(rest, turn), "sin": self._turned(rest, turn - sympy.S.Half)}
        return parts[above] / parts[below]

    def _turned(self, rest: Any, turn: Any) -> Any:
        """cos(rest + turn pi)."""
        if not self.parts:
            return sympy.cos(rest + turn * sympy.pi)
        cosine, sine = (
            sympy.chebyshevt(int(k * self.parts) % (2 * self.parts), self._cosine) for k in (turn, turn - sympy.S.Half)
        )
        return cosine if rest == 0 else sympy.cos(rest) * cosine - sympy.sin(rest) * sine

    def _parts(self) -> int:
        """Into how many parts half a turn is to be divided; 0 if SymPy writes all cosines in roots."""
        calls = {call for e in self.expressions for call in e.atoms(*CIRCULAR)}
        turns = {_turn(call.args[0]) for call in calls}
        if all(map(_in_roots, turns)):
            return 0
        parts = lcm(*(part.denominator for turn in turns for part in (turn, turn - Fraction(1, 2))))
        if parts > LARGEST:
            raise Untreatable(f"angles that are multiples of pi/{parts} are not treated: of pi/{LARGEST} at the least")
        return parts

    def _symbol(self, meaning: Any, **assumed: bool) -> Any:
        name = (
            f"({meaning})"
            if isinstance(meaning, sympy.Function) and not isinstance(meaning, sympy.cos)
            else str(meaning)
        )
        symbol = sympy.Symbol(name, real=True, **assumed)
        if name in self._taken:
            raise Untreatable(f"a symbol is called as {excerpt(meaning)} is written: rename it")
        self.meanings[symbol] = meaning
        return symbol


def is_numeric(power: Any) -> bool:
    """Whether a power is a square root, one with a whole exponent, or one of a number."""
    return bool(power.exp.is_Rational) and (power.exp.q <= 2 or not power.base.free_symbols)


def is_root_of_number(e: Any) -> bool:
    """Whether an expression is a power of a positive number that is more than square roots of numbers."""
    if not (isinstance(e, sympy.Pow) and e.exp.is_Rational and e.exp.q > 1 and is_algebraic(e.base)):
        return False
    return any(part.exp.q > 2 for part in e.atoms(sympy.Pow)) and visible_sign(e.base) == 1


def _canonical(e: Any) -> Any:
    """The expression as a fraction of products, and radicands as well."""
    roots = {p: sympy.factor(p.base) ** p.exp for p in e.atoms(sympy.Pow) if p.exp.is_Rational and p.exp.q > 1}
    return sympy.factor(e.xreplace(roots))


def _is_product(e: Any) -> bool:
    powers = e.as_powers_dict()
    return all(is_atom(base) and power.is_Integer and power.is_positive for base, power in powers.items()) and e != 1


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
