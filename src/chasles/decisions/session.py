"""Every statement of the book gets its verdict here; one that is wrong as printed also that on what replaces it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace as with_fields
from functools import cached_property, partial
from time import perf_counter
from typing import Any

from chasles.deciding import decided
from chasles.decisions.decision import Correction, Decision, DoesNotStand, Sentence, Used, key_of
from chasles.decisions.kept_answers import repairs_stand, verdict_stands
from chasles.decisions.memory import Memory
from chasles.decisions.tied import tied_by
from chasles.prover.decide import BUDGET, determining, pose
from chasles.repairs.repair import Repair, repair
from chasles.statements import (
    Chapter,
    Claim,
    Condition,
    Definition,
    Entry,
    Hypothesis,
    Inverse,
    Postulate,
    Problem,
    Statement,
    Theorem,
    load,
    problem_of,
)
from chasles.statements.chapter import bases
from chasles.statements.elsewhere import chapter_of
from chasles.statements.inversion import problems_of_inverse
from chasles.statements.posing import default_form, default_sides
from chasles.statements.premises import IN_FULL, with_all_premises
from chasles.statements.statement import Equation
from chasles.verdict import Assumed, Contradictory, Defined, Holds, HoldsUnder, IllFormed, Undecided, Verdict
from chasles.vocabulary import Misfit

__all__ = ["Correction", "Decision", "Session", "Used"]


class Session:
    """Decides statements, each once; a given claim that fails is used in its corrected form.

    With `book`, or what loads it, what is wrong as printed is repaired: what the book says about a symbol tells
    which freedom it has, and claims that rest on a definition tell what it is. What is in `memory` is not decided
    again; what it has from another time is checked.
    """

    def __init__(
        self, budget: float = BUDGET, book: Chapter | Callable[[], Chapter] | None = None, memory: Memory | None = None
    ) -> None:
        self.budget = budget
        self.memory = memory or Memory()
        self._decisions: dict[int, Decision] = {}
        self.searches = book is not None
        self._given_book = book
        self._others: dict[str, Session] = {}

    @cached_property
    def _chapter(self) -> Chapter | None:
        return self._given_book() if callable(self._given_book) else self._given_book

    @cached_property
    def _book(self) -> tuple[Statement, ...]:
        return tuple(entry.statement for entry in self._chapter or () if isinstance(entry.statement, Statement))

    @cached_property
    def package(self) -> str:
        """The package of the chapter; empty without one."""
        return self._chapter.package if self._chapter else ""

    def _of(self, package: str) -> Session:
        """The session of another chapter on which this one rests: it finds what is right by what that chapter says."""
        if package not in self._others:
            self._others[package] = Session(self.budget, partial(load, package), self.memory)
        return self._others[package]

    @cached_property
    def _place(self) -> dict[int, int]:
        return {id(statement): k for k, statement in enumerate(self._book)}

    def decide_all(self, entries: Iterable[Entry]) -> Iterator[tuple[Entry, Decision]]:
        """The decisions, one at a time, in the order of the entries."""
        for entry in entries:
            yield entry, self.decide(entry.statement)

    def decide(self, sentence: Sentence) -> Decision:
        """The decision on one sentence; those on which it rests are decided first where that matters."""
        known = self._decisions.get(id(sentence))
        if known is None:
            known = self._decisions[id(sentence)] = self._decide(sentence)
        return known

    def accepted(self, statement: Statement) -> Equation:
        """The sides with which a given statement is used; raises DoesNotStand."""
        return self._used(statement).sides

    def _used(self, statement: Statement) -> Used:
        """The form in which a given statement is used: as printed, unless that fails and another form is proved."""
        if not isinstance(statement, Claim):
            return Used(default_form(statement), default_sides(statement))
        decision = self.decide(statement)
        if decision.verdict.true:
            return Used("printed", statement.printed)
        if decision.correction is not None and decision.correction.verdict.true:
            return Used(decision.correction.form, decision.correction.sides)
        raise DoesNotStand(
            f"it rests on ({statement.number}), which is not proved: its verdict is '{decision.verdict.name}'"
        )

    def _decide(self, sentence: Sentence) -> Decision:
        started = perf_counter()
        try:
            given = {key_of(statement, sentence): self._used(statement) for statement in bases(sentence)}
        except TypeError as error:
            if not isinstance(sentence, Definition):
                return Decision(sentence, Undecided(str(error)), milliseconds=(perf_counter() - started) * 1000)
            given = {}
        verdict = self._inverse(sentence) if isinstance(sentence, Inverse) else self._form(sentence)
        correction = None
        if not verdict.true and isinstance(sentence, Statement):
            correction = self._correction(sentence)
        return Decision(sentence, verdict, correction, given, (perf_counter() - started) * 1000)

    def _correction(self, sentence: Statement) -> Correction | None:
        """The reading if it is true, else the nearest repair, else what is declared, true or not."""
        repairs = self._repairs(sentence)
        forms = [Correction("repair", (r.left, r.right), r.verdict) for r in repairs[:1]]
        for place, form in ((0, "reading"), (len(forms) + 1, "corrected")):
            if sentence.form_exists(form):
                sides = sentence.form(form)
                forms.insert(place, Correction(form, sides, self._form(sentence.saying(*sides))))
        if not forms:
            return None
        stands = next((each for each in forms if each.verdict.true), forms[-1])
        declared = tuple(each for each in forms if each is not stands and each.form != "repair")
        return with_fields(stands, repairs=repairs, others=declared)

    def _repairs(self, sentence: Statement) -> tuple[Repair, ...]:
        """What the search finds, if there is a book to search."""
        return [*self.search(sentence).values()][-1] if self.searches else ()

    def search(self, sentence: Statement) -> dict[str, tuple[Repair, ...]]:
        """The repairs of a statement, by the key by which they are remembered: the last are what is found.

        A claim is repaired by what comes before it, so that it never waits for itself; where what it is given leaves
        nothing to find, by all that it rests on. Raises DoesNotStand for what it rests on.
        """
        home = chapter_of(sentence)
        if home not in ("", self.package):
            return self._of(home).search(sentence)
        before = self._book[: None if isinstance(sentence, Definition) else self._place.get(id(sentence))]
        found: dict[str, tuple[Repair, ...]] = {}
        for said in dict.fromkeys((sentence, with_all_premises(sentence, self.accepted))):
            if isinstance(said, Statement) and not any(found.values()):
                key = self.memory.key_of_repairs(said, [self.accepted(given) for given in said.relied_on], before)
                stand = partial(self._stand, said, before)
                found[key] = self.memory.answer(key, stand, partial(self._search, said, before, said is not sentence))
        return found

    def _stand(self, said: Statement, before: tuple[Statement, ...], repairs: Any) -> bool:
        return repairs_stand(said, repairs, self.accepted, before, self.verdict_on)

    def _search(self, said: Statement, before: tuple[Statement, ...], in_full: bool) -> tuple[Repair, ...]:
        undecided = isinstance(self._form(said), Undecided)
        found = repair(said, self.accepted, context=before, undecided=undecided)
        return tuple(with_fields(each, verdict=_in_full(each.verdict)) for each in found) if in_full else found

    def verdict_on(self, problem: Problem, own: tuple[Hypothesis, ...] = ()) -> Verdict:
        """The verdict on a problem; `own` are the hypotheses whose use it reports."""
        key = self.memory.key_of_verdict(problem, own)
        stands = partial(verdict_stands, problem)
        found: Verdict = self.memory.answer(key, stands, lambda: decided(problem, own, self.budget))
        return found

    def _form(self, sentence: Statement | Theorem) -> Verdict:
        """The verdict on a sentence as printed."""
        try:
            accepted = default_sides if isinstance(sentence, Definition) else self.accepted
            problem = problem_of(sentence, "printed", accepted)
        except Misfit as misfit:
            return IllFormed(str(misfit))
        except TypeError as error:
            return Undecided(str(error))
        match sentence:
            case Definition():
                return Defined()
            case Postulate():
                return Assumed()
            case Condition():
                return self._posed(sentence, problem)
            case _:
                tied = tied_by(sentence, accepted)
                verdict = Undecided(tied) if tied else self.verdict_on(problem, sentence.assuming)
                if (
                    isinstance(verdict, Contradictory)
                    and isinstance(sentence, Statement)
                    and sentence.left.expands | sentence.right.expands
                ):
                    return Undecided("a series begins with a term that is zero, which is not seen")
                return verdict if verdict.true else self._in_full(sentence, verdict)

    def _in_full(self, sentence: Statement | Theorem, verdict: Verdict) -> Verdict:
        """The verdict where what is given brings all that it rests on; that without, where nothing refutes it so."""
        whole = with_all_premises(sentence, self.accepted)
        if whole is sentence or isinstance(verdict, Contradictory):
            return verdict
        try:
            problem, tied = problem_of(whole, "printed", self.accepted), tied_by(whole, self.accepted)
            found = Undecided(tied) if tied else self.verdict_on(problem, sentence.assuming)
        except (Misfit, TypeError) as error:
            found = Undecided(str(error))
        return verdict if isinstance(verdict, Undecided) and isinstance(found, Undecided) else _in_full(found)

    def _posed(self, sentence: Condition, problem: Problem) -> Verdict:
        """A condition is posed if a point satisfies it.

        One that determines its symbols does so by its own equations; that of one that gives its solution must first be
        decided to follow, and one on nothing is assumed.
        """
        if sentence.on and sentence.solution is None:
            return pose(determining(problem, sentence.on))
        verdict = self.verdict_on(problem, sentence.assuming)
        return pose(problem) if verdict.true else verdict

    def _inverse(self, sentence: Inverse) -> Verdict:
        """An inverse holds if each of its branches does and they cover the domain."""
        needs: dict[str, None] = {}
        certificates: dict[str, Any] = {}
        verdict: Verdict | None = None
        try:
            problems = list(problems_of_inverse(sentence, self.accepted))
        except Misfit as misfit:
            return IllFormed(str(misfit))
        except TypeError as error:
            return Undecided(str(error))
        for says, problem in problems:
            verdict = self.verdict_on(problem)
            if not isinstance(verdict, Holds | HoldsUnder):
                return verdict
            needs |= dict.fromkeys(h.text for h in sentence.assuming if h.text in verdict.needs)
            certificates[says] = verdict.certificate
        assert isinstance(verdict, Holds | HoldsUnder)
        unused = tuple(h.text for h in sentence.assuming if h.text not in needs)
        return HoldsUnder(tuple(needs), {"branches": certificates}, verdict.witness, unused)


def _in_full(verdict: Verdict) -> Verdict:
    """The verdict on a statement given all that it rests on, as its certificate says."""
    if not isinstance(verdict, Holds | HoldsUnder | Contradictory) or verdict.certificate is None:
        return verdict
    return with_fields(verdict, certificate={**verdict.certificate, IN_FULL: True})
