"""A modular test of an equation: the residual of its sides at random points, and what a change contributes to it.

Both are evaluated modulo a large prime. A residual that is zero at all points is zero with high probability (Schwartz,
J. ACM 27, 1980; Zippel, EUROSAM 1979): what passes is a conjecture, which the prover then decides.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from dataclasses import replace as with_fields
from fractions import Fraction
from functools import cached_property
from itertools import combinations_with_replacement

from chasles import vocabulary as w
from chasles.algebra.modular import Column, Span, minus, multiple, normalized, plus
from chasles.problems.context import build
from chasles.problems.divisors import UndeclaredDivisor
from chasles.problems.variables import Untreatable
from chasles.prover.conditions import solve_conditions
from chasles.repairs.residues import Sampled, SingularResidue, Unsampled, generic_points
from chasles.rewriting.coefficients import ONE, AngleFunction, Term, split
from chasles.rewriting.places import Path, Place, put, with_term
from chasles.rewriting.term_basis import fit
from chasles.statements import Claim, Goal, Problem, Statement, problem_of
from chasles.statements.goals import AcceptedSides
from chasles.vocabulary import Node

REFUSED = (w.Misfit, TypeError, Untreatable, UndeclaredDivisor, SingularResidue, Unsampled)
"""Why an equation cannot be tested: it does not fit, cannot be posed, is not treated, or divides by zero."""
Direction = tuple[int, ...]

POINTS, NUMBERS = 8, 30
"""So many points are drawn at least, and so many that at least so many numbers are compared."""
PROBED = 3
"""Points at which a change is tried first."""


@dataclass(frozen=True)
class ModularTest:
    """An equation at points where its hypotheses hold: the angles differ at the `varied`, not at the `fixed` ones.

    With the sides `exchanged`, a multiple of the whole of the right one is left to the other test.
    """

    statement: Statement
    left: Node
    right: Node
    problem: Problem
    varied: Sampled
    fixed: Sampled
    exchanged: bool = False
    probe: Sampled = field(init=False)
    _contributions: dict[tuple[int, Path, Node | None], Column] = field(init=False, default_factory=dict)
    _directions: dict[Node, Direction] = field(init=False, default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "probe", Sampled(self.fixed.context, self.fixed.points[:PROBED]))

    def residual_of(self, at: Sampled, left: Node, right: Node) -> Column:
        """The residual of an equation with other sides, less the difference that the statement allows."""
        residual = minus(at.flat(left), at.flat(right))
        if isinstance(self.statement, Claim) and self.statement.restates is not None:
            allowed = at.flat(self.problem.goals[0].right)
            return plus(residual, allowed) if self.exchanged else minus(residual, allowed)
        return residual

    def residual(self, at: Sampled) -> Column:
        """The residual of the equation: left less right side, entry by entry, point by point."""
        key = id(at), (), None
        if key not in self._contributions:
            self._contributions[key] = self.residual_of(at, self.left, self.right)
        return self._contributions[key]

    def contribution(self, at: Sampled, place: Place, term: Node | None = None) -> Column:
        """How the residual changes by a term at a place of the right side: the one that is there, or one added to it.

        Zero if the term does not fit there or has no value.
        """
        term = place.node if term is None else term
        key = id(at), place.path, term
        if key not in self._contributions:
            try:
                self._contributions[key] = self._contribution_of(at, place, term)
            except (w.Misfit, Unsampled):
                self._contributions[key] = [0] * len(self.residual(at))
        return self._contributions[key]

    def _contribution_of(self, at: Sampled, place: Place, term: Node) -> Column:
        if place.apart and fit(place.node, term):
            return _lifted(at, self.right, place.path, term)
        more = put(self.right, place.path, with_term(place.node, term))
        return minus(self.residual(at), self.residual_of(at, self.left, more))

    def of(self, right: Node) -> ModularTest:
        """The same test with another right side."""
        return ModularTest(self.statement, self.left, right, self.problem, self.varied, self.fixed)

    @cached_property
    def turned(self) -> ModularTest:
        """The same test with its sides exchanged."""
        return ModularTest(self.statement, self.right, self.left, self.problem, self.varied, self.fixed, exchanged=True)

    def holds(self, left: Node, right: Node) -> bool:
        """Whether other sides agree at all points."""
        return not any(self.residual_of(self.probe, left, right)) and not any(
            self.residual_of(self.varied, left, right)
        )

    def is_constant(self, scalar: Node) -> bool:
        """Whether a scalar depends on angles alone."""
        values = self.fixed.scalar(scalar).at
        return all(value == values[0] for value in values)

    def split(self, term: Node) -> Term:
        """A term as coefficient and core."""
        return split(term, self.is_constant)

    def times(self, at: Sampled, function: AngleFunction, column: Column) -> Column:
        """A column of numbers at all points, each times the function's value at its point."""
        return at.times(function.node, column)

    def direction(self, node: Node) -> Direction:
        """What all multiples have in common where the angles are fixed; () for zero, or what cannot be told."""
        if node not in self._directions:
            try:
                self._directions[node] = normalized(self.probe.flat(node))
            except (SingularResidue, Unsampled):
                self._directions[node] = ()
        return self._directions[node]

    @cached_property
    def functions(self) -> tuple[AngleFunction, ...]:
        """What coefficients are made of: one and the functions of angles that occur, none a combination of others."""
        occurring = [*_scalars(self.right), *(node for node in _scalars(self.left) if isinstance(node, w.Call))]
        known = [node for _, side in self.problem.rules for node in _scalars(side) if isinstance(node, w.Call)]
        found = [n for n in occurring if self._is_function(n)] or [n for n in known if self._is_function(n)]
        angles = dict.fromkeys(node.argument for node in found if isinstance(node, w.Call))
        both = [w.Call(function, angle) for angle in angles for function in ("cos", "sin")]
        return tuple(self._independent(map(AngleFunction, (ONE, *found, *both))))

    @cached_property
    def fractions(self) -> tuple[AngleFunction, ...]:
        """The functions, and these over what may be divided by, once and twice."""
        more = [
            AngleFunction(function.numerator, below)
            for divisor in self.divisors
            for below in (divisor, divisor**2)
            for function in self.functions
        ]
        return tuple(self._independent((*self.functions, *more)))

    @cached_property
    def squares(self) -> tuple[AngleFunction, ...]:
        """The functions and their products."""
        pairs = combinations_with_replacement(self.functions[1:], 2)
        return tuple(self._independent((*self.functions, *(AngleFunction(_times(one, other)) for one, other in pairs))))

    @cached_property
    def divisors(self) -> tuple[Node, ...]:
        """The functions of angles that are divided by or declared not to be zero; of multiples only the shortest."""
        declared = [node for h in self.problem.hypotheses for node in h.nonvanishing]
        printed = [node.denominator for node in _parts(self.right) if isinstance(node, w.Quotient)]
        kept: list[Node] = []
        for node in sorted(filter(self._is_function, (*printed, *declared)), key=lambda node: len(w.plain(node))):
            if all(multiple(self.varied.flat(node), self.varied.flat(other)) is None for other in kept):
                kept.append(node)
        return tuple(kept)

    def _is_function(self, scalar: Node) -> bool:
        try:
            values = self.varied.scalar(scalar).at
        except Unsampled:
            return False
        return self.is_constant(scalar) and any(value != values[0] for value in values)

    def _independent(self, functions: Iterable[AngleFunction]) -> Iterator[AngleFunction]:
        span = Span()
        for function in functions:
            if span.add(self.varied.flat(function.node)):
                yield function


