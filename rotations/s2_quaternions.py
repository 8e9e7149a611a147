"""Section 2: Euler-Rodrigues parameters and quaternions."""

from chasles.rotations.notation import *
from chasles.rotations.s1_rotations import (
    Q_is_a_rotation,
    angular_velocity,
    angular_velocity_in_body,
    e_is_unit,
    rotation_about_axis,
)

from chasles.statements import (
    Branch,
    Claim,
    Definition,
    Inverse,
    Kernel,
    Section,
    nonzero,
    perpendicular,
    unit,
    unit_column,
)
from chasles.vocabulary import (
    CPM,
    Node,
    column,
    cos,
    cross,
    det,
    dot,
    inverse,
    norm,
    number,
    over,
    rate,
    row,
    sin,
    tr,
    vect,
)
from chasles.vocabulary.partial import partial
from chasles.vocabulary.products import direct_sum

quaternions = Section("2", "Euler-Rodrigues Parameters and Quaternions")

r_is_unit, p_is_unit, q_is_unit, n_is_unit = unit_column(r, r_0), unit(p), unit(q), unit(n)

euler_rodrigues_vector = Definition(
    "2.1",
    r, sin(phi / 2) * e,
    says="The vector of the Euler-Rodrigues parameters.",
    sign="=",
    assuming=(e_is_unit,),
    kernel=Kernel(of=(e, phi)),
)

euler_rodrigues_scalar = Definition(
    "2.1", r_0, cos(phi / 2), part=2,
    says="The scalar of the Euler-Rodrigues parameters.", sign="="
)

_parameters = (euler_rodrigues_vector, euler_rodrigues_scalar)

euler_rodrigues_parameters_are_unit = Claim(
    "2.2",
    dot(r, r) + r_0**2, number(1),
    says="The four parameters lie on a sphere in four dimensions.",
    given=_parameters,
)

rotation_by_euler_rodrigues_parameters = Claim(
    "2.3",
    Q, (r_0**2 - dot(r, r)) * one + 2 * r @ r.T + 2 * r_0 * CPM(r),
    says="The rotation by the Euler-Rodrigues parameters, without any sine or cosine.",
    given=(rotation_about_axis, *_parameters),
    kernel=Kernel(of=(r, r_0), expected=(r_is_unit,)),
)

rotation_by_parameters_and_matrix = Claim(
    "2.4",
    Q, one + 2 * r_0 * CPM(r) + 2 * CPM(r) ** 2,
    says="The same as a polynomial in the cross-product matrix of the vector.",
    given=(rotation_about_axis, *_parameters),
)

trace_by_euler_rodrigues_parameters = Claim(
    "2.6",
    tr(Q), 4 * r_0**2 - 1,
    says="The trace of a rotation by the scalar.",
    given=(rotation_by_euler_rodrigues_parameters, *_parameters),
)

axial_vector_by_euler_rodrigues_parameters = Claim(
    "2.7",
    vect(Q), 2 * r_0 * r,
    says="The axial vector of a rotation by scalar and vector.",
    given=(rotation_about_axis, *_parameters),
)

vector_of_parameters_stays = Claim(
    "2.8",
    Q @ r, r,
    says="The vector of the Euler-Rodrigues parameters lies along the axis.",
    given=(rotation_about_axis, *_parameters),
)


def _fourfold(parameter: int) -> tuple[Node, Node]:
    """4 r_k r and 4 r_k r_0: the parameters times four times one of them, which is linear in the rotation."""
    if parameter == 0:
        return 2 * vect(Q), 1 + tr(Q)
    axes = (x_axis, y_axis, z_axis)
    here = axes[parameter - 1]
    along = [
        1 + 2 * here.T @ Q @ here - tr(Q) if other is here else other.T @ Q @ here + here.T @ Q @ other
        for other in axes
    ]
    return column(*along), 2 * (here.T @ vect(Q))


