"""Integrals over a body: sums over all its elements of volume, each of them of positive density."""

from __future__ import annotations

from chasles.vocabulary.dimension import LENGTH, NO_DIMENSION
from chasles.vocabulary.fitting import measured, word
from chasles.vocabulary.letters import Symbol, is_measured
from chasles.vocabulary.measure import Measure, scaled
from chasles.vocabulary.nodes import OfOne


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
