"""Interleaved rounds: every call in every round, so that what disturbs the machine disturbs all alike.

Times are the thread's own processor time, which leaves out what other processes take.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import repeat
from statistics import median
from time import thread_time

AT_LEAST = 2e-3
"""Seconds that a call is repeated for in a round."""
LONG = 0.2
"""A call of more seconds takes part in the first three rounds only."""


def seconds(call: Callable[[], object], loops: int) -> float:
    """The time of one call."""
    started = thread_time()
    for _ in repeat(None, loops):
        call()
    return (thread_time() - started) / loops


def interleaved(calls: dict[str, Callable[[], object]], rounds: int) -> dict[str, list[float]]:
    """The seconds of one call of each, round by round."""
    loops = {}
    for name, call in calls.items():
        call()
        loops[name] = max(1, round(AT_LEAST / max(seconds(call, 1), 1e-8)))
    times: dict[str, list[float]] = {name: [] for name in calls}
    long = set()
    for turn in range(rounds):
        for name, call in calls.items():
            if turn >= 3 and name in long:
                continue
            times[name].append(seconds(call, loops[name]))
            if times[name][-1] > LONG:
                long.add(name)
    return times


def ratio(one: list[float], other: list[float]) -> float:
    """The median, over the rounds, of one time by the other that both took part in."""
    return median(x / y for x, y in zip(one, other, strict=False))
