"""The functions of `one` beside `chasles.kernels`. Made by `chasles emit`; not to be edited."""

from .calls import (
    LightCrossProductMatrix,
    LightRotationFromAxisAngle,
    LightPointAfterDisplacement,
    LightPitchOfMotion,
    LightNormalMatrixInverse,
    LightScrewAxisPoint,
    LightPluckerLine,
    LightPluckerTransfer,
    LightRotationInTriadAxes,
    LightRotationFromTriads,
    LightAxialVector,
    LightVelocityOfPoint,
    LightInstantScrewPoint,
    LightNaturalRateMatrix,
    LightLinearRateMatrix,
    LightEulerRodriguesRateMatrix,
    LightRotationFromLinearInvariants,
    LightRotationFromEulerRodrigues,
    LightLinearInvariants,
    LightNaturalInvariants,
    LightEulerRodriguesParameters,
    LightScrewOfMotion,
    LightInstantScrew,
    LightNaturalVelocityMatrix,
    LightLinearVelocityMatrix,
    LightEulerRodriguesVelocityMatrix,
    LightPoseRateNatural,
    LightPoseRateLinear,
    LightPoseRateEulerRodrigues,
    LightTwistFromPoseRateNatural,
    LightTwistFromPoseRateLinear,
    LightTwistFromPoseRateEulerRodrigues,
    LightTwistTransfer,
    LightAngularAccelerationMatrix,
    LightAccelerationOfPoint,
    LightNaturalRateMatrixDot,
    LightLinearRateMatrixDot,
    LightEulerRodriguesRateMatrixDot,
    LightNaturalVelocityMatrixDot,
    LightLinearVelocityMatrixDot,
    LightEulerRodriguesVelocityMatrixDot,
    LightPoseAccelerationNatural,
    LightPoseAccelerationLinear,
    LightPoseAccelerationEulerRodrigues,
    LightTwistRateFromPoseNatural,
    LightTwistRateFromPoseLinear,
    LightTwistRateFromPoseEulerRodrigues,
    LightMovingFrameVelocity,
    LightMovingFrameAcceleration,
    LightWrenchAxis,
    LightPower,
    LightReciprocalProduct,
    LightWrenchTransfer,
    LightInertiaAboutPoint,
    LightInertiaAboutPointSym6,
    LightMomentumScrew,
    LightMomentumScrewSym6,
    LightKineticEnergy,
    LightKineticEnergySym6,
    LightNewtonEulerWrench,
    LightNewtonEulerWrenchSym6,
    LightNewtonEulerTwistRate,
    LightNewtonEulerTwistRateSym6,
    LightInertiaDyad,
    LightInertiaDyadSym6,
    LightRotationFromEulerXyx,
    LightEulerRateMatrixXyx,
    LightEulerRateMatrixBodyXyx,
    LightEulerRatesXyx,
    LightRotationFromEulerXyz,
    LightEulerRateMatrixXyz,
    LightEulerRateMatrixBodyXyz,
    LightEulerRatesXyz,
    LightRotationFromEulerXzx,
    LightEulerRateMatrixXzx,
    LightEulerRateMatrixBodyXzx,
    LightEulerRatesXzx,
    LightRotationFromEulerXzy,
    LightEulerRateMatrixXzy,
    LightEulerRateMatrixBodyXzy,
    LightEulerRatesXzy,
    LightRotationFromEulerYxy,
    LightEulerRateMatrixYxy,
    LightEulerRateMatrixBodyYxy,
    LightEulerRatesYxy,
    LightRotationFromEulerYxz,
    LightEulerRateMatrixYxz,
    LightEulerRateMatrixBodyYxz,
    LightEulerRatesYxz,
    LightRotationFromEulerYzx,
    LightEulerRateMatrixYzx,
    LightEulerRateMatrixBodyYzx,
    LightEulerRatesYzx,
    LightRotationFromEulerYzy,
    LightEulerRateMatrixYzy,
    LightEulerRateMatrixBodyYzy,
    LightEulerRatesYzy,
    LightRotationFromEulerZxy,
    LightEulerRateMatrixZxy,
    LightEulerRateMatrixBodyZxy,
    LightEulerRatesZxy,
    LightRotationFromEulerZxz,
    LightEulerRateMatrixZxz,
    LightEulerRateMatrixBodyZxz,
    LightEulerRatesZxz,
    LightRotationFromEulerZyx,
    LightEulerRateMatrixZyx,
    LightEulerRateMatrixBodyZyx,
    LightEulerRatesZyx,
    LightRotationFromEulerZyz,
    LightEulerRateMatrixZyz,
    LightEulerRateMatrixBodyZyz,
    LightEulerRatesZyz,
)

