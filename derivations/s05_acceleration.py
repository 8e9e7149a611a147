"""Section 3.5: acceleration analysis of rigid-body motions."""

from chasles.derivations.notation import *
from chasles.derivations.s02_screw import (
    euler_rodrigues_scalar,
    euler_rodrigues_vector,
    linear_scalar,
    linear_vector,
    natural_scalar,
    natural_vector,
    phi_is_not_zero,
    pose,
    rotation_from_axis_angle,
)
from chasles.derivations.s03_fixed_point import (
    angular_velocity,
    angular_velocity_matrix,
    angular_velocity_matrix_of_vector,
)
from chasles.derivations.s04_twist import (
    F_is_euler_rodrigues,
    F_is_linear,
    F_is_natural,
    F_tilde_is_euler_rodrigues,
    F_tilde_is_linear,
    F_tilde_is_natural,
    euler_rodrigues_array,
    euler_rodrigues_rate_matrix,
    euler_rodrigues_velocity_matrix,
    linear_invariants_array,
    linear_rate_matrix,
    linear_velocity_matrix,
    natural_rate_matrix,
    natural_velocity_matrix,
    phi_is_not_pi,
    pose_rate_matrix,
    twist,
    twist_matrix,
    velocity_by_angular_velocity_matrix,
    velocity_of_landmark,
    velocity_of_point,
)

from chasles.statements import Claim, Definition, Kernel, Section, unit
from chasles.vocabulary import (
    CPM,
    Node,
    bracket,
    column,
    cos,
    cot,
    cross,
    dot,
    matrix,
    norm,
    number,
    over,
    paren,
    printed,
    rate,
    replace,
    row,
    sin,
    tr,
    vect,
)

acceleration_analysis = Section("3.5", "Acceleration Analysis of Rigid-Body Motions")

acceleration_by_differentiation = Claim(
    "3.84",
    rate(rate(p)), rate(rate(a)) + rate(Omega) @ (p - a) + Omega @ (rate(p) - rate(a)),
    says="The acceleration of a point, by differentiating its velocity.",
    given=(velocity_by_angular_velocity_matrix,),
)

acceleration_by_matrices = Claim(
    "3.85",
    rate(rate(p)), rate(rate(a)) + (rate(Omega) + Omega**2) @ (p - a),
    says="The acceleration of a point from that of the landmark.",
    given=(velocity_by_angular_velocity_matrix,),
)

angular_acceleration_matrix = Definition(
    "3.86",
    W_acc, rate(Omega) + Omega**2,
    says="The angular-acceleration matrix.",
    given=(angular_velocity_matrix_of_vector,),
    kernel=Kernel(of=(omega, rate(omega))),
)

axial_vector_of_acceleration_matrix = Claim(
    "3.87",
    vect(W_acc), vect(rate(Omega)),
    says="The axial vector of the angular-acceleration matrix is that of its first term.",
    given=(angular_acceleration_matrix, angular_velocity_matrix_of_vector),
)

angular_acceleration = Claim(
    "3.87",
    vect(rate(Omega)), rate(omega),
    part=2,
    says="The axial vector of the angular-acceleration matrix is the angular acceleration.",
    given=(angular_velocity_matrix_of_vector,),
)

trace_of_acceleration_matrix = Claim(
    "3.88",
    tr(W_acc), tr(Omega**2),
    says="The trace of the angular-acceleration matrix is that of its second term.",
    given=(angular_acceleration_matrix, angular_velocity_matrix_of_vector),
)

trace_of_square = Claim(
    "3.88",
    tr(Omega**2), tr(-(norm(omega) ** 2) * one + omega @ omega.T),
    part=2,
    says="The trace of the square of the angular-velocity matrix, expanded.",
    given=(angular_velocity_matrix_of_vector,),
)

trace_by_terms = Claim(
    "3.88",
    tr(-(norm(omega) ** 2) * one + omega @ omega.T), -(norm(omega) ** 2) * tr(one) + dot(omega, omega),
    part=3,
    says="The trace of a sum is the sum of the traces.",
)

trace_in_closed_form = Claim(
    "3.88",
    -(norm(omega) ** 2) * tr(one) + dot(omega, omega), -(2 * norm(omega) ** 2),
    part=4,
    says="The trace of the angular-acceleration matrix is minus twice the square of the angular speed.",
)

