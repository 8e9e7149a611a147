"""Section 10: serial arms: where the end is, how fast it moves, what the joints carry."""

from chasles.rotations.notation import *

from chasles.statements import Claim, Definition, Kernel, Section, Stack, nonzero, positive
from chasles.statements.inequalities import says_that
from chasles.vocabulary import (
    PI,
    Node,
    column,
    cos,
    cross,
    det,
    dot,
    inverse,
    matrix,
    over,
    paren,
    rate,
    row,
    sin,
)
from chasles.vocabulary.motions import homogeneous
from chasles.vocabulary.partial import partial

serial_arms = Section("10", "Serial Arms")

c_1, s_1, c_2, s_2, c_3, s_3 = (f(angle) for angle in (theta_1, theta_2, theta_3) for f in (cos, sin))
c_12, s_12 = cos(theta_1 + theta_2), sin(theta_1 + theta_2)
c_23, s_23 = cos(theta_2 + theta_3), sin(theta_2 + theta_3)
c_123, s_123 = cos(theta_1 + theta_2 + theta_3), sin(theta_1 + theta_2 + theta_3)
joint_rates_2 = column(rate(theta_1), rate(theta_2))
joint_rates_3 = column(rate(theta_1), rate(theta_2), rate(theta_3))

_both = paren(rate(theta_1) + rate(theta_2))
_joints = ((e_1, r_1), (e_2, r_2), (e_3, r_3))
_jacobian = row(*(column(axis, cross(axis, arm)) for axis, arm in _joints))
_torques = column(*(dot(axis, moment + cross(arm, force)) for axis, arm in _joints))


def _link(angle: Node, length: Node) -> Node:
    """A turn about z, and then a link along the new x."""
    return turned(about_z(angle)) @ along(length * x_axis)


# The planar arm with two joints

end_of_planar_arm = Definition(
    "10.1",
    p_2R, column(a_1 * c_1 + a_2 * c_12, a_1 * s_1 + a_2 * s_12),
    says="The end of a planar arm with two joints.",
    sign="=",
    kernel=Kernel(of=(a_1, a_2, theta_1, theta_2)),
)

end_of_planar_arm_by_frames = Claim(
    "10.2",
    _link(theta_1, a_1) @ _link(theta_2, a_2),
    homogeneous(about_z(theta_1 + theta_2), column(p_2R, 0)),
    says="The same by the frames of its links.",
    given=(end_of_planar_arm,),
)

jacobian_of_planar_arm = Definition(
    "10.3",
    J_2R, matrix((-a_1 * s_1 - a_2 * s_12, -a_2 * s_12), (a_1 * c_1 + a_2 * c_12, a_2 * c_12)),
    says="Its Jacobian.",
    sign="=",
    kernel=Kernel(of=(a_1, a_2, theta_1, theta_2)),
)

velocity_of_planar_arm = Claim(
    "10.4",
    rate(p_2R), J_2R @ joint_rates_2,
    says="The velocity of the end from the rates of the joints.",
    given=(end_of_planar_arm, jacobian_of_planar_arm),
    kernel=Kernel(of=(a_1, a_2, theta_1, theta_2, rate(theta_1), rate(theta_2))),
)

determinant_of_jacobian_of_planar_arm = Claim(
    "10.5",
    det(J_2R), a_1 * a_2 * s_2,
    says="It is singular where the arm is stretched or folded.",
    given=(jacobian_of_planar_arm,),
)

inverse_of_jacobian_of_planar_arm = Claim(
    "10.6",
    inverse(J_2R),
    over(1, a_1 * a_2 * s_2)
    * matrix((a_2 * c_12, a_2 * s_12), (-a_1 * c_1 - a_2 * c_12, -a_1 * s_1 - a_2 * s_12)),
    says="The rates of the joints from the velocity of the end, elsewhere.",
    given=(jacobian_of_planar_arm,),
    assuming=(positive(a_1), positive(a_2), nonzero(s_2)),
    kernel=Kernel(of=(a_1, a_2, theta_1, theta_2)),
)

reach_of_planar_arm = Claim(
    "10.7",
    dot(p_2R, p_2R), a_1**2 + a_2**2 + 2 * a_1 * a_2 * c_2,
    says="How far the arm reaches depends on its elbow alone.",
    given=(end_of_planar_arm,),
)

