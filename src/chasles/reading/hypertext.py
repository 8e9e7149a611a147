"""Pages that hold mathematics in other formats, as Markdown of which each line keeps its place."""

from __future__ import annotations

import json
import re
from html import unescape

from chasles.reading.lexemes import BadPage

TAG = re.compile(r"<!--|<(/?)([a-z][\w-]*)([^<>]*)>", re.IGNORECASE)
HIDDEN = ("", "script", "style", "pre", "code", "textarea", "noscript", "syntaxhighlight", "title")
TEX = re.compile(r"math/tex|application/x-tex")
DISPLAYED = re.compile(r"mode\s*=\s*display|display\s*=\s*[\"']?block")
SOURCE = re.compile(r'\s*"source": ')


def of_html(text: str) -> str:
    """A page of HTML or of a wiki, the TeX of MathJax, KaTeX and `<math>` between dollars; no tags, no code."""
    found: list[str] = []
    lower, at, block = text.lower(), 0, False
    while tag := TAG.search(text, at):
        is_end, name, rest = tag[1] or "", (tag[2] or "").lower(), tag[3] or ""
        found.append(unescape(text[at : tag.start()]))
        at, written = tag.end(), ""
        is_wiki = name == "math" and "xmlns" not in rest and not is_end
        if name == "math":  # a wiki indents by colons what it sets off
            before = text[text.rfind("\n", 0, tag.start()) + 1 : tag.start()].strip()
            block = not is_end and bool(DISPLAYED.search(rest) or (before and not before.strip(":")))
        if is_wiki or TEX.search(rest) or (name in HIDDEN and not is_end):
            end = lower.find(f"</{name}" if name else "-->", at)
            at, inside = (end if end >= 0 else len(text)), unescape(text[at:end])
            if is_wiki or TEX.search(rest):
                sign = "$$" if block or DISPLAYED.search(rest) else "$"
                written = f"{sign}{inside}{sign}"
        if name[:1] == "h" and name[1:].isdigit() and not is_end:
            found[-1], written = found[-1].rstrip(" \t"), "#" * min(int(name[1:]), 6) + " "
        found.append(written + "\n" * (text.count("\n", tag.start(), at) - written.count("\n")) or " ")
    return "".join([*found, unescape(text[at:])])


def of_notebook(text: str) -> str:
    """The cells of a Jupyter notebook that are Markdown; raises `BadPage` for what is no notebook."""
    try:
        cells = [(cell["cell_type"], "".join(cell["source"]).split("\n")) for cell in json.loads(text)["cells"]]
    except (ValueError, LookupError, TypeError, RecursionError) as error:
        raise BadPage("this is no Jupyter notebook of version 4: it has no list of cells") from error
    places = [number for number, line in enumerate(text.split("\n"), 1) if SOURCE.match(line)]
    found: list[str] = []
    for (kind, lines), place in zip(cells, places if len(places) == len(cells) else [0] * len(cells), strict=True):
        if kind == "markdown":
            found += [*[""] * max(place - len(found), 1), *lines]
    return "\n".join(found)
