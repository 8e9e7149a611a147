"""Which C function computes a block of items? Loads, the program on registers, stores; sines and cosines go first."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from dataclasses import replace as with_fields

from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import MOST_ENTRIES, MOST_OPERANDS, Op, Program
from chasles.targets.c.functions import public_name
from chasles.targets.c.parts import KEPT, CutFunction, CutProgram, parts_of
from chasles.targets.c.sincos import parted
from chasles.targets.c.vectorised import ON_REGISTERS, register, spread
from chasles.targets.constants import Precision
from chasles.targets.kernel import EmissionError, TargetKernel
from chasles.targets.layout import listed
from chasles.targets.spelling import Spelled, spelled

_WORD = re.compile(r"\w+")
_WIDTHS = (4, 3, 2, 1)
"""How many numbers that lie side by side in an item are loaded or stored at a time."""


@dataclass(frozen=True, slots=True)
class BlockFunction:
    """A block function: its prototype, its lines on registers, and those that call the scalar kernel.

    `parts` are the functions that those on registers call, where they are many, with `void` before each.
    """

    prototype: str
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
    operands = kernel.program.parameters
    entries = sum(math.prod(item.shape) for item in operands)
    if len(operands) > MOST_OPERANDS or entries > MOST_ENTRIES:
        raise EmissionError(
            f"{kernel.name} has {len(operands)} operands with {entries} entries; a batch takes at most "
            f"{MOST_OPERANDS} with {MOST_ENTRIES}: split the kernel"
        )
    parameters = ("ptrdiff_t groups", "char *const *at", "const ptrdiff_t *steps", "const chasles_stream *stream")
    prototype = "\n".join(listed(f"void CHASLES_LEVELED({block_name(kernel, precision)})(", parameters, ")"))
    scalar = _one_by_one(kernel, precision)
    parts = parts_of(kernel.program)
    if not parts.parts:
        return BlockFunction(prototype, tuple(_on_registers(kernel.program, precision)), scalar)
    names = [f"{block_name(kernel, precision)}_part_{number}" for number, _ in enumerate(parts.parts, start=1)]
    functions = [
        (f"{name}({register(precision)} *{KEPT})", "{", *_indented(_part(part, precision)), "}")
        for name, part in zip(names, parts.parts, strict=True)
    ]
    lines = [
        "(void)stream;",
        f"{register(precision)} {KEPT}[{parts.room}];",
        "for (ptrdiff_t g = 0; g < groups; g++) {",
        *_indented(_copied(kernel.program, parts, precision, [f"{name}({KEPT});" for name in names])),
        "}",
    ]
    return BlockFunction(prototype, tuple(lines), scalar, tuple(functions))


def _on_registers(program: Program, precision: Precision) -> Iterator[str]:
    parts, inputs = parted(program), len(program.arguments)
    read = {place for place, _ in _read(pruned(program))}
    for place in range(len(program.parameters)):
        if place < inputs and place not in read:
            continue
        yield f"char *const at{place} = at[{place}];"
        shape, first = program.parameters[place].shape, len(program.parameters) + 2 * place
        said = [("step", place, math.prod(shape))]
        if shape:
            said += [("down", first, shape[-1]), ("across", first + 1, 1)]
        for name, k, numbers in said:
            yield f"const ptrdiff_t {name}{place} = CHASLES_STEP({k}, {numbers} * sizeof({precision.name}));"
    yield "chasles_stream copied = *stream;"
    if parts.angles is not None:
        yield from _sines_and_cosines(parts.angles, precision)
    text = spelled(parts.rest, ON_REGISTERS[precision])
    yield "for (ptrdiff_t g = 0; g < groups; g++) {"
    yield from _indented(_loads(parts.rest, text, inputs, precision))
    yield from _indented(_taken(parts.rest, text, inputs, precision, "g"))
    yield from _indented(text.lines)
    for place, entries in enumerate(text.entries, start=inputs):
        yield f"    {_item(place, 'char', precision)}"
        yield f"    prefetch_to_write(item{place}, {len(entries)});"
        yield from _indented(_stores(place, program.parameters[place].shape, entries, precision))
    yield "    stream_lines(&copied);"
    yield "}"


def _copied(program: Program, parts: CutProgram, precision: Precision, calls: Sequence[str]) -> Iterator[str]:
    """The calls, between loops that load all entries of the inputs and store those of the results."""
    suffix, inputs = precision.suffix, len(program.arguments)
    lanes = f"LANES{suffix.upper()}"
    for place, (item, start) in enumerate(zip(program.parameters, parts.places, strict=True)):
        size, loads = math.prod(item.shape), place < inputs
        if place == inputs:
            yield from calls
        kind, verb = ("const char", "take") if loads else ("char", "give")
        yield f"{kind} *const item{place} = at[{place}] + g * {lanes} * steps[{place}];"
        if not item.shape:
            call, number = ("load_1", f"{KEPT} + {start}") if loads else ("store_1", f"{KEPT}[{start}]")
            yield f"{call}{suffix}(item{place}, steps[{place}], {number});"
            continue
        down = len(program.parameters) + 2 * place
        where = f"item{place}, k, {item.shape[-1]}, steps[{down}], steps[{down + 1}], steps[{place}]"
        for first, width, count in ((0, 4, size // 4), (size - size % 4, size % 4, min(size % 4, 1))):
            if count:
                yield f"for (ptrdiff_t k = {first}; k < {first + count * width}; k += {width}) {{"
                numbers = ", ".join(f"{KEPT}[{start + n} + k]" for n in range(width))
                yield f"    {verb}_{width}{suffix}({where}, {f'{KEPT} + {start} + k' if loads else numbers});"
                yield "}"


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
        yield "chasles_stream none = {0, 0, 0, 0};"
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


def _loads(program: Program, text: Spelled, inputs: int, precision: Precision) -> Iterator[str]:
    """The entries that the program reads of its first arguments."""
    read = _read(program)
    for place, (name, item) in enumerate(zip(text.arguments[:inputs], program.arguments, strict=False)):
        size = math.prod(item.shape)
        wanted = [entry for entry in range(size) if (place, entry) in read]
        if not wanted:
            continue
        yield f"{register(precision)} {name}{f'[{size}]' if item.shape else ''};"
        yield _item(place, "const char", precision)
        yield f"prefetch(item{place}, {size});"
        for number, width in _runs(wanted):
            entry = wanted[number]
            target = name if item.shape and not entry else f"&{name}[{entry}]" if item.shape else f"&{name}"
            yield f"{_moved('take', 'load', width, place, entry, item.shape, precision)}, {target});"


def _taken(program: Program, text: Spelled, further: int, precision: Precision, group: str) -> Iterator[str]:
    """The sines and cosines that the program reads, which are its further arguments, of a group."""
    read = _read(program)
    for place, name in enumerate(text.arguments[further:]):
        if (further + place, 0) in read:
            room = ("sines", "cosines")[place % 2]
            yield f"const {register(precision)} {name} = {room}[{place // 2}][{group}];"


def _stores(place: int, shape: tuple[int, ...], entries: Sequence[str], precision: Precision) -> Iterator[str]:
    """The entries of a result, once all of them are known."""
    for entry, width in _runs(range(len(entries))):
        values = [spread(value, precision) for value in entries[entry : entry + width]]
        start = _moved("give", "store", width, place, entry, shape, precision)
        yield from listed(f"{start}, ", values, ");")


def _moved(
    several: str, alone: str, width: int, place: int, entry: int, shape: tuple[int, ...], precision: Precision
) -> str:
    """The call that moves some entries of the item at hand, up to the numbers: it says where these lie in each item."""
    if not shape:
        return f"{alone}_1{precision.suffix}(item{place}, step{place}"
    where = f"item{place}, {entry}, {shape[-1]}, down{place}, across{place}, step{place}"
    return f"{several}_{width}{precision.suffix}({where}"


def _item(place: int, kind: str, precision: Precision) -> str:
    """Where the first item of a group lies."""
    return f"{kind} *const item{place} = at{place} + g * LANES{precision.suffix.upper()} * step{place};"


def _runs(entries: Sequence[int]) -> Iterator[tuple[int, int]]:
    """Where among ascending entries to start and how many to take at a time, so that these lie side by side."""
    start = 0
    while start < len(entries):
        rest = entries[start : start + _WIDTHS[0]]
        width = next(width for width in _WIDTHS if width <= len(rest) and rest[width - 1] == rest[0] + width - 1)
        yield start, width
        start += width


def _read(program: Program) -> frozenset[tuple[int, int]]:
    """The arguments and entries that the program reads."""
    return frozenset((step.argument, step.entry) for step in program.steps if step.op is Op.INPUT)


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
