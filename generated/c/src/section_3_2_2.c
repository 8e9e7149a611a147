/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The kernels of section_3_2_2. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"
#include "loops.h"

static const chasles_shape chasles_plucker_line_loop_shapes[] = {{1, 1, 3}, {1, 1, 3}, {1, 1, 6}};
const chasles_loop chasles_plucker_line_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_plucker_line_loop_shapes,
    CHASLES_BLOCKS(chasles_plucker_line_block),
};

static const chasles_shape chasles_plucker_line_loopf_shapes[] = {{1, 1, 3}, {1, 1, 3}, {1, 1, 6}};
const chasles_loop chasles_plucker_line_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_plucker_line_loopf_shapes,
    CHASLES_BLOCKS(chasles_plucker_line_blockf),
};

static const chasles_shape chasles_plucker_transfer_loop_shapes[] = {
    {1, 1, 6},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
};
const chasles_loop chasles_plucker_transfer_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_plucker_transfer_loop_shapes,
    CHASLES_BLOCKS(chasles_plucker_transfer_block),
};

static const chasles_shape chasles_plucker_transfer_loopf_shapes[] = {
    {1, 1, 6},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
};
const chasles_loop chasles_plucker_transfer_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_plucker_transfer_loopf_shapes,
    CHASLES_BLOCKS(chasles_plucker_transfer_blockf),
};

#if !(CHASLES_VECTORS && defined(CHASLES_BLOCKS_ALONE))

/*
 * (3.23) The Plücker array of a line: its direction and its moment.
 *   given       p_1[3]: position of point P_1
 *               p_2[3]: position of point P_2
 *   returns     kappa[6]: Pluecker array: direction and moment
 *   verdict     defined
 *   assumes     p_1 != p_2
 *   operations  24: 2 add, 6 subtract, 9 multiply, 6 divide, 1 square root
 *   error bound 9.51 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 32c3975b5a0a9106d94e083a43fadc2be5fbb7bda4c600d797436f2a818ba4e5
 */
void chasles_plucker_line(const double p_1[3], const double p_2[3], double kappa[6])
{
    const double t1 = p_2[0] - p_1[0];
    const double t2 = p_2[1] - p_1[1];
    const double t3 = p_2[2] - p_1[2];
    const double t4 = t1 < 0.0 ? -t1 : t1;
    const double t5 = t2 < 0.0 ? -t2 : t2;
    const double t6 = t4 < t5 ? t5 : t4;
    const double t7 = t3 < 0.0 ? -t3 : t3;
    const double t8 = t6 < t7 ? t7 : t6;
    const double t9 = 0.0 == t8 ? 1.0 : t8;
    const double t10 = t1 / t9;
    const double t11 = t2 / t9;
    const double t12 = t3 / t9;
    const double t13 = t10 * t10 + t11 * t11 + t12 * t12;
    const double t14 = sqrt(t13);
    const int t15 = t13 == 0.0;
    const double kappa0 = (t15 ? 0.0 : t10) / t14;
    const double kappa1 = (t15 ? 0.0 : t11) / t14;
    const double kappa2 = (t15 ? 0.0 : t12) / t14;
    const double kappa3 = p_1[1] * kappa2 - p_1[2] * kappa1;
    const double kappa4 = p_1[2] * kappa0 - p_1[0] * kappa2;
    const double kappa5 = p_1[0] * kappa1 - p_1[1] * kappa0;
    kappa[0] = kappa0;
    kappa[1] = kappa1;
    kappa[2] = kappa2;
    kappa[3] = kappa3;
    kappa[4] = kappa4;
    kappa[5] = kappa5;
}

/*
 * (3.23) chasles_plucker_line in single precision.
 *   verdict: defined; assumes p_1 != p_2
 *   24 operations; derivation sha256 32c3975b5a0a9106d94e083a43fadc2be5fbb7bda4c600d797436f2a818ba4e5
 */
void chasles_plucker_linef(const float p_1[3], const float p_2[3], float kappa[6])
{
    const float t1 = p_2[0] - p_1[0];
    const float t2 = p_2[1] - p_1[1];
    const float t3 = p_2[2] - p_1[2];
    const float t4 = t1 < 0.0f ? -t1 : t1;
    const float t5 = t2 < 0.0f ? -t2 : t2;
    const float t6 = t4 < t5 ? t5 : t4;
    const float t7 = t3 < 0.0f ? -t3 : t3;
    const float t8 = t6 < t7 ? t7 : t6;
    const float t9 = 0.0f == t8 ? 1.0f : t8;
    const float t10 = t1 / t9;
    const float t11 = t2 / t9;
    const float t12 = t3 / t9;
    const float t13 = t10 * t10 + t11 * t11 + t12 * t12;
    const float t14 = sqrtf(t13);
    const int t15 = t13 == 0.0f;
    const float kappa0 = (t15 ? 0.0f : t10) / t14;
    const float kappa1 = (t15 ? 0.0f : t11) / t14;
    const float kappa2 = (t15 ? 0.0f : t12) / t14;
    const float kappa3 = p_1[1] * kappa2 - p_1[2] * kappa1;
    const float kappa4 = p_1[2] * kappa0 - p_1[0] * kappa2;
    const float kappa5 = p_1[0] * kappa1 - p_1[1] * kappa0;
    kappa[0] = kappa0;
    kappa[1] = kappa1;
    kappa[2] = kappa2;
    kappa[3] = kappa3;
    kappa[4] = kappa4;
    kappa[5] = kappa5;
}

/*
 * (3.23) chasles_plucker_line for a batch.
 *   verdict: defined; assumes p_1 != p_2
 *   24 operations; derivation sha256 32c3975b5a0a9106d94e083a43fadc2be5fbb7bda4c600d797436f2a818ba4e5
 */
