"""Section 3.8: dynamics of rigid bodies."""

from chasles.derivations.notation import *
from chasles.derivations.s03_fixed_point import (
    Q_is_a_rotation,
    angular_velocity_matrix,
    angular_velocity_matrix_of_vector,
)
from chasles.derivations.s04_twist import (
    position_of_a_point,
    twist_at_landmark,
    twist_transfer_matrix,
    velocity_of_A,
    velocity_of_point,
)

from chasles.statements import (
    Always,
    Claim,
    Definite,
    Definition,
    Iff,
    Kernel,
    OnlyWhere,
    Postulate,
    Section,
    Theorem,
    definite,
    nonzero,
    positive,
    symmetric,
    unit,
)
from chasles.vocabulary import (
    CPM,
    Cofactor,
    Identity,
    bracket,
    column,
    cross,
    det,
    dot,
    matrix,
    norm,
    number,
    paren,
    rate,
    row,
    tr,
)

dynamics = Section("3.8", "Dynamics of Rigid Bodies")

density_is_positive = positive(rho)
mass_is_positive = positive(m)
inertia_and_mass = (symmetric(I_C), mass_is_positive)

mass = Definition(
    "3.123",
    m, over_body(rho),
    says="The mass of the body.",
    sign="=",
    assuming=(density_is_positive,),
)

first_moment = Definition(
    "3.124",
    q_O, over_body(rho * p),
    says="The mass first moment of the body with respect to the origin.",
)

center_of_mass = Definition(
    "3.125",
    c, q_O / m,
    says="The center of mass.",
    assuming=(mass_is_positive,),
)

first_moment_by_center_of_mass = Claim(
    "text 3.8 a",
    over_body(rho * p), m * c,
    says="There is a center of mass: the first moment is that of the whole mass there.",
    given=(mass, first_moment, center_of_mass),
)

energy_of_body = Definition(
    "3.126",
    energy, over_body(half * rho * norm(rate(p)) ** 2),
    says="The kinetic energy of the body.",
)

radius = Definition("3.127", r_C, p - c, part=2, says="The position of P from the center of mass.")

landmark_is_center_of_mass = Definition("text 3.8 b", a, c, says="The center of mass is the landmark.")

velocity_from_center_of_mass = Claim(
    "3.127",
    rate(p), rate(c) + cross(omega, r_C),
    says="The velocity of P from that of the center of mass.",
    given=(velocity_of_point, landmark_is_center_of_mass, radius),
)

velocity_from_center_of_mass_by_matrix = Claim(
    "3.128",
    rate(p), rate(c) - R_C @ omega,
    says="The velocity of P from that of the center of mass, with a cross-product matrix.",
    given=(velocity_from_center_of_mass,),
)

energy_expanded = Claim(
    "text 3.8 c",
    energy,
    half
    * over_body(
        rho * bracket(norm(rate(c)) ** 2 - 2 * rate(c).T @ R_C @ omega + omega.T @ R_C.T @ R_C @ omega)
    ),
    says="The kinetic energy, the velocity substituted.",
    given=(energy_of_body, velocity_from_center_of_mass_by_matrix),
)

energy_in_three_integrals = Claim(
    "3.129",
    energy,
    half * norm(rate(c)) ** 2 * over_body(rho) - rate(c).T @ paren(over_body(rho * R_C)) @ omega
    + half * omega.T @ paren(over_body(rho * R_C.T @ R_C)) @ omega,
    says="The kinetic energy as the sum of three integrals.",
    given=(energy_expanded,),
)

product_under_the_integral = Claim(
    "text 3.8 d",
    R_C.T @ R_C, -(R_C**2),
    says="The product under the integral of the kinetic energy, since R is skew-symmetric.",
)

square_of_cross_product_matrix = Claim(
    "2.40",
    R_C**2, -(norm(r_C) ** 2) * one + r_C @ r_C.T,
    says="The square of a cross-product matrix.",
)

matrix_under_the_integral = Claim(
    "text 3.8 e",
    over_body(rho * R_C), over_body(rho * CPM(r_C)),
    says="The integral of R, the cross-product matrix of r, the operator written out.",
)

