"""Section 1: rotation matrices, their invariants, axis and angle."""

from chasles.rotations.notation import *

from chasles.statements import Claim, Definition, Kernel, Section, nonzero, rotation, unit
from chasles.statements.inequalities import inequality, says_that
from chasles.vocabulary import (
    CPM,
    PI,
    Cofactor,
    Node,
    Zero,
    cos,
    cross,
    det,
    dot,
    number,
    over,
    paren,
    rate,
    sin,
    tr,
    vect,
)
from chasles.vocabulary.functions import arccos, atan2
from chasles.vocabulary.partial import partial

rotation_matrices = Section("1", "Rotation Matrices")

e_is_unit, Q_is_a_rotation, R_is_a_rotation = unit(e), rotation(Q), rotation(R)


def _turn(angle: Node) -> Node:
    """The rotation about the axis e, in three parts."""
    return e @ e.T + cos(angle) * (one - e @ e.T) + sin(angle) * E


rotation_about_axis = Definition(
    "1.1",
    Q, _turn(phi),
    says="The rotation about an axis through an angle: what lies along the axis stays, what is normal to it turns.",
    sign="=",
    assuming=(e_is_unit,),
    kernel=Kernel(of=(e, phi)),
)

square_of_cross_product_matrix = Claim(
    "1.2",
    E**2, e @ e.T - one,
    says="The square of the cross-product matrix of a unit vector is minus the projection normal to it.",
    assuming=(e_is_unit,),
)

cube_of_cross_product_matrix = Claim(
    "1.3",
    E**3, -E,
    says="The cube of the cross-product matrix of a unit vector is its opposite.",
    assuming=(e_is_unit,),
)

rodrigues_formula = Claim(
    "1.4",
    Q, one + sin(phi) * E + (1 - cos(phi)) * E**2,
    says="Rodrigues' formula: the rotation as a polynomial in the cross-product matrix of its axis.",
    given=(rotation_about_axis,),
)

rotation_by_half_the_angle = Claim(
    "1.5",
    Q, one + 2 * sin(phi / 2) * cos(phi / 2) * E + 2 * sin(phi / 2) ** 2 * E**2,
    says="Rodrigues' formula by half the angle, which loses no digits where the angle is small.",
    given=(rotation_about_axis,),
)

rotation_of_a_vector = Claim(
    "1.6",
    Q @ a, cos(phi) * a + sin(phi) * cross(e, a) + (1 - cos(phi)) * dot(e, a) * e,
    says="A vector, turned about an axis through an angle.",
    given=(rotation_about_axis,),
    kernel=Kernel(of=(e, phi, a)),
)

rotation_is_orthogonal = Claim(
    "1.7",
    Q.T @ Q, one,
    says="The transpose of a rotation is its inverse.",
    given=(rotation_about_axis,),
)

rotation_is_proper = Claim(
    "1.8",
    det(Q), number(1),
    says="The determinant of a rotation is one: it mirrors nothing.",
    given=(rotation_about_axis,),
)

axis_stays = Claim(
    "1.9",
    Q @ e, e,
    says="A rotation leaves its axis where it is.",
    given=(rotation_about_axis,),
)

rotation_back = Claim(
    "1.10",
    Q.T, _turn(-phi),
    says="The rotation through the opposite angle is the transpose.",
    given=(rotation_about_axis,),
)

rotation_about_opposite_axis = Claim(
    "1.11",
    Q, one + sin(-phi) * CPM(-e) + (1 - cos(-phi)) * CPM(-e) ** 2,
    says="The opposite angle about the opposite axis gives the same rotation.",
    given=(rotation_about_axis,),
)

trace_of_rotation = Claim(
    "1.12",
    tr(Q), 1 + 2 * cos(phi),
    says="The trace of a rotation gives the cosine of its angle.",
    given=(rotation_about_axis,),
)

axial_vector_of_rotation = Claim(
    "1.13",
    vect(Q), sin(phi) * e,
    says="The axial vector of a rotation lies along its axis and gives the sine of its angle.",
    given=(rotation_about_axis,),
)

skew_part_of_rotation = Claim(
    "1.14",
    Q - Q.T, 2 * sin(phi) * E,
    says="What is skew-symmetric in a rotation.",
    given=(rotation_about_axis,),
)

