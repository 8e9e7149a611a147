/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The kernels of section_3_2_3. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"
#include "loops.h"

static const chasles_shape chasles_rotation_in_triad_axes_loop_shapes[] = {
    {2, 3, 3},
    {2, 3, 3},
    {2, 3, 3},
};
const chasles_loop chasles_rotation_in_triad_axes_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_rotation_in_triad_axes_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_in_triad_axes_block),
};

static const chasles_shape chasles_rotation_in_triad_axes_loopf_shapes[] = {
    {2, 3, 3},
    {2, 3, 3},
    {2, 3, 3},
};
const chasles_loop chasles_rotation_in_triad_axes_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_rotation_in_triad_axes_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_in_triad_axes_blockf),
};

static const chasles_shape chasles_rotation_from_triads_loop_shapes[] = {
    {2, 3, 3},
    {2, 3, 3},
    {2, 3, 3},
};
const chasles_loop chasles_rotation_from_triads_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_rotation_from_triads_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_triads_block),
};

static const chasles_shape chasles_rotation_from_triads_loopf_shapes[] = {
    {2, 3, 3},
    {2, 3, 3},
    {2, 3, 3},
};
const chasles_loop chasles_rotation_from_triads_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_rotation_from_triads_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_triads_blockf),
};

#if !(CHASLES_VECTORS && defined(CHASLES_BLOCKS_ALONE))

/*
 * text 3.2.3 h The rotation in the axes of the triad, as a product of matrices.
 *   given       triad[9]: the triad as columns
 *               triad_prime[9]: the displaced triad as columns
 *   returns     Q[9]: components of the rotation in the axes of the triad
 *   verdict     holds
 *   assumes     nothing
 *   expects     triad is a rotation
 *               triad' is a rotation
 *   operations  45: 18 add, 27 multiply
 *   error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 17b2c6690d171cd369c93be59a7a8c3b70bc0108c48d7358142e2312ebf805ee
 */
void chasles_rotation_in_triad_axes(const double triad[9], const double triad_prime[9], double Q[9])
{
    const double t1 = triad[0] * triad_prime[0] + triad[3] * triad_prime[3];
    const double Q0 = t1 + triad[6] * triad_prime[6];
    const double t2 = triad[0] * triad_prime[1] + triad[3] * triad_prime[4];
    const double Q1 = t2 + triad[6] * triad_prime[7];
    const double t3 = triad[0] * triad_prime[2] + triad[3] * triad_prime[5];
    const double Q2 = t3 + triad[6] * triad_prime[8];
    const double t4 = triad[1] * triad_prime[0] + triad[4] * triad_prime[3];
    const double Q3 = t4 + triad[7] * triad_prime[6];
    const double t5 = triad[1] * triad_prime[1] + triad[4] * triad_prime[4];
    const double Q4 = t5 + triad[7] * triad_prime[7];
    const double t6 = triad[1] * triad_prime[2] + triad[4] * triad_prime[5];
    const double Q5 = t6 + triad[7] * triad_prime[8];
    const double t7 = triad[2] * triad_prime[0] + triad[5] * triad_prime[3];
    const double Q6 = t7 + triad[8] * triad_prime[6];
    const double t8 = triad[2] * triad_prime[1] + triad[5] * triad_prime[4];
    const double Q7 = t8 + triad[8] * triad_prime[7];
    const double t9 = triad[2] * triad_prime[2] + triad[5] * triad_prime[5];
    const double Q8 = t9 + triad[8] * triad_prime[8];
    Q[0] = Q0;
    Q[1] = Q1;
    Q[2] = Q2;
    Q[3] = Q3;
    Q[4] = Q4;
    Q[5] = Q5;
    Q[6] = Q6;
    Q[7] = Q7;
    Q[8] = Q8;
}

/*
 * text 3.2.3 h chasles_rotation_in_triad_axes in single precision.
 *   verdict: holds; assumes nothing
 *   45 operations; derivation sha256 17b2c6690d171cd369c93be59a7a8c3b70bc0108c48d7358142e2312ebf805ee
 */
