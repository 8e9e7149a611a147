"""Expressions as power series in something small: what a claim up to terms of an order says of each coefficient.

A small vector is put as epsilon times itself, so that the coefficient of epsilon^k is homogeneous of degree k in it. A
series begins with a coefficient that is not seen to be zero; whoever divides by it has it declared nonzero.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from functools import reduce

from chasles import vocabulary as w
from chasles.statements import series
from chasles.statements.bounds import RealInterval, bounds_of
from chasles.statements.hypotheses import Hypothesis, nonzero
from chasles.statements.matrix_series import behind, composed, determinant_of, inverse_of, length_of
from chasles.statements.series import PowerSeries, TooShort, inverse, is_zero, minus, product, scaled, total
from chasles.vocabulary import Node
from chasles.vocabulary.expansions import Limit, UpTo
from chasles.vocabulary.functions import DERIVATIVES, FunctionOf
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.tree import rebuilt

MOST_TERMS = 40
"""Terms of a series that are looked at to find one that is not zero."""
AT_ZERO = {*((name, None) for name in ("arctan", "arcsin", "arcsinh", "tanh", "arctanh")), ("log", w.number(1))}
"""Functions with the value zero, and where they have it."""
Pair = tuple[str, Node, Node]


def coefficients_of(left: Node, right: Node, rules: Mapping[Node, Node]) -> Iterator[Pair]:
    """What the claim says of the coefficients, one by one: a label and the two that are equal.

    The `rules` say what symbols stand for. Raises TypeError for an expression that is not expanded.
    """
    small, exponent = _order_of(left, right)
    if small in rules:
        raise w.Misfit(f"{small} goes to zero, and a given statement says what it is")
    sides = [side.of if isinstance(side, UpTo | Limit) else side for side in (left, right)]
    if any(isinstance(part, UpTo | Limit) for side in sides for part in w.walk(side)):
        raise w.Misfit("a limit is the whole left side of a claim, and an order belongs to its whole right side")
    length = exponent + 2
    while True:
        expansion = _Expansion(small, length, rules)
        try:
            one, other = map(expansion, sides)
            if min(one.known, other.known) >= exponent:
                break
            reason = TypeError(f"no expansion of {left} to the order {exponent} in {small} is found")
        except TooShort as error:
            reason = error
        if length > MOST_TERMS:
            raise reason
        length *= 2
    for divisor in expansion.divisors:
        if divisor is not None and not _is_size_of(small, divisor):
            size = divisor if divisor.is_scalar else w.Norm(divisor)
            yield f"{w.plain(size)} is not zero, terms of order 0", w.number(0) / size, w.number(0)
    yield from _compared(left, one, other, exponent, "")
    if expansion.has_absolute_values:
        one, other = map(_Expansion(small, length, rules, below=True), sides)
        yield from _compared(left, one, other, exponent, f", {small} < 0")


def _compared(left: Node, one: PowerSeries, other: PowerSeries, exponent: int, where: str) -> Iterator[Pair]:
    for k in range(min(one.begin, other.begin, 0), exponent):
        a, b = one.coefficient(k), other.coefficient(k)
        if k == 0 or a is not None or b is not None:
            nothing = w.Number(Fraction(0)) if left.is_scalar else w.Zero(*left.shape)
            yield f"terms of order {k}{where}", nothing if a is None else a, nothing if b is None else b


def presupposed(left: Node, right: Node, assumed: Iterable[Hypothesis]) -> Iterator[Hypothesis]:
    """That a small vector is not zero: what holds nearby is asked, not at the point itself.

    Raises TypeError if an equation is assumed of what is small.
    """
    small, _ = _order_of(left, right)
    for hypothesis in assumed:
        if any(part == small for side in hypothesis.sides for part in w.walk(side)):
            raise TypeError(f"{small} goes to zero, and it is assumed that {hypothesis.text}")
    if not small.is_scalar:
        yield nonzero(w.Norm(small))


def _order_of(left: Node, right: Node) -> tuple[w.Symbol, int]:
    for side in (right, left):
        if isinstance(side, UpTo | Limit):
            assert isinstance(side.small, w.Symbol)
            return side.small, side.exponent if isinstance(side, UpTo) else 1
    raise w.Misfit("neither side is an expansion")


def _is_size_of(small: Node, divisor: Node) -> bool:
    """Whether it is a number, or one times a power of the size of what is small, which is not zero in a limit."""
    if isinstance(divisor, w.Scale):
        return _is_size_of(small, divisor.factor) and _is_size_of(small, divisor.term)
    return isinstance(divisor, w.Number) or divisor == small or (isinstance(divisor, w.Norm) and divisor.of == small)


class _Expansion:
    """Expands expressions to so many terms in something small.

    A length that is a multiple of an odd power of a small scalar takes its absolute value: what is small is positive,
    or it is `below` zero.
    """

    def __init__(self, small: w.Symbol, length: int, rules: Mapping[Node, Node], below: bool = False) -> None:
        self.small = small
        self.length = length
        self.rules = rules
        self.varying = {small, *rules}
        self.below = below
        self.has_absolute_values = False
        self.divisors: dict[Node | None, None] = {}

    def __call__(self, node: Node) -> PowerSeries:
        if not any(p in self.varying or getattr(p, "stands_for", isinstance(p, Shorthand)) for p in w.walk(node)):
            return self._constant(node)
        match node:
            case _ if node in self.rules:
                return self(self.rules[node])
            case w.Symbol(stands_for=Node() as of) | w.At(of) | w.Group(of):
                return self(of)
            case w.Symbol():
                return self._small if node == self.small else self._constant(node)
            case Shorthand():
                return self(node.definition)
            case w.Sum(terms):
                return reduce(total, map(self, terms))
            case w.Negative(term):
                return self(term).each(minus)
            case w.Scale(factor, term):
                return product(self(factor), self(term), scaled, self.length)
            case w.Quotient(numerator, denominator):
                below = self(denominator)
                self.divisors[below.coefficient(below.lead or 0)] = None
                return product(inverse(below, denominator), self(numerator), scaled, self.length)
            case w.Contract(factors):
                return reduce(lambda a, b: product(a, b, lambda x, y: x @ y, self.length), map(self, factors))
            case w.Power(base, exponent):
                times = scaled if node.is_scalar else (lambda x, y: x @ y)
                return reduce(lambda a, b: product(a, b, times, self.length), [self(base)] * exponent)
            case w.Dot(left, right):
                return product(self(left), self(right), w.Dot, self.length)
            case w.Cross(left, right):
                return product(self(left), self(right), w.Cross, self.length)
            case w.Transpose(of) | w.Skew(of) | w.Vect(of) | w.Trace(of):
                return self(of).each(lambda part: rebuilt(node, (part,)))
            case _:
                return self._other(node)

    def _other(self, node: Node) -> PowerSeries:
        match node:
            case w.Block(rows):
                return self._block(rows)
            case w.Norm(of):
                return self._norm(of)
            case w.Inverse(of):
                return self._of_matrix(of, inverse_of)
            case w.Determinant(of):
                return self._of_matrix(of, determinant_of)
            case w.Call(function, argument) | FunctionOf(function, (argument,)):
                return self._function(function, argument, node)
            case _:
                raise TypeError(f"{w.plain(node)} is not expanded where {w.plain(self.small)} is small")

    @property
    def _small(self) -> PowerSeries:
        return self._series(1, [w.Number(Fraction(1)) if self.small.is_scalar else self.small])

    def _constant(self, node: Node) -> PowerSeries:
        bounds = bounds_of(node, {}) if node.is_scalar else RealInterval()
        value = w.Number(Fraction(bounds.low)) if bounds.low == bounds.high else node
        return self._series(0, [None if is_zero(value) else value])

    def _series(self, begin: int, terms: list[Node | None]) -> PowerSeries:
        return PowerSeries(begin, tuple(terms), self.length)

    def _block(self, rows: tuple[tuple[Node, ...], ...]) -> PowerSeries:
        parts = [[self(part) for part in row] for row in rows]
        every = [entry for row in parts for entry in row]
        begin, known = min(s.begin for s in every), min(s.known for s in every)
        end = min(known, max(s.begin + len(s.terms) for s in every))
        terms: list[Node | None] = []
        for k in range(begin, end):
            grid = [[entry.coefficient(k) for entry in row] for row in parts]
            empty = all(entry is None for line in grid for entry in line)
            shown = [zip(line, row, strict=True) for line, row in zip(grid, rows, strict=True)]
            filled = tuple(tuple(w.Zero(*node.shape) if e is None else e for e, node in line) for line in shown)
            terms.append(None if empty else w.Block(filled))
        return PowerSeries(begin, tuple(terms), known)

    def _norm(self, of: Node) -> PowerSeries:
        inner = self(of)
        lead = inner.lead
        if lead is None:
            raise TooShort(f"{w.plain(of)} has no term up to the order {inner.known}")
        is_odd = self.small.is_scalar and lead % 2 == 1
        self.has_absolute_values |= is_odd
        self.divisors[inner.coefficient(lead)] = None
        found = length_of(inner, lead, self.length)
        return found.each(minus) if is_odd and self.below else found

    def _of_matrix(self, of: Node, function: Callable[[PowerSeries, Node, int], PowerSeries]) -> PowerSeries:
        inner = self(of)
        at_zero = inner.coefficient(0)
        if at_zero is None or (inner.lead or 0) < 0:
            raise TypeError(f"{w.plain(of)} has no inverse where {w.plain(self.small)} is zero, and is not expanded")
        self.divisors[w.Determinant(at_zero)] = None
        return function(inner, at_zero, self.length)

    def _function(self, name: str, argument: Node, node: Node) -> PowerSeries:
        """A function by its Taylor series around the value of its argument where what is small is zero."""
        inner = self(argument)
        if inner.begin < 0 and (inner.lead or 0) < 0:
            raise TypeError(f"{w.plain(node)} is not expanded: its argument grows without bound")
        around = inner.coefficient(0)
        if name in DERIVATIVES and name not in (*series.TURNS, "sqrt"):
            start = FunctionOf(name, (w.number(0) if around is None else around,))
            slope = self(DERIVATIVES[name](argument)[0])
            return series.by_slope(slope, inner, None if (name, around) in AT_ZERO else start)
        if name == "sqrt":
            self.divisors[around] = None
        slopes = series.taylor(name, around, self.length, node)
        return composed(slopes, behind(inner), self.length)
