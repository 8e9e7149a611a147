"""A mark is given for the number itself: not for its square, its size, its rational part or its first digits.

That the cases here tell these apart is tested too: each slip that is written into the grading marks one of them wrong.
"""

from __future__ import annotations

import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
import sympy as sp

from chasles.exact.polynomial_roots import Root
from chasles.exercises import agreement, grading
from chasles.exercises.data import DataError
from chasles.exercises.worksheet import Worksheet
from chasles.statements.exercise import Answer, Exercise, ListOf, Record, Scalar, Shape, Truth, Word, matrix_shape

NUMBERS = {
    "sqrt(2)": (["sqrt(8)/2", "2/sqrt(2)"], ["-sqrt(2)", "sqrt(2)+1", "sqrt(3)", "2", "0", "sqrt(2)/2"]),
    "-sqrt(2)": (["-sqrt(8)/2"], ["sqrt(2)", "0", "-sqrt(3)"]),
    "3": (["6/2", "3.0", 3], ["-3", -3, "3+sqrt(2)", "9", "1/3", 2]),
    "-1/3": (["-2/6"], ["1/3", "-1/4", "3"]),
    "1+sqrt(2)": (["1/(sqrt(2)-1)"], ["1-sqrt(2)", "sqrt(2)-1", "-1-sqrt(2)", "1", "1+sqrt(3)", "1+2*sqrt(2)"]),
    "sqrt(2)-sqrt(3)": (["1/(-sqrt(2)-sqrt(3))"], ["sqrt(3)-sqrt(2)", "sqrt(2)+sqrt(3)", "sqrt(2)-sqrt(5)", "0"]),
    "sqrt(6)": (["sqrt(2)*sqrt(3)"], ["-sqrt(6)", "sqrt(2)+sqrt(3)", "6"]),
    "sqrt(2+sqrt(3))": (["(sqrt(6)+sqrt(2))/2"], ["-sqrt(2+sqrt(3))", "(sqrt(6)-sqrt(2))/2", "sqrt(2-sqrt(3))"]),
    "pi": (["2*pi/2"], ["-pi", "22/7", "3.14159265358979", "2*pi", "pi+1", "pi^2"]),
    "pi/2-1": (["(pi-2)/2"], ["1-pi/2", "pi/2+1", "pi/2", "-1"]),
    "1/7": (["2/14"], ["0.142857142857142857", "-1/7", "1/8"]),
    "0": (["sqrt(8)-2*sqrt(2)", 0], ["1", "-1", "0.000000000000000000001", "sqrt(2)"]),
    "10^6*sqrt(2)": (["sqrt(2*10^12)"], ["-10^6*sqrt(2)", "1414213.5623730950488"]),
}
"""Numbers, what else they are, and what they are not though a sign, a part, a square or many digits agree."""
CUBIC = (1, 0, -3, 1)
VECTOR = sp.ImmutableMatrix([sp.sqrt(2), -1, 0])
SQUARE = sp.ImmutableMatrix([[1, sp.sqrt(2)], [-sp.sqrt(2), 3]])
OTHERS: list[tuple[Any, list[Any], list[Any]]] = [
    (VECTOR, [["sqrt(8)/2", -1, 0], [["sqrt(2)"], [-1], [0]]],
     [["-sqrt(2)", 1, 0], ["sqrt(2)", 1, 0], ["-sqrt(2)", -1, 0], [-1, "sqrt(2)", 0], ["sqrt(2)", -1, 1], [0, 0, 0]]),
    (SQUARE, [[[1, "sqrt(2)"], ["-sqrt(2)", 3]]],
     [[[1, "-sqrt(2)"], ["sqrt(2)", 3]], [[-1, "-sqrt(2)"], ["sqrt(2)", -3]], [[1, "sqrt(2)"], ["sqrt(2)", 3]],
      [[3, "sqrt(2)"], ["-sqrt(2)", 1]], [["-sqrt(2)", 3], [1, "sqrt(2)"]]]),
    ([sp.sqrt(2), sp.Integer(-1)], [["sqrt(2)", -1]],
     [["-sqrt(2)", 1], ["sqrt(2)", 1], [-1, "sqrt(2)"], ["sqrt(2)"], ["sqrt(2)", -1, -1], []]),
    ({"a": sp.sqrt(2), "b": sp.Integer(-1)}, [{"b": -1, "a": "sqrt(2)"}],
     [{"a": "-sqrt(2)", "b": 1}, {"a": "sqrt(2)", "b": 1}, {"a": "sqrt(2)"}, {"a": -1, "b": "sqrt(2)"},
      {"a": "sqrt(2)", "b": -1, "c": 0}]),
    ("pure-couple", ["pure-couple", "Pure-Couple"], ["pure", "pure-translation", "couple", "pure couple"]),
    (True, [True], [False]),
    (Root(CUBIC, 0), [{"root_of": list(CUBIC), "index": 0}, {"root_of": [-2, 0, 6, -2], "index": 0}],
     [{"root_of": list(CUBIC), "index": 1}, {"root_of": list(CUBIC), "index": 2}, "-1.8793852415718167681082",
      {"root_of": [1, 0, -3, -1], "index": 2}, {"root_of": [1, 0, -3, -1], "index": 0}]),
]  # fmt: skip
ANGLES = {
    "pi/3": (["7*pi/3", "-5*pi/3"], ["-pi/3", "4*pi/3", "2*pi/3", "5*pi/3", "-2*pi/3"]),
    "pi": (["-pi", "3*pi"], ["0", "pi/2"]),
    "1": (["1+2*pi"], ["-1", "1+pi", "7.283185307179586476925", "1-pi"]),
    "0": (["2*pi"], ["pi"]),
}
CASES = [
    *((sp.sympify(text.replace("^", "**")), *both, {}) for text, both in NUMBERS.items()),
    *((*case, {}) for case in OTHERS),
    *((sp.sympify(text), *both, {"turns": ("x",)}) for text, both in ANGLES.items()),
    (sp.sqrt(2), ["-sqrt(2)"], ["sqrt(2)+1", "2"], {"signs": (("x",),)}),
    (VECTOR, [["-sqrt(2)", 1, 0]], [["sqrt(2)", 1, 0], ["-sqrt(2)", -1, 0]], {"signs": (("x",),)}),
]
MARKS = [(x, given, right, more) for x, *both, more in CASES for right, many in zip((True, False), both, strict=True)
         for given in many]  # fmt: skip


