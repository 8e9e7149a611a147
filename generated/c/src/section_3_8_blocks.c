/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_8, for batches. Made by `chasles emit`; not to be edited by hand.
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

CHASLES_INLINE void chasles_inertia_about_point_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 9 * sizeof(double));
    ptrdiff_t entries4[9];
    const int dense4 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &I_C[0]);
            load_4(item0 + 4 * sizeof(double), step0, &I_C[4]);
            load_1(item0 + 8 * sizeof(double), step0, &I_C[8]);
        } else if (step0 == sizeof(double)) {
            I_C[0] = PACKED_IN(item0 + entries0[0], 0);
            I_C[1] = PACKED_IN(item0 + entries0[1], 0);
            I_C[2] = PACKED_IN(item0 + entries0[2], 0);
            I_C[3] = PACKED_IN(item0 + entries0[3], 0);
            I_C[4] = PACKED_IN(item0 + entries0[4], 0);
            I_C[5] = PACKED_IN(item0 + entries0[5], 0);
            I_C[6] = PACKED_IN(item0 + entries0[6], 0);
            I_C[7] = PACKED_IN(item0 + entries0[7], 0);
            I_C[8] = PACKED_IN(item0 + entries0[8], 0);
        } else {
            doubles all[9];
            take_each(item0, entries0, step0, 9, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
            I_C[6] = all[6];
            I_C[7] = all[7];
            I_C[8] = all[8];
        }
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &m);
        doubles c[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &c[0]);
        } else if (step2 == sizeof(double)) {
            c[0] = PACKED_IN(item2 + entries2[0], 0);
            c[1] = PACKED_IN(item2 + entries2[1], 0);
            c[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            c[0] = all[0];
            c[1] = all[1];
            c[2] = all[2];
        }
        doubles a[3];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3(item3 + 0 * sizeof(double), step3, &a[0]);
        } else if (step3 == sizeof(double)) {
            a[0] = PACKED_IN(item3 + entries3[0], 0);
            a[1] = PACKED_IN(item3 + entries3[1], 0);
            a[2] = PACKED_IN(item3 + entries3[2], 0);
        } else {
            doubles all[3];
            take_each(item3, entries3, step3, 3, all);
            a[0] = all[0];
            a[1] = all[1];
            a[2] = all[2];
        }
        const doubles t1 = a[0] - c[0];
        const doubles t2 = a[1] - c[1];
        const doubles t3 = a[2] - c[2];
        const doubles t4 = m * t2;
        const doubles t5 = m * t3;
        const doubles t6 = t1 * (m * t1);
        const doubles t7 = t1 * t4;
        const doubles t8 = t1 * t5;
        const doubles t9 = t2 * t4;
        const doubles t10 = t2 * t5;
        const doubles t11 = t3 * t5;
        const doubles I_A0 = I_C[0] + (t9 + t11);
        const doubles I_A1 = I_C[1] - t7;
        const doubles I_A2 = I_C[2] - t8;
        const doubles I_A3 = I_C[3] - t7;
        const doubles I_A4 = I_C[4] + (t6 + t11);
        const doubles I_A5 = I_C[5] - t10;
        const doubles I_A6 = I_C[6] - t8;
        const doubles I_A7 = I_C[7] - t10;
        const doubles I_A8 = I_C[8] + (t6 + t9);
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 9, sizeof(double), copied.ahead);
        const doubles result4[] = {I_A0, I_A1, I_A2, I_A3, I_A4, I_A5, I_A6, I_A7, I_A8};
        if (dense4) {
            store_all(item4, step4, 9, result4);
        } else if (step4 == sizeof(double)) {
            PACKED(item4 + entries4[0], 0) = result4[0];
            PACKED(item4 + entries4[1], 0) = result4[1];
            PACKED(item4 + entries4[2], 0) = result4[2];
            PACKED(item4 + entries4[3], 0) = result4[3];
            PACKED(item4 + entries4[4], 0) = result4[4];
            PACKED(item4 + entries4[5], 0) = result4[5];
            PACKED(item4 + entries4[6], 0) = result4[6];
            PACKED(item4 + entries4[7], 0) = result4[7];
            PACKED(item4 + entries4[8], 0) = result4[8];
        } else {
            give_each(item4, entries4, step4, 9, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_inertia_about_point_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(double), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 7)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 9)
        && is_packed(3, 3, sizeof(double), steps[3], steps + 11)
        && is_packed(9, 3, sizeof(double), steps[4], steps + 13)) {
        chasles_inertia_about_point_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_inertia_about_point_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_inertia_about_point_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 9 * sizeof(float));
    ptrdiff_t entries4[9];
    const int dense4 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &I_C[0]);
            load_4f(item0 + 4 * sizeof(float), step0, &I_C[4]);
            load_1f(item0 + 8 * sizeof(float), step0, &I_C[8]);
        } else if (step0 == sizeof(float)) {
            I_C[0] = PACKEDF_IN(item0 + entries0[0], 0);
            I_C[1] = PACKEDF_IN(item0 + entries0[1], 0);
            I_C[2] = PACKEDF_IN(item0 + entries0[2], 0);
            I_C[3] = PACKEDF_IN(item0 + entries0[3], 0);
            I_C[4] = PACKEDF_IN(item0 + entries0[4], 0);
            I_C[5] = PACKEDF_IN(item0 + entries0[5], 0);
            I_C[6] = PACKEDF_IN(item0 + entries0[6], 0);
            I_C[7] = PACKEDF_IN(item0 + entries0[7], 0);
            I_C[8] = PACKEDF_IN(item0 + entries0[8], 0);
        } else {
            floats all[9];
            take_eachf(item0, entries0, step0, 9, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
            I_C[6] = all[6];
            I_C[7] = all[7];
            I_C[8] = all[8];
        }
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &m);
        floats c[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &c[0]);
        } else if (step2 == sizeof(float)) {
            c[0] = PACKEDF_IN(item2 + entries2[0], 0);
            c[1] = PACKEDF_IN(item2 + entries2[1], 0);
            c[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            c[0] = all[0];
            c[1] = all[1];
            c[2] = all[2];
        }
        floats a[3];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3f(item3 + 0 * sizeof(float), step3, &a[0]);
        } else if (step3 == sizeof(float)) {
            a[0] = PACKEDF_IN(item3 + entries3[0], 0);
            a[1] = PACKEDF_IN(item3 + entries3[1], 0);
            a[2] = PACKEDF_IN(item3 + entries3[2], 0);
        } else {
            floats all[3];
            take_eachf(item3, entries3, step3, 3, all);
            a[0] = all[0];
            a[1] = all[1];
            a[2] = all[2];
        }
        const floats t1 = a[0] - c[0];
        const floats t2 = a[1] - c[1];
        const floats t3 = a[2] - c[2];
        const floats t4 = m * t2;
        const floats t5 = m * t3;
        const floats t6 = t1 * (m * t1);
        const floats t7 = t1 * t4;
        const floats t8 = t1 * t5;
        const floats t9 = t2 * t4;
        const floats t10 = t2 * t5;
        const floats t11 = t3 * t5;
        const floats I_A0 = I_C[0] + (t9 + t11);
        const floats I_A1 = I_C[1] - t7;
        const floats I_A2 = I_C[2] - t8;
        const floats I_A3 = I_C[3] - t7;
        const floats I_A4 = I_C[4] + (t6 + t11);
        const floats I_A5 = I_C[5] - t10;
        const floats I_A6 = I_C[6] - t8;
        const floats I_A7 = I_C[7] - t10;
        const floats I_A8 = I_C[8] + (t6 + t9);
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 9, sizeof(float), copied.ahead);
        const floats result4[] = {I_A0, I_A1, I_A2, I_A3, I_A4, I_A5, I_A6, I_A7, I_A8};
        if (dense4) {
            store_allf(item4, step4, 9, result4);
        } else if (step4 == sizeof(float)) {
            PACKEDF(item4 + entries4[0], 0) = result4[0];
            PACKEDF(item4 + entries4[1], 0) = result4[1];
            PACKEDF(item4 + entries4[2], 0) = result4[2];
            PACKEDF(item4 + entries4[3], 0) = result4[3];
            PACKEDF(item4 + entries4[4], 0) = result4[4];
            PACKEDF(item4 + entries4[5], 0) = result4[5];
            PACKEDF(item4 + entries4[6], 0) = result4[6];
            PACKEDF(item4 + entries4[7], 0) = result4[7];
            PACKEDF(item4 + entries4[8], 0) = result4[8];
        } else {
            give_eachf(item4, entries4, step4, 9, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_inertia_about_point_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(float), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 7)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 9)
        && is_packed(3, 3, sizeof(float), steps[3], steps + 11)
        && is_packed(9, 3, sizeof(float), steps[4], steps + 13)) {
        chasles_inertia_about_point_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_inertia_about_point_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_inertia_about_point_sym6_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(double));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[6];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &I_C[0]);
            load_2(item0 + 4 * sizeof(double), step0, &I_C[4]);
        } else if (step0 == sizeof(double)) {
            I_C[0] = PACKED_IN(item0 + entries0[0], 0);
            I_C[1] = PACKED_IN(item0 + entries0[1], 0);
            I_C[2] = PACKED_IN(item0 + entries0[2], 0);
            I_C[3] = PACKED_IN(item0 + entries0[3], 0);
            I_C[4] = PACKED_IN(item0 + entries0[4], 0);
            I_C[5] = PACKED_IN(item0 + entries0[5], 0);
        } else {
            doubles all[6];
            take_each(item0, entries0, step0, 6, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
        }
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &m);
        doubles c[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &c[0]);
        } else if (step2 == sizeof(double)) {
            c[0] = PACKED_IN(item2 + entries2[0], 0);
            c[1] = PACKED_IN(item2 + entries2[1], 0);
            c[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            c[0] = all[0];
            c[1] = all[1];
            c[2] = all[2];
        }
        doubles a[3];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3(item3 + 0 * sizeof(double), step3, &a[0]);
        } else if (step3 == sizeof(double)) {
            a[0] = PACKED_IN(item3 + entries3[0], 0);
            a[1] = PACKED_IN(item3 + entries3[1], 0);
            a[2] = PACKED_IN(item3 + entries3[2], 0);
        } else {
            doubles all[3];
            take_each(item3, entries3, step3, 3, all);
            a[0] = all[0];
            a[1] = all[1];
            a[2] = all[2];
        }
        const doubles t1 = a[0] - c[0];
        const doubles t2 = a[1] - c[1];
        const doubles t3 = a[2] - c[2];
        const doubles t4 = m * t2;
        const doubles t5 = m * t3;
        const doubles t6 = t1 * (m * t1);
        const doubles t7 = t2 * t4;
        const doubles t8 = t3 * t5;
        const doubles I_A0 = I_C[0] + (t7 + t8);
        const doubles I_A1 = I_C[1] - t1 * t4;
        const doubles I_A2 = I_C[2] - t1 * t5;
        const doubles I_A3 = I_C[3] + (t6 + t8);
        const doubles I_A4 = I_C[4] - t2 * t5;
        const doubles I_A5 = I_C[5] + (t6 + t7);
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 6, sizeof(double), copied.ahead);
        const doubles result4[] = {I_A0, I_A1, I_A2, I_A3, I_A4, I_A5};
        if (dense4) {
            store_all(item4, step4, 6, result4);
        } else if (step4 == sizeof(double)) {
            PACKED(item4 + entries4[0], 0) = result4[0];
            PACKED(item4 + entries4[1], 0) = result4[1];
            PACKED(item4 + entries4[2], 0) = result4[2];
            PACKED(item4 + entries4[3], 0) = result4[3];
            PACKED(item4 + entries4[4], 0) = result4[4];
            PACKED(item4 + entries4[5], 0) = result4[5];
        } else {
            give_each(item4, entries4, step4, 6, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_inertia_about_point_sym6_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(double), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 7)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 9)
        && is_packed(3, 3, sizeof(double), steps[3], steps + 11)
        && is_packed(6, 6, sizeof(double), steps[4], steps + 13)) {
        chasles_inertia_about_point_sym6_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_inertia_about_point_sym6_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_inertia_about_point_sym6_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(float));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[6];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &I_C[0]);
            load_2f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        } else if (step0 == sizeof(float)) {
            I_C[0] = PACKEDF_IN(item0 + entries0[0], 0);
            I_C[1] = PACKEDF_IN(item0 + entries0[1], 0);
            I_C[2] = PACKEDF_IN(item0 + entries0[2], 0);
            I_C[3] = PACKEDF_IN(item0 + entries0[3], 0);
            I_C[4] = PACKEDF_IN(item0 + entries0[4], 0);
            I_C[5] = PACKEDF_IN(item0 + entries0[5], 0);
        } else {
            floats all[6];
            take_eachf(item0, entries0, step0, 6, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
        }
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &m);
        floats c[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &c[0]);
        } else if (step2 == sizeof(float)) {
            c[0] = PACKEDF_IN(item2 + entries2[0], 0);
            c[1] = PACKEDF_IN(item2 + entries2[1], 0);
            c[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            c[0] = all[0];
            c[1] = all[1];
            c[2] = all[2];
        }
        floats a[3];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3f(item3 + 0 * sizeof(float), step3, &a[0]);
        } else if (step3 == sizeof(float)) {
            a[0] = PACKEDF_IN(item3 + entries3[0], 0);
            a[1] = PACKEDF_IN(item3 + entries3[1], 0);
            a[2] = PACKEDF_IN(item3 + entries3[2], 0);
        } else {
            floats all[3];
            take_eachf(item3, entries3, step3, 3, all);
            a[0] = all[0];
            a[1] = all[1];
            a[2] = all[2];
        }
        const floats t1 = a[0] - c[0];
        const floats t2 = a[1] - c[1];
        const floats t3 = a[2] - c[2];
        const floats t4 = m * t2;
        const floats t5 = m * t3;
        const floats t6 = t1 * (m * t1);
        const floats t7 = t2 * t4;
        const floats t8 = t3 * t5;
        const floats I_A0 = I_C[0] + (t7 + t8);
        const floats I_A1 = I_C[1] - t1 * t4;
        const floats I_A2 = I_C[2] - t1 * t5;
        const floats I_A3 = I_C[3] + (t6 + t8);
        const floats I_A4 = I_C[4] - t2 * t5;
        const floats I_A5 = I_C[5] + (t6 + t7);
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 6, sizeof(float), copied.ahead);
        const floats result4[] = {I_A0, I_A1, I_A2, I_A3, I_A4, I_A5};
        if (dense4) {
            store_allf(item4, step4, 6, result4);
        } else if (step4 == sizeof(float)) {
            PACKEDF(item4 + entries4[0], 0) = result4[0];
            PACKEDF(item4 + entries4[1], 0) = result4[1];
            PACKEDF(item4 + entries4[2], 0) = result4[2];
            PACKEDF(item4 + entries4[3], 0) = result4[3];
            PACKEDF(item4 + entries4[4], 0) = result4[4];
            PACKEDF(item4 + entries4[5], 0) = result4[5];
        } else {
            give_eachf(item4, entries4, step4, 6, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_inertia_about_point_sym6_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(float), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 7)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 9)
        && is_packed(3, 3, sizeof(float), steps[3], steps + 11)
        && is_packed(6, 6, sizeof(float), steps[4], steps + 13)) {
        chasles_inertia_about_point_sym6_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_inertia_about_point_sym6_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_momentum_screw_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &I_C[0]);
            load_4(item0 + 4 * sizeof(double), step0, &I_C[4]);
            load_1(item0 + 8 * sizeof(double), step0, &I_C[8]);
        } else if (step0 == sizeof(double)) {
            I_C[0] = PACKED_IN(item0 + entries0[0], 0);
            I_C[1] = PACKED_IN(item0 + entries0[1], 0);
            I_C[2] = PACKED_IN(item0 + entries0[2], 0);
            I_C[3] = PACKED_IN(item0 + entries0[3], 0);
            I_C[4] = PACKED_IN(item0 + entries0[4], 0);
            I_C[5] = PACKED_IN(item0 + entries0[5], 0);
            I_C[6] = PACKED_IN(item0 + entries0[6], 0);
            I_C[7] = PACKED_IN(item0 + entries0[7], 0);
            I_C[8] = PACKED_IN(item0 + entries0[8], 0);
        } else {
            doubles all[9];
            take_each(item0, entries0, step0, 9, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
            I_C[6] = all[6];
            I_C[7] = all[7];
            I_C[8] = all[8];
        }
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4(item2 + 0 * sizeof(double), step2, &t[0]);
            load_2(item2 + 4 * sizeof(double), step2, &t[4]);
        } else if (step2 == sizeof(double)) {
            t[0] = PACKED_IN(item2 + entries2[0], 0);
            t[1] = PACKED_IN(item2 + entries2[1], 0);
            t[2] = PACKED_IN(item2 + entries2[2], 0);
            t[3] = PACKED_IN(item2 + entries2[3], 0);
            t[4] = PACKED_IN(item2 + entries2[4], 0);
            t[5] = PACKED_IN(item2 + entries2[5], 0);
        } else {
            doubles all[6];
            take_each(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
            t[3] = all[3];
            t[4] = all[4];
            t[5] = all[5];
        }
        const doubles mu0 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const doubles mu1 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const doubles mu2 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
        const doubles mu3 = m * t[3];
        const doubles mu4 = m * t[4];
        const doubles mu5 = m * t[5];
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 6, sizeof(double), copied.ahead);
        const doubles result3[] = {mu0, mu1, mu2, mu3, mu4, mu5};
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

