"""Coefficients that depend on one angle alone are written anew, by cosine and sine of the angle or of its half.

In the half-angle 1 - cos(phi) is 2 sin^2(phi/2) and sin(phi)/(1 - cos(phi)) is cot(phi/2): what cancels in the formula
cancels before anything is rounded (Higham, Accuracy and Stability of Numerical Algorithms, 2002, section 1.7).
"""

from __future__ import annotations

from dataclasses import replace as with_fields
from fractions import Fraction
from math import gcd, isqrt, lcm

from chasles.lowering.arithmetic import Operators, applied
from chasles.lowering.builder import Builder
from chasles.lowering.circular import Circular, constant, multiple_of_angle
from chasles.lowering.program import Op, Program, Step

Value = tuple[int | None, Circular]
"""A function of the angle that a step holds; of none, if it is a number."""
RATIONAL = (Op.ADD, Op.SUBTRACT, Op.MULTIPLY, Op.NEGATE, Op.DIVIDE)
ONE = (((0, 0), Fraction(1)),)


def respelled(program: Program, *, halved: bool) -> Program:
    """The same program with functions of one angle in lowest terms; in those of half the angle, if `halved`."""
    values = _values(program, halved=halved)
    spelling = _Spelling(values, _units(program, halved=halved))
    for number, step in enumerate(program.steps):
        if values[number] is None or step.op is Op.CONSTANT:
            operands = [spelling.of(k) for k in step.operands]
            spelling.place[number] = spelling.builder.like(step, operands)
    entries = {entry for result in program.results for entry in result.entries}
    place = {entry: spelling.of(entry) for entry in sorted(entries)}
    results = tuple(with_fields(r, entries=tuple(place[k] for k in r.entries)) for r in program.results)
    return with_fields(program, steps=spelling.builder.steps, results=results)


def _angle_of(program: Program, number: int) -> tuple[int, Fraction]:
    """The step of which a step is a multiple, and which multiple it is."""
    step = program.steps[number]
    match step.op:
        case Op.NEGATE:
            angle, times = _angle_of(program, step.operands[0])
            return angle, -times
        case Op.MULTIPLY | Op.DIVIDE:
            first, second = (program.steps[k] for k in step.operands)
            if step.op is Op.MULTIPLY and first.is_number and first.value:
                angle, times = _angle_of(program, step.operands[1])
                return angle, first.value * times
            if second.is_number and second.value:
                angle, times = _angle_of(program, step.operands[0])
                return angle, times * second.value if step.op is Op.MULTIPLY else times / second.value
    return number, Fraction(1)


def _units(program: Program, *, halved: bool) -> dict[int, Fraction]:
    """For each angle the multiple of it by whose cosine and sine everything is written."""
    units: dict[int, Fraction] = {}
    for step in program.steps:
        if step.op in (Op.SINE, Op.COSINE):
            angle, times = _angle_of(program, step.operands[0])
            old, new = units.get(angle, abs(times)), abs(times)
            units[angle] = Fraction(gcd(old.numerator, new.numerator), lcm(old.denominator, new.denominator))
    return {angle: unit / 2 if halved else unit for angle, unit in units.items()}


def _values(program: Program, *, halved: bool) -> list[Value | None]:
    """Of each step, the function of one angle that it is."""
    units = _units(program, halved=halved)
    values: list[Value | None] = []
    for step in program.steps:
        known = [values[k] for k in step.operands]
        if step.is_number:
            values.append((None, constant(step.value)))
        elif step.op in (Op.SINE, Op.COSINE):
            angle, times = _angle_of(program, step.operands[0])
            cosine, sine = multiple_of_angle(int(times / units[angle]))
            values.append((angle, cosine if step.op is Op.COSINE else sine))
        else:
            values.append(_combined(step, [value for value in known if value is not None], len(known)))
    return values


