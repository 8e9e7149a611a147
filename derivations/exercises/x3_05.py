"""Exercise 3.5: the distance of a line from the origin, and its nearest point, from its Plücker coordinates."""

from chasles.derivations.notation import arc, e, n, p_0
from chasles.derivations.s02_screw import (
    direction_is_unit,
    moment_is_normal,
    moment_of_line,
    screw_axis_point_is_nearest,
)

from chasles.exact.evaluate import Value
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Arrow, Curve, Line, Picture, Point
from chasles.exercises.worksheet import Worksheet
from chasles.statements import Claim, Condition, unit
from chasles.statements.exercise import Answer, Datum, Exercise, Scalar, vector_shape
from chasles.vocabulary import cross, dot, norm

nearest_point_is_on_line = Condition(
    "Ex 3.5",
    cross(p_0, e),
    n,
    says="P* lies on the line: the moment of the line is that of a force at P*.",
    given=(moment_of_line,),
    on=(p_0,),
)

nearest_point = Claim(
    "Ex 3.5",
    p_0,
    cross(e, n),
    part=2,
    says="The point of a line nearest the origin, from the line's direction and moment.",
    given=(moment_of_line, nearest_point_is_on_line, screw_axis_point_is_nearest),
    assuming=(unit(e),),
)

square_of_distance = Claim(
    "Ex 3.5",
    dot(p_0, p_0),
    dot(n, n),
    part=3,
    says="The distance of the line from the origin is the magnitude of its moment.",
    given=(moment_of_line, nearest_point_is_on_line, screw_axis_point_is_nearest),
    assuming=(unit(e),),
)

other_points_are_farther = Claim(
    "Ex 3.5",
    norm(p_0 + arc * e) ** 2,
    norm(p_0) ** 2 + arc**2,
    part=4,
    says="Every other point of the line is farther away, by the square of its distance along the line.",
    given=(moment_of_line, nearest_point_is_on_line, screw_axis_point_is_nearest),
    assuming=(unit(e),),
)


def solve(sheet: Worksheet) -> str:
    """(a) and (b) are claims, decided; (c) evaluates them."""
    pi, status = sheet["pi"], "line"
    sheet.given({e: pi[:3, :], n: pi[3:, :]}, "The Plücker coordinates: a direction and a moment about the origin.")
    length = sheet.holds(direction_is_unit, "Do they belong to a line? Its direction is to be a unit vector.")
    if not sheet.holds(moment_is_normal, "Its moment is to be normal to its direction.") or not any(pi[:3, :]):
        return "not-a-line"
    if not length:
        status, pi = "not-normalised", pi / sheet.value(norm(e))
        normal = {e: pi[:3, :], n: pi[3:, :]}
        sheet.given(normal, "They are a multiple of normalised coordinates, which are had by division by |e|.")
    point = sheet.compute(nearest_point, "(b) The two conditions on P* determine it.")
    sheet.step(
        "(a) |p*| = |n|, and every other point of the line is farther away.",
        cites=(square_of_distance, other_points_are_farther),
    )
    distance = sheet.show(norm(n), "(c) The distance, in numbers.", named="d")
    sheet.check(nearest_point_is_on_line, "P* lies on the line.")
    sheet.check(screw_axis_point_is_nearest, "P* is the foot of the perpendicular from the origin.")
    sheet.check((distance**2, (point.T * point)[0, 0]), "The distance is that of P*.")
    sheet.answer(d=distance, p=point)
    origin = point * 0
    items: list[Arrow | Curve | Line | Point] = [Line(point, pi[:3, :], "axis"), Point(point, "P*"), Point(origin, "O")]
    if any(point):
        items += [Curve((origin, point), "perpendicular, of length d"), Arrow(origin, pi[3:, :], "n")]
    sheet.picture = Picture("The axis, its point nearest the origin, its moment n", tuple(items))
    return status


def instance(draw: Draw) -> dict[str, Value]:
    """A line by a rational direction and a point."""
    direction = draw.unit()
    return {"pi": draw.written(e=direction)["e"] + draw.written(n=draw.vector().cross(direction))["n"]}


exercise = Exercise(
    "3.5",
    "The Plücker coordinates of a joint axis",
    asked=(
        "Show that the distance of an axis from the origin is the magnitude of its moment.",
        "Show that the point of the axis nearest the origin is e x n.",
        "Find both for the measured Plücker coordinates.",
    ),
    data=(
        Datum(
            "pi",
            vector_shape(6),
            ["-sqrt(2)/2", 0, "sqrt(2)/2", 0, "-sqrt(2)", 0],
            "Plücker coordinates of the axis: direction, moment about the origin",
        ),
    ),
    statuses=("line", "not-a-line", "not-normalised"),
    solve=solve,
    instance=instance,
    symbols={"p": (p_0,)},
    answers=(
        Answer("d", Scalar(), "the distance of the axis from the origin", ("line", "not-normalised")),
        Answer("p", vector_shape(), "the point of the axis nearest the origin", ("line", "not-normalised")),
    ),
)
