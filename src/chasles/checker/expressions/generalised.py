"""A more general question: symbols in the place of what is no plain angle, of numbers, and of values of functions.

cos(x**2), cos(1) and cos(sqrt(k/m)*t) are cosines of some angle, cos(k*pi/n) is the Chebyshev polynomial T_k of
cos(pi/n), and floor(x) is some integer. Whatever holds for all values of the symbols holds for these.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import sympy

from chasles.checker.expressions.defined_functions import VALUED, Recurrences, defined_by, is_entire
from chasles.checker.expressions.enclosed import sign_of_number
from chasles.checker.expressions.quantities import is_atom
from chasles.checker.expressions.readings import CIRCULAR, MOST_PARTS
from chasles.checker.expressions.visible import assumed_of
from chasles.checker.sparse import Rejected


class Generalised:
    """Rewrites expressions; `symbols` says what has one, `roots` are equations between powers of symbols and numbers.

    Half a turn has so many `parts`, where the cosine of one has a symbol. No name that is `taken` is given.
    """

    def __init__(self, expressions: Sequence[Any], parts: int, taken: set[str]) -> None:
        if parts > MOST_PARTS:
            raise Rejected(f"half a turn is divided into {parts} parts, more than {MOST_PARTS}")
        self.parts, self.taken = parts, taken
        self.symbols: dict[Any, Any] = {}
        self.roots: list[tuple[Any, Any]] = []
        self.multiple = Recurrences(expressions)
        self.finite: dict[Any, None] = {}
        self.rooted = all(is_numeric(power) for e in expressions for power in e.atoms(sympy.Pow))
        if parts:
            self.cosine = self._symbol(sympy.cos(sympy.pi / parts))

    @property
    def met(self) -> list[Any]:
        """What has to be defined for the symbols to stand for something."""
        return [*(e for known in self.symbols for e in defined_by(known) or (known,) if e.free_symbols), *self.finite]

    def __call__(self, e: Any) -> Any:
        """The expression in the symbols; raises `Rejected` where something that is divided by would be lost."""
        if is_atom(e) or not e.args or not e.has(*CIRCULAR, *VALUED, sympy.Pow):
            return e
        if self.rooted and is_root_of_number(e):
            return self._root(e.base, int(e.exp.q)) ** int(e.exp.p)
        if is_entire(e):
            factor, quantity, _ = self.multiple(e.base)
            return (self(1 / factor) * self._symbol(quantity, **assumed_of(quantity))) ** -e.exp
        if isinstance(e, VALUED):
            self.finite |= dict.fromkeys([e] if isinstance(e, sympy.gamma) and e.free_symbols else ())
            factor, quantity, power = self.multiple(e)
            if not defined_by(quantity):
                # SymPy takes integers out of an argument that is written out.
                return self(quantity)
            return self(factor) * self._symbol(quantity, **assumed_of(quantity)) ** power
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
        plain = isinstance(e, sympy.cos) or not isinstance(e, sympy.Function | sympy.Number)
        return self.symbols.setdefault(e, sympy.Symbol(str(e) if plain else f"({e})", real=True, **assumed))

    def _root(self, base: Any, degree: int) -> Any:
        """The positive root of a positive number, whose power is known."""
        root = base ** sympy.Rational(1, degree)
        if root not in self.symbols:
            self.roots.append((self._symbol(root, positive=True) ** degree, self(base)))
        return self.symbols[root]


def _is_angle(e: Any) -> bool:
    """Whether an expression is a product of quantities."""
    return e != 1 and all(is_atom(base) and n.is_Integer and n > 0 for base, n in e.as_powers_dict().items())


def is_numeric(power: Any) -> bool:
    """Whether a power is a square root, one with a whole exponent, or one of a number."""
    return bool(power.exp.is_Rational) and (power.exp.q <= 2 or not power.base.free_symbols)


def is_root_of_number(e: Any) -> bool:
    """Whether an expression is a power of a positive number that is more than square roots of numbers."""
    return bool(
        e.is_Pow and e.exp.is_Rational and e.exp.q > 1 and not e.has(sympy.Symbol, sympy.Function, sympy.NumberSymbol)
        and any(part.exp.q > 2 for part in e.atoms(sympy.Pow) if part.exp.is_Rational) and sign_of_number(e.base) == 1
    )  # fmt: skip