integral_and_operator_interchanged = Claim(
    "text 3.8 e",
    over_body(rho * CPM(r_C)), CPM(over_body(rho * r_C)),
    part=2,
    says="The integral of r and the operator of the cross-product matrix are interchanged.",
    sign=r"\equiv",
)

integral_of_matrix_expanded = Claim(
    "text 3.8 f",
    over_body(rho * R_C), CPM(over_body(rho * p) - c * over_body(rho)),
    says="The integral of R, the cross-product matrix of r, by the first moment and the mass.",
    given=(radius,),
)

integral_of_matrix_vanishes = Claim(
    "text 3.8 g",
    over_body(rho * R_C), O,
    says="The integral of R vanishes, because r is measured from the center of mass.",
    given=(radius, center_of_mass, first_moment, mass),
)

energy_by_center_of_mass = Claim(
    "3.130",
    energy,
    half * m * norm(rate(c)) ** 2
    + half * omega.T @ bracket(over_body(rho * (norm(r_C) ** 2 * one - r_C @ r_C.T))) @ omega,
    says="The kinetic energy: that of the center of mass, and that of the rotation about it.",
    given=(energy_in_three_integrals, radius, center_of_mass, first_moment, mass),
    sign=r"\equiv",
)

inertia = Definition(
    "text 3.8 h",
    I_C, over_body(rho * (norm(r_C) ** 2 * one - r_C @ r_C.T)),
    says="The moment of inertia of the body at the center of mass.",
)

inertia_is_symmetric = Claim(
    "text 3.8 i",
    I_C.T, I_C,
    says="The moment of inertia is symmetric.",
    given=(inertia,),
)

integrand_as_product = Claim(
    "text 3.8 j",
    norm(r_C) ** 2 * one - r_C @ r_C.T, R_C @ R_C.T,
    says="The term in parentheses in the moment of inertia is a product of R and its transpose.",
)

cross_product_matrix_has_rank_two = Theorem(
    "text 3.8 k",
    says="A cross-product matrix is singular, and its null space is spanned by its vector, so its rank is two.",
    forms=(
        Always(det(R_C), number(0)),
        Iff(
            one=R_C @ x_any,
            other=x_any - dot(r_C, x_any) / norm(r_C) ** 2 * r_C,
            forth=-(1 / norm(r_C) ** 2) * R_C,
            back=R_C,
        ),
    ),
    assuming=(nonzero(norm(r_C), r"\mathbf{r} \neq \mathbf{0}"),),
)

inertia_is_semidefinite = Theorem(
    "text 3.8 l",
    says="The moment of inertia is positive-semidefinite.",
    forms=(Definite(x_any.T @ I_C @ x_any, squares=(over_body(rho * norm(cross(r_C, x_any)) ** 2),)),),
    given=(inertia,),
    assuming=(density_is_positive,),
)

normal_of_two_elements = Definition(
    "text 3.8 m",
    normal, cross(r_1, r_2),
    says="Normal to the plane of the center of mass and two elements of the body.",
)

only_rods_have_semidefinite_inertia = Theorem(
    "text 3.8 m",
    part=2,
    says="The product r x x vanishes for the elements on the line through the center of mass that is parallel to x. "
    "Two elements on different lines leave no such x but zero.",
    forms=(
        Iff(
            one=cross(r_C, x_any),
            other=r_C - dot(r_C, x_any) / dot(x_any, x_any) * x_any,
            forth=1 / dot(x_any, x_any) * CPM(x_any),
            back=-CPM(x_any),
        ),
        Definite(
            norm(cross(r_1, x_any)) ** 2 + norm(cross(r_2, x_any)) ** 2,
            squares=(norm(cross(r_1, x_any)) ** 2, norm(cross(r_2, x_any)) ** 2),
            over=(x_any,),
            by=1 / dot(normal, normal) * row(CPM(normal) @ CPM(r_2) - normal @ r_2.T, -CPM(normal) @ CPM(r_1)),
        ),
    ),
    given=(normal_of_two_elements,),
    assuming=(
        nonzero(dot(x_any, x_any), r"\mathbf{x} \neq \mathbf{0}"),
        nonzero(dot(normal, normal), r"\mathbf{n} \neq \mathbf{0}"),
    ),
)

