"""Which C function computes a block of items? Loads, the program on registers, stores; sines and cosines go first."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from dataclasses import replace as with_fields

from chasles.lowering.cost import cost
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import MOST_ENTRIES, MOST_OPERANDS, Program
from chasles.targets.c.functions import public_name
from chasles.targets.c.moves import copies, loads, operands, packed, read, stores
from chasles.targets.c.parts import KEPT, CutFunction, CutProgram, parts_of
from chasles.targets.c.sincos import parted
from chasles.targets.c.vectorised import ON_REGISTERS, register, spread
from chasles.targets.constants import Precision
from chasles.targets.kernel import EmissionError, TargetKernel
from chasles.targets.layout import listed
from chasles.targets.spelling import Spelled, spelled

_WORD = re.compile(r"\w+")
_MOST_COST = 4
"""Where a number that is moved goes with more arithmetic than so many additions, its move costs little beside it."""
_MOST_MOVED = 64
"""Of larger items known steps were measured to gain nothing, and compiling twice takes longer."""


@dataclass(frozen=True, slots=True)
class BlockFunction:
    """A block function: its name without a level, its lines on registers, and those that call the scalar kernel.

    `parts` are the functions that those on registers call, where they are many, with `void` before each. `choice` runs
    the lines as they are compiled for items that are packed, or for others.
    """

    name: str
    choice: tuple[str, ...]
    vector: tuple[str, ...]
    scalar: tuple[str, ...]
    parts: tuple[tuple[str, ...], ...] = ()


def loop_name(kernel: TargetKernel, precision: Precision) -> str:
    """The name of the constant that describes a kernel in one precision."""
    return public_name(kernel, precision, "_loop")


def block_name(kernel: TargetKernel, precision: Precision) -> str:
    """The name of the block function, to which the level's is appended."""
    return public_name(kernel, precision, "_block")


def block(kernel: TargetKernel, precision: Precision) -> BlockFunction:
    """The block function of the kernel. Raises EmissionError for more operands or entries than a batch can have."""
    parameters = kernel.program.parameters
    entries = sum(math.prod(item.shape) for item in parameters)
    if len(parameters) > MOST_OPERANDS or entries > MOST_ENTRIES:
        raise EmissionError(
            f"{kernel.name} has {len(parameters)} operands with {entries} entries; a batch takes at most "
            f"{MOST_OPERANDS} with {MOST_ENTRIES}: split the kernel"
        )
    name = block_name(kernel, precision)
    scalar = _one_by_one(kernel, precision)
    parts = parts_of(kernel.program)
    if not parts.parts:
        looks = entries <= _MOST_MOVED and cost(kernel.program) <= _MOST_COST * entries
        choice = _choice(name, packed(parameters, precision) if looks else ())
        return BlockFunction(name, choice, tuple(_on_registers(kernel.program, precision)), scalar)
    names = [f"{name}_part_{number}" for number, _ in enumerate(parts.parts, start=1)]
    functions = [
        (f"{each}({register(precision)} *{KEPT})", "{", *_indented(_part(part, precision)), "}")
        for each, part in zip(names, parts.parts, strict=True)
    ]
    lines = [
        "(void)stream;",
        f"{register(precision)} {KEPT}[{parts.room}];",
        *operands(parameters, range(len(parameters)), precision),
        "for (ptrdiff_t g = 0; g < groups; g++) {",
        *_indented(_copied(kernel.program, parts, precision, [f"{each}({KEPT});" for each in names])),
        "}",
    ]
    return BlockFunction(name, _choice(name, ()), tuple(lines), scalar, tuple(functions))


def _choice(name: str, questions: Iterable[str]) -> tuple[str, ...]:
    """The call of the lines; where there are questions and the answers are yes, of those compiled for packed items."""
    call = f"{name}_items(groups, at, steps, stream, "
    look = [f"    && {question}" for question in questions]
    known = ("if (CHASLES_LOOKS", *look[:-1], f"{look[-1]}) {{", f"    {call}1);", "    return;", "}") if look else ()
    return (*known, f"{call}CHASLES_PACKED);")


def _on_registers(program: Program, precision: Precision) -> Iterator[str]:
    parts, inputs = parted(program), len(program.arguments)
    taken = {place for place, _ in read(pruned(program))}
    places = [place for place in range(len(program.parameters)) if place >= inputs or place in taken]
    yield from operands(program.parameters, places, precision)
    yield "chasles_stream copied = *stream;"
    if parts.angles is not None:
        yield from _sines_and_cosines(parts.angles, precision)
    text = spelled(parts.rest, ON_REGISTERS[precision])
    yield "for (ptrdiff_t g = 0; g < groups; g++) {"
    yield from _indented(_loads(parts.rest, text, inputs, precision))
    yield from _indented(_taken(parts.rest, text, inputs, precision, "g"))
    yield from _indented(text.lines)
    for place, entries in enumerate(text.entries, start=inputs):
        yield from _indented(stores(place, program.parameters[place].shape, entries, precision))
    yield "    stream_lines(&copied);"
    yield "}"


