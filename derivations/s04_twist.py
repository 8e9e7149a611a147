"""Section 3.4: general instantaneous motion of a rigid body."""

from chasles.derivations.notation import *
from chasles.derivations.s02_screw import (
    euler_rodrigues_constraint,
    euler_rodrigues_scalar,
    euler_rodrigues_vector,
    linear_scalar,
    linear_vector,
    natural_scalar,
    natural_vector,
    phi_is_not_zero,
    pose,
    rotation_from_axis_angle,
    screw_axis_point,
)
from chasles.derivations.s03_fixed_point import (
    Q_is_a_rotation,
    angular_velocity,
    angular_velocity_matrix,
    angular_velocity_matrix_of_vector,
)

from chasles.statements import (
    Always,
    Branch,
    Claim,
    Condition,
    Definition,
    Iff,
    Inverse,
    Kernel,
    Minimum,
    Section,
    Theorem,
    nonzero,
    unit,
    unit_column,
)
from chasles.vocabulary import (
    CPM,
    PI,
    Node,
    at,
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
    row,
    sin,
    tr,
    vect,
)

general_instantaneous_motion = Section("3.4", "General Instantaneous Motion of a Rigid Body")

position_of_a_point = Definition(
    "3.47",
    at(p), at(a) + at(Q) @ paren(p_ref - a_ref),
    says="Where a point of the body lies.",
    sign="=",
)

velocity_from_reference_configuration = Claim(
    "3.48",
    rate(at(p)), rate(at(a)) + rate(at(Q)) @ paren(p_ref - a_ref),
    says="The velocity of a point from the reference configuration.",
    given=(position_of_a_point,),
)

velocity_by_angular_velocity_matrix = Claim(
    "3.49",
    rate(p), rate(a) + Omega @ (p - a),
    says="The velocity of a point from that of the landmark, by the angular-velocity matrix.",
    given=(position_of_a_point, angular_velocity_matrix),
    assuming=(Q_is_a_rotation,),
)

velocity_of_point = Claim(
    "3.50",
    rate(p), rate(a) + cross(omega, p - a),
    says="The velocity of a point from that of the landmark.",
    given=(velocity_by_angular_velocity_matrix, angular_velocity_matrix_of_vector),
    kernel=Kernel(of=(omega, rate(a), a, p)),
)

relative_velocity_is_perpendicular = Claim(
    "3.51",
    dot(rate(p) - rate(a), p - a), number(0),
    says="The relative velocity of two points is perpendicular to the line that joins them.",
    given=(velocity_of_point,),
)

perpendicular_relative_velocity = Theorem(
    "Thm 3.4.1",
    says="The relative velocity of two points of a rigid body is perpendicular to the line that joins them.",
    forms=(Always(dot(rate(p) - rate(a), p - a), number(0)),),
    given=(velocity_of_point,),
)

equal_projections_on_angular_velocity = Theorem(
    "Cor 3.4.1",
    says="The velocities of all points of a rigid body have the same projection onto the angular velocity.",
    forms=(Always(dot(omega, rate(p)), dot(omega, rate(a))),),
    given=(velocity_of_point,),
)

instant_screw_section = Section("3.4.1", "The Instant Screw of a Rigid-Body Motion")

omega_is_not_zero = nonzero(norm(omega), r"\boldsymbol{\omega} \neq \mathbf{0}")

minimum_velocity = Definition(
    "3.52",
    v_0, v0 * (omega / norm(omega)),
    says="The velocity of the points of the instant screw axis, parallel to the angular velocity.",
    sign="=",
    assuming=(omega_is_not_zero,),
)

minimum_velocity_projects_like_all = Condition(
    "text 3.4.1 a",
    dot(v_0, omega), dot(rate(p), omega),
    says="The least velocity has the same projection onto the angular velocity as every velocity of the body.",
    given=(minimum_velocity,),
    on=(v0,),
)

pitch_of_instant_screw = Definition(
    "3.53",
    pitch_, v0 / norm(omega),
    says="The pitch of the instant screw: metres along the axis per radian.",
    assuming=(omega_is_not_zero,),
)

