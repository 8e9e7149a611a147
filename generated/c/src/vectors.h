/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
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

/* What shuffles do not say well: gcc takes what a shuffle joins to registers first, which costs a move on the one port for
 * it. gcc's header of these takes longer to read than most blocks take to compile. */
#if CHASLES_LEVEL >= 1 && !defined(__clang__)
typedef double of_2 __attribute__((vector_size(16)));
typedef double of_4 __attribute__((vector_size(32)));
#define JOINED_2(a, b) __builtin_ia32_vinsertf128_pd256(__builtin_ia32_pd256_pd((of_2)(a)), (of_2)(b), 1)
#elif CHASLES_LEVEL >= 1
#define JOINED_2(a, b) SHUFFLE(a, b, 0, 1, 2, 3)
#endif
#if CHASLES_LEVEL == 2 && !defined(__clang__)
typedef double of_8 __attribute__((vector_size(64)));
typedef float of_16 __attribute__((vector_size(64)));
#define JOINED_4(a, b) \
    __builtin_ia32_insertf64x4_mask(__builtin_ia32_pd512_256pd((of_4)(a)), (of_4)(b), 1, (of_8){0}, 0xff)
#define PART_OF_2(x, k) __builtin_ia32_extractf64x2_512_mask((of_8)(x), k, (of_2){0}, 0xff)
#define PART_OF_4(x, k) __builtin_ia32_extractf64x4_mask((of_8)(x), k, (of_4){0}, 0xff)
#define ROOTS(x) __builtin_ia32_sqrtpd512_mask((of_8)(x), (of_8){0}, -1, 4)
#define ROOTSF(x) __builtin_ia32_sqrtps512_mask((of_16)(x), (of_16){0}, -1, 4)
#elif CHASLES_LEVEL == 2
#include <immintrin.h>
#define JOINED_4(a, b) _mm512_insertf64x4(_mm512_castpd256_pd512((__m256d)(a)), (__m256d)(b), 1)
#define PART_OF_2(x, k) _mm512_extractf64x2_pd((__m512d)(x), k)
#define PART_OF_4(x, k) _mm512_extractf64x4_pd((__m512d)(x), k)
#define ROOTS(x) _mm512_sqrt_pd((__m512d)(x))
#define ROOTSF(x) _mm512_sqrt_ps((__m512)(x))
#endif
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#if CHASLES_LEVEL == 1 && !(defined(__AVX2__) && defined(__FMA__))
#error "level 1 is x86-64-v3: compile this file with -march=x86-64-v3"
#endif
#if CHASLES_LEVEL == 2 && !(defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__))
#error "level 2 is x86-64-v4: compile this file with -march=x86-64-v4"
#endif

#define CHASLES_INLINE static inline __attribute__((always_inline, unused))
#ifdef __clang__
#define CHASLES_APART __attribute__((noinline))
#else
#define CHASLES_APART __attribute__((noinline, noclone))
#endif
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
#elif CHASLES_REGISTER == 32
#define LOWER(a, b) SHUFFLE(a, b, 0, 4, 2, 6)
#define UPPER(a, b) SHUFFLE(a, b, 1, 5, 3, 7)
#define LOWERF(a, b) SHUFFLE(a, b, 0, 8, 1, 9, 4, 12, 5, 13)
#define UPPERF(a, b) SHUFFLE(a, b, 2, 10, 3, 11, 6, 14, 7, 15)
#define EVENF(a, b) SHUFFLE(a, b, 0, 2, 8, 10, 4, 6, 12, 14)
#define ODDF(a, b) SHUFFLE(a, b, 1, 3, 9, 11, 5, 7, 13, 15)
#else
#define LOWER(a, b) SHUFFLE(a, b, 0, 8, 2, 10, 4, 12, 6, 14)
#define UPPER(a, b) SHUFFLE(a, b, 1, 9, 3, 11, 5, 13, 7, 15)
#define LOWERF(a, b) SHUFFLE(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29)
#define UPPERF(a, b) SHUFFLE(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31)
#define EVENF(a, b) SHUFFLE(a, b, 0, 2, 16, 18, 4, 6, 20, 22, 8, 10, 24, 26, 12, 14, 28, 30)
#define ODDF(a, b) SHUFFLE(a, b, 1, 3, 17, 19, 5, 7, 21, 23, 9, 11, 25, 27, 13, 15, 29, 31)
#endif

