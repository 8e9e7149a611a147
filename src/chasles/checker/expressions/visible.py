"""The signs that an expression is seen to have, whatever its symbols are; what is seen of values of functions.

Of SymPy's assumptions those on symbols are believed, and none that it makes of what is composed of them: for SymPy
(1.14) a third of an even number is not zero, a sixth is an integer, and atan(n) has a sign where n may be zero.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from functools import cache, lru_cache
from typing import Any

import sympy

from chasles.checker.expressions.complexes import OF_COMPLEX
from chasles.checker.expressions.quantities import NUMBERS, SIGNS, atoms_of, is_atom, is_unreal, require_real
from chasles.checker.expressions.readings import Floor
from chasles.checker.expressions.signs import SignedReading, is_nonnegative, is_positive, may_vanish
from chasles.checker.sparse import Rejected, limited

MOST_PRODUCTS = 10_000
ALWAYS = {
    **dict.fromkeys((sympy.exp, sympy.cosh), "positive"), Floor: "integer",
    **dict.fromkeys((sympy.Abs, sympy.acosh, sympy.asech), "nonnegative"),
    **dict.fromkeys((sympy.sin, sympy.cos, sympy.Max, sympy.Min), "real"),
}  # fmt: skip
"""What values at real arguments are."""
INHERITED = {
    Floor: ("nonnegative",), sympy.Abs: ("nonzero",), **dict.fromkeys((sympy.gamma, sympy.acosh), ("positive",)),
    **dict.fromkeys((sympy.sinh, sympy.tanh, sympy.asinh, sympy.atan, sympy.erf, sympy.log), tuple(SIGNS)),
}  # fmt: skip
"""And what they are where their arguments are so; some, where it is so of one less."""
LEAST = {"composite": 4, "prime": 2, "positive": 1, "negative": 1, "nonnegative": 0, "nonpositive": 0}
"""The least size of an integer of which this is so."""


def _part(e: Any, **kinds: bool) -> Any:
    """What is less than one, and not negative."""
    return _symbol(e, **kinds) / (1 + _symbol(e, **kinds))


@lru_cache(maxsize=4096)
def _symbol(_: Any, **kinds: bool) -> Any:
    """The same for the same value."""
    return sympy.Dummy(**{**kinds, "real": True})


BOUNDS: Mapping[type, Callable[[Any], Any]] = {
    **dict.fromkeys((sympy.tanh, sympy.erf), lambda e: 2 * _part(e, positive=True) - 1),
    sympy.atan: lambda e: sympy.pi * _part(e, positive=True) - sympy.pi / 2,
    sympy.asin: lambda e: sympy.pi / 2 * sympy.cos(_symbol(e)), sympy.atan2: lambda e: sympy.pi * sympy.cos(_symbol(e)),
    sympy.acos: lambda e: sympy.pi / 2 * (1 + sympy.cos(_symbol(e))),
    Floor: lambda e: _bounded(e.args[0]) - _part(e, nonnegative=True),
    **dict.fromkeys((sympy.sin, sympy.cos), lambda e: e.func(_bounded(e.args[0]))),
}  # fmt: skip
"""Between what values are: parts of a whole, and cosines of some angle."""


@lru_cache(maxsize=4096)
def signs_of(e: Any) -> frozenset[int]:
    """The signs that the values of an expression may have, where it has real ones."""
    found = frozenset((-1, 0, 1))
    for write in (_without_calls, _bounded) if e.has(*BOUNDS) else (_without_calls,):
        with suppress(Rejected), limited(MOST_PRODUCTS):  # what is remembered takes no part of what is left to others
            found &= frozenset(_signs(SignedReading({}, {}), e, write))
    return found


def _signs(reading: SignedReading, e: Any, write: Callable[[Any], Any]) -> Iterator[int]:
    for atom in atoms_of(e):
        require_real(atom)
    if e.has(*OF_COMPLEX):
        raise Rejected(f"{e} is not seen to be real")
    value = reading.normal(reading(write(e)))
    numerator, below = reading.cleared(value)
    value = numerator if all(is_positive(reading, reading.inverses[place]) for place in below) else value
    if value and not is_nonnegative(reading, -value):
        yield 1
    if value and not is_nonnegative(reading, value):
        yield -1
    if may_vanish(reading, reading.cleared(value)[0]):
        yield 0


def kinds_of(signs: frozenset[int], kinds: Iterable[str] = ("positive", "nonnegative")) -> dict[str, bool]:
    """Those of the kinds that say no more of a number than that it has one of the signs."""
    return {kind: True for kind in kinds if signs <= {*SIGNS[kind]}}


def is_running(index: Any, ends: Iterable[Any], kind: str = "integer") -> bool:
    """Whether what is assumed of an index excludes no number of a kind that has the sign of an end, but maybe zero."""
    signs = signs_of(index)
    plain = sympy.Dummy(**{kind: True}, **kinds_of(signs, SIGNS))
    same = (getattr(index, f"is_{each}") in (None, getattr(plain, f"is_{each}")) for each in NUMBERS)
    return not is_unreal(index) and all(same) and all(signs_of(end) <= signs | {0} for end in ends)


def assumed_of(e: Any) -> dict[str, bool]:
    """What is known of the value of a function at real arguments, or of one over it."""
    call = 1 / e if e.is_Pow else e
    least = int(isinstance(call, sympy.log | sympy.acosh))
    known = kinds_of(signs_of(call.args[0] - least), INHERITED.get(call.func, ()))
    return known | {ALWAYS[call.func]: True} if call.func in ALWAYS else known


def _bounded(e: Any) -> Any:
    """The same with what values are between in place of their symbols."""
    return BOUNDS[e.func](e) if e.func in BOUNDS else _without_calls(e, _bounded)


def _without_calls(e: Any, write: Callable[[Any], Any] | None = None) -> Any:
    """The expression with a symbol for each call, and integers by others that are not negative."""
    if is_atom(e) or not e.args:
        return _counted(e) if e.is_Symbol else e
    if isinstance(e, sympy.Add | sympy.Mul) or (e.is_Pow and e.exp.is_Rational and not e.exp.q & (e.exp.q - 1)):
        return e.func(*map(write or _without_calls, e.args))
    if e.is_Pow:
        return _symbol(e, **kinds_of(signs_of(e.base)))
    if e.func not in ALWAYS | INHERITED or (isinstance(e, sympy.log | sympy.gamma) and signs_of(e.args[0]) != {1}):
        return _symbol(e)
    return _symbol(e, **assumed_of(e))


@cache
def _counted(symbol: Any) -> Any:
    """An integer as a multiple of another, which is not negative if its sign is known, and a number."""
    if not symbol.is_integer:
        return symbol
    step, rest = 2 if symbol.is_even or symbol.is_odd else 1, int(bool(symbol.is_odd))
    least = [n for kind, n in LEAST.items() if getattr(symbol, f"is_{kind}")]
    if not least:
        return step * sympy.Dummy(integer=True) + rest
    number = step * sympy.Dummy(integer=True, nonnegative=True) + least[0] + (least[0] - rest) % step
    return -number if symbol.is_nonpositive else number
