"""How does a language spell one operation? Phrases with precedence, and the four habits of a dialect.

A language with two precisions has two dialects.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import IntEnum
from fractions import Fraction

from chasles.lowering.program import Op, Program

Shape = tuple[int, ...]
_CIRCULAR = {
    Op.SQUARE_ROOT: ("sqrt", 1),
    Op.SINE: ("sin", 1),
    Op.COSINE: ("cos", 1),
    Op.ARCTANGENT2: ("atan2", 2),
}
"""The operations that C calls by a name."""


class Level(IntEnum):
    """How tightly an expression binds; a looser one needs parentheses where a tighter one is expected."""

    CHOICE = 0
    COMPARISON = 1
    SUM = 2
    PRODUCT = 3
    SIGN = 4
    ATOM = 5


@dataclass(frozen=True, slots=True)
class Phrase:
    """An operation in a language: `text` with a gap for each operand, and the loosest level that each gap takes."""

    text: str
    level: Level
    gaps: tuple[Level, ...]

    @property
    def is_call(self) -> bool:
        """Whether the operands are a function's arguments."""
        return self.level is Level.ATOM


def infix(sign: str, level: Level) -> Phrase:
    """A binary operation, read from the left: the rounding order of a program is kept."""
    return Phrase(f"{{}} {sign} {{}}", level, (level, Level(level + 1)))


def call(name: str, operands: int = 1) -> Phrase:
    """A function of so many operands."""
    return Phrase(f"{name}({', '.join(['{}'] * operands)})", Level.ATOM, (Level.CHOICE,) * operands)


def circular(function: Callable[[str, int], Phrase]) -> dict[Op, Phrase]:
    """The root, and the functions of the circle, as a language calls what in C has a name."""
    return {op: function(*name) for op, name in _CIRCULAR.items()}


def called(program: Program) -> set[tuple[str, int]]:
    """The functions that a program calls: the names that they have in C, and how many operands each has."""
    functions = {(step.function, len(step.operands)) for step in program.steps if step.op is Op.FUNCTION}
    return functions | {_CIRCULAR[step.op] for step in program.steps if step.op in _CIRCULAR}


def flat(name: str, shape: Shape, entry: int) -> str:
    """The entry of an array of numbers one after the other."""
    return f"{name}[{entry}]" if shape else name


def nested(name: str, shape: Shape, entry: int) -> str:
    """The entry of arrays in arrays, row by row."""
    places: list[int] = []
    for extent in reversed(shape):
        entry, place = divmod(entry, extent)
        places.insert(0, place)
    return name + "".join(f"[{place}]" for place in places)


ARITHMETIC: Mapping[Op, Phrase] = {
    Op.ADD: infix("+", Level.SUM),
    Op.SUBTRACT: infix("-", Level.SUM),
    Op.MULTIPLY: infix("*", Level.PRODUCT),
    Op.DIVIDE: infix("/", Level.PRODUCT),
    Op.NEGATE: Phrase("-{}", Level.SIGN, (Level.ATOM,)),
    Op.LESS: Phrase("{} < {}", Level.COMPARISON, (Level.SUM, Level.SUM)),
    Op.EQUAL: Phrase("{} == {}", Level.COMPARISON, (Level.SUM, Level.SUM)),
}
"""What nearly all languages share."""
CONDITIONAL = Phrase("{} ? {} : {}", Level.CHOICE, (Level.COMPARISON, Level.SUM, Level.SUM))
"""How C and its kin choose."""


@dataclass(frozen=True, slots=True)
class Dialect:
    """A language in one precision.

    `function(name, operands)` spells a function of the table, `constant(value)` an exact number, and says how tightly
    the text binds; `component(name, shape, entry)` reads an entry (flat, row-major) of an argument; `declare(name,
    text, truth)` is the statement that names a temporary, `truth` where it holds a truth value. `lift` wraps one that
    is handed to a function. Where `name_entries` is set, every entry of a result that has to be computed has a name
    before the first is stored; where it is `special`, it has SciPy's functions. An expression longer than `width`
    is broken by naming its longest part.
    """

    spell: Mapping[Op, Phrase]
    constant: Callable[[Fraction], tuple[str, Level]]
    component: Callable[[str, Shape, int], str]
    declare: Callable[[str, str, bool], str]
    reserved: frozenset[str] = frozenset()
    lift: str = "{}"
    name_entries: bool = True
    width: int = 72
    function: Callable[[str, int], Phrase] = call
    special: bool = False
