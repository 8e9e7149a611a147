"""What an equation is written with, by values at points: scalars and their products, letters, matrices."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping
from functools import cached_property
from itertools import combinations_with_replacement, islice

from chasles import vocabulary as w
from chasles.algebra.modular import Column, normalized
from chasles.repairs.modular_testing import ModularTest
from chasles.repairs.required_values import quotient, value
from chasles.repairs.residues import Sampled
from chasles.rewriting.coefficients import ONE
from chasles.rewriting.coefficients import product as product_of
from chasles.statements import Hypothesis
from chasles.vocabulary import Node
from chasles.vocabulary.shorthand import Shorthand

MOST_FACTORS = 48
"""So many scalars are multiplied with each other to find a term that is missing."""
SCOUTS = 3
"""Points at which edits are tried first."""
_Named = Mapping[tuple[int, ...], list[Node]]


class Factors:
    """The scalars, letters and matrices that sides are written with, but for those `without`.

    Of what is `given`, matrices are taken by their letters alone.
    """

    def __init__(
        self, test: ModularTest, sides: Iterable[Node], given: Iterable[Node], without: Container[Node]
    ) -> None:
        # Where something vanishes, nothing is seen of what it is multiplied with.
        points = sorted(test.varied.points, key=lambda point: sum(not value for value in point.values()))
        self.at = Sampled(test.varied.context, points[:SCOUTS])
        own = dict.fromkeys(part for node in sides for part in w.walk(node))
        parts = own | dict.fromkeys(part for node in given for part in w.walk(node))
        found = [part for part in parts if not any(inner in without for inner in w.walk(part))]
        self.letters = tuple(part for part in found if isinstance(part, w.Symbol))
        self.tensors = [part for part in found if isinstance(part, w.Symbol | w.Rate) and not part.is_scalar]
        squares = [part for part in found if (_is_named(part) or part in own) and _is_factor(part)]
        inverses = dict.fromkeys(part for part in found if isinstance(part, w.Inverse) and not part.is_scalar)
        inverses |= dict.fromkeys(declared_inverses(test.problem.hypotheses))
        self.matrices = (*squares, *map(w.Transpose, squares), *inverses)
        scalars = [part for part in found if part.is_scalar]
        scalars += [w.Determinant(each.of) for each in inverses]
        both = [w.Call(f, node.argument) for node in scalars if isinstance(node, w.Call) for f in ("cos", "sin")]
        divisors = dict.fromkeys(part.denominator for part in found if isinstance(part, w.Quotient))
        scalars += [w.Quotient(ONE, each) for each in divisors]
        moving = [s for s in self.letters if s.is_scalar and not s.constant and s.stands_for is None]
        rates = [w.Rate(s) for s in moving] if any(isinstance(part, w.Rate) for part in parts) else []
        self.columns: dict[Node, Column] = {}
        for node in (ONE, *scalars, *both, *rates):
            column = value(self.at, node)
            if column is not None and all(column) and (node == ONE or not isinstance(node, w.Number)):
                self.columns.setdefault(node, column)

    def of_values(self, column: Column, most: int) -> Iterator[Node]:
        """The products of at most so many factors that have these values, up to a number; one if there are several."""
        direction = normalized(column)
        found = self._single.get(direction, []) or (self._pairs.get(direction, []) if most > 1 else [])
        yield from found
        if found or most < 3:
            return
        for factor in (*self.simple, *(pair[0] for pair in self._pairs.values())):
            own = self.columns.get(factor) or value(self.at, factor)
            rest = None if own is None else quotient(column, own)
            if rest is not None and (pair := self._pairs.get(normalized(rest))):
                yield product_of(factor, pair[0])
                return

    @cached_property
    def _single(self) -> _Named:
        return _by_direction(self.columns.items())

    @cached_property
    def _pairs(self) -> _Named:
        pairs = combinations_with_replacement(self.simple, 2)
        return _by_direction((_times(one, other), self.at.times(one, self.columns[other])) for one, other in pairs)

    @cached_property
    def simple(self) -> tuple[Node, ...]:
        """The scalars that are no products, and one over those that are divided by."""
        products = w.Scale | w.Negative | w.Group | w.Number
        found = (
            node
            for node in self.columns
            if (node.numerator == ONE if isinstance(node, w.Quotient) else not isinstance(node, products))
        )
        return tuple(islice(found, MOST_FACTORS))


def declared_inverses(hypotheses: Iterable[Hypothesis]) -> Iterator[w.Inverse]:
    """The inverses of matrices whose determinants are declared not to be zero."""
    declared = (node for h in hypotheses for node in h.nonvanishing if isinstance(node, w.Determinant))
    return (w.Inverse(node.of) for node in declared)


def _times(one: Node, other: Node) -> Node:
    for factor, by in ((one, other), (other, one)):
        if isinstance(by, w.Quotient) and by.numerator == ONE and not isinstance(factor, w.Quotient):
            return w.Quotient(factor, by.denominator)
    return one**2 if one == other else product_of(one, other)


def _is_named(node: Node) -> bool:
    return isinstance(node.of if isinstance(node, w.Rate | w.Skew) else node, w.Symbol)


def _is_factor(node: Node) -> bool:
    return node.shape[0] == node.shape[1] > 1 and (_is_named(node) or isinstance(node, w.Block | Shorthand))


def _by_direction(columns: Iterable[tuple[Node, Column]]) -> _Named:
    """Expressions by their values up to a number."""
    found: dict[tuple[int, ...], list[Node]] = {}
    for node, column in columns:
        found.setdefault(normalized(column), []).append(node)
    return found
