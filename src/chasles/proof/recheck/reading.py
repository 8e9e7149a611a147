"""What does a declaration say? It is read a second time here, for the checker, which shares no code with the prover.

What a hypothesis declares nonzero has its inverse as a variable, so that every expression is a polynomial.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import reduce
from operator import add, mul
from typing import Any

from chasles import vocabulary as w
from chasles.proof.recheck.expansion import Expansion, Matrix
from chasles.proof.recheck.sparse import MOST_VARIABLES, ONE, ZERO, Polynomial, Rejected, exponents, number, variable
from chasles.statements import Problem

__all__ = ["Reading"]


class Reading(Expansion):
    """A problem as polynomials: everything `vanishing` is zero, by name, and none of the `atoms` is.

    Variable k is the inverse of atom k as long as there are atoms. `names` tell of which fraction of each angle the
    cosine and sine are variables; nothing else is taken from them. Raises `Rejected` for what has no polynomial form.
    """

    def __init__(self, problem: Problem, names: Iterable[str]) -> None:
        super().__init__(dict(problem.rules))
        self.problem = problem
        found = (re.fullmatch(r"(?:cos|sin)\(([1-9]\d*)?(.+?)(?:/([1-9]\d*))?\)", name) for name in names)
        self._units = {m[2]: Fraction(int(m[1] or 1), int(m[3] or 1)) for m in found if m}
        self.variables: list[tuple[Any, ...]] = []
        self.places: dict[str, int] = {}
        self.vanishing: dict[str, Polynomial] = {}
        self.conditions: list[Polynomial] = []
        self.atoms: list[Polynomial] = []
        self.positive: list[tuple[str, Polynomial]] = []
        self._values: dict[int, Polynomial] = {}
        self._speeds: dict[int, Polynomial] = {}
        self._norms: dict[w.Node, int] = {}
        divisors = [(h, node) for h in problem.hypotheses for node in h.nonvanishing]
        for place, (hypothesis, _) in enumerate(divisors):
            self._variable(f"{place + 1}. {hypothesis.text}", "inverse", place)
        self._inverses = (1 << 8 * len(divisors)) - 1
        for hypothesis, node in divisors:
            atom, below = self.cleared(self(node)[0][0])
            self.atoms.append(atom)
            if hypothesis.kind == "positive":
                self.positive.append((hypothesis.text, atom * self.product(below)))
        for goal in problem.goals:
            self.difference(goal.left, goal.right)
        self._conditions()
        self._hypotheses()

    def _conditions(self) -> None:
        for goal in self.problem.conditions:
            for i, j, polynomial in self.difference(goal.left, goal.right):
                if polynomial:
                    self.conditions.append(self.cleared(polynomial)[0])
                    self._vanish(f"{len(self.conditions)}. {goal.label} [{i + 1}, {j + 1}]", polynomial)

    def _hypotheses(self) -> None:
        """What the hypotheses say, and its rates up to the highest order that occurs."""
        highest = max((what[2] for what in self.variables if what[0] == "entry"), default=0)
        for hypothesis in self.problem.hypotheses:
            for place, (left, right) in enumerate(hypothesis.equations):
                entries = self.difference(left, right)
                for order in range(highest + 1):
                    label = hypothesis.text + (f" ({'d' * order}ot)" if order else "")
                    entries = [(i, j, self.rate(entry)) for i, j, entry in entries] if order else entries
                    for i, j, entry in entries:
                        self._vanish(f"{label} [{place}: {i + 1}, {j + 1}]", entry)

    def _vanish(self, label: str, polynomial: Polynomial) -> None:
        polynomial = self.cleared(polynomial)[0]
        if self.vanishing.setdefault(label, polynomial) - polynomial:
            raise Rejected(f"two different hypotheses are both called {label}")

    def _variable(self, name: str, *what: Any) -> Polynomial:
        place = self.places.setdefault(squeezed(name), len(self.variables))
        if place == MOST_VARIABLES:
            raise Rejected(f"there are more than {MOST_VARIABLES} variables")
        if place == len(self.variables):
            self.variables.append(what)
        elif self.variables[place] != what:
            raise Rejected(f"two different quantities are both called {name}")
        return self._values[place] if place in self._values else variable(place)

    def settle(self, values: Mapping[int, Polynomial]) -> None:
        """From here on, these variables have these values."""
        self._values |= values
        self._known.clear()
        self._speeds.clear()

    def difference(self, left: w.Node, right: w.Node) -> list[tuple[int, int, Polynomial]]:
        """Row, column and left - right, for each entry."""
        rows = enumerate(zip(self(left), self(right), strict=True))
        return [(i, j, a - b) for i, row in rows for j, (a, b) in enumerate(zip(*row, strict=True))]

    def cleared(self, polynomial: Polynomial) -> tuple[Polynomial, int]:
        """The polynomial times the least product of atoms that leaves no inverse in it, and the powers of these."""
        parts: dict[int, dict[int, int]] = {}
        for monomial, coefficient in polynomial.terms.items():
            inverses = monomial & self._inverses
            parts.setdefault(inverses, {})[monomial - inverses] = coefficient
        least: dict[int, int] = {}
        for place, power in (power for inverses in parts for power in exponents(inverses)):
            least[place] = max(power, least.get(place, 0))
        top = sum(power << 8 * place for place, power in least.items())
        cleared = (Polynomial(part, polynomial.below) * self.product(top - powers) for powers, part in parts.items())
        return reduce(add, cleared, ZERO), top

    def product(self, powers: int) -> Polynomial:
        """The product of the atoms to these powers, packed as in a monomial."""
        return reduce(mul, (self.atoms[k] for k, power in exponents(powers) for _ in range(power)), ONE)

    def inverse(self, node: w.Node) -> Polynomial:
        """One over a scalar; raises `Rejected` unless it is a number times a product of atoms."""
        value, below = self.cleared(self(node)[0][0])
        for inverse, atom in [(ONE, ONE), *((variable(k), atom) for k, atom in enumerate(self.atoms))]:
            top = max(atom.terms, default=0)
            if top in value.terms and top in atom.terms:
                scale = Fraction(value.terms[top] * atom.below, atom.terms[top] * value.below)
                if not value - atom * number(scale):
                    return inverse * self.product(below) * number(1 / scale)
        match self.rules.get(node, node):
            case w.Negative(term):
                return -self.inverse(term)
            case w.Group(of) | w.At(of):
                return self.inverse(of)
            case w.Scale(factor, term):
                return self.inverse(factor) * self.inverse(term)
            case w.Power(base, exponent):
                return reduce(mul, [self.inverse(base)] * exponent)
            case rule if rule is not node:
                return self.inverse(rule)
            case _:
                raise Rejected(f"the statement divides by {node}, which nothing declares nonzero")

    def rate(self, polynomial: Polynomial) -> Polynomial:
        """The time derivative."""
        return reduce(add, (partial * self._speed(place) for place, partial in polynomial.partials().items()), ZERO)

    def _speed(self, place: int) -> Polynomial:
        if place not in self._speeds:
            self._speeds[place] = self._find_speed(place)
        return self._speeds[place]

    def _find_speed(self, place: int) -> Polynomial:
        match self.variables[place]:
            case ("inverse", int() as k):
                return -variable(place, 2) * self.rate(self.atoms[k])
            case ("norm", w.Node() as of):
                return self(w.Dot(of, w.Rate(of)))[0][0] * self.inverse(w.Norm(of))
            case ("cos", w.Symbol() as angle, Fraction() as unit):
                return variable(place + 1) * number(-unit) * self(w.Rate(angle))[0][0]
            case ("sin", w.Symbol() as angle, Fraction() as unit):
                return variable(place - 1) * number(unit) * self(w.Rate(angle))[0][0]
            case ("entry", w.Symbol() as of, int() as order, int() as i, int() as j):
                node: w.Node = of
                for _ in range(order + 1):
                    node = w.Rate(node)
                return self(node)[i][j]
        raise AssertionError(self.variables[place])

    def symbol(self, node: w.Symbol | w.Rate) -> Matrix:
        """The variables of a symbol or of its rate; the rate of what has entries of its own is the rate of these."""
        order = 0
        of: w.Node = node
        while isinstance(of, w.Rate) and of not in self.rules:
            order, of = order + 1, of.of
        own = isinstance(of, w.Symbol) and of not in self.rules and of.stands_for is None
        if isinstance(node, w.Rate) and not (own and not self._is_settled(of)):
            return [[self.rate(entry) for entry in row] for row in self(node.of)]
        assert isinstance(of, w.Symbol)
        if order and of.constant:
            return [[ZERO] * of.shape[1]] * of.shape[0]
        names = enumerate(_names(of, order))
        return [[self._variable(name, "entry", of, order, i, j) for j, name in enumerate(row)] for i, row in names]

    def _is_settled(self, node: w.Node) -> bool:
        return isinstance(node, w.Symbol) and self.places.get(_names(node, 0)[0][0]) in self._values

    def norm(self, of: w.Node) -> Polynomial:
        """The variable of a norm; the same for expressions with the same entries, or with opposite ones."""
        if of not in self._norms:
            same = [place for other, place in self._norms.items() if self._is_same_length(of, other)]
            name, what = f"|{of}|", ("norm", of)
            if same:
                self.places.setdefault(squeezed(name), same[0])
                what = self.variables[same[0]]
            length = self._variable(name, *what)
            self._norms[of] = self.places[squeezed(name)]
            self._vanish(f"norm {name}", length * length - self(w.Dot(of, of))[0][0])
        return variable(self._norms[of])

    def _is_same_length(self, one: w.Node, other: w.Node) -> bool:
        pairs = [(a, b) for (a,), (b,) in zip(self(one), self(other), strict=False)]
        same = one.shape == other.shape
        return same and (not any(a - b for a, b in pairs) or not any(a + b for a, b in pairs))

    def circular(self, angle: w.Node) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of a sum of multiples of symbols, by the addition formulas."""
        cosine, sine = ONE, ZERO
        value = self(angle)[0][0]
        for monomial, multiple in value.terms.items():
            match [(*self.variables[place], power) for place, power in exponents(monomial)]:
                case [("entry", w.Symbol() as symbol, 0, 0, 0, 1)] if symbol.is_scalar:
                    unit = self._units.get(symbol.name, abs(Fraction(multiple, value.below)))
                case _:
                    raise Rejected(f"{angle} is no angle: an angle is a sum of rational multiples of symbols")
            name = f"{unit.numerator if unit.numerator > 1 else ''}{symbol.name}"
            name += f"/{unit.denominator}" if unit.denominator > 1 else ""
            c = self._variable(f"cos({name})", "cos", symbol, unit)
            s = self._variable(f"sin({name})", "sin", symbol, unit)
            self._vanish(f"circle {name}", c * c + s * s - ONE)
            turns = multiple / (unit * value.below)
            if turns.denominator != 1:
                raise Rejected(f"{angle} is no whole multiple of {name}")
            s = s if turns > 0 else -s
            for _ in range(abs(turns.numerator)):
                cosine, sine = cosine * c - sine * s, sine * c + cosine * s
        return cosine, sine


def squeezed(name: str) -> str:
    """A variable's name without blanks, as certificates write it."""
    return name.replace(" ", "")


def _names(symbol: w.Symbol, order: int) -> list[list[str]]:
    """The names of the entries: e_1, Q_12, a_dot_3, phi."""
    rows, columns = symbol.shape
    stem = symbol.name + (f"_{'d' * order}ot" if order else "")
    if columns == 1:
        return [[f"{stem}_{i + 1}" if rows > 1 else stem] for i in range(rows)]
    return [[f"{stem}_{i + 1}{j + 1}" for j in range(columns)] for i in range(rows)]
