"""Section 5: elementary turns, yaw, pitch and roll, precession, nutation and spin."""

from chasles.rotations.notation import *
from chasles.rotations.s1_rotations import angular_velocity, angular_velocity_in_body

from chasles.statements import Claim, Definition, Kernel, Section, Stack, nonzero
from chasles.statements.inequalities import inequality
from chasles.vocabulary import CPM, PI, column, cos, det, inverse, matrix, rate, row, sin, tan, tr
from chasles.vocabulary.functions import arcsin

euler_angles = Section("5", "Euler Angles")

ca, sa, cb, sb, cg, sg = (f(angle) for angle in (alpha, beta, gamma) for f in (cos, sin))
yaw_pitch_roll = Stack("angles", (alpha, beta, gamma), "yaw, pitch and roll")
no_gimbal_lock = nonzero(cos(beta))

turn_about_x = Claim(
    "5.1",
    about_x(phi), one + sin(phi) * CPM(x_axis) + (1 - cos(phi)) * CPM(x_axis) ** 2,
    says="The turn about the axis x by Rodrigues' formula.",
    kernel=Kernel(of=(phi,)),
)

turn_about_y = Claim(
    "5.1",
    about_y(phi), one + sin(phi) * CPM(y_axis) + (1 - cos(phi)) * CPM(y_axis) ** 2,
    part=2,
    says="The turn about the axis y by Rodrigues' formula.",
    kernel=Kernel(of=(phi,)),
)

turn_about_z = Claim(
    "5.1",
    about_z(phi), one + sin(phi) * CPM(z_axis) + (1 - cos(phi)) * CPM(z_axis) ** 2,
    part=3,
    says="The turn about the axis z by Rodrigues' formula.",
    kernel=Kernel(of=(phi,)),
)

rate_of_turn_about_z = Claim(
    "5.2",
    rate(about_z(phi)), rate(phi) * CPM(z_axis) @ about_z(phi),
    says="The rate of a turn about z.",
)

turns_about_z_add_up = Claim(
    "5.3",
    about_z(phi_1) @ about_z(phi_2), about_z(phi_1 + phi_2),
    says="Turns about one axis add up.",
)

third_axis_by_quarter_turns = Claim(
    "5.4",
    about_x(PI / 2) @ about_y(PI / 2) @ about_x(-PI / 2), about_z(PI / 2),
    says="Two axes are enough: a quarter-turn about x turns the axis y into z.",
)

rotation_from_yaw_pitch_roll = Definition(
    "5.5",
    Q, about_z(alpha) @ about_y(beta) @ about_x(gamma),
    says="The rotation by yaw, pitch and roll: about z, then about the new y, then about the newest x.",
    sign="=",
    kernel=Kernel(of=(yaw_pitch_roll,)),
)

entries_by_yaw_pitch_roll = Claim(
    "5.6",
    Q,
    matrix(
        (ca * cb, ca * sb * sg - sa * cg, ca * sb * cg + sa * sg),
        (sa * cb, sa * sb * sg + ca * cg, sa * sb * cg - ca * sg),
        (-sb, cb * sg, cb * cg),
    ),
    says="The same, entry by entry.",
    given=(rotation_from_yaw_pitch_roll,),
)

sine_of_pitch = Claim(
    "5.7",
    sb, -Q[3, 1],
    says="The pitch from the rotation: its sine.",
    given=(rotation_from_yaw_pitch_roll,),
)

cosine_of_pitch = Claim(
    "5.8",
    cb**2, Q[1, 1] ** 2 + Q[2, 1] ** 2,
    says="The pitch from the rotation: the square of its cosine.",
    given=(rotation_from_yaw_pitch_roll,),
)

tangent_of_yaw = Claim(
    "5.9",
    sa * Q[1, 1], ca * Q[2, 1],
    says="The yaw from the rotation: its tangent is a ratio of two entries.",
    given=(rotation_from_yaw_pitch_roll,),
)

tangent_of_roll = Claim(
    "5.10",
    sg * Q[3, 3], cg * Q[3, 2],
    says="The roll from the rotation: its tangent is a ratio of two entries.",
    given=(rotation_from_yaw_pitch_roll,),
)

second_yaw_pitch_roll = Claim(
    "5.11",
    about_z(alpha + PI) @ about_y(PI - beta) @ about_x(gamma + PI), about_z(alpha) @ about_y(beta) @ about_x(gamma),
    says="Each rotation has two sets of yaw, pitch and roll.",
)

gimbal_lock_up = Claim(
    "5.12",
    about_z(alpha) @ about_y(PI / 2) @ about_x(gamma), about_z(alpha - gamma) @ about_y(PI / 2),
    says="At a pitch of a quarter-turn only the difference of yaw and roll counts.",
)

