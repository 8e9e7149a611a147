"""The equations that differ from a printed one in one mark: a sign, a transpose, a factor of two, an order, a function.

A letter is exchanged only where it stands alone on a side, for one of the other side. No matrix of which nothing is
known is transposed: that would make an identity of the condition that it is symmetric.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from fractions import Fraction
from itertools import chain, islice, zip_longest

from chasles.vocabulary import (
    Call,
    Contract,
    Cross,
    Misfit,
    Negative,
    Node,
    Number,
    Quotient,
    Scale,
    Sum,
    Symbol,
    Transpose,
    children,
    rebuilt,
    symbols_of,
)

__all__ = ["one_mark_away"]

IsKnown = Callable[[Symbol], bool]
TWO = Number(Fraction(2))
OTHER_FUNCTION = {"cos": "sin", "sin": "cos"}


def one_mark_away(left: Node, right: Node, is_known: IsKnown) -> Iterator[tuple[Node, Node, str]]:
    """Both sides with one mark changed, and what was changed; sides that say nothing, or do not fit, are left out."""
    seen = {(left, right)}
    of_right = ((left, changed, said) for changed, said in chain(_scaled(right), _edits(right, is_known)))
    of_left = ((changed, right, said) for changed, said in chain(_other_letters(left, right), _edits(left, is_known)))
    for found in filter(None, chain.from_iterable(zip_longest(of_right, of_left))):
        one, other, said = found
        if one.shape == other.shape == left.shape and one != other and (one, other) not in seen:
            seen.add((one, other))
            yield one, other, said


def _other_letters(left: Node, right: Node) -> Iterator[tuple[Node, str]]:
    """The letters of the right side that can stand for one that is alone on the left."""
    if isinstance(left, Symbol) and left not in (found := symbols_of(right)):
        yield from ((other, f"{other} in place of {left}") for other in found if other.shape == left.shape != (1, 1))


def _scaled(node: Node) -> Iterator[tuple[Node, str]]:
    """The whole with another sign or factor."""
    yield node.term if isinstance(node, Negative) else Negative(node), f"the sign of {node} is turned"
    if isinstance(node, Scale) and node.factor == TWO:
        yield node.term, "a factor of two is left out"
    else:
        yield Scale(TWO, node), "a factor of two is added"
    yield Quotient(node, TWO), "a factor of one half is added"


def _edits(node: Node, is_known: IsKnown) -> Iterator[tuple[Node, str]]:
    """The expression with one mark changed anywhere in it."""
    with suppress(Misfit):
        yield from _here(node, is_known)
    parts = children(node)
    for place, part in enumerate(parts):
        for changed, said in _edits(part, is_known):
            with suppress(Misfit):
                yield rebuilt(node, (*parts[:place], changed, *parts[place + 1 :])), said


def _here(node: Node, is_known: IsKnown) -> Iterator[tuple[Node, str]]:
    match node:
        case Sum(terms):
            for place, term in enumerate(terms):
                for changed, said in islice(_scaled(term), 2):
                    yield Sum((*terms[:place], changed, *terms[place + 1 :])), said
        case Negative(term):
            yield term, f"the sign of {term} is turned"
        case Contract(factors):
            for place in range(len(factors) - 1):
                swapped = (*factors[:place], factors[place + 1], factors[place], *factors[place + 2 :])
                yield Contract(swapped), f"{factors[place]} and {factors[place + 1]} are exchanged"
        case Cross(one, other):
            yield Cross(other, one), f"{one} and {other} are exchanged"
        case Call(function, argument) if function in OTHER_FUNCTION:
            yield Call(OTHER_FUNCTION[function], argument), f"{OTHER_FUNCTION[function]} in place of {function}"
        case Transpose(of) if of.shape[0] == of.shape[1] and _is_known(of, is_known):
            yield of, f"{of} is not transposed"
        case Number(value) if value in (2, 4):
            yield Number(value / 2), "a factor of two is left out"
        case Quotient(numerator, Number(value)) if value == 2:
            yield numerator, "a factor of one half is left out"
        case Symbol() if node.shape == (3, 3) and _is_known(node, is_known):
            yield Transpose(node), f"{node} is transposed"


def _is_known(node: Node, is_known: IsKnown) -> bool:
    return not isinstance(node, Symbol) or node.stands_for is not None or is_known(node)
