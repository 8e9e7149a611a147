"""Sums of powers of a symbol, times exponentials, cosines and sines of its multiples, and their integrals.

What multiplies them is free of the symbol; products of cosines and sines are written as sums.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce
from itertools import product
from math import factorial

from chasles.vocabulary.functions import FunctionOf, exp
from chasles.vocabulary.layout import At, Block, Call, Group
from chasles.vocabulary.letters import Symbol, Zero, zero_of
from chasles.vocabulary.nodes import Contract, Negative, Node, Number, Power, Quotient, Scale, Sum, Transpose, lifted
from chasles.vocabulary.spatial import Cross, Dot, Skew, Trace, Vect
from chasles.vocabulary.tree import children, rebuilt, walk
from chasles.vocabulary.words import cos, sin

LARGEST_DEGREE = 24
Monomial = tuple[tuple[Node, int], ...]
"""Powers of what is neither a sum nor a product."""
Rate = tuple[tuple[Monomial, Fraction], ...]
"""A polynomial: what is multiplied by the symbol in the argument of a function."""
Complex = tuple[Node | None, Node | None]
"""Real and imaginary part, None for zero."""


@dataclass(frozen=True, slots=True)
class Oscillation:
    """A power of the symbol, times an exponential of a multiple of it, times the cosine or sine of a multiple."""

    power: int = 0
    growth: Rate = ()
    turn: Rate = ()
    sine: bool = False

    @property
    def turned(self) -> tuple[int, Oscillation] | None:
        """The same with a sign in front, the multiple in the sine or cosine beginning with no sign; None for zero."""
        if not self.turn or self.turn[0][1] > 0:
            return None if self.sine and not self.turn else (1, self)
        turn = _added_rates((), self.turn, -1)
        return (-1 if self.sine else 1), replace(self, turn=turn)


def multiplied(one: Oscillation, other: Oscillation) -> Iterator[tuple[Fraction, Oscillation]]:
    """The product of two as a sum of multiples of such."""
    _require_letters(one.growth, other.growth)
    _require_letters(one.turn, other.turn)
    both = Oscillation(one.power + other.power, _added_rates(one.growth, other.growth))
    if not one.turn or not other.turn:
        turning = one if one.turn else other
        yield Fraction(1), replace(both, turn=turning.turn, sine=turning.sine)
        return
    for sign in (1, -1):
        turn = _added_rates(one.turn, other.turn, sign)
        half = Fraction(-sign if one.sine and other.sine else sign if other.sine else 1, 2)
        found = replace(both, turn=turn, sine=one.sine != other.sine).turned
        if found is not None:
            yield half * found[0], found[1]


def integrated(term: Oscillation, by: Node) -> Node:
    """An antiderivative, by the rule of integration by parts."""
    n, growth, turn = term.power, _combined(term.growth), _combined(term.turn)
    if growth is None and turn is None:
        return Quotient(Power(by, n + 1) if n else by, Number(Fraction(n + 1)))
    size = None if growth is None or turn is None else Sum((Power(growth, 2), Power(turn, 2)))
    inverse: Complex = (
        None if growth is None else Quotient(growth, size) if size is not None else Quotient(lifted(1), growth),
        None if turn is None else Negative(Quotient(turn, size) if size is not None else Quotient(lifted(1), turn)),
    )
    below, parts = inverse, list[Node]()
    turning: Complex = (lifted(1), None) if turn is None else (cos(Scale(turn, by)), sin(Scale(turn, by)))
    for k in range(n + 1):
        value = _times(below, turning)[int(term.sine)]
        if value is not None:
            times = Number(Fraction((-1) ** k * factorial(n), factorial(n - k)))
            parts.append(Scale(Scale(times, Power(by, n - k)) if n > k else times, value))
        below = _times(below, inverse)
    total = Sum(tuple(parts)) if len(parts) > 1 else parts[0]
    return total if growth is None else Scale(exp(Scale(growth, by)), total)


def oscillations_in(node: Node, by: Node) -> dict[Oscillation, Node]:
    """What multiplies each such term in an expression; raises TypeError where it is no sum of them."""
    if by not in walk(node):
        return {} if isinstance(node, Zero) or node == Number(Fraction(0)) else {Oscillation(): node}
    match node:
        case Symbol():
            return {Oscillation(1): Number(Fraction(1))}
        case Group(of):
            return oscillations_in(of, by)
        case Negative() | Transpose() | At() | Skew() | Trace() | Vect():
            return {term: rebuilt(node, (each,)) for term, each in oscillations_in(children(node)[0], by).items()}
        case Quotient(numerator, denominator) if by not in walk(denominator):
            return {term: Quotient(each, denominator) for term, each in oscillations_in(numerator, by).items()}
        case Sum(parts):
            return _added(pair for part in parts for pair in oscillations_in(part, by).items())
        case Block(rows):
            entries = [[(entry, oscillations_in(entry, by)) for entry in row] for row in rows]
            known = dict.fromkeys(term for row in entries for _, found in row for term in found)
            return {
                term: Block(
                    tuple(tuple(found.get(term, zero_of(entry.shape)) for entry, found in row) for row in entries)
                )
                for term in known
            }
        case Power(base, int() as exponent) if 0 < exponent <= LARGEST_DEGREE:
            return oscillations_in(reduce(Scale if base.is_scalar else _contracted, [base] * exponent), by)
        case Scale() | Contract() | Dot() | Cross():
            return _added(_products(node, [oscillations_in(part, by) for part in children(node)]))
        case Call("cos" | "sin" as function, argument):
            rate, rest = _linear(argument, by)
            sine = function == "sin"
            shifted = (sine, cos(rest)), (not sine, sin(rest) if sine else Negative(sin(rest)))
            found = [(Oscillation(turn=rate, sine=kind).turned, each) for kind, each in shifted]
            return _added((told[1], Scale(lifted(told[0]), each)) for told, each in found if told)
        case FunctionOf("exp", (argument,)):
            rate, rest = _linear(argument, by)
            return {Oscillation(growth=rate): exp(rest)}
        case FunctionOf("cosh" | "sinh" as function, (argument,)):
            sign = 1 if function == "cosh" else -1
            return oscillations_in(
                Quotient(Sum((exp(argument), Scale(lifted(sign), exp(Negative(argument))))), lifted(2)), by
            )
    raise TypeError(
        f"{node} is no polynomial in {by}, nor one in exponentials, cosines and sines of its multiples: "
        "only such are integrated between limits"
    )


def _products(node: Node, found: list[dict[Oscillation, Node]]) -> Iterator[tuple[Oscillation, Node]]:
    for chosen in product(*(each.items() for each in found)):
        of = rebuilt(node, tuple(each for _, each in chosen))
        sums: dict[Oscillation, Fraction] = {Oscillation(): Fraction(1)}
        for term, _ in chosen:
            told: dict[Oscillation, Fraction] = {}
            for known, times in sums.items():
                for share, each in multiplied(known, term):
                    told[each] = told.get(each, Fraction(0)) + times * share
            sums = told
        yield from ((term, of if times == 1 else Scale(Number(times), of)) for term, times in sums.items() if times)


def _linear(argument: Node, by: Node) -> tuple[Rate, Node]:
    """By what a symbol is multiplied in the argument of a function, and the rest of it."""
    found = oscillations_in(argument, by)
    if not found.keys() <= {Oscillation(), Oscillation(1)}:
        raise TypeError(f"{argument} is no multiple of {by} and a rest: only such are integrated between limits")
    return _polynomial(found.get(Oscillation(1), lifted(0))), found.get(Oscillation(), lifted(0))


def _polynomial(node: Node) -> Rate:
    """An expression as a polynomial in what is neither a sum nor a product, multiplied out."""
    match node:
        case Number(value):
            return (((), value),) if value else ()
        case Group(of):
            return _polynomial(of)
        case Negative(of):
            return _added_rates((), _polynomial(of), -1)
        case Sum(parts):
            return reduce(_added_rates, map(_polynomial, parts), ())
        case Scale(one, other) if node.is_scalar:
            pairs = product(_polynomial(one), _polynomial(other))
            return reduce(_added_rates, ((_raised(a, b, x * y),) for (a, x), (b, y) in pairs), ())
        case Quotient(above, below) if len(divisor := _polynomial(below)) == 1:
            ((by, value),) = divisor
            inverse = tuple((atom, -exponent) for atom, exponent in by)
            return _added_rates((), tuple(_raised(each, inverse, times / value) for each, times in _polynomial(above)))
        case Power(base, int() as exponent) if 0 < exponent <= LARGEST_DEGREE:
            return _polynomial(reduce(Scale, [base] * exponent))
        case _:
            return ((((node, 1),), Fraction(1)),)


def _raised(one: Monomial, other: Monomial, times: Fraction) -> tuple[Monomial, Fraction]:
    found: dict[Node, int] = {}
    for atom, exponent in (*one, *other):
        found[atom] = found.get(atom, 0) + exponent
    powers = ((atom, exponent) for atom, exponent in found.items() if exponent)
    return tuple(sorted(powers, key=lambda pair: str(pair[0]))), times


def _added_rates(one: Rate, other: Rate, sign: int = 1) -> Rate:
    found = dict(one)
    for monomial, times in other:
        found[monomial] = found.get(monomial, Fraction(0)) + sign * times
    return tuple(sorted(((each, times) for each, times in found.items() if times), key=str))


def _combined(rate: Rate) -> Node | None:
    """The polynomial as an expression; None for zero."""
    terms: list[Node] = []
    for monomial, times in rate:
        above = [Power(atom, exponent) if exponent > 1 else atom for atom, exponent in monomial if exponent > 0]
        below = [Power(atom, -exponent) if exponent < -1 else atom for atom, exponent in monomial if exponent < 0]
        node = reduce(Scale, above if above and times == 1 else [Number(times), *above])
        terms.append(Quotient(node, reduce(Scale, below)) if below else node)
    return None if not terms else terms[0] if len(terms) == 1 else Sum(tuple(terms))


def _require_letters(*rates: Rate) -> None:
    """Raise TypeError where it is not seen whether what is added is zero: of letters it is."""
    strange = next((a for rate in rates for m, _ in rate for a, _ in m if not isinstance(a, Symbol)), None)
    if all(rates) and strange is not None:
        raise TypeError(f"it is not seen whether what {strange} is in is zero: it is not integrated between limits")


def _times(one: Complex, other: Complex) -> Complex:
    (a, b), (c, d) = one, other
    real, imaginary = (_product(a, c), _product(b, d)), (_product(a, d), _product(b, c))
    return _sum(real[0], None if real[1] is None else Negative(real[1])), _sum(*imaginary)


def _product(one: Node | None, other: Node | None) -> Node | None:
    return None if one is None or other is None else Scale(one, other)


def _sum(one: Node | None, other: Node | None) -> Node | None:
    return other if one is None else one if other is None else Sum((one, other))


def _added(found: Iterable[tuple[Oscillation, Node]]) -> dict[Oscillation, Node]:
    terms: dict[Oscillation, list[Node]] = {}
    for term, each in found:
        terms.setdefault(term, []).append(each)
    return {term: Sum(tuple(same)) if len(same) > 1 else same[0] for term, same in terms.items()}


def _contracted(one: Node, other: Node) -> Node:
    return Contract((one, other))
