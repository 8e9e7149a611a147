/* The kernels of section_3_2_1. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "batches.h"
#include "chasles.h"

static const chasles_shape chasles_normal_matrix_inverse_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 3},
};
const chasles_loop chasles_normal_matrix_inverse_loop = {
    sizeof(double), 0, 2, 3,
    chasles_normal_matrix_inverse_loop_shapes,
    CHASLES_BLOCKS(chasles_normal_matrix_inverse_block),
};

static const chasles_shape chasles_normal_matrix_inverse_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 3},
};
const chasles_loop chasles_normal_matrix_inverse_loopf = {
    sizeof(float), 0, 2, 3,
    chasles_normal_matrix_inverse_loopf_shapes,
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
    sizeof(double), 0, 4, 5,
    chasles_screw_axis_point_loop_shapes,
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
    sizeof(float), 0, 4, 5,
    chasles_screw_axis_point_loopf_shapes,
    CHASLES_BLOCKS(chasles_screw_axis_point_blockf),
};

/*
 * (3.16) The inverse of the matrix of the normal equations.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *   returns     result[9]: (A^T A)^-1
 *   verdict     holds under
 *   assumes     phi != 0
 *               |e| = 1
 *   operations  19: 3 add, 2 subtract, 11 multiply, 2 divide, 1 cosine
 *   derivation  sha256 5ac2e58cb954695fb22629ed1368ffe7e286efef15ae1ae9e6c4f136f03b4fc3
 */
void chasles_normal_matrix_inverse(const double e[3], double phi, double result[9])
{
    const double cos_phi = cos(phi);
    const double t1 = 2.0 * (1.0 - cos_phi);
    const int t2 = t1 == 0.0;
    const double t3 = (t2 ? 0.0 : 1.0) / t1;
    const double t4 = (t2 ? 0.0 : 1.0 - 2.0 * cos_phi) / t1;
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
 *   19 operations; derivation sha256 5ac2e58cb954695fb22629ed1368ffe7e286efef15ae1ae9e6c4f136f03b4fc3
 */
void chasles_normal_matrix_inversef(const float e[3], float phi, float result[9])
{
    const float cos_phi = cosf(phi);
    const float t1 = 2.0f * (1.0f - cos_phi);
    const int t2 = t1 == 0.0f;
    const float t3 = (t2 ? 0.0f : 1.0f) / t1;
    const float t4 = (t2 ? 0.0f : 1.0f - 2.0f * cos_phi) / t1;
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
 *   19 operations; derivation sha256 5ac2e58cb954695fb22629ed1368ffe7e286efef15ae1ae9e6c4f136f03b4fc3
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
 *   19 operations; derivation sha256 5ac2e58cb954695fb22629ed1368ffe7e286efef15ae1ae9e6c4f136f03b4fc3
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
 *   operations  64: 18 add, 10 subtract, 31 multiply, 3 divide, 1 sine, 1 cosine
 *   derivation  sha256 8ec72961c7242876eb3f39769aa85197309a72737bed03662c26f5d342deb5dd
 */
void chasles_screw_axis_point(
    const double e[3],
    double phi,
    const double a[3],
    const double a_prime[3],
    double p_0[3])
{
    const double cos_phi = cos(phi);
    const double t1 = 1.0 - cos_phi;
    const double t2 = 2.0 * t1;
    const double sin_phi = sin(phi);
    const double t3 = e[0] * t1;
    const double t4 = e[1] * t1;
    const double t5 = e[1] * t3;
    const double t6 = e[2] * t3;
    const double t7 = e[2] * t4;
    const double t8 = cos_phi + e[0] * t3;
    const double t9 = cos_phi + e[1] * t4;
    const double t10 = cos_phi + e[2] * (e[2] * t1);
    const double t11 = e[0] * sin_phi;
    const double t12 = e[1] * sin_phi;
    const double t13 = e[2] * sin_phi;
    const double t14 = t5 - t13;
    const double t15 = t6 + t12;
    const double t16 = t5 + t13;
    const double t17 = t7 - t11;
    const double t18 = t6 - t12;
    const double t19 = t7 + t11;
    const double t20 = a[0] * t8 + a[1] * t14 + a[2] * t15 - a_prime[0];
    const double t21 = a[0] * t16 + a[1] * t9 + a[2] * t17 - a_prime[1];
    const double t22 = a[0] * t18 + a[1] * t19 + a[2] * t10 - a_prime[2];
    const int t23 = t2 == 0.0;
    const double p_0_0 = (t23 ? 0.0 : t8 * t20 + t16 * t21 + t18 * t22 - t20) / t2;
    const double p_0_1 = (t23 ? 0.0 : t14 * t20 + t9 * t21 + t19 * t22 - t21) / t2;
    const double p_0_2 = (t23 ? 0.0 : t15 * t20 + t17 * t21 + t10 * t22 - t22) / t2;
    p_0[0] = p_0_0;
    p_0[1] = p_0_1;
    p_0[2] = p_0_2;
}

/*
 * (3.18) chasles_screw_axis_point in single precision.
 *   verdict: holds under; assumes phi != 0, |e| = 1
 *   64 operations; derivation sha256 8ec72961c7242876eb3f39769aa85197309a72737bed03662c26f5d342deb5dd
 */
void chasles_screw_axis_pointf(
    const float e[3],
    float phi,
    const float a[3],
    const float a_prime[3],
    float p_0[3])
{
    const float cos_phi = cosf(phi);
    const float t1 = 1.0f - cos_phi;
    const float t2 = 2.0f * t1;
    const float sin_phi = sinf(phi);
    const float t3 = e[0] * t1;
    const float t4 = e[1] * t1;
    const float t5 = e[1] * t3;
    const float t6 = e[2] * t3;
    const float t7 = e[2] * t4;
    const float t8 = cos_phi + e[0] * t3;
    const float t9 = cos_phi + e[1] * t4;
    const float t10 = cos_phi + e[2] * (e[2] * t1);
    const float t11 = e[0] * sin_phi;
    const float t12 = e[1] * sin_phi;
    const float t13 = e[2] * sin_phi;
    const float t14 = t5 - t13;
    const float t15 = t6 + t12;
    const float t16 = t5 + t13;
    const float t17 = t7 - t11;
    const float t18 = t6 - t12;
    const float t19 = t7 + t11;
    const float t20 = a[0] * t8 + a[1] * t14 + a[2] * t15 - a_prime[0];
    const float t21 = a[0] * t16 + a[1] * t9 + a[2] * t17 - a_prime[1];
    const float t22 = a[0] * t18 + a[1] * t19 + a[2] * t10 - a_prime[2];
    const int t23 = t2 == 0.0f;
    const float p_0_0 = (t23 ? 0.0f : t8 * t20 + t16 * t21 + t18 * t22 - t20) / t2;
    const float p_0_1 = (t23 ? 0.0f : t14 * t20 + t9 * t21 + t19 * t22 - t21) / t2;
    const float p_0_2 = (t23 ? 0.0f : t15 * t20 + t17 * t21 + t10 * t22 - t22) / t2;
    p_0[0] = p_0_0;
    p_0[1] = p_0_1;
    p_0[2] = p_0_2;
}

/*
 * (3.18) chasles_screw_axis_point for a batch.
 *   verdict: holds under; assumes phi != 0, |e| = 1
 *   64 operations; derivation sha256 8ec72961c7242876eb3f39769aa85197309a72737bed03662c26f5d342deb5dd
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
 *   64 operations; derivation sha256 8ec72961c7242876eb3f39769aa85197309a72737bed03662c26f5d342deb5dd
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
