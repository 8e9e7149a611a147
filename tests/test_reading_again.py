"""A page is read again when a file changes, with what was found out before."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from chasles.cli.commands.read import changes
from chasles.pages import bounded_proofs
from chasles.pages.findings_told import records_of
from chasles.pages.known_answers import KnownAnswers, recalled, retained
from chasles.pages.page import read_page
from chasles.reading.notation_file import load_notation
from chasles.reading.pages import displayed

NOTATION = r"""
[symbols]
'\mathbf{e}' = 'unit vector'
'\mathbf{a}' = 'vector'
'\mathbf{b}' = 'vector'
"""
PAGE = r"""
$$\mathbf{b} = \mathbf{e} \times \mathbf{a} \tag{1}$$
$$\mathbf{e} \cdot \mathbf{b} = 0 \tag{2}$$
$$\mathbf{e} \times \mathbf{b} = \mathbf{a} - (\mathbf{e} \cdot \mathbf{a}) \mathbf{e} \tag{3}$$
"""


def _read(page: str, known: KnownAnswers) -> list[dict[str, object]]:
    read = read_page(displayed(page, "md"), load_notation(NOTATION), "", known)
    return list(records_of(read)["equations"])


def test_what_was_found_out_is_not_asked_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CHASLES_CACHE", str(tmp_path))
    known = recalled()
    first = _read(PAGE, known)
    retained(known)
    assert [each["verdict"] for each in first] == ["defined", "holds", "fails"]
    asked: list[object] = []
    found = bounded_proofs._found
    monkeypatch.setattr(bounded_proofs, "_found", lambda *of: asked.append(of) or found(*of))
    again = recalled()
    assert _read(PAGE, again) == first
    assert not asked
    (path,) = tmp_path.iterdir()
    path.write_text("not written again")
    retained(again)
    assert path.read_text() == "not written again"
    other = _read(PAGE.replace(r"= \mathbf{a} -", r"= -\mathbf{a} +"), recalled())
    assert [each["verdict"] for each in other] == ["defined", "holds", "holds-under"]
    assert asked


def test_answers_are_those_for_the_kinds_of_the_letters(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CHASLES_CACHE", str(tmp_path))
    known = KnownAnswers()
    page = displayed(r"$$\mathbf{e} \cdot \mathbf{e} = 1$$", "md")
    (one,) = read_page(page, load_notation(NOTATION), "", known).equations
    (other,) = read_page(page, load_notation(NOTATION.replace("unit vector", "vector")), "", known).equations
    assert (one.verdict, other.verdict) == ("holds-under", "open")


def test_a_file_of_answers_that_is_broken_is_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CHASLES_CACHE", str(tmp_path))
    retained(known := KnownAnswers(may_follow={"key": True}))
    (path,) = tmp_path.iterdir()
    assert recalled().may_follow == known.may_follow
    for text in ("", "[]", '{"verdicts": 3, "may_follow": {"key": 3}, "reasons": {"key": 3}}'):
        path.write_text(text)
        assert recalled().may_follow == {}
        assert recalled().memory.reasons == {}


def test_a_page_is_read_again_whenever_a_file_changes(tmp_path: Path) -> None:
    page, notation = tmp_path / "page.md", tmp_path / "notation.toml"
    page.write_text(PAGE)
    waits = iter(("", "notation", "", "page", "gone", "stop"))

    def wait(_: float) -> None:
        match next(waits):
            case "notation":
                notation.write_text(NOTATION)
            case "page":
                page.write_text("")
                os.utime(page, ns=(0, 1))
            case "gone":
                notation.unlink()
            case "stop":
                raise KeyboardInterrupt

    assert len(list(changes([page, notation], wait))) == 4
