"""The quantities of a problem as variables: entries, cosines and sines, norms, moments of a body; and their rates."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import reduce
from itertools import combinations_with_replacement
from operator import mul
from typing import Any

from chasles import vocabulary as w
from chasles.checker.expansion import Formless, expanded, scaled
from chasles.checker.sparse import ZERO, Polynomial, Rejected, cleared, exponents, number, packed, product, variable
from chasles.statements.rules import rated
from chasles.vocabulary.letters import entry_names

Matrix = list[list[Polynomial]]


class Quantities:
    """Every expression, `rules` applied, as a matrix of polynomials; and all that is `vanishing`, by name.

    The variables, by place and by name: first the inverses of the factors that are
    `nonzero`. `units` tell of which fraction of each angle, by its name, the cosine and sine are variables.
    """

    def __init__(self, rules: Mapping[w.Node, w.Node], units: Mapping[str, Fraction]) -> None:
        self.rules = rules
        self.variables: list[tuple[Any, ...]] = []
        self.places: dict[str, int] = {}
        self.nonzero: list[Polynomial] = []
        self.vanishing: dict[str, Polynomial] = {}
        self._units = units
        self._known: dict[w.Node, Matrix] = {}
        self._values: dict[int, Polynomial] = {}
        self._speeds: dict[int, Polynomial] = {}
        self._norms: dict[w.Node, int] = {}

    def __call__(self, node: w.Node) -> Matrix:
        """The entries of an expression; raises `Rejected` for what has no polynomial form."""
        if node not in self._known:
            self._known[node] = self(self.rules[node]) if node in self.rules else self._entries(node)
        return self._known[node]

    def _entries(self, node: w.Node) -> Matrix:
        match node:
            case w.Symbol(stands_for=w.Node() as of) | w.At(of, "t") | w.Group(of):
                return self(of)
            case w.Rate(w.At(of, "t") | w.Group(of)):
                return self(w.Rate(of))
            case w.Symbol() | w.Rate():
                return self._symbol(node)
            case w.Quotient(numerator, denominator):
                return scaled(self.inverse(denominator), self(numerator))
            case w.Norm(of):
                return [[self._norm(of)]]
            case w.Integral(of):
                for symbol in node.running & self.rules.keys():
                    if not self._is_running(symbol, node.running):
                        raise Rejected(f"{node} is over {symbol}, and a rule makes it the same for all elements")
                return [[self._integrated(entry, node.running, node.body) for entry in row] for row in self(of)]
            case w.Call("cos" | "sin" as function, argument):
                return [[self._turned(argument)[function == "sin"]]]
            case _:
                return expanded(node, self)

    def vanish(self, label: str, polynomial: Polynomial) -> None:
        """From here on, this is zero; raises `Rejected` where something else has that label."""
        polynomial = cleared(polynomial, self.nonzero)[0]
        if self.vanishing.setdefault(label, polynomial) - polynomial:
            raise Rejected(f"two different hypotheses are both called {label}")

    def variable(self, name: str, *what: Any) -> Polynomial:
        """The variable of a name, or its value; raises `Rejected` where that names something else."""
        place = self.places.setdefault(squeezed(name), len(self.variables))
        if place == len(self.variables):
            self.variables.append(what)
        elif self.variables[place] != what:
            raise Rejected(f"two different quantities are both called {name}")
        return self._values[place] if place in self._values else variable(place)

    def rate(self, polynomial: Polynomial) -> Polynomial:
        """The time derivative."""
        total = ZERO
        for place, partial in polynomial.partials().items():
            if place not in self._speeds:
                self._speeds[place] = self._speed(place)
            total += partial * self._speeds[place]
        return total

    def _speed(self, place: int) -> Polynomial:
        match self.variables[place]:
            case ("inverse", int() as k):
                return -variable(place, 2) * self.rate(self.nonzero[k])
            case ("norm", w.Node() as of):
                return self(w.Dot(of, w.Rate(of)))[0][0] * self.inverse(w.Norm(of))
            case ("cos" | "sin" as function, w.Symbol() as angle, Fraction() as unit):
                other, turn = (place + 1, -unit) if function == "cos" else (place - 1, unit)
                return variable(other) * number(turn) * self(w.Rate(angle))[0][0]
            case ("entry", w.Symbol() as of, int() as order, int() as i, int() as j):
                return self(rated(of, order + 1))[i][j]
            case ("moment", int() as inside, frozenset() as running, str() as body):
                return self._integrated(self.rate(Polynomial({inside: 1})), running, body)
        raise AssertionError(self.variables[place])

    def _symbol(self, node: w.Symbol | w.Rate) -> Matrix:
        """The variables of a symbol or of its rate; the rate of what has entries of its own is the rate of these."""
        of: w.Node = node
        order = 0
        while isinstance(of, w.Rate) and of not in self.rules:
            of, order = of.of, order + 1
        if isinstance(node, w.Rate) and not self._is_free(of):
            return [[self.rate(entry) for entry in row] for row in self(node.of)]
        assert isinstance(of, w.Symbol)
        if order and of.constant:
            return [[ZERO] * of.shape[1]] * of.shape[0]
        names = enumerate(_names(of, order))
        return [[self.variable(name, "entry", of, order, i, j) for j, name in enumerate(row)] for i, row in names]

    def _is_free(self, node: w.Node) -> bool:
        """Whether nothing says what a symbol is."""
        if not isinstance(node, w.Symbol) or node in self.rules or node.stands_for is not None:
            return False
        return self.places.get(_names(node, 0)[0][0]) not in self._values

    def _norm(self, of: w.Node) -> Polynomial:
        """The variable of a norm; the same for all whose squares are the same, since none is negative."""
        if of not in self._norms:
            name, what, square = f"|{of}|", ("norm", of), self(w.Dot(of, of))[0][0]
            for other, place in self._norms.items():
                if not self(w.Dot(other, other))[0][0] - square:
                    self.places.setdefault(squeezed(name), place)
                    what = self.variables[place]
            length = self.variable(name, *what)
            self._norms[of] = self.places[squeezed(name)]
            self.vanish(f"norm {name}", length * length - square)
        return variable(self._norms[of])

    def _integrated(self, polynomial: Polynomial, running: frozenset[w.Symbol], body: str) -> Polynomial:
        """The integral, which is linear: a moment of the body for each product of what differs between elements."""
        total = ZERO
        for monomial, coefficient in polynomial.terms.items():
            inside, factors = 0, []
            for place, power in exponents(monomial):
                match self.variables[place]:
                    case ("entry", w.Symbol() as symbol, order, i, j) if symbol in running:
                        inside |= packed(place, power)
                        factors += [_names(symbol, order)[i][j]] * power
                    case _ if self._differs(place, running):
                        raise Rejected("what is integrated is no polynomial in what differs from element to element")
            moment = self.variable(f"int({' '.join(factors)})", "moment", inside, running, body)
            total += Polynomial({monomial - inside: coefficient}, polynomial.below) * moment
        return total

    def _is_running(self, node: w.Node, running: frozenset[w.Symbol]) -> bool:
        """Whether an expression differs from element to element."""
        match self.rules.get(node, node):
            case rule if rule is not node:
                return self._is_running(rule, running)
            case w.Integral():
                return False
            case w.Symbol(stands_for=of):
                return self._is_running(of, running) if of is not None else node in running
            case _:
                return any(self._is_running(part, running) for part in w.children(node))

    def _differs(self, place: int, running: frozenset[w.Symbol]) -> bool:
        """Whether a variable differs from element to element."""
        match self.variables[place]:
            case ("inverse", int() as k):
                return any(self._differs(other, running) for other in self.nonzero[k].places)
            case ("norm", w.Node() as of):
                return any(self._differs(other, running) for (entry,) in self(of) for other in entry.places)
            case ("entry" | "cos" | "sin", w.Symbol() as symbol, *_):
                return symbol in running
        return False

    def _turned(self, angle: w.Node) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of a sum of multiples of symbols, by the addition formulas."""
        cosine, sine = number(1), ZERO
        value = self(angle)[0][0]
        for monomial, multiple in value.terms.items():
            match [(*self.variables[place], power) for place, power in exponents(monomial)]:
                case [("entry", w.PI, *_, 1)] if 2 * multiple % value.below == 0:
                    for _ in range(2 * multiple // value.below % 4):
                        cosine, sine = -sine, cosine
                    continue
                case [("entry", w.Symbol() as symbol, 0, 0, 0, 1)] if symbol.is_scalar and symbol != w.PI:
                    unit = self._units.get(symbol.name, abs(Fraction(multiple, value.below)))
                case _:
                    raise Formless(f"{angle} is no angle: no sum of multiples of symbols and quarter turns")
            name = f"{unit.numerator if unit.numerator > 1 else ''}{symbol.name}"
            name += f"/{unit.denominator}" if unit.denominator > 1 else ""
            c = self.variable(f"cos({name})", "cos", symbol, unit)
            s = self.variable(f"sin({name})", "sin", symbol, unit)
            self.vanish(f"circle {name}", c * c + s * s - number(1))
            turns = multiple / (unit * value.below)
            if turns.denominator != 1:
                raise Rejected(f"{angle} is no whole multiple of {name}")
            s = s if turns > 0 else -s
            for _ in range(abs(turns.numerator)):
                cosine, sine = cosine * c - sine * s, sine * c + cosine * s
        return cosine, sine

    def inverse(self, node: w.Node) -> Polynomial:
        """One over a scalar; raises `Rejected` unless it is a number times a product of nonzero factors."""
        value, below = cleared(self(node)[0][0], self.nonzero)
        tops = [max(factor.terms, default=-1) for factor in self.nonzero]
        for places in (each for size in range(4) for each in combinations_with_replacement(range(len(tops)), size)):
            if (top := sum(tops[k] for k in places)) == max(value.terms, default=-1):
                nonzero = product(self.nonzero, sum(map(packed, places)))
                scale = Fraction(value.terms[top] * nonzero.below, nonzero.terms[top] * value.below)
                if not value - nonzero * number(scale):
                    return reduce(mul, map(variable, places), product(self.nonzero, below) * number(1 / scale))
        match self.rules.get(node, node):
            case w.Negative(term):
                return -self.inverse(term)
            case w.Group(of) | w.At(of, "t"):
                return self.inverse(of)
            case w.Scale(factor, term):
                return self.inverse(factor) * self.inverse(term)
            case w.Quotient(above, divisor):
                return self.inverse(above) * self(divisor)[0][0]
            case w.Power(base, exponent):
                return reduce(mul, [self.inverse(base)] * exponent)
            case rule if rule is not node:
                return self.inverse(rule)
            case _:
                raise Rejected(f"the statement divides by {node}, which nothing declares nonzero")


def squeezed(name: str) -> str:
    """A variable's name as certificates write it: without blanks, the factors of a moment in alphabetical order."""
    if name.startswith("int(") and name.endswith(")"):
        return f"int({'.'.join(sorted(name[4:-1].split()))})"
    return name.replace(" ", "")


def _names(symbol: w.Symbol, order: int) -> list[list[str]]:
    """The names of the entries: e_1, Q_12, a_dot_3, phi."""
    return entry_names(symbol.name + (f"_{'d' * order}ot" if order else ""), *symbol.shape)
