"""The report as a site: a page a number, every reference leads somewhere, what is shared can be shown."""

from __future__ import annotations

import re
from pathlib import Path
from struct import unpack

import pytest

import chasles
from chasles.decisions.session import Session
from chasles.report.html.formulas import with_formulas
from chasles.report.html.overview import Trusted
from chasles.report.html.page import PageContents
from chasles.report.html.site import site
from chasles.statements import Chapter
from chasles.vocabulary import plain

NUMBERS = ("3.18", "3.16", "3.57", "3.96e", "3.50")


@pytest.fixture(scope="module")
def files() -> dict[str, str | bytes]:
    """The site of some equations of the book."""
    chapter = Chapter("Some equations", chasles.chapter.select(NUMBERS), source="Angeles & others")
    judge = Session(book=chasles.chapter, memory=None)
    decisions = {entry.name: judge.decide(entry.statement) for entry in chapter}
    return dict(site(chapter, decisions, PageContents(Trusted(0, 0, 0, 1)), "https://example.org/book"))


def test_every_number_has_a_page(files: dict[str, str | bytes]) -> None:
    expected = {"index.html", "style.css", *(f"n-{number.replace('.', '-')}.html" for number in NUMBERS)}
    assert {name for name in files if not name.endswith(".png")} == expected
    page = str(files["n-3-96e.html"])
    assert "<title>(3.96e) fails</title>" in page
    assert "Angeles &amp; others" in page
    assert "Right is" in page


def test_every_reference_leads_somewhere(files: dict[str, str | bytes]) -> None:
    places = {name: set(re.findall(r'\bid="([^"]+)"', str(text))) for name, text in files.items()}
    for name, text in files.items():
        for target in re.findall(r'href="([^"]*)"', str(text) if name.endswith(".html") else ""):
            file, _, place = target.partition("#")
            assert (file or name) in files, (name, target)
            # What is not among these equations the whole chapter would have.
            if place and places[file or name]:
                assert place in places[file or name] or place.startswith(("n-", "kernel-")), (name, target)


def test_an_erratum_has_a_picture_for_where_it_is_shared(files: dict[str, str | bytes]) -> None:
    pytest.importorskip("matplotlib")
    assert {name for name in files if name.endswith(".png")} == {"n-3-57.png", "n-3-96e.png"}
    picture = files["n-3-96e.png"]
    assert isinstance(picture, bytes)
    assert unpack(">II", picture[16:24]) == (1200, 630)
    assert 'property="og:image" content="https://example.org/book/n-3-96e.png"' in str(files["n-3-96e.html"])
    assert "og:image" not in str(files["n-3-18.html"])


def test_changes_and_reasons_are_formulas(files: dict[str, str | bytes]) -> None:
    page = str(files["n-3-57.html"])
    [reason] = re.findall(r"<dt>does not fit</dt><dd>(.*?)</dd>", page, re.DOTALL)
    assert "omega" not in re.sub(r"<math.*?</math>", "", reason, flags=re.DOTALL)
    assert reason.count("<math") == 2
    [changes] = re.findall(r'<ul class="changes">(.*?)</ul>', page, re.DOTALL)
    assert "the vector factor <math" in changes


def test_only_what_is_part_of_an_equation_becomes_a_formula() -> None:
    [decision] = chasles.decide("3.57/1")
    sides = decision.statement.printed
    said = str(with_formulas(f"a body < another; {plain(sides[0])} turns", sides))
    assert said.startswith("a body &lt; another; <math")
    assert said.endswith("</math> turns")
    assert str(with_formulas("nothing known", ())) == "nothing known"


def test_the_command_writes_it_whole(tmp_path: Path) -> None:
    from chasles.cli.files import write_files

    write_files(tmp_path / "site", {"index.html": "words", "picture.png": b"\x89PNG"})
    assert (tmp_path / "site" / "index.html").read_text("utf-8") == "words"
    assert (tmp_path / "site" / "picture.png").read_bytes() == b"\x89PNG"
