"""What the README shows runs, and what it says is so."""

from __future__ import annotations

import html
import re
import runpy
from pathlib import Path

import pytest

import chasles
from chasles.report.findings import numbers_of

ROOT = Path(__file__).parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(\w+)\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)


def test_every_block_is_of_a_kind_that_is_tested() -> None:
    assert {kind for kind, _ in BLOCKS} == {"python"}


@pytest.mark.parametrize("text", [text for _, text in BLOCKS])
def test_python_runs(text: str) -> None:
    exec(compile(text, "README.md", "exec"), {})


def test_the_picture_is_what_the_command_prints() -> None:
    terminal = runpy.run_path(str(ROOT / "docs" / "_extensions" / "terminal.py"))
    kept, made = terminal["PICTURE"].read_text("utf-8"), terminal["drawn"](terminal["printed"]())
    assert words_of(kept) == words_of(made), "run python docs/_extensions/terminal.py"
    assert "fails" in words_of(kept)
    assert "http" not in kept.replace("http://www.w3.org/2000/svg", "")


def words_of(picture: str) -> list[str]:
    """The words of a picture; its lines may be laid out by another version of the library."""
    lines = re.findall(r"<text[^>]*>(.*?)</text>", picture, re.DOTALL)
    return " ".join(html.unescape(line).replace("\N{NO-BREAK SPACE}", " ") for line in lines).split()


def test_links_lead_somewhere() -> None:
    places = re.findall(r"\]\(([^)#]+)\)", README)
    assert len(places) > 10
    assert [place for place in places if not (ROOT / place).exists()] == []


def test_the_number_that_people_repeat_is_right() -> None:
    """What is lost by the scan and wrong in the book is wrong in the book."""
    errata = (ROOT / "generated" / "ERRATA.md").read_text("utf-8")
    [counted] = re.findall(r"are not true as printed: (.*)\.$", errata, re.MULTILINE)
    wrong = sum(int(number) for number in re.findall(r"(\d+) (?:[a-z ]* and )?wrong in the book", counted))
    assert f"**{wrong} are wrong in the book**" in README
    assert f"{numbers_of(chasles.chapter).own} numbered equations" in README
