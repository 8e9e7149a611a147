"""Does a counterexample refute? It is evaluated again, exactly, by the checker's own arithmetic, at the point it shows.

What it leaves out must follow from it: a norm from its vector, anything else from linear equations. Where there is a
choice, the simplest is made; no other value is looked for.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from chasles.checker.expansion import Formless
from chasles.checker.motion import eliminated, require_motion
from chasles.checker.quantities import squeezed
from chasles.checker.reading import PolynomialProblem
from chasles.checker.sparse import ZERO, Polynomial, Rejected, cleared, product, well_formed
from chasles.checker.witness import Point, point_of, require, root_of, value_at
from chasles.statements import Goal, Problem
from chasles.statements.conditions import UNFINISHED

if TYPE_CHECKING:
    from chasles.verdict import Counterexample

Value = Mapping[int, Fraction]
SIMPLEST: Mapping[str, tuple[int | Fraction, ...]] = {
    **dict.fromkeys(("unit", "direction", "unit column", "positive"), (1,)),
    **dict.fromkeys(("rotation", "orthonormal", "definite"), (1, 0, 0, 0, 1, 0, 0, 0, 1)),
    "half_turn": (1, 0, 0, 0, -1, 0, 0, 0, -1),
}
"""Entries of the subjects of a hypothesis, zeros behind them, where a counterexample leaves all of them out."""


def check_counterexample(problem: Problem, shown: Counterexample) -> None:
    """The point satisfies all that is assumed, and there the entry's two sides differ, as shown; else `Rejected`."""
    from chasles.checker.any_size.at_sizes import check_at_sizes, sizes_in

    if sizes_in(problem):
        with well_formed("counterexample"):
            check_at_sizes(problem, shown)
        return
    kinds = {h.kind for h in problem.hypotheses}
    if UNFINISHED in kinds:
        raise Rejected("what is given of fields says more than is known of the point")
    polynomial = "inequality" not in kinds
    try:
        with well_formed("counterexample"):
            if not (reason := _objections(problem, shown)):
                return
    except Rejected as error:  # it is no point of polynomials, and may be one of scalars
        reason, polynomial = "" if isinstance(error, Formless) else str(error), False
    if polynomial:
        raise Rejected(reason)
    from chasles.checker.expressions.scalars import check_scalar_counterexample  # loads SymPy

    try:
        check_scalar_counterexample(problem, shown)
    except Rejected as error:
        raise Rejected(reason or str(error)) from None


def _objections(problem: Problem, shown: Counterexample) -> str:
    """Why the counterexample refutes no equation with that label; empty if it does one, or `Rejected`."""
    reading = PolynomialProblem(problem, shown.at)
    turned = [what[1] for what in reading.variables if what[0] == "cos"]
    found = [_objection(reading, goal, shown) for goal in problem.goals if goal.label == shown.goal]
    if len({*turned}) < len(turned):
        found = ["the point does not say by which fraction of an angle its cosine and sine are measured"]
    if found and all(found) and not reading.places.keys() >= {*map(squeezed, shown.at)}:
        raise Rejected(found[0])
    return min(found, default=f"no equation of the statement is called {shown.goal!r}", key=bool)


def _objection(reading: PolynomialProblem, goal: Goal, shown: Counterexample) -> str:
    """Why the counterexample does not refute this equation; empty if it does."""
    row, column = shown.entry
    if not (1 <= row <= goal.left.shape[0] and 1 <= column <= goal.left.shape[1]):
        return f"the equation has no entry {row}, {column}"
    sides = [reading(side)[row - 1][column - 1] for side in goal.sides]
    relevant = bound_in(reading, sides[0].places | sides[1].places)
    try:
        point = completed(reading, shown.at, relevant)
        require(reading, point, relevant)
        require_motion(reading, point)
        left, right = (quotient_at(reading, side, point) for side in sides)
    except Rejected as error:
        return str(error)
    if left == right:
        return f"both sides are {_text(reading, left, point, shown.at)} at the point"
    texts = (_text(reading, left, point, shown.at), _text(reading, right, point, shown.at))
    same = texts == (shown.left, shown.right)
    return "" if same else f"the sides are {' and '.join(texts)} at the point, not {shown.left} and {shown.right}"


def bound_in(reading: PolynomialProblem, places: set[int]) -> set[int]:
    """The variables in these places, and all those of which anything is assumed."""
    assumed = (*reading.vanishing.values(), *reading.nonzero, *(positive for _, positive in reading.positive))
    return {place for place in places.union(*(p.places for p in assumed)) if place >= len(reading.nonzero)}


