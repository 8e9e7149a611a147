"""Section 3.7: static analysis of rigid bodies."""

from chasles.derivations.notation import *
from chasles.derivations.s04_twist import (
    screw_array,
    twist,
    twist_transfer,
    twist_transfer_matrix,
)

from chasles.statements import (
    Always,
    Claim,
    Condition,
    Definition,
    Iff,
    Kernel,
    Minimum,
    Section,
    Theorem,
    nonzero,
)
from chasles.vocabulary import CPM, PI, column, cross, dot, inverse, matrix, norm, number, paren

static_analysis = Section("3.7", "Static Analysis of Rigid Bodies")

systems_are_equivalent = Condition(
    "text 3.7 a",
    moment_P + cross(p - p, force), moment_A + cross(a - p, force),
    says="The two systems of force and moment have the same moment about P.",
    on=(moment_P,),
)

moment_about_point = Claim(
    "3.106",
    moment_P, moment_A + cross(a - p, force),
    says="The moment about P from that about A.",
    given=(systems_are_equivalent,),
)

moment_about_point_by_force = Claim(
    "3.107",
    moment_P, moment_A + cross(force, p - a),
    says="The moment about P from that about A, in the form of the velocities of a rigid body.",
    given=(moment_about_point,),
)

force_is_not_zero = nonzero(norm(force), r"\mathbf{f} \neq \mathbf{0}")

least_moment_vector = Definition(
    "3.108",
    n_0, n0 * (force / norm(force)),
    says="The moment of least magnitude, parallel to the force.",
    sign="=",
    assuming=(force_is_not_zero,),
)

least_moment = Definition(
    "3.108",
    n0, dot(moment_P, force) / norm(force),
    part=2,
    says="The signed magnitude of the moment of least magnitude.",
    assuming=(force_is_not_zero,),
)

pitch_of_wrench = Definition(
    "3.109",
    pitch__, n0 / norm(force),
    says="The pitch of the wrench, in metres per radian.",
    assuming=(force_is_not_zero,),
)

pitch_of_wrench_by_moment = Claim(
    "3.109",
    n0 / norm(force), dot(moment_P, force) / norm(force) ** 2,
    part=2,
    says="The pitch from the moment about any point.",
    given=(least_moment,),
)

pitch_of_wrench_per_turn = Definition(
    "3.109",
    pitch_per_turn__, dot(2 * PI * moment_P, force) / norm(force) ** 2,
    part=3,
    says="The pitch of the wrench, in metres per turn.",
    sign="=",
    assuming=(force_is_not_zero,),
)

axis_of_wrench = Definition("3.110", axis__, column(e__, n__), says="The Plücker array of the axis of the wrench.")

direction_of_wrench = Definition(
    "3.110",
    e__, force / norm(force),
    part=2,
    says="The direction of the axis of the wrench.",
    sign="=",
    assuming=(force_is_not_zero,),
)

moment_of_wrench_axis = Definition(
    "3.110",
    n__, cross(p, e__),
    part=3,
    says="The moment of the axis of the wrench about the origin.",
    sign="=",
)

wrench_point_is_nearest = Condition(
    "text 3.7 b",
    dot(force, p_0__), number(0),
    says="Of all points of the axis of the wrench, P_0'' is nearest to the origin.",
    on=(p_0__,),
)

wrench_point_is_on_axis = Condition(
    "text 3.7 c",
    cross(force, moment_A + cross(force, p_0__ - a)), zero,
    says="The moment about P_0'' is parallel to the force.",
    on=(p_0__,),
    assuming=(force_is_not_zero,),
)

wrench_point = Claim(
    "3.111",
    p_0__, cross(1 / norm(force) ** 2 * force, moment_A - cross(force, a)),
    says="The point of the axis of the wrench nearest the origin.",
    given=(wrench_point_is_nearest, wrench_point_is_on_axis),
)

