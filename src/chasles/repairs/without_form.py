"""One edit of a side: tried at points in floating point where the equation has no polynomial form."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from itertools import chain, islice
from typing import TYPE_CHECKING

from chasles import vocabulary as w
from chasles.repairs.local_edits import FORM, SingleEdit, turned_signs
from chasles.repairs.one_term import FACTOR, SIGN, Change, instead
from chasles.repairs.single_edits import exchanged_letters, in_letters, placed, single_edits
from chasles.rewriting.coefficients import ONE, times
from chasles.rewriting.places import everywhere, with_term
from chasles.statements.inequalities import ZERO, difference_of, says_that
from chasles.vocabulary import Node
from chasles.vocabulary.families import Entry, Index, Member
from chasles.vocabulary.functions import FunctionOf, Relation

if TYPE_CHECKING:
    from chasles.repairs.real_test import RealTest

TURNED = {"arcsin": "arccos", "arccos": "arcsin", "sinh": "cosh", "cosh": "sinh", "max": "min", "min": "max"}
MOST = 2000
"""Edits of a side that are tried."""
OTHER_NUMBERS = (2, Fraction(1, 2), -1, 4, Fraction(1, 4), 3, Fraction(1, 3))


def changes_without_form(
    test: RealTest, left: Node, right: Node, letters: list[w.Symbol], given: Iterable[Node]
) -> Iterator[Change]:
    """The sides with one edit on either that agree at points where the hypotheses hold; none where none is found."""
    scalars = dict.fromkeys(part for side in (left, right, *given) for part in w.walk(side) if part.is_scalar)
    angles = dict.fromkeys(part.argument for part in scalars if isinstance(part, w.Call))
    scalars |= dict.fromkeys(w.Call(function, angle) for angle in angles for function in ("cos", "sin"))
    tried = edited(left, right, lambda side: chain(edits_of(side, letters), _with_scalars(side, scalars)))
    yield from (change for change in tried if test.agree(change.left, change.right))


def edited(left: Node, right: Node, edits: Callable[[Node], Iterator[SingleEdit]]) -> Iterator[Change]:
    """The sides with one of the edits of the right one, then of the left one; of an inequality, of its difference."""
    if (difference := difference_of(left, right)) is not None:
        for new, words, effort in islice(edits(difference), MOST):
            sign = ">=" if left == abs(difference) else ">"
            yield Change(*says_that(Relation(new, sign, ZERO)), (words,), effort)
        return
    for new, words, effort in islice(edits(right), MOST):
        yield Change(left, new, (words,), effort)
    for new, words, effort in islice(edits(left), MOST):
        yield Change(new, right, (words,), effort)


def _with_scalars(side: Node, scalars: Iterable[Node]) -> Iterator[SingleEdit]:
    """The side with a part multiplied or divided by a scalar that is printed somewhere, or with it or its square added.

    What is part of a product is not multiplied, nor is a term added to one: that is the same done to the whole.
    """
    products = w.Number | w.Negative | w.Scale | w.Quotient
    simple = [ONE, *(scalar for scalar in scalars if not isinstance(scalar, products))]
    parts = dict(everywhere(side))
    for path, part in parts.items():
        parent = parts[path[:-1]] if path else None
        if isinstance(part, w.Group) or isinstance(parent, w.Negative | w.Group):
            continue
        for scalar in simple:
            made = w.printed(lambda: [*_combined(part, scalar, parent)])  # type: ignore[type-var]  # noqa: B023
            for new in made if scalar != part else ():
                whole = placed(side, path, new)
                if whole.fault is None:
                    yield SingleEdit(whole, instead(new, part), FORM + 1 + isinstance(new, w.Sum))


def _combined(part: Node, scalar: Node, parent: Node | None) -> Iterator[Node]:
    if part.is_scalar and not isinstance(parent, w.Sum):
        for term in (scalar,) if scalar == ONE else (scalar, w.Power(scalar, 2)):
            yield from (with_term(part, term), with_term(part, w.Negative(term)))
    if scalar != ONE and not isinstance(part, w.Number | w.Negative) and not isinstance(parent, w.Scale | w.Quotient):
        yield times(scalar, part)
        yield w.Quotient(part, scalar)


def edits_of(side: Node, letters: list[w.Symbol], indices: Iterable[Index] = ()) -> Iterator[SingleEdit]:
    """The side with one slip undone: of form, of a letter, a sign, a number, a function or an index."""
    yield from chain(single_edits(side), in_letters(side, letters), exchanged_letters(side))
    parts = dict(everywhere(side))
    for path, part in parts.items():
        parent = parts[path[:-1]] if path else None
        in_product = isinstance(parent, w.Scale | w.Quotient)
        for new, effort in (*_of_functions(part), *_of_indices(part, indices)):
            if isinstance(parent, w.Negative) and isinstance(new, w.Negative):
                continue  # it is turned where the sign stands
            whole = placed(side, path, new)
            if whole.fault is None and not (in_product and new == ONE):
                yield SingleEdit(whole, instead(new, part), effort)


def _of_functions(part: Node) -> Iterator[tuple[Node, int]]:
    match part:
        case w.Number(value):
            yield from ((w.Number(value * factor), FACTOR) for factor in OTHER_NUMBERS)
            yield from ((w.Number(value + more), FACTOR + 1) for more in (1, -1))
        case FunctionOf(function, arguments):
            if function in TURNED:
                yield FunctionOf(TURNED[function], arguments), FACTOR
            if len(arguments) > 1:
                yield FunctionOf(function, arguments[::-1]), FACTOR
            if function in ("sqrt", "abs"):
                yield arguments[0], FACTOR
        case w.Sum():
            yield from ((edit.node, SIGN) for edit in turned_signs(part))
    if isinstance(part, w.Negative):
        yield part.term, SIGN
    elif part.is_scalar and not isinstance(part, w.Number):
        yield w.Negative(part), SIGN
        yield w.Power(part, 2), FORM
        yield from ((w.Scale(w.Number(Fraction(factor)), part), FACTOR) for factor in (2, Fraction(1, 2)))
        if isinstance(part, w.Sum | w.Power):
            yield w.printed(lambda: FunctionOf("sqrt", (part,))), FORM


def _of_indices(part: Node, indices: Iterable[Index]) -> Iterator[tuple[Node, int]]:
    match part:
        case Member(family, index):
            yield from ((Member(family, other), FORM) for other in indices if other != index)
        case Entry(of, i, j, letter):
            yield Entry(of, j, i, letter), FORM