cosine_of_elbow = Claim(
    "10.8",
    c_2, (dot(p_2R, p_2R) - a_1**2 - a_2**2) / (2 * a_1 * a_2),
    says="The angle of the elbow from where the end is: its cosine.",
    given=(end_of_planar_arm,),
    assuming=(positive(a_1), positive(a_2)),
)

cosine_of_shoulder = Claim(
    "10.9",
    dot(p_2R, p_2R) * c_1, (a_1 + a_2 * c_2) * p_2R[1] + a_2 * s_2 * p_2R[2],
    says="The angle of the shoulder, once that of the elbow is known: its cosine.",
    given=(end_of_planar_arm,),
)

sine_of_shoulder = Claim(
    "10.9",
    dot(p_2R, p_2R) * s_1, (a_1 + a_2 * c_2) * p_2R[2] - a_2 * s_2 * p_2R[1],
    part=2,
    says="And its sine.",
    given=(end_of_planar_arm,),
)

other_elbow = Claim(
    "10.10",
    dot(p_2R, p_2R),
    a_1**2 + a_2**2 + 2 * a_1 * a_2 * cos(-theta_2),
    says="The elbow may be on either side.",
    given=(end_of_planar_arm,),
)

acceleration_of_planar_arm = Claim(
    "10.11",
    rate(rate(p_2R)), J_2R @ column(rate(rate(theta_1)), rate(rate(theta_2))) + rate(J_2R) @ joint_rates_2,
    says="The acceleration of the end.",
    given=(end_of_planar_arm, jacobian_of_planar_arm),
)

rate_of_jacobian_of_planar_arm = Claim(
    "10.12",
    rate(J_2R),
    -matrix(
        (a_1 * c_1 * rate(theta_1) + a_2 * c_12 * _both, a_2 * c_12 * _both),
        (a_1 * s_1 * rate(theta_1) + a_2 * s_12 * _both, a_2 * s_12 * _both),
    ),
    says="The rate of the Jacobian.",
    given=(jacobian_of_planar_arm,),
)

manipulability_of_planar_arm = Claim(
    "10.13",
    det(J_2R @ J_2R.T), (a_1 * a_2 * s_2) ** 2,
    says="The square of its manipulability.",
    given=(jacobian_of_planar_arm,),
)

torques_of_planar_arm = Claim(
    "10.14",
    J_2R.T @ column(f_x, f_y),
    column(p_2R[1] * f_y - p_2R[2] * f_x, a_2 * (c_12 * f_y - s_12 * f_x)),
    says="What the joints carry of a force at the end: its moments about them.",
    given=(end_of_planar_arm, jacobian_of_planar_arm),
    kernel=Kernel(of=(a_1, a_2, theta_1, theta_2, f_x, f_y)),
)

# The planar arm with three joints

end_of_planar_arm_with_three_joints = Definition(
    "10.15",
    p_3R,
    column(a_1 * c_1 + a_2 * c_12 + a_3 * c_123, a_1 * s_1 + a_2 * s_12 + a_3 * s_123, theta_1 + theta_2 + theta_3),
    says="The end of a planar arm with three joints, and which way it points.",
    sign="=",
    kernel=Kernel(of=(a_1, a_2, a_3, theta_1, theta_2, theta_3)),
)

velocity_of_planar_arm_with_three_joints = Claim(
    "10.16",
    rate(p_3R),
    matrix(
        (-a_1 * s_1 - a_2 * s_12 - a_3 * s_123, -a_2 * s_12 - a_3 * s_123, -a_3 * s_123),
        (a_1 * c_1 + a_2 * c_12 + a_3 * c_123, a_2 * c_12 + a_3 * c_123, a_3 * c_123),
        (1, 1, 1),
    )
    @ joint_rates_3,
    says="Its velocity, and the rate at which it turns.",
    given=(end_of_planar_arm_with_three_joints,),
    kernel=Kernel(of=(a_1, a_2, a_3, theta_1, theta_2, theta_3, rate(theta_1), rate(theta_2), rate(theta_3))),
)

determinant_of_jacobian_with_three_joints = Claim(
    "10.17",
    det(
        matrix(
            (-a_1 * s_1 - a_2 * s_12 - a_3 * s_123, -a_2 * s_12 - a_3 * s_123, -a_3 * s_123),
            (a_1 * c_1 + a_2 * c_12 + a_3 * c_123, a_2 * c_12 + a_3 * c_123, a_3 * c_123),
            (1, 1, 1),
        )
    ),
    a_1 * a_2 * s_2,
    says="The third joint makes it no less singular.",
)

