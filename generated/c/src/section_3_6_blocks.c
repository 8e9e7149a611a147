/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_6, for batches. Made by `chasles emit`; not to be edited by hand.
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

CHASLES_INLINE void chasles_moving_frame_velocity_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 6, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 8, entries1));
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
        doubles o_dot[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &o_dot[0]);
        } else if (step0 == sizeof(double)) {
            o_dot[0] = PACKED_IN(item0 + entries0[0], 0);
            o_dot[1] = PACKED_IN(item0 + entries0[1], 0);
            o_dot[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            o_dot[0] = all[0];
            o_dot[1] = all[1];
            o_dot[2] = all[2];
        }
        doubles Q[9];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 9, copied.ahead);
        if (dense1) {
            load_4(item1 + 0 * sizeof(double), step1, &Q[0]);
            load_4(item1 + 4 * sizeof(double), step1, &Q[4]);
            load_1(item1 + 8 * sizeof(double), step1, &Q[8]);
        } else if (step1 == sizeof(double)) {
            Q[0] = PACKED_IN(item1 + entries1[0], 0);
            Q[1] = PACKED_IN(item1 + entries1[1], 0);
            Q[2] = PACKED_IN(item1 + entries1[2], 0);
            Q[3] = PACKED_IN(item1 + entries1[3], 0);
            Q[4] = PACKED_IN(item1 + entries1[4], 0);
            Q[5] = PACKED_IN(item1 + entries1[5], 0);
            Q[6] = PACKED_IN(item1 + entries1[6], 0);
            Q[7] = PACKED_IN(item1 + entries1[7], 0);
            Q[8] = PACKED_IN(item1 + entries1[8], 0);
        } else {
            doubles all[9];
            take_each(item1, entries1, step1, 9, all);
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
        doubles rho[3];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3(item3 + 0 * sizeof(double), step3, &rho[0]);
        } else if (step3 == sizeof(double)) {
            rho[0] = PACKED_IN(item3 + entries3[0], 0);
            rho[1] = PACKED_IN(item3 + entries3[1], 0);
            rho[2] = PACKED_IN(item3 + entries3[2], 0);
        } else {
            doubles all[3];
            take_each(item3, entries3, step3, 3, all);
            rho[0] = all[0];
            rho[1] = all[1];
            rho[2] = all[2];
        }
        doubles rho_dot[3];
        const char *const item4 = at4 + g * LANES * step4;
        prefetch(item4, 3, copied.ahead);
        if (dense4) {
            load_3(item4 + 0 * sizeof(double), step4, &rho_dot[0]);
        } else if (step4 == sizeof(double)) {
            rho_dot[0] = PACKED_IN(item4 + entries4[0], 0);
            rho_dot[1] = PACKED_IN(item4 + entries4[1], 0);
            rho_dot[2] = PACKED_IN(item4 + entries4[2], 0);
        } else {
            doubles all[3];
            take_each(item4, entries4, step4, 3, all);
            rho_dot[0] = all[0];
            rho_dot[1] = all[1];
            rho_dot[2] = all[2];
        }
        const doubles t1 = Q[0] * rho[0] + Q[1] * rho[1] + Q[2] * rho[2];
        const doubles t2 = Q[3] * rho[0] + Q[4] * rho[1] + Q[5] * rho[2];
        const doubles t3 = Q[6] * rho[0] + Q[7] * rho[1] + Q[8] * rho[2];
        const doubles t4 = Q[0] * rho_dot[0] + Q[1] * rho_dot[1] + Q[2] * rho_dot[2];
        const doubles p_dot0 = o_dot[0] + (omega[1] * t3 - omega[2] * t2) + t4;
        const doubles t5 = Q[3] * rho_dot[0] + Q[4] * rho_dot[1] + Q[5] * rho_dot[2];
        const doubles p_dot1 = o_dot[1] + (omega[2] * t1 - omega[0] * t3) + t5;
        const doubles t6 = Q[6] * rho_dot[0] + Q[7] * rho_dot[1] + Q[8] * rho_dot[2];
        const doubles p_dot2 = o_dot[2] + (omega[0] * t2 - omega[1] * t1) + t6;
        char *const item5 = at5 + g * LANES * step5;
        prefetch_to_write(item5, step5, 3, sizeof(double), copied.ahead);
        const doubles result5[] = {p_dot0, p_dot1, p_dot2};
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

