"""Section 6: rigid motions as 4 x 4 matrices; screws."""

from chasles.rotations.notation import *
from chasles.rotations.s1_rotations import Q_is_a_rotation, R_is_a_rotation, angular_velocity, e_is_unit

from chasles.statements import Claim, Definition, Kernel, Section, nonzero, perpendicular
from chasles.vocabulary import (
    CPM,
    Node,
    Zero,
    column,
    cos,
    cross,
    det,
    dot,
    inverse,
    matrix,
    number,
    over,
    paren,
    rate,
    sin,
    tr,
)
from chasles.vocabulary.motions import homogeneous, inverse_motion

rigid_motions = Section("6", "Rigid Motions")


def _turn(angle: Node) -> Node:
    """The rotation about the axis e."""
    return e @ e.T + cos(angle) * (one - e @ e.T) + sin(angle) * E


motion = Definition(
    "6.1",
    T, homogeneous(Q, p_T),
    says="A rigid motion as a 4 x 4 matrix: a rotation, and where the origin goes.",
    sign="=",
    assuming=(Q_is_a_rotation,),
    kernel=Kernel(of=(Q, p_T)),
)

another_motion = Definition(
    "6.1",
    S, homogeneous(R, p_S),
    part=2,
    says="Another rigid motion.",
    sign="=",
    assuming=(R_is_a_rotation,),
)

motion_of_point = Claim(
    "6.2",
    T @ column(x, 1), column(Q @ x + p_T, 1),
    says="A point has a one below its coordinates: it is turned and shifted.",
    given=(motion,),
)

motion_of_vector = Claim(
    "6.3",
    T @ column(a, 0), column(Q @ a, 0),
    says="A vector has a zero there: it is turned only.",
    given=(motion,),
)

composition_of_motions = Claim(
    "6.4",
    T @ S, homogeneous(Q @ R, Q @ p_S + p_T),
    says="Motions follow one another as their matrices multiply.",
    given=(motion, another_motion),
    kernel=Kernel(of=(Q, p_T, R, p_S)),
)

motion_is_rotation_then_translation = Claim(
    "6.5",
    T, along(p_T) @ turned(Q),
    says="A motion is a rotation about the origin, and then a translation.",
    given=(motion,),
)

motion_is_translation_then_rotation = Claim(
    "6.5",
    T, turned(Q) @ along(Q.T @ p_T),
    part=2,
    says="Or a translation first, by what is seen of it from the moving frame.",
    given=(motion,),
)

determinant_of_motion = Claim(
    "6.6",
    det(T), number(1),
    says="The determinant of a motion is one.",
    given=(motion,),
)

inverse_of_motion = Claim(
    "6.7",
    inverse(T), homogeneous(Q.T, -Q.T @ p_T),
    says="The inverse of a motion, without solving equations.",
    given=(motion,),
    kernel=Kernel(of=(Q, p_T), expected=(Q_is_a_rotation,)),
)

motion_and_back = Claim(
    "6.8",
    inverse_motion(T) @ T, one_4,
    says="A motion and its inverse.",
    given=(motion,),
)

inverse_of_composition = Claim(
    "6.9",
    inverse_motion(T @ S), inverse_motion(S) @ inverse_motion(T),
    says="The inverse of a composition has the inverses in the opposite order.",
    given=(motion, another_motion),
)

motion_keeps_distances = Claim(
    "6.10",
    dot(paren(Q @ x + p_T) - paren(Q @ x_1 + p_T), paren(Q @ x + p_T) - paren(Q @ x_1 + p_T)),
    dot(x - x_1, x - x_1),
    says="A motion keeps distances.",
    assuming=(Q_is_a_rotation,),
)

relative_motion = Claim(
    "6.11",
    inverse_motion(T) @ S, homogeneous(Q.T @ R, Q.T @ paren(p_S - p_T)),
    says="The second frame as seen from the first.",
    given=(motion, another_motion),
    kernel=Kernel(of=(Q, p_T, R, p_S), expected=(Q_is_a_rotation, R_is_a_rotation)),
)

rotation_about_an_axis_off_the_origin = Claim(
    "6.12",
    along(c) @ turned(Q) @ along(-c), homogeneous(Q, paren(one - Q) @ c),
    says="A rotation about an axis through another point than the origin.",
)

screw_motion = Definition(
    "6.13",
    T, homogeneous(_turn(phi), paren(one - _turn(phi)) @ c + d * e),
    says="A screw: a rotation about an axis through c, and an advance along it.",
    sign="=",
    assuming=(e_is_unit,),
    kernel=Kernel(of=(e, phi, c, d)),
)

