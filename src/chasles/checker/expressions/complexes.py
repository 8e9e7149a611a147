"""Complex expressions by their real and imaginary parts, all quantities being real; nothing imaginary is dropped."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import reduce
from typing import TYPE_CHECKING, Any

import sympy

from chasles.checker.expressions.quantities import is_atom
from chasles.checker.sparse import ZERO, Polynomial, Rejected

if TYPE_CHECKING:
    from chasles.checker.expressions.expressions import Expressions

BY_SIGN = (sympy.Max, sympy.Min, sympy.Heaviside, sympy.sign, sympy.Abs)
OF_COMPLEX = (type(sympy.I), sympy.re, sympy.im, sympy.conjugate, sympy.arg)
LARGEST_EXPONENT = 32
Pair = tuple[Any, Any]
Place = tuple[int, int]
QUOTIENTS: Mapping[type, Callable[[Any], Any]] = {
    sympy.tan: lambda z: sympy.sin(z) / sympy.cos(z), sympy.cot: lambda z: sympy.cos(z) / sympy.sin(z),
    sympy.sec: lambda z: 1 / sympy.cos(z), sympy.csc: lambda z: 1 / sympy.sin(z),
    sympy.tanh: lambda z: sympy.sinh(z) / sympy.cosh(z), sympy.coth: lambda z: sympy.cosh(z) / sympy.sinh(z),
    sympy.sech: lambda z: 1 / sympy.cosh(z), sympy.csch: lambda z: 1 / sympy.sinh(z),
}  # fmt: skip
INVERSES = (sympy.asin, sympy.acos, sympy.asec, sympy.acsc, sympy.acosh, sympy.atanh, sympy.asech, sympy.acoth)
PARTIAL = (*QUOTIENTS, *INVERSES, sympy.log, sympy.gamma, sympy.factorial, sympy.Mod)


class Parts:
    """Takes expressions apart into a real and an imaginary part.

    `met` are the real expressions that came up on the way: what they divide by and where their roots are real counts,
    also where the part that they are in is not asked for.
    """

    def __init__(self) -> None:
        self.met: dict[Any, None] = {}
        self._known: dict[Any, Pair] = {}

    def sides(self, left: Sequence[Any], right: Sequence[Any]) -> list[list[Any]]:
        """Two sides that are equal where the given ones are: imaginary parts, if there are any, come after all real."""
        parts = [list(map(self.of, side)) for side in (left, right)]
        count = 2 if any(im != 0 for side in parts for _, im in side) else 1
        return [[pair[k] for k in range(count) for pair in side] for side in parts]

    def pairs(self, one: Any, other: Any) -> list[Pair]:
        """The equations between real expressions that an equation says."""
        (a, b), (c, d) = self.of(one), self.of(other)
        return [(a, c)] if b == d == 0 else [(a, c), (b, d)]

    def nonzero(self, expression: Any) -> Any:
        """A real expression that vanishes where the given one does."""
        a, b = self.of(expression)
        return a if b == 0 else a**2 + b**2

    def of(self, expression: Any) -> Pair:
        """The parts of what is read as a whole: if it is real, nothing of it is dropped."""
        if expression.has(*OF_COMPLEX):
            return self(expression)
        if expression.has(*BY_SIGN) and expression.has(*PARTIAL):
            # A sign may be known without the functions in it that have no value everywhere.
            plain = expression.replace(lambda part: isinstance(part, sympy.Piecewise), lambda _: sympy.S.Zero)
            found = {f for part in plain.atoms(*BY_SIGN) for f in part.atoms(*PARTIAL) if f.free_symbols}
            self.met |= dict.fromkeys(sorted(found, key=str))
        return expression, sympy.S.Zero

    def __call__(self, expression: Any) -> Pair:
        """The two parts; raises `Rejected` for functions of complex numbers that are not taken apart."""
        if expression not in self._known:
            self._known[expression] = self._split(expression)
        return self._known[expression]

    def _split(self, e: Any) -> Pair:
        if e is sympy.I:
            return sympy.S.Zero, sympy.S.One
        if is_atom(e) or not e.has(*OF_COMPLEX):
            self.met |= {e: None} if isinstance(e, sympy.Expr) else {}
            return e, sympy.S.Zero
        if isinstance(e, sympy.Pow):
            return self._power(e)
        if isinstance(e, sympy.Add | sympy.Mul):
            return reduce(_plus if isinstance(e, sympy.Add) else _times, map(self, e.args))
        if isinstance(e, sympy.Abs) and e.args[0].is_Mul:
            return reduce(_times, (self(sympy.Abs(factor)) for factor in e.args[0].args))
        if isinstance(e, sympy.Derivative):
            re, im = self(e.expr)
            return re.diff(*e.variables), im.diff(*e.variables)
        if e.func in QUOTIENTS:
            return self(QUOTIENTS[e.func](*e.args))
        rule, parts = RULES.get(e.func), [self(argument) for argument in e.args]
        if rule is not None and len(parts) == 1:
            return rule(*parts[0])
        whole = e.func(*(re for re, _ in parts)) if rule is None and all(im == 0 for _, im in parts) else e
        if not whole.has(*OF_COMPLEX):
            return self(whole)
        raise Rejected(f"{e} is not treated: {e.func.__name__} of complex numbers is not")

    def _power(self, e: Any) -> Pair:
        """An integral power; one of a real number may have any exponent."""
        (re, im), exponent = self(e.base), e.exp
        if e.base is sympy.E:
            return RULES[sympy.exp](*self(exponent))
        if im == 0:
            real, turn = self(exponent)
            if turn == 0 and not (whole := re**real).has(*OF_COMPLEX):
                return self(whole)
        if im == 0 or not exponent.is_Integer or abs(exponent) > LARGEST_EXPONENT:
            raise Rejected(f"{e} is not treated: of complex numbers only small integral powers are")
        if exponent < 0:
            square = re**2 + im**2
            re, im = re / square, -im / square
            self.met |= {re: None, im: None}
        n = abs(int(exponent))
        terms = [sympy.binomial(n, k) * re ** (n - k) * im**k * (-1) ** (k // 2) for k in range(n + 1)]
        return sympy.Add(*terms[::2]), sympy.Add(*terms[1::2])


def _tidy(im: Any) -> Any:
    """An imaginary part that vanishes as a polynomial is seen to be zero."""
    return sympy.S.Zero if im.is_Add and sympy.expand(im) == 0 else im


def _plus(one: Pair, other: Pair) -> Pair:
    return one[0] + other[0], _tidy(one[1] + other[1])


def _times(one: Pair, other: Pair) -> Pair:
    (a, b), (c, d) = one, other
    return a * c - b * d, _tidy(a * d + b * c)


# With z = a + b I; Abramowitz and Stegun, Handbook of Mathematical Functions, 4.2.35, 4.3.55, 4.3.56, 4.5.49, 4.5.50.
RULES: Mapping[type, Callable[[Any, Any], Pair]] = {
    sympy.re: lambda a, b: (a, sympy.S.Zero), sympy.im: lambda a, b: (b, sympy.S.Zero),
    sympy.conjugate: lambda a, b: (a, -b), sympy.arg: lambda a, b: (sympy.atan2(b, a), sympy.S.Zero),
    sympy.Abs: lambda a, b: (sympy.Abs(a) if b == 0 else sympy.sqrt(a**2 + b**2), sympy.S.Zero),
    sympy.exp: lambda a, b: (sympy.exp(a) * sympy.cos(b), sympy.exp(a) * sympy.sin(b)),
    sympy.sin: lambda a, b: (sympy.sin(a) * sympy.cosh(b), sympy.cos(a) * sympy.sinh(b)),
    sympy.cos: lambda a, b: (sympy.cos(a) * sympy.cosh(b), -sympy.sin(a) * sympy.sinh(b)),
    sympy.sinh: lambda a, b: (sympy.sinh(a) * sympy.cos(b), sympy.cosh(a) * sympy.sin(b)),
    sympy.cosh: lambda a, b: (sympy.cosh(a) * sympy.cos(b), sympy.sinh(a) * sympy.sin(b)),
}  # fmt: skip


def parts(reading: Expressions, e: Any) -> tuple[Polynomial, Polynomial]:
    """The two parts as they are read; raises `Rejected` for functions of complex numbers that are not taken apart."""
    if not e.has(*OF_COMPLEX):
        return reading(e), ZERO
    split = Parts()
    real, imaginary = split(e)
    for each in split.met:
        reading(each)
    return reading(real), reading(imaginary)


def differences(reading: Expressions, pairs: Mapping[Place, tuple[Any, Any]]) -> dict[Place, Polynomial]:
    """What vanishes where the sides of each pair are equal; imaginary parts, if there are any, are further rows."""
    rows = 1 + max((row for row, _ in pairs), default=0)
    found: dict[Place, Polynomial] = {}
    for (row, column), (left, right) in pairs.items():
        (a, b), (c, d) = parts(reading, left), parts(reading, right)
        found[row, column] = a - c
        if b or d:
            found[row + rows, column] = b - d
    return found