_fourfolds = tuple((k, *_fourfold(k), norm(column(*_fourfold(k)))) for k in range(4))

euler_rodrigues_parameters = Inverse(
    "2.9",
    of=rotation_by_euler_rodrigues_parameters,
    says="The Euler-Rodrigues parameters from the rotation, each taken as divisor where it is the largest.",
    assuming=(Q_is_a_rotation,),
    branches=tuple(
        Branch(
            f"by parameter {k}",
            where=length, values=((r, along / length), (r_0, beside / length)), by=length / 16,
        )
        for k, along, beside, length in _fourfolds
    ),
    satisfying=(euler_rodrigues_parameters_are_unit,),
    gives=(r, r_0),
    largest=True,
    sign=(r_0, r),
    kernel=Kernel(of=(Q,), results=("r", "r_0")),
)

quaternion_of_rotation = Definition(
    "2.10",
    q, column(r, r_0),
    says="The Euler-Rodrigues parameters as a quaternion, the scalar last.",
    sign="=",
)

hamilton_product = Claim(
    "2.11",
    times(column(a, s), column(b, t)), column(s * b + t * a + cross(a, b), s * t - dot(a, b)),
    says="Hamilton's product of two quaternions by their scalars and vectors.",
)

product_of_quaternions = Definition(
    "2.12",
    h, times(p, q),
    says="The product of two quaternions.",
    sign="=",
    kernel=Kernel(of=(p, q), name="quaternion_product"),
)

product_from_the_left = Claim(
    "2.13",
    times(p, q), from_left(p) @ q,
    says="The product is linear in the second factor.",
)

product_from_the_right = Claim(
    "2.14",
    times(p, q), from_right(q) @ p,
    says="The product is linear in the first factor.",
)

product_is_associative = Claim(
    "2.15",
    times(times(p, q), h), times(p, times(q, h)),
    says="Brackets in a product of quaternions do not matter.",
)

products_from_both_sides_commute = Claim(
    "2.16",
    from_left(p) @ from_right(q), from_right(q) @ from_left(p),
    says="It does not matter which side is multiplied first.",
)

products_from_the_left_multiply = Claim(
    "2.17",
    from_left(times(p, q)), from_left(p) @ from_left(q),
    says="The matrices of products from the left multiply as the quaternions do.",
)

products_from_the_right_multiply = Claim(
    "2.18",
    from_right(times(p, q)), from_right(q) @ from_right(p),
    says="The matrices of products from the right multiply in the opposite order.",
)

neutral_quaternion = Claim(
    "2.19",
    times(p, neutral), p,
    says="The quaternion of no rotation changes nothing.",
)

conjugate_of_product = Claim(
    "2.20",
    conjugate(times(p, q)), times(conjugate(q), conjugate(p)),
    says="The conjugate of a product has the conjugates in the opposite order.",
)

product_with_conjugate = Claim(
    "2.21",
    times(q, conjugate(q)), dot(q, q) * neutral,
    says="A quaternion times its conjugate is the square of its length.",
)

length_of_product = Claim(
    "2.22",
    dot(times(p, q), times(p, q)), dot(p, p) * dot(q, q),
    says="Lengths of quaternions multiply: Euler's identity of four squares.",
)

conjugate_transposes_left = Claim(
    "2.23",
    from_left(conjugate(q)), from_left(q).T,
    says="The conjugate multiplies from the left by the transpose.",
)

conjugate_transposes_right = Claim(
    "2.23",
    from_right(conjugate(q)), from_right(q).T,
    part=2,
    says="The conjugate multiplies from the right by the transpose.",
)

left_matrix_is_orthogonal = Claim(
    "2.24",
    from_left(q).T @ from_left(q), dot(q, q) * one_4,
    says="Multiplication by a quaternion turns and stretches in four dimensions.",
)

