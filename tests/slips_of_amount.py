"""Slips of the pen at one node that change how much something is: signs, numbers, terms, factors, rates, angles."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction

from chasles.vocabulary import (
    Block,
    Call,
    Contract,
    Cross,
    Dot,
    Group,
    Negative,
    Node,
    Number,
    Power,
    Quotient,
    Rate,
    Scale,
    Sum,
    Zero,
    rebuilt,
    symbols_of,
    walk,
)

__all__ = [
    "Slip",
    "angles",
    "circular",
    "doubled",
    "factors",
    "is_zero",
    "left_out",
    "numbers",
    "rates",
    "signs",
    "turned",
    "twice",
    "with_block",
]

Slip = tuple[str, Node]
"""What kind of slip it is, and what stands there then."""


def turned(term: Node) -> Node:
    return term.term if isinstance(term, Negative) else Negative(term)


def is_zero(node: Node) -> bool:
    """Whether it is spelled as zero."""
    return isinstance(node, Zero) or node == Number(Fraction(0))


def signs(node: Node) -> Iterator[Slip]:
    match node:
        case Sum(terms):
            for place, term in enumerate(terms):
                yield "sign", Sum((*terms[:place], turned(term), *terms[place + 1 :]))
        case Block(rows):
            for i, row in enumerate(rows):
                for j, block in enumerate(row):
                    if not isinstance(block, Sum | Block) and not is_zero(block):
                        yield "sign", with_block(rows, i, j, turned(block))


def with_block(rows: tuple[tuple[Node, ...], ...], i: int, j: int, block: Node) -> Block:
    """The blocks with another one in a place."""
    row = (*rows[i][:j], block, *rows[i][j + 1 :])
    return Block((*rows[:i], row, *rows[i + 1 :]))


def left_out(node: Node) -> Iterator[Slip]:
    if isinstance(node, Sum):
        for place in range(len(node.terms)):
            rest = node.terms[:place] + node.terms[place + 1 :]
            yield "term left out", rest[0] if len(rest) == 1 else Sum(rest)


def doubled(node: Node) -> Iterator[Slip]:
    """A factor of two too much."""
    match node:
        case Sum(terms):
            for place, term in enumerate(terms):
                yield "factor of two", Sum((*terms[:place], twice(term), *terms[place + 1 :]))
        case Block(rows):
            for i, row in enumerate(rows):
                for j, block in enumerate(row):
                    if not isinstance(block, Sum | Block) and not is_zero(block):
                        yield "factor of two", with_block(rows, i, j, twice(block))


def twice(term: Node) -> Node:
    """The term with a factor of two, its sign in front."""
    return Negative(twice(term.term)) if isinstance(term, Negative) else Scale(Number(Fraction(2)), term)


def factors(node: Node) -> Iterator[Slip]:
    """A factor or a divisor left out, a factor divided by, a divisor multiplied with, brackets left out."""
    match node:
        case Scale(factor, term):
            yield "factor left out", term
            if symbols_of(factor) and not any(isinstance(part, Quotient) for part in walk(factor)):
                yield "divided, not multiplied", Quotient(term, factor)
            yield from _without_brackets(term, lambda part: Scale(factor, part, node.trailing))
        case Quotient(numerator, denominator):
            yield "factor left out", numerator
            if symbols_of(denominator):
                yield "multiplied, not divided", Scale(denominator, numerator)
            yield from _without_brackets(numerator, lambda part: Quotient(part, denominator, node.slash))
        case Contract(parts):
            for k in range(len(parts)):
                rest = parts[:k] + parts[k + 1 :]
                yield "factor left out", rest[0] if len(rest) == 1 else Contract(rest)
            for k, part in enumerate(parts):
                if not isinstance(part, Block):
                    yield from _without_brackets(part, lambda x, k=k: Contract((*parts[:k], x, *parts[k + 1 :])))
        case Cross(left, right):
            yield from _without_brackets(left, lambda part: Cross(part, right))
            yield from _without_brackets(right, lambda part: Cross(left, part))
        case Dot(left, right):
            yield from _without_brackets(left, lambda part: Dot(part, right))
            yield from _without_brackets(right, lambda part: Dot(left, part))


def _without_brackets(whole: Node, times: Callable[[Node], Node]) -> Iterator[Slip]:
    """What stands before or behind brackets, with the nearest of the terms alone."""
    while isinstance(whole, Group):
        whole = whole.of
    if isinstance(whole, Sum):
        first, *rest = whole.terms
        *start, last = whole.terms
        yield "brackets left out", Sum((_signed(first, times), *rest))
        if len(whole.terms) > 1:
            yield "brackets left out", Sum((*start, _signed(last, times)))


def _signed(part: Node, times: Callable[[Node], Node]) -> Node:
    return Negative(times(part.term)) if isinstance(part, Negative) else times(part)


def rates(node: Node) -> Iterator[Slip]:
    """A dot left out, or over the other factor of a product."""
    match node:
        case Rate(of):
            yield "rate left out", of
        case Scale(left, right) | Cross(left, right) | Dot(left, right) | Contract((left, right)):
            if isinstance(left, Rate) != isinstance(right, Rate):
                moved = (left.of, Rate(right)) if isinstance(left, Rate) else (Rate(left), right.of)
                yield "rate of the other factor", rebuilt(node, moved)


def circular(node: Node) -> Iterator[Slip]:
    if isinstance(node, Call):
        yield "sine and cosine", Call({"sin": "cos", "cos": "sin"}[node.function], node.argument)


def angles(node: Node) -> Iterator[Slip]:
    """Half of an angle for the angle; the angle for half of it comes from leaving out the divisor."""
    if isinstance(node, Call):
        yield "half of the angle", Call(node.function, Quotient(node.argument, Number(Fraction(2))))


def numbers(node: Node) -> Iterator[Slip]:
    match node:
        case Number(value):
            yield "number", Number(value + 1)
            if value > 1:
                yield "number", Number(value - 1)
        case Power(base, exponent):
            yield "exponent", Power(base, exponent + 1)
            if exponent > 1:
                yield "exponent", base if exponent == 2 else Power(base, exponent - 1)
