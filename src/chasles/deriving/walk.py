"""The walk: step after step, each with what it makes, why, and whether that is true."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import replace as with_fields

from chasles.decisions.session import Session
from chasles.deriving.comparing import PrintComparison, compare
from chasles.deriving.state import Equation, State, cited
from chasles.deriving.steps import StepResult, carry_out
from chasles.display import Displayed
from chasles.problems.unfold import UndeclaredDivisor
from chasles.problems.variables import Untreatable
from chasles.repairs.residues import SingularResidue, Unsampled
from chasles.statements import Statement
from chasles.statements.derivation import (
    Ansatz,
    Compare,
    Consider,
    Derivation,
    FactorOut,
    Solve,
    Step,
    Take,
)
from chasles.verdict import IllFormed, Undecided, Verdict
from chasles.vocabulary import Misfit, Symbol

__all__ = ["Passage", "Road", "walk"]

STUCK = (Misfit, TypeError, ValueError, LookupError, Untreatable, UndeclaredDivisor, SingularResidue, Unsampled)
"""Why a step cannot be carried out: words that do not fit, nothing to work on, no such combination."""


@dataclass(frozen=True, slots=True)
class Passage:
    """A step that was made: what kind, why, the equations after it, the verdict on it; what came of a comparison."""

    kind: str
    reason: str
    equations: tuple[Equation, ...]
    verdict: Verdict
    comparison: PrintComparison | None = None


@dataclass(frozen=True, slots=True, repr=False)
class Road(Displayed):
    """A derivation that was walked, as far as it went: it ends at the first step that is not true."""

    derivation: Derivation
    passages: tuple[Passage, ...]

    def __repr__(self) -> str:
        return (
            f"<road to {self.derivation.number}: {'arrives' if self.arrives else 'stops'} after {len(self.passages)}>"
        )

    def __str__(self) -> str:
        return self._repr_text_()

    @property
    def arrives(self) -> bool:
        """Whether every step is true and every comparison was decided, down to the last."""
        return len(self.passages) == len(self.derivation.steps) and all(map(_passable, self.passages))

    @property
    def comparisons(self) -> tuple[PrintComparison, ...]:
        return tuple(p.comparison for p in self.passages if p.comparison is not None)

    @property
    def differences(self) -> tuple[PrintComparison, ...]:
        """Where what was found is not what is printed."""
        return tuple(c for c in self.comparisons if c.form != "printed")


def walk(derivation: Derivation, judge: Session) -> Road:
    """The road of a derivation; the first step that is not true, or cannot be made, is its last."""
    road = Road(derivation, tuple(_passages(derivation, State(derivation, judge))))
    # What another time took for a combination is decided step by step; where it was none, the road is walked without.
    return walk(derivation, judge) if not road.arrives and judge.memory.forget_conjectures() else road


def _passages(derivation: Derivation, state: State) -> Iterator[Passage]:
    for step in derivation.steps:
        passage = _passage(step, state)
        yield passage
        if not _passable(passage):
            return


def _passable(passage: Passage) -> bool:
    """A comparison lets the road go on if it was decided, whatever came of it."""
    if passage.comparison is not None:
        return not isinstance(passage.comparison.printed, Undecided)
    return passage.verdict.true


def _passage(step: Step, state: State) -> Passage:
    try:
        if isinstance(step, Compare):
            return _compared(step, state)
        outcome = carry_out(step, state)
    except STUCK as error:
        said = str(error)
        verdict = IllFormed(said) if isinstance(error, Misfit | UndeclaredDivisor) else Undecided(said)
        return Passage(step.kind, said, state.equations, verdict)
    _move_on(step, state, outcome)
    return Passage(step.kind, outcome.reason, outcome.equations, outcome.verdict)


def _move_on(step: Step, state: State, outcome: StepResult) -> None:
    state.equations = outcome.equations
    if state.solved and [left for left, _ in outcome.equations] == [left for left, _ in state.solved]:
        state.solved = outcome.equations
    match step:
        case Ansatz():
            state.ansatz = step
        case Solve() | FactorOut(named=Symbol()):
            state.solved = outcome.equations
        case Take() | Consider():
            state.ansatz = None


def _compared(step: Compare, state: State) -> Passage:
    comparison = compare(step, state)
    statement = step.statement
    state.found[id(statement)] = _as_found(statement, comparison)
    if step.free and comparison.form is not None:
        before = dict(zip((left for left, _ in state.equations), state.equations, strict=True))
        before[comparison.found[0]] = comparison.found
        state.equations = tuple(before.values())
    said = f"{cited(statement)}: {comparison.words}"
    return Passage(step.kind, said, (comparison.found,), comparison.verdict, comparison)


def _as_found(statement: Statement, comparison: PrintComparison) -> Statement:
    """The statement that the road goes on with: what was found, in the statement's place."""
    left, right = comparison.found
    return with_fields(statement, left=left, right=right, reading=None, corrected=None, kernel=None)
