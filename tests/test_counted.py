"""What is bounded by a number of calls ends there, and what is not does not notice."""

from __future__ import annotations

import sys
from collections.abc import Callable

import pytest

from .counted import TooManyCalls, at_most


def called(times: float) -> None:
    """Calls a function so many times."""
    count = 0
    while count < times:
        count = following(count)


def following(count: int) -> int:
    return count + 1


def bounded(work: Callable[[], None], calls: int) -> None:
    with at_most(calls):
        work()


def test_what_has_no_end_is_ended() -> None:
    with pytest.raises(TooManyCalls, match="more than 1000 calls, the last of following"):
        bounded(lambda: called(float("inf")), 1000)


def test_each_call_counts_and_what_watched_before_watches_again() -> None:
    before = sys.gettrace()
    bounded(lambda: called(90), 100)
    with pytest.raises(TooManyCalls):
        bounded(lambda: called(101), 100)
    assert sys.gettrace() is before
