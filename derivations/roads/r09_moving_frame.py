"""(3.98) to (3.105): motion referred to a moving frame; the Coriolis term and its factor of two."""

from chasles.derivations.notation import Omega, Q, o, rho_M
from chasles.derivations.s03_fixed_point import Q_is_a_rotation, angular_velocity_matrix
from chasles.derivations.s06_moving_frame import (
    acceleration_in_moving_frame_by_differentiation,
    components_turned,
    moving_frame_acceleration,
    moving_frame_velocity,
    position_from_moving_frame,
    position_in_two_parts,
    rate_of_rotation,
    velocity_by_differentiation,
)

from chasles.statements.derivation import (
    Compare,
    Consider,
    Derivation,
    Differentiate,
    Factor,
    Substitute,
    Take,
)
from chasles.vocabulary import rate

accelerations_in_a_moving_frame = Derivation(
    "3.105",
    to=moving_frame_acceleration,
    says="A position in two parts, differentiated twice; each rate of the rotation is replaced.",
    assuming=(Q_is_a_rotation,),
    steps=(
        Consider(rate(Q)),
        Factor(Omega @ Q, using=(angular_velocity_matrix,)),
        Compare(rate_of_rotation),
        Take(position_in_two_parts),
        Substitute(components_turned),
        Compare(position_from_moving_frame),
        Differentiate(),
        Compare(velocity_by_differentiation),
        Substitute(rate_of_rotation),
        Compare(moving_frame_velocity),
        Differentiate(),
        Compare(acceleration_in_moving_frame_by_differentiation),
        Substitute(rate_of_rotation),
        Factor(
            rate(rate(o)),
            (rate(Omega) + Omega**2) @ Q @ rho_M,
            Omega @ Q @ rate(rho_M),
            Q @ rate(rate(rho_M)),
        ),
        Compare(moving_frame_acceleration),
    ),
)
