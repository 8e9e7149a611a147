"""Exercise 3.12: the hexagonal prism of Exercise 3.11, cut in two by a plane through an edge of its base."""

from chasles.derivations.exercises.calculations.bodies import (
    Body,
    cotangent_of_degrees,
    cut_hexagonal_prism,
    joined,
    regular_hexagon,
    tangent_of_double_angle,
    whole_prism,
)
from chasles.derivations.exercises.calculations.outlines import prism_edges, section_of
from chasles.derivations.exercises.x3_11 import (
    TETRAHEDRA,
    UNIT_DENSITY,
    UNITS,
    drawn_axes,
    mass_properties,
    principal,
)
from chasles.derivations.notation import I_C, a, c, m, zero
from chasles.derivations.s08_dynamics import inertia_about_point

from chasles.exact.evaluate import Value, column_of
from chasles.exact.numbers import compare, normal
from chasles.exact.principal_axes import CHOICE_OF_AXES
from chasles.exercises.data import DataError
from chasles.exercises.draw import Draw
from chasles.exercises.picture import Arrow, Curve, DrawnBody, Picture, Point
from chasles.exercises.worksheet import Worksheet
from chasles.statements.exercise import Answer, Datum, Else, Exercise, Scalar, matrix_shape, vector_shape

PARTS = ("wedge", "rest")
WORDS = ("undetermined", "infinite")


def solve(sheet: Worksheet) -> str:
    """Both parts by the same integrals; together they are the prism."""
    side, height = sheet["side"], sheet["height"]
    slope, upward, offset = cutting_plane(sheet)
    corners = regular_hexagon(side)
    whole, (wedge, rest) = whole_prism(corners, height), cut_hexagonal_prism(side, height, slope)
    through_top = compare(2 * slope * corners[1][1], height) > 0
    sheet.step(
        f"The plane leaves the prism through {'its top' if through_top else 'the far side'}: its height there, "
        "at Y = (sqrt(3)/2) side, is",
        ("Z", normal(2 * slope * corners[1][1])),
    )
    sheet.step(TETRAHEDRA)
    sheet.step("The common point lies in the cutting plane, so that the face which the cut makes adds nothing.")
    edges = prism_edges(corners, height)
    # Four colours take turns: with the section between the two sets of axes, like axes are alike.
    drawn = (
        DrawnBody(edges),
        *part(sheet, "wedge", wedge, side),
        Curve(section_of(edges, upward, offset), "section"),
        *part(sheet, "rest", rest, side),
    )
    together(sheet, whole, wedge, rest)
    sheet.picture = Picture("The two parts of the prism, C_w and C_r their centers of mass", drawn)
    return "ok"


def cutting_plane(sheet: Worksheet) -> tuple[Value, Value, Value]:
    """The slope dZ/dY of the plane, its upward normal, and its offset along that."""
    angle = sheet["angle_deg"]
    if compare(angle, 0) <= 0 or compare(angle, 90) >= 0:
        raise DataError(
            f"angle_deg: expected an angle between 0 and 90, and got {angle}: the plane would not cut the prism"
        )
    slope = cotangent_of_degrees(angle)
    edge = regular_hexagon(sheet["side"])[4]
    upward = column_of(0, -slope, 1)
    offset = normal(-slope * edge[1])
    says = "The plane: it holds the edge of the base at Y = -(sqrt(3)/2) side, and rises by the cotangent of the angle."
    sheet.step(says, ("dZ/dY", slope), ("normal", upward), ("normal . p", offset))
    return slope, upward, offset


