/* Batches of three kernels against their scalar functions: every length to 70, every kind of step, storage of exactly
 * the size that is needed, outputs over inputs, and, without an argument, the floating-point state, of which Valgrind
 * knows nothing. Prints what is wrong. */

#define _GNU_SOURCE
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "chasles.h"

#define MOST 70

static int wrong = 0;

static void check(int right, const char *what, int count, ptrdiff_t step)
{
    if (!right) {
        printf("%s is wrong: %d items, steps of %td\n", what, count, step);
        wrong = 1;
    }
}

static double number(int i)
{
    return (double)((i * 7919) % 1013) / 500.0 - 1.0;
}

/* Storage for `count` items of `size` numbers at a step, no byte more; `first` is where item 0 lies. */
static double *storage(int count, int size, ptrdiff_t step, double **first)
{
    const ptrdiff_t apart = step < 0 ? -step : step;
    const size_t all = count == 0 ? 0 : (size_t)((count - 1) * apart + size);
    double *numbers = malloc(all * sizeof(double) + (all == 0));
    for (size_t i = 0; i < all; i++) {
        numbers[i] = number((int)i + size);
    }
    *first = count > 0 && step < 0 ? numbers + (count - 1) * apart : numbers;
    return numbers;
}

static int near(const double *a, const double *b, int size)
{
    for (int i = 0; i < size; i++) {
        if (!(fabs(a[i] - b[i]) <= 4e-15)) {
            return 0;
        }
    }
    return 1;
}

static void lines(int count, ptrdiff_t step)
{
    double *p, *q, *kappa, expected[6];
    double *p_all = storage(count, 3, step, &p), *q_all = storage(count, 3, step * 2, &q);
    double *kappa_all = storage(count, 6, step == 0 ? 6 : step * 3, &kappa);
    chasles_plucker_line_batch((size_t)count, p, step, q, step * 2, kappa, step == 0 ? 6 : step * 3);
    for (int i = 0; i < count; i++) {
        chasles_plucker_line(p + i * step, q + i * step * 2, expected);
        const double *found = kappa + i * (step == 0 ? 6 : step * 3);
        check(memcmp(found, expected, sizeof expected) == 0 || found[0] != found[0], "plucker_line", count, step);
    }
    free(p_all);
    free(q_all);
    free(kappa_all);
}

static void rotations(int count, ptrdiff_t step)
{
    double *e, *phi, *Q, expected[9];
    double *e_all = storage(count, 3, step, &e), *phi_all = storage(count, 1, step, &phi);
    double *Q_all = storage(count, 9, 9, &Q);
    chasles_rotation_from_axis_angle_batch((size_t)count, e, step, phi, step, Q, 9);
    for (int i = 0; i < count; i++) {
        chasles_rotation_from_axis_angle(e + i * step, phi[i * step], expected);
        check(near(Q + 9 * i, expected, 9), "rotation_from_axis_angle", count, step);
    }
    free(e_all);
    free(phi_all);
    free(Q_all);
}

/* Outputs over inputs of the same item. */
static void swapped(int count)
{
    double *a, *b, *x, *y;
    double *all[4] = {storage(count, 3, 3, &a), storage(count, 3, 3, &b), storage(count, 1, 1, &x), storage(count, 1, 1, &y)};
    chasles_swapped_batch((size_t)count, a, 3, b, 3, x, 1, y, 1, a, 3, b, 3, x, 1, y, 1);
    for (int i = 0; i < 3 * count; i++) {
        check(a[i] == number(i + 3) && b[i] == number(i + 3), "swapped", count, 3);
    }
    for (int k = 0; k < 4; k++) {
        free(all[k]);
    }
}

/* Outputs over inputs of earlier items: the axes lie at the end of where the rotations go. */
static void behind(int count)
{
    double *Q, *phi, expected[9 * MOST];
    double *Q_all = storage(count, 9, 9, &Q), *phi_all = storage(count, 1, 1, &phi);
    const double *e = Q + 6 * count;
    for (int i = 0; i < count; i++) {
        chasles_rotation_from_axis_angle(e + 3 * i, phi[i], expected + 9 * i);
    }
    chasles_rotation_from_axis_angle_batch((size_t)count, e, 3, phi, 1, Q, 9);
    check(near(Q, expected, 9 * count), "rotation over earlier items", count, 3);
    free(Q_all);
    free(phi_all);
}

static void state(void)
{
    const double p[6] = {1, 2, 3, 1, 2, 3}, q[6] = {1, 2, 3, 4, 5, 6}, nan_q[6] = {4, 5, 6, NAN, 5, 6};
    double kappa[12];
    feclearexcept(FE_ALL_EXCEPT);
    feraiseexcept(FE_DIVBYZERO);
    chasles_plucker_line_batch(2, p, 3, nan_q, 3, kappa, 6);
    check(fetestexcept(FE_ALL_EXCEPT) == FE_DIVBYZERO, "the state after NaN", 2, 3);
    chasles_plucker_line_batch(1, p, 3, q, 3, kappa, 6);
    check(fetestexcept(FE_ALL_EXCEPT) == (FE_DIVBYZERO | FE_INVALID), "the state after a singular item", 1, 3);
    /* The same where a result that is a number takes the place of the NaN that came in, and another item's NaN has made
     * a comparison invalid. */
    double x[24], length[8];
    for (int i = 0; i < 24; i++) {
        x[i] = 1.0;
    }
    x[3] = x[7] = NAN;
    feclearexcept(FE_ALL_EXCEPT);
    chasles_signed_length_batch(8, x, 3, length, 1, x + 1, 3);
    check(length[2] != length[2] && x[7] == x[7], "a number in the place of NaN", 8, 3);
    check(fetestexcept(FE_ALL_EXCEPT) == 0, "the state after NaN in place", 8, 3);
    fesetround(FE_UPWARD);
    chasles_plucker_line_batch(1, p, 3, q, 3, kappa, 6);
    check(fegetround() == FE_UPWARD, "the rounding mode", 1, 3);
    fesetround(FE_TONEAREST);
#ifdef __GLIBC__
    /* A trap that the caller has set does not spring at what goes on inside a batch. */
    const double far[3] = {1e300, 2e300, 3e300};
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_OVERFLOW | FE_UNDERFLOW);
    chasles_plucker_line_batch(1, p, 3, far, 3, kappa, 6);
    check(fegetexcept() == (FE_OVERFLOW | FE_UNDERFLOW), "what traps there are", 1, 3);
    fedisableexcept(FE_ALL_EXCEPT);
#endif
}

int main(int argc, char **argv)
{
    (void)argv;
    const ptrdiff_t steps[] = {0, 3, 4, 7, -3, -5};
    for (int count = 0; count <= MOST; count++) {
        for (int k = 0; k < 6; k++) {
            lines(count, steps[k]);
            rotations(count, steps[k]);
        }
        swapped(count);
        behind(count);
    }
    if (argc == 1) {
        state();
    }
    printf("%s\n", wrong ? "wrong" : "right");
    return wrong;
}
