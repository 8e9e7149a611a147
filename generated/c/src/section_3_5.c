/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The kernels of section_3_5. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"
#include "loops.h"

static const chasles_shape chasles_angular_acceleration_matrix_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_angular_acceleration_matrix_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_angular_acceleration_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_angular_acceleration_matrix_block),
};

static const chasles_shape chasles_angular_acceleration_matrix_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_angular_acceleration_matrix_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_angular_acceleration_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_angular_acceleration_matrix_blockf),
};

static const chasles_shape chasles_acceleration_of_point_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_acceleration_of_point_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    5, 6, chasles_acceleration_of_point_loop_shapes,
    CHASLES_BLOCKS(chasles_acceleration_of_point_block),
};

static const chasles_shape chasles_acceleration_of_point_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_acceleration_of_point_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    5, 6, chasles_acceleration_of_point_loopf_shapes,
    CHASLES_BLOCKS(chasles_acceleration_of_point_blockf),
};

static const chasles_shape chasles_natural_rate_matrix_dot_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {2, 4, 3},
};
const chasles_loop chasles_natural_rate_matrix_dot_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_natural_rate_matrix_dot_loop_shapes,
    CHASLES_BLOCKS(chasles_natural_rate_matrix_dot_block),
};

static const chasles_shape chasles_natural_rate_matrix_dot_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {2, 4, 3},
};
const chasles_loop chasles_natural_rate_matrix_dot_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_natural_rate_matrix_dot_loopf_shapes,
    CHASLES_BLOCKS(chasles_natural_rate_matrix_dot_blockf),
};

static const chasles_shape chasles_linear_rate_matrix_dot_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {2, 4, 3},
};
const chasles_loop chasles_linear_rate_matrix_dot_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_linear_rate_matrix_dot_loop_shapes,
    CHASLES_BLOCKS(chasles_linear_rate_matrix_dot_block),
};

static const chasles_shape chasles_linear_rate_matrix_dot_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {2, 4, 3},
};
const chasles_loop chasles_linear_rate_matrix_dot_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_linear_rate_matrix_dot_loopf_shapes,
    CHASLES_BLOCKS(chasles_linear_rate_matrix_dot_blockf),
};

static const chasles_shape chasles_euler_rodrigues_rate_matrix_dot_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {2, 4, 3},
};
const chasles_loop chasles_euler_rodrigues_rate_matrix_dot_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_euler_rodrigues_rate_matrix_dot_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_rate_matrix_dot_block),
};

static const chasles_shape chasles_euler_rodrigues_rate_matrix_dot_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {2, 4, 3},
};
const chasles_loop chasles_euler_rodrigues_rate_matrix_dot_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_euler_rodrigues_rate_matrix_dot_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_rate_matrix_dot_blockf),
};

static const chasles_shape chasles_natural_velocity_matrix_dot_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {2, 3, 4},
};
const chasles_loop chasles_natural_velocity_matrix_dot_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_natural_velocity_matrix_dot_loop_shapes,
    CHASLES_BLOCKS(chasles_natural_velocity_matrix_dot_block),
};

static const chasles_shape chasles_natural_velocity_matrix_dot_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {2, 3, 4},
};
const chasles_loop chasles_natural_velocity_matrix_dot_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_natural_velocity_matrix_dot_loopf_shapes,
    CHASLES_BLOCKS(chasles_natural_velocity_matrix_dot_blockf),
};

static const chasles_shape chasles_linear_velocity_matrix_dot_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {2, 3, 4},
};
const chasles_loop chasles_linear_velocity_matrix_dot_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_linear_velocity_matrix_dot_loop_shapes,
    CHASLES_BLOCKS(chasles_linear_velocity_matrix_dot_block),
};

static const chasles_shape chasles_linear_velocity_matrix_dot_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {2, 3, 4},
};
const chasles_loop chasles_linear_velocity_matrix_dot_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_linear_velocity_matrix_dot_loopf_shapes,
    CHASLES_BLOCKS(chasles_linear_velocity_matrix_dot_blockf),
};

static const chasles_shape chasles_euler_rodrigues_velocity_matrix_dot_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {2, 3, 4},
};
const chasles_loop chasles_euler_rodrigues_velocity_matrix_dot_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_euler_rodrigues_velocity_matrix_dot_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_velocity_matrix_dot_block),
};

static const chasles_shape chasles_euler_rodrigues_velocity_matrix_dot_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {2, 3, 4},
};
const chasles_loop chasles_euler_rodrigues_velocity_matrix_dot_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_euler_rodrigues_velocity_matrix_dot_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_velocity_matrix_dot_blockf),
};

static const chasles_shape chasles_pose_acceleration_natural_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_acceleration_natural_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    4, 5, chasles_pose_acceleration_natural_loop_shapes,
    CHASLES_BLOCKS(chasles_pose_acceleration_natural_block),
};

static const chasles_shape chasles_pose_acceleration_natural_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_acceleration_natural_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    4, 5, chasles_pose_acceleration_natural_loopf_shapes,
    CHASLES_BLOCKS(chasles_pose_acceleration_natural_blockf),
};

static const chasles_shape chasles_pose_acceleration_linear_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_acceleration_linear_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    4, 5, chasles_pose_acceleration_linear_loop_shapes,
    CHASLES_BLOCKS(chasles_pose_acceleration_linear_block),
};

static const chasles_shape chasles_pose_acceleration_linear_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_acceleration_linear_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    4, 5, chasles_pose_acceleration_linear_loopf_shapes,
    CHASLES_BLOCKS(chasles_pose_acceleration_linear_blockf),
};

static const chasles_shape chasles_pose_acceleration_euler_rodrigues_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_acceleration_euler_rodrigues_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    4, 5, chasles_pose_acceleration_euler_rodrigues_loop_shapes,
    CHASLES_BLOCKS(chasles_pose_acceleration_euler_rodrigues_block),
};

static const chasles_shape chasles_pose_acceleration_euler_rodrigues_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_acceleration_euler_rodrigues_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    4, 5, chasles_pose_acceleration_euler_rodrigues_loopf_shapes,
    CHASLES_BLOCKS(chasles_pose_acceleration_euler_rodrigues_blockf),
};

static const chasles_shape chasles_twist_rate_from_pose_natural_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_rate_from_pose_natural_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    4, 5, chasles_twist_rate_from_pose_natural_loop_shapes,
    CHASLES_BLOCKS(chasles_twist_rate_from_pose_natural_block),
};

static const chasles_shape chasles_twist_rate_from_pose_natural_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_rate_from_pose_natural_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    4, 5, chasles_twist_rate_from_pose_natural_loopf_shapes,
    CHASLES_BLOCKS(chasles_twist_rate_from_pose_natural_blockf),
};

static const chasles_shape chasles_twist_rate_from_pose_linear_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_rate_from_pose_linear_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    4, 5, chasles_twist_rate_from_pose_linear_loop_shapes,
    CHASLES_BLOCKS(chasles_twist_rate_from_pose_linear_block),
};

static const chasles_shape chasles_twist_rate_from_pose_linear_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_rate_from_pose_linear_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    4, 5, chasles_twist_rate_from_pose_linear_loopf_shapes,
    CHASLES_BLOCKS(chasles_twist_rate_from_pose_linear_blockf),
};

static const chasles_shape chasles_twist_rate_from_pose_euler_rodrigues_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_rate_from_pose_euler_rodrigues_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    4, 5, chasles_twist_rate_from_pose_euler_rodrigues_loop_shapes,
    CHASLES_BLOCKS(chasles_twist_rate_from_pose_euler_rodrigues_block),
};

static const chasles_shape chasles_twist_rate_from_pose_euler_rodrigues_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_rate_from_pose_euler_rodrigues_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    4, 5, chasles_twist_rate_from_pose_euler_rodrigues_loopf_shapes,
    CHASLES_BLOCKS(chasles_twist_rate_from_pose_euler_rodrigues_blockf),
};

#if !(CHASLES_VECTORS && defined(CHASLES_BLOCKS_ALONE))

/*
 * (3.86) The angular-acceleration matrix.
 *   given       omega[3]: angular velocity
 *               omega_dot[3]: time derivative of: angular velocity
 *   returns     W[9]: angular-acceleration matrix
 *   verdict     defined
 *   assumes     Q is a rotation
 *   operations  15: 6 add, 3 subtract, 6 multiply
 *   error bound 2.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 600ac9c19e353f65970adc87c2c9e1aba7f40174fd2c1780126b444caebb2a29
 */
void chasles_angular_acceleration_matrix(
    const double omega[3],
    const double omega_dot[3],
    double W[9])
{
    const double t1 = omega[0] * omega[0];
    const double t2 = omega[0] * omega[1];
    const double t3 = omega[0] * omega[2];
    const double t4 = omega[1] * omega[1];
    const double t5 = omega[1] * omega[2];
    const double t6 = omega[2] * omega[2];
    const double W0 = -(t4 + t6);
    const double W4 = -(t1 + t6);
    const double W8 = -(t1 + t4);
    const double W1 = t2 - omega_dot[2];
    const double W2 = omega_dot[1] + t3;
    const double W3 = omega_dot[2] + t2;
    const double W5 = t5 - omega_dot[0];
    const double W6 = t3 - omega_dot[1];
    const double W7 = omega_dot[0] + t5;
    W[0] = W0;
    W[1] = W1;
    W[2] = W2;
    W[3] = W3;
    W[4] = W4;
    W[5] = W5;
    W[6] = W6;
    W[7] = W7;
    W[8] = W8;
}

/*
 * (3.86) chasles_angular_acceleration_matrix in single precision.
 *   verdict: defined; assumes Q is a rotation
 *   15 operations; derivation sha256 600ac9c19e353f65970adc87c2c9e1aba7f40174fd2c1780126b444caebb2a29
 */
void chasles_angular_acceleration_matrixf(
    const float omega[3],
    const float omega_dot[3],
    float W[9])
{
    const float t1 = omega[0] * omega[0];
    const float t2 = omega[0] * omega[1];
    const float t3 = omega[0] * omega[2];
    const float t4 = omega[1] * omega[1];
    const float t5 = omega[1] * omega[2];
    const float t6 = omega[2] * omega[2];
    const float W0 = -(t4 + t6);
    const float W4 = -(t1 + t6);
    const float W8 = -(t1 + t4);
    const float W1 = t2 - omega_dot[2];
    const float W2 = omega_dot[1] + t3;
    const float W3 = omega_dot[2] + t2;
    const float W5 = t5 - omega_dot[0];
    const float W6 = t3 - omega_dot[1];
    const float W7 = omega_dot[0] + t5;
    W[0] = W0;
    W[1] = W1;
    W[2] = W2;
    W[3] = W3;
    W[4] = W4;
    W[5] = W5;
    W[6] = W6;
    W[7] = W7;
    W[8] = W8;
}

/*
 * (3.86) chasles_angular_acceleration_matrix for a batch.
 *   verdict: defined; assumes Q is a rotation
 *   15 operations; derivation sha256 600ac9c19e353f65970adc87c2c9e1aba7f40174fd2c1780126b444caebb2a29
 */
