"""Every numbered equation of the chapter is declared, and nothing that it does not have."""

from __future__ import annotations

import re
import tomllib
from collections import defaultdict
from pathlib import Path

import pytest

from chasles.statements import Chapter, Theorem, load

LABELS = tuple(tomllib.loads((Path(__file__).parent / "printed.toml").read_text(encoding="utf-8")))
LAST = "3.83b"
THEOREMS = ("Thm 3.2.1", "Thm 3.2.2", "Thm 3.3.1", "Thm 3.4.1", "Cor 3.4.1", "Thm 3.4.2", "Thm 3.7.1", "Thm 3.7.2")
LAST_THEOREM = "Thm 3.4.2"
RECALLED = r"2\.\d+[a-z]?"
UNNUMBERED = r"text (3(?:\.\d+){1,2}) [a-z]"
EXERCISES = tuple(f"Ex 3.{n}" for n in range(1, 22))


@pytest.fixture(scope="module")
def chapter() -> Chapter:
    return load()


def test_the_list_is_the_books() -> None:
    """172 numbers: 3.1 to 3.148 without a gap, some of them with letters a, b, c ..."""
    assert len(LABELS) == 172
    letters: dict[int, list[str]] = defaultdict(list)
    for label in LABELS:
        match = re.fullmatch(r"3\.(\d+)([a-z]?)", label)
        assert match
        letters[int(match[1])].append(match[2])
    assert list(letters) == list(range(1, 149))
    for found in letters.values():
        assert found in ([""], ["a", "b", "c", "d", "e", "f"][: len(found)])


def test_every_label_so_far_is_declared(chapter: Chapter) -> None:
    declared = [label for label in LABELS if label in chapter.numbers]
    reached = max(LABELS.index(declared[-1]), LABELS.index(LAST)) + 1
    assert [label for label in LABELS[:reached] if label not in declared] == []


def test_every_theorem_so_far_is_declared(chapter: Chapter) -> None:
    theorems = {e.number for e in chapter if isinstance(e.statement, Theorem) and not e.number.startswith("text")}
    reached = THEOREMS.index(LAST_THEOREM) + 1
    assert [number for number in THEOREMS[:reached] if number not in theorems] == []
    assert theorems <= {*THEOREMS}


def test_no_number_is_made_up(chapter: Chapter) -> None:
    sections = {section.number for section in chapter.sections}

    def known(number: str) -> bool:
        if match := re.fullmatch(UNNUMBERED, number):
            return match[1] in sections
        return number in {*LABELS, *THEOREMS, *EXERCISES} or re.fullmatch(RECALLED, number) is not None

    assert [number for number in chapter.numbers if not known(number)] == []


def test_parts_are_counted_without_gaps(chapter: Chapter) -> None:
    parts: dict[str, list[int]] = defaultdict(list)
    for entry in chapter:
        parts[entry.number].append(entry.statement.part)
    assert {n: found for n, found in parts.items() if sorted(found) != list(range(1, len(found) + 1))} == {}
