"""Points that satisfy equations, to 50 digits: Gauss and Newton's method from random starts, of our own.

The iteration in machine numbers takes the least step that solves the linearised equations, so that equations may be
redundant and fewer than the unknowns. Its last inverse then refines the point in many digits (iterative refinement).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from .series import Undefined, mp, mpf

__all__ = ["refined", "solved"]

Residuals = Callable[[Sequence[Any]], list[Any]]
STEPS, REFINEMENTS = 25, 14
STUCK = 7
"""A search that has not come nearer in so many steps is given up."""
FARTHEST = 1e7
SMALL = mpf(10) ** -40


def solved(residuals: Residuals, start: Sequence[float]) -> list[Any] | None:
    """A point near the start at which the residuals vanish, or None if none was found."""
    values = np.array(start, dtype=float)
    if not values.size:
        return refined(residuals, [], None)
    inverse = None
    sizes: list[float] = []
    with np.errstate(all="ignore"):
        for _ in range(STEPS):
            found = _linearised(residuals, values)
            if found is None:
                return None
            at, slope = found
            sizes.append(float(np.max(np.abs(at), initial=0.0)))
            if len(sizes) > STUCK and sizes[-1] > 0.3 * sizes[-1 - STUCK]:
                return None
            inverse = np.linalg.pinv(slope, rcond=1e-9)
            values = _searched(residuals, values, inverse @ at, float(np.linalg.norm(at)))
            if sizes[-1] < 1e-12 * max(1.0, float(np.max(np.abs(values)))):
                break
            if not np.all(np.isfinite(values)) or np.max(np.abs(values)) > FARTHEST:
                return None
    near = sizes[-1] < 1e-7 * max(1.0, float(np.max(np.abs(values))))
    return refined(residuals, [mpf(float(v)) for v in values], inverse) if near else None


def _searched(residuals: Residuals, values: Any, step: Any, size: float) -> Any:
    """The point after the step, or after a part of it that brings the residuals down."""
    for part in (1.0, 0.5, 0.25, 0.1):
        there = values - part * step
        at = _at(residuals, there)
        if at is not None and float(np.linalg.norm(at)) < size * (1 - part / 4):
            break
    return there


def _at(residuals: Residuals, values: Any) -> Any:
    """The residuals, or None where they have no value."""
    try:
        found = residuals(list(values[:, None]))
    except (Undefined, OverflowError, ZeroDivisionError):
        return None
    at = np.array([float(np.asarray(r, dtype=float).flat[0]) for r in found])
    return at if np.all(np.isfinite(at)) else None


def refined(residuals: Residuals, values: Sequence[Any], inverse: Any) -> list[Any] | None:
    """The point with the residuals below 1e-40, or None."""
    current = list(values)
    for _ in range(REFINEMENTS):
        try:
            at = residuals(current)
        except (Undefined, OverflowError, ZeroDivisionError, ValueError):
            return None
        size = max((abs(r) for r in at), default=mpf(0))
        if size < SMALL:
            return current
        if inverse is None or not size < 1:
            return None
        # Machine numbers hold the residual's digits once its size is taken out.
        step = inverse @ np.array([float(mp.re(r / size)) for r in at])
        current = [v - mpf(float(s)) * size for v, s in zip(current, step, strict=True)]
    return None


def _linearised(residuals: Residuals, values: Any) -> tuple[Any, Any] | None:
    """The residuals and their slopes, all columns evaluated at once by central differences."""
    count = len(values)
    width = 1e-6
    steps = np.concatenate([np.zeros((count, 1)), np.eye(count) * width, -np.eye(count) * width], axis=1)
    columns = values[:, None] + steps
    try:
        found = residuals(list(columns))
    except (Undefined, OverflowError, ZeroDivisionError):
        return None
    rows = [np.broadcast_to(np.asarray(r, dtype=float), (2 * count + 1,)) for r in found]
    if not rows:
        return np.zeros(0), np.zeros((0, count))
    table = np.stack(rows)
    if not np.all(np.isfinite(table)):
        return None
    return table[:, 0], (table[:, 1 : count + 1] - table[:, count + 1 :]) / (2 * width)
