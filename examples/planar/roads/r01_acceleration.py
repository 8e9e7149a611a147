"""(2.6): the acceleration of a point, found by differentiating its velocity."""

from chasles.statements.derivation import Compare, Derivation, Differentiate, Factor, Take
from chasles.vocabulary import rate

from ..notation import E, a, omega, p
from ..s01_displacement import turn
from ..s02_velocity import acceleration_of_point, angular_velocity, point_of_moving_body, velocity_of_point

acceleration_by_differentiation = Derivation(
    "2.6",
    to=acceleration_of_point,
    says="The rate of a velocity, the velocity put in once more.",
    steps=(
        Take(velocity_of_point),
        Differentiate(),
        Factor(
            rate(rate(a)), rate(omega) * E @ (p - a), omega**2 * (p - a),
            using=(turn, angular_velocity, point_of_moving_body),
        ),
        Compare(acceleration_of_point),
    ),
)
