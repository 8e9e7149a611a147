"""A proof from given premises, or a refutation under all of them, within bounds that a page can wait for.

Where a proof is tried, no counterexample is searched for, as more premises may yet prove it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from chasles.algebra.work_limit import OutOfTime, within
from chasles.checker.any_size.at_sizes import sizes_in
from chasles.deciding import decided
from chasles.decisions.kept_answers import verdict_stands
from chasles.decisions.session import Session
from chasles.points.evaluation import Point
from chasles.points.search import UnreducedEntry, any_counterexample
from chasles.problems.context import Context
from chasles.prover.conditions import Solved
from chasles.prover.decide import decide_problem, pose
from chasles.prover.sources import DeclaredPoints
from chasles.statements import Claim, Hypothesis, Problem, problem_of
from chasles.statements.spins import with_spins
from chasles.verdict import Contradictory, Counterexample, Fails, Holds, HoldsUnder, Undecided, Verdict
from chasles.vocabulary import Misfit, Node, Power

MOST_TERMS = 500
"""Points are not drawn where hypotheses and sides have more terms than this: each point takes too long."""
MOST_WORDS, MOST_IN_BRIEF, MOST_OF_A_SLIP = 100, 24, 1000
"""Problems of functions that have no polynomial form are left where they have more words than this, entry by entry.

