"""(3.1) to (3.6): displacements of least magnitude, the theorem of Mozzi and Chasles."""

from chasles.derivations.notation import Q, a, d0, d_A, d_P, d_par, d_perp, e, one, p, p_, p_0
from chasles.derivations.s02_screw import (
    all_displacements_share_one_component,
    body_turns_about_the_landmark,
    displacement,
    displacement_by_positions,
    displacement_in_two_components,
    displacement_of_a_point,
    displacement_of_landmark,
    displacement_rearranged,
    normal_displacement,
    parallel_displacement,
    parallel_displacement_is_shared,
    phi_is_not_zero,
    point_after_displacement,
    pythagoras_of_displacement,
    rotation_from_axis_angle,
    screw_axis_point,
    shared_component,
)

from chasles.statements.derivation import Compare, Consider, Derivation, Factor, Multiply, Solve, Substitute, Take
from chasles.vocabulary import norm

least_displacements = Derivation(
    "Thm 3.2.2",
    to=pythagoras_of_displacement,
    says="A displacement by that of the landmark; its component along the axis, which all points share; what is left "
    "is normal to the axis, and vanishes on one line.",
    assuming=(phi_is_not_zero,),
    steps=(
        Take(body_turns_about_the_landmark),
        Solve(p_),
        Compare(point_after_displacement),
        Take(displacement),
        Substitute(point_after_displacement),
        Compare(displacement_by_positions),
        Compare(displacement_rearranged),
        Factor(d_A, (Q - one) @ (p - a), using=(displacement_of_landmark,)),
        Compare(displacement_of_a_point),
        Multiply(e.T),
        Factor(e.T @ d_A, using=(rotation_from_axis_angle,)),
        Compare(all_displacements_share_one_component),
        Take(parallel_displacement),
        Substitute(all_displacements_share_one_component),
        Factor(d0 * e, using=(shared_component,)),
        Compare(parallel_displacement_is_shared),
        Consider(d_par + d_perp),
        Substitute(parallel_displacement, normal_displacement),
        Factor(d_P),
        Compare(displacement_in_two_components),
        Consider(d_perp),
        Substitute(normal_displacement, displacement_of_a_point),
        Factor((Q - one) @ (p - p_0), using=(rotation_from_axis_angle, displacement_of_landmark, screw_axis_point)),
        Consider(norm(d_P) ** 2),
        Factor(
            d0**2,
            norm(d_perp) ** 2,
            using=(normal_displacement, shared_component, displacement_of_a_point, rotation_from_axis_angle),
        ),
        Compare(pythagoras_of_displacement),
    ),
)
