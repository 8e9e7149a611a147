"""A program read as algebra: every step a fraction in the entries of the arguments.

A root is a norm of the request, a sine or cosine that of a sum of its angles, an arctangent one of its angles by cosine
and sine; a selection goes the way that the signs on this way through the cases say, unless it is a scale, which is read
as any positive number.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from types import MappingProxyType

from chasles.algebra.localization import Ratio
from chasles.lowering.algebra import Algebra
from chasles.lowering.program import Op, Program
from chasles.lowering.request import Request
from chasles.lowering.scales import is_scale
from chasles.lowering.signs import Signs
from chasles.vocabulary import Call, Node, Number, Scale, Sum, Symbol, uniform

__all__ = ["Reading", "Settled", "Unreadable", "angles_of", "scale_symbols"]

Linear = dict[Symbol, Fraction]


class Unreadable(ValueError):
    """A step that does what the request's expressions do not; the message says what."""


class Settled:
    """The steps whose values are the same however comparisons come out, and those values once they are found.

    A quotient and a root are not among them: by what is zero, or of it, they are read otherwise.
    """

    def __init__(self, program: Program) -> None:
        self.values: dict[int, Ratio | None] = {}
        self.steps: set[int] = set()
        for number, step in enumerate(program.steps):
            if step.op not in (Op.SELECT, Op.DIVIDE, Op.SQUARE_ROOT) and self.steps.issuperset(step.operands):
                self.steps.add(number)


class Reading:
    """The values of a program's steps on one way through its cases; None is what has no value."""

    def __init__(
        self,
        program: Program,
        request: Request,
        signs: Signs,
        settled: Settled,
        scales: Mapping[int, Symbol] = MappingProxyType({}),
    ) -> None:
        self._scales = scales
        self._program = program
        self._request = request
        self._algebra: Algebra = signs.differences.algebra
        self._signs = signs
        self._settled = settled
        self._values: dict[int, Ratio | None] = {}

    def value(self, number: int) -> Ratio | None:
        """The value of a step; raises `Unreadable`, or `Fork` where a comparison is not settled."""
        values = self._settled.values if number in self._settled.steps else self._values
        if number not in values:
            values[number] = self._value(number)
        return values[number]

    def _value(self, number: int) -> Ratio | None:
        step = self._program.steps[number]
        if number in self._scales:
            return self._algebra.entry(self._scales[number])
        match step.op:
            case Op.INPUT:
                return self._input(step.argument, step.entry)
            case Op.CONSTANT:
                return self._algebra.constant(step.value)
            case Op.NOT_A_NUMBER:
                return None
            case Op.SINE | Op.COSINE:
                name = "sin" if step.op is Op.SINE else "cos"
                return self._algebra.entry(_call(name, _linear(self._program, self._request, step.operands[0])))
            case Op.SELECT:
                return self.value(step.operands[1 if self._holds(step.operands[0]) else 2])
            case _:
                return self._arithmetic(number)

    def _arithmetic(self, number: int) -> Ratio | None:
        known: list[Ratio] = []
        for operand in self._program.steps[number].operands:
            value = self.value(operand)
            if value is None:
                # What is not a number makes all that it enters no number; what it is combined with need not be read.
                return None
            known.append(value)
        match self._program.steps[number].op:
            case Op.ADD:
                return known[0] + known[1]
            case Op.SUBTRACT:
                return known[0] - known[1]
            case Op.MULTIPLY:
                return known[0] * known[1]
            case Op.NEGATE:
                return -known[0]
            case Op.DIVIDE:
                if self._signs.is_zero(known[1]):
                    return None
                quotient = self._algebra.quotient(known[0], known[1])
                if quotient is None:
                    raise Unreadable(f"step {number} divides by what can be zero where the formula has a value")
                return quotient
            case Op.SQUARE_ROOT:
                if self._signs.is_zero(known[0]):
                    return self._algebra.constant(Fraction(0))
                root = self._algebra.root(known[0])
                if root is None:
                    raise Unreadable(f"step {number} takes a root that is no norm of the formula")
                return root
            case Op.ARCTANGENT2:
                return self._angle(number, known[0], known[1])
            case op:
                raise Unreadable(f"step {number}, {op.value}, is read as a number")

    def _input(self, argument: int, entry: int) -> Ratio:
        node, row, column = self._request.place(argument, entry)
        try:
            return self._algebra.entry(node, row, column)
        except KeyError:
            raise Unreadable(f"it reads {node}, of which the formula has only the cosine and sine") from None

    def _angle(self, number: int, sine: Ratio, cosine: Ratio) -> Ratio:
        entry, vanishes = self._algebra.entry, self._algebra.vanishes
        for symbol, angle in self._request.angles:
            if vanishes(entry(angle.sine) - sine) and vanishes(entry(angle.cosine) - cosine):
                return entry(symbol) * self._algebra.constant(1 / angle.times)
        raise Unreadable(f"step {number} measures an angle that is none of the formula's")

    def _holds(self, number: int) -> bool:
        step = self._program.steps[number]
        if step.op not in (Op.LESS, Op.EQUAL):
            raise Unreadable(f"step {number}, {step.op.value}, is read as a truth value")
        left, right = (self.value(operand) for operand in step.operands)
        # No comparison with what is not a number holds.
        return left is not None and right is not None and self._signs.truth(step.op.value, left - right)


def scale_symbols(program: Program) -> dict[int, Symbol]:
    """A symbol for each step that is a scale: whatever positive number it stands for, the program is to be right."""
    numbers = (k for k in range(len(program.steps)) if is_scale(program.steps, k))
    return {k: Symbol(f"scale {k}", "", uniform((1, 1))) for k in numbers}


def angles_of(program: Program, request: Request) -> Iterator[Node]:
    """The cosines that the program takes, as expressions; with them its sines are known too."""
    for step in program.steps:
        if step.op in (Op.SINE, Op.COSINE):
            yield _call("cos", _linear(program, request, step.operands[0]))


def _call(function: str, angle: Linear) -> Call:
    terms = tuple(Scale(Number(multiple), symbol) for symbol, multiple in angle.items() if multiple)
    if not terms:
        return Call(function, Number(Fraction(0)))
    return Call(function, terms[0] if len(terms) == 1 else Sum(terms))


def _linear(program: Program, request: Request, number: int) -> Linear:
    """A step as a sum of rational multiples of scalar arguments."""
    step = program.steps[number]
    match step.op:
        case Op.INPUT if isinstance(symbol := request.place(step.argument, step.entry)[0], Symbol) and symbol.is_scalar:
            return {symbol: Fraction(1)}
        case Op.ADD | Op.SUBTRACT:
            one, other = (_linear(program, request, operand) for operand in step.operands)
            sign = 1 if step.op is Op.ADD else -1
            return {s: one.get(s, Fraction(0)) + sign * other.get(s, Fraction(0)) for s in {**one, **other}}
        case Op.NEGATE:
            return {s: -q for s, q in _linear(program, request, step.operands[0]).items()}
        case Op.MULTIPLY | Op.DIVIDE:
            first, second = (program.steps[operand] for operand in step.operands)
            if second.op is Op.CONSTANT and second.value:
                factor = second.value if step.op is Op.MULTIPLY else 1 / second.value
                return {s: q * factor for s, q in _linear(program, request, step.operands[0]).items()}
            if first.op is Op.CONSTANT and step.op is Op.MULTIPLY:
                return {s: q * first.value for s, q in _linear(program, request, step.operands[1]).items()}
    raise Unreadable(f"step {number} is no sum of multiples of angles, and a cosine or sine is taken of it")
