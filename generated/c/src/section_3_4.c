/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The kernels of section_3_4. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"
#include "loops.h"

static const chasles_shape chasles_velocity_of_point_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_velocity_of_point_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_velocity_of_point_loop_shapes,
    CHASLES_BLOCKS(chasles_velocity_of_point_block),
};

static const chasles_shape chasles_velocity_of_point_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_velocity_of_point_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_velocity_of_point_loopf_shapes,
    CHASLES_BLOCKS(chasles_velocity_of_point_blockf),
};

#if !(CHASLES_VECTORS && defined(CHASLES_BLOCKS_ALONE))

/*
 * (3.50) The velocity of a point from that of the landmark.
 *   given       omega[3]: angular velocity
 *               a_dot[3]: time derivative of: position of the landmark point A
 *               a[3]: position of the landmark point A
 *               p[3]: position of any point P
 *   returns     p_dot[3]: time derivative of: position of any point P
 *   verdict     holds
 *   assumes     nothing
 *   operations  15: 3 add, 6 subtract, 6 multiply
 *   error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 b5acf63f8b2ae232595725548e5ba32264be6bf6d52d501066130e78c9ed0486
 */
void chasles_velocity_of_point(
    const double omega[3],
    const double a_dot[3],
    const double a[3],
    const double p[3],
    double p_dot[3])
{
    const double t1 = p[0] - a[0];
    const double t2 = p[1] - a[1];
    const double t3 = p[2] - a[2];
    const double p_dot0 = a_dot[0] + (omega[1] * t3 - omega[2] * t2);
    const double p_dot1 = a_dot[1] + (omega[2] * t1 - omega[0] * t3);
    const double p_dot2 = a_dot[2] + (omega[0] * t2 - omega[1] * t1);
    p_dot[0] = p_dot0;
    p_dot[1] = p_dot1;
    p_dot[2] = p_dot2;
}

/*
 * (3.50) chasles_velocity_of_point in single precision.
 *   verdict: holds; assumes nothing
 *   15 operations; derivation sha256 b5acf63f8b2ae232595725548e5ba32264be6bf6d52d501066130e78c9ed0486
 */
void chasles_velocity_of_pointf(
    const float omega[3],
    const float a_dot[3],
    const float a[3],
    const float p[3],
    float p_dot[3])
{
    const float t1 = p[0] - a[0];
    const float t2 = p[1] - a[1];
    const float t3 = p[2] - a[2];
    const float p_dot0 = a_dot[0] + (omega[1] * t3 - omega[2] * t2);
    const float p_dot1 = a_dot[1] + (omega[2] * t1 - omega[0] * t3);
    const float p_dot2 = a_dot[2] + (omega[0] * t2 - omega[1] * t1);
    p_dot[0] = p_dot0;
    p_dot[1] = p_dot1;
    p_dot[2] = p_dot2;
}

/*
 * (3.50) chasles_velocity_of_point for a batch.
 *   verdict: holds; assumes nothing
 *   15 operations; derivation sha256 b5acf63f8b2ae232595725548e5ba32264be6bf6d52d501066130e78c9ed0486
 */
void chasles_velocity_of_point_batch(
    size_t count,
    const double *omega, ptrdiff_t omega_step,
    const double *a_dot, ptrdiff_t a_dot_step,
    const double *a, ptrdiff_t a_step,
    const double *p, ptrdiff_t p_step,
    double *p_dot, ptrdiff_t p_dot_step)
{
    char *const at[] = {(char *)omega, (char *)a_dot, (char *)a, (char *)p, (char *)p_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        omega_step * size,
        a_dot_step * size,
        a_step * size,
        p_step * size,
        p_dot_step * size};
    const chasles_loop *loop = &chasles_velocity_of_point_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.50) chasles_velocity_of_pointf for a batch.
 *   verdict: holds; assumes nothing
 *   15 operations; derivation sha256 b5acf63f8b2ae232595725548e5ba32264be6bf6d52d501066130e78c9ed0486
 */
void chasles_velocity_of_point_batchf(
    size_t count,
    const float *omega, ptrdiff_t omega_step,
    const float *a_dot, ptrdiff_t a_dot_step,
    const float *a, ptrdiff_t a_step,
    const float *p, ptrdiff_t p_step,
    float *p_dot, ptrdiff_t p_dot_step)
{
    char *const at[] = {(char *)omega, (char *)a_dot, (char *)a, (char *)p, (char *)p_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        omega_step * size,
        a_dot_step * size,
        a_step * size,
        p_step * size,
        p_dot_step * size};
    const chasles_loop *loop = &chasles_velocity_of_point_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

#endif
