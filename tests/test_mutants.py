"""Every claim and theorem with a slip of the pen in it must be refuted, exactly, or be true all the same."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import partial
from itertools import islice

import pytest

from chasles.proof.decide import decide_problem
from chasles.proof.judge import Judge
from chasles.proof.refutation import check_counterexample
from chasles.proof.verdict import Counterexample, Fails, Holds, HoldsUnder, Verdict
from chasles.statements import Chapter, Claim, Goal, Problem, Theorem, load, nonzero, problem_of, unit
from chasles.vocabulary import Misfit, Node, Transpose, cos, cross, dot, norm, number, scalar, sin, square, vector

from .exact_words import Words, number_of
from .explanations import evaluations, explanation
from .mutation import Mutant, mutants_of

SHARE_TO_REFUTE = Fraction(95, 100)
POINTS = 3


@dataclass
class Tally:
    """What became of the mutants."""

    refused: list[str] = field(default_factory=list)
    refuted: Counter[str] = field(default_factory=Counter)
    survivors: list[str] = field(default_factory=list)
    others: list[str] = field(default_factory=list)

    @property
    def decided(self) -> int:
        return self.refuted.total() + len(self.survivors) + len(self.others)

    def lines(self) -> Iterator[str]:
        share = 100 * self.refuted.total() / self.decided
        yield (
            f"{self.decided} mutants: {self.refuted.total()} refuted by a counterexample ({share:.1f} %), "
            f"{len(self.survivors)} true all the same; {len(self.refused)} more do not fit and cannot be written"
        )
        yield "refuted: " + ", ".join(f"{count} {slip}" for slip, count in self.refuted.most_common())
        yield from self.survivors
        yield from (f"UNDECIDED {line}" for line in self.others)


def sentences(chapter: Chapter, judge: Judge) -> Iterator[tuple[Claim | Theorem, str]]:
    """Every claim and theorem that stands, with the form in which it does."""
    for entry in chapter:
        sentence = entry.statement
        if isinstance(sentence, Claim | Theorem):
            decision = judge.decide(sentence)
            stands = decision.repaired
            if decision.stands and isinstance(stands, Claim | Theorem):
                yield stands, "printed"


def problem(sentence: Claim | Theorem, form: str, judge: Judge, refused: list[str]) -> Problem | None:
    """The problem, if the sentence can be written and makes sense."""
    try:
        return problem_of(sentence, form, judge.standing)
    except (Misfit, TypeError) as reason:
        refused.append(str(reason))
        return None


def refute_again(asked: Problem, shown: Counterexample) -> None:
    """The counterexample is right by the package's own checker, and by values that know nothing of it."""
    check_counterexample(asked, shown)
    words = Words(asked, shown.at)
    words.require()
    i, j = shown.entry
    said = number_of(shown.left), number_of(shown.right)
    assert said[0] != said[1]
    goals = [goal for goal in asked.goals if goal.label == shown.goal]
    sides = [words.sides(goal.left, goal.right) for goal in goals]
    assert said in [(left[i - 1][j - 1], right[i - 1][j - 1]) for left, right in sides], shown


def is_symmetric(given: Problem, matrix: Node) -> bool:
    """Whether a matrix is symmetric by what is given, so that it is no slip to transpose it."""
    asked = replace(given, goals=(Goal("", matrix, Transpose(matrix)),))
    return isinstance(decide_problem(asked), Holds | HoldsUnder)


def put_on_trial(mutant: Mutant, original: Problem, judge: Judge, tally: Tally) -> None:
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


@pytest.mark.slow
@pytest.mark.parametrize("half", ["one", "other"])
def test_no_slip_of_the_pen_passes(half: str, record_property: Callable[[str, object], None]) -> None:
    """In two halves, every second statement in each, for two test processes."""
    chapter, judge, tally = load(), Judge(book=load()), Tally()
    for sentence, form in islice(sentences(chapter, judge), half == "other", None, 2):
        original = problem(sentence, form, judge, [])
        assert original is not None
        for mutant in mutants_of(sentence, form, tally.refused, partial(is_symmetric, original)):
            put_on_trial(mutant, original, judge, tally)
    report = "\n".join(tally.lines())
    record_property("report", report)
    assert not tally.others, report
    assert tally.refuted.total() >= SHARE_TO_REFUTE * tally.decided, report


e, a, b = (vector(name, name, name) for name in "eab")
phi, x = (scalar(name, name, name) for name in ("phi", "x"))
M = square("M", "M", "M")


@pytest.mark.parametrize(
    ("claim", "slips"),
    [
        (Claim("1", a + b, b + a), {"sign": 4, "term left out": 4, "letter": 4}),
        (Claim("1", cross(a, b), -cross(b, a)), {"sign": 2, "operands swapped": 2, "letter": 4}),
        (Claim("1", M.T @ a, M @ a), {"sign": 2, "transpose lost": 0, "transpose added": 1}),
        (Claim("1", sin(phi), 2 * cos(phi)), {"sign": 2, "sine and cosine": 2, "number": 2}),
        (Claim("1", norm(a) ** 2, dot(a, a)), {"sign": 2, "exponent": 2}),
        (Claim("1", dot(a, b), number(0)), {"sign": 0, "number": 1, "letter": 2}),
    ],
)
def test_slips_are_made_everywhere(claim: Claim, slips: dict[str, int]) -> None:
    made = Counter(mutant.change.slip for mutant in mutants_of(claim, "printed", []))
    assert {slip: made[slip] for slip in slips} == slips


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
    tally, judge = Tally(), Judge()
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
