"""Sentences with formulas in them: what is a part of a known equation is shown as the book prints it."""

from __future__ import annotations

import re
from collections.abc import Iterable

from markupsafe import Markup, escape

from chasles.report.html.formulas import latex_for_mathml, math
from chasles.vocabulary import Node, plain, walk

ARTICLES = ("a", "A", "I")
"""Letters that are words as well."""


def with_formulas(text: str, nodes: Iterable[Node], of_words: bool = True) -> Markup:
    """The text, in which each part of the nodes that it spells in plain text is a formula, and so is an entry of one.

    The longest are found first. In a sentence `of_words` a letter that is a word too stays one.
    """
    known = {plain(part): part for node in nodes for part in walk(node)}
    spelled = [name for name in known if not name.isdecimal() and not (of_words and name in ARTICLES)]
    if not spelled:
        return escape(text)
    anyone = "|".join(re.escape(name) for name in sorted(spelled, key=lambda name: (-len(name), name)))
    pieces = re.split(rf"(?<![\w'^.(])({anyone})(?:_(\d\d?)(?!\w)|(?![\w'^~]))", text)
    found = escape(pieces[0])
    for piece, entry, words in zip(pieces[1::3], pieces[2::3], pieces[3::3], strict=True):
        latex = latex_for_mathml(known[piece])
        found += math(f"{{{latex}}}_{{{entry}}}" if entry else latex) + escape(words)
    return found
