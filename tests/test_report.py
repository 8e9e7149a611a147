"""The report: complete, well-formed, legible, the same each time; and nothing in it that was not decided."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import replace
from itertools import pairwise
from xml.etree.ElementTree import fromstring

import pytest

from chasles.decisions.session import Session
from chasles.report.findings import slips_in_words
from chasles.report.html.citing import place_of_number
from chasles.report.html.overview import Trusted
from chasles.report.html.page import PageContents, page
from chasles.report.html.palette import DARK, LIGHT
from chasles.report.latex_page import escaped, latex_page
from chasles.statements import Chapter, Claim, Entry, Section, Statement, load, nonzero
from chasles.verdict import Undecided
from chasles.vocabulary import column, norm, scalar, vector

from .parsed_page import Parsed
from .sampling import WHOLE

RAW_LATEX = re.compile(r"\\[A-Za-z]+|\\[{}|,]|[_^]\{|&#|&amp;")
SECTION = Section("9.1", "On <Bars> & Others")
x = vector("x", "x", "any vector")
k = scalar("k", "k", "any number")
EVERYTHING = {
    "right_one": Claim("9.2", norm(x) ** 2, x.T @ x, says="It holds, 1 < 2 & so on."),
    "under": Claim("9.10", k / k * x, x, says="It needs something.", assuming=(nonzero(k),)),
    "wrong": Claim("9.3", 2 * x, 3 * x, says="It fails."),
    "hollow": Claim("9.5", column(x, x), x, says="It does not fit.", reading=column(x, x)),
}


TEXT_ON = (
    *((text, ground) for text in ("ink", "quiet", "link") for ground in ("ground", "raised")),
    *((kind, f"{kind}-ground") for kind in ("good", "bad", "odd", "open", "plain")),
    *((kind, ground) for kind in ("good", "bad", "odd", "open", "plain") for ground in ("ground", "raised")),
    ("ink", "taken-ground"),
    ("ink", "added-ground"),
    ("ink", "bad-ground"),
    ("quiet", "bad-ground"),
    ("link", "bad-ground"),
    ("ground", "link"),
    *((curve, "ground") for curve in ("first", "second", "third", "fourth")),
)
"""Which colour of text is put on which ground."""


def contrast(text: str, ground: str) -> float:
    """The contrast of two colours given as #rrggbb, from 1 to 21, as WCAG 2 defines it."""
    lighter, darker = sorted((_luminance(text), _luminance(ground)), reverse=True)
    return (lighter + 0.05) / (darker + 0.05)


def _luminance(colour: str) -> float:
    parts = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def small(**statements: Statement) -> tuple[str, str]:
    """The page and the LaTeX of a small chapter."""
    book = Chapter("Bars & Co_1", tuple(Entry(name, SECTION, statement) for name, statement in statements.items()))
    judge = Session(book=book)
    decisions = {entry.name: judge.decide(entry.statement) for entry in book}
    return page(book, decisions, PageContents(Trusted(2, 1, 0, 800))), latex_page(book, decisions)


@pytest.fixture(scope="module")
def html(report: dict[str, str]) -> str:
    return report["index.html"]


@pytest.fixture(scope="module")
def parsed(html: str) -> Parsed:
    return Parsed(html)


def test_the_page_is_well_formed(html: str, parsed: Parsed) -> None:
    assert html.startswith("<!DOCTYPE html>\n")
    assert parsed.mistakes == []


def test_it_is_one_small_file_that_loads_nothing(html: str, parsed: Parsed) -> None:
    assert 1e6 < len(html.encode()) < 5e6
    assert not {"link", "img", "iframe", "object", "embed"} & {tag for tag, _ in parsed.tags}
    assert [attributes for tag, attributes in parsed.tags if tag == "script"] == [{}], "the search, and nothing else"
    assert not [name for _, attributes in parsed.tags for name in attributes if name.startswith("on") or name == "src"]
    assert not re.search(r"url\((?!#)", html)
    assert "@import" not in html
    assert "://" not in html


