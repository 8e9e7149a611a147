"""The places of an expression at which a part can be replaced, and the expression after it.

A place is linear if the whole depends linearly on the part there: terms, factors, blocks, arguments of linear
operations; not exponents, divisors or arguments of norms.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from chasles import vocabulary as w
from chasles.rewriting.coefficients import added
from chasles.vocabulary import Node

Path = tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Place:
    """A part of an expression and the way to it.

    `term` if it is the whole, a block or a term of a sum; `open` if a term can be added to it, and to nothing around it
    with the same effect. `inside` a rate, only constant factors of it are factors of the whole. `apart` if above it
    stand nothing but sums, blocks and common factors: changes in such places add up.
    """

    path: Path
    node: Node
    term: bool = True
    open: bool = True
    inside: bool = False
    apart: bool = True


def everywhere(node: Node, path: Path = ()) -> Iterator[tuple[Path, Node]]:
    """Every part with its path, the whole first."""
    yield path, node
    for k, part in enumerate(w.children(node)):
        yield from everywhere(part, (*path, k))


def linear_places(node: Node) -> Iterator[Place]:
    """Every linear place, the whole first, in reading order."""
    yield from _below(Place((), node))


def _below(place: Place) -> Iterator[Place]:
    yield place
    node, parts = place.node, w.children(place.node)
    term, is_open = isinstance(node, w.Sum | w.Block), not isinstance(node, w.Sum | w.Negative | w.Group | w.At)
    apart = place.apart and isinstance(node, w.Sum | w.Block | w.Scale | w.Quotient | w.Negative | w.Group)
    for k in _linear(node):
        leads_down = apart and not (isinstance(node, w.Scale) and k == 0)
        inside = place.inside or isinstance(node, w.Rate)
        yield from _below(Place((*place.path, k), parts[k], term, is_open, inside, leads_down))


def _linear(node: Node) -> range:
    match node:
        case w.Quotient():
            return range(1)
        case w.Sum() | w.Scale() | w.Contract() | w.Block() | w.Dot() | w.Cross():
            return range(len(w.children(node)))
        case (
            w.Negative()
            | w.Transpose()
            | w.Skew()
            | w.Vect()
            | w.Trace()
            | w.Group()
            | w.At()
            | w.Rate()
            | w.Integral()
        ):
            return range(1)
        case _:
            return range(0)


def separate_sums(root: Node) -> Iterator[tuple[Place, tuple[Place, ...]]]:
    """The sums that make up the expression block by block, each with its terms; one term is a sum of itself."""
    yield from _sums(Place((), root))


def _sums(place: Place) -> Iterator[tuple[Place, tuple[Place, ...]]]:
    inner = [other for other in linear_places(place.node) if other.apart]
    below = [Place((*place.path, *other.path), other.node) for other in inner if len(other.path) == 1]
    if isinstance(place.node, w.Sum):
        yield place, tuple(below)
    elif any(isinstance(other.node, w.Sum | w.Block) for other in inner):
        for other in below:
            yield from _sums(other)
    else:
        yield place, (place,)


def put(root: Node, path: Path, new: Node | None) -> Node:
    """The expression with something else in one place; with None, what stands there is left out."""
    if not path:
        return w.Zero(*root.shape) if new is None else new
    parts, k = list(w.children(root)), path[0]
    if new is None and len(path) == 1:
        if isinstance(root, w.Sum):
            return added([*parts[:k], *parts[k + 1 :]])
        new = w.Zero(*parts[k].shape)
    changed = put(parts[k], path[1:], new)
    if isinstance(root, w.Sum):
        return added([*parts[:k], changed, *parts[k + 1 :]])
    if isinstance(root, w.Negative) and isinstance(changed, w.Negative):
        return changed.term
    return w.rebuilt(root, (*parts[:k], changed, *parts[k + 1 :]))


def with_term(node: Node, term: Node) -> Node:
    """The expression with a term added to it, within its brackets if it has some."""
    if isinstance(node, w.Group) and isinstance(node.of, w.Sum):
        return w.Group(added([node.of, term]), node.brackets)
    return added([node, term])
