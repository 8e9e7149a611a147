"""The quantities of which a page speaks: symbols, and their rates."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

from chasles.statements.statement import bare
from chasles.vocabulary import PI, Node, Rate, Symbol, undotted
from chasles.vocabulary.families import Member

Quantity = tuple[Symbol, int]
"""A symbol and how often it is dotted."""


def quantity(node: Node) -> Quantity | None:
    """The symbol, or rate of one, that a side is; None for anything else, for an abbreviation, and for pi."""
    base, order = undotted(bare(node))
    base = bare(base)
    return (base, order) if isinstance(base, Symbol) and base.stands_for is None and base != PI else None


@lru_cache(maxsize=4096)
def quantities(node: Node, order: int = 0) -> tuple[Quantity, ...]:
    """The symbols that occur and how often they are dotted, abbreviations opened, each once."""
    match node:
        case Symbol(stands_for=None):
            return ((node, order),)
        case Symbol(stands_for=Node() as meant):
            return quantities(meant, order)
        case Rate(of):
            return quantities(of, order + 1)
        case Member(family):
            below: Iterable[Node] = family.members
        case _:
            below = node.below
    return tuple(dict.fromkeys(found for part in below for found in quantities(part, order)))


def symbols_in(sides: Iterable[Node]) -> set[Symbol]:
    """The symbols that occur in any of the sides, abbreviations opened."""
    return {symbol for side in sides for symbol, _ in quantities(side)}
