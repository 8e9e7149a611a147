"""Does the verdict agree with numbers? Each sentence at a few explicit motions, in 80 digits and more.

The prover's ring, its rates and its search are not used: rates are differences, conditions are solved as numbers,
bodies are point masses. An opinion proves nothing; a verdict that it contradicts is wrong.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from chasles.evaluation.matrices import Matrix
from chasles.statements import Claim, Condition, Goal, Inverse, Problem, Statement, Theorem, problem_of
from chasles.statements.goals import AcceptedSides
from chasles.statements.inversion import problems_of_inverse
from chasles.statements.posing import default_sides
from chasles.statements.statement import bare
from chasles.vocabulary import Node, Rate

from .instants import DIGITS, World

__all__ = ["AGREEMENT", "DISAGREEMENT", "NoMotion", "Opinion", "opinion_on", "rooted", "second_opinion"]

AGREEMENT = 80
"""Digits to which the two sides of what holds are the same."""
DISAGREEMENT = 6
"""Digits to which the two sides of what does not hold are the same at most."""
MOTIONS = 3
ATTEMPTS = 20

Sentence = Statement | Theorem | Inverse


class NoMotion(ValueError):
    """No motion was drawn that satisfies the hypotheses and conditions; the message names one that is violated."""


@dataclass(frozen=True, slots=True)
class Opinion:
    """To how many digits the sides of the goals are the same: of the worst goal, at the best and the worst motion."""

    most: float
    least: float
    goal: str

    @property
    def agrees(self) -> bool:
        """Whether all goals are satisfied at all motions."""
        return self.least > AGREEMENT

    @property
    def differs(self) -> bool:
        """Whether some goal is violated at every motion."""
        return self.most < DISAGREEMENT


def opinion_on(
    sentence: Sentence,
    form: str = "printed",
    accepted: AcceptedSides = default_sides,
    motions: int = MOTIONS,
) -> Opinion:
    """The opinion on a sentence in one of its forms.

    Raises `Misfit` if the form does not fit together, and `NoMotion` where no motion satisfies what is assumed.
    """
    if isinstance(sentence, Inverse):
        found = [second_opinion(problem, motions) for _, problem in problems_of_inverse(sentence, accepted)]
        return min(found, key=lambda opinion: opinion.least)
    problem = problem_of(sentence, form, accepted)
    if isinstance(sentence, Condition) and sentence.on and sentence.solution is None:
        conditions = (*problem.conditions, *problem.goals)
        unknowns = tuple(dict.fromkeys((*problem.unknowns, *sentence.on)))
        problem = replace(problem, conditions=conditions, unknowns=unknowns)
    return second_opinion(problem, motions)


def rooted(sentence: Statement | Theorem) -> tuple[Statement | Theorem, ...]:
    """The same sentence, resting on the definitions, conditions and postulates from which its given claims follow.

    So the motion is one of the whole chapter: where a claim is given that omega is the axial vector of Omega, it is so
    because Omega is made from the rate of a rotation. A claim about a symbol that is defined nowhere stays, in the
    second version only if it does not speak of a rate. Nothing if there are no claims to go back from.
    """
    if not any(isinstance(given, Claim) for given in sentence.given):
        return ()
    reached = dict.fromkeys(_reached(sentence))
    known = {_stem(g.left) for g in reached if not isinstance(g, Claim)}
    known |= {symbol for g in reached if isinstance(g, Condition) for symbol in g.on}
    kept = [g for g in reached if not isinstance(g, Claim) or _stem(g.left) not in known]
    rateless = [g for g in kept if not isinstance(g, Claim) or not isinstance(bare(g.left), Rate)]
    assumed = tuple(dict.fromkeys(h for g in (sentence, *reached) for h in g.assuming))
    return tuple(replace(sentence, given=tuple(given), assuming=assumed) for given in (kept, rateless))


def _reached(sentence: Sentence) -> Iterator[Statement]:
    """All statements on which a sentence rests, directly or through others."""
    for given in sentence.given:
        yield given
        yield from _reached(given)


def _stem(node: Node) -> Node:
    """The symbol of which a statement speaks: p for the second rate of p(t)."""
    left = bare(node)
    while isinstance(left, Rate):
        left = left.of
    return left


def second_opinion(problem: Problem, motions: int = MOTIONS) -> Opinion:
    """The opinion on a problem, at so many motions. Raises `NoMotion`."""
    found: list[tuple[float, str]] = []
    objection = ""
    for seed in range(motions * ATTEMPTS):
        world = World(problem, seed)
        objection = next(_objections(world), "")
        if not objection:
            found.append(_worst(world, problem.goals))
        if len(found) == motions:
            return Opinion(max(found)[0], *min(found))
    raise NoMotion(f"none of {motions * ATTEMPTS} motions satisfies what is assumed: {objection}")


def _worst(world: World, goals: tuple[Goal, ...]) -> tuple[float, str]:
    return min(((_digits(world, goal.left, goal.right), goal.label) for goal in goals), default=(float(DIGITS), ""))


def _objections(world: World) -> Iterator[str]:
    """The conditions and hypotheses that the motion violates."""
    now = world.instant()
    for hypothesis in world.problem.hypotheses:
        # A motion has the rate that is given for it: that another given statement agrees with it is not asked here.
        for left, right in hypothesis.equations if hypothesis.kind != "given" else ():
            if _digits(world, left, right) < AGREEMENT:
                yield hypothesis.text
        for node in hypothesis.nonvanishing:
            if abs(now(node)[0][0]) * 10**DISAGREEMENT < 1:
                yield hypothesis.text
    for condition in world.problem.conditions:
        if _digits(world, condition.left, condition.right) < AGREEMENT:
            yield f"the condition {condition.label}"


def _digits(world: World, left: Any, right: Any) -> float:
    """The number of digits, relative to the largest entry, to which the two sides are the same."""
    now = world.instant()
    one, other = now(left), now(right)
    size = max((abs(entry) for side in (one, other) for row in side for entry in row), default=0)
    apart = _apart(one, other)
    return float(DIGITS) if apart == 0 else float(-world.context.log10(apart / max(size, 1)))


def _apart(one: Matrix, other: Matrix) -> Any:
    return max(abs(a - b) for row, line in zip(one, other, strict=True) for a, b in zip(row, line, strict=True))
