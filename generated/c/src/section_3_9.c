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
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 e453c9ec715829e85f9601a1d0ec08462b05bd7dcf4ff68c0d823046a49f7b25
 */
void chasles_euler_rates_xyx(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[1] * t2 - omega[2] * t1) / t3;
    const double theta_dot0 = omega[0] - cos(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[1] * t1 + omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xyx in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 e453c9ec715829e85f9601a1d0ec08462b05bd7dcf4ff68c0d823046a49f7b25
 */
void chasles_euler_rates_xyxf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[1] * t2 - omega[2] * t1) / t3;
    const float theta_dot0 = omega[0] - cosf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[1] * t1 + omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xyx for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 e453c9ec715829e85f9601a1d0ec08462b05bd7dcf4ff68c0d823046a49f7b25
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
 *   13 operations; derivation sha256 e453c9ec715829e85f9601a1d0ec08462b05bd7dcf4ff68c0d823046a49f7b25
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
 *   derivation  sha256 6705bbdc3cc819470adf698e905e15041cab2c79ee214c77c73b890ac65f41ce
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
 *   24 operations; derivation sha256 6705bbdc3cc819470adf698e905e15041cab2c79ee214c77c73b890ac65f41ce
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
 *   24 operations; derivation sha256 6705bbdc3cc819470adf698e905e15041cab2c79ee214c77c73b890ac65f41ce
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
 *   24 operations; derivation sha256 6705bbdc3cc819470adf698e905e15041cab2c79ee214c77c73b890ac65f41ce
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
 *   derivation  sha256 8b9592b89e483d6287bed3bb4d0027fafb382171a6999dd56d09507bbf0d590c
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
 *   6 operations; derivation sha256 8b9592b89e483d6287bed3bb4d0027fafb382171a6999dd56d09507bbf0d590c
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
 *   6 operations; derivation sha256 8b9592b89e483d6287bed3bb4d0027fafb382171a6999dd56d09507bbf0d590c
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
 *   6 operations; derivation sha256 8b9592b89e483d6287bed3bb4d0027fafb382171a6999dd56d09507bbf0d590c
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
 *   derivation  sha256 6edfea23479e92ef7d1e7e7d68bcd13ee371f2991c16353952f09f3c9d81ed3c
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
 *   6 operations; derivation sha256 6edfea23479e92ef7d1e7e7d68bcd13ee371f2991c16353952f09f3c9d81ed3c
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
 *   6 operations; derivation sha256 6edfea23479e92ef7d1e7e7d68bcd13ee371f2991c16353952f09f3c9d81ed3c
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
 *   6 operations; derivation sha256 6edfea23479e92ef7d1e7e7d68bcd13ee371f2991c16353952f09f3c9d81ed3c
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
 *   derivation  sha256 bec42ab40a38f203a48f4e170dc0ad4fb0cb1c57041bf8abc87e9c159e906d1b
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
 *   13 operations; derivation sha256 bec42ab40a38f203a48f4e170dc0ad4fb0cb1c57041bf8abc87e9c159e906d1b
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
 *   13 operations; derivation sha256 bec42ab40a38f203a48f4e170dc0ad4fb0cb1c57041bf8abc87e9c159e906d1b
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
 *   13 operations; derivation sha256 bec42ab40a38f203a48f4e170dc0ad4fb0cb1c57041bf8abc87e9c159e906d1b
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
 *   derivation  sha256 de3a851daae76ca498f976ed679390610caf046ca454d49669dab454cd2104d1
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
 *   24 operations; derivation sha256 de3a851daae76ca498f976ed679390610caf046ca454d49669dab454cd2104d1
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
 *   24 operations; derivation sha256 de3a851daae76ca498f976ed679390610caf046ca454d49669dab454cd2104d1
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
 *   24 operations; derivation sha256 de3a851daae76ca498f976ed679390610caf046ca454d49669dab454cd2104d1
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
 *   derivation  sha256 545b1f6b179f88fad10dbd0fac8687f59350380469f6ca96bc437c08d8649800
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
 *   6 operations; derivation sha256 545b1f6b179f88fad10dbd0fac8687f59350380469f6ca96bc437c08d8649800
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
 *   6 operations; derivation sha256 545b1f6b179f88fad10dbd0fac8687f59350380469f6ca96bc437c08d8649800
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
 *   6 operations; derivation sha256 545b1f6b179f88fad10dbd0fac8687f59350380469f6ca96bc437c08d8649800
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
 *   derivation  sha256 4421d8d529350d6e5a4683c66c54675834e8b21d5b6680f974942482d20d7faa
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
 *   6 operations; derivation sha256 4421d8d529350d6e5a4683c66c54675834e8b21d5b6680f974942482d20d7faa
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
 *   6 operations; derivation sha256 4421d8d529350d6e5a4683c66c54675834e8b21d5b6680f974942482d20d7faa
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
 *   6 operations; derivation sha256 4421d8d529350d6e5a4683c66c54675834e8b21d5b6680f974942482d20d7faa
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
 *   derivation  sha256 0ccb549820c0ab21158582ccb0f8286408599eb24bab35fd4a60461f59ffafd6
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
 *   13 operations; derivation sha256 0ccb549820c0ab21158582ccb0f8286408599eb24bab35fd4a60461f59ffafd6
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
 *   13 operations; derivation sha256 0ccb549820c0ab21158582ccb0f8286408599eb24bab35fd4a60461f59ffafd6
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
 *   13 operations; derivation sha256 0ccb549820c0ab21158582ccb0f8286408599eb24bab35fd4a60461f59ffafd6
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
 *   derivation  sha256 528f8a3eb6e52746d86a5138d675ae8293cc6c7de4f1c00ba3c4b692ba51c455
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
 *   24 operations; derivation sha256 528f8a3eb6e52746d86a5138d675ae8293cc6c7de4f1c00ba3c4b692ba51c455
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
 *   24 operations; derivation sha256 528f8a3eb6e52746d86a5138d675ae8293cc6c7de4f1c00ba3c4b692ba51c455
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
 *   24 operations; derivation sha256 528f8a3eb6e52746d86a5138d675ae8293cc6c7de4f1c00ba3c4b692ba51c455
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
 *   derivation  sha256 4ccd841cb0d6e568bdae1a01686f08fa60121be46d720f48317ac76ca58343f3
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
 *   6 operations; derivation sha256 4ccd841cb0d6e568bdae1a01686f08fa60121be46d720f48317ac76ca58343f3
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
 *   6 operations; derivation sha256 4ccd841cb0d6e568bdae1a01686f08fa60121be46d720f48317ac76ca58343f3
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
 *   6 operations; derivation sha256 4ccd841cb0d6e568bdae1a01686f08fa60121be46d720f48317ac76ca58343f3
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
 *   derivation  sha256 140a985ea02031261c7a92a5cae173ebafe88054961990673ef5a69b4c1c784c
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
 *   6 operations; derivation sha256 140a985ea02031261c7a92a5cae173ebafe88054961990673ef5a69b4c1c784c
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
 *   6 operations; derivation sha256 140a985ea02031261c7a92a5cae173ebafe88054961990673ef5a69b4c1c784c
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
 *   6 operations; derivation sha256 140a985ea02031261c7a92a5cae173ebafe88054961990673ef5a69b4c1c784c
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
 *   derivation  sha256 087e3bef0a80b53adecd8dbfc1ca485d856b9ab12bf0597224ad01bffe84d48d
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
 *   13 operations; derivation sha256 087e3bef0a80b53adecd8dbfc1ca485d856b9ab12bf0597224ad01bffe84d48d
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
 *   13 operations; derivation sha256 087e3bef0a80b53adecd8dbfc1ca485d856b9ab12bf0597224ad01bffe84d48d
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
 *   13 operations; derivation sha256 087e3bef0a80b53adecd8dbfc1ca485d856b9ab12bf0597224ad01bffe84d48d
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
 *   derivation  sha256 4639340b4c5a19e5e71818440a5e25a7dc695042caa389d57e5938578f329204
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
 *   24 operations; derivation sha256 4639340b4c5a19e5e71818440a5e25a7dc695042caa389d57e5938578f329204
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
 *   24 operations; derivation sha256 4639340b4c5a19e5e71818440a5e25a7dc695042caa389d57e5938578f329204
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
 *   24 operations; derivation sha256 4639340b4c5a19e5e71818440a5e25a7dc695042caa389d57e5938578f329204
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
 *   derivation  sha256 4cbc84e4cff896b34c5c2f02307a9c69b503d7a3a6aa2154b90b95c513c1bbce
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
 *   6 operations; derivation sha256 4cbc84e4cff896b34c5c2f02307a9c69b503d7a3a6aa2154b90b95c513c1bbce
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
 *   6 operations; derivation sha256 4cbc84e4cff896b34c5c2f02307a9c69b503d7a3a6aa2154b90b95c513c1bbce
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
 *   6 operations; derivation sha256 4cbc84e4cff896b34c5c2f02307a9c69b503d7a3a6aa2154b90b95c513c1bbce
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
 *   derivation  sha256 a91079d1f94bff7ab0a579982ea7cd90304a0348ae48792ba5271dddfcbf7035
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
 *   6 operations; derivation sha256 a91079d1f94bff7ab0a579982ea7cd90304a0348ae48792ba5271dddfcbf7035
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
 *   6 operations; derivation sha256 a91079d1f94bff7ab0a579982ea7cd90304a0348ae48792ba5271dddfcbf7035
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
 *   6 operations; derivation sha256 a91079d1f94bff7ab0a579982ea7cd90304a0348ae48792ba5271dddfcbf7035
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
 *   derivation  sha256 57f9fa9a9312c200080117d0f7819b233fa81817547398adafd4ca1378e12c37
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
 *   13 operations; derivation sha256 57f9fa9a9312c200080117d0f7819b233fa81817547398adafd4ca1378e12c37
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
 *   13 operations; derivation sha256 57f9fa9a9312c200080117d0f7819b233fa81817547398adafd4ca1378e12c37
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
 *   13 operations; derivation sha256 57f9fa9a9312c200080117d0f7819b233fa81817547398adafd4ca1378e12c37
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
 *   derivation  sha256 7826edee42401859a8ff2260131eccd87584d6b7fc0ad058baafa9ef41dddf6d
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
 *   24 operations; derivation sha256 7826edee42401859a8ff2260131eccd87584d6b7fc0ad058baafa9ef41dddf6d
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
 *   24 operations; derivation sha256 7826edee42401859a8ff2260131eccd87584d6b7fc0ad058baafa9ef41dddf6d
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
 *   24 operations; derivation sha256 7826edee42401859a8ff2260131eccd87584d6b7fc0ad058baafa9ef41dddf6d
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
 *   derivation  sha256 07480db4ffa6cc7d6437a7e2665ee04918a7abb314a91e8b1902406359365ea3
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
 *   6 operations; derivation sha256 07480db4ffa6cc7d6437a7e2665ee04918a7abb314a91e8b1902406359365ea3
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
 *   6 operations; derivation sha256 07480db4ffa6cc7d6437a7e2665ee04918a7abb314a91e8b1902406359365ea3
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
 *   6 operations; derivation sha256 07480db4ffa6cc7d6437a7e2665ee04918a7abb314a91e8b1902406359365ea3
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
 *   derivation  sha256 8fcfcba93190fa9fe68f95cec90b57f0b7c5ef19ebaeb913da577bffd1d751aa
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
 *   6 operations; derivation sha256 8fcfcba93190fa9fe68f95cec90b57f0b7c5ef19ebaeb913da577bffd1d751aa
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
 *   6 operations; derivation sha256 8fcfcba93190fa9fe68f95cec90b57f0b7c5ef19ebaeb913da577bffd1d751aa
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
 *   6 operations; derivation sha256 8fcfcba93190fa9fe68f95cec90b57f0b7c5ef19ebaeb913da577bffd1d751aa
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
 *   derivation  sha256 2212d1def76d12a0d532fa8d15c98f725dc91b310425411666552c46e23e6bcc
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
 *   13 operations; derivation sha256 2212d1def76d12a0d532fa8d15c98f725dc91b310425411666552c46e23e6bcc
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
 *   13 operations; derivation sha256 2212d1def76d12a0d532fa8d15c98f725dc91b310425411666552c46e23e6bcc
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
 *   13 operations; derivation sha256 2212d1def76d12a0d532fa8d15c98f725dc91b310425411666552c46e23e6bcc
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
 *   derivation  sha256 ef5522efe35a5dbb6eb545a7113286a6df3ac2d9603f138c97acd6f4fc1ccdc9
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
 *   24 operations; derivation sha256 ef5522efe35a5dbb6eb545a7113286a6df3ac2d9603f138c97acd6f4fc1ccdc9
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
 *   24 operations; derivation sha256 ef5522efe35a5dbb6eb545a7113286a6df3ac2d9603f138c97acd6f4fc1ccdc9
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
 *   24 operations; derivation sha256 ef5522efe35a5dbb6eb545a7113286a6df3ac2d9603f138c97acd6f4fc1ccdc9
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
 *   derivation  sha256 f21a6f4f704b91ac82727b870a55688276de0a91bfef95348ddb665cf0053bbe
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
 *   6 operations; derivation sha256 f21a6f4f704b91ac82727b870a55688276de0a91bfef95348ddb665cf0053bbe
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
 *   6 operations; derivation sha256 f21a6f4f704b91ac82727b870a55688276de0a91bfef95348ddb665cf0053bbe
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
 *   6 operations; derivation sha256 f21a6f4f704b91ac82727b870a55688276de0a91bfef95348ddb665cf0053bbe
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
 *   derivation  sha256 8002c5ad3e9637706ec1f0995aff426cd6d3c93bbb9c6b05f736a8f04dc13a53
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
 *   6 operations; derivation sha256 8002c5ad3e9637706ec1f0995aff426cd6d3c93bbb9c6b05f736a8f04dc13a53
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
 *   6 operations; derivation sha256 8002c5ad3e9637706ec1f0995aff426cd6d3c93bbb9c6b05f736a8f04dc13a53
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
 *   6 operations; derivation sha256 8002c5ad3e9637706ec1f0995aff426cd6d3c93bbb9c6b05f736a8f04dc13a53
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
 *   derivation  sha256 d1003d9548b999def53c21a3d1f187a414f4fc0f945b05b72a7c6fbfb5c7a47d
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
 *   13 operations; derivation sha256 d1003d9548b999def53c21a3d1f187a414f4fc0f945b05b72a7c6fbfb5c7a47d
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
 *   13 operations; derivation sha256 d1003d9548b999def53c21a3d1f187a414f4fc0f945b05b72a7c6fbfb5c7a47d
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
 *   13 operations; derivation sha256 d1003d9548b999def53c21a3d1f187a414f4fc0f945b05b72a7c6fbfb5c7a47d
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
 *   derivation  sha256 9b151d27de4ffca05409badf5b12a98224dd3d563317e41d406695d5ac82d8fe
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
 *   24 operations; derivation sha256 9b151d27de4ffca05409badf5b12a98224dd3d563317e41d406695d5ac82d8fe
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
 *   24 operations; derivation sha256 9b151d27de4ffca05409badf5b12a98224dd3d563317e41d406695d5ac82d8fe
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
 *   24 operations; derivation sha256 9b151d27de4ffca05409badf5b12a98224dd3d563317e41d406695d5ac82d8fe
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
 *   derivation  sha256 2f9bfcf1cf1510c9d532f8993939787ce7f9c20c82877a4ff2da46a70393d647
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
 *   6 operations; derivation sha256 2f9bfcf1cf1510c9d532f8993939787ce7f9c20c82877a4ff2da46a70393d647
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
 *   6 operations; derivation sha256 2f9bfcf1cf1510c9d532f8993939787ce7f9c20c82877a4ff2da46a70393d647
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
 *   6 operations; derivation sha256 2f9bfcf1cf1510c9d532f8993939787ce7f9c20c82877a4ff2da46a70393d647
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
 *   derivation  sha256 5762f9bb88e3585fbcf0a24320f2bff2cde801a395480e2e0590be6aaf815133
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
 *   6 operations; derivation sha256 5762f9bb88e3585fbcf0a24320f2bff2cde801a395480e2e0590be6aaf815133
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
 *   6 operations; derivation sha256 5762f9bb88e3585fbcf0a24320f2bff2cde801a395480e2e0590be6aaf815133
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
 *   6 operations; derivation sha256 5762f9bb88e3585fbcf0a24320f2bff2cde801a395480e2e0590be6aaf815133
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
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 b6355f58c7c3fa95bc6d061430c73cc2a10d5ac79a707165aff3d890f9581dba
 */
