"""What does a kernel compute, step by step? A straight line of scalar steps in static single assignment.

A `Program` knows nothing of C or Python: a target spells it. Steps are numbered by their position and refer
only to earlier steps, so that one pass over `steps` is an evaluation.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from enum import StrEnum
from fractions import Fraction

from chasles.lowering.functions import FUNCTIONS

MOST_OPERANDS = 32
"""How many operands a function over batches may have: NumPy's own limit is that of its iterators."""
MOST_ENTRIES = 32768
"""How many numbers these may have in all: so that a group of items fits on the stack."""
Pattern = tuple[tuple[int, int], ...]
"""Rows and columns of the entries of a matrix that are not zero by construction."""


class Op(StrEnum):
    """The operations of a program; each takes the number of operands that `ARITY` or the table of functions says."""

    INPUT = "input"
    CONSTANT = "constant"
    NOT_A_NUMBER = "not_a_number"
    ADD = "add"
    SUBTRACT = "subtract"
    MULTIPLY = "multiply"
    DIVIDE = "divide"
    NEGATE = "negate"
    SQUARE_ROOT = "square_root"
    SINE = "sine"
    COSINE = "cosine"
    ARCTANGENT2 = "arctangent2"
    LESS = "less"
    EQUAL = "equal"
    SELECT = "select"
    FUNCTION = "function"


ARITY = {
    Op.INPUT: 0,
    Op.CONSTANT: 0,
    Op.NOT_A_NUMBER: 0,
    Op.ADD: 2,
    Op.SUBTRACT: 2,
    Op.MULTIPLY: 2,
    Op.DIVIDE: 2,
    Op.NEGATE: 1,
    Op.SQUARE_ROOT: 1,
    Op.SINE: 1,
    Op.COSINE: 1,
    Op.ARCTANGENT2: 2,
    Op.LESS: 2,
    Op.EQUAL: 2,
    Op.SELECT: 3,
}

FREE_OF_CHARGE = frozenset({Op.INPUT, Op.CONSTANT, Op.NOT_A_NUMBER, Op.NEGATE, Op.SELECT, Op.LESS, Op.EQUAL})


@dataclass(frozen=True, slots=True)
class Argument:
    """An input: `name` is an identifier in every target, `shape` is () for a scalar, (3,), (3, 3)..., row-major."""

    name: str
    shape: tuple[int, ...]
    meaning: str


@dataclass(frozen=True, slots=True)
class Step:
    """One operation: `operands` are numbers of earlier steps.

    `argument` and `entry` (flat, row-major) say which input an INPUT step reads; `value` is a CONSTANT's exact value;
    `function` is the name of a FUNCTION. LESS and EQUAL yield a truth value that only SELECT (condition, if
    true, if false) may read.
    """

    op: Op
    operands: tuple[int, ...] = ()
    argument: int = 0
    entry: int = 0
    value: Fraction = Fraction(0)
    function: str = ""

    def __post_init__(self) -> None:
        arity = FUNCTIONS[self.function].operands if self.op is Op.FUNCTION else ARITY[self.op]
        if len(self.operands) != arity:
            raise ValueError(f"{self.function or self.op} takes {arity} operands, not {len(self.operands)}")

    def __hash__(self) -> int:
        """Of what tells most steps apart: a fraction's hash, and an operation's, take longer than all of it."""
        if self.op is Op.CONSTANT:
            return hash((self.value.numerator, self.value.denominator))
        return hash((self.operands, self.argument, self.entry))

    @property
    def is_number(self) -> bool:
        """Whether it is a constant that is folded with others; pi, which a formula has by name, is not."""
        return self.op is Op.CONSTANT and self.value != HALF_TURN.value

    def on(self, operands: tuple[int, ...]) -> Step:
        """The same operation on other steps."""
        if operands == self.operands:
            return self
        return Step(self.op, operands, self.argument, self.entry, self.value, self.function)


HALF_TURN = Step(Op.CONSTANT, value=Fraction("3.14159265358979323846264338327950288419716939937510582097494459"))
"""The number pi in a formula that has it by name, by digits that no number else has."""


@dataclass(frozen=True, slots=True)
class Result:
    """An output: `entries` are the numbers of the steps that hold it, row-major; `pattern` is that of derivatives."""

    name: str
    shape: tuple[int, ...]
    meaning: str
    entries: tuple[int, ...]
    pattern: Pattern | None = field(default=None, repr=False)


@dataclass(frozen=True, slots=True)
class Program:
    """A kernel's computation: every step reads only arguments and earlier steps."""

    name: str
    arguments: tuple[Argument, ...]
    steps: tuple[Step, ...]
    results: tuple[Result, ...]

    def __post_init__(self) -> None:
        for number, step in enumerate(self.steps):
            for operand in step.operands:
                if operand >= number:
                    raise ValueError(f"{self.name}: step {number} reads a step that comes after it")
        for result in self.results:
            if any(entry >= len(self.steps) for entry in result.entries):
                raise ValueError(f"{self.name}: result {result.name} names a step that does not exist")

    @property
    def parameters(self) -> tuple[Argument | Result, ...]:
        """The arguments, then the results: what a function of the program is called with."""
        return (*self.arguments, *self.results)

    @property
    def operations(self) -> Counter[Op]:
        """How often each operation that costs time occurs."""
        return Counter(step.op for step in self.steps if step.op not in FREE_OF_CHARGE)


def is_power_of_two(value: Fraction) -> bool:
    """Whether multiplying by the value rounds nothing and keeps signs."""
    above, below = value.numerator, value.denominator
    return above > 0 and above & (above - 1) == 0 and below & (below - 1) == 0
