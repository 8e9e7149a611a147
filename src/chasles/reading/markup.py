"""Blocks of Markdown (MyST) and reStructuredText: where mathematics stands, and what is not prose.

Pages in other formats are read as Markdown of which each line keeps its place.
"""

from __future__ import annotations

import json
import re
from html import unescape
from typing import NamedTuple

from chasles.reading.lexemes import BadPage

FENCE = re.compile(r"[ \t>]*(([`~:])\2{2,})[ \t]*([^\s`]*)")
DIRECTIVE = re.compile(r"([ \t]*)\.\. ([\w:-]+)::[ \t]*")
LABEL = re.compile(r"^[ \t]*:?(?:label|name):[ \t]*(\S+)[ \t]*$", re.MULTILINE)
OPTIONS = re.compile(
    r"^[ \t]*:(?:label|name|no-?wrap|class|enumerated|number)[\w-]*:[^\n]*$|\A\s*---\n[^=]*?\n---$", re.MULTILINE
)
CODE = re.compile(
    r"\{?(?:code|sourcecode|highlight|parsed-literal|literalinclude|mermaid|raw|comment|doctest|test|plot|ipython|jupyter"
    r"|graph|prompt|csv-table|toctree|bibliography|thebe)|[^{]"
)


EMPTY_LINE = re.compile(r"\n[ \t>]*\n")
PROSE = re.compile(r"\$|^[ \t>]*#|(?<![\\A-Za-z{])[A-Za-z]{2,}(?:[ \n][a-z]{2,}){2}(?!})", re.MULTILINE)
"""A sign of another formula, a heading, or three words in a row."""
TAG = re.compile(r"<!--|<(/?)([a-z][\w-]*)([^<>]*)>", re.IGNORECASE)
HIDDEN = ("", "script", "style", "pre", "code", "textarea", "noscript", "syntaxhighlight", "title")
TEX = re.compile(r"math/tex|application/x-tex")
DISPLAYED = re.compile(r"mode\s*=\s*display|display\s*=\s*[\"']?block")
SOURCE = re.compile(r'\s*"source": ')


class PageBlock(NamedTuple):
    """A block of a page: "math", "code", "prose" or the "end" of such; its content and what follows begin there."""

    kind: str
    start: int
    after: int
    content: str = ""
    label: str | None = None


def fenced(text: str, start: int, end: int, is_inside: bool) -> PageBlock:
    """The block of Markdown that the fence between these places opens; one with prose inside ends right there."""
    fence = FENCE.match(text, start, end)
    assert fence
    kind = fence[3]
    if not kind and is_inside:
        return PageBlock("end", end, end)
    if kind not in ("math", "{math}") and (fence[2] == ":" or (kind and not CODE.match(kind))):
        return PageBlock("prose", end, end)
    closing = re.compile(rf"^[ \t>]*{fence[2]}{{{len(fence[1])},}}[ \t]*$", re.MULTILINE).search(text, end)
    block = _content(text, "math" if "math" in kind else "code", end, closing)
    return block._replace(after=closing.end()) if closing else block


def spaced(text: str, start: int, closer: str) -> PageBlock | None:
    """A display that begins here and has empty lines in it, and no prose."""
    end = text.find(closer, start) if closer in ("$$", r"\f]", r"\f}") else -1
    if end < 0 or not EMPTY_LINE.search(text, start, end) or PROSE.search(text, start, end):
        return None
    return PageBlock("math", start, end + len(closer), text[start:end])


def indented(text: str, start: int, end: int) -> PageBlock:
    """The block that the directive of reStructuredText between these places has, or what is indented after "::"."""
    directive = DIRECTIVE.match(text, start, end)
    line = text.rfind("\n", 0, start) + 1
    width = len(text[line:end]) - len(text[line:end].lstrip())
    closing = re.compile(rf"^[ \t]{{0,{width}}}\S", re.MULTILINE).search(text, end)
    kind = directive[2] if directive else "code"
    if kind != "math" and not CODE.match("{" + kind):
        return PageBlock("prose", end, end)
    begin = directive.end() if directive else end
    return _content(text, "math" if kind == "math" else "code", begin, closing)


def _content(text: str, kind: str, begin: int, closing: re.Match[str] | None) -> PageBlock:
    """The block, its options blanked out."""
    end = closing.start() if closing else len(text)
    content = text[begin:end] if kind == "math" else ""
    label = LABEL.search(content)
    content = OPTIONS.sub(lambda option: re.sub(r"[^\n]", " ", option[0]), content)
    return PageBlock(kind, begin, end, content, label and label[1])


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
