/* The blocks of section_3_5, for batches. Made by `chasles emit`; not to be edited by hand.
 *
 * Compiled once for each level. A block first computes the sines and cosines of all its items, then, register by
 * register, all else.
 */

#include <math.h>
#include <stddef.h>

#include "batches.h"
#include "chasles.h"
#include "vectors.h"

#if CHASLES_VECTORS

void CHASLES_LEVELED(chasles_angular_acceleration_matrix_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = steps[0];
    char *const at1 = at[1];
    const ptrdiff_t step1 = steps[1];
    char *const at2 = at[2];
    const ptrdiff_t step2 = steps[2];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item0 = at0 + g * LANES * step0;
        load_2(item0, step0, omega);
        load_1(item0 + 2 * sizeof(double), step0, &omega[2]);
        doubles omega_dot[3];
        const char *const item1 = at1 + g * LANES * step1;
        load_2(item1, step1, omega_dot);
        load_1(item1 + 2 * sizeof(double), step1, &omega_dot[2]);
        const doubles t1 = omega[2] * omega[2];
        const doubles t2 = omega[1] * omega[1];
        const doubles W0 = -(t1 + t2);
        const doubles t3 = omega[0] * omega[1];
        const doubles t4 = omega[0] * omega[2];
        const doubles t5 = omega[0] * omega[0];
        const doubles W4 = -(t1 + t5);
        const doubles t6 = omega[1] * omega[2];
        const doubles W8 = -(t2 + t5);
        const doubles W1 = t3 - omega_dot[2];
        const doubles W2 = omega_dot[1] + t4;
        const doubles W3 = omega_dot[2] + t3;
        const doubles W5 = t6 - omega_dot[0];
        const doubles W6 = t4 - omega_dot[1];
        const doubles W7 = omega_dot[0] + t6;
        char *const item2 = at2 + g * LANES * step2;
        store_4(item2, step2, W0, W1, W2, W3);
        store_4(item2 + 4 * sizeof(double), step2, W4, W5, W6, W7);
        store_1(item2 + 8 * sizeof(double), step2, W8);
    }
}

void CHASLES_LEVELED(chasles_angular_acceleration_matrix_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = steps[0];
    char *const at1 = at[1];
    const ptrdiff_t step1 = steps[1];
    char *const at2 = at[2];
    const ptrdiff_t step2 = steps[2];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item0 = at0 + g * LANESF * step0;
        load_2f(item0, step0, omega);
        load_1f(item0 + 2 * sizeof(float), step0, &omega[2]);
        floats omega_dot[3];
        const char *const item1 = at1 + g * LANESF * step1;
        load_2f(item1, step1, omega_dot);
        load_1f(item1 + 2 * sizeof(float), step1, &omega_dot[2]);
        const floats t1 = omega[2] * omega[2];
        const floats t2 = omega[1] * omega[1];
        const floats W0 = -(t1 + t2);
        const floats t3 = omega[0] * omega[1];
        const floats t4 = omega[0] * omega[2];
        const floats t5 = omega[0] * omega[0];
        const floats W4 = -(t1 + t5);
        const floats t6 = omega[1] * omega[2];
        const floats W8 = -(t2 + t5);
        const floats W1 = t3 - omega_dot[2];
        const floats W2 = omega_dot[1] + t4;
        const floats W3 = omega_dot[2] + t3;
        const floats W5 = t6 - omega_dot[0];
        const floats W6 = t4 - omega_dot[1];
        const floats W7 = omega_dot[0] + t6;
        char *const item2 = at2 + g * LANESF * step2;
        store_4f(item2, step2, W0, W1, W2, W3);
        store_4f(item2 + 4 * sizeof(float), step2, W4, W5, W6, W7);
        store_1f(item2 + 8 * sizeof(float), step2, W8);
    }
}

