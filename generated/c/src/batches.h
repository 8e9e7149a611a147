/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* How batches are run, for the library's own files alone. Made by `chasles emit`; not to be edited by hand.
 *
 * A block computes some groups of items; a group is as many items as a register has lanes, so that an item's result
 * does not depend on where in a batch it stands. Blocks are compiled once for each level, which is a set of
 * instructions; `chasles_run` cuts a batch into blocks.
 */
#ifndef CHASLES_BATCHES_H
#define CHASLES_BATCHES_H

#include <stddef.h>

/* Vector types need shuffles: gcc from 12 on, or clang; other compilers get blocks of one scalar call after another. */
#if (defined(__clang__) || (defined(__GNUC__) && __GNUC__ >= 12)) && (defined(__SSE2__) || defined(__aarch64__))
#define CHASLES_VECTORS 1
#else
#define CHASLES_VECTORS 0
#endif

/* How many levels there are: the compiler's own target and, on x86-64, x86-64-v3 and x86-64-v4. */
#ifndef CHASLES_LEVELS
#define CHASLES_LEVELS 1
#endif

/* The level of the file that is being compiled, from 0. */
#ifndef CHASLES_LEVEL
#define CHASLES_LEVEL 0
#endif

#if CHASLES_LEVEL == 0
#define CHASLES_LEVELED(name) name##_baseline
#define CHASLES_REGISTER 16
#elif CHASLES_LEVEL == 1
#define CHASLES_LEVELED(name) name##_v3
#define CHASLES_REGISTER 32
#else
#define CHASLES_LEVELED(name) name##_v4
#define CHASLES_REGISTER 64
#endif

/* The lowest level for which blocks are compiled: lower ones are for machines that this build does not run on. */
#ifndef CHASLES_LEAST
#define CHASLES_LEAST 0
#endif
#if CHASLES_LEAST == 0
#define CHASLES_LESSER(name) name##_baseline, name##_v3
#elif CHASLES_LEAST == 1
#define CHASLES_LESSER(name) NULL, name##_v3
#else
#define CHASLES_LESSER(name) NULL, NULL
#endif

/* Whether blocks of x86-64-v4 take items with gaps between them, as there are no others; else they know the steps. */
#define CHASLES_GAPS (CHASLES_LEAST == 2)

/* Whether blocks know that all items are packed, which is row-major without gaps and one after the other; and whether
 * those that move more than they compute look if it is so: constants for steps make them half as fast again. */
#define CHASLES_PACKED (CHASLES_LEVEL == 2 && !CHASLES_GAPS)
#define CHASLES_LOOKS (CHASLES_LEVEL == 1 || (CHASLES_LEVEL == 2 && CHASLES_GAPS))
#define CHASLES_STEP(k, size) (packed ? (ptrdiff_t)(size) : steps[k])
#define CHASLES_DENSE(found) (packed || (found))

#if CHASLES_LEVELS == 1
#define CHASLES_DECLARED(name) name##_baseline
#define CHASLES_BLOCKS(name) {name##_baseline}
#elif CHASLES_LEVELS == 2
#define CHASLES_DECLARED(name) name##_baseline, name##_v3
#define CHASLES_BLOCKS(name) {CHASLES_LESSER(name)}
#else
#define CHASLES_DECLARED(name) name##_baseline, name##_v3, name##_v4
#define CHASLES_BLOCKS(name) {CHASLES_LESSER(name), name##_v4}
#endif

/* The most items in a block that keeps sines or is gathered, and in one that is not; the most operands of a kernel, and
 * the bytes in which a block's items are gathered. */
#define CHASLES_BLOCK 64
#define CHASLES_LONG_BLOCK 256
#define CHASLES_OPERANDS 32
#define CHASLES_STORE 32768

/* The bytes of a line of memory, and the most lanes that a register has. */
#define CHASLES_LINE 64
#define CHASLES_LANES 16

#ifdef __cplusplus
extern "C" {
#endif

/* What is copied around the cache, `share` lines of memory with each group: `lines` from `from` to `to`, where they begin;
 * and whether blocks ask `ahead` for memory without gaps. */
typedef struct {
    const char *from;
    char *to;
    ptrdiff_t lines;
    ptrdiff_t share;
    int ahead;
} chasles_stream;

/* Computes groups * lanes items: that of operand k starts at at[k], the next one steps[k] bytes on. Its rows are
 * steps[operands + 2 * k] bytes apart, and what is in a row steps[operands + 2 * k + 1]. */
typedef void chasles_block(ptrdiff_t groups, char *const *at, const ptrdiff_t *steps, const chasles_stream *stream);

/* The core shape of an operand: how many axes, and the rows and columns, 1 where there is no such axis. */
typedef struct {
    int axes;
    int rows;
    int columns;
} chasles_shape;

/* A kernel in one precision. `number` is the size of a number in bytes; `silent` says whether a result can be NaN
 * without an operation that is invalid, `most` how many items a block takes, `gaps` whether blocks of every level take
 * items with gaps between them, and if 2 do not copy what a stream says; operands are inputs, then outputs. */
typedef struct {
    ptrdiff_t number;
    int silent;
    int most;
    int gaps;
    int inputs;
    int operands;
    const chasles_shape *shapes;
    chasles_block *blocks[CHASLES_LEVELS];
} chasles_loop;

/* The best level, from 0, that this machine has and for which there are blocks. Said here and not in batches.c, which
 * thus is the same however many levels there are. */
static inline int chasles_best_level(void)
{
#if CHASLES_LEVELS >= 3
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")
        && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("bmi2")) {
        return 2;
    }
#endif
#if CHASLES_LEVELS >= 2
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2")) {
        return 1;
    }
#endif
    return 0;
}

/* Computes `count` items. `core` holds the steps in bytes along the core axes, operand by operand; NULL where every
 * item is row-major without gaps. An output may lie over inputs of its own item and of earlier ones. The
 * floating-point state stays as it was, but that `invalid` is raised where a result is NaN and no input of it is. */
void chasles_run(
    const chasles_loop *loop, int level, ptrdiff_t count, char *const *at, const ptrdiff_t *steps, const ptrdiff_t *core);

/* What a block in single precision does that computes in double: `groups` groups of floats of the level, by the loop of
 * the same kernel in double. Each result is rounded once more. */
void chasles_run_in_double(
    const chasles_loop *loop, int level, ptrdiff_t groups, char *const *at, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif
