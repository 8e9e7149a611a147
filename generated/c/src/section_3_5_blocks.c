/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_5, for batches. Made by `chasles emit`; not to be edited by hand.
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

CHASLES_INLINE void chasles_angular_acceleration_matrix_block_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(double));
    ptrdiff_t entries2[9];
    const int dense2 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step2, steps + 7, entries2));
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
        doubles omega_dot[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &omega_dot[0]);
        } else if (step1 == sizeof(double)) {
            omega_dot[0] = PACKED_IN(item1 + entries1[0], 0);
            omega_dot[1] = PACKED_IN(item1 + entries1[1], 0);
            omega_dot[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            omega_dot[0] = all[0];
            omega_dot[1] = all[1];
            omega_dot[2] = all[2];
        }
        const doubles t1 = omega[0] * omega[0];
        const doubles t2 = omega[0] * omega[1];
        const doubles t3 = omega[0] * omega[2];
        const doubles t4 = omega[1] * omega[1];
        const doubles t5 = omega[1] * omega[2];
        const doubles t6 = omega[2] * omega[2];
        const doubles W0 = -(t4 + t6);
        const doubles W4 = -(t1 + t6);
        const doubles W8 = -(t1 + t4);
        const doubles W1 = t2 - omega_dot[2];
        const doubles W2 = omega_dot[1] + t3;
        const doubles W3 = omega_dot[2] + t2;
        const doubles W5 = t5 - omega_dot[0];
        const doubles W6 = t3 - omega_dot[1];
        const doubles W7 = omega_dot[0] + t5;
        char *const item2 = at2 + g * LANES * step2;
        prefetch_to_write(item2, step2, 9, sizeof(double), copied.ahead);
        const doubles result2[] = {W0, W1, W2, W3, W4, W5, W6, W7, W8};
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

void CHASLES_LEVELED(chasles_angular_acceleration_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 3)
        && is_packed(3, 3, sizeof(double), steps[1], steps + 5)
        && is_packed(9, 3, sizeof(double), steps[2], steps + 7)) {
        chasles_angular_acceleration_matrix_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_angular_acceleration_matrix_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_angular_acceleration_matrix_blockf_items(
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
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(float));
    ptrdiff_t entries2[9];
    const int dense2 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step2, steps + 7, entries2));
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
        floats omega_dot[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &omega_dot[0]);
        } else if (step1 == sizeof(float)) {
            omega_dot[0] = PACKEDF_IN(item1 + entries1[0], 0);
            omega_dot[1] = PACKEDF_IN(item1 + entries1[1], 0);
            omega_dot[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            omega_dot[0] = all[0];
            omega_dot[1] = all[1];
            omega_dot[2] = all[2];
        }
        const floats t1 = omega[0] * omega[0];
        const floats t2 = omega[0] * omega[1];
        const floats t3 = omega[0] * omega[2];
        const floats t4 = omega[1] * omega[1];
        const floats t5 = omega[1] * omega[2];
        const floats t6 = omega[2] * omega[2];
        const floats W0 = -(t4 + t6);
        const floats W4 = -(t1 + t6);
        const floats W8 = -(t1 + t4);
        const floats W1 = t2 - omega_dot[2];
        const floats W2 = omega_dot[1] + t3;
        const floats W3 = omega_dot[2] + t2;
        const floats W5 = t5 - omega_dot[0];
        const floats W6 = t3 - omega_dot[1];
        const floats W7 = omega_dot[0] + t5;
        char *const item2 = at2 + g * LANESF * step2;
        prefetch_to_write(item2, step2, 9, sizeof(float), copied.ahead);
        const floats result2[] = {W0, W1, W2, W3, W4, W5, W6, W7, W8};
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

void CHASLES_LEVELED(chasles_angular_acceleration_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 3)
        && is_packed(3, 3, sizeof(float), steps[1], steps + 5)
        && is_packed(9, 3, sizeof(float), steps[2], steps + 7)) {
        chasles_angular_acceleration_matrix_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_angular_acceleration_matrix_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_acceleration_of_point_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 6, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step1, steps + 8, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 10, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step3, steps + 12, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(double));
    ptrdiff_t entries4[3];
    const int dense4 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step4, steps + 14, entries4));
    char *const at5 = at[5];
    const ptrdiff_t step5 = CHASLES_STEP(5, 3 * sizeof(double));
    ptrdiff_t entries5[3];
    const int dense5 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step5, steps + 16, entries5));
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
        doubles omega_dot[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3(item1 + 0 * sizeof(double), step1, &omega_dot[0]);
        } else if (step1 == sizeof(double)) {
            omega_dot[0] = PACKED_IN(item1 + entries1[0], 0);
            omega_dot[1] = PACKED_IN(item1 + entries1[1], 0);
            omega_dot[2] = PACKED_IN(item1 + entries1[2], 0);
        } else {
            doubles all[3];
            take_each(item1, entries1, step1, 3, all);
            omega_dot[0] = all[0];
            omega_dot[1] = all[1];
            omega_dot[2] = all[2];
        }
        doubles a_ddot[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &a_ddot[0]);
        } else if (step2 == sizeof(double)) {
            a_ddot[0] = PACKED_IN(item2 + entries2[0], 0);
            a_ddot[1] = PACKED_IN(item2 + entries2[1], 0);
            a_ddot[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            a_ddot[0] = all[0];
            a_ddot[1] = all[1];
            a_ddot[2] = all[2];
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
        doubles p[3];
        const char *const item4 = at4 + g * LANES * step4;
        prefetch(item4, 3, copied.ahead);
        if (dense4) {
            load_3(item4 + 0 * sizeof(double), step4, &p[0]);
        } else if (step4 == sizeof(double)) {
            p[0] = PACKED_IN(item4 + entries4[0], 0);
            p[1] = PACKED_IN(item4 + entries4[1], 0);
            p[2] = PACKED_IN(item4 + entries4[2], 0);
        } else {
            doubles all[3];
            take_each(item4, entries4, step4, 3, all);
            p[0] = all[0];
            p[1] = all[1];
            p[2] = all[2];
        }
        const doubles t1 = p[0] - a[0];
        const doubles t2 = p[1] - a[1];
        const doubles t3 = p[2] - a[2];
        const doubles t4 = omega[1] * t3 - omega[2] * t2;
        const doubles t5 = omega[2] * t1 - omega[0] * t3;
        const doubles t6 = omega[0] * t2 - omega[1] * t1;
        const doubles t7 = a_ddot[0] + (omega_dot[1] * t3 - omega_dot[2] * t2);
        const doubles p_ddot0 = t7 + (omega[1] * t6 - omega[2] * t5);
        const doubles t8 = a_ddot[1] + (omega_dot[2] * t1 - omega_dot[0] * t3);
        const doubles p_ddot1 = t8 + (omega[2] * t4 - omega[0] * t6);
        const doubles t9 = a_ddot[2] + (omega_dot[0] * t2 - omega_dot[1] * t1);
        const doubles p_ddot2 = t9 + (omega[0] * t5 - omega[1] * t4);
        char *const item5 = at5 + g * LANES * step5;
        prefetch_to_write(item5, step5, 3, sizeof(double), copied.ahead);
        const doubles result5[] = {p_ddot0, p_ddot1, p_ddot2};
        if (dense5) {
            store_all(item5, step5, 3, result5);
        } else if (step5 == sizeof(double)) {
            PACKED(item5 + entries5[0], 0) = result5[0];
            PACKED(item5 + entries5[1], 0) = result5[1];
            PACKED(item5 + entries5[2], 0) = result5[2];
        } else {
            give_each(item5, entries5, step5, 3, result5);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_acceleration_of_point_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 6)
        && is_packed(3, 3, sizeof(double), steps[1], steps + 8)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 10)
        && is_packed(3, 3, sizeof(double), steps[3], steps + 12)
        && is_packed(3, 3, sizeof(double), steps[4], steps + 14)
        && is_packed(3, 3, sizeof(double), steps[5], steps + 16)) {
        chasles_acceleration_of_point_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_acceleration_of_point_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_acceleration_of_point_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 6, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step1, steps + 8, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 10, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step3, steps + 12, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(float));
    ptrdiff_t entries4[3];
    const int dense4 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step4, steps + 14, entries4));
    char *const at5 = at[5];
    const ptrdiff_t step5 = CHASLES_STEP(5, 3 * sizeof(float));
    ptrdiff_t entries5[3];
    const int dense5 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step5, steps + 16, entries5));
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
        floats omega_dot[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3, copied.ahead);
        if (dense1) {
            load_3f(item1 + 0 * sizeof(float), step1, &omega_dot[0]);
        } else if (step1 == sizeof(float)) {
            omega_dot[0] = PACKEDF_IN(item1 + entries1[0], 0);
            omega_dot[1] = PACKEDF_IN(item1 + entries1[1], 0);
            omega_dot[2] = PACKEDF_IN(item1 + entries1[2], 0);
        } else {
            floats all[3];
            take_eachf(item1, entries1, step1, 3, all);
            omega_dot[0] = all[0];
            omega_dot[1] = all[1];
            omega_dot[2] = all[2];
        }
        floats a_ddot[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &a_ddot[0]);
        } else if (step2 == sizeof(float)) {
            a_ddot[0] = PACKEDF_IN(item2 + entries2[0], 0);
            a_ddot[1] = PACKEDF_IN(item2 + entries2[1], 0);
            a_ddot[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            a_ddot[0] = all[0];
            a_ddot[1] = all[1];
            a_ddot[2] = all[2];
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
        floats p[3];
        const char *const item4 = at4 + g * LANESF * step4;
        prefetch(item4, 3, copied.ahead);
        if (dense4) {
            load_3f(item4 + 0 * sizeof(float), step4, &p[0]);
        } else if (step4 == sizeof(float)) {
            p[0] = PACKEDF_IN(item4 + entries4[0], 0);
            p[1] = PACKEDF_IN(item4 + entries4[1], 0);
            p[2] = PACKEDF_IN(item4 + entries4[2], 0);
        } else {
            floats all[3];
            take_eachf(item4, entries4, step4, 3, all);
            p[0] = all[0];
            p[1] = all[1];
            p[2] = all[2];
        }
        const floats t1 = p[0] - a[0];
        const floats t2 = p[1] - a[1];
        const floats t3 = p[2] - a[2];
        const floats t4 = omega[1] * t3 - omega[2] * t2;
        const floats t5 = omega[2] * t1 - omega[0] * t3;
        const floats t6 = omega[0] * t2 - omega[1] * t1;
        const floats t7 = a_ddot[0] + (omega_dot[1] * t3 - omega_dot[2] * t2);
        const floats p_ddot0 = t7 + (omega[1] * t6 - omega[2] * t5);
        const floats t8 = a_ddot[1] + (omega_dot[2] * t1 - omega_dot[0] * t3);
        const floats p_ddot1 = t8 + (omega[2] * t4 - omega[0] * t6);
        const floats t9 = a_ddot[2] + (omega_dot[0] * t2 - omega_dot[1] * t1);
        const floats p_ddot2 = t9 + (omega[0] * t5 - omega[1] * t4);
        char *const item5 = at5 + g * LANESF * step5;
        prefetch_to_write(item5, step5, 3, sizeof(float), copied.ahead);
        const floats result5[] = {p_ddot0, p_ddot1, p_ddot2};
        if (dense5) {
            store_allf(item5, step5, 3, result5);
        } else if (step5 == sizeof(float)) {
            PACKEDF(item5 + entries5[0], 0) = result5[0];
            PACKEDF(item5 + entries5[1], 0) = result5[1];
            PACKEDF(item5 + entries5[2], 0) = result5[2];
        } else {
            give_eachf(item5, entries5, step5, 3, result5);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_acceleration_of_point_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 6)
        && is_packed(3, 3, sizeof(float), steps[1], steps + 8)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 10)
        && is_packed(3, 3, sizeof(float), steps[3], steps + 12)
        && is_packed(3, 3, sizeof(float), steps[4], steps + 14)
        && is_packed(3, 3, sizeof(float), steps[5], steps + 16)) {
        chasles_acceleration_of_point_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_acceleration_of_point_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_natural_rate_matrix_dot_block_items(
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 12 * sizeof(double));
    ptrdiff_t entries3[12];
    const int dense3 = CHASLES_DENSE(find_entries(12, 3, sizeof(double), step3, steps + 10, entries3));
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
        doubles omega[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &omega[0]);
        } else if (step2 == sizeof(double)) {
            omega[0] = PACKED_IN(item2 + entries2[0], 0);
            omega[1] = PACKED_IN(item2 + entries2[1], 0);
            omega[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles t1 = choose(equal(sin_half_phi, spread(0.0)), spread(0.0), cos_half_phi);
        const doubles t2 = t1 / sin_half_phi;
        const doubles half_t2 = 0.5 * t2;
        const doubles t3 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2];
        const doubles t4 = (half_t2 * half_t2 + 0.25) * t3;
        const doubles t5 = 0.5 * e[0];
        const doubles t6 = 0.5 * e[1];
        const doubles t7 = 0.5 * e[2];
        const doubles t8 = half_t2 * (e[0] * t3 - omega[0]) + (omega[2] * t6 - omega[1] * t7);
        const doubles N_dot9 = -t8;
        const doubles t9 = half_t2 * (e[1] * t3 - omega[1]) + (omega[0] * t7 - omega[2] * t5);
        const doubles N_dot10 = -t9;
        const doubles t10 = half_t2 * (e[2] * t3 - omega[2]) + (omega[1] * t5 - omega[0] * t6);
        const doubles N_dot11 = -t10;
        const doubles t11 = e[0] * t4 + t2 * t8;
        const doubles t12 = e[1] * t4 + t2 * t9;
        const doubles t13 = e[2] * t4 + t2 * t10;
        const doubles half_t8 = 0.5 * t8;
        const doubles half_t9 = 0.5 * t9;
        const doubles half_t10 = 0.5 * t10;
        const doubles t14 = t5 * t12 + t6 * t11;
        const doubles t15 = t5 * t13 + t7 * t11;
        const doubles t16 = t6 * t13 + t7 * t12;
        const doubles N_dot0 = e[0] * t11 - t4;
        const doubles N_dot1 = t14 - half_t10;
        const doubles N_dot2 = half_t9 + t15;
        const doubles N_dot3 = half_t10 + t14;
        const doubles N_dot4 = e[1] * t12 - t4;
        const doubles N_dot5 = t16 - half_t8;
        const doubles N_dot6 = t15 - half_t9;
        const doubles N_dot7 = half_t8 + t16;
        const doubles N_dot8 = e[2] * t13 - t4;
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 12, sizeof(double), copied.ahead);
        const doubles result3[] = {
            N_dot0,
            N_dot1,
            N_dot2,
            N_dot3,
            N_dot4,
            N_dot5,
            N_dot6,
            N_dot7,
            N_dot8,
            N_dot9,
            N_dot10,
            N_dot11};
        if (dense3) {
            store_all(item3, step3, 12, result3);
        } else if (step3 == sizeof(double)) {
            PACKED(item3 + entries3[0], 0) = result3[0];
            PACKED(item3 + entries3[1], 0) = result3[1];
            PACKED(item3 + entries3[2], 0) = result3[2];
            PACKED(item3 + entries3[3], 0) = result3[3];
            PACKED(item3 + entries3[4], 0) = result3[4];
            PACKED(item3 + entries3[5], 0) = result3[5];
            PACKED(item3 + entries3[6], 0) = result3[6];
            PACKED(item3 + entries3[7], 0) = result3[7];
            PACKED(item3 + entries3[8], 0) = result3[8];
            PACKED(item3 + entries3[9], 0) = result3[9];
            PACKED(item3 + entries3[10], 0) = result3[10];
            PACKED(item3 + entries3[11], 0) = result3[11];
        } else {
            give_each(item3, entries3, step3, 12, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_natural_rate_matrix_dot_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_natural_rate_matrix_dot_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_natural_rate_matrix_dot_blockf_items(
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 12 * sizeof(float));
    ptrdiff_t entries3[12];
    const int dense3 = CHASLES_DENSE(find_entries(12, 3, sizeof(float), step3, steps + 10, entries3));
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
        floats omega[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &omega[0]);
        } else if (step2 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item2 + entries2[0], 0);
            omega[1] = PACKEDF_IN(item2 + entries2[1], 0);
            omega[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const truthsf t1 = equalf(sin_half_phi, spreadf(0.0f));
        const floats t2 = choosef(t1, spreadf(0.0f), cos_half_phi) / sin_half_phi;
        const floats half_t2 = 0.5f * t2;
        const floats t3 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2];
        const floats t4 = (half_t2 * half_t2 + 0.25f) * t3;
        const floats t5 = 0.5f * e[0];
        const floats t6 = 0.5f * e[1];
        const floats t7 = 0.5f * e[2];
        const floats t8 = half_t2 * (e[0] * t3 - omega[0]) + (omega[2] * t6 - omega[1] * t7);
        const floats N_dot9 = -t8;
        const floats t9 = half_t2 * (e[1] * t3 - omega[1]) + (omega[0] * t7 - omega[2] * t5);
        const floats N_dot10 = -t9;
        const floats t10 = half_t2 * (e[2] * t3 - omega[2]) + (omega[1] * t5 - omega[0] * t6);
        const floats N_dot11 = -t10;
        const floats t11 = e[0] * t4 + t2 * t8;
        const floats t12 = e[1] * t4 + t2 * t9;
        const floats t13 = e[2] * t4 + t2 * t10;
        const floats half_t8 = 0.5f * t8;
        const floats half_t9 = 0.5f * t9;
        const floats half_t10 = 0.5f * t10;
        const floats t14 = t5 * t12 + t6 * t11;
        const floats t15 = t5 * t13 + t7 * t11;
        const floats t16 = t6 * t13 + t7 * t12;
        const floats N_dot0 = e[0] * t11 - t4;
        const floats N_dot1 = t14 - half_t10;
        const floats N_dot2 = half_t9 + t15;
        const floats N_dot3 = half_t10 + t14;
        const floats N_dot4 = e[1] * t12 - t4;
        const floats N_dot5 = t16 - half_t8;
        const floats N_dot6 = t15 - half_t9;
        const floats N_dot7 = half_t8 + t16;
        const floats N_dot8 = e[2] * t13 - t4;
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 12, sizeof(float), copied.ahead);
        const floats result3[] = {
            N_dot0,
            N_dot1,
            N_dot2,
            N_dot3,
            N_dot4,
            N_dot5,
            N_dot6,
            N_dot7,
            N_dot8,
            N_dot9,
            N_dot10,
            N_dot11};
        if (dense3) {
            store_allf(item3, step3, 12, result3);
        } else if (step3 == sizeof(float)) {
            PACKEDF(item3 + entries3[0], 0) = result3[0];
            PACKEDF(item3 + entries3[1], 0) = result3[1];
            PACKEDF(item3 + entries3[2], 0) = result3[2];
            PACKEDF(item3 + entries3[3], 0) = result3[3];
            PACKEDF(item3 + entries3[4], 0) = result3[4];
            PACKEDF(item3 + entries3[5], 0) = result3[5];
            PACKEDF(item3 + entries3[6], 0) = result3[6];
            PACKEDF(item3 + entries3[7], 0) = result3[7];
            PACKEDF(item3 + entries3[8], 0) = result3[8];
            PACKEDF(item3 + entries3[9], 0) = result3[9];
            PACKEDF(item3 + entries3[10], 0) = result3[10];
            PACKEDF(item3 + entries3[11], 0) = result3[11];
        } else {
            give_eachf(item3, entries3, step3, 12, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_natural_rate_matrix_dot_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_natural_rate_matrix_dot_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_linear_rate_matrix_dot_block_items(
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 12 * sizeof(double));
    ptrdiff_t entries3[12];
    const int dense3 = CHASLES_DENSE(find_entries(12, 3, sizeof(double), step3, steps + 10, entries3));
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
        doubles omega[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &omega[0]);
        } else if (step2 == sizeof(double)) {
            omega[0] = PACKED_IN(item2 + entries2[0], 0);
            omega[1] = PACKED_IN(item2 + entries2[1], 0);
            omega[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_phi = sines[0][g];
        const doubles cos_phi = cosines[0][g];
        const doubles t1 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2];
        const doubles half_sin_phi = 0.5 * sin_phi;
        const doubles t2 = t1 * half_sin_phi;
        const doubles t3 = e[1] * omega[2] - e[2] * omega[1];
        const doubles t4 = e[2] * omega[0] - e[0] * omega[2];
        const doubles t5 = e[0] * omega[1] - e[1] * omega[0];
        const doubles half_cos_phi = 0.5 * cos_phi;
        const doubles t6 = 0.5 - half_cos_phi;
        const doubles t7 = omega[0] * half_sin_phi - t3 * t6;
        const doubles t8 = omega[1] * half_sin_phi - t4 * t6;
        const doubles t9 = omega[2] * half_sin_phi - t5 * t6;
        const doubles t10 = 0.5 + half_cos_phi;
        const doubles t11 = t1 * t6;
        const doubles t12 = omega[0] * t10 - e[0] * t11 - half_sin_phi * t3;
        const doubles t13 = omega[1] * t10 - e[1] * t11 - half_sin_phi * t4;
        const doubles t14 = omega[2] * t10 - e[2] * t11 - half_sin_phi * t5;
        const doubles half_t12 = 0.5 * t12;
        const doubles half_t13 = 0.5 * t13;
        const doubles half_t14 = 0.5 * t14;
        const doubles t15 = 0.5 * e[0];
        const doubles t16 = 0.5 * e[1];
        const doubles t17 = 0.5 * e[2];
        const doubles t18 = t8 * t15 + t7 * t16;
        const doubles t19 = t9 * t15 + t7 * t17;
        const doubles t20 = t9 * t16 + t8 * t17;
        const doubles L_dot0 = -(t2 + e[0] * t7);
        const doubles L_dot1 = half_t14 - t18;
        const doubles L_dot2 = -(half_t13 + t19);
        const doubles L_dot3 = -(half_t14 + t18);
        const doubles L_dot4 = -(t2 + e[1] * t8);
        const doubles L_dot5 = half_t12 - t20;
        const doubles L_dot6 = half_t13 - t19;
        const doubles L_dot7 = -(half_t12 + t20);
        const doubles L_dot8 = -(t2 + e[2] * t9);
        const doubles L_dot9 = -t12;
        const doubles L_dot10 = -t13;
        const doubles L_dot11 = -t14;
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 12, sizeof(double), copied.ahead);
        const doubles result3[] = {
            L_dot0,
            L_dot1,
            L_dot2,
            L_dot3,
            L_dot4,
            L_dot5,
            L_dot6,
            L_dot7,
            L_dot8,
            L_dot9,
            L_dot10,
            L_dot11};
        if (dense3) {
            store_all(item3, step3, 12, result3);
        } else if (step3 == sizeof(double)) {
            PACKED(item3 + entries3[0], 0) = result3[0];
            PACKED(item3 + entries3[1], 0) = result3[1];
            PACKED(item3 + entries3[2], 0) = result3[2];
            PACKED(item3 + entries3[3], 0) = result3[3];
            PACKED(item3 + entries3[4], 0) = result3[4];
            PACKED(item3 + entries3[5], 0) = result3[5];
            PACKED(item3 + entries3[6], 0) = result3[6];
            PACKED(item3 + entries3[7], 0) = result3[7];
            PACKED(item3 + entries3[8], 0) = result3[8];
            PACKED(item3 + entries3[9], 0) = result3[9];
            PACKED(item3 + entries3[10], 0) = result3[10];
            PACKED(item3 + entries3[11], 0) = result3[11];
        } else {
            give_each(item3, entries3, step3, 12, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_linear_rate_matrix_dot_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_linear_rate_matrix_dot_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_linear_rate_matrix_dot_blockf_items(
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 12 * sizeof(float));
    ptrdiff_t entries3[12];
    const int dense3 = CHASLES_DENSE(find_entries(12, 3, sizeof(float), step3, steps + 10, entries3));
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
        floats omega[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &omega[0]);
        } else if (step2 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item2 + entries2[0], 0);
            omega[1] = PACKEDF_IN(item2 + entries2[1], 0);
            omega[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_phi = sines[0][g];
        const floats cos_phi = cosines[0][g];
        const floats t1 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2];
        const floats half_sin_phi = 0.5f * sin_phi;
        const floats t2 = t1 * half_sin_phi;
        const floats t3 = e[1] * omega[2] - e[2] * omega[1];
        const floats t4 = e[2] * omega[0] - e[0] * omega[2];
        const floats t5 = e[0] * omega[1] - e[1] * omega[0];
        const floats half_cos_phi = 0.5f * cos_phi;
        const floats t6 = 0.5f - half_cos_phi;
        const floats t7 = omega[0] * half_sin_phi - t3 * t6;
        const floats t8 = omega[1] * half_sin_phi - t4 * t6;
        const floats t9 = omega[2] * half_sin_phi - t5 * t6;
        const floats t10 = 0.5f + half_cos_phi;
        const floats t11 = t1 * t6;
        const floats t12 = omega[0] * t10 - e[0] * t11 - half_sin_phi * t3;
        const floats t13 = omega[1] * t10 - e[1] * t11 - half_sin_phi * t4;
        const floats t14 = omega[2] * t10 - e[2] * t11 - half_sin_phi * t5;
        const floats half_t12 = 0.5f * t12;
        const floats half_t13 = 0.5f * t13;
        const floats half_t14 = 0.5f * t14;
        const floats t15 = 0.5f * e[0];
        const floats t16 = 0.5f * e[1];
        const floats t17 = 0.5f * e[2];
        const floats t18 = t8 * t15 + t7 * t16;
        const floats t19 = t9 * t15 + t7 * t17;
        const floats t20 = t9 * t16 + t8 * t17;
        const floats L_dot0 = -(t2 + e[0] * t7);
        const floats L_dot1 = half_t14 - t18;
        const floats L_dot2 = -(half_t13 + t19);
        const floats L_dot3 = -(half_t14 + t18);
        const floats L_dot4 = -(t2 + e[1] * t8);
        const floats L_dot5 = half_t12 - t20;
        const floats L_dot6 = half_t13 - t19;
        const floats L_dot7 = -(half_t12 + t20);
        const floats L_dot8 = -(t2 + e[2] * t9);
        const floats L_dot9 = -t12;
        const floats L_dot10 = -t13;
        const floats L_dot11 = -t14;
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 12, sizeof(float), copied.ahead);
        const floats result3[] = {
            L_dot0,
            L_dot1,
            L_dot2,
            L_dot3,
            L_dot4,
            L_dot5,
            L_dot6,
            L_dot7,
            L_dot8,
            L_dot9,
            L_dot10,
            L_dot11};
        if (dense3) {
            store_allf(item3, step3, 12, result3);
        } else if (step3 == sizeof(float)) {
            PACKEDF(item3 + entries3[0], 0) = result3[0];
            PACKEDF(item3 + entries3[1], 0) = result3[1];
            PACKEDF(item3 + entries3[2], 0) = result3[2];
            PACKEDF(item3 + entries3[3], 0) = result3[3];
            PACKEDF(item3 + entries3[4], 0) = result3[4];
            PACKEDF(item3 + entries3[5], 0) = result3[5];
            PACKEDF(item3 + entries3[6], 0) = result3[6];
            PACKEDF(item3 + entries3[7], 0) = result3[7];
            PACKEDF(item3 + entries3[8], 0) = result3[8];
            PACKEDF(item3 + entries3[9], 0) = result3[9];
            PACKEDF(item3 + entries3[10], 0) = result3[10];
            PACKEDF(item3 + entries3[11], 0) = result3[11];
        } else {
            give_eachf(item3, entries3, step3, 12, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_linear_rate_matrix_dot_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_linear_rate_matrix_dot_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rodrigues_rate_matrix_dot_block_items(
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 12 * sizeof(double));
    ptrdiff_t entries3[12];
    const int dense3 = CHASLES_DENSE(find_entries(12, 3, sizeof(double), step3, steps + 10, entries3));
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
        doubles omega[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &omega[0]);
        } else if (step2 == sizeof(double)) {
            omega[0] = PACKED_IN(item2 + entries2[0], 0);
            omega[1] = PACKED_IN(item2 + entries2[1], 0);
            omega[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles t1 = 0.25 * sin_half_phi;
        const doubles t2 = e[0] * t1;
        const doubles t3 = e[1] * t1;
        const doubles t4 = e[2] * t1;
        const doubles H_dot0 = -(omega[0] * t2 + omega[1] * t3 + omega[2] * t4);
        const doubles t5 = 0.25 * cos_half_phi;
        const doubles H_dot5 = omega[0] * t5 - (omega[2] * t3 - omega[1] * t4);
        const doubles H_dot6 = omega[1] * t5 - (omega[0] * t4 - omega[2] * t2);
        const doubles H_dot1 = omega[2] * t5 - (omega[1] * t2 - omega[0] * t3);
        const doubles H_dot7 = -H_dot5;
        const doubles H_dot2 = -H_dot6;
        const doubles H_dot3 = -H_dot1;
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 12, sizeof(double), copied.ahead);
        const doubles result3[] = {
            H_dot0,
            H_dot1,
            H_dot2,
            H_dot3,
            H_dot0,
            H_dot5,
            H_dot6,
            H_dot7,
            H_dot0,
            H_dot7,
            H_dot2,
            H_dot3};
        if (dense3) {
            store_all(item3, step3, 12, result3);
        } else if (step3 == sizeof(double)) {
            PACKED(item3 + entries3[0], 0) = result3[0];
            PACKED(item3 + entries3[1], 0) = result3[1];
            PACKED(item3 + entries3[2], 0) = result3[2];
            PACKED(item3 + entries3[3], 0) = result3[3];
            PACKED(item3 + entries3[4], 0) = result3[4];
            PACKED(item3 + entries3[5], 0) = result3[5];
            PACKED(item3 + entries3[6], 0) = result3[6];
            PACKED(item3 + entries3[7], 0) = result3[7];
            PACKED(item3 + entries3[8], 0) = result3[8];
            PACKED(item3 + entries3[9], 0) = result3[9];
            PACKED(item3 + entries3[10], 0) = result3[10];
            PACKED(item3 + entries3[11], 0) = result3[11];
        } else {
            give_each(item3, entries3, step3, 12, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_rate_matrix_dot_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 6)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 8)
        && is_packed(12, 3, sizeof(double), steps[3], steps + 10)) {
        chasles_euler_rodrigues_rate_matrix_dot_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_euler_rodrigues_rate_matrix_dot_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rodrigues_rate_matrix_dot_blockf_items(
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 12 * sizeof(float));
    ptrdiff_t entries3[12];
    const int dense3 = CHASLES_DENSE(find_entries(12, 3, sizeof(float), step3, steps + 10, entries3));
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
        floats omega[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &omega[0]);
        } else if (step2 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item2 + entries2[0], 0);
            omega[1] = PACKEDF_IN(item2 + entries2[1], 0);
            omega[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats t1 = 0.25f * sin_half_phi;
        const floats t2 = e[0] * t1;
        const floats t3 = e[1] * t1;
        const floats t4 = e[2] * t1;
        const floats H_dot0 = -(omega[0] * t2 + omega[1] * t3 + omega[2] * t4);
        const floats t5 = 0.25f * cos_half_phi;
        const floats H_dot5 = omega[0] * t5 - (omega[2] * t3 - omega[1] * t4);
        const floats H_dot6 = omega[1] * t5 - (omega[0] * t4 - omega[2] * t2);
        const floats H_dot1 = omega[2] * t5 - (omega[1] * t2 - omega[0] * t3);
        const floats H_dot7 = -H_dot5;
        const floats H_dot2 = -H_dot6;
        const floats H_dot3 = -H_dot1;
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 12, sizeof(float), copied.ahead);
        const floats result3[] = {
            H_dot0,
            H_dot1,
            H_dot2,
            H_dot3,
            H_dot0,
            H_dot5,
            H_dot6,
            H_dot7,
            H_dot0,
            H_dot7,
            H_dot2,
            H_dot3};
        if (dense3) {
            store_allf(item3, step3, 12, result3);
        } else if (step3 == sizeof(float)) {
            PACKEDF(item3 + entries3[0], 0) = result3[0];
            PACKEDF(item3 + entries3[1], 0) = result3[1];
            PACKEDF(item3 + entries3[2], 0) = result3[2];
            PACKEDF(item3 + entries3[3], 0) = result3[3];
            PACKEDF(item3 + entries3[4], 0) = result3[4];
            PACKEDF(item3 + entries3[5], 0) = result3[5];
            PACKEDF(item3 + entries3[6], 0) = result3[6];
            PACKEDF(item3 + entries3[7], 0) = result3[7];
            PACKEDF(item3 + entries3[8], 0) = result3[8];
            PACKEDF(item3 + entries3[9], 0) = result3[9];
            PACKEDF(item3 + entries3[10], 0) = result3[10];
            PACKEDF(item3 + entries3[11], 0) = result3[11];
        } else {
            give_eachf(item3, entries3, step3, 12, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_rate_matrix_dot_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 6)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 8)
        && is_packed(12, 3, sizeof(float), steps[3], steps + 10)) {
        chasles_euler_rodrigues_rate_matrix_dot_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_euler_rodrigues_rate_matrix_dot_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_natural_velocity_matrix_dot_block_items(
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 12 * sizeof(double));
    ptrdiff_t entries3[12];
    const int dense3 = CHASLES_DENSE(find_entries(12, 4, sizeof(double), step3, steps + 10, entries3));
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
        doubles omega[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &omega[0]);
        } else if (step2 == sizeof(double)) {
            omega[0] = PACKED_IN(item2 + entries2[0], 0);
            omega[1] = PACKED_IN(item2 + entries2[1], 0);
            omega[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles t1 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2];
        const doubles t2 = sin_half_phi * sin_half_phi;
        const doubles N_tilde_dot0 = t1 * (1.0 - 2.0 * t2);
        const doubles t3 = sin_half_phi * cos_half_phi;
        const doubles t4 = t1 * t3;
        const doubles t5 = e[1] * omega[2] - e[2] * omega[1];
        const doubles t6 = e[2] * omega[0] - e[0] * omega[2];
        const doubles t7 = e[0] * omega[1] - e[1] * omega[0];
        const doubles N_tilde_dot9 = e[0] * t4 + (omega[0] * t3 - t2 * t5);
        const doubles N_tilde_dot2 = e[1] * t4 + (omega[1] * t3 - t2 * t6);
        const doubles N_tilde_dot4 = e[2] * t4 + (omega[2] * t3 - t2 * t7);
        const doubles N_tilde_dot1 = -N_tilde_dot4;
        const doubles N_tilde_dot6 = -N_tilde_dot9;
        const doubles N_tilde_dot8 = -N_tilde_dot2;
        const doubles t8 = choose(equal(sin_half_phi, spread(0.0)), spread(0.0), cos_half_phi);
        const doubles t9 = 0.5 * (t8 / sin_half_phi);
        const doubles N_tilde_dot3 = -((e[0] * t1 - omega[0]) * t9 + 0.5 * t5);
        const doubles N_tilde_dot7 = -((e[1] * t1 - omega[1]) * t9 + 0.5 * t6);
        const doubles N_tilde_dot11 = -((e[2] * t1 - omega[2]) * t9 + 0.5 * t7);
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 12, sizeof(double), copied.ahead);
        const doubles result3[] = {
            N_tilde_dot0,
            N_tilde_dot1,
            N_tilde_dot2,
            N_tilde_dot3,
            N_tilde_dot4,
            N_tilde_dot0,
            N_tilde_dot6,
            N_tilde_dot7,
            N_tilde_dot8,
            N_tilde_dot9,
            N_tilde_dot0,
            N_tilde_dot11};
        if (dense3) {
            store_all(item3, step3, 12, result3);
        } else if (step3 == sizeof(double)) {
            PACKED(item3 + entries3[0], 0) = result3[0];
            PACKED(item3 + entries3[1], 0) = result3[1];
            PACKED(item3 + entries3[2], 0) = result3[2];
            PACKED(item3 + entries3[3], 0) = result3[3];
            PACKED(item3 + entries3[4], 0) = result3[4];
            PACKED(item3 + entries3[5], 0) = result3[5];
            PACKED(item3 + entries3[6], 0) = result3[6];
            PACKED(item3 + entries3[7], 0) = result3[7];
            PACKED(item3 + entries3[8], 0) = result3[8];
            PACKED(item3 + entries3[9], 0) = result3[9];
            PACKED(item3 + entries3[10], 0) = result3[10];
            PACKED(item3 + entries3[11], 0) = result3[11];
        } else {
            give_each(item3, entries3, step3, 12, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_natural_velocity_matrix_dot_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_natural_velocity_matrix_dot_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_natural_velocity_matrix_dot_blockf_items(
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 12 * sizeof(float));
    ptrdiff_t entries3[12];
    const int dense3 = CHASLES_DENSE(find_entries(12, 4, sizeof(float), step3, steps + 10, entries3));
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
        floats omega[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &omega[0]);
        } else if (step2 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item2 + entries2[0], 0);
            omega[1] = PACKEDF_IN(item2 + entries2[1], 0);
            omega[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats t1 = e[0] * omega[0] + e[1] * omega[1] + e[2] * omega[2];
        const floats t2 = sin_half_phi * sin_half_phi;
        const floats N_tilde_dot0 = t1 * (1.0f - 2.0f * t2);
        const floats t3 = sin_half_phi * cos_half_phi;
        const floats t4 = t1 * t3;
        const floats t5 = e[1] * omega[2] - e[2] * omega[1];
        const floats t6 = e[2] * omega[0] - e[0] * omega[2];
        const floats t7 = e[0] * omega[1] - e[1] * omega[0];
        const floats N_tilde_dot9 = e[0] * t4 + (omega[0] * t3 - t2 * t5);
        const floats N_tilde_dot2 = e[1] * t4 + (omega[1] * t3 - t2 * t6);
        const floats N_tilde_dot4 = e[2] * t4 + (omega[2] * t3 - t2 * t7);
        const floats N_tilde_dot1 = -N_tilde_dot4;
        const floats N_tilde_dot6 = -N_tilde_dot9;
        const floats N_tilde_dot8 = -N_tilde_dot2;
        const truthsf t8 = equalf(sin_half_phi, spreadf(0.0f));
        const floats t9 = 0.5f * (choosef(t8, spreadf(0.0f), cos_half_phi) / sin_half_phi);
        const floats N_tilde_dot3 = -((e[0] * t1 - omega[0]) * t9 + 0.5f * t5);
        const floats N_tilde_dot7 = -((e[1] * t1 - omega[1]) * t9 + 0.5f * t6);
        const floats N_tilde_dot11 = -((e[2] * t1 - omega[2]) * t9 + 0.5f * t7);
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 12, sizeof(float), copied.ahead);
        const floats result3[] = {
            N_tilde_dot0,
            N_tilde_dot1,
            N_tilde_dot2,
            N_tilde_dot3,
            N_tilde_dot4,
            N_tilde_dot0,
            N_tilde_dot6,
            N_tilde_dot7,
            N_tilde_dot8,
            N_tilde_dot9,
            N_tilde_dot0,
            N_tilde_dot11};
        if (dense3) {
            store_allf(item3, step3, 12, result3);
        } else if (step3 == sizeof(float)) {
            PACKEDF(item3 + entries3[0], 0) = result3[0];
            PACKEDF(item3 + entries3[1], 0) = result3[1];
            PACKEDF(item3 + entries3[2], 0) = result3[2];
            PACKEDF(item3 + entries3[3], 0) = result3[3];
            PACKEDF(item3 + entries3[4], 0) = result3[4];
            PACKEDF(item3 + entries3[5], 0) = result3[5];
            PACKEDF(item3 + entries3[6], 0) = result3[6];
            PACKEDF(item3 + entries3[7], 0) = result3[7];
            PACKEDF(item3 + entries3[8], 0) = result3[8];
            PACKEDF(item3 + entries3[9], 0) = result3[9];
            PACKEDF(item3 + entries3[10], 0) = result3[10];
            PACKEDF(item3 + entries3[11], 0) = result3[11];
        } else {
            give_eachf(item3, entries3, step3, 12, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_natural_velocity_matrix_dot_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_natural_velocity_matrix_dot_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_linear_velocity_matrix_dot_block_items(
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 12 * sizeof(double));
    ptrdiff_t entries3[12];
    const int dense3 = CHASLES_DENSE(find_entries(12, 4, sizeof(double), step3, steps + 10, entries3));
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
        doubles omega[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &omega[0]);
        } else if (step2 == sizeof(double)) {
            omega[0] = PACKED_IN(item2 + entries2[0], 0);
            omega[1] = PACKED_IN(item2 + entries2[1], 0);
            omega[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles t1 = choose(equal(cos_half_phi, spread(0.0)), spread(0.0), sin_half_phi);
        const doubles t2 = t1 / cos_half_phi;
        const doubles t3 = e[0] * t2;
        const doubles t4 = e[1] * t2;
        const doubles t5 = e[2] * t2;
        const doubles t6 = t2 * (omega[0] * t3 + omega[1] * t4 + omega[2] * t5);
        const doubles L_tilde_dot9 = 0.5 * (omega[0] + e[0] * t6 - (omega[2] * t4 - omega[1] * t5));
        const doubles L_tilde_dot2 = 0.5 * (omega[1] + e[1] * t6 - (omega[0] * t5 - omega[2] * t3));
        const doubles L_tilde_dot4 = 0.5 * (omega[2] + e[2] * t6 - (omega[1] * t3 - omega[0] * t4));
        const doubles L_tilde_dot1 = -L_tilde_dot4;
        const doubles L_tilde_dot3 = -L_tilde_dot9;
        const doubles L_tilde_dot7 = -L_tilde_dot2;
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 12, sizeof(double), copied.ahead);
        const doubles result3[] = {
            spread(0.0),
            L_tilde_dot1,
            L_tilde_dot2,
            L_tilde_dot3,
            L_tilde_dot4,
            spread(0.0),
            L_tilde_dot3,
            L_tilde_dot7,
            L_tilde_dot7,
            L_tilde_dot9,
            spread(0.0),
            L_tilde_dot1};
        if (dense3) {
            store_all(item3, step3, 12, result3);
        } else if (step3 == sizeof(double)) {
            PACKED(item3 + entries3[0], 0) = result3[0];
            PACKED(item3 + entries3[1], 0) = result3[1];
            PACKED(item3 + entries3[2], 0) = result3[2];
            PACKED(item3 + entries3[3], 0) = result3[3];
            PACKED(item3 + entries3[4], 0) = result3[4];
            PACKED(item3 + entries3[5], 0) = result3[5];
            PACKED(item3 + entries3[6], 0) = result3[6];
            PACKED(item3 + entries3[7], 0) = result3[7];
            PACKED(item3 + entries3[8], 0) = result3[8];
            PACKED(item3 + entries3[9], 0) = result3[9];
            PACKED(item3 + entries3[10], 0) = result3[10];
            PACKED(item3 + entries3[11], 0) = result3[11];
        } else {
            give_each(item3, entries3, step3, 12, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_linear_velocity_matrix_dot_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_linear_velocity_matrix_dot_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_linear_velocity_matrix_dot_blockf_items(
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 12 * sizeof(float));
    ptrdiff_t entries3[12];
    const int dense3 = CHASLES_DENSE(find_entries(12, 4, sizeof(float), step3, steps + 10, entries3));
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
        floats omega[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &omega[0]);
        } else if (step2 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item2 + entries2[0], 0);
            omega[1] = PACKEDF_IN(item2 + entries2[1], 0);
            omega[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const truthsf t1 = equalf(cos_half_phi, spreadf(0.0f));
        const floats t2 = choosef(t1, spreadf(0.0f), sin_half_phi) / cos_half_phi;
        const floats t3 = e[0] * t2;
        const floats t4 = e[1] * t2;
        const floats t5 = e[2] * t2;
        const floats t6 = t2 * (omega[0] * t3 + omega[1] * t4 + omega[2] * t5);
        const floats L_tilde_dot9 = 0.5f * (omega[0] + e[0] * t6 - (omega[2] * t4 - omega[1] * t5));
        const floats L_tilde_dot2 = 0.5f * (omega[1] + e[1] * t6 - (omega[0] * t5 - omega[2] * t3));
        const floats L_tilde_dot4 = 0.5f * (omega[2] + e[2] * t6 - (omega[1] * t3 - omega[0] * t4));
        const floats L_tilde_dot1 = -L_tilde_dot4;
        const floats L_tilde_dot3 = -L_tilde_dot9;
        const floats L_tilde_dot7 = -L_tilde_dot2;
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 12, sizeof(float), copied.ahead);
        const floats result3[] = {
            spreadf(0.0f),
            L_tilde_dot1,
            L_tilde_dot2,
            L_tilde_dot3,
            L_tilde_dot4,
            spreadf(0.0f),
            L_tilde_dot3,
            L_tilde_dot7,
            L_tilde_dot7,
            L_tilde_dot9,
            spreadf(0.0f),
            L_tilde_dot1};
        if (dense3) {
            store_allf(item3, step3, 12, result3);
        } else if (step3 == sizeof(float)) {
            PACKEDF(item3 + entries3[0], 0) = result3[0];
            PACKEDF(item3 + entries3[1], 0) = result3[1];
            PACKEDF(item3 + entries3[2], 0) = result3[2];
            PACKEDF(item3 + entries3[3], 0) = result3[3];
            PACKEDF(item3 + entries3[4], 0) = result3[4];
            PACKEDF(item3 + entries3[5], 0) = result3[5];
            PACKEDF(item3 + entries3[6], 0) = result3[6];
            PACKEDF(item3 + entries3[7], 0) = result3[7];
            PACKEDF(item3 + entries3[8], 0) = result3[8];
            PACKEDF(item3 + entries3[9], 0) = result3[9];
            PACKEDF(item3 + entries3[10], 0) = result3[10];
            PACKEDF(item3 + entries3[11], 0) = result3[11];
        } else {
            give_eachf(item3, entries3, step3, 12, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_linear_velocity_matrix_dot_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_linear_velocity_matrix_dot_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rodrigues_velocity_matrix_dot_block_items(
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 12 * sizeof(double));
    ptrdiff_t entries3[12];
    const int dense3 = CHASLES_DENSE(find_entries(12, 4, sizeof(double), step3, steps + 10, entries3));
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
        doubles omega[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3(item2 + 0 * sizeof(double), step2, &omega[0]);
        } else if (step2 == sizeof(double)) {
            omega[0] = PACKED_IN(item2 + entries2[0], 0);
            omega[1] = PACKED_IN(item2 + entries2[1], 0);
            omega[2] = PACKED_IN(item2 + entries2[2], 0);
        } else {
            doubles all[3];
            take_each(item2, entries2, step2, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles t1 = e[0] * sin_half_phi;
        const doubles t2 = e[1] * sin_half_phi;
        const doubles t3 = e[2] * sin_half_phi;
        const doubles H_tilde_dot9 = omega[0] * cos_half_phi - (omega[2] * t2 - omega[1] * t3);
        const doubles H_tilde_dot2 = omega[1] * cos_half_phi - (omega[0] * t3 - omega[2] * t1);
        const doubles H_tilde_dot4 = omega[2] * cos_half_phi - (omega[1] * t1 - omega[0] * t2);
        const doubles H_tilde_dot0 = -(omega[0] * t1 + omega[1] * t2 + omega[2] * t3);
        const doubles H_tilde_dot1 = -H_tilde_dot4;
        const doubles H_tilde_dot3 = -H_tilde_dot9;
        const doubles H_tilde_dot7 = -H_tilde_dot2;
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, step3, 12, sizeof(double), copied.ahead);
        const doubles result3[] = {
            H_tilde_dot0,
            H_tilde_dot1,
            H_tilde_dot2,
            H_tilde_dot3,
            H_tilde_dot4,
            H_tilde_dot0,
            H_tilde_dot3,
            H_tilde_dot7,
            H_tilde_dot7,
            H_tilde_dot9,
            H_tilde_dot0,
            H_tilde_dot1};
        if (dense3) {
            store_all(item3, step3, 12, result3);
        } else if (step3 == sizeof(double)) {
            PACKED(item3 + entries3[0], 0) = result3[0];
            PACKED(item3 + entries3[1], 0) = result3[1];
            PACKED(item3 + entries3[2], 0) = result3[2];
            PACKED(item3 + entries3[3], 0) = result3[3];
            PACKED(item3 + entries3[4], 0) = result3[4];
            PACKED(item3 + entries3[5], 0) = result3[5];
            PACKED(item3 + entries3[6], 0) = result3[6];
            PACKED(item3 + entries3[7], 0) = result3[7];
            PACKED(item3 + entries3[8], 0) = result3[8];
            PACKED(item3 + entries3[9], 0) = result3[9];
            PACKED(item3 + entries3[10], 0) = result3[10];
            PACKED(item3 + entries3[11], 0) = result3[11];
        } else {
            give_each(item3, entries3, step3, 12, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_velocity_matrix_dot_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 6)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 8)
        && is_packed(12, 4, sizeof(double), steps[3], steps + 10)) {
        chasles_euler_rodrigues_velocity_matrix_dot_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_euler_rodrigues_velocity_matrix_dot_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_euler_rodrigues_velocity_matrix_dot_blockf_items(
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
    const ptrdiff_t step3 = CHASLES_STEP(3, 12 * sizeof(float));
    ptrdiff_t entries3[12];
    const int dense3 = CHASLES_DENSE(find_entries(12, 4, sizeof(float), step3, steps + 10, entries3));
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
        floats omega[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3, copied.ahead);
        if (dense2) {
            load_3f(item2 + 0 * sizeof(float), step2, &omega[0]);
        } else if (step2 == sizeof(float)) {
            omega[0] = PACKEDF_IN(item2 + entries2[0], 0);
            omega[1] = PACKEDF_IN(item2 + entries2[1], 0);
            omega[2] = PACKEDF_IN(item2 + entries2[2], 0);
        } else {
            floats all[3];
            take_eachf(item2, entries2, step2, 3, all);
            omega[0] = all[0];
            omega[1] = all[1];
            omega[2] = all[2];
        }
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats t1 = e[0] * sin_half_phi;
        const floats t2 = e[1] * sin_half_phi;
        const floats t3 = e[2] * sin_half_phi;
        const floats H_tilde_dot9 = omega[0] * cos_half_phi - (omega[2] * t2 - omega[1] * t3);
        const floats H_tilde_dot2 = omega[1] * cos_half_phi - (omega[0] * t3 - omega[2] * t1);
        const floats H_tilde_dot4 = omega[2] * cos_half_phi - (omega[1] * t1 - omega[0] * t2);
        const floats H_tilde_dot0 = -(omega[0] * t1 + omega[1] * t2 + omega[2] * t3);
        const floats H_tilde_dot1 = -H_tilde_dot4;
        const floats H_tilde_dot3 = -H_tilde_dot9;
        const floats H_tilde_dot7 = -H_tilde_dot2;
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, step3, 12, sizeof(float), copied.ahead);
        const floats result3[] = {
            H_tilde_dot0,
            H_tilde_dot1,
            H_tilde_dot2,
            H_tilde_dot3,
            H_tilde_dot4,
            H_tilde_dot0,
            H_tilde_dot3,
            H_tilde_dot7,
            H_tilde_dot7,
            H_tilde_dot9,
            H_tilde_dot0,
            H_tilde_dot1};
        if (dense3) {
            store_allf(item3, step3, 12, result3);
        } else if (step3 == sizeof(float)) {
            PACKEDF(item3 + entries3[0], 0) = result3[0];
            PACKEDF(item3 + entries3[1], 0) = result3[1];
            PACKEDF(item3 + entries3[2], 0) = result3[2];
            PACKEDF(item3 + entries3[3], 0) = result3[3];
            PACKEDF(item3 + entries3[4], 0) = result3[4];
            PACKEDF(item3 + entries3[5], 0) = result3[5];
            PACKEDF(item3 + entries3[6], 0) = result3[6];
            PACKEDF(item3 + entries3[7], 0) = result3[7];
            PACKEDF(item3 + entries3[8], 0) = result3[8];
            PACKEDF(item3 + entries3[9], 0) = result3[9];
            PACKEDF(item3 + entries3[10], 0) = result3[10];
            PACKEDF(item3 + entries3[11], 0) = result3[11];
        } else {
            give_eachf(item3, entries3, step3, 12, result3);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_velocity_matrix_dot_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 4)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 6)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 8)
        && is_packed(12, 4, sizeof(float), steps[3], steps + 10)) {
        chasles_euler_rodrigues_velocity_matrix_dot_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_euler_rodrigues_velocity_matrix_dot_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_pose_acceleration_natural_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 5, entries0));
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
    const ptrdiff_t step4 = CHASLES_STEP(4, 7 * sizeof(double));
    ptrdiff_t entries4[7];
    const int dense4 = CHASLES_DENSE(find_entries(7, 7, sizeof(double), step4, steps + 13, entries4));
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
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles s_ddot4 = t_dot[3];
        const doubles s_ddot5 = t_dot[4];
        const doubles s_ddot6 = t_dot[5];
        const doubles t1 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
        const doubles t2 = e[0] * t1 - t[0];
        const doubles t3 = e[1] * t1 - t[1];
        const doubles t4 = e[2] * t1 - t[2];
        const doubles t5 = choose(equal(sin_half_phi, spread(0.0)), spread(0.0), cos_half_phi);
        const doubles t6 = 0.5 * (t5 / sin_half_phi);
        const doubles t7 = t2 * t6 + 0.5 * (e[1] * t[2] - e[2] * t[1]);
        const doubles t8 = t3 * t6 + 0.5 * (e[2] * t[0] - e[0] * t[2]);
        const doubles t9 = t4 * t6 + 0.5 * (e[0] * t[1] - e[1] * t[0]);
        const doubles t10 = e[0] * t_dot[0] + e[1] * t_dot[1] + e[2] * t_dot[2];
        const doubles s_ddot3 = t10 - (t[0] * t7 + t[1] * t8 + t[2] * t9);
        const doubles t11 = t1 * (t6 * t6 + 0.25);
        const doubles t12 = 0.5 * (e[1] * t_dot[2] - e[2] * t_dot[1] + (t[1] * t9 - t[2] * t8));
        const doubles s_ddot0 = t6 * (t_dot[0] - e[0] * s_ddot3 + t1 * t7) + t2 * t11 - t12;
        const doubles t13 = 0.5 * (e[2] * t_dot[0] - e[0] * t_dot[2] + (t[2] * t7 - t[0] * t9));
        const doubles s_ddot1 = t6 * (t_dot[1] - e[1] * s_ddot3 + t1 * t8) + t3 * t11 - t13;
        const doubles t14 = 0.5 * (e[0] * t_dot[1] - e[1] * t_dot[0] + (t[0] * t8 - t[1] * t7));
        const doubles s_ddot2 = t6 * (t_dot[2] - e[2] * s_ddot3 + t1 * t9) + t4 * t11 - t14;
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 7, sizeof(double), copied.ahead);
        const doubles result4[] = {s_ddot0, s_ddot1, s_ddot2, s_ddot3, s_ddot4, s_ddot5, s_ddot6};
        if (dense4) {
            store_all(item4, step4, 7, result4);
        } else if (step4 == sizeof(double)) {
            PACKED(item4 + entries4[0], 0) = result4[0];
            PACKED(item4 + entries4[1], 0) = result4[1];
            PACKED(item4 + entries4[2], 0) = result4[2];
            PACKED(item4 + entries4[3], 0) = result4[3];
            PACKED(item4 + entries4[4], 0) = result4[4];
            PACKED(item4 + entries4[5], 0) = result4[5];
            PACKED(item4 + entries4[6], 0) = result4[6];
        } else {
            give_each(item4, entries4, step4, 7, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pose_acceleration_natural_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_pose_acceleration_natural_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_pose_acceleration_natural_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 5, entries0));
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
    const ptrdiff_t step4 = CHASLES_STEP(4, 7 * sizeof(float));
    ptrdiff_t entries4[7];
    const int dense4 = CHASLES_DENSE(find_entries(7, 7, sizeof(float), step4, steps + 13, entries4));
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
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats s_ddot4 = t_dot[3];
        const floats s_ddot5 = t_dot[4];
        const floats s_ddot6 = t_dot[5];
        const floats t1 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
        const floats t2 = e[0] * t1 - t[0];
        const floats t3 = e[1] * t1 - t[1];
        const floats t4 = e[2] * t1 - t[2];
        const truthsf t5 = equalf(sin_half_phi, spreadf(0.0f));
        const floats t6 = 0.5f * (choosef(t5, spreadf(0.0f), cos_half_phi) / sin_half_phi);
        const floats t7 = t2 * t6 + 0.5f * (e[1] * t[2] - e[2] * t[1]);
        const floats t8 = t3 * t6 + 0.5f * (e[2] * t[0] - e[0] * t[2]);
        const floats t9 = t4 * t6 + 0.5f * (e[0] * t[1] - e[1] * t[0]);
        const floats t10 = e[0] * t_dot[0] + e[1] * t_dot[1] + e[2] * t_dot[2];
        const floats s_ddot3 = t10 - (t[0] * t7 + t[1] * t8 + t[2] * t9);
        const floats t11 = t1 * (t6 * t6 + 0.25f);
        const floats t12 = 0.5f * (e[1] * t_dot[2] - e[2] * t_dot[1] + (t[1] * t9 - t[2] * t8));
        const floats s_ddot0 = t6 * (t_dot[0] - e[0] * s_ddot3 + t1 * t7) + t2 * t11 - t12;
        const floats t13 = 0.5f * (e[2] * t_dot[0] - e[0] * t_dot[2] + (t[2] * t7 - t[0] * t9));
        const floats s_ddot1 = t6 * (t_dot[1] - e[1] * s_ddot3 + t1 * t8) + t3 * t11 - t13;
        const floats t14 = 0.5f * (e[0] * t_dot[1] - e[1] * t_dot[0] + (t[0] * t8 - t[1] * t7));
        const floats s_ddot2 = t6 * (t_dot[2] - e[2] * s_ddot3 + t1 * t9) + t4 * t11 - t14;
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 7, sizeof(float), copied.ahead);
        const floats result4[] = {s_ddot0, s_ddot1, s_ddot2, s_ddot3, s_ddot4, s_ddot5, s_ddot6};
        if (dense4) {
            store_allf(item4, step4, 7, result4);
        } else if (step4 == sizeof(float)) {
            PACKEDF(item4 + entries4[0], 0) = result4[0];
            PACKEDF(item4 + entries4[1], 0) = result4[1];
            PACKEDF(item4 + entries4[2], 0) = result4[2];
            PACKEDF(item4 + entries4[3], 0) = result4[3];
            PACKEDF(item4 + entries4[4], 0) = result4[4];
            PACKEDF(item4 + entries4[5], 0) = result4[5];
            PACKEDF(item4 + entries4[6], 0) = result4[6];
        } else {
            give_eachf(item4, entries4, step4, 7, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pose_acceleration_natural_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_pose_acceleration_natural_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_pose_acceleration_linear_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 5, entries0));
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
    const ptrdiff_t step4 = CHASLES_STEP(4, 7 * sizeof(double));
    ptrdiff_t entries4[7];
    const int dense4 = CHASLES_DENSE(find_entries(7, 7, sizeof(double), step4, steps + 13, entries4));
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
        const doubles sin_phi = sines[0][g];
        const doubles cos_phi = cosines[0][g];
        const doubles s_ddot4 = t_dot[3];
        const doubles s_ddot5 = t_dot[4];
        const doubles s_ddot6 = t_dot[5];
        const doubles half_cos_phi = 0.5 * cos_phi;
        const doubles t1 = 0.5 + half_cos_phi;
        const doubles half_sin_phi = 0.5 * sin_phi;
        const doubles t2 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
        const doubles t3 = half_sin_phi * t2;
        const doubles t4 = t_dot[0] * t1 - (e[1] * t_dot[2] - e[2] * t_dot[1]) * half_sin_phi;
        const doubles t5 = t_dot[1] * t1 - (e[2] * t_dot[0] - e[0] * t_dot[2]) * half_sin_phi;
        const doubles t6 = t_dot[2] * t1 - (e[0] * t_dot[1] - e[1] * t_dot[0]) * half_sin_phi;
        const doubles t7 = 0.5 - half_cos_phi;
        const doubles t8 = t2 * t7;
        const doubles t9 = e[0] * t_dot[0] + e[1] * t_dot[1] + e[2] * t_dot[2];
        const doubles t10 = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
        const doubles t11 = t7 * t9 + half_sin_phi * t10;
        const doubles s_ddot0 = t4 - t[0] * t3 + (e[1] * t[2] - e[2] * t[1]) * t8 - e[0] * t11;
        const doubles s_ddot1 = t5 - t[1] * t3 + (e[2] * t[0] - e[0] * t[2]) * t8 - e[1] * t11;
        const doubles s_ddot2 = t6 - t[2] * t3 + (e[0] * t[1] - e[1] * t[0]) * t8 - e[2] * t11;
        const doubles s_ddot3 = t2 * t8 - sin_phi * t9 - t1 * t10;
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 7, sizeof(double), copied.ahead);
        const doubles result4[] = {s_ddot0, s_ddot1, s_ddot2, s_ddot3, s_ddot4, s_ddot5, s_ddot6};
        if (dense4) {
            store_all(item4, step4, 7, result4);
        } else if (step4 == sizeof(double)) {
            PACKED(item4 + entries4[0], 0) = result4[0];
            PACKED(item4 + entries4[1], 0) = result4[1];
            PACKED(item4 + entries4[2], 0) = result4[2];
            PACKED(item4 + entries4[3], 0) = result4[3];
            PACKED(item4 + entries4[4], 0) = result4[4];
            PACKED(item4 + entries4[5], 0) = result4[5];
            PACKED(item4 + entries4[6], 0) = result4[6];
        } else {
            give_each(item4, entries4, step4, 7, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pose_acceleration_linear_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_pose_acceleration_linear_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_pose_acceleration_linear_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 5, entries0));
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
    const ptrdiff_t step4 = CHASLES_STEP(4, 7 * sizeof(float));
    ptrdiff_t entries4[7];
    const int dense4 = CHASLES_DENSE(find_entries(7, 7, sizeof(float), step4, steps + 13, entries4));
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
        const floats sin_phi = sines[0][g];
        const floats cos_phi = cosines[0][g];
        const floats s_ddot4 = t_dot[3];
        const floats s_ddot5 = t_dot[4];
        const floats s_ddot6 = t_dot[5];
        const floats half_cos_phi = 0.5f * cos_phi;
        const floats t1 = 0.5f + half_cos_phi;
        const floats half_sin_phi = 0.5f * sin_phi;
        const floats t2 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
        const floats t3 = half_sin_phi * t2;
        const floats t4 = t_dot[0] * t1 - (e[1] * t_dot[2] - e[2] * t_dot[1]) * half_sin_phi;
        const floats t5 = t_dot[1] * t1 - (e[2] * t_dot[0] - e[0] * t_dot[2]) * half_sin_phi;
        const floats t6 = t_dot[2] * t1 - (e[0] * t_dot[1] - e[1] * t_dot[0]) * half_sin_phi;
        const floats t7 = 0.5f - half_cos_phi;
        const floats t8 = t2 * t7;
        const floats t9 = e[0] * t_dot[0] + e[1] * t_dot[1] + e[2] * t_dot[2];
        const floats t10 = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
        const floats t11 = t7 * t9 + half_sin_phi * t10;
        const floats s_ddot0 = t4 - t[0] * t3 + (e[1] * t[2] - e[2] * t[1]) * t8 - e[0] * t11;
        const floats s_ddot1 = t5 - t[1] * t3 + (e[2] * t[0] - e[0] * t[2]) * t8 - e[1] * t11;
        const floats s_ddot2 = t6 - t[2] * t3 + (e[0] * t[1] - e[1] * t[0]) * t8 - e[2] * t11;
        const floats s_ddot3 = t2 * t8 - sin_phi * t9 - t1 * t10;
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 7, sizeof(float), copied.ahead);
        const floats result4[] = {s_ddot0, s_ddot1, s_ddot2, s_ddot3, s_ddot4, s_ddot5, s_ddot6};
        if (dense4) {
            store_allf(item4, step4, 7, result4);
        } else if (step4 == sizeof(float)) {
            PACKEDF(item4 + entries4[0], 0) = result4[0];
            PACKEDF(item4 + entries4[1], 0) = result4[1];
            PACKEDF(item4 + entries4[2], 0) = result4[2];
            PACKEDF(item4 + entries4[3], 0) = result4[3];
            PACKEDF(item4 + entries4[4], 0) = result4[4];
            PACKEDF(item4 + entries4[5], 0) = result4[5];
            PACKEDF(item4 + entries4[6], 0) = result4[6];
        } else {
            give_eachf(item4, entries4, step4, 7, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pose_acceleration_linear_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_pose_acceleration_linear_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_pose_acceleration_euler_rodrigues_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 5, entries0));
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
    const ptrdiff_t step4 = CHASLES_STEP(4, 7 * sizeof(double));
    ptrdiff_t entries4[7];
    const int dense4 = CHASLES_DENSE(find_entries(7, 7, sizeof(double), step4, steps + 13, entries4));
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
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles s_ddot4 = t_dot[3];
        const doubles s_ddot5 = t_dot[4];
        const doubles s_ddot6 = t_dot[5];
        const doubles t1 = e[0] * sin_half_phi;
        const doubles t2 = e[1] * sin_half_phi;
        const doubles t3 = e[2] * sin_half_phi;
        const doubles t4 = 0.25 * (t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
        const doubles t5 = sin_half_phi * t4;
        const doubles t6 = 0.5 * (t_dot[0] * cos_half_phi - (t_dot[2] * t2 - t_dot[1] * t3));
        const doubles s_ddot0 = t6 - e[0] * t5;
        const doubles t7 = 0.5 * (t_dot[1] * cos_half_phi - (t_dot[0] * t3 - t_dot[2] * t1));
        const doubles s_ddot1 = t7 - e[1] * t5;
        const doubles t8 = 0.5 * (t_dot[2] * cos_half_phi - (t_dot[1] * t1 - t_dot[0] * t2));
        const doubles s_ddot2 = t8 - e[2] * t5;
        const doubles t9 = 0.5 * (t_dot[0] * t1 + t_dot[1] * t2 + t_dot[2] * t3);
        const doubles s_ddot3 = -(t9 + cos_half_phi * t4);
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, step4, 7, sizeof(double), copied.ahead);
        const doubles result4[] = {s_ddot0, s_ddot1, s_ddot2, s_ddot3, s_ddot4, s_ddot5, s_ddot6};
        if (dense4) {
            store_all(item4, step4, 7, result4);
        } else if (step4 == sizeof(double)) {
            PACKED(item4 + entries4[0], 0) = result4[0];
            PACKED(item4 + entries4[1], 0) = result4[1];
            PACKED(item4 + entries4[2], 0) = result4[2];
            PACKED(item4 + entries4[3], 0) = result4[3];
            PACKED(item4 + entries4[4], 0) = result4[4];
            PACKED(item4 + entries4[5], 0) = result4[5];
            PACKED(item4 + entries4[6], 0) = result4[6];
        } else {
            give_each(item4, entries4, step4, 7, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pose_acceleration_euler_rodrigues_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 7)
        && is_packed(6, 6, sizeof(double), steps[2], steps + 9)
        && is_packed(6, 6, sizeof(double), steps[3], steps + 11)
        && is_packed(7, 7, sizeof(double), steps[4], steps + 13)) {
        chasles_pose_acceleration_euler_rodrigues_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_pose_acceleration_euler_rodrigues_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_pose_acceleration_euler_rodrigues_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 5, entries0));
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
    const ptrdiff_t step4 = CHASLES_STEP(4, 7 * sizeof(float));
    ptrdiff_t entries4[7];
    const int dense4 = CHASLES_DENSE(find_entries(7, 7, sizeof(float), step4, steps + 13, entries4));
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
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats s_ddot4 = t_dot[3];
        const floats s_ddot5 = t_dot[4];
        const floats s_ddot6 = t_dot[5];
        const floats t1 = e[0] * sin_half_phi;
        const floats t2 = e[1] * sin_half_phi;
        const floats t3 = e[2] * sin_half_phi;
        const floats t4 = 0.25f * (t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
        const floats t5 = sin_half_phi * t4;
        const floats t6 = 0.5f * (t_dot[0] * cos_half_phi - (t_dot[2] * t2 - t_dot[1] * t3));
        const floats s_ddot0 = t6 - e[0] * t5;
        const floats t7 = 0.5f * (t_dot[1] * cos_half_phi - (t_dot[0] * t3 - t_dot[2] * t1));
        const floats s_ddot1 = t7 - e[1] * t5;
        const floats t8 = 0.5f * (t_dot[2] * cos_half_phi - (t_dot[1] * t1 - t_dot[0] * t2));
        const floats s_ddot2 = t8 - e[2] * t5;
        const floats t9 = 0.5f * (t_dot[0] * t1 + t_dot[1] * t2 + t_dot[2] * t3);
        const floats s_ddot3 = -(t9 + cos_half_phi * t4);
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, step4, 7, sizeof(float), copied.ahead);
        const floats result4[] = {s_ddot0, s_ddot1, s_ddot2, s_ddot3, s_ddot4, s_ddot5, s_ddot6};
        if (dense4) {
            store_allf(item4, step4, 7, result4);
        } else if (step4 == sizeof(float)) {
            PACKEDF(item4 + entries4[0], 0) = result4[0];
            PACKEDF(item4 + entries4[1], 0) = result4[1];
            PACKEDF(item4 + entries4[2], 0) = result4[2];
            PACKEDF(item4 + entries4[3], 0) = result4[3];
            PACKEDF(item4 + entries4[4], 0) = result4[4];
            PACKEDF(item4 + entries4[5], 0) = result4[5];
            PACKEDF(item4 + entries4[6], 0) = result4[6];
        } else {
            give_eachf(item4, entries4, step4, 7, result4);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pose_acceleration_euler_rodrigues_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 7)
        && is_packed(6, 6, sizeof(float), steps[2], steps + 9)
        && is_packed(6, 6, sizeof(float), steps[3], steps + 11)
        && is_packed(7, 7, sizeof(float), steps[4], steps + 13)) {
        chasles_pose_acceleration_euler_rodrigues_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_pose_acceleration_euler_rodrigues_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_twist_rate_from_pose_natural_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 7 * sizeof(double));
    ptrdiff_t entries2[7];
    const int dense2 = CHASLES_DENSE(find_entries(7, 7, sizeof(double), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 7 * sizeof(double));
    ptrdiff_t entries3[7];
    const int dense3 = CHASLES_DENSE(find_entries(7, 7, sizeof(double), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(double));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step4, steps + 13, entries4));
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
        } else if (step2 == sizeof(double)) {
            s_dot[0] = PACKED_IN(item2 + entries2[0], 0);
            s_dot[1] = PACKED_IN(item2 + entries2[1], 0);
            s_dot[2] = PACKED_IN(item2 + entries2[2], 0);
            s_dot[3] = PACKED_IN(item2 + entries2[3], 0);
        } else {
            doubles all[7];
            take_each(item2, entries2, step2, 7, all);
            s_dot[0] = all[0];
            s_dot[1] = all[1];
            s_dot[2] = all[2];
            s_dot[3] = all[3];
        }
        doubles s_ddot[7];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 7, copied.ahead);
        if (dense3) {
            load_4(item3 + 0 * sizeof(double), step3, &s_ddot[0]);
            load_3(item3 + 4 * sizeof(double), step3, &s_ddot[4]);
        } else if (step3 == sizeof(double)) {
            s_ddot[0] = PACKED_IN(item3 + entries3[0], 0);
            s_ddot[1] = PACKED_IN(item3 + entries3[1], 0);
            s_ddot[2] = PACKED_IN(item3 + entries3[2], 0);
            s_ddot[3] = PACKED_IN(item3 + entries3[3], 0);
            s_ddot[4] = PACKED_IN(item3 + entries3[4], 0);
            s_ddot[5] = PACKED_IN(item3 + entries3[5], 0);
            s_ddot[6] = PACKED_IN(item3 + entries3[6], 0);
        } else {
            doubles all[7];
            take_each(item3, entries3, step3, 7, all);
            s_ddot[0] = all[0];
            s_ddot[1] = all[1];
            s_ddot[2] = all[2];
            s_ddot[3] = all[3];
            s_ddot[4] = all[4];
            s_ddot[5] = all[5];
            s_ddot[6] = all[6];
        }
        const doubles sin_phi = sines[0][g];
        const doubles cos_phi = cosines[0][g];
        const doubles t_dot3 = s_ddot[4];
        const doubles t_dot4 = s_ddot[5];
        const doubles t_dot5 = s_ddot[6];
        const doubles t1 = 1.0 - cos_phi;
        const doubles t2 = s_ddot[0] * sin_phi + t1 * (e[1] * s_ddot[2] - e[2] * s_ddot[1]);
        const doubles t3 = s_ddot[1] * sin_phi + t1 * (e[2] * s_ddot[0] - e[0] * s_ddot[2]);
        const doubles t4 = s_ddot[2] * sin_phi + t1 * (e[0] * s_ddot[1] - e[1] * s_ddot[0]);
        const doubles t5 = s_dot[3] * (1.0 + cos_phi);
        const doubles t6 = s_dot[3] * sin_phi;
        const doubles t7 = s_dot[0] * t5 + (e[1] * s_dot[2] - e[2] * s_dot[1]) * t6;
        const doubles t_dot0 = t2 + e[0] * s_ddot[3] + t7;
        const doubles t8 = s_dot[1] * t5 + (e[2] * s_dot[0] - e[0] * s_dot[2]) * t6;
        const doubles t_dot1 = t3 + e[1] * s_ddot[3] + t8;
        const doubles t9 = s_dot[2] * t5 + (e[0] * s_dot[1] - e[1] * s_dot[0]) * t6;
        const doubles t_dot2 = t4 + e[2] * s_ddot[3] + t9;
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

