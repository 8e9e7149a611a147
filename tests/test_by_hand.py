"""What goes into one entry of an expression, and what a counterexample makes of it."""

from __future__ import annotations

import pytest

from chasles.report.by_hand import parts_of_entry
from chasles.vocabulary import (
    CPM,
    Identity,
    Node,
    abbreviation,
    at,
    bracket,
    column,
    cross,
    matrix,
    rate,
    scalar,
    square,
    vector,
)

a, b = (vector(name, name, "a vector") for name in "ab")
x, y = (scalar(name, name, "a number") for name in "xy")
M, N = (square(name, name, "a matrix") for name in "MN")
A = abbreviation("A", "A", CPM(a), "cross-product matrix of a")
one = Identity(3)


@pytest.mark.parametrize(
    ("node", "place", "parts"),
    [
        (M, (1, 2), {("M", 0, (1, 2))}),
        (M.T, (1, 2), {("M", 0, (2, 1))}),
        (M + N, (0, 0), {("M", 0, (0, 0)), ("N", 0, (0, 0))}),
        (-(x * M), (0, 1), {("x", 0, (0, 0)), ("M", 0, (0, 1))}),
        (M / x, (0, 1), {("x", 0, (0, 0)), ("M", 0, (0, 1))}),
        (rate(a), (2, 0), {("a", 1, (2, 0))}),
        (rate(x * a), (2, 0), {("x", 0, (0, 0)), ("x", 1, (0, 0)), ("a", 0, (2, 0)), ("a", 1, (2, 0))}),
        (A, (0, 1), {("a", 0, (2, 0))}),
        (A, (1, 1), set()),
        (rate(A), (2, 0), {("a", 1, (1, 0))}),
        (x * one, (0, 1), {("x", 0, (0, 0))}),
        (column(a, b), (4, 0), {("b", 0, (1, 0))}),
        (matrix((M, one), (A, N)), (5, 3), {("N", 0, (2, 0))}),
        (matrix((M, one), (A, N)), (0, 4), set()),
        (bracket(at(a)), (1, 0), {("a", 0, (1, 0))}),
        (M @ a, (0, 0), {("M", 0, None), ("a", 0, None)}),
        (rate(cross(a, b)), (0, 0), {("a", 0, None), ("a", 1, None), ("b", 0, None), ("b", 1, None)}),
    ],
)
def test_only_what_goes_into_the_entry_is_a_part(
    node: Node, place: tuple[int, int], parts: set[tuple[str, int, tuple[int, int] | None]]
) -> None:
    found = list(parts_of_entry(node, place))
    assert {(symbol.name, order, entry) for symbol, order, entry in found} == parts


def test_there_is_no_part_of_an_entry_that_there_is_not() -> None:
    with pytest.raises(IndexError, match="no entry 7 among 6"):
        list(parts_of_entry(column(a, b), (6, 0)))
