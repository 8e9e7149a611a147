"""Slips of pen and print, undone one at a time: a lost transpose, a wrong letter, factors in the wrong order or place.

None of them is a wrong coefficient or a missing term; these are found from the gap between the sides.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace as with_fields
from itertools import combinations

from chasles.proof.places import everywhere, linear_places, put
from chasles.proof.single import instead
from chasles.vocabulary import (
    Block,
    Call,
    Contract,
    Cross,
    Group,
    Identity,
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
    plain,
    printed,
)

__all__ = ["Undone", "in_letters", "undone"]

Undone = tuple[Node, str]
"""An expression with one slip undone, and what was changed in words."""
Make = Callable[[], Node]


def undone(node: Node) -> Iterator[Undone]:
    """The expression with one slip of form undone, in every place where what comes out fits together."""
    parts, linear = dict(everywhere(node)), {place.path for place in linear_places(node)}
    for path, part in parts.items():
        inside = isinstance(parts.get(path[:-1]) if path else None, Rate | Transpose)
        signs = _signs(part) if isinstance(part, Sum) and path not in linear else ()
        for make, words in (*_of_form(part, inside), *signs):
            new = _made(make)
            whole = _made(lambda path=path, new=new: put(node, path, new))  # type: ignore[misc]
            if whole.fault is None:
                yield whole, words or instead(new, part)


def in_letters(
    node: Node, letters: Iterable[Symbol], *, of: Iterable[Symbol] = (), any_shape: bool = False
) -> Iterator[Undone]:
    """The expression with one of the letters for another (`of` some) of the same shape, in one place or in all."""
    found = list(everywhere(node))
    symbols = dict.fromkeys(part for _, part in found if isinstance(part, Symbol))
    for letter in letters:
        for symbol in tuple(of) or symbols:
            if letter == symbol or (not any_shape and letter.shape != symbol.shape):
                continue
            places = [path for path, part in found if part == symbol]
            for chosen in [(path,) for path in places] + ([tuple(places)] if len(places) > 1 else []):
                whole = node
                for path in chosen:
                    whole = _made(lambda whole=whole, path=path, letter=letter: put(whole, path, letter))  # type: ignore[misc]
                if whole.fault is None:
                    yield whole, instead(letter, symbol)


def _made(make: Make) -> Node:
    return printed(make)


def _of_form(node: Node, inside: bool) -> Iterator[tuple[Make, str]]:
    match node:
        case Transpose(of):
            yield lambda: of, ""
        case Identity() | Zero() | Negative() | Sum() | Group():
            return
        case Call(function, argument):
            yield lambda: Call({"sin": "cos", "cos": "sin"}[function], argument), ""
        case Power(base, exponent):
            yield lambda: Power(base, exponent + 1), ""
            yield lambda: base if exponent == 2 else Power(base, exponent - 1), ""
        case Cross(left, right) if left != right:
            yield lambda: Cross(right, left), ""
        case Contract(factors):
            for k in range(len(factors) - 1):
                yield _swapped(factors, k), ""
        case Scale(Node() as factor, Block() | Sum() as whole) if factor.is_scalar:
            yield from _partly(whole, lambda part: scaled_by(factor, part), factor)
        case Quotient(Block() | Sum() as whole, divisor):
            yield from _partly(whole, lambda part: with_fields(node, numerator=part), 1 / divisor)
        case Block(rows):
            yield from _exchanged(rows)
        case _:
            pass
    if isinstance(node, Symbol | Rate | Contract) and node.measure is not None and max(node.shape) > 1 and not inside:
        yield lambda: Transpose(node), ""


def _signs(whole: Sum) -> Iterator[tuple[Make, str]]:
    """A wrong sign where the whole does not depend on it linearly."""
    for k, term in enumerate(whole.terms):
        turned = term.term if isinstance(term, Negative) else Negative(term)
        terms = (*whole.terms[:k], turned, *whole.terms[k + 1 :])
        yield (lambda terms=terms: Sum(terms)), ""  # type: ignore[misc]


def scaled_by(factor: Node, part: Node) -> Node:
    """The part times the factor, its sign in front."""
    return Negative(Scale(factor, part.term)) if isinstance(part, Negative) else Scale(factor, part)


def _swapped(factors: tuple[Node, ...], k: int) -> Make:
    return lambda: Contract((*factors[:k], factors[k + 1], factors[k], *factors[k + 2 :]))


def _exchanged(rows: tuple[tuple[Node, ...], ...]) -> Iterator[tuple[Make, str]]:
    for k in range(len(rows) - 1):
        yield (lambda k=k: Block((*rows[:k], rows[k + 1], rows[k], *rows[k + 2 :]))), ""  # type: ignore[misc]
    for k in range(len(rows[0]) - 1):
        lines = tuple((*row[:k], row[k + 1], row[k], *row[k + 2 :]) for row in rows)
        yield (lambda lines=lines: Block(lines)), ""  # type: ignore[misc]


def _partly(whole: Block | Sum, times: Callable[[Node], Node], factor: Node) -> Iterator[tuple[Make, str]]:
    """A factor that was meant for some of the blocks or terms behind it."""
    parts = sum(whole.rows, ()) if isinstance(whole, Block) else whole.terms
    places = [k for k, part in enumerate(parts) if not isinstance(part, Zero)]
    for size in range(1, min(len(places), 4)):
        for chosen in combinations(places, size):
            names = " and ".join(plain(parts[k]) for k in chosen)
            yield _with_factor(whole, parts, chosen, times), f"the factor {plain(factor)} is that of {names} only"


def _with_factor(
    whole: Block | Sum, parts: Sequence[Node], chosen: tuple[int, ...], times: Callable[[Node], Node]
) -> Make:
    def make() -> Node:
        new = iter([times(part) if k in chosen else part for k, part in enumerate(parts)])
        if isinstance(whole, Sum):
            return Sum(tuple(new))
        return Block(tuple(tuple(next(new) for _ in row) for row in whole.rows))

    return make
