"""The places of an expression at any depth, scalars with the values that they would have to have at points of a test.

Where an equation is affine in a scalar at one place, its residual says which value there makes it true, if one does; so
an edit there is tried by evaluating the scalar alone. A scalar for which no value does is not looked into.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction

from chasles.algebra.modular import MODULUS, Column
from chasles.repairs.modular_testing import REFUSED, ModularTest
from chasles.repairs.residues import Sampled, inverse
from chasles.rewriting.coefficients import ONE
from chasles.rewriting.places import Path, put
from chasles.vocabulary import Block, Node, Number, Sum, children, printed

TWO = Number(Fraction(2))
_Values = Callable[[Node], Column | None]
_Lines = list[tuple[int, int]]


@dataclass(frozen=True, slots=True)
class Required:
    """A place with the smallest part `around` it of which the values `wanted` are known: itself, or the whole side."""

    path: Path
    node: Node
    parent: Node | None
    around: Node
    inner: Path
    values: _Values
    wanted: Column

    @property
    def known(self) -> bool:
        """Whether the values wanted are those of the place itself."""
        return not self.inner and self.node.is_scalar

    @property
    def term(self) -> bool:
        """Whether it stands in a sum or in a block, or by itself."""
        return self.parent is None or isinstance(self.parent, Sum | Block)

    def allows(self, new: Node) -> bool:
        """Whether something else in the place gives the values wanted."""
        whole = self.with_(new)
        return whole.fault is None and whole.shape == self.around.shape and self.values(whole) == self.wanted

    def with_(self, new: Node) -> Node:
        """What is around the place, with something else in it."""
        return printed(lambda: put(self.around, self.inner, new))


def required_values(test: ModularTest, at: Sampled) -> Iterator[Required]:
    """Every place of the right side but those in scalars of which no value makes the equation true."""

    def residual(right: Node) -> Column | None:
        try:
            return test.residual_of(at, test.left, right)
        except REFUSED:
            return None

    present = residual(test.right)
    if present is not None:
        whole = Required((), test.right, None, test.right, (), residual, [0] * len(present))
        yield from _within(at, whole, present)


def _within(at: Sampled, place: Required, present: Column) -> Iterator[Required]:
    """The place and those in it; `present` are the values of what is around it."""
    node = place.node
    if node.is_scalar and (place.inner or place.parent is None):
        own, wanted = value(at, node), None
        if own is not None and (ends := _ends(place)) is not None:
            lines = [*zip(*ends, strict=True)]
            if _affine(lines, own, present):
                wanted = _solved(lines, place.wanted, len(own))
                if wanted is None:
                    return
                present = own
                place = Required(place.path, node, place.parent, node, (), lambda new: value(at, new), wanted)
    yield place
    for k, part in enumerate(children(node)):
        inner = Required((*place.path, k), part, node, place.around, (*place.inner, k), place.values, place.wanted)
        yield from _within(at, inner, present)


def _ends(place: Required) -> tuple[Column, Column] | None:
    """The values of what is around a scalar, with one and with two in its place."""
    one, two = place.values(place.with_(ONE)), place.values(place.with_(TWO))
    return None if one is None or two is None else (one, two)


def _affine(lines: _Lines, own: Column, present: Column) -> bool:
    """Whether what is around depends on the scalar along the lines."""
    size = len(lines) // len(own)
    return all(
        (a + (b - a) * (own[k // size] - 1) - y) % MODULUS == 0
        for k, ((a, b), y) in enumerate(zip(lines, present, strict=True))
    )


def _solved(lines: _Lines, wanted: Column, count: int) -> Column | None:
    """The scalar at so many points with which what is around has the values wanted; None if there is none."""
    size = len(lines) // count
    found = []
    for k in range(0, len(lines), size):
        here = list(zip(lines[k : k + size], wanted[k : k + size], strict=True))
        lead = next(((a, (b - a) % MODULUS, y) for (a, b), y in here if (b - a) % MODULUS), None)
        if lead is None:
            return None
        a, slope, y = lead
        x = (1 + (y - a) * inverse(slope)) % MODULUS
        if any((a + (b - a) * (x - 1) - y) % MODULUS for (a, b), y in here):
            return None
        found.append(x)
    return found


def value(at: Sampled, node: Node) -> Column | None:
    """The values of a scalar at the points; None if it has none."""
    try:
        found: Column = at.scalar(node).at
    except REFUSED:
        return None
    return found


def quotient(one: Column, other: Column) -> Column | None:
    """The values of one scalar divided by those of another; None if these vanish."""
    return [a * inverse(b) % MODULUS for a, b in zip(one, other, strict=True)] if all(other) else None
