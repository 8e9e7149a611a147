/* The kernels of section_3_9. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"

/*
 * Ex 3.10 The rotation by Euler angles about x, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 43389048581969403bd2d6881878959cb85868b92c6fcb159fa1904f458463b3
 */
void chasles_rotation_from_euler_xyx(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double Q0 = cos(angles[1]);
    const double t3 = sin(angles[1]);
    const double Q3 = t2 * t3;
    const double t4 = t2 * Q0;
    const double Q6 = -(t1 * t3);
    const double t5 = t1 * Q0;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q1 = t3 * t7;
    const double Q2 = t3 * t6;
    const double Q4 = t1 * t6 - t4 * t7;
    const double Q5 = -(t1 * t7 + t4 * t6);
    const double Q7 = t2 * t6 + t5 * t7;
    const double Q8 = t5 * t6 - t2 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_xyx in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 43389048581969403bd2d6881878959cb85868b92c6fcb159fa1904f458463b3
 */
void chasles_rotation_from_euler_xyxf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float Q0 = cosf(angles[1]);
    const float t3 = sinf(angles[1]);
    const float Q3 = t2 * t3;
    const float t4 = t2 * Q0;
    const float Q6 = -(t1 * t3);
    const float t5 = t1 * Q0;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q1 = t3 * t7;
    const float Q2 = t3 * t6;
    const float Q4 = t1 * t6 - t4 * t7;
    const float Q5 = -(t1 * t7 + t4 * t6);
    const float Q7 = t2 * t6 + t5 * t7;
    const float Q8 = t5 * t6 - t2 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_xyx for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 43389048581969403bd2d6881878959cb85868b92c6fcb159fa1904f458463b3
 */
void chasles_rotation_from_euler_xyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_xyx(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 chasles_rotation_from_euler_xyxf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 43389048581969403bd2d6881878959cb85868b92c6fcb159fa1904f458463b3
 */
void chasles_rotation_from_euler_xyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_xyxf(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 08ee56a4cd7efde3734db4d7abe798d5c7f0ce23d4b1520ed9cabad29aebcf61
 */
void chasles_euler_rate_matrix_xyx(const double angles[3], double W[9])
{
    const double W4 = cos(angles[0]);
    const double W7 = sin(angles[0]);
    const double W2 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W5 = W7 * t1;
    const double W8 = -(W4 * t1);
    W[0] = 1.0;
    W[1] = 0.0;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xyx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 08ee56a4cd7efde3734db4d7abe798d5c7f0ce23d4b1520ed9cabad29aebcf61
 */
void chasles_euler_rate_matrix_xyxf(const float angles[3], float W[9])
{
    const float W4 = cosf(angles[0]);
    const float W7 = sinf(angles[0]);
    const float W2 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W5 = W7 * t1;
    const float W8 = -(W4 * t1);
    W[0] = 1.0f;
    W[1] = 0.0f;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xyx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 08ee56a4cd7efde3734db4d7abe798d5c7f0ce23d4b1520ed9cabad29aebcf61
 */
void chasles_euler_rate_matrix_xyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_xyx(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xyxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 08ee56a4cd7efde3734db4d7abe798d5c7f0ce23d4b1520ed9cabad29aebcf61
 */
void chasles_euler_rate_matrix_xyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_xyxf(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 2351fd947a763557e546abca735235b8fd406c27b8f8367b9656771c149abe54
 */
void chasles_euler_rate_matrix_body_xyx(const double angles[3], double W_body[9])
{
    const double W_body0 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W_body4 = cos(angles[2]);
    const double t2 = sin(angles[2]);
    const double W_body3 = t1 * t2;
    const double W_body7 = -t2;
    const double W_body6 = t1 * W_body4;
    W_body[0] = W_body0;
    W_body[1] = 0.0;
    W_body[2] = 1.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xyx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2351fd947a763557e546abca735235b8fd406c27b8f8367b9656771c149abe54
 */
void chasles_euler_rate_matrix_body_xyxf(const float angles[3], float W_body[9])
{
    const float W_body0 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W_body4 = cosf(angles[2]);
    const float t2 = sinf(angles[2]);
    const float W_body3 = t1 * t2;
    const float W_body7 = -t2;
    const float W_body6 = t1 * W_body4;
    W_body[0] = W_body0;
    W_body[1] = 0.0f;
    W_body[2] = 1.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xyx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2351fd947a763557e546abca735235b8fd406c27b8f8367b9656771c149abe54
 */
void chasles_euler_rate_matrix_body_xyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_xyx(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xyxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2351fd947a763557e546abca735235b8fd406c27b8f8367b9656771c149abe54
 */
void chasles_euler_rate_matrix_body_xyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_xyxf(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 The rates of Euler angles about x, y, x from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 6680ed5e0065e86be5ede1392988b273d66d7294e9f98bd21f5995b64f04020b
 */
void chasles_euler_rates_xyx(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double t4 = (t3 == 0.0 ? 0.0 : omega[2] * t1 - omega[1] * t2) / t3;
    const double theta_dot2 = -t4;
    const double theta_dot0 = omega[0] + cos(angles[1]) * t4;
    const double theta_dot1 = omega[1] * t1 + omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xyx in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 6680ed5e0065e86be5ede1392988b273d66d7294e9f98bd21f5995b64f04020b
 */
void chasles_euler_rates_xyxf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float t4 = (t3 == 0.0f ? 0.0f : omega[2] * t1 - omega[1] * t2) / t3;
    const float theta_dot2 = -t4;
    const float theta_dot0 = omega[0] + cosf(angles[1]) * t4;
    const float theta_dot1 = omega[1] * t1 + omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xyx for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 6680ed5e0065e86be5ede1392988b273d66d7294e9f98bd21f5995b64f04020b
 */
void chasles_euler_rates_xyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_xyx(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rates_xyxf for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 6680ed5e0065e86be5ede1392988b273d66d7294e9f98bd21f5995b64f04020b
 */
void chasles_euler_rates_xyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_xyxf(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 The rotation by Euler angles about x, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 0cea117706a64d97d8bdbd2e4fd380fc62206ab55d7d2a91540f368cc27f9870
 */
void chasles_rotation_from_euler_xyz(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double Q2 = sin(angles[1]);
    const double t4 = t2 * Q2;
    const double Q5 = -(t2 * t3);
    const double t5 = t1 * Q2;
    const double Q8 = t1 * t3;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q0 = t3 * t6;
    const double Q1 = -(t3 * t7);
    const double Q3 = t4 * t6 + t1 * t7;
    const double Q4 = t1 * t6 - t4 * t7;
    const double Q6 = t2 * t7 - t5 * t6;
    const double Q7 = t5 * t7 + t2 * t6;
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
 * Ex 3.10 chasles_rotation_from_euler_xyz in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 0cea117706a64d97d8bdbd2e4fd380fc62206ab55d7d2a91540f368cc27f9870
 */
void chasles_rotation_from_euler_xyzf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float Q2 = sinf(angles[1]);
    const float t4 = t2 * Q2;
    const float Q5 = -(t2 * t3);
    const float t5 = t1 * Q2;
    const float Q8 = t1 * t3;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q0 = t3 * t6;
    const float Q1 = -(t3 * t7);
    const float Q3 = t4 * t6 + t1 * t7;
    const float Q4 = t1 * t6 - t4 * t7;
    const float Q6 = t2 * t7 - t5 * t6;
    const float Q7 = t5 * t7 + t2 * t6;
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
 * Ex 3.10 chasles_rotation_from_euler_xyz for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 0cea117706a64d97d8bdbd2e4fd380fc62206ab55d7d2a91540f368cc27f9870
 */
void chasles_rotation_from_euler_xyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_xyz(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 chasles_rotation_from_euler_xyzf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 0cea117706a64d97d8bdbd2e4fd380fc62206ab55d7d2a91540f368cc27f9870
 */
void chasles_rotation_from_euler_xyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_xyzf(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 727b20e1b0b73863606b227bcb1ee8f63318534fcd2691b488dd6bb3e008f7a5
 */
void chasles_euler_rate_matrix_xyz(const double angles[3], double W[9])
{
    const double W4 = cos(angles[0]);
    const double W7 = sin(angles[0]);
    const double t1 = cos(angles[1]);
    const double W2 = sin(angles[1]);
    const double W5 = -(W7 * t1);
    const double W8 = W4 * t1;
    W[0] = 1.0;
    W[1] = 0.0;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xyz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 727b20e1b0b73863606b227bcb1ee8f63318534fcd2691b488dd6bb3e008f7a5
 */
void chasles_euler_rate_matrix_xyzf(const float angles[3], float W[9])
{
    const float W4 = cosf(angles[0]);
    const float W7 = sinf(angles[0]);
    const float t1 = cosf(angles[1]);
    const float W2 = sinf(angles[1]);
    const float W5 = -(W7 * t1);
    const float W8 = W4 * t1;
    W[0] = 1.0f;
    W[1] = 0.0f;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xyz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 727b20e1b0b73863606b227bcb1ee8f63318534fcd2691b488dd6bb3e008f7a5
 */
void chasles_euler_rate_matrix_xyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_xyz(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xyzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 727b20e1b0b73863606b227bcb1ee8f63318534fcd2691b488dd6bb3e008f7a5
 */
void chasles_euler_rate_matrix_xyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_xyzf(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 2be843b1c8bcf554409134741a98ded93388365670f614f6cb1fc893a0e8a883
 */
void chasles_euler_rate_matrix_body_xyz(const double angles[3], double W_body[9])
{
    const double t1 = cos(angles[1]);
    const double W_body6 = sin(angles[1]);
    const double W_body4 = cos(angles[2]);
    const double W_body0 = t1 * W_body4;
    const double W_body1 = sin(angles[2]);
    const double W_body3 = -(t1 * W_body1);
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = 0.0;
    W_body[8] = 1.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xyz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2be843b1c8bcf554409134741a98ded93388365670f614f6cb1fc893a0e8a883
 */
void chasles_euler_rate_matrix_body_xyzf(const float angles[3], float W_body[9])
{
    const float t1 = cosf(angles[1]);
    const float W_body6 = sinf(angles[1]);
    const float W_body4 = cosf(angles[2]);
    const float W_body0 = t1 * W_body4;
    const float W_body1 = sinf(angles[2]);
    const float W_body3 = -(t1 * W_body1);
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = 0.0f;
    W_body[8] = 1.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xyz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2be843b1c8bcf554409134741a98ded93388365670f614f6cb1fc893a0e8a883
 */
void chasles_euler_rate_matrix_body_xyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_xyz(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xyzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2be843b1c8bcf554409134741a98ded93388365670f614f6cb1fc893a0e8a883
 */
void chasles_euler_rate_matrix_body_xyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_xyzf(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 The rates of Euler angles about x, y, z from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 bd0c6f4b6dded2540673b31111efab98cd56656a47a7d1c15a58ec3feec76bb1
 */
void chasles_euler_rates_xyz(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[2] * t1 - omega[1] * t2) / t3;
    const double theta_dot0 = omega[0] - sin(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[1] * t1 + omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xyz in single precision.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 bd0c6f4b6dded2540673b31111efab98cd56656a47a7d1c15a58ec3feec76bb1
 */
void chasles_euler_rates_xyzf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[2] * t1 - omega[1] * t2) / t3;
    const float theta_dot0 = omega[0] - sinf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[1] * t1 + omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xyz for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 bd0c6f4b6dded2540673b31111efab98cd56656a47a7d1c15a58ec3feec76bb1
 */
void chasles_euler_rates_xyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_xyz(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rates_xyzf for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 bd0c6f4b6dded2540673b31111efab98cd56656a47a7d1c15a58ec3feec76bb1
 */
void chasles_euler_rates_xyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_xyzf(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 The rotation by Euler angles about x, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 fa5672d572ba62d9e45fffa4848cc24a0c47c7067a8a59b865433226cb492f17
 */
void chasles_rotation_from_euler_xzx(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double Q0 = cos(angles[1]);
    const double t3 = sin(angles[1]);
    const double Q3 = t1 * t3;
    const double t4 = t1 * Q0;
    const double Q6 = t2 * t3;
    const double t5 = t2 * Q0;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q1 = -(t3 * t6);
    const double Q2 = t3 * t7;
    const double Q4 = t4 * t6 - t2 * t7;
    const double Q5 = -(t4 * t7 + t2 * t6);
    const double Q7 = t5 * t6 + t1 * t7;
    const double Q8 = t1 * t6 - t5 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_xzx in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 fa5672d572ba62d9e45fffa4848cc24a0c47c7067a8a59b865433226cb492f17
 */
void chasles_rotation_from_euler_xzxf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float Q0 = cosf(angles[1]);
    const float t3 = sinf(angles[1]);
    const float Q3 = t1 * t3;
    const float t4 = t1 * Q0;
    const float Q6 = t2 * t3;
    const float t5 = t2 * Q0;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q1 = -(t3 * t6);
    const float Q2 = t3 * t7;
    const float Q4 = t4 * t6 - t2 * t7;
    const float Q5 = -(t4 * t7 + t2 * t6);
    const float Q7 = t5 * t6 + t1 * t7;
    const float Q8 = t1 * t6 - t5 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_xzx for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 fa5672d572ba62d9e45fffa4848cc24a0c47c7067a8a59b865433226cb492f17
 */
void chasles_rotation_from_euler_xzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_xzx(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 chasles_rotation_from_euler_xzxf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 fa5672d572ba62d9e45fffa4848cc24a0c47c7067a8a59b865433226cb492f17
 */
void chasles_rotation_from_euler_xzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_xzxf(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 dc3972bfdbefe855a135e5d6dfe1379102462102153180de7ed283e96eeb6111
 */
void chasles_euler_rate_matrix_xzx(const double angles[3], double W[9])
{
    const double W7 = cos(angles[0]);
    const double t1 = sin(angles[0]);
    const double W4 = -t1;
    const double W2 = cos(angles[1]);
    const double t2 = sin(angles[1]);
    const double W5 = W7 * t2;
    const double W8 = t1 * t2;
    W[0] = 1.0;
    W[1] = 0.0;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xzx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 dc3972bfdbefe855a135e5d6dfe1379102462102153180de7ed283e96eeb6111
 */
void chasles_euler_rate_matrix_xzxf(const float angles[3], float W[9])
{
    const float W7 = cosf(angles[0]);
    const float t1 = sinf(angles[0]);
    const float W4 = -t1;
    const float W2 = cosf(angles[1]);
    const float t2 = sinf(angles[1]);
    const float W5 = W7 * t2;
    const float W8 = t1 * t2;
    W[0] = 1.0f;
    W[1] = 0.0f;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xzx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 dc3972bfdbefe855a135e5d6dfe1379102462102153180de7ed283e96eeb6111
 */
void chasles_euler_rate_matrix_xzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_xzx(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xzxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 dc3972bfdbefe855a135e5d6dfe1379102462102153180de7ed283e96eeb6111
 */
void chasles_euler_rate_matrix_xzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_xzxf(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 d9e0e82546acba106ac4c57420a2eab05b641c00df85ff7be216b8a0fc9d8665
 */
void chasles_euler_rate_matrix_body_xzx(const double angles[3], double W_body[9])
{
    const double W_body0 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W_body7 = cos(angles[2]);
    const double W_body3 = -(t1 * W_body7);
    const double W_body4 = sin(angles[2]);
    const double W_body6 = t1 * W_body4;
    W_body[0] = W_body0;
    W_body[1] = 0.0;
    W_body[2] = 1.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xzx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 d9e0e82546acba106ac4c57420a2eab05b641c00df85ff7be216b8a0fc9d8665
 */
void chasles_euler_rate_matrix_body_xzxf(const float angles[3], float W_body[9])
{
    const float W_body0 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W_body7 = cosf(angles[2]);
    const float W_body3 = -(t1 * W_body7);
    const float W_body4 = sinf(angles[2]);
    const float W_body6 = t1 * W_body4;
    W_body[0] = W_body0;
    W_body[1] = 0.0f;
    W_body[2] = 1.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xzx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 d9e0e82546acba106ac4c57420a2eab05b641c00df85ff7be216b8a0fc9d8665
 */
void chasles_euler_rate_matrix_body_xzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_xzx(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xzxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 d9e0e82546acba106ac4c57420a2eab05b641c00df85ff7be216b8a0fc9d8665
 */
void chasles_euler_rate_matrix_body_xzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_xzxf(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 The rates of Euler angles about x, z, x from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 408e95f0d48f8fcc6450ff354821b3bcc7b8afe170311512bf6808fc6ebf035d
 */
void chasles_euler_rates_xzx(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[1] * t1 + omega[2] * t2) / t3;
    const double theta_dot0 = omega[0] - cos(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[2] * t1 - omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xzx in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 408e95f0d48f8fcc6450ff354821b3bcc7b8afe170311512bf6808fc6ebf035d
 */
void chasles_euler_rates_xzxf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[1] * t1 + omega[2] * t2) / t3;
    const float theta_dot0 = omega[0] - cosf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[2] * t1 - omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xzx for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 408e95f0d48f8fcc6450ff354821b3bcc7b8afe170311512bf6808fc6ebf035d
 */
void chasles_euler_rates_xzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_xzx(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rates_xzxf for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 408e95f0d48f8fcc6450ff354821b3bcc7b8afe170311512bf6808fc6ebf035d
 */
void chasles_euler_rates_xzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_xzxf(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 The rotation by Euler angles about x, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 ec01d03ae5956d3c060281719ab7e0fe33cdb6c1a61009f0ecedd6b28c16d955
 */
void chasles_rotation_from_euler_xzy(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double t4 = sin(angles[1]);
    const double Q1 = -t4;
    const double t5 = t1 * t4;
    const double Q4 = t1 * t3;
    const double t6 = t2 * t4;
    const double Q7 = t2 * t3;
    const double t7 = cos(angles[2]);
    const double t8 = sin(angles[2]);
    const double Q0 = t3 * t7;
    const double Q2 = t3 * t8;
    const double Q3 = t5 * t7 + t2 * t8;
    const double Q5 = t5 * t8 - t2 * t7;
    const double Q6 = t6 * t7 - t1 * t8;
    const double Q8 = t6 * t8 + t1 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_xzy in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 ec01d03ae5956d3c060281719ab7e0fe33cdb6c1a61009f0ecedd6b28c16d955
 */
void chasles_rotation_from_euler_xzyf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float t4 = sinf(angles[1]);
    const float Q1 = -t4;
    const float t5 = t1 * t4;
    const float Q4 = t1 * t3;
    const float t6 = t2 * t4;
    const float Q7 = t2 * t3;
    const float t7 = cosf(angles[2]);
    const float t8 = sinf(angles[2]);
    const float Q0 = t3 * t7;
    const float Q2 = t3 * t8;
    const float Q3 = t5 * t7 + t2 * t8;
    const float Q5 = t5 * t8 - t2 * t7;
    const float Q6 = t6 * t7 - t1 * t8;
    const float Q8 = t6 * t8 + t1 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_xzy for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 ec01d03ae5956d3c060281719ab7e0fe33cdb6c1a61009f0ecedd6b28c16d955
 */
void chasles_rotation_from_euler_xzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_xzy(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 chasles_rotation_from_euler_xzyf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 ec01d03ae5956d3c060281719ab7e0fe33cdb6c1a61009f0ecedd6b28c16d955
 */
void chasles_rotation_from_euler_xzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_xzyf(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 eff8b044920f2622991ff4992754af00b4bb6db0588c9c38024defb9d92b31a8
 */
void chasles_euler_rate_matrix_xzy(const double angles[3], double W[9])
{
    const double W7 = cos(angles[0]);
    const double t1 = sin(angles[0]);
    const double W4 = -t1;
    const double t2 = cos(angles[1]);
    const double W2 = -sin(angles[1]);
    const double W5 = W7 * t2;
    const double W8 = t1 * t2;
    W[0] = 1.0;
    W[1] = 0.0;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xzy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 eff8b044920f2622991ff4992754af00b4bb6db0588c9c38024defb9d92b31a8
 */
void chasles_euler_rate_matrix_xzyf(const float angles[3], float W[9])
{
    const float W7 = cosf(angles[0]);
    const float t1 = sinf(angles[0]);
    const float W4 = -t1;
    const float t2 = cosf(angles[1]);
    const float W2 = -sinf(angles[1]);
    const float W5 = W7 * t2;
    const float W8 = t1 * t2;
    W[0] = 1.0f;
    W[1] = 0.0f;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xzy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 eff8b044920f2622991ff4992754af00b4bb6db0588c9c38024defb9d92b31a8
 */
void chasles_euler_rate_matrix_xzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_xzy(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xzyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 eff8b044920f2622991ff4992754af00b4bb6db0588c9c38024defb9d92b31a8
 */
void chasles_euler_rate_matrix_xzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_xzyf(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 82d38f5fbd88f30e0766279355f8c1075afa7f058dd52a2ba49700c1103941b2
 */
void chasles_euler_rate_matrix_body_xzy(const double angles[3], double W_body[9])
{
    const double t1 = cos(angles[1]);
    const double W_body3 = -sin(angles[1]);
    const double W_body7 = cos(angles[2]);
    const double W_body0 = t1 * W_body7;
    const double t2 = sin(angles[2]);
    const double W_body1 = -t2;
    const double W_body6 = t1 * t2;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = 0.0;
    W_body[5] = 1.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xzy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 82d38f5fbd88f30e0766279355f8c1075afa7f058dd52a2ba49700c1103941b2
 */
void chasles_euler_rate_matrix_body_xzyf(const float angles[3], float W_body[9])
{
    const float t1 = cosf(angles[1]);
    const float W_body3 = -sinf(angles[1]);
    const float W_body7 = cosf(angles[2]);
    const float W_body0 = t1 * W_body7;
    const float t2 = sinf(angles[2]);
    const float W_body1 = -t2;
    const float W_body6 = t1 * t2;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = 0.0f;
    W_body[5] = 1.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xzy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 82d38f5fbd88f30e0766279355f8c1075afa7f058dd52a2ba49700c1103941b2
 */
void chasles_euler_rate_matrix_body_xzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_xzy(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xzyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 82d38f5fbd88f30e0766279355f8c1075afa7f058dd52a2ba49700c1103941b2
 */
void chasles_euler_rate_matrix_body_xzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_xzyf(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 The rates of Euler angles about x, z, y from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 c13c9cc6d29ab7900f6ed7fef43449399dc7948756dc5e0c1278fad40f8eaf5f
 */
void chasles_euler_rates_xzy(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[1] * t1 + omega[2] * t2) / t3;
    const double theta_dot0 = omega[0] + sin(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[2] * t1 - omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xzy in single precision.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 c13c9cc6d29ab7900f6ed7fef43449399dc7948756dc5e0c1278fad40f8eaf5f
 */
void chasles_euler_rates_xzyf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[1] * t1 + omega[2] * t2) / t3;
    const float theta_dot0 = omega[0] + sinf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[2] * t1 - omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xzy for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 c13c9cc6d29ab7900f6ed7fef43449399dc7948756dc5e0c1278fad40f8eaf5f
 */
void chasles_euler_rates_xzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_xzy(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rates_xzyf for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 c13c9cc6d29ab7900f6ed7fef43449399dc7948756dc5e0c1278fad40f8eaf5f
 */
void chasles_euler_rates_xzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_xzyf(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 The rotation by Euler angles about y, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 39c327f2b06e2eb28d5297a5219cdf25d8c6fa35f3e8c4abd686a96f628448b9
 */
void chasles_rotation_from_euler_yxy(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double Q4 = cos(angles[1]);
    const double t3 = sin(angles[1]);
    const double Q1 = t2 * t3;
    const double t4 = t2 * Q4;
    const double Q7 = t1 * t3;
    const double t5 = t1 * Q4;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q0 = t1 * t6 - t4 * t7;
    const double Q2 = t1 * t7 + t4 * t6;
    const double Q3 = t3 * t7;
    const double Q5 = -(t3 * t6);
    const double Q6 = -(t2 * t6 + t5 * t7);
    const double Q8 = t5 * t6 - t2 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yxy in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 39c327f2b06e2eb28d5297a5219cdf25d8c6fa35f3e8c4abd686a96f628448b9
 */
void chasles_rotation_from_euler_yxyf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float Q4 = cosf(angles[1]);
    const float t3 = sinf(angles[1]);
    const float Q1 = t2 * t3;
    const float t4 = t2 * Q4;
    const float Q7 = t1 * t3;
    const float t5 = t1 * Q4;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q0 = t1 * t6 - t4 * t7;
    const float Q2 = t1 * t7 + t4 * t6;
    const float Q3 = t3 * t7;
    const float Q5 = -(t3 * t6);
    const float Q6 = -(t2 * t6 + t5 * t7);
    const float Q8 = t5 * t6 - t2 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yxy for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 39c327f2b06e2eb28d5297a5219cdf25d8c6fa35f3e8c4abd686a96f628448b9
 */
void chasles_rotation_from_euler_yxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_yxy(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 chasles_rotation_from_euler_yxyf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 39c327f2b06e2eb28d5297a5219cdf25d8c6fa35f3e8c4abd686a96f628448b9
 */
void chasles_rotation_from_euler_yxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_yxyf(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 a636f1aef1e498fc12bb18c833be214ecab09d723d189feb6293198c1da27769
 */
void chasles_euler_rate_matrix_yxy(const double angles[3], double W[9])
{
    const double W1 = cos(angles[0]);
    const double t1 = sin(angles[0]);
    const double W7 = -t1;
    const double W5 = cos(angles[1]);
    const double t2 = sin(angles[1]);
    const double W2 = t1 * t2;
    const double W8 = W1 * t2;
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0;
    W[4] = 0.0;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yxy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 a636f1aef1e498fc12bb18c833be214ecab09d723d189feb6293198c1da27769
 */
void chasles_euler_rate_matrix_yxyf(const float angles[3], float W[9])
{
    const float W1 = cosf(angles[0]);
    const float t1 = sinf(angles[0]);
    const float W7 = -t1;
    const float W5 = cosf(angles[1]);
    const float t2 = sinf(angles[1]);
    const float W2 = t1 * t2;
    const float W8 = W1 * t2;
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0f;
    W[4] = 0.0f;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yxy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 a636f1aef1e498fc12bb18c833be214ecab09d723d189feb6293198c1da27769
 */
void chasles_euler_rate_matrix_yxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_yxy(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yxyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 a636f1aef1e498fc12bb18c833be214ecab09d723d189feb6293198c1da27769
 */
void chasles_euler_rate_matrix_yxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_yxyf(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 542fac587b2f6c693e2f358949f10e38342e83da48b28f0bfefa2518c3dbbf7d
 */
void chasles_euler_rate_matrix_body_yxy(const double angles[3], double W_body[9])
{
    const double W_body3 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W_body1 = cos(angles[2]);
    const double W_body7 = sin(angles[2]);
    const double W_body0 = t1 * W_body7;
    const double W_body6 = -(t1 * W_body1);
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = 0.0;
    W_body[5] = 1.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yxy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 542fac587b2f6c693e2f358949f10e38342e83da48b28f0bfefa2518c3dbbf7d
 */
void chasles_euler_rate_matrix_body_yxyf(const float angles[3], float W_body[9])
{
    const float W_body3 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W_body1 = cosf(angles[2]);
    const float W_body7 = sinf(angles[2]);
    const float W_body0 = t1 * W_body7;
    const float W_body6 = -(t1 * W_body1);
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = 0.0f;
    W_body[5] = 1.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yxy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 542fac587b2f6c693e2f358949f10e38342e83da48b28f0bfefa2518c3dbbf7d
 */
void chasles_euler_rate_matrix_body_yxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_yxy(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yxyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 542fac587b2f6c693e2f358949f10e38342e83da48b28f0bfefa2518c3dbbf7d
 */
void chasles_euler_rate_matrix_body_yxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_yxyf(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 The rates of Euler angles about y, x, y from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 cd5dec36e2ffbb4d79f5e51715750a932a8dcd10315484afd24a2b8c5417093d
 */
void chasles_euler_rates_yxy(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[0] * t2 + omega[2] * t1) / t3;
    const double theta_dot0 = omega[1] - cos(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[0] * t1 - omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yxy in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 cd5dec36e2ffbb4d79f5e51715750a932a8dcd10315484afd24a2b8c5417093d
 */
void chasles_euler_rates_yxyf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[0] * t2 + omega[2] * t1) / t3;
    const float theta_dot0 = omega[1] - cosf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[0] * t1 - omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yxy for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 cd5dec36e2ffbb4d79f5e51715750a932a8dcd10315484afd24a2b8c5417093d
 */
void chasles_euler_rates_yxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_yxy(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rates_yxyf for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 cd5dec36e2ffbb4d79f5e51715750a932a8dcd10315484afd24a2b8c5417093d
 */
void chasles_euler_rates_yxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_yxyf(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 The rotation by Euler angles about y, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 9a10b4aca9084db3dbe838592a18dd16991e4e9266812ea40c364e475765c2da
 */
void chasles_rotation_from_euler_yxz(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double t4 = sin(angles[1]);
    const double Q5 = -t4;
    const double t5 = t2 * t4;
    const double Q2 = t2 * t3;
    const double t6 = t1 * t4;
    const double Q8 = t1 * t3;
    const double t7 = cos(angles[2]);
    const double t8 = sin(angles[2]);
    const double Q0 = t1 * t7 + t5 * t8;
    const double Q1 = t5 * t7 - t1 * t8;
    const double Q3 = t3 * t8;
    const double Q4 = t3 * t7;
    const double Q6 = t6 * t8 - t2 * t7;
    const double Q7 = t2 * t8 + t6 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yxz in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 9a10b4aca9084db3dbe838592a18dd16991e4e9266812ea40c364e475765c2da
 */
void chasles_rotation_from_euler_yxzf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float t4 = sinf(angles[1]);
    const float Q5 = -t4;
    const float t5 = t2 * t4;
    const float Q2 = t2 * t3;
    const float t6 = t1 * t4;
    const float Q8 = t1 * t3;
    const float t7 = cosf(angles[2]);
    const float t8 = sinf(angles[2]);
    const float Q0 = t1 * t7 + t5 * t8;
    const float Q1 = t5 * t7 - t1 * t8;
    const float Q3 = t3 * t8;
    const float Q4 = t3 * t7;
    const float Q6 = t6 * t8 - t2 * t7;
    const float Q7 = t2 * t8 + t6 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yxz for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 9a10b4aca9084db3dbe838592a18dd16991e4e9266812ea40c364e475765c2da
 */
void chasles_rotation_from_euler_yxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_yxz(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 chasles_rotation_from_euler_yxzf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 9a10b4aca9084db3dbe838592a18dd16991e4e9266812ea40c364e475765c2da
 */
void chasles_rotation_from_euler_yxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_yxzf(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 e4b0c1a359b6a0462bcaf854f5621ef6f306aaed262ef9eedca1b9dfd21141db
 */
void chasles_euler_rate_matrix_yxz(const double angles[3], double W[9])
{
    const double W1 = cos(angles[0]);
    const double t1 = sin(angles[0]);
    const double W7 = -t1;
    const double t2 = cos(angles[1]);
    const double W5 = -sin(angles[1]);
    const double W2 = t1 * t2;
    const double W8 = W1 * t2;
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0;
    W[4] = 0.0;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yxz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 e4b0c1a359b6a0462bcaf854f5621ef6f306aaed262ef9eedca1b9dfd21141db
 */
void chasles_euler_rate_matrix_yxzf(const float angles[3], float W[9])
{
    const float W1 = cosf(angles[0]);
    const float t1 = sinf(angles[0]);
    const float W7 = -t1;
    const float t2 = cosf(angles[1]);
    const float W5 = -sinf(angles[1]);
    const float W2 = t1 * t2;
    const float W8 = W1 * t2;
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0f;
    W[4] = 0.0f;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yxz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 e4b0c1a359b6a0462bcaf854f5621ef6f306aaed262ef9eedca1b9dfd21141db
 */
void chasles_euler_rate_matrix_yxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_yxz(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yxzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 e4b0c1a359b6a0462bcaf854f5621ef6f306aaed262ef9eedca1b9dfd21141db
 */
void chasles_euler_rate_matrix_yxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_yxzf(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 bbaf7b40aee302ecf502aebad748a90068ef997f7ef78c435934daec4e186893
 */
void chasles_euler_rate_matrix_body_yxz(const double angles[3], double W_body[9])
{
    const double t1 = cos(angles[1]);
    const double W_body6 = -sin(angles[1]);
    const double W_body1 = cos(angles[2]);
    const double t2 = sin(angles[2]);
    const double W_body0 = t1 * t2;
    const double W_body4 = -t2;
    const double W_body3 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = 0.0;
    W_body[8] = 1.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yxz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 bbaf7b40aee302ecf502aebad748a90068ef997f7ef78c435934daec4e186893
 */
void chasles_euler_rate_matrix_body_yxzf(const float angles[3], float W_body[9])
{
    const float t1 = cosf(angles[1]);
    const float W_body6 = -sinf(angles[1]);
    const float W_body1 = cosf(angles[2]);
    const float t2 = sinf(angles[2]);
    const float W_body0 = t1 * t2;
    const float W_body4 = -t2;
    const float W_body3 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = 0.0f;
    W_body[8] = 1.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yxz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 bbaf7b40aee302ecf502aebad748a90068ef997f7ef78c435934daec4e186893
 */
void chasles_euler_rate_matrix_body_yxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_yxz(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yxzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 bbaf7b40aee302ecf502aebad748a90068ef997f7ef78c435934daec4e186893
 */
void chasles_euler_rate_matrix_body_yxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_yxzf(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 The rates of Euler angles about y, x, z from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 edb81e753178c5fce1e78e2d84d24357ec01af9efb3639d407093ca1170b8f22
 */
void chasles_euler_rates_yxz(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[0] * t2 + omega[2] * t1) / t3;
    const double theta_dot0 = omega[1] + sin(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[0] * t1 - omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yxz in single precision.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 edb81e753178c5fce1e78e2d84d24357ec01af9efb3639d407093ca1170b8f22
 */
void chasles_euler_rates_yxzf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[0] * t2 + omega[2] * t1) / t3;
    const float theta_dot0 = omega[1] + sinf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[0] * t1 - omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yxz for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 edb81e753178c5fce1e78e2d84d24357ec01af9efb3639d407093ca1170b8f22
 */
void chasles_euler_rates_yxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_yxz(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rates_yxzf for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 edb81e753178c5fce1e78e2d84d24357ec01af9efb3639d407093ca1170b8f22
 */
void chasles_euler_rates_yxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_yxzf(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 The rotation by Euler angles about y, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 8067174eae8e12da17f50ae58f90ed494f2ed48db1f70a248864566fd994638c
 */
void chasles_rotation_from_euler_yzx(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double Q3 = sin(angles[1]);
    const double Q0 = t1 * t3;
    const double t4 = t1 * Q3;
    const double Q6 = -(t2 * t3);
    const double t5 = t2 * Q3;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q1 = t2 * t7 - t4 * t6;
    const double Q2 = t4 * t7 + t2 * t6;
    const double Q4 = t3 * t6;
    const double Q5 = -(t3 * t7);
    const double Q7 = t5 * t6 + t1 * t7;
    const double Q8 = t1 * t6 - t5 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yzx in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 8067174eae8e12da17f50ae58f90ed494f2ed48db1f70a248864566fd994638c
 */
void chasles_rotation_from_euler_yzxf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float Q3 = sinf(angles[1]);
    const float Q0 = t1 * t3;
    const float t4 = t1 * Q3;
    const float Q6 = -(t2 * t3);
    const float t5 = t2 * Q3;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q1 = t2 * t7 - t4 * t6;
    const float Q2 = t4 * t7 + t2 * t6;
    const float Q4 = t3 * t6;
    const float Q5 = -(t3 * t7);
    const float Q7 = t5 * t6 + t1 * t7;
    const float Q8 = t1 * t6 - t5 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yzx for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 8067174eae8e12da17f50ae58f90ed494f2ed48db1f70a248864566fd994638c
 */
void chasles_rotation_from_euler_yzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_yzx(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 chasles_rotation_from_euler_yzxf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 8067174eae8e12da17f50ae58f90ed494f2ed48db1f70a248864566fd994638c
 */
void chasles_rotation_from_euler_yzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_yzxf(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 48b2bdb7a1b3028c165cf254cc61d428a4e18bdcc2621e21de7940aac283a8f6
 */
void chasles_euler_rate_matrix_yzx(const double angles[3], double W[9])
{
    const double W7 = cos(angles[0]);
    const double W1 = sin(angles[0]);
    const double t1 = cos(angles[1]);
    const double W5 = sin(angles[1]);
    const double W2 = W7 * t1;
    const double W8 = -(W1 * t1);
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0;
    W[4] = 0.0;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yzx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 48b2bdb7a1b3028c165cf254cc61d428a4e18bdcc2621e21de7940aac283a8f6
 */
void chasles_euler_rate_matrix_yzxf(const float angles[3], float W[9])
{
    const float W7 = cosf(angles[0]);
    const float W1 = sinf(angles[0]);
    const float t1 = cosf(angles[1]);
    const float W5 = sinf(angles[1]);
    const float W2 = W7 * t1;
    const float W8 = -(W1 * t1);
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0f;
    W[4] = 0.0f;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yzx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 48b2bdb7a1b3028c165cf254cc61d428a4e18bdcc2621e21de7940aac283a8f6
 */
void chasles_euler_rate_matrix_yzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_yzx(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yzxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 48b2bdb7a1b3028c165cf254cc61d428a4e18bdcc2621e21de7940aac283a8f6
 */
void chasles_euler_rate_matrix_yzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_yzxf(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 f7ecbe499957a1df734cc614102e267117566d3f6d80b71ca89a19ff14ae73d4
 */
void chasles_euler_rate_matrix_body_yzx(const double angles[3], double W_body[9])
{
    const double t1 = cos(angles[1]);
    const double W_body0 = sin(angles[1]);
    const double W_body7 = cos(angles[2]);
    const double W_body3 = t1 * W_body7;
    const double W_body4 = sin(angles[2]);
    const double W_body6 = -(t1 * W_body4);
    W_body[0] = W_body0;
    W_body[1] = 0.0;
    W_body[2] = 1.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yzx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 f7ecbe499957a1df734cc614102e267117566d3f6d80b71ca89a19ff14ae73d4
 */
void chasles_euler_rate_matrix_body_yzxf(const float angles[3], float W_body[9])
{
    const float t1 = cosf(angles[1]);
    const float W_body0 = sinf(angles[1]);
    const float W_body7 = cosf(angles[2]);
    const float W_body3 = t1 * W_body7;
    const float W_body4 = sinf(angles[2]);
    const float W_body6 = -(t1 * W_body4);
    W_body[0] = W_body0;
    W_body[1] = 0.0f;
    W_body[2] = 1.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yzx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 f7ecbe499957a1df734cc614102e267117566d3f6d80b71ca89a19ff14ae73d4
 */
void chasles_euler_rate_matrix_body_yzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_yzx(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yzxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 f7ecbe499957a1df734cc614102e267117566d3f6d80b71ca89a19ff14ae73d4
 */
void chasles_euler_rate_matrix_body_yzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_yzxf(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 The rates of Euler angles about y, z, x from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 33b2d9256eb74313ba05c6fc7b3e91f7765487fe3f26de05f701ff4288cedb31
 */
void chasles_euler_rates_yzx(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[0] * t1 - omega[2] * t2) / t3;
    const double theta_dot0 = omega[1] - sin(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[0] * t2 + omega[2] * t1;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yzx in single precision.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 33b2d9256eb74313ba05c6fc7b3e91f7765487fe3f26de05f701ff4288cedb31
 */
void chasles_euler_rates_yzxf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[0] * t1 - omega[2] * t2) / t3;
    const float theta_dot0 = omega[1] - sinf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[0] * t2 + omega[2] * t1;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yzx for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 33b2d9256eb74313ba05c6fc7b3e91f7765487fe3f26de05f701ff4288cedb31
 */
void chasles_euler_rates_yzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_yzx(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rates_yzxf for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 33b2d9256eb74313ba05c6fc7b3e91f7765487fe3f26de05f701ff4288cedb31
 */
void chasles_euler_rates_yzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_yzxf(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 The rotation by Euler angles about y, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 5b5ba0ef7860418b292b8302888ff85bd1afbe1f26dcb574f075aeaf9ff38357
 */
void chasles_rotation_from_euler_yzy(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double Q4 = cos(angles[1]);
    const double t3 = sin(angles[1]);
    const double t4 = t1 * Q4;
    const double Q1 = -(t1 * t3);
    const double t5 = t2 * Q4;
    const double Q7 = t2 * t3;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q0 = t4 * t6 - t2 * t7;
    const double Q2 = t4 * t7 + t2 * t6;
    const double Q3 = t3 * t6;
    const double Q5 = t3 * t7;
    const double Q6 = -(t5 * t6 + t1 * t7);
    const double Q8 = t1 * t6 - t5 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yzy in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 5b5ba0ef7860418b292b8302888ff85bd1afbe1f26dcb574f075aeaf9ff38357
 */
void chasles_rotation_from_euler_yzyf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float Q4 = cosf(angles[1]);
    const float t3 = sinf(angles[1]);
    const float t4 = t1 * Q4;
    const float Q1 = -(t1 * t3);
    const float t5 = t2 * Q4;
    const float Q7 = t2 * t3;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q0 = t4 * t6 - t2 * t7;
    const float Q2 = t4 * t7 + t2 * t6;
    const float Q3 = t3 * t6;
    const float Q5 = t3 * t7;
    const float Q6 = -(t5 * t6 + t1 * t7);
    const float Q8 = t1 * t6 - t5 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yzy for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 5b5ba0ef7860418b292b8302888ff85bd1afbe1f26dcb574f075aeaf9ff38357
 */
void chasles_rotation_from_euler_yzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_yzy(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 chasles_rotation_from_euler_yzyf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 5b5ba0ef7860418b292b8302888ff85bd1afbe1f26dcb574f075aeaf9ff38357
 */
void chasles_rotation_from_euler_yzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_yzyf(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 173a43a221173a0bd6addd4a110cef604ab7fcd2cf82d4df270377e26c071e83
 */
void chasles_euler_rate_matrix_yzy(const double angles[3], double W[9])
{
    const double W7 = cos(angles[0]);
    const double W1 = sin(angles[0]);
    const double W5 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W2 = -(W7 * t1);
    const double W8 = W1 * t1;
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0;
    W[4] = 0.0;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yzy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 173a43a221173a0bd6addd4a110cef604ab7fcd2cf82d4df270377e26c071e83
 */
void chasles_euler_rate_matrix_yzyf(const float angles[3], float W[9])
{
    const float W7 = cosf(angles[0]);
    const float W1 = sinf(angles[0]);
    const float W5 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W2 = -(W7 * t1);
    const float W8 = W1 * t1;
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0f;
    W[4] = 0.0f;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yzy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 173a43a221173a0bd6addd4a110cef604ab7fcd2cf82d4df270377e26c071e83
 */
void chasles_euler_rate_matrix_yzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_yzy(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yzyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 173a43a221173a0bd6addd4a110cef604ab7fcd2cf82d4df270377e26c071e83
 */
void chasles_euler_rate_matrix_yzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_yzyf(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 78afe33bfd90a71cf84d41ec65d49601b950b21dcafbd952225f877c9885d2a2
 */
void chasles_euler_rate_matrix_body_yzy(const double angles[3], double W_body[9])
{
    const double W_body3 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W_body7 = cos(angles[2]);
    const double W_body0 = t1 * W_body7;
    const double t2 = sin(angles[2]);
    const double W_body1 = -t2;
    const double W_body6 = t1 * t2;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = 0.0;
    W_body[5] = 1.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yzy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 78afe33bfd90a71cf84d41ec65d49601b950b21dcafbd952225f877c9885d2a2
 */
void chasles_euler_rate_matrix_body_yzyf(const float angles[3], float W_body[9])
{
    const float W_body3 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W_body7 = cosf(angles[2]);
    const float W_body0 = t1 * W_body7;
    const float t2 = sinf(angles[2]);
    const float W_body1 = -t2;
    const float W_body6 = t1 * t2;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = 0.0f;
    W_body[5] = 1.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yzy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 78afe33bfd90a71cf84d41ec65d49601b950b21dcafbd952225f877c9885d2a2
 */
void chasles_euler_rate_matrix_body_yzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_yzy(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yzyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 78afe33bfd90a71cf84d41ec65d49601b950b21dcafbd952225f877c9885d2a2
 */
void chasles_euler_rate_matrix_body_yzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_yzyf(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 The rates of Euler angles about y, z, y from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 c2679441a74674f45a4fb62481b4da309797cb451375f5e7c969afa25969398f
 */
void chasles_euler_rates_yzy(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double t4 = (t3 == 0.0 ? 0.0 : omega[0] * t1 - omega[2] * t2) / t3;
    const double theta_dot2 = -t4;
    const double theta_dot0 = omega[1] + cos(angles[1]) * t4;
    const double theta_dot1 = omega[0] * t2 + omega[2] * t1;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yzy in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 c2679441a74674f45a4fb62481b4da309797cb451375f5e7c969afa25969398f
 */
void chasles_euler_rates_yzyf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float t4 = (t3 == 0.0f ? 0.0f : omega[0] * t1 - omega[2] * t2) / t3;
    const float theta_dot2 = -t4;
    const float theta_dot0 = omega[1] + cosf(angles[1]) * t4;
    const float theta_dot1 = omega[0] * t2 + omega[2] * t1;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yzy for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 c2679441a74674f45a4fb62481b4da309797cb451375f5e7c969afa25969398f
 */
void chasles_euler_rates_yzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_yzy(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rates_yzyf for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 c2679441a74674f45a4fb62481b4da309797cb451375f5e7c969afa25969398f
 */
void chasles_euler_rates_yzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_yzyf(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 The rotation by Euler angles about z, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 8ae99d46108398deee39b74f0f0d6af4c2ca2209815ada56c3702867ca814530
 */
void chasles_rotation_from_euler_zxy(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double Q7 = sin(angles[1]);
    const double Q1 = -(t2 * t3);
    const double t4 = t2 * Q7;
    const double Q4 = t1 * t3;
    const double t5 = t1 * Q7;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q0 = t1 * t6 - t4 * t7;
    const double Q2 = t1 * t7 + t4 * t6;
    const double Q3 = t2 * t6 + t5 * t7;
    const double Q5 = t2 * t7 - t5 * t6;
    const double Q6 = -(t3 * t7);
    const double Q8 = t3 * t6;
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
 * Ex 3.10 chasles_rotation_from_euler_zxy in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 8ae99d46108398deee39b74f0f0d6af4c2ca2209815ada56c3702867ca814530
 */
void chasles_rotation_from_euler_zxyf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float Q7 = sinf(angles[1]);
    const float Q1 = -(t2 * t3);
    const float t4 = t2 * Q7;
    const float Q4 = t1 * t3;
    const float t5 = t1 * Q7;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q0 = t1 * t6 - t4 * t7;
    const float Q2 = t1 * t7 + t4 * t6;
    const float Q3 = t2 * t6 + t5 * t7;
    const float Q5 = t2 * t7 - t5 * t6;
    const float Q6 = -(t3 * t7);
    const float Q8 = t3 * t6;
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
 * Ex 3.10 chasles_rotation_from_euler_zxy for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 8ae99d46108398deee39b74f0f0d6af4c2ca2209815ada56c3702867ca814530
 */
void chasles_rotation_from_euler_zxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_zxy(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 chasles_rotation_from_euler_zxyf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 8ae99d46108398deee39b74f0f0d6af4c2ca2209815ada56c3702867ca814530
 */
void chasles_rotation_from_euler_zxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_zxyf(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 5be122f500ea442153ec10921e5fb13dd3487b8181aba875421abbcde2b0f441
 */
void chasles_euler_rate_matrix_zxy(const double angles[3], double W[9])
{
    const double W1 = cos(angles[0]);
    const double W4 = sin(angles[0]);
    const double t1 = cos(angles[1]);
    const double W8 = sin(angles[1]);
    const double W2 = -(W4 * t1);
    const double W5 = W1 * t1;
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0;
    W[7] = 0.0;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zxy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 5be122f500ea442153ec10921e5fb13dd3487b8181aba875421abbcde2b0f441
 */
void chasles_euler_rate_matrix_zxyf(const float angles[3], float W[9])
{
    const float W1 = cosf(angles[0]);
    const float W4 = sinf(angles[0]);
    const float t1 = cosf(angles[1]);
    const float W8 = sinf(angles[1]);
    const float W2 = -(W4 * t1);
    const float W5 = W1 * t1;
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0f;
    W[7] = 0.0f;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zxy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 5be122f500ea442153ec10921e5fb13dd3487b8181aba875421abbcde2b0f441
 */
void chasles_euler_rate_matrix_zxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_zxy(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zxyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 5be122f500ea442153ec10921e5fb13dd3487b8181aba875421abbcde2b0f441
 */
void chasles_euler_rate_matrix_zxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_zxyf(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 4b435c59444750de449c28f85ae7ad26df977cf6fbda22643e49734a03373fe2
 */
void chasles_euler_rate_matrix_body_zxy(const double angles[3], double W_body[9])
{
    const double t1 = cos(angles[1]);
    const double W_body3 = sin(angles[1]);
    const double W_body1 = cos(angles[2]);
    const double W_body7 = sin(angles[2]);
    const double W_body0 = -(t1 * W_body7);
    const double W_body6 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = 0.0;
    W_body[5] = 1.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zxy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 4b435c59444750de449c28f85ae7ad26df977cf6fbda22643e49734a03373fe2
 */
void chasles_euler_rate_matrix_body_zxyf(const float angles[3], float W_body[9])
{
    const float t1 = cosf(angles[1]);
    const float W_body3 = sinf(angles[1]);
    const float W_body1 = cosf(angles[2]);
    const float W_body7 = sinf(angles[2]);
    const float W_body0 = -(t1 * W_body7);
    const float W_body6 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = 0.0f;
    W_body[5] = 1.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zxy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 4b435c59444750de449c28f85ae7ad26df977cf6fbda22643e49734a03373fe2
 */
void chasles_euler_rate_matrix_body_zxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_zxy(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zxyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 4b435c59444750de449c28f85ae7ad26df977cf6fbda22643e49734a03373fe2
 */
void chasles_euler_rate_matrix_body_zxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_zxyf(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 The rates of Euler angles about z, x, y from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 36071585fc3f03318fec1095f6fce622812bcb4c86edba593061dbcba7c5833c
 */
void chasles_euler_rates_zxy(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[1] * t1 - omega[0] * t2) / t3;
    const double theta_dot0 = omega[2] - sin(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[0] * t1 + omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zxy in single precision.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 36071585fc3f03318fec1095f6fce622812bcb4c86edba593061dbcba7c5833c
 */
void chasles_euler_rates_zxyf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[1] * t1 - omega[0] * t2) / t3;
    const float theta_dot0 = omega[2] - sinf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[0] * t1 + omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zxy for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 36071585fc3f03318fec1095f6fce622812bcb4c86edba593061dbcba7c5833c
 */
void chasles_euler_rates_zxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_zxy(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rates_zxyf for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 36071585fc3f03318fec1095f6fce622812bcb4c86edba593061dbcba7c5833c
 */
void chasles_euler_rates_zxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_zxyf(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 The rotation by Euler angles about z, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 04f70e9463c92048149fe7c49d75cab4b8a6178633341287094620e7f32079a5
 */
void chasles_rotation_from_euler_zxz(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double Q8 = cos(angles[1]);
    const double t3 = sin(angles[1]);
    const double t4 = t2 * Q8;
    const double Q2 = t2 * t3;
    const double t5 = t1 * Q8;
    const double Q5 = -(t1 * t3);
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q0 = t1 * t6 - t4 * t7;
    const double Q1 = -(t1 * t7 + t4 * t6);
    const double Q3 = t2 * t6 + t5 * t7;
    const double Q4 = t5 * t6 - t2 * t7;
    const double Q6 = t3 * t7;
    const double Q7 = t3 * t6;
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
 * Ex 3.10 chasles_rotation_from_euler_zxz in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 04f70e9463c92048149fe7c49d75cab4b8a6178633341287094620e7f32079a5
 */
void chasles_rotation_from_euler_zxzf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float Q8 = cosf(angles[1]);
    const float t3 = sinf(angles[1]);
    const float t4 = t2 * Q8;
    const float Q2 = t2 * t3;
    const float t5 = t1 * Q8;
    const float Q5 = -(t1 * t3);
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q0 = t1 * t6 - t4 * t7;
    const float Q1 = -(t1 * t7 + t4 * t6);
    const float Q3 = t2 * t6 + t5 * t7;
    const float Q4 = t5 * t6 - t2 * t7;
    const float Q6 = t3 * t7;
    const float Q7 = t3 * t6;
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
 * Ex 3.10 chasles_rotation_from_euler_zxz for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 04f70e9463c92048149fe7c49d75cab4b8a6178633341287094620e7f32079a5
 */
void chasles_rotation_from_euler_zxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_zxz(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 chasles_rotation_from_euler_zxzf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 04f70e9463c92048149fe7c49d75cab4b8a6178633341287094620e7f32079a5
 */
void chasles_rotation_from_euler_zxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_zxzf(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 39bc0189602fb535367e07a92b8264011a74e4da0fe3ae728712ee149805d981
 */
void chasles_euler_rate_matrix_zxz(const double angles[3], double W[9])
{
    const double W1 = cos(angles[0]);
    const double W4 = sin(angles[0]);
    const double W8 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W2 = W4 * t1;
    const double W5 = -(W1 * t1);
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0;
    W[7] = 0.0;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zxz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 39bc0189602fb535367e07a92b8264011a74e4da0fe3ae728712ee149805d981
 */
void chasles_euler_rate_matrix_zxzf(const float angles[3], float W[9])
{
    const float W1 = cosf(angles[0]);
    const float W4 = sinf(angles[0]);
    const float W8 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W2 = W4 * t1;
    const float W5 = -(W1 * t1);
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0f;
    W[7] = 0.0f;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zxz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 39bc0189602fb535367e07a92b8264011a74e4da0fe3ae728712ee149805d981
 */
void chasles_euler_rate_matrix_zxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_zxz(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zxzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 39bc0189602fb535367e07a92b8264011a74e4da0fe3ae728712ee149805d981
 */
void chasles_euler_rate_matrix_zxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_zxzf(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 74da24a97e78f4dbac40e98935303cf217bc7f042bf9159e791dad68a3e3f65f
 */
void chasles_euler_rate_matrix_body_zxz(const double angles[3], double W_body[9])
{
    const double W_body6 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W_body1 = cos(angles[2]);
    const double t2 = sin(angles[2]);
    const double W_body0 = t1 * t2;
    const double W_body4 = -t2;
    const double W_body3 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = 0.0;
    W_body[8] = 1.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zxz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 74da24a97e78f4dbac40e98935303cf217bc7f042bf9159e791dad68a3e3f65f
 */
void chasles_euler_rate_matrix_body_zxzf(const float angles[3], float W_body[9])
{
    const float W_body6 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W_body1 = cosf(angles[2]);
    const float t2 = sinf(angles[2]);
    const float W_body0 = t1 * t2;
    const float W_body4 = -t2;
    const float W_body3 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = 0.0f;
    W_body[8] = 1.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zxz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 74da24a97e78f4dbac40e98935303cf217bc7f042bf9159e791dad68a3e3f65f
 */
void chasles_euler_rate_matrix_body_zxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_zxz(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zxzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 74da24a97e78f4dbac40e98935303cf217bc7f042bf9159e791dad68a3e3f65f
 */
void chasles_euler_rate_matrix_body_zxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_zxzf(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 The rates of Euler angles about z, x, z from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 c4be8033440e1d79b2e56990aa59b3c7ca0a87f9dd9af836af659978d8c1ec64
 */
void chasles_euler_rates_zxz(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double t4 = (t3 == 0.0 ? 0.0 : omega[1] * t1 - omega[0] * t2) / t3;
    const double theta_dot2 = -t4;
    const double theta_dot0 = omega[2] + cos(angles[1]) * t4;
    const double theta_dot1 = omega[0] * t1 + omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zxz in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 c4be8033440e1d79b2e56990aa59b3c7ca0a87f9dd9af836af659978d8c1ec64
 */
void chasles_euler_rates_zxzf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float t4 = (t3 == 0.0f ? 0.0f : omega[1] * t1 - omega[0] * t2) / t3;
    const float theta_dot2 = -t4;
    const float theta_dot0 = omega[2] + cosf(angles[1]) * t4;
    const float theta_dot1 = omega[0] * t1 + omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zxz for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 c4be8033440e1d79b2e56990aa59b3c7ca0a87f9dd9af836af659978d8c1ec64
 */
void chasles_euler_rates_zxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_zxz(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rates_zxzf for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 c4be8033440e1d79b2e56990aa59b3c7ca0a87f9dd9af836af659978d8c1ec64
 */
void chasles_euler_rates_zxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_zxzf(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 The rotation by Euler angles about z, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 581896c72ed36cfaa5f1c03cf7263fbf0550f59682687769a152434e626ec5fd
 */
void chasles_rotation_from_euler_zyx(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double t4 = sin(angles[1]);
    const double Q6 = -t4;
    const double Q0 = t1 * t3;
    const double t5 = t1 * t4;
    const double Q3 = t2 * t3;
    const double t6 = t2 * t4;
    const double t7 = cos(angles[2]);
    const double t8 = sin(angles[2]);
    const double Q1 = t5 * t8 - t2 * t7;
    const double Q2 = t2 * t8 + t5 * t7;
    const double Q4 = t1 * t7 + t6 * t8;
    const double Q5 = t6 * t7 - t1 * t8;
    const double Q7 = t3 * t8;
    const double Q8 = t3 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_zyx in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 581896c72ed36cfaa5f1c03cf7263fbf0550f59682687769a152434e626ec5fd
 */
void chasles_rotation_from_euler_zyxf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float t4 = sinf(angles[1]);
    const float Q6 = -t4;
    const float Q0 = t1 * t3;
    const float t5 = t1 * t4;
    const float Q3 = t2 * t3;
    const float t6 = t2 * t4;
    const float t7 = cosf(angles[2]);
    const float t8 = sinf(angles[2]);
    const float Q1 = t5 * t8 - t2 * t7;
    const float Q2 = t2 * t8 + t5 * t7;
    const float Q4 = t1 * t7 + t6 * t8;
    const float Q5 = t6 * t7 - t1 * t8;
    const float Q7 = t3 * t8;
    const float Q8 = t3 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_zyx for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 581896c72ed36cfaa5f1c03cf7263fbf0550f59682687769a152434e626ec5fd
 */
void chasles_rotation_from_euler_zyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_zyx(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 chasles_rotation_from_euler_zyxf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 581896c72ed36cfaa5f1c03cf7263fbf0550f59682687769a152434e626ec5fd
 */
void chasles_rotation_from_euler_zyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_zyxf(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 66c872236d303d61f6b01e55f2a04707326e08e9a8def9fd2d0718455165a53c
 */
void chasles_euler_rate_matrix_zyx(const double angles[3], double W[9])
{
    const double W4 = cos(angles[0]);
    const double t1 = sin(angles[0]);
    const double W1 = -t1;
    const double t2 = cos(angles[1]);
    const double W8 = -sin(angles[1]);
    const double W2 = W4 * t2;
    const double W5 = t1 * t2;
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0;
    W[7] = 0.0;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zyx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 66c872236d303d61f6b01e55f2a04707326e08e9a8def9fd2d0718455165a53c
 */
void chasles_euler_rate_matrix_zyxf(const float angles[3], float W[9])
{
    const float W4 = cosf(angles[0]);
    const float t1 = sinf(angles[0]);
    const float W1 = -t1;
    const float t2 = cosf(angles[1]);
    const float W8 = -sinf(angles[1]);
    const float W2 = W4 * t2;
    const float W5 = t1 * t2;
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0f;
    W[7] = 0.0f;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zyx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 66c872236d303d61f6b01e55f2a04707326e08e9a8def9fd2d0718455165a53c
 */
void chasles_euler_rate_matrix_zyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_zyx(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zyxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 66c872236d303d61f6b01e55f2a04707326e08e9a8def9fd2d0718455165a53c
 */
void chasles_euler_rate_matrix_zyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_zyxf(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 20343db592ec9160010881086692dd2ae5a3a0bdb2ea91849acb9df55eb2f72a
 */
void chasles_euler_rate_matrix_body_zyx(const double angles[3], double W_body[9])
{
    const double t1 = cos(angles[1]);
    const double W_body0 = -sin(angles[1]);
    const double W_body4 = cos(angles[2]);
    const double t2 = sin(angles[2]);
    const double W_body3 = t1 * t2;
    const double W_body7 = -t2;
    const double W_body6 = t1 * W_body4;
    W_body[0] = W_body0;
    W_body[1] = 0.0;
    W_body[2] = 1.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zyx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 20343db592ec9160010881086692dd2ae5a3a0bdb2ea91849acb9df55eb2f72a
 */
void chasles_euler_rate_matrix_body_zyxf(const float angles[3], float W_body[9])
{
    const float t1 = cosf(angles[1]);
    const float W_body0 = -sinf(angles[1]);
    const float W_body4 = cosf(angles[2]);
    const float t2 = sinf(angles[2]);
    const float W_body3 = t1 * t2;
    const float W_body7 = -t2;
    const float W_body6 = t1 * W_body4;
    W_body[0] = W_body0;
    W_body[1] = 0.0f;
    W_body[2] = 1.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zyx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 20343db592ec9160010881086692dd2ae5a3a0bdb2ea91849acb9df55eb2f72a
 */
void chasles_euler_rate_matrix_body_zyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_zyx(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zyxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 20343db592ec9160010881086692dd2ae5a3a0bdb2ea91849acb9df55eb2f72a
 */
void chasles_euler_rate_matrix_body_zyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_zyxf(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 The rates of Euler angles about z, y, x from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 c12c1c96a5832b81a39cc1699d8110c43abf5ac969574ba9645e1e2ca3e5a587
 */
void chasles_euler_rates_zyx(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[0] * t1 + omega[1] * t2) / t3;
    const double theta_dot0 = omega[2] + sin(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[1] * t1 - omega[0] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zyx in single precision.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 c12c1c96a5832b81a39cc1699d8110c43abf5ac969574ba9645e1e2ca3e5a587
 */
void chasles_euler_rates_zyxf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[0] * t1 + omega[1] * t2) / t3;
    const float theta_dot0 = omega[2] + sinf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[1] * t1 - omega[0] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zyx for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 c12c1c96a5832b81a39cc1699d8110c43abf5ac969574ba9645e1e2ca3e5a587
 */
void chasles_euler_rates_zyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_zyx(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rates_zyxf for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 c12c1c96a5832b81a39cc1699d8110c43abf5ac969574ba9645e1e2ca3e5a587
 */
void chasles_euler_rates_zyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_zyxf(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 The rotation by Euler angles about z, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 4025aa2b857829dd40030f976438d7ef055e83c86995d4d37382381b152c2f5a
 */
void chasles_rotation_from_euler_zyz(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double Q8 = cos(angles[1]);
    const double t3 = sin(angles[1]);
    const double t4 = t1 * Q8;
    const double Q2 = t1 * t3;
    const double t5 = t2 * Q8;
    const double Q5 = t2 * t3;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q0 = t4 * t6 - t2 * t7;
    const double Q1 = -(t4 * t7 + t2 * t6);
    const double Q3 = t5 * t6 + t1 * t7;
    const double Q4 = t1 * t6 - t5 * t7;
    const double Q6 = -(t3 * t6);
    const double Q7 = t3 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_zyz in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 4025aa2b857829dd40030f976438d7ef055e83c86995d4d37382381b152c2f5a
 */
void chasles_rotation_from_euler_zyzf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float Q8 = cosf(angles[1]);
    const float t3 = sinf(angles[1]);
    const float t4 = t1 * Q8;
    const float Q2 = t1 * t3;
    const float t5 = t2 * Q8;
    const float Q5 = t2 * t3;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q0 = t4 * t6 - t2 * t7;
    const float Q1 = -(t4 * t7 + t2 * t6);
    const float Q3 = t5 * t6 + t1 * t7;
    const float Q4 = t1 * t6 - t5 * t7;
    const float Q6 = -(t3 * t6);
    const float Q7 = t3 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_zyz for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 4025aa2b857829dd40030f976438d7ef055e83c86995d4d37382381b152c2f5a
 */
void chasles_rotation_from_euler_zyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_zyz(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 chasles_rotation_from_euler_zyzf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 4025aa2b857829dd40030f976438d7ef055e83c86995d4d37382381b152c2f5a
 */
void chasles_rotation_from_euler_zyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_rotation_from_euler_zyzf(angles + i * angles_step, Q + i * Q_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 b218cf9859c431d040eb202055f9cd230dc8e311ad82193e0c9a3f33d5febbe0
 */
void chasles_euler_rate_matrix_zyz(const double angles[3], double W[9])
{
    const double W4 = cos(angles[0]);
    const double t1 = sin(angles[0]);
    const double W1 = -t1;
    const double W8 = cos(angles[1]);
    const double t2 = sin(angles[1]);
    const double W2 = W4 * t2;
    const double W5 = t1 * t2;
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0;
    W[7] = 0.0;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zyz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 b218cf9859c431d040eb202055f9cd230dc8e311ad82193e0c9a3f33d5febbe0
 */
void chasles_euler_rate_matrix_zyzf(const float angles[3], float W[9])
{
    const float W4 = cosf(angles[0]);
    const float t1 = sinf(angles[0]);
    const float W1 = -t1;
    const float W8 = cosf(angles[1]);
    const float t2 = sinf(angles[1]);
    const float W2 = W4 * t2;
    const float W5 = t1 * t2;
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0f;
    W[7] = 0.0f;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zyz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 b218cf9859c431d040eb202055f9cd230dc8e311ad82193e0c9a3f33d5febbe0
 */
void chasles_euler_rate_matrix_zyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_zyz(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zyzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 b218cf9859c431d040eb202055f9cd230dc8e311ad82193e0c9a3f33d5febbe0
 */
void chasles_euler_rate_matrix_zyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_zyzf(angles + i * angles_step, W + i * W_step);
    }
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 338c4bd63de50eb34cdf85a54bb6ae6f4979fcbfa6b866131be19ad92fe74878
 */
void chasles_euler_rate_matrix_body_zyz(const double angles[3], double W_body[9])
{
    const double W_body6 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W_body4 = cos(angles[2]);
    const double W_body0 = -(t1 * W_body4);
    const double W_body1 = sin(angles[2]);
    const double W_body3 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = 0.0;
    W_body[8] = 1.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zyz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 338c4bd63de50eb34cdf85a54bb6ae6f4979fcbfa6b866131be19ad92fe74878
 */
void chasles_euler_rate_matrix_body_zyzf(const float angles[3], float W_body[9])
{
    const float W_body6 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W_body4 = cosf(angles[2]);
    const float W_body0 = -(t1 * W_body4);
    const float W_body1 = sinf(angles[2]);
    const float W_body3 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = 0.0f;
    W_body[8] = 1.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zyz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 338c4bd63de50eb34cdf85a54bb6ae6f4979fcbfa6b866131be19ad92fe74878
 */
void chasles_euler_rate_matrix_body_zyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_zyz(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zyzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 338c4bd63de50eb34cdf85a54bb6ae6f4979fcbfa6b866131be19ad92fe74878
 */
void chasles_euler_rate_matrix_body_zyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rate_matrix_body_zyzf(angles + i * angles_step, W_body + i * W_body_step);
    }
}

/*
 * Ex 3.10 The rates of Euler angles about z, y, z from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 a96c14a018c279b26006e373745953f8ade90795be64fb33b11d0b9c13278361
 */
void chasles_euler_rates_zyz(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[0] * t1 + omega[1] * t2) / t3;
    const double theta_dot0 = omega[2] - cos(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[1] * t1 - omega[0] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zyz in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 a96c14a018c279b26006e373745953f8ade90795be64fb33b11d0b9c13278361
 */
void chasles_euler_rates_zyzf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[0] * t1 + omega[1] * t2) / t3;
    const float theta_dot0 = omega[2] - cosf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[1] * t1 - omega[0] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zyz for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 a96c14a018c279b26006e373745953f8ade90795be64fb33b11d0b9c13278361
 */
void chasles_euler_rates_zyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_zyz(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}

/*
 * Ex 3.10 chasles_euler_rates_zyzf for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 a96c14a018c279b26006e373745953f8ade90795be64fb33b11d0b9c13278361
 */
void chasles_euler_rates_zyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_euler_rates_zyzf(
            angles + i * angles_step,
            omega + i * omega_step,
            theta_dot + i * theta_dot_step);
    }
}
