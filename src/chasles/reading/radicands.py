"""Letters of which positive numbers are meant: those of a product or quotient under a square root, as in sqrt(k/m)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from contextlib import suppress

from chasles.reading.atoms import Unread
from chasles.reading.commands import LETTERS, SAYS
from chasles.reading.glyphs import Glyph, letter_in
from chasles.reading.lexemes import BadPage

BESIDE = r"\\(?:[dt]?frac|pi|cdot)\b|[{}/.\d]"
"""What stands beside the letters of a product or a quotient."""
LETTER = rf"(?<!\S)(?!{BESIDE})(?:\\[A-Za-z]+|[A-Za-z])(?: _ (?:\{{ [^{{}}]* \}}|\S+))?"
PRODUCT = re.compile(rf"(?:(?:{BESIDE}|{LETTER}) ?)+")
DEFINED = re.compile(rf"(?:^|\\quad |, )({LETTER})(?: \( [^()]* \))? {SAYS}")


def letters_under_roots(texts: Iterable[str]) -> Iterator[Glyph]:
    """The letters of products under square roots, but for those that an equation defines; a text is one equation."""
    texts = list(texts)
    defined = {letter for text in texts for letter in DEFINED.findall(text)}
    for inside in (_group(text[found.end() :]) for text in texts for found in re.finditer(r"\\sqrt \{ ", text)):
        names = re.findall(LETTER, inside) if PRODUCT.fullmatch(inside) else []
        if all(len(word) == 1 or word in LETTERS for word in (name.split()[0] for name in names)):
            for name in (name for name in names if name not in defined):
                with suppress(Unread, BadPage):
                    if letter := letter_in(name):
                        yield letter


def _group(text: str) -> str:
    """What stands before the brace that closes."""
    depth = 1
    for brace in re.finditer(r"[{}]", text):
        depth += 1 if brace[0] == "{" else -1
        if not depth:
            return text[: brace.start()]
    return ""
