/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The kernels of section_3_6. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"
#include "loops.h"

static const chasles_shape chasles_moving_frame_velocity_loop_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_moving_frame_velocity_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    5, 6, chasles_moving_frame_velocity_loop_shapes,
    CHASLES_BLOCKS(chasles_moving_frame_velocity_block),
};

static const chasles_shape chasles_moving_frame_velocity_loopf_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_moving_frame_velocity_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    5, 6, chasles_moving_frame_velocity_loopf_shapes,
    CHASLES_BLOCKS(chasles_moving_frame_velocity_blockf),
};

static const chasles_shape chasles_moving_frame_acceleration_loop_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_moving_frame_acceleration_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    7, 8, chasles_moving_frame_acceleration_loop_shapes,
    CHASLES_BLOCKS(chasles_moving_frame_acceleration_block),
};

static const chasles_shape chasles_moving_frame_acceleration_loopf_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_moving_frame_acceleration_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    7, 8, chasles_moving_frame_acceleration_loopf_shapes,
    CHASLES_BLOCKS(chasles_moving_frame_acceleration_blockf),
};

#if !(CHASLES_VECTORS && defined(CHASLES_BLOCKS_ALONE))

/*
 * (3.103) The velocity of P in the fixed frame from that in the moving frame.
 *   given       o_dot[3]: time derivative of: position of the origin of the moving frame
 *               Q[9]: rotation
 *               omega[3]: angular velocity
 *               rho[3]: position of P in the moving frame
 *               rho_dot[3]: time derivative of: position of P in the moving frame
 *   returns     p_dot[3]: time derivative of: position of any point P
 *   verdict     holds
 *   assumes     nothing
 *   expects     Q is a rotation
 *   operations  45: 18 add, 3 subtract, 24 multiply
 *   error bound 7.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 b4941bd3b3f57c83b14de8fd13a10f996bcfeb8ee7bfc4215c85ab50fb9b8b33
 */
void chasles_moving_frame_velocity(
    const double o_dot[3],
    const double Q[9],
    const double omega[3],
    const double rho[3],
    const double rho_dot[3],
    double p_dot[3])
{
    const double t1 = Q[0] * rho[0] + Q[1] * rho[1] + Q[2] * rho[2];
    const double t2 = Q[3] * rho[0] + Q[4] * rho[1] + Q[5] * rho[2];
    const double t3 = Q[6] * rho[0] + Q[7] * rho[1] + Q[8] * rho[2];
    const double t4 = Q[0] * rho_dot[0] + Q[1] * rho_dot[1] + Q[2] * rho_dot[2];
    const double p_dot0 = o_dot[0] + (omega[1] * t3 - omega[2] * t2) + t4;
    const double t5 = Q[3] * rho_dot[0] + Q[4] * rho_dot[1] + Q[5] * rho_dot[2];
    const double p_dot1 = o_dot[1] + (omega[2] * t1 - omega[0] * t3) + t5;
    const double t6 = Q[6] * rho_dot[0] + Q[7] * rho_dot[1] + Q[8] * rho_dot[2];
    const double p_dot2 = o_dot[2] + (omega[0] * t2 - omega[1] * t1) + t6;
    p_dot[0] = p_dot0;
    p_dot[1] = p_dot1;
    p_dot[2] = p_dot2;
}

/*
 * (3.103) chasles_moving_frame_velocity in single precision.
 *   verdict: holds; assumes nothing
 *   45 operations; derivation sha256 b4941bd3b3f57c83b14de8fd13a10f996bcfeb8ee7bfc4215c85ab50fb9b8b33
 */
