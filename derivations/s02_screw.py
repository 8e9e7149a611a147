"""Section 3.2: general rigid-body motion and its associated screw."""

from chasles.derivations.notation import *

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
    orthonormal,
    rotation,
    unit,
)
from chasles.vocabulary import (
    CPM,
    PI,
    Entry,
    Kronecker,
    bracket,
    column,
    cos,
    cot,
    cross,
    det,
    dot,
    inverse,
    matrix,
    norm,
    number,
    paren,
    row,
    sin,
)

general_motion = Section("3.2", "General Rigid-Body Motion and Its Associated Screw")

cross_product_matrix = Definition(
    "2.38",
    V_any, CPM(v_any),
    says="The cross-product matrix of v: multiplying by it is taking the vector product with v.",
    kernel=Kernel(of=(v_any,)),
)

rotation_from_axis_angle = Definition(
    "2.49",
    Q, e @ e.T + cos(phi) * (one - e @ e.T) + sin(phi) * E,
    says="The rotation about the axis e through the angle phi.",
    sign="=",
    assuming=(unit(e),),
    kernel=Kernel(of=(e, phi)),
)

body_turns_about_the_landmark = Condition(
    "3.1",
    p_ - a_, Q @ (p - a),
    says="The vector from A to P is turned by the rotation of the body.",
    on=(p_,),
)

point_after_displacement = Claim(
    "3.2",
    p_, a_ + Q @ (p - a),
    says="Where a point of the body lies after the displacement.",
    given=(body_turns_about_the_landmark,),
    kernel=Kernel(of=(Q, a, a_, p), expected=(rotation(Q),)),
)

displacement_of_landmark = Definition("3.3", d_A, a_ - a, says="The displacement of A.")

displacement = Definition("3.3", d_P, p_ - p, part=2, says="The displacement of P.")

displacement_by_positions = Claim(
    "3.4",
    d_P, a_ - p + Q @ (p - a),
    says="The displacement of P by the positions of A.",
    given=(displacement, point_after_displacement),
)

displacement_rearranged = Claim(
    "3.4",
    d_P, a_ - a - p + Q @ (p - a) + a,
    part=2,
    says="The displacement of P by the positions of A, with a subtracted and added.",
    given=(displacement, point_after_displacement),
)

displacement_of_a_point = Claim(
    "3.4",
    d_P, d_A + paren(Q - one) @ paren(p - a),
    part=3,
    says="The displacement of P is that of A plus what the rotation adds.",
    given=(displacement, displacement_of_landmark, point_after_displacement),
)

relative_displacement = Definition(
    "text 3.2 e",
    d_PA, paren(Q - one) @ paren(p - a),
    says="The displacement of P relative to A, caused by the rotation alone.",
)

axis_is_not_turned = Claim(
    "text 3.2 a",
    Q @ e, e,
    says="A rotation does not turn its own axis.",
    given=(rotation_from_axis_angle,),
)

axis_is_not_turned_back = Claim(
    "text 3.2 b",
    Q.T @ e, e,
    says="The opposite rotation does not turn the axis either.",
    given=(rotation_from_axis_angle,),
)

all_displacements_share_one_component = Claim(
    "3.5",
    e.T @ d_P, e.T @ d_A,
    says="All displacements have the same component along the axis of rotation.",
    given=(displacement_of_a_point, rotation_from_axis_angle),
)

shared_component = Definition(
    "3.5", d0, e.T @ d_A, part=2,
    says="The component along the axis of rotation that all displacements share."
)

equal_components_along_the_axis = Theorem(
    "Thm 3.2.1",
    says="The displacements of all points of a rigid body have the same component along the axis of rotation.",
    forms=(Always(e.T @ d_P, e.T @ d_A),),
    given=(displacement_of_a_point, rotation_from_axis_angle),
)

parallel_displacement = Definition(
    "3.6b", d_par, e @ e.T @ d_P,
    says="The component of a displacement along the axis of rotation.", sign="="
)

parallel_displacement_is_shared = Claim(
    "3.6b",
    d_par, d0 * e,
    part=2,
    says="The component of a displacement along the axis of rotation is the same for all points.",
    given=(parallel_displacement, shared_component, displacement_of_a_point, rotation_from_axis_angle),
)

axial_displacement = Definition("3.6b", d_0, d0 * e, part=3, says="The displacement of the points of the screw axis.")

