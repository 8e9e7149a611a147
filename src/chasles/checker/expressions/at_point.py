"""What are the values of expressions at a point? They are evaluated as they stand, exactly, by the checker alone."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import sympy

from chasles.checker.expressions.algebra import constant
from chasles.checker.expressions.enclosed import written
from chasles.checker.expressions.expressions import Circle, Expressions
from chasles.checker.expressions.quantities import NUMBERS, SIGNS, is_atom, is_so
from chasles.checker.expressions.reals import Reals
from chasles.checker.expressions.switches import SWITCHES
from chasles.checker.expressions.symbolic import Symbolic, UnknownValue, Valuation
from chasles.checker.expressions.turns import turned
from chasles.checker.expressions.visible import is_running
from chasles.checker.sparse import ONE, ZERO, Polynomial, Rejected, exponents, number


class AtPoint(Expressions, Reals):
    """Reads expressions as numbers at a point, given by SymPy's spelling: x, Derivative(f(t), t), cos(phi/2).

    `symbolic` reads the arguments of cosines and sines.
    """

    def __init__(self, symbolic: Symbolic, at: Mapping[str, Any]) -> None:
        super().__init__({}, {})
        self.symbolic = symbolic
        self.at = {name: value for name, value in at.items() if not _is_circular(name)}
        self.turns = {name: value for name, value in at.items() if _is_circular(name)}
        self.numbers = {name: _exact(self, value) for name, value in self.at.items()}
        self.value_of = Valuation(symbolic, self, self.given)
        self.circle_of: dict[int, Circle] = {}

    def _read(self, e: Any) -> Polynomial:
        if isinstance(e, sympy.atan) and e.args[0].is_Rational:
            return self.arctangent(Fraction(int(e.args[0].p), int(e.args[0].q)))
        if isinstance(e, SWITCHES) and not isinstance(e, sympy.Abs):
            return self(written(e, lambda part: self.sign(self(part))))
        if isinstance(e, sympy.Derivative) and not is_atom(e):
            return self.value_of(self.symbolic(e))
        if isinstance(e, sympy.Pow) and not e.exp.is_Rational:
            exponent = constant(self(e.exp))
            return super()._read(e) if exponent is None else self.raised(e.base, exponent)
        return super()._read(e)

    def atom(self, e: Any) -> Polynomial:
        """The value of a real quantity; raises `Rejected` where the point has none, or one that SymPy excludes."""
        function = e.expr if isinstance(e, sympy.Derivative) else e
        if (self.symbolic.values.keys() - self.symbolic.rooted) & {e, function}:
            return self.value_of(self.symbolic.atom(e))
        if str(e) not in self.numbers:
            raise UnknownValue(f"no value is given for {e}")
        self.symbolic.place(e)
        value = self.numbers[str(e)]
        for assumption in (*SIGNS, *NUMBERS):
            said = getattr(e, f"is_{assumption}")
            if said is not None and said is not is_so(self, value, assumption):
                raise Rejected(f"{e} is {'' if said else 'not '}{assumption}, and its value is not so")
        if e is not function and (function.is_nonnegative or function.is_nonpositive):
            self._require_turning(e, function, value)
        return value

    def _require_turning(self, e: Any, function: Any, value: Polynomial) -> None:
        """Where what never changes its sign is zero, it turns: its first other rate is even, and has that sign."""
        order = int(e.derivative_count)
        lower = [str(function), *(str(function.diff(*e.variables[:n])) for n in range(1, order))]
        if str(function) not in self.numbers or any(self.sign(self.numbers.get(name, ZERO)) for name in lower):
            return
        if self.sign(value) not in ((0, 1 if function.is_nonnegative else -1) if order % 2 == 0 else (0,)):
            raise Rejected(f"{function} would change its sign at the point")

    def half_turn(self) -> Polynomial:
        """What pi is."""
        return self.pi

    def absolute(self, value: Polynomial) -> Polynomial:
        """The absolute value."""
        return value * number(self.sign(value))

    def over(self, value: Polynomial, spelled: str) -> Polynomial:
        """One over a value; raises `Rejected` for zero, and where it is not known to be none."""
        if not self.sign(value):
            raise Rejected(f"{spelled} is zero at the point")
        return self.inverse(value)

    def argument(self, e: Any) -> Polynomial:
        """The argument of a cosine or sine, in the quantities that make angles."""
        return self.symbolic(e)

    def require_nonnegative(self, value: Polynomial) -> None:
        """Something is not negative at the point."""
        if self.sign(value) < 0:
            raise Rejected("something is negative at the point that must not be")

    def is_half_turn(self, monomial: int) -> bool:
        """Whether a product of variables is pi."""
        return self.symbolic.is_half_turn(monomial)

    def circle(self, monomial: int, multiple: Fraction) -> Circle:
        """The cosine and sine that the point gives for a fraction of an angle."""
        if not monomial:
            return abs(multiple), *self.direction(number(abs(multiple)))
        if monomial not in self.circle_of:
            unit = self.symbolic.circle(monomial, multiple)[0]
            found = [name for name in self.turns if self._unit(name, monomial) is not None]
            cosines = [name for name in found if name.startswith("cos")]
            if not found:
                return unit, *self.direction(self.value_of(Polynomial({monomial: unit.numerator}, unit.denominator)))
            if len(cosines) != 1 or "sin" + cosines[0][3:] not in found:
                raise UnknownValue(f"no cosine and sine are given for {self._spelled(monomial)}")
            unit = self._unit(cosines[0], monomial) or unit
            c, s = (_exact(self, self.turns[name]) for name in (cosines[0], "sin" + cosines[0][3:]))
            if not self.vanishes(c * c + s * s - ONE):
                raise Rejected(f"{cosines[0]} and sin{cosines[0][3:]} are not cosine and sine of one angle")
            self.circle_of[monomial] = unit, c, s
        return self.circle_of[monomial]

    def _unit(self, name: str, monomial: int) -> Fraction | None:
        """The fraction of an angle of which a name such as cos(3*phi/2) is the cosine; None if of no such."""
        found = re.fullmatch(r"(?:cos|sin)\((?:([1-9]\d*)\*)?(.+?)(?:/([1-9]\d*))?\)", name)
        if not found or found[2] not in (self._spelled(monomial), f"({self._spelled(monomial)})"):
            return None
        return Fraction(int(found[1] or 1), int(found[3] or 1))

    def _spelled(self, monomial: int) -> str:
        return str(sympy.Mul(*(self.symbolic.atoms[place] ** power for place, power in exponents(monomial))))

    def given(self, place: int) -> Polynomial:
        """The value of a quantity, or of a cosine or sine, of the symbolic reading."""
        if place in self.symbolic.atoms:
            e = self.symbolic.atoms[place]
            return self.pi if e is sympy.pi else self.atom(e)
        for monomial, (unit, cosine, sine) in self.symbolic.circles.items():
            if place in cosine.places | sine.places:
                given, c, s = self.circle(monomial, unit)
                if unit != given:
                    raise Rejected(f"the point gives the cosine of another fraction of {self._spelled(monomial)}")
                return c if place in cosine.places else s
        raise UnknownValue(f"no value is given for {self.symbolic.names[place]}")

    def valued(self) -> set[int]:
        """The places of quantities, and of cosines and sines, that the point itself gives values."""
        read = self.symbolic
        atoms = {place for place, e in read.atoms.items() if str(e) in self.numbers and e not in read.values}
        turned = [circle for m, circle in read.circles.items() if any(self._unit(name, m) for name in self.turns)]
        return atoms.union(*(c.places | s.places for _, c, s in turned))

    def spelled(self) -> dict[str, Polynomial]:
        """The values of quantities and of angles by SymPy's spelling."""
        angles = [m for m in self.circle_of if not any(self._is_free(place) for place, _ in exponents(m))]
        return self.numbers | {self._spelled(m): self.value_of(Polynomial({m: 1})) for m in angles}

    def require_angles(self) -> None:
        """Angles whose quantities have values fit their cosines and sines, and the others can be so.

        A quantity that occurs in no other angle, and has no value, makes its angle whatever it is to be.
        """
        waiting = dict(self.circle_of)
        while waiting:
            free = {m: [self.symbolic.atoms[k] for k, _ in exponents(m) if self._is_free(k)] for m in waiting}
            for monomial, atoms in free.items():
                others = [e for other, more in free.items() if other != monomial for e in more]
                if not atoms:
                    self._require_fit(monomial)
                    break
                if any(e not in others and not e.is_zero and is_running(e, (), "real") for e in atoms):
                    known = [self.symbolic.atoms[k] for k, _ in exponents(monomial) if not self._is_free(k)]
                    if not all(self.sign(self.atom(e)) for e in known):
                        raise Rejected(f"{self._spelled(monomial)} is zero at the point, whatever the cosine given")
                    break
            else:
                raise Rejected("it is not seen that the angles can have the cosines and sines that are given")
            del waiting[monomial]

    def _is_free(self, place: int) -> bool:
        return str(self.symbolic.atoms[place]) not in self.numbers

    def _require_fit(self, monomial: int) -> None:
        unit, cosine, sine = self.circle_of[monomial]
        known = self._direction(self.value_of(Polynomial({monomial: 1})) * number(unit))
        if known is None:
            raise Rejected(f"the cosine of {self._spelled(monomial)} is not known at the point")
        c, s = known
        if not (self.vanishes(c - cosine) and self.vanishes(s - sine)):
            raise Rejected(f"cosine and sine of {self._spelled(monomial)} are not those of its value at the point")

    def direction(self, angle: Polynomial) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of a number."""
        return self._direction(angle) or (self.called("cos", angle), self.called("sin", angle))

    def _direction(self, angle: Polynomial) -> tuple[Polynomial, Polynomial] | None:
        """Cosine and sine of a sum of multiples of arctangents; None for other numbers."""
        c, s = ONE, ZERO
        parts = self.angle(angle)
        if parts is None or any(tangent != 1 and multiple.denominator != 1 for tangent, multiple in parts):
            return None
        for tangent, multiple in parts:
            one, other = turned(multiple / 4, self) if tangent == 1 else self._times(tangent, int(multiple))
            c, s = self.normal(c * one - s * other), self.normal(c * other + s * one)
        return c, s

    def _times(self, tangent: Fraction, times: int) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of a multiple of an arctangent."""
        cosine = self.root(number(1 / (1 + tangent * tangent)))
        return self.complex_power(cosine, cosine * number(tangent if times > 0 else -tangent), abs(times))


def _exact(point: AtPoint, value: Any) -> Polynomial:
    """A coordinate, as a number."""
    if isinstance(value, Fraction | int) and not isinstance(value, bool):
        return number(Fraction(value))
    if not isinstance(value, sympy.Expr) or value.free_symbols:
        raise Rejected(f"{value!r} is no exact number")
    return point(value)


def _is_circular(name: str) -> bool:
    return name.startswith(("cos(", "sin(")) and name.endswith(")")
