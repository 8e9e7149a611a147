"""One edit of a side: tried at points in floating point where the equation has no polynomial form."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain, islice, product
from random import Random
from typing import Any

from chasles.problems.variables import entry_name
from chasles.repairs.local_edits import FORM, SingleEdit, turned_signs
from chasles.repairs.one_term import FACTOR, SIGN, Change, instead
from chasles.repairs.real_values import NO_VALUE, RealPoint
from chasles.repairs.single_edits import exchanged_letters, in_letters, placed, single_edits
from chasles.rewriting.coefficients import ONE, times
from chasles.rewriting.places import everywhere
from chasles.statements import Problem, Statement, problem_of
from chasles.statements.goals import AcceptedSides
from chasles.vocabulary import (
    Block,
    Group,
    Misfit,
    Negative,
    Node,
    Number,
    Power,
    Quotient,
    Scale,
    Sum,
    Symbol,
    printed,
    symbols_of,
    walk,
)
from chasles.vocabulary.families import Entry, Index, Member
from chasles.vocabulary.functions import FunctionOf

_AtPoint = Callable[[tuple[float, ...]], list[float] | None]
POINTS, TRIES, NEAR, LARGEST = 4, 400, 1e-9, 1e9
"""So many points are compared, of so many that are tried; sides so near to each other agree, none may be larger."""
TURNED = {"arcsin": "arccos", "arccos": "arcsin", "sinh": "cosh", "cosh": "sinh", "max": "min", "min": "max"}
MOST = 2000
"""Edits of a side that are tried."""
OTHER_NUMBERS = (2, Fraction(1, 2), -1, 4, Fraction(1, 4), 3, Fraction(1, 3))


def changes_without_form(test: RealTest, left: Node, right: Node, letters: list[Symbol]) -> Iterator[Change]:
    """The sides with one edit on either that agree at points where the hypotheses hold; none where none is found."""
    scalars = dict.fromkeys(part for side in (left, right) for part in walk(side) if part.is_scalar)
    for new, words, effort in islice(chain(edits_of(right, letters), _with_scalars(right, scalars)), MOST):
        if test.agree(left, new):
            yield Change(left, new, (words,), effort)
    for new, words, effort in islice(chain(edits_of(left, letters), _with_scalars(left, scalars)), MOST):
        if test.agree(new, right):
            yield Change(new, right, (words,), effort)


def real_test(statement: Statement, left: Node, right: Node, accepted: AcceptedSides) -> RealTest | None:
    """The test in floating point of an equation that has no other; None where no points are found."""
    try:
        test = RealTest(
            problem_of(statement.saying(left, right), "printed", accepted), (*symbols_of(left), *symbols_of(right))
        )
    except (Misfit, TypeError, ValueError):
        return None
    return test if test.points else None


def _with_scalars(side: Node, scalars: Iterable[Node]) -> Iterator[SingleEdit]:
    """The side with a term multiplied or divided by a scalar that is printed somewhere."""
    for path, part in everywhere(side):
        if isinstance(part, Number | Scale | Quotient | Negative | Group):
            continue
        for scalar in scalars:
            if isinstance(scalar, Number | Negative | Scale | Quotient) or scalar == part:
                continue
            for new in (times(scalar, part), Quotient(part, scalar)):
                whole = placed(side, path, printed(lambda: new))  # noqa: B023
                if whole.fault is None:
                    yield SingleEdit(whole, instead(new, part), FORM + 1)


def edits_of(side: Node, letters: list[Symbol], indices: Iterable[Index] = ()) -> Iterator[SingleEdit]:
    """The side with one slip undone: of form, of a letter, a sign, a number, a function or an index."""
    yield from chain(single_edits(side), in_letters(side, letters), exchanged_letters(side))
    parts = dict(everywhere(side))
    for path, part in parts.items():
        parent = parts[path[:-1]] if path else None
        in_product = isinstance(parent, Scale | Quotient)
        alone = () if part.is_scalar or not isinstance(parent, Block | None) else _of_matrices(part)
        for new, effort in (*_of_functions(part), *_of_indices(part, indices), *alone):
            whole = placed(side, path, new)
            if whole.fault is None and not (in_product and new == ONE):
                yield SingleEdit(whole, instead(new, part), effort)


def _of_functions(part: Node) -> Iterator[tuple[Node, int]]:
    match part:
        case Number(value):
            yield from ((Number(value * factor), FACTOR) for factor in OTHER_NUMBERS)
            yield from ((Number(value + more), FACTOR + 1) for more in (1, -1))
        case FunctionOf(function, arguments):
            if function in TURNED:
                yield FunctionOf(TURNED[function], arguments), FACTOR
            if len(arguments) > 1:
                yield FunctionOf(function, arguments[::-1]), FACTOR
            if function in ("sqrt", "abs"):
                yield arguments[0], FACTOR
        case Sum():
            yield from ((edit.node, SIGN) for edit in turned_signs(part))
    if part.is_scalar and not isinstance(part, Number | Negative):
        yield Negative(part), SIGN
        yield Power(part, 2), FORM
        yield from ((Scale(Number(Fraction(factor)), part), FACTOR) for factor in (2, Fraction(1, 2)))
        if isinstance(part, Sum | Power):
            yield printed(lambda: FunctionOf("sqrt", (part,))), FORM


def _of_matrices(part: Node) -> Iterator[tuple[Node, int]]:
    """A whole side, or a block of one, with another sign or factor."""
    yield (part.term if isinstance(part, Negative) else Negative(part)), SIGN
    yield Scale(Number(Fraction(2)), part), FACTOR
    yield Scale(Number(Fraction(1, 2)), part), FACTOR + 1


def _of_indices(part: Node, indices: Iterable[Index]) -> Iterator[tuple[Node, int]]:
    match part:
        case Member(family, index):
            yield from ((Member(family, other), FORM) for other in indices if other != index)
        case Entry(of, i, j, letter):
            yield Entry(of, j, i, letter), FORM


class RealTest:
    """Points at which what a problem assumes holds; sides are compared there."""

    def __init__(self, problem: Problem, letters: Iterable[Symbol]) -> None:
        # SymPy is loaded where it is needed only.
        from chasles.checker.expressions.scalars import scalar_question
        from chasles.checker.expressions.words import EntriesOfWords

        self.letters = tuple(letters)
        self.entries = EntriesOfWords(problem)
        question = scalar_question(problem, proving=False)
        spoken = (question.left, question.right, *question.given, *question.nonzero)
        self.symbols = sorted({symbol for each in spoken for symbol in each.free_symbols}, key=str)
        self.given = [equation.lhs - equation.rhs for equation in question.given]
        self.points = [] if self.entries.moving else [self._point(problem, named) for named in self._drawn()]

    def _point(self, problem: Problem, at: Sequence[float]) -> RealPoint:
        """The entries of all letters at a point: a vector with a length and a direction of its own is their product."""
        values, random = dict(zip(map(str, self.symbols), at, strict=True)), Random(2)
        sides = [side for pair in (*problem.rules, *((g.left, g.right) for g in problem.goals)) for side in pair]
        sides += [node for h in problem.hypotheses for node in (*h.subjects, *h.nonvanishing)]
        found: dict[tuple[Symbol, int, int], float] = {}
        for symbol in dict.fromkeys((*(each for side in sides for each in symbols_of(side)), *self.letters)):
            length = values.get(f"|{symbol.name}|", 1.0)
            for i, j in product(*map(range, symbol.shape)):
                name = entry_name(symbol, 0, i, j)
                along = name.replace(symbol.name, f"{symbol.name}/|{symbol.name}|", 1)
                free = values.get(along, random.uniform(0.1, 1.4))
                found[symbol, i, j] = values.get(name, length * free)
        return RealPoint(dict(problem.rules), found)

    def agree(self, left: Node, right: Node) -> bool:
        """Whether the sides agree at all points at which both have a value, two or more."""
        count = 0
        for point in self.points:
            try:
                pairs = zip(chain(*point(left)), chain(*point(right)), strict=True)
                if not all(abs(one - other) < NEAR * max(1.0, abs(one)) for one, other in pairs):
                    return False
            except NO_VALUE:
                continue
            count += 1
        return count > 1

    def _drawn(self) -> Iterator[tuple[float, ...]]:
        random, found = Random(1), 0
        adjusted = [pair for equation in self.given if (pair := self._squared_alone(equation))]
        holds = self._function(self.given)
        for _ in range(TRIES):
            point = {symbol: _drawn(symbol, random) for symbol in self.symbols}
            for symbol, square in adjusted:
                values = square(tuple(point.values()))
                if values and values[0] >= 0:
                    point[symbol] = values[0] ** 0.5
            residuals = holds(tuple(point.values()))
            if residuals is not None and all(abs(residual) < NEAR for residual in residuals):
                yield tuple(point.values())
                found += 1
            if found == POINTS:
                return

    def _squared_alone(self, equation: Any) -> tuple[Any, _AtPoint] | None:
        """A quantity that occurs in an equation as its square alone, and what the equation says that this is."""
        for symbol in sorted(equation.free_symbols, key=str, reverse=True):
            square, rest = equation.coeff(symbol, 2), equation.subs(symbol, 0)
            if square.is_number and square and (equation - square * symbol**2 - rest).expand() == 0:
                return symbol, self._function([-rest / square])
        return None

    def _function(self, expressions: list[Any]) -> _AtPoint:
        """The values at a point; None where one is no real number."""
        from sympy import lambdify

        function = lambdify(self.symbols, expressions, "math")

        def at(point: tuple[float, ...]) -> list[float] | None:
            try:
                values = function(*point)
            except (ArithmeticError, NameError, TypeError, ValueError):
                return None
            return values if all(isinstance(v, int | float) and abs(v) < LARGEST for v in values) else None

        return at


def _drawn(symbol: Any, random: Random) -> float:
    size = random.uniform(0.1, 1.4)
    if symbol.is_nonnegative or symbol.is_positive:
        return size
    if symbol.is_nonpositive or symbol.is_negative:
        return -size
    return size * random.choice((-1, 1))
