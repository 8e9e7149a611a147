"""Displayed things: their HTML, LaTeX and text come from `chasles.report.notebook`, imported when first asked for.

Only what is known is displayed: nothing is decided, simplified or derived for it.
"""

from __future__ import annotations

from collections.abc import Container
from importlib import import_module
from types import ModuleType

__all__ = ["Displayed", "displayed_by"]

_room: list[str] = []


def displayed_by(room: str) -> None:
    """Name the module whose functions `html`, `latex` and `text` say how a thing is displayed."""
    _room[:] = [room]


def _pages() -> ModuleType:
    return import_module(_room[0])


class Displayed:
    """What a notebook displays: as HTML, as LaTeX and in plain text."""

    __slots__ = ()

    def _repr_text_(self) -> str:
        made: str = _pages().text(self)
        return made

    def _repr_html_(self) -> str:
        made: str = _pages().html(self)
        return made

    def _repr_latex_(self) -> str:
        made: str = _pages().latex(self)
        return made

    def _repr_mimebundle_(
        self, include: Container[str] | None = None, exclude: Container[str] | None = None
    ) -> dict[str, str]:
        made = {"text/plain": self._repr_text_, "text/html": self._repr_html_, "text/latex": self._repr_latex_}
        return {
            kind: make()
            for kind, make in made.items()
            if (not include or kind in include) and not (exclude and kind in exclude)
        }