determinant_of_left_matrix = Claim(
    "2.25",
    det(from_left(q)), dot(q, q) ** 2,
    says="It keeps orientation.",
)

inverse_quaternion = Claim(
    "2.26",
    times(q, conjugate(q) / dot(q, q)), neutral,
    says="The inverse of a quaternion is its conjugate, divided by the square of its length.",
    assuming=(nonzero(dot(q, q)),),
)

inverse_of_left_matrix = Claim(
    "2.27",
    inverse(from_left(q)), from_left(conjugate(q)) / dot(q, q),
    says="The inverse of the matrix of a product.",
    assuming=(nonzero(dot(q, q)),),
)

vector_turned_by_quaternion = Claim(
    "2.28",
    times(times(q, column(a, 0)), conjugate(q)), column(rotation_by(q) @ a, 0),
    says="A vector between a quaternion and its conjugate is turned.",
)

rotation_by_two_products = Claim(
    "2.29",
    from_left(q) @ from_right(conjugate(q)), direct_sum(rotation_by(q), dot(q, q)),
    says="A product from either side, as a rotation of the vector.",
)

rotation_by_unit_quaternion_is_orthogonal = Claim(
    "2.30",
    rotation_by(q).T @ rotation_by(q), one,
    says="A unit quaternion gives a rotation.",
    assuming=(q_is_unit,),
)

rotation_by_unit_quaternion_is_proper = Claim(
    "2.31",
    det(rotation_by(q)), number(1),
    says="And it gives no reflection.",
    assuming=(q_is_unit,),
)

rotation_from_quaternion = Definition(
    "2.32",
    Q, rotation_by(q),
    says="The rotation by a unit quaternion.",
    sign="=",
    assuming=(q_is_unit,),
    kernel=Kernel(of=(q,)),
)

rotation_by_quaternion_of_axis_and_angle = Claim(
    "2.32",
    rotation_by(column(r, r_0)), e @ e.T + cos(phi) * (one - e @ e.T) + sin(phi) * E,
    part=2,
    says="The rotation by the quaternion of an axis and an angle is the one about that axis through that angle.",
    given=_parameters,
)

quaternions_cover_rotations_twice = Claim(
    "2.33",
    rotation_by(-q), rotation_by(q),
    says="Opposite quaternions give one rotation.",
)

rotation_by_conjugate = Claim(
    "2.34",
    rotation_by(conjugate(q)), rotation_by(q).T,
    says="The conjugate turns back.",
)

rotation_by_product = Claim(
    "2.35",
    rotation_by(times(p, q)), rotation_by(p) @ rotation_by(q),
    says="Rotations follow one another as their quaternions multiply.",
)

scalar_of_composition = Claim(
    "2.36",
    tr(rotation_by(p) @ rotation_by(q)), 4 * dot(conjugate(p), q) ** 2 - 1,
    says="The angle of the rotation composed of two.",
    assuming=(p_is_unit, q_is_unit),
)

distance_of_rotations_by_quaternions = Claim(
    "2.37",
    3 - tr(rotation_by(p).T @ rotation_by(q)), 4 * (1 - dot(p, q) ** 2),
    says="The distance of two rotations by their quaternions.",
    assuming=(p_is_unit, q_is_unit),
)

rate_of_quaternion = Claim(
    "2.38",
    rate(q), over(1, 2) * times(column(omega, 0), q),
    says="The rate of a quaternion by the angular velocity in the fixed frame.",
    given=(angular_velocity, rotation_from_quaternion),
    assuming=(q_is_unit,),
    kernel=Kernel(of=(omega, q)),
)

rate_of_quaternion_in_body = Claim(
    "2.39",
    rate(q), over(1, 2) * times(q, column(omega_body, 0)),
    says="The rate of a quaternion by the angular velocity in the frame of the body.",
    given=(angular_velocity_in_body, rotation_from_quaternion),
    assuming=(q_is_unit,),
    kernel=Kernel(of=(omega_body, q)),
)

