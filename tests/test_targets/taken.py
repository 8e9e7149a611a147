"""Kernels that are taken away: what they are, at which points they are called, and what they must give there."""

from __future__ import annotations

import ctypes
import math
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

import chasles
from chasles.compiling.kernel import kernel_of
from chasles.lowering.passes.series import expanded_in_series
from chasles.targets import Heading, TargetKernel, discover, place, render

from .conftest import PROGRAMS

PLACES = [place for folder in sys.path for place in Path(folder).glob("nvidia/*/bin/nvcc")]
NVCC = shutil.which("nvcc") or next(map(str, PLACES), None)
"""NVIDIA's compiler, also where it was installed from PyPI."""
KINDS = {"": np.float64, "f": np.float32}
SPECIAL = (0.0, -0.0, math.inf, -math.inf, math.nan, 1.0, -1.0, 2.5, -0.75, 1e30, 1e-30)
PLAIN = (0.3, -1.25, 2.0, 0.7, -0.4, 1.5)
ROWS = 80
LACKING = {"torch": ("gammas",)}
"""Kernels that a language cannot spell."""
PLAIN_POINTS = ("gammas",)
"""Kernels whose poles the Python of this machine may not know: Python's own gamma raises there."""

x, y, z = sp.symbols("x y z")
v = sp.Matrix(sp.symbols("v1:4"))
m = sp.MatrixSymbol("m", 2, 3)
EXPRESSIONS = {
    "ratio": (x / y, [x, y]),
    "turned": (sp.Matrix([[sp.cos(x), -sp.sin(x), 0], [sp.sin(x), sp.cos(x), 0], [0, 0, 1]]), [x]),
    "unit_and_length": ([v / v.norm(), v.norm()], {"v": v}),
    "sinc_in_pieces": (sp.Piecewise((1, sp.Eq(y, 0)), (sp.sin(sp.pi * y) / (sp.pi * y), y < 3)), [y]),
    "sinc_with_slope": (sp.sinc(x) * y, [x, y], True),
    "angles": ([sp.asin(x), sp.acos(x), sp.atan(x), sp.atan2(x, y), sp.tan(x / 4)], [x, y]),
    "extremes": ([sp.Abs(x), sp.sign(x), sp.Max(x, y, 2), sp.Min(x, y)], [x, y]),
    "constants": ([sp.Matrix([1, sp.pi, sp.Rational(1, 3), -sp.sqrt(2)]), x], [x, y]),
    "products": (m * m.T, [m]),
    "in_between": (sp.Piecewise((x, sp.And(x > 0, y <= x)), (y, sp.Or(x < y, sp.Ne(x, 2)))), [x, y]),
    "new": (x - 2 * y + z, sp.symbols("fn match self") and [x, y, z]),
    "polynomial": (x**5 - 3 * x**3 / 7 + sp.Rational(12345678901234567, 3) * x - 1, [x]),
    "exponentials": ([sp.exp(x), sp.log(y), x**y, sp.sinh(x), sp.cosh(y), sp.tanh(x), x ** sp.Rational(7, 5)], [x, y]),
    "inverses": ([sp.asinh(x), sp.acosh(x), sp.atanh(y), sp.log(1 + x**2), sp.cbrt(y), x**40], [x, y]),
    "steps": ([sp.floor(x), sp.ceiling(y), sp.frac(x), sp.Heaviside(y), 1 + sp.Mod(x, 3)], [x, y]),
    "errors": ([sp.erf(x), sp.erfc(y), sp.exp(-(x**2))], [x, y]),
    "gammas": ([sp.gamma(x), sp.loggamma(y)], [x, y]),
    "keywords": (
        sp.Add(
            *(k * s for k, s in enumerate(sp.symbols("let impl template operator_ std gradient half jnp torch I"), 1))
        ),
        sp.symbols("let impl template operator_ std gradient half jnp torch I"),
    ),
}


