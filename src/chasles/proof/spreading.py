"""Many independent pieces of work, spread over processes where that is faster than one after the other.

A process is forked, so that it knows all that this one does and is there at once; where that is not safe, or there is
one processor only, the work is done here.
"""

from __future__ import annotations

import multiprocessing
import os
import sys
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from typing import Any, TypeVar

__all__ = ["processors", "spread"]

_T = TypeVar("_T")
_R = TypeVar("_R")
WORTH = 0.15
"""Seconds of work that are worth a process: to fork it, and to send what it found, takes some 30 ms."""
CHUNKS = 16
"""So many chunks of work for each process: few enough to send, and enough that none is left with the last long one."""
_work: list[tuple[Callable[[Any], Any], Sequence[Any]]] = []
"""What the forked processes do; the arguments need not be sent to them."""


def processors() -> int:
    """How many processes this one may use; CHASLES_PROCESSES limits it."""
    available = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    asked = os.environ.get("CHASLES_PROCESSES", "")
    return min(available, int(asked)) if asked.isdecimal() and int(asked) else available


def spread(work: Callable[[_T], _R], pieces: Sequence[_T], seconds: float) -> list[_R]:
    """The work on each piece, in order; `seconds` is about what one takes. Raises what the work raises.

    Results travel between processes, pieces do not.
    """
    workers = min(processors(), len(pieces), int(len(pieces) * seconds / WORTH))
    if workers < 2 or not sys.platform.startswith("linux") or threading.active_count() > 1 or _work:
        return [work(piece) for piece in pieces]
    _work.append((work, pieces))
    try:
        with ProcessPoolExecutor(workers, multiprocessing.get_context("fork")) as pool:
            chunk = max(1, len(pieces) // (workers * CHUNKS))
            return list(pool.map(_worked, range(len(pieces)), chunksize=chunk))
    finally:
        _work.clear()


def _worked(place: int) -> Any:
    work, pieces = _work[0]
    return work(pieces[place])
