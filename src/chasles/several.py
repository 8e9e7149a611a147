"""Several things displayed at once, one below the other."""

from __future__ import annotations

from typing import TypeVar

from chasles.display import Displayed

T_co = TypeVar("T_co", bound=Displayed, covariant=True)


class Several(tuple[T_co, ...], Displayed):
    """Things that are displayed one below the other, and printed so."""

    __slots__ = ()

    def __str__(self) -> str:
        return self._repr_text_()

    def _repr_text_(self) -> str:
        return "\n\n".join(each._repr_text_() for each in self)

    def _repr_html_(self) -> str:
        return "\n".join(each._repr_html_() for each in self)

    def _repr_latex_(self) -> str:
        return "\n\n".join(each._repr_latex_() for each in self)
