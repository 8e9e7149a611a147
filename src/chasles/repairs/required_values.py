"""The scalars of an expression at any depth, each with the values that it would have to have at the points of a test.

Where an equation is affine in a scalar at one place, its residual says which value there makes it true, if one does; so
an edit there is tried by evaluating the scalar alone. A place where no value does is not looked into.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

from chasles.algebra.modular import MODULUS, Column
from chasles.repairs.modular_testing import REFUSED, ModularTest
from chasles.repairs.residues import Sampled, inverse
from chasles.rewriting.coefficients import ONE
from chasles.rewriting.places import Path, put
from chasles.vocabulary import Block, Node, Number, Rate, Sum, children, printed

__all__ = ["Required", "quotient", "required_values", "value"]

NONE = Number(Fraction(0))


@dataclass(frozen=True, slots=True)
class Required:
    """A place, and the values `wanted` of the scalar `around` it, which is the place itself if its own are known.

    A `term` stands in a sum, a block or by itself: a factor of it is not part of a longer product.
    """

    path: Path
    node: Node
    around: Node
    inner: Path
    wanted: Column
    term: bool

    @property
    def known(self) -> bool:
        """Whether the values wanted are those of the place itself."""
        return not self.inner

    def allows(self, at: Sampled, new: Node) -> bool:
        """Whether something else in the place gives the values wanted."""
        whole = _with(self.around, self.inner, new)
        return whole.fault is None and whole.is_scalar and value(at, whole) == self.wanted


def required_values(test: ModularTest, at: Sampled) -> Iterator[Required]:
    """Every place in a scalar of the right side that some value would make the equation true."""
    residual = test.residual_of(at, test.left, test.right)

    def with_value(path: Path, new: Node) -> Column:
        return test.residual_of(at, test.left, _with(test.right, path, new))

    def below(node: Node, path: Path) -> Iterator[Required]:
        if node.is_scalar:
            wanted = _wanted(at, node, residual, [0] * len(residual), lambda new: with_value(path, new))
            if wanted is not None:
                yield from _within(at, node, path, wanted, term=True)
        elif not isinstance(node, Rate):
            for k, part in enumerate(children(node)):
                yield from below(part, (*path, k))

    return below(test.right, ())


def _within(at: Sampled, node: Node, path: Path, wanted: Column, *, term: bool) -> Iterator[Required]:
    """The scalar and all in it, each with its own values where the scalar is affine in it."""
    yield Required(path, node, node, (), wanted, term)
    present = value(at, node)
    for k, part in enumerate(children(node)):
        inner = None
        if part.is_scalar and present is not None:
            inner = _wanted(at, part, present, wanted, partial(_value_with, at, node, k))
        if inner is not None:
            yield from _within(at, part, (*path, k), inner, term=isinstance(node, Sum | Block))
        else:
            yield from _under(node, path, part, (k,), wanted)


def _under(around: Node, path: Path, node: Node, inner: Path, wanted: Column) -> Iterator[Required]:
    """A part of a scalar of which only the scalar's values are known, and all in it."""
    yield Required((*path, *inner), node, around, inner, wanted, term=False)
    for k, part in enumerate(children(node)):
        yield from _under(around, path, part, (*inner, k), wanted)


def _wanted(
    at: Sampled, node: Node, present: Column, wanted: Column, of: Callable[[Node], Column | None]
) -> Column | None:
    """The values of a scalar with which what is affine in it has the values wanted; None if there are none."""
    own = value(at, node)
    try:
        zero, one = of(NONE), of(ONE)
    except REFUSED:
        return None
    if own is None or zero is None or one is None:
        return None
    size = len(present) // len(own)
    found = []
    for k, x in enumerate(own):
        here = slice(k * size, (k + 1) * size)
        slopes = [(b - a) % MODULUS for a, b in zip(zero[here], one[here], strict=True)]
        lead = next((i for i, slope in enumerate(slopes) if slope), None)
        if lead is None:
            return None
        y = (wanted[here][lead] - zero[here][lead]) * inverse(slopes[lead]) % MODULUS
        for a, slope, now, then in zip(zero[here], slopes, present[here], wanted[here], strict=True):
            if (a + slope * x - now) % MODULUS or (a + slope * y - then) % MODULUS:
                return None
        found.append(y)
    return found


def _value_with(at: Sampled, node: Node, k: int, new: Node) -> Column | None:
    return value(at, _with(node, (k,), new))


def _with(node: Node, path: Path, new: Node) -> Node:
    return printed(lambda: put(node, path, new))


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
