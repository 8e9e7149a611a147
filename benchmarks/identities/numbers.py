"""What numbers say of a pair of sides: 30 digits at a few real points that respect what is assumed of the symbols."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random
from typing import Any

import sympy
from benchmarks.identities.pairs import Pair, read, text_of

__all__ = ["agreement", "changed", "falsified"]

POINTS = 4
DIGITS = 30
NEAR = sympy.Float("1e-20")


def _value(symbol: Any, random: Random) -> Any:
    """A value that fits what SymPy assumes of the symbol."""
    if symbol.is_integer:
        size = sympy.Integer(random.randint(1, 5))
        size = 2 * size if symbol.is_even else 2 * size - 1 if symbol.is_odd else size
    else:
        size = sympy.Rational(random.randint(1, 40), random.choice((7, 11, 13)))
    if symbol.is_zero:
        return sympy.S.Zero
    if symbol.is_negative or (symbol.is_nonpositive and not symbol.is_nonnegative):
        return -size
    return size if symbol.is_nonnegative else size * random.choice((1, -1))


def _entries(side: Any) -> list[Any]:
    if isinstance(side, sympy.MatrixExpr):
        side = side.doit().as_explicit()
    return list(side) if isinstance(side, sympy.MatrixBase) else [side]


def _drawn(symbol: Any, random: Random) -> Any:
    """A value of a symbol; of a matrix symbol, a matrix."""
    if isinstance(symbol, sympy.MatrixSymbol):
        rows, columns = map(int, symbol.shape)
        entries = [sympy.Rational(random.randint(-20, 20), 7) for _ in range(rows * columns)]
        return sympy.ImmutableMatrix(rows, columns, entries)
    return _value(symbol, random)


def values_of(left: Any, right: Any) -> Iterator[tuple[Any, Any]]:
    """Numbers of both sides, entry by entry, at one point after the other."""
    symbols = sorted(left.free_symbols | right.free_symbols, key=str)
    for seed in range(POINTS):
        random = Random(seed)
        point = {symbol: _drawn(symbol, random) for symbol in symbols}
        sides = [_entries(side.xreplace(point).doit()) for side in (left, right)]
        for one, other in zip(*sides, strict=True):
            try:
                yield sympy.N(one.doit(), DIGITS), sympy.N(other.doit(), DIGITS)
            except (ZeroDivisionError, TypeError, ValueError):
                continue


def agreement(left: Any, right: Any) -> str:
    """Whether the sides are `equal`, `different`, equal with values that are not real (`complex`), or `unclear`."""
    found = real = False
    for one, other in values_of(left, right):
        if not (one.is_number and other.is_number and one.is_finite and other.is_finite):
            continue
        found = True
        if abs(sympy.N(one - other, DIGITS)) > NEAR * (1 + abs(one)):
            return "different"
        real = real or abs(sympy.im(one)) + abs(sympy.im(other)) < NEAR
    return ("equal" if real else "complex") if found else "unclear"


def _changes(right: Any) -> Iterator[Any]:
    """Slips of the right side: a sign, a factor, an exponent."""
    if isinstance(right, sympy.MatrixExpr):
        yield 2 * right
        return
    entries = list(right) if isinstance(right, sympy.MatrixBase) else None
    if entries is not None:
        for change in _changes(entries[-1]):
            yield right.__class__(right.rows, right.cols, [*entries[:-1], change])
        return
    for term in sympy.Add.make_args(right)[:2]:
        if right.is_Add:
            yield right - 2 * term
    for power in sorted(right.atoms(sympy.Pow), key=str)[:1]:
        yield right.xreplace({power: power.base ** (power.exp + 1)})
    yield 2 * right
    yield -right
    yield right + 1


def changed(left: Any, right: Any, choice: int) -> Any:
    """A right side with a slip that differs from the left at a real point; None if none is found."""
    changes = list(_changes(right))
    start = choice % max(len(changes), 1)
    for wrong in [*changes[start:], *changes[:start]]:
        try:
            if agreement(left, wrong) == "different" and _differs_where_real(left, wrong):
                return wrong
        except Exception:
            continue
    return None


def falsified(pair: Pair) -> str:
    """The text of a right side that differs from the left at a real point; "" if none is found."""
    wrong = changed(*read(pair), len(pair.left))
    return "" if wrong is None else text_of(wrong)


def _differs_where_real(left: Any, wrong: Any) -> bool:
    for one, other in values_of(left, wrong):
        if one.is_number and other.is_number and one.is_finite and other.is_finite:
            real = abs(sympy.im(one)) + abs(sympy.im(other)) < NEAR
            if real and abs(one - other) > NEAR * (1 + abs(one)):
                return True
    return False
