"""Whether a motion passes through a point.

Values of functions and their rates that satisfy equations at one instant only count if functions exist that satisfy
them at all times. Equations that can be solved at the point for a rate each, others being chosen freely, have such
solutions (implicit functions, then ordinary differential equations). An equation that cannot be is to follow from
these and from all that the equations are derivatives of: what does, and vanishes at the point, vanishes along the
solution, for its derivatives are linear in it and its like.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from chasles.algebra.groebner import stated
from chasles.algebra.rings import Polynomial, Ring
from chasles.algebra.surds import SurdSum
from chasles.points.search.constraints import ConstraintSystem
from chasles.points.search.values import Sparse, Values, sparse
from chasles.problems.context import Context


@dataclass(frozen=True, slots=True)
class DifferentiatedRow:
    """An equation: the labels of its generator and of those of its derivatives, and the names of its highest rates.

    It determines rates when it is differentiated so many `times`. A rate that does not occur has no name.
    """

    labels: Sequence[str]
    rates: Sequence[str]
    times: int = 0


@dataclass(frozen=True, slots=True)
class EquationBlock:
    """Equations of which `rank` are independent; None if all are meant to be."""

    rows: Sequence[DifferentiatedRow]
    rank: int | None = None


@dataclass(slots=True)
class Motion:
    """The given equations between functions; `still` are the names of words that do not change.

    `determined` are the names of the rates that the equations determine, of which `highest` are those of each row's
    rates, in the same order, in its derivative.
    """

    blocks: Sequence[EquationBlock]
    highest: Sequence[str]
    determined: frozenset[str] = frozenset()
    still: frozenset[str] = frozenset()

    def exists(self, context: Context, system: ConstraintSystem, values: Values) -> bool:
        """Whether functions exist that have these values and satisfy the equations at all times."""
        generators = {g.label: g.polynomial for g in context.generators}
        slopes = _Slopes(system, values)
        solved: list[tuple[int, list[SurdSum]]] = []
        pivots: dict[str, str] = {}
        surplus: set[str] = set()
        for block in self.blocks:
            before, dependent = len(solved), set()
            for row in block.rows:
                if row.labels[0] in generators:
                    entries = slopes(sparse(context.field.ring, generators[row.labels[0]]), row.rates)
                    independent = None if entries is None else _take(entries, solved)
                    if independent is None:
                        return False
                    dependent |= set() if independent else {row.labels[row.times]}
                    if independent:
                        pivots[row.labels[row.times]] = self.highest[solved[-1][0]]
            gained = len(solved) - before
            if block.rank is not None and gained not in (0, block.rank):
                return False
            surplus |= dependent if block.rank is None or not gained else set()
        return not surplus or self._follow(context, system, values, surplus, pivots)

    def _follow(
        self, context: Context, system: ConstraintSystem, values: Values, surplus: set[str], pivots: Mapping[str, str]
    ) -> bool:
        """Whether the equations of these labels are consequences of the others, by which rates are replaced first.

        A condition on what does not change may be left: it holds at the point.
        """
        ring = context.field.ring
        said = {label for block in self.blocks for row in block.rows for label in row.labels}
        used = {label for block in self.blocks for row in block.rows for label in row.labels[: row.times]} | set(pivots)
        solved = []
        for generator in context.generators:
            place = system.place.get(pivots.get(generator.label, ""))
            if place is not None and ring.degrees(generator.polynomial)[place] == 1:
                factor = ring.derivative(generator.polynomial, place)
                if not values.of(sparse(ring, factor)).is_zero:
                    solved.append((place, factor, generator.polynomial))
                    used.discard(generator.label)
        kept = tuple(g.polynomial for g in context.generators if g.label in used or g.label not in said)
        basis = stated(ring, kept, complete=False)
        still = self._still(system)
        for generator in context.generators:
            if generator.label in surplus:
                rest = basis.reduce(_replaced(ring, generator.polynomial, solved))[1]
                if rest != 0 and not still.issuperset(k for k, degree in enumerate(ring.degrees(rest)) if degree):
                    return False
        return True

    def _still(self, system: ConstraintSystem) -> set[int]:
        """The places of what does not change: words, their cosines and sines, and roots of these."""
        still = {place for name, place in system.place.items() if name in self.still}
        still |= {k for a in system.angles if a.symbol.name in self.still for k in (a.cosine, a.sine)}
        for _ in system.roots:
            still |= {k for k, inside in system.roots.items() if all(j in still for term, _ in inside for j, _ in term)}
        return still


def _replaced(ring: Ring, polynomial: Polynomial, solved: Sequence[tuple[int, Polynomial, Polynomial]]) -> Polynomial:
    """A multiple of the polynomial, less multiples of equations that are linear in a variable, which is gone."""
    for place, factor, equation in (*solved, *solved):
        if ring.degrees(polynomial)[place] == 1:
            polynomial = factor * polynomial - ring.derivative(polynomial, place) * equation
    return polynomial


class _Slopes:
    """The derivatives of an equation by rates, of which angles and roots are functions."""

    def __init__(self, system: ConstraintSystem, values: Values) -> None:
        self.system = system
        self.values = values

    def __call__(self, terms: Sparse, rates: Sequence[str]) -> list[SurdSum] | None:
        """The derivatives in turn; None where a root vanishes."""
        found = [self._by(terms, name) for name in rates]
        return None if None in found else [entry for entry in found if entry is not None]

    def _by(self, terms: Sparse, name: str) -> SurdSum | None:
        place = self.system.place.get(name)
        total = SurdSum({}) if place is None else self._partial(terms, place)
        for angle in self.system.angles:
            if angle.symbol.name == name:
                one, other = self._partial(terms, angle.sine), self._partial(terms, angle.cosine)
                turned = one * self.values[angle.cosine] - other * self.values[angle.sine]
                total = total + turned * SurdSum.rational(angle.unit)
        for root, radicand in self.system.roots.items():
            slope = self._partial(terms, root)
            inside = SurdSum({}) if slope.is_zero else self._by(radicand, name)
            half = (self.values[root] + self.values[root]).inverse()
            if inside is None or (half is None and not slope.is_zero):
                return None
            total = total + slope * inside * half if half is not None else total
        return total

    def _partial(self, terms: Sparse, place: int) -> SurdSum:
        lowered = []
        for monomial, factor in terms:
            powers = dict(monomial)
            exponent = powers.pop(place, 0)
            if exponent:
                rest = {**powers, place: exponent - 1} if exponent > 1 else powers
                lowered.append((tuple(sorted(rest.items())), factor * exponent))
        return self.values.of(lowered)


def _take(row: list[SurdSum], solved: list[tuple[int, list[SurdSum]]]) -> bool | None:
    """Add a row to a matrix in echelon form if it is independent; None if no entry left can be inverted exactly."""
    for column, pivot in solved:
        factor = row[column]
        row = [a - factor * b for a, b in zip(row, pivot, strict=True)]
    if all(entry.is_zero for entry in row):
        return False
    for column, entry in enumerate(row):
        inverse = entry.inverse()
        if inverse is not None:
            solved.append((column, [other * inverse for other in row]))
            return True
    return None
