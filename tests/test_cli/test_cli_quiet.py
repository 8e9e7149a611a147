"""Quiet commands: nothing to read but errors, and the JSON that was asked for."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from chasles.report import waiting
from chasles.statements import Claim
from chasles.vocabulary import scalar

x, y = scalar("x", "x", "a number"), scalar("y", "y", "another")
FINE = [
    ("decide", "3.18"),
    ("list",),
    ("show", "3.57"),
    ("derive", "3.13"),
    ("repair", "3.57"),
    ("solve", "3.7"),
    ("practice", "3.7"),
    ("doctor",),
    ("completion", "fish"),
    ("verify", "power", "--samples", "1"),
]


@pytest.mark.sampled(2)
@pytest.mark.parametrize("words", FINE, ids=" ".join)
def test_what_is_fine_says_nothing(run, words: tuple[str, ...]) -> None:
    for line in (("-q", *words), (*words, "--quiet")):
        done = run(*line)
        assert (done.exit_code, done.stdout, done.stderr) == (0, "", "")
    assert run(*words).stdout


def test_json_is_printed_all_the_same(run) -> None:
    for line in (("-q", "list", "--json"), ("list", "--json", "-q")):
        assert json.loads(run(*line).stdout) == json.loads(run("list", "--json").stdout)


def test_errors_are_printed_all_the_same(run, chapter_is) -> None:
    done = run("-q", "show", "3.199")
    assert (done.exit_code, done.stdout) == (2, "")
    assert "near it" in done.stderr
    chapter_is(wrong=Claim("9.1", x, y, corrected=(x, y + y)))
    done = run("decide", "-q")
    assert (done.exit_code, done.stdout) == (1, "")
    assert "not proved: (9.1)" in done.stderr


def test_a_page_is_written_and_not_announced(run, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    done = run("solve", "3.7", "--html", str(page), "-q")
    assert (done.exit_code, done.stdout, done.stderr) == (0, "", "")
    assert page.exists()
    assert "wrote" in run("solve", "3.7", "--html", str(page)).stderr


def test_no_bar_moves(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    drawn: list[int] = []

    class Bar:
        def __init__(self, **options: Any) -> None: ...

        def add_task(self, doing: str, total: int) -> None:
            drawn.append(total)

        def nothing(self, *_: Any) -> None: ...

        start = advance = stop = nothing

    monkeypatch.setattr("rich.progress.Progress", Bar)
    assert list(waiting.progress("ab", 2, "Doing")) == ["a", "b"]
    with waiting.silent():
        assert list(waiting.progress("abc", 3, "Doing")) == ["a", "b", "c"]
    assert drawn == [2]
