"""Displayed things: their HTML, LaTeX and text come from `chasles.report.notebook`, imported when first asked for.

Only what is known is displayed: nothing is decided, simplified or derived for it.
"""

from __future__ import annotations

from collections.abc import Container
from importlib import import_module
from types import ModuleType

_rooms: list[str] = []


def displayed_by(pages: str, theorems: str) -> None:
    """Name the modules whose functions say how a thing is displayed: `html`, `latex`, `text`; `as_theorem` for Coq."""
    _rooms[:] = [pages, theorems]


def theorems() -> ModuleType:
    """The module that tells Coq of verdicts."""
    return import_module(_rooms[1])


class Displayed:
    """What a notebook displays: as HTML, as LaTeX and in plain text."""

    __slots__ = ()

    def _repr_text_(self) -> str:
        return str(import_module(_rooms[0]).text(self))

    def _repr_html_(self) -> str:
        return str(import_module(_rooms[0]).html(self))

    def _repr_latex_(self) -> str:
        return str(import_module(_rooms[0]).latex(self))

    def _repr_mimebundle_(
        self, include: Container[str] | None = None, exclude: Container[str] | None = None
    ) -> dict[str, str]:
        made = {"text/plain": self._repr_text_, "text/html": self._repr_html_, "text/latex": self._repr_latex_}
        return {
            kind: make()
            for kind, make in made.items()
            if (not include or kind in include) and not (exclude and kind in exclude)
        }
