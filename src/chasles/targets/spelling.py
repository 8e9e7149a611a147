"""How does a program read in a dialect? Declarations in order, then the text of every entry of every result.

A step that is used once stands inside the expression that uses it, as long as that stays readable; the others get a
name. The order of rounding is the program's: parentheses are as few as keep it.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from fractions import Fraction

from chasles.lowering.functions import FUNCTIONS
from chasles.lowering.names import Names
from chasles.lowering.program import Op, Program, Step
from chasles.targets.dialect import Dialect, Level, Phrase
from chasles.targets.kernel import TRUTH, EmissionError

# A right operand that begins with a minus sign stands in parentheses: a - (-b).
_CHAINED = (Level.SUM, Level.PRODUCT)
_ANGLES = {Op.SINE: "sin", Op.COSINE: "cos"}


@dataclass(frozen=True, slots=True)
class Spelled:
    """A program in a dialect: the names of its arguments and results, its `lines`, and the results' entries."""

    arguments: tuple[str, ...]
    results: tuple[str, ...]
    lines: tuple[str, ...]
    entries: tuple[tuple[str, ...], ...]


def spelled(program: Program, dialect: Dialect) -> Spelled:
    """The program in this dialect. Raises EmissionError where the dialect has no phrase for an operation."""
    return _Writer(program, dialect).written()


@dataclass(slots=True)
class _Expression:
    text: str
    level: Level
    op: Op
    constant: bool = False
    """Whether it holds constants only."""
    size: int = 0
    """How many operations stand inside, which a name would take out."""


class _Writer:
    """The state of one pass over the steps."""

    def __init__(self, program: Program, dialect: Dialect) -> None:
        self.program = program
        self.dialect = dialect
        self.names = Names(dialect.reserved)
        self.arguments = tuple(self.names.take(argument.name) for argument in program.arguments)
        self.results = tuple(self.names.take(result.name) for result in program.results)
        self.wanted = self._wanted_names() if dialect.name_entries else {}
        self.uses = _uses(program)
        self.expressions: dict[int, _Expression] = {}
        self.lines: list[str] = []

    def written(self) -> Spelled:
        for number, step in enumerate(self.program.steps):
            if self.uses[number]:
                self.expressions[number] = self._expression(step)
                self._name_if_needed(number, step)
        entries = tuple(
            tuple(self.expressions[entry].text for entry in result.entries) for result in self.program.results
        )
        return Spelled(self.arguments, self.results, tuple(self.lines), entries)

    def _wanted_names(self) -> dict[int, str]:
        """A name for every step that is an entry of a result, after the first such entry."""
        wanted: dict[int, str] = {}
        for name, result in zip(self.results, self.program.results, strict=True):
            stem = f"{name}_" if name[-1].isdigit() else name
            for position, entry in enumerate(result.entries):
                if entry not in wanted:
                    wanted[entry] = self.names.take(f"{stem}{position}" if result.shape else f"{name}_value")
        return wanted

    def _name_if_needed(self, number: int, step: Step) -> None:
        expression = self.expressions[number]
        if expression.constant and expression.size == 0:
            return
        if number in self.wanted:
            # An input that is handed on is read before anything is stored, for the output may lie over it.
            self._name(expression, self.wanted[number])
        elif self.uses[number] > 1 and not self._is_cheap_to_repeat(step):
            telling = self._telling_name(step)
            self._name(expression, self.names.take(telling) if telling else self.names.number("t"))

    def _is_cheap_to_repeat(self, step: Step) -> bool:
        if step.op is Op.NEGATE:
            return self.expressions[step.operands[0]].level is Level.ATOM
        return step.op is Op.INPUT

    def _telling_name(self, step: Step) -> str | None:
        """A name that says what the step is: sin_phi, half_phi."""
        operands = [self.expressions[operand].text for operand in step.operands]
        if step.op in _ANGLES and operands[0].isidentifier():
            return f"{_ANGLES[step.op]}_{operands[0]}"
        steps = [self.program.steps[operand] for operand in step.operands]
        for half, whole in ((0, 1), (1, 0)):
            if step.op is Op.MULTIPLY and steps[half].op is Op.CONSTANT and steps[half].value == Fraction(1, 2):
                return f"half_{operands[whole]}" if operands[whole].isidentifier() else None
        if step.op is Op.DIVIDE and steps[1].op is Op.CONSTANT and steps[1].value == 2 and operands[0].isidentifier():
            return f"half_{operands[0]}"
        return None

    def _name(self, expression: _Expression, name: str) -> None:
        """Declare the expression and let the name stand for it from here on."""
        text = self.dialect.lift.format(expression.text) if expression.constant else expression.text
        self.lines.append(self.dialect.declare(name, text, expression.op in TRUTH))
        expression.text, expression.level, expression.size, expression.constant = name, Level.ATOM, 0, False

    def _expression(self, step: Step) -> _Expression:
        if step.op is Op.INPUT:
            argument = self.program.arguments[step.argument]
            text = self.dialect.component(self.arguments[step.argument], argument.shape, step.entry)
            return _Expression(text, Level.ATOM, step.op)
        if step.op is Op.CONSTANT:
            return _Expression(*self.dialect.constant(step.value), step.op, constant=True)
        phrase = self._phrase(step)
        operands = [self.expressions[operand] for operand in step.operands]
        text = self._filled(phrase, operands)
        while len(text) > self.dialect.width and any(operand.size for operand in operands):
            longest = max(operands, key=lambda operand: (operand.size > 0, len(operand.text)))
            self._name(longest, self.names.number("t"))
            text = self._filled(phrase, operands)
        constant = all(operand.constant for operand in operands) and not phrase.is_call
        return _Expression(text, phrase.level, step.op, constant, 1 + sum(operand.size for operand in operands))

    def _phrase(self, step: Step) -> Phrase:
        op = step.op
        if op is Op.FUNCTION:
            if FUNCTIONS[step.function].special and not self.dialect.special:
                raise EmissionError(
                    f"{self.program.name}: {step.function} is a function of SciPy, which Python alone has"
                )
            return self.dialect.function(step.function, len(step.operands))
        try:
            return self.dialect.spell[op]
        except KeyError:
            raise EmissionError(f"{self.program.name}: the target's dialect does not spell {op.value!r}") from None

    def _filled(self, phrase: Phrase, operands: list[_Expression]) -> str:
        texts = []
        for gap, operand in zip(phrase.gaps, operands, strict=True):
            if phrase.is_call and operand.constant:
                texts.append(self.dialect.lift.format(operand.text))
            elif operand.level < gap or (texts and operand.text.startswith("-") and phrase.level in _CHAINED):
                texts.append(f"({operand.text})")
            else:
                texts.append(operand.text)
        return phrase.text.format(*texts)


def _uses(program: Program) -> Counter[int]:
    """How often each step is read by a result or by a step that is itself read."""
    uses = Counter(entry for result in program.results for entry in result.entries)
    for number in reversed(range(len(program.steps))):
        if uses[number]:
            uses.update(program.steps[number].operands)
    return uses
