"""A sample of the fuzzing, by count; and that its oracles notice what is wrong, whoever says it."""

from __future__ import annotations

from collections import Counter
from random import Random
from typing import Any

import pytest
import sympy as sp
from sympy import Eq, Function, cos, exp, sin, sqrt, symbols

from chasles.statements import Claim, Definition, Minimum, Theorem, rotation, unit
from chasles.verdict import Contradictory, Counterexample, Fails, Holds, HoldsUnder
from chasles.vocabulary import dot, norm, number, rate

from .fuzzing import judging, statement_judging
from .fuzzing.__main__ import examined, main
from .fuzzing.asking import Answer
from .fuzzing.classes import CLASSES
from .fuzzing.declared_words import named
from .fuzzing.equations import Equation, points
from .fuzzing.judging import judge
from .fuzzing.languages import LANGUAGES, draw_for
from .fuzzing.motions import CONSTRAINTS, CONTRADICTIONS, SYSTEMS
from .fuzzing.series import Undefined, mpf
from .fuzzing.shrinking import shrunk, smaller
from .fuzzing.statement_judging import judge_statement
from .fuzzing.statements import Asked
from .fuzzing.sympy_values import Values
from .sampling import WHOLE

x, y, t = symbols("x y t")
f, g, th = (Function(name)(t) for name in ("f", "g", "theta"))
SEED = 11
SAMPLE = 20
BATCH = 10
VARIANTS = 20 if WHOLE else 5


PENDING = ("verdict on nothing",)
"""The checker does not yet follow all that is said of functions and of imaginary parts, and an equation that is the
same on both sides is said to hold under equations of motion that contradict each other only once differentiated."""


@pytest.mark.sampled(2)
@pytest.mark.slow
@pytest.mark.parametrize("first", range(0, SAMPLE, BATCH))
@pytest.mark.parametrize("language", sorted(LANGUAGES))
def test_no_answer_in_the_sample_is_wrong(language: str, first: int) -> None:
    counts: Counter[str] = Counter()
    for place in range(first, first + BATCH):
        answer, alarm, question = examined(language, SEED, place)
        assert alarm is None or alarm.kind in PENDING, f"{place}: {question}: {alarm}"
        counts[answer] += 1
    assert counts["fails"]
    assert counts["holds"] + counts["holds-under"]


@pytest.mark.sampled(3)
@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(CLASSES))
def test_no_variant_of_what_was_once_wrong_is_wrong(name: str) -> None:
    for place in range(VARIANTS):
        asked, judged = CLASSES[name](Random(f"{name}/{place}"))
        assert judged.alarm is None or judged.alarm.kind in PENDING, f"{place}: {asked}: {judged}"


# What the oracles would say of answers that are wrong.
WRONG: list[tuple[Equation, Any, str]] = [
    (Equation(x, y), Holds({}, {}), "false holds"),
    (Equation(sin(2 * x), 2 * sin(x)), Holds({}, {}), "false holds"),
    (Equation(x, 1, (Eq(x**2, 1),)), HoldsUnder(("x**2 = 1",), {}, {}), "false holds"),
    (Equation(sqrt(x) * sqrt(y), sqrt(x * y)), Holds({}, {}), "needs incomplete"),
    (Equation(sqrt(x) * sqrt(y), sqrt(x * y)), HoldsUnder(("x >= 0",), {}, {}), "needs incomplete"),
    (Equation(1 / x + y, y + 1 / x), Holds({}, {}), "needs incomplete"),
    (Equation(x, y), Fails(Counterexample({"x": 1, "y": 1}, (1, 1), "1", "1")), "bad counterexample"),
    (Equation(x, y, (Eq(x + y, 1),)), Fails(Counterexample({"x": 1, "y": 1}, (1, 1), "1", "1")), "bad counterexample"),
    (Equation(x, 2, (Eq(2 * x, 4),)), Fails(Counterexample({"x": 1}, (1, 1), "1", "2")), "false fails"),
    (Equation(sqrt(x**2), x, where=(x > -1,)), Holds({}, {}), "false holds"),
    (Equation(sp.sign(x), 1, where=(x >= 0,)), Holds({}, {}), "false holds"),
    (Equation(x, 2, where=(x > 1,)), Fails(Counterexample({"x": 0}, (1, 1), "0", "2")), "bad counterexample"),
    (Equation(x, x, truth=True), Fails(Counterexample({"x": 1}, (1, 1), "1", "2")), "false fails"),
    (
        Equation(f.diff(t, 2), f, (Eq(f.diff(t), f),)),
        Fails(Counterexample({"Derivative(f(t), (t, 2))": 1, "f(t)": 0}, (1, 1), "1", "0")),
        "false fails",
    ),
    (Equation(f.diff(t), 0, (Eq(f**2 + g**2, 1),)), HoldsUnder(("f(t)**2 + g(t)**2 = 1",), {}, {}), "false holds"),
    (Equation(x, x, (Eq(x**2, -1),), satisfiable=False), Holds({}, {}), "verdict on nothing"),
]