def shape_of(expected: Any) -> Shape:
    match expected:
        case bool():
            return Truth()
        case str():
            return Word((expected, "pure-translation"))
        case list():
            return ListOf(Scalar(), 0)
        case dict():
            return Record(tuple(expected), Scalar())
        case sp.MatrixBase():
            return matrix_shape(*expected.shape)
        case _:
            return Scalar()


def marked(module: ModuleType, expected: Any, given: Any, more: dict[str, Any]) -> bool:
    """Whether the only answer of an exercise gets its mark."""

    def solve(sheet: Worksheet) -> str:
        sheet.answer(x=expected)
        return "ok"

    answers = (Answer("x", shape_of(expected), "what is asked for"),)
    asked = Exercise("0.0", "A number", ("Which?",), solve, answers=answers, **more)
    try:
        return bool(module.grade(asked, {}, {"x": given}).passed)
    except DataError:
        return False


@pytest.mark.parametrize(("expected", "given", "right", "more"), MARKS)
def test_an_answer_is_right_or_wrong(expected: Any, given: Any, right: bool, more: dict[str, Any]) -> None:
    assert marked(grading, expected, given, more) is right


@pytest.mark.parametrize("text", [text for text in NUMBERS if "sqrt" in text or "pi" in text])
@pytest.mark.parametrize("digits", [3, 9, 15, 40])
def test_decimals_are_not_what_they_are_near_to(text: str, digits: int) -> None:
    number = sp.sympify(text.replace("^", "**"))
    assert not marked(grading, number, str(sp.Rational(str(number.evalf(digits)))), {})


def test_signs_turn_together_and_nothing_else_does() -> None:
    def solve(sheet: Worksheet) -> str:
        sheet.answer(x=sp.sqrt(2), y=sp.sqrt(3), z=sp.sqrt(5))
        return "ok"

    answers = tuple(Answer(name, Scalar(), "what is asked for") for name in "xyz")
    asked = Exercise("0.0", "Numbers", ("Which?",), solve, signs=(("x", "y"),), answers=answers)
    for turns in (("", ""), ("-", "-"), ("", "-"), ("-", "")):
        for turn in ("", "-"):
            given = {"x": f"{turns[0]}sqrt(2)", "y": f"{turns[1]}sqrt(3)", "z": f"{turn}sqrt(5)"}
            assert grading.grade(asked, {}, given).passed is (turns[0] == turns[1] and not turn)


