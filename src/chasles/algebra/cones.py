"""Combinations with weights of at least zero: one that vanishes, by Dantzig's simplex method with Bland's rule."""

from __future__ import annotations

from collections.abc import Collection, Hashable, Mapping, Sequence
from fractions import Fraction

from chasles.algebra.work_limit import spend

MOST_STILL = 50
Column = Mapping[Hashable, Fraction]


def vanishing(columns: Sequence[Column], strict: Collection[int]) -> dict[int, Fraction] | None:
    """Weights of at least zero with which the columns add up to nothing, those of the `strict` ones to one, if any."""
    kept = _balanced(columns)
    if not kept & {*strict}:
        return None
    rows: dict[Hashable, dict[int, Fraction]] = {None: {k: Fraction(1) for k in sorted(kept & {*strict})}}
    for k in sorted(kept):
        for key, entry in columns[k].items():
            rows.setdefault((key,), {})[k] = entry
    return _solved(list(rows.values()))


def _balanced(columns: Sequence[Column]) -> set[int]:
    """The columns of which every entry may be made up for by others."""
    kept = set(range(len(columns)))
    while True:
        signs: dict[Hashable, set[bool]] = {}
        for k in kept:
            for key, entry in columns[k].items():
                signs.setdefault(key, set()).add(entry > 0)
        lost = {k for k in kept if any(len(signs[key]) == 1 for key in columns[k])}
        if not lost:
            return kept
        kept -= lost


def _solved(rows: list[dict[int, Fraction]]) -> dict[int, Fraction] | None:
    """A solution of at least zero of equations of which the first has the right side one, and the others zero."""
    right = [Fraction(int(k == 0)) for k in range(len(rows))]
    basis: list[int | None] = [None] * len(rows)
    still = 0
    while (right[0] and basis[0] is None) or any(b is None and r for b, r in zip(basis, right, strict=True)):
        cost: dict[int, Fraction] = {}
        for row, own in zip(rows, basis, strict=True):
            if own is None:
                for k, entry in row.items():
                    cost[k] = cost.get(k, Fraction(0)) + entry
        gain, least = max(((c, -k) for k, c in cost.items() if c > 0), default=(None, 0))
        if gain is None:
            return None
        entering = -least if still < MOST_STILL else min(k for k, c in cost.items() if c > 0)
        ratios = [
            (right[i] / row[entering], basis[i] is not None, basis[i] or 0, i)
            for i, row in enumerate(rows)
            if row.get(entering, 0) > 0
        ]
        step, *_, leaving = min(ratios)
        still = 0 if step else still + 1
        _pivot(rows, right, leaving, entering)
        basis[leaving] = entering
    return {k: value for k, value in zip(basis, right, strict=True) if k is not None and value}


def _pivot(rows: list[dict[int, Fraction]], right: list[Fraction], place: int, entering: int) -> None:
    pivot = rows[place][entering]
    own = rows[place] = {k: entry / pivot for k, entry in rows[place].items()}
    right[place] /= pivot
    for i, row in enumerate(rows):
        if i != place and (factor := row.get(entering)):
            spend(len(own))
            for k, entry in own.items():
                row[k] = row.get(k, Fraction(0)) - factor * entry
                if not row[k]:
                    del row[k]
            right[i] -= factor * right[place]