void CHASLES_LEVELED(chasles_momentum_screw_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(double), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 6)
        && is_packed(6, 6, sizeof(double), steps[2], steps + 8)
        && is_packed(6, 6, sizeof(double), steps[3], steps + 10)) {
        chasles_momentum_screw_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_momentum_screw_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_momentum_screw_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &I_C[0]);
            load_4f(item0 + 4 * sizeof(float), step0, &I_C[4]);
            load_1f(item0 + 8 * sizeof(float), step0, &I_C[8]);
        } else if (step0 == sizeof(float)) {
            I_C[0] = PACKEDF_IN(item0 + entries0[0], 0);
            I_C[1] = PACKEDF_IN(item0 + entries0[1], 0);
            I_C[2] = PACKEDF_IN(item0 + entries0[2], 0);
            I_C[3] = PACKEDF_IN(item0 + entries0[3], 0);
            I_C[4] = PACKEDF_IN(item0 + entries0[4], 0);
            I_C[5] = PACKEDF_IN(item0 + entries0[5], 0);
            I_C[6] = PACKEDF_IN(item0 + entries0[6], 0);
            I_C[7] = PACKEDF_IN(item0 + entries0[7], 0);
            I_C[8] = PACKEDF_IN(item0 + entries0[8], 0);
        } else {
            floats all[9];
            take_eachf(item0, entries0, step0, 9, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
            I_C[6] = all[6];
            I_C[7] = all[7];
            I_C[8] = all[8];
        }
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4f(item2 + 0 * sizeof(float), step2, &t[0]);
            load_2f(item2 + 4 * sizeof(float), step2, &t[4]);
        } else if (step2 == sizeof(float)) {
            t[0] = PACKEDF_IN(item2 + entries2[0], 0);
            t[1] = PACKEDF_IN(item2 + entries2[1], 0);
            t[2] = PACKEDF_IN(item2 + entries2[2], 0);
            t[3] = PACKEDF_IN(item2 + entries2[3], 0);
            t[4] = PACKEDF_IN(item2 + entries2[4], 0);
            t[5] = PACKEDF_IN(item2 + entries2[5], 0);
        } else {
            floats all[6];
            take_eachf(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
            t[3] = all[3];
            t[4] = all[4];
            t[5] = all[5];
        }
        const floats mu0 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const floats mu1 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const floats mu2 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
        const floats mu3 = m * t[3];
        const floats mu4 = m * t[4];
        const floats mu5 = m * t[5];
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 6, sizeof(float), copied.ahead);
        const floats result3[] = {mu0, mu1, mu2, mu3, mu4, mu5};
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

void CHASLES_LEVELED(chasles_momentum_screw_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(float), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 6)
        && is_packed(6, 6, sizeof(float), steps[2], steps + 8)
        && is_packed(6, 6, sizeof(float), steps[3], steps + 10)) {
        chasles_momentum_screw_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_momentum_screw_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_momentum_screw_sym6_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[6];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &I_C[0]);
            load_2(item0 + 4 * sizeof(double), step0, &I_C[4]);
        } else if (step0 == sizeof(double)) {
            I_C[0] = PACKED_IN(item0 + entries0[0], 0);
            I_C[1] = PACKED_IN(item0 + entries0[1], 0);
            I_C[2] = PACKED_IN(item0 + entries0[2], 0);
            I_C[3] = PACKED_IN(item0 + entries0[3], 0);
            I_C[4] = PACKED_IN(item0 + entries0[4], 0);
            I_C[5] = PACKED_IN(item0 + entries0[5], 0);
        } else {
            doubles all[6];
            take_each(item0, entries0, step0, 6, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
        }
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4(item2 + 0 * sizeof(double), step2, &t[0]);
            load_2(item2 + 4 * sizeof(double), step2, &t[4]);
        } else if (step2 == sizeof(double)) {
            t[0] = PACKED_IN(item2 + entries2[0], 0);
            t[1] = PACKED_IN(item2 + entries2[1], 0);
            t[2] = PACKED_IN(item2 + entries2[2], 0);
            t[3] = PACKED_IN(item2 + entries2[3], 0);
            t[4] = PACKED_IN(item2 + entries2[4], 0);
            t[5] = PACKED_IN(item2 + entries2[5], 0);
        } else {
            doubles all[6];
            take_each(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
            t[3] = all[3];
            t[4] = all[4];
            t[5] = all[5];
        }
        const doubles mu0 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const doubles mu1 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
        const doubles mu2 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const doubles mu3 = m * t[3];
        const doubles mu4 = m * t[4];
        const doubles mu5 = m * t[5];
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 6, sizeof(double), copied.ahead);
        const doubles result3[] = {mu0, mu1, mu2, mu3, mu4, mu5};
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

void CHASLES_LEVELED(chasles_momentum_screw_sym6_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(double), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 6)
        && is_packed(6, 6, sizeof(double), steps[2], steps + 8)
        && is_packed(6, 6, sizeof(double), steps[3], steps + 10)) {
        chasles_momentum_screw_sym6_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_momentum_screw_sym6_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_momentum_screw_sym6_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[6];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &I_C[0]);
            load_2f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        } else if (step0 == sizeof(float)) {
            I_C[0] = PACKEDF_IN(item0 + entries0[0], 0);
            I_C[1] = PACKEDF_IN(item0 + entries0[1], 0);
            I_C[2] = PACKEDF_IN(item0 + entries0[2], 0);
            I_C[3] = PACKEDF_IN(item0 + entries0[3], 0);
            I_C[4] = PACKEDF_IN(item0 + entries0[4], 0);
            I_C[5] = PACKEDF_IN(item0 + entries0[5], 0);
        } else {
            floats all[6];
            take_eachf(item0, entries0, step0, 6, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
        }
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4f(item2 + 0 * sizeof(float), step2, &t[0]);
            load_2f(item2 + 4 * sizeof(float), step2, &t[4]);
        } else if (step2 == sizeof(float)) {
            t[0] = PACKEDF_IN(item2 + entries2[0], 0);
            t[1] = PACKEDF_IN(item2 + entries2[1], 0);
            t[2] = PACKEDF_IN(item2 + entries2[2], 0);
            t[3] = PACKEDF_IN(item2 + entries2[3], 0);
            t[4] = PACKEDF_IN(item2 + entries2[4], 0);
            t[5] = PACKEDF_IN(item2 + entries2[5], 0);
        } else {
            floats all[6];
            take_eachf(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
            t[3] = all[3];
            t[4] = all[4];
            t[5] = all[5];
        }
        const floats mu0 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const floats mu1 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
        const floats mu2 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const floats mu3 = m * t[3];
        const floats mu4 = m * t[4];
        const floats mu5 = m * t[5];
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 6, sizeof(float), copied.ahead);
        const floats result3[] = {mu0, mu1, mu2, mu3, mu4, mu5};
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

