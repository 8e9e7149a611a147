/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_2, for batches. Made by `chasles emit`; not to be edited by hand.
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

CHASLES_INLINE void chasles_cross_product_matrix_block_items(
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
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles v[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &v[0]);
        } else if (step0 == sizeof(double)) {
            v[0] = PACKED_IN(item0 + entries0[0], 0);
            v[1] = PACKED_IN(item0 + entries0[1], 0);
            v[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            v[0] = all[0];
            v[1] = all[1];
            v[2] = all[2];
        }
        const doubles V7 = v[0];
        const doubles V2 = v[1];
        const doubles V3 = v[2];
        const doubles V1 = -V3;
        const doubles V5 = -V7;
        const doubles V6 = -V2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 9, sizeof(double), copied.ahead);
        const doubles result1[] = {spread(0.0), V1, V2, V3, spread(0.0), V5, V6, V7, spread(0.0)};
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

void CHASLES_LEVELED(chasles_cross_product_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 2)
        && is_packed(9, 3, sizeof(double), steps[1], steps + 4)) {
        chasles_cross_product_matrix_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_cross_product_matrix_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_cross_product_matrix_blockf_items(
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
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats v[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &v[0]);
        } else if (step0 == sizeof(float)) {
            v[0] = PACKEDF_IN(item0 + entries0[0], 0);
            v[1] = PACKEDF_IN(item0 + entries0[1], 0);
            v[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            v[0] = all[0];
            v[1] = all[1];
            v[2] = all[2];
        }
        const floats V7 = v[0];
        const floats V2 = v[1];
        const floats V3 = v[2];
        const floats V1 = -V3;
        const floats V5 = -V7;
        const floats V6 = -V2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 9, sizeof(float), copied.ahead);
        const floats result1[] = {spreadf(0.0f), V1, V2, V3, spreadf(0.0f), V5, V6, V7, spreadf(0.0f)};
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

void CHASLES_LEVELED(chasles_cross_product_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 2)
        && is_packed(9, 3, sizeof(float), steps[1], steps + 4)) {
        chasles_cross_product_matrix_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_cross_product_matrix_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_axis_angle_block_items(
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
        const doubles t1 = 1.0 - cos_phi;
        const doubles t2 = e[0] * t1;
        const doubles t3 = e[1] * t1;
        const doubles t4 = e[1] * t2;
        const doubles t5 = e[2] * t2;
        const doubles t6 = e[2] * t3;
        const doubles Q0 = cos_phi + e[0] * t2;
        const doubles Q4 = cos_phi + e[1] * t3;
        const doubles Q8 = cos_phi + e[2] * (e[2] * t1);
        const doubles t7 = e[0] * sin_phi;
        const doubles t8 = e[1] * sin_phi;
        const doubles t9 = e[2] * sin_phi;
        const doubles Q1 = t4 - t9;
        const doubles Q2 = t5 + t8;
        const doubles Q3 = t4 + t9;
        const doubles Q5 = t6 - t7;
        const doubles Q6 = t5 - t8;
        const doubles Q7 = t6 + t7;
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

void CHASLES_LEVELED(chasles_rotation_from_axis_angle_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_axis_angle_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_rotation_from_axis_angle_blockf_items(
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
        const floats t1 = 1.0f - cos_phi;
        const floats t2 = e[0] * t1;
        const floats t3 = e[1] * t1;
        const floats t4 = e[1] * t2;
        const floats t5 = e[2] * t2;
        const floats t6 = e[2] * t3;
        const floats Q0 = cos_phi + e[0] * t2;
        const floats Q4 = cos_phi + e[1] * t3;
        const floats Q8 = cos_phi + e[2] * (e[2] * t1);
        const floats t7 = e[0] * sin_phi;
        const floats t8 = e[1] * sin_phi;
        const floats t9 = e[2] * sin_phi;
        const floats Q1 = t4 - t9;
        const floats Q2 = t5 + t8;
        const floats Q3 = t4 + t9;
        const floats Q5 = t6 - t7;
        const floats Q6 = t5 - t8;
        const floats Q7 = t6 + t7;
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

void CHASLES_LEVELED(chasles_rotation_from_axis_angle_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_rotation_from_axis_angle_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_point_after_displacement_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step1, steps + 7, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(double));
    ptrdiff_t entries4[3];
    const int dense4 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step4, steps + 13, entries4));
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
        doubles p[3];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3(item3 + 0 * sizeof(double), step3, &p[0]);
        } else if (step3 == sizeof(double)) {
            p[0] = PACKED_IN(item3 + entries3[0], 0);
            p[1] = PACKED_IN(item3 + entries3[1], 0);
            p[2] = PACKED_IN(item3 + entries3[2], 0);
        } else {
            doubles all[3];
            take_each(item3, entries3, step3, 3, all);
            p[0] = all[0];
            p[1] = all[1];
            p[2] = all[2];
        }
        const doubles t1 = p[0] - a[0];
        const doubles t2 = p[1] - a[1];
        const doubles t3 = p[2] - a[2];
        const doubles p_prime0 = a_prime[0] + (Q[0] * t1 + Q[1] * t2 + Q[2] * t3);
        const doubles p_prime1 = a_prime[1] + (Q[3] * t1 + Q[4] * t2 + Q[5] * t3);
        const doubles p_prime2 = a_prime[2] + (Q[6] * t1 + Q[7] * t2 + Q[8] * t3);
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 3, sizeof(double), copied.ahead);
        const doubles result4[] = {p_prime0, p_prime1, p_prime2};
        if (dense4) {
            store_all(item4, step4, 3, result4);
        } else if (step4 == sizeof(double)) {
            PACKED(item4 + entries4[0], 0) = result4[0];
            PACKED(item4 + entries4[1], 0) = result4[1];
            PACKED(item4 + entries4[2], 0) = result4[2];
        } else {
            give_each(item4, entries4, step4, 3, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_point_after_displacement_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(double), steps[0], steps + 5)
        && is_packed(3, 3, sizeof(double), steps[1], steps + 7)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 9)
        && is_packed(3, 3, sizeof(double), steps[3], steps + 11)
        && is_packed(3, 3, sizeof(double), steps[4], steps + 13)) {
        chasles_point_after_displacement_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_point_after_displacement_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_point_after_displacement_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step1, steps + 7, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(float));
    ptrdiff_t entries4[3];
    const int dense4 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step4, steps + 13, entries4));
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
        floats p[3];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3f(item3 + 0 * sizeof(float), step3, &p[0]);
        } else if (step3 == sizeof(float)) {
            p[0] = PACKEDF_IN(item3 + entries3[0], 0);
            p[1] = PACKEDF_IN(item3 + entries3[1], 0);
            p[2] = PACKEDF_IN(item3 + entries3[2], 0);
        } else {
            floats all[3];
            take_eachf(item3, entries3, step3, 3, all);
            p[0] = all[0];
            p[1] = all[1];
            p[2] = all[2];
        }
        const floats t1 = p[0] - a[0];
        const floats t2 = p[1] - a[1];
        const floats t3 = p[2] - a[2];
        const floats p_prime0 = a_prime[0] + (Q[0] * t1 + Q[1] * t2 + Q[2] * t3);
        const floats p_prime1 = a_prime[1] + (Q[3] * t1 + Q[4] * t2 + Q[5] * t3);
        const floats p_prime2 = a_prime[2] + (Q[6] * t1 + Q[7] * t2 + Q[8] * t3);
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 3, sizeof(float), copied.ahead);
        const floats result4[] = {p_prime0, p_prime1, p_prime2};
        if (dense4) {
            store_allf(item4, step4, 3, result4);
        } else if (step4 == sizeof(float)) {
            PACKEDF(item4 + entries4[0], 0) = result4[0];
            PACKEDF(item4 + entries4[1], 0) = result4[1];
            PACKEDF(item4 + entries4[2], 0) = result4[2];
        } else {
            give_eachf(item4, entries4, step4, 3, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_point_after_displacement_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(float), steps[0], steps + 5)
        && is_packed(3, 3, sizeof(float), steps[1], steps + 7)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 9)
        && is_packed(3, 3, sizeof(float), steps[3], steps + 11)
        && is_packed(3, 3, sizeof(float), steps[4], steps + 13)) {
        chasles_point_after_displacement_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_point_after_displacement_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_pitch_of_motion_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 1 * sizeof(double));
    chasles_stream copied = *stream;
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
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1, copied.ahead);
        load_1(item1, step1, &phi);
        doubles d_P[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &d_P[0]);
        } else if (step2 == sizeof(double)) {
            d_P[0] = PACKED_IN(item2 + entries2[0], 0);
            d_P[1] = PACKED_IN(item2 + entries2[1], 0);
            d_P[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            d_P[0] = all[0];
            d_P[1] = all[1];
            d_P[2] = all[2];
        }
        const doubles t1 = e[0] * d_P[0] + e[1] * d_P[1] + e[2] * d_P[2];
        const doubles result_value = choose(equal(phi, spread(0.0)), spread(0.0), t1) / phi;
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 1, sizeof(double), copied.ahead);
        store_1(item3, step3, result_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pitch_of_motion_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 6)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 8)
        && is_packed(1, 1, sizeof(double), steps[3], steps + 10)) {
        chasles_pitch_of_motion_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_pitch_of_motion_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_pitch_of_motion_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 4, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 8, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 1 * sizeof(float));
    chasles_stream copied = *stream;
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
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1, copied.ahead);
        load_1f(item1, step1, &phi);
        floats d_P[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &d_P[0]);
        } else if (step2 == sizeof(float)) {
            d_P[0] = PACKEDF_IN(item2 + entries2[0], 0);
            d_P[1] = PACKEDF_IN(item2 + entries2[1], 0);
            d_P[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            d_P[0] = all[0];
            d_P[1] = all[1];
            d_P[2] = all[2];
        }
        const floats t1 = e[0] * d_P[0] + e[1] * d_P[1] + e[2] * d_P[2];
        const floats result_value = choosef(equalf(phi, spreadf(0.0f)), spreadf(0.0f), t1) / phi;
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 1, sizeof(float), copied.ahead);
        store_1f(item3, step3, result_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pitch_of_motion_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 6)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 8)
        && is_packed(1, 1, sizeof(float), steps[3], steps + 10)) {
        chasles_pitch_of_motion_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_pitch_of_motion_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

#else

void CHASLES_LEVELED(chasles_cross_product_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_cross_product_matrix(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_cross_product_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_cross_product_matrixf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_axis_angle_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_axis_angle(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_axis_angle_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_rotation_from_axis_anglef(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_point_after_displacement_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_point_after_displacement(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_point_after_displacement_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_point_after_displacementf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_pitch_of_motion_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_pitch_of_motion(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_pitch_of_motion_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_pitch_of_motionf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

#endif
