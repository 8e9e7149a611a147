"""What do words come to at a point? Exact values, found without the prover: its verdicts are held against these.

Every quantity is a power series in time, cut off, with rational coefficients; a rate is the next coefficient. Norms
must be rational. A number that is not rational, pi or an angle beside its own cosine and sine, is replaced by a
rational stand-in: two expressions that differ at the stand-in are different functions of the number, so they differ at
the number too, because it is transcendental.
"""

from __future__ import annotations

import functools
import operator
import re
from collections.abc import Iterable, Mapping
from fractions import Fraction
from math import factorial, isqrt

from chasles import vocabulary as w
from chasles.statements import Hypothesis, Problem

__all__ = ["STAND_IN", "Broken", "Words", "number_of"]

Series = list[Fraction]
Matrix = list[list[Series]]

STAND_IN = Fraction(22, 7)
"""Stands for pi, and for an angle whose cosine and sine are given."""


class Broken(AssertionError):
    """The point does not do what it must: it misses a value, or does not satisfy a hypothesis."""


class Words:
    """A problem's words at a point, which gives the entries of free symbols, of their rates, and cosines and sines.

    What conditions determine is solved for. A symbol about which the point says nothing is zero.
    """

    def __init__(self, problem: Problem, point: Mapping[str, Fraction]) -> None:
        self.rules = dict(problem.rules)
        self.problem = problem
        self.point = dict(point)
        self.unknowns: dict[w.Symbol, list[list[Fraction]]] = {}
        dots = [match[1] for name in point if (match := re.search(r"_(d+)ot(?:_\d+)?$", name))]
        self.order = max(map(len, dots), default=0)
        self._complete()
        if problem.unknowns:
            self._solve()

    def sides(self, left: w.Node, right: w.Node) -> tuple[list[list[Fraction]], list[list[Fraction]]]:
        """The entries of both sides of an equation."""
        return self.value(left), self.value(right)

    def value(self, node: w.Node) -> list[list[Fraction]]:
        """The entries of an expression."""
        return [[entry[0] for entry in row] for row in self(node, 0)]

    def require(self) -> None:
        """Raise `Broken` unless all hypotheses and conditions of the problem are satisfied, with their rates."""
        for condition in self.problem.conditions:
            if self.value(condition.left) != self.value(condition.right):
                raise Broken(f"the condition {condition.label} is not satisfied")
        for hypothesis in self.problem.hypotheses:
            if self._touched(hypothesis):
                self._require(hypothesis)

    def _touched(self, hypothesis: Hypothesis) -> bool:
        """Whether the point speaks of all that the hypothesis is about; about what it leaves out nothing is known."""
        return all(self._known(symbol) for node in hypothesis.subjects for symbol in self._free(node))

    def _known(self, symbol: w.Symbol) -> bool:
        return symbol in self.unknowns or any(
            re.fullmatch(rf"(cos|sin)\(\d*{re.escape(symbol.name)}(/\d+)?\)|{re.escape(symbol.name)}(_\d+)?", name)
            for name in self.point
        )

    def _free(self, node: w.Node) -> set[w.Symbol]:
        if node in self.rules:
            return self._free(self.rules[node])
        if isinstance(node, w.Symbol):
            return {node} if node.stands_for is None else self._free(node.stands_for)
        return {symbol for part in w.children(node) for symbol in self._free(part)}

    def _require(self, hypothesis: Hypothesis) -> None:
        for left, right in hypothesis.equations:
            if self(left, self.order) != self(right, self.order):
                raise Broken(f"{hypothesis.text} is not satisfied")
        for node in hypothesis.nonvanishing:
            value = self.value(node)[0][0]
            if value == 0 or (hypothesis.kind == "positive" and value < 0):
                raise Broken(f"{hypothesis.text} is not satisfied")

    def _complete(self) -> None:
        """Give values to what the point leaves out, since the sides do not depend on it, and a hypothesis is about."""
        for hypothesis in self.problem.hypotheses:
            for vector in hypothesis.subjects if hypothesis.kind == "unit" else ():
                if isinstance(vector, w.Symbol) and not self._known(vector):
                    self._set(vector, (Fraction(2, 3), Fraction(-1, 3), Fraction(2, 3)))
        nodes = [side for goal in (*self.problem.goals, *self.problem.conditions) for side in (goal.left, goal.right)]
        nodes += [*self.rules.values(), *(node for h in self.problem.hypotheses for node in h.nonvanishing)]
        for part in (part for node in nodes for part in w.walk(node)):
            if isinstance(part, w.Norm) and isinstance(part.of, w.Symbol) and not self._known(part.of):
                size = self.point.get(f"|{part.of.name}|")
                if size is not None and part.of not in self.rules:
                    self._set(part.of, (size, Fraction(0), Fraction(0)))

    def _set(self, vector: w.Symbol, values: tuple[Fraction, ...]) -> None:
        self.point |= {f"{vector.name}_{i + 1}": value for i, value in enumerate(values)}

    def _solve(self) -> None:
        """The values of what the conditions determine, which they contain linearly."""
        places = [(s, i, j) for s in self.problem.unknowns for i in range(s.shape[0]) for j in range(s.shape[1])]

        def residuals(values: Iterable[Fraction]) -> list[Fraction]:
            for symbol in self.problem.unknowns:
                self.unknowns[symbol] = [[Fraction(0)] * symbol.shape[1] for _ in range(symbol.shape[0])]
            for (symbol, i, j), value in zip(places, values, strict=True):
                self.unknowns[symbol][i][j] = value
            pairs = (self.sides(c.left, c.right) for c in self.problem.conditions)
            return [
                a - b
                for one, other in pairs
                for x, y in zip(one, other, strict=True)
                for a, b in zip(x, y, strict=True)
            ]

        size = len(places)
        offset = residuals([Fraction(0)] * size)
        columns = [
            [a - b for a, b in zip(residuals([Fraction(int(k == place)) for k in range(size)]), offset, strict=True)]
            for place in range(size)
        ]
        rows = [[*row, -constant] for *row, constant in zip(*columns, offset, strict=True)]
        residuals(_solution(rows, size))

    def __call__(self, node: w.Node, n: int) -> Matrix:
        """The entries of an expression as series with the powers 0 to n of time."""
        if node in self.rules:
            return self(self.rules[node], n)
        match node:
            case w.Symbol():
                return self._symbol(node, n)
            case w.Number(value):
                return [[_constant(value, n)]]
            case w.Identity(size):
                return [[_constant(int(i == j), n) for j in range(size)] for i in range(size)]
            case w.Zero(rows, columns):
                return [[_constant(0, n) for _ in range(columns)] for _ in range(rows)]
            case w.Sum(terms):
                matrices = [self(term, n) for term in terms]
                return [
                    [_total(entries) for entries in zip(*rows, strict=True)] for rows in zip(*matrices, strict=True)
                ]
            case w.Negative(term):
                return _each(self(term, n), lambda x: [-c for c in x])
            case w.Scale(factor, term):
                by = self(factor, n)[0][0]
                return _each(self(term, n), lambda x: _product(by, x))
            case w.Quotient(numerator, denominator):
                by = _inverse(self(denominator, n)[0][0])
                return _each(self(numerator, n), lambda x: _product(x, by))
            case w.Contract(factors):
                return _chain([self(factor, n) for factor in factors])
            case w.Power(w.Norm(of), exponent) if exponent % 2 == 0:
                square = _total([_product(x, x) for (x,) in self(of, n)])
                return _chain([[[square]]] * (exponent // 2))
            case w.Power(base, exponent):
                return _chain([self(base, n)] * exponent)
            case w.At(of) | w.Group(of):
                return self(of, n)
            case w.Rate(of):
                return self._rate(of, n)
            case w.Block(rows):
                return [
                    functools.reduce(operator.iadd, parts, [])
                    for row in rows
                    for parts in zip(*(self(b, n) for b in row), strict=True)
                ]
            case _:
                return self._spatial(node, n)

    def _spatial(self, node: w.Node, n: int) -> Matrix:
        match node:
            case w.Transpose(of):
                return _flipped(self(of, n))
            case w.Dot(left, right):
                return _chain([_flipped(self(left, n)), self(right, n)])
            case w.Cross(left, right):
                return _chain([_skew(self(left, n)), self(right, n)])
            case w.Skew(of):
                return _skew(self(of, n))
            case w.Vect(of):
                m = self(of, n)
                half = _constant(Fraction(1, 2), n)
                return [[_product(half, _less(m[k][j], m[j][k]))] for j, k in ((1, 2), (2, 0), (0, 1))]
            case w.Trace(of):
                m = self(of, n)
                return [[_total([m[i][i] for i in range(len(m))])]]
            case w.Determinant(of):
                return [[_determinant(self(of, n))]]
            case w.Cofactor(of):
                m = self(of, n)
                turn = ((1, 2), (2, 0), (0, 1))
                return [
                    [_less(_product(m[i][k], m[j][q]), _product(m[i][q], m[j][k])) for k, q in turn] for i, j in turn
                ]
            case w.Norm(of):
                return [[_root(_total([_product(x, x) for (x,) in self(of, n)]))]]
            case w.Call(function, argument):
                return [[self._circular(argument, n)[function]]]
            case _:
                raise Broken(f"{node} has no value")

    def _symbol(self, symbol: w.Symbol, n: int) -> Matrix:
        if symbol.stands_for is not None:
            return self(symbol.stands_for, n)
        rows, columns = symbol.shape
        if symbol in self.unknowns:
            if n:
                raise Broken(f"the rate of {symbol}, which conditions determine, is not known here")
            return _each([[[x] for x in row] for row in self.unknowns[symbol]], lambda x: x)
        if symbol == w.PI:
            return [[_constant(STAND_IN, n)]]
        found = [[[self._entry(symbol, 0, i, j)] for j in range(columns)] for i in range(rows)]
        rate: w.Node = symbol
        for order in range(1, n + 1):
            rate = w.Rate(rate)
            if rate in self.rules:
                later = self(self.rules[rate], n - order)
                for i, row in enumerate(later):
                    for j, entry in enumerate(row):
                        found[i][j] += [c * Fraction(factorial(k), factorial(order + k)) for k, c in enumerate(entry)]
                return found
            for i in range(rows):
                for j in range(columns):
                    value = Fraction(0) if symbol.constant else self._entry(symbol, order, i, j)
                    found[i][j].append(value / factorial(order))
        return found

    def _entry(self, symbol: w.Symbol, order: int, i: int, j: int) -> Fraction:
        stem = symbol.name + (f"_{'d' * order}ot" if order else "")
        rows, columns = symbol.shape
        name = stem if rows == columns == 1 else f"{stem}_{i + 1}" if columns == 1 else f"{stem}_{i + 1}{j + 1}"
        if name in self.point:
            return self.point[name]
        return STAND_IN if order == 0 and self._measures(symbol) else Fraction(0)

    def _measures(self, symbol: w.Symbol) -> dict[Fraction, str]:
        """The names of the point's cosines or sines of an angle, by the multiple of the angle."""
        found = {}
        for name in self.point:
            match = re.fullmatch(rf"(?:cos|sin)\((\d*){re.escape(symbol.name)}(?:/(\d+))?\)", name)
            if match:
                found[Fraction(int(match[1] or 1), int(match[2] or 1))] = name[3:]
        return found

    def _circular(self, argument: w.Node, n: int) -> dict[str, Series]:
        """Cosine and sine of a sum of multiples of angles: the first values from the point, the rest from the rates."""
        cosine, sine = Fraction(1), Fraction(0)
        angle = _constant(0, n)
        for symbol, multiple in self._multiples(argument).items():
            c, s = self._multiple(symbol, multiple)
            cosine, sine = cosine * c - sine * s, sine * c + cosine * s
            angle = _total([angle, [multiple * x for x in self._symbol(symbol, n)[0][0]]])
        cosines, sines = [cosine], [sine]
        for k in range(1, n + 1):
            change = [(j * angle[j], k - j) for j in range(1, k + 1)]
            cosines.append(-sum((a * sines[m] for a, m in change), Fraction(0)) / k)
            sines.append(sum((a * cosines[m] for a, m in change), Fraction(0)) / k)
        return {"cos": cosines, "sin": sines}

    def _multiples(self, node: w.Node) -> dict[w.Symbol, Fraction]:
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
                total: dict[w.Symbol, Fraction] = {}
                for term in terms:
                    for symbol, x in self._multiples(term).items():
                        total[symbol] = total.get(symbol, Fraction(0)) + x
                return total
            case _:
                raise Broken(f"{node} is no angle")

    def _multiple(self, symbol: w.Symbol, multiple: Fraction) -> tuple[Fraction, Fraction]:
        measures = self._measures(symbol)
        if not measures and multiple:
            raise Broken(f"the point has no cosine of {symbol}")
        for unit, name in measures.items():
            times = multiple / unit
            if times.denominator == 1:
                c, s = self._circle(name)
                if times < 0:
                    s, times = -s, -times
                cosine, sine = Fraction(1), Fraction(0)
                for _ in range(int(times)):
                    cosine, sine = cosine * c - sine * s, sine * c + cosine * s
                return cosine, sine
        raise Broken(f"the point has no cosine of {multiple} {symbol}")

    def _circle(self, name: str) -> tuple[Fraction, Fraction]:
        """Cosine and sine; one that the point leaves out does not matter, so the other gives it."""
        c, s = self.point.get("cos" + name), self.point.get("sin" + name)
        if c is None or s is None:
            known = c if c is not None else s
            assert known is not None
            other = _rational_root(1 - known * known)
            c, s = (known, other) if c is not None else (other, known)
        if c * c + s * s != 1:
            raise Broken(f"cosine and sine of {name} are not on the unit circle")
        return c, s

    def _rate(self, of: w.Node, n: int) -> Matrix:
        if isinstance(of, w.At | w.Group):
            return self(w.Rate(of.of), n)
        return _each(self(of, n + 1), lambda x: [k * c for k, c in enumerate(x)][1:])


def number_of(text: str, names: Iterable[str] = ("pi", "phi")) -> Fraction:
    """The number that a text such as 1 - 3/4 phi^2 says, with the stand-in for the letter."""
    total = Fraction(0)
    letters = "|".join(map(re.escape, names))
    for sign, coefficient, letter, power in re.findall(
        rf"([+-]?)\s*(\d+(?:/\d+)?)?\s*(?:({letters})(?:\^(-?\d+))?)?(?=\s[+-]\s|$)\s*", text
    ):
        if coefficient or letter:
            term = Fraction(coefficient or 1) * (STAND_IN ** int(power or 1) if letter else 1)
            total += -term if sign == "-" else term
    return total


def _constant(value: Fraction | int, n: int) -> Series:
    return [Fraction(value), *[Fraction(0)] * n]


def _total(entries: Iterable[Series]) -> Series:
    return [sum(coefficients, Fraction(0)) for coefficients in zip(*entries, strict=True)]


def _less(one: Series, other: Series) -> Series:
    return [a - b for a, b in zip(one, other, strict=True)]


def _product(one: Series, other: Series) -> Series:
    return [sum((one[k] * other[m - k] for k in range(m + 1)), Fraction(0)) for m in range(len(one))]


def _inverse(series: Series) -> Series:
    if series[0] == 0:
        raise Broken("a divisor is zero")
    found = [1 / series[0]]
    for m in range(1, len(series)):
        found.append(-sum((series[k] * found[m - k] for k in range(1, m + 1)), Fraction(0)) / series[0])
    return found


def _root(series: Series) -> Series:
    found = [_rational_root(series[0])]
    if not any(series):
        return series
    for m in range(1, len(series)):
        if found[0] == 0:
            raise Broken("the rate of a norm where the norm is zero")
        found.append((series[m] - sum((found[k] * found[m - k] for k in range(1, m)), Fraction(0))) / (2 * found[0]))
    return found


def _rational_root(square: Fraction) -> Fraction:
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator)) if square >= 0 else Fraction(0)
    if root * root != square:
        raise Broken(f"{square} is not the square of a rational number")
    return root


