"""The kernels of the book as installed, at every level of instructions: against the scalar C functions, bit for bit.

The inputs are hostile: zeros of both signs, denormals, the largest numbers, infinities, NaN and huge angles, among
plain ones.
"""

from __future__ import annotations

import ctypes
import re
import shutil
import subprocess
import warnings
from importlib import import_module
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from chasles import kernels

from .sampling import WHOLE

ROOT = Path(__file__).resolve().parents[1]
SOURCES = ROOT / "generated" / "c"
CC = shutil.which("gcc") or shutil.which("cc")
ITEMS = 1500
SPECIAL = [0.0, -0.0, 1.0, -1.0, 5e-324, -1e-310, 1e-40, 1e300, -1e300, 1e38, np.inf, -np.inf, np.nan]
ANGLES = [np.pi, np.pi / 2, -np.pi / 2, 1.6e6, -1.6e6, 1e15, 1e22]
LEVELS = ("baseline", "x86-64-v3", "x86-64-v4")

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(CC is None or not SOURCES.exists(), reason="needs the checkout and a C compiler"),
    pytest.mark.skipif(kernels.backend != "c", reason="needs compiled kernels"),
]


@pytest.fixture(scope="module")
def scalar(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    """The C functions for one item."""
    out = tmp_path_factory.mktemp("scalar") / "libchasles.so"
    flags = ["-std=c99", "-O1" if WHOLE else "-O0", "-shared", "-fPIC", f"-I{SOURCES}/include"]
    subprocess.run([str(CC), *flags, *sorted((SOURCES / "src").glob("*.c")), "-lm", "-o", out], check=True)
    return ctypes.CDLL(str(out))


@pytest.fixture(scope="module", params=LEVELS)
def level(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    """The installed ufuncs, made to use the instructions of one level."""
    if LEVELS.index(request.param) > LEVELS.index(kernels.instructions):
        pytest.skip(f"no {request.param} here")
    original = import_module("chasles._kernels").__file__
    assert original is not None
    copy = Path(shutil.copy(original, tmp_path_factory.mktemp(request.param)))
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CHASLES_INSTRUCTIONS", request.param)
        spec = spec_from_file_location(f"{request.param}._kernels", copy)
        assert spec is not None
        assert spec.loader is not None
        module = module_from_spec(spec)
        spec.loader.exec_module(module)
    assert module.instructions == request.param
    return module


def shapes_of(part: str) -> list[tuple[int, ...]]:
    return [tuple(map(int, re.findall(r"\d+", core))) for core in re.findall(r"\(([\d,]*)\)", part)]


def hostile(name: str, kind: type) -> list[Any]:
    """Inputs of a kernel: plain items, items with an odd number, and items that are mostly odd numbers."""
    random = np.random.default_rng(sum(map(ord, name)))
    drawn = []
    for shape in shapes_of(getattr(kernels, name).signature.split("->")[0]):
        plain = random.uniform(-2, 2, (ITEMS, *shape))
        odd = random.random(plain.shape) < random.choice([0, 0.1, 0.6], (ITEMS, *[1] * len(shape)))
        with np.errstate(all="ignore"):
            drawn.append(np.where(odd, random.choice([*SPECIAL, *ANGLES], plain.shape), plain).astype(kind))
    return drawn


def one_by_one(library: ctypes.CDLL, name: str, inputs: list[Any], kind: type) -> list[Any]:
    """What the scalar function gives for each item."""
    number = {np.float64: ctypes.c_double, np.float32: ctypes.c_float}[kind]
    function = getattr(library, f"chasles_{name}{'' if kind is np.float64 else 'f'}")
    outs = [np.zeros((ITEMS, *shape), kind) for shape in shapes_of(getattr(kernels, name).signature.split("->")[1])]
    for i in range(ITEMS):
        given = [number(x[i]) if x.ndim == 1 else ctypes.c_void_p(x.ctypes.data + i * x.strides[0]) for x in inputs]
        function(*given, *(ctypes.c_void_p(out.ctypes.data + i * out.strides[0]) for out in outs))
    return outs


def in_a_batch(ufunc: np.ufunc, inputs: list[Any]) -> tuple[list[Any], list[str]]:
    """The results and what NumPy says of the floating-point state."""
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        with np.errstate(all="warn"):
            found = ufunc(*inputs)
    return list(found) if isinstance(found, tuple) else [found], [str(one.message) for one in said]


def has_nan(arrays: list[Any]) -> Any:
    return np.any([np.isnan(array).reshape(len(array), -1).any(axis=1) for array in arrays], axis=0)


def turns(name: str) -> bool:
    """Whether a sine or a cosine is in the kernel, whose last bit depends on the level."""
    return re.search(r"operations .*\b(sine|cosine)", getattr(kernels, name).__doc__ or "") is not None


@pytest.mark.sampled(13)
@pytest.mark.parametrize("kind", [np.float64, np.float32])
@pytest.mark.parametrize("name", sorted(set(dir(kernels)) - {"array_api", "backend", "instructions", "one"}))
def test_a_batch_is_what_the_scalar_function_gives(
    name: str, kind: type, level: ModuleType, scalar: ctypes.CDLL
) -> None:
    inputs = hostile(name, kind)
    expected = one_by_one(scalar, name, inputs, kind)
    found, said = in_a_batch(getattr(level, name), inputs)
    # The largest numbers are left out where that last bit can say whether a product overflows.
    huge = [(np.abs(x) > 1e16) & np.isfinite(x) for x in inputs]
    compared = ~np.any([x.reshape(ITEMS, -1).any(axis=1) for x in huge], axis=0) if turns(name) else slice(None)
    for got, value in ((one[compared], other[compared]) for one, other in zip(found, expected, strict=True)):
        assert np.array_equal(np.isnan(got), np.isnan(value))
        assert np.array_equal(np.isinf(got), np.isinf(value))
        assert turns(name) or np.array_equal(got, value, equal_nan=True)
        assert turns(name) or np.array_equal(np.signbit(got) & ~np.isnan(got), np.signbit(value) & ~np.isnan(value))
    singular = has_nan(found) & ~has_nan(inputs)
    assert said == ([f"invalid value encountered in {name}"] if singular.any() else [])
    assert in_a_batch(getattr(level, name), [x[~singular] for x in inputs])[1] == []