pitch_by_velocity = Claim(
    "3.53",
    v0 / norm(omega), dot(rate(p), omega) / norm(omega) ** 2,
    part=2,
    says="The pitch from the velocity of any point.",
    given=(minimum_velocity, minimum_velocity_projects_like_all),
    sign=r"\equiv",
)

pitch_of_instant_screw_per_turn = Definition(
    "3.53",
    pitch_per_turn_, 2 * PI * v0 / norm(omega),
    part=3,
    says="The pitch in metres per turn.",
    assuming=(omega_is_not_zero,),
)

instant_screw_axis = Definition(
    "3.54", axis_, column(e_, n_), says="The Plücker array of the instant screw axis."
)

instant_direction = Definition(
    "3.55",
    e_, omega / norm(omega),
    says="The direction of the instant screw axis.",
    assuming=(omega_is_not_zero,),
)

instant_moment = Definition("3.55", n_, cross(p, e_), part=2, says="The moment of the instant screw axis.")

minimum_velocity_by_landmark = Claim(
    "text 3.4.1 d",
    v0, dot(rate(a), omega) / norm(omega),
    says="The signed magnitude of the least velocity, from the velocity of the landmark.",
    given=(minimum_velocity, minimum_velocity_projects_like_all, velocity_of_point),
)

axial_velocity_of_landmark = Definition(
    "3.57",
    adot_par, omega @ omega.T / norm(omega) ** 2 @ rate(a),
    part=2,
    says="The component of the landmark's velocity along the angular velocity.",
    assuming=(omega_is_not_zero,),
)

axial_velocity_of_landmark_by_dot = Claim(
    "3.57",
    adot_par, dot(rate(a), omega / norm(omega) ** 2),
    says="The component of the landmark's velocity along the angular velocity, by a scalar product.",
    given=(axial_velocity_of_landmark,),
    sic=True,
    sign=r"\equiv",
)

normal_velocity_of_landmark = Definition(
    "3.57",
    adot_perp, paren(one - omega @ omega.T / norm(omega) ** 2) @ rate(a),
    part=3,
    says="The component of the landmark's velocity normal to the angular velocity.",
    assuming=(omega_is_not_zero,),
)

normal_velocity_by_matrix = Claim(
    "3.57",
    paren(one - omega @ omega.T / norm(omega) ** 2) @ rate(a), -(1 / norm(omega) ** 2) * Omega**2 @ rate(a),
    part=4,
    says="The component of the landmark's velocity normal to the angular velocity, by the angular-velocity matrix.",
    given=(angular_velocity_matrix_of_vector,),
    assuming=(omega_is_not_zero,),
    sign=r"\equiv",
)

landmark_velocity_in_two_components = Claim(
    "3.56",
    rate(a), adot_par + adot_perp,
    says="The landmark's velocity is the sum of its components along and normal to the angular velocity.",
    given=(axial_velocity_of_landmark, normal_velocity_of_landmark),
    sign=r"\equiv",
)

square_of_angular_velocity_matrix = Claim(
    "3.58",
    Omega**2, omega @ omega.T - norm(omega) ** 2 * one,
    says="The square of the angular-velocity matrix.",
    given=(angular_velocity_matrix_of_vector,),
    sign=r"\equiv",
)

velocity_in_two_components = Claim(
    "3.59",
    rate(p),
    omega @ omega.T / norm(omega) ** 2 @ rate(a)
    - 1 / norm(omega) ** 2 * Omega**2 @ rate(a) + Omega @ paren(p - a),
    says="The velocity of a point: an axial component, the same for all, and a normal one.",
    given=(velocity_by_angular_velocity_matrix, angular_velocity_matrix_of_vector),
    assuming=(omega_is_not_zero,),
)

axial_velocity = Definition(
    "text 3.4.1 e",
    pdot_par, omega @ omega.T / norm(omega) ** 2 @ rate(a),
    says="The component of the velocity of a point along the angular velocity.",
    assuming=(omega_is_not_zero,),
)

