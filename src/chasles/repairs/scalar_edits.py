"""One edit inside a scalar at any depth, in an entry of a matrix, in an argument, in an exponent or in a factor.

The scalar that a place needs is known at the points of the test, so that a number, a factor or a term that is missing
is looked up by its values among the products of what the equation is written with.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping
from fractions import Fraction
from functools import cached_property
from itertools import combinations_with_replacement, islice

from chasles.algebra.modular import MODULUS, Column, minus, multiple, normalized, rational
from chasles.repairs.local_edits import FORM, SingleEdit, edits_at
from chasles.repairs.modular_testing import ModularTest
from chasles.repairs.one_term import FACTOR, Change, instead, missing, new_term, other_number, rescaled
from chasles.repairs.required_values import Required, quotient, required_values, value
from chasles.repairs.residues import Sampled
from chasles.repairs.single_edits import placed
from chasles.rewriting.coefficients import ONE, AngleFunction, scaled, times
from chasles.rewriting.coefficients import product as product_of
from chasles.rewriting.places import linear_places, with_term
from chasles.rewriting.term_basis import fit
from chasles.vocabulary import Call, Node, Number, Power, Rate, Sum, Symbol, Zero, plain, walk

__all__ = ["Factors", "scalar_edits"]

MOST_FACTORS = 48
"""So many scalars are multiplied with each other to find a term that is missing."""
SCOUTS = 3
"""Points at which the scalars are evaluated."""


class Factors:
    """The scalars that an equation is written with, by their values at points, and their products."""

    def __init__(self, test: ModularTest, nodes: Iterable[Node], without: Container[Node]) -> None:
        self.at = Sampled(test.varied.context, test.varied.points[:SCOUTS])
        parts = dict.fromkeys(part for node in nodes for part in walk(node))
        found = [part for part in parts if part.is_scalar and not any(inner in without for inner in walk(part))]
        both = [Call(f, node.argument) for node in found if isinstance(node, Call) for f in ("cos", "sin")]
        self.letters = tuple(node for node in found if isinstance(node, Symbol))
        rates = [Rate(s) for s in self.letters if not s.constant] if any(isinstance(n, Rate) for n in parts) else []
        self.columns: dict[Node, Column] = {}
        for node in (ONE, *found, *both, *rates):
            column = value(self.at, node)
            if column is not None and all(column) and (node == ONE or not isinstance(node, Number)):
                self.columns.setdefault(node, column)

    @cached_property
    def single(self) -> Mapping[tuple[int, ...], list[Node]]:
        """The scalars, those of the same values up to a number together."""
        found: dict[tuple[int, ...], list[Node]] = {}
        for node, column in self.columns.items():
            found.setdefault(normalized(column), []).append(node)
        return found

    @cached_property
    def pairs(self) -> Mapping[tuple[int, ...], list[Node]]:
        """Products of two factors."""
        found: dict[tuple[int, ...], list[Node]] = {}
        for one, other in combinations_with_replacement(self._simple, 2):
            column = self.at.times(one, self.columns[other])
            made = one**2 if one == other else product_of(one, other)
            found.setdefault(normalized(column), []).append(made)
        return found

    @cached_property
    def _simple(self) -> list[Node]:
        return list(
            islice((n for n in self.columns if isinstance(n, Symbol | Call | Rate | Power | Sum)), MOST_FACTORS)
        )

    def of_values(self, column: Column, most: int = 3) -> Iterator[Node]:
        """The products of at most so many factors that have these values, up to a number."""
        direction = normalized(column)
        found = self.single.get(direction, []) or (self.pairs.get(direction, []) if most > 1 else [])
        yield from found
        if found or most < 3:
            return
        for factor in self._simple:
            rest = quotient(column, self.columns[factor])
            if rest is not None and (pair := self.pairs.get(normalized(rest))):
                yield product_of(factor, pair[0])
                return


def scalar_edits(test: ModularTest, factors: Factors) -> Iterator[Change]:
    """The right sides that are true with one edit inside a scalar, or one more scalar factor."""
    yield from _lost_factors(test, factors)
    for place in required_values(test, factors.at):
        looked_up = place.known and not (test.exchanged and not place.path)
        found = [*_by_value(place, factors)] if looked_up else [*_inside(place, factors)]
        edits = (edit for edit in edits_at(place.node) if place.allows(factors.at, edit.node))
        for new, words, effort in (*found, *edits):
            right = placed(test.right, place.path, new)
            if right.fault is None and fit(test.left, right):
                yield Change(test.left, right, (words or instead(new, place.node),), effort)


def _lost_factors(test: ModularTest, factors: Factors) -> Iterator[Change]:
    """The right sides that are true with one more scalar factor of a vector, a matrix or a block."""
    residual = test.residual(factors.at)
    size = len(residual) // SCOUTS
    for place in linear_places(test.right):
        if not place.term or place.inside or place.node.is_scalar or (test.exchanged and not place.path):
            continue
        term = test.contribution(factors.at, place)
        ratios = [multiple(residual[k : k + size], term[k : k + size]) for k in range(0, len(residual), size)]
        wanted = [(ratio + 1) % MODULUS for ratio in ratios if ratio is not None]
        for factor in factors.of_values(wanted, most=1) if len(wanted) == len(ratios) else ():
            new = times(factor, place.node)
            right = placed(test.right, place.path, new)
            if value(factors.at, factor) == wanted and right.fault is None and fit(test.left, right):
                yield Change(test.left, right, (instead(new, place.node),), FACTOR + 1)


def _by_value(place: Required, factors: Factors) -> Iterator[SingleEdit]:
    """What has the values wanted: a multiple of what is there, another factor or one more, one more term."""
    node, wanted = place.node, place.wanted
    present = value(factors.at, node)
    if present is None:
        return
    zero = not any(present)
    ratio = None if zero else quotient(wanted, present)
    number = None if zero else _number(wanted, present)
    if number is not None:
        if place.term or isinstance(node, Number):
            new, words = rescaled(node, number)
            yield SingleEdit(Zero(1, 1) if new is None else new, words, other_number(number))
        return
    if ratio is not None and place.term:
        for factor in factors.of_values(ratio, most=1):
            if _number(ratio, factors.columns[factor]) == 1:
                yield SingleEdit(times(factor, node), f"the factor {plain(factor)} is added", FACTOR + 1)
    if zero or isinstance(node, Symbol | Call | Power | Rate | Number):
        yield from _others(place, factors, wanted)
    if not zero:
        for term, effort in _multiples(factors, minus(wanted, present), 3 if place.term else 1):
            yield SingleEdit(with_term(node, term), missing(term), effort + 2 * (not place.term))


def _others(place: Required, factors: Factors, wanted: Column) -> Iterator[SingleEdit]:
    for other, effort in _multiples(factors, wanted, 3 if place.term else 1):
        yield SingleEdit(other, instead(other, place.node), FORM if effort == 4 else effort)


def _multiples(factors: Factors, column: Column, most: int) -> Iterator[tuple[Node, int]]:
    """Rational multiples of products with these values, and the effort of adding them."""
    for node in factors.of_values(column, most):
        own = value(factors.at, node)
        number = None if own is None else _number(column, own)
        new = None if number is None else scaled(node, number)
        if number is not None and new is not None:
            yield new, new_term([(number, AngleFunction(node))]) + (abs(number) != 1)


def _number(column: Column, of: Column) -> Fraction | None:
    """The rational number that one scalar is of another."""
    ratio = multiple(column, of)
    return None if ratio is None else rational(ratio)


def _inside(place: Required, factors: Factors) -> Iterator[SingleEdit]:
    """Letters in the place of others, numbers and terms, where the values of the place itself are not known."""
    node = place.node
    news: list[Node] = []
    if isinstance(node, Symbol):
        news += [letter for letter in factors.letters if letter != node]
    for new in news:
        if place.allows(factors.at, new):
            yield SingleEdit(new, "")
