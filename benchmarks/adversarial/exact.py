"""What is a program's value without rounding? Ball arithmetic, repeated with more bits until the balls are small.

Each value goes with its size, the sum of the sizes of its terms, against which rounding errors are measured. What has
no value, as 0/0 has none and nothing that a NaN enters, is None. Nothing depends on a scale: its size is its own.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from flint import arb, ctx

from chasles.lowering.program import Op, Program
from chasles.lowering.scales import is_scale

__all__ = ["Exact", "Undecided", "roundings"]

BITS = 192
MOST_BITS = 1 << 16
"""With so many bits what still cannot be told from zero is zero: no product of ten floats is as small."""

Value = tuple[Any, Any] | None
"""A value and its size, both balls; None where there is none."""


class Undecided(ArithmeticError):
    """A comparison, or a value, that the most bits do not decide."""


class _Wide(ArithmeticError):
    """A ball that is too large to go on with."""


def roundings(program: Program) -> list[int]:
    """For each step how many roundoffs of its size its computed value may be off, to first order."""
    found: list[int] = []
    for step in program.steps:
        of = [found[k] for k in step.operands]
        match step.op:
            case Op.ADD | Op.SUBTRACT:
                found.append(max(of) + 1)
            case Op.MULTIPLY | Op.DIVIDE:
                found.append(sum(of) + 1)
            case Op.SINE | Op.COSINE | Op.ARCTANGENT2:
                found.append(max(of) + 2)
            case Op.SQUARE_ROOT:
                found.append(of[0] + 1)
            case Op.SELECT:
                found.append(max(of[1:]))
            case _:
                found.append(max(of, default=0))
    return found


@dataclass
class Exact:
    """A program as a function of floats; `least` is the relative size below which an error is of no interest."""

    program: Program
    least: float = 2.0**-60
    scales: frozenset[int] = frozenset()

    def __post_init__(self) -> None:
        self.scales = frozenset(k for k in range(len(self.program.steps)) if is_scale(self.program.steps, k))

    def __call__(self, inputs: Sequence[Any]) -> list[list[Value]]:
        """The entries of each result with their sizes. Each input is a flat sequence of floats or balls; NaN is None.

        Raises Undecided where a comparison cannot be decided.
        """
        values = self.steps(inputs)
        return [[values[k] for k in result.entries] for result in self.program.results]

    def steps(self, inputs: Sequence[Any], moved: Mapping[int, Any] = MappingProxyType({})) -> list[Any]:
        """The values of all steps, some of them moved; those of comparisons are truth values. Raises Undecided."""
        bits = BITS
        while True:
            ctx.prec = bits
            try:
                values = self._run(inputs, moved, last=bits >= MOST_BITS)
                if all(self._small(values[k]) for result in self.program.results for k in result.entries):
                    return values
            except _Wide:
                pass
            finally:
                ctx.prec = 128
            if bits >= MOST_BITS:
                raise Undecided(self.program.name)
            bits *= 4

    def _small(self, value: Value) -> bool:
        if value is None:
            return True
        ball, size = value
        if ball.is_exact():
            return True
        return bool(ball.is_finite()) and bool(ball.rad() <= size.abs_lower() * self.least)

    def _run(self, inputs: Sequence[Any], moved: Mapping[int, Any], *, last: bool) -> list[Value]:
        values: list[Any] = []
        for number, step in enumerate(self.program.steps):
            match step.op:
                case Op.INPUT:
                    given = inputs[step.argument][step.entry]
                    ball = None if given is None else given if isinstance(given, arb) else arb(float(given))
                    values.append(None if ball is None else (ball, abs(ball)))
                case Op.CONSTANT:
                    ball = arb(step.value.numerator) / step.value.denominator
                    values.append((ball, abs(ball)))
                case Op.NOT_A_NUMBER:
                    values.append(None)
                case Op.SELECT:
                    test, one, other = (values[k] for k in step.operands)
                    value = None if test is None else one if test else other
                    values.append((value[0], abs(value[0])) if value is not None and number in self.scales else value)
                case _:
                    of = [values[k] for k in step.operands]
                    values.append(None if None in of else OPERATIONS[step.op](of, last))
            if number in moved and values[number] is not None:
                values[number] = values[number][0] + moved[number], values[number][1]
        return values


def _added(of: list[Any], last: bool) -> Value:
    (x, p), (y, q) = of
    return x + y, p + q


def _subtracted(of: list[Any], last: bool) -> Value:
    (x, p), (y, q) = of
    return x - y, p + q


def _multiplied(of: list[Any], last: bool) -> Value:
    (x, p), (y, q) = of
    return x * y, p * q


def _divided(of: list[Any], last: bool) -> Value:
    (x, p), (y, q) = of
    if _sign(y, last) == 0:
        return None
    below = abs(y)
    return x / y, p / below * (q / below)


def _root(of: list[Any], last: bool) -> Value:
    x, p = of[0]
    sign = _sign(x, last)
    if sign < 0:
        return None
    root = x.sqrt() if sign else arb(0)
    return root, p / root if sign else p


def _sine(of: list[Any], last: bool) -> Value:
    return _narrow(of[0][0].sin())


def _cosine(of: list[Any], last: bool) -> Value:
    return _narrow(of[0][0].cos())


def _direction(of: list[Any], last: bool) -> Value:
    (y, q), (x, p) = of
    sign = _sign(y, last)
    if sign == 0 and _sign(x, last) >= 0:
        return arb(0), arb(0)
    angle = arb.atan2(y, x) if sign else arb.pi()
    return angle, (abs(x) * q + abs(y) * p) / (x * x + y * y) + abs(angle)


def _narrow(ball: Any) -> Value:
    if not ball.is_exact() and ball.rel_accuracy_bits() < 64:
        raise _Wide
    return ball, abs(ball)


def _sign(x: Any, last: bool) -> int:
    """-1, 0 or 1. Raises _Wide where the ball does not tell."""
    if x.is_zero():
        return 0
    if not x.is_finite():
        raise _Wide
    if x.contains(0):
        if last:
            return 0
        raise _Wide
    return 1 if x > 0 else -1


def _less(of: list[Any], last: bool) -> bool:
    return _sign(of[0][0] - of[1][0], last) < 0


def _equal(of: list[Any], last: bool) -> bool:
    return _sign(of[0][0] - of[1][0], last) == 0


def _negated(of: list[Any], last: bool) -> Value:
    x, p = of[0]
    return -x, p


OPERATIONS: dict[Op, Callable[[list[Any], bool], Any]] = {
    Op.ADD: _added,
    Op.SUBTRACT: _subtracted,
    Op.MULTIPLY: _multiplied,
    Op.DIVIDE: _divided,
    Op.NEGATE: _negated,
    Op.SQUARE_ROOT: _root,
    Op.SINE: _sine,
    Op.COSINE: _cosine,
    Op.ARCTANGENT2: _direction,
    Op.LESS: _less,
    Op.EQUAL: _equal,
}
