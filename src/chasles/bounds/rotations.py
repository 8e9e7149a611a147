"""What are sums of a rotation's entries? Polynomials in a quaternion, enclosed without what cancels in them.

A rotation's entries are quadratic in a quaternion (w, x, y, z), over its square; 1 + 2 Q_11 - tr(Q) is 4 x^2 over it,
and so is never near zero where x is the largest component.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import product
from typing import Any

import numpy as np

from chasles.bounds.intervals import Array, Interval, exactly
from chasles.bounds.outline import Outline
from chasles.lowering.program import Op


@cache
def _ring() -> tuple[Any, Any]:
    """The polynomials in a quaternion's components, and its square."""
    # SymPy takes longer to start than what needs no rotations takes in all.
    from sympy import QQ, ring

    polynomials = ring("w,x,y,z", QQ)[0]
    return polynomials, sum((part**2 for part in polynomials.gens), polynomials.zero)


@dataclass(frozen=True, slots=True)
class QuaternionFraction:
    """A polynomial in the quaternion's components, over a power of its square."""

    above: Any
    power: int

    @property
    def reduced(self) -> QuaternionFraction:
        """The same with what the polynomial and the power have in common left out."""
        (above, power), (_, square) = (self.above, self.power), _ring()
        while power:
            quotient, rest = divmod(above, square)
            if rest:
                break
            above, power = quotient, power - 1
        return QuaternionFraction(above, power)


def forms(outline: Outline, argument: int) -> dict[int, QuaternionFraction]:
    """The steps that are polynomials in a rotation's entries, by their numbers."""
    entries, (ring, _) = _entries(), _ring()
    found: dict[int, QuaternionFraction] = {}
    for number in outline.needed:
        step = outline.program.steps[number]
        of = [found.get(k) for k in outline.operands(number)]
        if step.op is Op.INPUT and step.argument == argument:
            found[number] = QuaternionFraction(entries[step.entry], 1)
        elif step.op is Op.CONSTANT:
            found[number] = QuaternionFraction(ring(ring.domain(step.value.numerator, step.value.denominator)), 0)
        elif of and all(form is not None for form in of):
            made = _made(step.op, [form for form in of if form is not None])
            if made is not None:
                found[number] = made.reduced
    return found


def _made(op: Op, of: list[QuaternionFraction]) -> QuaternionFraction | None:
    match op:
        case Op.NEGATE:
            return QuaternionFraction(-of[0].above, of[0].power)
        case Op.MULTIPLY:
            return QuaternionFraction(of[0].above * of[1].above, of[0].power + of[1].power)
        case Op.ADD | Op.SUBTRACT:
            power = max(form.power for form in of)
            a, b = (form.above * _ring()[1] ** (power - form.power) for form in of)
            return QuaternionFraction(a + b if op is Op.ADD else a - b, power)
        case _:
            return None


def _entries() -> list[Any]:
    """The entries of the rotation by a quaternion, times its square."""
    ring, _ = _ring()
    w, *vector = ring.gens
    found = []
    for i, j in product(range(3), repeat=2):
        if i == j:
            others = [vector[k] ** 2 for k in range(3) if k != i]
            found.append(w**2 + vector[i] ** 2 - sum(others, ring.zero))
        else:
            turned = 2 * w * vector[3 - i - j]
            found.append(2 * vector[i] * vector[j] + (turned if (j - i) % 3 == 2 else -turned))
    return found


def enclosed_forms(found: Mapping[int, QuaternionFraction], parts: list[Interval], like: Array) -> dict[int, Interval]:
    """What the forms run over where the quaternion's components run over intervals."""
    square = parts[0].squared + parts[1].squared + parts[2].squared + parts[3].squared
    return {number: _enclosed(form, parts, square, like) for number, form in found.items()}


def _enclosed(form: QuaternionFraction, parts: list[Interval], square: Interval, like: Array) -> Interval:
    total = Interval(like * 0, like * 0)
    for exponents, coefficient in form.above.terms():
        term = exactly(Fraction(int(coefficient.numerator), int(coefficient.denominator)), like)
        for part, exponent in zip(parts, exponents, strict=True):
            for _ in range(exponent // 2):
                term = term * part.squared
            term = term * part if exponent % 2 else term
        total = total + term
    for _ in range(form.power):
        total = total / square
    if form.above == 0:
        return Interval(np.zeros_like(like), np.zeros_like(like))
    return total