void chasles_angular_acceleration_matrix_batch(
    size_t count,
    const double *omega, ptrdiff_t omega_step,
    const double *omega_dot, ptrdiff_t omega_dot_step,
    double *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)omega, (char *)omega_dot, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {omega_step * size, omega_dot_step * size, W_step * size};
    const chasles_loop *loop = &chasles_angular_acceleration_matrix_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.86) chasles_angular_acceleration_matrixf for a batch.
 *   verdict: defined; assumes Q is a rotation
 *   15 operations; derivation sha256 600ac9c19e353f65970adc87c2c9e1aba7f40174fd2c1780126b444caebb2a29
 */
void chasles_angular_acceleration_matrix_batchf(
    size_t count,
    const float *omega, ptrdiff_t omega_step,
    const float *omega_dot, ptrdiff_t omega_dot_step,
    float *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)omega, (char *)omega_dot, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {omega_step * size, omega_dot_step * size, W_step * size};
    const chasles_loop *loop = &chasles_angular_acceleration_matrix_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.89) The acceleration of a point from that of the landmark, with vector products.
 *   given       omega[3]: angular velocity
 *               omega_dot[3]: time derivative of: angular velocity
 *               a_ddot[3]: second time derivative of: position of the landmark point A
 *               a[3]: position of the landmark point A
 *               p[3]: position of any point P
 *   returns     p_ddot[3]: second time derivative of: position of any point P
 *   verdict     holds
 *   assumes     nothing
 *   operations  36: 6 add, 12 subtract, 18 multiply
 *   error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 52077d75d24e72b9e016304332b02aeb13ece6765a6f5dff5b9cb8261bc6ae26
 */
void chasles_acceleration_of_point(
    const double omega[3],
    const double omega_dot[3],
    const double a_ddot[3],
    const double a[3],
    const double p[3],
    double p_ddot[3])
{
    const double t1 = p[0] - a[0];
    const double t2 = p[1] - a[1];
    const double t3 = p[2] - a[2];
    const double t4 = omega[1] * t3 - omega[2] * t2;
    const double t5 = omega[2] * t1 - omega[0] * t3;
    const double t6 = omega[0] * t2 - omega[1] * t1;
    const double t7 = a_ddot[0] + (omega_dot[1] * t3 - omega_dot[2] * t2);
    const double p_ddot0 = t7 + (omega[1] * t6 - omega[2] * t5);
    const double t8 = a_ddot[1] + (omega_dot[2] * t1 - omega_dot[0] * t3);
    const double p_ddot1 = t8 + (omega[2] * t4 - omega[0] * t6);
    const double t9 = a_ddot[2] + (omega_dot[0] * t2 - omega_dot[1] * t1);
    const double p_ddot2 = t9 + (omega[0] * t5 - omega[1] * t4);
    p_ddot[0] = p_ddot0;
    p_ddot[1] = p_ddot1;
    p_ddot[2] = p_ddot2;
}

/*
 * (3.89) chasles_acceleration_of_point in single precision.
 *   verdict: holds; assumes nothing
 *   36 operations; derivation sha256 52077d75d24e72b9e016304332b02aeb13ece6765a6f5dff5b9cb8261bc6ae26
 */
void chasles_acceleration_of_pointf(
    const float omega[3],
    const float omega_dot[3],
    const float a_ddot[3],
    const float a[3],
    const float p[3],
    float p_ddot[3])
{
    const float t1 = p[0] - a[0];
    const float t2 = p[1] - a[1];
    const float t3 = p[2] - a[2];
    const float t4 = omega[1] * t3 - omega[2] * t2;
    const float t5 = omega[2] * t1 - omega[0] * t3;
    const float t6 = omega[0] * t2 - omega[1] * t1;
    const float t7 = a_ddot[0] + (omega_dot[1] * t3 - omega_dot[2] * t2);
    const float p_ddot0 = t7 + (omega[1] * t6 - omega[2] * t5);
    const float t8 = a_ddot[1] + (omega_dot[2] * t1 - omega_dot[0] * t3);
    const float p_ddot1 = t8 + (omega[2] * t4 - omega[0] * t6);
    const float t9 = a_ddot[2] + (omega_dot[0] * t2 - omega_dot[1] * t1);
    const float p_ddot2 = t9 + (omega[0] * t5 - omega[1] * t4);
    p_ddot[0] = p_ddot0;
    p_ddot[1] = p_ddot1;
    p_ddot[2] = p_ddot2;
}

/*
 * (3.89) chasles_acceleration_of_point for a batch.
 *   verdict: holds; assumes nothing
 *   36 operations; derivation sha256 52077d75d24e72b9e016304332b02aeb13ece6765a6f5dff5b9cb8261bc6ae26
 */
void chasles_acceleration_of_point_batch(
    size_t count,
    const double *omega, ptrdiff_t omega_step,
    const double *omega_dot, ptrdiff_t omega_dot_step,
    const double *a_ddot, ptrdiff_t a_ddot_step,
    const double *a, ptrdiff_t a_step,
    const double *p, ptrdiff_t p_step,
    double *p_ddot, ptrdiff_t p_ddot_step)
{
    char *const at[] = {
        (char *)omega,
        (char *)omega_dot,
        (char *)a_ddot,
        (char *)a,
        (char *)p,
        (char *)p_ddot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        omega_step * size,
        omega_dot_step * size,
        a_ddot_step * size,
        a_step * size,
        p_step * size,
        p_ddot_step * size};
    const chasles_loop *loop = &chasles_acceleration_of_point_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.89) chasles_acceleration_of_pointf for a batch.
 *   verdict: holds; assumes nothing
 *   36 operations; derivation sha256 52077d75d24e72b9e016304332b02aeb13ece6765a6f5dff5b9cb8261bc6ae26
 */
void chasles_acceleration_of_point_batchf(
    size_t count,
    const float *omega, ptrdiff_t omega_step,
    const float *omega_dot, ptrdiff_t omega_dot_step,
    const float *a_ddot, ptrdiff_t a_ddot_step,
    const float *a, ptrdiff_t a_step,
    const float *p, ptrdiff_t p_step,
    float *p_ddot, ptrdiff_t p_ddot_step)
{
    char *const at[] = {
        (char *)omega,
        (char *)omega_dot,
        (char *)a_ddot,
        (char *)a,
        (char *)p,
        (char *)p_ddot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        omega_step * size,
        omega_dot_step * size,
        a_ddot_step * size,
        a_step * size,
        p_step * size,
        p_ddot_step * size};
    const chasles_loop *loop = &chasles_acceleration_of_point_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 f The rate of N by axis, angle and angular velocity: (3.96a).
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               omega[3]: angular velocity
 *   returns     N_dot[12]: time derivative of: natural invariants' rates from the angular velocity
 *   verdict     holds under
 *   assumes     |e| = 1
 *               phi != 0
 *   made of     an offered form, proved equal to the statement
 *   operations  70: 15 add, 12 subtract, 40 multiply, 1 divide, 1 sine, 1 cosine
 *   error bound 20.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 956e7fbe93e1ea999fe3f7edebc581c8b10e077f4393b085160cc0c68988d2d5
 */
void chasles_natural_rate_matrix_dot(
    const double e[3],
    double phi,
    const double omega[3],
    double N_dot[12])
{
    const double half_phi = 0.5 * phi;
    const double sin_half_phi = sin(half_phi);
    const double t1 = (sin_half_phi == 0.0 ? 0.0 : cos(half_phi)) / sin_half_phi;
    const double half_t1 = 0.5 * t1;
    const double t2 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2];
    const double t3 = (half_t1 * half_t1 + 0.25) * t2;
    const double t4 = 0.5 * e[0];
    const double t5 = 0.5 * e[1];
    const double t6 = 0.5 * e[2];
    const double t7 = half_t1 * (e[0] * t2 - omega[0]) + (omega[2] * t5 - omega[1] * t6);
    const double N_dot9 = -t7;
    const double t8 = half_t1 * (e[1] * t2 - omega[1]) + (omega[0] * t6 - omega[2] * t4);
    const double N_dot10 = -t8;
    const double t9 = half_t1 * (e[2] * t2 - omega[2]) + (omega[1] * t4 - omega[0] * t5);
    const double N_dot11 = -t9;
    const double t10 = e[0] * t3 + t1 * t7;
    const double t11 = e[1] * t3 + t1 * t8;
    const double t12 = e[2] * t3 + t1 * t9;
    const double half_t7 = 0.5 * t7;
    const double half_t8 = 0.5 * t8;
    const double half_t9 = 0.5 * t9;
    const double t13 = t4 * t11 + t5 * t10;
    const double t14 = t4 * t12 + t6 * t10;
    const double t15 = t5 * t12 + t6 * t11;
    const double N_dot0 = e[0] * t10 - t3;
    const double N_dot1 = t13 - half_t9;
    const double N_dot2 = half_t8 + t14;
    const double N_dot3 = half_t9 + t13;
    const double N_dot4 = e[1] * t11 - t3;
    const double N_dot5 = t15 - half_t7;
    const double N_dot6 = t14 - half_t8;
    const double N_dot7 = half_t7 + t15;
    const double N_dot8 = e[2] * t12 - t3;
    N_dot[0] = N_dot0;
    N_dot[1] = N_dot1;
    N_dot[2] = N_dot2;
    N_dot[3] = N_dot3;
    N_dot[4] = N_dot4;
    N_dot[5] = N_dot5;
    N_dot[6] = N_dot6;
    N_dot[7] = N_dot7;
    N_dot[8] = N_dot8;
    N_dot[9] = N_dot9;
    N_dot[10] = N_dot10;
    N_dot[11] = N_dot11;
}

/*
 * text 3.5 f chasles_natural_rate_matrix_dot in single precision.
 *   verdict: holds under; assumes |e| = 1, phi != 0
 *   70 operations; derivation sha256 956e7fbe93e1ea999fe3f7edebc581c8b10e077f4393b085160cc0c68988d2d5
 */
void chasles_natural_rate_matrix_dotf(
    const float e[3],
    float phi,
    const float omega[3],
    float N_dot[12])
{
    const float half_phi = 0.5f * phi;
    const float sin_half_phi = sinf(half_phi);
    const float t1 = (sin_half_phi == 0.0f ? 0.0f : cosf(half_phi)) / sin_half_phi;
    const float half_t1 = 0.5f * t1;
    const float t2 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2];
    const float t3 = (half_t1 * half_t1 + 0.25f) * t2;
    const float t4 = 0.5f * e[0];
    const float t5 = 0.5f * e[1];
    const float t6 = 0.5f * e[2];
    const float t7 = half_t1 * (e[0] * t2 - omega[0]) + (omega[2] * t5 - omega[1] * t6);
    const float N_dot9 = -t7;
    const float t8 = half_t1 * (e[1] * t2 - omega[1]) + (omega[0] * t6 - omega[2] * t4);
    const float N_dot10 = -t8;
    const float t9 = half_t1 * (e[2] * t2 - omega[2]) + (omega[1] * t4 - omega[0] * t5);
    const float N_dot11 = -t9;
    const float t10 = e[0] * t3 + t1 * t7;
    const float t11 = e[1] * t3 + t1 * t8;
    const float t12 = e[2] * t3 + t1 * t9;
    const float half_t7 = 0.5f * t7;
    const float half_t8 = 0.5f * t8;
    const float half_t9 = 0.5f * t9;
    const float t13 = t4 * t11 + t5 * t10;
    const float t14 = t4 * t12 + t6 * t10;
    const float t15 = t5 * t12 + t6 * t11;
    const float N_dot0 = e[0] * t10 - t3;
    const float N_dot1 = t13 - half_t9;
    const float N_dot2 = half_t8 + t14;
    const float N_dot3 = half_t9 + t13;
    const float N_dot4 = e[1] * t11 - t3;
    const float N_dot5 = t15 - half_t7;
    const float N_dot6 = t14 - half_t8;
    const float N_dot7 = half_t7 + t15;
    const float N_dot8 = e[2] * t12 - t3;
    N_dot[0] = N_dot0;
    N_dot[1] = N_dot1;
    N_dot[2] = N_dot2;
    N_dot[3] = N_dot3;
    N_dot[4] = N_dot4;
    N_dot[5] = N_dot5;
    N_dot[6] = N_dot6;
    N_dot[7] = N_dot7;
    N_dot[8] = N_dot8;
    N_dot[9] = N_dot9;
    N_dot[10] = N_dot10;
    N_dot[11] = N_dot11;
}

