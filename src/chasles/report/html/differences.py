"""Differences between two formulas, marked in both, part by part, in the trees of their MathML."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import SequenceMatcher
from itertools import groupby
from xml.etree.ElementTree import Element, tostring

TAKEN, ADDED = "taken", "added"
"""The classes of what only the one formula has, and only the other."""
ROWS = ("mrow", "mtable", "mtr", "mtd")


def mark_differences(before: Element, after: Element) -> None:
    """Mark the parts of `before` that are not in `after` as taken, those of `after` not in `before` as added."""
    old, new = list(_in_line(before)), list(_in_line(after))
    matcher = SequenceMatcher(None, [text for _, text in old], [text for _, text in new], autojunk=False)
    for kind, i, j, k, m in matcher.get_opcodes():
        if kind == "equal":
            continue
        taken, added = [part for part, _ in old[i:j]], [part for part, _ in new[k:m]]
        if len(taken) == len(added) and all(map(_are_alike, taken, added)):
            for one, other in zip(taken, added, strict=True):
                mark_differences(one, other)
            continue
        _mark(taken, TAKEN)
        _mark(added, ADDED)
    _gather(before, TAKEN)
    _gather(after, ADDED)


def _in_line(element: Element) -> Iterator[tuple[Element, str]]:
    """The parts as they follow each other, each with how it is spelled; rows are only what is in them.

    The entry of a matrix comes before what is in it, so that one that is new can be told.
    """
    for part in element:
        if part.tag == "mtd":
            yield part, part.tag
        if part.tag in ROWS:
            yield from _in_line(part)
        else:
            yield part, tostring(part, encoding="unicode")


def _are_alike(one: Element, other: Element) -> bool:
    """Whether two parts are of one kind and have parts of their own that can be compared.

    A letter with an accent is one: a mark between the two would strike through both.
    """
    return one.tag == other.tag != "mover" and len(one) > 0 and len(one) == len(other)


def _gather(element: Element, name: str) -> None:
    """Marked parts that stand side by side become one, so that a mark is drawn around all of them."""
    for part in element:
        _gather(part, name)
    if element.tag not in ("mrow", "mtd", "math"):
        return
    gathered: list[Element] = []
    for is_marked, run in groupby(list(element), lambda part: part.get("class") == name):
        parts = list(run)
        gathered += [_together(parts, name)] if is_marked and len(parts) > 1 else parts
    element[:] = gathered


def _together(parts: list[Element], name: str) -> Element:
    """The parts as one; an operator at the edge keeps the room that it had."""
    row = Element("mrow", {"class": name})
    for part in parts:
        del part.attrib["class"]
        if part.tag == "mo" and part in (parts[0], parts[-1]) and "fence" not in part.attrib:
            part.set("form", "infix")
        row.append(part)
    return row


def _mark(elements: list[Element], name: str) -> None:
    for element in elements:
        element.set("class", name)
