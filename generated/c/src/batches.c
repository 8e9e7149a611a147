/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* Batches, cut into blocks. Made by `chasles emit`; not to be edited by hand. */

#include "batches.h"

#include <fenv.h>
#include <stdint.h>
#include <string.h>

#if CHASLES_VECTORS && defined(__SSE2__)
#include <immintrin.h>
#endif

/* The floating-point state around a batch. On x86 with SSE it is one register, far quicker than <fenv.h>, which
 * minds the x87 unit too. */
#if CHASLES_VECTORS && defined(__SSE2_MATH__)
typedef unsigned int State;

/* The bit of `inexact`, and all that are to be looked at. */
#define CHASLES_INEXACT 0x20u
#define CHASLES_FLAGS 0x1fu

/* Clears the flags and masks the traps; gives the state as it was. `inexact`, which comes up at once, is set beforehand:
 * an operation that raises a flag anew stops the machine for as long as an item alone takes. */
static State quiet(void)
{
    const State state = _mm_getcsr();
    _mm_setcsr((state | 0x1f80u | CHASLES_INEXACT) & ~CHASLES_FLAGS);
    return state;
}

static int is_invalid(void)
{
    return (int)(_mm_getcsr() & 1u);
}

static void clear(void)
{
    _mm_setcsr(_mm_getcsr() & ~CHASLES_FLAGS);
}

static void restore(const State *state)
{
    _mm_setcsr(*state);
}
#else
typedef fenv_t State;

/* Clears the flags and masks the traps; gives the state as it was. */
static State quiet(void)
{
    State state;
    feholdexcept(&state);
    return state;
}

static int is_invalid(void)
{
    return fetestexcept(FE_INVALID) != 0;
}

static void clear(void)
{
    feclearexcept(FE_ALL_EXCEPT);
}

static void restore(const State *state)
{
    fesetenv(state);
}
#endif

/* How many items a group has: 1 << shift. */
static int shift_of(const chasles_loop *loop, int level)
{
    return !CHASLES_VECTORS ? 0 : level + (loop->number == (ptrdiff_t)sizeof(double) ? 1 : 2);
}

static ptrdiff_t size_of(const chasles_loop *loop, int k)
{
    return loop->number * loop->shapes[k].rows * loop->shapes[k].columns;
}

/* The size of an operand's items, the steps along their rows and columns, whether they are row-major without gaps, and
 * whether moreover they lie one after the other. */
typedef struct {
    ptrdiff_t size;
    ptrdiff_t down;
    ptrdiff_t across;
    int dense;
    int packed;
} Stride;

/* The strides that `core` says, without gaps where it is NULL; gives whether the items of each operand are packed. */
static int find_strides(const chasles_loop *loop, const ptrdiff_t *steps, const ptrdiff_t *core, Stride *strides)
{
    int packed = 1;
    for (int k = 0; k < loop->operands; k++) {
        const chasles_shape shape = loop->shapes[k];
        const ptrdiff_t row = loop->number * shape.columns, size = row * shape.rows;
        const ptrdiff_t down = core != NULL && shape.axes == 2 ? *core++ : row;
        const ptrdiff_t across = core != NULL && shape.axes >= 1 ? *core++ : loop->number;
        const int dense = (shape.columns == 1 || across == loop->number) && (shape.rows == 1 || down == row);
        strides[k].size = size;
        strides[k].down = dense ? row : down;
        strides[k].across = dense ? loop->number : across;
        strides[k].dense = dense;
        strides[k].packed = dense && steps[k] == size;
        packed &= strides[k].packed;
    }
    return packed;
}

/* Whether blocks take the items of an operand as they lie: without gaps in them or, unless their level is for these
 * alone, wherever their numbers are, if there are as many items as a register holds. */
static int is_taken(const chasles_loop *loop, Stride stride, int level, ptrdiff_t count)
{
    if (level == 2 && !loop->gaps) {
        return stride.packed;
    }
    /* Blocks that round from double may be behind a loop of floats, and know items alone. */
    const int knows_rows = CHASLES_VECTORS && (loop->gaps < 2 || loop->number == (ptrdiff_t)sizeof(double));
    return stride.dense || (knows_rows && count >> shift_of(loop, level) > 0);
}

