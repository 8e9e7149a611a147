"""Exercise 3.1: the screw of the displacement of a cube."""

from chasles.derivations.exercises.calculations.lines import meets_plane
from chasles.derivations.exercises.motion import SCREW_ANSWERS, SCREW_SIGNS, SCREW_SYMBOLS, find_screw, is_a_rotation
from chasles.derivations.notation import Q, a, a_, d_A, e_1, e_1_, e_2, e_2_, e_3, e_3_, p, triad, triad_
from chasles.derivations.s02_screw import (
    displaced_triad,
    displaced_triad_as_columns,
    point_after_displacement,
    triad_as_columns,
)

from chasles.exact.evaluate import Value
from chasles.exact.numbers import is_zero
from chasles.exercises.data import DataError
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Arrow, DrawnBody, Line, Picture, Point
from chasles.exercises.worksheet import Worksheet
from chasles.statements.exercise import Answer, Datum, Else, Exercise, Record, vector_shape
from chasles.vocabulary import det, inverse

CORNERS = ("A", "B", "D", "E")


def solve(sheet: Worksheet) -> str:
    """The edges at A, as columns before and after, give Q; Q and the displacement of A give the screw."""
    before, after = sheet["before"], sheet["after"]
    sheet.given({a: before["A"], a_: after["A"]}, "The corner A before and after.")
    for edges, columns, corners in (((e_1, e_2, e_3), triad_as_columns, before), ((e_1_, e_2_, e_3_), None, after)):
        vectors = {edge: corners[name] - corners["A"] for edge, name in zip(edges, CORNERS[1:], strict=True)}
        sheet.given(vectors, f"The edges AB, AD and AE {'before' if columns else 'after'}.")
        sheet.compute(columns or displaced_triad_as_columns)
    if is_zero(sheet.value(det(triad))):
        raise DataError("before: expected a corner with three edges in space, and A, B, D, E lie in one plane")
    sheet.values[Q] = sheet.show(
        triad_ @ inverse(triad), "(a) Each edge is turned by Q, which follows.", named="Q", cites=(displaced_triad,)
    )
    sheet.answer(Q=sheet.value(Q))
    if not is_a_rotation(sheet):
        sheet.step("No motion of a rigid body takes the edges there: they are deformed, or mirrored.")
        return "not-a-rotation"
    status = find_screw(sheet)
    for name in CORNERS:
        sheet.check((point_after_displacement.right, after[name]), f"{name} arrives.", at={p: before[name]})
    axis = (
        (Line(sheet.answers["p0"], sheet.answers["e"], "screw axis, with its hits as dots"),)
        if status == "screw"
        else ()
    )
    hits = None
    if status == "screw":
        places = zip(("X=0", "Y=0", "Z=0"), range(3), strict=True)
        hits = {name: meets_plane(sheet.answers["p0"], sheet.answers["e"], k) for name, k in places}
        sheet.step("(c) Along the axis from P_0, until a coordinate vanishes.", *hits.items())
    sheet.answer(hits=hits)
    bodies = (DrawnBody(edges_of(before), "before", faded=True), DrawnBody(edges_of(after), "after"))
    corners = ((before, ""), (after, "'"))
    labels = tuple(Point(places[name], name + mark) for places, mark in corners for name in CORNERS)
    arrow = Arrow(before["A"], sheet.value(d_A), "d_A")
    labels += tuple(Point(hit) for hit in (hits or {}).values() if not isinstance(hit, str))
    sheet.picture = Picture("The cube before and after, and its screw axis", (*bodies, *axis, arrow, *labels))
    return status


def edges_of(corners: dict[str, Value]) -> tuple[tuple[Value, Value], ...]:
    """The twelve edges of the parallelepiped."""
    corner = corners["A"]
    ways = [corners[name] - corner for name in CORNERS[1:]]
    return tuple(
        (start, start + ways[k])
        for k in range(3)
        for one in (0, 1)
        for other in (0, 1)
        for start in [corner + one * ways[(k + 1) % 3] + other * ways[(k + 2) % 3]]
    )


def instance(draw: Draw) -> dict[str, Value]:
    """A unit cube, turned and moved."""
    turn, way = draw.rotation(), draw.vector()
    ways = {"A": way * 0, **{name: turn[:, k] for k, name in enumerate(CORNERS[1:])}}
    return {"after": draw.written(**{name: way + edge for name, edge in ways.items()})}


exercise = Exercise(
    "3.1",
    "The displacement of a cube",
    asked=(
        "Find the rotation Q that the cube undergoes.",
        "Find the Plücker coordinates of the line of the cube whose points have the least displacement.",
        "Find where that line meets the coordinate planes.",
    ),
    data=(
        Datum(
            "before",
            Record(CORNERS, vector_shape()),
            {"A": [0, 0, 0], "B": [1, 0, 0], "D": [0, 1, 0], "E": [0, 0, 1]},
            "a corner A and its three neighbours",
        ),
        Datum(
            "after",
            Record(CORNERS, vector_shape()),
            {"A": [2, 0, 0], "B": [2, 1, 0], "D": [2, 0, 1], "E": [3, 0, 0]},
            "the same after the displacement",
        ),
    ),
    statuses=("screw", "pure-translation", "not-a-rotation"),
    stand_ins=dict.fromkeys(
        ("before", "after"),
        "The book gives the positions only in a figure; a unit cube at the origin, A' = (2, 0, 0), stands in.",
    ),
    solve=solve,
    instance=instance,
    symbols=SCREW_SYMBOLS,
    signs=SCREW_SIGNS,
    turns=("phi",),
    answers=(
        *SCREW_ANSWERS,
        Answer(
            "hits",
            Else(Record(("X=0", "Y=0", "Z=0"), Else(vector_shape(), ("parallel", "contained")))),
            "where the screw axis meets each coordinate plane, or how it lies to it; null without an axis",
            ("screw", "pure-translation"),
        ),
    ),
)
