"""Exercise 3.20: the inertia dyad at any point: its blocks, its definiteness, and what Steiner's theorem becomes."""

from chasles.derivations.exercises.calculations.inertia_data import require_inertia
from chasles.derivations.exercises.calculations.outlines import axes_to_draw
from chasles.derivations.notation import I_C, M_A, M_C, A, C, O, a, c, m, one, p
from chasles.derivations.s04_twist import twist_transfer_matrix
from chasles.derivations.s08_dynamics import (
    energy_by_twist_at_A,
    inertia_about_point_by_matrices,
    inertia_dyad,
    inertia_dyad_at_center_of_mass,
    inertia_dyad_is_definite,
    inertia_dyad_moved,
    inertia_dyad_with_subscript,
    no_decomposition,
    steiner_by_dyads,
    twist_at_center_of_mass_from_A,
)

from chasles.exact.evaluate import Value
from chasles.exact.principal_axes import in_axes, product
from chasles.exact.spectra import (
    diagonal,
    each_eigenvalue,
    is_positive_definite,
    leading_minors,
    residues_of,
    signature,
)
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Arrow, Picture, Point
from chasles.exercises.worksheet import Worksheet, equal
from chasles.statements import Claim
from chasles.statements.exercise import Answer, Datum, Exercise, Scalar, Truth, matrix_shape, vector_shape
from chasles.vocabulary import column, det, matrix, paren

determinant_of_dyad = Claim(
    "Ex 3.20",
    det(M_A),
    m**3 * det(I_C),
    says="The determinant of the inertia dyad is the same at all points.",
    given=(inertia_dyad, inertia_about_point_by_matrices),
)

B_node = matrix((I_C, O), (O, O))
P_node = column(C - A, one)
probe = column(one, C - A)


def solve(sheet: Worksheet) -> str:
    """(3.147) and its consequences, at the values."""
    sheet.given({I_C: require_inertia("I_C", sheet["I_C"]), m: sheet["m"], c: sheet["c"], a: sheet["a"]})
    derive(sheet)
    at_A = sheet.values[M_A]
    minors = leading_minors(at_A)
    definite = is_positive_definite(at_A)
    sheet.state(inertia_dyad_is_definite)
    sheet.step("Here, its leading minors.", ("minors", minors), ("positive-definite", definite))
    positive = 3 + signature(sheet["I_C"])[0]
    sheet.check((signature(at_A)[0], positive), "M_A has three positive eigenvalues more than I_C, as M_C has.")
    values = each_eigenvalue(at_A)
    sheet.step("Its eigenvalues, in ascending order.", ("eigenvalues", values))
    residues = residues_of(at_A, values)
    sheet.check((residues, 0 * residues), "They are the roots of its characteristic polynomial.")
    determinant = sheet.show(det(M_A), "Its determinant.", cites=(determinant_of_dyad,))
    sheet.check(determinant_of_dyad, "The determinant does not depend on the point.")
    parts = decompose(sheet)
    sheet.answer(M_A=at_A, **parts, eig_M_A=values, positive_definite=definite, det=determinant)
    axes = axes_to_draw(sheet["I_C"])
    items = [Arrow(sheet["c"], axis, f"axis {k} at C") for k, axis in enumerate(axes, 1)]
    sheet.picture = Picture("The two points", (Point(sheet["c"], "C"), Point(sheet["a"], "A"), *items))
    return "ok"


def derive(sheet: Worksheet) -> None:
    """(3.147), from the kinetic energy as a quadratic form of the twist at A."""
    for statement in (twist_at_center_of_mass_from_A, inertia_dyad_moved, energy_by_twist_at_A):
        sheet.state(statement)
    sheet.compute(inertia_about_point_by_matrices, "The moment of inertia at A.")
    sheet.compute(inertia_dyad, "Multiplied out: the inertia dyad at A.")
    sheet.compute(inertia_dyad_at_center_of_mass, "That at the center of mass.")
    sheet.compute(inertia_dyad_with_subscript)
    sheet.compute(twist_transfer_matrix, "The matrix U.", moved={p: c})
    sheet.check(inertia_dyad_moved, "The dyad at A is congruent to that at C.")