void chasles_euler_rates_yzy(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[2] * t2 - omega[0] * t1) / t3;
    const double theta_dot0 = omega[1] - cos(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[0] * t2 + omega[2] * t1;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yzy in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 b6355f58c7c3fa95bc6d061430c73cc2a10d5ac79a707165aff3d890f9581dba
 */
void chasles_euler_rates_yzyf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[2] * t2 - omega[0] * t1) / t3;
    const float theta_dot0 = omega[1] - cosf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[0] * t2 + omega[2] * t1;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yzy for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 b6355f58c7c3fa95bc6d061430c73cc2a10d5ac79a707165aff3d890f9581dba
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
 *   13 operations; derivation sha256 b6355f58c7c3fa95bc6d061430c73cc2a10d5ac79a707165aff3d890f9581dba
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
 *   derivation  sha256 b9f5bd8cb933973ed7cbd4c1597c7beb8def73e0322a6320eafff859e529e1b7
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
 *   24 operations; derivation sha256 b9f5bd8cb933973ed7cbd4c1597c7beb8def73e0322a6320eafff859e529e1b7
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
 *   24 operations; derivation sha256 b9f5bd8cb933973ed7cbd4c1597c7beb8def73e0322a6320eafff859e529e1b7
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
 *   24 operations; derivation sha256 b9f5bd8cb933973ed7cbd4c1597c7beb8def73e0322a6320eafff859e529e1b7
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
 *   derivation  sha256 df727c18be22cfac4c3a09b0f1e97010c957f2a06bb7dac8fad89bc630cdfc72
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
 *   6 operations; derivation sha256 df727c18be22cfac4c3a09b0f1e97010c957f2a06bb7dac8fad89bc630cdfc72
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
 *   6 operations; derivation sha256 df727c18be22cfac4c3a09b0f1e97010c957f2a06bb7dac8fad89bc630cdfc72
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
 *   6 operations; derivation sha256 df727c18be22cfac4c3a09b0f1e97010c957f2a06bb7dac8fad89bc630cdfc72
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
 *   derivation  sha256 f450ca1b0eb3ccc517bdc3221e8a1e2c9cc8e3d8de87bd14b8f038e09efa7cd4
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
 *   6 operations; derivation sha256 f450ca1b0eb3ccc517bdc3221e8a1e2c9cc8e3d8de87bd14b8f038e09efa7cd4
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
 *   6 operations; derivation sha256 f450ca1b0eb3ccc517bdc3221e8a1e2c9cc8e3d8de87bd14b8f038e09efa7cd4
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
 *   6 operations; derivation sha256 f450ca1b0eb3ccc517bdc3221e8a1e2c9cc8e3d8de87bd14b8f038e09efa7cd4
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
 *   derivation  sha256 b6247cfe1605afb09834132d0089f65feb63196135176c18e66aaecefde6ff2d
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
 *   13 operations; derivation sha256 b6247cfe1605afb09834132d0089f65feb63196135176c18e66aaecefde6ff2d
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
 *   13 operations; derivation sha256 b6247cfe1605afb09834132d0089f65feb63196135176c18e66aaecefde6ff2d
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
 *   13 operations; derivation sha256 b6247cfe1605afb09834132d0089f65feb63196135176c18e66aaecefde6ff2d
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
 *   derivation  sha256 ec42254a14e2150cfdfa3e489c58c9f29abfb1adb674fbfc9db9de4062ab509b
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
 *   24 operations; derivation sha256 ec42254a14e2150cfdfa3e489c58c9f29abfb1adb674fbfc9db9de4062ab509b
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
 *   24 operations; derivation sha256 ec42254a14e2150cfdfa3e489c58c9f29abfb1adb674fbfc9db9de4062ab509b
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
 *   24 operations; derivation sha256 ec42254a14e2150cfdfa3e489c58c9f29abfb1adb674fbfc9db9de4062ab509b
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
 *   derivation  sha256 596864b48f2083e275fa86c7bd645c22321a7dca6c8a229e42796d251888e8f2
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
 *   6 operations; derivation sha256 596864b48f2083e275fa86c7bd645c22321a7dca6c8a229e42796d251888e8f2
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
 *   6 operations; derivation sha256 596864b48f2083e275fa86c7bd645c22321a7dca6c8a229e42796d251888e8f2
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
 *   6 operations; derivation sha256 596864b48f2083e275fa86c7bd645c22321a7dca6c8a229e42796d251888e8f2
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
 *   derivation  sha256 d69ea9f6ef6685b83332ef5a90dbdd6051040c10577814f685fcfbda54e5aeaf
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
 *   6 operations; derivation sha256 d69ea9f6ef6685b83332ef5a90dbdd6051040c10577814f685fcfbda54e5aeaf
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
 *   6 operations; derivation sha256 d69ea9f6ef6685b83332ef5a90dbdd6051040c10577814f685fcfbda54e5aeaf
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
 *   6 operations; derivation sha256 d69ea9f6ef6685b83332ef5a90dbdd6051040c10577814f685fcfbda54e5aeaf
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
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 69c02425a879b8837aea25c6a1189c081b2a0c50eda10e5718e89bbd6988fd02
 */
