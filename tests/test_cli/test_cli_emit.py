"""`chasles emit`: all files or none, stale ones named, nothing rewritten without need."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from itertools import islice
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from chasles import derivations
from chasles.cli import answers, chosen_chapter, main
from chasles.cli.answers import all_derivations
from chasles.decisions import processes as spreading
from chasles.statements import Chapter, load
from chasles.targets import commission

from ..sampling import WHOLE

ROOT = Path(__file__).resolve().parents[2]
KERNELS = ["cross_product_matrix", "rotation_from_axis_angle", "point_after_displacement"]


def run(*words: str) -> Result:
    return CliRunner(env={"COLUMNS": None}).invoke(main, ["emit", *words], prog_name="chasles")


@pytest.fixture(autouse=True)
def _short_book(monkeypatch: pytest.MonkeyPatch) -> None:
    """The beginning of the book, which asks for three kernels, and the first of its roads."""
    whole = load()
    end = next(k for k, entry in enumerate(whole.entries) if entry.name == KERNELS[-1]) + 1
    beginning = Chapter(whole.title, whole.entries[:end])
    monkeypatch.setattr(chosen_chapter, "load", lambda package: beginning)
    first = dict(islice(all_derivations(beginning).items(), 2))
    monkeypatch.setattr(answers, "all_derivations", lambda chapter: first)
    monkeypatch.setattr(answers, "sentences_of_exercises", lambda chapter: {})


@pytest.fixture
def generated(made_once: Callable[[str, Callable[[Path], object]], Path], tmp_path: Path) -> Path:
    def emit(folder: Path) -> None:
        done = run("--out", str(folder))
        assert done.exit_code == 0, done.stderr

    return shutil.copytree(made_once("short-book", emit), tmp_path / "generated")


def contents(folder: Path) -> dict[str, tuple[bytes, int]]:
    """What every file holds and when it was written."""
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): (path.read_bytes(), path.stat().st_mtime_ns) for path in files}


def test_the_kernels_that_statements_ask_for_are_written(generated: Path) -> None:
    numpy, c = (
        (generated / "numpy/kernels.py").read_text("utf-8"),
        (generated / "c/include/chasles.h").read_text("utf-8"),
    )
    assert all(f"def {name}(" in numpy and f"void chasles_{name}(" in c for name in KERNELS)
    assert not [path for path in contents(generated) if path.endswith(".draft")]


def test_every_head_says_where_it_comes_from(generated: Path) -> None:
    from chasles.statements.fingerprint import fingerprint

    source = (generated / "c/src/section_3_2.c").read_text("utf-8")
    for entry in load().entries[:20]:
        if entry.statement.kernel is not None:
            assert f"({entry.number}) {entry.statement.says}"[:60] in source
            assert f"sha256 {fingerprint(entry.statement)}" in source


def test_a_second_time_nothing_is_touched(generated: Path) -> None:
    before = contents(generated)
    done = run("--out", str(generated))
    assert done.exit_code == 0
    assert f"files in {generated}: {len(before)} unchanged" in done.stdout
    assert contents(generated) == before


def test_as_data(generated: Path) -> None:
    (generated / "README.md").unlink()
    report = json.loads(run("--out", str(generated), "--json").stdout)
    assert report == {
        "folder": str(generated),
        "kernels": KERNELS,
        "refused": [],
        "changed": ["README.md"],
        "removed": [],
        "unchanged": len(contents(generated)) - 1,
    }


def test_what_is_as_emitted_passes_the_check(generated: Path) -> None:
    done = run("--out", str(generated), "--check")
    assert (done.exit_code, done.stderr) == (0, "")
    assert f"3 kernels, each proved equal to its statement; {generated} is as emitted" in done.stdout
    assert json.loads(run("--out", str(generated), "--check", "--json").stdout)["stale"] == []


def test_stale_files_are_named_and_left_alone(generated: Path) -> None:
    source = generated / "c/src/section_3_2.c"
    source.write_text(source.read_text("utf-8").replace("cos(", "sin("), "utf-8")
    (generated / "README.md").unlink()
    (generated / "c/old.c").write_text("int x;\n", "utf-8")
    before = contents(generated)
    done = run("--out", str(generated), "--check")
    assert done.exit_code == 1
    assert done.stderr.count("\n") == 1
    for path in ("c/src/section_3_2.c", "README.md", "c/old.c"):
        assert path in done.stderr
    assert "README.md is missing" in done.stdout
    assert any(line.startswith("-") and "sin(" in line for line in done.stdout.splitlines())
    assert any(line.startswith("+") and "cos(" in line for line in done.stdout.splitlines())
    assert contents(generated) == before
    found = json.loads(run("--out", str(generated), "--check", "--json").stdout)["stale"]
    assert {(each["path"], each["kind"]) for each in found} == {
        ("README.md", "missing"),
        ("c/old.c", "superfluous"),
        ("c/src/section_3_2.c", "differs"),
    }


def test_a_folder_that_cannot_be_written_is_one_line(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", "utf-8")
    done = run("--out", str(tmp_path / "file" / "generated"))
    assert done.exit_code == 1
    assert done.stderr.startswith("chasles: cannot write the generated files to ")
    assert "nothing was changed" in done.stderr
    assert done.stderr.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_read_only_folder_stays_as_it_was(generated: Path) -> None:
    (generated / "README.md").write_text("old\n", "utf-8")
    before = contents(generated)
    folders = [path for path in (generated, *generated.rglob("*")) if path.is_dir()]
    for folder in folders:
        folder.chmod(0o555)
    try:
        done = run("--out", str(generated))
    finally:
        for folder in folders:
            folder.chmod(0o755)
    assert done.exit_code == 1
    assert "nothing was changed" in done.stderr
    assert contents(generated) == before


def test_a_program_that_is_not_proved_equal_is_refused_and_the_others_are_emitted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    original = commission.program_of

    def negated(request):
        """The program with the signs of its sums turned."""
        from dataclasses import replace

        from chasles.lowering.program import Op

        program = original(request)
        turn = {Op.ADD: Op.SUBTRACT, Op.SUBTRACT: Op.ADD}
        return replace(program, steps=tuple(replace(step, op=turn.get(step.op, step.op)) for step in program.steps))

    monkeypatch.setattr(commission, "program_of", negated)
    done = run("--out", str(tmp_path / "generated"))
    assert done.exit_code == 1
    place = r"\S+s02_screw\.py, line \d+"
    said = [re.match(rf"chasles: refused: {place}: (\w+): ", line) for line in done.stderr.splitlines()]
    refused = [found and found[1] for found in said]
    assert len(refused) == 2
    assert "rotation_from_axis_angle" in refused
    assert "not proved to equal (2.49)" in done.stderr
    (emitted,) = set(KERNELS) - set(refused)
    assert "1 kernel, each proved equal" in done.stdout
    assert emitted in (tmp_path / "generated/MANIFEST.toml").read_text("utf-8")
    again = run("--out", str(tmp_path / "generated"), "--check")
    assert (again.exit_code, again.stderr.count("refused: ")) == (1, 2)


def test_kernels_made_in_several_processes_are_the_same(
    generated: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(spreading, "processors", lambda: 2)
    monkeypatch.setattr(spreading, "WORTH", 1e-9)
    done = run("--out", str(tmp_path / "again"))
    assert done.exit_code == 0, done.stderr
    one, other = contents(generated), contents(tmp_path / "again")
    assert {path: text for path, (text, _) in one.items()} == {path: text for path, (text, _) in other.items()}
    monkeypatch.setattr(commission, "differences", lambda *_: ("it is not",))
    done = run("--out", str(tmp_path / "refused"))
    assert done.exit_code == 1
    assert re.search(rf"nothing was emitted, all kernels are refused: \S+, line \d+: {KERNELS[0]}: ", done.stderr)


def checkout(folder: Path, declarations: Path) -> Path:
    folder.mkdir()
    (folder / "pyproject.toml").write_text("", "utf-8")
    (folder / "derivations").symlink_to(declarations)
    return folder


def test_the_checkout_around_the_current_folder_is_written_to(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    root = checkout(tmp_path / "mine", Path(derivations.__path__[0]))
    (root / "docs").mkdir()
    monkeypatch.chdir(root / "docs")
    done = run()
    assert done.exit_code == 0, done.stderr
    assert (root / "generated/MANIFEST.toml").is_file()


def test_another_checkout_is_not(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    theirs = shutil.copytree(derivations.__path__[0], tmp_path / "theirs")
    root = checkout(tmp_path / "other", theirs)
    monkeypatch.chdir(root)
    done = run()
    assert done.exit_code == 2
    assert "this chasles reads " in done.stderr
    assert done.stderr.count("\n") == 1
    assert not (root / "generated").exists()


def test_outside_every_checkout_nothing_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    done = run()
    assert done.exit_code == 2
    assert done.stderr.startswith(f"chasles: {tmp_path} is in no checkout")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
@pytest.mark.skipif(not (ROOT / "examples").exists(), reason="needs the checkout")
def test_a_whole_chapter_gives_the_same_bytes_under_two_hash_seeds(tmp_path: Path) -> None:
    """A short one; `emit --check` compares those of the book with what was written under another seed."""
    chapter = () if WHOLE else ("--chapter", str(ROOT / "examples" / "planar"))
    program = (sys.executable, "-c", "from chasles.cli import main; main()", *chapter)
    texts = []
    for seed in ("1", "2"):
        command = (*program, "emit", "--out", str(tmp_path / seed))
        done = subprocess.run(
            command, env={**os.environ, "PYTHONHASHSEED": seed}, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr
        texts.append({path: text for path, (text, _) in contents(tmp_path / seed).items()})
    assert texts[0] == texts[1]
    assert len(texts[0]) > 10
