"""How is a long program computed? In parts, one after the other, that leave what others need in an array.

A compiler's time grows with the square of what it must keep in registers at once, and beyond some hundred steps a
register is of no use to what comes later. So parts are functions of their own, and operands are copied in loops.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from math import prod

from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Argument, Op, Program, Result, Step
from chasles.targets.kernel import TRUTH

KEPT = "kept"
_MOST_STEPS = 640
"""A program of at most so many steps and entries is not cut."""
_STEPS = 448
"""How many steps and entries a part has."""
_REPEATED = (Op.INPUT, Op.CONSTANT, Op.NOT_A_NUMBER, Op.NEGATE, *TRUTH)
"""What each part that needs it does itself."""
_Piece = tuple[list[int], list[tuple[int, int]]]
"""Steps, and the entries of results, counted through, with the steps that hold them."""


@dataclass(frozen=True, slots=True)
class CutFunction:
    """A piece of a program: its one argument is the array of what is kept, its one result goes to these slots of it."""

    program: Program
    slots: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class CutProgram:
    """A program in parts, none where it is short enough to stay whole.

    The array of what is kept has `room` numbers; at each of `places` the entries of an argument or result begin.
    """

    parts: tuple[CutFunction, ...] = ()
    places: tuple[int, ...] = ()
    room: int = 0


def parts_of(program: Program) -> CutProgram:
    """The program cut, where it is long."""
    program = pruned(program)
    if len(program.steps) + sum(len(result.entries) for result in program.results) <= _MOST_STEPS:
        return CutProgram()
    pieces = list(_pieces(program))
    home = {number: place for place, (steps, _) in enumerate(pieces) for number in steps}
    bodies = [_body(program, place, piece, home) for place, piece in enumerate(pieces)]
    *places, room = accumulate((prod(item.shape) for item in program.parameters), initial=0)
    slots, room = _slots(bodies, home, room)
    first = places[len(program.arguments)]
    parts = []
    for place, (body, (_, entries)) in enumerate(zip(bodies, pieces, strict=True)):
        read = {k: slots[k] for k in body if home.get(k, place) != place}
        kept = [(k, slots[k]) for k in body if home.get(k) == place and k in slots]
        kept += [(step, first + entry) for entry, step in entries]
        parts.append(_part(program, body, read, places, kept))
    return CutProgram(tuple(parts), tuple(places), room)


def _pieces(program: Program) -> Iterator[_Piece]:
    """The steps of each part that others do not repeat, and the entries that are known then and in no part before."""
    ready: list[int] = []
    for number, step in enumerate(program.steps):
        ready.append(max((ready[k] for k in step.operands), default=-1) if step.op in _REPEATED else number)
    due: dict[int, list[tuple[int, int]]] = {}
    for entry, number in enumerate(number for result in program.results for number in result.entries):
        due.setdefault(ready[number], []).append((entry, number))
    steps: list[int] = []
    entries: list[tuple[int, int]] = []
    for number in range(-1, len(program.steps)):
        if number >= 0 and program.steps[number].op not in _REPEATED:
            steps.append(number)
        for pair in due.get(number, ()):
            entries.append(pair)
            if len(steps) + len(entries) >= _STEPS:
                yield steps, entries
                steps, entries = [], []
        if len(steps) + len(entries) >= _STEPS:
            yield steps, entries
            steps, entries = [], []
    yield steps, entries


def _body(program: Program, place: int, piece: _Piece, home: Mapping[int, int]) -> tuple[int, ...]:
    """The steps that a part does or reads."""
    found: set[int] = set()
    waiting = [*piece[0], *(number for _, number in piece[1])]
    while waiting:
        number = waiting.pop()
        if number not in found:
            found.add(number)
            if home.get(number, place) == place:
                waiting += program.steps[number].operands
    return tuple(sorted(found))


def _slots(bodies: Sequence[tuple[int, ...]], home: Mapping[int, int], room: int) -> tuple[dict[int, int], int]:
    """Where, beyond the first `room`, each step that a later part reads is kept; the room of the dead is reused."""
    last = {number: place for place, body in enumerate(bodies) for number in body if home.get(number, place) != place}
    dying: dict[int, list[int]] = {}
    slots: dict[int, int] = {}
    free: list[int] = []
    for place, body in enumerate(bodies):
        for number in body:
            if number in last and home[number] == place:
                if not free:
                    free.append(room)
                    room += 1
                slots[number] = free.pop()
                dying.setdefault(last[number], []).append(slots[number])
        free += dying.get(place, ())
    return slots, room


def _part(
    program: Program,
    body: Sequence[int],
    read: Mapping[int, int],
    places: Sequence[int],
    kept: Sequence[tuple[int, int]],
) -> CutFunction:
    """The part of these steps, some of which are `read` from slots, and some `kept` in others."""
    new: dict[int, int] = {}
    steps: list[Step] = []
    for number in body:
        step = program.steps[number]
        new[number] = len(steps)
        if number in read or step.op is Op.INPUT:
            steps.append(Step(Op.INPUT, entry=read.get(number, places[step.argument] + step.entry)))
        else:
            steps.append(step.on(tuple(new[k] for k in step.operands)))
    size = max((step.entry for step in steps), default=0) + 1
    result = Result("stored", (len(kept),), "what is kept", tuple(new[number] for number, _ in kept))
    argument = Argument(KEPT, (size,), "what is kept")
    return CutFunction(Program(program.name, (argument,), tuple(steps), (result,)), tuple(slot for _, slot in kept))
