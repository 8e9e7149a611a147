"""Exercise 3.7: a line from its moments about two points."""

from chasles.derivations.exercises.calculations.lines import unit_vectors_of
from chasles.derivations.exercises.x3_05 import nearest_point
from chasles.derivations.notation import a, b, e, n, n_A, n_B, p, p_0
from chasles.derivations.s02_screw import (
    direction_is_unit,
    moment_about_A,
    moment_about_B,
    moments_about_two_points,
    moments_share_a_component,
    plucker_array_moved,
)

from chasles.exact.evaluate import Value
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Arrow, Line, Picture, Point
from chasles.exercises.worksheet import Worksheet, equal
from chasles.statements import Condition
from chasles.statements.exercise import Answer, Datum, Else, Exercise, ListOf, Scalar, Word, vector_shape
from chasles.vocabulary import dot, norm, number

moment_is_normal_to_direction = Condition(
    "Ex 3.7", dot(n_A, e), number(0), says="The moment of a line about a point is normal to the line.", on=(e,)
)


def solve(sheet: Worksheet) -> str:
    """(3.27) is linear in e; what is left free is settled by n_A . e = 0 and |e| = 1."""
    sheet.given({a: sheet["a"], b: sheet["b"], n_A: sheet["nA"], n_B: sheet["nB"]}, "The points and the moments.")
    if not sheet.holds(moments_share_a_component, "No line has moments whose components along AB differ."):
        return refused(sheet, "moments_share_a_component")
    found = sheet.solve((moments_about_two_points, moment_is_normal_to_direction), e, "(a) Linear equations for e.")
    if not found.exist:
        return refused(sheet, "moments_about_two_points" if equal(sheet["a"], sheet["b"]) else "moment_is_normal")
    candidates = unit_vectors_of(found)
    if candidates is None:
        return undetermined(sheet)
    sheet.step("Of these, the vectors of length one.", ("e", list(candidates)), cites=(direction_is_unit,))
    if not candidates:
        return refused(sheet, "direction_is_unit")
    lines = [line(sheet, candidate) for candidate in candidates]
    drawn = [Line(point, candidate, "axis") for (point, _), candidate in zip(lines, candidates, strict=True)]
    measured = [Arrow(sheet["a"], sheet["nA"], "n_A"), Arrow(sheet["b"], sheet["nB"], "n_B")]
    points = [Point(sheet["a"], "A"), Point(sheet["b"], "B"), *(Point(point, "P*") for point, _ in lines)]
    sheet.picture = Picture("The axis and its moments about A and B", (*drawn, *measured, *points))
    if len(candidates) > 1:
        sheet.answer(e_candidates=list(candidates), p_candidates=[point for point, _ in lines])
        return "ambiguous"
    ((point, moment),) = lines
    distance = sheet.show(norm(n), "Its distance from the origin.", named="d", at={n: moment})
    sheet.answer(e=candidates[0], p=point, n0=moment, d=distance)
    return "compatible"


def line(sheet: Worksheet, direction: Value) -> tuple[Value, Value]:
    """The point nearest the origin and the moment about the origin, substituted back into both measurements."""
    sheet.values[e] = direction
    array = sheet.compute(plucker_array_moved, "(c) The moment moved from A to the origin.", at={b: sheet["a"] * 0})
    sheet.values[n] = array[3:, :]
    point = sheet.compute(nearest_point, "(b) The point nearest the origin.")
    sheet.check(moment_about_A, "The line has the measured moment about A.", at={p: point})
    sheet.check(moment_about_B, "The line has the measured moment about B.", at={p: point})
    sheet.check(direction_is_unit, "Its direction has length one.")
    return point, sheet.values[n]


def refused(sheet: Worksheet, name: str) -> str:
    """The measurements contradict each other."""
    sheet.answer(violated=[name])
    return "incompatible"


def undetermined(sheet: Worksheet) -> str:
    """A and B are one point: every line through some point, normal to the moment, has it."""
    says = "every unit vector e normal to n_A" if any(sheet["nA"]) else "every unit vector e"
    sheet.step(f"A and B are one point, about which the moment says nothing more: {says} is a solution.")
    sheet.answer(e_candidates=says, p_candidates="p = e x (n_A + a x e), for each of these e")
    return "ambiguous"


def instance(draw: Draw) -> dict[str, Value]:
    """The moments of a line about two points; now and then, one that no line has."""
    direction, point, one = draw.unit(), draw.vector(), draw.vector()
    other = one + draw.vector()
    wrong = draw.vector() * int(draw.integer(0, 3) == 0)
    moments = (point - one).cross(direction), (point - other).cross(direction) + wrong
    return draw.written(a=one, b=other, nA=moments[0], nB=moments[1])


exercise = Exercise(
    "3.7",
    "An axis from its moments about two points",
    asked=(
        "Find the direction of the axis from its moments about A and about B.",
        "Find its point nearest the origin.",
        "Find its Plücker coordinates about the origin.",
    ),
    data=(
        Datum("a", vector_shape(), [1, 0, 0], "position of A, in any unit of length"),
        Datum("b", vector_shape(), [0, 1, 1], "position of B, in the same unit"),
        Datum("nA", vector_shape(), [0, 2, 0], "moment of the axis about A, with its unit direction: in the same unit"),
        Datum("nB", vector_shape(), [0, 1, 1], "moment of the axis about B, in the same unit"),
    ),
    statuses=("compatible", "incompatible", "ambiguous"),
    solve=solve,
    instance=instance,
    symbols={"e": (e,), "p": (p_0, p), "n0": (n,)},
    orders=(("e_candidates", "p_candidates"),),
    answers=(
        Answer("e", vector_shape(), "the unit direction of the axis", ("compatible",)),
        Answer(
            "p",
            vector_shape(),
            "the point of the axis nearest the origin, in the unit of the positions",
            ("compatible",),
        ),
        Answer("n0", vector_shape(), "the moment of the axis about the origin, in the same unit", ("compatible",)),
        Answer("d", Scalar(), "the distance of the axis from the origin, in the same unit", ("compatible",)),
        Answer(
            "e_candidates",
            Else(ListOf(vector_shape()), ("every unit vector e", "every unit vector e normal to n_A")),
            "if there are several axes, their unit directions, in any order",
            ("ambiguous",),
        ),
        Answer(
            "p_candidates",
            Else(ListOf(vector_shape()), ("p = e x (n_A + a x e), for each of these e",)),
            "their points nearest the origin, in the same order",
            ("ambiguous",),
        ),
        Answer(
            "violated",
            ListOf(
                Word(("moments_share_a_component", "moment_is_normal", "moments_about_two_points", "direction_is_unit"))
            ),
            "if there is none, the first of these conditions that cannot be met",
            ("incompatible",),
        ),
    ),
)
