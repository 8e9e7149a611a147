"""What a piece of a formula may be: a word that fits, or a zero or an identity whose size its neighbours say."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

from chasles.vocabulary import Misfit, Node, Symbol, printed, symbols_of
from chasles.vocabulary.dimension import has_units
from chasles.vocabulary.measure import Extent, Measure

Shape = tuple[Extent, Extent]
MOST = 12
"""How many readings of one piece in one shape are kept."""
UNUSUAL = 4
"""The cost of a reading that counts only where no usual one fits."""
OF_ITS_OWN = "a quantity of its own"
"""The meaning of what print has a sign for that is no word: nothing is known of it, hence nothing refuted by it."""


def own_quantity(letter: str, measure: Measure, home: str, name: str = "") -> Symbol:
    """What is printed so, and of which nothing else is known."""
    return Symbol(name or letter, letter, measure, OF_ITS_OWN, home=home, has_units=has_units(home))


@dataclass(frozen=True, slots=True)
class Fit:
    """A reading of a piece; the lower its `cost`, the more usual it is.

    Where the size is not yet known, there is no node: `sized` makes one of a shape, or None; `usual` is the shape
    where nothing says it. `brackets` are those that the page has around it.
    """

    node: Node | None
    cost: int = 0
    brackets: str = ""
    sized: Callable[[Shape], Node | None] | None = None
    usual: Shape = (1, 1)

    @property
    def shape(self) -> Shape | None:
        """Its shape, where that is known and it is well formed."""
        return self.node.measure.shape if self.node is not None and self.node.measure is not None else None

    @property
    def sample(self) -> Node | None:
        """The word itself, or one of those that it may be."""
        shapes = () if self.sized is None else (self.usual, (3, 3), (3, 1), (1, 1))
        found = (self.sized(shape) for shape in shapes) if self.sized is not None else ()
        return self.node if self.node is not None else next((node for node in found if node is not None), None)

    def at(self, shape: Shape) -> Fit | None:
        """The same in a shape, or None where it has another."""
        if self.sized is None:
            return self if self.shape == shape else None
        node = self.sized(shape)
        return None if node is None else replace(self, node=node, sized=None)

    def sized_as(self, shape: Shape) -> Fit | None:
        """The same in a shape where its size is open; as it is where it is known."""
        return self if self.node is not None else self.at(shape)


def made(make: Callable[..., Node], *parts: Any, tolerant: bool = False) -> Node | None:
    """What is made of the parts, or None where they do not fit; if `tolerant`, with its fault."""
    try:
        node = printed(lambda: make(*parts)) if tolerant else make(*parts)
    except (Misfit, ValueError, TypeError):
        return None
    return node if tolerant or node.fault is None else None


def letters_agree(*nodes: Node) -> bool:
    """Whether no letter stands for two quantities."""
    letters: dict[str, Symbol] = {}
    return all(letters.setdefault(each.letter, each) == each for node in nodes for each in symbols_of(node))


def kept(fits: Iterable[Fit]) -> list[Fit]:
    """The distinct ones in which no letter stands for two quantities, the usual first, and not too many."""
    found: dict[object, Fit] = {}
    for fit in sorted(fits, key=lambda fit: fit.cost):
        sample = fit.sample
        if sample is not None and not letters_agree(sample):
            continue
        found.setdefault((fit.sized if sample is None else sample, fit.brackets, fit.node is None), fit)
    counts: dict[Shape | None, int] = {}
    chosen = []
    for fit in found.values():
        counts[fit.shape] = counts.get(fit.shape, 0) + 1
        if counts[fit.shape] <= MOST:
            chosen.append(fit)
    return chosen
