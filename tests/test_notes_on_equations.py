"""What a person says of single equations: role, what is defined, and the premises that count."""

from __future__ import annotations

import re

import pytest

import chasles
from chasles.reading.notation_file import BadNotation

LETTERS = r"""
[operators]
skew = '\tilde{#}'
[symbols]
'a|b|c|p' = "vector"
'e' = "unit vector"
'Q' = "rotation"
'x|y' = "scalar"
"""
PAGE = r"""
$$c = a \times b \quad (1)$$
$$a \cdot p = x \quad (2)$$
$$c = p \quad (3)$$
$$a \cdot c = 0 \quad (4)$$
$$x = 0 \quad (5)$$
$$b \cdot p = y \quad (6)$$
"""


def verdicts(notes: str, page: str = PAGE) -> dict[str, str]:
    found = chasles.read(page, LETTERS + "\n[equations]\n" + notes)
    return {each.number: each.verdict for each in found.equations}


def told(notes: str, number: str) -> tuple[str, ...]:
    found = chasles.read(PAGE, LETTERS + "\n[equations]\n" + notes)
    return next(getattr(each.finding.verdict, "needs", ()) for each in found.equations if each.number == number)


def test_what_is_given_counts_and_nothing_else() -> None:
    assert verdicts("")["4"] == "holds"
    assert verdicts("'4' = { given = [] }")["4"] == "fails"
    assert verdicts("'4' = { given = ['1'] }")["4"] == "holds"
    assert verdicts("'4' = { given = ['2'] }")["4"] == "fails"
    assert verdicts("'4' = { given = ['1', '2', '3'] }")["4"] == "holds"


def test_what_is_given_and_not_proved_is_told() -> None:
    assert verdicts("'5' = { given = ['1', '2', '3'] }")["5"] == "holds-under"
    assert told("'5' = { given = ['1', '2', '3'] }", "5") == ("(3)",)
    assert told(r"'5' = { given = ['2', 'p = a \times b'] }", "5") == ("p = a x b",)


def test_what_is_given_may_come_later_or_be_a_part() -> None:
    assert verdicts("'2' = { given = ['1', '3', '5'] }")["2"] == "holds-under"
    page = r"""$$p = e = a \quad (1)$$ $$p \cdot p = 1 \quad (2)$$"""
    assert verdicts("'2' = { given = ['1/1'] }", page)["2"] == "holds-under"
    assert verdicts("'2' = { given = ['1/2'] }", page)["2"] == "fails"


def test_what_is_given_twice_of_a_letter_restricts_the_others() -> None:
    page = r"""$$p = a \quad (1)$$ $$p = b \quad (2)$$ $$a = b \quad (3)$$"""
    assert verdicts("'3' = { given = ['1', '2'] }", page)["3"] == "holds-under"


def test_what_nothing_satisfies_proves_nothing() -> None:
    assert verdicts(r"'4' = { given = ['x = 1', 'x = 0'] }")["4"] in ("open", "contradictory")


def test_a_law_on_no_letter_is_one_that_nothing_satisfies() -> None:
    assert verdicts("'1' = { role = 'law' }", "$$2 + 2 = 5 \\quad (1)$$")["1"] in ("contradictory", "undecided")


def test_a_person_says_what_is_defined() -> None:
    page = r"""$$a = b \quad (1)$$ $$b \times a = 0 \quad (2)$$"""
    for letter in ("a", "b"):
        found = chasles.read(page, LETTERS + f"\n[equations]\n'1' = {{ role = 'definition', of = '{letter}' }}")
        assert str(found.equations[0].finding.statement.left) == letter
        assert found.equations[1].verdict == "holds"


@pytest.mark.parametrize(
    ("note", "said"),
    [
        ("'4' = 'law'", "[equations] '4': expected a table, such as { role = 'law' }"),
        ("'4' = { rol = 'law' }", "[equations] '4' has no 'rol'; near it: role: it takes role, of, given, reading"),
        ("'4' = { role = 'lwa' }", "[equations] '4' role has no 'lwa'; near it: law"),
        ("'4' = { given = '1' }", "[equations] '4' given: expected a list of numbers, or of equations in LaTeX"),
        ("'4' = { given = ['17'] }", "[equations] '4' given '17': expected an equation, and no relation stands in it"),
        ("'4' = { given = ['1/7'] }", "[equations] '4' given '1/7'"),
        (r"'4' = { given = ['a < b'] }", "< is no sign of an equation"),
        ("'4' = { of = 'c' }", "[equations] '4' of: only a definition is of something: say role = 'definition'"),
        (r"'1' = { role = 'definition', of = 'a \times b' }", "expected a letter alone"),
        ("'1' = { role = 'definition', of = 'x' }", "[equations] '1' of 'x': it stands alone on no side"),
    ],
)
def test_what_cannot_be_said_of_an_equation(note: str, said: str) -> None:
    with pytest.raises(BadNotation, match=re.escape(said)):
        verdicts(note)
