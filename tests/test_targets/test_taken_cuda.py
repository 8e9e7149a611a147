"""CUDA that is taken away: the host's functions give what the Python kernel gives, and batches where a GPU is."""

from __future__ import annotations

import ctypes
import re
import shutil
import subprocess

import numpy as np
import pytest
import sympy

import chasles

from .conftest import PROGRAMS
from .taken import EXPRESSIONS, KINDS, NVCC, caller, points, require_close, require_right, taken, wanted, written_out  # noqa: F401

CXX = shutil.which("g++")
HOST = "-Wall,-Wextra,-Wconversion,-Werror,-ffp-contract=off,-fPIC"
NUMBERS = {"": "double", "f": "float"}
ITEMS = 101


def host_shim(name, kernel, suffix, number):
    """A function that takes addresses alone."""
    program = kernel.program
    given = [f"in[{k}]" if item.shape else f"*in[{k}]" for k, item in enumerate(program.arguments)]
    made = [f"out[{k}]" for k in range(len(program.results))]
    yield f'extern "C" void run_{name}{suffix}(const {number} *const *in, {number} *const *out)'
    yield f"{{ chasles_{name}{suffix}({', '.join([*given, *made])}); }}"


def device_shim(name, kernel, suffix, number):
    """A function that takes addresses of batches in the memory of the host."""
    program = kernel.program
    sizes = [int(np.prod(item.shape, dtype=int)) for item in program.parameters]
    first = len(program.arguments)
    yield f'extern "C" int batch_{name}{suffix}(const {number} *const *in, {number} *const *out, size_t n) {{'
    for k, size in enumerate(sizes):
        yield f"{number} *p{k}; if (cudaMallocManaged(&p{k}, n * {size} * sizeof({number}))) return 1;"
        if k < first:
            yield f"memcpy(p{k}, in[{k}], n * {size} * sizeof({number}));"
    passed = ", ".join(f"p{k}, {size}" for k, size in enumerate(sizes))
    yield f"if (chasles_{name}_batch{suffix}(n, {passed}) || cudaDeviceSynchronize()) return 2;"
    for k, size in enumerate(sizes):
        if k >= first:
            yield f"memcpy(out[{k - first}], p{k}, n * {size} * sizeof({number}));"
        yield f"cudaFree(p{k});"
    yield "return 0; }"


STAND_IN = """
#include <stddef.h>
#define __CUDACC__
#define __global__
#define __host__
#define __device__
typedef int cudaError_t;
typedef void *cudaStream_t;
struct Place { unsigned x; };
static Place gridDim = {3}, blockDim = {4}, blockIdx, threadIdx;
inline cudaError_t cudaGetLastError() { return 0; }
"""


def stand_in_shim(name, kernel, suffix, number):
    """What a launch does, one thread after the other on the host."""
    sizes = [int(np.prod(item.shape, dtype=int)) for item in kernel.program.parameters]
    first = len(kernel.program.arguments)
    places = [f"in[{k}], {size}" if k < first else f"out[{k - first}], {size}" for k, size in enumerate(sizes)]
    yield f'extern "C" int batch_{name}{suffix}(const {number} *const *in, {number} *const *out, size_t n) {{'
    yield "for (blockIdx.x = 0; blockIdx.x < 3; blockIdx.x++) for (threadIdx.x = 0; threadIdx.x < 4; threadIdx.x++)"
    yield f"if (chasles_{name}_batch{suffix}(n, {', '.join(places)})) return 2;"
    yield "return 0; }"


def library(room, folder, kernels, command, suffix):
    lines = ["#include <string.h>", *(f'#include "{name}.cuh"' for name in kernels)]
    for name, kernel in kernels.items():
        for precision in NUMBERS.items():
            lines += host_shim(name, kernel, *precision)
            lines += device_shim(name, kernel, *precision) if suffix == "cu" else ()
    if suffix == "cu":
        lines += ['extern "C" int devices(void)', "{ int n = 0; return cudaGetDeviceCount(&n) ? 0 : n; }"]
    (room / f"shim.{suffix}").write_text("\n".join(lines))
    words = [*command, "-shared", f"-I{folder}", room / f"shim.{suffix}", "-o", room / "a.so"]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return ctypes.CDLL(str(room / "a.so"))