void CHASLES_LEVELED(chasles_twist_rate_from_pose_natural_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 7)
        && is_packed(7, 7, sizeof(double), steps[2], steps + 9)
        && is_packed(7, 7, sizeof(double), steps[3], steps + 11)
        && is_packed(6, 6, sizeof(double), steps[4], steps + 13)) {
        chasles_twist_rate_from_pose_natural_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_twist_rate_from_pose_natural_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_twist_rate_from_pose_natural_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 7 * sizeof(float));
    ptrdiff_t entries2[7];
    const int dense2 = CHASLES_DENSE(find_entries(7, 7, sizeof(float), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 7 * sizeof(float));
    ptrdiff_t entries3[7];
    const int dense3 = CHASLES_DENSE(find_entries(7, 7, sizeof(float), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(float));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step4, steps + 13, entries4));
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
        } else if (step2 == sizeof(float)) {
            s_dot[0] = PACKEDF_IN(item2 + entries2[0], 0);
            s_dot[1] = PACKEDF_IN(item2 + entries2[1], 0);
            s_dot[2] = PACKEDF_IN(item2 + entries2[2], 0);
            s_dot[3] = PACKEDF_IN(item2 + entries2[3], 0);
        } else {
            floats all[7];
            take_eachf(item2, entries2, step2, 7, all);
            s_dot[0] = all[0];
            s_dot[1] = all[1];
            s_dot[2] = all[2];
            s_dot[3] = all[3];
        }
        floats s_ddot[7];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 7, copied.ahead);
        if (dense3) {
            load_4f(item3 + 0 * sizeof(float), step3, &s_ddot[0]);
            load_3f(item3 + 4 * sizeof(float), step3, &s_ddot[4]);
        } else if (step3 == sizeof(float)) {
            s_ddot[0] = PACKEDF_IN(item3 + entries3[0], 0);
            s_ddot[1] = PACKEDF_IN(item3 + entries3[1], 0);
            s_ddot[2] = PACKEDF_IN(item3 + entries3[2], 0);
            s_ddot[3] = PACKEDF_IN(item3 + entries3[3], 0);
            s_ddot[4] = PACKEDF_IN(item3 + entries3[4], 0);
            s_ddot[5] = PACKEDF_IN(item3 + entries3[5], 0);
            s_ddot[6] = PACKEDF_IN(item3 + entries3[6], 0);
        } else {
            floats all[7];
            take_eachf(item3, entries3, step3, 7, all);
            s_ddot[0] = all[0];
            s_ddot[1] = all[1];
            s_ddot[2] = all[2];
            s_ddot[3] = all[3];
            s_ddot[4] = all[4];
            s_ddot[5] = all[5];
            s_ddot[6] = all[6];
        }
        const floats sin_phi = sines[0][g];
        const floats cos_phi = cosines[0][g];
        const floats t_dot3 = s_ddot[4];
        const floats t_dot4 = s_ddot[5];
        const floats t_dot5 = s_ddot[6];
        const floats t1 = 1.0f - cos_phi;
        const floats t2 = s_ddot[0] * sin_phi + t1 * (e[1] * s_ddot[2] - e[2] * s_ddot[1]);
        const floats t3 = s_ddot[1] * sin_phi + t1 * (e[2] * s_ddot[0] - e[0] * s_ddot[2]);
        const floats t4 = s_ddot[2] * sin_phi + t1 * (e[0] * s_ddot[1] - e[1] * s_ddot[0]);
        const floats t5 = s_dot[3] * (1.0f + cos_phi);
        const floats t6 = s_dot[3] * sin_phi;
        const floats t7 = s_dot[0] * t5 + (e[1] * s_dot[2] - e[2] * s_dot[1]) * t6;
        const floats t_dot0 = t2 + e[0] * s_ddot[3] + t7;
        const floats t8 = s_dot[1] * t5 + (e[2] * s_dot[0] - e[0] * s_dot[2]) * t6;
        const floats t_dot1 = t3 + e[1] * s_ddot[3] + t8;
        const floats t9 = s_dot[2] * t5 + (e[0] * s_dot[1] - e[1] * s_dot[0]) * t6;
        const floats t_dot2 = t4 + e[2] * s_ddot[3] + t9;
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