/*
 * text 3.5 f chasles_natural_rate_matrix_dot for a batch.
 *   verdict: holds under; assumes |e| = 1, phi != 0
 *   70 operations; derivation sha256 956e7fbe93e1ea999fe3f7edebc581c8b10e077f4393b085160cc0c68988d2d5
 */
void chasles_natural_rate_matrix_dot_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *omega, ptrdiff_t omega_step,
    double *N_dot, ptrdiff_t N_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)omega, (char *)N_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, omega_step * size, N_dot_step * size};
    const chasles_loop *loop = &chasles_natural_rate_matrix_dot_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 f chasles_natural_rate_matrix_dotf for a batch.
 *   verdict: holds under; assumes |e| = 1, phi != 0
 *   70 operations; derivation sha256 956e7fbe93e1ea999fe3f7edebc581c8b10e077f4393b085160cc0c68988d2d5
 */
void chasles_natural_rate_matrix_dot_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *omega, ptrdiff_t omega_step,
    float *N_dot, ptrdiff_t N_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)omega, (char *)N_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, omega_step * size, N_dot_step * size};
    const chasles_loop *loop = &chasles_natural_rate_matrix_dot_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 f The rate of L by axis, angle and angular velocity: (3.96b).
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               omega[3]: angular velocity
 *   returns     L_dot[12]: time derivative of: linear invariants' rates from the angular velocity
 *   verdict     holds under
 *   assumes     |e| = 1
 *   made of     an offered form, proved equal to the statement
 *   operations  73: 12 add, 16 subtract, 43 multiply, 1 sine, 1 cosine
 *   error bound 10.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 e58c3cd056fca600a3d8fabc77cc08383708b30fcd3f10997c5760ad3d813719
 */
void chasles_linear_rate_matrix_dot(
    const double e[3],
    double phi,
    const double omega[3],
    double L_dot[12])
{
    const double t1 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2];
    const double t2 = 0.5 * sin(phi);
    const double t3 = t1 * t2;
    const double t4 = e[1] * omega[2] - e[2] * omega[1];
    const double t5 = e[2] * omega[0] - e[0] * omega[2];
    const double t6 = e[0] * omega[1] - e[1] * omega[0];
    const double t7 = 0.5 * cos(phi);
    const double t8 = 0.5 - t7;
    const double t9 = omega[0] * t2 - t4 * t8;
    const double t10 = omega[1] * t2 - t5 * t8;
    const double t11 = omega[2] * t2 - t6 * t8;
    const double t12 = 0.5 + t7;
    const double t13 = t1 * t8;
    const double t14 = omega[0] * t12 - e[0] * t13 - t2 * t4;
    const double t15 = omega[1] * t12 - e[1] * t13 - t2 * t5;
    const double t16 = omega[2] * t12 - e[2] * t13 - t2 * t6;
    const double half_t14 = 0.5 * t14;
    const double half_t15 = 0.5 * t15;
    const double half_t16 = 0.5 * t16;
    const double t17 = 0.5 * e[0];
    const double t18 = 0.5 * e[1];
    const double t19 = 0.5 * e[2];
    const double t20 = t10 * t17 + t9 * t18;
    const double t21 = t11 * t17 + t9 * t19;
    const double t22 = t11 * t18 + t10 * t19;
    const double L_dot0 = -(t3 + e[0] * t9);
    const double L_dot1 = half_t16 - t20;
    const double L_dot2 = -(half_t15 + t21);
    const double L_dot3 = -(half_t16 + t20);
    const double L_dot4 = -(t3 + e[1] * t10);
    const double L_dot5 = half_t14 - t22;
    const double L_dot6 = half_t15 - t21;
    const double L_dot7 = -(half_t14 + t22);
    const double L_dot8 = -(t3 + e[2] * t11);
    const double L_dot9 = -t14;
    const double L_dot10 = -t15;
    const double L_dot11 = -t16;
    L_dot[0] = L_dot0;
    L_dot[1] = L_dot1;
    L_dot[2] = L_dot2;
    L_dot[3] = L_dot3;
    L_dot[4] = L_dot4;
    L_dot[5] = L_dot5;
    L_dot[6] = L_dot6;
    L_dot[7] = L_dot7;
    L_dot[8] = L_dot8;
    L_dot[9] = L_dot9;
    L_dot[10] = L_dot10;
    L_dot[11] = L_dot11;
}

/*
 * text 3.5 f chasles_linear_rate_matrix_dot in single precision.
 *   verdict: holds under; assumes |e| = 1
 *   73 operations; derivation sha256 e58c3cd056fca600a3d8fabc77cc08383708b30fcd3f10997c5760ad3d813719
 */
void chasles_linear_rate_matrix_dotf(
    const float e[3],
    float phi,
    const float omega[3],
    float L_dot[12])
{
    const float t1 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2];
    const float t2 = 0.5f * sinf(phi);
    const float t3 = t1 * t2;
    const float t4 = e[1] * omega[2] - e[2] * omega[1];
    const float t5 = e[2] * omega[0] - e[0] * omega[2];
    const float t6 = e[0] * omega[1] - e[1] * omega[0];
    const float t7 = 0.5f * cosf(phi);
    const float t8 = 0.5f - t7;
    const float t9 = omega[0] * t2 - t4 * t8;
    const float t10 = omega[1] * t2 - t5 * t8;
    const float t11 = omega[2] * t2 - t6 * t8;
    const float t12 = 0.5f + t7;
    const float t13 = t1 * t8;
    const float t14 = omega[0] * t12 - e[0] * t13 - t2 * t4;
    const float t15 = omega[1] * t12 - e[1] * t13 - t2 * t5;
    const float t16 = omega[2] * t12 - e[2] * t13 - t2 * t6;
    const float half_t14 = 0.5f * t14;
    const float half_t15 = 0.5f * t15;
    const float half_t16 = 0.5f * t16;
    const float t17 = 0.5f * e[0];
    const float t18 = 0.5f * e[1];
    const float t19 = 0.5f * e[2];
    const float t20 = t10 * t17 + t9 * t18;
    const float t21 = t11 * t17 + t9 * t19;
    const float t22 = t11 * t18 + t10 * t19;
    const float L_dot0 = -(t3 + e[0] * t9);
    const float L_dot1 = half_t16 - t20;
    const float L_dot2 = -(half_t15 + t21);
    const float L_dot3 = -(half_t16 + t20);
    const float L_dot4 = -(t3 + e[1] * t10);
    const float L_dot5 = half_t14 - t22;
    const float L_dot6 = half_t15 - t21;
    const float L_dot7 = -(half_t14 + t22);
    const float L_dot8 = -(t3 + e[2] * t11);
    const float L_dot9 = -t14;
    const float L_dot10 = -t15;
    const float L_dot11 = -t16;
    L_dot[0] = L_dot0;
    L_dot[1] = L_dot1;
    L_dot[2] = L_dot2;
    L_dot[3] = L_dot3;
    L_dot[4] = L_dot4;
    L_dot[5] = L_dot5;
    L_dot[6] = L_dot6;
    L_dot[7] = L_dot7;
    L_dot[8] = L_dot8;
    L_dot[9] = L_dot9;
    L_dot[10] = L_dot10;
    L_dot[11] = L_dot11;
}

/*
 * text 3.5 f chasles_linear_rate_matrix_dot for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   73 operations; derivation sha256 e58c3cd056fca600a3d8fabc77cc08383708b30fcd3f10997c5760ad3d813719
 */
void chasles_linear_rate_matrix_dot_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *omega, ptrdiff_t omega_step,
    double *L_dot, ptrdiff_t L_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)omega, (char *)L_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, omega_step * size, L_dot_step * size};
    const chasles_loop *loop = &chasles_linear_rate_matrix_dot_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 f chasles_linear_rate_matrix_dotf for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   73 operations; derivation sha256 e58c3cd056fca600a3d8fabc77cc08383708b30fcd3f10997c5760ad3d813719
 */
void chasles_linear_rate_matrix_dot_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *omega, ptrdiff_t omega_step,
    float *L_dot, ptrdiff_t L_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)omega, (char *)L_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, omega_step * size, L_dot_step * size};
    const chasles_loop *loop = &chasles_linear_rate_matrix_dot_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 f The rate of H by axis, angle and angular velocity: (3.96c).
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               omega[3]: angular velocity
 *   returns     H_dot[12]: time derivative of: Euler-Rodrigues parameters' rates from the angular
 *                 velocity
 *   verdict     holds under
 *   assumes     |e| = 1
 *   made of     an offered form, proved equal to the statement
 *   operations  28: 2 add, 6 subtract, 18 multiply, 1 sine, 1 cosine
 *   error bound 5.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 cbbc7c4a0ec6ff7289faa80a566dfa4879a785dc3e1fcb665d781015958b3b92
 */
void chasles_euler_rodrigues_rate_matrix_dot(
    const double e[3],
    double phi,
    const double omega[3],
    double H_dot[12])
{
    const double half_phi = 0.5 * phi;
    const double t1 = 0.25 * sin(half_phi);
    const double t2 = e[0] * t1;
    const double t3 = e[1] * t1;
    const double t4 = e[2] * t1;
    const double H_dot0 = -(omega[0] * t2 + omega[1] * t3 + omega[2] * t4);
    const double t5 = 0.25 * cos(half_phi);
    const double H_dot5 = omega[0] * t5 - (omega[2] * t3 - omega[1] * t4);
    const double H_dot6 = omega[1] * t5 - (omega[0] * t4 - omega[2] * t2);
    const double H_dot1 = omega[2] * t5 - (omega[1] * t2 - omega[0] * t3);
    const double H_dot7 = -H_dot5;
    const double H_dot2 = -H_dot6;
    const double H_dot3 = -H_dot1;
    H_dot[0] = H_dot0;
    H_dot[1] = H_dot1;
    H_dot[2] = H_dot2;
    H_dot[3] = H_dot3;
    H_dot[4] = H_dot0;
    H_dot[5] = H_dot5;
    H_dot[6] = H_dot6;
    H_dot[7] = H_dot7;
    H_dot[8] = H_dot0;
    H_dot[9] = H_dot7;
    H_dot[10] = H_dot2;
    H_dot[11] = H_dot3;
}

/*
 * text 3.5 f chasles_euler_rodrigues_rate_matrix_dot in single precision.
 *   verdict: holds under; assumes |e| = 1
 *   28 operations; derivation sha256 cbbc7c4a0ec6ff7289faa80a566dfa4879a785dc3e1fcb665d781015958b3b92
 */
