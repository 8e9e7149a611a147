"""The nearest true equations to one that fails, each proved before it counts.

Marks and factors without which an equation does not fit together are restored first; what then fails is changed as
little as possible. A definition that does not fit is what makes the claims that rest on it true.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from dataclasses import replace as with_fields
from itertools import chain, islice

from chasles.algebra.work_limit import OutOfTime, within
from chasles.deciding import decided
from chasles.display import Displayed
from chasles.repairs.any_size import NearestAtNumbers, differs_at_sizes, nearest_at_numbers
from chasles.repairs.candidates import Nearest, given_sides
from chasles.repairs.dependents import not_resting_on, resting_on, says_something, users_of
from chasles.repairs.one_term import Change
from chasles.repairs.ranking import ORTHOGONAL, Ranking
from chasles.repairs.well_formed import WellFormedRepair, fitting
from chasles.repairs.without_form import edited, edits_of
from chasles.rewriting.term_basis import fit, term_basis
from chasles.statements import Claim, Definition, Statement, problem_of
from chasles.statements.goals import AcceptedSides
from chasles.statements.posing import default_sides
from chasles.statements.statement import bare
from chasles.verdict import Holds, HoldsUnder, Verdict
from chasles.vocabulary import Misfit, Node, plain
from chasles.vocabulary.families import indices_of

EFFORT = 2e7
"""The work that the search for a repair, its proofs included, may take, in products of terms."""
MORE_EFFORT, MOST = 2, 8
"""Repairs of the same number of changes as the best are given if they take hardly more effort; so many are tried."""
MOST_DECIDED = 60
"""Edits of a side that are decided, where no points tell which may be right."""


@dataclass(frozen=True, slots=True, repr=False)
class Repair(Displayed):
    """A true equation near the printed one: its sides, what was changed in words, and the verdict on it.

    The first `marks` of the `edits` changes restore what was lost before it fitted together. `modulo`
    says why another object may stand on the left where the sides are right for that one; `by` names the claims that
    hold with a definition, and show it to be the one that was meant.
    """

    left: Node
    right: Node
    changes: tuple[str, ...]
    edits: int
    verdict: Verdict
    modulo: str | None = None
    by: tuple[str, ...] = ()
    marks: int = 0

    def __repr__(self) -> str:
        return f"<repair {plain(self.left)} = {plain(self.right)}>"


def repair(
    statement: Statement,
    accepted: AcceptedSides = default_sides,
    effort: float = EFFORT,
    context: Iterable[Statement] = (),
    undecided: bool = False,
) -> tuple[Repair, ...]:
    """The nearest true equations, that with the fewest and simplest changes first; none if none was proved in time.

    `accepted` gives the sides with which given statements are used. Changes are counted from the printed equation;
    where restored marks alone do not make it true, the search goes on from the statement's reading if it has one.
    `context` are other statements of the book: claims about a symbol say which freedom it has, claims that rest on a
    definition say what it is. What rests on a statement that is not proved is not repaired. What is `undecided` may be
    true: it is left alone unless its sides differ at points.
    """
    try:
        sides = given_sides(statement, accepted)
    except TypeError:
        return ()
    claims = tuple(other for other in context if isinstance(other, Claim) and says_something(other))
    if isinstance(statement, Claim):
        claims = not_resting_on(statement, claims)
    near = Nearest(statement, accepted, sides, claims, undecided)
    found: list[Repair] = []
    with suppress(OutOfTime), within(effort):
        found.extend(_of_definition(near) if isinstance(statement, Definition) else _of_claim(near))
    return tuple(found)


def claims_of(statement: Statement, repair: Repair, context: Iterable[Statement]) -> list[list[Statement]]:
    """What a repair says is true: the statement as it would be, or the claims that hold with what was meant.

    One of each group is true; that of the first is what the repair's verdict is on.
    """
    meant = statement.saying(repair.left, repair.right)
    if not isinstance(statement, Definition):
        return [[meant]]
    users = users_of(statement, (claim for claim in context if isinstance(claim, Claim)))
    return [[resting_on(meant, user) for user in users if user.number == number] for number in repair.by]


def _of_claim(near: Nearest) -> Iterator[Repair]:
    statement = near.statement
    if not isinstance(statement, Claim) or statement.solves is not None:
        return
    if near.undecided and not differs_at_sizes(statement, near.accepted):
        return
    sized = nearest_at_numbers(statement, near.accepted)
    for changes in _candidates(near) if sized is None else _at_any_size(sized):
        found = list(_proved(near, changes))
        yield from found
        if found:
            return


def _at_any_size(sized: NearestAtNumbers) -> Iterator[Iterable[Change]]:
    """Candidates among matrices of any size: what fits after a change or two, or else what is true at numbers."""
    groups = _fitting(sized) if sized.statement.fault else ()
    yield from (sized.said_of_any_size(filter(sized.agrees, map(_as_change, group))) for group in groups)
    if not groups:
        yield sized.said_of_any_size(sized.changes(*sized.statement.printed))


def _candidates(near: Nearest) -> Iterator[Iterable[Change]]:
    """Candidates, in order: later ones are further from the printed equation."""
    statement = near.statement
    once, twice = _fitting(near) if statement.fault else ([], [])
    for group in (once, twice):
        yield [_as_change(f) for f in group if near.agree(f.left, f.right)]
    if statement.reading is not None:
        left, right = statement.form("reading")
        words = _words_of_reading(near, left, right, [*once, *twice])
        yield (_marked(WellFormedRepair(left, right, words), change) for change in near.changes(left, right))
    elif not statement.fault:
        indexed = any(map(indices_of, statement.printed))
        yield from () if indexed else near.stages(*statement.printed)
        if indexed or not (near.is_tested(*statement.printed) or near.in_floats(*statement.printed)):
            yield _decided_edits(near)
    else:
        yield (_marked(f, change) for f in once for change in near.single_changes(f.left, f.right))
        yield (_marked(f, change) for f in (*once, *twice) for change in near.changes(f.left, f.right))


def _decided_edits(near: Nearest) -> Iterator[Change]:
    """One edit on either side with which the prover finds the equation true, where there are no points to try it at.

    None makes the sides the same: that would say nothing.
    """
    left, right = near.statement.printed
    try:
        if problem_of(near.statement, "printed", near.accepted).has_functions:
            return
    except (Misfit, TypeError):
        return
    indices = dict.fromkeys(index for side in (left, right) for index in indices_of(side))
    for change in edited(left, right, lambda side: islice(edits_of(side, near.letters, indices), MOST_DECIDED)):
        sides = change.left, change.right
        if sides[0] != sides[1] and fit(*sides) and _verdict(near, near.statement.saying(*sides)) is not None:
            yield change


def _fitting(near: Nearest) -> tuple[list[WellFormedRepair], list[WellFormedRepair]]:
    left, right = near.statement.printed
    return fitting(left, right, near.letters, term_basis((*near.given_sides, left, right), near.own))


def _words_of_reading(near: Nearest, left: Node, right: Node, found: Iterable[WellFormedRepair]) -> tuple[str, ...]:
    """The marks that lead from the printed equation to its reading."""
    for each in found:
        if each.left == left and each.right == right:
            return each.words
        for other, words, _ in near.introduced(each.left, each.right):
            if each.left == left and other == right:
                return (*each.words, words)
    return (f"it reads {plain(left)} = {plain(right)}",)


def _as_change(fitting: WellFormedRepair) -> Change:
    return _marked(fitting, Change(fitting.left, fitting.right, ()))


def _marked(fitting: WellFormedRepair, change: Change) -> Change:
    return with_fields(change, words=(*fitting.words, *change.words), marks=len(fitting.words))


def _proved(near: Nearest, changes: Iterable[Change]) -> Iterator[Repair]:
    """The candidates that the prover confirms: those of the least number of changes, the smallest changes first.

    One that is spelled as another, or as the printed equation, is none: a_ij is that of a matrix or of its transpose;
    nor is one whose sides are the same, which says nothing.
    """
    statement = near.statement
    hypotheses = chain(statement.assuming, *(given.assuming for given in statement.given))
    orthogonal = {subject for h in hypotheses if h.kind in ORTHOGONAL for subject in h.subjects}
    others = (*near.given_sides, *(side for claim in near.context for side in claim.printed))
    rank = Ranking(statement.printed, others, orthogonal)
    best: Change | None = None
    seen = {_spelled(*statement.printed)}
    for change in sorted(changes, key=rank):
        if best is not None and (len(change.words) > len(best.words) or change.effort > best.effort + MORE_EFFORT):
            return
        spelled = _spelled(change.left, change.right)
        says_nothing = not change.words or bare(change.left) == bare(change.right)
        if says_nothing or spelled in seen or len(seen) > MOST or rank.is_in_vain(change):
            continue
        seen.add(spelled)
        if (verdict := _verdict(near, statement.saying(change.left, change.right))) is not None:
            best = change if best is None else best
            left, right, words = change.left, change.right, change.words
            yield Repair(left, right, words, len(words), verdict, change.modulo, marks=change.marks)


def _spelled(left: Node, right: Node) -> tuple[str, str]:
    return plain(left), plain(right)


def _verdict(near: Nearest, claim: Statement) -> Holds | HoldsUnder | None:
    """The verdict on a claim if it is proved."""
    try:
        verdict = decided(problem_of(claim, "printed", near.accepted), claim.assuming)
    except (Misfit, TypeError):
        return None
    return verdict if isinstance(verdict, Holds | HoldsUnder) else None


def _of_definition(near: Nearest) -> Iterator[Repair]:
    """What a definition that does not fit together was meant to be: that with which claims that rest on it hold."""
    statement = near.statement
    users = users_of(statement, near.context)
    if not statement.fault or not users:
        return
    found = False
    for group in _fitting(near):
        for each in group:
            meant = statement.saying(each.left, each.right)
            decided_of = ((user.number, _verdict(near, resting_on(meant, user))) for user in users)
            verdicts = {number: verdict for number, verdict in decided_of if verdict is not None}
            if verdicts:
                found = True
                edits, verdict = len(each.words), next(iter(verdicts.values()))
                by = tuple(verdicts)
                yield Repair(each.left, each.right, each.words, edits, verdict, by=by, marks=edits)
        if found:
            return
