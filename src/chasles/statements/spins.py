"""Rotations that move: the rate of a rotation is a skew-symmetric matrix times the rotation.

Of Q Q^T = 1 the rate is dQ Q^T + (dQ Q^T)^T = 0, so that dQ Q^T is skew-symmetric for every differentiable rotation Q,
as (3.45) to (3.49) say: dQ = CPM(spin) Q, the spin being the axial vector of dQ Q^T, as often differentiable as dQ is.
Conversely, from any rotation at one instant every differentiable spin makes a motion whose rotation it is. So a
problem holds for all moving rotations if and only if it holds with this in the place of dQ, for all spins.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from chasles.statements.hypotheses import Hypothesis
from chasles.statements.problem import Problem
from chasles.vocabulary import CPM, FREQUENCY, Node, Rate, Symbol, vector, walk


def with_spins(problem: Problem) -> Problem:
    """The same problem with the rates of its rotations made from free spins; the problem itself if it has none."""
    turning = tuple(_turning(problem))
    rules: list[tuple[Node, Node]] = []
    for _, rotation in turning:
        spin = vector(f"{rotation.name}_spin", rf"\boldsymbol{{\omega}}_{{{rotation.letter}}}", "", FREQUENCY)
        rules.append((Rate(rotation), CPM(spin) @ rotation))
    presupposed = tuple(dict.fromkeys((*problem.presupposed, *(hypothesis for hypothesis, _ in turning))))
    return replace(problem, rules=(*problem.rules, *rules), presupposed=presupposed) if turning else problem


def _turning(problem: Problem) -> Iterator[tuple[Hypothesis, Symbol]]:
    """The rotations of which rates are taken and nothing is given."""
    sides = problem.sides
    sides += [*(right for _, right in problem.rules), *(side for h in problem.hypotheses if h.free for side in h.sides)]
    moving = {part for side in sides for node in walk(side) if isinstance(node, Rate) for part in walk(node)}
    known = {part for left, _ in problem.rules for part in walk(left)}.union(problem.unknowns)
    for hypothesis in problem.hypotheses:
        subject = hypothesis.subjects[0]
        if hypothesis.kind != "rotation" or hypothesis.free:
            continue
        if isinstance(subject, Symbol) and subject in moving - known and not subject.constant:
            yield hypothesis, subject
