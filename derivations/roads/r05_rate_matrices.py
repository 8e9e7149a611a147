"""(3.75) and (3.76): the matrices that give the rates of a rotation's invariants from its angular velocity."""

from chasles.derivations.notation import E, H, L, N, e, omega, phi
from chasles.derivations.s02_screw import phi_is_not_zero, rotation_from_axis_angle
from chasles.derivations.s03_fixed_point import angular_velocity, angular_velocity_matrix
from chasles.derivations.s04_twist import (
    euler_rodrigues_array,
    euler_rodrigues_rate_matrix,
    euler_rodrigues_rates,
    linear_invariants_array,
    linear_rate_matrix,
    linear_rates,
    natural_invariants_array,
    natural_rate_matrix,
    natural_rates,
)

from chasles.statements.derivation import (
    Compare,
    Derivation,
    Differentiate,
    Factor,
    FactorOut,
    Solve,
    Substitute,
    Take,
)
from chasles.vocabulary import cross, rate

_terms = (omega, e @ e.T @ omega, E @ omega, e.T @ omega)
_spin = (
    Take(angular_velocity),
    Substitute(angular_velocity_matrix),
    Substitute(rotation_from_axis_angle),
    Factor(rate(phi) * e, rate(e), cross(e, rate(e)), using=(rotation_from_axis_angle,)),
    Solve(rate(e), rate(phi), terms=_terms),
)
"""The angular velocity by the rates of axis and angle, solved for these."""

rates_of_natural_invariants = Derivation(
    "3.76b",
    to=natural_rate_matrix,
    says="The rates of axis and angle, solved for from the angular velocity of the rotation; their matrix is N.",
    assuming=(phi_is_not_zero, *rotation_from_axis_angle.assuming),
    steps=(
        *_spin,
        Take(natural_invariants_array),
        Differentiate(),
        Substitute(),
        FactorOut(omega),
        Compare(natural_rates),
        FactorOut(omega, named=N),
        Compare(natural_rate_matrix),
    ),
)

rates_of_linear_invariants = Derivation(
    "3.76c",
    to=linear_rate_matrix,
    says="The rates of the linear invariants from those of axis and angle; their matrix is L.",
    assuming=(phi_is_not_zero, *rotation_from_axis_angle.assuming),
    steps=(
        *_spin,
        Take(linear_invariants_array),
        Differentiate(),
        Substitute(),
        Factor(*_terms),
        FactorOut(omega),
        Compare(linear_rates),
        FactorOut(omega, named=L),
        Compare(linear_rate_matrix),
    ),
)

rates_of_euler_rodrigues_parameters = Derivation(
    "3.76d",
    to=euler_rodrigues_rate_matrix,
    says="The rates of the Euler-Rodrigues parameters from those of axis and angle; their matrix is H.",
    assuming=(phi_is_not_zero, *rotation_from_axis_angle.assuming),
    steps=(
        *_spin,
        Take(euler_rodrigues_array),
        Differentiate(),
        Substitute(),
        Factor(*_terms),
        FactorOut(omega),
        Compare(euler_rodrigues_rates),
        FactorOut(omega, named=H),
        Compare(euler_rodrigues_rate_matrix),
    ),
)