def test_every_number_of_the_book_is_there(html: str, parsed: Parsed) -> None:
    book = load()
    assert {place_of_number(number) for number in book.numbers} <= set(parsed.ids)
    equations = [number for number in book.numbers if number.startswith("3.")]
    assert len(equations) == 172
    assert [number for number in equations if f">({number})</a></h4>" not in html] == []
    assert len(re.findall('<div class="part"', html)) == len(book.entries)


def test_places_are_unique_and_links_lead_to_them(parsed: Parsed) -> None:
    assert [name for name, count in Counter(parsed.ids).items() if count > 1] == []
    known = set(parsed.ids)
    assert [link for link in parsed.having("href") if link[:1] != "#" or link[1:] not in known] == []
    named = {
        name for attribute in ("aria-labelledby", "for") for value in parsed.having(attribute) for name in value.split()
    }
    named |= {name for value in parsed.having("clip-path") for name in re.findall(r"url\(#(.*)\)", value)}
    assert named <= set(parsed.ids)


def test_headings_are_in_order(parsed: Parsed) -> None:
    levels = [int(tag[1]) for tag, _ in parsed.tags if re.fullmatch("h[1-6]", tag)]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(after <= before + 1 for before, after in pairwise(levels))


def test_a_screen_reader_finds_its_way(html: str, parsed: Parsed) -> None:
    tags = [tag for tag, _ in parsed.tags]
    assert dict(parsed.tags[0][1]) == {"lang": "en"}
    assert all(tags.count(landmark) == 1 for landmark in ("main", "nav", "footer"))
    assert html.index('class="skip"') < html.index("<header>")
    drawings = [attributes for tag, attributes in parsed.tags if tag == "svg"]
    assert drawings
    assert all(drawing["aria-labelledby"] for drawing in drawings)
    # What a picture has in it is not read: a drawing with links is a group.
    assert {drawing["role"] for drawing in drawings if drawing["class"] == "graph"} == {"group"}
    assert all(drawing["role"] == "img" for drawing in drawings if drawing["class"] != "graph")
    assert tags.count("table") == tags.count("caption")


def test_every_formula_is_mathml(html: str, parsed: Parsed) -> None:
    statements = sum(isinstance(entry.statement, Statement) for entry in load())
    formulas = re.findall(r"<math.*?</math>", html, re.S)
    assert len(formulas) > statements
    for formula in formulas:
        root = fromstring(formula)
        assert not RAW_LATEX.search("".join(root.itertext())), formula
        assert not [part for part in root.iter() if part.tag in ("mi", "mo", "mn") and not (part.text or "").strip()]
        assert not [part for part in root.iter() if "mathvariant" in part.attrib]
    assert [hit for hit in re.findall(r"\\[A-Za-z]+\{?|[_^]\{", parsed.visible) if hit] == []


def test_colours_can_be_told_apart() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.01)
    assert LIGHT.keys() == DARK.keys()
    for palette in (LIGHT, DARK):
        assert {
            pair: round(contrast(*(palette[name] for name in pair)), 2)
            for pair in TEXT_ON
            if contrast(*(palette[name] for name in pair)) < 4.5
        } == {}


def test_only_colours_of_the_palette_are_used(html: str) -> None:
    style = html.split("<style>")[1].split("</style>")[0]
    # How wide a formula is says the formula.
    assert set(re.findall(r"var\(--([a-z-]+)\)", style)) - {"wide"} <= set(LIGHT)
    assert set(re.findall(r"#[0-9a-f]{6}\b", style)) <= {*LIGHT.values(), *DARK.values()}


def test_every_verdict_and_section_has_its_filter(html: str, parsed: Parsed) -> None:
    style = html.split("<style>")[1].split("</style>")[0]
    filters = [attributes["id"] for _, attributes in parsed.tags if attributes.get("type") == "radio"]
    assert len(filters) == len(set(filters)) > 10
    for name in filters:
        what = ".number" if name.startswith("verdict") else ".of-book"
        assert name in ("verdict-all", "only-all") or f"#{name}:checked) {what}:not(" in style
    classes = {name for value in parsed.having("class") for name in value.split()}
    assert set(re.findall(r":not\(\.([a-z0-9-]+)\)", style)) <= classes


