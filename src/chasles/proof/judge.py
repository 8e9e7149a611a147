"""Every sentence of the book gets its verdict here, and beside a printed slip the verdict on what stands in for it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from dataclasses import replace as with_fields
from time import perf_counter
from typing import Any

from chasles.proof.decide import BUDGET, decide_problem, determining, pose
from chasles.proof.repair import Repair, repair
from chasles.proof.verdict import Assumed, Defined, Holds, HoldsUnder, IllFormed, Undecided, Verdict
from chasles.statements import (
    Chapter,
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
from chasles.statements.problem import default_form, default_sides
from chasles.statements.statement import Equation
from chasles.vocabulary import Misfit

__all__ = ["Correction", "Decision", "Judge", "Used"]

Sentence = Statement | Theorem | Inverse
PATIENCE = 60.0
"""Seconds for the search of one repair: so many that what is found does not depend on the machine."""


@dataclass(frozen=True, slots=True)
class Correction:
    """What stands in for a print that does not: its form, its sides and the verdict on it.

    The form is "reading", "repair" or "corrected". `repairs` are all that the search found, the nearest first;
    `others` are the other forms that are declared.
    """

    form: str
    sides: Equation
    verdict: Verdict
    repairs: tuple[Repair, ...] = ()
    others: tuple[Correction, ...] = ()

    @property
    def found(self) -> str:
        """Who found it: "repair" if the search did, else "declared"."""
        return "repair" if any((r.left, r.right) == self.sides for r in self.repairs) else "declared"


@dataclass(frozen=True, slots=True)
class Used:
    """The form in which a statement was used, and its sides in that form."""

    form: str
    sides: Equation


@dataclass(frozen=True, slots=True)
class Decision:
    """The verdict on a sentence as printed, what stands in for it, and how long it took.

    `given` says how each statement was used on whose sides it rests, by number and part: "3.96a/1".
    """

    statement: Sentence
    verdict: Verdict
    correction: Correction | None = None
    given: dict[str, Used] = field(default_factory=dict)
    milliseconds: float = 0.0

    @property
    def stands(self) -> bool:
        """Whether the sentence is true as printed, or something stands in for it."""
        return self.verdict.true or (self.correction is not None and self.correction.verdict.true)

    @property
    def sides(self) -> Equation:
        """The sides of what stands; as printed if nothing does. Only of an equation."""
        assert isinstance(self.statement, Statement)
        if self.verdict.true or self.correction is None or not self.correction.verdict.true:
            return self.statement.printed
        return self.correction.sides

    @property
    def repaired(self) -> Sentence:
        """The sentence as it would be printed if it said what stands."""
        if self.verdict.true or not isinstance(self.statement, Statement):
            return self.statement
        return self.statement.saying(*self.sides)

    @property
    def certificate(self) -> Any:
        """The certificate of the form that stands, if one was made."""
        verdict = self.correction.verdict if self.correction and not self.verdict.true else self.verdict
        return getattr(verdict, "certificate", None)

    def standing(self, given: Statement) -> Equation:
        """The sides with which the decision used a given statement."""
        used = self.given.get(_key(given))
        return default_sides(given) if used is None else used.sides


class Judge:
    """Decides sentences, each once; a given claim that fails is used in the form that stands in for it.

    With `book`, what does not stand as printed is repaired: what the book says about a symbol tells which freedom it
    has, and claims that rest on a definition tell what it is.
    """

    def __init__(self, budget: float = BUDGET, book: Chapter | None = None) -> None:
        self.budget = budget
        self._decisions: dict[int, Decision] = {}
        self._branches: dict[Problem, Verdict] = {}
        self._searches = book is not None
        self._book = tuple(entry.statement for entry in book or () if isinstance(entry.statement, Statement))
        self._place = {id(statement): k for k, statement in enumerate(self._book)}

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

    def standing(self, statement: Statement) -> Equation:
        """The sides with which a given statement is used; raises TypeError for one that does not stand."""
        return self._used(statement).sides

    def _used(self, statement: Statement) -> Used:
        """The form in which a given statement is used: printed, unless that fails and another form stands in."""
        if not isinstance(statement, Claim):
            return Used(default_form(statement), default_sides(statement))
        decision = self.decide(statement)
        if decision.verdict.true:
            return Used("printed", statement.printed)
        if decision.correction is not None and decision.correction.verdict.true:
            return Used(decision.correction.form, decision.correction.sides)
        raise TypeError(
            f"it rests on ({statement.number}), which does not stand: its verdict is '{decision.verdict.name}'"
        )

    def _decide(self, sentence: Sentence) -> Decision:
        started = perf_counter()
        try:
            relied_on = sentence.relied_on if isinstance(sentence, Statement) else sentence.given
            given = {_key(statement): self._used(statement) for statement in relied_on}
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
        """What the search finds. A claim is repaired by what comes before it, so that it never waits for itself."""
        if not self._searches:
            return ()
        place = None if isinstance(sentence, Definition) else self._place.get(id(sentence))
        return repair(sentence, self.standing, PATIENCE, self._book[:place])

    def _form(self, sentence: Statement | Theorem) -> Verdict:
        """The verdict on a sentence as printed."""
        try:
            standing = default_sides if isinstance(sentence, Definition) else self.standing
            problem = problem_of(sentence, "printed", standing)
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


def _key(statement: Statement) -> str:
    return f"{statement.number}/{statement.part}"
