"""Rotation vectors: the exponential, by Rodrigues' formula, and its Jacobians; Cayley's transform.

They divide by the length of the vector: a statement says by `nonzero(norm(v))` that it is not zero.
"""

from __future__ import annotations

from fractions import Fraction
from typing import ClassVar

from chasles.vocabulary.arguments import making
from chasles.vocabulary.fitting import square_measure, word
from chasles.vocabulary.layout import Call, Group
from chasles.vocabulary.letters import Identity
from chasles.vocabulary.nodes import Contract, Negative, Node, Number, OfOne, Power, Quotient, Scale, Sum
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.spatial import Inverse, Norm, Skew

ONE = Number(Fraction(1))


def _series(of: Node, linear: Node, quadratic: Node) -> Node:
    """A polynomial of the second degree in the cross-product matrix, which begins with the identity."""
    return Sum((Identity(3), Scale(linear, Skew(of)), Scale(quadratic, Power(Skew(of), 2))))


def _versine(length: Node) -> Node:
    return Quotient(Sum((ONE, Negative(Call("cos", length)))), Power(length, 2))


@word
class RotationByVector(Shorthand, OfOne):
    """The rotation through the length of a vector about its direction. Source: Rodrigues (1840)."""

    function: ClassVar[str] = "Exp"

    @property
    def definition(self) -> Node:
        length = Norm(self.of)
        return _series(self.of, Quotient(Call("sin", length), length), _versine(length))


@word
class LeftJacobian(Shorthand, OfOne):
    """The angular velocity in the fixed frame from the rate of a rotation vector. Source: Bortz (1971)."""

    function: ClassVar[str] = "J_l"

    @property
    def definition(self) -> Node:
        length = Norm(self.of)
        cubic = Quotient(Sum((length, Negative(Call("sin", length)))), Power(length, 3))
        return _series(self.of, _versine(length), cubic)


@word
class RightJacobian(Shorthand, OfOne):
    """The angular velocity in the frame of the body from the rate of a rotation vector."""

    function: ClassVar[str] = "J_r"

    @property
    def definition(self) -> Node:
        length = Norm(self.of)
        cubic = Quotient(Sum((length, Negative(Call("sin", length)))), Power(length, 3))
        return _series(self.of, Negative(_versine(length)), cubic)


@word
class Cayley(Shorthand, OfOne):
    """Cayley's transform of a square matrix: a rotation, if that is skew-symmetric. Source: Cayley (1846)."""

    function: ClassVar[str] = "cay"

    @property
    def definition(self) -> Node:
        one = Identity(square_measure(self.of, "Cayley's transform").shape[0])
        return Contract((Inverse(Group(Sum((one, Negative(self.of))))), Group(Sum((one, self.of)))))


exp_of_vector = making(RotationByVector, "exp_of_vector")
left_jacobian = making(LeftJacobian, "left_jacobian")
right_jacobian = making(RightJacobian, "right_jacobian")
cayley = making(Cayley, "cayley")
