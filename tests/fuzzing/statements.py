"""A question about a declared statement, and motions of our own that satisfy what it is given and assumes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import factorial
from random import Random
from typing import Any

import numpy as np

from chasles import vocabulary as w
from chasles.statements import Hypothesis, Statement, Theorem

from .hypotheses import Pair, beginning, in_domain, meaning
from .newton import solved
from .node_values import Words, entries_of
from .series import mpf

__all__ = ["Asked", "Motion", "goals", "motions", "symbols_in"]

SPARE = 1
Motion = Words
"""Words at a motion."""
Place = tuple[w.Symbol, int, int, int]
Said = tuple[tuple[w.Node, Any], ...]
"""Scalars and their values at the moment."""


@dataclass(frozen=True)
class Asked:
    """A statement to be decided; `truth` and `satisfiable` are what is known by construction."""

    statement: Statement | Theorem
    kind: str = ""
    truth: bool | None = None
    satisfiable: bool | None = None
    lenient: bool = False

    def unlabelled(self) -> Asked:
        """The same with nothing known of it."""
        return replace(self, truth=None, satisfiable=None)

    @property
    def equations(self) -> list[Pair]:
        """What is given, and what hypotheses mean, as equations."""
        given = [(g.left, g.right) for g in self.statement.given]
        return [*given, *(pair for h in self.hypotheses for pair in meaning(h))]

    @property
    def hypotheses(self) -> list[Hypothesis]:
        """All that is assumed."""
        return [*self.statement.assuming, *(h for g in self.statement.given for h in g.assuming)]

    def source(self) -> str:
        """The statement in words."""
        return str(self)

    def __str__(self) -> str:
        lines = [f"given {type(g).__name__} {g.left} = {g.right}" for g in self.statement.given]
        lines += [f"assuming {h.text}" for h in self.hypotheses]
        claims = [f"{label or 'claim'}: {left} = {right}" for label, left, right in goals(self.statement)]
        return "\n".join((*claims, *lines))


def goals(statement: Statement | Theorem) -> list[tuple[str, w.Node, w.Node]]:
    """The equations to be decided with their labels."""
    if isinstance(statement, Theorem):
        return [equation for form in statement.forms for equation in form.equations()]
    return [("", statement.left, statement.right)]


def symbols_in(asked: Asked) -> list[w.Symbol]:
    """The free symbols, by name."""
    nodes = [
        *(side for _, *sides in goals(asked.statement) for side in sides),
        *(s for p in asked.equations for s in p),
    ]
    nodes += [node for h in asked.hypotheses for node in h.subjects]
    found: set[w.Symbol] = set()
    while nodes:
        for symbol in w.symbols_of(nodes.pop()):
            if symbol.stands_for is not None:
                nodes.append(symbol.stands_for)
            elif symbol != w.PI:
                found.add(symbol)
    return sorted(found, key=lambda s: s.name)


def unfolded(asked: Asked) -> dict[w.Symbol, w.Node]:
    """What symbols stand for: a definition says so of its left side, or, where that is a rate, of a bare right side."""
    found: dict[w.Symbol, w.Node] = {}
    for given in asked.statement.given:
        for one, other in ((given.left, given.right), (given.right, given.left)):
            if isinstance(one, w.Symbol) and one not in found and not _reaches(other, one, found):
                found[one] = other
                break
    return found


def _reaches(node: w.Node, symbol: w.Symbol, meaning: Mapping[w.Symbol, w.Node]) -> bool:
    return any(s == symbol or (s in meaning and _reaches(meaning[s], symbol, meaning)) for s in w.symbols_of(node))


def depth(node: w.Node, meaning: Mapping[w.Symbol, w.Node]) -> int:
    """How many rates stand within each other, in what symbols stand for too."""
    if isinstance(node, w.Symbol):
        inner = meaning.get(node, node.stands_for)
        return 0 if inner is None else depth(inner, meaning)
    return max((depth(part, meaning) for part in w.children(node)), default=0) + isinstance(node, w.Rate)


class _System:
    """The equations for the coefficients of a motion; some of them are fixed."""

    def __init__(
        self, asked: Asked, fixed: Mapping[Place, Any], extra: tuple[tuple[w.Node, Any], ...], spare: int
    ) -> None:
        self.asked, self.extra = asked, extra
        self.meaning = meaning = unfolded(asked)
        sides = [side for _, *pair in goals(asked.statement) for side in pair]
        self.equations = [(a, b, max(depth(a, meaning), depth(b, meaning))) for a, b in asked.equations]
        said = [k + (depth(s, meaning)) for s, k, *_ in fixed]
        rates = max([0, *said, *(depth(side, meaning) for side in sides), *(n for *_, n in self.equations)])
        self.last = rates + spare if rates else 0
        self.symbols = symbols_in(asked)
        own = [s for s in self.symbols if s not in meaning]
        self.places = [(s, k, i, j) for s in own for k in range(self._size(s)) for i, j in entries_of(s)]
        values = {place: mpf(value) / factorial(place[1]) for place, value in fixed.items()}
        self.pinned = {place: value for place, value in values.items() if place[0] not in meaning}
        self.said = [(place, value) for place, value in values.items() if place[0] in meaning]
        self.free = [place for place in self.places if place not in self.pinned]

    def _size(self, symbol: w.Symbol) -> int:
        return 1 if symbol.constant else self.last + 1

    def words(self, values: Sequence[Any]) -> Words:
        """The words at a point of the free coefficients."""
        like = values[0] if len(values) else mpf(0)
        machine = isinstance(like, np.ndarray)
        known = {p: like * 0 + float(v) if machine else v for p, v in self.pinned.items()}
        known |= dict(zip(self.free, values, strict=True))
        entries = {
            s: [
                [[known[s, k, i, j] for k in range(self._size(s))] for j in range(s.shape[1])]
                for i in range(s.shape[0])
            ]
            for s in self.symbols
            if s not in self.meaning
        }
        return Words(entries, like, self.meaning)

    def residuals(self, values: Sequence[Any]) -> list[Any]:
        words = self.words(values)

        def number(value: Any) -> Any:
            return float(value) if isinstance(words.like, np.ndarray) else value

        total = [words.scalar(node) - number(value) for node, value in self.extra]
        total += [words(s, k)[i][j][k] - number(value) for (s, k, i, j), value in self.said]
        for one, other, order in self.equations:
            n = self.last - order
            if one in self.meaning and self.meaning[one] is other:  # type: ignore[index]
                continue
            for row, line in zip(words(one, n), words(other, n), strict=True):
                total += [a - b for x, y in zip(row, line, strict=True) for a, b in zip(x, y, strict=True)]
        return total


def motions(
    asked: Asked,
    draw: Random,
    tries: int,
    fixed: Mapping[Place, Any] | None = None,
    extra: Said = (),
    spare: int = SPARE,
) -> Iterator[Motion]:
    """Motions that satisfy all that is given and assumed, of at most so many tries.

    `fixed` gives entries of rates of symbols by symbol, order, row and column; `extra` values of scalars at the moment.
    """
    system = _System(asked, fixed or {}, extra, spare)
    for _ in range(tries):
        at = beginning(asked.hypotheses, system.symbols, draw)
        start = [at[s, i, j] if k == 0 else draw.uniform(-2, 2) for s, k, i, j in system.free]
        found = solved(system.residuals, start)
        if found is not None:
            motion = system.words(found)
            if in_domain(asked.hypotheses, motion):
                yield motion
