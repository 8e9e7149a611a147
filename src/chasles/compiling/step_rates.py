"""How does a step change with the steps that it is made of? Its rate as a sum of factors times theirs, said once.

The rate of an even function of a root is that by what the root is taken of, which there is where it vanishes.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass
from dataclasses import replace as with_fields
from fractions import Fraction

from chasles.compiling.quotient_rates import rate_of_quotient
from chasles.lowering.builder import Builder
from chasles.lowering.functions import FUNCTIONS
from chasles.lowering.program import Op, Step
from chasles.lowering.refusal import LoweringError


@dataclass(frozen=True, slots=True)
class StepRate:
    """The rate of a step: the sum of factors times rates of other steps, over a divisor."""

    terms: tuple[tuple[int, int], ...]
    divisor: int | None = None


Rates = dict[int, StepRate]
"""The steps that change, in their order."""


def rates_of(build: Builder, entries: Iterable[int], variables: Iterable[int]) -> Rates:
    """The rates of those steps that change with the variables and that entries depend on."""
    needed = set(entries)
    count = max(needed, default=-1) + 1
    for number in reversed(range(count)):
        if number in needed:
            needed.update(build.changes_with(number))
    changing, found = set(variables), {}
    for number in range(count):
        if number in needed and any(k in changing for k in build.changes_with(number)):
            changing.add(number)
            found[number] = _rate(build, number, build.step(number), changing)
    return found


def _rate(build: Builder, number: int, step: Step, changing: Collection[int]) -> StepRate:
    a, b = (*step.operands, build.zero)[:2]
    divisor = None
    match step.op:
        case _ if number in build.slopes:
            terms = list(build.slopes[number])
        case Op.ADD:
            terms = [(a, build.one), (b, build.one)]
        case Op.SUBTRACT:
            terms = [(a, build.one), (b, build.negate(build.one))]
        case Op.MULTIPLY if a == b:
            # Two times what comes, so that in both directions one number is doubled.
            terms, divisor = [(a, a)], build.constant(Fraction(1, 2))
        case Op.MULTIPLY:
            terms = [(a, b), (b, a)]
        case Op.DIVIDE:
            terms, divisor = rate_of_quotient(build, number, changing)
        case Op.NEGATE:
            terms = [(a, build.negate(build.one))]
        case Op.SQUARE_ROOT:
            terms, divisor = [(a, build.one)], build.multiply(build.constant(2), number)
        case Op.SINE:
            terms = [(a, build.cosine(a))]
        case Op.COSINE if (under := _under_root(build, a, changing)) is not None:
            times = build.constant(-(under.factor**2) / 2)
            terms = under.terms(build, build.multiply(times, build.function("stumpff", build.one, a)))
        case Op.COSINE:
            terms = [(a, build.negate(build.sine(a)))]
        case Op.ARCTANGENT2 if b == build.one and build.step(a).op is Op.DIVIDE:
            # Neither the quotient nor its square need be in range.
            above, below = build.step(a).operands
            terms = [(above, below), (below, build.negate(above))]
            divisor = build.add(build.multiply(above, above), build.multiply(below, below))
        case Op.ARCTANGENT2:
            terms, divisor = [(a, b), (b, build.negate(a))], build.add(build.multiply(a, a), build.multiply(b, b))
        case Op.FUNCTION if step.function in ("log", "log1p"):
            # Divided at the end it is a quotient, whose own slope keeps its digits.
            terms, divisor = [(a, build.one)], a if step.function == "log" else build.add(a, build.one)
        case Op.FUNCTION:
            terms = _terms_of_function(build, number, step, changing)
        case _:
            # Comparisons, and choices, which are no sums.
            terms = [(operand, build.zero) for operand in step.operands]
    return StepRate(tuple(term for term in terms if term[0] in changing), divisor)


@dataclass(frozen=True, slots=True)
class _Root:
    """A multiple, by a number and perhaps by a step, of the root of what a step holds."""

    factor: Fraction
    radicand: int
    by: int | None = None

    def terms(self, build: Builder, slope: int) -> list[tuple[int, int]]:
        """The terms of a function with this slope by the square of the multiple, the number left out."""
        if self.by is None:
            return [(self.radicand, slope)]
        rate = build.multiply(self.by, slope)
        twice = build.multiply(build.constant(2), build.multiply(self.radicand, rate))
        return [(self.radicand, build.multiply(self.by, rate)), (self.by, twice)]


def _under_root(build: Builder, number: int, changing: Collection[int]) -> _Root | None:
    """Of which root that changes a step is a multiple."""
    step = build.step(number)
    if step.op is Op.SQUARE_ROOT:
        return _Root(Fraction(1), step.operands[0]) if step.operands[0] in changing else None
    for one, other in (step.operands, step.operands[::-1]) if step.op is Op.MULTIPLY else ():
        factor = build.value(one)
        if factor is not None or build.step(other).op is Op.SQUARE_ROOT:
            inner = _under_root(build, other, changing)
            if inner is not None:
                return (
                    with_fields(inner, by=one) if factor is None else with_fields(inner, factor=factor * inner.factor)
                )
    return None


def _terms_of_function(build: Builder, number: int, step: Step, changing: Collection[int]) -> list[tuple[int, int]]:
    function, under = FUNCTIONS[step.function], _under_root(build, step.operands[-1], changing)
    # The root itself has no derivative at zero, and the even function has.
    by_square = function.rates_by_square if under is not None else None
    rates = by_square or function.rates
    if rates is None:
        raise LoweringError(f"the derivative of {step.function} is not known")
    *slopes, last = rates(build, number, *step.operands)
    found = list(zip(step.operands, slopes, strict=False))
    if by_square is None or under is None:
        return [*found, (step.operands[-1], last)]
    return found + under.terms(build, build.multiply(build.constant(under.factor**2), last))