/* The first byte of operand k and the one after its last. */
static void find_range(
    const chasles_loop *loop, int k, ptrdiff_t count, const char *at, ptrdiff_t step, Stride stride, uintptr_t *range)
{
    const ptrdiff_t last = (count - 1) * step;
    ptrdiff_t low = last < 0 ? last : 0, high = (last > 0 ? last : 0) + (stride.dense ? stride.size : loop->number);
    if (!stride.dense) {
        const ptrdiff_t down = (loop->shapes[k].rows - 1) * stride.down;
        const ptrdiff_t across = (loop->shapes[k].columns - 1) * stride.across;
        low += (down < 0 ? down : 0) + (across < 0 ? across : 0);
        high += (down > 0 ? down : 0) + (across > 0 ? across : 0);
    }
    range[0] = (uintptr_t)at + (uintptr_t)low;
    range[1] = (uintptr_t)at + (uintptr_t)high;
}

/* Whether an output lies over an input. */
static int overlaps(
    const chasles_loop *loop, ptrdiff_t count, char *const *at, const ptrdiff_t *steps, const Stride *strides)
{
    uintptr_t ranges[CHASLES_OPERANDS][2];
    int over = 0;
    for (int k = 0; k < loop->operands; k++) {
        find_range(loop, k, count, at[k], steps[k], strides[k], ranges[k]);
        for (int i = 0; k >= loop->inputs && i < loop->inputs; i++) {
            over |= ranges[k][0] < ranges[i][1] && ranges[i][0] < ranges[k][1];
        }
    }
    return over;
}

/* Copies `width` bytes of each of some items that lie so far apart, as many at a time as one move takes. */
static void copy_some(ptrdiff_t width, char *to, ptrdiff_t to_step, const char *from, ptrdiff_t from_step, ptrdiff_t items)
{
    ptrdiff_t done = 0;
#define COPY(bytes) \
    for (; width - done >= (bytes); done += (bytes)) { \
        for (ptrdiff_t i = 0; i < items; i++) { \
            memcpy(to + i * to_step + done, from + i * from_step + done, (bytes)); \
        } \
    }
    COPY(96)
    COPY(48)
    COPY(32)
    COPY(24)
    COPY(16)
    COPY(8)
    COPY(4)
#undef COPY
}

/* Copies `items` items from where their strides say to `together`, where they lie one after the other, or back. */
static void copy(
    ptrdiff_t number, chasles_shape shape, Stride stride, char *apart, ptrdiff_t step, char *together, ptrdiff_t items,
    int back)
{
    const ptrdiff_t entries = (ptrdiff_t)shape.rows * shape.columns, size = number * entries;
    const ptrdiff_t row = stride.across == number ? shape.columns : 1, wide = stride.dense ? entries : row;
    for (ptrdiff_t e = 0; e < entries; e += wide) {
        char *const there = apart + e / shape.columns * stride.down + e % shape.columns * stride.across;
        if (back) {
            copy_some(wide * number, there, step, together + e * number, size, items);
        } else {
            copy_some(wide * number, together + e * number, size, there, step, items);
        }
    }
}

/* A part of a batch: the places of its items, in the batch itself or gathered in `store`. Behind the steps between
 * items are those down and across in each of them. */
typedef struct {
    char *at[CHASLES_OPERANDS];
    ptrdiff_t steps[3 * CHASLES_OPERANDS];
} Part;

/* The steps of operand k: between items, and down and across in each. */
static void say_steps(const chasles_loop *loop, Part *part, int k, ptrdiff_t step, ptrdiff_t down, ptrdiff_t across)
{
    part->steps[k] = step;
    part->steps[loop->operands + 2 * k] = down;
    part->steps[loop->operands + 2 * k + 1] = across;
}

/* Gives the operands that are not in place room in `store`, and copies `items` items of the inputs there, the last one
 * again up to `filled`. */
