"""The kernels of `chasles.kernels`. Made by `chasles emit`; not to be edited."""

from .calls import (
    UfuncCrossProductMatrix,
    UfuncRotationFromAxisAngle,
    UfuncPointAfterDisplacement,
    UfuncPitchOfMotion,
    UfuncNormalMatrixInverse,
    UfuncScrewAxisPoint,
    UfuncPluckerLine,
    UfuncPluckerTransfer,
    UfuncRotationInTriadAxes,
    UfuncRotationFromTriads,
    UfuncAxialVector,
    UfuncVelocityOfPoint,
    UfuncInstantScrewPoint,
    UfuncNaturalRateMatrix,
    UfuncLinearRateMatrix,
    UfuncEulerRodriguesRateMatrix,
    UfuncRotationFromLinearInvariants,
    UfuncRotationFromEulerRodrigues,
    UfuncLinearInvariants,
    UfuncNaturalInvariants,
    UfuncEulerRodriguesParameters,
    UfuncScrewOfMotion,
    UfuncInstantScrew,
    UfuncNaturalVelocityMatrix,
    UfuncLinearVelocityMatrix,
    UfuncEulerRodriguesVelocityMatrix,
    UfuncPoseRateNatural,
    UfuncPoseRateLinear,
    UfuncPoseRateEulerRodrigues,
    UfuncTwistFromPoseRateNatural,
    UfuncTwistFromPoseRateLinear,
    UfuncTwistFromPoseRateEulerRodrigues,
    UfuncTwistTransfer,
    UfuncAngularAccelerationMatrix,
    UfuncAccelerationOfPoint,
    UfuncNaturalRateMatrixDot,
    UfuncLinearRateMatrixDot,
    UfuncEulerRodriguesRateMatrixDot,
    UfuncNaturalVelocityMatrixDot,
    UfuncLinearVelocityMatrixDot,
    UfuncEulerRodriguesVelocityMatrixDot,
    UfuncPoseAccelerationNatural,
    UfuncPoseAccelerationLinear,
    UfuncPoseAccelerationEulerRodrigues,
    UfuncTwistRateFromPoseNatural,
    UfuncTwistRateFromPoseLinear,
    UfuncTwistRateFromPoseEulerRodrigues,
    UfuncMovingFrameVelocity,
    UfuncMovingFrameAcceleration,
    UfuncWrenchAxis,
    UfuncPower,
    UfuncReciprocalProduct,
    UfuncWrenchTransfer,
    UfuncInertiaAboutPoint,
    UfuncInertiaAboutPointSym6,
    UfuncMomentumScrew,
    UfuncMomentumScrewSym6,
    UfuncKineticEnergy,
    UfuncKineticEnergySym6,
    UfuncNewtonEulerWrench,
    UfuncNewtonEulerWrenchSym6,
    UfuncNewtonEulerTwistRate,
    UfuncNewtonEulerTwistRateSym6,
    UfuncInertiaDyad,
    UfuncInertiaDyadSym6,
    UfuncRotationFromEulerXyx,
    UfuncEulerRateMatrixXyx,
    UfuncEulerRateMatrixBodyXyx,
    UfuncEulerRatesXyx,
    UfuncRotationFromEulerXyz,
    UfuncEulerRateMatrixXyz,
    UfuncEulerRateMatrixBodyXyz,
    UfuncEulerRatesXyz,
    UfuncRotationFromEulerXzx,
    UfuncEulerRateMatrixXzx,
    UfuncEulerRateMatrixBodyXzx,
    UfuncEulerRatesXzx,
    UfuncRotationFromEulerXzy,
    UfuncEulerRateMatrixXzy,
    UfuncEulerRateMatrixBodyXzy,
    UfuncEulerRatesXzy,
    UfuncRotationFromEulerYxy,
    UfuncEulerRateMatrixYxy,
    UfuncEulerRateMatrixBodyYxy,
    UfuncEulerRatesYxy,
    UfuncRotationFromEulerYxz,
    UfuncEulerRateMatrixYxz,
    UfuncEulerRateMatrixBodyYxz,
    UfuncEulerRatesYxz,
    UfuncRotationFromEulerYzx,
    UfuncEulerRateMatrixYzx,
    UfuncEulerRateMatrixBodyYzx,
    UfuncEulerRatesYzx,
    UfuncRotationFromEulerYzy,
    UfuncEulerRateMatrixYzy,
    UfuncEulerRateMatrixBodyYzy,
    UfuncEulerRatesYzy,
    UfuncRotationFromEulerZxy,
    UfuncEulerRateMatrixZxy,
    UfuncEulerRateMatrixBodyZxy,
    UfuncEulerRatesZxy,
    UfuncRotationFromEulerZxz,
    UfuncEulerRateMatrixZxz,
    UfuncEulerRateMatrixBodyZxz,
    UfuncEulerRatesZxz,
    UfuncRotationFromEulerZyx,
    UfuncEulerRateMatrixZyx,
    UfuncEulerRateMatrixBodyZyx,
    UfuncEulerRatesZyx,
    UfuncRotationFromEulerZyz,
    UfuncEulerRateMatrixZyz,
    UfuncEulerRateMatrixBodyZyz,
    UfuncEulerRatesZyz,
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

cross_product_matrix: UfuncCrossProductMatrix
"""(2.38) The cross-product matrix of v: multiplying by it is taking the vector product with v.
given       v (3): any vector
returns     V (3, 3): cross-product matrix of a vector
verdict     defined
assumes     nothing
operations  0
error bound exact, for all inputs
derivation  sha256 1dcc0e58f219711b3c3f86b749f8c10b4db63734a02b20de3d9c405c9765483d
signature   (3)->(3,3)
"""

rotation_from_axis_angle: UfuncRotationFromAxisAngle
"""(2.49) The rotation about the axis e through the angle phi.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
returns     Q (3, 3): rotation
verdict     defined
assumes     |e| = 1
operations  24: 6 add, 4 subtract, 12 multiply, 1 sine, 1 cosine
error bound 6.1 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
              precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 dd485fc9fc55c9da723bbd623b2225ec82c9e8dbfe322dbf4dfe768c7d30e93a
signature   (3),()->(3,3)
"""

point_after_displacement: UfuncPointAfterDisplacement
"""(3.2) Where a point of the body lies after the displacement.
given       Q (3, 3): rotation
            a (3): position of the landmark point A
            a_prime (3): position of A after the displacement
            p (3): position of any point P
returns     p_prime (3): position of P after the displacement
verdict     holds
assumes     nothing
expects     Q is a rotation
operations  21: 9 add, 3 subtract, 9 multiply
error bound 5.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 af99d11eca408718e24cab7a00a1fd908df2c4445259caf108fa6366c29b6560
signature   (3,3),(3),(3),(3)->(3)
"""

pitch_of_motion: UfuncPitchOfMotion
"""(3.7) The pitch from the displacement of any point.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            d_P (3): displacement of P
returns     result: d0 / phi
verdict     holds under
assumes     phi != 0
            |e| = 1
operations  6: 2 add, 3 multiply, 1 divide
error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 a00b650de0c575f7c9b2294f993cd4d248ffaaa64b28a7f2d4581cd5c90cdf7f
signature   (3),(),(3)->()
"""

normal_matrix_inverse: UfuncNormalMatrixInverse
"""(3.16) The inverse of the matrix of the normal equations.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
returns     result (3, 3): (A^T A)^-1
verdict     holds under
assumes     phi != 0
            |e| = 1
operations  17: 3 add, 1 subtract, 11 multiply, 1 divide, 1 sine
error bound 8.4 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
              precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine within 0.8 ulp
derivation  sha256 1a335cc68a85257903e9024003c40a39af04dc468b703619f454e7c6495b1c9c
signature   (3),()->(3,3)
"""

screw_axis_point: UfuncScrewAxisPoint
"""(3.18) The point of the screw axis nearest the origin.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            a (3): position of the landmark point A
            a_prime (3): position of A after the displacement
returns     p_0 (3): position of the point of the screw axis nearest the origin
verdict     holds under
assumes     phi != 0
            |e| = 1
made of     an offered form, proved equal to the statement
operations  39: 5 add, 12 subtract, 19 multiply, 1 divide, 1 sine, 1 cosine
error bound 9.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 41aeb7a69bd4c902412187ac18c770eab3e24db7018b56881eddfad568648df0
signature   (3),(),(3),(3)->(3)
"""

plucker_line: UfuncPluckerLine
"""(3.23) The Plücker array of a line: its direction and its moment.
given       p_1 (3): position of point P_1
            p_2 (3): position of point P_2
returns     kappa (6): Pluecker array: direction and moment
verdict     defined
assumes     p_1 != p_2
operations  24: 2 add, 6 subtract, 9 multiply, 6 divide, 1 square root
error bound 9.51 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 32c3975b5a0a9106d94e083a43fadc2be5fbb7bda4c600d797436f2a818ba4e5
signature   (3),(3)->(6)
"""

plucker_transfer: UfuncPluckerTransfer
"""(3.29a) The Plücker-coordinate transfer formula.
given       kappa_A (6): Pluecker array with the moment about A
            a (3): position of the landmark point A
            b (3): position of point B
returns     kappa_B (6): Pluecker array with the moment about B
verdict     holds
assumes     nothing
operations  15: 3 add, 6 subtract, 6 multiply
error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 6d53a1bee79a6a2a63aafa29de9b2815a5d19f7d96ef743e8fd201bd98bf5faf
signature   (6),(3),(3)->(6)
"""

rotation_in_triad_axes: UfuncRotationInTriadAxes
"""text 3.2.3 h The rotation in the axes of the triad, as a product of matrices.
given       triad (3, 3): the triad as columns
            triad_prime (3, 3): the displaced triad as columns
returns     Q (3, 3): components of the rotation in the axes of the triad
verdict     holds
assumes     nothing
expects     triad is a rotation
            triad' is a rotation
operations  45: 18 add, 27 multiply
error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 17b2c6690d171cd369c93be59a7a8c3b70bc0108c48d7358142e2312ebf805ee
signature   (3,3),(3,3)->(3,3)
"""

rotation_from_triads: UfuncRotationFromTriads
"""text 3.2.3 g The rotation that takes one triad into the other, in the frame in which both are given.
given       triad (3, 3): the triad as columns
            triad_prime (3, 3): the displaced triad as columns
returns     Q (3, 3): rotation
verdict     holds under
assumes     e_1, e_2, e_3 are orthonormal and right-handed
expects     triad is a rotation
            triad' is a rotation
operations  45: 18 add, 27 multiply
error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 0c12a1c3d699670fac6168e45da2070083d35015f2bd6eac4cd2f1464da2b780
signature   (3,3),(3,3)->(3,3)
"""

axial_vector: UfuncAxialVector
"""(3.45) The angular velocity: the axial vector of the angular-velocity matrix.
given       Omega (3, 3): angular-velocity matrix
returns     omega (3): angular velocity
verdict     defined
assumes     nothing
operations  6: 3 subtract, 3 multiply
error bound 1.01 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 8c4348a6af61531ef5e1d340b707a886d5ae17216e0e81a5fdda49099e70eece
signature   (3,3)->(3)
"""

velocity_of_point: UfuncVelocityOfPoint
"""(3.50) The velocity of a point from that of the landmark.
given       omega (3): angular velocity
            a_dot (3): time derivative of: position of the landmark point A
            a (3): position of the landmark point A
            p (3): position of any point P
returns     p_dot (3): time derivative of: position of any point P
verdict     holds
assumes     nothing
operations  15: 3 add, 6 subtract, 6 multiply
error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 b5acf63f8b2ae232595725548e5ba32264be6bf6d52d501066130e78c9ed0486
signature   (3),(3),(3),(3)->(3)
"""

instant_screw_point: UfuncInstantScrewPoint
"""(3.70) The point of the instant screw axis nearest the origin, with vector products.
given       omega (3): angular velocity
            a_dot (3): time derivative of: position of the landmark point A
            a (3): position of the landmark point A
returns     p_0_prime (3): position of the point of the instant screw axis nearest the origin
verdict     holds under
assumes     omega != 0
operations  35: 2 add, 9 subtract, 15 multiply, 9 divide
error bound 13.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 8add5ae098bd1648bf2231d712391a8ce89357247f8df1a150855707c8b25192
signature   (3),(3),(3)->(3)
"""

natural_rate_matrix: UfuncNaturalRateMatrix
"""(3.76b) The matrix of the natural invariants' rates.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
returns     N (4, 3): natural invariants' rates from the angular velocity
verdict     defined
assumes     |e| = 1
            phi != 0
operations  26: 6 add, 3 subtract, 14 multiply, 1 divide, 1 sine, 1 cosine
error bound 6.0 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
              precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 ae8848864c3fe36678c44ede0fea89f8af655c143bdb95acf6bb13cd98cc80e0
signature   (3),()->(4,3)
"""

linear_rate_matrix: UfuncLinearRateMatrix
"""(3.76c) The matrix of the linear invariants' rates.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
returns     L (4, 3): linear invariants' rates from the angular velocity
verdict     defined
assumes     |e| = 1
operations  30: 4 add, 7 subtract, 17 multiply, 1 sine, 1 cosine
error bound 5.2 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
              precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 dc969a2458fb1ccbe6cf9ba4bd5c14c48137796a5e63b6fdffe960bc3f43a806
signature   (3),()->(4,3)
"""

euler_rodrigues_rate_matrix: UfuncEulerRodriguesRateMatrix
"""(3.76d) The matrix of the Euler-Rodrigues parameters' rates.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
returns     H (4, 3): Euler-Rodrigues parameters' rates from the angular velocity
verdict     defined
assumes     |e| = 1
operations  8: 6 multiply, 1 sine, 1 cosine
error bound 2.61 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 6c847b4baa2596c76e6ab0bd3e04d8ba67a999fd27b87b011fca1a1dab6d4147
signature   (3),()->(4,3)
"""

rotation_from_linear_invariants: UfuncRotationFromLinearInvariants
"""text 3.4.2 f The rotation from its linear invariants.
given       q (3): vector part of four invariants of the rotation
            q_0: scalar part of four invariants of the rotation
returns     Q (3, 3): rotation
verdict     holds under
assumes     phi != pi
expects     |[q, q_0]| = 1
            1 + q_0 != 0
operations  20: 7 add, 3 subtract, 9 multiply, 1 divide
error bound 5.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 19e234a754a5568e2a2452e2008c17414b949e07381e92256366ba6cc7d976bb
signature   (3),()->(3,3)
"""

rotation_from_euler_rodrigues: UfuncRotationFromEulerRodrigues
"""text 3.4.2 f The rotation from its Euler-Rodrigues parameters.
given       q (3): vector part of four invariants of the rotation
            q_0: scalar part of four invariants of the rotation
returns     Q (3, 3): rotation
verdict     holds under
assumes     |e| = 1
expects     |[q, q_0]| = 1
operations  29: 8 add, 4 subtract, 17 multiply
error bound 5.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 767311161fbd53fb1cb19724605fdf117b3445cf5f7cf313ccc6ecbf4a40f8c5
signature   (3),()->(3,3)
"""

linear_invariants: UfuncLinearInvariants
"""text 3.4.2 g The linear invariants from the rotation.
given       Q (3, 3): rotation
returns     q (3): vector part of four invariants of the rotation
            q_0: scalar part of four invariants of the rotation
verdict     holds under
assumes     |e| = 1
expects     Q is a rotation
operations  10: 2 add, 4 subtract, 4 multiply
error bound q: 1.01 u of itself, for all inputs
            q_0: 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single
              precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 dd83557748f8a3babd3f50468d387276f7ffb668b7fc29c093a7976e71eaabef
signature   (3,3)->(3),()
"""

natural_invariants: UfuncNaturalInvariants
"""text 3.4.2 h The natural invariants from the rotation.
given       Q (3, 3): rotation
returns     e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
verdict     holds under
assumes     Q is a rotation
            phi != 0
operations  63: 23 add, 7 subtract, 22 multiply, 8 divide, 2 square root, 1 arctangent2
error bound e: 13.16 u of itself, for every rotation Q, beside the case that is taken
            phi: 26.99 u of itself, for every rotation Q, beside the case that is taken; u =
              2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, arctangent within 1
              ulp
derivation  sha256 167078e6ba9dff78870c0f0ddc85370ad11a1b0b824ddf316c3c9f19bd756081
signature   (3,3)->(3),()
"""

euler_rodrigues_parameters: UfuncEulerRodriguesParameters
"""text 3.4.2 i The Euler-Rodrigues parameters from the rotation.
given       Q (3, 3): rotation
returns     q (3): vector part of four invariants of the rotation
            q_0: scalar part of four invariants of the rotation
verdict     holds under
assumes     Q is a rotation
operations  50: 21 add, 7 subtract, 17 multiply, 4 divide, 1 square root
error bound q: 11.66 u of itself, for every rotation Q, beside the case that is taken
            q_0: 9.34 u of itself, for every rotation Q, beside the case that is taken; u = 2^-53,
              in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 acb16a335b8480158c7d6e339e4c3de8c51cf3bffd9594c8aa4b639840b77580
signature   (3,3)->(3),()
"""

screw_of_motion: UfuncScrewOfMotion
"""text 3.4.2 j The screw of a motion: Plücker array of its axis, translation along it, angle.
given       Q (3, 3): rotation
            a (3): position of the landmark point A
            a_prime (3): position of A after the displacement
returns     axis (6): [e; p_0 x e]
            d_0: e . (a' - a)
            phi: angle of rotation
verdict     holds under
assumes     Q is a rotation
            phi != 0
made of     an offered form, proved equal to the statement
operations  114: 31 add, 19 subtract, 49 multiply, 12 divide, 2 square root, 1 arctangent2
error bound axis: 59.30 u of the sum of its terms' sizes, for every rotation Q, beside the case
              that is taken
            d_0: 17.16 u of the sum of its terms' sizes, for every rotation Q, beside the case
              that is taken
            phi: 26.99 u of itself, for every rotation Q, beside the case that is taken; u =
              2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, arctangent within 1
              ulp
derivation  sha256 f4c88cd5f5da36a09188beb0fcfbf3a4571931b3f06ad9a253f46079ff8f69c5
signature   (3,3),(3),(3)->(6),(),()
"""

instant_screw: UfuncInstantScrew
"""text 3.4.1 c The instant screw: Plücker array of its axis, and pitch.
given       omega (3): angular velocity
            a_dot (3): time derivative of: position of the landmark point A
            a (3): position of the landmark point A
returns     axis (6): [e'; n']
            pitch: pitch of the instant screw, in metres per radian
verdict     holds under
assumes     omega != 0
made of     an offered form, proved equal to the statement
operations  45: 7 add, 6 subtract, 18 multiply, 13 divide, 1 square root
error bound axis: 21.51 u of the sum of its terms' sizes, for all inputs
            pitch: 14.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single
              precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 08f61d1364f32cd980675c2c982387b0404b3c2069f72429195ad15600cd8055
signature   (3),(3),(3)->(6),()
"""

natural_velocity_matrix: UfuncNaturalVelocityMatrix
"""(3.77b) The matrix that gives the angular velocity from the natural invariants' rates.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
returns     N_tilde (3, 4): angular velocity from the natural invariants' rates
verdict     ill-formed as printed, defined as read
assumes     |e| = 1
operations  6: 1 subtract, 3 multiply, 1 sine, 1 cosine
error bound 2.3 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
              precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 8f59c5ef77909eadf927c6b687cd3bab0b77e8cdc9373e233171e72268eed1b1
signature   (3),()->(3,4)
"""

linear_velocity_matrix: UfuncLinearVelocityMatrix
"""(3.77c) The matrix that gives the angular velocity from the linear invariants' rates.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
returns     L_tilde (3, 4): angular velocity from the linear invariants' rates
verdict     ill-formed as printed, defined as read
assumes     |e| = 1
            phi != pi
operations  7: 4 multiply, 1 divide, 1 sine, 1 cosine
error bound 5.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 89a180463935f0c42617efa0988e0354bd46d74d20a13999139be0c69246d5f3
signature   (3),()->(3,4)
"""

euler_rodrigues_velocity_matrix: UfuncEulerRodriguesVelocityMatrix
"""(3.77d) The matrix that gives the angular velocity from the Euler-Rodrigues parameters' rates.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
returns     H_tilde (3, 4): angular velocity from the Euler-Rodrigues parameters' rates
verdict     ill-formed as printed, defined as read
assumes     |e| = 1
operations  8: 6 multiply, 1 sine, 1 cosine
error bound 2.61 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 2f21b7ee20e1702180f136497178c100314ca7d0df136dd2feb59d1f89a6b375
signature   (3),()->(3,4)
"""

pose_rate_natural: UfuncPoseRateNatural
"""(3.78) The rate of the pose from the twist, with the natural invariants.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            t (6): twist: angular velocity, velocity of a landmark point
returns     s_dot (7): time derivative of: pose array
verdict     holds under
assumes     |e| = 1
            phi != 0
operations  34: 5 add, 6 subtract, 20 multiply, 1 divide, 1 sine, 1 cosine
error bound 11.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 e2dfaa3aa3fac1f79b45222f3204af5a75f395308f6b3f9290346729c641eaf1
signature   (3),(),(6)->(7)
"""

pose_rate_linear: UfuncPoseRateLinear
"""(3.78) The rate of the pose from the twist, with the linear invariants.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            t (6): twist: angular velocity, velocity of a landmark point
returns     s_dot (7): time derivative of: pose array
verdict     holds under
assumes     |e| = 1
operations  44: 5 add, 10 subtract, 27 multiply, 1 sine, 1 cosine
error bound 9.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 30ffb709cd3b1987574a6cb20949774164c18855b55a74fc172537bd3a7138a3
signature   (3),(),(6)->(7)
"""

pose_rate_euler_rodrigues: UfuncPoseRateEulerRodrigues
"""(3.78) The rate of the pose from the twist, with the Euler-Rodrigues parameters.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            t (6): twist: angular velocity, velocity of a landmark point
returns     s_dot (7): time derivative of: pose array
verdict     holds under
assumes     |e| = 1
operations  28: 5 add, 3 subtract, 18 multiply, 1 sine, 1 cosine
error bound 5.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 17b8436529f6b3c4a1aefcc8236971431106d820c1c98937a7defcd8b9830b55
signature   (3),(),(6)->(7)
"""

twist_from_pose_rate_natural: UfuncTwistFromPoseRateNatural
"""(3.80a) The twist from the rate of the pose, with the natural invariants.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            s_dot (7): time derivative of: pose array
returns     t (6): twist: angular velocity, velocity of a landmark point
verdict     holds under
assumes     |e| = 1
operations  27: 6 add, 4 subtract, 15 multiply, 1 sine, 1 cosine
error bound 7.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 c1c920878c5f917138095dea1943d4f0605d07dd2521a120e9e0a574400414d0
signature   (3),(),(7)->(6)
"""

twist_from_pose_rate_linear: UfuncTwistFromPoseRateLinear
"""(3.80a) The twist from the rate of the pose, with the linear invariants.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            s_dot (7): time derivative of: pose array
returns     t (6): twist: angular velocity, velocity of a landmark point
verdict     holds under
assumes     |e| = 1
            phi != pi
operations  25: 3 add, 6 subtract, 13 multiply, 1 divide, 1 sine, 1 cosine
error bound 9.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 649387c3a4635aed7b72ec7a0c9cd67fa1407b285288b83838890827853ca799
signature   (3),(),(7)->(6)
"""

twist_from_pose_rate_euler_rodrigues: UfuncTwistFromPoseRateEulerRodrigues
"""(3.80a) The twist from the rate of the pose, with the Euler-Rodrigues parameters.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            s_dot (7): time derivative of: pose array
returns     t (6): twist: angular velocity, velocity of a landmark point
verdict     holds under
assumes     |e| = 1
operations  29: 3 add, 6 subtract, 18 multiply, 1 sine, 1 cosine
error bound 6.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 f7009c929bd74e6e8423e03290dcaa8570b236828a6884c7d6bd52463508ac87
signature   (3),(),(7)->(6)
"""

twist_transfer: UfuncTwistTransfer
"""(3.83a) The twist-transfer formula.
given       t_A (6): twist at A
            a (3): position of the landmark point A
            p (3): position of any point P
returns     t_P (6): twist at P
verdict     holds
assumes     nothing
operations  15: 3 add, 6 subtract, 6 multiply
error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 4e8860fe94d4e257f6a09561ef25e7c999ddca2a00337fe8774fc0c2b9433a22
signature   (6),(3),(3)->(6)
"""

angular_acceleration_matrix: UfuncAngularAccelerationMatrix
"""(3.86) The angular-acceleration matrix.
given       omega (3): angular velocity
            omega_dot (3): time derivative of: angular velocity
returns     W (3, 3): angular-acceleration matrix
verdict     defined
assumes     Q is a rotation
operations  15: 6 add, 3 subtract, 6 multiply
error bound 2.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 600ac9c19e353f65970adc87c2c9e1aba7f40174fd2c1780126b444caebb2a29
signature   (3),(3)->(3,3)
"""

acceleration_of_point: UfuncAccelerationOfPoint
"""(3.89) The acceleration of a point from that of the landmark, with vector products.
given       omega (3): angular velocity
            omega_dot (3): time derivative of: angular velocity
            a_ddot (3): second time derivative of: position of the landmark point A
            a (3): position of the landmark point A
            p (3): position of any point P
returns     p_ddot (3): second time derivative of: position of any point P
verdict     holds
assumes     nothing
operations  36: 6 add, 12 subtract, 18 multiply
error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 52077d75d24e72b9e016304332b02aeb13ece6765a6f5dff5b9cb8261bc6ae26
signature   (3),(3),(3),(3),(3)->(3)
"""

natural_rate_matrix_dot: UfuncNaturalRateMatrixDot
"""text 3.5 f The rate of N by axis, angle and angular velocity: (3.96a).
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            omega (3): angular velocity
returns     N_dot (4, 3): time derivative of: natural invariants' rates from the angular velocity
verdict     holds under
assumes     |e| = 1
            phi != 0
made of     an offered form, proved equal to the statement
operations  70: 15 add, 12 subtract, 40 multiply, 1 divide, 1 sine, 1 cosine
error bound 20.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 956e7fbe93e1ea999fe3f7edebc581c8b10e077f4393b085160cc0c68988d2d5
signature   (3),(),(3)->(4,3)
"""

linear_rate_matrix_dot: UfuncLinearRateMatrixDot
"""text 3.5 f The rate of L by axis, angle and angular velocity: (3.96b).
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            omega (3): angular velocity
returns     L_dot (4, 3): time derivative of: linear invariants' rates from the angular velocity
verdict     holds under
assumes     |e| = 1
made of     an offered form, proved equal to the statement
operations  73: 12 add, 16 subtract, 43 multiply, 1 sine, 1 cosine
error bound 10.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 e58c3cd056fca600a3d8fabc77cc08383708b30fcd3f10997c5760ad3d813719
signature   (3),(),(3)->(4,3)
"""

euler_rodrigues_rate_matrix_dot: UfuncEulerRodriguesRateMatrixDot
"""text 3.5 f The rate of H by axis, angle and angular velocity: (3.96c).
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            omega (3): angular velocity
returns     H_dot (4, 3): time derivative of: Euler-Rodrigues parameters' rates from the angular
              velocity
verdict     holds under
assumes     |e| = 1
made of     an offered form, proved equal to the statement
operations  28: 2 add, 6 subtract, 18 multiply, 1 sine, 1 cosine
error bound 5.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 cbbc7c4a0ec6ff7289faa80a566dfa4879a785dc3e1fcb665d781015958b3b92
signature   (3),(),(3)->(4,3)
"""

natural_velocity_matrix_dot: UfuncNaturalVelocityMatrixDot
"""text 3.5 g The rate of the left inverse of N by axis, angle and angular velocity: (3.97a).
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            omega (3): angular velocity
returns     N_tilde_dot (3, 4): time derivative of: angular velocity from the natural invariants'
              rates
verdict     holds under
assumes     phi != 0
            |e| = 1
operations  55: 8 add, 10 subtract, 34 multiply, 1 divide, 1 sine, 1 cosine
error bound 11.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 71e01d77b3ea46f745a9336a2825937c48ecfb5c8f22e156a02b1d41218c2c74
signature   (3),(),(3)->(3,4)
"""

linear_velocity_matrix_dot: UfuncLinearVelocityMatrixDot
"""text 3.5 g The rate of the left inverse of L by axis, angle and angular velocity: (3.97b).
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            omega (3): angular velocity
returns     L_tilde_dot (3, 4): time derivative of: angular velocity from the linear invariants'
              rates
verdict     holds under
assumes     |e| = 1
            phi != pi
operations  34: 5 add, 6 subtract, 20 multiply, 1 divide, 1 sine, 1 cosine
error bound 16.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 b5286c2c91a7b4cfdc8d341b90ed08a2a37fc92a9f25530860458e82f6eaacf3
signature   (3),(),(3)->(3,4)
"""

euler_rodrigues_velocity_matrix_dot: UfuncEulerRodriguesVelocityMatrixDot
"""text 3.5 g The rate of the left inverse of H by axis, angle and angular velocity: (3.97c).
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            omega (3): angular velocity
returns     H_tilde_dot (3, 4): time derivative of: angular velocity from the Euler-Rodrigues
              parameters' rates
verdict     holds under
assumes     |e| = 1
operations  26: 2 add, 6 subtract, 16 multiply, 1 sine, 1 cosine
error bound 5.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 c80e798e741899e2d32fd6b3e16a5b786d0f82ee47987a537c4755eed1b60850
signature   (3),(),(3)->(3,4)
"""

pose_acceleration_natural: UfuncPoseAccelerationNatural
"""text 3.5 h The second rate of the pose from the twist and its rate, with the natural invariants.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            t (6): twist: angular velocity, velocity of a landmark point
            t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point
returns     s_ddot (7): second time derivative of: pose array
verdict     holds under
assumes     |e| = 1
            phi != 0
made of     an offered form, proved equal to the statement
operations  96: 19 add, 19 subtract, 55 multiply, 1 divide, 1 sine, 1 cosine
error bound 25.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 4063df423497b2a63464c14082ba023d497a45f17209d99f956cc810ce8006b6
signature   (3),(),(6),(6)->(7)
"""

pose_acceleration_linear: UfuncPoseAccelerationLinear
"""text 3.5 h The second rate of the pose from the twist and its rate, with the linear invariants.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            t (6): twist: angular velocity, velocity of a landmark point
            t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point
returns     s_ddot (7): second time derivative of: pose array
verdict     holds under
assumes     |e| = 1
made of     an offered form, proved equal to the statement
operations  76: 11 add, 18 subtract, 45 multiply, 1 sine, 1 cosine
error bound 12.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 1588dcded7d741e99e263e63960b704faab031996a2d165fbbe2b322357ed2e9
signature   (3),(),(6),(6)->(7)
"""

pose_acceleration_euler_rodrigues: UfuncPoseAccelerationEulerRodrigues
"""text 3.5 h The second rate of the pose from the twist and its rate, with the Euler-Rodrigues
parameters.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            t (6): twist: angular velocity, velocity of a landmark point
            t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point
returns     s_ddot (7): second time derivative of: pose array
verdict     holds under
assumes     |e| = 1
made of     an offered form, proved equal to the statement
operations  45: 5 add, 9 subtract, 29 multiply, 1 sine, 1 cosine
error bound 7.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 0f21a42c6c8b20a3978874f3add6fcde6371416fd40cc41c5da50d8f4cd6babd
signature   (3),(),(6),(6)->(7)
"""

twist_rate_from_pose_natural: UfuncTwistRateFromPoseNatural
"""text 3.5 i The rate of the twist from the rates of the pose, with the natural invariants.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            s_dot (7): time derivative of: pose array
            s_ddot (7): second time derivative of: pose array
returns     t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point
verdict     holds under
assumes     |e| = 1
made of     an offered form, proved equal to the statement
operations  51: 13 add, 7 subtract, 29 multiply, 1 sine, 1 cosine
error bound 8.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 46142537f8f2d352235601f0fe20d7417a8415c4299de5fde88c9772c1d5b072
signature   (3),(),(7),(7)->(6)
"""

twist_rate_from_pose_linear: UfuncTwistRateFromPoseLinear
"""text 3.5 i The rate of the twist from the rates of the pose, with the linear invariants.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            s_dot (7): time derivative of: pose array
            s_ddot (7): second time derivative of: pose array
returns     t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point
verdict     holds under
assumes     |e| = 1
            phi != pi
made of     an offered form, proved equal to the statement
operations  52: 6 add, 15 subtract, 27 multiply, 2 divide, 1 sine, 1 cosine
error bound 16.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 e60a5e59bbc9bfff80fda29a99e2165c18777756e0d5ef482d146ef9b36646a2
signature   (3),(),(7),(7)->(6)
"""

twist_rate_from_pose_euler_rodrigues: UfuncTwistRateFromPoseEulerRodrigues
"""text 3.5 i The rate of the twist from the rates of the pose, with the Euler-Rodrigues parameters.
given       e (3): unit vector along the axis of rotation, or along a line
            phi: angle of rotation
            s_dot (7): time derivative of: pose array
            s_ddot (7): second time derivative of: pose array
returns     t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point
verdict     holds under
assumes     |e| = 1
made of     an offered form, proved equal to the statement
operations  29: 3 add, 6 subtract, 18 multiply, 1 sine, 1 cosine
error bound 6.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 8f9dc9af1023fade3eb622411945883078b1f62098c7b9178f68aed0ef63d94d
signature   (3),(),(7),(7)->(6)
"""

moving_frame_velocity: UfuncMovingFrameVelocity
"""(3.103) The velocity of P in the fixed frame from that in the moving frame.
given       o_dot (3): time derivative of: position of the origin of the moving frame
            Q (3, 3): rotation
            omega (3): angular velocity
            rho (3): position of P in the moving frame
            rho_dot (3): time derivative of: position of P in the moving frame
returns     p_dot (3): time derivative of: position of any point P
verdict     holds
assumes     nothing
expects     Q is a rotation
operations  45: 18 add, 3 subtract, 24 multiply
error bound 7.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 b4941bd3b3f57c83b14de8fd13a10f996bcfeb8ee7bfc4215c85ab50fb9b8b33
signature   (3),(3,3),(3),(3),(3)->(3)
"""

moving_frame_acceleration: UfuncMovingFrameAcceleration
"""(3.105) The acceleration of P in the fixed frame: as a point of the moving frame, Coriolis, and in
the moving frame.
given       o_ddot (3): second time derivative of: position of the origin of the moving frame
            Q (3, 3): rotation
            omega (3): angular velocity
            omega_dot (3): time derivative of: angular velocity
            rho (3): position of P in the moving frame
            rho_dot (3): time derivative of: position of P in the moving frame
            rho_ddot (3): second time derivative of: position of P in the moving frame
returns     p_ddot (3): second time derivative of: position of any point P
verdict     holds
assumes     nothing
expects     Q is a rotation
made of     an offered form, proved equal to the statement
operations  87: 30 add, 9 subtract, 48 multiply
error bound 10.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 985f244a1c015e00a6d544a9a346e7446722d3d1972e549159bc1a6a90456d40
signature   (3),(3,3),(3),(3),(3),(3),(3)->(3)
"""

wrench_axis: UfuncWrenchAxis
"""text 3.7 d The axis and the pitch of the wrench.
given       f (3): resultant force
            n_A (3): resultant moment about A
            a (3): position of the landmark point A
returns     axis (6): [e''; n'']
            pitch: pitch of the wrench, in metres per radian
verdict     holds under
assumes     f != 0
made of     an offered form, proved equal to the statement
operations  45: 7 add, 6 subtract, 18 multiply, 13 divide, 1 square root
error bound axis: 21.51 u of the sum of its terms' sizes, for all inputs
            pitch: 14.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single
              precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 c78cfc23a3b398d6195b8dc68c79e9bdceefc46df0b8a9442885e124035211ef
signature   (3),(3),(3)->(6),()
"""

power: UfuncPower
"""(3.114) The power developed by a wrench on a body that moves with a twist at the same point.
given       t (6): twist: angular velocity, velocity of a landmark point
            w (6): wrench: moment, force
returns     Pi: power developed by a wrench on a moving body
verdict     holds
assumes     nothing
operations  11: 5 add, 6 multiply
error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 580a9557b1b4b779955409e7506c76202ce3a1e9982d422e1491bf0bcad680ef
signature   (6),(6)->()
"""

reciprocal_product: UfuncReciprocalProduct
"""text 3.7 k The reciprocal product of two screws, in either order.
given       s_w (6): screw of a wrench
            s_t (6): screw of a twist
returns     product: s_t^T Gamma s_w
verdict     holds
assumes     nothing
operations  11: 5 add, 6 multiply
error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 69eafb582289fe007146884f233005913bd49126222273503197968fd6ef8dd3
signature   (6),(6)->()
"""

wrench_transfer: UfuncWrenchTransfer
"""(3.119a) The wrench-transfer formula.
given       w_A (6): wrench at A
            a (3): position of the landmark point A
            p (3): position of any point P
returns     w_P (6): wrench at P
verdict     holds
assumes     nothing
operations  15: 3 add, 6 subtract, 6 multiply
error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 9cbbd4d64a694c0150c2c0a241ceaa9fe43fa91e335dce95c4c39681e8ecce3c
signature   (6),(3),(3)->(6)
"""

inertia_about_point: UfuncInertiaAboutPoint
"""(3.133a) Steiner's theorem: the moment of inertia with respect to A from that at the center of mass.
given       I_C (3, 3): moment of inertia at the center of mass
            m: mass
            c (3): position of the center of mass
            a (3): position of the landmark point A
returns     I_A (3, 3): moment of inertia with respect to A
verdict     holds under
assumes     m > 0
expects     I_C is symmetric
operations  24: 6 add, 9 subtract, 9 multiply
error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 4d7619030bc619e84b4607eaec8efd339cf9160ce49e3d74dfaae1e4b7730c87
signature   (3,3),(),(3),(3)->(3,3)
"""

inertia_about_point_sym6: UfuncInertiaAboutPointSym6
"""(3.133a) Steiner's theorem: the moment of inertia with respect to A from that at the center of mass.
given       I_C (6): moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,
              zz)
            m: mass
            c (3): position of the center of mass
            a (3): position of the landmark point A
returns     I_A (6): moment of inertia with respect to A, symmetric, as (xx, xy, xz, yy, yz, zz)
verdict     holds under
assumes     m > 0
expects     I_C is symmetric
operations  21: 6 add, 6 subtract, 9 multiply
error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 4d7619030bc619e84b4607eaec8efd339cf9160ce49e3d74dfaae1e4b7730c87
signature   (6),(),(3),(3)->(6)
"""

momentum_screw: UfuncMomentumScrew
"""(3.142) The momentum screw by inertia dyad and twist.
given       I_C (3, 3): moment of inertia at the center of mass
            m: mass
            t (6): twist: angular velocity, velocity of a landmark point
returns     mu (6): [I_C omega; m c_dot]
verdict     holds
assumes     nothing
expects     I_C is symmetric
            m > 0
operations  18: 6 add, 12 multiply
error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 6db3e3a77ef9af159d0c096ec679c53626cff81d41ccfbcc2a4db4833ae93473
signature   (3,3),(),(6)->(6)
"""

momentum_screw_sym6: UfuncMomentumScrewSym6
"""(3.142) The momentum screw by inertia dyad and twist.
given       I_C (6): moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,
              zz)
            m: mass
            t (6): twist: angular velocity, velocity of a landmark point
returns     mu (6): [I_C omega; m c_dot]
verdict     holds
assumes     nothing
expects     I_C is symmetric
            m > 0
operations  18: 6 add, 12 multiply
error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 6db3e3a77ef9af159d0c096ec679c53626cff81d41ccfbcc2a4db4833ae93473
signature   (6),(),(6)->(6)
"""

kinetic_energy: UfuncKineticEnergy
"""(3.145) The kinetic energy as a quadratic form of the twist.
given       I_C (3, 3): moment of inertia at the center of mass
            m: mass
            t (6): twist: angular velocity, velocity of a landmark point
returns     T: kinetic energy
verdict     holds
assumes     nothing
expects     I_C is symmetric
            m > 0
operations  35: 11 add, 24 multiply
error bound 9.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 69297c38ebd3f2599e0000c019f576151ae0e8d563b8a02661f982c45230000e
signature   (3,3),(),(6)->()
"""

kinetic_energy_sym6: UfuncKineticEnergySym6
"""(3.145) The kinetic energy as a quadratic form of the twist.
given       I_C (6): moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,
              zz)
            m: mass
            t (6): twist: angular velocity, velocity of a landmark point
returns     T: kinetic energy
verdict     holds
assumes     nothing
expects     I_C is symmetric
            m > 0
operations  35: 11 add, 24 multiply
error bound 9.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 69297c38ebd3f2599e0000c019f576151ae0e8d563b8a02661f982c45230000e
signature   (6),(),(6)->()
"""

newton_euler_wrench: UfuncNewtonEulerWrench
"""text 3.8 v The wrench that moves the body: the Newton-Euler equations as they stand.
given       I_C (3, 3): moment of inertia at the center of mass
            m: mass
            t (6): twist: angular velocity, velocity of a landmark point
            t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point
returns     w (6): wrench: moment, force
verdict     holds
assumes     nothing
expects     I_C is symmetric
            m > 0
operations  45: 15 add, 3 subtract, 27 multiply
error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 4e831789b8f20b1f8ebea121e0d8d47b7074e8225c3fd379d0994cdf87959c79
signature   (3,3),(),(6),(6)->(6)
"""

newton_euler_wrench_sym6: UfuncNewtonEulerWrenchSym6
"""text 3.8 v The wrench that moves the body: the Newton-Euler equations as they stand.
given       I_C (6): moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,
              zz)
            m: mass
            t (6): twist: angular velocity, velocity of a landmark point
            t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point
returns     w (6): wrench: moment, force
verdict     holds
assumes     nothing
expects     I_C is symmetric
            m > 0
operations  45: 15 add, 3 subtract, 27 multiply
error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 4e831789b8f20b1f8ebea121e0d8d47b7074e8225c3fd379d0994cdf87959c79
signature   (6),(),(6),(6)->(6)
"""

newton_euler_twist_rate: UfuncNewtonEulerTwistRate
"""text 3.8 v The rate of the twist of a body on which a wrench acts: the Newton-Euler equations
solved.
given       I_C (3, 3): moment of inertia at the center of mass
            m: mass
            t (6): twist: angular velocity, velocity of a landmark point
            w (6): wrench: moment, force
returns     t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point
verdict     holds under
assumes     det(I_C) != 0
            m > 0
expects     I_C is positive-definite
operations  108: 16 add, 18 subtract, 60 multiply, 14 divide
error bound 24.09 u of the sum of its terms' sizes, times the condition of its divisor, for all
              inputs of which that is at most 4096; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 583b7af3455d4e7d41db43315abbed568d7671c8edafcef5b697d79c93e17ecb
signature   (3,3),(),(6),(6)->(6)
"""

newton_euler_twist_rate_sym6: UfuncNewtonEulerTwistRateSym6
"""text 3.8 v The rate of the twist of a body on which a wrench acts: the Newton-Euler equations
solved.
given       I_C (6): moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,
              zz)
            m: mass
            t (6): twist: angular velocity, velocity of a landmark point
            w (6): wrench: moment, force
returns     t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point
verdict     holds under
assumes     det(I_C) != 0
            m > 0
expects     I_C is positive-definite
operations  96: 16 add, 15 subtract, 54 multiply, 11 divide
error bound 24.09 u of the sum of its terms' sizes, times the condition of its divisor, for all
              inputs of which that is at most 4096; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 583b7af3455d4e7d41db43315abbed568d7671c8edafcef5b697d79c93e17ecb
signature   (6),(),(6),(6)->(6)
"""

inertia_dyad: UfuncInertiaDyad
"""(3.147) The inertia dyad at A.
given       I_C (3, 3): moment of inertia at the center of mass
            m: mass
            c (3): position of the center of mass
            a (3): position of the landmark point A
returns     M_A (6, 6): inertia dyad at A
verdict     holds
assumes     nothing
expects     I_C is symmetric
            m > 0
operations  24: 6 add, 9 subtract, 9 multiply
error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 13cba9d3a00039b66aa71e0b7c6844416aef2b889cadec353dae6a76e70a10a9
signature   (3,3),(),(3),(3)->(6,6)
"""

inertia_dyad_sym6: UfuncInertiaDyadSym6
"""(3.147) The inertia dyad at A.
given       I_C (6): moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,
              zz)
            m: mass
            c (3): position of the center of mass
            a (3): position of the landmark point A
returns     M_A (6, 6): inertia dyad at A
verdict     holds
assumes     nothing
expects     I_C is symmetric
            m > 0
operations  21: 6 add, 6 subtract, 9 multiply
error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA
derivation  sha256 13cba9d3a00039b66aa71e0b7c6844416aef2b889cadec353dae6a76e70a10a9
signature   (6),(),(3),(3)->(6,6)
"""

rotation_from_euler_xyx: UfuncRotationFromEulerXyx
"""Ex 3.10 The rotation by Euler angles about x, y, x.
given       angles (3): Euler angles, in the order of the turns
returns     Q (3, 3): rotation
verdict     defined
assumes     nothing
operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 49974e148b9969b7a23a303df375f906766eda03e5d7416d35c36a35c77fea06
signature   (3)->(3,3)
"""

euler_rate_matrix_xyx: UfuncEulerRateMatrixXyx
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, y, x.
given       angles (3): Euler angles, in the order of the turns
returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 15ec222e6a4c0d4af15dcf0f4f9d944364836080f80ed845b4661afb074e1ca1
signature   (3)->(3,3)
"""

euler_rate_matrix_body_xyx: UfuncEulerRateMatrixBodyXyx
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, y, x.
given       angles (3): Euler angles, in the order of the turns
returns     W_body (3, 3): angular velocity in the body frame from those rates
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 cd8589089d7d47765a04b183158736b0b971b8a8d922838283fa2c2975eb5d89
signature   (3)->(3,3)
"""

euler_rates_xyx: UfuncEulerRatesXyx
"""Ex 3.10 The rates of Euler angles about x, y, x from the angular velocity in the fixed frame.
given       angles (3): Euler angles, in the order of the turns
            omega (3): angular velocity
returns     theta_dot (3): rates of the Euler angles
verdict     holds under
assumes     sin(theta_2) != 0
operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 6b432c618a3b5cb7132a0a1625419f24b2800b22e52d8f8b5202e756b67ea148
signature   (3),(3)->(3)
"""

rotation_from_euler_xyz: UfuncRotationFromEulerXyz
"""Ex 3.10 The rotation by Euler angles about x, y, z.
given       angles (3): Euler angles, in the order of the turns
returns     Q (3, 3): rotation
verdict     defined
assumes     nothing
operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 f87af8285d9801669ca9041e726f9817a40f9c95ddf51a655b261236297c04af
signature   (3)->(3,3)
"""

euler_rate_matrix_xyz: UfuncEulerRateMatrixXyz
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, y, z.
given       angles (3): Euler angles, in the order of the turns
returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 1d2f362d906c9640bebb7713dd74f3809ce202cd977dff0cc4c827b77ce9d4d3
signature   (3)->(3,3)
"""

euler_rate_matrix_body_xyz: UfuncEulerRateMatrixBodyXyz
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, y, z.
given       angles (3): Euler angles, in the order of the turns
returns     W_body (3, 3): angular velocity in the body frame from those rates
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 d605f1f844caa8fe73209313f2debbc7dad841db4b625533c1925d350b88b35f
signature   (3)->(3,3)
"""

euler_rates_xyz: UfuncEulerRatesXyz
"""Ex 3.10 The rates of Euler angles about x, y, z from the angular velocity in the fixed frame.
given       angles (3): Euler angles, in the order of the turns
            omega (3): angular velocity
returns     theta_dot (3): rates of the Euler angles
verdict     holds under
assumes     cos(theta_2) != 0
operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 379cc15712b3f593e6a56a0586d8cb970b2c344caf9eff56d13b4aa0f2bc0fcb
signature   (3),(3)->(3)
"""

rotation_from_euler_xzx: UfuncRotationFromEulerXzx
"""Ex 3.10 The rotation by Euler angles about x, z, x.
given       angles (3): Euler angles, in the order of the turns
returns     Q (3, 3): rotation
verdict     defined
assumes     nothing
operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 509556f6df445dd3c7fe5324e0ad671112ed8aaa27442b8973ddf4f722eb8d9b
signature   (3)->(3,3)
"""

euler_rate_matrix_xzx: UfuncEulerRateMatrixXzx
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, z, x.
given       angles (3): Euler angles, in the order of the turns
returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 063a79927c0f405045ca7f3a4600867811265ae8101b11b64e443152cd0965cf
signature   (3)->(3,3)
"""

euler_rate_matrix_body_xzx: UfuncEulerRateMatrixBodyXzx
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, z, x.
given       angles (3): Euler angles, in the order of the turns
returns     W_body (3, 3): angular velocity in the body frame from those rates
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 5092f84c7bbb66afac08e51bc82a4ea4bdc4738a19463c52fc60c25d1976c154
signature   (3)->(3,3)
"""

euler_rates_xzx: UfuncEulerRatesXzx
"""Ex 3.10 The rates of Euler angles about x, z, x from the angular velocity in the fixed frame.
given       angles (3): Euler angles, in the order of the turns
            omega (3): angular velocity
returns     theta_dot (3): rates of the Euler angles
verdict     holds under
assumes     sin(theta_2) != 0
operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 d60392e777e2f94766ccb4868d6a376f4b8f702f6466c7841c3f0e7493778009
signature   (3),(3)->(3)
"""

rotation_from_euler_xzy: UfuncRotationFromEulerXzy
"""Ex 3.10 The rotation by Euler angles about x, z, y.
given       angles (3): Euler angles, in the order of the turns
returns     Q (3, 3): rotation
verdict     defined
assumes     nothing
operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
error bound 5.3 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 6a4fd734359cc43f74679d358abf691bfd6612dbcd721aa9a209c64050a5d383
signature   (3)->(3,3)
"""

euler_rate_matrix_xzy: UfuncEulerRateMatrixXzy
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, z, y.
given       angles (3): Euler angles, in the order of the turns
returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 f4bf5edc3a0e9199cc30c83f6cab51d6bfce7ab2a3d75f59608b337bed74824b
signature   (3)->(3,3)
"""

euler_rate_matrix_body_xzy: UfuncEulerRateMatrixBodyXzy
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, z, y.
given       angles (3): Euler angles, in the order of the turns
returns     W_body (3, 3): angular velocity in the body frame from those rates
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 34b232afb99ddc1be46962d797e1c08bda20904a656a165ee2fc2232e4beec57
signature   (3)->(3,3)
"""

euler_rates_xzy: UfuncEulerRatesXzy
"""Ex 3.10 The rates of Euler angles about x, z, y from the angular velocity in the fixed frame.
given       angles (3): Euler angles, in the order of the turns
            omega (3): angular velocity
returns     theta_dot (3): rates of the Euler angles
verdict     holds under
assumes     cos(theta_2) != 0
operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 47b386989c7014707637badfc0f665d8b17c2674e34c6dc85b34228d94dd802e
signature   (3),(3)->(3)
"""

rotation_from_euler_yxy: UfuncRotationFromEulerYxy
"""Ex 3.10 The rotation by Euler angles about y, x, y.
given       angles (3): Euler angles, in the order of the turns
returns     Q (3, 3): rotation
verdict     defined
assumes     nothing
operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 42de6926cd35f5c06da566065b065c8ba754cee65703557fa42410e42dde4a35
signature   (3)->(3,3)
"""

euler_rate_matrix_yxy: UfuncEulerRateMatrixYxy
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, x, y.
given       angles (3): Euler angles, in the order of the turns
returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 ab9e4f4d487ee038942cc83869848be5fa4c534a19c656164684f27e1b65ac10
signature   (3)->(3,3)
"""

euler_rate_matrix_body_yxy: UfuncEulerRateMatrixBodyYxy
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, x, y.
given       angles (3): Euler angles, in the order of the turns
returns     W_body (3, 3): angular velocity in the body frame from those rates
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 2a86c48257dda6a27e84a7fb3b0817bd24bdff1a56c2bfeb6119d778d89bbab6
signature   (3)->(3,3)
"""

euler_rates_yxy: UfuncEulerRatesYxy
"""Ex 3.10 The rates of Euler angles about y, x, y from the angular velocity in the fixed frame.
given       angles (3): Euler angles, in the order of the turns
            omega (3): angular velocity
returns     theta_dot (3): rates of the Euler angles
verdict     holds under
assumes     sin(theta_2) != 0
operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 8c7b412f940aadc89ad8c5ce3785c5c0ca8dcbf9e58aac6572334181799e61e2
signature   (3),(3)->(3)
"""

rotation_from_euler_yxz: UfuncRotationFromEulerYxz
"""Ex 3.10 The rotation by Euler angles about y, x, z.
given       angles (3): Euler angles, in the order of the turns
returns     Q (3, 3): rotation
verdict     defined
assumes     nothing
operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
error bound 5.3 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 aac4d38f938bc0f3b21fc5113a3e553f105a0b99bd2a46001cf5af56197be36a
signature   (3)->(3,3)
"""

euler_rate_matrix_yxz: UfuncEulerRateMatrixYxz
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, x, z.
given       angles (3): Euler angles, in the order of the turns
returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 f673622637ac9520cdbbfacd9038ad6a42d7de01d522fe1daa4e4ed5a188d584
signature   (3)->(3,3)
"""

euler_rate_matrix_body_yxz: UfuncEulerRateMatrixBodyYxz
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, x, z.
given       angles (3): Euler angles, in the order of the turns
returns     W_body (3, 3): angular velocity in the body frame from those rates
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 a7f0e1639e85f122dde538fce97f31e9e4f583cf9ea5d074345d45245ff26ea8
signature   (3)->(3,3)
"""

euler_rates_yxz: UfuncEulerRatesYxz
"""Ex 3.10 The rates of Euler angles about y, x, z from the angular velocity in the fixed frame.
given       angles (3): Euler angles, in the order of the turns
            omega (3): angular velocity
returns     theta_dot (3): rates of the Euler angles
verdict     holds under
assumes     cos(theta_2) != 0
operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 bf11bed82696038fa225e27a75acb0d41b63af31adb0153ca5a712167c4d8284
signature   (3),(3)->(3)
"""

rotation_from_euler_yzx: UfuncRotationFromEulerYzx
"""Ex 3.10 The rotation by Euler angles about y, z, x.
given       angles (3): Euler angles, in the order of the turns
returns     Q (3, 3): rotation
verdict     defined
assumes     nothing
operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 73ccad1507926c77a4de1804d6ccee68b6eedcb0a87a5d797076c3aaa328556a
signature   (3)->(3,3)
"""

euler_rate_matrix_yzx: UfuncEulerRateMatrixYzx
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, z, x.
given       angles (3): Euler angles, in the order of the turns
returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 6bc14177fe8f581b737fd8108f75cca27c80f0c6043e24f8d305941c720fb93e
signature   (3)->(3,3)
"""

euler_rate_matrix_body_yzx: UfuncEulerRateMatrixBodyYzx
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, z, x.
given       angles (3): Euler angles, in the order of the turns
returns     W_body (3, 3): angular velocity in the body frame from those rates
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 ba974c498d2395f78752b5b9af3bd25c9bc8814b82f34bc12080e7f58fc39384
signature   (3)->(3,3)
"""

euler_rates_yzx: UfuncEulerRatesYzx
"""Ex 3.10 The rates of Euler angles about y, z, x from the angular velocity in the fixed frame.
given       angles (3): Euler angles, in the order of the turns
            omega (3): angular velocity
returns     theta_dot (3): rates of the Euler angles
verdict     holds under
assumes     cos(theta_2) != 0
operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 404a3dd7a9f43dbf16ca707d83946fda23f95d1982dc848908ed679160d5cc5f
signature   (3),(3)->(3)
"""

rotation_from_euler_yzy: UfuncRotationFromEulerYzy
"""Ex 3.10 The rotation by Euler angles about y, z, y.
given       angles (3): Euler angles, in the order of the turns
returns     Q (3, 3): rotation
verdict     defined
assumes     nothing
operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 fc249fbe7ecf26a2cf23c7eb4a1ae340b6f6d6b71fd0a11c005275bed3b0541a
signature   (3)->(3,3)
"""

euler_rate_matrix_yzy: UfuncEulerRateMatrixYzy
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, z, y.
given       angles (3): Euler angles, in the order of the turns
returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 ba3b9e2e5d19a42bcccf4fe889ac0ad5e1476885d7d3f35174490738c07caa93
signature   (3)->(3,3)
"""

euler_rate_matrix_body_yzy: UfuncEulerRateMatrixBodyYzy
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, z, y.
given       angles (3): Euler angles, in the order of the turns
returns     W_body (3, 3): angular velocity in the body frame from those rates
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 2906ed860e470e86a10fba075e603a757d21feeb996fd012d6a5c352f1f248cf
signature   (3)->(3,3)
"""

euler_rates_yzy: UfuncEulerRatesYzy
"""Ex 3.10 The rates of Euler angles about y, z, y from the angular velocity in the fixed frame.
given       angles (3): Euler angles, in the order of the turns
            omega (3): angular velocity
returns     theta_dot (3): rates of the Euler angles
verdict     holds under
assumes     sin(theta_2) != 0
operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 fbcf58ed5fb921bfdeae731af0d22be0b18c057d4ab3433941bb486f4f2ac07a
signature   (3),(3)->(3)
"""

rotation_from_euler_zxy: UfuncRotationFromEulerZxy
"""Ex 3.10 The rotation by Euler angles about z, x, y.
given       angles (3): Euler angles, in the order of the turns
returns     Q (3, 3): rotation
verdict     defined
assumes     nothing
operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 00df5b3e078a442b89ec92320b9be4d00f69c8c69b5377ceed30ce97167894d8
signature   (3)->(3,3)
"""

euler_rate_matrix_zxy: UfuncEulerRateMatrixZxy
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, x, y.
given       angles (3): Euler angles, in the order of the turns
returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 66b9e91ee2080f4af362adbd4cfbd2f6493f2d49f04e969606b8e5e66a892530
signature   (3)->(3,3)
"""

euler_rate_matrix_body_zxy: UfuncEulerRateMatrixBodyZxy
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, x, y.
given       angles (3): Euler angles, in the order of the turns
returns     W_body (3, 3): angular velocity in the body frame from those rates
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 ee0e5dc36786ec147d7731e28a73445f4829a353e033fb0bdf99f16a9ae96d67
signature   (3)->(3,3)
"""

euler_rates_zxy: UfuncEulerRatesZxy
"""Ex 3.10 The rates of Euler angles about z, x, y from the angular velocity in the fixed frame.
given       angles (3): Euler angles, in the order of the turns
            omega (3): angular velocity
returns     theta_dot (3): rates of the Euler angles
verdict     holds under
assumes     cos(theta_2) != 0
operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 f15319cb143e29fdad80688ea5d83794cf5328509c5cd1fb52fa078f77b2a785
signature   (3),(3)->(3)
"""

rotation_from_euler_zxz: UfuncRotationFromEulerZxz
"""Ex 3.10 The rotation by Euler angles about z, x, z.
given       angles (3): Euler angles, in the order of the turns
returns     Q (3, 3): rotation
verdict     defined
assumes     nothing
operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 90292a7b1973bd54561384a1b0aca95f4b081c5031f08a71f5bf1eeb509996f8
signature   (3)->(3,3)
"""

euler_rate_matrix_zxz: UfuncEulerRateMatrixZxz
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, x, z.
given       angles (3): Euler angles, in the order of the turns
returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 d6bac485f18ebb57e7adb1eb90896adee410e33308c5db55212969aa010526ee
signature   (3)->(3,3)
"""

euler_rate_matrix_body_zxz: UfuncEulerRateMatrixBodyZxz
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, x, z.
given       angles (3): Euler angles, in the order of the turns
returns     W_body (3, 3): angular velocity in the body frame from those rates
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 22c895ea0aa33cf27a73432cf9b7edd645045c890d81351055832ab2e86d2ae0
signature   (3)->(3,3)
"""

euler_rates_zxz: UfuncEulerRatesZxz
"""Ex 3.10 The rates of Euler angles about z, x, z from the angular velocity in the fixed frame.
given       angles (3): Euler angles, in the order of the turns
            omega (3): angular velocity
returns     theta_dot (3): rates of the Euler angles
verdict     holds under
assumes     sin(theta_2) != 0
operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 9730082636217a13ed6443b9376e26c825640305348e897e3b1e8d20d25ad893
signature   (3),(3)->(3)
"""

rotation_from_euler_zyx: UfuncRotationFromEulerZyx
"""Ex 3.10 The rotation by Euler angles about z, y, x.
given       angles (3): Euler angles, in the order of the turns
returns     Q (3, 3): rotation
verdict     defined
assumes     nothing
operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
error bound 5.3 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 77eae5b015783de7dba57287593533e40a4bf6d57321c5d7151d36cf1a028acc
signature   (3)->(3,3)
"""

euler_rate_matrix_zyx: UfuncEulerRateMatrixZyx
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, y, x.
given       angles (3): Euler angles, in the order of the turns
returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 0adf0d7abfcbe1f817931814b81c15a9c846b1c73dcdb818878d86351c757b6d
signature   (3)->(3,3)
"""

euler_rate_matrix_body_zyx: UfuncEulerRateMatrixBodyZyx
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, y, x.
given       angles (3): Euler angles, in the order of the turns
returns     W_body (3, 3): angular velocity in the body frame from those rates
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 6a7529b4dd785268409cc92077030a4cad8a64439e696ba9dfa305974e76a7df
signature   (3)->(3,3)
"""

euler_rates_zyx: UfuncEulerRatesZyx
"""Ex 3.10 The rates of Euler angles about z, y, x from the angular velocity in the fixed frame.
given       angles (3): Euler angles, in the order of the turns
            omega (3): angular velocity
returns     theta_dot (3): rates of the Euler angles
verdict     holds under
assumes     cos(theta_2) != 0
operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 f6fb3a6381c9037e8d1dbd8e1df9c051262d4c72bd9738451555e59c302f0f09
signature   (3),(3)->(3)
"""

rotation_from_euler_zyz: UfuncRotationFromEulerZyz
"""Ex 3.10 The rotation by Euler angles about z, y, z.
given       angles (3): Euler angles, in the order of the turns
returns     Q (3, 3): rotation
verdict     defined
assumes     nothing
operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 35a70c6c05dd2903cd2f50766b4e415a63eb2ffed2c6d3e412124e8647c7b716
signature   (3)->(3,3)
"""

euler_rate_matrix_zyz: UfuncEulerRateMatrixZyz
"""Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, y, z.
given       angles (3): Euler angles, in the order of the turns
returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 2df872f3e6c29262a9a735f3e6450ce704e08a1b40b33a555d7636f417131edb
signature   (3)->(3,3)
"""

euler_rate_matrix_body_zyz: UfuncEulerRateMatrixBodyZyz
"""Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, y, z.
given       angles (3): Euler angles, in the order of the turns
returns     W_body (3, 3): angular velocity in the body frame from those rates
verdict     defined
assumes     nothing
operations  6: 2 multiply, 2 sine, 2 cosine
error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 0e8fa3809441be1ebd1a102ce8fc5b78357d823973bbc7bac7e1da5c7ce38790
signature   (3)->(3,3)
"""

euler_rates_zyz: UfuncEulerRatesZyz
"""Ex 3.10 The rates of Euler angles about z, y, z from the angular velocity in the fixed frame.
given       angles (3): Euler angles, in the order of the turns
            omega (3): angular velocity
returns     theta_dot (3): rates of the Euler angles
verdict     holds under
assumes     sin(theta_2) != 0
operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
              2^-24
            supposed: every operation rounded to nearest, with or without FMA, sine and cosine
              within 0.8 ulp
derivation  sha256 c8e47ebca1883ce144424c202eb73e0d953be9339e55743f954ebc4ff9aaa9f5
signature   (3),(3)->(3)
"""
