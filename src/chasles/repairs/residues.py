"""Expressions at generic points, in residues modulo a large prime: fast enough to try out thousands of them.

The points satisfy the hypotheses exactly. Angles are as generic as residues can be, never right or zero: at a special
point terms coincide that are different everywhere else.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain, islice
from random import Random

from chasles import vocabulary as w
from chasles.algebra.modular import MODULUS, Column, inverted
from chasles.algebra.rings import Polynomial
from chasles.algebra.work_limit import check, spend
from chasles.evaluation.interpreter import Interpreter
from chasles.evaluation.matrices import Matrix, each
from chasles.points import sampling as points
from chasles.problems.context import Context
from chasles.problems.variables import Untreatable
from chasles.prover.conditions import Solved
from chasles.statements.lengths import Lengths
from chasles.vocabulary import Node
from chasles.vocabulary.differentiation import NoRule, rate_of
from chasles.vocabulary.partial import CarriedOut, with_derivatives

Point = Mapping[str, int]
A_TERM = 12
"""What a term of a polynomial, put in or read at a point, counts as, in products."""
_Coded = list[tuple[int, list[tuple[str, int]]]]


class SingularResidue(ValueError):
    """A division by zero at a generic point: the divisor vanishes everywhere."""


class Unsampled(LookupError):
    """An expression that has no value at the points: it did not occur when they were drawn, or has no such form."""


@dataclass(frozen=True, slots=True)
class Residues:
    """The residues of a scalar `at` each of a number of points."""

    at: Column

    def __add__(self, other: Residues) -> Residues:
        return Residues([(a + b) % MODULUS for a, b in zip(self.at, other.at, strict=True)])

    def __sub__(self, other: Residues) -> Residues:
        return Residues([(a - b) % MODULUS for a, b in zip(self.at, other.at, strict=True)])

    def __neg__(self) -> Residues:
        return Residues([-a % MODULUS for a in self.at])

    def __mul__(self, other: Residues) -> Residues:
        return Residues([a * b % MODULUS for a, b in zip(self.at, other.at, strict=True)])

    @property
    def inverse(self) -> Residues:
        """One over the scalar; raises `SingularResidue` where it vanishes at a point."""
        return Residues(list(map(inverse, self.at)))


class Sampled(Interpreter):
    """The values of expressions at a number of points of a context; raises `SingularResidue` for a division by zero."""

    def __init__(self, context: Context, at: Sequence[Point]) -> None:
        super().__init__(context.unfold.rules)
        self.context, self.points = context, at
        problem = context.problem
        self._lengths = Lengths(problem.hypotheses, dict(problem.rules))
        self._directions = {s.name: s for h in problem.hypotheses if h.kind == "direction" for s in h.subjects
                            if isinstance(s, w.Symbol)}  # fmt: skip
        self._angles = {v.symbol.name: v.symbol for v in context.variables if v.symbol is not None}

    def flat(self, node: Node) -> Column:
        """All entries at all points."""
        return list(chain.from_iterable(zip(*(entry.at for row in self(node) for entry in row), strict=True)))

    def times(self, scalar: Node, column: Column) -> Column:
        """A column of numbers at all points, each times the scalar's value at its point."""
        values = self.scalar(scalar).at
        size = len(column) // len(values)
        return [entry * values[k // size] % MODULUS for k, entry in enumerate(column)]

    def begin(self) -> None:
        check()

    def constant(self, value: Fraction) -> Residues:
        return Residues([residue(value)] * len(self.points))

    def quotient(self, numerator: Matrix, denominator: Node) -> Matrix:
        below = self.scalar(denominator).inverse
        return each(numerator, lambda entry: entry * below)

    def entries(self, node: Node) -> Matrix:
        match node:
            case _ if node in self.rules:
                return super().entries(node)
            case w.Inverse(of):
                found, _ = self._inverted(of)
                if not found:
                    raise SingularResidue("a matrix has no inverse at a generic point")
                return found
            case w.Determinant(of):
                return [[self._inverted(of)[1]]]
            case CarriedOut():
                try:
                    return self(with_derivatives(node, self.rules))
                except NoRule:
                    raise Unsampled(node) from None
            case w.Rate(w.Inverse(of)):
                return self(w.Negative(w.Contract((w.Inverse(of), w.Rate(of), w.Inverse(of)))))
            case w.Rate(of) if not isinstance(of, w.Symbol | w.Rate):
                # By its parts: all of it unfolded would be polynomials of many terms.
                try:
                    return self(rate_of(of))
                except NoRule:
                    if any(map(_is_foreign, w.walk(of))):
                        raise Unsampled(node) from None
                    return super().entries(node)
            case _:
                return super().entries(node)

    def _inverted(self, of: Node) -> tuple[Matrix, Residues]:
        """The inverse of a square matrix, none where it is singular at a point, and its determinant."""
        rows = self(of)
        found = [inverted([[entry.at[k] for entry in row] for row in rows]) for k in range(len(self.points))]
        determinant = Residues([each for _, each in found])
        if not all(determinant.at):
            return [], determinant
        places = range(len(rows))
        return [[Residues([each[i][j] for each, _ in found]) for j in places] for i in places], determinant

    def own(self, node: Node) -> Matrix:
        """What only the prover's own unfolding knows: free symbols, rates, norms, angles."""
        field = self.context.unfold.field
        try:
            found = self.context.unfold(self._said(node))
        except (KeyError, StopIteration, Untreatable):
            raise Unsampled(node) from None
        below = {d: self._at(field.power_product(d)).inverse for d in {e.denominator for row in found for e in row}}
        return each(found, lambda entry: self._at(entry.numerator) * below[entry.denominator])

    def _said(self, node: Node) -> Node:
        """The node as the problem says it: lengths of simpler vectors, rotation vectors as angles times directions."""
        values: dict[Node, Node] = {}
        for symbol in w.symbols_of(node) if self._directions else ():
            length = f"|{symbol.name}|"
            direction, angle = self._directions.get(f"{symbol.name}/{length}"), self._angles.get(length)
            if direction is not None and angle is not None:
                values |= {w.Norm(symbol): angle, symbol: w.Scale(angle, direction)}
        return w.replace(self._lengths(node), values)

    def _at(self, polynomial: Polynomial) -> Residues:
        coded = _coded(self.context, polynomial)
        spend(A_TERM * len(coded) * (1 + len(self.points)))
        return Residues([_value(coded, point) for point in self.points])


def _is_foreign(part: Node) -> bool:
    """Whether the prover unfolds it by other words only."""
    return isinstance(part, w.Inverse) or part.has_no_polynomial_form


def generic_points(context: Context, solved: tuple[Solved, ...], count: int) -> tuple[list[Point], list[Point]]:
    """Points of a context, in residues, with other angles at each; and the same with the same angles at all of them.

    No angle can be had from another. There are fewer points where they are hard to find.
    """
    field, draw = context.field, Random(0)
    ratios = {s.variable: (s.value.numerator, field.power_product(s.value.denominator)) for s in solved}
    generators = [_coded(context, g.polynomial) for g in context.generators]
    nonzero = [_coded(context, factor) for _, factor in context.nonzero]
    bound = [*generators, *(_coded(context, each) for ratio in ratios.values() for each in ratio)]
    tied = {*ratios, *(name for polynomial in bound for _, powers in polynomial for name, _ in powers)}
    free = [v.name for v in context.variables if v.kind == "entry" and v.name not in tied]
    same = _tangents(context, draw)
    varied: list[Point] = []
    fixed: list[Point] = []
    for point in islice(points.sample(context, ratios, simple=False), 2 * count):
        bare = {name: residue(value) for name, value in point.items()}
        # Small numbers coincide and vanish too often to tell one letter from another.
        bare |= {name: draw.randrange(1, MODULUS) for name in free if name in bare}
        pairs = [[bare | dict(_turned(context, tangents)) for tangents in (_tangents(context, draw), same)], [bare] * 2]
        # A length that depends on angles holds them: then they differ at the fixed points too.
        for pair in pairs:
            if not any(_value(g, p) for g in generators for p in pair) and all(
                _value(a, p) for a in nonzero for p in pair
            ):
                varied.append(pair[0])
                fixed.append(pair[1])
                break
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
