"""Dependencies as a drawing: a band for each section, a box for each number, a line from each number it rests on."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from chasles.report.details import number_in_words
from chasles.report.html.citing import Book
from chasles.report.html.shown import NumberShown

ACROSS = 18
"""Boxes in a row."""
WIDTH, HEIGHT = 44, 18
STEP_X, STEP_Y = 50, 52
LEFT, TOP, BAND = 12, 12, 26
"""The margin, and the height of a section's heading, in units of the drawing."""
Section = tuple[str, Sequence[NumberShown]]


@dataclass(frozen=True, slots=True)
class Box:
    """A number: its place on the page and in the drawing, its verdict, and SVG paths to what it rests on."""

    to: str
    label: str
    title: str
    verdict: str
    x: int
    y: int
    lines: tuple[str, ...]

    @property
    def middle(self) -> int:
        """The centre of the box, from the left."""
        return self.x + WIDTH // 2

    @property
    def baseline(self) -> int:
        """The baseline of the label, from the top."""
        return self.y + 13


def graph_of(book: Book, sections: Sequence[Section]) -> dict[str, Any]:
    """The drawing of all numbers, section by section, each below the heading of its section.

    Its sizes, the headings with how far down each stands, the boxes, how many lines, and on what most rests.
    """
    places, bands, height = _placed(sections)
    bases = _bases(book)
    boxes = []
    for _, numbers in sections:
        for number in numbers:
            name = number.cited.strip("()")
            lines = tuple(_curve(places[basis], places[name]) for basis in bases.get(name, ()) if basis in places)
            x, y = places[name]
            short = name.removeprefix("text ").replace("Thm ", "T").replace("Cor ", "C")
            title = f"{number.cited} {number.badge.word}. {number.parts[0].says}"
            boxes.append(Box(f"#{number.place}", short, title, number.badge.name, x, y, lines))
    return {
        "width": 2 * LEFT + ACROSS * STEP_X - (STEP_X - WIDTH),
        "height": height,
        "box_width": WIDTH,
        "box_height": HEIGHT,
        "bands": bands,
        "boxes": boxes,
        "links": sum(len(box.lines) for box in boxes),
        "most_used": _most_used(bases),
    }


def _placed(sections: Sequence[Section]) -> tuple[dict[str, tuple[int, int]], list[tuple[str, int]], int]:
    """Where each number and each heading stands, and how high it all is."""
    places: dict[str, tuple[int, int]] = {}
    bands = []
    y = TOP
    for heading, numbers in sections:
        bands.append((heading, y + 12))
        y += BAND
        for k, number in enumerate(numbers):
            place = (LEFT + k % ACROSS * STEP_X, y + k // ACROSS * STEP_Y)
            places.setdefault(number.cited.strip("()"), place)
        y += (len(numbers) + ACROSS - 1) // ACROSS * STEP_Y
    return places, bands, y


def _bases(book: Book) -> dict[str, tuple[str, ...]]:
    """For each number, the other numbers on which its statements rest."""
    found: dict[str, dict[str, None]] = {}
    for entry in book.chapter:
        mine = found.setdefault(entry.number, {})
        mine |= {basis.number: None for basis in Book.bases(entry) if basis.number != entry.number}
    return {number: tuple(bases) for number, bases in found.items()}


def _curve(basis: tuple[int, int], resting: tuple[int, int]) -> str:
    """From the lower edge of the basis to the upper edge of what rests on it; within a row, an arc below both."""
    (x0, y0), (x1, y1) = basis, resting
    x0, x1 = x0 + WIDTH // 2, x1 + WIDTH // 2
    start = y0 + HEIGHT
    if y1 == y0:
        sag = start + min(26, 8 + abs(x1 - x0) // 12)
        return f"M{x0} {start}C{x0} {sag} {x1} {sag} {x1} {start}"
    if y1 < y0:
        start, y1 = y0, y1 + HEIGHT
    middle = (start + y1) // 2
    return f"M{x0} {start}C{x0} {middle} {x1} {middle} {x1} {y1}"


def _most_used(bases: dict[str, tuple[str, ...]]) -> str:
    """The five numbers on which most others rest, with how many."""
    counts = Counter(basis for mine in bases.values() for basis in mine)
    most = sorted(counts, key=lambda number: (-counts[number], number))[:5]
    return ", ".join(f"{number_in_words(number)} ({counts[number]})" for number in most)