def _combined(step: Step, known: list[Value], arity: int) -> Value | None:
    angles = {angle for angle, _ in known if angle is not None}
    if len(known) < arity or not known or len(angles) > 1:
        return None
    angle, parts = next(iter(angles), None), [part for _, part in known]
    if step.op not in RATIONAL or (step.op is Op.DIVIDE and not parts[1].above):
        return None
    return angle, applied(Operators(), step, parts)


class _Spelling:
    """The steps of functions of an angle, as they are asked for."""

    def __init__(self, values: list[Value | None], units: dict[int, Fraction]) -> None:
        self.builder = Builder()
        self.place: dict[int, int] = {}
        self._values = values
        self._units = units

    def of(self, number: int) -> int:
        """The new step that holds what a step of the program holds."""
        value = self._values[number]
        if value is None or number in self.place:
            return self.place[number]
        angle, function = value
        if angle is None or function.is_constant:
            return self.builder.constant(function.above[0][1] if function.above else 0)
        turned = self.builder.multiply(self.builder.constant(self._units[angle]), self.of(angle))
        return self._function(function, turned)

    def _function(self, function: Circular, angle: int) -> int:
        (i, j), build = function.powers, self.builder
        if function.below != ONE:
            above = Circular((max(i, 0), max(j, 0)), function.above, ONE)
            below = Circular((max(-i, 0), max(-j, 0)), function.below, ONE)
            return build.divide(self._function(above, angle), self._function(below, angle))
        if len(function.above) == 1 or i < 0 or j < 0:
            terms = [self._monomial(i + k, j + m, q, angle) for (k, m), q in function.above]
            return self._sum(terms)
        terms = [self._monomial(k, m, q, angle) for (k, m), q in function.above]
        return build.multiply(self._monomial(i, j, Fraction(1), angle), self._sum(terms))

    def _sum(self, terms: list[int]) -> int:
        total = self.builder.zero
        for term in terms:
            total = self.builder.add(total, term)
        return total

    def _monomial(self, i: int, j: int, q: Fraction, angle: int) -> int:
        """The term q sine^i cosine^j; what is divided by is divided by once, and powers are taken of the quotient."""
        build, (s, c) = self.builder, (self._sine(angle, i), self._cosine(angle, j))
        if i < 0 or j < 0:
            (x, m), (y, n) = ((s, -i), (c, j)) if i < 0 else ((c, -j), (s, i))
            if n < 0:
                return self._times(q, build.divide(build.one, build.multiply(self._power(s, -i), self._power(c, -j))))
            both = min(m, n)
            if both:
                quotient = self._power(build.divide(y, x), both)
                rest = build.multiply(self._reciprocal(x, m - both, Fraction(1)), self._power(y, n - both))
                return self._times(q, build.multiply(quotient, rest))
            return self._reciprocal(x, m, q)
        return self._times(q, build.multiply(self._power(s, i), self._power(c, j)))

    def _sine(self, angle: int, power: int) -> int:
        return self.builder.sine(angle) if power else self.builder.one

    def _cosine(self, angle: int, power: int) -> int:
        return self.builder.cosine(angle) if power else self.builder.one

    def _times(self, q: Fraction, step: int) -> int:
        return self.builder.multiply(self.builder.constant(q), step)

    def _power(self, step: int, exponent: int) -> int:
        total = self.builder.one
        for _ in range(exponent):
            total = self.builder.multiply(total, step)
        return total

    def _reciprocal(self, step: int, exponent: int, q: Fraction) -> int:
        """The term q / step^exponent, by the reciprocal: its square is in range where that of the step is not."""
        if not exponent:
            return self.builder.constant(q)
        if exponent == 1:
            return self.builder.divide(self.builder.constant(q), step)
        root = Fraction(isqrt(abs(q.numerator)), isqrt(q.denominator))
        if exponent == 2 and root * root == abs(q):
            square = self._power(self.builder.divide(self.builder.constant(root), step), 2)
            return square if q > 0 else self.builder.negate(square)
        return self._times(q, self._power(self.builder.divide(self.builder.one, step), exponent))
