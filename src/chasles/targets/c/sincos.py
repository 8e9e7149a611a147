"""Which sines and cosines can be computed first, for many items at once? Those of angles that need no other.

A program is cut in two: one that gives the angles, and one that takes their sines and cosines as further arguments.
Two tight loops keep the machine busier than one that does both: their chains of operations together are longer than
what it can look ahead.
"""

from __future__ import annotations

from dataclasses import dataclass
from dataclasses import replace as with_fields
from fractions import Fraction

from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Argument, Op, Program, Result, Step

CIRCULAR = (Op.SINE, Op.COSINE)
_LATE = (*CIRCULAR, Op.ARCTANGENT2)


@dataclass(frozen=True, slots=True)
class Parted:
    """A program cut in two.

    `angles` has a scalar result for each angle; `rest` has the arguments of the whole program, then the sine and the
    cosine of each angle in turn. Where no angle can go first `angles` is None and `rest` the whole program.
    """

    angles: Program | None
    rest: Program


def parted(program: Program) -> Parted:
    """The program in two parts that together compute the same."""
    program = pruned(program)
    waits = _waits(program)
    early = [number for number, step in enumerate(program.steps) if step.op in CIRCULAR and not waits[step.operands[0]]]
    places = {angle: k for k, angle in enumerate(dict.fromkeys(program.steps[number].operands[0] for number in early))}
    if not places:
        return Parted(None, program)
    words = _words(program, list(places))
    results = tuple(Result(word, (), "an angle", (angle,)) for word, angle in zip(words, places, strict=True))
    angles = pruned(Program(program.name, program.arguments, program.steps, results))
    steps = list(program.steps)
    for number in early:
        step = steps[number]
        further = 2 * places[step.operands[0]] + (step.op is Op.COSINE)
        steps[number] = Step(Op.INPUT, argument=len(program.arguments) + further)
    more = [Argument(f"{name}_{word}", (), f"the {name} of {word}") for word in words for name in ("sin", "cos")]
    return Parted(angles, pruned(with_fields(program, arguments=(*program.arguments, *more), steps=tuple(steps))))


def _waits(program: Program) -> list[bool]:
    """For each step whether a sine, a cosine or an arctangent is needed for it."""
    waits: list[bool] = []
    for step in program.steps:
        waits.append(step.op in _LATE or any(waits[operand] for operand in step.operands))
    return waits


def _words(program: Program, angles: list[int]) -> list[str]:
    """What each angle is called: phi, half_phi, else angle_1 and so on."""
    words: list[str] = []
    for count, angle in enumerate(angles, start=1):
        word = _word(program, angle)
        words.append(f"angle_{count}" if word is None or word in words else word)
    return words


def _word(program: Program, number: int) -> str | None:
    step = program.steps[number]
    if step.op is Op.INPUT:
        argument = program.arguments[step.argument]
        return f"{argument.name}_{step.entry}" if argument.shape else argument.name
    for half, whole in ((0, 1), (1, 0)):
        if step.op is Op.MULTIPLY and program.steps[step.operands[half]].value == Fraction(1, 2):
            inner = _word(program, step.operands[whole])
            return None if inner is None else f"half_{inner}"
    return None
