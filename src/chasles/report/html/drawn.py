"""Pictures are drawn once: each is kept by the hash of what it shows, of where it stands and of all that draws it."""

from __future__ import annotations

from collections.abc import Callable
from hashlib import sha256
from typing import Any

from markupsafe import Markup

from chasles import cache

ROOM, MOST = "pictures", 16 * 2**20
"""The folder in the cache, and how many bytes of pictures are kept: some hundred reports."""
DRAWING = ("exact", "exercises", "report")
"""The packages on which a picture depends."""


def drawn(shows: Any, place: str, draw: Callable[[], Markup]) -> Markup:
    """The picture of this that is kept, or the one that `draw` makes, which is kept for the next time."""
    said = repr(shows)
    if " at 0x" in said:  # it holds what cannot be told by its words
        return draw()
    key = sha256(f"{cache.engine(DRAWING, ('matplotlib',))} {place} {said}".encode()).hexdigest()
    return Markup(cache.kept(ROOM, f"{key}.svg", lambda: draw().encode(), MOST).decode())
