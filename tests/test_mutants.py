"""Every claim and theorem with a slip of the pen in it must be refuted, exactly, or be true all the same."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import islice

import pytest

from chasles.checker.refutation import check_counterexample
from chasles.decisions.session import Session
from chasles.prover.decide import decide_problem
from chasles.statements import Chapter, Claim, Problem, Statement, Theorem, load, nonzero, problem_of, unit
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder, Verdict
from chasles.vocabulary import Misfit, Symbol, cos, dot, scalar, symbols_of, vector

from .decided import chapter_session
from .exact_words import number_of
from .explanations import completions, evaluations, explanation
from .meaning import Meaning
from .mutation import Mutant, mutants_of
from .sampling import WHOLE
from .slips import without_marks

SHARE_TO_REFUTE = Fraction(98, 100)
POINTS = 3
ASKED = os.environ.get("CHASLES_MUTANTS_EVERY", "1" if WHOLE else "")
EVERY, EVERY_STATEMENT = (int(ASKED), 1) if ASKED else (11, 23)
"""One mutant of a statement in so many is put on trial, from another one on for each statement; 1 is all of them.

Unless that is asked for, one statement in so many is taken."""


@dataclass
class Tally:
    """What became of the mutants."""

    refused: list[str] = field(default_factory=list)
    refuted: Counter[str] = field(default_factory=Counter)
    alike: list[Mutant] = field(default_factory=list)
    survivors: list[str] = field(default_factory=list)
    others: list[str] = field(default_factory=list)

    @property
    def decided(self) -> int:
        return self.refuted.total() + len(self.survivors) + len(self.others)

    def lines(self) -> Iterator[str]:
        share = 100 * self.refuted.total() / self.decided
        yield (
            f"{self.decided} mutants: {self.refuted.total()} refuted by a counterexample ({share:.1f} %), "
            f"{len(self.survivors)} true all the same; {len(self.refused)} more do not fit and cannot be written, "
            f"{len(self.alike)} say the same in other words and are none"
        )
        yield "refuted: " + ", ".join(f"{count} {slip}" for slip, count in self.refuted.most_common())
        yield from self.survivors
        yield from (f"UNDECIDED {line}" for line in self.others)


def sentences(chapter: Chapter, judge: Session) -> Iterator[tuple[Claim | Theorem, str]]:
    """Every claim and theorem that stands, with the form in which it does."""
    for entry in chapter:
        sentence = entry.statement
        if isinstance(sentence, Claim | Theorem):
            decision = judge.decide(sentence)
            stands = decision.repaired
            if decision.stands and isinstance(stands, Claim | Theorem):
                yield stands, "printed"


def problem(sentence: Claim | Theorem, form: str, judge: Session, refused: list[str]) -> Problem | None:
    """The problem, if the sentence can be written and makes sense."""
    try:
        return problem_of(sentence, form, judge.accepted)
    except (Misfit, TypeError) as reason:
        refused.append(str(reason))
        return None


def refute_again(asked: Problem, shown: Counterexample) -> None:
    """The counterexample is right by the package's own checker, and by values that know nothing of it."""
    check_counterexample(asked, shown)
    words = next(completions(asked, shown))
    i, j = shown.entry
    said = number_of(shown.left), number_of(shown.right)
    assert said[0] != said[1]
    goals = [goal for goal in asked.goals if goal.label == shown.goal]
    sides = [words.sides(goal.left, goal.right) for goal in goals]
    assert said in [(left[i - 1][j - 1], right[i - 1][j - 1]) for left, right in sides], shown


def put_on_trial(mutant: Mutant, original: Problem, judge: Session, tally: Tally) -> None:
    asked = problem(mutant.statement, "printed", judge, tally.refused)
    if asked is None:
        return
    verdict = decide_problem(asked, mutant.statement.assuming)
    match verdict:
        case Fails(counterexample):
            refute_again(asked, counterexample)
            tally.refuted[mutant.change.slip] += 1
        case Holds() | HoldsUnder():
            values = list(evaluations(asked, POINTS))
            assert values, f"{mutant} is said to hold, and no point was found at which to look"
            assert all(values), f"{mutant} is said to hold, and does not"
            tally.survivors.append(f"{mutant}: {explanation(original, asked)}")
        case _:
            tally.others.append(f"{mutant}: {verdict.name}: {getattr(verdict, 'reason', '')}")


