"""Quaternions as columns of four numbers: Hamilton's product, the conjugate, the matrices of products, rotations.

The scalar part stands first, or last where a word says so.
"""

from __future__ import annotations

from fractions import Fraction
from typing import ClassVar

from chasles.vocabulary.arguments import making
from chasles.vocabulary.fitting import measured, word
from chasles.vocabulary.layout import Block, Group
from chasles.vocabulary.letters import Identity
from chasles.vocabulary.measure import Misfit
from chasles.vocabulary.nodes import Contract, Negative, Node, Number, Power, Scale, Sum, Transpose
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.spatial import Cross, Dot, Skew


def _parts(of: Node, scalar_last: bool) -> tuple[Node, Node]:
    """The vector and the scalar; raises `Misfit` for what is no column of four."""
    if measured(of).shape != (4, 1):
        raise Misfit(f"a quaternion is a column of four numbers, and {of} is {of.shape[0]} x {of.shape[1]}")
    match of:
        case Block(((one,), (other,))) if (one.shape if scalar_last else other.shape) == (3, 1):
            return (one, other) if scalar_last else (other, one)
    return (of[1:3], of[4]) if scalar_last else (of[2:4], of[1])


def _column(vector: Node, scalar: Node, scalar_last: bool) -> Node:
    return Block(((vector,), (scalar,)) if scalar_last else ((scalar,), (vector,)))


@word
class QuaternionProduct(Shorthand):
    """Hamilton's product of two quaternions. Source: Hamilton, On quaternions (1844)."""

    left: Node
    right: Node
    scalar_last: bool = False
    function: ClassVar[str] = "product"

    @property
    def definition(self) -> Node:
        (p, p_0), (q, q_0) = _parts(self.left, self.scalar_last), _parts(self.right, self.scalar_last)
        vector = Sum((Scale(p_0, q), Scale(q_0, p), Cross(p, q)))
        return _column(vector, Sum((Scale(p_0, q_0), Negative(Dot(p, q)))), self.scalar_last)


@word
class QuaternionConjugate(Shorthand):
    """The quaternion with the opposite vector."""

    of: Node
    scalar_last: bool = False
    function: ClassVar[str] = "conj"

    @property
    def definition(self) -> Node:
        q, q_0 = _parts(self.of, self.scalar_last)
        return _column(Negative(q), q_0, self.scalar_last)


@word
class ProductFromLeft(Shorthand):
    """The matrix by which a quaternion multiplies others from the left."""

    of: Node
    scalar_last: bool = False
    function: ClassVar[str] = "left"

    @property
    def definition(self) -> Node:
        q, q_0 = _parts(self.of, self.scalar_last)
        return _matrix(q, Sum((Scale(q_0, Identity(3)), Skew(q))), q_0, self.scalar_last)


@word
class ProductFromRight(Shorthand):
    """The matrix by which a quaternion multiplies others from the right."""

    of: Node
    scalar_last: bool = False
    function: ClassVar[str] = "right"

    @property
    def definition(self) -> Node:
        q, q_0 = _parts(self.of, self.scalar_last)
        return _matrix(q, Sum((Scale(q_0, Identity(3)), Negative(Skew(q)))), q_0, self.scalar_last)


def _matrix(q: Node, block: Node, q_0: Node, scalar_last: bool) -> Node:
    """The block beside the vector, its opposite and the scalar."""
    across = Negative(Transpose(q))
    return Block(((block, q), (across, q_0)) if scalar_last else ((q_0, across), (q, block)))


@word
class QuaternionRotation(Shorthand):
    """The rotation by a unit quaternion; of another one, that rotation times its square. Source: Euler (1771)."""

    of: Node
    scalar_last: bool = False
    function: ClassVar[str] = "rot"

    @property
    def definition(self) -> Node:
        q, q_0 = _parts(self.of, self.scalar_last)
        two = Number(Fraction(2))
        diagonal = Scale(Group(Sum((Power(q_0, 2), Negative(Dot(q, q))))), Identity(3))
        return Sum((diagonal, Scale(two, Contract((q, Transpose(q)))), Scale(Scale(two, q_0), Skew(q))))


quaternion_product = making(QuaternionProduct, "quaternion_product")
quaternion_conjugate = making(QuaternionConjugate, "quaternion_conjugate")
product_from_left = making(ProductFromLeft, "product_from_left")
product_from_right = making(ProductFromRight, "product_from_right")
rotation_of_quaternion = making(QuaternionRotation, "rotation_of_quaternion")
