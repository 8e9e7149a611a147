"""NumPy: the printed formulas as one writes them by hand for batches."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from benchmarks.formulas import Kernel
from benchmarks.peers import Made

TITLE = "NumPy by hand"
ONE = np.eye(3)


def outer(u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """The dyads u v^T."""
    return u[..., :, np.newaxis] * v[..., np.newaxis, :]


def cross_matrix(v: np.ndarray) -> np.ndarray:
    """CPM(v)."""
    E = np.zeros((*v.shape, 3))
    E[..., 2, 1], E[..., 0, 2], E[..., 1, 0] = v[..., 0], v[..., 1], v[..., 2]
    E[..., 1, 2], E[..., 2, 0], E[..., 0, 1] = -v[..., 0], -v[..., 1], -v[..., 2]
    return E


def scalar(x: Any) -> np.ndarray:
    """A scalar as a factor of matrices."""
    return np.asarray(x)[..., np.newaxis, np.newaxis]


def times(A: np.ndarray, v: np.ndarray) -> np.ndarray:
    """The vectors A v."""
    return np.einsum("...ij,...j->...i", A, v)


def stacked(upper: np.ndarray, row: np.ndarray) -> np.ndarray:
    """A row below a matrix."""
    return np.concatenate([upper, row[..., np.newaxis, :]], axis=-2)


def rotation(e: np.ndarray, phi: np.ndarray) -> np.ndarray:
    """Q, (2.49)."""
    ee = outer(e, e)
    return ee + scalar(np.cos(phi)) * (ONE - ee) + scalar(np.sin(phi)) * cross_matrix(e)


def rate_matrix(e: np.ndarray, phi: np.ndarray) -> np.ndarray:
    """N, (3.76b)."""
    k = np.sin(phi) / (2 * (1 - np.cos(phi)))
    return stacked(scalar(k) * (ONE - outer(e, e)) - cross_matrix(e) / 2, e)


def rate_matrix_dot(e: np.ndarray, phi: np.ndarray, omega: np.ndarray) -> np.ndarray:
    """The derivative of (3.76b)."""
    k = np.sin(phi) / (2 * (1 - np.cos(phi)))
    rates = times(rate_matrix(e, phi), omega)
    e_dot, phi_dot = rates[..., :3], rates[..., 3]
    k_dot = -phi_dot / (2 * (1 - np.cos(phi)))
    upper = scalar(k_dot) * (ONE - outer(e, e)) - scalar(k) * (outer(e_dot, e) + outer(e, e_dot))
    return stacked(upper - cross_matrix(e_dot) / 2, e_dot)


def axis_point(e: np.ndarray, phi: np.ndarray, a: np.ndarray, a_moved: np.ndarray) -> np.ndarray:
    """p0, (3.18)."""
    Q = rotation(e, phi)
    d = times(Q, a) - a_moved
    return times(np.swapaxes(Q - ONE, -1, -2), d) / (2 * (1 - np.asarray(np.cos(phi))))[..., np.newaxis]


def steiner(I_C: np.ndarray, m: np.ndarray, c: np.ndarray, a: np.ndarray) -> np.ndarray:
    """I_A, (3.133)."""
    d = c - a
    return I_C + scalar(m) * (scalar(np.sum(d * d, axis=-1)) * ONE - outer(d, d))


def newton_euler(I_C: np.ndarray, m: np.ndarray, t: np.ndarray, t_dot: np.ndarray) -> np.ndarray:
    """The wrench, (3.139), block by block."""
    omega = t[..., :3]
    moment = times(I_C, t_dot[..., :3]) + np.cross(omega, times(I_C, omega))
    return np.concatenate([moment, np.asarray(m)[..., np.newaxis] * t_dot[..., 3:]], axis=-1)


def full(six: np.ndarray) -> np.ndarray:
    """The symmetric matrix of (xx, xy, xz, yy, yz, zz)."""
    return six[..., [[0, 1, 2], [1, 3, 4], [2, 4, 5]]]


def steiner_sym6(I_C: np.ndarray, m: np.ndarray, c: np.ndarray, a: np.ndarray) -> np.ndarray:
    """I_A in six numbers."""
    return steiner(full(I_C), m, c, a)[..., [0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]]


def newton_euler_sym6(I_C: np.ndarray, m: np.ndarray, t: np.ndarray, t_dot: np.ndarray) -> np.ndarray:
    """The wrench of an inertia in six numbers."""
    return newton_euler(full(I_C), m, t, t_dot)


WRITTEN = {
    "rotation_from_axis_angle": rotation,
    "natural_rate_matrix": rate_matrix,
    "natural_rate_matrix_dot": rate_matrix_dot,
    "screw_axis_point": axis_point,
    "inertia_about_point": steiner,
    "newton_euler_wrench": newton_euler,
    "inertia_about_point_sym6": steiner_sym6,
    "newton_euler_wrench_sym6": newton_euler_sym6,
}


def made(kernel: Kernel) -> Made:
    """One kernel; the result is copied where an array is given."""
    written = WRITTEN[kernel.name]

    def call(*inputs: Any, out: np.ndarray | None = None) -> np.ndarray:
        result = written(*inputs)
        if out is not None:
            out[...] = result
        return result

    return Made(call)


def make(kernels: Sequence[Kernel]) -> dict[str, Made]:
    """All kernels."""
    return {kernel.name: made(kernel) for kernel in kernels}
