/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The kernels of section_3_2_1. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"
#include "loops.h"

static const chasles_shape chasles_normal_matrix_inverse_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 3},
};
const chasles_loop chasles_normal_matrix_inverse_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_normal_matrix_inverse_loop_shapes,
    CHASLES_BLOCKS(chasles_normal_matrix_inverse_block),
};

static const chasles_shape chasles_normal_matrix_inverse_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 3},
};
const chasles_loop chasles_normal_matrix_inverse_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_normal_matrix_inverse_loopf_shapes,
    CHASLES_BLOCKS(chasles_normal_matrix_inverse_blockf),
};

static const chasles_shape chasles_screw_axis_point_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_screw_axis_point_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    4, 5, chasles_screw_axis_point_loop_shapes,
    CHASLES_BLOCKS(chasles_screw_axis_point_block),
};

static const chasles_shape chasles_screw_axis_point_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_screw_axis_point_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    4, 5, chasles_screw_axis_point_loopf_shapes,
    CHASLES_BLOCKS(chasles_screw_axis_point_blockf),
};

#if !(CHASLES_VECTORS && defined(CHASLES_BLOCKS_ALONE))

/*
 * (3.16) The inverse of the matrix of the normal equations.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *   returns     result[9]: (A^T A)^-1
 *   verdict     holds under
 *   assumes     phi != 0
 *               |e| = 1
 *   operations  17: 3 add, 1 subtract, 11 multiply, 1 divide, 1 sine
 *   error bound 8.4 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine within 0.8 ulp
 *   derivation  sha256 1a335cc68a85257903e9024003c40a39af04dc468b703619f454e7c6495b1c9c
 */
void chasles_normal_matrix_inverse(const double e[3], double phi, double result[9])
{
    const double t1 = sin(0.5 * phi);
    const double t2 = (t1 == 0.0 ? 0.0 : 0.5) / t1;
    const double t3 = t2 * t2;
    const double t4 = 1.0 - t3;
    const double t5 = e[0] * t4;
    const double t6 = e[1] * t4;
    const double result1 = e[1] * t5;
    const double result2 = e[2] * t5;
    const double result5 = e[2] * t6;
    const double result0 = t3 + e[0] * t5;
    const double result4 = t3 + e[1] * t6;
    const double result8 = t3 + e[2] * (e[2] * t4);
    result[0] = result0;
    result[1] = result1;
    result[2] = result2;
    result[3] = result1;
    result[4] = result4;
    result[5] = result5;
    result[6] = result2;
    result[7] = result5;
    result[8] = result8;
}

/*
 * (3.16) chasles_normal_matrix_inverse in single precision.
 *   verdict: holds under; assumes phi != 0, |e| = 1
 *   17 operations; derivation sha256 1a335cc68a85257903e9024003c40a39af04dc468b703619f454e7c6495b1c9c
 */
void chasles_normal_matrix_inversef(const float e[3], float phi, float result[9])
{
    const float t1 = sinf(0.5f * phi);
    const float t2 = (t1 == 0.0f ? 0.0f : 0.5f) / t1;
    const float t3 = t2 * t2;
    const float t4 = 1.0f - t3;
    const float t5 = e[0] * t4;
    const float t6 = e[1] * t4;
    const float result1 = e[1] * t5;
    const float result2 = e[2] * t5;
    const float result5 = e[2] * t6;
    const float result0 = t3 + e[0] * t5;
    const float result4 = t3 + e[1] * t6;
    const float result8 = t3 + e[2] * (e[2] * t4);
    result[0] = result0;
    result[1] = result1;
    result[2] = result2;
    result[3] = result1;
    result[4] = result4;
    result[5] = result5;
    result[6] = result2;
    result[7] = result5;
    result[8] = result8;
}

/*
 * (3.16) chasles_normal_matrix_inverse for a batch.
 *   verdict: holds under; assumes phi != 0, |e| = 1
 *   17 operations; derivation sha256 1a335cc68a85257903e9024003c40a39af04dc468b703619f454e7c6495b1c9c
 */
void chasles_normal_matrix_inverse_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *result, ptrdiff_t result_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)result};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, result_step * size};
    const chasles_loop *loop = &chasles_normal_matrix_inverse_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.16) chasles_normal_matrix_inversef for a batch.
 *   verdict: holds under; assumes phi != 0, |e| = 1
 *   17 operations; derivation sha256 1a335cc68a85257903e9024003c40a39af04dc468b703619f454e7c6495b1c9c
 */