normal_velocity = Definition(
    "text 3.4.1 e",
    pdot_perp, -(1 / norm(omega) ** 2 * Omega**2 @ rate(a)) + Omega @ paren(p - a),
    part=2,
    says="The component of the velocity of a point normal to the angular velocity.",
    assuming=(omega_is_not_zero,),
)

normal_velocity_vanishes = Condition(
    "3.60",
    Omega @ paren(p - a) - 1 / norm(omega) ** 2 * Omega**2 @ rate(a), zero,
    says="The points of the instant screw axis have no velocity normal to the angular velocity.",
    given=(angular_velocity_matrix_of_vector,),
    assuming=(omega_is_not_zero,),
    on=(p,),
    solution=a + 1 / norm(omega) ** 2 * Omega @ rate(a) + arc_by_omega * omega,
)

equation_of_instant_screw_axis = Claim(
    "3.61",
    Omega @ p, Omega @ (a + 1 / norm(omega) ** 2 * Omega @ rate(a)),
    says="The equation of the instant screw axis.",
    given=(),
    assuming=(omega_is_not_zero,),
    restates=normal_velocity_vanishes,
)

point_on_instant_screw_axis = Definition(
    "3.62b",
    r, a + 1 / norm(omega) ** 2 * Omega @ rate(a),
    says="One point of the instant screw axis.",
    assuming=(omega_is_not_zero,),
)

instant_screw_axis_through_point = Claim(
    "3.62a",
    Omega @ paren(p - r), zero,
    says="The instant screw axis passes through the point of (3.62b).",
    given=(point_on_instant_screw_axis,),
    restates=equation_of_instant_screw_axis,
)

point_solves_equation = Claim(
    "3.63",
    p, r,
    says="The point of (3.62b) solves the equation of the instant screw axis.",
    given=(point_on_instant_screw_axis,),
    solves=equation_of_instant_screw_axis,
)

point_on_instant_screw_axis_again = Claim(
    "3.63",
    r, a + 1 / norm(omega) ** 2 * Omega @ rate(a),
    part=2,
    says="The point of (3.62b), written out.",
    given=(point_on_instant_screw_axis,),
)

instant_screw_point_is_nearest = Condition(
    "3.64",
    omega.T @ p_0_, number(0),
    says="Of all points of the instant screw axis, P_0' is nearest to the origin.",
    on=(p_0_,),
)

instant_screw_point_is_on_axis = Condition(
    "text 3.4.1 b",
    Omega @ p_0_, Omega @ (a + 1 / norm(omega) ** 2 * Omega @ rate(a)),
    says="P_0' is a point of the instant screw axis.",
    given=(angular_velocity_matrix_of_vector,),
    assuming=(omega_is_not_zero,),
    on=(p_0_,),
)

instant_screw_matrix = Definition(
    "3.66", A_isa, column(Omega, omega.T), says="The matrix of the four equations of P_0'."
)

instant_screw_right_side = Definition(
    "3.66",
    b_isa, column(Omega @ a + paren(over(1, norm(omega) ** 2)) * Omega**2 @ rate(a), 0),
    part=2,
    says="The right side of the four equations of P_0'.",
    assuming=(omega_is_not_zero,),
)

equations_of_instant_screw_point = Claim(
    "3.65",
    A_isa @ p_0_, b_isa,
    says="Four compatible equations for the three coordinates of P_0'.",
    given=(instant_screw_matrix, instant_screw_right_side),
    restates=(instant_screw_point_is_on_axis, instant_screw_point_is_nearest),
)

normal_equations_of_instant_screw_point = Claim(
    "3.67",
    A_isa.T @ A_isa @ p_0_, A_isa.T @ b_isa,
    says="The normal equations of P_0'.",
    restates=equations_of_instant_screw_point,
    by=A_isa.T,
)

instant_normal_matrix = Claim(
    "3.68",
    A_isa.T @ A_isa, Omega.T @ Omega + omega @ omega.T,
    says="The matrix of the normal equations of P_0'.",
    given=(instant_screw_matrix,),
)