__all__ = [
    "cross_product_matrix",
    "rotation_from_axis_angle",
    "point_after_displacement",
    "pitch_of_motion",
    "normal_matrix_inverse",
    "screw_axis_point",
    "plucker_line",
    "plucker_transfer",
    "rotation_in_triad_axes",
    "rotation_from_triads",
    "axial_vector",
    "velocity_of_point",
    "instant_screw_point",
    "natural_rate_matrix",
    "linear_rate_matrix",
    "euler_rodrigues_rate_matrix",
    "rotation_from_linear_invariants",
    "rotation_from_euler_rodrigues",
    "linear_invariants",
    "natural_invariants",
    "euler_rodrigues_parameters",
    "screw_of_motion",
    "instant_screw",
    "natural_velocity_matrix",
    "linear_velocity_matrix",
    "euler_rodrigues_velocity_matrix",
    "pose_rate_natural",
    "pose_rate_linear",
    "pose_rate_euler_rodrigues",
    "twist_from_pose_rate_natural",
    "twist_from_pose_rate_linear",
    "twist_from_pose_rate_euler_rodrigues",
    "twist_transfer",
    "angular_acceleration_matrix",
    "acceleration_of_point",
    "natural_rate_matrix_dot",
    "linear_rate_matrix_dot",
    "euler_rodrigues_rate_matrix_dot",
    "natural_velocity_matrix_dot",
    "linear_velocity_matrix_dot",
    "euler_rodrigues_velocity_matrix_dot",
    "pose_acceleration_natural",
    "pose_acceleration_linear",
    "pose_acceleration_euler_rodrigues",
    "twist_rate_from_pose_natural",
    "twist_rate_from_pose_linear",
    "twist_rate_from_pose_euler_rodrigues",
    "moving_frame_velocity",
    "moving_frame_acceleration",
    "wrench_axis",
    "power",
    "reciprocal_product",
    "wrench_transfer",
    "inertia_about_point",
    "inertia_about_point_sym6",
    "momentum_screw",
    "momentum_screw_sym6",
    "kinetic_energy",
    "kinetic_energy_sym6",
    "newton_euler_wrench",
    "newton_euler_wrench_sym6",
    "newton_euler_twist_rate",
    "newton_euler_twist_rate_sym6",
    "inertia_dyad",
    "inertia_dyad_sym6",
    "rotation_from_euler_xyx",
    "euler_rate_matrix_xyx",
    "euler_rate_matrix_body_xyx",
    "euler_rates_xyx",
    "rotation_from_euler_xyz",
    "euler_rate_matrix_xyz",
    "euler_rate_matrix_body_xyz",
    "euler_rates_xyz",
    "rotation_from_euler_xzx",
    "euler_rate_matrix_xzx",
    "euler_rate_matrix_body_xzx",
    "euler_rates_xzx",
    "rotation_from_euler_xzy",
    "euler_rate_matrix_xzy",
    "euler_rate_matrix_body_xzy",
    "euler_rates_xzy",
    "rotation_from_euler_yxy",
    "euler_rate_matrix_yxy",
    "euler_rate_matrix_body_yxy",
    "euler_rates_yxy",
    "rotation_from_euler_yxz",
    "euler_rate_matrix_yxz",
    "euler_rate_matrix_body_yxz",
    "euler_rates_yxz",
    "rotation_from_euler_yzx",
    "euler_rate_matrix_yzx",
    "euler_rate_matrix_body_yzx",
    "euler_rates_yzx",
    "rotation_from_euler_yzy",
    "euler_rate_matrix_yzy",
    "euler_rate_matrix_body_yzy",
    "euler_rates_yzy",
    "rotation_from_euler_zxy",
    "euler_rate_matrix_zxy",
    "euler_rate_matrix_body_zxy",
    "euler_rates_zxy",
    "rotation_from_euler_zxz",
    "euler_rate_matrix_zxz",
    "euler_rate_matrix_body_zxz",
    "euler_rates_zxz",
    "rotation_from_euler_zyx",
    "euler_rate_matrix_zyx",
    "euler_rate_matrix_body_zyx",
    "euler_rates_zyx",
    "rotation_from_euler_zyz",
    "euler_rate_matrix_zyz",
    "euler_rate_matrix_body_zyz",
    "euler_rates_zyz",
]

