"""What does a SymPy expression say? It is read a second time here, for the checker, as a polynomial.

The variables are what SymPy has for real quantities (symbols, entries of matrix symbols, functions such as f(t) and
their derivatives), cosines and sines of fractions of angles, square roots, and inverses of what is divided by. To
treat another function, add how it is read to `READINGS`: in terms of others, or as a variable of its own (`fresh`, with
its square if that is a polynomial). What else is known of such a variable is told where it belongs: its sign in
`signs`, its rate in `rates`, its value at a point in `at_point`.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import reduce
from operator import add
from typing import Any

import sympy

from chasles.checker.expressions.algebra import QuotientRing, constant
from chasles.checker.expressions.quantities import is_atom, require_real
from chasles.checker.expressions.rates import Derivatives
from chasles.checker.expressions.readings import CIRCULAR, READINGS
from chasles.checker.expressions.turns import turned
from chasles.checker.sparse import ONE, ZERO, Polynomial, Rejected, exponents, variable

Circle = tuple[Fraction, Polynomial, Polynomial]
"""The fraction of an angle of which the cosine and the sine are variables, and these."""


class Expressions(QuotientRing):
    """Reads expressions; `names` are those of the variables by SymPy's spelling, `units` by the name of an angle.

    `divided` are SymPy's spellings of what is divided by, `values` what takes the place of some variables, those that
    are `rooted` a power of another one. Some variables are `positive`, and some are values of functions: `calls` tells
    of which, and of what.
    """

    def __init__(self, names: Mapping[str, str], units: Mapping[str, Fraction]) -> None:
        super().__init__()
        self.places: dict[str, int] = {}
        self.atoms: dict[int, Any] = {}
        self.values: dict[Any, Polynomial] = {}
        self.divided: dict[int, set[str]] = {}
        self.circles: dict[int, Circle] = {}
        self.angles: dict[int, str] = {}
        self.words: set[int] = set()
        self.positive: set[int] = set()
        self.rooted: set[Any] = set()
        self.calls: dict[int, tuple[str, tuple[Polynomial, ...]]] = {}
        self.rate: Derivatives = Derivatives(self)
        self._names, self._units = names, units
        self._known: dict[Any, Polynomial] = {}

    def __call__(self, e: Any) -> Polynomial:
        """The expression; raises `Rejected` for what has no polynomial form."""
        if e not in self._known:
            self._known[e] = self.normal(self._read(e))
        return self._known[e]

    def _read(self, e: Any) -> Polynomial:
        if is_atom(e):
            return self.atom(e)
        for kind in type(e).__mro__:
            if kind in READINGS:
                return READINGS[kind](self, e)
        raise Rejected(f"{e} ({type(e).__name__}) has no polynomial form")

    def atom(self, e: Any) -> Polynomial:
        """The variable of a real quantity, or its value."""
        function = e.expr if isinstance(e, sympy.Derivative) else e
        if function in self.values and function is not e:
            return reduce(self.rate, e.variables, self.values[function])
        return self.values[e] if e in self.values else variable(self.place(e))

    def substitute(self, e: Any, value: Polynomial) -> None:
        """From here on, a real quantity has this value, which is linear in others."""
        self.place(e)
        earlier, self.values[e] = dict(self.values), value
        for known, old in earlier.items():
            # What is linear in a quantity, or in rates of it, is so in what these become.
            places = [place for place in old.places if place in self.atoms]
            moved = {place: self.atom(self.atoms[place]) - variable(place) for place in places}
            self.values[known] = old + reduce(add, (old.partials()[k] * new for k, new in moved.items()), ZERO)
        self._known.clear()

    def place(self, e: Any) -> int:
        """The place of a real quantity; raises `Rejected` where its name is another's."""
        name = self._names.get(str(e), str(e))
        if name not in self.places:
            require_real(e)
            self.atoms[self.named(name)] = e
        place = self.places[name]
        if self.atoms.get(place) != e:
            raise Rejected(f"two different quantities are both called {name}")
        return place

    def named(self, name: str, square: Polynomial | None = None) -> int:
        """The place of a new variable that certificates call by this name."""
        if name in self.places:
            raise Rejected(f"two different quantities are both called {name}")
        self.places[name] = self.fresh(name, square)
        return self.places[name]

    def half_turn(self) -> Polynomial:
        """What pi is."""
        return variable(self.place(sympy.pi))

    def absolute(self, value: Polynomial) -> Polynomial:
        """The absolute value."""
        return self.root(self.normal(value * value))

    def divide(self, e: Any) -> Polynomial:
        """One over an expression, whose spelling then also tells what it divides by."""
        inverse = self._divided(e)
        for place in inverse.places & self.inverses.keys():
            self.divided.setdefault(place, set()).add(str(e))
        return inverse

    def _divided(self, e: Any) -> Polynomial:
        """One over an expression, factor by factor, with nothing divided by absolute values."""
        if isinstance(e, sympy.Mul):
            return reduce(lambda one, other: one * other, (self.divide(factor) for factor in e.args), ONE)
        if isinstance(e, sympy.Pow):
            if not e.exp.is_Rational:
                raise Rejected(f"{e} has no polynomial form")
            return self.raised(e.base, Fraction(int(-e.exp.p), int(e.exp.q)))
        if isinstance(e, sympy.Abs):
            return self.absolute(self(e.args[0])) * self.power(self.divide(e.args[0]), 2)
        if type(e) in CIRCULAR and CIRCULAR[type(e)][1]:
            above, below = (self.circular(part, e.args[0]) for part in CIRCULAR[type(e)])
            self.over(self.circular(CIRCULAR[type(e)][1], e.args[0]), f"{CIRCULAR[type(e)][1]}({e.args[0]})")
            return below * self.over(above, f"{CIRCULAR[type(e)][0] or 1}({e.args[0]})")
        return self.over(self(e), str(e))

    def over(self, value: Polynomial, spelled: str) -> Polynomial:
        """One over a value; what is divided by is spelled so."""
        inverse = self.inverse(value)
        numerator = self.cleared(value)[0]
        if constant(numerator) is None and (place := self.inverse_place(numerator)) is not None:
            self.divided.setdefault(place, set()).add(spelled)
        return inverse

    def raised(self, base: Any, exponent: Fraction) -> Polynomial:
        """A power with a rational exponent whose denominator is a power of two."""
        below = exponent.denominator
        if below & (below - 1):
            raise Rejected(f"{base}**({exponent}) has no polynomial form")
        if exponent < 0:
            whole = int(-(exponent // 1))
            return self.raised(base, whole + exponent) * self.power(self.divide(base), whole)
        if isinstance(base, sympy.Abs) and exponent.numerator % 2 == 0:
            return self.power(self(base.args[0]), exponent.numerator)
        value = self(base)
        while below > 1:
            value, below = self.root(value), below // 2
        return self.power(value, exponent.numerator)

    def exp(self, value: Polynomial) -> Polynomial:
        """The exponential."""
        return self.called("exp", value)

    def log(self, value: Polynomial, evident: bool = False) -> Polynomial:
        """The logarithm of what is positive, which has to be said unless it is `evident`."""
        return self.called("log", value)

    def arc(self, y: Polynomial, x: Polynomial) -> Polynomial:
        """The angle of the point (x, y)."""
        return self.called("arc", y, x)

    def powered(self, base: Polynomial, exponent: Polynomial) -> Polynomial:
        """A power of what is positive."""
        return self.exp(self.normal(exponent * self.log(base)))

    def know(self, value: Polynomial) -> None:
        """Something is not negative."""

    def require_nonnegative(self, value: Polynomial) -> None:
        """Something has not to be negative."""

    def circular(self, function: str, argument: Any) -> Polynomial:
        """The cosine or sine of an angle; one if neither is asked for."""
        return ONE if not function else self.turn(self.argument(argument), function == "sin")[function == "sin"]

    def argument(self, e: Any) -> Polynomial:
        """The argument of a cosine or sine, in the quantities that make angles."""
        return self(e)

    def direction(self, angle: Polynomial) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of what was read as an angle."""
        return self.turn(angle)

    def turn(self, angle: Polynomial, both: bool = True) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of a sum of rational multiples of angles and of pi; any sine if not `both` count."""
        cosine, sine = ONE, ZERO
        for monomial, coefficient in angle.terms.items():
            multiple = Fraction(coefficient, angle.below)
            if self.is_half_turn(monomial):
                c, s, times = *turned(multiple, self), 1
            else:
                unit, c, s = self.circle(monomial, multiple)
                if (multiple / unit).denominator != 1:
                    raise Rejected(f"an angle is no whole multiple of {unit} {self.angles.get(monomial, 1)}")
                times = int(multiple / unit)
            s = s if times > 0 else -s
            for _ in range(abs(times)):
                cosine, sine = self.normal(cosine * c - sine * s), self.normal(sine * c + cosine * s)
        return cosine, sine

    def is_half_turn(self, monomial: int) -> bool:
        """Whether a product of variables is pi."""
        return [(self.atoms.get(place), power) for place, power in exponents(monomial)] == [(sympy.pi, 1)]

    def circle(self, monomial: int, multiple: Fraction) -> Circle:
        """The cosine and sine of a fraction of an angle, which is a product of quantities."""
        pairs = exponents(monomial)
        if monomial not in self.circles:
            if not pairs or any(self.atoms.get(k) in (None, sympy.pi) and k not in self.calls for k, _ in pairs):
                raise Rejected("a cosine or sine is taken of what is no sum of multiples of products of quantities")
            spelled = "*".join(self.names[place] for place, power in pairs for _ in range(power))
            name = self.angles.setdefault(monomial, spelled)
            unit = self._units.get(name, abs(multiple))
            text = f"{unit.numerator if unit.numerator > 1 else ''}{name}"
            text += f"/{unit.denominator}" if unit.denominator > 1 else ""
            cosine = variable(self.named(f"cos({text})"))
            self.circles[monomial] = unit, cosine, variable(self.named(f"sin({text})", ONE - cosine * cosine))
        return self.circles[monomial]
