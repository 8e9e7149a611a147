"""How do steps change with others? By the chain rule, step by step, so that derivatives share what is computed.

What a step's rate is in terms of the rates of its operands is said once, and summed along the paths between variables
and entries: from the variables on, or from the entries back, whichever takes less (Griewank and Walther, Evaluating
Derivatives, 2008, chapters 3 and 7). Of a choice it is the derivative of what is chosen; nothing is said of where the
choice changes.
"""

from __future__ import annotations

from collections.abc import Collection, Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from dataclasses import replace as with_fields
from fractions import Fraction
from typing import TypeVar

from chasles.lowering.builder import Builder
from chasles.lowering.cost import WEIGHTS
from chasles.lowering.functions import FUNCTIONS
from chasles.lowering.program import Op, Step
from chasles.lowering.refusal import LoweringError

Key = TypeVar("Key", bound=Hashable)
Sums = dict[Key, int]
"""Steps of rates that are not zero: of one thing, by several."""
_COMPARISONS = (Op.LESS, Op.EQUAL)


@dataclass(frozen=True, slots=True)
class _Rate:
    """The rate of a step: the sum of factors times rates of other steps, over a divisor."""

    terms: tuple[tuple[int, int], ...]
    divisor: int | None = None


_Rates = dict[int, _Rate]
"""The steps that change, in their order."""


def derivatives(build: Builder, entries: Sequence[int], variables: Sequence[int]) -> list[Sums[int]]:
    """For each entry the steps of its derivatives by the variables, those that are not zero by construction."""
    rates = _rates(build, entries, variables)
    seeds = {variable: {place: build.one} for place, variable in enumerate(variables)}
    forward, below = _work(build, rates, variables, set(rates))
    if forward > _work_back(build, rates, entries, variables, below):
        columns = pulled_back(build, {entry: {entry: build.one} for entry in entries}, variables, rates)
        return [{k: column[entry] for k, column in enumerate(columns) if entry in column} for entry in entries]
    found = _forward(build, rates, seeds)
    return [found.get(entry, {}) for entry in entries]


def pushed_forward(build: Builder, entries: Sequence[int], tangents: Mapping[int, int]) -> list[int]:
    """The rates of entries of the rates of variables, step by step."""
    rates = _rates(build, entries, tangents)
    found = _forward(build, rates, {variable: {0: tangent} for variable, tangent in tangents.items()})
    return [found.get(entry, {}).get(0, build.zero) for entry in entries]


def pulled_back(
    build: Builder, seeds: Mapping[int, Sums[Key]], variables: Sequence[int], rates: _Rates | None = None
) -> list[Sums[Key]]:
    """For each variable the sums over entries of what stands before them in the seeds times their derivatives by it."""
    rates = _rates(build, tuple(seeds), variables) if rates is None else rates
    chosen = _below_choices(build, rates)
    by = _forward(build, {k: rates[k] for k in rates if k in chosen}, {v: {v: build.one} for v in variables})
    adjoints: dict[int, Sums[Key]] = {entry: dict(sums) for entry, sums in seeds.items()}
    for number in reversed(rates):
        rate = rates[number]
        # What is not chosen may have no value: its part is not multiplied by zero, but never taken.
        terms = by.get(number, {}).items() if build.step(number).op is Op.SELECT else rate.terms
        for key, adjoint in adjoints.pop(number, {}).items():
            share = adjoint if rate.divisor is None else build.divide(adjoint, rate.divisor)
            for operand, factor in terms:
                part = build.multiply(factor, share)
                sums = adjoints.setdefault(operand, {})
                if part != build.zero:
                    sums[key] = build.add(sums[key], part) if key in sums else part
    return [adjoints.get(variable, {}) for variable in variables]


def _forward(build: Builder, rates: _Rates, seeds: Mapping[int, Sums[Key]]) -> dict[int, Sums[Key]]:
    found: dict[int, Sums[Key]] = dict(seeds)
    for number, rate in rates.items():
        step = build.step(number)
        if step.op is Op.SELECT:
            sums = _of_choice(build, step, found)
        else:
            sums = {}
            for operand, factor in rate.terms:
                for key, by in found.get(operand, {}).items():
                    part = build.multiply(factor, by)
                    sums[key] = build.add(sums[key], part) if key in sums else part
            if rate.divisor is not None:
                sums = {key: build.divide(total, rate.divisor) for key, total in sums.items()}
        # By what a comparison changes is known, though it has no rate.
        found[number] = {k: total for k, total in sums.items() if total != build.zero or step.op in _COMPARISONS}
    return found