cross_product_matrix: LightCrossProductMatrix
"""(2.38) The cross-product matrix of v: multiplying by it is taking the vector product with v.
Of one element or a contiguous batch. As `chasles.kernels.cross_product_matrix`: (3)->(3,3).
"""

rotation_from_axis_angle: LightRotationFromAxisAngle
"""(2.49) The rotation about the axis e through the angle phi.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_axis_angle`: (3),()->(3,3).
"""

point_after_displacement: LightPointAfterDisplacement
"""(3.2) Where a point of the body lies after the displacement.
Of one element or a contiguous batch. As `chasles.kernels.point_after_displacement`: (3,3),(3),(3),(3)->(3).
"""

pitch_of_motion: LightPitchOfMotion
"""(3.7) The pitch from the displacement of any point.
Of one element or a contiguous batch. As `chasles.kernels.pitch_of_motion`: (3),(),(3)->().
"""

normal_matrix_inverse: LightNormalMatrixInverse
"""(3.16) The inverse of the matrix of the normal equations.
Of one element or a contiguous batch. As `chasles.kernels.normal_matrix_inverse`: (3),()->(3,3).
"""

screw_axis_point: LightScrewAxisPoint
"""(3.18) The point of the screw axis nearest the origin.
Of one element or a contiguous batch. As `chasles.kernels.screw_axis_point`: (3),(),(3),(3)->(3).
"""

plucker_line: LightPluckerLine
"""(3.23) The Plücker array of a line: its direction and its moment.
Of one element or a contiguous batch. As `chasles.kernels.plucker_line`: (3),(3)->(6).
"""

plucker_transfer: LightPluckerTransfer
"""(3.29a) The Plücker-coordinate transfer formula.
Of one element or a contiguous batch. As `chasles.kernels.plucker_transfer`: (6),(3),(3)->(6).
"""

rotation_in_triad_axes: LightRotationInTriadAxes
"""text 3.2.3 h The rotation in the axes of the triad, as a product of matrices.
Of one element or a contiguous batch. As `chasles.kernels.rotation_in_triad_axes`: (3,3),(3,3)->(3,3).
"""

rotation_from_triads: LightRotationFromTriads
"""text 3.2.3 g The rotation that takes one triad into the other, in the frame in which both are given.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_triads`: (3,3),(3,3)->(3,3).
"""

axial_vector: LightAxialVector
"""(3.45) The angular velocity: the axial vector of the angular-velocity matrix.
Of one element or a contiguous batch. As `chasles.kernels.axial_vector`: (3,3)->(3).
"""

velocity_of_point: LightVelocityOfPoint
"""(3.50) The velocity of a point from that of the landmark.
Of one element or a contiguous batch. As `chasles.kernels.velocity_of_point`: (3),(3),(3),(3)->(3).
"""

instant_screw_point: LightInstantScrewPoint
"""(3.70) The point of the instant screw axis nearest the origin, with vector products.
Of one element or a contiguous batch. As `chasles.kernels.instant_screw_point`: (3),(3),(3)->(3).
"""

natural_rate_matrix: LightNaturalRateMatrix
"""(3.76b) The matrix of the natural invariants' rates.
Of one element or a contiguous batch. As `chasles.kernels.natural_rate_matrix`: (3),()->(4,3).
"""

linear_rate_matrix: LightLinearRateMatrix
"""(3.76c) The matrix of the linear invariants' rates.
Of one element or a contiguous batch. As `chasles.kernels.linear_rate_matrix`: (3),()->(4,3).
"""

euler_rodrigues_rate_matrix: LightEulerRodriguesRateMatrix
"""(3.76d) The matrix of the Euler-Rodrigues parameters' rates.
Of one element or a contiguous batch. As `chasles.kernels.euler_rodrigues_rate_matrix`: (3),()->(4,3).
"""

rotation_from_linear_invariants: LightRotationFromLinearInvariants
"""text 3.4.2 f The rotation from its linear invariants.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_linear_invariants`: (3),()->(3,3).
"""

rotation_from_euler_rodrigues: LightRotationFromEulerRodrigues
"""text 3.4.2 f The rotation from its Euler-Rodrigues parameters.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_euler_rodrigues`: (3),()->(3,3).
"""

linear_invariants: LightLinearInvariants
"""text 3.4.2 g The linear invariants from the rotation.
Of one element or a contiguous batch. As `chasles.kernels.linear_invariants`: (3,3)->(3),().
"""

