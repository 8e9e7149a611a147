"""From words to polynomials: the one door. Every expression becomes a matrix of fractions over declared atoms.

Rates are taken here too: the derivation knows the rate of each variable; product and quotient rules do the rest.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from itertools import chain
from operator import add, mul

from chasles.proof.deadline import check
from chasles.proof.moments import Moments
from chasles.proof.ratios import Field, Ratio
from chasles.proof.variables import Untreatable, Variable, angle_multiples, angle_name
from chasles.vocabulary import (
    PI,
    At,
    Block,
    Call,
    Cofactor,
    Contract,
    Cross,
    Determinant,
    Dot,
    Group,
    Identity,
    Integral,
    Negative,
    Node,
    Norm,
    Number,
    Power,
    Quotient,
    Rate,
    Scale,
    Skew,
    Sum,
    Symbol,
    Trace,
    Transpose,
    Vect,
    Zero,
    plain,
)

__all__ = ["Matrix", "UndeclaredDivisor", "Unfolder"]

Matrix = list[list[Ratio]]


class UndeclaredDivisor(ValueError):
    """A division by something that no hypothesis says is not zero."""

    def __init__(self, divisor: Node) -> None:
        super().__init__(
            f"divides by {plain(divisor)}, which nothing declares nonzero: assume nonzero({plain(divisor)})"
        )
        self.divisor = divisor


class Unfolder:
    """Unfolds expressions over one field; `values` are symbols that conditions have determined.

    The symbols that are `running` differ from element to element in an integral over a body.
    """

    def __init__(
        self,
        field: Field,
        variables: tuple[Variable, ...],
        rules: Mapping[Node, Node],
        running: frozenset[Symbol] = frozenset(),
    ) -> None:
        self.field = field
        self.variables = variables
        self.rules = rules
        self.values: dict[Symbol, Matrix] = {}
        self.norms: list[tuple[Matrix, Ratio]] = []
        self.moments = Moments(field, variables, running, rules)
        self._place = {variable.name: place for place, variable in enumerate(variables)}
        self._entry = {(v.symbol, v.order, v.row, v.column): k for k, v in enumerate(variables) if v.kind == "entry"}
        self._known: dict[Node, Matrix] = {}
        self._rates: dict[int, Ratio] = {}
        self._rates_sought: set[int] = set()
        self._units = {v.symbol: v.unit for v in variables if v.kind == "cos" and v.symbol is not None}

    def __call__(self, node: Node) -> Matrix:
        """The entries of the expression."""
        known = self._known.get(node)
        if known is None:
            check()
            known = self._known[node] = self._unfold(node)
        return known

    def forget(self) -> None:
        """Unfold anew from here on: `values` has changed."""
        self._known.clear()
        self._rates.clear()

    def unit(self, angle: Symbol) -> Fraction:
        """The variables are the cosine and sine of this multiple of the angle."""
        return self._units[angle]

    def variable(self, place: int) -> Ratio:
        return self.field.ratio(self.field.ring.generators[place])

    def _unfold(self, node: Node) -> Matrix:
        if node in self.rules:
            return self(self.rules[node])
        match node:
            case Symbol():
                return self._symbol(node, 0)
            case Number(value):
                return [[self.field.constant(value)]]
            case Identity(size):
                return [[self.field.constant(int(i == j)) for j in range(size)] for i in range(size)]
            case Zero(rows, columns):
                return [[self.field.constant(0)] * columns for _ in range(rows)]
            case Sum(terms):
                return reduce(_plus, map(self, terms))
            case Negative(term):
                return _each(self(term), lambda entry: -entry)
            case Scale(factor, term):
                scalar = self(factor)[0][0]
                return _each(self(term), lambda entry: scalar * entry)
            case Quotient(numerator, denominator):
                constant, exponents = self._divisor(denominator)
                return _each(self(numerator), lambda entry: entry.divided(constant, exponents))
            case Contract(factors):
                return reduce(_times, map(self, factors))
            case Power(Norm(of), exponent) if exponent % 2 == 0:
                square = _times(_flipped(self(of)), self(of))
                return reduce(_times, [square] * (exponent // 2))
            case Power(base, exponent):
                return reduce(_times, [self(base)] * exponent)
            case Transpose(of):
                return _flipped(self(of))
            case Dot(left, right):
                return _times(_flipped(self(left)), self(right))
            case Norm(of):
                return [[self._norm(of)]]
            case Call(function, argument):
                return [[self._circular(function, argument)]]
            case Block(rows):
                return [list(chain(*parts)) for row in rows for parts in zip(*map(self, row), strict=True)]
            case At(of) | Group(of):
                return self(of)
            case Rate(of):
                return self._rate_of(of)
            case Integral(of):
                return _each(self(of), self.moments.integral)
            case _:
                return self._spatial(node)

    def _spatial(self, node: Node) -> Matrix:
        """The operations of three dimensions."""
        match node:
            case Skew(of):
                (x,), (y,), (z,) = self(of)
                nothing = self.field.constant(0)
                return [[nothing, -z, y], [z, nothing, -x], [-y, x, nothing]]
            case Cross(left, right):
                a, b = (([row[0] for row in self(side)]) for side in (left, right))
                return [[a[j] * b[k] - a[k] * b[j]] for j, k in ((1, 2), (2, 0), (0, 1))]
            case Vect(of):
                m = self(of)
                half = Fraction(2)
                return [[(m[k][j] - m[j][k]).divided(half, ())] for j, k in ((1, 2), (2, 0), (0, 1))]
            case Trace(of):
                m = self(of)
                return [[reduce(add, (m[i][i] for i in range(len(m))))]]
            case Determinant(of):
                return [[_determinant(self(of))]]
            case Cofactor(of):
                m = self(of)
                return [[_minor(m, i, j) for j in range(3)] for i in range(3)]
            case _:
                raise Untreatable(f"{plain(node)} ({type(node).__name__}) cannot stand here: it has no polynomial form")

    def _symbol(self, symbol: Symbol, order: int) -> Matrix:
        if symbol.stands_for is not None:
            return self(symbol.stands_for)
        if symbol in self.values:
            return self.values[symbol]
        rows, columns = symbol.shape
        return [[self.variable(self._entry[symbol, order, i, j]) for j in range(columns)] for i in range(rows)]

    def _divisor(self, node: Node) -> tuple[Fraction, tuple[int, ...]]:
        """A divisor as a constant times powers of atoms; raises `UndeclaredDivisor` if it is no such product."""
        match node:
            case Group(of):
                return self._divisor(of)
            case Number(value) if value:
                return value, ()
            case Negative(term):
                constant, exponents = self._divisor(term)
                return -constant, exponents
            case Scale(factor, term):
                (a, one), (b, other) = self._divisor(factor), self._divisor(term)
                return a * b, _joined(one, other)
            case Power(Norm(of), exponent) if exponent % 2 == 0 and not self._is_atom(Norm(of)):
                constant, exponents = self._atom(Power(Norm(of), 2))
                return constant ** (exponent // 2), tuple(e * (exponent // 2) for e in exponents)
            case Power(base, exponent):
                constant, exponents = self._divisor(base)
                return constant**exponent, tuple(e * exponent for e in exponents)
            case _:
                return self._atom(node)

    def _atom(self, node: Node) -> tuple[Fraction, tuple[int, ...]]:
        if node in self.rules:
            try:
                return self._divisor(self.rules[node])
            except UndeclaredDivisor:
                pass
        ratio = self(node)[0][0]
        for place, atom in enumerate(self.field.atoms):
            constant = _multiple(self.field, ratio.numerator, atom)
            if constant is not None:
                exponents = [0] * max(place + 1, len(ratio.denominator))
                exponents[place] = 1
                for k, power in enumerate(ratio.denominator):
                    exponents[k] -= power
                return constant, tuple(exponents)
        terms = self.field.ring.terms(ratio.numerator)
        if len(terms) == 1 and not any(terms[0][0]):
            return terms[0][1], tuple(-power for power in ratio.denominator)
        raise UndeclaredDivisor(node)

    def _is_atom(self, node: Node) -> bool:
        try:
            self._atom(node)
        except UndeclaredDivisor:
            return False
        return True

    def _norm(self, of: Node) -> Ratio:
        value = self(of)
        for known, variable in self.norms:
            if len(known) == len(value) and (_equal(known, value) or _equal(known, _each(value, lambda x: -x))):
                return variable
        place = next(k for k, v in enumerate(self.variables) if v.kind == "norm" and v.node == of)
        self.norms.append((value, self.variable(place)))
        return self.norms[-1][1]

    def _circular(self, function: str, argument: Node) -> Ratio:
        """The cosine or sine of a sum of angles, by the addition formulas."""
        cosine, sine = self.field.constant(1), self.field.constant(0)
        for symbol, multiple in angle_multiples(argument, self.rules).items():
            if symbol == PI:
                for _ in range(int(2 * multiple) % 4):
                    cosine, sine = -sine, cosine
                continue
            unit = self._units[symbol]
            name = angle_name(symbol, unit)
            c, s = (self.variable(self._place[f"{f}({name})"]) for f in ("cos", "sin"))
            times = multiple / unit
            if times < 0:
                s, times = -s, -times
            for _ in range(int(times)):
                cosine, sine = cosine * c - sine * s, sine * c + cosine * s
        return cosine if function == "cos" else sine

    def _rate_of(self, of: Node) -> Matrix:
        """The rate: that of a symbol's own rule if it has one, else by the derivation."""
        if isinstance(of, Group | At):
            return self(Rate(of.of))
        return _each(self(of), self.rate)

    def rate(self, ratio: Ratio) -> Ratio:
        """The time derivative of a fraction, by the quotient rule over its atoms."""
        total = self._polynomial_rate(ratio.numerator)
        total = Ratio(self.field, total.numerator, _joined(total.denominator, ratio.denominator))
        for place, power in enumerate(ratio.denominator):
            if power:
                below = [0] * (place + 1)
                below[place] = 1
                change = self._polynomial_rate(self.field.atoms[place]) * ratio
                change = change.divided(Fraction(1), tuple(below)) * self.field.constant(power)
                total = total - change
        return total

    def _polynomial_rate(self, polynomial: object) -> Ratio:
        total = self.field.constant(0)
        for place in range(len(self.variables)):
            partial = self.field.ring.derivative(polynomial, place)
            if partial != 0:
                total = total + self.field.ratio(partial) * self._variable_rate(place)
        return total

    def _variable_rate(self, place: int) -> Ratio:
        if place not in self._rates:
            if place in self._rates_sought:
                raise Untreatable(f"the rate of {self.variables[place].name} is said by itself: leave out a rule")
            self._rates_sought.add(place)
            self._rates[place] = self._find_rate(self.variables[place])
            self._rates_sought.remove(place)
        return self._rates[place]

    def _find_rate(self, variable: Variable) -> Ratio:
        symbol = variable.symbol
        if variable.kind == "norm":
            return self._norm_rate(variable)
        if variable.kind == "moment":
            return self.moments.integral(self._polynomial_rate(self.moments.integrand(variable.factors)))
        assert symbol is not None
        if symbol.constant:
            return self.field.constant(0)
        if variable.kind == "entry":
            node: Node = symbol
            for _ in range(variable.order + 1):
                node = Rate(node)
            if node in self.rules:
                return self(self.rules[node])[variable.row][variable.column]
            place = self._entry.get((symbol, variable.order + 1, variable.row, variable.column))
            if place is None:
                raise Untreatable(f"a condition determines {plain(symbol)}, and speaks of its rate")
            return self.variable(place)
        unit = self.field.constant(self._units[symbol])
        speed = self(Rate(symbol))[0][0] * unit
        name = variable.name.removeprefix(variable.kind)
        if variable.kind == "cos":
            return -(self.variable(self._place["sin" + name]) * speed)
        return self.variable(self._place["cos" + name]) * speed

    def _norm_rate(self, variable: Variable) -> Ratio:
        """d|x| = x . dx / |x|."""
        assert variable.node is not None
        value = self(variable.node)
        change = _times(_flipped(value), _each(value, self.rate))[0][0]
        constant, exponents = self._divisor(Norm(variable.node))
        return change.divided(constant, exponents)