normal_displacement = Definition(
    "3.6b",
    d_perp, (one - e @ e.T) @ d_P,
    part=4,
    says="The component of a displacement normal to the axis of rotation.",
    sign="=",
)

displacement_in_two_components = Claim(
    "3.6a",
    d_P, d_par + d_perp,
    says="A displacement is the sum of its components along and normal to the axis.",
    given=(parallel_displacement, normal_displacement),
)

components_are_orthogonal = Claim(
    "text 3.2 c",
    dot(d_par, d_perp), number(0),
    says="The components of a displacement along and normal to the axis of rotation are at right angles.",
    given=(parallel_displacement, normal_displacement),
    assuming=(unit(e),),
)

pythagoras_of_displacement = Claim(
    "text 3.2 d",
    norm(d_P) ** 2, d0**2 + norm(d_perp) ** 2,
    says="The displacement is least where its normal component vanishes.",
    given=(normal_displacement, shared_component, displacement_of_a_point, rotation_from_axis_angle),
)

pitch_of_screw = Definition(
    "3.7",
    pitch, d0 / phi,
    says="The pitch of the screw: the advance along the axis per radian of rotation.",
    assuming=(nonzero(phi, r"\phi \neq 0"),),
)

pitch_of_motion = Claim(
    "3.7",
    d0 / phi, d_P.T @ e / phi,
    part=2,
    says="The pitch from the displacement of any point.",
    given=(shared_component, displacement_of_a_point, rotation_from_axis_angle),
    assuming=(nonzero(phi, r"\phi \neq 0"),),
    kernel=Kernel(of=(e, phi, d_P)),
)

pitch_of_screw_per_turn = Definition(
    "3.7",
    pitch_per_turn, 2 * PI * d0 / phi,
    part=3,
    says="The pitch in metres per turn.",
    assuming=(nonzero(phi, r"\phi \neq 0"),),
)

screw_of_motion_section = Section("3.2.1", "The Screw of a Rigid-Body Motion")

phi_is_not_zero = nonzero(1 - cos(phi), r"\phi \neq 0")

screw_axis_point_is_nearest = Condition(
    "3.8",
    e.T @ p_0, number(0),
    says="Of all points of the screw axis, P_0 is nearest to the origin.",
    on=(p_0,),
)

axial_displacement_is_not_turned = Claim(
    "text 3.2.1 a",
    paren(Q - one) @ d_0, zero,
    says="The displacement of the points of the screw axis is along the axis of rotation.",
    given=(axial_displacement, rotation_from_axis_angle),
)

screw_axis_moves_along_itself = Condition(
    "3.9a",
    d_0, d_A + paren(Q - one) @ paren(p_0 - a),
    says="The point P_0 is displaced along the screw axis.",
    given=(axial_displacement, shared_component, rotation_from_axis_angle),
    on=(p_0,),
)

singular_equations_of_screw_axis_point = Claim(
    "3.9b",
    paren(Q - one) @ p_0, paren(Q - one) @ a - (one - e @ e.T) @ d_A,
    says="The equations of P_0, whose matrix is singular.",
    given=(axial_displacement, shared_component),
    restates=screw_axis_moves_along_itself,
    by=-1,
)

turning_less_identity_is_singular = Claim(
    "text 3.2.1 b",
    det(Q - one), number(0),
    says="Q - 1 is singular.",
    given=(rotation_from_axis_angle,),
)

screw_axis_matrix = Definition(
    "3.11",
    A_screw, column(Q - one, e.T),
    says="The matrix of the four equations of P_0.",
)

screw_axis_right_side = Definition(
    "3.11",
    b_screw, column(paren(Q - one) @ a - (one - e @ e.T) @ d_A, 0),
    part=2,
    says="The right side of the four equations of P_0.",
)

equations_of_screw_axis_point = Claim(
    "3.10",
    A_screw @ p_0, b_screw,
    says="Four compatible equations for the three coordinates of P_0.",
    given=(screw_axis_matrix, screw_axis_right_side),
    restates=(singular_equations_of_screw_axis_point, screw_axis_point_is_nearest),
)

normal_equations_of_screw_axis_point = Claim(
    "3.12",
    A_screw.T @ A_screw @ p_0, A_screw.T @ b_screw,
    says="The normal equations of P_0.",
    restates=equations_of_screw_axis_point,
    by=A_screw.T,
)

