"""Exercise 3.15: which points share principal axes of inertia with the center of mass?"""

from chasles.derivations.exercises.calculations.inertia_data import require_inertia
from chasles.derivations.exercises.calculations.outlines import axes_to_draw
from chasles.derivations.notation import I_A, I_C, a, c, e, m, r_C, x_any, zero
from chasles.derivations.s08_dynamics import inertia_about_point

from chasles.exact.evaluate import Value
from chasles.exact.numbers import is_zero
from chasles.exact.principal_axes import in_axes
from chasles.exact.spectra import diagonal, each_eigenvalue, residues_of
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Arrow, Curve, Picture, Point
from chasles.exercises.worksheet import Worksheet
from chasles.statements import Claim, Definition, perpendicular, symmetric
from chasles.statements.exercise import Answer, Datum, Exercise, Scalar, Truth, matrix_shape, vector_shape
from chasles.vocabulary import CPM, cross, det, dot, norm, paren, row

I_C_is_symmetric = symmetric(I_C)

point = Definition("Ex 3.15", a, c + r_C, says="The point, called A in (3.133a), by its position d = r from C.")
_moved = (inertia_about_point, point)

commutator = Claim(
    "Ex 3.15",
    I_C @ I_A - I_A @ I_C,
    -m * CPM(cross(r_C, I_C @ r_C)),
    part=2,
    says="The commutator of the two matrices. Symmetric matrices have three common principal axes if and only if they "
    "commute: if and only if d x I_C d = 0, that is, d is zero or itself along a principal axis at C.",
    given=_moved,
    assuming=(I_C_is_symmetric,),
)

one_common_axis = Claim(
    "Ex 3.15",
    cross(paren(cross(r_C, I_C @ r_C)), I_C @ cross(r_C, I_C @ r_C)),
    -det(row(r_C, I_C @ r_C, I_C @ I_C @ r_C)) * r_C,
    part=3,
    says="The normal of d and I_C d is along a principal axis at C if and only if det [d, I_C d, I_C^2 d] = 0.",
    assuming=(I_C_is_symmetric,),
)

axis_normal_to_d = Claim(
    "Ex 3.15",
    I_A @ e,
    I_C @ e + m * norm(r_C) ** 2 * e,
    part=4,
    says="A principal axis at C that is normal to d is one at P, and its moment is greater by m |d|^2.",
    given=_moved,
    assuming=(perpendicular(e, r_C),),
)

axis_along_d = Claim(
    "Ex 3.15",
    I_A @ r_C,
    I_C @ r_C,
    part=5,
    says="A principal axis at C that is along d is one at P, with the same moment.",
    given=_moved,
)

no_other_axis = Claim(
    "Ex 3.15",
    paren(I_A @ x_any - I_C @ x_any) - m * norm(r_C) ** 2 * x_any,
    -(m * dot(r_C, x_any)) * r_C,
    part=6,
    says="No other axis is common: if x is along a principal axis at both, d . x = 0, or x is along d.",
    given=_moved,
)

share_all = cross(r_C, I_C @ r_C)
share_one = det(row(r_C, I_C @ r_C, I_C @ I_C @ r_C))


def solve(sheet: Worksheet) -> str:
    """Two polynomials in I_C and d decide; the moments follow."""
    sheet.given({I_C: require_inertia("I_C", sheet["I_C"]), m: sheet["m"], c: sheet.value(zero), r_C: sheet["d"]})
    sheet.compute(point)
    sheet.compute(inertia_about_point, "The moment of inertia at P, by Steiner's theorem.")
    every = not any(sheet.show(share_all, "All three axes are common if and only if this is zero."))
    sheet.state(commutator)
    some = is_zero(sheet.show(share_one, "At least one axis is common if and only if this is zero."))
    sheet.state(no_other_axis)
    sheet.state(one_common_axis)
    sheet.state(axis_along_d)
    sheet.state(axis_normal_to_d)
    at_C, at_P = each_eigenvalue(sheet.values[I_C]), each_eigenvalue(sheet.values[I_A])
    sheet.step("The principal moments, in ascending order.", ("at C", at_C), ("at P", at_P))
    sheet.check(commutator, "The commutator, substituted.")
    for name, matrix, moments in (("C", I_C, at_C), ("P", I_A, at_P)):
        residues = residues_of(sheet.values[matrix], moments)
        sheet.check((residues, 0 * residues), f"The moments at {name} are the roots of its characteristic polynomial.")
    sheet.answer(I_P=sheet.values[I_A], share_all_axes=every, share_at_least_one=some, moments_C=at_C, moments_P=at_P)
    sheet.picture = drawn(sheet)
    return "ok"


def drawn(sheet: Worksheet) -> Picture:
    """C and P with the principal axes at each."""
    size = sheet.value(norm(r_C)) / 2 if any(sheet["d"]) else 1
    center, other = sheet.values[c], sheet.values[a]
    rows = [axes_to_draw(sheet.values[matrix]) for matrix in (I_C, I_A)]
    # Four colours take turns: with d between the two sets of axes, like axes are alike.
    items = (
        Point(center, "C"),
        Point(other, "P"),
        *(Arrow(center, size * axis, f"axis {k}") for k, axis in enumerate(rows[0], 1)),
        Arrow(center, other - center, "d") if any(sheet["d"]) else Curve((center, center)),
        *(Arrow(other, size * axis) for axis in rows[1]),
    )
    return Picture("The principal axes at C and at P", items)


def instance(draw: Draw) -> dict[str, Value]:
    """A body, and a point on one of its axes or in one of its principal planes."""
    turn, moments = draw.rotation(), draw.among(((3, 4, 5), (2, 2, 3), (4, 5, 8)))
    d = turn[:, 0] * draw.integer(0, 3) + turn[:, 1] * draw.integer(0, 3)
    return draw.written(I_C=in_axes(diagonal(moments), turn), m=draw.integer(1, 4), d=d)


exercise = Exercise(
    "3.15",
    "Principal axes at the center of mass and elsewhere",
    asked=(
        "When does a point P share principal axes of inertia with the center of mass?",
        "How are the principal moments at the two points related then?",
    ),
    data=(
        Datum("I_C", matrix_shape(), [[3, 0, 0], [0, 4, 0], [0, 0, 5]], "moment of inertia at the center of mass"),
        Datum("m", Scalar(positive=True), 1, "mass"),
        Datum("d", vector_shape(), [1, 1, 0], "position of P from the center of mass, p - c"),
    ),
    assumptions=(
        "The exercise can be read in two ways, and both are answered: that all principal axes are common, and that at "
        "least one is.",
        "Where two principal moments are equal, every axis in the plane of theirs counts as principal.",
    ),
    stand_ins=dict.fromkeys(
        ("I_C", "m", "d"), "The exercise gives no numbers: I_C = diag(3, 4, 5), m = 1 and d = (1, 1, 0) stand in."
    ),
    solve=solve,
    instance=instance,
    symbols={"I_P": (I_A,)},
    answers=(
        Answer("I_P", matrix_shape(), "the moment of inertia at P, by rows"),
        Answer("share_all_axes", Truth(), "whether all principal axes at C and at P are common"),
        Answer("share_at_least_one", Truth(), "whether at least one is"),
        *(Answer(f"moments_{x}", vector_shape(), f"principal moments at {x}, in ascending order") for x in "CP"),
    ),
)
