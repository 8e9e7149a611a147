"""Section 8: twists and wrenches, adjoints of motions, the Lie bracket."""

from chasles.rotations.notation import *
from chasles.rotations.s1_rotations import Q_is_a_rotation, angular_velocity, angular_velocity_in_body
from chasles.rotations.s6_motions import another_motion, motion

from chasles.statements import Claim, Definition, Kernel, Section, nonzero
from chasles.vocabulary import CPM, LENGTH, Zero, column, cross, det, dot, inverse, matrix, number, rate, scalar, vector
from chasles.vocabulary.motions import adjoint_of_motion, adjoint_of_twist, inverse_motion, twist_matrix

twists_and_adjoints = Section("8", "Twists and Adjoints")

ad, Ad = adjoint_of_twist, adjoint_of_motion
exchange = matrix((zero_block, one), (one, zero_block))
pitch = scalar("p", "p", "pitch, in metres per radian", LENGTH)
axis_point = vector("c", "c", "position of a point on the axis of a twist", LENGTH)

matrix_of_twist = Claim(
    "8.1",
    twist_matrix(column(omega, velocity)), matrix((CPM(omega), velocity), (zero_row, 0)),
    says="A twist as a 4 x 4 matrix.",
    kernel=Kernel(of=(omega, velocity)),
)

velocity_by_twist = Claim(
    "8.2",
    twist_matrix(column(omega, velocity)) @ column(x, 1), column(cross(omega, x) + velocity, 0),
    says="The velocity of a point by the twist of its body.",
)

cube_of_matrix_of_twist = Claim(
    "8.3",
    twist_matrix(t_a) ** 4, -dot(t_a[1:3], t_a[1:3]) * twist_matrix(t_a) ** 2,
    says="Powers of the matrix of a twist end with the third.",
)

twist_in_fixed_frame = Definition(
    "8.4",
    t_space, column(omega, rate(p_T) - cross(omega, p_T)),
    says="The twist of a body in the fixed frame: its angular velocity, and the velocity of its point at the origin.",
    sign="=",
    kernel=Kernel(of=(omega, p_T, rate(p_T))),
)

twist_in_body_frame = Definition(
    "8.5",
    t_body, column(omega_body, Q.T @ rate(p_T)),
    says="The twist of a body in its own frame.",
    sign="=",
    kernel=Kernel(of=(Q, omega_body, rate(p_T)), expected=(Q_is_a_rotation,)),
)

rate_of_motion_by_twist = Claim(
    "8.6",
    rate(T), twist_matrix(t_space) @ T,
    says="The rate of a motion by the twist in the fixed frame.",
    given=(motion, twist_in_fixed_frame, angular_velocity),
)

rate_of_motion_by_twist_of_body = Claim(
    "8.7",
    rate(T), T @ twist_matrix(t_body),
    says="The rate of a motion by the twist in the frame of the body.",
    given=(motion, twist_in_body_frame, angular_velocity_in_body),
)

adjoint_matrix_of_motion = Claim(
    "8.8",
    Ad(T), matrix((Q, zero_block), (CPM(p_T) @ Q, Q)),
    says="The adjoint of a motion, which carries twists from the moving frame to the fixed one.",
    given=(motion,),
    kernel=Kernel(of=(Q, p_T)),
)

twists_in_both_frames = Claim(
    "8.9",
    t_space, Ad(T) @ t_body,
    says="The adjoint takes the twist in the frame of the body to that in the fixed frame.",
    given=(motion, twist_in_fixed_frame, twist_in_body_frame, angular_velocity, angular_velocity_in_body),
    assuming=(Q_is_a_rotation,),
)

matrix_of_carried_twist = Claim(
    "8.10",
    twist_matrix(Ad(T) @ t_a), T @ twist_matrix(t_a) @ inverse_motion(T),
    says="Carrying a twist over is a similarity of its matrix.",
    given=(motion,),
)

carried_twist = Claim(
    "8.11",
    Ad(T) @ column(omega, velocity), column(Q @ omega, Q @ velocity + cross(p_T, Q @ omega)),
    says="A twist, carried over, part by part.",
    given=(motion,),
    kernel=Kernel(of=(Q, p_T, omega, velocity)),
)

adjoint_of_composition = Claim(
    "8.12",
    Ad(T @ S), Ad(T) @ Ad(S),
    says="Adjoints multiply as motions do.",
    given=(motion, another_motion),
)

adjoint_of_inverse = Claim(
    "8.13",
    inverse(Ad(T)), Ad(inverse_motion(T)),
    says="The inverse of an adjoint is that of the inverse motion.",
    given=(motion,),
)

inverse_adjoint_in_blocks = Claim(
    "8.14",
    Ad(inverse_motion(T)), matrix((Q.T, zero_block), (-Q.T @ CPM(p_T), Q.T)),
    says="The same in blocks.",
    given=(motion,),
    kernel=Kernel(of=(Q, p_T), expected=(Q_is_a_rotation,)),
)

determinant_of_adjoint = Claim(
    "8.15",
    det(Ad(T)), number(1),
    says="The determinant of an adjoint is one.",
    given=(motion,),
)