normal_matrix = Claim(
    "3.13",
    A_screw.T @ A_screw, 2 * (1 - cos(phi)) * one - (1 - 2 * cos(phi)) * e @ e.T,
    says="The matrix of the normal equations.",
    given=(screw_axis_matrix, rotation_from_axis_angle),
)

inverse_is_sought_as = Condition(
    "3.14",
    inverse(A_screw.T @ A_screw), alpha * one + beta * e @ e.T,
    says="The inverse is sought as a combination of the same two matrices.",
    given=(screw_axis_matrix, rotation_from_axis_angle),
    assuming=(phi_is_not_zero,),
    on=(alpha, beta),
)

coefficient_of_identity = Claim(
    "3.15",
    alpha, 1 / (2 * (1 - cos(phi))),
    says="The coefficient of the identity in the inverse.",
    given=(screw_axis_matrix, rotation_from_axis_angle, inverse_is_sought_as),
)

coefficient_of_dyad = Claim(
    "3.15",
    beta, (1 - 2 * cos(phi)) / (2 * (1 - cos(phi))),
    part=2,
    says="The coefficient of the dyad e e^T in the inverse.",
    given=(screw_axis_matrix, rotation_from_axis_angle, inverse_is_sought_as),
)

normal_matrix_inverse = Claim(
    "3.16",
    inverse(A_screw.T @ A_screw),
    1 / (2 * (1 - cos(phi))) * one + (1 - 2 * cos(phi)) / (2 * (1 - cos(phi))) * e @ e.T,
    says="The inverse of the matrix of the normal equations.",
    given=(screw_axis_matrix, rotation_from_axis_angle),
    assuming=(phi_is_not_zero,),
    kernel=Kernel(of=(e, phi)),
)

normal_right_side = Claim(
    "3.17",
    A_screw.T @ b_screw, paren(Q - one).T @ bracket(paren(Q - one) @ a - d_A),
    says="The right side of the normal equations.",
    given=(screw_axis_matrix, screw_axis_right_side, rotation_from_axis_angle),
)

screw_axis_point = Claim(
    "3.18",
    p_0, (Q - one).T @ (Q @ a - a_) / (2 * (1 - cos(phi))),
    says="The point of the screw axis nearest the origin.",
    given=(
        rotation_from_axis_angle,
        displacement_of_landmark,
        shared_component,
        axial_displacement,
        screw_axis_point_is_nearest,
        screw_axis_moves_along_itself,
    ),
    assuming=(phi_is_not_zero,),
    kernel=Kernel(
        of=(e, phi, a, a_),
        form=half * (paren(one - e @ e.T) @ paren(a + a_) + cot(phi / 2) * cross(e, a_ - a)),
    ),
)

mozzi_chasles = Theorem(
    "Thm 3.2.2",
    says="The displacements of least magnitude are those of the points of one line, parallel to the axis of rotation, "
    "and they are parallel to that axis.",
    forms=(
        Always(d_P, d_0 + (Q - one) @ (p - p_0)),
        Minimum(of=norm(d_P) ** 2, value=d0**2, over=p, at=p_0 + arc * e, squares=((Q - one) @ (p - p_0),)),
        Iff(
            one=(Q - one) @ (p - p_0),
            other=(one - e @ e.T) @ (p - p_0),
            forth=1 / (2 * (1 - cos(phi))) * (Q - one).T,
            back=Q - one,
        ),
    ),
    given=(
        displacement_of_a_point,
        rotation_from_axis_angle,
        displacement_of_landmark,
        shared_component,
        axial_displacement,
        screw_axis_point,
    ),
)

plucker_section = Section("3.2.2", "The Plücker Coordinates of a Line")

point_on_line = Condition(
    "text 3.2.2 a",
    cross(p_2 - p_1, p - p_1), zero,
    says="P lies on the line through P_1 and P_2.",
    on=(p,),
    solution=p_1 + lam * (p_2 - p_1),
)

line_equation = Claim(
    "3.19",
    cross(p_2 - p_1, p) + cross(p_1, p_2 - p_1), zero,
    says="The equation of the line through two points.",
    restates=point_on_line,
)

line_equation_by_matrices = Claim(
    "text 3.2.2 b",
    paren(P_2 - P_1) @ p + cross(p_1, p_2 - p_1), zero,
    says="The equation of the line through two points, with cross-product matrices.",
    restates=line_equation,
)

homogeneous_line_equation = Claim(
    "3.20",
    row(P_2 - P_1, cross(p_1, p_2 - p_1)) @ column(p, 1), zero,
    says="The equation of the line in homogeneous coordinates.",
    restates=line_equation_by_matrices,
)

