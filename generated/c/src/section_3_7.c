/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The kernels of section_3_7. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"
#include "loops.h"

static const chasles_shape chasles_wrench_axis_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
    {0, 1, 1},
};
const chasles_loop chasles_wrench_axis_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 5, chasles_wrench_axis_loop_shapes,
    CHASLES_BLOCKS(chasles_wrench_axis_block),
};

static const chasles_shape chasles_wrench_axis_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
    {0, 1, 1},
};
const chasles_loop chasles_wrench_axis_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 5, chasles_wrench_axis_loopf_shapes,
    CHASLES_BLOCKS(chasles_wrench_axis_blockf),
};

static const chasles_shape chasles_power_loop_shapes[] = {{1, 1, 6}, {1, 1, 6}, {0, 1, 1}};
const chasles_loop chasles_power_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_power_loop_shapes,
    CHASLES_BLOCKS(chasles_power_block),
};

static const chasles_shape chasles_power_loopf_shapes[] = {{1, 1, 6}, {1, 1, 6}, {0, 1, 1}};
const chasles_loop chasles_power_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_power_loopf_shapes,
    CHASLES_BLOCKS(chasles_power_blockf),
};

static const chasles_shape chasles_reciprocal_product_loop_shapes[] = {
    {1, 1, 6},
    {1, 1, 6},
    {0, 1, 1},
};
const chasles_loop chasles_reciprocal_product_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_reciprocal_product_loop_shapes,
    CHASLES_BLOCKS(chasles_reciprocal_product_block),
};

static const chasles_shape chasles_reciprocal_product_loopf_shapes[] = {
    {1, 1, 6},
    {1, 1, 6},
    {0, 1, 1},
};
const chasles_loop chasles_reciprocal_product_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_reciprocal_product_loopf_shapes,
    CHASLES_BLOCKS(chasles_reciprocal_product_blockf),
};

static const chasles_shape chasles_wrench_transfer_loop_shapes[] = {
    {1, 1, 6},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
};
const chasles_loop chasles_wrench_transfer_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_wrench_transfer_loop_shapes,
    CHASLES_BLOCKS(chasles_wrench_transfer_block),
};

static const chasles_shape chasles_wrench_transfer_loopf_shapes[] = {
    {1, 1, 6},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
};
const chasles_loop chasles_wrench_transfer_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_wrench_transfer_loopf_shapes,
    CHASLES_BLOCKS(chasles_wrench_transfer_blockf),
};

#if !(CHASLES_VECTORS && defined(CHASLES_BLOCKS_ALONE))

/*
 * text 3.7 d The axis and the pitch of the wrench.
 *   given       f[3]: resultant force
 *               n_A[3]: resultant moment about A
 *               a[3]: position of the landmark point A
 *   returns     axis[6]: [e''; n'']
 *               pitch: pitch of the wrench, in metres per radian
 *   verdict     holds under
 *   assumes     f != 0
 *   made of     an offered form, proved equal to the statement
 *   operations  45: 7 add, 6 subtract, 18 multiply, 13 divide, 1 square root
 *   error bound axis: 21.51 u of the sum of its terms' sizes, for all inputs
 *               pitch: 14.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 c78cfc23a3b398d6195b8dc68c79e9bdceefc46df0b8a9442885e124035211ef
 */
void chasles_wrench_axis(
    const double f[3],
    const double n_A[3],
    const double a[3],
    double axis[6],
    double *pitch)
{
    const double t1 = f[0] < 0.0 ? -f[0] : f[0];
    const double t2 = f[1] < 0.0 ? -f[1] : f[1];
    const double t3 = t1 < t2 ? t2 : t1;
    const double t4 = f[2] < 0.0 ? -f[2] : f[2];
    const double t5 = t3 < t4 ? t4 : t3;
    const double t6 = 0.0 == t5 ? 1.0 : t5;
    const double t7 = f[0] / t6;
    const double t8 = f[1] / t6;
    const double t9 = f[2] / t6;
    const double t10 = t7 * t7 + t8 * t8 + t9 * t9;
    const double t11 = sqrt(t10);
    const int t12 = t10 == 0.0;
    const double axis0 = (t12 ? 0.0 : t7) / t11;
    const double axis1 = (t12 ? 0.0 : t8) / t11;
    const double axis2 = (t12 ? 0.0 : t9) / t11;
    const double t13 = (t12 ? 0.0 : n_A[0]) / t11;
    const double t14 = (t12 ? 0.0 : n_A[1]) / t11;
    const double t15 = (t12 ? 0.0 : n_A[2]) / t11;
    const double t16 = a[0] + (axis1 * t15 - axis2 * t14) / t6;
    const double t17 = a[1] + (axis2 * t13 - axis0 * t15) / t6;
    const double t18 = a[2] + (axis0 * t14 - axis1 * t13) / t6;
    const double axis3 = axis2 * t17 - axis1 * t18;
    const double axis4 = axis0 * t18 - axis2 * t16;
    const double axis5 = axis1 * t16 - axis0 * t17;
    const double pitch_value = (axis0 * t13 + axis1 * t14 + axis2 * t15) / t6;
    axis[0] = axis0;
    axis[1] = axis1;
    axis[2] = axis2;
    axis[3] = axis3;
    axis[4] = axis4;
    axis[5] = axis5;
    *pitch = pitch_value;
}