@pytest.fixture(scope="session")
def taken():
    """The kernels by their names, with NumPy's text to be called: nothing is compiled here."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CC", "no-such-compiler")
        kernels = {name: kernel_of(program) for name, program in PROGRAMS.items()}
        for name, (expression, inputs, *jacobian) in EXPRESSIONS.items():
            kernels[name] = chasles.compile(expression, inputs, name=name, jacobian=bool(jacobian))
    return kernels


@pytest.fixture(scope="session")
def written_out(taken, tmp_path_factory):
    """Writes all kernels for a target into one folder, which it gives."""

    def folder(target):
        root = tmp_path_factory.mktemp(target)
        for name, kernel in taken.items():
            if name not in LACKING.get(target, ()):
                kernel.write(root, target)
        return root / target

    return folder


@pytest.fixture(scope="session")
def emitted_as(taken, tmp_path_factory):
    """Emits all kernels together in a language, into the folder that it gives."""

    def folder(target):
        heading = Heading("3.1", "A /* test */.", "holds", ("x != 0",), "0" * 64)
        kernels = [TargetKernel(expanded_in_series(kernel.program), heading) for kernel in taken.values()]
        texts = render(kernels, discover(named=[target]))
        root = tmp_path_factory.mktemp(target)
        place(root, texts)
        return root / target

    return folder


def points(program, kind):
    """Rows of inputs: plain ones, then such with a zero, an infinity, NaN or a large number here and there."""
    random = np.random.default_rng(len(program.name))
    shapes = [argument.shape for argument in program.arguments]
    for row in range(ROWS):
        values = [random.choice(PLAIN, shape) + random.integers(0, 5, shape) / 8 for shape in shapes]
        if row >= ROWS // 4 and program.name not in PLAIN_POINTS:
            values = [np.where(random.random(a.shape) < 0.4, random.choice(SPECIAL, a.shape), a) for a in values]
        yield [np.array(a, kind) for a in values]


def wanted(kernel, inputs):
    """The results of the Python kernel."""
    with np.errstate(all="ignore"):
        found = kernel.array_api(*inputs)
    return found if isinstance(found, tuple) else (found,)


def require_right(kernel, called):
    """Compare `called(kind, inputs)`, a list of arrays, with the Python kernel at all points in both precisions."""
    for kind in KINDS.values():
        rows = list(points(kernel.program, kind))
        expected = wanted(kernel, [np.stack(column) for column in zip(*rows, strict=True)])
        got = [np.stack(column) for column in zip(*(called(kind, row) for row in rows), strict=True)]
        for result, found, values in zip(kernel.program.results, got, expected, strict=True):
            require_close(f"{kernel.name}: {result.name}", kind, rows, found, values)


def require_close(name, kind, rows, got, expected):
    """Within a few roundoffs of the largest entry of a result; NaN, infinities and the signs of zeros as they are."""
    assert (got.shape, got.dtype) == (expected.shape, expected.dtype), name
    finite = np.isfinite(expected)
    with np.errstate(invalid="ignore"):
        off = np.abs(got - expected)
    largest = np.where(finite, np.abs(expected), 0).reshape(len(rows), -1).max(axis=-1)
    allowed = 16 * np.finfo(kind).eps * np.maximum(1, largest).reshape(-1, *[1] * (got.ndim - 1))
    same = (got == expected) & (np.signbit(got) == np.signbit(expected)) | np.isnan(got) & np.isnan(expected)
    right = np.where(finite & (expected != 0), off <= allowed, same | finite & (got != 0) & (off <= allowed))
    for row in np.flatnonzero(~right.reshape(len(rows), -1).all(axis=-1)):
        raise AssertionError(f"{name} of {rows[row]} in {kind.__name__}: {got[row]}, expected {expected[row]}")


def caller(library, kernel):
    """Calls `run_NAME` of a shared library, or `run_NAMEf`, with the addresses of the inputs and of the outputs."""

    def called(kind, inputs):
        function = library[f"run_{kernel.name}{'' if kind is np.float64 else 'f'}"]
        outputs = [np.full(result.shape, 77, kind) for result in kernel.program.results]
        given, made = ((ctypes.c_void_p * len(part))(*(a.ctypes.data for a in part)) for part in (inputs, outputs))
        function.restype = None
        function(given, made)
        return outputs

    return called
