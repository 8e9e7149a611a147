"""Polynomials that vanish: the equations of hypotheses and their rates, circles of angles, squares of norms."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from chasles.algebra.groebner import stated
from chasles.algebra.localization import Ratio
from chasles.algebra.rings import Polynomial, Ring
from chasles.evaluation.matrices import Matrix, each
from chasles.problems.relevance import is_turned
from chasles.problems.unfold import Unfolder
from chasles.problems.variables import Unlisted, Variable
from chasles.statements import Hypothesis
from chasles.vocabulary import Norm

MOST_ORDERS = 8
"""So often a hypothesis is differentiated at most, to see where its rates say nothing new."""


@dataclass(frozen=True, slots=True)
class Generator:
    """A polynomial that vanishes, and why: a hypothesis, an identity of cosine and sine, a norm, a condition.

    `order` is how often the hypothesis was differentiated.
    """

    label: str
    polynomial: Polynomial
    hypothesis: Hypothesis | None = None
    order: int = 0


def generators_of(
    unfold: Unfolder, variables: tuple[Variable, ...], active: tuple[Hypothesis, ...]
) -> Iterator[Generator]:
    """All that vanishes, of hypotheses that matter first."""
    ring = unfold.field.ring
    place = {variable.name: k for k, variable in enumerate(variables)}
    for hypothesis in active:
        yield from generators_of_hypothesis(
            unfold, hypothesis, 0 if is_turned(hypothesis, unfold.rules) else MOST_ORDERS
        )
    for variable in variables:
        if variable.kind == "cos":
            name = variable.name.removeprefix("cos")
            c, s = (ring.generators[place[f + name]] for f in ("cos", "sin"))
            yield Generator(f"circle {name[1:-1]}", s * s + c * c - ring.constant(Fraction(1)))
    for variable in variables:
        if variable.kind == "norm":
            assert variable.node is not None
            size = unfold(Norm(variable.node))[0][0]
            square = unfold(variable.node)
            total = size * size
            for (entry,) in square:
                total = total - entry * entry
            if not total.is_zero:
                yield Generator(f"norm {variable.name}", total.numerator)


def generators_of_hypothesis(unfold: Unfolder, hypothesis: Hypothesis, most: int) -> Iterator[Generator]:
    """What its equations say, and their rates, until there is no variable for a rate or they say nothing new."""
    for number, (left, right) in enumerate(hypothesis.equations):
        matrix = minus(unfold(left), unfold(right))
        known: list[Polynomial] = []
        for dots in range(most + 1):
            label = hypothesis.text + (f" ({'d' * dots}ot)" if dots else "")
            new: dict[str, Polynomial] = {}
            for i, j, entry in entries(matrix):
                numerator = entry.numerator
                if numerator != 0 and not any(numerator == old or numerator == -old for old in new.values()):
                    new[f"{label} [{number}: {i + 1}, {j + 1}]"] = numerator
            if dots and _follow(unfold.field.ring, new.values(), known):
                break
            yield from (Generator(name, polynomial, hypothesis, dots) for name, polynomial in new.items())
            known += new.values()
            try:
                matrix = each(matrix, unfold.rate)
            except Unlisted:
                break


def _follow(ring: Ring, new: Collection[Polynomial], known: Sequence[Polynomial]) -> bool:
    """Whether division by what is known leaves nothing of what is new, which speaks of nothing else."""

    def occurring(polynomials: Iterable[Polynomial]) -> set[int]:
        return {k for p in polynomials for k, power in enumerate(ring.degrees(p)) if power}

    if not occurring(new) <= occurring(known):
        return False
    basis = stated(ring, tuple(known), complete=False)
    return all(basis.reduce(polynomial)[1] == 0 for polynomial in new)


def minus(left: Matrix, right: Matrix) -> Matrix:
    """The difference, entry by entry."""
    return [[a - b for a, b in zip(one, other, strict=True)] for one, other in zip(left, right, strict=True)]


def entries(matrix: Matrix) -> Iterator[tuple[int, int, Ratio]]:
    """The entries with their places, row by row."""
    for i, row in enumerate(matrix):
        for j, entry in enumerate(row):
            yield i, j, entry
