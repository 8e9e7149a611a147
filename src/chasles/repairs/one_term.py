"""One change to the right side: another coefficient, a term left out, a term that was missing.

A change must contribute the residual of the equation, which is known. So each is tested by comparing two columns of
residues, and the coefficient of a term that was missing is the solution of a small linear system.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from chasles.algebra.modular import MODULUS, Column, combination, multiple, plus, rational
from chasles.repairs.modular_testing import ModularTest
from chasles.rewriting.coefficients import ONE, AngleFunction, scaled, spelled, times
from chasles.rewriting.places import Place, linear_places, put, with_term
from chasles.rewriting.term_basis import TermBasis
from chasles.vocabulary import Block, Negative, Node, Sum, plain

Coefficient = list[tuple[Fraction, AngleFunction]]
"""A sum of numbers times functions."""
SIGN, FACTOR, LEFT_OUT, REPLACED = 0, 1, 3, 4
"""The effort of turning a sign, of a factor, of leaving a term out, and of putting another in its place."""


@dataclass(frozen=True, slots=True)
class Change:
    """An equation after some changes, each in plain words; `effort` ranks the same number of changes.

    `modulo` says why another object may stand on the left side, where one does; the first `marks` changes restore what
    was lost before it fitted together.
    """

    left: Node
    right: Node
    words: tuple[str, ...]
    effort: int = 0
    modulo: str | None = None
    marks: int = 0


def other_number(number: Fraction) -> int:
    """The effort of multiplying a term by a number: least for a sign, less for whole numbers and halves than others.

    A negative one is a factor and a sign, two slips.
    """
    return LEFT_OUT if number == 0 else SIGN if number == -1 else FACTOR + (number.denominator > 2) + 2 * (number < 0)


def other_coefficient(coefficient: Coefficient) -> int:
    """The effort of changing a coefficient: it grows with the terms of the new one, and zero leaves the term out."""
    terms = sum(1 for value, _ in coefficient if value)
    return 1 + terms if terms else LEFT_OUT


def new_term(coefficient: Coefficient) -> int:
    """The effort of adding a term: more than that of any simple change of what is printed."""
    return 2 + other_coefficient(coefficient)


def instead(new: Node, old: Node) -> str:
    """A change of one part for another, in words."""
    return f"{plain(new)} instead of {plain(old)}"


def missing(term: Node) -> str:
    """A term that was missing, in words."""
    return f"the term {plain(term)} is added"


def new_coefficients(test: ModularTest) -> Iterator[Change]:
    """The right sides that are true with another coefficient of one term, of a block or of the whole."""
    residual = test.residual(test.probe)
    for place in linear_places(test.right):
        if not place.term or (test.exchanged and not place.path):
            continue
        contribution = test.contribution(test.probe, place)
        ratio = multiple(residual, contribution)
        number = None if ratio is None else rational(ratio)
        if number == -1 and not place.path:
            continue  # if nothing that is printed stays, nothing was repaired
        if number is not None:
            new, words = rescaled(place.node, number + 1)
            yield Change(test.left, put(test.right, place.path, new), (words,), other_number(number + 1))


def rescaled(term: Node, number: Fraction) -> tuple[Node | None, str]:
    """A rational multiple of a term, None for none of it, and the change in words."""
    new = scaled(term, number)
    if new is None:
        return None, f"the term {plain(term)} is left out"
    return new, f"the sign of {plain(term)} is turned" if number == -1 else instead(new, term)


def fitted(test: ModularTest, cores: Sequence[Column], wanted: Column) -> list[Coefficient] | None:
    """The coefficients of cores, given at the varied points, that make up what is wanted; None unless unique."""
    for functions in (test.functions, test.fractions, test.squares):
        columns = [test.times(test.varied, function, core) for core in cores for function in functions]
        values = combination(columns, wanted)
        if values is not None:
            size = len(functions)
            return [list(zip(values[k : k + size], functions, strict=True)) for k in range(0, len(values), size)]
    return None


def other_terms(test: ModularTest, basis: TermBasis) -> Iterator[Change]:
    """The right sides that are true with one more term somewhere, or with another behind a printed coefficient."""
    for place in linear_places(test.right):
        if place.inside or (place.node.is_scalar and place.path):
            continue
        terms = place.node.terms if isinstance(place.node, Sum) else (place.node,)
        new = distinct_terms(test, basis.terms(place.node), terms)
        if place.open:
            yield from _completed(test, place, new)
        if place.term and place.apart and not isinstance(place.node, Sum | Block):
            yield from _replaced(test, place, new)


def distinct_terms(test: ModularTest, terms: Iterable[Node], known: Iterable[Node | None]) -> tuple[Node, ...]:
    """The terms that are no multiples of each other, nor of known ones, where the angles are fixed; none is zero."""
    seen = {test.direction(node) for node in known if node is not None} | {()}
    kept: list[Node] = []
    for term in terms:
        direction = test.direction(term)
        if direction not in seen:
            seen.add(direction)
            kept.append(term)
    return tuple(kept)


def _completed(test: ModularTest, place: Place, terms: Iterable[Node]) -> Iterator[Change]:
    for term in terms:
        if multiple(test.residual(test.probe), test.contribution(test.probe, place, term)) is None:
            continue
        found = fitted(test, [test.contribution(test.varied, place, term)], test.residual(test.varied))
        if found and (coefficient := spelled(found[0])) is not None:
            new = times(coefficient, term)
            right = put(test.right, place.path, with_term(place.node, new))
            yield Change(test.left, right, (missing(new),), new_term(found[0]) + 2 * (not place.apart))


def _replaced(test: ModularTest, place: Place, terms: Iterable[Node]) -> Iterator[Change]:
    """Another core behind the printed coefficient; with no coefficient, only if there are other terms or blocks."""
    coefficient = test.split(place.node).coefficient
    if coefficient == ONE and not place.path:
        return
    wanted = plus(test.residual(test.probe), test.contribution(test.probe, place))
    for term in terms:
        new = times(coefficient, term)
        sign = multiple(wanted, test.contribution(test.probe, place, new))
        if sign in (1, MODULUS - 1):
            new = new if sign == 1 else Negative(new)
            yield Change(test.left, put(test.right, place.path, new), (instead(new, place.node),), REPLACED)