/* A register of one number that `at` gives for each of the first lanes: two, four, eight or sixteen. */
#define LIST_2(at) {at(0), at(1)}
#define LIST_4(at) {at(0), at(1), at(2), at(3)}
#define LIST_8(at) {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)}
#define LIST_16(at) \
    {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8), at(9), at(10), at(11), at(12), at(13), at(14), at(15)}
#if CHASLES_REGISTER == 16
#define LIST LIST_2
#define LISTF LIST_4
#elif CHASLES_REGISTER == 32
#define LIST LIST_4
#define LISTF LIST_8
#else
#define LIST LIST_8
#define LISTF LIST_16
#endif

CHASLES_INLINE doubles spread(double x)
{
#define AT(i) x
    const doubles all = LIST(AT);
#undef AT
    return all;
}

CHASLES_INLINE doubles roots(doubles x)
{
#if CHASLES_REGISTER == 64
    return (doubles)ROOTS(x);
#else
#define AT(i) sqrt(x[i])
    const doubles all = LIST(AT);
#undef AT
    return all;
#endif
}

/* Whether all lanes hold the same number, as where an item is computed alone. */
CHASLES_INLINE int alike(doubles x)
{
    const truths apart = (truths)x ^ (truths)spread(x[0]);
    long long any = 0;
    for (int i = 0; i < LANES; i++) {
        any |= apart[i];
    }
    return !any;
}

CHASLES_INLINE truths less(doubles a, doubles b)
{
    return (truths)(a < b);
}

CHASLES_INLINE truths equal(doubles a, doubles b)
{
    return (truths)(a == b);
}

/* a where it is true, else b; nothing is computed. */
CHASLES_INLINE doubles choose(truths is, doubles a, doubles b)
{
    return (doubles)((is & (truths)a) | (~is & (truths)b));
}

CHASLES_INLINE floats spreadf(float x)
{
#define AT(i) x
    const floats all = LISTF(AT);
#undef AT
    return all;
}

CHASLES_INLINE floats rootsf(floats x)
{
#if CHASLES_REGISTER == 64
    return (floats)ROOTSF(x);
#else
#define AT(i) sqrtf(x[i])
    const floats all = LISTF(AT);
#undef AT
    return all;
#endif
}

/* Whether all lanes hold the same number, as where an item is computed alone. */
CHASLES_INLINE int alikef(floats x)
{
    const truthsf apart = (truthsf)x ^ (truthsf)spreadf(x[0]);
    long long any = 0;
    for (int i = 0; i < LANESF; i++) {
        any |= apart[i];
    }
    return !any;
}

CHASLES_INLINE truthsf lessf(floats a, floats b)
{
    return (truthsf)(a < b);
}

CHASLES_INLINE truthsf equalf(floats a, floats b)
{
    return (truthsf)(a == b);
}

/* a where it is true, else b; nothing is computed. */
CHASLES_INLINE floats choosef(truthsf is, floats a, floats b)
{
    return (floats)((is & (truthsf)a) | (~is & (truthsf)b));
}

/* 16 bytes of the item `first`, then, while a register has room, of that `apart` items on. */
CHASLES_INLINE doubles row(const char *at, ptrdiff_t step, int first, int apart)
{
#define PART(k) (*(const double_2 *)(at + (first + (k) * apart) * step))
#if CHASLES_REGISTER == 16
    (void)apart;
    return (doubles)PART(0);
#elif CHASLES_REGISTER == 32
    return (doubles)JOINED_2(PART(0), PART(1));
#else
    return (doubles)JOINED_4(JOINED_2(PART(0), PART(1)), JOINED_2(PART(2), PART(3)));
#endif
#undef PART
}

CHASLES_INLINE floats rowf(const char *at, ptrdiff_t step, int first)
{
    return (floats)row(at, step, first, 4);
}

