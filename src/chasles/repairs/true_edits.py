"""The right sides that are true with one edit at any depth: in a term, an entry, an argument, an exponent or a factor.

Where the scalar that a place needs is known at the points of the test, a number, a factor or a term that is missing is
looked up by its values among the products of what the equation is written with.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from chasles import vocabulary as w
from chasles.algebra.modular import MODULUS, Column, minus, multiple, rational
from chasles.repairs.factors import Factors
from chasles.repairs.local_edits import FORM, SingleEdit, edits_at
from chasles.repairs.modular_testing import ModularTest
from chasles.repairs.one_term import FACTOR, Change, instead, missing, new_term, other_number, rescaled
from chasles.repairs.required_values import Required, quotient, required_values, value
from chasles.repairs.single_edits import placed
from chasles.rewriting.coefficients import AngleFunction, scaled, times
from chasles.rewriting.places import Place, linear_places, with_term
from chasles.rewriting.term_basis import fit
from chasles.vocabulary import Node
from chasles.vocabulary.parts import Submatrix


def true_edits(test: ModularTest, factors: Factors) -> Iterator[Change]:
    """The right sides that are true with one edit, with one more scalar factor or with one more term."""
    yield from _by_factors(test, factors)
    linear = {place.path for place in linear_places(test.right)}
    for place in required_values(test, factors.at):
        node = place.node
        turned = not place.known and place.path not in linear
        edits = [*edits_at(place.node, place.parent, turned=turned), *_multiplied(place.node, place.parent, factors)]
        if place.path or not test.exchanged:
            edits += () if place.known else _unknown(place.node, place.parent, factors)
        found = [edit for edit in edits if place.allows(edit.node)]
        if place.known and (place.path or not test.exchanged):
            found += _by_value(place, factors)
        for new, words, effort in found:
            right = placed(test.right, place.path, new)
            if right.fault is None and fit(test.left, right):
                yield Change(test.left, right, (words or instead(new, node),), effort)


def _by_factors(test: ModularTest, factors: Factors) -> Iterator[Change]:
    """The right sides true with one more factor of a vector, matrix or block, or one more letter with factors."""
    residual = test.residual(factors.at)
    size = len(residual) // len(factors.at.points)

    def ratios(place: Place, term: Node | None = None) -> Column | None:
        contribution = test.contribution(factors.at, place, term)
        parts = [slice(k, k + size) for k in range(0, len(residual), size)]
        found = [multiple(residual[part], contribution[part]) for part in parts]
        return None if None in found else [ratio for ratio in found if ratio is not None]

    for place in linear_places(test.right):
        node = place.node
        if place.inside or node.is_scalar:
            continue
        found: list[tuple[Node, str, int]] = []
        if place.term and (place.path or not test.exchanged) and (ratio := ratios(place)):
            wanted = [(each + 1) % MODULUS for each in ratio]
            more = (times(f, node) for f in factors.of_values(wanted, most=1) if factors.columns[f] == wanted)
            found += [(new, instead(new, node), FACTOR + 1) for new in more]
        for letter in factors.tensors if place.open else ():
            if letter.shape == node.shape and (ratio := ratios(place, letter)):
                for factor, number in _multiples(factors, ratio, most=2):
                    term = times(factor, letter)
                    effort = new_term([(number, AngleFunction(factor))]) + 2 * (not place.apart)
                    found.append((with_term(node, term), missing(term), effort))
        for new, words, effort in found:
            right = placed(test.right, place.path, new)
            if right.fault is None and fit(test.left, right):
                yield Change(test.left, right, (words,), effort)


def _multiplied(node: Node, parent: Node | None, factors: Factors) -> Iterator[SingleEdit]:
    """A vector or a matrix with one more matrix as a factor."""
    parts = node.factors if isinstance(node, w.Contract) else (node,)
    outside = w.Sum | w.Negative | w.Scale | w.Quotient | w.Group | w.Zero
    alone = node.is_scalar and not isinstance(node, w.Contract)
    if alone or isinstance(parent, w.Contract | w.Transpose) or isinstance(node, outside):
        return
    for k in range(node.is_scalar, len(parts) + (not node.is_scalar)):
        for factor in factors.matrices:
            size = parts[k].shape[0] if k < len(parts) else parts[-1].shape[1]
            if factor.shape[0] == size:
                made = (*parts[:k], factor, *parts[k:])
                words = f"the factor {w.plain(factor)} is added"
                yield SingleEdit(w.printed(lambda: w.Contract(made)), words, FORM + 1)  # noqa: B023


def _unknown(node: Node, parent: Node | None, factors: Factors) -> Iterator[SingleEdit]:
    """Other letters, other numbers and more terms, where the values wanted of the place itself are not known."""
    if isinstance(node, w.Symbol | w.Zero):
        ones = (w.Identity(node.shape[0]),) if isinstance(node, w.Zero) and len({*node.shape}) == 1 else ()
        others = (*factors.letters, *ones)
        yield from (SingleEdit(other, "") for other in others if other != node and other.shape == node.shape)
    if isinstance(node, w.Number):
        numbers = (node.value + 1, node.value - 1, 2 * node.value, node.value / 2)
        least = 1 if isinstance(parent, w.Scale | w.Quotient) else 0
        yield from (SingleEdit(w.Number(number), "") for number in numbers if number > 0 and number != least)
        return
    if node.is_scalar and isinstance(node, w.Symbol | Submatrix | w.Call | w.Power):
        for factor in factors.simple:
            if isinstance(factor, w.Symbol | Submatrix):
                yield SingleEdit(times(factor, node), f"the factor {w.plain(factor)} is added", FACTOR + 1)
    if node.is_scalar or not isinstance(parent, w.Sum | w.Contract | w.Transpose):
        for factor in factors.simple if node.is_scalar else dict.fromkeys((*factors.letters, *factors.matrices)):
            if not isinstance(factor, w.Number) and factor != node and fit(factor, node):
                yield from (SingleEdit(with_term(node, t), missing(t), FORM + 1) for t in (factor, w.Negative(factor)))


def _by_value(place: Required, factors: Factors) -> Iterator[SingleEdit]:
    """What has the values wanted: a multiple of what is there, another factor or one more, one more term."""
    node, wanted = place.node, place.wanted
    present = value(factors.at, node)
    if present is None:
        return
    zero = not any(present)
    number = None if zero else _number(wanted, present)
    if number is not None:
        if place.term or (number and isinstance(node, w.Number)):
            new, words = rescaled(node, number)
            yield SingleEdit(w.Zero(1, 1) if new is None else new, words, other_number(number))
        return
    ratio = quotient(wanted, present)
    if ratio is not None and place.term:
        for factor in factors.of_values(ratio, most=1):
            if factors.columns[factor] == ratio:
                yield SingleEdit(times(factor, node), f"the factor {w.plain(factor)} is added", FACTOR + 1)
    most = 4 if place.term else 1
    if zero or isinstance(node, w.Symbol | w.Call | w.Power | w.Rate | w.Number):
        for other, number in _multiples(factors, wanted, most):
            yield SingleEdit(other, instead(other, node), FORM + (abs(number) != 1) + isinstance(other, w.Quotient))
    if not zero:
        for term, number in _multiples(factors, minus(wanted, present), most):
            if node in w.walk(term) or not fit(term, node):
                continue  # what takes away all that stands there says nothing
            effort = new_term([(number, AngleFunction(term))]) + (abs(number) != 1) + 2 * (not place.term)
            yield SingleEdit(with_term(node, term), missing(term), effort)


def _multiples(factors: Factors, column: Column, most: int) -> Iterator[tuple[Node, Fraction]]:
    """Rational multiples of products with these values, and the numbers."""
    for node in factors.of_values(column, most):
        own = value(factors.at, node)
        number = None if own is None else _number(column, own)
        new = None if number is None else scaled(node, number)
        if number is not None and new is not None:
            yield new, number


def _number(column: Column, of: Column) -> Fraction | None:
    """The rational number that one scalar is of another."""
    ratio = multiple(column, of)
    return None if ratio is None else rational(ratio)
