"""`chasles report`: two files, whole or not at all; and what is said where they cannot be written."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from chasles.cli import checkout
from chasles.cli.failures import Failure
from chasles.cli.files import write_files
from chasles.statements import Claim
from chasles.vocabulary import vector

x = vector("x", "x", "any vector")
TWICE = Claim("9.1", x + x, 2 * x, says="Twice.")


def test_both_files_are_written(run, chapter_is, tmp_path: Path) -> None:
    chapter_is(twice=TWICE)
    done = run("report", "--out", str(tmp_path / "deep" / "folder"))
    assert done.exit_code == 0, done.stderr
    assert "1 statement: 1 hold" in done.stdout
    assert sorted(path.name for path in (tmp_path / "deep" / "folder").iterdir()) == ["chapter.tex", "index.html"]
    assert ">(9.1)</a></h4>" in (tmp_path / "deep" / "folder" / "index.html").read_text("utf-8")


def test_it_tells_a_program_what_it_wrote(run, chapter_is, tmp_path: Path) -> None:
    chapter_is(twice=TWICE)
    told = json.loads(run("report", "--out", str(tmp_path), "--json").stdout)
    assert told["folder"] == str(tmp_path)
    assert {file["path"]: file["bytes"] for file in told["files"]} == {
        str(path): path.stat().st_size for path in tmp_path.iterdir()
    }


def test_a_file_in_the_folder_s_place_is_named(run, chapter_is, tmp_path: Path) -> None:
    chapter_is(twice=TWICE)
    (tmp_path / "file").write_text("mine", "utf-8")
    done = run("report", "--out", str(tmp_path / "file"))
    assert done.exit_code == 2
    assert "is a file" in done.stderr
    done = run("report", "--out", str(tmp_path / "file" / "below"))
    assert done.exit_code == 1
    assert "cannot write to" in done.stderr
    assert done.stderr.count("\n") == 1
    assert (tmp_path / "file").read_text("utf-8") == "mine"


def test_a_damaged_manifest_is_named(run, chapter_is, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    chapter_is(twice=TWICE)
    (tmp_path / "generated").mkdir()
    (tmp_path / "generated" / "MANIFEST.toml").write_text("files = [", "utf-8")
    monkeypatch.setattr(checkout, "installed_folder", lambda book: tmp_path / "generated")
    done = run("report", "--out", str(tmp_path / "out"))
    assert done.exit_code == 1
    assert "generated/MANIFEST.toml cannot be read" in done.stderr
    assert "chasles emit" in done.stderr
    assert not (tmp_path / "out").exists()


def test_nothing_changes_where_one_file_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "first").write_text("old", "utf-8")
    with pytest.raises(Failure, match="cannot write to"):
        write_files(tmp_path, {"first": "new", "no/such/folder": "new"})
    assert [path.name for path in tmp_path.iterdir()] == ["first"]
    assert (tmp_path / "first").read_text("utf-8") == "old"


def test_other_files_are_left_alone(tmp_path: Path) -> None:
    (tmp_path / "mine").write_text("old", "utf-8")
    write_files(tmp_path, {"first": "one\n"})
    write_files(tmp_path, {"first": "two\n"})
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == {"mine": b"old", "first": b"two\n"}
