"""What would make an installation faster is said once, and on standard error."""

from __future__ import annotations

from pathlib import Path

import pytest

from chasles.cli import hint


@pytest.fixture
def without_flint(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    monkeypatch.setattr(hint, "find_spec", lambda _: None)
    monkeypatch.setenv("CHASLES_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def test_it_is_said_once(without_flint: Path, capsys: pytest.CaptureFixture[str]) -> None:
    hint.say_once_what_is_faster()
    said = capsys.readouterr()
    assert (said.out, "pip install 'chasles[fast]'" in said.err) == ("", True)
    hint.say_once_what_is_faster()
    assert capsys.readouterr().err == ""


def test_nothing_is_said_where_it_is_there_or_nothing_is_kept(
    without_flint: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(hint, "find_spec", lambda name: name)
    hint.say_once_what_is_faster()
    monkeypatch.setattr(hint, "find_spec", lambda _: None)
    monkeypatch.setenv("CHASLES_CACHE", "")
    hint.say_once_what_is_faster()
    without_flint.write_text("no folder", "utf-8")
    monkeypatch.setenv("CHASLES_CACHE", str(without_flint))
    hint.say_once_what_is_faster()
    assert capsys.readouterr().err == ""
