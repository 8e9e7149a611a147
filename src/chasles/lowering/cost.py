"""What does a program cost? Operations weighted by how long current processors take over them, in additions."""

from __future__ import annotations

from chasles.lowering.program import Op, Program

__all__ = ["WEIGHTS", "cost"]

WEIGHTS = {
    Op.ADD: 1,
    Op.SUBTRACT: 1,
    Op.MULTIPLY: 1,
    Op.DIVIDE: 4,
    Op.SQUARE_ROOT: 5,
    Op.SINE: 15,
    Op.COSINE: 15,
    Op.ARCTANGENT2: 30,
}
"""Reciprocal throughput relative to an addition; comparisons, selections and signs vanish beside the rest."""


def cost(program: Program) -> int:
    """The weighted number of operations."""
    return sum(WEIGHTS[op] * count for op, count in program.operations.items())