natural_invariants: LightNaturalInvariants
"""text 3.4.2 h The natural invariants from the rotation.
Of one element or a contiguous batch. As `chasles.kernels.natural_invariants`: (3,3)->(3),().
"""

euler_rodrigues_parameters: LightEulerRodriguesParameters
"""text 3.4.2 i The Euler-Rodrigues parameters from the rotation.
Of one element or a contiguous batch. As `chasles.kernels.euler_rodrigues_parameters`: (3,3)->(3),().
"""

screw_of_motion: LightScrewOfMotion
"""text 3.4.2 j The screw of a motion: Plücker array of its axis, translation along it, angle.
Of one element or a contiguous batch. As `chasles.kernels.screw_of_motion`: (3,3),(3),(3)->(6),(),().
"""

instant_screw: LightInstantScrew
"""text 3.4.1 c The instant screw: Plücker array of its axis, and pitch.
Of one element or a contiguous batch. As `chasles.kernels.instant_screw`: (3),(3),(3)->(6),().
"""

natural_velocity_matrix: LightNaturalVelocityMatrix
"""(3.77b) The matrix that gives the angular velocity from the natural invariants' rates.
Of one element or a contiguous batch. As `chasles.kernels.natural_velocity_matrix`: (3),()->(3,4).
"""

linear_velocity_matrix: LightLinearVelocityMatrix
"""(3.77c) The matrix that gives the angular velocity from the linear invariants' rates.
Of one element or a contiguous batch. As `chasles.kernels.linear_velocity_matrix`: (3),()->(3,4).
"""

euler_rodrigues_velocity_matrix: LightEulerRodriguesVelocityMatrix
"""(3.77d) The matrix that gives the angular velocity from the Euler-Rodrigues parameters' rates.
Of one element or a contiguous batch. As `chasles.kernels.euler_rodrigues_velocity_matrix`: (3),()->(3,4).
"""

pose_rate_natural: LightPoseRateNatural
"""(3.78) The rate of the pose from the twist, with the natural invariants.
Of one element or a contiguous batch. As `chasles.kernels.pose_rate_natural`: (3),(),(6)->(7).
"""

pose_rate_linear: LightPoseRateLinear
"""(3.78) The rate of the pose from the twist, with the linear invariants.
Of one element or a contiguous batch. As `chasles.kernels.pose_rate_linear`: (3),(),(6)->(7).
"""

pose_rate_euler_rodrigues: LightPoseRateEulerRodrigues
"""(3.78) The rate of the pose from the twist, with the Euler-Rodrigues parameters.
Of one element or a contiguous batch. As `chasles.kernels.pose_rate_euler_rodrigues`: (3),(),(6)->(7).
"""

twist_from_pose_rate_natural: LightTwistFromPoseRateNatural
"""(3.80a) The twist from the rate of the pose, with the natural invariants.
Of one element or a contiguous batch. As `chasles.kernels.twist_from_pose_rate_natural`: (3),(),(7)->(6).
"""

twist_from_pose_rate_linear: LightTwistFromPoseRateLinear
"""(3.80a) The twist from the rate of the pose, with the linear invariants.
Of one element or a contiguous batch. As `chasles.kernels.twist_from_pose_rate_linear`: (3),(),(7)->(6).
"""

twist_from_pose_rate_euler_rodrigues: LightTwistFromPoseRateEulerRodrigues
"""(3.80a) The twist from the rate of the pose, with the Euler-Rodrigues parameters.
Of one element or a contiguous batch. As `chasles.kernels.twist_from_pose_rate_euler_rodrigues`: (3),(),(7)->(6).
"""

twist_transfer: LightTwistTransfer
"""(3.83a) The twist-transfer formula.
Of one element or a contiguous batch. As `chasles.kernels.twist_transfer`: (6),(3),(3)->(6).
"""

angular_acceleration_matrix: LightAngularAccelerationMatrix
"""(3.86) The angular-acceleration matrix.
Of one element or a contiguous batch. As `chasles.kernels.angular_acceleration_matrix`: (3),(3)->(3,3).
"""

acceleration_of_point: LightAccelerationOfPoint
"""(3.89) The acceleration of a point from that of the landmark, with vector products.
Of one element or a contiguous batch. As `chasles.kernels.acceleration_of_point`: (3),(3),(3),(3),(3)->(3).
"""