void chasles_euler_rodrigues_rate_matrix_dotf(
    const float e[3],
    float phi,
    const float omega[3],
    float H_dot[12])
{
    const float half_phi = 0.5f * phi;
    const float t1 = 0.25f * sinf(half_phi);
    const float t2 = e[0] * t1;
    const float t3 = e[1] * t1;
    const float t4 = e[2] * t1;
    const float H_dot0 = -(omega[0] * t2 + omega[1] * t3 + omega[2] * t4);
    const float t5 = 0.25f * cosf(half_phi);
    const float H_dot5 = omega[0] * t5 - (omega[2] * t3 - omega[1] * t4);
    const float H_dot6 = omega[1] * t5 - (omega[0] * t4 - omega[2] * t2);
    const float H_dot1 = omega[2] * t5 - (omega[1] * t2 - omega[0] * t3);
    const float H_dot7 = -H_dot5;
    const float H_dot2 = -H_dot6;
    const float H_dot3 = -H_dot1;
    H_dot[0] = H_dot0;
    H_dot[1] = H_dot1;
    H_dot[2] = H_dot2;
    H_dot[3] = H_dot3;
    H_dot[4] = H_dot0;
    H_dot[5] = H_dot5;
    H_dot[6] = H_dot6;
    H_dot[7] = H_dot7;
    H_dot[8] = H_dot0;
    H_dot[9] = H_dot7;
    H_dot[10] = H_dot2;
    H_dot[11] = H_dot3;
}

/*
 * text 3.5 f chasles_euler_rodrigues_rate_matrix_dot for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   28 operations; derivation sha256 cbbc7c4a0ec6ff7289faa80a566dfa4879a785dc3e1fcb665d781015958b3b92
 */
void chasles_euler_rodrigues_rate_matrix_dot_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *omega, ptrdiff_t omega_step,
    double *H_dot, ptrdiff_t H_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)omega, (char *)H_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, omega_step * size, H_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rodrigues_rate_matrix_dot_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 f chasles_euler_rodrigues_rate_matrix_dotf for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   28 operations; derivation sha256 cbbc7c4a0ec6ff7289faa80a566dfa4879a785dc3e1fcb665d781015958b3b92
 */
void chasles_euler_rodrigues_rate_matrix_dot_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *omega, ptrdiff_t omega_step,
    float *H_dot, ptrdiff_t H_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)omega, (char *)H_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, omega_step * size, H_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rodrigues_rate_matrix_dot_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 g The rate of the left inverse of N by axis, angle and angular velocity: (3.97a).
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               omega[3]: angular velocity
 *   returns     N_tilde_dot[12]: time derivative of: angular velocity from the natural invariants'
 *                 rates
 *   verdict     holds under
 *   assumes     phi != 0
 *               |e| = 1
 *   operations  55: 8 add, 10 subtract, 34 multiply, 1 divide, 1 sine, 1 cosine
 *   error bound 11.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 71e01d77b3ea46f745a9336a2825937c48ecfb5c8f22e156a02b1d41218c2c74
 */
void chasles_natural_velocity_matrix_dot(
    const double e[3],
    double phi,
    const double omega[3],
    double N_tilde_dot[12])
{
    const double t1 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2];
    const double half_phi = 0.5 * phi;
    const double sin_half_phi = sin(half_phi);
    const double t2 = sin_half_phi * sin_half_phi;
    const double N_tilde_dot0 = t1 * (1.0 - 2.0 * t2);
    const double cos_half_phi = cos(half_phi);
    const double t3 = sin_half_phi * cos_half_phi;
    const double t4 = t1 * t3;
    const double t5 = e[1] * omega[2] - e[2] * omega[1];
    const double t6 = e[2] * omega[0] - e[0] * omega[2];
    const double t7 = e[0] * omega[1] - e[1] * omega[0];
    const double N_tilde_dot9 = e[0] * t4 + (omega[0] * t3 - t2 * t5);
    const double N_tilde_dot2 = e[1] * t4 + (omega[1] * t3 - t2 * t6);
    const double N_tilde_dot4 = e[2] * t4 + (omega[2] * t3 - t2 * t7);
    const double N_tilde_dot1 = -N_tilde_dot4;
    const double N_tilde_dot6 = -N_tilde_dot9;
    const double N_tilde_dot8 = -N_tilde_dot2;
    const double t8 = 0.5 * ((sin_half_phi == 0.0 ? 0.0 : cos_half_phi) / sin_half_phi);
    const double N_tilde_dot3 = -((e[0] * t1 - omega[0]) * t8 + 0.5 * t5);
    const double N_tilde_dot7 = -((e[1] * t1 - omega[1]) * t8 + 0.5 * t6);
    const double N_tilde_dot11 = -((e[2] * t1 - omega[2]) * t8 + 0.5 * t7);
    N_tilde_dot[0] = N_tilde_dot0;
    N_tilde_dot[1] = N_tilde_dot1;
    N_tilde_dot[2] = N_tilde_dot2;
    N_tilde_dot[3] = N_tilde_dot3;
    N_tilde_dot[4] = N_tilde_dot4;
    N_tilde_dot[5] = N_tilde_dot0;
    N_tilde_dot[6] = N_tilde_dot6;
    N_tilde_dot[7] = N_tilde_dot7;
    N_tilde_dot[8] = N_tilde_dot8;
    N_tilde_dot[9] = N_tilde_dot9;
    N_tilde_dot[10] = N_tilde_dot0;
    N_tilde_dot[11] = N_tilde_dot11;
}

/*
 * text 3.5 g chasles_natural_velocity_matrix_dot in single precision.
 *   verdict: holds under; assumes phi != 0, |e| = 1
 *   55 operations; derivation sha256 71e01d77b3ea46f745a9336a2825937c48ecfb5c8f22e156a02b1d41218c2c74
 */
void chasles_natural_velocity_matrix_dotf(
    const float e[3],
    float phi,
    const float omega[3],
    float N_tilde_dot[12])
{
    const float t1 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2];
    const float half_phi = 0.5f * phi;
    const float sin_half_phi = sinf(half_phi);
    const float t2 = sin_half_phi * sin_half_phi;
    const float N_tilde_dot0 = t1 * (1.0f - 2.0f * t2);
    const float cos_half_phi = cosf(half_phi);
    const float t3 = sin_half_phi * cos_half_phi;
    const float t4 = t1 * t3;
    const float t5 = e[1] * omega[2] - e[2] * omega[1];
    const float t6 = e[2] * omega[0] - e[0] * omega[2];
    const float t7 = e[0] * omega[1] - e[1] * omega[0];
    const float N_tilde_dot9 = e[0] * t4 + (omega[0] * t3 - t2 * t5);
    const float N_tilde_dot2 = e[1] * t4 + (omega[1] * t3 - t2 * t6);
    const float N_tilde_dot4 = e[2] * t4 + (omega[2] * t3 - t2 * t7);
    const float N_tilde_dot1 = -N_tilde_dot4;
    const float N_tilde_dot6 = -N_tilde_dot9;
    const float N_tilde_dot8 = -N_tilde_dot2;
    const float t8 = 0.5f * ((sin_half_phi == 0.0f ? 0.0f : cos_half_phi) / sin_half_phi);
    const float N_tilde_dot3 = -((e[0] * t1 - omega[0]) * t8 + 0.5f * t5);
    const float N_tilde_dot7 = -((e[1] * t1 - omega[1]) * t8 + 0.5f * t6);
    const float N_tilde_dot11 = -((e[2] * t1 - omega[2]) * t8 + 0.5f * t7);
    N_tilde_dot[0] = N_tilde_dot0;
    N_tilde_dot[1] = N_tilde_dot1;
    N_tilde_dot[2] = N_tilde_dot2;
    N_tilde_dot[3] = N_tilde_dot3;
    N_tilde_dot[4] = N_tilde_dot4;
    N_tilde_dot[5] = N_tilde_dot0;
    N_tilde_dot[6] = N_tilde_dot6;
    N_tilde_dot[7] = N_tilde_dot7;
    N_tilde_dot[8] = N_tilde_dot8;
    N_tilde_dot[9] = N_tilde_dot9;
    N_tilde_dot[10] = N_tilde_dot0;
    N_tilde_dot[11] = N_tilde_dot11;
}

/*
 * text 3.5 g chasles_natural_velocity_matrix_dot for a batch.
 *   verdict: holds under; assumes phi != 0, |e| = 1
 *   55 operations; derivation sha256 71e01d77b3ea46f745a9336a2825937c48ecfb5c8f22e156a02b1d41218c2c74
 */
void chasles_natural_velocity_matrix_dot_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *omega, ptrdiff_t omega_step,
    double *N_tilde_dot, ptrdiff_t N_tilde_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)omega, (char *)N_tilde_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        omega_step * size,
        N_tilde_dot_step * size};
    const chasles_loop *loop = &chasles_natural_velocity_matrix_dot_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 g chasles_natural_velocity_matrix_dotf for a batch.
 *   verdict: holds under; assumes phi != 0, |e| = 1
 *   55 operations; derivation sha256 71e01d77b3ea46f745a9336a2825937c48ecfb5c8f22e156a02b1d41218c2c74
 */
void chasles_natural_velocity_matrix_dot_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *omega, ptrdiff_t omega_step,
    float *N_tilde_dot, ptrdiff_t N_tilde_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)omega, (char *)N_tilde_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        omega_step * size,
        N_tilde_dot_step * size};
    const chasles_loop *loop = &chasles_natural_velocity_matrix_dot_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 g The rate of the left inverse of L by axis, angle and angular velocity: (3.97b).
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               omega[3]: angular velocity
 *   returns     L_tilde_dot[12]: time derivative of: angular velocity from the linear invariants'
 *                 rates
 *   verdict     holds under
 *   assumes     |e| = 1
 *               phi != pi
 *   operations  34: 5 add, 6 subtract, 20 multiply, 1 divide, 1 sine, 1 cosine
 *   error bound 16.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 b5286c2c91a7b4cfdc8d341b90ed08a2a37fc92a9f25530860458e82f6eaacf3
 */
void chasles_linear_velocity_matrix_dot(
    const double e[3],
    double phi,
    const double omega[3],
    double L_tilde_dot[12])
{
    const double half_phi = 0.5 * phi;
    const double cos_half_phi = cos(half_phi);
    const double t1 = (cos_half_phi == 0.0 ? 0.0 : sin(half_phi)) / cos_half_phi;
    const double t2 = e[0] * t1;
    const double t3 = e[1] * t1;
    const double t4 = e[2] * t1;
    const double t5 = t1 * (omega[0] * t2 + omega[1] * t3 + omega[2] * t4);
    const double L_tilde_dot9 = 0.5 * (omega[0] + e[0] * t5 - (omega[2] * t3 - omega[1] * t4));
    const double L_tilde_dot2 = 0.5 * (omega[1] + e[1] * t5 - (omega[0] * t4 - omega[2] * t2));
    const double L_tilde_dot4 = 0.5 * (omega[2] + e[2] * t5 - (omega[1] * t2 - omega[0] * t3));
    const double L_tilde_dot1 = -L_tilde_dot4;
    const double L_tilde_dot3 = -L_tilde_dot9;
    const double L_tilde_dot7 = -L_tilde_dot2;
    L_tilde_dot[0] = 0.0;
    L_tilde_dot[1] = L_tilde_dot1;
    L_tilde_dot[2] = L_tilde_dot2;
    L_tilde_dot[3] = L_tilde_dot3;
    L_tilde_dot[4] = L_tilde_dot4;
    L_tilde_dot[5] = 0.0;
    L_tilde_dot[6] = L_tilde_dot3;
    L_tilde_dot[7] = L_tilde_dot7;
    L_tilde_dot[8] = L_tilde_dot7;
    L_tilde_dot[9] = L_tilde_dot9;
    L_tilde_dot[10] = 0.0;
    L_tilde_dot[11] = L_tilde_dot1;
}