void chasles_moving_frame_velocityf(
    const float o_dot[3],
    const float Q[9],
    const float omega[3],
    const float rho[3],
    const float rho_dot[3],
    float p_dot[3])
{
    const float t1 = Q[0] * rho[0] + Q[1] * rho[1] + Q[2] * rho[2];
    const float t2 = Q[3] * rho[0] + Q[4] * rho[1] + Q[5] * rho[2];
    const float t3 = Q[6] * rho[0] + Q[7] * rho[1] + Q[8] * rho[2];
    const float t4 = Q[0] * rho_dot[0] + Q[1] * rho_dot[1] + Q[2] * rho_dot[2];
    const float p_dot0 = o_dot[0] + (omega[1] * t3 - omega[2] * t2) + t4;
    const float t5 = Q[3] * rho_dot[0] + Q[4] * rho_dot[1] + Q[5] * rho_dot[2];
    const float p_dot1 = o_dot[1] + (omega[2] * t1 - omega[0] * t3) + t5;
    const float t6 = Q[6] * rho_dot[0] + Q[7] * rho_dot[1] + Q[8] * rho_dot[2];
    const float p_dot2 = o_dot[2] + (omega[0] * t2 - omega[1] * t1) + t6;
    p_dot[0] = p_dot0;
    p_dot[1] = p_dot1;
    p_dot[2] = p_dot2;
}

/*
 * (3.103) chasles_moving_frame_velocity for a batch.
 *   verdict: holds; assumes nothing
 *   45 operations; derivation sha256 b4941bd3b3f57c83b14de8fd13a10f996bcfeb8ee7bfc4215c85ab50fb9b8b33
 */
void chasles_moving_frame_velocity_batch(
    size_t count,
    const double *o_dot, ptrdiff_t o_dot_step,
    const double *Q, ptrdiff_t Q_step,
    const double *omega, ptrdiff_t omega_step,
    const double *rho, ptrdiff_t rho_step,
    const double *rho_dot, ptrdiff_t rho_dot_step,
    double *p_dot, ptrdiff_t p_dot_step)
{
    char *const at[] = {
        (char *)o_dot,
        (char *)Q,
        (char *)omega,
        (char *)rho,
        (char *)rho_dot,
        (char *)p_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        o_dot_step * size,
        Q_step * size,
        omega_step * size,
        rho_step * size,
        rho_dot_step * size,
        p_dot_step * size};
    const chasles_loop *loop = &chasles_moving_frame_velocity_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.103) chasles_moving_frame_velocityf for a batch.
 *   verdict: holds; assumes nothing
 *   45 operations; derivation sha256 b4941bd3b3f57c83b14de8fd13a10f996bcfeb8ee7bfc4215c85ab50fb9b8b33
 */
void chasles_moving_frame_velocity_batchf(
    size_t count,
    const float *o_dot, ptrdiff_t o_dot_step,
    const float *Q, ptrdiff_t Q_step,
    const float *omega, ptrdiff_t omega_step,
    const float *rho, ptrdiff_t rho_step,
    const float *rho_dot, ptrdiff_t rho_dot_step,
    float *p_dot, ptrdiff_t p_dot_step)
{
    char *const at[] = {
        (char *)o_dot,
        (char *)Q,
        (char *)omega,
        (char *)rho,
        (char *)rho_dot,
        (char *)p_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        o_dot_step * size,
        Q_step * size,
        omega_step * size,
        rho_step * size,
        rho_dot_step * size,
        p_dot_step * size};
    const chasles_loop *loop = &chasles_moving_frame_velocity_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.105) The acceleration of P in the fixed frame: as a point of the moving frame, Coriolis, and in
 *   the moving frame.
 *   given       o_ddot[3]: second time derivative of: position of the origin of the moving frame
 *               Q[9]: rotation
 *               omega[3]: angular velocity
 *               omega_dot[3]: time derivative of: angular velocity
 *               rho[3]: position of P in the moving frame
 *               rho_dot[3]: time derivative of: position of P in the moving frame
 *               rho_ddot[3]: second time derivative of: position of P in the moving frame
 *   returns     p_ddot[3]: second time derivative of: position of any point P
 *   verdict     holds
 *   assumes     nothing
 *   expects     Q is a rotation
 *   made of     an offered form, proved equal to the statement
 *   operations  87: 30 add, 9 subtract, 48 multiply
 *   error bound 10.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 985f244a1c015e00a6d544a9a346e7446722d3d1972e549159bc1a6a90456d40
 */
