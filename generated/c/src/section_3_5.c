/* The kernels of section_3_5. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "batches.h"
#include "chasles.h"

static const chasles_shape chasles_angular_acceleration_matrix_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_angular_acceleration_matrix_loop = {
    sizeof(double), 0, 2, 3,
    chasles_angular_acceleration_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_angular_acceleration_matrix_block),
};

static const chasles_shape chasles_angular_acceleration_matrix_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_angular_acceleration_matrix_loopf = {
    sizeof(float), 0, 2, 3,
    chasles_angular_acceleration_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_angular_acceleration_matrix_blockf),
};

static const chasles_shape chasles_acceleration_of_point_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_acceleration_of_point_loop = {
    sizeof(double), 0, 5, 6,
    chasles_acceleration_of_point_loop_shapes,
    CHASLES_BLOCKS(chasles_acceleration_of_point_block),
};

static const chasles_shape chasles_acceleration_of_point_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_acceleration_of_point_loopf = {
    sizeof(float), 0, 5, 6,
    chasles_acceleration_of_point_loopf_shapes,
    CHASLES_BLOCKS(chasles_acceleration_of_point_blockf),
};

/*
 * (3.86) The angular-acceleration matrix.
 *   given       omega[3]: angular velocity
 *               omega_dot[3]: time derivative of: angular velocity
 *   returns     W[9]: angular-acceleration matrix
 *   verdict     defined
 *   assumes     Q is a rotation
 *   operations  15: 6 add, 3 subtract, 6 multiply
 *   derivation  sha256 9353bb16e90ad45c91a0cb2ecc494d929aa7746b83fe6af49af9df200dbbb47d
 */
void chasles_angular_acceleration_matrix(
    const double omega[3],
    const double omega_dot[3],
    double W[9])
{
    const double t1 = omega[2] * omega[2];
    const double t2 = omega[1] * omega[1];
    const double W0 = -(t1 + t2);
    const double t3 = omega[0] * omega[1];
    const double t4 = omega[0] * omega[2];
    const double t5 = omega[0] * omega[0];
    const double W4 = -(t1 + t5);
    const double t6 = omega[1] * omega[2];
    const double W8 = -(t2 + t5);
    const double W1 = t3 - omega_dot[2];
    const double W2 = omega_dot[1] + t4;
    const double W3 = omega_dot[2] + t3;
    const double W5 = t6 - omega_dot[0];
    const double W6 = t4 - omega_dot[1];
    const double W7 = omega_dot[0] + t6;
    W[0] = W0;
    W[1] = W1;
    W[2] = W2;
    W[3] = W3;
    W[4] = W4;
    W[5] = W5;
    W[6] = W6;
    W[7] = W7;
    W[8] = W8;
}

/*
 * (3.86) chasles_angular_acceleration_matrix in single precision.
 *   verdict: defined; assumes Q is a rotation
 *   15 operations; derivation sha256 9353bb16e90ad45c91a0cb2ecc494d929aa7746b83fe6af49af9df200dbbb47d
 */
void chasles_angular_acceleration_matrixf(
    const float omega[3],
    const float omega_dot[3],
    float W[9])
{
    const float t1 = omega[2] * omega[2];
    const float t2 = omega[1] * omega[1];
    const float W0 = -(t1 + t2);
    const float t3 = omega[0] * omega[1];
    const float t4 = omega[0] * omega[2];
    const float t5 = omega[0] * omega[0];
    const float W4 = -(t1 + t5);
    const float t6 = omega[1] * omega[2];
    const float W8 = -(t2 + t5);
    const float W1 = t3 - omega_dot[2];
    const float W2 = omega_dot[1] + t4;
    const float W3 = omega_dot[2] + t3;
    const float W5 = t6 - omega_dot[0];
    const float W6 = t4 - omega_dot[1];
    const float W7 = omega_dot[0] + t6;
    W[0] = W0;
    W[1] = W1;
    W[2] = W2;
    W[3] = W3;
    W[4] = W4;
    W[5] = W5;
    W[6] = W6;
    W[7] = W7;
    W[8] = W8;
}

/*
 * (3.86) chasles_angular_acceleration_matrix for a batch.
 *   verdict: defined; assumes Q is a rotation
 *   15 operations; derivation sha256 9353bb16e90ad45c91a0cb2ecc494d929aa7746b83fe6af49af9df200dbbb47d
 */
void chasles_angular_acceleration_matrix_batch(
    size_t count,
    const double *omega, ptrdiff_t omega_step,
    const double *omega_dot, ptrdiff_t omega_dot_step,
    double *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)omega, (char *)omega_dot, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {omega_step * size, omega_dot_step * size, W_step * size};
    const chasles_loop *loop = &chasles_angular_acceleration_matrix_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.86) chasles_angular_acceleration_matrixf for a batch.
 *   verdict: defined; assumes Q is a rotation
 *   15 operations; derivation sha256 9353bb16e90ad45c91a0cb2ecc494d929aa7746b83fe6af49af9df200dbbb47d
 */
