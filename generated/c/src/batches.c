/* Batches, cut into blocks. Made by `chasles emit`; not to be edited by hand. */

#include "batches.h"

#include <fenv.h>
#include <stdint.h>
#include <string.h>

#if CHASLES_VECTORS && defined(__SSE2__)
#include <emmintrin.h>
#endif

/* The floating-point state around a batch. On x86 with SSE it is one register, far quicker than <fenv.h>, which
 * minds the x87 unit too. */
#if CHASLES_VECTORS && defined(__SSE2_MATH__)
typedef unsigned int State;

/* Clears the flags and masks the traps; gives the state as it was. */
static State quiet(void)
{
    const State state = _mm_getcsr();
    _mm_setcsr((state | 0x1f80u) & ~0x3fu);
    return state;
}

static int is_invalid(void)
{
    return (int)(_mm_getcsr() & 1u);
}

static void clear(void)
{
    _mm_setcsr(_mm_getcsr() & ~0x3fu);
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

int chasles_best_level(void)
{
#if CHASLES_LEVELS >= 2
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2")) {
        return 1;
    }
#endif
    return 0;
}

/* How many items a group has. */
static ptrdiff_t lanes_of(const chasles_loop *loop, int level)
{
    return !CHASLES_VECTORS ? 1 : loop->number == (ptrdiff_t)sizeof(double) ? (ptrdiff_t)2 << level : (ptrdiff_t)4 << level;
}

static ptrdiff_t size_of(const chasles_loop *loop, int k)
{
    return loop->number * loop->shapes[k].rows * loop->shapes[k].columns;
}

/* The steps along the rows and columns of an operand, and whether its items are row-major without gaps. */
typedef struct {
    ptrdiff_t down;
    ptrdiff_t across;
    int dense;
} Stride;

/* The strides that `core` says; without gaps where it is NULL. Gives whether there are none. */
static int find_strides(const chasles_loop *loop, const ptrdiff_t *core, Stride *strides)
{
    int dense = 1;
    for (int k = 0; k < loop->operands; k++) {
        const chasles_shape shape = loop->shapes[k];
        const ptrdiff_t row = loop->number * shape.columns;
        const ptrdiff_t down = core != NULL && shape.axes == 2 ? *core++ : row;
        const ptrdiff_t across = core != NULL && shape.axes >= 1 ? *core++ : loop->number;
        strides[k].down = down;
        strides[k].across = across;
        strides[k].dense = (shape.columns == 1 || across == loop->number) && (shape.rows == 1 || down == row);
        dense &= strides[k].dense;
    }
    return dense;
}

