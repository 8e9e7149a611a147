"""Words of the pages: verdicts with sign and colour, points, counts, durations."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from itertools import chain
from math import isqrt

from rich.text import Text

from chasles.algebra.values import InPi
from chasles.statements import Statement
from chasles.verdict import Counterexample, Verdict
from chasles.vocabulary import PI
from chasles.vocabulary.letters import entry_names

VERDICTS: dict[str, tuple[str, str, str, str]] = {
    "holds": ("✓", "+", "holds", "green"),
    "holds-under": ("✓", "+", "holds under", "green"),
    "fails": ("✗", "x", "fails", "bold red"),
    "ill-formed": ("⊘", "!", "ill-formed", "bold magenta"),
    "contradictory": ("↯", "#", "contradictory", "bold magenta"),
    "undecided": ("?", "?", "undecided", "bold yellow"),
    "defined": ("≡", "=", "defined", "cyan"),
    "posed": ("∃", "o", "posed", "cyan"),
    "assumed": ("⊢", "-", "assumed", "cyan"),
}
"""Verdict -> sign, the sign in ASCII, word, colour; in the order in which totals name them."""


def labelled(verdict: Verdict, signs: bool) -> Text:
    """The verdict as a sign and a word, coloured."""
    sign, ascii_sign, word, colour = VERDICTS[verdict.name]
    return Text(f"{sign if signs else ascii_sign} {word}", style=colour)


def said(verdict: Verdict) -> str:
    """The verdict in a sentence: "holds under |e| = 1, phi != 0"."""
    return " ".join((VERDICTS[verdict.name][2], ", ".join(verdict.needs))).strip()


def counted(verdicts: Iterable[Verdict]) -> str:
    """How many there are of each: "36 hold, 1 holds under hypotheses, 5 ill-formed"."""
    names = [verdict.name for verdict in verdicts]
    found = ((names.count(name), word) for name, (_, _, word, _) in VERDICTS.items())
    return ", ".join(f"{count} {_of_so_many(word, count)}" for count, word in found if count)


def _of_so_many(word: str, count: int) -> str:
    words = word.replace("under", "under hypotheses")
    return re.sub(r"^(hold|fail)s", r"\1", words) if count != 1 else words


def entry_in_words(found: Counterexample, statement: object = None) -> str:
    """In which entry the sides differ, "row 2, column 1"; empty for scalars, and for what may be one."""
    is_scalar = statement.left.is_scalar if isinstance(statement, Statement) else found.entry == (1, 1)
    return "" if is_scalar else "row {}, column {}".format(*found.entry)


def number_of(count: int, noun: str) -> str:
    """How many there are: "1 step", "2 steps"."""
    return f"{count} {noun}{'s' * (count != 1)}"


def point_in_words(point: Mapping[str, object]) -> str:
    """The point as one line: "e = (1, 0, 0), cos(phi) = 0"; the entries of a vector or a matrix are put together.

    An angle is a multiple of pi; where it is none, its cosine and sine say what it is.
    """
    parts = []
    turned = {found[1] for name in point if (found := re.fullmatch(r"cos\(\d*(.+?)(?:/\d+)?\)", name))}
    unsaid = {name for name in turned if not isinstance(point.get(name), InPi)} | {PI.name}
    rest = {name: value for name, value in sorted(point.items()) if name not in unsaid}
    while rest:
        name = next(iter(rest))
        stem = name.rpartition("_")[0]
        if stem and (rows := _array(stem, {each for each in rest if each.rpartition("_")[0] == stem})):
            parts.append(f"{stem} = ({'; '.join(', '.join(str(rest.pop(e)) for e in row) for row in rows)})")
        else:
            parts.append(f"{name} = {rest.pop(name)}")
    return ", ".join(parts)


def _array(stem: str, names: set[str]) -> list[list[str]]:
    """The names, row by row, if they are all those of a vector or a square matrix with three rows or more."""
    size, rows = len(names), isqrt(len(names))
    column = [list(chain.from_iterable(entry_names(stem, size, 1)))]
    arrays = (array for array in (column, entry_names(stem, rows, rows)) if len(array[0]) > 2)
    return next((array for array in arrays if names == {*chain.from_iterable(array)}), [])


def seconds(value: float) -> str:
    """A duration: milliseconds below a tenth of a second."""
    return f"{value * 1000:.0f} ms" if value < 0.1 else f"{value:.2f} s"