symmetric_part_of_rotation = Claim(
    "1.15",
    Q + Q.T, 2 * cos(phi) * one + 2 * (1 - cos(phi)) * e @ e.T,
    says="What is symmetric in a rotation.",
    given=(rotation_about_axis,),
)

axis_from_rotation = Claim(
    "1.16",
    e, vect(Q) / sin(phi),
    says="The axis of a rotation that is no half-turn.",
    given=(rotation_about_axis,),
    assuming=(nonzero(sin(phi)),),
)

projection_on_axis = Claim(
    "1.17",
    e @ e.T, (Q + Q.T - (tr(Q) - 1) * one) / (3 - tr(Q)),
    says="The projection on the axis from the rotation, half-turns included.",
    given=(rotation_about_axis,),
    assuming=(nonzero(3 - tr(Q)),),
    kernel=Kernel(of=(Q,), expected=(Q_is_a_rotation,)),
)

first_rotation_about_axis = Definition(
    "1.18",
    Q_1, _turn(phi_1),
    says="The first of two rotations about one axis.",
    sign="=",
    assuming=(e_is_unit,),
)

second_rotation_about_axis = Definition(
    "1.18",
    Q_2, _turn(phi_2),
    part=2,
    says="The second of two rotations about one axis.",
    sign="=",
    assuming=(e_is_unit,),
)

angles_about_one_axis_add_up = Claim(
    "1.19",
    Q_2 @ Q_1, _turn(phi_1 + phi_2),
    says="Angles of rotations about one axis add up.",
    given=(first_rotation_about_axis, second_rotation_about_axis),
)

rotations_about_one_axis_commute = Claim(
    "1.20",
    Q_2 @ Q_1, Q_1 @ Q_2,
    says="Two rotations about one axis may be exchanged.",
    given=(first_rotation_about_axis, second_rotation_about_axis),
)

half_turn_about_axis = Claim(
    "1.21",
    _turn(PI), 2 * e @ e.T - one,
    says="A half-turn keeps what lies along its axis and turns round what is normal to it.",
)

rotation_is_its_cofactor_matrix = Claim(
    "1.22",
    Q, Cofactor(Q),
    says="A rotation is its own matrix of cofactors: each of its columns is the vector product of the others.",
    assuming=(Q_is_a_rotation,),
)

rotation_keeps_products = Claim(
    "1.23",
    dot(Q @ a, Q @ b), dot(a, b),
    says="A rotation keeps scalar products, and with them lengths and angles.",
    assuming=(Q_is_a_rotation,),
)

rotation_keeps_vector_products = Claim(
    "1.24",
    cross(Q @ a, Q @ b), Q @ cross(a, b),
    says="A rotation turns a vector product as it turns the factors.",
    assuming=(Q_is_a_rotation,),
)

cross_product_matrix_of_turned_vector = Claim(
    "1.25",
    CPM(Q @ a), Q @ CPM(a) @ Q.T,
    says="The cross-product matrix of a turned vector.",
    assuming=(Q_is_a_rotation,),
)

characteristic_equation_of_rotation = Claim(
    "1.26",
    Q**3 - tr(Q) * Q**2 + tr(Q) * Q - one, Zero(3, 3),
    says="The Cayley-Hamilton equation of a rotation: its trace says all.",
    assuming=(Q_is_a_rotation,),
)

trace_of_square = Claim(
    "1.27",
    tr(Q**2), tr(Q) ** 2 - 2 * tr(Q),
    says="The trace of a rotation applied twice.",
    assuming=(Q_is_a_rotation,),
)

linear_invariants_lie_on_a_sphere = Claim(
    "1.28",
    dot(vect(Q), vect(Q)) + over(1, 4) * (tr(Q) - 1) ** 2, number(1),
    says="Sine and cosine of the angle, as trace and axial vector give them, lie on the unit circle.",
    assuming=(Q_is_a_rotation,),
)

axial_vector_stays = Claim(
    "1.29",
    Q @ vect(Q), vect(Q),
    says="A rotation leaves its axial vector where it is.",
    assuming=(Q_is_a_rotation,),
)

