"""The kernels of another chapter: of its C library where that is compiled, in NumPy where it is not."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping, Sequence
from os import environ
from pathlib import Path
from types import ModuleType
from typing import Any
from warnings import warn

from chasles import kernels
from chasles.kernels.signatures import named

COMPILED = "compiled"
"""The folder beside a chapter's kernels with its shared object, which is called as its sources are hashed."""
LEVELS = ("baseline", "x86-64-v3", "x86-64-v4")
"""In the order of `batches.h`; the first is the compiler's own target."""

Operands = Mapping[str, tuple[str, Sequence[str], Sequence[str]]]
"""By the kernel's name its signature, and the names of its inputs and outputs."""


def kernels_of(written: ModuleType, folder: Path, digest: str, operands: Operands) -> dict[str, Any]:
    """What the module of a chapter's kernels holds, by name: `backend`, `instructions`, `one` and each kernel.

    Raises ImportError where `CHASLES_BACKEND` insists on compiled kernels, and there are none.
    """
    library, reason = _library(folder, digest)
    one = ModuleType(f"{written.__package__}.one", "Each kernel for one element or a C-contiguous batch of one shape.")
    if library is None:
        if environ.get("CHASLES_BACKEND") == "c":
            raise ImportError(f"CHASLES_BACKEND is 'c', but the compiled kernels in {folder} cannot be had: {reason}")
        if (folder / COMPILED).is_dir() and kernels.make_ufunc is not None:
            said = f"NumPy kernels in place of the compiled ones in {folder}: {reason}"
            warn(said, RuntimeWarning, stacklevel=3)
        known = {name: getattr(written, name) for name in operands}
        vars(one).update(known)
        return {**known, "one": one, "backend": "numpy", "instructions": ""}
    known = {}
    for number, (name, (signature, inputs, outputs)) in enumerate(operands.items()):
        doc = getattr(written, name).__doc__ or ""
        ufunc, light = functions_of(library, number, name, doc, signature, inputs, outputs)
        known[name] = named(ufunc, light)
        setattr(one, name, light)
    level = library.chasles_limit(LEVELS.index(kernels.instructions))
    return {**known, "one": one, "backend": "c", "instructions": LEVELS[level]}


def functions_of(
    library: ctypes.CDLL,
    number: int,
    name: str,
    doc: str,
    signature: str,
    inputs: Sequence[str],
    outputs: Sequence[str],
) -> tuple[Any, Any]:
    """The ufunc of a kernel, by its number in the shared object, and its light function."""
    data = library.chasles_data
    data.restype = ctypes.c_void_p
    loops = data(2 * number), data(2 * number + 1)
    entry, items = (ctypes.cast(f, ctypes.c_void_p).value for f in (library.chasles_entry, library.chasles_items))
    call = f"{name}({', '.join(inputs)}, /, *, out=None)\n--\n\n"
    return (
        kernels.make_ufunc(name, doc, signature, len(inputs), len(outputs), entry, *loops),
        kernels.make_light(name, call + doc, (*inputs, *outputs), items, *loops),
    )


def _library(folder: Path, digest: str) -> tuple[ctypes.CDLL | None, str]:
    """The shared object of these sources; else None, and why."""
    if kernels.make_ufunc is None:
        return None, f"the kernels of chasles are those of {kernels.backend!r} here"
    path = folder / COMPILED / f"{digest}.so"
    build = "`chasles --chapter ... build` compiles them"
    if path.is_file():
        try:
            return ctypes.CDLL(str(path)), ""
        except OSError as error:
            return None, f"loading them failed ({error}); {build}"
    return None, f"what was emitted last is not compiled; {build}"
