"""A counterexample worked out by hand: the values that go into its entry, by the given statements."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import accumulate

from chasles import vocabulary as w
from chasles.algebra.values import shown
from chasles.decisions.session import Decision
from chasles.points.evaluation import ratio_at
from chasles.problems.context import Context, build
from chasles.problems.divisors import UndeclaredDivisor
from chasles.problems.variables import Untreatable, entry_name
from chasles.prover.counterexample import transcendental_name
from chasles.statements import Statement
from chasles.statements.rules import rated
from chasles.verdict import Counterexample, Fails
from chasles.vocabulary import PI, Misfit, Node, Rate, Symbol

Place = tuple[int, int]
EntryPart = tuple[w.Symbol, int, Place | None]
"""A symbol, which rate of it, and the entry that counts, row and column from zero; None where several count."""


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
        context = build(decision.problem(statement, True))
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
    for i, row in enumerate(context.unfold(rated(symbol, order))):
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


def parts_of_entry(node: w.Node, place: Place, order: int = 0) -> Iterator[EntryPart]:
    """What the entry of the expression's rate of that order is made of; some of it may cancel."""
    row, column = place
    match node:
        case w.Symbol(stands_for=w.Node() as of) | w.At(of) | w.Group(of):
            yield from parts_of_entry(of, place, order)
        case w.Symbol():
            yield node, order, place
        case w.Number() | w.Identity() | w.Zero():
            return
        case w.Rate(of):
            yield from parts_of_entry(of, place, order + 1)
        case w.Sum(terms):
            for term in terms:
                yield from parts_of_entry(term, place, order)
        case w.Negative(term):
            yield from parts_of_entry(term, place, order)
        case w.Transpose(of):
            yield from parts_of_entry(of, (column, row), order)
        case w.Skew(of):
            if row != column:
                yield from parts_of_entry(of, (3 - row - column, 0), order)
        case w.Block(rows):
            yield from _of_block(rows, place, order)
        case w.Scale(factor, term) | w.Quotient(term, factor):
            for k in range(order + 1):
                yield from parts_of_entry(factor, (0, 0), k)
                yield from parts_of_entry(term, place, k)
        case _:
            yield from ((symbol, k, None) for symbol in w.symbols_of(node) for k in range(order + 1))


def _of_block(rows: Sequence[Sequence[w.Node]], place: Place, order: int) -> Iterator[EntryPart]:
    """The block in which the entry is, and where in it."""
    heights, widths = [line[0].shape[0] for line in rows], [block.shape[1] for block in rows[0]]
    (i, row), (j, column) = _within(heights, place[0]), _within(widths, place[1])
    yield from parts_of_entry(rows[i][j], (row, column), order)


def _within(sizes: Sequence[int], index: int) -> tuple[int, int]:
    """Into which of the parts of these sizes an index falls, and where in it."""
    for part, (size, end) in enumerate(zip(sizes, accumulate(sizes), strict=True)):
        if index < end:
            return part, index - end + size
    raise IndexError(f"there is no entry {index + 1} among {sum(sizes)}")
