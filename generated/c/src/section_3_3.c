/* The kernels of section_3_3. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"

/*
 * (3.45) The angular velocity: the axial vector of the angular-velocity matrix.
 *   given       Omega[9]: angular-velocity matrix
 *   returns     omega[3]: angular velocity
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 3 subtract, 3 multiply
 *   error bound 1.01 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
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
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_axial_vector(Omega + i * Omega_step, omega + i * omega_step);
    }
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
    for (ptrdiff_t i = 0; i < (ptrdiff_t)count; i++) {
        chasles_axial_vectorf(Omega + i * Omega_step, omega + i * omega_step);
    }
}
