"""Section 3.3: rotation of a rigid body about a fixed point."""

from chasles.derivations.notation import *

from chasles.statements import Always, Claim, Definition, Kernel, Section, Theorem, rotation
from chasles.vocabulary import CPM, at, cross, dot, number, rate, vect

rotation_about_a_fixed_point = Section("3.3", "Rotation of a Rigid Body About a Fixed Point")

Q_is_a_rotation = rotation(Q)

position_in_rotation = Definition(
    "3.41",
    at(p), at(Q) @ p_ref,
    says="Where a point lies while the body turns about the origin.",
    sign="=",
)

velocity_from_reference = Claim(
    "3.42",
    rate(at(p)), rate(at(Q)) @ p_ref,
    says="The velocity of a point from its reference position.",
    given=(position_in_rotation,),
)

velocity_in_rotation = Claim(
    "3.43",
    rate(p), rate(Q) @ Q.T @ p,
    says="The velocity of a point from where it is now.",
    given=(position_in_rotation,),
    assuming=(Q_is_a_rotation,),
)

angular_velocity_matrix = Definition("3.44", Omega, rate(Q) @ Q.T, says="The angular-velocity matrix.")

angular_velocity_matrix_is_skew = Theorem(
    "Thm 3.3.1",
    says="The angular-velocity matrix is skew-symmetric.",
    forms=(Always(Omega.T, -Omega),),
    given=(angular_velocity_matrix,),
    assuming=(Q_is_a_rotation,),
)

angular_velocity = Definition(
    "3.45",
    omega, vect(Omega),
    says="The angular velocity: the axial vector of the angular-velocity matrix.",
    kernel=Kernel(of=(Omega,), name="axial_vector"),
)

angular_velocity_matrix_of_vector = Claim(
    "text 3.3 a",
    Omega, CPM(omega),
    says="The angular-velocity matrix is the cross-product matrix of the angular velocity.",
    given=(angular_velocity_matrix, angular_velocity),
    assuming=(Q_is_a_rotation,),
)

velocity_by_matrix = Claim(
    "3.46",
    rate(p), Omega @ p,
    says="The velocity of a point by the angular-velocity matrix.",
    given=(position_in_rotation, angular_velocity_matrix),
    assuming=(Q_is_a_rotation,),
)

velocity_by_vector = Claim(
    "3.46",
    Omega @ p, cross(omega, p),
    part=2,
    says="The velocity of a point by the angular velocity.",
    given=(angular_velocity_matrix_of_vector,),
)

velocity_is_normal_to_radius = Claim(
    "text 3.3 b",
    dot(rate(p), p), number(0),
    says="The velocity of a point is perpendicular to the line from the fixed point to it.",
    given=(velocity_by_matrix, angular_velocity_matrix_of_vector),
)
