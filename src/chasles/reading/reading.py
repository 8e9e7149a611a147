"""What is read of a printed equation: its parts in words, one way or several, or why it could not be read.

Which of several quantities does a letter mean? What equations nearby, that can be read in one way, take it for.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

from chasles.reading.printed import PrintedEquation
from chasles.vocabulary import Node, Symbol, symbols_of

Status = Literal["read", "ambiguous", "unread"]


@dataclass(frozen=True, slots=True)
class Part:
    r"""One relation between two expressions: `sign` is `=`, `\equiv`, `<`, `>`, `\leq`, `\geq` or `\neq`.

    `fault` says why the two do not fit together, where they do not; `line` is where the page has it.
    """

    left: Node
    sign: str
    right: Node
    fault: str = ""
    line: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True)
class Reading:
    """One way to read an equation: its parts in the order of print; a chain a = b = c is a = b and b = c.

    What the equation is said to hold for, as in "for phi != 0", is `given`.
    """

    parts: tuple[Part, ...]
    given: tuple[Part, ...] = ()

    @property
    def sides(self) -> tuple[Node, ...]:
        """The sides of its parts."""
        return tuple(side for part in self.parts for side in (part.left, part.right))


@dataclass(frozen=True, slots=True)
class ReadEquation:
    """A printed equation with every reading that fits, the usual one first; without one, `why` it is unread.

    `column` is the place of what could not be read, counted from 1 in the equation's LaTeX.
    """

    printed: PrintedEquation
    readings: tuple[Reading, ...] = ()
    why: str = ""
    column: int | None = None

    @property
    def status(self) -> Status:
        """Read in one way, in several, or in none."""
        return "unread" if not self.readings else "read" if len(self.readings) == 1 else "ambiguous"


def settled(read: Sequence[ReadEquation]) -> tuple[ReadEquation, ...]:
    """The equations with the readings first whose letters mean what they mean nearby; none is left out."""
    places: dict[Symbol, list[int]] = {}
    for place, equation in enumerate(read):
        if equation.status == "read":
            for symbol in _symbols(equation.readings[0]):
                places.setdefault(symbol, []).append(place)
    return tuple(
        replace(equation, readings=_chosen(equation.readings, place, places, len(read)))
        if equation.status == "ambiguous"
        else equation
        for place, equation in enumerate(read)
    )


def _symbols(reading: Reading) -> frozenset[Symbol]:
    return frozenset(symbol for side in reading.sides for symbol in symbols_of(side))


def _chosen(readings: tuple[Reading, ...], here: int, places: dict[Symbol, list[int]], far: int) -> tuple[Reading, ...]:
    symbols = [_symbols(reading) for reading in readings]
    shared = frozenset.intersection(*symbols)

    def distances(own: frozenset[Symbol]) -> list[int]:
        return [min((abs(here - place) for place in places.get(symbol, ())), default=far) for symbol in own - shared]

    return tuple(sorted(readings, key=lambda reading: sum(distances(_symbols(reading)))))