natural_rate_matrix_dot: LightNaturalRateMatrixDot
"""text 3.5 f The rate of N by axis, angle and angular velocity: (3.96a).
Of one element or a contiguous batch. As `chasles.kernels.natural_rate_matrix_dot`: (3),(),(3)->(4,3).
"""

linear_rate_matrix_dot: LightLinearRateMatrixDot
"""text 3.5 f The rate of L by axis, angle and angular velocity: (3.96b).
Of one element or a contiguous batch. As `chasles.kernels.linear_rate_matrix_dot`: (3),(),(3)->(4,3).
"""

euler_rodrigues_rate_matrix_dot: LightEulerRodriguesRateMatrixDot
"""text 3.5 f The rate of H by axis, angle and angular velocity: (3.96c).
Of one element or a contiguous batch. As `chasles.kernels.euler_rodrigues_rate_matrix_dot`: (3),(),(3)->(4,3).
"""

natural_velocity_matrix_dot: LightNaturalVelocityMatrixDot
"""text 3.5 g The rate of the left inverse of N by axis, angle and angular velocity: (3.97a).
Of one element or a contiguous batch. As `chasles.kernels.natural_velocity_matrix_dot`: (3),(),(3)->(3,4).
"""

linear_velocity_matrix_dot: LightLinearVelocityMatrixDot
"""text 3.5 g The rate of the left inverse of L by axis, angle and angular velocity: (3.97b).
Of one element or a contiguous batch. As `chasles.kernels.linear_velocity_matrix_dot`: (3),(),(3)->(3,4).
"""

euler_rodrigues_velocity_matrix_dot: LightEulerRodriguesVelocityMatrixDot
"""text 3.5 g The rate of the left inverse of H by axis, angle and angular velocity: (3.97c).
Of one element or a contiguous batch. As `chasles.kernels.euler_rodrigues_velocity_matrix_dot`: (3),(),(3)->(3,4).
"""

pose_acceleration_natural: LightPoseAccelerationNatural
"""text 3.5 h The second rate of the pose from the twist and its rate, with the natural invariants.
Of one element or a contiguous batch. As `chasles.kernels.pose_acceleration_natural`: (3),(),(6),(6)->(7).
"""

pose_acceleration_linear: LightPoseAccelerationLinear
"""text 3.5 h The second rate of the pose from the twist and its rate, with the linear invariants.
Of one element or a contiguous batch. As `chasles.kernels.pose_acceleration_linear`: (3),(),(6),(6)->(7).
"""

pose_acceleration_euler_rodrigues: LightPoseAccelerationEulerRodrigues
"""text 3.5 h The second rate of the pose from the twist and its rate, with the Euler-Rodrigues parameters.
Of one element or a contiguous batch. As `chasles.kernels.pose_acceleration_euler_rodrigues`: (3),(),(6),(6)->(7).
"""

twist_rate_from_pose_natural: LightTwistRateFromPoseNatural
"""text 3.5 i The rate of the twist from the rates of the pose, with the natural invariants.
Of one element or a contiguous batch. As `chasles.kernels.twist_rate_from_pose_natural`: (3),(),(7),(7)->(6).
"""

twist_rate_from_pose_linear: LightTwistRateFromPoseLinear
"""text 3.5 i The rate of the twist from the rates of the pose, with the linear invariants.
Of one element or a contiguous batch. As `chasles.kernels.twist_rate_from_pose_linear`: (3),(),(7),(7)->(6).
"""

twist_rate_from_pose_euler_rodrigues: LightTwistRateFromPoseEulerRodrigues
"""text 3.5 i The rate of the twist from the rates of the pose, with the Euler-Rodrigues parameters.
Of one element or a contiguous batch. As `chasles.kernels.twist_rate_from_pose_euler_rodrigues`: (3),(),(7),(7)->(6).
"""

moving_frame_velocity: LightMovingFrameVelocity
"""(3.103) The velocity of P in the fixed frame from that in the moving frame.
Of one element or a contiguous batch. As `chasles.kernels.moving_frame_velocity`: (3),(3,3),(3),(3),(3)->(3).
"""

moving_frame_acceleration: LightMovingFrameAcceleration
"""(3.105) The acceleration of P in the fixed frame: as a point of the moving frame, Coriolis, and in the moving frame.
Of one element or a contiguous batch. As `chasles.kernels.moving_frame_acceleration`: (3),(3,3),(3),(3),(3),(3),(3)->(3).
"""

wrench_axis: LightWrenchAxis
"""text 3.7 d The axis and the pitch of the wrench.
Of one element or a contiguous batch. As `chasles.kernels.wrench_axis`: (3),(3),(3)->(6),().
"""

