"""The emitted kernels: compiled generalised ufuncs where a C compiler was at hand, else the same formulas in NumPy.

``chasles.kernels.NAME`` broadcasts over leading batch axes; shapes, units and the source equation stand in each
docstring. ``NAME_sym6`` takes and gives a symmetric matrix as (xx, xy, xz, yy, yz, zz), where ``NAME`` reads all nine
numbers. Inputs are not tested; ``chasles.checked`` does that. ``chasles.kernels.one.NAME`` is the same for one element
or a C-contiguous batch of one shape, all of one precision, for a fraction of a call's time. Compiled loops release the
global lock; sub-interpreters are not supported. ``chasles.kernels.array_api.NAME`` takes arrays of JAX, PyTorch and
every other library of the array API and gives such arrays.

``chasles.kernels.backend`` is ``"c"`` or ``"numpy"``. The environment variable ``CHASLES_BACKEND``, read once at
import, chooses: ``numpy`` takes the NumPy kernels, ``c`` insists on the compiled ones; unset or empty takes the
compiled ones where they load. ``chasles.kernels.instructions`` says for which instructions the compiled loops that run
were built; ``CHASLES_INSTRUCTIONS``, read once at import too, insists on ``baseline``, ``x86-64-v3`` or ``x86-64-v4``.
Where no angle comes in all builds give the same bits.

Raises:
    ImportError: ``CHASLES_BACKEND`` holds another word, asks for compiled kernels that are not there, or no kernels
        were emitted at all.
"""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from os import environ
from types import ModuleType
from typing import Any
from warnings import warn

_COMPILED = "chasles._kernels"
_WRITTEN_OUT = "chasles.generated.numpy.kernels"


def written_out(name: str = _WRITTEN_OUT) -> ModuleType:
    """The module of the NumPy kernels, or one that is emitted with it; raises ImportError where none were emitted."""
    try:
        return import_module(name)
    except ModuleNotFoundError as error:
        if error.name is None or not name.startswith(error.name):
            raise
        raise ImportError("no kernels were emitted; `chasles emit` writes them into generated/") from error


def _choose(wanted: str) -> tuple[str, ModuleType]:
    """The backend's name and the module that holds its kernels."""
    if wanted not in ("", "c", "numpy"):
        raise ImportError(f"CHASLES_BACKEND is {wanted!r}; expected 'c', 'numpy' or nothing")
    if wanted == "numpy":
        return "numpy", written_out()
    reason = "there are none here (no C compiler or no Python.h at installation)"
    if find_spec(_COMPILED) is not None:
        try:
            return "c", import_module(_COMPILED)
        except ImportError as error:
            reason = f"loading them failed ({error})"
            if not wanted:
                warn(f"NumPy kernels in place of the compiled ones: {reason}", RuntimeWarning, stacklevel=2)
    if wanted == "c":
        raise ImportError(f"CHASLES_BACKEND is 'c', but the compiled kernels cannot be had: {reason}")
    return "numpy", written_out()


backend, _module = _choose(environ.get("CHASLES_BACKEND", ""))
instructions: str = getattr(_module, "instructions", "")
one: Any = getattr(_module, "one", _module)
make_ufunc: Any = getattr(_module, "make_ufunc", None)
"""For `chasles.compile`: the ufunc of an inner loop compiled elsewhere; None where nothing is compiled."""
make_light: Any = getattr(_module, "make_light", None)
"""The same for a light function."""
_names = frozenset(name for name in getattr(_module, "__all__", dir(_module)) if not name.startswith("_"))


def __getattr__(name: str) -> Any:
    if name == "array_api":
        return import_module(f"{__name__}.array_api")
    if name in _names:
        from chasles.kernels.signatures import named

        kernel = globals()[name] = named(getattr(_module, name), getattr(one, name))
        return kernel
    raise AttributeError(f"chasles.kernels ({backend}) has no kernel {name!r}; dir(chasles.kernels) lists all")


def __dir__() -> list[str]:
    return ["array_api", "backend", "instructions", "one", *sorted(_names)]