/*
 * text 3.7 d chasles_wrench_axis in single precision.
 *   verdict: holds under; assumes f != 0
 *   45 operations; derivation sha256 c78cfc23a3b398d6195b8dc68c79e9bdceefc46df0b8a9442885e124035211ef
 */
void chasles_wrench_axisf(
    const float f[3],
    const float n_A[3],
    const float a[3],
    float axis[6],
    float *pitch)
{
    const float t1 = f[0] < 0.0f ? -f[0] : f[0];
    const float t2 = f[1] < 0.0f ? -f[1] : f[1];
    const float t3 = t1 < t2 ? t2 : t1;
    const float t4 = f[2] < 0.0f ? -f[2] : f[2];
    const float t5 = t3 < t4 ? t4 : t3;
    const float t6 = 0.0f == t5 ? 1.0f : t5;
    const float t7 = f[0] / t6;
    const float t8 = f[1] / t6;
    const float t9 = f[2] / t6;
    const float t10 = t7 * t7 + t8 * t8 + t9 * t9;
    const float t11 = sqrtf(t10);
    const int t12 = t10 == 0.0f;
    const float axis0 = (t12 ? 0.0f : t7) / t11;
    const float axis1 = (t12 ? 0.0f : t8) / t11;
    const float axis2 = (t12 ? 0.0f : t9) / t11;
    const float t13 = (t12 ? 0.0f : n_A[0]) / t11;
    const float t14 = (t12 ? 0.0f : n_A[1]) / t11;
    const float t15 = (t12 ? 0.0f : n_A[2]) / t11;
    const float t16 = a[0] + (axis1 * t15 - axis2 * t14) / t6;
    const float t17 = a[1] + (axis2 * t13 - axis0 * t15) / t6;
    const float t18 = a[2] + (axis0 * t14 - axis1 * t13) / t6;
    const float axis3 = axis2 * t17 - axis1 * t18;
    const float axis4 = axis0 * t18 - axis2 * t16;
    const float axis5 = axis1 * t16 - axis0 * t17;
    const float pitch_value = (axis0 * t13 + axis1 * t14 + axis2 * t15) / t6;
    axis[0] = axis0;
    axis[1] = axis1;
    axis[2] = axis2;
    axis[3] = axis3;
    axis[4] = axis4;
    axis[5] = axis5;
    *pitch = pitch_value;
}

/*
 * text 3.7 d chasles_wrench_axis for a batch.
 *   verdict: holds under; assumes f != 0
 *   45 operations; derivation sha256 c78cfc23a3b398d6195b8dc68c79e9bdceefc46df0b8a9442885e124035211ef
 */
void chasles_wrench_axis_batch(
    size_t count,
    const double *f, ptrdiff_t f_step,
    const double *n_A, ptrdiff_t n_A_step,
    const double *a, ptrdiff_t a_step,
    double *axis, ptrdiff_t axis_step,
    double *pitch, ptrdiff_t pitch_step)
{
    char *const at[] = {(char *)f, (char *)n_A, (char *)a, (char *)axis, (char *)pitch};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        f_step * size,
        n_A_step * size,
        a_step * size,
        axis_step * size,
        pitch_step * size};
    const chasles_loop *loop = &chasles_wrench_axis_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.7 d chasles_wrench_axisf for a batch.
 *   verdict: holds under; assumes f != 0
 *   45 operations; derivation sha256 c78cfc23a3b398d6195b8dc68c79e9bdceefc46df0b8a9442885e124035211ef
 */
void chasles_wrench_axis_batchf(
    size_t count,
    const float *f, ptrdiff_t f_step,
    const float *n_A, ptrdiff_t n_A_step,
    const float *a, ptrdiff_t a_step,
    float *axis, ptrdiff_t axis_step,
    float *pitch, ptrdiff_t pitch_step)
{
    char *const at[] = {(char *)f, (char *)n_A, (char *)a, (char *)axis, (char *)pitch};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        f_step * size,
        n_A_step * size,
        a_step * size,
        axis_step * size,
        pitch_step * size};
    const chasles_loop *loop = &chasles_wrench_axis_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.114) The power developed by a wrench on a body that moves with a twist at the same point.
 *   given       t[6]: twist: angular velocity, velocity of a landmark point
 *               w[6]: wrench: moment, force
 *   returns     Pi: power developed by a wrench on a moving body
 *   verdict     holds
 *   assumes     nothing
 *   operations  11: 5 add, 6 multiply
 *   error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 580a9557b1b4b779955409e7506c76202ce3a1e9982d422e1491bf0bcad680ef
 */
