/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_4, for batches. Made by `chasles emit`; not to be edited by hand.
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

void CHASLES_LEVELED(chasles_velocity_of_point_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    const ptrdiff_t down0 = CHASLES_STEP(5, 3 * sizeof(double));
    const ptrdiff_t across0 = CHASLES_STEP(6, 1 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    const ptrdiff_t down1 = CHASLES_STEP(7, 3 * sizeof(double));
    const ptrdiff_t across1 = CHASLES_STEP(8, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    const ptrdiff_t down2 = CHASLES_STEP(9, 3 * sizeof(double));
    const ptrdiff_t across2 = CHASLES_STEP(10, 1 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    const ptrdiff_t down3 = CHASLES_STEP(11, 3 * sizeof(double));
    const ptrdiff_t across3 = CHASLES_STEP(12, 1 * sizeof(double));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(double));
    const ptrdiff_t down4 = CHASLES_STEP(13, 3 * sizeof(double));
    const ptrdiff_t across4 = CHASLES_STEP(14, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3);
        take_3(item0, 0, 3, down0, across0, step0, omega);
        doubles a_dot[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3);
        take_3(item1, 0, 3, down1, across1, step1, a_dot);
        doubles a[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3);
        take_3(item2, 0, 3, down2, across2, step2, a);
        doubles p[3];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 3);
        take_3(item3, 0, 3, down3, across3, step3, p);
        const doubles t1 = p[0] - a[0];
        const doubles t2 = p[1] - a[1];
        const doubles t3 = p[2] - a[2];
        const doubles p_dot0 = a_dot[0] + (omega[1] * t3 - omega[2] * t2);
        const doubles p_dot1 = a_dot[1] + (omega[2] * t1 - omega[0] * t3);
        const doubles p_dot2 = a_dot[2] + (omega[0] * t2 - omega[1] * t1);
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, 3);
        give_3(item4, 0, 3, down4, across4, step4, p_dot0, p_dot1, p_dot2);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_velocity_of_point_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    const ptrdiff_t down0 = CHASLES_STEP(5, 3 * sizeof(float));
    const ptrdiff_t across0 = CHASLES_STEP(6, 1 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    const ptrdiff_t down1 = CHASLES_STEP(7, 3 * sizeof(float));
    const ptrdiff_t across1 = CHASLES_STEP(8, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    const ptrdiff_t down2 = CHASLES_STEP(9, 3 * sizeof(float));
    const ptrdiff_t across2 = CHASLES_STEP(10, 1 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    const ptrdiff_t down3 = CHASLES_STEP(11, 3 * sizeof(float));
    const ptrdiff_t across3 = CHASLES_STEP(12, 1 * sizeof(float));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(float));
    const ptrdiff_t down4 = CHASLES_STEP(13, 3 * sizeof(float));
    const ptrdiff_t across4 = CHASLES_STEP(14, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3);
        take_3f(item0, 0, 3, down0, across0, step0, omega);
        floats a_dot[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3);
        take_3f(item1, 0, 3, down1, across1, step1, a_dot);
        floats a[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3);
        take_3f(item2, 0, 3, down2, across2, step2, a);
        floats p[3];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 3);
        take_3f(item3, 0, 3, down3, across3, step3, p);
        const floats t1 = p[0] - a[0];
        const floats t2 = p[1] - a[1];
        const floats t3 = p[2] - a[2];
        const floats p_dot0 = a_dot[0] + (omega[1] * t3 - omega[2] * t2);
        const floats p_dot1 = a_dot[1] + (omega[2] * t1 - omega[0] * t3);
        const floats p_dot2 = a_dot[2] + (omega[0] * t2 - omega[1] * t1);
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, 3);
        give_3f(item4, 0, 3, down4, across4, step4, p_dot0, p_dot1, p_dot2);
        stream_lines(&copied);
    }
}

#else

void CHASLES_LEVELED(chasles_velocity_of_point_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_velocity_of_point(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_velocity_of_point_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_velocity_of_pointf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

#endif
