"""Are two programs the same function? Both are evaluated over fractions in what goes in, and compared exactly.

Cosines and sines of one angle are polynomials in those of a part of it, modulo cos^2 + sin^2 = 1; a root's square is
what stands under it. Of every other function it is known only that like arguments give like values. So what is said to
be equivalent is; what is not said to be may yet be. Numerators are compared in normal form, by division with remainder
in several variables (Cox, Little and O'Shea, Ideals, Varieties, and Algorithms, section 2.3).
"""

from __future__ import annotations

from fractions import Fraction
from math import factorial, gcd, lcm

from chasles.algebra.localization import Localization, Ratio, quotient
from chasles.algebra.normal_form import reduce_by
from chasles.algebra.rings import Exponents, Polynomial, make_ring
from chasles.algebra.work_limit import OutOfTime, spend
from chasles.lowering.arithmetic import Arithmetic, Operators, evaluated
from chasles.lowering.circular import multiple_of_angle
from chasles.lowering.program import Op, Program
from chasles.lowering.scales import with_free_scales

MOST_MULTIPLES = 12
"""So many times the part is an angle still written by it."""
POLYNOMIAL = (Op.INPUT, Op.CONSTANT, Op.ADD, Op.SUBTRACT, Op.MULTIPLY, Op.DIVIDE, Op.NEGATE)
CIRCULAR = (Op.SINE, Op.COSINE)

Angle = tuple[Ratio, Fraction, Polynomial, Polynomial]
"""An angle without its rational factor, the factor of the part that is known, and the cosine and sine of that part."""


def equivalent(one: Program, other: Program) -> bool:
    """Whether the results of the two are equal wherever both have values.

    No is also said where that is not seen with the work that `chasles.algebra.work_limit.within` leaves.
    """
    if [r.shape for r in one.results] != [r.shape for r in other.results]:
        return False
    if one == other:
        return True
    one, other = with_free_scales(one, 1), with_free_scales(other, 2)
    algebra = _Fractions(one, other)
    try:
        arithmetic: Arithmetic[Ratio] = algebra
        values, others = (evaluated(program.steps, arithmetic, algebra.entry) for program in (one, other))
        pairs = dict.fromkeys(
            pair
            for r, s in zip(one.results, other.results, strict=True)
            for pair in zip(r.entries, s.entries, strict=True)
        )
        return all(algebra.is_equal(values[a], others[b]) for a, b in pairs)
    except (OutOfTime, ZeroDivisionError):
        return False