acceleration_of_point = Claim(
    "3.89",
    rate(rate(p)), rate(rate(a)) + cross(rate(omega), p - a) + cross(omega, bracket(cross(omega, p - a))),
    says="The acceleration of a point from that of the landmark, with vector products.",
    given=(velocity_of_point,),
    kernel=Kernel(of=(omega, rate(omega), rate(rate(a)), a, p)),
)

twist_rate = Claim(
    "3.90",
    rate(t), column(rate(omega), rate(v)),
    says="The twist rate.",
    given=(twist,),
    sign=r"\equiv",
)

pose_rate_by_twist = Definition(
    "text 3.5 a",
    rate(s), T @ t,
    says="The rate of the pose is linear in the twist, whatever the invariants chosen.",
)

twist_by_pose_rate = Definition(
    "text 3.5 b",
    t, S @ rate(s),
    says="The twist is linear in the rate of the pose.",
)

second_rate_of_pose = Claim(
    "3.91",
    rate(rate(s)), T @ rate(t) + rate(T) @ t,
    says="The second rate of the pose.",
    given=(pose_rate_by_twist,),
)

rate_of_pose_rate_matrix = Claim(
    "3.92",
    rate(T), matrix((rate(F), O_43), (O, O)),
    says="The rate of the matrix of the pose's rate.",
    given=(pose_rate_matrix,),
    sign=r"\equiv",
)

twist_rate_from_pose = Claim(
    "3.93",
    rate(t), S @ rate(rate(s)) + rate(S) @ rate(s),
    says="The twist rate from the rates of the pose.",
    given=(twist_by_pose_rate,),
)

rate_of_twist_matrix = Claim(
    "3.94",
    rate(S), printed(lambda: matrix((rate(F), O), (O_34, O))),
    reading=matrix((rate(F_tilde), O), (O_34, O)),
    says="The rate of the matrix of the twist.",
    given=(twist_matrix,),
)

linear_invariants_vector = Definition("3.95b", u, sin(phi) * e, says="The vector of the linear invariants.")

linear_invariants_scalar = Definition("3.95b", u_0, cos(phi), part=2, says="The scalar of the linear invariants.")

euler_rodrigues_parameters_vector = Definition(
    "3.95b", r_er, sin(phi / 2) * e, part=3, says="The vector of the Euler-Rodrigues parameters."
)

euler_rodrigues_parameters_scalar = Definition(
    "3.95b", r_0, cos(phi / 2), part=4, says="The scalar of the Euler-Rodrigues parameters."
)

linear_invariants_named = Claim(
    "3.95a",
    lambda_, column(u, u_0),
    says="The linear invariants by their parts.",
    given=(linear_invariants_array, linear_invariants_vector, linear_invariants_scalar),
    sign=r"\equiv",
)

euler_rodrigues_named = Claim(
    "3.95a",
    eta, column(r_er, r_0),
    part=2,
    says="The Euler-Rodrigues parameters by their parts.",
    given=(euler_rodrigues_array, euler_rodrigues_parameters_vector, euler_rodrigues_parameters_scalar),
    sign=r"\equiv",
)

axis_angle_rates = (rotation_from_axis_angle, angular_velocity_matrix, angular_velocity)

upper_block_of_natural_rates = Definition(
    "text 3.5 c",
    N_upper, bracket(over(sin(phi), paren(2 * (1 - cos(phi))))) * paren(one - e @ e.T) - paren(over(1, 2)) * E,
    says="The upper block of N, the matrix of the natural invariants' rates.",
    assuming=(unit(e), phi_is_not_zero),
)

natural_rates_by_blocks = Definition(
    "text 3.5 c",
    N, column(N_upper, e.T),
    part=2,
    says="The matrix of the natural invariants' rates, N, by its blocks.",
)

B_is_the_upper_block = Definition(
    "text 3.5 d",
    B_N, 4 * (1 - cos(phi)) * rate(N_upper),
    says="What B must be for the upper block of the rate of N in (3.96a) to hold.",
)

rate_of_natural_rate_matrix = Claim(
    "3.96a",
    rate(N), printed(lambda: 1 / (4 * (1 - cos(phi))) * column(B_N, rate(e))),
    reading=1 / (4 * (1 - cos(phi))) * column(B_N, rate(e).T),
    says="The rate of N, the matrix of the natural invariants' rates, by its blocks.",
    given=(natural_rates_by_blocks, upper_block_of_natural_rates, B_is_the_upper_block),
    assuming=(phi_is_not_zero,),
)

