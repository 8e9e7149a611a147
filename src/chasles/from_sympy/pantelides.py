"""How often each of several equations is to be differentiated until together they determine their highest rates.

Pantelides' algorithm (SIAM J. Sci. Stat. Comput. 9, 1988) in the terms of Pryce's signature method (BIT 41, 2001):
equation i is differentiated c_i times, function j then occurs with its d_j-th rate, and every equation can be assigned
a function of its own that occurs in it with that rate. An equation to which none can be assigned is left over.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

Orders = Mapping[Any, int]
MOST = 8
"""No equation is differentiated more often."""
MORE = 1
"""So much more often are equations differentiated that are more than the functions of which they speak."""


@dataclass(slots=True)
class Offsets:
    """`times` says how often each equation is differentiated, `highest` the rate with which each function occurs then.

    Every equation is differentiated until one of its functions occurs with that rate.
    """

    times: list[int] = field(default_factory=list)
    highest: dict[Any, int] = field(default_factory=dict)


def offsets(equations: Sequence[Orders]) -> Offsets:
    """The offsets of equations, of each of which is told how often it differentiates which functions."""
    times: dict[int, int] = {}
    # A differential equation goes before what it may make superfluous.
    ranked = sorted(range(len(equations)), key=lambda i: -max(equations[i].values()))
    for row in ranked:
        found = _assigned(equations, {**times, row: 0})
        times = found or times
    highest = _highest(equations, {**dict.fromkeys(ranked, 0), **times})
    if len(times) < len(equations):
        # What is left over may contradict the others, which is seen from some rates more of all of them.
        highest = {f: order + MORE for f, order in highest.items()}
    # It may also speak of higher rates than the others do: these are then differentiated as far.
    reached = [min(highest[f] - order for f, order in orders.items()) for orders in equations]
    return Offsets(reached, highest)


def _highest(equations: Sequence[Orders], times: Mapping[int, int]) -> dict[Any, int]:
    found: dict[Any, int] = {}
    for row, count in times.items():
        for f, order in equations[row].items():
            found[f] = max(found.get(f, 0), order + count)
    return found


def _assigned(equations: Sequence[Orders], times: dict[int, int]) -> dict[int, int] | None:
    """How often to differentiate so that every equation has a function of its own; None if none is found."""
    while True:
        highest = _highest(equations, times)
        edges = {row: [f for f, k in equations[row].items() if k + times[row] == highest[f]] for row in times}
        owner: dict[Any, int] = {}
        for row in times:
            visited: dict[int, None] = {}
            if not _augment(row, edges, owner, visited, set()):
                break
        else:
            return times
        for row in visited:
            times[row] += 1
        if max(times.values()) > MOST:
            return None


def _augment(
    row: int, edges: Mapping[int, Sequence[Any]], owner: dict[Any, int], visited: dict[int, None], seen: set[Any]
) -> bool:
    """Let an equation own a function, those of others being passed on; `visited` are the equations that were asked."""
    visited[row] = None
    for f in edges[row]:
        if f not in seen:
            seen.add(f)
            if f not in owner or _augment(owner[f], edges, owner, visited, seen):
                owner[f] = row
                return True
    return False
