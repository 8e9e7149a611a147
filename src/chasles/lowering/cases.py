"""Values that depend on a comparison: the first case all of whose comparisons come out as said is taken."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from chasles.vocabulary import Node, Symbol, number


@dataclass(frozen=True, slots=True)
class Comparison:
    """left < right, or left = right, or (where it does not hold) the opposite."""

    kind: Literal["less", "equal"]
    left: Node
    right: Node
    holds: bool = True


@dataclass(frozen=True, slots=True)
class Case:
    """Where all comparisons come out as said: the values of a choice's symbols, in their order.

    A case without values says what no numbers do: there something is infinite, or not a number.
    """

    where: tuple[Comparison, ...]
    values: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Choice:
    """The symbols take the values of the first case that applies, and have no value where none does."""

    symbols: tuple[Symbol, ...]
    cases: tuple[Case, ...]

    @property
    def is_exhaustive(self) -> bool:
        """Whether the last case applies whatever comes."""
        return not self.cases[-1].where


def vanishes(scalar: Node, *, holds: bool = True) -> Comparison:
    """Whether the scalar is zero, or (where that does not hold) is not."""
    return Comparison("equal", scalar, number(0), holds)


def largest_of(symbols: tuple[Symbol, ...], candidates: Sequence[tuple[Node, tuple[Node, ...]]]) -> Choice:
    """The values beside the largest of the scalars; the first of several that are equally large.

    Each candidate is a scalar and the values that go with it.
    """
    cases = []
    for place, (size, values) in enumerate(candidates):
        rivals = candidates[place + 1 :]
        cases.append(Case(tuple(Comparison("less", size, other, holds=False) for other, _ in rivals), values))
    return Choice(symbols, tuple(cases))


def oriented(sign: Symbol, entries: Sequence[Node], finite: Node | None = None) -> Choice:
    """The sign, 1 or -1, that makes the first of the entries positive that is not zero; 1 where all are zero.

    There is none where the scalar that is to be `finite` is not.
    """
    cases = [] if finite is None else [Case((vanishes(finite - finite, holds=False),), ())]
    plus, minus = number(1), number(-1)
    for entry in entries:
        cases.append(Case((Comparison("less", entry, number(0)),), (minus,)))
        cases.append(Case((Comparison("less", number(0), entry),), (plus,)))
    return Choice((sign,), (*cases, Case((), (plus,))))
