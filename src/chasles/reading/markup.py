"""Blocks of Markdown (MyST) and reStructuredText: where mathematics stands, and what is not prose."""

from __future__ import annotations

import re
from typing import NamedTuple

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
