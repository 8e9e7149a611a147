/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The blocks of section_3_3, for batches. Made by `chasles emit`; not to be edited by hand.
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

CHASLES_INLINE void chasles_axial_vector_block_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(double));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(double), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(double));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(double), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        doubles Omega[9];
        const char *const item0 = at0 + g * LANES * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4(item0 + 1 * sizeof(double), step0, &Omega[1]);
            load_4(item0 + 5 * sizeof(double), step0, &Omega[5]);
        } else if (step0 == sizeof(double)) {
            Omega[1] = PACKED_IN(item0 + entries0[1], 0);
            Omega[2] = PACKED_IN(item0 + entries0[2], 0);
            Omega[3] = PACKED_IN(item0 + entries0[3], 0);
            Omega[5] = PACKED_IN(item0 + entries0[5], 0);
            Omega[6] = PACKED_IN(item0 + entries0[6], 0);
            Omega[7] = PACKED_IN(item0 + entries0[7], 0);
        } else {
            doubles all[9];
            take_each(item0, entries0, step0, 9, all);
            Omega[1] = all[1];
            Omega[2] = all[2];
            Omega[3] = all[3];
            Omega[5] = all[5];
            Omega[6] = all[6];
            Omega[7] = all[7];
        }
        const doubles omega0 = 0.5 * (Omega[7] - Omega[5]);
        const doubles omega1 = 0.5 * (Omega[2] - Omega[6]);
        const doubles omega2 = 0.5 * (Omega[3] - Omega[1]);
        char *const item1 = at1 + g * LANES * step1;
        prefetch_to_write(item1, step1, 3, sizeof(double), copied.ahead);
        const doubles result1[] = {omega0, omega1, omega2};
        if (dense1) {
            store_all(item1, step1, 3, result1);
        } else if (step1 == sizeof(double)) {
            PACKED(item1 + entries1[0], 0) = result1[0];
            PACKED(item1 + entries1[1], 0) = result1[1];
            PACKED(item1 + entries1[2], 0) = result1[2];
        } else {
            give_each(item1, entries1, step1, 3, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_axial_vector_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(double), steps[0], steps + 2)
        && is_packed(3, 3, sizeof(double), steps[1], steps + 4)) {
        chasles_axial_vector_block_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_axial_vector_block_items(groups, at, steps, stream, CHASLES_PACKED);
}

CHASLES_INLINE void chasles_axial_vector_blockf_items(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream, const int packed)
{
    char *const at0 = at[0];
    const ptrdiff_t step0 = CHASLES_STEP(0, 9 * sizeof(float));
    ptrdiff_t entries0[9];
    const int dense0 = CHASLES_DENSE(find_entries(9, 3, sizeof(float), step0, steps + 2, entries0));
    char *const at1 = at[1];
    const ptrdiff_t step1 = CHASLES_STEP(1, 3 * sizeof(float));
    ptrdiff_t entries1[3];
    const int dense1 = CHASLES_DENSE(find_entries(3, 3, sizeof(float), step1, steps + 4, entries1));
    chasles_stream copied = *stream;
    for (ptrdiff_t g = 0; g < groups; g++) {
        floats Omega[9];
        const char *const item0 = at0 + g * LANESF * step0;
        prefetch(item0, 9, copied.ahead);
        if (dense0) {
            load_4f(item0 + 1 * sizeof(float), step0, &Omega[1]);
            load_4f(item0 + 5 * sizeof(float), step0, &Omega[5]);
        } else if (step0 == sizeof(float)) {
            Omega[1] = PACKEDF_IN(item0 + entries0[1], 0);
            Omega[2] = PACKEDF_IN(item0 + entries0[2], 0);
            Omega[3] = PACKEDF_IN(item0 + entries0[3], 0);
            Omega[5] = PACKEDF_IN(item0 + entries0[5], 0);
            Omega[6] = PACKEDF_IN(item0 + entries0[6], 0);
            Omega[7] = PACKEDF_IN(item0 + entries0[7], 0);
        } else {
            floats all[9];
            take_eachf(item0, entries0, step0, 9, all);
            Omega[1] = all[1];
            Omega[2] = all[2];
            Omega[3] = all[3];
            Omega[5] = all[5];
            Omega[6] = all[6];
            Omega[7] = all[7];
        }
        const floats omega0 = 0.5f * (Omega[7] - Omega[5]);
        const floats omega1 = 0.5f * (Omega[2] - Omega[6]);
        const floats omega2 = 0.5f * (Omega[3] - Omega[1]);
        char *const item1 = at1 + g * LANESF * step1;
        prefetch_to_write(item1, step1, 3, sizeof(float), copied.ahead);
        const floats result1[] = {omega0, omega1, omega2};
        if (dense1) {
            store_allf(item1, step1, 3, result1);
        } else if (step1 == sizeof(float)) {
            PACKEDF(item1 + entries1[0], 0) = result1[0];
            PACKEDF(item1 + entries1[1], 0) = result1[1];
            PACKEDF(item1 + entries1[2], 0) = result1[2];
        } else {
            give_eachf(item1, entries1, step1, 3, result1);
        }
        stream_lines(&copied);
    }
}

void CHASLES_LEVELED(chasles_axial_vector_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    if (CHASLES_LOOKS
        && is_packed(9, 3, sizeof(float), steps[0], steps + 2)
        && is_packed(3, 3, sizeof(float), steps[1], steps + 4)) {
        chasles_axial_vector_blockf_items(groups, at, steps, stream, 1);
        return;
    }
    chasles_axial_vector_blockf_items(groups, at, steps, stream, CHASLES_PACKED);
}

#else

void CHASLES_LEVELED(chasles_axial_vector_block)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_axial_vector((const double *)(at[0] + i * steps[0]), (double *)(at[1] + i * steps[1]));
    }
}

void CHASLES_LEVELED(chasles_axial_vector_blockf)(
    ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream)
{
    (void)stream;
    for (ptrdiff_t i = 0; i < groups; i++) {
        chasles_axial_vectorf((const float *)(at[0] + i * steps[0]), (float *)(at[1] + i * steps[1]));
    }
}

#endif