power: LightPower
"""(3.114) The power developed by a wrench on a body that moves with a twist at the same point.
Of one element or a contiguous batch. As `chasles.kernels.power`: (6),(6)->().
"""

reciprocal_product: LightReciprocalProduct
"""text 3.7 k The reciprocal product of two screws, in either order.
Of one element or a contiguous batch. As `chasles.kernels.reciprocal_product`: (6),(6)->().
"""

wrench_transfer: LightWrenchTransfer
"""(3.119a) The wrench-transfer formula.
Of one element or a contiguous batch. As `chasles.kernels.wrench_transfer`: (6),(3),(3)->(6).
"""

inertia_about_point: LightInertiaAboutPoint
"""(3.133a) Steiner's theorem: the moment of inertia with respect to A from that at the center of mass.
Of one element or a contiguous batch. As `chasles.kernels.inertia_about_point`: (3,3),(),(3),(3)->(3,3).
"""

inertia_about_point_sym6: LightInertiaAboutPointSym6
"""(3.133a) Steiner's theorem: the moment of inertia with respect to A from that at the center of mass.
Of one element or a contiguous batch. As `chasles.kernels.inertia_about_point_sym6`: (6),(),(3),(3)->(6).
"""

momentum_screw: LightMomentumScrew
"""(3.142) The momentum screw by inertia dyad and twist.
Of one element or a contiguous batch. As `chasles.kernels.momentum_screw`: (3,3),(),(6)->(6).
"""

momentum_screw_sym6: LightMomentumScrewSym6
"""(3.142) The momentum screw by inertia dyad and twist.
Of one element or a contiguous batch. As `chasles.kernels.momentum_screw_sym6`: (6),(),(6)->(6).
"""

kinetic_energy: LightKineticEnergy
"""(3.145) The kinetic energy as a quadratic form of the twist.
Of one element or a contiguous batch. As `chasles.kernels.kinetic_energy`: (3,3),(),(6)->().
"""

kinetic_energy_sym6: LightKineticEnergySym6
"""(3.145) The kinetic energy as a quadratic form of the twist.
Of one element or a contiguous batch. As `chasles.kernels.kinetic_energy_sym6`: (6),(),(6)->().
"""

newton_euler_wrench: LightNewtonEulerWrench
"""text 3.8 v The wrench that moves the body: the Newton-Euler equations as they stand.
Of one element or a contiguous batch. As `chasles.kernels.newton_euler_wrench`: (3,3),(),(6),(6)->(6).
"""

newton_euler_wrench_sym6: LightNewtonEulerWrenchSym6
"""text 3.8 v The wrench that moves the body: the Newton-Euler equations as they stand.
Of one element or a contiguous batch. As `chasles.kernels.newton_euler_wrench_sym6`: (6),(),(6),(6)->(6).
"""

newton_euler_twist_rate: LightNewtonEulerTwistRate
"""text 3.8 v The rate of the twist of a body on which a wrench acts: the Newton-Euler equations solved.
Of one element or a contiguous batch. As `chasles.kernels.newton_euler_twist_rate`: (3,3),(),(6),(6)->(6).
"""

newton_euler_twist_rate_sym6: LightNewtonEulerTwistRateSym6
"""text 3.8 v The rate of the twist of a body on which a wrench acts: the Newton-Euler equations solved.
Of one element or a contiguous batch. As `chasles.kernels.newton_euler_twist_rate_sym6`: (6),(),(6),(6)->(6).
"""

inertia_dyad: LightInertiaDyad
"""(3.147) The inertia dyad at A.
Of one element or a contiguous batch. As `chasles.kernels.inertia_dyad`: (3,3),(),(3),(3)->(6,6).
"""

inertia_dyad_sym6: LightInertiaDyadSym6
"""(3.147) The inertia dyad at A.
Of one element or a contiguous batch. As `chasles.kernels.inertia_dyad_sym6`: (6),(),(3),(3)->(6,6).
"""

rotation_from_euler_xyx: LightRotationFromEulerXyx
"""Ex 3.10 The rotation by Euler angles about x, y, x.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_euler_xyx`: (3)->(3,3).
"""

