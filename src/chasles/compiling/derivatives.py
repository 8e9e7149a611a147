"""How do steps change with an input? By the chain rule, step by step, so that derivatives share what is computed.

This is the forward mode of automatic differentiation (Griewank and Walther, Evaluating Derivatives, 2008, section 3.1).
Of a choice it is the derivative of what is chosen; nothing is said of where the choice changes.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from chasles.lowering.builder import Builder
from chasles.lowering.functions import FUNCTIONS
from chasles.lowering.program import Op, Step
from chasles.lowering.refusal import LoweringError

__all__ = ["derivatives"]


def derivatives(build: Builder, entries: Sequence[int], argument: int, entry: int) -> list[int]:
    """The steps that hold the derivatives of some steps by an entry of an argument."""
    steps = build.steps[: max(entries) + 1]
    rates: list[int] = []
    for number, step in enumerate(steps):
        if step.op is Op.INPUT:
            rates.append(build.one if (step.argument, step.entry) == (argument, entry) else build.zero)
        else:
            rates.append(_rate(build, number, step, rates))
    return [rates[k] for k in entries]


def _rate(build: Builder, number: int, step: Step, by: Sequence[int]) -> int:
    rates = [by[k] for k in step.operands]
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
        case Op.COSINE if (under := _under_root(build, a)) is not None:
            half = build.multiply(build.constant(-(under[0] ** 2) / 2), build.function("stumpff", build.one, a))
            return build.multiply(half, by[under[1]])
        case Op.COSINE:
            return build.negate(build.multiply(build.sine(a), da))
        case Op.ARCTANGENT2:
            turned = build.subtract(build.multiply(b, da), build.multiply(a, db))
            return build.divide(turned, build.add(build.multiply(a, a), build.multiply(b, b)))
        case Op.FUNCTION:
            return _of_function(build, number, step, by)
        case op:
            raise AssertionError(op)


def _under_root(build: Builder, number: int) -> tuple[Fraction, int] | None:
    """Of which step a step is a multiple of the root, and which multiple."""
    step = build.step(number)
    if step.op is Op.SQUARE_ROOT:
        return Fraction(1), step.operands[0]
    factor = build.value(step.operands[0]) if step.op is Op.MULTIPLY else None
    inner = None if factor is None else _under_root(build, step.operands[1])
    return None if factor is None or inner is None else (factor * inner[0], inner[1])


def _of_function(build: Builder, number: int, step: Step, by: Sequence[int]) -> int:
    rates = [by[k] for k in step.operands]
    function = FUNCTIONS[step.function]
    known, under = function.rates, _under_root(build, step.operands[-1])
    if function.rates_by_square is not None and under is not None:
        # The root itself has no derivative at zero, and the even function has.
        factor, square = under
        times = build.constant(factor * factor)
        known, rates = function.rates_by_square, [*rates[:-1], build.multiply(times, by[square])]
    if known is None:
        raise LoweringError(f"the derivative of {step.function} is not known")
    total = build.zero
    for slope, rate in zip(known(build, number, *step.operands), rates, strict=True):
        if rate != build.zero:
            total = build.add(total, build.multiply(slope, rate))
    return total
