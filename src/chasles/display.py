"""Displayed things: their HTML, LaTeX and text come from `chasles.report.notebook`, imported when first asked for.

Only what is known is displayed: nothing is decided, simplified or derived for it.
"""

from __future__ import annotations

from collections.abc import Container
from importlib import import_module
from sys import modules
from types import ModuleType

__all__ = ["Displayed", "theorems"]


def _pages() -> ModuleType:
    return import_module(modules[__package__].displayed_by[0])


def theorems() -> ModuleType:
    """The module that tells Coq of verdicts."""
    return import_module(modules[__package__].displayed_by[1])


class Displayed:
    """What a notebook displays: as HTML, as LaTeX and in plain text."""

    __slots__ = ()

    def _repr_text_(self) -> str:
        return str(_pages().text(self))

    def _repr_html_(self) -> str:
        return str(_pages().html(self))

    def _repr_latex_(self) -> str:
        return str(_pages().latex(self))

    def _repr_mimebundle_(
        self, include: Container[str] | None = None, exclude: Container[str] | None = None
    ) -> dict[str, str]:
        made = {"text/plain": self._repr_text_, "text/html": self._repr_html_, "text/latex": self._repr_latex_}
        return {
            kind: make()
            for kind, make in made.items()
            if (not include or kind in include) and not (exclude and kind in exclude)
        }
