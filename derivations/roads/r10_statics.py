"""(3.106) to (3.122): the wrench, its axis, its power, and its transfer from point to point."""

from chasles.derivations.notation import (
    U,
    V,
    a,
    force,
    moment_A,
    moment_P,
    one_6,
    p,
    p_0__,
    t,
    t_P,
    w,
    w_A,
    w_P,
)
from chasles.derivations.s04_twist import twist, twist_transfer, twist_transfer_matrix
from chasles.derivations.s07_statics import (
    elementary_power,
    exchange_is_symmetric,
    exchange_of_halves,
    force_is_not_zero,
    moment_about_point,
    moment_about_point_by_force,
    power,
    power_at_another_point,
    power_is_the_same_at_all_points,
    product_of_transfers,
    screws_are_reciprocal,
    screws_are_reciprocal_by_symmetry,
    systems_are_equivalent,
    wrench,
    wrench_at_A,
    wrench_at_P,
    wrench_point,
    wrench_point_is_nearest,
    wrench_point_is_on_axis,
    wrench_transfer,
    wrench_transfer_inverse,
    wrench_transfer_matrix,
)

from chasles.statements.derivation import Compare, Consider, Derivation, Expand, Factor, Solve, Substitute, Take
from chasles.vocabulary import cross, dot, norm

axis_of_a_wrench = Derivation(
    "3.111",
    to=wrench_point,
    says="Two systems of force and moment are equivalent if they have the same moment about any point; where that "
    "moment is parallel to the force, a point is sought.",
    assuming=(force_is_not_zero,),
    steps=(
        Take(systems_are_equivalent),
        Solve(moment_P),
        Compare(moment_about_point),
        Factor(moment_A, cross(force, p - a)),
        Compare(moment_about_point_by_force),
        Take(wrench_point_is_nearest, wrench_point_is_on_axis),
        Solve(
            p_0__,
            terms=(cross(force, moment_A) / norm(force) ** 2, a, dot(a, force) / norm(force) ** 2 * force),
        ),
        Factor(cross(1 / norm(force) ** 2 * force, moment_A - cross(force, a))),
        Compare(wrench_point),
    ),
)

power_of_a_wrench = Derivation(
    "3.122",
    to=wrench_transfer_inverse,
    says="The power of a wrench is the same wherever the force is assumed to act, because the two transfers cancel.",
    steps=(
        Take(elementary_power),
        Factor(t.T @ w, using=(twist, wrench)),
        Compare(power),
        Take(screws_are_reciprocal),
        Substitute(exchange_is_symmetric, both=True, using=(exchange_of_halves,)),
        Compare(screws_are_reciprocal_by_symmetry),
        Take(wrench_at_P),
        Substitute(moment_about_point),
        Factor(V @ w_A, using=(wrench_at_A, wrench_transfer_matrix)),
        Compare(wrench_transfer),
        Consider(t_P.T @ w_P),
        Substitute(twist_transfer, wrench_transfer),
        Expand(),
        Compare(power_at_another_point),
        Consider(U.T @ V),
        Substitute(twist_transfer_matrix, wrench_transfer_matrix),
        Expand(),
        Factor(one_6),
        Compare(product_of_transfers),
        Take(power_at_another_point),
        Substitute(product_of_transfers, using=(twist_transfer_matrix, wrench_transfer_matrix)),
        Expand(),
        Compare(power_is_the_same_at_all_points),
        Take(product_of_transfers),
        Compare(wrench_transfer_inverse),
    ),
)
