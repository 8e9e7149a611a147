"""Rates carried out in words: the rules of differentiation, as a reader applies them."""

from __future__ import annotations

from fractions import Fraction

from chasles.rewriting.coefficients import added
from chasles.vocabulary import (
    At,
    Block,
    Call,
    Contract,
    Cross,
    Dot,
    Group,
    Identity,
    Integral,
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
    cos,
    rebuilt,
    sin,
)

__all__ = ["carried_out", "rate_of"]


def carried_out(node: Node) -> Node:
    """The expression with every rate taken as far as the rules go; rates of symbols stay as they are."""
    if isinstance(node, Rate):
        inner = carried_out(node.of)
        return Rate(inner) if isinstance(inner, Symbol | Rate) else rate_of(inner)
    parts = node._parts()
    changed = tuple(map(carried_out, parts))
    return node if changed == parts else rebuilt(node, changed)


def rate_of(node: Node) -> Node:
    """The time derivative of an expression, by the rules for sums, products, quotients and functions."""
    match node:
        case Number() | Identity() | Zero() | Symbol(constant=True):
            return Zero(*node.shape)
        case Symbol() | Rate():
            return Rate(node)
        case Sum(terms):
            return added([rate_of(term) for term in terms])
        case Contract(factors):
            return _product(node, factors)
        case Scale(factor, term):
            return _sum(_times(rate_of(factor), term), _times(factor, rate_of(term)))
        case Quotient(above, below):
            first = _over(rate_of(above), below)
            change = rate_of(below)
            return first if isinstance(change, Zero) else _sum(first, _minus(_times(change / below**2, above)))
        case Power(base, exponent):
            return _product(node, (base,) * exponent) if not base.is_scalar else _power(base, exponent)
        case Call(function, argument):
            speed = rate_of(argument)
            return _times(speed, cos(argument)) if function == "sin" else _minus(_times(speed, sin(argument)))
        case Norm(of):
            return _over(_binary(Dot, of, rate_of(of)), node)
        case Dot(left, right) | Cross(left, right):
            kind = type(node)
            return _sum(_binary(kind, rate_of(left), right), _binary(kind, left, rate_of(right)))
        case Block(rows):
            return Block(tuple(tuple(rate_of(block) for block in row) for row in rows))
        case Negative() | Transpose() | Skew() | Vect() | Trace() | Integral() | At() | Group():
            inner = rate_of(node._parts()[0])
            return Zero(*node.shape) if isinstance(inner, Zero) else rebuilt(node, (inner,))
        case _:
            return Rate(node)


def _product(node: Node, factors: tuple[Node, ...]) -> Node:
    terms = []
    for k, factor in enumerate(factors):
        change = rate_of(factor)
        if not isinstance(change, Zero):
            terms.append(Contract((*factors[:k], change, *factors[k + 1 :])))
    return added(terms) if terms else Zero(*node.shape)


def _power(base: Node, exponent: int) -> Node:
    below = base if exponent == 2 else base ** (exponent - 1)
    return _times(Scale(Number(Fraction(exponent)), below), rate_of(base))


def _times(factor: Node, term: Node) -> Node:
    if isinstance(factor, Zero) or isinstance(term, Zero):
        return Zero(*term.shape)
    return Scale(factor, term)


def _over(above: Node, below: Node) -> Node:
    return above if isinstance(above, Zero) else Quotient(above, below)


def _minus(node: Node) -> Node:
    return node if isinstance(node, Zero) else Negative(node)


def _sum(one: Node, other: Node) -> Node:
    return added([one, other])


def _binary(kind: type[Dot] | type[Cross], left: Node, right: Node) -> Node:
    if isinstance(left, Zero) or isinstance(right, Zero):
        return Zero(*((1, 1) if kind is Dot else left.shape))
    return kind(left, right)