static void gather(
    const chasles_loop *loop, Part *part, const Part *batch, const Stride *strides, const int *in_place, ptrdiff_t items,
    ptrdiff_t filled, char *store)
{
    *part = *batch;
    for (int k = 0; k < loop->operands; k++) {
        const ptrdiff_t size = size_of(loop, k);
        if (in_place != NULL && in_place[k]) {
            continue;
        }
        part->at[k] = store;
        say_steps(loop, part, k, size, loop->number * loop->shapes[k].columns, loop->number);
        if (k < loop->inputs) {
            copy(loop->number, loop->shapes[k], strides[k], batch->at[k], batch->steps[k], store, items, 0);
            for (ptrdiff_t i = items; i < filled; i++) {
                memcpy(store + i * size, store + (items - 1) * size, (size_t)size);
            }
        }
        store += filled * size;
    }
}

/* Copies `items` items of each output that is not in place to their places. */
static void scatter(
    const chasles_loop *loop, const Part *part, const Part *batch, const Stride *strides, const int *in_place,
    ptrdiff_t items)
{
    for (int k = loop->inputs; k < loop->operands; k++) {
        if (in_place == NULL || !in_place[k]) {
            copy(loop->number, loop->shapes[k], strides[k], batch->at[k], batch->steps[k], part->at[k], items, 1);
        }
    }
}

/* Whether one of so many numbers is NaN: the bits of its magnitude are beyond those of infinity. */
static int has_nan(const chasles_loop *loop, const char *at, ptrdiff_t count)
{
    const uint64_t infinity = 0x7ff0000000000000u;
    const uint32_t infinityf = 0x7f800000u;
    uint64_t beyond = 0, bits;
    uint32_t beyondf = 0, bitsf;
    if (loop->number == (ptrdiff_t)sizeof bits) {
        for (ptrdiff_t n = 0; n < count; n++) {
            memcpy(&bits, at + n * (ptrdiff_t)sizeof bits, sizeof bits);
            beyond |= infinity - (bits & INT64_MAX);
        }
    } else {
        for (ptrdiff_t n = 0; n < count; n++) {
            memcpy(&bitsf, at + n * (ptrdiff_t)sizeof bitsf, sizeof bitsf);
            beyondf |= infinityf - (bitsf & INT32_MAX);
        }
    }
    return (beyond >> 63 | beyondf >> 31) != 0;
}

/* Whether one of the numbers of operand k in some items is NaN. */
static int holds_nan(const chasles_loop *loop, const Part *part, int k, ptrdiff_t item, ptrdiff_t items)
{
    const ptrdiff_t *const core = part->steps + loop->operands + 2 * k, step = part->steps[k];
    const ptrdiff_t columns = loop->shapes[k].columns, entries = columns * loop->shapes[k].rows;
    const char *const at = part->at[k] + item * step;
    if (step == size_of(loop, k) && core[0] == columns * loop->number && core[1] == loop->number) {
        return has_nan(loop, at, items * entries);
    }
    for (ptrdiff_t e = 0; e < items * entries; e++) {
        const ptrdiff_t down = e / columns % loop->shapes[k].rows, across = e % columns;
        if (has_nan(loop, at + e / entries * step + down * core[0] + across * core[1], 1)) {
            return 1;
        }
    }
    return 0;
}

/* Whether an item has a NaN among its results and none among its inputs. Mostly no result of all items is NaN. */
static int is_singular(const chasles_loop *loop, const Part *part, ptrdiff_t items)
{
    int any = 0;
    for (int k = loop->inputs; k < loop->operands; k++) {
        any |= holds_nan(loop, part, k, 0, items);
    }
    for (ptrdiff_t i = 0; i < items && any; i++) {
        int came = 0, went = 0;
        for (int k = 0; k < loop->operands; k++) {
            const int found = holds_nan(loop, part, k, i, 1);
            came |= k < loop->inputs && found;
            went |= k >= loop->inputs && found;
        }
        if (went && !came) {
            return 1;
        }
    }
    return 0;
}

