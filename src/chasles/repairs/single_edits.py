"""Single edits that undo a slip: a lost transpose, a wrong letter, factors in the wrong order or place.

Wrong coefficients and missing terms are not among them; these are found from the residual of the equation.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace as with_fields
from itertools import combinations
from typing import NamedTuple, TypeVar

from chasles.repairs.one_term import FACTOR, SIGN, instead
from chasles.rewriting.places import Path, everywhere, linear_places, put
from chasles.vocabulary import (
    Block,
    Call,
    Contract,
    Cross,
    Negative,
    Node,
    Power,
    Quotient,
    Rate,
    Scale,
    Sum,
    Symbol,
    Transpose,
    Zero,
    children,
    plain,
    printed,
    rebuilt,
)

__all__ = ["FORM", "SingleEdit", "edits_at", "in_letters", "placed", "single_edits"]

_T = TypeVar("_T")
FORM = 3
"""The effort of undoing a slip of form, or of a wrong letter."""


class SingleEdit(NamedTuple):
    """An expression with one slip undone, what was changed in words, and how much that is."""

    node: Node
    words: str
    effort: int = FORM


def placed(node: Node, path: Path, new: Node) -> Node:
    """The expression with something else in one place, whether it fits there or not."""
    return printed(lambda: put(node, path, new))


def single_edits(node: Node, *, scalars: bool = True) -> Iterator[SingleEdit]:
    """The expression with one slip of form undone, in every place where what comes out fits together.

    Without `scalars`, those in the scalars are left out, but for those whose rate is taken.
    """
    parts, linear = dict(everywhere(node)), {place.path for place in linear_places(node)}
    within: set[Path] = set()
    for path, part in parts.items():
        if not scalars and (path[:-1] in within or part.is_scalar) and not isinstance(part, Block):
            within.add(path)
            continue
        parent = parts[path[:-1]] if path else None
        for new, words, effort in edits_at(part, parent, turned=path not in linear):
            whole = placed(node, path, new)
            if whole.fault is None:
                yield SingleEdit(whole, words or instead(new, part), effort)


def edits_at(part: Node, parent: Node | None = None, *, turned: bool = True) -> Iterator[SingleEdit]:
    """What one slip of form, undone at the root of an expression, makes of it; signs only if `turned`."""
    yield from _of_form(part)
    yield from _with_factor(part)
    if not isinstance(parent, Rate | Transpose):
        yield from _flipped(part)
    if turned:
        yield from _signs(part)


def in_letters(
    node: Node, letters: Iterable[Symbol], *, of: Iterable[Symbol] = (), any_shape: bool = False
) -> Iterator[SingleEdit]:
    """The expression with one of the letters for another (`of` some) of the same shape, in one place or in all."""
    found = list(everywhere(node))
    symbols = tuple(of) or tuple(dict.fromkeys(part for _, part in found if isinstance(part, Symbol)))
    for letter in letters:
        for symbol in symbols:
            if letter == symbol or (not any_shape and letter.shape != symbol.shape):
                continue
            places = [path for path, part in found if part == symbol]
            wholes = [placed(node, path, letter) for path in places]
            if len(places) > 1:
                wholes.append(printed(lambda: _renamed(node, {symbol: letter})))  # noqa: B023
            yield from (SingleEdit(whole, instead(letter, symbol)) for whole in wholes if whole.fault is None)


def _renamed(node: Node, letters: Mapping[Node, Node]) -> Node:
    """The expression with other letters in all places; what a letter stands for is left alone."""
    parts = children(node)
    changed = tuple(_renamed(part, letters) for part in parts)
    return letters.get(node, node) if changed == parts else rebuilt(node, changed)


def _of_form(node: Node) -> Iterator[SingleEdit]:
    match node:
        case Transpose(of):
            yield SingleEdit(of, "")
        case Call(function, argument):
            yield SingleEdit(Call({"sin": "cos", "cos": "sin"}[function], argument), "")
        case Power(base, exponent):
            yield SingleEdit(_raised(base, exponent + 1), "")
            yield SingleEdit(_raised(base, exponent - 1), "")
        case Cross(left, right) if left != right:
            yield SingleEdit(Cross(right, left), "")
        case Contract(factors):
            yield from (SingleEdit(_swapped(factors, k), "") for k in range(len(factors) - 1))
        case Block(rows):
            yield from (SingleEdit(_block(_exchanged(rows, k)), "") for k in range(len(rows) - 1))
            for k in range(len(rows[0]) - 1):
                yield SingleEdit(_block(tuple(_exchanged(row, k) for row in rows)), "")


def _raised(base: Node, exponent: int) -> Node:
    return base if exponent == 1 else printed(lambda: Power(base, exponent))


def _swapped(factors: tuple[Node, ...], k: int) -> Node:
    return printed(lambda: Contract(_exchanged(factors, k)))


def _block(rows: tuple[tuple[Node, ...], ...]) -> Node:
    return printed(lambda: Block(rows))


def _exchanged(items: tuple[_T, ...], k: int) -> tuple[_T, ...]:
    return (*items[:k], items[k + 1], items[k], *items[k + 2 :])


def _flipped(node: Node) -> Iterator[SingleEdit]:
    """A lost transpose."""
    if isinstance(node, Symbol | Rate | Contract) and node.measure is not None and max(node.shape) > 1:
        yield SingleEdit(Transpose(node), "")


def _signs(node: Node) -> Iterator[SingleEdit]:
    """A wrong sign, where the whole does not depend on it linearly."""
    if isinstance(node, Sum):
        for k, term in enumerate(node.terms):
            turned = term.term if isinstance(term, Negative) else Negative(term)
            yield SingleEdit(Sum((*node.terms[:k], turned, *node.terms[k + 1 :])), "", SIGN)


def _with_factor(node: Node) -> Iterator[SingleEdit]:
    """A common factor that was meant for some of the blocks or terms behind it."""
    match node:
        case Scale(Node() as factor, Block() | Sum() as whole) if factor.is_scalar:
            yield from _for_some(whole, lambda part: Scale(factor, part), plain(factor))
        case Quotient(Block() | Sum() as whole, divisor):
            yield from _for_some(whole, lambda part: with_fields(node, numerator=part), plain(1 / divisor))


def _for_some(whole: Block | Sum, times: Callable[[Node], Node], factor: str) -> Iterator[SingleEdit]:
    parts = [part for row in whole.rows for part in row] if isinstance(whole, Block) else whole.terms
    places = [k for k, part in enumerate(parts) if not isinstance(part, Zero)]
    for size in range(1, min(len(places), 4)):
        for chosen in combinations(places, size):
            new = [_signed(part, times) if k in chosen else part for k, part in enumerate(parts)]
            names = " and ".join(plain(parts[k]) for k in chosen)
            yield SingleEdit(_like(whole, new), f"the factor {factor} is that of {names} only", FACTOR)


def _signed(part: Node, times: Callable[[Node], Node]) -> Node:
    """What `times` makes of the part, its sign in front."""
    return Negative(times(part.term)) if isinstance(part, Negative) else times(part)


def _like(whole: Block | Sum, parts: list[Node]) -> Node:
    if isinstance(whole, Sum):
        return printed(lambda: Sum(tuple(parts)))
    taken = iter(parts)
    return _block(tuple(tuple(next(taken) for _ in row) for row in whole.rows))
