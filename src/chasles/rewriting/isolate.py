"""An equation solved for one of its terms, and a product taken apart at its last factor."""

from __future__ import annotations

from dataclasses import replace as with_fields

from chasles.rewriting.coefficients import added
from chasles.rewriting.matching import occurs
from chasles.rewriting.product import Product, spelled_out
from chasles.rewriting.products import multiplied_out, products
from chasles.vocabulary import Block, Cross, Dot, Negative, Node, Quotient, Scale, Skew, Sum, Transpose


class CannotIsolate(ValueError):
    """The equation has no term, or several, with what is sought, or it is deeper inside."""


def alone(unknown: Node, left: Node, right: Node) -> tuple[Node, Node]:
    """Left - right as a coefficient times unknown - value: the value and the coefficient.

    Raises `CannotIsolate` unless exactly one term is a scalar multiple of the unknown.
    """
    terms = products(Sum((left, Negative(right))))
    mine = [p for p in terms if any(occurs(unknown, part) for part in (*p.scalars, *p.divisors, *p.factors))]
    if len(mine) != 1:
        raise CannotIsolate(f"{unknown} occurs in {len(mine)} terms of {left} = {right}: say by what to multiply it")
    (own,) = mine
    if own.factors == (unknown,):
        scalars = list(own.scalars)
    elif unknown in own.scalars and not own.factors:
        scalars = list(own.scalars)
        scalars.remove(unknown)
    else:
        raise CannotIsolate(f"{unknown} is not alone in {left} = {right}: say by what to multiply it")
    rest = [with_fields(p, number=-p.number / own.number) for p in terms if p != own]
    value = spelled_out(rest, unknown.shape)
    for divisor in own.divisors:
        value = Scale(divisor, value)
    for scalar in scalars:
        value = Quotient(value, scalar)
    coefficient = spelled_out([with_fields(own, scalars=tuple(scalars), factors=(), shape=(1, 1))], (1, 1))
    return (multiplied_out(value) if own.divisors else value), coefficient


def before(factor: Node, node: Node) -> Node:
    """What multiplies the factor at the end of every term; raises `CannotIsolate` for a term that does not end so."""
    if isinstance(node, Block):
        return Block(tuple((added([before(factor, block) for block in row]),) for row in node.rows))
    terms = products(node)
    return added([spelled_out([_before(factor, p)], (p.shape[0], factor.shape[0])) for p in terms])


def _before(factor: Node, p: Product) -> Product:
    shape = (p.shape[0], factor.shape[0])
    match p.factors:
        case (*others, last) if last == factor:
            return with_fields(p, factors=tuple(others), shape=shape)
        case (*others, Cross(left, right)) if right == factor:
            return with_fields(p, factors=(*others, Skew(left)), shape=shape)
        case (*others, Cross(left, right)) if left == factor:
            return with_fields(p, number=-p.number, factors=(*others, Skew(right)), shape=shape)
    for k, scalar in enumerate(p.scalars):
        if isinstance(scalar, Dot) and factor in (scalar.left, scalar.right):
            other = scalar.left if scalar.right == factor else scalar.right
            scalars = (*p.scalars[:k], *p.scalars[k + 1 :])
            return with_fields(p, scalars=scalars, factors=(*p.factors, Transpose(other)), shape=shape)
    raise CannotIsolate(f"{spelled_out([p], p.shape)} does not end with {factor}")
