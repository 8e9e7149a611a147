"""An equation at points in floating point: those of functions without polynomial form, and of their derivatives."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from itertools import chain, islice, product
from random import Random

from chasles import vocabulary as w
from chasles.evaluation.matrices import Matrix
from chasles.repairs.real_values import NO_VALUE, RealPoint, agree_at
from chasles.statements import Problem, Statement, problem_of
from chasles.statements.goals import AcceptedSides
from chasles.statements.rules import rated
from chasles.vocabulary import Node
from chasles.vocabulary.partial import differentiates

POINTS, TRIES, NEAR = 8, 400, 1e-9
"""So many points are compared, of so many that are tried; sides so near to each other agree."""
MOST_DOTS = 2
"""So many rates are taken of letters where some are taken."""
STEPS, SMALL, EXACT = 20, 1e-7, 1e-12
"""Steps of Newton's method, the change by which it takes slopes, and how well what is given has to hold."""


def real_test(statement: Statement, left: Node, right: Node, accepted: AcceptedSides) -> RealTest | None:
    """The test in floating point of an equation that has no other; None where no points are found."""

    def posed(one: Node, other: Node) -> Problem:
        return problem_of(statement.saying(one, other), "printed", accepted)

    try:
        test = RealTest(posed, (left, right))
    except (w.Misfit, TypeError, ValueError):
        return None
    return test if test.has_values else None


class RealTest:
    """Points at which what a problem assumes holds; sides are compared there, as `posed` where they are carried out."""

    def __init__(self, posed: Callable[[Node, Node], Problem], sides: tuple[Node, Node]) -> None:
        self.posed, self.sides = posed, sides
        problem = posed(*sides)
        self.rules = dict(problem.rules)
        stated = [goal.sides for goal in (*problem.goals, *problem.conditions)]
        self.given = stated[len(problem.goals) :]
        self.positive: list[Node] = list(problem.nonnegative)
        for h in problem.hypotheses:
            self.given += h.equations if h.kind != "inequality" else ()
            self.positive += h.subjects[:1] if h.kind in ("inequality", "positive") else ()
        said = [*(side for pair in (*problem.rules, *stated, *self.given) for side in pair), *self.positive]
        found = dict.fromkeys(symbol for side in said for symbol in w.symbols_of(side))
        free: list[Node] = [symbol for symbol in found if symbol not in self.rules and symbol.stands_for is None]
        dots = max((1 for side in said for part in w.walk(side) if isinstance(part, w.Rate)), default=0) * MOST_DOTS
        # What is assumed of letters at all times holds of their rates.
        still = [pair for pair in self.given if not any(isinstance(part, w.Rate) for s in pair for part in w.walk(s))]
        self.given += [(rated(a, n), rated(b, n)) for a, b in still for n in range(1, dots + 1)]
        moving = [s for s in free if not (isinstance(s, w.Symbol) and s.constant)]
        free += [rate for s in moving for n in range(1, dots + 1) if (rate := rated(s, n)) not in self.rules]
        self.places = [(symbol, i, j) for symbol in free for i, j in product(*map(range, symbol.shape))]
        given = chain(*self.given, *self.rules.items())
        bound = {symbol for side in given for symbol in w.symbols_of(side)}
        self.bound = [k for k, (symbol, _, _) in enumerate(self.places) if w.undotted(symbol)[0] in bound]
        self.points = list(islice(self._drawn(), POINTS))
        self.is_direct = not any(side.expands for side in sides) and self._has_values(sides)

    @property
    def has_values(self) -> bool:
        """Whether the sides are made of words that have values at points, at some of which they may have none."""
        return self._has_values(tuple(chain(*self._pairs(*self.sides))))

    def _has_values(self, sides: tuple[Node, ...]) -> bool:
        try:
            return bool(self.points) and all(map(self.points[0], sides))
        except TypeError:
            return False
        except NO_VALUE:
            return True

    def agree(self, left: Node, right: Node) -> bool:
        """Whether the sides agree at the points."""
        try:
            pairs = self._pairs(left, right)
        except (w.Misfit, TypeError):
            return False
        return agree_at(self.points, lambda point: all(_near(point(one), point(other)) for one, other in pairs))

    def _pairs(self, left: Node, right: Node) -> list[tuple[Node, Node]]:
        """The sides; what is expanded, or differentiated in a way that points do not show, is carried out once."""
        if self.is_direct or not any(side.expands or differentiates(side) for side in (left, right)):
            return [(left, right)]
        return [goal.sides for goal in self.posed(left, right).goals]

    def _drawn(self) -> Iterator[RealPoint]:
        random = Random(1)
        for _ in range(TRIES):
            values = [random.uniform(0.1, 1.4) * (1 if s in self.positive else random.choice((-1, 1)))
                      for s, _, _ in self.places]  # fmt: skip
            with suppress(*NO_VALUE):
                point = self._solved(values)
                if point is not None and all(point.scalar(each) > 0 for each in self.positive):
                    yield point

    def _solved(self, values: list[float]) -> RealPoint | None:
        """The point near these values at which what is given holds, by Newton's method; None where it finds none."""
        import numpy as np

        for _ in range(STEPS):
            point = self._at(values)
            residuals = self._residuals(point)
            if all(abs(each) < EXACT for each in residuals):
                return point
            moved = (self._at([v + SMALL * (k == place) for k, v in enumerate(values)]) for place in self.bound)
            slopes = [[(b - a) / SMALL for a, b in zip(residuals, self._residuals(p), strict=True)] for p in moved]
            step = np.linalg.lstsq(np.array(slopes).T, np.array(residuals), rcond=1e-9)[0]
            changes = dict(zip(self.bound, step.tolist(), strict=True))
            values = [value - changes.get(place, 0.0) for place, value in enumerate(values)]
        return None

    def _residuals(self, point: RealPoint) -> list[float]:
        pairs = (zip(chain(*point(one)), chain(*point(other)), strict=True) for one, other in self.given)
        return [a - b for pair in pairs for a, b in pair]

    def _at(self, values: list[float]) -> RealPoint:
        return RealPoint(self.rules, dict(zip(self.places, values, strict=True)))


def _near(one: Matrix, other: Matrix) -> bool:
    pairs = zip(chain(*one), chain(*other), strict=True)
    return all(abs(a - b) < NEAR * max(1.0, abs(a)) for a, b in pairs)