void chasles_rotation_in_triad_axesf(const float triad[9], const float triad_prime[9], float Q[9])
{
    const float t1 = triad[0] * triad_prime[0] + triad[3] * triad_prime[3];
    const float Q0 = t1 + triad[6] * triad_prime[6];
    const float t2 = triad[0] * triad_prime[1] + triad[3] * triad_prime[4];
    const float Q1 = t2 + triad[6] * triad_prime[7];
    const float t3 = triad[0] * triad_prime[2] + triad[3] * triad_prime[5];
    const float Q2 = t3 + triad[6] * triad_prime[8];
    const float t4 = triad[1] * triad_prime[0] + triad[4] * triad_prime[3];
    const float Q3 = t4 + triad[7] * triad_prime[6];
    const float t5 = triad[1] * triad_prime[1] + triad[4] * triad_prime[4];
    const float Q4 = t5 + triad[7] * triad_prime[7];
    const float t6 = triad[1] * triad_prime[2] + triad[4] * triad_prime[5];
    const float Q5 = t6 + triad[7] * triad_prime[8];
    const float t7 = triad[2] * triad_prime[0] + triad[5] * triad_prime[3];
    const float Q6 = t7 + triad[8] * triad_prime[6];
    const float t8 = triad[2] * triad_prime[1] + triad[5] * triad_prime[4];
    const float Q7 = t8 + triad[8] * triad_prime[7];
    const float t9 = triad[2] * triad_prime[2] + triad[5] * triad_prime[5];
    const float Q8 = t9 + triad[8] * triad_prime[8];
    Q[0] = Q0;
    Q[1] = Q1;
    Q[2] = Q2;
    Q[3] = Q3;
    Q[4] = Q4;
    Q[5] = Q5;
    Q[6] = Q6;
    Q[7] = Q7;
    Q[8] = Q8;
}

/*
 * text 3.2.3 h chasles_rotation_in_triad_axes for a batch.
 *   verdict: holds; assumes nothing
 *   45 operations; derivation sha256 17b2c6690d171cd369c93be59a7a8c3b70bc0108c48d7358142e2312ebf805ee
 */
