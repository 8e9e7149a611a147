"""What do words come to at a point? Exact values, found without the prover: its verdicts are held against these.

Every quantity is a power series in time, cut off, with rational coefficients; a rate is the next coefficient. Norms
must be rational. A number that is not rational, pi or an angle beside its own cosine and sine, is replaced by a
rational stand-in: two expressions that differ at the stand-in are different functions of the number, so they differ at
the number too, because it is transcendental. A body is a number of elements, with masses that give it the moments
that the point names: nothing but the linearity of the integral is used.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from fractions import Fraction
from itertools import chain as chain_of
from math import factorial, prod
from random import Random

from chasles import vocabulary as w
from chasles.statements import Hypothesis, Problem

from .exact_points import STAND_IN, Point
from .exact_series import (
    Broken,
    Matrix,
    Series,
    chain,
    constant,
    determinant,
    each,
    flipped,
    inverse,
    minus,
    skew,
    solution,
    square_root,
    summed,
    times,
)

__all__ = ["Broken", "Words", "number_of"]

Numbers = list[list[Fraction]]
SPARE_ELEMENTS = 3


class Words:
    """A problem's words at a point, which gives the entries of free symbols, of their rates, and cosines and sines.

    What conditions determine is solved for.
    """

    def __init__(self, problem: Problem, point: Mapping[str, Fraction]) -> None:
        self.rules = dict(problem.rules)
        self.problem = problem
        self.point = Point(point)
        self.unknowns: dict[w.Symbol, Numbers] = {}
        self._integrals: dict[tuple[w.Node, int], Matrix] = {}
        self._complete()
        self.body = _body(self.point.moments())
        if problem.unknowns:
            self._solve()

    def sides(self, left: w.Node, right: w.Node) -> tuple[Numbers, Numbers]:
        """The entries of both sides of an equation."""
        return self.value(left), self.value(right)

    def value(self, node: w.Node) -> Numbers:
        """The entries of an expression."""
        return [[entry[0] for entry in row] for row in self(node, 0)]

    def require(self) -> None:
        """Raise `Broken` unless all hypotheses and conditions of the problem are satisfied, with their rates."""
        for condition in self.problem.conditions:
            if self.value(condition.left) != self.value(condition.right):
                raise Broken(f"the condition {condition.label} is not satisfied")
        for hypothesis in self.problem.hypotheses:
            symbols = {symbol for node in hypothesis.subjects for symbol in self._free(node)}
            if all(symbol in self.unknowns or self.point.speaks_of(symbol) for symbol in symbols):
                # What is given of a quantity and of its rate agrees now; the rates of that are not asked for.
                last = 0 if hypothesis.kind == "given" else max(map(self._order, symbols), default=0)
                self._require(hypothesis, last)

    def _require(self, hypothesis: Hypothesis, order: int) -> None:
        for left, right in hypothesis.equations:
            if self(left, order) != self(right, order):
                raise Broken(f"{hypothesis.text} is not satisfied")
        for node in hypothesis.nonvanishing:
            value = self.value(node)[0][0]
            if value == 0 or (hypothesis.kind == "positive" and value < 0):
                raise Broken(f"{hypothesis.text} is not satisfied")

    def _free(self, node: w.Node) -> set[w.Symbol]:
        if node in self.rules:
            return self._free(self.rules[node])
        if isinstance(node, w.Symbol):
            return {node} if node.stands_for is None else self._free(node.stands_for)
        return {symbol for part in w.children(node) for symbol in self._free(part)}

    def _order(self, symbol: w.Symbol) -> int:
        """Up to which rate the point or a rule says what the symbol does."""
        dots = [0]
        rate: w.Node = symbol
        for order in range(1, 4):
            rate = w.Rate(rate)
            dots += [order] if rate in self.rules else []
        return max(*dots, self.point.order(symbol))

    def _complete(self) -> None:
        """Give values to what the point leaves out, since the sides do not depend on it, and a hypothesis is about."""
        for hypothesis in self.problem.hypotheses:
            for vector in hypothesis.subjects if hypothesis.kind == "unit" else ():
                if isinstance(vector, w.Symbol) and not self.point.speaks_of(vector):
                    self._set(vector, (Fraction(2, 3), Fraction(-1, 3), Fraction(2, 3)))
        nodes = [side for goal in (*self.problem.goals, *self.problem.conditions) for side in (goal.left, goal.right)]
        nodes += [*self.rules.values(), *(node for h in self.problem.hypotheses for node in h.nonvanishing)]
        for part in (part for node in nodes for part in w.walk(node)):
            if isinstance(part, w.Norm) and isinstance(part.of, w.Symbol) and not self.point.speaks_of(part.of):
                size = self.point.values.get(f"|{part.of.name}|")
                if size is not None and part.of not in self.rules:
                    self._set(part.of, (size, Fraction(0), Fraction(0)))

    def _set(self, vector: w.Symbol, values: tuple[Fraction, ...]) -> None:
        self.point.values |= {f"{vector.name}_{i + 1}": value for i, value in enumerate(values)}

    def _solve(self) -> None:
        """The values of what the conditions determine, which they contain linearly."""
        places = [(s, i, j) for s in self.problem.unknowns for i in range(s.shape[0]) for j in range(s.shape[1])]

        def residuals(values: Iterable[Fraction]) -> list[Fraction]:
            for symbol in self.problem.unknowns:
                self.unknowns[symbol] = [[Fraction(0)] * symbol.shape[1] for _ in range(symbol.shape[0])]
            for (symbol, i, j), value in zip(places, values, strict=True):
                self.unknowns[symbol][i][j] = value
            pairs = (self.sides(condition.left, condition.right) for condition in self.problem.conditions)
            lines = (line for one, other in pairs for line in zip(one, other, strict=True))
            return [a - b for x, y in lines for a, b in zip(x, y, strict=True)]

        size = len(places)
        offset = residuals([Fraction(0)] * size)
        columns = []
        for place in range(size):
            there = residuals([Fraction(int(k == place)) for k in range(size)])
            columns.append([a - b for a, b in zip(there, offset, strict=True)])
        rows = [[*row, -rest] for *row, rest in zip(*columns, offset, strict=True)]
        residuals(solution(rows, size))

    def __call__(self, node: w.Node, n: int) -> Matrix:
        """The entries of an expression as series with the powers 0 to n of time."""
        if node in self.rules:
            return self(self.rules[node], n)
        match node:
            case w.Symbol():
                return self._symbol(node, n)
            case w.Number(value):
                return [[constant(value, n)]]
            case w.Identity(size):
                return [[constant(int(i == j), n) for j in range(size)] for i in range(size)]
            case w.Zero(rows, columns):
                return [[constant(0, n) for _ in range(columns)] for _ in range(rows)]
            case w.Sum(terms):
                return _sum([self(term, n) for term in terms])
            case w.Negative(term):
                return each(self(term, n), lambda x: [-c for c in x])
            case w.Scale(factor, term):
                by = self(factor, n)[0][0]
                return each(self(term, n), lambda x: times(by, x))
            case w.Quotient(numerator, denominator):
                by = inverse(self(denominator, n)[0][0])
                return each(self(numerator, n), lambda x: times(x, by))
            case w.Contract(factors):
                return chain([self(factor, n) for factor in factors])
            case w.Power(w.Norm(of), exponent) if exponent % 2 == 0:
                square = summed([times(x, x) for (x,) in self(of, n)])
                return chain([[[square]]] * (exponent // 2))
            case w.Power(base, exponent):
                return chain([self(base, n)] * exponent)
            case w.At(of) | w.Group(of):
                return self(of, n)
            case w.Rate(w.At(of) | w.Group(of)):
                return self(w.Rate(of), n)
            case w.Rate(of):
                return each(self(of, n + 1), lambda x: [k * c for k, c in enumerate(x)][1:])
            case w.Block(rows):
                blocks = [[self(block, n) for block in row] for row in rows]
                return [list(chain_of(*parts)) for row in blocks for parts in zip(*row, strict=True)]
            case w.Integral(of):
                return self._integral(node, n)
            case _:
                return self._spatial(node, n)

    def _spatial(self, node: w.Node, n: int) -> Matrix:
        match node:
            case w.Transpose(of):
                return flipped(self(of, n))
            case w.Dot(left, right):
                return chain([flipped(self(left, n)), self(right, n)])
            case w.Cross(left, right):
                return chain([skew(self(left, n)), self(right, n)])
            case w.Skew(of):
                return skew(self(of, n))
            case w.Vect(of):
                m, half = self(of, n), constant(Fraction(1, 2), n)
                return [[times(half, minus(m[k][j], m[j][k]))] for j, k in ((1, 2), (2, 0), (0, 1))]
            case w.Trace(of):
                return [[summed([row[i] for i, row in enumerate(self(of, n))])]]
            case w.Determinant(of):
                return [[determinant(self(of, n))]]
            case w.Cofactor(of):
                m, turn = self(of, n), ((1, 2), (2, 0), (0, 1))
                return [[minus(times(m[i][k], m[j][q]), times(m[i][q], m[j][k])) for k, q in turn] for i, j in turn]
            case w.Norm(of):
                return [[square_root(summed([times(x, x) for (x,) in self(of, n)]))]]
            case w.Call(function, argument):
                return [[self._circular(argument, n)[function]]]
            case _:
                raise Broken(f"{node} has no value")

    def _symbol(self, symbol: w.Symbol, n: int) -> Matrix:
        if symbol.stands_for is not None:
            return self(symbol.stands_for, n)
        if symbol in self.unknowns:
            if n:
                raise Broken(f"the rate of {symbol}, which conditions determine, is not known here")
            return [[[x] for x in row] for row in self.unknowns[symbol]]
        if symbol == w.PI:
            return [[constant(STAND_IN, n)]]
        rows, columns = symbol.shape
        found = [[[self.point.entry(symbol, 0, i, j)] for j in range(columns)] for i in range(rows)]
        rate: w.Node = symbol
        for order in range(1, n + 1):
            rate = w.Rate(rate)
            ruled = self(self.rules[rate], n - order) if rate in self.rules else None
            for i, row in enumerate(found):
                for j, series in enumerate(row):
                    if ruled:
                        series += [c * Fraction(factorial(k), factorial(order + k)) for k, c in enumerate(ruled[i][j])]
                    else:
                        value = Fraction(0) if symbol.constant else self.point.entry(symbol, order, i, j)
                        series.append(value / factorial(order))
            if ruled:
                break
        return found

    def _integral(self, node: w.Integral, n: int) -> Matrix:
        """The sum over the elements, each with values of its own for what differs from element to element."""
        if (node, n) not in self._integrals:
            around = self.point
            terms = []
            for mass, values in self.body:
                self.point = Point(around.values | values)
                terms.append(each(self(node.of, n), lambda x, mass=mass: [mass * c for c in x]))
            self.point = around
            if not terms:
                raise Broken("the point has no moments of the body")
            self._integrals[node, n] = _sum(terms)
        return self._integrals[node, n]

    def _circular(self, argument: w.Node, n: int) -> dict[str, Series]:
        """Cosine and sine of a sum of multiples of angles: the first values from the point, the rest from the rates."""
        cosine, sine, angle = Fraction(1), Fraction(0), constant(0, n)
        for symbol, multiple in self._multiples(argument).items():
            c, s = self.point.circle(symbol, multiple)
            cosine, sine = cosine * c - sine * s, sine * c + cosine * s
            angle = summed([angle, [multiple * x for x in self._symbol(symbol, n)[0][0]]])
        cosines, sines = [cosine], [sine]
        for k in range(1, n + 1):
            change = [(j * angle[j], k - j) for j in range(1, k + 1)]
            cosines.append(-sum((a * sines[m] for a, m in change), Fraction(0)) / k)
            sines.append(sum((a * cosines[m] for a, m in change), Fraction(0)) / k)
        return {"cos": cosines, "sin": sines}

    def _multiples(self, node: w.Node) -> dict[w.Symbol, Fraction]:
        """An angle as a sum of multiples of symbols."""
        if node in self.rules:
            return self._multiples(self.rules[node])
        match node:
            case w.Symbol(stands_for=w.Node() as of) | w.Group(of) | w.At(of):
                return self._multiples(of)
            case w.Symbol():
                return {node: Fraction(1)}
            case w.Negative(of):
                return {symbol: -x for symbol, x in self._multiples(of).items()}
            case w.Scale(factor, of) if not w.symbols_of(factor):
                by = self.value(factor)[0][0]
                return {symbol: by * x for symbol, x in self._multiples(of).items()}
            case w.Quotient(of, below) if not w.symbols_of(below):
                by = self.value(below)[0][0]
                return {symbol: x / by for symbol, x in self._multiples(of).items()}
            case w.Sum(terms):
                found: dict[w.Symbol, Fraction] = {}
                for term in terms:
                    for symbol, x in self._multiples(term).items():
                        found[symbol] = found.get(symbol, Fraction(0)) + x
                return found
            case _:
                raise Broken(f"{node} is no angle")


def _sum(matrices: list[Matrix]) -> Matrix:
    return [[summed(entries) for entries in zip(*rows, strict=True)] for rows in zip(*matrices, strict=True)]


def _body(moments: Mapping[tuple[str, ...], Fraction]) -> list[tuple[Fraction, dict[str, Fraction]]]:
    """Elements with masses, not all of them positive, that have these moments; the density of each is one."""
    if not moments:
        return []
    draw = Random(0)
    names = dict.fromkeys(name for factors in moments for name in factors)
    densities = {name for name in names if all(name in factors for factors in moments)}
    elements = [
        {name: Fraction(1 if name in densities else draw.randint(-9, 9)) for name in names}
        for _ in range(len(moments) + SPARE_ELEMENTS)
    ]
    rows = [
        [*(prod((e[name] for name in factors), start=Fraction(1)) for e in elements), value]
        for factors, value in moments.items()
    ]
    return list(zip(solution(rows, len(elements)), elements, strict=True))


def number_of(text: str, names: Iterable[str] = ("pi", "phi")) -> Fraction:
    """The number that a text such as 1 - 3/4 phi^2 says, with the stand-in for the letter."""
    found = Fraction(0)
    letters = "|".join(map(re.escape, names))
    term = rf"([+-]?)\s*(\d+(?:/\d+)?)?\s*(?:({letters})(?:\^(-?\d+))?)?(?=\s[+-]\s|$)\s*"
    for sign, coefficient, letter, power in re.findall(term, text):
        if coefficient or letter:
            value = Fraction(coefficient or 1) * (STAND_IN ** int(power or 1) if letter else 1)
            found += -value if sign == "-" else value
    return found
