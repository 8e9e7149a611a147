"""Every sentence of the book gets its verdict here, and beside a printed slip the verdict on what stands in for it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from time import perf_counter
from typing import Any

from chasles.proof.decide import BUDGET, decide_problem, determining, pose
from chasles.proof.verdict import Assumed, Defined, Holds, HoldsUnder, IllFormed, Undecided, Verdict
from chasles.statements import (
    Claim,
    Condition,
    Definition,
    Entry,
    Inverse,
    Postulate,
    Problem,
    Statement,
    Theorem,
    problem_of,
)
from chasles.statements.inversion import problems_of_inverse
from chasles.statements.problem import default_form
from chasles.vocabulary import Misfit

__all__ = ["Correction", "Decision", "Judge"]

Sentence = Statement | Theorem | Inverse


@dataclass(frozen=True, slots=True)
class Correction:
    """What stands in for a print that does not: its form ("reading" or "corrected") and the verdict on it."""

    form: str
    verdict: Verdict


@dataclass(frozen=True, slots=True)
class Decision:
    """The verdict on a sentence as printed, what stands in for it, and how long it took.

    `given` says in which form each given statement was used.
    """

    statement: Sentence
    verdict: Verdict
    correction: Correction | None = None
    given: dict[str, str] = field(default_factory=dict)
    milliseconds: float = 0.0

    @property
    def certificate(self) -> Any:
        """The certificate of the form that stands, if one was made."""
        verdict = self.correction.verdict if self.correction and not self.verdict.true else self.verdict
        return getattr(verdict, "certificate", None)


class Judge:
    """Decides sentences, each once; a given claim that fails is used in the form that stands in for it."""

    def __init__(self, budget: float = BUDGET) -> None:
        self.budget = budget
        self._decisions: dict[int, Decision] = {}
        self._branches: dict[Problem, Verdict] = {}

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

    def standing(self, statement: Statement) -> str:
        """The form in which a given statement is used: printed, unless that fails and another form stands in."""
        if statement.fault or not isinstance(statement, Claim):
            return default_form(statement)
        decision = self.decide(statement)
        if decision.verdict.true:
            return "printed"
        if decision.correction is not None and decision.correction.verdict.true:
            return decision.correction.form
        raise TypeError(
            f"it rests on ({statement.number}), which does not stand: its verdict is '{decision.verdict.name}'"
        )

    def _decide(self, sentence: Sentence) -> Decision:
        started = perf_counter()
        try:
            given = {f"{g.number}/{g.part}": self.standing(g) for g in sentence.given}
        except TypeError as error:
            if not isinstance(sentence, Definition):
                return Decision(sentence, Undecided(str(error)), milliseconds=(perf_counter() - started) * 1000)
            given = {}
        verdict = self._inverse(sentence) if isinstance(sentence, Inverse) else self._form(sentence, "printed")
        correction = None if verdict.true else self._correction(sentence)
        return Decision(sentence, verdict, correction, given, (perf_counter() - started) * 1000)

    def _correction(self, sentence: Sentence) -> Correction | None:
        """The first form that is true, as read and then as corrected; the last one tried if none is."""
        found = None
        for form in ("reading", "corrected"):
            if isinstance(sentence, Statement) and sentence.form_exists(form):
                found = Correction(form, self._form(sentence, form))
                if found.verdict.true:
                    break
        return found

    def _form(self, sentence: Statement | Theorem, form: str) -> Verdict:
        """The verdict on one form of a sentence."""
        try:
            standing = default_form if isinstance(sentence, Definition) else self.standing
            problem = problem_of(sentence, form, standing)
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
                return decide_problem(problem, sentence.assuming, self.budget)

    def _posed(self, sentence: Condition, problem: Problem) -> Verdict:
        """A condition is posed if a point satisfies it.

        One that determines its symbols does so by its own equations; one that says no more than its named hypotheses,
        or gives its solution, must first be decided to follow.
        """
        if sentence.on and sentence.solution is None:
            return pose(determining(problem, sentence.on))
        verdict = decide_problem(problem, sentence.assuming, self.budget)
        return pose(problem) if verdict.true else verdict

    def _inverse(self, sentence: Inverse) -> Verdict:
        """An inverse holds if each of its branches does and they cover the domain."""
        needs: dict[str, None] = {}
        certificates: dict[str, Any] = {}
        verdict: Verdict | None = None
        for says, problem in problems_of_inverse(sentence, self.standing):
            if problem not in self._branches:
                self._branches[problem] = decide_problem(problem, (), self.budget)
            verdict = self._branches[problem]
            if not isinstance(verdict, Holds | HoldsUnder):
                return verdict
            needs |= dict.fromkeys(h.text for h in sentence.assuming if h.text in verdict.needs)
            certificates[says] = verdict.certificate
        assert isinstance(verdict, Holds | HoldsUnder)
        unused = tuple(h.text for h in sentence.assuming if h.text not in needs)
        return HoldsUnder(tuple(needs), {"branches": certificates}, verdict.witness, unused)