euler_rate_matrix_xyx: LightEulerRateMatrixXyx
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, y, x.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_xyx`: (3)->(3,3).
"""

euler_rate_matrix_body_xyx: LightEulerRateMatrixBodyXyx
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, y, x.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_body_xyx`: (3)->(3,3).
"""

euler_rates_xyx: LightEulerRatesXyx
"""Ex 3.10 The rates of Euler angles about x, y, x from the angular velocity in the fixed frame.
Of one element or a contiguous batch. As `chasles.kernels.euler_rates_xyx`: (3),(3)->(3).
"""

rotation_from_euler_xyz: LightRotationFromEulerXyz
"""Ex 3.10 The rotation by Euler angles about x, y, z.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_euler_xyz`: (3)->(3,3).
"""

euler_rate_matrix_xyz: LightEulerRateMatrixXyz
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, y, z.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_xyz`: (3)->(3,3).
"""

euler_rate_matrix_body_xyz: LightEulerRateMatrixBodyXyz
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, y, z.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_body_xyz`: (3)->(3,3).
"""

euler_rates_xyz: LightEulerRatesXyz
"""Ex 3.10 The rates of Euler angles about x, y, z from the angular velocity in the fixed frame.
Of one element or a contiguous batch. As `chasles.kernels.euler_rates_xyz`: (3),(3)->(3).
"""

rotation_from_euler_xzx: LightRotationFromEulerXzx
"""Ex 3.10 The rotation by Euler angles about x, z, x.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_euler_xzx`: (3)->(3,3).
"""

euler_rate_matrix_xzx: LightEulerRateMatrixXzx
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, z, x.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_xzx`: (3)->(3,3).
"""

euler_rate_matrix_body_xzx: LightEulerRateMatrixBodyXzx
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, z, x.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_body_xzx`: (3)->(3,3).
"""

euler_rates_xzx: LightEulerRatesXzx
"""Ex 3.10 The rates of Euler angles about x, z, x from the angular velocity in the fixed frame.
Of one element or a contiguous batch. As `chasles.kernels.euler_rates_xzx`: (3),(3)->(3).
"""

rotation_from_euler_xzy: LightRotationFromEulerXzy
"""Ex 3.10 The rotation by Euler angles about x, z, y.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_euler_xzy`: (3)->(3,3).
"""

euler_rate_matrix_xzy: LightEulerRateMatrixXzy
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, z, y.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_xzy`: (3)->(3,3).
"""

euler_rate_matrix_body_xzy: LightEulerRateMatrixBodyXzy
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, z, y.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_body_xzy`: (3)->(3,3).
"""

euler_rates_xzy: LightEulerRatesXzy
"""Ex 3.10 The rates of Euler angles about x, z, y from the angular velocity in the fixed frame.
Of one element or a contiguous batch. As `chasles.kernels.euler_rates_xzy`: (3),(3)->(3).
"""

rotation_from_euler_yxy: LightRotationFromEulerYxy
"""Ex 3.10 The rotation by Euler angles about y, x, y.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_euler_yxy`: (3)->(3,3).
"""

euler_rate_matrix_yxy: LightEulerRateMatrixYxy
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, x, y.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_yxy`: (3)->(3,3).
"""

euler_rate_matrix_body_yxy: LightEulerRateMatrixBodyYxy
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, x, y.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_body_yxy`: (3)->(3,3).
"""

euler_rates_yxy: LightEulerRatesYxy
"""Ex 3.10 The rates of Euler angles about y, x, y from the angular velocity in the fixed frame.
Of one element or a contiguous batch. As `chasles.kernels.euler_rates_yxy`: (3),(3)->(3).
"""

rotation_from_euler_yxz: LightRotationFromEulerYxz
"""Ex 3.10 The rotation by Euler angles about y, x, z.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_euler_yxz`: (3)->(3,3).
"""

euler_rate_matrix_yxz: LightEulerRateMatrixYxz
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, x, z.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_yxz`: (3)->(3,3).
"""

euler_rate_matrix_body_yxz: LightEulerRateMatrixBodyYxz
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, x, z.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_body_yxz`: (3)->(3,3).
"""

euler_rates_yxz: LightEulerRatesYxz
"""Ex 3.10 The rates of Euler angles about y, x, z from the angular velocity in the fixed frame.
Of one element or a contiguous batch. As `chasles.kernels.euler_rates_yxz`: (3),(3)->(3).
"""

rotation_from_euler_yzx: LightRotationFromEulerYzx
"""Ex 3.10 The rotation by Euler angles about y, z, x.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_euler_yzx`: (3)->(3,3).
"""

