"""A progress bar on standard error, drawn only in a terminal and only where it takes long."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from threading import Timer
from typing import TypeVar

PATIENCE = 0.8
"""Seconds before the bar appears."""
_T = TypeVar("_T")
_silences: list[None] = []


@contextmanager
def silent() -> Iterator[None]:
    """No bar appears inside."""
    _silences.append(None)
    try:
        yield
    finally:
        _silences.pop()


def progress(things: Iterable[_T], total: int, doing: str) -> Iterator[_T]:
    """The things, one at a time, with a bar that says how many of the `total` are through."""
    if _silences or not sys.stderr.isatty():
        yield from things
        return
    from rich.progress import Progress

    from chasles.report.screen import console_on

    bar = Progress(console=console_on(sys.stderr, os.environ), transient=True)
    task = bar.add_task(doing, total=total)
    # It moves in a thread of its own, also while a single thing takes long.
    appears = Timer(PATIENCE, bar.start)
    appears.daemon = True
    appears.start()
    try:
        for thing in things:
            yield thing
            bar.advance(task)
    finally:
        appears.cancel()
        appears.join()
        bar.stop()
