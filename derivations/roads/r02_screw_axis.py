"""(3.10) to (3.18): the point of the screw axis nearest the origin."""

from chasles.derivations.notation import A_screw, Q, a, a_, alpha, b_screw, beta, e, one, p_0
from chasles.derivations.s02_screw import (
    coefficient_of_dyad,
    coefficient_of_identity,
    displacement_of_landmark,
    equations_of_screw_axis_point,
    inverse_is_sought_as,
    normal_equations_of_screw_axis_point,
    normal_matrix,
    normal_matrix_inverse,
    normal_right_side,
    phi_is_not_zero,
    rotation_from_axis_angle,
    screw_axis_matrix,
    screw_axis_point,
    screw_axis_right_side,
)

from chasles.statements.derivation import (
    Ansatz,
    Compare,
    Consider,
    Derivation,
    Expand,
    Factor,
    Multiply,
    Solve,
    Substitute,
    Take,
)
from chasles.vocabulary import inverse

point_of_the_screw_axis = Derivation(
    "3.18",
    to=screw_axis_point,
    says="Four equations for three coordinates, their normal equations, and the inverse of their matrix.",
    assuming=(phi_is_not_zero,),
    steps=(
        Take(equations_of_screw_axis_point),
        Multiply(A_screw.T),
        Compare(normal_equations_of_screw_axis_point),
        Consider(A_screw.T @ A_screw),
        Substitute(screw_axis_matrix),
        Expand(),
        Factor(one, e @ e.T, using=(rotation_from_axis_angle,)),
        Compare(normal_matrix),
        Ansatz(inverse(A_screw.T @ A_screw), alpha * one + beta * e @ e.T),
        Substitute(normal_matrix, both=True),
        Solve(alpha, beta, using=(rotation_from_axis_angle,)),
        Compare(coefficient_of_identity),
        Compare(coefficient_of_dyad),
        Take(inverse_is_sought_as),
        Substitute(coefficient_of_identity, coefficient_of_dyad),
        Compare(normal_matrix_inverse),
        Consider(A_screw.T @ b_screw),
        Substitute(screw_axis_matrix, screw_axis_right_side),
        Expand(),
        Factor(
            (Q - one).T @ (Q - one) @ a,
            (Q - one).T @ (a_ - a),
            using=(rotation_from_axis_angle, displacement_of_landmark),
        ),
        Compare(normal_right_side, using=(displacement_of_landmark,)),
        Take(normal_equations_of_screw_axis_point),
        Substitute(normal_right_side),
        Solve(p_0, by=normal_matrix_inverse, using=(screw_axis_matrix, rotation_from_axis_angle)),
        Factor((Q - one).T @ (Q @ a - a_), using=(rotation_from_axis_angle, displacement_of_landmark)),
        Compare(screw_axis_point),
    ),
)
