"""Exponentials of rigid motions: of a column of a rotation vector and a translation, and their Jacobians.

They divide by the length of the rotation vector: a statement says by `nonzero` that it is not zero. The rotation vector
stands on top, or the translation where a word says `linear_first`.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import ClassVar

from chasles.vocabulary.arguments import making
from chasles.vocabulary.fitting import word
from chasles.vocabulary.layout import Call, Group
from chasles.vocabulary.motions import halves, homogeneous, triangular
from chasles.vocabulary.nodes import Contract, Negative, Node, Number, Scale, Sum
from chasles.vocabulary.rotation_vectors import LeftJacobian, RightJacobian, RotationByVector
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.spatial import Norm, Skew


@word
class MotionByVector(Shorthand):
    """The motion that turns by a rotation vector and advances along a screw."""

    of: Node
    linear_first: bool = False
    function: ClassVar[str] = "Exp"

    @property
    def definition(self) -> Node:
        angular, linear = halves(self.of, self.linear_first)
        return homogeneous(RotationByVector(angular), Contract((LeftJacobian(angular), linear)))


@word
class LeftJacobianOfMotion(Shorthand):
    """The twist in the fixed frame from the rate of the vector of a motion.

    Source: Barfoot and Furgale, Associating uncertainty with three-dimensional poses (2014), equation (102).
    """

    of: Node
    linear_first: bool = False
    function: ClassVar[str] = "J_l"

    @property
    def definition(self) -> Node:
        angular, linear = halves(self.of, self.linear_first)
        return triangular(LeftJacobian(angular), _across(angular, linear, 1), self.linear_first)


@word
class RightJacobianOfMotion(Shorthand):
    """The twist in the frame of the body from the rate of the vector of a motion."""

    of: Node
    linear_first: bool = False
    function: ClassVar[str] = "J_r"

    @property
    def definition(self) -> Node:
        angular, linear = halves(self.of, self.linear_first)
        return triangular(RightJacobian(angular), _across(angular, linear, -1), self.linear_first)


def _across(angular: Node, linear: Node, sign: int) -> Node:
    """By what the linear part follows from the rate of the rotation vector; odd terms have the sign."""
    n, v, p = Norm(angular), Skew(angular), Skew(linear)
    cosine, sine, one, half = Call("cos", n), Call("sin", n), Number(Fraction(1)), Number(Fraction(1, 2))
    versine = Group(one - half * n**2 - cosine) / n**4
    fifth = half * (versine - 3 * (Group(n - sine - Number(Fraction(1, 6)) * n**3) / n**5))
    terms = (
        (Number(Fraction(sign, 2)), (p,)),
        (Group(n - sine) / n**3, (v @ p, p @ v, sign * (v @ p @ v))),
        (Negative(sign * versine), (v @ v @ p, p @ v @ v, -3 * (v @ p @ v))),
        (Negative(fifth), (v @ p @ v @ v, v @ v @ p @ v)),
    )
    return Sum(tuple(Scale(factor, _sum(parts)) for factor, parts in terms))


def _sum(terms: Sequence[Node]) -> Node:
    return Group(Sum(tuple(terms))) if len(terms) > 1 else terms[0]


exp_of_motion_vector = making(MotionByVector, "exp_of_motion_vector")
left_jacobian_of_motion = making(LeftJacobianOfMotion, "left_jacobian_of_motion")
right_jacobian_of_motion = making(RightJacobianOfMotion, "right_jacobian_of_motion")
