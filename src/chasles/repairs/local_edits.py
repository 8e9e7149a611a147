"""What one slip of form, undone at the root of an expression, makes of it.

Lost and added transposes, dots and factors, brackets that closed too early, sines for cosines, halves of angles, other
exponents, products and blocks in another order.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace as with_fields
from fractions import Fraction
from itertools import combinations
from typing import NamedTuple, TypeVar

from chasles import vocabulary as w
from chasles.repairs.one_term import FACTOR, SIGN
from chasles.rewriting.coefficients import negated
from chasles.rewriting.product import contraction
from chasles.vocabulary import Node
from chasles.vocabulary.parts import Submatrix
from chasles.vocabulary.parts import part as entry

_T = TypeVar("_T")
FORM = 3
"""The effort of undoing a slip of form, or of a wrong letter."""
TWO = w.Number(Fraction(2))
_MADE_OF_OTHERS = w.Transpose | w.Sum | w.Negative | w.Scale | w.Quotient | w.Group | w.Identity | w.Zero
"""What is transposed by its parts, or not changed by that."""
_Times = Callable[[Node], Node]


class SingleEdit(NamedTuple):
    """An expression with one slip undone, what was changed in words, and how much that is."""

    node: Node
    words: str
    effort: int = FORM


def edits_at(part: Node, parent: Node | None, *, turned: bool) -> Iterator[SingleEdit]:
    """The edits at the root of an expression that stands in another; signs only if `turned`."""
    made = w.printed(lambda: [*_of_form(part), *_of_factors(part), *_of_rates(part, parent)])  # type: ignore[type-var]
    yield from (SingleEdit(new, "") for new in made)
    powers = w.printed(lambda: list(_exponents(part, parent)))  # type: ignore[type-var]
    yield from (SingleEdit(new, "", FACTOR if part.is_scalar or isinstance(part, w.Power) else FORM) for new in powers)
    yield from _with_factor(part)
    flat = not isinstance(part, _MADE_OF_OTHERS) and part.measure is not None and max(part.shape) > 1
    if flat and not isinstance(parent, w.Rate | w.Transpose):
        yield SingleEdit(w.Transpose(part), "")
    if turned:
        yield from turned_signs(part)


def _of_form(node: Node) -> Iterator[Node]:
    match node:
        case w.Transpose(of) | w.Inverse(of):
            yield of
        case w.Call(function, argument):
            yield w.Call({"sin": "cos", "cos": "sin"}[function], argument)
            if not isinstance(argument, w.Scale | w.Quotient):
                yield w.Call(function, w.Quotient(argument, TWO))
                yield w.Call(function, w.Scale(TWO, argument))
        case w.Cross(left, right) if left != right:
            yield w.Cross(right, left)
        case w.Contract(factors):
            yield from (w.Contract(_exchanged(factors, k, k + 1)) for k in range(len(factors) - 1))
            for k, factor in enumerate(factors):
                if isinstance(factor, w.Symbol) and factor.shape[0] == factor.shape[1] > 1:
                    yield w.Contract((*factors[:k], w.Inverse(factor), *factors[k + 1 :]))
        case w.Block(rows):
            yield from _rearranged(rows)
        case Submatrix(of, (i, last), (j, end)) if (i, j) == (last, end):
            height, width = of.shape
            places = [*((k, j) for k in range(1, height + 1)), *((i, k) for k in range(1, width + 1)), (j, i)]
            inside = (place for place in dict.fromkeys(places) if place[0] <= height and place[1] <= width)
            yield from (entry(of, max(place) if 1 in (height, width) else place) for place in inside if place != (i, j))


def _exponents(node: Node, parent: Node | None) -> Iterator[Node]:
    """One power more or less."""
    if isinstance(node, w.Power):
        yield w.Power(node.base, node.exponent + 1)
        yield node.base if node.exponent == 2 else w.Power(node.base, node.exponent - 1)
    elif isinstance(node, w.Symbol | w.Call | w.Norm | Submatrix):
        if node.shape[0] == node.shape[1] and not isinstance(parent, w.Power):
            yield w.Power(node, 2)
    elif isinstance(node, w.Sum | w.Group) and node.is_scalar and isinstance(parent, w.Scale | w.Quotient):
        yield w.Power(node, 2)


def _rearranged(rows: tuple[tuple[Node, ...], ...]) -> Iterator[Node]:
    """The blocks with two rows, two columns or two blocks exchanged."""
    for k, n in combinations(range(len(rows)), 2):
        yield w.Block(_exchanged(rows, k, n))
    for k, n in combinations(range(len(rows[0])), 2):
        yield w.Block(tuple(_exchanged(row, k, n) for row in rows))
    blocks, width = sum(rows, ()), len(rows[0])
    for k, n in combinations(range(len(blocks)), 2):
        if blocks[k] != blocks[n] and len(rows) > 1 < width:
            yield w.rebuilt(w.Block(rows), _exchanged(blocks, k, n))


def _of_factors(node: Node) -> Iterator[Node]:
    """A factor too many, multiplied with in place of divided by, or meant for the terms beside it too."""
    match node:
        case w.Scale(factor, term):
            yield term
            if term.is_scalar:
                yield factor
                yield w.Quotient(factor, term)
            yield w.Quotient(term, factor)
        case w.Quotient(numerator, denominator):
            yield numerator
            yield w.Scale(denominator, numerator)
        case w.Contract(factors):
            yield from (contraction(factors[:k] + factors[k + 1 :]) for k in range(len(factors)))
        case w.Sum(terms):
            for k, term in enumerate(terms):
                for outer in _outer(term):
                    yield from _gathered(terms, k, outer)


def _outer(term: Node) -> Iterator[tuple[Node, _Times, bool]]:
    """The term without what it is multiplied with in front or behind, which is put there again; which it is."""
    match term:
        case w.Negative(of):
            yield from ((w.Negative(inner), times, front) for inner, times, front in _outer(of))
        case w.Scale(factor, of):
            yield of, lambda part: with_fields(term, term=part), not term.trailing
            if of.is_scalar:
                yield factor, lambda part: w.Scale(part, of), False
        case w.Quotient(numerator, _):
            yield numerator, lambda part: with_fields(term, numerator=part), False
        case w.Contract(factors):
            for k in range(1, len(factors)):
                yield contraction(factors[k:]), _before(factors[:k]), True
                yield contraction(factors[:k]), _behind(factors[k:]), False
        case w.Cross(left, right) | w.Dot(left, right):
            yield right, lambda part: w.rebuilt(term, (left, part)), True
            yield left, lambda part: w.rebuilt(term, (part, right)), False


def _before(factors: tuple[Node, ...]) -> _Times:
    return lambda part: w.Contract((*factors, part))


def _behind(factors: tuple[Node, ...]) -> _Times:
    return lambda part: w.Contract((part, *factors))


def _gathered(terms: tuple[Node, ...], k: int, outer: tuple[Node, _Times, bool]) -> Iterator[Node]:
    """What a term is multiplied with, for the terms that follow it too, or for those before it."""
    inner, times, front = outer
    for first, last in (*((k, end) for end in range(k + 2, len(terms) + 1)), *((begin, k + 1) for begin in range(k))):
        kept = [inner if n == k else terms[n] for n in range(first, last)]
        leading = kept[0] if front else None
        turned = isinstance(leading, w.Negative)
        inside = w.Sum(tuple(negated(each) for each in kept)) if turned else w.Sum(tuple(kept))
        made = w.Negative(times(w.Group(inside))) if turned else times(w.Group(inside))
        whole = (*terms[:first], made, *terms[last:])
        yield whole[0] if len(whole) == 1 else w.Sum(whole)


def _of_rates(node: Node, parent: Node | None) -> Iterator[Node]:
    """A dot too many or too few, also of a whole side, or over the other factor of a product."""
    if parent is None and not isinstance(node, w.Rate | w.Symbol | w.Inverse):
        yield w.Rate(node)
    match node:
        case w.Rate(of):
            yield of
            if not isinstance(parent, w.Rate):
                yield w.Rate(node)
        case w.Symbol() if not node.constant and node.stands_for is None and not isinstance(parent, w.Rate):
            yield w.Rate(node)
        case w.Inverse():
            yield w.Rate(node)
        case w.Scale() | w.Cross() | w.Dot() | w.Contract((_, _)):
            match w.children(node):
                case (w.Rate(left), right) if not isinstance(right, w.Rate):
                    yield w.rebuilt(node, (left, w.Rate(right)))
                case (left, w.Rate(right)) if not isinstance(left, w.Rate):
                    yield w.rebuilt(node, (w.Rate(left), right))


def _exchanged(items: tuple[_T, ...], k: int, n: int) -> tuple[_T, ...]:
    return (*items[:k], items[n], *items[k + 1 : n], items[k], *items[n + 1 :])


def turned_signs(node: Node) -> Iterator[SingleEdit]:
    """A sum with the sign of one term turned, or blocks with that of one block."""
    parts = w.children(node) if isinstance(node, w.Sum | w.Block) else ()
    for k, part in enumerate(parts):
        if not isinstance(part, w.Zero | w.Block) and not (isinstance(node, w.Block) and isinstance(part, w.Sum)):
            yield SingleEdit(w.rebuilt(node, (*parts[:k], negated(part), *parts[k + 1 :])), "", SIGN)


def _with_factor(node: Node) -> Iterator[SingleEdit]:
    """A common factor that was meant for some of the blocks or terms behind it."""
    match node:
        case w.Scale(Node() as factor, w.Block() | w.Sum() as whole) if factor.is_scalar:
            yield from _for_some(whole, lambda part: w.Scale(factor, part), w.plain(factor))
        case w.Quotient(w.Block() | w.Sum() as whole, divisor):
            yield from _for_some(whole, lambda part: with_fields(node, numerator=part), w.plain(1 / divisor))


def _for_some(whole: w.Block | w.Sum, times: _Times, factor: str) -> Iterator[SingleEdit]:
    parts = w.children(whole)
    places = [k for k, part in enumerate(parts) if not isinstance(part, w.Zero)]
    for size in range(1, min(len(places), 4)):
        for chosen in combinations(places, size):
            new = [_signed(part, times) if k in chosen else part for k, part in enumerate(parts)]
            names = " and ".join(w.plain(parts[k]) for k in chosen)
            made = w.printed(lambda: w.rebuilt(whole, tuple(new)))  # noqa: B023
            yield SingleEdit(made, f"the factor {factor} is that of {names} only", FACTOR)


def _signed(part: Node, times: _Times) -> Node:
    """What `times` makes of the part, its sign in front."""
    return w.Negative(times(part.term)) if isinstance(part, w.Negative) else times(part)