void CHASLES_LEVELED(chasles_moving_frame_velocity_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 6)
        && is_packed(9, 3, sizeof(double), steps[1], steps + 8)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 10)
        && is_packed(3, 3, sizeof(double), steps[3], steps + 12)
        && is_packed(3, 3, sizeof(double), steps[4], steps + 14)
        && is_packed(3, 3, sizeof(double), steps[5], steps + 16)) {
        chasles_moving_frame_velocity_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_moving_frame_velocity_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_moving_frame_velocity_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 6, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 8, entries1));
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
        floats o_dot[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &o_dot[0]);
        } else if (step0 == sizeof(float)) {
            o_dot[0] = PACKEDF_IN(item0 + entries0[0], 0);
            o_dot[1] = PACKEDF_IN(item0 + entries0[1], 0);
            o_dot[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            o_dot[0] = all[0];
            o_dot[1] = all[1];
            o_dot[2] = all[2];
        }
        floats Q[9];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 9, copied.ahead);
        if (dense1) {
            load_4f(item1 + 0 * sizeof(float), step1, &Q[0]);
            load_4f(item1 + 4 * sizeof(float), step1, &Q[4]);
            load_1f(item1 + 8 * sizeof(float), step1, &Q[8]);
        } else if (step1 == sizeof(float)) {
            Q[0] = PACKEDF_IN(item1 + entries1[0], 0);
            Q[1] = PACKEDF_IN(item1 + entries1[1], 0);
            Q[2] = PACKEDF_IN(item1 + entries1[2], 0);
            Q[3] = PACKEDF_IN(item1 + entries1[3], 0);
            Q[4] = PACKEDF_IN(item1 + entries1[4], 0);
            Q[5] = PACKEDF_IN(item1 + entries1[5], 0);
            Q[6] = PACKEDF_IN(item1 + entries1[6], 0);
            Q[7] = PACKEDF_IN(item1 + entries1[7], 0);
            Q[8] = PACKEDF_IN(item1 + entries1[8], 0);
        } else {
            floats all[9];
            take_eachf(item1, entries1, step1, 9, all);
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
        floats rho[3];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3f(item3 + 0 * sizeof(float), step3, &rho[0]);
        } else if (step3 == sizeof(float)) {
            rho[0] = PACKEDF_IN(item3 + entries3[0], 0);
            rho[1] = PACKEDF_IN(item3 + entries3[1], 0);
            rho[2] = PACKEDF_IN(item3 + entries3[2], 0);
        } else {
            floats all[3];
            take_eachf(item3, entries3, step3, 3, all);
            rho[0] = all[0];
            rho[1] = all[1];
            rho[2] = all[2];
        }
        floats rho_dot[3];
        const char *const item4 = at4 + g * LANESF * step4;
        prefetch(item4, 3, copied.ahead);
        if (dense4) {
            load_3f(item4 + 0 * sizeof(float), step4, &rho_dot[0]);
        } else if (step4 == sizeof(float)) {
            rho_dot[0] = PACKEDF_IN(item4 + entries4[0], 0);
            rho_dot[1] = PACKEDF_IN(item4 + entries4[1], 0);
            rho_dot[2] = PACKEDF_IN(item4 + entries4[2], 0);
        } else {
            floats all[3];
            take_eachf(item4, entries4, step4, 3, all);
            rho_dot[0] = all[0];
            rho_dot[1] = all[1];
            rho_dot[2] = all[2];
        }
        const floats t1 = Q[0] * rho[0] + Q[1] * rho[1] + Q[2] * rho[2];
        const floats t2 = Q[3] * rho[0] + Q[4] * rho[1] + Q[5] * rho[2];
        const floats t3 = Q[6] * rho[0] + Q[7] * rho[1] + Q[8] * rho[2];
        const floats t4 = Q[0] * rho_dot[0] + Q[1] * rho_dot[1] + Q[2] * rho_dot[2];
        const floats p_dot0 = o_dot[0] + (omega[1] * t3 - omega[2] * t2) + t4;
        const floats t5 = Q[3] * rho_dot[0] + Q[4] * rho_dot[1] + Q[5] * rho_dot[2];
        const floats p_dot1 = o_dot[1] + (omega[2] * t1 - omega[0] * t3) + t5;
        const floats t6 = Q[6] * rho_dot[0] + Q[7] * rho_dot[1] + Q[8] * rho_dot[2];
        const floats p_dot2 = o_dot[2] + (omega[0] * t2 - omega[1] * t1) + t6;
        char *const item5 = at5 + g * LANESF * step5;
        prefetch_to_write(item5, step5, 3, sizeof(float), copied.ahead);
        const floats result5[] = {p_dot0, p_dot1, p_dot2};
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

