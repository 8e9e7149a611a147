"""Is each statement declared in the section that its number belongs to?"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

from chasles.statements.chapter import Entry, Section, place_of
from chasles.statements.packages import DeclarationError


def in_own_sections(module: str, entries: Sequence[Entry]) -> Sequence[Entry]:
    """The entries; raises `DeclarationError` for a number that is among those of an earlier section of the module."""
    for entry in entries:
        if not entry.section.number:
            raise DeclarationError(f"{entry.place}{module}.{entry.name} is declared before any Section")
    numbered: dict[Section, list[tuple[list[int], Entry]]] = {}
    for entry in entries:
        kind, place, _ = place_of(entry.statement.number)
        if kind == 0:
            numbered.setdefault(entry.section, []).append(([digits for digits, _ in place], entry))
    for (earlier, before), (later, own) in combinations(numbered.items(), 2):
        places = [place for place, _ in before]
        strays = [entry for place, entry in own if min(places) <= place <= max(places)]
        rest = [place for place, entry in own if entry not in strays]
        if strays and len(rest) > len(strays) and min(rest) > max(places):
            stray = strays[0]
            raise DeclarationError(
                f"{stray.place}{module}.{stray.name} has the number ({stray.statement.number}), as in Section "
                f"{earlier.number}, and is declared in Section {later.number}: move it there"
                " or number it otherwise"
            )
    return entries
