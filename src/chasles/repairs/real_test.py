"""An equation at random motions: those of functions without polynomial form, and of their derivatives."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from itertools import chain, cycle, islice

import numpy as np

from chasles import vocabulary as w
from chasles.motions.random_motion import MOTIONS, Key, NotInMotion, RandomMotion, TooFewTerms, ValuesInMotion
from chasles.motions.satisfying_motion import equal, satisfying
from chasles.motions.time_series import Array
from chasles.statements import Hypothesis, Problem, Statement, problem_of
from chasles.statements.goals import AcceptedSides
from chasles.vocabulary import Node
from chasles.vocabulary.differentiation import NoRule
from chasles.vocabulary.partial import differentiates

TRIES = 60
"""So often a motion is looked for that satisfies what is given."""
RATES = 2
"""So many rates are taken of letters where some are taken."""
NO_VALUE = (ArithmeticError, ValueError, LookupError, TooFewTerms, w.Misfit, NoRule)
"""What is raised for an expression that has no value at a motion; `NotInMotion` and TypeError for any like it."""


def real_test(statement: Statement, left: Node, right: Node, accepted: AcceptedSides) -> RealTest | None:
    """The test in floating point of an equation that has no other; None where no motions are found."""

    def posed(one: Node, other: Node) -> Problem:
        return problem_of(statement.saying(one, other), "printed", accepted)

    try:
        test = RealTest(posed, (left, right))
    except (w.Misfit, TypeError, ValueError):
        return None
    return test if test.has_values else None


class RealTest:
    """Motions at which what a problem assumes holds; sides are compared there, carried out as `posed` where need be."""

    def __init__(self, posed: Callable[[Node, Node], Problem], sides: tuple[Node, Node]) -> None:
        self.posed, self.sides = posed, sides
        problem = posed(*sides)
        self._rules = dict(problem.rules)
        self._given = [goal.sides for goal in problem.conditions]
        self._positive: list[Node] = list(problem.nonnegative)
        for h in problem.hypotheses:
            self._given += h.equations if h.kind != "inequality" else ()
            self._positive += h.subjects[:1] if h.kind in ("inequality", "positive") else ()
        stated = (*problem.rules, *(goal.sides for goal in problem.goals), *self._given)
        said = [*chain(*stated), *self._positive]
        moves = any(isinstance(part, w.Rate) for side in said for part in w.walk(side))
        self._terms = 1 + RATES * moves
        self._values = self._drawn()
        self.is_direct = not any(side.expands for side in sides) and self._has_values(sides)

    @property
    def has_values(self) -> bool:
        """Whether the sides are made of words that have values at motions, at some of which they may have none."""
        return self._has_values(tuple(chain(*self._pairs(*self.sides))))

    def _has_values(self, sides: tuple[Node, ...]) -> bool:
        try:
            with np.errstate(all="ignore"):
                return self._values is not None and all(map(self._values, sides))
        except (NotInMotion, TypeError):
            return False
        except NO_VALUE:
            return True

    def agree(self, left: Node, right: Node) -> bool:
        """Whether the sides agree at the motions at which they are real."""
        if (values := self._values) is None:
            return False
        try:
            with np.errstate(all="ignore"):
                pairs = self._pairs(left, right)
                return all(equal(values(one), values(other), MOTIONS) for one, other in pairs)
        except (NotInMotion, TypeError, *NO_VALUE):
            return False

    def _pairs(self, left: Node, right: Node) -> list[tuple[Node, Node]]:
        """The sides; what is expanded, or differentiated in a way that values do not show, is carried out once."""
        if self.is_direct or not any(side.expands or differentiates(side) for side in (left, right)):
            return [(left, right)]
        return [goal.sides for goal in self.posed(left, right).goals]

    def _at(self, motion: RandomMotion) -> ValuesInMotion:
        return ValuesInMotion(motion, self._rules, {}, self._terms)

    def _drawn(self) -> ValuesInMotion | None:
        """The values at motions, all evaluated at once; None where there are not two."""
        with np.errstate(all="ignore"):
            found = list(islice(chain.from_iterable(map(self._satisfying, range(TRIES))), MOTIONS))
        if len(found) < 2:
            return None
        lanes = [*islice(cycle(found), MOTIONS)]
        numbers = {key: np.concatenate([lane[key] for lane in lanes], axis=3) for key in found[0]}
        return self._at(RandomMotion(self._facts, numbers))

    def _satisfying(self, start: int) -> Iterator[dict[Key, Array]]:
        """The free numbers of motions that satisfy what is given, one where equations are."""
        drawn = RandomMotion(self._facts, start=start)
        with suppress(NotInMotion, TypeError, *NO_VALUE):
            motion = satisfying(self._given, self._rules, {}, self._terms, drawn) if self._given else drawn
            if motion is not None:
                values = self._at(motion)
                signs = [np.broadcast_to(values.scalar(each).now, (MOTIONS, 1)) > 0 for each in self._positive]
                lanes = np.flatnonzero(np.all(signs, axis=0)) if signs else range(MOTIONS)
                for lane in lanes[:1] if self._given else lanes:
                    yield {key: part[:, :, :, [min(lane, part.shape[3] - 1)]] for key, part in motion.numbers.items()}

    def _facts(self, symbol: w.Symbol) -> tuple[Hypothesis, ...]:
        return (Hypothesis("positive", (symbol,)),) if symbol in self._positive else ()
