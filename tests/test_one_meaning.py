"""A letter of a page has one meaning where a notation declares several symbols that are printed alike."""

from __future__ import annotations

from dataclasses import replace
from types import ModuleType

import pytest

from chasles.reading.equations import read_equations
from chasles.reading.notation_file import load_notation
from chasles.reading.one_meaning import one_meaning_each
from chasles.reading.pages import displayed
from chasles.vocabulary import FREQUENCY, plain, scalar, square, vector
from chasles.vocabulary.families import Family

HERE = vector("a", r"\mathbf{a}", "a vector of this section")
THERE = vector("a_there", r"\mathbf{a}", "a vector of that section")


def test_what_is_printed_alike_and_is_alike_is_one_symbol() -> None:
    assert one_meaning_each([HERE, THERE]) == [HERE, HERE]


@pytest.mark.parametrize(
    "other",
    [
        square("a_there", r"\mathbf{a}", "a matrix"),
        vector("a_there", r"\mathbf{a}", "unit vector"),
        vector("a_there", r"\mathbf{a}", "a vector of that section", FREQUENCY),
        vector("a_there", r"\mathbf{a}", "a vector of that section", constant=True),
        vector("a_there", r"\mathbf{b}", "a vector of that section"),
    ],
)
def test_what_differs_in_kind_shape_dimension_or_letter_is_left(other: object) -> None:
    assert one_meaning_each([HERE, other]) == [HERE, other]


def test_symbols_with_one_name_get_names_of_their_own() -> None:
    entry, column = scalar("a_2", "a_2", "an entry"), vector("a", "a", "a column")
    first, second, third = one_meaning_each([column, entry, square("a", "A", "a matrix")])
    assert len({first.name, second.name, third.name}) == 3
    assert [second.name, third.name] == ["a_2'2", "a'2"]


def test_abbreviations_and_families_stand_for_what_is_left() -> None:
    short = replace(scalar("s", "s", "an abbreviation"), stands_for=THERE.T @ THERE)
    family = Family("i", (THERE, HERE, THERE))
    assert one_meaning_each([HERE, THERE, short])[2].stands_for == HERE.T @ HERE
    assert one_meaning_each([HERE, THERE, family])[2].members == (HERE, HERE, HERE)


def test_a_page_is_read_with_one_meaning_each() -> None:
    chapter = ModuleType("chapter")
    chapter.__dict__.update(HERE=HERE, THERE=THERE)
    (equation,) = displayed(r"$$ \mathbf{a} = 2 \mathbf{a} $$", "page.md")
    (found,) = read_equations([equation], load_notation(chapter))
    assert [plain(each.parts[0].left) for each in found.readings] == ["a"]
