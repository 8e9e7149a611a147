"""Expressions rewritten before any step is made of them.

Transposes are carried to the symbols; cosines and sines of an angle that is known by its
own cosine and sine become polynomials in these.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from chasles import vocabulary as w
from chasles.lowering.refusal import LoweringError
from chasles.problems.variables import Untreatable, angle_multiples
from chasles.vocabulary.tree import with_inner


@dataclass(frozen=True, slots=True)
class Angle:
    """`times` the angle, in (-pi, pi], whose cosine and sine are given; these lie on the unit circle."""

    cosine: w.Node
    sine: w.Node
    times: Fraction = Fraction(1)


def flipped(node: w.Node) -> w.Node:
    """The transpose, carried inwards as far as it goes."""
    match node:
        case _ if node.is_scalar:
            return node
        case w.Transpose(of):
            return of
        case w.Sum(terms):
            return w.Sum(tuple(map(flipped, terms)))
        case w.Negative(term):
            return w.Negative(flipped(term))
        case w.Scale(factor, term):
            return w.Scale(factor, flipped(term))
        case w.Quotient(numerator, denominator):
            return w.Quotient(flipped(numerator), denominator)
        case w.Contract(factors):
            return w.Contract(tuple(flipped(factor) for factor in reversed(factors)))
        case w.Block(rows):
            return w.Block(tuple(tuple(map(flipped, column)) for column in zip(*rows, strict=True)))
        case w.Zero(rows, columns):
            return w.Zero(columns, rows)
        case w.Skew():
            return w.Negative(node)
        case w.Identity():
            return node
        case w.At(of, "t") | w.Group(of):
            return flipped(of)
        case _:
            return w.Transpose(node)


def without_angles(node: w.Node, angles: Mapping[w.Symbol, Angle], rules: Mapping[w.Node, w.Node]) -> w.Node:
    """The expression with cosines and sines of the given angles written by what these are known by.

    Raises `LoweringError` where a fraction of such an angle occurs.
    """
    if not angles:
        return node
    if isinstance(node, w.Call):
        try:
            multiples = angle_multiples(node.argument, rules)
        except Untreatable as error:
            raise LoweringError(str(error)) from None
        return _circular(node, multiples, angles) if set(multiples) & set(angles) else node
    return with_inner(node, lambda part: without_angles(part, angles, rules))


def _circular(node: w.Call, multiples: Mapping[w.Symbol, Fraction], angles: Mapping[w.Symbol, Angle]) -> w.Node:
    """The cosine or sine of a sum of angles, by the addition formulas."""
    rest = tuple(w.Scale(w.Number(q), symbol) for symbol, q in multiples.items() if symbol not in angles)
    total: tuple[w.Node, w.Node] | None = None
    if rest:
        other = rest[0] if len(rest) == 1 else w.Sum(rest)
        total = w.Call("cos", other), w.Call("sin", other)
    for symbol, multiple in multiples.items():
        if symbol not in angles:
            continue
        angle = angles[symbol]
        times = multiple * angle.times
        if times.denominator != 1:
            raise LoweringError(
                f"{w.plain(node)} needs a fraction of the angle that is known by {w.plain(angle.cosine)} and "
                f"{w.plain(angle.sine)}: give the cosine and sine of that fraction instead"
            )
        step = (angle.cosine, angle.sine if times > 0 else w.Negative(angle.sine))
        for _ in range(abs(times.numerator)):
            total = step if total is None else _turned(total, step)
    assert total is not None
    return total[0] if node.function == "cos" else total[1]


def _turned(one: tuple[w.Node, w.Node], other: tuple[w.Node, w.Node]) -> tuple[w.Node, w.Node]:
    (c, s), (d, t) = one, other
    return w.Sum((w.Scale(c, d), w.Negative(w.Scale(s, t)))), w.Sum((w.Scale(s, d), w.Scale(c, t)))
