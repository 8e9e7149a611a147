"""(3.57) to (3.70): the instant screw."""

from chasles.derivations.notation import A_isa, Omega, a, b_isa, omega, one, p, p_0_
from chasles.derivations.s03_fixed_point import angular_velocity_matrix_of_vector
from chasles.derivations.s04_twist import (
    axial_velocity_of_landmark,
    axial_velocity_of_landmark_by_dot,
    equation_of_instant_screw_axis,
    equations_of_instant_screw_point,
    instant_normal_matrix,
    instant_normal_matrix_is_spherical,
    instant_normal_right_side,
    instant_screw_matrix,
    instant_screw_point,
    instant_screw_point_by_matrix,
    instant_screw_right_side,
    landmark_velocity_in_two_components,
    normal_equations_of_instant_screw_point,
    normal_velocity_by_matrix,
    normal_velocity_of_landmark,
    normal_velocity_vanishes,
    omega_is_not_zero,
    square_of_angular_velocity_matrix,
    velocity_by_angular_velocity_matrix,
    velocity_in_two_components,
)

from chasles.statements.derivation import (
    Compare,
    Consider,
    Derivation,
    Expand,
    Factor,
    Multiply,
    Solve,
    Substitute,
    Take,
)
from chasles.vocabulary import cross, dot, norm, rate

_vector = (angular_velocity_matrix_of_vector,)

point_of_the_instant_screw_axis = Derivation(
    "3.70",
    to=instant_screw_point,
    says="The velocity in two components; the normal one vanishes on a line, whose point nearest the origin solves "
    "four equations for three coordinates.",
    assuming=(omega_is_not_zero,),
    steps=(
        Consider(Omega**2),
        Factor(omega @ omega.T, norm(omega) ** 2 * one, using=_vector),
        Compare(square_of_angular_velocity_matrix),
        Take(axial_velocity_of_landmark),
        Factor(dot(rate(a), omega / norm(omega) ** 2) * omega),
        Compare(axial_velocity_of_landmark_by_dot),
        Take(normal_velocity_of_landmark),
        Factor(1 / norm(omega) ** 2 * Omega**2 @ rate(a), using=_vector),
        Compare(normal_velocity_by_matrix, using=(normal_velocity_of_landmark,)),
        Take(velocity_by_angular_velocity_matrix),
        Substitute(landmark_velocity_in_two_components),
        Substitute(axial_velocity_of_landmark, normal_velocity_of_landmark),
        Factor(
            omega @ omega.T / norm(omega) ** 2 @ rate(a),
            1 / norm(omega) ** 2 * Omega**2 @ rate(a),
            Omega @ (p - a),
            using=_vector,
        ),
        Compare(velocity_in_two_components),
        Take(normal_velocity_vanishes),
        Expand(both=True),
        Compare(equation_of_instant_screw_axis),
        Take(equations_of_instant_screw_point),
        Multiply(A_isa.T),
        Compare(normal_equations_of_instant_screw_point),
        Consider(A_isa.T @ A_isa),
        Substitute(instant_screw_matrix),
        Expand(),
        Compare(instant_normal_matrix),
        Factor(norm(omega) ** 2 * one, using=_vector),
        Compare(instant_normal_matrix_is_spherical),
        Consider(A_isa.T @ b_isa),
        Substitute(instant_screw_matrix, instant_screw_right_side),
        Expand(),
        Factor(Omega @ rate(a), Omega**2 @ a, using=_vector),
        Compare(instant_normal_right_side),
        Take(normal_equations_of_instant_screw_point),
        Substitute(instant_normal_matrix_is_spherical, both=True),
        Substitute(instant_normal_right_side),
        Solve(p_0_),
        Compare(instant_screw_point_by_matrix),
        Factor(cross(omega, rate(a) - cross(omega, a)) / norm(omega) ** 2, using=_vector),
        Compare(instant_screw_point),
    ),
)
