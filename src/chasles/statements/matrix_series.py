"""Power series of columns and matrices: lengths, inverses, determinants."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import partial, reduce

from chasles.statements.series import PowerSeries, minus, product, scaled, taylor, total
from chasles.vocabulary import Determinant, Dot, Identity, Inverse, Node, Norm, Number, Trace

ONE = Number(Fraction(1))


def behind(series: PowerSeries) -> PowerSeries:
    """The series without its coefficient of order 0."""
    return PowerSeries(1, tuple(series.coefficient(k) for k in range(1, series.known)), series.known)


def composed(slopes: Iterable[Node | None], rest: PowerSeries, length: int) -> PowerSeries:
    """A Taylor series at a series without a coefficient of order 0."""
    first, *others = slopes
    found, power = _constant(first, length), _constant(ONE, length)
    for slope in others:
        power = product(power, rest, scaled, length)
        if power.lead is None:
            break
        if slope is not None:
            found = total(found, power.each(partial(scaled, slope)))
    return PowerSeries(found.begin, found.terms, min(found.known, rest.known))


def length_of(column: PowerSeries, lead: int, length: int) -> PowerSeries:
    """The length where what is small is positive: |a + d| is |a| times the root of |1 + d/|a||^2."""
    first = column.coefficient(lead)
    assert first is not None
    alone = PowerSeries(lead, (Norm(first),), length)
    if sum(term is not None for term in column.terms) == 1 and column.known >= length:
        return alone
    whole = PowerSeries(0, column.terms[lead - column.begin :], column.known - lead)
    square = product(whole, whole, Dot, length).each(lambda part: part / Norm(first) ** 2)
    return product(alone, composed(taylor("sqrt", ONE, length, ONE), behind(square), length), scaled, length)


def inverse_of(matrix: PowerSeries, at_zero: Node, length: int) -> PowerSeries:
    """The inverse by that of the coefficient of order 0: (A + D)^-1 is A^-1 - A^-1 D A^-1 + ..."""
    first, rest = _divided(matrix, at_zero)
    found = power = _constant(first, length)
    for _ in range(1, matrix.known):
        power = product(rest, power, _times, length).each(minus)
        found = total(found, power)
    return PowerSeries(found.begin, found.terms, min(found.known, matrix.known))


def determinant_of(matrix: PowerSeries, at_zero: Node, length: int) -> PowerSeries:
    """The determinant: that of the coefficient of order 0, times that of 1 + D by traces of powers of D (Newton)."""
    first, rest = _divided(matrix, at_zero)
    traces, elementary = list[PowerSeries](), [_constant(ONE, length)]
    power = _constant(Identity(at_zero.shape[0]), length)
    for k in range(1, min(matrix.known, length)):
        power = product(power, rest, _times, length)
        traces.append(power.each(Trace))
        found = _constant(None, length)
        for i, trace in enumerate(traces):
            term = product(elementary[k - 1 - i], trace, scaled, length)
            found = total(found, term.each(minus) if i % 2 else term)
        elementary.append(found.each(partial(scaled, Number(Fraction(1, k)))))
    found = reduce(total, elementary)
    if not isinstance(first, Identity):
        found = found.each(partial(scaled, Determinant(at_zero)))
    return PowerSeries(found.begin, found.terms, min(found.known, matrix.known))


def _divided(matrix: PowerSeries, at_zero: Node) -> tuple[Node, PowerSeries]:
    """The inverse of the coefficient of order 0, and that inverse times what comes behind it."""
    first: Node = at_zero if isinstance(at_zero, Identity) else Inverse(at_zero)
    return first, behind(matrix).each(partial(_times, first))


def _times(left: Node, right: Node) -> Node:
    """The matrix product, in which an identity is left out."""
    return right if isinstance(left, Identity) else left if isinstance(right, Identity) else left @ right


def _constant(node: Node | None, length: int) -> PowerSeries:
    return PowerSeries(0, (node,), length)
