"""The emitted kernels for arrays of any library of the array API: what goes in comes out, on its device.

``chasles.kernels.array_api.NAME`` is the readable text of the kernel whatever ``chasles.kernels.backend`` is: JAX may
trace, compile and differentiate it, PyTorch differentiate it, and array-api-strict watches over it. Arrays of
libraries that do not offer the array API themselves, as PyTorch's, need the package ``array-api-compat``. Lists and
numbers join the arrays beside them; without any they are NumPy's. Shapes and precision are as in ``chasles.kernels``.

Derivatives are those of the formula that is computed. Where a kernel has a limit because what is removable is removed
from its formula, as at phi = 0, the derivative is the limit's. Where a kernel gives NaN, so does its derivative.

Raises:
    AttributeError: for a name that is no kernel's.
"""

from __future__ import annotations

from typing import Any

from chasles.kernels import written_out

_module = written_out()
__all__ = list(_module.__all__)


def __getattr__(name: str) -> Any:
    if name in __all__:
        return getattr(_module, name)
    raise AttributeError(f"chasles.kernels.array_api has no kernel {name!r}; dir(chasles.kernels.array_api) lists all")


def __dir__() -> list[str]:
    return sorted(__all__)
