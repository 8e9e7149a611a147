"""One edit of a side: tried at points in floating point where the equation has no polynomial form."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from fractions import Fraction
from itertools import chain, islice, product
from random import Random

from chasles import vocabulary as w
from chasles.evaluation.matrices import Matrix
from chasles.problems.variables import entry_name
from chasles.repairs.local_edits import FORM, SingleEdit, turned_signs
from chasles.repairs.one_term import FACTOR, SIGN, Change, instead
from chasles.repairs.real_values import NO_VALUE, RealPoint, agree_at
from chasles.repairs.single_edits import exchanged_letters, in_letters, placed, single_edits
from chasles.rewriting.coefficients import ONE, times
from chasles.rewriting.places import everywhere
from chasles.statements import Problem, Statement, problem_of
from chasles.statements.goals import AcceptedSides
from chasles.vocabulary import Node
from chasles.vocabulary.families import Entry, Index, Member
from chasles.vocabulary.functions import FunctionOf
from chasles.vocabulary.partial import differentiates

POINTS, TRIES, NEAR = 8, 400, 1e-9
"""So many points are compared, of so many that are tried; sides so near to each other agree."""
STEPS, SMALL, EXACT = 20, 1e-7, 1e-12
"""Steps of Newton's method, the change by which it takes slopes, and how well what is given has to hold."""
TURNED = {"arcsin": "arccos", "arccos": "arcsin", "sinh": "cosh", "cosh": "sinh", "max": "min", "min": "max"}
MOST = 2000
"""Edits of a side that are tried."""
OTHER_NUMBERS = (2, Fraction(1, 2), -1, 4, Fraction(1, 4), 3, Fraction(1, 3))


def changes_without_form(test: RealTest, left: Node, right: Node, letters: list[w.Symbol]) -> Iterator[Change]:
    """The sides with one edit on either that agree at points where the hypotheses hold; none where none is found."""
    scalars = dict.fromkeys(part for side in (left, right) for part in w.walk(side) if part.is_scalar)
    angles = dict.fromkeys(part.argument for part in scalars if isinstance(part, w.Call))
    scalars |= dict.fromkeys(w.Call(function, angle) for angle in angles for function in ("cos", "sin"))
    tried = edited(left, right, lambda side: chain(edits_of(side, letters), _with_scalars(side, scalars)))
    yield from (change for change in tried if test.agree(change.left, change.right))


def edited(left: Node, right: Node, edits: Callable[[Node], Iterator[SingleEdit]]) -> Iterator[Change]:
    """The sides with one of the edits of the right one, then of the left one."""
    for new, words, effort in islice(edits(right), MOST):
        yield Change(left, new, (words,), effort)
    for new, words, effort in islice(edits(left), MOST):
        yield Change(new, right, (words,), effort)


def real_test(statement: Statement, left: Node, right: Node, accepted: AcceptedSides) -> RealTest | None:
    """The test in floating point of an equation that has no other; None where no points are found."""

    def posed(one: Node, other: Node) -> Problem:
        return problem_of(statement.saying(one, other), "printed", accepted)

    try:
        test = RealTest(posed, (left, right))
    except (w.Misfit, TypeError, ValueError):
        return None
    return test if test.has_values else None


def _with_scalars(side: Node, scalars: Iterable[Node]) -> Iterator[SingleEdit]:
    """The side with a term multiplied or divided by a scalar that is printed somewhere."""
    for path, part in everywhere(side):
        if isinstance(part, w.Number | w.Scale | w.Quotient | w.Negative | w.Group):
            continue
        for scalar in scalars:
            if isinstance(scalar, w.Number | w.Negative | w.Scale | w.Quotient) or scalar == part:
                continue
            for new in (times(scalar, part), w.printed(lambda: w.Quotient(part, scalar))):  # noqa: B023
                whole = placed(side, path, new)
                if whole.fault is None:
                    yield SingleEdit(whole, instead(new, part), FORM + 1)


def edits_of(side: Node, letters: list[w.Symbol], indices: Iterable[Index] = ()) -> Iterator[SingleEdit]:
    """The side with one slip undone: of form, of a letter, a sign, a number, a function or an index."""
    yield from chain(single_edits(side), in_letters(side, letters), exchanged_letters(side))
    parts = dict(everywhere(side))
    for path, part in parts.items():
        parent = parts[path[:-1]] if path else None
        in_product = isinstance(parent, w.Scale | w.Quotient)
        alone = () if part.is_scalar or not isinstance(parent, w.Block | None) else _of_matrices(part)
        for new, effort in (*_of_functions(part), *_of_indices(part, indices), *alone):
            whole = placed(side, path, new)
            if whole.fault is None and not (in_product and new == ONE):
                yield SingleEdit(whole, instead(new, part), effort)


def _of_functions(part: Node) -> Iterator[tuple[Node, int]]:
    match part:
        case w.Number(value):
            yield from ((w.Number(value * factor), FACTOR) for factor in OTHER_NUMBERS)
            yield from ((w.Number(value + more), FACTOR + 1) for more in (1, -1))
        case FunctionOf(function, arguments):
            if function in TURNED:
                yield FunctionOf(TURNED[function], arguments), FACTOR
            if len(arguments) > 1:
                yield FunctionOf(function, arguments[::-1]), FACTOR
            if function in ("sqrt", "abs"):
                yield arguments[0], FACTOR
        case w.Sum():
            yield from ((edit.node, SIGN) for edit in turned_signs(part))
    if part.is_scalar and not isinstance(part, w.Number | w.Negative):
        yield w.Negative(part), SIGN
        yield w.Power(part, 2), FORM
        yield from ((w.Scale(w.Number(Fraction(factor)), part), FACTOR) for factor in (2, Fraction(1, 2)))
        if isinstance(part, w.Sum | w.Power):
            yield w.printed(lambda: FunctionOf("sqrt", (part,))), FORM


