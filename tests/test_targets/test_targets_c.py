"""The C library stands alone: no warning, a self-test of its own, and outputs that may lie over inputs."""

from __future__ import annotations

import ctypes
import re
import shutil
import subprocess

import numpy as np
import pytest

STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]


def pointer(array):
    kind = ctypes.c_double if array.dtype == np.float64 else ctypes.c_float
    return array.ctypes.data_as(ctypes.POINTER(kind))


def test_every_file_compiles_without_a_warning(generated, compile_c, tmp_path):
    for source in sorted((generated / "c").rglob("*.c")):
        compile_c("-std=c99", "-O2", *STRICT, f"-I{generated}/c/include", "-c", source, "-o", tmp_path / "x.o")


@pytest.mark.skipif(shutil.which("g++") is None, reason="no C++ compiler")
@pytest.mark.parametrize("standard", ["c++11", "c++20"])
def test_every_file_is_c_plus_plus_too(generated, tmp_path, standard):
    for source in sorted((generated / "c").rglob("*.c")):
        command = ["g++", f"-std={standard}", *STRICT, f"-I{generated}/c/include", "-x", "c++", "-c", source]
        done = subprocess.run([*command, "-o", tmp_path / "x.o"], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr


def test_the_header_needs_nothing_before_it_and_minds_no_macro(generated, compile_c, tmp_path):
    for included in ("", "#include <complex.h>\n#include <errno.h>\n#include <math.h>\n"):
        source = tmp_path / "user.c"
        source.write_text(f'{included}#include "chasles.h"\nint main(void) {{ return 0; }}\n')
        compile_c("-std=c99", *STRICT, f"-I{generated}/c/include", source, "-o", tmp_path / "user")


def self_test(generated, compile_c, folder, sources):
    program = folder / "self_test"
    test = generated / "c/test/self_test.c"
    folders = [f"-I{generated}/c/include", f"-I{generated}/c/src"]
    compile_c("-std=c99", *STRICT, *folders, *sources, test, "-lm", "-o", program)
    return subprocess.run([program], capture_output=True, text=True, check=False)


def test_the_self_test_passes(generated, compile_c, kernels, tmp_path):
    done = self_test(generated, compile_c, tmp_path, (generated / "c/src").glob("*.c"))
    compared = 2 * sum(len(check.outputs) for kernel in kernels for check in kernel.checks)
    assert (done.returncode, done.stdout) == (0, f"{compared} passed, 0 failed\n")


def test_the_command_in_the_readme_works(generated, compile_c, tmp_path):
    (command,) = re.findall(r"^    (cc .*)", (generated / "README.md").read_text(), re.M)
    shutil.copytree(generated / "c", tmp_path / "c")
    done = subprocess.run(command, shell=True, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout.endswith(" 0 failed\n")) == (0, True), done.stderr


@pytest.mark.parametrize(
    ("right", "wrong"),
    [("(Q[7] - Q[5]) * 0.5;", "(Q[5] - Q[7]) * 0.5;"), ("1.0f / 7.0f", "1.0f / 7.1f"), ("/ t4;", "/ (t4 + t4);")],
)
def test_the_self_test_finds_what_is_wrong(generated, compile_c, tmp_path, right, wrong):
    sources = []
    found = 0
    for source in (generated / "c/src").glob("*.c"):
        text = source.read_text()
        found += text.count(right)
        sources.append(tmp_path / source.name)
        sources[-1].write_text(text.replace(right, wrong))
    assert found
    done = self_test(generated, compile_c, tmp_path, sources)
    assert done.returncode == 1
    assert re.search(r", expected .*\n(.|\n)*[1-9]\d* failed\n", done.stdout)


def test_a_self_test_without_vectors_does_not_pass(builder, compile_c, tmp_path):
    from chasles.targets import Heading, Kernel, discover, render, write

    line = builder("bare", x=())
    (x,) = line.inputs()
    write(tmp_path, render([Kernel(line.program(y=x * x), Heading("3.1", "s", "holds", (), "0" * 64))], discover()))
    done = self_test(tmp_path, compile_c, tmp_path, (tmp_path / "c/src").glob("*.c"))
    assert (done.returncode, done.stdout) == (1, "0 passed, 0 failed\n")


@pytest.mark.parametrize(("suffix", "kind"), [("", np.float64), ("f", np.float32)])
def test_outputs_may_lie_over_inputs(library, suffix, kind):
    scalar = {"": ctypes.c_double, "f": ctypes.c_float}[suffix]
    a, b = np.array([1, 2, 3], kind), np.array([4, 5, 6], kind)
    x = np.zeros(2, kind)
    swapped = getattr(library, f"chasles_swapped{suffix}")
    swapped(pointer(a), pointer(b), scalar(7), scalar(8), pointer(a), pointer(b), pointer(x), pointer(x[1:]))
    assert (a.tolist(), b.tolist(), x.tolist()) == ([4, 5, 6], [1, 2, 3], [8, 7])

    rotation = getattr(library, f"chasles_rotation_from_axis_angle{suffix}")
    apart, over = np.zeros(9, kind), np.zeros(9, kind)
    e = np.array([0.6, 0, 0.8], kind)
    rotation(pointer(e), scalar(1.5), pointer(apart))
    for place in (0, 3, 6):
        over[place : place + 3] = e
        rotation(pointer(over[place:]), scalar(1.5), pointer(over))
        assert over.tolist() == apart.tolist()


@pytest.mark.parametrize(("suffix", "kind"), [("", np.float64), ("f", np.float32)])
def test_batches_step_as_they_are_told(library, ufuncs, suffix, kind):
    rotation = getattr(library, f"chasles_rotation_from_axis_angle_batch{suffix}")
    step = ctypes.c_ssize_t
    e, phi = np.array([0.6, 0, 0.8], kind), np.linspace(-3, 3, 8, dtype=kind)
    Q = np.full((4, 10), -1, kind)
    rotation(ctypes.c_size_t(4), pointer(e), step(0), pointer(phi[6:]), step(-2), pointer(Q), step(10))
    assert np.array_equal(Q[:, :9].reshape(4, 3, 3), ufuncs.rotation_from_axis_angle(e, phi[6::-2]))
    assert np.all(Q[:, 9] == -1)
    rotation(ctypes.c_size_t(0), None, step(0), None, step(0), None, step(0))


def test_each_function_opens_with_its_contract(texts, kernels):
    for kernel in kernels:
        source = texts[f"c/src/{kernel.heading.section}.c"]
        for name in (f"chasles_{kernel.name}", f"chasles_{kernel.name}f", f"chasles_{kernel.name}_batchf"):
            head = source[: source.index(f"void {name}(")].rpartition("/*\n")[2]
            for part in ("(3.18)", "holds under", "|e| = 1", "phi != 0", kernel.heading.derivation):
                assert part in head
            total = kernel.program.operations.total()
            assert re.search(rf"operations  {total}\b|\b{total} operations", head)


def test_no_latex_and_only_the_standard_library(texts):
    standard = {"<fenv.h>", "<math.h>", "<stddef.h>", "<stdint.h>", "<string.h>"}
    own = {'"batches.h"', '"chasles.h"', '"vectors.h"'}
    for path, text in texts.items():
        if path.startswith(("c/include", "c/src")):
            assert "$" not in text
            assert set(re.findall(r"#include (.*)", text)) <= standard | own
            assert not re.search(r"\b(malloc|errno =)\b", text)
            assert not re.search(r"^ *static (?!const|inline)[^()]*(=|;)", text, re.M), "a function keeps a state"
        if re.fullmatch(r"c/src/s\d+_\w+\.c", path):
            assert "\\" not in text


def test_results_are_computed_before_any_is_stored(texts):
    for path, text in texts.items():
        if re.fullmatch(r"c/src/s\d+_\w+\.c", path) and not path.endswith("_blocks.c"):
            for body in re.findall(r"^void.*?^\{\n(.*?)^\}", text, re.M | re.S):
                lines = [line.strip() for line in body.splitlines()]
                stores = [place for place, line in enumerate(lines) if re.match(r"(\w+\[\d+\]|\*\w+) = ", line)]
                assert all(re.fullmatch(r"\S+ = -?[\w.+]+;", lines[place]) for place in stores)
                assert not stores or all("const" not in line for line in lines[stores[0] :])


def test_a_group_is_loaded_before_any_of_it_is_stored(texts, kernels):
    groups = 0
    for path, text in texts.items():
        if path.endswith("_blocks.c") and "trigonometry" not in path:
            for body in re.findall(r"g\+\+\) \{\n(.*?)^    \}", text, re.M | re.S):
                loads, stores = ([m.start() for m in re.finditer(rf"\b{word}_\d", body)] for word in ("load", "store"))
                assert not stores or max(loads, default=0) < min(stores)
                groups += bool(stores)
    assert groups == 2 * len(kernels)
