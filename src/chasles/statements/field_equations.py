"""What is given of fields: how they move, where conditions hold, and which leave free what is differentiated."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace as with_fields

from chasles import vocabulary as w
from chasles.statements.conditions import ASSUMED, UNFINISHED, assumed, degree
from chasles.statements.hypotheses import Hypothesis
from chasles.statements.problem import Goal, Problem
from chasles.statements.rules import fit_together
from chasles.statements.statement import Equation
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Node, Rate
from chasles.vocabulary.fields import Field, fields_of, rates_of_fields
from chasles.vocabulary.nabla import Convection, Nabla
from chasles.vocabulary.partial import PartialDerivative, differentiates, with_derivatives
from chasles.vocabulary.shorthand import Shorthand

MOST_RATES = 3
"""Rates of fields are said up to this order, and so are derivatives of what is given by several quantities."""
LINKS = 9
"""What is given is differentiated also where other equations link it to what is spoken of, over so many of these."""


def moving(sides: Sequence[Node], rules: Sequence[Equation]) -> Iterator[Equation]:
    """The rates of fields, where rates are taken, of which nothing else is given."""
    if not any(isinstance(part, Rate) for side in sides for part in opened_parts(side)):
        return
    known = dict(rules)
    depth = max(_orders(sides, known).values(), default=0)
    found = rates_of_fields((each for each in fields_of(sides) if each not in known), min(depth, MOST_RATES))
    yield from ((left, right) for left, right in found.items() if left not in known)


def _orders(nodes: Iterable[Node], rules: Mapping[Node, Node]) -> dict[Node, int]:
    """How often each field that occurs is differentiated, by what it depends on or in time."""
    found: dict[Node, int] = {}
    waiting = [(node, 0) for node in nodes]
    seen = {*waiting}
    while waiting:
        node, order = waiting.pop()
        if isinstance(node, Field) and node not in rules:
            root = node if node.root is None else node.root
            found[root] = max(found.get(root, 0), order + len(node.taken))
        inner = rules.get(node, getattr(node, "stands_for", None))
        below = (node.definition,) if isinstance(node, Shorthand) else node.below if inner is None else (inner,)
        order += isinstance(node, Rate | PartialDerivative) and inner is None
        new = {(part, order) for part in below} - seen
        seen |= new
        waiting += new
    return found


def carried_out(problem: Problem) -> Problem:
    """The same problem with all derivatives carried out, and those of what is assumed of fields."""
    rules = dict(problem.rules)

    def found(side: Node) -> Node:
        return with_derivatives(side, rules)

    told = problem.said_otherwise(found, lambda said: said.rewritten(found))
    return _substituted(with_fields(told, hypotheses=(*told.hypotheses, *_everywhere(told))))


def _substituted(problem: Problem) -> Problem:
    """The same problem with a rule for each derivative of a field that a field equation says alone on a side."""
    rules, hypotheses = [*problem.rules], list[Hypothesis]()
    for each in problem.hypotheses:
        rest = [*each.equations]
        for left, right in each.equations if each.kind == ASSUMED[1] else ():
            said = [*rules, (left, right)]
            if isinstance(left, Field) and left.taken and left not in dict(rules) and fit_together(said):
                rules = said
                rest.remove((left, right))
        subjects = tuple(w.Sum((left, w.Negative(right))) for left, right in rest)
        if each.kind != ASSUMED[1]:
            hypotheses.append(each)
        elif rest:
            hypotheses.append(with_fields(each, subjects=subjects, equations=tuple(rest)))
    return with_fields(problem, rules=tuple(rules), hypotheses=tuple(hypotheses))


def _everywhere(problem: Problem) -> Iterator[Hypothesis]:
    """What is assumed of fields alone, differentiated by what they depend on as often as they are elsewhere."""
    rules, said = dict(problem.rules), problem.sides
    defined = {left: right for left, right in rules.items() if not isinstance(left, Rate)}
    wanted = _orders(said, defined)
    reach = [*said, *(defined[part] for side in said for part in opened_parts(side) if part in defined)]
    places = dict.fromkeys(place for each in fields_of(reach) for place in each.taken)
    told = [hypothesis for hypothesis in problem.hypotheses if _is_of_fields(hypothesis, rules)]
    known = {each: _orders(each.sides, defined) for each in told}
    times = dict.fromkeys(told, 0)
    most = MOST_RATES if len(places) > 1 else LINKS
    for link in range(LINKS):
        asked = {each: max(0, *(wanted.get(root, 0) - order for root, order in known[each].items())) for each in told}
        times |= {each: min(asked[each], most) for each in told if not link or _links(each)}
        reached = [(root, order + times[each]) for each in told if times[each] for root, order in known[each].items()]
        wanted |= {root: max(wanted.get(root, 0), order) for root, order in reached}
    if asked != times:
        yield Hypothesis(UNFINISHED, tuple(said), free=True)
    for each in told:
        # That a matrix is its own cofactor matrix says no more of its derivatives than that it is orthogonal.
        pairs = [pair for pair in each.equations if not any(isinstance(side, w.Cofactor) for side in pair)]
        found: list[Equation] = []
        for _ in range(times[each]):
            slopes = [[PartialDerivative(side, place) for side in pair] for pair in pairs for place in places]
            pairs = [*dict.fromkeys((with_derivatives(a, rules), with_derivatives(b, rules)) for a, b in slopes)]
            found += pairs
        if found:
            kind = each.kind if each.kind in ASSUMED else "everywhere"
            yield Hypothesis(kind, sum(found, ()), tuple(found), (), each.latex, f"{each.text} everywhere", free=True)


def _links(hypothesis: Hypothesis) -> bool:
    """Whether it is said how far its derivatives go: it has none, is linear, or says what a derivative is."""
    fields, left = {*fields_of(hypothesis.sides)}, hypothesis.sides[0]
    explicit = hypothesis.kind not in ASSUMED or (isinstance(left, Field) and left.taken)
    return bool(explicit) or all(degree(side, fields, {}) < 2 for side in hypothesis.sides)


def _is_of_fields(hypothesis: Hypothesis, rules: Mapping[Node, Node]) -> bool:
    """Whether it is said of fields, wherever they are taken, and not of something that moves."""
    parts = {part for side in hypothesis.sides for part in opened_parts(side)}
    still = not any(isinstance(part, Rate) and part not in rules for part in parts)
    return hypothesis.kind != ASSUMED[0] and still and bool(fields_of(parts))


def freely_assumed(
    conditions: Sequence[Goal], unknowns: Iterable[w.Symbol], sides: Sequence[Node], rules: Mapping[Node, Node]
) -> tuple[Hypothesis, ...]:
    """Conditions as hypotheses; none where they tie what is differentiated or expanded, for no hypothesis says how.

    They do not tie it if they are of fields, nor if they say what higher rates are than those of which derivatives are
    taken: equations of motion restrict no position and no velocity.
    """
    if all(symbol.is_field for symbol in unknowns):
        return tuple(assumed(conditions, ASSUMED[1]))
    parts = [part for side in sides for part in opened_parts(side)]
    taken = [part.of for part in parts if isinstance(part, PartialDerivative | Nabla | Convection)]
    said = [side for goal in conditions for side in goal.sides]

    def highest(nodes: Iterable[Node], symbol: w.Symbol) -> int:
        return max((_rates_of(symbol, node, rules) for node in nodes), default=-1)

    bound = unknowns if any(map(differentiates, sides)) else ()
    tied = any(part.expands for part in parts) or any(highest(said, one) <= highest(taken, one) for one in bound)
    return () if tied else tuple(assumed(conditions))


def _rates_of(symbol: w.Symbol, node: Node, rules: Mapping[Node, Node]) -> int:
    """The highest rate of a symbol that occurs; -1 where none does."""
    inner = rules.get(node, getattr(node, "stands_for", None))
    parts = (inner,) if inner is not None else (*node.below, *getattr(node, "variables", ()))
    found = 0 if node == symbol else max((_rates_of(symbol, part, rules) for part in parts), default=-1)
    return found + 1 if found >= 0 and isinstance(node, w.Rate) and inner is None else found
