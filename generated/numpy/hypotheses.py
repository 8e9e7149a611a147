# SPDX-License-Identifier: BSD-3-Clause
# Emitted by chasles 0.2.0.
"""What each kernel takes, and what must hold of it. Made by `chasles emit`; not to be edited.

KERNELS holds, by the kernel's name, its inputs (name, core shape) and its demands: a kind of hypothesis, its text, the
names of the inputs that it is about, and for "nonzero" the function of these inputs that is zero where it is broken.
"""

from __future__ import annotations

from typing import Any

from .batches import prepared

__all__ = ("KERNELS",)


def divisor_1(phi: Any) -> Any:
    """It vanishes where this is broken: phi != 0."""
    batch, phi = prepared("divisor_1", ("phi", phi, ()))
    return batch.array((), phi)


def divisor_2(phi: Any) -> Any:
    """It vanishes where this is broken: phi != 0."""
    batch, phi = prepared("divisor_2", ("phi", phi, ()))
    xp = batch.xp
    t1 = xp.sin(0.5 * phi)
    return batch.array((), 2.0 * (t1 * t1))


def divisor_3(p_1: Any, p_2: Any) -> Any:
    """It vanishes where this is broken: p_1 != p_2."""
    batch, p_1, p_2 = prepared("divisor_3", ("p_1", p_1, (3,)), ("p_2", p_2, (3,)))
    xp = batch.xp
    t1 = p_2[0] - p_1[0]
    t2 = p_2[1] - p_1[1]
    t3 = p_2[2] - p_1[2]
    return batch.array((), xp.sqrt(t1 * t1 + t2 * t2 + t3 * t3))


def divisor_4(omega: Any) -> Any:
    """It vanishes where this is broken: omega != 0."""
    batch, omega = prepared("divisor_4", ("omega", omega, (3,)))
    xp = batch.xp
    return batch.array((), xp.sqrt(omega[0] * omega[0] + omega[1] * omega[1] + omega[2] * omega[2]))


def divisor_5(q_0: Any) -> Any:
    """It vanishes where this is broken: 1 + q_0 != 0."""
    batch, q_0 = prepared("divisor_5", ("q_0", q_0, ()))
    return batch.array((), 1.0 + q_0)


def divisor_6(Q: Any) -> Any:
    """It vanishes where this is broken: phi != 0."""
    batch, Q = prepared("divisor_6", ("Q", Q, (3, 3)))
    return batch.array((), 3.0 - (Q[2][2] + (Q[0][0] + Q[1][1])))


def divisor_7(phi: Any) -> Any:
    """It vanishes where this is broken: phi != pi."""
    batch, phi = prepared("divisor_7", ("phi", phi, ()))
    xp = batch.xp
    t1 = xp.cos(0.5 * phi)
    return batch.array((), 2.0 * (t1 * t1))


def divisor_8(f: Any) -> Any:
    """It vanishes where this is broken: f != 0."""
    batch, f = prepared("divisor_8", ("f", f, (3,)))
    xp = batch.xp
    return batch.array((), xp.sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]))


def divisor_9(angles: Any) -> Any:
    """It vanishes where this is broken: sin(theta_2) != 0."""
    batch, angles = prepared("divisor_9", ("angles", angles, (3,)))
    xp = batch.xp
    return batch.array((), xp.sin(angles[1]))


def divisor_10(angles: Any) -> Any:
    """It vanishes where this is broken: cos(theta_2) != 0."""
    batch, angles = prepared("divisor_10", ("angles", angles, (3,)))
    xp = batch.xp
    return batch.array((), xp.cos(angles[1]))


