"""Slips of the pen at one node that put one thing for another: transposes, orders, blocks, letters, marks, indices."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import combinations

from chasles.vocabulary import (
    Block,
    Contract,
    Cross,
    Entry,
    Group,
    Identity,
    Index,
    Inverse,
    Member,
    Negative,
    Node,
    Quotient,
    Scale,
    Sum,
    Symbol,
    Transpose,
    Zero,
    children,
    rebuilt,
    symbols_of,
    walk,
)

from .slips_of_amount import Slip, is_zero, with_block

__all__ = ["blocks", "exchanged_letters", "indices_of", "letters", "lost_marks", "order", "other_indices", "transposes"]


def transposes(node: Node, is_symmetric: Callable[[Node], bool]) -> Iterator[Slip]:
    """A lost transpose, and an extra one on a square matrix that is not symmetric."""
    rows, columns = node.shape
    if isinstance(node, Negative | Sum | Inverse) or (rows == columns and is_symmetric(node)):
        return
    if isinstance(node, Transpose):
        yield "transpose lost", node.of
    elif rows == columns != 1:
        factors = _factors(node)
        if [_mirrored(factor) for factor in reversed(factors)] != factors:
            yield "transpose added", Transpose(node)


def _factors(node: Node) -> list[Node]:
    """The matrices of a product, scalars and brackets left out."""
    match node:
        case Contract(factors):
            return [inner for factor in factors for inner in _factors(factor)]
        case Scale(factor, of):
            return _factors(of if factor.is_scalar else factor)
        case Quotient(of, _) | Group(of):
            return _factors(of)
        case _:
            return [node]


def _mirrored(node: Node) -> Node:
    match node:
        case Identity() | Zero():
            return node
        case Transpose(of):
            return of
        case _:
            return node if node.is_scalar else Transpose(node)


def order(node: Node) -> Iterator[Slip]:
    match node:
        case Cross(left, right) if left != right:
            yield "operands swapped", Cross(right, left)
        case Contract(factors):
            for k in range(len(factors) - 1):
                swapped = (*factors[:k], factors[k + 1], factors[k], *factors[k + 2 :])
                if swapped != factors:
                    yield "factors swapped", Contract(swapped)
        case Block(rows):
            for k in range(len(rows) - 1):
                yield "rows swapped", Block((*rows[:k], rows[k + 1], rows[k], *rows[k + 2 :]))
            for k in range(len(rows[0]) - 1):
                exchanged = tuple((*row[:k], row[k + 1], row[k], *row[k + 2 :]) for row in rows)
                yield "columns swapped", Block(exchanged)


def blocks(node: Node) -> Iterator[Slip]:
    """A block left out, or exchanged for another that is not beside it."""
    if not isinstance(node, Block):
        return
    places = [(i, j) for i, row in enumerate(node.rows) for j in range(len(row))]
    for i, j in places:
        block = node.rows[i][j]
        if not is_zero(block):
            yield "block left out", with_block(node.rows, i, j, Zero(*block.shape))
    for (i, j), (k, n) in combinations(places, 2):
        one, other = node.rows[i][j], node.rows[k][n]
        if one != other:
            once = with_block(node.rows, i, j, other)
            yield "blocks exchanged", with_block(once.rows, k, n, one)


def letters(node: Node, letters: tuple[Symbol, ...]) -> Iterator[Slip]:
    if isinstance(node, Symbol):
        for letter in letters:
            if letter != node and letter.size == node.size:
                yield "letter", letter


def exchanged_letters(node: Node, letters: tuple[Symbol, ...]) -> Iterator[Node]:
    """The whole with two of the letters exchanged in all places."""
    present = [letter for letter in letters if letter in symbols_of(node)]
    for one, other in combinations(present, 2):
        if one.size == other.size:
            yield _exchanged(node, {one: other, other: one})


def _exchanged(node: Node, letters: Mapping[Symbol, Symbol]) -> Node:
    if isinstance(node, Symbol):
        return letters.get(node, node)
    parts = children(node)
    return rebuilt(node, tuple(_exchanged(part, letters) for part in parts)) if parts else node


def lost_marks(node: Node, marked: Mapping[Symbol, Symbol]) -> Iterator[Slip]:
    """A tilde or a prime lost, where the letter without it means something else in the chapter."""
    if isinstance(node, Symbol) and node in marked:
        yield "mark lost", marked[node]


def indices_of(node: Node) -> Iterator[Index]:
    for part in walk(node):
        match part:
            case Member(_, index):
                yield index
            case Entry(_, i, j, _):
                yield from (i, j)


def other_indices(node: Node, indices: tuple[Index, ...]) -> Iterator[Slip]:
    match node:
        case Member(family, index):
            for other in indices:
                if other != index:
                    yield "index", Member(family, other)
        case Entry(of, i, j, letter):
            yield "indices swapped", Entry(of, j, i, letter)