angular_velocity_from_quaternion = Claim(
    "2.40",
    column(omega, 0), 2 * times(rate(q), conjugate(q)),
    says="The angular velocity in the fixed frame from the rate of a quaternion.",
    given=(angular_velocity, rotation_from_quaternion),
    assuming=(q_is_unit,),
    kernel=Kernel(of=(q, rate(q))),
)

angular_velocity_in_body_from_quaternion = Claim(
    "2.41",
    column(omega_body, 0), 2 * times(conjugate(q), rate(q)),
    says="The angular velocity in the frame of the body from the rate of a quaternion.",
    given=(angular_velocity_in_body, rotation_from_quaternion),
    assuming=(q_is_unit,),
    kernel=Kernel(of=(q, rate(q))),
)

speed_of_quaternion = Claim(
    "2.42",
    dot(rate(q), rate(q)), over(1, 4) * dot(omega, omega),
    says="A quaternion moves half as fast as the body turns.",
    given=(angular_velocity, rotation_from_quaternion),
    assuming=(q_is_unit,),
)

rate_is_normal_to_quaternion = Claim(
    "2.43",
    dot(q, rate(q)), number(0),
    says="A unit quaternion moves on its sphere.",
    assuming=(q_is_unit,),
)

acceleration_of_quaternion = Claim(
    "2.44",
    rate(rate(q)), over(1, 2) * times(column(rate(omega), 0), q) - over(1, 4) * dot(omega, omega) * q,
    says="The second rate of a quaternion by the angular acceleration.",
    given=(rate_of_quaternion,),
    kernel=Kernel(of=(omega, rate(omega), q)),
)

second_quaternion_on_great_circle = Definition(
    "2.45",
    q, cos(phi_1 + phi_2) * p + sin(phi_1 + phi_2) * n,
    says="A quaternion on the great circle through p that begins in the direction of n.",
    sign="=",
    assuming=(p_is_unit, n_is_unit, perpendicular(p, n)),
)

interpolated_quaternion = Definition(
    "2.46",
    h, (sin(phi_1) * p + sin(phi_2) * q) / sin(phi_1 + phi_2),
    says="Between two quaternions on a great circle, by the angles from the second and from the first.",
    sign="=",
    assuming=(nonzero(sin(phi_1 + phi_2)),),
    kernel=Kernel(of=(p, q, phi_1, phi_2)),
)

angle_of_quaternions = Claim(
    "2.47",
    dot(p, q), cos(phi_1 + phi_2),
    says="The two quaternions enclose the sum of the two angles.",
    given=(second_quaternion_on_great_circle,),
)

interpolated_quaternion_is_on_great_circle = Claim(
    "2.48",
    h, cos(phi_2) * p + sin(phi_2) * n,
    says="What is interpolated lies on the great circle, at the angle that was asked for.",
    given=(second_quaternion_on_great_circle, interpolated_quaternion),
)

interpolated_quaternion_is_unit = Claim(
    "2.49",
    dot(h, h), number(1),
    says="So it is a unit quaternion too.",
    given=(second_quaternion_on_great_circle, interpolated_quaternion),
)

derivative_of_product_by_second_factor = Claim(
    "2.50",
    partial(times(p, q), q), from_left(p),
    says="The Jacobian of a product by the second factor.",
)

derivative_of_product_by_first_factor = Claim(
    "2.51",
    partial(times(p, q), p), from_right(q),
    says="The Jacobian of a product by the first factor.",
)

derivative_of_turned_vector_by_quaternion = Claim(
    "2.52",
    partial(rotation_by(q) @ a, q),
    2
    * row(
        dot(q[1:3], a) * one + q[1:3] @ a.T - a @ q[1:3].T - q[4] * CPM(a),
        q[4] * a + cross(q[1:3], a),
    ),
    says="The Jacobian of a turned vector by the quaternion.",
)