least_moment_on_one_line = Theorem(
    "Thm 3.7.1",
    says="The moment is least if the force is applied at any point of one line, parallel to the force, and that moment "
    "is parallel to the force.",
    forms=(
        Always(moment_P, dot(moment_A, force) / norm(force) ** 2 * force + cross(force, p - p_0__)),
        Minimum(
            of=norm(moment_P) ** 2,
            value=(dot(moment_A, force) / norm(force)) ** 2,
            over=p,
            at=p_0__ + arc_by_force * force,
            squares=(cross(force, p - p_0__),),
        ),
        Iff(
            one=cross(force, p - p_0__),
            other=p - p_0__ - dot(force, p - p_0__) / norm(force) ** 2 * force,
            forth=-(1 / norm(force) ** 2) * CPM(force),
            back=CPM(force),
        ),
    ),
    given=(moment_about_point_by_force, wrench_point),
)

equal_projections_on_wrench_axis = Theorem(
    "Thm 3.7.2",
    says="The moments about all points have the same projection onto the axis of the wrench.",
    forms=(Always(dot(moment_P, e__), dot(moment_A, e__)),),
    given=(moment_about_point_by_force, direction_of_wrench),
)

_direction = force / norm(force)

wrench_axis = Claim(
    "text 3.7 d",
    column(column(e__, n__), pitch__),
    column(
        column(force / norm(force), cross(p_0__, force / norm(force))), dot(moment_A, force) / norm(force) ** 2
    ),
    says="The axis and the pitch of the wrench.",
    given=(
        direction_of_wrench,
        moment_of_wrench_axis.at({p: p_0__}),
        pitch_of_wrench,
        least_moment,
        moment_about_point_by_force,
        wrench_point,
    ),
    kernel=Kernel(
        of=(force, moment_A, a),
        results=("axis", "pitch"),
        form=column(
            column(
                _direction,
                cross(cross(_direction, moment_A / norm(force)) + a, _direction),
            ),
            dot(_direction, moment_A / norm(force)),
        ),
    ),
)

exchange_of_halves = Definition(
    "3.112",
    Gamma, matrix((O, one), (one, O)),
    says="The matrix that exchanges the halves of a six-dimensional array.",
)

wrench_of_screw = Definition(
    "text 3.7 e",
    w, amplitude * Gamma @ screw,
    says="The wrench: the screw times an amplitude, its halves exchanged.",
)

wrench_of_screw_by_moment_and_force = Claim(
    "text 3.7 e",
    amplitude * Gamma @ screw, column(cross(p, paren(amplitude * e)) + pitch * paren(amplitude * e), amplitude * e),
    part=2,
    says="The moment of a force along a line and a moment parallel to it; and that force.",
    given=(exchange_of_halves, screw_array),
    sign=r"\equiv",
)

force_of_screw = Definition("text 3.7 f", force, amplitude * e, says="The force of the wrench along its axis.")

moment_of_screw = Definition(
    "text 3.7 f",
    moment, cross(p, force) + pitch * force,
    part=2,
    says="The moment of the wrench about the origin, of a force along its axis and a moment parallel to it.",
)

wrench = Definition("3.113", w, column(moment, force), says="The wrench: moment and force.")

wrench_of_screw_is_a_wrench = Claim(
    "text 3.7 g",
    amplitude * Gamma @ screw, w,
    says="The two definitions of the wrench agree.",
    given=(exchange_of_halves, screw_array, wrench, force_of_screw, moment_of_screw),
)

elementary_power = Definition(
    "text 3.7 h",
    power_, dot(moment, omega) + dot(force, v),
    says="The power of a moment and of a force on a moving body.",
)

power = Claim(
    "3.114",
    power_, t.T @ w,
    says="The power developed by a wrench on a body that moves with a twist at the same point.",
    given=(elementary_power, twist, wrench),
    kernel=Kernel(of=(t, w)),
)

wrench_by_screw = Definition(
    "3.115",
    w, amplitude_of_wrench * Gamma @ s_w,
    says="A wrench by its screw and its amplitude.",
    sign="=",
)

twist_by_screw = Definition(
    "3.115",
    t, amplitude_of_twist * s_t,
    part=2,
    says="A twist by its screw and its amplitude.",
    sign="=",
)