/* How many items the store holds, in whole groups. */
static ptrdiff_t room_of(const chasles_loop *loop, ptrdiff_t lanes)
{
    ptrdiff_t all = 0;
    for (int k = 0; k < loop->operands; k++) {
        all += size_of(loop, k);
    }
    if (all * CHASLES_BLOCK <= CHASLES_STORE) {
        return CHASLES_BLOCK;
    }
    const ptrdiff_t room = CHASLES_STORE / all;
    return room - room % lanes;
}

#if CHASLES_VECTORS && defined(__SSE2__)
/* Results of fewer bytes may still be in the cache when they are read; those of one or two numbers an item are little
 * beside the inputs. */
#define CHASLES_STREAMED 16777216
#define CHASLES_WIDE 3
/* Whether memory is asked for before it is needed, and such results are copied around the cache: on AMD's Zen 3 and 5
 * loops took up to half as long again so. */
#ifndef CHASLES_STREAMS
#define CHASLES_STREAMS __builtin_cpu_is("intel")
#endif

/* The output whose items lie one after the other and are so many that the cache could not keep them: then a line of
 * memory is better not read before it is written. Where more is read than written that saves little. -1 where there is
 * none. */
static int streamed_output(
    const chasles_loop *loop, ptrdiff_t count, const ptrdiff_t *steps, const Stride *strides)
{
    int widest = loop->inputs;
    for (int k = widest; k < loop->operands; k++) {
        widest = strides[k].size > strides[widest].size ? k : widest;
    }
    const ptrdiff_t size = strides[widest].size;
    if (size < CHASLES_WIDE * loop->number || count * size < CHASLES_STREAMED) {
        return -1;
    }
    ptrdiff_t read = 0;
    for (int k = 0; k < loop->inputs; k++) {
        read += steps[k] == 0 ? 0 : strides[k].size;
    }
    const int fits = size * CHASLES_LANES <= CHASLES_STORE / 2 - 2 * CHASLES_LINE && loop->gaps < 2;
    const int saves = size > read && CHASLES_STREAMS;
    return fits && saves && strides[widest].packed ? widest : -1;
}

/* Waits until what went around the cache is where others see it. */
static void settle(void)
{
    _mm_sfence();
}
#else
#define CHASLES_STREAMS 0
static int streamed_output(
    const chasles_loop *loop, ptrdiff_t count, const ptrdiff_t *steps, const Stride *strides)
{
    (void)loop, (void)count, (void)steps, (void)strides;
    return -1;
}

static void settle(void)
{
}
#endif

/* A batch under way. */
typedef struct {
    const chasles_loop *loop;
    chasles_block *block;
    const Stride *strides;
    int shift;
    ptrdiff_t lanes;
    Part rest;
    chasles_stream nothing;
    const int *in_place;
    int singular;
} Run;

/* Computes the first `items` of the rest at the places of `part`, while what `stream` says is copied. */
static void advance(Run *run, const Part *part, ptrdiff_t items, const chasles_stream *stream)
{
    run->block((items + run->lanes - 1) >> run->shift, part->at, part->steps, stream);
    if (!run->singular && (run->loop->silent || is_invalid())) {
        run->singular = is_singular(run->loop, part, items);
        clear();
    }
}

/* The rest begins so many items later. */
static void go_on(Run *run, ptrdiff_t items)
{
    for (int k = 0; k < run->loop->operands; k++) {
        run->rest.at[k] += items * run->rest.steps[k];
    }
}


/* Computes items where they lie; gives how many of the rest. */
static ptrdiff_t run_in_place(Run *run, ptrdiff_t left)
{
    const ptrdiff_t most = left > run->loop->most ? run->loop->most : left;
    const ptrdiff_t items = most >> run->shift << run->shift;
    advance(run, &run->rest, items, &run->nothing);
    go_on(run, items);
    return items;
}

/* Computes items of which the operands that are not in place are copied to the store, and the results back; gives how
 * many of the rest. */