plucker_coordinates = Definition(
    "3.21",
    gamma, column(p_2 - p_1, cross(p_1, p_2 - p_1)),
    says="The Plücker coordinates of the line through two points.",
)

points_differ = nonzero(norm(p_2 - p_1), r"\mathbf{p}_1 \neq \mathbf{p}_2")

direction_of_line = Definition(
    "3.22",
    e, (p_2 - p_1) / norm(p_2 - p_1),
    says="The direction of the line through two points.",
    assuming=(points_differ,),
)

moment_of_line = Definition(
    "3.22", n, cross(p_1, e), part=2,
    says="The moment of the line through two points about the origin."
)

plucker_coordinates_normalized = Claim(
    "text 3.2.2 c",
    gamma, norm(p_2 - p_1) * column(e, n),
    says="The Plücker coordinates are a multiple of the normalized ones.",
    given=(plucker_coordinates, direction_of_line, moment_of_line),
)

plucker_line = Definition(
    "3.23",
    kappa, column(e, n),
    says="The Plücker array of a line: its direction and its moment.",
    sign="=",
    given=(direction_of_line, moment_of_line),
    kernel=Kernel(of=(p_1, p_2)),
)

direction_is_unit = Claim(
    "3.24",
    dot(e, e), number(1),
    says="The direction of a line is a unit vector.",
    given=(direction_of_line,),
)

moment_is_normal = Claim(
    "3.24",
    dot(n, e), number(0),
    part=2,
    says="The moment of a line is normal to its direction.",
    given=(moment_of_line,),
)

moment_about_A = Definition("3.25", n_A, cross(p - a, e), says="The moment of a line about A.")

moment_about_B = Definition("3.25", n_B, cross(p - b, e), part=2, says="The moment of a line about B.")

plucker_array_at_A = Definition("3.26", kappa_A, column(e, n_A), says="The Plücker array with the moment about A.")

plucker_array_at_B = Definition(
    "3.26", kappa_B, column(e, n_B), part=2, says="The Plücker array with the moment about B."
)

moments_about_two_points = Claim(
    "3.27",
    n_B - n_A, cross(a - b, e),
    says="How the moment of a line changes with the point about which it is taken.",
    given=(moment_about_A, moment_about_B),
)

plucker_array_moved = Claim(
    "3.28",
    kappa_B, column(e, n_A + cross(a - b, e)),
    says="The Plücker array with the moment about B from that about A.",
    given=(plucker_array_at_B, moment_about_A, moment_about_B),
)

plucker_transfer_matrix = Definition(
    "3.29b",
    U, matrix((one, O), (A - B, one)),
    says="The matrix that transfers Plücker coordinates from A to B.",
)

plucker_transfer = Claim(
    "3.29a",
    kappa_B, U @ kappa_A,
    says="The Plücker-coordinate transfer formula.",
    given=(plucker_array_at_A, plucker_array_at_B, moment_about_A, moment_about_B, plucker_transfer_matrix),
    kernel=Kernel(of=(kappa_A, a, b)),
)

transfer_is_unimodular = Claim(
    "3.30",
    det(U), number(1),
    says="The transfer matrix has determinant one.",
    given=(plucker_transfer_matrix,),
)

transfer_inverse = Claim(
    "3.31",
    inverse(U), matrix((one, O), (B - A, one)),
    says="The inverse transfer is the transfer back.",
    given=(plucker_transfer_matrix,),
)

moments_share_a_component = Claim(
    "3.32",
    paren(a - b).T @ n_B, paren(a - b).T @ n_A,
    says="The moments about two points have the same component along the line that joins them.",
    restates=moments_about_two_points,
    by=paren(a - b).T,
)

line_at_infinity = Definition(
    "3.33",
    kappa_inf, column(zero, f),
    says="The Plücker array of a line at infinity.",
    sign="=",
)

pose_section = Section("3.2.3", "The Pose of a Rigid Body")

pose = Definition("3.34", s, column(q, q_0, d_A), says="The pose of a rigid body.")

euler_rodrigues_vector = Definition("text 3.2.3 a", q, sin(phi / 2) * e, says="Euler-Rodrigues parameters: the vector.")

euler_rodrigues_scalar = Definition(
    "text 3.2.3 a", q_0, cos(phi / 2), part=2, says="Euler-Rodrigues parameters: the scalar."
)

