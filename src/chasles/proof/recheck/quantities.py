"""The quantities of a problem as variables: entries, cosines and sines, norms, moments of a body; and their rates."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from fractions import Fraction
from functools import reduce
from operator import add
from typing import Any

from chasles import vocabulary as w
from chasles.proof.recheck.expansion import Expansion, Matrix
from chasles.proof.recheck.sparse import MOST_VARIABLES, ONE, ZERO, Polynomial, Rejected, exponents, number, variable

__all__ = ["Quantities", "squeezed"]


class Quantities(Expansion):
    """Variables by place and by name, the `atoms` whose inverses come first among them, and all that is `vanishing`.

    `units` tell of which fraction of each angle, by its name, the cosine and sine are variables.
    """

    def __init__(self, rules: Mapping[w.Node, w.Node], units: Mapping[str, Fraction]) -> None:
        super().__init__(rules)
        self.variables: list[tuple[Any, ...]] = []
        self.places: dict[str, int] = {}
        self.atoms: list[Polynomial] = []
        self.vanishing: dict[str, Polynomial] = {}
        self._units = units
        self._values: dict[int, Polynomial] = {}
        self._speeds: dict[int, Polynomial] = {}
        self._norms: dict[w.Node, int] = {}

    @abstractmethod
    def cleared(self, polynomial: Polynomial) -> tuple[Polynomial, int]:
        """The polynomial times the least product of atoms that leaves no inverse in it, and the powers of these."""

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
            case ("moment", int() as inside, frozenset() as running, str() as body):
                return self._integrated(self.rate(Polynomial({inside: 1})), running, body)
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

    def integral(self, node: w.Integral) -> Matrix:
        """The integral, which is linear: a moment of the body for each product of what differs between elements."""
        for symbol in node.running & self.rules.keys():
            if not self._is_running(symbol, node.running):
                raise Rejected(f"{node} is over something that a rule defines, the same for all elements: {symbol}")
        return [[self._integrated(entry, node.running, node.body) for entry in row] for row in self(node.of)]

    def _is_running(self, node: w.Node, running: frozenset[w.Symbol]) -> bool:
        """Whether an expression differs from element to element."""
        while node in self.rules:
            node = self.rules[node]
        match node:
            case w.Integral():
                return False
            case w.Symbol(stands_for=None):
                return node in running
            case w.Symbol(stands_for=w.Node() as of):
                return self._is_running(of, running)
            case _:
                return any(self._is_running(part, running) for part in w.children(node))

    def _integrated(self, polynomial: Polynomial, running: frozenset[w.Symbol], body: str) -> Polynomial:
        total = ZERO
        for monomial, coefficient in polynomial.terms.items():
            inside, factors = 0, []
            for place, power in exponents(monomial):
                match self.variables[place]:
                    case ("entry", w.Symbol() as symbol, order, i, j) if symbol in running:
                        inside |= power << 8 * place
                        factors += [_names(symbol, order)[i][j]] * power
                    case _ if self._differs(place, running):
                        raise Rejected("what is integrated is no polynomial in what differs from element to element")
            moment = self._variable(f"int({' '.join(factors)})", "moment", inside, running, body)
            total += Polynomial({monomial - inside: coefficient}, polynomial.below) * moment
        return total

    def _differs(self, place: int, running: frozenset[w.Symbol]) -> bool:
        """Whether a variable differs from element to element."""
        match self.variables[place]:
            case ("inverse", int() as k):
                return any(self._differs(other, running) for other in self.atoms[k].places)
            case ("norm", w.Node() as of):
                return any(self._differs(other, running) for (entry,) in self(of) for other in entry.places)
            case ("entry" | "cos" | "sin", w.Symbol() as symbol, *_):
                return symbol in running
        return False

    def circular(self, angle: w.Node) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of a sum of multiples of symbols, by the addition formulas."""
        cosine, sine = ONE, ZERO
        value = self(angle)[0][0]
        for monomial, multiple in value.terms.items():
            match [(*self.variables[place], power) for place, power in exponents(monomial)]:
                case [("entry", w.PI, *_, 1)] if 2 * multiple % value.below == 0:
                    for _ in range(2 * multiple // value.below % 4):
                        cosine, sine = -sine, cosine
                    continue
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
    """A variable's name as certificates write it: without blanks, the factors of a moment in alphabetical order."""
    if name.startswith("int(") and name.endswith(")"):
        return f"int({'.'.join(sorted(name[4:-1].split()))})"
    return name.replace(" ", "")


def _names(symbol: w.Symbol, order: int) -> list[list[str]]:
    """The names of the entries: e_1, Q_12, a_dot_3, phi."""
    rows, columns = symbol.shape
    stem = symbol.name + (f"_{'d' * order}ot" if order else "")
    if columns == 1:
        return [[f"{stem}_{i + 1}" if rows > 1 else stem] for i in range(rows)]
    return [[f"{stem}_{i + 1}{j + 1}" for j in range(columns)] for i in range(rows)]