elements_of_a_rod = Definition("text 3.8 n", r_C, arc_of_element * e, says="All elements lie on one line.", sign="=")

null_space_of_the_inertia_of_a_rod = Theorem(
    "text 3.8 o",
    says="The moment of inertia of a rod has a null space spanned by a vector parallel to the rod.",
    forms=(
        Always(I_C, over_body(rho * arc_of_element**2) * (one - e @ e.T)),
        Iff(
            one=I_C @ x_any,
            other=x_any - dot(e, x_any) * e,
            forth=1 / over_body(rho * arc_of_element**2) * one,
            back=over_body(rho * arc_of_element**2) * one,
        ),
    ),
    given=(inertia, elements_of_a_rod),
    assuming=(unit(e), nonzero(over_body(rho * arc_of_element**2))),
)

inertia_with_respect_to_point = Definition(
    "3.131",
    I_A, over_body(rho * (norm(p - a) ** 2 * one - (p - a) @ (p - a).T)),
    says="The moment of inertia with respect to A.",
)

position_from_A = Claim(
    "3.132",
    p - a, r_C - (a - c),
    says="The position of P from A by that from the center of mass.",
    given=(radius,),
)

inertia_with_respect_to_point_substituted = Claim(
    "text 3.8 p",
    I_A,
    over_body(rho * (norm(r_C - (a - c)) ** 2 * one - (r_C - (a - c)) @ (r_C - (a - c)).T)),
    says="The moment of inertia with respect to A, the position from the center of mass substituted.",
    given=(inertia_with_respect_to_point, radius),
)

inertia_with_respect_to_point_expanded = Claim(
    "text 3.8 q",
    I_A,
    over_body(rho * (norm(r_C) ** 2 * one - r_C @ r_C.T))
    + 2 * (-over_body(r_C.T * rho)) @ (a - c) * one
    + (a - c) @ over_body(r_C.T * rho)
    + paren(over_body(r_C * rho)) @ (a - c).T
    + over_body(rho * (norm(a - c) ** 2 * one - (a - c) @ (a - c).T)),
    says="The moment of inertia with respect to A, the position from the center of mass substituted, expanded.",
    given=(inertia_with_respect_to_point_substituted,),
)

inertia_about_point = Claim(
    "3.133a",
    I_A, I_C + m * (norm(a - c) ** 2 * one - (a - c) @ (a - c).T),
    says="Steiner's theorem: the moment of inertia with respect to A from that at the center of mass.",
    given=(inertia_with_respect_to_point_expanded, inertia, radius, center_of_mass, first_moment, mass),
    kernel=Kernel(of=(I_C, m, c, a), symmetric=(I_C, I_A), expected=inertia_and_mass),
)

product_of_cross_product_matrices = Claim(
    "2.39",
    CPM(v_any) @ CPM(v_any).T, norm(v_any) ** 2 * one - v_any @ v_any.T,
    says="What Steiner's theorem takes from this equation: a cross-product matrix times its transpose.",
)

inertia_about_point_by_matrices = Claim(
    "3.133b",
    I_A, I_C + m * (A - C) @ (A - C).T,
    says="Steiner's theorem with cross-product matrices.",
    given=(inertia_about_point,),
)

newton = Postulate("3.134a", force, m * rate(rate(c)), says="The Newton equation.")

euler = Postulate(
    "3.134b", moment_C, I_C @ rate(omega) + cross(omega, I_C @ omega), says="The Euler equation."
)

momentum_of_body = Definition("3.135", momentum, m * rate(c), says="The momentum.")

angular_momentum_of_body = Definition("3.135", h_C, I_C @ omega, part=2, says="The angular momentum.")

inertia_turns_with_the_body = Claim(
    "text 3.8 r",
    rate(I_C), Omega @ I_C - I_C @ Omega,
    says="The rate of the moment of inertia.",
    given=(inertia, radius, velocity_from_center_of_mass, angular_velocity_matrix_of_vector),
)

rate_of_momentum = Claim(
    "3.136",
    rate(momentum), m * rate(rate(c)),
    says="The rate of the momentum.",
    given=(momentum_of_body,),
)

