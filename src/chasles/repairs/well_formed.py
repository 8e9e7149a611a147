"""Equations that do not fit together as printed, with a lost mark or factor restored so that they do.

A lost mark is a separator between blocks, a transpose, a tilde or another letter; a lost factor is a vector, where a
scalar is set equal to one, or an invariant of the dimension that is missing.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from chasles import vocabulary as w
from chasles.repairs.local_edits import SingleEdit
from chasles.repairs.single_edits import in_letters, placed, single_edits
from chasles.rewriting.coefficients import added
from chasles.rewriting.places import everywhere
from chasles.rewriting.product import contraction
from chasles.rewriting.term_basis import TermBasis, dimension_of, fit
from chasles.vocabulary import Node


@dataclass(frozen=True, slots=True)
class WellFormedRepair:
    """Two sides that fit, and in words what was changed so that they do."""

    left: Node
    right: Node
    words: tuple[str, ...]


def fitting(
    left: Node, right: Node, letters: Sequence[w.Symbol], basis: TermBasis
) -> tuple[list[WellFormedRepair], list[WellFormedRepair]]:
    """The equations that fit after one change, and those after two."""
    marked = [letter for letter in letters if any(letter.name.startswith(s.name) for s in w.symbols_of(left))]
    lefts = _said(in_letters(left, marked, any_shape=True))
    rights = _said((*_separated(right), *single_edits(right), *in_letters(right, letters, any_shape=True)))
    unchanged = [_EditedSide(left, ())]
    once = _pairs(unchanged, [*rights, *_said(_factored(left, right, basis))])
    once += _pairs(lefts, [] if right.fault else [_EditedSide(right, ())])
    again = [
        _EditedSide(node, (*said.words, words))
        for said in rights
        for node, words, _ in (*_separated(said.node), *_factored(left, said.node, basis))
    ]
    return once, _pairs(lefts, rights) + _pairs(unchanged, again)


@dataclass(frozen=True, slots=True)
class _EditedSide:
    """A side, and what was changed in it."""

    node: Node
    words: tuple[str, ...]


def _said(found: Iterable[SingleEdit]) -> list[_EditedSide]:
    return [_EditedSide(each.node, (each.words,)) for each in found]


def _pairs(lefts: Sequence[_EditedSide], rights: Sequence[_EditedSide]) -> list[WellFormedRepair]:
    return [
        WellFormedRepair(left.node, right.node, (*left.words, *right.words))
        for right in rights
        for left in lefts
        if fit(left.node, right.node)
    ]


def _separated(node: Node) -> Iterator[SingleEdit]:
    """The expression with one more separator between the blocks of a row, where it then fits together."""
    rows = [
        (path, part.rows[0]) for path, part in everywhere(node) if isinstance(part, w.Block) and len(part.rows) == 1
    ]
    for path, blocks in rows:
        for k, block in enumerate(blocks):
            for before, behind in _cut(block):
                whole = placed(node, path, _row((*blocks[:k], before, behind, *blocks[k + 1 :])))
                if whole.fault is None:
                    yield SingleEdit(whole, f"{w.plain(before)} and {w.plain(behind)} are separate blocks")


def _cut(block: Node) -> Iterator[tuple[Node, Node]]:
    """The block as two, cut between its terms or between the factors of its last term."""
    terms = block.terms if isinstance(block, w.Sum) else (block,)
    for k in range(1, len(terms)):
        yield _sum(terms[:k]), _sum(terms[k:])
    last = terms[-1].term if isinstance(terms[-1], w.Negative) else terms[-1]
    factors = last.factors if isinstance(last, w.Contract) else ()
    for k in range(1, len(factors)):
        before, behind = _contracted(factors[:k]), _contracted(factors[k:])
        yield _sum((*terms[:-1], w.Negative(before) if last is not terms[-1] else before)), behind


def _row(blocks: tuple[Node, ...]) -> Node:
    return w.printed(lambda: w.Block((blocks,)))


def _sum(terms: tuple[Node, ...]) -> Node:
    return w.printed(lambda: added(terms))


def _contracted(factors: tuple[Node, ...]) -> Node:
    return w.printed(lambda: contraction(factors))


def _factored(left: Node, right: Node, basis: TermBasis) -> Iterator[SingleEdit]:
    """The right side times what brings it to the left side's shape and dimension."""
    if right.fault or fit(left, right):
        return
    one, other = dimension_of(left), dimension_of(right)
    if one is None or other is None:
        return
    if right.is_scalar and left.shape == (3, 1):
        for vector in basis.of_dimension((3, 1), one / other):
            # A pure number in front of it would be another change.
            if not isinstance(vector, w.Scale) or dimension_of(vector.factor) != w.NO_DIMENSION:
                yield SingleEdit(w.Scale(right, vector), f"the vector factor {w.plain(vector)} is added")
    elif left.shape == right.shape:
        for weight in basis.of_dimension((1, 1), one / other):
            yield SingleEdit(w.Scale(weight, right), f"the factor {w.plain(weight)} is added")
