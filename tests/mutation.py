"""Mutants of a statement: what it would say after one small slip of the pen, in words and not in text.

Only slips that fit are mutants: those which the vocabulary refuses when they are written are counted, no more. Nor is
it a slip to turn the sign of something that is said to be zero, or of what is squared, or to say that a thing is equal
to itself.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields
from dataclasses import replace as with_fields
from typing import Any

from chasles.statements import Always, Claim, Hypothesis, Theorem
from chasles.vocabulary import Node, Symbol

from .slips import Mutated, Spoken, is_zero, written

__all__ = ["Mutant", "mutants_of"]


@dataclass(frozen=True, slots=True)
class Mutant:
    """A statement with a slip in the part of it that `where` names."""

    statement: Claim | Theorem
    where: str
    change: Mutated

    def __str__(self) -> str:
        number, change = self.statement.number, self.change
        return f"({number}) part {self.statement.part}, {self.where}: {change.slip}: {change.before} -> {change.after}"


def mutants_of(
    sentence: Claim | Theorem,
    form: str,
    refused: list[str],
    is_symmetric: Callable[[Node], bool] = lambda _: False,
) -> Iterator[Mutant]:
    """All mutants of one form of a statement, each spelling once; `refused` collects slips that cannot be written.

    Nothing that `is_symmetric` is transposed, nor what is symmetric by its spelling.
    """
    if isinstance(sentence, Theorem):
        yield from _of_theorem(sentence, refused, is_symmetric)
        return
    sides = sentence.form(form)
    seen = {sides}
    spoken = Spoken(sides, is_symmetric)
    for place, name in ((0, "left side"), (1, "right side")):
        if place == 0 and sentence.solves is not None:
            continue
        for change in spoken.mutated(sides[place], refused, signed=not is_zero(sides[1 - place])):
            changed = (change.whole, sides[1]) if place == 0 else (sides[0], change.whole)
            if changed in seen or changed[0] == changed[1]:
                continue
            seen.add(changed)
            divisors = spoken.new_divisors(change.whole)
            made = written(lambda sides=changed, divisors=divisors: _claim(sentence, sides, divisors), refused)
            if made is not None:
                yield Mutant(made, name, change)


def _claim(sentence: Claim, sides: tuple[Node, Node], hypotheses: tuple[Hypothesis, ...]) -> Claim:
    left, right = sides
    assuming = (*sentence.assuming, *hypotheses)
    return with_fields(sentence, left=left, right=right, reading=None, corrected=None, kernel=None, assuming=assuming)


def _of_theorem(theorem: Theorem, refused: list[str], is_symmetric: Callable[[Node], bool]) -> Iterator[Mutant]:
    for number, part in enumerate(theorem.forms):
        owned = tuple(node for _, _, node in _form_nodes(part))
        spoken = Spoken(owned, is_symmetric)
        seen: set[Any] = {part}
        for name, place, node in _form_nodes(part):
            for change in spoken.mutated(node, refused, signed=_is_signed(part, name)):
                changed = _with_node(part, name, place, change.whole)
                if changed in seen or (isinstance(changed, Always) and changed.left == changed.right):
                    continue
                seen.add(changed)
                forms = (*theorem.forms[:number], changed, *theorem.forms[number + 1 :])
                assuming = (*theorem.assuming, *spoken.new_divisors(change.whole))
                if written(lambda changed=changed: changed.equations(), refused) is None:
                    continue
                statement = with_fields(theorem, forms=forms, assuming=assuming)
                yield Mutant(statement, f"{type(part).__name__} {name}", change)


def _is_signed(part: Any, name: str) -> bool:
    """Whether the sign of the whole expression matters: not that of a square, nor of what is said to be zero."""
    if isinstance(part, Always):
        return not is_zero(part.right if name == "left" else part.left)
    return name != "squares"


def _form_nodes(part: Any) -> Iterator[tuple[str, int | None, Node]]:
    """The expressions of a theorem's form, other than the bare symbols it speaks of."""
    for field in fields(part):
        value = getattr(part, field.name)
        if isinstance(value, tuple):
            for place, node in enumerate(value):
                yield field.name, place, node
        elif isinstance(value, Node) and field.type not in ("Symbol", Symbol):
            yield field.name, None, value


def _with_node(part: Any, name: str, place: int | None, node: Node) -> Any:
    if place is None:
        return with_fields(part, **{name: node})
    old = getattr(part, name)
    return with_fields(part, **{name: (*old[:place], node, *old[place + 1 :])})
