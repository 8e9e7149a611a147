"""Do two expressions mean the same by their words alone? Found from exact values, without the prover.

A slip that leaves the meaning of the words as it was is no slip: two scalars in the other order, a transpose under a
trace, a sign turned under a square. The values are those at points where every letter is free, with nothing given and
nothing assumed; what follows from a definition or a hypothesis is not in the words.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import chain, islice
from random import Random

from chasles.points import sampling as points
from chasles.problems.context import build
from chasles.problems.divisors import UndeclaredDivisor
from chasles.problems.variables import Untreatable
from chasles.statements import Goal, Problem
from chasles.vocabulary import Integral, Node, Symbol, symbols_of, walk

from .exact_points import entries
from .exact_words import Broken, Words

__all__ = ["Meaning"]

POINTS = 4
ATTEMPTS = 40
ELEMENTS = 5
RATES = 3


@dataclass
class Meaning:
    """What the words of a problem mean: by themselves, with every letter free, and with all that is given."""

    free: tuple[Words, ...] = ()
    given: tuple[Words, ...] = ()
    _known: dict[Node, Hashable] = field(default_factory=dict)

    def of_words(self, node: Node) -> Hashable:
        """What an expression means: its values at all points, or its spelling where it has none.

        Two expressions mean the same if they have the same values whatever their letters are.
        """
        if node not in self._known:
            try:
                values = [words.value(node) for words in self.free]
            except Broken:
                values = []
            self._known[node] = tuple(tuple(map(tuple, value)) for value in values) or node
        return self._known[node]

    def is_symmetric(self, matrix: Node) -> bool:
        """Whether a square matrix is its own transpose by all that is given, so that it is no slip to transpose it."""
        try:
            found = [words.value(matrix) for words in self.given]
        except Broken:
            return False
        return bool(found) and all([list(row) for row in zip(*value, strict=True)] == value for value in found)

    @classmethod
    def of(cls, problem: Problem, letters: Iterable[Symbol] = ()) -> Meaning:
        """The meaning of the sides of a problem's goals, and of further letters that may be mistaken for theirs."""
        nodes = [side for goal in problem.goals for side in (goal.left, goal.right)]
        divisors = tuple(h for h in problem.hypotheses if h.nonvanishing)
        bare = Problem(tuple(Goal("", node, node) for node in nodes), hypotheses=divisors)
        spoken = dict.fromkeys(chain((symbol for node in nodes for symbol in symbols_of(node)), letters))
        free, draw, running = tuple(_words(bare)), Random(0), _running(nodes)
        for words in free:
            words.point.values |= _missing(words, spoken, draw)
            words.body = _body(running, draw) if running else []
        return cls(free, tuple(_words(problem)))


def _missing(words: Words, letters: Iterable[Symbol], draw: Random) -> dict[str, Fraction]:
    """Values for what a point leaves out: letters and rates that the sides speak of only after a slip."""
    names = [
        name
        for letter in letters
        if letter.stands_for is None
        for order in range(0 if not words.point.speaks_of(letter) else 1, 1 if letter.constant else RATES + 1)
        for name in entries(letter, order)
    ]
    return {name: Fraction(draw.randint(1, 9)) for name in names if name not in words.point.values}


def _running(nodes: Iterable[Node]) -> list[Symbol]:
    """What differs from element to element of a body, the densities among it."""
    integrals = [part for node in nodes for part in walk(node) if isinstance(part, Integral)]
    return sorted({symbol for integral in integrals for symbol in integral.running}, key=lambda symbol: symbol.name)


def _body(running: Iterable[Symbol], draw: Random) -> list[tuple[Fraction, dict[str, Fraction]]]:
    """Elements of any volume, with any values of what differs from element to element."""
    names = [name for symbol in running for name in entries(symbol)]
    return [
        (Fraction(draw.randint(1, 9)), {name: Fraction(draw.randint(-9, 9)) for name in names}) for _ in range(ELEMENTS)
    ]


def _words(problem: Problem) -> Iterator[Words]:
    """The words at a number of points that satisfy what the problem asks of them."""
    try:
        drawn = islice(points.sample(build(problem), {}, simple=False), ATTEMPTS)
    except (Untreatable, UndeclaredDivisor):
        return
    found = 0
    for point in drawn:
        try:
            words = Words(problem, point)
            words.require()
        except Broken:
            continue
        yield words
        found += 1
        if found == POINTS:
            return
