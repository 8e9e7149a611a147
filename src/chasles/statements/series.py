"""Power series with expressions for coefficients: sums, products, inverses, functions by Taylor's series.

A series begins with a coefficient that is not seen to be zero; whoever divides by it has it declared nonzero.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from itertools import cycle, islice
from math import factorial

from chasles.vocabulary import Call, Negative, Node, Number, Quotient, Scale, Sum, Zero, plain
from chasles.vocabulary.functions import FunctionOf

ONE = Number(Fraction(1))
TURNS = {"exp": (0, 0, 0, 0), "sin": (1, 2, -1, -2), "cos": (2, -1, -2, 1), "sinh": (1, 2, 1, 2), "cosh": (2, 1, 2, 1)}
"""Which derivatives follow each other, with their signs: 0 the exponential function, 1 sine, 2 cosine."""


class TooShort(TypeError):
    """A series in which no term is seen that is not zero: more terms may show one."""


@dataclass(frozen=True, slots=True)
class PowerSeries:
    """Coefficients from the power `begin` on, None for zero; nothing is known of the power `known` and beyond."""

    begin: int
    terms: tuple[Node | None, ...]
    known: int

    def coefficient(self, power: int) -> Node | None:
        """The coefficient of a power; None for zero."""
        place = power - self.begin
        return self.terms[place] if 0 <= place < len(self.terms) else None

    @property
    def lead(self) -> int | None:
        """The power of the first coefficient that is not zero."""
        return next((self.begin + k for k, term in enumerate(self.terms) if term is not None), None)

    def each(self, change: Callable[[Node], Node]) -> PowerSeries:
        """The series with each coefficient changed."""
        return PowerSeries(self.begin, tuple(None if t is None else change(t) for t in self.terms), self.known)


def product(one: PowerSeries, other: PowerSeries, times: Callable[[Node, Node], Node], length: int) -> PowerSeries:
    """The product of two series, up to a power."""
    known = min(one.known + _first(other), other.known + _first(one), length)
    begin = one.begin + other.begin
    terms: list[Node | None] = [None] * max(0, min(known - begin, len(one.terms) + len(other.terms) - 1))
    for i, a in enumerate(one.terms):
        for j, b in enumerate(other.terms):
            if a is not None and b is not None and i + j < len(terms):
                terms[i + j] = _plus(terms[i + j], times(a, b))
    return PowerSeries(begin, tuple(terms), known)


def inverse(of: PowerSeries, divisor: Node) -> PowerSeries:
    """One over a series, by that of its first coefficient: 1/(a (1 + d)) = (1 - d + d^2 - ...)/a."""
    lead = of.lead
    if lead is None:
        raise TooShort(f"{plain(divisor)} has no term up to the order {of.known} by which could be divided")
    first = of.coefficient(lead)
    assert first is not None
    over = _over(first)
    rest = [of.coefficient(lead + k) for k in range(1, of.known - lead)]
    terms: list[Node | None] = [over]
    for k in range(1, of.known - lead):
        found: Node | None = None
        for j in range(1, k + 1):
            a, b = rest[j - 1], terms[k - j]
            if a is not None and b is not None:
                found = _plus(found, scaled(over, minus(scaled(a, b))))
        terms.append(found)
    return PowerSeries(-lead, tuple(terms), of.known - 2 * lead)


def taylor(name: str, at: Node | None, length: int, node: Node) -> list[Node | None]:
    """The coefficients of the Taylor series around a point; None for the point is zero."""
    factors = [Fraction(1, factorial(k)) for k in range(length)]
    if name in TURNS:
        values, turns = _values(name, at), islice(cycle(TURNS[name]), length)
        signed = [(values[abs(turn)], -each if turn < 0 else each) for turn, each in zip(turns, factors, strict=True)]
        return [None if value is None else scaled(Number(factor), value) for value, factor in signed]
    if name == "sqrt" and at is not None:
        root: Node = at if at == ONE else FunctionOf("sqrt", (at,))
        found, factor, below = list[Node | None](), Fraction(1), root
        for k in range(length):
            found.append(scaled(Number(factor), below))
            factor *= (Fraction(1, 2) - k) / (k + 1)
            below = scaled(below, _over(at))
        return found
    raise TypeError(f"{plain(node)} is not expanded there")


def _values(name: str, at: Node | None) -> tuple[Node | None, ...]:
    """At the point: the exponential function, and sine and cosine, hyperbolic ones for a function of that kind."""
    if at is None:
        return ONE, None, ONE
    hyperbolic = (FunctionOf("sinh", (at,)), FunctionOf("cosh", (at,)))
    return FunctionOf("exp", (at,)), *(hyperbolic if name.endswith("h") else (Call("sin", at), Call("cos", at)))


def by_slope(slope: PowerSeries, inner: PowerSeries, start: Node | None) -> PowerSeries:
    """The series of a function from those of its slope and its argument, and its value at the start; None for zero."""
    rates = tuple(
        None if t is None or not k else scaled(Number(Fraction(k)), t) for k, t in enumerate(inner.terms, inner.begin)
    )
    found = product(slope, PowerSeries(inner.begin - 1, rates, inner.known - 1), scaled, slope.known)
    if (found.lead or 0) < 0:
        raise TypeError("what grows without bound is not expanded")
    terms = (found.coefficient(k - 1) for k in range(1, found.known + 1))
    risen = (None if t is None else scaled(Number(Fraction(1, k)), t) for k, t in enumerate(terms, 1))
    return PowerSeries(0, (start, *risen), found.known + 1)


def _first(series: PowerSeries) -> int:
    lead = series.lead
    return series.known if lead is None else lead


def total(one: PowerSeries, other: PowerSeries) -> PowerSeries:
    """The sum of two series."""
    known, begin = min(one.known, other.known), min(one.begin, other.begin)
    end = min(known, max(one.begin + len(one.terms), other.begin + len(other.terms)))
    pairs = ((one.coefficient(k), other.coefficient(k)) for k in range(begin, end))
    return PowerSeries(begin, tuple(a if b is None else _plus(a, b) for a, b in pairs), known)


def is_zero(node: Node) -> bool:
    """Whether an expression is zero as it is spelled."""
    return isinstance(node, Zero) or (isinstance(node, Number) and not node.value)


def _number(value: Fraction) -> Node | None:
    return Number(value) if value else None


def _plus(one: Node | None, other: Node) -> Node | None:
    if one is None:
        return other
    if isinstance(one, Number) and isinstance(other, Number):
        return _number(one.value + other.value)
    return Sum((*(one.terms if isinstance(one, Sum) else (one,)), other))


def minus(node: Node) -> Node:
    """The opposite of an expression."""
    match node:
        case Number(value):
            return Number(-value)
        case Negative(term):
            return term
        case _:
            return Negative(node)


def scaled(factor: Node, term: Node) -> Node:
    """The scalar times the term; numbers are multiplied."""
    match factor, term:
        case Number(a), Number(b):
            return Number(a * b)
        case (Number(a), other) | (other, Number(a)) if a == 1 and (other.is_scalar or other is term):
            return other
        case Number(a), Scale(Number(b), rest):
            return Scale(Number(a * b), rest)
        case _:
            return Scale(factor, term)


def _over(divisor: Node) -> Node:
    return Number(1 / divisor.value) if isinstance(divisor, Number) else Quotient(ONE, divisor)
