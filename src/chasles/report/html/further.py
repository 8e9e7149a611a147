"""Sections of the page that other rooms have to give, as the worked exercises with their pictures.

A giver takes the chapter and yields sections; where it has nothing to show, it yields none and the page has no heading
for it. `FURTHER` lists the givers in the order in which their sections stand.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from chasles.report.html.exercises import worked_exercises
from chasles.report.html.shown import Further
from chasles.statements import Chapter

__all__ = ["FURTHER", "Further", "further_sections"]

Giver = Callable[[Chapter], Iterable[Further]]
FURTHER: tuple[Giver, ...] = (worked_exercises,)


def further_sections(chapter: Chapter) -> Iterator[Further]:
    """What all givers have to show."""
    for giver in FURTHER:
        yield from giver(chapter)
