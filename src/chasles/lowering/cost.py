"""What does a program cost? Operations weighted by how long current processors take over them, in additions."""

from __future__ import annotations

from chasles.lowering.program import Op, Program

__all__ = ["ANGLE", "WEIGHTS", "cost"]

WEIGHTS = {
    Op.ADD: 1,
    Op.SUBTRACT: 1,
    Op.MULTIPLY: 1,
    Op.DIVIDE: 4,
    Op.SQUARE_ROOT: 7,
    Op.SINE: 5,
    Op.COSINE: 5,
    Op.ARCTANGENT2: 40,
}
"""Time in a vector loop relative to an addition; comparisons, selections and signs vanish beside the rest."""

ANGLE = 16
"""What the first of cosine and sine of an angle costs besides: reducing the angle, which both share."""


def cost(program: Program) -> int:
    """The weighted number of operations."""
    angles = {step.operands for step in program.steps if step.op in (Op.SINE, Op.COSINE)}
    return ANGLE * len(angles) + sum(WEIGHTS[op] * count for op, count in program.operations.items())
