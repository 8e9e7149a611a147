/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_2_2, for batches. Made by `chasles emit`; not to be edited by hand.
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

void CHASLES_LEVELED(chasles_plucker_line_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    const ptrdiff_t down0 = CHASLES_STEP(3, 3 * sizeof(double));
    const ptrdiff_t across0 = CHASLES_STEP(4, 1 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    const ptrdiff_t down1 = CHASLES_STEP(5, 3 * sizeof(double));
    const ptrdiff_t across1 = CHASLES_STEP(6, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    const ptrdiff_t down2 = CHASLES_STEP(7, 6 * sizeof(double));
    const ptrdiff_t across2 = CHASLES_STEP(8, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles p_1[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3);
        take_3(item0, 0, 3, down0, across0, step0, p_1);
        doubles p_2[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3);
        take_3(item1, 0, 3, down1, across1, step1, p_2);
        const doubles t1 = p_2[0] - p_1[0];
        const doubles t2 = p_2[1] - p_1[1];
        const doubles t3 = p_2[2] - p_1[2];
        const doubles t4 = choose(less(t1, spread(0.0)), -t1, t1);
        const doubles t5 = choose(less(t2, spread(0.0)), -t2, t2);
        const doubles t6 = choose(less(t4, t5), t5, t4);
        const doubles t7 = choose(less(t3, spread(0.0)), -t3, t3);
        const doubles t8 = choose(less(t6, t7), t7, t6);
        const doubles t9 = choose(equal(spread(0.0), t8), spread(1.0), t8);
        const doubles t10 = t1 / t9;
        const doubles t11 = t2 / t9;
        const doubles t12 = t3 / t9;
        const doubles t13 = t10 * t10 + t11 * t11 + t12 * t12;
        const doubles t14 = roots(t13);
        const truths t15 = equal(t13, spread(0.0));
        const doubles kappa0 = choose(t15, spread(0.0), t10) / t14;
        const doubles kappa1 = choose(t15, spread(0.0), t11) / t14;
        const doubles kappa2 = choose(t15, spread(0.0), t12) / t14;
        const doubles kappa3 = p_1[1] * kappa2 - p_1[2] * kappa1;
        const doubles kappa4 = p_1[2] * kappa0 - p_1[0] * kappa2;
        const doubles kappa5 = p_1[0] * kappa1 - p_1[1] * kappa0;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, 6);
        give_4(item2, 0, 6, down2, across2, step2, kappa0, kappa1, kappa2, kappa3);
        give_2(item2, 4, 6, down2, across2, step2, kappa4, kappa5);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_plucker_line_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    const ptrdiff_t down0 = CHASLES_STEP(3, 3 * sizeof(float));
    const ptrdiff_t across0 = CHASLES_STEP(4, 1 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    const ptrdiff_t down1 = CHASLES_STEP(5, 3 * sizeof(float));
    const ptrdiff_t across1 = CHASLES_STEP(6, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    const ptrdiff_t down2 = CHASLES_STEP(7, 6 * sizeof(float));
    const ptrdiff_t across2 = CHASLES_STEP(8, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats p_1[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3);
        take_3f(item0, 0, 3, down0, across0, step0, p_1);
        floats p_2[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3);
        take_3f(item1, 0, 3, down1, across1, step1, p_2);
        const floats t1 = p_2[0] - p_1[0];
        const floats t2 = p_2[1] - p_1[1];
        const floats t3 = p_2[2] - p_1[2];
        const floats t4 = choosef(lessf(t1, spreadf(0.0f)), -t1, t1);
        const floats t5 = choosef(lessf(t2, spreadf(0.0f)), -t2, t2);
        const floats t6 = choosef(lessf(t4, t5), t5, t4);
        const floats t7 = choosef(lessf(t3, spreadf(0.0f)), -t3, t3);
        const floats t8 = choosef(lessf(t6, t7), t7, t6);
        const floats t9 = choosef(equalf(spreadf(0.0f), t8), spreadf(1.0f), t8);
        const floats t10 = t1 / t9;
        const floats t11 = t2 / t9;
        const floats t12 = t3 / t9;
        const floats t13 = t10 * t10 + t11 * t11 + t12 * t12;
        const floats t14 = rootsf(t13);
        const truthsf t15 = equalf(t13, spreadf(0.0f));
        const floats kappa0 = choosef(t15, spreadf(0.0f), t10) / t14;
        const floats kappa1 = choosef(t15, spreadf(0.0f), t11) / t14;
        const floats kappa2 = choosef(t15, spreadf(0.0f), t12) / t14;
        const floats kappa3 = p_1[1] * kappa2 - p_1[2] * kappa1;
        const floats kappa4 = p_1[2] * kappa0 - p_1[0] * kappa2;
        const floats kappa5 = p_1[0] * kappa1 - p_1[1] * kappa0;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, 6);
        give_4f(item2, 0, 6, down2, across2, step2, kappa0, kappa1, kappa2, kappa3);
        give_2f(item2, 4, 6, down2, across2, step2, kappa4, kappa5);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_plucker_transfer_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    const ptrdiff_t down0 = CHASLES_STEP(4, 6 * sizeof(double));
    const ptrdiff_t across0 = CHASLES_STEP(5, 1 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    const ptrdiff_t down1 = CHASLES_STEP(6, 3 * sizeof(double));
    const ptrdiff_t across1 = CHASLES_STEP(7, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    const ptrdiff_t down2 = CHASLES_STEP(8, 3 * sizeof(double));
    const ptrdiff_t across2 = CHASLES_STEP(9, 1 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    const ptrdiff_t down3 = CHASLES_STEP(10, 6 * sizeof(double));
    const ptrdiff_t across3 = CHASLES_STEP(11, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles kappa_A[6];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 6);
        take_4(item0, 0, 6, down0, across0, step0, kappa_A);
        take_2(item0, 4, 6, down0, across0, step0, &kappa_A[4]);
        doubles a[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3);
        take_3(item1, 0, 3, down1, across1, step1, a);
        doubles b[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3);
        take_3(item2, 0, 3, down2, across2, step2, b);
        const doubles kappa_B0 = kappa_A[0];
        const doubles kappa_B1 = kappa_A[1];
        const doubles kappa_B2 = kappa_A[2];
        const doubles t1 = a[0] - b[0];
        const doubles t2 = a[1] - b[1];
        const doubles t3 = a[2] - b[2];
        const doubles kappa_B3 = kappa_A[3] + (kappa_B2 * t2 - kappa_B1 * t3);
        const doubles kappa_B4 = kappa_A[4] + (kappa_B0 * t3 - kappa_B2 * t1);
        const doubles kappa_B5 = kappa_A[5] + (kappa_B1 * t1 - kappa_B0 * t2);
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, 6);
        give_4(item3, 0, 6, down3, across3, step3, kappa_B0, kappa_B1, kappa_B2, kappa_B3);
        give_2(item3, 4, 6, down3, across3, step3, kappa_B4, kappa_B5);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_plucker_transfer_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    const ptrdiff_t down0 = CHASLES_STEP(4, 6 * sizeof(float));
    const ptrdiff_t across0 = CHASLES_STEP(5, 1 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    const ptrdiff_t down1 = CHASLES_STEP(6, 3 * sizeof(float));
    const ptrdiff_t across1 = CHASLES_STEP(7, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    const ptrdiff_t down2 = CHASLES_STEP(8, 3 * sizeof(float));
    const ptrdiff_t across2 = CHASLES_STEP(9, 1 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    const ptrdiff_t down3 = CHASLES_STEP(10, 6 * sizeof(float));
    const ptrdiff_t across3 = CHASLES_STEP(11, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats kappa_A[6];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 6);
        take_4f(item0, 0, 6, down0, across0, step0, kappa_A);
        take_2f(item0, 4, 6, down0, across0, step0, &kappa_A[4]);
        floats a[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3);
        take_3f(item1, 0, 3, down1, across1, step1, a);
        floats b[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3);
        take_3f(item2, 0, 3, down2, across2, step2, b);
        const floats kappa_B0 = kappa_A[0];
        const floats kappa_B1 = kappa_A[1];
        const floats kappa_B2 = kappa_A[2];
        const floats t1 = a[0] - b[0];
        const floats t2 = a[1] - b[1];
        const floats t3 = a[2] - b[2];
        const floats kappa_B3 = kappa_A[3] + (kappa_B2 * t2 - kappa_B1 * t3);
        const floats kappa_B4 = kappa_A[4] + (kappa_B0 * t3 - kappa_B2 * t1);
        const floats kappa_B5 = kappa_A[5] + (kappa_B1 * t1 - kappa_B0 * t2);
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, 6);
        give_4f(item3, 0, 6, down3, across3, step3, kappa_B0, kappa_B1, kappa_B2, kappa_B3);
        give_2f(item3, 4, 6, down3, across3, step3, kappa_B4, kappa_B5);
        stream_lines(&copied);
    }
}

#else

void CHASLES_LEVELED(chasles_plucker_line_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_plucker_line(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_plucker_line_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_plucker_linef(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_plucker_transfer_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_plucker_transfer(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_plucker_transfer_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_plucker_transferf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

#endif
