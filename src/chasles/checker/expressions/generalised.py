"""A more general question, for the checker: symbols in the place of what is no plain angle, and of numbers.

What stands in the arguments of cosines and sines is a symbol, and so are cos(pi/n) and roots of numbers.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import sympy

from chasles.checker.expressions.enclosed import sign_of_number
from chasles.checker.expressions.quantities import is_atom
from chasles.checker.expressions.readings import CIRCULAR
from chasles.checker.sparse import Rejected


class Generalised:
    """Puts symbols in the place of what is no plain angle, and of the cosine of a part of half a turn."""

    def __init__(self, parts: int, taken: set[str]) -> None:
        self.parts, self.taken = parts, taken
        self.symbols: dict[Any, Any] = {}
        self.roots: list[tuple[Any, Any]] = []
        if parts:
            self.cosine = self._symbol(sympy.cos(sympy.pi / parts))

    @property
    def met(self) -> list[Any]:
        """What the symbols stand for, as far as it has to be defined."""
        return [e for e in self.symbols if e.free_symbols]

    def __call__(self, e: Any) -> Any:
        if is_atom(e) or not e.args:
            return e
        if _is_root_of_number(e):
            return self._root(e.base, int(e.exp.q)) ** int(e.exp.p)
        if type(e) not in CIRCULAR:
            return e.func(*map(self, e.args))
        rest, turn = sympy.S.Zero, Fraction(0)
        for term in sympy.Add.make_args(sympy.expand(e.args[0])):
            multiple, factor = term.as_coeff_Mul()
            if factor is sympy.pi:
                turn += Fraction(int(multiple.p), int(multiple.q))
            else:
                rest += multiple * (factor if _is_angle(factor) else self._symbol(factor))
        if not self.parts:
            return type(e)(rest + sympy.Rational(turn.numerator, turn.denominator) * sympy.pi)
        above, below = (self._turned(name, rest, turn) for name in CIRCULAR[type(e)])
        if rest != 0 and CIRCULAR[type(e)][1]:
            raise Rejected(f"what {e} divides by is not seen any more")
        return above / below

    def _turned(self, name: str, rest: Any, turn: Fraction) -> Any:
        if not name:
            return sympy.S.One
        turn = turn if name == "cos" else turn - Fraction(1, 2)
        c, s = self._chebyshev(turn), self._chebyshev(turn - Fraction(1, 2))
        return c if rest == 0 else sympy.cos(rest) * c - sympy.sin(rest) * s

    def _chebyshev(self, turn: Fraction) -> Any:
        """cos(k t) is 2 cos(t) cos((k - 1) t) - cos((k - 2) t)."""
        count = turn * self.parts
        if count.denominator != 1:
            raise Rejected(f"{turn} pi is no multiple of pi/{self.parts}")
        before, value = self.cosine, sympy.S.One
        for _ in range(int(count) % (2 * self.parts)):
            before, value = value, sympy.expand(2 * self.cosine * value - before)
        return value

    def _symbol(self, e: Any, **assumed: bool) -> Any:
        if str(e) in self.taken:
            raise Rejected(f"a symbol is called {e}, as something else is written")
        name = f"({e})" if isinstance(e, sympy.Function) and not isinstance(e, sympy.cos) else str(e)
        return self.symbols.setdefault(e, sympy.Symbol(name, real=True, **assumed))

    def _root(self, base: Any, degree: int) -> Any:
        """The positive root of a positive number, whose power is known."""
        root = base ** sympy.Rational(1, degree)
        if root not in self.symbols:
            if sign_of_number(base) != 1:
                raise Rejected(f"{base} is not seen to be positive")
            self.roots.append((self._symbol(root, positive=True) ** degree, self(base)))
        return self.symbols[root]


def _is_angle(e: Any) -> bool:
    """Whether an expression is a product of quantities."""
    return e != 1 and all(is_atom(base) and n.is_Integer and n > 0 for base, n in e.as_powers_dict().items())


def _is_root_of_number(e: Any) -> bool:
    """Whether an expression is a power of a number that is more than square roots of numbers."""
    return bool(
        e.is_Pow and e.exp.is_Rational and e.exp.q > 1 and not e.free_symbols and not e.has(sympy.cos, sympy.pi)
        and any(part.exp.q > 2 for part in e.atoms(sympy.Pow) if part.exp.is_Rational)
    )  # fmt: skip