void CHASLES_LEVELED(chasles_twist_rate_from_pose_natural_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 7)
        && is_packed(7, 7, sizeof(float), steps[2], steps + 9)
        && is_packed(7, 7, sizeof(float), steps[3], steps + 11)
        && is_packed(6, 6, sizeof(float), steps[4], steps + 13)) {
        chasles_twist_rate_from_pose_natural_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_twist_rate_from_pose_natural_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_twist_rate_from_pose_linear_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 7 * sizeof(double));
    ptrdiff_t entries2[7];
    const int dense2 = CHASLES_DENSE(find_entries(7, 7, sizeof(double), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 7 * sizeof(double));
    ptrdiff_t entries3[7];
    const int dense3 = CHASLES_DENSE(find_entries(7, 7, sizeof(double), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(double));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step4, steps + 13, entries4));
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
        } else if (step2 == sizeof(double)) {
            s_dot[0] = PACKED_IN(item2 + entries2[0], 0);
            s_dot[1] = PACKED_IN(item2 + entries2[1], 0);
            s_dot[2] = PACKED_IN(item2 + entries2[2], 0);
            s_dot[3] = PACKED_IN(item2 + entries2[3], 0);
        } else {
            doubles all[7];
            take_each(item2, entries2, step2, 7, all);
            s_dot[0] = all[0];
            s_dot[1] = all[1];
            s_dot[2] = all[2];
            s_dot[3] = all[3];
        }
        doubles s_ddot[7];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 7, copied.ahead);
        if (dense3) {
            load_4(item3 + 0 * sizeof(double), step3, &s_ddot[0]);
            load_3(item3 + 4 * sizeof(double), step3, &s_ddot[4]);
        } else if (step3 == sizeof(double)) {
            s_ddot[0] = PACKED_IN(item3 + entries3[0], 0);
            s_ddot[1] = PACKED_IN(item3 + entries3[1], 0);
            s_ddot[2] = PACKED_IN(item3 + entries3[2], 0);
            s_ddot[3] = PACKED_IN(item3 + entries3[3], 0);
            s_ddot[4] = PACKED_IN(item3 + entries3[4], 0);
            s_ddot[5] = PACKED_IN(item3 + entries3[5], 0);
            s_ddot[6] = PACKED_IN(item3 + entries3[6], 0);
        } else {
            doubles all[7];
            take_each(item3, entries3, step3, 7, all);
            s_ddot[0] = all[0];
            s_ddot[1] = all[1];
            s_ddot[2] = all[2];
            s_ddot[3] = all[3];
            s_ddot[4] = all[4];
            s_ddot[5] = all[5];
            s_ddot[6] = all[6];
        }
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles t_dot3 = s_ddot[4];
        const doubles t_dot4 = s_ddot[5];
        const doubles t_dot5 = s_ddot[6];
        const doubles t1 = choose(equal(cos_half_phi, spread(0.0)), spread(0.0), sin_half_phi);
        const doubles t2 = t1 / cos_half_phi;
        const doubles t3 = e[0] * t2;
        const doubles t4 = e[1] * t2;
        const doubles t5 = e[2] * t2;
        const doubles t6 = 2.0 * (cos_half_phi * cos_half_phi);
        const doubles t7 = choose(equal(t6, spread(0.0)), spread(0.0), s_dot[3]) / t6;
        const doubles t8 = (s_dot[0] - s_dot[1] * t5 + s_dot[2] * t4 - s_dot[3] * t3) * t7;
        const doubles t_dot0 = s_ddot[0] - s_ddot[1] * t5 + s_ddot[2] * t4 - s_ddot[3] * t3 - t8;
        const doubles t9 = (s_dot[1] + s_dot[0] * t5 - s_dot[2] * t3 - s_dot[3] * t4) * t7;
        const doubles t_dot1 = s_ddot[1] + s_ddot[0] * t5 - s_ddot[2] * t3 - s_ddot[3] * t4 - t9;
        const doubles t10 = (s_dot[2] + (s_dot[1] * t3 - s_dot[0] * t4) - s_dot[3] * t5) * t7;
        const doubles t_dot2 = s_ddot[2] + (s_ddot[1] * t3 - s_ddot[0] * t4) - s_ddot[3] * t5 - t10;
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

