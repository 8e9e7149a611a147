"""Repairs of what is said of matrices of any size: searched for at numbers for the sizes, and proved for every size."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace as with_fields
from itertools import chain, islice, product

from chasles.checker.any_size.at_sizes import PointAtSizes
from chasles.checker.sparse import Rejected
from chasles.points.at_sizes import points_at_sizes
from chasles.repairs.local_edits import FORM, SingleEdit
from chasles.repairs.one_term import LEFT_OUT, Change, instead
from chasles.repairs.single_edits import placed
from chasles.repairs.without_form import edits_of
from chasles.rewriting.places import everywhere
from chasles.rewriting.term_basis import fit
from chasles.statements import Claim, problem_of
from chasles.statements.goals import AcceptedSides
from chasles.statements.matrices import with_sizes
from chasles.vocabulary import (
    Block,
    Contract,
    Identity,
    Inverse,
    Misfit,
    Negative,
    Node,
    Scale,
    Sum,
    Symbol,
    Transpose,
    Zero,
    printed,
    rebuilt,
    symbols_of,
    walk,
)
from chasles.vocabulary.measure import Extent
from chasles.vocabulary.sizes import at_sizes, sizes_of

SMALLEST, MOST = 2, 600
"""The first number that is put for a size; so many edits of a side are tried."""
DRAWN, POINTS = 60, 6
"""So many points are drawn, of which so many are used, those of the largest sizes first."""


def at_numbers(claim: Claim) -> tuple[Claim, dict[str, int]] | None:
    """The claim at different small numbers for the letters, and these; None where no letter stands for a size."""
    hypotheses = [node for h in claim.assuming for node in (*h.subjects, *h.nonvanishing)]
    sizes = sizes_of([claim.left, claim.right, *hypotheses])
    if not sizes:
        return None
    numbers = {size.name: SMALLEST + place for place, size in enumerate(sizes)}
    return with_sizes(claim, numbers), numbers


def changes_at_any_size(
    claim: Claim, sized: Claim, numbers: dict[str, int], letters: Iterable[Symbol], accepted: AcceptedSides
) -> Iterator[Change]:
    """The sides with one edit on either that agree at points of several sizes; `sized` is the claim at numbers."""
    test = _PointTest(claim, accepted)
    back = at_letters(claim, numbers)
    of_numbers = [sized_letter for each in letters if isinstance(sized_letter := at_sizes(each, numbers), Symbol)]
    for place, side in enumerate(sized.printed):
        edits = chain(edits_of(side, of_numbers), _inverses(side), _inserted(side, of_numbers))
        for new, words, effort in islice(edits, MOST):
            sides = list(claim.printed)
            sides[place] = printed(lambda: back(new))  # noqa: B023
            left, right = sides
            if left != right and fit(left, right) and test.agree(left, right):
                yield Change(left, right, (words,), effort + _awkward(new) - _awkward(side))


def _inverses(side: Node) -> Iterator[SingleEdit]:
    """An inverse lost or added."""
    for path, part in everywhere(side):
        square = isinstance(part, Symbol) and part.shape[0] == part.shape[1] != 1
        new = part.of if isinstance(part, Inverse) else Inverse(part) if square else None
        whole = None if new is None else placed(side, path, new)
        if new is not None and whole is not None and whole.fault is None:
            yield SingleEdit(whole, instead(new, part), FORM)


def _inserted(side: Node, letters: list[Symbol]) -> Iterator[SingleEdit]:
    """A letter, its transpose or its inverse, before or behind a factor."""
    parts = dict(everywhere(side))
    matrices = [letter for letter in letters if max(letter.shape) > 1]
    for path, part in parts.items():
        if part.is_scalar or isinstance(part, Sum | Negative | Scale | Block | Contract):
            continue
        for letter in matrices:
            kinds = (letter, Transpose(letter), *((Inverse(letter),) if letter.shape[0] == letter.shape[1] else ()))
            for factor, pair in product(kinds, (True, False)):
                one, other = (factor, part) if pair else (part, factor)
                if one.shape[1] == other.shape[0] and (new := Contract((one, other))).shape == part.shape:
                    whole = placed(side, path, new)
                    if whole.fault is None:
                        yield SingleEdit(whole, instead(new, part), LEFT_OUT)


def _awkward(side: Node) -> int:
    """How many transposes of products, or of the whole, are printed as such."""
    products = (part for part in walk(side) if isinstance(part, Transpose) and isinstance(part.of, Contract))
    return 2 * isinstance(side, Transpose) + sum(1 for _ in products)


class _PointTest:
    """Points of several sizes at which what a claim assumes holds; sides are compared there."""

    def __init__(self, claim: Claim, accepted: AcceptedSides) -> None:
        self.claim = claim
        self.accepted = accepted
        try:
            found = list(islice(points_at_sizes(problem_of(claim, "printed", accepted)), DRAWN))
        except (Misfit, TypeError):
            found = []
        self.points = found[::-1][:: max(1, len(found) // POINTS)]

    def agree(self, left: Node, right: Node) -> bool:
        """Whether the sides agree at all points at which both have a value, and at two or more."""
        try:
            problem = problem_of(self.claim.saying(left, right), "printed", self.accepted)
        except (Misfit, TypeError):
            return False
        count = 0
        for at in self.points:
            try:
                point = PointAtSizes(problem, at)
                if any(point(goal.left) != point(goal.right) for goal in problem.goals):
                    return False
            except Rejected:
                continue
            count += 1
        return count > 1


def at_letters(claim: Claim, numbers: dict[str, int]) -> Callable[[Node], Node]:
    """What says an expression at numbers for sizes with letters for them again."""
    said = [claim.left, claim.right, *(side for given in claim.given for side in given.printed)]
    symbols = {symbol.name: symbol for side in said for symbol in symbols_of(side)}
    extents: dict[int, Extent] = {}
    for size in sizes_of(said):
        extents[numbers[size.name]] = size

    def lifted(node: Node) -> Node:
        match node:
            case Symbol(name) if name in symbols:
                return symbols[name]
            case Identity(size) if size in extents:
                return with_fields(node, size=extents[size])
            case Zero(rows, columns):
                return with_fields(node, rows=extents.get(rows, rows), columns=extents.get(columns, columns))
            case _:
                return rebuilt(node, tuple(map(lifted, node.below)))

    return lifted
