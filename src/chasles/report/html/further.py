"""Sections of the page that other rooms have to give: worked exercises with pictures, measured errors and times.

A giver takes the chapter and yields sections; where it has nothing to show, it yields none and the page has no heading
for it. `FURTHER` lists the givers in the order in which their sections stand.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

from markupsafe import Markup

from chasles.statements import Chapter

__all__ = ["FURTHER", "Further", "further_sections"]


@dataclass(frozen=True, slots=True)
class Further:
    """A section: its place on the page, its heading, and the HTML below it, in which headings begin with h3."""

    place: str
    title: str
    body: Markup


Giver = Callable[[Chapter], Iterable[Further]]
FURTHER: tuple[Giver, ...] = ()


def further_sections(chapter: Chapter) -> Iterator[Further]:
    """What all givers have to show."""
    for giver in FURTHER:
        yield from giver(chapter)