rate_of_linear_rate_matrix = Claim(
    "3.96b",
    rate(L),
    column(
        paren(over(1, 2)) * bracket(one * tr(rate(Q)) - rate(Q)),
        -(paren(over(1, 2)) * omega.T @ bracket(one * tr(Q) - Q.T)),
    ),
    says="The rate of L, the matrix of the linear invariants' rates, by the rotation and its rate.",
    given=(linear_rate_matrix, *axis_angle_rates),
)

rate_of_linear_rate_matrix_by_velocity = Claim(
    "3.96b",
    rate(L),
    column(
        -(paren(dot(omega, u)) * one) - paren(over(1, 2)) * Omega @ Q,
        -(paren(over(1, 2)) * omega.T @ bracket(one * tr(Q) - Q.T)),
    ),
    part=2,
    says="The rate of L, the matrix of the linear invariants' rates, by the rotation and the angular velocity.",
    given=(linear_rate_matrix, linear_invariants_vector, *axis_angle_rates),
)

rate_of_euler_rodrigues_rate_matrix = Claim(
    "3.96c",
    rate(H), number(1) / 2 * column(rate(r_0) * one - rate(R_er), -rate(r_er).T),
    says="The rate of H, the matrix of the Euler-Rodrigues parameters' rates.",
    given=(euler_rodrigues_rate_matrix, euler_rodrigues_parameters_vector, euler_rodrigues_parameters_scalar),
)

trace_of_rotation_rate = Claim(
    "3.96d",
    tr(rate(Q)), tr(Omega @ Q),
    says="The rate of the trace of the rotation.",
    given=axis_angle_rates,
    sign=r"\equiv",
)

trace_of_rotation_rate_by_velocity = Claim(
    "3.96d",
    tr(Omega @ Q), -(2 * omega.T @ u),
    part=2,
    says="The rate of the trace of the rotation by the angular velocity.",
    given=(linear_invariants_vector, *axis_angle_rates),
    sign=r"\equiv",
)

upper_block_of_natural_rate_matrix_rate = Claim(
    "3.96e",
    B_N,
    -(2 * paren(dot(e, omega)) * one)
    + 2 * (3 - cos(phi)) * paren(dot(e, omega)) * e @ e.T
    - 2 * (1 + sin(phi)) * omega @ e.T
    - (2 * cos(phi) + sin(phi)) * e @ omega.T
    - paren(sin(phi)) * bracket(Omega - paren(dot(e, omega)) * E),
    says="The block B of the rate of N by the invariants and the angular velocity.",
    given=(upper_block_of_natural_rates, B_is_the_upper_block, *axis_angle_rates),
    sign=r"\equiv",
)

rate_of_natural_velocity_matrix = Claim(
    "3.97a",
    rate(N),
    printed(
        lambda: row(
            rate(phi) * paren(cos(phi)) * one + rate(phi) * paren(sin(theta)) * E @ rate(e),
        )
    ),
    reading=(
        rate(N_tilde),
        row(rate(phi) * paren(cos(phi)) * one + rate(phi) * paren(sin(phi)) * E, rate(e)),
    ),
    says="The rate of the matrix that gives the angular velocity from the natural invariants' rates.",
    given=(natural_velocity_matrix,),
)

scalar_of_linear_rate = Definition("3.97e", D, 1 + u_0, says="One plus the scalar linear invariant.")

block_of_linear_rate = Definition(
    "3.97d",
    V_lin,
    rate(U_lin)
    - paren(rate(u) @ u.T + u @ rate(u).T)
    - rate(u_0) / D * paren(U_lin - u @ u.T),
    says="The block V of the rate of the left inverse of L.",
    given=(scalar_of_linear_rate,),
    assuming=(phi_is_not_pi,),
)

rate_of_linear_velocity_matrix = Claim(
    "3.97b",
    rate(L), printed(lambda: row(over(V_lin, D) @ rate(u))),
    reading=(rate(L_tilde), row(over(V_lin, D), rate(u))),
    says="The rate of the matrix that gives the angular velocity from the linear invariants' rates.",
    given=(
        linear_velocity_matrix,
        linear_invariants_vector,
        linear_invariants_scalar,
        scalar_of_linear_rate,
        block_of_linear_rate,
    ),
)

