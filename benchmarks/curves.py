"""Errors over the angle: the formula as the book prints it, evaluated as typed, and the kernel. Data for a plot."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from benchmarks.adversarial.exact import Exact
from benchmarks.adversarial.throwing import Tried
from benchmarks.formulas import ONE, Matrix, axis_point, rate_matrix, rate_matrix_dot, rotation
from flint import arb, ctx

from chasles import kernels as shipped

__all__ = ["CURVES", "curves"]

AXIS = np.array([2.0, 3.0, 6.0]) / 7
OTHERS: dict[str, list[float]] = {
    "omega": [0.5, -1.0, 2.0],
    "a": [1.25, -0.75, 0.5],
    "a_prime": [-0.5, 1.5, 0.875],
}
ANGLES = [
    *(("phi", 10.0**-k) for k in (*range(300, 20, -10), *range(20, 0, -1))),
    *(("phi", x) for x in (0.3, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0)),
    *(("pi - phi", 10.0**-k) for k in range(1, 16)),
]
"""The variable that is small, and what it is; near pi the float nearest to the difference is taken."""
BITS = 400


def _linear_rate_matrix(f: Any, e: Matrix, phi: Any) -> Matrix:
    """L, (3.76c)."""
    Q = rotation(f, e, phi)
    trace = Q.rows[0][0] + Q.rows[1][1] + Q.rows[2][2]
    return Matrix([*((ONE * trace - Q) * 0.5).rows, *(e.T * -f.sin(phi)).rows])


def _invariants(Q: list[float]) -> list[float]:
    """The axis along vect(Q), and the angle by the trace: what one types after reading (3.75)."""
    x, y, z = (Q[7] - Q[5]) / 2, (Q[2] - Q[6]) / 2, (Q[3] - Q[1]) / 2
    length = math.sqrt(x * x + y * y + z * z)
    cosine = (Q[0] + Q[4] + Q[8] - 1) / 2
    if length == 0 or abs(cosine) > 1:
        return [math.nan] * 4
    return [x / length, y / length, z / length, math.acos(cosine)]


CURVES: dict[str, tuple[str, Callable[..., Matrix]]] = {
    "rotation_from_axis_angle": ("Q", rotation),
    "natural_rate_matrix": ("N", rate_matrix),
    "natural_rate_matrix_dot": ("dN/dt", rate_matrix_dot),
    "screw_axis_point": ("p0", axis_point),
    "linear_rate_matrix": ("L", _linear_rate_matrix),
}


def curves(tried: Sequence[Tried]) -> dict[str, Any]:
    """By kernel: for each angle the normwise errors of both in units of 2^-53; null where there is no finite result."""
    found = {one.kernel.name: _curve(one) for one in tried if one.kernel.name in CURVES}
    if any(one.kernel.name == "natural_invariants" for one in tried):
        found["natural_invariants"] = _curve_of_invariants()
    return found


def _curve(tried: Tried) -> dict[str, Any]:
    program = tried.kernel.program
    title, formula = CURVES[program.name]
    exact, points = Exact(program, least=2.0**-110), []
    for variable, small in ANGLES:
        phi = small if variable == "phi" else math.pi - small
        values = [AXIS.tolist(), [phi], *([*OTHERS[a.name]] for a in program.arguments[2:])]
        right = [None if value is None else value[0] for value in exact(values)[0]]
        shaped = [Matrix([[x] for x in v]) if len(v) > 1 else v[0] for v in values]
        with np.errstate(all="ignore"):
            ours = getattr(shipped, program.name)(*(np.array(v) if len(v) > 1 else v[0] for v in values))
        points.append(_point(variable, small, np.ravel(ours).tolist(), _typed(formula, shaped), right))
    return {"title": title, "points": points}


def _typed(formula: Callable[..., Matrix], values: Sequence[Any]) -> list[float]:
    try:
        return [float(x) for x in formula(math, *values).flat]
    except (ZeroDivisionError, OverflowError):
        return [math.nan]


def _curve_of_invariants() -> dict[str, Any]:
    points = []
    for variable, small in ANGLES:
        phi = small if variable == "phi" else math.pi - small
        axis, Q = _rotation(phi)
        with np.errstate(all="ignore"):
            e, angle = shipped.natural_invariants(np.array(Q).reshape(3, 3))
        ours, typed, right = [*e.tolist(), float(angle)], _invariants(Q), [*axis, arb(phi)]
        both = [_point(variable, small, ours[k], typed[k], right[k]) for k in (slice(0, 3), slice(3, 4))]
        points.append(both[0] | {"ours": _larger(both, "ours"), "as_typed": _larger(both, "as_typed")})
    return {"title": "e and phi from Q, the larger of the two errors", "points": points}


def _rotation(phi: float) -> tuple[list[Any], list[float]]:
    """A unit vector, and the rotation about it rounded to floats."""
    before = ctx.prec
    ctx.prec = BITS
    try:
        length = sum((arb(float(x)) ** 2 for x in AXIS), arb(0)).sqrt()
        axis = [arb(float(x)) / length for x in AXIS]
        exact = rotation(_Balls, Matrix([[x] for x in axis]), arb(phi))
        return axis, [float(x) for x in exact.flat]
    finally:
        ctx.prec = before


class _Balls:
    """Cosine and sine of a ball."""

    @staticmethod
    def cos(x: Any) -> Any:
        return x.cos()

    @staticmethod
    def sin(x: Any) -> Any:
        return x.sin()


def _larger(both: list[dict[str, Any]], key: str) -> float | None:
    values = [one[key] for one in both]
    return None if None in values else max(values)


def _point(variable: str, small: float, ours: list[float], typed: list[float], right: list[Any]) -> dict[str, Any]:
    return {variable: small, "ours": _error(ours, right), "as_typed": _error(typed, right)}


def _error(got: list[float], right: list[Any]) -> float | None:
    """The largest error of an entry in units of the roundoff of the largest entry."""
    if len(got) != len(right) or not all(map(math.isfinite, got)) or None in right:
        return None
    gaps = [abs(arb(x) - y) for x, y in zip(got, right, strict=True)]
    return float(f"{float(max(gaps, key=float) / max(map(abs, right), key=float)) * 2.0**53:.3g}")
