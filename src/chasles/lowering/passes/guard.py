"""Divisions guarded: where a divisor is zero the quotient is 0/0, not a number, whatever was to be divided.

Without that x/0 is infinite, and an infinity can come back as a finite number, as in 1/(1/0). The numerator is replaced
and not the divisor, so that the machine itself says `invalid`, and only there.
"""

from __future__ import annotations

from dataclasses import replace as with_fields
from functools import cache, partial

from chasles.lowering.program import Op, Program, Step
from chasles.lowering.scales import is_scale


def guarded(program: Program) -> Program:
    """The same program, and NaN instead of an infinity wherever a divisor that is not a constant is zero."""
    steps: list[Step] = []
    numbers: dict[Step, int] = {}
    is_known_scale = cache(partial(is_scale, steps))

    def add(step: Step) -> int:
        if step not in numbers:
            numbers[step] = len(steps)
            steps.append(step)
        return numbers[step]

    place: list[int] = []
    for step in program.steps:
        operands = tuple(place[k] for k in step.operands)
        if step.op is Op.DIVIDE and steps[operands[1]].op is not Op.CONSTANT and not is_known_scale(operands[1]):
            zero = add(Step(Op.CONSTANT))
            divisor = steps[operands[1]]
            # A root is zero where its radicand is, which is known earlier.
            tested = divisor.operands[0] if divisor.op is Op.SQUARE_ROOT else operands[1]
            singular = add(Step(Op.EQUAL, (tested, zero)))
            operands = add(Step(Op.SELECT, (singular, zero, operands[0]))), operands[1]
        place.append(add(step.on(operands)))
    results = tuple(with_fields(r, entries=tuple(place[k] for k in r.entries)) for r in program.results)
    return with_fields(program, steps=tuple(steps), results=results)
