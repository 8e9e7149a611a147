"""A limit on the work of a decision, counted so that no verdict depends on the machine or on its load.

The unit is one product of two terms of polynomials; what is no polynomial arithmetic counts as so many products as
take that long. The user may limit the seconds too. Without a limit any amount of work is allowed.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from math import inf
from time import monotonic

from chasles.algebra.rings import backend

MANY = 1_000
"""Products of terms that take no time worth a thought."""
RATES = {"flint": 4e6, "sympy": 3e5}
"""Products of terms that a computer of this age forms in a second, at the least."""
STEP = 100
"""What a step of a search, or the reading of a word, counts as, in products."""


class OutOfTime(Exception):
    """The work, or the time, that was allowed is over, or would be by what comes next; the message says which."""


@dataclass(slots=True)
class _Work:
    """What is done so far, in products; one for each outermost limit."""

    done: float = 0.0


@dataclass(frozen=True, slots=True)
class _Limit:
    """Nothing goes on once so much work is done, nor after the deadline."""

    work: _Work
    most: float
    deadline: float
    said: str
    said_of_time: str


_limit: ContextVar[_Limit | None] = ContextVar("limit", default=None)


@contextmanager
def within(products: float = inf, seconds: float = inf) -> Iterator[None]:
    """Let everything inside take no more work, and no more seconds, than this, nor than what surrounds it has left."""
    outer = _limit.get()
    work = outer.work if outer else _Work()
    most, deadline = work.done + products, monotonic() + seconds
    said, said_of_time = f"{products / 1e6:g} million products of terms were not enough", f"{seconds:g} seconds"
    if outer and outer.most <= most:
        most, said = outer.most, outer.said
    if outer and outer.deadline <= deadline:
        deadline, said_of_time = outer.deadline, outer.said_of_time
    token = _limit.set(_Limit(work, most, deadline, said, said_of_time))
    try:
        yield
    finally:
        _limit.reset(token)


def remaining() -> float:
    """The products that are left; infinite without a limit."""
    limit = _limit.get()
    return inf if limit is None else limit.most - limit.work.done


def spend(products: float) -> None:
    """Count work that is done; raise `OutOfTime` if a limit has been passed."""
    limit = _limit.get()
    if limit is None:
        return
    limit.work.done += products
    if limit.work.done > limit.most:
        raise OutOfTime(limit.said)
    if limit.deadline < inf and monotonic() > limit.deadline:
        raise OutOfTime(f"{limit.said_of_time} were not enough")


def check() -> None:
    """Count one step; raise `OutOfTime` if a limit has been passed."""
    spend(STEP)


def afford(products: float) -> None:
    """Raise `OutOfTime` if so many products of terms, which nothing can interrupt, are more than what is left."""
    limit = _limit.get()
    if limit is None or products <= MANY:
        return
    if products > limit.most - limit.work.done:
        raise OutOfTime(limit.said)
    if limit.deadline < inf and products > RATES[backend()] * (limit.deadline - monotonic()):
        raise OutOfTime(f"{limit.said_of_time} were not enough")
