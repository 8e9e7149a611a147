"""Slips of the pen: a sign turned round, a factor of two; a term, factor, bracket, dot, mark or block left out; a
transpose added or lost; two factors, blocks or letters exchanged; a cosine for a sine, half an angle; a wrong number,
exponent, index or letter of the same kind.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from chasles.statements import Hypothesis, nonzero
from chasles.vocabulary import (
    Block,
    Call,
    Integral,
    Inverse,
    Misfit,
    Node,
    Quotient,
    Rate,
    Sum,
    Symbol,
    children,
    printed,
    rebuilt,
    symbols_of,
    walk,
)

from . import slips_of_amount as amount
from . import slips_of_form as form
from .slips_of_amount import Slip, is_zero

__all__ = ["Mutated", "Spoken", "without_marks", "written"]

Slips = Callable[[Node], Iterator[Slip]]
MARKS = "~'"


@dataclass(frozen=True, slots=True)
class Mutated:
    """One expression with a slip in it; `slip` names the kind, `before` and `after` the part that changed."""

    slip: str
    before: Node
    after: Node
    whole: Node


def written(write: Callable[[], Any], refused: list[str]) -> Any:
    """What `write` makes; None, and the reason in `refused`, if it does not fit."""
    try:
        return write()
    except Misfit as misfit:
        refused.append(str(misfit))
        return None


def without_marks(letters: Iterable[Symbol], chapter: Mapping[str, Symbol]) -> dict[Symbol, Symbol]:
    """What each letter with a tilde or primes means without them, if that means something in the chapter."""
    bare = {letter: letter.name.rstrip(MARKS) for letter in letters}
    return {letter: chapter[name] for letter, name in bare.items() if name != letter.name and name in chapter}


def _divisors(nodes: Iterable[Node]) -> list[Node]:
    """What is divided by, numbers left out."""
    found = [part.denominator for node in nodes for part in walk(node) if isinstance(part, Quotient)]
    return [divisor for divisor in dict.fromkeys(found) if symbols_of(divisor)]


class Spoken:
    """What a statement speaks of, which is what may be mistaken for something else in it.

    An angle is mistaken for an angle only, and what has a rate for something else that has one. `chapter` has the
    letters of the chapter, by name.
    """

    def __init__(
        self, sides: tuple[Node, ...], is_symmetric: Callable[[Node], bool], chapter: Mapping[str, Symbol]
    ) -> None:
        parts = [part for side in sides for part in walk(side)]
        self.sides = sides
        self.letters = tuple(dict.fromkeys(part for part in parts if isinstance(part, Symbol)))
        self.angles = {symbol for part in parts if isinstance(part, Call) for symbol in symbols_of(part.argument)}
        self.indices = tuple(dict.fromkeys(index for side in sides for index in form.indices_of(side)))
        self.marked = without_marks(self.letters, chapter)
        self.moving = _moving(sides)
        self.running = {symbol for part in parts if isinstance(part, Integral) for symbol in part.running}
        self.slips: tuple[Slips, ...] = (
            amount.signs,
            amount.left_out,
            lambda node: form.transposes(node, is_symmetric),
            form.order,
            amount.circular,
            amount.numbers,
            lambda node: form.letters(node, self._alike(node)),
            lambda node: form.other_indices(node, self.indices),
            amount.doubled,
            amount.factors,
            amount.rates,
            form.blocks,
            amount.angles,
            lambda node: form.lost_marks(node, self.marked),
        )

    def _alike(self, letter: Node) -> tuple[Symbol, ...]:
        """The letters that may be mistaken for one."""
        return tuple(s for s in self.letters if (s in self.angles) == (letter in self.angles))

    def mutated(self, node: Node, refused: list[str], *, signed: bool, sized: bool) -> Iterator[Mutated]:
        """The expression with one slip, at any depth.

        The sign of the whole is turned only if it is `signed`, the whole is doubled only if it is `sized`.
        """
        for change in self._mutated(node, refused, signed=signed, sized=sized):
            running = [d for d in self._divisors(change.whole) if self.running.intersection(symbols_of(d))]
            if running:
                refused.append(f"cannot divide by {running[0]}, which differs from element to element")
            elif _moving((change.whole,)) <= self.moving:
                yield change

    def _mutated(self, node: Node, refused: list[str], *, signed: bool, sized: bool) -> Iterator[Mutated]:
        if not isinstance(node, Sum | Block | Inverse) and not is_zero(node):
            if signed:
                yield Mutated("sign", node, amount.turned(node), amount.turned(node))
            if sized:
                yield Mutated("factor of two", node, amount.twice(node), amount.twice(node))
        for slip in self.slips:
            yield from _everywhere(node, slip, refused)
        angles = tuple(letter for letter in self.letters if letter in self.angles)
        for letters in (angles, tuple(letter for letter in self.letters if letter not in self.angles)):
            for whole in _fitting(lambda letters=letters: list(form.exchanged_letters(node, letters)), refused):
                yield Mutated("letters exchanged", node, whole, whole)

    def new_divisors(self, changed: Node) -> tuple[Hypothesis, ...]:
        """Hypotheses that what a slip made into a divisor is not zero, so that the slip itself is judged."""
        return tuple(map(nonzero, self._divisors(changed)))

    def _divisors(self, changed: Node) -> list[Node]:
        """What is divided by, and was not."""
        old = _divisors(self.sides)
        return [divisor for divisor in _divisors((changed,)) if divisor not in old]


def _moving(nodes: Iterable[Node]) -> set[Symbol]:
    """The letters whose rates occur."""
    return {s for node in nodes for part in walk(node) if isinstance(part, Rate) for s in symbols_of(part.of)}


def _everywhere(node: Node, slip: Slips, refused: list[str]) -> Iterator[Mutated]:
    for kind, after in printed(lambda: list(slip(node))):  # type: ignore[type-var]
        if after.fault is None:
            yield Mutated(kind, node, after, after)
        else:
            refused.append(after.fault)
    parts = children(node)
    for place, part in enumerate(parts):
        for inner in _everywhere(part, slip, refused):
            changed = (*parts[:place], inner.whole, *parts[place + 1 :])
            whole = written(lambda changed=changed: rebuilt(node, changed), refused)
            if whole is not None:
                yield Mutated(inner.slip, inner.before, inner.after, whole)


def _fitting(write: Callable[[], list[Node]], refused: list[str]) -> Iterator[Node]:
    """Of the expressions that `write` makes, those that fit."""
    for made in printed(write):  # type: ignore[type-var]
        if made.fault is None:
            yield made
        else:
            refused.append(made.fault)