def _of_choice(build: Builder, step: Step, found: Mapping[int, Sums[Key]]) -> Sums[Key]:
    """What has no value has no derivative by what decides on it."""
    condition, *pieces = step.operands
    valueless = [build.step(piece).op is Op.NOT_A_NUMBER for piece in pieces]
    keys = dict.fromkeys(key for k in (*pieces, *([condition] if any(valueless) else [])) for key in found.get(k, ()))

    def of(piece: int, key: Key) -> int:
        return found.get(piece, {}).get(key, build.zero) if build.step(piece).op is not Op.NOT_A_NUMBER else piece

    return {key: build.select(condition, of(pieces[0], key), of(pieces[1], key)) for key in keys}


def _rates(build: Builder, entries: Iterable[int], variables: Iterable[int]) -> _Rates:
    """The rates of those steps that change with the variables and that entries depend on."""
    needed = set(entries)
    steps = build.steps[: max(needed, default=-1) + 1]
    for number in reversed(range(len(steps))):
        if number in needed:
            needed.update(steps[number].operands)
    changing, found = set(variables), {}
    for number, step in enumerate(steps):
        if number in needed and any(k in changing for k in step.operands):
            changing.add(number)
            found[number] = _rate(build, number, step, changing)
    return found


def _rate(build: Builder, number: int, step: Step, changing: Collection[int]) -> _Rate:
    a, b = (*step.operands, build.zero)[:2]
    divisor = None
    match step.op:
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
            terms, divisor = [(a, build.one), (b, build.negate(number))], b
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
        case Op.ARCTANGENT2:
            terms, divisor = [(a, b), (b, build.negate(a))], build.add(build.multiply(a, a), build.multiply(b, b))
        case Op.FUNCTION:
            terms = _terms_of_function(build, number, step, changing)
        case _:
            # Comparisons, and choices, which are no sums.
            terms = [(operand, build.zero) for operand in step.operands]
    return _Rate(tuple(term for term in terms if term[0] in changing), divisor)


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


def _below_choices(build: Builder, rates: _Rates) -> set[int]:
    """The choices, and what they depend on."""
    found: set[int] = set()
    for number in reversed(rates):
        if number in found or build.step(number).op is Op.SELECT:
            found.update((number, *(operand for operand, _ in rates[number].terms)))
    return found


def _work(
    build: Builder, rates: _Rates, variables: Iterable[int], counted: Collection[int]
) -> tuple[int, dict[int, int]]:
    """What the rates of the counted steps cost by all variables, and by which of them each step changes, as bits."""
    by = {variable: 1 << place for place, variable in enumerate(variables)}
    leaves, total = set(by), 0
    for number, rate in rates.items():
        mask = work = 0
        for operand, factor in rate.terms:
            bits = by.get(operand, 0)
            work += 0 if operand in leaves or _is_free(build, factor) else bits.bit_count()
            work += (mask & bits).bit_count()
            mask |= bits
        by[number] = mask
        total += work + mask.bit_count() * _price(build, rate.divisor) if number in counted else 0
    return total, by


def _work_back(
    build: Builder, rates: _Rates, entries: Iterable[int], variables: Iterable[int], by: Mapping[int, int]
) -> int:
    """What it costs to go back from all entries; a choice costs its derivatives by variables."""
    total, _ = _work(build, rates, variables, _below_choices(build, rates))
    of = {entry: 1 << place for place, entry in enumerate(dict.fromkeys(entries))}
    seeds = dict(of)
    for number in reversed(rates):
        rate, bits = rates[number], of.get(number, 0)
        count = bits.bit_count()
        if build.step(number).op is Op.SELECT:
            total += count * by[number].bit_count()
            continue
        total += count * _price(build, rate.divisor)
        for operand, factor in rate.terms:
            known = of.get(operand, 0)
            alone = rate.divisor is None and bits == seeds.get(number)
            total += 0 if alone or _is_free(build, factor) else count
            total += (bits & known).bit_count()
            of[operand] = bits | known
    return total


def _price(build: Builder, divisor: int | None) -> int:
    return 0 if divisor is None else WEIGHTS[Op.DIVIDE if build.value(divisor) is None else Op.MULTIPLY]


def _is_free(build: Builder, factor: int) -> bool:
    value = build.value(factor)
    return value is not None and abs(value) in (0, 1)
