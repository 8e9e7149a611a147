"""The decision on a statement: the verdict on it as printed and, where that is wrong, on its correction."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from chasles.display import Displayed
from chasles.repairs.repair import Repair
from chasles.several import Several
from chasles.statements import Inverse, Problem, Statement, Theorem, problem_of
from chasles.statements.elsewhere import chapter_of, other_chapter
from chasles.statements.posing import default_sides
from chasles.statements.premises import with_all_premises
from chasles.statements.statement import Equation
from chasles.verdict import Verdict

Sentence = Statement | Theorem | Inverse
HOW = {"printed": "as printed", "reading": "as read", "repair": "as repaired", "corrected": "as corrected"}
"""A form of a statement in words."""
WORST_FIRST = (
    *("ill-formed", "fails", "contradictory", "undecided"),
    *("holds-under", "holds", "posed", "assumed", "defined"),
)
"""The names of verdicts: what is wrong as printed, what is not known, what needs something, what is right."""


class DoesNotStand(TypeError):
    """Something rests on a sentence of which no form is known to be true."""


class Certificate(dict[str, Any], Displayed):
    """Plain data by which `chasles.checker.certificate` derives a statement again."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Correction:
    """What replaces an equation that is wrong as printed: its form, its sides and the verdict on it.

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


@dataclass(frozen=True, slots=True, repr=False)
class Decision(Displayed):
    """The verdict on a statement as printed, its correction if it is wrong, and how long it took.

    `given` says how each statement was used on whose sides it rests, by number and part: "3.96a/1".
    """

    statement: Sentence
    verdict: Verdict
    correction: Correction | None = None
    given: dict[str, Used] = field(default_factory=dict)
    milliseconds: float = 0.0

    def __repr__(self) -> str:
        needs = " " * bool(self.needs) + ", ".join(self.needs)
        return f"<decision on {key_of(self.statement)}: {self.verdict.name}{needs}>"

    @property
    def needs(self) -> tuple[str, ...]:
        """The hypotheses under which it holds as printed."""
        return self.verdict.needs

    @property
    def stands(self) -> bool:
        """Whether the statement is true as printed, or has a correction that is true."""
        return self.verdict.true or (self.correction is not None and self.correction.verdict.true)

    @property
    def sides(self) -> Equation:
        """The sides of what is right: as printed, or of the correction; as printed if none is. Only of an equation."""
        assert isinstance(self.statement, Statement)
        if self.verdict.true or self.correction is None or not self.correction.verdict.true:
            return self.statement.printed
        return self.correction.sides

    @property
    def repaired(self) -> Sentence:
        """The sentence as it would be printed if it were right."""
        if self.verdict.true or not isinstance(self.statement, Statement):
            return self.statement
        return self.statement.saying(*self.sides)

    @property
    def standing(self) -> Verdict:
        """The verdict on what stands: on the correction of an equation that is wrong as printed, if it has one."""
        return self.correction.verdict if self.correction and not self.verdict.true else self.verdict

    @property
    def certificate(self) -> Certificate | None:
        """The certificate of the form that is proved, if one was made."""
        found = getattr(self.standing, "certificate", None) if self.standing.true else None
        return None if found is None else Certificate(found)

    def problem(self, said: Statement | Theorem, in_full: bool) -> Problem:
        """What is said as it is posed, `in_full` given all that it rests on."""
        said = with_all_premises(said, self.accepted) if in_full else said
        return problem_of(said, "printed", self.accepted)

    def accepted(self, given: Statement) -> Equation:
        """The sides with which the decision used a given statement."""
        used = self.given.get(key_of(given, self.statement))
        return default_sides(given) if used is None else used.sides


class Decisions(Several[Decision]):
    """The decisions on what has one number, part by part."""

    __slots__ = ()

    @property
    def verdict(self) -> Verdict:
        """The verdict on the part that is least certain: one that is wrong as printed, else one with needs."""
        return min((each.verdict for each in self), key=lambda said: WORST_FIRST.index(said.name))

    @property
    def needs(self) -> tuple[str, ...]:
        """The hypotheses under which the parts hold."""
        return tuple(dict.fromkeys(need for decision in self for need in decision.needs))

    @property
    def stands(self) -> bool:
        """Whether every part is true as printed, or has a correction that is true."""
        return all(decision.stands for decision in self)


def key_of(statement: Sentence, citing: Sentence | None = None) -> str:
    """The number and the part, "3.96a/1", after the chapter's package where that is not the one of who cites it."""
    home = other_chapter(statement, chapter_of(citing)) if citing is not None else ""
    return f"{home} {statement.number}/{statement.part}".lstrip()
