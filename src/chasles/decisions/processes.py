"""Many independent pieces of work, spread over processes where that is faster than one after the other.

A process is forked, so that it knows all that this one does and is there at once; where that is not safe or not
possible, or there is one processor only, the work is done here.
"""

from __future__ import annotations

import multiprocessing
import os
import sys
import threading
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from chasles.algebra.rings import backend

if TYPE_CHECKING:
    from concurrent.futures import ProcessPoolExecutor

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
    backend()  # what is imported here is not imported in each process
    _work.append((work, pieces))
    try:
        found = _over_processes(len(pieces), workers)
    finally:
        _work.clear()
    return [work(piece) for piece in pieces] if found is None else found


def _over_processes(count: int, workers: int) -> list[Any] | None:
    """What processes make of the pieces; None where there can be none, or one of them was killed."""
    pool = _pool(workers)
    if pool is None:
        return None
    from concurrent.futures.process import BrokenProcessPool

    others = set(multiprocessing.active_children())
    with pool:
        try:
            found = pool.map(_worked, range(count), chunksize=max(1, count // (workers * CHUNKS)))
        except OSError:
            # Some may have been forked before the system allowed no more, and would wait for ever.
            for forked in set(multiprocessing.active_children()) - others:
                forked.terminate()
            return None
        try:
            return list(found)
        except BrokenProcessPool:
            return None


def _pool(workers: int) -> ProcessPoolExecutor | None:
    """Processes that can be given work; None where they cannot be forked, or have no semaphores to share."""
    try:
        from concurrent.futures import ProcessPoolExecutor

        return ProcessPoolExecutor(workers, multiprocessing.get_context("fork"))
    except (ImportError, NotImplementedError, OSError, ValueError):
        return None


def _worked(place: int) -> Any:
    work, pieces = _work[0]
    return work(pieces[place])
