"""Which name does a thing get, so that no two share one and none is a word of the language?"""

from __future__ import annotations

from collections.abc import Iterable


class Names:
    """The names of one function; a name once given is not given again."""

    def __init__(self, reserved: Iterable[str]) -> None:
        self._taken = set(reserved)
        self._counts: dict[str, int] = {}

    def take(self, wanted: str) -> str:
        """The name nearest to `wanted` that is free: underscores are appended until it is."""
        name = wanted
        while name in self._taken:
            name += "_"
        self._taken.add(name)
        return name

    def number(self, stem: str) -> str:
        """The first free name of `stem` followed by 1, 2, 3 and so on."""
        count = self._counts.get(stem, 0) + 1
        while f"{stem}{count}" in self._taken:
            count += 1
        self._counts[stem] = count
        return self.take(f"{stem}{count}")
