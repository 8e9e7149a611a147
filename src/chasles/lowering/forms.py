"""Forms in other steps, such as sums of squares, by which a program divides or of which it takes the root."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache, partial
from itertools import product

from chasles.lowering.program import Op, Program, Step
from chasles.lowering.scales import is_scale

MOST_TESTS = 12
"""Choices that decide what is divided by; of more each doubles what is to be looked at."""


@dataclass(frozen=True, slots=True)
class Divisor:
    """A step that is a form in others, its leaves; if it is `chosen` from several, it is the sum of their squares.

    Of one with `constants` it is the sum of multiples of their squares and of constants.
    """

    step: int
    leaves: tuple[int, ...]
    chosen: bool = False
    constants: bool = False


def divisors(program: Program, *, roots: bool) -> Iterator[Divisor]:
    """The forms of the second degree and of higher ones that are divided by, with or without a root.

    With `roots` also those of which the root is taken, divided by or not, and then sums of squares with constants, too.
    """
    steps, degrees = program.steps, _degrees(program.steps)
    is_known_scale = cache(partial(is_scale, steps))
    for place, step in enumerate(steps):
        if step.op is Op.DIVIDE and is_known_scale(step.operands[1]):
            continue
        if step.op is Op.DIVIDE:
            number = step.operands[1]
            under = steps[number]
            form = under.operands[0] if under.op is Op.SQUARE_ROOT else number
            if steps[form].op is Op.SELECT:
                leaves = _chosen_leaves(program, form, number)
                if leaves:
                    yield Divisor(form, leaves, chosen=True)
                continue
        elif roots and step.op is Op.SQUARE_ROOT:
            form = step.operands[0]
            squared = _squared(steps, form)
            large = tuple(sorted({k for k in squared if k is not None}))
            if None in squared and _vanish(steps, large):
                yield Divisor(form, large, constants=True)
                continue
        else:
            continue
        leaves = _leaves(steps, degrees, form)
        # The root of an odd power of a scale is no power of it.
        has_root = step.op is Op.SQUARE_ROOT or form != step.operands[1]
        if degrees[form] > 1 and not (has_root and degrees[form] % 2) and _vanish(steps, leaves) and form < place:
            yield Divisor(form, leaves)


def _degrees(steps: Sequence[Step]) -> list[int]:
    """The degree of each step as a form in its leaves; 1 for a leaf."""
    found: list[int] = []
    for step in steps:
        of = [found[k] for k in step.operands]
        match step.op:
            case Op.CONSTANT:
                found.append(0)
            case Op.NEGATE:
                found.append(of[0])
            case Op.MULTIPLY:
                found.append(of[0] + of[1])
            case Op.ADD | Op.SUBTRACT:
                found.append(of[0] if of[0] == of[1] else 1)
            case Op.SQUARE_ROOT if of[0] > 1 and of[0] % 2 == 0:
                found.append(of[0] // 2)
            case _:
                found.append(1)
    return found


def _leaves(steps: Sequence[Step], degrees: Sequence[int], form: int) -> tuple[int, ...]:
    """The steps in which a form is one, each once, in the order of the program; none of a product of several.

    Of these one may be as small as another is large: what the largest divides vanishes where the product does not.
    """
    found, seen, waiting, is_sum = set(), set(), [form], False
    while waiting:
        number = waiting.pop()
        if number in seen:
            continue
        seen.add(number)
        step = steps[number]
        alike = step.op in (Op.ADD, Op.SUBTRACT) and all(degrees[k] == degrees[number] for k in step.operands)
        root = step.op is Op.SQUARE_ROOT and degrees[step.operands[0]] == 2 * degrees[number]
        if step.op is Op.NEGATE or (degrees[number] > 1 and (step.op is Op.MULTIPLY or alike)) or root:
            waiting += step.operands
            is_sum |= alike
        elif step.op is not Op.CONSTANT:
            found.add(number)
    return tuple(sorted(found)) if is_sum or len(found) == 1 else ()


def _vanish(steps: Sequence[Step], leaves: Sequence[int]) -> bool:
    """Whether all leaves vanish with the inputs, and so can be small at once."""
    return bool(leaves) and all(_is_linear(steps, leaf) for leaf in leaves)


def _is_linear(steps: Sequence[Step], number: int) -> bool:
    step = steps[number]
    if step.op in (Op.ADD, Op.SUBTRACT, Op.NEGATE):
        return all(_is_linear(steps, k) for k in step.operands)
    if step.op is Op.MULTIPLY:
        return steps[step.operands[0]].op is Op.CONSTANT and _is_linear(steps, step.operands[1])
    return step.op is Op.INPUT


def _chosen_leaves(program: Program, form: int, divisor: int) -> tuple[int, ...]:
    """The numerators over a chosen sum of squares of which it is the sum of squares, whichever is chosen."""
    steps = program.steps
    above = {s.operands[0] for s in steps if s.op is Op.DIVIDE and s.operands[1] == divisor}
    tests = sorted({test for k in (form, *above) for test in _tests(steps, k)})
    if len(tests) > MOST_TESTS:
        return ()
    ways = [dict(zip(tests, way, strict=True)) for way in product((True, False), repeat=len(tests))]
    chosen = [(taken, _squares(steps, _resolved(steps, form, taken))) for taken in ways if _exists(steps, form, taken)]
    if not any(_vanish(steps, squares) for _, squares in chosen):
        return ()
    leaves = tuple(sorted(k for k in above if all(_resolved(steps, k, taken) in squares for taken, squares in chosen)))
    for taken, squares in chosen:
        if sorted(squares) != sorted(_resolved(steps, k, taken) for k in leaves):
            return ()
    return leaves


def _exists(steps: Sequence[Step], number: int, taken: dict[int, bool]) -> bool:
    """Whether a selection comes to a number where the tests come out so."""
    return steps[_resolved(steps, number, taken)].op is not Op.NOT_A_NUMBER


def _tests(steps: Sequence[Step], number: int) -> Iterator[int]:
    step = steps[number]
    if step.op is Op.SELECT:
        yield step.operands[0]
        for k in step.operands[1:]:
            yield from _tests(steps, k)


def _resolved(steps: Sequence[Step], number: int, taken: dict[int, bool]) -> int:
    """What a selection comes to where the tests come out so."""
    while steps[number].op is Op.SELECT:
        test, one, other = steps[number].operands
        number = one if taken[test] else other
    return number


def _squares(steps: Sequence[Step], number: int) -> list[int]:
    """The steps of which a step is the sum of squares; none if it is no such sum."""
    step = steps[number]
    if step.op is Op.MULTIPLY and step.operands[0] == step.operands[1]:
        return [step.operands[0]]
    if step.op is not Op.ADD:
        return []
    one, other = (_squares(steps, k) for k in step.operands)
    return [*one, *other] if one and other else []


def adds_up(steps: Sequence[Step], number: int) -> bool:
    """Whether a step is a sum of positive multiples of squares, which vanishes with what is squared and not before."""
    squared = _squared(steps, number)
    return bool(squared) and None not in squared


def _squared(steps: Sequence[Step], number: int) -> list[int | None]:
    """What is squared in a sum of positive multiples of squares, None for constants; nothing if it is no such sum."""
    step = steps[number]
    if step.op is Op.CONSTANT:
        return [None] if step.value > 0 else []
    if step.op is Op.MULTIPLY and step.operands[0] == step.operands[1]:
        return [step.operands[0]]
    if step.op is Op.MULTIPLY and steps[step.operands[0]].op is Op.CONSTANT and steps[step.operands[0]].value > 0:
        inner = _squared(steps, step.operands[1])
        return [] if None in inner else inner
    if step.op is not Op.ADD:
        return []
    one, other = (_squared(steps, k) for k in step.operands)
    return [*one, *other] if one and other else []
