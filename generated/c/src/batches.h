/* How batches are run, for the library's own files alone. Made by `chasles emit`; not to be edited by hand.
 *
 * A block computes some groups of items; a group is as many items as a register has lanes, so that an item's result
 * does not depend on where in a batch it stands. Blocks are compiled once for each level, which is a set of
 * instructions; `chasles_run` cuts a batch into blocks.
 */
#ifndef CHASLES_BATCHES_H
#define CHASLES_BATCHES_H

#include <stddef.h>

/* Vector types need shuffles: gcc from 12 on, or clang; other compilers get blocks of one scalar call after another. */
#if (defined(__clang__) || (defined(__GNUC__) && __GNUC__ >= 12)) && (defined(__SSE2__) || defined(__aarch64__))
#define CHASLES_VECTORS 1
#else
#define CHASLES_VECTORS 0
#endif

/* How many levels there are: the compiler's own target and, on x86-64, x86-64-v3. With x86-64-v4 the widest kernels
 * were slower, in registers of 64 bytes as in those of 32. */
#ifndef CHASLES_LEVELS
#define CHASLES_LEVELS 1
#endif

/* The level of the file that is being compiled, from 0. */
#ifndef CHASLES_LEVEL
#define CHASLES_LEVEL 0
#endif

#if CHASLES_LEVEL == 0
#define CHASLES_LEVELED(name) name##_baseline
#define CHASLES_REGISTER 16
#else
#define CHASLES_LEVELED(name) name##_v3
#define CHASLES_REGISTER 32
#endif

#if CHASLES_LEVELS == 1
#define CHASLES_DECLARED(name) name##_baseline
#define CHASLES_BLOCKS(name) {name##_baseline}
#else
#define CHASLES_DECLARED(name) name##_baseline, name##_v3
#define CHASLES_BLOCKS(name) {name##_baseline, name##_v3}
#endif

/* The most items in a block, the most operands of a kernel, and the bytes in which a block's items are gathered. */
#define CHASLES_BLOCK 64
#define CHASLES_OPERANDS 16
#define CHASLES_STORE 32768

