/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_4_2, for batches. Made by `chasles emit`; not to be edited by hand.
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

CHASLES_INLINE void chasles_natural_rate_matrix_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 12 * sizeof(double));
    ptrdiff_t entries2[12];
    const int dense2 = CHASLES_DENSE(find_entries(12, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[1][GROUPS];
    doubles sines[1][GROUPS];
    doubles cosines[1][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &phi);
        angles[0][g] = 0.5 * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles e[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &e[0]);
        } else if (step0 == sizeof(double)) {
            e[0] = PACKED_IN(item0 + entries0[0], 0);
            e[1] = PACKED_IN(item0 + entries0[1], 0);
            e[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles N9 = e[0];
        const doubles N10 = e[1];
        const doubles N11 = e[2];
        const doubles half_N9 = 0.5 * N9;
        const doubles half_N10 = 0.5 * N10;
        const doubles half_N11 = 0.5 * N11;
        const doubles t1 = choose(equal(sin_half_phi, spread(0.0)), spread(0.0), cos_half_phi);
        const doubles t2 = 0.5 * (t1 / sin_half_phi);
        const doubles t3 = N10 * t2;
        const doubles t4 = N11 * t2;
        const doubles t5 = N9 * (N9 * t2);
        const doubles t6 = N9 * t3;
        const doubles t7 = N9 * t4;
        const doubles t8 = N10 * t3;
        const doubles t9 = N10 * t4;
        const doubles t10 = N11 * t4;
        const doubles N0 = t8 + t10;
        const doubles N4 = t5 + t10;
        const doubles N8 = t5 + t8;
        const doubles N1 = half_N11 - t6;
        const doubles N2 = -(half_N10 + t7);
        const doubles N3 = -(half_N11 + t6);
        const doubles N5 = half_N9 - t9;
        const doubles N6 = half_N10 - t7;
        const doubles N7 = -(half_N9 + t9);
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 12, sizeof(double), copied.ahead);
        const doubles result2[] = {N0, N1, N2, N3, N4, N5, N6, N7, N8, N9, N10, N11};
        if (dense2) {
            store_all(item2, step2, 12, result2);
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
            PACKED(item2 + entries2[9], 0) = result2[9];
            PACKED(item2 + entries2[10], 0) = result2[10];
            PACKED(item2 + entries2[11], 0) = result2[11];
        } else {
            give_each(item2, entries2, step2, 12, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_natural_rate_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_natural_rate_matrix_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_natural_rate_matrix_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 12 * sizeof(float));
    ptrdiff_t entries2[12];
    const int dense2 = CHASLES_DENSE(find_entries(12, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[1][GROUPSF];
    floats sines[1][GROUPSF];
    floats cosines[1][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &phi);
        angles[0][g] = 0.5f * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats e[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &e[0]);
        } else if (step0 == sizeof(float)) {
            e[0] = PACKEDF_IN(item0 + entries0[0], 0);
            e[1] = PACKEDF_IN(item0 + entries0[1], 0);
            e[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats N9 = e[0];
        const floats N10 = e[1];
        const floats N11 = e[2];
        const floats half_N9 = 0.5f * N9;
        const floats half_N10 = 0.5f * N10;
        const floats half_N11 = 0.5f * N11;
        const truthsf t1 = equalf(sin_half_phi, spreadf(0.0f));
        const floats t2 = 0.5f * (choosef(t1, spreadf(0.0f), cos_half_phi) / sin_half_phi);
        const floats t3 = N10 * t2;
        const floats t4 = N11 * t2;
        const floats t5 = N9 * (N9 * t2);
        const floats t6 = N9 * t3;
        const floats t7 = N9 * t4;
        const floats t8 = N10 * t3;
        const floats t9 = N10 * t4;
        const floats t10 = N11 * t4;
        const floats N0 = t8 + t10;
        const floats N4 = t5 + t10;
        const floats N8 = t5 + t8;
        const floats N1 = half_N11 - t6;
        const floats N2 = -(half_N10 + t7);
        const floats N3 = -(half_N11 + t6);
        const floats N5 = half_N9 - t9;
        const floats N6 = half_N10 - t7;
        const floats N7 = -(half_N9 + t9);
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 12, sizeof(float), copied.ahead);
        const floats result2[] = {N0, N1, N2, N3, N4, N5, N6, N7, N8, N9, N10, N11};
        if (dense2) {
            store_allf(item2, step2, 12, result2);
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
            PACKEDF(item2 + entries2[9], 0) = result2[9];
            PACKEDF(item2 + entries2[10], 0) = result2[10];
            PACKEDF(item2 + entries2[11], 0) = result2[11];
        } else {
            give_eachf(item2, entries2, step2, 12, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_natural_rate_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_natural_rate_matrix_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_linear_rate_matrix_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 12 * sizeof(double));
    ptrdiff_t entries2[12];
    const int dense2 = CHASLES_DENSE(find_entries(12, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[1][GROUPS];
    doubles sines[1][GROUPS];
    doubles cosines[1][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &phi);
        angles[0][g] = phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles e[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &e[0]);
        } else if (step0 == sizeof(double)) {
            e[0] = PACKED_IN(item0 + entries0[0], 0);
            e[1] = PACKED_IN(item0 + entries0[1], 0);
            e[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        const doubles sin_phi = sines[0][g];
        const doubles cos_phi = cosines[0][g];
        const doubles half_cos_phi = 0.5 * cos_phi;
        const doubles t1 = 0.5 - half_cos_phi;
        const doubles t2 = e[0] * t1;
        const doubles t3 = e[1] * t1;
        const doubles t4 = e[1] * t2;
        const doubles t5 = e[2] * t2;
        const doubles t6 = e[2] * t3;
        const doubles t7 = 0.5 + half_cos_phi;
        const doubles L0 = t7 - e[0] * t2;
        const doubles L4 = t7 - e[1] * t3;
        const doubles L8 = t7 - e[2] * (e[2] * t1);
        const doubles half_sin_phi = 0.5 * sin_phi;
        const doubles t8 = e[0] * half_sin_phi;
        const doubles t9 = e[1] * half_sin_phi;
        const doubles t10 = e[2] * half_sin_phi;
        const doubles L1 = t10 - t4;
        const doubles L2 = -(t5 + t9);
        const doubles L3 = -(t4 + t10);
        const doubles L5 = t8 - t6;
        const doubles L6 = t9 - t5;
        const doubles L7 = -(t6 + t8);
        const doubles L9 = -(e[0] * sin_phi);
        const doubles L10 = -(e[1] * sin_phi);
        const doubles L11 = -(e[2] * sin_phi);
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 12, sizeof(double), copied.ahead);
        const doubles result2[] = {L0, L1, L2, L3, L4, L5, L6, L7, L8, L9, L10, L11};
        if (dense2) {
            store_all(item2, step2, 12, result2);
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
            PACKED(item2 + entries2[9], 0) = result2[9];
            PACKED(item2 + entries2[10], 0) = result2[10];
            PACKED(item2 + entries2[11], 0) = result2[11];
        } else {
            give_each(item2, entries2, step2, 12, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_linear_rate_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_linear_rate_matrix_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_linear_rate_matrix_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 12 * sizeof(float));
    ptrdiff_t entries2[12];
    const int dense2 = CHASLES_DENSE(find_entries(12, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[1][GROUPSF];
    floats sines[1][GROUPSF];
    floats cosines[1][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &phi);
        angles[0][g] = phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats e[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &e[0]);
        } else if (step0 == sizeof(float)) {
            e[0] = PACKEDF_IN(item0 + entries0[0], 0);
            e[1] = PACKEDF_IN(item0 + entries0[1], 0);
            e[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        const floats sin_phi = sines[0][g];
        const floats cos_phi = cosines[0][g];
        const floats half_cos_phi = 0.5f * cos_phi;
        const floats t1 = 0.5f - half_cos_phi;
        const floats t2 = e[0] * t1;
        const floats t3 = e[1] * t1;
        const floats t4 = e[1] * t2;
        const floats t5 = e[2] * t2;
        const floats t6 = e[2] * t3;
        const floats t7 = 0.5f + half_cos_phi;
        const floats L0 = t7 - e[0] * t2;
        const floats L4 = t7 - e[1] * t3;
        const floats L8 = t7 - e[2] * (e[2] * t1);
        const floats half_sin_phi = 0.5f * sin_phi;
        const floats t8 = e[0] * half_sin_phi;
        const floats t9 = e[1] * half_sin_phi;
        const floats t10 = e[2] * half_sin_phi;
        const floats L1 = t10 - t4;
        const floats L2 = -(t5 + t9);
        const floats L3 = -(t4 + t10);
        const floats L5 = t8 - t6;
        const floats L6 = t9 - t5;
        const floats L7 = -(t6 + t8);
        const floats L9 = -(e[0] * sin_phi);
        const floats L10 = -(e[1] * sin_phi);
        const floats L11 = -(e[2] * sin_phi);
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 12, sizeof(float), copied.ahead);
        const floats result2[] = {L0, L1, L2, L3, L4, L5, L6, L7, L8, L9, L10, L11};
        if (dense2) {
            store_allf(item2, step2, 12, result2);
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
            PACKEDF(item2 + entries2[9], 0) = result2[9];
            PACKEDF(item2 + entries2[10], 0) = result2[10];
            PACKEDF(item2 + entries2[11], 0) = result2[11];
        } else {
            give_eachf(item2, entries2, step2, 12, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_linear_rate_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_linear_rate_matrix_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rodrigues_rate_matrix_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 12 * sizeof(double));
    ptrdiff_t entries2[12];
    const int dense2 = CHASLES_DENSE(find_entries(12, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[1][GROUPS];
    doubles sines[1][GROUPS];
    doubles cosines[1][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &phi);
        angles[0][g] = 0.5 * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles e[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &e[0]);
        } else if (step0 == sizeof(double)) {
            e[0] = PACKED_IN(item0 + entries0[0], 0);
            e[1] = PACKED_IN(item0 + entries0[1], 0);
            e[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles H0 = 0.5 * cos_half_phi;
        const doubles half_sin_half_phi = 0.5 * sin_half_phi;
        const doubles H5 = e[0] * half_sin_half_phi;
        const doubles H7 = -H5;
        const doubles H6 = e[1] * half_sin_half_phi;
        const doubles H2 = -H6;
        const doubles H1 = e[2] * half_sin_half_phi;
        const doubles H3 = -H1;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 12, sizeof(double), copied.ahead);
        const doubles result2[] = {H0, H1, H2, H3, H0, H5, H6, H7, H0, H7, H2, H3};
        if (dense2) {
            store_all(item2, step2, 12, result2);
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
            PACKED(item2 + entries2[9], 0) = result2[9];
            PACKED(item2 + entries2[10], 0) = result2[10];
            PACKED(item2 + entries2[11], 0) = result2[11];
        } else {
            give_each(item2, entries2, step2, 12, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_rate_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 3)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 5)
        && is_packed(12, 3, sizeof(double), steps[2], steps + 7)) {
        chasles_euler_rodrigues_rate_matrix_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_euler_rodrigues_rate_matrix_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rodrigues_rate_matrix_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 12 * sizeof(float));
    ptrdiff_t entries2[12];
    const int dense2 = CHASLES_DENSE(find_entries(12, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[1][GROUPSF];
    floats sines[1][GROUPSF];
    floats cosines[1][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &phi);
        angles[0][g] = 0.5f * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats e[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &e[0]);
        } else if (step0 == sizeof(float)) {
            e[0] = PACKEDF_IN(item0 + entries0[0], 0);
            e[1] = PACKEDF_IN(item0 + entries0[1], 0);
            e[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats H0 = 0.5f * cos_half_phi;
        const floats half_sin_half_phi = 0.5f * sin_half_phi;
        const floats H5 = e[0] * half_sin_half_phi;
        const floats H7 = -H5;
        const floats H6 = e[1] * half_sin_half_phi;
        const floats H2 = -H6;
        const floats H1 = e[2] * half_sin_half_phi;
        const floats H3 = -H1;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 12, sizeof(float), copied.ahead);
        const floats result2[] = {H0, H1, H2, H3, H0, H5, H6, H7, H0, H7, H2, H3};
        if (dense2) {
            store_allf(item2, step2, 12, result2);
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
            PACKEDF(item2 + entries2[9], 0) = result2[9];
            PACKEDF(item2 + entries2[10], 0) = result2[10];
            PACKEDF(item2 + entries2[11], 0) = result2[11];
        } else {
            give_eachf(item2, entries2, step2, 12, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_rate_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 3)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 5)
        && is_packed(12, 3, sizeof(float), steps[2], steps + 7)) {
        chasles_euler_rodrigues_rate_matrix_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_euler_rodrigues_rate_matrix_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_linear_invariants_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(double));
    ptrdiff_t entries2[9];
    const int dense2 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles q[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &q[0]);
        } else if (step0 == sizeof(double)) {
            q[0] = PACKED_IN(item0 + entries0[0], 0);
            q[1] = PACKED_IN(item0 + entries0[1], 0);
            q[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            q[0] = all[0];
            q[1] = all[1];
            q[2] = all[2];
        }
        doubles q_0;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &q_0);
        const doubles t1 = 1.0 + q_0;
        const doubles t2 = choose(equal(t1, spread(0.0)), spread(0.0), spread(1.0)) / t1;
        const doubles t3 = q[0] * t2;
        const doubles t4 = q[1] * t2;
        const doubles t5 = q[1] * t3;
        const doubles t6 = q[2] * t3;
        const doubles t7 = q[2] * t4;
        const doubles Q0 = q_0 + q[0] * t3;
        const doubles Q4 = q_0 + q[1] * t4;
        const doubles Q8 = q_0 + q[2] * (q[2] * t2);
        const doubles Q1 = t5 - q[2];
        const doubles Q2 = q[1] + t6;
        const doubles Q3 = q[2] + t5;
        const doubles Q5 = t7 - q[0];
        const doubles Q6 = t6 - q[1];
        const doubles Q7 = q[0] + t7;
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

void CHASLES_LEVELED(chasles_rotation_from_linear_invariants_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 3)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 5)
        && is_packed(9, 3, sizeof(double), steps[2], steps + 7)) {
        chasles_rotation_from_linear_invariants_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_rotation_from_linear_invariants_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_linear_invariants_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(float));
    ptrdiff_t entries2[9];
    const int dense2 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats q[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &q[0]);
        } else if (step0 == sizeof(float)) {
            q[0] = PACKEDF_IN(item0 + entries0[0], 0);
            q[1] = PACKEDF_IN(item0 + entries0[1], 0);
            q[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            q[0] = all[0];
            q[1] = all[1];
            q[2] = all[2];
        }
        floats q_0;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &q_0);
        const floats t1 = 1.0f + q_0;
        const floats t2 = choosef(equalf(t1, spreadf(0.0f)), spreadf(0.0f), spreadf(1.0f)) / t1;
        const floats t3 = q[0] * t2;
        const floats t4 = q[1] * t2;
        const floats t5 = q[1] * t3;
        const floats t6 = q[2] * t3;
        const floats t7 = q[2] * t4;
        const floats Q0 = q_0 + q[0] * t3;
        const floats Q4 = q_0 + q[1] * t4;
        const floats Q8 = q_0 + q[2] * (q[2] * t2);
        const floats Q1 = t5 - q[2];
        const floats Q2 = q[1] + t6;
        const floats Q3 = q[2] + t5;
        const floats Q5 = t7 - q[0];
        const floats Q6 = t6 - q[1];
        const floats Q7 = q[0] + t7;
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

void CHASLES_LEVELED(chasles_rotation_from_linear_invariants_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 3)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 5)
        && is_packed(9, 3, sizeof(float), steps[2], steps + 7)) {
        chasles_rotation_from_linear_invariants_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_rotation_from_linear_invariants_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_rodrigues_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(double));
    ptrdiff_t entries2[9];
    const int dense2 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles q[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &q[0]);
        } else if (step0 == sizeof(double)) {
            q[0] = PACKED_IN(item0 + entries0[0], 0);
            q[1] = PACKED_IN(item0 + entries0[1], 0);
            q[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            q[0] = all[0];
            q[1] = all[1];
            q[2] = all[2];
        }
        doubles q_0;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &q_0);
        const doubles t1 = q_0 * q_0 - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
        const doubles t2 = 2.0 * q_0;
        const doubles t3 = 2.0 * q[0];
        const doubles t4 = 2.0 * q[1];
        const doubles t5 = q[1] * t3;
        const doubles t6 = q[2] * t3;
        const doubles t7 = q[2] * t4;
        const doubles Q0 = t1 + q[0] * t3;
        const doubles Q4 = t1 + q[1] * t4;
        const doubles Q8 = t1 + q[2] * (2.0 * q[2]);
        const doubles t8 = q[0] * t2;
        const doubles t9 = q[1] * t2;
        const doubles t10 = q[2] * t2;
        const doubles Q1 = t5 - t10;
        const doubles Q2 = t6 + t9;
        const doubles Q3 = t5 + t10;
        const doubles Q5 = t7 - t8;
        const doubles Q6 = t6 - t9;
        const doubles Q7 = t7 + t8;
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

void CHASLES_LEVELED(chasles_rotation_from_euler_rodrigues_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 3)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 5)
        && is_packed(9, 3, sizeof(double), steps[2], steps + 7)) {
        chasles_rotation_from_euler_rodrigues_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_rotation_from_euler_rodrigues_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_euler_rodrigues_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(float));
    ptrdiff_t entries2[9];
    const int dense2 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats q[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &q[0]);
        } else if (step0 == sizeof(float)) {
            q[0] = PACKEDF_IN(item0 + entries0[0], 0);
            q[1] = PACKEDF_IN(item0 + entries0[1], 0);
            q[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            q[0] = all[0];
            q[1] = all[1];
            q[2] = all[2];
        }
        floats q_0;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &q_0);
        const floats t1 = q_0 * q_0 - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
        const floats t2 = 2.0f * q_0;
        const floats t3 = 2.0f * q[0];
        const floats t4 = 2.0f * q[1];
        const floats t5 = q[1] * t3;
        const floats t6 = q[2] * t3;
        const floats t7 = q[2] * t4;
        const floats Q0 = t1 + q[0] * t3;
        const floats Q4 = t1 + q[1] * t4;
        const floats Q8 = t1 + q[2] * (2.0f * q[2]);
        const floats t8 = q[0] * t2;
        const floats t9 = q[1] * t2;
        const floats t10 = q[2] * t2;
        const floats Q1 = t5 - t10;
        const floats Q2 = t6 + t9;
        const floats Q3 = t5 + t10;
        const floats Q5 = t7 - t8;
        const floats Q6 = t6 - t9;
        const floats Q7 = t7 + t8;
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

void CHASLES_LEVELED(chasles_rotation_from_euler_rodrigues_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 3)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 5)
        && is_packed(9, 3, sizeof(float), steps[2], steps + 7)) {
        chasles_rotation_from_euler_rodrigues_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_rotation_from_euler_rodrigues_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_linear_invariants_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles Q[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &Q[0]);
            load_4(item0 + 4 * sizeof(double), step0, &Q[4]);
            load_1(item0 + 8 * sizeof(double), step0, &Q[8]);
        } else if (step0 == sizeof(double)) {
            Q[0] = PACKED_IN(item0 + entries0[0], 0);
            Q[1] = PACKED_IN(item0 + entries0[1], 0);
            Q[2] = PACKED_IN(item0 + entries0[2], 0);
            Q[3] = PACKED_IN(item0 + entries0[3], 0);
            Q[4] = PACKED_IN(item0 + entries0[4], 0);
            Q[5] = PACKED_IN(item0 + entries0[5], 0);
            Q[6] = PACKED_IN(item0 + entries0[6], 0);
            Q[7] = PACKED_IN(item0 + entries0[7], 0);
            Q[8] = PACKED_IN(item0 + entries0[8], 0);
        } else {
            doubles all[9];
            take_each(item0, entries0, step0, 9, all);
            Q[0] = all[0];
            Q[1] = all[1];
            Q[2] = all[2];
            Q[3] = all[3];
            Q[4] = all[4];
            Q[5] = all[5];
            Q[6] = all[6];
            Q[7] = all[7];
            Q[8] = all[8];
        }
        const doubles q0 = 0.5 * (Q[7] - Q[5]);
        const doubles q1 = 0.5 * (Q[2] - Q[6]);
        const doubles q2 = 0.5 * (Q[3] - Q[1]);
        const doubles q_0_value = 0.5 * (Q[8] + (Q[0] + Q[4]) - 1.0);
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 3, sizeof(double), copied.ahead);
        const doubles result1[] = {q0, q1, q2};
        if (dense1) {
            store_all(item1, step1, 3, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
        } else {
            give_each(item1, entries1, step1, 3, result1);
        }
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 1, sizeof(double), copied.ahead);
        store_1(item2, step2, q_0_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_linear_invariants_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(double), steps[0], steps + 3)
        && is_packed(3, 3, sizeof(double), steps[1], steps + 5)
        && is_packed(1, 1, sizeof(double), steps[2], steps + 7)) {
        chasles_linear_invariants_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_linear_invariants_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_linear_invariants_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats Q[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &Q[0]);
            load_4f(item0 + 4 * sizeof(float), step0, &Q[4]);
            load_1f(item0 + 8 * sizeof(float), step0, &Q[8]);
        } else if (step0 == sizeof(float)) {
            Q[0] = PACKEDF_IN(item0 + entries0[0], 0);
            Q[1] = PACKEDF_IN(item0 + entries0[1], 0);
            Q[2] = PACKEDF_IN(item0 + entries0[2], 0);
            Q[3] = PACKEDF_IN(item0 + entries0[3], 0);
            Q[4] = PACKEDF_IN(item0 + entries0[4], 0);
            Q[5] = PACKEDF_IN(item0 + entries0[5], 0);
            Q[6] = PACKEDF_IN(item0 + entries0[6], 0);
            Q[7] = PACKEDF_IN(item0 + entries0[7], 0);
            Q[8] = PACKEDF_IN(item0 + entries0[8], 0);
        } else {
            floats all[9];
            take_eachf(item0, entries0, step0, 9, all);
            Q[0] = all[0];
            Q[1] = all[1];
            Q[2] = all[2];
            Q[3] = all[3];
            Q[4] = all[4];
            Q[5] = all[5];
            Q[6] = all[6];
            Q[7] = all[7];
            Q[8] = all[8];
        }
        const floats q0 = 0.5f * (Q[7] - Q[5]);
        const floats q1 = 0.5f * (Q[2] - Q[6]);
        const floats q2 = 0.5f * (Q[3] - Q[1]);
        const floats q_0_value = 0.5f * (Q[8] + (Q[0] + Q[4]) - 1.0f);
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 3, sizeof(float), copied.ahead);
        const floats result1[] = {q0, q1, q2};
        if (dense1) {
            store_allf(item1, step1, 3, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
        } else {
            give_eachf(item1, entries1, step1, 3, result1);
        }
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 1, sizeof(float), copied.ahead);
        store_1f(item2, step2, q_0_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_linear_invariants_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(float), steps[0], steps + 3)
        && is_packed(3, 3, sizeof(float), steps[1], steps + 5)
        && is_packed(1, 1, sizeof(float), steps[2], steps + 7)) {
        chasles_linear_invariants_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_linear_invariants_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_natural_invariants_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles Q[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &Q[0]);
            load_4(item0 + 4 * sizeof(double), step0, &Q[4]);
            load_1(item0 + 8 * sizeof(double), step0, &Q[8]);
        } else if (step0 == sizeof(double)) {
            Q[0] = PACKED_IN(item0 + entries0[0], 0);
            Q[1] = PACKED_IN(item0 + entries0[1], 0);
            Q[2] = PACKED_IN(item0 + entries0[2], 0);
            Q[3] = PACKED_IN(item0 + entries0[3], 0);
            Q[4] = PACKED_IN(item0 + entries0[4], 0);
            Q[5] = PACKED_IN(item0 + entries0[5], 0);
            Q[6] = PACKED_IN(item0 + entries0[6], 0);
            Q[7] = PACKED_IN(item0 + entries0[7], 0);
            Q[8] = PACKED_IN(item0 + entries0[8], 0);
        } else {
            doubles all[9];
            take_each(item0, entries0, step0, 9, all);
            Q[0] = all[0];
            Q[1] = all[1];
            Q[2] = all[2];
            Q[3] = all[3];
            Q[4] = all[4];
            Q[5] = all[5];
            Q[6] = all[6];
            Q[7] = all[7];
            Q[8] = all[8];
        }
        const doubles t1 = Q[2] + Q[6];
        const doubles t2 = Q[5] + Q[7];
        const doubles t3 = Q[8] + (Q[0] + Q[4]);
        const doubles t4 = 1.0 + 2.0 * Q[8] - t3;
        const doubles t5 = t1 * t1;
        const doubles t6 = t2 * t2;
        const doubles t7 = Q[1] + Q[3];
        const doubles t8 = 1.0 + 2.0 * Q[4] - t3;
        const doubles t9 = t7 * t7;
        const doubles t10 = Q[7] - Q[5];
        const doubles t11 = Q[2] - Q[6];
        const doubles t12 = Q[3] - Q[1];
        const doubles t13 = t11 * t11;
        const doubles t14 = t6 + (t9 + t8 * t8) + t13;
        const doubles t15 = t12 * t12;
        const doubles t16 = t5 + t6 + t4 * t4 + t15;
        const truths t17 = less(t14, t16);
        const doubles t18 = choose(t17, t1, t7);
        const doubles t19 = choose(t17, t2, t8);
        const doubles t20 = choose(t17, t4, t2);
        const doubles t21 = 1.0 + 2.0 * Q[0] - t3;
        const doubles t22 = t10 * t10;
        const doubles t23 = t5 + (t9 + t21 * t21) + t22;
        const truths t24 = less(t23, t16);
        const truths t25 = less(t23, t14);
        const doubles t26 = choose(t25, t18, choose(t24, t18, t21));
        const doubles t27 = choose(t25, t19, choose(t24, t19, t7));
        const doubles t28 = choose(t25, t20, choose(t24, t20, t1));
        const doubles t29 = 1.0 + t3;
        const doubles t30 = t15 + (t13 + t22) + t29 * t29;
        const truths t31 = less(t30, t16);
        const truths t32 = less(t30, t14);
        const truths t33 = less(t30, t23);
        const doubles t34 = choose(t33, t26, choose(t32, t26, choose(t31, t26, t10)));
        const doubles t35 = choose(t33, t27, choose(t32, t27, choose(t31, t27, t11)));
        const doubles t36 = choose(t33, t28, choose(t32, t28, choose(t31, t28, t12)));
        const doubles t37 = choose(less(t34, spread(0.0)), -t34, t34);
        const doubles t38 = choose(less(t35, spread(0.0)), -t35, t35);
        const doubles t39 = choose(less(t37, t38), t38, t37);
        const doubles t40 = choose(less(t36, spread(0.0)), -t36, t36);
        const doubles t41 = choose(less(t39, t40), t40, t39);
        const doubles t42 = choose(equal(spread(0.0), t41), spread(1.0), t41);
        const doubles t43 = t34 / t42;
        const doubles t44 = t35 / t42;
        const doubles t45 = t36 / t42;
        const doubles t46 = t43 * t43 + t44 * t44 + t45 * t45;
        const doubles t47 = roots(t46);
        const truths t48 = equal(t46, spread(0.0));
        const doubles t49 = choose(t48, spread(0.0), t43) / t47;
        const doubles t50 = choose(t48, spread(0.0), t44) / t47;
        const doubles t51 = choose(t48, spread(0.0), t45) / t47;
        const doubles t52 = choose(t17, t12, t11);
        const doubles t53 = choose(t17, t16, t14);
        const doubles t54 = choose(t25, t52, choose(t24, t52, t10));
        const doubles t55 = choose(t25, t53, choose(t24, t53, t23));
        const doubles t56 = choose(t33, t55, choose(t32, t55, choose(t31, t55, t30)));
        const doubles t57 = roots(t56);
        const truths t58 = equal(t56, spread(0.0));
        const doubles t59 = choose(t33, t54, choose(t32, t54, choose(t31, t54, t29)));
        const doubles t60 = choose(t58, spread(0.0), t59) / t57;
        const doubles t61 = choose(less(t51, spread(0.0)), spread(-1.0), spread(1.0));
        const doubles t62 = choose(less(spread(0.0), t50), spread(1.0), t61);
        const doubles t63 = choose(less(t50, spread(0.0)), spread(-1.0), t62);
        const doubles t64 = choose(less(spread(0.0), t49), spread(1.0), t63);
        const doubles t65 = choose(less(t49, spread(0.0)), spread(-1.0), t64);
        const doubles t66 = choose(less(spread(0.0), t60), spread(1.0), t65);
        const doubles t67 = choose(less(t60, spread(0.0)), spread(-1.0), t66);
        const doubles t68 = choose(equal(spread(0.0), t30 - t30), t67, spread(NAN));
        const doubles e0 = t49 * t68;
        const doubles e1 = t50 * t68;
        const doubles e2 = t51 * t68;
        const doubles phi_value = 2.0 * directions(t42 * (choose(t58, spread(0.0), t47) / t57), t60 * t68);
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 3, sizeof(double), copied.ahead);
        const doubles result1[] = {e0, e1, e2};
        if (dense1) {
            store_all(item1, step1, 3, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
        } else {
            give_each(item1, entries1, step1, 3, result1);
        }
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 1, sizeof(double), copied.ahead);
        store_1(item2, step2, phi_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_natural_invariants_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_natural_invariants_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_natural_invariants_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats Q[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &Q[0]);
            load_4f(item0 + 4 * sizeof(float), step0, &Q[4]);
            load_1f(item0 + 8 * sizeof(float), step0, &Q[8]);
        } else if (step0 == sizeof(float)) {
            Q[0] = PACKEDF_IN(item0 + entries0[0], 0);
            Q[1] = PACKEDF_IN(item0 + entries0[1], 0);
            Q[2] = PACKEDF_IN(item0 + entries0[2], 0);
            Q[3] = PACKEDF_IN(item0 + entries0[3], 0);
            Q[4] = PACKEDF_IN(item0 + entries0[4], 0);
            Q[5] = PACKEDF_IN(item0 + entries0[5], 0);
            Q[6] = PACKEDF_IN(item0 + entries0[6], 0);
            Q[7] = PACKEDF_IN(item0 + entries0[7], 0);
            Q[8] = PACKEDF_IN(item0 + entries0[8], 0);
        } else {
            floats all[9];
            take_eachf(item0, entries0, step0, 9, all);
            Q[0] = all[0];
            Q[1] = all[1];
            Q[2] = all[2];
            Q[3] = all[3];
            Q[4] = all[4];
            Q[5] = all[5];
            Q[6] = all[6];
            Q[7] = all[7];
            Q[8] = all[8];
        }
        const floats t1 = Q[2] + Q[6];
        const floats t2 = Q[5] + Q[7];
        const floats t3 = Q[8] + (Q[0] + Q[4]);
        const floats t4 = 1.0f + 2.0f * Q[8] - t3;
        const floats t5 = t1 * t1;
        const floats t6 = t2 * t2;
        const floats t7 = Q[1] + Q[3];
        const floats t8 = 1.0f + 2.0f * Q[4] - t3;
        const floats t9 = t7 * t7;
        const floats t10 = Q[7] - Q[5];
        const floats t11 = Q[2] - Q[6];
        const floats t12 = Q[3] - Q[1];
        const floats t13 = t11 * t11;
        const floats t14 = t6 + (t9 + t8 * t8) + t13;
        const floats t15 = t12 * t12;
        const floats t16 = t5 + t6 + t4 * t4 + t15;
        const truthsf t17 = lessf(t14, t16);
        const floats t18 = choosef(t17, t1, t7);
        const floats t19 = choosef(t17, t2, t8);
        const floats t20 = choosef(t17, t4, t2);
        const floats t21 = 1.0f + 2.0f * Q[0] - t3;
        const floats t22 = t10 * t10;
        const floats t23 = t5 + (t9 + t21 * t21) + t22;
        const truthsf t24 = lessf(t23, t16);
        const truthsf t25 = lessf(t23, t14);
        const floats t26 = choosef(t25, t18, choosef(t24, t18, t21));
        const floats t27 = choosef(t25, t19, choosef(t24, t19, t7));
        const floats t28 = choosef(t25, t20, choosef(t24, t20, t1));
        const floats t29 = 1.0f + t3;
        const floats t30 = t15 + (t13 + t22) + t29 * t29;
        const truthsf t31 = lessf(t30, t16);
        const truthsf t32 = lessf(t30, t14);
        const truthsf t33 = lessf(t30, t23);
        const floats t34 = choosef(t33, t26, choosef(t32, t26, choosef(t31, t26, t10)));
        const floats t35 = choosef(t33, t27, choosef(t32, t27, choosef(t31, t27, t11)));
        const floats t36 = choosef(t33, t28, choosef(t32, t28, choosef(t31, t28, t12)));
        const floats t37 = choosef(lessf(t34, spreadf(0.0f)), -t34, t34);
        const floats t38 = choosef(lessf(t35, spreadf(0.0f)), -t35, t35);
        const floats t39 = choosef(lessf(t37, t38), t38, t37);
        const floats t40 = choosef(lessf(t36, spreadf(0.0f)), -t36, t36);
        const floats t41 = choosef(lessf(t39, t40), t40, t39);
        const floats t42 = choosef(equalf(spreadf(0.0f), t41), spreadf(1.0f), t41);
        const floats t43 = t34 / t42;
        const floats t44 = t35 / t42;
        const floats t45 = t36 / t42;
        const floats t46 = t43 * t43 + t44 * t44 + t45 * t45;
        const floats t47 = rootsf(t46);
        const truthsf t48 = equalf(t46, spreadf(0.0f));
        const floats t49 = choosef(t48, spreadf(0.0f), t43) / t47;
        const floats t50 = choosef(t48, spreadf(0.0f), t44) / t47;
        const floats t51 = choosef(t48, spreadf(0.0f), t45) / t47;
        const floats t52 = choosef(t17, t12, t11);
        const floats t53 = choosef(t17, t16, t14);
        const floats t54 = choosef(t25, t52, choosef(t24, t52, t10));
        const floats t55 = choosef(t25, t53, choosef(t24, t53, t23));
        const floats t56 = choosef(t33, t55, choosef(t32, t55, choosef(t31, t55, t30)));
        const floats t57 = rootsf(t56);
        const truthsf t58 = equalf(t56, spreadf(0.0f));
        const floats t59 = choosef(t33, t54, choosef(t32, t54, choosef(t31, t54, t29)));
        const floats t60 = choosef(t58, spreadf(0.0f), t59) / t57;
        const floats t61 = choosef(lessf(t51, spreadf(0.0f)), spreadf(-1.0f), spreadf(1.0f));
        const floats t62 = choosef(lessf(spreadf(0.0f), t50), spreadf(1.0f), t61);
        const floats t63 = choosef(lessf(t50, spreadf(0.0f)), spreadf(-1.0f), t62);
        const floats t64 = choosef(lessf(spreadf(0.0f), t49), spreadf(1.0f), t63);
        const floats t65 = choosef(lessf(t49, spreadf(0.0f)), spreadf(-1.0f), t64);
        const floats t66 = choosef(lessf(spreadf(0.0f), t60), spreadf(1.0f), t65);
        const floats t67 = choosef(lessf(t60, spreadf(0.0f)), spreadf(-1.0f), t66);
        const floats t68 = choosef(equalf(spreadf(0.0f), t30 - t30), t67, spreadf(NAN));
        const floats e0 = t49 * t68;
        const floats e1 = t50 * t68;
        const floats e2 = t51 * t68;
        const floats t69 = directionsf(t42 * (choosef(t58, spreadf(0.0f), t47) / t57), t60 * t68);
        const floats phi_value = 2.0f * t69;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 3, sizeof(float), copied.ahead);
        const floats result1[] = {e0, e1, e2};
        if (dense1) {
            store_allf(item1, step1, 3, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
        } else {
            give_eachf(item1, entries1, step1, 3, result1);
        }
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 1, sizeof(float), copied.ahead);
        store_1f(item2, step2, phi_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_natural_invariants_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_natural_invariants_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rodrigues_parameters_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles Q[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &Q[0]);
            load_4(item0 + 4 * sizeof(double), step0, &Q[4]);
            load_1(item0 + 8 * sizeof(double), step0, &Q[8]);
        } else if (step0 == sizeof(double)) {
            Q[0] = PACKED_IN(item0 + entries0[0], 0);
            Q[1] = PACKED_IN(item0 + entries0[1], 0);
            Q[2] = PACKED_IN(item0 + entries0[2], 0);
            Q[3] = PACKED_IN(item0 + entries0[3], 0);
            Q[4] = PACKED_IN(item0 + entries0[4], 0);
            Q[5] = PACKED_IN(item0 + entries0[5], 0);
            Q[6] = PACKED_IN(item0 + entries0[6], 0);
            Q[7] = PACKED_IN(item0 + entries0[7], 0);
            Q[8] = PACKED_IN(item0 + entries0[8], 0);
        } else {
            doubles all[9];
            take_each(item0, entries0, step0, 9, all);
            Q[0] = all[0];
            Q[1] = all[1];
            Q[2] = all[2];
            Q[3] = all[3];
            Q[4] = all[4];
            Q[5] = all[5];
            Q[6] = all[6];
            Q[7] = all[7];
            Q[8] = all[8];
        }
        const doubles t1 = Q[2] + Q[6];
        const doubles t2 = Q[5] + Q[7];
        const doubles t3 = Q[8] + (Q[0] + Q[4]);
        const doubles t4 = 1.0 + 2.0 * Q[8] - t3;
        const doubles t5 = Q[7] - Q[5];
        const doubles t6 = Q[2] - Q[6];
        const doubles t7 = Q[3] - Q[1];
        const doubles t8 = t1 * t1;
        const doubles t9 = t2 * t2;
        const doubles t10 = t7 * t7;
        const doubles t11 = t8 + t9 + t4 * t4 + t10;
        const doubles t12 = Q[1] + Q[3];
        const doubles t13 = 1.0 + 2.0 * Q[4] - t3;
        const doubles t14 = t12 * t12;
        const doubles t15 = t6 * t6;
        const doubles t16 = t9 + (t14 + t13 * t13) + t15;
        const truths t17 = less(t16, t11);
        const doubles t18 = choose(t17, t1, t12);
        const doubles t19 = choose(t17, t11, t16);
        const doubles t20 = choose(t17, t2, t13);
        const doubles t21 = choose(t17, t4, t2);
        const doubles t22 = 1.0 + 2.0 * Q[0] - t3;
        const doubles t23 = t5 * t5;
        const doubles t24 = t8 + (t14 + t22 * t22) + t23;
        const truths t25 = less(t24, t11);
        const truths t26 = less(t24, t16);
        const doubles t27 = choose(t26, t18, choose(t25, t18, t22));
        const doubles t28 = choose(t26, t19, choose(t25, t19, t24));
        const doubles t29 = choose(t26, t20, choose(t25, t20, t12));
        const doubles t30 = choose(t26, t21, choose(t25, t21, t1));
        const doubles t31 = 1.0 + t3;
        const doubles t32 = t10 + (t15 + t23) + t31 * t31;
        const truths t33 = less(t32, t11);
        const truths t34 = less(t32, t16);
        const truths t35 = less(t32, t24);
        const doubles t36 = choose(t35, t28, choose(t34, t28, choose(t33, t28, t32)));
        const doubles t37 = roots(t36);
        const truths t38 = equal(t36, spread(0.0));
        const doubles t39 = choose(t35, t27, choose(t34, t27, choose(t33, t27, t5)));
        const doubles t40 = choose(t38, spread(0.0), t39) / t37;
        const doubles t41 = choose(t35, t29, choose(t34, t29, choose(t33, t29, t6)));
        const doubles t42 = choose(t38, spread(0.0), t41) / t37;
        const doubles t43 = choose(t35, t30, choose(t34, t30, choose(t33, t30, t7)));
        const doubles t44 = choose(t38, spread(0.0), t43) / t37;
        const doubles t45 = choose(t17, t7, t6);
        const doubles t46 = choose(t26, t45, choose(t25, t45, t5));
        const doubles t47 = choose(t35, t46, choose(t34, t46, choose(t33, t46, t31)));
        const doubles t48 = choose(t38, spread(0.0), t47) / t37;
        const doubles t49 = choose(less(t44, spread(0.0)), spread(-1.0), spread(1.0));
        const doubles t50 = choose(less(spread(0.0), t42), spread(1.0), t49);
        const doubles t51 = choose(less(t42, spread(0.0)), spread(-1.0), t50);
        const doubles t52 = choose(less(spread(0.0), t40), spread(1.0), t51);
        const doubles t53 = choose(less(t40, spread(0.0)), spread(-1.0), t52);
        const doubles t54 = choose(less(spread(0.0), t48), spread(1.0), t53);
        const doubles t55 = choose(less(t48, spread(0.0)), spread(-1.0), t54);
        const doubles t56 = choose(equal(spread(0.0), t32 - t32), t55, spread(NAN));
        const doubles q0 = t40 * t56;
        const doubles q1 = t42 * t56;
        const doubles q2 = t44 * t56;
        const doubles q_0_value = t48 * t56;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 3, sizeof(double), copied.ahead);
        const doubles result1[] = {q0, q1, q2};
        if (dense1) {
            store_all(item1, step1, 3, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
        } else {
            give_each(item1, entries1, step1, 3, result1);
        }
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 1, sizeof(double), copied.ahead);
        store_1(item2, step2, q_0_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_parameters_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rodrigues_parameters_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rodrigues_parameters_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step1, steps + 5, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats Q[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &Q[0]);
            load_4f(item0 + 4 * sizeof(float), step0, &Q[4]);
            load_1f(item0 + 8 * sizeof(float), step0, &Q[8]);
        } else if (step0 == sizeof(float)) {
            Q[0] = PACKEDF_IN(item0 + entries0[0], 0);
            Q[1] = PACKEDF_IN(item0 + entries0[1], 0);
            Q[2] = PACKEDF_IN(item0 + entries0[2], 0);
            Q[3] = PACKEDF_IN(item0 + entries0[3], 0);
            Q[4] = PACKEDF_IN(item0 + entries0[4], 0);
            Q[5] = PACKEDF_IN(item0 + entries0[5], 0);
            Q[6] = PACKEDF_IN(item0 + entries0[6], 0);
            Q[7] = PACKEDF_IN(item0 + entries0[7], 0);
            Q[8] = PACKEDF_IN(item0 + entries0[8], 0);
        } else {
            floats all[9];
            take_eachf(item0, entries0, step0, 9, all);
            Q[0] = all[0];
            Q[1] = all[1];
            Q[2] = all[2];
            Q[3] = all[3];
            Q[4] = all[4];
            Q[5] = all[5];
            Q[6] = all[6];
            Q[7] = all[7];
            Q[8] = all[8];
        }
        const floats t1 = Q[2] + Q[6];
        const floats t2 = Q[5] + Q[7];
        const floats t3 = Q[8] + (Q[0] + Q[4]);
        const floats t4 = 1.0f + 2.0f * Q[8] - t3;
        const floats t5 = Q[7] - Q[5];
        const floats t6 = Q[2] - Q[6];
        const floats t7 = Q[3] - Q[1];
        const floats t8 = t1 * t1;
        const floats t9 = t2 * t2;
        const floats t10 = t7 * t7;
        const floats t11 = t8 + t9 + t4 * t4 + t10;
        const floats t12 = Q[1] + Q[3];
        const floats t13 = 1.0f + 2.0f * Q[4] - t3;
        const floats t14 = t12 * t12;
        const floats t15 = t6 * t6;
        const floats t16 = t9 + (t14 + t13 * t13) + t15;
        const truthsf t17 = lessf(t16, t11);
        const floats t18 = choosef(t17, t1, t12);
        const floats t19 = choosef(t17, t11, t16);
        const floats t20 = choosef(t17, t2, t13);
        const floats t21 = choosef(t17, t4, t2);
        const floats t22 = 1.0f + 2.0f * Q[0] - t3;
        const floats t23 = t5 * t5;
        const floats t24 = t8 + (t14 + t22 * t22) + t23;
        const truthsf t25 = lessf(t24, t11);
        const truthsf t26 = lessf(t24, t16);
        const floats t27 = choosef(t26, t18, choosef(t25, t18, t22));
        const floats t28 = choosef(t26, t19, choosef(t25, t19, t24));
        const floats t29 = choosef(t26, t20, choosef(t25, t20, t12));
        const floats t30 = choosef(t26, t21, choosef(t25, t21, t1));
        const floats t31 = 1.0f + t3;
        const floats t32 = t10 + (t15 + t23) + t31 * t31;
        const truthsf t33 = lessf(t32, t11);
        const truthsf t34 = lessf(t32, t16);
        const truthsf t35 = lessf(t32, t24);
        const floats t36 = choosef(t35, t28, choosef(t34, t28, choosef(t33, t28, t32)));
        const floats t37 = rootsf(t36);
        const truthsf t38 = equalf(t36, spreadf(0.0f));
        const floats t39 = choosef(t35, t27, choosef(t34, t27, choosef(t33, t27, t5)));
        const floats t40 = choosef(t38, spreadf(0.0f), t39) / t37;
        const floats t41 = choosef(t35, t29, choosef(t34, t29, choosef(t33, t29, t6)));
        const floats t42 = choosef(t38, spreadf(0.0f), t41) / t37;
        const floats t43 = choosef(t35, t30, choosef(t34, t30, choosef(t33, t30, t7)));
        const floats t44 = choosef(t38, spreadf(0.0f), t43) / t37;
        const floats t45 = choosef(t17, t7, t6);
        const floats t46 = choosef(t26, t45, choosef(t25, t45, t5));
        const floats t47 = choosef(t35, t46, choosef(t34, t46, choosef(t33, t46, t31)));
        const floats t48 = choosef(t38, spreadf(0.0f), t47) / t37;
        const floats t49 = choosef(lessf(t44, spreadf(0.0f)), spreadf(-1.0f), spreadf(1.0f));
        const floats t50 = choosef(lessf(spreadf(0.0f), t42), spreadf(1.0f), t49);
        const floats t51 = choosef(lessf(t42, spreadf(0.0f)), spreadf(-1.0f), t50);
        const floats t52 = choosef(lessf(spreadf(0.0f), t40), spreadf(1.0f), t51);
        const floats t53 = choosef(lessf(t40, spreadf(0.0f)), spreadf(-1.0f), t52);
        const floats t54 = choosef(lessf(spreadf(0.0f), t48), spreadf(1.0f), t53);
        const floats t55 = choosef(lessf(t48, spreadf(0.0f)), spreadf(-1.0f), t54);
        const floats t56 = choosef(equalf(spreadf(0.0f), t32 - t32), t55, spreadf(NAN));
        const floats q0 = t40 * t56;
        const floats q1 = t42 * t56;
        const floats q2 = t44 * t56;
        const floats q_0_value = t48 * t56;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 3, sizeof(float), copied.ahead);
        const floats result1[] = {q0, q1, q2};
        if (dense1) {
            store_allf(item1, step1, 3, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
        } else {
            give_eachf(item1, entries1, step1, 3, result1);
        }
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 1, sizeof(float), copied.ahead);
        store_1f(item2, step2, q_0_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_parameters_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_euler_rodrigues_parameters_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_screw_of_motion_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step0, steps + 6, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step1, steps + 8, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 10, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step3, steps + 12, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 1 * sizeof(double));
    char *const at5 = at[5];
    const ptrdiff_t step5 = CHASLES_STEP(5, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles Q[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &Q[0]);
            load_4(item0 + 4 * sizeof(double), step0, &Q[4]);
            load_1(item0 + 8 * sizeof(double), step0, &Q[8]);
        } else if (step0 == sizeof(double)) {
            Q[0] = PACKED_IN(item0 + entries0[0], 0);
            Q[1] = PACKED_IN(item0 + entries0[1], 0);
            Q[2] = PACKED_IN(item0 + entries0[2], 0);
            Q[3] = PACKED_IN(item0 + entries0[3], 0);
            Q[4] = PACKED_IN(item0 + entries0[4], 0);
            Q[5] = PACKED_IN(item0 + entries0[5], 0);
            Q[6] = PACKED_IN(item0 + entries0[6], 0);
            Q[7] = PACKED_IN(item0 + entries0[7], 0);
            Q[8] = PACKED_IN(item0 + entries0[8], 0);
        } else {
            doubles all[9];
            take_each(item0, entries0, step0, 9, all);
            Q[0] = all[0];
            Q[1] = all[1];
            Q[2] = all[2];
            Q[3] = all[3];
            Q[4] = all[4];
            Q[5] = all[5];
            Q[6] = all[6];
            Q[7] = all[7];
            Q[8] = all[8];
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
        doubles a_prime[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &a_prime[0]);
        } else if (step2 == sizeof(double)) {
            a_prime[0] = PACKED_IN(item2 + entries2[0], 0);
            a_prime[1] = PACKED_IN(item2 + entries2[1], 0);
            a_prime[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            a_prime[0] = all[0];
            a_prime[1] = all[1];
            a_prime[2] = all[2];
        }
        const doubles t1 = Q[2] + Q[6];
        const doubles t2 = Q[5] + Q[7];
        const doubles t3 = Q[8] + (Q[0] + Q[4]);
        const doubles t4 = 1.0 + 2.0 * Q[8] - t3;
        const doubles t5 = t1 * t1;
        const doubles t6 = t2 * t2;
        const doubles t7 = Q[1] + Q[3];
        const doubles t8 = 1.0 + 2.0 * Q[4] - t3;
        const doubles t9 = t7 * t7;
        const doubles t10 = Q[7] - Q[5];
        const doubles t11 = Q[2] - Q[6];
        const doubles t12 = Q[3] - Q[1];
        const doubles t13 = t11 * t11;
        const doubles t14 = t6 + (t9 + t8 * t8) + t13;
        const doubles t15 = t12 * t12;
        const doubles t16 = t5 + t6 + t4 * t4 + t15;
        const truths t17 = less(t14, t16);
        const doubles t18 = choose(t17, t1, t7);
        const doubles t19 = choose(t17, t2, t8);
        const doubles t20 = choose(t17, t4, t2);
        const doubles t21 = 1.0 + 2.0 * Q[0] - t3;
        const doubles t22 = t10 * t10;
        const doubles t23 = t5 + (t9 + t21 * t21) + t22;
        const truths t24 = less(t23, t16);
        const truths t25 = less(t23, t14);
        const doubles t26 = choose(t25, t18, choose(t24, t18, t21));
        const doubles t27 = choose(t25, t19, choose(t24, t19, t7));
        const doubles t28 = choose(t25, t20, choose(t24, t20, t1));
        const doubles t29 = 1.0 + t3;
        const doubles t30 = t15 + (t13 + t22) + t29 * t29;
        const truths t31 = less(t30, t16);
        const truths t32 = less(t30, t14);
        const truths t33 = less(t30, t23);
        const doubles t34 = choose(t33, t26, choose(t32, t26, choose(t31, t26, t10)));
        const doubles t35 = choose(t33, t27, choose(t32, t27, choose(t31, t27, t11)));
        const doubles t36 = choose(t33, t28, choose(t32, t28, choose(t31, t28, t12)));
        const doubles t37 = choose(less(t34, spread(0.0)), -t34, t34);
        const doubles t38 = choose(less(t35, spread(0.0)), -t35, t35);
        const doubles t39 = choose(less(t37, t38), t38, t37);
        const doubles t40 = choose(less(t36, spread(0.0)), -t36, t36);
        const doubles t41 = choose(less(t39, t40), t40, t39);
        const doubles t42 = choose(equal(spread(0.0), t41), spread(1.0), t41);
        const doubles t43 = t34 / t42;
        const doubles t44 = t35 / t42;
        const doubles t45 = t36 / t42;
        const doubles t46 = t43 * t43 + t44 * t44 + t45 * t45;
        const doubles t47 = roots(t46);
        const truths t48 = equal(t46, spread(0.0));
        const doubles t49 = choose(t48, spread(0.0), t43) / t47;
        const doubles t50 = choose(t48, spread(0.0), t44) / t47;
        const doubles t51 = choose(t48, spread(0.0), t45) / t47;
        const doubles t52 = choose(t17, t12, t11);
        const doubles t53 = choose(t17, t16, t14);
        const doubles t54 = choose(t25, t52, choose(t24, t52, t10));
        const doubles t55 = choose(t25, t53, choose(t24, t53, t23));
        const doubles t56 = choose(t33, t55, choose(t32, t55, choose(t31, t55, t30)));
        const doubles t57 = roots(t56);
        const truths t58 = equal(t56, spread(0.0));
        const doubles t59 = choose(t33, t54, choose(t32, t54, choose(t31, t54, t29)));
        const doubles t60 = choose(t58, spread(0.0), t59) / t57;
        const doubles t61 = choose(t58, spread(0.0), t47) / t57;
        const doubles t62 = choose(less(t51, spread(0.0)), spread(-1.0), spread(1.0));
        const doubles t63 = choose(less(spread(0.0), t50), spread(1.0), t62);
        const doubles t64 = choose(less(t50, spread(0.0)), spread(-1.0), t63);
        const doubles t65 = choose(less(spread(0.0), t49), spread(1.0), t64);
        const doubles t66 = choose(less(t49, spread(0.0)), spread(-1.0), t65);
        const doubles t67 = choose(less(spread(0.0), t60), spread(1.0), t66);
        const doubles t68 = choose(less(t60, spread(0.0)), spread(-1.0), t67);
        const doubles t69 = choose(equal(spread(0.0), t30 - t30), t68, spread(NAN));
        const doubles axis0 = t49 * t69;
        const doubles axis1 = t50 * t69;
        const doubles axis2 = t51 * t69;
        const doubles t70 = a[0] + a_prime[0];
        const doubles t71 = a[1] + a_prime[1];
        const doubles t72 = a[2] + a_prime[2];
        const doubles t73 = a_prime[0] - a[0];
        const doubles t74 = a_prime[1] - a[1];
        const doubles t75 = a_prime[2] - a[2];
        const doubles t76 = axis1 * t75 - axis2 * t74;
        const doubles t77 = axis2 * t73 - axis0 * t75;
        const doubles t78 = axis0 * t74 - axis1 * t73;
        const doubles t79 = t60 * t69;
        const doubles t80 = choose(equal(t61, spread(0.0)), spread(0.0), t79) / t61;
        const doubles t81 = axis2 * t71 - axis1 * t72 + (axis2 * t77 - axis1 * t78) * t80 / t42;
        const doubles axis3 = 0.5 * t81;
        const doubles t82 = axis0 * t72 - axis2 * t70 + (axis0 * t78 - axis2 * t76) * t80 / t42;
        const doubles axis4 = 0.5 * t82;
        const doubles t83 = axis1 * t70 - axis0 * t71 + (axis1 * t76 - axis0 * t77) * t80 / t42;
        const doubles axis5 = 0.5 * t83;
        const doubles d_0_value = axis0 * t73 + axis1 * t74 + axis2 * t75;
        const doubles phi_value = 2.0 * directions(t42 * t61, t79);
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
        store_1(item4, step4, d_0_value);
        char *const item5 = at5 + g * LANES * step5;
        prefetch_to_write(item5, step5, 1, sizeof(double), copied.ahead);
        store_1(item5, step5, phi_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_screw_of_motion_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_screw_of_motion_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_screw_of_motion_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step0, steps + 6, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step1, steps + 8, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 10, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step3, steps + 12, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 1 * sizeof(float));
    char *const at5 = at[5];
    const ptrdiff_t step5 = CHASLES_STEP(5, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats Q[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &Q[0]);
            load_4f(item0 + 4 * sizeof(float), step0, &Q[4]);
            load_1f(item0 + 8 * sizeof(float), step0, &Q[8]);
        } else if (step0 == sizeof(float)) {
            Q[0] = PACKEDF_IN(item0 + entries0[0], 0);
            Q[1] = PACKEDF_IN(item0 + entries0[1], 0);
            Q[2] = PACKEDF_IN(item0 + entries0[2], 0);
            Q[3] = PACKEDF_IN(item0 + entries0[3], 0);
            Q[4] = PACKEDF_IN(item0 + entries0[4], 0);
            Q[5] = PACKEDF_IN(item0 + entries0[5], 0);
            Q[6] = PACKEDF_IN(item0 + entries0[6], 0);
            Q[7] = PACKEDF_IN(item0 + entries0[7], 0);
            Q[8] = PACKEDF_IN(item0 + entries0[8], 0);
        } else {
            floats all[9];
            take_eachf(item0, entries0, step0, 9, all);
            Q[0] = all[0];
            Q[1] = all[1];
            Q[2] = all[2];
            Q[3] = all[3];
            Q[4] = all[4];
            Q[5] = all[5];
            Q[6] = all[6];
            Q[7] = all[7];
            Q[8] = all[8];
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
        floats a_prime[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &a_prime[0]);
        } else if (step2 == sizeof(float)) {
            a_prime[0] = PACKEDF_IN(item2 + entries2[0], 0);
            a_prime[1] = PACKEDF_IN(item2 + entries2[1], 0);
            a_prime[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            a_prime[0] = all[0];
            a_prime[1] = all[1];
            a_prime[2] = all[2];
        }
        const floats t1 = Q[2] + Q[6];
        const floats t2 = Q[5] + Q[7];
        const floats t3 = Q[8] + (Q[0] + Q[4]);
        const floats t4 = 1.0f + 2.0f * Q[8] - t3;
        const floats t5 = t1 * t1;
        const floats t6 = t2 * t2;
        const floats t7 = Q[1] + Q[3];
        const floats t8 = 1.0f + 2.0f * Q[4] - t3;
        const floats t9 = t7 * t7;
        const floats t10 = Q[7] - Q[5];
        const floats t11 = Q[2] - Q[6];
        const floats t12 = Q[3] - Q[1];
        const floats t13 = t11 * t11;
        const floats t14 = t6 + (t9 + t8 * t8) + t13;
        const floats t15 = t12 * t12;
        const floats t16 = t5 + t6 + t4 * t4 + t15;
        const truthsf t17 = lessf(t14, t16);
        const floats t18 = choosef(t17, t1, t7);
        const floats t19 = choosef(t17, t2, t8);
        const floats t20 = choosef(t17, t4, t2);
        const floats t21 = 1.0f + 2.0f * Q[0] - t3;
        const floats t22 = t10 * t10;
        const floats t23 = t5 + (t9 + t21 * t21) + t22;
        const truthsf t24 = lessf(t23, t16);
        const truthsf t25 = lessf(t23, t14);
        const floats t26 = choosef(t25, t18, choosef(t24, t18, t21));
        const floats t27 = choosef(t25, t19, choosef(t24, t19, t7));
        const floats t28 = choosef(t25, t20, choosef(t24, t20, t1));
        const floats t29 = 1.0f + t3;
        const floats t30 = t15 + (t13 + t22) + t29 * t29;
        const truthsf t31 = lessf(t30, t16);
        const truthsf t32 = lessf(t30, t14);
        const truthsf t33 = lessf(t30, t23);
        const floats t34 = choosef(t33, t26, choosef(t32, t26, choosef(t31, t26, t10)));
        const floats t35 = choosef(t33, t27, choosef(t32, t27, choosef(t31, t27, t11)));
        const floats t36 = choosef(t33, t28, choosef(t32, t28, choosef(t31, t28, t12)));
        const floats t37 = choosef(lessf(t34, spreadf(0.0f)), -t34, t34);
        const floats t38 = choosef(lessf(t35, spreadf(0.0f)), -t35, t35);
        const floats t39 = choosef(lessf(t37, t38), t38, t37);
        const floats t40 = choosef(lessf(t36, spreadf(0.0f)), -t36, t36);
        const floats t41 = choosef(lessf(t39, t40), t40, t39);
        const floats t42 = choosef(equalf(spreadf(0.0f), t41), spreadf(1.0f), t41);
        const floats t43 = t34 / t42;
        const floats t44 = t35 / t42;
        const floats t45 = t36 / t42;
        const floats t46 = t43 * t43 + t44 * t44 + t45 * t45;
        const floats t47 = rootsf(t46);
        const truthsf t48 = equalf(t46, spreadf(0.0f));
        const floats t49 = choosef(t48, spreadf(0.0f), t43) / t47;
        const floats t50 = choosef(t48, spreadf(0.0f), t44) / t47;
        const floats t51 = choosef(t48, spreadf(0.0f), t45) / t47;
        const floats t52 = choosef(t17, t12, t11);
        const floats t53 = choosef(t17, t16, t14);
        const floats t54 = choosef(t25, t52, choosef(t24, t52, t10));
        const floats t55 = choosef(t25, t53, choosef(t24, t53, t23));
        const floats t56 = choosef(t33, t55, choosef(t32, t55, choosef(t31, t55, t30)));
        const floats t57 = rootsf(t56);
        const truthsf t58 = equalf(t56, spreadf(0.0f));
        const floats t59 = choosef(t33, t54, choosef(t32, t54, choosef(t31, t54, t29)));
        const floats t60 = choosef(t58, spreadf(0.0f), t59) / t57;
        const floats t61 = choosef(t58, spreadf(0.0f), t47) / t57;
        const floats t62 = choosef(lessf(t51, spreadf(0.0f)), spreadf(-1.0f), spreadf(1.0f));
        const floats t63 = choosef(lessf(spreadf(0.0f), t50), spreadf(1.0f), t62);
        const floats t64 = choosef(lessf(t50, spreadf(0.0f)), spreadf(-1.0f), t63);
        const floats t65 = choosef(lessf(spreadf(0.0f), t49), spreadf(1.0f), t64);
        const floats t66 = choosef(lessf(t49, spreadf(0.0f)), spreadf(-1.0f), t65);
        const floats t67 = choosef(lessf(spreadf(0.0f), t60), spreadf(1.0f), t66);
        const floats t68 = choosef(lessf(t60, spreadf(0.0f)), spreadf(-1.0f), t67);
        const floats t69 = choosef(equalf(spreadf(0.0f), t30 - t30), t68, spreadf(NAN));
        const floats axis0 = t49 * t69;
        const floats axis1 = t50 * t69;
        const floats axis2 = t51 * t69;
        const floats t70 = a[0] + a_prime[0];
        const floats t71 = a[1] + a_prime[1];
        const floats t72 = a[2] + a_prime[2];
        const floats t73 = a_prime[0] - a[0];
        const floats t74 = a_prime[1] - a[1];
        const floats t75 = a_prime[2] - a[2];
        const floats t76 = axis1 * t75 - axis2 * t74;
        const floats t77 = axis2 * t73 - axis0 * t75;
        const floats t78 = axis0 * t74 - axis1 * t73;
        const floats t79 = t60 * t69;
        const floats t80 = choosef(equalf(t61, spreadf(0.0f)), spreadf(0.0f), t79) / t61;
        const floats t81 = axis2 * t71 - axis1 * t72 + (axis2 * t77 - axis1 * t78) * t80 / t42;
        const floats axis3 = 0.5f * t81;
        const floats t82 = axis0 * t72 - axis2 * t70 + (axis0 * t78 - axis2 * t76) * t80 / t42;
        const floats axis4 = 0.5f * t82;
        const floats t83 = axis1 * t70 - axis0 * t71 + (axis1 * t76 - axis0 * t77) * t80 / t42;
        const floats axis5 = 0.5f * t83;
        const floats d_0_value = axis0 * t73 + axis1 * t74 + axis2 * t75;
        const floats phi_value = 2.0f * directionsf(t42 * t61, t79);
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
        store_1f(item4, step4, d_0_value);
        char *const item5 = at5 + g * LANESF * step5;
        prefetch_to_write(item5, step5, 1, sizeof(float), copied.ahead);
        store_1f(item5, step5, phi_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_screw_of_motion_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_screw_of_motion_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_instant_screw_block_items(
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
        const doubles t11 = roots(t10);
        const truths t12 = equal(t10, spread(0.0));
        const doubles axis0 = choose(t12, spread(0.0), t7) / t11;
        const doubles axis1 = choose(t12, spread(0.0), t8) / t11;
        const doubles axis2 = choose(t12, spread(0.0), t9) / t11;
        const doubles t13 = choose(t12, spread(0.0), a_dot[0]) / t11;
        const doubles t14 = choose(t12, spread(0.0), a_dot[1]) / t11;
        const doubles t15 = choose(t12, spread(0.0), a_dot[2]) / t11;
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

void CHASLES_LEVELED(chasles_instant_screw_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_instant_screw_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_instant_screw_blockf_items(
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
        const floats t11 = rootsf(t10);
        const truthsf t12 = equalf(t10, spreadf(0.0f));
        const floats axis0 = choosef(t12, spreadf(0.0f), t7) / t11;
        const floats axis1 = choosef(t12, spreadf(0.0f), t8) / t11;
        const floats axis2 = choosef(t12, spreadf(0.0f), t9) / t11;
        const floats t13 = choosef(t12, spreadf(0.0f), a_dot[0]) / t11;
        const floats t14 = choosef(t12, spreadf(0.0f), a_dot[1]) / t11;
        const floats t15 = choosef(t12, spreadf(0.0f), a_dot[2]) / t11;
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

void CHASLES_LEVELED(chasles_instant_screw_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_instant_screw_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_natural_velocity_matrix_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 12 * sizeof(double));
    ptrdiff_t entries2[12];
    const int dense2 = CHASLES_DENSE(find_entries(12, 4, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[1][GROUPS];
    doubles sines[1][GROUPS];
    doubles cosines[1][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &phi);
        angles[0][g] = phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles e[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &e[0]);
        } else if (step0 == sizeof(double)) {
            e[0] = PACKED_IN(item0 + entries0[0], 0);
            e[1] = PACKED_IN(item0 + entries0[1], 0);
            e[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        const doubles sin_phi = sines[0][g];
        const doubles cos_phi = cosines[0][g];
        const doubles N_tilde3 = e[0];
        const doubles N_tilde7 = e[1];
        const doubles N_tilde11 = e[2];
        const doubles N_tilde0 = sin_phi;
        const doubles t1 = 1.0 - cos_phi;
        const doubles N_tilde9 = N_tilde3 * t1;
        const doubles N_tilde2 = N_tilde7 * t1;
        const doubles N_tilde4 = N_tilde11 * t1;
        const doubles N_tilde1 = -N_tilde4;
        const doubles N_tilde6 = -N_tilde9;
        const doubles N_tilde8 = -N_tilde2;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 12, sizeof(double), copied.ahead);
        const doubles result2[] = {
            N_tilde0,
            N_tilde1,
            N_tilde2,
            N_tilde3,
            N_tilde4,
            N_tilde0,
            N_tilde6,
            N_tilde7,
            N_tilde8,
            N_tilde9,
            N_tilde0,
            N_tilde11};
        if (dense2) {
            store_all(item2, step2, 12, result2);
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
            PACKED(item2 + entries2[9], 0) = result2[9];
            PACKED(item2 + entries2[10], 0) = result2[10];
            PACKED(item2 + entries2[11], 0) = result2[11];
        } else {
            give_each(item2, entries2, step2, 12, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_natural_velocity_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 3)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 5)
        && is_packed(12, 4, sizeof(double), steps[2], steps + 7)) {
        chasles_natural_velocity_matrix_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_natural_velocity_matrix_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_natural_velocity_matrix_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 12 * sizeof(float));
    ptrdiff_t entries2[12];
    const int dense2 = CHASLES_DENSE(find_entries(12, 4, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[1][GROUPSF];
    floats sines[1][GROUPSF];
    floats cosines[1][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &phi);
        angles[0][g] = phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats e[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &e[0]);
        } else if (step0 == sizeof(float)) {
            e[0] = PACKEDF_IN(item0 + entries0[0], 0);
            e[1] = PACKEDF_IN(item0 + entries0[1], 0);
            e[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        const floats sin_phi = sines[0][g];
        const floats cos_phi = cosines[0][g];
        const floats N_tilde3 = e[0];
        const floats N_tilde7 = e[1];
        const floats N_tilde11 = e[2];
        const floats N_tilde0 = sin_phi;
        const floats t1 = 1.0f - cos_phi;
        const floats N_tilde9 = N_tilde3 * t1;
        const floats N_tilde2 = N_tilde7 * t1;
        const floats N_tilde4 = N_tilde11 * t1;
        const floats N_tilde1 = -N_tilde4;
        const floats N_tilde6 = -N_tilde9;
        const floats N_tilde8 = -N_tilde2;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 12, sizeof(float), copied.ahead);
        const floats result2[] = {
            N_tilde0,
            N_tilde1,
            N_tilde2,
            N_tilde3,
            N_tilde4,
            N_tilde0,
            N_tilde6,
            N_tilde7,
            N_tilde8,
            N_tilde9,
            N_tilde0,
            N_tilde11};
        if (dense2) {
            store_allf(item2, step2, 12, result2);
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
            PACKEDF(item2 + entries2[9], 0) = result2[9];
            PACKEDF(item2 + entries2[10], 0) = result2[10];
            PACKEDF(item2 + entries2[11], 0) = result2[11];
        } else {
            give_eachf(item2, entries2, step2, 12, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_natural_velocity_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 3)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 5)
        && is_packed(12, 4, sizeof(float), steps[2], steps + 7)) {
        chasles_natural_velocity_matrix_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_natural_velocity_matrix_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_linear_velocity_matrix_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 12 * sizeof(double));
    ptrdiff_t entries2[12];
    const int dense2 = CHASLES_DENSE(find_entries(12, 4, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[1][GROUPS];
    doubles sines[1][GROUPS];
    doubles cosines[1][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &phi);
        angles[0][g] = 0.5 * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles e[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &e[0]);
        } else if (step0 == sizeof(double)) {
            e[0] = PACKED_IN(item0 + entries0[0], 0);
            e[1] = PACKED_IN(item0 + entries0[1], 0);
            e[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles t1 = choose(equal(cos_half_phi, spread(0.0)), spread(0.0), sin_half_phi);
        const doubles t2 = t1 / cos_half_phi;
        const doubles L_tilde9 = e[0] * t2;
        const doubles L_tilde2 = e[1] * t2;
        const doubles L_tilde4 = e[2] * t2;
        const doubles L_tilde1 = -L_tilde4;
        const doubles L_tilde3 = -L_tilde9;
        const doubles L_tilde7 = -L_tilde2;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 12, sizeof(double), copied.ahead);
        const doubles result2[] = {
            spread(1.0),
            L_tilde1,
            L_tilde2,
            L_tilde3,
            L_tilde4,
            spread(1.0),
            L_tilde3,
            L_tilde7,
            L_tilde7,
            L_tilde9,
            spread(1.0),
            L_tilde1};
        if (dense2) {
            store_all(item2, step2, 12, result2);
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
            PACKED(item2 + entries2[9], 0) = result2[9];
            PACKED(item2 + entries2[10], 0) = result2[10];
            PACKED(item2 + entries2[11], 0) = result2[11];
        } else {
            give_each(item2, entries2, step2, 12, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_linear_velocity_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 3)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 5)
        && is_packed(12, 4, sizeof(double), steps[2], steps + 7)) {
        chasles_linear_velocity_matrix_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_linear_velocity_matrix_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_linear_velocity_matrix_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 12 * sizeof(float));
    ptrdiff_t entries2[12];
    const int dense2 = CHASLES_DENSE(find_entries(12, 4, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[1][GROUPSF];
    floats sines[1][GROUPSF];
    floats cosines[1][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &phi);
        angles[0][g] = 0.5f * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats e[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &e[0]);
        } else if (step0 == sizeof(float)) {
            e[0] = PACKEDF_IN(item0 + entries0[0], 0);
            e[1] = PACKEDF_IN(item0 + entries0[1], 0);
            e[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const truthsf t1 = equalf(cos_half_phi, spreadf(0.0f));
        const floats t2 = choosef(t1, spreadf(0.0f), sin_half_phi) / cos_half_phi;
        const floats L_tilde9 = e[0] * t2;
        const floats L_tilde2 = e[1] * t2;
        const floats L_tilde4 = e[2] * t2;
        const floats L_tilde1 = -L_tilde4;
        const floats L_tilde3 = -L_tilde9;
        const floats L_tilde7 = -L_tilde2;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 12, sizeof(float), copied.ahead);
        const floats result2[] = {
            spreadf(1.0f),
            L_tilde1,
            L_tilde2,
            L_tilde3,
            L_tilde4,
            spreadf(1.0f),
            L_tilde3,
            L_tilde7,
            L_tilde7,
            L_tilde9,
            spreadf(1.0f),
            L_tilde1};
        if (dense2) {
            store_allf(item2, step2, 12, result2);
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
            PACKEDF(item2 + entries2[9], 0) = result2[9];
            PACKEDF(item2 + entries2[10], 0) = result2[10];
            PACKEDF(item2 + entries2[11], 0) = result2[11];
        } else {
            give_eachf(item2, entries2, step2, 12, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_linear_velocity_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 3)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 5)
        && is_packed(12, 4, sizeof(float), steps[2], steps + 7)) {
        chasles_linear_velocity_matrix_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_linear_velocity_matrix_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rodrigues_velocity_matrix_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 12 * sizeof(double));
    ptrdiff_t entries2[12];
    const int dense2 = CHASLES_DENSE(find_entries(12, 4, sizeof(double), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    doubles angles[1][GROUPS];
    doubles sines[1][GROUPS];
    doubles cosines[1][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &phi);
        angles[0][g] = 0.5 * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles e[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &e[0]);
        } else if (step0 == sizeof(double)) {
            e[0] = PACKED_IN(item0 + entries0[0], 0);
            e[1] = PACKED_IN(item0 + entries0[1], 0);
            e[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles H_tilde0 = 2.0 * cos_half_phi;
        const doubles t1 = 2.0 * sin_half_phi;
        const doubles H_tilde9 = e[0] * t1;
        const doubles H_tilde2 = e[1] * t1;
        const doubles H_tilde4 = e[2] * t1;
        const doubles H_tilde1 = -H_tilde4;
        const doubles H_tilde3 = -H_tilde9;
        const doubles H_tilde7 = -H_tilde2;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 12, sizeof(double), copied.ahead);
        const doubles result2[] = {
            H_tilde0,
            H_tilde1,
            H_tilde2,
            H_tilde3,
            H_tilde4,
            H_tilde0,
            H_tilde3,
            H_tilde7,
            H_tilde7,
            H_tilde9,
            H_tilde0,
            H_tilde1};
        if (dense2) {
            store_all(item2, step2, 12, result2);
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
            PACKED(item2 + entries2[9], 0) = result2[9];
            PACKED(item2 + entries2[10], 0) = result2[10];
            PACKED(item2 + entries2[11], 0) = result2[11];
        } else {
            give_each(item2, entries2, step2, 12, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_velocity_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 3)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 5)
        && is_packed(12, 4, sizeof(double), steps[2], steps + 7)) {
        chasles_euler_rodrigues_velocity_matrix_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_euler_rodrigues_velocity_matrix_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rodrigues_velocity_matrix_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 3, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 12 * sizeof(float));
    ptrdiff_t entries2[12];
    const int dense2 = CHASLES_DENSE(find_entries(12, 4, sizeof(float), step2, steps + 7, entries2));
    chasles_stream copied = *stream;
    floats angles[1][GROUPSF];
    floats sines[1][GROUPSF];
    floats cosines[1][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &phi);
        angles[0][g] = 0.5f * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats e[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &e[0]);
        } else if (step0 == sizeof(float)) {
            e[0] = PACKEDF_IN(item0 + entries0[0], 0);
            e[1] = PACKEDF_IN(item0 + entries0[1], 0);
            e[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats H_tilde0 = 2.0f * cos_half_phi;
        const floats t1 = 2.0f * sin_half_phi;
        const floats H_tilde9 = e[0] * t1;
        const floats H_tilde2 = e[1] * t1;
        const floats H_tilde4 = e[2] * t1;
        const floats H_tilde1 = -H_tilde4;
        const floats H_tilde3 = -H_tilde9;
        const floats H_tilde7 = -H_tilde2;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 12, sizeof(float), copied.ahead);
        const floats result2[] = {
            H_tilde0,
            H_tilde1,
            H_tilde2,
            H_tilde3,
            H_tilde4,
            H_tilde0,
            H_tilde3,
            H_tilde7,
            H_tilde7,
            H_tilde9,
            H_tilde0,
            H_tilde1};
        if (dense2) {
            store_allf(item2, step2, 12, result2);
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
            PACKEDF(item2 + entries2[9], 0) = result2[9];
            PACKEDF(item2 + entries2[10], 0) = result2[10];
            PACKEDF(item2 + entries2[11], 0) = result2[11];
        } else {
            give_eachf(item2, entries2, step2, 12, result2);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_velocity_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 3)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 5)
        && is_packed(12, 4, sizeof(float), steps[2], steps + 7)) {
        chasles_euler_rodrigues_velocity_matrix_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_euler_rodrigues_velocity_matrix_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_pose_rate_natural_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 7 * sizeof(double));
    ptrdiff_t entries3[7];
    const int dense3 = CHASLES_DENSE(find_entries(7, 7, sizeof(double), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    doubles angles[1][GROUPS];
    doubles sines[1][GROUPS];
    doubles cosines[1][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &phi);
        angles[0][g] = 0.5 * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles e[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &e[0]);
        } else if (step0 == sizeof(double)) {
            e[0] = PACKED_IN(item0 + entries0[0], 0);
            e[1] = PACKED_IN(item0 + entries0[1], 0);
            e[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
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
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles s_dot4 = t[3];
        const doubles s_dot5 = t[4];
        const doubles s_dot6 = t[5];
        const doubles s_dot3 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
        const doubles t1 = choose(equal(sin_half_phi, spread(0.0)), spread(0.0), cos_half_phi);
        const doubles t2 = 0.5 * (t1 / sin_half_phi);
        const doubles s_dot0 = -(0.5 * (e[1] * t[2] - e[2] * t[1]) + (e[0] * s_dot3 - t[0]) * t2);
        const doubles s_dot1 = -(0.5 * (e[2] * t[0] - e[0] * t[2]) + (e[1] * s_dot3 - t[1]) * t2);
        const doubles s_dot2 = -(0.5 * (e[0] * t[1] - e[1] * t[0]) + (e[2] * s_dot3 - t[2]) * t2);
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 7, sizeof(double), copied.ahead);
        const doubles result3[] = {s_dot0, s_dot1, s_dot2, s_dot3, s_dot4, s_dot5, s_dot6};
        if (dense3) {
            store_all(item3, step3, 7, result3);
        } else if (step3 == sizeof(double)) {
            PACKED(item3 + entries3[0], 0) = result3[0];
            PACKED(item3 + entries3[1], 0) = result3[1];
            PACKED(item3 + entries3[2], 0) = result3[2];
            PACKED(item3 + entries3[3], 0) = result3[3];
            PACKED(item3 + entries3[4], 0) = result3[4];
            PACKED(item3 + entries3[5], 0) = result3[5];
            PACKED(item3 + entries3[6], 0) = result3[6];
        } else {
            give_each(item3, entries3, step3, 7, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pose_rate_natural_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_pose_rate_natural_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_pose_rate_natural_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 7 * sizeof(float));
    ptrdiff_t entries3[7];
    const int dense3 = CHASLES_DENSE(find_entries(7, 7, sizeof(float), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    floats angles[1][GROUPSF];
    floats sines[1][GROUPSF];
    floats cosines[1][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &phi);
        angles[0][g] = 0.5f * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats e[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &e[0]);
        } else if (step0 == sizeof(float)) {
            e[0] = PACKEDF_IN(item0 + entries0[0], 0);
            e[1] = PACKEDF_IN(item0 + entries0[1], 0);
            e[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
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
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats s_dot4 = t[3];
        const floats s_dot5 = t[4];
        const floats s_dot6 = t[5];
        const floats s_dot3 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
        const truthsf t1 = equalf(sin_half_phi, spreadf(0.0f));
        const floats t2 = 0.5f * (choosef(t1, spreadf(0.0f), cos_half_phi) / sin_half_phi);
        const floats s_dot0 = -(0.5f * (e[1] * t[2] - e[2] * t[1]) + (e[0] * s_dot3 - t[0]) * t2);
        const floats s_dot1 = -(0.5f * (e[2] * t[0] - e[0] * t[2]) + (e[1] * s_dot3 - t[1]) * t2);
        const floats s_dot2 = -(0.5f * (e[0] * t[1] - e[1] * t[0]) + (e[2] * s_dot3 - t[2]) * t2);
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 7, sizeof(float), copied.ahead);
        const floats result3[] = {s_dot0, s_dot1, s_dot2, s_dot3, s_dot4, s_dot5, s_dot6};
        if (dense3) {
            store_allf(item3, step3, 7, result3);
        } else if (step3 == sizeof(float)) {
            PACKEDF(item3 + entries3[0], 0) = result3[0];
            PACKEDF(item3 + entries3[1], 0) = result3[1];
            PACKEDF(item3 + entries3[2], 0) = result3[2];
            PACKEDF(item3 + entries3[3], 0) = result3[3];
            PACKEDF(item3 + entries3[4], 0) = result3[4];
            PACKEDF(item3 + entries3[5], 0) = result3[5];
            PACKEDF(item3 + entries3[6], 0) = result3[6];
        } else {
            give_eachf(item3, entries3, step3, 7, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pose_rate_natural_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_pose_rate_natural_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_pose_rate_linear_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 7 * sizeof(double));
    ptrdiff_t entries3[7];
    const int dense3 = CHASLES_DENSE(find_entries(7, 7, sizeof(double), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    doubles angles[1][GROUPS];
    doubles sines[1][GROUPS];
    doubles cosines[1][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &phi);
        angles[0][g] = phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles e[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &e[0]);
        } else if (step0 == sizeof(double)) {
            e[0] = PACKED_IN(item0 + entries0[0], 0);
            e[1] = PACKED_IN(item0 + entries0[1], 0);
            e[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
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
        const doubles sin_phi = sines[0][g];
        const doubles cos_phi = cosines[0][g];
        const doubles s_dot4 = t[3];
        const doubles s_dot5 = t[4];
        const doubles s_dot6 = t[5];
        const doubles half_cos_phi = 0.5 * cos_phi;
        const doubles t1 = 0.5 + half_cos_phi;
        const doubles t2 = (e[0] * t[0] + e[1] * t[1] + e[2] * t[2]) * (0.5 - half_cos_phi);
        const doubles half_sin_phi = 0.5 * sin_phi;
        const doubles s_dot0 = t[0] * t1 - e[0] * t2 - (e[1] * t[2] - e[2] * t[1]) * half_sin_phi;
        const doubles s_dot1 = t[1] * t1 - e[1] * t2 - (e[2] * t[0] - e[0] * t[2]) * half_sin_phi;
        const doubles s_dot2 = t[2] * t1 - e[2] * t2 - (e[0] * t[1] - e[1] * t[0]) * half_sin_phi;
        const doubles t3 = t[0] * (e[0] * sin_phi) + t[1] * (e[1] * sin_phi);
        const doubles s_dot3 = -(t3 + t[2] * (e[2] * sin_phi));
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 7, sizeof(double), copied.ahead);
        const doubles result3[] = {s_dot0, s_dot1, s_dot2, s_dot3, s_dot4, s_dot5, s_dot6};
        if (dense3) {
            store_all(item3, step3, 7, result3);
        } else if (step3 == sizeof(double)) {
            PACKED(item3 + entries3[0], 0) = result3[0];
            PACKED(item3 + entries3[1], 0) = result3[1];
            PACKED(item3 + entries3[2], 0) = result3[2];
            PACKED(item3 + entries3[3], 0) = result3[3];
            PACKED(item3 + entries3[4], 0) = result3[4];
            PACKED(item3 + entries3[5], 0) = result3[5];
            PACKED(item3 + entries3[6], 0) = result3[6];
        } else {
            give_each(item3, entries3, step3, 7, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pose_rate_linear_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_pose_rate_linear_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_pose_rate_linear_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 7 * sizeof(float));
    ptrdiff_t entries3[7];
    const int dense3 = CHASLES_DENSE(find_entries(7, 7, sizeof(float), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    floats angles[1][GROUPSF];
    floats sines[1][GROUPSF];
    floats cosines[1][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &phi);
        angles[0][g] = phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats e[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &e[0]);
        } else if (step0 == sizeof(float)) {
            e[0] = PACKEDF_IN(item0 + entries0[0], 0);
            e[1] = PACKEDF_IN(item0 + entries0[1], 0);
            e[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
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
        const floats sin_phi = sines[0][g];
        const floats cos_phi = cosines[0][g];
        const floats s_dot4 = t[3];
        const floats s_dot5 = t[4];
        const floats s_dot6 = t[5];
        const floats half_cos_phi = 0.5f * cos_phi;
        const floats t1 = 0.5f + half_cos_phi;
        const floats t2 = (e[0] * t[0] + e[1] * t[1] + e[2] * t[2]) * (0.5f - half_cos_phi);
        const floats half_sin_phi = 0.5f * sin_phi;
        const floats s_dot0 = t[0] * t1 - e[0] * t2 - (e[1] * t[2] - e[2] * t[1]) * half_sin_phi;
        const floats s_dot1 = t[1] * t1 - e[1] * t2 - (e[2] * t[0] - e[0] * t[2]) * half_sin_phi;
        const floats s_dot2 = t[2] * t1 - e[2] * t2 - (e[0] * t[1] - e[1] * t[0]) * half_sin_phi;
        const floats t3 = t[0] * (e[0] * sin_phi) + t[1] * (e[1] * sin_phi);
        const floats s_dot3 = -(t3 + t[2] * (e[2] * sin_phi));
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 7, sizeof(float), copied.ahead);
        const floats result3[] = {s_dot0, s_dot1, s_dot2, s_dot3, s_dot4, s_dot5, s_dot6};
        if (dense3) {
            store_allf(item3, step3, 7, result3);
        } else if (step3 == sizeof(float)) {
            PACKEDF(item3 + entries3[0], 0) = result3[0];
            PACKEDF(item3 + entries3[1], 0) = result3[1];
            PACKEDF(item3 + entries3[2], 0) = result3[2];
            PACKEDF(item3 + entries3[3], 0) = result3[3];
            PACKEDF(item3 + entries3[4], 0) = result3[4];
            PACKEDF(item3 + entries3[5], 0) = result3[5];
            PACKEDF(item3 + entries3[6], 0) = result3[6];
        } else {
            give_eachf(item3, entries3, step3, 7, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pose_rate_linear_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_pose_rate_linear_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_pose_rate_euler_rodrigues_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 7 * sizeof(double));
    ptrdiff_t entries3[7];
    const int dense3 = CHASLES_DENSE(find_entries(7, 7, sizeof(double), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    doubles angles[1][GROUPS];
    doubles sines[1][GROUPS];
    doubles cosines[1][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &phi);
        angles[0][g] = 0.5 * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles e[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &e[0]);
        } else if (step0 == sizeof(double)) {
            e[0] = PACKED_IN(item0 + entries0[0], 0);
            e[1] = PACKED_IN(item0 + entries0[1], 0);
            e[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
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
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles s_dot4 = t[3];
        const doubles s_dot5 = t[4];
        const doubles s_dot6 = t[5];
        const doubles half_cos_half_phi = 0.5 * cos_half_phi;
        const doubles half_sin_half_phi = 0.5 * sin_half_phi;
        const doubles t1 = e[0] * half_sin_half_phi;
        const doubles t2 = e[1] * half_sin_half_phi;
        const doubles t3 = e[2] * half_sin_half_phi;
        const doubles s_dot0 = t[0] * half_cos_half_phi + t[1] * t3 - t[2] * t2;
        const doubles s_dot1 = t[1] * half_cos_half_phi - t[0] * t3 + t[2] * t1;
        const doubles s_dot2 = t[0] * t2 - t[1] * t1 + t[2] * half_cos_half_phi;
        const doubles s_dot3 = -(t[0] * t1 + t[1] * t2 + t[2] * t3);
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 7, sizeof(double), copied.ahead);
        const doubles result3[] = {s_dot0, s_dot1, s_dot2, s_dot3, s_dot4, s_dot5, s_dot6};
        if (dense3) {
            store_all(item3, step3, 7, result3);
        } else if (step3 == sizeof(double)) {
            PACKED(item3 + entries3[0], 0) = result3[0];
            PACKED(item3 + entries3[1], 0) = result3[1];
            PACKED(item3 + entries3[2], 0) = result3[2];
            PACKED(item3 + entries3[3], 0) = result3[3];
            PACKED(item3 + entries3[4], 0) = result3[4];
            PACKED(item3 + entries3[5], 0) = result3[5];
            PACKED(item3 + entries3[6], 0) = result3[6];
        } else {
            give_each(item3, entries3, step3, 7, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pose_rate_euler_rodrigues_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 6)
        && is_packed(6, 6, sizeof(double), steps[2], steps + 8)
        && is_packed(7, 7, sizeof(double), steps[3], steps + 10)) {
        chasles_pose_rate_euler_rodrigues_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_pose_rate_euler_rodrigues_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_pose_rate_euler_rodrigues_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    ptrdiff_t entries2[6];
    const int dense2 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 7 * sizeof(float));
    ptrdiff_t entries3[7];
    const int dense3 = CHASLES_DENSE(find_entries(7, 7, sizeof(float), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    floats angles[1][GROUPSF];
    floats sines[1][GROUPSF];
    floats cosines[1][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &phi);
        angles[0][g] = 0.5f * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats e[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &e[0]);
        } else if (step0 == sizeof(float)) {
            e[0] = PACKEDF_IN(item0 + entries0[0], 0);
            e[1] = PACKEDF_IN(item0 + entries0[1], 0);
            e[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
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
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats s_dot4 = t[3];
        const floats s_dot5 = t[4];
        const floats s_dot6 = t[5];
        const floats half_cos_half_phi = 0.5f * cos_half_phi;
        const floats half_sin_half_phi = 0.5f * sin_half_phi;
        const floats t1 = e[0] * half_sin_half_phi;
        const floats t2 = e[1] * half_sin_half_phi;
        const floats t3 = e[2] * half_sin_half_phi;
        const floats s_dot0 = t[0] * half_cos_half_phi + t[1] * t3 - t[2] * t2;
        const floats s_dot1 = t[1] * half_cos_half_phi - t[0] * t3 + t[2] * t1;
        const floats s_dot2 = t[0] * t2 - t[1] * t1 + t[2] * half_cos_half_phi;
        const floats s_dot3 = -(t[0] * t1 + t[1] * t2 + t[2] * t3);
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 7, sizeof(float), copied.ahead);
        const floats result3[] = {s_dot0, s_dot1, s_dot2, s_dot3, s_dot4, s_dot5, s_dot6};
        if (dense3) {
            store_allf(item3, step3, 7, result3);
        } else if (step3 == sizeof(float)) {
            PACKEDF(item3 + entries3[0], 0) = result3[0];
            PACKEDF(item3 + entries3[1], 0) = result3[1];
            PACKEDF(item3 + entries3[2], 0) = result3[2];
            PACKEDF(item3 + entries3[3], 0) = result3[3];
            PACKEDF(item3 + entries3[4], 0) = result3[4];
            PACKEDF(item3 + entries3[5], 0) = result3[5];
            PACKEDF(item3 + entries3[6], 0) = result3[6];
        } else {
            give_eachf(item3, entries3, step3, 7, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pose_rate_euler_rodrigues_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 6)
        && is_packed(6, 6, sizeof(float), steps[2], steps + 8)
        && is_packed(7, 7, sizeof(float), steps[3], steps + 10)) {
        chasles_pose_rate_euler_rodrigues_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_pose_rate_euler_rodrigues_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_twist_from_pose_rate_natural_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 7 * sizeof(double));
    ptrdiff_t entries2[7];
    const int dense2 = CHASLES_DENSE(find_entries(7, 7, sizeof(double), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    doubles angles[1][GROUPS];
    doubles sines[1][GROUPS];
    doubles cosines[1][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &phi);
        angles[0][g] = phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles e[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &e[0]);
        } else if (step0 == sizeof(double)) {
            e[0] = PACKED_IN(item0 + entries0[0], 0);
            e[1] = PACKED_IN(item0 + entries0[1], 0);
            e[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        doubles s_dot[7];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 7, copied.ahead);
        if (dense2) {
            load_4(item2 + 0 * sizeof(double), step2, &s_dot[0]);
            load_3(item2 + 4 * sizeof(double), step2, &s_dot[4]);
        } else if (step2 == sizeof(double)) {
            s_dot[0] = PACKED_IN(item2 + entries2[0], 0);
            s_dot[1] = PACKED_IN(item2 + entries2[1], 0);
            s_dot[2] = PACKED_IN(item2 + entries2[2], 0);
            s_dot[3] = PACKED_IN(item2 + entries2[3], 0);
            s_dot[4] = PACKED_IN(item2 + entries2[4], 0);
            s_dot[5] = PACKED_IN(item2 + entries2[5], 0);
            s_dot[6] = PACKED_IN(item2 + entries2[6], 0);
        } else {
            doubles all[7];
            take_each(item2, entries2, step2, 7, all);
            s_dot[0] = all[0];
            s_dot[1] = all[1];
            s_dot[2] = all[2];
            s_dot[3] = all[3];
            s_dot[4] = all[4];
            s_dot[5] = all[5];
            s_dot[6] = all[6];
        }
        const doubles sin_phi = sines[0][g];
        const doubles cos_phi = cosines[0][g];
        const doubles t3 = s_dot[4];
        const doubles t4 = s_dot[5];
        const doubles t5 = s_dot[6];
        const doubles t6 = 1.0 - cos_phi;
        const doubles t7 = s_dot[0] * sin_phi + t6 * (e[1] * s_dot[2] - e[2] * s_dot[1]);
        const doubles t0 = t7 + e[0] * s_dot[3];
        const doubles t8 = s_dot[1] * sin_phi + t6 * (e[2] * s_dot[0] - e[0] * s_dot[2]);
        const doubles t1 = t8 + e[1] * s_dot[3];
        const doubles t9 = s_dot[2] * sin_phi + t6 * (e[0] * s_dot[1] - e[1] * s_dot[0]);
        const doubles t2 = t9 + e[2] * s_dot[3];
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 6, sizeof(double), copied.ahead);
        const doubles result3[] = {t0, t1, t2, t3, t4, t5};
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

void CHASLES_LEVELED(chasles_twist_from_pose_rate_natural_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 6)
        && is_packed(7, 7, sizeof(double), steps[2], steps + 8)
        && is_packed(6, 6, sizeof(double), steps[3], steps + 10)) {
        chasles_twist_from_pose_rate_natural_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_twist_from_pose_rate_natural_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_twist_from_pose_rate_natural_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 7 * sizeof(float));
    ptrdiff_t entries2[7];
    const int dense2 = CHASLES_DENSE(find_entries(7, 7, sizeof(float), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    floats angles[1][GROUPSF];
    floats sines[1][GROUPSF];
    floats cosines[1][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &phi);
        angles[0][g] = phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats e[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &e[0]);
        } else if (step0 == sizeof(float)) {
            e[0] = PACKEDF_IN(item0 + entries0[0], 0);
            e[1] = PACKEDF_IN(item0 + entries0[1], 0);
            e[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        floats s_dot[7];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 7, copied.ahead);
        if (dense2) {
            load_4f(item2 + 0 * sizeof(float), step2, &s_dot[0]);
            load_3f(item2 + 4 * sizeof(float), step2, &s_dot[4]);
        } else if (step2 == sizeof(float)) {
            s_dot[0] = PACKEDF_IN(item2 + entries2[0], 0);
            s_dot[1] = PACKEDF_IN(item2 + entries2[1], 0);
            s_dot[2] = PACKEDF_IN(item2 + entries2[2], 0);
            s_dot[3] = PACKEDF_IN(item2 + entries2[3], 0);
            s_dot[4] = PACKEDF_IN(item2 + entries2[4], 0);
            s_dot[5] = PACKEDF_IN(item2 + entries2[5], 0);
            s_dot[6] = PACKEDF_IN(item2 + entries2[6], 0);
        } else {
            floats all[7];
            take_eachf(item2, entries2, step2, 7, all);
            s_dot[0] = all[0];
            s_dot[1] = all[1];
            s_dot[2] = all[2];
            s_dot[3] = all[3];
            s_dot[4] = all[4];
            s_dot[5] = all[5];
            s_dot[6] = all[6];
        }
        const floats sin_phi = sines[0][g];
        const floats cos_phi = cosines[0][g];
        const floats t3 = s_dot[4];
        const floats t4 = s_dot[5];
        const floats t5 = s_dot[6];
        const floats t6 = 1.0f - cos_phi;
        const floats t7 = s_dot[0] * sin_phi + t6 * (e[1] * s_dot[2] - e[2] * s_dot[1]);
        const floats t0 = t7 + e[0] * s_dot[3];
        const floats t8 = s_dot[1] * sin_phi + t6 * (e[2] * s_dot[0] - e[0] * s_dot[2]);
        const floats t1 = t8 + e[1] * s_dot[3];
        const floats t9 = s_dot[2] * sin_phi + t6 * (e[0] * s_dot[1] - e[1] * s_dot[0]);
        const floats t2 = t9 + e[2] * s_dot[3];
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 6, sizeof(float), copied.ahead);
        const floats result3[] = {t0, t1, t2, t3, t4, t5};
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

void CHASLES_LEVELED(chasles_twist_from_pose_rate_natural_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 6)
        && is_packed(7, 7, sizeof(float), steps[2], steps + 8)
        && is_packed(6, 6, sizeof(float), steps[3], steps + 10)) {
        chasles_twist_from_pose_rate_natural_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_twist_from_pose_rate_natural_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_twist_from_pose_rate_linear_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 7 * sizeof(double));
    ptrdiff_t entries2[7];
    const int dense2 = CHASLES_DENSE(find_entries(7, 7, sizeof(double), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    doubles angles[1][GROUPS];
    doubles sines[1][GROUPS];
    doubles cosines[1][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &phi);
        angles[0][g] = 0.5 * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles e[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &e[0]);
        } else if (step0 == sizeof(double)) {
            e[0] = PACKED_IN(item0 + entries0[0], 0);
            e[1] = PACKED_IN(item0 + entries0[1], 0);
            e[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        doubles s_dot[7];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 7, copied.ahead);
        if (dense2) {
            load_4(item2 + 0 * sizeof(double), step2, &s_dot[0]);
            load_3(item2 + 4 * sizeof(double), step2, &s_dot[4]);
        } else if (step2 == sizeof(double)) {
            s_dot[0] = PACKED_IN(item2 + entries2[0], 0);
            s_dot[1] = PACKED_IN(item2 + entries2[1], 0);
            s_dot[2] = PACKED_IN(item2 + entries2[2], 0);
            s_dot[3] = PACKED_IN(item2 + entries2[3], 0);
            s_dot[4] = PACKED_IN(item2 + entries2[4], 0);
            s_dot[5] = PACKED_IN(item2 + entries2[5], 0);
            s_dot[6] = PACKED_IN(item2 + entries2[6], 0);
        } else {
            doubles all[7];
            take_each(item2, entries2, step2, 7, all);
            s_dot[0] = all[0];
            s_dot[1] = all[1];
            s_dot[2] = all[2];
            s_dot[3] = all[3];
            s_dot[4] = all[4];
            s_dot[5] = all[5];
            s_dot[6] = all[6];
        }
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles t3 = s_dot[4];
        const doubles t4 = s_dot[5];
        const doubles t5 = s_dot[6];
        const doubles t6 = choose(equal(cos_half_phi, spread(0.0)), spread(0.0), sin_half_phi);
        const doubles t7 = t6 / cos_half_phi;
        const doubles t8 = e[0] * t7;
        const doubles t9 = e[1] * t7;
        const doubles t10 = e[2] * t7;
        const doubles t0 = s_dot[0] - s_dot[1] * t10 + s_dot[2] * t9 - s_dot[3] * t8;
        const doubles t1 = s_dot[1] + s_dot[0] * t10 - s_dot[2] * t8 - s_dot[3] * t9;
        const doubles t2 = s_dot[2] + (s_dot[1] * t8 - s_dot[0] * t9) - s_dot[3] * t10;
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 6, sizeof(double), copied.ahead);
        const doubles result3[] = {t0, t1, t2, t3, t4, t5};
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

void CHASLES_LEVELED(chasles_twist_from_pose_rate_linear_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_twist_from_pose_rate_linear_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_twist_from_pose_rate_linear_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 7 * sizeof(float));
    ptrdiff_t entries2[7];
    const int dense2 = CHASLES_DENSE(find_entries(7, 7, sizeof(float), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    floats angles[1][GROUPSF];
    floats sines[1][GROUPSF];
    floats cosines[1][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &phi);
        angles[0][g] = 0.5f * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats e[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &e[0]);
        } else if (step0 == sizeof(float)) {
            e[0] = PACKEDF_IN(item0 + entries0[0], 0);
            e[1] = PACKEDF_IN(item0 + entries0[1], 0);
            e[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        floats s_dot[7];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 7, copied.ahead);
        if (dense2) {
            load_4f(item2 + 0 * sizeof(float), step2, &s_dot[0]);
            load_3f(item2 + 4 * sizeof(float), step2, &s_dot[4]);
        } else if (step2 == sizeof(float)) {
            s_dot[0] = PACKEDF_IN(item2 + entries2[0], 0);
            s_dot[1] = PACKEDF_IN(item2 + entries2[1], 0);
            s_dot[2] = PACKEDF_IN(item2 + entries2[2], 0);
            s_dot[3] = PACKEDF_IN(item2 + entries2[3], 0);
            s_dot[4] = PACKEDF_IN(item2 + entries2[4], 0);
            s_dot[5] = PACKEDF_IN(item2 + entries2[5], 0);
            s_dot[6] = PACKEDF_IN(item2 + entries2[6], 0);
        } else {
            floats all[7];
            take_eachf(item2, entries2, step2, 7, all);
            s_dot[0] = all[0];
            s_dot[1] = all[1];
            s_dot[2] = all[2];
            s_dot[3] = all[3];
            s_dot[4] = all[4];
            s_dot[5] = all[5];
            s_dot[6] = all[6];
        }
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats t3 = s_dot[4];
        const floats t4 = s_dot[5];
        const floats t5 = s_dot[6];
        const truthsf t6 = equalf(cos_half_phi, spreadf(0.0f));
        const floats t7 = choosef(t6, spreadf(0.0f), sin_half_phi) / cos_half_phi;
        const floats t8 = e[0] * t7;
        const floats t9 = e[1] * t7;
        const floats t10 = e[2] * t7;
        const floats t0 = s_dot[0] - s_dot[1] * t10 + s_dot[2] * t9 - s_dot[3] * t8;
        const floats t1 = s_dot[1] + s_dot[0] * t10 - s_dot[2] * t8 - s_dot[3] * t9;
        const floats t2 = s_dot[2] + (s_dot[1] * t8 - s_dot[0] * t9) - s_dot[3] * t10;
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 6, sizeof(float), copied.ahead);
        const floats result3[] = {t0, t1, t2, t3, t4, t5};
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

void CHASLES_LEVELED(chasles_twist_from_pose_rate_linear_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_twist_from_pose_rate_linear_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_twist_from_pose_rate_euler_rodrigues_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 7 * sizeof(double));
    ptrdiff_t entries2[7];
    const int dense2 = CHASLES_DENSE(find_entries(7, 7, sizeof(double), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    doubles angles[1][GROUPS];
    doubles sines[1][GROUPS];
    doubles cosines[1][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &phi);
        angles[0][g] = 0.5 * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles e[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &e[0]);
        } else if (step0 == sizeof(double)) {
            e[0] = PACKED_IN(item0 + entries0[0], 0);
            e[1] = PACKED_IN(item0 + entries0[1], 0);
            e[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        doubles s_dot[7];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 7, copied.ahead);
        if (dense2) {
            load_4(item2 + 0 * sizeof(double), step2, &s_dot[0]);
            load_3(item2 + 4 * sizeof(double), step2, &s_dot[4]);
        } else if (step2 == sizeof(double)) {
            s_dot[0] = PACKED_IN(item2 + entries2[0], 0);
            s_dot[1] = PACKED_IN(item2 + entries2[1], 0);
            s_dot[2] = PACKED_IN(item2 + entries2[2], 0);
            s_dot[3] = PACKED_IN(item2 + entries2[3], 0);
            s_dot[4] = PACKED_IN(item2 + entries2[4], 0);
            s_dot[5] = PACKED_IN(item2 + entries2[5], 0);
            s_dot[6] = PACKED_IN(item2 + entries2[6], 0);
        } else {
            doubles all[7];
            take_each(item2, entries2, step2, 7, all);
            s_dot[0] = all[0];
            s_dot[1] = all[1];
            s_dot[2] = all[2];
            s_dot[3] = all[3];
            s_dot[4] = all[4];
            s_dot[5] = all[5];
            s_dot[6] = all[6];
        }
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles t3 = s_dot[4];
        const doubles t4 = s_dot[5];
        const doubles t5 = s_dot[6];
        const doubles t6 = 2.0 * cos_half_phi;
        const doubles t7 = 2.0 * sin_half_phi;
        const doubles t8 = e[0] * t7;
        const doubles t9 = e[1] * t7;
        const doubles t10 = e[2] * t7;
        const doubles t0 = s_dot[0] * t6 - s_dot[1] * t10 + s_dot[2] * t9 - s_dot[3] * t8;
        const doubles t1 = s_dot[0] * t10 + s_dot[1] * t6 - s_dot[2] * t8 - s_dot[3] * t9;
        const doubles t2 = s_dot[1] * t8 - s_dot[0] * t9 + s_dot[2] * t6 - s_dot[3] * t10;
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 6, sizeof(double), copied.ahead);
        const doubles result3[] = {t0, t1, t2, t3, t4, t5};
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

void CHASLES_LEVELED(chasles_twist_from_pose_rate_euler_rodrigues_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_twist_from_pose_rate_euler_rodrigues_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_twist_from_pose_rate_euler_rodrigues_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 7 * sizeof(float));
    ptrdiff_t entries2[7];
    const int dense2 = CHASLES_DENSE(find_entries(7, 7, sizeof(float), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    ptrdiff_t entries3[6];
    const int dense3 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step3, steps + 10, entries3));
    chasles_stream copied = *stream;
    floats angles[1][GROUPSF];
    floats sines[1][GROUPSF];
    floats cosines[1][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &phi);
        angles[0][g] = 0.5f * phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats e[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &e[0]);
        } else if (step0 == sizeof(float)) {
            e[0] = PACKEDF_IN(item0 + entries0[0], 0);
            e[1] = PACKEDF_IN(item0 + entries0[1], 0);
            e[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            e[0] = all[0];
            e[1] = all[1];
            e[2] = all[2];
        }
        floats s_dot[7];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 7, copied.ahead);
        if (dense2) {
            load_4f(item2 + 0 * sizeof(float), step2, &s_dot[0]);
            load_3f(item2 + 4 * sizeof(float), step2, &s_dot[4]);
        } else if (step2 == sizeof(float)) {
            s_dot[0] = PACKEDF_IN(item2 + entries2[0], 0);
            s_dot[1] = PACKEDF_IN(item2 + entries2[1], 0);
            s_dot[2] = PACKEDF_IN(item2 + entries2[2], 0);
            s_dot[3] = PACKEDF_IN(item2 + entries2[3], 0);
            s_dot[4] = PACKEDF_IN(item2 + entries2[4], 0);
            s_dot[5] = PACKEDF_IN(item2 + entries2[5], 0);
            s_dot[6] = PACKEDF_IN(item2 + entries2[6], 0);
        } else {
            floats all[7];
            take_eachf(item2, entries2, step2, 7, all);
            s_dot[0] = all[0];
            s_dot[1] = all[1];
            s_dot[2] = all[2];
            s_dot[3] = all[3];
            s_dot[4] = all[4];
            s_dot[5] = all[5];
            s_dot[6] = all[6];
        }
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats t3 = s_dot[4];
        const floats t4 = s_dot[5];
        const floats t5 = s_dot[6];
        const floats t6 = 2.0f * cos_half_phi;
        const floats t7 = 2.0f * sin_half_phi;
        const floats t8 = e[0] * t7;
        const floats t9 = e[1] * t7;
        const floats t10 = e[2] * t7;
        const floats t0 = s_dot[0] * t6 - s_dot[1] * t10 + s_dot[2] * t9 - s_dot[3] * t8;
        const floats t1 = s_dot[0] * t10 + s_dot[1] * t6 - s_dot[2] * t8 - s_dot[3] * t9;
        const floats t2 = s_dot[1] * t8 - s_dot[0] * t9 + s_dot[2] * t6 - s_dot[3] * t10;
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 6, sizeof(float), copied.ahead);
        const floats result3[] = {t0, t1, t2, t3, t4, t5};
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

void CHASLES_LEVELED(chasles_twist_from_pose_rate_euler_rodrigues_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_twist_from_pose_rate_euler_rodrigues_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_twist_transfer_block_items(
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
        doubles t_A[6];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4(item0 + 0 * sizeof(double), step0, &t_A[0]);
            load_2(item0 + 4 * sizeof(double), step0, &t_A[4]);
        } else if (step0 == sizeof(double)) {
            t_A[0] = PACKED_IN(item0 + entries0[0], 0);
            t_A[1] = PACKED_IN(item0 + entries0[1], 0);
            t_A[2] = PACKED_IN(item0 + entries0[2], 0);
            t_A[3] = PACKED_IN(item0 + entries0[3], 0);
            t_A[4] = PACKED_IN(item0 + entries0[4], 0);
            t_A[5] = PACKED_IN(item0 + entries0[5], 0);
        } else {
            doubles all[6];
            take_each(item0, entries0, step0, 6, all);
            t_A[0] = all[0];
            t_A[1] = all[1];
            t_A[2] = all[2];
            t_A[3] = all[3];
            t_A[4] = all[4];
            t_A[5] = all[5];
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
        const doubles t_P0 = t_A[0];
        const doubles t_P1 = t_A[1];
        const doubles t_P2 = t_A[2];
        const doubles t1 = a[0] - p[0];
        const doubles t2 = a[1] - p[1];
        const doubles t3 = a[2] - p[2];
        const doubles t_P3 = t_A[3] + (t_P2 * t2 - t_P1 * t3);
        const doubles t_P4 = t_A[4] + (t_P0 * t3 - t_P2 * t1);
        const doubles t_P5 = t_A[5] + (t_P1 * t1 - t_P0 * t2);
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 6, sizeof(double), copied.ahead);
        const doubles result3[] = {t_P0, t_P1, t_P2, t_P3, t_P4, t_P5};
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

void CHASLES_LEVELED(chasles_twist_transfer_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(double), steps[0], steps + 4)
        && is_packed(3, 3, sizeof(double), steps[1], steps + 6)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 8)
        && is_packed(6, 6, sizeof(double), steps[3], steps + 10)) {
        chasles_twist_transfer_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_twist_transfer_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_twist_transfer_blockf_items(
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
        floats t_A[6];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 6, copied.ahead);
        if (dense0) {
            load_4f(item0 + 0 * sizeof(float), step0, &t_A[0]);
            load_2f(item0 + 4 * sizeof(float), step0, &t_A[4]);
        } else if (step0 == sizeof(float)) {
            t_A[0] = PACKEDF_IN(item0 + entries0[0], 0);
            t_A[1] = PACKEDF_IN(item0 + entries0[1], 0);
            t_A[2] = PACKEDF_IN(item0 + entries0[2], 0);
            t_A[3] = PACKEDF_IN(item0 + entries0[3], 0);
            t_A[4] = PACKEDF_IN(item0 + entries0[4], 0);
            t_A[5] = PACKEDF_IN(item0 + entries0[5], 0);
        } else {
            floats all[6];
            take_eachf(item0, entries0, step0, 6, all);
            t_A[0] = all[0];
            t_A[1] = all[1];
            t_A[2] = all[2];
            t_A[3] = all[3];
            t_A[4] = all[4];
            t_A[5] = all[5];
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
        const floats t_P0 = t_A[0];
        const floats t_P1 = t_A[1];
        const floats t_P2 = t_A[2];
        const floats t1 = a[0] - p[0];
        const floats t2 = a[1] - p[1];
        const floats t3 = a[2] - p[2];
        const floats t_P3 = t_A[3] + (t_P2 * t2 - t_P1 * t3);
        const floats t_P4 = t_A[4] + (t_P0 * t3 - t_P2 * t1);
        const floats t_P5 = t_A[5] + (t_P1 * t1 - t_P0 * t2);
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 6, sizeof(float), copied.ahead);
        const floats result3[] = {t_P0, t_P1, t_P2, t_P3, t_P4, t_P5};
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

void CHASLES_LEVELED(chasles_twist_transfer_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(6, 6, sizeof(float), steps[0], steps + 4)
        && is_packed(3, 3, sizeof(float), steps[1], steps + 6)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 8)
        && is_packed(6, 6, sizeof(float), steps[3], steps + 10)) {
        chasles_twist_transfer_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_twist_transfer_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

#else

void CHASLES_LEVELED(chasles_natural_rate_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_natural_rate_matrix(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_natural_rate_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_natural_rate_matrixf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_linear_rate_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_linear_rate_matrix(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_linear_rate_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_linear_rate_matrixf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_rate_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rodrigues_rate_matrix(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_rate_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rodrigues_rate_matrixf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_linear_invariants_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_linear_invariants(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_linear_invariants_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_linear_invariantsf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_rodrigues_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_rodrigues(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_euler_rodrigues_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_euler_rodriguesf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_linear_invariants_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_linear_invariants(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_linear_invariants_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_linear_invariantsf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_natural_invariants_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_natural_invariants(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_natural_invariants_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_natural_invariantsf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_parameters_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rodrigues_parameters(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_parameters_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rodrigues_parametersf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_screw_of_motion_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_screw_of_motion(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]),
            (double *)(at[5] + i * steps[5]));
    }
}

void CHASLES_LEVELED(chasles_screw_of_motion_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_screw_of_motionf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]),
            (float *)(at[5] + i * steps[5]));
    }
}

void CHASLES_LEVELED(chasles_instant_screw_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_instant_screw(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_instant_screw_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_instant_screwf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_natural_velocity_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_natural_velocity_matrix(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_natural_velocity_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_natural_velocity_matrixf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_linear_velocity_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_linear_velocity_matrix(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_linear_velocity_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_linear_velocity_matrixf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_velocity_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rodrigues_velocity_matrix(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_velocity_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rodrigues_velocity_matrixf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_pose_rate_natural_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_pose_rate_natural(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_pose_rate_natural_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_pose_rate_naturalf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_pose_rate_linear_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_pose_rate_linear(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_pose_rate_linear_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_pose_rate_linearf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_pose_rate_euler_rodrigues_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_pose_rate_euler_rodrigues(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_pose_rate_euler_rodrigues_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_pose_rate_euler_rodriguesf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_twist_from_pose_rate_natural_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_twist_from_pose_rate_natural(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_twist_from_pose_rate_natural_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_twist_from_pose_rate_naturalf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_twist_from_pose_rate_linear_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_twist_from_pose_rate_linear(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_twist_from_pose_rate_linear_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_twist_from_pose_rate_linearf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_twist_from_pose_rate_euler_rodrigues_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_twist_from_pose_rate_euler_rodrigues(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_twist_from_pose_rate_euler_rodrigues_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_twist_from_pose_rate_euler_rodriguesf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_twist_transfer_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_twist_transfer(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_twist_transfer_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_twist_transferf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

#endif