def _each(matrix: Matrix, change: object) -> Matrix:
    assert callable(change)
    return [[change(entry) for entry in row] for row in matrix]


def _flipped(matrix: Matrix) -> Matrix:
    return [list(column) for column in zip(*matrix, strict=True)]


def _chain(matrices: list[Matrix]) -> Matrix:
    total = matrices[0]
    for matrix in matrices[1:]:
        columns = list(zip(*matrix, strict=True))
        total = [[_total(map(_product, row, column)) for column in columns] for row in total]
    return total


def _skew(vector: Matrix) -> Matrix:
    (x,), (y,), (z,) = vector
    nothing = _less(x, x)
    return [[nothing, _less(nothing, z), y], [z, nothing, _less(nothing, x)], [_less(nothing, y), x, nothing]]


def _determinant(matrix: Matrix) -> Series:
    if len(matrix) == 1:
        return matrix[0][0]
    terms = []
    for j, entry in enumerate(matrix[0]):
        if any(entry):
            minor = _product(entry, _determinant([row[:j] + row[j + 1 :] for row in matrix[1:]]))
            terms.append(minor if j % 2 == 0 else [-c for c in minor])
    return _total(terms) if terms else _less(matrix[0][0], matrix[0][0])


def _solution(rows: list[list[Fraction]], size: int) -> list[Fraction]:
    """A solution of the linear system whose last column is the right side; raises `Broken` if there is none."""
    pivots: list[int] = []
    for column in range(size):
        done = len(pivots)
        row = next((r for r in range(done, len(rows)) if rows[r][column]), None)
        if row is None:
            continue
        rows[done], rows[row] = rows[row], rows[done]
        rows[done] = [x / rows[done][column] for x in rows[done]]
        for r, line in enumerate(rows):
            if r != done and line[column]:
                rows[r] = [x - line[column] * y for x, y in zip(line, rows[done], strict=True)]
        pivots.append(column)
    if any(row[-1] for row in rows[len(pivots) :]):
        raise Broken("the conditions contradict each other at the point")
    found = [Fraction(0)] * size
    for place, column in enumerate(pivots):
        found[column] = rows[place][-1]
    return found
