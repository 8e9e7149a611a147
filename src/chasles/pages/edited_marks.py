"""The equations that differ from a printed one by one slip: in a sign, a factor of two, a form, an order or a letter.

No matrix of which nothing is known is transposed: that would make an identity of the condition that it is symmetric.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from itertools import chain, islice, zip_longest

from chasles.repairs.one_term import instead
from chasles.repairs.single_edits import in_letters, placed, single_edits
from chasles.rewriting.places import everywhere
from chasles.vocabulary import Group, Negative, Node, Number, Quotient, Scale, Sum, Symbol, Transpose, symbols_of, walk
from chasles.vocabulary.functions import FunctionOf
from chasles.vocabulary.tree import replace

IsKnown = Callable[[Symbol], bool]
TWO = Number(Fraction(2))
SaidOf = Callable[[Node, Node], str]
SMALL = tuple(map(Fraction, range(1, 5)))
"""Numbers of which one is put for another."""


def unsaid(new: Node, old: Node) -> str:
    """Nothing of what was changed."""
    return ""


def in_words(new: Node, old: Node) -> str:
    """What was changed, in words."""
    for one, other in ((new, old), (old, new)):
        if one == Negative(other):
            return f"the sign of {other} is turned"
    return instead(new, old)


def one_mark_away(
    left: Node, right: Node, more: Iterable[Symbol], is_known: IsKnown, said_of: SaidOf = unsaid
) -> Iterator[tuple[Node, Node, str]]:
    """Both sides with one mark changed, and what was changed; sides that say nothing, or do not fit, are left out.

    The letters that one may be meant for are those of the sides, and `more`. To say what was changed takes long, and is
    left to `said_of`.
    """
    seen, turned = {(left, right)}, _turned((left, right), is_known)
    has_roots = any(map(_is_root, (*walk(left), *walk(right))))
    printed = _with_roots_taken(left), _with_roots_taken(right)
    letters = tuple(dict.fromkeys((*symbols_of(left), *symbols_of(right), *more)))
    of_right = ((left, *edit) for edit in chain(_scaled(right, said_of), _edits(right, letters, said_of)))
    of_left = ((changed, right, said) for changed, said in _edits(left, letters, said_of))
    for one, other, said in filter(None, chain.from_iterable(zip_longest(of_right, of_left))):
        fits = one.fault is other.fault is None and one.shape == other.shape == left.shape and one != other
        is_other_root = has_roots and (_with_roots_taken(one), _with_roots_taken(other)) == printed
        has_square = has_roots and any(map(_is_root_of_a_square, (*walk(one), *walk(other))))
        if (
            fits
            and not (is_other_root or has_square)
            and (one, other) not in seen
            and _turned((one, other), is_known) == turned
        ):
            seen.add((one, other))
            yield one, other, said


def _with_roots_taken(node: Node) -> Node:
    """The expression with one sign for every root: with the other it speaks of the other solution."""
    negative = [part for part in walk(node) if isinstance(part, Negative) and _is_root(part.term)]
    signs: dict[Node, Node] = {part: part.term for part in negative}
    return replace(node, signs) if signs else node


def _is_root(node: Node) -> bool:
    match node:
        case FunctionOf("sqrt"):
            return True
        case Group() | Scale() | Quotient():
            return any(map(_is_root, node.below))
    return False


def _is_root_of_a_square(node: Node) -> bool:
    """Whether it is a root that nobody writes: that of one or four."""
    return isinstance(node, FunctionOf) and node.arguments in ((Number(Fraction(1)),), (Number(Fraction(4)),))


def _turned(sides: tuple[Node, Node], is_known: IsKnown) -> Counter[Node]:
    """The letters of which nothing is known, as often as they are transposed."""
    turned = (part.of for side in sides for part in walk(side) if isinstance(part, Transpose))
    return Counter(of for of in turned if isinstance(of, Symbol) and of.stands_for is None and not is_known(of))


def _scaled(node: Node, said_of: SaidOf) -> Iterator[tuple[Node, str]]:
    """The whole with another sign or factor."""
    turned = node.term if isinstance(node, Negative) else Negative(node)
    yield turned, said_of(turned, node)
    if isinstance(node, Scale) and node.factor == TWO:
        yield node.term, "a factor of two is left out"
    else:
        yield Scale(TWO, node), "a factor of two is added"
    yield Quotient(node, TWO), "a factor of one half is added"


def _edits(node: Node, letters: tuple[Symbol, ...], said_of: SaidOf) -> Iterator[tuple[Node, str]]:
    """The expression with one mark changed anywhere in it, or one letter for another."""
    for path, part in everywhere(node):
        for changed, said in _here(part, said_of):
            yield placed(node, path, changed), said
    for edit in chain(single_edits(node, said_of), in_letters(node, letters, told=said_of)):
        yield edit.node, edit.words


def _here(node: Node, said_of: SaidOf) -> Iterator[tuple[Node, str]]:
    match node:
        case Sum(terms):
            for place, term in enumerate(terms):
                for changed, said in islice(_scaled(term, said_of), 2):
                    yield Sum((*terms[:place], changed, *terms[place + 1 :])), said
        case Negative(term):
            yield term, said_of(term, node)
        case Scale(Number(value), term) if value in SMALL:
            yield term, f"a factor of {value} is left out"
        case Number(value) if value in SMALL:
            yield from ((Number(other), f"{other} for {value}") for other in SMALL[1:] if other != value)
        case Quotient(numerator, Number(value)) if value == 2:
            yield numerator, "a factor of one half is left out"
