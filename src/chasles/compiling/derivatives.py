"""How do steps change with an input? By the chain rule, step by step, so that derivatives share what is computed.

This is the forward mode of automatic differentiation (Griewank and Walther, Evaluating Derivatives, 2008, section 3.1).
Of a choice it is the derivative of what is chosen; nothing is said of where the choice changes.
"""

from __future__ import annotations

from collections.abc import Sequence

from chasles.lowering.builder import Builder
from chasles.lowering.program import Op, Step

__all__ = ["derivatives"]


def derivatives(build: Builder, entries: Sequence[int], argument: int, entry: int) -> list[int]:
    """The steps that hold the derivatives of some steps by an entry of an argument."""
    steps = build.steps[: max(entries) + 1]
    rates: list[int] = []
    for number, step in enumerate(steps):
        if step.op is Op.INPUT:
            rates.append(build.one if (step.argument, step.entry) == (argument, entry) else build.zero)
        else:
            rates.append(_rate(build, number, step, [rates[k] for k in step.operands]))
    return [rates[k] for k in entries]


def _rate(build: Builder, number: int, step: Step, rates: Sequence[int]) -> int:
    if step.op is Op.NOT_A_NUMBER:
        return number
    if step.op is Op.SELECT:
        return build.select(step.operands[0], rates[1], rates[2])
    if all(rate == build.zero for rate in rates) or step.op in (Op.LESS, Op.EQUAL):
        return build.zero
    a, b = (*step.operands, build.zero)[:2]
    da, db = (*rates, build.zero)[:2]
    match step.op:
        case Op.ADD:
            return build.add(da, db)
        case Op.SUBTRACT:
            return build.subtract(da, db)
        case Op.MULTIPLY:
            return build.add(build.multiply(da, b), build.multiply(a, db))
        case Op.DIVIDE:
            return build.divide(build.subtract(da, build.multiply(number, db)), b)
        case Op.NEGATE:
            return build.negate(da)
        case Op.SQUARE_ROOT:
            return build.divide(da, build.multiply(build.constant(2), number))
        case Op.SINE:
            return build.multiply(build.cosine(a), da)
        case Op.COSINE:
            return build.negate(build.multiply(build.sine(a), da))
        case Op.ARCTANGENT2:
            turned = build.subtract(build.multiply(b, da), build.multiply(a, db))
            return build.divide(turned, build.add(build.multiply(a, a), build.multiply(b, b)))
        case op:
            raise AssertionError(op)
