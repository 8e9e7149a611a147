"""(3.126) to (3.133): the kinetic energy of a body, its moment of inertia, and Steiner's theorem."""

from chasles.derivations.notation import (
    I_C,
    R_C,
    A,
    C,
    a,
    c,
    m,
    omega,
    one,
    over_body,
    r_C,
    rho,
)
from chasles.derivations.s04_twist import velocity_of_point
from chasles.derivations.s08_dynamics import (
    center_of_mass,
    density_is_positive,
    energy_by_center_of_mass,
    energy_by_inertia,
    energy_in_three_integrals,
    energy_of_body,
    first_moment,
    inertia,
    inertia_about_point,
    inertia_about_point_by_matrices,
    inertia_with_respect_to_point,
    inertia_with_respect_to_point_expanded,
    inertia_with_respect_to_point_substituted,
    integral_of_matrix_vanishes,
    landmark_is_center_of_mass,
    mass,
    mass_is_positive,
    position_from_A,
    radius,
    square_of_cross_product_matrix,
    velocity_from_center_of_mass,
    velocity_from_center_of_mass_by_matrix,
)

from chasles.statements.derivation import Compare, Consider, Derivation, Expand, Factor, Substitute, Take
from chasles.vocabulary import cross, norm, rate

_mass = (radius, center_of_mass, first_moment, mass)

energy_of_a_body = Derivation(
    "3.144",
    to=energy_by_inertia,
    says="The velocity of an element, from that of the center of mass, is put into the integral; the mixed term "
    "vanishes.",
    assuming=(density_is_positive, mass_is_positive),
    steps=(
        Take(velocity_of_point),
        Substitute(landmark_is_center_of_mass),
        Factor(rate(c), cross(omega, r_C), using=(radius,)),
        Compare(velocity_from_center_of_mass, using=(landmark_is_center_of_mass,)),
        Factor(rate(c), R_C @ omega),
        Compare(velocity_from_center_of_mass_by_matrix),
        Take(energy_of_body),
        Substitute(velocity_from_center_of_mass_by_matrix),
        Factor(
            norm(rate(c)) ** 2 * over_body(rho),
            rate(c).T @ over_body(rho * R_C) @ omega,
            omega.T @ over_body(rho * R_C.T @ R_C) @ omega,
        ),
        Compare(energy_in_three_integrals),
        Consider(over_body(rho * R_C)),
        Factor(using=_mass),
        Compare(integral_of_matrix_vanishes),
        Consider(R_C**2),
        Factor(norm(r_C) ** 2 * one, r_C @ r_C.T),
        Compare(square_of_cross_product_matrix),
        Take(energy_in_three_integrals),
        Substitute(integral_of_matrix_vanishes),
        Factor(
            m * norm(rate(c)) ** 2,
            omega.T @ over_body(rho * (norm(r_C) ** 2 * one - r_C @ r_C.T)) @ omega,
            using=(mass,),
        ),
        Compare(energy_by_center_of_mass),
        Factor(m * norm(rate(c)) ** 2, omega.T @ I_C @ omega, using=(inertia,)),
        Compare(energy_by_inertia),
    ),
)

theorem_of_steiner = Derivation(
    "3.133b",
    to=inertia_about_point_by_matrices,
    says="The position from A is put into the moment of inertia; the first moments about the center of mass vanish.",
    assuming=(density_is_positive, mass_is_positive),
    steps=(
        Take(inertia_with_respect_to_point),
        Substitute(position_from_A, using=(radius,)),
        Compare(inertia_with_respect_to_point_substituted),
        Expand(),
        Compare(inertia_with_respect_to_point_expanded, using=(radius,)),
        Factor(
            I_C,
            m * norm(a - c) ** 2 * one,
            m * (a - c) @ (a - c).T,
            using=(inertia, *_mass),
        ),
        Compare(inertia_about_point),
        Factor(I_C, m * (A - C) @ (A - C).T),
        Compare(inertia_about_point_by_matrices),
    ),
)
