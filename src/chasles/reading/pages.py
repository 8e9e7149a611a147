"""Displayed equations of a page in LaTeX, Markdown, reStructuredText, HTML or a notebook, with numbers and places."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import PurePath
from typing import Any, Literal

from chasles.reading.function_values import with_values
from chasles.reading.lexemes import BadPage, Token, spelled
from chasles.reading.macros import MOST_WASTED, MacroTable, Source
from chasles.reading.markup import PageBlock, fenced, indented, of_html, of_notebook, spaced
from chasles.reading.mathjax_macros import configured_macros
from chasles.reading.named_in_prose import with_names
from chasles.reading.printed import PrintedEquation, PrintedPage, Remark
from chasles.reading.tex_page import CLOSING, LONGEST_REMARK, MOST_CHARACTERS, Included, TexPage

Kind = Literal["tex", "md", "rst", "html", "ipynb", "equation"]

SUFFIXES: dict[str, Kind] = {
    ".tex": "tex", ".ltx": "tex", ".md": "md", ".markdown": "md", ".myst": "md", ".dox": "md", ".rst": "rst",
    ".html": "html", ".htm": "html", ".wiki": "html", ".mediawiki": "html", ".ipynb": "ipynb",
}  # fmt: skip
LABEL_AFTER = re.compile(r"[ \t]*\(([^\s()]+)\)[ \t]*(?=\n|$)")
ROW_END = "\\\\"
ROLE = ":math:`"


def kind_of(path: str) -> Kind:
    """How a page of this name is written; raises `BadPage` for one that is none of these."""
    if (kind := SUFFIXES.get(PurePath(path).suffix.lower())) is None:
        raise BadPage(f"{path}: pages are read whose names end with {', '.join(SUFFIXES)}")
    return kind


def displayed(text: str, kind: Kind, **options: Any) -> tuple[PrintedEquation, ...]:
    """The displayed equations of a page, read as by `printed_page`."""
    return printed_page(text, kind, **options).equations


def printed_page(
    text: str,
    kind: Kind,
    *,
    file: str = "",
    macros: str = "",
    is_inline: bool = False,
    included: Included | None = None,
) -> PrintedPage:
    r"""The displayed equations of a page in its order; with `is_inline` also the equations between single dollars.

    A text of the kind "equation" is one equation. `macros` is LaTeX that defines macros, or has a table of MathJax's
    macros, as a page of HTML may have itself. `included` gives path and
    text of what \input names, which is passed over without it. Raises `BadPage` for a page of more than 5 MB and for
    files that include each other; a display that is broken is found, with its `fault`.
    """
    macros = configured_macros(macros) or macros
    if len(text) <= MOST_CHARACTERS and (as_markdown := {"html": of_html, "ipynb": of_notebook}.get(kind)):
        macros += configured_macros(text) if kind == "html" else ""
        text, kind = as_markdown(text), "md"
    pages = {"md": _MarkdownPage, "rst": _StructuredPage}
    page = pages.get(kind, TexPage)(is_inline, included)
    style = TexPage(False, included)
    style.macros = page.macros
    style.read(Source(macros, page.macros, "macros"))
    source = Source(text, page.macros, file)
    if kind == "equation":
        page.display(Token(""), "", "", source)
    else:
        page.read(source)
    remarks = tuple(_expanded(page.remarks, page.macros))
    return PrintedPage(tuple(with_values([*with_names(page.found, remarks)])), remarks)


def _expanded(remarks: Iterable[Remark], macros: MacroTable) -> Iterator[Remark]:
    """The remarks with macros expanded, but for those that are long then; none where much was expanded in vain."""
    for remark in remarks:
        if macros.wasted >= MOST_WASTED:
            return
        source = Source(remark.latex, macros)
        source.left = LONGEST_REMARK
        with suppress(BadPage):
            yield remark._replace(latex=spelled([*iter(source.next, None)]))


class _MarkdownPage(TexPage):
    """A page in Markdown, with what MyST, GitHub and Doxygen have of mathematics; equations are not counted."""

    counts = False
    special_text = re.compile(
        r"<!--|^[ \t>]*(?:`{3,}|~{3,}|:{3,})[^\n`]*$|`+"
        r"|\\f(?:\[|\{\w+\*?\}\{?)|^#{1,6}[ \t][^\n]*|\\(?:[A-Za-z@]+|.)|\$\$?",
        re.DOTALL | re.MULTILINE,
    )

    def handle(self, token: Token, source: Source) -> None:
        text = token.text
        if text == "<!--":
            end = source.text.find("-->", source.at)
            source.at = end if end > 0 else source.end
        elif text.startswith(r"\f{"):
            self.display(token, r"\f{", text[3 : text.index("}")], source)
        elif text.startswith("#"):
            self.numbering.begin_heading(text.lstrip("#").rstrip("# "))
        elif text.lstrip(" \t>")[:1] not in ("`", "~", ":"):
            super().handle(token, source)
        elif (
            token.column == 1 and len(text.lstrip(" \t>")) > 2 and source.text[source.at : source.at + 1] in ("", "\n")
        ):
            is_inside = bool(self.fences) and text.strip("> \t").startswith(self.fences[-1])
            block = fenced(source.text, source.at - len(text), source.at, is_inside)
            if block.kind == "prose":
                fence = text.strip("> \t")
                self.fences.append(fence[: len(fence) - len(fence.lstrip("`~:"))])
            self.take_block(block, source)
        else:
            end = source.text.find(text, source.at, source.at + 1000)
            source.at = end + len(text) if end > 0 else source.at

    def take_block(self, block: PageBlock, source: Source) -> None:
        """A block that is set off; of one with prose inside nothing is passed over."""
        source.at = block.after
        if block.kind == "end":
            self.fences.pop()
        if block.kind == "math":
            inside = Source(block.content, self.macros, source.file, source.place(block.start))
            raw, fault = self.content(Token("", *source.place(block.start)), "", inside)
            empty_line = [token._replace(text=ROW_END) if token.text == r"\par" else token for token in raw]
            self.take(empty_line, fault, Token("", *source.place(block.start)), "", source, block.label or "")

    def display(self, opening: Token, opener: str, environment: str, source: Source) -> None:
        block = None if source.waiting else spaced(source.text, source.at, CLOSING.get(opener, ""))
        if block:
            self.take_block(block, source)
            return
        raw, fault = self.content(opening, opener, source)
        label = LABEL_AFTER.match(source.text, source.at) if opener == "$$" else None
        if fault is None or opener != "$":
            self.take(raw, fault, opening, environment, source, label[1] if label else "")


class _StructuredPage(_MarkdownPage):
    """A page in reStructuredText."""

    special_text = re.compile(
        r"^[ \t]*\.\. [\w:-]+::[ \t]*|::[ \t]*$|^\S[^\n]*\n([=~^\"'*+#`:.-])\1{2,}[ \t]*$|:math:`|``[^`\n]*``",
        re.MULTILINE,
    )

    def handle(self, token: Token, source: Source) -> None:
        text = token.text
        if "\n" in text:
            self.numbering.begin_heading(text.partition("\n")[0])
        elif text.strip() == "::" or text.lstrip().startswith(".. "):
            self.take_block(indented(source.text, source.at - len(text), source.at), source)
        elif text == ROLE and (end := source.text.find("`", source.at, source.at + LONGEST_REMARK)) > 0:
            self.remark(source, len(ROLE), end + 1)
