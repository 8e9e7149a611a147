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

CHASLES_INLINE void chasles_plucker_line_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles p_1[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &p_1[0]);
        } else if (step0 == sizeof(double)) {
            p_1[0] = PACKED_IN(item0 + entries0[0], 0);
            p_1[1] = PACKED_IN(item0 + entries0[1], 0);
            p_1[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            p_1[0] = all[0];
            p_1[1] = all[1];
            p_1[2] = all[2];
        }
        doubles p_2[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &p_2[0]);
        } else if (step1 == sizeof(double)) {
            p_2[0] = PACKED_IN(item1 + entries1[0], 0);
            p_2[1] = PACKED_IN(item1 + entries1[1], 0);
            p_2[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            p_2[0] = all[0];
            p_2[1] = all[1];
            p_2[2] = all[2];
        }
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
        prefetch_to_write(item2, step2, 6, sizeof(double), copied.ahead);
        const doubles result2[] = {kappa0, kappa1, kappa2, kappa3, kappa4, kappa5};
        if (dense2) {
            store_all(item2, step2, 6, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
            PACKED(item2 + entries2[3], 0) = result2[3];
            PACKED(item2 + entries2[4], 0) = result2[4];
            PACKED(item2 + entries2[5], 0) = result2[5];
        } else {
            give_each(item2, entries2, step2, 6, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_plucker_line_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_plucker_line_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_plucker_line_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats p_1[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &p_1[0]);
        } else if (step0 == sizeof(float)) {
            p_1[0] = PACKEDF_IN(item0 + entries0[0], 0);
            p_1[1] = PACKEDF_IN(item0 + entries0[1], 0);
            p_1[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            p_1[0] = all[0];
            p_1[1] = all[1];
            p_1[2] = all[2];
        }
        floats p_2[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &p_2[0]);
        } else if (step1 == sizeof(float)) {
            p_2[0] = PACKEDF_IN(item1 + entries1[0], 0);
            p_2[1] = PACKEDF_IN(item1 + entries1[1], 0);
            p_2[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            p_2[0] = all[0];
            p_2[1] = all[1];
            p_2[2] = all[2];
        }
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
        prefetch_to_write(item2, step2, 6, sizeof(float), copied.ahead);
        const floats result2[] = {kappa0, kappa1, kappa2, kappa3, kappa4, kappa5};
        if (dense2) {
            store_allf(item2, step2, 6, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
            PACKEDF(item2 + entries2[3], 0) = result2[3];
            PACKEDF(item2 + entries2[4], 0) = result2[4];
            PACKEDF(item2 + entries2[5], 0) = result2[5];
        } else {
            give_eachf(item2, entries2, step2, 6, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_plucker_line_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_plucker_line_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_plucker_transfer_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step1, steps + 6, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles kappa_A[6];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &kappa_A[0]);
            load_2(item0 + 4 * sizeof(double), step0, &kappa_A[4]);
        } else if (step0 == sizeof(double)) {
            kappa_A[0] = PACKED_IN(item0 + entries0[0], 0);
            kappa_A[1] = PACKED_IN(item0 + entries0[1], 0);
            kappa_A[2] = PACKED_IN(item0 + entries0[2], 0);
            kappa_A[3] = PACKED_IN(item0 + entries0[3], 0);
            kappa_A[4] = PACKED_IN(item0 + entries0[4], 0);
            kappa_A[5] = PACKED_IN(item0 + entries0[5], 0);
        } else {
            doubles all[6];
            take_each(item0, entries0, step0, 6, all);
            kappa_A[0] = all[0];
            kappa_A[1] = all[1];
            kappa_A[2] = all[2];
            kappa_A[3] = all[3];
            kappa_A[4] = all[4];
            kappa_A[5] = all[5];
        }
        doubles a[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &a[0]);
        } else if (step1 == sizeof(double)) {
            a[0] = PACKED_IN(item1 + entries1[0], 0);
            a[1] = PACKED_IN(item1 + entries1[1], 0);
            a[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            a[0] = all[0];
            a[1] = all[1];
            a[2] = all[2];
        }
        doubles b[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &b[0]);
        } else if (step2 == sizeof(double)) {
            b[0] = PACKED_IN(item2 + entries2[0], 0);
            b[1] = PACKED_IN(item2 + entries2[1], 0);
            b[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            b[0] = all[0];
            b[1] = all[1];
            b[2] = all[2];
        }
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
        prefetch_to_write(item3, step3, 6, sizeof(double), copied.ahead);
        const doubles result3[] = {kappa_B0, kappa_B1, kappa_B2, kappa_B3, kappa_B4, kappa_B5};
        if (dense3) {
            store_all(item3, step3, 6, result3);
        } else if (step3 == sizeof(double)) {
            PACKED(item3 + entries3[0], 0) = result3[0];
            PACKED(item3 + entries3[1], 0) = result3[1];
            PACKED(item3 + entries3[2], 0) = result3[2];
            PACKED(item3 + entries3[3], 0) = result3[3];
            PACKED(item3 + entries3[4], 0) = result3[4];
            PACKED(item3 + entries3[5], 0) = result3[5];
        } else {
            give_each(item3, entries3, step3, 6, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_plucker_transfer_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(double), steps[0], steps + 4)
        && is_packed(3, 3, sizeof(double), steps[1], steps + 6)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 8)
        && is_packed(6, 6, sizeof(double), steps[3], steps + 10)) {
        chasles_plucker_transfer_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_plucker_transfer_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_plucker_transfer_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step1, steps + 6, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats kappa_A[6];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &kappa_A[0]);
            load_2f(item0 + 4 * sizeof(float), step0, &kappa_A[4]);
        } else if (step0 == sizeof(float)) {
            kappa_A[0] = PACKEDF_IN(item0 + entries0[0], 0);
            kappa_A[1] = PACKEDF_IN(item0 + entries0[1], 0);
            kappa_A[2] = PACKEDF_IN(item0 + entries0[2], 0);
            kappa_A[3] = PACKEDF_IN(item0 + entries0[3], 0);
            kappa_A[4] = PACKEDF_IN(item0 + entries0[4], 0);
            kappa_A[5] = PACKEDF_IN(item0 + entries0[5], 0);
        } else {
            floats all[6];
            take_eachf(item0, entries0, step0, 6, all);
            kappa_A[0] = all[0];
            kappa_A[1] = all[1];
            kappa_A[2] = all[2];
            kappa_A[3] = all[3];
            kappa_A[4] = all[4];
            kappa_A[5] = all[5];
        }
        floats a[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &a[0]);
        } else if (step1 == sizeof(float)) {
            a[0] = PACKEDF_IN(item1 + entries1[0], 0);
            a[1] = PACKEDF_IN(item1 + entries1[1], 0);
            a[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            a[0] = all[0];
            a[1] = all[1];
            a[2] = all[2];
        }
        floats b[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &b[0]);
        } else if (step2 == sizeof(float)) {
            b[0] = PACKEDF_IN(item2 + entries2[0], 0);
            b[1] = PACKEDF_IN(item2 + entries2[1], 0);
            b[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            b[0] = all[0];
            b[1] = all[1];
            b[2] = all[2];
        }
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
        prefetch_to_write(item3, step3, 6, sizeof(float), copied.ahead);
        const floats result3[] = {kappa_B0, kappa_B1, kappa_B2, kappa_B3, kappa_B4, kappa_B5};
        if (dense3) {
            store_allf(item3, step3, 6, result3);
        } else if (step3 == sizeof(float)) {
            PACKEDF(item3 + entries3[0], 0) = result3[0];
            PACKEDF(item3 + entries3[1], 0) = result3[1];
            PACKEDF(item3 + entries3[2], 0) = result3[2];
            PACKEDF(item3 + entries3[3], 0) = result3[3];
            PACKEDF(item3 + entries3[4], 0) = result3[4];
            PACKEDF(item3 + entries3[5], 0) = result3[5];
        } else {
            give_eachf(item3, entries3, step3, 6, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_plucker_transfer_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(float), steps[0], steps + 4)
        && is_packed(3, 3, sizeof(float), steps[1], steps + 6)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 8)
        && is_packed(6, 6, sizeof(float), steps[3], steps + 10)) {
        chasles_plucker_transfer_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_plucker_transfer_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

#else

void CHASLES_LEVELED(chasles_plucker_line_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
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
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
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
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
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
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
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
