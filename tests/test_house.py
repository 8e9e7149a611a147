"""The house around the code: what is imported when, what is said when a tool is missing, what is built."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from importlib import metadata
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest

import chasles

from .sampling import WHOLE

ROOT = Path(__file__).resolve().parents[1]
CC = os.environ.get("CC", "cc")
pytestmark = pytest.mark.skipif(not (ROOT / "pyproject.toml").exists(), reason="needs the checkout")


def run(*command: str | Path, cwd: Path = ROOT, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        command, cwd=cwd, env={**os.environ, **environment}, capture_output=True, text=True, check=False
    )


def succeed(*command: str | Path, cwd: Path = ROOT, **environment: str) -> str:
    done = run(*command, cwd=cwd, **environment)
    assert done.returncode == 0, f"{done.args}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def can_compile(cc: str = CC, python: str | Path = sys.executable) -> subprocess.CompletedProcess[str]:
    return run("sh", ROOT / "cmake" / "can_compile.sh", cc, python)


needs_c = pytest.mark.skipif(can_compile().returncode != 0, reason="no C compiler or no Python.h on this machine")


def test_one_version() -> None:
    version = chasles.__version__
    assert metadata.version("chasles") == version
    assert f"\nversion: {version}\n" in (ROOT / "CITATION.cff").read_text("utf-8")
    assert f"\n## {version}" in (ROOT / "CHANGELOG.md").read_text("utf-8")


SYMBOLIC = {"sympy", "mpmath", "flint"}
HEAVY = {*SYMBOLIC, "numpy", "click", "rich", "jinja2", "latex2mathml", "lark"}


@pytest.mark.parametrize(
    ("code", "absent"),
    [
        ("import chasles", {*HEAVY, "chasles.statements", "chasles.kernels"}),
        ("import chasles.kernels", {*HEAVY, "chasles.statements"} - {"numpy"}),
        ("import chasles; chasles.kernels.power; chasles.kernels.one", {*HEAVY, "chasles.statements"} - {"numpy"}),
        ("import chasles.checked; chasles.checked.power", {*HEAVY, "chasles.statements"} - {"numpy"}),
        ("import chasles.statements; chasles.statements.load()", {*SYMBOLIC, "numpy"}),
        ("import chasles.cli", {*HEAVY, "chasles.statements"} - {"click"}),
    ],
)
@pytest.mark.parametrize("backend", ["", "numpy"])
def test_what_an_import_costs(code: str, absent: set[str], backend: str) -> None:
    """By what is imported, whatever the machine is busy with: SymPy takes ten times as long as all of this."""
    printed = succeed(
        sys.executable, "-c", f"import sys; {code}; print(*sys.modules, sep=chr(10))", CHASLES_BACKEND=backend
    )
    before = succeed(sys.executable, "-c", "import sys; print(*sys.modules, sep=chr(10))")
    assert sorted(absent & (set(printed.split()) - set(before.split()))) == []


def test_a_submodule_does_not_hide_the_function_of_its_name() -> None:
    names = ("prove", "load", "decide", "repair", "derive")
    code = f"import chasles, chasles.prove, chasles.statements; print([callable(getattr(chasles, n)) for n in {names}])"
    assert succeed(sys.executable, "-c", code) == "[True, True, True, True, True]\n"


def test_unknown_names_are_named() -> None:
    with pytest.raises(AttributeError, match=r"no attribute 'proove'; it offers .*prove"):
        chasles.proove  # noqa: B018


def test_the_book_has_one_name() -> None:
    spec = spec_from_file_location("derivations", ROOT / "derivations" / "__init__.py")
    assert spec is not None
    assert spec.loader is not None
    with pytest.raises(ImportError, match=r"import them as 'chasles\.derivations'"):
        spec.loader.exec_module(module_from_spec(spec))


@pytest.mark.parametrize(("cc", "package"), [("no-such-compiler", "gcc"), ("false", "libc6-dev")])
def test_missing_compiler_is_named(cc: str, package: str) -> None:
    done = can_compile(cc)
    assert done.returncode == 1
    assert f"install the Debian package {package}, then" in done.stderr
    assert done.stderr.count("\n") == 1


@needs_c
def test_missing_python_header_is_named(tmp_path: Path) -> None:
    python = tmp_path / "python"
    python.write_text(f"#!/bin/sh\necho {tmp_path}\n", "utf-8")
    python.chmod(0o755)
    done = can_compile(python=python)
    assert done.returncode == 1
    assert f"No Python.h in {tmp_path}" in done.stderr
    assert "install the Debian package python3-dev, then" in done.stderr


@pytest.fixture(scope="module")
def c_library(tmp_path_factory: pytest.TempPathFactory, hasty_compiler: str) -> Path:
    """The prefix into which CMake has installed the C library, its self-test passed."""
    tmp = tmp_path_factory.mktemp("c_library")
    # As with a compiler that offers no more; the extension, which has the same files, is compiled for all instructions.
    plain = () if WHOLE else ("-Dchasles_has_x86-64-v3=OFF",)
    succeed(cmake(), "-S", ROOT, "-B", tmp / "build", *plain, CC=hasty_compiler)
    succeed(cmake(), "--build", tmp / "build")
    succeed(cmake().with_name("ctest"), "--test-dir", tmp / "build", "--no-tests=error")
    succeed(cmake(), "--install", tmp / "build", "--prefix", tmp / "prefix")
    return tmp / "prefix"


def cmake() -> Path:
    beside_python = Path(sys.executable).parent
    found = shutil.which("cmake", path=f"{beside_python}{os.pathsep}{os.environ['PATH']}")
    assert found, "cmake comes with the `test` extra"
    return Path(found)


CONSUMER = """\
#include <chasles.h>
#include <stdio.h>

int main(void)
{
    const double e[3] = {0.0, 0.0, 1.0}, d[3] = {0.0, 0.0, 6.0};
    double pitch;
    chasles_pitch_of_motion(e, 2.0, d, &pitch);
    printf("%g\\n", pitch);
    return 0;
}
"""
CONSUMER_CMAKE = """\
cmake_minimum_required(VERSION 3.21)
project(consumer LANGUAGES C)
find_package(chasles 0.2 REQUIRED)
add_executable(consumer consumer.c)
target_link_libraries(consumer PRIVATE chasles::chasles)
"""


@pytest.mark.slow
@needs_c
def test_c_library_is_found_by_cmake(c_library: Path, tmp_path: Path) -> None:
    (tmp_path / "consumer.c").write_text(CONSUMER, "utf-8")
    (tmp_path / "CMakeLists.txt").write_text(CONSUMER_CMAKE, "utf-8")
    succeed(cmake(), "-S", tmp_path, "-B", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={c_library}")
    succeed(cmake(), "--build", tmp_path / "build")
    assert succeed(tmp_path / "build" / "consumer") == "3\n"


@pytest.mark.slow
@needs_c
@pytest.mark.skipif(shutil.which("pkg-config") is None, reason="no pkg-config on this machine")
def test_c_library_is_found_by_pkg_config(c_library: Path, tmp_path: Path) -> None:
    moved = shutil.copytree(c_library, tmp_path / "größer & moved")
    (folder,) = (path.parent for path in moved.rglob("chasles.pc"))
    (tmp_path / "consumer.c").write_text(CONSUMER, "utf-8")
    command = f"eval {CC} consumer.c $(pkg-config --cflags --libs chasles) -o consumer"
    succeed("sh", "-c", command, PKG_CONFIG_PATH=str(folder), cwd=tmp_path)
    assert succeed(tmp_path / "consumer") == "3\n"
