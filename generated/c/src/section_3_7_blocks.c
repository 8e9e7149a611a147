/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_7, for batches. Made by `chasles emit`; not to be edited by hand.
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

CHASLES_INLINE void chasles_wrench_axis_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step1, steps + 7, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles f[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &f[0]);
        } else if (step0 == sizeof(double)) {
            f[0] = PACKED_IN(item0 + entries0[0], 0);
            f[1] = PACKED_IN(item0 + entries0[1], 0);
            f[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            f[0] = all[0];
            f[1] = all[1];
            f[2] = all[2];
        }
        doubles n_A[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &n_A[0]);
        } else if (step1 == sizeof(double)) {
            n_A[0] = PACKED_IN(item1 + entries1[0], 0);
            n_A[1] = PACKED_IN(item1 + entries1[1], 0);
            n_A[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            n_A[0] = all[0];
            n_A[1] = all[1];
            n_A[2] = all[2];
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
        const doubles t1 = choose(less(f[0], spread(0.0)), -f[0], f[0]);
        const doubles t2 = choose(less(f[1], spread(0.0)), -f[1], f[1]);
        const doubles t3 = choose(less(t1, t2), t2, t1);
        const doubles t4 = choose(less(f[2], spread(0.0)), -f[2], f[2]);
        const doubles t5 = choose(less(t3, t4), t4, t3);
        const doubles t6 = choose(equal(spread(0.0), t5), spread(1.0), t5);
        const doubles t7 = f[0] / t6;
        const doubles t8 = f[1] / t6;
        const doubles t9 = f[2] / t6;
        const doubles t10 = t7 * t7 + t8 * t8 + t9 * t9;
        const doubles t11 = roots(t10);
        const truths t12 = equal(t10, spread(0.0));
        const doubles axis0 = choose(t12, spread(0.0), t7) / t11;
        const doubles axis1 = choose(t12, spread(0.0), t8) / t11;
        const doubles axis2 = choose(t12, spread(0.0), t9) / t11;
        const doubles t13 = choose(t12, spread(0.0), n_A[0]) / t11;
        const doubles t14 = choose(t12, spread(0.0), n_A[1]) / t11;
        const doubles t15 = choose(t12, spread(0.0), n_A[2]) / t11;
        const doubles t16 = a[0] + (axis1 * t15 - axis2 * t14) / t6;
        const doubles t17 = a[1] + (axis2 * t13 - axis0 * t15) / t6;
        const doubles t18 = a[2] + (axis0 * t14 - axis1 * t13) / t6;
        const doubles axis3 = axis2 * t17 - axis1 * t18;
        const doubles axis4 = axis0 * t18 - axis2 * t16;
        const doubles axis5 = axis1 * t16 - axis0 * t17;
        const doubles pitch_value = (axis0 * t13 + axis1 * t14 + axis2 * t15) / t6;
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 6, sizeof(double), copied.ahead);
        const doubles result3[] = {axis0, axis1, axis2, axis3, axis4, axis5};
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
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 1, sizeof(double), copied.ahead);
        store_1(item4, step4, pitch_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_wrench_axis_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_wrench_axis_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_wrench_axis_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step1, steps + 7, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats f[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &f[0]);
        } else if (step0 == sizeof(float)) {
            f[0] = PACKEDF_IN(item0 + entries0[0], 0);
            f[1] = PACKEDF_IN(item0 + entries0[1], 0);
            f[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            f[0] = all[0];
            f[1] = all[1];
            f[2] = all[2];
        }
        floats n_A[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &n_A[0]);
        } else if (step1 == sizeof(float)) {
            n_A[0] = PACKEDF_IN(item1 + entries1[0], 0);
            n_A[1] = PACKEDF_IN(item1 + entries1[1], 0);
            n_A[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            n_A[0] = all[0];
            n_A[1] = all[1];
            n_A[2] = all[2];
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
        const floats t1 = choosef(lessf(f[0], spreadf(0.0f)), -f[0], f[0]);
        const floats t2 = choosef(lessf(f[1], spreadf(0.0f)), -f[1], f[1]);
        const floats t3 = choosef(lessf(t1, t2), t2, t1);
        const floats t4 = choosef(lessf(f[2], spreadf(0.0f)), -f[2], f[2]);
        const floats t5 = choosef(lessf(t3, t4), t4, t3);
        const floats t6 = choosef(equalf(spreadf(0.0f), t5), spreadf(1.0f), t5);
        const floats t7 = f[0] / t6;
        const floats t8 = f[1] / t6;
        const floats t9 = f[2] / t6;
        const floats t10 = t7 * t7 + t8 * t8 + t9 * t9;
        const floats t11 = rootsf(t10);
        const truthsf t12 = equalf(t10, spreadf(0.0f));
        const floats axis0 = choosef(t12, spreadf(0.0f), t7) / t11;
        const floats axis1 = choosef(t12, spreadf(0.0f), t8) / t11;
        const floats axis2 = choosef(t12, spreadf(0.0f), t9) / t11;
        const floats t13 = choosef(t12, spreadf(0.0f), n_A[0]) / t11;
        const floats t14 = choosef(t12, spreadf(0.0f), n_A[1]) / t11;
        const floats t15 = choosef(t12, spreadf(0.0f), n_A[2]) / t11;
        const floats t16 = a[0] + (axis1 * t15 - axis2 * t14) / t6;
        const floats t17 = a[1] + (axis2 * t13 - axis0 * t15) / t6;
        const floats t18 = a[2] + (axis0 * t14 - axis1 * t13) / t6;
        const floats axis3 = axis2 * t17 - axis1 * t18;
        const floats axis4 = axis0 * t18 - axis2 * t16;
        const floats axis5 = axis1 * t16 - axis0 * t17;
        const floats pitch_value = (axis0 * t13 + axis1 * t14 + axis2 * t15) / t6;
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 6, sizeof(float), copied.ahead);
        const floats result3[] = {axis0, axis1, axis2, axis3, axis4, axis5};
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
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 1, sizeof(float), copied.ahead);
        store_1f(item4, step4, pitch_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_wrench_axis_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_wrench_axis_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_power_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 6 * sizeof(double));
    ptrdiff_t entries1[6];
    const int dense1 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles t[6];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &t[0]);
            load_2(item0 + 4 * sizeof(double), step0, &t[4]);
        } else if (step0 == sizeof(double)) {
            t[0] = PACKED_IN(item0 + entries0[0], 0);
            t[1] = PACKED_IN(item0 + entries0[1], 0);
            t[2] = PACKED_IN(item0 + entries0[2], 0);
            t[3] = PACKED_IN(item0 + entries0[3], 0);
            t[4] = PACKED_IN(item0 + entries0[4], 0);
            t[5] = PACKED_IN(item0 + entries0[5], 0);
        } else {
            doubles all[6];
            take_each(item0, entries0, step0, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
            t[3] = all[3];
            t[4] = all[4];
            t[5] = all[5];
        }
        doubles w[6];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 6, copied.ahead);
        if (dense1) {
            load_4(item1 + 0 * sizeof(double), step1, &w[0]);
            load_2(item1 + 4 * sizeof(double), step1, &w[4]);
        } else if (step1 == sizeof(double)) {
            w[0] = PACKED_IN(item1 + entries1[0], 0);
            w[1] = PACKED_IN(item1 + entries1[1], 0);
            w[2] = PACKED_IN(item1 + entries1[2], 0);
            w[3] = PACKED_IN(item1 + entries1[3], 0);
            w[4] = PACKED_IN(item1 + entries1[4], 0);
            w[5] = PACKED_IN(item1 + entries1[5], 0);
        } else {
            doubles all[6];
            take_each(item1, entries1, step1, 6, all);
            w[0] = all[0];
            w[1] = all[1];
            w[2] = all[2];
            w[3] = all[3];
            w[4] = all[4];
            w[5] = all[5];
        }
        const doubles t1 = t[0] * w[0] + t[1] * w[1] + t[2] * w[2] + t[3] * w[3] + t[4] * w[4];
        const doubles Pi_value = t1 + t[5] * w[5];
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 1, sizeof(double), copied.ahead);
        store_1(item2, step2, Pi_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_power_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(double), steps[0], steps + 3)
        && is_packed(6, 6, sizeof(double), steps[1], steps + 5)
        && is_packed(1, 1, sizeof(double), steps[2], steps + 7)) {
        chasles_power_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_power_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_power_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 6 * sizeof(float));
    ptrdiff_t entries1[6];
    const int dense1 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats t[6];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &t[0]);
            load_2f(item0 + 4 * sizeof(float), step0, &t[4]);
        } else if (step0 == sizeof(float)) {
            t[0] = PACKEDF_IN(item0 + entries0[0], 0);
            t[1] = PACKEDF_IN(item0 + entries0[1], 0);
            t[2] = PACKEDF_IN(item0 + entries0[2], 0);
            t[3] = PACKEDF_IN(item0 + entries0[3], 0);
            t[4] = PACKEDF_IN(item0 + entries0[4], 0);
            t[5] = PACKEDF_IN(item0 + entries0[5], 0);
        } else {
            floats all[6];
            take_eachf(item0, entries0, step0, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
            t[3] = all[3];
            t[4] = all[4];
            t[5] = all[5];
        }
        floats w[6];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 6, copied.ahead);
        if (dense1) {
            load_4f(item1 + 0 * sizeof(float), step1, &w[0]);
            load_2f(item1 + 4 * sizeof(float), step1, &w[4]);
        } else if (step1 == sizeof(float)) {
            w[0] = PACKEDF_IN(item1 + entries1[0], 0);
            w[1] = PACKEDF_IN(item1 + entries1[1], 0);
            w[2] = PACKEDF_IN(item1 + entries1[2], 0);
            w[3] = PACKEDF_IN(item1 + entries1[3], 0);
            w[4] = PACKEDF_IN(item1 + entries1[4], 0);
            w[5] = PACKEDF_IN(item1 + entries1[5], 0);
        } else {
            floats all[6];
            take_eachf(item1, entries1, step1, 6, all);
            w[0] = all[0];
            w[1] = all[1];
            w[2] = all[2];
            w[3] = all[3];
            w[4] = all[4];
            w[5] = all[5];
        }
        const floats t1 = t[0] * w[0] + t[1] * w[1] + t[2] * w[2] + t[3] * w[3] + t[4] * w[4];
        const floats Pi_value = t1 + t[5] * w[5];
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 1, sizeof(float), copied.ahead);
        store_1f(item2, step2, Pi_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_power_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(float), steps[0], steps + 3)
        && is_packed(6, 6, sizeof(float), steps[1], steps + 5)
        && is_packed(1, 1, sizeof(float), steps[2], steps + 7)) {
        chasles_power_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_power_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_reciprocal_product_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 6 * sizeof(double));
    ptrdiff_t entries1[6];
    const int dense1 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles s_w[6];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &s_w[0]);
            load_2(item0 + 4 * sizeof(double), step0, &s_w[4]);
        } else if (step0 == sizeof(double)) {
            s_w[0] = PACKED_IN(item0 + entries0[0], 0);
            s_w[1] = PACKED_IN(item0 + entries0[1], 0);
            s_w[2] = PACKED_IN(item0 + entries0[2], 0);
            s_w[3] = PACKED_IN(item0 + entries0[3], 0);
            s_w[4] = PACKED_IN(item0 + entries0[4], 0);
            s_w[5] = PACKED_IN(item0 + entries0[5], 0);
        } else {
            doubles all[6];
            take_each(item0, entries0, step0, 6, all);
            s_w[0] = all[0];
            s_w[1] = all[1];
            s_w[2] = all[2];
            s_w[3] = all[3];
            s_w[4] = all[4];
            s_w[5] = all[5];
        }
        doubles s_t[6];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 6, copied.ahead);
        if (dense1) {
            load_4(item1 + 0 * sizeof(double), step1, &s_t[0]);
            load_2(item1 + 4 * sizeof(double), step1, &s_t[4]);
        } else if (step1 == sizeof(double)) {
            s_t[0] = PACKED_IN(item1 + entries1[0], 0);
            s_t[1] = PACKED_IN(item1 + entries1[1], 0);
            s_t[2] = PACKED_IN(item1 + entries1[2], 0);
            s_t[3] = PACKED_IN(item1 + entries1[3], 0);
            s_t[4] = PACKED_IN(item1 + entries1[4], 0);
            s_t[5] = PACKED_IN(item1 + entries1[5], 0);
        } else {
            doubles all[6];
            take_each(item1, entries1, step1, 6, all);
            s_t[0] = all[0];
            s_t[1] = all[1];
            s_t[2] = all[2];
            s_t[3] = all[3];
            s_t[4] = all[4];
            s_t[5] = all[5];
        }
        const doubles t1 = s_w[0] * s_t[3] + s_w[1] * s_t[4] + s_w[2] * s_t[5] + s_w[3] * s_t[0];
        const doubles product_value = t1 + s_w[4] * s_t[1] + s_w[5] * s_t[2];
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 1, sizeof(double), copied.ahead);
        store_1(item2, step2, product_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_reciprocal_product_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(double), steps[0], steps + 3)
        && is_packed(6, 6, sizeof(double), steps[1], steps + 5)
        && is_packed(1, 1, sizeof(double), steps[2], steps + 7)) {
        chasles_reciprocal_product_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_reciprocal_product_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_reciprocal_product_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 6 * sizeof(float));
    ptrdiff_t entries1[6];
    const int dense1 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats s_w[6];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &s_w[0]);
            load_2f(item0 + 4 * sizeof(float), step0, &s_w[4]);
        } else if (step0 == sizeof(float)) {
            s_w[0] = PACKEDF_IN(item0 + entries0[0], 0);
            s_w[1] = PACKEDF_IN(item0 + entries0[1], 0);
            s_w[2] = PACKEDF_IN(item0 + entries0[2], 0);
            s_w[3] = PACKEDF_IN(item0 + entries0[3], 0);
            s_w[4] = PACKEDF_IN(item0 + entries0[4], 0);
            s_w[5] = PACKEDF_IN(item0 + entries0[5], 0);
        } else {
            floats all[6];
            take_eachf(item0, entries0, step0, 6, all);
            s_w[0] = all[0];
            s_w[1] = all[1];
            s_w[2] = all[2];
            s_w[3] = all[3];
            s_w[4] = all[4];
            s_w[5] = all[5];
        }
        floats s_t[6];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 6, copied.ahead);
        if (dense1) {
            load_4f(item1 + 0 * sizeof(float), step1, &s_t[0]);
            load_2f(item1 + 4 * sizeof(float), step1, &s_t[4]);
        } else if (step1 == sizeof(float)) {
            s_t[0] = PACKEDF_IN(item1 + entries1[0], 0);
            s_t[1] = PACKEDF_IN(item1 + entries1[1], 0);
            s_t[2] = PACKEDF_IN(item1 + entries1[2], 0);
            s_t[3] = PACKEDF_IN(item1 + entries1[3], 0);
            s_t[4] = PACKEDF_IN(item1 + entries1[4], 0);
            s_t[5] = PACKEDF_IN(item1 + entries1[5], 0);
        } else {
            floats all[6];
            take_eachf(item1, entries1, step1, 6, all);
            s_t[0] = all[0];
            s_t[1] = all[1];
            s_t[2] = all[2];
            s_t[3] = all[3];
            s_t[4] = all[4];
            s_t[5] = all[5];
        }
        const floats t1 = s_w[0] * s_t[3] + s_w[1] * s_t[4] + s_w[2] * s_t[5] + s_w[3] * s_t[0];
        const floats product_value = t1 + s_w[4] * s_t[1] + s_w[5] * s_t[2];
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 1, sizeof(float), copied.ahead);
        store_1f(item2, step2, product_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_reciprocal_product_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(float), steps[0], steps + 3)
        && is_packed(6, 6, sizeof(float), steps[1], steps + 5)
        && is_packed(1, 1, sizeof(float), steps[2], steps + 7)) {
        chasles_reciprocal_product_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_reciprocal_product_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_wrench_transfer_block_items(
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
        doubles w_A[6];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &w_A[0]);
            load_2(item0 + 4 * sizeof(double), step0, &w_A[4]);
        } else if (step0 == sizeof(double)) {
            w_A[0] = PACKED_IN(item0 + entries0[0], 0);
            w_A[1] = PACKED_IN(item0 + entries0[1], 0);
            w_A[2] = PACKED_IN(item0 + entries0[2], 0);
            w_A[3] = PACKED_IN(item0 + entries0[3], 0);
            w_A[4] = PACKED_IN(item0 + entries0[4], 0);
            w_A[5] = PACKED_IN(item0 + entries0[5], 0);
        } else {
            doubles all[6];
            take_each(item0, entries0, step0, 6, all);
            w_A[0] = all[0];
            w_A[1] = all[1];
            w_A[2] = all[2];
            w_A[3] = all[3];
            w_A[4] = all[4];
            w_A[5] = all[5];
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
        doubles p[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &p[0]);
        } else if (step2 == sizeof(double)) {
            p[0] = PACKED_IN(item2 + entries2[0], 0);
            p[1] = PACKED_IN(item2 + entries2[1], 0);
            p[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            p[0] = all[0];
            p[1] = all[1];
            p[2] = all[2];
        }
        const doubles w_P3 = w_A[3];
        const doubles w_P4 = w_A[4];
        const doubles w_P5 = w_A[5];
        const doubles t1 = a[0] - p[0];
        const doubles t2 = a[1] - p[1];
        const doubles t3 = a[2] - p[2];
        const doubles w_P0 = w_A[0] + (w_P5 * t2 - w_P4 * t3);
        const doubles w_P1 = w_A[1] + (w_P3 * t3 - w_P5 * t1);
        const doubles w_P2 = w_A[2] + (w_P4 * t1 - w_P3 * t2);
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 6, sizeof(double), copied.ahead);
        const doubles result3[] = {w_P0, w_P1, w_P2, w_P3, w_P4, w_P5};
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

