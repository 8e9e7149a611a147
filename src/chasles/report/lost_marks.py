"""The marks that a scan has lost, told from the LaTeX of the printed equation and of its reading."""

from __future__ import annotations

import re
from dataclasses import dataclass
from difflib import SequenceMatcher

TOKEN = re.compile(r"\\[A-Za-z]+|\\.|[A-Za-z0-9]|\S")
MARKS = {"&": "a separator between two blocks", r"\tilde": "a tilde", "^": "a superscript"}
"""What is small or blank on a page, and is lost when its picture is made into text."""
LAYOUT = frozenset(("{", "}", "(", ")", r"\left", r"\right", r"\mathbf", r"\boldsymbol"))
"""What a difference in a mark brings with it."""


@dataclass(frozen=True, slots=True)
class Lost:
    """The `marks` that an equation has lost in the scan, and the `letters` that it has for others, in words."""

    marks: tuple[str, ...] = ()
    letters: tuple[str, ...] = ()


def lost_marks(printed: str, read: str) -> Lost:
    """The marks and letters in which a reading differs from the printed one; none if it differs in more than these."""
    before, behind = TOKEN.findall(printed), TOKEN.findall(read)
    marks: dict[str, None] = {}
    letters: dict[str, None] = {}
    for kind, i, j, k, m in SequenceMatcher(None, before, behind, autojunk=False).get_opcodes():
        old, new = before[i:j], behind[k:m]
        small = [MARKS[token] for token in new if token in MARKS]
        if kind == "equal" or (not small and LAYOUT.issuperset((*old, *new))):
            continue
        if small:
            marks |= dict.fromkeys(small)
        elif len(old) == len(new) == 1 and _are_letters(*old, *new):
            letters[f"{_named(old[0])} for {_named(new[0])}"] = None
        else:
            return Lost()
    return Lost(tuple(marks), tuple(letters))


def _are_letters(*tokens: str) -> bool:
    return all(token.lstrip("\\").isalpha() for token in tokens)


def _named(letter: str) -> str:
    return letter.removeprefix("\\")
