"""Mutants of a statement: what it would say after one small slip of the pen, in words and not in text.

A slip is a sign turned round, a term left out, a transpose added or lost, two factors or blocks in the wrong order, a
cosine for a sine, a wrong number or exponent, a wrong letter of the same kind. Only slips that fit are mutants: those
which the vocabulary refuses when they are written are counted, no more. Nor is it a slip to turn the sign of something
that is said to be zero, or of what is squared, or to say that a thing is equal to itself.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, fields
from dataclasses import replace as with_fields
from fractions import Fraction
from typing import Any

from chasles.statements import Always, Claim, Hypothesis, Theorem, nonzero
from chasles.vocabulary import (
    Block,
    Call,
    Contract,
    Cross,
    Entry,
    Group,
    Identity,
    Index,
    Inverse,
    Member,
    Misfit,
    Negative,
    Node,
    Number,
    Power,
    Quotient,
    Rate,
    Scale,
    Sum,
    Symbol,
    Transpose,
    Zero,
    children,
    rebuilt,
    symbols_of,
    walk,
)

__all__ = ["Mutant", "Mutated", "mutants_of"]

Slip = tuple[str, Node]
Slips = Callable[[Node], Iterator[Slip]]


@dataclass(frozen=True, slots=True)
class Mutated:
    """One expression with a slip in it; `slip` names the kind, `before` and `after` the part that changed."""

    slip: str
    before: Node
    after: Node
    whole: Node


@dataclass(frozen=True, slots=True)
class Mutant:
    """A statement with a slip in the part of it that `where` names."""

    statement: Claim | Theorem
    form: str
    where: str
    change: Mutated

    def __str__(self) -> str:
        number, change = self.statement.number, self.change
        return f"({number}) part {self.statement.part}, {self.where}: {change.slip}: {change.before} -> {change.after}"


def mutants_of(sentence: Claim | Theorem, form: str, refused: list[str]) -> Iterator[Mutant]:
    """All mutants of one form of a statement, each spelling once; `refused` collects slips that cannot be written."""
    if isinstance(sentence, Theorem):
        yield from _of_theorem(sentence, refused)
        return
    sides = sentence.form(form)
    seen = {sides}
    spoken = _Spoken(sides)
    for place, name in ((0, "left side"), (1, "right side")):
        if place == 0 and sentence.solves is not None:
            continue
        for change in spoken.mutated(sides[place], refused, signed=not _is_zero(sides[1 - place])):
            changed = (change.whole, sides[1]) if place == 0 else (sides[0], change.whole)
            if changed in seen or changed[0] == changed[1]:
                continue
            seen.add(changed)
            made = _written(lambda changed=changed, change=change: _claim(sentence, form, changed, change), refused)
            if made is not None:
                yield Mutant(made, form, name, change)


def _claim(sentence: Claim, form: str, sides: tuple[Node, Node], change: Mutated) -> Claim:
    """The claim with other sides. What it divides by, and the original does not, is declared not to be zero."""
    return with_fields(
        sentence,
        left=sides[0],
        right=sides[1],
        reading=None,
        corrected=None,
        kernel=None,
        assuming=(*sentence.assuming, *spoken.new_divisors(change.whole)),
    )


def _of_theorem(theorem: Theorem, refused: list[str]) -> Iterator[Mutant]:
    for number, part in enumerate(theorem.forms):
        owned = tuple(node for _, _, node in _form_nodes(part))
        spoken = _Spoken(owned)
        seen: set[Any] = {part}
        for name, place, node in _form_nodes(part):
            for change in spoken.mutated(node, refused, signed=_is_signed(part, name)):
                changed = _with_node(part, name, place, change.whole)
                if changed in seen or (isinstance(changed, Always) and changed.left == changed.right):
                    continue
                seen.add(changed)
                forms = (*theorem.forms[:number], changed, *theorem.forms[number + 1 :])
                assuming = (*theorem.assuming, *spoken.new_divisors(change.whole))
                if _written(lambda changed=changed: changed.equations(), refused) is None:
                    continue
                statement = with_fields(theorem, forms=forms, assuming=assuming)
                yield Mutant(statement, "printed", f"{type(part).__name__} {name}", change)


def _is_signed(part: Any, name: str) -> bool:
    """Whether the sign of the whole expression matters: not that of a square, nor of what is said to be zero."""
    if isinstance(part, Always):
        return not _is_zero(part.right if name == "left" else part.left)
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


def _written(write: Callable[[], Any], refused: list[str]) -> Any:
    try:
        return write()
    except Misfit as misfit:
        refused.append(str(misfit))
        return None


def _divisors(nodes: Iterable[Node]) -> list[Node]:
    """What is divided by, numbers left out."""
    found = [part.denominator for node in nodes for part in walk(node) if isinstance(part, Quotient)]
    return [divisor for divisor in dict.fromkeys(found) if symbols_of(divisor)]


class _Spoken:
    """What a statement speaks of, which is what may be mistaken for something else in it.

    An angle is mistaken for an angle only, and what has a rate for something else that has one.
    """

    def __init__(self, sides: tuple[Node, ...]) -> None:
        parts = [part for side in sides for part in walk(side)]
        self.sides = sides
        self.letters = tuple(dict.fromkeys(part for part in parts if isinstance(part, Symbol)))
        self.angles = {symbol for part in parts if isinstance(part, Call) for symbol in symbols_of(part.argument)}
        self.indices = tuple(dict.fromkeys(index for side in sides for index in _indices(side)))
        self.moving = _moving(sides)
        self.slips = (
            _signs,
            _left_out,
            _transposes,
            _order,
            _circular,
            _numbers,
            lambda node: _letters(node, tuple(s for s in self.letters if (s in self.angles) == (node in self.angles))),
            lambda node: _other_indices(node, self.indices),
        )

    def mutated(self, node: Node, refused: list[str], *, signed: bool) -> Iterator[Mutated]:
        """The expression with one slip, at any depth; the sign of the whole is turned only if it is `signed`."""
        if signed and not isinstance(node, Sum | Block | Inverse) and not _is_zero(node):
            yield Mutated("sign", node, _turned(node), _turned(node))
        for slip in self.slips:
            for change in _everywhere(node, slip, refused):
                if _moving((change.whole,)) <= self.moving:
                    yield change

    def new_divisors(self, changed: Node) -> tuple[Hypothesis, ...]:
        """Hypotheses that what a slip made into a divisor is not zero, so that the slip itself is judged."""
        old = _divisors(self.sides)
        return tuple(nonzero(divisor) for divisor in _divisors((changed,)) if divisor not in old)


def _moving(nodes: Iterable[Node]) -> set[Symbol]:
    """The letters whose rates occur."""
    return {s for node in nodes for part in walk(node) if isinstance(part, Rate) for s in symbols_of(part.of)}


def _everywhere(node: Node, slip: Slips, refused: list[str]) -> Iterator[Mutated]:
    try:
        for kind, after in slip(node):
            yield Mutated(kind, node, after, after)
    except Misfit as misfit:
        refused.append(str(misfit))
    parts = children(node)
    for place, part in enumerate(parts):
        for inner in _everywhere(part, slip, refused):
            changed = (*parts[:place], inner.whole, *parts[place + 1 :])
            whole = _written(lambda changed=changed: rebuilt(node, changed), refused)
            if whole is not None:
                yield Mutated(inner.slip, inner.before, inner.after, whole)


def _turned(term: Node) -> Node:
    return term.term if isinstance(term, Negative) else Negative(term)


def _is_zero(node: Node) -> bool:
    return isinstance(node, Zero) or node == Number(Fraction(0))


def _signs(node: Node) -> Iterator[Slip]:
    match node:
        case Sum(terms):
            for place, term in enumerate(terms):
                yield "sign", Sum((*terms[:place], _turned(term), *terms[place + 1 :]))
        case Block(rows):
            for i, row in enumerate(rows):
                for j, block in enumerate(row):
                    if not isinstance(block, Sum | Block) and not _is_zero(block):
                        yield "sign", _with_block(rows, i, j, _turned(block))


def _with_block(rows: tuple[tuple[Node, ...], ...], i: int, j: int, block: Node) -> Block:
    row = (*rows[i][:j], block, *rows[i][j + 1 :])
    return Block((*rows[:i], row, *rows[i + 1 :]))


def _left_out(node: Node) -> Iterator[Slip]:
    if isinstance(node, Sum):
        for place in range(len(node.terms)):
            rest = node.terms[:place] + node.terms[place + 1 :]
            yield "term left out", rest[0] if len(rest) == 1 else Sum(rest)


def _transposes(node: Node) -> Iterator[Slip]:
    """A lost transpose, and an extra one on a square matrix that is not symmetric by its spelling."""
    if isinstance(node, Transpose):
        yield "transpose lost", node.of
    elif isinstance(node, Negative | Sum | Inverse):
        return
    elif node.shape[0] == node.shape[1] > 1:
        factors = _factors(node)
        if [_mirrored(factor) for factor in reversed(factors)] != factors:
            yield "transpose added", Transpose(node)


def _factors(node: Node) -> list[Node]:
    """The matrices of a product, scalars and brackets left out."""
    match node:
        case Contract(factors):
            return [inner for factor in factors for inner in _factors(factor)]
        case Scale(factor, of):
            return _factors(of if factor.is_scalar else factor)
        case Quotient(of, _) | Group(of):
            return _factors(of)
        case _:
            return [node]


def _mirrored(node: Node) -> Node:
    match node:
        case Identity() | Zero():
            return node
        case Transpose(of):
            return of
        case _:
            return node if node.is_scalar else Transpose(node)


def _order(node: Node) -> Iterator[Slip]:
    match node:
        case Cross(left, right) if left != right:
            yield "operands swapped", Cross(right, left)
        case Contract(factors):
            for k in range(len(factors) - 1):
                swapped = (*factors[:k], factors[k + 1], factors[k], *factors[k + 2 :])
                if swapped != factors:
                    yield "factors swapped", Contract(swapped)
        case Block(rows):
            for k in range(len(rows) - 1):
                yield "rows swapped", Block((*rows[:k], rows[k + 1], rows[k], *rows[k + 2 :]))
            for k in range(len(rows[0]) - 1):
                exchanged = tuple((*row[:k], row[k + 1], row[k], *row[k + 2 :]) for row in rows)
                yield "columns swapped", Block(exchanged)


def _circular(node: Node) -> Iterator[Slip]:
    if isinstance(node, Call):
        yield "sine and cosine", Call({"sin": "cos", "cos": "sin"}[node.function], node.argument)


def _numbers(node: Node) -> Iterator[Slip]:
    match node:
        case Number(value):
            yield "number", Number(value + 1)
            if value > 1:
                yield "number", Number(value - 1)
        case Power(base, exponent):
            yield "exponent", Power(base, exponent + 1)
            if exponent > 1:
                yield "exponent", base if exponent == 2 else Power(base, exponent - 1)


def _letters(node: Node, letters: tuple[Symbol, ...]) -> Iterator[Slip]:
    if isinstance(node, Symbol):
        for letter in letters:
            if letter != node and letter.size == node.size:
                yield "letter", letter


def _indices(node: Node) -> Iterator[Index]:
    for part in walk(node):
        match part:
            case Member(_, index):
                yield index
            case Entry(_, i, j, _):
                yield from (i, j)


def _other_indices(node: Node, indices: tuple[Index, ...]) -> Iterator[Slip]:
    match node:
        case Member(family, index):
            for other in indices:
                if other != index:
                    yield "index", Member(family, other)
        case Entry(of, i, j, letter):
            yield "indices swapped", Entry(of, j, i, letter)