void CHASLES_LEVELED(chasles_acceleration_of_point_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = steps[0];
    char *const at1 = at[1];
    const ptrdiff_t step1 = steps[1];
    char *const at2 = at[2];
    const ptrdiff_t step2 = steps[2];
    char *const at3 = at[3];
    const ptrdiff_t step3 = steps[3];
    char *const at4 = at[4];
    const ptrdiff_t step4 = steps[4];
    char *const at5 = at[5];
    const ptrdiff_t step5 = steps[5];
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles omega[3];
        const char *const item0 = at0 + g * LANES * step0;
        load_2(item0, step0, omega);
        load_1(item0 + 2 * sizeof(double), step0, &omega[2]);
        doubles omega_dot[3];
        const char *const item1 = at1 + g * LANES * step1;
        load_2(item1, step1, omega_dot);
        load_1(item1 + 2 * sizeof(double), step1, &omega_dot[2]);
        doubles a_ddot[3];
        const char *const item2 = at2 + g * LANES * step2;
        load_2(item2, step2, a_ddot);
        load_1(item2 + 2 * sizeof(double), step2, &a_ddot[2]);
        doubles a[3];
        const char *const item3 = at3 + g * LANES * step3;
        load_2(item3, step3, a);
        load_1(item3 + 2 * sizeof(double), step3, &a[2]);
        doubles p[3];
        const char *const item4 = at4 + g * LANES * step4;
        load_2(item4, step4, p);
        load_1(item4 + 2 * sizeof(double), step4, &p[2]);
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
        store_2(item5, step5, p_ddot0, p_ddot1);
        store_1(item5 + 2 * sizeof(double), step5, p_ddot2);
    }
}

void CHASLES_LEVELED(chasles_acceleration_of_point_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = steps[0];
    char *const at1 = at[1];
    const ptrdiff_t step1 = steps[1];
    char *const at2 = at[2];
    const ptrdiff_t step2 = steps[2];
    char *const at3 = at[3];
    const ptrdiff_t step3 = steps[3];
    char *const at4 = at[4];
    const ptrdiff_t step4 = steps[4];
    char *const at5 = at[5];
    const ptrdiff_t step5 = steps[5];
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats omega[3];
        const char *const item0 = at0 + g * LANESF * step0;
        load_2f(item0, step0, omega);
        load_1f(item0 + 2 * sizeof(float), step0, &omega[2]);
        floats omega_dot[3];
        const char *const item1 = at1 + g * LANESF * step1;
        load_2f(item1, step1, omega_dot);
        load_1f(item1 + 2 * sizeof(float), step1, &omega_dot[2]);
        floats a_ddot[3];
        const char *const item2 = at2 + g * LANESF * step2;
        load_2f(item2, step2, a_ddot);
        load_1f(item2 + 2 * sizeof(float), step2, &a_ddot[2]);
        floats a[3];
        const char *const item3 = at3 + g * LANESF * step3;
        load_2f(item3, step3, a);
        load_1f(item3 + 2 * sizeof(float), step3, &a[2]);
        floats p[3];
        const char *const item4 = at4 + g * LANESF * step4;
        load_2f(item4, step4, p);
        load_1f(item4 + 2 * sizeof(float), step4, &p[2]);
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
        store_2f(item5, step5, p_ddot0, p_ddot1);
        store_1f(item5 + 2 * sizeof(float), step5, p_ddot2);
    }
}

#else

void CHASLES_LEVELED(chasles_angular_acceleration_matrix_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps)
{
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_angular_acceleration_matrix(
            (const double *)(at[0] + i * steps[0]),
            (const double *)(at[1] + i * steps[1]),
            (double *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_angular_acceleration_matrix_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps)
{
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_angular_acceleration_matrixf(
            (const float *)(at[0] + i * steps[0]),
            (const float *)(at[1] + i * steps[1]),
            (float *)(at[2] + i * steps[2]));
    }
}

void CHASLES_LEVELED(chasles_acceleration_of_point_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps)
{
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
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps)
{
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

#endif
