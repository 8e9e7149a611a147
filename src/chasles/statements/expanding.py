"""Expressions as power series in something small: what a claim up to terms of an order says of each coefficient.

A small vector is put as epsilon times itself, so that the coefficient of epsilon^k is homogeneous of degree k in it. A
series begins with a coefficient that is not seen to be zero; whoever divides by it has it declared nonzero.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import partial, reduce

from chasles.statements.hypotheses import Hypothesis, nonzero
from chasles.vocabulary import (
    At,
    Block,
    Call,
    Contract,
    Cross,
    Determinant,
    Dot,
    Group,
    Misfit,
    Negative,
    Node,
    Norm,
    Number,
    Power,
    Quotient,
    Rate,
    Scale,
    Skew,
    Sum,
    Symbol,
    Trace,
    Transpose,
    Vect,
    Zero,
    plain,
    walk,
)
from chasles.vocabulary.expansions import Limit, UpTo
from chasles.vocabulary.functions import FunctionOf
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.tree import rebuilt

__all__ = ["coefficients_of", "presupposed"]

MOST_TERMS = 40
"""Terms of a series that are looked at to find one that is not zero."""
Pair = tuple[str, Node, Node]


def coefficients_of(left: Node, right: Node, rules: Mapping[Node, Node]) -> Iterator[Pair]:
    """What the claim says of the coefficients, one by one: a label and the two that are equal.

    The `rules` say what symbols stand for. Raises `Misfit` for an expression that is not expanded.
    """
    small, exponent = _order_of(left, right)
    if small in rules:
        raise Misfit(f"{small} goes to zero, and a given statement says what it is")
    sides = [side.of if isinstance(side, UpTo | Limit) else side for side in (left, right)]
    if any(isinstance(part, UpTo | Limit) for side in sides for part in walk(side)):
        raise Misfit("a limit is the whole left side of a claim, and an order belongs to its whole right side")
    length = exponent + 2
    while True:
        one, other = (_Expansion(small, length, rules)(side) for side in sides)
        if min(one.known, other.known) >= exponent:
            break
        if length > MOST_TERMS:
            raise Misfit(f"no expansion of {left} to the order {exponent} in {small} is found")
        length *= 2
    for k in range(min(one.begin, other.begin, 0), exponent):
        a, b = one.coefficient(k), other.coefficient(k)
        if k == 0 or a is not None or b is not None:
            nothing = Number(Fraction(0)) if left.is_scalar else Zero(*left.shape)
            yield f"terms of order {k}", nothing if a is None else a, nothing if b is None else b


def presupposed(left: Node, right: Node, assumed: Iterable[Hypothesis]) -> Iterator[Hypothesis]:
    """That a small vector is not zero: what holds nearby is asked, not at the point itself.

    Raises TypeError if an equation is assumed of what is small.
    """
    small, _ = _order_of(left, right)
    for hypothesis in assumed:
        if any(part == small for equation in hypothesis.equations for side in equation for part in walk(side)):
            raise TypeError(f"{small} goes to zero, and it is assumed that {hypothesis.text}")
    if not small.is_scalar:
        yield nonzero(Norm(small))


def _order_of(left: Node, right: Node) -> tuple[Symbol, int]:
    for side in (right, left):
        if isinstance(side, UpTo | Limit):
            assert isinstance(side.small, Symbol)
            return side.small, side.exponent if isinstance(side, UpTo) else 1
    raise Misfit("neither side is an expansion")


@dataclass(frozen=True, slots=True)
class _Series:
    """Coefficients from the power `begin` on, None for zero; nothing is known of the power `known` and beyond."""

    begin: int
    terms: tuple[Node | None, ...]
    known: int

    def coefficient(self, power: int) -> Node | None:
        place = power - self.begin
        return self.terms[place] if 0 <= place < len(self.terms) else None

    @property
    def lead(self) -> int | None:
        """The power of the first coefficient that is not zero."""
        return next((self.begin + k for k, term in enumerate(self.terms) if term is not None), None)

    def each(self, change: Callable[[Node], Node]) -> _Series:
        return _Series(self.begin, tuple(None if t is None else change(t) for t in self.terms), self.known)


class _Expansion:
    """Expands expressions to so many terms in something small."""

    def __init__(self, small: Symbol, length: int, rules: Mapping[Node, Node]) -> None:
        self.small = small
        self.length = length
        self.rules = rules

    def __call__(self, node: Node) -> _Series:
        if not any(self._may_vary(part) for part in walk(node)):
            return self._constant(node)
        match node:
            case _ if node in self.rules:
                return self(self.rules[node])
            case Symbol(stands_for=Node() as of) | At(of) | Group(of):
                return self(of)
            case Symbol():
                return self._small if node == self.small else self._constant(node)
            case Shorthand():
                return self(node.definition)
            case Sum(terms):
                return reduce(_sum, map(self, terms))
            case Negative(term):
                return self(term).each(_minus)
            case Scale(factor, term):
                return self._product(self(factor), self(term), _scaled)
            case Quotient(numerator, denominator):
                return self._product(self._inverse(self(denominator), denominator), self(numerator), _scaled)
            case Contract(factors):
                return reduce(lambda a, b: self._product(a, b, lambda x, y: x @ y), map(self, factors))
            case Power(base, exponent):
                times = _scaled if node.is_scalar else (lambda x, y: x @ y)
                return reduce(lambda a, b: self._product(a, b, times), [self(base)] * exponent)
            case Dot(left, right):
                return self._product(self(left), self(right), Dot)
            case Cross(left, right):
                return self._product(self(left), self(right), Cross)
            case Transpose(of) | Skew(of) | Vect(of) | Trace(of):
                return self(of).each(lambda part: rebuilt(node, (part,)))
            case _:
                return self._other(node)

    def _other(self, node: Node) -> _Series:
        match node:
            case Block(rows):
                return self._block(rows)
            case Norm(of):
                return self._norm(of)
            case Call(function, argument) | FunctionOf(function, (argument,)):
                return self._function(function, argument, node)
            case Rate() | Determinant() | _:
                raise Misfit(f"{plain(node)} is not expanded where {plain(self.small)} is small")

    def _may_vary(self, part: Node) -> bool:
        stands_for_more = isinstance(part, Symbol) and part.stands_for is not None
        return part == self.small or part in self.rules or stands_for_more or isinstance(part, Shorthand)

    @property
    def _small(self) -> _Series:
        return self._series(1, [Number(Fraction(1)) if self.small.is_scalar else self.small])

    def _constant(self, node: Node) -> _Series:
        return self._series(0, [None if _is_zero(node) else node])

    def _series(self, begin: int, terms: list[Node | None]) -> _Series:
        return _Series(begin, tuple(terms), self.length)

    def _product(self, one: _Series, other: _Series, times: Callable[[Node, Node], Node]) -> _Series:
        known = min(one.known + _first(other), other.known + _first(one), self.length)
        begin = one.begin + other.begin
        terms: list[Node | None] = [None] * max(0, min(known - begin, len(one.terms) + len(other.terms) - 1))
        for i, a in enumerate(one.terms):
            for j, b in enumerate(other.terms):
                if a is not None and b is not None and i + j < len(terms):
                    terms[i + j] = _plus(terms[i + j], times(a, b))
        return _Series(begin, tuple(terms), known)

    def _inverse(self, of: _Series, divisor: Node) -> _Series:
        """One over a series, by that of its first coefficient: 1/(a (1 + d)) = (1 - d + d^2 - ...)/a."""
        lead = of.lead
        if lead is None:
            raise Misfit(f"{plain(divisor)} has no term up to the order {of.known} by which could be divided")
        first = of.coefficient(lead)
        assert first is not None
        over = _over(first)
        rest = [of.coefficient(lead + k) for k in range(1, of.known - lead)]
        terms: list[Node | None] = [over]
        for k in range(1, of.known - lead):
            total: Node | None = None
            for j in range(1, k + 1):
                a, b = rest[j - 1], terms[k - j]
                if a is not None and b is not None:
                    total = _plus(total, _scaled(over, _minus(_scaled(a, b))))
            terms.append(total)
        return _Series(-lead, tuple(terms), of.known - 2 * lead)

    def _block(self, rows: tuple[tuple[Node, ...], ...]) -> _Series:
        parts = [[self(part) for part in row] for row in rows]
        every = [series for row in parts for series in row]
        begin, known = min(s.begin for s in every), min(s.known for s in every)
        end = min(known, max(s.begin + len(s.terms) for s in every))
        terms: list[Node | None] = []
        for k in range(begin, end):
            grid = [[series.coefficient(k) for series in row] for row in parts]
            empty = all(entry is None for line in grid for entry in line)
            shown = zip(grid, rows, strict=True)
            filled = (tuple(e or Zero(*node.shape) for e, node in zip(line, row, strict=True)) for line, row in shown)
            terms.append(None if empty else Block(tuple(filled)))
        return _Series(begin, tuple(terms), known)

    def _norm(self, of: Node) -> _Series:
        inner = self(of)
        lead = inner.lead
        found = [k for k, term in enumerate(inner.terms) if term is not None]
        if lead is None or len(found) != 1 or inner.known < self.length or (self.small.is_scalar and lead % 2):
            raise Misfit(f"|{plain(of)}| is not expanded: it is no multiple of what is small")
        first = inner.coefficient(lead)
        assert first is not None
        return self._series(lead, [Norm(first)])

    def _function(self, name: str, argument: Node, node: Node) -> _Series:
        """A function by its Taylor series around the value of its argument where what is small is zero."""
        inner = self(argument)
        if inner.begin < 0 and (inner.lead or 0) < 0:
            raise Misfit(f"{plain(node)} is not expanded: its argument grows without bound")
        around = inner.coefficient(0)
        slopes = _taylor(name, around, self.length, node)
        begin = max(1, inner.begin)
        rest = _Series(begin, tuple(inner.coefficient(k) for k in range(begin, inner.known)), inner.known)
        total = self._constant(slopes[0]) if slopes[0] is not None else self._series(0, [None])
        power = self._constant(Number(Fraction(1)))
        for slope in slopes[1:]:
            power = self._product(power, rest, _scaled)
            if power.lead is None:
                break
            if slope is not None:
                total = _sum(total, power.each(partial(_scaled, slope)))
        return _Series(total.begin, total.terms, min(total.known, inner.known))


def _taylor(name: str, at: Node | None, length: int, node: Node) -> list[Node | None]:
    """The coefficients of the Taylor series around a point; None for the point is zero."""
    factorials = [Fraction(1)]
    for k in range(1, length):
        factorials.append(factorials[-1] / k)
    if name in ("sin", "cos", "exp"):
        value = {"exp": (0, 0, 0, 0), "sin": (1, 2, -1, -2), "cos": (2, -1, -2, 1)}[name]
        if at is None:
            numbers = {"exp": (1, 1, 1, 1), "sin": (0, 1, 0, -1), "cos": (1, 0, -1, 0)}[name]
            return [_number(factorials[k] * numbers[k % 4]) for k in range(length)]
        signed = {0: FunctionOf("exp", (at,)), 1: Call("sin", at), 2: Call("cos", at)}
        if name == "exp":
            return [_scaled(Number(factorials[k]), signed[0]) for k in range(length)]
        made = [(factorials[k] * (1 if value[k % 4] > 0 else -1), signed[abs(value[k % 4])]) for k in range(length)]
        return [_scaled(Number(factor), function) for factor, function in made]
    powers = {"sqrt": Fraction(1, 2)}
    if name in powers and at is not None:
        root: Node = at if at == Number(Fraction(1)) else FunctionOf("sqrt", (at,))
        found, factor, below = list[Node | None](), Fraction(1), root
        for k in range(length):
            found.append(_scaled(Number(factor), below))
            factor *= (powers[name] - k) / (k + 1)
            below = _scaled(below, _over(at))
        return found
    if name in ("log", "arctan", "arcsin") and (at is None) != (name == "log"):
        return _at_its_zero(name, at, length, node)
    raise Misfit(f"{plain(node)} is not expanded there")


def _at_its_zero(name: str, at: Node | None, length: int, node: Node) -> list[Node | None]:
    """The logarithm around one; the inverse tangent and sine around zero."""
    if name == "log":
        if at != Number(Fraction(1)):
            raise Misfit(f"{plain(node)} is not expanded there")
        return [None, *(_number(Fraction((-1) ** (k + 1), k)) for k in range(1, length))]
    if name == "arctan":
        return [_number(Fraction((-1) ** (k // 2), k)) if k % 2 else None for k in range(length)]
    terms, factor = list[Node | None](), Fraction(1)
    for k in range(length):
        terms.append(_number(factor / k) if k % 2 else None)
        if k % 2:
            factor *= Fraction(k, k + 1)
    return terms


def _first(series: _Series) -> int:
    lead = series.lead
    return series.known if lead is None else lead


def _sum(one: _Series, other: _Series) -> _Series:
    known, begin = min(one.known, other.known), min(one.begin, other.begin)
    end = min(known, max(one.begin + len(one.terms), other.begin + len(other.terms)))
    terms = []
    for k in range(begin, end):
        a, b = one.coefficient(k), other.coefficient(k)
        terms.append(a if b is None else _plus(a, b))
    return _Series(begin, tuple(terms), known)


def _is_zero(node: Node) -> bool:
    return isinstance(node, Zero) or (isinstance(node, Number) and not node.value)


def _number(value: Fraction) -> Node | None:
    return Number(value) if value else None


def _plus(one: Node | None, other: Node) -> Node | None:
    if one is None:
        return other
    if isinstance(one, Number) and isinstance(other, Number):
        return _number(one.value + other.value)
    return Sum((*(one.terms if isinstance(one, Sum) else (one,)), other))


def _minus(node: Node) -> Node:
    match node:
        case Number(value):
            return Number(-value)
        case Negative(term):
            return term
        case _:
            return Negative(node)


def _scaled(factor: Node, term: Node) -> Node:
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
    return Number(1 / divisor.value) if isinstance(divisor, Number) else Quotient(Number(Fraction(1)), divisor)