static ptrdiff_t run_gathered(Run *run, ptrdiff_t left, char *store)
{
    const ptrdiff_t room = room_of(run->loop, run->lanes), most = left > room ? room : left;
    const int *const in_place = most >= run->lanes ? run->in_place : NULL;
    const ptrdiff_t items = in_place != NULL ? most >> run->shift << run->shift : most;
    const ptrdiff_t filled = (items + run->lanes - 1) >> run->shift << run->shift;
    Part part;
    gather(run->loop, &part, &run->rest, run->strides, in_place, items, filled, store);
    advance(run, &part, items, &run->nothing);
    scatter(run->loop, &part, &run->rest, run->strides, in_place, items);
    go_on(run, items);
    return items;
}

/* Computes whole blocks, of output k in one half of the store, while what the other half holds is copied to its place,
 * around the cache, by whole lines of memory; gives how many items of the rest. */
static ptrdiff_t run_streamed(Run *run, int k, ptrdiff_t left, char *store)
{
    const ptrdiff_t size = run->rest.steps[k], half = CHASLES_STORE / 2;
    const ptrdiff_t fitting = (half - 2 * CHASLES_LINE) / size;
    const ptrdiff_t most = fitting > CHASLES_BLOCK ? CHASLES_BLOCK : fitting;
    const ptrdiff_t items = most - most % CHASLES_LANES, bytes = items * size;
    const ptrdiff_t odd = (ptrdiff_t)((uintptr_t)run->rest.at[k] % CHASLES_LINE), groups = items >> run->shift;
    char *const start = store + (CHASLES_LINE - (uintptr_t)store % CHASLES_LINE) % CHASLES_LINE;
    char *const rooms[2] = {start, start + half - CHASLES_LINE};
    chasles_stream stream = run->nothing;
    ptrdiff_t done = 0;
    for (int turn = 0; left - done >= items; turn = !turn) {
        char *const room = rooms[turn], *const to = run->rest.at[k] - odd;
        Part part = run->rest;
        part.at[k] = room + odd;
        memcpy(room, rooms[!turn] + bytes, done > 0 ? (size_t)odd : 0);
        advance(run, &part, items, &stream);
        /* The first line is not ours alone. */
        const ptrdiff_t skipped = done == 0 && odd > 0;
        memcpy(to + odd, room + odd, (size_t)(skipped * (CHASLES_LINE - odd)));
        stream.from = room + skipped * CHASLES_LINE;
        stream.to = to + skipped * CHASLES_LINE;
        stream.lines = bytes / CHASLES_LINE - skipped;
        stream.share = (stream.lines + groups - 1) / groups;
        go_on(run, items);
        done += items;
    }
    memcpy(stream.to, stream.from, (size_t)(stream.lines * CHASLES_LINE + odd));
    return done;
}

void chasles_run(
    const chasles_loop *loop, int level, ptrdiff_t count, char *const *at, const ptrdiff_t *steps, const ptrdiff_t *core)
{
    if (count <= 0) {
        return;
    }
    double store[CHASLES_STORE / sizeof(double)];
    Stride strides[CHASLES_OPERANDS];
    Run run;
    int in_place_each[CHASLES_OPERANDS];
    const chasles_stream nothing = {NULL, NULL, 0, 0, CHASLES_STREAMS};
    const int packed = find_strides(loop, steps, core, strides);
    const int over = overlaps(loop, count, at, steps, strides);
    int lies_well = !over;
    for (int k = 0; k < loop->operands; k++) {
        say_steps(loop, &run.rest, k, steps[k], strides[k].down, strides[k].across);
        lies_well &= packed || is_taken(loop, strides[k], 1, count);
    }
    if (level == 2 && !loop->gaps) {
        /* Such blocks take items without gaps; by narrower registers few items are computed, and what has gaps. */
        level = count >> shift_of(loop, level) == 0 || (lies_well && !packed) ? 1 : 2;
        lies_well = lies_well && (level == 1 || packed);
    }
    for (int k = 0; k < loop->operands && !lies_well; k++) {
        in_place_each[k] = is_taken(loop, strides[k], level, count);
    }
    run.loop = loop;
    run.block = loop->blocks[level];
    run.strides = strides;
    run.shift = shift_of(loop, level);
    run.lanes = (ptrdiff_t)1 << run.shift;
    run.in_place = over || lies_well ? NULL : in_place_each;
    run.nothing = nothing;
    run.singular = 0;
    memcpy(run.rest.at, at, (size_t)loop->operands * sizeof *at);
    if (lies_well && count == 1) {
        /* An item alone is computed in all lanes. */
        memset(run.rest.steps, 0, (size_t)loop->operands * sizeof *steps);
        count = run.lanes;
    }
    const int in_place = lies_well && count >= run.lanes;
    const int streamed = in_place ? streamed_output(loop, count, run.rest.steps, strides) : -1;
    ptrdiff_t left = count;
    const State state = quiet();
    if (streamed >= 0) {
        left -= run_streamed(&run, streamed, left, (char *)store);
    }
    while (left > 0) {
        if (in_place && left < run.lanes) {
            /* The last group begins among items that are computed already, to the same results. */
            go_on(&run, left - run.lanes);
            left = run.lanes;
        }
        left -= in_place ? run_in_place(&run, left) : run_gathered(&run, left, (char *)store);
    }
    if (streamed >= 0) {
        settle();
    }
    restore(&state);
    if (run.singular) {
        feraiseexcept(FE_INVALID);
    }
}

