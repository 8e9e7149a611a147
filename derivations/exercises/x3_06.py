"""Exercise 3.6: the screw of a gripper's motion, from its axes and one point."""

from chasles.derivations.exercises.motion import SCREW_ANSWERS, SCREW_SIGNS, SCREW_SYMBOLS, find_screw, is_a_rotation
from chasles.derivations.notation import Q, a, a_, e_1, e_1_, e_2, e_2_, e_3, e_3_, unit_columns
from chasles.derivations.s02_screw import displaced_triad_as_columns, rotation_in_triad_axes, triad_as_columns

from chasles.exact.evaluate import Value
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Arrow, Line, Picture, Point
from chasles.exercises.worksheet import Worksheet
from chasles.statements.exercise import Datum, Exercise, vector_shape

DERIVED = (
    "The book shows the frames only in a figure. Read from the text: Y is parallel to D'C', and C' = (0, 1, 0), so "
    "that the vertex cut off next to C' is the origin, and the other is (1, 1, 1): both triangles are normal to "
    "(1, 1, 1). That is the direction of X'': in the planes, i'' could not be all positive; and j'' is normal to CC', "
    "C = (1, 0, 1), which (1, 1, 1) is not. So j'' is along i'' x CC', its Z-component positive, and k'' = i'' x j''. "
    "In the reference pose, the axes of F' are parallel to those of F."
)


def solve(sheet: Worksheet) -> str:
    """The axes after the motion, as columns, are the rotation from the reference pose."""
    reference = dict(zip((e_1, e_2, e_3), unit_columns, strict=True))
    sheet.given({a: sheet["p"], a_: sheet["c"]}, "P in the reference pose, and C', with which it is to coincide.")
    sheet.given(reference | {e_1_: sheet["i"], e_2_: sheet["j"], e_3_: sheet["k"]}, "The axes of F, and those of F''.")
    sheet.compute(triad_as_columns)
    sheet.compute(displaced_triad_as_columns)
    sheet.values[Q] = sheet.compute(rotation_in_triad_axes, "(a) In the axes of F, the rotation has these components.")
    sheet.answer(Q=sheet.value(Q))
    if not is_a_rotation(sheet):
        sheet.step("The three axes are not orthonormal and right-handed: they are no frame.")
        return "not-a-rotation"
    status = find_screw(sheet)
    if status == "screw":
        sheet.step(
            "(b) The points of least displacement are those of the screw axis.",
            ("p_0", sheet.answers["p0"]),
            ("direction", sheet.answers["e"]),
        )
        axis = (Line(sheet.answers["p0"], sheet.answers["e"], "screw axis"), Point(sheet.answers["p0"], "P_0"))
        frame = tuple(Arrow(sheet["c"], sheet[name], f"{name}''") for name in "ijk")
        points = (Point(sheet["p"], "P"), Point(sheet["c"], "C'"))
        title = "The gripper's frame after its motion, and the screw axis"
        sheet.picture = Picture(title, (*axis, *frame, *points), view=(22, -35))
    return status


def instance(draw: Draw) -> dict[str, Value]:
    """Axes with rational components, and any two points."""
    turn = draw.rotation()
    return draw.written(i=turn[:, 0], j=turn[:, 1], k=turn[:, 2], p=draw.vector(), c=draw.vector())


exercise = Exercise(
    "3.6",
    "A gripper on a workpiece",
    asked=(
        "Find the angle and the axis of the gripper's rotation from its reference pose.",
        "Find the points of the gripper whose displacement is least, P being brought to C'.",
    ),
    data=(
        Datum("i", vector_shape(), ["1/sqrt(3)", "1/sqrt(3)", "1/sqrt(3)"], "axis X'' in F"),
        Datum("j", vector_shape(), ["-1/sqrt(2)", 0, "1/sqrt(2)"], "axis Y'' in F"),
        Datum("k", vector_shape(), ["1/sqrt(6)", "-2/sqrt(6)", "1/sqrt(6)"], "axis Z'' in F"),
        Datum("p", vector_shape(), [2, -1, "1/4"], "reference position of P"),
        Datum("c", vector_shape(), [0, 1, 0], "position of C'"),
    ),
    statuses=("screw", "pure-translation", "not-a-rotation"),
    stand_ins=dict.fromkeys(("i", "j", "k"), DERIVED)
    | {"c": "The book shows C' only in a figure; (0, 1, 0) stands in."},
    solve=solve,
    instance=instance,
    symbols=SCREW_SYMBOLS,
    signs=SCREW_SIGNS,
    turns=("phi",),
    answers=SCREW_ANSWERS,
)
