/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_4_1, for batches. Made by `chasles emit`; not to be edited by hand.
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

void CHASLES_LEVELED(chasles_instant_screw_point_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    const ptrdiff_t down0 = CHASLES_STEP(4, 3 * sizeof(double));
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    const ptrdiff_t down3 = CHASLES_STEP(10, 3 * sizeof(double));
    const ptrdiff_t across3 = CHASLES_STEP(11, 1 * sizeof(double));
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
        const doubles t1 = choose(less(omega[0], spread(0.0)), -omega[0], omega[0]);
        const doubles t2 = choose(less(omega[1], spread(0.0)), -omega[1], omega[1]);
        const doubles t3 = choose(less(t1, t2), t2, t1);
        const doubles t4 = choose(less(omega[2], spread(0.0)), -omega[2], omega[2]);
        const doubles t5 = choose(less(t3, t4), t4, t3);
        const doubles t6 = choose(equal(spread(0.0), t5), spread(1.0), t5);
        const doubles t7 = omega[0] / t6;
        const doubles t8 = omega[1] / t6;
        const doubles t9 = omega[2] / t6;
        const doubles t10 = t7 * t7 + t8 * t8 + t9 * t9;
        const doubles t11 = a_dot[0] - (omega[1] * a[2] - omega[2] * a[1]);
        const doubles t12 = a_dot[1] - (omega[2] * a[0] - omega[0] * a[2]);
        const doubles t13 = a_dot[2] - (omega[0] * a[1] - omega[1] * a[0]);
        const truths t14 = equal(t10, spread(0.0));
        const doubles p_0_prime0 = choose(t14, spread(0.0), t8 * t13 - t9 * t12) / t10 / t6;
        const doubles p_0_prime1 = choose(t14, spread(0.0), t9 * t11 - t7 * t13) / t10 / t6;
        const doubles p_0_prime2 = choose(t14, spread(0.0), t7 * t12 - t8 * t11) / t10 / t6;
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, 3);
        give_3(item3, 0, 3, down3, across3, step3, p_0_prime0, p_0_prime1, p_0_prime2);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_instant_screw_point_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    const ptrdiff_t down0 = CHASLES_STEP(4, 3 * sizeof(float));
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    const ptrdiff_t down3 = CHASLES_STEP(10, 3 * sizeof(float));
    const ptrdiff_t across3 = CHASLES_STEP(11, 1 * sizeof(float));
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
        const floats t1 = choosef(lessf(omega[0], spreadf(0.0f)), -omega[0], omega[0]);
        const floats t2 = choosef(lessf(omega[1], spreadf(0.0f)), -omega[1], omega[1]);
        const floats t3 = choosef(lessf(t1, t2), t2, t1);
        const floats t4 = choosef(lessf(omega[2], spreadf(0.0f)), -omega[2], omega[2]);
        const floats t5 = choosef(lessf(t3, t4), t4, t3);
        const floats t6 = choosef(equalf(spreadf(0.0f), t5), spreadf(1.0f), t5);
        const floats t7 = omega[0] / t6;
        const floats t8 = omega[1] / t6;
        const floats t9 = omega[2] / t6;
        const floats t10 = t7 * t7 + t8 * t8 + t9 * t9;
        const floats t11 = a_dot[0] - (omega[1] * a[2] - omega[2] * a[1]);
        const floats t12 = a_dot[1] - (omega[2] * a[0] - omega[0] * a[2]);
        const floats t13 = a_dot[2] - (omega[0] * a[1] - omega[1] * a[0]);
        const truthsf t14 = equalf(t10, spreadf(0.0f));
        const floats p_0_prime0 = choosef(t14, spreadf(0.0f), t8 * t13 - t9 * t12) / t10 / t6;
        const floats p_0_prime1 = choosef(t14, spreadf(0.0f), t9 * t11 - t7 * t13) / t10 / t6;
        const floats p_0_prime2 = choosef(t14, spreadf(0.0f), t7 * t12 - t8 * t11) / t10 / t6;
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, 3);
        give_3f(item3, 0, 3, down3, across3, step3, p_0_prime0, p_0_prime1, p_0_prime2);
        stream_lines(&copied);
    }
}

#else

void CHASLES_LEVELED(chasles_instant_screw_point_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_instant_screw_point(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_instant_screw_point_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_instant_screw_pointf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

#endif
