"""Every build of a kernel: NumPy, the C function for one item, the loops of each level, and the light path."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from importlib.util import module_from_spec, spec_from_file_location
from os import environ
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from chasles import kernels
from chasles.lowering.program import Program

__all__ = ["Build", "builds", "modules"]

LEVELS = ("baseline", "x86-64-v3", "x86-64-v4")
SOURCES = Path(__file__).resolve().parents[2] / "generated" / "c"
FLAGS = ("-std=c99", "-O2", "-fno-math-errno", "-ffp-contract=off", "-shared", "-fPIC")

Array = np.ndarray[Any, Any]
Batch = Callable[[Program, Sequence[Array]], list[Array]]


@dataclass(frozen=True, slots=True)
class Build:
    """What computes the results of a batch, and the module of its functions where these take any storage."""

    call: Batch
    module: ModuleType | None = None

    def __call__(self, program: Program, inputs: Sequence[Array]) -> list[Array]:
        """The results, each an array with the batch axis first."""
        return self.call(program, inputs)


@cache
def builds(folder: Path) -> dict[str, Build]:
    """All that can be had here, by name; what has to be compiled or copied goes into the folder, and is used again.

    Raises RuntimeError where the installed kernels are not compiled, CalledProcessError where the C does not compile.
    """
    if kernels.backend != "c":
        raise RuntimeError("the kernels are to be compiled ones; set CHASLES_BACKEND=c to see why they are not")
    library, written_out = _library(folder), import_module("chasles.generated.numpy.kernels")
    found: dict[str, Build] = {
        "numpy": Build(_called(written_out), written_out),
        "c": Build(lambda program, inputs: _one_by_one(library, program, inputs)),
    }
    for level in LEVELS:
        module = _loaded(level, folder)
        if module is not None:
            found[f"gufunc {level}"] = Build(_called(module), module)
            found[f"one {level}"] = Build(_called(module.one))
    return found


def modules(found: dict[str, Build]) -> dict[str, ModuleType]:
    """Those of the builds whose functions take any storage."""
    return {name: build.module for name, build in found.items() if build.module is not None}


def _library(folder: Path) -> ctypes.CDLL:
    compiler = environ.get("CC") or shutil.which("gcc") or shutil.which("cc") or "cc"
    target = folder / "libchasles.so"
    if target.exists():
        return ctypes.CDLL(str(target))
    sources = sorted((SOURCES / "src").glob("*.c"))
    subprocess.run([compiler, *FLAGS, f"-I{SOURCES}/include", *sources, "-lm", "-o", target], check=True)
    return ctypes.CDLL(str(target))


def _loaded(level: str, folder: Path) -> ModuleType | None:
    """The installed extension, made to run with the instructions of a level; None where this machine has not these."""
    original = import_module("chasles._kernels").__file__
    assert original is not None
    (folder / level).mkdir(exist_ok=True)
    copy = folder / level / Path(original).name
    if not copy.exists():
        shutil.copy(original, copy)
    before = environ.get("CHASLES_INSTRUCTIONS")
    environ["CHASLES_INSTRUCTIONS"] = level
    try:
        spec = spec_from_file_location(f"{level}._kernels", copy)
        assert spec is not None
        assert spec.loader is not None
        module = module_from_spec(spec)
        spec.loader.exec_module(module)
    except ImportError:
        return None
    finally:
        del environ["CHASLES_INSTRUCTIONS"]
        if before is not None:
            environ["CHASLES_INSTRUCTIONS"] = before
    return module


def _called(module: Any) -> Batch:
    def build(program: Program, inputs: Sequence[Array]) -> list[Array]:
        with np.errstate(all="ignore"):
            found = getattr(module, program.name)(*inputs)
        return list(found) if isinstance(found, tuple) else [found]

    return build


def _one_by_one(library: ctypes.CDLL, program: Program, inputs: Sequence[Array]) -> list[Array]:
    single = inputs[0].dtype == np.float32
    number = ctypes.c_float if single else ctypes.c_double
    function = getattr(library, f"chasles_{program.name}{'f' if single else ''}")
    items = len(inputs[0])
    outs = [np.zeros((items, *result.shape), inputs[0].dtype) for result in program.results]
    scalars = [x.tolist() if x.ndim == 1 else None for x in inputs]
    places = [(x.ctypes.data, x.strides[0]) for x in (*inputs, *outs)]
    for i in range(items):
        arguments: list[Any] = [
            number(scalar[i]) if scalar is not None else ctypes.c_void_p(start + i * step)
            for scalar, (start, step) in zip([*scalars, *[None] * len(outs)], places, strict=True)
        ]
        function(*arguments)
    return outs