void chasles_moving_frame_acceleration(
    const double o_ddot[3],
    const double Q[9],
    const double omega[3],
    const double omega_dot[3],
    const double rho[3],
    const double rho_dot[3],
    const double rho_ddot[3],
    double p_ddot[3])
{
    const double t1 = Q[0] * rho[0] + Q[1] * rho[1] + Q[2] * rho[2];
    const double t2 = Q[3] * rho[0] + Q[4] * rho[1] + Q[5] * rho[2];
    const double t3 = Q[6] * rho[0] + Q[7] * rho[1] + Q[8] * rho[2];
    const double t4 = 2.0 * (Q[0] * rho_dot[0] + Q[1] * rho_dot[1] + Q[2] * rho_dot[2]);
    const double t5 = omega[1] * t3 - omega[2] * t2 + t4;
    const double t6 = 2.0 * (Q[3] * rho_dot[0] + Q[4] * rho_dot[1] + Q[5] * rho_dot[2]);
    const double t7 = omega[2] * t1 - omega[0] * t3 + t6;
    const double t8 = 2.0 * (Q[6] * rho_dot[0] + Q[7] * rho_dot[1] + Q[8] * rho_dot[2]);
    const double t9 = omega[0] * t2 - omega[1] * t1 + t8;
    const double t10 = o_ddot[0] + (omega_dot[1] * t3 - omega_dot[2] * t2);
    const double t11 = o_ddot[1] + (omega_dot[2] * t1 - omega_dot[0] * t3);
    const double t12 = o_ddot[2] + (omega_dot[0] * t2 - omega_dot[1] * t1);
    const double t13 = Q[0] * rho_ddot[0] + Q[1] * rho_ddot[1] + Q[2] * rho_ddot[2];
    const double p_ddot0 = t10 + (omega[1] * t9 - omega[2] * t7) + t13;
    const double t14 = Q[3] * rho_ddot[0] + Q[4] * rho_ddot[1] + Q[5] * rho_ddot[2];
    const double p_ddot1 = t11 + (omega[2] * t5 - omega[0] * t9) + t14;
    const double t15 = Q[6] * rho_ddot[0] + Q[7] * rho_ddot[1] + Q[8] * rho_ddot[2];
    const double p_ddot2 = t12 + (omega[0] * t7 - omega[1] * t5) + t15;
    p_ddot[0] = p_ddot0;
    p_ddot[1] = p_ddot1;
    p_ddot[2] = p_ddot2;
}

/*
 * (3.105) chasles_moving_frame_acceleration in single precision.
 *   verdict: holds; assumes nothing
 *   87 operations; derivation sha256 985f244a1c015e00a6d544a9a346e7446722d3d1972e549159bc1a6a90456d40
 */
