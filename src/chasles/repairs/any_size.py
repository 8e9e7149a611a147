"""Repairs of what is said of matrices of any size: searched for at numbers for the sizes, and proved for every size."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from dataclasses import replace as with_fields
from itertools import islice

from chasles import vocabulary as w
from chasles.checker.any_size.at_sizes import PointAtSizes
from chasles.points.at_sizes import points_at_sizes
from chasles.repairs.candidates import Nearest
from chasles.repairs.modular_testing import ModularTest
from chasles.repairs.one_term import Change
from chasles.repairs.without_form import edited, edits_of
from chasles.rewriting.term_basis import fit
from chasles.statements import Claim, problem_of
from chasles.statements.goals import AcceptedSides
from chasles.statements.matrices import with_sizes
from chasles.statements.statement import Equation
from chasles.vocabulary import Node
from chasles.vocabulary.measure import Extent
from chasles.vocabulary.sizes import Size, at_sizes, sizes_of

DRAWN, POINTS = 60, 6
"""So many points are drawn, of which so many are used, those of the largest sizes first."""


def nearest_at_numbers(claim: Claim, accepted: AcceptedSides) -> NearestAtNumbers | None:
    """What can be changed in a claim on matrices of any size that fails; None where no letter stands for a size.

    For the letters stand different small numbers at which it fails: there are claims that are true of even sizes only,
    and matrices of which it is assumed that they have no fewer rows than columns.
    """
    sizes = _sizes(claim, accepted)
    more = range(len(sizes) - 1)
    growing, falling = [2, *(4 + k for k in more)], [3, *(5 + k for k in more)][::-1]
    for chosen in (growing, falling) if sizes else ():
        near = _at_numbers(claim, accepted, {size.name: number for size, number in zip(sizes, chosen, strict=True)})
        if chosen is falling or near.is_tested(*near.statement.printed):
            return near
    return None


def differs_at_sizes(claim: Claim, accepted: AcceptedSides) -> bool:
    """Whether the sides differ at some points of several sizes; so they may, where no letter stands for a size."""
    if not _sizes(claim, accepted):
        return True
    test = _PointTest(claim, accepted)
    return bool(test.points) and not test.agree(claim.left, claim.right)


def _sizes(claim: Claim, accepted: AcceptedSides) -> tuple[Size, ...]:
    hypotheses = [node for h in claim.assuming for node in (*h.subjects, *h.nonvanishing)]
    rested_on = [side for given in claim.given for side in accepted(given)]
    return sizes_of([claim.left, claim.right, *hypotheses, *rested_on])


def _at_numbers(claim: Claim, accepted: AcceptedSides, numbers: dict[str, int]) -> NearestAtNumbers:
    known: dict[tuple[str, int], Equation] = {}
    for given in claim.given:
        left, right = accepted(given)
        known[given.number, given.part] = at_sizes(left, numbers), at_sizes(right, numbers)
    return NearestAtNumbers(
        with_sizes(claim, numbers),
        lambda given: known[given.number, given.part],
        tuple(side for pair in known.values() for side in pair),
        at_points=_PointTest(claim, accepted),
        back=at_letters(claim, numbers),
    )


@dataclass
class NearestAtNumbers(Nearest):
    """The same at numbers for sizes; what is not true at points of several sizes is no change."""

    at_points: _PointTest = field(kw_only=True)
    back: Callable[[Node], Node] = field(kw_only=True)

    def said_of_any_size(self, changes: Iterable[Change]) -> Iterator[Change]:
        """The changes, said of any size again."""
        for change in changes:
            sides = self._back(change)
            printed = zip(sides, self.statement.printed, strict=True)
            more = sum(_awkward(new) - _awkward(old) for new, old in printed)
            yield with_fields(change, left=sides[0], right=sides[1], effort=change.effort + more)

    def _back(self, change: Change) -> tuple[Node, Node]:
        left, right = (w.printed(lambda: self.back(side)) for side in (change.left, change.right))  # noqa: B023
        return left, right

    def _holds(self, test: ModularTest, change: Change) -> bool:
        return super()._holds(test, change) and self.agrees(change)

    def agrees(self, change: Change) -> bool:
        """Whether the sides fit and agree at points of several sizes."""
        left, right = self._back(change)
        return left != right and fit(left, right) and self.at_points.agree(left, right)

    def _without_form(self, left: Node, right: Node) -> Iterator[Change]:
        if not self.is_tested(left, right):
            yield from filter(self.agrees, edited(left, right, lambda side: edits_of(side, self.letters)))


def _awkward(side: Node) -> int:
    """How many transposes of products, or of the whole, are printed as such."""
    products = (part for part in w.walk(side) if isinstance(part, w.Transpose) and isinstance(part.of, w.Contract))
    return 2 * isinstance(side, w.Transpose) + sum(1 for _ in products)


class _PointTest:
    """Points of several sizes at which what a claim assumes holds; sides are compared there."""

    def __init__(self, claim: Claim, accepted: AcceptedSides) -> None:
        self.claim = claim
        self.accepted = accepted
        try:
            fitting = claim.saying(claim.left, claim.left) if claim.fault else claim
            found = list(islice(points_at_sizes(problem_of(fitting, "printed", accepted)), DRAWN))
        except (w.Misfit, TypeError):
            found = []
        self.points = found[::-1][:: max(1, len(found) // POINTS)]

    def agree(self, left: Node, right: Node) -> bool:
        """Whether the sides agree at all points at which both have a value, and at two or more."""
        try:
            problem = problem_of(self.claim.saying(left, right), "printed", self.accepted)
        except (w.Misfit, TypeError):
            return False
        count = 0
        for at in self.points:
            with suppress(ArithmeticError, ValueError, LookupError, TypeError):
                point = PointAtSizes(problem, at)
                if any(point(goal.left) != point(goal.right) for goal in problem.goals):
                    return False
                count += 1
        return count > 1


def at_letters(claim: Claim, numbers: dict[str, int]) -> Callable[[Node], Node]:
    """What says an expression at numbers for sizes with letters for them again."""
    said = [claim.left, claim.right, *(side for given in claim.given for side in given.printed)]
    symbols = {symbol.name: symbol for side in said for symbol in w.symbols_of(side)}
    extents: dict[int, Extent] = {}
    for size in sizes_of(said):
        extents[numbers[size.name]] = size

    def lifted(node: Node) -> Node:
        match node:
            case w.Symbol(name) if name in symbols:
                return symbols[name]
            case w.Identity(size) if size in extents:
                return with_fields(node, size=extents[size])
            case w.Zero(rows, columns):
                return with_fields(node, rows=extents.get(rows, rows), columns=extents.get(columns, columns))
            case _:
                return w.rebuilt(node, tuple(map(lifted, node.below)))

    return lifted
