"""The hypotheses that are relevant to a problem, and how often each is differentiated."""

from __future__ import annotations

from collections.abc import Mapping

from chasles.problems.scanning import scan
from chasles.problems.variables import Variables
from chasles.statements import Hypothesis, Problem
from chasles.vocabulary import Contract, Node, Rate, Skew, Symbol, undotted

Rates = dict[Node, list[tuple[int, dict[Symbol, int]]]]
"""For each symbol, of which of its rates a rule speaks, and by which rates of which symbols."""
MOST = 8
"""Nothing is differentiated more often: what is not closed by then refutes nothing, as the checker sees to."""


def complete_subjects(problem: Problem, found: Variables) -> None:
    """Where an equation restricts a symbol that occurs, all the symbols of which it speaks occur."""
    rules = dict(problem.rules)
    spoken = {h: {s for node in h.subjects for s in free_symbols(node, rules)} for h in problem.hypotheses}
    for _ in problem.hypotheses:
        occurring = set(found.orders) | set(found.angles)
        for hypothesis, symbols in spoken.items():
            if hypothesis.equations and symbols & occurring and not symbols <= occurring:
                for node in hypothesis.subjects:
                    scan(found, node, 0, rules)


def relevant_hypotheses(problem: Problem, found: Variables) -> tuple[Hypothesis, ...]:
    """The hypotheses on symbols that occur freely, and on what these share a hypothesis with, rates included."""
    rules = dict(problem.rules)
    symbols = {
        hypothesis: {s for node in hypothesis.subjects for s in free_symbols(node, rules)}
        for hypothesis in problem.hypotheses
        if not (hypothesis.equations and any(subject in rules for subject in hypothesis.subjects))
    }
    rates: Rates = {}
    for left, right in rules.items():
        base, order = undotted(left)
        if order:
            rates.setdefault(base, []).append((order, _spoken_of(right, rules)))
    active: dict[Hypothesis, int] = {}
    changed = True
    while changed:
        occurring = set(found.orders) | set(found.angles)
        bear = {h: own for h, own in symbols.items() if not own or _bears_on(own, rates) & occurring}
        now = {h: _order(found, h, own, rates, rules) for h, own in bear.items()}
        changed = now != active
        active = now
        for hypothesis, order in active.items():
            for node in (*hypothesis.subjects, *hypothesis.nonvanishing):
                scan(found, node, order, rules)
    return tuple(h for h in problem.hypotheses if h in active)


def _bears_on(symbols: set[Symbol], rates: Rates) -> set[Symbol]:
    """The symbols on which an equation bears that restricts the given ones: those too that make up their rates."""
    while more := {s for symbol in symbols for _, told in rates.get(symbol, ()) for s in told} - symbols:
        symbols = symbols | more
    return symbols


def _order(
    found: Variables, hypothesis: Hypothesis, symbols: set[Symbol], rates: Rates, rules: Mapping[Node, Node]
) -> int:
    """Up to which rate the equations of a hypothesis say something of use, without a rate higher than any that occurs.

    What they say of higher ones may restrict lower ones; a counterexample stands only if the checker sees that it does
    not.
    """
    if not hypothesis.equations or hypothesis.kind == "given" or is_turned(hypothesis, rules):
        return 0
    reached = {symbol: _reached(found, symbol, rates, frozenset()) for symbol in symbols}
    stated = [each for node in hypothesis.subjects for each in _spoken_of(node, rules).items()]
    most = min(MOST, max((0, *(reached[symbol] - order for symbol, order in stated))))
    highest = max(found.orders.values(), default=0)
    return next((order for order in range(most) if _highest(hypothesis, order + 1, rules) > highest), most)


def _highest(hypothesis: Hypothesis, order: int, rules: Mapping[Node, Node]) -> int:
    """The highest rate of a symbol that the `order`-th rate of a hypothesis speaks of, once the rules are applied."""
    found = Variables()
    for node in hypothesis.subjects:
        scan(found, node, order, rules)
    return max(found.orders.values(), default=0)


def _reached(found: Variables, symbol: Symbol, rates: Rates, through: frozenset[Symbol]) -> int:
    """Up to which rate a symbol is asked for: by what occurs, by a rule for a rate, and by what that rule speaks of."""
    reached = found.reached.get(symbol, 0)
    for order, told in rates.get(symbol, ()):
        others = {other: dots for other, dots in told.items() if other not in through | {symbol}}
        further = (_reached(found, other, rates, through | {symbol}) - dots for other, dots in others.items())
        reached = max(reached, order + max(further, default=0))
    return reached


def is_turned(hypothesis: Hypothesis, rules: Mapping[Node, Node]) -> bool:
    """Whether the rates of a hypothesis follow: that of a rotation is said to be a skew-symmetric matrix times it."""
    if hypothesis.kind != "rotation" or hypothesis.free:
        return False
    match rules.get(Rate(hypothesis.subjects[0])):
        case Contract((Skew(), turned)):
            return turned == hypothesis.subjects[0]
    return False


def free_symbols(node: Node, rules: Mapping[Node, Node]) -> set[Symbol]:
    """The symbols that an expression speaks of, once the rules are applied."""
    return set(_spoken_of(node, rules))


def _spoken_of(node: Node, rules: Mapping[Node, Node]) -> dict[Symbol, int]:
    """The same, with the highest rate of each."""
    found = Variables()
    scan(found, node, 0, rules)
    return {symbol: found.reached.get(symbol, 0) for symbol in (*found.orders, *found.angles)}
