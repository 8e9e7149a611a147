"""C++ that is taken away: functions of spans and of Eigen's matrices, which give what the Python kernel gives."""

from __future__ import annotations

import ctypes
import math
import os
import shutil
import subprocess
from pathlib import Path

import pytest

from .conftest import PROGRAMS
from .taken import EXPRESSIONS, caller, require_right, taken, written_out  # noqa: F401

CXX = shutil.which("g++") or shutil.which("clang++")
WARNINGS = "-Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror -pedantic"
STRICT = ["-std=c++20", "-ffp-contract=off", *WARNINGS.split()]
EIGEN = next(
    (
        folder
        for folder in (os.environ.get("EIGEN", ""), "/usr/include/eigen3", "/usr/local/include/eigen3")
        if folder and (Path(folder) / "Eigen/Core").is_file()
    ),
    None,
)
CALLED = {"new": "new_", "keywords": "keywords"}
pytestmark = pytest.mark.skipif(CXX is None, reason="no C++ compiler")


def span_shim(kernel, number):
    """The call with spans."""
    program = kernel.program
    for place, item in enumerate(program.parameters):
        is_input = place < len(program.arguments)
        at = f"in[{place}]" if is_input else f"out[{place - len(program.arguments)}]"
        kind = f"std::span<{'const ' if is_input else ''}{number}, {math.prod(item.shape)}>"
        yield f"{kind}({at}, {math.prod(item.shape)})" if item.shape else f"*{at}"


def eigen_shim(kernel, number):
    """The call with maps, of which those that come in may be expressions and those that go out are columns."""
    program = kernel.program
    for place, item in enumerate(program.parameters):
        is_input = place < len(program.arguments)
        at = f"in[{place}]" if is_input else f"out[{place - len(program.arguments)}]"
        if not item.shape:
            yield f"*{at}"
        elif is_input:
            rows, columns = (*item.shape, 1)[:2]
            order = "Eigen::RowMajor" if columns > 1 else "Eigen::ColMajor"
            yield f"Eigen::Map<const Eigen::Matrix<{number}, {rows}, {columns}, {order}>>({at}) * {number}(1)"
        else:
            yield f"m{place}"


def eigen_call(kernel, number, name):
    program = kernel.program
    first = len(program.arguments)
    for place, item in enumerate(program.results):
        if item.shape:
            rows, columns = (*item.shape, 1)[:2]
            yield f"Eigen::Matrix<{number}, {rows}, {columns}> m{first + place};"
    yield f"chasles::{name}({', '.join(eigen_shim(kernel, number))});"
    for place, item in enumerate(program.results):
        if item.shape:
            rows, columns = (*item.shape, 1)[:2]
            for entry in range(rows * columns):
                yield f"out[{place}][{entry}] = m{first + place}({entry // columns}, {entry % columns});"


def source(taken, eigen):  # noqa: F811
    if eigen:
        yield "#include <Eigen/Core>"
    for name in taken:
        yield f'#include "{name}.hpp"'
    yield from ('#include "ratio.hpp"', 'extern "C" {')
    for name, kernel in taken.items():
        called = CALLED.get(name, name)
        for number, suffix in (("double", ""), ("float", "f")):
            yield f"void run_{name}{suffix}(const {number} *const *in, {number} *const *out);"
            yield f"void run_{name}{suffix}(const {number} *const *in, {number} *const *out) {{"
            if eigen:
                yield from eigen_call(kernel, number, called)
            else:
                yield f"chasles::{called}({', '.join(span_shim(kernel, number))});"
            yield "}"
    yield "}"


@pytest.fixture(scope="module", params=["span", "Eigen::Ref"])
def library_alone(request, taken, written_out, tmp_path_factory):  # noqa: F811
    eigen = request.param != "span"
    if eigen and EIGEN is None:
        pytest.skip("no Eigen (Debian: libeigen3-dev, or its folder in $EIGEN)")
    folder, room = written_out("cpp"), tmp_path_factory.mktemp("alone")
    (room / "shim.cpp").write_text("\n".join(source(taken, eigen)))
    folders = [f"-I{folder}", *(["-isystem", EIGEN] if eigen else [])]
    command = [
        CXX,
        *STRICT,
        "-O0" if eigen else "-O1",
        "-shared",
        "-fPIC",
        *folders,
        room / "shim.cpp",
        "-o",
        room / "a.so",
    ]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return ctypes.CDLL(str(room / "a.so"))


@pytest.mark.sampled(7)
@pytest.mark.parametrize("function", [*PROGRAMS, *EXPRESSIONS])
def test_the_functions_are_those_of_the_python_kernel(library_alone, taken, function):  # noqa: F811
    require_right(taken[function], caller(library_alone, taken[function]))
