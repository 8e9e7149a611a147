"""The screw of a motion, as exercises ask for it: from the rotation and one point before and after."""

from chasles.derivations.notation import Q, d0, e, n, p_0, p_1, phi, pitch
from chasles.derivations.s02_screw import (
    axial_displacement,
    displacement_of_landmark,
    moment_of_line,
    pitch_of_screw,
    rotation_from_axis_angle,
    screw_axis_moves_along_itself,
    screw_axis_point,
    screw_axis_point_is_nearest,
    shared_component,
)
from chasles.derivations.s04_twist import natural_invariants

from chasles.exact.numbers import angle
from chasles.exercises.worksheet import Worksheet, equal
from chasles.statements import rotation
from chasles.statements.exercise import Answer, Else, Scalar, matrix_shape, vector_shape
from chasles.vocabulary import cos, det, number, sin

__all__ = ["NO_AXIS", "SCREW_ANSWERS", "SCREW_SIGNS", "SCREW_SYMBOLS", "find_screw", "is_a_rotation"]

NO_AXIS = {"e": None, "p0": None, "n": None, "d0": None, "pitch": None}
"""The answers where all points move alike: no line is distinguished, and the pitch is infinite."""


SCREW_SYMBOLS = {"Q": (Q,), "phi": (phi,), "e": (e,), "p0": (p_0,), "n": (n,), "d0": (d0,), "pitch": (pitch,)}
SCREW_SIGNS = (("e", "phi", "n", "d0"),)
"""A rotation through phi about e is one through -phi about -e; the advance along -e has the other sign."""

_MOVED = ("screw", "pure-translation")
SCREW_ANSWERS = (
    Answer("Q", matrix_shape(), "the rotation, by rows"),
    Answer("phi", Scalar(), "its angle in radians, in [0, pi]; 0 for a pure translation", _MOVED),
    Answer("e", Else(vector_shape()), "the unit direction of its axis; null for a pure translation", _MOVED),
    Answer("p0", Else(vector_shape()), "the point of the screw axis nearest the origin; else null", _MOVED),
    Answer("n", Else(vector_shape()), "the moment of the screw axis about the origin; else null", _MOVED),
    Answer("d0", Else(Scalar()), "the displacement along the axis, positive along e; else null", _MOVED),
    Answer("pitch", Else(Scalar()), "the displacement along the axis per radian, d0 / phi; else null", _MOVED),
)


def is_a_rotation(sheet: Worksheet) -> bool:
    """Whether Q is proper orthogonal, shown in two steps."""
    one = sheet.value(Q.T @ Q)
    sheet.show(Q.T @ Q, "A rigid body keeps lengths and angles: Q^T Q is to be the identity.")
    sheet.show(det(Q), "And right hands: det Q is to be 1.")
    return equal(one, one**0) and sheet.satisfied(rotation(Q))


def find_screw(sheet: Worksheet) -> str:
    """The status; Q, which is a rotation, a and a_ are known."""
    sheet.compute(displacement_of_landmark, "The displacement of the landmark.")
    if not sheet.invert(natural_invariants, "The axis and the angle of the rotation."):
        sheet.step("Q is the identity: all points have this displacement, and there is no axis.", ("Q", sheet.value(Q)))
        sheet.answer(phi=sheet.value(number(0)), **NO_AXIS)
        return "pure-translation"
    turned = angle(sheet.value(cos(phi)), sheet.value(sin(phi)))
    sheet.given({phi: turned}, "The angle with that cosine and sine, between 0 and pi.")
    point = sheet.compute(screw_axis_point)
    moment = sheet.compute(moment_of_line, moved={p_1: p_0})
    advance = sheet.compute(shared_component, "What all displacements share: the advance along the axis.")
    sheet.compute(axial_displacement, "The displacement of the points of the axis, of all the least.")
    pitch = sheet.compute(pitch_of_screw, "The pitch, per radian.")
    sheet.check(rotation_from_axis_angle, "Axis and angle give the rotation back.")
    sheet.check(screw_axis_point_is_nearest, "P_0 is the foot of the perpendicular from the origin.")
    sheet.check(screw_axis_moves_along_itself, "P_0 is displaced along the axis.")
    sheet.answer(phi=turned, e=sheet.value(e), p0=point, n=moment, d0=advance, pitch=pitch)
    return "screw"
