"""A formula that is too long for a line is broken before a sign between its terms, as browsers do not."""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree.ElementTree import Element, SubElement

__all__ = ["in_lines", "width_of"]

MOST = 68
"""About how many letters and signs fit on a line."""
FEW = 16
"""A line has at least as many, so that a left side does not stand alone."""
SIGNS = ("=", "\N{IDENTICAL TO}", "+", "\N{MINUS SIGN}")


def in_lines(tree: Element) -> Element:
    """The formula, as a table with a row for each line if it is too long for one; the rest of it is as it was."""
    if width_of(tree) <= MOST or tree.tag != "mrow":
        return tree
    lines = list(_lines(tree))
    if len(lines) == 1:
        return tree
    table = Element("mtable", {"class": "lines"})
    for place, line in enumerate(lines):
        row = SubElement(SubElement(SubElement(table, "mtr"), "mtd"), "mrow")
        if place:
            SubElement(row, "mspace", width="2em")
            line[0].set("form", "infix")
        row.extend(line)
    return table


def width_of(element: Element) -> float:
    """About how many letters wide the element is."""
    match element.tag:
        case "mfrac":
            return max(map(width_of, element))
        case "mtable":
            rows = [[width_of(entry) + 1 for entry in row] for row in element]
            widest: list[float] = [max(column) for column in zip(*rows, strict=True)]
            return sum(widest)
        case "mover":
            return width_of(element[0])
        case "msub" | "msup" | "msubsup":
            return width_of(element[0]) + 0.7 * max(map(width_of, element[1:]))
        case "mo" if element.text in SIGNS:
            return 2
        case "mspace":
            return 0.3
        case _:
            return sum(map(width_of, element), start=float(len(element.text or "")))


def _lines(tree: Element) -> Iterator[list[Element]]:
    """The parts line by line: as many terms to a line as fit."""
    line: list[Element] = []
    for term in _terms(tree):
        before = sum(map(width_of, line))
        if before > FEW and before + sum(map(width_of, term)) > MOST:
            yield line
            line = []
        line.extend(term)
    yield line


def _terms(tree: Element) -> Iterator[list[Element]]:
    """The terms, each with the sign before it; a sign that follows another begins none."""
    term: list[Element] = []
    for part in tree:
        follows_a_sign = bool(term) and len(term) == 1 and term[0].text in SIGNS
        if part.tag == "mo" and part.text in SIGNS and term and not follows_a_sign:
            yield term
            term = []
        term.append(part)
    yield term
