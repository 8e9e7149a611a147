"""Does an expression print the tokens of the page again? Typefaces, braces, alignment and spaces are layout."""

from __future__ import annotations

import re

LAYOUT = {r"\left", r"\right", r"\quad", r"\,", r"\ ", r"\\", r"\mathbf", r"\boldsymbol", r"\overrightarrow", r"\text",
          r"\mathsf", r"\mathrm", r"\operatorname", "&", ",", "{", "}"}  # fmt: skip
MATRIX = re.compile(r"\\(begin|end)\{[bp]matrix\}")
MARK = re.compile(r"\\[a-zA-Z]+|\\.|[A-Za-z]|\d+|\S")


def tokens_of(text: str) -> tuple[str, ...]:
    """The text as tokens without layout: a matrix is what stands in square brackets."""
    text = MATRIX.sub(lambda found: " [ " if found[1] == "begin" else " ] ", text)
    return tuple(token for token in MARK.findall(text) if token not in LAYOUT)
