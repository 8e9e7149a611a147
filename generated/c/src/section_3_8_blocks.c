/* The blocks of section_3_8, for batches. Made by `chasles emit`; not to be edited by hand.
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

void CHASLES_LEVELED(chasles_inertia_about_point_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 9 * sizeof(double));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[9];
        const char *const item0 = at0 + g * LANES * step0;
        fetch(item0, LANES * step0);
        load_4(item0, step0, I_C);
        load_4(item0 + 4 * sizeof(double), step0, &I_C[4]);
        load_1(item0 + 8 * sizeof(double), step0, &I_C[8]);
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        fetch(item1, LANES * step1);
        load_1(item1, step1, &m);
        doubles c[3];
        const char *const item2 = at2 + g * LANES * step2;
        fetch(item2, LANES * step2);
        load_3(item2, step2, c);
        doubles a[3];
        const char *const item3 = at3 + g * LANES * step3;
        fetch(item3, LANES * step3);
        load_3(item3, step3, a);
        const doubles t1 = a[0] - c[0];
        const doubles t2 = a[1] - c[1];
        const doubles t3 = a[2] - c[2];
        const doubles t4 = m * t2;
        const doubles t5 = m * t3;
        const doubles t6 = t1 * (m * t1);
        const doubles t7 = t1 * t4;
        const doubles t8 = t1 * t5;
        const doubles t9 = t2 * t4;
        const doubles t10 = t2 * t5;
        const doubles t11 = t3 * t5;
        const doubles I_A0 = I_C[0] + (t9 + t11);
        const doubles I_A1 = I_C[1] - t7;
        const doubles I_A2 = I_C[2] - t8;
        const doubles I_A3 = I_C[3] - t7;
        const doubles I_A4 = I_C[4] + (t6 + t11);
        const doubles I_A5 = I_C[5] - t10;
        const doubles I_A6 = I_C[6] - t8;
        const doubles I_A7 = I_C[7] - t10;
        const doubles I_A8 = I_C[8] + (t6 + t9);
        char *const item4 = at4 + g * LANES * step4;
        claim(item4, LANES * step4);
        store_4(item4, step4, I_A0, I_A1, I_A2, I_A3);
        store_4(item4 + 4 * sizeof(double), step4, I_A4, I_A5, I_A6, I_A7);
        store_1(item4 + 8 * sizeof(double), step4, I_A8);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_inertia_about_point_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 9 * sizeof(float));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[9];
        const char *const item0 = at0 + g * LANESF * step0;
        fetch(item0, LANESF * step0);
        load_4f(item0, step0, I_C);
        load_4f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        load_1f(item0 + 8 * sizeof(float), step0, &I_C[8]);
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        fetch(item1, LANESF * step1);
        load_1f(item1, step1, &m);
        floats c[3];
        const char *const item2 = at2 + g * LANESF * step2;
        fetch(item2, LANESF * step2);
        load_3f(item2, step2, c);
        floats a[3];
        const char *const item3 = at3 + g * LANESF * step3;
        fetch(item3, LANESF * step3);
        load_3f(item3, step3, a);
        const floats t1 = a[0] - c[0];
        const floats t2 = a[1] - c[1];
        const floats t3 = a[2] - c[2];
        const floats t4 = m * t2;
        const floats t5 = m * t3;
        const floats t6 = t1 * (m * t1);
        const floats t7 = t1 * t4;
        const floats t8 = t1 * t5;
        const floats t9 = t2 * t4;
        const floats t10 = t2 * t5;
        const floats t11 = t3 * t5;
        const floats I_A0 = I_C[0] + (t9 + t11);
        const floats I_A1 = I_C[1] - t7;
        const floats I_A2 = I_C[2] - t8;
        const floats I_A3 = I_C[3] - t7;
        const floats I_A4 = I_C[4] + (t6 + t11);
        const floats I_A5 = I_C[5] - t10;
        const floats I_A6 = I_C[6] - t8;
        const floats I_A7 = I_C[7] - t10;
        const floats I_A8 = I_C[8] + (t6 + t9);
        char *const item4 = at4 + g * LANESF * step4;
        claim(item4, LANESF * step4);
        store_4f(item4, step4, I_A0, I_A1, I_A2, I_A3);
        store_4f(item4 + 4 * sizeof(float), step4, I_A4, I_A5, I_A6, I_A7);
        store_1f(item4 + 8 * sizeof(float), step4, I_A8);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_inertia_about_point_sym6_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(double));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[6];
        const char *const item0 = at0 + g * LANES * step0;
        fetch(item0, LANES * step0);
        load_4(item0, step0, I_C);
        load_2(item0 + 4 * sizeof(double), step0, &I_C[4]);
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        fetch(item1, LANES * step1);
        load_1(item1, step1, &m);
        doubles c[3];
        const char *const item2 = at2 + g * LANES * step2;
        fetch(item2, LANES * step2);
        load_3(item2, step2, c);
        doubles a[3];
        const char *const item3 = at3 + g * LANES * step3;
        fetch(item3, LANES * step3);
        load_3(item3, step3, a);
        const doubles t1 = a[0] - c[0];
        const doubles t2 = a[1] - c[1];
        const doubles t3 = a[2] - c[2];
        const doubles t4 = m * t2;
        const doubles t5 = m * t3;
        const doubles t6 = t1 * (m * t1);
        const doubles t7 = t2 * t4;
        const doubles t8 = t3 * t5;
        const doubles I_A0 = I_C[0] + (t7 + t8);
        const doubles I_A1 = I_C[1] - t1 * t4;
        const doubles I_A2 = I_C[2] - t1 * t5;
        const doubles I_A3 = I_C[3] + (t6 + t8);
        const doubles I_A4 = I_C[4] - t2 * t5;
        const doubles I_A5 = I_C[5] + (t6 + t7);
        char *const item4 = at4 + g * LANES * step4;
        claim(item4, LANES * step4);
        store_4(item4, step4, I_A0, I_A1, I_A2, I_A3);
        store_2(item4 + 4 * sizeof(double), step4, I_A4, I_A5);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_inertia_about_point_sym6_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(float));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[6];
        const char *const item0 = at0 + g * LANESF * step0;
        fetch(item0, LANESF * step0);
        load_4f(item0, step0, I_C);
        load_2f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        fetch(item1, LANESF * step1);
        load_1f(item1, step1, &m);
        floats c[3];
        const char *const item2 = at2 + g * LANESF * step2;
        fetch(item2, LANESF * step2);
        load_3f(item2, step2, c);
        floats a[3];
        const char *const item3 = at3 + g * LANESF * step3;
        fetch(item3, LANESF * step3);
        load_3f(item3, step3, a);
        const floats t1 = a[0] - c[0];
        const floats t2 = a[1] - c[1];
        const floats t3 = a[2] - c[2];
        const floats t4 = m * t2;
        const floats t5 = m * t3;
        const floats t6 = t1 * (m * t1);
        const floats t7 = t2 * t4;
        const floats t8 = t3 * t5;
        const floats I_A0 = I_C[0] + (t7 + t8);
        const floats I_A1 = I_C[1] - t1 * t4;
        const floats I_A2 = I_C[2] - t1 * t5;
        const floats I_A3 = I_C[3] + (t6 + t8);
        const floats I_A4 = I_C[4] - t2 * t5;
        const floats I_A5 = I_C[5] + (t6 + t7);
        char *const item4 = at4 + g * LANESF * step4;
        claim(item4, LANESF * step4);
        store_4f(item4, step4, I_A0, I_A1, I_A2, I_A3);
        store_2f(item4 + 4 * sizeof(float), step4, I_A4, I_A5);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_momentum_screw_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[9];
        const char *const item0 = at0 + g * LANES * step0;
        fetch(item0, LANES * step0);
        load_4(item0, step0, I_C);
        load_4(item0 + 4 * sizeof(double), step0, &I_C[4]);
        load_1(item0 + 8 * sizeof(double), step0, &I_C[8]);
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        fetch(item1, LANES * step1);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        fetch(item2, LANES * step2);
        load_4(item2, step2, t);
        load_2(item2 + 4 * sizeof(double), step2, &t[4]);
        const doubles mu0 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const doubles mu1 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const doubles mu2 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
        const doubles mu3 = m * t[3];
        const doubles mu4 = m * t[4];
        const doubles mu5 = m * t[5];
        char *const item3 = at3 + g * LANES * step3;
        claim(item3, LANES * step3);
        store_4(item3, step3, mu0, mu1, mu2, mu3);
        store_2(item3 + 4 * sizeof(double), step3, mu4, mu5);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_momentum_screw_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[9];
        const char *const item0 = at0 + g * LANESF * step0;
        fetch(item0, LANESF * step0);
        load_4f(item0, step0, I_C);
        load_4f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        load_1f(item0 + 8 * sizeof(float), step0, &I_C[8]);
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        fetch(item1, LANESF * step1);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        fetch(item2, LANESF * step2);
        load_4f(item2, step2, t);
        load_2f(item2 + 4 * sizeof(float), step2, &t[4]);
        const floats mu0 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const floats mu1 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const floats mu2 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
        const floats mu3 = m * t[3];
        const floats mu4 = m * t[4];
        const floats mu5 = m * t[5];
        char *const item3 = at3 + g * LANESF * step3;
        claim(item3, LANESF * step3);
        store_4f(item3, step3, mu0, mu1, mu2, mu3);
        store_2f(item3 + 4 * sizeof(float), step3, mu4, mu5);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_momentum_screw_sym6_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[6];
        const char *const item0 = at0 + g * LANES * step0;
        fetch(item0, LANES * step0);
        load_4(item0, step0, I_C);
        load_2(item0 + 4 * sizeof(double), step0, &I_C[4]);
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        fetch(item1, LANES * step1);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        fetch(item2, LANES * step2);
        load_4(item2, step2, t);
        load_2(item2 + 4 * sizeof(double), step2, &t[4]);
        const doubles mu0 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const doubles mu1 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
        const doubles mu2 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const doubles mu3 = m * t[3];
        const doubles mu4 = m * t[4];
        const doubles mu5 = m * t[5];
        char *const item3 = at3 + g * LANES * step3;
        claim(item3, LANES * step3);
        store_4(item3, step3, mu0, mu1, mu2, mu3);
        store_2(item3 + 4 * sizeof(double), step3, mu4, mu5);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_momentum_screw_sym6_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[6];
        const char *const item0 = at0 + g * LANESF * step0;
        fetch(item0, LANESF * step0);
        load_4f(item0, step0, I_C);
        load_2f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        fetch(item1, LANESF * step1);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        fetch(item2, LANESF * step2);
        load_4f(item2, step2, t);
        load_2f(item2 + 4 * sizeof(float), step2, &t[4]);
        const floats mu0 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const floats mu1 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
        const floats mu2 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const floats mu3 = m * t[3];
        const floats mu4 = m * t[4];
        const floats mu5 = m * t[5];
        char *const item3 = at3 + g * LANESF * step3;
        claim(item3, LANESF * step3);
        store_4f(item3, step3, mu0, mu1, mu2, mu3);
        store_2f(item3 + 4 * sizeof(float), step3, mu4, mu5);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 1 * sizeof(double));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[9];
        const char *const item0 = at0 + g * LANES * step0;
        fetch(item0, LANES * step0);
        load_4(item0, step0, I_C);
        load_4(item0 + 4 * sizeof(double), step0, &I_C[4]);
        load_1(item0 + 8 * sizeof(double), step0, &I_C[8]);
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        fetch(item1, LANES * step1);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        fetch(item2, LANES * step2);
        load_4(item2, step2, t);
        load_2(item2 + 4 * sizeof(double), step2, &t[4]);
        const doubles t1 = (I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]) * (0.5 * t[0]);
        const doubles t2 = t1 + (I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]) * (0.5 * t[1]);
        const doubles t3 = t2 + (I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2]) * (0.5 * t[2]);
        const doubles t4 = t3 + m * t[3] * (0.5 * t[3]) + m * t[4] * (0.5 * t[4]);
        const doubles T_value = t4 + m * t[5] * (0.5 * t[5]);
        char *const item3 = at3 + g * LANES * step3;
        claim(item3, LANES * step3);
        store_1(item3, step3, T_value);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 1 * sizeof(float));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[9];
        const char *const item0 = at0 + g * LANESF * step0;
        fetch(item0, LANESF * step0);
        load_4f(item0, step0, I_C);
        load_4f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        load_1f(item0 + 8 * sizeof(float), step0, &I_C[8]);
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        fetch(item1, LANESF * step1);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        fetch(item2, LANESF * step2);
        load_4f(item2, step2, t);
        load_2f(item2 + 4 * sizeof(float), step2, &t[4]);
        const floats t1 = (I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]) * (0.5f * t[0]);
        const floats t2 = t1 + (I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]) * (0.5f * t[1]);
        const floats t3 = t2 + (I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2]) * (0.5f * t[2]);
        const floats t4 = t3 + m * t[3] * (0.5f * t[3]) + m * t[4] * (0.5f * t[4]);
        const floats T_value = t4 + m * t[5] * (0.5f * t[5]);
        char *const item3 = at3 + g * LANESF * step3;
        claim(item3, LANESF * step3);
        store_1f(item3, step3, T_value);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_sym6_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 1 * sizeof(double));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[6];
        const char *const item0 = at0 + g * LANES * step0;
        fetch(item0, LANES * step0);
        load_4(item0, step0, I_C);
        load_2(item0 + 4 * sizeof(double), step0, &I_C[4]);
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        fetch(item1, LANES * step1);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        fetch(item2, LANES * step2);
        load_4(item2, step2, t);
        load_2(item2 + 4 * sizeof(double), step2, &t[4]);
        const doubles t1 = (I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]) * (0.5 * t[0]);
        const doubles t2 = t1 + (I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2]) * (0.5 * t[1]);
        const doubles t3 = t2 + (I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]) * (0.5 * t[2]);
        const doubles t4 = t3 + m * t[3] * (0.5 * t[3]) + m * t[4] * (0.5 * t[4]);
        const doubles T_value = t4 + m * t[5] * (0.5 * t[5]);
        char *const item3 = at3 + g * LANES * step3;
        claim(item3, LANES * step3);
        store_1(item3, step3, T_value);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_sym6_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 1 * sizeof(float));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[6];
        const char *const item0 = at0 + g * LANESF * step0;
        fetch(item0, LANESF * step0);
        load_4f(item0, step0, I_C);
        load_2f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        fetch(item1, LANESF * step1);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        fetch(item2, LANESF * step2);
        load_4f(item2, step2, t);
        load_2f(item2 + 4 * sizeof(float), step2, &t[4]);
        const floats t1 = (I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]) * (0.5f * t[0]);
        const floats t2 = t1 + (I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2]) * (0.5f * t[1]);
        const floats t3 = t2 + (I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]) * (0.5f * t[2]);
        const floats t4 = t3 + m * t[3] * (0.5f * t[3]) + m * t[4] * (0.5f * t[4]);
        const floats T_value = t4 + m * t[5] * (0.5f * t[5]);
        char *const item3 = at3 + g * LANESF * step3;
        claim(item3, LANESF * step3);
        store_1f(item3, step3, T_value);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(double));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[9];
        const char *const item0 = at0 + g * LANES * step0;
        fetch(item0, LANES * step0);
        load_4(item0, step0, I_C);
        load_4(item0 + 4 * sizeof(double), step0, &I_C[4]);
        load_1(item0 + 8 * sizeof(double), step0, &I_C[8]);
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        fetch(item1, LANES * step1);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        fetch(item2, LANES * step2);
        load_3(item2, step2, t);
        doubles t_dot[6];
        const char *const item3 = at3 + g * LANES * step3;
        fetch(item3, LANES * step3);
        load_4(item3, step3, t_dot);
        load_2(item3 + 4 * sizeof(double), step3, &t_dot[4]);
        const doubles w3 = m * t_dot[3];
        const doubles w4 = m * t_dot[4];
        const doubles w5 = m * t_dot[5];
        const doubles t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const doubles t2 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const doubles t3 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
        const doubles t4 = I_C[0] * t_dot[0] + I_C[1] * t_dot[1] + I_C[2] * t_dot[2];
        const doubles w0 = t4 + (t[1] * t3 - t[2] * t2);
        const doubles t5 = I_C[3] * t_dot[0] + I_C[4] * t_dot[1] + I_C[5] * t_dot[2];
        const doubles w1 = t5 + (t[2] * t1 - t[0] * t3);
        const doubles t6 = I_C[6] * t_dot[0] + I_C[7] * t_dot[1] + I_C[8] * t_dot[2];
        const doubles w2 = t6 + (t[0] * t2 - t[1] * t1);
        char *const item4 = at4 + g * LANES * step4;
        claim(item4, LANES * step4);
        store_4(item4, step4, w0, w1, w2, w3);
        store_2(item4 + 4 * sizeof(double), step4, w4, w5);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(float));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[9];
        const char *const item0 = at0 + g * LANESF * step0;
        fetch(item0, LANESF * step0);
        load_4f(item0, step0, I_C);
        load_4f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        load_1f(item0 + 8 * sizeof(float), step0, &I_C[8]);
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        fetch(item1, LANESF * step1);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        fetch(item2, LANESF * step2);
        load_3f(item2, step2, t);
        floats t_dot[6];
        const char *const item3 = at3 + g * LANESF * step3;
        fetch(item3, LANESF * step3);
        load_4f(item3, step3, t_dot);
        load_2f(item3 + 4 * sizeof(float), step3, &t_dot[4]);
        const floats w3 = m * t_dot[3];
        const floats w4 = m * t_dot[4];
        const floats w5 = m * t_dot[5];
        const floats t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const floats t2 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const floats t3 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
        const floats t4 = I_C[0] * t_dot[0] + I_C[1] * t_dot[1] + I_C[2] * t_dot[2];
        const floats w0 = t4 + (t[1] * t3 - t[2] * t2);
        const floats t5 = I_C[3] * t_dot[0] + I_C[4] * t_dot[1] + I_C[5] * t_dot[2];
        const floats w1 = t5 + (t[2] * t1 - t[0] * t3);
        const floats t6 = I_C[6] * t_dot[0] + I_C[7] * t_dot[1] + I_C[8] * t_dot[2];
        const floats w2 = t6 + (t[0] * t2 - t[1] * t1);
        char *const item4 = at4 + g * LANESF * step4;
        claim(item4, LANESF * step4);
        store_4f(item4, step4, w0, w1, w2, w3);
        store_2f(item4 + 4 * sizeof(float), step4, w4, w5);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_sym6_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(double));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[6];
        const char *const item0 = at0 + g * LANES * step0;
        fetch(item0, LANES * step0);
        load_4(item0, step0, I_C);
        load_2(item0 + 4 * sizeof(double), step0, &I_C[4]);
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        fetch(item1, LANES * step1);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        fetch(item2, LANES * step2);
        load_3(item2, step2, t);
        doubles t_dot[6];
        const char *const item3 = at3 + g * LANES * step3;
        fetch(item3, LANES * step3);
        load_4(item3, step3, t_dot);
        load_2(item3 + 4 * sizeof(double), step3, &t_dot[4]);
        const doubles w3 = m * t_dot[3];
        const doubles w4 = m * t_dot[4];
        const doubles w5 = m * t_dot[5];
        const doubles t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const doubles t2 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
        const doubles t3 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const doubles t4 = I_C[0] * t_dot[0] + I_C[1] * t_dot[1] + I_C[2] * t_dot[2];
        const doubles w0 = t4 + (t[1] * t3 - t[2] * t2);
        const doubles t5 = I_C[1] * t_dot[0] + I_C[3] * t_dot[1] + I_C[4] * t_dot[2];
        const doubles w1 = t5 + (t[2] * t1 - t[0] * t3);
        const doubles t6 = I_C[2] * t_dot[0] + I_C[4] * t_dot[1] + I_C[5] * t_dot[2];
        const doubles w2 = t6 + (t[0] * t2 - t[1] * t1);
        char *const item4 = at4 + g * LANES * step4;
        claim(item4, LANES * step4);
        store_4(item4, step4, w0, w1, w2, w3);
        store_2(item4 + 4 * sizeof(double), step4, w4, w5);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_sym6_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(float));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[6];
        const char *const item0 = at0 + g * LANESF * step0;
        fetch(item0, LANESF * step0);
        load_4f(item0, step0, I_C);
        load_2f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        fetch(item1, LANESF * step1);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        fetch(item2, LANESF * step2);
        load_3f(item2, step2, t);
        floats t_dot[6];
        const char *const item3 = at3 + g * LANESF * step3;
        fetch(item3, LANESF * step3);
        load_4f(item3, step3, t_dot);
        load_2f(item3 + 4 * sizeof(float), step3, &t_dot[4]);
        const floats w3 = m * t_dot[3];
        const floats w4 = m * t_dot[4];
        const floats w5 = m * t_dot[5];
        const floats t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const floats t2 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
        const floats t3 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const floats t4 = I_C[0] * t_dot[0] + I_C[1] * t_dot[1] + I_C[2] * t_dot[2];
        const floats w0 = t4 + (t[1] * t3 - t[2] * t2);
        const floats t5 = I_C[1] * t_dot[0] + I_C[3] * t_dot[1] + I_C[4] * t_dot[2];
        const floats w1 = t5 + (t[2] * t1 - t[0] * t3);
        const floats t6 = I_C[2] * t_dot[0] + I_C[4] * t_dot[1] + I_C[5] * t_dot[2];
        const floats w2 = t6 + (t[0] * t2 - t[1] * t1);
        char *const item4 = at4 + g * LANESF * step4;
        claim(item4, LANESF * step4);
        store_4f(item4, step4, w0, w1, w2, w3);
        store_2f(item4 + 4 * sizeof(float), step4, w4, w5);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(double));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[9];
        const char *const item0 = at0 + g * LANES * step0;
        fetch(item0, LANES * step0);
        load_4(item0, step0, I_C);
        load_4(item0 + 4 * sizeof(double), step0, &I_C[4]);
        load_1(item0 + 8 * sizeof(double), step0, &I_C[8]);
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        fetch(item1, LANES * step1);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        fetch(item2, LANES * step2);
        load_3(item2, step2, t);
        doubles w[6];
        const char *const item3 = at3 + g * LANES * step3;
        fetch(item3, LANES * step3);
        load_4(item3, step3, w);
        load_2(item3 + 4 * sizeof(double), step3, &w[4]);
        const doubles t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const doubles t2 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const doubles t3 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
        const doubles t4 = w[0] - (t[1] * t3 - t[2] * t2);
        const doubles t5 = w[1] - (t[2] * t1 - t[0] * t3);
        const doubles t6 = w[2] - (t[0] * t2 - t[1] * t1);
        const doubles t7 = I_C[4] * I_C[8] - I_C[5] * I_C[7];
        const doubles t8 = I_C[5] * I_C[6] - I_C[3] * I_C[8];
        const doubles t9 = I_C[3] * I_C[7] - I_C[4] * I_C[6];
        const doubles t10 = I_C[0] * t7 + I_C[1] * t8 + I_C[2] * t9;
        const doubles t11 = choose(equal(t10, spread(0.0)), spread(0.0), spread(1.0)) / t10;
        const doubles t12 = t4 * t7 + t5 * (I_C[2] * I_C[7] - I_C[1] * I_C[8]);
        const doubles t13 = t4 * t8 + t5 * (I_C[0] * I_C[8] - I_C[2] * I_C[6]);
        const doubles t14 = t4 * t9 + t5 * (I_C[1] * I_C[6] - I_C[0] * I_C[7]);
        const doubles t_dot0 = t11 * (t12 + t6 * (I_C[1] * I_C[5] - I_C[2] * I_C[4]));
        const doubles t_dot1 = t11 * (t13 + t6 * (I_C[2] * I_C[3] - I_C[0] * I_C[5]));
        const doubles t_dot2 = t11 * (t14 + t6 * (I_C[0] * I_C[4] - I_C[1] * I_C[3]));
        const doubles t15 = choose(equal(m, spread(0.0)), spread(0.0), spread(1.0)) / m;
        const doubles t_dot3 = w[3] * t15;
        const doubles t_dot4 = w[4] * t15;
        const doubles t_dot5 = w[5] * t15;
        char *const item4 = at4 + g * LANES * step4;
        claim(item4, LANES * step4);
        store_4(item4, step4, t_dot0, t_dot1, t_dot2, t_dot3);
        store_2(item4 + 4 * sizeof(double), step4, t_dot4, t_dot5);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(float));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[9];
        const char *const item0 = at0 + g * LANESF * step0;
        fetch(item0, LANESF * step0);
        load_4f(item0, step0, I_C);
        load_4f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        load_1f(item0 + 8 * sizeof(float), step0, &I_C[8]);
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        fetch(item1, LANESF * step1);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        fetch(item2, LANESF * step2);
        load_3f(item2, step2, t);
        floats w[6];
        const char *const item3 = at3 + g * LANESF * step3;
        fetch(item3, LANESF * step3);
        load_4f(item3, step3, w);
        load_2f(item3 + 4 * sizeof(float), step3, &w[4]);
        const floats t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const floats t2 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const floats t3 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
        const floats t4 = w[0] - (t[1] * t3 - t[2] * t2);
        const floats t5 = w[1] - (t[2] * t1 - t[0] * t3);
        const floats t6 = w[2] - (t[0] * t2 - t[1] * t1);
        const floats t7 = I_C[4] * I_C[8] - I_C[5] * I_C[7];
        const floats t8 = I_C[5] * I_C[6] - I_C[3] * I_C[8];
        const floats t9 = I_C[3] * I_C[7] - I_C[4] * I_C[6];
        const floats t10 = I_C[0] * t7 + I_C[1] * t8 + I_C[2] * t9;
        const floats t11 = choosef(equalf(t10, spreadf(0.0f)), spreadf(0.0f), spreadf(1.0f)) / t10;
        const floats t12 = t4 * t7 + t5 * (I_C[2] * I_C[7] - I_C[1] * I_C[8]);
        const floats t13 = t4 * t8 + t5 * (I_C[0] * I_C[8] - I_C[2] * I_C[6]);
        const floats t14 = t4 * t9 + t5 * (I_C[1] * I_C[6] - I_C[0] * I_C[7]);
        const floats t_dot0 = t11 * (t12 + t6 * (I_C[1] * I_C[5] - I_C[2] * I_C[4]));
        const floats t_dot1 = t11 * (t13 + t6 * (I_C[2] * I_C[3] - I_C[0] * I_C[5]));
        const floats t_dot2 = t11 * (t14 + t6 * (I_C[0] * I_C[4] - I_C[1] * I_C[3]));
        const floats t15 = choosef(equalf(m, spreadf(0.0f)), spreadf(0.0f), spreadf(1.0f)) / m;
        const floats t_dot3 = w[3] * t15;
        const floats t_dot4 = w[4] * t15;
        const floats t_dot5 = w[5] * t15;
        char *const item4 = at4 + g * LANESF * step4;
        claim(item4, LANESF * step4);
        store_4f(item4, step4, t_dot0, t_dot1, t_dot2, t_dot3);
        store_2f(item4 + 4 * sizeof(float), step4, t_dot4, t_dot5);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_sym6_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(double));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(double));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[6];
        const char *const item0 = at0 + g * LANES * step0;
        fetch(item0, LANES * step0);
        load_4(item0, step0, I_C);
        load_2(item0 + 4 * sizeof(double), step0, &I_C[4]);
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        fetch(item1, LANES * step1);
        load_1(item1, step1, &m);
        doubles t[6];
        const char *const item2 = at2 + g * LANES * step2;
        fetch(item2, LANES * step2);
        load_3(item2, step2, t);
        doubles w[6];
        const char *const item3 = at3 + g * LANES * step3;
        fetch(item3, LANES * step3);
        load_4(item3, step3, w);
        load_2(item3 + 4 * sizeof(double), step3, &w[4]);
        const doubles t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const doubles t2 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
        const doubles t3 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const doubles t4 = w[0] - (t[1] * t3 - t[2] * t2);
        const doubles t5 = w[1] - (t[2] * t1 - t[0] * t3);
        const doubles t6 = w[2] - (t[0] * t2 - t[1] * t1);
        const doubles t7 = I_C[3] * I_C[5] - I_C[4] * I_C[4];
        const doubles t8 = I_C[2] * I_C[4] - I_C[1] * I_C[5];
        const doubles t9 = I_C[1] * I_C[4] - I_C[2] * I_C[3];
        const doubles t10 = I_C[1] * I_C[2] - I_C[0] * I_C[4];
        const doubles t11 = I_C[0] * t7 + I_C[1] * t8 + I_C[2] * t9;
        const doubles t12 = choose(equal(t11, spread(0.0)), spread(0.0), spread(1.0)) / t11;
        const doubles t_dot0 = t12 * (t4 * t7 + t5 * t8 + t6 * t9);
        const doubles t_dot1 = t12 * (t4 * t8 + t5 * (I_C[0] * I_C[5] - I_C[2] * I_C[2]) + t6 * t10);
        const doubles t_dot2 = t12 * (t4 * t9 + t5 * t10 + t6 * (I_C[0] * I_C[3] - I_C[1] * I_C[1]));
        const doubles t13 = choose(equal(m, spread(0.0)), spread(0.0), spread(1.0)) / m;
        const doubles t_dot3 = w[3] * t13;
        const doubles t_dot4 = w[4] * t13;
        const doubles t_dot5 = w[5] * t13;
        char *const item4 = at4 + g * LANES * step4;
        claim(item4, LANES * step4);
        store_4(item4, step4, t_dot0, t_dot1, t_dot2, t_dot3);
        store_2(item4 + 4 * sizeof(double), step4, t_dot4, t_dot5);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_sym6_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 6 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 6 * sizeof(float));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 6 * sizeof(float));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[6];
        const char *const item0 = at0 + g * LANESF * step0;
        fetch(item0, LANESF * step0);
        load_4f(item0, step0, I_C);
        load_2f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        fetch(item1, LANESF * step1);
        load_1f(item1, step1, &m);
        floats t[6];
        const char *const item2 = at2 + g * LANESF * step2;
        fetch(item2, LANESF * step2);
        load_3f(item2, step2, t);
        floats w[6];
        const char *const item3 = at3 + g * LANESF * step3;
        fetch(item3, LANESF * step3);
        load_4f(item3, step3, w);
        load_2f(item3 + 4 * sizeof(float), step3, &w[4]);
        const floats t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
        const floats t2 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
        const floats t3 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
        const floats t4 = w[0] - (t[1] * t3 - t[2] * t2);
        const floats t5 = w[1] - (t[2] * t1 - t[0] * t3);
        const floats t6 = w[2] - (t[0] * t2 - t[1] * t1);
        const floats t7 = I_C[3] * I_C[5] - I_C[4] * I_C[4];
        const floats t8 = I_C[2] * I_C[4] - I_C[1] * I_C[5];
        const floats t9 = I_C[1] * I_C[4] - I_C[2] * I_C[3];
        const floats t10 = I_C[1] * I_C[2] - I_C[0] * I_C[4];
        const floats t11 = I_C[0] * t7 + I_C[1] * t8 + I_C[2] * t9;
        const floats t12 = choosef(equalf(t11, spreadf(0.0f)), spreadf(0.0f), spreadf(1.0f)) / t11;
        const floats t_dot0 = t12 * (t4 * t7 + t5 * t8 + t6 * t9);
        const floats t_dot1 = t12 * (t4 * t8 + t5 * (I_C[0] * I_C[5] - I_C[2] * I_C[2]) + t6 * t10);
        const floats t_dot2 = t12 * (t4 * t9 + t5 * t10 + t6 * (I_C[0] * I_C[3] - I_C[1] * I_C[1]));
        const floats t13 = choosef(equalf(m, spreadf(0.0f)), spreadf(0.0f), spreadf(1.0f)) / m;
        const floats t_dot3 = w[3] * t13;
        const floats t_dot4 = w[4] * t13;
        const floats t_dot5 = w[5] * t13;
        char *const item4 = at4 + g * LANESF * step4;
        claim(item4, LANESF * step4);
        store_4f(item4, step4, t_dot0, t_dot1, t_dot2, t_dot3);
        store_2f(item4 + 4 * sizeof(float), step4, t_dot4, t_dot5);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 36 * sizeof(double));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[9];
        const char *const item0 = at0 + g * LANES * step0;
        fetch(item0, LANES * step0);
        load_4(item0, step0, I_C);
        load_4(item0 + 4 * sizeof(double), step0, &I_C[4]);
        load_1(item0 + 8 * sizeof(double), step0, &I_C[8]);
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        fetch(item1, LANES * step1);
        load_1(item1, step1, &m);
        doubles c[3];
        const char *const item2 = at2 + g * LANES * step2;
        fetch(item2, LANES * step2);
        load_3(item2, step2, c);
        doubles a[3];
        const char *const item3 = at3 + g * LANES * step3;
        fetch(item3, LANES * step3);
        load_3(item3, step3, a);
        const doubles M_A21 = m;
        const doubles t1 = a[0] - c[0];
        const doubles t2 = a[1] - c[1];
        const doubles t3 = a[2] - c[2];
        const doubles M_A11 = M_A21 * t1;
        const doubles M_A16 = -M_A11;
        const doubles M_A15 = M_A21 * t2;
        const doubles M_A5 = -M_A15;
        const doubles M_A4 = M_A21 * t3;
        const doubles M_A9 = -M_A4;
        const doubles t4 = t1 * M_A11;
        const doubles t5 = t1 * M_A15;
        const doubles t6 = t1 * M_A4;
        const doubles t7 = t2 * M_A15;
        const doubles t8 = t2 * M_A4;
        const doubles t9 = t3 * M_A4;
        const doubles M_A0 = I_C[0] + (t7 + t9);
        const doubles M_A1 = I_C[1] - t5;
        const doubles M_A2 = I_C[2] - t6;
        const doubles M_A6 = I_C[3] - t5;
        const doubles M_A7 = I_C[4] + (t4 + t9);
        const doubles M_A8 = I_C[5] - t8;
        const doubles M_A12 = I_C[6] - t6;
        const doubles M_A13 = I_C[7] - t8;
        const doubles M_A14 = I_C[8] + (t4 + t7);
        char *const item4 = at4 + g * LANES * step4;
        claim(item4, LANES * step4);
        store_4(item4, step4, M_A0, M_A1, M_A2, spread(0.0));
        store_4(item4 + 4 * sizeof(double), step4, M_A4, M_A5, M_A6, M_A7);
        store_4(item4 + 8 * sizeof(double), step4, M_A8, M_A9, spread(0.0), M_A11);
        store_4(item4 + 12 * sizeof(double), step4, M_A12, M_A13, M_A14, M_A15);
        store_4(item4 + 16 * sizeof(double), step4, M_A16, spread(0.0), spread(0.0), M_A9);
        store_4(item4 + 20 * sizeof(double), step4, M_A15, M_A21, spread(0.0), spread(0.0));
        store_4(item4 + 24 * sizeof(double), step4, M_A4, spread(0.0), M_A16, spread(0.0));
        store_4(item4 + 28 * sizeof(double), step4, M_A21, spread(0.0), M_A5, M_A11);
        store_4(item4 + 32 * sizeof(double), step4, spread(0.0), spread(0.0), spread(0.0), M_A21);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 36 * sizeof(float));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[9];
        const char *const item0 = at0 + g * LANESF * step0;
        fetch(item0, LANESF * step0);
        load_4f(item0, step0, I_C);
        load_4f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        load_1f(item0 + 8 * sizeof(float), step0, &I_C[8]);
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        fetch(item1, LANESF * step1);
        load_1f(item1, step1, &m);
        floats c[3];
        const char *const item2 = at2 + g * LANESF * step2;
        fetch(item2, LANESF * step2);
        load_3f(item2, step2, c);
        floats a[3];
        const char *const item3 = at3 + g * LANESF * step3;
        fetch(item3, LANESF * step3);
        load_3f(item3, step3, a);
        const floats M_A21 = m;
        const floats t1 = a[0] - c[0];
        const floats t2 = a[1] - c[1];
        const floats t3 = a[2] - c[2];
        const floats M_A11 = M_A21 * t1;
        const floats M_A16 = -M_A11;
        const floats M_A15 = M_A21 * t2;
        const floats M_A5 = -M_A15;
        const floats M_A4 = M_A21 * t3;
        const floats M_A9 = -M_A4;
        const floats t4 = t1 * M_A11;
        const floats t5 = t1 * M_A15;
        const floats t6 = t1 * M_A4;
        const floats t7 = t2 * M_A15;
        const floats t8 = t2 * M_A4;
        const floats t9 = t3 * M_A4;
        const floats M_A0 = I_C[0] + (t7 + t9);
        const floats M_A1 = I_C[1] - t5;
        const floats M_A2 = I_C[2] - t6;
        const floats M_A6 = I_C[3] - t5;
        const floats M_A7 = I_C[4] + (t4 + t9);
        const floats M_A8 = I_C[5] - t8;
        const floats M_A12 = I_C[6] - t6;
        const floats M_A13 = I_C[7] - t8;
        const floats M_A14 = I_C[8] + (t4 + t7);
        char *const item4 = at4 + g * LANESF * step4;
        claim(item4, LANESF * step4);
        store_4f(item4, step4, M_A0, M_A1, M_A2, spreadf(0.0f));
        store_4f(item4 + 4 * sizeof(float), step4, M_A4, M_A5, M_A6, M_A7);
        store_4f(item4 + 8 * sizeof(float), step4, M_A8, M_A9, spreadf(0.0f), M_A11);
        store_4f(item4 + 12 * sizeof(float), step4, M_A12, M_A13, M_A14, M_A15);
        store_4f(item4 + 16 * sizeof(float), step4, M_A16, spreadf(0.0f), spreadf(0.0f), M_A9);
        store_4f(item4 + 20 * sizeof(float), step4, M_A15, M_A21, spreadf(0.0f), spreadf(0.0f));
        store_4f(item4 + 24 * sizeof(float), step4, M_A4, spreadf(0.0f), M_A16, spreadf(0.0f));
        store_4f(item4 + 28 * sizeof(float), step4, M_A21, spreadf(0.0f), M_A5, M_A11);
        store_4f(item4 + 32 * sizeof(float), step4, spreadf(0.0f), spreadf(0.0f), spreadf(0.0f), M_A21);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_sym6_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(double));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(double));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(double));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(double));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 36 * sizeof(double));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles I_C[6];
        const char *const item0 = at0 + g * LANES * step0;
        fetch(item0, LANES * step0);
        load_4(item0, step0, I_C);
        load_2(item0 + 4 * sizeof(double), step0, &I_C[4]);
        doubles m;
        const char *const item1 = at1 + g * LANES * step1;
        fetch(item1, LANES * step1);
        load_1(item1, step1, &m);
        doubles c[3];
        const char *const item2 = at2 + g * LANES * step2;
        fetch(item2, LANES * step2);
        load_3(item2, step2, c);
        doubles a[3];
        const char *const item3 = at3 + g * LANES * step3;
        fetch(item3, LANES * step3);
        load_3(item3, step3, a);
        const doubles M_A21 = m;
        const doubles t1 = a[0] - c[0];
        const doubles t2 = a[1] - c[1];
        const doubles t3 = a[2] - c[2];
        const doubles M_A11 = M_A21 * t1;
        const doubles M_A16 = -M_A11;
        const doubles M_A15 = M_A21 * t2;
        const doubles M_A5 = -M_A15;
        const doubles M_A4 = M_A21 * t3;
        const doubles M_A9 = -M_A4;
        const doubles t4 = t1 * M_A11;
        const doubles t5 = t2 * M_A15;
        const doubles t6 = t3 * M_A4;
        const doubles M_A0 = I_C[0] + (t5 + t6);
        const doubles M_A1 = I_C[1] - t1 * M_A15;
        const doubles M_A2 = I_C[2] - t1 * M_A4;
        const doubles M_A7 = I_C[3] + (t4 + t6);
        const doubles M_A8 = I_C[4] - t2 * M_A4;
        const doubles M_A14 = I_C[5] + (t4 + t5);
        char *const item4 = at4 + g * LANES * step4;
        claim(item4, LANES * step4);
        store_4(item4, step4, M_A0, M_A1, M_A2, spread(0.0));
        store_4(item4 + 4 * sizeof(double), step4, M_A4, M_A5, M_A1, M_A7);
        store_4(item4 + 8 * sizeof(double), step4, M_A8, M_A9, spread(0.0), M_A11);
        store_4(item4 + 12 * sizeof(double), step4, M_A2, M_A8, M_A14, M_A15);
        store_4(item4 + 16 * sizeof(double), step4, M_A16, spread(0.0), spread(0.0), M_A9);
        store_4(item4 + 20 * sizeof(double), step4, M_A15, M_A21, spread(0.0), spread(0.0));
        store_4(item4 + 24 * sizeof(double), step4, M_A4, spread(0.0), M_A16, spread(0.0));
        store_4(item4 + 28 * sizeof(double), step4, M_A21, spread(0.0), M_A5, M_A11);
        store_4(item4 + 32 * sizeof(double), step4, spread(0.0), spread(0.0), spread(0.0), M_A21);
        follow(&way);
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_sym6_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 6 * sizeof(float));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 1 * sizeof(float));
    char *const at2 = at[2];
    const ptrdiff_t step2 = CHASLES_STEP(2, 3 * sizeof(float));
    char *const at3 = at[3];
    const ptrdiff_t step3 = CHASLES_STEP(3, 3 * sizeof(float));
    char *const at4 = at[4];
    const ptrdiff_t step4 = CHASLES_STEP(4, 36 * sizeof(float));
    chasles_trail way = *trail;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats I_C[6];
        const char *const item0 = at0 + g * LANESF * step0;
        fetch(item0, LANESF * step0);
        load_4f(item0, step0, I_C);
        load_2f(item0 + 4 * sizeof(float), step0, &I_C[4]);
        floats m;
        const char *const item1 = at1 + g * LANESF * step1;
        fetch(item1, LANESF * step1);
        load_1f(item1, step1, &m);
        floats c[3];
        const char *const item2 = at2 + g * LANESF * step2;
        fetch(item2, LANESF * step2);
        load_3f(item2, step2, c);
        floats a[3];
        const char *const item3 = at3 + g * LANESF * step3;
        fetch(item3, LANESF * step3);
        load_3f(item3, step3, a);
        const floats M_A21 = m;
        const floats t1 = a[0] - c[0];
        const floats t2 = a[1] - c[1];
        const floats t3 = a[2] - c[2];
        const floats M_A11 = M_A21 * t1;
        const floats M_A16 = -M_A11;
        const floats M_A15 = M_A21 * t2;
        const floats M_A5 = -M_A15;
        const floats M_A4 = M_A21 * t3;
        const floats M_A9 = -M_A4;
        const floats t4 = t1 * M_A11;
        const floats t5 = t2 * M_A15;
        const floats t6 = t3 * M_A4;
        const floats M_A0 = I_C[0] + (t5 + t6);
        const floats M_A1 = I_C[1] - t1 * M_A15;
        const floats M_A2 = I_C[2] - t1 * M_A4;
        const floats M_A7 = I_C[3] + (t4 + t6);
        const floats M_A8 = I_C[4] - t2 * M_A4;
        const floats M_A14 = I_C[5] + (t4 + t5);
        char *const item4 = at4 + g * LANESF * step4;
        claim(item4, LANESF * step4);
        store_4f(item4, step4, M_A0, M_A1, M_A2, spreadf(0.0f));
        store_4f(item4 + 4 * sizeof(float), step4, M_A4, M_A5, M_A1, M_A7);
        store_4f(item4 + 8 * sizeof(float), step4, M_A8, M_A9, spreadf(0.0f), M_A11);
        store_4f(item4 + 12 * sizeof(float), step4, M_A2, M_A8, M_A14, M_A15);
        store_4f(item4 + 16 * sizeof(float), step4, M_A16, spreadf(0.0f), spreadf(0.0f), M_A9);
        store_4f(item4 + 20 * sizeof(float), step4, M_A15, M_A21, spreadf(0.0f), spreadf(0.0f));
        store_4f(item4 + 24 * sizeof(float), step4, M_A4, spreadf(0.0f), M_A16, spreadf(0.0f));
        store_4f(item4 + 28 * sizeof(float), step4, M_A21, spreadf(0.0f), M_A5, M_A11);
        store_4f(item4 + 32 * sizeof(float), step4, spreadf(0.0f), spreadf(0.0f), spreadf(0.0f), M_A21);
        follow(&way);
    }
}

#else

void CHASLES_LEVELED(chasles_inertia_about_point_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_about_point(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_inertia_about_point_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_about_pointf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_inertia_about_point_sym6_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_about_point_sym6(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_inertia_about_point_sym6_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_about_point_sym6f(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_momentum_screw_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_momentum_screw(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_momentum_screw_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_momentum_screwf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_momentum_screw_sym6_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_momentum_screw_sym6(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_momentum_screw_sym6_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_momentum_screw_sym6f(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_kinetic_energy(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_kinetic_energyf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_sym6_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_kinetic_energy_sym6(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (double *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_kinetic_energy_sym6_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_kinetic_energy_sym6f(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (float *)(at[3] + i * steps[3]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_wrench(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_wrenchf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_sym6_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_wrench_sym6(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_wrench_sym6_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_wrench_sym6f(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_twist_rate(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_twist_ratef(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_sym6_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_twist_rate_sym6(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_newton_euler_twist_rate_sym6_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_newton_euler_twist_rate_sym6f(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_dyad(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_dyadf(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_sym6_block)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_dyad_sym6(
            (const double *)(at[0] + i * steps[0]),
            *(const double *)(at[1] + i * steps[1]),
            (const double *)(at[2] + i * steps[2]),
            (const double *)(at[3] + i * steps[3]),
            (double *)(at[4] + i * steps[4]));
    }
}

void CHASLES_LEVELED(chasles_inertia_dyad_sym6_blockf)(
    ptrdiff_t groups,
    char *const *at,
    const ptrdiff_t *steps,
    const chasles_trail *trail)
{
    (void)trail;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_inertia_dyad_sym6f(
            (const float *)(at[0] + i * steps[0]),
            *(const float *)(at[1] + i * steps[1]),
            (const float *)(at[2] + i * steps[2]),
            (const float *)(at[3] + i * steps[3]),
            (float *)(at[4] + i * steps[4]));
    }
}

#endif
