"""Linear systems in numbers of many digits: one solution, whether or not it is the only one."""

from __future__ import annotations

from typing import Any

from chasles.evaluation.matrices import Matrix

__all__ = ["solved"]

NEGLIGIBLE = 60
"""A pivot below 10^-NEGLIGIBLE is one that would be zero in exact arithmetic."""


def solved(matrix: Matrix, right: list[Any], context: Any) -> list[Any]:
    """A solution of the system, by elimination with full pivoting; what is left free is one.

    Equations that contradict the others are passed over: whether they are satisfied has to be looked at afterwards.
    """
    rows = [[*row, last] for row, last in zip(matrix, right, strict=True)]
    size = len(matrix[0])
    columns, used = list(range(size)), 0
    pivots: list[int] = []
    least = context.mpf(10) ** -NEGLIGIBLE
    while columns and used < len(rows):
        best = max(((r, c) for r in range(used, len(rows)) for c in columns), key=lambda at: abs(rows[at[0]][at[1]]))
        row, column = best
        if abs(rows[row][column]) < least:
            break
        rows[used], rows[row] = rows[row], rows[used]
        rows[used] = [entry / rows[used][column] for entry in rows[used]]
        for k, line in enumerate(rows):
            if k != used:
                rows[k] = [x - line[column] * y for x, y in zip(line, rows[used], strict=True)]
        pivots.append(column)
        columns.remove(column)
        used += 1
    solution = [context.mpf(1)] * size
    for row, column in enumerate(pivots):
        solution[column] = rows[row][-1] - sum((rows[row][free] for free in columns), context.mpf(0))
    return solution