def part(sheet: Worksheet, name: str, body: Body, size: Value) -> tuple[Arrow | Point, ...]:
    """The answers for one part; what is drawn of it."""
    whose = f"the {name}"
    mass_properties(sheet, body, whose)
    moments, radii, axes = principal(sheet, whose)
    tangent = tangent_of_double_angle(sheet.values[I_C])
    sheet.step(
        f"The axes of {whose} in the YZ plane: tan(2 theta) = 2 I_yz / (I_yy - I_zz).", ("tan(2 theta)", tangent)
    )
    found = {
        "V": sheet.values[m],
        "centroid": sheet.values[c],
        "I_C_over_rho": sheet.values[I_C],
        "moments_over_rho": moments,
        "k2": radii,
        "axes": axes,
        "tan_2theta": tangent,
    }
    sheet.answer(**{f"{name}.{key}": value for key, value in found.items()})
    return drawn_axes(sheet, axes, size, f"C_{name[0]}", labelled=name == "wedge")


def together(sheet: Worksheet, whole: Body, wedge: Body, rest: Body) -> None:
    """The parts add up to the prism: masses, first moments, and moments of inertia about its center of mass."""
    both = joined(wedge, rest)
    sheet.check((both.mass, whole.mass), "The volumes of the parts add up to that of the prism.")
    sheet.check((both.first, whole.first), "So do their first moments.")
    about_origin = []
    for name, body in (("wedge", wedge), ("rest", rest)):
        bound = {m: body.mass, c: sheet.answers[f"{name}.centroid"], I_C: sheet.answers[f"{name}.I_C_over_rho"]}
        says = f"The moment of inertia of the {name} about the origin, by Steiner's theorem."
        about_origin.append(sheet.compute(inertia_about_point, says, at={**bound, a: sheet.value(zero)}))
    sheet.check(
        (about_origin[0] + about_origin[1], whole.inertia),
        "Moved to the origin, the moments of inertia of the parts add up to the prism's.",
    )


def instance(draw: Draw) -> dict[str, Value]:
    """A prism of whole numbers, cut through its far side or through its top."""
    return {"side": draw.integer(1, 40), "height": draw.integer(1, 80), "angle_deg": draw.among((30, 45, 60))}


exercise = Exercise(
    "3.12",
    "A hexagonal prism cut in two",
    asked=(
        "A plane through an edge of the base cuts the prism of Exercise 3.11, at a given angle with its axis.",
        "Find the centroidal principal moments and axes of inertia of each part.",
    ),
    data=(
        Datum("side", Scalar(positive=True), 25, "side of the hexagon, in any unit of length (the book: mm)"),
        Datum("height", Scalar(positive=True), 150, "height of the prism, in the same unit"),
        Datum("angle_deg", Scalar(), 45, "angle between the plane and the axis, in degrees"),
    ),
    assumptions=(
        UNIT_DENSITY,
        UNITS,
        "The base lies in the plane Z = 0 with its center at the origin and two opposite corners on the X axis.",
        "The plane holds the edge of the base at Y = -(sqrt(3)/2) side and rises towards +Y; the wedge is below it.",
        CHOICE_OF_AXES,
    ),
    solve=solve,
    instance=instance,
    axes={f"{name}.axes": (f"{name}.I_C_over_rho", f"{name}.moments_over_rho") for name in PARTS},
    orders=tuple((f"{name}.moments_over_rho", f"{name}.k2", f"{name}.axes") for name in PARTS),
    answers=tuple(
        Answer(f"{name}.{key}", shape, f"{says}, of the {name}")
        for name in PARTS
        for key, shape, says in (
            ("V", Scalar(), "the volume, in the cube of the unit of length"),
            ("centroid", vector_shape(), "the center of mass"),
            ("I_C_over_rho", matrix_shape(), "centroidal moment of inertia per unit of density, by rows"),
            ("moments_over_rho", vector_shape(), "principal moments of inertia per unit of density"),
            ("k2", vector_shape(), "squares of the radii of gyration, in the order of the moments"),
            ("axes", matrix_shape(), "principal axes as rows, in the order of the moments, of any length and sign"),
            ("tan_2theta", Else(Scalar(), WORDS), "2 I_yz / (I_yy - I_zz)"),
        )
    ),
)
