"""LaTeX split as TeX splits it, each piece with its place."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple, Protocol, TypeVar

SPACE_BEHIND = r"\*?(?:\s*\[\s*-?[\d.]*\s*(?:em|ex|pt|px|pc|bp|mm|cm|in|mu|sp|\\\w+)\s*\])?"
LEXEME = re.compile(rf"%[^\n]*(?:\n[ \t]*|$)|\\\\{SPACE_BEHIND}|\\(?:[A-Za-z@]+|.|$)|\s+|.", re.DOTALL)
GROUP_OPENING = re.compile(r"\{$|\\begin\b")
GROUP_CLOSING = re.compile(r"\}$|\\end\b")
MOST_LEXEMES = 20_000


class BadPage(ValueError):
    """What cannot be read of a page, and where: its text says it in one line."""

    def __init__(self, message: str, line: int = 1, column: int = 1) -> None:
        super().__init__(message)
        self.line, self.column = line, column


class Token(NamedTuple):
    """A piece of an equation: a control word, one letter, one number or one sign, with its place in the page."""

    text: str
    line: int = 1
    column: int = 1


class Printed(Protocol):
    """What stands on a page."""

    @property
    def text(self) -> str: ...


Piece = TypeVar("Piece", bound=Printed)


def lexemes(latex: str, line: int = 1, column: int = 1) -> list[Token]:
    """The text as TeX splits it, comments left out and white space as one blank."""
    found: list[Token] = []
    for match in LEXEME.finditer(latex):
        text = match[0]
        if not text.startswith("%"):
            found.append(Token(blank(text), line, column))
            if len(found) > MOST_LEXEMES:
                raise BadPage(f"an equation of more than {MOST_LEXEMES} tokens: write it as several", line, column)
        lines = text.count("\n")
        line, column = line + lines, len(text) - text.rfind("\n") if lines else column + len(text)
    return found


def blank(text: str) -> str:
    r"""White space as TeX has it: a blank, or \par for an empty line; a row's end bare; any other text as it stands."""
    if text.startswith("\\\\"):
        return "\\\\"
    return text if not text.isspace() else " " if text.count("\n") < 2 else r"\par"


def spelled(raw: Iterable[Token]) -> str:
    """The text that is split into these lexemes."""
    text = ""
    for token in raw:
        glued = token.text[:1].isalpha() and re.search(r"\\[A-Za-z@]+$", text)
        text += " " + token.text if glued else token.text
    return text.strip()


def cut(
    pieces: Iterable[Piece], signs: tuple[str, ...], opening: tuple[str, ...] = (), closing: tuple[str, ...] = ()
) -> list[list[Piece]]:
    """The pieces parted at these signs, where they are in no group, no environment and no such brackets."""
    parts: list[list[Piece]] = [[]]
    depth = 0
    for piece in pieces:
        depth += bool(GROUP_OPENING.match(piece.text)) or piece.text in opening
        depth -= depth > 0 and (bool(GROUP_CLOSING.match(piece.text)) or piece.text in closing)
        if depth == 0 and piece.text in signs:
            parts.append([])
        else:
            parts[-1].append(piece)
    return parts
