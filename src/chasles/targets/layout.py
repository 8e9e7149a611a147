"""How is a list of things laid out in code? On one line where it fits, else one on each line."""

from __future__ import annotations

from collections.abc import Sequence

_LONGEST = 100


def listed(start: str, items: Sequence[str], end: str, closing_line: bool = False) -> tuple[str, ...]:
    """The lines of `start`, the items and `end`; with `closing_line` `end` has a line of its own, after a comma."""
    line = f"{start}{', '.join(items)}{end}"
    if len(line) <= _LONGEST and "\n" not in line:
        return (line,)
    *first, last = items
    if closing_line:
        return (start, *(f"    {item}," for item in items), end)
    return (start, *(f"    {item}," for item in first), f"    {last}{end}")
