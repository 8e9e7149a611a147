"""Which C functions does a kernel become? For either precision one that takes an item and one that takes a batch."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from chasles.lowering.names import Names
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Argument, Op, Result
from chasles.targets.c.language import DIALECTS, RESERVED
from chasles.targets.constants import DOUBLE, SINGLE, Precision
from chasles.targets.contract import cited, contract, summary
from chasles.targets.dialect import Dialect
from chasles.targets.kernel import TargetKernel
from chasles.targets.layout import listed
from chasles.targets.spelling import Spelled, spelled

PRECISIONS = (DOUBLE, SINGLE)


def precisions_of(kernel: TargetKernel) -> tuple[Precision, ...]:
    """Those that hold all of the kernel's constants: double, and single precision unless one is out of its range."""
    constants = [step.value for step in kernel.program.steps if step.op is Op.CONSTANT]
    return PRECISIONS if all(map(SINGLE.holds, constants)) else (DOUBLE,)


@dataclass(frozen=True, slots=True)
class Function:
    """A C function as the templates lay it out: `comment` and `lines` line by line, the prototype without its end."""

    name: str
    comment: tuple[str, ...]
    prototype: str
    lines: tuple[str, ...]


def public_name(kernel: TargetKernel, precision: Precision, variant: str = "") -> str:
    """The name in the header: chasles_NAME, chasles_NAMEf, chasles_NAME_batch, chasles_NAME_batchf."""
    return f"chasles_{kernel.name}{variant}{precision.suffix}"


def single(kernel: TargetKernel, precision: Precision, dialects: Mapping[Precision, Dialect] = DIALECTS) -> Function:
    """The function that computes one item and stores it once all of it is known."""
    program = kernel.program
    text = spelled(program, dialects[precision])
    name = public_name(kernel, precision)
    inputs = [_input(word, item, precision) for word, item in zip(text.arguments, program.arguments, strict=True)]
    outputs = [_output(word, item, precision) for word, item in zip(text.results, program.results, strict=True)]
    stores = [
        f"{word}[{position}] = {entry};" if item.shape else f"*{word} = {entry};"
        for word, item, entries in zip(text.results, program.results, text.entries, strict=True)
        for position, entry in enumerate(entries)
    ]
    lines = (*unread(kernel, text.arguments), *text.lines, *stores)
    comment = head(kernel, text, public_name(kernel, DOUBLE) if precision is SINGLE else "")
    return Function(name, comment, _prototype(name, [*inputs, *outputs]), lines)


def head(kernel: TargetKernel, text: Spelled, main: str = "") -> tuple[str, ...]:
    """The lines of a comment: the whole contract, or that it is the `main` function in single precision."""
    if main:
        return _comment(summary(kernel, f"{main} in single precision."))
    program = kernel.program
    given = [_shown(word, item) for word, item in zip(text.arguments, program.arguments, strict=True)]
    returned = [_shown(word, item) for word, item in zip(text.results, program.results, strict=True)]
    return _comment(contract(kernel, given, returned))


def unread(kernel: TargetKernel, words: Sequence[str], statement: str = "(void){};") -> tuple[str, ...]:
    """Statements that say of each argument that nothing reads that this is meant."""
    read = {step.argument for step in pruned(kernel.program).steps if step.op is Op.INPUT}
    return tuple(statement.format(word) for place, word in enumerate(words) if place not in read)


def in_short(kernel: TargetKernel) -> str:
    """One line: the equation, the shapes of what goes in and comes out, and the file with the whole contract."""
    names, program = Names(RESERVED), kernel.program
    words = [_shown(names.take(item.name), item) for item in program.parameters]
    given, returned = (", ".join(part) for part in (words[: len(program.arguments)], words[len(program.arguments) :]))
    (line,) = _comment([f"{cited(kernel.heading.number)} {given} -> {returned}; src/{kernel.heading.section}.c"])
    return line


def batch(kernel: TargetKernel, precision: Precision) -> Function:
    """The function that computes `count` items, each input and output with a step of its own."""
    program = kernel.program
    names = Names(RESERVED | {"loop", "size"})
    words = [names.take(item.name) for item in program.parameters]
    count, at, moves = names.take("count"), names.take("at"), names.take("moves")
    steps = [names.take(f"{word}_step") for word in words]
    parameters = [f"size_t {count}"]
    for position, (word, step) in enumerate(zip(words, steps, strict=True)):
        is_input = position < len(program.arguments)
        parameters.append(f"{'const ' if is_input else ''}{precision.name} *{word}, ptrdiff_t {step}")
    name = public_name(kernel, precision, "_batch")
    lines = (
        *listed(f"char *const {at}[] = {{", [f"(char *){word}" for word in words], "};"),
        f"const ptrdiff_t size = (ptrdiff_t)sizeof({precision.name});",
        *listed(f"const ptrdiff_t {moves}[] = {{", [f"{step} * size" for step in steps], "};"),
        f"const chasles_loop *loop = &{public_name(kernel, precision, '_loop')};",
        f"chasles_run(loop, chasles_best_level(), (ptrdiff_t){count}, {at}, {moves}, NULL);",
    )
    comment = _comment(summary(kernel, f"{public_name(kernel, precision)} for a batch."))
    return Function(name, comment, _prototype(name, parameters), lines)


def _input(word: str, item: Argument, precision: Precision) -> str:
    return f"const {precision.name} {_shown(word, item)}" if item.shape else f"{precision.name} {word}"


def _output(word: str, item: Result, precision: Precision) -> str:
    return f"{precision.name} {_shown(word, item)}" if item.shape else f"{precision.name} *{word}"


def _shown(word: str, item: Argument | Result) -> str:
    """The name with its size, as in a declaration."""
    return f"{word}[{math.prod(item.shape)}]" if item.shape else word


def _prototype(name: str, parameters: Sequence[str]) -> str:
    return "\n".join(listed(f"void {name}(", parameters, ")"))


def _comment(lines: Sequence[str]) -> tuple[str, ...]:
    """The lines of a comment, none of which ends it or begins another."""
    return tuple(line.replace("*/", "* /").replace("/*", "/ *") for line in lines)
