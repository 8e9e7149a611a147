"""Words that set others out: blocks, rates, arguments, functions, brackets."""

from __future__ import annotations

from chasles.vocabulary.dimension import LENGTH, NO_DIMENSION, Dimension
from chasles.vocabulary.fitting import SCALAR, measured, word
from chasles.vocabulary.letters import Symbol, has_no_letter, is_measured
from chasles.vocabulary.measure import Measure, Misfit, entrywise, scaled, stacked, uniform
from chasles.vocabulary.nodes import Node, OfOne


@word
class Integral(OfOne):
    """The integral over the volume of a body.

    The `density`, and the quantities `over` which the integral is taken, differ from element to element; so does what
    a rule makes of them. Everything else is the same for all elements. An element's mass, density times volume, does
    not change with time. Without a `body` it is a sum over members, which have no volume.
    """

    density: Symbol
    over: tuple[Symbol, ...]
    body: str = r"\mathcal{B}"

    def _measured(self) -> Measure:
        return scaled(measured(self.of), LENGTH**3 if self.body and is_measured(self.density) else NO_DIMENSION)

    @property
    def running(self) -> frozenset[Symbol]:
        """The symbols that differ from element to element."""
        return frozenset((self.density, *self.over))


@word
class Block(Node):
    """A matrix of blocks, row by row."""

    rows: tuple[tuple[Node, ...], ...]

    def _parts(self) -> tuple[Node, ...]:
        return sum(self.rows, ())

    def _measured(self) -> Measure:
        return stacked([[measured(block) for block in row] for row in self.rows], self.rows)


@word
class Call(Node):
    """A function of a dimensionless scalar: "sin" or "cos"."""

    function: str
    argument: Node

    def _measured(self) -> Measure:
        if not self.argument.is_scalar or measured(self.argument).grid[0][0] not in (None, NO_DIMENSION):
            raise Misfit(f"{self.function} takes an angle in radians, and {self.argument} is not one")
        return uniform(SCALAR)


@word
class Rate(OfOne):
    """The time derivative."""

    def _measured(self) -> Measure:
        of = measured(self.of)
        if all(d in (None, NO_DIMENSION) for row in of.grid for d in row):
            if has_no_letter(self.of):
                return scaled(of, None)
            if not is_measured(self.of):
                return of
        return entrywise(lambda d: Dimension(d.length, d.mass, d.time - 1), of)


@word
class At(OfOne):
    """The quantity, printed with its argument: p(t)."""

    argument: str

    def _measured(self) -> Measure:
        return measured(self.of)


@word
class Group(OfOne):
    """A term that the author puts between brackets which its meaning does not ask for.

    With a `frame`, the brackets say in which coordinate frame the components are given, and bear its letter.
    """

    brackets: str = "()"
    frame: str = ""

    def _measured(self) -> Measure:
        return measured(self.of)
