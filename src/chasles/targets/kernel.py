"""What is emitted? A kernel: a program, what its heading says of it, and exact values it must give.

Nothing here knows a language; every target reads a kernel through this module.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from chasles.lowering.program import Op, Program

if TYPE_CHECKING:
    from chasles.bounds.bound import Bound
    from chasles.bounds.box import BoxBound

Exact = Fraction | int | str
"""A rational number, or a decimal numeral such as "0.4794255386042030", or "nan"."""

TESTED = ("unit", "unit column", "rotation", "positive", "symmetric", "definite", "nonzero")
"""The kinds of hypotheses that are tested on arguments."""

TRUTH = (Op.LESS, Op.EQUAL)
"""The operations that yield a truth value."""

_NUMERAL = re.compile(r"[+-]?(\d+\.\d*|\.\d+|\d+)([eE][+-]?\d+)?|nan")
_SECTION = re.compile(r"[a-z][a-z0-9_]*")
_HASH = re.compile(r"[0-9a-f]{64}")


class EmissionError(Exception):
    """Nothing can be emitted; the message says why, where, and what to do."""


@dataclass(frozen=True, slots=True)
class Heading:
    """What a generated function says of itself, in plain text.

    The proof assumes the `hypotheses`; what is `expected` of the arguments gives the result its meaning.
    `derivation` is the sha256 of the declaration in hexadecimal; `section` names the file of the C library; `form` is
    "offered" where the program spells other words than the statement's, proved equal to it, else "stated".
    Raises ValueError for LaTeX, for a text of several lines and for a derivation that is no such hash.
    """

    number: str
    says: str
    verdict: str
    hypotheses: tuple[str, ...]
    derivation: str
    section: str = "kernels"
    form: str = "stated"
    expected: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        for text in (self.number, self.says, self.verdict, *self.hypotheses, *self.expected):
            require_plain(text, f"the heading of ({self.number})")
        if not _HASH.fullmatch(self.derivation):
            raise ValueError(f"({self.number}): derivation must be 64 hexadecimal digits, not {self.derivation!r}")
        if not _SECTION.fullmatch(self.section):
            raise ValueError(f"({self.number}): section must be a file's name like s02_screw, not {self.section!r}")


@dataclass(frozen=True, slots=True)
class Check:
    """Exact inputs of a kernel and the outputs they must give, entries row-major.

    An output passes where it is within `tolerance` machine epsilons of the largest entry expected, counted as at
    least one; "nan" passes for NaN alone.
    """

    inputs: tuple[tuple[Exact, ...], ...]
    outputs: tuple[tuple[Exact, ...], ...]
    tolerance: int = 8

    def __post_init__(self) -> None:
        for entry in (entry for group in (*self.inputs, *self.outputs) for entry in group):
            if isinstance(entry, str) and not _NUMERAL.fullmatch(entry):
                raise ValueError(f"a check holds {entry!r}, which is neither a decimal numeral nor 'nan'")


@dataclass(frozen=True, slots=True)
class Demand:
    """What must hold of some of a kernel's arguments, named: a kind of hypothesis and its text.

    What a "nonzero" one says does not vanish is the `divisor`, a program of those arguments with one result.
    Raises ValueError for a kind that no test of numbers confirms.
    """

    kind: str
    text: str
    arguments: tuple[str, ...]
    divisor: Program | None = None

    def __post_init__(self) -> None:
        if self.kind not in TESTED:
            raise ValueError(f"{self.text}: no test of arguments knows the hypothesis {self.kind!r}")
        if (self.kind == "nonzero") != (self.divisor is not None):
            raise ValueError(f"{self.text}: a divisor belongs to what must not vanish, and to nothing else")


@dataclass(frozen=True, slots=True)
class TargetKernel:
    """A program ready to be spelled in every language, with what is proved of its errors, if that was asked for.

    A `bound` is for all inputs that the heading allows, `box_bounds` are for those of a box.

    Raises ValueError where a check has other sizes than the program, or the program cannot be spelled: nothing to
    read or to give, an entry that an argument lacks, a truth value where a number belongs.
    """

    program: Program
    heading: Heading
    checks: tuple[Check, ...] = ()
    demands: tuple[Demand, ...] = ()
    bound: Bound | None = None
    box_bounds: tuple[BoxBound, ...] = ()

    def __post_init__(self) -> None:
        program = self.program
        inputs, outputs = _sizes(program)
        for check in self.checks:
            found = tuple(map(len, check.inputs)), tuple(map(len, check.outputs))
            if found != (inputs, outputs):
                raise ValueError(f"{program.name}: a check has sizes {found}, the program {(inputs, outputs)}")

    @property
    def name(self) -> str:
        """The kernel's public name."""
        return self.program.name


def signature(program: Program) -> str:
    """The generalised ufunc signature with frozen core dimensions, such as "(3),()->(3,3)"."""
    inputs = ",".join(_core(argument.shape) for argument in program.arguments)
    outputs = ",".join(_core(result.shape) for result in program.results)
    return f"{inputs}->{outputs}"


def require_plain(text: str, where: str) -> None:
    """Raise ValueError where `text` could not stand in a comment of every language."""
    if "\\" in text or "$" in text:
        raise ValueError(f"{where}: LaTeX cannot stand in generated code; write it plainly: {text!r}")
    if not text.isprintable():
        raise ValueError(f"{where}: a text of one printable line is expected, not {text!r}")


def _sizes(program: Program) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """How many entries each input and each output has, once all of the program is found in order."""
    if not program.arguments or not program.results:
        raise ValueError(f"{program.name}: a kernel needs at least one input and one output")
    for item in program.parameters:
        require_plain(item.meaning, f"{program.name}: the meaning of {item.name}")
        if not item.name.isidentifier() or not item.name.isascii():
            raise ValueError(f"{program.name}: {item.name!r} is no name in every language")
    inputs = tuple(math.prod(argument.shape) for argument in program.arguments)
    outputs = tuple(math.prod(result.shape) for result in program.results)
    for number, step in enumerate(program.steps):
        if step.op is Op.INPUT and not (0 <= step.argument < len(inputs) and 0 <= step.entry < inputs[step.argument]):
            raise ValueError(f"{program.name}: step {number} reads an entry that no argument has")
        for position, operand in enumerate(step.operands):
            if (program.steps[operand].op in TRUTH) != (step.op is Op.SELECT and position == 0):
                raise ValueError(f"{program.name}: step {number} takes a truth value for a number or a number for one")
    for result, size in zip(program.results, outputs, strict=True):
        if len(result.entries) != size:
            raise ValueError(f"{program.name}: {result.name} has {len(result.entries)} entries, its shape {size}")
        if any(program.steps[entry].op in TRUTH for entry in result.entries):
            raise ValueError(f"{program.name}: {result.name} holds a truth value")
    return inputs, outputs


def _core(shape: tuple[int, ...]) -> str:
    return f"({','.join(map(str, shape))})"