/* A register of numbers that lie one after the other in memory. */
typedef double packed_doubles
    __attribute__((vector_size(CHASLES_REGISTER), aligned(sizeof(double)), may_alias));

#define PACKED(at, k) (*(packed_doubles *)((at) + CHASLES_REGISTER * (k)))
#define PACKED_IN(at, k) (*(const packed_doubles *)((at) + CHASLES_REGISTER * (k)))
typedef float packed_floats
    __attribute__((vector_size(CHASLES_REGISTER), aligned(sizeof(float)), may_alias));

#define PACKEDF(at, k) (*(packed_floats *)((at) + CHASLES_REGISTER * (k)))
#define PACKEDF_IN(at, k) (*(const packed_floats *)((at) + CHASLES_REGISTER * (k)))

/* Asks for so many registers that are soon read, as if there were no gaps, where that is to be done `ahead`. */
CHASLES_INLINE void prefetch(const char *at, ptrdiff_t registers, int ahead)
{
#if CHASLES_REGISTER == 64
    for (ptrdiff_t k = 0; k < registers * CHASLES_LINE && ahead; k += CHASLES_LINE) {
        __builtin_prefetch(at + 16 * CHASLES_LINE + k);
    }
#else
    (void)at, (void)registers, (void)ahead;
#endif
}

/* Asks for memory that is soon written, of a group of items of so many numbers. Where there are gaps between items no line
 * is written whole, so that each is read before: without asking large batches would take half as long again. */
CHASLES_INLINE void prefetch_to_write(const char *at, ptrdiff_t step, ptrdiff_t count, ptrdiff_t number, int ahead)
{
#define ASK(to) __asm__ volatile("prefetchw %0" : : "m"(*(to)))
#if CHASLES_REGISTER >= 32
    if (step > count * number || -step >= count * number) {
        const ptrdiff_t lanes = CHASLES_REGISTER / number;
        const char *const later = at + (count * number > 2 * CHASLES_LINE ? lanes : CHASLES_BLOCK / 4) * step;
        for (ptrdiff_t i = 0; i < lanes; i++) {
            for (ptrdiff_t k = 0; k < count * number; k += CHASLES_LINE) {
                ASK(later + i * step + k);
            }
        }
        return;
    }
#endif
#if CHASLES_REGISTER == 64
    for (ptrdiff_t k = 0; k < count * CHASLES_LINE && ahead; k += CHASLES_LINE) {
        ASK(at + 8 * CHASLES_LINE + k);
    }
#endif
#undef ASK
    (void)at, (void)step, (void)count, (void)number, (void)ahead;
}

/* Copies a share of what is to be copied on the way, around the cache: where the rest is computed memory would idle. */
CHASLES_INLINE void stream_lines(chasles_stream *stream)
{
#ifdef __SSE2__
    for (ptrdiff_t i = 0; i < stream->share && stream->lines > 0; i++) {
        for (int k = 0; k < CHASLES_LINE; k += 16) {
            const __m128i part = _mm_load_si128((const __m128i *)(const void *)(stream->from + k));
            _mm_stream_si128((__m128i *)(void *)(stream->to + k), part);
        }
        stream->from += CHASLES_LINE;
        stream->to += CHASLES_LINE;
        stream->lines--;
    }
#else
    (void)stream;
#endif
}

/* One to four numbers that lie side by side in each item. */
CHASLES_INLINE void load_1(const char *at, ptrdiff_t step, doubles *to)
{
    if (step == 0) {
        to[0] = spread(*(const double *)at);
        return;
    }
    if (step == sizeof(double)) {
        to[0] = PACKED_IN(at, 0);
        return;
    }
#define AT(i) *(const double *)(at + (i) * step)
    const doubles all = LIST(AT);
#undef AT
    to[0] = all;
}

CHASLES_INLINE void store_1(char *at, ptrdiff_t step, doubles x)
{
    if (step == sizeof(double)) {
        PACKED(at, 0) = x;
        return;
    }
    for (int i = 0; i < LANES; i++) {
        *(double *)(at + i * step) = x[i];
    }
}

