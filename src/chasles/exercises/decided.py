"""Sentences of the book as steps of a solution: each is decided before it is cited, and used as repaired."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

from chasles.decisions.decision import Decision, DoesNotStand
from chasles.decisions.memory import Memory
from chasles.decisions.recalled import shipped
from chasles.decisions.session import Session
from chasles.deriving import walk
from chasles.exercises.solution import Citation, SolutionStep, note, stated
from chasles.statements import Claim, Inverse, Statement, Theorem, load
from chasles.statements.derivation import Derivation
from chasles.statements.elsewhere import other_chapter
from chasles.statements.packages import BOOK
from chasles.verdict import Fails, Undecided
from chasles.vocabulary import Node, plain, replace

Sentence = Statement | Theorem | Inverse
IN_A_LINE = 6
"""So many coordinates of a point stand in a line."""
MOST_SHOWN = 300
"""Characters of an equation of a derivation that is shown on the sheet."""


class Refuted(AssertionError):
    """An answer, substituted back, does not satisfy what was asked: a defect of the exercise."""


@cache
def _session() -> Session:
    return Session(book=load, memory=Memory(shipped=shipped(BOOK)))


def _decided(sentence: Sentence) -> Decision:
    """The decision on a sentence; raises DoesNotStand for one that is undecided, without a correction that is true."""
    decision = _session().decide(sentence)
    if isinstance(decision.verdict, Undecided) and not decision.stands:
        raise DoesNotStand(f"it rests on ({sentence.number}), which is undecided: {decision.verdict.reason}")
    return decision


class Decided:
    """Steps without numbers: statements, derivations and refutations, for all values."""

    def __init__(self, chapter: str = "") -> None:
        self.chapter = chapter
        self.steps: list[SolutionStep] = []

    def state(self, sentence: Statement | Theorem, says: str = "") -> None:
        """A sentence of the book, or of the exercise, as a step without numbers: it is decided, for all values."""
        if isinstance(sentence, Theorem):
            said = [equation for form in sentence.forms for equation in form.equations()]
        else:
            said = [("", *self.sides(sentence))]
        lines = tuple(stated(*equation) for equation in said)
        self.steps.append(SolutionStep(says or sentence.says, (self.cite(sentence),), lines))

    def walk(self, road: Derivation, says: str) -> dict[str, Node]:
        """Carry out a derivation of the book, each step decided: the last right side of each left side, by its name.

        Raises Refuted if a step is not true, DoesNotStand if that is not known.
        """
        walked = walk(road, _session())
        if not walked.arrives:
            last = walked.steps[-1]
            unknown = isinstance(last.verdict, Undecided)
            raise (DoesNotStand if unknown else Refuted)(f"the derivation stops at {last.kind}: {last.reason}")
        equations = [equation for step in walked.steps for equation in step.equations]
        lines = [stated("", *sides) for sides in dict.fromkeys(equations) if plain(sides[0]) != plain(sides[1])]
        shown = tuple(line for line in lines if len(line.text) <= MOST_SHOWN)
        self.steps.append(SolutionStep(f"{says} {road.says}", (), shown))
        return {plain(left): right for left, right in equations}

    def refute(self, claim: Claim, says: str) -> None:
        """A claim that does not hold, with the counterexample that was found; raises Refuted or DoesNotStand."""
        verdict = _decided(claim).verdict
        if not isinstance(verdict, Fails):
            raise Refuted(f"({claim.number}) part {claim.part} does not fail: {verdict.name}")
        found = verdict.counterexample
        values = [f"{name} = {value}" for name, value in found.at.items() if value]
        rows = [", ".join(values[k : k + IN_A_LINE]) for k in range(0, len(values), IN_A_LINE)] or [""]
        lines = (
            stated("", claim.left, claim.right),
            *(note(f"with {row},") for row in rows[:-1]),
            note(f"not so at {rows[-1]}, all else zero: entry {found.entry[0]} is {found.left}, and {found.right}"),
        )
        citation = Citation(claim.number, claim.part, verdict.name, chapter=other_chapter(claim, self.chapter))
        self.steps.append(SolutionStep(f"{claim.says} {says}", (citation,), lines))

    def cite(self, sentence: Sentence) -> Citation:
        """The sentence's number, and what is decided of it. Raises DoesNotStand if nothing is."""
        decision = _decided(sentence)
        correction = None if decision.verdict.true else decision.correction
        form, verdict = (correction.form, correction.verdict) if correction else ("printed", decision.verdict)
        other = other_chapter(sentence, self.chapter)
        return Citation(sentence.number, sentence.part, verdict.name, verdict.needs, form, other)

    def sides(self, statement: Statement, moved: Mapping[Any, Node] | None = None) -> tuple[Node, Node]:
        """Both sides of a statement, repaired where it is wrong as printed; `moved` says it of other symbols."""
        left, right = _session().accepted(statement)
        return (replace(left, moved), replace(right, moved)) if moved else (left, right)