# The arm with a shoulder and an elbow in space

end_of_shoulder_arm = Definition(
    "10.18",
    p_RRR,
    column((a_2 * c_2 + a_3 * c_23) * c_1, (a_2 * c_2 + a_3 * c_23) * s_1, h_1 + a_2 * s_2 + a_3 * s_23),
    says="The end of an arm with a waist, a shoulder and an elbow.",
    sign="=",
    kernel=Kernel(of=(h_1, a_2, a_3, theta_1, theta_2, theta_3)),
)

end_of_shoulder_arm_by_frames = Claim(
    "10.19",
    turned(about_z(theta_1))
    @ along(h_1 * z_axis)
    @ turned(about_x(PI / 2))
    @ _link(theta_2, a_2)
    @ _link(theta_3, a_3)
    @ column(zero, 1),
    column(p_RRR, 1),
    says="The same by Denavit-Hartenberg frames.",
    given=(end_of_shoulder_arm,),
)

jacobian_of_shoulder_arm = Definition(
    "10.20",
    J_RRR,
    matrix(
        (-s_1 * (a_2 * c_2 + a_3 * c_23), -c_1 * (a_2 * s_2 + a_3 * s_23), -a_3 * c_1 * s_23),
        (c_1 * (a_2 * c_2 + a_3 * c_23), -s_1 * (a_2 * s_2 + a_3 * s_23), -a_3 * s_1 * s_23),
        (0, a_2 * c_2 + a_3 * c_23, a_3 * c_23),
    ),
    says="Its Jacobian.",
    sign="=",
    kernel=Kernel(of=(a_2, a_3, theta_1, theta_2, theta_3)),
)

velocity_of_shoulder_arm = Claim(
    "10.21",
    rate(p_RRR), J_RRR @ joint_rates_3,
    says="The velocity of its end.",
    given=(end_of_shoulder_arm, jacobian_of_shoulder_arm),
)

determinant_of_jacobian_of_shoulder_arm = Claim(
    "10.22",
    det(J_RRR), -a_2 * a_3 * s_3 * (a_2 * c_2 + a_3 * c_23),
    says="It is singular where the elbow is stretched or folded, and where the end is above the waist.",
    given=(jacobian_of_shoulder_arm,),
)

reach_of_shoulder_arm = Claim(
    "10.23",
    dot(p_RRR - h_1 * z_axis, p_RRR - h_1 * z_axis), a_2**2 + a_3**2 + 2 * a_2 * a_3 * c_3,
    says="How far it reaches from the shoulder depends on the elbow alone.",
    given=(end_of_shoulder_arm,),
)

waist_from_end = Claim(
    "10.24",
    s_1 * p_RRR[1], c_1 * p_RRR[2],
    says="The waist faces the end, or turns its back on it.",
    given=(end_of_shoulder_arm,),
)

columns_of_jacobian_of_shoulder_arm = Claim(
    "10.25",
    J_RRR,
    row(
        cross(z_axis, p_RRR),
        cross(column(s_1, -c_1, 0), p_RRR - h_1 * z_axis),
        cross(column(s_1, -c_1, 0), p_RRR - h_1 * z_axis - a_2 * column(c_2 * c_1, c_2 * s_1, s_2)),
    ),
    says="Each column is the vector product of the axis of a joint and the vector from it to the end.",
    given=(end_of_shoulder_arm, jacobian_of_shoulder_arm),
)

# The selectively compliant arm

end_of_selective_arm = Claim(
    "10.26",
    _link(theta_1, a_1) @ _link(theta_2, a_2) @ along(-b_3 * z_axis) @ turned(about_z(theta_4)),
    homogeneous(
        about_z(theta_1 + theta_2 + theta_4), column(a_1 * c_1 + a_2 * c_12, a_1 * s_1 + a_2 * s_12, -b_3)
    ),
    says="An arm with three parallel axes and a stroke along them: it keeps its end upright.",
    kernel=Kernel(of=(a_1, a_2, b_3, theta_1, theta_2, theta_4)),
)