linear_vector = Definition("text 3.2.3 b", q, paren(sin(phi)) * e, says="Linear invariants: the vector.")

linear_scalar = Definition("text 3.2.3 b", q_0, cos(phi), part=2, says="Linear invariants: the scalar.")

natural_vector = Definition("text 3.2.3 c", q, e, says="Natural invariants: the axis.")

natural_scalar = Definition("text 3.2.3 c", q_0, phi, part=2, says="Natural invariants: the angle.")

euler_rodrigues_constraint = Claim(
    "3.35",
    norm(q) ** 2 + q_0**2, number(1),
    says="The constraint on the Euler-Rodrigues parameters.",
    given=(euler_rodrigues_vector, euler_rodrigues_scalar),
    assuming=(unit(e),),
)

linear_constraint = Claim(
    "3.35",
    norm(q) ** 2 + q_0**2, number(1),
    part=2,
    says="The constraint on the linear invariants.",
    given=(linear_vector, linear_scalar),
    assuming=(unit(e),),
)

natural_constraint = Condition(
    "3.36",
    norm(e) ** 2, number(1),
    says="The constraint on the natural invariants.",
    assuming=(unit(e),),
)

triad_is_orthonormal = orthonormal(e_1, e_2, e_3)

first_vector_of_triad = Definition("3.37", e_1, AP_1, says="The first vector of the triad, from A to P_1.")

second_vector_of_triad = Definition("3.37", e_2, AP_2, part=2, says="The second vector of the triad, from A to P_2.")

third_vector_of_triad = Definition("3.37", e_3, AP_3, part=3, says="The third vector of the triad, from A to P_3.")

triad_orthonormality = Condition(
    "3.38",
    dot(e_of[i], e_of[j]), Kronecker(i, j),
    says="The vectors of the triad are orthonormal.",
    assuming=(triad_is_orthonormal,),
)

triad_is_right_handed = Condition(
    "3.38",
    e_3, cross(e_1, e_2),
    part=2,
    says="The triad is right-handed.",
    assuming=(triad_is_orthonormal,),
)

displaced_triad = Definition(
    "text 3.2.3 d",
    e_of_[j], Q @ e_of[j],
    says="The triad is turned with the body.",
)

triad_as_columns = Definition("text 3.2.3 e", triad, row(e_1, e_2, e_3), says="The triad as a matrix.")

displaced_triad_as_columns = Definition(
    "text 3.2.3 e", triad_, row(e_1_, e_2_, e_3_), part=2, says="The displaced triad as a matrix."
)

rotation_components = Definition(
    "text 3.2.3 f",
    Q_in_axes, triad.T @ Q @ triad,
    says="The components of the rotation in the axes of the triad.",
)

rotation_entry = Claim(
    "3.39",
    Entry(Q_in_axes, i, j, "q"), dot(e_of[i], e_of_[j]),
    says="Each component of the rotation is the cosine of the angle between two vectors of the triads.",
    given=(rotation_components, triad_as_columns, displaced_triad),
)

rotation_by_cosines = Claim(
    "3.40",
    Q_in_axes,
    matrix(
        (dot(e_1, e_1_), dot(e_1, e_2_), dot(e_1, e_3_)),
        (dot(e_2, e_1_), dot(e_2, e_2_), dot(e_2, e_3_)),
        (dot(e_3, e_1_), dot(e_3, e_2_), dot(e_3, e_3_)),
    ),
    says="The rotation in the axes of the triad, by the cosines of the angles between the two triads.",
    given=(rotation_components, triad_as_columns, displaced_triad),
)

rotation_in_triad_axes = Claim(
    "text 3.2.3 h",
    Q_in_axes, triad.T @ triad_,
    says="The rotation in the axes of the triad, as a product of matrices.",
    given=(rotation_components, triad_as_columns, displaced_triad_as_columns, displaced_triad),
    kernel=Kernel(of=(triad, triad_), expected=(rotation(triad), rotation(triad_))),
)

rotation_from_triads = Claim(
    "text 3.2.3 g",
    Q, triad_ @ triad.T,
    says="The rotation that takes one triad into the other, in the frame in which both are given.",
    given=(triad_as_columns, displaced_triad_as_columns, displaced_triad),
    assuming=(triad_is_orthonormal,),
    kernel=Kernel(of=(triad, triad_), expected=(rotation(triad), rotation(triad_))),
)
