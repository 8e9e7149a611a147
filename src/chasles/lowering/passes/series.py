"""The functions of Stumpff in operations: a polynomial where the angle is small, beyond it a quotient.

c_k is (1/(k - 2)! - c_(k-2)) / a^2, from the cosine and the sine over the angle on.
"""

from __future__ import annotations

from dataclasses import replace as with_fields
from fractions import Fraction
from math import factorial

from chasles.lowering.builder import Builder
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Op, Program

_ENOUGH = Fraction(1, 2**57)
"""What is left out of a polynomial, in parts of its first term."""


def expanded_in_series(program: Program, most: int | None = None) -> Program:
    """The same program to within a few roundoffs, without functions that no language has.

    Exactly the same where none beyond the order `most` = 2 is expanded, for which no polynomial is needed.
    """
    if not any(step.function == "stumpff" for step in program.steps):
        return program
    build = Builder()
    place: list[int] = []
    for step in program.steps:
        operands = [place[k] for k in step.operands]
        if step.function == "stumpff":
            order = build.value(operands[0])
            assert order is not None
            assert order >= 0
            known = most is None or order <= most
            place.append(_stumpff(build, int(order), operands[1]) if known else build.like(step, operands))
        else:
            place.append(build.like(step, operands))
    results = tuple(with_fields(r, entries=tuple(place[k] for k in r.entries)) for r in program.results)
    return pruned(with_fields(program, steps=build.steps, results=results))


def _stumpff(build: Builder, order: int, angle: int) -> int:
    if order == 0:
        return build.cosine(angle)
    if order == 1:
        is_zero = build.equal(angle, build.zero)
        above, below = (build.select(is_zero, build.one, k) for k in (build.sine(angle), angle))
        return build.divide(above, below)
    half = build.constant(Fraction(1, 2))
    if order == 2:
        root = _stumpff(build, 1, build.multiply(half, angle))
        return build.multiply(half, build.multiply(root, root))
    of = build.step(angle)
    square = of.operands[0] if of.op is Op.SQUARE_ROOT else build.multiply(angle, angle)
    lower = _stumpff(build, order - 2, angle)
    far = build.divide(build.subtract(build.constant(Fraction(1, factorial(order - 2))), lower), square)
    limit = Fraction(3 * order)
    return build.select(build.less(square, build.constant(limit)), _polynomial(build, order, square, limit), far)


def _polynomial(build: Builder, order: int, square: int, limit: Fraction) -> int:
    """The first terms of the series, by Horner's scheme: as many as count below the limit."""
    terms = 1
    while limit**terms * factorial(order) > _ENOUGH * factorial(2 * terms + order):
        terms += 1
    total = build.zero
    for n in reversed(range(terms)):
        total = build.multiply(square, total)
        total = build.add(build.constant(Fraction((-1) ** n, factorial(2 * n + order))), total)
    return total