EXACT = "return is_zero(difference)"
LIST = "_all(agree(one, other, equal) for one, other in zip(expected, given, strict=True))"
DICT = "_all(agree(expected[key], given[key], equal) for key in expected)"
TURNS = "angle - 2 * sp.pi * int(to_int(turns.mid._mpi_[0], round_nearest))"
SLIPS = [
    (EXACT, "return is_zero(other**2 - one**2)"),
    (EXACT, "return is_zero(abs(other) - abs(one))"),
    (EXACT, "return is_zero(other + one)"),
    (EXACT, "return is_zero(other**3 - other * one**2)"),
    (EXACT, "return is_zero(other**2 - one * other)"),
    (EXACT, "return abs(float(difference)) < 1e-9"),
    (EXACT, "return abs(float(difference)) < 1e-15 * (1 + abs(float(other)))"),
    (EXACT, "return sp.N(other, 15) == sp.N(one, 15)"),
    (EXACT, "return round(float(other), 3) == round(float(one), 3)"),
    (EXACT, "return sp.expand(other).as_coeff_Add()[0] == sp.expand(one).as_coeff_Add()[0]"),
    (EXACT, "return other.is_rational is False or is_zero(difference)"),
    (EXACT, "return sp.floor(other) == sp.floor(one)"),
    (EXACT, "return sp.sign(other) == sp.sign(one)"),
    (EXACT, "return sp.minimal_polynomial(other, sp.Symbol('x')) == sp.minimal_polynomial(one, sp.Symbol('x'))"),
    (EXACT, "return other == one or is_zero(other + one)"),
    (EXACT, "return other == one"),
    (EXACT, "return None"),
    (LIST, "_all([agree(one, other, equal) for one, other in zip(expected, given)][:1])"),
    (LIST, "any(agree(one, other, equal) for one, other in zip(expected, given))"),
    (LIST, LIST.replace("expected, given", "sorted(expected, key=str), sorted(given, key=str)")),
    (LIST, LIST.replace("agree(", "agree(opposite(one), other, equal) or agree(")),
    (LIST, "is_zero(sum(one - other for one, other in zip(expected, given)))"),
    (DICT, "any(agree(expected[key], given[key], equal) for key in expected)"),
    (DICT, "_all(is_zero(expected[key] ** 2 - given[key] ** 2) for key in expected)"),
    (TURNS, "angle"),
    (TURNS, "sp.sin(angle)"),
    (TURNS, "sp.sin(angle / 4)"),
    (TURNS, "angle - 4 * sp.pi * int(to_int(turns.mid._mpi_[0], round_nearest))"),
    ("_without_turns(other - one)", "_without_turns(other + one)"),
    ("_without_turns(other - one) if self._is_angle else other - one", "_without_turns(other - one)"),
    ("bool(expected == given)", "bool(str(expected)[:4] == str(given)[:4])"),
    ("bool(expected == given)", "True"),
    ("return value.value", "return Root(value.coefficients, 1).value"),
    ("return -value if", "return value if"),
    ("[opposite(part) for part in value]", "value"),
    ("for name in group if name in expected}]", "for name in group[1:]}]"),
    ("for group in self.exercise.signs:", "for group in (*self.exercise.signs, ('x',)):"),
    ("for group in self.exercise.signs:", "for group in ():"),
]  # fmt: skip
"""What stands in the grading, and what a slip would make of it."""


@pytest.fixture
def written(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The grading with a slip in it, or in what it rests on."""
    before, after = request.param
    sources = [Path(module.__file__).read_text("utf-8") for module in (agreement, grading)]
    assert any(before in source for source in sources)
    names = ["slipped_agreement", "slipped_grading"]
    for name, source in zip(names, sources, strict=True):
        slipped = ModuleType(name)
        monkeypatch.setitem(sys.modules, name, slipped)
        whole = source.replace(before, after).replace("from chasles.exercises.agreement", f"from {names[0]}")
        exec(compile(whole, name, "exec"), slipped.__dict__)
    return sys.modules[names[1]]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("written", SLIPS, indirect=True)
def test_every_slip_in_the_grading_marks_something_wrong(written: ModuleType) -> None:
    assert any(_judges_otherwise(written, *case) for case in MARKS)


def _judges_otherwise(module: ModuleType, expected: Any, given: Any, right: bool, more: dict[str, Any]) -> bool:
    try:
        return marked(module, expected, given, more) is not right
    except Exception:
        return False