instant_normal_matrix_by_square = Claim(
    "3.68",
    Omega.T @ Omega + omega @ omega.T, -(Omega**2) + omega @ omega.T,
    part=2,
    says="The matrix of the normal equations of P_0', since the angular-velocity matrix is skew-symmetric.",
    given=(angular_velocity_matrix_of_vector,),
)

instant_normal_matrix_is_spherical = Claim(
    "3.69",
    A_isa.T @ A_isa, norm(omega) ** 2 * one,
    says="The matrix of the normal equations of P_0' is a multiple of the identity.",
    given=(instant_screw_matrix, angular_velocity_matrix_of_vector),
)

instant_normal_right_side = Claim(
    "3.69",
    A_isa.T @ b_isa, Omega @ (rate(a) - Omega @ a),
    part=2,
    says="The right side of the normal equations of P_0'.",
    given=(instant_screw_matrix, instant_screw_right_side, angular_velocity_matrix_of_vector),
)

instant_screw_point_by_matrix = Claim(
    "3.70",
    p_0_, Omega @ (rate(a) - Omega @ a) / norm(omega) ** 2,
    says="The point of the instant screw axis nearest the origin.",
    given=(instant_screw_point_is_nearest, instant_screw_point_is_on_axis, angular_velocity_matrix_of_vector),
    assuming=(omega_is_not_zero,),
)

instant_screw_point = Claim(
    "3.70",
    p_0_, cross(omega, rate(a) - cross(omega, a)) / norm(omega) ** 2,
    part=2,
    says="The point of the instant screw axis nearest the origin, with vector products.",
    given=(instant_screw_point_is_nearest, instant_screw_point_is_on_axis, angular_velocity_matrix_of_vector),
    assuming=(omega_is_not_zero,),
    sign=r"\equiv",
    kernel=Kernel(of=(omega, rate(a), a)),
)

least_velocity_on_one_line = Theorem(
    "Thm 3.4.2",
    says="The velocities of least magnitude are those of the points of one line, parallel to the angular velocity, "
    "and they are parallel to it.",
    forms=(
        Always(rate(p), dot(rate(a), omega) / norm(omega) ** 2 * omega + cross(omega, p - p_0_)),
        Minimum(
            of=norm(rate(p)) ** 2,
            value=(dot(rate(a), omega) / norm(omega)) ** 2,
            over=p,
            at=p_0_ + arc_by_omega * omega,
            squares=(cross(omega, p - p_0_),),
        ),
        Iff(
            one=cross(omega, p - p_0_),
            other=p - p_0_ - dot(omega, p - p_0_) / norm(omega) ** 2 * omega,
            forth=-(1 / norm(omega) ** 2) * CPM(omega),
            back=CPM(omega),
        ),
    ),
    given=(velocity_of_point, instant_screw_point),
)

twist_section = Section("3.4.2", "The Twist of a Rigid Body")

screw_array = Definition("3.71", screw, column(e, cross(p, e) + pitch * e), says="The screw: a line with a pitch.")

twist = Definition("3.72", t, column(omega, v), says="The twist: angular velocity and velocity of a landmark point.")

velocity_of_landmark = Definition(
    "text 3.4.2 a", v, rate(d_A), says="The velocity of the landmark is the rate of its displacement."
)

direction_of_translation = Definition(
    "text 3.4.2 b",
    e, v / norm(v),
    says="The direction of a pure translation.",
    assuming=(nonzero(norm(v), r"\mathbf{v} \neq \mathbf{0}"),),
)

translation_twist = Definition("3.73", t, column(zero, v), says="The twist of a pure translation.")

translation_twist_by_direction = Claim(
    "3.73",
    t, norm(v) * column(zero, e),
    part=2,
    says="The twist of a pure translation as an amplitude times a screw.",
    given=(translation_twist, direction_of_translation),
)

infinite_pitch_screw = Definition("3.74", screw_inf, column(zero, e), says="The screw of infinite pitch.")

natural_invariants_array = Definition("3.75", nu, column(e, phi), says="The natural invariants.")

linear_invariants_array = Definition(
    "3.75", lambda_, column(paren(sin(phi)) * e, cos(phi)), part=2, says="The linear invariants."
)

