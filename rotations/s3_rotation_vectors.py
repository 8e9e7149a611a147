"""Section 3: rotation vectors: the exponential and the logarithm of rotations, and their Jacobians."""

from chasles.rotations.notation import *
from chasles.rotations.s1_rotations import (
    R_is_a_rotation,
    angular_velocity,
    angular_velocity_in_body,
    e_is_unit,
)

from chasles.statements import Claim, Definition, Kernel, Section, nonzero, positive, unit
from chasles.vocabulary import CPM, column, cos, cross, det, dot, inverse, norm, number, over, rate, sin, tr, vect
from chasles.vocabulary.expansions import limit, up_to
from chasles.vocabulary.partial import gradient, partial
from chasles.vocabulary.rotation_vectors import exp_of_vector, left_jacobian, right_jacobian

rotation_vectors = Section("3", "Rotation Vectors")

v_turns = nonzero(v_length)
V = CPM(v)
_turn = one + sin(phi) * CPM(e_fixed) + (1 - cos(phi)) * CPM(e_fixed) ** 2

rotation_by_vector = Definition(
    "3.1",
    Q, exp_of_vector(v),
    says="The rotation about the direction of a vector through its length: the exponential of a rotation vector.",
    sign="=",
    assuming=(v_turns,),
    kernel=Kernel(of=(v,), form=one + sin(v_length) / v_length * V + 2 * (sin(v_length / 2) / v_length) ** 2 * V**2),
)

exponential_by_axis_and_angle = Claim(
    "3.2",
    exp_of_vector(phi * e), e @ e.T + cos(phi) * (one - e @ e.T) + sin(phi) * E,
    says="The exponential of an angle along an axis is the rotation about that axis through that angle.",
    assuming=(e_is_unit, positive(phi)),
)

exponential_by_half_the_angle = Claim(
    "3.3",
    Q, one + sin(v_length) / v_length * V + 2 * (sin(v_length / 2) / v_length) ** 2 * V**2,
    says="The exponential, without the difference of nearly equal numbers.",
    given=(rotation_by_vector,),
)

cube_of_cross_product_matrix_of_vector = Claim(
    "3.4",
    V**3, -v_length**2 * V,
    says="Powers of a cross-product matrix end with the second: so the series of the exponential has a sum.",
)

exponential_is_orthogonal = Claim(
    "3.5",
    exp_of_vector(v).T @ exp_of_vector(v), one,
    says="The exponential of a rotation vector is orthogonal.",
    assuming=(v_turns,),
)

exponential_is_proper = Claim(
    "3.6",
    det(exp_of_vector(v)), number(1),
    says="And it mirrors nothing.",
    assuming=(v_turns,),
)

exponential_keeps_its_vector = Claim(
    "3.7",
    exp_of_vector(v) @ v, v,
    says="A rotation vector stays where it is.",
    assuming=(v_turns,),
)

exponential_of_opposite = Claim(
    "3.8",
    exp_of_vector(-v), exp_of_vector(v).T,
    says="The opposite vector turns back.",
    assuming=(v_turns,),
)

exponential_of_turned_vector = Claim(
    "3.9",
    exp_of_vector(R @ v), R @ exp_of_vector(v) @ R.T,
    says="The rotation by a turned vector is the rotation seen from the turned frame.",
    assuming=(v_turns, R_is_a_rotation),
)

trace_of_exponential = Claim(
    "3.10",
    tr(Q), 1 + 2 * cos(v_length),
    says="The angle is the length of the rotation vector.",
    given=(rotation_by_vector,),
)

axial_vector_of_exponential = Claim(
    "3.11",
    vect(Q), sin(v_length) / v_length * v,
    says="The axial vector lies along the rotation vector.",
    given=(rotation_by_vector,),
)

logarithm_of_rotation = Claim(
    "3.12",
    V, over(1, 2) * (v_length / sin(v_length)) * (Q - Q.T),
    says="The logarithm of a rotation that is no half-turn.",
    given=(rotation_by_vector,),
    assuming=(nonzero(sin(v_length)),),
)