void chasles_moving_frame_accelerationf(
    const float o_ddot[3],
    const float Q[9],
    const float omega[3],
    const float omega_dot[3],
    const float rho[3],
    const float rho_dot[3],
    const float rho_ddot[3],
    float p_ddot[3])
{
    const float t1 = Q[0] * rho[0] + Q[1] * rho[1] + Q[2] * rho[2];
    const float t2 = Q[3] * rho[0] + Q[4] * rho[1] + Q[5] * rho[2];
    const float t3 = Q[6] * rho[0] + Q[7] * rho[1] + Q[8] * rho[2];
    const float t4 = 2.0f * (Q[0] * rho_dot[0] + Q[1] * rho_dot[1] + Q[2] * rho_dot[2]);
    const float t5 = omega[1] * t3 - omega[2] * t2 + t4;
    const float t6 = 2.0f * (Q[3] * rho_dot[0] + Q[4] * rho_dot[1] + Q[5] * rho_dot[2]);
    const float t7 = omega[2] * t1 - omega[0] * t3 + t6;
    const float t8 = 2.0f * (Q[6] * rho_dot[0] + Q[7] * rho_dot[1] + Q[8] * rho_dot[2]);
    const float t9 = omega[0] * t2 - omega[1] * t1 + t8;
    const float t10 = o_ddot[0] + (omega_dot[1] * t3 - omega_dot[2] * t2);
    const float t11 = o_ddot[1] + (omega_dot[2] * t1 - omega_dot[0] * t3);
    const float t12 = o_ddot[2] + (omega_dot[0] * t2 - omega_dot[1] * t1);
    const float t13 = Q[0] * rho_ddot[0] + Q[1] * rho_ddot[1] + Q[2] * rho_ddot[2];
    const float p_ddot0 = t10 + (omega[1] * t9 - omega[2] * t7) + t13;
    const float t14 = Q[3] * rho_ddot[0] + Q[4] * rho_ddot[1] + Q[5] * rho_ddot[2];
    const float p_ddot1 = t11 + (omega[2] * t5 - omega[0] * t9) + t14;
    const float t15 = Q[6] * rho_ddot[0] + Q[7] * rho_ddot[1] + Q[8] * rho_ddot[2];
    const float p_ddot2 = t12 + (omega[0] * t7 - omega[1] * t5) + t15;
    p_ddot[0] = p_ddot0;
    p_ddot[1] = p_ddot1;
    p_ddot[2] = p_ddot2;
}

/*
 * (3.105) chasles_moving_frame_acceleration for a batch.
 *   verdict: holds; assumes nothing
 *   87 operations; derivation sha256 985f244a1c015e00a6d544a9a346e7446722d3d1972e549159bc1a6a90456d40
 */
void chasles_moving_frame_acceleration_batch(
    size_t count,
    const double *o_ddot, ptrdiff_t o_ddot_step,
    const double *Q, ptrdiff_t Q_step,
    const double *omega, ptrdiff_t omega_step,
    const double *omega_dot, ptrdiff_t omega_dot_step,
    const double *rho, ptrdiff_t rho_step,
    const double *rho_dot, ptrdiff_t rho_dot_step,
    const double *rho_ddot, ptrdiff_t rho_ddot_step,
    double *p_ddot, ptrdiff_t p_ddot_step)
{
    char *const at[] = {
        (char *)o_ddot,
        (char *)Q,
        (char *)omega,
        (char *)omega_dot,
        (char *)rho,
        (char *)rho_dot,
        (char *)rho_ddot,
        (char *)p_ddot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        o_ddot_step * size,
        Q_step * size,
        omega_step * size,
        omega_dot_step * size,
        rho_step * size,
        rho_dot_step * size,
        rho_ddot_step * size,
        p_ddot_step * size};
    const chasles_loop *loop = &chasles_moving_frame_acceleration_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.105) chasles_moving_frame_accelerationf for a batch.
 *   verdict: holds; assumes nothing
 *   87 operations; derivation sha256 985f244a1c015e00a6d544a9a346e7446722d3d1972e549159bc1a6a90456d40
 */
void chasles_moving_frame_acceleration_batchf(
    size_t count,
    const float *o_ddot, ptrdiff_t o_ddot_step,
    const float *Q, ptrdiff_t Q_step,
    const float *omega, ptrdiff_t omega_step,
    const float *omega_dot, ptrdiff_t omega_dot_step,
    const float *rho, ptrdiff_t rho_step,
    const float *rho_dot, ptrdiff_t rho_dot_step,
    const float *rho_ddot, ptrdiff_t rho_ddot_step,
    float *p_ddot, ptrdiff_t p_ddot_step)
{
    char *const at[] = {
        (char *)o_ddot,
        (char *)Q,
        (char *)omega,
        (char *)omega_dot,
        (char *)rho,
        (char *)rho_dot,
        (char *)rho_ddot,
        (char *)p_ddot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        o_ddot_step * size,
        Q_step * size,
        omega_step * size,
        omega_dot_step * size,
        rho_step * size,
        rho_dot_step * size,
        rho_ddot_step * size,
        p_ddot_step * size};
    const chasles_loop *loop = &chasles_moving_frame_acceleration_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

#endif
