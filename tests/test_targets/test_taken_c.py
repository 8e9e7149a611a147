"""C that is taken away: a header and a source for each kernel, without a warning, equal to the Python kernel."""

from __future__ import annotations

import ctypes
import os
import re

import pytest
import sympy as sp

import chasles

from .conftest import PROGRAMS
from .taken import EXPRESSIONS, caller, require_right, taken, written_out  # noqa: F401

STRICT = "-std=c99 -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Wmissing-prototypes -Werror -pedantic"
x, y = sp.symbols("x y")


@pytest.fixture(autouse=True)
def nothing_is_compiled_to_be_called(monkeypatch):
    monkeypatch.setenv("CC", "no-such-compiler")


def shim(kernel):
    """Functions that take addresses alone."""
    program = kernel.program
    for number, suffix in (("double", ""), ("float", "f")):
        given = [f"in[{k}]" if item.shape else f"*in[{k}]" for k, item in enumerate(program.arguments)]
        made = [f"out[{k}]" for k in range(len(program.results))]
        yield f"void run_{kernel.name}{suffix}(const {number} *const *in, {number} *const *out);"
        yield f"void run_{kernel.name}{suffix}(const {number} *const *in, {number} *const *out)"
        yield f"{{ chasles_{kernel.name}{suffix}({', '.join([*given, *made])}); }}"


@pytest.fixture(scope="module")
def library_alone(taken, written_out, compile_c, tmp_path_factory):  # noqa: F811
    folder, room = written_out("c"), tmp_path_factory.mktemp("alone")
    lines = [f'#include "chasles_{name}.h"' for name in taken]
    lines += [line for kernel in taken.values() for line in shim(kernel)]
    (room / "shim.c").write_text("\n".join(lines))
    sources = [room / "shim.c", *sorted(folder.glob("*.c"))]
    compile_c(
        *STRICT.split(),
        "-O1",
        "-ffp-contract=off",
        "-shared",
        "-fPIC",
        f"-I{folder}",
        *sources,
        "-lm",
        "-o",
        room / "a.so",
    )
    return ctypes.CDLL(str(room / "a.so"))


@pytest.mark.sampled(7)
@pytest.mark.parametrize("function", [*PROGRAMS, *EXPRESSIONS])
def test_the_functions_are_those_of_the_python_kernel(library_alone, taken, function):  # noqa: F811
    require_right(taken[function], caller(library_alone, taken[function]))


def test_nothing_is_allocated_and_nothing_repeats(taken, written_out):  # noqa: F811
    for path in written_out("c").iterdir():
        text = re.sub(r"/\*.*?\*/", "", path.read_text(), flags=re.S)
        assert not re.search(
            r"\b(for|while|do|goto|malloc|alloca|static|errno|int)\b|#define (?!CHASLES_\w+_H$)", text, re.M
        ), path
        assert not re.search(r"[-+] [\w.\[\]]+ [*/?]|(?:[*/<]|==) [\w.\[\]]+ [-+?]", text), path
        assert path.read_text().startswith("/* SPDX-License-Identifier: BSD-3-Clause */\n/* Emitted by chasles ")


def test_the_head_has_shapes_the_licence_and_the_error_bound(tmp_path):
    kernel = chasles.compile(sp.Matrix([[x * y, x], [1, y]]), {"x": x, "y": y}, name="square")
    header, source = kernel.write(tmp_path / "new" / "folder", box={"x": (0, 1), "y": (1, 2)}, license="MIT")
    assert (header, source) == tuple(tmp_path / "new/folder/c" / f"chasles_square.{suffix}" for suffix in "hc")
    text = header.read_text()
    assert text.startswith("/* SPDX-License-Identifier: MIT */\n")
    assert " * (),()->(2,2): the shapes" in text
    bound = kernel.error_bound({"x": (0, 1), "y": (1, 2)})
    assert f"error bound result: within {bound['result'].absolute.max():.4g} of the exact value" in text
    assert "for x in [0, 1], y in [1, 2]; u = 2^-24" in text
    assert "error bound" not in chasles.compile(x, [x]).write(tmp_path)[0].read_text()


def test_several_kernels_lie_in_one_folder_and_nothing_else_is_touched(tmp_path):
    (tmp_path / "MANIFEST.toml").write_text('files = ["mine.txt"]\n')
    (tmp_path / "mine.txt").write_text("mine")
    for name in ("one", "two"):
        chasles.compile(x + 1, [x], name=name).write(tmp_path)
    found = {path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*") if path.is_file()}
    assert found == {
        "MANIFEST.toml",
        "mine.txt",
        *(f"c/chasles_{name}.{suffix}" for name in ("one", "two") for suffix in "hc"),
    }


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"targets": "fortran"}, "no target 'fortran'; there are c, "),
        ({"targets": ("c", "gufunc")}, "'gufunc' stands alone; what can be taken away: c"),
        ({"license": "a\nb"}, "license: a text of one printable line"),
        ({"box": {"y": 1}}, "x"),
    ],
)
def test_what_cannot_be_written_is_refused_by_name_and_leaves_nothing(tmp_path, options, message):
    with pytest.raises(ValueError, match=message):
        chasles.compile(x, [x]).write(tmp_path / "made", **options)
    assert not (tmp_path / "made").exists()


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="every folder can be written to here")
def test_a_folder_that_cannot_be_written_to_says_so(tmp_path):
    tmp_path.chmod(0o500)
    with pytest.raises(PermissionError):
        chasles.compile(x, [x]).write(tmp_path)
    assert not list(tmp_path.iterdir())


def test_a_file_where_a_folder_belongs_leaves_everything_as_it_was(tmp_path):
    (tmp_path / "c").mkdir()
    (tmp_path / "c/chasles_expression.c").mkdir()
    with pytest.raises(OSError, match="a folder stands where a file belongs"):
        chasles.compile(x, [x]).write(tmp_path)
    assert [path.name for path in (tmp_path / "c").iterdir()] == ["chasles_expression.c"]


def test_what_is_written_is_the_same_each_time(tmp_path):
    kernel = chasles.compile(sp.sin(x) * y, [x, y])
    first = [path.read_bytes() for path in kernel.write(tmp_path / "a")]
    assert first == [path.read_bytes() for path in kernel.write(str(tmp_path / "b"), ["c", "c"])]
    assert [path.name for path in (tmp_path / "a").iterdir()] == ["c"]
