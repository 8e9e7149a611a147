"""The kernels with their inputs tested: ``chasles.checked.NAME`` takes and gives what ``chasles.kernels.NAME`` does.

What is tested is what `chasles emit` recorded of each kernel: core shapes, finite numbers, and the hypotheses that its
docstring names. An equation between numbers, as that of a unit vector, holds if it does to half of the digits of the
type that is computed in: within 1.5e-8 in float64, 3.5e-4 in float32, relative to the size of what is compared. A
matrix is positive-definite if its smallest principal value is more than the largest times the machine epsilon. What
must not vanish is broken where the kernel has no value because of it: a limit that the kernel gives passes.

Raises:
    ValueError: naming the kernel, the argument, what does not hold and the first index where, along the batch axes.
    TypeError: for another number of inputs, and for what is not a real number.
"""

from __future__ import annotations

from typing import Any

from chasles import kernels
from chasles.checked.call import Checked

_RECORD = "chasles.generated.numpy.hypotheses"
_KERNELS: dict[str, Any] = kernels.written_out(_RECORD).KERNELS
_made: dict[str, Checked] = {}


def __getattr__(name: str) -> Checked:
    if name not in _KERNELS:
        raise AttributeError(f"chasles.checked has no kernel {name!r}; dir(chasles.checked) lists all")
    if name not in _made:
        _made[name] = Checked(name, getattr(kernels, name), *_KERNELS[name])
    return _made[name]


def __dir__() -> list[str]:
    return sorted(_KERNELS)