determinant_of_selective_arm = Claim(
    "10.27",
    det(
        matrix(
            (-a_1 * s_1 - a_2 * s_12, -a_2 * s_12, 0, 0),
            (a_1 * c_1 + a_2 * c_12, a_2 * c_12, 0, 0),
            (0, 0, -1, 0),
            (1, 1, 0, 1),
        )
    ),
    -a_1 * a_2 * s_2,
    says="It is singular where its planar part is.",
)

# The spherical wrist

orientation_of_wrist = Definition(
    "10.28",
    Q, about_z(psi) @ about_y(theta) @ about_z(chi),
    says="The orientation of a spherical wrist, whose three axes meet.",
    sign="=",
    kernel=Kernel(of=(Stack("angles", (psi, theta, chi), "angles of the joints of the wrist"),)),
)

axes_of_wrist = Claim(
    "10.29",
    det(row(z_axis, about_z(psi) @ y_axis, about_z(psi) @ about_y(theta) @ z_axis)), -sin(theta),
    says="The wrist is singular where its first and its last axis fall together.",
)

other_configuration_of_wrist = Claim(
    "10.30",
    about_z(psi + PI) @ about_y(-theta) @ about_z(chi + PI), about_z(psi) @ about_y(theta) @ about_z(chi),
    says="A wrist reaches each orientation in two ways.",
)

middle_angle_of_wrist = Claim(
    "10.31",
    Q[1, 3] ** 2 + Q[2, 3] ** 2, sin(theta) ** 2,
    says="The middle angle from the orientation.",
    given=(orientation_of_wrist,),
)

# Any arm with three turning joints

angular_velocity_of_hand = Definition(
    "10.32",
    omega, rate(theta_1) * e_1 + rate(theta_2) * e_2 + rate(theta_3) * e_3,
    says="The angular velocity of the hand: the axes, each times the rate of its joint.",
    sign="=",
)

velocity_of_hand = Definition(
    "10.33",
    velocity,
    rate(theta_1) * cross(e_1, r_1) + rate(theta_2) * cross(e_2, r_2) + rate(theta_3) * cross(e_3, r_3),
    says="The velocity of its end.",
    sign="=",
)

twist_of_hand = Claim(
    "10.34",
    column(omega, velocity), _jacobian @ joint_rates_3,
    says="The Jacobian of an arm: its columns are the twists of the joints.",
    given=(angular_velocity_of_hand, velocity_of_hand),
    kernel=Kernel(of=(e_1, e_2, e_3, r_1, r_2, r_3, rate(theta_1), rate(theta_2), rate(theta_3))),
)

power_at_joints = Claim(
    "10.35",
    dot(moment, omega) + dot(force, velocity),
    dot(_torques, joint_rates_3),
    says="What the joints carry of a wrench: its moments about their axes.",
    given=(angular_velocity_of_hand, velocity_of_hand),
)

torques_at_joints = Claim(
    "10.36",
    _jacobian.T @ column(moment, force),
    _torques,
    says="The transpose of the Jacobian gives the torques of the joints.",
    kernel=Kernel(of=(e_1, e_2, e_3, r_1, r_2, r_3, moment, force)),
)

determinant_of_positioning_jacobian = Claim(
    "10.37",
    det(row(cross(e_1, r_1), cross(e_2, r_2), cross(e_3, r_3))),
    dot(cross(e_1, r_1), cross(cross(e_2, r_2), cross(e_3, r_3))),
    says="A positioning arm is singular where the velocities that its joints give lie in a plane.",
)

jacobian_of_planar_arm_by_derivatives = Claim(
    "10.38",
    row(partial(p_2R, theta_1), partial(p_2R, theta_2)), J_2R,
    says="The columns of a Jacobian are derivatives by the angles of the joints.",
    given=(end_of_planar_arm, jacobian_of_planar_arm),
)

jacobian_of_shoulder_arm_by_derivatives = Claim(
    "10.39",
    row(partial(p_RRR, theta_1), partial(p_RRR, theta_2), partial(p_RRR, theta_3)), J_RRR,
    says="The same for the arm with waist, shoulder and elbow.",
    given=(end_of_shoulder_arm, jacobian_of_shoulder_arm),
)

manipulability_is_not_negative = Claim(
    "10.40",
    *says_that(det(J_2R @ J_2R.T) >= 0),
    says="So the manipulability is a real number.",
    given=(jacobian_of_planar_arm,),
)
