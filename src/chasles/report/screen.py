"""Where is the page shown? In a terminal with its width and colours, or plainly and unwrapped in a pipe or a file."""

from __future__ import annotations

import os
import sys
from typing import TextIO

from rich.console import Console, RenderableType

__all__ = ["NARROW", "Screen"]

NARROW = 64
"""Columns below which a table gives way to a list."""
_UNBROKEN = 10_000


class Screen:
    """A place to print pages on; `signs` says whether it can show more than ASCII."""

    def __init__(self, file: TextIO | None = None) -> None:
        self._file = file or sys.stdout
        chosen = os.environ.get("COLUMNS", "")
        self.console = Console(file=self._file, markup=False, highlight=False, emoji=False)
        if not self.console.is_terminal and not chosen.isdecimal():
            self.console.width = _UNBROKEN

    @property
    def is_terminal(self) -> bool:
        return self.console.is_terminal

    @property
    def narrow(self) -> bool:
        """Whether a table with several columns of text has no room."""
        return self.console.width < NARROW

    @property
    def signs(self) -> bool:
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
