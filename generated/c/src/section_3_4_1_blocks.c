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

CHASLES_INLINE void chasles_instant_screw_point_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step1, steps + 6, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &omega[0]);
        } else if (step0 == sizeof(double)) {
            omega[0] = PACKED_IN(item0 + entries0[0], 0);
            omega[1] = PACKED_IN(item0 + entries0[1], 0);
            omega[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        doubles a_dot[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &a_dot[0]);
        } else if (step1 == sizeof(double)) {
            a_dot[0] = PACKED_IN(item1 + entries1[0], 0);
            a_dot[1] = PACKED_IN(item1 + entries1[1], 0);
            a_dot[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            a_dot[0] = all[0];
            a_dot[1] = all[1];
            a_dot[2] = all[2];
        }
        doubles a[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &a[0]);
        } else if (step2 == sizeof(double)) {
            a[0] = PACKED_IN(item2 + entries2[0], 0);
            a[1] = PACKED_IN(item2 + entries2[1], 0);
            a[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            a[0] = all[0];
            a[1] = all[1];
            a[2] = all[2];
        }
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
        prefetch_to_write(item3, step3, 3, sizeof(double), copied.ahead);
        const doubles result3[] = {p_0_prime0, p_0_prime1, p_0_prime2};
        if (dense3) {
            store_all(item3, step3, 3, result3);
        } else if (step3 == sizeof(double)) {
            PACKED(item3 + entries3[0], 0) = result3[0];
            PACKED(item3 + entries3[1], 0) = result3[1];
            PACKED(item3 + entries3[2], 0) = result3[2];
        } else {
            give_each(item3, entries3, step3, 3, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_instant_screw_point_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_instant_screw_point_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_instant_screw_point_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step1, steps + 6, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &omega[0]);
        } else if (step0 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item0 + entries0[0], 0);
            omega[1] = PACKEDF_IN(item0 + entries0[1], 0);
            omega[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        floats a_dot[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &a_dot[0]);
        } else if (step1 == sizeof(float)) {
            a_dot[0] = PACKEDF_IN(item1 + entries1[0], 0);
            a_dot[1] = PACKEDF_IN(item1 + entries1[1], 0);
            a_dot[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            a_dot[0] = all[0];
            a_dot[1] = all[1];
            a_dot[2] = all[2];
        }
        floats a[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &a[0]);
        } else if (step2 == sizeof(float)) {
            a[0] = PACKEDF_IN(item2 + entries2[0], 0);
            a[1] = PACKEDF_IN(item2 + entries2[1], 0);
            a[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            a[0] = all[0];
            a[1] = all[1];
            a[2] = all[2];
        }
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
        prefetch_to_write(item3, step3, 3, sizeof(float), copied.ahead);
        const floats result3[] = {p_0_prime0, p_0_prime1, p_0_prime2};
        if (dense3) {
            store_allf(item3, step3, 3, result3);
        } else if (step3 == sizeof(float)) {
            PACKEDF(item3 + entries3[0], 0) = result3[0];
            PACKEDF(item3 + entries3[1], 0) = result3[1];
            PACKEDF(item3 + entries3[2], 0) = result3[2];
        } else {
            give_eachf(item3, entries3, step3, 3, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_instant_screw_point_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_instant_screw_point_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

#else

void CHASLES_LEVELED(chasles_instant_screw_point_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
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
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
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
