"""Equations that are given, as data: their sides by name, what follows from them, and what is said of angles."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from chasles.from_sympy.real_zeros import SquaresGiven
from chasles.from_sympy.triads import Triad

Pair = tuple[Any, Any]


@dataclass(slots=True)
class Moving:
    """An equation between functions: how often it differentiates them, and is differentiated to determine rates."""

    orders: dict[Any, int]
    times: int = 0


@dataclass(slots=True)
class Equations:
    """Equations under one name, of which the `sources` are what the user gave.

    They are `derived` if they follow from these. A single one of scalars has the `label` that the checker gives it.
    """

    text: str
    pairs: list[Pair]
    sources: tuple[str, ...]
    triad: Triad | None = None
    derived: bool = False
    moving: list[Moving] = field(default_factory=list)
    label: str = ""

    @property
    def sides(self) -> list[Any]:
        """Both sides of all of them."""
        return [side for pair in self.pairs for side in pair]


@dataclass(slots=True)
class SideConditions:
    """The given equations, what they say of angles (used by substitution), and the triads among them.

    `stated` are the pairs of sides as they were given, `highest` the rates of functions that they determine.
    """

    equations: list[Equations] = field(default_factory=list)
    substitutions: list[tuple[str, Any, Any]] = field(default_factory=list)
    stated: list[Pair] = field(default_factory=list)
    squares: list[SquaresGiven] = field(default_factory=list)
    highest: Mapping[Any, int] = field(default_factory=dict)
