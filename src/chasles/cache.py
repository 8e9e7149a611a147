"""The cache: one folder, which CHASLES_CACHE names; if that is empty, nothing is cached.

Nothing in it is needed: it can be removed at any time and is made again.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import lru_cache
from hashlib import sha256
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


def kept(room: str, name: str, make: Callable[[], bytes], most: int) -> bytes:
    """The content of that name in a folder of the cache, or else made and kept there; raises what `make` raises.

    The file has the hash of the content before it, and is made anew where it is not whole. Of its kind, files of so
    many bytes are kept together.
    """
    root = folder()
    if root is None:
        return make()
    path = root / room / name
    with suppress(OSError):
        whole = path.read_bytes()
        if _hash(whole[_DIGITS:]) == whole[:_DIGITS]:
            used(path)
            return whole[_DIGITS:]
    content = make()
    # A cache that cannot be written is none: nothing is said.
    with suppress(OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        keep(path, _hash(content) + content)
        trim(path.parent.glob(f"*{path.suffix}"), most)
    return content


def _hash(content: bytes) -> bytes:
    return sha256(content).hexdigest().encode()


_DIGITS = len(_hash(b""))


@lru_cache
def engine(parts: tuple[str, ...], libraries: tuple[str, ...]) -> str:
    """The hash of these packages and modules of chasles, and of the versions of libraries that they compute with."""
    from importlib.metadata import PackageNotFoundError, version

    found = sha256()
    root = Path(__file__).parent
    for name in parts:
        for source in sorted((root / name).rglob("*.py")) or [root / f"{name}.py"]:
            found.update(source.relative_to(root).as_posix().encode())
            found.update(source.read_bytes())
    for library in libraries:
        with suppress(PackageNotFoundError):
            found.update(f"{library} {version(library)}".encode())
    return found.hexdigest()


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
