"""Section 9: the exponential of rigid motions, and its Jacobians."""

from chasles.rotations.notation import *
from chasles.rotations.s1_rotations import angular_velocity, angular_velocity_in_body
from chasles.rotations.s3_rotation_vectors import v_turns
from chasles.rotations.s8_twists import twist_in_body_frame, twist_in_fixed_frame

from chasles.statements import Claim, Definition, Kernel, Section, nonzero
from chasles.vocabulary import (
    column,
    cos,
    cross,
    det,
    dot,
    inverse,
    matrix,
    over,
    rate,
    sin,
    tr,
)
from chasles.vocabulary.motion_vectors import (
    exp_of_motion_vector,
    left_jacobian_of_motion,
    right_jacobian_of_motion,
)
from chasles.vocabulary.motions import adjoint_of_motion, adjoint_of_twist, homogeneous, inverse_motion, twist_matrix
from chasles.vocabulary.rotation_vectors import exp_of_vector, left_jacobian

exponential_of_motions = Section("9", "The Exponential of Rigid Motions")

nu, xi = v_length, column(v, rho)
X, ad = twist_matrix(xi), adjoint_of_twist(xi)
Exp = exp_of_motion_vector(xi)

exponential_of_motion = Claim(
    "9.1",
    Exp, homogeneous(exp_of_vector(v), left_jacobian(v) @ rho),
    says="The exponential of a motion, in blocks.",
    assuming=(v_turns,),
    kernel=Kernel(of=(v, rho)),
)

exponential_as_polynomial = Claim(
    "9.2",
    Exp, one_4 + X + (1 - cos(nu)) / nu**2 * X**2 + (nu - sin(nu)) / nu**3 * X**3,
    says="The sum of its series: powers of the matrix end with the third.",
    assuming=(v_turns,),
)

exponential_of_opposite_vector = Claim(
    "9.3",
    exp_of_motion_vector(-xi), inverse_motion(Exp),
    says="The opposite vector moves back.",
    assuming=(v_turns,),
)

exponential_commutes_with_its_vector = Claim(
    "9.4",
    Exp @ X, X @ Exp,
    says="The exponential and the matrix of its vector may be exchanged.",
    assuming=(v_turns,),
)

trace_of_exponential_of_motion = Claim(
    "9.5",
    tr(Exp), 2 + 2 * cos(nu),
    says="The angle of a motion is the length of its rotation vector.",
    assuming=(v_turns,),
)

translation_from_motion = Claim(
    "9.6",
    left_jacobian(v) @ rho, Exp[1:3, 4],
    says="The logarithm of a motion: the translation of the vector from that of the motion.",
    assuming=(v_turns,),
)

adjoint_keeps_the_vector = Claim(
    "9.7",
    adjoint_of_motion(Exp) @ xi, xi,
    says="A motion carries its own vector to itself: the screw does not move.",
    assuming=(v_turns,),
)

adjoint_of_exponential = Claim(
    "9.8",
    adjoint_of_motion(Exp),
    one_6
    + (3 * sin(nu) - nu * cos(nu)) / (2 * nu) * ad
    + (4 - nu * sin(nu) - 4 * cos(nu)) / (2 * nu**2) * ad**2
    + (sin(nu) - nu * cos(nu)) / (2 * nu**3) * ad**3
    + (2 - nu * sin(nu) - 2 * cos(nu)) / (2 * nu**4) * ad**4,
    says="The adjoint of the exponential is the exponential of the adjoint: the sum of its series.",
    assuming=(v_turns,),
)

fifth_power_of_adjoint = Claim(
    "9.9",
    ad**5, -2 * nu**2 * ad**3 - nu**4 * ad,
    says="Powers of the adjoint of a twist end with the fourth.",
)

jacobian_of_motion_in_blocks = Claim(
    "9.10",
    left_jacobian_of_motion(xi),
    matrix((left_jacobian(v), zero_block), (left_jacobian_of_motion(xi)[4:6, 1:3], left_jacobian(v))),
    says="The Jacobian of motions is triangular, and has that of rotations on its diagonal.",
    assuming=(v_turns,),
)

