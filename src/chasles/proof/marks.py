"""An equation that does not fit together as printed: what can it say if a mark was lost, or a factor?

A lost mark is a separator between blocks, a transpose, a tilde or another letter; a lost factor is a vector, where a
scalar is set equal to one, or an invariant of the dimension that is missing.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from chasles.proof.ansatz import Palette, dimension_of, fit
from chasles.proof.coefficients import added
from chasles.proof.places import everywhere, put
from chasles.proof.slips import Undone, in_letters, undone
from chasles.vocabulary import Block, Contract, Misfit, Negative, Node, Scale, Sum, Symbol, plain, printed, symbols_of

__all__ = ["Fitting", "fitting"]


@dataclass(frozen=True, slots=True)
class Fitting:
    """Two sides that fit, and in words what was changed so that they do."""

    left: Node
    right: Node
    words: tuple[str, ...]


def fitting(left: Node, right: Node, letters: Sequence[Symbol], palette: Palette) -> Iterator[list[Fitting]]:
    """The equations that fit after one change, and then those after two."""
    marked = [letter for letter in letters if any(letter.name.startswith(s.name) for s in symbols_of(left))]
    lefts = list(in_letters(left, marked, any_shape=True))
    rights = list(_restored(right, letters))
    whole = [] if right.fault else [(right, ())]
    yield _pairs([(left, ())], [*_said(rights), *_said(_factored(left, right, palette))]) + _pairs(_said(lefts), whole)
    again = [
        (other, (words, more))
        for new, words in rights
        for other, more in (*_separated_anywhere(new), *_factored(left, new, palette))
    ]
    yield _pairs(_said(lefts), _said(rights)) + _pairs([(left, ())], again)


_Said = tuple[Node, tuple[str, ...]]


def _said(found: Sequence[Undone] | Iterator[Undone]) -> list[_Said]:
    return [(node, (words,)) for node, words in found]


def _pairs(lefts: Sequence[_Said], rights: Sequence[_Said]) -> list[Fitting]:
    return [
        Fitting(one, other, (*said, *more)) for other, more in rights for one, said in lefts if fit(one, other)
    ]


def _restored(node: Node, letters: Sequence[Symbol]) -> Iterator[Undone]:
    """The expression with one mark restored, where that makes it fit together."""
    yield from _separated_anywhere(node)
    yield from undone(node)
    yield from in_letters(node, letters, any_shape=True)


def _separated_anywhere(node: Node) -> Iterator[Undone]:
    """The expression with one more separator between the blocks of a row."""
    for path, part in everywhere(node):
        if isinstance(part, Block) and len(part.rows) == 1:
            for k, block in enumerate(part.rows[0]):
                for before, behind in _cut(block):
                    row = (*part.rows[0][:k], before, behind, *part.rows[0][k + 1 :])
                    whole = printed(lambda path=path, row=row: put(node, path, Block((row,))))  # type: ignore[misc]
                    if whole.fault is None:
                        yield whole, f"{plain(before)} and {plain(behind)} are separate blocks"


def _cut(block: Node) -> Iterator[tuple[Node, Node]]:
    """The block as two, cut between its terms or between the factors of its last term."""
    terms = block.terms if isinstance(block, Sum) else (block,)
    for k in range(1, len(terms)):
        yield printed(lambda k=k: added(terms[:k])), printed(lambda k=k: added(terms[k:]))  # type: ignore[misc]
    last = terms[-1].term if isinstance(terms[-1], Negative) else terms[-1]
    if isinstance(last, Contract):
        for k in range(1, len(last.factors)):
            before, behind = (printed(lambda part=part: _contracted(part)) for part in (last.factors[:k], last.factors[k:]))  # type: ignore[misc]
            signed = Negative(before) if isinstance(terms[-1], Negative) else before
            yield printed(lambda signed=signed: added((*terms[:-1], signed))), behind  # type: ignore[misc]


def _contracted(factors: tuple[Node, ...]) -> Node:
    return factors[0] if len(factors) == 1 else Contract(factors)


def _factored(left: Node, right: Node, palette: Palette) -> Iterator[Undone]:
    """The right side times what brings it to the left side's shape and dimension."""
    one, other = dimension_of(left), dimension_of(right) if right.fault is None else None
    if one is None or other is None or fit(left, right):
        return
    if right.is_scalar and left.shape == (3, 1):
        for vector in palette.of_dimension((3, 1), one / other):
            yield Scale(right, vector), f"the vector factor {plain(vector)} is added"
    elif left.shape == right.shape:
        for weight in palette.of_dimension((1, 1), one / other):
            yield Scale(weight, right), f"the factor {plain(weight)} is added"
