"""The equations, roots and inequations that a point must satisfy, taken from the context of a problem."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from chasles.points.search.values import Sparse, sparse
from chasles.problems.context import Context
from chasles.vocabulary import PI, Symbol


@dataclass(frozen=True, slots=True)
class BoundAngle:
    """The places of the cosine and sine of `unit` times an angle, and of the angle itself where it stands alone."""

    symbol: Symbol
    cosine: int
    sine: int
    unit: Fraction
    bare: int | None


@dataclass(frozen=True, slots=True)
class ConstraintSystem:
    """Equations by the places of their variables; `roots` are squares of variables that are not negative.

    `consequences` hold wherever the rest does.
    """

    names: tuple[str, ...]
    place: dict[str, int]
    equations: list[Sparse]
    consequences: list[Sparse]
    roots: dict[int, Sparse]
    angles: tuple[BoundAngle, ...]
    circles: dict[int, Sparse]
    nonzero: list[Sparse]
    pi: int | None


def constraint_system(context: Context) -> ConstraintSystem:
    """The constraint system of a context: a root's equation is told from the others by its hypothesis."""
    ring = context.field.ring
    place = {name: k for k, name in enumerate(ring.names)}
    equations: list[Sparse] = []
    consequences: list[Sparse] = []
    roots: dict[int, Sparse] = {}
    circles: list[Sparse] = []
    for generator in context.generators:
        terms = sparse(ring, generator.polynomial)
        hypothesis = generator.hypothesis
        root = place[str(hypothesis.subjects[0])] if hypothesis is not None and hypothesis.kind == "root" else None
        scale = next((c for monomial, c in terms if monomial == ((root, 2),)), None)
        if hypothesis is None:
            circles.append(terms)
        elif hypothesis.kind == "consequence":
            consequences.append(terms)
        elif root is None or scale is None:  # the square of a root of a quotient may be multiplied by what divides
            equations.append(terms)
        else:
            roots[root] = [(monomial, -c / scale) for monomial, c in terms if monomial != ((root, 2),)]
    angles = []
    for k, variable in enumerate(context.variables):
        if variable.kind == "cos" and variable.symbol is not None:
            sine = place["sin" + variable.name.removeprefix("cos")]
            unit = context.unfold.coordinates.unit(variable.symbol)
            angles.append(BoundAngle(variable.symbol, k, sine, unit, place.get(variable.symbol.name)))
    by_sine = {a.sine: next(c for c in circles if any(m == ((a.sine, 2),) for m, _ in c)) for a in angles}
    nonzero = [sparse(ring, factor) for _, factor in context.nonzero]
    return ConstraintSystem(
        ring.names, place, equations, consequences, roots, tuple(angles), by_sine, nonzero, place.get(PI.name)
    )