rate_of_euler_rodrigues_velocity_matrix = Claim(
    "3.97c",
    rate(H), printed(lambda: row(rate(r_0) * one + rate(R_er) - rate(r_er))),
    reading=(rate(H_tilde), row(rate(r_0) * one + rate(R_er), -rate(r_er))),
    says="The rate of the matrix that gives the angular velocity from the Euler-Rodrigues parameters' rates.",
    given=(
        euler_rodrigues_velocity_matrix,
        euler_rodrigues_parameters_vector,
        euler_rodrigues_parameters_scalar,
    ),
)

# The rates of the six matrices as functions of axis, angle and angular velocity: what (3.96) and (3.97) come to when
# the rates of the invariants are put in by (3.76a).


def _rate_of_axis(cotangent: Node) -> Node:
    """The upper rows of (3.76a), with the cotangent of half the angle as it is to be written."""
    return half * cotangent * paren((one - e @ e.T) @ omega) - half * cross(e, omega)


rate_of_axis = Claim(
    "text 3.5 e",
    rate(e), _rate_of_axis(over(sin(phi), 1 - cos(phi))),
    says="The rate of the axis by the angular velocity.",
    given=axis_angle_rates,
    assuming=(phi_is_not_zero,),
)

rate_of_angle = Claim(
    "text 3.5 e",
    rate(phi), dot(e, omega),
    part=2,
    says="The rate of the angle by the angular velocity.",
    given=axis_angle_rates,
)

_axis_rate = half * cot(phi / 2) * paren((one - e @ e.T) @ omega) - cross(half * e, omega)
_half_cotangent_rate = -((half * cot(phi / 2)) ** 2 + half**2) * dot(e, omega)
_along = _half_cotangent_rate * e + cot(phi / 2) * _axis_rate

natural_rate_matrix_dot = Claim(
    "text 3.5 f",
    rate(N),
    column(
        -(half * dot(e, omega) / (1 - cos(phi))) * (one - e @ e.T)
        - over(sin(phi), 2 * (1 - cos(phi))) * (rate_of_axis.right @ e.T + e @ rate_of_axis.right.T)
        - half * CPM(rate_of_axis.right),
        rate_of_axis.right.T,
    ),
    says="The rate of N by axis, angle and angular velocity: (3.96a).",
    given=(natural_rate_matrix, *axis_angle_rates),
    kernel=Kernel(
        of=(e, phi, omega),
        form=column(
            _half_cotangent_rate * one - half * (e @ _along.T + _along @ e.T) - half * CPM(_axis_rate),
            _axis_rate.T,
        ),
    ),
)

_across = half * sin(phi) * omega - half * (1 - cos(phi)) * cross(e, omega)
_rate_of_u = (
    half * (1 + cos(phi)) * omega - half * (1 - cos(phi)) * dot(e, omega) * e - half * sin(phi) * cross(e, omega)
)

linear_rate_matrix_dot = Claim(
    "text 3.5 f",
    rate(L),
    column(
        -(paren(dot(omega, u)) * one) - half * CPM(omega) @ Q,
        -(half * omega.T @ bracket(one * tr(Q) - Q.T)),
    ),
    part=2,
    says="The rate of L by axis, angle and angular velocity: (3.96b).",
    given=(linear_rate_matrix, linear_invariants_vector, *axis_angle_rates),
    kernel=Kernel(
        of=(e, phi, omega),
        form=column(
            -(half * sin(phi) * dot(e, omega)) * one
            - half * (e @ _across.T + _across @ e.T)
            - half * CPM(_rate_of_u),
            -_rate_of_u.T,
        ),
    ),
)

_rate_of_r = half * (r_0 * omega - cross(r_er, omega))
_rate_of_r_0 = -(half * dot(r_er, omega))
_quarter = half**2 * r_er
_half_rate_of_r = half**2 * r_0 * omega - cross(_quarter, omega)

