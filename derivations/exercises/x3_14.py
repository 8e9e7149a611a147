"""Exercise 3.14: two observers measure the moment of inertia of one body in two frames; do they agree?"""

from chasles.derivations.exercises.calculations.inertia_data import require_symmetric
from chasles.derivations.exercises.calculations.outlines import axes_to_draw
from chasles.derivations.notation import I_C, Q, half, one, over_body, r_C, rho, unit_columns, x_any
from chasles.derivations.s08_dynamics import density_is_positive, inertia

from chasles.exact.evaluate import Value
from chasles.exact.principal_axes import in_axes, principal_axes, product
from chasles.exact.spectra import diagonal, each_eigenvalue, residues_of, signature
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Arrow, Curve, Picture, Point
from chasles.exercises.worksheet import Worksheet, equal
from chasles.statements import Claim, Definite, Theorem, rotation
from chasles.statements.exercise import Answer, Datum, Exercise, Truth, matrix_shape, vector_shape
from chasles.vocabulary import column, det, dot, number, paren, tr

Q_turns_the_frame = rotation(Q)
turned = Q @ I_C @ Q.T
second = half * (tr(I_C) ** 2 - tr(I_C @ I_C))

invariants = (
    Claim("Ex 3.14", tr(turned), tr(I_C), says="The trace is the same in all frames.", assuming=(Q_turns_the_frame,)),
    Claim(
        "Ex 3.14",
        tr(turned @ turned),
        tr(I_C @ I_C),
        part=2,
        says="So is the trace of the square, and with it the second invariant.",
        assuming=(Q_turns_the_frame,),
    ),
    Claim("Ex 3.14", det(turned), det(I_C), part=3, says="So is the determinant.", assuming=(Q_turns_the_frame,)),
)

second_moment = Claim(
    "Ex 3.14",
    half * tr(I_C) * one - I_C,
    over_body(rho * r_C @ r_C.T),
    part=4,
    says="Half the trace less the moment of inertia is the integral of rho r r^T.",
    given=(inertia,),
)

only_bodies_have_it = Theorem(
    "Ex 3.14",
    part=5,
    says="That matrix is positive-semidefinite: no principal moment exceeds the sum of the others. It is singular only "
    "if all elements lie in one plane, normal to its null vector.",
    forms=(
        Definite(
            x_any.T @ paren(half * tr(I_C) * one - I_C) @ x_any,
            squares=(over_body(rho * dot(r_C, x_any) ** 2),),
        ),
    ),
    given=(inertia,),
    assuming=(density_is_positive,),
)


def solve(sheet: Worksheet) -> str:
    """Equal invariants are necessary; a rotation that takes one result into the other shows that they suffice."""
    found = {name: observer(sheet, name) for name in ("A", "B")}
    compatible = equal(found["A"][0], found["B"][0])
    says = "are equal: in suitable axes both matrices are the same" if compatible else "differ: no one body has both"
    for claim in invariants:
        sheet.state(claim)
    sheet.step(f"The invariants {says}.", ("A", found["A"][0]), ("B", found["B"][0]), cites=invariants)
    if compatible:
        show_rotation(sheet)
    admissible = [is_admissible for _, is_admissible, _ in found.values()]
    planar = [is_planar for _, _, is_planar in found.values()]
    sheet.state(second_moment)
    sheet.state(only_bodies_have_it)
    sheet.step(
        "Is it the moment of inertia of a body? Only if half its trace less the matrix is positive-semidefinite.",
        ("A", found["A"][1]),
        ("B", found["B"][1]),
        ("all elements in one plane", all(planar)),
    )
    away = sheet.value(unit_columns[0]) * 4
    # Four colours take turns: with a line between the two sets of axes, like axes are alike.
    axes_A, axes_B = (tuple(enumerate(axes_to_draw(sheet[name]), 1)) for name in ("A", "B"))
    seen_by_A = tuple(Arrow(0 * away, axis, f"axis {k}, by ascending moment") for k, axis in axes_A)
    seen_by_B = tuple(Arrow(away, axis) for _, axis in axes_B)
    frames = (Point(0 * away, "as A has them"), Point(away, "as B has them"))
    between = Curve((0 * away, away))
    title = "The principal axes in the frames of both observers"
    sheet.picture = Picture(title, (*seen_by_A, between, *seen_by_B, *frames))
    sheet.answer(compatible=compatible, physically_admissible=all(admissible), planar=all(planar))
    return "ok"