rotation_vector_from_axial_vector = Claim(
    "3.13",
    v, v_length / sin(v_length) * vect(Q),
    says="The rotation vector from the rotation and its angle.",
    given=(rotation_by_vector,),
    assuming=(nonzero(sin(v_length)),),
)

rotation_vector_by_axis_and_angle = Definition(
    "3.14",
    v, phi * e,
    says="The rotation vector of an axis and an angle.",
    sign="=",
    assuming=(e_is_unit, positive(phi)),
    kernel=Kernel(of=(e, phi)),
)

rotation_by_quaternion_of_vector = Claim(
    "3.15",
    rotation_by(column(sin(v_length / 2) / v_length * v, cos(v_length / 2))), exp_of_vector(v),
    says="The quaternion of a rotation vector.",
    assuming=(v_turns,),
)

quaternion_from_vector = Definition(
    "3.16",
    q, column(sin(v_length / 2) / v_length * v, cos(v_length / 2)),
    says="The quaternion of a rotation vector, the scalar last.",
    sign="=",
    assuming=(v_turns,),
    kernel=Kernel(of=(v,)),
)

quaternion_from_vector_is_unit = Claim(
    "3.17",
    dot(q, q), number(1),
    says="It is a unit quaternion.",
    given=(quaternion_from_vector,),
)

jacobian_on_the_left = Definition(
    "3.18",
    J, left_jacobian(v),
    says="The left Jacobian of rotations.",
    sign="=",
    assuming=(v_turns,),
    kernel=Kernel(of=(v,), name="left_jacobian"),
)

jacobian_on_the_right = Claim(
    "3.19",
    right_jacobian(v), left_jacobian(-v),
    says="The right Jacobian is the left one of the opposite vector.",
    assuming=(v_turns,),
    kernel=Kernel(of=(v,), name="right_jacobian"),
)

jacobians_are_transposes = Claim(
    "3.20",
    right_jacobian(v), left_jacobian(v).T,
    says="The two Jacobians are each other's transposes.",
    assuming=(v_turns,),
)

left_jacobian_by_right = Claim(
    "3.21",
    left_jacobian(v), exp_of_vector(v) @ right_jacobian(v),
    says="The two Jacobians differ by the rotation.",
    assuming=(v_turns,),
)

left_jacobian_commutes_with_exponential = Claim(
    "3.22",
    left_jacobian(v) @ exp_of_vector(v), exp_of_vector(v) @ left_jacobian(v),
    says="The Jacobian and the rotation may be exchanged.",
    assuming=(v_turns,),
)

left_jacobian_keeps_its_vector = Claim(
    "3.23",
    left_jacobian(v) @ v, v,
    says="The Jacobian leaves the rotation vector where it is.",
    assuming=(v_turns,),
)

exponential_by_left_jacobian = Claim(
    "3.24",
    exp_of_vector(v) - one, V @ left_jacobian(v),
    says="What a rotation changes, by the Jacobian.",
    assuming=(v_turns,),
)

difference_of_jacobians = Claim(
    "3.25",
    left_jacobian(v) - right_jacobian(v), 2 * ((1 - cos(v_length)) / v_length**2) * V,
    says="The two Jacobians differ in their skew-symmetric parts.",
    assuming=(v_turns,),
)

determinant_of_left_jacobian = Claim(
    "3.26",
    det(left_jacobian(v)), 2 * (1 - cos(v_length)) / v_length**2,
    says="The Jacobian is singular at whole turns, and nowhere else.",
    assuming=(v_turns,),
)

inverse_of_left_jacobian = Claim(
    "3.27",
    inverse(left_jacobian(v)),
    one - over(1, 2) * V + (1 - v_length / 2 * (cos(v_length / 2) / sin(v_length / 2))) / v_length**2 * V**2,
    says="The inverse of the left Jacobian, where the angle is no whole number of turns.",
    assuming=(v_turns, nonzero(sin(v_length / 2))),
    kernel=Kernel(of=(v,)),
)

