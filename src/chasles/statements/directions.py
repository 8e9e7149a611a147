"""Rotation vectors: where the norm of a vector is an angle, the vector is that angle times a direction.

Every vector phi is |phi| n with |n| = 1, and n is any direction where phi is zero. So what holds for all angles and
directions holds for all vectors; what fails for an angle that is not negative fails for a vector. Where rates are
taken, |phi| is not zero: there angle and direction are as often differentiable as the vector is.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace as with_fields
from fractions import Fraction
from functools import partial

from chasles.statements.hypotheses import Hypothesis, nonzero
from chasles.statements.problem import Problem
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Call, Dot, Integral, Node, Norm, Number, Rate, Scale, Symbol, replace, undotted, uniform


def with_directions(problem: Problem) -> Problem:
    """The same problem, each free vector whose norm is an angle said by the angle and a direction."""
    for vector in dict.fromkeys(_rotation_vectors(problem)):
        if _is_free(vector, problem):
            problem = _with_direction(problem, vector)
    return problem


def _rotation_vectors(problem: Problem) -> Iterator[Symbol]:
    """The vectors of whose norms cosines and sines are taken."""
    for node in problem.all_sides:
        for call in (part for part in opened_parts(node) if isinstance(part, Call)):
            norms = (part.of for part in opened_parts(call.argument) if isinstance(part, Norm))
            yield from (of for of in norms if isinstance(of, Symbol) and of.shape == (3, 1))


def _is_free(vector: Symbol, problem: Problem) -> bool:
    """Whether nothing else is known of a vector than that it is not zero, or at right angles to another."""
    known = {undotted(left)[0] for left, _ in problem.rules} | {*problem.unknowns}
    running = {symbol for node in problem.all_sides for part in opened_parts(node) if isinstance(part, Integral)
               for symbol in part.running}  # fmt: skip
    spoken_of = (h for h in problem.hypotheses if any(vector in opened_parts(subject) for subject in h.subjects))
    return vector not in known | running and all(
        h.kind == "nonzero" or (h.kind == "perpendicular" and h.subjects.count(vector) == 1) for h in spoken_of
    )


def length_and_direction(vector: Symbol) -> tuple[Symbol, Symbol]:
    """The symbols by which a rotation vector is said: its length, an angle, and its direction."""
    name, letter = f"|{vector.name}|", rf"\|{vector.letter}\|"
    angle = Symbol(name, letter, uniform((1, 1)), f"length of {vector.name}", vector.constant)
    direction = Symbol(
        f"{vector.name}/{name}", rf"{vector.letter}/{letter}", uniform((3, 1)), f"direction of {vector.name}",
        vector.constant,
    )  # fmt: skip
    return angle, direction


def _with_direction(problem: Problem, vector: Symbol) -> Problem:
    angle, direction = length_and_direction(vector)
    values: dict[Node, Node] = {Norm(vector): angle, vector: Scale(angle, direction)}

    def said(hypothesis: Hypothesis) -> Hypothesis:
        here = {**values, vector: direction} if hypothesis.kind == "perpendicular" else values
        return hypothesis.rewritten(partial(replace, values=here))

    unit = (Dot(direction, direction), Number(Fraction(1)))
    hypotheses = [Hypothesis("direction", (direction,), (unit,), (), "", f"{direction.name} is a direction")]
    moves = any(isinstance(part, Rate) for node in problem.all_sides for part in opened_parts(node))
    if moves and not vector.constant and not any(Norm(vector) in h.nonvanishing for h in problem.hypotheses):
        hypotheses.append(said(nonzero(Norm(vector))))
    found = problem.said_otherwise(lambda side: replace(side, values), said)
    return with_fields(
        found,
        hypotheses=(*hypotheses, *found.hypotheses),
        presupposed=(*map(said, problem.presupposed), *hypotheses[1:]),
        nonnegative=(*problem.nonnegative, angle),
    )