def test_what_is_wrong_has_its_reason_and_what_is_right(html: str) -> None:
    errata = html.split('<section id="errata"')[1].split("</section>")[0]
    wrong = errata.split('<article class="erratum"')[1:]
    groups = [(len(group.split("<article")) - 1, group.partition("</h3>")[0]) for group in errata.split("<h3>")[1:]]
    assert groups == [(3, "Wrong in the book"), (5, "Lost by the scan"), (4, "Lost by the scan and wrong in the book")]
    assert all('<p class="lead-in">Right is</p>' in slip for slip in wrong)
    fails = next(slip for slip in wrong if ">(3.96e)</a>" in slip)
    assert all(f"<dt>{word}</dt>" in fails for word in ("at", "the left side is", "the right side is"))
    assert 'class="added"' in fails
    assert 'class="taken"' in fails


def test_only_what_is_refuted_or_ill_formed_is_called_wrong():
    said = {name: Session().decide(EVERYTHING[name]) for name in ("right_one", "wrong", "hollow")}
    pairs = [(Entry(name, SECTION, EVERYTHING[name]), decision) for name, decision in said.items()]
    assert slips_in_words(pairs) == "1 wrong in the book, 1 lost by the scan"
    open_ones = [(entry, replace(decision, verdict=Undecided("too large"))) for entry, decision in pairs]
    assert slips_in_words(open_ones) == ""


def test_certificates_and_kernels_are_named(html: str) -> None:
    assert len(re.findall(r"sha256:[0-9a-f]{64}", html)) > 250
    assert "rotation_from_axis_angle (24 operations)" in html
    assert "6 add, 4 subtract, 12 multiply, 1 sine, 1 cosine" in html


def test_roads_open_and_close(html: str) -> None:
    roads = html.split('<details class="road">')[1:]
    assert len(roads) > (50 if WHOLE else 12)
    assert all("complete" in road for road in roads)
    assert not re.search(r"<details[^>]* open", html)


def test_text_is_text() -> None:
    html, latex = small(**EVERYTHING)
    assert Parsed(html).mistakes == []
    assert "On &lt;Bars&gt; &amp; Others" in html
    assert "It holds, 1 &lt; 2 &amp; so on." in html
    assert r"Bars \& Co\_1" in latex
    assert escaped(r"a_b^c~{\x}#$%&") == (r"a\_b\textasciicircum{}c\textasciitilde{}\{\textbackslash{}x\}\#\$\%\&")


def test_a_chapter_without_kernels_or_roads_has_a_page() -> None:
    html, _ = small(**EVERYTHING)
    assert "holds under" in html
    assert "0 functions" in html
    assert '<details class="road">' not in html


def test_the_verdicts_are_those_of_the_decisions() -> None:
    html, latex = small(**EVERYTHING)
    badges = {number: re.findall(r'class="badge ([a-z-]+)"', part) for number, part in parts_by_number(html).items()}
    assert badges == {
        "(9.2)": ["holds"],
        "(9.3)": ["fails", "holds"],
        "(9.5)": ["ill-formed"],
        "(9.10)": ["holds-under"],
    } or (
        {number: found[0] for number, found in badges.items()}
        == {"(9.2)": "holds", "(9.3)": "fails", "(9.5)": "ill-formed", "(9.10)": "holds-under"}
    )
    assert r"\statement{(9.3)}{fails}{}" in latex


def parts_by_number(html: str) -> dict[str, str]:
    articles = re.findall(r'<article id="[^"]*" class="number.*?</article>', html, re.S)
    return {re.findall(r">([^<]*)</a></h4>", article)[0]: article for article in articles}


def test_the_latex_is_balanced(report: dict[str, str]) -> None:
    text = report["chapter.tex"]
    opened: list[str] = []
    for word, name in re.findall(r"\\(begin|end)\{(\w+)\}", text):
        if word == "begin":
            opened.append(name)
        else:
            assert opened.pop() == name
    assert opened == []
    bare = re.sub(r"\\[\\{}%]", "", text)
    assert bare.count("{") == bare.count("}")
    assert len(re.findall(r"\\left(?![a-z])", text)) == len(re.findall(r"\\right(?![a-z])", text))
    assert all(f"{{({number})}}" in text for number in load().numbers if number.startswith("3."))
