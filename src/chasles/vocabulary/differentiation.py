"""The rules of differentiation: the rate of a sum, a product, a quotient or a function by the rates of its parts."""

from __future__ import annotations

from fractions import Fraction

from chasles.vocabulary.layout import At, Block, Call, Group, Rate
from chasles.vocabulary.letters import Identity, Zero
from chasles.vocabulary.nodes import Contract, Negative, Node, Number, Power, Quotient, Scale, Sum, Transpose
from chasles.vocabulary.plain import plain
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.spatial import Cross, Dot, Norm, Skew, Trace, Vect
from chasles.vocabulary.tree import children, rebuilt


class NoRule(TypeError):
    """An expression whose rate is not made of the rates of its parts; the message names it and says what to do."""


def rate_of(node: Node) -> Node:
    """The time derivative of an expression by the rates of its parts.

    Raises `NoRule` for what has no such rule: symbols, inverses, determinants.
    """
    match node:
        case Shorthand():
            return Rate(node.definition)
        case Number() | Identity() | Zero():
            return Zero(*node.shape)
        case Sum(terms):
            return Sum(tuple(map(Rate, terms)))
        case Negative(term):
            return Negative(Rate(term))
        case Scale(factor, term):
            return Sum((Scale(Rate(factor), term), Scale(factor, Rate(term))))
        case Quotient(numerator, denominator):
            falling = Scale(Rate(denominator) / denominator**2, numerator)
            return Sum((Rate(numerator) / denominator, Negative(falling)))
        case Contract(factors):
            return Sum(tuple(Contract((*factors[:k], Rate(f), *factors[k + 1 :])) for k, f in enumerate(factors)))
        case Power(Norm(of), exponent) if exponent % 2 == 0:
            square: Node = Dot(of, of)
            return Rate(square if exponent == 2 else Power(square, exponent // 2))
        case Power(base, 1):
            return Rate(base)
        case Power(base, exponent) if node.is_scalar:
            below = base if exponent == 2 else Power(base, exponent - 1)
            return Scale(Scale(Number(Fraction(exponent)), below), Rate(base))
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
            return Scale(Rate(argument), Call("cos", argument))
        case Call("cos", argument):
            return Negative(Scale(Rate(argument), Call("sin", argument)))
        case _ if (own := node.rate_by_parts()) is not None:
            return own
        case _:
            raise NoRule(f"the rate of {plain(node)} follows no rule: state it in the rates of symbols")
