"""(3.84) to (3.89): the accelerations of a rigid body."""

from chasles.derivations.notation import Omega, W_acc, a, omega, p
from chasles.derivations.s03_fixed_point import angular_velocity_matrix_of_vector
from chasles.derivations.s04_twist import velocity_by_angular_velocity_matrix
from chasles.derivations.s05_acceleration import (
    acceleration_by_differentiation,
    acceleration_by_matrices,
    acceleration_of_point,
    angular_acceleration,
    angular_acceleration_matrix,
    axial_vector_of_acceleration_matrix,
    trace_of_acceleration_matrix,
)

from chasles.statements.derivation import (
    Compare,
    Consider,
    Derivation,
    Differentiate,
    Factor,
    Substitute,
    Take,
    TakeVector,
)
from chasles.vocabulary import cross, norm, rate, tr

_vector = (angular_velocity_matrix_of_vector,)

accelerations_of_a_rigid_body = Derivation(
    "3.89",
    to=acceleration_of_point,
    says="The rate of a velocity, the velocity put in once more; the angular-acceleration matrix by its axial vector "
    "and its trace.",
    steps=(
        Take(angular_velocity_matrix_of_vector),
        Differentiate(),
        TakeVector(),
        Factor(rate(omega)),
        Compare(angular_acceleration),
        Take(angular_acceleration_matrix),
        TakeVector(),
        Factor(rate(omega), using=_vector),
        Compare(axial_vector_of_acceleration_matrix),
        Consider(tr(W_acc)),
        Substitute(angular_acceleration_matrix),
        Factor(norm(omega) ** 2, using=_vector),
        Compare(trace_of_acceleration_matrix),
        Take(velocity_by_angular_velocity_matrix),
        Differentiate(),
        Compare(acceleration_by_differentiation),
        Substitute(velocity_by_angular_velocity_matrix),
        Factor(rate(rate(a)), (rate(Omega) + Omega**2) @ (p - a)),
        Compare(acceleration_by_matrices),
        Factor(
            rate(rate(a)),
            cross(rate(omega), p - a),
            cross(omega, cross(omega, p - a)),
            using=_vector,
        ),
        Compare(acceleration_of_point),
    ),
)