#if CHASLES_VECTORS
typedef float narrow_4 __attribute__((vector_size(16), aligned(4), may_alias));
typedef double wide_4 __attribute__((vector_size(32), aligned(8), may_alias));
#endif

/* Copies the numbers of some floats' items to doubles, one item after the other, or back. */
static void widen(float *narrow, ptrdiff_t step, double *wide, ptrdiff_t numbers, ptrdiff_t items, int back)
{
    const ptrdiff_t apart = step / (ptrdiff_t)sizeof(float), whole = apart == numbers ? numbers * items : numbers;
    for (ptrdiff_t done = 0; done < items * numbers; done += whole, narrow += apart, wide += whole) {
        ptrdiff_t n = 0;
#if CHASLES_VECTORS
        for (; n + 4 <= whole; n += 4) {
            narrow_4 *const four = (narrow_4 *)(void *)(narrow + n);
            wide_4 *const other = (wide_4 *)(void *)(wide + n);
            if (back) {
                *four = __builtin_convertvector(*other, narrow_4);
            } else {
                *other = __builtin_convertvector(*four, wide_4);
            }
        }
#endif
        for (; n < whole; n++) {
            if (back) {
                narrow[n] = (float)wide[n];
            } else {
                wide[n] = (double)narrow[n];
            }
        }
    }
}

void chasles_run_in_double(
    const chasles_loop *loop, int level, ptrdiff_t groups, char *const *at, const ptrdiff_t *steps)
{
    double store[CHASLES_STORE / sizeof(double)];
    const int shift = shift_of(loop, level);
    const ptrdiff_t count = groups << (CHASLES_VECTORS ? shift + 1 : 0), room = room_of(loop, (ptrdiff_t)1 << shift);
    for (ptrdiff_t done = 0, items; done < count; done += items) {
        items = count - done > room ? room : count - done;
        Part part;
        double *next = store;
        for (int k = 0; k < loop->operands; k++) {
            const ptrdiff_t size = size_of(loop, k), numbers = size / (ptrdiff_t)sizeof(double);
            part.at[k] = (char *)next;
            say_steps(loop, &part, k, size, loop->number * loop->shapes[k].columns, loop->number);
            if (k < loop->inputs) {
                widen((float *)(void *)(at[k] + done * steps[k]), steps[k], next, numbers, items, 0);
            }
            next += items * numbers;
        }
        const chasles_stream nothing = {NULL, NULL, 0, 0, 0};
        loop->blocks[level](items >> shift, part.at, part.steps, &nothing);
        for (int k = loop->inputs; k < loop->operands; k++) {
            const ptrdiff_t numbers = part.steps[k] / (ptrdiff_t)sizeof(double);
            double *const found = (double *)(void *)part.at[k];
            widen((float *)(void *)(at[k] + done * steps[k]), steps[k], found, numbers, items, 1);
        }
    }
}
