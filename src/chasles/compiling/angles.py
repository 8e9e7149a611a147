"""Which functions are there in an expression, of which angles, what is divided by; and does a polynomial vanish?"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from functools import lru_cache, reduce
from itertools import islice
from random import Random
from typing import Any

import sympy
from sympy.codegen.cfunctions import log1p

from chasles.compiling.sharing import parts_before
from chasles.compiling.taylor import ANALYTIC

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
KEPT = 2**15
"""Parts of which it is known what they are: expressions share them, and each is met many times."""


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