void chasles_angular_acceleration_matrix_batchf(
    size_t count,
    const float *omega, ptrdiff_t omega_step,
    const float *omega_dot, ptrdiff_t omega_dot_step,
    float *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)omega, (char *)omega_dot, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {omega_step * size, omega_dot_step * size, W_step * size};
    const chasles_loop *loop = &chasles_angular_acceleration_matrix_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.89) The acceleration of a point from that of the landmark, with vector products.
 *   given       omega[3]: angular velocity
 *               omega_dot[3]: time derivative of: angular velocity
 *               a_ddot[3]: second time derivative of: position of the landmark point A
 *               a[3]: position of the landmark point A
 *               p[3]: position of any point P
 *   returns     p_ddot[3]: second time derivative of: position of any point P
 *   verdict     holds
 *   assumes     nothing
 *   operations  36: 6 add, 12 subtract, 18 multiply
 *   derivation  sha256 d86e77df283994951e7f23ec5c1e412135f31c7e3539b9cb228bb538b4e39021
 */
void chasles_acceleration_of_point(
    const double omega[3],
    const double omega_dot[3],
    const double a_ddot[3],
    const double a[3],
    const double p[3],
    double p_ddot[3])
{
    const double t1 = p[0] - a[0];
    const double t2 = p[1] - a[1];
    const double t3 = p[2] - a[2];
    const double t4 = omega[1] * t3 - omega[2] * t2;
    const double t5 = omega[2] * t1 - omega[0] * t3;
    const double t6 = omega[0] * t2 - omega[1] * t1;
    const double t7 = a_ddot[0] + (omega_dot[1] * t3 - omega_dot[2] * t2);
    const double p_ddot0 = t7 + (omega[1] * t6 - omega[2] * t5);
    const double t8 = a_ddot[1] + (omega_dot[2] * t1 - omega_dot[0] * t3);
    const double p_ddot1 = t8 + (omega[2] * t4 - omega[0] * t6);
    const double t9 = a_ddot[2] + (omega_dot[0] * t2 - omega_dot[1] * t1);
    const double p_ddot2 = t9 + (omega[0] * t5 - omega[1] * t4);
    p_ddot[0] = p_ddot0;
    p_ddot[1] = p_ddot1;
    p_ddot[2] = p_ddot2;
}

/*
 * (3.89) chasles_acceleration_of_point in single precision.
 *   verdict: holds; assumes nothing
 *   36 operations; derivation sha256 d86e77df283994951e7f23ec5c1e412135f31c7e3539b9cb228bb538b4e39021
 */
void chasles_acceleration_of_pointf(
    const float omega[3],
    const float omega_dot[3],
    const float a_ddot[3],
    const float a[3],
    const float p[3],
    float p_ddot[3])
{
    const float t1 = p[0] - a[0];
    const float t2 = p[1] - a[1];
    const float t3 = p[2] - a[2];
    const float t4 = omega[1] * t3 - omega[2] * t2;
    const float t5 = omega[2] * t1 - omega[0] * t3;
    const float t6 = omega[0] * t2 - omega[1] * t1;
    const float t7 = a_ddot[0] + (omega_dot[1] * t3 - omega_dot[2] * t2);
    const float p_ddot0 = t7 + (omega[1] * t6 - omega[2] * t5);
    const float t8 = a_ddot[1] + (omega_dot[2] * t1 - omega_dot[0] * t3);
    const float p_ddot1 = t8 + (omega[2] * t4 - omega[0] * t6);
    const float t9 = a_ddot[2] + (omega_dot[0] * t2 - omega_dot[1] * t1);
    const float p_ddot2 = t9 + (omega[0] * t5 - omega[1] * t4);
    p_ddot[0] = p_ddot0;
    p_ddot[1] = p_ddot1;
    p_ddot[2] = p_ddot2;
}

/*
 * (3.89) chasles_acceleration_of_point for a batch.
 *   verdict: holds; assumes nothing
 *   36 operations; derivation sha256 d86e77df283994951e7f23ec5c1e412135f31c7e3539b9cb228bb538b4e39021
 */
void chasles_acceleration_of_point_batch(
    size_t count,
    const double *omega, ptrdiff_t omega_step,
    const double *omega_dot, ptrdiff_t omega_dot_step,
    const double *a_ddot, ptrdiff_t a_ddot_step,
    const double *a, ptrdiff_t a_step,
    const double *p, ptrdiff_t p_step,
    double *p_ddot, ptrdiff_t p_ddot_step)
{
    char *const at[] = {
        (char *)omega,
        (char *)omega_dot,
        (char *)a_ddot,
        (char *)a,
        (char *)p,
        (char *)p_ddot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        omega_step * size,
        omega_dot_step * size,
        a_ddot_step * size,
        a_step * size,
        p_step * size,
        p_ddot_step * size};
    const chasles_loop *loop = &chasles_acceleration_of_point_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.89) chasles_acceleration_of_pointf for a batch.
 *   verdict: holds; assumes nothing
 *   36 operations; derivation sha256 d86e77df283994951e7f23ec5c1e412135f31c7e3539b9cb228bb538b4e39021
 */
void chasles_acceleration_of_point_batchf(
    size_t count,
    const float *omega, ptrdiff_t omega_step,
    const float *omega_dot, ptrdiff_t omega_dot_step,
    const float *a_ddot, ptrdiff_t a_ddot_step,
    const float *a, ptrdiff_t a_step,
    const float *p, ptrdiff_t p_step,
    float *p_ddot, ptrdiff_t p_ddot_step)
{
    char *const at[] = {
        (char *)omega,
        (char *)omega_dot,
        (char *)a_ddot,
        (char *)a,
        (char *)p,
        (char *)p_ddot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        omega_step * size,
        omega_dot_step * size,
        a_ddot_step * size,
        a_step * size,
        p_step * size,
        p_ddot_step * size};
    const chasles_loop *loop = &chasles_acceleration_of_point_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}
