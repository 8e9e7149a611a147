"""Derivatives by a whole column or matrix, of any size, in words of matrices.

A differential is turned until what varies stands alone: d tr(W^T A X B) is tr((A^T W B^T)^T dX). Source: J. R. Magnus
and H. Neudecker, Matrix Differential Calculus with Applications in Statistics and Econometrics.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce

from chasles.vocabulary.differentiation import NoRule
from chasles.vocabulary.fields import Field
from chasles.vocabulary.functions import DERIVATIVES, FunctionOf
from chasles.vocabulary.layout import At, Block, Call, Group
from chasles.vocabulary.letters import Identity, Zero
from chasles.vocabulary.nodes import Contract, Negative, Node, Number, Power, Quotient, Scale, Sum, Transpose
from chasles.vocabulary.plain import plain
from chasles.vocabulary.sizes import sizes_of
from chasles.vocabulary.spatial import Cofactor, Cross, Determinant, Dot, Inverse, Norm, Skew, Trace, Vect
from chasles.vocabulary.tree import walk

ONE, TWO = Number(Fraction(1)), Number(Fraction(2))
Weighted = tuple[Node, Node]
"""A part, and a weight of its shape: the sum of the products of their entries is what varies."""
Between = tuple[Node | None, Node, Node | None]
"""A part between two factors; None for the identity."""


def derivative_by_whole(of: Node, by: Node) -> Node:
    """Of a scalar by a matrix a matrix of the same shape, by a column a row; of a column by a column the Jacobian.

    Raises `NoRule` for what has no rule of differentiation.
    """
    rules = _Derivative(by)
    if not of.is_scalar:
        return _sum(rules.jacobian(None, of, None), of.shape[0], by.shape[0])
    found = rules.gradient(of)
    return found if by.shape[1] != 1 else Transpose(found)


@dataclass(frozen=True, slots=True)
class _Derivative:
    """Derivatives by one letter."""

    by: Node

    def gradient(self, of: Node) -> Node:
        """The derivatives of a scalar by the entries of the letter, in its shape."""
        return _sum(self._weighted(of, ONE), *self.by.shape)

    def _weighted(self, of: Node, weight: Node) -> Iterator[Node]:
        """What the entries of the letter are weighted with, so that the variation is that of a weighted part."""
        if of == self.by:
            yield weight
        elif self._varies(of):
            for part, its_weight in self._parts(of, weight):
                yield from self._weighted(part, its_weight)

    def _varies(self, node: Node) -> bool:
        places = (place for part in walk(node) if isinstance(part, Field) for place in part.arguments)
        return any(self.by in walk(each) for each in (node, *places))

    def _parts(self, node: Node, weight: Node) -> Iterable[Weighted]:
        match node:
            case Sum(terms):
                return ((term, weight) for term in terms)
            case Negative(of):
                return ((of, Negative(weight)),)
            case Group(of) | At(of, "t"):
                return ((of, weight),)
            case Scale(factor, term):
                return (term, _times(factor, weight)), (factor, _entries(weight, term))
            case Quotient(numerator, divisor):
                falling = Negative(_entries(weight, numerator) / Power(divisor, 2))
                return (numerator, weight / divisor), (divisor, falling)
            case Power(Norm(of), exponent) if exponent % 2 == 0:
                return ((Dot(of, of) if exponent == 2 else Power(Dot(of, of), exponent // 2), weight),)
            case Power(base, exponent) if node.is_scalar:
                return ((base, _times(Number(Fraction(exponent)), Power(base, exponent - 1), weight)),)
            case Power(base, exponent):
                return self._parts(Contract((base,) * exponent), weight)
            case Contract(factors):
                return _factors(factors, weight)
            case Transpose(of):
                return ((of, Transpose(weight)),)
            case Inverse(of):
                turned = Transpose(node)
                return ((of, Negative(_times(turned, weight, turned))),)
            case Block(rows):
                return [(part, _times(above, weight, Transpose(beside))) for above, part, beside in _placed(rows)]
            case _:
                return self._parts_of_scalar(node, weight)

    def _parts_of_scalar(self, node: Node, weight: Node) -> Iterable[Weighted]:
        match node:
            case Trace(of):
                return ((of, Scale(weight, Identity(of.shape[0]))),)
            case Determinant(of) if sizes_of([of]):
                return ((of, _times(weight, node, Transpose(Inverse(of)))),)
            case Determinant(of):
                return ((of, Scale(weight, Cofactor(of))),)
            case Dot(left, right):
                return (left, Scale(weight, right)), (right, Scale(weight, left))
            case Norm(of):
                return ((of, Scale(weight, of / node)),)
            case Cross(left, right):
                return (left, Cross(right, weight)), (right, Cross(weight, left))
            case Skew(of):
                return ((of, Scale(TWO, Vect(weight))),)
            case Vect(of):
                return ((of, Skew(weight) / TWO),)
            case Call(function) | FunctionOf(function) if function in DERIVATIVES:
                slopes = DERIVATIVES[function](*node.below)
                return ((each, _times(slope, weight)) for each, slope in zip(node.below, slopes, strict=True))
            case _:
                raise NoRule(f"the derivative of {plain(node)} by {plain(self.by)} follows no rule")

    def jacobian(self, left: Node | None, node: Node, right: Node | None) -> Iterator[Node]:
        """The derivative of a part between two factors, which make a column of it."""
        if not self._varies(node):
            return
        if node.is_scalar:
            yield _times(left, right, Transpose(self.gradient(node)))
        elif node == self.by:
            yield _times(left, Identity(node.shape[0]) if left is None or left.is_scalar else None, right)
        else:
            for part in self._between(left, node, right):
                yield from self.jacobian(*part)

    def _between(self, left: Node | None, node: Node, right: Node | None) -> Iterable[Between]:
        match node:
            case Sum(terms):
                return ((left, term, right) for term in terms)
            case Negative(of):
                return ((_times(Number(Fraction(-1)), left), of, right),)
            case Group(of) | At(of, "t"):
                return ((left, of, right),)
            case Scale(factor, term):
                return (_times(left, factor), term, right), (_times(left, term, right), factor, None)
            case Quotient(numerator, divisor):
                whole = Negative(_times(left, numerator, right) / Power(divisor, 2))
                return (_times(left, ONE / divisor), numerator, right), (whole, divisor, None)
            case Contract(factors):
                return _around(left, factors, right)
            case Power(base, exponent):
                return _around(left, (base,) * exponent, right)
            case Inverse(of):
                return ((Negative(_times(left, node)), of, _times(node, right)),)
            case Block(rows):
                return [(_times(left, Transpose(above)), part, _times(beside, right))
                        for above, part, beside in _placed(rows)]  # fmt: skip
            case Cross(one, other):
                turned = Negative(Skew(other)), Skew(one)
                return [(_times(left, t), part, right) for t, part in zip(turned, (one, other), strict=True)]
            case Skew(of) if right is not None:
                return ((Negative(_times(left, Skew(right))), of, None),)
            case Transpose(of):
                return (_transposed(left, of, right),)
            case _:
                raise NoRule(f"the derivative of {plain(node)} by {plain(self.by)} follows no rule")


def _times(*factors: Node | None) -> Node:
    """The product, scalars before what they multiply; None is the identity."""
    given = [factor for factor in factors if factor is not None and factor != ONE]
    scalars = [factor for factor in given if factor.is_scalar]
    others = [factor for factor in given if not factor.is_scalar]
    if not others:
        return reduce(Scale, scalars) if scalars else ONE
    product = others[0] if len(others) == 1 else Contract(tuple(others))
    return Scale(reduce(Scale, scalars), product) if scalars else product


def _entries(one: Node, other: Node) -> Node:
    """The sum of the products of the entries of two matrices."""
    if one.is_scalar:
        return _times(one, other)
    product = Contract((Transpose(one), other))
    return product if product.is_scalar else Trace(product)


def _factors(factors: tuple[Node, ...], weight: Node) -> Iterator[Weighted]:
    for left, factor, right in _around(None, factors, None):
        turned = [None if side is None else Transpose(side) for side in (left, right)]
        yield factor, _times(turned[0], weight, turned[1])


def _around(left: Node | None, factors: tuple[Node, ...], right: Node | None) -> Iterator[Between]:
    """Each factor between those before it and those behind it."""
    for k, factor in enumerate(factors):
        before = Contract(factors[:k]) if k else None
        yield _joined(left, before), factor, _joined(Contract(factors[k + 1 :]) if factors[k + 1 :] else None, right)


def _joined(one: Node | None, other: Node | None) -> Node | None:
    return other if one is None else one if other is None else _times(one, other)


def _transposed(left: Node | None, of: Node, right: Node | None) -> Between:
    """A transpose between two factors, with the transposition further inside."""
    match of:
        case _ if of.shape[1] == 1 and right is not None:
            return _times(left, Transpose(right)), of, None
        case Transpose(inner) | Group(Transpose(inner)):
            return left, inner, right
        case Sum(terms):
            return left, Sum(tuple(map(Transpose, terms))), right
        case Negative(inner):
            return left, Negative(Transpose(inner)), right
        case Scale(factor, term):
            return left, Scale(factor, Transpose(term)), right
        case Quotient(numerator, divisor):
            return left, Transpose(numerator) / divisor, right
        case Contract(factors):
            return left, Contract(tuple(map(Transpose, reversed(factors)))), right
        case Power(base, exponent):
            return left, Contract((Transpose(base),) * exponent), right
        case Inverse(inner):
            turned = Transpose(of)
            return Negative(_times(left, turned)), Transpose(inner), _times(turned, right)
        case Skew():
            return left, Negative(of), right
        case Block(rows):
            return left, Block(tuple(tuple(map(Transpose, line)) for line in zip(*rows, strict=True))), right
        case Group(inner):
            return left, Transpose(inner), right
        case _:
            raise NoRule(f"the derivative of the transpose of {plain(of)} follows no rule")


def _placed(rows: tuple[tuple[Node, ...], ...]) -> Iterator[tuple[Node, Node, Node]]:
    """Each block, with what takes its rows from the left, and its columns from the right when transposed."""
    heights = [line[0].shape[0] for line in rows]
    widths = [part.shape[1] for part in rows[0]]
    for i, line in enumerate(rows):
        for j, part in enumerate(line):
            yield _selecting(i, heights), part, _selecting(j, widths)


def _selecting(place: int, extents: list[int]) -> Node:
    here = extents[place]
    return Block((tuple(Identity(here) if k == place else Zero(here, other) for k, other in enumerate(extents)),))


def _sum(terms: Iterable[Node], rows: int, columns: int) -> Node:
    found = tuple(terms)
    return (found[0] if len(found) == 1 else Sum(found)) if found else Zero(rows, columns)
