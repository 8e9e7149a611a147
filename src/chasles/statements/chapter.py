"""The whole book as one object: every statement, by name and by number, in the order in which it was declared."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from chasles.display import Displayed
from chasles.statements.arrays import variants
from chasles.statements.inversion import Inverse
from chasles.statements.kernel import Kernel
from chasles.statements.packages import BOOK, DeclarationError
from chasles.statements.statement import Statement, Theorem
from chasles.vocabulary.arguments import Declared

Sentence = Statement | Theorem | Inverse


@dataclass(frozen=True, slots=True)
class Section(Declared):
    """A heading of the book; the statements declared below it belong to it."""

    number: str
    title: str


@dataclass(frozen=True, slots=True, repr=False)
class Entry(Displayed):
    """A statement with its name (that of the variable that holds it) and its section."""

    name: str
    section: Section
    statement: Sentence

    def __repr__(self) -> str:
        return f"<({self.number}) {self.name}>"

    @property
    def number(self) -> str:
        """The number of the statement, as printed."""
        return self.statement.number

    @property
    def place(self) -> str:
        """File and line of the declaration, as a message begins; empty where that is no file."""
        return f"{self.statement.place}: " if self.statement.place else ""

    @property
    def key(self) -> tuple[str, int]:
        """The number and the part, which together belong to one statement only."""
        return self.statement.number, self.statement.part

    @property
    def kernels(self) -> tuple[Kernel, ...]:
        """The kernels that the statement asks for, each with its name."""
        kernel = self.statement.kernel
        return variants(kernel, self.name) if kernel else ()


@dataclass(frozen=True, repr=False)
class Chapter(Displayed):
    """The statements of a book, which the `package` declares; `source` is the book: author, title, edition.

    Raises `DeclarationError` if two have one name, or one number and part, or if one rests on itself or a later one.
    """

    title: str
    entries: tuple[Entry, ...]
    package: str = BOOK
    source: str = ""

    def __post_init__(self) -> None:
        seen: dict[tuple[str, int], str] = {}
        names: dict[str, str] = {}
        order = {id(entry.statement): place for place, entry in enumerate(self.entries)}
        for place, entry in enumerate(self.entries):
            number, part = entry.key
            if entry.key in seen:
                raise DeclarationError(
                    f"{entry.place}{seen[entry.key]} and {entry.name} are both declared as ({number}), part {part}: "
                    "give the second another `part`"
                )
            seen[entry.key] = entry.name
            if entry.name in names:
                raise DeclarationError(
                    f"{entry.place}({names[entry.name]}) and ({number}) are both called {entry.name}: give one "
                    "another name"
                )
            names[entry.name] = number
            for basis in bases(entry.statement):
                if order.get(id(basis), -1) >= place:
                    raise DeclarationError(
                        f"{entry.place}{entry.name} ({number}) rests on ({basis.number}), which does not come before it"
                    )

    def __repr__(self) -> str:
        return f"<chapter {self.title!r}: {len(self.entries)} statements>"

    @cached_property
    def sections(self) -> tuple[Section, ...]:
        """The sections that have statements, in the book's order."""
        return tuple(dict.fromkeys(entry.section for entry in self.entries))

    @cached_property
    def numbers(self) -> tuple[str, ...]:
        """Every number once, in the book's order."""
        return tuple(sorted({entry.number for entry in self.entries}, key=place_of))

    def __iter__(self) -> Iterator[Entry]:
        return iter(self.entries)

    def select(self, numbers: Sequence[str] = (), sections: Sequence[str] = ()) -> tuple[Entry, ...]:
        """The entries with one of the numbers, or of one of the sections; all without either.

        Raises KeyError naming the first number or section that the book does not have.
        """
        for number in numbers:
            if number not in self.numbers and number not in {entry.name for entry in self.entries}:
                raise KeyError(number)
        for section in sections:
            if not any(_within(known.number, section) for known in self.sections):
                raise KeyError(section)
        return tuple(
            entry
            for entry in self.entries
            if not (numbers or sections)
            or entry.number in numbers
            or entry.name in numbers
            or any(_within(entry.section.number, section) for section in sections)
        )


def bases(sentence: Sentence) -> Iterator[Statement]:
    """The statements that a sentence names: what is given, and what it restates, solves or inverts."""
    yield from sentence.given if isinstance(sentence, Theorem) else sentence.relied_on


def _within(number: str, section: str) -> bool:
    return number == section or number.startswith(section + ".")


def place_of(number: str) -> tuple[int, list[tuple[int, str]], str]:
    """Where a number stands in the book: 3.9a before 3.9b before 3.10, equations before theorems before text."""
    kinds = ("Thm", "Cor", "text", "Ex")
    kind = next((i + 1 for i, word in enumerate(kinds) if number.startswith(word)), 0)
    return kind, [(int(digits), letters) for digits, letters in re.findall(r"(\d+)([a-z]*)", number)], number
