"""(3.134) to (3.148): the Newton-Euler equations by dyads, and Steiner's theorem for the inertia dyad."""

from chasles.derivations.notation import I_C, M, W_dyad, c, h_C, momentum, mu, omega, p, t
from chasles.derivations.s03_fixed_point import angular_velocity_matrix_of_vector
from chasles.derivations.s04_twist import twist_transfer_matrix
from chasles.derivations.s08_dynamics import (
    angular_momentum_of_body,
    angular_velocity_dyad,
    energy_by_inertia,
    euler,
    euler_by_angular_momentum,
    inertia_dyad,
    inertia_dyad_at_center_of_mass,
    inertia_dyad_moved,
    inertia_turns_with_the_body,
    kinetic_energy,
    momentum_of_body,
    momentum_screw,
    momentum_screw_of_body,
    newton,
    newton_by_momentum,
    newton_euler_by_dyads,
    newton_euler_by_momentum_screw,
    rate_of_angular_momentum,
    rate_of_momentum,
    rate_of_momentum_screw,
    rate_of_momentum_screw_by_twist,
    steiner_by_dyads,
    twist_at_center_of_mass,
    twist_is_in_null_space,
    wrench_at_center_of_mass,
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
from chasles.vocabulary import cross, rate

_vector = (angular_velocity_matrix_of_vector,)
_dyads = (
    inertia_dyad_at_center_of_mass,
    angular_velocity_dyad,
    angular_velocity_matrix_of_vector,
    twist_at_center_of_mass,
)
_transfer = twist_transfer_matrix.at({p: c})

newton_and_euler_by_dyads = Derivation(
    "3.146",
    to=newton_euler_by_momentum_screw,
    says="The rates of momentum and angular momentum; both laws in one equation of dyads, and by the momentum screw.",
    steps=(
        Take(momentum_of_body),
        Differentiate(),
        Compare(rate_of_momentum),
        Take(angular_momentum_of_body),
        Differentiate(),
        Substitute(inertia_turns_with_the_body),
        Factor(I_C @ rate(omega), cross(omega, I_C @ omega), using=_vector),
        Compare(rate_of_angular_momentum),
        Take(newton),
        Factor(rate(momentum), using=(momentum_of_body,)),
        Compare(newton_by_momentum),
        Take(euler),
        Factor(rate(h_C), using=(angular_momentum_of_body, inertia_turns_with_the_body, *_vector)),
        Compare(euler_by_angular_momentum),
        Consider(W_dyad @ t),
        Substitute(angular_velocity_dyad, twist_at_center_of_mass),
        Expand(),
        Factor(using=_vector),
        Compare(twist_is_in_null_space),
        Take(wrench_at_center_of_mass),
        Substitute(euler, newton),
        Factor(M @ rate(t), W_dyad @ M @ t, using=_dyads),
        Compare(newton_euler_by_dyads),
        Take(momentum_screw_of_body),
        Factor(M @ t, using=_dyads),
        Compare(momentum_screw, using=(momentum_screw_of_body,)),
        Take(momentum_screw_of_body),
        Differentiate(),
        Substitute(inertia_turns_with_the_body),
        Factor(M @ rate(t), W_dyad @ mu, using=(*_dyads, momentum_screw_of_body)),
        Compare(rate_of_momentum_screw),
        Factor(M @ rate(t), W_dyad @ M @ t, using=(*_dyads, momentum_screw_of_body)),
        Compare(rate_of_momentum_screw_by_twist, using=(*_dyads, momentum_screw_of_body, inertia_turns_with_the_body)),
        Take(wrench_at_center_of_mass),
        Substitute(euler, newton),
        Factor(rate(mu), using=(*_dyads, momentum_screw_of_body, inertia_turns_with_the_body)),
        Compare(newton_euler_by_momentum_screw),
    ),
)

kinetic_energy_by_dyads = Derivation(
    "3.145",
    to=kinetic_energy,
    says="The kinetic energy as a quadratic form of the twist.",
    steps=(
        Take(energy_by_inertia),
        Factor(t.T @ M @ t, using=_dyads),
        Compare(kinetic_energy),
    ),
)

steiner_in_dyad_form = Derivation(
    "3.148",
    to=steiner_by_dyads,
    says="The inertia dyad moved from point to point by a congruence.",
    steps=(
        Take(inertia_dyad_moved),
        Substitute(_transfer, inertia_dyad_at_center_of_mass),
        Expand(),
        Compare(inertia_dyad),
        Compare(steiner_by_dyads),
    ),
)
