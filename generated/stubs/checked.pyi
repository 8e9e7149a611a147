"""The functions of `checked` beside `chasles.kernels`. Made by `chasles emit`; not to be edited."""

from .calls import (
    CheckedCrossProductMatrix,
    CheckedRotationFromAxisAngle,
    CheckedPointAfterDisplacement,
    CheckedPitchOfMotion,
    CheckedNormalMatrixInverse,
    CheckedScrewAxisPoint,
    CheckedPluckerLine,
    CheckedPluckerTransfer,
    CheckedRotationInTriadAxes,
    CheckedRotationFromTriads,
    CheckedAxialVector,
    CheckedVelocityOfPoint,
    CheckedInstantScrewPoint,
    CheckedNaturalRateMatrix,
    CheckedLinearRateMatrix,
    CheckedEulerRodriguesRateMatrix,
    CheckedRotationFromLinearInvariants,
    CheckedRotationFromEulerRodrigues,
    CheckedLinearInvariants,
    CheckedNaturalInvariants,
    CheckedEulerRodriguesParameters,
    CheckedScrewOfMotion,
    CheckedInstantScrew,
    CheckedNaturalVelocityMatrix,
    CheckedLinearVelocityMatrix,
    CheckedEulerRodriguesVelocityMatrix,
    CheckedPoseRateNatural,
    CheckedPoseRateLinear,
    CheckedPoseRateEulerRodrigues,
    CheckedTwistFromPoseRateNatural,
    CheckedTwistFromPoseRateLinear,
    CheckedTwistFromPoseRateEulerRodrigues,
    CheckedTwistTransfer,
    CheckedAngularAccelerationMatrix,
    CheckedAccelerationOfPoint,
    CheckedNaturalRateMatrixDot,
    CheckedLinearRateMatrixDot,
    CheckedEulerRodriguesRateMatrixDot,
    CheckedNaturalVelocityMatrixDot,
    CheckedLinearVelocityMatrixDot,
    CheckedEulerRodriguesVelocityMatrixDot,
    CheckedPoseAccelerationNatural,
    CheckedPoseAccelerationLinear,
    CheckedPoseAccelerationEulerRodrigues,
    CheckedTwistRateFromPoseNatural,
    CheckedTwistRateFromPoseLinear,
    CheckedTwistRateFromPoseEulerRodrigues,
    CheckedMovingFrameVelocity,
    CheckedMovingFrameAcceleration,
    CheckedWrenchAxis,
    CheckedPower,
    CheckedReciprocalProduct,
    CheckedWrenchTransfer,
    CheckedInertiaAboutPoint,
    CheckedInertiaAboutPointSym6,
    CheckedMomentumScrew,
    CheckedMomentumScrewSym6,
    CheckedKineticEnergy,
    CheckedKineticEnergySym6,
    CheckedNewtonEulerWrench,
    CheckedNewtonEulerWrenchSym6,
    CheckedNewtonEulerTwistRate,
    CheckedNewtonEulerTwistRateSym6,
    CheckedInertiaDyad,
    CheckedInertiaDyadSym6,
    CheckedRotationFromEulerXyx,
    CheckedEulerRateMatrixXyx,
    CheckedEulerRateMatrixBodyXyx,
    CheckedEulerRatesXyx,
    CheckedRotationFromEulerXyz,
    CheckedEulerRateMatrixXyz,
    CheckedEulerRateMatrixBodyXyz,
    CheckedEulerRatesXyz,
    CheckedRotationFromEulerXzx,
    CheckedEulerRateMatrixXzx,
    CheckedEulerRateMatrixBodyXzx,
    CheckedEulerRatesXzx,
    CheckedRotationFromEulerXzy,
    CheckedEulerRateMatrixXzy,
    CheckedEulerRateMatrixBodyXzy,
    CheckedEulerRatesXzy,
    CheckedRotationFromEulerYxy,
    CheckedEulerRateMatrixYxy,
    CheckedEulerRateMatrixBodyYxy,
    CheckedEulerRatesYxy,
    CheckedRotationFromEulerYxz,
    CheckedEulerRateMatrixYxz,
    CheckedEulerRateMatrixBodyYxz,
    CheckedEulerRatesYxz,
    CheckedRotationFromEulerYzx,
    CheckedEulerRateMatrixYzx,
    CheckedEulerRateMatrixBodyYzx,
    CheckedEulerRatesYzx,
    CheckedRotationFromEulerYzy,
    CheckedEulerRateMatrixYzy,
    CheckedEulerRateMatrixBodyYzy,
    CheckedEulerRatesYzy,
    CheckedRotationFromEulerZxy,
    CheckedEulerRateMatrixZxy,
    CheckedEulerRateMatrixBodyZxy,
    CheckedEulerRatesZxy,
    CheckedRotationFromEulerZxz,
    CheckedEulerRateMatrixZxz,
    CheckedEulerRateMatrixBodyZxz,
    CheckedEulerRatesZxz,
    CheckedRotationFromEulerZyx,
    CheckedEulerRateMatrixZyx,
    CheckedEulerRateMatrixBodyZyx,
    CheckedEulerRatesZyx,
    CheckedRotationFromEulerZyz,
    CheckedEulerRateMatrixZyz,
    CheckedEulerRateMatrixBodyZyz,
    CheckedEulerRatesZyz,
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

cross_product_matrix: CheckedCrossProductMatrix
"""(2.38) The cross-product matrix of v: multiplying by it is taking the vector product with v.
The inputs are tested. As `chasles.kernels.cross_product_matrix`: (3)->(3,3).
"""

rotation_from_axis_angle: CheckedRotationFromAxisAngle
"""(2.49) The rotation about the axis e through the angle phi.
The inputs are tested. As `chasles.kernels.rotation_from_axis_angle`: (3),()->(3,3).
"""

point_after_displacement: CheckedPointAfterDisplacement
"""(3.2) Where a point of the body lies after the displacement.
The inputs are tested. As `chasles.kernels.point_after_displacement`: (3,3),(3),(3),(3)->(3).
"""

pitch_of_motion: CheckedPitchOfMotion
"""(3.7) The pitch from the displacement of any point.
The inputs are tested. As `chasles.kernels.pitch_of_motion`: (3),(),(3)->().
"""

normal_matrix_inverse: CheckedNormalMatrixInverse
"""(3.16) The inverse of the matrix of the normal equations.
The inputs are tested. As `chasles.kernels.normal_matrix_inverse`: (3),()->(3,3).
"""

screw_axis_point: CheckedScrewAxisPoint
"""(3.18) The point of the screw axis nearest the origin.
The inputs are tested. As `chasles.kernels.screw_axis_point`: (3),(),(3),(3)->(3).
"""

plucker_line: CheckedPluckerLine
"""(3.23) The Plücker array of a line: its direction and its moment.
The inputs are tested. As `chasles.kernels.plucker_line`: (3),(3)->(6).
"""

plucker_transfer: CheckedPluckerTransfer
"""(3.29a) The Plücker-coordinate transfer formula.
The inputs are tested. As `chasles.kernels.plucker_transfer`: (6),(3),(3)->(6).
"""

rotation_in_triad_axes: CheckedRotationInTriadAxes
"""text 3.2.3 h The rotation in the axes of the triad, as a product of matrices.
The inputs are tested. As `chasles.kernels.rotation_in_triad_axes`: (3,3),(3,3)->(3,3).
"""

rotation_from_triads: CheckedRotationFromTriads
"""text 3.2.3 g The rotation that takes one triad into the other, in the frame in which both are given.
The inputs are tested. As `chasles.kernels.rotation_from_triads`: (3,3),(3,3)->(3,3).
"""

axial_vector: CheckedAxialVector
"""(3.45) The angular velocity: the axial vector of the angular-velocity matrix.
The inputs are tested. As `chasles.kernels.axial_vector`: (3,3)->(3).
"""

velocity_of_point: CheckedVelocityOfPoint
"""(3.50) The velocity of a point from that of the landmark.
The inputs are tested. As `chasles.kernels.velocity_of_point`: (3),(3),(3),(3)->(3).
"""

instant_screw_point: CheckedInstantScrewPoint
"""(3.70) The point of the instant screw axis nearest the origin, with vector products.
The inputs are tested. As `chasles.kernels.instant_screw_point`: (3),(3),(3)->(3).
"""

natural_rate_matrix: CheckedNaturalRateMatrix
"""(3.76b) The matrix of the natural invariants' rates.
The inputs are tested. As `chasles.kernels.natural_rate_matrix`: (3),()->(4,3).
"""

linear_rate_matrix: CheckedLinearRateMatrix
"""(3.76c) The matrix of the linear invariants' rates.
The inputs are tested. As `chasles.kernels.linear_rate_matrix`: (3),()->(4,3).
"""

euler_rodrigues_rate_matrix: CheckedEulerRodriguesRateMatrix
"""(3.76d) The matrix of the Euler-Rodrigues parameters' rates.
The inputs are tested. As `chasles.kernels.euler_rodrigues_rate_matrix`: (3),()->(4,3).
"""

rotation_from_linear_invariants: CheckedRotationFromLinearInvariants
"""text 3.4.2 f The rotation from its linear invariants.
The inputs are tested. As `chasles.kernels.rotation_from_linear_invariants`: (3),()->(3,3).
"""

rotation_from_euler_rodrigues: CheckedRotationFromEulerRodrigues
"""text 3.4.2 f The rotation from its Euler-Rodrigues parameters.
The inputs are tested. As `chasles.kernels.rotation_from_euler_rodrigues`: (3),()->(3,3).
"""

linear_invariants: CheckedLinearInvariants
"""text 3.4.2 g The linear invariants from the rotation.
The inputs are tested. As `chasles.kernels.linear_invariants`: (3,3)->(3),().
"""

natural_invariants: CheckedNaturalInvariants
"""text 3.4.2 h The natural invariants from the rotation.
The inputs are tested. As `chasles.kernels.natural_invariants`: (3,3)->(3),().
"""

euler_rodrigues_parameters: CheckedEulerRodriguesParameters
"""text 3.4.2 i The Euler-Rodrigues parameters from the rotation.
The inputs are tested. As `chasles.kernels.euler_rodrigues_parameters`: (3,3)->(3),().
"""

screw_of_motion: CheckedScrewOfMotion
"""text 3.4.2 j The screw of a motion: Plücker array of its axis, translation along it, angle.
The inputs are tested. As `chasles.kernels.screw_of_motion`: (3,3),(3),(3)->(6),(),().
"""

instant_screw: CheckedInstantScrew
"""text 3.4.1 c The instant screw: Plücker array of its axis, and pitch.
The inputs are tested. As `chasles.kernels.instant_screw`: (3),(3),(3)->(6),().
"""

natural_velocity_matrix: CheckedNaturalVelocityMatrix
"""(3.77b) The matrix that gives the angular velocity from the natural invariants' rates.
The inputs are tested. As `chasles.kernels.natural_velocity_matrix`: (3),()->(3,4).
"""

linear_velocity_matrix: CheckedLinearVelocityMatrix
"""(3.77c) The matrix that gives the angular velocity from the linear invariants' rates.
The inputs are tested. As `chasles.kernels.linear_velocity_matrix`: (3),()->(3,4).
"""

euler_rodrigues_velocity_matrix: CheckedEulerRodriguesVelocityMatrix
"""(3.77d) The matrix that gives the angular velocity from the Euler-Rodrigues parameters' rates.
The inputs are tested. As `chasles.kernels.euler_rodrigues_velocity_matrix`: (3),()->(3,4).
"""

pose_rate_natural: CheckedPoseRateNatural
"""(3.78) The rate of the pose from the twist, with the natural invariants.
The inputs are tested. As `chasles.kernels.pose_rate_natural`: (3),(),(6)->(7).
"""

pose_rate_linear: CheckedPoseRateLinear
"""(3.78) The rate of the pose from the twist, with the linear invariants.
The inputs are tested. As `chasles.kernels.pose_rate_linear`: (3),(),(6)->(7).
"""

pose_rate_euler_rodrigues: CheckedPoseRateEulerRodrigues
"""(3.78) The rate of the pose from the twist, with the Euler-Rodrigues parameters.
The inputs are tested. As `chasles.kernels.pose_rate_euler_rodrigues`: (3),(),(6)->(7).
"""

twist_from_pose_rate_natural: CheckedTwistFromPoseRateNatural
"""(3.80a) The twist from the rate of the pose, with the natural invariants.
The inputs are tested. As `chasles.kernels.twist_from_pose_rate_natural`: (3),(),(7)->(6).
"""

twist_from_pose_rate_linear: CheckedTwistFromPoseRateLinear
"""(3.80a) The twist from the rate of the pose, with the linear invariants.
The inputs are tested. As `chasles.kernels.twist_from_pose_rate_linear`: (3),(),(7)->(6).
"""

twist_from_pose_rate_euler_rodrigues: CheckedTwistFromPoseRateEulerRodrigues
"""(3.80a) The twist from the rate of the pose, with the Euler-Rodrigues parameters.
The inputs are tested. As `chasles.kernels.twist_from_pose_rate_euler_rodrigues`: (3),(),(7)->(6).
"""

twist_transfer: CheckedTwistTransfer
"""(3.83a) The twist-transfer formula.
The inputs are tested. As `chasles.kernels.twist_transfer`: (6),(3),(3)->(6).
"""

angular_acceleration_matrix: CheckedAngularAccelerationMatrix
"""(3.86) The angular-acceleration matrix.
The inputs are tested. As `chasles.kernels.angular_acceleration_matrix`: (3),(3)->(3,3).
"""

acceleration_of_point: CheckedAccelerationOfPoint
"""(3.89) The acceleration of a point from that of the landmark, with vector products.
The inputs are tested. As `chasles.kernels.acceleration_of_point`: (3),(3),(3),(3),(3)->(3).
"""

natural_rate_matrix_dot: CheckedNaturalRateMatrixDot
"""text 3.5 f The rate of N by axis, angle and angular velocity: (3.96a).
The inputs are tested. As `chasles.kernels.natural_rate_matrix_dot`: (3),(),(3)->(4,3).
"""

linear_rate_matrix_dot: CheckedLinearRateMatrixDot
"""text 3.5 f The rate of L by axis, angle and angular velocity: (3.96b).
The inputs are tested. As `chasles.kernels.linear_rate_matrix_dot`: (3),(),(3)->(4,3).
"""

euler_rodrigues_rate_matrix_dot: CheckedEulerRodriguesRateMatrixDot
"""text 3.5 f The rate of H by axis, angle and angular velocity: (3.96c).
The inputs are tested. As `chasles.kernels.euler_rodrigues_rate_matrix_dot`: (3),(),(3)->(4,3).
"""

natural_velocity_matrix_dot: CheckedNaturalVelocityMatrixDot
"""text 3.5 g The rate of the left inverse of N by axis, angle and angular velocity: (3.97a).
The inputs are tested. As `chasles.kernels.natural_velocity_matrix_dot`: (3),(),(3)->(3,4).
"""

linear_velocity_matrix_dot: CheckedLinearVelocityMatrixDot
"""text 3.5 g The rate of the left inverse of L by axis, angle and angular velocity: (3.97b).
The inputs are tested. As `chasles.kernels.linear_velocity_matrix_dot`: (3),(),(3)->(3,4).
"""

euler_rodrigues_velocity_matrix_dot: CheckedEulerRodriguesVelocityMatrixDot
"""text 3.5 g The rate of the left inverse of H by axis, angle and angular velocity: (3.97c).
The inputs are tested. As `chasles.kernels.euler_rodrigues_velocity_matrix_dot`: (3),(),(3)->(3,4).
"""

pose_acceleration_natural: CheckedPoseAccelerationNatural
"""text 3.5 h The second rate of the pose from the twist and its rate, with the natural invariants.
The inputs are tested. As `chasles.kernels.pose_acceleration_natural`: (3),(),(6),(6)->(7).
"""

pose_acceleration_linear: CheckedPoseAccelerationLinear
"""text 3.5 h The second rate of the pose from the twist and its rate, with the linear invariants.
The inputs are tested. As `chasles.kernels.pose_acceleration_linear`: (3),(),(6),(6)->(7).
"""

pose_acceleration_euler_rodrigues: CheckedPoseAccelerationEulerRodrigues
"""text 3.5 h The second rate of the pose from the twist and its rate, with the Euler-Rodrigues parameters.
The inputs are tested. As `chasles.kernels.pose_acceleration_euler_rodrigues`: (3),(),(6),(6)->(7).
"""

twist_rate_from_pose_natural: CheckedTwistRateFromPoseNatural
"""text 3.5 i The rate of the twist from the rates of the pose, with the natural invariants.
The inputs are tested. As `chasles.kernels.twist_rate_from_pose_natural`: (3),(),(7),(7)->(6).
"""

twist_rate_from_pose_linear: CheckedTwistRateFromPoseLinear
"""text 3.5 i The rate of the twist from the rates of the pose, with the linear invariants.
The inputs are tested. As `chasles.kernels.twist_rate_from_pose_linear`: (3),(),(7),(7)->(6).
"""

twist_rate_from_pose_euler_rodrigues: CheckedTwistRateFromPoseEulerRodrigues
"""text 3.5 i The rate of the twist from the rates of the pose, with the Euler-Rodrigues parameters.
The inputs are tested. As `chasles.kernels.twist_rate_from_pose_euler_rodrigues`: (3),(),(7),(7)->(6).
"""

moving_frame_velocity: CheckedMovingFrameVelocity
"""(3.103) The velocity of P in the fixed frame from that in the moving frame.
The inputs are tested. As `chasles.kernels.moving_frame_velocity`: (3),(3,3),(3),(3),(3)->(3).
"""

moving_frame_acceleration: CheckedMovingFrameAcceleration
"""(3.105) The acceleration of P in the fixed frame: as a point of the moving frame, Coriolis, and in the moving frame.
The inputs are tested. As `chasles.kernels.moving_frame_acceleration`: (3),(3,3),(3),(3),(3),(3),(3)->(3).
"""

wrench_axis: CheckedWrenchAxis
"""text 3.7 d The axis and the pitch of the wrench.
The inputs are tested. As `chasles.kernels.wrench_axis`: (3),(3),(3)->(6),().
"""

power: CheckedPower
"""(3.114) The power developed by a wrench on a body that moves with a twist at the same point.
The inputs are tested. As `chasles.kernels.power`: (6),(6)->().
"""

reciprocal_product: CheckedReciprocalProduct
"""text 3.7 k The reciprocal product of two screws, in either order.
The inputs are tested. As `chasles.kernels.reciprocal_product`: (6),(6)->().
"""

wrench_transfer: CheckedWrenchTransfer
"""(3.119a) The wrench-transfer formula.
The inputs are tested. As `chasles.kernels.wrench_transfer`: (6),(3),(3)->(6).
"""

inertia_about_point: CheckedInertiaAboutPoint
"""(3.133a) Steiner's theorem: the moment of inertia with respect to A from that at the center of mass.
The inputs are tested. As `chasles.kernels.inertia_about_point`: (3,3),(),(3),(3)->(3,3).
"""

inertia_about_point_sym6: CheckedInertiaAboutPointSym6
"""(3.133a) Steiner's theorem: the moment of inertia with respect to A from that at the center of mass.
The inputs are tested. As `chasles.kernels.inertia_about_point_sym6`: (6),(),(3),(3)->(6).
"""

momentum_screw: CheckedMomentumScrew
"""(3.142) The momentum screw by inertia dyad and twist.
The inputs are tested. As `chasles.kernels.momentum_screw`: (3,3),(),(6)->(6).
"""

momentum_screw_sym6: CheckedMomentumScrewSym6
"""(3.142) The momentum screw by inertia dyad and twist.
The inputs are tested. As `chasles.kernels.momentum_screw_sym6`: (6),(),(6)->(6).
"""

kinetic_energy: CheckedKineticEnergy
"""(3.145) The kinetic energy as a quadratic form of the twist.
The inputs are tested. As `chasles.kernels.kinetic_energy`: (3,3),(),(6)->().
"""

kinetic_energy_sym6: CheckedKineticEnergySym6
"""(3.145) The kinetic energy as a quadratic form of the twist.
The inputs are tested. As `chasles.kernels.kinetic_energy_sym6`: (6),(),(6)->().
"""

newton_euler_wrench: CheckedNewtonEulerWrench
"""text 3.8 v The wrench that moves the body: the Newton-Euler equations as they stand.
The inputs are tested. As `chasles.kernels.newton_euler_wrench`: (3,3),(),(6),(6)->(6).
"""

newton_euler_wrench_sym6: CheckedNewtonEulerWrenchSym6
"""text 3.8 v The wrench that moves the body: the Newton-Euler equations as they stand.
The inputs are tested. As `chasles.kernels.newton_euler_wrench_sym6`: (6),(),(6),(6)->(6).
"""

newton_euler_twist_rate: CheckedNewtonEulerTwistRate
"""text 3.8 v The rate of the twist of a body on which a wrench acts: the Newton-Euler equations solved.
The inputs are tested. As `chasles.kernels.newton_euler_twist_rate`: (3,3),(),(6),(6)->(6).
"""

newton_euler_twist_rate_sym6: CheckedNewtonEulerTwistRateSym6
"""text 3.8 v The rate of the twist of a body on which a wrench acts: the Newton-Euler equations solved.
The inputs are tested. As `chasles.kernels.newton_euler_twist_rate_sym6`: (6),(),(6),(6)->(6).
"""

inertia_dyad: CheckedInertiaDyad
"""(3.147) The inertia dyad at A.
The inputs are tested. As `chasles.kernels.inertia_dyad`: (3,3),(),(3),(3)->(6,6).
"""

inertia_dyad_sym6: CheckedInertiaDyadSym6
"""(3.147) The inertia dyad at A.
The inputs are tested. As `chasles.kernels.inertia_dyad_sym6`: (6),(),(3),(3)->(6,6).
"""

rotation_from_euler_xyx: CheckedRotationFromEulerXyx
"""Ex 3.10 The rotation by Euler angles about x, y, x.
The inputs are tested. As `chasles.kernels.rotation_from_euler_xyx`: (3)->(3,3).
"""

euler_rate_matrix_xyx: CheckedEulerRateMatrixXyx
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, y, x.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_xyx`: (3)->(3,3).
"""

euler_rate_matrix_body_xyx: CheckedEulerRateMatrixBodyXyx
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, y, x.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_body_xyx`: (3)->(3,3).
"""

euler_rates_xyx: CheckedEulerRatesXyx
"""Ex 3.10 The rates of Euler angles about x, y, x from the angular velocity in the fixed frame.
The inputs are tested. As `chasles.kernels.euler_rates_xyx`: (3),(3)->(3).
"""

rotation_from_euler_xyz: CheckedRotationFromEulerXyz
"""Ex 3.10 The rotation by Euler angles about x, y, z.
The inputs are tested. As `chasles.kernels.rotation_from_euler_xyz`: (3)->(3,3).
"""

euler_rate_matrix_xyz: CheckedEulerRateMatrixXyz
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, y, z.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_xyz`: (3)->(3,3).
"""

euler_rate_matrix_body_xyz: CheckedEulerRateMatrixBodyXyz
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, y, z.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_body_xyz`: (3)->(3,3).
"""

euler_rates_xyz: CheckedEulerRatesXyz
"""Ex 3.10 The rates of Euler angles about x, y, z from the angular velocity in the fixed frame.
The inputs are tested. As `chasles.kernels.euler_rates_xyz`: (3),(3)->(3).
"""

rotation_from_euler_xzx: CheckedRotationFromEulerXzx
"""Ex 3.10 The rotation by Euler angles about x, z, x.
The inputs are tested. As `chasles.kernels.rotation_from_euler_xzx`: (3)->(3,3).
"""

euler_rate_matrix_xzx: CheckedEulerRateMatrixXzx
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, z, x.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_xzx`: (3)->(3,3).
"""

euler_rate_matrix_body_xzx: CheckedEulerRateMatrixBodyXzx
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, z, x.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_body_xzx`: (3)->(3,3).
"""

euler_rates_xzx: CheckedEulerRatesXzx
"""Ex 3.10 The rates of Euler angles about x, z, x from the angular velocity in the fixed frame.
The inputs are tested. As `chasles.kernels.euler_rates_xzx`: (3),(3)->(3).
"""

rotation_from_euler_xzy: CheckedRotationFromEulerXzy
"""Ex 3.10 The rotation by Euler angles about x, z, y.
The inputs are tested. As `chasles.kernels.rotation_from_euler_xzy`: (3)->(3,3).
"""

euler_rate_matrix_xzy: CheckedEulerRateMatrixXzy
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, z, y.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_xzy`: (3)->(3,3).
"""

euler_rate_matrix_body_xzy: CheckedEulerRateMatrixBodyXzy
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, z, y.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_body_xzy`: (3)->(3,3).
"""

euler_rates_xzy: CheckedEulerRatesXzy
"""Ex 3.10 The rates of Euler angles about x, z, y from the angular velocity in the fixed frame.
The inputs are tested. As `chasles.kernels.euler_rates_xzy`: (3),(3)->(3).
"""

rotation_from_euler_yxy: CheckedRotationFromEulerYxy
"""Ex 3.10 The rotation by Euler angles about y, x, y.
The inputs are tested. As `chasles.kernels.rotation_from_euler_yxy`: (3)->(3,3).
"""

euler_rate_matrix_yxy: CheckedEulerRateMatrixYxy
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, x, y.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_yxy`: (3)->(3,3).
"""

euler_rate_matrix_body_yxy: CheckedEulerRateMatrixBodyYxy
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, x, y.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_body_yxy`: (3)->(3,3).
"""

euler_rates_yxy: CheckedEulerRatesYxy
"""Ex 3.10 The rates of Euler angles about y, x, y from the angular velocity in the fixed frame.
The inputs are tested. As `chasles.kernels.euler_rates_yxy`: (3),(3)->(3).
"""

rotation_from_euler_yxz: CheckedRotationFromEulerYxz
"""Ex 3.10 The rotation by Euler angles about y, x, z.
The inputs are tested. As `chasles.kernels.rotation_from_euler_yxz`: (3)->(3,3).
"""

euler_rate_matrix_yxz: CheckedEulerRateMatrixYxz
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, x, z.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_yxz`: (3)->(3,3).
"""

euler_rate_matrix_body_yxz: CheckedEulerRateMatrixBodyYxz
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, x, z.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_body_yxz`: (3)->(3,3).
"""

euler_rates_yxz: CheckedEulerRatesYxz
"""Ex 3.10 The rates of Euler angles about y, x, z from the angular velocity in the fixed frame.
The inputs are tested. As `chasles.kernels.euler_rates_yxz`: (3),(3)->(3).
"""

rotation_from_euler_yzx: CheckedRotationFromEulerYzx
"""Ex 3.10 The rotation by Euler angles about y, z, x.
The inputs are tested. As `chasles.kernels.rotation_from_euler_yzx`: (3)->(3,3).
"""

euler_rate_matrix_yzx: CheckedEulerRateMatrixYzx
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, z, x.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_yzx`: (3)->(3,3).
"""

euler_rate_matrix_body_yzx: CheckedEulerRateMatrixBodyYzx
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, z, x.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_body_yzx`: (3)->(3,3).
"""

euler_rates_yzx: CheckedEulerRatesYzx
"""Ex 3.10 The rates of Euler angles about y, z, x from the angular velocity in the fixed frame.
The inputs are tested. As `chasles.kernels.euler_rates_yzx`: (3),(3)->(3).
"""

rotation_from_euler_yzy: CheckedRotationFromEulerYzy
"""Ex 3.10 The rotation by Euler angles about y, z, y.
The inputs are tested. As `chasles.kernels.rotation_from_euler_yzy`: (3)->(3,3).
"""

euler_rate_matrix_yzy: CheckedEulerRateMatrixYzy
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, z, y.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_yzy`: (3)->(3,3).
"""

euler_rate_matrix_body_yzy: CheckedEulerRateMatrixBodyYzy
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, z, y.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_body_yzy`: (3)->(3,3).
"""

euler_rates_yzy: CheckedEulerRatesYzy
"""Ex 3.10 The rates of Euler angles about y, z, y from the angular velocity in the fixed frame.
The inputs are tested. As `chasles.kernels.euler_rates_yzy`: (3),(3)->(3).
"""

rotation_from_euler_zxy: CheckedRotationFromEulerZxy
"""Ex 3.10 The rotation by Euler angles about z, x, y.
The inputs are tested. As `chasles.kernels.rotation_from_euler_zxy`: (3)->(3,3).
"""

euler_rate_matrix_zxy: CheckedEulerRateMatrixZxy
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, x, y.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_zxy`: (3)->(3,3).
"""

euler_rate_matrix_body_zxy: CheckedEulerRateMatrixBodyZxy
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, x, y.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_body_zxy`: (3)->(3,3).
"""

euler_rates_zxy: CheckedEulerRatesZxy
"""Ex 3.10 The rates of Euler angles about z, x, y from the angular velocity in the fixed frame.
The inputs are tested. As `chasles.kernels.euler_rates_zxy`: (3),(3)->(3).
"""

rotation_from_euler_zxz: CheckedRotationFromEulerZxz
"""Ex 3.10 The rotation by Euler angles about z, x, z.
The inputs are tested. As `chasles.kernels.rotation_from_euler_zxz`: (3)->(3,3).
"""

euler_rate_matrix_zxz: CheckedEulerRateMatrixZxz
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, x, z.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_zxz`: (3)->(3,3).
"""

euler_rate_matrix_body_zxz: CheckedEulerRateMatrixBodyZxz
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, x, z.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_body_zxz`: (3)->(3,3).
"""

euler_rates_zxz: CheckedEulerRatesZxz
"""Ex 3.10 The rates of Euler angles about z, x, z from the angular velocity in the fixed frame.
The inputs are tested. As `chasles.kernels.euler_rates_zxz`: (3),(3)->(3).
"""

rotation_from_euler_zyx: CheckedRotationFromEulerZyx
"""Ex 3.10 The rotation by Euler angles about z, y, x.
The inputs are tested. As `chasles.kernels.rotation_from_euler_zyx`: (3)->(3,3).
"""

euler_rate_matrix_zyx: CheckedEulerRateMatrixZyx
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, y, x.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_zyx`: (3)->(3,3).
"""

euler_rate_matrix_body_zyx: CheckedEulerRateMatrixBodyZyx
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, y, x.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_body_zyx`: (3)->(3,3).
"""

euler_rates_zyx: CheckedEulerRatesZyx
"""Ex 3.10 The rates of Euler angles about z, y, x from the angular velocity in the fixed frame.
The inputs are tested. As `chasles.kernels.euler_rates_zyx`: (3),(3)->(3).
"""

rotation_from_euler_zyz: CheckedRotationFromEulerZyz
"""Ex 3.10 The rotation by Euler angles about z, y, z.
The inputs are tested. As `chasles.kernels.rotation_from_euler_zyz`: (3)->(3,3).
"""

euler_rate_matrix_zyz: CheckedEulerRateMatrixZyz
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, y, z.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_zyz`: (3)->(3,3).
"""

euler_rate_matrix_body_zyz: CheckedEulerRateMatrixBodyZyz
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, y, z.
The inputs are tested. As `chasles.kernels.euler_rate_matrix_body_zyz`: (3)->(3,3).
"""

euler_rates_zyz: CheckedEulerRatesZyz
"""Ex 3.10 The rates of Euler angles about z, y, z from the angular velocity in the fixed frame.
The inputs are tested. As `chasles.kernels.euler_rates_zyz`: (3),(3)->(3).
"""
