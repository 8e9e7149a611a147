"""Letters that a page has for one quantity only, where a notation declares several that look alike."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace as with_fields
from typing import Any

from chasles.reading.declared_letters import KINDS
from chasles.reading.letter_table import named_apart
from chasles.vocabulary import Node, Symbol, replace
from chasles.vocabulary.families import Family


def one_meaning_each(values: Iterable[Any]) -> list[Any]:
    """The values, with one symbol for all that are printed alike and are of the same kind, shape and dimension.

    What is left of symbols and entries with the same name has names of its own. Abbreviations stand for the same.
    """
    values = list(values)
    taken: dict[Node, Node] = {}
    first: dict[tuple[object, ...], Symbol] = {}
    named: dict[str, Symbol] = {}
    for symbol in (value for value in values if isinstance(value, Symbol) and value.stands_for is None):
        kind = next((kind for kind in KINDS if symbol.meaning.startswith(kind)), "")
        key = symbol.letter, symbol.size, symbol.constant, kind
        if key not in first:
            first[key] = named_apart(symbol, named, as_printed=False)
        taken[symbol] = first[key]
    for symbol in (value for value in values if isinstance(value, Symbol)):
        if symbol.stands_for is not None:
            taken[symbol] = with_fields(symbol, stands_for=replace(symbol.stands_for, taken))
    return [_changed(value, taken) for value in values]


def _changed(value: Any, taken: dict[Node, Node]) -> Any:
    if isinstance(value, Symbol):
        return taken[value]
    if isinstance(value, Family):
        one, two, three = (taken.get(member, member) for member in value.members)
        return with_fields(value, members=(one, two, three))
    return value