void CHASLES_LEVELED(chasles_momentum_screw_sym6_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(float), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 6)
        && is_packed(6, 6, sizeof(float), steps[2], steps + 8)
        && is_packed(6, 6, sizeof(float), steps[3], steps + 10)) {
        chasles_momentum_screw_sym6_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_momentum_screw_sym6_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_kinetic_energy_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &I_C[0]);
            load_4(item0 + 4 * sizeof(double), step0, &I_C[4]);
            load_1(item0 + 8 * sizeof(double), step0, &I_C[8]);
        } else if (step0 == sizeof(double)) {
            I_C[0] = PACKED_IN(item0 + entries0[0], 0);
            I_C[1] = PACKED_IN(item0 + entries0[1], 0);
            I_C[2] = PACKED_IN(item0 + entries0[2], 0);
            I_C[3] = PACKED_IN(item0 + entries0[3], 0);
            I_C[4] = PACKED_IN(item0 + entries0[4], 0);
            I_C[5] = PACKED_IN(item0 + entries0[5], 0);
            I_C[6] = PACKED_IN(item0 + entries0[6], 0);
            I_C[7] = PACKED_IN(item0 + entries0[7], 0);
            I_C[8] = PACKED_IN(item0 + entries0[8], 0);
        } else {
            doubles all[9];
            take_each(item0, entries0, step0, 9, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
            I_C[6] = all[6];
            I_C[7] = all[7];
            I_C[8] = all[8];
        }
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4(item2 + 0 * sizeof(double), step2, &t[0]);
            load_2(item2 + 4 * sizeof(double), step2, &t[4]);
        } else if (step2 == sizeof(double)) {
            t[0] = PACKED_IN(item2 + entries2[0], 0);
            t[1] = PACKED_IN(item2 + entries2[1], 0);
            t[2] = PACKED_IN(item2 + entries2[2], 0);
            t[3] = PACKED_IN(item2 + entries2[3], 0);
            t[4] = PACKED_IN(item2 + entries2[4], 0);
            t[5] = PACKED_IN(item2 + entries2[5], 0);
        } else {
            doubles all[6];
            take_each(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
            t[3] = all[3];
            t[4] = all[4];
            t[5] = all[5];
        }
        const doubles t1 = (I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]) * (0.5 * t[0]);
        const doubles t2 = t1 + (I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]) * (0.5 * t[1]);
        const doubles t3 = t2 + (I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2]) * (0.5 * t[2]);
        const doubles t4 = t3 + m * t[3] * (0.5 * t[3]) + m * t[4] * (0.5 * t[4]);
        const doubles T_value = t4 + m * t[5] * (0.5 * t[5]);
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 1, sizeof(double), copied.ahead);
        store_1(item3, step3, T_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(double), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 6)
        && is_packed(6, 6, sizeof(double), steps[2], steps + 8)
        && is_packed(1, 1, sizeof(double), steps[3], steps + 10)) {
        chasles_kinetic_energy_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_kinetic_energy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_kinetic_energy_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &I_C[0]);
            load_4f(item0 + 4 * sizeof(float), step0, &I_C[4]);
            load_1f(item0 + 8 * sizeof(float), step0, &I_C[8]);
        } else if (step0 == sizeof(float)) {
            I_C[0] = PACKEDF_IN(item0 + entries0[0], 0);
            I_C[1] = PACKEDF_IN(item0 + entries0[1], 0);
            I_C[2] = PACKEDF_IN(item0 + entries0[2], 0);
            I_C[3] = PACKEDF_IN(item0 + entries0[3], 0);
            I_C[4] = PACKEDF_IN(item0 + entries0[4], 0);
            I_C[5] = PACKEDF_IN(item0 + entries0[5], 0);
            I_C[6] = PACKEDF_IN(item0 + entries0[6], 0);
            I_C[7] = PACKEDF_IN(item0 + entries0[7], 0);
            I_C[8] = PACKEDF_IN(item0 + entries0[8], 0);
        } else {
            floats all[9];
            take_eachf(item0, entries0, step0, 9, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
            I_C[6] = all[6];
            I_C[7] = all[7];
            I_C[8] = all[8];
        }
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4f(item2 + 0 * sizeof(float), step2, &t[0]);
            load_2f(item2 + 4 * sizeof(float), step2, &t[4]);
        } else if (step2 == sizeof(float)) {
            t[0] = PACKEDF_IN(item2 + entries2[0], 0);
            t[1] = PACKEDF_IN(item2 + entries2[1], 0);
            t[2] = PACKEDF_IN(item2 + entries2[2], 0);
            t[3] = PACKEDF_IN(item2 + entries2[3], 0);
            t[4] = PACKEDF_IN(item2 + entries2[4], 0);
            t[5] = PACKEDF_IN(item2 + entries2[5], 0);
        } else {
            floats all[6];
            take_eachf(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
            t[3] = all[3];
            t[4] = all[4];
            t[5] = all[5];
        }
        const floats t1 = (I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]) * (0.5f * t[0]);
        const floats t2 = t1 + (I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]) * (0.5f * t[1]);
        const floats t3 = t2 + (I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2]) * (0.5f * t[2]);
        const floats t4 = t3 + m * t[3] * (0.5f * t[3]) + m * t[4] * (0.5f * t[4]);
        const floats T_value = t4 + m * t[5] * (0.5f * t[5]);
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 1, sizeof(float), copied.ahead);
        store_1f(item3, step3, T_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(float), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 6)
        && is_packed(6, 6, sizeof(float), steps[2], steps + 8)
        && is_packed(1, 1, sizeof(float), steps[3], steps + 10)) {
        chasles_kinetic_energy_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_kinetic_energy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_kinetic_energy_sym6_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[6];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &I_C[0]);
            load_2(item0 + 4 * sizeof(double), step0, &I_C[4]);
        } else if (step0 == sizeof(double)) {
            I_C[0] = PACKED_IN(item0 + entries0[0], 0);
            I_C[1] = PACKED_IN(item0 + entries0[1], 0);
            I_C[2] = PACKED_IN(item0 + entries0[2], 0);
            I_C[3] = PACKED_IN(item0 + entries0[3], 0);
            I_C[4] = PACKED_IN(item0 + entries0[4], 0);
            I_C[5] = PACKED_IN(item0 + entries0[5], 0);
        } else {
            doubles all[6];
            take_each(item0, entries0, step0, 6, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
        }
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4(item2 + 0 * sizeof(double), step2, &t[0]);
            load_2(item2 + 4 * sizeof(double), step2, &t[4]);
        } else if (step2 == sizeof(double)) {
            t[0] = PACKED_IN(item2 + entries2[0], 0);
            t[1] = PACKED_IN(item2 + entries2[1], 0);
            t[2] = PACKED_IN(item2 + entries2[2], 0);
            t[3] = PACKED_IN(item2 + entries2[3], 0);
            t[4] = PACKED_IN(item2 + entries2[4], 0);
            t[5] = PACKED_IN(item2 + entries2[5], 0);
        } else {
            doubles all[6];
            take_each(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
            t[3] = all[3];
            t[4] = all[4];
            t[5] = all[5];
        }
        const doubles t1 = (I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]) * (0.5 * t[0]);
        const doubles t2 = t1 + (I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2]) * (0.5 * t[1]);
        const doubles t3 = t2 + (I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]) * (0.5 * t[2]);
        const doubles t4 = t3 + m * t[3] * (0.5 * t[3]) + m * t[4] * (0.5 * t[4]);
        const doubles T_value = t4 + m * t[5] * (0.5 * t[5]);
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 1, sizeof(double), copied.ahead);
        store_1(item3, step3, T_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_sym6_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(double), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 6)
        && is_packed(6, 6, sizeof(double), steps[2], steps + 8)
        && is_packed(1, 1, sizeof(double), steps[3], steps + 10)) {
        chasles_kinetic_energy_sym6_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_kinetic_energy_sym6_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_kinetic_energy_sym6_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[6];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &I_C[0]);
            load_2f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        } else if (step0 == sizeof(float)) {
            I_C[0] = PACKEDF_IN(item0 + entries0[0], 0);
            I_C[1] = PACKEDF_IN(item0 + entries0[1], 0);
            I_C[2] = PACKEDF_IN(item0 + entries0[2], 0);
            I_C[3] = PACKEDF_IN(item0 + entries0[3], 0);
            I_C[4] = PACKEDF_IN(item0 + entries0[4], 0);
            I_C[5] = PACKEDF_IN(item0 + entries0[5], 0);
        } else {
            floats all[6];
            take_eachf(item0, entries0, step0, 6, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
        }
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4f(item2 + 0 * sizeof(float), step2, &t[0]);
            load_2f(item2 + 4 * sizeof(float), step2, &t[4]);
        } else if (step2 == sizeof(float)) {
            t[0] = PACKEDF_IN(item2 + entries2[0], 0);
            t[1] = PACKEDF_IN(item2 + entries2[1], 0);
            t[2] = PACKEDF_IN(item2 + entries2[2], 0);
            t[3] = PACKEDF_IN(item2 + entries2[3], 0);
            t[4] = PACKEDF_IN(item2 + entries2[4], 0);
            t[5] = PACKEDF_IN(item2 + entries2[5], 0);
        } else {
            floats all[6];
            take_eachf(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
            t[3] = all[3];
            t[4] = all[4];
            t[5] = all[5];
        }
        const floats t1 = (I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]) * (0.5f * t[0]);
        const floats t2 = t1 + (I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2]) * (0.5f * t[1]);
        const floats t3 = t2 + (I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]) * (0.5f * t[2]);
        const floats t4 = t3 + m * t[3] * (0.5f * t[3]) + m * t[4] * (0.5f * t[4]);
        const floats T_value = t4 + m * t[5] * (0.5f * t[5]);
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 1, sizeof(float), copied.ahead);
        store_1f(item3, step3, T_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_sym6_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(float), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 6)
        && is_packed(6, 6, sizeof(float), steps[2], steps + 8)
        && is_packed(1, 1, sizeof(float), steps[3], steps + 10)) {
        chasles_kinetic_energy_sym6_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_kinetic_energy_sym6_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_newton_euler_wrench_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(double));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &I_C[0]);
            load_4(item0 + 4 * sizeof(double), step0, &I_C[4]);
            load_1(item0 + 8 * sizeof(double), step0, &I_C[8]);
        } else if (step0 == sizeof(double)) {
            I_C[0] = PACKED_IN(item0 + entries0[0], 0);
            I_C[1] = PACKED_IN(item0 + entries0[1], 0);
            I_C[2] = PACKED_IN(item0 + entries0[2], 0);
            I_C[3] = PACKED_IN(item0 + entries0[3], 0);
            I_C[4] = PACKED_IN(item0 + entries0[4], 0);
            I_C[5] = PACKED_IN(item0 + entries0[5], 0);
            I_C[6] = PACKED_IN(item0 + entries0[6], 0);
            I_C[7] = PACKED_IN(item0 + entries0[7], 0);
            I_C[8] = PACKED_IN(item0 + entries0[8], 0);
        } else {
            doubles all[9];
            take_each(item0, entries0, step0, 9, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
            I_C[6] = all[6];
            I_C[7] = all[7];
            I_C[8] = all[8];
        }
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4(item2 + 0 * sizeof(double), step2, &t[0]);
        } else if (step2 == sizeof(double)) {
            t[0] = PACKED_IN(item2 + entries2[0], 0);
            t[1] = PACKED_IN(item2 + entries2[1], 0);
            t[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[6];
            take_each(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
        }
        doubles t_dot[6];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 6, copied.ahead);
        if (dense3) {
            load_4(item3 + 0 * sizeof(double), step3, &t_dot[0]);
            load_2(item3 + 4 * sizeof(double), step3, &t_dot[4]);
        } else if (step3 == sizeof(double)) {
            t_dot[0] = PACKED_IN(item3 + entries3[0], 0);
            t_dot[1] = PACKED_IN(item3 + entries3[1], 0);
            t_dot[2] = PACKED_IN(item3 + entries3[2], 0);
            t_dot[3] = PACKED_IN(item3 + entries3[3], 0);
            t_dot[4] = PACKED_IN(item3 + entries3[4], 0);
            t_dot[5] = PACKED_IN(item3 + entries3[5], 0);
        } else {
            doubles all[6];
            take_each(item3, entries3, step3, 6, all);
            t_dot[0] = all[0];
            t_dot[1] = all[1];
            t_dot[2] = all[2];
            t_dot[3] = all[3];
            t_dot[4] = all[4];
            t_dot[5] = all[5];
        }
        const doubles w3 = m * t_dot[3];
        const doubles w4 = m * t_dot[4];
        const doubles w5 = m * t_dot[5];
        const doubles t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const doubles t2 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const doubles t3 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
        const doubles t4 = I_C[0] * t_dot[0] + I_C[1] * t_dot[1] + I_C[2] * t_dot[2];
        const doubles w0 = t4 + (t[1] * t3 - t[2] * t2);
        const doubles t5 = I_C[3] * t_dot[0] + I_C[4] * t_dot[1] + I_C[5] * t_dot[2];
        const doubles w1 = t5 + (t[2] * t1 - t[0] * t3);
        const doubles t6 = I_C[6] * t_dot[0] + I_C[7] * t_dot[1] + I_C[8] * t_dot[2];
        const doubles w2 = t6 + (t[0] * t2 - t[1] * t1);
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 6, sizeof(double), copied.ahead);
        const doubles result4[] = {w0, w1, w2, w3, w4, w5};
        if (dense4) {
            store_all(item4, step4, 6, result4);
        } else if (step4 == sizeof(double)) {
            PACKED(item4 + entries4[0], 0) = result4[0];
            PACKED(item4 + entries4[1], 0) = result4[1];
            PACKED(item4 + entries4[2], 0) = result4[2];
            PACKED(item4 + entries4[3], 0) = result4[3];
            PACKED(item4 + entries4[4], 0) = result4[4];
            PACKED(item4 + entries4[5], 0) = result4[5];
        } else {
            give_each(item4, entries4, step4, 6, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(double), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 7)
        && is_packed(6, 6, sizeof(double), steps[2], steps + 9)
        && is_packed(6, 6, sizeof(double), steps[3], steps + 11)
        && is_packed(6, 6, sizeof(double), steps[4], steps + 13)) {
        chasles_newton_euler_wrench_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_newton_euler_wrench_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_newton_euler_wrench_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(float));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &I_C[0]);
            load_4f(item0 + 4 * sizeof(float), step0, &I_C[4]);
            load_1f(item0 + 8 * sizeof(float), step0, &I_C[8]);
        } else if (step0 == sizeof(float)) {
            I_C[0] = PACKEDF_IN(item0 + entries0[0], 0);
            I_C[1] = PACKEDF_IN(item0 + entries0[1], 0);
            I_C[2] = PACKEDF_IN(item0 + entries0[2], 0);
            I_C[3] = PACKEDF_IN(item0 + entries0[3], 0);
            I_C[4] = PACKEDF_IN(item0 + entries0[4], 0);
            I_C[5] = PACKEDF_IN(item0 + entries0[5], 0);
            I_C[6] = PACKEDF_IN(item0 + entries0[6], 0);
            I_C[7] = PACKEDF_IN(item0 + entries0[7], 0);
            I_C[8] = PACKEDF_IN(item0 + entries0[8], 0);
        } else {
            floats all[9];
            take_eachf(item0, entries0, step0, 9, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
            I_C[6] = all[6];
            I_C[7] = all[7];
            I_C[8] = all[8];
        }
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4f(item2 + 0 * sizeof(float), step2, &t[0]);
        } else if (step2 == sizeof(float)) {
            t[0] = PACKEDF_IN(item2 + entries2[0], 0);
            t[1] = PACKEDF_IN(item2 + entries2[1], 0);
            t[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[6];
            take_eachf(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
        }
        floats t_dot[6];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 6, copied.ahead);
        if (dense3) {
            load_4f(item3 + 0 * sizeof(float), step3, &t_dot[0]);
            load_2f(item3 + 4 * sizeof(float), step3, &t_dot[4]);
        } else if (step3 == sizeof(float)) {
            t_dot[0] = PACKEDF_IN(item3 + entries3[0], 0);
            t_dot[1] = PACKEDF_IN(item3 + entries3[1], 0);
            t_dot[2] = PACKEDF_IN(item3 + entries3[2], 0);
            t_dot[3] = PACKEDF_IN(item3 + entries3[3], 0);
            t_dot[4] = PACKEDF_IN(item3 + entries3[4], 0);
            t_dot[5] = PACKEDF_IN(item3 + entries3[5], 0);
        } else {
            floats all[6];
            take_eachf(item3, entries3, step3, 6, all);
            t_dot[0] = all[0];
            t_dot[1] = all[1];
            t_dot[2] = all[2];
            t_dot[3] = all[3];
            t_dot[4] = all[4];
            t_dot[5] = all[5];
        }
        const floats w3 = m * t_dot[3];
        const floats w4 = m * t_dot[4];
        const floats w5 = m * t_dot[5];
        const floats t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const floats t2 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const floats t3 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
        const floats t4 = I_C[0] * t_dot[0] + I_C[1] * t_dot[1] + I_C[2] * t_dot[2];
        const floats w0 = t4 + (t[1] * t3 - t[2] * t2);
        const floats t5 = I_C[3] * t_dot[0] + I_C[4] * t_dot[1] + I_C[5] * t_dot[2];
        const floats w1 = t5 + (t[2] * t1 - t[0] * t3);
        const floats t6 = I_C[6] * t_dot[0] + I_C[7] * t_dot[1] + I_C[8] * t_dot[2];
        const floats w2 = t6 + (t[0] * t2 - t[1] * t1);
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 6, sizeof(float), copied.ahead);
        const floats result4[] = {w0, w1, w2, w3, w4, w5};
        if (dense4) {
            store_allf(item4, step4, 6, result4);
        } else if (step4 == sizeof(float)) {
            PACKEDF(item4 + entries4[0], 0) = result4[0];
            PACKEDF(item4 + entries4[1], 0) = result4[1];
            PACKEDF(item4 + entries4[2], 0) = result4[2];
            PACKEDF(item4 + entries4[3], 0) = result4[3];
            PACKEDF(item4 + entries4[4], 0) = result4[4];
            PACKEDF(item4 + entries4[5], 0) = result4[5];
        } else {
            give_eachf(item4, entries4, step4, 6, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(float), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 7)
        && is_packed(6, 6, sizeof(float), steps[2], steps + 9)
        && is_packed(6, 6, sizeof(float), steps[3], steps + 11)
        && is_packed(6, 6, sizeof(float), steps[4], steps + 13)) {
        chasles_newton_euler_wrench_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_newton_euler_wrench_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_newton_euler_wrench_sym6_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(double));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[6];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &I_C[0]);
            load_2(item0 + 4 * sizeof(double), step0, &I_C[4]);
        } else if (step0 == sizeof(double)) {
            I_C[0] = PACKED_IN(item0 + entries0[0], 0);
            I_C[1] = PACKED_IN(item0 + entries0[1], 0);
            I_C[2] = PACKED_IN(item0 + entries0[2], 0);
            I_C[3] = PACKED_IN(item0 + entries0[3], 0);
            I_C[4] = PACKED_IN(item0 + entries0[4], 0);
            I_C[5] = PACKED_IN(item0 + entries0[5], 0);
        } else {
            doubles all[6];
            take_each(item0, entries0, step0, 6, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
        }
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4(item2 + 0 * sizeof(double), step2, &t[0]);
        } else if (step2 == sizeof(double)) {
            t[0] = PACKED_IN(item2 + entries2[0], 0);
            t[1] = PACKED_IN(item2 + entries2[1], 0);
            t[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[6];
            take_each(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
        }
        doubles t_dot[6];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 6, copied.ahead);
        if (dense3) {
            load_4(item3 + 0 * sizeof(double), step3, &t_dot[0]);
            load_2(item3 + 4 * sizeof(double), step3, &t_dot[4]);
        } else if (step3 == sizeof(double)) {
            t_dot[0] = PACKED_IN(item3 + entries3[0], 0);
            t_dot[1] = PACKED_IN(item3 + entries3[1], 0);
            t_dot[2] = PACKED_IN(item3 + entries3[2], 0);
            t_dot[3] = PACKED_IN(item3 + entries3[3], 0);
            t_dot[4] = PACKED_IN(item3 + entries3[4], 0);
            t_dot[5] = PACKED_IN(item3 + entries3[5], 0);
        } else {
            doubles all[6];
            take_each(item3, entries3, step3, 6, all);
            t_dot[0] = all[0];
            t_dot[1] = all[1];
            t_dot[2] = all[2];
            t_dot[3] = all[3];
            t_dot[4] = all[4];
            t_dot[5] = all[5];
        }
        const doubles w3 = m * t_dot[3];
        const doubles w4 = m * t_dot[4];
        const doubles w5 = m * t_dot[5];
        const doubles t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const doubles t2 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
        const doubles t3 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const doubles t4 = I_C[0] * t_dot[0] + I_C[1] * t_dot[1] + I_C[2] * t_dot[2];
        const doubles w0 = t4 + (t[1] * t3 - t[2] * t2);
        const doubles t5 = I_C[1] * t_dot[0] + I_C[3] * t_dot[1] + I_C[4] * t_dot[2];
        const doubles w1 = t5 + (t[2] * t1 - t[0] * t3);
        const doubles t6 = I_C[2] * t_dot[0] + I_C[4] * t_dot[1] + I_C[5] * t_dot[2];
        const doubles w2 = t6 + (t[0] * t2 - t[1] * t1);
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 6, sizeof(double), copied.ahead);
        const doubles result4[] = {w0, w1, w2, w3, w4, w5};
        if (dense4) {
            store_all(item4, step4, 6, result4);
        } else if (step4 == sizeof(double)) {
            PACKED(item4 + entries4[0], 0) = result4[0];
            PACKED(item4 + entries4[1], 0) = result4[1];
            PACKED(item4 + entries4[2], 0) = result4[2];
            PACKED(item4 + entries4[3], 0) = result4[3];
            PACKED(item4 + entries4[4], 0) = result4[4];
            PACKED(item4 + entries4[5], 0) = result4[5];
        } else {
            give_each(item4, entries4, step4, 6, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_sym6_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(double), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 7)
        && is_packed(6, 6, sizeof(double), steps[2], steps + 9)
        && is_packed(6, 6, sizeof(double), steps[3], steps + 11)
        && is_packed(6, 6, sizeof(double), steps[4], steps + 13)) {
        chasles_newton_euler_wrench_sym6_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_newton_euler_wrench_sym6_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_newton_euler_wrench_sym6_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(float));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[6];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &I_C[0]);
            load_2f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        } else if (step0 == sizeof(float)) {
            I_C[0] = PACKEDF_IN(item0 + entries0[0], 0);
            I_C[1] = PACKEDF_IN(item0 + entries0[1], 0);
            I_C[2] = PACKEDF_IN(item0 + entries0[2], 0);
            I_C[3] = PACKEDF_IN(item0 + entries0[3], 0);
            I_C[4] = PACKEDF_IN(item0 + entries0[4], 0);
            I_C[5] = PACKEDF_IN(item0 + entries0[5], 0);
        } else {
            floats all[6];
            take_eachf(item0, entries0, step0, 6, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
        }
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4f(item2 + 0 * sizeof(float), step2, &t[0]);
        } else if (step2 == sizeof(float)) {
            t[0] = PACKEDF_IN(item2 + entries2[0], 0);
            t[1] = PACKEDF_IN(item2 + entries2[1], 0);
            t[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[6];
            take_eachf(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
        }
        floats t_dot[6];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 6, copied.ahead);
        if (dense3) {
            load_4f(item3 + 0 * sizeof(float), step3, &t_dot[0]);
            load_2f(item3 + 4 * sizeof(float), step3, &t_dot[4]);
        } else if (step3 == sizeof(float)) {
            t_dot[0] = PACKEDF_IN(item3 + entries3[0], 0);
            t_dot[1] = PACKEDF_IN(item3 + entries3[1], 0);
            t_dot[2] = PACKEDF_IN(item3 + entries3[2], 0);
            t_dot[3] = PACKEDF_IN(item3 + entries3[3], 0);
            t_dot[4] = PACKEDF_IN(item3 + entries3[4], 0);
            t_dot[5] = PACKEDF_IN(item3 + entries3[5], 0);
        } else {
            floats all[6];
            take_eachf(item3, entries3, step3, 6, all);
            t_dot[0] = all[0];
            t_dot[1] = all[1];
            t_dot[2] = all[2];
            t_dot[3] = all[3];
            t_dot[4] = all[4];
            t_dot[5] = all[5];
        }
        const floats w3 = m * t_dot[3];
        const floats w4 = m * t_dot[4];
        const floats w5 = m * t_dot[5];
        const floats t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const floats t2 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
        const floats t3 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const floats t4 = I_C[0] * t_dot[0] + I_C[1] * t_dot[1] + I_C[2] * t_dot[2];
        const floats w0 = t4 + (t[1] * t3 - t[2] * t2);
        const floats t5 = I_C[1] * t_dot[0] + I_C[3] * t_dot[1] + I_C[4] * t_dot[2];
        const floats w1 = t5 + (t[2] * t1 - t[0] * t3);
        const floats t6 = I_C[2] * t_dot[0] + I_C[4] * t_dot[1] + I_C[5] * t_dot[2];
        const floats w2 = t6 + (t[0] * t2 - t[1] * t1);
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 6, sizeof(float), copied.ahead);
        const floats result4[] = {w0, w1, w2, w3, w4, w5};
        if (dense4) {
            store_allf(item4, step4, 6, result4);
        } else if (step4 == sizeof(float)) {
            PACKEDF(item4 + entries4[0], 0) = result4[0];
            PACKEDF(item4 + entries4[1], 0) = result4[1];
            PACKEDF(item4 + entries4[2], 0) = result4[2];
            PACKEDF(item4 + entries4[3], 0) = result4[3];
            PACKEDF(item4 + entries4[4], 0) = result4[4];
            PACKEDF(item4 + entries4[5], 0) = result4[5];
        } else {
            give_eachf(item4, entries4, step4, 6, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_sym6_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(float), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 7)
        && is_packed(6, 6, sizeof(float), steps[2], steps + 9)
        && is_packed(6, 6, sizeof(float), steps[3], steps + 11)
        && is_packed(6, 6, sizeof(float), steps[4], steps + 13)) {
        chasles_newton_euler_wrench_sym6_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_newton_euler_wrench_sym6_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_newton_euler_twist_rate_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(double));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &I_C[0]);
            load_4(item0 + 4 * sizeof(double), step0, &I_C[4]);
            load_1(item0 + 8 * sizeof(double), step0, &I_C[8]);
        } else if (step0 == sizeof(double)) {
            I_C[0] = PACKED_IN(item0 + entries0[0], 0);
            I_C[1] = PACKED_IN(item0 + entries0[1], 0);
            I_C[2] = PACKED_IN(item0 + entries0[2], 0);
            I_C[3] = PACKED_IN(item0 + entries0[3], 0);
            I_C[4] = PACKED_IN(item0 + entries0[4], 0);
            I_C[5] = PACKED_IN(item0 + entries0[5], 0);
            I_C[6] = PACKED_IN(item0 + entries0[6], 0);
            I_C[7] = PACKED_IN(item0 + entries0[7], 0);
            I_C[8] = PACKED_IN(item0 + entries0[8], 0);
        } else {
            doubles all[9];
            take_each(item0, entries0, step0, 9, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
            I_C[6] = all[6];
            I_C[7] = all[7];
            I_C[8] = all[8];
        }
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4(item2 + 0 * sizeof(double), step2, &t[0]);
        } else if (step2 == sizeof(double)) {
            t[0] = PACKED_IN(item2 + entries2[0], 0);
            t[1] = PACKED_IN(item2 + entries2[1], 0);
            t[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[6];
            take_each(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
        }
        doubles w[6];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 6, copied.ahead);
        if (dense3) {
            load_4(item3 + 0 * sizeof(double), step3, &w[0]);
            load_2(item3 + 4 * sizeof(double), step3, &w[4]);
        } else if (step3 == sizeof(double)) {
            w[0] = PACKED_IN(item3 + entries3[0], 0);
            w[1] = PACKED_IN(item3 + entries3[1], 0);
            w[2] = PACKED_IN(item3 + entries3[2], 0);
            w[3] = PACKED_IN(item3 + entries3[3], 0);
            w[4] = PACKED_IN(item3 + entries3[4], 0);
            w[5] = PACKED_IN(item3 + entries3[5], 0);
        } else {
            doubles all[6];
            take_each(item3, entries3, step3, 6, all);
            w[0] = all[0];
            w[1] = all[1];
            w[2] = all[2];
            w[3] = all[3];
            w[4] = all[4];
            w[5] = all[5];
        }
        const doubles t1 = choose(less(I_C[0], spread(0.0)), -I_C[0], I_C[0]);
        const doubles t2 = choose(less(I_C[1], spread(0.0)), -I_C[1], I_C[1]);
        const doubles t3 = choose(less(t1, t2), t2, t1);
        const doubles t4 = choose(less(I_C[2], spread(0.0)), -I_C[2], I_C[2]);
        const doubles t5 = choose(less(t3, t4), t4, t3);
        const doubles t6 = choose(less(I_C[3], spread(0.0)), -I_C[3], I_C[3]);
        const doubles t7 = choose(less(t5, t6), t6, t5);
        const doubles t8 = choose(less(I_C[4], spread(0.0)), -I_C[4], I_C[4]);
        const doubles t9 = choose(less(t7, t8), t8, t7);
        const doubles t10 = choose(less(I_C[5], spread(0.0)), -I_C[5], I_C[5]);
        const doubles t11 = choose(less(t9, t10), t10, t9);
        const doubles t12 = choose(less(I_C[6], spread(0.0)), -I_C[6], I_C[6]);
        const doubles t13 = choose(less(t11, t12), t12, t11);
        const doubles t14 = choose(less(I_C[7], spread(0.0)), -I_C[7], I_C[7]);
        const doubles t15 = choose(less(t13, t14), t14, t13);
        const doubles t16 = choose(less(I_C[8], spread(0.0)), -I_C[8], I_C[8]);
        const doubles t17 = choose(less(t15, t16), t16, t15);
        const doubles t18 = choose(equal(spread(0.0), t17), spread(1.0), t17);
        const doubles t19 = I_C[0] / t18;
        const doubles t20 = I_C[1] / t18;
        const doubles t21 = I_C[2] / t18;
        const doubles t22 = I_C[3] / t18;
        const doubles t23 = I_C[4] / t18;
        const doubles t24 = I_C[5] / t18;
        const doubles t25 = I_C[6] / t18;
        const doubles t26 = I_C[7] / t18;
        const doubles t27 = I_C[8] / t18;
        const doubles t28 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const doubles t29 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const doubles t30 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
        const doubles t31 = w[0] - (t[1] * t30 - t[2] * t29);
        const doubles t32 = w[1] - (t[2] * t28 - t[0] * t30);
        const doubles t33 = w[2] - (t[0] * t29 - t[1] * t28);
        const doubles t34 = t23 * t27 - t24 * t26;
        const doubles t35 = t24 * t25 - t22 * t27;
        const doubles t36 = t22 * t26 - t23 * t25;
        const doubles t37 = I_C[0] * (I_C[4] * I_C[8] - I_C[5] * I_C[7]);
        const doubles t38 = t37 + I_C[1] * (I_C[5] * I_C[6] - I_C[3] * I_C[8]);
        const truths t39 = equal(spread(0.0), t38 + I_C[2] * (I_C[3] * I_C[7] - I_C[4] * I_C[6]));
        const doubles t40 = choose(t39, spread(0.0), t19 * t34 + t20 * t35 + t21 * t36);
        const doubles t41 = choose(equal(t40, spread(0.0)), spread(0.0), spread(1.0)) / t40;
        const doubles t42 = t31 * t34 + t32 * (t21 * t26 - t20 * t27);
        const doubles t43 = t31 * t35 + t32 * (t19 * t27 - t21 * t25);
        const doubles t44 = t31 * t36 + t32 * (t20 * t25 - t19 * t26);
        const doubles t45 = choose(equal(m, spread(0.0)), spread(0.0), spread(1.0)) / m;
        const doubles t_dot3 = w[3] * t45;
        const doubles t_dot4 = w[4] * t45;
        const doubles t_dot5 = w[5] * t45;
        const doubles t_dot0 = t41 * (t42 + t33 * (t20 * t24 - t21 * t23)) / t18;
        const doubles t_dot1 = t41 * (t43 + t33 * (t21 * t22 - t19 * t24)) / t18;
        const doubles t_dot2 = t41 * (t44 + t33 * (t19 * t23 - t20 * t22)) / t18;
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 6, sizeof(double), copied.ahead);
        const doubles result4[] = {t_dot0, t_dot1, t_dot2, t_dot3, t_dot4, t_dot5};
        if (dense4) {
            store_all(item4, step4, 6, result4);
        } else if (step4 == sizeof(double)) {
            PACKED(item4 + entries4[0], 0) = result4[0];
            PACKED(item4 + entries4[1], 0) = result4[1];
            PACKED(item4 + entries4[2], 0) = result4[2];
            PACKED(item4 + entries4[3], 0) = result4[3];
            PACKED(item4 + entries4[4], 0) = result4[4];
            PACKED(item4 + entries4[5], 0) = result4[5];
        } else {
            give_each(item4, entries4, step4, 6, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_newton_euler_twist_rate_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_newton_euler_twist_rate_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(float));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &I_C[0]);
            load_4f(item0 + 4 * sizeof(float), step0, &I_C[4]);
            load_1f(item0 + 8 * sizeof(float), step0, &I_C[8]);
        } else if (step0 == sizeof(float)) {
            I_C[0] = PACKEDF_IN(item0 + entries0[0], 0);
            I_C[1] = PACKEDF_IN(item0 + entries0[1], 0);
            I_C[2] = PACKEDF_IN(item0 + entries0[2], 0);
            I_C[3] = PACKEDF_IN(item0 + entries0[3], 0);
            I_C[4] = PACKEDF_IN(item0 + entries0[4], 0);
            I_C[5] = PACKEDF_IN(item0 + entries0[5], 0);
            I_C[6] = PACKEDF_IN(item0 + entries0[6], 0);
            I_C[7] = PACKEDF_IN(item0 + entries0[7], 0);
            I_C[8] = PACKEDF_IN(item0 + entries0[8], 0);
        } else {
            floats all[9];
            take_eachf(item0, entries0, step0, 9, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
            I_C[6] = all[6];
            I_C[7] = all[7];
            I_C[8] = all[8];
        }
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4f(item2 + 0 * sizeof(float), step2, &t[0]);
        } else if (step2 == sizeof(float)) {
            t[0] = PACKEDF_IN(item2 + entries2[0], 0);
            t[1] = PACKEDF_IN(item2 + entries2[1], 0);
            t[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[6];
            take_eachf(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
        }
        floats w[6];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 6, copied.ahead);
        if (dense3) {
            load_4f(item3 + 0 * sizeof(float), step3, &w[0]);
            load_2f(item3 + 4 * sizeof(float), step3, &w[4]);
        } else if (step3 == sizeof(float)) {
            w[0] = PACKEDF_IN(item3 + entries3[0], 0);
            w[1] = PACKEDF_IN(item3 + entries3[1], 0);
            w[2] = PACKEDF_IN(item3 + entries3[2], 0);
            w[3] = PACKEDF_IN(item3 + entries3[3], 0);
            w[4] = PACKEDF_IN(item3 + entries3[4], 0);
            w[5] = PACKEDF_IN(item3 + entries3[5], 0);
        } else {
            floats all[6];
            take_eachf(item3, entries3, step3, 6, all);
            w[0] = all[0];
            w[1] = all[1];
            w[2] = all[2];
            w[3] = all[3];
            w[4] = all[4];
            w[5] = all[5];
        }
        const floats t1 = choosef(lessf(I_C[0], spreadf(0.0f)), -I_C[0], I_C[0]);
        const floats t2 = choosef(lessf(I_C[1], spreadf(0.0f)), -I_C[1], I_C[1]);
        const floats t3 = choosef(lessf(t1, t2), t2, t1);
        const floats t4 = choosef(lessf(I_C[2], spreadf(0.0f)), -I_C[2], I_C[2]);
        const floats t5 = choosef(lessf(t3, t4), t4, t3);
        const floats t6 = choosef(lessf(I_C[3], spreadf(0.0f)), -I_C[3], I_C[3]);
        const floats t7 = choosef(lessf(t5, t6), t6, t5);
        const floats t8 = choosef(lessf(I_C[4], spreadf(0.0f)), -I_C[4], I_C[4]);
        const floats t9 = choosef(lessf(t7, t8), t8, t7);
        const floats t10 = choosef(lessf(I_C[5], spreadf(0.0f)), -I_C[5], I_C[5]);
        const floats t11 = choosef(lessf(t9, t10), t10, t9);
        const floats t12 = choosef(lessf(I_C[6], spreadf(0.0f)), -I_C[6], I_C[6]);
        const floats t13 = choosef(lessf(t11, t12), t12, t11);
        const floats t14 = choosef(lessf(I_C[7], spreadf(0.0f)), -I_C[7], I_C[7]);
        const floats t15 = choosef(lessf(t13, t14), t14, t13);
        const floats t16 = choosef(lessf(I_C[8], spreadf(0.0f)), -I_C[8], I_C[8]);
        const floats t17 = choosef(lessf(t15, t16), t16, t15);
        const floats t18 = choosef(equalf(spreadf(0.0f), t17), spreadf(1.0f), t17);
        const floats t19 = I_C[0] / t18;
        const floats t20 = I_C[1] / t18;
        const floats t21 = I_C[2] / t18;
        const floats t22 = I_C[3] / t18;
        const floats t23 = I_C[4] / t18;
        const floats t24 = I_C[5] / t18;
        const floats t25 = I_C[6] / t18;
        const floats t26 = I_C[7] / t18;
        const floats t27 = I_C[8] / t18;
        const floats t28 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const floats t29 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const floats t30 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
        const floats t31 = w[0] - (t[1] * t30 - t[2] * t29);
        const floats t32 = w[1] - (t[2] * t28 - t[0] * t30);
        const floats t33 = w[2] - (t[0] * t29 - t[1] * t28);
        const floats t34 = t23 * t27 - t24 * t26;
        const floats t35 = t24 * t25 - t22 * t27;
        const floats t36 = t22 * t26 - t23 * t25;
        const floats t37 = I_C[0] * (I_C[4] * I_C[8] - I_C[5] * I_C[7]);
        const floats t38 = t37 + I_C[1] * (I_C[5] * I_C[6] - I_C[3] * I_C[8]);
        const floats t39 = t38 + I_C[2] * (I_C[3] * I_C[7] - I_C[4] * I_C[6]);
        const floats t40 = t19 * t34 + t20 * t35 + t21 * t36;
        const floats t41 = choosef(equalf(spreadf(0.0f), t39), spreadf(0.0f), t40);
        const floats t42 = choosef(equalf(t41, spreadf(0.0f)), spreadf(0.0f), spreadf(1.0f)) / t41;
        const floats t43 = t31 * t34 + t32 * (t21 * t26 - t20 * t27);
        const floats t44 = t31 * t35 + t32 * (t19 * t27 - t21 * t25);
        const floats t45 = t31 * t36 + t32 * (t20 * t25 - t19 * t26);
        const floats t46 = choosef(equalf(m, spreadf(0.0f)), spreadf(0.0f), spreadf(1.0f)) / m;
        const floats t_dot3 = w[3] * t46;
        const floats t_dot4 = w[4] * t46;
        const floats t_dot5 = w[5] * t46;
        const floats t_dot0 = t42 * (t43 + t33 * (t20 * t24 - t21 * t23)) / t18;
        const floats t_dot1 = t42 * (t44 + t33 * (t21 * t22 - t19 * t24)) / t18;
        const floats t_dot2 = t42 * (t45 + t33 * (t19 * t23 - t20 * t22)) / t18;
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 6, sizeof(float), copied.ahead);
        const floats result4[] = {t_dot0, t_dot1, t_dot2, t_dot3, t_dot4, t_dot5};
        if (dense4) {
            store_allf(item4, step4, 6, result4);
        } else if (step4 == sizeof(float)) {
            PACKEDF(item4 + entries4[0], 0) = result4[0];
            PACKEDF(item4 + entries4[1], 0) = result4[1];
            PACKEDF(item4 + entries4[2], 0) = result4[2];
            PACKEDF(item4 + entries4[3], 0) = result4[3];
            PACKEDF(item4 + entries4[4], 0) = result4[4];
            PACKEDF(item4 + entries4[5], 0) = result4[5];
        } else {
            give_eachf(item4, entries4, step4, 6, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_newton_euler_twist_rate_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_newton_euler_twist_rate_sym6_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(double));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[6];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &I_C[0]);
            load_2(item0 + 4 * sizeof(double), step0, &I_C[4]);
        } else if (step0 == sizeof(double)) {
            I_C[0] = PACKED_IN(item0 + entries0[0], 0);
            I_C[1] = PACKED_IN(item0 + entries0[1], 0);
            I_C[2] = PACKED_IN(item0 + entries0[2], 0);
            I_C[3] = PACKED_IN(item0 + entries0[3], 0);
            I_C[4] = PACKED_IN(item0 + entries0[4], 0);
            I_C[5] = PACKED_IN(item0 + entries0[5], 0);
        } else {
            doubles all[6];
            take_each(item0, entries0, step0, 6, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
        }
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4(item2 + 0 * sizeof(double), step2, &t[0]);
        } else if (step2 == sizeof(double)) {
            t[0] = PACKED_IN(item2 + entries2[0], 0);
            t[1] = PACKED_IN(item2 + entries2[1], 0);
            t[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[6];
            take_each(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
        }
        doubles w[6];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 6, copied.ahead);
        if (dense3) {
            load_4(item3 + 0 * sizeof(double), step3, &w[0]);
            load_2(item3 + 4 * sizeof(double), step3, &w[4]);
        } else if (step3 == sizeof(double)) {
            w[0] = PACKED_IN(item3 + entries3[0], 0);
            w[1] = PACKED_IN(item3 + entries3[1], 0);
            w[2] = PACKED_IN(item3 + entries3[2], 0);
            w[3] = PACKED_IN(item3 + entries3[3], 0);
            w[4] = PACKED_IN(item3 + entries3[4], 0);
            w[5] = PACKED_IN(item3 + entries3[5], 0);
        } else {
            doubles all[6];
            take_each(item3, entries3, step3, 6, all);
            w[0] = all[0];
            w[1] = all[1];
            w[2] = all[2];
            w[3] = all[3];
            w[4] = all[4];
            w[5] = all[5];
        }
        const doubles t1 = choose(less(I_C[0], spread(0.0)), -I_C[0], I_C[0]);
        const doubles t2 = choose(less(I_C[1], spread(0.0)), -I_C[1], I_C[1]);
        const doubles t3 = choose(less(t1, t2), t2, t1);
        const doubles t4 = choose(less(I_C[2], spread(0.0)), -I_C[2], I_C[2]);
        const doubles t5 = choose(less(t3, t4), t4, t3);
        const doubles t6 = choose(less(I_C[3], spread(0.0)), -I_C[3], I_C[3]);
        const doubles t7 = choose(less(t5, t6), t6, t5);
        const doubles t8 = choose(less(I_C[4], spread(0.0)), -I_C[4], I_C[4]);
        const doubles t9 = choose(less(t7, t8), t8, t7);
        const doubles t10 = choose(less(I_C[5], spread(0.0)), -I_C[5], I_C[5]);
        const doubles t11 = choose(less(t9, t10), t10, t9);
        const doubles t12 = choose(equal(spread(0.0), t11), spread(1.0), t11);
        const doubles t13 = I_C[0] / t12;
        const doubles t14 = I_C[1] / t12;
        const doubles t15 = I_C[2] / t12;
        const doubles t16 = I_C[3] / t12;
        const doubles t17 = I_C[4] / t12;
        const doubles t18 = I_C[5] / t12;
        const doubles t19 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const doubles t20 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
        const doubles t21 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const doubles t22 = w[0] - (t[1] * t21 - t[2] * t20);
        const doubles t23 = w[1] - (t[2] * t19 - t[0] * t21);
        const doubles t24 = w[2] - (t[0] * t20 - t[1] * t19);
        const doubles t25 = t16 * t18 - t17 * t17;
        const doubles t26 = t15 * t17 - t14 * t18;
        const doubles t27 = t14 * t17 - t15 * t16;
        const doubles t28 = t14 * t15 - t13 * t17;
        const doubles t29 = I_C[0] * (I_C[3] * I_C[5] - I_C[4] * I_C[4]);
        const doubles t30 = t29 + I_C[1] * (I_C[2] * I_C[4] - I_C[1] * I_C[5]);
        const truths t31 = equal(spread(0.0), t30 + I_C[2] * (I_C[1] * I_C[4] - I_C[2] * I_C[3]));
        const doubles t32 = choose(t31, spread(0.0), t13 * t25 + t14 * t26 + t15 * t27);
        const doubles t33 = choose(equal(t32, spread(0.0)), spread(0.0), spread(1.0)) / t32;
        const doubles t34 = choose(equal(m, spread(0.0)), spread(0.0), spread(1.0)) / m;
        const doubles t_dot3 = w[3] * t34;
        const doubles t_dot4 = w[4] * t34;
        const doubles t_dot5 = w[5] * t34;
        const doubles t_dot0 = t33 * (t22 * t25 + t23 * t26 + t24 * t27) / t12;
        const doubles t_dot1 = t33 * (t22 * t26 + t23 * (t13 * t18 - t15 * t15) + t24 * t28) / t12;
        const doubles t_dot2 = t33 * (t22 * t27 + t23 * t28 + t24 * (t13 * t16 - t14 * t14)) / t12;
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 6, sizeof(double), copied.ahead);
        const doubles result4[] = {t_dot0, t_dot1, t_dot2, t_dot3, t_dot4, t_dot5};
        if (dense4) {
            store_all(item4, step4, 6, result4);
        } else if (step4 == sizeof(double)) {
            PACKED(item4 + entries4[0], 0) = result4[0];
            PACKED(item4 + entries4[1], 0) = result4[1];
            PACKED(item4 + entries4[2], 0) = result4[2];
            PACKED(item4 + entries4[3], 0) = result4[3];
            PACKED(item4 + entries4[4], 0) = result4[4];
            PACKED(item4 + entries4[5], 0) = result4[5];
        } else {
            give_each(item4, entries4, step4, 6, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_sym6_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_newton_euler_twist_rate_sym6_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_newton_euler_twist_rate_sym6_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(float));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[6];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &I_C[0]);
            load_2f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        } else if (step0 == sizeof(float)) {
            I_C[0] = PACKEDF_IN(item0 + entries0[0], 0);
            I_C[1] = PACKEDF_IN(item0 + entries0[1], 0);
            I_C[2] = PACKEDF_IN(item0 + entries0[2], 0);
            I_C[3] = PACKEDF_IN(item0 + entries0[3], 0);
            I_C[4] = PACKEDF_IN(item0 + entries0[4], 0);
            I_C[5] = PACKEDF_IN(item0 + entries0[5], 0);
        } else {
            floats all[6];
            take_eachf(item0, entries0, step0, 6, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
        }
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 6, copied.ahead);
        if (dense2) {
            load_4f(item2 + 0 * sizeof(float), step2, &t[0]);
        } else if (step2 == sizeof(float)) {
            t[0] = PACKEDF_IN(item2 + entries2[0], 0);
            t[1] = PACKEDF_IN(item2 + entries2[1], 0);
            t[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[6];
            take_eachf(item2, entries2, step2, 6, all);
            t[0] = all[0];
            t[1] = all[1];
            t[2] = all[2];
        }
        floats w[6];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 6, copied.ahead);
        if (dense3) {
            load_4f(item3 + 0 * sizeof(float), step3, &w[0]);
            load_2f(item3 + 4 * sizeof(float), step3, &w[4]);
        } else if (step3 == sizeof(float)) {
            w[0] = PACKEDF_IN(item3 + entries3[0], 0);
            w[1] = PACKEDF_IN(item3 + entries3[1], 0);
            w[2] = PACKEDF_IN(item3 + entries3[2], 0);
            w[3] = PACKEDF_IN(item3 + entries3[3], 0);
            w[4] = PACKEDF_IN(item3 + entries3[4], 0);
            w[5] = PACKEDF_IN(item3 + entries3[5], 0);
        } else {
            floats all[6];
            take_eachf(item3, entries3, step3, 6, all);
            w[0] = all[0];
            w[1] = all[1];
            w[2] = all[2];
            w[3] = all[3];
            w[4] = all[4];
            w[5] = all[5];
        }
        const floats t1 = choosef(lessf(I_C[0], spreadf(0.0f)), -I_C[0], I_C[0]);
        const floats t2 = choosef(lessf(I_C[1], spreadf(0.0f)), -I_C[1], I_C[1]);
        const floats t3 = choosef(lessf(t1, t2), t2, t1);
        const floats t4 = choosef(lessf(I_C[2], spreadf(0.0f)), -I_C[2], I_C[2]);
        const floats t5 = choosef(lessf(t3, t4), t4, t3);
        const floats t6 = choosef(lessf(I_C[3], spreadf(0.0f)), -I_C[3], I_C[3]);
        const floats t7 = choosef(lessf(t5, t6), t6, t5);
        const floats t8 = choosef(lessf(I_C[4], spreadf(0.0f)), -I_C[4], I_C[4]);
        const floats t9 = choosef(lessf(t7, t8), t8, t7);
        const floats t10 = choosef(lessf(I_C[5], spreadf(0.0f)), -I_C[5], I_C[5]);
        const floats t11 = choosef(lessf(t9, t10), t10, t9);
        const floats t12 = choosef(equalf(spreadf(0.0f), t11), spreadf(1.0f), t11);
        const floats t13 = I_C[0] / t12;
        const floats t14 = I_C[1] / t12;
        const floats t15 = I_C[2] / t12;
        const floats t16 = I_C[3] / t12;
        const floats t17 = I_C[4] / t12;
        const floats t18 = I_C[5] / t12;
        const floats t19 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const floats t20 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
        const floats t21 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const floats t22 = w[0] - (t[1] * t21 - t[2] * t20);
        const floats t23 = w[1] - (t[2] * t19 - t[0] * t21);
        const floats t24 = w[2] - (t[0] * t20 - t[1] * t19);
        const floats t25 = t16 * t18 - t17 * t17;
        const floats t26 = t15 * t17 - t14 * t18;
        const floats t27 = t14 * t17 - t15 * t16;
        const floats t28 = t14 * t15 - t13 * t17;
        const floats t29 = I_C[0] * (I_C[3] * I_C[5] - I_C[4] * I_C[4]);
        const floats t30 = t29 + I_C[1] * (I_C[2] * I_C[4] - I_C[1] * I_C[5]);
        const floats t31 = t30 + I_C[2] * (I_C[1] * I_C[4] - I_C[2] * I_C[3]);
        const floats t32 = t13 * t25 + t14 * t26 + t15 * t27;
        const floats t33 = choosef(equalf(spreadf(0.0f), t31), spreadf(0.0f), t32);
        const floats t34 = choosef(equalf(t33, spreadf(0.0f)), spreadf(0.0f), spreadf(1.0f)) / t33;
        const floats t35 = choosef(equalf(m, spreadf(0.0f)), spreadf(0.0f), spreadf(1.0f)) / m;
        const floats t_dot3 = w[3] * t35;
        const floats t_dot4 = w[4] * t35;
        const floats t_dot5 = w[5] * t35;
        const floats t_dot0 = t34 * (t22 * t25 + t23 * t26 + t24 * t27) / t12;
        const floats t_dot1 = t34 * (t22 * t26 + t23 * (t13 * t18 - t15 * t15) + t24 * t28) / t12;
        const floats t_dot2 = t34 * (t22 * t27 + t23 * t28 + t24 * (t13 * t16 - t14 * t14)) / t12;
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 6, sizeof(float), copied.ahead);
        const floats result4[] = {t_dot0, t_dot1, t_dot2, t_dot3, t_dot4, t_dot5};
        if (dense4) {
            store_allf(item4, step4, 6, result4);
        } else if (step4 == sizeof(float)) {
            PACKEDF(item4 + entries4[0], 0) = result4[0];
            PACKEDF(item4 + entries4[1], 0) = result4[1];
            PACKEDF(item4 + entries4[2], 0) = result4[2];
            PACKEDF(item4 + entries4[3], 0) = result4[3];
            PACKEDF(item4 + entries4[4], 0) = result4[4];
            PACKEDF(item4 + entries4[5], 0) = result4[5];
        } else {
            give_eachf(item4, entries4, step4, 6, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_sym6_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_newton_euler_twist_rate_sym6_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_inertia_dyad_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 36 * sizeof(double));
    ptrdiff_t entries4[36];
    const int dense4 = CHASLES_DENSE(find_entries(36, 6, sizeof(double), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &I_C[0]);
            load_4(item0 + 4 * sizeof(double), step0, &I_C[4]);
            load_1(item0 + 8 * sizeof(double), step0, &I_C[8]);
        } else if (step0 == sizeof(double)) {
            I_C[0] = PACKED_IN(item0 + entries0[0], 0);
            I_C[1] = PACKED_IN(item0 + entries0[1], 0);
            I_C[2] = PACKED_IN(item0 + entries0[2], 0);
            I_C[3] = PACKED_IN(item0 + entries0[3], 0);
            I_C[4] = PACKED_IN(item0 + entries0[4], 0);
            I_C[5] = PACKED_IN(item0 + entries0[5], 0);
            I_C[6] = PACKED_IN(item0 + entries0[6], 0);
            I_C[7] = PACKED_IN(item0 + entries0[7], 0);
            I_C[8] = PACKED_IN(item0 + entries0[8], 0);
        } else {
            doubles all[9];
            take_each(item0, entries0, step0, 9, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
            I_C[6] = all[6];
            I_C[7] = all[7];
            I_C[8] = all[8];
        }
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &m);
        doubles c[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &c[0]);
        } else if (step2 == sizeof(double)) {
            c[0] = PACKED_IN(item2 + entries2[0], 0);
            c[1] = PACKED_IN(item2 + entries2[1], 0);
            c[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            c[0] = all[0];
            c[1] = all[1];
            c[2] = all[2];
        }
        doubles a[3];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3(item3 + 0 * sizeof(double), step3, &a[0]);
        } else if (step3 == sizeof(double)) {
            a[0] = PACKED_IN(item3 + entries3[0], 0);
            a[1] = PACKED_IN(item3 + entries3[1], 0);
            a[2] = PACKED_IN(item3 + entries3[2], 0);
        } else {
            doubles all[3];
            take_each(item3, entries3, step3, 3, all);
            a[0] = all[0];
            a[1] = all[1];
            a[2] = all[2];
        }
        const doubles M_A21 = m;
        const doubles t1 = a[0] - c[0];
        const doubles t2 = a[1] - c[1];
        const doubles t3 = a[2] - c[2];
        const doubles M_A11 = M_A21 * t1;
        const doubles M_A16 = -M_A11;
        const doubles M_A15 = M_A21 * t2;
        const doubles M_A5 = -M_A15;
        const doubles M_A4 = M_A21 * t3;
        const doubles M_A9 = -M_A4;
        const doubles t4 = t1 * M_A11;
        const doubles t5 = t1 * M_A15;
        const doubles t6 = t1 * M_A4;
        const doubles t7 = t2 * M_A15;
        const doubles t8 = t2 * M_A4;
        const doubles t9 = t3 * M_A4;
        const doubles M_A0 = I_C[0] + (t7 + t9);
        const doubles M_A1 = I_C[1] - t5;
        const doubles M_A2 = I_C[2] - t6;
        const doubles M_A6 = I_C[3] - t5;
        const doubles M_A7 = I_C[4] + (t4 + t9);
        const doubles M_A8 = I_C[5] - t8;
        const doubles M_A12 = I_C[6] - t6;
        const doubles M_A13 = I_C[7] - t8;
        const doubles M_A14 = I_C[8] + (t4 + t7);
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 36, sizeof(double), copied.ahead);
        const doubles result4[] = {
            M_A0,
            M_A1,
            M_A2,
            spread(0.0),
            M_A4,
            M_A5,
            M_A6,
            M_A7,
            M_A8,
            M_A9,
            spread(0.0),
            M_A11,
            M_A12,
            M_A13,
            M_A14,
            M_A15,
            M_A16,
            spread(0.0),
            spread(0.0),
            M_A9,
            M_A15,
            M_A21,
            spread(0.0),
            spread(0.0),
            M_A4,
            spread(0.0),
            M_A16,
            spread(0.0),
            M_A21,
            spread(0.0),
            M_A5,
            M_A11,
            spread(0.0),
            spread(0.0),
            spread(0.0),
            M_A21};
        if (dense4) {
            store_all(item4, step4, 36, result4);
        } else if (step4 == sizeof(double)) {
            PACKED(item4 + entries4[0], 0) = result4[0];
            PACKED(item4 + entries4[1], 0) = result4[1];
            PACKED(item4 + entries4[2], 0) = result4[2];
            PACKED(item4 + entries4[3], 0) = result4[3];
            PACKED(item4 + entries4[4], 0) = result4[4];
            PACKED(item4 + entries4[5], 0) = result4[5];
            PACKED(item4 + entries4[6], 0) = result4[6];
            PACKED(item4 + entries4[7], 0) = result4[7];
            PACKED(item4 + entries4[8], 0) = result4[8];
            PACKED(item4 + entries4[9], 0) = result4[9];
            PACKED(item4 + entries4[10], 0) = result4[10];
            PACKED(item4 + entries4[11], 0) = result4[11];
            PACKED(item4 + entries4[12], 0) = result4[12];
            PACKED(item4 + entries4[13], 0) = result4[13];
            PACKED(item4 + entries4[14], 0) = result4[14];
            PACKED(item4 + entries4[15], 0) = result4[15];
            PACKED(item4 + entries4[16], 0) = result4[16];
            PACKED(item4 + entries4[17], 0) = result4[17];
            PACKED(item4 + entries4[18], 0) = result4[18];
            PACKED(item4 + entries4[19], 0) = result4[19];
            PACKED(item4 + entries4[20], 0) = result4[20];
            PACKED(item4 + entries4[21], 0) = result4[21];
            PACKED(item4 + entries4[22], 0) = result4[22];
            PACKED(item4 + entries4[23], 0) = result4[23];
            PACKED(item4 + entries4[24], 0) = result4[24];
            PACKED(item4 + entries4[25], 0) = result4[25];
            PACKED(item4 + entries4[26], 0) = result4[26];
            PACKED(item4 + entries4[27], 0) = result4[27];
            PACKED(item4 + entries4[28], 0) = result4[28];
            PACKED(item4 + entries4[29], 0) = result4[29];
            PACKED(item4 + entries4[30], 0) = result4[30];
            PACKED(item4 + entries4[31], 0) = result4[31];
            PACKED(item4 + entries4[32], 0) = result4[32];
            PACKED(item4 + entries4[33], 0) = result4[33];
            PACKED(item4 + entries4[34], 0) = result4[34];
            PACKED(item4 + entries4[35], 0) = result4[35];
        } else {
            give_each(item4, entries4, step4, 36, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(double), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 7)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 9)
        && is_packed(3, 3, sizeof(double), steps[3], steps + 11)
        && is_packed(36, 6, sizeof(double), steps[4], steps + 13)) {
        chasles_inertia_dyad_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_inertia_dyad_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_inertia_dyad_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 36 * sizeof(float));
    ptrdiff_t entries4[36];
    const int dense4 = CHASLES_DENSE(find_entries(36, 6, sizeof(float), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &I_C[0]);
            load_4f(item0 + 4 * sizeof(float), step0, &I_C[4]);
            load_1f(item0 + 8 * sizeof(float), step0, &I_C[8]);
        } else if (step0 == sizeof(float)) {
            I_C[0] = PACKEDF_IN(item0 + entries0[0], 0);
            I_C[1] = PACKEDF_IN(item0 + entries0[1], 0);
            I_C[2] = PACKEDF_IN(item0 + entries0[2], 0);
            I_C[3] = PACKEDF_IN(item0 + entries0[3], 0);
            I_C[4] = PACKEDF_IN(item0 + entries0[4], 0);
            I_C[5] = PACKEDF_IN(item0 + entries0[5], 0);
            I_C[6] = PACKEDF_IN(item0 + entries0[6], 0);
            I_C[7] = PACKEDF_IN(item0 + entries0[7], 0);
            I_C[8] = PACKEDF_IN(item0 + entries0[8], 0);
        } else {
            floats all[9];
            take_eachf(item0, entries0, step0, 9, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
            I_C[6] = all[6];
            I_C[7] = all[7];
            I_C[8] = all[8];
        }
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &m);
        floats c[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &c[0]);
        } else if (step2 == sizeof(float)) {
            c[0] = PACKEDF_IN(item2 + entries2[0], 0);
            c[1] = PACKEDF_IN(item2 + entries2[1], 0);
            c[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            c[0] = all[0];
            c[1] = all[1];
            c[2] = all[2];
        }
        floats a[3];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3f(item3 + 0 * sizeof(float), step3, &a[0]);
        } else if (step3 == sizeof(float)) {
            a[0] = PACKEDF_IN(item3 + entries3[0], 0);
            a[1] = PACKEDF_IN(item3 + entries3[1], 0);
            a[2] = PACKEDF_IN(item3 + entries3[2], 0);
        } else {
            floats all[3];
            take_eachf(item3, entries3, step3, 3, all);
            a[0] = all[0];
            a[1] = all[1];
            a[2] = all[2];
        }
        const floats M_A21 = m;
        const floats t1 = a[0] - c[0];
        const floats t2 = a[1] - c[1];
        const floats t3 = a[2] - c[2];
        const floats M_A11 = M_A21 * t1;
        const floats M_A16 = -M_A11;
        const floats M_A15 = M_A21 * t2;
        const floats M_A5 = -M_A15;
        const floats M_A4 = M_A21 * t3;
        const floats M_A9 = -M_A4;
        const floats t4 = t1 * M_A11;
        const floats t5 = t1 * M_A15;
        const floats t6 = t1 * M_A4;
        const floats t7 = t2 * M_A15;
        const floats t8 = t2 * M_A4;
        const floats t9 = t3 * M_A4;
        const floats M_A0 = I_C[0] + (t7 + t9);
        const floats M_A1 = I_C[1] - t5;
        const floats M_A2 = I_C[2] - t6;
        const floats M_A6 = I_C[3] - t5;
        const floats M_A7 = I_C[4] + (t4 + t9);
        const floats M_A8 = I_C[5] - t8;
        const floats M_A12 = I_C[6] - t6;
        const floats M_A13 = I_C[7] - t8;
        const floats M_A14 = I_C[8] + (t4 + t7);
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 36, sizeof(float), copied.ahead);
        const floats result4[] = {
            M_A0,
            M_A1,
            M_A2,
            spreadf(0.0f),
            M_A4,
            M_A5,
            M_A6,
            M_A7,
            M_A8,
            M_A9,
            spreadf(0.0f),
            M_A11,
            M_A12,
            M_A13,
            M_A14,
            M_A15,
            M_A16,
            spreadf(0.0f),
            spreadf(0.0f),
            M_A9,
            M_A15,
            M_A21,
            spreadf(0.0f),
            spreadf(0.0f),
            M_A4,
            spreadf(0.0f),
            M_A16,
            spreadf(0.0f),
            M_A21,
            spreadf(0.0f),
            M_A5,
            M_A11,
            spreadf(0.0f),
            spreadf(0.0f),
            spreadf(0.0f),
            M_A21};
        if (dense4) {
            store_allf(item4, step4, 36, result4);
        } else if (step4 == sizeof(float)) {
            PACKEDF(item4 + entries4[0], 0) = result4[0];
            PACKEDF(item4 + entries4[1], 0) = result4[1];
            PACKEDF(item4 + entries4[2], 0) = result4[2];
            PACKEDF(item4 + entries4[3], 0) = result4[3];
            PACKEDF(item4 + entries4[4], 0) = result4[4];
            PACKEDF(item4 + entries4[5], 0) = result4[5];
            PACKEDF(item4 + entries4[6], 0) = result4[6];
            PACKEDF(item4 + entries4[7], 0) = result4[7];
            PACKEDF(item4 + entries4[8], 0) = result4[8];
            PACKEDF(item4 + entries4[9], 0) = result4[9];
            PACKEDF(item4 + entries4[10], 0) = result4[10];
            PACKEDF(item4 + entries4[11], 0) = result4[11];
            PACKEDF(item4 + entries4[12], 0) = result4[12];
            PACKEDF(item4 + entries4[13], 0) = result4[13];
            PACKEDF(item4 + entries4[14], 0) = result4[14];
            PACKEDF(item4 + entries4[15], 0) = result4[15];
            PACKEDF(item4 + entries4[16], 0) = result4[16];
            PACKEDF(item4 + entries4[17], 0) = result4[17];
            PACKEDF(item4 + entries4[18], 0) = result4[18];
            PACKEDF(item4 + entries4[19], 0) = result4[19];
            PACKEDF(item4 + entries4[20], 0) = result4[20];
            PACKEDF(item4 + entries4[21], 0) = result4[21];
            PACKEDF(item4 + entries4[22], 0) = result4[22];
            PACKEDF(item4 + entries4[23], 0) = result4[23];
            PACKEDF(item4 + entries4[24], 0) = result4[24];
            PACKEDF(item4 + entries4[25], 0) = result4[25];
            PACKEDF(item4 + entries4[26], 0) = result4[26];
            PACKEDF(item4 + entries4[27], 0) = result4[27];
            PACKEDF(item4 + entries4[28], 0) = result4[28];
            PACKEDF(item4 + entries4[29], 0) = result4[29];
            PACKEDF(item4 + entries4[30], 0) = result4[30];
            PACKEDF(item4 + entries4[31], 0) = result4[31];
            PACKEDF(item4 + entries4[32], 0) = result4[32];
            PACKEDF(item4 + entries4[33], 0) = result4[33];
            PACKEDF(item4 + entries4[34], 0) = result4[34];
            PACKEDF(item4 + entries4[35], 0) = result4[35];
        } else {
            give_eachf(item4, entries4, step4, 36, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(float), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 7)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 9)
        && is_packed(3, 3, sizeof(float), steps[3], steps + 11)
        && is_packed(36, 6, sizeof(float), steps[4], steps + 13)) {
        chasles_inertia_dyad_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_inertia_dyad_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_inertia_dyad_sym6_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 36 * sizeof(double));
    ptrdiff_t entries4[36];
    const int dense4 = CHASLES_DENSE(find_entries(36, 6, sizeof(double), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[6];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &I_C[0]);
            load_2(item0 + 4 * sizeof(double), step0, &I_C[4]);
        } else if (step0 == sizeof(double)) {
            I_C[0] = PACKED_IN(item0 + entries0[0], 0);
            I_C[1] = PACKED_IN(item0 + entries0[1], 0);
            I_C[2] = PACKED_IN(item0 + entries0[2], 0);
            I_C[3] = PACKED_IN(item0 + entries0[3], 0);
            I_C[4] = PACKED_IN(item0 + entries0[4], 0);
            I_C[5] = PACKED_IN(item0 + entries0[5], 0);
        } else {
            doubles all[6];
            take_each(item0, entries0, step0, 6, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
        }
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &m);
        doubles c[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &c[0]);
        } else if (step2 == sizeof(double)) {
            c[0] = PACKED_IN(item2 + entries2[0], 0);
            c[1] = PACKED_IN(item2 + entries2[1], 0);
            c[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            c[0] = all[0];
            c[1] = all[1];
            c[2] = all[2];
        }
        doubles a[3];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3(item3 + 0 * sizeof(double), step3, &a[0]);
        } else if (step3 == sizeof(double)) {
            a[0] = PACKED_IN(item3 + entries3[0], 0);
            a[1] = PACKED_IN(item3 + entries3[1], 0);
            a[2] = PACKED_IN(item3 + entries3[2], 0);
        } else {
            doubles all[3];
            take_each(item3, entries3, step3, 3, all);
            a[0] = all[0];
            a[1] = all[1];
            a[2] = all[2];
        }
        const doubles M_A21 = m;
        const doubles t1 = a[0] - c[0];
        const doubles t2 = a[1] - c[1];
        const doubles t3 = a[2] - c[2];
        const doubles M_A11 = M_A21 * t1;
        const doubles M_A16 = -M_A11;
        const doubles M_A15 = M_A21 * t2;
        const doubles M_A5 = -M_A15;
        const doubles M_A4 = M_A21 * t3;
        const doubles M_A9 = -M_A4;
        const doubles t4 = t1 * M_A11;
        const doubles t5 = t2 * M_A15;
        const doubles t6 = t3 * M_A4;
        const doubles M_A0 = I_C[0] + (t5 + t6);
        const doubles M_A1 = I_C[1] - t1 * M_A15;
        const doubles M_A2 = I_C[2] - t1 * M_A4;
        const doubles M_A7 = I_C[3] + (t4 + t6);
        const doubles M_A8 = I_C[4] - t2 * M_A4;
        const doubles M_A14 = I_C[5] + (t4 + t5);
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 36, sizeof(double), copied.ahead);
        const doubles result4[] = {
            M_A0,
            M_A1,
            M_A2,
            spread(0.0),
            M_A4,
            M_A5,
            M_A1,
            M_A7,
            M_A8,
            M_A9,
            spread(0.0),
            M_A11,
            M_A2,
            M_A8,
            M_A14,
            M_A15,
            M_A16,
            spread(0.0),
            spread(0.0),
            M_A9,
            M_A15,
            M_A21,
            spread(0.0),
            spread(0.0),
            M_A4,
            spread(0.0),
            M_A16,
            spread(0.0),
            M_A21,
            spread(0.0),
            M_A5,
            M_A11,
            spread(0.0),
            spread(0.0),
            spread(0.0),
            M_A21};
        if (dense4) {
            store_all(item4, step4, 36, result4);
        } else if (step4 == sizeof(double)) {
            PACKED(item4 + entries4[0], 0) = result4[0];
            PACKED(item4 + entries4[1], 0) = result4[1];
            PACKED(item4 + entries4[2], 0) = result4[2];
            PACKED(item4 + entries4[3], 0) = result4[3];
            PACKED(item4 + entries4[4], 0) = result4[4];
            PACKED(item4 + entries4[5], 0) = result4[5];
            PACKED(item4 + entries4[6], 0) = result4[6];
            PACKED(item4 + entries4[7], 0) = result4[7];
            PACKED(item4 + entries4[8], 0) = result4[8];
            PACKED(item4 + entries4[9], 0) = result4[9];
            PACKED(item4 + entries4[10], 0) = result4[10];
            PACKED(item4 + entries4[11], 0) = result4[11];
            PACKED(item4 + entries4[12], 0) = result4[12];
            PACKED(item4 + entries4[13], 0) = result4[13];
            PACKED(item4 + entries4[14], 0) = result4[14];
            PACKED(item4 + entries4[15], 0) = result4[15];
            PACKED(item4 + entries4[16], 0) = result4[16];
            PACKED(item4 + entries4[17], 0) = result4[17];
            PACKED(item4 + entries4[18], 0) = result4[18];
            PACKED(item4 + entries4[19], 0) = result4[19];
            PACKED(item4 + entries4[20], 0) = result4[20];
            PACKED(item4 + entries4[21], 0) = result4[21];
            PACKED(item4 + entries4[22], 0) = result4[22];
            PACKED(item4 + entries4[23], 0) = result4[23];
            PACKED(item4 + entries4[24], 0) = result4[24];
            PACKED(item4 + entries4[25], 0) = result4[25];
            PACKED(item4 + entries4[26], 0) = result4[26];
            PACKED(item4 + entries4[27], 0) = result4[27];
            PACKED(item4 + entries4[28], 0) = result4[28];
            PACKED(item4 + entries4[29], 0) = result4[29];
            PACKED(item4 + entries4[30], 0) = result4[30];
            PACKED(item4 + entries4[31], 0) = result4[31];
            PACKED(item4 + entries4[32], 0) = result4[32];
            PACKED(item4 + entries4[33], 0) = result4[33];
            PACKED(item4 + entries4[34], 0) = result4[34];
            PACKED(item4 + entries4[35], 0) = result4[35];
        } else {
            give_each(item4, entries4, step4, 36, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_sym6_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(double), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 7)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 9)
        && is_packed(3, 3, sizeof(double), steps[3], steps + 11)
        && is_packed(36, 6, sizeof(double), steps[4], steps + 13)) {
        chasles_inertia_dyad_sym6_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_inertia_dyad_sym6_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_inertia_dyad_sym6_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    ptrdiff_t entries0[6];
    const int dense0 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 36 * sizeof(float));
    ptrdiff_t entries4[36];
    const int dense4 = CHASLES_DENSE(find_entries(36, 6, sizeof(float), step4, steps + 13, entries4));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[6];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &I_C[0]);
            load_2f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        } else if (step0 == sizeof(float)) {
            I_C[0] = PACKEDF_IN(item0 + entries0[0], 0);
            I_C[1] = PACKEDF_IN(item0 + entries0[1], 0);
            I_C[2] = PACKEDF_IN(item0 + entries0[2], 0);
            I_C[3] = PACKEDF_IN(item0 + entries0[3], 0);
            I_C[4] = PACKEDF_IN(item0 + entries0[4], 0);
            I_C[5] = PACKEDF_IN(item0 + entries0[5], 0);
        } else {
            floats all[6];
            take_eachf(item0, entries0, step0, 6, all);
            I_C[0] = all[0];
            I_C[1] = all[1];
            I_C[2] = all[2];
            I_C[3] = all[3];
            I_C[4] = all[4];
            I_C[5] = all[5];
        }
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &m);
        floats c[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &c[0]);
        } else if (step2 == sizeof(float)) {
            c[0] = PACKEDF_IN(item2 + entries2[0], 0);
            c[1] = PACKEDF_IN(item2 + entries2[1], 0);
            c[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            c[0] = all[0];
            c[1] = all[1];
            c[2] = all[2];
        }
        floats a[3];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3f(item3 + 0 * sizeof(float), step3, &a[0]);
        } else if (step3 == sizeof(float)) {
            a[0] = PACKEDF_IN(item3 + entries3[0], 0);
            a[1] = PACKEDF_IN(item3 + entries3[1], 0);
            a[2] = PACKEDF_IN(item3 + entries3[2], 0);
        } else {
            floats all[3];
            take_eachf(item3, entries3, step3, 3, all);
            a[0] = all[0];
            a[1] = all[1];
            a[2] = all[2];
        }
        const floats M_A21 = m;
        const floats t1 = a[0] - c[0];
        const floats t2 = a[1] - c[1];
        const floats t3 = a[2] - c[2];
        const floats M_A11 = M_A21 * t1;
        const floats M_A16 = -M_A11;
        const floats M_A15 = M_A21 * t2;
        const floats M_A5 = -M_A15;
        const floats M_A4 = M_A21 * t3;
        const floats M_A9 = -M_A4;
        const floats t4 = t1 * M_A11;
        const floats t5 = t2 * M_A15;
        const floats t6 = t3 * M_A4;
        const floats M_A0 = I_C[0] + (t5 + t6);
        const floats M_A1 = I_C[1] - t1 * M_A15;
        const floats M_A2 = I_C[2] - t1 * M_A4;
        const floats M_A7 = I_C[3] + (t4 + t6);
        const floats M_A8 = I_C[4] - t2 * M_A4;
        const floats M_A14 = I_C[5] + (t4 + t5);
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 36, sizeof(float), copied.ahead);
        const floats result4[] = {
            M_A0,
            M_A1,
            M_A2,
            spreadf(0.0f),
            M_A4,
            M_A5,
            M_A1,
            M_A7,
            M_A8,
            M_A9,
            spreadf(0.0f),
            M_A11,
            M_A2,
            M_A8,
            M_A14,
            M_A15,
            M_A16,
            spreadf(0.0f),
            spreadf(0.0f),
            M_A9,
            M_A15,
            M_A21,
            spreadf(0.0f),
            spreadf(0.0f),
            M_A4,
            spreadf(0.0f),
            M_A16,
            spreadf(0.0f),
            M_A21,
            spreadf(0.0f),
            M_A5,
            M_A11,
            spreadf(0.0f),
            spreadf(0.0f),
            spreadf(0.0f),
            M_A21};
        if (dense4) {
            store_allf(item4, step4, 36, result4);
        } else if (step4 == sizeof(float)) {
            PACKEDF(item4 + entries4[0], 0) = result4[0];
            PACKEDF(item4 + entries4[1], 0) = result4[1];
            PACKEDF(item4 + entries4[2], 0) = result4[2];
            PACKEDF(item4 + entries4[3], 0) = result4[3];
            PACKEDF(item4 + entries4[4], 0) = result4[4];
            PACKEDF(item4 + entries4[5], 0) = result4[5];
            PACKEDF(item4 + entries4[6], 0) = result4[6];
            PACKEDF(item4 + entries4[7], 0) = result4[7];
            PACKEDF(item4 + entries4[8], 0) = result4[8];
            PACKEDF(item4 + entries4[9], 0) = result4[9];
            PACKEDF(item4 + entries4[10], 0) = result4[10];
            PACKEDF(item4 + entries4[11], 0) = result4[11];
            PACKEDF(item4 + entries4[12], 0) = result4[12];
            PACKEDF(item4 + entries4[13], 0) = result4[13];
            PACKEDF(item4 + entries4[14], 0) = result4[14];
            PACKEDF(item4 + entries4[15], 0) = result4[15];
            PACKEDF(item4 + entries4[16], 0) = result4[16];
            PACKEDF(item4 + entries4[17], 0) = result4[17];
            PACKEDF(item4 + entries4[18], 0) = result4[18];
            PACKEDF(item4 + entries4[19], 0) = result4[19];
            PACKEDF(item4 + entries4[20], 0) = result4[20];
            PACKEDF(item4 + entries4[21], 0) = result4[21];
            PACKEDF(item4 + entries4[22], 0) = result4[22];
            PACKEDF(item4 + entries4[23], 0) = result4[23];
            PACKEDF(item4 + entries4[24], 0) = result4[24];
            PACKEDF(item4 + entries4[25], 0) = result4[25];
            PACKEDF(item4 + entries4[26], 0) = result4[26];
            PACKEDF(item4 + entries4[27], 0) = result4[27];
            PACKEDF(item4 + entries4[28], 0) = result4[28];
            PACKEDF(item4 + entries4[29], 0) = result4[29];
            PACKEDF(item4 + entries4[30], 0) = result4[30];
            PACKEDF(item4 + entries4[31], 0) = result4[31];
            PACKEDF(item4 + entries4[32], 0) = result4[32];
            PACKEDF(item4 + entries4[33], 0) = result4[33];
            PACKEDF(item4 + entries4[34], 0) = result4[34];
            PACKEDF(item4 + entries4[35], 0) = result4[35];
        } else {
            give_eachf(item4, entries4, step4, 36, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_sym6_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(float), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 7)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 9)
        && is_packed(3, 3, sizeof(float), steps[3], steps + 11)
        && is_packed(36, 6, sizeof(float), steps[4], steps + 13)) {
        chasles_inertia_dyad_sym6_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_inertia_dyad_sym6_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

#else

void CHASLES_LEVELED(chasles_inertia_about_point_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_about_point(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_inertia_about_point_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_about_pointf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_inertia_about_point_sym6_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_about_point_sym6(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_inertia_about_point_sym6_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_about_point_sym6f(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_momentum_screw_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_momentum_screw(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_momentum_screw_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_momentum_screwf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_momentum_screw_sym6_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_momentum_screw_sym6(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_momentum_screw_sym6_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_momentum_screw_sym6f(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_kinetic_energy(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_kinetic_energyf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_sym6_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_kinetic_energy_sym6(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_sym6_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_kinetic_energy_sym6f(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_wrench(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_wrenchf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_sym6_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_wrench_sym6(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_sym6_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_wrench_sym6f(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_twist_rate(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_twist_ratef(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_sym6_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_twist_rate_sym6(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_sym6_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_twist_rate_sym6f(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_dyad(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_dyadf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_sym6_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_dyad_sym6(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_sym6_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_dyad_sym6f(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

#endif
