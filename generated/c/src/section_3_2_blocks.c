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

void CHASLES_LEVELED(chasles_cross_product_matrix_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    const ptrdiff_t down0 = CHASLES_STEP(2, 3 * sizeof(double));
    const ptrdiff_t across0 = CHASLES_STEP(3, 1 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(double));
    const ptrdiff_t down1 = CHASLES_STEP(4, 3 * sizeof(double));
    const ptrdiff_t across1 = CHASLES_STEP(5, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles v[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3);
        take_3(item0, 0, 3, down0, across0, step0, v);
        const doubles V7 = v[0];
        const doubles V2 = v[1];
        const doubles V3 = v[2];
        const doubles V1 = -V3;
        const doubles V5 = -V7;
        const doubles V6 = -V2;
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, 9);
        give_4(item1, 0, 3, down1, across1, step1, spread(0.0), V1, V2, V3);
        give_4(item1, 4, 3, down1, across1, step1, spread(0.0), V5, V6, V7);
        give_1(item1, 8, 3, down1, across1, step1, spread(0.0));
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_cross_product_matrix_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    const ptrdiff_t down0 = CHASLES_STEP(2, 3 * sizeof(float));
    const ptrdiff_t across0 = CHASLES_STEP(3, 1 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 9 * sizeof(float));
    const ptrdiff_t down1 = CHASLES_STEP(4, 3 * sizeof(float));
    const ptrdiff_t across1 = CHASLES_STEP(5, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats v[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3);
        take_3f(item0, 0, 3, down0, across0, step0, v);
        const floats V7 = v[0];
        const floats V2 = v[1];
        const floats V3 = v[2];
        const floats V1 = -V3;
        const floats V5 = -V7;
        const floats V6 = -V2;
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, 9);
        give_4f(item1, 0, 3, down1, across1, step1, spreadf(0.0f), V1, V2, V3);
        give_4f(item1, 4, 3, down1, across1, step1, spreadf(0.0f), V5, V6, V7);
        give_1f(item1, 8, 3, down1, across1, step1, spreadf(0.0f));
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_axis_angle_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    const ptrdiff_t down0 = CHASLES_STEP(3, 3 * sizeof(double));
    const ptrdiff_t across0 = CHASLES_STEP(4, 1 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(double));
    const ptrdiff_t down2 = CHASLES_STEP(7, 3 * sizeof(double));
    const ptrdiff_t across2 = CHASLES_STEP(8, 1 * sizeof(double));
    chasles_stream copied = *stream;
    doubles angles[1][GROUPS];
    doubles sines[1][GROUPS];
    doubles cosines[1][GROUPS];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1);
        load_1(item1, step1, &phi);
        angles[0][g] = phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincos)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles e[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3);
        take_3(item0, 0, 3, down0, across0, step0, e);
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
        prefetch_to_write(item2, 9);
        give_4(item2, 0, 3, down2, across2, step2, Q0, Q1, Q2, Q3);
        give_4(item2, 4, 3, down2, across2, step2, Q4, Q5, Q6, Q7);
        give_1(item2, 8, 3, down2, across2, step2, Q8);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_rotation_from_axis_angle_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    const ptrdiff_t down0 = CHASLES_STEP(3, 3 * sizeof(float));
    const ptrdiff_t across0 = CHASLES_STEP(4, 1 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 9 * sizeof(float));
    const ptrdiff_t down2 = CHASLES_STEP(7, 3 * sizeof(float));
    const ptrdiff_t across2 = CHASLES_STEP(8, 1 * sizeof(float));
    chasles_stream copied = *stream;
    floats angles[1][GROUPSF];
    floats sines[1][GROUPSF];
    floats cosines[1][GROUPSF];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1);
        load_1f(item1, step1, &phi);
        angles[0][g] = phi;
    }
    copied.share = (copied.share + 1) / 2;
    CHASLES_LEVELED(chasles_sincosf)(groups, angles[0], sines[0], cosines[0], &copied);
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats e[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3);
        take_3f(item0, 0, 3, down0, across0, step0, e);
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
        prefetch_to_write(item2, 9);
        give_4f(item2, 0, 3, down2, across2, step2, Q0, Q1, Q2, Q3);
        give_4f(item2, 4, 3, down2, across2, step2, Q4, Q5, Q6, Q7);
        give_1f(item2, 8, 3, down2, across2, step2, Q8);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_point_after_displacement_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    const ptrdiff_t down0 = CHASLES_STEP(5, 3 * sizeof(double));
    const ptrdiff_t across0 = CHASLES_STEP(6, 1 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    const ptrdiff_t down1 = CHASLES_STEP(7, 3 * sizeof(double));
    const ptrdiff_t across1 = CHASLES_STEP(8, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    const ptrdiff_t down2 = CHASLES_STEP(9, 3 * sizeof(double));
    const ptrdiff_t across2 = CHASLES_STEP(10, 1 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    const ptrdiff_t down3 = CHASLES_STEP(11, 3 * sizeof(double));
    const ptrdiff_t across3 = CHASLES_STEP(12, 1 * sizeof(double));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(double));
    const ptrdiff_t down4 = CHASLES_STEP(13, 3 * sizeof(double));
    const ptrdiff_t across4 = CHASLES_STEP(14, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles Q[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9);
        take_4(item0, 0, 3, down0, across0, step0, Q);
        take_4(item0, 4, 3, down0, across0, step0, &Q[4]);
        take_1(item0, 8, 3, down0, across0, step0, &Q[8]);
        doubles a[3];
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 3);
        take_3(item1, 0, 3, down1, across1, step1, a);
        doubles a_prime[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3);
        take_3(item2, 0, 3, down2, across2, step2, a_prime);
        doubles p[3];
        const char *const item3 = at3 + g * LANES * step3;
        prefetch(item3, 3);
        take_3(item3, 0, 3, down3, across3, step3, p);
        const doubles t1 = p[0] - a[0];
        const doubles t2 = p[1] - a[1];
        const doubles t3 = p[2] - a[2];
        const doubles p_prime0 = a_prime[0] + (Q[0] * t1 + Q[1] * t2 + Q[2] * t3);
        const doubles p_prime1 = a_prime[1] + (Q[3] * t1 + Q[4] * t2 + Q[5] * t3);
        const doubles p_prime2 = a_prime[2] + (Q[6] * t1 + Q[7] * t2 + Q[8] * t3);
        char *const item4 = at4 + g * LANES * step4;
        prefetch_to_write(item4, 3);
        give_3(item4, 0, 3, down4, across4, step4, p_prime0, p_prime1, p_prime2);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_point_after_displacement_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    const ptrdiff_t down0 = CHASLES_STEP(5, 3 * sizeof(float));
    const ptrdiff_t across0 = CHASLES_STEP(6, 1 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    const ptrdiff_t down1 = CHASLES_STEP(7, 3 * sizeof(float));
    const ptrdiff_t across1 = CHASLES_STEP(8, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    const ptrdiff_t down2 = CHASLES_STEP(9, 3 * sizeof(float));
    const ptrdiff_t across2 = CHASLES_STEP(10, 1 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    const ptrdiff_t down3 = CHASLES_STEP(11, 3 * sizeof(float));
    const ptrdiff_t across3 = CHASLES_STEP(12, 1 * sizeof(float));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 3 * sizeof(float));
    const ptrdiff_t down4 = CHASLES_STEP(13, 3 * sizeof(float));
    const ptrdiff_t across4 = CHASLES_STEP(14, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats Q[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9);
        take_4f(item0, 0, 3, down0, across0, step0, Q);
        take_4f(item0, 4, 3, down0, across0, step0, &Q[4]);
        take_1f(item0, 8, 3, down0, across0, step0, &Q[8]);
        floats a[3];
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 3);
        take_3f(item1, 0, 3, down1, across1, step1, a);
        floats a_prime[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3);
        take_3f(item2, 0, 3, down2, across2, step2, a_prime);
        floats p[3];
        const char *const item3 = at3 + g * LANESF * step3;
        prefetch(item3, 3);
        take_3f(item3, 0, 3, down3, across3, step3, p);
        const floats t1 = p[0] - a[0];
        const floats t2 = p[1] - a[1];
        const floats t3 = p[2] - a[2];
        const floats p_prime0 = a_prime[0] + (Q[0] * t1 + Q[1] * t2 + Q[2] * t3);
        const floats p_prime1 = a_prime[1] + (Q[3] * t1 + Q[4] * t2 + Q[5] * t3);
        const floats p_prime2 = a_prime[2] + (Q[6] * t1 + Q[7] * t2 + Q[8] * t3);
        char *const item4 = at4 + g * LANESF * step4;
        prefetch_to_write(item4, 3);
        give_3f(item4, 0, 3, down4, across4, step4, p_prime0, p_prime1, p_prime2);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pitch_of_motion_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(double));
    const ptrdiff_t down0 = CHASLES_STEP(4, 3 * sizeof(double));
    const ptrdiff_t across0 = CHASLES_STEP(5, 1 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    const ptrdiff_t down2 = CHASLES_STEP(8, 3 * sizeof(double));
    const ptrdiff_t across2 = CHASLES_STEP(9, 1 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 1 * sizeof(double));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles e[3];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 3);
        take_3(item0, 0, 3, down0, across0, step0, e);
        doubles phi;
        const char *const item1 = at1 + g * LANES * step1;
        prefetch(item1, 1);
        load_1(item1, step1, &phi);
        doubles d_P[3];
        const char *const item2 = at2 + g * LANES * step2;
        prefetch(item2, 3);
        take_3(item2, 0, 3, down2, across2, step2, d_P);
        const doubles t1 = e[0] * d_P[0] + e[1] * d_P[1] + e[2] * d_P[2];
        const doubles result_value = choose(equal(phi, spread(0.0)), spread(0.0), t1) / phi;
        char *const item3 = at3 + g * LANES * step3;
        prefetch_to_write(item3, 1);
        store_1(item3, step3, result_value);
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_pitch_of_motion_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 3 * sizeof(float));
    const ptrdiff_t down0 = CHASLES_STEP(4, 3 * sizeof(float));
    const ptrdiff_t across0 = CHASLES_STEP(5, 1 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    const ptrdiff_t down2 = CHASLES_STEP(8, 3 * sizeof(float));
    const ptrdiff_t across2 = CHASLES_STEP(9, 1 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 1 * sizeof(float));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats e[3];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 3);
        take_3f(item0, 0, 3, down0, across0, step0, e);
        floats phi;
        const char *const item1 = at1 + g * LANESF * step1;
        prefetch(item1, 1);
        load_1f(item1, step1, &phi);
        floats d_P[3];
        const char *const item2 = at2 + g * LANESF * step2;
        prefetch(item2, 3);
        take_3f(item2, 0, 3, down2, across2, step2, d_P);
        const floats t1 = e[0] * d_P[0] + e[1] * d_P[1] + e[2] * d_P[2];
        const floats result_value = choosef(equalf(phi, spreadf(0.0f)), spreadf(0.0f), t1) / phi;
        char *const item3 = at3 + g * LANESF * step3;
        prefetch_to_write(item3, 1);
        store_1f(item3, step3, result_value);
        stream_lines(&copied);
    }
}

#else

void CHASLES_LEVELED(chasles_cross_product_matrix_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_cross_product_matrix(
            (const double *)(at[0] + i * steps[0]),
            (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_cross_product_matrix_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_cross_product_matrixf(
            (const float *)(at[0] + i * steps[0]),
            (float *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_rotation_from_axis_angle_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
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
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
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
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
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
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
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
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
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
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_stream *stream)
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
