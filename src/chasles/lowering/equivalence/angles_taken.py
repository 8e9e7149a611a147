"""Of which angles does a program take sines and cosines? Sums of multiples of its arguments, and of their lengths."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction

from chasles.lowering.program import HALF_TURN, Op, Program
from chasles.lowering.request import Request
from chasles.vocabulary import PI, Call, Node, Norm, Number, Scale, Sum, Symbol, symbols_of, walk

Linear = dict[Node, Fraction]
"""An angle as a sum of multiples of scalar arguments, and of lengths of others."""


class Unreadable(ValueError):
    """A step that does what the request's expressions do not; the message says what."""


def angles_of(program: Program, request: Request) -> Iterator[Node]:
    """The cosines that the program takes, as expressions; with them its sines are known too."""
    functions = {known.symbol for known in request.functions}
    said = (*(output.value for output in request.outputs), *(right for _, right in request.rules))
    said += tuple(argument for known in request.functions for argument in known.arguments)
    calls = (part for node in said for part in walk(node) if isinstance(part, Call))
    turning = [symbol for call in calls for symbol in symbols_of(call.argument) if symbol in functions]

    def length(number: int) -> Linear:
        """A multiple of the length of the one argument that a step is made of; the reading sees whether it is that."""
        of, waiting = set(), [number]
        while waiting:
            step = program.steps[waiting.pop()]
            waiting += step.operands
            of |= {request.place(step.argument, step.entry)[0]} if step.op is Op.INPUT else set()
        angles: Linear = {symbol: Fraction(1, 2) for symbol in turning}
        lengths: Linear = {Norm(node): _factor(program, number) for node in of if len(of) == 1 and not node.is_scalar}
        return angles | lengths

    for step in program.steps:
        if step.op in (Op.SINE, Op.COSINE):
            yield call_at("cos", linear_angle(program, request, step.operands[0], length))


def call_at(function: str, angle: Linear) -> Call:
    """The sine or cosine of an angle."""
    terms = tuple(Scale(Number(multiple), symbol) for symbol, multiple in angle.items() if multiple)
    if not terms:
        return Call(function, Number(Fraction(0)))
    return Call(function, terms[0] if len(terms) == 1 else Sum(terms))


def linear_angle(program: Program, request: Request, number: int, length: Callable[[int], Linear]) -> Linear:
    """A step as a sum of rational multiples of scalar arguments and of lengths."""
    step = program.steps[number]
    match step.op:
        case Op.CONSTANT if step == HALF_TURN:
            return {PI: Fraction(1)}
        case Op.INPUT if isinstance(symbol := request.place(step.argument, step.entry)[0], Symbol) and symbol.is_scalar:
            return {symbol: Fraction(1)}
        case Op.ADD | Op.SUBTRACT:
            one, other = (linear_angle(program, request, operand, length) for operand in step.operands)
            sign = 1 if step.op is Op.ADD else -1
            return {s: one.get(s, Fraction(0)) + sign * other.get(s, Fraction(0)) for s in {**one, **other}}
        case Op.NEGATE:
            return {s: -q for s, q in linear_angle(program, request, step.operands[0], length).items()}
        case Op.MULTIPLY | Op.DIVIDE:
            first, second = (program.steps[operand] for operand in step.operands)
            if second.is_number and second.value:
                factor = second.value if step.op is Op.MULTIPLY else 1 / second.value
                return {s: q * factor for s, q in linear_angle(program, request, step.operands[0], length).items()}
            if first.is_number and step.op is Op.MULTIPLY:
                return {s: q * first.value for s, q in linear_angle(program, request, step.operands[1], length).items()}
    if step.op is not Op.INPUT and (found := length(number)):
        return found
    raise Unreadable(f"step {number} is no sum of multiples of angles, and a cosine or sine is taken of it")


def _factor(program: Program, number: int) -> Fraction:
    """The product of the constants in a product."""
    step = program.steps[number]
    match step.op:
        case Op.CONSTANT:
            return step.value
        case Op.MULTIPLY:
            one, other = (_factor(program, operand) for operand in step.operands)
            return one * other
        case _:
            return Fraction(1)