euler_rodrigues_array = Definition(
    "3.75",
    eta, column(bracket(sin(over(phi, 2))) * e, cos(over(phi, 2))),
    part=3,
    says="The Euler-Rodrigues parameters.",
)

natural_rate_matrix = Definition(
    "3.76b",
    N,
    column(
        bracket(over(sin(phi), paren(2 * (1 - cos(phi))))) * paren(one - e @ e.T) - paren(over(1, 2)) * E,
        e.T,
    ),
    says="The matrix of the natural invariants' rates.",
    given=(),
    assuming=(unit(e), phi_is_not_zero),
    kernel=Kernel(of=(e, phi)),
)

linear_rate_matrix = Definition(
    "3.76c",
    L, column(paren(over(1, 2)) * bracket(tr(Q) * one - Q), -paren(sin(phi)) * e.T),
    says="The matrix of the linear invariants' rates.",
    given=(rotation_from_axis_angle,),
    kernel=Kernel(of=(e, phi)),
)

euler_rodrigues_rate_matrix = Definition(
    "3.76d",
    H, number(1) / 2 * column(cos(over(phi, 2)) * one - sin(over(phi, 2)) * E, -sin(over(phi, 2)) * e.T),
    says="The matrix of the Euler-Rodrigues parameters' rates.",
    assuming=(unit(e),),
    kernel=Kernel(of=(e, phi)),
)

natural_rates = Claim(
    "3.76a",
    rate(nu), N @ omega,
    says="The rates of the natural invariants are linear in the angular velocity.",
    given=(
        natural_invariants_array,
        natural_rate_matrix,
        rotation_from_axis_angle,
        angular_velocity_matrix,
        angular_velocity,
    ),
)

linear_rates = Claim(
    "3.76a",
    rate(lambda_), L @ omega,
    part=2,
    says="The rates of the linear invariants are linear in the angular velocity.",
    given=(
        linear_invariants_array,
        linear_rate_matrix,
        rotation_from_axis_angle,
        angular_velocity_matrix,
        angular_velocity,
    ),
)

euler_rodrigues_rates = Claim(
    "3.76a",
    rate(eta), H @ omega,
    part=3,
    says="The rates of the Euler-Rodrigues parameters are linear in the angular velocity.",
    given=(
        euler_rodrigues_array,
        euler_rodrigues_rate_matrix,
        rotation_from_axis_angle,
        angular_velocity_matrix,
        angular_velocity,
    ),
)

rotation_from_linear_invariants = Claim(
    "text 3.4.2 f",
    Q, q_0 * one + CPM(q) + q @ q.T / (1 + q_0),
    says="The rotation from its linear invariants.",
    given=(rotation_from_axis_angle, linear_vector, linear_scalar),
    assuming=(nonzero(1 + cos(phi), r"\phi \neq \pi"),),
    kernel=Kernel(of=(q, q_0), expected=(unit_column(q, q_0), nonzero(1 + q_0))),
)

rotation_from_euler_rodrigues = Claim(
    "text 3.4.2 f",
    Q, (q_0**2 - dot(q, q)) * one + 2 * q @ q.T + 2 * q_0 * CPM(q),
    part=2,
    says="The rotation from its Euler-Rodrigues parameters.",
    given=(rotation_from_axis_angle, euler_rodrigues_vector, euler_rodrigues_scalar),
    kernel=Kernel(of=(q, q_0), expected=(unit_column(q, q_0),)),
)

rotation_from_half_angle = Claim(
    "text 3.4.2 f",
    Q,
    (cos(phi / 2) ** 2 - sin(phi / 2) ** 2) * one
    + 2 * sin(phi / 2) ** 2 * e @ e.T
    + 2 * sin(phi / 2) * cos(phi / 2) * E,
    part=3,
    says="The rotation from its axis and half its angle.",
    given=(rotation_from_axis_angle,),
)

linear_invariants = Claim(
    "text 3.4.2 g",
    column(q, q_0), column(vect(Q), (tr(Q) - 1) / 2),
    says="The linear invariants from the rotation.",
    given=(rotation_from_axis_angle, linear_vector, linear_scalar),
    kernel=Kernel(of=(Q,), results=("q", "q_0"), expected=(Q_is_a_rotation,)),
)

