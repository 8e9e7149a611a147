/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_2_1, for batches. Made by `chasles emit`; not to be edited by hand.
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

CHASLES_INLINE void chasles_normal_matrix_inverse_block_items(
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
        const doubles t1 = choose(equal(sin_half_phi, spread(0.0)), spread(0.0), spread(0.5));
        const doubles t2 = t1 / sin_half_phi;
        const doubles t3 = t2 * t2;
        const doubles t4 = 1.0 - t3;
        const doubles t5 = e[0] * t4;
        const doubles t6 = e[1] * t4;
        const doubles result1_ = e[1] * t5;
        const doubles result2_ = e[2] * t5;
        const doubles result5_ = e[2] * t6;
        const doubles result0_ = t3 + e[0] * t5;
        const doubles result4_ = t3 + e[1] * t6;
        const doubles result8_ = t3 + e[2] * (e[2] * t4);
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 9, sizeof(double), copied.ahead);
        const doubles result2[] = {
            result0_,
            result1_,
            result2_,
            result1_,
            result4_,
            result5_,
            result2_,
            result5_,
            result8_};
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

void CHASLES_LEVELED(chasles_normal_matrix_inverse_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_normal_matrix_inverse_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_normal_matrix_inverse_blockf_items(
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
        const truthsf t1 = equalf(sin_half_phi, spreadf(0.0f));
        const floats t2 = choosef(t1, spreadf(0.0f), spreadf(0.5f)) / sin_half_phi;
        const floats t3 = t2 * t2;
        const floats t4 = 1.0f - t3;
        const floats t5 = e[0] * t4;
        const floats t6 = e[1] * t4;
        const floats result1_ = e[1] * t5;
        const floats result2_ = e[2] * t5;
        const floats result5_ = e[2] * t6;
        const floats result0_ = t3 + e[0] * t5;
        const floats result4_ = t3 + e[1] * t6;
        const floats result8_ = t3 + e[2] * (e[2] * t4);
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 9, sizeof(float), copied.ahead);
        const floats result2[] = {
            result0_,
            result1_,
            result2_,
            result1_,
            result4_,
            result5_,
            result2_,
            result5_,
            result8_};
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

void CHASLES_LEVELED(chasles_normal_matrix_inverse_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_normal_matrix_inverse_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_screw_axis_point_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 5, entries0));
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
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(double));
    ptrdiff_t entries4[3];
    const int dense4 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step4, steps + 13, entries4));
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
        doubles a_prime[3];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3(item3 + 0 * sizeof(double), step3, &a_prime[0]);
        } else if (step3 == sizeof(double)) {
            a_prime[0] = PACKED_IN(item3 + entries3[0], 0);
            a_prime[1] = PACKED_IN(item3 + entries3[1], 0);
            a_prime[2] = PACKED_IN(item3 + entries3[2], 0);
        } else {
            doubles all[3];
            take_each(item3, entries3, step3, 3, all);
            a_prime[0] = all[0];
            a_prime[1] = all[1];
            a_prime[2] = all[2];
        }
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles t1 = a[0] + a_prime[0];
        const doubles t2 = a[1] + a_prime[1];
        const doubles t3 = a[2] + a_prime[2];
        const doubles t4 = e[0] * t1 + e[1] * t2 + e[2] * t3;
        const doubles t5 = a_prime[0] - a[0];
        const doubles t6 = a_prime[1] - a[1];
        const doubles t7 = a_prime[2] - a[2];
        const doubles t8 = choose(equal(sin_half_phi, spread(0.0)), spread(0.0), cos_half_phi);
        const doubles t9 = t8 / sin_half_phi;
        const doubles p_0_0 = 0.5 * ((e[1] * t7 - e[2] * t6) * t9 - (e[0] * t4 - t1));
        const doubles p_0_1 = 0.5 * ((e[2] * t5 - e[0] * t7) * t9 - (e[1] * t4 - t2));
        const doubles p_0_2 = 0.5 * ((e[0] * t6 - e[1] * t5) * t9 - (e[2] * t4 - t3));
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 3, sizeof(double), copied.ahead);
        const doubles result4[] = {p_0_0, p_0_1, p_0_2};
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

void CHASLES_LEVELED(chasles_screw_axis_point_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_screw_axis_point_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_screw_axis_point_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 5, entries0));
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
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(float));
    ptrdiff_t entries4[3];
    const int dense4 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step4, steps + 13, entries4));
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
        floats a_prime[3];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3f(item3 + 0 * sizeof(float), step3, &a_prime[0]);
        } else if (step3 == sizeof(float)) {
            a_prime[0] = PACKEDF_IN(item3 + entries3[0], 0);
            a_prime[1] = PACKEDF_IN(item3 + entries3[1], 0);
            a_prime[2] = PACKEDF_IN(item3 + entries3[2], 0);
        } else {
            floats all[3];
            take_eachf(item3, entries3, step3, 3, all);
            a_prime[0] = all[0];
            a_prime[1] = all[1];
            a_prime[2] = all[2];
        }
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats t1 = a[0] + a_prime[0];
        const floats t2 = a[1] + a_prime[1];
        const floats t3 = a[2] + a_prime[2];
        const floats t4 = e[0] * t1 + e[1] * t2 + e[2] * t3;
        const floats t5 = a_prime[0] - a[0];
        const floats t6 = a_prime[1] - a[1];
        const floats t7 = a_prime[2] - a[2];
        const truthsf t8 = equalf(sin_half_phi, spreadf(0.0f));
        const floats t9 = choosef(t8, spreadf(0.0f), cos_half_phi) / sin_half_phi;
        const floats p_0_0 = 0.5f * ((e[1] * t7 - e[2] * t6) * t9 - (e[0] * t4 - t1));
        const floats p_0_1 = 0.5f * ((e[2] * t5 - e[0] * t7) * t9 - (e[1] * t4 - t2));
        const floats p_0_2 = 0.5f * ((e[0] * t6 - e[1] * t5) * t9 - (e[2] * t4 - t3));
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 3, sizeof(float), copied.ahead);
        const floats result4[] = {p_0_0, p_0_1, p_0_2};
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

void CHASLES_LEVELED(chasles_screw_axis_point_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_screw_axis_point_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

#else

void CHASLES_LEVELED(chasles_normal_matrix_inverse_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_normal_matrix_inverse(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_normal_matrix_inverse_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_normal_matrix_inversef(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_screw_axis_point_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_screw_axis_point(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_screw_axis_point_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_screw_axis_pointf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

#endif