KERNELS: dict[str, tuple[Any, Any]] = {
    "cross_product_matrix": (
        (("v", (3,)),),
        (),
    ),
    "rotation_from_axis_angle": (
        (("e", (3,)), ("phi", ())),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "point_after_displacement": (
        (("Q", (3, 3)), ("a", (3,)), ("a_prime", (3,)), ("p", (3,))),
        (
            ("rotation", "Q is a rotation", ("Q",), None),
        ),
    ),
    "pitch_of_motion": (
        (("e", (3,)), ("phi", ()), ("d_P", (3,))),
        (
            ("nonzero", "phi != 0", ("phi",), divisor_1),
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "normal_matrix_inverse": (
        (("e", (3,)), ("phi", ())),
        (
            ("nonzero", "phi != 0", ("phi",), divisor_2),
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "screw_axis_point": (
        (("e", (3,)), ("phi", ()), ("a", (3,)), ("a_prime", (3,))),
        (
            ("nonzero", "phi != 0", ("phi",), divisor_2),
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "plucker_line": (
        (("p_1", (3,)), ("p_2", (3,))),
        (
            ("nonzero", "p_1 != p_2", ("p_1", "p_2"), divisor_3),
        ),
    ),
    "plucker_transfer": (
        (("kappa_A", (6,)), ("a", (3,)), ("b", (3,))),
        (),
    ),
    "rotation_in_triad_axes": (
        (("triad", (3, 3)), ("triad_prime", (3, 3))),
        (
            ("rotation", "triad is a rotation", ("triad",), None),
            ("rotation", "triad' is a rotation", ("triad_prime",), None),
        ),
    ),
    "rotation_from_triads": (
        (("triad", (3, 3)), ("triad_prime", (3, 3))),
        (
            ("rotation", "triad is a rotation", ("triad",), None),
            ("rotation", "triad' is a rotation", ("triad_prime",), None),
        ),
    ),
    "axial_vector": (
        (("Omega", (3, 3)),),
        (),
    ),
    "velocity_of_point": (
        (("omega", (3,)), ("a_dot", (3,)), ("a", (3,)), ("p", (3,))),
        (),
    ),
    "instant_screw_point": (
        (("omega", (3,)), ("a_dot", (3,)), ("a", (3,))),
        (
            ("nonzero", "omega != 0", ("omega",), divisor_4),
        ),
    ),
    "natural_rate_matrix": (
        (("e", (3,)), ("phi", ())),
        (
            ("unit", "|e| = 1", ("e",), None),
            ("nonzero", "phi != 0", ("phi",), divisor_2),
        ),
    ),
    "linear_rate_matrix": (
        (("e", (3,)), ("phi", ())),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "euler_rodrigues_rate_matrix": (
        (("e", (3,)), ("phi", ())),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "rotation_from_linear_invariants": (
        (("q", (3,)), ("q_0", ())),
        (
            ("unit column", "|[q, q_0]| = 1", ("q", "q_0"), None),
            ("nonzero", "1 + q_0 != 0", ("q_0",), divisor_5),
        ),
    ),
    "rotation_from_euler_rodrigues": (
        (("q", (3,)), ("q_0", ())),
        (
            ("unit column", "|[q, q_0]| = 1", ("q", "q_0"), None),
        ),
    ),
    "linear_invariants": (
        (("Q", (3, 3)),),
        (
            ("rotation", "Q is a rotation", ("Q",), None),
        ),
    ),
    "natural_invariants": (
        (("Q", (3, 3)),),
        (
            ("rotation", "Q is a rotation", ("Q",), None),
            ("nonzero", "phi != 0", ("Q",), divisor_6),
        ),
    ),
    "euler_rodrigues_parameters": (
        (("Q", (3, 3)),),
        (
            ("rotation", "Q is a rotation", ("Q",), None),
        ),
    ),
    "screw_of_motion": (
        (("Q", (3, 3)), ("a", (3,)), ("a_prime", (3,))),
        (
            ("rotation", "Q is a rotation", ("Q",), None),
            ("nonzero", "phi != 0", ("Q",), divisor_6),
        ),
    ),
    "instant_screw": (
        (("omega", (3,)), ("a_dot", (3,)), ("a", (3,))),
        (
            ("nonzero", "omega != 0", ("omega",), divisor_4),
        ),
    ),
    "natural_velocity_matrix": (
        (("e", (3,)), ("phi", ())),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "linear_velocity_matrix": (
        (("e", (3,)), ("phi", ())),
        (
            ("unit", "|e| = 1", ("e",), None),
            ("nonzero", "phi != pi", ("phi",), divisor_7),
        ),
    ),
    "euler_rodrigues_velocity_matrix": (
        (("e", (3,)), ("phi", ())),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "pose_rate_natural": (
        (("e", (3,)), ("phi", ()), ("t", (6,))),
        (
            ("unit", "|e| = 1", ("e",), None),
            ("nonzero", "phi != 0", ("phi",), divisor_2),
        ),
    ),
    "pose_rate_linear": (
        (("e", (3,)), ("phi", ()), ("t", (6,))),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "pose_rate_euler_rodrigues": (
        (("e", (3,)), ("phi", ()), ("t", (6,))),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "twist_from_pose_rate_natural": (
        (("e", (3,)), ("phi", ()), ("s_dot", (7,))),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "twist_from_pose_rate_linear": (
        (("e", (3,)), ("phi", ()), ("s_dot", (7,))),
        (
            ("unit", "|e| = 1", ("e",), None),
            ("nonzero", "phi != pi", ("phi",), divisor_7),
        ),
    ),
    "twist_from_pose_rate_euler_rodrigues": (
        (("e", (3,)), ("phi", ()), ("s_dot", (7,))),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "twist_transfer": (
        (("t_A", (6,)), ("a", (3,)), ("p", (3,))),
        (),
    ),
    "angular_acceleration_matrix": (
        (("omega", (3,)), ("omega_dot", (3,))),
        (),
    ),
    "acceleration_of_point": (
        (("omega", (3,)), ("omega_dot", (3,)), ("a_ddot", (3,)), ("a", (3,)), ("p", (3,))),
        (),
    ),
    "natural_rate_matrix_dot": (
        (("e", (3,)), ("phi", ()), ("omega", (3,))),
        (
            ("unit", "|e| = 1", ("e",), None),
            ("nonzero", "phi != 0", ("phi",), divisor_2),
        ),
    ),
    "linear_rate_matrix_dot": (
        (("e", (3,)), ("phi", ()), ("omega", (3,))),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "euler_rodrigues_rate_matrix_dot": (
        (("e", (3,)), ("phi", ()), ("omega", (3,))),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "natural_velocity_matrix_dot": (
        (("e", (3,)), ("phi", ()), ("omega", (3,))),
        (
            ("nonzero", "phi != 0", ("phi",), divisor_2),
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "linear_velocity_matrix_dot": (
        (("e", (3,)), ("phi", ()), ("omega", (3,))),
        (
            ("unit", "|e| = 1", ("e",), None),
            ("nonzero", "phi != pi", ("phi",), divisor_7),
        ),
    ),
    "euler_rodrigues_velocity_matrix_dot": (
        (("e", (3,)), ("phi", ()), ("omega", (3,))),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "pose_acceleration_natural": (
        (("e", (3,)), ("phi", ()), ("t", (6,)), ("t_dot", (6,))),
        (
            ("unit", "|e| = 1", ("e",), None),
            ("nonzero", "phi != 0", ("phi",), divisor_2),
        ),
    ),
    "pose_acceleration_linear": (
        (("e", (3,)), ("phi", ()), ("t", (6,)), ("t_dot", (6,))),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "pose_acceleration_euler_rodrigues": (
        (("e", (3,)), ("phi", ()), ("t", (6,)), ("t_dot", (6,))),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "twist_rate_from_pose_natural": (
        (("e", (3,)), ("phi", ()), ("s_dot", (7,)), ("s_ddot", (7,))),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "twist_rate_from_pose_linear": (
        (("e", (3,)), ("phi", ()), ("s_dot", (7,)), ("s_ddot", (7,))),
        (
            ("unit", "|e| = 1", ("e",), None),
            ("nonzero", "phi != pi", ("phi",), divisor_7),
        ),
    ),
    "twist_rate_from_pose_euler_rodrigues": (
        (("e", (3,)), ("phi", ()), ("s_dot", (7,)), ("s_ddot", (7,))),
        (
            ("unit", "|e| = 1", ("e",), None),
        ),
    ),
    "moving_frame_velocity": (
        (("o_dot", (3,)), ("Q", (3, 3)), ("omega", (3,)), ("rho", (3,)), ("rho_dot", (3,))),
        (
            ("rotation", "Q is a rotation", ("Q",), None),
        ),
    ),
    "moving_frame_acceleration": (
        (("o_ddot", (3,)), ("Q", (3, 3)), ("omega", (3,)), ("omega_dot", (3,)), ("rho", (3,)), ("rho_dot", (3,)), ("rho_ddot", (3,))),
        (
            ("rotation", "Q is a rotation", ("Q",), None),
        ),
    ),
    "wrench_axis": (
        (("f", (3,)), ("n_A", (3,)), ("a", (3,))),
        (
            ("nonzero", "f != 0", ("f",), divisor_8),
        ),
    ),
    "power": (
        (("t", (6,)), ("w", (6,))),
        (),
    ),
    "reciprocal_product": (
        (("s_w", (6,)), ("s_t", (6,))),
        (),
    ),
    "wrench_transfer": (
        (("w_A", (6,)), ("a", (3,)), ("p", (3,))),
        (),
    ),
    "inertia_about_point": (
        (("I_C", (3, 3)), ("m", ()), ("c", (3,)), ("a", (3,))),
        (
            ("positive", "m > 0", ("m",), None),
            ("symmetric", "I_C is symmetric", ("I_C",), None),
        ),
    ),
    "inertia_about_point_sym6": (
        (("I_C", (6,)), ("m", ()), ("c", (3,)), ("a", (3,))),
        (
            ("positive", "m > 0", ("m",), None),
        ),
    ),
    "momentum_screw": (
        (("I_C", (3, 3)), ("m", ()), ("t", (6,))),
        (
            ("symmetric", "I_C is symmetric", ("I_C",), None),
            ("positive", "m > 0", ("m",), None),
        ),
    ),
    "momentum_screw_sym6": (
        (("I_C", (6,)), ("m", ()), ("t", (6,))),
        (
            ("positive", "m > 0", ("m",), None),
        ),
    ),
    "kinetic_energy": (
        (("I_C", (3, 3)), ("m", ()), ("t", (6,))),
        (
            ("symmetric", "I_C is symmetric", ("I_C",), None),
            ("positive", "m > 0", ("m",), None),
        ),
    ),
    "kinetic_energy_sym6": (
        (("I_C", (6,)), ("m", ()), ("t", (6,))),
        (
            ("positive", "m > 0", ("m",), None),
        ),
    ),
    "newton_euler_wrench": (
        (("I_C", (3, 3)), ("m", ()), ("t", (6,)), ("t_dot", (6,))),
        (
            ("symmetric", "I_C is symmetric", ("I_C",), None),
            ("positive", "m > 0", ("m",), None),
        ),
    ),
    "newton_euler_wrench_sym6": (
        (("I_C", (6,)), ("m", ()), ("t", (6,)), ("t_dot", (6,))),
        (
            ("positive", "m > 0", ("m",), None),
        ),
    ),
    "newton_euler_twist_rate": (
        (("I_C", (3, 3)), ("m", ()), ("t", (6,)), ("w", (6,))),
        (
            ("positive", "m > 0", ("m",), None),
            ("definite", "I_C is positive-definite", ("I_C",), None),
        ),
    ),
    "newton_euler_twist_rate_sym6": (
        (("I_C", (6,)), ("m", ()), ("t", (6,)), ("w", (6,))),
        (
            ("positive", "m > 0", ("m",), None),
            ("definite", "I_C is positive-definite", ("I_C",), None),
        ),
    ),
    "inertia_dyad": (
        (("I_C", (3, 3)), ("m", ()), ("c", (3,)), ("a", (3,))),
        (
            ("symmetric", "I_C is symmetric", ("I_C",), None),
            ("positive", "m > 0", ("m",), None),
        ),
    ),
    "inertia_dyad_sym6": (
        (("I_C", (6,)), ("m", ()), ("c", (3,)), ("a", (3,))),
        (
            ("positive", "m > 0", ("m",), None),
        ),
    ),
    "rotation_from_euler_xyx": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_xyx": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_body_xyx": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rates_xyx": (
        (("angles", (3,)), ("omega", (3,))),
        (
            ("nonzero", "sin(theta_2) != 0", ("angles",), divisor_9),
        ),
    ),
    "rotation_from_euler_xyz": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_xyz": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_body_xyz": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rates_xyz": (
        (("angles", (3,)), ("omega", (3,))),
        (
            ("nonzero", "cos(theta_2) != 0", ("angles",), divisor_10),
        ),
    ),
    "rotation_from_euler_xzx": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_xzx": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_body_xzx": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rates_xzx": (
        (("angles", (3,)), ("omega", (3,))),
        (
            ("nonzero", "sin(theta_2) != 0", ("angles",), divisor_9),
        ),
    ),
    "rotation_from_euler_xzy": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_xzy": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_body_xzy": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rates_xzy": (
        (("angles", (3,)), ("omega", (3,))),
        (
            ("nonzero", "cos(theta_2) != 0", ("angles",), divisor_10),
        ),
    ),
    "rotation_from_euler_yxy": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_yxy": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_body_yxy": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rates_yxy": (
        (("angles", (3,)), ("omega", (3,))),
        (
            ("nonzero", "sin(theta_2) != 0", ("angles",), divisor_9),
        ),
    ),
    "rotation_from_euler_yxz": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_yxz": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_body_yxz": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rates_yxz": (
        (("angles", (3,)), ("omega", (3,))),
        (
            ("nonzero", "cos(theta_2) != 0", ("angles",), divisor_10),
        ),
    ),
    "rotation_from_euler_yzx": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_yzx": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_body_yzx": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rates_yzx": (
        (("angles", (3,)), ("omega", (3,))),
        (
            ("nonzero", "cos(theta_2) != 0", ("angles",), divisor_10),
        ),
    ),
    "rotation_from_euler_yzy": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_yzy": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_body_yzy": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rates_yzy": (
        (("angles", (3,)), ("omega", (3,))),
        (
            ("nonzero", "sin(theta_2) != 0", ("angles",), divisor_9),
        ),
    ),
    "rotation_from_euler_zxy": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_zxy": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_body_zxy": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rates_zxy": (
        (("angles", (3,)), ("omega", (3,))),
        (
            ("nonzero", "cos(theta_2) != 0", ("angles",), divisor_10),
        ),
    ),
    "rotation_from_euler_zxz": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_zxz": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_body_zxz": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rates_zxz": (
        (("angles", (3,)), ("omega", (3,))),
        (
            ("nonzero", "sin(theta_2) != 0", ("angles",), divisor_9),
        ),
    ),
    "rotation_from_euler_zyx": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_zyx": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_body_zyx": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rates_zyx": (
        (("angles", (3,)), ("omega", (3,))),
        (
            ("nonzero", "cos(theta_2) != 0", ("angles",), divisor_10),
        ),
    ),
    "rotation_from_euler_zyz": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_zyz": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rate_matrix_body_zyz": (
        (("angles", (3,)),),
        (),
    ),
    "euler_rates_zyz": (
        (("angles", (3,)), ("omega", (3,))),
        (
            ("nonzero", "sin(theta_2) != 0", ("angles",), divisor_9),
        ),
    ),
}
