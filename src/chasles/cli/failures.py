"""Error messages: one line on standard error, with a hint, and the exit status."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager

import click

FAILED = 1
"""Something did not pass its own check."""
BAD_INPUT = 2
"""The command, or what it was given to read, makes no sense."""


class Failure(Exception):
    """A message to the person: what was wrong, where, what was expected, what to do. `status` is the exit status."""

    def __init__(self, message: str, status: int = FAILED) -> None:
        super().__init__(message)
        self.status = status


@contextmanager
def failing(*errors: type[Exception], before: str = "", status: int = FAILED) -> Iterator[None]:
    """One of these errors within raises a Failure that says the same, with something before it."""
    try:
        yield
    except errors as error:
        raise Failure(f"{before}{error}", status) from error


def complain(messages: Iterable[str]) -> int:
    """Say each message on a line of standard error; the exit status that follows, 0 if there is nothing to say."""
    status = 0
    for message in messages:
        say(message)
        status = FAILED
    return status


def say(message: str) -> None:
    """Say something on one line of standard error."""
    click.echo(f"chasles: {' '.join(message.split())}", err=True)