/*
 * text 3.5 g chasles_linear_velocity_matrix_dot in single precision.
 *   verdict: holds under; assumes |e| = 1, phi != pi
 *   34 operations; derivation sha256 b5286c2c91a7b4cfdc8d341b90ed08a2a37fc92a9f25530860458e82f6eaacf3
 */
void chasles_linear_velocity_matrix_dotf(
    const float e[3],
    float phi,
    const float omega[3],
    float L_tilde_dot[12])
{
    const float half_phi = 0.5f * phi;
    const float cos_half_phi = cosf(half_phi);
    const float t1 = (cos_half_phi == 0.0f ? 0.0f : sinf(half_phi)) / cos_half_phi;
    const float t2 = e[0] * t1;
    const float t3 = e[1] * t1;
    const float t4 = e[2] * t1;
    const float t5 = t1 * (omega[0] * t2 + omega[1] * t3 + omega[2] * t4);
    const float L_tilde_dot9 = 0.5f * (omega[0] + e[0] * t5 - (omega[2] * t3 - omega[1] * t4));
    const float L_tilde_dot2 = 0.5f * (omega[1] + e[1] * t5 - (omega[0] * t4 - omega[2] * t2));
    const float L_tilde_dot4 = 0.5f * (omega[2] + e[2] * t5 - (omega[1] * t2 - omega[0] * t3));
    const float L_tilde_dot1 = -L_tilde_dot4;
    const float L_tilde_dot3 = -L_tilde_dot9;
    const float L_tilde_dot7 = -L_tilde_dot2;
    L_tilde_dot[0] = 0.0f;
    L_tilde_dot[1] = L_tilde_dot1;
    L_tilde_dot[2] = L_tilde_dot2;
    L_tilde_dot[3] = L_tilde_dot3;
    L_tilde_dot[4] = L_tilde_dot4;
    L_tilde_dot[5] = 0.0f;
    L_tilde_dot[6] = L_tilde_dot3;
    L_tilde_dot[7] = L_tilde_dot7;
    L_tilde_dot[8] = L_tilde_dot7;
    L_tilde_dot[9] = L_tilde_dot9;
    L_tilde_dot[10] = 0.0f;
    L_tilde_dot[11] = L_tilde_dot1;
}

/*
 * text 3.5 g chasles_linear_velocity_matrix_dot for a batch.
 *   verdict: holds under; assumes |e| = 1, phi != pi
 *   34 operations; derivation sha256 b5286c2c91a7b4cfdc8d341b90ed08a2a37fc92a9f25530860458e82f6eaacf3
 */
void chasles_linear_velocity_matrix_dot_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *omega, ptrdiff_t omega_step,
    double *L_tilde_dot, ptrdiff_t L_tilde_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)omega, (char *)L_tilde_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        omega_step * size,
        L_tilde_dot_step * size};
    const chasles_loop *loop = &chasles_linear_velocity_matrix_dot_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 g chasles_linear_velocity_matrix_dotf for a batch.
 *   verdict: holds under; assumes |e| = 1, phi != pi
 *   34 operations; derivation sha256 b5286c2c91a7b4cfdc8d341b90ed08a2a37fc92a9f25530860458e82f6eaacf3
 */
void chasles_linear_velocity_matrix_dot_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *omega, ptrdiff_t omega_step,
    float *L_tilde_dot, ptrdiff_t L_tilde_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)omega, (char *)L_tilde_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        omega_step * size,
        L_tilde_dot_step * size};
    const chasles_loop *loop = &chasles_linear_velocity_matrix_dot_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 g The rate of the left inverse of H by axis, angle and angular velocity: (3.97c).
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               omega[3]: angular velocity
 *   returns     H_tilde_dot[12]: time derivative of: angular velocity from the Euler-Rodrigues
 *                 parameters' rates
 *   verdict     holds under
 *   assumes     |e| = 1
 *   operations  26: 2 add, 6 subtract, 16 multiply, 1 sine, 1 cosine
 *   error bound 5.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 c80e798e741899e2d32fd6b3e16a5b786d0f82ee47987a537c4755eed1b60850
 */
void chasles_euler_rodrigues_velocity_matrix_dot(
    const double e[3],
    double phi,
    const double omega[3],
    double H_tilde_dot[12])
{
    const double half_phi = 0.5 * phi;
    const double sin_half_phi = sin(half_phi);
    const double t1 = e[0] * sin_half_phi;
    const double t2 = e[1] * sin_half_phi;
    const double t3 = e[2] * sin_half_phi;
    const double cos_half_phi = cos(half_phi);
    const double H_tilde_dot9 = omega[0] * cos_half_phi - (omega[2] * t2 - omega[1] * t3);
    const double H_tilde_dot2 = omega[1] * cos_half_phi - (omega[0] * t3 - omega[2] * t1);
    const double H_tilde_dot4 = omega[2] * cos_half_phi - (omega[1] * t1 - omega[0] * t2);
    const double H_tilde_dot0 = -(omega[0] * t1 + omega[1] * t2 + omega[2] * t3);
    const double H_tilde_dot1 = -H_tilde_dot4;
    const double H_tilde_dot3 = -H_tilde_dot9;
    const double H_tilde_dot7 = -H_tilde_dot2;
    H_tilde_dot[0] = H_tilde_dot0;
    H_tilde_dot[1] = H_tilde_dot1;
    H_tilde_dot[2] = H_tilde_dot2;
    H_tilde_dot[3] = H_tilde_dot3;
    H_tilde_dot[4] = H_tilde_dot4;
    H_tilde_dot[5] = H_tilde_dot0;
    H_tilde_dot[6] = H_tilde_dot3;
    H_tilde_dot[7] = H_tilde_dot7;
    H_tilde_dot[8] = H_tilde_dot7;
    H_tilde_dot[9] = H_tilde_dot9;
    H_tilde_dot[10] = H_tilde_dot0;
    H_tilde_dot[11] = H_tilde_dot1;
}

/*
 * text 3.5 g chasles_euler_rodrigues_velocity_matrix_dot in single precision.
 *   verdict: holds under; assumes |e| = 1
 *   26 operations; derivation sha256 c80e798e741899e2d32fd6b3e16a5b786d0f82ee47987a537c4755eed1b60850
 */
void chasles_euler_rodrigues_velocity_matrix_dotf(
    const float e[3],
    float phi,
    const float omega[3],
    float H_tilde_dot[12])
{
    const float half_phi = 0.5f * phi;
    const float sin_half_phi = sinf(half_phi);
    const float t1 = e[0] * sin_half_phi;
    const float t2 = e[1] * sin_half_phi;
    const float t3 = e[2] * sin_half_phi;
    const float cos_half_phi = cosf(half_phi);
    const float H_tilde_dot9 = omega[0] * cos_half_phi - (omega[2] * t2 - omega[1] * t3);
    const float H_tilde_dot2 = omega[1] * cos_half_phi - (omega[0] * t3 - omega[2] * t1);
    const float H_tilde_dot4 = omega[2] * cos_half_phi - (omega[1] * t1 - omega[0] * t2);
    const float H_tilde_dot0 = -(omega[0] * t1 + omega[1] * t2 + omega[2] * t3);
    const float H_tilde_dot1 = -H_tilde_dot4;
    const float H_tilde_dot3 = -H_tilde_dot9;
    const float H_tilde_dot7 = -H_tilde_dot2;
    H_tilde_dot[0] = H_tilde_dot0;
    H_tilde_dot[1] = H_tilde_dot1;
    H_tilde_dot[2] = H_tilde_dot2;
    H_tilde_dot[3] = H_tilde_dot3;
    H_tilde_dot[4] = H_tilde_dot4;
    H_tilde_dot[5] = H_tilde_dot0;
    H_tilde_dot[6] = H_tilde_dot3;
    H_tilde_dot[7] = H_tilde_dot7;
    H_tilde_dot[8] = H_tilde_dot7;
    H_tilde_dot[9] = H_tilde_dot9;
    H_tilde_dot[10] = H_tilde_dot0;
    H_tilde_dot[11] = H_tilde_dot1;
}

/*
 * text 3.5 g chasles_euler_rodrigues_velocity_matrix_dot for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   26 operations; derivation sha256 c80e798e741899e2d32fd6b3e16a5b786d0f82ee47987a537c4755eed1b60850
 */
void chasles_euler_rodrigues_velocity_matrix_dot_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *omega, ptrdiff_t omega_step,
    double *H_tilde_dot, ptrdiff_t H_tilde_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)omega, (char *)H_tilde_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        omega_step * size,
        H_tilde_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rodrigues_velocity_matrix_dot_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 g chasles_euler_rodrigues_velocity_matrix_dotf for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   26 operations; derivation sha256 c80e798e741899e2d32fd6b3e16a5b786d0f82ee47987a537c4755eed1b60850
 */
void chasles_euler_rodrigues_velocity_matrix_dot_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *omega, ptrdiff_t omega_step,
    float *H_tilde_dot, ptrdiff_t H_tilde_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)omega, (char *)H_tilde_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        omega_step * size,
        H_tilde_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rodrigues_velocity_matrix_dot_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 h The second rate of the pose from the twist and its rate, with the natural invariants.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *               t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   returns     s_ddot[7]: second time derivative of: pose array
 *   verdict     holds under
 *   assumes     |e| = 1
 *               phi != 0
 *   made of     an offered form, proved equal to the statement
 *   operations  96: 19 add, 19 subtract, 55 multiply, 1 divide, 1 sine, 1 cosine
 *   error bound 25.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 4063df423497b2a63464c14082ba023d497a45f17209d99f956cc810ce8006b6
 */
void chasles_pose_acceleration_natural(
    const double e[3],
    double phi,
    const double t[6],
    const double t_dot[6],
    double s_ddot[7])
{
    const double s_ddot4 = t_dot[3];
    const double s_ddot5 = t_dot[4];
    const double s_ddot6 = t_dot[5];
    const double t1 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
    const double t2 = e[0] * t1 - t[0];
    const double t3 = e[1] * t1 - t[1];
    const double t4 = e[2] * t1 - t[2];
    const double half_phi = 0.5 * phi;
    const double sin_half_phi = sin(half_phi);
    const double t5 = 0.5 * ((sin_half_phi == 0.0 ? 0.0 : cos(half_phi)) / sin_half_phi);
    const double t6 = t2 * t5 + 0.5 * (e[1] * t[2] - e[2] * t[1]);
    const double t7 = t3 * t5 + 0.5 * (e[2] * t[0] - e[0] * t[2]);
    const double t8 = t4 * t5 + 0.5 * (e[0] * t[1] - e[1] * t[0]);
    const double t9 = e[0] * t_dot[0] + e[1] * t_dot[1] + e[2] * t_dot[2];
    const double s_ddot3 = t9 - (t[0] * t6 + t[1] * t7 + t[2] * t8);
    const double t10 = t1 * (t5 * t5 + 0.25);
    const double t11 = 0.5 * (e[1] * t_dot[2] - e[2] * t_dot[1] + (t[1] * t8 - t[2] * t7));
    const double s_ddot0 = t5 * (t_dot[0] - e[0] * s_ddot3 + t1 * t6) + t2 * t10 - t11;
    const double t12 = 0.5 * (e[2] * t_dot[0] - e[0] * t_dot[2] + (t[2] * t6 - t[0] * t8));
    const double s_ddot1 = t5 * (t_dot[1] - e[1] * s_ddot3 + t1 * t7) + t3 * t10 - t12;
    const double t13 = 0.5 * (e[0] * t_dot[1] - e[1] * t_dot[0] + (t[0] * t7 - t[1] * t6));
    const double s_ddot2 = t5 * (t_dot[2] - e[2] * s_ddot3 + t1 * t8) + t4 * t10 - t13;
    s_ddot[0] = s_ddot0;
    s_ddot[1] = s_ddot1;
    s_ddot[2] = s_ddot2;
    s_ddot[3] = s_ddot3;
    s_ddot[4] = s_ddot4;
    s_ddot[5] = s_ddot5;
    s_ddot[6] = s_ddot6;
}

