"""The report as a site of static files: the page, and a page of its own for each number, ready for any host.

Where the page of an erratum is shared, its picture is shown: what is printed, and what is right.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from importlib.util import find_spec
from io import BytesIO
from textwrap import wrap

from chasles.report.findings import DecisionsByName
from chasles.report.html.citing import Link
from chasles.report.html.filling import filled
from chasles.report.html.page import PageContents, SectionView, contents
from chasles.report.html.palette import LIGHT
from chasles.report.html.shown import NumberShown
from chasles.statements import Chapter

_WITHIN = re.compile(r'href="#([^"]*)"')
Files = Iterator[tuple[str, str | bytes]]
WIDTH, HEIGHT, DOTS = 12.0, 6.3, 100
COLUMNS, LINES = 62, 5


def site(chapter: Chapter, decisions: DecisionsByName, sources: PageContents, address: str = "") -> Files:
    """The files by name; `address` is where they will lie, which those who show a shared page's picture want to know.

    A page that is not true as printed has a picture where Matplotlib is installed. Raises DamagedEvidence.
    """
    values = contents(chapter, decisions, sources)
    yield "index.html", str(filled("index.html.jinja", **values, has_pages=True))
    yield "style.css", str(filled("theme.css.jinja", **values))
    listed = [(section, number) for section in values["sections"] for number in section.numbers]
    places = {part.place: number.place for _, number in listed for part in (number, *number.parts)}
    for k, (section, number) in enumerate(listed):
        links = [
            Link(f"{other.place}.html", other.cited)
            for _, other in (*listed[max(k - 1, 0) : k], *listed[k + 1 : k + 2])
        ]
        picture = drawn_card(number, chapter.source or chapter.title)
        if picture is not None:
            yield f"{number.place}.png", picture
        at = "" if picture is None else f"{address.rstrip('/')}{'/' * bool(address)}{number.place}.png"
        yield f"{number.place}.html", _page(values, section, number, links, at, places)


def _page(
    values: Mapping[str, object],
    section: SectionView,
    number: NumberShown,
    links: list[Link],
    picture: str,
    places: Mapping[str, str],
) -> str:
    """The page of a number, its references leading to where on the site they are."""
    text = filled(
        "number.html.jinja",
        number=number,
        heading=f"{number.cited} {number.badge.word}",
        says=" ".join(part.says for part in number.parts),
        section=f"{section.number} {section.title}",
        links=links,
        picture=picture,
        source=values["source"],
        version=values["version"],
    )

    def led(found: re.Match[str]) -> str:
        place = found[1]
        home = number.place if place == "content" else places.get(place, "index")
        return found[0] if home == number.place else f'href="{home}.html#{place}"'

    return _WITHIN.sub(led, text)


def drawn_card(number: NumberShown, source: str) -> bytes | None:
    """A PNG of 1200 x 630 dots; None for a number that is true as printed, and where Matplotlib is not installed."""
    wrong = [part for part in number.parts if part.instead]
    if not wrong or find_spec("matplotlib") is None:
        return None
    from matplotlib.figure import Figure

    part = wrong[0]
    figure = Figure(figsize=(WIDTH, HEIGHT), dpi=DOTS, facecolor=LIGHT["ground"])
    blocks = (
        (f"{number.cited}  {part.badge.word}", 34, LIGHT["bad"], "DejaVu Sans"),
        ("as printed", 17, LIGHT["quiet"], "DejaVu Sans"),
        (_lines(part.equations[0].words), 20, LIGHT["ink"], "DejaVu Sans Mono"),
        ("right is", 17, LIGHT["quiet"], "DejaVu Sans"),
        (_lines(part.instead[0].equation.words), 20, LIGHT["good"], "DejaVu Sans Mono"),
    )
    top = 0.93
    for text, size, colour, family in blocks:
        figure.text(0.04, top, text, size=size, color=colour, family=family, va="top", parse_math=False)
        top -= (text.count("\n") + 1) * size * 1.45 / (HEIGHT * 72) + 0.02
    figure.text(0.04, 0.04, source, size=14, color=LIGHT["quiet"], family="DejaVu Sans", va="bottom", wrap=True)
    file = BytesIO()
    figure.savefig(file, format="png", metadata={"Software": None})
    return file.getvalue()


def _lines(text: str) -> str:
    lines = wrap(text, COLUMNS, break_long_words=False)
    return "\n".join(lines if len(lines) <= LINES else [*lines[: LINES - 1], "..."])
