"""What Exercise 3.21 states: the terms of the angular-acceleration matrix, and the accelerations that they give."""

from chasles.derivations.notation import Omega, e_1, e_2, e_3, omega, r_C
from chasles.derivations.s03_fixed_point import angular_velocity_matrix_of_vector

from chasles.statements import Claim, orthonormal
from chasles.vocabulary import CPM, cross, dot, norm, number, rate, tr

given = (angular_velocity_matrix_of_vector,)

rate_of_matrix = Claim(
    "Ex 3.21", rate(Omega), CPM(rate(omega)), says="The first term, by the angular acceleration.", given=given
)

terms_are_orthogonal = Claim(
    "Ex 3.21",
    tr(rate(Omega) @ (Omega**2).T),
    number(0),
    part=2,
    says="The two terms of (3.86) are orthogonal: one is skew-symmetric, the other symmetric.",
    given=given,
)

size_of_first = Claim(
    "Ex 3.21",
    tr(rate(Omega) @ rate(Omega).T),
    2 * norm(rate(omega)) ** 2,
    part=3,
    says="The square of the first term's norm.",
    given=given,
)

size_of_second = Claim(
    "Ex 3.21",
    tr(Omega**2 @ (Omega**2).T),
    2 * norm(omega) ** 4,
    part=4,
    says="The square of the second term's norm.",
    given=given,
)

product_of_accelerations = Claim(
    "Ex 3.21",
    dot(rate(Omega) @ r_C, Omega**2 @ r_C),
    dot(omega, r_C) * dot(cross(omega, rate(omega)), r_C),
    part=5,
    says="The product of the tangential and the centripetal acceleration of a point at r from another: it vanishes "
    "for all r if and only if the angular acceleration is parallel to the angular velocity (or one is zero); and for "
    "those r that are normal to omega, or to omega x alpha.",
    given=given,
)

orthogonal_on_average = Claim(
    "Ex 3.21",
    dot(rate(Omega) @ e_1, Omega**2 @ e_1)
    + dot(rate(Omega) @ e_2, Omega**2 @ e_2)
    + dot(rate(Omega) @ e_3, Omega**2 @ e_3),
    number(0),
    part=6,
    says="What the orthogonality of the matrices restates: for three points on perpendicular axes, at one distance, "
    "the products add up to zero. The accelerations are orthogonal on average over all directions of r.",
    given=given,
    assuming=(orthonormal(e_1, e_2, e_3),),
)

twist_of_axes = cross(omega, rate(omega))

accelerations_are_orthogonal = Claim(
    "Ex 3.21",
    dot(rate(Omega) @ r_C, Omega**2 @ r_C),
    number(0),
    part=7,
    says="The last sentence of the exercise, taken at its word: the two accelerations are orthogonal.",
    given=given,
)