void chasles_euler_rates_zxz(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[0] * t2 - omega[1] * t1) / t3;
    const double theta_dot0 = omega[2] - cos(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[0] * t1 + omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zxz in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 69c02425a879b8837aea25c6a1189c081b2a0c50eda10e5718e89bbd6988fd02
 */
void chasles_euler_rates_zxzf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[0] * t2 - omega[1] * t1) / t3;
    const float theta_dot0 = omega[2] - cosf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[0] * t1 + omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zxz for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 69c02425a879b8837aea25c6a1189c081b2a0c50eda10e5718e89bbd6988fd02
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
 *   13 operations; derivation sha256 69c02425a879b8837aea25c6a1189c081b2a0c50eda10e5718e89bbd6988fd02
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
 *   derivation  sha256 600331d1bf931f72e5c669d33f112d1205b8fe035f57e62c807299776dba5386
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
 *   24 operations; derivation sha256 600331d1bf931f72e5c669d33f112d1205b8fe035f57e62c807299776dba5386
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
 *   24 operations; derivation sha256 600331d1bf931f72e5c669d33f112d1205b8fe035f57e62c807299776dba5386
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
 *   24 operations; derivation sha256 600331d1bf931f72e5c669d33f112d1205b8fe035f57e62c807299776dba5386
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
 *   derivation  sha256 801dcac4871c313d8f88d5611a62e3fdfff1565d6bb1568273ad0ea2a965d1e5
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
 *   6 operations; derivation sha256 801dcac4871c313d8f88d5611a62e3fdfff1565d6bb1568273ad0ea2a965d1e5
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
 *   6 operations; derivation sha256 801dcac4871c313d8f88d5611a62e3fdfff1565d6bb1568273ad0ea2a965d1e5
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
 *   6 operations; derivation sha256 801dcac4871c313d8f88d5611a62e3fdfff1565d6bb1568273ad0ea2a965d1e5
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
 *   derivation  sha256 d820b0c990936bb7c922ad28e0b083d260059e6b0d74c52dcd91087315dfc602
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
 *   6 operations; derivation sha256 d820b0c990936bb7c922ad28e0b083d260059e6b0d74c52dcd91087315dfc602
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
 *   6 operations; derivation sha256 d820b0c990936bb7c922ad28e0b083d260059e6b0d74c52dcd91087315dfc602
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
 *   6 operations; derivation sha256 d820b0c990936bb7c922ad28e0b083d260059e6b0d74c52dcd91087315dfc602
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
 *   derivation  sha256 621952a0c32884add034832a91f740d3acb5c4d2939cdeff3c489ff41833c3c9
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
 *   13 operations; derivation sha256 621952a0c32884add034832a91f740d3acb5c4d2939cdeff3c489ff41833c3c9
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
 *   13 operations; derivation sha256 621952a0c32884add034832a91f740d3acb5c4d2939cdeff3c489ff41833c3c9
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
 *   13 operations; derivation sha256 621952a0c32884add034832a91f740d3acb5c4d2939cdeff3c489ff41833c3c9
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
 *   derivation  sha256 20ec1abc97e092ce5bad87ed0387a034bad0867c0b77b86a3b952f003423a08c
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
 *   24 operations; derivation sha256 20ec1abc97e092ce5bad87ed0387a034bad0867c0b77b86a3b952f003423a08c
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
 *   24 operations; derivation sha256 20ec1abc97e092ce5bad87ed0387a034bad0867c0b77b86a3b952f003423a08c
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
 *   24 operations; derivation sha256 20ec1abc97e092ce5bad87ed0387a034bad0867c0b77b86a3b952f003423a08c
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
 *   derivation  sha256 f418037614354fc95575c5aec827f9f49fc347c491c4170e0c6ec842a5a94a3b
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
 *   6 operations; derivation sha256 f418037614354fc95575c5aec827f9f49fc347c491c4170e0c6ec842a5a94a3b
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
 *   6 operations; derivation sha256 f418037614354fc95575c5aec827f9f49fc347c491c4170e0c6ec842a5a94a3b
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
 *   6 operations; derivation sha256 f418037614354fc95575c5aec827f9f49fc347c491c4170e0c6ec842a5a94a3b
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
 *   derivation  sha256 3ef03099d7065afdf2c43a90443a389d8fd659ce4ef8f0db395cc2d6f5b9a4cf
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
 *   6 operations; derivation sha256 3ef03099d7065afdf2c43a90443a389d8fd659ce4ef8f0db395cc2d6f5b9a4cf
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
 *   6 operations; derivation sha256 3ef03099d7065afdf2c43a90443a389d8fd659ce4ef8f0db395cc2d6f5b9a4cf
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
 *   6 operations; derivation sha256 3ef03099d7065afdf2c43a90443a389d8fd659ce4ef8f0db395cc2d6f5b9a4cf
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
 *   derivation  sha256 b611c82c8754e1d16d209c861db78e54b286288315a5f5818e43a985e2b73890
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
 *   13 operations; derivation sha256 b611c82c8754e1d16d209c861db78e54b286288315a5f5818e43a985e2b73890
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
 *   13 operations; derivation sha256 b611c82c8754e1d16d209c861db78e54b286288315a5f5818e43a985e2b73890
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
 *   13 operations; derivation sha256 b611c82c8754e1d16d209c861db78e54b286288315a5f5818e43a985e2b73890
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
