"""Which of several quantities does a letter mean? What equations nearby, that can be read in one way, take it for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from chasles.reading.reading import ReadEquation, Reading
from chasles.vocabulary import Symbol, symbols_of


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
    return frozenset(
        symbol for part in reading.parts for side in (part.left, part.right) for symbol in symbols_of(side)
    )


def _chosen(readings: tuple[Reading, ...], here: int, places: dict[Symbol, list[int]], far: int) -> tuple[Reading, ...]:
    symbols = [_symbols(reading) for reading in readings]
    shared = frozenset.intersection(*symbols)

    def distances(own: frozenset[Symbol]) -> list[int]:
        return [min((abs(here - place) for place in places.get(symbol, ())), default=far) for symbol in own - shared]

    return tuple(sorted(readings, key=lambda reading: sum(distances(_symbols(reading)))))