def _lifted(at: Sampled, root: Node, path: Path, term: Node) -> Column:
    """The values of a term in a place apart: times the common factors above it, among zeros where it is in a block."""
    rows, columns = root.shape
    factors, top, left = at.constant(Fraction(1)), 0, 0
    for k in path:
        match root:
            case w.Negative():
                factors = -factors
            case w.Scale(factor, _):
                factors = factors * at.scalar(factor)
            case w.Quotient(_, denominator):
                factors = factors * at.scalar(denominator).inverse
            case w.Block(lines):
                row, column = [(i, j) for i, line in enumerate(lines) for j in range(len(line))][k]
                top += sum(line[0].shape[0] for line in lines[:row])
                left += sum(block.shape[1] for block in lines[row][:column])
        root = w.children(root)[k]
    size = rows * columns
    found = [0] * (size * len(at.points))
    for i, line in enumerate(at(term)):
        for j, entry in enumerate(line):
            found[(top + i) * columns + left + j :: size] = (factors * entry).at
    return found


def _times(one: AngleFunction, other: AngleFunction) -> Node:
    return one.numerator**2 if one == other else one.numerator * other.numerator


def _parts(node: Node) -> Iterator[Node]:
    """The node and all below it but arguments of functions and rates."""
    yield node
    if not isinstance(node, w.Call | w.Rate):
        for part in w.children(node):
            yield from _parts(part)


def _scalars(node: Node) -> Iterator[Node]:
    return (part for part in _parts(node) if isinstance(part, w.Call | w.Symbol) and part.is_scalar)


def modular_test(
    statement: Statement, left: Node, right: Node, accepted: AcceptedSides, extra: Iterable[Node] = ()
) -> ModularTest | None:
    """The equation with these sides, at points where `extra` expressions have values too; None without such points.

    Raises `Misfit` or TypeError for an equation that cannot be posed, `Untreatable` for what the prover does not treat.
    """
    problem = problem_of(statement.saying(left, right), "printed", accepted)
    context = build(
        with_fields(problem, goals=(*problem.goals, *(Goal("", node, node) for node in extra if node != w.PI)))
    )
    solved = solve_conditions(context)[1]
    # Bare angles, their cosines and sines are independent of each other, unless pi measures the angles.
    if "pi" in context.field.ring.names:
        return None
    rows, columns = left.shape
    varied, fixed = generic_points(context, solved, max(POINTS, NUMBERS // (rows * columns)))
    if len(varied) < POINTS:
        return None
    return ModularTest(statement, left, right, problem, Sampled(context, varied), Sampled(context, fixed))
