"""Rust that is taken away: a crate without the standard library, whose functions give what the Python kernel gives."""

from __future__ import annotations

import ctypes
import shutil
import subprocess

import numpy as np
import pytest
import sympy

import chasles
from chasles.lowering.functions import FUNCTIONS

from .conftest import PROGRAMS
from .taken import EXPRESSIONS, caller, emitted_as, require_right, taken  # noqa: F401

pytestmark = pytest.mark.skipif(shutil.which("rustc") is None, reason="no rustc")
NAMES = {"sin": 1, "cos": 1, "sqrt": 1, "atan2": 2} | {
    name: function.operands for name, function in FUNCTIONS.items() if not function.special
}
"""The functions of C's library, which stands in for the crate `libm` here: nothing is fetched."""


def rust(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def libm():
    yield "#![no_std]"
    for name, operands in NAMES.items():
        for suffix, number in (("", "f64"), ("f", "f32")):
            parameters, passed = ", ".join(f"{x}: {number}" for x in "xy"[:operands]), ", ".join("xy"[:operands])
            yield f"pub fn {name}{suffix}({parameters}) -> {number} {{"
            yield f'    extern "C" {{ fn {name}{suffix}({parameters}) -> {number}; }}'
            yield f"    unsafe {{ {name}{suffix}({passed}) }}\n}}"


def shim(name, kernel):
    """A function that takes addresses alone."""
    called = {"new": "new"}.get(name, name)
    program = kernel.program
    for number, end, suffix in (("f64", "", ""), ("f32", "_f32", "f")):
        given = [
            f"&*(*a.add({place}) as *const {shaped(item.shape, number)})" if item.shape else f"**a.add({place})"
            for place, item in enumerate(program.arguments)
        ]
        yield "#[no_mangle]"
        yield f'pub unsafe extern "C" fn run_{name}{suffix}(a: *const *const {number}, b: *const *mut {number}) {{'
        yield f"    let r = chasles_kernels::{called}{end}({', '.join(given)});"
        for place, item in enumerate(program.results):
            value = f"r.{place}" if len(program.results) > 1 else "r"
            yield f"    (*b.add({place}) as *mut {shaped(item.shape, number)}).write({value});"
        yield "}"


def shaped(shape, number):
    for extent in reversed(shape):
        number = f"[{number}; {extent}]"
    return number


@pytest.fixture(scope="module", params=["std", "libm"])
def library_alone(request, taken, emitted_as, tmp_path_factory):  # noqa: F811
    folder, room = emitted_as("rust"), tmp_path_factory.mktemp("alone")
    options = ("--edition", "2021", "-D", "warnings", "--cfg", f'feature="{request.param}"', "-C", "panic=abort")
    (room / "libm.rs").write_text("\n".join(libm()))
    (room / "shim.rs").write_text("\n".join(line for name, kernel in taken.items() for line in shim(name, kernel)))
    rust("rustc", "--crate-type", "lib", "--edition", "2021", room / "libm.rs", "-o", room / "liblibm.rlib")
    beside = () if request.param == "std" else ("--extern", f"libm={room / 'liblibm.rlib'}")
    crate, made = folder / "src/lib.rs", room / "libchasles_kernels.rlib"
    rust("rustc", "--crate-type", "lib", "--crate-name", "chasles_kernels", *options, *beside, crate, "-o", made)
    link = ("--crate-type", "cdylib", "-L", room, "--extern", f"chasles_kernels={made}")
    rust("rustc", *options, *link, room / "shim.rs", "-o", room / "a.so")
    return ctypes.CDLL(str(room / "a.so"))


@pytest.mark.sampled(7)
@pytest.mark.parametrize("function", [*PROGRAMS, *EXPRESSIONS])
def test_the_functions_are_those_of_the_python_kernel(library_alone, taken, function):  # noqa: F811
    require_right(taken[function], caller(library_alone, taken[function]))


@pytest.mark.parametrize("x", [1 + 1e-12, 1 + 1e-8, 1.001, 1.5, 1.999])
def test_inverse_hyperbolic_functions_lose_no_digits(library_alone, taken, x):  # noqa: F811
    found = caller(library_alone, taken["inverses"])(np.float64, [np.array(x), np.array(x - 1)])
    np.testing.assert_allclose(found[1], np.arccosh(x), rtol=4e-16)
    np.testing.assert_allclose(found[2], np.arctanh(x - 1), rtol=4e-16)


@pytest.mark.skipif(shutil.which("cargo") is None, reason="no cargo")
def test_cargo_builds_the_crates_of_several_kernels_in_one_folder(taken, tmp_path):  # noqa: F811
    stub = tmp_path / "libm"
    (stub / "src").mkdir(parents=True)
    (stub / "src/lib.rs").write_text("\n".join(libm()))
    (stub / "Cargo.toml").write_text('[package]\nname = "libm"\nversion = "0.2.99"\nedition = "2021"\n')
    paths = [path for name in ("turned", "products") for path in taken[name].write(tmp_path / "made", "rust")]
    assert all(path.is_file() for path in paths)
    for name in ("turned", "products"):
        crate = tmp_path / "made/rust" / name / "Cargo.toml"
        patch = f'patch.crates-io.libm.path="{stub}"'
        words = ("--offline", "--manifest-path", crate, "--config", patch, "--target-dir", tmp_path / "target")
        rust("cargo", "check", "--quiet", *words)
        rust("cargo", "check", "--quiet", *words, "--no-default-features", "--features", "std")


def test_a_matrix_is_an_array_of_its_rows(taken, tmp_path):  # noqa: F811
    text = "\n".join(path.read_text() for path in taken["products"].write(tmp_path, "rust"))
    assert "pub fn products(m: &[[f64; 3]; 2]) -> [[f64; 2]; 2] {" in text
    assert text.count("pub fn ") == 2


def test_no_module_has_a_name_that_cargo_knows(tmp_path):
    x = sympy.Symbol("x")
    for called in ("lib", "main", "_"):
        paths = [path.name for path in chasles.compile(x, x, name=called).write(tmp_path, "rust")]
        assert paths.count(f"{called}.rs") == (called == "lib")
        assert len(set(paths)) == len(paths)