def _of_matrices(part: Node) -> Iterator[tuple[Node, int]]:
    """A whole side, or a block of one, with another sign or factor."""
    yield (part.term if isinstance(part, w.Negative) else w.Negative(part)), SIGN
    yield w.Scale(w.Number(Fraction(2)), part), FACTOR
    yield w.Scale(w.Number(Fraction(1, 2)), part), FACTOR + 1


def _of_indices(part: Node, indices: Iterable[Index]) -> Iterator[tuple[Node, int]]:
    match part:
        case Member(family, index):
            yield from ((Member(family, other), FORM) for other in indices if other != index)
        case Entry(of, i, j, letter):
            yield Entry(of, j, i, letter), FORM


class RealTest:
    """Points at which what a problem assumes holds; sides are compared there, as `posed` where they are carried out."""

    def __init__(self, posed: Callable[[Node, Node], Problem], sides: tuple[Node, Node]) -> None:
        self.posed, self.sides = posed, sides
        problem = posed(*sides)
        self.rules = dict(problem.rules)
        stated = [(goal.left, goal.right) for goal in (*problem.goals, *problem.conditions)]
        self.given = stated[len(problem.goals) :]
        self.positive: list[Node] = list(problem.nonnegative)
        for h in problem.hypotheses:
            self.given += h.equations if h.kind != "inequality" else ()
            self.positive += h.subjects[:1] if h.kind in ("inequality", "positive") else ()
        said = [*(side for pair in (*problem.rules, *stated, *self.given) for side in pair), *self.positive]
        found = dict.fromkeys(symbol for side in said for symbol in w.symbols_of(side))
        free = [symbol for symbol in found if symbol not in self.rules and symbol.stands_for is None]
        self.places = [(symbol, i, j) for symbol in free for i, j in product(*map(range, symbol.shape))]
        named = {entry_name(symbol, 0, i, j): place for place, (symbol, i, j) in enumerate(self.places)}
        self.products = {  # a vector with a length and a direction of its own is their product
            (symbol, i, 0): (named[f"|{symbol.name}|"], named[f"{symbol.name}/|{symbol.name}|_{i + 1}"])
            for symbol in dict.fromkeys(each for side in sides for each in w.symbols_of(side))
            for i in range(symbol.shape[0])
            if f"{symbol.name}/|{symbol.name}|_{i + 1}" in named
        }
        given = chain(*self.given, *self.rules.items())
        bound = {symbol for side in given for symbol in w.symbols_of(side)}
        self.bound = [k for k, (symbol, _, _) in enumerate(self.places) if symbol in bound]
        moving = any(isinstance(part, w.Rate) for side in said for part in w.walk(side))
        self.points = [] if moving else list(islice(self._drawn(), POINTS))

    @property
    def has_values(self) -> bool:
        """Whether the sides are made of words that have values at points, at some of which they may have none."""
        try:
            return bool(self.points) and all(map(self.points[0], chain(*self._pairs(*self.sides))))
        except TypeError:
            return False
        except NO_VALUE:
            return True

    def agree(self, left: Node, right: Node) -> bool:
        """Whether the sides agree at the points."""
        try:
            pairs = self._pairs(left, right)
        except (w.Misfit, TypeError):
            return False
        return agree_at(self.points, lambda point: all(_near(point(one), point(other)) for one, other in pairs))

    def _pairs(self, left: Node, right: Node) -> list[tuple[Node, Node]]:
        """The sides; what is expanded or differentiated is so once, and not at each point."""
        if not any(side.expands or differentiates(side) for side in (left, right)):
            return [(left, right)]
        return [(goal.left, goal.right) for goal in self.posed(left, right).goals]

    def _drawn(self) -> Iterator[RealPoint]:
        random = Random(1)
        for _ in range(TRIES):
            values = [random.uniform(0.1, 1.4) * (1 if s in self.positive else random.choice((-1, 1)))
                      for s, _, _ in self.places]  # fmt: skip
            with suppress(*NO_VALUE):
                point = self._solved(values)
                if point is not None and all(point.scalar(each) > 0 for each in self.positive):
                    yield point

    def _solved(self, values: list[float]) -> RealPoint | None:
        """The point near these values at which what is given holds, by Newton's method; None where it finds none."""
        import numpy as np

        for _ in range(STEPS):
            point = self._at(values)
            residuals = self._residuals(point)
            if all(abs(each) < EXACT for each in residuals):
                return point
            moved = (self._at([v + SMALL * (k == place) for k, v in enumerate(values)]) for place in self.bound)
            slopes = [[(b - a) / SMALL for a, b in zip(residuals, self._residuals(p), strict=True)] for p in moved]
            step = np.linalg.lstsq(np.array(slopes).T, np.array(residuals), rcond=1e-9)[0]
            changes = dict(zip(self.bound, step.tolist(), strict=True))
            values = [value - changes.get(place, 0.0) for place, value in enumerate(values)]
        return None

    def _residuals(self, point: RealPoint) -> list[float]:
        pairs = (zip(chain(*point(one)), chain(*point(other)), strict=True) for one, other in self.given)
        return [a - b for pair in pairs for a, b in pair]

    def _at(self, values: list[float]) -> RealPoint:
        products = {place: values[length] * values[along] for place, (length, along) in self.products.items()}
        return RealPoint(self.rules, dict(zip(self.places, values, strict=True)) | products)


def _near(one: Matrix, other: Matrix) -> bool:
    pairs = zip(chain(*one), chain(*other), strict=True)
    return all(abs(a - b) < NEAR * max(1.0, abs(a)) for a, b in pairs)
