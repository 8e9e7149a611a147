"""Exponentials of numbers and of multiples of cross-product matrices."""

from __future__ import annotations

from chasles.vocabulary import Group, Misfit, Negative, Node, Scale, Skew
from chasles.vocabulary.functions import FunctionOf
from chasles.vocabulary.rotation_vectors import RotationByVector


def exponential(of: Node) -> Node:
    """The exponential of a scalar, or of a multiple of a cross-product matrix; raises `Misfit` for anything else."""
    if of.is_scalar:
        return FunctionOf("exp", (of,))
    vector = _axial(of)
    if vector is None:
        raise Misfit(f"{of} is neither a scalar nor a multiple of a cross-product matrix")
    return RotationByVector(vector)


def _axial(of: Node) -> Node | None:
    """The vector whose cross-product matrix it is."""
    if isinstance(of, Skew):
        return of.of
    if isinstance(of, Group | Negative) and (inner := _axial(of.below[0])) is not None:
        return inner if isinstance(of, Group) else Negative(inner)
    if isinstance(of, Scale) and (inner := _axial(of.term)) is not None:
        return Scale(of.factor, inner, of.trailing)
    return None
