"""Other compilers and machines: what they are given to compile, and what they make of it where they are at hand."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[1]
SOURCES = ROOT / "generated"
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]
GNU_ONLY = re.compile(r"__(?:attribute|builtin|extension|asm|typeof|inline)\w*|\bvector_size\b|\basm\b|\btypeof\b")
SYSTEM = re.compile(r"#\s*include\s*<([^>]+)>")

pytestmark = pytest.mark.skipif(not (ROOT / "pyproject.toml").exists(), reason="needs the checkout")


def need(program: str) -> str:
    found = shutil.which(program, path=os.pathsep.join((str(Path(sys.executable).parent), os.environ["PATH"])))
    if found is None:
        pytest.skip(f"no {program} on this machine")
    return found


def flags(folder: Path, compiler: str, **variables: str) -> dict[str, list[str]]:
    """By source file, the options with which CMake would call a compiler of some kind; the last command of each."""
    given = {
        "CMAKE_C_COMPILER": need("cc"),
        "CMAKE_C_COMPILER_ID": compiler,
        "CMAKE_C_COMPILER_ID_RUN": "1",
        "CMAKE_C_COMPILER_FORCED": "1",
        "CMAKE_C_COMPILER_VERSION": "19.0",
        "CMAKE_C_STANDARD_COMPUTED_DEFAULT": "11",
        "CMAKE_SIZEOF_VOID_P": "8",
        "CMAKE_EXPORT_COMPILE_COMMANDS": "ON",
        "CMAKE_MAKE_PROGRAM": need("ninja"),
        **variables,
    }
    command = [need("cmake"), "-Wno-dev", "-G", "Ninja", "-S", ROOT, "-B", folder]
    command += [f"-D{name}={value}" for name, value in given.items()]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    commands: list[dict[str, Any]] = json.loads((folder / "compile_commands.json").read_text("utf-8"))
    return {Path(each["file"]).stem: each["command"].split() for each in commands}


def test_gcc_and_clang_keep_products_and_sums_apart(tmp_path: Path) -> None:
    for compiler in ("GNU", "Clang", "AppleClang"):
        found = flags(tmp_path / compiler, compiler)
        assert {"-O2", "-fno-math-errno", "-ffp-contract=off"} <= set(found["section_3_2"])
        assert {"-O3", "-fno-trapping-math", "-ffp-contract=off"} <= set(found["section_3_2_blocks"])
        assert found["trigonometry_blocks"].index("-ffp-contract=fast") > found["trigonometry_blocks"].index("-O3")


def test_msvc_gets_no_flag_of_another_compiler(tmp_path: Path) -> None:
    found = flags(tmp_path, "MSVC", MSVC="1")
    assert "batches" in found
    for command in found.values():
        assert "/fp:precise" in command
        assert not [word for word in command if word.startswith(("-f", "-O", "-m", "/clang:"))]


def test_clang_in_place_of_msvc_gets_its_flags_where_it_reads_them(tmp_path: Path) -> None:
    found = flags(tmp_path, "Clang", MSVC="1", CMAKE_C_COMPILER_FRONTEND_VARIANT="MSVC")
    for name, command in found.items():
        assert "/clang:-ffp-contract=off" in command
        assert not [word for word in command if word.startswith(("-ffp", "-fno", "-O", "-m"))]
        assert ("/clang:-ffp-contract=fast" in command) == (name == "trigonometry_blocks")
    said = [word for word in found["trigonometry_blocks"] if word.startswith("/clang:")]
    (tmp_path / "empty.c").write_text("int empty;\n", "utf-8")
    windows = ["--driver-mode=cl", "--target=x86_64-pc-windows-msvc", "-Werror", "-c", "empty.c", "-Foempty.obj"]
    subprocess.run([need("clang"), *windows, *said], cwd=tmp_path, check=True)


def preprocessed(folder: Path, *defined: str) -> str:
    """The C files as a compiler leaves them that predefines nothing of gcc's; system headers are left out."""
    texts = {path: path.read_text("utf-8") for path in sorted(SOURCES.rglob("*.[ch]"))}
    assert any(GNU_ONLY.search(text) for text in texts.values()), "nothing is to be guarded"
    for name in {name for text in texts.values() for name in SYSTEM.findall(text)}:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text("", "utf-8")
    folders = [f"-I{SOURCES}/c/include", f"-I{SOURCES}/c/src", f"-I{folder}"]
    command = [need("gcc"), "-E", "-P", "-undef", "-nostdinc", *folders, *(f"-D{macro}" for macro in defined)]
    files = [path for path in texts if path.suffix == ".c"]
    return subprocess.run([*command, *files], capture_output=True, text=True, check=True).stdout


@pytest.mark.skipif(not SOURCES.exists(), reason="needs the generated files")
def test_a_compiler_that_is_neither_gcc_nor_clang_sees_plain_c(tmp_path: Path) -> None:
    seen = preprocessed(tmp_path, "_MSC_VER=1940", "_WIN32")
    assert "chasles_screw_axis_point" in seen
    assert sorted(set(GNU_ONLY.findall(seen))) == []


@pytest.mark.skipif(not SOURCES.exists(), reason="needs the generated files")
def test_only_a_free_threaded_build_says_that_it_does_without_the_global_lock(tmp_path: Path) -> None:
    """Under the stable ABI of Python 3.11 there are neither this slot nor that of several interpreters."""
    said = "{Py_mod_gil, Py_MOD_GIL_NOT_USED}"
    slots = re.compile(r"PyModuleDef_Slot slots\[\] = \{(.*?)\};", re.DOTALL)
    [stable], [free] = (slots.findall(preprocessed(tmp_path, *macros)) for macros in ((), ("Py_GIL_DISABLED=1",)))
    assert said not in stable
    assert said in free
    assert "Py_mod_multiple_interpreters" not in stable + free


@pytest.mark.slow
@pytest.mark.skipif(not SOURCES.exists(), reason="needs the generated files")
def test_the_self_test_passes_on_another_processor(tmp_path: Path) -> None:
    """The library with its registers of aarch64, on an emulated processor."""
    compiler, emulator = need("aarch64-linux-gnu-gcc"), need("qemu-aarch64")
    program = tmp_path / "self_test"
    files = [*sorted((SOURCES / "c" / "src").glob("*.c")), SOURCES / "c" / "test" / "self_test.c"]
    options = ["-std=c99", "-O0", *WARNINGS, f"-I{SOURCES}/c/include", "-static"]
    subprocess.run([compiler, *options, *files, "-lm", "-o", program], check=True)
    done = subprocess.run([emulator, program], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-2000:]
    assert re.search(r"[1-9]\d* passed, 0 failed\n$", done.stdout)


@pytest.mark.slow
@pytest.mark.skipif(not SOURCES.exists(), reason="needs the generated files")
def test_windows_headers_are_enough(tmp_path: Path) -> None:
    compiler = need("x86_64-w64-mingw32-gcc")
    files = [*sorted((SOURCES / "c" / "src").glob("*.c")), SOURCES / "c" / "test" / "self_test.c"]
    options = ["-std=c99", "-O0", *WARNINGS, f"-I{SOURCES}/c/include"]
    subprocess.run([compiler, *options, *files, "-lm", "-o", tmp_path / "self_test.exe"], check=True)
