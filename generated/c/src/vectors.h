/* Registers of numbers, for the blocks alone. Made by `chasles emit`; not to be edited by hand.
 *
 * `doubles` and `floats` fill a register of the level; an operation on them is one on each lane. NAMEf is NAME in single
 * precision. Items lie one `step` of bytes after the other; lane i belongs to item i.
 */
#ifndef CHASLES_VECTORS_H
#define CHASLES_VECTORS_H

#include "batches.h"

#if CHASLES_VECTORS

#include <math.h>
#include <stddef.h>

#if CHASLES_LEVEL == 1 && !(defined(__AVX2__) && defined(__FMA__))
#error "level 1 is x86-64-v3: compile this file with -march=x86-64-v3"
#endif

#define CHASLES_INLINE static inline __attribute__((always_inline, unused))
#define CHASLES_VECTOR(bytes) __attribute__((vector_size(bytes), may_alias))

typedef double doubles CHASLES_VECTOR(CHASLES_REGISTER);
typedef float floats CHASLES_VECTOR(CHASLES_REGISTER);
typedef long long truths CHASLES_VECTOR(CHASLES_REGISTER);
typedef int truthsf CHASLES_VECTOR(CHASLES_REGISTER);

#define LANES ((ptrdiff_t)(sizeof(doubles) / sizeof(double)))
#define LANESF ((ptrdiff_t)(sizeof(floats) / sizeof(float)))
#define GROUPS (CHASLES_BLOCK / LANES)
#define GROUPSF (CHASLES_BLOCK / LANESF)

/* Two numbers, four, and two pairs, as they lie in memory; a pair of floats is moved as one double. */
typedef double double_2 __attribute__((vector_size(16), aligned(4), may_alias));
typedef double double_4 __attribute__((vector_size(32), aligned(4), may_alias));
typedef float float_4 __attribute__((vector_size(16), aligned(4), may_alias));
typedef double pair __attribute__((aligned(4), may_alias));

#define SHUFFLE __builtin_shufflevector

/* Within each 16 bytes: the lower or upper halves of two registers, numbers alternating; their numbers 0, 2 or 1, 3. */
#if CHASLES_REGISTER == 16
#define LOWER(a, b) SHUFFLE(a, b, 0, 2)
#define UPPER(a, b) SHUFFLE(a, b, 1, 3)
#define LOWERF(a, b) SHUFFLE(a, b, 0, 4, 1, 5)
#define UPPERF(a, b) SHUFFLE(a, b, 2, 6, 3, 7)
#define EVENF(a, b) SHUFFLE(a, b, 0, 2, 4, 6)
#define ODDF(a, b) SHUFFLE(a, b, 1, 3, 5, 7)
#else
#define LOWER(a, b) SHUFFLE(a, b, 0, 4, 2, 6)
#define UPPER(a, b) SHUFFLE(a, b, 1, 5, 3, 7)
#define LOWERF(a, b) SHUFFLE(a, b, 0, 8, 1, 9, 4, 12, 5, 13)
#define UPPERF(a, b) SHUFFLE(a, b, 2, 10, 3, 11, 6, 14, 7, 15)
#define EVENF(a, b) SHUFFLE(a, b, 0, 2, 8, 10, 4, 6, 12, 14)
#define ODDF(a, b) SHUFFLE(a, b, 1, 3, 9, 11, 5, 7, 13, 15)
#endif

/* A register of one number that `at` gives for each of the first lanes: two, four or eight. */
#define LIST_2(at) {at(0), at(1)}
#define LIST_4(at) {at(0), at(1), at(2), at(3)}
#define LIST_8(at) {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)}
#if CHASLES_REGISTER == 16
#define LIST LIST_2
#define LISTF LIST_4
#else
#define LIST LIST_4
#define LISTF LIST_8
#endif

CHASLES_INLINE doubles spread(double x)
{
#define AT(i) x
    const doubles all = LIST(AT);
    return all;
}

CHASLES_INLINE floats spreadf(float x)
{
    const floats all = LISTF(AT);
#undef AT
    return all;
}

CHASLES_INLINE doubles roots(doubles x)
{
#define AT(i) sqrt(x[i])
    const doubles all = LIST(AT);
#undef AT
    return all;
}

CHASLES_INLINE floats rootsf(floats x)
{
#define AT(i) sqrtf(x[i])
    const floats all = LISTF(AT);
#undef AT
    return all;
}

CHASLES_INLINE truths less(doubles a, doubles b)
{
    return (truths)(a < b);
}

