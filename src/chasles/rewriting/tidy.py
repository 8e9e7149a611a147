"""Computed expressions tidied: factors of one and terms of zero left out, signs moved to the front."""

from __future__ import annotations

from fractions import Fraction

from chasles.rewriting.coefficients import added, negated
from chasles.vocabulary import Contract, Negative, Node, Number, Quotient, Scale, Sum, Zero
from chasles.vocabulary.letters import zero_of
from chasles.vocabulary.tree import with_parts


def tidied(node: Node) -> Node:
    """The same expression without factors of one and terms of zero, each sign before its product."""
    node = with_parts(node, tidied)
    match node:
        case Scale(factor, term) if _zero(factor) or _zero(term):
            return zero_of(node.shape)
        case Scale(Number(value), term) if value == 1:
            return term
        case Scale(Negative(factor), term):
            return tidied(Negative(tidied(Scale(factor, term))))
        case Contract(factors) if any(map(_zero, factors)):
            return zero_of(node.shape)
        case Contract((Scale(factor, term), *others)):
            return Scale(factor, Contract((term, *others)))
        case Quotient(above, _) if _zero(above):
            return zero_of(node.shape)
        case Negative(Negative(term)):
            return term
        case Negative(Sum(terms)):
            return Sum(tuple(tidied(Negative(term)) for term in terms))
        case Negative(term) if _zero(term):
            return zero_of(node.shape)
        case Sum(terms):
            kept = _without_opposites([term for term in terms if not _zero(term)])
            return added(kept) if kept else zero_of(node.shape)
    return node


def _without_opposites(terms: list[Node]) -> list[Node]:
    kept: list[Node] = []
    for term in terms:
        if negated(term) in kept:
            kept.remove(negated(term))
        else:
            kept.append(term)
    return kept


def _zero(node: Node) -> bool:
    return isinstance(node, Zero) or node == Number(Fraction(0))
