"""`chasles emit --target`: one language for itself, of the book and of another chapter."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest

from ..sampling import WHOLE
from ..test_targets.taken import NVCC

ROOT = Path(__file__).resolve().parents[2]
pytestmark = pytest.mark.skipif(not (ROOT / "examples").exists(), reason="needs the checkout")
PLANAR = ("--chapter", str(ROOT / "examples" / "planar"))


def files(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def test_a_language_alone_is_written_below_the_current_folder(run, tmp_path, monkeypatch) -> None:
    (tmp_path / "MANIFEST.toml").write_text('files = ["mine"]\n')
    (tmp_path / "mine").write_text("mine")
    monkeypatch.chdir(tmp_path)
    done = run(*PLANAR, "emit", "--target", "rust", "--target", "cpp", "--json")
    assert done.exit_code == 0, done.stderr
    report = json.loads(done.stdout)
    assert files(tmp_path) == {"MANIFEST.toml", "mine", *report["changed"]}
    kernels = report["kernels"]
    assert set(report["changed"]) == {
        *(f"cpp/{name}.hpp" for name in kernels),
        *(f"rust/src/{name}.rs" for name in (*kernels, "lib", "math")),
        "rust/Cargo.toml",
    }
    assert " --chapter planar emit`" in (tmp_path / "rust/src/lib.rs").read_text("utf-8")
    again = run(*PLANAR, "emit", "--target", "cpp", "--check")
    assert again.exit_code == 0, again.stdout
    (tmp_path / f"cpp/{kernels[0]}.hpp").write_text("")
    again = run(*PLANAR, "emit", "--target", "cpp", "--check")
    assert again.exit_code == 1
    assert f"cpp/{kernels[0]}.hpp" in again.stderr


def test_an_unknown_language_is_named_and_nothing_is_written(run, tmp_path) -> None:
    done = run(*PLANAR, "emit", "--target", "fortran", "--out", str(tmp_path / "made"))
    assert (done.exit_code, files(tmp_path)) == (2, set())
    assert done.stderr.startswith("chasles: there is no target 'fortran'; there are c, cpp, ")


def test_a_folder_that_cannot_be_written_is_one_line(run, tmp_path) -> None:
    (tmp_path / "cpp").write_text("")
    done = run(*PLANAR, "emit", "--target", "cpp", "--out", str(tmp_path))
    assert done.exit_code == 1
    assert done.stderr.startswith(f"chasles: cannot write to {tmp_path}, nothing was changed: ")
    assert done.stderr.count("\n") == 1


COMPILED = {
    "rust": ("rustc", "--edition=2021", "--crate-type=lib", '--cfg=feature="std"', "-Dwarnings", "--emit=metadata"),
    "cpp": ("g++", "-std=c++20", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-pedantic", "-fsyntax-only"),
    "cuda": ("nvcc", "-std=c++17", "-Xcicc", "-O0", "-Xptxas", "-O0", "-Werror", "all-warnings", "-c"),
}


@pytest.mark.slow
@pytest.mark.parametrize("target", COMPILED)
def test_what_is_emitted_compiles(run, tmp_path, target) -> None:
    """Of the whole book in a nightly run."""
    compiler, *options = COMPILED[target]
    compiler = NVCC if compiler == "nvcc" else shutil.which(compiler)
    if compiler is None:
        pytest.skip(f"no compiler for {target}")
    done = run(*(() if WHOLE else PLANAR), "emit", "--target", target, "--out", str(tmp_path))
    assert done.exit_code == 0, done.stderr
    source = tmp_path / "rust/src/lib.rs"
    if target != "rust":
        source = tmp_path / f"all.{target.replace('cuda', 'cu')}"
        source.write_text("".join(f'#include "{path}"\n' for path in sorted(tmp_path.rglob("*.[ch][up][hp]"))))
        assert source.read_text()
    command = [compiler, *options, str(source), *(() if target == "cpp" else ("-o", str(tmp_path / "made")))]
    compiled = subprocess.run(command, capture_output=True, text=True, check=False)
    assert compiled.returncode == 0, compiled.stderr
