# SPDX-License-Identifier: BSD-3-Clause
# Emitted by chasles 0.2.0.
"""Kernels for NumPy and every other library of the array API. Made by `chasles emit`; not to be edited.

Core axes come last, batch axes before them broadcast; lists are taken as NumPy arrays. Single precision stays single.
`out` takes an array, or a tuple with one for each result (None for a new one), and may share storage with inputs.
What a function assumes of its inputs is not tested. Each raises ValueError for a core shape that does not fit and
TypeError for what is not a real number.
"""

from __future__ import annotations

from typing import Any

from .batches import delivered, prepared

__all__ = (
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
)


def cross_product_matrix(v: Any, /, *, out: Any = None) -> Any:
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
    batch, v = prepared("cross_product_matrix", ("v", v, (3,)))
    V = batch.array((3, 3), 0.0, -v[2], v[1], v[2], 0.0, -v[0], -v[1], v[0], 0.0)
    return delivered(out, V)


def rotation_from_axis_angle(e: Any, phi: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi = prepared("rotation_from_axis_angle", ("e", e, (3,)), ("phi", phi, ()))
    xp = batch.xp
    cos_phi = xp.cos(phi)
    t1 = 1.0 - cos_phi
    sin_phi = xp.sin(phi)
    t2 = e[0] * t1
    t3 = e[1] * t1
    t4 = e[1] * t2
    t5 = e[2] * t2
    t6 = e[2] * t3
    t7 = e[0] * sin_phi
    t8 = e[1] * sin_phi
    t9 = e[2] * sin_phi
    Q = batch.array(
        (3, 3),
        cos_phi + e[0] * t2,
        t4 - t9,
        t5 + t8,
        t4 + t9,
        cos_phi + e[1] * t3,
        t6 - t7,
        t5 - t8,
        t6 + t7,
        cos_phi + e[2] * (e[2] * t1),
    )
    return delivered(out, Q)


def point_after_displacement(Q: Any, a: Any, a_prime: Any, p: Any, /, *, out: Any = None) -> Any:
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
    batch, Q, a, a_prime, p = prepared(
        "point_after_displacement",
        ("Q", Q, (3, 3)),
        ("a", a, (3,)),
        ("a_prime", a_prime, (3,)),
        ("p", p, (3,)),
    )
    t1 = p[0] - a[0]
    t2 = p[1] - a[1]
    t3 = p[2] - a[2]
    p_prime = batch.array(
        (3,),
        a_prime[0] + (Q[0][0] * t1 + Q[0][1] * t2 + Q[0][2] * t3),
        a_prime[1] + (Q[1][0] * t1 + Q[1][1] * t2 + Q[1][2] * t3),
        a_prime[2] + (Q[2][0] * t1 + Q[2][1] * t2 + Q[2][2] * t3),
    )
    return delivered(out, p_prime)


def pitch_of_motion(e: Any, phi: Any, d_P: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, d_P = prepared(
        "pitch_of_motion",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("d_P", d_P, (3,)),
    )
    xp = batch.xp
    t1 = e[0] * d_P[0] + e[1] * d_P[1] + e[2] * d_P[2]
    result = batch.array((), xp.where(phi == 0.0, batch.number(0.0), t1) / phi)
    return delivered(out, result)


def normal_matrix_inverse(e: Any, phi: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi = prepared("normal_matrix_inverse", ("e", e, (3,)), ("phi", phi, ()))
    xp = batch.xp
    t1 = xp.sin(0.5 * phi)
    t2 = xp.where(t1 == 0.0, batch.number(0.0), batch.number(0.5)) / t1
    t3 = t2 * t2
    t4 = 1.0 - t3
    t5 = e[0] * t4
    t6 = e[1] * t4
    t7 = e[1] * t5
    t8 = e[2] * t5
    t9 = e[2] * t6
    result = batch.array(
        (3, 3),
        t3 + e[0] * t5,
        t7,
        t8,
        t7,
        t3 + e[1] * t6,
        t9,
        t8,
        t9,
        t3 + e[2] * (e[2] * t4),
    )
    return delivered(out, result)


def screw_axis_point(e: Any, phi: Any, a: Any, a_prime: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, a, a_prime = prepared(
        "screw_axis_point",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("a", a, (3,)),
        ("a_prime", a_prime, (3,)),
    )
    xp = batch.xp
    t1 = a[0] + a_prime[0]
    t2 = a[1] + a_prime[1]
    t3 = a[2] + a_prime[2]
    t4 = e[0] * t1 + e[1] * t2 + e[2] * t3
    t5 = a_prime[0] - a[0]
    t6 = a_prime[1] - a[1]
    t7 = a_prime[2] - a[2]
    half_phi = 0.5 * phi
    sin_half_phi = xp.sin(half_phi)
    t8 = xp.where(sin_half_phi == 0.0, batch.number(0.0), xp.cos(half_phi))
    t9 = t8 / sin_half_phi
    p_0 = batch.array(
        (3,),
        0.5 * ((e[1] * t7 - e[2] * t6) * t9 - (e[0] * t4 - t1)),
        0.5 * ((e[2] * t5 - e[0] * t7) * t9 - (e[1] * t4 - t2)),
        0.5 * ((e[0] * t6 - e[1] * t5) * t9 - (e[2] * t4 - t3)),
    )
    return delivered(out, p_0)


def plucker_line(p_1: Any, p_2: Any, /, *, out: Any = None) -> Any:
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
    batch, p_1, p_2 = prepared("plucker_line", ("p_1", p_1, (3,)), ("p_2", p_2, (3,)))
    xp = batch.xp
    t1 = p_2[0] - p_1[0]
    t2 = p_2[1] - p_1[1]
    t3 = p_2[2] - p_1[2]
    t4 = xp.where(t1 < 0.0, -t1, t1)
    t5 = xp.where(t2 < 0.0, -t2, t2)
    t6 = xp.where(t4 < t5, t5, t4)
    t7 = xp.where(t3 < 0.0, -t3, t3)
    t8 = xp.where(t6 < t7, t7, t6)
    t9 = xp.where(0.0 == t8, batch.number(1.0), t8)
    t10 = t1 / t9
    t11 = t2 / t9
    t12 = t3 / t9
    t13 = t10 * t10 + t11 * t11 + t12 * t12
    t14 = xp.sqrt(t13)
    t15 = t13 == 0.0
    t16 = xp.where(t15, batch.number(0.0), t10) / t14
    t17 = xp.where(t15, batch.number(0.0), t11) / t14
    t18 = xp.where(t15, batch.number(0.0), t12) / t14
    kappa = batch.array(
        (6,),
        t16,
        t17,
        t18,
        p_1[1] * t18 - p_1[2] * t17,
        p_1[2] * t16 - p_1[0] * t18,
        p_1[0] * t17 - p_1[1] * t16,
    )
    return delivered(out, kappa)


def plucker_transfer(kappa_A: Any, a: Any, b: Any, /, *, out: Any = None) -> Any:
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
    batch, kappa_A, a, b = prepared(
        "plucker_transfer",
        ("kappa_A", kappa_A, (6,)),
        ("a", a, (3,)),
        ("b", b, (3,)),
    )
    t1 = a[0] - b[0]
    t2 = a[1] - b[1]
    t3 = a[2] - b[2]
    kappa_B = batch.array(
        (6,),
        kappa_A[0],
        kappa_A[1],
        kappa_A[2],
        kappa_A[3] + (kappa_A[2] * t2 - kappa_A[1] * t3),
        kappa_A[4] + (kappa_A[0] * t3 - kappa_A[2] * t1),
        kappa_A[5] + (kappa_A[1] * t1 - kappa_A[0] * t2),
    )
    return delivered(out, kappa_B)


def rotation_in_triad_axes(triad: Any, triad_prime: Any, /, *, out: Any = None) -> Any:
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
    batch, triad, triad_prime = prepared(
        "rotation_in_triad_axes",
        ("triad", triad, (3, 3)),
        ("triad_prime", triad_prime, (3, 3)),
    )
    t1 = triad[0][0] * triad_prime[0][0] + triad[1][0] * triad_prime[1][0]
    t2 = triad[0][0] * triad_prime[0][1] + triad[1][0] * triad_prime[1][1]
    t3 = triad[0][0] * triad_prime[0][2] + triad[1][0] * triad_prime[1][2]
    t4 = triad[0][1] * triad_prime[0][0] + triad[1][1] * triad_prime[1][0]
    t5 = triad[0][1] * triad_prime[0][1] + triad[1][1] * triad_prime[1][1]
    t6 = triad[0][1] * triad_prime[0][2] + triad[1][1] * triad_prime[1][2]
    t7 = triad[0][2] * triad_prime[0][0] + triad[1][2] * triad_prime[1][0]
    t8 = triad[0][2] * triad_prime[0][1] + triad[1][2] * triad_prime[1][1]
    t9 = triad[0][2] * triad_prime[0][2] + triad[1][2] * triad_prime[1][2]
    Q = batch.array(
        (3, 3),
        t1 + triad[2][0] * triad_prime[2][0],
        t2 + triad[2][0] * triad_prime[2][1],
        t3 + triad[2][0] * triad_prime[2][2],
        t4 + triad[2][1] * triad_prime[2][0],
        t5 + triad[2][1] * triad_prime[2][1],
        t6 + triad[2][1] * triad_prime[2][2],
        t7 + triad[2][2] * triad_prime[2][0],
        t8 + triad[2][2] * triad_prime[2][1],
        t9 + triad[2][2] * triad_prime[2][2],
    )
    return delivered(out, Q)


def rotation_from_triads(triad: Any, triad_prime: Any, /, *, out: Any = None) -> Any:
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
    batch, triad, triad_prime = prepared(
        "rotation_from_triads",
        ("triad", triad, (3, 3)),
        ("triad_prime", triad_prime, (3, 3)),
    )
    t1 = triad[0][0] * triad_prime[0][0] + triad[0][1] * triad_prime[0][1]
    t2 = triad[1][0] * triad_prime[0][0] + triad[1][1] * triad_prime[0][1]
    t3 = triad[2][0] * triad_prime[0][0] + triad[2][1] * triad_prime[0][1]
    t4 = triad[0][0] * triad_prime[1][0] + triad[0][1] * triad_prime[1][1]
    t5 = triad[1][0] * triad_prime[1][0] + triad[1][1] * triad_prime[1][1]
    t6 = triad[2][0] * triad_prime[1][0] + triad[2][1] * triad_prime[1][1]
    t7 = triad[0][0] * triad_prime[2][0] + triad[0][1] * triad_prime[2][1]
    t8 = triad[1][0] * triad_prime[2][0] + triad[1][1] * triad_prime[2][1]
    t9 = triad[2][0] * triad_prime[2][0] + triad[2][1] * triad_prime[2][1]
    Q = batch.array(
        (3, 3),
        t1 + triad[0][2] * triad_prime[0][2],
        t2 + triad[1][2] * triad_prime[0][2],
        t3 + triad[2][2] * triad_prime[0][2],
        t4 + triad[0][2] * triad_prime[1][2],
        t5 + triad[1][2] * triad_prime[1][2],
        t6 + triad[2][2] * triad_prime[1][2],
        t7 + triad[0][2] * triad_prime[2][2],
        t8 + triad[1][2] * triad_prime[2][2],
        t9 + triad[2][2] * triad_prime[2][2],
    )
    return delivered(out, Q)


def axial_vector(Omega: Any, /, *, out: Any = None) -> Any:
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
    batch, Omega = prepared("axial_vector", ("Omega", Omega, (3, 3)))
    omega = batch.array(
        (3,),
        0.5 * (Omega[2][1] - Omega[1][2]),
        0.5 * (Omega[0][2] - Omega[2][0]),
        0.5 * (Omega[1][0] - Omega[0][1]),
    )
    return delivered(out, omega)


def velocity_of_point(omega: Any, a_dot: Any, a: Any, p: Any, /, *, out: Any = None) -> Any:
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
    batch, omega, a_dot, a, p = prepared(
        "velocity_of_point",
        ("omega", omega, (3,)),
        ("a_dot", a_dot, (3,)),
        ("a", a, (3,)),
        ("p", p, (3,)),
    )
    t1 = p[0] - a[0]
    t2 = p[1] - a[1]
    t3 = p[2] - a[2]
    p_dot = batch.array(
        (3,),
        a_dot[0] + (omega[1] * t3 - omega[2] * t2),
        a_dot[1] + (omega[2] * t1 - omega[0] * t3),
        a_dot[2] + (omega[0] * t2 - omega[1] * t1),
    )
    return delivered(out, p_dot)


def instant_screw_point(omega: Any, a_dot: Any, a: Any, /, *, out: Any = None) -> Any:
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
    batch, omega, a_dot, a = prepared(
        "instant_screw_point",
        ("omega", omega, (3,)),
        ("a_dot", a_dot, (3,)),
        ("a", a, (3,)),
    )
    xp = batch.xp
    t1 = xp.where(omega[0] < 0.0, -omega[0], omega[0])
    t2 = xp.where(omega[1] < 0.0, -omega[1], omega[1])
    t3 = xp.where(t1 < t2, t2, t1)
    t4 = xp.where(omega[2] < 0.0, -omega[2], omega[2])
    t5 = xp.where(t3 < t4, t4, t3)
    t6 = xp.where(0.0 == t5, batch.number(1.0), t5)
    t7 = omega[0] / t6
    t8 = omega[1] / t6
    t9 = omega[2] / t6
    t10 = t7 * t7 + t8 * t8 + t9 * t9
    t11 = a_dot[0] - (omega[1] * a[2] - omega[2] * a[1])
    t12 = a_dot[1] - (omega[2] * a[0] - omega[0] * a[2])
    t13 = a_dot[2] - (omega[0] * a[1] - omega[1] * a[0])
    t14 = t10 == 0.0
    p_0_prime = batch.array(
        (3,),
        xp.where(t14, batch.number(0.0), t8 * t13 - t9 * t12) / t10 / t6,
        xp.where(t14, batch.number(0.0), t9 * t11 - t7 * t13) / t10 / t6,
        xp.where(t14, batch.number(0.0), t7 * t12 - t8 * t11) / t10 / t6,
    )
    return delivered(out, p_0_prime)


def natural_rate_matrix(e: Any, phi: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi = prepared("natural_rate_matrix", ("e", e, (3,)), ("phi", phi, ()))
    xp = batch.xp
    t1 = 0.5 * e[0]
    t2 = 0.5 * e[1]
    t3 = 0.5 * e[2]
    half_phi = 0.5 * phi
    sin_half_phi = xp.sin(half_phi)
    t4 = xp.where(sin_half_phi == 0.0, batch.number(0.0), xp.cos(half_phi))
    t5 = 0.5 * (t4 / sin_half_phi)
    t6 = e[1] * t5
    t7 = e[2] * t5
    t8 = e[0] * (e[0] * t5)
    t9 = e[0] * t6
    t10 = e[0] * t7
    t11 = e[1] * t6
    t12 = e[1] * t7
    t13 = e[2] * t7
    N = batch.array(
        (4, 3),
        t11 + t13,
        t3 - t9,
        -(t2 + t10),
        -(t3 + t9),
        t8 + t13,
        t1 - t12,
        t2 - t10,
        -(t1 + t12),
        t8 + t11,
        e[0],
        e[1],
        e[2],
    )
    return delivered(out, N)


def linear_rate_matrix(e: Any, phi: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi = prepared("linear_rate_matrix", ("e", e, (3,)), ("phi", phi, ()))
    xp = batch.xp
    t1 = 0.5 * xp.cos(phi)
    t2 = 0.5 - t1
    t3 = e[0] * t2
    t4 = e[1] * t2
    t5 = e[1] * t3
    t6 = e[2] * t3
    t7 = e[2] * t4
    t8 = 0.5 + t1
    sin_phi = xp.sin(phi)
    half_sin_phi = 0.5 * sin_phi
    t9 = e[0] * half_sin_phi
    t10 = e[1] * half_sin_phi
    t11 = e[2] * half_sin_phi
    L = batch.array(
        (4, 3),
        t8 - e[0] * t3,
        t11 - t5,
        -(t6 + t10),
        -(t5 + t11),
        t8 - e[1] * t4,
        t9 - t7,
        t10 - t6,
        -(t7 + t9),
        t8 - e[2] * (e[2] * t2),
        -(e[0] * sin_phi),
        -(e[1] * sin_phi),
        -(e[2] * sin_phi),
    )
    return delivered(out, L)


def euler_rodrigues_rate_matrix(e: Any, phi: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi = prepared("euler_rodrigues_rate_matrix", ("e", e, (3,)), ("phi", phi, ()))
    xp = batch.xp
    half_phi = 0.5 * phi
    t1 = 0.5 * xp.cos(half_phi)
    t2 = 0.5 * xp.sin(half_phi)
    t3 = e[0] * t2
    t4 = e[1] * t2
    t5 = e[2] * t2
    H = batch.array((4, 3), t1, t5, -t4, -t5, t1, t3, t4, -t3, t1, -t3, -t4, -t5)
    return delivered(out, H)


def rotation_from_linear_invariants(q: Any, q_0: Any, /, *, out: Any = None) -> Any:
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
    batch, q, q_0 = prepared("rotation_from_linear_invariants", ("q", q, (3,)), ("q_0", q_0, ()))
    xp = batch.xp
    t1 = 1.0 + q_0
    t2 = xp.where(t1 == 0.0, batch.number(0.0), batch.number(1.0)) / t1
    t3 = q[0] * t2
    t4 = q[1] * t2
    t5 = q[1] * t3
    t6 = q[2] * t3
    t7 = q[2] * t4
    Q = batch.array(
        (3, 3),
        q_0 + q[0] * t3,
        t5 - q[2],
        q[1] + t6,
        q[2] + t5,
        q_0 + q[1] * t4,
        t7 - q[0],
        t6 - q[1],
        q[0] + t7,
        q_0 + q[2] * (q[2] * t2),
    )
    return delivered(out, Q)


def rotation_from_euler_rodrigues(q: Any, q_0: Any, /, *, out: Any = None) -> Any:
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
    batch, q, q_0 = prepared("rotation_from_euler_rodrigues", ("q", q, (3,)), ("q_0", q_0, ()))
    t1 = q_0 * q_0 - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2])
    t2 = 2.0 * q_0
    t3 = 2.0 * q[0]
    t4 = 2.0 * q[1]
    t5 = q[1] * t3
    t6 = q[2] * t3
    t7 = q[2] * t4
    t8 = q[0] * t2
    t9 = q[1] * t2
    t10 = q[2] * t2
    Q = batch.array(
        (3, 3),
        t1 + q[0] * t3,
        t5 - t10,
        t6 + t9,
        t5 + t10,
        t1 + q[1] * t4,
        t7 - t8,
        t6 - t9,
        t7 + t8,
        t1 + q[2] * (2.0 * q[2]),
    )
    return delivered(out, Q)


def linear_invariants(Q: Any, /, *, out: Any = None) -> Any:
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
    batch, Q = prepared("linear_invariants", ("Q", Q, (3, 3)))
    q = batch.array(
        (3,),
        0.5 * (Q[2][1] - Q[1][2]),
        0.5 * (Q[0][2] - Q[2][0]),
        0.5 * (Q[1][0] - Q[0][1]),
    )
    q_0 = batch.array((), 0.5 * (Q[2][2] + (Q[0][0] + Q[1][1]) - 1.0))
    return delivered(out, q, q_0)


def natural_invariants(Q: Any, /, *, out: Any = None) -> Any:
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
    batch, Q = prepared("natural_invariants", ("Q", Q, (3, 3)))
    xp = batch.xp
    t1 = Q[0][2] + Q[2][0]
    t2 = Q[1][2] + Q[2][1]
    t3 = Q[2][2] + (Q[0][0] + Q[1][1])
    t4 = 1.0 + 2.0 * Q[2][2] - t3
    t5 = t1 * t1
    t6 = t2 * t2
    t7 = Q[0][1] + Q[1][0]
    t8 = 1.0 + 2.0 * Q[1][1] - t3
    t9 = t7 * t7
    t10 = Q[2][1] - Q[1][2]
    t11 = Q[0][2] - Q[2][0]
    t12 = Q[1][0] - Q[0][1]
    t13 = t11 * t11
    t14 = t6 + (t9 + t8 * t8) + t13
    t15 = t12 * t12
    t16 = t5 + t6 + t4 * t4 + t15
    t17 = t14 < t16
    t18 = xp.where(t17, t1, t7)
    t19 = xp.where(t17, t2, t8)
    t20 = xp.where(t17, t4, t2)
    t21 = 1.0 + 2.0 * Q[0][0] - t3
    t22 = t10 * t10
    t23 = t5 + (t9 + t21 * t21) + t22
    t24 = t23 < t16
    t25 = t23 < t14
    t26 = xp.where(t25, t18, xp.where(t24, t18, t21))
    t27 = xp.where(t25, t19, xp.where(t24, t19, t7))
    t28 = xp.where(t25, t20, xp.where(t24, t20, t1))
    t29 = 1.0 + t3
    t30 = t15 + (t13 + t22) + t29 * t29
    t31 = t30 < t16
    t32 = t30 < t14
    t33 = t30 < t23
    t34 = xp.where(t33, t26, xp.where(t32, t26, xp.where(t31, t26, t10)))
    t35 = xp.where(t33, t27, xp.where(t32, t27, xp.where(t31, t27, t11)))
    t36 = xp.where(t33, t28, xp.where(t32, t28, xp.where(t31, t28, t12)))
    t37 = xp.where(t34 < 0.0, -t34, t34)
    t38 = xp.where(t35 < 0.0, -t35, t35)
    t39 = xp.where(t37 < t38, t38, t37)
    t40 = xp.where(t36 < 0.0, -t36, t36)
    t41 = xp.where(t39 < t40, t40, t39)
    t42 = xp.where(0.0 == t41, batch.number(1.0), t41)
    t43 = t34 / t42
    t44 = t35 / t42
    t45 = t36 / t42
    t46 = t43 * t43 + t44 * t44 + t45 * t45
    t47 = xp.sqrt(t46)
    t48 = t46 == 0.0
    t49 = xp.where(t48, batch.number(0.0), t43) / t47
    t50 = xp.where(t48, batch.number(0.0), t44) / t47
    t51 = xp.where(t48, batch.number(0.0), t45) / t47
    t52 = xp.where(t17, t12, t11)
    t53 = xp.where(t17, t16, t14)
    t54 = xp.where(t25, t52, xp.where(t24, t52, t10))
    t55 = xp.where(t25, t53, xp.where(t24, t53, t23))
    t56 = xp.where(t33, t55, xp.where(t32, t55, xp.where(t31, t55, t30)))
    t57 = xp.sqrt(t56)
    t58 = t56 == 0.0
    t59 = xp.where(t33, t54, xp.where(t32, t54, xp.where(t31, t54, t29)))
    t60 = xp.where(t58, batch.number(0.0), t59) / t57
    t61 = xp.where(t51 < 0.0, batch.number(-1.0), batch.number(1.0))
    t62 = xp.where(0.0 < t50, batch.number(1.0), t61)
    t63 = xp.where(t50 < 0.0, batch.number(-1.0), t62)
    t64 = xp.where(0.0 < t49, batch.number(1.0), t63)
    t65 = xp.where(t49 < 0.0, batch.number(-1.0), t64)
    t66 = xp.where(0.0 < t60, batch.number(1.0), t65)
    t67 = xp.where(t60 < 0.0, batch.number(-1.0), t66)
    t68 = xp.where(0.0 == t30 - t30, t67, batch.number(xp.nan))
    e = batch.array((3,), t49 * t68, t50 * t68, t51 * t68)
    phi = batch.array(
        (),
        2.0 * xp.atan2(t42 * (xp.where(t58, batch.number(0.0), t47) / t57), t60 * t68),
    )
    return delivered(out, e, phi)


def euler_rodrigues_parameters(Q: Any, /, *, out: Any = None) -> Any:
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
    batch, Q = prepared("euler_rodrigues_parameters", ("Q", Q, (3, 3)))
    xp = batch.xp
    t1 = Q[0][2] + Q[2][0]
    t2 = Q[1][2] + Q[2][1]
    t3 = Q[2][2] + (Q[0][0] + Q[1][1])
    t4 = 1.0 + 2.0 * Q[2][2] - t3
    t5 = Q[2][1] - Q[1][2]
    t6 = Q[0][2] - Q[2][0]
    t7 = Q[1][0] - Q[0][1]
    t8 = t1 * t1
    t9 = t2 * t2
    t10 = t7 * t7
    t11 = t8 + t9 + t4 * t4 + t10
    t12 = Q[0][1] + Q[1][0]
    t13 = 1.0 + 2.0 * Q[1][1] - t3
    t14 = t12 * t12
    t15 = t6 * t6
    t16 = t9 + (t14 + t13 * t13) + t15
    t17 = t16 < t11
    t18 = xp.where(t17, t1, t12)
    t19 = xp.where(t17, t11, t16)
    t20 = xp.where(t17, t2, t13)
    t21 = xp.where(t17, t4, t2)
    t22 = 1.0 + 2.0 * Q[0][0] - t3
    t23 = t5 * t5
    t24 = t8 + (t14 + t22 * t22) + t23
    t25 = t24 < t11
    t26 = t24 < t16
    t27 = xp.where(t26, t18, xp.where(t25, t18, t22))
    t28 = xp.where(t26, t19, xp.where(t25, t19, t24))
    t29 = xp.where(t26, t20, xp.where(t25, t20, t12))
    t30 = xp.where(t26, t21, xp.where(t25, t21, t1))
    t31 = 1.0 + t3
    t32 = t10 + (t15 + t23) + t31 * t31
    t33 = t32 < t11
    t34 = t32 < t16
    t35 = t32 < t24
    t36 = xp.where(t35, t28, xp.where(t34, t28, xp.where(t33, t28, t32)))
    t37 = xp.sqrt(t36)
    t38 = t36 == 0.0
    t39 = xp.where(t35, t27, xp.where(t34, t27, xp.where(t33, t27, t5)))
    t40 = xp.where(t38, batch.number(0.0), t39) / t37
    t41 = xp.where(t35, t29, xp.where(t34, t29, xp.where(t33, t29, t6)))
    t42 = xp.where(t38, batch.number(0.0), t41) / t37
    t43 = xp.where(t35, t30, xp.where(t34, t30, xp.where(t33, t30, t7)))
    t44 = xp.where(t38, batch.number(0.0), t43) / t37
    t45 = xp.where(t17, t7, t6)
    t46 = xp.where(t26, t45, xp.where(t25, t45, t5))
    t47 = xp.where(t35, t46, xp.where(t34, t46, xp.where(t33, t46, t31)))
    t48 = xp.where(t38, batch.number(0.0), t47) / t37
    t49 = xp.where(t44 < 0.0, batch.number(-1.0), batch.number(1.0))
    t50 = xp.where(0.0 < t42, batch.number(1.0), t49)
    t51 = xp.where(t42 < 0.0, batch.number(-1.0), t50)
    t52 = xp.where(0.0 < t40, batch.number(1.0), t51)
    t53 = xp.where(t40 < 0.0, batch.number(-1.0), t52)
    t54 = xp.where(0.0 < t48, batch.number(1.0), t53)
    t55 = xp.where(t48 < 0.0, batch.number(-1.0), t54)
    t56 = xp.where(0.0 == t32 - t32, t55, batch.number(xp.nan))
    q = batch.array((3,), t40 * t56, t42 * t56, t44 * t56)
    q_0 = batch.array((), t48 * t56)
    return delivered(out, q, q_0)


def screw_of_motion(Q: Any, a: Any, a_prime: Any, /, *, out: Any = None) -> Any:
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
    batch, Q, a, a_prime = prepared(
        "screw_of_motion",
        ("Q", Q, (3, 3)),
        ("a", a, (3,)),
        ("a_prime", a_prime, (3,)),
    )
    xp = batch.xp
    t1 = Q[0][2] + Q[2][0]
    t2 = Q[1][2] + Q[2][1]
    t3 = Q[2][2] + (Q[0][0] + Q[1][1])
    t4 = 1.0 + 2.0 * Q[2][2] - t3
    t5 = t1 * t1
    t6 = t2 * t2
    t7 = Q[0][1] + Q[1][0]
    t8 = 1.0 + 2.0 * Q[1][1] - t3
    t9 = t7 * t7
    t10 = Q[2][1] - Q[1][2]
    t11 = Q[0][2] - Q[2][0]
    t12 = Q[1][0] - Q[0][1]
    t13 = t11 * t11
    t14 = t6 + (t9 + t8 * t8) + t13
    t15 = t12 * t12
    t16 = t5 + t6 + t4 * t4 + t15
    t17 = t14 < t16
    t18 = xp.where(t17, t1, t7)
    t19 = xp.where(t17, t2, t8)
    t20 = xp.where(t17, t4, t2)
    t21 = 1.0 + 2.0 * Q[0][0] - t3
    t22 = t10 * t10
    t23 = t5 + (t9 + t21 * t21) + t22
    t24 = t23 < t16
    t25 = t23 < t14
    t26 = xp.where(t25, t18, xp.where(t24, t18, t21))
    t27 = xp.where(t25, t19, xp.where(t24, t19, t7))
    t28 = xp.where(t25, t20, xp.where(t24, t20, t1))
    t29 = 1.0 + t3
    t30 = t15 + (t13 + t22) + t29 * t29
    t31 = t30 < t16
    t32 = t30 < t14
    t33 = t30 < t23
    t34 = xp.where(t33, t26, xp.where(t32, t26, xp.where(t31, t26, t10)))
    t35 = xp.where(t33, t27, xp.where(t32, t27, xp.where(t31, t27, t11)))
    t36 = xp.where(t33, t28, xp.where(t32, t28, xp.where(t31, t28, t12)))
    t37 = xp.where(t34 < 0.0, -t34, t34)
    t38 = xp.where(t35 < 0.0, -t35, t35)
    t39 = xp.where(t37 < t38, t38, t37)
    t40 = xp.where(t36 < 0.0, -t36, t36)
    t41 = xp.where(t39 < t40, t40, t39)
    t42 = xp.where(0.0 == t41, batch.number(1.0), t41)
    t43 = t34 / t42
    t44 = t35 / t42
    t45 = t36 / t42
    t46 = t43 * t43 + t44 * t44 + t45 * t45
    t47 = xp.sqrt(t46)
    t48 = t46 == 0.0
    t49 = xp.where(t48, batch.number(0.0), t43) / t47
    t50 = xp.where(t48, batch.number(0.0), t44) / t47
    t51 = xp.where(t48, batch.number(0.0), t45) / t47
    t52 = xp.where(t17, t12, t11)
    t53 = xp.where(t17, t16, t14)
    t54 = xp.where(t25, t52, xp.where(t24, t52, t10))
    t55 = xp.where(t25, t53, xp.where(t24, t53, t23))
    t56 = xp.where(t33, t55, xp.where(t32, t55, xp.where(t31, t55, t30)))
    t57 = xp.sqrt(t56)
    t58 = t56 == 0.0
    t59 = xp.where(t33, t54, xp.where(t32, t54, xp.where(t31, t54, t29)))
    t60 = xp.where(t58, batch.number(0.0), t59) / t57
    t61 = xp.where(t58, batch.number(0.0), t47) / t57
    t62 = xp.where(t51 < 0.0, batch.number(-1.0), batch.number(1.0))
    t63 = xp.where(0.0 < t50, batch.number(1.0), t62)
    t64 = xp.where(t50 < 0.0, batch.number(-1.0), t63)
    t65 = xp.where(0.0 < t49, batch.number(1.0), t64)
    t66 = xp.where(t49 < 0.0, batch.number(-1.0), t65)
    t67 = xp.where(0.0 < t60, batch.number(1.0), t66)
    t68 = xp.where(t60 < 0.0, batch.number(-1.0), t67)
    t69 = xp.where(0.0 == t30 - t30, t68, batch.number(xp.nan))
    t70 = t49 * t69
    t71 = t50 * t69
    t72 = t51 * t69
    t73 = a[0] + a_prime[0]
    t74 = a[1] + a_prime[1]
    t75 = a[2] + a_prime[2]
    t76 = a_prime[0] - a[0]
    t77 = a_prime[1] - a[1]
    t78 = a_prime[2] - a[2]
    t79 = t71 * t78 - t72 * t77
    t80 = t72 * t76 - t70 * t78
    t81 = t70 * t77 - t71 * t76
    t82 = t60 * t69
    t83 = xp.where(t61 == 0.0, batch.number(0.0), t82) / t61
    axis = batch.array(
        (6,),
        t70,
        t71,
        t72,
        0.5 * (t72 * t74 - t71 * t75 + (t72 * t80 - t71 * t81) * t83 / t42),
        0.5 * (t70 * t75 - t72 * t73 + (t70 * t81 - t72 * t79) * t83 / t42),
        0.5 * (t71 * t73 - t70 * t74 + (t71 * t79 - t70 * t80) * t83 / t42),
    )
    d_0 = batch.array((), t70 * t76 + t71 * t77 + t72 * t78)
    phi = batch.array((), 2.0 * xp.atan2(t42 * t61, t82))
    return delivered(out, axis, d_0, phi)


def instant_screw(omega: Any, a_dot: Any, a: Any, /, *, out: Any = None) -> Any:
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
    batch, omega, a_dot, a = prepared(
        "instant_screw",
        ("omega", omega, (3,)),
        ("a_dot", a_dot, (3,)),
        ("a", a, (3,)),
    )
    xp = batch.xp
    t1 = xp.where(omega[0] < 0.0, -omega[0], omega[0])
    t2 = xp.where(omega[1] < 0.0, -omega[1], omega[1])
    t3 = xp.where(t1 < t2, t2, t1)
    t4 = xp.where(omega[2] < 0.0, -omega[2], omega[2])
    t5 = xp.where(t3 < t4, t4, t3)
    t6 = xp.where(0.0 == t5, batch.number(1.0), t5)
    t7 = omega[0] / t6
    t8 = omega[1] / t6
    t9 = omega[2] / t6
    t10 = t7 * t7 + t8 * t8 + t9 * t9
    t11 = xp.sqrt(t10)
    t12 = t10 == 0.0
    t13 = xp.where(t12, batch.number(0.0), t7) / t11
    t14 = xp.where(t12, batch.number(0.0), t8) / t11
    t15 = xp.where(t12, batch.number(0.0), t9) / t11
    t16 = xp.where(t12, batch.number(0.0), a_dot[0]) / t11
    t17 = xp.where(t12, batch.number(0.0), a_dot[1]) / t11
    t18 = xp.where(t12, batch.number(0.0), a_dot[2]) / t11
    t19 = a[0] + (t14 * t18 - t15 * t17) / t6
    t20 = a[1] + (t15 * t16 - t13 * t18) / t6
    t21 = a[2] + (t13 * t17 - t14 * t16) / t6
    axis = batch.array(
        (6,),
        t13,
        t14,
        t15,
        t15 * t20 - t14 * t21,
        t13 * t21 - t15 * t19,
        t14 * t19 - t13 * t20,
    )
    pitch = batch.array((), (t13 * t16 + t14 * t17 + t15 * t18) / t6)
    return delivered(out, axis, pitch)


def natural_velocity_matrix(e: Any, phi: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi = prepared("natural_velocity_matrix", ("e", e, (3,)), ("phi", phi, ()))
    xp = batch.xp
    sin_phi = xp.sin(phi)
    t1 = 1.0 - xp.cos(phi)
    t2 = e[0] * t1
    t3 = e[1] * t1
    t4 = e[2] * t1
    N_tilde = batch.array(
        (3, 4),
        sin_phi,
        -t4,
        t3,
        e[0],
        t4,
        sin_phi,
        -t2,
        e[1],
        -t3,
        t2,
        sin_phi,
        e[2],
    )
    return delivered(out, N_tilde)


def linear_velocity_matrix(e: Any, phi: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi = prepared("linear_velocity_matrix", ("e", e, (3,)), ("phi", phi, ()))
    xp = batch.xp
    half_phi = 0.5 * phi
    cos_half_phi = xp.cos(half_phi)
    t1 = xp.where(cos_half_phi == 0.0, batch.number(0.0), xp.sin(half_phi))
    t2 = t1 / cos_half_phi
    t3 = e[0] * t2
    t4 = e[1] * t2
    t5 = e[2] * t2
    L_tilde = batch.array((3, 4), 1.0, -t5, t4, -t3, t5, 1.0, -t3, -t4, -t4, t3, 1.0, -t5)
    return delivered(out, L_tilde)


def euler_rodrigues_velocity_matrix(e: Any, phi: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi = prepared("euler_rodrigues_velocity_matrix", ("e", e, (3,)), ("phi", phi, ()))
    xp = batch.xp
    half_phi = 0.5 * phi
    t1 = 2.0 * xp.cos(half_phi)
    t2 = 2.0 * xp.sin(half_phi)
    t3 = e[0] * t2
    t4 = e[1] * t2
    t5 = e[2] * t2
    H_tilde = batch.array((3, 4), t1, -t5, t4, -t3, t5, t1, -t3, -t4, -t4, t3, t1, -t5)
    return delivered(out, H_tilde)


def pose_rate_natural(e: Any, phi: Any, t: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, t = prepared("pose_rate_natural", ("e", e, (3,)), ("phi", phi, ()), ("t", t, (6,)))
    xp = batch.xp
    t1 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2]
    half_phi = 0.5 * phi
    sin_half_phi = xp.sin(half_phi)
    t2 = xp.where(sin_half_phi == 0.0, batch.number(0.0), xp.cos(half_phi))
    t3 = 0.5 * (t2 / sin_half_phi)
    s_dot = batch.array(
        (7,),
        -(0.5 * (e[1] * t[2] - e[2] * t[1]) + (e[0] * t1 - t[0]) * t3),
        -(0.5 * (e[2] * t[0] - e[0] * t[2]) + (e[1] * t1 - t[1]) * t3),
        -(0.5 * (e[0] * t[1] - e[1] * t[0]) + (e[2] * t1 - t[2]) * t3),
        t1,
        t[3],
        t[4],
        t[5],
    )
    return delivered(out, s_dot)


def pose_rate_linear(e: Any, phi: Any, t: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, t = prepared("pose_rate_linear", ("e", e, (3,)), ("phi", phi, ()), ("t", t, (6,)))
    xp = batch.xp
    t1 = 0.5 * xp.cos(phi)
    t2 = 0.5 + t1
    t3 = (e[0] * t[0] + e[1] * t[1] + e[2] * t[2]) * (0.5 - t1)
    sin_phi = xp.sin(phi)
    half_sin_phi = 0.5 * sin_phi
    s_dot = batch.array(
        (7,),
        t[0] * t2 - e[0] * t3 - (e[1] * t[2] - e[2] * t[1]) * half_sin_phi,
        t[1] * t2 - e[1] * t3 - (e[2] * t[0] - e[0] * t[2]) * half_sin_phi,
        t[2] * t2 - e[2] * t3 - (e[0] * t[1] - e[1] * t[0]) * half_sin_phi,
        -(t[0] * (e[0] * sin_phi) + t[1] * (e[1] * sin_phi) + t[2] * (e[2] * sin_phi)),
        t[3],
        t[4],
        t[5],
    )
    return delivered(out, s_dot)


def pose_rate_euler_rodrigues(e: Any, phi: Any, t: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, t = prepared(
        "pose_rate_euler_rodrigues",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("t", t, (6,)),
    )
    xp = batch.xp
    half_phi = 0.5 * phi
    t1 = 0.5 * xp.cos(half_phi)
    t2 = 0.5 * xp.sin(half_phi)
    t3 = e[0] * t2
    t4 = e[1] * t2
    t5 = e[2] * t2
    s_dot = batch.array(
        (7,),
        t[0] * t1 + t[1] * t5 - t[2] * t4,
        t[1] * t1 - t[0] * t5 + t[2] * t3,
        t[0] * t4 - t[1] * t3 + t[2] * t1,
        -(t[0] * t3 + t[1] * t4 + t[2] * t5),
        t[3],
        t[4],
        t[5],
    )
    return delivered(out, s_dot)


def twist_from_pose_rate_natural(e: Any, phi: Any, s_dot: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, s_dot = prepared(
        "twist_from_pose_rate_natural",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("s_dot", s_dot, (7,)),
    )
    xp = batch.xp
    sin_phi = xp.sin(phi)
    t1 = 1.0 - xp.cos(phi)
    t = batch.array(
        (6,),
        s_dot[0] * sin_phi + t1 * (e[1] * s_dot[2] - e[2] * s_dot[1]) + e[0] * s_dot[3],
        s_dot[1] * sin_phi + t1 * (e[2] * s_dot[0] - e[0] * s_dot[2]) + e[1] * s_dot[3],
        s_dot[2] * sin_phi + t1 * (e[0] * s_dot[1] - e[1] * s_dot[0]) + e[2] * s_dot[3],
        s_dot[4],
        s_dot[5],
        s_dot[6],
    )
    return delivered(out, t)


def twist_from_pose_rate_linear(e: Any, phi: Any, s_dot: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, s_dot = prepared(
        "twist_from_pose_rate_linear",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("s_dot", s_dot, (7,)),
    )
    xp = batch.xp
    half_phi = 0.5 * phi
    cos_half_phi = xp.cos(half_phi)
    t1 = xp.where(cos_half_phi == 0.0, batch.number(0.0), xp.sin(half_phi))
    t2 = t1 / cos_half_phi
    t3 = e[0] * t2
    t4 = e[1] * t2
    t5 = e[2] * t2
    t = batch.array(
        (6,),
        s_dot[0] - s_dot[1] * t5 + s_dot[2] * t4 - s_dot[3] * t3,
        s_dot[1] + s_dot[0] * t5 - s_dot[2] * t3 - s_dot[3] * t4,
        s_dot[2] + (s_dot[1] * t3 - s_dot[0] * t4) - s_dot[3] * t5,
        s_dot[4],
        s_dot[5],
        s_dot[6],
    )
    return delivered(out, t)


def twist_from_pose_rate_euler_rodrigues(e: Any, phi: Any, s_dot: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, s_dot = prepared(
        "twist_from_pose_rate_euler_rodrigues",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("s_dot", s_dot, (7,)),
    )
    xp = batch.xp
    half_phi = 0.5 * phi
    t1 = 2.0 * xp.cos(half_phi)
    t2 = 2.0 * xp.sin(half_phi)
    t3 = e[0] * t2
    t4 = e[1] * t2
    t5 = e[2] * t2
    t = batch.array(
        (6,),
        s_dot[0] * t1 - s_dot[1] * t5 + s_dot[2] * t4 - s_dot[3] * t3,
        s_dot[0] * t5 + s_dot[1] * t1 - s_dot[2] * t3 - s_dot[3] * t4,
        s_dot[1] * t3 - s_dot[0] * t4 + s_dot[2] * t1 - s_dot[3] * t5,
        s_dot[4],
        s_dot[5],
        s_dot[6],
    )
    return delivered(out, t)


def twist_transfer(t_A: Any, a: Any, p: Any, /, *, out: Any = None) -> Any:
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
    batch, t_A, a, p = prepared("twist_transfer", ("t_A", t_A, (6,)), ("a", a, (3,)), ("p", p, (3,)))
    t1 = a[0] - p[0]
    t2 = a[1] - p[1]
    t3 = a[2] - p[2]
    t_P = batch.array(
        (6,),
        t_A[0],
        t_A[1],
        t_A[2],
        t_A[3] + (t_A[2] * t2 - t_A[1] * t3),
        t_A[4] + (t_A[0] * t3 - t_A[2] * t1),
        t_A[5] + (t_A[1] * t1 - t_A[0] * t2),
    )
    return delivered(out, t_P)


def angular_acceleration_matrix(omega: Any, omega_dot: Any, /, *, out: Any = None) -> Any:
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
    batch, omega, omega_dot = prepared(
        "angular_acceleration_matrix",
        ("omega", omega, (3,)),
        ("omega_dot", omega_dot, (3,)),
    )
    t1 = omega[0] * omega[0]
    t2 = omega[0] * omega[1]
    t3 = omega[0] * omega[2]
    t4 = omega[1] * omega[1]
    t5 = omega[1] * omega[2]
    t6 = omega[2] * omega[2]
    W = batch.array(
        (3, 3),
        -(t4 + t6),
        t2 - omega_dot[2],
        omega_dot[1] + t3,
        omega_dot[2] + t2,
        -(t1 + t6),
        t5 - omega_dot[0],
        t3 - omega_dot[1],
        omega_dot[0] + t5,
        -(t1 + t4),
    )
    return delivered(out, W)


def acceleration_of_point(omega: Any, omega_dot: Any, a_ddot: Any, a: Any, p: Any, /, *, out: Any = None) -> Any:
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
    batch, omega, omega_dot, a_ddot, a, p = prepared(
        "acceleration_of_point",
        ("omega", omega, (3,)),
        ("omega_dot", omega_dot, (3,)),
        ("a_ddot", a_ddot, (3,)),
        ("a", a, (3,)),
        ("p", p, (3,)),
    )
    t1 = p[0] - a[0]
    t2 = p[1] - a[1]
    t3 = p[2] - a[2]
    t4 = omega[1] * t3 - omega[2] * t2
    t5 = omega[2] * t1 - omega[0] * t3
    t6 = omega[0] * t2 - omega[1] * t1
    t7 = a_ddot[0] + (omega_dot[1] * t3 - omega_dot[2] * t2)
    t8 = a_ddot[1] + (omega_dot[2] * t1 - omega_dot[0] * t3)
    t9 = a_ddot[2] + (omega_dot[0] * t2 - omega_dot[1] * t1)
    p_ddot = batch.array(
        (3,),
        t7 + (omega[1] * t6 - omega[2] * t5),
        t8 + (omega[2] * t4 - omega[0] * t6),
        t9 + (omega[0] * t5 - omega[1] * t4),
    )
    return delivered(out, p_ddot)


def natural_rate_matrix_dot(e: Any, phi: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, omega = prepared(
        "natural_rate_matrix_dot",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("omega", omega, (3,)),
    )
    xp = batch.xp
    half_phi = 0.5 * phi
    sin_half_phi = xp.sin(half_phi)
    t1 = xp.where(sin_half_phi == 0.0, batch.number(0.0), xp.cos(half_phi))
    t2 = t1 / sin_half_phi
    half_t2 = 0.5 * t2
    t3 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2]
    t4 = (half_t2 * half_t2 + 0.25) * t3
    t5 = 0.5 * e[0]
    t6 = 0.5 * e[1]
    t7 = 0.5 * e[2]
    t8 = half_t2 * (e[0] * t3 - omega[0]) + (omega[2] * t6 - omega[1] * t7)
    t9 = half_t2 * (e[1] * t3 - omega[1]) + (omega[0] * t7 - omega[2] * t5)
    t10 = half_t2 * (e[2] * t3 - omega[2]) + (omega[1] * t5 - omega[0] * t6)
    t11 = e[0] * t4 + t2 * t8
    t12 = e[1] * t4 + t2 * t9
    t13 = e[2] * t4 + t2 * t10
    half_t8 = 0.5 * t8
    half_t9 = 0.5 * t9
    half_t10 = 0.5 * t10
    t14 = t5 * t12 + t6 * t11
    t15 = t5 * t13 + t7 * t11
    t16 = t6 * t13 + t7 * t12
    N_dot = batch.array(
        (4, 3),
        e[0] * t11 - t4,
        t14 - half_t10,
        half_t9 + t15,
        half_t10 + t14,
        e[1] * t12 - t4,
        t16 - half_t8,
        t15 - half_t9,
        half_t8 + t16,
        e[2] * t13 - t4,
        -t8,
        -t9,
        -t10,
    )
    return delivered(out, N_dot)


def linear_rate_matrix_dot(e: Any, phi: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, omega = prepared(
        "linear_rate_matrix_dot",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("omega", omega, (3,)),
    )
    xp = batch.xp
    t1 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2]
    t2 = 0.5 * xp.sin(phi)
    t3 = t1 * t2
    t4 = e[1] * omega[2] - e[2] * omega[1]
    t5 = e[2] * omega[0] - e[0] * omega[2]
    t6 = e[0] * omega[1] - e[1] * omega[0]
    t7 = 0.5 * xp.cos(phi)
    t8 = 0.5 - t7
    t9 = omega[0] * t2 - t4 * t8
    t10 = omega[1] * t2 - t5 * t8
    t11 = omega[2] * t2 - t6 * t8
    t12 = 0.5 + t7
    t13 = t1 * t8
    t14 = omega[0] * t12 - e[0] * t13 - t2 * t4
    t15 = omega[1] * t12 - e[1] * t13 - t2 * t5
    t16 = omega[2] * t12 - e[2] * t13 - t2 * t6
    half_t14 = 0.5 * t14
    half_t15 = 0.5 * t15
    half_t16 = 0.5 * t16
    t17 = 0.5 * e[0]
    t18 = 0.5 * e[1]
    t19 = 0.5 * e[2]
    t20 = t10 * t17 + t9 * t18
    t21 = t11 * t17 + t9 * t19
    t22 = t11 * t18 + t10 * t19
    L_dot = batch.array(
        (4, 3),
        -(t3 + e[0] * t9),
        half_t16 - t20,
        -(half_t15 + t21),
        -(half_t16 + t20),
        -(t3 + e[1] * t10),
        half_t14 - t22,
        half_t15 - t21,
        -(half_t14 + t22),
        -(t3 + e[2] * t11),
        -t14,
        -t15,
        -t16,
    )
    return delivered(out, L_dot)


def euler_rodrigues_rate_matrix_dot(e: Any, phi: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, omega = prepared(
        "euler_rodrigues_rate_matrix_dot",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("omega", omega, (3,)),
    )
    xp = batch.xp
    half_phi = 0.5 * phi
    t1 = 0.25 * xp.sin(half_phi)
    t2 = e[0] * t1
    t3 = e[1] * t1
    t4 = e[2] * t1
    t5 = -(omega[0] * t2 + omega[1] * t3 + omega[2] * t4)
    t6 = 0.25 * xp.cos(half_phi)
    t7 = omega[0] * t6 - (omega[2] * t3 - omega[1] * t4)
    t8 = omega[1] * t6 - (omega[0] * t4 - omega[2] * t2)
    t9 = omega[2] * t6 - (omega[1] * t2 - omega[0] * t3)
    H_dot = batch.array((4, 3), t5, t9, -t8, -t9, t5, t7, t8, -t7, t5, -t7, -t8, -t9)
    return delivered(out, H_dot)


def natural_velocity_matrix_dot(e: Any, phi: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, omega = prepared(
        "natural_velocity_matrix_dot",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("omega", omega, (3,)),
    )
    xp = batch.xp
    t1 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2]
    half_phi = 0.5 * phi
    sin_half_phi = xp.sin(half_phi)
    t2 = sin_half_phi * sin_half_phi
    t3 = t1 * (1.0 - 2.0 * t2)
    cos_half_phi = xp.cos(half_phi)
    t4 = sin_half_phi * cos_half_phi
    t5 = t1 * t4
    t6 = e[1] * omega[2] - e[2] * omega[1]
    t7 = e[2] * omega[0] - e[0] * omega[2]
    t8 = e[0] * omega[1] - e[1] * omega[0]
    t9 = e[0] * t5 + (omega[0] * t4 - t2 * t6)
    t10 = e[1] * t5 + (omega[1] * t4 - t2 * t7)
    t11 = e[2] * t5 + (omega[2] * t4 - t2 * t8)
    t12 = xp.where(sin_half_phi == 0.0, batch.number(0.0), cos_half_phi) / sin_half_phi
    half_t12 = 0.5 * t12
    N_tilde_dot = batch.array(
        (3, 4),
        t3,
        -t11,
        t10,
        -((e[0] * t1 - omega[0]) * half_t12 + 0.5 * t6),
        t11,
        t3,
        -t9,
        -((e[1] * t1 - omega[1]) * half_t12 + 0.5 * t7),
        -t10,
        t9,
        t3,
        -((e[2] * t1 - omega[2]) * half_t12 + 0.5 * t8),
    )
    return delivered(out, N_tilde_dot)


def linear_velocity_matrix_dot(e: Any, phi: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, omega = prepared(
        "linear_velocity_matrix_dot",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("omega", omega, (3,)),
    )
    xp = batch.xp
    half_phi = 0.5 * phi
    cos_half_phi = xp.cos(half_phi)
    t1 = xp.where(cos_half_phi == 0.0, batch.number(0.0), xp.sin(half_phi))
    t2 = t1 / cos_half_phi
    t3 = e[0] * t2
    t4 = e[1] * t2
    t5 = e[2] * t2
    t6 = t2 * (omega[0] * t3 + omega[1] * t4 + omega[2] * t5)
    t7 = 0.5 * (omega[0] + e[0] * t6 - (omega[2] * t4 - omega[1] * t5))
    t8 = 0.5 * (omega[1] + e[1] * t6 - (omega[0] * t5 - omega[2] * t3))
    t9 = 0.5 * (omega[2] + e[2] * t6 - (omega[1] * t3 - omega[0] * t4))
    L_tilde_dot = batch.array((3, 4), 0.0, -t9, t8, -t7, t9, 0.0, -t7, -t8, -t8, t7, 0.0, -t9)
    return delivered(out, L_tilde_dot)


def euler_rodrigues_velocity_matrix_dot(e: Any, phi: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, omega = prepared(
        "euler_rodrigues_velocity_matrix_dot",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("omega", omega, (3,)),
    )
    xp = batch.xp
    half_phi = 0.5 * phi
    sin_half_phi = xp.sin(half_phi)
    t1 = e[0] * sin_half_phi
    t2 = e[1] * sin_half_phi
    t3 = e[2] * sin_half_phi
    cos_half_phi = xp.cos(half_phi)
    t4 = omega[0] * cos_half_phi - (omega[2] * t2 - omega[1] * t3)
    t5 = omega[1] * cos_half_phi - (omega[0] * t3 - omega[2] * t1)
    t6 = omega[2] * cos_half_phi - (omega[1] * t1 - omega[0] * t2)
    t7 = -(omega[0] * t1 + omega[1] * t2 + omega[2] * t3)
    H_tilde_dot = batch.array((3, 4), t7, -t6, t5, -t4, t6, t7, -t4, -t5, -t5, t4, t7, -t6)
    return delivered(out, H_tilde_dot)


def pose_acceleration_natural(e: Any, phi: Any, t: Any, t_dot: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, t, t_dot = prepared(
        "pose_acceleration_natural",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("t", t, (6,)),
        ("t_dot", t_dot, (6,)),
    )
    xp = batch.xp
    t1 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2]
    t2 = e[0] * t1 - t[0]
    t3 = e[1] * t1 - t[1]
    t4 = e[2] * t1 - t[2]
    half_phi = 0.5 * phi
    sin_half_phi = xp.sin(half_phi)
    t5 = xp.where(sin_half_phi == 0.0, batch.number(0.0), xp.cos(half_phi))
    t6 = 0.5 * (t5 / sin_half_phi)
    t7 = t2 * t6 + 0.5 * (e[1] * t[2] - e[2] * t[1])
    t8 = t3 * t6 + 0.5 * (e[2] * t[0] - e[0] * t[2])
    t9 = t4 * t6 + 0.5 * (e[0] * t[1] - e[1] * t[0])
    t10 = e[0] * t_dot[0] + e[1] * t_dot[1] + e[2] * t_dot[2]
    t11 = t10 - (t[0] * t7 + t[1] * t8 + t[2] * t9)
    t12 = t1 * (t6 * t6 + 0.25)
    t13 = 0.5 * (e[1] * t_dot[2] - e[2] * t_dot[1] + (t[1] * t9 - t[2] * t8))
    t14 = 0.5 * (e[2] * t_dot[0] - e[0] * t_dot[2] + (t[2] * t7 - t[0] * t9))
    t15 = 0.5 * (e[0] * t_dot[1] - e[1] * t_dot[0] + (t[0] * t8 - t[1] * t7))
    s_ddot = batch.array(
        (7,),
        t6 * (t_dot[0] - e[0] * t11 + t1 * t7) + t2 * t12 - t13,
        t6 * (t_dot[1] - e[1] * t11 + t1 * t8) + t3 * t12 - t14,
        t6 * (t_dot[2] - e[2] * t11 + t1 * t9) + t4 * t12 - t15,
        t11,
        t_dot[3],
        t_dot[4],
        t_dot[5],
    )
    return delivered(out, s_ddot)


def pose_acceleration_linear(e: Any, phi: Any, t: Any, t_dot: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, t, t_dot = prepared(
        "pose_acceleration_linear",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("t", t, (6,)),
        ("t_dot", t_dot, (6,)),
    )
    xp = batch.xp
    t1 = 0.5 * xp.cos(phi)
    t2 = 0.5 + t1
    sin_phi = xp.sin(phi)
    half_sin_phi = 0.5 * sin_phi
    t3 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2]
    t4 = half_sin_phi * t3
    t5 = 0.5 - t1
    t6 = t3 * t5
    t7 = t_dot[0] * t2 - (e[1] * t_dot[2] - e[2] * t_dot[1]) * half_sin_phi - t[0] * t4
    t8 = t_dot[1] * t2 - (e[2] * t_dot[0] - e[0] * t_dot[2]) * half_sin_phi - t[1] * t4
    t9 = t_dot[2] * t2 - (e[0] * t_dot[1] - e[1] * t_dot[0]) * half_sin_phi - t[2] * t4
    t10 = e[0] * t_dot[0] + e[1] * t_dot[1] + e[2] * t_dot[2]
    t11 = t[0] * t[0] + t[1] * t[1] + t[2] * t[2]
    t12 = t5 * t10 + half_sin_phi * t11
    s_ddot = batch.array(
        (7,),
        t7 + (e[1] * t[2] - e[2] * t[1]) * t6 - e[0] * t12,
        t8 + (e[2] * t[0] - e[0] * t[2]) * t6 - e[1] * t12,
        t9 + (e[0] * t[1] - e[1] * t[0]) * t6 - e[2] * t12,
        t3 * t6 - sin_phi * t10 - t2 * t11,
        t_dot[3],
        t_dot[4],
        t_dot[5],
    )
    return delivered(out, s_ddot)


def pose_acceleration_euler_rodrigues(e: Any, phi: Any, t: Any, t_dot: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, t, t_dot = prepared(
        "pose_acceleration_euler_rodrigues",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("t", t, (6,)),
        ("t_dot", t_dot, (6,)),
    )
    xp = batch.xp
    half_phi = 0.5 * phi
    cos_half_phi = xp.cos(half_phi)
    sin_half_phi = xp.sin(half_phi)
    t1 = e[0] * sin_half_phi
    t2 = e[1] * sin_half_phi
    t3 = e[2] * sin_half_phi
    t4 = 0.25 * (t[0] * t[0] + t[1] * t[1] + t[2] * t[2])
    t5 = sin_half_phi * t4
    s_ddot = batch.array(
        (7,),
        0.5 * (t_dot[0] * cos_half_phi - (t_dot[2] * t2 - t_dot[1] * t3)) - e[0] * t5,
        0.5 * (t_dot[1] * cos_half_phi - (t_dot[0] * t3 - t_dot[2] * t1)) - e[1] * t5,
        0.5 * (t_dot[2] * cos_half_phi - (t_dot[1] * t1 - t_dot[0] * t2)) - e[2] * t5,
        -(0.5 * (t_dot[0] * t1 + t_dot[1] * t2 + t_dot[2] * t3) + cos_half_phi * t4),
        t_dot[3],
        t_dot[4],
        t_dot[5],
    )
    return delivered(out, s_ddot)


def twist_rate_from_pose_natural(e: Any, phi: Any, s_dot: Any, s_ddot: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, s_dot, s_ddot = prepared(
        "twist_rate_from_pose_natural",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("s_dot", s_dot, (7,)),
        ("s_ddot", s_ddot, (7,)),
    )
    xp = batch.xp
    sin_phi = xp.sin(phi)
    cos_phi = xp.cos(phi)
    t1 = 1.0 - cos_phi
    t2 = s_ddot[0] * sin_phi + t1 * (e[1] * s_ddot[2] - e[2] * s_ddot[1])
    t3 = s_ddot[1] * sin_phi + t1 * (e[2] * s_ddot[0] - e[0] * s_ddot[2])
    t4 = s_ddot[2] * sin_phi + t1 * (e[0] * s_ddot[1] - e[1] * s_ddot[0])
    t5 = s_dot[3] * (1.0 + cos_phi)
    t6 = s_dot[3] * sin_phi
    t7 = s_dot[0] * t5 + (e[1] * s_dot[2] - e[2] * s_dot[1]) * t6
    t8 = s_dot[1] * t5 + (e[2] * s_dot[0] - e[0] * s_dot[2]) * t6
    t9 = s_dot[2] * t5 + (e[0] * s_dot[1] - e[1] * s_dot[0]) * t6
    t_dot = batch.array(
        (6,),
        t2 + e[0] * s_ddot[3] + t7,
        t3 + e[1] * s_ddot[3] + t8,
        t4 + e[2] * s_ddot[3] + t9,
        s_ddot[4],
        s_ddot[5],
        s_ddot[6],
    )
    return delivered(out, t_dot)


def twist_rate_from_pose_linear(e: Any, phi: Any, s_dot: Any, s_ddot: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, s_dot, s_ddot = prepared(
        "twist_rate_from_pose_linear",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("s_dot", s_dot, (7,)),
        ("s_ddot", s_ddot, (7,)),
    )
    xp = batch.xp
    half_phi = 0.5 * phi
    cos_half_phi = xp.cos(half_phi)
    t1 = xp.where(cos_half_phi == 0.0, batch.number(0.0), xp.sin(half_phi))
    t2 = t1 / cos_half_phi
    t3 = e[0] * t2
    t4 = e[1] * t2
    t5 = e[2] * t2
    t6 = 2.0 * (cos_half_phi * cos_half_phi)
    t7 = xp.where(t6 == 0.0, batch.number(0.0), s_dot[3]) / t6
    t8 = (s_dot[0] - s_dot[1] * t5 + s_dot[2] * t4 - s_dot[3] * t3) * t7
    t9 = (s_dot[1] + s_dot[0] * t5 - s_dot[2] * t3 - s_dot[3] * t4) * t7
    t10 = (s_dot[2] + (s_dot[1] * t3 - s_dot[0] * t4) - s_dot[3] * t5) * t7
    t_dot = batch.array(
        (6,),
        s_ddot[0] - s_ddot[1] * t5 + s_ddot[2] * t4 - s_ddot[3] * t3 - t8,
        s_ddot[1] + s_ddot[0] * t5 - s_ddot[2] * t3 - s_ddot[3] * t4 - t9,
        s_ddot[2] + (s_ddot[1] * t3 - s_ddot[0] * t4) - s_ddot[3] * t5 - t10,
        s_ddot[4],
        s_ddot[5],
        s_ddot[6],
    )
    return delivered(out, t_dot)


def twist_rate_from_pose_euler_rodrigues(e: Any, phi: Any, s_dot: Any, s_ddot: Any, /, *, out: Any = None) -> Any:
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
    batch, e, phi, s_dot, s_ddot = prepared(
        "twist_rate_from_pose_euler_rodrigues",
        ("e", e, (3,)),
        ("phi", phi, ()),
        ("s_dot", s_dot, (7,)),
        ("s_ddot", s_ddot, (7,)),
    )
    xp = batch.xp
    half_phi = 0.5 * phi
    t1 = 2.0 * xp.cos(half_phi)
    t2 = 2.0 * xp.sin(half_phi)
    t3 = e[0] * t2
    t4 = e[1] * t2
    t5 = e[2] * t2
    t_dot = batch.array(
        (6,),
        s_ddot[0] * t1 - s_ddot[1] * t5 + s_ddot[2] * t4 - s_ddot[3] * t3,
        s_ddot[0] * t5 + s_ddot[1] * t1 - s_ddot[2] * t3 - s_ddot[3] * t4,
        s_ddot[1] * t3 - s_ddot[0] * t4 + s_ddot[2] * t1 - s_ddot[3] * t5,
        s_ddot[4],
        s_ddot[5],
        s_ddot[6],
    )
    return delivered(out, t_dot)


def moving_frame_velocity(o_dot: Any, Q: Any, omega: Any, rho: Any, rho_dot: Any, /, *, out: Any = None) -> Any:
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
    batch, o_dot, Q, omega, rho, rho_dot = prepared(
        "moving_frame_velocity",
        ("o_dot", o_dot, (3,)),
        ("Q", Q, (3, 3)),
        ("omega", omega, (3,)),
        ("rho", rho, (3,)),
        ("rho_dot", rho_dot, (3,)),
    )
    t1 = Q[0][0] * rho[0] + Q[0][1] * rho[1] + Q[0][2] * rho[2]
    t2 = Q[1][0] * rho[0] + Q[1][1] * rho[1] + Q[1][2] * rho[2]
    t3 = Q[2][0] * rho[0] + Q[2][1] * rho[1] + Q[2][2] * rho[2]
    t4 = Q[0][0] * rho_dot[0] + Q[0][1] * rho_dot[1] + Q[0][2] * rho_dot[2]
    t5 = Q[1][0] * rho_dot[0] + Q[1][1] * rho_dot[1] + Q[1][2] * rho_dot[2]
    t6 = Q[2][0] * rho_dot[0] + Q[2][1] * rho_dot[1] + Q[2][2] * rho_dot[2]
    p_dot = batch.array(
        (3,),
        o_dot[0] + (omega[1] * t3 - omega[2] * t2) + t4,
        o_dot[1] + (omega[2] * t1 - omega[0] * t3) + t5,
        o_dot[2] + (omega[0] * t2 - omega[1] * t1) + t6,
    )
    return delivered(out, p_dot)


def moving_frame_acceleration(o_ddot: Any, Q: Any, omega: Any, omega_dot: Any, rho: Any, rho_dot: Any, rho_ddot: Any, /, *, out: Any = None) -> Any:
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
    batch, o_ddot, Q, omega, omega_dot, rho, rho_dot, rho_ddot = prepared(
        "moving_frame_acceleration",
        ("o_ddot", o_ddot, (3,)),
        ("Q", Q, (3, 3)),
        ("omega", omega, (3,)),
        ("omega_dot", omega_dot, (3,)),
        ("rho", rho, (3,)),
        ("rho_dot", rho_dot, (3,)),
        ("rho_ddot", rho_ddot, (3,)),
    )
    t1 = Q[0][0] * rho[0] + Q[0][1] * rho[1] + Q[0][2] * rho[2]
    t2 = Q[1][0] * rho[0] + Q[1][1] * rho[1] + Q[1][2] * rho[2]
    t3 = Q[2][0] * rho[0] + Q[2][1] * rho[1] + Q[2][2] * rho[2]
    t4 = 2.0 * (Q[0][0] * rho_dot[0] + Q[0][1] * rho_dot[1] + Q[0][2] * rho_dot[2])
    t5 = omega[1] * t3 - omega[2] * t2 + t4
    t6 = 2.0 * (Q[1][0] * rho_dot[0] + Q[1][1] * rho_dot[1] + Q[1][2] * rho_dot[2])
    t7 = omega[2] * t1 - omega[0] * t3 + t6
    t8 = 2.0 * (Q[2][0] * rho_dot[0] + Q[2][1] * rho_dot[1] + Q[2][2] * rho_dot[2])
    t9 = omega[0] * t2 - omega[1] * t1 + t8
    t10 = o_ddot[0] + (omega_dot[1] * t3 - omega_dot[2] * t2)
    t11 = o_ddot[1] + (omega_dot[2] * t1 - omega_dot[0] * t3)
    t12 = o_ddot[2] + (omega_dot[0] * t2 - omega_dot[1] * t1)
    t13 = Q[0][0] * rho_ddot[0] + Q[0][1] * rho_ddot[1] + Q[0][2] * rho_ddot[2]
    t14 = Q[1][0] * rho_ddot[0] + Q[1][1] * rho_ddot[1] + Q[1][2] * rho_ddot[2]
    t15 = Q[2][0] * rho_ddot[0] + Q[2][1] * rho_ddot[1] + Q[2][2] * rho_ddot[2]
    p_ddot = batch.array(
        (3,),
        t10 + (omega[1] * t9 - omega[2] * t7) + t13,
        t11 + (omega[2] * t5 - omega[0] * t9) + t14,
        t12 + (omega[0] * t7 - omega[1] * t5) + t15,
    )
    return delivered(out, p_ddot)


def wrench_axis(f: Any, n_A: Any, a: Any, /, *, out: Any = None) -> Any:
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
    batch, f, n_A, a = prepared("wrench_axis", ("f", f, (3,)), ("n_A", n_A, (3,)), ("a", a, (3,)))
    xp = batch.xp
    t1 = xp.where(f[0] < 0.0, -f[0], f[0])
    t2 = xp.where(f[1] < 0.0, -f[1], f[1])
    t3 = xp.where(t1 < t2, t2, t1)
    t4 = xp.where(f[2] < 0.0, -f[2], f[2])
    t5 = xp.where(t3 < t4, t4, t3)
    t6 = xp.where(0.0 == t5, batch.number(1.0), t5)
    t7 = f[0] / t6
    t8 = f[1] / t6
    t9 = f[2] / t6
    t10 = t7 * t7 + t8 * t8 + t9 * t9
    t11 = xp.sqrt(t10)
    t12 = t10 == 0.0
    t13 = xp.where(t12, batch.number(0.0), t7) / t11
    t14 = xp.where(t12, batch.number(0.0), t8) / t11
    t15 = xp.where(t12, batch.number(0.0), t9) / t11
    t16 = xp.where(t12, batch.number(0.0), n_A[0]) / t11
    t17 = xp.where(t12, batch.number(0.0), n_A[1]) / t11
    t18 = xp.where(t12, batch.number(0.0), n_A[2]) / t11
    t19 = a[0] + (t14 * t18 - t15 * t17) / t6
    t20 = a[1] + (t15 * t16 - t13 * t18) / t6
    t21 = a[2] + (t13 * t17 - t14 * t16) / t6
    axis = batch.array(
        (6,),
        t13,
        t14,
        t15,
        t15 * t20 - t14 * t21,
        t13 * t21 - t15 * t19,
        t14 * t19 - t13 * t20,
    )
    pitch = batch.array((), (t13 * t16 + t14 * t17 + t15 * t18) / t6)
    return delivered(out, axis, pitch)


def power(t: Any, w: Any, /, *, out: Any = None) -> Any:
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
    batch, t, w = prepared("power", ("t", t, (6,)), ("w", w, (6,)))
    t1 = t[0] * w[0] + t[1] * w[1] + t[2] * w[2] + t[3] * w[3] + t[4] * w[4]
    Pi = batch.array((), t1 + t[5] * w[5])
    return delivered(out, Pi)


def reciprocal_product(s_w: Any, s_t: Any, /, *, out: Any = None) -> Any:
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
    batch, s_w, s_t = prepared("reciprocal_product", ("s_w", s_w, (6,)), ("s_t", s_t, (6,)))
    t1 = s_w[0] * s_t[3] + s_w[1] * s_t[4] + s_w[2] * s_t[5] + s_w[3] * s_t[0]
    product = batch.array((), t1 + s_w[4] * s_t[1] + s_w[5] * s_t[2])
    return delivered(out, product)


def wrench_transfer(w_A: Any, a: Any, p: Any, /, *, out: Any = None) -> Any:
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
    batch, w_A, a, p = prepared("wrench_transfer", ("w_A", w_A, (6,)), ("a", a, (3,)), ("p", p, (3,)))
    t1 = a[0] - p[0]
    t2 = a[1] - p[1]
    t3 = a[2] - p[2]
    w_P = batch.array(
        (6,),
        w_A[0] + (w_A[5] * t2 - w_A[4] * t3),
        w_A[1] + (w_A[3] * t3 - w_A[5] * t1),
        w_A[2] + (w_A[4] * t1 - w_A[3] * t2),
        w_A[3],
        w_A[4],
        w_A[5],
    )
    return delivered(out, w_P)


def inertia_about_point(I_C: Any, m: Any, c: Any, a: Any, /, *, out: Any = None) -> Any:
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
    batch, I_C, m, c, a = prepared(
        "inertia_about_point",
        ("I_C", I_C, (3, 3)),
        ("m", m, ()),
        ("c", c, (3,)),
        ("a", a, (3,)),
    )
    t1 = a[0] - c[0]
    t2 = a[1] - c[1]
    t3 = a[2] - c[2]
    t4 = m * t2
    t5 = m * t3
    t6 = t1 * (m * t1)
    t7 = t1 * t4
    t8 = t1 * t5
    t9 = t2 * t4
    t10 = t2 * t5
    t11 = t3 * t5
    I_A = batch.array(
        (3, 3),
        I_C[0][0] + (t9 + t11),
        I_C[0][1] - t7,
        I_C[0][2] - t8,
        I_C[1][0] - t7,
        I_C[1][1] + (t6 + t11),
        I_C[1][2] - t10,
        I_C[2][0] - t8,
        I_C[2][1] - t10,
        I_C[2][2] + (t6 + t9),
    )
    return delivered(out, I_A)


def inertia_about_point_sym6(I_C: Any, m: Any, c: Any, a: Any, /, *, out: Any = None) -> Any:
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
    batch, I_C, m, c, a = prepared(
        "inertia_about_point_sym6",
        ("I_C", I_C, (6,)),
        ("m", m, ()),
        ("c", c, (3,)),
        ("a", a, (3,)),
    )
    t1 = a[0] - c[0]
    t2 = a[1] - c[1]
    t3 = a[2] - c[2]
    t4 = m * t2
    t5 = m * t3
    t6 = t1 * (m * t1)
    t7 = t2 * t4
    t8 = t3 * t5
    I_A = batch.array(
        (6,),
        I_C[0] + (t7 + t8),
        I_C[1] - t1 * t4,
        I_C[2] - t1 * t5,
        I_C[3] + (t6 + t8),
        I_C[4] - t2 * t5,
        I_C[5] + (t6 + t7),
    )
    return delivered(out, I_A)


def momentum_screw(I_C: Any, m: Any, t: Any, /, *, out: Any = None) -> Any:
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
    batch, I_C, m, t = prepared("momentum_screw", ("I_C", I_C, (3, 3)), ("m", m, ()), ("t", t, (6,)))
    mu = batch.array(
        (6,),
        I_C[0][0] * t[0] + I_C[0][1] * t[1] + I_C[0][2] * t[2],
        I_C[1][0] * t[0] + I_C[1][1] * t[1] + I_C[1][2] * t[2],
        I_C[2][0] * t[0] + I_C[2][1] * t[1] + I_C[2][2] * t[2],
        m * t[3],
        m * t[4],
        m * t[5],
    )
    return delivered(out, mu)


def momentum_screw_sym6(I_C: Any, m: Any, t: Any, /, *, out: Any = None) -> Any:
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
    batch, I_C, m, t = prepared("momentum_screw_sym6", ("I_C", I_C, (6,)), ("m", m, ()), ("t", t, (6,)))
    mu = batch.array(
        (6,),
        I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2],
        I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2],
        I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2],
        m * t[3],
        m * t[4],
        m * t[5],
    )
    return delivered(out, mu)


def kinetic_energy(I_C: Any, m: Any, t: Any, /, *, out: Any = None) -> Any:
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
    batch, I_C, m, t = prepared("kinetic_energy", ("I_C", I_C, (3, 3)), ("m", m, ()), ("t", t, (6,)))
    t1 = (I_C[0][0] * t[0] + I_C[0][1] * t[1] + I_C[0][2] * t[2]) * (0.5 * t[0])
    t2 = t1 + (I_C[1][0] * t[0] + I_C[1][1] * t[1] + I_C[1][2] * t[2]) * (0.5 * t[1])
    t3 = t2 + (I_C[2][0] * t[0] + I_C[2][1] * t[1] + I_C[2][2] * t[2]) * (0.5 * t[2])
    T = batch.array(
        (),
        t3 + m * t[3] * (0.5 * t[3]) + m * t[4] * (0.5 * t[4]) + m * t[5] * (0.5 * t[5]),
    )
    return delivered(out, T)


def kinetic_energy_sym6(I_C: Any, m: Any, t: Any, /, *, out: Any = None) -> Any:
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
    batch, I_C, m, t = prepared("kinetic_energy_sym6", ("I_C", I_C, (6,)), ("m", m, ()), ("t", t, (6,)))
    t1 = (I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]) * (0.5 * t[0])
    t2 = t1 + (I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2]) * (0.5 * t[1])
    t3 = t2 + (I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]) * (0.5 * t[2])
    T = batch.array(
        (),
        t3 + m * t[3] * (0.5 * t[3]) + m * t[4] * (0.5 * t[4]) + m * t[5] * (0.5 * t[5]),
    )
    return delivered(out, T)


def newton_euler_wrench(I_C: Any, m: Any, t: Any, t_dot: Any, /, *, out: Any = None) -> Any:
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
    batch, I_C, m, t, t_dot = prepared(
        "newton_euler_wrench",
        ("I_C", I_C, (3, 3)),
        ("m", m, ()),
        ("t", t, (6,)),
        ("t_dot", t_dot, (6,)),
    )
    t1 = I_C[0][0] * t[0] + I_C[0][1] * t[1] + I_C[0][2] * t[2]
    t2 = I_C[1][0] * t[0] + I_C[1][1] * t[1] + I_C[1][2] * t[2]
    t3 = I_C[2][0] * t[0] + I_C[2][1] * t[1] + I_C[2][2] * t[2]
    t4 = I_C[0][0] * t_dot[0] + I_C[0][1] * t_dot[1] + I_C[0][2] * t_dot[2]
    t5 = I_C[1][0] * t_dot[0] + I_C[1][1] * t_dot[1] + I_C[1][2] * t_dot[2]
    t6 = I_C[2][0] * t_dot[0] + I_C[2][1] * t_dot[1] + I_C[2][2] * t_dot[2]
    w = batch.array(
        (6,),
        t4 + (t[1] * t3 - t[2] * t2),
        t5 + (t[2] * t1 - t[0] * t3),
        t6 + (t[0] * t2 - t[1] * t1),
        m * t_dot[3],
        m * t_dot[4],
        m * t_dot[5],
    )
    return delivered(out, w)


def newton_euler_wrench_sym6(I_C: Any, m: Any, t: Any, t_dot: Any, /, *, out: Any = None) -> Any:
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
    batch, I_C, m, t, t_dot = prepared(
        "newton_euler_wrench_sym6",
        ("I_C", I_C, (6,)),
        ("m", m, ()),
        ("t", t, (6,)),
        ("t_dot", t_dot, (6,)),
    )
    t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]
    t2 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2]
    t3 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]
    t4 = I_C[0] * t_dot[0] + I_C[1] * t_dot[1] + I_C[2] * t_dot[2]
    t5 = I_C[1] * t_dot[0] + I_C[3] * t_dot[1] + I_C[4] * t_dot[2]
    t6 = I_C[2] * t_dot[0] + I_C[4] * t_dot[1] + I_C[5] * t_dot[2]
    w = batch.array(
        (6,),
        t4 + (t[1] * t3 - t[2] * t2),
        t5 + (t[2] * t1 - t[0] * t3),
        t6 + (t[0] * t2 - t[1] * t1),
        m * t_dot[3],
        m * t_dot[4],
        m * t_dot[5],
    )
    return delivered(out, w)


def newton_euler_twist_rate(I_C: Any, m: Any, t: Any, w: Any, /, *, out: Any = None) -> Any:
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
    batch, I_C, m, t, w = prepared(
        "newton_euler_twist_rate",
        ("I_C", I_C, (3, 3)),
        ("m", m, ()),
        ("t", t, (6,)),
        ("w", w, (6,)),
    )
    xp = batch.xp
    t1 = xp.where(I_C[0][0] < 0.0, -I_C[0][0], I_C[0][0])
    t2 = xp.where(I_C[0][1] < 0.0, -I_C[0][1], I_C[0][1])
    t3 = xp.where(t1 < t2, t2, t1)
    t4 = xp.where(I_C[0][2] < 0.0, -I_C[0][2], I_C[0][2])
    t5 = xp.where(t3 < t4, t4, t3)
    t6 = xp.where(I_C[1][0] < 0.0, -I_C[1][0], I_C[1][0])
    t7 = xp.where(t5 < t6, t6, t5)
    t8 = xp.where(I_C[1][1] < 0.0, -I_C[1][1], I_C[1][1])
    t9 = xp.where(t7 < t8, t8, t7)
    t10 = xp.where(I_C[1][2] < 0.0, -I_C[1][2], I_C[1][2])
    t11 = xp.where(t9 < t10, t10, t9)
    t12 = xp.where(I_C[2][0] < 0.0, -I_C[2][0], I_C[2][0])
    t13 = xp.where(t11 < t12, t12, t11)
    t14 = xp.where(I_C[2][1] < 0.0, -I_C[2][1], I_C[2][1])
    t15 = xp.where(t13 < t14, t14, t13)
    t16 = xp.where(I_C[2][2] < 0.0, -I_C[2][2], I_C[2][2])
    t17 = xp.where(t15 < t16, t16, t15)
    t18 = xp.where(0.0 == t17, batch.number(1.0), t17)
    t19 = I_C[0][0] / t18
    t20 = I_C[0][1] / t18
    t21 = I_C[0][2] / t18
    t22 = I_C[1][0] / t18
    t23 = I_C[1][1] / t18
    t24 = I_C[1][2] / t18
    t25 = I_C[2][0] / t18
    t26 = I_C[2][1] / t18
    t27 = I_C[2][2] / t18
    t28 = I_C[0][0] * t[0] + I_C[0][1] * t[1] + I_C[0][2] * t[2]
    t29 = I_C[1][0] * t[0] + I_C[1][1] * t[1] + I_C[1][2] * t[2]
    t30 = I_C[2][0] * t[0] + I_C[2][1] * t[1] + I_C[2][2] * t[2]
    t31 = w[0] - (t[1] * t30 - t[2] * t29)
    t32 = w[1] - (t[2] * t28 - t[0] * t30)
    t33 = w[2] - (t[0] * t29 - t[1] * t28)
    t34 = t23 * t27 - t24 * t26
    t35 = t24 * t25 - t22 * t27
    t36 = t22 * t26 - t23 * t25
    t37 = I_C[0][0] * (I_C[1][1] * I_C[2][2] - I_C[1][2] * I_C[2][1])
    t38 = t37 + I_C[0][1] * (I_C[1][2] * I_C[2][0] - I_C[1][0] * I_C[2][2])
    t39 = 0.0 == t38 + I_C[0][2] * (I_C[1][0] * I_C[2][1] - I_C[1][1] * I_C[2][0])
    t40 = xp.where(t39, batch.number(0.0), t19 * t34 + t20 * t35 + t21 * t36)
    t41 = xp.where(t40 == 0.0, batch.number(0.0), batch.number(1.0)) / t40
    t42 = t31 * t34 + t32 * (t21 * t26 - t20 * t27) + t33 * (t20 * t24 - t21 * t23)
    t43 = t31 * t35 + t32 * (t19 * t27 - t21 * t25) + t33 * (t21 * t22 - t19 * t24)
    t44 = t31 * t36 + t32 * (t20 * t25 - t19 * t26) + t33 * (t19 * t23 - t20 * t22)
    t45 = xp.where(m == 0.0, batch.number(0.0), batch.number(1.0)) / m
    t_dot = batch.array(
        (6,),
        t41 * t42 / t18,
        t41 * t43 / t18,
        t41 * t44 / t18,
        w[3] * t45,
        w[4] * t45,
        w[5] * t45,
    )
    return delivered(out, t_dot)


def newton_euler_twist_rate_sym6(I_C: Any, m: Any, t: Any, w: Any, /, *, out: Any = None) -> Any:
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
    batch, I_C, m, t, w = prepared(
        "newton_euler_twist_rate_sym6",
        ("I_C", I_C, (6,)),
        ("m", m, ()),
        ("t", t, (6,)),
        ("w", w, (6,)),
    )
    xp = batch.xp
    t1 = xp.where(I_C[0] < 0.0, -I_C[0], I_C[0])
    t2 = xp.where(I_C[1] < 0.0, -I_C[1], I_C[1])
    t3 = xp.where(t1 < t2, t2, t1)
    t4 = xp.where(I_C[2] < 0.0, -I_C[2], I_C[2])
    t5 = xp.where(t3 < t4, t4, t3)
    t6 = xp.where(I_C[3] < 0.0, -I_C[3], I_C[3])
    t7 = xp.where(t5 < t6, t6, t5)
    t8 = xp.where(I_C[4] < 0.0, -I_C[4], I_C[4])
    t9 = xp.where(t7 < t8, t8, t7)
    t10 = xp.where(I_C[5] < 0.0, -I_C[5], I_C[5])
    t11 = xp.where(t9 < t10, t10, t9)
    t12 = xp.where(0.0 == t11, batch.number(1.0), t11)
    t13 = I_C[0] / t12
    t14 = I_C[1] / t12
    t15 = I_C[2] / t12
    t16 = I_C[3] / t12
    t17 = I_C[4] / t12
    t18 = I_C[5] / t12
    t19 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]
    t20 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2]
    t21 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]
    t22 = w[0] - (t[1] * t21 - t[2] * t20)
    t23 = w[1] - (t[2] * t19 - t[0] * t21)
    t24 = w[2] - (t[0] * t20 - t[1] * t19)
    t25 = t16 * t18 - t17 * t17
    t26 = t15 * t17 - t14 * t18
    t27 = t14 * t17 - t15 * t16
    t28 = t14 * t15 - t13 * t17
    t29 = I_C[0] * (I_C[3] * I_C[5] - I_C[4] * I_C[4])
    t30 = t29 + I_C[1] * (I_C[2] * I_C[4] - I_C[1] * I_C[5])
    t31 = 0.0 == t30 + I_C[2] * (I_C[1] * I_C[4] - I_C[2] * I_C[3])
    t32 = xp.where(t31, batch.number(0.0), t13 * t25 + t14 * t26 + t15 * t27)
    t33 = xp.where(t32 == 0.0, batch.number(0.0), batch.number(1.0)) / t32
    t34 = xp.where(m == 0.0, batch.number(0.0), batch.number(1.0)) / m
    t_dot = batch.array(
        (6,),
        t33 * (t22 * t25 + t23 * t26 + t24 * t27) / t12,
        t33 * (t22 * t26 + t23 * (t13 * t18 - t15 * t15) + t24 * t28) / t12,
        t33 * (t22 * t27 + t23 * t28 + t24 * (t13 * t16 - t14 * t14)) / t12,
        w[3] * t34,
        w[4] * t34,
        w[5] * t34,
    )
    return delivered(out, t_dot)


def inertia_dyad(I_C: Any, m: Any, c: Any, a: Any, /, *, out: Any = None) -> Any:
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
    batch, I_C, m, c, a = prepared(
        "inertia_dyad",
        ("I_C", I_C, (3, 3)),
        ("m", m, ()),
        ("c", c, (3,)),
        ("a", a, (3,)),
    )
    t1 = a[0] - c[0]
    t2 = a[1] - c[1]
    t3 = a[2] - c[2]
    t4 = m * t1
    t5 = m * t2
    t6 = m * t3
    t7 = t1 * t4
    t8 = t1 * t5
    t9 = t1 * t6
    t10 = t2 * t5
    t11 = t2 * t6
    t12 = t3 * t6
    M_A = batch.array(
        (6, 6),
        I_C[0][0] + (t10 + t12),
        I_C[0][1] - t8,
        I_C[0][2] - t9,
        0.0,
        t6,
        -t5,
        I_C[1][0] - t8,
        I_C[1][1] + (t7 + t12),
        I_C[1][2] - t11,
        -t6,
        0.0,
        t4,
        I_C[2][0] - t9,
        I_C[2][1] - t11,
        I_C[2][2] + (t7 + t10),
        t5,
        -t4,
        0.0,
        0.0,
        -t6,
        t5,
        m,
        0.0,
        0.0,
        t6,
        0.0,
        -t4,
        0.0,
        m,
        0.0,
        -t5,
        t4,
        0.0,
        0.0,
        0.0,
        m,
    )
    return delivered(out, M_A)


def inertia_dyad_sym6(I_C: Any, m: Any, c: Any, a: Any, /, *, out: Any = None) -> Any:
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
    batch, I_C, m, c, a = prepared(
        "inertia_dyad_sym6",
        ("I_C", I_C, (6,)),
        ("m", m, ()),
        ("c", c, (3,)),
        ("a", a, (3,)),
    )
    t1 = a[0] - c[0]
    t2 = a[1] - c[1]
    t3 = a[2] - c[2]
    t4 = m * t1
    t5 = m * t2
    t6 = m * t3
    t7 = t1 * t4
    t8 = t2 * t5
    t9 = t3 * t6
    t10 = I_C[1] - t1 * t5
    t11 = I_C[2] - t1 * t6
    t12 = I_C[4] - t2 * t6
    M_A = batch.array(
        (6, 6),
        I_C[0] + (t8 + t9),
        t10,
        t11,
        0.0,
        t6,
        -t5,
        t10,
        I_C[3] + (t7 + t9),
        t12,
        -t6,
        0.0,
        t4,
        t11,
        t12,
        I_C[5] + (t7 + t8),
        t5,
        -t4,
        0.0,
        0.0,
        -t6,
        t5,
        m,
        0.0,
        0.0,
        t6,
        0.0,
        -t4,
        0.0,
        m,
        0.0,
        -t5,
        t4,
        0.0,
        0.0,
        0.0,
        m,
    )
    return delivered(out, M_A)


def rotation_from_euler_xyx(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("rotation_from_euler_xyx", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.sin(angles[1])
    t5 = t2 * t3
    t6 = t1 * t3
    t7 = xp.cos(angles[2])
    t8 = xp.sin(angles[2])
    Q = batch.array(
        (3, 3),
        t3,
        t4 * t8,
        t4 * t7,
        t2 * t4,
        t1 * t7 - t5 * t8,
        -(t1 * t8 + t5 * t7),
        -(t1 * t4),
        t2 * t7 + t6 * t8,
        t6 * t7 - t2 * t8,
    )
    return delivered(out, Q)


def euler_rate_matrix_xyx(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_xyx", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.sin(angles[1])
    W = batch.array((3, 3), 1.0, 0.0, xp.cos(angles[1]), 0.0, t1, t2 * t3, 0.0, t2, -(t1 * t3))
    return delivered(out, W)


def euler_rate_matrix_body_xyx(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_body_xyx", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.sin(angles[1])
    t2 = xp.cos(angles[2])
    t3 = xp.sin(angles[2])
    W_body = batch.array((3, 3), xp.cos(angles[1]), 0.0, 1.0, t1 * t3, t2, 0.0, t1 * t2, -t3, 0.0)
    return delivered(out, W_body)


def euler_rates_xyx(angles: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, angles, omega = prepared("euler_rates_xyx", ("angles", angles, (3,)), ("omega", omega, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.sin(angles[1])
    t4 = xp.where(t3 == 0.0, batch.number(0.0), omega[1] * t2 - omega[2] * t1) / t3
    theta_dot = batch.array((3,), omega[0] - xp.cos(angles[1]) * t4, omega[1] * t1 + omega[2] * t2, t4)
    return delivered(out, theta_dot)


def rotation_from_euler_xyz(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("rotation_from_euler_xyz", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.sin(angles[1])
    t5 = t2 * t4
    t6 = t1 * t4
    t7 = xp.cos(angles[2])
    t8 = xp.sin(angles[2])
    Q = batch.array(
        (3, 3),
        t3 * t7,
        -(t3 * t8),
        t4,
        t5 * t7 + t1 * t8,
        t1 * t7 - t5 * t8,
        -(t2 * t3),
        t2 * t8 - t6 * t7,
        t6 * t8 + t2 * t7,
        t1 * t3,
    )
    return delivered(out, Q)


def euler_rate_matrix_xyz(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_xyz", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    W = batch.array((3, 3), 1.0, 0.0, xp.sin(angles[1]), 0.0, t1, -(t2 * t3), 0.0, t2, t1 * t3)
    return delivered(out, W)


def euler_rate_matrix_body_xyz(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_body_xyz", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[1])
    t2 = xp.cos(angles[2])
    t3 = xp.sin(angles[2])
    W_body = batch.array((3, 3), t1 * t2, t3, 0.0, -(t1 * t3), t2, 0.0, xp.sin(angles[1]), 0.0, 1.0)
    return delivered(out, W_body)


def euler_rates_xyz(angles: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, angles, omega = prepared("euler_rates_xyz", ("angles", angles, (3,)), ("omega", omega, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.where(t3 == 0.0, batch.number(0.0), omega[2] * t1 - omega[1] * t2) / t3
    theta_dot = batch.array((3,), omega[0] - xp.sin(angles[1]) * t4, omega[1] * t1 + omega[2] * t2, t4)
    return delivered(out, theta_dot)


def rotation_from_euler_xzx(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("rotation_from_euler_xzx", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.sin(angles[1])
    t5 = t1 * t3
    t6 = t2 * t3
    t7 = xp.cos(angles[2])
    t8 = xp.sin(angles[2])
    Q = batch.array(
        (3, 3),
        t3,
        -(t4 * t7),
        t4 * t8,
        t1 * t4,
        t5 * t7 - t2 * t8,
        -(t5 * t8 + t2 * t7),
        t2 * t4,
        t6 * t7 + t1 * t8,
        t1 * t7 - t6 * t8,
    )
    return delivered(out, Q)


def euler_rate_matrix_xzx(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_xzx", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.sin(angles[1])
    W = batch.array((3, 3), 1.0, 0.0, xp.cos(angles[1]), 0.0, -t2, t1 * t3, 0.0, t1, t2 * t3)
    return delivered(out, W)


def euler_rate_matrix_body_xzx(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_body_xzx", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.sin(angles[1])
    t2 = xp.cos(angles[2])
    t3 = xp.sin(angles[2])
    W_body = batch.array((3, 3), xp.cos(angles[1]), 0.0, 1.0, -(t1 * t2), t3, 0.0, t1 * t3, t2, 0.0)
    return delivered(out, W_body)


def euler_rates_xzx(angles: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, angles, omega = prepared("euler_rates_xzx", ("angles", angles, (3,)), ("omega", omega, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.sin(angles[1])
    t4 = xp.where(t3 == 0.0, batch.number(0.0), omega[1] * t1 + omega[2] * t2) / t3
    theta_dot = batch.array((3,), omega[0] - xp.cos(angles[1]) * t4, omega[2] * t1 - omega[1] * t2, t4)
    return delivered(out, theta_dot)


def rotation_from_euler_xzy(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("rotation_from_euler_xzy", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.sin(angles[1])
    t5 = t1 * t4
    t6 = t2 * t4
    t7 = xp.cos(angles[2])
    t8 = xp.sin(angles[2])
    Q = batch.array(
        (3, 3),
        t3 * t7,
        -t4,
        t3 * t8,
        t5 * t7 + t2 * t8,
        t1 * t3,
        t5 * t8 - t2 * t7,
        t6 * t7 - t1 * t8,
        t2 * t3,
        t6 * t8 + t1 * t7,
    )
    return delivered(out, Q)


def euler_rate_matrix_xzy(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_xzy", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    W = batch.array((3, 3), 1.0, 0.0, -xp.sin(angles[1]), 0.0, -t2, t1 * t3, 0.0, t1, t2 * t3)
    return delivered(out, W)


def euler_rate_matrix_body_xzy(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_body_xzy", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[1])
    t2 = xp.cos(angles[2])
    t3 = xp.sin(angles[2])
    W_body = batch.array((3, 3), t1 * t2, -t3, 0.0, -xp.sin(angles[1]), 0.0, 1.0, t1 * t3, t2, 0.0)
    return delivered(out, W_body)


def euler_rates_xzy(angles: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, angles, omega = prepared("euler_rates_xzy", ("angles", angles, (3,)), ("omega", omega, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.where(t3 == 0.0, batch.number(0.0), omega[1] * t1 + omega[2] * t2) / t3
    theta_dot = batch.array((3,), omega[0] + xp.sin(angles[1]) * t4, omega[2] * t1 - omega[1] * t2, t4)
    return delivered(out, theta_dot)


def rotation_from_euler_yxy(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("rotation_from_euler_yxy", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.sin(angles[1])
    t5 = t2 * t3
    t6 = t1 * t3
    t7 = xp.cos(angles[2])
    t8 = xp.sin(angles[2])
    Q = batch.array(
        (3, 3),
        t1 * t7 - t5 * t8,
        t2 * t4,
        t1 * t8 + t5 * t7,
        t4 * t8,
        t3,
        -(t4 * t7),
        -(t2 * t7 + t6 * t8),
        t1 * t4,
        t6 * t7 - t2 * t8,
    )
    return delivered(out, Q)


def euler_rate_matrix_yxy(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_yxy", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.sin(angles[1])
    W = batch.array((3, 3), 0.0, t1, t2 * t3, 1.0, 0.0, xp.cos(angles[1]), 0.0, -t2, t1 * t3)
    return delivered(out, W)


def euler_rate_matrix_body_yxy(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_body_yxy", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.sin(angles[1])
    t2 = xp.cos(angles[2])
    t3 = xp.sin(angles[2])
    W_body = batch.array((3, 3), t1 * t3, t2, 0.0, xp.cos(angles[1]), 0.0, 1.0, -(t1 * t2), t3, 0.0)
    return delivered(out, W_body)


def euler_rates_yxy(angles: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, angles, omega = prepared("euler_rates_yxy", ("angles", angles, (3,)), ("omega", omega, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.sin(angles[1])
    t4 = xp.where(t3 == 0.0, batch.number(0.0), omega[0] * t2 + omega[2] * t1) / t3
    theta_dot = batch.array((3,), omega[1] - xp.cos(angles[1]) * t4, omega[0] * t1 - omega[2] * t2, t4)
    return delivered(out, theta_dot)


def rotation_from_euler_yxz(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("rotation_from_euler_yxz", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.sin(angles[1])
    t5 = t2 * t4
    t6 = t1 * t4
    t7 = xp.cos(angles[2])
    t8 = xp.sin(angles[2])
    Q = batch.array(
        (3, 3),
        t1 * t7 + t5 * t8,
        t5 * t7 - t1 * t8,
        t2 * t3,
        t3 * t8,
        t3 * t7,
        -t4,
        t6 * t8 - t2 * t7,
        t2 * t8 + t6 * t7,
        t1 * t3,
    )
    return delivered(out, Q)


def euler_rate_matrix_yxz(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_yxz", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    W = batch.array((3, 3), 0.0, t1, t2 * t3, 1.0, 0.0, -xp.sin(angles[1]), 0.0, -t2, t1 * t3)
    return delivered(out, W)


def euler_rate_matrix_body_yxz(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_body_yxz", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[1])
    t2 = xp.cos(angles[2])
    t3 = xp.sin(angles[2])
    W_body = batch.array((3, 3), t1 * t3, t2, 0.0, t1 * t2, -t3, 0.0, -xp.sin(angles[1]), 0.0, 1.0)
    return delivered(out, W_body)


def euler_rates_yxz(angles: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, angles, omega = prepared("euler_rates_yxz", ("angles", angles, (3,)), ("omega", omega, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.where(t3 == 0.0, batch.number(0.0), omega[0] * t2 + omega[2] * t1) / t3
    theta_dot = batch.array((3,), omega[1] + xp.sin(angles[1]) * t4, omega[0] * t1 - omega[2] * t2, t4)
    return delivered(out, theta_dot)


def rotation_from_euler_yzx(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("rotation_from_euler_yzx", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.sin(angles[1])
    t5 = t1 * t4
    t6 = t2 * t4
    t7 = xp.cos(angles[2])
    t8 = xp.sin(angles[2])
    Q = batch.array(
        (3, 3),
        t1 * t3,
        t2 * t8 - t5 * t7,
        t5 * t8 + t2 * t7,
        t4,
        t3 * t7,
        -(t3 * t8),
        -(t2 * t3),
        t6 * t7 + t1 * t8,
        t1 * t7 - t6 * t8,
    )
    return delivered(out, Q)


def euler_rate_matrix_yzx(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_yzx", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    W = batch.array((3, 3), 0.0, t2, t1 * t3, 1.0, 0.0, xp.sin(angles[1]), 0.0, t1, -(t2 * t3))
    return delivered(out, W)


def euler_rate_matrix_body_yzx(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_body_yzx", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[1])
    t2 = xp.cos(angles[2])
    t3 = xp.sin(angles[2])
    W_body = batch.array((3, 3), xp.sin(angles[1]), 0.0, 1.0, t1 * t2, t3, 0.0, -(t1 * t3), t2, 0.0)
    return delivered(out, W_body)


def euler_rates_yzx(angles: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, angles, omega = prepared("euler_rates_yzx", ("angles", angles, (3,)), ("omega", omega, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.where(t3 == 0.0, batch.number(0.0), omega[0] * t1 - omega[2] * t2) / t3
    theta_dot = batch.array((3,), omega[1] - xp.sin(angles[1]) * t4, omega[0] * t2 + omega[2] * t1, t4)
    return delivered(out, theta_dot)


def rotation_from_euler_yzy(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("rotation_from_euler_yzy", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.sin(angles[1])
    t5 = t1 * t3
    t6 = t2 * t3
    t7 = xp.cos(angles[2])
    t8 = xp.sin(angles[2])
    Q = batch.array(
        (3, 3),
        t5 * t7 - t2 * t8,
        -(t1 * t4),
        t5 * t8 + t2 * t7,
        t4 * t7,
        t3,
        t4 * t8,
        -(t6 * t7 + t1 * t8),
        t2 * t4,
        t1 * t7 - t6 * t8,
    )
    return delivered(out, Q)


def euler_rate_matrix_yzy(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_yzy", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.sin(angles[1])
    W = batch.array((3, 3), 0.0, t2, -(t1 * t3), 1.0, 0.0, xp.cos(angles[1]), 0.0, t1, t2 * t3)
    return delivered(out, W)


def euler_rate_matrix_body_yzy(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_body_yzy", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.sin(angles[1])
    t2 = xp.cos(angles[2])
    t3 = xp.sin(angles[2])
    W_body = batch.array((3, 3), t1 * t2, -t3, 0.0, xp.cos(angles[1]), 0.0, 1.0, t1 * t3, t2, 0.0)
    return delivered(out, W_body)


def euler_rates_yzy(angles: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, angles, omega = prepared("euler_rates_yzy", ("angles", angles, (3,)), ("omega", omega, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.sin(angles[1])
    t4 = xp.where(t3 == 0.0, batch.number(0.0), omega[2] * t2 - omega[0] * t1) / t3
    theta_dot = batch.array((3,), omega[1] - xp.cos(angles[1]) * t4, omega[0] * t2 + omega[2] * t1, t4)
    return delivered(out, theta_dot)


def rotation_from_euler_zxy(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("rotation_from_euler_zxy", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.sin(angles[1])
    t5 = t2 * t4
    t6 = t1 * t4
    t7 = xp.cos(angles[2])
    t8 = xp.sin(angles[2])
    Q = batch.array(
        (3, 3),
        t1 * t7 - t5 * t8,
        -(t2 * t3),
        t1 * t8 + t5 * t7,
        t2 * t7 + t6 * t8,
        t1 * t3,
        t2 * t8 - t6 * t7,
        -(t3 * t8),
        t4,
        t3 * t7,
    )
    return delivered(out, Q)


def euler_rate_matrix_zxy(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_zxy", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    W = batch.array((3, 3), 0.0, t1, -(t2 * t3), 0.0, t2, t1 * t3, 1.0, 0.0, xp.sin(angles[1]))
    return delivered(out, W)


def euler_rate_matrix_body_zxy(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_body_zxy", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[1])
    t2 = xp.cos(angles[2])
    t3 = xp.sin(angles[2])
    W_body = batch.array((3, 3), -(t1 * t3), t2, 0.0, xp.sin(angles[1]), 0.0, 1.0, t1 * t2, t3, 0.0)
    return delivered(out, W_body)


def euler_rates_zxy(angles: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, angles, omega = prepared("euler_rates_zxy", ("angles", angles, (3,)), ("omega", omega, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.where(t3 == 0.0, batch.number(0.0), omega[1] * t1 - omega[0] * t2) / t3
    theta_dot = batch.array((3,), omega[2] - xp.sin(angles[1]) * t4, omega[0] * t1 + omega[1] * t2, t4)
    return delivered(out, theta_dot)


def rotation_from_euler_zxz(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("rotation_from_euler_zxz", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.sin(angles[1])
    t5 = t2 * t3
    t6 = t1 * t3
    t7 = xp.cos(angles[2])
    t8 = xp.sin(angles[2])
    Q = batch.array(
        (3, 3),
        t1 * t7 - t5 * t8,
        -(t1 * t8 + t5 * t7),
        t2 * t4,
        t2 * t7 + t6 * t8,
        t6 * t7 - t2 * t8,
        -(t1 * t4),
        t4 * t8,
        t4 * t7,
        t3,
    )
    return delivered(out, Q)


def euler_rate_matrix_zxz(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_zxz", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.sin(angles[1])
    W = batch.array((3, 3), 0.0, t1, t2 * t3, 0.0, t2, -(t1 * t3), 1.0, 0.0, xp.cos(angles[1]))
    return delivered(out, W)


def euler_rate_matrix_body_zxz(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_body_zxz", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.sin(angles[1])
    t2 = xp.cos(angles[2])
    t3 = xp.sin(angles[2])
    W_body = batch.array((3, 3), t1 * t3, t2, 0.0, t1 * t2, -t3, 0.0, xp.cos(angles[1]), 0.0, 1.0)
    return delivered(out, W_body)


def euler_rates_zxz(angles: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, angles, omega = prepared("euler_rates_zxz", ("angles", angles, (3,)), ("omega", omega, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.sin(angles[1])
    t4 = xp.where(t3 == 0.0, batch.number(0.0), omega[0] * t2 - omega[1] * t1) / t3
    theta_dot = batch.array((3,), omega[2] - xp.cos(angles[1]) * t4, omega[0] * t1 + omega[1] * t2, t4)
    return delivered(out, theta_dot)


def rotation_from_euler_zyx(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("rotation_from_euler_zyx", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.sin(angles[1])
    t5 = t1 * t4
    t6 = t2 * t4
    t7 = xp.cos(angles[2])
    t8 = xp.sin(angles[2])
    Q = batch.array(
        (3, 3),
        t1 * t3,
        t5 * t8 - t2 * t7,
        t2 * t8 + t5 * t7,
        t2 * t3,
        t1 * t7 + t6 * t8,
        t6 * t7 - t1 * t8,
        -t4,
        t3 * t8,
        t3 * t7,
    )
    return delivered(out, Q)


def euler_rate_matrix_zyx(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_zyx", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    W = batch.array((3, 3), 0.0, -t2, t1 * t3, 0.0, t1, t2 * t3, 1.0, 0.0, -xp.sin(angles[1]))
    return delivered(out, W)


def euler_rate_matrix_body_zyx(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_body_zyx", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[1])
    t2 = xp.cos(angles[2])
    t3 = xp.sin(angles[2])
    W_body = batch.array((3, 3), -xp.sin(angles[1]), 0.0, 1.0, t1 * t3, t2, 0.0, t1 * t2, -t3, 0.0)
    return delivered(out, W_body)


def euler_rates_zyx(angles: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, angles, omega = prepared("euler_rates_zyx", ("angles", angles, (3,)), ("omega", omega, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.where(t3 == 0.0, batch.number(0.0), omega[0] * t1 + omega[1] * t2) / t3
    theta_dot = batch.array((3,), omega[2] + xp.sin(angles[1]) * t4, omega[1] * t1 - omega[0] * t2, t4)
    return delivered(out, theta_dot)


def rotation_from_euler_zyz(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("rotation_from_euler_zyz", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.cos(angles[1])
    t4 = xp.sin(angles[1])
    t5 = t1 * t3
    t6 = t2 * t3
    t7 = xp.cos(angles[2])
    t8 = xp.sin(angles[2])
    Q = batch.array(
        (3, 3),
        t5 * t7 - t2 * t8,
        -(t5 * t8 + t2 * t7),
        t1 * t4,
        t6 * t7 + t1 * t8,
        t1 * t7 - t6 * t8,
        t2 * t4,
        -(t4 * t7),
        t4 * t8,
        t3,
    )
    return delivered(out, Q)


def euler_rate_matrix_zyz(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_zyz", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.sin(angles[1])
    W = batch.array((3, 3), 0.0, -t2, t1 * t3, 0.0, t1, t2 * t3, 1.0, 0.0, xp.cos(angles[1]))
    return delivered(out, W)


def euler_rate_matrix_body_zyz(angles: Any, /, *, out: Any = None) -> Any:
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
    batch, angles = prepared("euler_rate_matrix_body_zyz", ("angles", angles, (3,)))
    xp = batch.xp
    t1 = xp.sin(angles[1])
    t2 = xp.cos(angles[2])
    t3 = xp.sin(angles[2])
    W_body = batch.array((3, 3), -(t1 * t2), t3, 0.0, t1 * t3, t2, 0.0, xp.cos(angles[1]), 0.0, 1.0)
    return delivered(out, W_body)


def euler_rates_zyz(angles: Any, omega: Any, /, *, out: Any = None) -> Any:
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
    batch, angles, omega = prepared("euler_rates_zyz", ("angles", angles, (3,)), ("omega", omega, (3,)))
    xp = batch.xp
    t1 = xp.cos(angles[0])
    t2 = xp.sin(angles[0])
    t3 = xp.sin(angles[1])
    t4 = xp.where(t3 == 0.0, batch.number(0.0), omega[0] * t1 + omega[1] * t2) / t3
    theta_dot = batch.array((3,), omega[2] - xp.cos(angles[1]) * t4, omega[1] * t1 - omega[0] * t2, t4)
    return delivered(out, theta_dot)
