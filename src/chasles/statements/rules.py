"""Can the rules of a problem stand together? None may be said twice, lead back to itself, or move what is constant."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from chasles.statements.statement import Equation
from chasles.vocabulary import Node, Rate, Symbol, children, undotted, walk


def passed_on(rules: Sequence[Equation]) -> list[Equation]:
    """What is given for the rate of a quantity is given for the rate of the symbol that the quantity is."""
    table = dict(rules)
    passed: list[Equation] = []
    for left, right in rules:
        base, dots = behind(left, table)
        symbol = table.get(base)
        on = dots and isinstance(symbol, Symbol) and symbol.stands_for is None and not symbol.constant
        other = rated(symbol, dots) if on and symbol is not None and symbol not in table else left
        passed.append((left if other in {*table, *dict(passed)} else other, right))
    return passed


def behind(left: Node, rules: Mapping[Node, Node]) -> tuple[Node, int]:
    """The quantity of whose rate a rule speaks, of a lower rate if a rule says that too; and how often it is dotted."""
    base, dots = left, 0
    while isinstance(base, Rate) and (not dots or base not in rules):
        base, dots = base.of, dots + 1
    return base, dots


def rated(node: Node, dots: int) -> Node:
    """The rate of a quantity, of so many dots."""
    return rated(Rate(node), dots - 1) if dots else node


def refuse_circles(number: str, rules: Sequence[Equation], unknowns: Collection[Symbol]) -> None:
    """Raise TypeError if a symbol is said twice to be something, or a rule leads back to its own left side."""
    table: dict[Node, Node] = {}
    for left, right in rules:
        if table.setdefault(left, right) != right:
            raise TypeError(f"({number}) is given two statements that say what {left} is: name one of them")
    for left, right in table.items():
        _refuse_second_rule(number, left, right, unknowns)
    reads = {left: frozenset(_rules_read(right, table)) for left, right in table.items()}
    for start in table:
        reached: set[Node] = set()
        ahead = set(reads[start])
        while ahead:
            reached |= ahead
            ahead = {further for left in ahead for further in reads[left]} - reached
        if start in reached:
            raise TypeError(
                f"({number}) is given statements that say what {start} is by {start} itself: "
                "state one of them as a Condition"
            )


def fit_together(rules: Sequence[Equation]) -> bool:
    """Whether no symbol is said twice to be something, and none is said by itself."""
    try:
        refuse_circles("", rules, ())
    except TypeError:
        return False
    return True


def _refuse_second_rule(number: str, left: Node, right: Node, unknowns: Collection[Symbol]) -> None:
    """Raise TypeError if what a rule replaces is known otherwise too: by a condition, or as a constant."""
    base, _ = undotted(left)
    if base in unknowns:
        raise TypeError(f"({number}) is given what {left} is, and a condition on {base}: name one of them")
    varying = any(isinstance(part, Symbol) and not part.constant for part in walk(right))
    if isinstance(base, Symbol) and base.constant and varying:
        raise TypeError(f"({number}) is given that {left}, a constant, is {right}, which may vary")


def _rules_read(node: Node, table: Mapping[Node, Node]) -> Iterator[Node]:
    """The rules that are applied when the node is read, before any of them is followed."""
    if node in table:
        yield node
    elif isinstance(node, Symbol) and node.stands_for is not None:
        yield from _rules_read(node.stands_for, table)
    else:
        for part in children(node):
            yield from _rules_read(part, table)