void chasles_power(const double t[6], const double w[6], double *Pi)
{
    const double t1 = t[0] * w[0] + t[1] * w[1] + t[2] * w[2] + t[3] * w[3] + t[4] * w[4];
    const double Pi_value = t1 + t[5] * w[5];
    *Pi = Pi_value;
}

/*
 * (3.114) chasles_power in single precision.
 *   verdict: holds; assumes nothing
 *   11 operations; derivation sha256 580a9557b1b4b779955409e7506c76202ce3a1e9982d422e1491bf0bcad680ef
 */
void chasles_powerf(const float t[6], const float w[6], float *Pi)
{
    const float t1 = t[0] * w[0] + t[1] * w[1] + t[2] * w[2] + t[3] * w[3] + t[4] * w[4];
    const float Pi_value = t1 + t[5] * w[5];
    *Pi = Pi_value;
}

/*
 * (3.114) chasles_power for a batch.
 *   verdict: holds; assumes nothing
 *   11 operations; derivation sha256 580a9557b1b4b779955409e7506c76202ce3a1e9982d422e1491bf0bcad680ef
 */
void chasles_power_batch(
    size_t count,
    const double *t, ptrdiff_t t_step,
    const double *w, ptrdiff_t w_step,
    double *Pi, ptrdiff_t Pi_step)
{
    char *const at[] = {(char *)t, (char *)w, (char *)Pi};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {t_step * size, w_step * size, Pi_step * size};
    const chasles_loop *loop = &chasles_power_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.114) chasles_powerf for a batch.
 *   verdict: holds; assumes nothing
 *   11 operations; derivation sha256 580a9557b1b4b779955409e7506c76202ce3a1e9982d422e1491bf0bcad680ef
 */