/* The first byte of operand k and the one after its last. */
static void find_range(
    const chasles_loop *loop, int k, ptrdiff_t count, const char *at, ptrdiff_t step, Stride stride, uintptr_t *range)
{
    const ptrdiff_t ways[3] = {
        (count - 1) * step, (loop->shapes[k].rows - 1) * stride.down, (loop->shapes[k].columns - 1) * stride.across};
    ptrdiff_t low = 0, high = loop->number;
    for (int i = 0; i < 3; i++) {
        low += ways[i] < 0 ? ways[i] : 0;
        high += ways[i] > 0 ? ways[i] : 0;
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

/* Copies the numbers of an item from where its strides say to `to`, or the other way where `back` is set. */
static void copy(ptrdiff_t number, chasles_shape shape, Stride stride, char *to, char *from, int back)
{
    const size_t width = (size_t)(stride.dense ? number * shape.rows * shape.columns : number);
    const int rows = stride.dense ? 1 : shape.rows, columns = stride.dense ? 1 : shape.columns;
    for (int i = 0; i < rows; i++) {
        for (int j = 0; j < columns; j++) {
            char *apart = from + i * stride.down + j * stride.across;
            char *together = to + (i * columns + j) * number;
            memcpy(back ? apart : together, back ? together : apart, width);
        }
    }
}

/* A part of a batch: the places of its items, in the batch itself or gathered in `store`. */
typedef struct {
    char *at[CHASLES_OPERANDS];
    ptrdiff_t steps[CHASLES_OPERANDS];
} Part;

/* Copies `items` items of each input to `store`, and the last one again up to `filled`; gives outputs room there. */
static void gather(
    const chasles_loop *loop, Part *part, const Part *batch, const Stride *strides, ptrdiff_t items, ptrdiff_t filled,
    char *store)
{
    for (int k = 0; k < loop->operands; k++) {
        const ptrdiff_t size = size_of(loop, k);
        part->at[k] = store;
        part->steps[k] = size;
        for (ptrdiff_t i = 0; k < loop->inputs && i < filled; i++) {
            char *from = batch->at[k] + (i < items ? i : items - 1) * batch->steps[k];
            copy(loop->number, loop->shapes[k], strides[k], store + i * size, from, 0);
        }
        store += filled * size;
    }
}

/* Copies `items` items of each output to their places. */
static void scatter(const chasles_loop *loop, const Part *part, const Part *batch, const Stride *strides, ptrdiff_t items)
{
    for (int k = loop->inputs; k < loop->operands; k++) {
        for (ptrdiff_t i = 0; i < items; i++) {
            char *to = batch->at[k] + i * batch->steps[k];
            copy(loop->number, loop->shapes[k], strides[k], part->at[k] + i * part->steps[k], to, 1);
        }
    }
}

/* Whether one of `size` bytes of numbers is NaN. */
static int holds_nan(ptrdiff_t number, const char *at, ptrdiff_t size)
{
    for (ptrdiff_t i = 0; i < size; i += number) {
        double x;
        if (number == (ptrdiff_t)sizeof(double)) {
            memcpy(&x, at + i, sizeof(double));
        } else {
            float narrow;
            memcpy(&narrow, at + i, sizeof(float));
            x = (double)narrow;
        }
        if (x != x) {
            return 1;
        }
    }
    return 0;
}

/* Whether an item has a NaN among its results and none among its inputs. */
static int is_singular(const chasles_loop *loop, const Part *part, ptrdiff_t items)
{
    for (ptrdiff_t i = 0; i < items; i++) {
        int came = 0, went = 0;
        for (int k = 0; k < loop->operands; k++) {
            const int found = holds_nan(loop->number, part->at[k] + i * part->steps[k], size_of(loop, k));
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

/* How a part of a batch is computed: where it lies; copied to the store and back; results in the store, from where they
 * go around the cache. */
typedef enum { IN_PLACE, GATHERED, STREAMED } Way;

#if CHASLES_VECTORS && defined(__SSE2__)
/* Results of fewer bytes may still be in the cache when they are read; for results of fewer numbers an item, which are
 * little beside the inputs, copying costs more than is gained. Both measured. */
#define CHASLES_STREAMED 16777216
#define CHASLES_WIDE 6

/* Whether the results lie one after the other and are so many that the cache could not keep them: then a line of memory
 * is better not read before it is written. */
static int is_streamed(const chasles_loop *loop, ptrdiff_t count, const ptrdiff_t *steps)
{
    ptrdiff_t item = 0;
    for (int k = loop->inputs; k < loop->operands; k++) {
        if (steps[k] != size_of(loop, k)) {
            return 0;
        }
        item += steps[k];
    }
    return item >= CHASLES_WIDE * loop->number && count >= CHASLES_STREAMED / item;
}

/* Waits until what went around the cache is where others see it. */
static void settle(void)
{
    _mm_sfence();
}

/* Gives the results of a part room in `store`, all else where it lies. */
static void place_results(const chasles_loop *loop, Part *part, const Part *batch, ptrdiff_t items, char *store)
{
    *part = *batch;
    for (int k = loop->inputs; k < loop->operands; k++) {
        part->at[k] = store;
        store += items * part->steps[k];
    }
}

/* Copies the results of a part to their places, around the cache. */
static void stream(const chasles_loop *loop, const Part *part, const Part *batch, ptrdiff_t items)
{
    for (int k = loop->inputs; k < loop->operands; k++) {
        const char *from = part->at[k], *end = from + items * part->steps[k];
        char *to = batch->at[k];
        for (; from < end && ((uintptr_t)to & 15) != 0; from += sizeof(int), to += sizeof(int)) {
            int four;
            memcpy(&four, from, sizeof four);
            _mm_stream_si32((int *)(void *)to, four);
        }
        for (; end - from >= 16; from += 16, to += 16) {
            _mm_stream_si128((__m128i *)(void *)to, _mm_loadu_si128((const __m128i *)(const void *)from));
        }
        memcpy(to, from, (size_t)(end - from));
    }
}
#else
static int is_streamed(const chasles_loop *loop, ptrdiff_t count, const ptrdiff_t *steps)
{
    (void)loop, (void)count, (void)steps;
    return 0;
}

static void settle(void)
{
}

static void place_results(const chasles_loop *loop, Part *part, const Part *batch, ptrdiff_t items, char *store)
{
    (void)loop, (void)part, (void)batch, (void)items, (void)store;
}

static void stream(const chasles_loop *loop, const Part *part, const Part *batch, ptrdiff_t items)
{
    (void)loop, (void)part, (void)batch, (void)items;
}
#endif

/* A batch under way. */
typedef struct {
    const chasles_loop *loop;
    chasles_block *block;
    const Stride *strides;
    ptrdiff_t lanes;
    Part rest;
    int singular;
} Run;

/* Computes the first `items` of the rest. */
static void advance(Run *run, Way way, ptrdiff_t items, char *store)
{
    const chasles_loop *loop = run->loop;
    const ptrdiff_t groups = (items + run->lanes - 1) / run->lanes;
    Part there;
    const Part *part = &there;
    if (way == IN_PLACE) {
        part = &run->rest;
    } else if (way == GATHERED) {
        gather(loop, &there, &run->rest, run->strides, items, groups * run->lanes, store);
    } else {
        place_results(loop, &there, &run->rest, items, store);
    }
    run->block(groups, part->at, part->steps);
    if (!run->singular && (loop->silent || is_invalid())) {
        run->singular = is_singular(loop, part, items);
        clear();
    }
    if (way == GATHERED) {
        scatter(loop, part, &run->rest, run->strides, items);
    } else if (way == STREAMED) {
        stream(loop, part, &run->rest, items);
    }
    for (int k = 0; k < loop->operands; k++) {
        run->rest.at[k] += items * run->rest.steps[k];
    }
}

static void step_back(Run *run, ptrdiff_t items)
{
    for (int k = 0; k < run->loop->operands; k++) {
        run->rest.at[k] -= items * run->rest.steps[k];
    }
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
    run.loop = loop;
    run.block = loop->blocks[level];
    run.strides = strides;
    run.lanes = lanes_of(loop, level);
    run.singular = 0;
    memcpy(run.rest.at, at, (size_t)loop->operands * sizeof *at);
    memcpy(run.rest.steps, steps, (size_t)loop->operands * sizeof *steps);
    const int lies_well = find_strides(loop, core, strides) && !overlaps(loop, count, at, steps, strides);
    if (lies_well && count == 1) {
        /* An item alone is computed in all lanes. */
        memset(run.rest.steps, 0, sizeof run.rest.steps);
        count = run.lanes;
    }
    Way whole = GATHERED;
    if (lies_well && count >= run.lanes) {
        whole = is_streamed(loop, count, run.rest.steps) ? STREAMED : IN_PLACE;
    }
    const ptrdiff_t room = room_of(loop, run.lanes);
    const State state = quiet();
    for (ptrdiff_t left = count, items = 0; left > 0; left -= items) {
        Way way = whole;
        if (left < run.lanes && whole != GATHERED) {
            /* The last group begins among items that are computed already, to the same results. */
            step_back(&run, run.lanes - left);
            left = run.lanes;
            way = IN_PLACE;
        }
        const ptrdiff_t most = way == IN_PLACE ? CHASLES_BLOCK : room;
        items = left > most ? most : way == GATHERED ? left : left - left % run.lanes;
        advance(&run, way, items, (char *)store);
    }
    if (whole == STREAMED) {
        settle();
    }
    restore(&state);
    if (run.singular) {
        feraiseexcept(FE_INVALID);
    }
}
