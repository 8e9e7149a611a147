"""How do steps change with others? By the chain rule, step by step, so that derivatives share what is computed.

Rates of steps are summed along the paths between variables and entries: from the variables on, or from the entries
back, whichever takes less (Griewank and Walther, Evaluating Derivatives, 2008, chapters 3 and 7). Of a choice it is the
derivative of what is chosen; nothing is said of where the choice changes.
"""

from __future__ import annotations

from collections.abc import Collection, Hashable, Iterable, Mapping, Sequence
from typing import TypeVar

from chasles.compiling.step_rates import Rates, rates_of
from chasles.lowering.builder import Builder
from chasles.lowering.cost import WEIGHTS
from chasles.lowering.program import Op, Step

Key = TypeVar("Key", bound=Hashable)
Sums = dict[Key, int]
"""Steps of rates that are not zero: of one thing, by several."""
COMPARISONS = (Op.LESS, Op.EQUAL)


def derivatives(build: Builder, entries: Sequence[int], variables: Sequence[int]) -> list[Sums[int]]:
    """For each entry the steps of its derivatives by the variables, those that are not zero by construction."""
    rates = rates_of(build, entries, variables)
    seeds = {variable: {place: build.one} for place, variable in enumerate(variables)}
    forward, below = _work(build, rates, variables, set(rates))
    if forward > _work_back(build, rates, entries, variables, below):
        columns = pulled_back(build, {entry: {entry: build.one} for entry in entries}, variables, rates)
        return [{k: column[entry] for k, column in enumerate(columns) if entry in column} for entry in entries]
    found = _forward(build, rates, seeds)
    return [found.get(entry, {}) for entry in entries]


def pushed_forward(build: Builder, entries: Sequence[int], tangents: Mapping[int, int]) -> list[int]:
    """The rates of entries of the rates of variables, step by step."""
    rates = rates_of(build, entries, tangents)
    found = _forward(build, rates, {variable: {0: tangent} for variable, tangent in tangents.items()})
    return [found.get(entry, {}).get(0, build.zero) for entry in entries]


def pulled_back(
    build: Builder, seeds: Mapping[int, Sums[Key]], variables: Sequence[int], rates: Rates | None = None
) -> list[Sums[Key]]:
    """For each variable the sums over entries of their factors in the seeds times their derivatives by it."""
    rates = rates_of(build, tuple(seeds), variables) if rates is None else rates
    chosen = _below_choices(build, rates)
    by = _forward(build, {k: rates[k] for k in rates if k in chosen}, {v: {v: build.one} for v in variables})
    adjoints: dict[int, Sums[Key]] = {entry: dict(sums) for entry, sums in seeds.items()}
    for number in reversed(rates):
        rate = rates[number]
        # What is not chosen may have no value: its part is not multiplied by zero, but never taken.
        terms = by.get(number, {}).items() if build.is_choice(number) else rate.terms
        for key, adjoint in adjoints.pop(number, {}).items():
            share = adjoint if rate.divisor is None else build.divide(adjoint, rate.divisor)
            for operand, factor in terms:
                part = build.multiply(factor, share)
                sums = adjoints.setdefault(operand, {})
                if part != build.zero:
                    sums[key] = build.add(sums[key], part) if key in sums else part
    return [adjoints.get(variable, {}) for variable in variables]


def _forward(build: Builder, rates: Rates, seeds: Mapping[int, Sums[Key]]) -> dict[int, Sums[Key]]:
    found: dict[int, Sums[Key]] = dict(seeds)
    for number, rate in rates.items():
        step = build.step(number)
        if build.is_choice(number):
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
        found[number] = {k: total for k, total in sums.items() if total != build.zero or step.op in COMPARISONS}
    return found


def _of_choice(build: Builder, step: Step, found: Mapping[int, Sums[Key]]) -> Sums[Key]:
    """What has no value has no derivative by what decides on it."""
    condition, *pieces = step.operands
    valueless = [build.step(piece).op is Op.NOT_A_NUMBER for piece in pieces]
    keys = dict.fromkeys(key for k in (*pieces, *([condition] if any(valueless) else [])) for key in found.get(k, ()))

    def of(piece: int, key: Key) -> int:
        return found.get(piece, {}).get(key, build.zero) if build.step(piece).op is not Op.NOT_A_NUMBER else piece

    return {key: build.select(condition, of(pieces[0], key), of(pieces[1], key)) for key in keys}


def _below_choices(build: Builder, rates: Rates) -> set[int]:
    """The choices, and what they depend on."""
    found: set[int] = set()
    for number in reversed(rates):
        if number in found or build.is_choice(number):
            found.update((number, *(operand for operand, _ in rates[number].terms)))
    return found


def _work(
    build: Builder, rates: Rates, variables: Iterable[int], counted: Collection[int]
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
    build: Builder, rates: Rates, entries: Iterable[int], variables: Iterable[int], by: Mapping[int, int]
) -> int:
    """What it costs to go back from all entries; a choice costs its derivatives by variables."""
    total, _ = _work(build, rates, variables, _below_choices(build, rates))
    of = {entry: 1 << place for place, entry in enumerate(dict.fromkeys(entries))}
    seeds = dict(of)
    for number in reversed(rates):
        rate, bits = rates[number], of.get(number, 0)
        count = bits.bit_count()
        if build.is_choice(number):
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
