"""What is divided by is kept in range: a sum of squares is that of numbers divided by the largest of them.

The squares of small numbers vanish, and those of large ones overflow, where the quotient has a value: so the numbers of
which a divisor is a form of the second degree or of a higher one are divided by their scale s first. Every step that is
homogeneous in them is s^k times the same step of the numbers divided; s^k is multiplied in where k differs between two
terms, and at the end, which it seldom reaches. Forms with a constant term do not vanish with the inputs, but overflow:
of a root of a sum of squares and positive constants the scale is 1 as long as the numbers are not large. Norms have
long been scaled so: Blue, A portable Fortran program to find the Euclidean norm of a vector, ACM TOMS, 1978.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace as with_fields
from fractions import Fraction

from chasles.lowering.builder import Builder
from chasles.lowering.forms import Divisor, adds_up, divisors
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Op, Program, Step
from chasles.lowering.scales import large_scale_of, scale_of

Powers = dict[int, int]
"""Of which scales, by the places of their divisors, and which: none is zero."""
Form = tuple[Powers, int]
"""Powers of scales, and the step that they are multiplied by."""


_POLYNOMIAL = (Op.ADD, Op.SUBTRACT, Op.MULTIPLY, Op.NEGATE)
WORK = 100_000
"""Steps times divisors up to which divisors are scaled: that what comes out is the same is proved one by one."""
MARGIN = Fraction(1, 2**26)
"""Numbers of which the products are not zero even if they are smaller by so much have products with all digits."""


def scaled(program: Program) -> Program:
    """The same program, the first of its divisors that asks for it kept in range."""
    found = next(divisors(program, roots=False), None)
    return program if found is None else pruned(_Scaling(program, [found]).program)


def all_scaled(program: Program) -> Program:
    """The same program, each divisor and each root of a sum of squares that asks for it kept in range.

    All are left as they are where the program is so long, and they are so many, that it would take too much work.
    """
    if len(program.steps) * len(list(divisors(program, roots=True))) > WORK:
        return program
    while found := _apart(divisors(program, roots=True)):
        program = pruned(_Scaling(program, found, among_others=True).program)
    return program


def _apart(found: Iterable[Divisor]) -> list[Divisor]:
    """The first of the divisors, and those that share no number with others: these are scaled at once.

    A chosen one is scaled alone: what it is chosen from may depend on others.
    """
    apart: list[Divisor] = []
    leaves: set[int] = set()
    for divisor in found:
        if divisor.chosen:
            return apart or [divisor]
        if leaves.isdisjoint(divisor.leaves):
            apart.append(divisor)
            leaves.update(divisor.leaves)
    return apart


class _Scaling:
    """The program anew: each step plain, or as powers of scales times a step, or both."""

    def __init__(self, program: Program, apart: Sequence[Divisor], *, among_others: bool = False) -> None:
        self._among_others = among_others
        self._steps, self._apart = program.steps, apart
        self._divisors = {divisor.step: place for place, divisor in enumerate(apart)}
        self._leaves = {leaf: place for place, divisor in enumerate(apart) for leaf in divisor.leaves}
        self._build = Builder()
        self._place: dict[int, int] = {}
        self._forms: dict[int, Form] = {}
        self._bound: set[int] = set()
        self._copies: set[int] = set()
        self._scales: dict[int, int] = {}
        for number, step in enumerate(program.steps):
            self._read(number, step)
        results = tuple(with_fields(r, entries=tuple(map(self._plain, r.entries))) for r in program.results)
        self.program = with_fields(program, steps=self._build.steps, results=results)

    def _read(self, number: int, step: Step) -> None:
        """Put a step into the new program; those that a divisor enters are bound to their form."""
        if number in self._divisors:
            self._bound.add(number)
            self._forms[number] = self._form_of_divisor(self._divisors[number], step)
            return
        if self._bound.isdisjoint(step.operands):
            self._place[number] = self._copied(number, step)
            form = self._combined(step)
            if number in self._leaves:
                self._forms[number] = self._divided(number)
            elif form is not None and form[0]:
                self._forms[number] = form
            return
        self._bound.add(number)
        form = self._combined(step)
        self._forms[number] = form or ({}, self._build.like(step, [self._plain(k) for k in step.operands]))

    def _copied(self, number: int, step: Step) -> int:
        """A step that no divisor enters; most of them only do what they did on copies of their operands."""
        operands = [self._place[k] for k in step.operands]
        if not self._copies.issuperset(step.operands):
            return self._build.like(step, operands)
        self._copies.add(number)
        return self._build.copied(step, operands)

    def _form_of_divisor(self, place: int, step: Step) -> Form:
        divisor = self._apart[place]
        for leaf in divisor.leaves:
            if leaf not in self._forms:
                self._forms[leaf] = self._divided(leaf)
        if divisor.constants:
            return {place: 2}, self._with_constants(divisor.step, place)
        if not divisor.chosen:
            form = self._combined(step)
            assert form is not None
            powers, held = form
            return form if adds_up(self._steps, divisor.step) else (powers, self._guarded(step, place, powers, held))
        build, (first, *rest) = self._build, (self._forms[leaf][1] for leaf in divisor.leaves)
        total = build.multiply(first, first)
        for other in rest:
            total = build.add(total, build.multiply(other, other))
        return {place: 2}, total

    def _with_constants(self, number: int, place: int) -> int:
        """The sum over the square of the scale."""
        build, step = self._build, self._steps[number]
        if step.op is Op.CONSTANT:
            inverse = self._over_scale(build.one, place)
            return build.multiply(build.constant(step.value), build.multiply(inverse, inverse))
        one, other = step.operands
        if step.op is Op.ADD:
            return build.add(self._with_constants(one, place), self._with_constants(other, place))
        if one == other:
            return build.multiply(self._forms[one][1], self._forms[one][1])
        return build.multiply(build.constant(self._steps[one].value), self._with_constants(other, place))

    def _guarded(self, step: Step, place: int, powers: Powers, held: int) -> int:
        """Zero where the form itself is: the numbers divided are rounded, and what cancels may no longer do so.

        Numbers so small that their products vanish are left alone: the form itself is zero whatever they are.
        """
        build = self._build
        for k in step.operands:
            if k not in self._place:
                self._place_all(k)
        plain = build.like(step, [self._place[k] for k in step.operands])
        guarded = build.select(build.equal(plain, build.zero), build.zero, held)
        if not self._among_others:
            # The one divisor of a kernel whose error is bounded for all inputs: it must not depend on what vanishes.
            return guarded
        product = small = build.multiply(build.constant(MARGIN), self._scales[place])
        for _ in range(powers[place] - 1):
            product = build.multiply(product, small)
        return build.select(build.equal(product, build.zero), held, guarded)

    def _divided(self, leaf: int) -> Form:
        place = self._leaves[leaf]
        if place not in self._scales:
            divisor = self._apart[place]
            for number in divisor.leaves:
                if number not in self._place:
                    self._place_all(number)
            numbers = [self._place[k] for k in divisor.leaves]
            self._scales[place] = (large_scale_of if divisor.constants else scale_of)(self._build, numbers)
        return {place: 1}, self._over_scale(self._place[leaf], place)

    def _over_scale(self, number: int, place: int) -> int:
        """The number over the scale; by one that is mostly 1 it is divided once, and its reciprocal multiplied by."""
        if not self._apart[place].constants:
            return self._build.divide(number, self._scales[place])
        return self._build.multiply(self._inverse(place), number)

    def _inverse(self, place: int) -> int:
        return self._build.divide(self._build.one, self._scales[place])

    def _place_all(self, number: int) -> None:
        """Place a step before its turn, with all that it needs."""
        step = self._steps[number]
        for k in step.operands:
            if k not in self._place:
                self._place_all(k)
        self._place[number] = self._build.like(step, [self._place[k] for k in step.operands])

    def _plain(self, number: int) -> int:
        """The step itself."""
        step = self._steps[number]
        if number not in self._place and self._among_others and self._is_polynomial(number):
            # Other divisors are made of the step too, and what overflows in it would do so in the power of the scale.
            self._place[number] = self._build.like(step, [self._plain(k) for k in step.operands])
        if number not in self._place:
            powers, held = self._forms[number]
            for place, power in powers.items():
                held = self._unscaled(held, place, power)
            self._place[number] = held
        return self._place[number]

    def _unscaled(self, held: int, place: int, power: int) -> int:
        for _ in range(abs(power)):
            if power > 0:
                held = self._build.multiply(self._scales[place], held)
            elif self._among_others:
                held = self._build.multiply(self._inverse(place), held)
            else:
                held = self._build.divide(held, self._scales[place])
        return held

    def _is_polynomial(self, number: int) -> bool:
        """Whether a step vanishes with the leaves, and is no multiple of what grows as they vanish."""
        step = self._steps[number]
        own = self._forms[number][0].values()
        powers = [power for k in step.operands if k in self._forms for power in self._form(k)[0].values()]
        return step.op in _POLYNOMIAL and bool(own) and min(own) > 0 and all(power > 0 for power in powers)

    def _form(self, number: int) -> Form:
        return self._forms.get(number) or ({}, self._place[number])

    def _combined(self, step: Step) -> Form | None:
        """The step as powers of scales times one; None where it is none, or where none of its operands is."""
        if not any(k in self._forms for k in step.operands):
            return None
        build, forms = self._build, [self._form(k) for k in step.operands]
        powers, held = [power for power, _ in forms], [k for _, k in forms]
        match step.op:
            case Op.MULTIPLY:
                return self._product(step)
            case Op.DIVIDE:
                return _sum(powers[0], powers[1], -1), build.divide(*held)
            case Op.ADD | Op.SUBTRACT if powers[0] == powers[1]:
                return powers[0], build.like(step, held)
            case Op.NEGATE:
                return powers[0], build.negate(held[0])
            case Op.SQUARE_ROOT if all(power % 2 == 0 for power in powers[0].values()):
                return {place: power // 2 for place, power in powers[0].items()}, build.square_root(held[0])
            case Op.SELECT if powers[1] == powers[2] and not powers[0]:
                return powers[1], build.select(*held)
            case _:
                return None

    def _product(self, step: Step) -> Form:
        """A factor that no divisor enters is taken as it is, unless its form lowers the powers of the other."""
        one, other = step.operands
        forms = [self._form(k) for k in (one, other)]
        for mine, its in ((0, 1), (1, 0)):
            free, bound = step.operands[mine], step.operands[its]
            powers = forms[its][0]
            lowers = _size(_sum(powers, forms[mine][0])) < _size(powers)
            if free not in self._bound and bound in self._bound and not lowers:
                forms[mine] = {}, self._place[free]
        return _sum(forms[0][0], forms[1][0]), self._build.multiply(forms[0][1], forms[1][1])


def _sum(one: Powers, other: Powers, sign: int = 1) -> Powers:
    places = sorted({*one, *other})
    sums = ((place, one.get(place, 0) + sign * other.get(place, 0)) for place in places)
    return {place: power for place, power in sums if power}


def _size(powers: Powers) -> int:
    return sum(map(abs, powers.values()))
