/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The kernels of section_3_4_1. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"
#include "loops.h"

static const chasles_shape chasles_instant_screw_point_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_instant_screw_point_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_instant_screw_point_loop_shapes,
    CHASLES_BLOCKS(chasles_instant_screw_point_block),
};

static const chasles_shape chasles_instant_screw_point_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_instant_screw_point_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_instant_screw_point_loopf_shapes,
    CHASLES_BLOCKS(chasles_instant_screw_point_blockf),
};

#if !(CHASLES_VECTORS && defined(CHASLES_BLOCKS_ALONE))

/*
 * (3.70) The point of the instant screw axis nearest the origin, with vector products.
 *   given       omega[3]: angular velocity
 *               a_dot[3]: time derivative of: position of the landmark point A
 *               a[3]: position of the landmark point A
 *   returns     p_0_prime[3]: position of the point of the instant screw axis nearest the origin
 *   verdict     holds under
 *   assumes     omega != 0
 *   operations  35: 2 add, 9 subtract, 15 multiply, 9 divide
 *   error bound 13.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 8add5ae098bd1648bf2231d712391a8ce89357247f8df1a150855707c8b25192
 */
void chasles_instant_screw_point(
    const double omega[3],
    const double a_dot[3],
    const double a[3],
    double p_0_prime[3])
{
    const double t1 = omega[0] < 0.0 ? -omega[0] : omega[0];
    const double t2 = omega[1] < 0.0 ? -omega[1] : omega[1];
    const double t3 = t1 < t2 ? t2 : t1;
    const double t4 = omega[2] < 0.0 ? -omega[2] : omega[2];
    const double t5 = t3 < t4 ? t4 : t3;
    const double t6 = 0.0 == t5 ? 1.0 : t5;
    const double t7 = omega[0] / t6;
    const double t8 = omega[1] / t6;
    const double t9 = omega[2] / t6;
    const double t10 = t7 * t7 + t8 * t8 + t9 * t9;
    const double t11 = a_dot[0] - (omega[1] * a[2] - omega[2] * a[1]);
    const double t12 = a_dot[1] - (omega[2] * a[0] - omega[0] * a[2]);
    const double t13 = a_dot[2] - (omega[0] * a[1] - omega[1] * a[0]);
    const int t14 = t10 == 0.0;
    const double p_0_prime0 = (t14 ? 0.0 : t8 * t13 - t9 * t12) / t10 / t6;
    const double p_0_prime1 = (t14 ? 0.0 : t9 * t11 - t7 * t13) / t10 / t6;
    const double p_0_prime2 = (t14 ? 0.0 : t7 * t12 - t8 * t11) / t10 / t6;
    p_0_prime[0] = p_0_prime0;
    p_0_prime[1] = p_0_prime1;
    p_0_prime[2] = p_0_prime2;
}

/*
 * (3.70) chasles_instant_screw_point in single precision.
 *   verdict: holds under; assumes omega != 0
 *   35 operations; derivation sha256 8add5ae098bd1648bf2231d712391a8ce89357247f8df1a150855707c8b25192
 */
void chasles_instant_screw_pointf(
    const float omega[3],
    const float a_dot[3],
    const float a[3],
    float p_0_prime[3])
{
    const float t1 = omega[0] < 0.0f ? -omega[0] : omega[0];
    const float t2 = omega[1] < 0.0f ? -omega[1] : omega[1];
    const float t3 = t1 < t2 ? t2 : t1;
    const float t4 = omega[2] < 0.0f ? -omega[2] : omega[2];
    const float t5 = t3 < t4 ? t4 : t3;
    const float t6 = 0.0f == t5 ? 1.0f : t5;
    const float t7 = omega[0] / t6;
    const float t8 = omega[1] / t6;
    const float t9 = omega[2] / t6;
    const float t10 = t7 * t7 + t8 * t8 + t9 * t9;
    const float t11 = a_dot[0] - (omega[1] * a[2] - omega[2] * a[1]);
    const float t12 = a_dot[1] - (omega[2] * a[0] - omega[0] * a[2]);
    const float t13 = a_dot[2] - (omega[0] * a[1] - omega[1] * a[0]);
    const int t14 = t10 == 0.0f;
    const float p_0_prime0 = (t14 ? 0.0f : t8 * t13 - t9 * t12) / t10 / t6;
    const float p_0_prime1 = (t14 ? 0.0f : t9 * t11 - t7 * t13) / t10 / t6;
    const float p_0_prime2 = (t14 ? 0.0f : t7 * t12 - t8 * t11) / t10 / t6;
    p_0_prime[0] = p_0_prime0;
    p_0_prime[1] = p_0_prime1;
    p_0_prime[2] = p_0_prime2;
}

/*
 * (3.70) chasles_instant_screw_point for a batch.
 *   verdict: holds under; assumes omega != 0
 *   35 operations; derivation sha256 8add5ae098bd1648bf2231d712391a8ce89357247f8df1a150855707c8b25192
 */
void chasles_instant_screw_point_batch(
    size_t count,
    const double *omega, ptrdiff_t omega_step,
    const double *a_dot, ptrdiff_t a_dot_step,
    const double *a, ptrdiff_t a_step,
    double *p_0_prime, ptrdiff_t p_0_prime_step)
{
    char *const at[] = {(char *)omega, (char *)a_dot, (char *)a, (char *)p_0_prime};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        omega_step * size,
        a_dot_step * size,
        a_step * size,
        p_0_prime_step * size};
    const chasles_loop *loop = &chasles_instant_screw_point_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.70) chasles_instant_screw_pointf for a batch.
 *   verdict: holds under; assumes omega != 0
 *   35 operations; derivation sha256 8add5ae098bd1648bf2231d712391a8ce89357247f8df1a150855707c8b25192
 */
void chasles_instant_screw_point_batchf(
    size_t count,
    const float *omega, ptrdiff_t omega_step,
    const float *a_dot, ptrdiff_t a_dot_step,
    const float *a, ptrdiff_t a_step,
    float *p_0_prime, ptrdiff_t p_0_prime_step)
{
    char *const at[] = {(char *)omega, (char *)a_dot, (char *)a, (char *)p_0_prime};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        omega_step * size,
        a_dot_step * size,
        a_step * size,
        p_0_prime_step * size};
    const chasles_loop *loop = &chasles_instant_screw_point_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

#endif
