"""(3.44) to (3.51): the velocities of a rigid body."""

from chasles.derivations.notation import Omega, Q, a, omega, one, p
from chasles.derivations.s03_fixed_point import (
    Q_is_a_rotation,
    angular_velocity,
    angular_velocity_matrix,
    angular_velocity_matrix_of_vector,
)
from chasles.derivations.s04_twist import (
    position_of_a_point,
    relative_velocity_is_perpendicular,
    velocity_by_angular_velocity_matrix,
    velocity_from_reference_configuration,
    velocity_of_point,
)

from chasles.statements.derivation import (
    Compare,
    Consider,
    Derivation,
    Differentiate,
    Expand,
    Factor,
    Substitute,
    Take,
)
from chasles.vocabulary import CPM, cross, dot, rate

velocities_of_a_rigid_body = Derivation(
    "3.51",
    to=relative_velocity_is_perpendicular,
    says="The rate of a position; a rotation's rate is skew-symmetric after the rotation is divided out, so it is a "
    "vector product.",
    assuming=(Q_is_a_rotation,),
    steps=(
        Consider(Q @ Q.T),
        Factor(one),
        Differentiate(),
        Take(angular_velocity_matrix),
        Factor(CPM(omega), using=(angular_velocity, angular_velocity_matrix)),
        Compare(angular_velocity_matrix_of_vector),
        Take(position_of_a_point),
        Differentiate(),
        Compare(velocity_from_reference_configuration),
        Factor(rate(a), Omega @ (p - a), using=(position_of_a_point, angular_velocity_matrix)),
        Compare(velocity_by_angular_velocity_matrix),
        Factor(rate(a), cross(omega, p - a), using=(angular_velocity_matrix_of_vector,)),
        Compare(velocity_of_point),
        Consider(dot(rate(p) - rate(a), p - a)),
        Substitute(velocity_of_point),
        Expand(),
        Factor(),
        Compare(relative_velocity_is_perpendicular),
    ),
)