rate_of_angular_momentum = Claim(
    "3.136",
    rate(h_C), I_C @ rate(omega) + cross(omega, I_C @ omega),
    part=2,
    says="The rate of the angular momentum.",
    given=(angular_momentum_of_body, inertia_turns_with_the_body, angular_velocity_matrix_of_vector),
)

newton_by_momentum = Claim(
    "3.137",
    force, rate(momentum),
    says="The Newton equation: the force is the rate of the momentum.",
    given=(rate_of_momentum,),
    restates=newton,
)

euler_by_angular_momentum = Claim(
    "3.137",
    moment_C, rate(h_C),
    part=2,
    says="The Euler equation: the moment is the rate of the angular momentum.",
    given=(rate_of_angular_momentum,),
    restates=euler,
)

inertia_dyad_at_center_of_mass = Definition(
    "3.138", M, matrix((I_C, O), (O, m * one)), says="The inertia dyad of the body."
)

angular_velocity_dyad = Definition(
    "3.140", W_dyad, matrix((Omega, O), (O, O)), says="The angular-velocity dyad of the body."
)

twist_at_center_of_mass = Definition(
    "text 3.8 s", t, column(omega, rate(c)), says="The twist is that at the center of mass."
)

wrench_at_center_of_mass = Definition(
    "text 3.8 s", w, column(moment_C, force), part=2, says="The wrench acts at the center of mass."
)

_dyads = (
    inertia_dyad_at_center_of_mass,
    angular_velocity_dyad,
    angular_velocity_matrix_of_vector,
    twist_at_center_of_mass,
)

newton_euler_by_dyads = Claim(
    "3.139",
    M @ rate(t) + W_dyad @ M @ t, w,
    says="The Newton-Euler equations by dyads.",
    given=(*_dyads, wrench_at_center_of_mass),
    restates=(euler, newton),
    by=-1,
)

twist_is_in_null_space = Claim(
    "3.141",
    W_dyad @ t, zero_6,
    says="The twist lies in the null space of the angular-velocity dyad.",
    given=_dyads[1:],
)

momentum_screw_of_body = Definition(
    "3.142",
    mu, column(I_C @ omega, m * rate(c)),
    says="The momentum screw of the body about the center of mass.",
)

momentum_screw = Claim(
    "3.142",
    column(I_C @ omega, m * rate(c)), M @ t,
    part=2,
    says="The momentum screw by inertia dyad and twist.",
    given=(inertia_dyad_at_center_of_mass, twist_at_center_of_mass),
    kernel=Kernel(of=(I_C, m, t), results=("mu",), symmetric=(I_C,), expected=inertia_and_mass),
)

rate_of_momentum_screw = Claim(
    "3.143",
    rate(mu), M @ rate(t) + W_dyad @ mu,
    says="The rate of the momentum screw.",
    given=(*_dyads, momentum_screw_of_body, inertia_turns_with_the_body),
)

rate_of_momentum_screw_by_twist = Claim(
    "3.143",
    M @ rate(t) + W_dyad @ mu, M @ rate(t) + W_dyad @ M @ t,
    part=2,
    says="The rate of the momentum screw by the twist alone.",
    given=(inertia_dyad_at_center_of_mass, twist_at_center_of_mass, momentum_screw_of_body),
)

energy_by_inertia = Claim(
    "3.144",
    energy, half * m * norm(rate(c)) ** 2 + half * omega.T @ I_C @ omega,
    says="The kinetic energy by the moment of inertia.",
    given=(energy_by_center_of_mass, inertia),
)

inertia_is_definite = definite(I_C)

energy_is_definite = Theorem(
    "text 3.8 t",
    says="The kinetic energy is positive, and vanishes only when the body is stationary: unless the body is a rod.",
    forms=(
        Definite(
            energy,
            squares=(half * m * norm(rate(c)) ** 2, half * (omega.T @ I_C @ omega)),
            over=(rate(c), omega),
            by=Identity(6),
        ),
    ),
    given=(energy_by_inertia,),
    assuming=(mass_is_positive, inertia_is_definite),
)

kinetic_energy = Claim(
    "3.145",
    energy, half * t.T @ M @ t,
    says="The kinetic energy as a quadratic form of the twist.",
    given=(energy_by_inertia, inertia_dyad_at_center_of_mass, twist_at_center_of_mass),
    kernel=Kernel(of=(I_C, m, t), symmetric=(I_C,), expected=inertia_and_mass),
)

