"""SciPy: `Rotation.from_rotvec`, for Q only."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from benchmarks.formulas import Kernel
from benchmarks.peers import Made
from scipy.spatial.transform import Rotation

TITLE = "SciPy Rotation"


def call(e: Any, phi: Any, out: np.ndarray | None = None) -> np.ndarray:
    """Q by way of the rotation vector; it cannot fill an array that is given."""
    made = Rotation.from_rotvec(np.asarray(phi)[..., np.newaxis] * e).as_matrix()
    if out is not None:
        out[...] = made
    return made


def make(kernels: Sequence[Kernel]) -> dict[str, Made]:
    """The rotation."""
    return {kernel.name: Made(call) for kernel in kernels if kernel.name == "rotation_from_axis_angle"}
