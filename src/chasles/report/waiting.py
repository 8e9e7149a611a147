"""A progress bar on standard error, drawn only in a terminal and only where it takes long."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from threading import Event, Thread
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
    wait = _Wait(total, doing)
    try:
        for thing in things:
            yield thing
            wait.done += 1
    finally:
        wait.end()


class _Wait:
    """A bar with a thread of its own, so that it moves and appears while a single thing takes long."""

    def __init__(self, total: int, doing: str) -> None:
        self.done = 0
        self._total, self._doing, self._over = total, doing, Event()
        self._thread = Thread(target=self._draw, daemon=True)
        self._thread.start()

    def end(self) -> None:
        """Wipe the bar."""
        self._over.set()
        self._thread.join()

    def _draw(self) -> None:
        if self._over.wait(PATIENCE):
            return
        from rich.progress import Progress

        from chasles.report.screen import console_on

        with Progress(console=console_on(sys.stderr, os.environ), transient=True) as bar:
            task = bar.add_task(self._doing, total=self._total)
            while not self._over.wait(0.1):
                bar.update(task, completed=self.done)
