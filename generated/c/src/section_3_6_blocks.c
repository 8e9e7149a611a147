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

void CHASLES_LEVELED(chasles_moving_frame_velocity_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    const ptrdiff_t down0 = CHASLES_STEP(6, 3 * sizeof(double));
    const ptrdiff_t across0 = CHASLES_STEP(7, 1 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    const ptrdiff_t down1 = CHASLES_STEP(8, 3 * sizeof(double));
    const ptrdiff_t across1 = CHASLES_STEP(9, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    const ptrdiff_t down2 = CHASLES_STEP(10, 3 * sizeof(double));
    const ptrdiff_t across2 = CHASLES_STEP(11, 1 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    const ptrdiff_t down3 = CHASLES_STEP(12, 3 * sizeof(double));
    const ptrdiff_t across3 = CHASLES_STEP(13, 1 * sizeof(double));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(double));
    const ptrdiff_t down4 = CHASLES_STEP(14, 3 * sizeof(double));
    const ptrdiff_t across4 = CHASLES_STEP(15, 1 * sizeof(double));
    char *const at5 = at[5];
    const ptrdiff_t step5 = CHASLES_STEP(5, 3 * sizeof(double));
    const ptrdiff_t down5 = CHASLES_STEP(16, 3 * sizeof(double));
    const ptrdiff_t across5 = CHASLES_STEP(17, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles o_dot[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3);
        take_3(item0, 0, 3, down0, across0, step0, o_dot);
        doubles Q[9];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 9);
        take_4(item1, 0, 3, down1, across1, step1, Q);
        take_4(item1, 4, 3, down1, across1, step1, &Q[4]);
        take_1(item1, 8, 3, down1, across1, step1, &Q[8]);
        doubles omega[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3);
        take_3(item2, 0, 3, down2, across2, step2, omega);
        doubles rho[3];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 3);
        take_3(item3, 0, 3, down3, across3, step3, rho);
        doubles rho_dot[3];
        const char *const item4 = at4 + g * LANES * step4;
        prefetch(item4, 3);
        take_3(item4, 0, 3, down4, across4, step4, rho_dot);
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
        prefetch_to_write(item5, 3);
        give_3(item5, 0, 3, down5, across5, step5, p_dot0, p_dot1, p_dot2);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_moving_frame_velocity_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    const ptrdiff_t down0 = CHASLES_STEP(6, 3 * sizeof(float));
    const ptrdiff_t across0 = CHASLES_STEP(7, 1 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    const ptrdiff_t down1 = CHASLES_STEP(8, 3 * sizeof(float));
    const ptrdiff_t across1 = CHASLES_STEP(9, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    const ptrdiff_t down2 = CHASLES_STEP(10, 3 * sizeof(float));
    const ptrdiff_t across2 = CHASLES_STEP(11, 1 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    const ptrdiff_t down3 = CHASLES_STEP(12, 3 * sizeof(float));
    const ptrdiff_t across3 = CHASLES_STEP(13, 1 * sizeof(float));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(float));
    const ptrdiff_t down4 = CHASLES_STEP(14, 3 * sizeof(float));
    const ptrdiff_t across4 = CHASLES_STEP(15, 1 * sizeof(float));
    char *const at5 = at[5];
    const ptrdiff_t step5 = CHASLES_STEP(5, 3 * sizeof(float));
    const ptrdiff_t down5 = CHASLES_STEP(16, 3 * sizeof(float));
    const ptrdiff_t across5 = CHASLES_STEP(17, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats o_dot[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3);
        take_3f(item0, 0, 3, down0, across0, step0, o_dot);
        floats Q[9];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 9);
        take_4f(item1, 0, 3, down1, across1, step1, Q);
        take_4f(item1, 4, 3, down1, across1, step1, &Q[4]);
        take_1f(item1, 8, 3, down1, across1, step1, &Q[8]);
        floats omega[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3);
        take_3f(item2, 0, 3, down2, across2, step2, omega);
        floats rho[3];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 3);
        take_3f(item3, 0, 3, down3, across3, step3, rho);
        floats rho_dot[3];
        const char *const item4 = at4 + g * LANESF * step4;
        prefetch(item4, 3);
        take_3f(item4, 0, 3, down4, across4, step4, rho_dot);
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
        prefetch_to_write(item5, 3);
        give_3f(item5, 0, 3, down5, across5, step5, p_dot0, p_dot1, p_dot2);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_moving_frame_acceleration_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    const ptrdiff_t down0 = CHASLES_STEP(8, 3 * sizeof(double));
    const ptrdiff_t across0 = CHASLES_STEP(9, 1 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    const ptrdiff_t down1 = CHASLES_STEP(10, 3 * sizeof(double));
    const ptrdiff_t across1 = CHASLES_STEP(11, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    const ptrdiff_t down2 = CHASLES_STEP(12, 3 * sizeof(double));
    const ptrdiff_t across2 = CHASLES_STEP(13, 1 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    const ptrdiff_t down3 = CHASLES_STEP(14, 3 * sizeof(double));
    const ptrdiff_t across3 = CHASLES_STEP(15, 1 * sizeof(double));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(double));
    const ptrdiff_t down4 = CHASLES_STEP(16, 3 * sizeof(double));
    const ptrdiff_t across4 = CHASLES_STEP(17, 1 * sizeof(double));
    char *const at5 = at[5];
    const ptrdiff_t step5 = CHASLES_STEP(5, 3 * sizeof(double));
    const ptrdiff_t down5 = CHASLES_STEP(18, 3 * sizeof(double));
    const ptrdiff_t across5 = CHASLES_STEP(19, 1 * sizeof(double));
    char *const at6 = at[6];
    const ptrdiff_t step6 = CHASLES_STEP(6, 3 * sizeof(double));
    const ptrdiff_t down6 = CHASLES_STEP(20, 3 * sizeof(double));
    const ptrdiff_t across6 = CHASLES_STEP(21, 1 * sizeof(double));
    char *const at7 = at[7];
    const ptrdiff_t step7 = CHASLES_STEP(7, 3 * sizeof(double));
    const ptrdiff_t down7 = CHASLES_STEP(22, 3 * sizeof(double));
    const ptrdiff_t across7 = CHASLES_STEP(23, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles o_ddot[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3);
        take_3(item0, 0, 3, down0, across0, step0, o_ddot);
        doubles Q[9];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 9);
        take_4(item1, 0, 3, down1, across1, step1, Q);
        take_4(item1, 4, 3, down1, across1, step1, &Q[4]);
        take_1(item1, 8, 3, down1, across1, step1, &Q[8]);
        doubles omega[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3);
        take_3(item2, 0, 3, down2, across2, step2, omega);
        doubles omega_dot[3];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 3);
        take_3(item3, 0, 3, down3, across3, step3, omega_dot);
        doubles rho[3];
        const char *const item4 = at4 + g * LANES * step4;
        prefetch(item4, 3);
        take_3(item4, 0, 3, down4, across4, step4, rho);
        doubles rho_dot[3];
        const char *const item5 = at5 + g * LANES * step5;
        prefetch(item5, 3);
        take_3(item5, 0, 3, down5, across5, step5, rho_dot);
        doubles rho_ddot[3];
        const char *const item6 = at6 + g * LANES * step6;
        prefetch(item6, 3);
        take_3(item6, 0, 3, down6, across6, step6, rho_ddot);
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
        prefetch_to_write(item7, 3);
        give_3(item7, 0, 3, down7, across7, step7, p_ddot0, p_ddot1, p_ddot2);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_moving_frame_acceleration_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    const ptrdiff_t down0 = CHASLES_STEP(8, 3 * sizeof(float));
    const ptrdiff_t across0 = CHASLES_STEP(9, 1 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    const ptrdiff_t down1 = CHASLES_STEP(10, 3 * sizeof(float));
    const ptrdiff_t across1 = CHASLES_STEP(11, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    const ptrdiff_t down2 = CHASLES_STEP(12, 3 * sizeof(float));
    const ptrdiff_t across2 = CHASLES_STEP(13, 1 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    const ptrdiff_t down3 = CHASLES_STEP(14, 3 * sizeof(float));
    const ptrdiff_t across3 = CHASLES_STEP(15, 1 * sizeof(float));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(float));
    const ptrdiff_t down4 = CHASLES_STEP(16, 3 * sizeof(float));
    const ptrdiff_t across4 = CHASLES_STEP(17, 1 * sizeof(float));
    char *const at5 = at[5];
    const ptrdiff_t step5 = CHASLES_STEP(5, 3 * sizeof(float));
    const ptrdiff_t down5 = CHASLES_STEP(18, 3 * sizeof(float));
    const ptrdiff_t across5 = CHASLES_STEP(19, 1 * sizeof(float));
    char *const at6 = at[6];
    const ptrdiff_t step6 = CHASLES_STEP(6, 3 * sizeof(float));
    const ptrdiff_t down6 = CHASLES_STEP(20, 3 * sizeof(float));
    const ptrdiff_t across6 = CHASLES_STEP(21, 1 * sizeof(float));
    char *const at7 = at[7];
    const ptrdiff_t step7 = CHASLES_STEP(7, 3 * sizeof(float));
    const ptrdiff_t down7 = CHASLES_STEP(22, 3 * sizeof(float));
    const ptrdiff_t across7 = CHASLES_STEP(23, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats o_ddot[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3);
        take_3f(item0, 0, 3, down0, across0, step0, o_ddot);
        floats Q[9];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 9);
        take_4f(item1, 0, 3, down1, across1, step1, Q);
        take_4f(item1, 4, 3, down1, across1, step1, &Q[4]);
        take_1f(item1, 8, 3, down1, across1, step1, &Q[8]);
        floats omega[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3);
        take_3f(item2, 0, 3, down2, across2, step2, omega);
        floats omega_dot[3];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 3);
        take_3f(item3, 0, 3, down3, across3, step3, omega_dot);
        floats rho[3];
        const char *const item4 = at4 + g * LANESF * step4;
        prefetch(item4, 3);
        take_3f(item4, 0, 3, down4, across4, step4, rho);
        floats rho_dot[3];
        const char *const item5 = at5 + g * LANESF * step5;
        prefetch(item5, 3);
        take_3f(item5, 0, 3, down5, across5, step5, rho_dot);
        floats rho_ddot[3];
        const char *const item6 = at6 + g * LANESF * step6;
        prefetch(item6, 3);
        take_3f(item6, 0, 3, down6, across6, step6, rho_ddot);
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
        prefetch_to_write(item7, 3);
        give_3f(item7, 0, 3, down7, across7, step7, p_ddot0, p_ddot1, p_ddot2);
        stream_lines(&copied);
    }
}

#else

void CHASLES_LEVELED(chasles_moving_frame_velocity_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
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
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
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
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
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
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
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