euler_rodrigues_rate_matrix_dot = Claim(
    "text 3.5 f",
    rate(H), half * column(_rate_of_r_0 * one - CPM(_rate_of_r), -_rate_of_r.T),
    part=3,
    says="The rate of H by axis, angle and angular velocity: (3.96c).",
    given=(
        euler_rodrigues_rate_matrix,
        euler_rodrigues_parameters_vector,
        euler_rodrigues_parameters_scalar,
        *axis_angle_rates,
    ),
    kernel=Kernel(
        of=(e, phi, omega),
        form=column(-dot(_quarter, omega) * one - CPM(_half_rate_of_r), -_half_rate_of_r.T),
    ),
)

natural_velocity_matrix_dot = Claim(
    "text 3.5 g",
    rate(N_tilde),
    row(dot(e, omega) * cos(phi) * one + CPM(half * sin(phi) * dot(e, omega) * e + _across), rate_of_axis.right),
    says="The rate of the left inverse of N by axis, angle and angular velocity: (3.97a).",
    given=(natural_velocity_matrix, *axis_angle_rates),
    assuming=(phi_is_not_zero,),
    kernel=Kernel(of=(e, phi, omega)),
)

_gibbs = over(sin(phi), 1 + cos(phi)) * e
_rate_of_gibbs = half * (omega + dot(_gibbs, omega) * _gibbs - cross(_gibbs, omega))

linear_velocity_matrix_dot = Claim(
    "text 3.5 g",
    rate(L_tilde), row(CPM(_rate_of_gibbs), -_rate_of_gibbs),
    part=2,
    says="The rate of the left inverse of L by axis, angle and angular velocity: (3.97b).",
    given=(linear_velocity_matrix, *axis_angle_rates),
    kernel=Kernel(of=(e, phi, omega)),
)

euler_rodrigues_velocity_matrix_dot = Claim(
    "text 3.5 g",
    rate(H_tilde), 2 * row(_rate_of_r_0 * one + CPM(_rate_of_r), -_rate_of_r),
    part=3,
    says="The rate of the left inverse of H by axis, angle and angular velocity: (3.97c).",
    given=(
        euler_rodrigues_velocity_matrix,
        euler_rodrigues_parameters_vector,
        euler_rodrigues_parameters_scalar,
        *axis_angle_rates,
    ),
    kernel=Kernel(of=(e, phi, omega)),
)

# The second rate of the pose, (3.91), and the rate of the twist, (3.93), with each kind of invariants: the rates of T
# and S by (3.92) and (3.94).

_spin = (*axis_angle_rates, twist, velocity_of_landmark, pose)
_natural = (natural_vector, natural_scalar, *_spin)
_linear = (linear_vector, linear_scalar, *_spin)
_euler_rodrigues = (euler_rodrigues_vector, euler_rodrigues_scalar, *_spin)
_parameters = (euler_rodrigues_parameters_vector, euler_rodrigues_parameters_scalar)
_angular_part = row(one, O) @ t


def _with_twist(rate_of_matrix: Node) -> Node:
    """(3.92), with the angular velocity as a part of the twist."""
    return matrix((replace(rate_of_matrix, {omega: _angular_part}), O_43), (O, O))


_w, _w_dot, _v_dot = _angular_part, row(one, O) @ rate(t), row(O, one) @ rate(t)
_e_dot = half * cot(phi / 2) * paren((one - e @ e.T) @ _w) - half * cross(e, _w)
_phi_dot_dot = dot(e, _w_dot) + dot(_e_dot, _w)
_e_dot_dot = (
    half * cot(phi / 2) * (_w_dot - _phi_dot_dot * e - dot(e, _w) * _e_dot)
    - ((half * cot(phi / 2)) ** 2 + half**2) * dot(e, _w) * paren((one - e @ e.T) @ _w)
    - half * (cross(e, _w_dot) + cross(_e_dot, _w))
)

pose_acceleration_natural = Claim(
    "text 3.5 h",
    rate(rate(s)), T @ rate(t) + _with_twist(natural_rate_matrix_dot.right) @ t,
    says="The second rate of the pose from the twist and its rate, with the natural invariants.",
    given=(pose_rate_matrix, F_is_natural, natural_rate_matrix, *_natural),
    kernel=Kernel(
        of=(e, phi, t, rate(t)),
        form=column(_e_dot_dot, _phi_dot_dot, _v_dot),
    ),
)