void chasles_rotation_in_triad_axes_batch(
    size_t count,
    const double *triad, ptrdiff_t triad_step,
    const double *triad_prime, ptrdiff_t triad_prime_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)triad, (char *)triad_prime, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {triad_step * size, triad_prime_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_in_triad_axes_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.2.3 h chasles_rotation_in_triad_axesf for a batch.
 *   verdict: holds; assumes nothing
 *   45 operations; derivation sha256 17b2c6690d171cd369c93be59a7a8c3b70bc0108c48d7358142e2312ebf805ee
 */
void chasles_rotation_in_triad_axes_batchf(
    size_t count,
    const float *triad, ptrdiff_t triad_step,
    const float *triad_prime, ptrdiff_t triad_prime_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)triad, (char *)triad_prime, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {triad_step * size, triad_prime_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_in_triad_axes_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.2.3 g The rotation that takes one triad into the other, in the frame in which both are given.
 *   given       triad[9]: the triad as columns
 *               triad_prime[9]: the displaced triad as columns
 *   returns     Q[9]: rotation
 *   verdict     holds under
 *   assumes     e_1, e_2, e_3 are orthonormal and right-handed
 *   expects     triad is a rotation
 *               triad' is a rotation
 *   operations  45: 18 add, 27 multiply
 *   error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 0c12a1c3d699670fac6168e45da2070083d35015f2bd6eac4cd2f1464da2b780
 */
void chasles_rotation_from_triads(const double triad[9], const double triad_prime[9], double Q[9])
{
    const double t1 = triad[0] * triad_prime[0] + triad[1] * triad_prime[1];
    const double Q0 = t1 + triad[2] * triad_prime[2];
    const double t2 = triad[3] * triad_prime[0] + triad[4] * triad_prime[1];
    const double Q1 = t2 + triad[5] * triad_prime[2];
    const double t3 = triad[6] * triad_prime[0] + triad[7] * triad_prime[1];
    const double Q2 = t3 + triad[8] * triad_prime[2];
    const double t4 = triad[0] * triad_prime[3] + triad[1] * triad_prime[4];
    const double Q3 = t4 + triad[2] * triad_prime[5];
    const double t5 = triad[3] * triad_prime[3] + triad[4] * triad_prime[4];
    const double Q4 = t5 + triad[5] * triad_prime[5];
    const double t6 = triad[6] * triad_prime[3] + triad[7] * triad_prime[4];
    const double Q5 = t6 + triad[8] * triad_prime[5];
    const double t7 = triad[0] * triad_prime[6] + triad[1] * triad_prime[7];
    const double Q6 = t7 + triad[2] * triad_prime[8];
    const double t8 = triad[3] * triad_prime[6] + triad[4] * triad_prime[7];
    const double Q7 = t8 + triad[5] * triad_prime[8];
    const double t9 = triad[6] * triad_prime[6] + triad[7] * triad_prime[7];
    const double Q8 = t9 + triad[8] * triad_prime[8];
    Q[0] = Q0;
    Q[1] = Q1;
    Q[2] = Q2;
    Q[3] = Q3;
    Q[4] = Q4;
    Q[5] = Q5;
    Q[6] = Q6;
    Q[7] = Q7;
    Q[8] = Q8;
}

/*
 * text 3.2.3 g chasles_rotation_from_triads in single precision.
 *   verdict: holds under; assumes e_1, e_2, e_3 are orthonormal and right-handed
 *   45 operations; derivation sha256 0c12a1c3d699670fac6168e45da2070083d35015f2bd6eac4cd2f1464da2b780
 */
void chasles_rotation_from_triadsf(const float triad[9], const float triad_prime[9], float Q[9])
{
    const float t1 = triad[0] * triad_prime[0] + triad[1] * triad_prime[1];
    const float Q0 = t1 + triad[2] * triad_prime[2];
    const float t2 = triad[3] * triad_prime[0] + triad[4] * triad_prime[1];
    const float Q1 = t2 + triad[5] * triad_prime[2];
    const float t3 = triad[6] * triad_prime[0] + triad[7] * triad_prime[1];
    const float Q2 = t3 + triad[8] * triad_prime[2];
    const float t4 = triad[0] * triad_prime[3] + triad[1] * triad_prime[4];
    const float Q3 = t4 + triad[2] * triad_prime[5];
    const float t5 = triad[3] * triad_prime[3] + triad[4] * triad_prime[4];
    const float Q4 = t5 + triad[5] * triad_prime[5];
    const float t6 = triad[6] * triad_prime[3] + triad[7] * triad_prime[4];
    const float Q5 = t6 + triad[8] * triad_prime[5];
    const float t7 = triad[0] * triad_prime[6] + triad[1] * triad_prime[7];
    const float Q6 = t7 + triad[2] * triad_prime[8];
    const float t8 = triad[3] * triad_prime[6] + triad[4] * triad_prime[7];
    const float Q7 = t8 + triad[5] * triad_prime[8];
    const float t9 = triad[6] * triad_prime[6] + triad[7] * triad_prime[7];
    const float Q8 = t9 + triad[8] * triad_prime[8];
    Q[0] = Q0;
    Q[1] = Q1;
    Q[2] = Q2;
    Q[3] = Q3;
    Q[4] = Q4;
    Q[5] = Q5;
    Q[6] = Q6;
    Q[7] = Q7;
    Q[8] = Q8;
}

/*
 * text 3.2.3 g chasles_rotation_from_triads for a batch.
 *   verdict: holds under; assumes e_1, e_2, e_3 are orthonormal and right-handed
 *   45 operations; derivation sha256 0c12a1c3d699670fac6168e45da2070083d35015f2bd6eac4cd2f1464da2b780
 */
void chasles_rotation_from_triads_batch(
    size_t count,
    const double *triad, ptrdiff_t triad_step,
    const double *triad_prime, ptrdiff_t triad_prime_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)triad, (char *)triad_prime, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {triad_step * size, triad_prime_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_triads_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.2.3 g chasles_rotation_from_triadsf for a batch.
 *   verdict: holds under; assumes e_1, e_2, e_3 are orthonormal and right-handed
 *   45 operations; derivation sha256 0c12a1c3d699670fac6168e45da2070083d35015f2bd6eac4cd2f1464da2b780
 */
void chasles_rotation_from_triads_batchf(
    size_t count,
    const float *triad, ptrdiff_t triad_step,
    const float *triad_prime, ptrdiff_t triad_prime_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)triad, (char *)triad_prime, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {triad_step * size, triad_prime_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_triads_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

#endif
