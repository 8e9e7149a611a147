"""What is known before anything is decided: what the chapter brings along, and what earlier runs found.

What a chapter brings along is text that people can read; each stands by its question's hash, under what asked first.
Verdicts are kept from one run to the next in a file for this version of the engine, written whole or not at all.

CHASLES_CACHE names another folder; empty, it turns the cache off. Nothing in the file is believed: what comes from it
is checked again like everything else.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from contextlib import suppress
from importlib.resources import files
from pathlib import Path
from typing import Any

from chasles import cache
from chasles.decisions.memory import Memory
from chasles.decisions.session import Session
from chasles.statements import Chapter
from chasles.statements.chapter import bases
from chasles.statements.elsewhere import chapter_of
from chasles.statements.packages import generated_package

ENGINE = (
    *("vocabulary", "evaluation", "statements", "rewriting", "algebra", "verdict", "checker", "problems", "points"),
    *("motions", "prover", "from_sympy", "prove", "deciding", "repairs", "decisions", "deriving"),
)
"""The packages and modules on which a verdict depends."""
LIBRARIES = ("sympy", "python-flint")
MOST = 4096
"""Answers that are kept: some ten books of this size."""
ANSWERS = "ANSWERS.json"


def session_of(book: Chapter, anew: bool = False) -> Session:
    """A session that knows what the chapter brings and what earlier runs decided; nothing where all is `anew`."""
    if anew:
        return Session(book=book)
    packages = dict.fromkeys([*(chapter_of(basis) for entry in book for basis in bases(entry.statement)), book.package])
    answers = {key: answer for package in filter(None, packages) for key, answer in shipped(package).items()}
    return Session(book=book, memory=Memory(read_kept(_path()), answers))


def read_kept(path: Path | None) -> dict[str, Any]:
    """The tables that a file has; none where it cannot be read."""
    kept: Any = {}
    if path is not None:
        with suppress(OSError, ValueError):
            kept = json.loads(path.read_text(encoding="utf-8"))
    return kept if isinstance(kept, dict) else {}


def retained(memory: Memory) -> None:
    """Keep what was decided for the next run. A cache that cannot be written is none: nothing is said."""
    if memory.has_learned:
        write_kept(_path(), memory.as_data(MOST))


def write_kept(path: Path | None, tables: Mapping[str, Any]) -> None:
    """Keep tables in the file of this engine, in place of those of other engines."""
    if path is None:
        return
    with suppress(OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        cache.keep(path, json.dumps(tables, separators=(",", ":")).encode())
        for other in path.parent.glob(f"{path.stem.partition('-')[0]}-*.json"):
            if other != path:
                other.unlink()


def forget() -> None:
    """Remove what is kept."""
    path = _path()
    if path is not None:
        path.unlink(missing_ok=True)


def _path() -> Path | None:
    return path_of("verdicts", ENGINE)


def path_of(name: str, parts: tuple[str, ...]) -> Path | None:
    """The file of the engine that has these parts; None where nothing is to be kept."""
    folder = cache.folder()
    return None if folder is None else folder / f"{name}-{cache.engine(parts, LIBRARIES)[:16]}.json"


def shipped(package: str) -> dict[str, Any]:
    """The answers that a chapter's package brings, by question; none where it brings none that can be read."""
    try:
        text = files(generated_package(package)).joinpath(ANSWERS).read_text("utf-8")
        groups = json.loads(text)
        return {key: answer for answers in groups.values() for key, answer in answers.items()}
    except (ModuleNotFoundError, OSError, ValueError, AttributeError):
        return {}


def as_text(groups: Mapping[str, Mapping[str, Any]]) -> str:
    """The text of the file: the answers of each group, one on a line."""
    parts = []
    for asking, answers in groups.items():
        lines = ",\n".join(
            f"  {json.dumps(key)}: {json.dumps(answer, ensure_ascii=False)}" for key, answer in answers.items()
        )
        parts.append(f" {json.dumps(asking, ensure_ascii=False)}: {{\n{lines}\n }}")
    return "{\n" + ",\n".join(parts) + "\n}\n"
