/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The kernels of section_3_2. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"
#include "loops.h"

static const chasles_shape chasles_cross_product_matrix_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_cross_product_matrix_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    1, 2, chasles_cross_product_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_cross_product_matrix_block),
};

static const chasles_shape chasles_cross_product_matrix_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_cross_product_matrix_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    1, 2, chasles_cross_product_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_cross_product_matrix_blockf),
};

static const chasles_shape chasles_rotation_from_axis_angle_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 3},
};
const chasles_loop chasles_rotation_from_axis_angle_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_rotation_from_axis_angle_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_axis_angle_block),
};

static const chasles_shape chasles_rotation_from_axis_angle_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 3},
};
const chasles_loop chasles_rotation_from_axis_angle_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_rotation_from_axis_angle_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_axis_angle_blockf),
};

static const chasles_shape chasles_point_after_displacement_loop_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_point_after_displacement_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_point_after_displacement_loop_shapes,
    CHASLES_BLOCKS(chasles_point_after_displacement_block),
};

static const chasles_shape chasles_point_after_displacement_loopf_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_point_after_displacement_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_point_after_displacement_loopf_shapes,
    CHASLES_BLOCKS(chasles_point_after_displacement_blockf),
};

static const chasles_shape chasles_pitch_of_motion_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {0, 1, 1},
};
const chasles_loop chasles_pitch_of_motion_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_pitch_of_motion_loop_shapes,
    CHASLES_BLOCKS(chasles_pitch_of_motion_block),
};

static const chasles_shape chasles_pitch_of_motion_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 3},
    {0, 1, 1},
};
const chasles_loop chasles_pitch_of_motion_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_pitch_of_motion_loopf_shapes,
    CHASLES_BLOCKS(chasles_pitch_of_motion_blockf),
};

#if !(CHASLES_VECTORS && defined(CHASLES_BLOCKS_ALONE))

/*
 * (2.38) The cross-product matrix of v: multiplying by it is taking the vector product with v.
 *   given       v[3]: any vector
 *   returns     V[9]: cross-product matrix of a vector
 *   verdict     defined
 *   assumes     nothing
 *   operations  0
 *   error bound exact, for all inputs
 *   derivation  sha256 1dcc0e58f219711b3c3f86b749f8c10b4db63734a02b20de3d9c405c9765483d
 */
void chasles_cross_product_matrix(const double v[3], double V[9])
{
    const double V7 = v[0];
    const double V2 = v[1];
    const double V3 = v[2];
    const double V1 = -V3;
    const double V5 = -V7;
    const double V6 = -V2;
    V[0] = 0.0;
    V[1] = V1;
    V[2] = V2;
    V[3] = V3;
    V[4] = 0.0;
    V[5] = V5;
    V[6] = V6;
    V[7] = V7;
    V[8] = 0.0;
}

/*
 * (2.38) chasles_cross_product_matrix in single precision.
 *   verdict: defined; assumes nothing
 *   0 operations; derivation sha256 1dcc0e58f219711b3c3f86b749f8c10b4db63734a02b20de3d9c405c9765483d
 */
void chasles_cross_product_matrixf(const float v[3], float V[9])
{
    const float V7 = v[0];
    const float V2 = v[1];
    const float V3 = v[2];
    const float V1 = -V3;
    const float V5 = -V7;
    const float V6 = -V2;
    V[0] = 0.0f;
    V[1] = V1;
    V[2] = V2;
    V[3] = V3;
    V[4] = 0.0f;
    V[5] = V5;
    V[6] = V6;
    V[7] = V7;
    V[8] = 0.0f;
}

/*
 * (2.38) chasles_cross_product_matrix for a batch.
 *   verdict: defined; assumes nothing
 *   0 operations; derivation sha256 1dcc0e58f219711b3c3f86b749f8c10b4db63734a02b20de3d9c405c9765483d
 */