void CHASLES_LEVELED(chasles_twist_rate_from_pose_linear_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_twist_rate_from_pose_linear_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_twist_rate_from_pose_linear_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 7 * sizeof(float));
    ptrdiff_t entries2[7];
    const int dense2 = CHASLES_DENSE(find_entries(7, 7, sizeof(float), step2, steps + 9, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 7 * sizeof(float));
    ptrdiff_t entries3[7];
    const int dense3 = CHASLES_DENSE(find_entries(7, 7, sizeof(float), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(float));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step4, steps + 13, entries4));
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
        } else if (step2 == sizeof(float)) {
            s_dot[0] = PACKEDF_IN(item2 + entries2[0], 0);
            s_dot[1] = PACKEDF_IN(item2 + entries2[1], 0);
            s_dot[2] = PACKEDF_IN(item2 + entries2[2], 0);
            s_dot[3] = PACKEDF_IN(item2 + entries2[3], 0);
        } else {
            floats all[7];
            take_eachf(item2, entries2, step2, 7, all);
            s_dot[0] = all[0];
            s_dot[1] = all[1];
            s_dot[2] = all[2];
            s_dot[3] = all[3];
        }
        floats s_ddot[7];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 7, copied.ahead);
        if (dense3) {
            load_4f(item3 + 0 * sizeof(float), step3, &s_ddot[0]);
            load_3f(item3 + 4 * sizeof(float), step3, &s_ddot[4]);
        } else if (step3 == sizeof(float)) {
            s_ddot[0] = PACKEDF_IN(item3 + entries3[0], 0);
            s_ddot[1] = PACKEDF_IN(item3 + entries3[1], 0);
            s_ddot[2] = PACKEDF_IN(item3 + entries3[2], 0);
            s_ddot[3] = PACKEDF_IN(item3 + entries3[3], 0);
            s_ddot[4] = PACKEDF_IN(item3 + entries3[4], 0);
            s_ddot[5] = PACKEDF_IN(item3 + entries3[5], 0);
            s_ddot[6] = PACKEDF_IN(item3 + entries3[6], 0);
        } else {
            floats all[7];
            take_eachf(item3, entries3, step3, 7, all);
            s_ddot[0] = all[0];
            s_ddot[1] = all[1];
            s_ddot[2] = all[2];
            s_ddot[3] = all[3];
            s_ddot[4] = all[4];
            s_ddot[5] = all[5];
            s_ddot[6] = all[6];
        }
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats t_dot3 = s_ddot[4];
        const floats t_dot4 = s_ddot[5];
        const floats t_dot5 = s_ddot[6];
        const truthsf t1 = equalf(cos_half_phi, spreadf(0.0f));
        const floats t2 = choosef(t1, spreadf(0.0f), sin_half_phi) / cos_half_phi;
        const floats t3 = e[0] * t2;
        const floats t4 = e[1] * t2;
        const floats t5 = e[2] * t2;
        const floats t6 = 2.0f * (cos_half_phi * cos_half_phi);
        const floats t7 = choosef(equalf(t6, spreadf(0.0f)), spreadf(0.0f), s_dot[3]) / t6;
        const floats t8 = (s_dot[0] - s_dot[1] * t5 + s_dot[2] * t4 - s_dot[3] * t3) * t7;
        const floats t_dot0 = s_ddot[0] - s_ddot[1] * t5 + s_ddot[2] * t4 - s_ddot[3] * t3 - t8;
        const floats t9 = (s_dot[1] + s_dot[0] * t5 - s_dot[2] * t3 - s_dot[3] * t4) * t7;
        const floats t_dot1 = s_ddot[1] + s_ddot[0] * t5 - s_ddot[2] * t3 - s_ddot[3] * t4 - t9;
        const floats t10 = (s_dot[2] + (s_dot[1] * t3 - s_dot[0] * t4) - s_dot[3] * t5) * t7;
        const floats t_dot2 = s_ddot[2] + (s_ddot[1] * t3 - s_ddot[0] * t4) - s_ddot[3] * t5 - t10;
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

