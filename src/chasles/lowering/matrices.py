"""Matrices of steps before their components: sums of multiples of the identity, dyads and cross-product matrices."""

from __future__ import annotations

from dataclasses import dataclass

Column = tuple[int, ...]
"""The numbers of the steps that hold the entries of a column."""
Rows = tuple[Column, ...]
"""The numbers of the steps that hold the entries of a matrix, row by row."""


@dataclass(frozen=True, slots=True)
class Unit:
    """The identity matrix."""

    size: int


@dataclass(frozen=True, slots=True)
class Dyad:
    """left right^T."""

    left: Column
    right: Column


@dataclass(frozen=True, slots=True)
class SymmetricDyad:
    """left right^T + right left^T, for two different columns."""

    left: Column
    right: Column


@dataclass(frozen=True, slots=True)
class CrossProduct:
    """The cross-product matrix of a vector."""

    of: Column


@dataclass(frozen=True, slots=True)
class Dense:
    """A matrix of which nothing is known but its entries."""

    rows: Rows


@dataclass(frozen=True, slots=True)
class DoubleCross:
    """The product of the cross-product matrices of two vectors: x -> left x (right x x)."""

    left: Column
    right: Column


Tensor = Unit | Dyad | SymmetricDyad | CrossProduct | DoubleCross | Dense


@dataclass(frozen=True, slots=True)
class Matrix:
    """A sum of coefficients times tensors; a matrix without terms is zero."""

    shape: tuple[int, int]
    terms: tuple[tuple[int, Tensor], ...] = ()


def transposed(rows: Rows) -> Rows:
    """The rows of the transpose."""
    return tuple(zip(*rows, strict=True))