#ifdef __cplusplus
extern "C" {
#endif

/* Computes groups * lanes items: that of operand k starts at at[k], the next one steps[k] bytes on, each row-major. */
typedef void chasles_block(ptrdiff_t groups, char *const *at, const ptrdiff_t *steps);

/* The core shape of an operand: how many axes, and the rows and columns, 1 where there is no such axis. */
typedef struct {
    int axes;
    int rows;
    int columns;
} chasles_shape;

/* A kernel in one precision. `number` is the size of a number in bytes; `silent` says whether a result can be NaN
 * without an operation that is invalid; operands are inputs, then outputs. */
typedef struct {
    ptrdiff_t number;
    int silent;
    int inputs;
    int operands;
    const chasles_shape *shapes;
    chasles_block *blocks[CHASLES_LEVELS];
} chasles_loop;

/* The best level of this machine, from 0. */
int chasles_best_level(void);

/* Computes `count` items. `core` holds the steps in bytes along the core axes, operand by operand; NULL where every
 * item is row-major without gaps. An output may lie over inputs of its own item and of earlier ones. The
 * floating-point state stays as it was, but that `invalid` is raised where a result is NaN and no input of it is. */
void chasles_run(
    const chasles_loop *loop, int level, ptrdiff_t count, char *const *at, const ptrdiff_t *steps, const ptrdiff_t *core);

extern const chasles_loop chasles_cross_product_matrix_loop;
extern const chasles_loop chasles_cross_product_matrix_loopf;
extern const chasles_loop chasles_rotation_from_axis_angle_loop;
extern const chasles_loop chasles_rotation_from_axis_angle_loopf;
extern const chasles_loop chasles_point_after_displacement_loop;
extern const chasles_loop chasles_point_after_displacement_loopf;
extern const chasles_loop chasles_pitch_of_motion_loop;
extern const chasles_loop chasles_pitch_of_motion_loopf;
extern const chasles_loop chasles_normal_matrix_inverse_loop;
extern const chasles_loop chasles_normal_matrix_inverse_loopf;
extern const chasles_loop chasles_screw_axis_point_loop;
extern const chasles_loop chasles_screw_axis_point_loopf;
extern const chasles_loop chasles_plucker_line_loop;
extern const chasles_loop chasles_plucker_line_loopf;
extern const chasles_loop chasles_plucker_transfer_loop;
extern const chasles_loop chasles_plucker_transfer_loopf;
extern const chasles_loop chasles_rotation_in_triad_axes_loop;
extern const chasles_loop chasles_rotation_in_triad_axes_loopf;
extern const chasles_loop chasles_rotation_from_triads_loop;
extern const chasles_loop chasles_rotation_from_triads_loopf;
extern const chasles_loop chasles_velocity_of_point_loop;
extern const chasles_loop chasles_velocity_of_point_loopf;
extern const chasles_loop chasles_instant_screw_point_loop;
extern const chasles_loop chasles_instant_screw_point_loopf;
extern const chasles_loop chasles_natural_rate_matrix_loop;
extern const chasles_loop chasles_natural_rate_matrix_loopf;
extern const chasles_loop chasles_linear_rate_matrix_loop;
extern const chasles_loop chasles_linear_rate_matrix_loopf;
extern const chasles_loop chasles_euler_rodrigues_rate_matrix_loop;
extern const chasles_loop chasles_euler_rodrigues_rate_matrix_loopf;
extern const chasles_loop chasles_rotation_from_linear_invariants_loop;
extern const chasles_loop chasles_rotation_from_linear_invariants_loopf;
extern const chasles_loop chasles_rotation_from_euler_rodrigues_loop;
extern const chasles_loop chasles_rotation_from_euler_rodrigues_loopf;
extern const chasles_loop chasles_linear_invariants_loop;
extern const chasles_loop chasles_linear_invariants_loopf;
extern const chasles_loop chasles_natural_invariants_loop;
extern const chasles_loop chasles_natural_invariants_loopf;
extern const chasles_loop chasles_euler_rodrigues_parameters_loop;
extern const chasles_loop chasles_euler_rodrigues_parameters_loopf;
extern const chasles_loop chasles_screw_of_motion_loop;
extern const chasles_loop chasles_screw_of_motion_loopf;
extern const chasles_loop chasles_instant_screw_loop;
extern const chasles_loop chasles_instant_screw_loopf;
extern const chasles_loop chasles_natural_velocity_matrix_loop;
extern const chasles_loop chasles_natural_velocity_matrix_loopf;
extern const chasles_loop chasles_linear_velocity_matrix_loop;
extern const chasles_loop chasles_linear_velocity_matrix_loopf;
extern const chasles_loop chasles_euler_rodrigues_velocity_matrix_loop;
extern const chasles_loop chasles_euler_rodrigues_velocity_matrix_loopf;
extern const chasles_loop chasles_pose_rate_natural_loop;
extern const chasles_loop chasles_pose_rate_natural_loopf;
extern const chasles_loop chasles_pose_rate_linear_loop;
extern const chasles_loop chasles_pose_rate_linear_loopf;
extern const chasles_loop chasles_pose_rate_euler_rodrigues_loop;
extern const chasles_loop chasles_pose_rate_euler_rodrigues_loopf;
extern const chasles_loop chasles_twist_from_pose_rate_natural_loop;
extern const chasles_loop chasles_twist_from_pose_rate_natural_loopf;
extern const chasles_loop chasles_twist_from_pose_rate_linear_loop;
extern const chasles_loop chasles_twist_from_pose_rate_linear_loopf;
extern const chasles_loop chasles_twist_from_pose_rate_euler_rodrigues_loop;
extern const chasles_loop chasles_twist_from_pose_rate_euler_rodrigues_loopf;
extern const chasles_loop chasles_twist_transfer_loop;
extern const chasles_loop chasles_twist_transfer_loopf;
extern const chasles_loop chasles_angular_acceleration_matrix_loop;
extern const chasles_loop chasles_angular_acceleration_matrix_loopf;
extern const chasles_loop chasles_acceleration_of_point_loop;
extern const chasles_loop chasles_acceleration_of_point_loopf;
extern const chasles_loop chasles_moving_frame_velocity_loop;
extern const chasles_loop chasles_moving_frame_velocity_loopf;
extern const chasles_loop chasles_moving_frame_acceleration_loop;
extern const chasles_loop chasles_moving_frame_acceleration_loopf;
extern const chasles_loop chasles_wrench_axis_loop;
extern const chasles_loop chasles_wrench_axis_loopf;
extern const chasles_loop chasles_power_loop;
extern const chasles_loop chasles_power_loopf;
extern const chasles_loop chasles_reciprocal_product_loop;
extern const chasles_loop chasles_reciprocal_product_loopf;
extern const chasles_loop chasles_wrench_transfer_loop;
extern const chasles_loop chasles_wrench_transfer_loopf;
extern const chasles_loop chasles_inertia_about_point_loop;
extern const chasles_loop chasles_inertia_about_point_loopf;
extern const chasles_loop chasles_momentum_screw_loop;
extern const chasles_loop chasles_momentum_screw_loopf;
extern const chasles_loop chasles_kinetic_energy_loop;
extern const chasles_loop chasles_kinetic_energy_loopf;
extern const chasles_loop chasles_newton_euler_wrench_loop;
extern const chasles_loop chasles_newton_euler_wrench_loopf;
extern const chasles_loop chasles_newton_euler_twist_rate_loop;
extern const chasles_loop chasles_newton_euler_twist_rate_loopf;
extern const chasles_loop chasles_inertia_dyad_loop;
extern const chasles_loop chasles_inertia_dyad_loopf;
chasles_block CHASLES_DECLARED(chasles_cross_product_matrix_block);
chasles_block CHASLES_DECLARED(chasles_cross_product_matrix_blockf);
chasles_block CHASLES_DECLARED(chasles_rotation_from_axis_angle_block);
chasles_block CHASLES_DECLARED(chasles_rotation_from_axis_angle_blockf);
chasles_block CHASLES_DECLARED(chasles_point_after_displacement_block);
chasles_block CHASLES_DECLARED(chasles_point_after_displacement_blockf);
chasles_block CHASLES_DECLARED(chasles_pitch_of_motion_block);
chasles_block CHASLES_DECLARED(chasles_pitch_of_motion_blockf);
chasles_block CHASLES_DECLARED(chasles_normal_matrix_inverse_block);
chasles_block CHASLES_DECLARED(chasles_normal_matrix_inverse_blockf);
chasles_block CHASLES_DECLARED(chasles_screw_axis_point_block);
chasles_block CHASLES_DECLARED(chasles_screw_axis_point_blockf);
chasles_block CHASLES_DECLARED(chasles_plucker_line_block);
chasles_block CHASLES_DECLARED(chasles_plucker_line_blockf);
chasles_block CHASLES_DECLARED(chasles_plucker_transfer_block);
chasles_block CHASLES_DECLARED(chasles_plucker_transfer_blockf);
chasles_block CHASLES_DECLARED(chasles_rotation_in_triad_axes_block);
chasles_block CHASLES_DECLARED(chasles_rotation_in_triad_axes_blockf);
chasles_block CHASLES_DECLARED(chasles_rotation_from_triads_block);
chasles_block CHASLES_DECLARED(chasles_rotation_from_triads_blockf);
chasles_block CHASLES_DECLARED(chasles_velocity_of_point_block);
chasles_block CHASLES_DECLARED(chasles_velocity_of_point_blockf);
chasles_block CHASLES_DECLARED(chasles_instant_screw_point_block);
chasles_block CHASLES_DECLARED(chasles_instant_screw_point_blockf);
chasles_block CHASLES_DECLARED(chasles_natural_rate_matrix_block);
chasles_block CHASLES_DECLARED(chasles_natural_rate_matrix_blockf);
chasles_block CHASLES_DECLARED(chasles_linear_rate_matrix_block);
chasles_block CHASLES_DECLARED(chasles_linear_rate_matrix_blockf);
chasles_block CHASLES_DECLARED(chasles_euler_rodrigues_rate_matrix_block);
chasles_block CHASLES_DECLARED(chasles_euler_rodrigues_rate_matrix_blockf);
chasles_block CHASLES_DECLARED(chasles_rotation_from_linear_invariants_block);
chasles_block CHASLES_DECLARED(chasles_rotation_from_linear_invariants_blockf);
chasles_block CHASLES_DECLARED(chasles_rotation_from_euler_rodrigues_block);
chasles_block CHASLES_DECLARED(chasles_rotation_from_euler_rodrigues_blockf);
chasles_block CHASLES_DECLARED(chasles_linear_invariants_block);
chasles_block CHASLES_DECLARED(chasles_linear_invariants_blockf);
chasles_block CHASLES_DECLARED(chasles_natural_invariants_block);
chasles_block CHASLES_DECLARED(chasles_natural_invariants_blockf);
chasles_block CHASLES_DECLARED(chasles_euler_rodrigues_parameters_block);
chasles_block CHASLES_DECLARED(chasles_euler_rodrigues_parameters_blockf);
chasles_block CHASLES_DECLARED(chasles_screw_of_motion_block);
chasles_block CHASLES_DECLARED(chasles_screw_of_motion_blockf);
chasles_block CHASLES_DECLARED(chasles_instant_screw_block);
chasles_block CHASLES_DECLARED(chasles_instant_screw_blockf);
chasles_block CHASLES_DECLARED(chasles_natural_velocity_matrix_block);
chasles_block CHASLES_DECLARED(chasles_natural_velocity_matrix_blockf);
chasles_block CHASLES_DECLARED(chasles_linear_velocity_matrix_block);
chasles_block CHASLES_DECLARED(chasles_linear_velocity_matrix_blockf);
chasles_block CHASLES_DECLARED(chasles_euler_rodrigues_velocity_matrix_block);
chasles_block CHASLES_DECLARED(chasles_euler_rodrigues_velocity_matrix_blockf);
chasles_block CHASLES_DECLARED(chasles_pose_rate_natural_block);
chasles_block CHASLES_DECLARED(chasles_pose_rate_natural_blockf);
chasles_block CHASLES_DECLARED(chasles_pose_rate_linear_block);
chasles_block CHASLES_DECLARED(chasles_pose_rate_linear_blockf);
chasles_block CHASLES_DECLARED(chasles_pose_rate_euler_rodrigues_block);
chasles_block CHASLES_DECLARED(chasles_pose_rate_euler_rodrigues_blockf);
chasles_block CHASLES_DECLARED(chasles_twist_from_pose_rate_natural_block);
chasles_block CHASLES_DECLARED(chasles_twist_from_pose_rate_natural_blockf);
chasles_block CHASLES_DECLARED(chasles_twist_from_pose_rate_linear_block);
chasles_block CHASLES_DECLARED(chasles_twist_from_pose_rate_linear_blockf);
chasles_block CHASLES_DECLARED(chasles_twist_from_pose_rate_euler_rodrigues_block);
chasles_block CHASLES_DECLARED(chasles_twist_from_pose_rate_euler_rodrigues_blockf);
chasles_block CHASLES_DECLARED(chasles_twist_transfer_block);
chasles_block CHASLES_DECLARED(chasles_twist_transfer_blockf);
chasles_block CHASLES_DECLARED(chasles_angular_acceleration_matrix_block);
chasles_block CHASLES_DECLARED(chasles_angular_acceleration_matrix_blockf);
chasles_block CHASLES_DECLARED(chasles_acceleration_of_point_block);
chasles_block CHASLES_DECLARED(chasles_acceleration_of_point_blockf);
chasles_block CHASLES_DECLARED(chasles_moving_frame_velocity_block);
chasles_block CHASLES_DECLARED(chasles_moving_frame_velocity_blockf);
chasles_block CHASLES_DECLARED(chasles_moving_frame_acceleration_block);
chasles_block CHASLES_DECLARED(chasles_moving_frame_acceleration_blockf);
chasles_block CHASLES_DECLARED(chasles_wrench_axis_block);
chasles_block CHASLES_DECLARED(chasles_wrench_axis_blockf);
chasles_block CHASLES_DECLARED(chasles_power_block);
chasles_block CHASLES_DECLARED(chasles_power_blockf);
chasles_block CHASLES_DECLARED(chasles_reciprocal_product_block);
chasles_block CHASLES_DECLARED(chasles_reciprocal_product_blockf);
chasles_block CHASLES_DECLARED(chasles_wrench_transfer_block);
chasles_block CHASLES_DECLARED(chasles_wrench_transfer_blockf);
chasles_block CHASLES_DECLARED(chasles_inertia_about_point_block);
chasles_block CHASLES_DECLARED(chasles_inertia_about_point_blockf);
chasles_block CHASLES_DECLARED(chasles_momentum_screw_block);
chasles_block CHASLES_DECLARED(chasles_momentum_screw_blockf);
chasles_block CHASLES_DECLARED(chasles_kinetic_energy_block);
chasles_block CHASLES_DECLARED(chasles_kinetic_energy_blockf);
chasles_block CHASLES_DECLARED(chasles_newton_euler_wrench_block);
chasles_block CHASLES_DECLARED(chasles_newton_euler_wrench_blockf);
chasles_block CHASLES_DECLARED(chasles_newton_euler_twist_rate_block);
chasles_block CHASLES_DECLARED(chasles_newton_euler_twist_rate_blockf);
chasles_block CHASLES_DECLARED(chasles_inertia_dyad_block);
chasles_block CHASLES_DECLARED(chasles_inertia_dyad_blockf);

#ifdef __cplusplus
}
#endif

#endif
