"""Mutants of a statement: what it would say after one small slip of the pen, in words and not in text.

Only slips that fit are mutants: those which the vocabulary refuses when they are written are counted, no more. Nor is
it a slip to turn the sign of something that is said to be zero, or of what is squared, or to say that a thing is equal
to itself, or to say the same in other words: by values at points where all letters are free, never by asking whether
the mutant is true.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Mapping
from dataclasses import dataclass, fields
from dataclasses import replace as with_fields
from functools import partial
from typing import Any

from chasles.statements import Always, Claim, Hypothesis, Theorem
from chasles.vocabulary import Node, Symbol

from .meaning import Meaning
from .slips import Mutated, Spoken, written
from .slips_of_amount import is_zero

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
    meaning: Meaning | None = None,
    chapter: Mapping[str, Symbol] | None = None,
    alike: list[Mutant] | None = None,
) -> Iterator[Mutant]:
    """All mutants of one form of a statement, each meaning once; `refused` collects slips that cannot be written.

    Nothing that is symmetric by its `meaning` or its spelling is transposed. What says the same in other words is no
    mutant, and collected in `alike`. The `chapter` has letters, by name, which one of the statement's may lose a mark
    to.
    """
    meaning, letters = meaning or Meaning(), dict(chapter or {})
    made = _of_theorem if isinstance(sentence, Theorem) else partial(_of_claim, form=form)
    for mutant, same in made(sentence, refused=refused, meaning=meaning, chapter=letters):
        if not same:
            yield mutant
        elif alike is not None:
            alike.append(mutant)


def _of_claim(
    sentence: Claim, *, form: str, refused: list[str], meaning: Meaning, chapter: dict[str, Symbol]
) -> Iterator[tuple[Mutant, bool]]:
    """The mutants, and whether each says the same."""
    sides = sentence.form(form)
    spoken = Spoken(sides, meaning.is_symmetric, chapter)
    for place, name in ((0, "left side"), (1, "right side")):
        if place == 0 and sentence.solves is not None:
            continue
        matters, said = not is_zero(sides[1 - place]), meaning.of_words(sides[place])
        seen = {said}
        for change in spoken.mutated(sides[place], refused, signed=matters, sized=matters):
            changed = (change.whole, sides[1]) if place == 0 else (sides[0], change.whole)
            means = meaning.of_words(change.whole)
            if (means in seen and means != said) or changed[0] == changed[1] or change.whole == sides[place]:
                continue
            divisors = spoken.new_divisors(change.whole)
            made = written(lambda sides=changed, divisors=divisors: _claim(sentence, sides, divisors), refused)
            if made is not None:
                seen.add(means)
                yield Mutant(made, name, change), means == said


def _claim(sentence: Claim, sides: tuple[Node, Node], hypotheses: tuple[Hypothesis, ...]) -> Claim:
    left, right = sides
    assuming = (*sentence.assuming, *hypotheses)
    return with_fields(sentence, left=left, right=right, reading=None, corrected=None, kernel=None, assuming=assuming)


def _of_theorem(
    theorem: Theorem, *, refused: list[str], meaning: Meaning, chapter: dict[str, Symbol]
) -> Iterator[tuple[Mutant, bool]]:
    """The mutants, and whether each says the same."""
    for number, part in enumerate(theorem.forms):
        owned = tuple(node for _, _, node in _form_nodes(part))
        spoken = Spoken(owned, meaning.is_symmetric, chapter)
        said = _meaning(part.equations(), meaning)
        seen = {said}
        for name, place, node in _form_nodes(part):
            for change in spoken.mutated(node, refused, signed=_is_signed(part, name), sized=_is_sized(part, name)):
                changed = _with_node(part, name, place, change.whole)
                if changed == part or (isinstance(changed, Always) and changed.left == changed.right):
                    continue
                forms = (*theorem.forms[:number], changed, *theorem.forms[number + 1 :])
                assuming = (*theorem.assuming, *spoken.new_divisors(change.whole))
                equations = written(lambda changed=changed: changed.equations(), refused)
                if equations is None:
                    continue
                means = _meaning(equations, meaning)
                if means in seen and means != said:
                    continue
                seen.add(means)
                statement = with_fields(theorem, forms=forms, assuming=assuming)
                yield Mutant(statement, f"{type(part).__name__} {name}", change), means == said


def _meaning(equations: Iterable[tuple[str, Node, Node]], meaning: Meaning) -> tuple[Hashable, ...]:
    """What the equations mean by their words."""
    return tuple(meaning.of_words(side) for _, *sides in equations for side in sides)


def _is_sized(part: Any, name: str) -> bool:
    """Whether it matters how often the whole expression is taken: not where it is said to be zero."""
    return not isinstance(part, Always) or not is_zero(part.right if name == "left" else part.left)


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
        elif isinstance(value, Node) and field.type not in ("Symbol", "w.Symbol", Symbol):
            yield field.name, None, value


def _with_node(part: Any, name: str, place: int | None, node: Node) -> Any:
    if place is None:
        return with_fields(part, **{name: node})
    old = getattr(part, name)
    return with_fields(part, **{name: (*old[:place], node, *old[place + 1 :])})