CHASLES_INLINE void load_1f(const char *at, ptrdiff_t step, floats *to)
{
    if (step == 0) {
        to[0] = spreadf(*(const float *)at);
        return;
    }
    if (step == sizeof(float)) {
        to[0] = PACKEDF_IN(at, 0);
        return;
    }
#define AT(i) *(const float *)(at + (i) * step)
    const floats all = LISTF(AT);
#undef AT
    to[0] = all;
}

CHASLES_INLINE void store_1f(char *at, ptrdiff_t step, floats x)
{
    if (step == sizeof(float)) {
        PACKEDF(at, 0) = x;
        return;
    }
    for (int i = 0; i < LANESF; i++) {
        *(float *)(at + i * step) = x[i];
    }
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

CHASLES_INLINE void load_3(const char *at, ptrdiff_t step, doubles *to)
{
#if CHASLES_REGISTER == 64
    if (step == 3 * sizeof(double)) {
        const doubles a = PACKED_IN(at, 0), b = PACKED_IN(at, 1), c = PACKED_IN(at, 2);
        /* Blends take another port than what moves numbers between lanes; the three of one kind were slower. */
        const doubles firsts = SHUFFLE(SHUFFLE(a, b, 0, 9, 2, 3, 12, 5, 6, 15), c, 0, 1, 10, 3, 4, 13, 6, 7);
        to[0] = SHUFFLE(firsts, firsts, 0, 3, 6, 1, 4, 7, 2, 5);
        to[1] = SHUFFLE(SHUFFLE(a, b, 1, 4, 7, 10, 13, 0, 0, 0), c, 0, 1, 2, 3, 4, 8, 11, 14);
        to[2] = SHUFFLE(SHUFFLE(a, b, 2, 5, 8, 11, 14, 0, 0, 0), c, 0, 1, 2, 3, 4, 9, 12, 15);
        return;
    }
#elif CHASLES_REGISTER == 32
    if (step == 3 * sizeof(double)) {
#define HALVES(k) (doubles)JOINED_2(*(const double_2 *)(at + 16 * (k)), *(const double_2 *)(at + 16 * (k) + 48))
        const doubles a = HALVES(0), b = HALVES(1), c = HALVES(2);
#undef HALVES
        to[0] = SHUFFLE(a, b, 0, 5, 2, 7);
        to[1] = SHUFFLE(a, c, 1, 4, 3, 6);
        to[2] = SHUFFLE(b, c, 0, 5, 2, 7);
        return;
    }
#endif
    load_2(at, step, to);
    load_1(at + 2 * sizeof(double), step, to + 2);
}

CHASLES_INLINE void load_3f(const char *at, ptrdiff_t step, floats *to)
{
#if CHASLES_REGISTER == 64
    if (step == 3 * sizeof(float)) {
        const floats a = PACKEDF_IN(at, 0), b = PACKEDF_IN(at, 1), c = PACKEDF_IN(at, 2);
        const floats first = SHUFFLE(a, b, 0, 3, 6, 9, 12, 15, 18, 21, 24, 27, 30, 0, 0, 0, 0, 0);
        const floats second = SHUFFLE(a, b, 1, 4, 7, 10, 13, 16, 19, 22, 25, 28, 31, 0, 0, 0, 0, 0);
        const floats third = SHUFFLE(a, b, 2, 5, 8, 11, 14, 17, 20, 23, 26, 29, 0, 0, 0, 0, 0, 0);
        to[0] = SHUFFLE(first, c, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 17, 20, 23, 26, 29);
        to[1] = SHUFFLE(second, c, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 18, 21, 24, 27, 30);
        to[2] = SHUFFLE(third, c, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 16, 19, 22, 25, 28, 31);
        return;
    }
#endif
    load_2f(at, step, to);
    load_1f(at + 2 * sizeof(float), step, to + 2);
}

CHASLES_INLINE void load_4(const char *at, ptrdiff_t step, doubles *to)
{
#if CHASLES_REGISTER == 64
#define ROW(i) (*(const double_4 *)(at + (i) * step))
#define ROWS(i, j) (doubles)JOINED_4(ROW(i), ROW(j))
    const doubles a = ROWS(0, 2), b = ROWS(1, 3), c = ROWS(4, 6), d = ROWS(5, 7);
#undef ROWS
#undef ROW
    const doubles ab = LOWER(a, b), cd = LOWER(c, d), ab_ = UPPER(a, b), cd_ = UPPER(c, d);
    to[0] = SHUFFLE(ab, cd, 0, 1, 4, 5, 8, 9, 12, 13);
    to[1] = SHUFFLE(ab_, cd_, 0, 1, 4, 5, 8, 9, 12, 13);
    to[2] = SHUFFLE(ab, cd, 2, 3, 6, 7, 10, 11, 14, 15);
    to[3] = SHUFFLE(ab_, cd_, 2, 3, 6, 7, 10, 11, 14, 15);
#else
    load_2(at, step, to);
    load_2(at + 2 * sizeof(double), step, to + 2);
#endif
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
#define PART(k) *(double_2 *)(at + (first + (k) * apart) * step)
#if CHASLES_REGISTER == 32
    PART(0) = SHUFFLE(x, x, 0, 1);
    PART(1) = SHUFFLE(x, x, 2, 3);
#else
    PART(0) = (double_2)SHUFFLE(x, x, 0, 1);
    PART(1) = (double_2)PART_OF_2(x, 1);
    PART(2) = (double_2)PART_OF_2(x, 2);
    PART(3) = (double_2)PART_OF_2(x, 3);
#endif
#undef PART
#endif
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

CHASLES_INLINE void store_3(char *at, ptrdiff_t step, doubles x, doubles y, doubles z)
{
#if CHASLES_REGISTER == 64
    if (step == 3 * sizeof(double)) {
        PACKED(at, 0) = SHUFFLE(SHUFFLE(x, y, 0, 8, 0, 1, 9, 0, 2, 10), z, 0, 1, 8, 3, 4, 9, 6, 7);
        PACKED(at, 1) = SHUFFLE(SHUFFLE(x, y, 0, 3, 11, 0, 4, 12, 0, 5), z, 10, 1, 2, 11, 4, 5, 12, 7);
        PACKED(at, 2) = SHUFFLE(SHUFFLE(x, y, 13, 0, 6, 14, 0, 7, 15, 0), z, 0, 13, 2, 3, 14, 5, 6, 15);
        return;
    }
#elif CHASLES_REGISTER == 32
    if (step == 3 * sizeof(double)) {
        const doubles a = SHUFFLE(x, y, 0, 4, 2, 6), b = SHUFFLE(z, x, 0, 5, 2, 7), c = SHUFFLE(y, z, 1, 5, 3, 7);
        *(double_4 *)at = (double_4)SHUFFLE(a, b, 0, 1, 4, 5);
        *(double_4 *)(at + 32) = (double_4)SHUFFLE(c, a, 0, 1, 6, 7);
        *(double_4 *)(at + 64) = (double_4)SHUFFLE(b, c, 2, 3, 6, 7);
        return;
    }
#endif
    store_2(at, step, x, y);
    store_1(at + 2 * sizeof(double), step, z);
}

CHASLES_INLINE void store_3f(char *at, ptrdiff_t step, floats x, floats y, floats z)
{
#if CHASLES_REGISTER == 64
    if (step == 3 * sizeof(float)) {
        const floats a = SHUFFLE(x, y, 0, 16, 0, 1, 17, 0, 2, 18, 0, 3, 19, 0, 4, 20, 0, 5);
        const floats b = SHUFFLE(x, y, 21, 0, 6, 22, 0, 7, 23, 0, 8, 24, 0, 9, 25, 0, 10, 26);
        const floats c = SHUFFLE(x, y, 0, 11, 27, 0, 12, 28, 0, 13, 29, 0, 14, 30, 0, 15, 31, 0);
        PACKEDF(at, 0) = SHUFFLE(a, z, 0, 1, 16, 3, 4, 17, 6, 7, 18, 9, 10, 19, 12, 13, 20, 15);
        PACKEDF(at, 1) = SHUFFLE(b, z, 0, 21, 2, 3, 22, 5, 6, 23, 8, 9, 24, 11, 12, 25, 14, 15);
        PACKEDF(at, 2) = SHUFFLE(c, z, 26, 1, 2, 27, 4, 5, 28, 7, 8, 29, 10, 11, 30, 13, 14, 31);
        return;
    }
#endif
    store_2f(at, step, x, y);
    store_1f(at + 2 * sizeof(float), step, z);
}

#if CHASLES_REGISTER == 64
/* Four numbers of items: `to[i]` has those of item i, then those of item 4 + i. */
CHASLES_INLINE void across_4(doubles x, doubles y, doubles z, doubles w, doubles *to)
{
    const doubles even = LOWER(x, y), odd = UPPER(x, y), even_ = LOWER(z, w), odd_ = UPPER(z, w);
    to[0] = SHUFFLE(even, even_, 0, 1, 8, 9, 4, 5, 12, 13);
    to[1] = SHUFFLE(odd, odd_, 0, 1, 8, 9, 4, 5, 12, 13);
    to[2] = SHUFFLE(even, even_, 2, 3, 10, 11, 6, 7, 14, 15);
    to[3] = SHUFFLE(odd, odd_, 2, 3, 10, 11, 6, 7, 14, 15);
}
#endif

CHASLES_INLINE void store_4(char *at, ptrdiff_t step, doubles x, doubles y, doubles z, doubles w)
{
#define FOUR(i) *(double_4 *)(at + (i) * step)
#if CHASLES_REGISTER == 16
    store_2(at, step, x, y);
    store_2(at + 2 * sizeof(double), step, z, w);
#elif CHASLES_REGISTER == 32
    const doubles even = LOWER(x, y), odd = UPPER(x, y), even_ = LOWER(z, w), odd_ = UPPER(z, w);
    FOUR(0) = (double_4)SHUFFLE(even, even_, 0, 1, 4, 5);
    FOUR(1) = (double_4)SHUFFLE(odd, odd_, 0, 1, 4, 5);
    FOUR(2) = (double_4)SHUFFLE(even, even_, 2, 3, 6, 7);
    FOUR(3) = (double_4)SHUFFLE(odd, odd_, 2, 3, 6, 7);
#else
    doubles all[4];
    across_4(x, y, z, w, all);
    for (int i = 0; i < 4; i++) {
        FOUR(i) = (double_4)PART_OF_4(all[i], 0);
        FOUR(4 + i) = (double_4)PART_OF_4(all[i], 1);
    }
#endif
#undef FOUR
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

#define IN_ORDER (CHASLES_REGISTER == 64)
#define IN_ORDERF 0
#if IN_ORDER
/* Up to twelve numbers of items, item by item: where memory is what takes the time it is best written in its order. More
 * would not stay in registers. */
CHASLES_INLINE void store_in_order(char *at, ptrdiff_t step, int count, const doubles *x)
{
    const int whole = count / 4 * 4, rest = count - whole;
    doubles fours[12], pairs[2];
    for (int k = 0; k < whole; k += 4) {
        across_4(x[k], x[k + 1], x[k + 2], x[k + 3], fours + k);
    }
    if (rest >= 2) {
        pairs[0] = LOWER(x[whole], x[whole + 1]);
        pairs[1] = UPPER(x[whole], x[whole + 1]);
    }
#define ITEM(i) \
    for (int k = 0; k < whole; k += 4) { \
        *(double_4 *)(at + (i) * step + k * (int)sizeof(double)) = (double_4)PART_OF_4(fours[k + (i) % 4], (i) / 4); \
    } \
    if (rest >= 2) { \
        *(double_2 *)(at + (i) * step + whole * (int)sizeof(double)) = (double_2)PART_OF_2(pairs[(i) % 2], (i) / 2); \
    } \
    if (rest % 2 > 0) { \
        *(double *)(at + (i) * step + (count - 1) * (int)sizeof(double)) = x[count - 1][i]; \
    }
    ITEM(0) ITEM(1) ITEM(2) ITEM(3) ITEM(4) ITEM(5) ITEM(6) ITEM(7)
#undef ITEM
}
#endif

/* All numbers of items, four at a time where they are not stored item by item. */
CHASLES_INLINE void store_all(
    char *at, ptrdiff_t step, int count, const doubles *x)
{
#if IN_ORDER
    if (4 < count && count <= 12) {
        store_in_order(at, step, count, x);
        return;
    }
#endif
    const int whole = count / 4 * 4;
    for (int k = 0; k < whole; k += 4) {
        store_4(at, step, x[k], x[k + 1], x[k + 2], x[k + 3]);
        at += 4 * sizeof(double);
    }
    if (count - whole == 3) {
        store_3(at, step, x[whole], x[whole + 1], x[whole + 2]);
    } else if (count - whole == 2) {
        store_2(at, step, x[whole], x[whole + 1]);
    } else if (count - whole == 1) {
        store_1(at, step, x[whole]);
    }
}

/* All numbers of items, four at a time where they are not stored item by item. */
CHASLES_INLINE void store_allf(
    char *at, ptrdiff_t step, int count, const floats *x)
{
#if IN_ORDERF
    if (4 < count && count <= 12) {
        store_in_order(at, step, count, x);
        return;
    }
#endif
    const int whole = count / 4 * 4;
    for (int k = 0; k < whole; k += 4) {
        store_4f(at, step, x[k], x[k + 1], x[k + 2], x[k + 3]);
        at += 4 * sizeof(float);
    }
    if (count - whole == 3) {
        store_3f(at, step, x[whole], x[whole + 1], x[whole + 2]);
    } else if (count - whole == 2) {
        store_2f(at, step, x[whole], x[whole + 1]);
    } else if (count - whole == 1) {
        store_1f(at, step, x[whole]);
    }
}

/* Whether the items of an operand, of so many numbers, are packed; `core` has the steps down and across in an item. */
CHASLES_INLINE int is_packed(ptrdiff_t count, ptrdiff_t columns, ptrdiff_t size, ptrdiff_t step, const ptrdiff_t *core)
{
    return step == count * size && core[0] == columns * size && core[1] == size;
}

/* Whether the numbers of an item lie one after the other, and items apart. If not, `entries` says how many bytes each lies
 * behind the first: `core` has the steps between rows of so many columns, and in a row. */
static CHASLES_APART __attribute__((unused)) int find_entries(
    ptrdiff_t count, ptrdiff_t columns, ptrdiff_t size, ptrdiff_t step, const ptrdiff_t *core, ptrdiff_t *entries)
{
    if (core[1] == size && core[0] == columns * size && step != 0) {
        return 1;
    }
    for (ptrdiff_t k = 0, row = 0; k < count; row += core[0]) {
        for (ptrdiff_t entry = row, end = k + columns; k < end; k++, entry += core[1]) {
            entries[k] = entry;
        }
    }
    return 0;
}

/* All numbers of each item, wherever they lie. */
static CHASLES_APART __attribute__((unused)) void take_each(
    const char *at, const ptrdiff_t *entries, ptrdiff_t step, int count, doubles *to)
{
    for (int k = 0; k < count; k++) {
        if (step == sizeof(double)) {
            to[k] = PACKED_IN(at + entries[k], 0);
        } else {
            load_1(at + entries[k], step, to + k);
        }
    }
}

static CHASLES_APART __attribute__((unused)) void give_each(
    char *at, const ptrdiff_t *entries, ptrdiff_t step, int count, const doubles *all)
{
    for (int k = 0; k < count; k++) {
        if (step == sizeof(double)) {
            PACKED(at + entries[k], 0) = all[k];
        } else {
            store_1(at + entries[k], step, all[k]);
        }
    }
}

static CHASLES_APART __attribute__((unused)) void take_eachf(
    const char *at, const ptrdiff_t *entries, ptrdiff_t step, int count, floats *to)
{
    for (int k = 0; k < count; k++) {
        if (step == sizeof(float)) {
            to[k] = PACKEDF_IN(at + entries[k], 0);
        } else {
            load_1f(at + entries[k], step, to + k);
        }
    }
}

static CHASLES_APART __attribute__((unused)) void give_eachf(
    char *at, const ptrdiff_t *entries, ptrdiff_t step, int count, const floats *all)
{
    for (int k = 0; k < count; k++) {
        if (step == sizeof(float)) {
            PACKEDF(at + entries[k], 0) = all[k];
        } else {
            store_1f(at + entries[k], step, all[k]);
        }
    }
}

#ifdef __cplusplus
extern "C" {
#endif

/* The sine and cosine of each angle of some groups, within 0.8 units in the last place below 1.6e6, libm's beyond; with
 * each group a share of the stream. */
void CHASLES_LEVELED(chasles_sincos)(
    ptrdiff_t groups, doubles *angles, doubles *sines, doubles *cosines, chasles_stream *stream);
void CHASLES_LEVELED(chasles_sincosf)(
    ptrdiff_t groups, floats *angles, floats *sines, floats *cosines, chasles_stream *stream);

/* libm's angle of the point (x, y), lane by lane. */
void CHASLES_LEVELED(chasles_directions)(doubles *y, const doubles *x);
void CHASLES_LEVELED(chasles_directionsf)(floats *y, const floats *x);

#ifdef __cplusplus
}
#endif

/* A function of libm, lane by lane: a file of blocks begins with those that it calls. */
#define CHASLES_LANEWISE_1(name) \
    CHASLES_INLINE doubles name##_of(doubles x) \
    { \
        if (alike(x)) { \
            return spread(name(x[0])); \
        } \
        for (int i = 0; i < LANES; i++) { \
            x[i] = name(x[i]); \
        } \
        return x; \
    } \
    CHASLES_INLINE floats name##_off(floats x) \
    { \
        if (alikef(x)) { \
            return spreadf(name##f(x[0])); \
        } \
        for (int i = 0; i < LANESF; i++) { \
            x[i] = name##f(x[i]); \
        } \
        return x; \
    }
#define CHASLES_LANEWISE_2(name) \
    CHASLES_INLINE doubles name##_of(doubles x, doubles y) \
    { \
        if (alike(x) && alike(y)) { \
            return spread(name(x[0], y[0])); \
        } \
        for (int i = 0; i < LANES; i++) { \
            x[i] = name(x[i], y[i]); \
        } \
        return x; \
    } \
    CHASLES_INLINE floats name##_off(floats x, floats y) \
    { \
        if (alikef(x) && alikef(y)) { \
            return spreadf(name##f(x[0], y[0])); \
        } \
        for (int i = 0; i < LANESF; i++) { \
            x[i] = name##f(x[i], y[i]); \
        } \
        return x; \
    }

CHASLES_INLINE doubles sine_of(doubles x)
{
    chasles_stream none = {0, 0, 0, 0, 0};
    doubles sine, cosine;
    CHASLES_LEVELED(chasles_sincos)(1, &x, &sine, &cosine, &none);
    return sine;
}

CHASLES_INLINE doubles cosine_of(doubles x)
{
    chasles_stream none = {0, 0, 0, 0, 0};
    doubles sine, cosine;
    CHASLES_LEVELED(chasles_sincos)(1, &x, &sine, &cosine, &none);
    return cosine;
}

CHASLES_INLINE doubles directions(doubles y, doubles x)
{
    CHASLES_LEVELED(chasles_directions)(&y, &x);
    return y;
}

CHASLES_INLINE floats sine_off(floats x)
{
    chasles_stream none = {0, 0, 0, 0, 0};
    floats sine, cosine;
    CHASLES_LEVELED(chasles_sincosf)(1, &x, &sine, &cosine, &none);
    return sine;
}

CHASLES_INLINE floats cosine_off(floats x)
{
    chasles_stream none = {0, 0, 0, 0, 0};
    floats sine, cosine;
    CHASLES_LEVELED(chasles_sincosf)(1, &x, &sine, &cosine, &none);
    return cosine;
}

CHASLES_INLINE floats directionsf(floats y, floats x)
{
    CHASLES_LEVELED(chasles_directionsf)(&y, &x);
    return y;
}

#endif

#endif
