"""Words for words, before any step is made.

Transposes are carried to the symbols, rates to the symbols' rates; cosines and sines of an angle that is known by its
own cosine and sine become polynomials in these.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from chasles.lowering.refusal import LoweringError
from chasles.proof.variables import Untreatable, angle_multiples
from chasles.vocabulary import (
    At,
    Block,
    Call,
    Contract,
    Cross,
    Dot,
    Group,
    Identity,
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
    children,
    plain,
    rebuilt,
)

__all__ = ["Angle", "flipped", "rate_of", "without_angles"]


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


def rate_of(node: Node) -> Node:
    """The time derivative of an expression by the rates of its parts.

    Raises `LoweringError` for what has no such rule: symbols, inverses, determinants.
    """
    match node:
        case Number() | Identity() | Zero():
            return Zero(*node.shape)
        case Sum(terms):
            return Sum(tuple(map(Rate, terms)))
        case Negative(term):
            return Negative(Rate(term))
        case Scale(factor, term):
            return Sum((Scale(Rate(factor), term), Scale(factor, Rate(term))))
        case Quotient(numerator, denominator):
            return Quotient(Sum((Rate(numerator), Negative(Scale(Rate(denominator), node)))), denominator)
        case Contract(factors):
            return Sum(tuple(Contract((*factors[:k], Rate(f), *factors[k + 1 :])) for k, f in enumerate(factors)))
        case Power(Norm(of), exponent) if exponent % 2 == 0:
            square: Node = Dot(of, of)
            return Rate(square if exponent == 2 else Power(square, exponent // 2))
        case Power(base, exponent) if node.is_scalar:
            below = Number(Fraction(1)) if exponent == 1 else Power(base, exponent - 1)
            return Scale(Number(Fraction(exponent)), Scale(below, Rate(base)))
        case Power(base, exponent):
            return rate_of(Contract((base,) * exponent))
        case Transpose() | Skew() | Vect() | Trace() | Block():
            return rebuilt(node, tuple(map(Rate, children(node))))
        case At(of, "t") | Group(of):
            return Rate(of)
        case _:
            return _rate_of_scalar_or_vector(node)


def _rate_of_scalar_or_vector(node: Node) -> Node:
    match node:
        case Dot(left, right):
            return Sum((Dot(Rate(left), right), Dot(left, Rate(right))))
        case Cross(left, right):
            return Sum((Cross(Rate(left), right), Cross(left, Rate(right))))
        case Norm(of):
            return Quotient(Dot(of, Rate(of)), node)
        case Call("sin", argument):
            return Scale(Call("cos", argument), Rate(argument))
        case Call("cos", argument):
            return Negative(Scale(Call("sin", argument), Rate(argument)))
        case _:
            raise LoweringError(f"the rate of {plain(node)} has no program: state it in the rates of symbols")


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
