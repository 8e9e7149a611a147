/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* Sines and cosines of registers of angles. Made by `chasles emit`; not to be edited by hand.
 *
 * The polynomials, and the parts of pi/2, are those of fdlibm, of which the notice is:
 *   Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 *   Developed at SunSoft, a Sun Microsystems, Inc. business.
 *   Permission to use, copy, modify, and distribute this software is freely granted, provided that this notice is
 *   preserved.
 * There is no branch: the nearest multiple k of pi/2 is taken off in parts whose products with k are exact (Cody and
 * Waite, Software Manual for the Elementary Functions, 1980), both polynomials are evaluated, and the bits of k say
 * which is which and of what sign. Adding 1.5 * 2^52 rounds to a whole
 * number and leaves it in the lowest bits; no compiler may rearrange that, so nothing of -ffast-math is to be given.
 */

#include "vectors.h"

#if CHASLES_VECTORS

#include <math.h>

/* Below this k has at most 20 bits, and its products with the first 33 bits of the parts are exact. */
#define MOST 1.6e6
#define ROUNDING 6755399441055744.0
#define QUARTERS 6.36619772367581382433e-01
#define PART_1 1.57079632673412561417e+00
#define PART_2 6.07710050630396597660e-11
#define PART_3 2.02226624871116645580e-21
#define PART_4 8.47842766036889956997e-32
#define REST_2 6.07710050650619224932e-11

static inline doubles absolute(doubles x)
{
    return (doubles)((truths)x & 0x7fffffffffffffffLL);
}

/* Bit `place` of a whole number, as a sign. */
#define SIGN(bits, place) ((truths)((unsigned_bits)(bits) << (63 - (place))) & (truths)spread(-0.0))

typedef unsigned long long unsigned_bits CHASLES_VECTOR(CHASLES_REGISTER);

static inline int any(truths is)
{
    long long bits = 0;
    for (int i = 0; i < LANES; i++) {
        bits |= is[i];
    }
    return bits != 0;
}

/* Which of the two is the sine, and the signs: k odd swaps them; the sine changes sign with k's second bit, the cosine
 * with that of k + 1. */
static inline void place(truths k, doubles of_sine, doubles of_cosine, doubles *sine, doubles *cosine)
{
    const truths odd = -(k & 1);
    *sine = (doubles)((truths)choose(odd, of_cosine, of_sine) ^ SIGN(k, 1));
    *cosine = (doubles)((truths)choose(odd, of_sine, of_cosine) ^ SIGN(k + 1, 1));
}

static inline void sincos_of(doubles x, doubles *sine, doubles *cosine)
{
    const doubles shifted = x * QUARTERS + ROUNDING;
    const doubles k = shifted - ROUNDING;
    /* x - k pi/2 as a sum y + tail. */
    const doubles first = x - k * PART_1;
    const doubles second = k * PART_2;
    const doubles near = first - second;
    const doubles lost = (first - near) - second;
    const doubles third = k * PART_3;
    const doubles y = near - third;
    const doubles tail = ((near - y) - third) + (lost - k * PART_4);
    const doubles z = y * y, v = z * y, w = z * z;
    const doubles p = (8.33333333332248946124e-03 + z * -1.98412698298579493134e-04)
        + w * ((2.75573137070700676789e-06 + z * -2.50507602534068634195e-08) + w * 1.58969099521155010221e-10);
    const doubles of_sine = y - ((z * (0.5 * tail - v * p) - tail) - v * -1.66666666666666324348e-01);
    const doubles q = z * ((4.16666666666666019037e-02 + z * -1.38888888888741095749e-03) + w * 2.48015872894767294178e-05)
        + w * w * ((-2.75573143513906633035e-07 + z * 2.08757232129817482790e-09) + w * -1.13596475577881948265e-11);
    const doubles half = 0.5 * z, one = 1.0 - half;
    const doubles of_cosine = one + (((1.0 - one) - half) + (z * q - y * tail));
    place((truths)shifted, of_sine, of_cosine, sine, cosine);
}

void CHASLES_LEVELED(chasles_sincos)(
    ptrdiff_t groups, doubles *angles, doubles *sines, doubles *cosines, chasles_stream *stream)
{
    truths near = ~(truths)spread(0.0);
    for (ptrdiff_t g = 0; g < groups; g++) {
        near &= (truths)(absolute(angles[g]) <= MOST);
        sincos_of(angles[g], &sines[g], &cosines[g]);
        stream_lines(stream);
    }
    if (!any(~near)) {
        return;
    }
    for (ptrdiff_t g = 0; g < groups; g++) {
        for (int i = 0; i < LANES; i++) {
            const double x = angles[g][i];
            if (!(fabs(x) <= MOST)) {
                sines[g][i] = sin(x);
                cosines[g][i] = cos(x);
            }
        }
    }
}

