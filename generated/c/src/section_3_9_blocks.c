/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_9, for batches. Made by `chasles emit`; not to be edited by hand.
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

CHASLES_INLINE void chasles_rotation_from_euler_xyx_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[3][GROUPS];
    doubles sines[3][GROUPS];
    doubles cosines[3][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles sin_angles_2 = sines[2][g];
        const doubles cos_angles_2 = cosines[2][g];
        const doubles Q0 = cos_angles_1;
        const doubles Q3 = sin_angles_0 * sin_angles_1;
        const doubles t1 = sin_angles_0 * Q0;
        const doubles Q6 = -(cos_angles_0 * sin_angles_1);
        const doubles t2 = cos_angles_0 * Q0;
        const doubles Q1 = sin_angles_1 * sin_angles_2;
        const doubles Q2 = sin_angles_1 * cos_angles_2;
        const doubles Q4 = cos_angles_0 * cos_angles_2 - t1 * sin_angles_2;
        const doubles Q5 = -(cos_angles_0 * sin_angles_2 + t1 * cos_angles_2);
        const doubles Q7 = sin_angles_0 * cos_angles_2 + t2 * sin_angles_2;
        const doubles Q8 = t2 * cos_angles_2 - sin_angles_0 * sin_angles_2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_xyx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_xyx_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[3][GROUPSF];
    floats sines[3][GROUPSF];
    floats cosines[3][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats sin_angles_2 = sines[2][g];
        const floats cos_angles_2 = cosines[2][g];
        const floats Q0 = cos_angles_1;
        const floats Q3 = sin_angles_0 * sin_angles_1;
        const floats t1 = sin_angles_0 * Q0;
        const floats Q6 = -(cos_angles_0 * sin_angles_1);
        const floats t2 = cos_angles_0 * Q0;
        const floats Q1 = sin_angles_1 * sin_angles_2;
        const floats Q2 = sin_angles_1 * cos_angles_2;
        const floats Q4 = cos_angles_0 * cos_angles_2 - t1 * sin_angles_2;
        const floats Q5 = -(cos_angles_0 * sin_angles_2 + t1 * cos_angles_2);
        const floats Q7 = sin_angles_0 * cos_angles_2 + t2 * sin_angles_2;
        const floats Q8 = t2 * cos_angles_2 - sin_angles_0 * sin_angles_2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_xyx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_xyx_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles W4 = cos_angles_0;
        const doubles W7 = sin_angles_0;
        const doubles W2 = cos_angles_1;
        const doubles W5 = W7 * sin_angles_1;
        const doubles W8 = -(W4 * sin_angles_1);
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {spread(1.0), spread(0.0), W2, spread(0.0), W4, W5, spread(0.0), W7, W8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_xyx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_xyx_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats W4 = cos_angles_0;
        const floats W7 = sin_angles_0;
        const floats W2 = cos_angles_1;
        const floats W5 = W7 * sin_angles_1;
        const floats W8 = -(W4 * sin_angles_1);
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            spreadf(1.0f),
            spreadf(0.0f),
            W2,
            spreadf(0.0f),
            W4,
            W5,
            spreadf(0.0f),
            W7,
            W8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_xyx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_xyx_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 1 * sizeof(double), step0, &angles_[1]);
        } else if (step0 == sizeof(double)) {
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_2 = sines[1][g];
        const doubles cos_angles_2 = cosines[1][g];
        const doubles W_body0 = cos_angles_1;
        const doubles W_body4 = cos_angles_2;
        const doubles W_body3 = sin_angles_1 * sin_angles_2;
        const doubles W_body7 = -sin_angles_2;
        const doubles W_body6 = sin_angles_1 * W_body4;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {
            W_body0,
            spread(0.0),
            spread(1.0),
            W_body3,
            W_body4,
            spread(0.0),
            W_body6,
            W_body7,
            spread(0.0)};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_xyx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_xyx_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 1 * sizeof(float), step0, &angles_[1]);
        } else if (step0 == sizeof(float)) {
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_2 = sines[1][g];
        const floats cos_angles_2 = cosines[1][g];
        const floats W_body0 = cos_angles_1;
        const floats W_body4 = cos_angles_2;
        const floats W_body3 = sin_angles_1 * sin_angles_2;
        const floats W_body7 = -sin_angles_2;
        const floats W_body6 = sin_angles_1 * W_body4;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            W_body0,
            spreadf(0.0f),
            spreadf(1.0f),
            W_body3,
            W_body4,
            spreadf(0.0f),
            W_body6,
            W_body7,
            spreadf(0.0f)};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_xyx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_xyx_block_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &omega[0]);
        } else if (step1 == sizeof(double)) {
            omega[0] = PACKED_IN(item1 + entries1[0], 0);
            omega[1] = PACKED_IN(item1 + entries1[1], 0);
            omega[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_0 = sines[1][g];
        const doubles cos_angles_0 = cosines[1][g];
        const doubles t1 = omega[1] * sin_angles_0 - omega[2] * cos_angles_0;
        const doubles theta_dot2 = choose(equal(sin_angles_1, spread(0.0)), spread(0.0), t1) / sin_angles_1;
        const doubles theta_dot0 = omega[0] - cos_angles_1 * theta_dot2;
        const doubles theta_dot1 = omega[1] * cos_angles_0 + omega[2] * sin_angles_0;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 3, sizeof(double), copied.ahead);
        const doubles result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_all(item2, step2, 3, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
        } else {
            give_each(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_xyx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_xyx_blockf_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &omega[0]);
        } else if (step1 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item1 + entries1[0], 0);
            omega[1] = PACKEDF_IN(item1 + entries1[1], 0);
            omega[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_0 = sines[1][g];
        const floats cos_angles_0 = cosines[1][g];
        const floats t1 = omega[1] * sin_angles_0 - omega[2] * cos_angles_0;
        const floats t2 = choosef(equalf(sin_angles_1, spreadf(0.0f)), spreadf(0.0f), t1);
        const floats theta_dot2 = t2 / sin_angles_1;
        const floats theta_dot0 = omega[0] - cos_angles_1 * theta_dot2;
        const floats theta_dot1 = omega[1] * cos_angles_0 + omega[2] * sin_angles_0;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 3, sizeof(float), copied.ahead);
        const floats result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_allf(item2, step2, 3, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
        } else {
            give_eachf(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_xyx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_xyz_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[3][GROUPS];
    doubles sines[3][GROUPS];
    doubles cosines[3][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles sin_angles_2 = sines[2][g];
        const doubles cos_angles_2 = cosines[2][g];
        const doubles Q2 = sin_angles_1;
        const doubles t1 = sin_angles_0 * Q2;
        const doubles Q5 = -(sin_angles_0 * cos_angles_1);
        const doubles t2 = cos_angles_0 * Q2;
        const doubles Q8 = cos_angles_0 * cos_angles_1;
        const doubles Q0 = cos_angles_1 * cos_angles_2;
        const doubles Q1 = -(cos_angles_1 * sin_angles_2);
        const doubles Q3 = t1 * cos_angles_2 + cos_angles_0 * sin_angles_2;
        const doubles Q4 = cos_angles_0 * cos_angles_2 - t1 * sin_angles_2;
        const doubles Q6 = sin_angles_0 * sin_angles_2 - t2 * cos_angles_2;
        const doubles Q7 = t2 * sin_angles_2 + sin_angles_0 * cos_angles_2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_xyz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_xyz_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[3][GROUPSF];
    floats sines[3][GROUPSF];
    floats cosines[3][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats sin_angles_2 = sines[2][g];
        const floats cos_angles_2 = cosines[2][g];
        const floats Q2 = sin_angles_1;
        const floats t1 = sin_angles_0 * Q2;
        const floats Q5 = -(sin_angles_0 * cos_angles_1);
        const floats t2 = cos_angles_0 * Q2;
        const floats Q8 = cos_angles_0 * cos_angles_1;
        const floats Q0 = cos_angles_1 * cos_angles_2;
        const floats Q1 = -(cos_angles_1 * sin_angles_2);
        const floats Q3 = t1 * cos_angles_2 + cos_angles_0 * sin_angles_2;
        const floats Q4 = cos_angles_0 * cos_angles_2 - t1 * sin_angles_2;
        const floats Q6 = sin_angles_0 * sin_angles_2 - t2 * cos_angles_2;
        const floats Q7 = t2 * sin_angles_2 + sin_angles_0 * cos_angles_2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_xyz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_xyz_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles W4 = cos_angles_0;
        const doubles W7 = sin_angles_0;
        const doubles W2 = sin_angles_1;
        const doubles W5 = -(W7 * cos_angles_1);
        const doubles W8 = W4 * cos_angles_1;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {spread(1.0), spread(0.0), W2, spread(0.0), W4, W5, spread(0.0), W7, W8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_xyz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_xyz_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats W4 = cos_angles_0;
        const floats W7 = sin_angles_0;
        const floats W2 = sin_angles_1;
        const floats W5 = -(W7 * cos_angles_1);
        const floats W8 = W4 * cos_angles_1;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            spreadf(1.0f),
            spreadf(0.0f),
            W2,
            spreadf(0.0f),
            W4,
            W5,
            spreadf(0.0f),
            W7,
            W8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_xyz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_xyz_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 1 * sizeof(double), step0, &angles_[1]);
        } else if (step0 == sizeof(double)) {
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_2 = sines[1][g];
        const doubles cos_angles_2 = cosines[1][g];
        const doubles W_body6 = sin_angles_1;
        const doubles W_body4 = cos_angles_2;
        const doubles W_body0 = cos_angles_1 * W_body4;
        const doubles W_body1 = sin_angles_2;
        const doubles W_body3 = -(cos_angles_1 * W_body1);
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {
            W_body0,
            W_body1,
            spread(0.0),
            W_body3,
            W_body4,
            spread(0.0),
            W_body6,
            spread(0.0),
            spread(1.0)};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_xyz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_xyz_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 1 * sizeof(float), step0, &angles_[1]);
        } else if (step0 == sizeof(float)) {
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_2 = sines[1][g];
        const floats cos_angles_2 = cosines[1][g];
        const floats W_body6 = sin_angles_1;
        const floats W_body4 = cos_angles_2;
        const floats W_body0 = cos_angles_1 * W_body4;
        const floats W_body1 = sin_angles_2;
        const floats W_body3 = -(cos_angles_1 * W_body1);
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            W_body0,
            W_body1,
            spreadf(0.0f),
            W_body3,
            W_body4,
            spreadf(0.0f),
            W_body6,
            spreadf(0.0f),
            spreadf(1.0f)};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_xyz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_xyz_block_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &omega[0]);
        } else if (step1 == sizeof(double)) {
            omega[0] = PACKED_IN(item1 + entries1[0], 0);
            omega[1] = PACKED_IN(item1 + entries1[1], 0);
            omega[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_0 = sines[1][g];
        const doubles cos_angles_0 = cosines[1][g];
        const doubles t1 = omega[2] * cos_angles_0 - omega[1] * sin_angles_0;
        const doubles theta_dot2 = choose(equal(cos_angles_1, spread(0.0)), spread(0.0), t1) / cos_angles_1;
        const doubles theta_dot0 = omega[0] - sin_angles_1 * theta_dot2;
        const doubles theta_dot1 = omega[1] * cos_angles_0 + omega[2] * sin_angles_0;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 3, sizeof(double), copied.ahead);
        const doubles result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_all(item2, step2, 3, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
        } else {
            give_each(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_xyz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_xyz_blockf_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &omega[0]);
        } else if (step1 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item1 + entries1[0], 0);
            omega[1] = PACKEDF_IN(item1 + entries1[1], 0);
            omega[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_0 = sines[1][g];
        const floats cos_angles_0 = cosines[1][g];
        const floats t1 = omega[2] * cos_angles_0 - omega[1] * sin_angles_0;
        const floats t2 = choosef(equalf(cos_angles_1, spreadf(0.0f)), spreadf(0.0f), t1);
        const floats theta_dot2 = t2 / cos_angles_1;
        const floats theta_dot0 = omega[0] - sin_angles_1 * theta_dot2;
        const floats theta_dot1 = omega[1] * cos_angles_0 + omega[2] * sin_angles_0;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 3, sizeof(float), copied.ahead);
        const floats result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_allf(item2, step2, 3, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
        } else {
            give_eachf(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_xyz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_xzx_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[3][GROUPS];
    doubles sines[3][GROUPS];
    doubles cosines[3][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles sin_angles_2 = sines[2][g];
        const doubles cos_angles_2 = cosines[2][g];
        const doubles Q0 = cos_angles_1;
        const doubles Q3 = cos_angles_0 * sin_angles_1;
        const doubles t1 = cos_angles_0 * Q0;
        const doubles Q6 = sin_angles_0 * sin_angles_1;
        const doubles t2 = sin_angles_0 * Q0;
        const doubles Q1 = -(sin_angles_1 * cos_angles_2);
        const doubles Q2 = sin_angles_1 * sin_angles_2;
        const doubles Q4 = t1 * cos_angles_2 - sin_angles_0 * sin_angles_2;
        const doubles Q5 = -(t1 * sin_angles_2 + sin_angles_0 * cos_angles_2);
        const doubles Q7 = t2 * cos_angles_2 + cos_angles_0 * sin_angles_2;
        const doubles Q8 = cos_angles_0 * cos_angles_2 - t2 * sin_angles_2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_xzx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_xzx_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[3][GROUPSF];
    floats sines[3][GROUPSF];
    floats cosines[3][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats sin_angles_2 = sines[2][g];
        const floats cos_angles_2 = cosines[2][g];
        const floats Q0 = cos_angles_1;
        const floats Q3 = cos_angles_0 * sin_angles_1;
        const floats t1 = cos_angles_0 * Q0;
        const floats Q6 = sin_angles_0 * sin_angles_1;
        const floats t2 = sin_angles_0 * Q0;
        const floats Q1 = -(sin_angles_1 * cos_angles_2);
        const floats Q2 = sin_angles_1 * sin_angles_2;
        const floats Q4 = t1 * cos_angles_2 - sin_angles_0 * sin_angles_2;
        const floats Q5 = -(t1 * sin_angles_2 + sin_angles_0 * cos_angles_2);
        const floats Q7 = t2 * cos_angles_2 + cos_angles_0 * sin_angles_2;
        const floats Q8 = cos_angles_0 * cos_angles_2 - t2 * sin_angles_2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_xzx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_xzx_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles W7 = cos_angles_0;
        const doubles W4 = -sin_angles_0;
        const doubles W2 = cos_angles_1;
        const doubles W5 = W7 * sin_angles_1;
        const doubles W8 = sin_angles_0 * sin_angles_1;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {spread(1.0), spread(0.0), W2, spread(0.0), W4, W5, spread(0.0), W7, W8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_xzx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_xzx_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats W7 = cos_angles_0;
        const floats W4 = -sin_angles_0;
        const floats W2 = cos_angles_1;
        const floats W5 = W7 * sin_angles_1;
        const floats W8 = sin_angles_0 * sin_angles_1;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            spreadf(1.0f),
            spreadf(0.0f),
            W2,
            spreadf(0.0f),
            W4,
            W5,
            spreadf(0.0f),
            W7,
            W8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_xzx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_xzx_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 1 * sizeof(double), step0, &angles_[1]);
        } else if (step0 == sizeof(double)) {
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_2 = sines[1][g];
        const doubles cos_angles_2 = cosines[1][g];
        const doubles W_body0 = cos_angles_1;
        const doubles W_body7 = cos_angles_2;
        const doubles W_body3 = -(sin_angles_1 * W_body7);
        const doubles W_body4 = sin_angles_2;
        const doubles W_body6 = sin_angles_1 * W_body4;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {
            W_body0,
            spread(0.0),
            spread(1.0),
            W_body3,
            W_body4,
            spread(0.0),
            W_body6,
            W_body7,
            spread(0.0)};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_xzx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_xzx_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 1 * sizeof(float), step0, &angles_[1]);
        } else if (step0 == sizeof(float)) {
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_2 = sines[1][g];
        const floats cos_angles_2 = cosines[1][g];
        const floats W_body0 = cos_angles_1;
        const floats W_body7 = cos_angles_2;
        const floats W_body3 = -(sin_angles_1 * W_body7);
        const floats W_body4 = sin_angles_2;
        const floats W_body6 = sin_angles_1 * W_body4;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            W_body0,
            spreadf(0.0f),
            spreadf(1.0f),
            W_body3,
            W_body4,
            spreadf(0.0f),
            W_body6,
            W_body7,
            spreadf(0.0f)};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_xzx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_xzx_block_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &omega[0]);
        } else if (step1 == sizeof(double)) {
            omega[0] = PACKED_IN(item1 + entries1[0], 0);
            omega[1] = PACKED_IN(item1 + entries1[1], 0);
            omega[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_0 = sines[1][g];
        const doubles cos_angles_0 = cosines[1][g];
        const doubles t1 = omega[1] * cos_angles_0 + omega[2] * sin_angles_0;
        const doubles theta_dot2 = choose(equal(sin_angles_1, spread(0.0)), spread(0.0), t1) / sin_angles_1;
        const doubles theta_dot0 = omega[0] - cos_angles_1 * theta_dot2;
        const doubles theta_dot1 = omega[2] * cos_angles_0 - omega[1] * sin_angles_0;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 3, sizeof(double), copied.ahead);
        const doubles result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_all(item2, step2, 3, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
        } else {
            give_each(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_xzx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_xzx_blockf_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &omega[0]);
        } else if (step1 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item1 + entries1[0], 0);
            omega[1] = PACKEDF_IN(item1 + entries1[1], 0);
            omega[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_0 = sines[1][g];
        const floats cos_angles_0 = cosines[1][g];
        const floats t1 = omega[1] * cos_angles_0 + omega[2] * sin_angles_0;
        const floats t2 = choosef(equalf(sin_angles_1, spreadf(0.0f)), spreadf(0.0f), t1);
        const floats theta_dot2 = t2 / sin_angles_1;
        const floats theta_dot0 = omega[0] - cos_angles_1 * theta_dot2;
        const floats theta_dot1 = omega[2] * cos_angles_0 - omega[1] * sin_angles_0;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 3, sizeof(float), copied.ahead);
        const floats result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_allf(item2, step2, 3, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
        } else {
            give_eachf(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_xzx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_xzy_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[3][GROUPS];
    doubles sines[3][GROUPS];
    doubles cosines[3][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles sin_angles_2 = sines[2][g];
        const doubles cos_angles_2 = cosines[2][g];
        const doubles Q1 = -sin_angles_1;
        const doubles t1 = cos_angles_0 * sin_angles_1;
        const doubles Q4 = cos_angles_0 * cos_angles_1;
        const doubles t2 = sin_angles_0 * sin_angles_1;
        const doubles Q7 = sin_angles_0 * cos_angles_1;
        const doubles Q0 = cos_angles_1 * cos_angles_2;
        const doubles Q2 = cos_angles_1 * sin_angles_2;
        const doubles Q3 = t1 * cos_angles_2 + sin_angles_0 * sin_angles_2;
        const doubles Q5 = t1 * sin_angles_2 - sin_angles_0 * cos_angles_2;
        const doubles Q6 = t2 * cos_angles_2 - cos_angles_0 * sin_angles_2;
        const doubles Q8 = t2 * sin_angles_2 + cos_angles_0 * cos_angles_2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_xzy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_xzy_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[3][GROUPSF];
    floats sines[3][GROUPSF];
    floats cosines[3][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats sin_angles_2 = sines[2][g];
        const floats cos_angles_2 = cosines[2][g];
        const floats Q1 = -sin_angles_1;
        const floats t1 = cos_angles_0 * sin_angles_1;
        const floats Q4 = cos_angles_0 * cos_angles_1;
        const floats t2 = sin_angles_0 * sin_angles_1;
        const floats Q7 = sin_angles_0 * cos_angles_1;
        const floats Q0 = cos_angles_1 * cos_angles_2;
        const floats Q2 = cos_angles_1 * sin_angles_2;
        const floats Q3 = t1 * cos_angles_2 + sin_angles_0 * sin_angles_2;
        const floats Q5 = t1 * sin_angles_2 - sin_angles_0 * cos_angles_2;
        const floats Q6 = t2 * cos_angles_2 - cos_angles_0 * sin_angles_2;
        const floats Q8 = t2 * sin_angles_2 + cos_angles_0 * cos_angles_2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_xzy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_xzy_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles W7 = cos_angles_0;
        const doubles W4 = -sin_angles_0;
        const doubles W2 = -sin_angles_1;
        const doubles W5 = W7 * cos_angles_1;
        const doubles W8 = sin_angles_0 * cos_angles_1;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {spread(1.0), spread(0.0), W2, spread(0.0), W4, W5, spread(0.0), W7, W8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_xzy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_xzy_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats W7 = cos_angles_0;
        const floats W4 = -sin_angles_0;
        const floats W2 = -sin_angles_1;
        const floats W5 = W7 * cos_angles_1;
        const floats W8 = sin_angles_0 * cos_angles_1;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            spreadf(1.0f),
            spreadf(0.0f),
            W2,
            spreadf(0.0f),
            W4,
            W5,
            spreadf(0.0f),
            W7,
            W8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_xzy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_xzy_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 1 * sizeof(double), step0, &angles_[1]);
        } else if (step0 == sizeof(double)) {
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_2 = sines[1][g];
        const doubles cos_angles_2 = cosines[1][g];
        const doubles W_body3 = -sin_angles_1;
        const doubles W_body7 = cos_angles_2;
        const doubles W_body0 = cos_angles_1 * W_body7;
        const doubles W_body1 = -sin_angles_2;
        const doubles W_body6 = cos_angles_1 * sin_angles_2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {
            W_body0,
            W_body1,
            spread(0.0),
            W_body3,
            spread(0.0),
            spread(1.0),
            W_body6,
            W_body7,
            spread(0.0)};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_xzy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_xzy_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 1 * sizeof(float), step0, &angles_[1]);
        } else if (step0 == sizeof(float)) {
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_2 = sines[1][g];
        const floats cos_angles_2 = cosines[1][g];
        const floats W_body3 = -sin_angles_1;
        const floats W_body7 = cos_angles_2;
        const floats W_body0 = cos_angles_1 * W_body7;
        const floats W_body1 = -sin_angles_2;
        const floats W_body6 = cos_angles_1 * sin_angles_2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            W_body0,
            W_body1,
            spreadf(0.0f),
            W_body3,
            spreadf(0.0f),
            spreadf(1.0f),
            W_body6,
            W_body7,
            spreadf(0.0f)};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_xzy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_xzy_block_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &omega[0]);
        } else if (step1 == sizeof(double)) {
            omega[0] = PACKED_IN(item1 + entries1[0], 0);
            omega[1] = PACKED_IN(item1 + entries1[1], 0);
            omega[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_0 = sines[1][g];
        const doubles cos_angles_0 = cosines[1][g];
        const doubles t1 = omega[1] * cos_angles_0 + omega[2] * sin_angles_0;
        const doubles theta_dot2 = choose(equal(cos_angles_1, spread(0.0)), spread(0.0), t1) / cos_angles_1;
        const doubles theta_dot0 = omega[0] + sin_angles_1 * theta_dot2;
        const doubles theta_dot1 = omega[2] * cos_angles_0 - omega[1] * sin_angles_0;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 3, sizeof(double), copied.ahead);
        const doubles result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_all(item2, step2, 3, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
        } else {
            give_each(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_xzy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_xzy_blockf_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &omega[0]);
        } else if (step1 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item1 + entries1[0], 0);
            omega[1] = PACKEDF_IN(item1 + entries1[1], 0);
            omega[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_0 = sines[1][g];
        const floats cos_angles_0 = cosines[1][g];
        const floats t1 = omega[1] * cos_angles_0 + omega[2] * sin_angles_0;
        const floats t2 = choosef(equalf(cos_angles_1, spreadf(0.0f)), spreadf(0.0f), t1);
        const floats theta_dot2 = t2 / cos_angles_1;
        const floats theta_dot0 = omega[0] + sin_angles_1 * theta_dot2;
        const floats theta_dot1 = omega[2] * cos_angles_0 - omega[1] * sin_angles_0;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 3, sizeof(float), copied.ahead);
        const floats result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_allf(item2, step2, 3, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
        } else {
            give_eachf(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_xzy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_yxy_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[3][GROUPS];
    doubles sines[3][GROUPS];
    doubles cosines[3][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles sin_angles_2 = sines[2][g];
        const doubles cos_angles_2 = cosines[2][g];
        const doubles Q4 = cos_angles_1;
        const doubles Q1 = sin_angles_0 * sin_angles_1;
        const doubles t1 = sin_angles_0 * Q4;
        const doubles Q7 = cos_angles_0 * sin_angles_1;
        const doubles t2 = cos_angles_0 * Q4;
        const doubles Q0 = cos_angles_0 * cos_angles_2 - t1 * sin_angles_2;
        const doubles Q2 = cos_angles_0 * sin_angles_2 + t1 * cos_angles_2;
        const doubles Q3 = sin_angles_1 * sin_angles_2;
        const doubles Q5 = -(sin_angles_1 * cos_angles_2);
        const doubles Q6 = -(sin_angles_0 * cos_angles_2 + t2 * sin_angles_2);
        const doubles Q8 = t2 * cos_angles_2 - sin_angles_0 * sin_angles_2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_yxy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_yxy_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[3][GROUPSF];
    floats sines[3][GROUPSF];
    floats cosines[3][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats sin_angles_2 = sines[2][g];
        const floats cos_angles_2 = cosines[2][g];
        const floats Q4 = cos_angles_1;
        const floats Q1 = sin_angles_0 * sin_angles_1;
        const floats t1 = sin_angles_0 * Q4;
        const floats Q7 = cos_angles_0 * sin_angles_1;
        const floats t2 = cos_angles_0 * Q4;
        const floats Q0 = cos_angles_0 * cos_angles_2 - t1 * sin_angles_2;
        const floats Q2 = cos_angles_0 * sin_angles_2 + t1 * cos_angles_2;
        const floats Q3 = sin_angles_1 * sin_angles_2;
        const floats Q5 = -(sin_angles_1 * cos_angles_2);
        const floats Q6 = -(sin_angles_0 * cos_angles_2 + t2 * sin_angles_2);
        const floats Q8 = t2 * cos_angles_2 - sin_angles_0 * sin_angles_2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_yxy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_yxy_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles W1 = cos_angles_0;
        const doubles W7 = -sin_angles_0;
        const doubles W5 = cos_angles_1;
        const doubles W2 = sin_angles_0 * sin_angles_1;
        const doubles W8 = W1 * sin_angles_1;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {spread(0.0), W1, W2, spread(1.0), spread(0.0), W5, spread(0.0), W7, W8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_yxy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_yxy_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats W1 = cos_angles_0;
        const floats W7 = -sin_angles_0;
        const floats W5 = cos_angles_1;
        const floats W2 = sin_angles_0 * sin_angles_1;
        const floats W8 = W1 * sin_angles_1;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            spreadf(0.0f),
            W1,
            W2,
            spreadf(1.0f),
            spreadf(0.0f),
            W5,
            spreadf(0.0f),
            W7,
            W8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_yxy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_yxy_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 1 * sizeof(double), step0, &angles_[1]);
        } else if (step0 == sizeof(double)) {
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_2 = sines[1][g];
        const doubles cos_angles_2 = cosines[1][g];
        const doubles W_body3 = cos_angles_1;
        const doubles W_body1 = cos_angles_2;
        const doubles W_body7 = sin_angles_2;
        const doubles W_body0 = sin_angles_1 * W_body7;
        const doubles W_body6 = -(sin_angles_1 * W_body1);
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {
            W_body0,
            W_body1,
            spread(0.0),
            W_body3,
            spread(0.0),
            spread(1.0),
            W_body6,
            W_body7,
            spread(0.0)};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_yxy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_yxy_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 1 * sizeof(float), step0, &angles_[1]);
        } else if (step0 == sizeof(float)) {
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_2 = sines[1][g];
        const floats cos_angles_2 = cosines[1][g];
        const floats W_body3 = cos_angles_1;
        const floats W_body1 = cos_angles_2;
        const floats W_body7 = sin_angles_2;
        const floats W_body0 = sin_angles_1 * W_body7;
        const floats W_body6 = -(sin_angles_1 * W_body1);
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            W_body0,
            W_body1,
            spreadf(0.0f),
            W_body3,
            spreadf(0.0f),
            spreadf(1.0f),
            W_body6,
            W_body7,
            spreadf(0.0f)};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_yxy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_yxy_block_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &omega[0]);
        } else if (step1 == sizeof(double)) {
            omega[0] = PACKED_IN(item1 + entries1[0], 0);
            omega[1] = PACKED_IN(item1 + entries1[1], 0);
            omega[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_0 = sines[1][g];
        const doubles cos_angles_0 = cosines[1][g];
        const doubles t1 = omega[0] * sin_angles_0 + omega[2] * cos_angles_0;
        const doubles theta_dot2 = choose(equal(sin_angles_1, spread(0.0)), spread(0.0), t1) / sin_angles_1;
        const doubles theta_dot0 = omega[1] - cos_angles_1 * theta_dot2;
        const doubles theta_dot1 = omega[0] * cos_angles_0 - omega[2] * sin_angles_0;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 3, sizeof(double), copied.ahead);
        const doubles result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_all(item2, step2, 3, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
        } else {
            give_each(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_yxy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_yxy_blockf_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &omega[0]);
        } else if (step1 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item1 + entries1[0], 0);
            omega[1] = PACKEDF_IN(item1 + entries1[1], 0);
            omega[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_0 = sines[1][g];
        const floats cos_angles_0 = cosines[1][g];
        const floats t1 = omega[0] * sin_angles_0 + omega[2] * cos_angles_0;
        const floats t2 = choosef(equalf(sin_angles_1, spreadf(0.0f)), spreadf(0.0f), t1);
        const floats theta_dot2 = t2 / sin_angles_1;
        const floats theta_dot0 = omega[1] - cos_angles_1 * theta_dot2;
        const floats theta_dot1 = omega[0] * cos_angles_0 - omega[2] * sin_angles_0;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 3, sizeof(float), copied.ahead);
        const floats result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_allf(item2, step2, 3, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
        } else {
            give_eachf(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_yxy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_yxz_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[3][GROUPS];
    doubles sines[3][GROUPS];
    doubles cosines[3][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles sin_angles_2 = sines[2][g];
        const doubles cos_angles_2 = cosines[2][g];
        const doubles Q5 = -sin_angles_1;
        const doubles t1 = sin_angles_0 * sin_angles_1;
        const doubles Q2 = sin_angles_0 * cos_angles_1;
        const doubles t2 = cos_angles_0 * sin_angles_1;
        const doubles Q8 = cos_angles_0 * cos_angles_1;
        const doubles Q0 = cos_angles_0 * cos_angles_2 + t1 * sin_angles_2;
        const doubles Q1 = t1 * cos_angles_2 - cos_angles_0 * sin_angles_2;
        const doubles Q3 = cos_angles_1 * sin_angles_2;
        const doubles Q4 = cos_angles_1 * cos_angles_2;
        const doubles Q6 = t2 * sin_angles_2 - sin_angles_0 * cos_angles_2;
        const doubles Q7 = sin_angles_0 * sin_angles_2 + t2 * cos_angles_2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_yxz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_yxz_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[3][GROUPSF];
    floats sines[3][GROUPSF];
    floats cosines[3][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats sin_angles_2 = sines[2][g];
        const floats cos_angles_2 = cosines[2][g];
        const floats Q5 = -sin_angles_1;
        const floats t1 = sin_angles_0 * sin_angles_1;
        const floats Q2 = sin_angles_0 * cos_angles_1;
        const floats t2 = cos_angles_0 * sin_angles_1;
        const floats Q8 = cos_angles_0 * cos_angles_1;
        const floats Q0 = cos_angles_0 * cos_angles_2 + t1 * sin_angles_2;
        const floats Q1 = t1 * cos_angles_2 - cos_angles_0 * sin_angles_2;
        const floats Q3 = cos_angles_1 * sin_angles_2;
        const floats Q4 = cos_angles_1 * cos_angles_2;
        const floats Q6 = t2 * sin_angles_2 - sin_angles_0 * cos_angles_2;
        const floats Q7 = sin_angles_0 * sin_angles_2 + t2 * cos_angles_2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_yxz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_yxz_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles W1 = cos_angles_0;
        const doubles W7 = -sin_angles_0;
        const doubles W5 = -sin_angles_1;
        const doubles W2 = sin_angles_0 * cos_angles_1;
        const doubles W8 = W1 * cos_angles_1;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {spread(0.0), W1, W2, spread(1.0), spread(0.0), W5, spread(0.0), W7, W8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_yxz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_yxz_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats W1 = cos_angles_0;
        const floats W7 = -sin_angles_0;
        const floats W5 = -sin_angles_1;
        const floats W2 = sin_angles_0 * cos_angles_1;
        const floats W8 = W1 * cos_angles_1;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            spreadf(0.0f),
            W1,
            W2,
            spreadf(1.0f),
            spreadf(0.0f),
            W5,
            spreadf(0.0f),
            W7,
            W8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_yxz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_yxz_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 1 * sizeof(double), step0, &angles_[1]);
        } else if (step0 == sizeof(double)) {
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_2 = sines[1][g];
        const doubles cos_angles_2 = cosines[1][g];
        const doubles W_body6 = -sin_angles_1;
        const doubles W_body1 = cos_angles_2;
        const doubles W_body0 = cos_angles_1 * sin_angles_2;
        const doubles W_body4 = -sin_angles_2;
        const doubles W_body3 = cos_angles_1 * W_body1;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {
            W_body0,
            W_body1,
            spread(0.0),
            W_body3,
            W_body4,
            spread(0.0),
            W_body6,
            spread(0.0),
            spread(1.0)};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_yxz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_yxz_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 1 * sizeof(float), step0, &angles_[1]);
        } else if (step0 == sizeof(float)) {
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_2 = sines[1][g];
        const floats cos_angles_2 = cosines[1][g];
        const floats W_body6 = -sin_angles_1;
        const floats W_body1 = cos_angles_2;
        const floats W_body0 = cos_angles_1 * sin_angles_2;
        const floats W_body4 = -sin_angles_2;
        const floats W_body3 = cos_angles_1 * W_body1;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            W_body0,
            W_body1,
            spreadf(0.0f),
            W_body3,
            W_body4,
            spreadf(0.0f),
            W_body6,
            spreadf(0.0f),
            spreadf(1.0f)};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_yxz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_yxz_block_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &omega[0]);
        } else if (step1 == sizeof(double)) {
            omega[0] = PACKED_IN(item1 + entries1[0], 0);
            omega[1] = PACKED_IN(item1 + entries1[1], 0);
            omega[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_0 = sines[1][g];
        const doubles cos_angles_0 = cosines[1][g];
        const doubles t1 = omega[0] * sin_angles_0 + omega[2] * cos_angles_0;
        const doubles theta_dot2 = choose(equal(cos_angles_1, spread(0.0)), spread(0.0), t1) / cos_angles_1;
        const doubles theta_dot0 = omega[1] + sin_angles_1 * theta_dot2;
        const doubles theta_dot1 = omega[0] * cos_angles_0 - omega[2] * sin_angles_0;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 3, sizeof(double), copied.ahead);
        const doubles result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_all(item2, step2, 3, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
        } else {
            give_each(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_yxz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_yxz_blockf_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &omega[0]);
        } else if (step1 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item1 + entries1[0], 0);
            omega[1] = PACKEDF_IN(item1 + entries1[1], 0);
            omega[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_0 = sines[1][g];
        const floats cos_angles_0 = cosines[1][g];
        const floats t1 = omega[0] * sin_angles_0 + omega[2] * cos_angles_0;
        const floats t2 = choosef(equalf(cos_angles_1, spreadf(0.0f)), spreadf(0.0f), t1);
        const floats theta_dot2 = t2 / cos_angles_1;
        const floats theta_dot0 = omega[1] + sin_angles_1 * theta_dot2;
        const floats theta_dot1 = omega[0] * cos_angles_0 - omega[2] * sin_angles_0;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 3, sizeof(float), copied.ahead);
        const floats result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_allf(item2, step2, 3, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
        } else {
            give_eachf(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_yxz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_yzx_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[3][GROUPS];
    doubles sines[3][GROUPS];
    doubles cosines[3][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles sin_angles_2 = sines[2][g];
        const doubles cos_angles_2 = cosines[2][g];
        const doubles Q3 = sin_angles_1;
        const doubles Q0 = cos_angles_0 * cos_angles_1;
        const doubles t1 = cos_angles_0 * Q3;
        const doubles Q6 = -(sin_angles_0 * cos_angles_1);
        const doubles t2 = sin_angles_0 * Q3;
        const doubles Q1 = sin_angles_0 * sin_angles_2 - t1 * cos_angles_2;
        const doubles Q2 = t1 * sin_angles_2 + sin_angles_0 * cos_angles_2;
        const doubles Q4 = cos_angles_1 * cos_angles_2;
        const doubles Q5 = -(cos_angles_1 * sin_angles_2);
        const doubles Q7 = t2 * cos_angles_2 + cos_angles_0 * sin_angles_2;
        const doubles Q8 = cos_angles_0 * cos_angles_2 - t2 * sin_angles_2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_yzx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_yzx_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[3][GROUPSF];
    floats sines[3][GROUPSF];
    floats cosines[3][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats sin_angles_2 = sines[2][g];
        const floats cos_angles_2 = cosines[2][g];
        const floats Q3 = sin_angles_1;
        const floats Q0 = cos_angles_0 * cos_angles_1;
        const floats t1 = cos_angles_0 * Q3;
        const floats Q6 = -(sin_angles_0 * cos_angles_1);
        const floats t2 = sin_angles_0 * Q3;
        const floats Q1 = sin_angles_0 * sin_angles_2 - t1 * cos_angles_2;
        const floats Q2 = t1 * sin_angles_2 + sin_angles_0 * cos_angles_2;
        const floats Q4 = cos_angles_1 * cos_angles_2;
        const floats Q5 = -(cos_angles_1 * sin_angles_2);
        const floats Q7 = t2 * cos_angles_2 + cos_angles_0 * sin_angles_2;
        const floats Q8 = cos_angles_0 * cos_angles_2 - t2 * sin_angles_2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_yzx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_yzx_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles W7 = cos_angles_0;
        const doubles W1 = sin_angles_0;
        const doubles W5 = sin_angles_1;
        const doubles W2 = W7 * cos_angles_1;
        const doubles W8 = -(W1 * cos_angles_1);
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {spread(0.0), W1, W2, spread(1.0), spread(0.0), W5, spread(0.0), W7, W8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_yzx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_yzx_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats W7 = cos_angles_0;
        const floats W1 = sin_angles_0;
        const floats W5 = sin_angles_1;
        const floats W2 = W7 * cos_angles_1;
        const floats W8 = -(W1 * cos_angles_1);
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            spreadf(0.0f),
            W1,
            W2,
            spreadf(1.0f),
            spreadf(0.0f),
            W5,
            spreadf(0.0f),
            W7,
            W8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_yzx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_yzx_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 1 * sizeof(double), step0, &angles_[1]);
        } else if (step0 == sizeof(double)) {
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_2 = sines[1][g];
        const doubles cos_angles_2 = cosines[1][g];
        const doubles W_body0 = sin_angles_1;
        const doubles W_body7 = cos_angles_2;
        const doubles W_body3 = cos_angles_1 * W_body7;
        const doubles W_body4 = sin_angles_2;
        const doubles W_body6 = -(cos_angles_1 * W_body4);
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {
            W_body0,
            spread(0.0),
            spread(1.0),
            W_body3,
            W_body4,
            spread(0.0),
            W_body6,
            W_body7,
            spread(0.0)};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_yzx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_yzx_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 1 * sizeof(float), step0, &angles_[1]);
        } else if (step0 == sizeof(float)) {
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_2 = sines[1][g];
        const floats cos_angles_2 = cosines[1][g];
        const floats W_body0 = sin_angles_1;
        const floats W_body7 = cos_angles_2;
        const floats W_body3 = cos_angles_1 * W_body7;
        const floats W_body4 = sin_angles_2;
        const floats W_body6 = -(cos_angles_1 * W_body4);
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            W_body0,
            spreadf(0.0f),
            spreadf(1.0f),
            W_body3,
            W_body4,
            spreadf(0.0f),
            W_body6,
            W_body7,
            spreadf(0.0f)};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_yzx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_yzx_block_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &omega[0]);
        } else if (step1 == sizeof(double)) {
            omega[0] = PACKED_IN(item1 + entries1[0], 0);
            omega[1] = PACKED_IN(item1 + entries1[1], 0);
            omega[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_0 = sines[1][g];
        const doubles cos_angles_0 = cosines[1][g];
        const doubles t1 = omega[0] * cos_angles_0 - omega[2] * sin_angles_0;
        const doubles theta_dot2 = choose(equal(cos_angles_1, spread(0.0)), spread(0.0), t1) / cos_angles_1;
        const doubles theta_dot0 = omega[1] - sin_angles_1 * theta_dot2;
        const doubles theta_dot1 = omega[0] * sin_angles_0 + omega[2] * cos_angles_0;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 3, sizeof(double), copied.ahead);
        const doubles result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_all(item2, step2, 3, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
        } else {
            give_each(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_yzx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_yzx_blockf_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &omega[0]);
        } else if (step1 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item1 + entries1[0], 0);
            omega[1] = PACKEDF_IN(item1 + entries1[1], 0);
            omega[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_0 = sines[1][g];
        const floats cos_angles_0 = cosines[1][g];
        const floats t1 = omega[0] * cos_angles_0 - omega[2] * sin_angles_0;
        const floats t2 = choosef(equalf(cos_angles_1, spreadf(0.0f)), spreadf(0.0f), t1);
        const floats theta_dot2 = t2 / cos_angles_1;
        const floats theta_dot0 = omega[1] - sin_angles_1 * theta_dot2;
        const floats theta_dot1 = omega[0] * sin_angles_0 + omega[2] * cos_angles_0;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 3, sizeof(float), copied.ahead);
        const floats result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_allf(item2, step2, 3, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
        } else {
            give_eachf(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_yzx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_yzy_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[3][GROUPS];
    doubles sines[3][GROUPS];
    doubles cosines[3][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles sin_angles_2 = sines[2][g];
        const doubles cos_angles_2 = cosines[2][g];
        const doubles Q4 = cos_angles_1;
        const doubles t1 = cos_angles_0 * Q4;
        const doubles Q1 = -(cos_angles_0 * sin_angles_1);
        const doubles t2 = sin_angles_0 * Q4;
        const doubles Q7 = sin_angles_0 * sin_angles_1;
        const doubles Q0 = t1 * cos_angles_2 - sin_angles_0 * sin_angles_2;
        const doubles Q2 = t1 * sin_angles_2 + sin_angles_0 * cos_angles_2;
        const doubles Q3 = sin_angles_1 * cos_angles_2;
        const doubles Q5 = sin_angles_1 * sin_angles_2;
        const doubles Q6 = -(t2 * cos_angles_2 + cos_angles_0 * sin_angles_2);
        const doubles Q8 = cos_angles_0 * cos_angles_2 - t2 * sin_angles_2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_yzy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_yzy_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[3][GROUPSF];
    floats sines[3][GROUPSF];
    floats cosines[3][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats sin_angles_2 = sines[2][g];
        const floats cos_angles_2 = cosines[2][g];
        const floats Q4 = cos_angles_1;
        const floats t1 = cos_angles_0 * Q4;
        const floats Q1 = -(cos_angles_0 * sin_angles_1);
        const floats t2 = sin_angles_0 * Q4;
        const floats Q7 = sin_angles_0 * sin_angles_1;
        const floats Q0 = t1 * cos_angles_2 - sin_angles_0 * sin_angles_2;
        const floats Q2 = t1 * sin_angles_2 + sin_angles_0 * cos_angles_2;
        const floats Q3 = sin_angles_1 * cos_angles_2;
        const floats Q5 = sin_angles_1 * sin_angles_2;
        const floats Q6 = -(t2 * cos_angles_2 + cos_angles_0 * sin_angles_2);
        const floats Q8 = cos_angles_0 * cos_angles_2 - t2 * sin_angles_2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_yzy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_yzy_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles W7 = cos_angles_0;
        const doubles W1 = sin_angles_0;
        const doubles W5 = cos_angles_1;
        const doubles W2 = -(W7 * sin_angles_1);
        const doubles W8 = W1 * sin_angles_1;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {spread(0.0), W1, W2, spread(1.0), spread(0.0), W5, spread(0.0), W7, W8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_yzy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_yzy_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats W7 = cos_angles_0;
        const floats W1 = sin_angles_0;
        const floats W5 = cos_angles_1;
        const floats W2 = -(W7 * sin_angles_1);
        const floats W8 = W1 * sin_angles_1;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            spreadf(0.0f),
            W1,
            W2,
            spreadf(1.0f),
            spreadf(0.0f),
            W5,
            spreadf(0.0f),
            W7,
            W8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_yzy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_yzy_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 1 * sizeof(double), step0, &angles_[1]);
        } else if (step0 == sizeof(double)) {
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_2 = sines[1][g];
        const doubles cos_angles_2 = cosines[1][g];
        const doubles W_body3 = cos_angles_1;
        const doubles W_body7 = cos_angles_2;
        const doubles W_body0 = sin_angles_1 * W_body7;
        const doubles W_body1 = -sin_angles_2;
        const doubles W_body6 = sin_angles_1 * sin_angles_2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {
            W_body0,
            W_body1,
            spread(0.0),
            W_body3,
            spread(0.0),
            spread(1.0),
            W_body6,
            W_body7,
            spread(0.0)};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_yzy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_yzy_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 1 * sizeof(float), step0, &angles_[1]);
        } else if (step0 == sizeof(float)) {
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_2 = sines[1][g];
        const floats cos_angles_2 = cosines[1][g];
        const floats W_body3 = cos_angles_1;
        const floats W_body7 = cos_angles_2;
        const floats W_body0 = sin_angles_1 * W_body7;
        const floats W_body1 = -sin_angles_2;
        const floats W_body6 = sin_angles_1 * sin_angles_2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            W_body0,
            W_body1,
            spreadf(0.0f),
            W_body3,
            spreadf(0.0f),
            spreadf(1.0f),
            W_body6,
            W_body7,
            spreadf(0.0f)};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_yzy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_yzy_block_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &omega[0]);
        } else if (step1 == sizeof(double)) {
            omega[0] = PACKED_IN(item1 + entries1[0], 0);
            omega[1] = PACKED_IN(item1 + entries1[1], 0);
            omega[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_0 = sines[1][g];
        const doubles cos_angles_0 = cosines[1][g];
        const doubles t1 = omega[2] * sin_angles_0 - omega[0] * cos_angles_0;
        const doubles theta_dot2 = choose(equal(sin_angles_1, spread(0.0)), spread(0.0), t1) / sin_angles_1;
        const doubles theta_dot0 = omega[1] - cos_angles_1 * theta_dot2;
        const doubles theta_dot1 = omega[0] * sin_angles_0 + omega[2] * cos_angles_0;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 3, sizeof(double), copied.ahead);
        const doubles result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_all(item2, step2, 3, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
        } else {
            give_each(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_yzy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_yzy_blockf_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &omega[0]);
        } else if (step1 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item1 + entries1[0], 0);
            omega[1] = PACKEDF_IN(item1 + entries1[1], 0);
            omega[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_0 = sines[1][g];
        const floats cos_angles_0 = cosines[1][g];
        const floats t1 = omega[2] * sin_angles_0 - omega[0] * cos_angles_0;
        const floats t2 = choosef(equalf(sin_angles_1, spreadf(0.0f)), spreadf(0.0f), t1);
        const floats theta_dot2 = t2 / sin_angles_1;
        const floats theta_dot0 = omega[1] - cos_angles_1 * theta_dot2;
        const floats theta_dot1 = omega[0] * sin_angles_0 + omega[2] * cos_angles_0;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 3, sizeof(float), copied.ahead);
        const floats result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_allf(item2, step2, 3, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
        } else {
            give_eachf(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_yzy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_zxy_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[3][GROUPS];
    doubles sines[3][GROUPS];
    doubles cosines[3][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles sin_angles_2 = sines[2][g];
        const doubles cos_angles_2 = cosines[2][g];
        const doubles Q7 = sin_angles_1;
        const doubles Q1 = -(sin_angles_0 * cos_angles_1);
        const doubles t1 = sin_angles_0 * Q7;
        const doubles Q4 = cos_angles_0 * cos_angles_1;
        const doubles t2 = cos_angles_0 * Q7;
        const doubles Q0 = cos_angles_0 * cos_angles_2 - t1 * sin_angles_2;
        const doubles Q2 = cos_angles_0 * sin_angles_2 + t1 * cos_angles_2;
        const doubles Q3 = sin_angles_0 * cos_angles_2 + t2 * sin_angles_2;
        const doubles Q5 = sin_angles_0 * sin_angles_2 - t2 * cos_angles_2;
        const doubles Q6 = -(cos_angles_1 * sin_angles_2);
        const doubles Q8 = cos_angles_1 * cos_angles_2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_zxy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_zxy_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[3][GROUPSF];
    floats sines[3][GROUPSF];
    floats cosines[3][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats sin_angles_2 = sines[2][g];
        const floats cos_angles_2 = cosines[2][g];
        const floats Q7 = sin_angles_1;
        const floats Q1 = -(sin_angles_0 * cos_angles_1);
        const floats t1 = sin_angles_0 * Q7;
        const floats Q4 = cos_angles_0 * cos_angles_1;
        const floats t2 = cos_angles_0 * Q7;
        const floats Q0 = cos_angles_0 * cos_angles_2 - t1 * sin_angles_2;
        const floats Q2 = cos_angles_0 * sin_angles_2 + t1 * cos_angles_2;
        const floats Q3 = sin_angles_0 * cos_angles_2 + t2 * sin_angles_2;
        const floats Q5 = sin_angles_0 * sin_angles_2 - t2 * cos_angles_2;
        const floats Q6 = -(cos_angles_1 * sin_angles_2);
        const floats Q8 = cos_angles_1 * cos_angles_2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_zxy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_zxy_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles W1 = cos_angles_0;
        const doubles W4 = sin_angles_0;
        const doubles W8 = sin_angles_1;
        const doubles W2 = -(W4 * cos_angles_1);
        const doubles W5 = W1 * cos_angles_1;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {spread(0.0), W1, W2, spread(0.0), W4, W5, spread(1.0), spread(0.0), W8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_zxy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_zxy_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats W1 = cos_angles_0;
        const floats W4 = sin_angles_0;
        const floats W8 = sin_angles_1;
        const floats W2 = -(W4 * cos_angles_1);
        const floats W5 = W1 * cos_angles_1;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            spreadf(0.0f),
            W1,
            W2,
            spreadf(0.0f),
            W4,
            W5,
            spreadf(1.0f),
            spreadf(0.0f),
            W8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_zxy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_zxy_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 1 * sizeof(double), step0, &angles_[1]);
        } else if (step0 == sizeof(double)) {
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_2 = sines[1][g];
        const doubles cos_angles_2 = cosines[1][g];
        const doubles W_body3 = sin_angles_1;
        const doubles W_body1 = cos_angles_2;
        const doubles W_body7 = sin_angles_2;
        const doubles W_body0 = -(cos_angles_1 * W_body7);
        const doubles W_body6 = cos_angles_1 * W_body1;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {
            W_body0,
            W_body1,
            spread(0.0),
            W_body3,
            spread(0.0),
            spread(1.0),
            W_body6,
            W_body7,
            spread(0.0)};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_zxy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_zxy_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 1 * sizeof(float), step0, &angles_[1]);
        } else if (step0 == sizeof(float)) {
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_2 = sines[1][g];
        const floats cos_angles_2 = cosines[1][g];
        const floats W_body3 = sin_angles_1;
        const floats W_body1 = cos_angles_2;
        const floats W_body7 = sin_angles_2;
        const floats W_body0 = -(cos_angles_1 * W_body7);
        const floats W_body6 = cos_angles_1 * W_body1;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            W_body0,
            W_body1,
            spreadf(0.0f),
            W_body3,
            spreadf(0.0f),
            spreadf(1.0f),
            W_body6,
            W_body7,
            spreadf(0.0f)};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_zxy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_zxy_block_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &omega[0]);
        } else if (step1 == sizeof(double)) {
            omega[0] = PACKED_IN(item1 + entries1[0], 0);
            omega[1] = PACKED_IN(item1 + entries1[1], 0);
            omega[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_0 = sines[1][g];
        const doubles cos_angles_0 = cosines[1][g];
        const doubles t1 = omega[1] * cos_angles_0 - omega[0] * sin_angles_0;
        const doubles theta_dot2 = choose(equal(cos_angles_1, spread(0.0)), spread(0.0), t1) / cos_angles_1;
        const doubles theta_dot0 = omega[2] - sin_angles_1 * theta_dot2;
        const doubles theta_dot1 = omega[0] * cos_angles_0 + omega[1] * sin_angles_0;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 3, sizeof(double), copied.ahead);
        const doubles result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_all(item2, step2, 3, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
        } else {
            give_each(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_zxy_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_zxy_blockf_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &omega[0]);
        } else if (step1 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item1 + entries1[0], 0);
            omega[1] = PACKEDF_IN(item1 + entries1[1], 0);
            omega[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_0 = sines[1][g];
        const floats cos_angles_0 = cosines[1][g];
        const floats t1 = omega[1] * cos_angles_0 - omega[0] * sin_angles_0;
        const floats t2 = choosef(equalf(cos_angles_1, spreadf(0.0f)), spreadf(0.0f), t1);
        const floats theta_dot2 = t2 / cos_angles_1;
        const floats theta_dot0 = omega[2] - sin_angles_1 * theta_dot2;
        const floats theta_dot1 = omega[0] * cos_angles_0 + omega[1] * sin_angles_0;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 3, sizeof(float), copied.ahead);
        const floats result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_allf(item2, step2, 3, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
        } else {
            give_eachf(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_zxy_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_zxz_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[3][GROUPS];
    doubles sines[3][GROUPS];
    doubles cosines[3][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles sin_angles_2 = sines[2][g];
        const doubles cos_angles_2 = cosines[2][g];
        const doubles Q8 = cos_angles_1;
        const doubles t1 = sin_angles_0 * Q8;
        const doubles Q2 = sin_angles_0 * sin_angles_1;
        const doubles t2 = cos_angles_0 * Q8;
        const doubles Q5 = -(cos_angles_0 * sin_angles_1);
        const doubles Q0 = cos_angles_0 * cos_angles_2 - t1 * sin_angles_2;
        const doubles Q1 = -(cos_angles_0 * sin_angles_2 + t1 * cos_angles_2);
        const doubles Q3 = sin_angles_0 * cos_angles_2 + t2 * sin_angles_2;
        const doubles Q4 = t2 * cos_angles_2 - sin_angles_0 * sin_angles_2;
        const doubles Q6 = sin_angles_1 * sin_angles_2;
        const doubles Q7 = sin_angles_1 * cos_angles_2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_zxz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_zxz_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[3][GROUPSF];
    floats sines[3][GROUPSF];
    floats cosines[3][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats sin_angles_2 = sines[2][g];
        const floats cos_angles_2 = cosines[2][g];
        const floats Q8 = cos_angles_1;
        const floats t1 = sin_angles_0 * Q8;
        const floats Q2 = sin_angles_0 * sin_angles_1;
        const floats t2 = cos_angles_0 * Q8;
        const floats Q5 = -(cos_angles_0 * sin_angles_1);
        const floats Q0 = cos_angles_0 * cos_angles_2 - t1 * sin_angles_2;
        const floats Q1 = -(cos_angles_0 * sin_angles_2 + t1 * cos_angles_2);
        const floats Q3 = sin_angles_0 * cos_angles_2 + t2 * sin_angles_2;
        const floats Q4 = t2 * cos_angles_2 - sin_angles_0 * sin_angles_2;
        const floats Q6 = sin_angles_1 * sin_angles_2;
        const floats Q7 = sin_angles_1 * cos_angles_2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_zxz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_zxz_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles W1 = cos_angles_0;
        const doubles W4 = sin_angles_0;
        const doubles W8 = cos_angles_1;
        const doubles W2 = W4 * sin_angles_1;
        const doubles W5 = -(W1 * sin_angles_1);
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {spread(0.0), W1, W2, spread(0.0), W4, W5, spread(1.0), spread(0.0), W8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_zxz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_zxz_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats W1 = cos_angles_0;
        const floats W4 = sin_angles_0;
        const floats W8 = cos_angles_1;
        const floats W2 = W4 * sin_angles_1;
        const floats W5 = -(W1 * sin_angles_1);
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            spreadf(0.0f),
            W1,
            W2,
            spreadf(0.0f),
            W4,
            W5,
            spreadf(1.0f),
            spreadf(0.0f),
            W8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_zxz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_zxz_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 1 * sizeof(double), step0, &angles_[1]);
        } else if (step0 == sizeof(double)) {
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_2 = sines[1][g];
        const doubles cos_angles_2 = cosines[1][g];
        const doubles W_body6 = cos_angles_1;
        const doubles W_body1 = cos_angles_2;
        const doubles W_body0 = sin_angles_1 * sin_angles_2;
        const doubles W_body4 = -sin_angles_2;
        const doubles W_body3 = sin_angles_1 * W_body1;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {
            W_body0,
            W_body1,
            spread(0.0),
            W_body3,
            W_body4,
            spread(0.0),
            W_body6,
            spread(0.0),
            spread(1.0)};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_zxz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_zxz_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 1 * sizeof(float), step0, &angles_[1]);
        } else if (step0 == sizeof(float)) {
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_2 = sines[1][g];
        const floats cos_angles_2 = cosines[1][g];
        const floats W_body6 = cos_angles_1;
        const floats W_body1 = cos_angles_2;
        const floats W_body0 = sin_angles_1 * sin_angles_2;
        const floats W_body4 = -sin_angles_2;
        const floats W_body3 = sin_angles_1 * W_body1;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            W_body0,
            W_body1,
            spreadf(0.0f),
            W_body3,
            W_body4,
            spreadf(0.0f),
            W_body6,
            spreadf(0.0f),
            spreadf(1.0f)};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_zxz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_zxz_block_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &omega[0]);
        } else if (step1 == sizeof(double)) {
            omega[0] = PACKED_IN(item1 + entries1[0], 0);
            omega[1] = PACKED_IN(item1 + entries1[1], 0);
            omega[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_0 = sines[1][g];
        const doubles cos_angles_0 = cosines[1][g];
        const doubles t1 = omega[0] * sin_angles_0 - omega[1] * cos_angles_0;
        const doubles theta_dot2 = choose(equal(sin_angles_1, spread(0.0)), spread(0.0), t1) / sin_angles_1;
        const doubles theta_dot0 = omega[2] - cos_angles_1 * theta_dot2;
        const doubles theta_dot1 = omega[0] * cos_angles_0 + omega[1] * sin_angles_0;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 3, sizeof(double), copied.ahead);
        const doubles result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_all(item2, step2, 3, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
        } else {
            give_each(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_zxz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_zxz_blockf_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &omega[0]);
        } else if (step1 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item1 + entries1[0], 0);
            omega[1] = PACKEDF_IN(item1 + entries1[1], 0);
            omega[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_0 = sines[1][g];
        const floats cos_angles_0 = cosines[1][g];
        const floats t1 = omega[0] * sin_angles_0 - omega[1] * cos_angles_0;
        const floats t2 = choosef(equalf(sin_angles_1, spreadf(0.0f)), spreadf(0.0f), t1);
        const floats theta_dot2 = t2 / sin_angles_1;
        const floats theta_dot0 = omega[2] - cos_angles_1 * theta_dot2;
        const floats theta_dot1 = omega[0] * cos_angles_0 + omega[1] * sin_angles_0;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 3, sizeof(float), copied.ahead);
        const floats result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_allf(item2, step2, 3, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
        } else {
            give_eachf(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_zxz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_zyx_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[3][GROUPS];
    doubles sines[3][GROUPS];
    doubles cosines[3][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles sin_angles_2 = sines[2][g];
        const doubles cos_angles_2 = cosines[2][g];
        const doubles Q6 = -sin_angles_1;
        const doubles Q0 = cos_angles_0 * cos_angles_1;
        const doubles t1 = cos_angles_0 * sin_angles_1;
        const doubles Q3 = sin_angles_0 * cos_angles_1;
        const doubles t2 = sin_angles_0 * sin_angles_1;
        const doubles Q1 = t1 * sin_angles_2 - sin_angles_0 * cos_angles_2;
        const doubles Q2 = sin_angles_0 * sin_angles_2 + t1 * cos_angles_2;
        const doubles Q4 = cos_angles_0 * cos_angles_2 + t2 * sin_angles_2;
        const doubles Q5 = t2 * cos_angles_2 - cos_angles_0 * sin_angles_2;
        const doubles Q7 = cos_angles_1 * sin_angles_2;
        const doubles Q8 = cos_angles_1 * cos_angles_2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_zyx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_zyx_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[3][GROUPSF];
    floats sines[3][GROUPSF];
    floats cosines[3][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats sin_angles_2 = sines[2][g];
        const floats cos_angles_2 = cosines[2][g];
        const floats Q6 = -sin_angles_1;
        const floats Q0 = cos_angles_0 * cos_angles_1;
        const floats t1 = cos_angles_0 * sin_angles_1;
        const floats Q3 = sin_angles_0 * cos_angles_1;
        const floats t2 = sin_angles_0 * sin_angles_1;
        const floats Q1 = t1 * sin_angles_2 - sin_angles_0 * cos_angles_2;
        const floats Q2 = sin_angles_0 * sin_angles_2 + t1 * cos_angles_2;
        const floats Q4 = cos_angles_0 * cos_angles_2 + t2 * sin_angles_2;
        const floats Q5 = t2 * cos_angles_2 - cos_angles_0 * sin_angles_2;
        const floats Q7 = cos_angles_1 * sin_angles_2;
        const floats Q8 = cos_angles_1 * cos_angles_2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_zyx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_zyx_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles W4 = cos_angles_0;
        const doubles W1 = -sin_angles_0;
        const doubles W8 = -sin_angles_1;
        const doubles W2 = W4 * cos_angles_1;
        const doubles W5 = sin_angles_0 * cos_angles_1;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {spread(0.0), W1, W2, spread(0.0), W4, W5, spread(1.0), spread(0.0), W8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_zyx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_zyx_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats W4 = cos_angles_0;
        const floats W1 = -sin_angles_0;
        const floats W8 = -sin_angles_1;
        const floats W2 = W4 * cos_angles_1;
        const floats W5 = sin_angles_0 * cos_angles_1;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            spreadf(0.0f),
            W1,
            W2,
            spreadf(0.0f),
            W4,
            W5,
            spreadf(1.0f),
            spreadf(0.0f),
            W8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_zyx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_zyx_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 1 * sizeof(double), step0, &angles_[1]);
        } else if (step0 == sizeof(double)) {
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_2 = sines[1][g];
        const doubles cos_angles_2 = cosines[1][g];
        const doubles W_body0 = -sin_angles_1;
        const doubles W_body4 = cos_angles_2;
        const doubles W_body3 = cos_angles_1 * sin_angles_2;
        const doubles W_body7 = -sin_angles_2;
        const doubles W_body6 = cos_angles_1 * W_body4;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {
            W_body0,
            spread(0.0),
            spread(1.0),
            W_body3,
            W_body4,
            spread(0.0),
            W_body6,
            W_body7,
            spread(0.0)};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_zyx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_zyx_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 1 * sizeof(float), step0, &angles_[1]);
        } else if (step0 == sizeof(float)) {
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_2 = sines[1][g];
        const floats cos_angles_2 = cosines[1][g];
        const floats W_body0 = -sin_angles_1;
        const floats W_body4 = cos_angles_2;
        const floats W_body3 = cos_angles_1 * sin_angles_2;
        const floats W_body7 = -sin_angles_2;
        const floats W_body6 = cos_angles_1 * W_body4;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            W_body0,
            spreadf(0.0f),
            spreadf(1.0f),
            W_body3,
            W_body4,
            spreadf(0.0f),
            W_body6,
            W_body7,
            spreadf(0.0f)};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_zyx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_zyx_block_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &omega[0]);
        } else if (step1 == sizeof(double)) {
            omega[0] = PACKED_IN(item1 + entries1[0], 0);
            omega[1] = PACKED_IN(item1 + entries1[1], 0);
            omega[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_0 = sines[1][g];
        const doubles cos_angles_0 = cosines[1][g];
        const doubles t1 = omega[0] * cos_angles_0 + omega[1] * sin_angles_0;
        const doubles theta_dot2 = choose(equal(cos_angles_1, spread(0.0)), spread(0.0), t1) / cos_angles_1;
        const doubles theta_dot0 = omega[2] + sin_angles_1 * theta_dot2;
        const doubles theta_dot1 = omega[1] * cos_angles_0 - omega[0] * sin_angles_0;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 3, sizeof(double), copied.ahead);
        const doubles result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_all(item2, step2, 3, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
        } else {
            give_each(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_zyx_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_zyx_blockf_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &omega[0]);
        } else if (step1 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item1 + entries1[0], 0);
            omega[1] = PACKEDF_IN(item1 + entries1[1], 0);
            omega[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_0 = sines[1][g];
        const floats cos_angles_0 = cosines[1][g];
        const floats t1 = omega[0] * cos_angles_0 + omega[1] * sin_angles_0;
        const floats t2 = choosef(equalf(cos_angles_1, spreadf(0.0f)), spreadf(0.0f), t1);
        const floats theta_dot2 = t2 / cos_angles_1;
        const floats theta_dot0 = omega[2] + sin_angles_1 * theta_dot2;
        const floats theta_dot1 = omega[1] * cos_angles_0 - omega[0] * sin_angles_0;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 3, sizeof(float), copied.ahead);
        const floats result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_allf(item2, step2, 3, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
        } else {
            give_eachf(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_zyx_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_zyz_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[3][GROUPS];
    doubles sines[3][GROUPS];
    doubles cosines[3][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles sin_angles_2 = sines[2][g];
        const doubles cos_angles_2 = cosines[2][g];
        const doubles Q8 = cos_angles_1;
        const doubles t1 = cos_angles_0 * Q8;
        const doubles Q2 = cos_angles_0 * sin_angles_1;
        const doubles t2 = sin_angles_0 * Q8;
        const doubles Q5 = sin_angles_0 * sin_angles_1;
        const doubles Q0 = t1 * cos_angles_2 - sin_angles_0 * sin_angles_2;
        const doubles Q1 = -(t1 * sin_angles_2 + sin_angles_0 * cos_angles_2);
        const doubles Q3 = t2 * cos_angles_2 + cos_angles_0 * sin_angles_2;
        const doubles Q4 = cos_angles_0 * cos_angles_2 - t2 * sin_angles_2;
        const doubles Q6 = -(sin_angles_1 * cos_angles_2);
        const doubles Q7 = sin_angles_1 * sin_angles_2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_zyz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_zyz_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[3][GROUPSF];
    floats sines[3][GROUPSF];
    floats cosines[3][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
        angles[2][g] = angles_[2];
    }
    copied.share = (copied.share + 3) / 4;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[2], sines[2], cosines[2], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats sin_angles_2 = sines[2][g];
        const floats cos_angles_2 = cosines[2][g];
        const floats Q8 = cos_angles_1;
        const floats t1 = cos_angles_0 * Q8;
        const floats Q2 = cos_angles_0 * sin_angles_1;
        const floats t2 = sin_angles_0 * Q8;
        const floats Q5 = sin_angles_0 * sin_angles_1;
        const floats Q0 = t1 * cos_angles_2 - sin_angles_0 * sin_angles_2;
        const floats Q1 = -(t1 * sin_angles_2 + sin_angles_0 * cos_angles_2);
        const floats Q3 = t2 * cos_angles_2 + cos_angles_0 * sin_angles_2;
        const floats Q4 = cos_angles_0 * cos_angles_2 - t2 * sin_angles_2;
        const floats Q6 = -(sin_angles_1 * cos_angles_2);
        const floats Q7 = sin_angles_1 * sin_angles_2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {Q0, Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_euler_zyz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_zyz_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_0 = sines[0][g];
        const doubles cos_angles_0 = cosines[0][g];
        const doubles sin_angles_1 = sines[1][g];
        const doubles cos_angles_1 = cosines[1][g];
        const doubles W4 = cos_angles_0;
        const doubles W1 = -sin_angles_0;
        const doubles W8 = cos_angles_1;
        const doubles W2 = W4 * sin_angles_1;
        const doubles W5 = sin_angles_0 * sin_angles_1;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {spread(0.0), W1, W2, spread(0.0), W4, W5, spread(1.0), spread(0.0), W8};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_zyz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_zyz_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[0];
        angles[1][g] = angles_[1];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_0 = sines[0][g];
        const floats cos_angles_0 = cosines[0][g];
        const floats sin_angles_1 = sines[1][g];
        const floats cos_angles_1 = cosines[1][g];
        const floats W4 = cos_angles_0;
        const floats W1 = -sin_angles_0;
        const floats W8 = cos_angles_1;
        const floats W2 = W4 * sin_angles_1;
        const floats W5 = sin_angles_0 * sin_angles_1;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            spreadf(0.0f),
            W1,
            W2,
            spreadf(0.0f),
            W4,
            W5,
            spreadf(1.0f),
            spreadf(0.0f),
            W8};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_zyz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_zyz_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 1 * sizeof(double), step0, &angles_[1]);
        } else if (step0 == sizeof(double)) {
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
            angles_[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_2 = sines[1][g];
        const doubles cos_angles_2 = cosines[1][g];
        const doubles W_body6 = cos_angles_1;
        const doubles W_body4 = cos_angles_2;
        const doubles W_body0 = -(sin_angles_1 * W_body4);
        const doubles W_body1 = sin_angles_2;
        const doubles W_body3 = sin_angles_1 * W_body1;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {
            W_body0,
            W_body1,
            spread(0.0),
            W_body3,
            W_body4,
            spread(0.0),
            W_body6,
            spread(0.0),
            spread(1.0)};
        if (dense1) {
            store_all(item1, step1, 9, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
            PACKED(item1 + entries1[3], 0) = result1[3];
            PACKED(item1 + entries1[4], 0) = result1[4];
            PACKED(item1 + entries1[5], 0) = result1[5];
            PACKED(item1 + entries1[6], 0) = result1[6];
            PACKED(item1 + entries1[7], 0) = result1[7];
            PACKED(item1 + entries1[8], 0) = result1[8];
        } else {
            give_each(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_zyz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rate_matrix_body_zyz_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 1 * sizeof(float), step0, &angles_[1]);
        } else if (step0 == sizeof(float)) {
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
            angles_[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[1] = all[1];
            angles_[2] = all[2];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[2];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_2 = sines[1][g];
        const floats cos_angles_2 = cosines[1][g];
        const floats W_body6 = cos_angles_1;
        const floats W_body4 = cos_angles_2;
        const floats W_body0 = -(sin_angles_1 * W_body4);
        const floats W_body1 = sin_angles_2;
        const floats W_body3 = sin_angles_1 * W_body1;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {
            W_body0,
            W_body1,
            spreadf(0.0f),
            W_body3,
            W_body4,
            spreadf(0.0f),
            W_body6,
            spreadf(0.0f),
            spreadf(1.0f)};
        if (dense1) {
            store_allf(item1, step1, 9, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
            PACKEDF(item1 + entries1[3], 0) = result1[3];
            PACKEDF(item1 + entries1[4], 0) = result1[4];
            PACKEDF(item1 + entries1[5], 0) = result1[5];
            PACKEDF(item1 + entries1[6], 0) = result1[6];
            PACKEDF(item1 + entries1[7], 0) = result1[7];
            PACKEDF(item1 + entries1[8], 0) = result1[8];
        } else {
            give_eachf(item1, entries1, step1, 9, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rate_matrix_body_zyz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_zyz_block_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[2][GROUPS];
    doubles sines[2][GROUPS];
    doubles cosines[2][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles angles_[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2(item0 + 0 * sizeof(double), step0, &angles_[0]);
        } else if (step0 == sizeof(double)) {
            angles_[0] = PACKED_IN(item0 + entries0[0], 0);
            angles_[1] = PACKED_IN(item0 + entries0[1], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincos)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &omega[0]);
        } else if (step1 == sizeof(double)) {
            omega[0] = PACKED_IN(item1 + entries1[0], 0);
            omega[1] = PACKED_IN(item1 + entries1[1], 0);
            omega[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_angles_1 = sines[0][g];
        const doubles cos_angles_1 = cosines[0][g];
        const doubles sin_angles_0 = sines[1][g];
        const doubles cos_angles_0 = cosines[1][g];
        const doubles t1 = omega[0] * cos_angles_0 + omega[1] * sin_angles_0;
        const doubles theta_dot2 = choose(equal(sin_angles_1, spread(0.0)), spread(0.0), t1) / sin_angles_1;
        const doubles theta_dot0 = omega[2] - cos_angles_1 * theta_dot2;
        const doubles theta_dot1 = omega[1] * cos_angles_0 - omega[0] * sin_angles_0;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 3, sizeof(double), copied.ahead);
        const doubles result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_all(item2, step2, 3, result2);
        } else if (step2 == sizeof(double)) {
            PACKED(item2 + entries2[0], 0) = result2[0];
            PACKED(item2 + entries2[1], 0) = result2[1];
            PACKED(item2 + entries2[2], 0) = result2[2];
        } else {
            give_each(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_zyz_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rates_zyz_blockf_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[2][GROUPSF];
    floats sines[2][GROUPSF];
    floats cosines[2][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats angles_[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_2f(item0 + 0 * sizeof(float), step0, &angles_[0]);
        } else if (step0 == sizeof(float)) {
            angles_[0] = PACKEDF_IN(item0 + entries0[0], 0);
            angles_[1] = PACKEDF_IN(item0 + entries0[1], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            angles_[0] = all[0];
            angles_[1] = all[1];
        }
        angles[0][g] = angles_[1];
        angles[1][g] = angles_[0];
    }
    copied.share = (copied.share + 2) / 3;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[1], sines[1], cosines[1], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &omega[0]);
        } else if (step1 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item1 + entries1[0], 0);
            omega[1] = PACKEDF_IN(item1 + entries1[1], 0);
            omega[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_angles_1 = sines[0][g];
        const floats cos_angles_1 = cosines[0][g];
        const floats sin_angles_0 = sines[1][g];
        const floats cos_angles_0 = cosines[1][g];
        const floats t1 = omega[0] * cos_angles_0 + omega[1] * sin_angles_0;
        const floats t2 = choosef(equalf(sin_angles_1, spreadf(0.0f)), spreadf(0.0f), t1);
        const floats theta_dot2 = t2 / sin_angles_1;
        const floats theta_dot0 = omega[2] - cos_angles_1 * theta_dot2;
        const floats theta_dot1 = omega[1] * cos_angles_0 - omega[0] * sin_angles_0;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 3, sizeof(float), copied.ahead);
        const floats result2[] = {theta_dot0, theta_dot1, theta_dot2};
        if (dense2) {
            store_allf(item2, step2, 3, result2);
        } else if (step2 == sizeof(float)) {
            PACKEDF(item2 + entries2[0], 0) = result2[0];
            PACKEDF(item2 + entries2[1], 0) = result2[1];
            PACKEDF(item2 + entries2[2], 0) = result2[2];
        } else {
            give_eachf(item2, entries2, step2, 3, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rates_zyz_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

#else

void CHASLES_LEVELED(chasles_rotation_from_euler_xyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_xyx(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_xyxf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_xyx(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_xyxf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_xyx(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_xyxf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_xyx(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_xyxf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_xyz(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_xyzf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_xyz(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_xyzf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_xyz(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_xyzf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_xyz(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_xyzf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_xzx(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_xzxf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_xzx(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_xzxf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_xzx(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_xzxf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_xzx(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_xzxf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_xzy(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_xzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_xzyf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_xzy(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_xzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_xzyf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_xzy(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_xzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_xzyf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_xzy(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_xzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_xzyf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_yxy(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_yxyf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_yxy(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_yxyf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_yxy(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_yxyf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_yxy(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_yxyf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_yxz(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_yxzf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_yxz(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_yxzf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_yxz(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_yxzf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_yxz(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_yxzf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_yzx(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_yzxf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_yzx(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_yzxf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_yzx(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_yzxf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yzx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_yzx(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yzx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_yzxf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_yzy(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_yzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_yzyf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_yzy(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_yzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_yzyf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_yzy(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_yzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_yzyf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yzy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_yzy(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_yzy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_yzyf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_zxy(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_zxyf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_zxy(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_zxyf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_zxy(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_zxyf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zxy_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_zxy(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zxy_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_zxyf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_zxz(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_zxzf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_zxz(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_zxzf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_zxz(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_zxzf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zxz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_zxz(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zxz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_zxzf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_zyx(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_zyxf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_zyx(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_zyxf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_zyx(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_zyxf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zyx_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_zyx(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zyx_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_zyxf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_zyz(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_zyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_zyzf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_zyz(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_zyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_zyzf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_zyz(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rate_matrix_body_zyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rate_matrix_body_zyzf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zyz_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_zyz(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rates_zyz_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rates_zyzf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

#endif
