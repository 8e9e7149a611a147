"""What is divided by is kept in range: a sum of squares is that of numbers divided by the largest of them.

The squares of small numbers vanish, and those of large ones overflow, where the quotient has a value: so the numbers of
which a divisor is a form of the second degree or of a higher one are divided by their scale s first. Every step that is
homogeneous in them is s^k times the same step of the numbers divided; s^k is multiplied in where k differs between two
terms, and at the end, which it seldom reaches. Forms with a constant term do not vanish with the inputs, and stay.
Norms have long been scaled so: Blue, A portable Fortran program to find the Euclidean norm of a vector, ACM TOMS, 1978.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from dataclasses import replace as with_fields
from itertools import product

from chasles.lowering.builder import Builder
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Op, Program, Step
from chasles.lowering.scales import is_scale, scale_of

__all__ = ["all_scaled", "scaled"]

Form = tuple[int, int]
"""A power of the scale, and the step that it is multiplied by."""


_POLYNOMIAL = (Op.ADD, Op.SUBTRACT, Op.MULTIPLY, Op.NEGATE)
WORK = 100_000
"""Steps that may be looked at until all divisors are scaled; each takes as many as the program has."""
MOST_TESTS = 12
"""Choices that decide what is divided by; of more each doubles what is to be looked at."""


def scaled(program: Program) -> Program:
    """The same program, the first of its divisors that asks for it kept in range."""
    found = next(_divisors(program, _degrees(program.steps), roots=False), None)
    return program if found is None else pruned(_Scaling(program, found).program)


def all_scaled(program: Program) -> Program:
    """The same program, each divisor and each root of a sum of squares that asks for it kept in range.

    All are left as they are where the program is so long, and they are so many, that it would take too much work.
    """
    work = len(program.steps) * len(list(_divisors(program, _degrees(program.steps), roots=True)))
    if work > WORK:
        return program
    work = 0
    while work <= WORK and (found := next(_divisors(program, _degrees(program.steps), roots=True), None)) is not None:
        work += len(program.steps)
        program = pruned(_Scaling(program, found, among_others=True).program)
    return program


@dataclass(frozen=True, slots=True)
class _Divisor:
    """A step that is a form in others, its leaves; if it is `chosen` from several, it is the sum of their squares."""

    step: int
    leaves: tuple[int, ...]
    chosen: bool = False


def _divisors(program: Program, degrees: Sequence[int], *, roots: bool) -> Iterator[_Divisor]:
    """The forms of the second degree and of higher ones that are divided by, with or without a root.

    With `roots` also the sums of squares of which the root is taken, divided by or not.
    """
    steps = program.steps
    for place, step in enumerate(steps):
        if step.op is Op.DIVIDE and is_scale(steps, step.operands[1]):
            continue
        if step.op is Op.DIVIDE:
            number = step.operands[1]
            under = steps[number]
            form = under.operands[0] if under.op is Op.SQUARE_ROOT else number
            if steps[form].op is Op.SELECT:
                leaves = _chosen_leaves(program, form, number)
                if leaves:
                    yield _Divisor(form, leaves, chosen=True)
                continue
        elif roots and step.op is Op.SQUARE_ROOT and _adds_up(steps, step.operands[0]):
            form = step.operands[0]
        else:
            continue
        leaves = _leaves(steps, degrees, form)
        if degrees[form] > 1 and _vanish(steps, leaves) and form < place:
            yield _Divisor(form, leaves)


def _degrees(steps: Sequence[Step]) -> list[int]:
    """The degree of each step as a form in its leaves; 1 for a leaf."""
    found: list[int] = []
    for step in steps:
        of = [found[k] for k in step.operands]
        match step.op:
            case Op.CONSTANT:
                found.append(0)
            case Op.NEGATE:
                found.append(of[0])
            case Op.MULTIPLY:
                found.append(of[0] + of[1])
            case Op.ADD | Op.SUBTRACT:
                found.append(of[0] if of[0] == of[1] else 1)
            case Op.SQUARE_ROOT if of[0] > 1 and of[0] % 2 == 0:
                found.append(of[0] // 2)
            case _:
                found.append(1)
    return found


def _leaves(steps: Sequence[Step], degrees: Sequence[int], form: int) -> tuple[int, ...]:
    """The steps in which a form is one, each once, in the order of the program."""
    found, seen, waiting = set(), set(), [form]
    while waiting:
        number = waiting.pop()
        if number in seen:
            continue
        seen.add(number)
        step = steps[number]
        alike = step.op in (Op.ADD, Op.SUBTRACT) and all(degrees[k] == degrees[number] for k in step.operands)
        root = step.op is Op.SQUARE_ROOT and degrees[step.operands[0]] == 2 * degrees[number]
        if step.op is Op.NEGATE or (degrees[number] > 1 and (step.op is Op.MULTIPLY or alike)) or root:
            waiting += step.operands
        elif step.op is not Op.CONSTANT:
            found.add(number)
    return tuple(sorted(found))


def _vanish(steps: Sequence[Step], leaves: Sequence[int]) -> bool:
    """Whether all leaves vanish with the inputs, and so can be small at once."""
    return bool(leaves) and all(_is_linear(steps, leaf) for leaf in leaves)


def _is_linear(steps: Sequence[Step], number: int) -> bool:
    step = steps[number]
    if step.op in (Op.ADD, Op.SUBTRACT, Op.NEGATE):
        return all(_is_linear(steps, k) for k in step.operands)
    if step.op is Op.MULTIPLY:
        return steps[step.operands[0]].op is Op.CONSTANT and _is_linear(steps, step.operands[1])
    return step.op is Op.INPUT


def _chosen_leaves(program: Program, form: int, divisor: int) -> tuple[int, ...]:
    """The numerators over a chosen sum of squares of which it is the sum of squares, whichever is chosen."""
    steps = program.steps
    above = {s.operands[0] for s in steps if s.op is Op.DIVIDE and s.operands[1] == divisor}
    tests = sorted({test for k in (form, *above) for test in _tests(steps, k)})
    if len(tests) > MOST_TESTS:
        return ()
    ways = [dict(zip(tests, way, strict=True)) for way in product((True, False), repeat=len(tests))]
    chosen = [(taken, _squares(steps, _resolved(steps, form, taken))) for taken in ways if _exists(steps, form, taken)]
    if not any(_vanish(steps, squares) for _, squares in chosen):
        return ()
    leaves = tuple(sorted(k for k in above if all(_resolved(steps, k, taken) in squares for taken, squares in chosen)))
    for taken, squares in chosen:
        if sorted(squares) != sorted(_resolved(steps, k, taken) for k in leaves):
            return ()
    return leaves


def _exists(steps: Sequence[Step], number: int, taken: dict[int, bool]) -> bool:
    """Whether a selection comes to a number where the tests come out so."""
    return steps[_resolved(steps, number, taken)].op is not Op.NOT_A_NUMBER


def _tests(steps: Sequence[Step], number: int) -> Iterator[int]:
    step = steps[number]
    if step.op is Op.SELECT:
        yield step.operands[0]
        for k in step.operands[1:]:
            yield from _tests(steps, k)


def _resolved(steps: Sequence[Step], number: int, taken: dict[int, bool]) -> int:
    """What a selection comes to where the tests come out so."""
    while steps[number].op is Op.SELECT:
        test, one, other = steps[number].operands
        number = one if taken[test] else other
    return number


def _squares(steps: Sequence[Step], number: int) -> list[int]:
    """The steps of which a step is the sum of squares; none if it is no such sum."""
    step = steps[number]
    if step.op is Op.MULTIPLY and step.operands[0] == step.operands[1]:
        return [step.operands[0]]
    if step.op is not Op.ADD:
        return []
    one, other = (_squares(steps, k) for k in step.operands)
    return [*one, *other] if one and other else []


def _adds_up(steps: Sequence[Step], number: int) -> bool:
    """Whether a step is a sum of positive multiples of squares, which vanishes with what is squared and not before."""
    step = steps[number]
    if step.op is Op.ADD:
        return all(_adds_up(steps, k) for k in step.operands)
    if step.op is not Op.MULTIPLY:
        return False
    one, other = step.operands
    return one == other or (steps[one].op is Op.CONSTANT and steps[one].value > 0 and _adds_up(steps, other))


class _Scaling:
    """The program anew: each step plain, or as a power of the scale times a step, or both."""

    def __init__(self, program: Program, divisor: _Divisor, *, among_others: bool = False) -> None:
        self._among_others = among_others
        self._steps, self._divisor = program.steps, divisor
        self._build = Builder()
        self._place: dict[int, int] = {}
        self._forms: dict[int, Form] = {}
        self._bound: set[int] = set()
        self._scale = -1
        for number, step in enumerate(program.steps):
            self._read(number, step)
        results = tuple(with_fields(r, entries=tuple(map(self._plain, r.entries))) for r in program.results)
        self.program = with_fields(program, steps=self._build.steps, results=results)

    def _read(self, number: int, step: Step) -> None:
        """Put a step into the new program; those that the divisor enters are bound to their form."""
        if number == self._divisor.step:
            self._bound.add(number)
            self._forms[number] = self._form_of_divisor(step)
            return
        if self._bound.isdisjoint(step.operands):
            self._place[number] = self._build.like(step, [self._place[k] for k in step.operands])
            form = self._combined(step)
            if number in self._divisor.leaves:
                self._forms[number] = 1, self._divided(number)
            elif form is not None and form[0]:
                self._forms[number] = form
            return
        self._bound.add(number)
        form = self._combined(step)
        self._forms[number] = form or (0, self._build.like(step, [self._plain(k) for k in step.operands]))

    def _form_of_divisor(self, step: Step) -> Form:
        for leaf in self._divisor.leaves:
            if leaf not in self._forms:
                self._forms[leaf] = 1, self._divided(leaf)
        if not self._divisor.chosen:
            form = self._combined(step)
            assert form is not None
            return form if _adds_up(self._steps, self._divisor.step) else (form[0], self._guarded(step, form[1]))
        build, (first, *rest) = self._build, (self._forms[leaf][1] for leaf in self._divisor.leaves)
        total = build.multiply(first, first)
        for other in rest:
            total = build.add(total, build.multiply(other, other))
        return 2, total

    def _guarded(self, step: Step, held: int) -> int:
        """Zero where the form itself is: the numbers divided are rounded, and what cancels may no longer do so."""
        build = self._build
        for k in step.operands:
            if k not in self._place:
                self._place_all(k)
        plain = build.like(step, [self._place[k] for k in step.operands])
        return build.select(build.equal(plain, build.zero), build.zero, held)

    def _divided(self, leaf: int) -> int:
        if self._scale < 0:
            for number in self._divisor.leaves:
                if number not in self._place:
                    self._place_all(number)
            self._scale = scale_of(self._build, [self._place[k] for k in self._divisor.leaves])
        return self._build.divide(self._place[leaf], self._scale)

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
        if number not in self._place and self._among_others and step.op in _POLYNOMIAL:
            # Other divisors are made of the step too, and what overflows in it would do so in the power of the scale.
            self._place[number] = self._build.like(step, [self._plain(k) for k in step.operands])
        if number not in self._place:
            power, held = self._forms[number]
            for _ in range(abs(power)):
                held = self._build.multiply(self._scale, held) if power > 0 else self._build.divide(held, self._scale)
            self._place[number] = held
        return self._place[number]

    def _form(self, number: int) -> Form:
        return self._forms.get(number) or (0, self._place[number])

    def _combined(self, step: Step) -> Form | None:
        """The step as a power of the scale times one; None where it is none, or where none of its operands is."""
        if not any(k in self._forms for k in step.operands):
            return None
        build, forms = self._build, [self._form(k) for k in step.operands]
        powers, held = [power for power, _ in forms], [k for _, k in forms]
        match step.op:
            case Op.MULTIPLY:
                return self._product(step)
            case Op.DIVIDE:
                return powers[0] - powers[1], build.divide(*held)
            case Op.ADD | Op.SUBTRACT if powers[0] == powers[1]:
                return powers[0], build.like(step, held)
            case Op.NEGATE:
                return powers[0], build.negate(held[0])
            case Op.SQUARE_ROOT if powers[0] % 2 == 0:
                return powers[0] // 2, build.square_root(held[0])
            case Op.SELECT if powers[1] == powers[2] and not powers[0]:
                return powers[1], build.select(*held)
            case _:
                return None

    def _product(self, step: Step) -> Form:
        """A factor that the divisor does not enter is taken as it is, unless its form lowers the power of the other."""
        one, other = step.operands
        forms = [self._form(k) for k in (one, other)]
        for mine, its in ((0, 1), (1, 0)):
            free, bound = step.operands[mine], step.operands[its]
            power = forms[its][0]
            if free not in self._bound and bound in self._bound and abs(power + forms[mine][0]) >= abs(power):
                forms[mine] = 0, self._place[free]
        return forms[0][0] + forms[1][0], self._build.multiply(forms[0][1], forms[1][1])
