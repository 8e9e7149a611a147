"""What exactly must be decided? Goals, rules, conditions and hypotheses: words only, no algebra."""

from __future__ import annotations

from collections.abc import Callable, Container
from dataclasses import dataclass
from dataclasses import replace as with_fields
from itertools import chain

from chasles.statements.hypotheses import Hypothesis
from chasles.vocabulary import Node, Symbol, walk


@dataclass(frozen=True, slots=True)
class Goal:
    """Two sides to be proved equal, entry by entry."""

    label: str
    left: Node
    right: Node

    @property
    def sides(self) -> tuple[Node, Node]:
        """The left side and the right."""
        return self.left, self.right


@dataclass(frozen=True, slots=True)
class Problem:
    """For all values of the symbols that satisfy `hypotheses` and `conditions`, with `rules` applied: the goals hold.

    `rules` replace symbols (or rates of symbols); `unknowns` are the symbols that the conditions must determine. What
    the goals prove, they prove under `presupposed` hypotheses, by which squares are squares. They are about each of
    the `cases`: if nothing satisfies one, they say nothing. Nor does anything refute them where a symbol is negative
    that is among the `nonnegative`.
    """

    goals: tuple[Goal, ...]
    rules: tuple[tuple[Node, Node], ...] = ()
    conditions: tuple[Goal, ...] = ()
    unknowns: tuple[Symbol, ...] = ()
    hypotheses: tuple[Hypothesis, ...] = ()
    presupposed: tuple[Hypothesis, ...] = ()
    cases: tuple[Goal, ...] = ()
    nonnegative: tuple[Symbol, ...] = ()

    @property
    def sides(self) -> list[Node]:
        """The sides of what is to be proved and of the conditions."""
        return [side for goal in (*self.goals, *self.conditions) for side in goal.sides]

    @property
    def sides_and_rules(self) -> list[Node]:
        """Those sides, and the sides of the rules."""
        return [*self.sides, *chain.from_iterable(self.rules)]

    @property
    def assumed_sides(self) -> list[Node]:
        """The sides of the equations that hypotheses say."""
        return [side for hypothesis in self.hypotheses for side in hypothesis.sides]

    @property
    def all_sides(self) -> list[Node]:
        """The sides of all that is said to be equal."""
        return [*self.sides_and_rules, *(side for goal in self.cases for side in goal.sides), *self.assumed_sides]

    @property
    def has_functions(self) -> bool:
        """Whether functions of scalars occur that have no polynomial form."""
        sides = (*self.sides_and_rules, *self.assumed_sides)
        return any(part.has_no_polynomial_form for side in sides for part in walk(side))

    def said_otherwise(
        self,
        side: Callable[[Node], Node],
        hypothesis: Callable[[Hypothesis], Hypothesis],
        at_work: Container[Node] | None = None,
    ) -> Problem:
        """The same problem with each side said otherwise; of rules only those `at_work`, if these are named."""

        def rewritten(goal: Goal) -> Goal:
            return Goal(goal.label, *map(side, goal.sides))

        changed = dict(self.rules) if at_work is None else at_work
        rules = tuple((left, side(right) if left in changed else right) for left, right in self.rules)
        return with_fields(
            self,
            goals=tuple(map(rewritten, self.goals)),
            rules=rules,
            conditions=tuple(map(rewritten, self.conditions)),
            hypotheses=tuple(map(hypothesis, self.hypotheses)),
            cases=tuple(map(rewritten, self.cases)),
        )