# At a half-turn Q + 1 = 2 e e^T: each column that is not zero is along the axis.


def _fourfold(parameter: int) -> tuple[Node, Node]:
    """4 q_k q and 4 q_k q_0: the Euler-Rodrigues parameters times four times one of them, which is linear in Q."""
    if parameter == 0:
        return 2 * vect(Q), 1 + tr(Q)
    here = unit_columns[parameter - 1]
    along = [
        1 + 2 * here.T @ Q @ here - tr(Q) if other is here else other.T @ Q @ here + here.T @ Q @ other
        for other in unit_columns
    ]
    return column(*along), 2 * (here.T @ vect(Q))


_fourfolds = tuple((k, *_fourfold(k), norm(column(*_fourfold(k)))) for k in (0, 1, 2, 3))
_Q_is_not_the_identity = nonzero(3 - tr(Q), r"\phi \neq 0")

natural_invariants = Inverse(
    "text 3.4.2 h",
    of=rotation_from_half_angle,
    says="The natural invariants from the rotation.",
    assuming=(Q_is_a_rotation, _Q_is_not_the_identity),
    branches=tuple(
        Branch(
            f"by Euler-Rodrigues parameter {k}",
            where=length,
            values=(
                (e, along / norm(along)),
                (cos(phi / 2), beside / length),
                (sin(phi / 2), norm(along) / length),
            ),
            by=length / 16,
            assuming=(nonzero(norm(along), r"\mathbf{q} \neq \mathbf{0}"),),
            inverses=((norm(along), 4 * norm(along) / (length**2 * (3 - tr(Q)))),),
        )
        for k, along, beside, length in _fourfolds
    ),
    gives=(e, phi),
    largest=True,
    sign=(cos(phi / 2), e),
    kernel=Kernel(of=(Q,), results=("e", "phi")),
)

euler_rodrigues_parameters = Inverse(
    "text 3.4.2 i",
    of=rotation_from_euler_rodrigues,
    says="The Euler-Rodrigues parameters from the rotation.",
    assuming=(Q_is_a_rotation,),
    branches=tuple(
        Branch(
            f"by Euler-Rodrigues parameter {k}",
            where=length, values=((q, along / length), (q_0, beside / length)), by=length / 16,
        )
        for k, along, beside, length in _fourfolds
    ),
    satisfying=(euler_rodrigues_constraint,),
    gives=(q, q_0),
    largest=True,
    sign=(q_0, q),
    kernel=Kernel(of=(Q,), results=("q", "q_0")),
)

screw_of_motion = Inverse(
    "text 3.4.2 j",
    of=rotation_from_half_angle,
    says="The screw of a motion: Plücker array of its axis, translation along it, angle.",
    assuming=natural_invariants.assuming,
    given=(screw_axis_point,),
    branches=natural_invariants.branches,
    gives=(column(e, cross(p_0, e)), dot(e, a_ - a), phi),
    largest=True,
    sign=(cos(phi / 2), e),
    kernel=Kernel(
        of=(Q, a, a_),
        results=("axis", "d_0", "phi"),
        form=column(
            column(e, half * (cross(a + a_, e) + cot(phi / 2) * cross(bracket(cross(e, a_ - a)), e))),
            dot(e, a_ - a),
            phi,
        ),
    ),
)

_direction = omega / norm(omega)

instant_screw = Claim(
    "text 3.4.1 c",
    column(column(e_, n_), pitch_),
    column(column(omega / norm(omega), cross(p_0_, omega / norm(omega))), dot(rate(a), omega) / norm(omega) ** 2),
    says="The instant screw: Plücker array of its axis, and pitch.",
    given=(
        instant_direction,
        instant_moment.at({p: p_0_}),
        pitch_of_instant_screw,
        minimum_velocity_by_landmark,
        instant_screw_point,
    ),
    kernel=Kernel(
        of=(omega, rate(a), a),
        results=("axis", "pitch"),
        form=column(
            column(
                _direction,
                cross(cross(_direction, rate(a) / norm(omega)) + a, _direction),
            ),
            dot(_direction, rate(a) / norm(omega)),
        ),
    ),
)

