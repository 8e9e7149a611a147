/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_2_3, for batches. Made by `chasles emit`; not to be edited by hand.
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

void CHASLES_LEVELED(chasles_rotation_in_triad_axes_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    const ptrdiff_t down0 = CHASLES_STEP(3, 3 * sizeof(double));
    const ptrdiff_t across0 = CHASLES_STEP(4, 1 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    const ptrdiff_t down1 = CHASLES_STEP(5, 3 * sizeof(double));
    const ptrdiff_t across1 = CHASLES_STEP(6, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(double));
    const ptrdiff_t down2 = CHASLES_STEP(7, 3 * sizeof(double));
    const ptrdiff_t across2 = CHASLES_STEP(8, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles triad[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9);
        take_4(item0, 0, 3, down0, across0, step0, triad);
        take_4(item0, 4, 3, down0, across0, step0, &triad[4]);
        take_1(item0, 8, 3, down0, across0, step0, &triad[8]);
        doubles triad_prime[9];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 9);
        take_4(item1, 0, 3, down1, across1, step1, triad_prime);
        take_4(item1, 4, 3, down1, across1, step1, &triad_prime[4]);
        take_1(item1, 8, 3, down1, across1, step1, &triad_prime[8]);
        const doubles t1 = triad[0] * triad_prime[0] + triad[3] * triad_prime[3];
        const doubles Q0 = t1 + triad[6] * triad_prime[6];
        const doubles t2 = triad[0] * triad_prime[1] + triad[3] * triad_prime[4];
        const doubles Q1 = t2 + triad[6] * triad_prime[7];
        const doubles t3 = triad[0] * triad_prime[2] + triad[3] * triad_prime[5];
        const doubles Q2 = t3 + triad[6] * triad_prime[8];
        const doubles t4 = triad[1] * triad_prime[0] + triad[4] * triad_prime[3];
        const doubles Q3 = t4 + triad[7] * triad_prime[6];
        const doubles t5 = triad[1] * triad_prime[1] + triad[4] * triad_prime[4];
        const doubles Q4 = t5 + triad[7] * triad_prime[7];
        const doubles t6 = triad[1] * triad_prime[2] + triad[4] * triad_prime[5];
        const doubles Q5 = t6 + triad[7] * triad_prime[8];
        const doubles t7 = triad[2] * triad_prime[0] + triad[5] * triad_prime[3];
        const doubles Q6 = t7 + triad[8] * triad_prime[6];
        const doubles t8 = triad[2] * triad_prime[1] + triad[5] * triad_prime[4];
        const doubles Q7 = t8 + triad[8] * triad_prime[7];
        const doubles t9 = triad[2] * triad_prime[2] + triad[5] * triad_prime[5];
        const doubles Q8 = t9 + triad[8] * triad_prime[8];
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, 9);
        give_4(item2, 0, 3, down2, across2, step2, Q0, Q1, Q2, Q3);
        give_4(item2, 4, 3, down2, across2, step2, Q4, Q5, Q6, Q7);
        give_1(item2, 8, 3, down2, across2, step2, Q8);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_in_triad_axes_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    const ptrdiff_t down0 = CHASLES_STEP(3, 3 * sizeof(float));
    const ptrdiff_t across0 = CHASLES_STEP(4, 1 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    const ptrdiff_t down1 = CHASLES_STEP(5, 3 * sizeof(float));
    const ptrdiff_t across1 = CHASLES_STEP(6, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(float));
    const ptrdiff_t down2 = CHASLES_STEP(7, 3 * sizeof(float));
    const ptrdiff_t across2 = CHASLES_STEP(8, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats triad[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9);
        take_4f(item0, 0, 3, down0, across0, step0, triad);
        take_4f(item0, 4, 3, down0, across0, step0, &triad[4]);
        take_1f(item0, 8, 3, down0, across0, step0, &triad[8]);
        floats triad_prime[9];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 9);
        take_4f(item1, 0, 3, down1, across1, step1, triad_prime);
        take_4f(item1, 4, 3, down1, across1, step1, &triad_prime[4]);
        take_1f(item1, 8, 3, down1, across1, step1, &triad_prime[8]);
        const floats t1 = triad[0] * triad_prime[0] + triad[3] * triad_prime[3];
        const floats Q0 = t1 + triad[6] * triad_prime[6];
        const floats t2 = triad[0] * triad_prime[1] + triad[3] * triad_prime[4];
        const floats Q1 = t2 + triad[6] * triad_prime[7];
        const floats t3 = triad[0] * triad_prime[2] + triad[3] * triad_prime[5];
        const floats Q2 = t3 + triad[6] * triad_prime[8];
        const floats t4 = triad[1] * triad_prime[0] + triad[4] * triad_prime[3];
        const floats Q3 = t4 + triad[7] * triad_prime[6];
        const floats t5 = triad[1] * triad_prime[1] + triad[4] * triad_prime[4];
        const floats Q4 = t5 + triad[7] * triad_prime[7];
        const floats t6 = triad[1] * triad_prime[2] + triad[4] * triad_prime[5];
        const floats Q5 = t6 + triad[7] * triad_prime[8];
        const floats t7 = triad[2] * triad_prime[0] + triad[5] * triad_prime[3];
        const floats Q6 = t7 + triad[8] * triad_prime[6];
        const floats t8 = triad[2] * triad_prime[1] + triad[5] * triad_prime[4];
        const floats Q7 = t8 + triad[8] * triad_prime[7];
        const floats t9 = triad[2] * triad_prime[2] + triad[5] * triad_prime[5];
        const floats Q8 = t9 + triad[8] * triad_prime[8];
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, 9);
        give_4f(item2, 0, 3, down2, across2, step2, Q0, Q1, Q2, Q3);
        give_4f(item2, 4, 3, down2, across2, step2, Q4, Q5, Q6, Q7);
        give_1f(item2, 8, 3, down2, across2, step2, Q8);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_triads_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    const ptrdiff_t down0 = CHASLES_STEP(3, 3 * sizeof(double));
    const ptrdiff_t across0 = CHASLES_STEP(4, 1 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    const ptrdiff_t down1 = CHASLES_STEP(5, 3 * sizeof(double));
    const ptrdiff_t across1 = CHASLES_STEP(6, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(double));
    const ptrdiff_t down2 = CHASLES_STEP(7, 3 * sizeof(double));
    const ptrdiff_t across2 = CHASLES_STEP(8, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles triad[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9);
        take_4(item0, 0, 3, down0, across0, step0, triad);
        take_4(item0, 4, 3, down0, across0, step0, &triad[4]);
        take_1(item0, 8, 3, down0, across0, step0, &triad[8]);
        doubles triad_prime[9];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 9);
        take_4(item1, 0, 3, down1, across1, step1, triad_prime);
        take_4(item1, 4, 3, down1, across1, step1, &triad_prime[4]);
        take_1(item1, 8, 3, down1, across1, step1, &triad_prime[8]);
        const doubles t1 = triad[0] * triad_prime[0] + triad[1] * triad_prime[1];
        const doubles Q0 = t1 + triad[2] * triad_prime[2];
        const doubles t2 = triad[3] * triad_prime[0] + triad[4] * triad_prime[1];
        const doubles Q1 = t2 + triad[5] * triad_prime[2];
        const doubles t3 = triad[6] * triad_prime[0] + triad[7] * triad_prime[1];
        const doubles Q2 = t3 + triad[8] * triad_prime[2];
        const doubles t4 = triad[0] * triad_prime[3] + triad[1] * triad_prime[4];
        const doubles Q3 = t4 + triad[2] * triad_prime[5];
        const doubles t5 = triad[3] * triad_prime[3] + triad[4] * triad_prime[4];
        const doubles Q4 = t5 + triad[5] * triad_prime[5];
        const doubles t6 = triad[6] * triad_prime[3] + triad[7] * triad_prime[4];
        const doubles Q5 = t6 + triad[8] * triad_prime[5];
        const doubles t7 = triad[0] * triad_prime[6] + triad[1] * triad_prime[7];
        const doubles Q6 = t7 + triad[2] * triad_prime[8];
        const doubles t8 = triad[3] * triad_prime[6] + triad[4] * triad_prime[7];
        const doubles Q7 = t8 + triad[5] * triad_prime[8];
        const doubles t9 = triad[6] * triad_prime[6] + triad[7] * triad_prime[7];
        const doubles Q8 = t9 + triad[8] * triad_prime[8];
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, 9);
        give_4(item2, 0, 3, down2, across2, step2, Q0, Q1, Q2, Q3);
        give_4(item2, 4, 3, down2, across2, step2, Q4, Q5, Q6, Q7);
        give_1(item2, 8, 3, down2, across2, step2, Q8);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_triads_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    const ptrdiff_t down0 = CHASLES_STEP(3, 3 * sizeof(float));
    const ptrdiff_t across0 = CHASLES_STEP(4, 1 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    const ptrdiff_t down1 = CHASLES_STEP(5, 3 * sizeof(float));
    const ptrdiff_t across1 = CHASLES_STEP(6, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(float));
    const ptrdiff_t down2 = CHASLES_STEP(7, 3 * sizeof(float));
    const ptrdiff_t across2 = CHASLES_STEP(8, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats triad[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9);
        take_4f(item0, 0, 3, down0, across0, step0, triad);
        take_4f(item0, 4, 3, down0, across0, step0, &triad[4]);
        take_1f(item0, 8, 3, down0, across0, step0, &triad[8]);
        floats triad_prime[9];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 9);
        take_4f(item1, 0, 3, down1, across1, step1, triad_prime);
        take_4f(item1, 4, 3, down1, across1, step1, &triad_prime[4]);
        take_1f(item1, 8, 3, down1, across1, step1, &triad_prime[8]);
        const floats t1 = triad[0] * triad_prime[0] + triad[1] * triad_prime[1];
        const floats Q0 = t1 + triad[2] * triad_prime[2];
        const floats t2 = triad[3] * triad_prime[0] + triad[4] * triad_prime[1];
        const floats Q1 = t2 + triad[5] * triad_prime[2];
        const floats t3 = triad[6] * triad_prime[0] + triad[7] * triad_prime[1];
        const floats Q2 = t3 + triad[8] * triad_prime[2];
        const floats t4 = triad[0] * triad_prime[3] + triad[1] * triad_prime[4];
        const floats Q3 = t4 + triad[2] * triad_prime[5];
        const floats t5 = triad[3] * triad_prime[3] + triad[4] * triad_prime[4];
        const floats Q4 = t5 + triad[5] * triad_prime[5];
        const floats t6 = triad[6] * triad_prime[3] + triad[7] * triad_prime[4];
        const floats Q5 = t6 + triad[8] * triad_prime[5];
        const floats t7 = triad[0] * triad_prime[6] + triad[1] * triad_prime[7];
        const floats Q6 = t7 + triad[2] * triad_prime[8];
        const floats t8 = triad[3] * triad_prime[6] + triad[4] * triad_prime[7];
        const floats Q7 = t8 + triad[5] * triad_prime[8];
        const floats t9 = triad[6] * triad_prime[6] + triad[7] * triad_prime[7];
        const floats Q8 = t9 + triad[8] * triad_prime[8];
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, 9);
        give_4f(item2, 0, 3, down2, across2, step2, Q0, Q1, Q2, Q3);
        give_4f(item2, 4, 3, down2, across2, step2, Q4, Q5, Q6, Q7);
        give_1f(item2, 8, 3, down2, across2, step2, Q8);
        stream_lines(&copied);
    }
}

#else

void CHASLES_LEVELED(chasles_rotation_in_triad_axes_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_in_triad_axes(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_in_triad_axes_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_in_triad_axesf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_triads_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_triads(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_triads_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_triadsf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

#endif