void CHASLES_LEVELED(chasles_twist_rate_from_pose_linear_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    chasles_twist_rate_from_pose_linear_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_twist_rate_from_pose_euler_rodrigues_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 7 * sizeof(double));
    ptrdiff_t entries3[7];
    const int dense3 = CHASLES_DENSE(find_entries(7, 7, sizeof(double), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(double));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(double), step4, steps + 13, entries4));
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
        doubles s_ddot[7];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 7, copied.ahead);
        if (dense3) {
            load_4(item3 + 0 * sizeof(double), step3, &s_ddot[0]);
            load_3(item3 + 4 * sizeof(double), step3, &s_ddot[4]);
        } else if (step3 == sizeof(double)) {
            s_ddot[0] = PACKED_IN(item3 + entries3[0], 0);
            s_ddot[1] = PACKED_IN(item3 + entries3[1], 0);
            s_ddot[2] = PACKED_IN(item3 + entries3[2], 0);
            s_ddot[3] = PACKED_IN(item3 + entries3[3], 0);
            s_ddot[4] = PACKED_IN(item3 + entries3[4], 0);
            s_ddot[5] = PACKED_IN(item3 + entries3[5], 0);
            s_ddot[6] = PACKED_IN(item3 + entries3[6], 0);
        } else {
            doubles all[7];
            take_each(item3, entries3, step3, 7, all);
            s_ddot[0] = all[0];
            s_ddot[1] = all[1];
            s_ddot[2] = all[2];
            s_ddot[3] = all[3];
            s_ddot[4] = all[4];
            s_ddot[5] = all[5];
            s_ddot[6] = all[6];
        }
        const doubles sin_half_phi = sines[0][g];
        const doubles cos_half_phi = cosines[0][g];
        const doubles t_dot3 = s_ddot[4];
        const doubles t_dot4 = s_ddot[5];
        const doubles t_dot5 = s_ddot[6];
        const doubles t1 = 2.0 * cos_half_phi;
        const doubles t2 = 2.0 * sin_half_phi;
        const doubles t3 = e[0] * t2;
        const doubles t4 = e[1] * t2;
        const doubles t5 = e[2] * t2;
        const doubles t_dot0 = s_ddot[0] * t1 - s_ddot[1] * t5 + s_ddot[2] * t4 - s_ddot[3] * t3;
        const doubles t_dot1 = s_ddot[0] * t5 + s_ddot[1] * t1 - s_ddot[2] * t3 - s_ddot[3] * t4;
        const doubles t_dot2 = s_ddot[1] * t3 - s_ddot[0] * t4 + s_ddot[2] * t1 - s_ddot[3] * t5;
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

