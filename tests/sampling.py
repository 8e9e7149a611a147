"""Sweeps over many inputs of a kind: a sample by their places, and all of them with CHASLES_TEST_WHOLE=1."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable, Sequence
from itertools import islice
from typing import TypeVar

import pytest

__all__ = ["WHOLE", "kept_and_left_out", "sample"]

T = TypeVar("T")
WHOLE = os.environ.get("CHASLES_TEST_WHOLE", "") not in ("", "0")
"""Whether nothing is left out."""


def sample(inputs: Iterable[T], every: int, first: int = 0) -> list[T]:
    """One input in `every`, from the place `first` on; all of them where the whole is asked for."""
    return list(inputs) if WHOLE else list(islice(inputs, first, None, every))


def kept_and_left_out(items: Sequence[pytest.Item]) -> tuple[list[pytest.Item], list[pytest.Item]]:
    """The cases of tests marked `sampled(every)`: each `every`-th of a test, the first among them, and the others."""
    kept: list[pytest.Item] = []
    left_out: list[pytest.Item] = []
    places: Counter[str] = Counter()
    for item in items:
        mark = item.get_closest_marker("sampled")
        test = item.nodeid.partition("[")[0]
        out = mark is not None and not WHOLE and places[test] % mark.args[0] != 0
        (left_out if out else kept).append(item)
        places[test] += 1
    return kept, left_out
