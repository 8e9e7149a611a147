"""Single edits that undo a slip: a lost transpose, a wrong letter, factors in the wrong order or place.

Wrong coefficients and missing terms are not among them; these are found from the residual of the equation.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import combinations

from chasles.repairs.local_edits import FORM, SingleEdit, edits_at
from chasles.repairs.one_term import instead
from chasles.rewriting.places import Path, everywhere, linear_places, put
from chasles.vocabulary import Node, Symbol, plain, printed
from chasles.vocabulary.tree import with_parts


def placed(node: Node, path: Path, new: Node) -> Node:
    """The expression with something else in one place, whether it fits there or not."""
    return printed(lambda: put(node, path, new))


def single_edits(node: Node, told: Callable[[Node, Node], str] = instead) -> Iterator[SingleEdit]:
    """The expression with one slip of form undone, in every place where what comes out fits together."""
    parts, linear = dict(everywhere(node)), {place.path for place in linear_places(node)}
    for path, part in parts.items():
        parent = parts[path[:-1]] if path else None
        for new, words, effort in edits_at(part, parent, turned=path not in linear):
            whole = placed(node, path, new)
            if whole.fault is None:
                yield SingleEdit(whole, words or told(new, part), effort)


def in_letters(
    node: Node, letters: Iterable[Symbol], *, of: Iterable[Symbol] = (), any_shape: bool = False,
    told: Callable[[Node, Node], str] = instead,
) -> Iterator[SingleEdit]:  # fmt: skip
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
            yield from (SingleEdit(whole, told(letter, symbol)) for whole in wholes if whole.fault is None)


def _renamed(node: Node, letters: Mapping[Node, Node]) -> Node:
    """The expression with other letters in all places; what a letter stands for is left alone."""
    return letters[node] if node in letters else with_parts(node, lambda part: _renamed(part, letters))


def exchanged_letters(node: Node) -> Iterator[SingleEdit]:
    """The expression with two of its letters exchanged wherever they stand."""
    letters = dict.fromkeys(part for _, part in everywhere(node) if isinstance(part, Symbol))
    for one, other in combinations(letters, 2):
        if one.shape == other.shape:
            whole = printed(lambda: _renamed(node, {one: other, other: one}))  # noqa: B023
            if whole.fault is None:
                yield SingleEdit(whole, f"{plain(one)} and {plain(other)} are exchanged", FORM + 1)