void CHASLES_LEVELED(chasles_twist_rate_from_pose_euler_rodrigues_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(double), steps[1], steps + 7)
        && is_packed(7, 7, sizeof(double), steps[2], steps + 9)
        && is_packed(7, 7, sizeof(double), steps[3], steps + 11)
        && is_packed(6, 6, sizeof(double), steps[4], steps + 13)) {
        chasles_twist_rate_from_pose_euler_rodrigues_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_twist_rate_from_pose_euler_rodrigues_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_twist_rate_from_pose_euler_rodrigues_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 5, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 7 * sizeof(float));
    ptrdiff_t entries3[7];
    const int dense3 = CHASLES_DENSE(find_entries(7, 7, sizeof(float), step3, steps + 11, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(float));
    ptrdiff_t entries4[6];
    const int dense4 = CHASLES_DENSE(find_entries(6, 6, sizeof(float), step4, steps + 13, entries4));
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
        floats s_ddot[7];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 7, copied.ahead);
        if (dense3) {
            load_4f(item3 + 0 * sizeof(float), step3, &s_ddot[0]);
            load_3f(item3 + 4 * sizeof(float), step3, &s_ddot[4]);
        } else if (step3 == sizeof(float)) {
            s_ddot[0] = PACKEDF_IN(item3 + entries3[0], 0);
            s_ddot[1] = PACKEDF_IN(item3 + entries3[1], 0);
            s_ddot[2] = PACKEDF_IN(item3 + entries3[2], 0);
            s_ddot[3] = PACKEDF_IN(item3 + entries3[3], 0);
            s_ddot[4] = PACKEDF_IN(item3 + entries3[4], 0);
            s_ddot[5] = PACKEDF_IN(item3 + entries3[5], 0);
            s_ddot[6] = PACKEDF_IN(item3 + entries3[6], 0);
        } else {
            floats all[7];
            take_eachf(item3, entries3, step3, 7, all);
            s_ddot[0] = all[0];
            s_ddot[1] = all[1];
            s_ddot[2] = all[2];
            s_ddot[3] = all[3];
            s_ddot[4] = all[4];
            s_ddot[5] = all[5];
            s_ddot[6] = all[6];
        }
        const floats sin_half_phi = sines[0][g];
        const floats cos_half_phi = cosines[0][g];
        const floats t_dot3 = s_ddot[4];
        const floats t_dot4 = s_ddot[5];
        const floats t_dot5 = s_ddot[6];
        const floats t1 = 2.0f * cos_half_phi;
        const floats t2 = 2.0f * sin_half_phi;
        const floats t3 = e[0] * t2;
        const floats t4 = e[1] * t2;
        const floats t5 = e[2] * t2;
        const floats t_dot0 = s_ddot[0] * t1 - s_ddot[1] * t5 + s_ddot[2] * t4 - s_ddot[3] * t3;
        const floats t_dot1 = s_ddot[0] * t5 + s_ddot[1] * t1 - s_ddot[2] * t3 - s_ddot[3] * t4;
        const floats t_dot2 = s_ddot[1] * t3 - s_ddot[0] * t4 + s_ddot[2] * t1 - s_ddot[3] * t5;
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

