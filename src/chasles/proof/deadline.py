"""How long may a decision take? A deadline that every long loop of the prover looks at.

Without one nothing is ever late: the book's statements are small.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from math import inf
from time import monotonic

from chasles.proof.rings import backend

__all__ = ["OutOfTime", "afford", "check", "remaining", "within"]

MANY = 1_000
"""Products of terms that take no time worth a thought."""
RATES = {"flint": 4e6, "sympy": 3e5}
"""Products of terms that a computer of this age forms in a second, at the least."""

_deadline: ContextVar[float] = ContextVar("deadline", default=inf)


class OutOfTime(Exception):
    """The time allowed for a decision is over."""


@contextmanager
def within(seconds: float) -> Iterator[None]:
    """Let everything inside take no more than a number of seconds, nor more than what surrounds it has left."""
    token = _deadline.set(min(_deadline.get(), monotonic() + seconds))
    try:
        yield
    finally:
        _deadline.reset(token)


def remaining() -> float:
    """The seconds that are left; infinite without a deadline."""
    return _deadline.get() - monotonic()


def check() -> None:
    """Raise `OutOfTime` if the deadline has passed."""
    if remaining() < 0:
        raise OutOfTime


def afford(products: int) -> None:
    """Raise `OutOfTime` if so many products of terms, which nothing can interrupt, take longer than what is left."""
    if products > MANY and products > max(RATES[backend()] * remaining(), 0):
        raise OutOfTime
