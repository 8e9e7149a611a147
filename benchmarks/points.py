"""Where the kernels are timed and where their errors are measured, and what is right there."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from math import log10, pi
from typing import Any

import mpmath
import numpy as np
from benchmarks.formulas import Kernel

NEAR_ZERO = (1e-300, 1e-12, 1e-8, 1e-4, 1e-2)
NEAR_PI = (pi, pi - 1e-12, pi - 1e-8, pi - 1e-4)
SEED = 17


def batch(kernel: Kernel, n: int) -> tuple[np.ndarray, ...]:
    """Random elements: unit axes, angles from 0.1 to 3, positive definite inertia, other components normal."""
    draw = np.random.default_rng(SEED)
    drawn: dict[str, np.ndarray] = {}
    for name, shape in kernel.inputs.items():
        x = draw.standard_normal((n, *shape))
        if name == "e":
            x = unit_axes(n, draw)
        elif name == "phi":
            x = draw.uniform(0.1, 3.0, n)
        elif name == "m":
            x = draw.uniform(0.5, 2.0, n)
        elif name == "I":
            factor = draw.standard_normal((n, 3, 3))
            x = factor @ np.swapaxes(factor, 1, 2)
            x = (x + np.swapaxes(x, 1, 2)) / 2
            x = x if shape == (3, 3) else x[:, [0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]]
        drawn[name] = np.ascontiguousarray(x)
    return tuple(drawn.values())


def unit_axes(n: int, draw: np.random.Generator) -> np.ndarray:
    """Unit vectors, rounded to float64."""
    e = draw.standard_normal((n, 3))
    return e / np.linalg.norm(e, axis=1, keepdims=True)


def nearly_exact_axes(n: int) -> np.ndarray:
    """The n axes, of many, whose squares come nearest to 1: what is wrong with e is then not counted as an error."""
    e = unit_axes(200_000, np.random.default_rng(SEED))
    wide = e.astype(np.longdouble)
    order = np.argsort(np.abs((wide * wide).sum(axis=1) - 1), kind="stable")
    return e[order[:n]]


def near(kernel: Kernel, angles: Sequence[float], n: int = 10) -> tuple[np.ndarray, ...]:
    """The random elements with nearly exact axes, at the angles given: n for each angle."""
    inputs = dict(zip(kernel.inputs, batch(kernel, n * len(angles)), strict=True))
    inputs["e"] = np.tile(nearly_exact_axes(n), (len(angles), 1))
    inputs["phi"] = np.repeat(np.array(angles), n)
    return tuple(inputs.values())


def references(kernel: Kernel, inputs: tuple[np.ndarray, ...]) -> list[np.ndarray]:
    """The formula's values for each element, as arrays of mpmath's numbers with 50 right digits."""
    return [
        exact(kernel, dict(zip(kernel.inputs, (exactly(np.asarray(x[i])) for x in inputs), strict=True)))
        for i in range(len(inputs[0]))
    ]


def exact(kernel: Kernel, given: dict[str, np.ndarray]) -> np.ndarray:
    """The formula's value for one element."""
    phi = abs(float(given["phi"])) if "phi" in given else 1.0
    # 1 - cos(phi) loses twice the digits of phi, the products of its derivative as many again.
    with mpmath.workdps(100 + int(4 * max(0.0, -log10(phi)))):
        values = np.empty(kernel.size, dtype=object)
        values[:] = kernel.of(mpmath.mp, *(np.ravel(x) for x in given.values()))
    return values.reshape(kernel.output)


def largest_error(call: Any, inputs: tuple[np.ndarray, ...], right: Sequence[np.ndarray]) -> float | None:
    """The largest error, normwise in units of 2^-53; None where a result is not finite or has no right digit."""
    worst = 0.0
    for i, value in enumerate(right):
        with np.errstate(all="ignore"):
            try:
                found = np.asarray(call(*(x[i] for x in inputs)))
            except ZeroDivisionError:
                return None
        finite = bool(np.isfinite(found).all())
        beyond = norm(value) > sys.float_info.max
        if finite == beyond:
            return None
        if beyond:
            continue
        with mpmath.workdps(60):
            worst = max(worst, float(norm(value - exactly(found)) / norm(value) * 2**53))
    return worst if worst < 2**53 else None


def exactly(values: np.ndarray) -> np.ndarray:
    """The same floats as mpmath's numbers."""
    return np.vectorize(mpmath.mpf, otypes=[object])(values)


def norm(values: np.ndarray) -> Any:
    """The Euclidean norm of all entries."""
    return mpmath.sqrt(np.sum(values * values))


def condition(kernel: Kernel, inputs: tuple[np.ndarray, ...], i: int) -> float:
    """By how much, at most, a relative error of each entry of the i-th element is magnified in the result."""
    step = 1e-25
    given = dict(zip(kernel.inputs, (exactly(np.asarray(x[i])) for x in inputs), strict=True))
    with mpmath.workdps(60):
        value, total = exact(kernel, given), mpmath.mpf(0)
        for name, x in given.items():
            for index in np.ndindex(x.shape):
                moved = x.copy()
                moved[index] *= 1 + mpmath.mpf(step)
                total += norm(exact(kernel, {**given, name: moved}) - value) / step
        return float(total / norm(value))