void CHASLES_LEVELED(chasles_twist_rate_from_pose_euler_rodrigues_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 5)
        && is_packed(1, 1, sizeof(float), steps[1], steps + 7)
        && is_packed(7, 7, sizeof(float), steps[2], steps + 9)
        && is_packed(7, 7, sizeof(float), steps[3], steps + 11)
        && is_packed(6, 6, sizeof(float), steps[4], steps + 13)) {
        chasles_twist_rate_from_pose_euler_rodrigues_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_twist_rate_from_pose_euler_rodrigues_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

#else

void CHASLES_LEVELED(chasles_angular_acceleration_matrix_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_angular_acceleration_matrix(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_angular_acceleration_matrix_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_angular_acceleration_matrixf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_acceleration_of_point_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_acceleration_of_point(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (const double *)(at[4] + i * steps[4]),
            (double *)(at[5] + i * steps[5]));
    }
}

void CHASLES_LEVELED(chasles_acceleration_of_point_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_acceleration_of_pointf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (const float *)(at[4] + i * steps[4]),
            (float *)(at[5] + i * steps[5]));
    }
}

void CHASLES_LEVELED(chasles_natural_rate_matrix_dot_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_natural_rate_matrix_dot(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_natural_rate_matrix_dot_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_natural_rate_matrix_dotf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_linear_rate_matrix_dot_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_linear_rate_matrix_dot(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_linear_rate_matrix_dot_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_linear_rate_matrix_dotf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_rate_matrix_dot_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rodrigues_rate_matrix_dot(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_rate_matrix_dot_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rodrigues_rate_matrix_dotf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_natural_velocity_matrix_dot_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_natural_velocity_matrix_dot(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_natural_velocity_matrix_dot_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_natural_velocity_matrix_dotf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_linear_velocity_matrix_dot_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_linear_velocity_matrix_dot(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_linear_velocity_matrix_dot_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_linear_velocity_matrix_dotf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_velocity_matrix_dot_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rodrigues_velocity_matrix_dot(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_euler_rodrigues_velocity_matrix_dot_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_euler_rodrigues_velocity_matrix_dotf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_pose_acceleration_natural_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_pose_acceleration_natural(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_pose_acceleration_natural_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_pose_acceleration_naturalf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_pose_acceleration_linear_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_pose_acceleration_linear(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_pose_acceleration_linear_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_pose_acceleration_linearf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_pose_acceleration_euler_rodrigues_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_pose_acceleration_euler_rodrigues(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_pose_acceleration_euler_rodrigues_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_pose_acceleration_euler_rodriguesf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_twist_rate_from_pose_natural_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_twist_rate_from_pose_natural(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_twist_rate_from_pose_natural_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_twist_rate_from_pose_naturalf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_twist_rate_from_pose_linear_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_twist_rate_from_pose_linear(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_twist_rate_from_pose_linear_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_twist_rate_from_pose_linearf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_twist_rate_from_pose_euler_rodrigues_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_twist_rate_from_pose_euler_rodrigues(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_twist_rate_from_pose_euler_rodrigues_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_twist_rate_from_pose_euler_rodriguesf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

#endif
