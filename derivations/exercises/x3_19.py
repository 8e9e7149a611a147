"""Exercise 3.19: the readouts of a force sensor, moved to another point and into another frame."""

from chasles.derivations.notation import Q, a, force, moment_A, moment_P, p
from chasles.derivations.s07_statics import moment_about_point, wrench_transfer_inverse

from chasles.exact.evaluate import Value
from chasles.exercises.data import DataError
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Arrow, Picture, Point
from chasles.exercises.worksheet import Worksheet
from chasles.statements import rotation
from chasles.statements.exercise import Answer, Datum, Exercise, matrix_shape, vector_shape

OTHER = "stands in: the book shows the frames and the points only in a figure of another chapter"


def solve(sheet: Worksheet) -> str:
    """(3.106) moves the moment from S to P; R turns both vectors into F_2."""
    sheet.given(
        {moment_A: sheet["n"], force: sheet["f"], a: sheet["r"] * 0, p: sheet["r"]},
        "The readouts: a moment about S and a force; S is the origin, P lies at r.",
    )
    sheet.given({Q: sheet["R"]}, "The rotation that takes coordinates in F_S to coordinates in F_2.")
    if not sheet.satisfied(rotation(Q)):
        raise DataError("R: expected a rotation matrix, and R^T R is not the identity or det R is not 1")
    moved = sheet.compute(moment_about_point, "The moment about P, in F_S.")
    moment = sheet.show(Q @ moment_P, "The moment about P, in F_2.")
    turned = sheet.show(Q @ force, "The force, in F_2.")
    back = {moment_A: moved, a: sheet["r"], p: sheet["r"] * 0}
    sheet.check(
        (sheet.value(moment_about_point.right, back), sheet["n"]),
        "Moved back from P to S, the moment is the one that was read.",
        cites=(wrench_transfer_inverse,),
    )
    sheet.check((Q.T @ Q @ force, force), "Turned back into F_S, the force is the one that was read.")
    sheet.answer(n_P_in_S=moved, n_P_in_2=moment, f_in_2=turned)
    sheet.picture = Picture(
        "The wrench at P, in the sensor's frame",
        (
            Point(sheet["r"] * 0, "S"),
            Point(sheet["r"], "P"),
            Arrow(sheet["r"], sheet["f"], "force"),
            Arrow(sheet["r"], moved, "moment about P"),
        ),
    )
    return "ok"


def instance(draw: Draw) -> dict[str, Value]:
    """Any readouts, any point, any frame."""
    return draw.written(n=draw.vector(), f=draw.vector(), r=draw.vector() / 10, R=draw.rotation())


exercise = Exercise(
    "3.19",
    "A wrench from a force sensor",
    asked=("Find the wrench at P in the frame F_2 from what the sensor at S reads.",),
    data=(
        Datum("n", vector_shape(), [1, 0, 1], "moment about S read by the sensor, N m"),
        Datum("f", vector_shape(), [0, 1, 0], "force read by the sensor, N"),
        Datum("r", vector_shape(), [0, 0, "1/10"], "position of P from S in F_S, m"),
        Datum("R", matrix_shape(), [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "takes coordinates in F_S to those in F_2"),
    ),
    assumptions=("The sensor reads the moment about S. Moments in N m, lengths in m.",),
    stand_ins={
        "r": f"r = (0, 0, 1/10) m {OTHER}; the distance of 100 mm is the book's.",
        "R": f"R = 1, parallel frames, {OTHER}.",
    },
    solve=solve,
    instance=instance,
    answers=(
        Answer("n_P_in_S", vector_shape(), "moment about P, components in F_S, N m"),
        Answer("n_P_in_2", vector_shape(), "moment about P, components in F_2, N m"),
        Answer("f_in_2", vector_shape(), "force, components in F_2, N"),
    ),
)
