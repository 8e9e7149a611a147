"""What would make this installation faster, said once and not each time."""

from __future__ import annotations

from contextlib import suppress
from importlib.util import find_spec

import click

from chasles import cache
from chasles.cli.quiet import is_quiet

_SAID = "said-fast"
"""The file in the cache that stands for having said it."""


def say_once_what_is_faster() -> None:
    """One line on standard error where python-flint is not installed; where nothing can be kept, nothing is said."""
    folder = cache.folder()
    if find_spec("flint") is not None or folder is None or is_quiet() or (folder / _SAID).exists():
        return
    with suppress(OSError):
        folder.mkdir(parents=True, exist_ok=True)
        (folder / _SAID).touch()
        click.echo(
            "hint: with python-flint, `pip install 'chasles[fast]'`, new proofs are found about three times as fast",
            err=True,
        )