void chasles_cross_product_matrix_batch(
    size_t count,
    const double *v, ptrdiff_t v_step,
    double *V, ptrdiff_t V_step)
{
    char *const at[] = {(char *)v, (char *)V};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {v_step * size, V_step * size};
    const chasles_loop *loop = &chasles_cross_product_matrix_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (2.38) chasles_cross_product_matrixf for a batch.
 *   verdict: defined; assumes nothing
 *   0 operations; derivation sha256 1dcc0e58f219711b3c3f86b749f8c10b4db63734a02b20de3d9c405c9765483d
 */
void chasles_cross_product_matrix_batchf(
    size_t count,
    const float *v, ptrdiff_t v_step,
    float *V, ptrdiff_t V_step)
{
    char *const at[] = {(char *)v, (char *)V};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {v_step * size, V_step * size};
    const chasles_loop *loop = &chasles_cross_product_matrix_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (2.49) The rotation about the axis e through the angle phi.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     |e| = 1
 *   operations  24: 6 add, 4 subtract, 12 multiply, 1 sine, 1 cosine
 *   error bound 6.1 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 dd485fc9fc55c9da723bbd623b2225ec82c9e8dbfe322dbf4dfe768c7d30e93a
 */
void chasles_rotation_from_axis_angle(const double e[3], double phi, double Q[9])
{
    const double cos_phi = cos(phi);
    const double t1 = 1.0 - cos_phi;
    const double sin_phi = sin(phi);
    const double t2 = e[0] * t1;
    const double t3 = e[1] * t1;
    const double t4 = e[1] * t2;
    const double t5 = e[2] * t2;
    const double t6 = e[2] * t3;
    const double Q0 = cos_phi + e[0] * t2;
    const double Q4 = cos_phi + e[1] * t3;
    const double Q8 = cos_phi + e[2] * (e[2] * t1);
    const double t7 = e[0] * sin_phi;
    const double t8 = e[1] * sin_phi;
    const double t9 = e[2] * sin_phi;
    const double Q1 = t4 - t9;
    const double Q2 = t5 + t8;
    const double Q3 = t4 + t9;
    const double Q5 = t6 - t7;
    const double Q6 = t5 - t8;
    const double Q7 = t6 + t7;
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
 * (2.49) chasles_rotation_from_axis_angle in single precision.
 *   verdict: defined; assumes |e| = 1
 *   24 operations; derivation sha256 dd485fc9fc55c9da723bbd623b2225ec82c9e8dbfe322dbf4dfe768c7d30e93a
 */
void chasles_rotation_from_axis_anglef(const float e[3], float phi, float Q[9])
{
    const float cos_phi = cosf(phi);
    const float t1 = 1.0f - cos_phi;
    const float sin_phi = sinf(phi);
    const float t2 = e[0] * t1;
    const float t3 = e[1] * t1;
    const float t4 = e[1] * t2;
    const float t5 = e[2] * t2;
    const float t6 = e[2] * t3;
    const float Q0 = cos_phi + e[0] * t2;
    const float Q4 = cos_phi + e[1] * t3;
    const float Q8 = cos_phi + e[2] * (e[2] * t1);
    const float t7 = e[0] * sin_phi;
    const float t8 = e[1] * sin_phi;
    const float t9 = e[2] * sin_phi;
    const float Q1 = t4 - t9;
    const float Q2 = t5 + t8;
    const float Q3 = t4 + t9;
    const float Q5 = t6 - t7;
    const float Q6 = t5 - t8;
    const float Q7 = t6 + t7;
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
 * (2.49) chasles_rotation_from_axis_angle for a batch.
 *   verdict: defined; assumes |e| = 1
 *   24 operations; derivation sha256 dd485fc9fc55c9da723bbd623b2225ec82c9e8dbfe322dbf4dfe768c7d30e93a
 */
void chasles_rotation_from_axis_angle_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_axis_angle_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (2.49) chasles_rotation_from_axis_anglef for a batch.
 *   verdict: defined; assumes |e| = 1
 *   24 operations; derivation sha256 dd485fc9fc55c9da723bbd623b2225ec82c9e8dbfe322dbf4dfe768c7d30e93a
 */
void chasles_rotation_from_axis_angle_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_axis_angle_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.2) Where a point of the body lies after the displacement.
 *   given       Q[9]: rotation
 *               a[3]: position of the landmark point A
 *               a_prime[3]: position of A after the displacement
 *               p[3]: position of any point P
 *   returns     p_prime[3]: position of P after the displacement
 *   verdict     holds
 *   assumes     nothing
 *   expects     Q is a rotation
 *   operations  21: 9 add, 3 subtract, 9 multiply
 *   error bound 5.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 af99d11eca408718e24cab7a00a1fd908df2c4445259caf108fa6366c29b6560
 */
void chasles_point_after_displacement(
    const double Q[9],
    const double a[3],
    const double a_prime[3],
    const double p[3],
    double p_prime[3])
{
    const double t1 = p[0] - a[0];
    const double t2 = p[1] - a[1];
    const double t3 = p[2] - a[2];
    const double p_prime0 = a_prime[0] + (Q[0] * t1 + Q[1] * t2 + Q[2] * t3);
    const double p_prime1 = a_prime[1] + (Q[3] * t1 + Q[4] * t2 + Q[5] * t3);
    const double p_prime2 = a_prime[2] + (Q[6] * t1 + Q[7] * t2 + Q[8] * t3);
    p_prime[0] = p_prime0;
    p_prime[1] = p_prime1;
    p_prime[2] = p_prime2;
}

/*
 * (3.2) chasles_point_after_displacement in single precision.
 *   verdict: holds; assumes nothing
 *   21 operations; derivation sha256 af99d11eca408718e24cab7a00a1fd908df2c4445259caf108fa6366c29b6560
 */
void chasles_point_after_displacementf(
    const float Q[9],
    const float a[3],
    const float a_prime[3],
    const float p[3],
    float p_prime[3])
{
    const float t1 = p[0] - a[0];
    const float t2 = p[1] - a[1];
    const float t3 = p[2] - a[2];
    const float p_prime0 = a_prime[0] + (Q[0] * t1 + Q[1] * t2 + Q[2] * t3);
    const float p_prime1 = a_prime[1] + (Q[3] * t1 + Q[4] * t2 + Q[5] * t3);
    const float p_prime2 = a_prime[2] + (Q[6] * t1 + Q[7] * t2 + Q[8] * t3);
    p_prime[0] = p_prime0;
    p_prime[1] = p_prime1;
    p_prime[2] = p_prime2;
}

/*
 * (3.2) chasles_point_after_displacement for a batch.
 *   verdict: holds; assumes nothing
 *   21 operations; derivation sha256 af99d11eca408718e24cab7a00a1fd908df2c4445259caf108fa6366c29b6560
 */
void chasles_point_after_displacement_batch(
    size_t count,
    const double *Q, ptrdiff_t Q_step,
    const double *a, ptrdiff_t a_step,
    const double *a_prime, ptrdiff_t a_prime_step,
    const double *p, ptrdiff_t p_step,
    double *p_prime, ptrdiff_t p_prime_step)
{
    char *const at[] = {(char *)Q, (char *)a, (char *)a_prime, (char *)p, (char *)p_prime};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        Q_step * size,
        a_step * size,
        a_prime_step * size,
        p_step * size,
        p_prime_step * size};
    const chasles_loop *loop = &chasles_point_after_displacement_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.2) chasles_point_after_displacementf for a batch.
 *   verdict: holds; assumes nothing
 *   21 operations; derivation sha256 af99d11eca408718e24cab7a00a1fd908df2c4445259caf108fa6366c29b6560
 */
void chasles_point_after_displacement_batchf(
    size_t count,
    const float *Q, ptrdiff_t Q_step,
    const float *a, ptrdiff_t a_step,
    const float *a_prime, ptrdiff_t a_prime_step,
    const float *p, ptrdiff_t p_step,
    float *p_prime, ptrdiff_t p_prime_step)
{
    char *const at[] = {(char *)Q, (char *)a, (char *)a_prime, (char *)p, (char *)p_prime};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        Q_step * size,
        a_step * size,
        a_prime_step * size,
        p_step * size,
        p_prime_step * size};
    const chasles_loop *loop = &chasles_point_after_displacement_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.7) The pitch from the displacement of any point.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               d_P[3]: displacement of P
 *   returns     result: d0 / phi
 *   verdict     holds under
 *   assumes     phi != 0
 *               |e| = 1
 *   operations  6: 2 add, 3 multiply, 1 divide
 *   error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 a00b650de0c575f7c9b2294f993cd4d248ffaaa64b28a7f2d4581cd5c90cdf7f
 */
void chasles_pitch_of_motion(const double e[3], double phi, const double d_P[3], double *result)
{
    const double result_value = (phi == 0.0 ? 0.0 : e[0] * d_P[0] + e[1] * d_P[1] + e[2] * d_P[2]) / phi;
    *result = result_value;
}

/*
 * (3.7) chasles_pitch_of_motion in single precision.
 *   verdict: holds under; assumes phi != 0, |e| = 1
 *   6 operations; derivation sha256 a00b650de0c575f7c9b2294f993cd4d248ffaaa64b28a7f2d4581cd5c90cdf7f
 */
void chasles_pitch_of_motionf(const float e[3], float phi, const float d_P[3], float *result)
{
    const float t1 = phi == 0.0f ? 0.0f : e[0] * d_P[0] + e[1] * d_P[1] + e[2] * d_P[2];
    const float result_value = t1 / phi;
    *result = result_value;
}

/*
 * (3.7) chasles_pitch_of_motion for a batch.
 *   verdict: holds under; assumes phi != 0, |e| = 1
 *   6 operations; derivation sha256 a00b650de0c575f7c9b2294f993cd4d248ffaaa64b28a7f2d4581cd5c90cdf7f
 */
void chasles_pitch_of_motion_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *d_P, ptrdiff_t d_P_step,
    double *result, ptrdiff_t result_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)d_P, (char *)result};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, d_P_step * size, result_step * size};
    const chasles_loop *loop = &chasles_pitch_of_motion_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.7) chasles_pitch_of_motionf for a batch.
 *   verdict: holds under; assumes phi != 0, |e| = 1
 *   6 operations; derivation sha256 a00b650de0c575f7c9b2294f993cd4d248ffaaa64b28a7f2d4581cd5c90cdf7f
 */
void chasles_pitch_of_motion_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *d_P, ptrdiff_t d_P_step,
    float *result, ptrdiff_t result_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)d_P, (char *)result};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, d_P_step * size, result_step * size};
    const chasles_loop *loop = &chasles_pitch_of_motion_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

#endif
