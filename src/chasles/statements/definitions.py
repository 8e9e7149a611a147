"""The definitions on which statements rest in turn: what is given brings what it is given itself."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from chasles.statements.goals import AcceptedSides
from chasles.statements.statement import Definition, Statement, bare
from chasles.vocabulary import Node


def definitions_behind(given: Sequence[Statement]) -> Iterator[Definition]:
    """The definitions given to what is given, and so on, the nearest first."""
    seen = dict.fromkeys(given)
    while given:
        given = tuple(dict.fromkeys(each for statement in given for each in statement.given if each not in seen))
        seen |= dict.fromkeys(given)
        yield from (each for each in given if isinstance(each, Definition))


def rules_behind(given: Sequence[Statement], accepted: AcceptedSides) -> Mapping[Node, Node]:
    """What letters are by these definitions, of several of one letter by the nearest."""
    found: dict[Node, Node] = {}
    for definition in definitions_behind(given):
        left, right = accepted(definition)
        found.setdefault(bare(left), right)
    return found
