"""Which functions are there in an expression, of which angles, what is divided by; and does a polynomial vanish?

An angle that is a product, a power or a sum is one symbol: SymPy spreads its powers and terms among others.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from functools import lru_cache, reduce
from itertools import islice
from math import floor
from random import Random
from typing import Any

import sympy
from sympy.codegen.cfunctions import log1p

from chasles.compiling.sharing import parts_before
from chasles.compiling.taylor import ANALYTIC
from chasles.compiling.variables import Substitution

QUOTIENTS: Mapping[Any, Callable[[Any], Any]] = {
    sympy.tan: lambda a: sympy.sin(a) / sympy.cos(a),
    sympy.cot: lambda a: sympy.cos(a) / sympy.sin(a),
    sympy.sec: lambda a: 1 / sympy.cos(a),
    sympy.csc: lambda a: 1 / sympy.sin(a),
    sympy.coth: lambda a: 1 / sympy.tanh(a),
    sympy.sech: lambda a: 1 / sympy.cosh(a),
    sympy.csch: lambda a: 1 / sympy.sinh(a),
}
"""What these are in others."""
KNOWN = (*ANALYTIC, *QUOTIENTS, sympy.log, sympy.atan2)
_PRIME = 2**61 - 1
_SEEDS = 64
"""So many points are tried; at half of them a root has a value."""
_POINTS = 8
MOST_PARTS = 80
"""Larger quotients and sums stay as they are."""
KEPT = 2**15
"""Parts of which it is known what they are: expressions share them, and each is met many times."""
ANGLE, ROOT = (sympy.Dummy(name, dummy_index=k, real=True) for k, name in enumerate(("angle", "root")))
"""The symbol in place of the angle meanwhile, and that for one that is a multiple of a root."""


def parts_of(expression: sympy.Basic, others: Collection[sympy.Basic]) -> dict[sympy.Basic, None]:
    """The different parts of an expression, as they come, without the others and what is in them.

    SymPy's own ways to look for parts take a time that grows with the tree, in which what is shared occurs many times.
    """
    found: dict[sympy.Basic, None] = {}
    waiting = [expression]
    while waiting:
        part = waiting.pop()
        if part not in found and part not in others:
            found[part] = None
            waiting += part.args
    return found


@lru_cache(KEPT)
def parts_of_kinds(expression: sympy.Basic, kinds: tuple[Any, ...], outside: tuple[Any, ...] = ()) -> frozenset[Any]:
    """The different parts of these kinds, those in such parts too, but none in parts of the kinds outside."""
    if isinstance(expression, outside):
        return frozenset()
    own = frozenset([expression] if isinstance(expression, kinds) else [])
    return own.union(*(parts_of_kinds(part, kinds, outside) for part in expression.args))


@lru_cache(KEPT)
def size_of(expression: Any) -> int:
    """How many parts it has, each as often as it occurs."""
    return 1 + sum(map(size_of, expression.args))


def divisors(parts: Iterable[sympy.Basic]) -> set[sympy.Expr]:
    """What the parts that are quotients divide by."""
    return {part.base for part in parts if isinstance(part, sympy.Pow) and part.exp.is_number and part.exp.is_negative}


def angle_of(function: Any) -> sympy.Expr:
    """The angle of which, times a number, a function is taken; of a logarithm what is added to 1, in parts of it."""
    return with_series(function).args[0].as_coeff_Mul()[1]


def with_series(function: Any) -> Any:
    """The function, or else one that has a series where the angle is zero; an arctangent in the right half-plane."""
    match function:
        case sympy.log():
            above, below = sympy.fraction(function.args[0])
            return log1p(sympy.Mul(above - below, 1 / below))
        case sympy.atan2(args=(y, x)) if not (slope := sympy.Mul(y, 1 / x)).is_number:
            return sympy.atan(slope)
    return function


def square_of(angle: sympy.Expr) -> sympy.Expr:
    """What an angle is the root of; its square, if it is no root."""
    return (
        angle.base
        if isinstance(angle, sympy.Pow) and angle.exp == sympy.S.Half
        else sympy.Pow(angle, 2, evaluate=not angle.is_Add)
    )


@lru_cache(KEPT)
def vanishes(left: Any) -> bool:
    """Whether it is zero modulo a prime at points where symbols and functions have random values (Schwartz, 1980)."""
    residues = (_residue(left, Random(seed)) for seed in range(_SEEDS))
    known = (residue for residue in residues if residue is not None)
    return next(known, 1) == 0 and not any(islice(known, _POINTS))


def _residue(expression: Any, draw: Random) -> int | None:
    """The value modulo the prime, with one of both values of a root; None where a root or a reciprocal has none."""
    known: dict[sympy.Basic, int] = {}

    def of(part: Any) -> int:
        if part not in known:
            above, below = sympy.Rational(part).as_numer_denom() if part.is_Rational or part.is_Float else (0, 0)
            known[part] = int(above) * pow(int(below), -1, _PRIME) if below else draw.randrange(_PRIME)
        return known[part]

    for part in parts_before([expression]):
        match part:
            case sympy.Add():
                known[part] = sum(map(of, part.args)) % _PRIME
            case sympy.Mul():
                known[part] = reduce(lambda product, each: product * of(each) % _PRIME, part.args, 1)
            case sympy.Pow(args=(base, sympy.Rational() as exponent)) if exponent.q < 3:
                root = of(base)
                if exponent.q == 2:
                    root = pow(root, (_PRIME + 1) // 4, _PRIME) * draw.choice((1, -1))
                if (root**exponent.q - of(base)) % _PRIME or (exponent < 0 and root == 0):
                    return None
                known[part] = pow(root, int(exponent.p), _PRIME)
    return of(expression)


class WholeAngle:
    """Expressions in a symbol for an angle: (a b)^-2 is a^-2 b^-2 to SymPy, and a - b - sin(a - b) has three terms."""

    def __init__(self, angle: sympy.Expr) -> None:
        self._angle = angle.primitive()[1]
        factors = sympy.Mul.make_args(self._angle)
        self._number = sympy.Mul(*(factor for factor in factors if factor.is_number))
        self._powers = dict(factor.as_base_exp() for factor in factors if not factor.is_number)
        self._terms = self._angle.as_coefficients_dict() if angle.is_Add else {}
        self.symbol = ROOT if sympy.S.Half in self._powers.values() else ANGLE
        self._done: dict[sympy.Basic, sympy.Basic] = {self._angle: self.symbol}
        self._back = Substitution({self.symbol: self._angle})

    def occurs_in(self, parts: Iterable[sympy.Basic]) -> bool:
        """Whether one of them is zero where the angle is, as far as it is seen."""
        if self._terms:
            return any(part.is_Add and self._sum(part) != part for part in parts)
        known = all(exponent.is_Rational for exponent in self._powers.values())
        return known and any(self._powers.get(part, sympy.S.Zero) > 0 for part in parts)

    def of(self, expression: sympy.Basic) -> sympy.Basic:
        """The expression, in which the angle is a symbol where it occurs as a whole."""
        found = self._done.get(expression)
        if found is None:
            parts = [self.of(part) for part in expression.args]
            found = expression.func(*parts) if parts != list(expression.args) else expression
            if isinstance(found, sympy.Mul | sympy.Pow) and not self._terms:
                found = self._product(found)
            elif isinstance(found, sympy.Add) and self._terms:
                found = self._sum(found)
            self._done[expression] = found
        return found

    def back(self, expression: sympy.Basic) -> sympy.Basic:
        """The expression with the angle again."""
        return self._back.of(expression)

    def _product(self, product: sympy.Expr) -> sympy.Expr:
        """With the powers of the angle that it is divided by, or else those that are in it."""
        powers = dict(factor.as_base_exp() for factor in sympy.Mul.make_args(product))
        exponents = [(powers.get(base, sympy.S.Zero), exponent) for base, exponent in self._powers.items()]
        if not all(exponent.is_Rational for exponent, _ in exponents):
            return product
        # Where the angle vanishes one of these does.
        power = min((floor(exponent / whole) for exponent, whole in exponents if whole > 0), default=0)
        others = [base ** (-power * exponent) for base, exponent in self._powers.items()]
        return sympy.Mul(product, (self.symbol / self._number) ** power, *others) if power else product

    def _sum(self, total: sympy.Expr) -> sympy.Expr:
        """With the multiple of the angle whose terms are all in it."""
        terms = total.as_coefficients_dict()
        multiples = {terms.get(term, sympy.S.Zero) / number for term, number in self._terms.items()}
        if len(multiples) > 1 or 0 in multiples:
            return total
        [multiple] = multiples
        rest = [number * term for term, number in terms.items() if term not in self._terms]
        return sympy.Add(multiple * self.symbol, *rest)
