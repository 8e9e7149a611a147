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

CHASLES_INLINE void chasles_rotation_in_triad_axes_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(double));
    ptrdiff_t entries2[9];
    const int dense2 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles triad[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &triad[0]);
            load_4(item0 + 4 * sizeof(double), step0, &triad[4]);
            load_1(item0 + 8 * sizeof(double), step0, &triad[8]);
        } else if (step0 == sizeof(double)) {
            triad[0] = PACKED_IN(item0 + entries0[0], 0);
            triad[1] = PACKED_IN(item0 + entries0[1], 0);
            triad[2] = PACKED_IN(item0 + entries0[2], 0);
            triad[3] = PACKED_IN(item0 + entries0[3], 0);
            triad[4] = PACKED_IN(item0 + entries0[4], 0);
            triad[5] = PACKED_IN(item0 + entries0[5], 0);
            triad[6] = PACKED_IN(item0 + entries0[6], 0);
            triad[7] = PACKED_IN(item0 + entries0[7], 0);
            triad[8] = PACKED_IN(item0 + entries0[8], 0);
        } else {
            doubles all[9];
            take_each(item0, entries0, step0, 9, all);
            triad[0] = all[0];
            triad[1] = all[1];
            triad[2] = all[2];
            triad[3] = all[3];
            triad[4] = all[4];
            triad[5] = all[5];
            triad[6] = all[6];
            triad[7] = all[7];
            triad[8] = all[8];
        }
        doubles triad_prime[9];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 9, copied.ahead);
        if (dense1) {
            load_4(item1 + 0 * sizeof(double), step1, &triad_prime[0]);
            load_4(item1 + 4 * sizeof(double), step1, &triad_prime[4]);
            load_1(item1 + 8 * sizeof(double), step1, &triad_prime[8]);
        } else if (step1 == sizeof(double)) {
            triad_prime[0] = PACKED_IN(item1 + entries1[0], 0);
            triad_prime[1] = PACKED_IN(item1 + entries1[1], 0);
            triad_prime[2] = PACKED_IN(item1 + entries1[2], 0);
            triad_prime[3] = PACKED_IN(item1 + entries1[3], 0);
            triad_prime[4] = PACKED_IN(item1 + entries1[4], 0);
            triad_prime[5] = PACKED_IN(item1 + entries1[5], 0);
            triad_prime[6] = PACKED_IN(item1 + entries1[6], 0);
            triad_prime[7] = PACKED_IN(item1 + entries1[7], 0);
            triad_prime[8] = PACKED_IN(item1 + entries1[8], 0);
        } else {
            doubles all[9];
            take_each(item1, entries1, step1, 9, all);
            triad_prime[0] = all[0];
            triad_prime[1] = all[1];
            triad_prime[2] = all[2];
            triad_prime[3] = all[3];
            triad_prime[4] = all[4];
            triad_prime[5] = all[5];
            triad_prime[6] = all[6];
            triad_prime[7] = all[7];
            triad_prime[8] = all[8];
        }
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
        prefetch_to_write(item2, step2, 9, sizeof(double), copied.ahead);
        const doubles result2[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense2) {
            store_all(item2, step2, 9, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
            PACKED(item2 + entries2[3], 0) = result2[3];
            PACKED(item2 + entries2[4], 0) = result2[4];
            PACKED(item2 + entries2[5], 0) = result2[5];
            PACKED(item2 + entries2[6], 0) = result2[6];
            PACKED(item2 + entries2[7], 0) = result2[7];
            PACKED(item2 + entries2[8], 0) = result2[8];
        } else {
            give_each(item2, entries2, step2, 9, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_in_triad_axes_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(double), steps[0], steps + 3)
        && is_packed(9, 3, sizeof(double), steps[1], steps + 5)
        && is_packed(9, 3, sizeof(double), steps[2], steps + 7)) {
        chasles_rotation_in_triad_axes_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_rotation_in_triad_axes_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_in_triad_axes_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(float));
    ptrdiff_t entries2[9];
    const int dense2 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats triad[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &triad[0]);
            load_4f(item0 + 4 * sizeof(float), step0, &triad[4]);
            load_1f(item0 + 8 * sizeof(float), step0, &triad[8]);
        } else if (step0 == sizeof(float)) {
            triad[0] = PACKEDF_IN(item0 + entries0[0], 0);
            triad[1] = PACKEDF_IN(item0 + entries0[1], 0);
            triad[2] = PACKEDF_IN(item0 + entries0[2], 0);
            triad[3] = PACKEDF_IN(item0 + entries0[3], 0);
            triad[4] = PACKEDF_IN(item0 + entries0[4], 0);
            triad[5] = PACKEDF_IN(item0 + entries0[5], 0);
            triad[6] = PACKEDF_IN(item0 + entries0[6], 0);
            triad[7] = PACKEDF_IN(item0 + entries0[7], 0);
            triad[8] = PACKEDF_IN(item0 + entries0[8], 0);
        } else {
            floats all[9];
            take_eachf(item0, entries0, step0, 9, all);
            triad[0] = all[0];
            triad[1] = all[1];
            triad[2] = all[2];
            triad[3] = all[3];
            triad[4] = all[4];
            triad[5] = all[5];
            triad[6] = all[6];
            triad[7] = all[7];
            triad[8] = all[8];
        }
        floats triad_prime[9];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 9, copied.ahead);
        if (dense1) {
            load_4f(item1 + 0 * sizeof(float), step1, &triad_prime[0]);
            load_4f(item1 + 4 * sizeof(float), step1, &triad_prime[4]);
            load_1f(item1 + 8 * sizeof(float), step1, &triad_prime[8]);
        } else if (step1 == sizeof(float)) {
            triad_prime[0] = PACKEDF_IN(item1 + entries1[0], 0);
            triad_prime[1] = PACKEDF_IN(item1 + entries1[1], 0);
            triad_prime[2] = PACKEDF_IN(item1 + entries1[2], 0);
            triad_prime[3] = PACKEDF_IN(item1 + entries1[3], 0);
            triad_prime[4] = PACKEDF_IN(item1 + entries1[4], 0);
            triad_prime[5] = PACKEDF_IN(item1 + entries1[5], 0);
            triad_prime[6] = PACKEDF_IN(item1 + entries1[6], 0);
            triad_prime[7] = PACKEDF_IN(item1 + entries1[7], 0);
            triad_prime[8] = PACKEDF_IN(item1 + entries1[8], 0);
        } else {
            floats all[9];
            take_eachf(item1, entries1, step1, 9, all);
            triad_prime[0] = all[0];
            triad_prime[1] = all[1];
            triad_prime[2] = all[2];
            triad_prime[3] = all[3];
            triad_prime[4] = all[4];
            triad_prime[5] = all[5];
            triad_prime[6] = all[6];
            triad_prime[7] = all[7];
            triad_prime[8] = all[8];
        }
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
        prefetch_to_write(item2, step2, 9, sizeof(float), copied.ahead);
        const floats result2[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense2) {
            store_allf(item2, step2, 9, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
            PACKEDF(item2 + entries2[3], 0) = result2[3];
            PACKEDF(item2 + entries2[4], 0) = result2[4];
            PACKEDF(item2 + entries2[5], 0) = result2[5];
            PACKEDF(item2 + entries2[6], 0) = result2[6];
            PACKEDF(item2 + entries2[7], 0) = result2[7];
            PACKEDF(item2 + entries2[8], 0) = result2[8];
        } else {
            give_eachf(item2, entries2, step2, 9, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_in_triad_axes_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(float), steps[0], steps + 3)
        && is_packed(9, 3, sizeof(float), steps[1], steps + 5)
        && is_packed(9, 3, sizeof(float), steps[2], steps + 7)) {
        chasles_rotation_in_triad_axes_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_rotation_in_triad_axes_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_triads_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(double));
    ptrdiff_t entries2[9];
    const int dense2 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles triad[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &triad[0]);
            load_4(item0 + 4 * sizeof(double), step0, &triad[4]);
            load_1(item0 + 8 * sizeof(double), step0, &triad[8]);
        } else if (step0 == sizeof(double)) {
            triad[0] = PACKED_IN(item0 + entries0[0], 0);
            triad[1] = PACKED_IN(item0 + entries0[1], 0);
            triad[2] = PACKED_IN(item0 + entries0[2], 0);
            triad[3] = PACKED_IN(item0 + entries0[3], 0);
            triad[4] = PACKED_IN(item0 + entries0[4], 0);
            triad[5] = PACKED_IN(item0 + entries0[5], 0);
            triad[6] = PACKED_IN(item0 + entries0[6], 0);
            triad[7] = PACKED_IN(item0 + entries0[7], 0);
            triad[8] = PACKED_IN(item0 + entries0[8], 0);
        } else {
            doubles all[9];
            take_each(item0, entries0, step0, 9, all);
            triad[0] = all[0];
            triad[1] = all[1];
            triad[2] = all[2];
            triad[3] = all[3];
            triad[4] = all[4];
            triad[5] = all[5];
            triad[6] = all[6];
            triad[7] = all[7];
            triad[8] = all[8];
        }
        doubles triad_prime[9];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 9, copied.ahead);
        if (dense1) {
            load_4(item1 + 0 * sizeof(double), step1, &triad_prime[0]);
            load_4(item1 + 4 * sizeof(double), step1, &triad_prime[4]);
            load_1(item1 + 8 * sizeof(double), step1, &triad_prime[8]);
        } else if (step1 == sizeof(double)) {
            triad_prime[0] = PACKED_IN(item1 + entries1[0], 0);
            triad_prime[1] = PACKED_IN(item1 + entries1[1], 0);
            triad_prime[2] = PACKED_IN(item1 + entries1[2], 0);
            triad_prime[3] = PACKED_IN(item1 + entries1[3], 0);
            triad_prime[4] = PACKED_IN(item1 + entries1[4], 0);
            triad_prime[5] = PACKED_IN(item1 + entries1[5], 0);
            triad_prime[6] = PACKED_IN(item1 + entries1[6], 0);
            triad_prime[7] = PACKED_IN(item1 + entries1[7], 0);
            triad_prime[8] = PACKED_IN(item1 + entries1[8], 0);
        } else {
            doubles all[9];
            take_each(item1, entries1, step1, 9, all);
            triad_prime[0] = all[0];
            triad_prime[1] = all[1];
            triad_prime[2] = all[2];
            triad_prime[3] = all[3];
            triad_prime[4] = all[4];
            triad_prime[5] = all[5];
            triad_prime[6] = all[6];
            triad_prime[7] = all[7];
            triad_prime[8] = all[8];
        }
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
        prefetch_to_write(item2, step2, 9, sizeof(double), copied.ahead);
        const doubles result2[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense2) {
            store_all(item2, step2, 9, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
            PACKED(item2 + entries2[3], 0) = result2[3];
            PACKED(item2 + entries2[4], 0) = result2[4];
            PACKED(item2 + entries2[5], 0) = result2[5];
            PACKED(item2 + entries2[6], 0) = result2[6];
            PACKED(item2 + entries2[7], 0) = result2[7];
            PACKED(item2 + entries2[8], 0) = result2[8];
        } else {
            give_each(item2, entries2, step2, 9, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_triads_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(double), steps[0], steps + 3)
        && is_packed(9, 3, sizeof(double), steps[1], steps + 5)
        && is_packed(9, 3, sizeof(double), steps[2], steps + 7)) {
        chasles_rotation_from_triads_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_rotation_from_triads_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_triads_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(float));
    ptrdiff_t entries2[9];
    const int dense2 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats triad[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &triad[0]);
            load_4f(item0 + 4 * sizeof(float), step0, &triad[4]);
            load_1f(item0 + 8 * sizeof(float), step0, &triad[8]);
        } else if (step0 == sizeof(float)) {
            triad[0] = PACKEDF_IN(item0 + entries0[0], 0);
            triad[1] = PACKEDF_IN(item0 + entries0[1], 0);
            triad[2] = PACKEDF_IN(item0 + entries0[2], 0);
            triad[3] = PACKEDF_IN(item0 + entries0[3], 0);
            triad[4] = PACKEDF_IN(item0 + entries0[4], 0);
            triad[5] = PACKEDF_IN(item0 + entries0[5], 0);
            triad[6] = PACKEDF_IN(item0 + entries0[6], 0);
            triad[7] = PACKEDF_IN(item0 + entries0[7], 0);
            triad[8] = PACKEDF_IN(item0 + entries0[8], 0);
        } else {
            floats all[9];
            take_eachf(item0, entries0, step0, 9, all);
            triad[0] = all[0];
            triad[1] = all[1];
            triad[2] = all[2];
            triad[3] = all[3];
            triad[4] = all[4];
            triad[5] = all[5];
            triad[6] = all[6];
            triad[7] = all[7];
            triad[8] = all[8];
        }
        floats triad_prime[9];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 9, copied.ahead);
        if (dense1) {
            load_4f(item1 + 0 * sizeof(float), step1, &triad_prime[0]);
            load_4f(item1 + 4 * sizeof(float), step1, &triad_prime[4]);
            load_1f(item1 + 8 * sizeof(float), step1, &triad_prime[8]);
        } else if (step1 == sizeof(float)) {
            triad_prime[0] = PACKEDF_IN(item1 + entries1[0], 0);
            triad_prime[1] = PACKEDF_IN(item1 + entries1[1], 0);
            triad_prime[2] = PACKEDF_IN(item1 + entries1[2], 0);
            triad_prime[3] = PACKEDF_IN(item1 + entries1[3], 0);
            triad_prime[4] = PACKEDF_IN(item1 + entries1[4], 0);
            triad_prime[5] = PACKEDF_IN(item1 + entries1[5], 0);
            triad_prime[6] = PACKEDF_IN(item1 + entries1[6], 0);
            triad_prime[7] = PACKEDF_IN(item1 + entries1[7], 0);
            triad_prime[8] = PACKEDF_IN(item1 + entries1[8], 0);
        } else {
            floats all[9];
            take_eachf(item1, entries1, step1, 9, all);
            triad_prime[0] = all[0];
            triad_prime[1] = all[1];
            triad_prime[2] = all[2];
            triad_prime[3] = all[3];
            triad_prime[4] = all[4];
            triad_prime[5] = all[5];
            triad_prime[6] = all[6];
            triad_prime[7] = all[7];
            triad_prime[8] = all[8];
        }
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
        prefetch_to_write(item2, step2, 9, sizeof(float), copied.ahead);
        const floats result2[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense2) {
            store_allf(item2, step2, 9, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
            PACKEDF(item2 + entries2[3], 0) = result2[3];
            PACKEDF(item2 + entries2[4], 0) = result2[4];
            PACKEDF(item2 + entries2[5], 0) = result2[5];
            PACKEDF(item2 + entries2[6], 0) = result2[6];
            PACKEDF(item2 + entries2[7], 0) = result2[7];
            PACKEDF(item2 + entries2[8], 0) = result2[8];
        } else {
            give_eachf(item2, entries2, step2, 9, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_triads_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(float), steps[0], steps + 3)
        && is_packed(9, 3, sizeof(float), steps[1], steps + 5)
        && is_packed(9, 3, sizeof(float), steps[2], steps + 7)) {
        chasles_rotation_from_triads_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_rotation_from_triads_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

#else

void CHASLES_LEVELED(chasles_rotation_in_triad_axes_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
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
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
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
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
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
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
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