phi_is_not_pi = nonzero(1 + cos(phi), r"\phi \neq \pi")

natural_velocity_matrix = Definition(
    "3.77b",
    N_tilde, printed(lambda: row(paren(sin(phi)) * one + paren(1 - cos(phi)) * E @ e)),
    reading=row(paren(sin(phi)) * one + paren(1 - cos(phi)) * E, e),
    says="The matrix that gives the angular velocity from the natural invariants' rates.",
    assuming=(unit(e),),
    kernel=Kernel(of=(e, phi)),
)

linear_velocity_matrix = Definition(
    "3.77c",
    L_tilde,
    printed(
        lambda: row(
            one
            + bracket(over(paren(sin(phi)), paren(1 + cos(phi)))) * E
            - bracket(over(paren(sin(phi)), paren(1 + cos(phi)))) * e
        )
    ),
    reading=row(
        one + bracket(over(paren(sin(phi)), paren(1 + cos(phi)))) * E,
        -bracket(over(paren(sin(phi)), paren(1 + cos(phi)))) * e,
    ),
    says="The matrix that gives the angular velocity from the linear invariants' rates.",
    assuming=(unit(e), phi_is_not_pi),
    kernel=Kernel(of=(e, phi)),
)

euler_rodrigues_velocity_matrix = Definition(
    "3.77d",
    H_tilde,
    printed(
        lambda: 2
        * row(
            bracket(cos(over(phi, 2))) * one + bracket(sin(over(phi, 2))) * E - bracket(sin(over(phi, 2))) * e,
        )
    ),
    reading=2 * row(bracket(cos(over(phi, 2))) * one + bracket(sin(over(phi, 2))) * E, -bracket(sin(over(phi, 2))) * e),
    says="The matrix that gives the angular velocity from the Euler-Rodrigues parameters' rates.",
    assuming=(unit(e),),
    kernel=Kernel(of=(e, phi)),
)

angular_velocity_from_natural_rates = Claim(
    "3.77a",
    omega, printed(lambda: N_tilde @ rate(v)),
    says="The angular velocity from the rates of the natural invariants.",
    given=(
        natural_invariants_array,
        natural_velocity_matrix,
        rotation_from_axis_angle,
        angular_velocity_matrix,
        angular_velocity,
    ),
    reading=N_tilde @ rate(nu),
)

angular_velocity_from_linear_rates = Claim(
    "3.77a",
    omega, L_tilde @ rate(lambda_),
    part=2,
    says="The angular velocity from the rates of the linear invariants.",
    given=(
        linear_invariants_array,
        linear_velocity_matrix,
        rotation_from_axis_angle,
        angular_velocity_matrix,
        angular_velocity,
    ),
)

angular_velocity_from_euler_rodrigues_rates = Claim(
    "3.77a",
    omega, H_tilde @ rate(eta),
    part=3,
    says="The angular velocity from the rates of the Euler-Rodrigues parameters.",
    given=(
        euler_rodrigues_array,
        euler_rodrigues_velocity_matrix,
        rotation_from_axis_angle,
        angular_velocity_matrix,
        angular_velocity,
    ),
)

F_is_natural = Definition("text 3.4.2 c", F, N, says="F of (3.79) for the natural invariants.")
F_is_linear = Definition("text 3.4.2 c", F, L, part=2, says="F of (3.79) for the linear invariants.")
F_is_euler_rodrigues = Definition("text 3.4.2 c", F, H, part=3, says="F of (3.79) for the Euler-Rodrigues parameters.")

pose_rate_matrix = Definition(
    "3.79", T, matrix((F, O_43), (O, one)), says="The matrix of the pose's rate."
)

_spin = (rotation_from_axis_angle, angular_velocity_matrix, angular_velocity, twist, velocity_of_landmark, pose)

