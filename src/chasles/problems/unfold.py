"""From words to polynomials: every expression becomes a matrix of fractions whose denominators are declared factors.

Time derivatives of fractions follow from the rates of the variables, by product and quotient rule.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from chasles.algebra.localization import Localization, Ratio, joined
from chasles.algebra.rings import Polynomial
from chasles.algebra.work_limit import check
from chasles.evaluation.interpreter import Interpreter
from chasles.evaluation.matrices import Matrix, each, product, transposed
from chasles.problems.divisors import Divisors
from chasles.problems.moments import BodyMoments
from chasles.problems.variables import Coordinates, NoForm, Unlisted, Untreatable, Variable, angle_multiples
from chasles.statements.rules import rated
from chasles.vocabulary import PI, At, Call, Group, Integral, Node, Norm, Rate, Symbol, plain


class Unfolder(Interpreter):
    """Unfolds expressions over one field; `values` are symbols that conditions have determined.

    The symbols that are `running` differ from element to element in an integral over a body.
    """

    def __init__(
        self,
        field: Localization,
        variables: tuple[Variable, ...],
        rules: Mapping[Node, Node],
        running: frozenset[Symbol] = frozenset(),
    ) -> None:
        super().__init__(rules)
        self.field = field
        self.variables = variables
        self.values: dict[Symbol, Matrix] = {}
        self.norms: list[tuple[Matrix, Ratio]] = []
        self.moments = BodyMoments(field, variables, running, rules)
        self.coordinates = Coordinates(field, variables)
        self.divisors = Divisors(field, rules, self)
        self.rate = Differentiation(field, variables, self.coordinates, rules, self.moments, self.divisors, self)

    def begin(self) -> None:
        check()

    def constant(self, value: Fraction) -> Ratio:
        return self.field.constant(value)

    def is_zero(self, entry: Ratio) -> bool:
        return entry.is_zero

    def quotient(self, numerator: Matrix, denominator: Node) -> Matrix:
        constant, exponents = self.divisors(denominator)
        return each(numerator, lambda entry: entry.divided(constant, exponents))

    def own(self, node: Node) -> Matrix:
        match node:
            case Symbol():
                return self._symbol(node)
            case Norm(of):
                return [[self._norm(of)]]
            case Call(function, argument):
                return [[self._circular(function, argument)]]
            case Rate(Group(of) | At(of)):
                return self(Rate(of))
            case Rate(of):
                return each(self(of), self.rate)
            case Integral(of):
                return each(self(of), self.moments.integral)
            case _:
                raise NoForm(f"{plain(node)} ({type(node).__name__}) cannot stand here: it has no polynomial form")

    def forget(self) -> None:
        """Unfold anew from here on: `values` has changed."""
        self._known.clear()
        self.rate.forget()

    def _symbol(self, symbol: Symbol) -> Matrix:
        if symbol in self.values:
            return self.values[symbol]
        rows, columns = symbol.shape
        return [[self._entry(symbol, i, j) for j in range(columns)] for i in range(rows)]

    def _entry(self, symbol: Symbol, row: int, column: int) -> Ratio:
        entry = self.coordinates.entry(symbol, 0, row, column)
        if entry is None:
            raise Unlisted(f"{plain(symbol)} has no variable for its rate of order 0")
        return entry

    def _norm(self, of: Node) -> Ratio:
        value = self(of)
        for known, variable in self.norms:
            if len(known) == len(value) and (_equal(known, value) or _equal(known, each(value, lambda x: -x))):
                return variable
        self.norms.append((value, self.coordinates.norm(of)))
        return self.norms[-1][1]

    def _circular(self, function: str, argument: Node) -> Ratio:
        """The cosine or sine of a sum of angles, by the addition formulas."""
        cosine, sine = self.field.constant(1), self.field.constant(0)
        for symbol, multiple in angle_multiples(argument, self.rules).items():
            if symbol == PI:
                for _ in range(int(2 * multiple) % 4):
                    cosine, sine = -sine, cosine
                continue
            c, s = self.coordinates.circular(symbol)
            count = multiple / self.coordinates.unit(symbol)
            if count < 0:
                s, count = -s, -count
            for _ in range(int(count)):
                cosine, sine = cosine * c - sine * s, sine * c + cosine * s
        return cosine if function == "cos" else sine


def _equal(left: Matrix, right: Matrix) -> bool:
    return all((a - b).is_zero for one, other in zip(left, right, strict=True) for a, b in zip(one, other, strict=True))


class Differentiation:
    """The derivation over one field's variables: `entries` unfolds an expression, `rules` say what one is put for."""

    def __init__(
        self,
        field: Localization,
        variables: tuple[Variable, ...],
        coordinates: Coordinates,
        rules: Mapping[Node, Node],
        moments: BodyMoments,
        divisors: Divisors,
        entries: Callable[[Node], list[list[Ratio]]],
    ) -> None:
        self.field = field
        self.variables = variables
        self.coordinates = coordinates
        self.rules = rules
        self.moments = moments
        self.divisors = divisors
        self.entries = entries
        self._known: dict[int, Ratio] = {}
        self._sought: set[int] = set()

    def forget(self) -> None:
        """Find the rates anew from here on: a symbol has been determined."""
        self._known.clear()

    def __call__(self, ratio: Ratio) -> Ratio:
        """The time derivative of a fraction, by the quotient rule over its denominator."""
        total = self.of_polynomial(ratio.numerator)
        total = Ratio(self.field, total.numerator, joined(total.denominator, ratio.denominator))
        for place, power in enumerate(ratio.denominator):
            if power:
                below = [0] * (place + 1)
                below[place] = 1
                change = self.of_polynomial(self.field.nonzero[place]) * ratio
                change = change.divided(Fraction(1), tuple(below)) * self.field.constant(power)
                total = total - change
        return total

    def of_polynomial(self, polynomial: Polynomial) -> Ratio:
        """The time derivative of a polynomial in the variables, by the chain rule."""
        total = self.field.constant(0)
        ring = self.field.ring
        for place, degree in enumerate(ring.degrees(polynomial)):
            if degree > 0:
                total = total + self.field.ratio(ring.derivative(polynomial, place)) * self._of_variable(place)
        return total

    def _of_variable(self, place: int) -> Ratio:
        if place not in self._known:
            if place in self._sought:
                raise Untreatable(f"the rate of {self.variables[place].name} is said by itself: leave out a rule")
            self._sought.add(place)
            try:
                self._known[place] = self._find(self.variables[place])
            finally:
                self._sought.remove(place)
        return self._known[place]

    def _find(self, variable: Variable) -> Ratio:
        symbol = variable.symbol
        if variable.kind == "norm":
            return self._of_norm(variable)
        if variable.kind == "moment":
            return self.moments.integral(self.of_polynomial(self.moments.integrand(variable.factors)))
        assert symbol is not None
        if symbol.constant:
            return self.field.constant(0)
        if variable.kind == "entry":
            node = rated(symbol, variable.order + 1)
            if node in self.rules:
                return self.entries(self.rules[node])[variable.row][variable.column]
            rate = self.coordinates.entry(symbol, variable.order + 1, variable.row, variable.column)
            if rate is None:
                raise Unlisted(f"a condition determines {plain(symbol)}, and speaks of its rate")
            return rate
        speed = self.entries(Rate(symbol))[0][0] * self.field.constant(self.coordinates.unit(symbol))
        cosine, sine = self.coordinates.circular(symbol)
        return -(sine * speed) if variable.kind == "cos" else cosine * speed

    def _of_norm(self, variable: Variable) -> Ratio:
        """d|x| = x . dx / |x|."""
        assert variable.node is not None
        value = self.entries(variable.node)
        change: Ratio = product(transposed(value), each(value, self))[0][0]
        constant, exponents = self.divisors(Norm(variable.node))
        return change.divided(constant, exponents)