inverse_of_left_jacobian_by_whole_angle = Claim(
    "3.28",
    inverse(left_jacobian(v)),
    one - over(1, 2) * V + (1 / v_length**2 - (1 + cos(v_length)) / (2 * v_length * sin(v_length))) * V**2,
    says="The same by the whole angle, which half-turns are excluded from too.",
    assuming=(v_turns, nonzero(sin(v_length))),
)

inverse_of_right_jacobian = Claim(
    "3.29",
    inverse(right_jacobian(v)),
    one + over(1, 2) * V + (1 - v_length / 2 * (cos(v_length / 2) / sin(v_length / 2))) / v_length**2 * V**2,
    says="The inverse of the right Jacobian.",
    assuming=(v_turns, nonzero(sin(v_length / 2))),
)

rate_of_angle = Claim(
    "3.30",
    rate(v_length), dot(v, rate(v)) / v_length,
    says="The rate of the angle by that of the rotation vector.",
    assuming=(v_turns,),
)

angular_velocity_by_rotation_vector = Claim(
    "3.31",
    omega, left_jacobian(v) @ rate(v),
    says="The left Jacobian gives the angular velocity in the fixed frame from the rate of the rotation vector.",
    given=(angular_velocity, rotation_by_vector),
    kernel=Kernel(of=(v, rate(v))),
)

angular_velocity_in_body_by_rotation_vector = Claim(
    "3.32",
    omega_body, right_jacobian(v) @ rate(v),
    says="The right Jacobian gives the angular velocity in the frame of the body.",
    given=(angular_velocity_in_body, rotation_by_vector),
    kernel=Kernel(of=(v, rate(v))),
)

rate_of_rotation_vector = Claim(
    "3.33",
    rate(v),
    omega - over(1, 2) * cross(v, omega)
    + (1 - v_length / 2 * (cos(v_length / 2) / sin(v_length / 2))) / v_length**2 * cross(v, cross(v, omega)),
    says="Bortz's equation: the rate of a rotation vector by the angular velocity in the fixed frame.",
    given=(angular_velocity_by_rotation_vector,),
    assuming=(v_turns, nonzero(sin(v_length / 2))),
    kernel=Kernel(of=(v, omega)),
)

rate_of_rotation_about_fixed_axis = Claim(
    "3.34",
    rate(_turn), rate(phi) * CPM(e_fixed) @ _turn,
    says="About an axis that stays, the exponential is differentiated like that of a number.",
    assuming=(unit(e_fixed),),
)

derivative_of_turned_vector = Claim(
    "3.35",
    partial(exp_of_vector(v) @ a, v), -exp_of_vector(v) @ CPM(a) @ right_jacobian(v),
    says="The Jacobian of a turned vector by the rotation vector.",
    assuming=(v_turns,),
)

gradient_of_angle = Claim(
    "3.36",
    gradient(norm(v), v), v / v_length,
    says="The gradient of the angle is the axis.",
    assuming=(v_turns,),
)

small_rotation = Claim(
    "3.37",
    exp_of_vector(v), up_to(one + V, v, 2),
    says="A small rotation adds the vector product with its vector.",
    assuming=(v_turns,),
)

rotation_of_second_order = Claim(
    "3.38",
    exp_of_vector(v), up_to(one + V + over(1, 2) * V**2, v, 3),
    says="The same with the terms of the second order.",
    assuming=(v_turns,),
)

jacobian_of_small_rotation = Claim(
    "3.39",
    left_jacobian(v), up_to(one + over(1, 2) * V + over(1, 6) * V**2, v, 3),
    says="The left Jacobian of a small rotation.",
    assuming=(v_turns,),
)

exponential_at_zero = Claim(
    "3.40",
    limit(exp_of_vector(v), v), one,
    says="The exponential has a value where its formula has none.",
)
