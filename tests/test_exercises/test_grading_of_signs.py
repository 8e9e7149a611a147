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

from chasles.exact import grading
from chasles.exact.roots import Root
from chasles.exact.sheet import Sheet
from chasles.statements.exercise import Exercise

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
    ("pure-couple", ["pure-couple"], ["pure", "PURE-COUPLE", "couple"]),
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


def marked(module: ModuleType, expected: Any, given: Any, more: dict[str, Any]) -> bool:
    """Whether the only answer of an exercise gets its mark."""

    def solve(sheet: Sheet) -> str:
        sheet.answer(x=expected)
        return "ok"

    asked = Exercise("0.0", "A number", ("Which?",), solve, **more)
    return bool(module.grade(asked, {}, {"x": given}).passed)


@pytest.mark.parametrize(("expected", "given", "right", "more"), MARKS)
def test_an_answer_is_right_or_wrong(expected: Any, given: Any, right: bool, more: dict[str, Any]) -> None:
    assert marked(grading, expected, given, more) is right


@pytest.mark.parametrize("text", [text for text in NUMBERS if "sqrt" in text or "pi" in text])
@pytest.mark.parametrize("digits", [3, 9, 15, 40])
def test_decimals_are_not_what_they_are_near_to(text: str, digits: int) -> None:
    number = sp.sympify(text.replace("^", "**"))
    assert not marked(grading, number, str(sp.Rational(str(number.evalf(digits)))), {})


def test_signs_turn_together_and_nothing_else_does() -> None:
    def solve(sheet: Sheet) -> str:
        sheet.answer(x=sp.sqrt(2), y=sp.sqrt(3), z=sp.sqrt(5))
        return "ok"

    asked = Exercise("0.0", "Numbers", ("Which?",), solve, signs=(("x", "y"),))
    for turns in (("", ""), ("-", "-"), ("", "-"), ("-", "")):
        for turn in ("", "-"):
            given = {"x": f"{turns[0]}sqrt(2)", "y": f"{turns[1]}sqrt(3)", "z": f"{turn}sqrt(5)"}
            assert grading.grade(asked, {}, given).passed is (turns[0] == turns[1] and not turn)


DIFFERENCE = "return value is not None and is_zero(value - turn * expected)"
MATRICES = "equal(expected * turn, value)"
LIST = """all(
                _same(turn, a, b, is_angle) for a, b in zip(expected, value, strict=True)"""
PLACE = "turn == 1 and same_number(expected, value)"
SLIPS = [
    (DIFFERENCE, "return value is not None and is_zero(value**2 - expected**2)"),
    (DIFFERENCE, "return value is not None and is_zero(abs(value) - abs(expected))"),
    (DIFFERENCE, "return value is not None and is_zero(value + turn * expected)"),
    (DIFFERENCE, "return value is not None and is_zero(value - expected)"),
    (DIFFERENCE, "return value is not None and is_zero(value**3 - value * expected**2)"),
    (DIFFERENCE, "return value is not None and is_zero(value**2 - turn * expected * value)"),
    (DIFFERENCE, "return abs(float(value - turn * expected)) < 1e-9"),
    (DIFFERENCE, "return abs(float(value - turn * expected)) < 1e-15 * (1 + abs(float(value)))"),
    (DIFFERENCE, "return sp.N(value, 15) == sp.N(turn * expected, 15)"),
    (DIFFERENCE, "return round(float(value), 3) == round(float(turn * expected), 3)"),
    (DIFFERENCE, "return sp.expand(value).as_coeff_Add()[0] == sp.expand(turn * expected).as_coeff_Add()[0]"),
    (DIFFERENCE, "return value.is_rational is False or is_zero(value - turn * expected)"),
    (DIFFERENCE, "return sp.floor(value) == sp.floor(turn * expected)"),
    (DIFFERENCE, "return sp.sign(value) == sp.sign(turn * expected)"),
    (DIFFERENCE, "return sp.minimal_polynomial(value, X) == sp.minimal_polynomial(turn * expected, X)"),
    (DIFFERENCE, "return value == turn * expected or is_zero(value + turn * expected)"),
    (MATRICES, "equal(expected, value)"),
    (MATRICES, "(equal(expected, value) or equal(-expected, value))"),
    (MATRICES, "equal(expected.applyfunc(abs), value.applyfunc(abs))"),
    (MATRICES, "equal(expected.T * expected, value.T * value)"),
    (MATRICES, "equal(*(sp.Matrix(sorted(entries, key=float)) for entries in (expected * turn, value)))"),
    (MATRICES, "is_zero((expected * turn - value)[0])"),
    (MATRICES, "is_zero(sum(expected * turn - value))"),
    ("normal(value - turn * expected) / (2 * sp.pi)", "normal(value - turn * expected) / sp.pi"),
    ("normal(value - turn * expected) / (2 * sp.pi)", "normal(value + turn * expected) / (2 * sp.pi)"),
    ("bool((normal(value - turn * expected) / (2 * sp.pi)).is_integer)", "is_zero(sp.cos(value) - sp.cos(expected))"),
    ("bool((normal(value - turn * expected) / (2 * sp.pi)).is_integer)", "is_zero(sp.sin(value) - sp.sin(expected))"),
    ("bool((normal(value - turn * expected) / (2 * sp.pi)).is_integer)", "is_zero(value - turn * expected)"),
    ("set(expected) == set(value) and all(", "all("),
    ("set(expected) == set(value) and all(", "set(expected) >= set(value) and any("),
    (f"len(expected) == len(value) and {LIST}", LIST.replace("True", "False")),
    (LIST, LIST.replace("zip(expected, value", "zip(sorted(expected), sorted(value)")),
    ("_same(turn, a, b, is_angle)", "(_same(turn, a, b, is_angle) or _same(-turn, a, b, is_angle))"),
    ("_same(turn, expected[k], value[k], is_angle)", "is_zero(expected[k] ** 2 - value[k] ** 2)"),
    (PLACE, "expected.coefficients == value.coefficients"),
    (PLACE, "abs(float(expected.value - getattr(value, 'value', value))) < 1e-9"),
    ("bool(expected == value)", "bool(str(expected).casefold() == str(value).casefold())"),
    ("bool(expected == value)", "True"),
    ("for name in group}", "for name in group} and {}"),
    ("signs = product((1, -1), repeat=len(exercise.signs))", "signs = [(1,) * len(exercise.signs)]"),
]  # fmt: skip
"""What stands in the grading, and what a slip would make of it."""


@pytest.fixture
def written(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The grading with a slip in it."""
    before, after = request.param
    source = Path(grading.__file__).read_text(encoding="utf-8")
    assert before in source
    slipped = ModuleType("slipped_grading")
    monkeypatch.setitem(sys.modules, slipped.__name__, slipped)
    exec(compile(source.replace(before, after), "slipped_grading", "exec"), slipped.__dict__)
    return slipped


@pytest.mark.parametrize("written", SLIPS, indirect=True)
def test_every_slip_in_the_grading_marks_something_wrong(written: ModuleType) -> None:
    assert any(_judges_otherwise(written, *case) for case in MARKS)


def _judges_otherwise(module: ModuleType, expected: Any, given: Any, right: bool, more: dict[str, Any]) -> bool:
    try:
        return marked(module, expected, given, more) is not right
    except Exception:
        return False