similar_rotation = Claim(
    "1.30",
    R @ Q @ R.T, one + sin(phi) * CPM(R @ e) + (1 - cos(phi)) * CPM(R @ e) ** 2,
    says="A rotation seen from a turned frame has the turned axis and the same angle.",
    given=(rotation_about_axis,),
    assuming=(R_is_a_rotation,),
)

trace_of_similar_rotation = Claim(
    "1.31",
    tr(R @ Q @ R.T), tr(Q),
    says="The trace is the same in all frames.",
    assuming=(R_is_a_rotation,),
)

axial_vector_of_similar_rotation = Claim(
    "1.32",
    vect(R @ Q @ R.T), R @ vect(Q),
    says="The axial vector turns with the frame.",
    assuming=(R_is_a_rotation,),
)

distance_of_rotations = Claim(
    "1.33",
    tr(paren(Q - R).T @ (Q - R)), 2 * (3 - tr(Q.T @ R)),
    says="The distance of two rotations in the Frobenius norm, squared, by the trace of the rotation between them.",
    assuming=(Q_is_a_rotation, R_is_a_rotation),
    kernel=Kernel(of=(Q, R), expected=(Q_is_a_rotation, R_is_a_rotation)),
)

angular_velocity = Definition(
    "1.34",
    omega, vect(rate(Q) @ Q.T),
    says="The angular velocity in the fixed frame: the axial vector of the rate of the rotation, turned back.",
    sign="=",
)

angular_velocity_in_body = Definition(
    "1.34",
    omega_body, vect(Q.T @ rate(Q)),
    part=2,
    says="The angular velocity in the frame of the body.",
    sign="=",
)

rate_of_rotation = Claim(
    "1.35",
    rate(Q), CPM(omega) @ Q,
    says="The rate of a rotation by the angular velocity in the fixed frame.",
    given=(angular_velocity,),
    assuming=(Q_is_a_rotation,),
)

rate_of_rotation_in_body = Claim(
    "1.35",
    rate(Q), Q @ CPM(omega_body),
    part=2,
    says="The rate of a rotation by the angular velocity in the frame of the body.",
    given=(angular_velocity_in_body,),
    assuming=(Q_is_a_rotation,),
)

angular_velocities_in_both_frames = Claim(
    "1.36",
    omega, Q @ omega_body,
    says="The angular velocities in the two frames.",
    given=(angular_velocity, angular_velocity_in_body),
    assuming=(Q_is_a_rotation,),
)

angular_velocity_by_axis_and_angle = Claim(
    "1.37",
    omega, rate(phi) * e + sin(phi) * rate(e) + (1 - cos(phi)) * cross(e, rate(e)),
    says="The angular velocity in the fixed frame by the rates of the axis and the angle.",
    given=(angular_velocity, rotation_about_axis),
    kernel=Kernel(of=(e, phi, rate(e), rate(phi))),
)

angular_velocity_in_body_by_axis_and_angle = Claim(
    "1.38",
    omega_body, rate(phi) * e + sin(phi) * rate(e) - (1 - cos(phi)) * cross(e, rate(e)),
    says="The angular velocity in the frame of the body by the rates of the axis and the angle.",
    given=(angular_velocity_in_body, rotation_about_axis),
    kernel=Kernel(of=(e, phi, rate(e), rate(phi))),
)

derivative_by_angle = Claim(
    "1.39",
    partial(Q, phi), E @ Q,
    says="The derivative of a rotation by its angle.",
    given=(rotation_about_axis,),
)

angle_from_trace = Claim(
    "1.40",
    phi, arccos((tr(Q) - 1) / 2),
    says="The angle of a rotation from its trace, between nothing and half a turn.",
    given=(rotation_about_axis,),
    assuming=(inequality(phi >= 0), inequality(phi <= PI)),
)

angle_from_axial_vector_and_trace = Claim(
    "1.41",
    phi, atan2(dot(e, vect(Q)), (tr(Q) - 1) / 2),
    says="The angle of a rotation whose axis is known, to either side, without loss of digits.",
    given=(rotation_about_axis,),
    assuming=(inequality(phi > -PI), inequality(phi < PI)),
)

trace_is_three_at_most = Claim(
    "1.42",
    *says_that(3 - tr(Q) >= 0),
    says="No rotation has a greater trace than the identity.",
    given=(rotation_about_axis,),
)
