"""Is there a motion through the point?

Values of functions and their rates that satisfy equations at one instant only count if functions exist that satisfy
them at all times. They do where the equations can be solved for as many of the highest rates as there are equations
(implicit functions, then ordinary differential equations), and all that follows by differentiation holds there too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from chasles.proof.context import Context
from chasles.proof.search.stage import Stage
from chasles.proof.search.values import Values, sparse
from chasles.proof.surds import Exact

__all__ = ["Motion"]


@dataclass(frozen=True, slots=True)
class Motion:
    """The texts of the given equations, with the number of independent ones among those of each (None for all).

    `highest` are the names of the highest rates that occur in them, `angles` those of functions that occur as angles.
    """

    equations: Mapping[str, int | None]
    highest: Sequence[str]

    def exists(self, context: Context, stage: Stage, values: Values) -> bool:
        """Whether the equations determine as many of the highest rates as there are independent equations."""
        rows: list[list[Exact]] = []
        wanted = 0
        for text, rank in self.equations.items():
            own = [g for g in context.generators if g.hypothesis is not None and g.hypothesis.text == text]
            rows += [self._row(context, stage, values, g.polynomial) for g in own]
            wanted += len(own) if rank is None else rank
        for root in stage.roots:
            name = stage.names[root]
            generator = next(g for g in context.generators if g.hypothesis and str(g.hypothesis.subjects[0]) == name)
            rows.append(self._row(context, stage, values, generator.polynomial))
            wanted += 1
        return _rank(rows) == wanted

    def _row(self, context: Context, stage: Stage, values: Values, polynomial: object) -> list[Exact]:
        """The derivatives by the highest rates and by the roots."""
        ring = context.field.ring

        def partial(place: int) -> Exact:
            return values.of(sparse(ring, ring.derivative(polynomial, place)))

        row = []
        for name in self.highest:
            total = partial(stage.place[name]) if name in stage.place else Exact({})
            for angle in stage.angles:
                if angle.symbol.name == name:
                    turned = partial(angle.sine) * values[angle.cosine] - partial(angle.cosine) * values[angle.sine]
                    total = total + turned * Exact.rational(angle.unit)
            row.append(total)
        return row + [partial(root) for root in stage.roots]


def _rank(rows: list[list[Exact]]) -> int:
    """The rank of a matrix; a pivot that cannot be inverted exactly is passed over, which can only lower it."""
    rank = 0
    for column in range(len(rows[0]) if rows else 0):
        for r in range(rank, len(rows)):
            inverse = rows[r][column].inverse()
            if inverse is None:
                continue
            rows[rank], rows[r] = rows[r], rows[rank]
            for other in range(rank + 1, len(rows)):
                factor = rows[other][column] * inverse
                rows[other] = [a - factor * b for a, b in zip(rows[other], rows[rank], strict=True)]
            rank += 1
            break
    return rank