gimbal_lock_down = Claim(
    "5.12",
    about_z(alpha) @ about_y(-PI / 2) @ about_x(gamma), about_z(alpha + gamma) @ about_y(-PI / 2),
    part=2,
    says="At the opposite pitch only their sum counts.",
)

trace_by_yaw_pitch_roll = Claim(
    "5.13",
    tr(Q), ca * cb + ca * cg + cb * cg + sa * sb * sg,
    says="The trace by yaw, pitch and roll.",
    given=(rotation_from_yaw_pitch_roll,),
)

quaternion_from_yaw_pitch_roll = Definition(
    "5.14",
    q,
    times(
        times(column(sin(alpha / 2) * z_axis, cos(alpha / 2)), column(sin(beta / 2) * y_axis, cos(beta / 2))),
        column(sin(gamma / 2) * x_axis, cos(gamma / 2)),
    ),
    says="The quaternion of yaw, pitch and roll: the product of three.",
    sign="=",
    kernel=Kernel(of=(yaw_pitch_roll,)),
)

components_of_quaternion_from_yaw_pitch_roll = Claim(
    "5.15",
    q,
    column(
        cos(alpha / 2) * cos(beta / 2) * sin(gamma / 2) - sin(alpha / 2) * sin(beta / 2) * cos(gamma / 2),
        cos(alpha / 2) * sin(beta / 2) * cos(gamma / 2) + sin(alpha / 2) * cos(beta / 2) * sin(gamma / 2),
        sin(alpha / 2) * cos(beta / 2) * cos(gamma / 2) - cos(alpha / 2) * sin(beta / 2) * sin(gamma / 2),
        cos(alpha / 2) * cos(beta / 2) * cos(gamma / 2) + sin(alpha / 2) * sin(beta / 2) * sin(gamma / 2),
    ),
    says="Its components.",
    given=(quaternion_from_yaw_pitch_roll,),
)

quaternion_gives_yaw_pitch_roll = Claim(
    "5.16",
    rotation_by(q), about_z(alpha) @ about_y(beta) @ about_x(gamma),
    says="The quaternion gives the same rotation.",
    given=(quaternion_from_yaw_pitch_roll,),
)

rates_of_yaw_pitch_roll = Definition(
    "5.17",
    angle_rates, column(rate(alpha), rate(beta), rate(gamma)),
    says="The rates of yaw, pitch and roll.",
    sign="=",
)

rate_matrix = Definition(
    "5.18",
    W, matrix((0, -sa, ca * cb), (0, ca, sa * cb), (1, 0, -sb)),
    says="Its columns are the axes of the three turns, as the turns before have left them.",
    sign="=",
    kernel=Kernel(of=(yaw_pitch_roll,)),
)

columns_of_rate_matrix = Claim(
    "5.19",
    W, row(z_axis, about_z(alpha) @ y_axis, about_z(alpha) @ about_y(beta) @ x_axis),
    says="The axes of the three turns.",
    given=(rate_matrix,),
)

rate_matrix_in_body = Definition(
    "5.20",
    W_body, matrix((-sb, 0, 1), (cb * sg, cg, 0), (cb * cg, -sg, 0)),
    says="The same axes as the body sees them.",
    sign="=",
    kernel=Kernel(of=(yaw_pitch_roll,)),
)

rate_matrices_in_both_frames = Claim(
    "5.21",
    W, Q @ W_body,
    says="The two matrices differ by the rotation.",
    given=(rate_matrix, rate_matrix_in_body, rotation_from_yaw_pitch_roll),
)

angular_velocity_by_yaw_pitch_roll = Claim(
    "5.22",
    omega, W @ angle_rates,
    says="The angular velocity in the fixed frame from the rates of yaw, pitch and roll.",
    given=(angular_velocity, rotation_from_yaw_pitch_roll, rate_matrix, rates_of_yaw_pitch_roll),
)

angular_velocity_in_body_by_yaw_pitch_roll = Claim(
    "5.23",
    omega_body, W_body @ angle_rates,
    says="The angular velocity in the frame of the body from those rates.",
    given=(angular_velocity_in_body, rotation_from_yaw_pitch_roll, rate_matrix_in_body, rates_of_yaw_pitch_roll),
)

determinant_of_rate_matrix = Claim(
    "5.24",
    det(W), -cb,
    says="The rates cannot be found where the first and the last axis are parallel.",
    given=(rate_matrix,),
)

