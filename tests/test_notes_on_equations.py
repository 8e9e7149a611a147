"""What a person says of single equations: role, what is defined, and the premises that count."""

from __future__ import annotations

import re

import pytest

import chasles
from chasles.reading.letter_table import BadNotation

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


def kinds(notes: str, page: str) -> list[str]:
    return [each.verdict for each in chasles.read(page, LETTERS + "\n[equations]\n" + notes).equations]


def told(notes: str, number: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What a relation needs, and what is given of it."""
    found = chasles.read(PAGE, LETTERS + "\n[equations]\n" + notes)
    finding = next(each.finding for each in found.equations if each.number == number)
    return getattr(finding.verdict, "needs", ()), finding.given


def test_what_is_given_counts_and_nothing_else() -> None:
    assert verdicts("")["4"] == "holds"
    assert verdicts("'4' = { given = [] }")["4"] == "fails"
    assert verdicts("'4' = { given = ['1'] }")["4"] == "holds"
    assert verdicts("'4' = { given = ['2'] }")["4"] == "fails"
    assert verdicts("'4' = { given = ['1', '2', '3'] }")["4"] == "holds"


def test_what_is_given_is_told_and_needed_no_more() -> None:
    assert verdicts("'5' = { given = ['1', '2', '3'] }")["5"] == "holds"
    assert told("'5' = { given = ['1', '2', '3'] }", "5") == ((), ("(1)", "(2)", "(3)"))
    assert told(r"'5' = { given = ['2', 'p = a \times b'] }", "5") == ((), ("(2)", "p = a x b"))
    assert told(r"'4' = { given = ['c = (e \cdot e - 1) a + a \times b'] }", "4")[0] == ("|e| = 1",)


def test_what_is_given_may_come_later_or_be_a_part() -> None:
    assert verdicts("'2' = { given = ['1', '3', '5'] }")["2"] == "holds"
    page = r"""$$p = e = a \quad (1)$$ $$p \cdot p = 1 \quad (2)$$"""
    assert verdicts("'2' = { given = ['1/1'] }", page)["2"] == "holds-under"
    assert verdicts("'2' = { given = ['1/2'] }", page)["2"] == "fails"


def test_what_is_given_twice_of_a_letter_restricts_the_others() -> None:
    page = r"""$$p = a \quad (1)$$ $$p = b \quad (2)$$ $$a = b \quad (3)$$"""
    assert verdicts("'3' = { given = ['1', '2'] }", page)["3"] == "holds"


def test_what_is_proved_of_what_no_page_says_is_assumed_in_what_follows() -> None:
    page = r"""$$a \cdot p = x \quad (1)$$ $$2 a \cdot p = 2 b \cdot p \quad (2)$$ $$b \cdot p = x \quad (3)$$"""
    assert verdicts("'2' = { given = [] }", page)["3"] == "open"
    found = chasles.read(page, LETTERS + "\n[equations]\n'2' = { given = ['a = b'] }")
    assert [each.verdict for each in found.equations] == ["defined", "holds", "holds-under"]
    assert found.equations[2].finding.verdict.needs == ("(2)",)


def test_one_relation_of_several_has_a_note_of_its_own() -> None:
    page = r"""$$a \cdot c = b \cdot c \equiv x \quad (1)$$"""
    assert kinds("", page) == ["open", "defined"]
    assert kinds("'1' = { role = 'condition' }", page) == ["posed", "defined"]
    assert kinds("'1' = { given = ['a = b'] }", page) == ["holds", "defined"]
    assert kinds("'1/1' = { role = 'law' }", page) == ["assumed", "defined"]
    assert kinds("'1/2' = { role = 'law' }", page) == ["open", "assumed"]
    assert kinds("'1' = { role = 'condition' }\n'1/2' = { role = 'claim' }", page) == ["posed", "fails"]


def test_a_definition_of_no_letter_is_assumed() -> None:
    page = r"""$$a \cdot b = b \cdot p \quad (1)$$ $$2 a \cdot b = 2 b \cdot p \quad (2)$$"""
    assert kinds("'1' = { role = 'definition' }", page) == ["defined", "holds-under"]


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
        ("'4' = { of = 'c' }", "[equations] '4' of: 'of' belongs to a definition: say role = 'definition'"),
        (r"'1' = { role = 'definition', of = 'a \times b' }", "expected a letter alone"),
        ("'1' = { role = 'definition', of = 'x' }", "[equations] '1' of 'x': it is alone on neither side"),
    ],
)
def test_what_cannot_be_said_of_an_equation(note: str, said: str) -> None:
    with pytest.raises(BadNotation, match=re.escape(said)):
        verdicts(note)


def test_a_file_on_the_letters_of_a_module() -> None:
    page = r"$$\mathbf{c} = \mathbf{a} \quad (1)$$ $$\mathbf{a} \cdot \mathbf{c} = 0 \quad (2)$$"
    notes = "[page]\nnotation = 'chasles.derivations.notation'\n[equations]\n'2' = { role = 'condition' }"
    assert [each.verdict for each in chasles.read(page, notes).equations] == ["defined", "posed"]
    with pytest.raises(BadNotation, match="there is no module 'chasles\\.nowhere'"):
        chasles.read(page, "[page]\nnotation = 'chasles.nowhere'")
    with pytest.raises(BadNotation, match="a file on a module has no 'symbols'"):
        chasles.read(page, notes + "\n[symbols]\n'x' = 'scalar'")


def test_a_reading_is_of_a_whole_equation() -> None:
    with pytest.raises(BadNotation, match=re.escape("[equations] '1/1': give one reading for the whole of '1'")):
        verdicts("'1/1' = { reading = 'c = a' }")
