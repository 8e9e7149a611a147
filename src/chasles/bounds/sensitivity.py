"""How much does each rounding move an entry? Derivatives backwards through the program, over a box of inputs.

An entry differs from its exact value by the sum, over all operations, of the operation's relative error times the
entry's derivative by it, taken somewhere between (mean value theorem). The derivative is enclosed over the box and
over all values that rounding can lead to, so that the sum of sizes is a bound without any remainder. Errors that cancel
in an entry, as those of a cosine that enters twice, are seen to.
"""

from __future__ import annotations

from typing import Any

from chasles.bounds.running import Running
from chasles.lowering.program import Op

__all__ = ["entry_error"]

Slope = tuple[int, Any]
"""A power of t, and the ball that it is multiplied by."""


def entry_error(running: Running, entry: int, power: int) -> Any:
    """A bound on the error of the entry that a step holds, as a multiple of a power of t.

    Raises ZeroDivisionError where the error grows faster than that power.
    """
    total = running.zero
    slopes: dict[int, Slope] = {entry: (0, running.zero + 1)}
    for number in reversed(running.outline.needed):
        if number not in slopes:
            continue
        slope = slopes.pop(number)
        if number in running.losses:
            loss, absolute = running.losses[number]
            near = running.near[number]
            grown = slope[0] if absolute else slope[0] + near.power
            if grown < power:
                raise ZeroDivisionError
            moved = slope[1] * loss if absolute else slope[1] * near.value * loss
            total += running.lowered(abs(moved), grown, power)
            slope = slope[0], slope[1] * running.wobble
        for operand, given in _passed_on(running, number, slope):
            if operand in running.rounded:
                slopes[operand] = _sum(running, slopes[operand], given) if operand in slopes else given
    return total


def _passed_on(running: Running, number: int, slope: Slope) -> list[tuple[int, Slope]]:
    """The derivatives by the operands."""
    if number in running.outline.angles:
        return []
    power, value = slope
    operands, near = running.outline.operands(number), running.near
    match running.outline.program.steps[number].op:
        case Op.ADD:
            return [(k, slope) for k in operands]
        case Op.SUBTRACT:
            return [(operands[0], slope), (operands[1], (power, -value))]
        case Op.NEGATE:
            return [(operands[0], (power, -value))]
        case Op.MULTIPLY:
            pairs = (operands, operands[::-1])
            return [(k, (power + near[other].power, value * near[other].value)) for k, other in pairs]
        case Op.DIVIDE:
            above, below = (near[k] for k in operands)
            shared = power - below.power, value / below.value
            ratio = above.power - below.power, -above.value / below.value
            return [(operands[0], shared), (operands[1], (shared[0] + ratio[0], shared[1] * ratio[1]))]
        case Op.SQUARE_ROOT:
            return [(operands[0], (power, value / (2 * near[operands[0]].value.sqrt())))]
        case _:
            return []


def _sum(running: Running, x: Slope, y: Slope) -> Slope:
    power = min(x[0], y[0])
    return power, running.lowered(x[1], x[0], power) + running.lowered(y[1], y[0], power)
