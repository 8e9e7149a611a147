"""Expressions rewritten before any step is made of them.

Transposes are carried to the symbols; cosines and sines of an angle that is known by its
own cosine and sine become polynomials in these.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from chasles.lowering.refusal import LoweringError
from chasles.problems.variables import Untreatable, angle_multiples
from chasles.vocabulary import (
    At,
    Block,
    Call,
    Contract,
    Group,
    Identity,
    Negative,
    Node,
    Number,
    Quotient,
    Scale,
    Skew,
    Sum,
    Symbol,
    Transpose,
    Zero,
    children,
    plain,
    rebuilt,
)


@dataclass(frozen=True, slots=True)
class Angle:
    """`times` the angle, in (-pi, pi], whose cosine and sine are given; these lie on the unit circle."""

    cosine: Node
    sine: Node
    times: Fraction = Fraction(1)


def flipped(node: Node) -> Node:
    """The transpose, carried inwards as far as it goes."""
    match node:
        case _ if node.is_scalar:
            return node
        case Transpose(of):
            return of
        case Sum(terms):
            return Sum(tuple(map(flipped, terms)))
        case Negative(term):
            return Negative(flipped(term))
        case Scale(factor, term):
            return Scale(factor, flipped(term))
        case Quotient(numerator, denominator):
            return Quotient(flipped(numerator), denominator)
        case Contract(factors):
            return Contract(tuple(flipped(factor) for factor in reversed(factors)))
        case Block(rows):
            return Block(tuple(tuple(map(flipped, column)) for column in zip(*rows, strict=True)))
        case Zero(rows, columns):
            return Zero(columns, rows)
        case Skew():
            return Negative(node)
        case Identity():
            return node
        case At(of, "t") | Group(of):
            return flipped(of)
        case _:
            return Transpose(node)


def without_angles(node: Node, angles: Mapping[Symbol, Angle], rules: Mapping[Node, Node]) -> Node:
    """The expression with cosines and sines of the given angles written by what these are known by.

    Raises `LoweringError` where a fraction of such an angle occurs.
    """
    if not angles:
        return node
    if isinstance(node, Call):
        try:
            multiples = angle_multiples(node.argument, rules)
        except Untreatable as error:
            raise LoweringError(str(error)) from None
        return _circular(node, multiples, angles) if set(multiples) & set(angles) else node
    if isinstance(node, Symbol) and node.stands_for is not None:
        inner = without_angles(node.stands_for, angles, rules)
        return node if inner == node.stands_for else inner
    parts = children(node)
    changed = tuple(without_angles(part, angles, rules) for part in parts)
    return node if changed == parts else rebuilt(node, changed)


def _circular(node: Call, multiples: Mapping[Symbol, Fraction], angles: Mapping[Symbol, Angle]) -> Node:
    """The cosine or sine of a sum of angles, by the addition formulas."""
    rest = tuple(Scale(Number(q), symbol) for symbol, q in multiples.items() if symbol not in angles)
    total: tuple[Node, Node] | None = None
    if rest:
        other = rest[0] if len(rest) == 1 else Sum(rest)
        total = Call("cos", other), Call("sin", other)
    for symbol, multiple in multiples.items():
        if symbol not in angles:
            continue
        angle = angles[symbol]
        times = multiple * angle.times
        if times.denominator != 1:
            raise LoweringError(
                f"{plain(node)} needs a fraction of the angle that is known by {plain(angle.cosine)} and "
                f"{plain(angle.sine)}: give the cosine and sine of that fraction instead"
            )
        step = (angle.cosine, angle.sine if times > 0 else Negative(angle.sine))
        for _ in range(abs(times.numerator)):
            total = step if total is None else _turned(total, step)
    assert total is not None
    return total[0] if node.function == "cos" else total[1]


def _turned(one: tuple[Node, Node], other: tuple[Node, Node]) -> tuple[Node, Node]:
    (c, s), (d, t) = one, other
    return Sum((Scale(c, d), Negative(Scale(s, t)))), Sum((Scale(s, d), Scale(c, t)))