/*
 * text 3.5 h chasles_pose_acceleration_natural in single precision.
 *   verdict: holds under; assumes |e| = 1, phi != 0
 *   96 operations; derivation sha256 4063df423497b2a63464c14082ba023d497a45f17209d99f956cc810ce8006b6
 */
void chasles_pose_acceleration_naturalf(
    const float e[3],
    float phi,
    const float t[6],
    const float t_dot[6],
    float s_ddot[7])
{
    const float s_ddot4 = t_dot[3];
    const float s_ddot5 = t_dot[4];
    const float s_ddot6 = t_dot[5];
    const float t1 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
    const float t2 = e[0] * t1 - t[0];
    const float t3 = e[1] * t1 - t[1];
    const float t4 = e[2] * t1 - t[2];
    const float half_phi = 0.5f * phi;
    const float sin_half_phi = sinf(half_phi);
    const float t5 = 0.5f * ((sin_half_phi == 0.0f ? 0.0f : cosf(half_phi)) / sin_half_phi);
    const float t6 = t2 * t5 + 0.5f * (e[1] * t[2] - e[2] * t[1]);
    const float t7 = t3 * t5 + 0.5f * (e[2] * t[0] - e[0] * t[2]);
    const float t8 = t4 * t5 + 0.5f * (e[0] * t[1] - e[1] * t[0]);
    const float t9 = e[0] * t_dot[0] + e[1] * t_dot[1] + e[2] * t_dot[2];
    const float s_ddot3 = t9 - (t[0] * t6 + t[1] * t7 + t[2] * t8);
    const float t10 = t1 * (t5 * t5 + 0.25f);
    const float t11 = 0.5f * (e[1] * t_dot[2] - e[2] * t_dot[1] + (t[1] * t8 - t[2] * t7));
    const float s_ddot0 = t5 * (t_dot[0] - e[0] * s_ddot3 + t1 * t6) + t2 * t10 - t11;
    const float t12 = 0.5f * (e[2] * t_dot[0] - e[0] * t_dot[2] + (t[2] * t6 - t[0] * t8));
    const float s_ddot1 = t5 * (t_dot[1] - e[1] * s_ddot3 + t1 * t7) + t3 * t10 - t12;
    const float t13 = 0.5f * (e[0] * t_dot[1] - e[1] * t_dot[0] + (t[0] * t7 - t[1] * t6));
    const float s_ddot2 = t5 * (t_dot[2] - e[2] * s_ddot3 + t1 * t8) + t4 * t10 - t13;
    s_ddot[0] = s_ddot0;
    s_ddot[1] = s_ddot1;
    s_ddot[2] = s_ddot2;
    s_ddot[3] = s_ddot3;
    s_ddot[4] = s_ddot4;
    s_ddot[5] = s_ddot5;
    s_ddot[6] = s_ddot6;
}

/*
 * text 3.5 h chasles_pose_acceleration_natural for a batch.
 *   verdict: holds under; assumes |e| = 1, phi != 0
 *   96 operations; derivation sha256 4063df423497b2a63464c14082ba023d497a45f17209d99f956cc810ce8006b6
 */
void chasles_pose_acceleration_natural_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *t, ptrdiff_t t_step,
    const double *t_dot, ptrdiff_t t_dot_step,
    double *s_ddot, ptrdiff_t s_ddot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)t, (char *)t_dot, (char *)s_ddot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        t_step * size,
        t_dot_step * size,
        s_ddot_step * size};
    const chasles_loop *loop = &chasles_pose_acceleration_natural_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 h chasles_pose_acceleration_naturalf for a batch.
 *   verdict: holds under; assumes |e| = 1, phi != 0
 *   96 operations; derivation sha256 4063df423497b2a63464c14082ba023d497a45f17209d99f956cc810ce8006b6
 */
void chasles_pose_acceleration_natural_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *t, ptrdiff_t t_step,
    const float *t_dot, ptrdiff_t t_dot_step,
    float *s_ddot, ptrdiff_t s_ddot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)t, (char *)t_dot, (char *)s_ddot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        t_step * size,
        t_dot_step * size,
        s_ddot_step * size};
    const chasles_loop *loop = &chasles_pose_acceleration_natural_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 h The second rate of the pose from the twist and its rate, with the linear invariants.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *               t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   returns     s_ddot[7]: second time derivative of: pose array
 *   verdict     holds under
 *   assumes     |e| = 1
 *   made of     an offered form, proved equal to the statement
 *   operations  76: 11 add, 18 subtract, 45 multiply, 1 sine, 1 cosine
 *   error bound 12.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 1588dcded7d741e99e263e63960b704faab031996a2d165fbbe2b322357ed2e9
 */
void chasles_pose_acceleration_linear(
    const double e[3],
    double phi,
    const double t[6],
    const double t_dot[6],
    double s_ddot[7])
{
    const double s_ddot4 = t_dot[3];
    const double s_ddot5 = t_dot[4];
    const double s_ddot6 = t_dot[5];
    const double t1 = 0.5 * cos(phi);
    const double t2 = 0.5 + t1;
    const double sin_phi = sin(phi);
    const double half_sin_phi = 0.5 * sin_phi;
    const double t3 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
    const double t4 = half_sin_phi * t3;
    const double t5 = t_dot[0] * t2 - (e[1] * t_dot[2] - e[2] * t_dot[1]) * half_sin_phi;
    const double t6 = t_dot[1] * t2 - (e[2] * t_dot[0] - e[0] * t_dot[2]) * half_sin_phi;
    const double t7 = t_dot[2] * t2 - (e[0] * t_dot[1] - e[1] * t_dot[0]) * half_sin_phi;
    const double t8 = 0.5 - t1;
    const double t9 = t3 * t8;
    const double t10 = e[0] * t_dot[0] + e[1] * t_dot[1] + e[2] * t_dot[2];
    const double t11 = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
    const double t12 = t8 * t10 + half_sin_phi * t11;
    const double s_ddot0 = t5 - t[0] * t4 + (e[1] * t[2] - e[2] * t[1]) * t9 - e[0] * t12;
    const double s_ddot1 = t6 - t[1] * t4 + (e[2] * t[0] - e[0] * t[2]) * t9 - e[1] * t12;
    const double s_ddot2 = t7 - t[2] * t4 + (e[0] * t[1] - e[1] * t[0]) * t9 - e[2] * t12;
    const double s_ddot3 = t3 * t9 - sin_phi * t10 - t2 * t11;
    s_ddot[0] = s_ddot0;
    s_ddot[1] = s_ddot1;
    s_ddot[2] = s_ddot2;
    s_ddot[3] = s_ddot3;
    s_ddot[4] = s_ddot4;
    s_ddot[5] = s_ddot5;
    s_ddot[6] = s_ddot6;
}

/*
 * text 3.5 h chasles_pose_acceleration_linear in single precision.
 *   verdict: holds under; assumes |e| = 1
 *   76 operations; derivation sha256 1588dcded7d741e99e263e63960b704faab031996a2d165fbbe2b322357ed2e9
 */
void chasles_pose_acceleration_linearf(
    const float e[3],
    float phi,
    const float t[6],
    const float t_dot[6],
    float s_ddot[7])
{
    const float s_ddot4 = t_dot[3];
    const float s_ddot5 = t_dot[4];
    const float s_ddot6 = t_dot[5];
    const float t1 = 0.5f * cosf(phi);
    const float t2 = 0.5f + t1;
    const float sin_phi = sinf(phi);
    const float half_sin_phi = 0.5f * sin_phi;
    const float t3 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
    const float t4 = half_sin_phi * t3;
    const float t5 = t_dot[0] * t2 - (e[1] * t_dot[2] - e[2] * t_dot[1]) * half_sin_phi;
    const float t6 = t_dot[1] * t2 - (e[2] * t_dot[0] - e[0] * t_dot[2]) * half_sin_phi;
    const float t7 = t_dot[2] * t2 - (e[0] * t_dot[1] - e[1] * t_dot[0]) * half_sin_phi;
    const float t8 = 0.5f - t1;
    const float t9 = t3 * t8;
    const float t10 = e[0] * t_dot[0] + e[1] * t_dot[1] + e[2] * t_dot[2];
    const float t11 = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
    const float t12 = t8 * t10 + half_sin_phi * t11;
    const float s_ddot0 = t5 - t[0] * t4 + (e[1] * t[2] - e[2] * t[1]) * t9 - e[0] * t12;
    const float s_ddot1 = t6 - t[1] * t4 + (e[2] * t[0] - e[0] * t[2]) * t9 - e[1] * t12;
    const float s_ddot2 = t7 - t[2] * t4 + (e[0] * t[1] - e[1] * t[0]) * t9 - e[2] * t12;
    const float s_ddot3 = t3 * t9 - sin_phi * t10 - t2 * t11;
    s_ddot[0] = s_ddot0;
    s_ddot[1] = s_ddot1;
    s_ddot[2] = s_ddot2;
    s_ddot[3] = s_ddot3;
    s_ddot[4] = s_ddot4;
    s_ddot[5] = s_ddot5;
    s_ddot[6] = s_ddot6;
}

/*
 * text 3.5 h chasles_pose_acceleration_linear for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   76 operations; derivation sha256 1588dcded7d741e99e263e63960b704faab031996a2d165fbbe2b322357ed2e9
 */
void chasles_pose_acceleration_linear_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *t, ptrdiff_t t_step,
    const double *t_dot, ptrdiff_t t_dot_step,
    double *s_ddot, ptrdiff_t s_ddot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)t, (char *)t_dot, (char *)s_ddot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        t_step * size,
        t_dot_step * size,
        s_ddot_step * size};
    const chasles_loop *loop = &chasles_pose_acceleration_linear_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 h chasles_pose_acceleration_linearf for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   76 operations; derivation sha256 1588dcded7d741e99e263e63960b704faab031996a2d165fbbe2b322357ed2e9
 */
