"""Expressions at generic points, in residues modulo a large prime: fast enough to try out thousands of them.

The points satisfy the hypotheses exactly. Angles are as generic as residues can be, never right or zero: at a special
point terms coincide that are different everywhere else.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from itertools import islice
from random import Random

from chasles.algebra.modular import MODULUS, Column
from chasles.algebra.rings import Polynomial
from chasles.algebra.work_limit import check
from chasles.points import sampling as points
from chasles.problems.context import Context
from chasles.problems.variables import Untreatable
from chasles.prover.conditions import Solved
from chasles.vocabulary import (
    At,
    Block,
    Contract,
    Cross,
    Dot,
    Group,
    Identity,
    Negative,
    Node,
    Norm,
    Number,
    Power,
    Quotient,
    Scale,
    Skew,
    Sum,
    Symbol,
    Trace,
    Transpose,
    Vect,
    Zero,
)

__all__ = ["Sampled", "SingularResidue", "Unsampled", "generic_points", "inverse"]

Matrix = list[list[int]]
Values = list[Matrix]
Point = Mapping[str, int]


class SingularResidue(ValueError):
    """A division by zero at a generic point: the divisor vanishes everywhere."""


class Unsampled(LookupError):
    """An expression that has no value at the points: it did not occur when they were drawn, or has no such form."""


class Sampled:
    """The values of expressions at a number of points of a context."""

    def __init__(self, context: Context, at: Sequence[Point]) -> None:
        self.context, self.points = context, at
        self._known: dict[Node, Values] = {}

    def flat(self, node: Node) -> Column:
        """All entries at all points."""
        return [entry for matrix in self(node) for row in matrix for entry in row]

    def __call__(self, node: Node) -> Values:
        """The expression's matrix at each point; raises `SingularResidue` where it divides by zero."""
        known = self._known.get(node)
        if known is None:
            check()
            known = self._known[node] = self._evaluated(node)
        return known

    def _evaluated(self, node: Node) -> Values:
        rules = self.context.unfold.rules
        if node in rules:
            return self(rules[node])
        match node:
            case Symbol(stands_for=Node() as of) | At(of) | Group(of):
                return self(of)
            case Number(value):
                return [[[residue(value)]]] * len(self.points)
            case Identity(size):
                return [[[int(i == j) for j in range(size)] for i in range(size)]] * len(self.points)
            case Zero(rows, columns):
                return [[[0] * columns] * rows] * len(self.points)
            case Sum(terms):
                return [reduce(_plus, matrices) for matrices in zip(*map(self, terms), strict=True)]
            case Negative(term):
                return [_scaled(-1, matrix) for matrix in self(term)]
            case Scale(factor, term):
                return [_scaled(f[0][0], matrix) for f, matrix in zip(self(factor), self(term), strict=True)]
            case Quotient(numerator, denominator):
                pairs = zip(self(denominator), self(numerator), strict=True)
                return [_scaled(inverse(d[0][0]), matrix) for d, matrix in pairs]
            case Contract(factors):
                return [reduce(_times, matrices) for matrices in zip(*map(self, factors), strict=True)]
            case Power(Norm(of), exponent) if exponent % 2 == 0:
                return [reduce(_times, [_times(_flipped(m), m)] * (exponent // 2)) for m in self(of)]
            case Power(base, exponent):
                return [reduce(_times, [matrix] * exponent) for matrix in self(base)]
            case Transpose(of):
                return [_flipped(matrix) for matrix in self(of)]
            case Block(rows):
                lines = [zip(*map(self, row), strict=True) for row in rows]
                return [_stacked(parts) for parts in zip(*lines, strict=True)]
            case _:
                return self._spatial(node)

    def _spatial(self, node: Node) -> Values:
        match node:
            case Dot(left, right):
                return [_times(_flipped(a), b) for a, b in zip(self(left), self(right), strict=True)]
            case Cross(left, right):
                return [_times(_skew(a), b) for a, b in zip(self(left), self(right), strict=True)]
            case Skew(of):
                return [_skew(matrix) for matrix in self(of)]
            case Vect(of):
                half = residue(Fraction(1, 2))
                places = ((1, 2), (2, 0), (0, 1))
                return [[[(m[k][j] - m[j][k]) * half % MODULUS] for j, k in places] for m in self(of)]
            case Trace(of):
                return [[[sum(row[i] for i, row in enumerate(matrix)) % MODULUS]] for matrix in self(of)]
            case _:
                return self._unfolded(node)

    def _unfolded(self, node: Node) -> Values:
        """What only the prover's own unfolding knows: free symbols, rates, norms, angles."""
        field = self.context.unfold.field
        try:
            found = self.context.unfold(node)
        except (KeyError, StopIteration, Untreatable):
            raise Unsampled(node) from None
        values: Values = []
        entries = [[(_coded(self.context, e.numerator), e.denominator) for e in row] for row in found]
        nonzero = {d: _coded(self.context, field.power_product(d)) for row in entries for _, d in row}
        for point in self.points:
            below = {d: inverse(_value(factor, point)) for d, factor in nonzero.items()}
            values.append([[_value(above, point) * below[d] % MODULUS for above, d in row] for row in entries])
        return values


def generic_points(context: Context, solved: tuple[Solved, ...], count: int) -> tuple[list[Point], list[Point]]:
    """Points of a context, in residues, with other angles at each; and the same with the same angles at all of them.

    No angle can be had from another. There are fewer points where they are hard to find.
    """
    field, draw = context.field, Random(0)
    ratios = {s.variable: (s.value.numerator, field.power_product(s.value.denominator)) for s in solved}
    generators = [_coded(context, g.polynomial) for g in context.generators]
    nonzero = [_coded(context, factor) for _, factor in context.nonzero]
    same = _tangents(context, draw)
    varied: list[Point] = []
    fixed: list[Point] = []
    for point in islice(points.sample(context, ratios, simple=False), 2 * count):
        bare = {name: residue(value) for name, value in point.items()}
        pair = [bare | dict(_turned(context, tangents)) for tangents in (_tangents(context, draw), same)]
        if all(not any(_value(g, p) for g in generators) and all(_value(a, p) for a in nonzero) for p in pair):
            varied.append(pair[0])
            fixed.append(pair[1])
        if len(varied) == count:
            break
    return varied, fixed


def _tangents(context: Context, draw: Random) -> dict[str, int]:
    """A number for each angle: one for its cosine and sine, and one for itself where it stands alone."""
    names = [variable.name for variable in context.variables if variable.kind == "cos"]
    names += [context.variables[place].name for place in sorted(context.transcendental)]
    return {name: draw.randrange(MODULUS) for name in names}


def _turned(context: Context, tangents: Mapping[str, int]) -> Iterator[tuple[str, int]]:
    """Cosines, sines and bare angles, each generic."""
    for variable in context.variables:
        if variable.kind == "cos":
            tangent = tangents[variable.name]
            below = inverse(1 + tangent * tangent)
            yield variable.name, (1 - tangent * tangent) * below % MODULUS
            yield "sin" + variable.name.removeprefix("cos"), 2 * tangent * below % MODULUS
    for place in context.transcendental:
        yield context.variables[place].name, tangents[context.variables[place].name]


def residue(value: Fraction) -> int:
    """The residue of a rational number."""
    return value.numerator * inverse(value.denominator) % MODULUS


def inverse(value: int) -> int:
    """The residue of one over a number; raises `SingularResidue` for zero."""
    if value % MODULUS == 0:
        raise SingularResidue("a divisor vanishes at a generic point")
    return pow(value, -1, MODULUS)


_Coded = list[tuple[int, list[tuple[str, int]]]]


def _coded(context: Context, polynomial: Polynomial) -> _Coded:
    """A polynomial as coefficients with the names and exponents of what they multiply."""
    names = context.field.ring.names
    terms = context.field.ring.terms(polynomial)
    return [(residue(c), [(names[k], e) for k, e in enumerate(exponents) if e]) for exponents, c in terms]


def _value(polynomial: _Coded, point: Point) -> int:
    total = 0
    for coefficient, powers in polynomial:
        term = coefficient
        for name, exponent in powers:
            term = term * point[name] ** exponent % MODULUS
        total += term
    return total % MODULUS


def _plus(left: Matrix, right: Matrix) -> Matrix:
    rows = zip(left, right, strict=True)
    return [[(a + b) % MODULUS for a, b in zip(one, other, strict=True)] for one, other in rows]


def _times(left: Matrix, right: Matrix) -> Matrix:
    columns = list(zip(*right, strict=True))
    return [[sum(a * b for a, b in zip(row, column, strict=True)) % MODULUS for column in columns] for row in left]


def _scaled(factor: int, matrix: Matrix) -> Matrix:
    return [[factor * entry % MODULUS for entry in row] for row in matrix]


def _flipped(matrix: Matrix) -> Matrix:
    return [list(column) for column in zip(*matrix, strict=True)]


def _skew(vector: Matrix) -> Matrix:
    (x,), (y,), (z,) = vector
    return [[0, -z % MODULUS, y], [z, 0, -x % MODULUS], [-y % MODULUS, x, 0]]


def _stacked(lines: Iterable[tuple[Matrix, ...]]) -> Matrix:
    return [[entry for row in parts for entry in row] for line in lines for parts in zip(*line, strict=True)]