void chasles_normal_matrix_inverse_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *result, ptrdiff_t result_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)result};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, result_step * size};
    const chasles_loop *loop = &chasles_normal_matrix_inverse_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.18) The point of the screw axis nearest the origin.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               a[3]: position of the landmark point A
 *               a_prime[3]: position of A after the displacement
 *   returns     p_0[3]: position of the point of the screw axis nearest the origin
 *   verdict     holds under
 *   assumes     phi != 0
 *               |e| = 1
 *   made of     an offered form, proved equal to the statement
 *   operations  39: 5 add, 12 subtract, 19 multiply, 1 divide, 1 sine, 1 cosine
 *   error bound 9.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 41aeb7a69bd4c902412187ac18c770eab3e24db7018b56881eddfad568648df0
 */
void chasles_screw_axis_point(
    const double e[3],
    double phi,
    const double a[3],
    const double a_prime[3],
    double p_0[3])
{
    const double t1 = a[0] + a_prime[0];
    const double t2 = a[1] + a_prime[1];
    const double t3 = a[2] + a_prime[2];
    const double t4 = e[0] * t1 + e[1] * t2 + e[2] * t3;
    const double t5 = a_prime[0] - a[0];
    const double t6 = a_prime[1] - a[1];
    const double t7 = a_prime[2] - a[2];
    const double half_phi = 0.5 * phi;
    const double sin_half_phi = sin(half_phi);
    const double t8 = (sin_half_phi == 0.0 ? 0.0 : cos(half_phi)) / sin_half_phi;
    const double p_0_0 = 0.5 * ((e[1] * t7 - e[2] * t6) * t8 - (e[0] * t4 - t1));
    const double p_0_1 = 0.5 * ((e[2] * t5 - e[0] * t7) * t8 - (e[1] * t4 - t2));
    const double p_0_2 = 0.5 * ((e[0] * t6 - e[1] * t5) * t8 - (e[2] * t4 - t3));
    p_0[0] = p_0_0;
    p_0[1] = p_0_1;
    p_0[2] = p_0_2;
}

/*
 * (3.18) chasles_screw_axis_point in single precision.
 *   verdict: holds under; assumes phi != 0, |e| = 1
 *   39 operations; derivation sha256 41aeb7a69bd4c902412187ac18c770eab3e24db7018b56881eddfad568648df0
 */
void chasles_screw_axis_pointf(
    const float e[3],
    float phi,
    const float a[3],
    const float a_prime[3],
    float p_0[3])
{
    const float t1 = a[0] + a_prime[0];
    const float t2 = a[1] + a_prime[1];
    const float t3 = a[2] + a_prime[2];
    const float t4 = e[0] * t1 + e[1] * t2 + e[2] * t3;
    const float t5 = a_prime[0] - a[0];
    const float t6 = a_prime[1] - a[1];
    const float t7 = a_prime[2] - a[2];
    const float half_phi = 0.5f * phi;
    const float sin_half_phi = sinf(half_phi);
    const float t8 = (sin_half_phi == 0.0f ? 0.0f : cosf(half_phi)) / sin_half_phi;
    const float p_0_0 = 0.5f * ((e[1] * t7 - e[2] * t6) * t8 - (e[0] * t4 - t1));
    const float p_0_1 = 0.5f * ((e[2] * t5 - e[0] * t7) * t8 - (e[1] * t4 - t2));
    const float p_0_2 = 0.5f * ((e[0] * t6 - e[1] * t5) * t8 - (e[2] * t4 - t3));
    p_0[0] = p_0_0;
    p_0[1] = p_0_1;
    p_0[2] = p_0_2;
}

/*
 * (3.18) chasles_screw_axis_point for a batch.
 *   verdict: holds under; assumes phi != 0, |e| = 1
 *   39 operations; derivation sha256 41aeb7a69bd4c902412187ac18c770eab3e24db7018b56881eddfad568648df0
 */
void chasles_screw_axis_point_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *a, ptrdiff_t a_step,
    const double *a_prime, ptrdiff_t a_prime_step,
    double *p_0, ptrdiff_t p_0_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)a, (char *)a_prime, (char *)p_0};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        a_step * size,
        a_prime_step * size,
        p_0_step * size};
    const chasles_loop *loop = &chasles_screw_axis_point_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.18) chasles_screw_axis_pointf for a batch.
 *   verdict: holds under; assumes phi != 0, |e| = 1
 *   39 operations; derivation sha256 41aeb7a69bd4c902412187ac18c770eab3e24db7018b56881eddfad568648df0
 */
void chasles_screw_axis_point_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *a, ptrdiff_t a_step,
    const float *a_prime, ptrdiff_t a_prime_step,
    float *p_0, ptrdiff_t p_0_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)a, (char *)a_prime, (char *)p_0};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        e_step * size,
        phi_step * size,
        a_step * size,
        a_prime_step * size,
        p_0_step * size};
    const chasles_loop *loop = &chasles_screw_axis_point_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

#endif
