"""Rigid motions as 4 x 4 matrices of a rotation and a position, and twists: inverses, adjoints, exponentials.

The angular velocity stands on top of a twist, or the velocity where a word says `linear_first`.
"""

from __future__ import annotations

from fractions import Fraction
from typing import ClassVar

from chasles.vocabulary.arguments import making
from chasles.vocabulary.fitting import measured, word
from chasles.vocabulary.layout import Block
from chasles.vocabulary.letters import Zero
from chasles.vocabulary.measure import Misfit
from chasles.vocabulary.nodes import Contract, Negative, Node, Number, OfOne, Transpose
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.spatial import Skew


def homogeneous(rotation: Node, position: Node) -> Block:
    """The 4 x 4 matrix of the motion x -> rotation x + position."""
    return Block(((rotation, position), (Zero(1, 3), Number(Fraction(1)))))


def _pose(of: Node) -> tuple[Node, Node]:
    """The rotation and the position; raises `Misfit` for what is no matrix of a motion."""
    if measured(of).shape != (4, 4):
        raise Misfit(f"a motion is a 4 x 4 matrix, and {of} is {of.shape[0]} x {of.shape[1]}")
    match of:
        case Block(((rotation, position), (Zero(), _))) if rotation.shape == (3, 3):
            return rotation, position
    return of[1:3, 1:3], of[1:3, 4]


def halves(of: Node, linear_first: bool) -> tuple[Node, Node]:
    """The angular and the linear part; raises `Misfit` for what is no column of six."""
    if measured(of).shape != (6, 1):
        raise Misfit(f"a twist is a column of six numbers, and {of} is {of.shape[0]} x {of.shape[1]}")
    match of:
        case Negative(term):
            angular, linear = halves(term, linear_first)
            return Negative(angular), Negative(linear)
        case Block(((one,), (other,))) if one.shape == (3, 1):
            return (other, one) if linear_first else (one, other)
    return (of[4:6], of[1:3]) if linear_first else (of[1:3], of[4:6])


def triangular(diagonal: Node, across: Node, linear_first: bool) -> Node:
    """The matrix that adds to the linear part what the angular part is mapped to."""
    zero = Zero(3, 3)
    rows = ((diagonal, across), (zero, diagonal)) if linear_first else ((diagonal, zero), (across, diagonal))
    return Block(rows)


@word
class InverseMotion(Shorthand, OfOne):
    """The inverse of the 4 x 4 matrix of a motion, by the transpose of its rotation."""

    function: ClassVar[str] = "inv"

    @property
    def definition(self) -> Node:
        rotation, position = _pose(self.of)
        return homogeneous(Transpose(rotation), Negative(Contract((Transpose(rotation), position))))


@word
class TwistMatrix(Shorthand):
    """The 4 x 4 matrix of a twist: the cross-product matrix of its angular part beside its linear part."""

    of: Node
    linear_first: bool = False
    function: ClassVar[str] = "hat"

    @property
    def definition(self) -> Node:
        angular, linear = halves(self.of, self.linear_first)
        return Block(((Skew(angular), linear), (Zero(1, 3), Zero(1, 1))))


@word
class AdjointOfMotion(Shorthand):
    """The 6 x 6 matrix by which a motion carries twists over."""

    of: Node
    linear_first: bool = False
    function: ClassVar[str] = "Ad"

    @property
    def definition(self) -> Node:
        rotation, position = _pose(self.of)
        return triangular(rotation, Contract((Skew(position), rotation)), self.linear_first)


@word
class AdjointOfTwist(Shorthand):
    """The 6 x 6 matrix of the Lie bracket with a twist."""

    of: Node
    linear_first: bool = False
    function: ClassVar[str] = "ad"

    @property
    def definition(self) -> Node:
        angular, linear = halves(self.of, self.linear_first)
        return triangular(Skew(angular), Skew(linear), self.linear_first)


inverse_motion = making(InverseMotion, "inverse_motion")
twist_matrix = making(TwistMatrix, "twist_matrix")
adjoint_of_motion = making(AdjointOfMotion, "adjoint_of_motion")
adjoint_of_twist = making(AdjointOfTwist, "adjoint_of_twist")
