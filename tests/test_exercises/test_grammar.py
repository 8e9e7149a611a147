"""Data are read by a small grammar; whatever else a text says is refused, by name and place."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import pytest
import sympy as sp

from chasles.exact.grammar import NotANumber, read_number
from chasles.exact.numbers import is_zero, normal
from chasles.exact.spelling import text_of
from chasles.exercises.data import DataError, read_json
from chasles.exercises.solving import solve

from .test_numbers import nested


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("12", sp.Integer(12)),
        (" 1/3 ", sp.Rational(1, 3)),
        ("0.1", sp.Rational(1, 10)),
        (".5", sp.Rational(1, 2)),
        ("5.", sp.Integer(5)),
        ("-2^2", sp.Integer(-4)),
        ("2^3^2", sp.Integer(512)),
        ("2**-2", sp.Rational(1, 4)),
        ("2*-3", sp.Integer(-6)),
        ("1-2-3", sp.Integer(-4)),
        ("8/4/2", sp.Integer(1)),
        ("sqrt(2)/2", sp.sqrt(2) / 2),
        ("pi/4", sp.pi / 4),
        ("cos(pi/3)", sp.Rational(1, 2)),
        ("atan(1)", sp.pi / 4),
        ("arccos(0)", sp.pi / 2),
        ("cot(pi/4) + sec(0) + csc(pi/2)", sp.Integer(3)),
        ("acot(1) + asec(2) + acsc(2)", 3 * sp.pi / 4),
        ("(1+sqrt(5))^64/2^64", ((1 + sp.sqrt(5)) / 2) ** 64),
    ],
)
def test_numbers(text: str, expected: sp.Expr) -> None:
    assert is_zero(read_number(text) - expected)


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("", 1),
        ("__import__('os').system('true')", 1),
        ("().__class__", 3),
        ("lambda: 0", 7),
        ("exec(1)", 1),
        ("x", 1),
        ("1e5", 2),
        ("1 2", 3),
        ("(1+", 4),
        ("1)", 2),
        ("sqrt 2", 6),
        ("sqrt(-1)", 1),
        ("asin(2)", 1),
        ("tan(pi/2)", 1),
        ("2^65", 3),
        ("2^(1/2)", 3),
        ("2^pi", 3),
        ("1/0", 2),
        ("1/(sqrt(2)*sqrt(3) - sqrt(6))", 2),
        ("0^-1", 2),
        ("((2^64)^64)^64", 8),
        ("1,5", 2),
        ("π", 1),
        ("1" * 201, 201),
    ],
)
def test_what_is_not_a_number_is_named_with_its_place(text: str, place: int) -> None:
    with pytest.raises(NotANumber, match=f"at character {place}$") as caught:
        read_number(text)
    assert caught.value.place == place


@pytest.mark.parametrize("seed", range(40))
def test_what_is_written_is_read_back(seed: int) -> None:
    value = normal(nested(Random(seed), 3))
    assert is_zero(read_number(text_of(value)) - value)


def test_towers_of_powers_and_brackets_end() -> None:
    with pytest.raises(NotANumber):
        read_number("(" * 100 + "2^64" + ")^64" * 20)
    assert read_number("(" * 90 + "1" + ")" * 90) == 1


def test_the_square_of_what_may_be_written_is_read() -> None:
    digits = "9" * 1900
    assert read_number(f"sqrt(({digits})^2)", 2000) == int(digits)
    with pytest.raises(NotANumber):
        read_number(f"({digits})^8", 2000)


@pytest.mark.parametrize("entry", ["__import__('os')", "exit()", "open('f','w')", "9**9**9**9"])
def test_code_in_a_data_file_is_refused(entry: str) -> None:
    with pytest.raises(DataError, match=r"^a\[3\]: .*at character \d+$"):
        solve("3.7", a=[1, 0, entry])


@pytest.mark.parametrize(
    ("raw", "expected"), [(0.1, "1/10"), (2.5e-3, "1/400"), (Fraction(2, 3), "2/3"), (7, "7"), (sp.sqrt(2), "sqrt(2)")]
)
def test_python_numbers_are_read_as_they_show(raw: object, expected: str) -> None:
    assert text_of(solve("3.5", pi=[1, 0, 0, 0, raw, 0]).answers["d"]) == expected


@pytest.mark.parametrize(
    ("text", "match"),
    [
        ("[1]", "an object with keys"),
        ("{", "not JSON: .* line 1, column 2"),
        ('{"a": NaN}', "NaN is not a number"),
        ('{"a": 1, "a": 2}', "'a' is given twice"),
        ('{"a": ' + "[" * 100000 + "]" * 100000 + "}", "nested too deeply|not JSON"),
        ('{"a": ' + "1" * 5000 + "}", "at most 200 characters"),
    ],
)
def test_malformed_files_are_refused(text: str, match: str) -> None:
    with pytest.raises(DataError, match=match):
        read_json(text)


@pytest.mark.parametrize(
    ("data", "match"),
    [
        ({"q": 1}, "no datum 'q'; it takes a, b, nA, nB"),
        ({"nAA": [1, 0, 0]}, "near it: nA"),
        ({"a": [1, 0]}, "a: expected a list of 3 numbers, and got 2 of them"),
        ({"a": "1"}, "a: expected a list of 3 numbers, and got '1'"),
        ({"a": [1, 0, True]}, r"a\[3\]: expected a number, and got True"),
        ({"a": [1, 0, None]}, r"a\[3\]: expected a number, and got None"),
        ({"a": [1, 0, float("nan")]}, r"a\[3\]: expected a number"),
        ({"a": [1, 0, float("inf")]}, r"a\[3\]: expected a number"),
        ({"a": {"x": 1}}, "a: expected a list of 3 numbers"),
        ({"a": [1, 0, "5 mm"]}, r"a\[3\]: '5 mm': expected the end.*at character 3"),
    ],
)
def test_malformed_data_are_named(data: dict, match: str) -> None:
    with pytest.raises(DataError, match=match):
        solve("3.7", **data)