def decompose(sheet: Worksheet) -> dict[str, object]:
    """What Steiner's theorem becomes: the hint's decomposition, which exists at C alone, and one that does."""
    positive, negative, null = found = signature(sheet.value(M_A - M_C))
    says = (
        "The hint asks for M_A = M_C + P P^T (and m R R^T for it). Then M_A - M_C would have no negative eigenvalue; "
        f"it has {positive} positive, {negative} negative and {null} zero."
    )
    sheet.step(says)
    sheet.state(no_decomposition)
    sheet.refute(steiner_by_dyads, "Not with the P that Steiner's theorem suggests:")
    exists = negative == 0
    if exists:
        sheet.step("Here A is the center of mass, and P = 0 (R = 0) does it.")
    else:
        sheet.show(
            probe.T @ paren(M_A - M_C) @ probe,
            "For the columns x of this matrix, x . (M_A - M_C) x is on the diagonal: never positive, not all zero. So "
            "no P, and no R, exists.",
        )
    sheet.step("What does hold: M_A = B + m P P^T, with the moment of inertia alone in B.", cites=(steiner_by_dyads,))
    first, second = (
        sheet.show(B_node, "The positive-semidefinite part.", named="B"),
        sheet.show(P_node, "And P.", named="P"),
    )
    sheet.check(steiner_by_dyads, "B + m P P^T is M_A.")
    sheet.check((signature(first)[1], 0), "B has no negative eigenvalue.")
    return {"B": first, "P": second, "signature_MA_minus_MC": list(found), "hint_decomposition_exists": exists}


def with_rotated_factor(sheet: Worksheet, given: dict[str, Value]) -> list[dict[str, Value]]:
    """P P^T is what counts: P R, with any orthogonal R, is as good as P."""
    if "P" in given and equal(product(given["P"], given["P"].T), product(sheet.answers["P"], sheet.answers["P"].T)):
        return [{"P": given["P"]}]
    return []


def instance(draw: Draw) -> dict[str, Value]:
    """A body, and a point on one of its axes."""
    turn, center = draw.rotation(), draw.vector()
    inertia = in_axes(diagonal(draw.among(((3, 4, 5), (2, 2, 3), (4, 5, 8)))), turn)
    return draw.written(I_C=inertia, m=draw.integer(1, 4), c=center, a=center + turn[:, 0] * draw.integer(0, 3))


exercise = Exercise(
    "3.20",
    "The inertia dyad at any point",
    asked=(
        "Derive the inertia dyad (3.147) at a point A.",
        "Show that it is positive-definite, by a decomposition M_A = M_C + P P^T.",
        "Can P P^T be written as m R R^T, with a 6 x 6 matrix R, as in Steiner's theorem?",
    ),
    data=(
        Datum("I_C", matrix_shape(), [[3, 0, 0], [0, 4, 0], [0, 0, 5]], "moment of inertia at the center of mass"),
        Datum("m", Scalar(positive=True), 1, "mass"),
        Datum("c", vector_shape(), [0, 0, 0], "position of the center of mass"),
        Datum("a", vector_shape(), [1, 0, 0], "position of A"),
    ),
    stand_ins=dict.fromkeys(
        ("I_C", "m", "c", "a"),
        "The exercise gives no numbers: I_C = diag(3, 4, 5), m = 1, c = 0 and a = (1, 0, 0) stand in.",
    ),
    solve=solve,
    instance=instance,
    answers=(
        Answer("M_A", matrix_shape(6, 6), "the inertia dyad at A, by rows, the angular velocity first"),
        Answer("B", matrix_shape(6, 6), "of M_A = B + m P P^T, the part with the moment of inertia alone, by rows"),
        Answer("P", matrix_shape(6, 3), "the other factor, by rows; as far as P P^T determines it"),
        Answer("signature_MA_minus_MC", vector_shape(), "how many eigenvalues of M_A - M_C are > 0, < 0 and 0"),
        Answer("hint_decomposition_exists", Truth(), "whether M_A = M_C + P P^T has a solution P"),
        Answer("eig_M_A", vector_shape(6), "the eigenvalues of M_A in ascending order"),
        Answer("positive_definite", Truth(), "whether M_A is positive-definite"),
        Answer("det", Scalar(), "the determinant of M_A"),
    ),
    alternatives=with_rotated_factor,
    symbols={"M_A": (M_A,), "B": (B_node,), "P": (P_node,), "det": (det(M_A),)},
)
