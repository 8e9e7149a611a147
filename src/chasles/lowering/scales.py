"""A power of numbers is in range where the numbers themselves are not far from one: by what are they to be divided?

The scale of some numbers is the largest of their sizes, or 1 where all are zero. What is homogeneous in them is the
same whatever positive number they are divided by, so that nothing depends on how the comparisons of rounded numbers
come out: a scale is read as any positive number.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from chasles.lowering.builder import Builder
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Op, Program, Step

LARGE = Fraction(2**60)
"""From here on squares can be out of range in single precision, and 1 is nothing beside them in double."""


def scale_of(build: Builder, numbers: Sequence[int]) -> int:
    """The step that holds the scale of the numbers; NaN where the first of them is, or all before it are infinite."""
    most = _most(build, numbers)
    return build.select(build.equal(most, build.zero), build.one, most)


def large_scale_of(build: Builder, numbers: Sequence[int]) -> int:
    """The step that holds the scale of large numbers, and 1 where they are not large, or infinite, or none."""
    most = _most(build, numbers)
    held = build.select(build.equal(build.subtract(most, most), build.zero), most, build.one)
    return build.select(build.less(build.constant(LARGE), most), held, build.one)


def _most(build: Builder, numbers: Sequence[int]) -> int:
    most = _size(build, numbers[0])
    for number in numbers[1:]:
        size = _size(build, number)
        most = build.select(build.less(most, size), size, most)
    return most


def _size(build: Builder, number: int) -> int:
    return build.select(build.less(number, build.zero), build.negate(number), number)


def is_scale(steps: Sequence[Step], number: int) -> bool:
    """Whether a step is the scale of some numbers, and so positive wherever it is a number."""
    step = steps[number]
    if step.op is not Op.SELECT:
        return False
    test, one, most = step.operands
    if steps[test].op is Op.LESS and _is_constant(steps[most], 1) and steps[one].op is Op.SELECT:
        return _is_constant(steps[steps[test].operands[0]], LARGE) and _is_large(steps, one, steps[test].operands[1])
    return (
        steps[test].op is Op.EQUAL
        and most in steps[test].operands
        and any(_is_constant(steps[k], 0) for k in steps[test].operands)
        and _is_constant(steps[one], 1)
        and _is_size(steps, most)
    )


def with_free_scales(program: Program, which: int) -> Program:
    """The program with each of its scales read: whatever positive number it is, nothing is to depend on it."""
    steps = tuple(
        Step(Op.INPUT, argument=-which, entry=number) if is_scale(program.steps, number) else step
        for number, step in enumerate(program.steps)
    )
    return pruned(replace(program, steps=steps))


def _is_large(steps: Sequence[Step], number: int, most: int) -> bool:
    """Whether a step is the largest of some sizes, or 1."""
    _, one, other = steps[number].operands
    return one == most and _is_size(steps, most) and _is_constant(steps[other], 1)


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


def _is_constant(step: Step, value: Fraction | int) -> bool:
    return step.op is Op.CONSTANT and step.value == value
