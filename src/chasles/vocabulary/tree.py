"""Walking and rebuilding expressions: the one place that knows which fields of a node are nodes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace as with_fields
from itertools import islice
from typing import Any

from chasles.vocabulary.fitting import printed
from chasles.vocabulary.layout import Block, Rate
from chasles.vocabulary.letters import Symbol
from chasles.vocabulary.nodes import Node, node_fields


def children(node: Node) -> tuple[Node, ...]:
    """The nodes directly below, in reading order; an abbreviation has none."""
    return node.below


def rebuilt(node: Node, parts: tuple[Node, ...]) -> Node:
    """The same kind of node over other parts, measured anew; of one that does not fit, one that need not fit."""
    taken, changes = iter(parts), dict[str, Any]()
    if isinstance(node, Block):
        changes["rows"] = tuple(tuple(next(taken) for _ in row) for row in node.rows)
    for name in node_fields(type(node)):  # type: ignore[arg-type]
        held = getattr(node, name)
        changes[name] = tuple(islice(taken, len(held))) if isinstance(held, tuple) else next(taken)
    if node.fault:
        return printed(lambda: with_fields(node, **changes))  # type: ignore[type-var]
    return with_fields(node, **changes) if changes else node  # type: ignore[type-var]


def with_parts(node: Node, change: Callable[[Node], Node]) -> Node:
    """The node with each node directly below it changed; itself where none of them is."""
    changed = tuple(map(change, node.below))
    return node if changed == node.below else rebuilt(node, changed)


def with_inner(node: Node, change: Callable[[Node], Node]) -> Node:
    """The same, and an abbreviation as what it stands for, changed, where that is another expression."""
    if not isinstance(node, Symbol) or node.stands_for is None:
        return with_parts(node, change)
    inner = change(node.stands_for)
    return node if inner == node.stands_for else inner


def replace(node: Node, values: Mapping[Node, Node]) -> Node:
    """The expression with every occurrence of a key replaced by its value; nothing is simplified.

    What differs from element to element in an integral over a body, or in a sum over members, is not replaced there.
    """
    if node in values:
        return values[node]
    running = getattr(node, "running", ())
    if running:
        values = {key: value for key, value in values.items() if key not in running}
    return with_inner(node, lambda part: replace(part, values))


def undotted(node: Node) -> tuple[Node, int]:
    """What a rate is the rate of, and how many times over."""
    order = 0
    while isinstance(node, Rate):
        node, order = node.of, order + 1
    return node, order


def walk(node: Node) -> Iterator[Node]:
    """The node and all below it, in reading order; abbreviations are not opened."""
    waiting = [node]
    while waiting:
        node = waiting.pop()
        yield node
        waiting += node.below[::-1]


def symbols_of(node: Node) -> tuple[Symbol, ...]:
    """The symbols that occur, in the order of their first occurrence, abbreviations as themselves."""
    return tuple(dict.fromkeys(part for part in walk(node) if isinstance(part, Symbol)))
