"""Pictures are drawn once: each is kept by the hash of what it shows, of where it stands and of all that draws it."""

from __future__ import annotations

import functools
from collections.abc import Callable
from contextlib import suppress
from hashlib import sha256
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from markupsafe import Markup

from chasles import cache

MOST = 16 * 2**20
"""Bytes of pictures that are kept: some hundred reports."""
DRAWING = ("exact", "exercises", "report")
"""The packages on which a picture depends."""


def drawn(shows: Any, place: str, draw: Callable[[], Markup]) -> Markup:
    """The picture of this that is kept, or the one that `draw` makes, which is kept for the next time."""
    path = _path(repr(shows), place)
    if path is None:
        return draw()
    with suppress(OSError, ValueError):
        digest, text = path.read_text("utf-8").split("\n", 1)
        if digest == _hash(text):
            cache.used(path)
            return Markup(text)
    made = draw()
    # A cache that cannot be written is none: nothing is said.
    with suppress(OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        cache.keep(path, f"{_hash(made)}\n{made}".encode())
        cache.trim(path.parent.glob("*.svg"), MOST)
    return made


def are_kept() -> bool:
    """Whether any picture is."""
    root = cache.folder()
    return root is not None and any((root / "pictures").glob("*.svg"))


def _path(said: str, place: str) -> Path | None:
    """Where the picture is kept; None where nothing is, or where it holds what cannot be told by its words."""
    root = cache.folder()
    if root is None or " at 0x" in said or not _engine():
        return None
    return root / "pictures" / f"{_hash(f'{_engine()} {place} {said}')}.svg"


def _hash(text: str) -> str:
    return sha256(text.encode()).hexdigest()


@functools.cache
def _engine() -> str:
    """The hash of the sources and the version of matplotlib; empty where that is missing."""
    root = Path(__file__).parents[2]
    found = sha256()
    try:
        found.update(version("matplotlib").encode())
    except PackageNotFoundError:
        return ""
    for package in DRAWING:
        for source in sorted((root / package).rglob("*.py")):
            found.update(source.relative_to(root).as_posix().encode())
            found.update(source.read_bytes())
    return found.hexdigest()
