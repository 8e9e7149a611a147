"""The cache: one folder, which CHASLES_CACHE names; if that is empty, nothing is cached.

Nothing in it is needed: it can be removed at any time and is made again.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from uuid import uuid4


def folder() -> Path | None:
    """The folder of the cache, which need not exist; None where nothing is to be kept."""
    named = os.environ.get("CHASLES_CACHE")
    if named == "":
        return None
    if named is not None:
        return Path(named)
    from platformdirs import user_cache_path

    return user_cache_path("chasles", appauthor=False)


def keep(path: Path, content: bytes) -> None:
    """The file holds the content, or is as it was; a draft that ends in `.part` is left by who is killed. OSError."""
    draft = path.with_name(f"{uuid4().hex}.part")
    try:
        draft.write_bytes(content)
        draft.replace(path)
    finally:
        draft.unlink(missing_ok=True)


def used(path: Path) -> None:
    """Note that the file was of use just now."""
    with suppress(OSError):
        os.utime(path)


def trim(files: Iterable[Path], most: int) -> None:
    """Remove those that were of no use for longest, so that the rest hold at most so many bytes together.

    Others may remove them at the same time; of two processes that both do, each sees what the other left.
    """
    found = []
    for path in files:
        with suppress(OSError):
            status = path.stat()
            found.append((status.st_mtime_ns, path.name, path, status.st_size))
    total = 0
    for _, _, path, size in sorted(found, reverse=True):
        total += size
        if total > most:
            with suppress(OSError):
                path.unlink()
