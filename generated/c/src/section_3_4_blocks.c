/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_4, for batches. Made by `chasles emit`; not to be edited by hand.
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

CHASLES_INLINE void chasles_velocity_of_point_block_items(
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(double));
    ptrdiff_t entries4[3];
    const int dense4 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step4, steps + 13, entries4));
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
        const doubles p_dot0 = a_dot[0] + (omega[1] * t3 - omega[2] * t2);
        const doubles p_dot1 = a_dot[1] + (omega[2] * t1 - omega[0] * t3);
        const doubles p_dot2 = a_dot[2] + (omega[0] * t2 - omega[1] * t1);
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 3, sizeof(double), copied.ahead);
        const doubles result4[] = {p_dot0, p_dot1, p_dot2};
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

void CHASLES_LEVELED(chasles_velocity_of_point_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 5)
        && is_packed(3, 3, sizeof(double), steps[1], steps + 7)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 9)
        && is_packed(3, 3, sizeof(double), steps[3], steps + 11)
        && is_packed(3, 3, sizeof(double), steps[4], steps + 13)) {
        chasles_velocity_of_point_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_velocity_of_point_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_velocity_of_point_blockf_items(
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(float));
    ptrdiff_t entries4[3];
    const int dense4 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step4, steps + 13, entries4));
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
        const floats p_dot0 = a_dot[0] + (omega[1] * t3 - omega[2] * t2);
        const floats p_dot1 = a_dot[1] + (omega[2] * t1 - omega[0] * t3);
        const floats p_dot2 = a_dot[2] + (omega[0] * t2 - omega[1] * t1);
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 3, sizeof(float), copied.ahead);
        const floats result4[] = {p_dot0, p_dot1, p_dot2};
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

void CHASLES_LEVELED(chasles_velocity_of_point_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 5)
        && is_packed(3, 3, sizeof(float), steps[1], steps + 7)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 9)
        && is_packed(3, 3, sizeof(float), steps[3], steps + 11)
        && is_packed(3, 3, sizeof(float), steps[4], steps + 13)) {
        chasles_velocity_of_point_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_velocity_of_point_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

#else

void CHASLES_LEVELED(chasles_velocity_of_point_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_velocity_of_point(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_velocity_of_point_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_velocity_of_pointf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

#endif