void CHASLES_LEVELED(chasles_moving_frame_velocity_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 6)
        && is_packed(9, 3, sizeof(float), steps[1], steps + 8)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 10)
        && is_packed(3, 3, sizeof(float), steps[3], steps + 12)
        && is_packed(3, 3, sizeof(float), steps[4], steps + 14)
        && is_packed(3, 3, sizeof(float), steps[5], steps + 16)) {
        chasles_moving_frame_velocity_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_moving_frame_velocity_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_moving_frame_acceleration_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step0, steps + 8, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step1, steps + 10, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step2, steps + 12, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step3, steps + 14, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(double));
    ptrdiff_t entries4[3];
    const int dense4 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step4, steps + 16, entries4));
    char *const at5 = at[5];
    const ptrdiff_t step5 = CHASLES_STEP(5, 3 * sizeof(double));
    ptrdiff_t entries5[3];
    const int dense5 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step5, steps + 18, entries5));
    char *const at6 = at[6];
    const ptrdiff_t step6 = CHASLES_STEP(6, 3 * sizeof(double));
    ptrdiff_t entries6[3];
    const int dense6 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step6, steps + 20, entries6));
    char *const at7 = at[7];
    const ptrdiff_t step7 = CHASLES_STEP(7, 3 * sizeof(double));
    ptrdiff_t entries7[3];
    const int dense7 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step7, steps + 22, entries7));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles o_ddot[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3(item0 + 0 * sizeof(double), step0, &o_ddot[0]);
        } else if (step0 == sizeof(double)) {
            o_ddot[0] = PACKED_IN(item0 + entries0[0], 0);
            o_ddot[1] = PACKED_IN(item0 + entries0[1], 0);
            o_ddot[2] = PACKED_IN(item0 + entries0[2], 0);
        } else {
            doubles all[3];
            take_each(item0, entries0, step0, 3, all);
            o_ddot[0] = all[0];
            o_ddot[1] = all[1];
            o_ddot[2] = all[2];
        }
        doubles Q[9];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 9, copied.ahead);
        if (dense1) {
            load_4(item1 + 0 * sizeof(double), step1, &Q[0]);
            load_4(item1 + 4 * sizeof(double), step1, &Q[4]);
            load_1(item1 + 8 * sizeof(double), step1, &Q[8]);
        } else if (step1 == sizeof(double)) {
            Q[0] = PACKED_IN(item1 + entries1[0], 0);
            Q[1] = PACKED_IN(item1 + entries1[1], 0);
            Q[2] = PACKED_IN(item1 + entries1[2], 0);
            Q[3] = PACKED_IN(item1 + entries1[3], 0);
            Q[4] = PACKED_IN(item1 + entries1[4], 0);
            Q[5] = PACKED_IN(item1 + entries1[5], 0);
            Q[6] = PACKED_IN(item1 + entries1[6], 0);
            Q[7] = PACKED_IN(item1 + entries1[7], 0);
            Q[8] = PACKED_IN(item1 + entries1[8], 0);
        } else {
            doubles all[9];
            take_each(item1, entries1, step1, 9, all);
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
        doubles omega_dot[3];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3(item3 + 0 * sizeof(double), step3, &omega_dot[0]);
        } else if (step3 == sizeof(double)) {
            omega_dot[0] = PACKED_IN(item3 + entries3[0], 0);
            omega_dot[1] = PACKED_IN(item3 + entries3[1], 0);
            omega_dot[2] = PACKED_IN(item3 + entries3[2], 0);
        } else {
            doubles all[3];
            take_each(item3, entries3, step3, 3, all);
            omega_dot[0] = all[0];
            omega_dot[1] = all[1];
            omega_dot[2] = all[2];
        }
        doubles rho[3];
        const char *const item4 = at4 + g * LANES * step4;
        prefetch(item4, 3, copied.ahead);
        if (dense4) {
            load_3(item4 + 0 * sizeof(double), step4, &rho[0]);
        } else if (step4 == sizeof(double)) {
            rho[0] = PACKED_IN(item4 + entries4[0], 0);
            rho[1] = PACKED_IN(item4 + entries4[1], 0);
            rho[2] = PACKED_IN(item4 + entries4[2], 0);
        } else {
            doubles all[3];
            take_each(item4, entries4, step4, 3, all);
            rho[0] = all[0];
            rho[1] = all[1];
            rho[2] = all[2];
        }
        doubles rho_dot[3];
        const char *const item5 = at5 + g * LANES * step5;
        prefetch(item5, 3, copied.ahead);
        if (dense5) {
            load_3(item5 + 0 * sizeof(double), step5, &rho_dot[0]);
        } else if (step5 == sizeof(double)) {
            rho_dot[0] = PACKED_IN(item5 + entries5[0], 0);
            rho_dot[1] = PACKED_IN(item5 + entries5[1], 0);
            rho_dot[2] = PACKED_IN(item5 + entries5[2], 0);
        } else {
            doubles all[3];
            take_each(item5, entries5, step5, 3, all);
            rho_dot[0] = all[0];
            rho_dot[1] = all[1];
            rho_dot[2] = all[2];
        }
        doubles rho_ddot[3];
        const char *const item6 = at6 + g * LANES * step6;
        prefetch(item6, 3, copied.ahead);
        if (dense6) {
            load_3(item6 + 0 * sizeof(double), step6, &rho_ddot[0]);
        } else if (step6 == sizeof(double)) {
            rho_ddot[0] = PACKED_IN(item6 + entries6[0], 0);
            rho_ddot[1] = PACKED_IN(item6 + entries6[1], 0);
            rho_ddot[2] = PACKED_IN(item6 + entries6[2], 0);
        } else {
            doubles all[3];
            take_each(item6, entries6, step6, 3, all);
            rho_ddot[0] = all[0];
            rho_ddot[1] = all[1];
            rho_ddot[2] = all[2];
        }
        const doubles t1 = Q[0] * rho[0] + Q[1] * rho[1] + Q[2] * rho[2];
        const doubles t2 = Q[3] * rho[0] + Q[4] * rho[1] + Q[5] * rho[2];
        const doubles t3 = Q[6] * rho[0] + Q[7] * rho[1] + Q[8] * rho[2];
        const doubles t4 = 2.0 * (Q[0] * rho_dot[0] + Q[1] * rho_dot[1] + Q[2] * rho_dot[2]);
        const doubles t5 = omega[1] * t3 - omega[2] * t2 + t4;
        const doubles t6 = 2.0 * (Q[3] * rho_dot[0] + Q[4] * rho_dot[1] + Q[5] * rho_dot[2]);
        const doubles t7 = omega[2] * t1 - omega[0] * t3 + t6;
        const doubles t8 = 2.0 * (Q[6] * rho_dot[0] + Q[7] * rho_dot[1] + Q[8] * rho_dot[2]);
        const doubles t9 = omega[0] * t2 - omega[1] * t1 + t8;
        const doubles t10 = o_ddot[0] + (omega_dot[1] * t3 - omega_dot[2] * t2);
        const doubles t11 = o_ddot[1] + (omega_dot[2] * t1 - omega_dot[0] * t3);
        const doubles t12 = o_ddot[2] + (omega_dot[0] * t2 - omega_dot[1] * t1);
        const doubles t13 = Q[0] * rho_ddot[0] + Q[1] * rho_ddot[1] + Q[2] * rho_ddot[2];
        const doubles p_ddot0 = t10 + (omega[1] * t9 - omega[2] * t7) + t13;
        const doubles t14 = Q[3] * rho_ddot[0] + Q[4] * rho_ddot[1] + Q[5] * rho_ddot[2];
        const doubles p_ddot1 = t11 + (omega[2] * t5 - omega[0] * t9) + t14;
        const doubles t15 = Q[6] * rho_ddot[0] + Q[7] * rho_ddot[1] + Q[8] * rho_ddot[2];
        const doubles p_ddot2 = t12 + (omega[0] * t7 - omega[1] * t5) + t15;
        char *const item7 = at7 + g * LANES * step7;
        prefetch_to_write(item7, step7, 3, sizeof(double), copied.ahead);
        const doubles result7[] = {p_ddot0, p_ddot1, p_ddot2};
        if (dense7) {
            store_all(item7, step7, 3, result7);
        } else if (step7 == sizeof(double)) {
            PACKED(item7 + entries7[0], 0) = result7[0];
            PACKED(item7 + entries7[1], 0) = result7[1];
            PACKED(item7 + entries7[2], 0) = result7[2];
        } else {
            give_each(item7, entries7, step7, 3, result7);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_moving_frame_acceleration_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(double), steps[0], steps + 8)
        && is_packed(9, 3, sizeof(double), steps[1], steps + 10)
        && is_packed(3, 3, sizeof(double), steps[2], steps + 12)
        && is_packed(3, 3, sizeof(double), steps[3], steps + 14)
        && is_packed(3, 3, sizeof(double), steps[4], steps + 16)
        && is_packed(3, 3, sizeof(double), steps[5], steps + 18)
        && is_packed(3, 3, sizeof(double), steps[6], steps + 20)
        && is_packed(3, 3, sizeof(double), steps[7], steps + 22)) {
        chasles_moving_frame_acceleration_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_moving_frame_acceleration_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_moving_frame_acceleration_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    ptrdiff_t entries0[3];
    const int dense0 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step0, steps + 8, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    ptrdiff_t entries1[9];
    const int dense1 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step1, steps + 10, entries1));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    ptrdiff_t entries2[3];
    const int dense2 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step2, steps + 12, entries2));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    ptrdiff_t entries3[3];
    const int dense3 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step3, steps + 14, entries3));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(float));
    ptrdiff_t entries4[3];
    const int dense4 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step4, steps + 16, entries4));
    char *const at5 = at[5];
    const ptrdiff_t step5 = CHASLES_STEP(5, 3 * sizeof(float));
    ptrdiff_t entries5[3];
    const int dense5 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step5, steps + 18, entries5));
    char *const at6 = at[6];
    const ptrdiff_t step6 = CHASLES_STEP(6, 3 * sizeof(float));
    ptrdiff_t entries6[3];
    const int dense6 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step6, steps + 20, entries6));
    char *const at7 = at[7];
    const ptrdiff_t step7 = CHASLES_STEP(7, 3 * sizeof(float));
    ptrdiff_t entries7[3];
    const int dense7 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step7, steps + 22, entries7));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats o_ddot[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3, copied.ahead);
        if (dense0) {
            load_3f(item0 + 0 * sizeof(float), step0, &o_ddot[0]);
        } else if (step0 == sizeof(float)) {
            o_ddot[0] = PACKEDF_IN(item0 + entries0[0], 0);
            o_ddot[1] = PACKEDF_IN(item0 + entries0[1], 0);
            o_ddot[2] = PACKEDF_IN(item0 + entries0[2], 0);
        } else {
            floats all[3];
            take_eachf(item0, entries0, step0, 3, all);
            o_ddot[0] = all[0];
            o_ddot[1] = all[1];
            o_ddot[2] = all[2];
        }
        floats Q[9];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 9, copied.ahead);
        if (dense1) {
            load_4f(item1 + 0 * sizeof(float), step1, &Q[0]);
            load_4f(item1 + 4 * sizeof(float), step1, &Q[4]);
            load_1f(item1 + 8 * sizeof(float), step1, &Q[8]);
        } else if (step1 == sizeof(float)) {
            Q[0] = PACKEDF_IN(item1 + entries1[0], 0);
            Q[1] = PACKEDF_IN(item1 + entries1[1], 0);
            Q[2] = PACKEDF_IN(item1 + entries1[2], 0);
            Q[3] = PACKEDF_IN(item1 + entries1[3], 0);
            Q[4] = PACKEDF_IN(item1 + entries1[4], 0);
            Q[5] = PACKEDF_IN(item1 + entries1[5], 0);
            Q[6] = PACKEDF_IN(item1 + entries1[6], 0);
            Q[7] = PACKEDF_IN(item1 + entries1[7], 0);
            Q[8] = PACKEDF_IN(item1 + entries1[8], 0);
        } else {
            floats all[9];
            take_eachf(item1, entries1, step1, 9, all);
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
        floats omega_dot[3];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 3, copied.ahead);
        if (dense3) {
            load_3f(item3 + 0 * sizeof(float), step3, &omega_dot[0]);
        } else if (step3 == sizeof(float)) {
            omega_dot[0] = PACKEDF_IN(item3 + entries3[0], 0);
            omega_dot[1] = PACKEDF_IN(item3 + entries3[1], 0);
            omega_dot[2] = PACKEDF_IN(item3 + entries3[2], 0);
        } else {
            floats all[3];
            take_eachf(item3, entries3, step3, 3, all);
            omega_dot[0] = all[0];
            omega_dot[1] = all[1];
            omega_dot[2] = all[2];
        }
        floats rho[3];
        const char *const item4 = at4 + g * LANESF * step4;
        prefetch(item4, 3, copied.ahead);
        if (dense4) {
            load_3f(item4 + 0 * sizeof(float), step4, &rho[0]);
        } else if (step4 == sizeof(float)) {
            rho[0] = PACKEDF_IN(item4 + entries4[0], 0);
            rho[1] = PACKEDF_IN(item4 + entries4[1], 0);
            rho[2] = PACKEDF_IN(item4 + entries4[2], 0);
        } else {
            floats all[3];
            take_eachf(item4, entries4, step4, 3, all);
            rho[0] = all[0];
            rho[1] = all[1];
            rho[2] = all[2];
        }
        floats rho_dot[3];
        const char *const item5 = at5 + g * LANESF * step5;
        prefetch(item5, 3, copied.ahead);
        if (dense5) {
            load_3f(item5 + 0 * sizeof(float), step5, &rho_dot[0]);
        } else if (step5 == sizeof(float)) {
            rho_dot[0] = PACKEDF_IN(item5 + entries5[0], 0);
            rho_dot[1] = PACKEDF_IN(item5 + entries5[1], 0);
            rho_dot[2] = PACKEDF_IN(item5 + entries5[2], 0);
        } else {
            floats all[3];
            take_eachf(item5, entries5, step5, 3, all);
            rho_dot[0] = all[0];
            rho_dot[1] = all[1];
            rho_dot[2] = all[2];
        }
        floats rho_ddot[3];
        const char *const item6 = at6 + g * LANESF * step6;
        prefetch(item6, 3, copied.ahead);
        if (dense6) {
            load_3f(item6 + 0 * sizeof(float), step6, &rho_ddot[0]);
        } else if (step6 == sizeof(float)) {
            rho_ddot[0] = PACKEDF_IN(item6 + entries6[0], 0);
            rho_ddot[1] = PACKEDF_IN(item6 + entries6[1], 0);
            rho_ddot[2] = PACKEDF_IN(item6 + entries6[2], 0);
        } else {
            floats all[3];
            take_eachf(item6, entries6, step6, 3, all);
            rho_ddot[0] = all[0];
            rho_ddot[1] = all[1];
            rho_ddot[2] = all[2];
        }
        const floats t1 = Q[0] * rho[0] + Q[1] * rho[1] + Q[2] * rho[2];
        const floats t2 = Q[3] * rho[0] + Q[4] * rho[1] + Q[5] * rho[2];
        const floats t3 = Q[6] * rho[0] + Q[7] * rho[1] + Q[8] * rho[2];
        const floats t4 = 2.0f * (Q[0] * rho_dot[0] + Q[1] * rho_dot[1] + Q[2] * rho_dot[2]);
        const floats t5 = omega[1] * t3 - omega[2] * t2 + t4;
        const floats t6 = 2.0f * (Q[3] * rho_dot[0] + Q[4] * rho_dot[1] + Q[5] * rho_dot[2]);
        const floats t7 = omega[2] * t1 - omega[0] * t3 + t6;
        const floats t8 = 2.0f * (Q[6] * rho_dot[0] + Q[7] * rho_dot[1] + Q[8] * rho_dot[2]);
        const floats t9 = omega[0] * t2 - omega[1] * t1 + t8;
        const floats t10 = o_ddot[0] + (omega_dot[1] * t3 - omega_dot[2] * t2);
        const floats t11 = o_ddot[1] + (omega_dot[2] * t1 - omega_dot[0] * t3);
        const floats t12 = o_ddot[2] + (omega_dot[0] * t2 - omega_dot[1] * t1);
        const floats t13 = Q[0] * rho_ddot[0] + Q[1] * rho_ddot[1] + Q[2] * rho_ddot[2];
        const floats p_ddot0 = t10 + (omega[1] * t9 - omega[2] * t7) + t13;
        const floats t14 = Q[3] * rho_ddot[0] + Q[4] * rho_ddot[1] + Q[5] * rho_ddot[2];
        const floats p_ddot1 = t11 + (omega[2] * t5 - omega[0] * t9) + t14;
        const floats t15 = Q[6] * rho_ddot[0] + Q[7] * rho_ddot[1] + Q[8] * rho_ddot[2];
        const floats p_ddot2 = t12 + (omega[0] * t7 - omega[1] * t5) + t15;
        char *const item7 = at7 + g * LANESF * step7;
        prefetch_to_write(item7, step7, 3, sizeof(float), copied.ahead);
        const floats result7[] = {p_ddot0, p_ddot1, p_ddot2};
        if (dense7) {
            store_allf(item7, step7, 3, result7);
        } else if (step7 == sizeof(float)) {
            PACKEDF(item7 + entries7[0], 0) = result7[0];
            PACKEDF(item7 + entries7[1], 0) = result7[1];
            PACKEDF(item7 + entries7[2], 0) = result7[2];
        } else {
            give_eachf(item7, entries7, step7, 3, result7);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_moving_frame_acceleration_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(3, 3, sizeof(float), steps[0], steps + 8)
        && is_packed(9, 3, sizeof(float), steps[1], steps + 10)
        && is_packed(3, 3, sizeof(float), steps[2], steps + 12)
        && is_packed(3, 3, sizeof(float), steps[3], steps + 14)
        && is_packed(3, 3, sizeof(float), steps[4], steps + 16)
        && is_packed(3, 3, sizeof(float), steps[5], steps + 18)
        && is_packed(3, 3, sizeof(float), steps[6], steps + 20)
        && is_packed(3, 3, sizeof(float), steps[7], steps + 22)) {
        chasles_moving_frame_acceleration_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_moving_frame_acceleration_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

#else

void CHASLES_LEVELED(chasles_moving_frame_velocity_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_moving_frame_velocity(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (const double *)(at[4] + i * steps[4]),
            (double *)(at[5] + i * steps[5]));
    }
}

void CHASLES_LEVELED(chasles_moving_frame_velocity_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_moving_frame_velocityf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (const float *)(at[4] + i * steps[4]),
            (float *)(at[5] + i * steps[5]));
    }
}

void CHASLES_LEVELED(chasles_moving_frame_acceleration_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_moving_frame_acceleration(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (const double *)(at[4] + i * steps[4]),
            (const double *)(at[5] + i * steps[5]),
            (const double *)(at[6] + i * steps[6]),
            (double *)(at[7] + i * steps[7]));
    }
}

void CHASLES_LEVELED(chasles_moving_frame_acceleration_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_moving_frame_accelerationf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (const float *)(at[4] + i * steps[4]),
            (const float *)(at[5] + i * steps[5]),
            (const float *)(at[6] + i * steps[6]),
            (float *)(at[7] + i * steps[7]));
    }
}

#endif