void CHASLES_LEVELED(chasles_wrench_transfer_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(double), steps[0], steps + 4)
        && is_packed(3, 3, sizeof(double), steps[1], steps + 6)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 8)
        && is_packed(6, 6, sizeof(double), steps[3], steps + 10)) {
        chasles_wrench_transfer_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_wrench_transfer_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_wrench_transfer_blockf_items(
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
        floats w_A[6];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &w_A[0]);
            load_2f(item0 + 4 * sizeof(float), step0, &w_A[4]);
        } else if (step0 == sizeof(float)) {
            w_A[0] = PACKEDF_IN(item0 + entries0[0], 0);
            w_A[1] = PACKEDF_IN(item0 + entries0[1], 0);
            w_A[2] = PACKEDF_IN(item0 + entries0[2], 0);
            w_A[3] = PACKEDF_IN(item0 + entries0[3], 0);
            w_A[4] = PACKEDF_IN(item0 + entries0[4], 0);
            w_A[5] = PACKEDF_IN(item0 + entries0[5], 0);
        } else {
            floats all[6];
            take_eachf(item0, entries0, step0, 6, all);
            w_A[0] = all[0];
            w_A[1] = all[1];
            w_A[2] = all[2];
            w_A[3] = all[3];
            w_A[4] = all[4];
            w_A[5] = all[5];
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
        floats p[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &p[0]);
        } else if (step2 == sizeof(float)) {
            p[0] = PACKEDF_IN(item2 + entries2[0], 0);
            p[1] = PACKEDF_IN(item2 + entries2[1], 0);
            p[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            p[0] = all[0];
            p[1] = all[1];
            p[2] = all[2];
        }
        const floats w_P3 = w_A[3];
        const floats w_P4 = w_A[4];
        const floats w_P5 = w_A[5];
        const floats t1 = a[0] - p[0];
        const floats t2 = a[1] - p[1];
        const floats t3 = a[2] - p[2];
        const floats w_P0 = w_A[0] + (w_P5 * t2 - w_P4 * t3);
        const floats w_P1 = w_A[1] + (w_P3 * t3 - w_P5 * t1);
        const floats w_P2 = w_A[2] + (w_P4 * t1 - w_P3 * t2);
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 6, sizeof(float), copied.ahead);
        const floats result3[] = {w_P0, w_P1, w_P2, w_P3, w_P4, w_P5};
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

void CHASLES_LEVELED(chasles_wrench_transfer_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(float), steps[0], steps + 4)
        && is_packed(3, 3, sizeof(float), steps[1], steps + 6)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 8)
        && is_packed(6, 6, sizeof(float), steps[3], steps + 10)) {
        chasles_wrench_transfer_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_wrench_transfer_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

#else

void CHASLES_LEVELED(chasles_wrench_axis_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_wrench_axis(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_wrench_axis_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_wrench_axisf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_power_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_power(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_power_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_powerf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_reciprocal_product_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_reciprocal_product(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_reciprocal_product_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_reciprocal_productf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_wrench_transfer_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_wrench_transfer(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_wrench_transfer_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_wrench_transferf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

#endif
