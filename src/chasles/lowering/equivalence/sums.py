"""Programs that differ in the order, the grouping and the signs of sums and products alone: told in one pass over both.

A value is a sum of products with exact numbers in front; factors are inputs, values of functions, and sums, the first
number of which is taken out. Nothing is multiplied out and nothing cancelled but in sums, so that the work grows with
the programs. Such normal forms of expressions with shared parts are those of value numbering (Click, Global Code
Motion, Global Value Numbering, 1995).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from fractions import Fraction

from chasles.lowering.program import Op, Program, Step

MOST_TERMS = 3_000_000
"""So many terms are added at most, for all steps together; nothing is said of programs that take more."""

Product = tuple[tuple[int, int], ...]
"""Factors with their powers, in the order of factors; divisors are factors of their own, with negative numbers."""
Total = dict[Product, Fraction]


def same_but_for_order(one: Program, other: Program) -> bool:
    """Whether all results are the same sums of the same products; where they are not it is not known."""
    forms = _Forms()
    try:
        return forms.results(one) == forms.results(other)
    except OverflowError:
        return False


class _Forms:
    """Normal forms; factors are numbered from 1 as they are met, by what they are."""

    def __init__(self) -> None:
        self._numbers: dict[object, int] = {}
        self._terms = 0

    def results(self, program: Program) -> list[tuple[object, ...]]:
        """What each result holds."""
        values: list[Total] = []
        uses = Counter(k for step in program.steps for k in step.operands)
        uses.update(entry for result in program.results for entry in result.entries)
        for step in program.steps:
            operands = [values[k] for k in step.operands]
            if step.op in (Op.ADD, Op.SUBTRACT):
                values.append(self._sum(operands, step.op, [uses[k] == 1 for k in step.operands]))
            else:
                values.append(self._value(step, operands))
                self._terms += len(values[-1])
            if self._terms > MOST_TERMS:
                raise OverflowError
        return [
            (result.name, result.shape, tuple(_key(values[entry]) for entry in result.entries))
            for result in program.results
        ]

    def _value(self, step: Step, operands: list[Total]) -> Total:
        match step.op:
            case Op.CONSTANT:
                return {(): step.value} if step.value else {}
            case Op.NEGATE:
                return _scaled(operands[0], Fraction(-1))
            case Op.MULTIPLY | Op.DIVIDE:
                return self._product(operands[0], operands[1], 1 if step.op is Op.MULTIPLY else -1)
            case Op.SINE | Op.COSINE:
                first = _first(operands[0])
                turned = _scaled(operands[0], Fraction(-1)) if first < 0 else operands[0]
                sign = Fraction(-1 if first < 0 and step.op is Op.SINE else 1)
                return {((self._number((step.op, _key(turned))), 1),): sign}
        what = (step.op, step.argument, step.entry, step.value, getattr(step, "function", ""))
        return {((self._number((what, *map(_key, operands))), 1),): Fraction(1)}

    def _sum(self, terms: Sequence[Total], op: Op, alone: Sequence[bool]) -> Total:
        """The sum, or the difference; the longer of the two is not copied where nothing else reads it."""
        (a, b), sign = terms, Fraction(1 if op is Op.ADD else -1)
        longer = int(len(b) > len(a))
        one, other, factor = (b, a, Fraction(1)) if longer else (a, b, sign)
        self._terms += len(other) + (0 if alone[longer] and sign == 1 else len(one))
        if longer and sign < 0:
            one = _scaled(one, sign)
        elif not alone[longer]:
            one = dict(one)
        for product, number in other.items():
            value = one.get(product, Fraction(0)) + factor * number
            if value:
                one[product] = value
            else:
                one.pop(product, None)
        return one

    def _product(self, a: Total, b: Total, power: int) -> Total:
        """The product a b, or the quotient a / b. Constants are multiplied into sums, other sums are factors."""
        for value, other in ((b, a), (a, b)):
            if set(value) <= {()} and (power > 0 or (value is b and value)):
                factor = value.get((), Fraction(0))
                return _scaled(other, factor**power) if factor else {}
        (x, left), (y, right) = self._single(a), self._single(b)
        if not x or not y:
            return {((self._number(("quotient", x, left, y, right)), 1),): Fraction(1)} if power < 0 else {}
        powers = dict(left)
        for number, times in right:
            powers[power * number] = powers.get(power * number, 0) + times
        return {tuple(sorted(powers.items())): x * y**power}

    def _single(self, total: Total) -> tuple[Fraction, Product]:
        """The value as a number times a product; a sum is a factor, its first number taken out."""
        if len(total) == 1:
            [(product, number)] = total.items()
            return number, product
        if not total:
            return Fraction(0), ()
        first = _first(total)
        return first, ((self._number(("sum", _key(_scaled(total, 1 / first)))), 1),)

    def _number(self, what: object) -> int:
        return self._numbers.setdefault(what, len(self._numbers) + 1)


def _key(total: Total) -> tuple[tuple[Product, Fraction], ...]:
    return tuple(sorted(total.items()))


def _first(total: Total) -> Fraction:
    return total[min(total)] if total else Fraction(0)


def _scaled(total: Total, factor: Fraction) -> Total:
    return {product: factor * number for product, number in total.items()}