bracket_of_twists = Claim(
    "8.16",
    ad(column(omega, velocity)) @ column(omega_u, velocity_u),
    column(cross(omega, omega_u), cross(omega, velocity_u) + cross(velocity, omega_u)),
    says="The Lie bracket of two twists.",
    kernel=Kernel(of=(omega, velocity, omega_u, velocity_u)),
)

matrix_of_bracket = Claim(
    "8.17",
    twist_matrix(ad(t_a) @ t_b), twist_matrix(t_a) @ twist_matrix(t_b) - twist_matrix(t_b) @ twist_matrix(t_a),
    says="The matrix of the bracket is the commutator of the matrices.",
)

bracket_with_itself = Claim(
    "8.18",
    ad(t_a) @ t_a, zero_6,
    says="The bracket of a twist with itself vanishes.",
)

bracket_is_skew = Claim(
    "8.19",
    ad(t_a) @ t_b, -ad(t_b) @ t_a,
    says="The bracket changes its sign with the order.",
)

jacobi_identity = Claim(
    "8.20",
    ad(t_a) @ ad(t_b) @ t_c + ad(t_b) @ ad(t_c) @ t_a + ad(t_c) @ ad(t_a) @ t_b, zero_6,
    says="Jacobi's identity.",
)

adjoint_of_bracket = Claim(
    "8.21",
    ad(ad(t_a) @ t_b), ad(t_a) @ ad(t_b) - ad(t_b) @ ad(t_a),
    says="Jacobi's identity as one of matrices.",
)

carried_bracket = Claim(
    "8.22",
    Ad(T) @ (ad(t_a) @ t_b), ad(Ad(T) @ t_a) @ (Ad(T) @ t_b),
    says="A motion carries brackets over with the twists.",
    given=(motion,),
)

adjoint_of_carried_twist = Claim(
    "8.23",
    ad(Ad(T) @ t_a), Ad(T) @ ad(t_a) @ Ad(inverse_motion(T)),
    says="The same as one of matrices.",
    given=(motion,),
)

rate_of_adjoint = Claim(
    "8.24",
    rate(Ad(T)), ad(t_space) @ Ad(T),
    says="The rate of an adjoint by the twist in the fixed frame.",
    given=(motion, twist_in_fixed_frame, angular_velocity),
)

rate_of_adjoint_by_twist_of_body = Claim(
    "8.25",
    rate(Ad(T)), Ad(T) @ ad(t_body),
    says="The rate of an adjoint by the twist in the frame of the body.",
    given=(motion, twist_in_body_frame, angular_velocity_in_body),
)

power_of_wrench = Claim(
    "8.26",
    dot(column(moment, force), column(omega, velocity)), dot(moment, omega) + dot(force, velocity),
    says="The power of a wrench on a moving body.",
    kernel=Kernel(of=(moment, force, omega, velocity)),
)

power_in_both_frames = Claim(
    "8.27",
    dot(Ad(inverse_motion(T)).T @ w_a, Ad(T) @ t_a), dot(w_a, t_a),
    says="Power is the same in all frames if wrenches are carried by the transpose of the inverse.",
    given=(motion,),
)

carried_wrench = Claim(
    "8.28",
    Ad(inverse_motion(T)).T @ column(moment, force), column(Q @ moment + cross(p_T, Q @ force), Q @ force),
    says="A wrench, carried over, part by part.",
    given=(motion,),
    kernel=Kernel(of=(Q, p_T, moment, force)),
)

reciprocal_product_in_both_frames = Claim(
    "8.29",
    (Ad(T) @ t_a).T @ exchange @ (Ad(T) @ t_b), t_a.T @ exchange @ t_b,
    says="The product of the angular part of each twist with the linear part of the other is the same in all frames.",
    given=(motion,),
)

adjoint_and_exchange = Claim(
    "8.30",
    exchange @ Ad(T) @ exchange, Ad(inverse_motion(T)).T,
    says="Wrenches are carried like twists with the parts exchanged.",
    given=(motion,),
)

twist_of_revolute_joint = Claim(
    "8.31",
    twist_matrix(column(rate(phi) * e, cross(axis_point, rate(phi) * e))) @ column(axis_point, 1), Zero(4, 1),
    says="The points of the axis of a turning joint do not move.",
)

twist_of_screw_joint = Claim(
    "8.32",
    twist_matrix(column(rate(phi) * e, cross(axis_point, rate(phi) * e) + pitch * rate(phi) * e))
    @ column(axis_point, 1),
    column(pitch * rate(phi) * e, 0),
    says="The points of the axis of a screw advance by its pitch.",
)

pitch_of_twist = Claim(
    "8.33",
    dot(omega, velocity) / dot(omega, omega),
    dot(Q @ omega, Q @ velocity + cross(p_T, Q @ omega)) / dot(Q @ omega, Q @ omega),
    says="The pitch of a twist is the same in all frames.",
    assuming=(Q_is_a_rotation, nonzero(dot(omega, omega)), nonzero(dot(Q @ omega, Q @ omega))),
)

composed_twists = Claim(
    "8.34",
    rate(T @ S) @ inverse_motion(T @ S), twist_matrix(t_space) + T @ rate(S) @ inverse_motion(S) @ inverse_motion(T),
    says="The twist of what moves in a moving frame: that of the frame, and its own, carried over.",
    given=(motion, another_motion, twist_in_fixed_frame, angular_velocity),
)
