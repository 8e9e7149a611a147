"""Section 3.6: rigid-body motion referred to moving coordinate axes."""

from chasles.derivations.notation import *
from chasles.derivations.s03_fixed_point import (
    Q_is_a_rotation,
    angular_velocity_matrix,
    angular_velocity_matrix_of_vector,
)

from chasles.statements import Claim, Definition, Kernel, Section
from chasles.vocabulary import bracket, cross, in_frame, rate

moving_coordinate_axes = Section("3.6", "Rigid-Body Motion Referred to Moving Coordinate Axes")

position_in_two_parts = Definition(
    "3.98",
    in_frame(p, "F"), in_frame(o, "F") + in_frame(rho_F, "F"),
    says="The position of P by the origin of the moving frame.",
    sign="=",
)

components_turned = Definition(
    "3.99",
    in_frame(rho_F, "F"), in_frame(Q, "F") @ in_frame(rho_M, "M"),
    says="The components in the fixed frame from those in the moving frame.",
    sign="=",
)

position_from_moving_frame = Claim(
    "3.100",
    in_frame(p, "F"), in_frame(o, "F") + in_frame(Q, "F") @ in_frame(rho_M, "M"),
    says="The position of P from its components in the moving frame.",
    given=(position_in_two_parts, components_turned),
)

velocity_by_differentiation = Claim(
    "3.101",
    in_frame(rate(p), "F"),
    in_frame(rate(o), "F") + in_frame(rate(Q), "F") @ in_frame(rho_M, "M")
    + in_frame(Q, "F") @ in_frame(rate(rho_M), "M"),
    says="The velocity of P, by differentiating its position in the moving frame.",
    given=(position_from_moving_frame,),
)

rate_of_rotation = Claim(
    "3.102",
    in_frame(rate(Q), "F"), in_frame(Omega, "F") @ in_frame(Q, "F"),
    says="The rate of the rotation by the angular-velocity matrix.",
    given=(angular_velocity_matrix,),
    assuming=(Q_is_a_rotation,),
)

moving_frame_velocity = Claim(
    "3.103",
    in_frame(rate(p), "F"),
    in_frame(rate(o), "F") + in_frame(Omega, "F") @ in_frame(Q, "F") @ in_frame(rho_M, "M")
    + in_frame(Q, "F") @ in_frame(rate(rho_M), "M"),
    says="The velocity of P in the fixed frame from that in the moving frame.",
    given=(velocity_by_differentiation, rate_of_rotation, angular_velocity_matrix_of_vector),
    kernel=Kernel(of=(rate(o), Q, omega, rho_M, rate(rho_M)), expected=(Q_is_a_rotation,)),
)

acceleration_in_moving_frame_by_differentiation = Claim(
    "3.104",
    in_frame(rate(rate(p)), "F"),
    in_frame(rate(rate(o)), "F") + in_frame(rate(Omega), "F") @ in_frame(Q, "F") @ in_frame(rho_M, "M")
    + in_frame(Omega, "F") @ in_frame(rate(Q), "F") @ in_frame(rho_M, "M")
    + in_frame(Omega, "F") @ in_frame(Q, "F") @ in_frame(rate(rho_M), "M")
    + in_frame(rate(Q), "F") @ in_frame(rate(rho_M), "M") + in_frame(Q, "F") @ in_frame(rate(rate(rho_M)), "M"),
    says="The acceleration of P, by differentiating its velocity.",
    given=(moving_frame_velocity,),
)

moving_frame_acceleration = Claim(
    "3.105",
    in_frame(rate(rate(p)), "F"),
    in_frame(rate(rate(o)), "F")
    + (in_frame(rate(Omega), "F") + in_frame(Omega**2, "F")) @ in_frame(Q, "F") @ in_frame(rho_M, "M")
    + 2 * in_frame(Omega, "F") @ in_frame(Q, "F") @ in_frame(rate(rho_M), "M")
    + in_frame(Q, "F") @ in_frame(rate(rate(rho_M)), "M"),
    says="The acceleration of P in the fixed frame: as a point of the moving frame, Coriolis, and in the moving frame.",
    given=(acceleration_in_moving_frame_by_differentiation, rate_of_rotation, angular_velocity_matrix_of_vector),
    kernel=Kernel(
        of=(rate(rate(o)), Q, omega, rate(omega), rho_M, rate(rho_M), rate(rate(rho_M))),
        expected=(Q_is_a_rotation,),
        form=rate(rate(o))
        + cross(rate(omega), Q @ rho_M)
        + cross(omega, bracket(cross(omega, Q @ rho_M) + 2 * Q @ rate(rho_M)))
        + Q @ rate(rate(rho_M)),
    ),
)
