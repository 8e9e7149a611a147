"""Figures of matplotlib as parts of the page: small, in the page's colours, with words for who does not see them.

Each is drawn once, and kept by the hash of what it shows, of where it stands and of all that draws it.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Callable
from hashlib import sha256
from io import StringIO
from itertools import count
from typing import Any
from xml.etree.ElementTree import Element, SubElement, fromstring, tostring

from markupsafe import Markup

from chasles import cache
from chasles.exercises.picture import Arrow, Curve, DrawnBody, Graph, Line, Picture, Point

COLOURS = {
    "#ffffff": "ground",
    "#f2f2f2": "raised",
    "#e6e6e6": "raised",
    "#ececec": "raised",
    "#b0b0b0": "rule",
    "#cccccc": "rule",
    "#dddddd": "rule",
    "#999999": "quiet",
    "#000000": "ink",
    "#0072b2": "first",
    "#d55e00": "second",
    "#009e73": "third",
    "#e69f00": "fourth",
}
"""matplotlib's colours, and those of `chasles.exercises.drawing`, by the page's names for theirs."""
LEFT_OUT = ("stroke-linejoin: miter", "stroke-linecap: square", "stroke-linecap: butt")
"""How ends and corners are drawn makes no difference at this size."""
SVG = "{http://www.w3.org/2000/svg}"
HREF = "{http://www.w3.org/1999/xlink}href"
Names = defaultdict[str, str]
"""New names of the parts that others refer to, by the old ones."""
KINDS = ((DrawnBody, "bodies"), (Line, "lines"), (Arrow, "arrows"), (Curve, "curves"), (Point, "points"))
ROOM, MOST = "pictures", 16 * 2**20
"""The folder in the cache, and how many bytes of pictures are kept: some hundred reports."""
DRAWING = ("exact", "exercises", "report")
"""The packages on which a picture depends."""


def inline(figure: Any, place: str, title: str, words: str) -> Markup:
    """The figure as SVG, its title in the element of that name instead of the drawing.

    `place` is the beginning of the names of its parts, which no other part of the page has.
    """
    root = fromstring(_drawn(figure))
    numbers = count(1)
    names: Names = defaultdict(lambda: f"{place}-{next(numbers)}")
    svg = Element("svg", {"class": "picture", "viewBox": root.get("viewBox", ""), "role": "img",
                          "aria-labelledby": f"{place}-title {place}-text"})  # fmt: skip
    SubElement(svg, "title", id=f"{place}-title").text = title
    SubElement(svg, "desc", id=f"{place}-text").text = words
    svg.extend(part for child in root for part in _slim(child, names))
    return Markup(tostring(svg, encoding="unicode"))


def said_of(picture: Picture) -> str:
    """What is to be seen, in words: the names of what is drawn, kind by kind, or of a graph's curves."""
    graphs = [item for item in picture.items if isinstance(item, Graph)]
    if graphs:
        named = ", ".join(label for label, _ in graphs[0].curves)
        first, last = graphs[0].over
        return f"{named} over the {graphs[0].unit} from {first} to {last}."
    parts = []
    for kind, word in KINDS:
        names = [item.label for item in picture.items if isinstance(item, kind) and item.label]
        if names:
            parts.append(f"{word}: {', '.join(names)}")
    return f"Drawn in space, {'; '.join(parts)}." if parts else "Drawn in space."


def _drawn(figure: Any) -> str:
    """The figure as matplotlib writes it, its letters as text."""
    from matplotlib import rc_context
    from matplotlib.text import Text

    for axes in figure.axes:
        axes.set_title("")
    for text in figure.findobj(Text):
        text.set_path_effects([])
    written = StringIO()
    with rc_context({"svg.fonttype": "none", "svg.hashsalt": "chasles"}):
        figure.savefig(written, format="svg", metadata={"Date": None}, bbox_inches="tight", pad_inches=0.05)
    return written.getvalue()


def _slim(element: Element, names: Names) -> list[Element]:
    """The element without what is not drawn; a group without attributes is only what is in it."""
    tag = element.tag.removeprefix(SVG)
    if tag in ("metadata", "style"):
        return []
    children = [part for child in element for part in _slim(child, names)]
    attributes = dict(_attributes(tag, element, names))
    if tag == "g" and not attributes:
        return children
    if tag in ("g", "defs") and not children:
        return []
    slim = Element(tag, attributes)
    slim.text = (element.text or "").strip() or None
    slim.extend(children)
    return [slim]


def _attributes(tag: str, element: Element, names: Names) -> Any:
    """The attributes that are needed, by their short names, the numbers rounded."""
    is_cited = tag == "clipPath" or (tag == "path" and "id" in element.attrib)
    for name, value in element.attrib.items():
        if name == "id":
            if is_cited:
                yield "id", names[value]
        elif name == HREF:
            yield "href", f"#{names[value[1:]]}"
        elif name == "clip-path":
            yield name, f"url(#{names[value[5:-1]]})"
        elif name == "style":
            if style := _style(value):
                yield name, style
        elif name == "transform" and re.match(r"rotate\(-?0 ", value):
            continue
        else:
            yield name, _rounded(value)


def _style(style: str) -> str:
    """The style in the page's colours; letters are those of the page."""
    kept = [one for one in style.split("; ") if one not in LEFT_OUT and not one.startswith(("font-family", "font:"))]
    text = ";".join(one.replace(": ", ":") for one in kept)
    return re.sub(r"#[0-9a-f]{6}\b", lambda found: f"var(--{COLOURS[found[0]]})", text)


def _rounded(value: str) -> str:
    """The numbers with one decimal; of a path, without blanks that separate nothing."""
    short = re.sub(r"-?\d+\.\d+", lambda found: f"{float(found[0]):.1f}".removesuffix(".0"), value)
    return re.sub(r" *([A-Za-z]) *", r"\1", " ".join(short.split())) if short[:2] == "M " else short


def drawn(shows: Any, place: str, draw: Callable[[], Markup]) -> Markup:
    """The picture of this that is kept, or the one that `draw` makes, which is kept for the next time."""
    said = repr(shows)
    if " at 0x" in said:  # it holds what cannot be told by its words
        return draw()
    key = sha256(f"{cache.engine(DRAWING, ('matplotlib',))} {place} {said}".encode()).hexdigest()
    return Markup(cache.kept(ROOM, f"{key}.svg", lambda: draw().encode(), MOST).decode())
