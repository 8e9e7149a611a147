"""Exercise 3.13: the moment of inertia of equal point masses, from the matrix of their positions."""

from chasles.derivations.exercises.calculations.bodies import point_masses
from chasles.derivations.exercises.x3_11 import mass_properties
from chasles.derivations.notation import I_A, I_C, O, a, c, m, one, over_body, p, p_1, rho, zero
from chasles.derivations.s08_dynamics import inertia_with_respect_to_point

from chasles.exact.evaluate import Value
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Picture, Point
from chasles.exercises.worksheet import Worksheet
from chasles.statements import Claim, Definition
from chasles.statements.exercise import Answer, Datum, Exercise, ListOf, Scalar, matrix_shape, vector_shape
from chasles.vocabulary import LENGTH, norm, square, tr

S = square("S", "S", "sum of p p^T over the points so far", LENGTH**2)

point_is_origin = Definition("Ex 3.13", a, zero, says="The moment of inertia is taken about the origin.")

matrix_is_inertia = Claim(
    "Ex 3.13",
    I_A,
    tr(over_body(rho * p @ p.T)) * one - over_body(rho * p @ p.T),
    part=2,
    says="The matrix tr(S) 1 - S, with S the integral of rho p p^T, is the moment of inertia about the origin: of any "
    "body. For equal masses at the points P_i, S is m P P^T, with their positions as the columns of P.",
    given=(inertia_with_respect_to_point, point_is_origin),
)

no_point_adds_nothing = Claim(
    "Ex 3.13", tr(O) * one - O, O, part=3, says="By induction over the points: without any, the matrix is zero."
)

one_more_point = Claim(
    "Ex 3.13",
    tr(S + p_1 @ p_1.T) * one - (S + p_1 @ p_1.T),
    (tr(S) * one - S) + (norm(p_1) ** 2 * one - p_1 @ p_1.T),
    part=4,
    says="One more point adds its own |p|^2 1 - p p^T, so that m [tr(P P^T) 1 - P P^T] is the sum over all points.",
)


def solve(sheet: Worksheet) -> str:
    """The interpretation is a claim; the rest is Section 3.8."""
    points = sheet["points"]
    body = point_masses(sheet["m"], points)
    sheet.state(matrix_is_inertia)
    sheet.state(no_point_adds_nothing)
    sheet.state(one_more_point)
    sheet.given({over_body(rho * p @ p.T): body.second}, "For these points: the matrix m P P^T.")
    about_origin = sheet.compute(matrix_is_inertia, "The moment of inertia about the origin.")
    mass_properties(sheet, body, "the points", "Sums over the points are")
    each = [sheet.value(m * (norm(p) ** 2 * one - p @ p.T), {m: sheet["m"], p: point}) for point in points]
    sheet.check((about_origin, sum(each[1:], each[0])), "It is the sum of m (|p|^2 1 - p p^T) over the points.")
    apart = point_masses(sheet["m"], tuple(point - sheet.values[c] for point in points))
    sheet.check((apart.first, sheet.value(zero)), "As seen from the center of mass, the first moment is zero.")
    sheet.check((apart.inertia, sheet.values[I_C]), "The sum over the points as seen from there is I_C.")
    sheet.answer(I_O=about_origin, centroid=sheet.values[c], total_mass=sheet.values[m], I_C=sheet.values[I_C])
    items = (*(Point(point, f"P{k}") for k, point in enumerate(points, 1)), Point(sheet.values[c], "C"))
    sheet.picture = Picture("The points and their center of mass", items)
    return "ok"


def instance(draw: Draw) -> dict[str, Value]:
    """Three to five points."""
    points = [draw.written(p=draw.vector())["p"] for _ in range(draw.integer(3, 5))]
    return {"m": draw.integer(1, 5), "points": points}


exercise = Exercise(
    "3.13",
    "What a matrix of Exercise 2.23 means",
    asked=("Give a mechanical interpretation of m [tr(P P^T) 1 - P P^T], for equal masses m at points P_i.",),
    data=(
        Datum("m", Scalar(positive=True), 1, "the mass at each point"),
        Datum(
            "points", ListOf(vector_shape()), [[1, 0, 0], [0, 2, 0], [0, 0, 3], [1, 1, 1]], "positions of the points"
        ),
    ),
    assumptions=(
        "Exercise 2.23 is not in the chapter: P is taken to be the matrix whose columns are the positions p_i.",
        "About the center of mass, m in the equations of Section 3.8 is the mass of all points together.",
    ),
    stand_ins={
        "m": "The exercise gives no numbers: unit masses stand in.",
        "points": "The exercise gives no numbers: four points that lie in no plane stand in.",
    },
    solve=solve,
    instance=instance,
    symbols={"centroid": (c,), "total_mass": (m,), "I_C": (I_C,)},
    answers=(
        Answer("I_O", matrix_shape(), "m [tr(P P^T) 1 - P P^T] by rows, the moment of inertia about the origin"),
        Answer("centroid", vector_shape(), "the center of mass"),
        Answer("total_mass", Scalar(), "the mass of all points together"),
        Answer("I_C", matrix_shape(), "the centroidal moment of inertia, by rows"),
    ),
)
