"""The functions of `chasles.kernels.one`. Made by `chasles emit`; not to be edited."""

from typing import Any

from .protocols import (
    Array,
    Light1x1,
    Light1x2,
    Light2x1,
    Light3x1,
    Light3x2,
    Light3x3,
    Light4x1,
    Light5x1,
    Light7x1,
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

cross_product_matrix: Light1x1[Array]
"""As `chasles.kernels.cross_product_matrix`: (3)->(3,3)."""

rotation_from_axis_angle: Light2x1[Array]
"""As `chasles.kernels.rotation_from_axis_angle`: (3),()->(3,3)."""

point_after_displacement: Light4x1[Array]
"""As `chasles.kernels.point_after_displacement`: (3,3),(3),(3),(3)->(3)."""

pitch_of_motion: Light3x1[Any]
"""As `chasles.kernels.pitch_of_motion`: (3),(),(3)->()."""

normal_matrix_inverse: Light2x1[Array]
"""As `chasles.kernels.normal_matrix_inverse`: (3),()->(3,3)."""

screw_axis_point: Light4x1[Array]
"""As `chasles.kernels.screw_axis_point`: (3),(),(3),(3)->(3)."""

plucker_line: Light2x1[Array]
"""As `chasles.kernels.plucker_line`: (3),(3)->(6)."""

plucker_transfer: Light3x1[Array]
"""As `chasles.kernels.plucker_transfer`: (6),(3),(3)->(6)."""

rotation_in_triad_axes: Light2x1[Array]
"""As `chasles.kernels.rotation_in_triad_axes`: (3,3),(3,3)->(3,3)."""

rotation_from_triads: Light2x1[Array]
"""As `chasles.kernels.rotation_from_triads`: (3,3),(3,3)->(3,3)."""

axial_vector: Light1x1[Array]
"""As `chasles.kernels.axial_vector`: (3,3)->(3)."""

velocity_of_point: Light4x1[Array]
"""As `chasles.kernels.velocity_of_point`: (3),(3),(3),(3)->(3)."""

instant_screw_point: Light3x1[Array]
"""As `chasles.kernels.instant_screw_point`: (3),(3),(3)->(3)."""

natural_rate_matrix: Light2x1[Array]
"""As `chasles.kernels.natural_rate_matrix`: (3),()->(4,3)."""

linear_rate_matrix: Light2x1[Array]
"""As `chasles.kernels.linear_rate_matrix`: (3),()->(4,3)."""

euler_rodrigues_rate_matrix: Light2x1[Array]
"""As `chasles.kernels.euler_rodrigues_rate_matrix`: (3),()->(4,3)."""

rotation_from_linear_invariants: Light2x1[Array]
"""As `chasles.kernels.rotation_from_linear_invariants`: (3),()->(3,3)."""

rotation_from_euler_rodrigues: Light2x1[Array]
"""As `chasles.kernels.rotation_from_euler_rodrigues`: (3),()->(3,3)."""

linear_invariants: Light1x2[tuple[Array, Any]]
"""As `chasles.kernels.linear_invariants`: (3,3)->(3),()."""

natural_invariants: Light1x2[tuple[Array, Any]]
"""As `chasles.kernels.natural_invariants`: (3,3)->(3),()."""

euler_rodrigues_parameters: Light1x2[tuple[Array, Any]]
"""As `chasles.kernels.euler_rodrigues_parameters`: (3,3)->(3),()."""

screw_of_motion: Light3x3[tuple[Array, Any, Any]]
"""As `chasles.kernels.screw_of_motion`: (3,3),(3),(3)->(6),(),()."""

instant_screw: Light3x2[tuple[Array, Any]]
"""As `chasles.kernels.instant_screw`: (3),(3),(3)->(6),()."""

natural_velocity_matrix: Light2x1[Array]
"""As `chasles.kernels.natural_velocity_matrix`: (3),()->(3,4)."""

linear_velocity_matrix: Light2x1[Array]
"""As `chasles.kernels.linear_velocity_matrix`: (3),()->(3,4)."""

euler_rodrigues_velocity_matrix: Light2x1[Array]
"""As `chasles.kernels.euler_rodrigues_velocity_matrix`: (3),()->(3,4)."""

pose_rate_natural: Light3x1[Array]
"""As `chasles.kernels.pose_rate_natural`: (3),(),(6)->(7)."""

pose_rate_linear: Light3x1[Array]
"""As `chasles.kernels.pose_rate_linear`: (3),(),(6)->(7)."""

pose_rate_euler_rodrigues: Light3x1[Array]
"""As `chasles.kernels.pose_rate_euler_rodrigues`: (3),(),(6)->(7)."""

twist_from_pose_rate_natural: Light3x1[Array]
"""As `chasles.kernels.twist_from_pose_rate_natural`: (3),(),(7)->(6)."""

twist_from_pose_rate_linear: Light3x1[Array]
"""As `chasles.kernels.twist_from_pose_rate_linear`: (3),(),(7)->(6)."""

twist_from_pose_rate_euler_rodrigues: Light3x1[Array]
"""As `chasles.kernels.twist_from_pose_rate_euler_rodrigues`: (3),(),(7)->(6)."""

twist_transfer: Light3x1[Array]
"""As `chasles.kernels.twist_transfer`: (6),(3),(3)->(6)."""

angular_acceleration_matrix: Light2x1[Array]
"""As `chasles.kernels.angular_acceleration_matrix`: (3),(3)->(3,3)."""

acceleration_of_point: Light5x1[Array]
"""As `chasles.kernels.acceleration_of_point`: (3),(3),(3),(3),(3)->(3)."""

natural_rate_matrix_dot: Light3x1[Array]
"""As `chasles.kernels.natural_rate_matrix_dot`: (3),(),(3)->(4,3)."""

linear_rate_matrix_dot: Light3x1[Array]
"""As `chasles.kernels.linear_rate_matrix_dot`: (3),(),(3)->(4,3)."""

euler_rodrigues_rate_matrix_dot: Light3x1[Array]
"""As `chasles.kernels.euler_rodrigues_rate_matrix_dot`: (3),(),(3)->(4,3)."""

natural_velocity_matrix_dot: Light3x1[Array]
"""As `chasles.kernels.natural_velocity_matrix_dot`: (3),(),(3)->(3,4)."""

linear_velocity_matrix_dot: Light3x1[Array]
"""As `chasles.kernels.linear_velocity_matrix_dot`: (3),(),(3)->(3,4)."""

euler_rodrigues_velocity_matrix_dot: Light3x1[Array]
"""As `chasles.kernels.euler_rodrigues_velocity_matrix_dot`: (3),(),(3)->(3,4)."""

pose_acceleration_natural: Light4x1[Array]
"""As `chasles.kernels.pose_acceleration_natural`: (3),(),(6),(6)->(7)."""

pose_acceleration_linear: Light4x1[Array]
"""As `chasles.kernels.pose_acceleration_linear`: (3),(),(6),(6)->(7)."""

pose_acceleration_euler_rodrigues: Light4x1[Array]
"""As `chasles.kernels.pose_acceleration_euler_rodrigues`: (3),(),(6),(6)->(7)."""

twist_rate_from_pose_natural: Light4x1[Array]
"""As `chasles.kernels.twist_rate_from_pose_natural`: (3),(),(7),(7)->(6)."""

twist_rate_from_pose_linear: Light4x1[Array]
"""As `chasles.kernels.twist_rate_from_pose_linear`: (3),(),(7),(7)->(6)."""

twist_rate_from_pose_euler_rodrigues: Light4x1[Array]
"""As `chasles.kernels.twist_rate_from_pose_euler_rodrigues`: (3),(),(7),(7)->(6)."""

moving_frame_velocity: Light5x1[Array]
"""As `chasles.kernels.moving_frame_velocity`: (3),(3,3),(3),(3),(3)->(3)."""

moving_frame_acceleration: Light7x1[Array]
"""As `chasles.kernels.moving_frame_acceleration`: (3),(3,3),(3),(3),(3),(3),(3)->(3)."""

wrench_axis: Light3x2[tuple[Array, Any]]
"""As `chasles.kernels.wrench_axis`: (3),(3),(3)->(6),()."""

power: Light2x1[Any]
"""As `chasles.kernels.power`: (6),(6)->()."""

reciprocal_product: Light2x1[Any]
"""As `chasles.kernels.reciprocal_product`: (6),(6)->()."""

wrench_transfer: Light3x1[Array]
"""As `chasles.kernels.wrench_transfer`: (6),(3),(3)->(6)."""

inertia_about_point: Light4x1[Array]
"""As `chasles.kernels.inertia_about_point`: (3,3),(),(3),(3)->(3,3)."""

inertia_about_point_sym6: Light4x1[Array]
"""As `chasles.kernels.inertia_about_point_sym6`: (6),(),(3),(3)->(6)."""

momentum_screw: Light3x1[Array]
"""As `chasles.kernels.momentum_screw`: (3,3),(),(6)->(6)."""

momentum_screw_sym6: Light3x1[Array]
"""As `chasles.kernels.momentum_screw_sym6`: (6),(),(6)->(6)."""

kinetic_energy: Light3x1[Any]
"""As `chasles.kernels.kinetic_energy`: (3,3),(),(6)->()."""

kinetic_energy_sym6: Light3x1[Any]
"""As `chasles.kernels.kinetic_energy_sym6`: (6),(),(6)->()."""

newton_euler_wrench: Light4x1[Array]
"""As `chasles.kernels.newton_euler_wrench`: (3,3),(),(6),(6)->(6)."""

newton_euler_wrench_sym6: Light4x1[Array]
"""As `chasles.kernels.newton_euler_wrench_sym6`: (6),(),(6),(6)->(6)."""

newton_euler_twist_rate: Light4x1[Array]
"""As `chasles.kernels.newton_euler_twist_rate`: (3,3),(),(6),(6)->(6)."""

newton_euler_twist_rate_sym6: Light4x1[Array]
"""As `chasles.kernels.newton_euler_twist_rate_sym6`: (6),(),(6),(6)->(6)."""

inertia_dyad: Light4x1[Array]
"""As `chasles.kernels.inertia_dyad`: (3,3),(),(3),(3)->(6,6)."""

inertia_dyad_sym6: Light4x1[Array]
"""As `chasles.kernels.inertia_dyad_sym6`: (6),(),(3),(3)->(6,6)."""

rotation_from_euler_xyx: Light1x1[Array]
"""As `chasles.kernels.rotation_from_euler_xyx`: (3)->(3,3)."""

euler_rate_matrix_xyx: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_xyx`: (3)->(3,3)."""

euler_rate_matrix_body_xyx: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_body_xyx`: (3)->(3,3)."""

euler_rates_xyx: Light2x1[Array]
"""As `chasles.kernels.euler_rates_xyx`: (3),(3)->(3)."""

rotation_from_euler_xyz: Light1x1[Array]
"""As `chasles.kernels.rotation_from_euler_xyz`: (3)->(3,3)."""

euler_rate_matrix_xyz: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_xyz`: (3)->(3,3)."""

euler_rate_matrix_body_xyz: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_body_xyz`: (3)->(3,3)."""

euler_rates_xyz: Light2x1[Array]
"""As `chasles.kernels.euler_rates_xyz`: (3),(3)->(3)."""

rotation_from_euler_xzx: Light1x1[Array]
"""As `chasles.kernels.rotation_from_euler_xzx`: (3)->(3,3)."""

euler_rate_matrix_xzx: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_xzx`: (3)->(3,3)."""

euler_rate_matrix_body_xzx: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_body_xzx`: (3)->(3,3)."""

euler_rates_xzx: Light2x1[Array]
"""As `chasles.kernels.euler_rates_xzx`: (3),(3)->(3)."""

rotation_from_euler_xzy: Light1x1[Array]
"""As `chasles.kernels.rotation_from_euler_xzy`: (3)->(3,3)."""

euler_rate_matrix_xzy: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_xzy`: (3)->(3,3)."""

euler_rate_matrix_body_xzy: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_body_xzy`: (3)->(3,3)."""

euler_rates_xzy: Light2x1[Array]
"""As `chasles.kernels.euler_rates_xzy`: (3),(3)->(3)."""

rotation_from_euler_yxy: Light1x1[Array]
"""As `chasles.kernels.rotation_from_euler_yxy`: (3)->(3,3)."""

euler_rate_matrix_yxy: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_yxy`: (3)->(3,3)."""

euler_rate_matrix_body_yxy: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_body_yxy`: (3)->(3,3)."""

euler_rates_yxy: Light2x1[Array]
"""As `chasles.kernels.euler_rates_yxy`: (3),(3)->(3)."""

rotation_from_euler_yxz: Light1x1[Array]
"""As `chasles.kernels.rotation_from_euler_yxz`: (3)->(3,3)."""

euler_rate_matrix_yxz: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_yxz`: (3)->(3,3)."""

euler_rate_matrix_body_yxz: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_body_yxz`: (3)->(3,3)."""

euler_rates_yxz: Light2x1[Array]
"""As `chasles.kernels.euler_rates_yxz`: (3),(3)->(3)."""

rotation_from_euler_yzx: Light1x1[Array]
"""As `chasles.kernels.rotation_from_euler_yzx`: (3)->(3,3)."""

euler_rate_matrix_yzx: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_yzx`: (3)->(3,3)."""

euler_rate_matrix_body_yzx: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_body_yzx`: (3)->(3,3)."""

euler_rates_yzx: Light2x1[Array]
"""As `chasles.kernels.euler_rates_yzx`: (3),(3)->(3)."""

rotation_from_euler_yzy: Light1x1[Array]
"""As `chasles.kernels.rotation_from_euler_yzy`: (3)->(3,3)."""

euler_rate_matrix_yzy: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_yzy`: (3)->(3,3)."""

euler_rate_matrix_body_yzy: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_body_yzy`: (3)->(3,3)."""

euler_rates_yzy: Light2x1[Array]
"""As `chasles.kernels.euler_rates_yzy`: (3),(3)->(3)."""

rotation_from_euler_zxy: Light1x1[Array]
"""As `chasles.kernels.rotation_from_euler_zxy`: (3)->(3,3)."""

euler_rate_matrix_zxy: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_zxy`: (3)->(3,3)."""

euler_rate_matrix_body_zxy: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_body_zxy`: (3)->(3,3)."""

euler_rates_zxy: Light2x1[Array]
"""As `chasles.kernels.euler_rates_zxy`: (3),(3)->(3)."""

rotation_from_euler_zxz: Light1x1[Array]
"""As `chasles.kernels.rotation_from_euler_zxz`: (3)->(3,3)."""

euler_rate_matrix_zxz: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_zxz`: (3)->(3,3)."""

euler_rate_matrix_body_zxz: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_body_zxz`: (3)->(3,3)."""

euler_rates_zxz: Light2x1[Array]
"""As `chasles.kernels.euler_rates_zxz`: (3),(3)->(3)."""

rotation_from_euler_zyx: Light1x1[Array]
"""As `chasles.kernels.rotation_from_euler_zyx`: (3)->(3,3)."""

euler_rate_matrix_zyx: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_zyx`: (3)->(3,3)."""

euler_rate_matrix_body_zyx: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_body_zyx`: (3)->(3,3)."""

euler_rates_zyx: Light2x1[Array]
"""As `chasles.kernels.euler_rates_zyx`: (3),(3)->(3)."""

rotation_from_euler_zyz: Light1x1[Array]
"""As `chasles.kernels.rotation_from_euler_zyz`: (3)->(3,3)."""

euler_rate_matrix_zyz: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_zyz`: (3)->(3,3)."""

euler_rate_matrix_body_zyz: Light1x1[Array]
"""As `chasles.kernels.euler_rate_matrix_body_zyz`: (3)->(3,3)."""

euler_rates_zyz: Light2x1[Array]
"""As `chasles.kernels.euler_rates_zyz`: (3),(3)->(3)."""