CHASLES_INLINE truthsf lessf(floats a, floats b)
{
    return (truthsf)(a < b);
}

CHASLES_INLINE truths equal(doubles a, doubles b)
{
    return (truths)(a == b);
}

CHASLES_INLINE truthsf equalf(floats a, floats b)
{
    return (truthsf)(a == b);
}

/* a where it is true, else b; nothing is computed. */
CHASLES_INLINE doubles choose(truths is, doubles a, doubles b)
{
    return (doubles)((is & (truths)a) | (~is & (truths)b));
}

CHASLES_INLINE floats choosef(truthsf is, floats a, floats b)
{
    return (floats)((is & (truthsf)a) | (~is & (truthsf)b));
}

/* 16 bytes of the item `first`, then, where a register has room, of the item `first + apart`. */
CHASLES_INLINE doubles row(const char *at, ptrdiff_t step, int first, int apart)
{
#define HALF(k) (*(const double_2 *)(at + (first + (k) * apart) * step))
#if CHASLES_REGISTER == 16
    (void)apart;
    return (doubles)HALF(0);
#else
    return SHUFFLE(HALF(0), HALF(1), 0, 1, 2, 3);
#endif
#undef HALF
}

CHASLES_INLINE floats rowf(const char *at, ptrdiff_t step, int first)
{
#define HALF(k) (*(const float_4 *)(at + (first + 4 * (k)) * step))
#if CHASLES_REGISTER == 16
    return (floats)HALF(0);
#else
    return SHUFFLE(HALF(0), HALF(1), 0, 1, 2, 3, 4, 5, 6, 7);
#endif
#undef HALF
}

/* One, two or four numbers that lie side by side in each item. */
CHASLES_INLINE void load_1(const char *at, ptrdiff_t step, doubles *to)
{
#define AT(i) *(const double *)(at + (i) * step)
    const doubles all = LIST(AT);
#undef AT
    to[0] = all;
}

CHASLES_INLINE void load_1f(const char *at, ptrdiff_t step, floats *to)
{
#define AT(i) *(const float *)(at + (i) * step)
    const floats all = LISTF(AT);
#undef AT
    to[0] = all;
}

CHASLES_INLINE void load_2(const char *at, ptrdiff_t step, doubles *to)
{
    const doubles even = row(at, step, 0, 2), odd = row(at, step, 1, 2);
    to[0] = LOWER(even, odd);
    to[1] = UPPER(even, odd);
}

CHASLES_INLINE void load_2f(const char *at, ptrdiff_t step, floats *to)
{
#define AT(i) *(const pair *)(at + ((i) / 2 * 4 + (i) % 2) * step)
    const doubles first = LIST(AT);
#undef AT
#define AT(i) *(const pair *)(at + ((i) / 2 * 4 + 2 + (i) % 2) * step)
    const doubles second = LIST(AT);
#undef AT
    to[0] = EVENF((floats)first, (floats)second);
    to[1] = ODDF((floats)first, (floats)second);
}

CHASLES_INLINE void load_4(const char *at, ptrdiff_t step, doubles *to)
{
    load_2(at, step, to);
    load_2(at + 2 * sizeof(double), step, to + 2);
}

CHASLES_INLINE void load_4f(const char *at, ptrdiff_t step, floats *to)
{
    const floats a = rowf(at, step, 0), b = rowf(at, step, 1), c = rowf(at, step, 2), d = rowf(at, step, 3);
    const doubles ab = (doubles)LOWERF(a, b), cd = (doubles)LOWERF(c, d);
    const doubles ab_ = (doubles)UPPERF(a, b), cd_ = (doubles)UPPERF(c, d);
    to[0] = (floats)LOWER(ab, cd);
    to[1] = (floats)UPPER(ab, cd);
    to[2] = (floats)LOWER(ab_, cd_);
    to[3] = (floats)UPPER(ab_, cd_);
}

/* The counterpart of `row`. */
CHASLES_INLINE void put_row(char *at, ptrdiff_t step, int first, int apart, doubles x)
{
#if CHASLES_REGISTER == 16
    (void)apart;
    *(double_2 *)(at + first * step) = (double_2)x;
#else
    *(double_2 *)(at + first * step) = SHUFFLE(x, x, 0, 1);
    *(double_2 *)(at + (first + apart) * step) = SHUFFLE(x, x, 2, 3);
#endif
}