newton_euler_by_momentum_screw = Claim(
    "3.146",
    rate(mu), w,
    says="The Newton-Euler equations: the wrench is the rate of the momentum screw.",
    given=(
        rate_of_momentum_screw,
        *_dyads,
        momentum_screw_of_body,
        wrench_at_center_of_mass,
    ),
    restates=(euler, newton),
    by=-1,
)

angular_velocity_in_twist = Claim(
    "text 3.8 u",
    omega, row(one, O) @ t,
    says="The angular velocity is the upper half of the twist.",
    given=(twist_at_center_of_mass,),
)

velocity_in_twist = Claim(
    "text 3.8 u",
    rate(c), row(O, one) @ t,
    part=2,
    says="The velocity of the center of mass is the lower half of the twist.",
    given=(twist_at_center_of_mass,),
)

_motion_by_twist = (
    inertia_dyad_at_center_of_mass,
    angular_velocity_dyad,
    angular_velocity_matrix_of_vector,
    angular_velocity_in_twist,
    velocity_in_twist,
    wrench_at_center_of_mass,
    newton,
    euler,
)

newton_euler_wrench = Claim(
    "text 3.8 v",
    w, M @ rate(t) + W_dyad @ M @ t,
    says="The wrench that moves the body: the Newton-Euler equations as they stand.",
    given=_motion_by_twist,
    kernel=Kernel(of=(I_C, m, t, rate(t)), symmetric=(I_C,), expected=inertia_and_mass),
)

inverse_inertia_dyad = Definition(
    "text 3.8 v",
    M_inv, matrix((Cofactor(I_C).T / det(I_C), O), (O, 1 / m * one)),
    part=2,
    says="The inverse of the inertia dyad.",
    assuming=(nonzero(det(I_C)), mass_is_positive),
)

newton_euler_twist_rate = Claim(
    "text 3.8 v",
    rate(t), M_inv @ (w - W_dyad @ M @ t),
    part=3,
    says="The rate of the twist of a body on which a wrench acts: the Newton-Euler equations solved.",
    given=(inverse_inertia_dyad, *_motion_by_twist),
    kernel=Kernel(of=(I_C, m, t, w), symmetric=(I_C,), expected=(inertia_is_definite,)),
)

rate_of_inertia_dyad = Claim(
    "Ex 3.17",
    rate(M), W_dyad @ M - M @ W_dyad,
    says="The rate of the inertia dyad.",
    given=(inertia_dyad_at_center_of_mass, angular_velocity_dyad, inertia_turns_with_the_body),
)

momentum_screw_by_dyad = Definition("Ex 3.17", mu, M @ t, part=2, says="The momentum screw of the exercise.")

rate_of_momentum_screw_by_rate_of_dyad = Claim(
    "Ex 3.17",
    rate(mu), M @ rate(t) + W_dyad @ M @ t,
    part=3,
    says="The rate of the momentum screw from that of the inertia dyad.",
    given=(
        momentum_screw_by_dyad,
        rate_of_inertia_dyad,
        angular_velocity_dyad,
        angular_velocity_matrix_of_vector,
        twist_at_center_of_mass,
    ),
)

difference_is_skew = Claim(
    "Ex 3.18",
    (rate(M) - 2 * W_dyad @ M).T, -(rate(M) - 2 * W_dyad @ M),
    says="The rate of the inertia dyad less twice the product of the dyads is skew-symmetric.",
    given=(
        rate_of_inertia_dyad,
        inertia_dyad_at_center_of_mass,
        angular_velocity_dyad,
        angular_velocity_matrix_of_vector,
    ),
    assuming=(symmetric(I_C),),
)

velocity_of_center_of_mass_by_matrix = Claim(
    "text 3.8 w",
    rate(c), v_A + Omega @ (c - a),
    says="The velocity of the center of mass, a point of the body, from that of A.",
    given=(position_of_a_point.at({p: c, p_ref: c_ref}), velocity_of_A, angular_velocity_matrix),
    assuming=(Q_is_a_rotation,),
)