SymPy counts no work: where nothing says that a claim follows, or fails by a slip, few words are looked at; where a slip
is known, more.
"""
LESS_WORK = 0.04
"""The part of the work that is taken for a refutation, or a condition."""
LEAST_WORK = 0.02
"""The part of it that is taken where nothing is known of what follows."""
ATTEMPTS = 24
"""So often a point is drawn."""


class _Unproved(Exception):
    """An entry does not vanish, or is not seen to."""


class _FewTerms(DeclaredPoints):
    """Points, for what is not long."""

    most_words = MOST_WORDS
    attempts = ATTEMPTS
    fruitless = 8

    def likely_vanish(self, context: Context, solved: tuple[Solved, ...], suspects: Sequence[UnreducedEntry]) -> bool:
        _require_few_terms(context, suspects)
        return super().likely_vanish(context, solved, suspects)

    def refute_soon(
        self, context: Context, solved: tuple[Solved, ...], suspects: Sequence[UnreducedEntry]
    ) -> Counterexample | None:
        _require_few_terms(context, suspects)
        return super().refute_soon(context, solved, suspects)

    def witness(self, context: Context, solved: tuple[Solved, ...]) -> Point | None:
        _require_few_terms(context, ())
        return super().witness(context, solved)


def _require_few_terms(context: Context, suspects: Sequence[UnreducedEntry]) -> None:
    polynomials = (*(g.polynomial for g in context.generators), *(e.ratio.numerator for e in suspects))
    if sum(map(len, polynomials)) > MOST_TERMS:
        raise _Unproved("written out it is too long")


class _Likely(DeclaredPoints):
    """Points that satisfy what a proof rests on, and no others."""

    most_words = MOST_WORDS
    attempts = ATTEMPTS

    def refute(self, context: Context, solved: tuple[Solved, ...], suspects: Sequence[UnreducedEntry]) -> None:
        raise _Unproved

    def refute_soon(self, context: Context, solved: tuple[Solved, ...], suspects: Sequence[UnreducedEntry]) -> None:
        return None

    def contradiction(self, problem: Problem) -> Contradictory | None:
        return None


class _NoCounterexamples(_Likely, _FewTerms):
    """Points at which a problem is looked at before a proof is tried, and one that satisfies what a proof rests on."""

    most_words = MOST_IN_BRIEF

    def refute_soon(self, context: Context, solved: tuple[Solved, ...], suspects: Sequence[UnreducedEntry]) -> None:
        if not self.likely_vanish(context, solved, suspects):
            raise _Unproved


class _Brief(_FewTerms):
    """The same, for what has few functions."""

    most_words = MOST_IN_BRIEF


class _OfSlip(_FewTerms):
    """Points at which it shows that something is a slip, which is known."""

    most_words = MOST_OF_A_SLIP


FEW_TERMS, BRIEF, OF_SLIP = _FewTerms(), _Brief(), _OfSlip()
NO_COUNTEREXAMPLES, LIKELY = _NoCounterexamples(), _Likely()
Source = _FewTerms | _Likely


def proof_of(claim: Claim, session: Session, likely: bool = False, work: float = 1.0) -> Verdict | None:
    """The verdict on a claim that follows from its premises, which a point satisfies; None if that is not found.

    This part of the work is taken where it is likely to follow, less where that is not known.
    """
    verdict = _answer(claim, session, *((LIKELY, work) if likely else (NO_COUNTEREXAMPLES, LEAST_WORK)))
    return verdict if verdict.true else None


def verdict_on(claim: Claim, session: Session, source: Source = FEW_TERMS, work: float = LESS_WORK) -> Verdict:
    """The verdict on a claim under its premises; undecided where that takes more than this part of the work.

    The `source` of points says how much is looked at that has functions: points at which it does not hold are searched
    for long.
    """
    return _answer(claim, session, source, work)


def posed_on(claim: Claim, session: Session) -> Verdict:
    """The verdict on what is assumed: posed where a point satisfies it; undecided where that takes too long."""
    try:
        with within(LESS_WORK * session.budget):
            return pose(problem_of(claim, "printed", session.accepted), ATTEMPTS)
    except (Misfit, TypeError, OutOfTime) as error:
        return Undecided(str(error))


def _answer(claim: Claim, session: Session, source: Source, work: float = LESS_WORK) -> Verdict:
    """The verdict; what is undecided is so with this source of points alone."""
    try:
        problem = problem_of(claim, "printed", session.accepted)
    except (Misfit, TypeError) as error:
        return Undecided(str(error))
    key = session.memory.key_of_verdict(problem, claim.assuming)
    tried = f"{key} {type(source).__name__} {work}"
    if tried in session.memory.reasons:
        return Undecided(session.memory.reasons[tried])
    find = partial(_found, problem, claim.assuming, work * session.budget, source)
    try:
        found: Verdict = session.memory.answer(key, partial(verdict_stands, problem), find)
    except (_Unproved, Misfit, TypeError, ArithmeticError, RecursionError) as error:
        found = Undecided(str(error))
        session.memory.reasons[tried] = found.reason
    return found


def _found(problem: Problem, own: tuple[Hypothesis, ...], budget: float, source: Source) -> Verdict:
    if not isinstance(source, _Likely):
        verdict = _decided(problem, own, budget, source)
    else:
        with any_counterexample():
            verdict = _decided(problem, own, budget, source)
        if isinstance(verdict, Fails):  # the first point found is not one to tell
            raise _Unproved
    if isinstance(verdict, Undecided):
        raise _Unproved(verdict.reason)
    return verdict


def _decided(problem: Problem, own: tuple[Hypothesis, ...], budget: float, source: Source) -> Verdict:
    """The verdict; one on rotations that move is proved for all spins."""
    if problem.has_functions:
        _require_few_words(problem, source)
    if sizes_in(problem) or problem.has_functions:
        return decided(problem, own, budget)
    spun = with_spins(problem)
    if spun is problem:
        verdict = decide_problem(problem, own, budget, source)
        if not (isinstance(verdict, Undecided) and verdict.without_form):
            return verdict
        _require_few_words(problem, source)
        return decided(problem, own, budget)
    try:
        verdict = decide_problem(problem, own, budget, source)
    except _Unproved as error:
        verdict = Undecided(str(error))
    if verdict.true or isinstance(verdict, Fails):
        return verdict
    moved = decide_problem(spun, own, budget, source)
    if isinstance(moved, Holds | HoldsUnder):
        return replace(moved, certificate={**moved.certificate, "spins": True})
    return verdict


def _require_few_words(problem: Problem, source: Source) -> None:
    if _words_in(problem) > source.most_words:
        raise _Unproved("written out it is too long")


def _words_in(problem: Problem) -> int:
    """The words of all that is claimed and assumed, what they stand for written out, for each entry.

    A high power counts for several.
    """
    rules = dict(problem.rules)
    known: dict[Node, int] = {}

    def count(node: Node) -> int:
        if node not in known:
            known[node] = 1
            known[node] = count(rules[node]) if node in rules else 1 + sum(map(count, node.below))
            known[node] += node.exponent // 10 if isinstance(node, Power) and isinstance(node.exponent, int) else 0
        return known[node]

    return sum(count(side) * side.shape[0] * side.shape[1] for side in (*problem.sides, *problem.assumed_sides))