void chasles_power_batchf(
    size_t count,
    const float *t, ptrdiff_t t_step,
    const float *w, ptrdiff_t w_step,
    float *Pi, ptrdiff_t Pi_step)
{
    char *const at[] = {(char *)t, (char *)w, (char *)Pi};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {t_step * size, w_step * size, Pi_step * size};
    const chasles_loop *loop = &chasles_power_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.7 k The reciprocal product of two screws, in either order.
 *   given       s_w[6]: screw of a wrench
 *               s_t[6]: screw of a twist
 *   returns     product: s_t^T Gamma s_w
 *   verdict     holds
 *   assumes     nothing
 *   operations  11: 5 add, 6 multiply
 *   error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 69eafb582289fe007146884f233005913bd49126222273503197968fd6ef8dd3
 */
void chasles_reciprocal_product(const double s_w[6], const double s_t[6], double *product)
{
    const double t1 = s_w[0] * s_t[3] + s_w[1] * s_t[4] + s_w[2] * s_t[5] + s_w[3] * s_t[0];
    const double product_value = t1 + s_w[4] * s_t[1] + s_w[5] * s_t[2];
    *product = product_value;
}

/*
 * text 3.7 k chasles_reciprocal_product in single precision.
 *   verdict: holds; assumes nothing
 *   11 operations; derivation sha256 69eafb582289fe007146884f233005913bd49126222273503197968fd6ef8dd3
 */
void chasles_reciprocal_productf(const float s_w[6], const float s_t[6], float *product)
{
    const float t1 = s_w[0] * s_t[3] + s_w[1] * s_t[4] + s_w[2] * s_t[5] + s_w[3] * s_t[0];
    const float product_value = t1 + s_w[4] * s_t[1] + s_w[5] * s_t[2];
    *product = product_value;
}

/*
 * text 3.7 k chasles_reciprocal_product for a batch.
 *   verdict: holds; assumes nothing
 *   11 operations; derivation sha256 69eafb582289fe007146884f233005913bd49126222273503197968fd6ef8dd3
 */
void chasles_reciprocal_product_batch(
    size_t count,
    const double *s_w, ptrdiff_t s_w_step,
    const double *s_t, ptrdiff_t s_t_step,
    double *product, ptrdiff_t product_step)
{
    char *const at[] = {(char *)s_w, (char *)s_t, (char *)product};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {s_w_step * size, s_t_step * size, product_step * size};
    const chasles_loop *loop = &chasles_reciprocal_product_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.7 k chasles_reciprocal_productf for a batch.
 *   verdict: holds; assumes nothing
 *   11 operations; derivation sha256 69eafb582289fe007146884f233005913bd49126222273503197968fd6ef8dd3
 */
void chasles_reciprocal_product_batchf(
    size_t count,
    const float *s_w, ptrdiff_t s_w_step,
    const float *s_t, ptrdiff_t s_t_step,
    float *product, ptrdiff_t product_step)
{
    char *const at[] = {(char *)s_w, (char *)s_t, (char *)product};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {s_w_step * size, s_t_step * size, product_step * size};
    const chasles_loop *loop = &chasles_reciprocal_product_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.119a) The wrench-transfer formula.
 *   given       w_A[6]: wrench at A
 *               a[3]: position of the landmark point A
 *               p[3]: position of any point P
 *   returns     w_P[6]: wrench at P
 *   verdict     holds
 *   assumes     nothing
 *   operations  15: 3 add, 6 subtract, 6 multiply
 *   error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 9cbbd4d64a694c0150c2c0a241ceaa9fe43fa91e335dce95c4c39681e8ecce3c
 */
void chasles_wrench_transfer(
    const double w_A[6],
    const double a[3],
    const double p[3],
    double w_P[6])
{
    const double w_P3 = w_A[3];
    const double w_P4 = w_A[4];
    const double w_P5 = w_A[5];
    const double t1 = a[0] - p[0];
    const double t2 = a[1] - p[1];
    const double t3 = a[2] - p[2];
    const double w_P0 = w_A[0] + (w_P5 * t2 - w_P4 * t3);
    const double w_P1 = w_A[1] + (w_P3 * t3 - w_P5 * t1);
    const double w_P2 = w_A[2] + (w_P4 * t1 - w_P3 * t2);
    w_P[0] = w_P0;
    w_P[1] = w_P1;
    w_P[2] = w_P2;
    w_P[3] = w_P3;
    w_P[4] = w_P4;
    w_P[5] = w_P5;
}

/*
 * (3.119a) chasles_wrench_transfer in single precision.
 *   verdict: holds; assumes nothing
 *   15 operations; derivation sha256 9cbbd4d64a694c0150c2c0a241ceaa9fe43fa91e335dce95c4c39681e8ecce3c
 */
void chasles_wrench_transferf(const float w_A[6], const float a[3], const float p[3], float w_P[6])
{
    const float w_P3 = w_A[3];
    const float w_P4 = w_A[4];
    const float w_P5 = w_A[5];
    const float t1 = a[0] - p[0];
    const float t2 = a[1] - p[1];
    const float t3 = a[2] - p[2];
    const float w_P0 = w_A[0] + (w_P5 * t2 - w_P4 * t3);
    const float w_P1 = w_A[1] + (w_P3 * t3 - w_P5 * t1);
    const float w_P2 = w_A[2] + (w_P4 * t1 - w_P3 * t2);
    w_P[0] = w_P0;
    w_P[1] = w_P1;
    w_P[2] = w_P2;
    w_P[3] = w_P3;
    w_P[4] = w_P4;
    w_P[5] = w_P5;
}

/*
 * (3.119a) chasles_wrench_transfer for a batch.
 *   verdict: holds; assumes nothing
 *   15 operations; derivation sha256 9cbbd4d64a694c0150c2c0a241ceaa9fe43fa91e335dce95c4c39681e8ecce3c
 */
void chasles_wrench_transfer_batch(
    size_t count,
    const double *w_A, ptrdiff_t w_A_step,
    const double *a, ptrdiff_t a_step,
    const double *p, ptrdiff_t p_step,
    double *w_P, ptrdiff_t w_P_step)
{
    char *const at[] = {(char *)w_A, (char *)a, (char *)p, (char *)w_P};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {w_A_step * size, a_step * size, p_step * size, w_P_step * size};
    const chasles_loop *loop = &chasles_wrench_transfer_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.119a) chasles_wrench_transferf for a batch.
 *   verdict: holds; assumes nothing
 *   15 operations; derivation sha256 9cbbd4d64a694c0150c2c0a241ceaa9fe43fa91e335dce95c4c39681e8ecce3c
 */
void chasles_wrench_transfer_batchf(
    size_t count,
    const float *w_A, ptrdiff_t w_A_step,
    const float *a, ptrdiff_t a_step,
    const float *p, ptrdiff_t p_step,
    float *w_P, ptrdiff_t w_P_step)
{
    char *const at[] = {(char *)w_A, (char *)a, (char *)p, (char *)w_P};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {w_A_step * size, a_step * size, p_step * size, w_P_step * size};
    const chasles_loop *loop = &chasles_wrench_transfer_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

#endif
