"""What does a program cost? Operations weighted by how long current processors take over them, in additions.

In a loop over many items the operations count; for one item the longest chain of them does. `python -m benchmarks.cost`
measures both on a machine, and how well they foretell the times of the kernels.
"""

from __future__ import annotations

from collections.abc import Mapping

from chasles.lowering.program import Op, Program

WEIGHTS = {
    Op.ADD: 1,
    Op.SUBTRACT: 1,
    Op.MULTIPLY: 1,
    Op.DIVIDE: 12,
    Op.SQUARE_ROOT: 20,
    Op.SINE: 1,
    Op.COSINE: 1,
    Op.ARCTANGENT2: 300,
    Op.FUNCTION: 100,
}
"""Time in a vector loop relative to an addition; comparisons, selections and signs vanish beside the rest."""

LATENCIES = {
    Op.ADD: 1,
    Op.SUBTRACT: 1,
    Op.MULTIPLY: 1,
    Op.DIVIDE: 5,
    Op.SQUARE_ROOT: 8,
    Op.SINE: 12,
    Op.COSINE: 12,
    Op.ARCTANGENT2: 25,
    Op.FUNCTION: 20,
    Op.LESS: 1,
    Op.EQUAL: 1,
    Op.SELECT: 1,
}
"""Time until a result can be used, relative to that of an addition; a change of sign is taken into what uses it."""

ROUNDINGS = {
    **dict.fromkeys((Op.ADD, Op.SUBTRACT, Op.MULTIPLY, Op.DIVIDE, Op.SQUARE_ROOT), 1),
    **dict.fromkeys((Op.SINE, Op.COSINE, Op.ARCTANGENT2, Op.FUNCTION), 2),
}

ANGLE = 40
"""What the first of cosine and sine of an angle costs besides: both are computed, and selected from, together."""


def cost(program: Program) -> int:
    """The weighted number of operations."""
    angles = {step.operands for step in program.steps if step.op in (Op.SINE, Op.COSINE)}
    return ANGLE * len(angles) + sum(WEIGHTS[op] * count for op, count in program.operations.items())


def latency(program: Program) -> int:
    """The weighted length of the longest chain of steps, each of which waits for the one before it."""
    return _longest_chain(program, LATENCIES)


def roundings(program: Program) -> int:
    """The most roundings in a row: to first order, so many units in the last place, times the condition, can go wrong.

    A sine, a cosine or an arctangent counts as two: libraries round it to within one unit rather than half of one.
    """
    return _longest_chain(program, ROUNDINGS)


def _longest_chain(program: Program, weights: Mapping[Op, int]) -> int:
    lengths: list[int] = []
    for step in program.steps:
        lengths.append(weights.get(step.op, 0) + max((lengths[k] for k in step.operands), default=0))
    return max((lengths[entry] for result in program.results for entry in result.entries), default=0)


def price(program: Program) -> tuple[int, int]:
    """By what programs that compute the same are chosen: their operations, then their longest chain."""
    return cost(program), latency(program)
