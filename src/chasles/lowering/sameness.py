"""Are two programs the same function? Both are read as fractions in what goes in and compared exactly.

Cosines and sines of one angle are polynomials in those of a part of it, modulo cos^2 + sin^2 = 1; a root's square is
what stands under it. Of every other function it is known only that like arguments give like values. So what is said to
be the same is; what is not said to be may yet be.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from fractions import Fraction
from math import gcd

from chasles.algebra.normal_form import reduce_by
from chasles.algebra.rings import Polynomial, Ring, make_ring
from chasles.lowering.circular import Polynomial as Turned
from chasles.lowering.circular import multiple_of_angle
from chasles.lowering.passes.angles import angle_of
from chasles.lowering.program import Op, Program, Step

__all__ = ["same"]

MOST_PRODUCTS = 100_000
"""Products of terms in one multiplication; what needs more is not said to be the same."""
MOST_TURNS = 12
"""So many times the part is an angle still written by it."""
_TURNS = (Op.SINE, Op.COSINE)
_ARITHMETIC = (Op.INPUT, Op.CONSTANT, Op.ADD, Op.SUBTRACT, Op.MULTIPLY, Op.DIVIDE, Op.NEGATE, *_TURNS)


def same(one: Program, other: Program) -> bool:
    """Whether the results of the two are equal wherever both have values; no is also said where that is not seen."""
    if [r.shape for r in one.results] != [r.shape for r in other.results]:
        return False
    algebra = _Algebra((one, other))
    try:
        values = [algebra.values(program) for program in (one, other)]
        pairs = [
            (values[0][a], values[1][b])
            for r, s in zip(one.results, other.results, strict=True)
            for a, b in zip(r.entries, s.entries, strict=True)
        ]
        return all(algebra.is_equal(a, b) for a, b in dict.fromkeys(pairs))
    except _TooLarge:
        return False


class _TooLarge(Exception):
    """More terms than are looked at."""


@dataclass(frozen=True, slots=True, eq=False)
class _Fraction:
    """A numerator over a denominator, neither of them in lowest terms."""

    above: Polynomial
    below: Polynomial


@dataclass(slots=True)
class _Algebra:
    """Fractions in the entries of arguments, and in what functions give of fractions."""

    programs: tuple[Program, Program]
    ring: Ring = field(init=False)
    _generators: list[Polynomial] = field(init=False, default_factory=list)
    _free: list[Polynomial] = field(init=False)
    _turns: list[tuple[Polynomial, Polynomial]] = field(init=False)
    _entries: dict[tuple[int, int], Polynomial] = field(init=False)
    _keys: dict[object, int] = field(init=False, default_factory=dict)
    _angles: dict[int, tuple[Polynomial, Polynomial]] = field(init=False, default_factory=dict)
    _known: list[tuple[Op, tuple[_Fraction, ...], _Fraction]] = field(init=False, default_factory=list)
    _units: dict[int, Fraction] = field(init=False, default_factory=dict)

    def __post_init__(self) -> None:
        steps = [step for program in self.programs for step in program.steps]
        entries = list(dict.fromkeys((step.argument, step.entry) for step in steps if step.op is Op.INPUT))
        turns = sum(step.op in _TURNS for step in steps)
        others = sum(step.op not in _ARITHMETIC for step in steps)
        # A root comes before all that can stand under it, and a cosine before its sine.
        names = [f"f{k}" for k in range(others)] + [f"{kind}{k}" for kind in "cs" for k in range(turns)]
        self.ring = make_ring([*names, *(f"x{k}" for k in range(len(entries)))])
        made = self.ring.generators
        self._free = list(made[:others])
        self._turns = list(zip(made[others : others + turns], made[others + turns : others + 2 * turns], strict=True))
        self._entries = dict(zip(entries, made[others + 2 * turns :], strict=True))
        for program in self.programs:
            self._measure(program)

    def values(self, program: Program) -> list[_Fraction]:
        """What each step holds."""
        found: list[_Fraction] = []
        keys = self._keys_of(program)
        for step in program.steps:
            of = [found[k] for k in step.operands]
            if step.op in _TURNS:
                base, times = angle_of(program, step.operands[0])
                found.append(self._turned(step.op, keys[base], times))
            else:
                found.append(self._value(step, of))
        return found

    def is_equal(self, one: _Fraction, other: _Fraction) -> bool:
        """Whether two fractions are the same."""
        if one is other:
            return True
        return bool(self._times(one.above, other.below) - self._times(other.above, one.below) == 0)

    def _value(self, step: Step, of: list[_Fraction]) -> _Fraction:
        one = self.ring.constant(Fraction(1))
        match step.op:
            case Op.INPUT:
                return _Fraction(self._entries[step.argument, step.entry], one)
            case Op.CONSTANT:
                return _Fraction(self.ring.constant(step.value), one)
            case Op.ADD | Op.SUBTRACT:
                a, b = of
                sign = 1 if step.op is Op.ADD else -1
                if a.below == b.below:
                    return _Fraction(a.above + sign * b.above, a.below)
                above = self._times(a.above, b.below) + sign * self._times(b.above, a.below)
                return _Fraction(above, self._times(a.below, b.below))
            case Op.MULTIPLY:
                return _Fraction(self._times(of[0].above, of[1].above), self._times(of[0].below, of[1].below))
            case Op.DIVIDE:
                below = self._times(of[0].below, of[1].above)
                if below == 0:
                    raise _TooLarge
                return _Fraction(self._times(of[0].above, of[1].below), below)
            case Op.NEGATE:
                return _Fraction(-of[0].above, of[0].below)
            case op:
                return self._function(op, tuple(of))

    def _function(self, op: Op, of: tuple[_Fraction, ...]) -> _Fraction:
        """What a function gives of the fractions: what it gave of such before, or something new."""
        for known, arguments, value in self._known:
            if known is op and all(map(self.is_equal, arguments, of)):
                return value
        if op is Op.SELECT and self.is_equal(of[1], of[2]):
            return of[1]
        new = self._free.pop()
        value = _Fraction(new, self.ring.constant(Fraction(1)))
        if op is Op.SQUARE_ROOT and len(of[0].below) == 1 and not any(self.ring.leading(of[0].below)[0]):
            scale = self.ring.constant(1 / self.ring.leading(of[0].below)[1])
            self._generators.append(new * new - of[0].above * scale)
        self._known.append((op, of, value))
        return value

    def _times(self, one: Polynomial, other: Polynomial) -> Polynomial:
        if len(one) * len(other) > MOST_PRODUCTS:
            raise _TooLarge
        return reduce_by(self.ring, one * other, self._generators).remainder

    def _turned(self, op: Op, key: int, times: Fraction) -> _Fraction:
        """The cosine or sine of a multiple of what has the key."""
        unit = self._units.get(key, abs(times) or Fraction(1))
        if times and abs(times / unit) > MOST_TURNS:
            key, unit = self._key(("times", key, abs(times))), abs(times)
        if key not in self._angles:
            cosine, sine = self._turns.pop()
            self._angles[key] = cosine, sine
            self._generators.append(cosine * cosine + sine * sine - 1)
        found = multiple_of_angle(int(times / unit))[0 if op is Op.COSINE else 1]
        rise = {(i + max(found.powers[0], 0), j + max(found.powers[1], 0)): q for (i, j), q in found.above}
        return _Fraction(self._polynomial(rise, *self._angles[key]), self.ring.constant(Fraction(1)))

    def _polynomial(self, turned: Turned, cosine: Polynomial, sine: Polynomial) -> Polynomial:
        total = self.ring.constant(Fraction(0))
        for (i, j), q in turned.items():
            total = total + self.ring.constant(q) * sine**i * cosine**j
        return reduce_by(self.ring, total, self._generators).remainder

    def _measure(self, program: Program) -> None:
        """Of each angle the part by which all its multiples in both programs are written."""
        keys = self._keys_of(program)
        for step in program.steps:
            if step.op in _TURNS:
                base, times = angle_of(program, step.operands[0])
                old, new = self._units.get(keys[base], abs(times)), abs(times)
                above = gcd(old.numerator * new.denominator, new.numerator * old.denominator)
                self._units[keys[base]] = Fraction(above, old.denominator * new.denominator) if above else new

    def _keys_of(self, program: Program) -> list[int]:
        """A number for each step, the same for steps that are spelled alike in either program."""
        keys: list[int] = []
        for step in program.steps:
            of: Iterable[int] = (keys[k] for k in step.operands)
            of = sorted(of) if step.op in (Op.ADD, Op.MULTIPLY) else of
            keys.append(self._key((step.op, *of, step.argument, step.entry, step.value)))
        return keys

    def _key(self, spelled: object) -> int:
        return self._keys.setdefault(spelled, len(self._keys))