jacobian_of_motion_as_polynomial = Claim(
    "9.11",
    left_jacobian_of_motion(xi),
    one_6
    + (4 - nu * sin(nu) - 4 * cos(nu)) / (2 * nu**2) * ad
    + (4 * nu - 5 * sin(nu) + nu * cos(nu)) / (2 * nu**3) * ad**2
    + (2 - nu * sin(nu) - 2 * cos(nu)) / (2 * nu**4) * ad**3
    + (2 * nu - 3 * sin(nu) + nu * cos(nu)) / (2 * nu**5) * ad**4,
    says="The left Jacobian of motions as a polynomial in the adjoint of the vector.",
    assuming=(v_turns,),
)

right_jacobian_of_motion_by_left = Claim(
    "9.12",
    right_jacobian_of_motion(xi), left_jacobian_of_motion(-xi),
    says="The right Jacobian is the left one of the opposite vector.",
    assuming=(v_turns,),
)

left_jacobian_of_motion_by_right = Claim(
    "9.13",
    left_jacobian_of_motion(xi), adjoint_of_motion(Exp) @ right_jacobian_of_motion(xi),
    says="The two differ by the adjoint of the motion.",
    assuming=(v_turns,),
)

jacobian_of_motion_keeps_the_vector = Claim(
    "9.14",
    left_jacobian_of_motion(xi) @ xi, xi,
    says="The Jacobian leaves the vector of the motion as it is.",
    assuming=(v_turns,),
)

adjoint_by_jacobian = Claim(
    "9.15",
    adjoint_of_motion(Exp) - one_6, ad @ left_jacobian_of_motion(xi),
    says="What a motion changes, by its Jacobian.",
    assuming=(v_turns,),
)

determinant_of_jacobian_of_motion = Claim(
    "9.16",
    det(left_jacobian_of_motion(xi)), (2 * (1 - cos(nu)) / nu**2) ** 2,
    says="It is singular where that of rotations is.",
    assuming=(v_turns,),
)

inverse_of_jacobian_of_motion = Claim(
    "9.17",
    inverse(left_jacobian_of_motion(xi)),
    one_6
    - over(1, 2) * ad
    + (2 / nu**2 + (nu + 3 * sin(nu)) / (4 * nu * (cos(nu) - 1))) * ad**2
    + (1 / nu**4 + (nu + sin(nu)) / (4 * nu**3 * (cos(nu) - 1))) * ad**4,
    says="The inverse of the left Jacobian of motions, where the angle is no whole number of turns.",
    assuming=(v_turns, nonzero(cos(nu) - 1)),
)

motion_by_vector = Definition(
    "9.18",
    Q, exp_of_vector(v),
    says="The rotation of a motion by its vector.",
    sign="=",
    assuming=(v_turns,),
)

position_by_vector = Definition(
    "9.18",
    p_T, left_jacobian(v) @ rho,
    part=2,
    says="The position of a motion by its vector.",
    sign="=",
    assuming=(v_turns,),
)

twist_by_vector_of_motion = Claim(
    "9.19",
    t_space, left_jacobian_of_motion(column(v, rho)) @ column(rate(v), rate(rho)),
    says="The twist in the fixed frame from the rate of the vector of the motion.",
    given=(motion_by_vector, position_by_vector, twist_in_fixed_frame, angular_velocity),
)

twist_of_body_by_vector_of_motion = Claim(
    "9.20",
    t_body, right_jacobian_of_motion(column(v, rho)) @ column(rate(v), rate(rho)),
    says="The twist in the frame of the body from the rate of the vector of the motion.",
    given=(motion_by_vector, position_by_vector, twist_in_body_frame, angular_velocity_in_body),
)

axis_of_motion_by_vector = Claim(
    "9.21",
    Exp @ column(cross(v, rho) / nu**2, 1), column(cross(v, rho) / nu**2 + dot(v, rho) / nu**2 * v, 1),
    says="The point of the screw axis nearest to the origin advances along it.",
    assuming=(v_turns,),
)
