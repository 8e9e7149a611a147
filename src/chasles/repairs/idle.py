"""What nobody would have printed: products that are zero or one, factors and terms that cancel each other."""

from __future__ import annotations

from collections.abc import Container
from itertools import pairwise

from chasles import vocabulary as w
from chasles.rewriting.coefficients import negated, split
from chasles.vocabulary import Node
from chasles.vocabulary.functions import FunctionOf

ORTHOGONAL = ("rotation", "half_turn", "orthogonal")
"""The hypotheses that say of a matrix that its transpose is its inverse."""


def idle_parts(node: Node, orthogonal: Container[Node] = ()) -> int:
    """How many parts of an expression have no effect: a x a, t - 2 t, c (1/c), and R R^T of what is `orthogonal`."""
    return sum(1 for part in w.walk(node) if _is_idle(part, orthogonal))


def _is_idle(part: Node, orthogonal: Container[Node]) -> bool:
    match part:
        case w.Cross(one, other):
            return one == other
        case w.Sum():
            cores = [split(term, lambda scalar: isinstance(scalar, w.Number)).core for term in _terms(part)]
            return len(set(cores)) < len(cores)
        case w.Quotient(w.Scale(w.Number(), _), w.Number()):
            return True
        case w.Scale(w.Number(), w.Scale(w.Number()) | w.Number()) | FunctionOf("sqrt", (w.Number(),)):
            return True
        case w.Scale(factor, w.Quotient(_, divisor)):
            return _base(factor) == _base(divisor)
        case w.Contract(factors):
            return any(_vanish(one, other, orthogonal) for one, other in pairwise(factors))
        case _:
            return False


def _terms(node: Node) -> list[Node]:
    """The terms of a sum, those in brackets one by one."""
    match node:
        case w.Sum(terms):
            return [inner for term in terms for inner in _terms(term)]
        case w.Group(of):
            return _terms(of)
        case w.Negative(of):
            return [negated(inner) for inner in _terms(of)]
        case _:
            return [node]


def _base(node: Node) -> Node:
    return node.base if isinstance(node, w.Power) else node


def _vanish(one: Node, other: Node, orthogonal: Container[Node]) -> bool:
    """Whether the product of two factors is seen to be zero, or the identity."""
    pairs = ((one, other), (other, one))
    if any(a == w.Transpose(b) and b in orthogonal for a, b in pairs) or (isinstance(one, w.Skew) and one.of == other):
        return True
    return any(isinstance(a, w.Inverse) and a.of == b for a, b in pairs)