inverse_of_rate_matrix = Claim(
    "5.25",
    inverse(W), matrix((ca * tan(beta), sa * tan(beta), 1), (-sa, ca, 0), (ca / cb, sa / cb, 0)),
    says="Yaw, pitch and roll rates from the angular velocity in the fixed frame.",
    given=(rate_matrix,),
    assuming=(no_gimbal_lock,),
)

inverse_of_rate_matrix_in_body = Claim(
    "5.26",
    inverse(W_body), matrix((0, sg / cb, cg / cb), (0, cg, -sg), (1, sg * tan(beta), cg * tan(beta))),
    says="Yaw, pitch and roll rates from the angular velocity in the frame of the body.",
    given=(rate_matrix_in_body,),
    assuming=(no_gimbal_lock,),
    kernel=Kernel(of=(beta, gamma)),
)

length_of_angular_velocity = Claim(
    "5.27",
    W.T @ W, matrix((1, 0, -sb), (0, 1, 0), (-sb, 0, 1)),
    says="Only the first and the last axis are not always at right angles.",
    given=(rate_matrix,),
)

rotation_from_precession_nutation_spin = Definition(
    "5.28",
    Q, about_z(psi) @ about_x(theta) @ about_z(chi),
    says="The rotation by Euler's angles: precession, nutation and spin.",
    sign="=",
    kernel=Kernel(of=(Stack("angles", (psi, theta, chi), "precession, nutation and spin"),)),
)

entries_by_precession_nutation_spin = Claim(
    "5.29",
    Q,
    matrix(
        (
            cos(psi) * cos(chi) - sin(psi) * cos(theta) * sin(chi),
            -cos(psi) * sin(chi) - sin(psi) * cos(theta) * cos(chi),
            sin(psi) * sin(theta),
        ),
        (
            sin(psi) * cos(chi) + cos(psi) * cos(theta) * sin(chi),
            -sin(psi) * sin(chi) + cos(psi) * cos(theta) * cos(chi),
            -cos(psi) * sin(theta),
        ),
        (sin(theta) * sin(chi), sin(theta) * cos(chi), cos(theta)),
    ),
    says="The same, entry by entry.",
    given=(rotation_from_precession_nutation_spin,),
)

figure_axis = Claim(
    "5.30",
    Q @ z_axis, column(sin(psi) * sin(theta), -cos(psi) * sin(theta), cos(theta)),
    says="Where the axis of the body points: spin does not move it.",
    given=(rotation_from_precession_nutation_spin,),
)

trace_by_precession_nutation_spin = Claim(
    "5.31",
    1 + tr(Q), (1 + cos(theta)) * (1 + cos(psi + chi)),
    says="The trace by Euler's angles.",
    given=(rotation_from_precession_nutation_spin,),
)

angular_velocity_in_body_by_precession_nutation_spin = Claim(
    "5.32",
    omega_body,
    column(
        rate(psi) * sin(theta) * sin(chi) + rate(theta) * cos(chi),
        rate(psi) * sin(theta) * cos(chi) - rate(theta) * sin(chi),
        rate(psi) * cos(theta) + rate(chi),
    ),
    says="Euler's kinematic equations.",
    given=(angular_velocity_in_body, rotation_from_precession_nutation_spin),
)

angular_velocity_by_precession_nutation_spin = Claim(
    "5.33",
    omega,
    column(
        rate(theta) * cos(psi) + rate(chi) * sin(theta) * sin(psi),
        rate(theta) * sin(psi) - rate(chi) * sin(theta) * cos(psi),
        rate(psi) + rate(chi) * cos(theta),
    ),
    says="The same in the fixed frame.",
    given=(angular_velocity, rotation_from_precession_nutation_spin),
)

half_angles_of_precession_nutation_spin = Claim(
    "5.34",
    times(
        times(column(sin(psi / 2) * z_axis, cos(psi / 2)), column(sin(theta / 2) * x_axis, cos(theta / 2))),
        column(sin(chi / 2) * z_axis, cos(chi / 2)),
    ),
    column(
        sin(theta / 2) * cos((psi - chi) / 2),
        sin(theta / 2) * sin((psi - chi) / 2),
        cos(theta / 2) * sin((psi + chi) / 2),
        cos(theta / 2) * cos((psi + chi) / 2),
    ),
    says="Euler's parameters by Euler's angles: half the sum and half the difference of precession and spin.",
)

pitch_from_rotation = Claim(
    "5.35",
    beta, arcsin(-Q[3, 1]),
    says="The pitch from the rotation, a quarter-turn up or down at most.",
    given=(rotation_from_yaw_pitch_roll,),
    assuming=(inequality(beta >= -PI / 2), inequality(beta <= PI / 2)),
)