points_of_screw_axis_advance = Claim(
    "6.14",
    T @ column(c + d_1 * e, 1), column(c + (d_1 + d) * e, 1),
    says="The points of the axis move along it.",
    given=(screw_motion,),
)

rotation_and_advance_commute = Claim(
    "6.15",
    turned(_turn(phi)) @ along(d * e), along(d * e) @ turned(_turn(phi)),
    says="A rotation and a translation along its axis may be exchanged.",
    assuming=(e_is_unit,),
)

rotation_and_translation_commute_only_along_the_axis = Claim(
    "6.16",
    turned(Q) @ along(x) - along(x) @ turned(Q), matrix((Zero(3, 3), paren(Q - one) @ x), (zero_row, 0)),
    says="By how much it matters which comes first.",
)

screw_through_another_point_of_the_axis = Claim(
    "6.17",
    paren(one - _turn(phi)) @ paren(c + d_1 * e), paren(one - _turn(phi)) @ c,
    says="It does not matter which point of the axis is named.",
    assuming=(e_is_unit,),
)

first_screw = Definition(
    "6.18",
    H, homogeneous(_turn(phi_1), paren(one - _turn(phi_1)) @ c + d_1 * e),
    says="The first of two screws about one axis.",
    sign="=",
    assuming=(e_is_unit,),
)

second_screw = Definition(
    "6.18",
    K, homogeneous(_turn(phi_2), paren(one - _turn(phi_2)) @ c + d_2 * e),
    part=2,
    says="The second of two screws about one axis.",
    sign="=",
    assuming=(e_is_unit,),
)

screws_about_one_axis_add_up = Claim(
    "6.19",
    K @ H,
    homogeneous(_turn(phi_1 + phi_2), paren(one - _turn(phi_1 + phi_2)) @ c + (d_1 + d_2) * e),
    says="Screws about one axis add their angles and their advances.",
    given=(first_screw, second_screw),
)

screws_about_one_axis_commute = Claim(
    "6.20",
    K @ H, H @ K,
    says="And may be exchanged.",
    given=(first_screw, second_screw),
)

advance_of_screw = Claim(
    "6.21",
    dot(e, T[1:3, 4]), d,
    says="The advance of a screw: the component of the translation along the axis.",
    given=(screw_motion,),
)

point_of_screw_axis = Claim(
    "6.22",
    c,
    over(1, 2) * paren(T[1:3, 4] - d * e) + over(1, 2) * (cos(phi / 2) / sin(phi / 2)) * cross(e, T[1:3, 4]),
    says="The point of the axis that is nearest to the origin.",
    given=(screw_motion,),
    assuming=(perpendicular(e, c), nonzero(sin(phi / 2))),
)

rotation_from_motion = Claim(
    "6.23",
    tr(T), 2 + 2 * cos(phi),
    says="The trace of a screw gives its angle.",
    given=(screw_motion,),
)

velocity_of_point = Claim(
    "6.24",
    rate(Q @ x_rest + p_T), cross(omega, Q @ x_rest) + rate(p_T),
    says="The velocity of a point that the moving frame carries.",
    given=(angular_velocity,),
    assuming=(Q_is_a_rotation,),
)

velocity_of_point_that_moves_in_the_frame = Claim(
    "6.25",
    rate(Q @ x_1 + p_T), cross(omega, Q @ x_1) + Q @ rate(x_1) + rate(p_T),
    says="The velocity of a point that moves in the moving frame.",
    given=(angular_velocity,),
    assuming=(Q_is_a_rotation,),
)

acceleration_of_point_that_moves_in_the_frame = Claim(
    "6.26",
    rate(rate(Q @ x_1 + p_T)),
    rate(rate(p_T))
    + cross(rate(omega), Q @ x_1)
    + cross(omega, cross(omega, Q @ x_1))
    + 2 * cross(omega, Q @ rate(x_1))
    + Q @ rate(rate(x_1)),
    says="Its acceleration, with the centripetal term and that of Coriolis.",
    given=(angular_velocity,),
    assuming=(Q_is_a_rotation,),
)

rate_of_motion = Claim(
    "6.27",
    rate(T) @ inverse_motion(T), matrix((CPM(omega), rate(p_T) - cross(omega, p_T)), (zero_row, 0)),
    says="The rate of a motion, moved back: the angular velocity, and the velocity of what is at the origin now.",
    given=(motion, angular_velocity),
)
