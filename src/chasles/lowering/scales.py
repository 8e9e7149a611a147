"""A power of numbers is in range where the numbers themselves are not far from one: by what are they to be divided?

The scale of some numbers is the largest of their sizes, or 1 where all are zero. What is homogeneous in them is the
same whatever positive number they are divided by, so that nothing depends on how the comparisons of rounded numbers
come out: a scale is read as any positive number.
"""

from __future__ import annotations

from collections.abc import Sequence

from chasles.lowering.builder import Builder
from chasles.lowering.program import Op, Step

__all__ = ["is_scale", "scale_of"]


def scale_of(build: Builder, numbers: Sequence[int]) -> int:
    """The step that holds the scale of the numbers; NaN where the first of them is, or all before it are infinite."""
    most = _size(build, numbers[0])
    for number in numbers[1:]:
        size = _size(build, number)
        most = build.select(build.less(most, size), size, most)
    return build.select(build.equal(most, build.zero), build.one, most)


def _size(build: Builder, number: int) -> int:
    return build.select(build.less(number, build.zero), build.negate(number), number)


def is_scale(steps: Sequence[Step], number: int) -> bool:
    """Whether a step is the scale of some numbers, and so positive wherever it is a number."""
    step = steps[number]
    if step.op is not Op.SELECT:
        return False
    test, one, most = step.operands
    return (
        steps[test].op is Op.EQUAL
        and most in steps[test].operands
        and any(_is_constant(steps[k], 0) for k in steps[test].operands)
        and _is_constant(steps[one], 1)
        and _is_size(steps, most)
    )


def _is_size(steps: Sequence[Step], number: int) -> bool:
    """Whether a step chooses between sizes, or is the size of a number."""
    step = steps[number]
    if step.op is not Op.SELECT or steps[step.operands[0]].op is not Op.LESS:
        return False
    test, one, other = step.operands
    less, more = steps[test].operands
    if steps[one].op is Op.NEGATE and steps[one].operands == (other,):
        return less == other and _is_constant(steps[more], 0)
    return _is_size(steps, one) and _is_size(steps, other)


def _is_constant(step: Step, value: int) -> bool:
    return step.op is Op.CONSTANT and step.value == value