@pytest.fixture(scope="module")
def as_cuda(taken, written_out, tmp_path_factory):  # noqa: F811
    """The kernels compiled by nvcc."""
    if NVCC is None:
        pytest.skip("no nvcc (on PyPI: nvidia-cuda-nvcc)")
    command = [
        NVCC,
        "-std=c++17",
        "-O1",
        "-Xcicc",
        "-O0",
        "-Xptxas",
        "-O0",
        "-Werror",
        "all-warnings",
        "-Xcompiler",
        HOST,
    ]
    return library(tmp_path_factory.mktemp("nvcc"), written_out("cuda"), taken, command, "cu")


@pytest.fixture(scope="module")
def as_cpp(taken, written_out, tmp_path_factory):  # noqa: F811
    """The kernels compiled as C++."""
    if CXX is None:
        pytest.skip("no C++ compiler")
    command = [CXX, "-std=c++11", "-O1", "-pedantic", "-Wdouble-promotion", "-Wshadow", *HOST.split(",")]
    return library(tmp_path_factory.mktemp("cpp"), written_out("cuda"), taken, command, "cpp")


@pytest.fixture(scope="module")
def as_stand_in(taken, written_out, tmp_path_factory):  # noqa: F811
    """The batches as C++, with the words of CUDA put in other words."""
    if CXX is None:
        pytest.skip("no C++ compiler")
    folder, room = written_out("cuda"), tmp_path_factory.mktemp("stand_in")
    lines = [STAND_IN]
    for name, kernel in taken.items():
        text = (folder / f"{name}.cuh").read_text()
        assert text.count("<<<blocks, threads, 0, stream>>>(") == 2
        lines.append(text.replace("<<<blocks, threads, 0, stream>>>", ""))
        lines += [line for precision in NUMBERS.items() for line in stand_in_shim(name, kernel, *precision)]
    (room / "shim.cpp").write_text("\n".join(lines))
    words = [CXX, "-std=c++17", "-Wno-unused-parameter", "-O0", "-ffp-contract=off", "-shared", "-fPIC"]
    done = subprocess.run([*words, room / "shim.cpp", "-o", room / "a.so"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return ctypes.CDLL(str(room / "a.so"))


@pytest.mark.sampled(7)
@pytest.mark.parametrize("compiled", ["as_cuda", "as_cpp"])
@pytest.mark.parametrize("function", [*PROGRAMS, *EXPRESSIONS])
def test_the_functions_of_the_host_are_those_of_the_python_kernel(request, compiled, taken, function):  # noqa: F811
    require_right(taken[function], caller(request.getfixturevalue(compiled), taken[function]))


@pytest.mark.sampled(7)
@pytest.mark.parametrize("compiled", ["as_cuda", "as_stand_in"])
@pytest.mark.parametrize("function", [*PROGRAMS, *EXPRESSIONS])
def test_batches_are_those_of_the_python_kernel(request, compiled, taken, function):  # noqa: F811
    library = request.getfixturevalue(compiled)
    if compiled == "as_cuda" and library.devices() == 0:
        pytest.skip("no GPU")
    kernel = taken[function]
    for suffix, kind in KINDS.items():
        rows = (list(points(kernel.program, kind)) * ITEMS)[:ITEMS]
        batches = [np.stack(column) for column in zip(*rows, strict=True)]
        made = [np.full((ITEMS, *result.shape), 77, kind) for result in kernel.program.results]
        places = ((ctypes.c_void_p * len(part))(*(a.ctypes.data for a in part)) for part in (batches, made))
        assert library[f"batch_{function}{suffix}"](*places, ctypes.c_size_t(ITEMS)) == 0
        for got, expected in zip(made, wanted(kernel, batches), strict=True):
            require_close(kernel.name, kind, rows, got, expected)


def test_no_argument_has_the_name_of_a_function(tmp_path):
    x, y = sympy.symbols("chasles_product chasles_product_items")
    [path] = chasles.compile(x * y, [x, y], name="product").write(tmp_path, "cuda")
    items = path.read_text().split("static __global__ void chasles_product_items(")[1].split(")")[0]
    assert re.findall(r"double \*?(\w+)", items) == ["chasles_product_", "chasles_product_items_", "result"]