pose_rate_natural = Claim(
    "3.78",
    rate(s), T @ t,
    says="The rate of the pose from the twist, with the natural invariants.",
    given=(pose_rate_matrix, F_is_natural, natural_rate_matrix, natural_vector, natural_scalar, *_spin),
    kernel=Kernel(of=(e, phi, t)),
)

pose_rate_linear = Claim(
    "3.78",
    rate(s), T @ t,
    part=2,
    says="The rate of the pose from the twist, with the linear invariants.",
    given=(pose_rate_matrix, F_is_linear, linear_rate_matrix, linear_vector, linear_scalar, *_spin),
    kernel=Kernel(of=(e, phi, t)),
)

pose_rate_euler_rodrigues = Claim(
    "3.78",
    rate(s), T @ t,
    part=3,
    says="The rate of the pose from the twist, with the Euler-Rodrigues parameters.",
    given=(
        pose_rate_matrix,
        F_is_euler_rodrigues,
        euler_rodrigues_rate_matrix,
        euler_rodrigues_vector,
        euler_rodrigues_scalar,
        *_spin,
    ),
    kernel=Kernel(of=(e, phi, t)),
)

F_tilde_is_natural = Definition(
    "text 3.4.2 d", F_tilde, N_tilde, says="The left inverse of F for the natural invariants."
)
F_tilde_is_linear = Definition(
    "text 3.4.2 d", F_tilde, L_tilde, part=2, says="The left inverse of F for the linear invariants."
)
F_tilde_is_euler_rodrigues = Definition(
    "text 3.4.2 d", F_tilde, H_tilde, part=3, says="The left inverse of F for the Euler-Rodrigues parameters."
)

twist_matrix = Definition(
    "3.80b", S, matrix((F_tilde, O), (O_34, one)), says="The matrix of the twist from the pose's rate."
)

twist_from_pose_rate_natural = Claim(
    "3.80a",
    t, S @ rate(s),
    says="The twist from the rate of the pose, with the natural invariants.",
    given=(twist_matrix, F_tilde_is_natural, natural_velocity_matrix, natural_vector, natural_scalar, *_spin),
    kernel=Kernel(of=(e, phi, rate(s))),
)

twist_from_pose_rate_linear = Claim(
    "3.80a",
    t, S @ rate(s),
    part=2,
    says="The twist from the rate of the pose, with the linear invariants.",
    given=(twist_matrix, F_tilde_is_linear, linear_velocity_matrix, linear_vector, linear_scalar, *_spin),
    kernel=Kernel(of=(e, phi, rate(s))),
)

twist_from_pose_rate_euler_rodrigues = Claim(
    "3.80a",
    t, S @ rate(s),
    part=3,
    says="The twist from the rate of the pose, with the Euler-Rodrigues parameters.",
    given=(
        twist_matrix,
        F_tilde_is_euler_rodrigues,
        euler_rodrigues_velocity_matrix,
        euler_rodrigues_vector,
        euler_rodrigues_scalar,
        *_spin,
    ),
    kernel=Kernel(of=(e, phi, rate(s))),
)

twist_at_landmark = Definition("3.81", t_A, column(omega, v_A), says="The twist at A.", sign="=")

twist_at_point = Definition("3.81", t_P, column(omega, v_P), part=2, says="The twist at P.", sign="=")

velocity_of_A = Definition("text 3.4.2 e", v_A, rate(a), says="The velocity of A.")

velocity_of_P = Definition("text 3.4.2 e", v_P, rate(p), part=2, says="The velocity of P.")

velocity_transfer = Claim(
    "3.82",
    v_P, v_A + cross(a - p, omega),
    says="The velocity of P from that of A.",
    given=(velocity_of_A, velocity_of_P, velocity_of_point),
)

twist_transfer_matrix = Definition(
    "3.83b",
    U, matrix((one, O), (A - P, one)),
    says="The matrix that transfers a twist from A to P.",
)

twist_transfer = Claim(
    "3.83a",
    t_P, U @ t_A,
    says="The twist-transfer formula.",
    given=(twist_at_landmark, twist_at_point, velocity_transfer, twist_transfer_matrix),
    kernel=Kernel(of=(t_A, a, p)),
)
