"""(3.77): left inverses of N, L and H. There are many; y tells them apart, and y = 0 is the one by normal equations."""

from chasles.derivations.notation import E, H, H_tilde, L, L_tilde, N, N_tilde, e, omega, one, phi, zero
from chasles.derivations.s02_screw import phi_is_not_zero, rotation_from_axis_angle
from chasles.derivations.s04_twist import (
    angular_velocity_from_euler_rodrigues_rates,
    angular_velocity_from_linear_rates,
    angular_velocity_from_natural_rates,
    euler_rodrigues_rate_matrix,
    euler_rodrigues_rates,
    euler_rodrigues_velocity_matrix,
    linear_rate_matrix,
    linear_rates,
    linear_velocity_matrix,
    natural_rate_matrix,
    natural_rates,
    natural_velocity_matrix,
    phi_is_not_pi,
)

from chasles.statements import unit
from chasles.statements.derivation import (
    Ansatz,
    Compare,
    Consider,
    Derivation,
    Factor,
    Multiply,
    Solve,
    Substitute,
    Take,
)
from chasles.vocabulary import Identity, column, cos, row, scalar, sin

x_1 = scalar("x_1", "x_1", "coefficient of the identity in the left block")
x_2 = scalar("x_2", "x_2", "coefficient of e e^T in the left block")
x_3 = scalar("x_3", "x_3", "coefficient of E in the left block")
x_4 = scalar("x_4", "x_4", "coefficient of e in the last column")
y = scalar("y", "y", "what the left inverse makes of the invariants' constraint, along e")

_sought = row(x_1 * one + x_2 * e @ e.T + x_3 * E, x_4 * e)
_four = Identity(4)
_of_natural = column(e, 0)
_of_linear = column(sin(phi) * e, cos(phi))
_of_euler_rodrigues = column(sin(phi / 2) * e, cos(phi / 2))

left_inverses_of_N = Derivation(
    "3.77b",
    to=angular_velocity_from_natural_rates,
    says="A left inverse of N is sought by four coefficients: since e . e_dot = 0, it may make anything of [e; 0]. "
    "What N and it leave of the identity is a multiple of that row.",
    assuming=(unit(e), phi_is_not_zero),
    steps=(
        Ansatz(N_tilde, _sought, such_that=(N_tilde @ row(N, _of_natural), row(one, y * e))),
        Substitute(natural_rate_matrix, both=True),
        Solve(x_1, x_2, x_3, x_4),
        Substitute(),
        Compare(natural_velocity_matrix, free=(y,)),
        Consider(_four - N @ N_tilde),
        Substitute(natural_rate_matrix, natural_velocity_matrix),
        Factor(_of_natural @ _of_natural.T, column(zero, 1) @ _of_natural.T),
        Take(natural_rates),
        Multiply(N_tilde),
        Factor(omega, using=(natural_rate_matrix, natural_velocity_matrix)),
        Compare(angular_velocity_from_natural_rates),
    ),
)

left_inverse_of_N_by_normal_equations = Derivation(
    "3.77b",
    to=natural_velocity_matrix,
    says="The left inverse that the approach to (3.65) gives, which the text announces: (N^T N)^-1 N^T.",
    assuming=(unit(e), phi_is_not_zero),
    steps=(
        Ansatz(N_tilde, _sought, such_that=(N_tilde @ row(N, _of_natural), row(one, zero))),
        Substitute(natural_rate_matrix, both=True),
        Solve(x_1, x_2, x_3, x_4),
        Substitute(),
        Compare(natural_velocity_matrix),
        Multiply(N.T @ N),
        Factor(N.T, using=(natural_rate_matrix,)),
    ),
)

left_inverses_of_L = Derivation(
    "3.77c",
    to=angular_velocity_from_linear_rates,
    says="A left inverse of L may make anything of the linear invariants themselves, whose squares add up to one.",
    assuming=(unit(e), phi_is_not_pi),
    steps=(
        Ansatz(L_tilde, _sought, such_that=(L_tilde @ row(L, _of_linear), row(one, y * e))),
        Substitute(linear_rate_matrix, both=True),
        Substitute(rotation_from_axis_angle, both=True),
        Solve(x_1, x_2, x_3, x_4),
        Substitute(),
        Compare(linear_velocity_matrix, free=(y,)),
        Factor(one, e @ e.T, E, e),
        Compare(linear_velocity_matrix),
        Consider(_four - L @ L_tilde),
        Substitute(linear_rate_matrix, linear_velocity_matrix),
        Factor(_of_natural @ _of_linear.T, column(zero, 1) @ _of_linear.T, using=(rotation_from_axis_angle,)),
        Take(linear_rates),
        Multiply(L_tilde),
        Factor(omega, using=(linear_rate_matrix, linear_velocity_matrix, rotation_from_axis_angle)),
        Compare(angular_velocity_from_linear_rates),
    ),
)

left_inverse_of_L_by_normal_equations = Derivation(
    "3.77c",
    to=linear_velocity_matrix,
    says="The left inverse of L that the approach to (3.65) gives: (L^T L)^-1 L^T.",
    assuming=(unit(e), phi_is_not_pi),
    steps=(
        Ansatz(L_tilde, _sought, such_that=(L_tilde @ row(L, _of_linear), row(one, zero))),
        Substitute(linear_rate_matrix, both=True),
        Substitute(rotation_from_axis_angle, both=True),
        Solve(x_1, x_2, x_3, x_4),
        Substitute(),
        Compare(linear_velocity_matrix),
        Multiply(L.T @ L),
        Factor(L.T, using=(linear_rate_matrix, rotation_from_axis_angle)),
    ),
)

left_inverses_of_H = Derivation(
    "3.77d",
    to=angular_velocity_from_euler_rodrigues_rates,
    says="A left inverse of H may make anything of the Euler-Rodrigues parameters themselves; the one by normal "
    "equations, (H^T H)^-1 H^T, makes nothing of them.",
    assuming=(unit(e),),
    steps=(
        Ansatz(H_tilde, _sought, such_that=(H_tilde @ row(H, _of_euler_rodrigues), row(one, y * e))),
        Substitute(euler_rodrigues_rate_matrix, both=True),
        Solve(x_1, x_2, x_3, x_4),
        Substitute(),
        Compare(euler_rodrigues_velocity_matrix, free=(y,)),
        Multiply(H.T @ H),
        Factor(H.T, using=(euler_rodrigues_rate_matrix,)),
        Consider(_four - H @ H_tilde),
        Substitute(euler_rodrigues_rate_matrix, euler_rodrigues_velocity_matrix),
        Factor(_of_euler_rodrigues @ _of_euler_rodrigues.T),
        Take(euler_rodrigues_rates),
        Multiply(H_tilde),
        Factor(omega, using=(euler_rodrigues_rate_matrix, euler_rodrigues_velocity_matrix)),
        Compare(angular_velocity_from_euler_rodrigues_rates),
    ),
)