def _each(matrix: Matrix, change: Callable[[Ratio], Ratio]) -> Matrix:
    return [[change(entry) for entry in row] for row in matrix]


def _plus(left: Matrix, right: Matrix) -> Matrix:
    return [[a + b for a, b in zip(one, other, strict=True)] for one, other in zip(left, right, strict=True)]


def _times(left: Matrix, right: Matrix) -> Matrix:
    columns = list(zip(*right, strict=True))
    return [[reduce(add, map(mul, row, column)) for column in columns] for row in left]


def _flipped(matrix: Matrix) -> Matrix:
    return [list(column) for column in zip(*matrix, strict=True)]


def _equal(left: Matrix, right: Matrix) -> bool:
    return all((a - b).is_zero for one, other in zip(left, right, strict=True) for a, b in zip(one, other, strict=True))


def _joined(one: tuple[int, ...], other: tuple[int, ...]) -> tuple[int, ...]:
    size = max(len(one), len(other))
    one, other = one + (0,) * (size - len(one)), other + (0,) * (size - len(other))
    return tuple(a + b for a, b in zip(one, other, strict=True))


def _multiple(field: Field, polynomial: object, atom: object) -> Fraction | None:
    """The constant c with polynomial = c atom, if there is one."""
    if polynomial == 0:
        return None
    (exponents, c), (other, d) = field.ring.leading(polynomial), field.ring.leading(atom)
    constant = c / d
    return constant if exponents == other and polynomial == atom * field.ring.constant(constant) else None


def _determinant(m: Matrix) -> Ratio:
    """The determinant, by expansion along the first row while it has zeros to save, for at most 6 x 6."""
    if len(m) == 1:
        return m[0][0]
    total: Ratio | None = None
    for j, entry in enumerate(m[0]):
        if entry.is_zero:
            continue
        minor = _determinant([row[:j] + row[j + 1 :] for row in m[1:]])
        term = entry * minor if j % 2 == 0 else -(entry * minor)
        total = term if total is None else total + term
    return total if total is not None else m[0][0]


def _minor(m: Matrix, i: int, j: int) -> Ratio:
    a, b = (i + 1) % 3, (i + 2) % 3
    c, d = (j + 1) % 3, (j + 2) % 3
    return m[a][c] * m[b][d] - m[a][d] * m[b][c]
