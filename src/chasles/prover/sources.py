"""Where points come from: drawn for what is declared, searched for where a question is on SymPy expressions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import islice
from typing import Any, Protocol

from chasles.algebra.values import is_zero
from chasles.points import sampling as points
from chasles.points.evaluation import Point, ratio_at
from chasles.points.search import UnreducedEntry
from chasles.problems.context import Context
from chasles.prover.conditions import Solved
from chasles.prover.consistency import contradiction, holds_somewhere
from chasles.prover.counterexample import FRUITLESS, refute, solved_ratios
from chasles.statements import Problem
from chasles.verdict import Contradictory, Counterexample

SAMPLES = 40
"""So many sample points are looked at for one that satisfies all hypotheses."""
Suspects = Sequence[UnreducedEntry]


class PointSource(Protocol):
    """Finds exact points of a problem; `write` writes its certificates, if not as for what is declared."""

    @property
    def write(self) -> Callable[..., dict[str, Any]] | None: ...

    def refute(self, context: Context, solved: tuple[Solved, ...], suspects: Suspects) -> Counterexample | None:
        """A counterexample to one of the entries, if one is found."""
        ...

    def refute_soon(self, context: Context, solved: tuple[Solved, ...], suspects: Suspects) -> Counterexample | None:
        """The same before the hypotheses are completed, where it is worth while to look."""
        ...

    def witness(self, context: Context, solved: tuple[Solved, ...]) -> Mapping[str, Any] | None:
        """A point that satisfies all that is assumed, if one is found."""
        ...

    def contradiction(self, problem: Problem) -> Contradictory | None:
        """That nothing satisfies what is assumed, if that is found."""
        ...


class DeclaredPoints:
    """Points of what is declared, drawn so that they satisfy its hypotheses."""

    write = None
    attempts = points.ATTEMPTS
    """So often a point is drawn at which the entries are looked at."""
    fruitless = FRUITLESS
    """So many points are tried in vain before the best counterexample so far is taken."""

    def refute(self, context: Context, solved: tuple[Solved, ...], suspects: Suspects) -> Counterexample | None:
        """The counterexample that is easiest to evaluate by hand."""
        return refute(context, solved, suspects, self.fruitless)

    def refute_soon(self, context: Context, solved: tuple[Solved, ...], suspects: Suspects) -> Counterexample | None:
        """None where the entries likely vanish: then a proof is worth while first."""
        return None if self.likely_vanish(context, solved, suspects) else self.refute(context, solved, suspects)

    def likely_vanish(self, context: Context, solved: tuple[Solved, ...], suspects: Suspects) -> bool:
        """Whether the entries vanish at a few rich points: then they likely vanish everywhere."""
        ratios = solved_ratios(context, solved)
        few = islice(points.sample(context, ratios, simple=False, attempts=self.attempts), 3)
        return all(is_zero(ratio_at(context, e.ratio, point) or {}) for point in few for e in suspects)

    def witness(self, context: Context, solved: tuple[Solved, ...]) -> Point | None:
        """The first point drawn, if the hypotheses on what does not occur hold somewhere too."""
        drawn = islice(points.sample(context, solved_ratios(context, solved), attempts=self.attempts), SAMPLES)
        found = next(drawn, None)
        return found if found is not None and holds_somewhere(context) else None

    def contradiction(self, problem: Problem) -> Contradictory | None:
        """That nothing satisfies what is assumed, by a completion of the hypotheses."""
        return contradiction(problem)