def letters_of(chapter: Chapter) -> dict[str, Symbol]:
    """The letters of the chapter by name."""
    statements = [entry.statement for entry in chapter if isinstance(entry.statement, Statement)]
    return {symbol.name: symbol for each in statements for side in each.printed for symbol in symbols_of(side)}


def symbols_in(asked: Problem) -> set[Symbol]:
    """The letters in what is asked."""
    return {symbol for goal in asked.goals for side in (goal.left, goal.right) for symbol in symbols_of(side)}


def confirm_alike(alike: list[Mutant], judge: Session) -> None:
    """What says the same as a true statement is true: neither the values at points nor the prover miss a difference."""
    for mutant in alike:
        asked = problem(mutant.statement, "printed", judge, [])
        if asked is not None:
            assert isinstance(decide_problem(asked, mutant.statement.assuming), Holds | HoldsUnder), str(mutant)


@pytest.mark.slow
@pytest.mark.parametrize("half", ["one", "other"])
def test_no_slip_of_the_pen_passes(half: str, record_property: Callable[[str, object], None]) -> None:
    """In two halves, every second statement in each, for two test processes: a share in each is one in the whole."""
    chapter, judge, tally = load(), chapter_session(), Tally()
    letters = letters_of(chapter)
    mine = islice(sentences(chapter, judge), half == "other", None, 2)
    for place, (sentence, form) in enumerate(islice(mine, 0, None, EVERY_STATEMENT)):
        original = problem(sentence, form, judge, [])
        assert original is not None
        marked = without_marks(symbols_in(original), letters)
        meaning = Meaning.of(original, marked.values())
        mutants = mutants_of(sentence, form, tally.refused, meaning, letters, tally.alike)
        for mutant in islice(mutants, place % EVERY, None, EVERY):
            put_on_trial(mutant, original, judge, tally)
    confirm_alike(tally.alike, judge)
    report = "\n".join(tally.lines())
    record_property("report", report)
    assert not tally.others, report
    assert tally.refuted.total() >= SHARE_TO_REFUTE * tally.decided, report


e, a = (vector(name, name, name) for name in "ea")
phi, x = (scalar(name, name, name) for name in ("phi", "x"))


def test_what_a_slip_divides_by_is_not_zero() -> None:
    claim = Claim("1", x / (1 - cos(phi)), x / (1 - cos(phi)), assuming=(nonzero(1 - cos(phi)),))
    made = {
        str(m): decide_problem(problem_of(m.statement), m.statement.assuming) for m in mutants_of(claim, "printed", [])
    }
    assert all(isinstance(verdict, Fails) for verdict in made.values()), made


def test_a_lenient_prover_would_be_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    """A prover that says of everything that it holds does not get past the values."""
    claim = Claim("1", dot(e, e) * a, a, assuming=(unit(e),))
    original = problem_of(claim)
    tally, judge = Tally(), Session()
    honest = decide_problem(original, claim.assuming)

    def lenient(asked: Problem, own: object = (), budget: float = 1.0) -> Verdict:
        return honest

    monkeypatch.setitem(put_on_trial.__globals__, "decide_problem", lenient)
    mutants = [m for m in mutants_of(claim, "printed", tally.refused) if m.change.slip == "sign"]
    assert len(mutants) == 2
    for mutant in mutants:
        with pytest.raises(AssertionError, match="is said to hold, and does not"):
            put_on_trial(mutant, original, judge, tally)


def test_a_wrong_counterexample_would_be_noticed() -> None:
    claim = Claim("1", dot(e, e) * a, 2 * a, assuming=(unit(e),))
    asked = problem_of(claim)
    verdict = decide_problem(asked, claim.assuming)
    assert isinstance(verdict, Fails)
    shown = verdict.counterexample
    refute_again(asked, shown)
    for wrong in (
        Counterexample({**shown.at, "e_1": Fraction(7)}, shown.entry, shown.left, shown.right, shown.goal),
        Counterexample(shown.at, shown.entry, shown.right, shown.left, shown.goal),
        Counterexample(shown.at, shown.entry, shown.left, shown.left, shown.goal),
    ):
        with pytest.raises((AssertionError, ValueError)):
            refute_again(asked, wrong)
