"""What is known of pages before they are read again: verdicts, and what may follow from what.

It is kept from one run to the next. Of what comes from another time a verdict is checked again; what may follow is a
conjecture, and what was not decided stays open.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from chasles.decisions.memory import Memory
from chasles.decisions.recalled import ENGINE, path_of, read_kept, write_kept

PARTS = (*ENGINE, "pages")
MOST = 4096
"""Answers of each kind that are kept: those of some ten pages."""


@dataclass
class KnownAnswers:
    """The verdicts in a `memory`, and by a key what `may_follow`."""

    memory: Memory = field(default_factory=Memory)
    may_follow: dict[str, bool | None] = field(default_factory=dict)
    _kept: int = 0

    @property
    def has_learned(self) -> bool:
        """Whether there is more than what was kept before."""
        return self.memory.has_learned or len(self.may_follow) + len(self.memory.reasons) > self._kept


def recalled() -> KnownAnswers:
    """What earlier runs of this engine found out; nothing where nothing can be read."""
    kept = read_kept(path_of("pages", PARTS))
    known = KnownAnswers(Memory(_table(kept, "verdicts")))
    known.memory.reasons = {key: why for key, why in _table(kept, "reasons").items() if isinstance(why, str)}
    known.may_follow = {k: told for k, told in _table(kept, "may_follow").items() if told is None or told is bool(told)}
    known._kept = len(known.may_follow) + len(known.memory.reasons)
    return known


def retained(known: KnownAnswers) -> None:
    """Keep what was found out for the next run, the latest of it where there is too much; no file is written anew."""
    if not known.has_learned:
        return
    tables: dict[str, dict[str, Any]] = {"reasons": {**known.memory.reasons}, "may_follow": {**known.may_follow}}
    latest = {name: dict(list(table.items())[-MOST:]) for name, table in tables.items()}
    write_kept(path_of("pages", PARTS), {"verdicts": known.memory.as_data(MOST), **latest})


def _table(kept: Mapping[str, Any], name: str) -> dict[str, Any]:
    table = kept.get(name)
    return table if isinstance(table, dict) else {}
