"""A program prepared for bounds: guards of divisions looked through, angles as exact multiples of inputs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction

from chasles.lowering.program import Op, Program, Step, is_power_of_two
from chasles.lowering.scales import is_scale


class NoBound(ValueError):
    """A bound of this kind cannot be proved of this program; the message says why."""


@dataclass(frozen=True, slots=True)
class Outline:
    """The steps that results need, in order, by number; `angles` are the inputs' multiples whose sine is taken.

    `sources` says of which step a number is the value, where a guard passes it on; `angles[k]` is the argument, its
    entry and the factor of the angle of which step k is the sine or cosine. A factor of 1 or -1 is looked through too;
    `signs` are the steps by whose signs it is chosen. The `scales` are positive numbers on which no result depends:
    whatever they are in the machine, the exact value is the same with that number,
    which is proved of a kernel where it is proved equal to its statement.
    """

    program: Program
    needed: tuple[int, ...]
    sources: dict[int, int]
    angles: dict[int, tuple[int, int, Fraction]]
    signs: tuple[int, ...] = ()
    scales: frozenset[int] = frozenset()

    def operands(self, number: int) -> tuple[int, ...]:
        """The operands of a step, looked up through guards."""
        return tuple(self.sources.get(k, k) for k in self.program.steps[number].operands)

    def entries(self, result: int) -> tuple[int, ...]:
        """The steps that hold a result."""
        return tuple(self.sources.get(k, k) for k in self.program.results[result].entries)


def outlined(program: Program, truths: Mapping[int, bool] | None = None) -> Outline:
    """The program's outline where comparisons come out as `truths` says.

    Raises NoBound for another choice between cases and for an angle that is rounded.
    """
    steps = program.steps
    sources: dict[int, int] = {}
    signs: dict[int, list[int]] = {}
    for number, step in enumerate(steps):
        if _is_guard(number, step, program) or _is_held_back(number, step, program):
            sources[number] = sources.get(step.operands[2], step.operands[2])
        elif step.op is Op.SELECT and truths and step.operands[0] in truths:
            chosen = step.operands[1 if truths[step.operands[0]] else 2]
            sources[number] = sources.get(chosen, chosen)
        elif _is_of_the_finite(step, program):
            sources[number] = sources.get(step.operands[1], step.operands[1])
        elif step.op is Op.MULTIPLY and is_sign(sign := sources.get(step.operands[1], step.operands[1]), program):
            sources[number] = sources.get(step.operands[0], step.operands[0])
            signs[number] = [sources.get(k, k) for k in _compared(sign, program)]
    scales = frozenset(k for k in range(len(steps)) if is_scale(steps, k))
    needed: set[int] = set()
    angles: dict[int, tuple[int, int, Fraction]] = {}
    signed = sorted({k for number in signs for k in signs[number]})
    ahead = [sources.get(k, k) for result in program.results for k in result.entries] + signed
    while ahead:
        number = ahead.pop()
        if number in needed:
            continue
        needed.add(number)
        step = steps[number]
        if number in scales:
            continue
        if step.op in (Op.SELECT, Op.NOT_A_NUMBER):
            raise NoBound("it chooses between cases by values that are rounded")
        if step.op in (Op.SINE, Op.COSINE):
            angles[number] = _angle(step.operands[0], program)
            continue
        ahead += [sources.get(k, k) for k in step.operands]
    return Outline(program, tuple(sorted(needed)), sources, angles, tuple(signed), scales)


def is_sign(number: int, program: Program) -> bool:
    """Whether a step chooses between 1 and -1 by comparisons with zero."""
    step = program.steps[number]
    if step.op is not Op.SELECT:
        return False
    comparison = program.steps[step.operands[0]]
    compared = [k for k in comparison.operands if not _is_zero(program.steps[k])]
    return (
        comparison.op is Op.LESS
        and len(compared) == 1
        and all(is_one(k, program) or is_sign(k, program) for k in step.operands[1:])
    )


def is_one(number: int, program: Program) -> bool:
    """Whether a step is 1 or -1."""
    step = program.steps[number]
    if step.op is Op.NEGATE:
        return is_one(step.operands[0], program)
    return step.op is Op.CONSTANT and abs(step.value) == 1


def _compared(number: int, program: Program) -> Iterator[int]:
    """The steps by whose signs a sign is chosen."""
    step = program.steps[number]
    if step.op is Op.SELECT:
        yield from (k for k in program.steps[step.operands[0]].operands if not _is_zero(program.steps[k]))
        for operand in step.operands[1:]:
            yield from _compared(operand, program)


def with_cases(program: Program) -> Outline:
    """The program's outline with its choices and with angles as values like others.

    A choice of which one side is not a number, or of which both are the same, is looked through. Raises NoBound for a
    result that is nowhere a number.
    """
    steps, sources = program.steps, dict[int, int]()
    for number, step in enumerate(steps):
        if step.op is not Op.SELECT:
            continue
        _, one, other = (sources.get(k, k) for k in step.operands)
        if _is_guard(number, step, program) or steps[one].op is Op.NOT_A_NUMBER:
            sources[number] = other
        elif steps[other].op is Op.NOT_A_NUMBER or one == other:
            sources[number] = one
    results = [sources.get(k, k) for result in program.results for k in result.entries]
    needed = reached(results, lambda number: [sources.get(k, k) for k in steps[number].operands])
    if any(steps[number].op is Op.NOT_A_NUMBER for number in needed):
        raise NoBound("a result is not a number")
    return Outline(program, tuple(sorted(needed)), sources, {})


def reached(numbers: Iterable[int], read: Callable[[int], Iterable[int]]) -> set[int]:
    """These steps and all that they depend on, by what each of them reads."""
    found, ahead = set[int](), list(numbers)
    while ahead:
        number = ahead.pop()
        if number not in found:
            found.add(number)
            ahead += read(number)
    return found


def _is_guard(number: int, step: Step, program: Program) -> bool:
    """Whether a selection is 0 where a divisor is zero, and is read by divisions by that divisor alone.

    There the quotient is no number; everywhere else it is that of the operand selected.
    """
    if step.op is not Op.SELECT:
        return False
    steps = program.steps
    test, zero = (steps[k] for k in step.operands[:2])
    if test.op is not Op.EQUAL or not _is_zero(zero):
        return False
    tested = [k for k in test.operands if not _is_zero(steps[k])]
    readers = [reader for reader in steps if number in reader.operands]
    read = any(number in result.entries for result in program.results)
    return not read and all(
        reader.op is Op.DIVIDE
        and reader.operands[1] != number
        and (reader.operands[1] in tested or _root_of(steps[reader.operands[1]]) in tested)
        for reader in readers
    )


def _is_held_back(number: int, step: Step, program: Program) -> bool:
    """Whether a selection is 0 where a value is zero, and is read by guards and by the divisions that they guard alone.

    Where 0 is selected, the quotient is no number.
    """
    steps = program.steps
    if step.op is not Op.SELECT or not _is_zero(steps[step.operands[1]]):
        return False
    if steps[step.operands[0]].op is not Op.EQUAL or any(number in result.entries for result in program.results):
        return False
    zeros = {k for k, other in enumerate(steps) if _is_zero(other)}
    tests = {
        k for k, s in enumerate(steps) if s.op is Op.EQUAL and number in s.operands and not zeros.isdisjoint(s.operands)
    }
    guards = {
        k for k, s in enumerate(steps) if s.op is Op.SELECT and s.operands[0] in tests and _is_guard(k, s, program)
    }
    return all(
        k in tests or (reader.op is Op.DIVIDE and reader.operands[1] == number and reader.operands[0] in guards)
        for k, reader in enumerate(steps)
        if number in reader.operands
    ) and all(k in guards for k, reader in enumerate(steps) if not tests.isdisjoint(reader.operands))


def _is_of_the_finite(step: Step, program: Program) -> bool:
    """Whether a selection is not a number where some x - x is not zero, and so where x is no finite number."""
    if step.op is not Op.SELECT:
        return False
    steps = program.steps
    test, other = steps[step.operands[0]], steps[step.operands[2]]
    if test.op is not Op.EQUAL or other.op is not Op.NOT_A_NUMBER:
        return False
    compared = [steps[k] for k in test.operands if not _is_zero(steps[k])]
    return len(compared) == 1 and compared[0].op is Op.SUBTRACT and len(set(compared[0].operands)) == 1


def _is_zero(step: Step) -> bool:
    return step.op is Op.CONSTANT and step.value == 0


def _root_of(step: Step) -> int | None:
    return step.operands[0] if step.op is Op.SQUARE_ROOT else None


def _angle(number: int, program: Program) -> tuple[int, int, Fraction]:
    """The input and the power of two times which it is the angle."""
    step, factor = program.steps[number], Fraction(1)
    while step.op is Op.MULTIPLY:
        constant, inner = (program.steps[k] for k in step.operands)
        if constant.op is not Op.CONSTANT or not is_power_of_two(constant.value):
            break
        step, factor = inner, factor * constant.value
    if step.op is not Op.INPUT:
        raise NoBound("it takes the sine of a rounded angle")
    return step.argument, step.entry, factor