/* In double precision, which is far beyond what single precision needs: one part fewer, shorter polynomials. */
static inline void sincos_of_narrow(doubles x, doubles *sine, doubles *cosine)
{
    const doubles shifted = x * QUARTERS + ROUNDING;
    const doubles k = shifted - ROUNDING;
    const doubles y = (x - k * PART_1) - k * REST_2;
    const doubles z = y * y, w = z * z;
    /* A product with y and no sum, so that -0 stays. */
    const doubles of_sine = y
        * ((1.0 + z * (-0.166666666416265235595 + z * 0.0083333293858894631756))
            + w * z * (-0.000198393348360966317347 + z * 0.0000027183114939898219064));
    const doubles of_cosine = ((1.0 + z * -0.499999997251031003120) + w * 0.0416666233237390631894)
        + w * z * (-0.00138867637746099294692 + z * 0.0000243904487962774090654);
    place((truths)shifted, of_sine, of_cosine, sine, cosine);
}

typedef float half_floats CHASLES_VECTOR(CHASLES_REGISTER / 2);

#if CHASLES_REGISTER == 16
#define FIRST_HALF 0, 1
#define SECOND_HALF 2, 3
#elif CHASLES_REGISTER == 32
#define FIRST_HALF 0, 1, 2, 3
#define SECOND_HALF 4, 5, 6, 7
#else
#define FIRST_HALF 0, 1, 2, 3, 4, 5, 6, 7
#define SECOND_HALF 8, 9, 10, 11, 12, 13, 14, 15
#endif

static inline floats narrowed(doubles first, doubles second)
{
    const half_floats a = __builtin_convertvector(first, half_floats);
    const half_floats b = __builtin_convertvector(second, half_floats);
    return SHUFFLE(a, b, FIRST_HALF, SECOND_HALF);
}

void CHASLES_LEVELED(chasles_sincosf)(
    ptrdiff_t groups, floats *angles, floats *sines, floats *cosines, chasles_stream *stream)
{
    truths near = ~(truths)spread(0.0);
    for (ptrdiff_t g = 0; g < groups; g++) {
        const floats x = angles[g];
        const half_floats first = SHUFFLE(x, x, FIRST_HALF), second = SHUFFLE(x, x, SECOND_HALF);
        const doubles a = __builtin_convertvector(first, doubles), b = __builtin_convertvector(second, doubles);
        doubles sine_a, sine_b, cosine_a, cosine_b;
        sincos_of_narrow(a, &sine_a, &cosine_a);
        sincos_of_narrow(b, &sine_b, &cosine_b);
        near &= (truths)(absolute(a) <= MOST) & (truths)(absolute(b) <= MOST);
        sines[g] = narrowed(sine_a, sine_b);
        cosines[g] = narrowed(cosine_a, cosine_b);
        stream_lines(stream);
    }
    if (!any(~near)) {
        return;
    }
    for (ptrdiff_t g = 0; g < groups; g++) {
        for (int i = 0; i < LANESF; i++) {
            const float x = angles[g][i];
            if (!(fabsf(x) <= (float)MOST)) {
                sines[g][i] = sinf(x);
                cosines[g][i] = cosf(x);
            }
        }
    }
}

void CHASLES_LEVELED(chasles_directions)(doubles *y, const doubles *x)
{
    if (alike(*x) && alike(*y)) {
        *y = spread(atan2((*y)[0], (*x)[0]));
        return;
    }
    for (int i = 0; i < LANES; i++) {
        (*y)[i] = atan2((*y)[i], (*x)[i]);
    }
}

void CHASLES_LEVELED(chasles_directionsf)(floats *y, const floats *x)
{
    if (alikef(*x) && alikef(*y)) {
        *y = spreadf(atan2f((*y)[0], (*x)[0]));
        return;
    }
    for (int i = 0; i < LANESF; i++) {
        (*y)[i] = atan2f((*y)[i], (*x)[i]);
    }
}

#else

/* Without vector types nothing is to be done; a file must not be empty. */
typedef int chasles_nothing;

#endif
