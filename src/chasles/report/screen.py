"""The screen that pages are shown on: a terminal with its width and colours, or a pipe or file, plain and unwrapped."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from typing import TextIO

from rich.console import Console, RenderableType
from rich.measure import Measurement

NARROW = 64
"""Columns below which a table gives way to a list."""
_UNBROKEN = 10_000


def console_on(file: TextIO, environ: Mapping[str, str], *, terminal: bool | None = None) -> Console:
    """A console with colours where the file is a terminal and nothing in the environment says otherwise.

    NO_COLOR that is not empty and CLICOLOR=0 turn them off; CLICOLOR_FORCE that is neither empty nor 0 turns them on,
    unless NO_COLOR is there, as FORCE_COLOR does. `terminal` settles it whatever the file and the environment say: a
    notebook's kernel sets both of those variables. Nothing but the file is written to, in a notebook neither.
    """
    forced = environ.get("CLICOLOR_FORCE", "0") not in ("", "0")
    plain = bool(environ.get("NO_COLOR")) or (environ.get("CLICOLOR") == "0" and not forced)
    return Console(
        file=file,
        markup=False,
        highlight=False,
        emoji=False,
        no_color=plain or None,
        force_terminal=True if forced and terminal is None else terminal,
        force_jupyter=False,
    )


class Screen:
    """A place to print pages on; `signs` says whether it can show more than ASCII, `terminal` whether it is one."""

    def __init__(self, file: TextIO | None = None, *, terminal: bool | None = None) -> None:
        self._file = file or sys.stdout
        chosen = os.environ.get("COLUMNS", "") if terminal is None else ""
        self.console = console_on(self._file, os.environ, terminal=terminal)
        if not self.console.is_terminal and not chosen.isdecimal():
            self.console.width = _UNBROKEN

    @property
    def is_terminal(self) -> bool:
        """Whether a person reads it at once, with colours and a width."""
        return self.console.is_terminal

    @property
    def narrow(self) -> bool:
        """Whether a table with several columns of text has no room."""
        return self.console.width < NARROW

    def has_room_for(self, page: RenderableType) -> bool:
        """Whether the page can be shown without anything being cut off."""
        unbounded = self.console.options.update_width(_UNBROKEN)
        return Measurement.get(self.console, unbounded, page).minimum <= self.console.width

    @property
    def signs(self) -> bool:
        """Whether it can show more than ASCII."""
        return self.console.encoding.lower().startswith("utf")

    def show(self, *pages: RenderableType) -> None:
        """Print the pages; what does not go to a terminal has no blanks at the ends of its lines."""
        if self.is_terminal:
            for page in pages:
                self.console.print(page)
            return
        with self.console.capture() as captured:
            for page in pages:
                self.console.print(page)
        self._file.write("\n".join(line.rstrip() for line in captured.get().split("\n")))
