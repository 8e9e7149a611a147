"""Linear systems of rational numbers, solved exactly."""

from __future__ import annotations

from fractions import Fraction


def eliminated(rows: list[list[Fraction]]) -> list[Fraction] | None:
    """A solution of the system whose last column is the right side, by Gauss-Jordan elimination; None if none."""
    size = len(rows[0]) - 1
    pivots: list[int] = []
    for column in range(size):
        done = len(pivots)
        row = next((r for r in range(done, len(rows)) if rows[r][column]), None)
        if row is None:
            continue
        rows[done], rows[row] = rows[row], rows[done]
        rows[done] = [x / rows[done][column] for x in rows[done]]
        for r, line in enumerate(rows):
            if r != done and line[column]:
                rows[r] = [x - line[column] * y for x, y in zip(line, rows[done], strict=True)]
        pivots.append(column)
    if any(line[-1] for line in rows[len(pivots) :]):
        return None
    solution = [Fraction(0)] * size
    for row, column in enumerate(pivots):
        solution[column] = rows[row][-1]
    return solution
