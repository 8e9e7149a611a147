"""Slips of the pen: a sign turned round, a term left out, a transpose added or lost, two factors or blocks in the wrong
order, a cosine for a sine, a wrong number or exponent, a wrong letter of the same kind.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from chasles.statements import Hypothesis, nonzero
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

__all__ = ["Mutated", "Spoken", "is_zero", "written"]

Slip = tuple[str, Node]
Slips = Callable[[Node], Iterator[Slip]]


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


def _divisors(nodes: Iterable[Node]) -> list[Node]:
    """What is divided by, numbers left out."""
    found = [part.denominator for node in nodes for part in walk(node) if isinstance(part, Quotient)]
    return [divisor for divisor in dict.fromkeys(found) if symbols_of(divisor)]


class Spoken:
    """What a statement speaks of, which is what may be mistaken for something else in it.

    An angle is mistaken for an angle only, and what has a rate for something else that has one.
    """

    def __init__(self, sides: tuple[Node, ...], is_symmetric: Callable[[Node], bool]) -> None:
        parts = [part for side in sides for part in walk(side)]
        self.sides = sides
        self.letters = tuple(dict.fromkeys(part for part in parts if isinstance(part, Symbol)))
        self.angles = {symbol for part in parts if isinstance(part, Call) for symbol in symbols_of(part.argument)}
        self.indices = tuple(dict.fromkeys(index for side in sides for index in _indices(side)))
        self.moving = _moving(sides)
        self.slips = (
            _signs,
            _left_out,
            lambda node: _transposes(node, is_symmetric),
            _order,
            _circular,
            _numbers,
            lambda node: _letters(node, tuple(s for s in self.letters if (s in self.angles) == (node in self.angles))),
            lambda node: _other_indices(node, self.indices),
        )

    def mutated(self, node: Node, refused: list[str], *, signed: bool) -> Iterator[Mutated]:
        """The expression with one slip, at any depth; the sign of the whole is turned only if it is `signed`."""
        if signed and not isinstance(node, Sum | Block | Inverse) and not is_zero(node):
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
            whole = written(lambda changed=changed: rebuilt(node, changed), refused)
            if whole is not None:
                yield Mutated(inner.slip, inner.before, inner.after, whole)


def _turned(term: Node) -> Node:
    return term.term if isinstance(term, Negative) else Negative(term)


def is_zero(node: Node) -> bool:
    """Whether it is spelled as zero."""
    return isinstance(node, Zero) or node == Number(Fraction(0))


def _signs(node: Node) -> Iterator[Slip]:
    match node:
        case Sum(terms):
            for place, term in enumerate(terms):
                yield "sign", Sum((*terms[:place], _turned(term), *terms[place + 1 :]))
        case Block(rows):
            for i, row in enumerate(rows):
                for j, block in enumerate(row):
                    if not isinstance(block, Sum | Block) and not is_zero(block):
                        yield "sign", _with_block(rows, i, j, _turned(block))


def _with_block(rows: tuple[tuple[Node, ...], ...], i: int, j: int, block: Node) -> Block:
    row = (*rows[i][:j], block, *rows[i][j + 1 :])
    return Block((*rows[:i], row, *rows[i + 1 :]))


def _left_out(node: Node) -> Iterator[Slip]:
    if isinstance(node, Sum):
        for place in range(len(node.terms)):
            rest = node.terms[:place] + node.terms[place + 1 :]
            yield "term left out", rest[0] if len(rest) == 1 else Sum(rest)


def _transposes(node: Node, is_symmetric: Callable[[Node], bool]) -> Iterator[Slip]:
    """A lost transpose, and an extra one on a square matrix that is not symmetric."""
    rows, columns = node.shape
    if isinstance(node, Negative | Sum | Inverse) or (rows == columns and is_symmetric(node)):
        return
    if isinstance(node, Transpose):
        yield "transpose lost", node.of
    elif rows == columns > 1:
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
