"""What vanishes because of what is given: equations, their derivatives, and what follows for orthonormal frames."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import reduce
from itertools import combinations_with_replacement
from operator import add, sub
from typing import Any

from chasles.checker.expressions.algebra import primitive
from chasles.checker.expressions.asked import Asked, GivenEquation
from chasles.checker.expressions.complexes import differences
from chasles.checker.expressions.motion import time_of
from chasles.checker.expressions.rates import MOST_RATES
from chasles.checker.expressions.reading_of_proof import Proven
from chasles.checker.expressions.signs import is_nonnegative, is_positive
from chasles.checker.sparse import ONE, Polynomial, Rejected, cofactor, determinant, number, parsed, variable

LABEL = re.compile(r"(exp given|log given|given|frame|equal|zero|root|square) (\S+)(?: (\d+),(\d+))?(?: d(\d+))?")
MOVING = ("given", "frame", "square")
"""What may be differentiated."""
Frame = tuple[dict[tuple[int, int], Polynomial], set[str], bool]
"""What a frame satisfies, the equations that say that it is one, and whether they hold at all times."""


class Facts:
    """What vanishes, by label: "given 0 1,1" is the first entry of the first equation, with " d2" its second rate.

    "frame 0 1,2" is an entry of M M^T - 1 for the first frame M of the certificate, "frame 0 4,2" one of M less its
    cofactors; "equal 0" are two products of the same size, "zero x" is a quantity that SymPy takes to be zero, and
    "root x" is a power of a root less what it is the root of; "square 0 1,1" is squared in a sum of squares;
    "exp given 0 1,1" is the difference of the exponentials of both sides, and so is "log given 0 1,1".
    `used` are the texts of the equations that were asked for.
    """

    def __init__(self, asked: Asked, reading: Proven, certificate: Mapping[str, Any]) -> None:
        self.asked, self.reading, self.used = asked, reading, set[str]()
        self._certificate = certificate
        self._frames: dict[int, Frame] = {}
        self._known: dict[str, Polynomial] = {}

    def __getitem__(self, label: str) -> Polynomial:
        """What vanishes under a label; raises `Rejected` where nothing does."""
        if label not in self._known:
            self._known[label] = self.reading.cleared(self._stated(label))[0]
        return self._known[label]

    def _stated(self, label: str) -> Polynomial:
        if (found := LABEL.fullmatch(label)) is None:
            raise Rejected(f"{label!r} names nothing that is given")
        kind, name, rates = found[1], found[2], int(found[5] or 0)
        entry = int(found[3] or 0) - 1, int(found[4] or 0) - 1
        if (kind in ("zero", "root", "equal")) == bool(found[3]) or rates > MOST_RATES * (kind in MOVING):
            raise Rejected(f"{label!r} names nothing that is given")
        if kind in ("zero", "root"):
            return self._zero(name) if kind == "zero" else self.reading.functions.relation(self.reading.places[name])
        place = int(name)
        if kind == "equal":
            one, other = self._certificate["equal"][place]
            return self.reading.equal(*([parsed(text, self.reading.places) for text in side] for side in (one, other)))
        if kind in ("exp given", "log given"):
            return self._of_both(kind[:3], self.asked.given[place], entry)
        if kind == "given":
            item = self.asked.given[place]
            self.used.add(item.text)
            fact = differences(self.reading, item.pairs)[entry]
            moves = bool(item.functions)
        elif kind == "square":
            fact, moves = self._square(place, entry)
        else:
            entries, texts, moves = self._frame(place)
            fact = entries[entry]
            self.used |= texts
        if rates and not moves:
            raise Rejected(f"{label!r}: what is given is not about functions")
        for _ in range(rates):
            fact = self.reading.rate(fact, time_of(item for item in self.asked.given if item.functions))
        return fact

    def _of_both(self, function: str, item: GivenEquation, entry: tuple[int, int]) -> Polynomial:
        """What vanishes since both sides have equal exponentials, and logarithms if one is positive."""
        self.used.add(item.text)
        one, other = (self.reading.normal(self.reading(side)) for side in item.pairs[entry])
        if function == "exp":
            return self.reading.exp(one) - self.reading.exp(other)
        if not any(is_positive(self.reading, side) for side in (one, other)):
            raise Rejected("a logarithm is taken of a side that is not seen to be positive")
        return self.reading.log(one, evident=True) - self.reading.log(other, evident=True)

    def _square(self, place: int, entry: tuple[int, int]) -> tuple[Polynomial, bool]:
        """What vanishes since its square and others, with weights of at least zero, add up to multiples of facts."""
        of, said = (self._certificate["squares"][place][part] for part in ("of", "squares"))
        squares = [[parsed(text, self.reading.places) for text in pair] for pair in said]
        if any(k[:5] != "given" for k, _ in of) or not all(is_nonnegative(self.reading, pair[0]) for pair in squares):
            raise Rejected("a sum of squares is of nothing that is given, or has a weight that may be negative")
        given = (parsed(times, self.reading.places) * self[label] for label, times in of)
        total = reduce(add, (weight * base * base for weight, base in squares))
        if self.reading.normal(reduce(sub, given, total)):
            raise Rejected("what is given is not the sum of squares that it is said to be")
        weight, base = squares[entry[0]]
        moves = all(bool(self.asked.given[int(label.split()[1])].functions) for label, _ in of)
        return base if is_positive(self.reading, weight) else weight * base, moves

    def _zero(self, name: str) -> Polynomial:
        """What SymPy assumes to be zero."""
        place = self.reading.places[name]
        e = self.reading.atoms.get(place)
        if e is None or not e.is_zero:
            raise Rejected(f"{name} is not assumed to be zero")
        self.used.add(f"{e} is zero")
        return variable(place)

    def _frame(self, place: int) -> Frame:
        """What a square matrix with orthonormal columns satisfies besides, and the equations that say what it is."""
        if place not in self._frames:
            said = self._certificate["frames"][place]
            rows = [[variable(self.reading.places[name]) for name in row] for row in said["rows"]]
            size = len(rows)
            columns = [list(column) for column in zip(*rows, strict=True)]
            if any(len(row) != size for row in rows):
                raise Rejected("a frame is no square matrix")
            texts: set[str] = set()
            for i, j in combinations_with_replacement(range(size), 2):
                texts |= self._source(_dot(columns[i], columns[j]) - number(int(i == j)))
            entries = {(i, j): _dot(rows[i], rows[j]) - number(int(i == j)) for i in range(size) for j in range(size)}
            if said["proper"]:
                texts |= self._source(determinant(rows) - ONE)
                entries |= {(size + i, j): rows[i][j] - cofactor(rows, i, j) for i in range(size) for j in range(size)}
            moving = all(any(item.functions for item in self.asked.given if item.text == text) for text in texts)
            self._frames[place] = entries, texts, moving
        return self._frames[place]

    def _source(self, polynomial: Polynomial) -> set[str]:
        """The equation given that says that a polynomial vanishes."""
        wanted = primitive(self.reading.normal(polynomial))[1].terms
        for item in self.asked.given:
            for difference in differences(self.reading, item.pairs).values():
                if primitive(self.reading.cleared(difference)[0])[1].terms == wanted:
                    return {item.text}
        raise Rejected("what is said to be a frame is not given to be one")


def _dot(one: list[Polynomial], other: list[Polynomial]) -> Polynomial:
    return reduce(add, (a * b for a, b in zip(one, other, strict=True)))
