"""How far is a result from the sum of its terms' sizes? An a-priori bound for all inputs, by counting roundings.

Along with each step goes the sum of the sizes of its terms: the same step with every operand replaced by its size, and
sums in the place of differences. The computed value differs from the exact one by at most a multiple of that sum,
which is kept as an exact fraction. A sum of two exact values counts as one term; a value of one term, or of terms that
are none of them negative, is that sum itself up to its sign, and so has a relative error.

The analysis is that of Higham, Accuracy and Stability of Numerical Algorithms, 2002, chapters 3 and 4.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

from chasles.bounds.model import Model
from chasles.bounds.outline import NoBound, Outline
from chasles.lowering.program import Op, Step, is_power_of_two


@dataclass(frozen=True, slots=True)
class TermwiseError:
    """The error in parts of the sum of the terms' sizes; `single` where that sum is the size of the value itself.

    It is `conditioned` where those parts are to be multiplied by the condition of a divisor.
    """

    error: Fraction = Fraction(0)
    single: bool = True
    nonnegative: bool = False
    conditioned: bool = False


def termwise_errors(
    outline: Outline, model: Model, known: Mapping[int, Fraction] | None = None, most: int = 1
) -> dict[int, TermwiseError]:
    """The error of every step that results need; `known` are relative errors of sums that do not cancel.

    With `most` above 1 a divisor may cancel: errors are in parts of the sum of terms times the divisor's condition,
    which is the sum of its terms' sizes over its own size, as long as that is not above `most`. Errors are convex
    functions of the condition that vanish with it: what holds for the largest holds, in proportion, for all.

    Raises NoBound where a divisor may cancel that must not, a radicand, or what a sign is chosen by.
    """
    found: dict[int, TermwiseError] = {}
    steps = outline.program.steps
    if most > 1:
        model = replace(model, roundoff=model.roundoff * most)
    for number in outline.needed:
        step = steps[number]
        if number in outline.angles:
            found[number] = TermwiseError(model.loss(step.op))
            continue
        if number in outline.scales:
            found[number] = TermwiseError(nonnegative=True)
            continue
        operands = outline.operands(number)
        found[number] = _share(step, [found[k] for k in operands], operands, outline, model, most > 1)
        if known and number in known:
            found[number] = TermwiseError(known[number] * most)
    if not all(found[k].single for k in outline.signs):
        raise NoBound("it chooses a sign by a sum whose terms may cancel")
    return {k: replace(error, error=error.error / most) for k, error in found.items()}


def _share(
    step: Step, of: list[TermwiseError], numbers: tuple[int, ...], outline: Outline, model: Model, conditioned: bool
) -> TermwiseError:
    match step.op:
        case Op.INPUT:
            return TermwiseError()
        case Op.CONSTANT:
            exact = model.is_exact(step.value)
            return TermwiseError(Fraction(0) if exact else model.roundoff, nonnegative=step.value >= 0)
        case Op.NEGATE:
            return TermwiseError(of[0].error, of[0].single, conditioned=of[0].conditioned)
        case Op.ADD | Op.SUBTRACT:
            return _sum(step.op, of, model)
        case Op.MULTIPLY:
            return _product(of, numbers, outline, model)
        case Op.DIVIDE:
            return _quotient(of, model, conditioned)
        case Op.SQUARE_ROOT:
            return _root(of[0], model)
        case Op.ARCTANGENT2:
            return _direction(of, model)
        case op:
            raise NoBound(f"nothing is known of the operation {op}")


def _sum(op: Op, of: list[TermwiseError], model: Model) -> TermwiseError:
    x, y = of
    if not x.error and not y.error:
        return TermwiseError(model.roundoff, nonnegative=op is Op.ADD and x.nonnegative and y.nonnegative)
    positive = op is Op.ADD and x.nonnegative and y.nonnegative
    error = _after(1 + max(x.error, y.error), model.loss(op))
    return TermwiseError(error, positive and x.single and y.single, positive, x.conditioned or y.conditioned)


def _product(of: list[TermwiseError], numbers: tuple[int, ...], outline: Outline, model: Model) -> TermwiseError:
    x, y = of
    single = x.single and y.single
    square = numbers[0] == numbers[1]
    nonnegative = (square or (x.nonnegative and y.nonnegative)) and single
    for other, number in ((y, numbers[0]), (x, numbers[1])):
        step = outline.program.steps[number]
        if step.op is Op.CONSTANT and is_power_of_two(step.value):
            return TermwiseError(other.error, single, nonnegative, other.conditioned)
    error = _after((1 + x.error) * (1 + y.error), model.loss(Op.MULTIPLY))
    return TermwiseError(error, single, nonnegative, x.conditioned or y.conditioned)


def _quotient(of: list[TermwiseError], model: Model, conditioned: bool) -> TermwiseError:
    x, y = of
    if not (y.single or (conditioned and not y.conditioned)):
        raise NoBound("it divides by a sum whose terms may cancel")
    error = _after((1 + x.error) / (1 - y.error), model.loss(Op.DIVIDE))
    single, nonnegative = x.single and y.single, x.nonnegative and y.nonnegative
    return TermwiseError(error, single, nonnegative and y.single, x.conditioned or y.conditioned or not y.single)


def _root(of: TermwiseError, model: Model) -> TermwiseError:
    if not of.single or not of.nonnegative:
        raise NoBound("it takes the root of a sum whose terms may cancel")
    # |sqrt(1 + d) - 1| <= |d| / 2 + d^2 / 2 for |d| <= 1.
    error = _after(1 + of.error / 2 + of.error**2 / 2, model.loss(Op.SQUARE_ROOT))
    return TermwiseError(error, True, True, of.conditioned)


def _direction(of: list[TermwiseError], model: Model) -> TermwiseError:
    """The angle of a point: it moves, relatively, by no more than the ratio of the point's coordinates does."""
    y, x = of
    if not (x.single and y.single):
        raise NoBound("it takes the angle of a point whose coordinates may cancel")
    error = max((1 + y.error) / (1 - x.error), (1 + x.error) / (1 - y.error))
    return TermwiseError(_after(error, model.loss(Op.ARCTANGENT2)), conditioned=y.conditioned or x.conditioned)


def _after(growth: Fraction, loss: Fraction) -> Fraction:
    """The error once an operation has added its own to values that have grown by a factor."""
    return growth * (1 + loss) - 1
