"""(3.91) to (3.97): the rates of the matrices, by differentiation."""

from chasles.derivations.notation import D, E, Omega, R_er, U_lin, e, omega, one, r_0, r_er, u, u_0
from chasles.derivations.s02_screw import phi_is_not_zero
from chasles.derivations.s04_twist import (
    euler_rodrigues_rate_matrix,
    euler_rodrigues_velocity_matrix,
    linear_rate_matrix,
    linear_velocity_matrix,
    natural_velocity_matrix,
    phi_is_not_pi,
    pose_rate_matrix,
    twist_matrix,
)
from chasles.derivations.s05_acceleration import (
    B_is_the_upper_block,
    axis_angle_rates,
    euler_rodrigues_parameters_scalar,
    euler_rodrigues_parameters_vector,
    linear_invariants_scalar,
    linear_invariants_vector,
    natural_rates_by_blocks,
    pose_rate_by_twist,
    rate_of_euler_rodrigues_rate_matrix,
    rate_of_euler_rodrigues_velocity_matrix,
    rate_of_linear_rate_matrix,
    rate_of_linear_rate_matrix_by_velocity,
    rate_of_linear_velocity_matrix,
    rate_of_natural_rate_matrix,
    rate_of_natural_velocity_matrix,
    rate_of_pose_rate_matrix,
    rate_of_twist_matrix,
    scalar_of_linear_rate,
    second_rate_of_pose,
    twist_by_pose_rate,
    twist_rate_from_pose,
    upper_block_of_natural_rate_matrix_rate,
    upper_block_of_natural_rates,
)

from chasles.statements import unit
from chasles.statements.derivation import Compare, Derivation, Differentiate, Factor, Substitute, Take
from chasles.vocabulary import dot, rate, row

second_rates_of_the_pose = Derivation(
    "3.94",
    to=rate_of_twist_matrix,
    says="The relations between pose and twist, differentiated.",
    steps=(
        Take(pose_rate_by_twist),
        Differentiate(),
        Compare(second_rate_of_pose),
        Take(pose_rate_matrix),
        Differentiate(),
        Compare(rate_of_pose_rate_matrix),
        Take(twist_by_pose_rate),
        Differentiate(),
        Compare(twist_rate_from_pose),
        Take(twist_matrix),
        Differentiate(),
        Compare(rate_of_twist_matrix),
    ),
)

rate_of_N = Derivation(
    "3.96a",
    to=rate_of_natural_rate_matrix,
    says="N by its blocks, differentiated; B is what the upper block then must be, by the angular velocity.",
    assuming=(unit(e), phi_is_not_zero),
    steps=(
        Take(B_is_the_upper_block),
        Substitute(upper_block_of_natural_rates),
        Factor(
            dot(e, omega) * one,
            dot(e, omega) * e @ e.T,
            omega @ e.T,
            e @ omega.T,
            Omega,
            dot(e, omega) * E,
            e @ omega.T @ E,
            using=axis_angle_rates,
        ),
        Compare(upper_block_of_natural_rate_matrix_rate),
        Take(natural_rates_by_blocks),
        Differentiate(),
        Compare(rate_of_natural_rate_matrix),
    ),
)

rate_of_L = Derivation(
    "3.96b",
    to=rate_of_linear_rate_matrix_by_velocity,
    says="L differentiated.",
    assuming=(unit(e),),
    steps=(
        Take(linear_rate_matrix),
        Differentiate(),
        Compare(rate_of_linear_rate_matrix),
        Compare(rate_of_linear_rate_matrix_by_velocity),
    ),
)

rate_of_H = Derivation(
    "3.96c",
    to=rate_of_euler_rodrigues_rate_matrix,
    says="H differentiated.",
    assuming=(unit(e),),
    steps=(
        Take(euler_rodrigues_rate_matrix),
        Differentiate(),
        Compare(rate_of_euler_rodrigues_rate_matrix),
    ),
)

rate_of_N_tilde = Derivation(
    "3.97a",
    to=rate_of_natural_velocity_matrix,
    says="The left inverse of N, differentiated.",
    assuming=(unit(e),),
    steps=(
        Take(natural_velocity_matrix),
        Differentiate(),
        Compare(rate_of_natural_velocity_matrix),
    ),
)

rate_of_L_tilde = Derivation(
    "3.97b",
    to=rate_of_linear_velocity_matrix,
    says="The left inverse of L, differentiated.",
    assuming=(unit(e), phi_is_not_pi),
    steps=(
        Take(linear_velocity_matrix),
        Differentiate(),
        Factor(
            rate(U_lin) / D,
            rate(u_0) / D**2 * U_lin,
            rate(u) / D,
            rate(u_0) / D**2 * u,
            using=(linear_invariants_vector, linear_invariants_scalar, scalar_of_linear_rate),
        ),
        Compare(rate_of_linear_velocity_matrix),
    ),
)

rate_of_H_tilde = Derivation(
    "3.97c",
    to=rate_of_euler_rodrigues_velocity_matrix,
    says="The left inverse of H, differentiated.",
    assuming=(unit(e),),
    steps=(
        Take(euler_rodrigues_velocity_matrix),
        Differentiate(),
        Factor(
            row(rate(r_0) * one + rate(R_er), -rate(r_er)),
            using=(euler_rodrigues_parameters_vector, euler_rodrigues_parameters_scalar),
        ),
        Compare(rate_of_euler_rodrigues_velocity_matrix),
    ),
)
