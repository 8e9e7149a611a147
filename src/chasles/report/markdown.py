"""Text for Markdown pages: tables whose cells may hold anything, equations set off from the text."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

SPECIAL = str.maketrans({mark: rf"\{mark}" for mark in r"\`*_[]<>|#"})


def escaped(text: str) -> str:
    """The text as it stands: nothing in it is a mark of Markdown."""
    return text.translate(SPECIAL)


def code(text: str) -> str:
    """The text as code, in as many backticks as it takes."""
    fence = "`"
    while fence in text:
        fence += "`"
    blank = " " if text.startswith("`") or text.endswith("`") else ""
    return f"{fence}{blank}{text}{blank}{fence}"


def displayed(latex: str) -> str:
    """An equation on a line of its own."""
    return f"$$\n{latex}\n$$"


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    """The lines of a table; the cells are Markdown already, in which bars are escaped here."""
    yield f"| {' | '.join(head)} |"
    yield f"|{'|'.join(' --- ' for _ in head)}|"
    for row in rows:
        yield f"| {' | '.join(row)} |".replace("  ", " ")
