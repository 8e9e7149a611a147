"""Words for declared statements: random ones, the same in other words, with a slip, and rates by the product rule."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from random import Random

from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    NO_DIMENSION,
    Contract,
    Cross,
    Dot,
    Identity,
    Negative,
    Node,
    Number,
    Rate,
    Scale,
    Sum,
    Symbol,
    Trace,
    Transpose,
    Zero,
    cross,
    dot,
    scalar,
    square,
    tr,
    vector,
)

__all__ = ["NOTHING", "ONE", "named", "random_vector", "same", "scaled", "slipped", "spun"]

ONE = Identity(3)
NOTHING = Number(Fraction(0))
MAKE = {"scalar": scalar, "vector": vector, "square": square}


def named(kind: str, name: str, order: int = 0, constant: bool = False) -> Symbol:
    """A symbol with the dimension of a rate of this order of something without dimension."""
    dimension = NO_DIMENSION
    for _ in range(order):
        dimension = dimension * FREQUENCY
    return MAKE[kind](name, name, "", dimension, constant=constant)


def random_vector(draw: Random, vectors: Sequence[Node], depth: int = 2) -> Node:
    """A vector made of the given ones, all without dimension."""
    one = draw.choice(vectors)
    if depth <= 0:
        return one
    other = random_vector(draw, vectors, depth - 1)
    third = draw.choice(vectors)
    return draw.choice(
        (cross(one, other), one + other, one - other, dot(one, other) * third, CPM(one) @ other, 2 * one, -other)
    )


def scaled(node: Node, draw: Random, vectors: Sequence[Node]) -> Node:
    """Something that is nothing where the word is, without further dimension."""
    other = draw.choice(vectors)
    if node.is_scalar:
        return draw.choice((node, node * other, node * dot(other, draw.choice(vectors)), -node))
    if node.shape == (3, 1):
        return draw.choice((node, cross(other, node), dot(node, other), 3 * node))
    return draw.choice((node, node @ other, node.T, tr(node), node @ CPM(other)))


def same(node: Node, draw: Random) -> Node:
    """The word in other words."""
    if node.shape == (3, 1):
        return draw.choice((ONE @ node, node + Zero(3, 1), Negative(-node), node, node.T.T, node + node - node))
    if node.shape == (3, 3):
        return draw.choice((ONE @ node, node.T.T, node + Zero(3, 3), node))
    return draw.choice((node, node + node - node, Negative(-node), 2 * node - node))


def slipped(node: Node, draw: Random) -> Node:
    """The word with a slip, of the same shape and dimension."""
    return draw.choice((-node, 2 * node, node.T if node.shape == (3, 3) else 3 * node, node - 2 * node))


def spun(node: Node, rates: Mapping[Node, Node]) -> Node:
    """The time derivative by the product rule, with names for the rates that have them."""
    if node in rates:
        return rates[node]
    match node:
        case Number():
            return NOTHING
        case Symbol(constant=True) | Identity() | Zero():
            return NOTHING if node.is_scalar else Zero(*node.shape)
        case Sum(terms):
            return Sum(tuple(spun(term, rates) for term in terms))
        case Negative(of) | Transpose(of) | Trace(of):
            return type(node)(spun(of, rates))
        case Dot(one, other) | Cross(one, other) | Scale(one, other):
            make = type(node)
            return make(spun(one, rates), other) + make(one, spun(other, rates))
        case Contract(factors):
            return Sum(
                tuple(Contract((*factors[:k], spun(f, rates), *factors[k + 1 :])) for k, f in enumerate(factors))
            )
    return Rate(node)