void chasles_pose_acceleration_linear_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *t, ptrdiff_t t_step,
    const float *t_dot, ptrdiff_t t_dot_step,
    float *s_ddot, ptrdiff_t s_ddot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)t, (char *)t_dot, (char *)s_ddot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        t_step * size,
        t_dot_step * size,
        s_ddot_step * size};
    const chasles_loop *loop = &chasles_pose_acceleration_linear_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 h The second rate of the pose from the twist and its rate, with the Euler-Rodrigues
 *   parameters.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *               t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   returns     s_ddot[7]: second time derivative of: pose array
 *   verdict     holds under
 *   assumes     |e| = 1
 *   made of     an offered form, proved equal to the statement
 *   operations  45: 5 add, 9 subtract, 29 multiply, 1 sine, 1 cosine
 *   error bound 7.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 0f21a42c6c8b20a3978874f3add6fcde6371416fd40cc41c5da50d8f4cd6babd
 */
void chasles_pose_acceleration_euler_rodrigues(
    const double e[3],
    double phi,
    const double t[6],
    const double t_dot[6],
    double s_ddot[7])
{
    const double s_ddot4 = t_dot[3];
    const double s_ddot5 = t_dot[4];
    const double s_ddot6 = t_dot[5];
    const double half_phi = 0.5 * phi;
    const double cos_half_phi = cos(half_phi);
    const double sin_half_phi = sin(half_phi);
    const double t1 = e[0] * sin_half_phi;
    const double t2 = e[1] * sin_half_phi;
    const double t3 = e[2] * sin_half_phi;
    const double t4 = 0.25 * (t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    const double t5 = sin_half_phi * t4;
    const double t6 = 0.5 * (t_dot[0] * cos_half_phi - (t_dot[2] * t2 - t_dot[1] * t3));
    const double s_ddot0 = t6 - e[0] * t5;
    const double t7 = 0.5 * (t_dot[1] * cos_half_phi - (t_dot[0] * t3 - t_dot[2] * t1));
    const double s_ddot1 = t7 - e[1] * t5;
    const double t8 = 0.5 * (t_dot[2] * cos_half_phi - (t_dot[1] * t1 - t_dot[0] * t2));
    const double s_ddot2 = t8 - e[2] * t5;
    const double t9 = 0.5 * (t_dot[0] * t1 + t_dot[1] * t2 + t_dot[2] * t3);
    const double s_ddot3 = -(t9 + cos_half_phi * t4);
    s_ddot[0] = s_ddot0;
    s_ddot[1] = s_ddot1;
    s_ddot[2] = s_ddot2;
    s_ddot[3] = s_ddot3;
    s_ddot[4] = s_ddot4;
    s_ddot[5] = s_ddot5;
    s_ddot[6] = s_ddot6;
}

/*
 * text 3.5 h chasles_pose_acceleration_euler_rodrigues in single precision.
 *   verdict: holds under; assumes |e| = 1
 *   45 operations; derivation sha256 0f21a42c6c8b20a3978874f3add6fcde6371416fd40cc41c5da50d8f4cd6babd
 */
void chasles_pose_acceleration_euler_rodriguesf(
    const float e[3],
    float phi,
    const float t[6],
    const float t_dot[6],
    float s_ddot[7])
{
    const float s_ddot4 = t_dot[3];
    const float s_ddot5 = t_dot[4];
    const float s_ddot6 = t_dot[5];
    const float half_phi = 0.5f * phi;
    const float cos_half_phi = cosf(half_phi);
    const float sin_half_phi = sinf(half_phi);
    const float t1 = e[0] * sin_half_phi;
    const float t2 = e[1] * sin_half_phi;
    const float t3 = e[2] * sin_half_phi;
    const float t4 = 0.25f * (t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    const float t5 = sin_half_phi * t4;
    const float t6 = 0.5f * (t_dot[0] * cos_half_phi - (t_dot[2] * t2 - t_dot[1] * t3));
    const float s_ddot0 = t6 - e[0] * t5;
    const float t7 = 0.5f * (t_dot[1] * cos_half_phi - (t_dot[0] * t3 - t_dot[2] * t1));
    const float s_ddot1 = t7 - e[1] * t5;
    const float t8 = 0.5f * (t_dot[2] * cos_half_phi - (t_dot[1] * t1 - t_dot[0] * t2));
    const float s_ddot2 = t8 - e[2] * t5;
    const float t9 = 0.5f * (t_dot[0] * t1 + t_dot[1] * t2 + t_dot[2] * t3);
    const float s_ddot3 = -(t9 + cos_half_phi * t4);
    s_ddot[0] = s_ddot0;
    s_ddot[1] = s_ddot1;
    s_ddot[2] = s_ddot2;
    s_ddot[3] = s_ddot3;
    s_ddot[4] = s_ddot4;
    s_ddot[5] = s_ddot5;
    s_ddot[6] = s_ddot6;
}

/*
 * text 3.5 h chasles_pose_acceleration_euler_rodrigues for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   45 operations; derivation sha256 0f21a42c6c8b20a3978874f3add6fcde6371416fd40cc41c5da50d8f4cd6babd
 */
void chasles_pose_acceleration_euler_rodrigues_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *t, ptrdiff_t t_step,
    const double *t_dot, ptrdiff_t t_dot_step,
    double *s_ddot, ptrdiff_t s_ddot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)t, (char *)t_dot, (char *)s_ddot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        t_step * size,
        t_dot_step * size,
        s_ddot_step * size};
    const chasles_loop *loop = &chasles_pose_acceleration_euler_rodrigues_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 h chasles_pose_acceleration_euler_rodriguesf for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   45 operations; derivation sha256 0f21a42c6c8b20a3978874f3add6fcde6371416fd40cc41c5da50d8f4cd6babd
 */
void chasles_pose_acceleration_euler_rodrigues_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *t, ptrdiff_t t_step,
    const float *t_dot, ptrdiff_t t_dot_step,
    float *s_ddot, ptrdiff_t s_ddot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)t, (char *)t_dot, (char *)s_ddot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        t_step * size,
        t_dot_step * size,
        s_ddot_step * size};
    const chasles_loop *loop = &chasles_pose_acceleration_euler_rodrigues_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 i The rate of the twist from the rates of the pose, with the natural invariants.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               s_dot[7]: time derivative of: pose array
 *               s_ddot[7]: second time derivative of: pose array
 *   returns     t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   verdict     holds under
 *   assumes     |e| = 1
 *   made of     an offered form, proved equal to the statement
 *   operations  51: 13 add, 7 subtract, 29 multiply, 1 sine, 1 cosine
 *   error bound 8.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 46142537f8f2d352235601f0fe20d7417a8415c4299de5fde88c9772c1d5b072
 */
void chasles_twist_rate_from_pose_natural(
    const double e[3],
    double phi,
    const double s_dot[7],
    const double s_ddot[7],
    double t_dot[6])
{
    const double t_dot3 = s_ddot[4];
    const double t_dot4 = s_ddot[5];
    const double t_dot5 = s_ddot[6];
    const double sin_phi = sin(phi);
    const double cos_phi = cos(phi);
    const double t1 = 1.0 - cos_phi;
    const double t2 = s_ddot[0] * sin_phi + t1 * (e[1] * s_ddot[2] - e[2] * s_ddot[1]);
    const double t3 = s_ddot[1] * sin_phi + t1 * (e[2] * s_ddot[0] - e[0] * s_ddot[2]);
    const double t4 = s_ddot[2] * sin_phi + t1 * (e[0] * s_ddot[1] - e[1] * s_ddot[0]);
    const double t5 = s_dot[3] * (1.0 + cos_phi);
    const double t6 = s_dot[3] * sin_phi;
    const double t7 = s_dot[0] * t5 + (e[1] * s_dot[2] - e[2] * s_dot[1]) * t6;
    const double t_dot0 = t2 + e[0] * s_ddot[3] + t7;
    const double t8 = s_dot[1] * t5 + (e[2] * s_dot[0] - e[0] * s_dot[2]) * t6;
    const double t_dot1 = t3 + e[1] * s_ddot[3] + t8;
    const double t9 = s_dot[2] * t5 + (e[0] * s_dot[1] - e[1] * s_dot[0]) * t6;
    const double t_dot2 = t4 + e[2] * s_ddot[3] + t9;
    t_dot[0] = t_dot0;
    t_dot[1] = t_dot1;
    t_dot[2] = t_dot2;
    t_dot[3] = t_dot3;
    t_dot[4] = t_dot4;
    t_dot[5] = t_dot5;
}

/*
 * text 3.5 i chasles_twist_rate_from_pose_natural in single precision.
 *   verdict: holds under; assumes |e| = 1
 *   51 operations; derivation sha256 46142537f8f2d352235601f0fe20d7417a8415c4299de5fde88c9772c1d5b072
 */
void chasles_twist_rate_from_pose_naturalf(
    const float e[3],
    float phi,
    const float s_dot[7],
    const float s_ddot[7],
    float t_dot[6])
{
    const float t_dot3 = s_ddot[4];
    const float t_dot4 = s_ddot[5];
    const float t_dot5 = s_ddot[6];
    const float sin_phi = sinf(phi);
    const float cos_phi = cosf(phi);
    const float t1 = 1.0f - cos_phi;
    const float t2 = s_ddot[0] * sin_phi + t1 * (e[1] * s_ddot[2] - e[2] * s_ddot[1]);
    const float t3 = s_ddot[1] * sin_phi + t1 * (e[2] * s_ddot[0] - e[0] * s_ddot[2]);
    const float t4 = s_ddot[2] * sin_phi + t1 * (e[0] * s_ddot[1] - e[1] * s_ddot[0]);
    const float t5 = s_dot[3] * (1.0f + cos_phi);
    const float t6 = s_dot[3] * sin_phi;
    const float t7 = s_dot[0] * t5 + (e[1] * s_dot[2] - e[2] * s_dot[1]) * t6;
    const float t_dot0 = t2 + e[0] * s_ddot[3] + t7;
    const float t8 = s_dot[1] * t5 + (e[2] * s_dot[0] - e[0] * s_dot[2]) * t6;
    const float t_dot1 = t3 + e[1] * s_ddot[3] + t8;
    const float t9 = s_dot[2] * t5 + (e[0] * s_dot[1] - e[1] * s_dot[0]) * t6;
    const float t_dot2 = t4 + e[2] * s_ddot[3] + t9;
    t_dot[0] = t_dot0;
    t_dot[1] = t_dot1;
    t_dot[2] = t_dot2;
    t_dot[3] = t_dot3;
    t_dot[4] = t_dot4;
    t_dot[5] = t_dot5;
}

/*
 * text 3.5 i chasles_twist_rate_from_pose_natural for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   51 operations; derivation sha256 46142537f8f2d352235601f0fe20d7417a8415c4299de5fde88c9772c1d5b072
 */
void chasles_twist_rate_from_pose_natural_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *s_dot, ptrdiff_t s_dot_step,
    const double *s_ddot, ptrdiff_t s_ddot_step,
    double *t_dot, ptrdiff_t t_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)s_dot, (char *)s_ddot, (char *)t_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        s_dot_step * size,
        s_ddot_step * size,
        t_dot_step * size};
    const chasles_loop *loop = &chasles_twist_rate_from_pose_natural_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 i chasles_twist_rate_from_pose_naturalf for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   51 operations; derivation sha256 46142537f8f2d352235601f0fe20d7417a8415c4299de5fde88c9772c1d5b072
 */
