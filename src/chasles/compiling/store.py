"""Where compiled expressions are kept: in the cache folder, by content, each file written whole or not at all.

An index named after all that goes into a compilation holds the hash of what came out, after which the shared object is
named. A file that does not have its hash is made anew: what is loaded is what was compiled. What was of no use for
longest goes when there is too much.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from contextlib import suppress
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory
from time import time

from chasles import cache

Make = Callable[[Path], Path]
"""Makes a shared object in a folder."""

ROOM, MOST = "compiled", 64 * 2**20
"""The folder in the cache, and how many bytes of shared objects are kept: a thousand expressions or so."""
_ABANDONED = 3600.0
"""Seconds after which nobody writes any more."""

_loaded: dict[str, ctypes.CDLL] = {}


def loaded(key: str, make: Make) -> ctypes.CDLL:
    """The shared object of this key, from this process, from the cache or else made. Raises what `make` raises."""
    library = _loaded.get(key)
    if library is None:
        library = _loaded[key] = _from_cache(key) or _made(key, make)
    return library


def kept(key: str, make: Callable[[], bytes], suffix: str = ".o") -> bytes:
    """The content of this key, from the cache or else made."""
    return cache.kept(ROOM, f"{key}{suffix}", make, MOST // 8)


def _from_cache(key: str) -> ctypes.CDLL | None:
    folder = _folder()
    if folder is None:
        return None
    with suppress(OSError, ValueError):
        digest = (folder / f"{key}.index").read_text(encoding="ascii")
        path = folder / f"{digest}.so"
        if sha256(path.read_bytes()).hexdigest() == digest:
            cache.used(path)
            return ctypes.CDLL(str(path))
    return None


def _made(key: str, make: Make) -> ctypes.CDLL:
    folder = _folder()
    with TemporaryDirectory(prefix="chasles-", ignore_cleanup_errors=True) as room:
        made = make(Path(room))
        if folder is not None:
            # A cache that cannot be written is none: nothing is said.
            with suppress(OSError):
                content = made.read_bytes()
                digest = sha256(content).hexdigest()
                folder.mkdir(parents=True, exist_ok=True)
                cache.keep(folder / f"{digest}.so", content)
                cache.keep(folder / f"{key}.index", digest.encode("ascii"))
                _sweep(folder)
                return ctypes.CDLL(str(folder / f"{digest}.so"))
        return ctypes.CDLL(str(made))


def _sweep(folder: Path) -> None:
    """Remove what is too much, and what was left by those who were killed while writing."""
    cache.trim(folder.glob("*.so"), MOST)
    for index in folder.glob("*.index"):
        with suppress(OSError, UnicodeDecodeError):
            if not (folder / f"{index.read_text(encoding='ascii')}.so").exists():
                index.unlink()
    for draft in folder.glob("*.part"):
        with suppress(OSError):
            if time() - draft.stat().st_mtime > _ABANDONED:
                draft.unlink()


def _folder() -> Path | None:
    root = cache.folder()
    return None if root is None else root / ROOM
