"""A counterexample worked out by hand: the values that go into its entry, by the given statements."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction

from chasles.algebra.values import shown
from chasles.decisions.session import Decision
from chasles.points.evaluation import ratio_at
from chasles.problems.context import Context, build
from chasles.problems.divisors import UndeclaredDivisor
from chasles.problems.variables import Untreatable, entry_name
from chasles.prover.counterexample import transcendental_name
from chasles.report.entry_parts import EntryPart, parts_of_entry
from chasles.statements import Statement, problem_of
from chasles.verdict import Counterexample, Fails
from chasles.vocabulary import PI, Misfit, Node, Rate, Symbol


@dataclass(frozen=True, slots=True)
class ByHand:
    """The `values`, by name, of what goes into an entry and has a definition; for each side, what defines the rest."""

    values: dict[str, str] = field(default_factory=dict)
    left: tuple[Statement, ...] = ()
    right: tuple[Statement, ...] = ()


@dataclass(frozen=True, slots=True)
class Refutation:
    """A `form` of an equation that fails: what it says, the counterexample, and that worked out by hand."""

    form: str
    statement: Statement
    found: Counterexample
    by_hand: ByHand


def refutations(decision: Decision) -> Iterator[Refutation]:
    """Each form of an equation that fails: as printed, then as read or corrected."""
    statement, correction = decision.statement, decision.correction
    if not isinstance(statement, Statement):
        return
    forms = [("printed", statement, decision.verdict)]
    tried = () if correction is None else (*correction.others, correction)
    forms += [(each.form, statement.saying(*each.sides), each.verdict) for each in tried]
    for form, said, verdict in forms:
        if isinstance(verdict, Fails):
            found = verdict.counterexample
            yield Refutation(form, said, found, worked_out(said, decision, found))


def worked_out(statement: Statement, decision: Decision, found: Counterexample) -> ByHand:
    """What goes into the entry of the counterexample: vectors, single entries of matrices, and how to get the sides.

    There are no values where they depend on what the counterexample leaves open.
    """
    sides = statement.printed
    place = found.entry[0] - 1, found.entry[1] - 1
    values: dict[str, str] = {}
    definitions: list[tuple[Statement, ...]] = []
    try:
        if found.goal or any(place[0] >= side.shape[0] or place[1] >= side.shape[1] for side in sides):
            return ByHand()
        context = build(problem_of(statement, standing=decision.accepted))
        for side in sides:
            parts = [part for part in parts_of_entry(side, place) if part[0] in context.unfold.rules]
            rest: list[Symbol] = []
            for part in parts:
                known = {} if part[0] in map(_rated, sides) else dict(_entries(context, part, found))
                values |= known
                rest += [] if known else [part[0]]
            definitions.append(_definitions(statement, rest))
    except (Untreatable, UndeclaredDivisor, KeyError, Misfit):
        return ByHand()
    return ByHand(values, *definitions)


def _entries(context: Context, part: EntryPart, found: Counterexample) -> Iterator[tuple[str, str]]:
    """The entries of a scalar or a vector, or the one entry of a matrix that counts."""
    symbol, order, place = part
    is_matrix = symbol.shape[1] > 1
    if is_matrix and place is None:
        return
    node: Node = symbol
    for _ in range(order):
        node = Rate(node)
    for i, row in enumerate(context.unfold(node)):
        for j, ratio in enumerate(row):
            if not is_matrix or (i, j) == place:
                value = ratio_at(context, ratio, {PI.name: Fraction(1), **found.at})
                if value is not None:
                    yield entry_name(symbol, order, i, j), shown(value, transcendental_name(context))


def _rated(side: Node) -> Node:
    """What the side is, or is the rate of: its value is said anyway."""
    while isinstance(side, Rate):
        side = side.of
    return side


def _definitions(statement: Statement, symbols: Iterable[Symbol]) -> tuple[Statement, ...]:
    """What the statement is given on the symbols."""
    found = (each for symbol in symbols for each in statement.given if each.left == symbol)
    return tuple(dict.fromkeys(found))