def observer(sheet: Worksheet, name: str) -> tuple[Value, bool, bool]:
    """What one observer's matrix says: its invariants, whether a body can have it, whether that body is planar."""
    at = {I_C: require_symmetric(name, sheet[name])}
    triple = sheet.show(column(tr(I_C), second, det(I_C)), f"The invariants, as {name} has them.", at=at)
    square = sheet.show(tr(I_C @ I_C), f"The trace of the square, as {name} has it.", at=at)
    moments = each_eigenvalue(at[I_C])
    residues = residues_of(at[I_C], moments)
    sheet.step(f"The principal moments, as {name} has them.", ("moments", moments))
    sheet.check((residues, 0 * residues), f"They are the roots of the characteristic polynomial of {name}.")
    sheet.answer(**{f"invariants_{name}": triple, f"eigenvalues_{name}": moments})
    sheet.answer(trace_sq=[*sheet.answers.get("trace_sq", []), square])
    _, negative, null = signature(sheet.value(second_moment.left, at))
    return triple, negative == 0, negative == 0 and null > 0


def show_rotation(sheet: Worksheet) -> None:
    """A rotation that takes the matrix of B into that of A, where square roots express one."""
    if isinstance(sheet.answers["eigenvalues_A"], list):
        sheet.step("Equal characteristic polynomials: both are the same diagonal matrix in their principal axes.")
        return
    axes_A, axes_B = principal_axes(sheet["A"]), principal_axes(sheet["B"])
    says = "A rotation from the axes of B to those of A; half-turns about principal axes lead to others."
    sheet.given({Q: product(axes_A.T, axes_B)}, says)
    sheet.check((sheet.value(turned, {I_C: sheet["B"]}), sheet["A"]), "It takes the matrix of B into that of A.")
    sheet.check((Q @ Q.T, one), "It is a rotation: it is orthogonal.")
    sheet.check((det(Q), number(1)), "It is proper.")


def instance(draw: Draw) -> dict[str, Value]:
    """One body, or two that differ in one moment, as seen from two frames."""
    moments = draw.among(((3, 4, 5), (2, 2, 3), (1, 2, 3), (4, 5, 8)))
    others = draw.among((moments, (*moments[:2], moments[2] + 1)))
    turns = draw.rotation(), draw.rotation()
    return draw.written(A=in_axes(diagonal(moments), turns[0]), B=in_axes(diagonal(others), turns[1]))


exercise = Exercise(
    "3.14",
    "Two measurements of one moment of inertia",
    asked=(
        "Two observers report the centroidal moment of inertia of one body, each in a frame of its own.",
        "Show, by invariants, that the two agree.",
    ),
    data=(
        Datum("A", matrix_shape(), [[1, 0, 0], [0, 2, 0], [0, 0, 3]], "the matrix of observer A"),
        Datum(
            "B", matrix_shape(), [[2, "2/3", "2/3"], ["2/3", "5/3", 0], ["2/3", 0, "7/3"]], "the matrix of observer B"
        ),
    ),
    assumptions=(
        "Equal invariants say that the measurements agree with each other; that a body has such a moment of inertia is "
        "a further condition, which the exercise does not ask for and which is tested as well.",
    ),
    solve=solve,
    instance=instance,
    answers=(
        *(Answer(f"invariants_{x}", vector_shape(), f"trace, second invariant, determinant of {x}") for x in "AB"),
        *(Answer(f"eigenvalues_{x}", vector_shape(), f"principal moments of {x}, in ascending order") for x in "AB"),
        Answer("trace_sq", vector_shape(2), "the traces of A^2 and B^2"),
        Answer("compatible", Truth(), "whether both can be of one body"),
        Answer("physically_admissible", Truth(), "whether bodies with these moments of inertia exist"),
        Answer("planar", Truth(), "whether all elements of such bodies lie in one plane"),
    ),
)
