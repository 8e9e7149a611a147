"""What does an expression divide by?"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from chasles.statements.simpler_words import factors_of
from chasles.statements.statement import bare
from chasles.vocabulary import Node, Quotient, Symbol, children
from chasles.vocabulary.shorthand import opened


def divisors_of(node: Node, rules: Mapping[Node, Node], seen: dict[Node, None] | None = None) -> Iterator[Node]:
    """What an expression divides by once the rules are applied, factor by factor, inner divisors first."""
    seen = {} if seen is None else seen
    node = opened(bare(node))
    if node in seen:
        return
    seen[node] = None
    if node in rules:
        yield from divisors_of(rules[node], rules, seen)
    elif isinstance(node, Symbol) and node.stands_for is not None:
        yield from divisors_of(node.stands_for, rules, seen)
    else:
        for part in children(node):
            yield from divisors_of(part, rules, seen)
    if isinstance(node, Quotient):
        yield from factors_of(node.denominator)
