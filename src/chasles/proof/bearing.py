"""Which hypotheses bear on a problem, and up to which rate do they say something of use?"""

from __future__ import annotations

from collections.abc import Mapping

from chasles.proof.scanning import scan
from chasles.proof.variables import Variables
from chasles.statements import Hypothesis, Problem
from chasles.vocabulary import Contract, Node, Rate, Skew, Symbol, undotted

__all__ = ["bearing", "complete_subjects", "free_symbols", "is_turned"]


def complete_subjects(problem: Problem, found: Variables) -> None:
    """Where an equation restricts a symbol that occurs, all the symbols of which it speaks occur."""
    rules = dict(problem.rules)
    for _ in problem.hypotheses:
        occurring = set(found.orders) | set(found.angles)
        for hypothesis in problem.hypotheses:
            symbols = {s for node in hypothesis.subjects for s in free_symbols(node, rules)}
            if hypothesis.equations and symbols & occurring and not symbols <= occurring:
                for node in hypothesis.subjects:
                    scan(found, node, 0, rules)


def bearing(problem: Problem, found: Variables) -> tuple[Hypothesis, ...]:
    """The hypotheses on symbols that occur freely, and on what these share a hypothesis with, rates included."""
    rules = dict(problem.rules)
    symbols = {
        hypothesis: {s for node in hypothesis.subjects for s in free_symbols(node, rules)}
        for hypothesis in problem.hypotheses
        if not (hypothesis.equations and any(subject in rules for subject in hypothesis.subjects))
    }
    rates: dict[Node, set[Symbol]] = {}
    for left, right in rules.items():
        base, order = undotted(left)
        if order:
            rates[base] = rates.get(base, set()) | free_symbols(right, rules)
    active: dict[Hypothesis, int] = {}
    changed = True
    while changed:
        occurring = set(found.orders) | set(found.angles)
        now = {h: _order(found, h, own, rules) for h, own in symbols.items() if _bears_on(own, rates) & occurring}
        changed = now != active
        active = now
        for hypothesis, order in active.items():
            for node in (*hypothesis.subjects, *hypothesis.nonvanishing):
                scan(found, node, order, rules)
    return tuple(h for h in problem.hypotheses if h in active)


def _bears_on(symbols: set[Symbol], rates: Mapping[Node, set[Symbol]]) -> set[Symbol]:
    """The symbols on which an equation bears that restricts the given ones: those too that make up their rates."""
    return symbols.union(*(rates[symbol] for symbol in symbols & rates.keys()))


def _order(found: Variables, hypothesis: Hypothesis, symbols: set[Symbol], rules: Mapping[Node, Node]) -> int:
    """Up to which rate the equations of a hypothesis say something of use: a rule for a rate asks for it too."""
    if not hypothesis.equations or hypothesis.kind == "given" or is_turned(hypothesis, rules):
        return 0
    orders = [found.reached.get(symbol, 0) for symbol in symbols]
    orders += [order for node, order in map(undotted, rules) if node in symbols]
    return max(orders, default=0)


def is_turned(hypothesis: Hypothesis, rules: Mapping[Node, Node]) -> bool:
    """Whether the rates of a hypothesis follow: that of a rotation is said to be a skew-symmetric matrix times it."""
    match rules.get(Rate(hypothesis.subjects[0])):
        case Contract((Skew(), turned)):
            return hypothesis.kind == "rotation" and turned == hypothesis.subjects[0]
    return False


def free_symbols(node: Node, rules: Mapping[Node, Node]) -> set[Symbol]:
    """The symbols that an expression speaks of, once the rules are applied."""
    found = Variables()
    scan(found, node, 0, rules)
    return set(found.orders) | set(found.angles)
