"""Exercise 3.11: the centroid and the centroidal moment of inertia of a hexagonal prism."""

from chasles.derivations.exercises.calculations.bodies import Body, regular_hexagon, whole_prism
from chasles.derivations.exercises.calculations.outlines import prism_edges
from chasles.derivations.notation import I_A, I_C, a, c, m, one, rho, zero
from chasles.derivations.s08_dynamics import (
    center_of_mass,
    first_moment,
    inertia,
    inertia_about_point,
    mass,
)

from chasles.exact.evaluate import Value, matrix_of
from chasles.exact.principal_axes import CHOICE_OF_AXES, columns_of, principal_axes, product
from chasles.exact.spectra import diagonal, each_eigenvalue, eigenvalues
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Arrow, DrawnBody, Picture, Point
from chasles.exercises.worksheet import Worksheet
from chasles.statements.exercise import Answer, Datum, Exercise, Scalar, matrix_shape, vector_shape

UNIT_DENSITY = "The density is one: a mass stands for a volume, and a moment of inertia is per unit of density."

UNITS = (
    "With lengths in some unit, as mm in the book, V is in its third power, I_C_over_rho and the moments are in its "
    "fifth, k2 in its second."
)

TETRAHEDRA = (
    "Each face falls into triangles; each triangle and one common point make a tetrahedron. Of one with its corners at "
    "that point and at a, b, c from there, and with s = a + b + c, the volume V is a . (b x c) / 6; the integral of x "
    "is V s / 4, and that of x x^T is V (s s^T + a a^T + b b^T + c c^T) / 20."
)


def mass_properties(sheet: Worksheet, body: Body, whose: str, way: str = "Added up with their signs, they are") -> None:
    """Bind mass, center of mass and centroidal moment of inertia of a body, whose integrals are known.

    The integral about the center of mass and the one about the origin are found apart; Steiner's theorem relates them.
    """
    integrals = {rho: 1, mass.right: body.mass, first_moment.right: body.first}
    sheet.given(integrals, f"{way} the integrals over {whose}, exactly.")
    sheet.compute(mass, f"The mass of {whose}.")
    sheet.compute(first_moment)
    sheet.compute(center_of_mass, f"The center of mass of {whose}.")
    says = "The integral about the center of mass: tr(S) 1 - S, with S the integral of p p^T less q_O q_O^T / m."
    sheet.given({inertia.right: body.centroidal_inertia}, says)
    sheet.compute(inertia, f"The centroidal moment of inertia of {whose}.")
    about_origin = {a: sheet.value(zero), I_A: body.inertia}
    sheet.check(
        inertia_about_point,
        f"Steiner's theorem leads to the moment of inertia of {whose} at the origin.",
        at=about_origin,
    )


def principal(sheet: Worksheet, whose: str) -> tuple[Value, Value, Value]:
    """Principal moments (ascending), squares of the radii of gyration, and axes (rows), of what is bound."""
    matrix, total = sheet.values[I_C], sheet.values[m]
    moments = each_eigenvalue(matrix)
    radii = matrix_of(moments / total)
    axes = principal_axes(matrix)
    distinct = len(eigenvalues(matrix))
    freedom = {
        1: " All are equal: every axis is principal.",
        2: " Two are equal: every axis in their plane is principal.",
        3: "",
    }
    sheet.step(
        f"Principal moments of inertia of {whose}, their axes as rows, and the squares of the radii of gyration."
        f"{freedom[distinct]}",
        ("moments", moments),
        ("axes", axes),
        ("k squared", radii),
    )
    left = matrix_of(matrix * axes.T - axes.T * diagonal(moments))
    sheet.check((left, 0 * left), f"I e less its moment times e vanishes for each axis e of {whose}.")
    sheet.check((product(axes, axes.T), sheet.value(one)), f"The axes of {whose} are orthonormal.")
    return moments, radii, axes


def drawn_axes(
    sheet: Worksheet, axes: Value, size: Value, name: str = "C", labelled: bool = True
) -> tuple[Arrow | Point, ...]:
    """The principal axes, from the center of mass that is bound."""
    center, rows = sheet.values[c], columns_of(axes)
    arrows = tuple(Arrow(center, size * axis, f"axis {k}" if labelled else "") for k, axis in enumerate(rows, 1))
    return (Point(center, name), *arrows)


def solve(sheet: Worksheet) -> str:
    """The integrals are those of a prism; the rest is Section 3.8."""
    side, height = sheet["side"], sheet["height"]
    corners = regular_hexagon(side)
    sheet.step(TETRAHEDRA)
    mass_properties(sheet, whole_prism(corners, height), "the prism")
    moments, radii, axes = principal(sheet, "the prism")
    sheet.answer(V=sheet.values[m], centroid=sheet.values[c], I_C_over_rho=sheet.values[I_C])
    sheet.answer(moments_over_rho=moments, axes=axes, k2=radii)
    items = (DrawnBody(prism_edges(corners, height)), *drawn_axes(sheet, axes, side))
    sheet.picture = Picture("The prism and its principal axes", items)
    return "ok"


def instance(draw: Draw) -> dict[str, Value]:
    """A prism of whole numbers."""
    return {"side": draw.integer(1, 60), "height": draw.integer(1, 99)}


exercise = Exercise(
    "3.11",
    "The moment of inertia of a hexagonal prism",
    asked=(
        "Find the center of mass of a homogeneous prism over a regular hexagon.",
        "Find its centroidal principal moments and axes of inertia.",
    ),
    data=(
        Datum("side", Scalar(positive=True), 25, "side of the hexagon, in any unit of length (the book: mm)"),
        Datum("height", Scalar(positive=True), 150, "height of the prism, in the same unit"),
    ),
    assumptions=(
        UNIT_DENSITY,
        UNITS,
        "The base lies in the plane Z = 0 with its center at the origin and two opposite corners on the X axis.",
        CHOICE_OF_AXES,
    ),
    solve=solve,
    instance=instance,
    answers=(
        Answer("V", Scalar(), "the volume, in the cube of the unit of length"),
        Answer("centroid", vector_shape(), "the center of mass"),
        Answer("I_C_over_rho", matrix_shape(), "centroidal moment of inertia per unit of density, by rows"),
        Answer("moments_over_rho", vector_shape(), "principal moments of inertia per unit of density"),
        Answer("axes", matrix_shape(), "principal axes as rows, in the order of the moments, of any length and sign"),
        Answer("k2", vector_shape(), "squares of the principal radii of gyration, in ascending order"),
    ),
    symbols={"V": (m,), "centroid": (c,), "I_C_over_rho": (I_C,)},
    axes={"axes": ("I_C_over_rho", "moments_over_rho")},
)
