"""Where one expression occurs in another, also as consecutive factors of a product or as terms of a sum."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from chasles.rewriting.coefficients import added
from chasles.rewriting.product import chained
from chasles.vocabulary import Contract, Node, Sum, Symbol, rebuilt


def put_for(node: Node, pattern: Node, value: Node) -> Node:
    """The expression with `value` in every place of `pattern`; the same object if it does not occur."""
    if node == pattern:
        return value
    if isinstance(node, Symbol) and node.stands_for is not None:
        inner = put_for(node.stands_for, pattern, value)
        return node if inner == node.stands_for else inner
    parts = node.below
    changed = tuple(put_for(part, pattern, value) for part in parts)
    if changed != parts:
        node = chained(changed) if isinstance(node, Contract) else rebuilt(node, changed)
    match node, pattern:
        case Contract(factors), Contract(run):
            return chained(_with_run(factors, run, value))
        case Sum(terms), Sum(run):
            return _added(terms, run, value)
    return node


def occurs(pattern: Node, node: Node) -> bool:
    """Whether the expression occurs, abbreviations opened, in one piece or as a run of factors or terms."""
    assert pattern.measure is not None
    return put_for(node, pattern, Symbol(f"[{pattern}]", str(pattern), pattern.measure)) != node


def _with_run(factors: Sequence[Node], run: Sequence[Node], value: Node) -> Iterator[Node]:
    k = 0
    while k < len(factors):
        if tuple(factors[k : k + len(run)]) == tuple(run):
            yield value
            k += len(run)
        else:
            yield factors[k]
            k += 1


def _added(terms: Sequence[Node], run: Sequence[Node], value: Node) -> Node:
    rest = list(terms)
    for term in run:
        if term not in rest:
            return Sum(tuple(terms))
        rest.remove(term)
    return added([*rest, value])