euler_rate_matrix_yzx: LightEulerRateMatrixYzx
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, z, x.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_yzx`: (3)->(3,3).
"""

euler_rate_matrix_body_yzx: LightEulerRateMatrixBodyYzx
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, z, x.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_body_yzx`: (3)->(3,3).
"""

euler_rates_yzx: LightEulerRatesYzx
"""Ex 3.10 The rates of Euler angles about y, z, x from the angular velocity in the fixed frame.
Of one element or a contiguous batch. As `chasles.kernels.euler_rates_yzx`: (3),(3)->(3).
"""

rotation_from_euler_yzy: LightRotationFromEulerYzy
"""Ex 3.10 The rotation by Euler angles about y, z, y.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_euler_yzy`: (3)->(3,3).
"""

euler_rate_matrix_yzy: LightEulerRateMatrixYzy
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, z, y.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_yzy`: (3)->(3,3).
"""

euler_rate_matrix_body_yzy: LightEulerRateMatrixBodyYzy
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, z, y.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_body_yzy`: (3)->(3,3).
"""

euler_rates_yzy: LightEulerRatesYzy
"""Ex 3.10 The rates of Euler angles about y, z, y from the angular velocity in the fixed frame.
Of one element or a contiguous batch. As `chasles.kernels.euler_rates_yzy`: (3),(3)->(3).
"""

rotation_from_euler_zxy: LightRotationFromEulerZxy
"""Ex 3.10 The rotation by Euler angles about z, x, y.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_euler_zxy`: (3)->(3,3).
"""

euler_rate_matrix_zxy: LightEulerRateMatrixZxy
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, x, y.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_zxy`: (3)->(3,3).
"""

euler_rate_matrix_body_zxy: LightEulerRateMatrixBodyZxy
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, x, y.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_body_zxy`: (3)->(3,3).
"""

euler_rates_zxy: LightEulerRatesZxy
"""Ex 3.10 The rates of Euler angles about z, x, y from the angular velocity in the fixed frame.
Of one element or a contiguous batch. As `chasles.kernels.euler_rates_zxy`: (3),(3)->(3).
"""

rotation_from_euler_zxz: LightRotationFromEulerZxz
"""Ex 3.10 The rotation by Euler angles about z, x, z.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_euler_zxz`: (3)->(3,3).
"""

euler_rate_matrix_zxz: LightEulerRateMatrixZxz
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, x, z.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_zxz`: (3)->(3,3).
"""

euler_rate_matrix_body_zxz: LightEulerRateMatrixBodyZxz
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, x, z.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_body_zxz`: (3)->(3,3).
"""

euler_rates_zxz: LightEulerRatesZxz
"""Ex 3.10 The rates of Euler angles about z, x, z from the angular velocity in the fixed frame.
Of one element or a contiguous batch. As `chasles.kernels.euler_rates_zxz`: (3),(3)->(3).
"""

rotation_from_euler_zyx: LightRotationFromEulerZyx
"""Ex 3.10 The rotation by Euler angles about z, y, x.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_euler_zyx`: (3)->(3,3).
"""

euler_rate_matrix_zyx: LightEulerRateMatrixZyx
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, y, x.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_zyx`: (3)->(3,3).
"""

euler_rate_matrix_body_zyx: LightEulerRateMatrixBodyZyx
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, y, x.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_body_zyx`: (3)->(3,3).
"""

euler_rates_zyx: LightEulerRatesZyx
"""Ex 3.10 The rates of Euler angles about z, y, x from the angular velocity in the fixed frame.
Of one element or a contiguous batch. As `chasles.kernels.euler_rates_zyx`: (3),(3)->(3).
"""

rotation_from_euler_zyz: LightRotationFromEulerZyz
"""Ex 3.10 The rotation by Euler angles about z, y, z.
Of one element or a contiguous batch. As `chasles.kernels.rotation_from_euler_zyz`: (3)->(3,3).
"""

euler_rate_matrix_zyz: LightEulerRateMatrixZyz
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, y, z.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_zyz`: (3)->(3,3).
"""

euler_rate_matrix_body_zyz: LightEulerRateMatrixBodyZyz
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, y, z.
Of one element or a contiguous batch. As `chasles.kernels.euler_rate_matrix_body_zyz`: (3)->(3,3).
"""

euler_rates_zyz: LightEulerRatesZyz
"""Ex 3.10 The rates of Euler angles about z, y, z from the angular velocity in the fixed frame.
Of one element or a contiguous batch. As `chasles.kernels.euler_rates_zyz`: (3),(3)->(3).
"""
