"""A statement displayed on its own, without the rest of the report."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from itertools import groupby

from chasles.decisions.decision import Sentence
from chasles.report.details import number_in_words
from chasles.report.html.citing import Book
from chasles.statements import Chapter, Entry, Inverse, Section, Statement, Theorem
from chasles.statements.chapter import bases

NOWHERE = Section("", "")


class Alone(Book):
    """What there is of a book where one sentence is shown: no page to lead to; the hypotheses behind it as formulas."""

    def __init__(self, sentence: Sentence) -> None:
        super().__init__(Chapter("", ()))
        self.sentence = sentence

    @cached_property
    def hypotheses(self) -> dict[str, str]:
        """The hypotheses of the sentence, and of all on which it rests, in LaTeX by their text."""
        found: dict[str, str] = {}
        seen: set[int] = set()
        waiting: list[Sentence] = [self.sentence]
        while waiting:
            sentence = waiting.pop()
            if id(sentence) not in seen:
                seen.add(id(sentence))
                found |= {hypothesis.text: hypothesis.latex for hypothesis in sentence.assuming}
                waiting += rests_on(sentence)
        return found


def entry_of(sentence: Sentence) -> Entry:
    """The sentence as an entry, of no name and no section."""
    return Entry("", NOWHERE, sentence)


def as_displayed(value: object) -> object:
    """The value; of a sentence, its entry."""
    return entry_of(value) if isinstance(value, Statement | Theorem | Inverse) else value


def rests_on(sentence: Sentence) -> tuple[Statement, ...]:
    """What the sentence names, each once."""
    return tuple(dict.fromkeys(bases(sentence)))


def cited(statements: Iterable[Statement]) -> str:
    """Their numbers, as one looks for them."""
    return ", ".join(number_in_words(each.number, each.part) for each in statements)


def sections_of(chapter: Chapter) -> Iterator[tuple[str, str, str, str]]:
    """For each section its number, its title, the first and the last of its numbers, and how many statements it has."""
    for section, group in groupby(chapter, lambda entry: entry.section):
        members = [entry.statement for entry in group]
        ends = [number_in_words(sentence.number) for sentence in (members[0], members[-1])]
        yield section.number, section.title, " to ".join(dict.fromkeys(ends)), str(len(members))
