"""A formula that is too long for a line is broken before a sign or a factor, as browsers do not."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from xml.etree.ElementTree import Element, SubElement

MOST = 68
"""About how many letters and signs fit on a line."""
BESIDE = 8
"""How many fewer fit in a matrix, beside its brackets and what it is equal to."""
FEW = 16
"""A line has at least as many, so that a left side does not stand alone."""
WHOLE = 24
"""What is in brackets and no wider stays on one line."""
SIGNS = ("=", "\N{IDENTICAL TO}", "+", "\N{MINUS SIGN}")
SPACED = (*SIGNS, "\N{MIDDLE DOT}", "\N{DOT OPERATOR}", "\N{MULTIPLICATION SIGN}", "\N{INTEGRAL}")
SCRIPTS = ("msub", "msup", "msubsup")


@dataclass(frozen=True, slots=True)
class _Piece:
    """What stays together, and where it may begin a line: the better, the lower. By brackets, then by sign."""

    element: Element
    rank: tuple[int, int] | None


def in_lines(tree: Element, most: float = MOST) -> Element:
    """The formula, as a table with a row for each line if it is too long for one; the rest of it is as it was.

    Brackets come apart only where they must: a line begins before the outermost sign that fits, else before a factor.
    """
    if width_of(tree) <= most:
        return tree
    lines = list(_lines(list(_ranked(_pieces(tree, most))), most))
    if len(lines) == 1:
        return lines[0][0] if len(lines[0]) == 1 else _copy(Element("mrow"), *lines[0])
    table = Element("mtable", {"class": "lines"})
    for place, line in enumerate(lines):
        row = SubElement(SubElement(SubElement(table, "mtr"), "mtd"), "mrow")
        if place:
            SubElement(row, "mspace", width="2em")
            if line[0].text in SIGNS:
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
        case "mo" if element.text in SPACED:
            return 2
        case "mspace":
            return 0.3
        case _:
            return sum(map(width_of, element), start=float(len(element.text or "")))


def _pieces(element: Element, most: float, depth: int = 0) -> Iterator[tuple[Element, int]]:
    """The parts that stay together, each with how many brackets are around it."""
    inner = element[0] if element.tag in SCRIPTS else element
    if inner.tag == "mrow" and (not depth or width_of(inner) > WHOLE):
        parts = list(inner)
        if element is not inner:
            # The exponent of a bracket stays with the bracket that closes.
            parts[-1] = _copy(element, parts[-1], *element[1:])
        for part in parts:
            if element.get("class"):
                part.set("class", part.get("class", element.get("class", "")))
            yield from [(part, depth)] if _is_bracket(part) else _pieces(part, most, depth + 1)
    elif element.tag == "mtable":
        yield _narrowed(element, most - BESIDE), depth
    elif element.tag in ("mfrac", "msqrt"):
        yield _copy(element, *(in_lines(part, most) for part in _whole(element))), depth
    else:
        yield element, depth


def _whole(element: Element) -> Iterator[Element]:
    """What is in it, a row of several things as one."""
    several = len(element) > 1 and element.tag in ("msqrt", "mtd")
    yield from (_copy(Element("mrow"), *element),) if several else element


def _narrowed(matrix: Element, most: float) -> Element:
    """The matrix; its columns that take more than their share of the width have entries in lines."""
    columns = zip(*matrix, strict=True)
    widths = [max(width_of(entry) + 1 for entry in column) for column in columns]
    fair = most / len(widths)
    left = most - sum(width for width in widths if width <= fair)
    room = left / max(1, sum(width > fair for width in widths))
    rows = ([_copy(entry, *(in_lines(part, room) for part in _whole(entry))) for entry in row] for row in matrix)
    return _copy(matrix, *(_copy(row, *entries) for row, entries in zip(matrix, rows, strict=True)))


def _copy(of: Element, *parts: Element) -> Element:
    """An element of the same kind with these parts."""
    made = Element(of.tag, of.attrib)
    made.text = of.text
    made.extend(parts)
    return made


def _is_bracket(element: Element) -> bool:
    return element.get("form") in ("prefix", "postfix") and element.get("fence") is not None


def _ranked(pieces: Iterator[tuple[Element, int]]) -> Iterator[_Piece]:
    """The pieces, each with how good a line's beginning it is; before some there is none."""
    before: Element | None = None
    for element, depth in pieces:
        joined = before is None or _holds_on(before) or _is_held(element)
        sign = element.tag == "mo" and element.text in SIGNS
        yield _Piece(element, None if joined else (depth, 0 if sign else 1))
        before = element


def _holds_on(element: Element) -> bool:
    """Whether what follows stays on its line: an operator, a bracket that opens, the name of a function."""
    if element.tag in ("mtext", "mspace"):
        return True
    if element.tag == "mo":
        return element.get("form") != "postfix"
    return element.tag == "mi" and len(element.text or "") > 1


def _is_held(element: Element) -> bool:
    """Whether it stays on the line of what is before it: an operator other than a sign, a bracket that closes."""
    while element.tag in SCRIPTS:
        element = element[0]
    if element.tag == "mspace":
        return True
    return element.tag == "mo" and element.text not in SIGNS and element.get("form") != "prefix"


def _lines(pieces: list[_Piece], most: float) -> Iterator[list[Element]]:
    """The pieces line by line: each line ends at the best place at which it is full enough and not too full."""
    while pieces:
        width, end, best = 0.0, 0, None
        for place, piece in enumerate(pieces):
            if piece.rank is not None and min(FEW, most / 2) < width and (best is None or piece.rank <= best):
                end, best = place, piece.rank
            width += width_of(piece.element)
            if width > most and end:
                break
        else:
            end = len(pieces)
        yield [piece.element for piece in pieces[:end]]
        pieces = pieces[end:]