velocity_of_center_of_mass = Claim(
    "text 3.8 w",
    rate(c), v_A + cross(a - c, omega),
    part=2,
    says="The velocity of the center of mass from that of A, by the angular velocity.",
    given=(velocity_of_center_of_mass_by_matrix, angular_velocity_matrix_of_vector),
)

twist_at_center_of_mass_from_A = Claim(
    "text 3.8 w",
    t, U @ t_A,
    part=3,
    says="The twist at the center of mass from that at A.",
    given=(
        twist_at_center_of_mass,
        velocity_of_center_of_mass,
        twist_at_landmark,
        twist_transfer_matrix.at({p: c}),
    ),
)

inertia_dyad_moved = Definition(
    "text 3.8 x",
    M_A, U.T @ M @ U,
    says="The inertia dyad at A, congruent to that at the center of mass: Steiner's theorem in dyad form.",
    given=(twist_transfer_matrix.at({p: c}),),
)

energy_by_twist_at_A = Claim(
    "text 3.8 x",
    energy, half * t_A.T @ M_A @ t_A,
    part=2,
    says="The kinetic energy is the same quadratic form of the twist at A, with the inertia dyad at A.",
    given=(
        kinetic_energy,
        twist_at_center_of_mass_from_A,
        inertia_dyad_moved,
        twist_transfer_matrix.at({p: c}),
        inertia_dyad_at_center_of_mass,
    ),
)

inertia_dyad = Claim(
    "3.147",
    M_A, matrix((I_A, m * (C - A)), (m * (C - A).T, m * one)),
    says="The inertia dyad at A.",
    given=(
        inertia_dyad_moved,
        twist_transfer_matrix.at({p: c}),
        inertia_dyad_at_center_of_mass,
        inertia_about_point_by_matrices,
    ),
    kernel=Kernel(of=(I_C, m, c, a), symmetric=(I_C,), expected=inertia_and_mass),
)

inertia_dyad_is_definite = Theorem(
    "text 3.8 y",
    says="The inertia dyad is positive-definite, at whatever point.",
    forms=(
        Definite(
            t_A.T @ M_A @ t_A,
            squares=(omega.T @ I_C @ omega, m * norm(v_A + cross(omega, c - a)) ** 2),
            over=(omega, v_A),
            by=matrix((one, O), (C - A, one)),
        ),
    ),
    given=(inertia_dyad, inertia_about_point_by_matrices, twist_at_landmark),
    assuming=(mass_is_positive, inertia_is_definite),
)

inertia_dyad_with_subscript = Definition(
    "text 3.8 z", M_C, M, says="The inertia dyad at the center of mass, with the subscript that it should have."
)

no_decomposition = Theorem(
    "text 3.8 z",
    part=2,
    says="No matrix P makes the inertia dyad at A that at the center of mass plus m P P^T, unless A is the center of "
    "mass: their difference is indefinite.",
    forms=(
        OnlyWhere(
            left=M_A,
            right=M_C + m * P_dyad @ P_dyad.T,
            by=column(one, C - A),
            squares=(
                2 * m * norm(c - a) ** 2,
                m * tr((P_dyad.T @ column(one, C - A)).T @ (P_dyad.T @ column(one, C - A))),
            ),
        ),
    ),
    given=(
        inertia_dyad,
        inertia_about_point_by_matrices,
        inertia_dyad_with_subscript,
        inertia_dyad_at_center_of_mass,
    ),
    assuming=(mass_is_positive,),
)

matrix_suggested_by_steiner = Definition(
    "text 3.8 z",
    P_dyad, matrix((A - C, O), (O, O)),
    part=3,
    says="The matrix that Steiner's theorem suggests: with it the blocks on the diagonal are right.",
)

steiner_by_dyads = Claim(
    "3.148",
    M_A, M_C + m * P_dyad @ P_dyad.T,
    says="The inertia dyad at A as a definite matrix plus a semidefinite one; no P makes it so unless A is C.",
    given=(
        inertia_dyad,
        inertia_about_point_by_matrices,
        inertia_dyad_with_subscript,
        inertia_dyad_at_center_of_mass,
        matrix_suggested_by_steiner,
    ),
    assuming=(inertia_is_definite,),
)
