"""What does the C self-test compare? Every exact vector of a kernel, in both precisions, alone and in a batch."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from chasles.lowering.names import Names
from chasles.targets.c.functions import PRECISIONS, public_name
from chasles.targets.c.language import RESERVED
from chasles.targets.constants import DOUBLE, Precision, literal
from chasles.targets.kernel import Check, Exact, TargetKernel
from chasles.targets.layout import listed

_BATCH = 11
"""How many times a vector stands in its batch: whole groups and a rest, in either precision at every level."""
_EPSILON = {"double": "DBL_EPSILON", "float": "FLT_EPSILON"}


@dataclass(frozen=True, slots=True)
class OutputCheck:
    """One output of a vector: what it is called, how many entries it has, and where they are."""

    what: str
    compare: str
    size: int
    got: str
    expected: str
    tolerance: str


@dataclass(frozen=True, slots=True)
class Vector:
    """A C function that calls a kernel, for one item and for a batch of them, and compares what it gives."""

    function: str
    lines: tuple[str, ...]
    comparisons: tuple[OutputCheck, ...]


def vectors(kernel: TargetKernel) -> Iterator[Vector]:
    """The vectors of the kernel, by precision and in their order."""
    for precision in PRECISIONS:
        for number, check in enumerate(kernel.checks, start=1):
            yield _vector(kernel, check, precision, number)


def _vector(kernel: TargetKernel, check: Check, precision: Precision, number: int) -> Vector:
    program, names = kernel.program, Names(RESERVED)
    lines: list[str] = []
    passed, steps, comparisons = [], [], []
    for argument, entries in zip(program.arguments, check.inputs, strict=True):
        word = names.take(argument.name)
        passed.append(word if argument.shape else f"{word}[0]")
        steps.append(f"{word}, 0")
        lines += _array(precision, word, entries)
    function = public_name(kernel, precision)
    for result, entries in zip(program.results, check.outputs, strict=True):
        word = names.take(result.name)
        expected, all_, size = names.take(f"{word}_expected"), names.take(f"{word}_batch"), len(entries)
        passed.append(word)
        steps.append(f"{all_}, {size}")
        lines += [*_array(DOUBLE, expected, entries), f"{precision.name} {word}[{size}], {all_}[{_BATCH * size}];"]
        tolerance = f"{check.tolerance}.0 * {_EPSILON[precision.name]}"
        compare = f"compare{precision.suffix}"
        for said, got in (("", word), (", first of a batch", all_), (", last", f"{all_} + {(_BATCH - 1) * size}")):
            what = f'"{function}, vector {number}{said}: {result.name}"'
            comparisons.append(OutputCheck(what, compare, size, got, expected, tolerance))
    lines.append(f"{function}({', '.join(passed)});")
    lines += listed(f"{public_name(kernel, precision, '_batch')}(", [str(_BATCH), *steps], ");")
    return Vector(f"{kernel.name}_vector_{number}{precision.suffix}", tuple(lines), tuple(comparisons))


def _array(precision: Precision, word: str, entries: Sequence[Exact]) -> tuple[str, ...]:
    """The lines that declare an array with these entries."""
    values = [_number(entry, precision) for entry in entries]
    return listed(f"const {precision.name} {word}[{len(entries)}] = {{", values, "};", closing_line=True)


def _number(entry: Exact, precision: Precision) -> str:
    """The C constant of an exact number; a numeral is handed to the compiler as it stands."""
    if not isinstance(entry, str):
        return literal(Fraction(entry), precision)[0]
    if entry == "nan":
        return "NAN"
    return f"{entry if set(entry) & set('.eE') else entry + '.0'}{precision.suffix}"
