"""Exercise 3.2: forces along lines between points, reduced to a wrench; the point of its axis nearest one of them."""

from chasles.derivations.notation import a, force, moment_A, moment_P, n_0, p, p_0__
from chasles.derivations.s07_statics import (
    least_moment,
    least_moment_on_one_line,
    least_moment_vector,
    moment_about_point,
    moment_about_point_by_force,
    pitch_of_wrench,
    wrench_point,
    wrench_point_is_nearest,
    wrench_point_is_on_axis,
)

from chasles.exact.evaluate import Value
from chasles.exact.numbers import sign
from chasles.exercises.data import DataError
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Arrow, DrawnBody, Line, Picture, Point
from chasles.exercises.worksheet import Worksheet, equal
from chasles.statements.exercise import Answer, Datum, Exercise, ListOf, Record, Scalar, Tuple, Word, vector_shape
from chasles.vocabulary import norm, vector

NAMES = ("P1", "P2", "P3", "P4")
along = vector("l", "l", "from one point towards another")


def solve(sheet: Worksheet) -> str:
    """The forces are moved to the point that is asked about, which is made the origin; there they are a wrench."""
    points, near = sheet["points"], sheet["closest_to"]
    here = points[near]
    sheet.given({name: points[name] for name in NAMES}, "The points.")
    total = moment = here * 0
    for k, (start, end, size) in enumerate(sheet["forces"], 1):
        total, moment = add(sheet, points, here, (k, start, end, size), (total, moment))
    says = f"Together they are one force f, the sum of the forces, at {near} and one moment n_A about it."
    sheet.step(says, ("f", total), ("n_A", moment))
    if equal(total, here * 0):
        sheet.step("Without a resultant force the moment is the same about every point: no point is distinguished.")
        sheet.answer(n=moment)
        return "pure-couple"
    says = f"From here on A is {near}, and the origin; f is the resultant force."
    sheet.given({force: total, moment_A: moment, a: here * 0}, says)
    nearest = sheet.compute(wrench_point, f"Of the points about which the moment is least, the one nearest {near}.")
    sheet.given({p: nearest}, "The force is applied there.")
    sheet.compute(moment_about_point_by_force, "The moment about that point.")
    signed = sheet.compute(least_moment, "Its component along the force, which no choice of P changes.")
    least = sheet.compute(least_moment_vector, "The moment of least magnitude.")
    pitch = sheet.compute(pitch_of_wrench)
    place = sheet.show(norm(p_0__), f"Its distance from {near}.", named="distance")
    says = f"In the given coordinates, {near} added.{halfway(points, nearest + here)}"
    sheet.step(says, ("P", nearest + here), cites=(least_moment_on_one_line,))
    sheet.check((moment_P, n_0), "The moment about P is the least one.")
    sheet.check(wrench_point_is_on_axis, "It is parallel to the force.")
    sheet.check(wrench_point_is_nearest, f"P is the foot of the perpendicular from {near}.")
    sheet.answer(f=total, P=nearest + here, n_min=least, n_min_signed=signed, pitch=pitch, distance=place)
    sheet.picture = picture(sheet, total, nearest + here)
    return "ok"


def add(
    sheet: Worksheet, points: dict[str, Value], here: Value, one: tuple[int, str, str, Value], sums: tuple[Value, Value]
) -> tuple[Value, Value]:
    """One force, and its moment about the point that is asked about, added to the sums."""
    k, start, end, size = one
    way = points[end] - points[start]
    if equal(way, way * 0):
        raise DataError(f"forces: a force from {start} to {end} has no direction, as these points are one")
    if sign(size) < 0:
        raise DataError(f"forces: the magnitude of the force from {start} to {end} is negative; exchange the points")
    vector_of_force = sheet.value(along / norm(along), {along: way}) * size
    at = {force: vector_of_force, moment_A: way * 0, a: points[start], p: here}
    sheet.step(f"The force of magnitude {size} from {start} to {end}.", (f"f_{k}", vector_of_force))
    says = f"It acts at {start}, where it has no moment; its moment about {sheet['closest_to']}, with f_{k} for f."
    moment = sheet.compute(moment_about_point, says, at=at)
    return sums[0] + vector_of_force, sums[1] + moment


def halfway(points: dict[str, Value], place: Value) -> str:
    """Between which of the points the place is halfway, if between any."""
    pairs = ((one, two) for k, one in enumerate(NAMES) for two in NAMES[k + 1 :])
    found = (f" P is the midpoint of {one} and {two}." for one, two in pairs
             if equal(points[one] + points[two], 2 * place) and not equal(points[one], points[two]))  # fmt: skip
    return next(found, "")


def picture(sheet: Worksheet, total: Value, place: Value) -> Picture:
    """The tetrahedron with the forces and the axis of the wrench."""
    points = sheet["points"]
    edges = tuple((points[one], points[two]) for k, one in enumerate(NAMES) for two in NAMES[k + 1 :])
    forces = tuple(
        Arrow(points[start], points[end] - points[start], f"f_{k}")
        for k, (start, end, _) in enumerate(sheet["forces"], 1)
    )
    marks = (*(Point(points[name], name) for name in NAMES), Point(place, "P"))
    axis = Line(place, total, "axis")
    return Picture("The forces and the axis of their wrench", (DrawnBody(edges), axis, *forces, *marks))


def instance(draw: Draw) -> dict[str, Value]:
    """The tetrahedron, with other forces."""
    return {"forces": [[*draw.some(NAMES, 2), str(draw.integer(1, 9))] for _ in range(2)]}


exercise = Exercise(
    "3.2",
    "Two forces on a tetrahedron",
    asked=("Find the point, nearest P4, about which the moment of the two forces is least.",),
    data=(
        Datum(
            "points",
            Record(NAMES, vector_shape()),
            {
                "P1": [1, 0, 0],
                "P2": ["1/2", "sqrt(3)/2", 0],
                "P3": ["1/2", "sqrt(3)/6", "sqrt(6)/3"],
                "P4": [0, 0, 0],
            },
            "the four points",
        ),
        Datum(
            "forces",
            ListOf(Tuple((("from", Word(NAMES)), ("to", Word(NAMES)), ("magnitude", Scalar())))),
            [["P2", "P3", 1], ["P4", "P1", 1]],
            "the forces: from a point, towards a point, magnitude",
        ),
        Datum("closest_to", Word(NAMES), "P4", "the point to which P is to be nearest"),
    ),
    statuses=("ok", "pure-couple"),
    stand_ins={
        "points": "The book shows the axes only in a figure; P4 at the origin, P1 on X and P2 in the plane XY stand in."
    },
    solve=solve,
    instance=instance,
    answers=(
        Answer("f", vector_shape(), "the sum of the forces", ("ok",)),
        Answer("P", vector_shape(), "the point that is asked for, in the given coordinates", ("ok",)),
        Answer("n_min", vector_shape(), "the moment about P, as a vector", ("ok",)),
        Answer("n_min_signed", Scalar(), "its component along f: negative if it is opposite to f", ("ok",)),
        Answer("pitch", Scalar(), "the pitch of the wrench, n_min_signed / |f|", ("ok",)),
        Answer("distance", Scalar(), "the distance of P from the point to which it is to be nearest", ("ok",)),
        Answer("n", vector_shape(), "of a pure couple, the moment, the same about all points", ("pure-couple",)),
    ),
)