def completed(reading: PolynomialProblem, at: Mapping[str, Fraction], relevant: set[int]) -> Point:
    """The point, with values for what it leaves out."""
    angles = {reading.places[what[1].name]: what[1].name for what in reading.variables if what[0] == "cos"}
    # An angle is shown only where pi measures it.
    pi = {"pi": 1} if reading.places.get("pi") in relevant or not at.keys().isdisjoint(angles.values()) else {}
    point = point_of(reading, {name: Fraction(value) for name, value in at.items()} | pi)
    _angle(reading, point, angles.keys() & (relevant | point.keys()))
    _choose(reading, point, relevant)
    _norms(reading, point, relevant)
    variables = reading.variables
    entries = [p for p in sorted(relevant - point.keys() - angles.keys()) if variables[p][0] == "entry"]
    determined = [p for p in entries if variables[p][1] in reading.problem.unknowns and not variables[p][2]]
    _linear(reading, point, determined, whole=False)
    _linear(reading, point, [place for place in entries if place not in point])
    _norms(reading, point, relevant)
    return point


def _angle(reading: PolynomialProblem, point: Point, angles: set[int]) -> None:
    """The only angle that occurs beside its own cosine and sine may be left out: it is transcendental."""
    if len(angles) == 1 and reading.places.get("pi") not in point and not angles & point.keys():
        point[angles.pop()] = Fraction(1), 1


def _choose(reading: PolynomialProblem, point: Point, relevant: set[int]) -> None:
    """What is left out altogether is as simple as its hypothesis, or its norm, allows."""
    wanted = [(h.subjects, SIMPLEST[h.kind]) for h in reading.problem.hypotheses if h.kind in SIMPLEST]
    for place, (kind, *what) in enumerate(reading.variables):
        if kind == "norm" and place in point:
            wanted.append(((what[0],), (point[place][0], *[0] * (what[0].shape[0] - 1))))
        elif kind == "cos" and point.keys().isdisjoint((reading.places.get(what[0].name), place, place + 1)):
            point |= {place: (Fraction(1), 0), place + 1: (Fraction(0), 0)}
    for subjects, numbers in wanted:
        entries = [entry for subject in subjects for row in reading(subject) for entry in row]
        places = [place for entry in entries for place in entry.places]
        if len(places) >= len(numbers) and relevant.issuperset(places) and point.keys().isdisjoint(places):
            known = [(Fraction(number), 0) for number in (*numbers, *[0] * len(places))]
            point.update(zip(places, known, strict=False))


def _norms(reading: PolynomialProblem, point: Point, relevant: set[int]) -> None:
    """A norm that is left out is the square root, where that is rational."""
    for place in sorted(relevant - point.keys()):
        kind, of, *_ = reading.variables[place]
        entries = [entry for (entry,) in reading(of)] if kind == "norm" else []
        if entries and all(entry.places <= point.keys() for entry in entries):
            numbers = [number for entry in entries for number in quotient_at(reading, entry, point).values()]
            root = root_of(sum((number * number for number in numbers), Fraction(0)))
            if root is not None:
                point[place] = root, 0


def _linear(reading: PolynomialProblem, point: Point, missing: list[int], whole: bool = True) -> None:
    """What is left out and occurs linearly in what vanishes is solved for; on the `whole`, what that leaves is zero."""
    rows: list[list[Fraction]] = []
    zeros = point | {place: (Fraction(0), 0) for place in missing}
    for polynomial in reading.vanishing.values():
        partials = polynomial.partials()
        slopes = [partials.get(place, ZERO) for place in missing]
        if polynomial.places <= zeros.keys() and not any(slope.places & {*missing} for slope in slopes):
            values = [value_at(part, zeros) for part in (*slopes, -polynomial)]
            if all(value.keys() <= {0} for value in values):
                rows.append([value.get(0, Fraction(0)) for value in values])
    found = _solution(rows, len(missing))
    for column, place in enumerate(missing):
        if whole or column in found:
            point[place] = found.get(column, Fraction(0)), 0


def _solution(rows: list[list[Fraction]], size: int) -> dict[int, Fraction]:
    """Values that satisfy the equations, by elimination, if any do; zero is meant where there is a choice."""
    reduced, pivots = eliminated(rows, size)
    return {column: row[-1] for column, row in zip(pivots, reduced, strict=False)}


def quotient_at(reading: PolynomialProblem, polynomial: Polynomial, point: Point) -> Value:
    """The value of an expression, its inverses of nonzero factors evaluated too."""
    numerator, powers = cleared(polynomial, reading.nonzero)
    below = value_at(product(reading.nonzero, powers), point)
    if len(below) != 1:
        raise Rejected("what is divided by is zero at the point, or a sum in a transcendental number")
    ((shift, divisor),) = below.items()
    return {power - shift: value / divisor for power, value in value_at(numerator, point).items()}


def _text(reading: PolynomialProblem, value: Value, point: Point, at: Mapping[str, Fraction]) -> str:
    """The value as 1/2, 2 pi, 1 - 3/4 phi."""
    bare = [reading.variables[place][1].name for place, (_, power) in point.items() if power]
    name = bare[0] if len(bare) == 1 and bare[0] not in at else "pi"
    text = ""
    for power, number in sorted(value.items()):
        unit = name if power == 1 else f"{name}^{power}"
        size = str(abs(number)) if not power else unit if abs(number) == 1 else f"{abs(number)} {unit}"
        text += f" {'-' if number < 0 else '+'} {size}" if text else f"{'-' * (number < 0)}{size}"
    return text or "0"
