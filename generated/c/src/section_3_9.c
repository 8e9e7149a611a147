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
 *   derivation  sha256 dc25d3c29d228eb0e4db2e7284ae285688a98dad73a9ce5754ebbde12caab3d1
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
 *   13 operations; derivation sha256 dc25d3c29d228eb0e4db2e7284ae285688a98dad73a9ce5754ebbde12caab3d1
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
 *   13 operations; derivation sha256 dc25d3c29d228eb0e4db2e7284ae285688a98dad73a9ce5754ebbde12caab3d1
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
 *   13 operations; derivation sha256 dc25d3c29d228eb0e4db2e7284ae285688a98dad73a9ce5754ebbde12caab3d1
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
 *   derivation  sha256 ef78e8d8a2f64f490cf253a137d167a50f5c2baac61b871bbb0421b691514a33
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
 *   24 operations; derivation sha256 ef78e8d8a2f64f490cf253a137d167a50f5c2baac61b871bbb0421b691514a33
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
 *   24 operations; derivation sha256 ef78e8d8a2f64f490cf253a137d167a50f5c2baac61b871bbb0421b691514a33
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
 *   24 operations; derivation sha256 ef78e8d8a2f64f490cf253a137d167a50f5c2baac61b871bbb0421b691514a33
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
 *   derivation  sha256 0bbaee6346a1733edd0665efc3803dd79b070ecde8be0f041579ee6f7f25437e
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
 *   6 operations; derivation sha256 0bbaee6346a1733edd0665efc3803dd79b070ecde8be0f041579ee6f7f25437e
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
 *   6 operations; derivation sha256 0bbaee6346a1733edd0665efc3803dd79b070ecde8be0f041579ee6f7f25437e
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
 *   6 operations; derivation sha256 0bbaee6346a1733edd0665efc3803dd79b070ecde8be0f041579ee6f7f25437e
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
 *   derivation  sha256 1bf5c28d32a8398be51df3a9faea455bcb2b84dd8e4adb28b9ab9ce5a849afeb
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
 *   6 operations; derivation sha256 1bf5c28d32a8398be51df3a9faea455bcb2b84dd8e4adb28b9ab9ce5a849afeb
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
 *   6 operations; derivation sha256 1bf5c28d32a8398be51df3a9faea455bcb2b84dd8e4adb28b9ab9ce5a849afeb
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
 *   6 operations; derivation sha256 1bf5c28d32a8398be51df3a9faea455bcb2b84dd8e4adb28b9ab9ce5a849afeb
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
 *   derivation  sha256 92ffca814bf55194dbaab2789d526410119beac1331e329cc2a7d3a8d86f3e7e
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
 *   13 operations; derivation sha256 92ffca814bf55194dbaab2789d526410119beac1331e329cc2a7d3a8d86f3e7e
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
 *   13 operations; derivation sha256 92ffca814bf55194dbaab2789d526410119beac1331e329cc2a7d3a8d86f3e7e
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
 *   13 operations; derivation sha256 92ffca814bf55194dbaab2789d526410119beac1331e329cc2a7d3a8d86f3e7e
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
 *   derivation  sha256 d87af31d8064f0432f6584f5f3b779ac157cd7cb2fd428e403c2606c591e6ab0
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
 *   24 operations; derivation sha256 d87af31d8064f0432f6584f5f3b779ac157cd7cb2fd428e403c2606c591e6ab0
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
 *   24 operations; derivation sha256 d87af31d8064f0432f6584f5f3b779ac157cd7cb2fd428e403c2606c591e6ab0
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
 *   24 operations; derivation sha256 d87af31d8064f0432f6584f5f3b779ac157cd7cb2fd428e403c2606c591e6ab0
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
 *   derivation  sha256 3b9b8235e4c8fcf384c7c55c8d008191b5ba7256d0172eff576a02612b7b5275
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
 *   6 operations; derivation sha256 3b9b8235e4c8fcf384c7c55c8d008191b5ba7256d0172eff576a02612b7b5275
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
 *   6 operations; derivation sha256 3b9b8235e4c8fcf384c7c55c8d008191b5ba7256d0172eff576a02612b7b5275
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
 *   6 operations; derivation sha256 3b9b8235e4c8fcf384c7c55c8d008191b5ba7256d0172eff576a02612b7b5275
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
 *   derivation  sha256 3ae39b45394bce41b7344b42020cefcaf35408de091e740348ab7e92581fd171
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
 *   6 operations; derivation sha256 3ae39b45394bce41b7344b42020cefcaf35408de091e740348ab7e92581fd171
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
 *   6 operations; derivation sha256 3ae39b45394bce41b7344b42020cefcaf35408de091e740348ab7e92581fd171
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
 *   6 operations; derivation sha256 3ae39b45394bce41b7344b42020cefcaf35408de091e740348ab7e92581fd171
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
 *   derivation  sha256 f0c9c8006ed755a58d3a5e3453882b764155b478f3ccc81aff9263fcd693130b
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
 *   13 operations; derivation sha256 f0c9c8006ed755a58d3a5e3453882b764155b478f3ccc81aff9263fcd693130b
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
 *   13 operations; derivation sha256 f0c9c8006ed755a58d3a5e3453882b764155b478f3ccc81aff9263fcd693130b
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
 *   13 operations; derivation sha256 f0c9c8006ed755a58d3a5e3453882b764155b478f3ccc81aff9263fcd693130b
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
 *   derivation  sha256 8ed8b54e3664bc9230db9b3c2c73b559c4c5aa0d545a0bbcd5503654d557cc47
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
 *   24 operations; derivation sha256 8ed8b54e3664bc9230db9b3c2c73b559c4c5aa0d545a0bbcd5503654d557cc47
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
 *   24 operations; derivation sha256 8ed8b54e3664bc9230db9b3c2c73b559c4c5aa0d545a0bbcd5503654d557cc47
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
 *   24 operations; derivation sha256 8ed8b54e3664bc9230db9b3c2c73b559c4c5aa0d545a0bbcd5503654d557cc47
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
 *   derivation  sha256 9c5ab65be41d67243beebe951c10a97ef87d6eb5d3f193d63cf6658e7f44b6f8
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
 *   6 operations; derivation sha256 9c5ab65be41d67243beebe951c10a97ef87d6eb5d3f193d63cf6658e7f44b6f8
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
 *   6 operations; derivation sha256 9c5ab65be41d67243beebe951c10a97ef87d6eb5d3f193d63cf6658e7f44b6f8
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
 *   6 operations; derivation sha256 9c5ab65be41d67243beebe951c10a97ef87d6eb5d3f193d63cf6658e7f44b6f8
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
 *   derivation  sha256 b8846cc63b152cacd903a643382cc65754655411c92c92439b52cc10b4faf8b3
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
 *   6 operations; derivation sha256 b8846cc63b152cacd903a643382cc65754655411c92c92439b52cc10b4faf8b3
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
 *   6 operations; derivation sha256 b8846cc63b152cacd903a643382cc65754655411c92c92439b52cc10b4faf8b3
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
 *   6 operations; derivation sha256 b8846cc63b152cacd903a643382cc65754655411c92c92439b52cc10b4faf8b3
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
 *   derivation  sha256 101ac690a535ae5a51bb85759b6df9380aae98fdec6ae12fee9aac2f6153c920
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
 *   13 operations; derivation sha256 101ac690a535ae5a51bb85759b6df9380aae98fdec6ae12fee9aac2f6153c920
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
 *   13 operations; derivation sha256 101ac690a535ae5a51bb85759b6df9380aae98fdec6ae12fee9aac2f6153c920
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
 *   13 operations; derivation sha256 101ac690a535ae5a51bb85759b6df9380aae98fdec6ae12fee9aac2f6153c920
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
 *   derivation  sha256 b01ea8a55ea91c3c712ca018c1a183476a14931beaf248d2a0e6ffa906a6bea9
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
 *   24 operations; derivation sha256 b01ea8a55ea91c3c712ca018c1a183476a14931beaf248d2a0e6ffa906a6bea9
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
 *   24 operations; derivation sha256 b01ea8a55ea91c3c712ca018c1a183476a14931beaf248d2a0e6ffa906a6bea9
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
 *   24 operations; derivation sha256 b01ea8a55ea91c3c712ca018c1a183476a14931beaf248d2a0e6ffa906a6bea9
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
 *   derivation  sha256 99d8fde272ba013e3978bdb107acde19a3dca7d3d410d6219f7c418f309602be
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
 *   6 operations; derivation sha256 99d8fde272ba013e3978bdb107acde19a3dca7d3d410d6219f7c418f309602be
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
 *   6 operations; derivation sha256 99d8fde272ba013e3978bdb107acde19a3dca7d3d410d6219f7c418f309602be
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
 *   6 operations; derivation sha256 99d8fde272ba013e3978bdb107acde19a3dca7d3d410d6219f7c418f309602be
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
 *   derivation  sha256 6dd807336c1a4e1572a5a6a3db8169f73d1b51c3092752ae6002dcd6da833ccb
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
 *   6 operations; derivation sha256 6dd807336c1a4e1572a5a6a3db8169f73d1b51c3092752ae6002dcd6da833ccb
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
 *   6 operations; derivation sha256 6dd807336c1a4e1572a5a6a3db8169f73d1b51c3092752ae6002dcd6da833ccb
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
 *   6 operations; derivation sha256 6dd807336c1a4e1572a5a6a3db8169f73d1b51c3092752ae6002dcd6da833ccb
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
 *   derivation  sha256 94fb1bb483db078ce2c2c21e24b9585dd03786b54f33df6db1bf0225793fbd66
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
 *   13 operations; derivation sha256 94fb1bb483db078ce2c2c21e24b9585dd03786b54f33df6db1bf0225793fbd66
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
 *   13 operations; derivation sha256 94fb1bb483db078ce2c2c21e24b9585dd03786b54f33df6db1bf0225793fbd66
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
 *   13 operations; derivation sha256 94fb1bb483db078ce2c2c21e24b9585dd03786b54f33df6db1bf0225793fbd66
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
 *   derivation  sha256 17190d54bfd0a86d9502cb09537bd8e6286d32172d51eaff6b4d85fe515e6386
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
 *   24 operations; derivation sha256 17190d54bfd0a86d9502cb09537bd8e6286d32172d51eaff6b4d85fe515e6386
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
 *   24 operations; derivation sha256 17190d54bfd0a86d9502cb09537bd8e6286d32172d51eaff6b4d85fe515e6386
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
 *   24 operations; derivation sha256 17190d54bfd0a86d9502cb09537bd8e6286d32172d51eaff6b4d85fe515e6386
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
 *   derivation  sha256 bbf73fa477d98d3c94b5e432f4be63588fcc3cc8e76193c0919e06f2fb7c2f6b
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
 *   6 operations; derivation sha256 bbf73fa477d98d3c94b5e432f4be63588fcc3cc8e76193c0919e06f2fb7c2f6b
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
 *   6 operations; derivation sha256 bbf73fa477d98d3c94b5e432f4be63588fcc3cc8e76193c0919e06f2fb7c2f6b
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
 *   6 operations; derivation sha256 bbf73fa477d98d3c94b5e432f4be63588fcc3cc8e76193c0919e06f2fb7c2f6b
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
 *   derivation  sha256 26a8efdcbc2560faa634d8a1459ad6fa123eac21993214a47c8eeb509e4e2ba0
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
 *   6 operations; derivation sha256 26a8efdcbc2560faa634d8a1459ad6fa123eac21993214a47c8eeb509e4e2ba0
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
 *   6 operations; derivation sha256 26a8efdcbc2560faa634d8a1459ad6fa123eac21993214a47c8eeb509e4e2ba0
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
 *   6 operations; derivation sha256 26a8efdcbc2560faa634d8a1459ad6fa123eac21993214a47c8eeb509e4e2ba0
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
 *   derivation  sha256 c8a8c2fcdd4e811d34d4792ac2e6cbf91bd601af111a0fe88e7ba06331d57eb4
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
 *   13 operations; derivation sha256 c8a8c2fcdd4e811d34d4792ac2e6cbf91bd601af111a0fe88e7ba06331d57eb4
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
 *   13 operations; derivation sha256 c8a8c2fcdd4e811d34d4792ac2e6cbf91bd601af111a0fe88e7ba06331d57eb4
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
 *   13 operations; derivation sha256 c8a8c2fcdd4e811d34d4792ac2e6cbf91bd601af111a0fe88e7ba06331d57eb4
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
 *   derivation  sha256 f5f8c01f2091a8649522d5f542bef4da4d9d1b0480afffc3bf175b82c186c1a2
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
 *   24 operations; derivation sha256 f5f8c01f2091a8649522d5f542bef4da4d9d1b0480afffc3bf175b82c186c1a2
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
 *   24 operations; derivation sha256 f5f8c01f2091a8649522d5f542bef4da4d9d1b0480afffc3bf175b82c186c1a2
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
 *   24 operations; derivation sha256 f5f8c01f2091a8649522d5f542bef4da4d9d1b0480afffc3bf175b82c186c1a2
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
 *   derivation  sha256 979ee93a192c498dbd2cea6d4a0649d886572dcb11db1a223e095e68bbed983c
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
 *   6 operations; derivation sha256 979ee93a192c498dbd2cea6d4a0649d886572dcb11db1a223e095e68bbed983c
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
 *   6 operations; derivation sha256 979ee93a192c498dbd2cea6d4a0649d886572dcb11db1a223e095e68bbed983c
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
 *   6 operations; derivation sha256 979ee93a192c498dbd2cea6d4a0649d886572dcb11db1a223e095e68bbed983c
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
 *   derivation  sha256 1c65e98508f0ef49ac9374e13b4dbdfbfe2366ef59511c9d7fbfdf9247490c66
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
 *   6 operations; derivation sha256 1c65e98508f0ef49ac9374e13b4dbdfbfe2366ef59511c9d7fbfdf9247490c66
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
 *   6 operations; derivation sha256 1c65e98508f0ef49ac9374e13b4dbdfbfe2366ef59511c9d7fbfdf9247490c66
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
 *   6 operations; derivation sha256 1c65e98508f0ef49ac9374e13b4dbdfbfe2366ef59511c9d7fbfdf9247490c66
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
 *   derivation  sha256 2a3e407528723168ae6ccf7d2bb337f22a2589efe02700bea8cb8a61c85d4dd6
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
 *   13 operations; derivation sha256 2a3e407528723168ae6ccf7d2bb337f22a2589efe02700bea8cb8a61c85d4dd6
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
 *   13 operations; derivation sha256 2a3e407528723168ae6ccf7d2bb337f22a2589efe02700bea8cb8a61c85d4dd6
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
 *   13 operations; derivation sha256 2a3e407528723168ae6ccf7d2bb337f22a2589efe02700bea8cb8a61c85d4dd6
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
 *   derivation  sha256 7b686944ad47c5cd9b3784929c2d0070f98b0ffabb883c4f47ecf3cb702f4abd
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
 *   24 operations; derivation sha256 7b686944ad47c5cd9b3784929c2d0070f98b0ffabb883c4f47ecf3cb702f4abd
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
 *   24 operations; derivation sha256 7b686944ad47c5cd9b3784929c2d0070f98b0ffabb883c4f47ecf3cb702f4abd
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
 *   24 operations; derivation sha256 7b686944ad47c5cd9b3784929c2d0070f98b0ffabb883c4f47ecf3cb702f4abd
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
 *   derivation  sha256 ba6684559cbfa5211efd1920d50f40cb70bc54cc92f6f5e00dc8c9c9306ccb9b
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
 *   6 operations; derivation sha256 ba6684559cbfa5211efd1920d50f40cb70bc54cc92f6f5e00dc8c9c9306ccb9b
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
 *   6 operations; derivation sha256 ba6684559cbfa5211efd1920d50f40cb70bc54cc92f6f5e00dc8c9c9306ccb9b
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
 *   6 operations; derivation sha256 ba6684559cbfa5211efd1920d50f40cb70bc54cc92f6f5e00dc8c9c9306ccb9b
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
 *   derivation  sha256 a35dfd48aac93458874306893e6f44c24955bbacc04abd7298941ffe4ad38df7
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
 *   6 operations; derivation sha256 a35dfd48aac93458874306893e6f44c24955bbacc04abd7298941ffe4ad38df7
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
 *   6 operations; derivation sha256 a35dfd48aac93458874306893e6f44c24955bbacc04abd7298941ffe4ad38df7
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
 *   6 operations; derivation sha256 a35dfd48aac93458874306893e6f44c24955bbacc04abd7298941ffe4ad38df7
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
 *   derivation  sha256 e6787b1ffc3ac3257b5fb969bb06df8128f53d9dc82afd679e4bc41ba6ee3198
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
 *   13 operations; derivation sha256 e6787b1ffc3ac3257b5fb969bb06df8128f53d9dc82afd679e4bc41ba6ee3198
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
 *   13 operations; derivation sha256 e6787b1ffc3ac3257b5fb969bb06df8128f53d9dc82afd679e4bc41ba6ee3198
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
 *   13 operations; derivation sha256 e6787b1ffc3ac3257b5fb969bb06df8128f53d9dc82afd679e4bc41ba6ee3198
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
 *   derivation  sha256 ca7633bf41e92038cc6b88046e6340d4c576629d0f18bc3aecb737f26530ca17
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
 *   24 operations; derivation sha256 ca7633bf41e92038cc6b88046e6340d4c576629d0f18bc3aecb737f26530ca17
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
 *   24 operations; derivation sha256 ca7633bf41e92038cc6b88046e6340d4c576629d0f18bc3aecb737f26530ca17
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
 *   24 operations; derivation sha256 ca7633bf41e92038cc6b88046e6340d4c576629d0f18bc3aecb737f26530ca17
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
 *   derivation  sha256 c9bbde2ea0fb35785f195db8cf9c22b079939ad6bc1baf139d90c4c613f8de4e
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
 *   6 operations; derivation sha256 c9bbde2ea0fb35785f195db8cf9c22b079939ad6bc1baf139d90c4c613f8de4e
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
 *   6 operations; derivation sha256 c9bbde2ea0fb35785f195db8cf9c22b079939ad6bc1baf139d90c4c613f8de4e
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
 *   6 operations; derivation sha256 c9bbde2ea0fb35785f195db8cf9c22b079939ad6bc1baf139d90c4c613f8de4e
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
 *   derivation  sha256 a611a63b6938b2b997498f97e27cd039fceb6b271b6c278f8fb653f9efd6344a
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
 *   6 operations; derivation sha256 a611a63b6938b2b997498f97e27cd039fceb6b271b6c278f8fb653f9efd6344a
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
 *   6 operations; derivation sha256 a611a63b6938b2b997498f97e27cd039fceb6b271b6c278f8fb653f9efd6344a
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
 *   6 operations; derivation sha256 a611a63b6938b2b997498f97e27cd039fceb6b271b6c278f8fb653f9efd6344a
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
 *   derivation  sha256 ee67b04e12e2ce2ff7badd33424db51608115b788ef62f3b47fcf14fdb928c97
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
 *   13 operations; derivation sha256 ee67b04e12e2ce2ff7badd33424db51608115b788ef62f3b47fcf14fdb928c97
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
 *   13 operations; derivation sha256 ee67b04e12e2ce2ff7badd33424db51608115b788ef62f3b47fcf14fdb928c97
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
 *   13 operations; derivation sha256 ee67b04e12e2ce2ff7badd33424db51608115b788ef62f3b47fcf14fdb928c97
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
 *   derivation  sha256 756e561b63ad1d97719fdce482ca42e3886b6d3b2c0b57cbd62497adc959bff9
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
 *   24 operations; derivation sha256 756e561b63ad1d97719fdce482ca42e3886b6d3b2c0b57cbd62497adc959bff9
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
 *   24 operations; derivation sha256 756e561b63ad1d97719fdce482ca42e3886b6d3b2c0b57cbd62497adc959bff9
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
 *   24 operations; derivation sha256 756e561b63ad1d97719fdce482ca42e3886b6d3b2c0b57cbd62497adc959bff9
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
 *   derivation  sha256 512360b2471fc102ac0fa8c9ac661115c57b4554ccbb378ff4a41d591c93840f
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
 *   6 operations; derivation sha256 512360b2471fc102ac0fa8c9ac661115c57b4554ccbb378ff4a41d591c93840f
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
 *   6 operations; derivation sha256 512360b2471fc102ac0fa8c9ac661115c57b4554ccbb378ff4a41d591c93840f
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
 *   6 operations; derivation sha256 512360b2471fc102ac0fa8c9ac661115c57b4554ccbb378ff4a41d591c93840f
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
 *   derivation  sha256 adfc2a1f56123a02796689fcd31259419dc567c1cea84e1b93815971924418ae
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
 *   6 operations; derivation sha256 adfc2a1f56123a02796689fcd31259419dc567c1cea84e1b93815971924418ae
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
 *   6 operations; derivation sha256 adfc2a1f56123a02796689fcd31259419dc567c1cea84e1b93815971924418ae
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
 *   6 operations; derivation sha256 adfc2a1f56123a02796689fcd31259419dc567c1cea84e1b93815971924418ae
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
 *   derivation  sha256 09b879f243dc95114aab98bf81ea6eae784a54b0990675a477f7ce0c32d031d1
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
 *   13 operations; derivation sha256 09b879f243dc95114aab98bf81ea6eae784a54b0990675a477f7ce0c32d031d1
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
 *   13 operations; derivation sha256 09b879f243dc95114aab98bf81ea6eae784a54b0990675a477f7ce0c32d031d1
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
 *   13 operations; derivation sha256 09b879f243dc95114aab98bf81ea6eae784a54b0990675a477f7ce0c32d031d1
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
 *   derivation  sha256 b086cf1947f6376651c2d19f6e9839e418d89561cf84963157d2affe0010df0c
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
 *   24 operations; derivation sha256 b086cf1947f6376651c2d19f6e9839e418d89561cf84963157d2affe0010df0c
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
 *   24 operations; derivation sha256 b086cf1947f6376651c2d19f6e9839e418d89561cf84963157d2affe0010df0c
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
 *   24 operations; derivation sha256 b086cf1947f6376651c2d19f6e9839e418d89561cf84963157d2affe0010df0c
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
 *   derivation  sha256 c78d897ee452651cdb8b9bfc04d057d2602075b3c060b52e9abbb487376671ce
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
 *   6 operations; derivation sha256 c78d897ee452651cdb8b9bfc04d057d2602075b3c060b52e9abbb487376671ce
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
 *   6 operations; derivation sha256 c78d897ee452651cdb8b9bfc04d057d2602075b3c060b52e9abbb487376671ce
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
 *   6 operations; derivation sha256 c78d897ee452651cdb8b9bfc04d057d2602075b3c060b52e9abbb487376671ce
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
 *   derivation  sha256 8abeae5db88e4e8b1f980002de3225324bc9a6183b8092de5393f5b48777d47e
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
 *   6 operations; derivation sha256 8abeae5db88e4e8b1f980002de3225324bc9a6183b8092de5393f5b48777d47e
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
 *   6 operations; derivation sha256 8abeae5db88e4e8b1f980002de3225324bc9a6183b8092de5393f5b48777d47e
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
 *   6 operations; derivation sha256 8abeae5db88e4e8b1f980002de3225324bc9a6183b8092de5393f5b48777d47e
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
 *   derivation  sha256 44ffc8749b3737689be53a3802e4e63272cccafc953c814cecb9e96ac9a325df
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
 *   13 operations; derivation sha256 44ffc8749b3737689be53a3802e4e63272cccafc953c814cecb9e96ac9a325df
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
 *   13 operations; derivation sha256 44ffc8749b3737689be53a3802e4e63272cccafc953c814cecb9e96ac9a325df
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
 *   13 operations; derivation sha256 44ffc8749b3737689be53a3802e4e63272cccafc953c814cecb9e96ac9a325df
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
 *   derivation  sha256 43811e29291aaf24b8d2ac3cc8abeea6bd935d6d676c55cfca93e360e0f55e27
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
 *   24 operations; derivation sha256 43811e29291aaf24b8d2ac3cc8abeea6bd935d6d676c55cfca93e360e0f55e27
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
 *   24 operations; derivation sha256 43811e29291aaf24b8d2ac3cc8abeea6bd935d6d676c55cfca93e360e0f55e27
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
 *   24 operations; derivation sha256 43811e29291aaf24b8d2ac3cc8abeea6bd935d6d676c55cfca93e360e0f55e27
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
 *   derivation  sha256 6c84c4efffd55db4ea8213dc9b11cecc8349dad17b36135cc160d50d6109cb3f
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
 *   6 operations; derivation sha256 6c84c4efffd55db4ea8213dc9b11cecc8349dad17b36135cc160d50d6109cb3f
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
 *   6 operations; derivation sha256 6c84c4efffd55db4ea8213dc9b11cecc8349dad17b36135cc160d50d6109cb3f
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
 *   6 operations; derivation sha256 6c84c4efffd55db4ea8213dc9b11cecc8349dad17b36135cc160d50d6109cb3f
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
 *   derivation  sha256 36a3c2c542a8d3639c876836964fedd9c9060e40dbe251339937870900c56103
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
 *   6 operations; derivation sha256 36a3c2c542a8d3639c876836964fedd9c9060e40dbe251339937870900c56103
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
 *   6 operations; derivation sha256 36a3c2c542a8d3639c876836964fedd9c9060e40dbe251339937870900c56103
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
 *   6 operations; derivation sha256 36a3c2c542a8d3639c876836964fedd9c9060e40dbe251339937870900c56103
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
 *   derivation  sha256 76b36cf9c5a1b834fc7624c1332aeaf5949ec6ce50867f34ab37b197a766426f
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
 *   13 operations; derivation sha256 76b36cf9c5a1b834fc7624c1332aeaf5949ec6ce50867f34ab37b197a766426f
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
 *   13 operations; derivation sha256 76b36cf9c5a1b834fc7624c1332aeaf5949ec6ce50867f34ab37b197a766426f
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
 *   13 operations; derivation sha256 76b36cf9c5a1b834fc7624c1332aeaf5949ec6ce50867f34ab37b197a766426f
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
