/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The kernels of section_3_3. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"
#include "loops.h"

static const chasles_shape chasles_axial_vector_loop_shapes[] = {{2, 3, 3}, {1, 1, 3}};
const chasles_loop chasles_axial_vector_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    1, 2, chasles_axial_vector_loop_shapes,
    CHASLES_BLOCKS(chasles_axial_vector_block),
};

static const chasles_shape chasles_axial_vector_loopf_shapes[] = {{2, 3, 3}, {1, 1, 3}};
const chasles_loop chasles_axial_vector_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    1, 2, chasles_axial_vector_loopf_shapes,
    CHASLES_BLOCKS(chasles_axial_vector_blockf),
};

#if !(CHASLES_VECTORS && defined(CHASLES_BLOCKS_ALONE))

/*
 * (3.45) The angular velocity: the axial vector of the angular-velocity matrix.
 *   given       Omega[9]: angular-velocity matrix
 *   returns     omega[3]: angular velocity
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 3 subtract, 3 multiply
 *   error bound 1.01 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 8c4348a6af61531ef5e1d340b707a886d5ae17216e0e81a5fdda49099e70eece
 */
void chasles_axial_vector(const double Omega[9], double omega[3])
{
    const double omega0 = 0.5 * (Omega[7] - Omega[5]);
    const double omega1 = 0.5 * (Omega[2] - Omega[6]);
    const double omega2 = 0.5 * (Omega[3] - Omega[1]);
    omega[0] = omega0;
    omega[1] = omega1;
    omega[2] = omega2;
}

/*
 * (3.45) chasles_axial_vector in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 8c4348a6af61531ef5e1d340b707a886d5ae17216e0e81a5fdda49099e70eece
 */
void chasles_axial_vectorf(const float Omega[9], float omega[3])
{
    const float omega0 = 0.5f * (Omega[7] - Omega[5]);
    const float omega1 = 0.5f * (Omega[2] - Omega[6]);
    const float omega2 = 0.5f * (Omega[3] - Omega[1]);
    omega[0] = omega0;
    omega[1] = omega1;
    omega[2] = omega2;
}

/*
 * (3.45) chasles_axial_vector for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 8c4348a6af61531ef5e1d340b707a886d5ae17216e0e81a5fdda49099e70eece
 */
void chasles_axial_vector_batch(
    size_t count,
    const double *Omega, ptrdiff_t Omega_step,
    double *omega, ptrdiff_t omega_step)
{
    char *const at[] = {(char *)Omega, (char *)omega};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {Omega_step * size, omega_step * size};
    const chasles_loop *loop = &chasles_axial_vector_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.45) chasles_axial_vectorf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 8c4348a6af61531ef5e1d340b707a886d5ae17216e0e81a5fdda49099e70eece
 */
void chasles_axial_vector_batchf(
    size_t count,
    const float *Omega, ptrdiff_t Omega_step,
    float *omega, ptrdiff_t omega_step)
{
    char *const at[] = {(char *)Omega, (char *)omega};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {Omega_step * size, omega_step * size};
    const chasles_loop *loop = &chasles_axial_vector_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

#endif
