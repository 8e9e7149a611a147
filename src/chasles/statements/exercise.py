"""An exercise as data: what is asked, which data it takes and of what shape, what is the book's and what is assumed."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from chasles.vocabulary import Node
from chasles.vocabulary.arguments import Declared


@dataclass(frozen=True, slots=True)
class Scalar(Declared):
    """A real number; an integer, or one with a sign, where that is demanded. `least` is the smallest integer."""

    positive: bool = False
    integer: bool = False
    least: int | None = None
    most: int | None = None


@dataclass(frozen=True, slots=True)
class Array(Declared):
    """Numbers in rows: of one column, a list of numbers; else, a list of rows."""

    rows: int
    columns: int = 1


@dataclass(frozen=True, slots=True)
class Word(Declared):
    """One of some words; given in either case of letters, known as spelled here."""

    among: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Truth(Declared):
    """True or false."""


@dataclass(frozen=True, slots=True)
class Else(Declared):
    """A thing of some shape, or one of some words in its place; None stands for nothing."""

    of: Shape
    words: tuple[str | None, ...] = (None,)


@dataclass(frozen=True, slots=True)
class ListOf(Declared):
    """A list of things of one shape, at least so many and at most so many."""

    of: Shape
    least: int = 1
    most: int | None = None


@dataclass(frozen=True, slots=True)
class Tuple(Declared):
    """A list of a fixed number of things, each of its own shape and with its own name for messages."""

    parts: tuple[tuple[str, Shape], ...]


@dataclass(frozen=True, slots=True)
class Record(Declared):
    """Named things of one shape."""

    names: tuple[str, ...]
    of: Shape


Shape = Scalar | Array | Word | Truth | Else | ListOf | Tuple | Record


def vector_shape(size: int = 3) -> Array:
    """A list of so many numbers."""
    return Array(size)


def matrix_shape(rows: int = 3, columns: int = 3) -> Array:
    """A list of rows."""
    return Array(rows, columns)


@dataclass(frozen=True, slots=True)
class Datum(Declared):
    """One key of the data: its shape, its default as a user would write it, what it is.

    A datum without a default may be left out, and is None then.
    """

    key: str
    shape: Shape
    default: Any
    says: str


@dataclass(frozen=True, slots=True)
class Answer(Declared):
    """One answer by its name: its shape, what it is with its unit and convention.

    It is asked for where the status is one of `only`, if there are any, and where the datum `given` is.
    """

    name: str
    shape: Shape
    says: str
    only: tuple[str, ...] = ()
    given: str = ""


@dataclass(frozen=True, eq=False)
class Exercise(Declared):
    """An exercise: what is `asked`, in our words, part by part; the `data`; how it is solved.

    For practice: `instance` draws new data; `symbols` are the book's symbols for answers, by the answers' names;
    `signs` are groups of answers that may all be given with the other sign, `turns` angles up to whole turns; `orders`
    groups of lists that may be given in any one order; `axes` rows along principal axes, by the matrix and its moments;
    `synonyms` other words for a word. `alternatives` says, of the sheet and the answers given, what else is right.

    `solve` writes the solution on a sheet and returns its status, one of `statuses`. `assumptions` are always made;
    `stand_ins` only where a key has its default: said of the keys for which the book gives none.
    """

    number: str
    title: str
    asked: tuple[str, ...]
    solve: Callable[[Any], str]
    data: tuple[Datum, ...] = ()
    statuses: tuple[str, ...] = ("ok",)
    assumptions: tuple[str, ...] = ()
    stand_ins: Mapping[str, str] = field(default_factory=dict)
    instance: Callable[[Any], dict[str, Any]] | None = None
    symbols: Mapping[str, tuple[Node, ...]] = field(default_factory=dict)
    signs: tuple[tuple[str, ...], ...] = ()
    turns: tuple[str, ...] = ()
    orders: tuple[tuple[str, ...], ...] = ()
    axes: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    answers: tuple[Answer, ...] = ()
    synonyms: Mapping[str, str] = field(default_factory=dict)
    alternatives: Callable[[Any, dict[str, Any]], list[dict[str, Any]]] | None = None

    @property
    def keys(self) -> tuple[str, ...]:
        """The names of the data, in order."""
        return tuple(datum.key for datum in self.data)

    def assumed(self, given: tuple[str, ...]) -> tuple[str, ...]:
        """All that is assumed where these keys are given by the user."""
        defaults = [text for key, text in self.stand_ins.items() if key not in given]
        return (*self.assumptions, *dict.fromkeys(defaults))
