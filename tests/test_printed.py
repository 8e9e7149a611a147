"""The declarations say what the book prints: their LaTeX is compared, token by token, with the source."""

from __future__ import annotations

import re
import tomllib
from dataclasses import replace
from pathlib import Path

import pytest

from chasles.statements import Chapter, Statement, load
from chasles.vocabulary import Negative, latex

HERE = Path(__file__).parent
PRINTED: dict[str, str] = tomllib.loads((HERE / "printed.toml").read_text(encoding="utf-8"))
DIFFERENCES: dict[str, str] = tomllib.loads((HERE / "printed_differences.toml").read_text(encoding="utf-8"))
LAYOUT = {r"\left", r"\right", r"\quad", r"\,", r"\ ", r"\\", r"\mathbf", r"\boldsymbol", r"\overrightarrow", r"\text"}
PUNCTUATION = {"&", ",", "{", "}"}


def without_underbraces(text: str) -> str:
    """The text with each underbrace replaced by what it embraces."""
    while (start := text.find(r"\underbrace{")) >= 0:
        inner = start + len(r"\underbrace{")
        middle = closing(text, inner)
        end = middle + 1
        if text[end : end + 2] == "_{":
            end = closing(text, end + 2) + 1
        elif text[end : end + 1] == "_":
            end += 2
        text = text[:start] + text[inner:middle] + text[end:]
    return text


def closing(text: str, start: int) -> int:
    """Where the brace that is open at `start` closes."""
    depth = 1
    for place in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[place], 0)
        if depth == 0:
            return place
    raise ValueError(f"no closing brace in {text!r}")


def tokens(text: str) -> list[str]:
    """The text as a stream of tokens, without layout: a matrix is a pair of square brackets."""
    text = without_underbraces(text)
    text = re.sub(r"\\(begin|end)\{aligned\}|\\text\{or\}", " ", text)
    text = text.replace(r"\begin{bmatrix}", " [ ").replace(r"\end{bmatrix}", " ] ")
    found = re.findall(r"\\[a-zA-Z]+|\\.|[A-Za-z]|\d+|\S", text)
    return [token for token in found if token not in LAYOUT and token not in PUNCTUATION]


def assembled(parts: list[Statement]) -> str:
    """The statements of one number as the book prints them: a chain goes on where it can, nothing is said twice."""
    text, last = "", None
    for part in parts:
        left, right = latex(part.left), latex(part.right)
        if last is None:
            text = f"{left} {part.sign} {right}"
        elif (left, right) == (latex(last.left), latex(last.right)):
            continue
        elif left in (latex(last.right), latex(last.left)):
            text += f" {part.sign} {right}"
        elif right == latex(last.right):
            text += f" {part.sign} {left}"
        else:
            text += f" {left} {part.sign} {right}"
        last = part
    return text


def declared(chapter: Chapter) -> dict[str, list[Statement]]:
    numbered: dict[str, list[Statement]] = {}
    for entry in chapter:
        if isinstance(entry.statement, Statement) and entry.number in PRINTED:
            numbered.setdefault(entry.number, []).append(entry.statement)
    return {number: sorted(parts, key=lambda part: part.part) for number, parts in numbered.items()}


CHAPTER = load()
DECLARED = declared(CHAPTER)


def test_the_source_has_all_its_numbers():
    assert len(PRINTED) == 172


@pytest.mark.parametrize("number", list(DECLARED))
def test_declared_as_printed(number: str):
    same = tokens(assembled(DECLARED[number])) == tokens(PRINTED[number])
    if number in DIFFERENCES:
        assert not same, f"({number}) is as printed now: take it off the list of differences"
    else:
        assert tokens(assembled(DECLARED[number])) == tokens(PRINTED[number])


def test_every_listed_difference_is_declared_and_explained():
    assert set(DIFFERENCES) <= set(DECLARED)
    assert all(DIFFERENCES.values())


@pytest.mark.parametrize("number", ["3.2", "3.13", "3.50"])
def test_a_flipped_sign_is_seen(number: str):
    part, *others = DECLARED[number]
    flipped = replace(part, right=Negative(part.right))
    assert tokens(assembled([flipped, *others])) != tokens(PRINTED[number])