void chasles_twist_rate_from_pose_natural_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *s_dot, ptrdiff_t s_dot_step,
    const float *s_ddot, ptrdiff_t s_ddot_step,
    float *t_dot, ptrdiff_t t_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)s_dot, (char *)s_ddot, (char *)t_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        s_dot_step * size,
        s_ddot_step * size,
        t_dot_step * size};
    const chasles_loop *loop = &chasles_twist_rate_from_pose_natural_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 i The rate of the twist from the rates of the pose, with the linear invariants.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               s_dot[7]: time derivative of: pose array
 *               s_ddot[7]: second time derivative of: pose array
 *   returns     t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   verdict     holds under
 *   assumes     |e| = 1
 *               phi != pi
 *   made of     an offered form, proved equal to the statement
 *   operations  52: 6 add, 15 subtract, 27 multiply, 2 divide, 1 sine, 1 cosine
 *   error bound 16.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 e60a5e59bbc9bfff80fda29a99e2165c18777756e0d5ef482d146ef9b36646a2
 */
void chasles_twist_rate_from_pose_linear(
    const double e[3],
    double phi,
    const double s_dot[7],
    const double s_ddot[7],
    double t_dot[6])
{
    const double t_dot3 = s_ddot[4];
    const double t_dot4 = s_ddot[5];
    const double t_dot5 = s_ddot[6];
    const double half_phi = 0.5 * phi;
    const double cos_half_phi = cos(half_phi);
    const double t1 = (cos_half_phi == 0.0 ? 0.0 : sin(half_phi)) / cos_half_phi;
    const double t2 = e[0] * t1;
    const double t3 = e[1] * t1;
    const double t4 = e[2] * t1;
    const double t5 = 2.0 * (cos_half_phi * cos_half_phi);
    const double t6 = (t5 == 0.0 ? 0.0 : s_dot[3]) / t5;
    const double t7 = (s_dot[0] - s_dot[1] * t4 + s_dot[2] * t3 - s_dot[3] * t2) * t6;
    const double t_dot0 = s_ddot[0] - s_ddot[1] * t4 + s_ddot[2] * t3 - s_ddot[3] * t2 - t7;
    const double t8 = (s_dot[1] + s_dot[0] * t4 - s_dot[2] * t2 - s_dot[3] * t3) * t6;
    const double t_dot1 = s_ddot[1] + s_ddot[0] * t4 - s_ddot[2] * t2 - s_ddot[3] * t3 - t8;
    const double t9 = (s_dot[2] + (s_dot[1] * t2 - s_dot[0] * t3) - s_dot[3] * t4) * t6;
    const double t_dot2 = s_ddot[2] + (s_ddot[1] * t2 - s_ddot[0] * t3) - s_ddot[3] * t4 - t9;
    t_dot[0] = t_dot0;
    t_dot[1] = t_dot1;
    t_dot[2] = t_dot2;
    t_dot[3] = t_dot3;
    t_dot[4] = t_dot4;
    t_dot[5] = t_dot5;
}

/*
 * text 3.5 i chasles_twist_rate_from_pose_linear in single precision.
 *   verdict: holds under; assumes |e| = 1, phi != pi
 *   52 operations; derivation sha256 e60a5e59bbc9bfff80fda29a99e2165c18777756e0d5ef482d146ef9b36646a2
 */
void chasles_twist_rate_from_pose_linearf(
    const float e[3],
    float phi,
    const float s_dot[7],
    const float s_ddot[7],
    float t_dot[6])
{
    const float t_dot3 = s_ddot[4];
    const float t_dot4 = s_ddot[5];
    const float t_dot5 = s_ddot[6];
    const float half_phi = 0.5f * phi;
    const float cos_half_phi = cosf(half_phi);
    const float t1 = (cos_half_phi == 0.0f ? 0.0f : sinf(half_phi)) / cos_half_phi;
    const float t2 = e[0] * t1;
    const float t3 = e[1] * t1;
    const float t4 = e[2] * t1;
    const float t5 = 2.0f * (cos_half_phi * cos_half_phi);
    const float t6 = (t5 == 0.0f ? 0.0f : s_dot[3]) / t5;
    const float t7 = (s_dot[0] - s_dot[1] * t4 + s_dot[2] * t3 - s_dot[3] * t2) * t6;
    const float t_dot0 = s_ddot[0] - s_ddot[1] * t4 + s_ddot[2] * t3 - s_ddot[3] * t2 - t7;
    const float t8 = (s_dot[1] + s_dot[0] * t4 - s_dot[2] * t2 - s_dot[3] * t3) * t6;
    const float t_dot1 = s_ddot[1] + s_ddot[0] * t4 - s_ddot[2] * t2 - s_ddot[3] * t3 - t8;
    const float t9 = (s_dot[2] + (s_dot[1] * t2 - s_dot[0] * t3) - s_dot[3] * t4) * t6;
    const float t_dot2 = s_ddot[2] + (s_ddot[1] * t2 - s_ddot[0] * t3) - s_ddot[3] * t4 - t9;
    t_dot[0] = t_dot0;
    t_dot[1] = t_dot1;
    t_dot[2] = t_dot2;
    t_dot[3] = t_dot3;
    t_dot[4] = t_dot4;
    t_dot[5] = t_dot5;
}

/*
 * text 3.5 i chasles_twist_rate_from_pose_linear for a batch.
 *   verdict: holds under; assumes |e| = 1, phi != pi
 *   52 operations; derivation sha256 e60a5e59bbc9bfff80fda29a99e2165c18777756e0d5ef482d146ef9b36646a2
 */
void chasles_twist_rate_from_pose_linear_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *s_dot, ptrdiff_t s_dot_step,
    const double *s_ddot, ptrdiff_t s_ddot_step,
    double *t_dot, ptrdiff_t t_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)s_dot, (char *)s_ddot, (char *)t_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        s_dot_step * size,
        s_ddot_step * size,
        t_dot_step * size};
    const chasles_loop *loop = &chasles_twist_rate_from_pose_linear_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 i chasles_twist_rate_from_pose_linearf for a batch.
 *   verdict: holds under; assumes |e| = 1, phi != pi
 *   52 operations; derivation sha256 e60a5e59bbc9bfff80fda29a99e2165c18777756e0d5ef482d146ef9b36646a2
 */
void chasles_twist_rate_from_pose_linear_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *s_dot, ptrdiff_t s_dot_step,
    const float *s_ddot, ptrdiff_t s_ddot_step,
    float *t_dot, ptrdiff_t t_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)s_dot, (char *)s_ddot, (char *)t_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        s_dot_step * size,
        s_ddot_step * size,
        t_dot_step * size};
    const chasles_loop *loop = &chasles_twist_rate_from_pose_linear_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 i The rate of the twist from the rates of the pose, with the Euler-Rodrigues parameters.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               s_dot[7]: time derivative of: pose array
 *               s_ddot[7]: second time derivative of: pose array
 *   returns     t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   verdict     holds under
 *   assumes     |e| = 1
 *   made of     an offered form, proved equal to the statement
 *   operations  29: 3 add, 6 subtract, 18 multiply, 1 sine, 1 cosine
 *   error bound 6.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 8f9dc9af1023fade3eb622411945883078b1f62098c7b9178f68aed0ef63d94d
 */
void chasles_twist_rate_from_pose_euler_rodrigues(
    const double e[3],
    double phi,
    const double s_dot[7],
    const double s_ddot[7],
    double t_dot[6])
{
    (void)s_dot;
    const double t_dot3 = s_ddot[4];
    const double t_dot4 = s_ddot[5];
    const double t_dot5 = s_ddot[6];
    const double half_phi = 0.5 * phi;
    const double t1 = 2.0 * cos(half_phi);
    const double t2 = 2.0 * sin(half_phi);
    const double t3 = e[0] * t2;
    const double t4 = e[1] * t2;
    const double t5 = e[2] * t2;
    const double t_dot0 = s_ddot[0] * t1 - s_ddot[1] * t5 + s_ddot[2] * t4 - s_ddot[3] * t3;
    const double t_dot1 = s_ddot[0] * t5 + s_ddot[1] * t1 - s_ddot[2] * t3 - s_ddot[3] * t4;
    const double t_dot2 = s_ddot[1] * t3 - s_ddot[0] * t4 + s_ddot[2] * t1 - s_ddot[3] * t5;
    t_dot[0] = t_dot0;
    t_dot[1] = t_dot1;
    t_dot[2] = t_dot2;
    t_dot[3] = t_dot3;
    t_dot[4] = t_dot4;
    t_dot[5] = t_dot5;
}

/*
 * text 3.5 i chasles_twist_rate_from_pose_euler_rodrigues in single precision.
 *   verdict: holds under; assumes |e| = 1
 *   29 operations; derivation sha256 8f9dc9af1023fade3eb622411945883078b1f62098c7b9178f68aed0ef63d94d
 */
void chasles_twist_rate_from_pose_euler_rodriguesf(
    const float e[3],
    float phi,
    const float s_dot[7],
    const float s_ddot[7],
    float t_dot[6])
{
    (void)s_dot;
    const float t_dot3 = s_ddot[4];
    const float t_dot4 = s_ddot[5];
    const float t_dot5 = s_ddot[6];
    const float half_phi = 0.5f * phi;
    const float t1 = 2.0f * cosf(half_phi);
    const float t2 = 2.0f * sinf(half_phi);
    const float t3 = e[0] * t2;
    const float t4 = e[1] * t2;
    const float t5 = e[2] * t2;
    const float t_dot0 = s_ddot[0] * t1 - s_ddot[1] * t5 + s_ddot[2] * t4 - s_ddot[3] * t3;
    const float t_dot1 = s_ddot[0] * t5 + s_ddot[1] * t1 - s_ddot[2] * t3 - s_ddot[3] * t4;
    const float t_dot2 = s_ddot[1] * t3 - s_ddot[0] * t4 + s_ddot[2] * t1 - s_ddot[3] * t5;
    t_dot[0] = t_dot0;
    t_dot[1] = t_dot1;
    t_dot[2] = t_dot2;
    t_dot[3] = t_dot3;
    t_dot[4] = t_dot4;
    t_dot[5] = t_dot5;
}

/*
 * text 3.5 i chasles_twist_rate_from_pose_euler_rodrigues for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   29 operations; derivation sha256 8f9dc9af1023fade3eb622411945883078b1f62098c7b9178f68aed0ef63d94d
 */
void chasles_twist_rate_from_pose_euler_rodrigues_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *s_dot, ptrdiff_t s_dot_step,
    const double *s_ddot, ptrdiff_t s_ddot_step,
    double *t_dot, ptrdiff_t t_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)s_dot, (char *)s_ddot, (char *)t_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        s_dot_step * size,
        s_ddot_step * size,
        t_dot_step * size};
    const chasles_loop *loop = &chasles_twist_rate_from_pose_euler_rodrigues_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.5 i chasles_twist_rate_from_pose_euler_rodriguesf for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   29 operations; derivation sha256 8f9dc9af1023fade3eb622411945883078b1f62098c7b9178f68aed0ef63d94d
 */
void chasles_twist_rate_from_pose_euler_rodrigues_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *s_dot, ptrdiff_t s_dot_step,
    const float *s_ddot, ptrdiff_t s_ddot_step,
    float *t_dot, ptrdiff_t t_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)s_dot, (char *)s_ddot, (char *)t_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        s_dot_step * size,
        s_ddot_step * size,
        t_dot_step * size};
    const chasles_loop *loop = &chasles_twist_rate_from_pose_euler_rodrigues_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

#endif