def _copied(program: Program, parts: CutProgram, precision: Precision, calls: Sequence[str]) -> Iterator[str]:
    """The calls, between loops that load all entries of the inputs and store those of the results."""
    inputs = len(program.arguments)
    for place, (item, start) in enumerate(zip(program.parameters, parts.places, strict=True)):
        if place == inputs:
            yield from calls
        yield from copies(place, item.shape, f"{KEPT} + {start}", precision, back=place >= inputs)


def _loads(program: Program, text: Spelled, inputs: int, precision: Precision) -> Iterator[str]:
    """The entries that the program reads of its first arguments."""
    taken = read(program)
    for place, (name, item) in enumerate(zip(text.arguments[:inputs], program.arguments, strict=False)):
        wanted = [entry for entry in range(math.prod(item.shape)) if (place, entry) in taken]
        if wanted:
            yield from loads(place, item.shape, name, wanted, precision)


def _part(part: CutFunction, precision: Precision) -> Iterator[str]:
    """A part of a program; its angles come first. What is known is stored at once, so that few registers are needed."""
    suffix, kind = precision.suffix, register(precision)
    dialect = with_fields(ON_REGISTERS[precision], name_entries=False)
    parts = parted(part.program)
    if parts.angles is not None:
        count = len(parts.angles.results)
        yield f"{kind} angles[{count}][1], sines[{count}][1], cosines[{count}][1];"
        text = spelled(parts.angles, dialect)
        yield "{"
        yield from _indented(_interleaved(text, [f"angles[{place}][0]" for place in range(count)], precision))
        yield "}"
        yield "chasles_stream none = {0, 0, 0, 0, 0};"
        yield f"CHASLES_LEVELED(chasles_sincos{suffix})({count}, angles[0], sines[0], cosines[0], &none);"
    text = spelled(parts.rest, dialect)
    yield from _taken(parts.rest, text, 1, precision, "0")
    yield from _interleaved(text, [f"{KEPT}[{slot}]" for slot in part.slots], precision)


def _interleaved(text: Spelled, targets: Sequence[str], precision: Precision) -> Iterator[str]:
    """The declarations, and behind the last one that an entry needs that it goes to its target."""
    known = {line.split(" = ")[0].split()[-1]: number for number, line in enumerate(text.lines)}
    due: dict[int, list[str]] = {}
    for target, entry in zip(targets, (entry for entries in text.entries for entry in entries), strict=True):
        last = max((known.get(word, -1) for word in _WORD.findall(entry)), default=-1)
        due.setdefault(last, []).append(f"{target} = {spread(entry, precision)};")
    yield from due.get(-1, ())
    for number, line in enumerate(text.lines):
        yield from (line, *due.get(number, ()))


def _sines_and_cosines(angles: Program, precision: Precision) -> Iterator[str]:
    """The angles of all items, then their sines and cosines."""
    kind, suffix, count = register(precision), precision.suffix, len(angles.results)
    for name in ("angles", "sines", "cosines"):
        yield f"{kind} {name}[{count}][GROUPS{suffix.upper()}];"
    text = spelled(angles, with_fields(ON_REGISTERS[precision], name_entries=False))
    yield "for (ptrdiff_t g = 0; g < groups; g++) {"
    yield from _indented(_loads(angles, text, len(angles.arguments), precision))
    yield from _indented(text.lines)
    for place, (entry,) in enumerate(text.entries):
        yield f"    angles[{place}][g] = {spread(entry, precision)};"
    yield "}"
    yield f"copied.share = (copied.share + {count}) / {count + 1};"
    for place in range(count):
        rooms = ", ".join(f"{name}[{place}]" for name in ("angles", "sines", "cosines"))
        yield f"CHASLES_LEVELED(chasles_sincos{suffix})(groups, {rooms}, &copied);"


def _taken(program: Program, text: Spelled, further: int, precision: Precision, group: str) -> Iterator[str]:
    """The sines and cosines that the program reads, which are its further arguments, of a group."""
    taken = read(program)
    for place, name in enumerate(text.arguments[further:]):
        if (further + place, 0) in taken:
            room = ("sines", "cosines")[place % 2]
            yield f"const {register(precision)} {name} = {room}[{place // 2}][{group}];"


def _one_by_one(kernel: TargetKernel, precision: Precision) -> tuple[str, ...]:
    """The call of the scalar kernel for item i."""
    passed = []
    inputs = len(kernel.program.arguments)
    for place, item in enumerate(kernel.program.parameters):
        pointer = f"({'const ' if place < inputs else ''}{precision.name} *)(at[{place}] + i * steps[{place}])"
        passed.append(pointer if item.shape or place >= inputs else f"*{pointer}")
    return listed(f"{public_name(kernel, precision)}(", passed, ");")


def _indented(lines: Iterable[str]) -> Iterator[str]:
    for line in lines:
        yield from (f"    {part}" for part in line.split("\n"))
