"""Derivations carried out: each step with its result, the reason, and the verdict on it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import replace as with_fields

from chasles.decisions.session import Session
from chasles.deriving.comparing import PrintComparison, compare
from chasles.deriving.state import Equation, State
from chasles.deriving.steps import StepResult, carry_out
from chasles.display import Displayed
from chasles.problems.divisors import UndeclaredDivisor
from chasles.problems.variables import Untreatable
from chasles.repairs.residues import SingularResidue, Unsampled
from chasles.statements import Statement
from chasles.statements.derivation import Ansatz, Compare, Consider, Derivation, DerivationStep, FactorOut, Solve, Take
from chasles.verdict import IllFormed, Undecided, Verdict
from chasles.vocabulary import Misfit, Symbol

STUCK = (Misfit, TypeError, ValueError, LookupError, Untreatable, UndeclaredDivisor, SingularResidue, Unsampled)
"""Why a step cannot be carried out: words that do not fit, nothing to work on, no such combination."""


@dataclass(frozen=True, slots=True)
class CheckedStep:
    """A step that was carried out: its kind and reason, the equations after it, the verdict, the comparison."""

    kind: str
    reason: str
    equations: tuple[Equation, ...]
    verdict: Verdict
    comparison: PrintComparison | None = None


@dataclass(frozen=True, slots=True, repr=False)
class CheckedDerivation(Displayed):
    """A derivation that was carried out, up to the first step that is not true."""

    derivation: Derivation
    steps: tuple[CheckedStep, ...]

    def __repr__(self) -> str:
        came = "complete" if self.arrives else "stops"
        return f"<derivation of {self.derivation.number}: {came} after {len(self.steps)}>"

    def __str__(self) -> str:
        return self._repr_text_()

    @property
    def arrives(self) -> bool:
        """Whether every step is true and every comparison was decided, down to the last."""
        return len(self.steps) == len(self.derivation.steps) and all(map(_goes_on, self.steps))

    @property
    def comparisons(self) -> tuple[PrintComparison, ...]:
        """The comparisons with the printed equations, in the order of the steps."""
        return tuple(p.comparison for p in self.steps if p.comparison is not None)

    @property
    def differences(self) -> tuple[PrintComparison, ...]:
        """Where what was found is not what is printed."""
        return tuple(c for c in self.comparisons if c.form != "printed")


def walk(derivation: Derivation, session: Session) -> CheckedDerivation:
    """The derivation carried out; the first step that is not true, or cannot be made, is its last."""
    checked = CheckedDerivation(derivation, tuple(_checked_steps(derivation, State(derivation, session))))
    # A combination remembered from an earlier run is a conjecture: where it leads astray, all is done again without it.
    return walk(derivation, session) if not checked.arrives and session.memory.forget_conjectures() else checked


def _checked_steps(derivation: Derivation, state: State) -> Iterator[CheckedStep]:
    for step in derivation.steps:
        checked = _checked(step, state)
        yield checked
        if not _goes_on(checked):
            return


def _goes_on(checked: CheckedStep) -> bool:
    """Whether the derivation goes on: after a true step, and after a comparison that was decided either way."""
    if checked.comparison is not None:
        return not isinstance(checked.comparison.printed, Undecided)
    return checked.verdict.true


def _checked(step: DerivationStep, state: State) -> CheckedStep:
    try:
        if isinstance(step, Compare):
            return _compared(step, state)
        outcome = carry_out(step, state)
    except STUCK as error:
        said = str(error)
        verdict = IllFormed(said) if isinstance(error, Misfit | UndeclaredDivisor) else Undecided(said)
        return CheckedStep(step.kind, said, state.equations, verdict)
    _move_on(step, state, outcome)
    return CheckedStep(step.kind, outcome.reason, outcome.equations, outcome.verdict)


def _move_on(step: DerivationStep, state: State, outcome: StepResult) -> None:
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


def _compared(step: Compare, state: State) -> CheckedStep:
    comparison = compare(step, state)
    statement = step.statement
    state.found[id(statement)] = _as_found(statement, comparison)
    if step.free and comparison.form is not None:
        before = dict(zip((left for left, _ in state.equations), state.equations, strict=True))
        before[comparison.found[0]] = comparison.found
        state.equations = tuple(before.values())
    said = f"{state.cited(statement)}: {comparison.words}"
    return CheckedStep(step.kind, said, (comparison.found,), comparison.verdict, comparison)


def _as_found(statement: Statement, comparison: PrintComparison) -> Statement:
    """The statement as it was found, with which the derivation goes on."""
    left, right = comparison.found
    return with_fields(statement, left=left, right=right, reading=None, corrected=None, kernel=None)
