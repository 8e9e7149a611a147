"""The C library stands alone: no warning, a self-test of its own, and outputs that may lie over inputs."""

from __future__ import annotations

import ctypes
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from ..sampling import WHOLE

STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]


def pointer(array):
    kind = ctypes.c_double if array.dtype == np.float64 else ctypes.c_float
    return array.ctypes.data_as(ctypes.POINTER(kind))


LEVELS = {
    "baseline": [],
    "x86-64-v3": ["-march=x86-64-v3", "-DCHASLES_LEVEL=1", "-DCHASLES_LEVELS=3"],
    "x86-64-v4": ["-march=x86-64-v4", "-DCHASLES_LEVEL=2", "-DCHASLES_LEVELS=3"],
}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("level", LEVELS)
def test_every_file_compiles_without_a_warning(generated, levels, tmp_path, compiler, level):
    if shutil.which(compiler) is None or level not in levels:
        pytest.skip(f"no {compiler} for {level}")
    for source in sorted((generated / "c").rglob("*.c")):
        command = [compiler, "-std=c99", "-O2", *STRICT, *LEVELS[level], f"-I{generated}/c/include", "-c", source]
        done = subprocess.run([*command, "-o", tmp_path / "x.o"], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr


def test_without_vector_types_batches_call_the_scalar_kernels(generated, compile_c, kernels, tmp_path):
    """As with a compiler that has none; what the processor offers is switched off by leaving out what asks for it."""
    sources = [tmp_path / source.name for source in sorted((generated / "c/src").iterdir())]
    for source in sources:
        text = (generated / "c/src" / source.name).read_text()
        source.write_text(text.replace("#define CHASLES_VECTORS 1", "#define CHASLES_VECTORS 0"))
    assert "CHASLES_VECTORS 1" not in (tmp_path / "batches.h").read_text()
    folders = [f"-I{generated}/c/include", f"-I{tmp_path}"]
    test, program = generated / "c/test/self_test.c", tmp_path / "self_test"
    c_files = [source for source in sources if source.suffix == ".c"]
    compile_c("-std=c99", *STRICT, *folders, *c_files, test, "-lm", "-o", program)
    done = subprocess.run([program], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout.endswith(" 0 failed\n")) == (0, True), done.stdout


@pytest.mark.skipif(shutil.which("g++") is None, reason="no C++ compiler")
@pytest.mark.sampled(2)
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
    compared = 6 * sum(len(check.outputs) for kernel in kernels for check in kernel.checks)
    assert (done.returncode, done.stdout) == (0, f"{compared} passed, 0 failed\n")


def test_the_command_in_the_readme_works(generated, compile_c, tmp_path):
    (command,) = re.findall(r"^    (cc .*)", (generated / "README.md").read_text(), re.M)
    shutil.copytree(generated / "c", tmp_path / "c")
    done = subprocess.run(command, shell=True, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout.endswith(" 0 failed\n")) == (0, True), done.stderr


@pytest.mark.sampled(2)
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
    from chasles.targets import Heading, TargetKernel, discover, render, write

    line = builder("bare", x=())
    (x,) = line.inputs()
    write(
        tmp_path, render([TargetKernel(line.program(y=x * x), Heading("3.1", "s", "holds", (), "0" * 64))], discover())
    )
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
    standard = {"<emmintrin.h>", "<immintrin.h>", "<fenv.h>", "<math.h>", "<stddef.h>", "<stdint.h>", "<string.h>"}
    own = {'"batches.h"', '"chasles.h"', '"loops.h"', '"vectors.h"'}
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
                words = "load|take", "store|give"
                loads, stores = ([m.start() for m in re.finditer(rf"\b({word})_\w", body)] for word in words)
                assert not stores or max(loads, default=0) < min(stores)
                groups += bool(stores)
    assert groups == 2 * len(kernels)


SANITIZERS = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-g"]
BATCHES = Path(__file__).with_name("batches.c")
OF_ALL = pytest.mark.skipif(not WHOLE, reason="test_c_sanitizers tries some sections: set CHASLES_TEST_WHOLE=1")


@pytest.fixture(scope="module")
def batches(generated, compile_c, compile_levels, objects, levels, tmp_path_factory):
    """Builds the program that tries batches, with the options given, for some levels that this machine can run."""

    def built(*options):
        folder = tmp_path_factory.mktemp("batches")
        some = levels if WHOLE else levels[:2]
        made = compile_levels(generated, folder, some, *options) if options else objects
        words = ["-std=gnu99", *options, f"-I{generated}/c/include", BATCHES, *made, "-lm", "-o", folder / "batches"]
        compile_c(*words)
        return folder / "batches"

    return built


def tried(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


def test_batches_are_right_in_any_storage(batches):
    assert tried(batches()) == (0, "right\n", "")


@pytest.mark.slow
@OF_ALL
def test_sanitizers_find_nothing(batches):
    program = batches(*SANITIZERS)
    code, out, err = tried(program)
    if "LeakSanitizer has encountered a fatal error" in err:
        code, out, err = tried("env", "ASAN_OPTIONS=detect_leaks=0", program)
    assert (code, out, err) == (0, "right\n", "")


@pytest.mark.slow
@OF_ALL
@pytest.mark.skipif(shutil.which("valgrind") is None, reason="no valgrind")
def test_valgrind_finds_nothing(batches):
    command = ["valgrind", "--quiet", "--error-exitcode=9", "--leak-check=full", batches("-g"), "memory"]
    assert tried(*command) == (0, "right\n", "")