CHASLES_INLINE void store_1(char *at, ptrdiff_t step, doubles x)
{
    for (int i = 0; i < LANES; i++) {
        *(double *)(at + i * step) = x[i];
    }
}

CHASLES_INLINE void store_1f(char *at, ptrdiff_t step, floats x)
{
    for (int i = 0; i < LANESF; i++) {
        *(float *)(at + i * step) = x[i];
    }
}

CHASLES_INLINE void store_2(char *at, ptrdiff_t step, doubles x, doubles y)
{
    put_row(at, step, 0, 2, LOWER(x, y));
    put_row(at, step, 1, 2, UPPER(x, y));
}

CHASLES_INLINE void store_2f(char *at, ptrdiff_t step, floats x, floats y)
{
    const doubles first = (doubles)LOWERF(x, y), second = (doubles)UPPERF(x, y);
    for (int i = 0; i < LANES; i++) {
        *(pair *)(at + (i / 2 * 4 + i % 2) * step) = first[i];
        *(pair *)(at + (i / 2 * 4 + 2 + i % 2) * step) = second[i];
    }
}

CHASLES_INLINE void store_4(char *at, ptrdiff_t step, doubles x, doubles y, doubles z, doubles w)
{
#if CHASLES_REGISTER == 16
    store_2(at, step, x, y);
    store_2(at + 2 * sizeof(double), step, z, w);
#else
    const doubles even = LOWER(x, y), odd = UPPER(x, y), even_ = LOWER(z, w), odd_ = UPPER(z, w);
#define FOUR(i) *(double_4 *)(at + (i) * step)
    FOUR(0) = (double_4)SHUFFLE(even, even_, 0, 1, 4, 5);
    FOUR(1) = (double_4)SHUFFLE(odd, odd_, 0, 1, 4, 5);
    FOUR(2) = (double_4)SHUFFLE(even, even_, 2, 3, 6, 7);
    FOUR(3) = (double_4)SHUFFLE(odd, odd_, 2, 3, 6, 7);
#undef FOUR
#endif
}

CHASLES_INLINE void store_4f(char *at, ptrdiff_t step, floats x, floats y, floats z, floats w)
{
    const doubles xy = (doubles)LOWERF(x, y), zw = (doubles)LOWERF(z, w);
    const doubles xy_ = (doubles)UPPERF(x, y), zw_ = (doubles)UPPERF(z, w);
    put_row(at, step, 0, 4, LOWER(xy, zw));
    put_row(at, step, 1, 4, UPPER(xy, zw));
    put_row(at, step, 2, 4, LOWER(xy_, zw_));
    put_row(at, step, 3, 4, UPPER(xy_, zw_));
}

#ifdef __cplusplus
extern "C" {
#endif

/* The sine and cosine of each angle of some groups, within 0.8 units in the last place below 1.6e6, libm's beyond. */
void CHASLES_LEVELED(chasles_turns)(ptrdiff_t groups, doubles *angles, doubles *sines, doubles *cosines);
void CHASLES_LEVELED(chasles_turnsf)(ptrdiff_t groups, floats *angles, floats *sines, floats *cosines);

/* libm's angle of the point (x, y), lane by lane. */
void CHASLES_LEVELED(chasles_directions)(doubles *y, const doubles *x);
void CHASLES_LEVELED(chasles_directionsf)(floats *y, const floats *x);

#ifdef __cplusplus
}
#endif

CHASLES_INLINE doubles sine_of(doubles x)
{
    doubles sine, cosine;
    CHASLES_LEVELED(chasles_turns)(1, &x, &sine, &cosine);
    return sine;
}

CHASLES_INLINE floats sine_off(floats x)
{
    floats sine, cosine;
    CHASLES_LEVELED(chasles_turnsf)(1, &x, &sine, &cosine);
    return sine;
}

CHASLES_INLINE doubles cosine_of(doubles x)
{
    doubles sine, cosine;
    CHASLES_LEVELED(chasles_turns)(1, &x, &sine, &cosine);
    return cosine;
}

CHASLES_INLINE floats cosine_off(floats x)
{
    floats sine, cosine;
    CHASLES_LEVELED(chasles_turnsf)(1, &x, &sine, &cosine);
    return cosine;
}

CHASLES_INLINE doubles directions(doubles y, doubles x)
{
    CHASLES_LEVELED(chasles_directions)(&y, &x);
    return y;
}

CHASLES_INLINE floats directionsf(floats y, floats x)
{
    CHASLES_LEVELED(chasles_directionsf)(&y, &x);
    return y;
}

#endif

#endif