@pytest.mark.parametrize(("question", "verdict", "kind"), WRONG, ids=lambda case: str(case)[:50])
def test_a_wrong_answer_is_noticed(
    question: Equation, verdict: Any, kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(judging, "ask", lambda asked: Answer(verdict.name, verdict))
    monkeypatch.setattr(judging, "rejection", lambda asked, said: None)
    alarm = judge(question, Random(0)).alarm
    assert alarm is not None
    assert alarm.kind == kind


e, a1, b = named("vector", "e"), named("vector", "e1", 1), named("vector", "b")
Q = named("square", "Q")
e_turns = (Definition("2", rate(e), a1),)
WRONG_STATEMENTS: list[tuple[Asked, Any, str]] = [
    (Asked(Claim("1", dot(e, e), number(1))), Holds({}, {}), "false holds"),
    (Asked(Claim("1", dot(e, b), number(1), assuming=(unit(e),))), HoldsUnder(("|e| = 1",), {}, {}), "false holds"),
    (
        Asked(Claim("1", dot(e, rate(a1)), -2 * dot(a1, a1), given=e_turns, assuming=(unit(e),))),
        HoldsUnder(("|e| = 1",), {}, {}),
        "false holds",
    ),
    (
        Asked(Claim("1", dot(e, rate(a1)), -dot(a1, a1), given=e_turns, assuming=(unit(e),))),
        Fails(Counterexample({"e_3": 1, "e_1": 0, "e_2": 0, "e1_1": 0, "e1_dot_3": 1}, (1, 1), "1", "0")),
        "false fails",
    ),
    (
        Asked(Claim("1", Q @ e, b, assuming=(rotation(Q),))),
        Fails(Counterexample({"Q_11": 2, "e_1": 0}, (1, 1), "1", "0")),
        "bad counterexample",
    ),
    (
        Asked(Claim("1", Q @ e, e, assuming=(rotation(Q),))),
        Fails(Counterexample({"Q_11": 1, "e_1": 1, "e_2": 0, "e_3": 0}, (1, 1), "1", "0")),
        "bad counterexample",
    ),
    (Asked(Claim("1", e, e, assuming=(unit(e),))), Contradictory(("|e| = 1",)), "false contradictory"),
    (
        Asked(Claim("1", e, e, given=(Definition("2", b, 2 * e),), assuming=(unit(e), unit(b))), satisfiable=False),
        Holds({}, {}),
        "verdict on nothing",
    ),
    (
        Asked(Theorem("1", "", (Minimum(norm(b) ** 2, dot(e, e), b, e, (b,)),))),
        Holds({}, {}),
        "false holds",
    ),
]


@pytest.mark.parametrize(("asked", "verdict", "kind"), WRONG_STATEMENTS, ids=lambda case: str(case)[:40])
def test_a_wrong_decision_is_noticed(asked: Asked, verdict: Any, kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(statement_judging, "ask_statement", lambda said: Answer(verdict.name, verdict))
    monkeypatch.setattr(statement_judging, "statement_rejection", lambda said, it: None)
    alarm = judge_statement(asked, Random(0)).alarm
    assert alarm is not None
    assert alarm.kind == kind


def test_what_is_called_contradictory_is_not_satisfied_anywhere(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(judging, "ask", lambda asked: Answer("contradictory"))
    alarm = judge(Equation(x, 1, (Eq(x**2, 1),)), Random(0)).alarm
    assert alarm is not None
    assert alarm.kind == "false contradictory"
    assert judge(Equation(x, 1, (Eq(x**2, -1),)), Random(0)).alarm is None


def test_a_rejected_certificate_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(judging, "rejection", lambda asked, said: "Rejected: no")
    alarm = judge(Equation(x + y, y + x), Random(0)).alarm
    assert alarm is not None
    assert alarm.kind == "own certificate rejected"


@pytest.mark.sampled(4)
@pytest.mark.parametrize("kind", sorted(SYSTEMS | CONSTRAINTS))
def test_motions_are_found_and_satisfy_what_is_given(kind: str) -> None:
    given, functions = (SYSTEMS | CONSTRAINTS)[kind]
    question = Equation(functions[0].diff(t, 2), functions[0], given)
    found = list(points(question, Random(1), 6))
    assert found
    for item in given:
        one, other = Values(found[0], mpf(0))(item.lhs, 1), Values(found[0], mpf(0))(item.rhs, 1)
        assert max(abs(a - b) for a, b in zip(one, other, strict=True)) < mpf(10) ** -39


@pytest.mark.parametrize("kind", sorted(CONTRADICTIONS))
def test_no_motion_is_found_where_there_is_none(kind: str) -> None:
    given, functions = CONTRADICTIONS[kind]
    assert not list(points(Equation(functions[0], functions[0], given), Random(1), 6))


# Explicit solutions, as expressions of the time.
SOLUTIONS: dict[str, dict[Any, Any]] = {
    "growth": {th: 3 * exp(t)},
    "oscillator": {th: 2 * cos(t) - sin(t)},
    "damped": {th: exp(-t / 2) * cos(sqrt(3) * t / 2)},
    "turning": {f: sin(t), g: cos(t)},
    "riccati": {f: sp.tan(t)},
    "logistic": {f: 1 / (1 + 2 * exp(-t))},
    "circle": {f: cos(t**2), g: sin(t**2)},
    "hyperbola": {f: exp(t), g: exp(-t)},
}


@pytest.mark.parametrize("kind", sorted(SOLUTIONS))
def test_an_explicit_solution_is_a_motion(kind: str) -> None:
    given, functions = (SYSTEMS | CONSTRAINTS)[kind]
    start = sp.Rational(1, 3)
    fixed = {
        (h, k): mpf(str(sp.N(sp.diff(SOLUTIONS[kind][h], t, k).subs(t, start), 60)))
        for h in functions
        for k in range(5)
    }
    question = Equation(functions[0].diff(t), functions[0], given)
    assert list(points(question, Random(0), 1, fixed))
    moved = {place: value + (place == (functions[0], 1)) for place, value in fixed.items()}
    assert not list(points(question, Random(0), 1, moved))


ELEMENTARY = (
    sin(x) * exp(x), cos(x) ** 3, 1 / (2 + x), sqrt(1 + x), (2 + x) ** sp.Rational(-3, 2), sp.log(2 + x), sp.tan(x),
    sp.Abs(x - 3), sp.sign(x - 3) * x, sp.sinh(x), sp.cosh(x), sp.tanh(x), sp.asin(x / 2), sp.acos(x / 2), sp.atan(x),
    sp.sec(x), (1 + x) ** x, sp.Max(x, 1 + x), sp.Piecewise((x**2, x > 1), (x**3, True)), sp.pi * x + sp.E,
)  # fmt: skip
NOWHERE = (1 / x, sqrt(x - 1), sp.log(x), sp.cot(x), sp.acos(x + 2), 1 / (sin(x) ** 2 + cos(x) ** 2 - 1))


@pytest.mark.parametrize("e", ELEMENTARY, ids=str)
def test_series_are_those_of_sympy(e: Any) -> None:
    series = Values({x: [mpf(1) / 3, mpf(1), mpf(0), mpf(0)]}, mpf(0))(e, 3)
    real = sp.Symbol("x", real=True)
    for k, value in enumerate(series):
        rate = sp.diff(e.subs(x, real), real, k).subs(real, sp.Rational(1, 3)).doit()
        assert abs(sp.Float(str(value), 45) - sp.N(rate / sp.factorial(k), 40)) < sp.Rational(1, 10**35)


@pytest.mark.parametrize("e", NOWHERE, ids=str)
def test_where_there_is_no_value_none_is_said(e: Any) -> None:
    with pytest.raises(Undefined):
        Values({x: [mpf(0)]}, mpf(0))(e)


def test_an_alarm_is_shrunk() -> None:
    question = Equation(x * sin(y) + 3 * y**2, x * sin(y) + y, (Eq(x, 3), Eq(y * x, 2)))
    small, tries = shrunk(question, smaller, lambda other: other.lhs.has(y) and any(e.has(x) for e in other.given))
    assert tries < 60
    assert (small.lhs, small.rhs, small.given) == (y, y, (Eq(x, 0, evaluate=False),))


def test_the_same_seed_asks_the_same() -> None:
    for name, language in LANGUAGES.items():
        first, again = (str(language.question(draw_for(name, 3, 5))) for _ in range(2))
        assert first == again


def test_the_command_counts(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--questions", "2", "--seed", "2", "--language", "scalars"]) == 0
    assert "2 questions with seed 2" in capsys.readouterr().out
