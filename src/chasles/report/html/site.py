"""The report as a site of static files: the page, and a page of its own for each number, ready for any host."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from chasles.report.findings import DecisionsByName
from chasles.report.html.citing import Link
from chasles.report.html.filling import filled
from chasles.report.html.page import PageContents, SectionView, contents
from chasles.report.html.shared_card import drawn_card
from chasles.report.html.shown import NumberShown
from chasles.statements import Chapter

_WITHIN = re.compile(r'href="#([^"]*)"')
Files = Iterator[tuple[str, str | bytes]]


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
