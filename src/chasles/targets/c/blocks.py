"""Which C function computes a block of items? Loads, the program on registers, stores; sines and cosines go first."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from dataclasses import replace as with_fields

from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Op, Program
from chasles.targets.c.functions import public_name
from chasles.targets.c.sincos import parted
from chasles.targets.c.vectorised import ON_REGISTERS, register, spread
from chasles.targets.constants import Precision
from chasles.targets.kernel import EmissionError, TargetKernel
from chasles.targets.layout import listed
from chasles.targets.spelling import Spelled, spelled

__all__ = ["MOST_OPERANDS", "BlockFunction", "block", "block_name", "loop_name"]

MOST_OPERANDS = 16
_MOST_ENTRIES = 512
"""So that a group of items of every level fits into the store where items are gathered."""
_WIDTHS = (4, 3, 2, 1)
"""How many numbers that lie side by side in an item are loaded or stored at a time."""


@dataclass(frozen=True, slots=True)
class BlockFunction:
    """A block function: its prototype, its lines on registers, and those that call the scalar kernel."""

    prototype: str
    vector: tuple[str, ...]
    scalar: tuple[str, ...]


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
    if len(operands) > MOST_OPERANDS or entries > _MOST_ENTRIES:
        raise EmissionError(
            f"{kernel.name} has {len(operands)} operands with {entries} entries; a batch takes at most "
            f"{MOST_OPERANDS} with {_MOST_ENTRIES}: split the kernel"
        )
    parameters = ("ptrdiff_t groups", "char *const *at", "const ptrdiff_t *steps", "const chasles_stream *stream")
    prototype = "\n".join(listed(f"void CHASLES_LEVELED({block_name(kernel, precision)})(", parameters, ")"))
    return BlockFunction(prototype, tuple(_on_registers(kernel, precision)), _one_by_one(kernel, precision))


def _on_registers(kernel: TargetKernel, precision: Precision) -> Iterator[str]:
    parts, inputs = parted(kernel.program), len(kernel.program.arguments)
    read = {place for place, _ in _read(pruned(kernel.program))}
    for place in range(len(kernel.program.parameters)):
        if place < inputs and place not in read:
            continue
        yield f"char *const at{place} = at[{place}];"
        size = math.prod(kernel.program.parameters[place].shape)
        yield f"const ptrdiff_t step{place} = CHASLES_STEP({place}, {size} * sizeof({precision.name}));"
    yield "chasles_stream copied = *stream;"
    if parts.angles is not None:
        yield from _sines_and_cosines(parts.angles, precision)
    text = spelled(parts.rest, ON_REGISTERS[precision])
    yield "for (ptrdiff_t g = 0; g < groups; g++) {"
    yield from _indented(_loads(parts.rest, text, inputs, precision))
    for place, name in enumerate(text.arguments[inputs:]):
        room = ("sines", "cosines")[place % 2]
        if (inputs + place, 0) in _read(parts.rest):
            yield f"    const {register(precision)} {name} = {room}[{place // 2}][g];"
    yield from _indented(text.lines)
    yield from _indented(_stores(parts.rest, text, inputs, precision))
    yield "    stream_lines(&copied);"
    yield "}"


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
        wanted = [(place, entry) in read for entry in range(size)]
        if not any(wanted):
            continue
        yield f"{register(precision)} {name}{f'[{size}]' if item.shape else ''};"
        yield _item(place, "const char", precision)
        yield f"prefetch(item{place}, LANES{precision.suffix.upper()} * step{place});"
        for entry, width in _runs(wanted):
            target = name if item.shape and not entry else f"&{name}[{entry}]" if item.shape else f"&{name}"
            yield f"load_{width}{precision.suffix}({_place(place, entry, precision)}, step{place}, {target});"


def _stores(program: Program, text: Spelled, inputs: int, precision: Precision) -> Iterator[str]:
    """The results, once all of them are known."""
    for place, entries in enumerate(text.entries, start=inputs):
        yield _item(place, "char", precision)
        yield f"prefetch_to_write(item{place}, LANES{precision.suffix.upper()} * step{place});"
        for entry, width in _runs([True] * len(entries)):
            values = [spread(value, precision) for value in entries[entry : entry + width]]
            start = f"store_{width}{precision.suffix}("
            yield from listed(start, [_place(place, entry, precision), f"step{place}", *values], ");")


def _item(place: int, kind: str, precision: Precision) -> str:
    """Where the first item of a group lies."""
    return f"{kind} *const item{place} = at{place} + g * LANES{precision.suffix.upper()} * step{place};"


def _place(place: int, entry: int, precision: Precision) -> str:
    """Where an entry of the item at hand lies."""
    return f"item{place} + {entry} * sizeof({precision.name})" if entry else f"item{place}"


def _runs(wanted: Sequence[bool]) -> Iterator[tuple[int, int]]:
    """Where to start and how many to take at a time, so that all that is wanted is taken and nothing else."""
    entry = 0
    while entry < len(wanted):
        widths = [width for width in _WIDTHS if list(wanted[entry : entry + width]) == [True] * width]
        if widths:
            yield entry, widths[0]
        entry += widths[0] if widths else 1


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