pose_acceleration_linear = Claim(
    "text 3.5 h",
    rate(rate(s)), T @ rate(t) + _with_twist(linear_rate_matrix_dot.right) @ t,
    part=2,
    says="The second rate of the pose from the twist and its rate, with the linear invariants.",
    given=(pose_rate_matrix, F_is_linear, linear_rate_matrix, linear_invariants_vector, *_linear),
    kernel=Kernel(
        of=(e, phi, t, rate(t)),
        form=column(
            half * (1 + cos(phi)) * _w_dot
            - half * sin(phi) * cross(e, _w_dot)
            - half * sin(phi) * dot(e, _w) * _w
            + half * (1 - cos(phi)) * dot(e, _w) * cross(e, _w)
            - (half * (1 - cos(phi)) * dot(e, _w_dot) + half * sin(phi) * dot(_w, _w)) * e,
            half * (1 - cos(phi)) * dot(e, _w) * dot(e, _w)
            - sin(phi) * dot(e, _w_dot)
            - half * (1 + cos(phi)) * dot(_w, _w),
            _v_dot,
        ),
    ),
)

pose_acceleration_euler_rodrigues = Claim(
    "text 3.5 h",
    rate(rate(s)), T @ rate(t) + _with_twist(euler_rodrigues_rate_matrix_dot.right) @ t,
    part=3,
    says="The second rate of the pose from the twist and its rate, with the Euler-Rodrigues parameters.",
    given=(pose_rate_matrix, F_is_euler_rodrigues, euler_rodrigues_rate_matrix, *_parameters, *_euler_rodrigues),
    kernel=Kernel(
        of=(e, phi, t, rate(t)),
        form=column(
            half * (r_0 * _w_dot - cross(r_er, _w_dot)) - half**2 * dot(_w, _w) * r_er,
            -(half * dot(r_er, _w_dot)) - half**2 * dot(_w, _w) * r_0,
            _v_dot,
        ),
    ),
)

_vector_part = row(one, zero, O) @ rate(s)
_scalar_part = row(zero.T, 1, zero.T) @ rate(s)


def _with_pose(rate_of_matrix: Node) -> Node:
    """(3.94)."""
    return matrix((rate_of_matrix, O), (O_34, O))


twist_rate_from_pose_natural = Claim(
    "text 3.5 i",
    rate(t),
    S @ rate(rate(s))
    + _with_pose(
        row(
            _scalar_part * cos(phi) * one + _scalar_part * sin(phi) * E + (1 - cos(phi)) * CPM(_vector_part),
            _vector_part,
        )
    )
    @ rate(s),
    says="The rate of the twist from the rates of the pose, with the natural invariants.",
    given=(twist_matrix, F_tilde_is_natural, natural_velocity_matrix, *_natural),
    kernel=Kernel(
        of=(e, phi, rate(s), rate(rate(s))),
        form=S @ rate(rate(s))
        + column(
            (1 + cos(phi)) * _scalar_part * _vector_part + sin(phi) * _scalar_part * cross(e, _vector_part), zero
        ),
    ),
)

_rate_of_quotient = (_vector_part - over(sin(phi), 1 + cos(phi)) * _scalar_part * e) / (1 + cos(phi))

twist_rate_from_pose_linear = Claim(
    "text 3.5 i",
    rate(t),
    S @ rate(rate(s)) + _with_pose(row(CPM(_rate_of_quotient), -_rate_of_quotient)) @ rate(s),
    part=2,
    says="The rate of the twist from the rates of the pose, with the linear invariants.",
    given=(twist_matrix, F_tilde_is_linear, linear_velocity_matrix, *_linear),
    kernel=Kernel(
        of=(e, phi, rate(s), rate(rate(s))),
        form=S @ rate(rate(s)) - _scalar_part / (1 + cos(phi)) * column(row(L_tilde, O) @ rate(s), zero),
    ),
)

twist_rate_from_pose_euler_rodrigues = Claim(
    "text 3.5 i",
    rate(t),
    S @ rate(rate(s)) + _with_pose(2 * row(_scalar_part * one + CPM(_vector_part), -_vector_part)) @ rate(s),
    part=3,
    says="The rate of the twist from the rates of the pose, with the Euler-Rodrigues parameters.",
    given=(twist_matrix, F_tilde_is_euler_rodrigues, euler_rodrigues_velocity_matrix, *_euler_rodrigues),
    kernel=Kernel(of=(e, phi, rate(s), rate(rate(s))), form=S @ rate(rate(s))),
)