power_by_screws = Claim(
    "text 3.7 i",
    t.T @ w, amplitude_of_twist * amplitude_of_wrench * (paren(Gamma @ s_w).T @ s_t),
    says="The power vanishes with the product of the screws of wrench and twist.",
    given=(wrench_by_screw, twist_by_screw),
)

product_of_screws = Claim(
    "3.116",
    paren(Gamma @ s_w).T @ s_t, s_w.T @ Gamma.T @ s_t,
    says="The product of the screws of wrench and twist, its transpose multiplied out.",
    sign=r"\equiv",
)

screws_are_reciprocal = Condition(
    "3.116",
    s_w.T @ Gamma.T @ s_t, number(0),
    part=2,
    says="Two screws are reciprocal.",
    given=(exchange_of_halves,),
    on=(s_t,),
)

exchange_is_symmetric = Claim(
    "text 3.7 j",
    Gamma.T, Gamma,
    says="The matrix that exchanges the halves is symmetric.",
    given=(exchange_of_halves,),
)

screws_are_reciprocal_by_symmetry = Claim(
    "3.117",
    s_w.T @ Gamma @ s_t, number(0),
    says="Two screws are reciprocal.",
    given=(exchange_of_halves,),
    restates=screws_are_reciprocal,
)

screws_are_reciprocal_both_ways = Claim(
    "3.117",
    s_t.T @ Gamma @ s_w, number(0),
    part=2,
    says="Two screws that are reciprocal are so in the other order.",
    given=(exchange_of_halves,),
    restates=screws_are_reciprocal,
)

reciprocal_product = Claim(
    "text 3.7 k",
    s_t.T @ Gamma @ s_w, s_w.T @ Gamma @ s_t,
    says="The reciprocal product of two screws, in either order.",
    given=(exchange_of_halves,),
    kernel=Kernel(of=(s_w, s_t), results=("product",)),
)

wrench_at_A = Definition("3.118", w_A, column(moment_A, force), says="The wrench at A.")

wrench_at_P = Definition("3.118", w_P, column(moment_P, force), part=2, says="The wrench at P.")

wrench_transfer_matrix = Definition(
    "3.119b",
    V, matrix((one, A - P), (O_in_V, one)),
    says="The matrix that transfers a wrench from A to P.",
)

wrench_transfer = Claim(
    "3.119a",
    w_P, V @ w_A,
    says="The wrench-transfer formula.",
    given=(wrench_at_A, wrench_at_P, moment_about_point, wrench_transfer_matrix),
    kernel=Kernel(of=(w_A, a, p)),
)

power_at_another_point = Claim(
    "3.120",
    t_P.T @ w_P, t_A.T @ U.T @ V @ w_A,
    says="The power at P by twist and wrench at A.",
    given=(twist_transfer, wrench_transfer, twist_transfer_matrix, wrench_transfer_matrix),
)

product_of_transfers = Claim(
    "3.121",
    U.T @ V, matrix((one, -A + P), (O_in_V, one)) @ matrix((one, A - P), (O_in_V, one)),
    says="The transpose of the transfer matrix of twists times that of wrenches.",
    given=(twist_transfer_matrix, wrench_transfer_matrix),
)

transfers_cancel = Claim(
    "3.121",
    matrix((one, -A + P), (O_in_V, one)) @ matrix((one, A - P), (O_in_V, one)), one_6,
    part=2,
    says="The transpose of the transfer matrix of twists times that of wrenches is the identity.",
)

power_is_the_same_at_all_points = Claim(
    "text 3.7 l",
    t_P.T @ w_P, t_A.T @ w_A,
    says="The power is the same, wherever the force is assumed to be applied.",
    given=(twist_transfer, wrench_transfer, twist_transfer_matrix, wrench_transfer_matrix),
)

wrench_transfer_inverse = Claim(
    "3.122",
    inverse(V), U.T,
    says="The inverse of the transfer of wrenches is the transpose of that of twists.",
    given=(twist_transfer_matrix, wrench_transfer_matrix),
)
