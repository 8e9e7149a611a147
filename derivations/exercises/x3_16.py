"""Exercise 3.16: the smallest principal moment of inertia is least at the center of mass, though not only there."""

from chasles.derivations.exercises.calculations.inertia_data import require_inertia
from chasles.derivations.exercises.calculations.outlines import axes_to_draw
from chasles.derivations.exercises.x3_15 import point
from chasles.derivations.notation import I_A, I_C, a, arc, c, e, m, r_C, x_any, zero
from chasles.derivations.s08_dynamics import inertia_about_point, mass_is_positive

from chasles.exact.evaluate import Value
from chasles.exact.polynomial_roots import same_number
from chasles.exact.principal_axes import in_axes
from chasles.exact.spectra import diagonal, each_eigenvalue, residues_of, signature, smallest_belongs_to
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Arrow, Picture, Point
from chasles.exercises.worksheet import Refuted, Worksheet
from chasles.statements import Claim, Definite, Definition, Minimum, Theorem
from chasles.statements.exercise import Answer, Datum, Exercise, ListOf, Scalar, Truth, matrix_shape, vector_shape
from chasles.vocabulary import cross, norm, paren

greater_by_a_square = Claim(
    "Ex 3.16",
    x_any.T @ I_A @ x_any,
    x_any.T @ I_C @ x_any + m * norm(cross(r_C, x_any)) ** 2,
    says="About parallel axes through P and C, along any vector x, the moments differ by m |d x x|^2.",
    given=(inertia_about_point, point),
)

no_moment_is_smaller = Theorem(
    "Ex 3.16",
    part=2,
    says="None is smaller than at C. For the unit x of the smallest moment at P: that moment is x . I_P x, which is "
    "not less than x . I_C x, nor this than the smallest moment at C.",
    forms=(
        Definite(
            x_any.T @ paren(I_A - I_C) @ x_any,
            squares=(m * norm(cross(r_C, x_any)) ** 2,),
        ),
    ),
    given=(inertia_about_point, point),
    assuming=(mass_is_positive,),
)

least_at_center_of_mass = Theorem(
    "Ex 3.16",
    part=3,
    says="Over all points A, the moment about an axis through A along x is least at the center of mass.",
    forms=(
        Minimum(
            of=x_any.T @ I_A @ x_any / m,
            value=x_any.T @ I_C @ x_any / m,
            over=a,
            at=c,
            squares=(cross(a - c, x_any),),
        ),
    ),
    given=(inertia_about_point,),
    assuming=(mass_is_positive,),
)

point_on_axis = Definition("Ex 3.16", a, c + arc * e, part=4, says="A point on the axis through C along e.")

not_only_there = Claim(
    "Ex 3.16",
    I_A @ e,
    I_C @ e,
    part=5,
    says="If e is along the axis of the smallest moment at C, the same moment is found at every point of that axis: "
    "equality needs d x x = 0 for an x of the smallest moment, that is, d is zero or of that moment itself.",
    given=(inertia_about_point, point_on_axis),
)


def solve(sheet: Worksheet) -> str:
    """The moments at each point, and whether the smallest is that at C."""
    sheet.given({I_C: require_inertia("I_C", sheet["I_C"]), m: sheet["m"], c: sheet.value(zero)})
    sheet.state(greater_by_a_square)
    sheet.state(no_moment_is_smaller)
    sheet.state(least_at_center_of_mass)
    at_C = each_eigenvalue(sheet.values[I_C])
    sheet.step("The principal moments at C.", ("moments", at_C))
    found, equal_ones = [], []
    for d in sheet["d"]:
        found.append(moments_at(sheet, d))
        equal_ones.append(smallest_belongs_to(sheet.values[I_C], d))
        same = "is that at C: d is zero, or along an axis of that moment" if equal_ones[-1] else "is greater than at C"
        sheet.step(f"The smallest of them {same}.", ("moments", found[-1]))
        if same_number(found[-1][0], at_C[0]) != equal_ones[-1]:
            raise Refuted(f"the moments {found[-1][0]} and {at_C[0]} contradict what d says")
    if any(same and any(d) for d, same in zip(sheet["d"], equal_ones, strict=True)):
        sheet.state(
            not_only_there, f"So the minimum is not attained at the center of mass alone. {not_only_there.says}"
        )
    sheet.answer(moments_C=at_C, moments_P=found, smallest_equal_to_C=equal_ones)
    axes = axes_to_draw(sheet.values[I_C])
    items: list[Arrow | Point] = [Arrow(sheet.values[c], axis, f"axis {k} at C") for k, axis in enumerate(axes, 1)]
    items += [Point(d, f"P{k}") for k, d in enumerate(sheet["d"], 1)]
    sheet.picture = Picture("The principal axes at C, and the points", tuple(items))
    return "ok"


def moments_at(sheet: Worksheet, d: Value) -> Value:
    """The principal moments at one point."""
    at = {r_C: d}
    at |= {a: sheet.compute(point, at=at)}
    matrix = sheet.compute(inertia_about_point, "The moment of inertia at P.", at=at)
    moments = each_eigenvalue(matrix)
    residues = residues_of(matrix, moments)
    sheet.check((residues, 0 * residues), "The moments are the roots of the characteristic polynomial.")
    _, smaller, _ = signature(matrix - sheet.values[I_C])
    sheet.check((smaller, 0), "The difference from I_C has no negative eigenvalue.")
    return moments


def instance(draw: Draw) -> dict[str, Value]:
    """A body, and a point on each of its axes."""
    turn, moments = draw.rotation(), draw.among(((3, 4, 5), (2, 2, 3), (4, 5, 8)))
    points = [turn[:, k] * draw.integer(1, 3) for k in range(3)]
    return draw.written(I_C=in_axes(diagonal(moments), turn), m=draw.integer(1, 4), d=points)


exercise = Exercise(
    "3.16",
    "The smallest principal moment of inertia",
    asked=("Show that the smallest principal moment of inertia of a body attains its minimum at the center of mass.",),
    data=(
        Datum("I_C", matrix_shape(), [[3, 0, 0], [0, 4, 0], [0, 0, 5]], "moment of inertia at the center of mass"),
        Datum("m", Scalar(positive=True), 1, "mass"),
        Datum("d", ListOf(vector_shape()), [[1, 0, 0], [0, 1, 0], [1, 1, 1]], "positions from the center of mass"),
    ),
    assumptions=(
        "The exercise says 'at the center of mass': that is one place where the minimum is attained, not the only one.",
    ),
    stand_ins=dict.fromkeys(
        ("I_C", "m", "d"),
        "The exercise gives no numbers: I_C = diag(3, 4, 5), m = 1 and three points stand in; at the first, on the "
        "axis of the smallest moment, that moment is the same as at C.",
    ),
    solve=solve,
    instance=instance,
    answers=(
        Answer("moments_C", vector_shape(), "principal moments at C, in ascending order"),
        Answer("moments_P", ListOf(vector_shape()), "the same at each point, in the order of the points"),
        Answer("smallest_equal_to_C", ListOf(Truth()), "for each point, whether the smallest is that at C"),
    ),
)