class _Fractions(Operators):
    """Fractions in the entries of two programs' arguments, and in what functions give of fractions."""

    def __init__(self, *programs: Program) -> None:
        steps = [step for program in programs for step in program.steps]
        entries = list(dict.fromkeys((step.argument, step.entry) for step in steps if step.op is Op.INPUT))
        circular = sum((step.op in CIRCULAR) + 2 * (step.function == "stumpff") for step in steps)
        others = sum(step.op not in (*POLYNOMIAL, *CIRCULAR) for step in steps)
        # A root comes before all that can stand under it, and a cosine before its sine and before those of a part.
        names = [f"f{k}" for k in range(others)] + [f"{kind}{k}" for k in range(circular) for kind in "cs"]
        self._words = 1 + (len(names) + len(entries)) // 64
        ring = make_ring([*names, *(f"x{k}" for k in range(len(entries)))])
        self._field = Localization(ring, [])
        made = iter(ring.generators)
        self._free = [next(made) for _ in range(others)]
        self._circles = iter([(next(made), next(made)) for _ in range(circular)])
        self._entries = {entry: self._field.ratio(variable) for entry, variable in zip(entries, made, strict=True)}
        self._positive = [value.numerator for (argument, _), value in self._entries.items() if argument < 0]
        self._rules: dict[int, list[tuple[Polynomial, Exponents]]] = {}
        self._angles: list[Angle] = []
        self._known: list[tuple[Op | str, tuple[Ratio, ...], Ratio]] = []

    def entry(self, argument: int, entry: int) -> Ratio:
        """An entry of an argument."""
        return self._entries[argument, entry]

    def is_equal(self, one: Ratio, other: Ratio) -> bool:
        """Whether two fractions are the same."""
        same = one is other or (one.denominator == other.denominator and one.numerator == other.numerator)
        return same or self._reduced(self.subtract(one, other)).is_zero

    def constant(self, value: Fraction) -> Ratio:
        return self._field.constant(value)

    def add(self, a: Ratio, b: Ratio) -> Ratio:
        """The sum; its terms are as long as there are variables."""
        spend((len(a.numerator) + len(b.numerator)) * self._words)
        return a + b

    def subtract(self, a: Ratio, b: Ratio) -> Ratio:
        return self.add(a, -b)

    def multiply(self, a: Ratio, b: Ratio) -> Ratio:
        spend(len(a.numerator) * len(b.numerator) * self._words)
        return self._reduced(a * b)

    def divide(self, a: Ratio, b: Ratio) -> Ratio:
        """The quotient, what it is divided by being a unit from here on; raises ZeroDivisionError for zero."""
        divisor, units = self._reduced(b), self._field.nonzero
        exponents, scale = self._leading(divisor)
        if not any(exponents):
            return self._reduced(quotient(a, divisor, scale, ()))
        unit = divisor.numerator * self._field.ring.constant(1 / scale)
        place = next((k for k, known in enumerate(units) if known == unit), len(units))
        if place == len(units):
            units.append(unit)
        return self._reduced(quotient(a, divisor, scale, (*(0,) * place, 1)))

    def square_root(self, a: Ratio) -> Ratio:
        """The root; what is positive and stands in it in an even power is taken out."""
        units, ring = self._field.nonzero, self._field.ring
        numerator, outside = a.numerator, ring.constant(Fraction(1))
        for positive in self._positive:
            while not a.is_zero and (parts := ring.divide(numerator, positive * positive))[1] == 0:
                numerator, outside = parts[0], outside * positive
        below = a.denominator
        if not all(power % 2 == 0 and (not power or units[k] in self._positive) for k, power in enumerate(below)):
            below = ()
        if below or outside != ring.constant(Fraction(1)):
            inside = Ratio(self._field, numerator, () if below else a.denominator)
            root = self.square_root(inside) * self._field.ratio(outside)
            return root.divided(Fraction(1), tuple(power // 2 for power in below))
        known = len(self._known)
        root = self._function(Op.SQUARE_ROOT, a)
        if len(self._known) > known and not a.denominator:
            self._let_vanish(root.numerator * root.numerator - a.numerator)
        return root

    def sine(self, a: Ratio) -> Ratio:
        return self._circular(a, 1)

    def cosine(self, a: Ratio) -> Ratio:
        return self._circular(a, 0)

    def not_a_number(self) -> Ratio:
        return self._function(Op.NOT_A_NUMBER)

    def arctangent2(self, y: Ratio, x: Ratio) -> Ratio:
        return self._function(Op.ARCTANGENT2, y, x)

    def less(self, a: Ratio, b: Ratio) -> Ratio:  # type: ignore[override]
        return self._function(Op.LESS, a, b)

    def equal(self, a: Ratio, b: Ratio) -> Ratio:  # type: ignore[override]
        return self._function(Op.EQUAL, a, b)

    def select(self, condition: Ratio, if_true: Ratio, if_false: Ratio) -> Ratio:  # type: ignore[override]
        if self.is_equal(if_true, if_false) or (if_true.is_zero and self._vanishes_where(if_false, condition)):
            return if_false
        taken_out = self.constant(Fraction(1))
        for positive in self._positive:
            powers = [self._power_of(positive, each) for each in (if_true, if_false) if not each.is_zero]
            factor = self._field.ratio(positive)
            for _ in range(abs(common := min(powers))):
                move, back = (self.divide, self.multiply) if common > 0 else (self.multiply, self.divide)
                if_true, if_false, taken_out = move(if_true, factor), move(if_false, factor), back(taken_out, factor)
        return self.multiply(self._function(Op.SELECT, condition, if_true, if_false), taken_out)

    def _power_of(self, positive: Polynomial, ratio: Ratio) -> int:
        """How often what is positive is a factor of a fraction that is not zero; less than zero where below."""
        numerator, found = ratio.numerator, 0
        while (parts := self._field.ring.divide(numerator, positive))[1] == 0:
            numerator, found = parts[0], found + 1
        below = zip(self._field.nonzero, ratio.denominator, strict=False)
        return found - sum(power for unit, power in below if unit == positive)

    def _vanishes_where(self, value: Ratio, condition: Ratio) -> bool:
        """Whether two things that are equal under the condition differ by a multiple of the value."""
        for (one, other), found in ((of, found) for op, of, found in self._known if op is Op.EQUAL):
            difference = self._reduced(one - other)
            if found is condition and not difference.is_zero and not value.is_zero:
                scale = self._leading(value)[1] / self._leading(difference)[1]
                return bool(value.numerator == difference.numerator * self._field.ring.constant(scale))
        return False

    def function(self, name: str, *of: Ratio) -> Ratio:
        """What a function gives; those of Stumpff are fractions in an angle, its sine and its cosine."""
        if name == "stumpff":
            order = self._field.ring.leading(of[0].numerator)[1] if not of[0].is_zero else 0
            return self._stumpff(int(order), of[1])
        return self._function(name, *of)

    def _stumpff(self, order: int, angle: Ratio) -> Ratio:
        if order < 2:
            return self.divide(self.sine(angle), angle) if order else self.cosine(angle)
        first = self.constant(Fraction(1, factorial(order - 2)))
        return self.divide(first - self._stumpff(order - 2, angle), self.multiply(angle, angle))

    def _function(self, op: Op | str, *of: Ratio) -> Ratio:
        """What a function gives of the fractions: what it gave of such before, or something new."""
        for known, arguments, value in self._known:
            if known is op and all(map(self.is_equal, arguments, of)):
                return value
        self._known.append((op, of, self._field.ratio(self._free.pop())))
        return self._known[-1][2]

    def _circular(self, angle: Ratio, which: int) -> Ratio:
        """The cosine (0) or sine (1) of an angle, by those of the part of it that is known."""
        angle = self._reduced(angle)
        if angle.is_zero:
            return self.constant(Fraction(1 - which))
        times = self._leading(angle)[1]
        whole = angle * self.constant(1 / times)
        alike = [known for known in self._angles if self.is_equal(known[0], whole)]
        for _, part, *circle in alike:
            if (times / part).denominator == 1 and abs(times / part) <= MOST_MULTIPLES:
                return self._field.ratio(self._multiple(int(times / part), circle)[which])
        self._angles.append(self._part(whole, times, alike[-1:]))
        return self._circular(angle, which)

    def _part(self, whole: Ratio, times: Fraction, known: list[Angle]) -> Angle:
        """A part by which the multiple of a whole is written, and what is known, if that is not too small a part."""
        cosine, sine = next(self._circles)
        for _, part, *circle in known:
            common = Fraction(gcd(times.numerator, part.numerator), lcm(times.denominator, part.denominator))
            if max(abs(times), part) <= MOST_MULTIPLES * common:
                written = self._multiple(int(part / common), [cosine, sine])
                for old, new in zip(circle, written, strict=True):
                    self._let_vanish(old - new)
                times = common
        self._let_vanish(cosine * cosine + sine * sine - 1)
        return whole, abs(times), cosine, sine

    def _multiple(self, times: int, circle: list[Polynomial]) -> tuple[Polynomial, Polynomial]:
        """The cosine and the sine of so many times an angle."""
        cosine, sine = circle
        found = []
        for function in multiple_of_angle(times):
            terms = (self._field.ring.constant(q) * sine**i * cosine**j for (i, j), q in function.over[0].items())
            found.append(sum(terms, self._field.ring.constant(Fraction(0))))
        return found[0], found[1]

    def _leading(self, ratio: Ratio) -> tuple[tuple[int, ...], Fraction]:
        """The leading term of the numerator; raises ZeroDivisionError for zero."""
        if ratio.is_zero:
            raise ZeroDivisionError("a program divides by what is zero")
        return self._field.ring.leading(ratio.numerator)

    def _reduced(self, ratio: Ratio) -> Ratio:
        """The fraction with its numerator in normal form; of the rules those are looked at whose variables occur."""
        ring, numerator = self._field.ring, ratio.numerator
        while numerator != 0:
            degrees = ring.degrees(numerator)
            rules = [
                rule
                for place, degree in enumerate(degrees)
                if degree
                for rule in self._rules.get(place, ())
                if degree >= rule[1][place]
            ]
            if not rules:
                break
            _, numerator = reduce_by(ring, numerator, *zip(*rules, strict=True))
        return Ratio(self._field, numerator, ratio.denominator)

    def _let_vanish(self, polynomial: Polynomial) -> None:
        """A rule more; its leading term is a power of a variable."""
        lead = self._field.ring.leading(polynomial)[0]
        [place] = (place for place, exponent in enumerate(lead) if exponent)
        self._rules.setdefault(place, []).append((polynomial, lead))
