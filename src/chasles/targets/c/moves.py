"""How do the items of operands come to registers, and results to memory?

Items whose numbers lie one after the other are loaded by several numbers at a time and transposed; where each number of
all items lies side by side, as in Fortran order, it is a register's load; whatever lies otherwise a function takes.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence

from chasles.lowering.program import Argument, Op, Program, Result
from chasles.targets.c.vectorised import register, spread
from chasles.targets.constants import Precision
from chasles.targets.layout import listed

_WIDTHS = (4, 3, 2, 1)
"""How many numbers that lie side by side in an item are loaded or stored at a time."""


def operands(parameters: Sequence[Argument | Result], places: Collection[int], precision: Precision) -> Iterator[str]:
    """What is known of operands before their items are moved: `at`, `step`, and if `dense`, or else the `entries`."""
    size = f"sizeof({precision.name})"
    for place in places:
        shape, first = parameters[place].shape, len(parameters) + 2 * place
        count = math.prod(shape)
        yield f"char *const at{place} = at[{place}];"
        yield f"const ptrdiff_t step{place} = CHASLES_STEP({place}, {count} * {size});"
        if shape:
            where = f"{count}, {shape[-1]}, {size}, step{place}, steps + {first}"
            yield f"ptrdiff_t entries{place}[{count}];"
            yield f"const int dense{place} = CHASLES_DENSE(find_entries({where}, entries{place}));"


def packed(parameters: Sequence[Argument | Result], precision: Precision) -> Iterator[str]:
    """The question of each operand whether its items are row-major without gaps, one after the other."""
    for place, item in enumerate(parameters):
        columns = item.shape[-1] if item.shape else 1
        core = f"steps + {len(parameters) + 2 * place}"
        yield f"is_packed({math.prod(item.shape)}, {columns}, sizeof({precision.name}), steps[{place}], {core})"


def loads(place: int, shape: tuple[int, ...], name: str, wanted: Sequence[int], precision: Precision) -> Iterator[str]:
    """The entries that are wanted of an operand's items, as registers of that name."""
    suffix, size = precision.suffix, math.prod(shape)
    yield f"{register(precision)} {name}{f'[{size}]' if shape else ''};"
    yield _item(place, "const char", precision)
    yield f"prefetch(item{place}, {size}, copied.ahead);"
    if not shape:
        yield f"load_1{suffix}(item{place}, step{place}, &{name});"
        return
    yield f"if (dense{place}) {{"
    for number, count in _runs(wanted):
        entry = wanted[number]
        width = 4 if count == 3 and entry + 4 <= size else count  # a fourth comes at no cost
        at = f"item{place} + {entry} * sizeof({precision.name})"
        yield f"    load_{width}{suffix}({at}, step{place}, &{name}[{entry}]);"
    yield f"}} else if (step{place} == sizeof({precision.name})) {{"
    for entry in wanted:
        at = f"item{place} + entries{place}[{entry}]"
        yield f"    {name}[{entry}] = PACKED{suffix.upper()}_IN({at}, 0);"
    yield "} else {"
    yield f"    {register(precision)} all[{size}];"
    yield f"    take_each{suffix}(item{place}, entries{place}, step{place}, {size}, all);"
    for entry in wanted:
        yield f"    {name}[{entry}] = all[{entry}];"
    yield "}"


def stores(place: int, shape: tuple[int, ...], entries: Sequence[str], precision: Precision) -> Iterator[str]:
    """The entries of a result, once all of them are known."""
    suffix, values = precision.suffix, [spread(value, precision) for value in entries]
    yield _item(place, "char", precision)
    yield f"prefetch_to_write(item{place}, step{place}, {len(entries)}, sizeof({precision.name}), copied.ahead);"
    if not shape:
        yield from listed(f"store_1{suffix}(item{place}, step{place}, ", values, ");")
        return
    yield from listed(f"const {register(precision)} result{place}[] = {{", values, "};")
    yield f"if (dense{place}) {{"
    yield f"    store_all{suffix}(item{place}, step{place}, {len(entries)}, result{place});"
    yield f"}} else if (step{place} == sizeof({precision.name})) {{"
    for entry in range(len(entries)):
        yield f"    PACKED{suffix.upper()}(item{place} + entries{place}[{entry}], 0) = result{place}[{entry}];"
    yield "} else {"
    yield f"    give_each{suffix}(item{place}, entries{place}, step{place}, {len(entries)}, result{place});"
    yield "}"


def copies(place: int, shape: tuple[int, ...], kept: str, precision: Precision, *, back: bool) -> Iterator[str]:
    """Loops that load all entries of an operand's items to registers in memory, or that store them from there."""
    suffix, size = precision.suffix, math.prod(shape)
    yield _item(place, "char" if back else "const char", precision)
    if not shape:
        call, number = ("store", f"*({kept})") if back else ("load", kept)
        yield f"{call}_1{suffix}(item{place}, step{place}, {number});"
        return
    yield f"if (dense{place}) {{"
    for begin, width, count in ((0, 4, size // 4), (size - size % 4, size % 4, min(size % 4, 1))):
        if count:
            at = f"item{place} + k * sizeof({precision.name}), step{place}"
            numbers = ", ".join(f"({kept})[k + {n}]" for n in range(width)) if back else f"{kept} + k"
            yield f"    for (ptrdiff_t k = {begin}; k < {begin + count * width}; k += {width}) {{"
            yield f"        {'store' if back else 'load'}_{width}{suffix}({at}, {numbers});"
            yield "    }"
    yield "} else {"
    verb = "give" if back else "take"
    yield f"    {verb}_each{suffix}(item{place}, entries{place}, step{place}, {size}, {kept});"
    yield "}"


def read(program: Program) -> frozenset[tuple[int, int]]:
    """The arguments and entries that the program reads."""
    return frozenset((step.argument, step.entry) for step in program.steps if step.op is Op.INPUT)


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
