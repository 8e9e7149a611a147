/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_3, for batches. Made by `chasles emit`; not to be edited by hand.
 *
 * Compiled once for each level. A block first computes the sines and cosines of all its items, then, register by
 * register, all else.
 */

#include <math.h>
#include <stddef.h>

#include "chasles.h"
#include "loops.h"
#include "vectors.h"

#if CHASLES_VECTORS

void CHASLES_LEVELED(chasles_axial_vector_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    const ptrdiff_t down0 = CHASLES_STEP(2, 3 * sizeof(double));
    const ptrdiff_t across0 = CHASLES_STEP(3, 1 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    const ptrdiff_t down1 = CHASLES_STEP(4, 3 * sizeof(double));
    const ptrdiff_t across1 = CHASLES_STEP(5, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles Omega[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9);
        take_3(item0, 1, 3, down0, across0, step0, &Omega[1]);
        take_3(item0, 5, 3, down0, across0, step0, &Omega[5]);
        const doubles omega0 = 0.5 * (Omega[7] - Omega[5]);
        const doubles omega1 = 0.5 * (Omega[2] - Omega[6]);
        const doubles omega2 = 0.5 * (Omega[3] - Omega[1]);
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, 3);
        give_3(item1, 0, 3, down1, across1, step1, omega0, omega1, omega2);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_axial_vector_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    const ptrdiff_t down0 = CHASLES_STEP(2, 3 * sizeof(float));
    const ptrdiff_t across0 = CHASLES_STEP(3, 1 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    const ptrdiff_t down1 = CHASLES_STEP(4, 3 * sizeof(float));
    const ptrdiff_t across1 = CHASLES_STEP(5, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats Omega[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9);
        take_3f(item0, 1, 3, down0, across0, step0, &Omega[1]);
        take_3f(item0, 5, 3, down0, across0, step0, &Omega[5]);
        const floats omega0 = 0.5f * (Omega[7] - Omega[5]);
        const floats omega1 = 0.5f * (Omega[2] - Omega[6]);
        const floats omega2 = 0.5f * (Omega[3] - Omega[1]);
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, 3);
        give_3f(item1, 0, 3, down1, across1, step1, omega0, omega1, omega2);
        stream_lines(&copied);
    }
}

#else

void CHASLES_LEVELED(chasles_axial_vector_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_axial_vector((const double *)(at[0] + i * steps[0]), (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_axial_vector_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_axial_vectorf((const float *)(at[0] + i * steps[0]), (float *)(at[1] + i * steps[1]));
    }
}

#endif