void chasles_plucker_line_batch(
    size_t count,
    const double *p_1, ptrdiff_t p_1_step,
    const double *p_2, ptrdiff_t p_2_step,
    double *kappa, ptrdiff_t kappa_step)
{
    char *const at[] = {(char *)p_1, (char *)p_2, (char *)kappa};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {p_1_step * size, p_2_step * size, kappa_step * size};
    const chasles_loop *loop = &chasles_plucker_line_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.23) chasles_plucker_linef for a batch.
 *   verdict: defined; assumes p_1 != p_2
 *   24 operations; derivation sha256 32c3975b5a0a9106d94e083a43fadc2be5fbb7bda4c600d797436f2a818ba4e5
 */
void chasles_plucker_line_batchf(
    size_t count,
    const float *p_1, ptrdiff_t p_1_step,
    const float *p_2, ptrdiff_t p_2_step,
    float *kappa, ptrdiff_t kappa_step)
{
    char *const at[] = {(char *)p_1, (char *)p_2, (char *)kappa};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {p_1_step * size, p_2_step * size, kappa_step * size};
    const chasles_loop *loop = &chasles_plucker_line_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.29a) The Plücker-coordinate transfer formula.
 *   given       kappa_A[6]: Pluecker array with the moment about A
 *               a[3]: position of the landmark point A
 *               b[3]: position of point B
 *   returns     kappa_B[6]: Pluecker array with the moment about B
 *   verdict     holds
 *   assumes     nothing
 *   operations  15: 3 add, 6 subtract, 6 multiply
 *   error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 6d53a1bee79a6a2a63aafa29de9b2815a5d19f7d96ef743e8fd201bd98bf5faf
 */
void chasles_plucker_transfer(
    const double kappa_A[6],
    const double a[3],
    const double b[3],
    double kappa_B[6])
{
    const double kappa_B0 = kappa_A[0];
    const double kappa_B1 = kappa_A[1];
    const double kappa_B2 = kappa_A[2];
    const double t1 = a[0] - b[0];
    const double t2 = a[1] - b[1];
    const double t3 = a[2] - b[2];
    const double kappa_B3 = kappa_A[3] + (kappa_B2 * t2 - kappa_B1 * t3);
    const double kappa_B4 = kappa_A[4] + (kappa_B0 * t3 - kappa_B2 * t1);
    const double kappa_B5 = kappa_A[5] + (kappa_B1 * t1 - kappa_B0 * t2);
    kappa_B[0] = kappa_B0;
    kappa_B[1] = kappa_B1;
    kappa_B[2] = kappa_B2;
    kappa_B[3] = kappa_B3;
    kappa_B[4] = kappa_B4;
    kappa_B[5] = kappa_B5;
}

/*
 * (3.29a) chasles_plucker_transfer in single precision.
 *   verdict: holds; assumes nothing
 *   15 operations; derivation sha256 6d53a1bee79a6a2a63aafa29de9b2815a5d19f7d96ef743e8fd201bd98bf5faf
 */
void chasles_plucker_transferf(
    const float kappa_A[6],
    const float a[3],
    const float b[3],
    float kappa_B[6])
{
    const float kappa_B0 = kappa_A[0];
    const float kappa_B1 = kappa_A[1];
    const float kappa_B2 = kappa_A[2];
    const float t1 = a[0] - b[0];
    const float t2 = a[1] - b[1];
    const float t3 = a[2] - b[2];
    const float kappa_B3 = kappa_A[3] + (kappa_B2 * t2 - kappa_B1 * t3);
    const float kappa_B4 = kappa_A[4] + (kappa_B0 * t3 - kappa_B2 * t1);
    const float kappa_B5 = kappa_A[5] + (kappa_B1 * t1 - kappa_B0 * t2);
    kappa_B[0] = kappa_B0;
    kappa_B[1] = kappa_B1;
    kappa_B[2] = kappa_B2;
    kappa_B[3] = kappa_B3;
    kappa_B[4] = kappa_B4;
    kappa_B[5] = kappa_B5;
}

/*
 * (3.29a) chasles_plucker_transfer for a batch.
 *   verdict: holds; assumes nothing
 *   15 operations; derivation sha256 6d53a1bee79a6a2a63aafa29de9b2815a5d19f7d96ef743e8fd201bd98bf5faf
 */
void chasles_plucker_transfer_batch(
    size_t count,
    const double *kappa_A, ptrdiff_t kappa_A_step,
    const double *a, ptrdiff_t a_step,
    const double *b, ptrdiff_t b_step,
    double *kappa_B, ptrdiff_t kappa_B_step)
{
    char *const at[] = {(char *)kappa_A, (char *)a, (char *)b, (char *)kappa_B};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {kappa_A_step * size, a_step * size, b_step * size, kappa_B_step * size};
    const chasles_loop *loop = &chasles_plucker_transfer_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.29a) chasles_plucker_transferf for a batch.
 *   verdict: holds; assumes nothing
 *   15 operations; derivation sha256 6d53a1bee79a6a2a63aafa29de9b2815a5d19f7d96ef743e8fd201bd98bf5faf
 */
void chasles_plucker_transfer_batchf(
    size_t count,
    const float *kappa_A, ptrdiff_t kappa_A_step,
    const float *a, ptrdiff_t a_step,
    const float *b, ptrdiff_t b_step,
    float *kappa_B, ptrdiff_t kappa_B_step)
{
    char *const at[] = {(char *)kappa_A, (char *)a, (char *)b, (char *)kappa_B};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {kappa_A_step * size, a_step * size, b_step * size, kappa_B_step * size};
    const chasles_loop *loop = &chasles_plucker_transfer_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

#endif
