/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* Compares the kernels with exact vectors. Made by `chasles emit`; not to be edited by hand.
 *
 * Prints every entry that is wrong and a line "N passed, M failed"; the exit status is 0 where all passed and there
 * was something to pass.
 */

#include <float.h>
#include <math.h>
#include <stdio.h>

#include "chasles.h"

static int passed = 0;
static int failed = 0;

/* The distance that `tolerance` allows, which is relative to the largest entry expected, counted as at least one. */
static double margin(int size, const double *expected, double tolerance)
{
    double largest = 1.0;
    for (int i = 0; i < size; i++) {
        if (fabs(expected[i]) > largest) {
            largest = fabs(expected[i]);
        }
    }
    return tolerance * largest;
}

static int is_right(const char *what, int i, double got, double expected, double allowed)
{
    const int right = expected != expected ? got != got : fabs(got - expected) <= allowed;
    if (!right) {
        printf("%s[%d] is %.17g, expected %.17g\n", what, i, got, expected);
    }
    return right;
}

static void count(int right)
{
    passed += right;
    failed += !right;
}

static void compare(const char *what, int size, const double *got, const double *expected, double tolerance)
{
    int right = 1;
    for (int i = 0; i < size; i++) {
        right &= is_right(what, i, got[i], expected[i], margin(size, expected, tolerance));
    }
    count(right);
}

static void comparef(const char *what, int size, const float *got, const double *expected, double tolerance)
{
    int right = 1;
    for (int i = 0; i < size; i++) {
        right &= is_right(what, i, (double)got[i], expected[i], margin(size, expected, tolerance));
    }
    count(right);
}

static void cross_product_matrix_vector_1(void)
{
    const double v[3] = {1.25, 0.5, -0.75};
    const double V_expected[9] = {0.0, 0.75, 0.5, -0.75, 0.0, -1.25, -0.5, 1.25, 0.0};
    double V[9], V_batch[99];
    chasles_cross_product_matrix(v, V);
    chasles_cross_product_matrix_batch(11, v, 0, V_batch, 9);
    compare("chasles_cross_product_matrix, vector 1: V", 9, V, V_expected, 8.0 * DBL_EPSILON);
    compare("chasles_cross_product_matrix, vector 1, first of a batch: V", 9, V_batch, V_expected, 8.0 * DBL_EPSILON);
    compare("chasles_cross_product_matrix, vector 1, last: V", 9, V_batch + 90, V_expected, 8.0 * DBL_EPSILON);
}

static void cross_product_matrix_vector_2(void)
{
    const double v[3] = {2.0, -1.5, 0.25};
    const double V_expected[9] = {0.0, -0.25, -1.5, 0.25, 0.0, -2.0, 1.5, 2.0, 0.0};
    double V[9], V_batch[99];
    chasles_cross_product_matrix(v, V);
    chasles_cross_product_matrix_batch(11, v, 0, V_batch, 9);
    compare("chasles_cross_product_matrix, vector 2: V", 9, V, V_expected, 8.0 * DBL_EPSILON);
    compare("chasles_cross_product_matrix, vector 2, first of a batch: V", 9, V_batch, V_expected, 8.0 * DBL_EPSILON);
    compare("chasles_cross_product_matrix, vector 2, last: V", 9, V_batch + 90, V_expected, 8.0 * DBL_EPSILON);
}

static void cross_product_matrix_vector_1f(void)
{
    const float v[3] = {1.25f, 0.5f, -0.75f};
    const double V_expected[9] = {0.0, 0.75, 0.5, -0.75, 0.0, -1.25, -0.5, 1.25, 0.0};
    float V[9], V_batch[99];
    chasles_cross_product_matrixf(v, V);
    chasles_cross_product_matrix_batchf(11, v, 0, V_batch, 9);
    comparef("chasles_cross_product_matrixf, vector 1: V", 9, V, V_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_cross_product_matrixf, vector 1, first of a batch: V", 9, V_batch, V_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_cross_product_matrixf, vector 1, last: V", 9, V_batch + 90, V_expected, 8.0 * FLT_EPSILON);
}

static void cross_product_matrix_vector_2f(void)
{
    const float v[3] = {2.0f, -1.5f, 0.25f};
    const double V_expected[9] = {0.0, -0.25, -1.5, 0.25, 0.0, -2.0, 1.5, 2.0, 0.0};
    float V[9], V_batch[99];
    chasles_cross_product_matrixf(v, V);
    chasles_cross_product_matrix_batchf(11, v, 0, V_batch, 9);
    comparef("chasles_cross_product_matrixf, vector 2: V", 9, V, V_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_cross_product_matrixf, vector 2, first of a batch: V", 9, V_batch, V_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_cross_product_matrixf, vector 2, last: V", 9, V_batch + 90, V_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_axis_angle_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double Q_expected[9] = {
        0.39139765546246103595,
        -0.48050582676933940189,
        0.78480699903810888391,
        0.78480699903810888391,
        0.61962353466403814747,
        -0.012027034183092589426,
        -0.48050582676933940189,
        0.62062937872063155347,
        0.61962353466403814747,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_axis_angle(e, phi[0], Q);
    chasles_rotation_from_axis_angle_batch(11, e, 0, phi, 0, Q_batch, 9);
    compare("chasles_rotation_from_axis_angle, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_axis_angle, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_axis_angle, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_axis_angle_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double Q_expected[9] = {
        -0.416146836547142387,
        -0.72743794146054535632,
        0.54557845609540901724,
        0.72743794146054535632,
        0.093666024609828872322,
        0.67975048154262834576,
        -0.54557845609540901724,
        0.67975048154262834576,
        0.49018713884302874068,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_axis_angle(e, phi[0], Q);
    chasles_rotation_from_axis_angle_batch(11, e, 0, phi, 0, Q_batch, 9);
    compare("chasles_rotation_from_axis_angle, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_axis_angle, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_axis_angle, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_axis_angle_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const double Q_expected[9] = {
        0.39139765546246103595,
        -0.48050582676933940189,
        0.78480699903810888391,
        0.78480699903810888391,
        0.61962353466403814747,
        -0.012027034183092589426,
        -0.48050582676933940189,
        0.62062937872063155347,
        0.61962353466403814747,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_axis_anglef(e, phi[0], Q);
    chasles_rotation_from_axis_angle_batchf(11, e, 0, phi, 0, Q_batch, 9);
    comparef("chasles_rotation_from_axis_anglef, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_axis_anglef, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_axis_anglef, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_axis_angle_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const double Q_expected[9] = {
        -0.416146836547142387,
        -0.72743794146054535632,
        0.54557845609540901724,
        0.72743794146054535632,
        0.093666024609828872322,
        0.67975048154262834576,
        -0.54557845609540901724,
        0.67975048154262834576,
        0.49018713884302874068,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_axis_anglef(e, phi[0], Q);
    chasles_rotation_from_axis_angle_batchf(11, e, 0, phi, 0, Q_batch, 9);
    comparef("chasles_rotation_from_axis_anglef, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_axis_anglef, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_axis_anglef, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void point_after_displacement_vector_1(void)
{
    const double Q[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double a[3] = {1.25, 0.5, -0.75};
    const double a_prime[3] = {2.0, -1.5, 0.25};
    const double p[3] = {1.75, -0.5, 0.75};
    const double p_prime_expected[3] = {
        3.6666666666666666667,
        -2.3333333333333333333,
        0.41666666666666666667,
    };
    double p_prime[3], p_prime_batch[33];
    chasles_point_after_displacement(Q, a, a_prime, p, p_prime);
    chasles_point_after_displacement_batch(11, Q, 0, a, 0, a_prime, 0, p, 0, p_prime_batch, 3);
    compare("chasles_point_after_displacement, vector 1: p_prime", 3, p_prime, p_prime_expected, 8.0 * DBL_EPSILON);
    compare("chasles_point_after_displacement, vector 1, first of a batch: p_prime", 3, p_prime_batch, p_prime_expected, 8.0 * DBL_EPSILON);
    compare("chasles_point_after_displacement, vector 1, last: p_prime", 3, p_prime_batch + 30, p_prime_expected, 8.0 * DBL_EPSILON);
}

static void point_after_displacement_vector_2(void)
{
    const double Q[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double a[3] = {2.0, -1.5, 0.25};
    const double a_prime[3] = {1.75, -0.5, 0.75};
    const double p[3] = {-1.25, 1.5, 1.25};
    const double p_prime_expected[3] = {-2.6, -1.3, 1.75};
    double p_prime[3], p_prime_batch[33];
    chasles_point_after_displacement(Q, a, a_prime, p, p_prime);
    chasles_point_after_displacement_batch(11, Q, 0, a, 0, a_prime, 0, p, 0, p_prime_batch, 3);
    compare("chasles_point_after_displacement, vector 2: p_prime", 3, p_prime, p_prime_expected, 8.0 * DBL_EPSILON);
    compare("chasles_point_after_displacement, vector 2, first of a batch: p_prime", 3, p_prime_batch, p_prime_expected, 8.0 * DBL_EPSILON);
    compare("chasles_point_after_displacement, vector 2, last: p_prime", 3, p_prime_batch + 30, p_prime_expected, 8.0 * DBL_EPSILON);
}

static void point_after_displacement_vector_1f(void)
{
    const float Q[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const float a[3] = {1.25f, 0.5f, -0.75f};
    const float a_prime[3] = {2.0f, -1.5f, 0.25f};
    const float p[3] = {1.75f, -0.5f, 0.75f};
    const double p_prime_expected[3] = {
        3.6666666666666666667,
        -2.3333333333333333333,
        0.41666666666666666667,
    };
    float p_prime[3], p_prime_batch[33];
    chasles_point_after_displacementf(Q, a, a_prime, p, p_prime);
    chasles_point_after_displacement_batchf(11, Q, 0, a, 0, a_prime, 0, p, 0, p_prime_batch, 3);
    comparef("chasles_point_after_displacementf, vector 1: p_prime", 3, p_prime, p_prime_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_point_after_displacementf, vector 1, first of a batch: p_prime", 3, p_prime_batch, p_prime_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_point_after_displacementf, vector 1, last: p_prime", 3, p_prime_batch + 30, p_prime_expected, 8.0 * FLT_EPSILON);
}

static void point_after_displacement_vector_2f(void)
{
    const float Q[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const float a[3] = {2.0f, -1.5f, 0.25f};
    const float a_prime[3] = {1.75f, -0.5f, 0.75f};
    const float p[3] = {-1.25f, 1.5f, 1.25f};
    const double p_prime_expected[3] = {-2.6, -1.3, 1.75};
    float p_prime[3], p_prime_batch[33];
    chasles_point_after_displacementf(Q, a, a_prime, p, p_prime);
    chasles_point_after_displacement_batchf(11, Q, 0, a, 0, a_prime, 0, p, 0, p_prime_batch, 3);
    comparef("chasles_point_after_displacementf, vector 2: p_prime", 3, p_prime, p_prime_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_point_after_displacementf, vector 2, first of a batch: p_prime", 3, p_prime_batch, p_prime_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_point_after_displacementf, vector 2, last: p_prime", 3, p_prime_batch + 30, p_prime_expected, 8.0 * FLT_EPSILON);
}

static void pitch_of_motion_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double d_P[3] = {0.5, -0.75, 2.0};
    const double result_expected[1] = {0.8};
    double result[1], result_batch[11];
    chasles_pitch_of_motion(e, phi[0], d_P, result);
    chasles_pitch_of_motion_batch(11, e, 0, phi, 0, d_P, 0, result_batch, 1);
    compare("chasles_pitch_of_motion, vector 1: result", 1, result, result_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pitch_of_motion, vector 1, first of a batch: result", 1, result_batch, result_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pitch_of_motion, vector 1, last: result", 1, result_batch + 10, result_expected, 8.0 * DBL_EPSILON);
}

static void pitch_of_motion_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double d_P[3] = {-1.5, 0.25, 1.75};
    const double result_expected[1] = {0.775};
    double result[1], result_batch[11];
    chasles_pitch_of_motion(e, phi[0], d_P, result);
    chasles_pitch_of_motion_batch(11, e, 0, phi, 0, d_P, 0, result_batch, 1);
    compare("chasles_pitch_of_motion, vector 2: result", 1, result, result_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pitch_of_motion, vector 2, first of a batch: result", 1, result_batch, result_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pitch_of_motion, vector 2, last: result", 1, result_batch + 10, result_expected, 8.0 * DBL_EPSILON);
}

static void pitch_of_motion_vector_3(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {0.0};
    const double d_P[3] = {0.0, 0.0, 0.0};
    const double result_expected[1] = {NAN};
    double result[1], result_batch[11];
    chasles_pitch_of_motion(e, phi[0], d_P, result);
    chasles_pitch_of_motion_batch(11, e, 0, phi, 0, d_P, 0, result_batch, 1);
    compare("chasles_pitch_of_motion, vector 3: result", 1, result, result_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pitch_of_motion, vector 3, first of a batch: result", 1, result_batch, result_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pitch_of_motion, vector 3, last: result", 1, result_batch + 10, result_expected, 8.0 * DBL_EPSILON);
}

static void pitch_of_motion_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float d_P[3] = {0.5f, -0.75f, 2.0f};
    const double result_expected[1] = {0.8};
    float result[1], result_batch[11];
    chasles_pitch_of_motionf(e, phi[0], d_P, result);
    chasles_pitch_of_motion_batchf(11, e, 0, phi, 0, d_P, 0, result_batch, 1);
    comparef("chasles_pitch_of_motionf, vector 1: result", 1, result, result_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pitch_of_motionf, vector 1, first of a batch: result", 1, result_batch, result_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pitch_of_motionf, vector 1, last: result", 1, result_batch + 10, result_expected, 8.0 * FLT_EPSILON);
}

static void pitch_of_motion_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float d_P[3] = {-1.5f, 0.25f, 1.75f};
    const double result_expected[1] = {0.775};
    float result[1], result_batch[11];
    chasles_pitch_of_motionf(e, phi[0], d_P, result);
    chasles_pitch_of_motion_batchf(11, e, 0, phi, 0, d_P, 0, result_batch, 1);
    comparef("chasles_pitch_of_motionf, vector 2: result", 1, result, result_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pitch_of_motionf, vector 2, first of a batch: result", 1, result_batch, result_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pitch_of_motionf, vector 2, last: result", 1, result_batch + 10, result_expected, 8.0 * FLT_EPSILON);
}

static void pitch_of_motion_vector_3f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {0.0f};
    const float d_P[3] = {0.0f, 0.0f, 0.0f};
    const double result_expected[1] = {NAN};
    float result[1], result_batch[11];
    chasles_pitch_of_motionf(e, phi[0], d_P, result);
    chasles_pitch_of_motion_batchf(11, e, 0, phi, 0, d_P, 0, result_batch, 1);
    comparef("chasles_pitch_of_motionf, vector 3: result", 1, result, result_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pitch_of_motionf, vector 3, first of a batch: result", 1, result_batch, result_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pitch_of_motionf, vector 3, last: result", 1, result_batch + 10, result_expected, 8.0 * FLT_EPSILON);
}

static void normal_matrix_inverse_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double result_expected[9] = {
        0.76024059925867785102,
        0.059939850185330537245,
        0.059939850185330537245,
        0.059939850185330537245,
        0.85015037453667365689,
        0.11987970037066107449,
        0.059939850185330537245,
        0.11987970037066107449,
        0.85015037453667365689,
    };
    double result[9], result_batch[99];
    chasles_normal_matrix_inverse(e, phi[0], result);
    chasles_normal_matrix_inverse_batch(11, e, 0, phi, 0, result_batch, 9);
    compare("chasles_normal_matrix_inverse, vector 1: result", 9, result, result_expected, 8.0 * DBL_EPSILON);
    compare("chasles_normal_matrix_inverse, vector 1, first of a batch: result", 9, result_batch, result_expected, 8.0 * DBL_EPSILON);
    compare("chasles_normal_matrix_inverse, vector 1, last: result", 9, result_batch + 90, result_expected, 8.0 * DBL_EPSILON);
}

static void normal_matrix_inverse_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double result_expected[9] = {
        0.35307073185934797865,
        0.0,
        0.0,
        0.0,
        0.58596526838998270634,
        0.31052604870751297025,
        0.0,
        0.31052604870751297025,
        0.76710546346936527231,
    };
    double result[9], result_batch[99];
    chasles_normal_matrix_inverse(e, phi[0], result);
    chasles_normal_matrix_inverse_batch(11, e, 0, phi, 0, result_batch, 9);
    compare("chasles_normal_matrix_inverse, vector 2: result", 9, result, result_expected, 8.0 * DBL_EPSILON);
    compare("chasles_normal_matrix_inverse, vector 2, first of a batch: result", 9, result_batch, result_expected, 8.0 * DBL_EPSILON);
    compare("chasles_normal_matrix_inverse, vector 2, last: result", 9, result_batch + 90, result_expected, 8.0 * DBL_EPSILON);
}

static void normal_matrix_inverse_vector_3(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {0.0};
    const double result_expected[9] = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};
    double result[9], result_batch[99];
    chasles_normal_matrix_inverse(e, phi[0], result);
    chasles_normal_matrix_inverse_batch(11, e, 0, phi, 0, result_batch, 9);
    compare("chasles_normal_matrix_inverse, vector 3: result", 9, result, result_expected, 8.0 * DBL_EPSILON);
    compare("chasles_normal_matrix_inverse, vector 3, first of a batch: result", 9, result_batch, result_expected, 8.0 * DBL_EPSILON);
    compare("chasles_normal_matrix_inverse, vector 3, last: result", 9, result_batch + 90, result_expected, 8.0 * DBL_EPSILON);
}

static void normal_matrix_inverse_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const double result_expected[9] = {
        0.76024059925867785102,
        0.059939850185330537245,
        0.059939850185330537245,
        0.059939850185330537245,
        0.85015037453667365689,
        0.11987970037066107449,
        0.059939850185330537245,
        0.11987970037066107449,
        0.85015037453667365689,
    };
    float result[9], result_batch[99];
    chasles_normal_matrix_inversef(e, phi[0], result);
    chasles_normal_matrix_inverse_batchf(11, e, 0, phi, 0, result_batch, 9);
    comparef("chasles_normal_matrix_inversef, vector 1: result", 9, result, result_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_normal_matrix_inversef, vector 1, first of a batch: result", 9, result_batch, result_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_normal_matrix_inversef, vector 1, last: result", 9, result_batch + 90, result_expected, 8.0 * FLT_EPSILON);
}

static void normal_matrix_inverse_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const double result_expected[9] = {
        0.35307073185934797865,
        0.0,
        0.0,
        0.0,
        0.58596526838998270634,
        0.31052604870751297025,
        0.0,
        0.31052604870751297025,
        0.76710546346936527231,
    };
    float result[9], result_batch[99];
    chasles_normal_matrix_inversef(e, phi[0], result);
    chasles_normal_matrix_inverse_batchf(11, e, 0, phi, 0, result_batch, 9);
    comparef("chasles_normal_matrix_inversef, vector 2: result", 9, result, result_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_normal_matrix_inversef, vector 2, first of a batch: result", 9, result_batch, result_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_normal_matrix_inversef, vector 2, last: result", 9, result_batch + 90, result_expected, 8.0 * FLT_EPSILON);
}

static void normal_matrix_inverse_vector_3f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {0.0f};
    const double result_expected[9] = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};
    float result[9], result_batch[99];
    chasles_normal_matrix_inversef(e, phi[0], result);
    chasles_normal_matrix_inverse_batchf(11, e, 0, phi, 0, result_batch, 9);
    comparef("chasles_normal_matrix_inversef, vector 3: result", 9, result, result_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_normal_matrix_inversef, vector 3, first of a batch: result", 9, result_batch, result_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_normal_matrix_inversef, vector 3, last: result", 9, result_batch + 90, result_expected, 8.0 * FLT_EPSILON);
}

static void screw_axis_point_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double a[3] = {0.5, -0.75, 2.0};
    const double a_prime[3] = {-1.5, 0.25, 1.75};
    const double p_0_expected[3] = {
        -1.3830685870138728703,
        -1.7273806582985870833,
        2.4189149518055235184,
    };
    double p_0[3], p_0_batch[33];
    chasles_screw_axis_point(e, phi[0], a, a_prime, p_0);
    chasles_screw_axis_point_batch(11, e, 0, phi, 0, a, 0, a_prime, 0, p_0_batch, 3);
    compare("chasles_screw_axis_point, vector 1: p_0", 3, p_0, p_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_axis_point, vector 1, first of a batch: p_0", 3, p_0_batch, p_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_axis_point, vector 1, last: p_0", 3, p_0_batch + 30, p_0_expected, 8.0 * DBL_EPSILON);
}

static void screw_axis_point_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double a[3] = {-1.5, 0.25, 1.75};
    const double a_prime[3] = {-0.5, 0.75, -1.25};
    const double p_0_expected[3] = {
        -1.7063018775277637733,
        0.4568370463737322812,
        -0.3426277847802992109,
    };
    double p_0[3], p_0_batch[33];
    chasles_screw_axis_point(e, phi[0], a, a_prime, p_0);
    chasles_screw_axis_point_batch(11, e, 0, phi, 0, a, 0, a_prime, 0, p_0_batch, 3);
    compare("chasles_screw_axis_point, vector 2: p_0", 3, p_0, p_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_axis_point, vector 2, first of a batch: p_0", 3, p_0_batch, p_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_axis_point, vector 2, last: p_0", 3, p_0_batch + 30, p_0_expected, 8.0 * DBL_EPSILON);
}

static void screw_axis_point_vector_3(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {0.0};
    const double a[3] = {0.0, 0.0, 0.0};
    const double a_prime[3] = {0.0, 0.0, 0.0};
    const double p_0_expected[3] = {NAN, NAN, NAN};
    double p_0[3], p_0_batch[33];
    chasles_screw_axis_point(e, phi[0], a, a_prime, p_0);
    chasles_screw_axis_point_batch(11, e, 0, phi, 0, a, 0, a_prime, 0, p_0_batch, 3);
    compare("chasles_screw_axis_point, vector 3: p_0", 3, p_0, p_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_axis_point, vector 3, first of a batch: p_0", 3, p_0_batch, p_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_axis_point, vector 3, last: p_0", 3, p_0_batch + 30, p_0_expected, 8.0 * DBL_EPSILON);
}

static void screw_axis_point_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float a[3] = {0.5f, -0.75f, 2.0f};
    const float a_prime[3] = {-1.5f, 0.25f, 1.75f};
    const double p_0_expected[3] = {
        -1.3830685870138728703,
        -1.7273806582985870833,
        2.4189149518055235184,
    };
    float p_0[3], p_0_batch[33];
    chasles_screw_axis_pointf(e, phi[0], a, a_prime, p_0);
    chasles_screw_axis_point_batchf(11, e, 0, phi, 0, a, 0, a_prime, 0, p_0_batch, 3);
    comparef("chasles_screw_axis_pointf, vector 1: p_0", 3, p_0, p_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_axis_pointf, vector 1, first of a batch: p_0", 3, p_0_batch, p_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_axis_pointf, vector 1, last: p_0", 3, p_0_batch + 30, p_0_expected, 8.0 * FLT_EPSILON);
}

static void screw_axis_point_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float a[3] = {-1.5f, 0.25f, 1.75f};
    const float a_prime[3] = {-0.5f, 0.75f, -1.25f};
    const double p_0_expected[3] = {
        -1.7063018775277637733,
        0.4568370463737322812,
        -0.3426277847802992109,
    };
    float p_0[3], p_0_batch[33];
    chasles_screw_axis_pointf(e, phi[0], a, a_prime, p_0);
    chasles_screw_axis_point_batchf(11, e, 0, phi, 0, a, 0, a_prime, 0, p_0_batch, 3);
    comparef("chasles_screw_axis_pointf, vector 2: p_0", 3, p_0, p_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_axis_pointf, vector 2, first of a batch: p_0", 3, p_0_batch, p_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_axis_pointf, vector 2, last: p_0", 3, p_0_batch + 30, p_0_expected, 8.0 * FLT_EPSILON);
}

static void screw_axis_point_vector_3f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {0.0f};
    const float a[3] = {0.0f, 0.0f, 0.0f};
    const float a_prime[3] = {0.0f, 0.0f, 0.0f};
    const double p_0_expected[3] = {NAN, NAN, NAN};
    float p_0[3], p_0_batch[33];
    chasles_screw_axis_pointf(e, phi[0], a, a_prime, p_0);
    chasles_screw_axis_point_batchf(11, e, 0, phi, 0, a, 0, a_prime, 0, p_0_batch, 3);
    comparef("chasles_screw_axis_pointf, vector 3: p_0", 3, p_0, p_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_axis_pointf, vector 3, first of a batch: p_0", 3, p_0_batch, p_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_axis_pointf, vector 3, last: p_0", 3, p_0_batch + 30, p_0_expected, 8.0 * FLT_EPSILON);
}

static void plucker_line_vector_1(void)
{
    const double p_1[3] = {1.25, 0.5, -0.75};
    const double p_2[3] = {2.0, -1.5, 0.25};
    const double kappa_expected[6] = {
        0.31799936400190799364,
        -0.84799830400508798304,
        0.42399915200254399152,
        -0.42399915200254399152,
        -0.76849846300461098463,
        -1.2189975620073139756,
    };
    double kappa[6], kappa_batch[66];
    chasles_plucker_line(p_1, p_2, kappa);
    chasles_plucker_line_batch(11, p_1, 0, p_2, 0, kappa_batch, 6);
    compare("chasles_plucker_line, vector 1: kappa", 6, kappa, kappa_expected, 8.0 * DBL_EPSILON);
    compare("chasles_plucker_line, vector 1, first of a batch: kappa", 6, kappa_batch, kappa_expected, 8.0 * DBL_EPSILON);
    compare("chasles_plucker_line, vector 1, last: kappa", 6, kappa_batch + 60, kappa_expected, 8.0 * DBL_EPSILON);
}

static void plucker_line_vector_2(void)
{
    const double p_1[3] = {2.0, -1.5, 0.25};
    const double p_2[3] = {1.75, -0.5, 0.75};
    const double kappa_expected[6] = {
        -0.21821789023599238127,
        0.87287156094396952506,
        0.43643578047198476253,
        -0.87287156094396952506,
        -0.92742603350296762038,
        1.4184162865339504782,
    };
    double kappa[6], kappa_batch[66];
    chasles_plucker_line(p_1, p_2, kappa);
    chasles_plucker_line_batch(11, p_1, 0, p_2, 0, kappa_batch, 6);
    compare("chasles_plucker_line, vector 2: kappa", 6, kappa, kappa_expected, 8.0 * DBL_EPSILON);
    compare("chasles_plucker_line, vector 2, first of a batch: kappa", 6, kappa_batch, kappa_expected, 8.0 * DBL_EPSILON);
    compare("chasles_plucker_line, vector 2, last: kappa", 6, kappa_batch + 60, kappa_expected, 8.0 * DBL_EPSILON);
}

static void plucker_line_vector_3(void)
{
    const double p_1[3] = {0.0, 0.0, 0.0};
    const double p_2[3] = {0.0, 0.0, 0.0};
    const double kappa_expected[6] = {NAN, NAN, NAN, NAN, NAN, NAN};
    double kappa[6], kappa_batch[66];
    chasles_plucker_line(p_1, p_2, kappa);
    chasles_plucker_line_batch(11, p_1, 0, p_2, 0, kappa_batch, 6);
    compare("chasles_plucker_line, vector 3: kappa", 6, kappa, kappa_expected, 8.0 * DBL_EPSILON);
    compare("chasles_plucker_line, vector 3, first of a batch: kappa", 6, kappa_batch, kappa_expected, 8.0 * DBL_EPSILON);
    compare("chasles_plucker_line, vector 3, last: kappa", 6, kappa_batch + 60, kappa_expected, 8.0 * DBL_EPSILON);
}

static void plucker_line_vector_1f(void)
{
    const float p_1[3] = {1.25f, 0.5f, -0.75f};
    const float p_2[3] = {2.0f, -1.5f, 0.25f};
    const double kappa_expected[6] = {
        0.31799936400190799364,
        -0.84799830400508798304,
        0.42399915200254399152,
        -0.42399915200254399152,
        -0.76849846300461098463,
        -1.2189975620073139756,
    };
    float kappa[6], kappa_batch[66];
    chasles_plucker_linef(p_1, p_2, kappa);
    chasles_plucker_line_batchf(11, p_1, 0, p_2, 0, kappa_batch, 6);
    comparef("chasles_plucker_linef, vector 1: kappa", 6, kappa, kappa_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_plucker_linef, vector 1, first of a batch: kappa", 6, kappa_batch, kappa_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_plucker_linef, vector 1, last: kappa", 6, kappa_batch + 60, kappa_expected, 8.0 * FLT_EPSILON);
}

static void plucker_line_vector_2f(void)
{
    const float p_1[3] = {2.0f, -1.5f, 0.25f};
    const float p_2[3] = {1.75f, -0.5f, 0.75f};
    const double kappa_expected[6] = {
        -0.21821789023599238127,
        0.87287156094396952506,
        0.43643578047198476253,
        -0.87287156094396952506,
        -0.92742603350296762038,
        1.4184162865339504782,
    };
    float kappa[6], kappa_batch[66];
    chasles_plucker_linef(p_1, p_2, kappa);
    chasles_plucker_line_batchf(11, p_1, 0, p_2, 0, kappa_batch, 6);
    comparef("chasles_plucker_linef, vector 2: kappa", 6, kappa, kappa_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_plucker_linef, vector 2, first of a batch: kappa", 6, kappa_batch, kappa_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_plucker_linef, vector 2, last: kappa", 6, kappa_batch + 60, kappa_expected, 8.0 * FLT_EPSILON);
}

static void plucker_line_vector_3f(void)
{
    const float p_1[3] = {0.0f, 0.0f, 0.0f};
    const float p_2[3] = {0.0f, 0.0f, 0.0f};
    const double kappa_expected[6] = {NAN, NAN, NAN, NAN, NAN, NAN};
    float kappa[6], kappa_batch[66];
    chasles_plucker_linef(p_1, p_2, kappa);
    chasles_plucker_line_batchf(11, p_1, 0, p_2, 0, kappa_batch, 6);
    comparef("chasles_plucker_linef, vector 3: kappa", 6, kappa, kappa_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_plucker_linef, vector 3, first of a batch: kappa", 6, kappa_batch, kappa_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_plucker_linef, vector 3, last: kappa", 6, kappa_batch + 60, kappa_expected, 8.0 * FLT_EPSILON);
}

static void plucker_transfer_vector_1(void)
{
    const double kappa_A[6] = {1.25, 0.5, -0.75, 2.0, -1.5, 0.25};
    const double a[3] = {1.75, -0.5, 0.75};
    const double b[3] = {-1.25, 1.5, 1.25};
    const double kappa_B_expected[6] = {1.25, 0.5, -0.75, 3.75, 0.125, 4.25};
    double kappa_B[6], kappa_B_batch[66];
    chasles_plucker_transfer(kappa_A, a, b, kappa_B);
    chasles_plucker_transfer_batch(11, kappa_A, 0, a, 0, b, 0, kappa_B_batch, 6);
    compare("chasles_plucker_transfer, vector 1: kappa_B", 6, kappa_B, kappa_B_expected, 8.0 * DBL_EPSILON);
    compare("chasles_plucker_transfer, vector 1, first of a batch: kappa_B", 6, kappa_B_batch, kappa_B_expected, 8.0 * DBL_EPSILON);
    compare("chasles_plucker_transfer, vector 1, last: kappa_B", 6, kappa_B_batch + 60, kappa_B_expected, 8.0 * DBL_EPSILON);
}

static void plucker_transfer_vector_2(void)
{
    const double kappa_A[6] = {2.0, -1.5, 0.25, 1.75, -0.5, 0.75};
    const double a[3] = {-1.25, 1.5, 1.25};
    const double b[3] = {0.5, -0.75, 2.0};
    const double kappa_B_expected[6] = {2.0, -1.5, 0.25, 1.1875, -1.5625, -1.125};
    double kappa_B[6], kappa_B_batch[66];
    chasles_plucker_transfer(kappa_A, a, b, kappa_B);
    chasles_plucker_transfer_batch(11, kappa_A, 0, a, 0, b, 0, kappa_B_batch, 6);
    compare("chasles_plucker_transfer, vector 2: kappa_B", 6, kappa_B, kappa_B_expected, 8.0 * DBL_EPSILON);
    compare("chasles_plucker_transfer, vector 2, first of a batch: kappa_B", 6, kappa_B_batch, kappa_B_expected, 8.0 * DBL_EPSILON);
    compare("chasles_plucker_transfer, vector 2, last: kappa_B", 6, kappa_B_batch + 60, kappa_B_expected, 8.0 * DBL_EPSILON);
}

static void plucker_transfer_vector_1f(void)
{
    const float kappa_A[6] = {1.25f, 0.5f, -0.75f, 2.0f, -1.5f, 0.25f};
    const float a[3] = {1.75f, -0.5f, 0.75f};
    const float b[3] = {-1.25f, 1.5f, 1.25f};
    const double kappa_B_expected[6] = {1.25, 0.5, -0.75, 3.75, 0.125, 4.25};
    float kappa_B[6], kappa_B_batch[66];
    chasles_plucker_transferf(kappa_A, a, b, kappa_B);
    chasles_plucker_transfer_batchf(11, kappa_A, 0, a, 0, b, 0, kappa_B_batch, 6);
    comparef("chasles_plucker_transferf, vector 1: kappa_B", 6, kappa_B, kappa_B_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_plucker_transferf, vector 1, first of a batch: kappa_B", 6, kappa_B_batch, kappa_B_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_plucker_transferf, vector 1, last: kappa_B", 6, kappa_B_batch + 60, kappa_B_expected, 8.0 * FLT_EPSILON);
}

static void plucker_transfer_vector_2f(void)
{
    const float kappa_A[6] = {2.0f, -1.5f, 0.25f, 1.75f, -0.5f, 0.75f};
    const float a[3] = {-1.25f, 1.5f, 1.25f};
    const float b[3] = {0.5f, -0.75f, 2.0f};
    const double kappa_B_expected[6] = {2.0, -1.5, 0.25, 1.1875, -1.5625, -1.125};
    float kappa_B[6], kappa_B_batch[66];
    chasles_plucker_transferf(kappa_A, a, b, kappa_B);
    chasles_plucker_transfer_batchf(11, kappa_A, 0, a, 0, b, 0, kappa_B_batch, 6);
    comparef("chasles_plucker_transferf, vector 2: kappa_B", 6, kappa_B, kappa_B_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_plucker_transferf, vector 2, first of a batch: kappa_B", 6, kappa_B_batch, kappa_B_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_plucker_transferf, vector 2, last: kappa_B", 6, kappa_B_batch + 60, kappa_B_expected, 8.0 * FLT_EPSILON);
}

static void rotation_in_triad_axes_vector_1(void)
{
    const double triad[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double triad_prime[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double Q_expected[9] = {
        0.93333333333333333333,
        -0.13333333333333333333,
        -0.33333333333333333333,
        0.33333333333333333333,
        0.66666666666666666667,
        0.66666666666666666667,
        0.13333333333333333333,
        -0.73333333333333333333,
        0.66666666666666666667,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_in_triad_axes(triad, triad_prime, Q);
    chasles_rotation_in_triad_axes_batch(11, triad, 0, triad_prime, 0, Q_batch, 9);
    compare("chasles_rotation_in_triad_axes, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_in_triad_axes, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_in_triad_axes, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_in_triad_axes_vector_2(void)
{
    const double triad[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double triad_prime[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double Q_expected[9] = {
        0.93333333333333333333,
        0.33333333333333333333,
        0.13333333333333333333,
        -0.13333333333333333333,
        0.66666666666666666667,
        -0.73333333333333333333,
        -0.33333333333333333333,
        0.66666666666666666667,
        0.66666666666666666667,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_in_triad_axes(triad, triad_prime, Q);
    chasles_rotation_in_triad_axes_batch(11, triad, 0, triad_prime, 0, Q_batch, 9);
    compare("chasles_rotation_in_triad_axes, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_in_triad_axes, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_in_triad_axes, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_in_triad_axes_vector_1f(void)
{
    const float triad[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const float triad_prime[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const double Q_expected[9] = {
        0.93333333333333333333,
        -0.13333333333333333333,
        -0.33333333333333333333,
        0.33333333333333333333,
        0.66666666666666666667,
        0.66666666666666666667,
        0.13333333333333333333,
        -0.73333333333333333333,
        0.66666666666666666667,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_in_triad_axesf(triad, triad_prime, Q);
    chasles_rotation_in_triad_axes_batchf(11, triad, 0, triad_prime, 0, Q_batch, 9);
    comparef("chasles_rotation_in_triad_axesf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_in_triad_axesf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_in_triad_axesf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_in_triad_axes_vector_2f(void)
{
    const float triad[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const float triad_prime[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const double Q_expected[9] = {
        0.93333333333333333333,
        0.33333333333333333333,
        0.13333333333333333333,
        -0.13333333333333333333,
        0.66666666666666666667,
        -0.73333333333333333333,
        -0.33333333333333333333,
        0.66666666666666666667,
        0.66666666666666666667,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_in_triad_axesf(triad, triad_prime, Q);
    chasles_rotation_in_triad_axes_batchf(11, triad, 0, triad_prime, 0, Q_batch, 9);
    comparef("chasles_rotation_in_triad_axesf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_in_triad_axesf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_in_triad_axesf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_triads_vector_1(void)
{
    const double triad[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double triad_prime[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double Q_expected[9] = {
        0.66666666666666666667,
        -0.13333333333333333333,
        -0.73333333333333333333,
        0.33333333333333333333,
        0.93333333333333333333,
        0.13333333333333333333,
        0.66666666666666666667,
        -0.33333333333333333333,
        0.66666666666666666667,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_triads(triad, triad_prime, Q);
    chasles_rotation_from_triads_batch(11, triad, 0, triad_prime, 0, Q_batch, 9);
    compare("chasles_rotation_from_triads, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_triads, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_triads, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_triads_vector_2(void)
{
    const double triad[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double triad_prime[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double Q_expected[9] = {
        0.66666666666666666667,
        0.33333333333333333333,
        0.66666666666666666667,
        -0.13333333333333333333,
        0.93333333333333333333,
        -0.33333333333333333333,
        -0.73333333333333333333,
        0.13333333333333333333,
        0.66666666666666666667,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_triads(triad, triad_prime, Q);
    chasles_rotation_from_triads_batch(11, triad, 0, triad_prime, 0, Q_batch, 9);
    compare("chasles_rotation_from_triads, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_triads, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_triads, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_triads_vector_1f(void)
{
    const float triad[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const float triad_prime[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const double Q_expected[9] = {
        0.66666666666666666667,
        -0.13333333333333333333,
        -0.73333333333333333333,
        0.33333333333333333333,
        0.93333333333333333333,
        0.13333333333333333333,
        0.66666666666666666667,
        -0.33333333333333333333,
        0.66666666666666666667,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_triadsf(triad, triad_prime, Q);
    chasles_rotation_from_triads_batchf(11, triad, 0, triad_prime, 0, Q_batch, 9);
    comparef("chasles_rotation_from_triadsf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_triadsf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_triadsf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_triads_vector_2f(void)
{
    const float triad[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const float triad_prime[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const double Q_expected[9] = {
        0.66666666666666666667,
        0.33333333333333333333,
        0.66666666666666666667,
        -0.13333333333333333333,
        0.93333333333333333333,
        -0.33333333333333333333,
        -0.73333333333333333333,
        0.13333333333333333333,
        0.66666666666666666667,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_triadsf(triad, triad_prime, Q);
    chasles_rotation_from_triads_batchf(11, triad, 0, triad_prime, 0, Q_batch, 9);
    comparef("chasles_rotation_from_triadsf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_triadsf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_triadsf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void axial_vector_vector_1(void)
{
    const double Omega[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double omega_expected[3] = {0.5, 0.5, 0.5};
    double omega[3], omega_batch[33];
    chasles_axial_vector(Omega, omega);
    chasles_axial_vector_batch(11, Omega, 0, omega_batch, 3);
    compare("chasles_axial_vector, vector 1: omega", 3, omega, omega_expected, 8.0 * DBL_EPSILON);
    compare("chasles_axial_vector, vector 1, first of a batch: omega", 3, omega_batch, omega_expected, 8.0 * DBL_EPSILON);
    compare("chasles_axial_vector, vector 1, last: omega", 3, omega_batch + 30, omega_expected, 8.0 * DBL_EPSILON);
}

static void axial_vector_vector_2(void)
{
    const double Omega[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double omega_expected[3] = {0.0, 0.0, 0.8};
    double omega[3], omega_batch[33];
    chasles_axial_vector(Omega, omega);
    chasles_axial_vector_batch(11, Omega, 0, omega_batch, 3);
    compare("chasles_axial_vector, vector 2: omega", 3, omega, omega_expected, 8.0 * DBL_EPSILON);
    compare("chasles_axial_vector, vector 2, first of a batch: omega", 3, omega_batch, omega_expected, 8.0 * DBL_EPSILON);
    compare("chasles_axial_vector, vector 2, last: omega", 3, omega_batch + 30, omega_expected, 8.0 * DBL_EPSILON);
}

static void axial_vector_vector_1f(void)
{
    const float Omega[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const double omega_expected[3] = {0.5, 0.5, 0.5};
    float omega[3], omega_batch[33];
    chasles_axial_vectorf(Omega, omega);
    chasles_axial_vector_batchf(11, Omega, 0, omega_batch, 3);
    comparef("chasles_axial_vectorf, vector 1: omega", 3, omega, omega_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_axial_vectorf, vector 1, first of a batch: omega", 3, omega_batch, omega_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_axial_vectorf, vector 1, last: omega", 3, omega_batch + 30, omega_expected, 8.0 * FLT_EPSILON);
}

static void axial_vector_vector_2f(void)
{
    const float Omega[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const double omega_expected[3] = {0.0, 0.0, 0.8};
    float omega[3], omega_batch[33];
    chasles_axial_vectorf(Omega, omega);
    chasles_axial_vector_batchf(11, Omega, 0, omega_batch, 3);
    comparef("chasles_axial_vectorf, vector 2: omega", 3, omega, omega_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_axial_vectorf, vector 2, first of a batch: omega", 3, omega_batch, omega_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_axial_vectorf, vector 2, last: omega", 3, omega_batch + 30, omega_expected, 8.0 * FLT_EPSILON);
}

static void velocity_of_point_vector_1(void)
{
    const double omega[3] = {1.25, 0.5, -0.75};
    const double a_dot[3] = {2.0, -1.5, 0.25};
    const double a[3] = {1.75, -0.5, 0.75};
    const double p[3] = {-1.25, 1.5, 1.25};
    const double p_dot_expected[3] = {3.75, 0.125, 4.25};
    double p_dot[3], p_dot_batch[33];
    chasles_velocity_of_point(omega, a_dot, a, p, p_dot);
    chasles_velocity_of_point_batch(11, omega, 0, a_dot, 0, a, 0, p, 0, p_dot_batch, 3);
    compare("chasles_velocity_of_point, vector 1: p_dot", 3, p_dot, p_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_velocity_of_point, vector 1, first of a batch: p_dot", 3, p_dot_batch, p_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_velocity_of_point, vector 1, last: p_dot", 3, p_dot_batch + 30, p_dot_expected, 8.0 * DBL_EPSILON);
}

static void velocity_of_point_vector_2(void)
{
    const double omega[3] = {2.0, -1.5, 0.25};
    const double a_dot[3] = {1.75, -0.5, 0.75};
    const double a[3] = {-1.25, 1.5, 1.25};
    const double p[3] = {0.5, -0.75, 2.0};
    const double p_dot_expected[3] = {1.1875, -1.5625, -1.125};
    double p_dot[3], p_dot_batch[33];
    chasles_velocity_of_point(omega, a_dot, a, p, p_dot);
    chasles_velocity_of_point_batch(11, omega, 0, a_dot, 0, a, 0, p, 0, p_dot_batch, 3);
    compare("chasles_velocity_of_point, vector 2: p_dot", 3, p_dot, p_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_velocity_of_point, vector 2, first of a batch: p_dot", 3, p_dot_batch, p_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_velocity_of_point, vector 2, last: p_dot", 3, p_dot_batch + 30, p_dot_expected, 8.0 * DBL_EPSILON);
}

static void velocity_of_point_vector_1f(void)
{
    const float omega[3] = {1.25f, 0.5f, -0.75f};
    const float a_dot[3] = {2.0f, -1.5f, 0.25f};
    const float a[3] = {1.75f, -0.5f, 0.75f};
    const float p[3] = {-1.25f, 1.5f, 1.25f};
    const double p_dot_expected[3] = {3.75, 0.125, 4.25};
    float p_dot[3], p_dot_batch[33];
    chasles_velocity_of_pointf(omega, a_dot, a, p, p_dot);
    chasles_velocity_of_point_batchf(11, omega, 0, a_dot, 0, a, 0, p, 0, p_dot_batch, 3);
    comparef("chasles_velocity_of_pointf, vector 1: p_dot", 3, p_dot, p_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_velocity_of_pointf, vector 1, first of a batch: p_dot", 3, p_dot_batch, p_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_velocity_of_pointf, vector 1, last: p_dot", 3, p_dot_batch + 30, p_dot_expected, 8.0 * FLT_EPSILON);
}

static void velocity_of_point_vector_2f(void)
{
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const float a_dot[3] = {1.75f, -0.5f, 0.75f};
    const float a[3] = {-1.25f, 1.5f, 1.25f};
    const float p[3] = {0.5f, -0.75f, 2.0f};
    const double p_dot_expected[3] = {1.1875, -1.5625, -1.125};
    float p_dot[3], p_dot_batch[33];
    chasles_velocity_of_pointf(omega, a_dot, a, p, p_dot);
    chasles_velocity_of_point_batchf(11, omega, 0, a_dot, 0, a, 0, p, 0, p_dot_batch, 3);
    comparef("chasles_velocity_of_pointf, vector 2: p_dot", 3, p_dot, p_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_velocity_of_pointf, vector 2, first of a batch: p_dot", 3, p_dot_batch, p_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_velocity_of_pointf, vector 2, last: p_dot", 3, p_dot_batch + 30, p_dot_expected, 8.0 * FLT_EPSILON);
}

static void instant_screw_point_vector_1(void)
{
    const double omega[3] = {1.25, 0.5, -0.75};
    const double a_dot[3] = {2.0, -1.5, 0.25};
    const double a[3] = {1.75, -0.5, 0.75};
    const double p_0_prime_expected[3] = {
        0.60526315789473684211,
        -1.5526315789473684211,
        -0.026315789473684210526,
    };
    double p_0_prime[3], p_0_prime_batch[33];
    chasles_instant_screw_point(omega, a_dot, a, p_0_prime);
    chasles_instant_screw_point_batch(11, omega, 0, a_dot, 0, a, 0, p_0_prime_batch, 3);
    compare("chasles_instant_screw_point, vector 1: p_0_prime", 3, p_0_prime, p_0_prime_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw_point, vector 1, first of a batch: p_0_prime", 3, p_0_prime_batch, p_0_prime_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw_point, vector 1, last: p_0_prime", 3, p_0_prime_batch + 30, p_0_prime_expected, 8.0 * DBL_EPSILON);
}

static void instant_screw_point_vector_2(void)
{
    const double omega[3] = {2.0, -1.5, 0.25};
    const double a_dot[3] = {1.75, -0.5, 0.75};
    const double a[3] = {-1.25, 1.5, 1.25};
    const double p_0_prime_expected[3] = {
        -0.0024752475247524752475,
        0.27722772277227722772,
        1.6831683168316831683,
    };
    double p_0_prime[3], p_0_prime_batch[33];
    chasles_instant_screw_point(omega, a_dot, a, p_0_prime);
    chasles_instant_screw_point_batch(11, omega, 0, a_dot, 0, a, 0, p_0_prime_batch, 3);
    compare("chasles_instant_screw_point, vector 2: p_0_prime", 3, p_0_prime, p_0_prime_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw_point, vector 2, first of a batch: p_0_prime", 3, p_0_prime_batch, p_0_prime_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw_point, vector 2, last: p_0_prime", 3, p_0_prime_batch + 30, p_0_prime_expected, 8.0 * DBL_EPSILON);
}

static void instant_screw_point_vector_3(void)
{
    const double omega[3] = {0.0, 0.0, 0.0};
    const double a_dot[3] = {0.0, 0.0, 0.0};
    const double a[3] = {0.0, 0.0, 0.0};
    const double p_0_prime_expected[3] = {NAN, NAN, NAN};
    double p_0_prime[3], p_0_prime_batch[33];
    chasles_instant_screw_point(omega, a_dot, a, p_0_prime);
    chasles_instant_screw_point_batch(11, omega, 0, a_dot, 0, a, 0, p_0_prime_batch, 3);
    compare("chasles_instant_screw_point, vector 3: p_0_prime", 3, p_0_prime, p_0_prime_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw_point, vector 3, first of a batch: p_0_prime", 3, p_0_prime_batch, p_0_prime_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw_point, vector 3, last: p_0_prime", 3, p_0_prime_batch + 30, p_0_prime_expected, 8.0 * DBL_EPSILON);
}

static void instant_screw_point_vector_1f(void)
{
    const float omega[3] = {1.25f, 0.5f, -0.75f};
    const float a_dot[3] = {2.0f, -1.5f, 0.25f};
    const float a[3] = {1.75f, -0.5f, 0.75f};
    const double p_0_prime_expected[3] = {
        0.60526315789473684211,
        -1.5526315789473684211,
        -0.026315789473684210526,
    };
    float p_0_prime[3], p_0_prime_batch[33];
    chasles_instant_screw_pointf(omega, a_dot, a, p_0_prime);
    chasles_instant_screw_point_batchf(11, omega, 0, a_dot, 0, a, 0, p_0_prime_batch, 3);
    comparef("chasles_instant_screw_pointf, vector 1: p_0_prime", 3, p_0_prime, p_0_prime_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screw_pointf, vector 1, first of a batch: p_0_prime", 3, p_0_prime_batch, p_0_prime_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screw_pointf, vector 1, last: p_0_prime", 3, p_0_prime_batch + 30, p_0_prime_expected, 8.0 * FLT_EPSILON);
}

static void instant_screw_point_vector_2f(void)
{
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const float a_dot[3] = {1.75f, -0.5f, 0.75f};
    const float a[3] = {-1.25f, 1.5f, 1.25f};
    const double p_0_prime_expected[3] = {
        -0.0024752475247524752475,
        0.27722772277227722772,
        1.6831683168316831683,
    };
    float p_0_prime[3], p_0_prime_batch[33];
    chasles_instant_screw_pointf(omega, a_dot, a, p_0_prime);
    chasles_instant_screw_point_batchf(11, omega, 0, a_dot, 0, a, 0, p_0_prime_batch, 3);
    comparef("chasles_instant_screw_pointf, vector 2: p_0_prime", 3, p_0_prime, p_0_prime_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screw_pointf, vector 2, first of a batch: p_0_prime", 3, p_0_prime_batch, p_0_prime_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screw_pointf, vector 2, last: p_0_prime", 3, p_0_prime_batch + 30, p_0_prime_expected, 8.0 * FLT_EPSILON);
}

static void instant_screw_point_vector_3f(void)
{
    const float omega[3] = {0.0f, 0.0f, 0.0f};
    const float a_dot[3] = {0.0f, 0.0f, 0.0f};
    const float a[3] = {0.0f, 0.0f, 0.0f};
    const double p_0_prime_expected[3] = {NAN, NAN, NAN};
    float p_0_prime[3], p_0_prime_batch[33];
    chasles_instant_screw_pointf(omega, a_dot, a, p_0_prime);
    chasles_instant_screw_point_batchf(11, omega, 0, a_dot, 0, a, 0, p_0_prime_batch, 3);
    comparef("chasles_instant_screw_pointf, vector 3: p_0_prime", 3, p_0_prime, p_0_prime_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screw_pointf, vector 3, first of a batch: p_0_prime", 3, p_0_prime_batch, p_0_prime_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screw_pointf, vector 3, last: p_0_prime", 3, p_0_prime_batch + 30, p_0_prime_expected, 8.0 * FLT_EPSILON);
}

static void natural_rate_matrix_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double N_expected[12] = {
        0.61601390022220513576,
        0.17932985827778204939,
        -0.48733680838888461727,
        -0.48733680838888461727,
        0.38500868763887820985,
        -0.14134028344443590121,
        0.17932985827778204939,
        -0.47467361677776923455,
        0.38500868763887820985,
        0.33333333333333333333,
        0.66666666666666666667,
        0.66666666666666666667,
    };
    double N[12], N_batch[132];
    chasles_natural_rate_matrix(e, phi[0], N);
    chasles_natural_rate_matrix_batch(11, e, 0, phi, 0, N_batch, 12);
    compare("chasles_natural_rate_matrix, vector 1: N", 12, N, N_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_rate_matrix, vector 1, first of a batch: N", 12, N_batch, N_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_rate_matrix, vector 1, last: N", 12, N_batch + 120, N_expected, 8.0 * DBL_EPSILON);
}

static void natural_rate_matrix_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double N_expected[12] = {
        0.3210463079671653515,
        0.4,
        -0.3,
        -0.4,
        0.20546963709898582496,
        -0.15410222782423936872,
        0.3,
        -0.15410222782423936872,
        0.11557667086817952654,
        0.0,
        0.6,
        0.8,
    };
    double N[12], N_batch[132];
    chasles_natural_rate_matrix(e, phi[0], N);
    chasles_natural_rate_matrix_batch(11, e, 0, phi, 0, N_batch, 12);
    compare("chasles_natural_rate_matrix, vector 2: N", 12, N, N_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_rate_matrix, vector 2, first of a batch: N", 12, N_batch, N_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_rate_matrix, vector 2, last: N", 12, N_batch + 120, N_expected, 8.0 * DBL_EPSILON);
}

static void natural_rate_matrix_vector_3(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {0.0};
    const double N_expected[12] = {
        NAN,
        NAN,
        NAN,
        NAN,
        NAN,
        NAN,
        NAN,
        NAN,
        NAN,
        0.33333333333333333333,
        0.66666666666666666667,
        0.66666666666666666667,
    };
    double N[12], N_batch[132];
    chasles_natural_rate_matrix(e, phi[0], N);
    chasles_natural_rate_matrix_batch(11, e, 0, phi, 0, N_batch, 12);
    compare("chasles_natural_rate_matrix, vector 3: N", 12, N, N_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_rate_matrix, vector 3, first of a batch: N", 12, N_batch, N_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_rate_matrix, vector 3, last: N", 12, N_batch + 120, N_expected, 8.0 * DBL_EPSILON);
}

static void natural_rate_matrix_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const double N_expected[12] = {
        0.61601390022220513576,
        0.17932985827778204939,
        -0.48733680838888461727,
        -0.48733680838888461727,
        0.38500868763887820985,
        -0.14134028344443590121,
        0.17932985827778204939,
        -0.47467361677776923455,
        0.38500868763887820985,
        0.33333333333333333333,
        0.66666666666666666667,
        0.66666666666666666667,
    };
    float N[12], N_batch[132];
    chasles_natural_rate_matrixf(e, phi[0], N);
    chasles_natural_rate_matrix_batchf(11, e, 0, phi, 0, N_batch, 12);
    comparef("chasles_natural_rate_matrixf, vector 1: N", 12, N, N_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_rate_matrixf, vector 1, first of a batch: N", 12, N_batch, N_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_rate_matrixf, vector 1, last: N", 12, N_batch + 120, N_expected, 8.0 * FLT_EPSILON);
}

static void natural_rate_matrix_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const double N_expected[12] = {
        0.3210463079671653515,
        0.4,
        -0.3,
        -0.4,
        0.20546963709898582496,
        -0.15410222782423936872,
        0.3,
        -0.15410222782423936872,
        0.11557667086817952654,
        0.0,
        0.6,
        0.8,
    };
    float N[12], N_batch[132];
    chasles_natural_rate_matrixf(e, phi[0], N);
    chasles_natural_rate_matrix_batchf(11, e, 0, phi, 0, N_batch, 12);
    comparef("chasles_natural_rate_matrixf, vector 2: N", 12, N, N_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_rate_matrixf, vector 2, first of a batch: N", 12, N_batch, N_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_rate_matrixf, vector 2, last: N", 12, N_batch + 120, N_expected, 8.0 * FLT_EPSILON);
}

static void natural_rate_matrix_vector_3f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {0.0f};
    const double N_expected[12] = {
        NAN,
        NAN,
        NAN,
        NAN,
        NAN,
        NAN,
        NAN,
        NAN,
        NAN,
        0.33333333333333333333,
        0.66666666666666666667,
        0.66666666666666666667,
    };
    float N[12], N_batch[132];
    chasles_natural_rate_matrixf(e, phi[0], N);
    chasles_natural_rate_matrix_batchf(11, e, 0, phi, 0, N_batch, 12);
    comparef("chasles_natural_rate_matrixf, vector 3: N", 12, N, N_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_rate_matrixf, vector 3, first of a batch: N", 12, N_batch, N_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_rate_matrixf, vector 3, last: N", 12, N_batch + 120, N_expected, 8.0 * FLT_EPSILON);
}

static void linear_rate_matrix_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double L_expected[12] = {
        0.61962353466403814747,
        0.24025291338466970094,
        -0.39240349951905444196,
        -0.39240349951905444196,
        0.50551059506324959171,
        0.0060135170915462947131,
        0.24025291338466970094,
        -0.31031468936031577674,
        0.50551059506324959171,
        -0.31632820645186207145,
        -0.6326564129037241429,
        -0.6326564129037241429,
    };
    double L[12], L_batch[132];
    chasles_linear_rate_matrix(e, phi[0], L);
    chasles_linear_rate_matrix_batch(11, e, 0, phi, 0, L_batch, 12);
    compare("chasles_linear_rate_matrix, vector 1: L", 12, L, L_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_rate_matrix, vector 1, first of a batch: L", 12, L_batch, L_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_rate_matrix, vector 1, last: L", 12, L_batch + 120, L_expected, 8.0 * DBL_EPSILON);
}

static void linear_rate_matrix_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double L_expected[12] = {
        0.2919265817264288065,
        0.36371897073027267816,
        -0.27278922804770450862,
        -0.36371897073027267816,
        0.037020151147943176842,
        -0.33987524077131417288,
        0.27278922804770450862,
        -0.33987524077131417288,
        -0.16124040596865675734,
        0.0,
        -0.54557845609540901724,
        -0.72743794146054535632,
    };
    double L[12], L_batch[132];
    chasles_linear_rate_matrix(e, phi[0], L);
    chasles_linear_rate_matrix_batch(11, e, 0, phi, 0, L_batch, 12);
    compare("chasles_linear_rate_matrix, vector 2: L", 12, L, L_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_rate_matrix, vector 2, first of a batch: L", 12, L_batch, L_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_rate_matrix, vector 2, last: L", 12, L_batch + 120, L_expected, 8.0 * DBL_EPSILON);
}

static void linear_rate_matrix_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const double L_expected[12] = {
        0.61962353466403814747,
        0.24025291338466970094,
        -0.39240349951905444196,
        -0.39240349951905444196,
        0.50551059506324959171,
        0.0060135170915462947131,
        0.24025291338466970094,
        -0.31031468936031577674,
        0.50551059506324959171,
        -0.31632820645186207145,
        -0.6326564129037241429,
        -0.6326564129037241429,
    };
    float L[12], L_batch[132];
    chasles_linear_rate_matrixf(e, phi[0], L);
    chasles_linear_rate_matrix_batchf(11, e, 0, phi, 0, L_batch, 12);
    comparef("chasles_linear_rate_matrixf, vector 1: L", 12, L, L_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_rate_matrixf, vector 1, first of a batch: L", 12, L_batch, L_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_rate_matrixf, vector 1, last: L", 12, L_batch + 120, L_expected, 8.0 * FLT_EPSILON);
}

static void linear_rate_matrix_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const double L_expected[12] = {
        0.2919265817264288065,
        0.36371897073027267816,
        -0.27278922804770450862,
        -0.36371897073027267816,
        0.037020151147943176842,
        -0.33987524077131417288,
        0.27278922804770450862,
        -0.33987524077131417288,
        -0.16124040596865675734,
        0.0,
        -0.54557845609540901724,
        -0.72743794146054535632,
    };
    float L[12], L_batch[132];
    chasles_linear_rate_matrixf(e, phi[0], L);
    chasles_linear_rate_matrix_batchf(11, e, 0, phi, 0, L_batch, 12);
    comparef("chasles_linear_rate_matrixf, vector 2: L", 12, L, L_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_rate_matrixf, vector 2, first of a batch: L", 12, L_batch, L_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_rate_matrixf, vector 2, last: L", 12, L_batch + 120, L_expected, 8.0 * FLT_EPSILON);
}

static void euler_rodrigues_rate_matrix_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double H_expected[12] = {
        0.40548155975260895109,
        0.19503242431348738494,
        -0.19503242431348738494,
        -0.19503242431348738494,
        0.40548155975260895109,
        0.097516212156743692468,
        0.19503242431348738494,
        -0.097516212156743692468,
        0.40548155975260895109,
        -0.097516212156743692468,
        -0.19503242431348738494,
        -0.19503242431348738494,
    };
    double H[12], H_batch[132];
    chasles_euler_rodrigues_rate_matrix(e, phi[0], H);
    chasles_euler_rodrigues_rate_matrix_batch(11, e, 0, phi, 0, H_batch, 12);
    compare("chasles_euler_rodrigues_rate_matrix, vector 1: H", 12, H, H_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_rate_matrix, vector 1, first of a batch: H", 12, H_batch, H_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_rate_matrix, vector 1, last: H", 12, H_batch + 120, H_expected, 8.0 * DBL_EPSILON);
}

static void euler_rodrigues_rate_matrix_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double H_expected[12] = {
        0.2701511529340698587,
        0.33658839392315860266,
        -0.252441295442368952,
        -0.33658839392315860266,
        0.2701511529340698587,
        0.0,
        0.252441295442368952,
        0.0,
        0.2701511529340698587,
        0.0,
        -0.252441295442368952,
        -0.33658839392315860266,
    };
    double H[12], H_batch[132];
    chasles_euler_rodrigues_rate_matrix(e, phi[0], H);
    chasles_euler_rodrigues_rate_matrix_batch(11, e, 0, phi, 0, H_batch, 12);
    compare("chasles_euler_rodrigues_rate_matrix, vector 2: H", 12, H, H_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_rate_matrix, vector 2, first of a batch: H", 12, H_batch, H_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_rate_matrix, vector 2, last: H", 12, H_batch + 120, H_expected, 8.0 * DBL_EPSILON);
}

static void euler_rodrigues_rate_matrix_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const double H_expected[12] = {
        0.40548155975260895109,
        0.19503242431348738494,
        -0.19503242431348738494,
        -0.19503242431348738494,
        0.40548155975260895109,
        0.097516212156743692468,
        0.19503242431348738494,
        -0.097516212156743692468,
        0.40548155975260895109,
        -0.097516212156743692468,
        -0.19503242431348738494,
        -0.19503242431348738494,
    };
    float H[12], H_batch[132];
    chasles_euler_rodrigues_rate_matrixf(e, phi[0], H);
    chasles_euler_rodrigues_rate_matrix_batchf(11, e, 0, phi, 0, H_batch, 12);
    comparef("chasles_euler_rodrigues_rate_matrixf, vector 1: H", 12, H, H_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_rate_matrixf, vector 1, first of a batch: H", 12, H_batch, H_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_rate_matrixf, vector 1, last: H", 12, H_batch + 120, H_expected, 8.0 * FLT_EPSILON);
}

static void euler_rodrigues_rate_matrix_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const double H_expected[12] = {
        0.2701511529340698587,
        0.33658839392315860266,
        -0.252441295442368952,
        -0.33658839392315860266,
        0.2701511529340698587,
        0.0,
        0.252441295442368952,
        0.0,
        0.2701511529340698587,
        0.0,
        -0.252441295442368952,
        -0.33658839392315860266,
    };
    float H[12], H_batch[132];
    chasles_euler_rodrigues_rate_matrixf(e, phi[0], H);
    chasles_euler_rodrigues_rate_matrix_batchf(11, e, 0, phi, 0, H_batch, 12);
    comparef("chasles_euler_rodrigues_rate_matrixf, vector 2: H", 12, H, H_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_rate_matrixf, vector 2, first of a batch: H", 12, H_batch, H_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_rate_matrixf, vector 2, last: H", 12, H_batch + 120, H_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_linear_invariants_vector_1(void)
{
    const double q[3] = {1.25, 0.5, -0.75};
    const double q_0[1] = {2.0};
    const double Q_expected[9] = {
        2.5208333333333333333,
        0.95833333333333333333,
        0.1875,
        -0.54166666666666666667,
        2.0833333333333333333,
        -1.375,
        -0.8125,
        1.125,
        2.1875,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_linear_invariants(q, q_0[0], Q);
    chasles_rotation_from_linear_invariants_batch(11, q, 0, q_0, 0, Q_batch, 9);
    compare("chasles_rotation_from_linear_invariants, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_linear_invariants, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_linear_invariants, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_linear_invariants_vector_2(void)
{
    const double q[3] = {2.0, -1.5, 0.25};
    const double q_0[1] = {1.75};
    const double Q_expected[9] = {
        3.2045454545454545455,
        -1.3409090909090909091,
        -1.3181818181818181818,
        -0.84090909090909090909,
        2.5681818181818181818,
        -2.1363636363636363636,
        1.6818181818181818182,
        1.8636363636363636364,
        1.7727272727272727273,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_linear_invariants(q, q_0[0], Q);
    chasles_rotation_from_linear_invariants_batch(11, q, 0, q_0, 0, Q_batch, 9);
    compare("chasles_rotation_from_linear_invariants, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_linear_invariants, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_linear_invariants, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_linear_invariants_vector_1f(void)
{
    const float q[3] = {1.25f, 0.5f, -0.75f};
    const float q_0[1] = {2.0f};
    const double Q_expected[9] = {
        2.5208333333333333333,
        0.95833333333333333333,
        0.1875,
        -0.54166666666666666667,
        2.0833333333333333333,
        -1.375,
        -0.8125,
        1.125,
        2.1875,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_linear_invariantsf(q, q_0[0], Q);
    chasles_rotation_from_linear_invariants_batchf(11, q, 0, q_0, 0, Q_batch, 9);
    comparef("chasles_rotation_from_linear_invariantsf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_linear_invariantsf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_linear_invariantsf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_linear_invariants_vector_2f(void)
{
    const float q[3] = {2.0f, -1.5f, 0.25f};
    const float q_0[1] = {1.75f};
    const double Q_expected[9] = {
        3.2045454545454545455,
        -1.3409090909090909091,
        -1.3181818181818181818,
        -0.84090909090909090909,
        2.5681818181818181818,
        -2.1363636363636363636,
        1.6818181818181818182,
        1.8636363636363636364,
        1.7727272727272727273,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_linear_invariantsf(q, q_0[0], Q);
    chasles_rotation_from_linear_invariants_batchf(11, q, 0, q_0, 0, Q_batch, 9);
    comparef("chasles_rotation_from_linear_invariantsf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_linear_invariantsf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_linear_invariantsf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_rodrigues_vector_1(void)
{
    const double q[3] = {1.25, 0.5, -0.75};
    const double q_0[1] = {2.0};
    const double Q_expected[9] = {4.75, 4.25, 0.125, -1.75, 2.125, -5.75, -3.875, 4.25, 2.75};
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_rodrigues(q, q_0[0], Q);
    chasles_rotation_from_euler_rodrigues_batch(11, q, 0, q_0, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_rodrigues, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_rodrigues, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_rodrigues, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_rodrigues_vector_2(void)
{
    const double q[3] = {2.0, -1.5, 0.25};
    const double q_0[1] = {1.75};
    const double Q_expected[9] = {4.75, -6.875, -4.25, -5.125, 1.25, -7.75, 6.25, 6.25, -3.125};
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_rodrigues(q, q_0[0], Q);
    chasles_rotation_from_euler_rodrigues_batch(11, q, 0, q_0, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_rodrigues, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_rodrigues, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_rodrigues, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_rodrigues_vector_1f(void)
{
    const float q[3] = {1.25f, 0.5f, -0.75f};
    const float q_0[1] = {2.0f};
    const double Q_expected[9] = {4.75, 4.25, 0.125, -1.75, 2.125, -5.75, -3.875, 4.25, 2.75};
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_rodriguesf(q, q_0[0], Q);
    chasles_rotation_from_euler_rodrigues_batchf(11, q, 0, q_0, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_rodriguesf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_rodriguesf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_rodriguesf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_rodrigues_vector_2f(void)
{
    const float q[3] = {2.0f, -1.5f, 0.25f};
    const float q_0[1] = {1.75f};
    const double Q_expected[9] = {4.75, -6.875, -4.25, -5.125, 1.25, -7.75, 6.25, 6.25, -3.125};
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_rodriguesf(q, q_0[0], Q);
    chasles_rotation_from_euler_rodrigues_batchf(11, q, 0, q_0, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_rodriguesf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_rodriguesf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_rodriguesf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void linear_invariants_vector_1(void)
{
    const double Q[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double q_expected[3] = {0.5, 0.5, 0.5};
    double q[3], q_batch[33];
    const double q_0_expected[1] = {0.5};
    double q_0[1], q_0_batch[11];
    chasles_linear_invariants(Q, q, q_0);
    chasles_linear_invariants_batch(11, Q, 0, q_batch, 3, q_0_batch, 1);
    compare("chasles_linear_invariants, vector 1: q", 3, q, q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_invariants, vector 1, first of a batch: q", 3, q_batch, q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_invariants, vector 1, last: q", 3, q_batch + 30, q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_invariants, vector 1: q_0", 1, q_0, q_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_invariants, vector 1, first of a batch: q_0", 1, q_0_batch, q_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_invariants, vector 1, last: q_0", 1, q_0_batch + 10, q_0_expected, 8.0 * DBL_EPSILON);
}

static void linear_invariants_vector_2(void)
{
    const double Q[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double q_expected[3] = {0.0, 0.0, 0.8};
    double q[3], q_batch[33];
    const double q_0_expected[1] = {0.6};
    double q_0[1], q_0_batch[11];
    chasles_linear_invariants(Q, q, q_0);
    chasles_linear_invariants_batch(11, Q, 0, q_batch, 3, q_0_batch, 1);
    compare("chasles_linear_invariants, vector 2: q", 3, q, q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_invariants, vector 2, first of a batch: q", 3, q_batch, q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_invariants, vector 2, last: q", 3, q_batch + 30, q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_invariants, vector 2: q_0", 1, q_0, q_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_invariants, vector 2, first of a batch: q_0", 1, q_0_batch, q_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_invariants, vector 2, last: q_0", 1, q_0_batch + 10, q_0_expected, 8.0 * DBL_EPSILON);
}

static void linear_invariants_vector_1f(void)
{
    const float Q[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const double q_expected[3] = {0.5, 0.5, 0.5};
    float q[3], q_batch[33];
    const double q_0_expected[1] = {0.5};
    float q_0[1], q_0_batch[11];
    chasles_linear_invariantsf(Q, q, q_0);
    chasles_linear_invariants_batchf(11, Q, 0, q_batch, 3, q_0_batch, 1);
    comparef("chasles_linear_invariantsf, vector 1: q", 3, q, q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_invariantsf, vector 1, first of a batch: q", 3, q_batch, q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_invariantsf, vector 1, last: q", 3, q_batch + 30, q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_invariantsf, vector 1: q_0", 1, q_0, q_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_invariantsf, vector 1, first of a batch: q_0", 1, q_0_batch, q_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_invariantsf, vector 1, last: q_0", 1, q_0_batch + 10, q_0_expected, 8.0 * FLT_EPSILON);
}

static void linear_invariants_vector_2f(void)
{
    const float Q[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const double q_expected[3] = {0.0, 0.0, 0.8};
    float q[3], q_batch[33];
    const double q_0_expected[1] = {0.6};
    float q_0[1], q_0_batch[11];
    chasles_linear_invariantsf(Q, q, q_0);
    chasles_linear_invariants_batchf(11, Q, 0, q_batch, 3, q_0_batch, 1);
    comparef("chasles_linear_invariantsf, vector 2: q", 3, q, q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_invariantsf, vector 2, first of a batch: q", 3, q_batch, q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_invariantsf, vector 2, last: q", 3, q_batch + 30, q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_invariantsf, vector 2: q_0", 1, q_0, q_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_invariantsf, vector 2, first of a batch: q_0", 1, q_0_batch, q_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_invariantsf, vector 2, last: q_0", 1, q_0_batch + 10, q_0_expected, 8.0 * FLT_EPSILON);
}

static void natural_invariants_vector_1(void)
{
    const double Q[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double e_expected[3] = {
        0.57735026918962576451,
        0.57735026918962576451,
        0.57735026918962576451,
    };
    double e[3], e_batch[33];
    const double phi_expected[1] = {1.0471975511965977462};
    double phi[1], phi_batch[11];
    chasles_natural_invariants(Q, e, phi);
    chasles_natural_invariants_batch(11, Q, 0, e_batch, 3, phi_batch, 1);
    compare("chasles_natural_invariants, vector 1: e", 3, e, e_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_invariants, vector 1, first of a batch: e", 3, e_batch, e_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_invariants, vector 1, last: e", 3, e_batch + 30, e_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_invariants, vector 1: phi", 1, phi, phi_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_invariants, vector 1, first of a batch: phi", 1, phi_batch, phi_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_invariants, vector 1, last: phi", 1, phi_batch + 10, phi_expected, 8.0 * DBL_EPSILON);
}

static void natural_invariants_vector_2(void)
{
    const double Q[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double e_expected[3] = {0.0, 0.0, 1.0};
    double e[3], e_batch[33];
    const double phi_expected[1] = {0.92729521800161223243};
    double phi[1], phi_batch[11];
    chasles_natural_invariants(Q, e, phi);
    chasles_natural_invariants_batch(11, Q, 0, e_batch, 3, phi_batch, 1);
    compare("chasles_natural_invariants, vector 2: e", 3, e, e_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_invariants, vector 2, first of a batch: e", 3, e_batch, e_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_invariants, vector 2, last: e", 3, e_batch + 30, e_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_invariants, vector 2: phi", 1, phi, phi_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_invariants, vector 2, first of a batch: phi", 1, phi_batch, phi_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_invariants, vector 2, last: phi", 1, phi_batch + 10, phi_expected, 8.0 * DBL_EPSILON);
}

static void natural_invariants_vector_1f(void)
{
    const float Q[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const double e_expected[3] = {
        0.57735026918962576451,
        0.57735026918962576451,
        0.57735026918962576451,
    };
    float e[3], e_batch[33];
    const double phi_expected[1] = {1.0471975511965977462};
    float phi[1], phi_batch[11];
    chasles_natural_invariantsf(Q, e, phi);
    chasles_natural_invariants_batchf(11, Q, 0, e_batch, 3, phi_batch, 1);
    comparef("chasles_natural_invariantsf, vector 1: e", 3, e, e_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_invariantsf, vector 1, first of a batch: e", 3, e_batch, e_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_invariantsf, vector 1, last: e", 3, e_batch + 30, e_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_invariantsf, vector 1: phi", 1, phi, phi_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_invariantsf, vector 1, first of a batch: phi", 1, phi_batch, phi_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_invariantsf, vector 1, last: phi", 1, phi_batch + 10, phi_expected, 8.0 * FLT_EPSILON);
}

static void natural_invariants_vector_2f(void)
{
    const float Q[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const double e_expected[3] = {0.0, 0.0, 1.0};
    float e[3], e_batch[33];
    const double phi_expected[1] = {0.92729521800161223243};
    float phi[1], phi_batch[11];
    chasles_natural_invariantsf(Q, e, phi);
    chasles_natural_invariants_batchf(11, Q, 0, e_batch, 3, phi_batch, 1);
    comparef("chasles_natural_invariantsf, vector 2: e", 3, e, e_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_invariantsf, vector 2, first of a batch: e", 3, e_batch, e_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_invariantsf, vector 2, last: e", 3, e_batch + 30, e_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_invariantsf, vector 2: phi", 1, phi, phi_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_invariantsf, vector 2, first of a batch: phi", 1, phi_batch, phi_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_invariantsf, vector 2, last: phi", 1, phi_batch + 10, phi_expected, 8.0 * FLT_EPSILON);
}

static void euler_rodrigues_parameters_vector_1(void)
{
    const double Q[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double q_expected[3] = {
        0.28867513459481288225,
        0.28867513459481288225,
        0.28867513459481288225,
    };
    double q[3], q_batch[33];
    const double q_0_expected[1] = {0.86602540378443864676};
    double q_0[1], q_0_batch[11];
    chasles_euler_rodrigues_parameters(Q, q, q_0);
    chasles_euler_rodrigues_parameters_batch(11, Q, 0, q_batch, 3, q_0_batch, 1);
    compare("chasles_euler_rodrigues_parameters, vector 1: q", 3, q, q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_parameters, vector 1, first of a batch: q", 3, q_batch, q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_parameters, vector 1, last: q", 3, q_batch + 30, q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_parameters, vector 1: q_0", 1, q_0, q_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_parameters, vector 1, first of a batch: q_0", 1, q_0_batch, q_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_parameters, vector 1, last: q_0", 1, q_0_batch + 10, q_0_expected, 8.0 * DBL_EPSILON);
}

static void euler_rodrigues_parameters_vector_2(void)
{
    const double Q[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double q_expected[3] = {0.0, 0.0, 0.44721359549995793928};
    double q[3], q_batch[33];
    const double q_0_expected[1] = {0.89442719099991587856};
    double q_0[1], q_0_batch[11];
    chasles_euler_rodrigues_parameters(Q, q, q_0);
    chasles_euler_rodrigues_parameters_batch(11, Q, 0, q_batch, 3, q_0_batch, 1);
    compare("chasles_euler_rodrigues_parameters, vector 2: q", 3, q, q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_parameters, vector 2, first of a batch: q", 3, q_batch, q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_parameters, vector 2, last: q", 3, q_batch + 30, q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_parameters, vector 2: q_0", 1, q_0, q_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_parameters, vector 2, first of a batch: q_0", 1, q_0_batch, q_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_parameters, vector 2, last: q_0", 1, q_0_batch + 10, q_0_expected, 8.0 * DBL_EPSILON);
}

static void euler_rodrigues_parameters_vector_1f(void)
{
    const float Q[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const double q_expected[3] = {
        0.28867513459481288225,
        0.28867513459481288225,
        0.28867513459481288225,
    };
    float q[3], q_batch[33];
    const double q_0_expected[1] = {0.86602540378443864676};
    float q_0[1], q_0_batch[11];
    chasles_euler_rodrigues_parametersf(Q, q, q_0);
    chasles_euler_rodrigues_parameters_batchf(11, Q, 0, q_batch, 3, q_0_batch, 1);
    comparef("chasles_euler_rodrigues_parametersf, vector 1: q", 3, q, q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_parametersf, vector 1, first of a batch: q", 3, q_batch, q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_parametersf, vector 1, last: q", 3, q_batch + 30, q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_parametersf, vector 1: q_0", 1, q_0, q_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_parametersf, vector 1, first of a batch: q_0", 1, q_0_batch, q_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_parametersf, vector 1, last: q_0", 1, q_0_batch + 10, q_0_expected, 8.0 * FLT_EPSILON);
}

static void euler_rodrigues_parameters_vector_2f(void)
{
    const float Q[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const double q_expected[3] = {0.0, 0.0, 0.44721359549995793928};
    float q[3], q_batch[33];
    const double q_0_expected[1] = {0.89442719099991587856};
    float q_0[1], q_0_batch[11];
    chasles_euler_rodrigues_parametersf(Q, q, q_0);
    chasles_euler_rodrigues_parameters_batchf(11, Q, 0, q_batch, 3, q_0_batch, 1);
    comparef("chasles_euler_rodrigues_parametersf, vector 2: q", 3, q, q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_parametersf, vector 2, first of a batch: q", 3, q_batch, q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_parametersf, vector 2, last: q", 3, q_batch + 30, q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_parametersf, vector 2: q_0", 1, q_0, q_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_parametersf, vector 2, first of a batch: q_0", 1, q_0_batch, q_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_parametersf, vector 2, last: q_0", 1, q_0_batch + 10, q_0_expected, 8.0 * FLT_EPSILON);
}

static void screw_of_motion_vector_1(void)
{
    const double Q[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double a[3] = {1.25, 0.5, -0.75};
    const double a_prime[3] = {2.0, -1.5, 0.25};
    const double axis_expected[6] = {
        0.57735026918962576451,
        0.57735026918962576451,
        0.57735026918962576451,
        0.57735026918962576451,
        -2.7424137786507223814,
        2.1650635094610966169,
    };
    double axis[6], axis_batch[66];
    const double d_0_expected[1] = {-0.14433756729740644113};
    double d_0[1], d_0_batch[11];
    const double phi_expected[1] = {1.0471975511965977462};
    double phi[1], phi_batch[11];
    chasles_screw_of_motion(Q, a, a_prime, axis, d_0, phi);
    chasles_screw_of_motion_batch(
        11,
        Q, 0,
        a, 0,
        a_prime, 0,
        axis_batch, 6,
        d_0_batch, 1,
        phi_batch, 1);
    compare("chasles_screw_of_motion, vector 1: axis", 6, axis, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 1, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 1, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 1: d_0", 1, d_0, d_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 1, first of a batch: d_0", 1, d_0_batch, d_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 1, last: d_0", 1, d_0_batch + 10, d_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 1: phi", 1, phi, phi_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 1, first of a batch: phi", 1, phi_batch, phi_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 1, last: phi", 1, phi_batch + 10, phi_expected, 8.0 * DBL_EPSILON);
}

static void screw_of_motion_vector_2(void)
{
    const double Q[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double a[3] = {2.0, -1.5, 0.25};
    const double a_prime[3] = {1.75, -0.5, 0.75};
    const double axis_expected[6] = {0.0, 0.0, 1.0, -1.25, -0.875, 0.0};
    double axis[6], axis_batch[66];
    const double d_0_expected[1] = {0.5};
    double d_0[1], d_0_batch[11];
    const double phi_expected[1] = {0.92729521800161223243};
    double phi[1], phi_batch[11];
    chasles_screw_of_motion(Q, a, a_prime, axis, d_0, phi);
    chasles_screw_of_motion_batch(
        11,
        Q, 0,
        a, 0,
        a_prime, 0,
        axis_batch, 6,
        d_0_batch, 1,
        phi_batch, 1);
    compare("chasles_screw_of_motion, vector 2: axis", 6, axis, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 2, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 2, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 2: d_0", 1, d_0, d_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 2, first of a batch: d_0", 1, d_0_batch, d_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 2, last: d_0", 1, d_0_batch + 10, d_0_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 2: phi", 1, phi, phi_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 2, first of a batch: phi", 1, phi_batch, phi_expected, 8.0 * DBL_EPSILON);
    compare("chasles_screw_of_motion, vector 2, last: phi", 1, phi_batch + 10, phi_expected, 8.0 * DBL_EPSILON);
}

static void screw_of_motion_vector_1f(void)
{
    const float Q[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const float a[3] = {1.25f, 0.5f, -0.75f};
    const float a_prime[3] = {2.0f, -1.5f, 0.25f};
    const double axis_expected[6] = {
        0.57735026918962576451,
        0.57735026918962576451,
        0.57735026918962576451,
        0.57735026918962576451,
        -2.7424137786507223814,
        2.1650635094610966169,
    };
    float axis[6], axis_batch[66];
    const double d_0_expected[1] = {-0.14433756729740644113};
    float d_0[1], d_0_batch[11];
    const double phi_expected[1] = {1.0471975511965977462};
    float phi[1], phi_batch[11];
    chasles_screw_of_motionf(Q, a, a_prime, axis, d_0, phi);
    chasles_screw_of_motion_batchf(
        11,
        Q, 0,
        a, 0,
        a_prime, 0,
        axis_batch, 6,
        d_0_batch, 1,
        phi_batch, 1);
    comparef("chasles_screw_of_motionf, vector 1: axis", 6, axis, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 1, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 1, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 1: d_0", 1, d_0, d_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 1, first of a batch: d_0", 1, d_0_batch, d_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 1, last: d_0", 1, d_0_batch + 10, d_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 1: phi", 1, phi, phi_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 1, first of a batch: phi", 1, phi_batch, phi_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 1, last: phi", 1, phi_batch + 10, phi_expected, 8.0 * FLT_EPSILON);
}

static void screw_of_motion_vector_2f(void)
{
    const float Q[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const float a[3] = {2.0f, -1.5f, 0.25f};
    const float a_prime[3] = {1.75f, -0.5f, 0.75f};
    const double axis_expected[6] = {0.0, 0.0, 1.0, -1.25, -0.875, 0.0};
    float axis[6], axis_batch[66];
    const double d_0_expected[1] = {0.5};
    float d_0[1], d_0_batch[11];
    const double phi_expected[1] = {0.92729521800161223243};
    float phi[1], phi_batch[11];
    chasles_screw_of_motionf(Q, a, a_prime, axis, d_0, phi);
    chasles_screw_of_motion_batchf(
        11,
        Q, 0,
        a, 0,
        a_prime, 0,
        axis_batch, 6,
        d_0_batch, 1,
        phi_batch, 1);
    comparef("chasles_screw_of_motionf, vector 2: axis", 6, axis, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 2, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 2, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 2: d_0", 1, d_0, d_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 2, first of a batch: d_0", 1, d_0_batch, d_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 2, last: d_0", 1, d_0_batch + 10, d_0_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 2: phi", 1, phi, phi_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 2, first of a batch: phi", 1, phi_batch, phi_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_screw_of_motionf, vector 2, last: phi", 1, phi_batch + 10, phi_expected, 8.0 * FLT_EPSILON);
}

static void instant_screw_vector_1(void)
{
    const double omega[3] = {1.25, 0.5, -0.75};
    const double a_dot[3] = {2.0, -1.5, 0.25};
    const double a[3] = {1.75, -0.5, 0.75};
    const double axis_expected[6] = {
        0.81110710565381269082,
        0.32444284226152507633,
        -0.48666426339228761449,
        0.76414827322122353504,
        0.27321502506233690638,
        1.4557238054102638293,
    };
    double axis[6], axis_batch[66];
    const double pitch_expected[1] = {0.65789473684210526316};
    double pitch[1], pitch_batch[11];
    chasles_instant_screw(omega, a_dot, a, axis, pitch);
    chasles_instant_screw_batch(11, omega, 0, a_dot, 0, a, 0, axis_batch, 6, pitch_batch, 1);
    compare("chasles_instant_screw, vector 1: axis", 6, axis, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 1, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 1, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 1: pitch", 1, pitch, pitch_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 1, first of a batch: pitch", 1, pitch_batch, pitch_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 1, last: pitch", 1, pitch_batch + 10, pitch_expected, 8.0 * DBL_EPSILON);
}

static void instant_screw_vector_2(void)
{
    const double omega[3] = {2.0, -1.5, 0.25};
    const double a_dot[3] = {1.75, -0.5, 0.75};
    const double a[3] = {-1.25, 1.5, 1.25};
    const double axis_expected[6] = {
        0.79602975216799130853,
        -0.5970223141259934814,
        0.099503719020998913567,
        1.0324742330099689249,
        1.3400983544387502196,
        -0.21920373744725008187,
    };
    double axis[6], axis_batch[66];
    const double pitch_expected[1] = {0.7029702970297029703};
    double pitch[1], pitch_batch[11];
    chasles_instant_screw(omega, a_dot, a, axis, pitch);
    chasles_instant_screw_batch(11, omega, 0, a_dot, 0, a, 0, axis_batch, 6, pitch_batch, 1);
    compare("chasles_instant_screw, vector 2: axis", 6, axis, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 2, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 2, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 2: pitch", 1, pitch, pitch_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 2, first of a batch: pitch", 1, pitch_batch, pitch_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 2, last: pitch", 1, pitch_batch + 10, pitch_expected, 8.0 * DBL_EPSILON);
}

static void instant_screw_vector_3(void)
{
    const double omega[3] = {0.0, 0.0, 0.0};
    const double a_dot[3] = {0.0, 0.0, 0.0};
    const double a[3] = {0.0, 0.0, 0.0};
    const double axis_expected[6] = {NAN, NAN, NAN, NAN, NAN, NAN};
    double axis[6], axis_batch[66];
    const double pitch_expected[1] = {NAN};
    double pitch[1], pitch_batch[11];
    chasles_instant_screw(omega, a_dot, a, axis, pitch);
    chasles_instant_screw_batch(11, omega, 0, a_dot, 0, a, 0, axis_batch, 6, pitch_batch, 1);
    compare("chasles_instant_screw, vector 3: axis", 6, axis, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 3, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 3, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 3: pitch", 1, pitch, pitch_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 3, first of a batch: pitch", 1, pitch_batch, pitch_expected, 8.0 * DBL_EPSILON);
    compare("chasles_instant_screw, vector 3, last: pitch", 1, pitch_batch + 10, pitch_expected, 8.0 * DBL_EPSILON);
}

static void instant_screw_vector_1f(void)
{
    const float omega[3] = {1.25f, 0.5f, -0.75f};
    const float a_dot[3] = {2.0f, -1.5f, 0.25f};
    const float a[3] = {1.75f, -0.5f, 0.75f};
    const double axis_expected[6] = {
        0.81110710565381269082,
        0.32444284226152507633,
        -0.48666426339228761449,
        0.76414827322122353504,
        0.27321502506233690638,
        1.4557238054102638293,
    };
    float axis[6], axis_batch[66];
    const double pitch_expected[1] = {0.65789473684210526316};
    float pitch[1], pitch_batch[11];
    chasles_instant_screwf(omega, a_dot, a, axis, pitch);
    chasles_instant_screw_batchf(11, omega, 0, a_dot, 0, a, 0, axis_batch, 6, pitch_batch, 1);
    comparef("chasles_instant_screwf, vector 1: axis", 6, axis, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 1, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 1, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 1: pitch", 1, pitch, pitch_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 1, first of a batch: pitch", 1, pitch_batch, pitch_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 1, last: pitch", 1, pitch_batch + 10, pitch_expected, 8.0 * FLT_EPSILON);
}

static void instant_screw_vector_2f(void)
{
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const float a_dot[3] = {1.75f, -0.5f, 0.75f};
    const float a[3] = {-1.25f, 1.5f, 1.25f};
    const double axis_expected[6] = {
        0.79602975216799130853,
        -0.5970223141259934814,
        0.099503719020998913567,
        1.0324742330099689249,
        1.3400983544387502196,
        -0.21920373744725008187,
    };
    float axis[6], axis_batch[66];
    const double pitch_expected[1] = {0.7029702970297029703};
    float pitch[1], pitch_batch[11];
    chasles_instant_screwf(omega, a_dot, a, axis, pitch);
    chasles_instant_screw_batchf(11, omega, 0, a_dot, 0, a, 0, axis_batch, 6, pitch_batch, 1);
    comparef("chasles_instant_screwf, vector 2: axis", 6, axis, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 2, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 2, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 2: pitch", 1, pitch, pitch_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 2, first of a batch: pitch", 1, pitch_batch, pitch_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 2, last: pitch", 1, pitch_batch + 10, pitch_expected, 8.0 * FLT_EPSILON);
}

static void instant_screw_vector_3f(void)
{
    const float omega[3] = {0.0f, 0.0f, 0.0f};
    const float a_dot[3] = {0.0f, 0.0f, 0.0f};
    const float a[3] = {0.0f, 0.0f, 0.0f};
    const double axis_expected[6] = {NAN, NAN, NAN, NAN, NAN, NAN};
    float axis[6], axis_batch[66];
    const double pitch_expected[1] = {NAN};
    float pitch[1], pitch_batch[11];
    chasles_instant_screwf(omega, a_dot, a, axis, pitch);
    chasles_instant_screw_batchf(11, omega, 0, a_dot, 0, a, 0, axis_batch, 6, pitch_batch, 1);
    comparef("chasles_instant_screwf, vector 3: axis", 6, axis, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 3, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 3, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 3: pitch", 1, pitch, pitch_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 3, first of a batch: pitch", 1, pitch_batch, pitch_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_instant_screwf, vector 3, last: pitch", 1, pitch_batch + 10, pitch_expected, 8.0 * FLT_EPSILON);
}

static void natural_velocity_matrix_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double N_tilde_expected[12] = {
        0.94898461935558621435,
        -0.45645175840315422303,
        0.45645175840315422303,
        0.33333333333333333333,
        0.45645175840315422303,
        0.94898461935558621435,
        -0.22822587920157711152,
        0.66666666666666666667,
        -0.45645175840315422303,
        0.22822587920157711152,
        0.94898461935558621435,
        0.66666666666666666667,
    };
    double N_tilde[12], N_tilde_batch[132];
    chasles_natural_velocity_matrix(e, phi[0], N_tilde);
    chasles_natural_velocity_matrix_batch(11, e, 0, phi, 0, N_tilde_batch, 12);
    compare("chasles_natural_velocity_matrix, vector 1: N_tilde", 12, N_tilde, N_tilde_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_velocity_matrix, vector 1, first of a batch: N_tilde", 12, N_tilde_batch, N_tilde_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_velocity_matrix, vector 1, last: N_tilde", 12, N_tilde_batch + 120, N_tilde_expected, 8.0 * DBL_EPSILON);
}

static void natural_velocity_matrix_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double N_tilde_expected[12] = {
        0.9092974268256816954,
        -1.1329174692377139096,
        0.8496881019282854322,
        0.0,
        1.1329174692377139096,
        0.9092974268256816954,
        0.0,
        0.6,
        -0.8496881019282854322,
        0.0,
        0.9092974268256816954,
        0.8,
    };
    double N_tilde[12], N_tilde_batch[132];
    chasles_natural_velocity_matrix(e, phi[0], N_tilde);
    chasles_natural_velocity_matrix_batch(11, e, 0, phi, 0, N_tilde_batch, 12);
    compare("chasles_natural_velocity_matrix, vector 2: N_tilde", 12, N_tilde, N_tilde_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_velocity_matrix, vector 2, first of a batch: N_tilde", 12, N_tilde_batch, N_tilde_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_velocity_matrix, vector 2, last: N_tilde", 12, N_tilde_batch + 120, N_tilde_expected, 8.0 * DBL_EPSILON);
}

static void natural_velocity_matrix_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const double N_tilde_expected[12] = {
        0.94898461935558621435,
        -0.45645175840315422303,
        0.45645175840315422303,
        0.33333333333333333333,
        0.45645175840315422303,
        0.94898461935558621435,
        -0.22822587920157711152,
        0.66666666666666666667,
        -0.45645175840315422303,
        0.22822587920157711152,
        0.94898461935558621435,
        0.66666666666666666667,
    };
    float N_tilde[12], N_tilde_batch[132];
    chasles_natural_velocity_matrixf(e, phi[0], N_tilde);
    chasles_natural_velocity_matrix_batchf(11, e, 0, phi, 0, N_tilde_batch, 12);
    comparef("chasles_natural_velocity_matrixf, vector 1: N_tilde", 12, N_tilde, N_tilde_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_velocity_matrixf, vector 1, first of a batch: N_tilde", 12, N_tilde_batch, N_tilde_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_velocity_matrixf, vector 1, last: N_tilde", 12, N_tilde_batch + 120, N_tilde_expected, 8.0 * FLT_EPSILON);
}

static void natural_velocity_matrix_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const double N_tilde_expected[12] = {
        0.9092974268256816954,
        -1.1329174692377139096,
        0.8496881019282854322,
        0.0,
        1.1329174692377139096,
        0.9092974268256816954,
        0.0,
        0.6,
        -0.8496881019282854322,
        0.0,
        0.9092974268256816954,
        0.8,
    };
    float N_tilde[12], N_tilde_batch[132];
    chasles_natural_velocity_matrixf(e, phi[0], N_tilde);
    chasles_natural_velocity_matrix_batchf(11, e, 0, phi, 0, N_tilde_batch, 12);
    comparef("chasles_natural_velocity_matrixf, vector 2: N_tilde", 12, N_tilde, N_tilde_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_velocity_matrixf, vector 2, first of a batch: N_tilde", 12, N_tilde_batch, N_tilde_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_velocity_matrixf, vector 2, last: N_tilde", 12, N_tilde_batch + 120, N_tilde_expected, 8.0 * FLT_EPSILON);
}

static void linear_velocity_matrix_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double L_tilde_expected[12] = {
        1.0,
        -0.48098962732726961333,
        0.48098962732726961333,
        -0.24049481366363480666,
        0.48098962732726961333,
        1.0,
        -0.24049481366363480666,
        -0.48098962732726961333,
        -0.48098962732726961333,
        0.24049481366363480666,
        1.0,
        -0.48098962732726961333,
    };
    double L_tilde[12], L_tilde_batch[132];
    chasles_linear_velocity_matrix(e, phi[0], L_tilde);
    chasles_linear_velocity_matrix_batch(11, e, 0, phi, 0, L_tilde_batch, 12);
    compare("chasles_linear_velocity_matrix, vector 1: L_tilde", 12, L_tilde, L_tilde_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_velocity_matrix, vector 1, first of a batch: L_tilde", 12, L_tilde_batch, L_tilde_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_velocity_matrix, vector 1, last: L_tilde", 12, L_tilde_batch + 120, L_tilde_expected, 8.0 * DBL_EPSILON);
}

static void linear_velocity_matrix_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double L_tilde_expected[12] = {
        1.0,
        -1.2459261797239217844,
        0.9344446347929413383,
        0.0,
        1.2459261797239217844,
        1.0,
        0.0,
        -0.9344446347929413383,
        -0.9344446347929413383,
        0.0,
        1.0,
        -1.2459261797239217844,
    };
    double L_tilde[12], L_tilde_batch[132];
    chasles_linear_velocity_matrix(e, phi[0], L_tilde);
    chasles_linear_velocity_matrix_batch(11, e, 0, phi, 0, L_tilde_batch, 12);
    compare("chasles_linear_velocity_matrix, vector 2: L_tilde", 12, L_tilde, L_tilde_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_velocity_matrix, vector 2, first of a batch: L_tilde", 12, L_tilde_batch, L_tilde_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_velocity_matrix, vector 2, last: L_tilde", 12, L_tilde_batch + 120, L_tilde_expected, 8.0 * DBL_EPSILON);
}

static void linear_velocity_matrix_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const double L_tilde_expected[12] = {
        1.0,
        -0.48098962732726961333,
        0.48098962732726961333,
        -0.24049481366363480666,
        0.48098962732726961333,
        1.0,
        -0.24049481366363480666,
        -0.48098962732726961333,
        -0.48098962732726961333,
        0.24049481366363480666,
        1.0,
        -0.48098962732726961333,
    };
    float L_tilde[12], L_tilde_batch[132];
    chasles_linear_velocity_matrixf(e, phi[0], L_tilde);
    chasles_linear_velocity_matrix_batchf(11, e, 0, phi, 0, L_tilde_batch, 12);
    comparef("chasles_linear_velocity_matrixf, vector 1: L_tilde", 12, L_tilde, L_tilde_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_velocity_matrixf, vector 1, first of a batch: L_tilde", 12, L_tilde_batch, L_tilde_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_velocity_matrixf, vector 1, last: L_tilde", 12, L_tilde_batch + 120, L_tilde_expected, 8.0 * FLT_EPSILON);
}

static void linear_velocity_matrix_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const double L_tilde_expected[12] = {
        1.0,
        -1.2459261797239217844,
        0.9344446347929413383,
        0.0,
        1.2459261797239217844,
        1.0,
        0.0,
        -0.9344446347929413383,
        -0.9344446347929413383,
        0.0,
        1.0,
        -1.2459261797239217844,
    };
    float L_tilde[12], L_tilde_batch[132];
    chasles_linear_velocity_matrixf(e, phi[0], L_tilde);
    chasles_linear_velocity_matrix_batchf(11, e, 0, phi, 0, L_tilde_batch, 12);
    comparef("chasles_linear_velocity_matrixf, vector 2: L_tilde", 12, L_tilde, L_tilde_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_velocity_matrixf, vector 2, first of a batch: L_tilde", 12, L_tilde_batch, L_tilde_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_velocity_matrixf, vector 2, last: L_tilde", 12, L_tilde_batch + 120, L_tilde_expected, 8.0 * FLT_EPSILON);
}

static void euler_rodrigues_velocity_matrix_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double H_tilde_expected[12] = {
        1.6219262390104358044,
        -0.78012969725394953974,
        0.78012969725394953974,
        -0.39006484862697476987,
        0.78012969725394953974,
        1.6219262390104358044,
        -0.39006484862697476987,
        -0.78012969725394953974,
        -0.78012969725394953974,
        0.39006484862697476987,
        1.6219262390104358044,
        -0.78012969725394953974,
    };
    double H_tilde[12], H_tilde_batch[132];
    chasles_euler_rodrigues_velocity_matrix(e, phi[0], H_tilde);
    chasles_euler_rodrigues_velocity_matrix_batch(11, e, 0, phi, 0, H_tilde_batch, 12);
    compare("chasles_euler_rodrigues_velocity_matrix, vector 1: H_tilde", 12, H_tilde, H_tilde_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_velocity_matrix, vector 1, first of a batch: H_tilde", 12, H_tilde_batch, H_tilde_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_velocity_matrix, vector 1, last: H_tilde", 12, H_tilde_batch + 120, H_tilde_expected, 8.0 * DBL_EPSILON);
}

static void euler_rodrigues_velocity_matrix_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double H_tilde_expected[12] = {
        1.0806046117362794348,
        -1.3463535756926344106,
        1.009765181769475808,
        0.0,
        1.3463535756926344106,
        1.0806046117362794348,
        0.0,
        -1.009765181769475808,
        -1.009765181769475808,
        0.0,
        1.0806046117362794348,
        -1.3463535756926344106,
    };
    double H_tilde[12], H_tilde_batch[132];
    chasles_euler_rodrigues_velocity_matrix(e, phi[0], H_tilde);
    chasles_euler_rodrigues_velocity_matrix_batch(11, e, 0, phi, 0, H_tilde_batch, 12);
    compare("chasles_euler_rodrigues_velocity_matrix, vector 2: H_tilde", 12, H_tilde, H_tilde_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_velocity_matrix, vector 2, first of a batch: H_tilde", 12, H_tilde_batch, H_tilde_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_velocity_matrix, vector 2, last: H_tilde", 12, H_tilde_batch + 120, H_tilde_expected, 8.0 * DBL_EPSILON);
}

static void euler_rodrigues_velocity_matrix_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const double H_tilde_expected[12] = {
        1.6219262390104358044,
        -0.78012969725394953974,
        0.78012969725394953974,
        -0.39006484862697476987,
        0.78012969725394953974,
        1.6219262390104358044,
        -0.39006484862697476987,
        -0.78012969725394953974,
        -0.78012969725394953974,
        0.39006484862697476987,
        1.6219262390104358044,
        -0.78012969725394953974,
    };
    float H_tilde[12], H_tilde_batch[132];
    chasles_euler_rodrigues_velocity_matrixf(e, phi[0], H_tilde);
    chasles_euler_rodrigues_velocity_matrix_batchf(11, e, 0, phi, 0, H_tilde_batch, 12);
    comparef("chasles_euler_rodrigues_velocity_matrixf, vector 1: H_tilde", 12, H_tilde, H_tilde_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_velocity_matrixf, vector 1, first of a batch: H_tilde", 12, H_tilde_batch, H_tilde_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_velocity_matrixf, vector 1, last: H_tilde", 12, H_tilde_batch + 120, H_tilde_expected, 8.0 * FLT_EPSILON);
}

static void euler_rodrigues_velocity_matrix_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const double H_tilde_expected[12] = {
        1.0806046117362794348,
        -1.3463535756926344106,
        1.009765181769475808,
        0.0,
        1.3463535756926344106,
        1.0806046117362794348,
        0.0,
        -1.009765181769475808,
        -1.009765181769475808,
        0.0,
        1.0806046117362794348,
        -1.3463535756926344106,
    };
    float H_tilde[12], H_tilde_batch[132];
    chasles_euler_rodrigues_velocity_matrixf(e, phi[0], H_tilde);
    chasles_euler_rodrigues_velocity_matrix_batchf(11, e, 0, phi, 0, H_tilde_batch, 12);
    comparef("chasles_euler_rodrigues_velocity_matrixf, vector 2: H_tilde", 12, H_tilde, H_tilde_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_velocity_matrixf, vector 2, first of a batch: H_tilde", 12, H_tilde_batch, H_tilde_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_velocity_matrixf, vector 2, last: H_tilde", 12, H_tilde_batch + 120, H_tilde_expected, 8.0 * FLT_EPSILON);
}

static void pose_rate_natural_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double t[6] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75};
    const double s_dot_expected[7] = {
        -0.80116406037500320371,
        -0.81510548681247276845,
        1.2156875169999743703,
        1.0,
        -1.5,
        0.25,
        1.75,
    };
    double s_dot[7], s_dot_batch[77];
    chasles_pose_rate_natural(e, phi[0], t, s_dot);
    chasles_pose_rate_natural_batch(11, e, 0, phi, 0, t, 0, s_dot_batch, 7);
    compare("chasles_pose_rate_natural, vector 1: s_dot", 7, s_dot, s_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_rate_natural, vector 1, first of a batch: s_dot", 7, s_dot_batch, s_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_rate_natural, vector 1, last: s_dot", 7, s_dot_batch + 70, s_dot_expected, 8.0 * DBL_EPSILON);
}

static void pose_rate_natural_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double t[6] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25};
    const double s_dot_expected[7] = {
        -0.90656946195074802725,
        0.38168851058232756098,
        -0.28626638293674567073,
        1.55,
        -0.5,
        0.75,
        -1.25,
    };
    double s_dot[7], s_dot_batch[77];
    chasles_pose_rate_natural(e, phi[0], t, s_dot);
    chasles_pose_rate_natural_batch(11, e, 0, phi, 0, t, 0, s_dot_batch, 7);
    compare("chasles_pose_rate_natural, vector 2: s_dot", 7, s_dot, s_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_rate_natural, vector 2, first of a batch: s_dot", 7, s_dot_batch, s_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_rate_natural, vector 2, last: s_dot", 7, s_dot_batch + 70, s_dot_expected, 8.0 * DBL_EPSILON);
}

static void pose_rate_natural_vector_3(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {0.0};
    const double t[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const double s_dot_expected[7] = {NAN, NAN, NAN, 0.0, 0.0, 0.0, 0.0};
    double s_dot[7], s_dot_batch[77];
    chasles_pose_rate_natural(e, phi[0], t, s_dot);
    chasles_pose_rate_natural_batch(11, e, 0, phi, 0, t, 0, s_dot_batch, 7);
    compare("chasles_pose_rate_natural, vector 3: s_dot", 7, s_dot, s_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_rate_natural, vector 3, first of a batch: s_dot", 7, s_dot_batch, s_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_rate_natural, vector 3, last: s_dot", 7, s_dot_batch + 70, s_dot_expected, 8.0 * DBL_EPSILON);
}

static void pose_rate_natural_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float t[6] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f};
    const double s_dot_expected[7] = {
        -0.80116406037500320371,
        -0.81510548681247276845,
        1.2156875169999743703,
        1.0,
        -1.5,
        0.25,
        1.75,
    };
    float s_dot[7], s_dot_batch[77];
    chasles_pose_rate_naturalf(e, phi[0], t, s_dot);
    chasles_pose_rate_natural_batchf(11, e, 0, phi, 0, t, 0, s_dot_batch, 7);
    comparef("chasles_pose_rate_naturalf, vector 1: s_dot", 7, s_dot, s_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_rate_naturalf, vector 1, first of a batch: s_dot", 7, s_dot_batch, s_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_rate_naturalf, vector 1, last: s_dot", 7, s_dot_batch + 70, s_dot_expected, 8.0 * FLT_EPSILON);
}

static void pose_rate_natural_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float t[6] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f};
    const double s_dot_expected[7] = {
        -0.90656946195074802725,
        0.38168851058232756098,
        -0.28626638293674567073,
        1.55,
        -0.5,
        0.75,
        -1.25,
    };
    float s_dot[7], s_dot_batch[77];
    chasles_pose_rate_naturalf(e, phi[0], t, s_dot);
    chasles_pose_rate_natural_batchf(11, e, 0, phi, 0, t, 0, s_dot_batch, 7);
    comparef("chasles_pose_rate_naturalf, vector 2: s_dot", 7, s_dot, s_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_rate_naturalf, vector 2, first of a batch: s_dot", 7, s_dot_batch, s_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_rate_naturalf, vector 2, last: s_dot", 7, s_dot_batch + 70, s_dot_expected, 8.0 * FLT_EPSILON);
}

static void pose_rate_natural_vector_3f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {0.0f};
    const float t[6] = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
    const double s_dot_expected[7] = {NAN, NAN, NAN, 0.0, 0.0, 0.0, 0.0};
    float s_dot[7], s_dot_batch[77];
    chasles_pose_rate_naturalf(e, phi[0], t, s_dot);
    chasles_pose_rate_natural_batchf(11, e, 0, phi, 0, t, 0, s_dot_batch, 7);
    comparef("chasles_pose_rate_naturalf, vector 3: s_dot", 7, s_dot, s_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_rate_naturalf, vector 3, first of a batch: s_dot", 7, s_dot_batch, s_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_rate_naturalf, vector 3, last: s_dot", 7, s_dot_batch + 70, s_dot_expected, 8.0 * FLT_EPSILON);
}

static void pose_rate_linear_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double t[6] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75};
    const double s_dot_expected[7] = {
        -0.65518491674459208588,
        -0.56330766187387182534,
        1.3638836638390708664,
        -0.94898461935558621435,
        -1.5,
        0.25,
        1.75,
    };
    double s_dot[7], s_dot_batch[77];
    chasles_pose_rate_linear(e, phi[0], t, s_dot);
    chasles_pose_rate_linear_batch(11, e, 0, phi, 0, t, 0, s_dot_batch, 7);
    compare("chasles_pose_rate_linear, vector 1: s_dot", 7, s_dot, s_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_rate_linear, vector 1, first of a batch: s_dot", 7, s_dot_batch, s_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_rate_linear, vector 1, last: s_dot", 7, s_dot_batch + 70, s_dot_expected, 8.0 * DBL_EPSILON);
}

static void pose_rate_linear_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double t[6] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25};
    const double s_dot_expected[7] = {
        -0.8243412789905579303,
        -0.039948177467404991091,
        -0.77632336270953463149,
        -1.4094110115798066279,
        -0.5,
        0.75,
        -1.25,
    };
    double s_dot[7], s_dot_batch[77];
    chasles_pose_rate_linear(e, phi[0], t, s_dot);
    chasles_pose_rate_linear_batch(11, e, 0, phi, 0, t, 0, s_dot_batch, 7);
    compare("chasles_pose_rate_linear, vector 2: s_dot", 7, s_dot, s_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_rate_linear, vector 2, first of a batch: s_dot", 7, s_dot_batch, s_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_rate_linear, vector 2, last: s_dot", 7, s_dot_batch + 70, s_dot_expected, 8.0 * DBL_EPSILON);
}

static void pose_rate_linear_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float t[6] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f};
    const double s_dot_expected[7] = {
        -0.65518491674459208588,
        -0.56330766187387182534,
        1.3638836638390708664,
        -0.94898461935558621435,
        -1.5,
        0.25,
        1.75,
    };
    float s_dot[7], s_dot_batch[77];
    chasles_pose_rate_linearf(e, phi[0], t, s_dot);
    chasles_pose_rate_linear_batchf(11, e, 0, phi, 0, t, 0, s_dot_batch, 7);
    comparef("chasles_pose_rate_linearf, vector 1: s_dot", 7, s_dot, s_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_rate_linearf, vector 1, first of a batch: s_dot", 7, s_dot_batch, s_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_rate_linearf, vector 1, last: s_dot", 7, s_dot_batch + 70, s_dot_expected, 8.0 * FLT_EPSILON);
}

static void pose_rate_linear_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float t[6] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f};
    const double s_dot_expected[7] = {
        -0.8243412789905579303,
        -0.039948177467404991091,
        -0.77632336270953463149,
        -1.4094110115798066279,
        -0.5,
        0.75,
        -1.25,
    };
    float s_dot[7], s_dot_batch[77];
    chasles_pose_rate_linearf(e, phi[0], t, s_dot);
    chasles_pose_rate_linear_batchf(11, e, 0, phi, 0, t, 0, s_dot_batch, 7);
    comparef("chasles_pose_rate_linearf, vector 2: s_dot", 7, s_dot, s_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_rate_linearf, vector 2, first of a batch: s_dot", 7, s_dot_batch, s_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_rate_linearf, vector 2, last: s_dot", 7, s_dot_batch + 70, s_dot_expected, 8.0 * FLT_EPSILON);
}

static void pose_rate_euler_rodrigues_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double t[6] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75};
    const double s_dot_expected[7] = {
        -0.33359838698578583302,
        -0.20659495765771302085,
        0.98161649077951936401,
        -0.2925486364702310774,
        -1.5,
        0.25,
        1.75,
    };
    double s_dot[7], s_dot_batch[77];
    chasles_pose_rate_euler_rodrigues(e, phi[0], t, s_dot);
    chasles_pose_rate_euler_rodrigues_batch(11, e, 0, phi, 0, t, 0, s_dot_batch, 7);
    compare("chasles_pose_rate_euler_rodrigues, vector 1: s_dot", 7, s_dot, s_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_rate_euler_rodrigues, vector 1, first of a batch: s_dot", 7, s_dot_batch, s_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_rate_euler_rodrigues, vector 1, last: s_dot", 7, s_dot_batch + 70, s_dot_expected, 8.0 * DBL_EPSILON);
}

static void pose_rate_euler_rodrigues_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double t[6] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25};
    const double s_dot_expected[7] = {
        -0.76285189794446080338,
        0.57242037911825536867,
        0.094102574471068824732,
        -0.65214001322611979266,
        -0.5,
        0.75,
        -1.25,
    };
    double s_dot[7], s_dot_batch[77];
    chasles_pose_rate_euler_rodrigues(e, phi[0], t, s_dot);
    chasles_pose_rate_euler_rodrigues_batch(11, e, 0, phi, 0, t, 0, s_dot_batch, 7);
    compare("chasles_pose_rate_euler_rodrigues, vector 2: s_dot", 7, s_dot, s_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_rate_euler_rodrigues, vector 2, first of a batch: s_dot", 7, s_dot_batch, s_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_rate_euler_rodrigues, vector 2, last: s_dot", 7, s_dot_batch + 70, s_dot_expected, 8.0 * DBL_EPSILON);
}

static void pose_rate_euler_rodrigues_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float t[6] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f};
    const double s_dot_expected[7] = {
        -0.33359838698578583302,
        -0.20659495765771302085,
        0.98161649077951936401,
        -0.2925486364702310774,
        -1.5,
        0.25,
        1.75,
    };
    float s_dot[7], s_dot_batch[77];
    chasles_pose_rate_euler_rodriguesf(e, phi[0], t, s_dot);
    chasles_pose_rate_euler_rodrigues_batchf(11, e, 0, phi, 0, t, 0, s_dot_batch, 7);
    comparef("chasles_pose_rate_euler_rodriguesf, vector 1: s_dot", 7, s_dot, s_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_rate_euler_rodriguesf, vector 1, first of a batch: s_dot", 7, s_dot_batch, s_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_rate_euler_rodriguesf, vector 1, last: s_dot", 7, s_dot_batch + 70, s_dot_expected, 8.0 * FLT_EPSILON);
}

static void pose_rate_euler_rodrigues_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float t[6] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f};
    const double s_dot_expected[7] = {
        -0.76285189794446080338,
        0.57242037911825536867,
        0.094102574471068824732,
        -0.65214001322611979266,
        -0.5,
        0.75,
        -1.25,
    };
    float s_dot[7], s_dot_batch[77];
    chasles_pose_rate_euler_rodriguesf(e, phi[0], t, s_dot);
    chasles_pose_rate_euler_rodrigues_batchf(11, e, 0, phi, 0, t, 0, s_dot_batch, 7);
    comparef("chasles_pose_rate_euler_rodriguesf, vector 2: s_dot", 7, s_dot, s_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_rate_euler_rodriguesf, vector 2, first of a batch: s_dot", 7, s_dot_batch, s_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_rate_euler_rodriguesf, vector 2, last: s_dot", 7, s_dot_batch + 70, s_dot_expected, 8.0 * FLT_EPSILON);
}

static void twist_from_pose_rate_natural_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double s_dot[7] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75, -0.5};
    const double t_expected[6] = {
        1.2297346452864672205,
        -1.9399643437182667723,
        0.49857395010841248354,
        0.25,
        1.75,
        -0.5,
    };
    double t[6], t_batch[66];
    chasles_twist_from_pose_rate_natural(e, phi[0], s_dot, t);
    chasles_twist_from_pose_rate_natural_batch(11, e, 0, phi, 0, s_dot, 0, t_batch, 6);
    compare("chasles_twist_from_pose_rate_natural, vector 1: t", 6, t, t_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_from_pose_rate_natural, vector 1, first of a batch: t", 6, t_batch, t_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_from_pose_rate_natural, vector 1, last: t", 6, t_batch + 60, t_expected, 8.0 * DBL_EPSILON);
}

static void twist_from_pose_rate_natural_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double s_dot[7] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25, 1.5};
    const double t_expected[6] = {
        -0.16022132917345151415,
        -1.7720518471501504405,
        2.4658026498373711152,
        0.75,
        -1.25,
        1.5,
    };
    double t[6], t_batch[66];
    chasles_twist_from_pose_rate_natural(e, phi[0], s_dot, t);
    chasles_twist_from_pose_rate_natural_batch(11, e, 0, phi, 0, s_dot, 0, t_batch, 6);
    compare("chasles_twist_from_pose_rate_natural, vector 2: t", 6, t, t_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_from_pose_rate_natural, vector 2, first of a batch: t", 6, t_batch, t_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_from_pose_rate_natural, vector 2, last: t", 6, t_batch + 60, t_expected, 8.0 * DBL_EPSILON);
}

static void twist_from_pose_rate_natural_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float s_dot[7] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f, -0.5f};
    const double t_expected[6] = {
        1.2297346452864672205,
        -1.9399643437182667723,
        0.49857395010841248354,
        0.25,
        1.75,
        -0.5,
    };
    float t[6], t_batch[66];
    chasles_twist_from_pose_rate_naturalf(e, phi[0], s_dot, t);
    chasles_twist_from_pose_rate_natural_batchf(11, e, 0, phi, 0, s_dot, 0, t_batch, 6);
    comparef("chasles_twist_from_pose_rate_naturalf, vector 1: t", 6, t, t_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_from_pose_rate_naturalf, vector 1, first of a batch: t", 6, t_batch, t_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_from_pose_rate_naturalf, vector 1, last: t", 6, t_batch + 60, t_expected, 8.0 * FLT_EPSILON);
}

static void twist_from_pose_rate_natural_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float s_dot[7] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f, 1.5f};
    const double t_expected[6] = {
        -0.16022132917345151415,
        -1.7720518471501504405,
        2.4658026498373711152,
        0.75,
        -1.25,
        1.5,
    };
    float t[6], t_batch[66];
    chasles_twist_from_pose_rate_naturalf(e, phi[0], s_dot, t);
    chasles_twist_from_pose_rate_natural_batchf(11, e, 0, phi, 0, s_dot, 0, t_batch, 6);
    comparef("chasles_twist_from_pose_rate_naturalf, vector 2: t", 6, t, t_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_from_pose_rate_naturalf, vector 2, first of a batch: t", 6, t_batch, t_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_from_pose_rate_naturalf, vector 2, last: t", 6, t_batch + 60, t_expected, 8.0 * FLT_EPSILON);
}

static void twist_from_pose_rate_linear_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double s_dot[7] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75, -0.5};
    const double t_expected[6] = {
        2.1834636956454436466,
        -0.26901037267273038667,
        2.3006185170795435083,
        0.25,
        1.75,
        -0.5,
    };
    double t[6], t_batch[66];
    chasles_twist_from_pose_rate_linear(e, phi[0], s_dot, t);
    chasles_twist_from_pose_rate_linear_batch(11, e, 0, phi, 0, s_dot, 0, t_batch, 6);
    compare("chasles_twist_from_pose_rate_linear, vector 1: t", 6, t, t_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_from_pose_rate_linear, vector 1, first of a batch: t", 6, t_batch, t_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_from_pose_rate_linear, vector 1, last: t", 6, t_batch + 60, t_expected, 8.0 * DBL_EPSILON);
}

static void twist_from_pose_rate_linear_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double s_dot[7] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25, 1.5};
    const double t_expected[6] = {
        -0.17620343404333310407,
        -1.1516669521894120075,
        3.7746300420513728997,
        0.75,
        -1.25,
        1.5,
    };
    double t[6], t_batch[66];
    chasles_twist_from_pose_rate_linear(e, phi[0], s_dot, t);
    chasles_twist_from_pose_rate_linear_batch(11, e, 0, phi, 0, s_dot, 0, t_batch, 6);
    compare("chasles_twist_from_pose_rate_linear, vector 2: t", 6, t, t_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_from_pose_rate_linear, vector 2, first of a batch: t", 6, t_batch, t_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_from_pose_rate_linear, vector 2, last: t", 6, t_batch + 60, t_expected, 8.0 * DBL_EPSILON);
}

static void twist_from_pose_rate_linear_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float s_dot[7] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f, -0.5f};
    const double t_expected[6] = {
        2.1834636956454436466,
        -0.26901037267273038667,
        2.3006185170795435083,
        0.25,
        1.75,
        -0.5,
    };
    float t[6], t_batch[66];
    chasles_twist_from_pose_rate_linearf(e, phi[0], s_dot, t);
    chasles_twist_from_pose_rate_linear_batchf(11, e, 0, phi, 0, s_dot, 0, t_batch, 6);
    comparef("chasles_twist_from_pose_rate_linearf, vector 1: t", 6, t, t_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_from_pose_rate_linearf, vector 1, first of a batch: t", 6, t_batch, t_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_from_pose_rate_linearf, vector 1, last: t", 6, t_batch + 60, t_expected, 8.0 * FLT_EPSILON);
}

static void twist_from_pose_rate_linear_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float s_dot[7] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f, 1.5f};
    const double t_expected[6] = {
        -0.17620343404333310407,
        -1.1516669521894120075,
        3.7746300420513728997,
        0.75,
        -1.25,
        1.5,
    };
    float t[6], t_batch[66];
    chasles_twist_from_pose_rate_linearf(e, phi[0], s_dot, t);
    chasles_twist_from_pose_rate_linear_batchf(11, e, 0, phi, 0, s_dot, 0, t_batch, 6);
    comparef("chasles_twist_from_pose_rate_linearf, vector 2: t", 6, t, t_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_from_pose_rate_linearf, vector 2, first of a batch: t", 6, t_batch, t_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_from_pose_rate_linearf, vector 2, last: t", 6, t_batch + 60, t_expected, 8.0 * FLT_EPSILON);
}

static void twist_from_pose_rate_euler_rodrigues_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double s_dot[7] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75, -0.5};
    const double t_expected[6] = {
        3.5414170598940412913,
        -0.43631498200387731354,
        3.7314335388045900711,
        0.25,
        1.75,
        -0.5,
    };
    double t[6], t_batch[66];
    chasles_twist_from_pose_rate_euler_rodrigues(e, phi[0], s_dot, t);
    chasles_twist_from_pose_rate_euler_rodrigues_batch(11, e, 0, phi, 0, s_dot, 0, t_batch, 6);
    compare("chasles_twist_from_pose_rate_euler_rodrigues, vector 1: t", 6, t, t_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_from_pose_rate_euler_rodrigues, vector 1, first of a batch: t", 6, t_batch, t_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_from_pose_rate_euler_rodrigues, vector 1, last: t", 6, t_batch + 60, t_expected, 8.0 * DBL_EPSILON);
}

static void twist_from_pose_rate_euler_rodrigues_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double s_dot[7] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25, 1.5};
    const double t_expected[6] = {
        -0.19040624343099509089,
        -1.2444966197201438533,
        4.0788826310390199282,
        0.75,
        -1.25,
        1.5,
    };
    double t[6], t_batch[66];
    chasles_twist_from_pose_rate_euler_rodrigues(e, phi[0], s_dot, t);
    chasles_twist_from_pose_rate_euler_rodrigues_batch(11, e, 0, phi, 0, s_dot, 0, t_batch, 6);
    compare("chasles_twist_from_pose_rate_euler_rodrigues, vector 2: t", 6, t, t_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_from_pose_rate_euler_rodrigues, vector 2, first of a batch: t", 6, t_batch, t_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_from_pose_rate_euler_rodrigues, vector 2, last: t", 6, t_batch + 60, t_expected, 8.0 * DBL_EPSILON);
}

static void twist_from_pose_rate_euler_rodrigues_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float s_dot[7] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f, -0.5f};
    const double t_expected[6] = {
        3.5414170598940412913,
        -0.43631498200387731354,
        3.7314335388045900711,
        0.25,
        1.75,
        -0.5,
    };
    float t[6], t_batch[66];
    chasles_twist_from_pose_rate_euler_rodriguesf(e, phi[0], s_dot, t);
    chasles_twist_from_pose_rate_euler_rodrigues_batchf(11, e, 0, phi, 0, s_dot, 0, t_batch, 6);
    comparef("chasles_twist_from_pose_rate_euler_rodriguesf, vector 1: t", 6, t, t_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_from_pose_rate_euler_rodriguesf, vector 1, first of a batch: t", 6, t_batch, t_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_from_pose_rate_euler_rodriguesf, vector 1, last: t", 6, t_batch + 60, t_expected, 8.0 * FLT_EPSILON);
}

static void twist_from_pose_rate_euler_rodrigues_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float s_dot[7] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f, 1.5f};
    const double t_expected[6] = {
        -0.19040624343099509089,
        -1.2444966197201438533,
        4.0788826310390199282,
        0.75,
        -1.25,
        1.5,
    };
    float t[6], t_batch[66];
    chasles_twist_from_pose_rate_euler_rodriguesf(e, phi[0], s_dot, t);
    chasles_twist_from_pose_rate_euler_rodrigues_batchf(11, e, 0, phi, 0, s_dot, 0, t_batch, 6);
    comparef("chasles_twist_from_pose_rate_euler_rodriguesf, vector 2: t", 6, t, t_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_from_pose_rate_euler_rodriguesf, vector 2, first of a batch: t", 6, t_batch, t_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_from_pose_rate_euler_rodriguesf, vector 2, last: t", 6, t_batch + 60, t_expected, 8.0 * FLT_EPSILON);
}

static void twist_transfer_vector_1(void)
{
    const double t_A[6] = {1.25, 0.5, -0.75, 2.0, -1.5, 0.25};
    const double a[3] = {1.75, -0.5, 0.75};
    const double p[3] = {-1.25, 1.5, 1.25};
    const double t_P_expected[6] = {1.25, 0.5, -0.75, 3.75, 0.125, 4.25};
    double t_P[6], t_P_batch[66];
    chasles_twist_transfer(t_A, a, p, t_P);
    chasles_twist_transfer_batch(11, t_A, 0, a, 0, p, 0, t_P_batch, 6);
    compare("chasles_twist_transfer, vector 1: t_P", 6, t_P, t_P_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_transfer, vector 1, first of a batch: t_P", 6, t_P_batch, t_P_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_transfer, vector 1, last: t_P", 6, t_P_batch + 60, t_P_expected, 8.0 * DBL_EPSILON);
}

static void twist_transfer_vector_2(void)
{
    const double t_A[6] = {2.0, -1.5, 0.25, 1.75, -0.5, 0.75};
    const double a[3] = {-1.25, 1.5, 1.25};
    const double p[3] = {0.5, -0.75, 2.0};
    const double t_P_expected[6] = {2.0, -1.5, 0.25, 1.1875, -1.5625, -1.125};
    double t_P[6], t_P_batch[66];
    chasles_twist_transfer(t_A, a, p, t_P);
    chasles_twist_transfer_batch(11, t_A, 0, a, 0, p, 0, t_P_batch, 6);
    compare("chasles_twist_transfer, vector 2: t_P", 6, t_P, t_P_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_transfer, vector 2, first of a batch: t_P", 6, t_P_batch, t_P_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_transfer, vector 2, last: t_P", 6, t_P_batch + 60, t_P_expected, 8.0 * DBL_EPSILON);
}

static void twist_transfer_vector_1f(void)
{
    const float t_A[6] = {1.25f, 0.5f, -0.75f, 2.0f, -1.5f, 0.25f};
    const float a[3] = {1.75f, -0.5f, 0.75f};
    const float p[3] = {-1.25f, 1.5f, 1.25f};
    const double t_P_expected[6] = {1.25, 0.5, -0.75, 3.75, 0.125, 4.25};
    float t_P[6], t_P_batch[66];
    chasles_twist_transferf(t_A, a, p, t_P);
    chasles_twist_transfer_batchf(11, t_A, 0, a, 0, p, 0, t_P_batch, 6);
    comparef("chasles_twist_transferf, vector 1: t_P", 6, t_P, t_P_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_transferf, vector 1, first of a batch: t_P", 6, t_P_batch, t_P_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_transferf, vector 1, last: t_P", 6, t_P_batch + 60, t_P_expected, 8.0 * FLT_EPSILON);
}

static void twist_transfer_vector_2f(void)
{
    const float t_A[6] = {2.0f, -1.5f, 0.25f, 1.75f, -0.5f, 0.75f};
    const float a[3] = {-1.25f, 1.5f, 1.25f};
    const float p[3] = {0.5f, -0.75f, 2.0f};
    const double t_P_expected[6] = {2.0, -1.5, 0.25, 1.1875, -1.5625, -1.125};
    float t_P[6], t_P_batch[66];
    chasles_twist_transferf(t_A, a, p, t_P);
    chasles_twist_transfer_batchf(11, t_A, 0, a, 0, p, 0, t_P_batch, 6);
    comparef("chasles_twist_transferf, vector 2: t_P", 6, t_P, t_P_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_transferf, vector 2, first of a batch: t_P", 6, t_P_batch, t_P_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_transferf, vector 2, last: t_P", 6, t_P_batch + 60, t_P_expected, 8.0 * FLT_EPSILON);
}

static void angular_acceleration_matrix_vector_1(void)
{
    const double omega[3] = {1.25, 0.5, -0.75};
    const double omega_dot[3] = {2.0, -1.5, 0.25};
    const double W_expected[9] = {
        -0.8125,
        0.375,
        -2.4375,
        0.875,
        -2.125,
        -2.375,
        0.5625,
        1.625,
        -1.8125,
    };
    double W[9], W_batch[99];
    chasles_angular_acceleration_matrix(omega, omega_dot, W);
    chasles_angular_acceleration_matrix_batch(11, omega, 0, omega_dot, 0, W_batch, 9);
    compare("chasles_angular_acceleration_matrix, vector 1: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_angular_acceleration_matrix, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_angular_acceleration_matrix, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void angular_acceleration_matrix_vector_2(void)
{
    const double omega[3] = {2.0, -1.5, 0.25};
    const double omega_dot[3] = {1.75, -0.5, 0.75};
    const double W_expected[9] = {-2.3125, -3.75, 0.0, -2.25, -4.0625, -2.125, 1.0, 1.375, -6.25};
    double W[9], W_batch[99];
    chasles_angular_acceleration_matrix(omega, omega_dot, W);
    chasles_angular_acceleration_matrix_batch(11, omega, 0, omega_dot, 0, W_batch, 9);
    compare("chasles_angular_acceleration_matrix, vector 2: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_angular_acceleration_matrix, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_angular_acceleration_matrix, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void angular_acceleration_matrix_vector_1f(void)
{
    const float omega[3] = {1.25f, 0.5f, -0.75f};
    const float omega_dot[3] = {2.0f, -1.5f, 0.25f};
    const double W_expected[9] = {
        -0.8125,
        0.375,
        -2.4375,
        0.875,
        -2.125,
        -2.375,
        0.5625,
        1.625,
        -1.8125,
    };
    float W[9], W_batch[99];
    chasles_angular_acceleration_matrixf(omega, omega_dot, W);
    chasles_angular_acceleration_matrix_batchf(11, omega, 0, omega_dot, 0, W_batch, 9);
    comparef("chasles_angular_acceleration_matrixf, vector 1: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_angular_acceleration_matrixf, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_angular_acceleration_matrixf, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void angular_acceleration_matrix_vector_2f(void)
{
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const float omega_dot[3] = {1.75f, -0.5f, 0.75f};
    const double W_expected[9] = {-2.3125, -3.75, 0.0, -2.25, -4.0625, -2.125, 1.0, 1.375, -6.25};
    float W[9], W_batch[99];
    chasles_angular_acceleration_matrixf(omega, omega_dot, W);
    chasles_angular_acceleration_matrix_batchf(11, omega, 0, omega_dot, 0, W_batch, 9);
    comparef("chasles_angular_acceleration_matrixf, vector 2: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_angular_acceleration_matrixf, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_angular_acceleration_matrixf, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void acceleration_of_point_vector_1(void)
{
    const double omega[3] = {1.25, 0.5, -0.75};
    const double omega_dot[3] = {2.0, -1.5, 0.25};
    const double a_ddot[3] = {1.75, -0.5, 0.75};
    const double a[3] = {-1.25, 1.5, 1.25};
    const double p[3] = {0.5, -0.75, 2.0};
    const double p_ddot_expected[3] = {-2.34375, 4.03125, -3.28125};
    double p_ddot[3], p_ddot_batch[33];
    chasles_acceleration_of_point(omega, omega_dot, a_ddot, a, p, p_ddot);
    chasles_acceleration_of_point_batch(
        11,
        omega, 0,
        omega_dot, 0,
        a_ddot, 0,
        a, 0,
        p, 0,
        p_ddot_batch, 3);
    compare("chasles_acceleration_of_point, vector 1: p_ddot", 3, p_ddot, p_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_acceleration_of_point, vector 1, first of a batch: p_ddot", 3, p_ddot_batch, p_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_acceleration_of_point, vector 1, last: p_ddot", 3, p_ddot_batch + 30, p_ddot_expected, 8.0 * DBL_EPSILON);
}

static void acceleration_of_point_vector_2(void)
{
    const double omega[3] = {2.0, -1.5, 0.25};
    const double omega_dot[3] = {1.75, -0.5, 0.75};
    const double a_ddot[3] = {-1.25, 1.5, 1.25};
    const double a[3] = {0.5, -0.75, 2.0};
    const double p[3] = {-1.5, 0.25, 1.75};
    const double p_ddot_expected[3] = {-0.375, 2.46875, 2.1875};
    double p_ddot[3], p_ddot_batch[33];
    chasles_acceleration_of_point(omega, omega_dot, a_ddot, a, p, p_ddot);
    chasles_acceleration_of_point_batch(
        11,
        omega, 0,
        omega_dot, 0,
        a_ddot, 0,
        a, 0,
        p, 0,
        p_ddot_batch, 3);
    compare("chasles_acceleration_of_point, vector 2: p_ddot", 3, p_ddot, p_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_acceleration_of_point, vector 2, first of a batch: p_ddot", 3, p_ddot_batch, p_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_acceleration_of_point, vector 2, last: p_ddot", 3, p_ddot_batch + 30, p_ddot_expected, 8.0 * DBL_EPSILON);
}

static void acceleration_of_point_vector_1f(void)
{
    const float omega[3] = {1.25f, 0.5f, -0.75f};
    const float omega_dot[3] = {2.0f, -1.5f, 0.25f};
    const float a_ddot[3] = {1.75f, -0.5f, 0.75f};
    const float a[3] = {-1.25f, 1.5f, 1.25f};
    const float p[3] = {0.5f, -0.75f, 2.0f};
    const double p_ddot_expected[3] = {-2.34375, 4.03125, -3.28125};
    float p_ddot[3], p_ddot_batch[33];
    chasles_acceleration_of_pointf(omega, omega_dot, a_ddot, a, p, p_ddot);
    chasles_acceleration_of_point_batchf(
        11,
        omega, 0,
        omega_dot, 0,
        a_ddot, 0,
        a, 0,
        p, 0,
        p_ddot_batch, 3);
    comparef("chasles_acceleration_of_pointf, vector 1: p_ddot", 3, p_ddot, p_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_acceleration_of_pointf, vector 1, first of a batch: p_ddot", 3, p_ddot_batch, p_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_acceleration_of_pointf, vector 1, last: p_ddot", 3, p_ddot_batch + 30, p_ddot_expected, 8.0 * FLT_EPSILON);
}

static void acceleration_of_point_vector_2f(void)
{
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const float omega_dot[3] = {1.75f, -0.5f, 0.75f};
    const float a_ddot[3] = {-1.25f, 1.5f, 1.25f};
    const float a[3] = {0.5f, -0.75f, 2.0f};
    const float p[3] = {-1.5f, 0.25f, 1.75f};
    const double p_ddot_expected[3] = {-0.375, 2.46875, 2.1875};
    float p_ddot[3], p_ddot_batch[33];
    chasles_acceleration_of_pointf(omega, omega_dot, a_ddot, a, p, p_ddot);
    chasles_acceleration_of_point_batchf(
        11,
        omega, 0,
        omega_dot, 0,
        a_ddot, 0,
        a, 0,
        p, 0,
        p_ddot_batch, 3);
    comparef("chasles_acceleration_of_pointf, vector 2: p_ddot", 3, p_ddot, p_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_acceleration_of_pointf, vector 2, first of a batch: p_ddot", 3, p_ddot_batch, p_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_acceleration_of_pointf, vector 2, last: p_ddot", 3, p_ddot_batch + 30, p_ddot_expected, 8.0 * FLT_EPSILON);
}

static void natural_rate_matrix_dot_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double omega[3] = {0.5, -0.75, 2.0};
    const double N_dot_expected[12] = {
        -0.27898333998546877378,
        1.3285658949579282903,
        0.65915111030575008976,
        0.11287837795795391998,
        0.3474685349435766037,
        -0.26109036019476721496,
        -0.15595437650672267869,
        0.54007370018023598875,
        -1.5290265432901329947,
        -0.80116406037500320371,
        -0.81510548681247276845,
        1.2156875169999743703,
    };
    double N_dot[12], N_dot_batch[132];
    chasles_natural_rate_matrix_dot(e, phi[0], omega, N_dot);
    chasles_natural_rate_matrix_dot_batch(11, e, 0, phi, 0, omega, 0, N_dot_batch, 12);
    compare("chasles_natural_rate_matrix_dot, vector 1: N_dot", 12, N_dot, N_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_rate_matrix_dot, vector 1, first of a batch: N_dot", 12, N_dot_batch, N_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_rate_matrix_dot, vector 1, last: N_dot", 12, N_dot_batch + 120, N_dot_expected, 8.0 * DBL_EPSILON);
}

static void natural_rate_matrix_dot_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double omega[3] = {-1.5, 0.25, 1.75};
    const double N_dot_expected[12] = {
        -0.54725963438198936691,
        0.031497275736667510054,
        0.041996367648890013405,
        0.31776365867341318079,
        -0.49729379054360429733,
        -0.23348899696259902241,
        0.42368487823121757438,
        0.67308046498814900485,
        -0.049965843838385069586,
        -0.90656946195074802725,
        0.38168851058232756098,
        -0.28626638293674567073,
    };
    double N_dot[12], N_dot_batch[132];
    chasles_natural_rate_matrix_dot(e, phi[0], omega, N_dot);
    chasles_natural_rate_matrix_dot_batch(11, e, 0, phi, 0, omega, 0, N_dot_batch, 12);
    compare("chasles_natural_rate_matrix_dot, vector 2: N_dot", 12, N_dot, N_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_rate_matrix_dot, vector 2, first of a batch: N_dot", 12, N_dot_batch, N_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_rate_matrix_dot, vector 2, last: N_dot", 12, N_dot_batch + 120, N_dot_expected, 8.0 * DBL_EPSILON);
}

static void natural_rate_matrix_dot_vector_3(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {0.0};
    const double omega[3] = {0.0, 0.0, 0.0};
    const double N_dot_expected[12] = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};
    double N_dot[12], N_dot_batch[132];
    chasles_natural_rate_matrix_dot(e, phi[0], omega, N_dot);
    chasles_natural_rate_matrix_dot_batch(11, e, 0, phi, 0, omega, 0, N_dot_batch, 12);
    compare("chasles_natural_rate_matrix_dot, vector 3: N_dot", 12, N_dot, N_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_rate_matrix_dot, vector 3, first of a batch: N_dot", 12, N_dot_batch, N_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_rate_matrix_dot, vector 3, last: N_dot", 12, N_dot_batch + 120, N_dot_expected, 8.0 * DBL_EPSILON);
}

static void natural_rate_matrix_dot_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float omega[3] = {0.5f, -0.75f, 2.0f};
    const double N_dot_expected[12] = {
        -0.27898333998546877378,
        1.3285658949579282903,
        0.65915111030575008976,
        0.11287837795795391998,
        0.3474685349435766037,
        -0.26109036019476721496,
        -0.15595437650672267869,
        0.54007370018023598875,
        -1.5290265432901329947,
        -0.80116406037500320371,
        -0.81510548681247276845,
        1.2156875169999743703,
    };
    float N_dot[12], N_dot_batch[132];
    chasles_natural_rate_matrix_dotf(e, phi[0], omega, N_dot);
    chasles_natural_rate_matrix_dot_batchf(11, e, 0, phi, 0, omega, 0, N_dot_batch, 12);
    comparef("chasles_natural_rate_matrix_dotf, vector 1: N_dot", 12, N_dot, N_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_rate_matrix_dotf, vector 1, first of a batch: N_dot", 12, N_dot_batch, N_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_rate_matrix_dotf, vector 1, last: N_dot", 12, N_dot_batch + 120, N_dot_expected, 8.0 * FLT_EPSILON);
}

static void natural_rate_matrix_dot_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float omega[3] = {-1.5f, 0.25f, 1.75f};
    const double N_dot_expected[12] = {
        -0.54725963438198936691,
        0.031497275736667510054,
        0.041996367648890013405,
        0.31776365867341318079,
        -0.49729379054360429733,
        -0.23348899696259902241,
        0.42368487823121757438,
        0.67308046498814900485,
        -0.049965843838385069586,
        -0.90656946195074802725,
        0.38168851058232756098,
        -0.28626638293674567073,
    };
    float N_dot[12], N_dot_batch[132];
    chasles_natural_rate_matrix_dotf(e, phi[0], omega, N_dot);
    chasles_natural_rate_matrix_dot_batchf(11, e, 0, phi, 0, omega, 0, N_dot_batch, 12);
    comparef("chasles_natural_rate_matrix_dotf, vector 2: N_dot", 12, N_dot, N_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_rate_matrix_dotf, vector 2, first of a batch: N_dot", 12, N_dot_batch, N_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_rate_matrix_dotf, vector 2, last: N_dot", 12, N_dot_batch + 120, N_dot_expected, 8.0 * FLT_EPSILON);
}

static void natural_rate_matrix_dot_vector_3f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {0.0f};
    const float omega[3] = {0.0f, 0.0f, 0.0f};
    const double N_dot_expected[12] = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};
    float N_dot[12], N_dot_batch[132];
    chasles_natural_rate_matrix_dotf(e, phi[0], omega, N_dot);
    chasles_natural_rate_matrix_dot_batchf(11, e, 0, phi, 0, omega, 0, N_dot_batch, 12);
    comparef("chasles_natural_rate_matrix_dotf, vector 3: N_dot", 12, N_dot, N_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_rate_matrix_dotf, vector 3, first of a batch: N_dot", 12, N_dot_batch, N_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_rate_matrix_dotf, vector 3, last: N_dot", 12, N_dot_batch + 120, N_dot_expected, 8.0 * FLT_EPSILON);
}

static void linear_rate_matrix_dot_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double omega[3] = {0.5, -0.75, 2.0};
    const double L_dot_expected[12] = {
        -0.34436730535597960615,
        0.85235955168427498002,
        0.22033179131592171588,
        -0.51152411215479588643,
        -0.31332144790608892409,
        -0.62990111537209934704,
        -0.34297587055795010946,
        0.02528380137249273884,
        -1.2402804854491038985,
        0.65518491674459208588,
        0.56330766187387182534,
        -1.3638836638390708664,
    };
    double L_dot[12], L_dot_batch[132];
    chasles_linear_rate_matrix_dot(e, phi[0], omega, L_dot);
    chasles_linear_rate_matrix_dot_batch(11, e, 0, phi, 0, omega, 0, L_dot_batch, 12);
    compare("chasles_linear_rate_matrix_dot, vector 1: L_dot", 12, L_dot, L_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_rate_matrix_dot, vector 1, first of a batch: L_dot", 12, L_dot_batch, L_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_rate_matrix_dot, vector 1, last: L_dot", 12, L_dot_batch + 120, L_dot_expected, 8.0 * DBL_EPSILON);
}

static void linear_rate_matrix_dot_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double omega[3] = {-1.5, 0.25, 1.75};
    const double L_dot_expected[12] = {
        -0.70470550578990331393,
        -0.0030110386592282799385,
        0.53350827899442120995,
        0.77331232405030635155,
        -1.2827156739588007004,
        -0.84502150321575444559,
        0.49356010152701621886,
        -0.020680224225196515298,
        -0.83140084341090924139,
        0.8243412789905579303,
        0.039948177467404991091,
        0.77632336270953463149,
    };
    double L_dot[12], L_dot_batch[132];
    chasles_linear_rate_matrix_dot(e, phi[0], omega, L_dot);
    chasles_linear_rate_matrix_dot_batch(11, e, 0, phi, 0, omega, 0, L_dot_batch, 12);
    compare("chasles_linear_rate_matrix_dot, vector 2: L_dot", 12, L_dot, L_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_rate_matrix_dot, vector 2, first of a batch: L_dot", 12, L_dot_batch, L_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_rate_matrix_dot, vector 2, last: L_dot", 12, L_dot_batch + 120, L_dot_expected, 8.0 * DBL_EPSILON);
}

static void linear_rate_matrix_dot_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float omega[3] = {0.5f, -0.75f, 2.0f};
    const double L_dot_expected[12] = {
        -0.34436730535597960615,
        0.85235955168427498002,
        0.22033179131592171588,
        -0.51152411215479588643,
        -0.31332144790608892409,
        -0.62990111537209934704,
        -0.34297587055795010946,
        0.02528380137249273884,
        -1.2402804854491038985,
        0.65518491674459208588,
        0.56330766187387182534,
        -1.3638836638390708664,
    };
    float L_dot[12], L_dot_batch[132];
    chasles_linear_rate_matrix_dotf(e, phi[0], omega, L_dot);
    chasles_linear_rate_matrix_dot_batchf(11, e, 0, phi, 0, omega, 0, L_dot_batch, 12);
    comparef("chasles_linear_rate_matrix_dotf, vector 1: L_dot", 12, L_dot, L_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_rate_matrix_dotf, vector 1, first of a batch: L_dot", 12, L_dot_batch, L_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_rate_matrix_dotf, vector 1, last: L_dot", 12, L_dot_batch + 120, L_dot_expected, 8.0 * FLT_EPSILON);
}

static void linear_rate_matrix_dot_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float omega[3] = {-1.5f, 0.25f, 1.75f};
    const double L_dot_expected[12] = {
        -0.70470550578990331393,
        -0.0030110386592282799385,
        0.53350827899442120995,
        0.77331232405030635155,
        -1.2827156739588007004,
        -0.84502150321575444559,
        0.49356010152701621886,
        -0.020680224225196515298,
        -0.83140084341090924139,
        0.8243412789905579303,
        0.039948177467404991091,
        0.77632336270953463149,
    };
    float L_dot[12], L_dot_batch[132];
    chasles_linear_rate_matrix_dotf(e, phi[0], omega, L_dot);
    chasles_linear_rate_matrix_dot_batchf(11, e, 0, phi, 0, omega, 0, L_dot_batch, 12);
    comparef("chasles_linear_rate_matrix_dotf, vector 2: L_dot", 12, L_dot, L_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_rate_matrix_dotf, vector 2, first of a batch: L_dot", 12, L_dot_batch, L_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_rate_matrix_dotf, vector 2, last: L_dot", 12, L_dot_batch + 120, L_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rodrigues_rate_matrix_dot_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double omega[3] = {0.5, -0.75, 2.0};
    const double H_dot_expected[12] = {
        -0.1462743182351155387,
        0.490808245389759682,
        0.10329747882885651043,
        -0.490808245389759682,
        -0.1462743182351155387,
        -0.16679919349289291651,
        -0.10329747882885651043,
        0.16679919349289291651,
        -0.1462743182351155387,
        0.16679919349289291651,
        0.10329747882885651043,
        -0.490808245389759682,
    };
    double H_dot[12], H_dot_batch[132];
    chasles_euler_rodrigues_rate_matrix_dot(e, phi[0], omega, H_dot);
    chasles_euler_rodrigues_rate_matrix_dot_batch(11, e, 0, phi, 0, omega, 0, H_dot_batch, 12);
    compare("chasles_euler_rodrigues_rate_matrix_dot, vector 1: H_dot", 12, H_dot, H_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_rate_matrix_dot, vector 1, first of a batch: H_dot", 12, H_dot_batch, H_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_rate_matrix_dot, vector 1, last: H_dot", 12, H_dot_batch + 120, H_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rodrigues_rate_matrix_dot_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double omega[3] = {-1.5, 0.25, 1.75};
    const double H_dot_expected[12] = {
        -0.32607000661305989633,
        0.047051287235534412366,
        -0.28621018955912768433,
        -0.047051287235534412366,
        -0.32607000661305989633,
        -0.38142594897223040169,
        0.28621018955912768433,
        0.38142594897223040169,
        -0.32607000661305989633,
        0.38142594897223040169,
        -0.28621018955912768433,
        -0.047051287235534412366,
    };
    double H_dot[12], H_dot_batch[132];
    chasles_euler_rodrigues_rate_matrix_dot(e, phi[0], omega, H_dot);
    chasles_euler_rodrigues_rate_matrix_dot_batch(11, e, 0, phi, 0, omega, 0, H_dot_batch, 12);
    compare("chasles_euler_rodrigues_rate_matrix_dot, vector 2: H_dot", 12, H_dot, H_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_rate_matrix_dot, vector 2, first of a batch: H_dot", 12, H_dot_batch, H_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_rate_matrix_dot, vector 2, last: H_dot", 12, H_dot_batch + 120, H_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rodrigues_rate_matrix_dot_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float omega[3] = {0.5f, -0.75f, 2.0f};
    const double H_dot_expected[12] = {
        -0.1462743182351155387,
        0.490808245389759682,
        0.10329747882885651043,
        -0.490808245389759682,
        -0.1462743182351155387,
        -0.16679919349289291651,
        -0.10329747882885651043,
        0.16679919349289291651,
        -0.1462743182351155387,
        0.16679919349289291651,
        0.10329747882885651043,
        -0.490808245389759682,
    };
    float H_dot[12], H_dot_batch[132];
    chasles_euler_rodrigues_rate_matrix_dotf(e, phi[0], omega, H_dot);
    chasles_euler_rodrigues_rate_matrix_dot_batchf(11, e, 0, phi, 0, omega, 0, H_dot_batch, 12);
    comparef("chasles_euler_rodrigues_rate_matrix_dotf, vector 1: H_dot", 12, H_dot, H_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_rate_matrix_dotf, vector 1, first of a batch: H_dot", 12, H_dot_batch, H_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_rate_matrix_dotf, vector 1, last: H_dot", 12, H_dot_batch + 120, H_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rodrigues_rate_matrix_dot_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float omega[3] = {-1.5f, 0.25f, 1.75f};
    const double H_dot_expected[12] = {
        -0.32607000661305989633,
        0.047051287235534412366,
        -0.28621018955912768433,
        -0.047051287235534412366,
        -0.32607000661305989633,
        -0.38142594897223040169,
        0.28621018955912768433,
        0.38142594897223040169,
        -0.32607000661305989633,
        0.38142594897223040169,
        -0.28621018955912768433,
        -0.047051287235534412366,
    };
    float H_dot[12], H_dot_batch[132];
    chasles_euler_rodrigues_rate_matrix_dotf(e, phi[0], omega, H_dot);
    chasles_euler_rodrigues_rate_matrix_dot_batchf(11, e, 0, phi, 0, omega, 0, H_dot_batch, 12);
    comparef("chasles_euler_rodrigues_rate_matrix_dotf, vector 2: H_dot", 12, H_dot, H_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_rate_matrix_dotf, vector 2, first of a batch: H_dot", 12, H_dot_batch, H_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_rate_matrix_dotf, vector 2, last: H_dot", 12, H_dot_batch + 120, H_dot_expected, 8.0 * FLT_EPSILON);
}

static void natural_velocity_matrix_dot_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double omega[3] = {0.5, -0.75, 2.0};
    const double N_tilde_dot_expected[12] = {
        0.31532236239526866545,
        -1.4650104701088282584,
        0.074571913794305796828,
        -0.80116406037500320371,
        1.4650104701088282584,
        0.31532236239526866545,
        0.23221090973950946736,
        -0.81510548681247276845,
        -0.074571913794305796828,
        -0.23221090973950946736,
        0.31532236239526866545,
        1.2156875169999743703,
    };
    double N_tilde_dot[12], N_tilde_dot_batch[132];
    chasles_natural_velocity_matrix_dot(e, phi[0], omega, N_tilde_dot);
    chasles_natural_velocity_matrix_dot_batch(11, e, 0, phi, 0, omega, 0, N_tilde_dot_batch, 12);
    compare("chasles_natural_velocity_matrix_dot, vector 1: N_tilde_dot", 12, N_tilde_dot, N_tilde_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_velocity_matrix_dot, vector 1, first of a batch: N_tilde_dot", 12, N_tilde_dot_batch, N_tilde_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_velocity_matrix_dot, vector 1, last: N_tilde_dot", 12, N_tilde_dot_batch + 120, N_tilde_dot_expected, 8.0 * DBL_EPSILON);
}

static void natural_velocity_matrix_dot_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double omega[3] = {-1.5, 0.25, 1.75};
    const double N_tilde_dot_expected[12] = {
        -0.64502759664807069985,
        -0.72213357665818006047,
        1.3861735837554376325,
        -0.90656946195074802725,
        0.72213357665818006047,
        -0.64502759664807069985,
        1.283835475651796786,
        0.38168851058232756098,
        -1.3861735837554376325,
        -1.283835475651796786,
        -0.64502759664807069985,
        -0.28626638293674567073,
    };
    double N_tilde_dot[12], N_tilde_dot_batch[132];
    chasles_natural_velocity_matrix_dot(e, phi[0], omega, N_tilde_dot);
    chasles_natural_velocity_matrix_dot_batch(11, e, 0, phi, 0, omega, 0, N_tilde_dot_batch, 12);
    compare("chasles_natural_velocity_matrix_dot, vector 2: N_tilde_dot", 12, N_tilde_dot, N_tilde_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_velocity_matrix_dot, vector 2, first of a batch: N_tilde_dot", 12, N_tilde_dot_batch, N_tilde_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_velocity_matrix_dot, vector 2, last: N_tilde_dot", 12, N_tilde_dot_batch + 120, N_tilde_dot_expected, 8.0 * DBL_EPSILON);
}

static void natural_velocity_matrix_dot_vector_3(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {0.0};
    const double omega[3] = {0.0, 0.0, 0.0};
    const double N_tilde_dot_expected[12] = {
        0.0,
        0.0,
        0.0,
        NAN,
        0.0,
        0.0,
        0.0,
        NAN,
        0.0,
        0.0,
        0.0,
        NAN,
    };
    double N_tilde_dot[12], N_tilde_dot_batch[132];
    chasles_natural_velocity_matrix_dot(e, phi[0], omega, N_tilde_dot);
    chasles_natural_velocity_matrix_dot_batch(11, e, 0, phi, 0, omega, 0, N_tilde_dot_batch, 12);
    compare("chasles_natural_velocity_matrix_dot, vector 3: N_tilde_dot", 12, N_tilde_dot, N_tilde_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_velocity_matrix_dot, vector 3, first of a batch: N_tilde_dot", 12, N_tilde_dot_batch, N_tilde_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_natural_velocity_matrix_dot, vector 3, last: N_tilde_dot", 12, N_tilde_dot_batch + 120, N_tilde_dot_expected, 8.0 * DBL_EPSILON);
}

static void natural_velocity_matrix_dot_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float omega[3] = {0.5f, -0.75f, 2.0f};
    const double N_tilde_dot_expected[12] = {
        0.31532236239526866545,
        -1.4650104701088282584,
        0.074571913794305796828,
        -0.80116406037500320371,
        1.4650104701088282584,
        0.31532236239526866545,
        0.23221090973950946736,
        -0.81510548681247276845,
        -0.074571913794305796828,
        -0.23221090973950946736,
        0.31532236239526866545,
        1.2156875169999743703,
    };
    float N_tilde_dot[12], N_tilde_dot_batch[132];
    chasles_natural_velocity_matrix_dotf(e, phi[0], omega, N_tilde_dot);
    chasles_natural_velocity_matrix_dot_batchf(11, e, 0, phi, 0, omega, 0, N_tilde_dot_batch, 12);
    comparef("chasles_natural_velocity_matrix_dotf, vector 1: N_tilde_dot", 12, N_tilde_dot, N_tilde_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_velocity_matrix_dotf, vector 1, first of a batch: N_tilde_dot", 12, N_tilde_dot_batch, N_tilde_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_velocity_matrix_dotf, vector 1, last: N_tilde_dot", 12, N_tilde_dot_batch + 120, N_tilde_dot_expected, 8.0 * FLT_EPSILON);
}

static void natural_velocity_matrix_dot_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float omega[3] = {-1.5f, 0.25f, 1.75f};
    const double N_tilde_dot_expected[12] = {
        -0.64502759664807069985,
        -0.72213357665818006047,
        1.3861735837554376325,
        -0.90656946195074802725,
        0.72213357665818006047,
        -0.64502759664807069985,
        1.283835475651796786,
        0.38168851058232756098,
        -1.3861735837554376325,
        -1.283835475651796786,
        -0.64502759664807069985,
        -0.28626638293674567073,
    };
    float N_tilde_dot[12], N_tilde_dot_batch[132];
    chasles_natural_velocity_matrix_dotf(e, phi[0], omega, N_tilde_dot);
    chasles_natural_velocity_matrix_dot_batchf(11, e, 0, phi, 0, omega, 0, N_tilde_dot_batch, 12);
    comparef("chasles_natural_velocity_matrix_dotf, vector 2: N_tilde_dot", 12, N_tilde_dot, N_tilde_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_velocity_matrix_dotf, vector 2, first of a batch: N_tilde_dot", 12, N_tilde_dot_batch, N_tilde_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_velocity_matrix_dotf, vector 2, last: N_tilde_dot", 12, N_tilde_dot_batch + 120, N_tilde_dot_expected, 8.0 * FLT_EPSILON);
}

static void natural_velocity_matrix_dot_vector_3f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {0.0f};
    const float omega[3] = {0.0f, 0.0f, 0.0f};
    const double N_tilde_dot_expected[12] = {
        0.0,
        0.0,
        0.0,
        NAN,
        0.0,
        0.0,
        0.0,
        NAN,
        0.0,
        0.0,
        0.0,
        NAN,
    };
    float N_tilde_dot[12], N_tilde_dot_batch[132];
    chasles_natural_velocity_matrix_dotf(e, phi[0], omega, N_tilde_dot);
    chasles_natural_velocity_matrix_dot_batchf(11, e, 0, phi, 0, omega, 0, N_tilde_dot_batch, 12);
    comparef("chasles_natural_velocity_matrix_dotf, vector 3: N_tilde_dot", 12, N_tilde_dot, N_tilde_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_velocity_matrix_dotf, vector 3, first of a batch: N_tilde_dot", 12, N_tilde_dot_batch, N_tilde_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_natural_velocity_matrix_dotf, vector 3, last: N_tilde_dot", 12, N_tilde_dot_batch + 120, N_tilde_dot_expected, 8.0 * FLT_EPSILON);
}

static void linear_velocity_matrix_dot_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double omega[3] = {0.5, -0.75, 2.0};
    const double L_tilde_dot_expected[12] = {
        0.0,
        -1.3839462281529997365,
        -0.081239326970863315975,
        0.32460410447633607798,
        1.3839462281529997365,
        0.0,
        0.32460410447633607798,
        0.081239326970863315975,
        0.081239326970863315975,
        -0.32460410447633607798,
        0.0,
        -1.3839462281529997365,
    };
    double L_tilde_dot[12], L_tilde_dot_batch[132];
    chasles_linear_velocity_matrix_dot(e, phi[0], omega, L_tilde_dot);
    chasles_linear_velocity_matrix_dot_batch(11, e, 0, phi, 0, omega, 0, L_tilde_dot_batch, 12);
    compare("chasles_linear_velocity_matrix_dot, vector 1: L_tilde_dot", 12, L_tilde_dot, L_tilde_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_velocity_matrix_dot, vector 1, first of a batch: L_tilde_dot", 12, L_tilde_dot_batch, L_tilde_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_velocity_matrix_dot, vector 1, last: L_tilde_dot", 12, L_tilde_dot_batch + 120, L_tilde_dot_expected, 8.0 * DBL_EPSILON);
}

static void linear_velocity_matrix_dot_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double omega[3] = {-1.5, 0.25, 1.75};
    const double L_tilde_dot_expected[12] = {
        0.0,
        -1.6779881928104450481,
        2.1873108864718046271,
        1.411898282978333448,
        1.6779881928104450481,
        0.0,
        1.411898282978333448,
        -2.1873108864718046271,
        -2.1873108864718046271,
        -1.411898282978333448,
        0.0,
        -1.6779881928104450481,
    };
    double L_tilde_dot[12], L_tilde_dot_batch[132];
    chasles_linear_velocity_matrix_dot(e, phi[0], omega, L_tilde_dot);
    chasles_linear_velocity_matrix_dot_batch(11, e, 0, phi, 0, omega, 0, L_tilde_dot_batch, 12);
    compare("chasles_linear_velocity_matrix_dot, vector 2: L_tilde_dot", 12, L_tilde_dot, L_tilde_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_velocity_matrix_dot, vector 2, first of a batch: L_tilde_dot", 12, L_tilde_dot_batch, L_tilde_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_linear_velocity_matrix_dot, vector 2, last: L_tilde_dot", 12, L_tilde_dot_batch + 120, L_tilde_dot_expected, 8.0 * DBL_EPSILON);
}

static void linear_velocity_matrix_dot_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float omega[3] = {0.5f, -0.75f, 2.0f};
    const double L_tilde_dot_expected[12] = {
        0.0,
        -1.3839462281529997365,
        -0.081239326970863315975,
        0.32460410447633607798,
        1.3839462281529997365,
        0.0,
        0.32460410447633607798,
        0.081239326970863315975,
        0.081239326970863315975,
        -0.32460410447633607798,
        0.0,
        -1.3839462281529997365,
    };
    float L_tilde_dot[12], L_tilde_dot_batch[132];
    chasles_linear_velocity_matrix_dotf(e, phi[0], omega, L_tilde_dot);
    chasles_linear_velocity_matrix_dot_batchf(11, e, 0, phi, 0, omega, 0, L_tilde_dot_batch, 12);
    comparef("chasles_linear_velocity_matrix_dotf, vector 1: L_tilde_dot", 12, L_tilde_dot, L_tilde_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_velocity_matrix_dotf, vector 1, first of a batch: L_tilde_dot", 12, L_tilde_dot_batch, L_tilde_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_velocity_matrix_dotf, vector 1, last: L_tilde_dot", 12, L_tilde_dot_batch + 120, L_tilde_dot_expected, 8.0 * FLT_EPSILON);
}

static void linear_velocity_matrix_dot_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float omega[3] = {-1.5f, 0.25f, 1.75f};
    const double L_tilde_dot_expected[12] = {
        0.0,
        -1.6779881928104450481,
        2.1873108864718046271,
        1.411898282978333448,
        1.6779881928104450481,
        0.0,
        1.411898282978333448,
        -2.1873108864718046271,
        -2.1873108864718046271,
        -1.411898282978333448,
        0.0,
        -1.6779881928104450481,
    };
    float L_tilde_dot[12], L_tilde_dot_batch[132];
    chasles_linear_velocity_matrix_dotf(e, phi[0], omega, L_tilde_dot);
    chasles_linear_velocity_matrix_dot_batchf(11, e, 0, phi, 0, omega, 0, L_tilde_dot_batch, 12);
    comparef("chasles_linear_velocity_matrix_dotf, vector 2: L_tilde_dot", 12, L_tilde_dot, L_tilde_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_velocity_matrix_dotf, vector 2, first of a batch: L_tilde_dot", 12, L_tilde_dot_batch, L_tilde_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_linear_velocity_matrix_dotf, vector 2, last: L_tilde_dot", 12, L_tilde_dot_batch + 120, L_tilde_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rodrigues_velocity_matrix_dot_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double omega[3] = {0.5, -0.75, 2.0};
    const double H_tilde_dot_expected[12] = {
        -0.58509727294046215481,
        -1.963232981559038728,
        -0.41318991531542604171,
        0.66719677397157166605,
        1.963232981559038728,
        -0.58509727294046215481,
        0.66719677397157166605,
        0.41318991531542604171,
        0.41318991531542604171,
        -0.66719677397157166605,
        -0.58509727294046215481,
        -1.963232981559038728,
    };
    double H_tilde_dot[12], H_tilde_dot_batch[132];
    chasles_euler_rodrigues_velocity_matrix_dot(e, phi[0], omega, H_tilde_dot);
    chasles_euler_rodrigues_velocity_matrix_dot_batch(
        11,
        e, 0,
        phi, 0,
        omega, 0,
        H_tilde_dot_batch, 12);
    compare("chasles_euler_rodrigues_velocity_matrix_dot, vector 1: H_tilde_dot", 12, H_tilde_dot, H_tilde_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_velocity_matrix_dot, vector 1, first of a batch: H_tilde_dot", 12, H_tilde_dot_batch, H_tilde_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_velocity_matrix_dot, vector 1, last: H_tilde_dot", 12, H_tilde_dot_batch + 120, H_tilde_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rodrigues_velocity_matrix_dot_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double omega[3] = {-1.5, 0.25, 1.75};
    const double H_tilde_dot_expected[12] = {
        -1.3042800264522395853,
        -0.18820514894213764946,
        1.1448407582365107373,
        1.5257037958889216068,
        0.18820514894213764946,
        -1.3042800264522395853,
        1.5257037958889216068,
        -1.1448407582365107373,
        -1.1448407582365107373,
        -1.5257037958889216068,
        -1.3042800264522395853,
        -0.18820514894213764946,
    };
    double H_tilde_dot[12], H_tilde_dot_batch[132];
    chasles_euler_rodrigues_velocity_matrix_dot(e, phi[0], omega, H_tilde_dot);
    chasles_euler_rodrigues_velocity_matrix_dot_batch(
        11,
        e, 0,
        phi, 0,
        omega, 0,
        H_tilde_dot_batch, 12);
    compare("chasles_euler_rodrigues_velocity_matrix_dot, vector 2: H_tilde_dot", 12, H_tilde_dot, H_tilde_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_velocity_matrix_dot, vector 2, first of a batch: H_tilde_dot", 12, H_tilde_dot_batch, H_tilde_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rodrigues_velocity_matrix_dot, vector 2, last: H_tilde_dot", 12, H_tilde_dot_batch + 120, H_tilde_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rodrigues_velocity_matrix_dot_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float omega[3] = {0.5f, -0.75f, 2.0f};
    const double H_tilde_dot_expected[12] = {
        -0.58509727294046215481,
        -1.963232981559038728,
        -0.41318991531542604171,
        0.66719677397157166605,
        1.963232981559038728,
        -0.58509727294046215481,
        0.66719677397157166605,
        0.41318991531542604171,
        0.41318991531542604171,
        -0.66719677397157166605,
        -0.58509727294046215481,
        -1.963232981559038728,
    };
    float H_tilde_dot[12], H_tilde_dot_batch[132];
    chasles_euler_rodrigues_velocity_matrix_dotf(e, phi[0], omega, H_tilde_dot);
    chasles_euler_rodrigues_velocity_matrix_dot_batchf(
        11,
        e, 0,
        phi, 0,
        omega, 0,
        H_tilde_dot_batch, 12);
    comparef("chasles_euler_rodrigues_velocity_matrix_dotf, vector 1: H_tilde_dot", 12, H_tilde_dot, H_tilde_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_velocity_matrix_dotf, vector 1, first of a batch: H_tilde_dot", 12, H_tilde_dot_batch, H_tilde_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_velocity_matrix_dotf, vector 1, last: H_tilde_dot", 12, H_tilde_dot_batch + 120, H_tilde_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rodrigues_velocity_matrix_dot_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float omega[3] = {-1.5f, 0.25f, 1.75f};
    const double H_tilde_dot_expected[12] = {
        -1.3042800264522395853,
        -0.18820514894213764946,
        1.1448407582365107373,
        1.5257037958889216068,
        0.18820514894213764946,
        -1.3042800264522395853,
        1.5257037958889216068,
        -1.1448407582365107373,
        -1.1448407582365107373,
        -1.5257037958889216068,
        -1.3042800264522395853,
        -0.18820514894213764946,
    };
    float H_tilde_dot[12], H_tilde_dot_batch[132];
    chasles_euler_rodrigues_velocity_matrix_dotf(e, phi[0], omega, H_tilde_dot);
    chasles_euler_rodrigues_velocity_matrix_dot_batchf(
        11,
        e, 0,
        phi, 0,
        omega, 0,
        H_tilde_dot_batch, 12);
    comparef("chasles_euler_rodrigues_velocity_matrix_dotf, vector 2: H_tilde_dot", 12, H_tilde_dot, H_tilde_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_velocity_matrix_dotf, vector 2, first of a batch: H_tilde_dot", 12, H_tilde_dot_batch, H_tilde_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rodrigues_velocity_matrix_dotf, vector 2, last: H_tilde_dot", 12, H_tilde_dot_batch + 120, H_tilde_dot_expected, 8.0 * FLT_EPSILON);
}

static void pose_acceleration_natural_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double t[6] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75};
    const double t_dot[6] = {-0.5, 0.75, -1.25, 1.5, 1.25, 0.5};
    const double s_ddot_expected[7] = {
        0.61804758348365931567,
        -0.01724265838909408017,
        -4.4680165512396200332,
        2.1421221189218017151,
        1.5,
        1.25,
        0.5,
    };
    double s_ddot[7], s_ddot_batch[77];
    chasles_pose_acceleration_natural(e, phi[0], t, t_dot, s_ddot);
    chasles_pose_acceleration_natural_batch(11, e, 0, phi, 0, t, 0, t_dot, 0, s_ddot_batch, 7);
    compare("chasles_pose_acceleration_natural, vector 1: s_ddot", 7, s_ddot, s_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_acceleration_natural, vector 1, first of a batch: s_ddot", 7, s_ddot_batch, s_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_acceleration_natural, vector 1, last: s_ddot", 7, s_ddot_batch + 70, s_ddot_expected, 8.0 * DBL_EPSILON);
}

static void pose_acceleration_natural_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double t[6] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25};
    const double t_dot[6] = {1.5, 1.25, 0.5, -0.75, 2.0, -1.5};
    const double s_ddot_expected[7] = {
        1.7338268758434564786,
        -1.4297887478689565379,
        -0.23953687716317242977,
        2.1043101504323990073,
        -0.75,
        2.0,
        -1.5,
    };
    double s_ddot[7], s_ddot_batch[77];
    chasles_pose_acceleration_natural(e, phi[0], t, t_dot, s_ddot);
    chasles_pose_acceleration_natural_batch(11, e, 0, phi, 0, t, 0, t_dot, 0, s_ddot_batch, 7);
    compare("chasles_pose_acceleration_natural, vector 2: s_ddot", 7, s_ddot, s_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_acceleration_natural, vector 2, first of a batch: s_ddot", 7, s_ddot_batch, s_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_acceleration_natural, vector 2, last: s_ddot", 7, s_ddot_batch + 70, s_ddot_expected, 8.0 * DBL_EPSILON);
}

static void pose_acceleration_natural_vector_3(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {0.0};
    const double t[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const double t_dot[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const double s_ddot_expected[7] = {NAN, NAN, NAN, NAN, 0.0, 0.0, 0.0};
    double s_ddot[7], s_ddot_batch[77];
    chasles_pose_acceleration_natural(e, phi[0], t, t_dot, s_ddot);
    chasles_pose_acceleration_natural_batch(11, e, 0, phi, 0, t, 0, t_dot, 0, s_ddot_batch, 7);
    compare("chasles_pose_acceleration_natural, vector 3: s_ddot", 7, s_ddot, s_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_acceleration_natural, vector 3, first of a batch: s_ddot", 7, s_ddot_batch, s_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_acceleration_natural, vector 3, last: s_ddot", 7, s_ddot_batch + 70, s_ddot_expected, 8.0 * DBL_EPSILON);
}

static void pose_acceleration_natural_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float t[6] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f};
    const float t_dot[6] = {-0.5f, 0.75f, -1.25f, 1.5f, 1.25f, 0.5f};
    const double s_ddot_expected[7] = {
        0.61804758348365931567,
        -0.01724265838909408017,
        -4.4680165512396200332,
        2.1421221189218017151,
        1.5,
        1.25,
        0.5,
    };
    float s_ddot[7], s_ddot_batch[77];
    chasles_pose_acceleration_naturalf(e, phi[0], t, t_dot, s_ddot);
    chasles_pose_acceleration_natural_batchf(11, e, 0, phi, 0, t, 0, t_dot, 0, s_ddot_batch, 7);
    comparef("chasles_pose_acceleration_naturalf, vector 1: s_ddot", 7, s_ddot, s_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_acceleration_naturalf, vector 1, first of a batch: s_ddot", 7, s_ddot_batch, s_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_acceleration_naturalf, vector 1, last: s_ddot", 7, s_ddot_batch + 70, s_ddot_expected, 8.0 * FLT_EPSILON);
}

static void pose_acceleration_natural_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float t[6] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f};
    const float t_dot[6] = {1.5f, 1.25f, 0.5f, -0.75f, 2.0f, -1.5f};
    const double s_ddot_expected[7] = {
        1.7338268758434564786,
        -1.4297887478689565379,
        -0.23953687716317242977,
        2.1043101504323990073,
        -0.75,
        2.0,
        -1.5,
    };
    float s_ddot[7], s_ddot_batch[77];
    chasles_pose_acceleration_naturalf(e, phi[0], t, t_dot, s_ddot);
    chasles_pose_acceleration_natural_batchf(11, e, 0, phi, 0, t, 0, t_dot, 0, s_ddot_batch, 7);
    comparef("chasles_pose_acceleration_naturalf, vector 2: s_ddot", 7, s_ddot, s_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_acceleration_naturalf, vector 2, first of a batch: s_ddot", 7, s_ddot_batch, s_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_acceleration_naturalf, vector 2, last: s_ddot", 7, s_ddot_batch + 70, s_ddot_expected, 8.0 * FLT_EPSILON);
}

static void pose_acceleration_natural_vector_3f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {0.0f};
    const float t[6] = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
    const float t_dot[6] = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
    const double s_ddot_expected[7] = {NAN, NAN, NAN, NAN, 0.0, 0.0, 0.0};
    float s_ddot[7], s_ddot_batch[77];
    chasles_pose_acceleration_naturalf(e, phi[0], t, t_dot, s_ddot);
    chasles_pose_acceleration_natural_batchf(11, e, 0, phi, 0, t, 0, t_dot, 0, s_ddot_batch, 7);
    comparef("chasles_pose_acceleration_naturalf, vector 3: s_ddot", 7, s_ddot, s_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_acceleration_naturalf, vector 3, first of a batch: s_ddot", 7, s_ddot_batch, s_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_acceleration_naturalf, vector 3, last: s_ddot", 7, s_ddot_batch + 70, s_ddot_expected, 8.0 * FLT_EPSILON);
}

static void pose_acceleration_linear_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double t[6] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75};
    const double t_dot[6] = {-0.5, 0.75, -1.25, 1.5, 1.25, 0.5};
    const double s_ddot_expected[7] = {
        -0.0099074417040513519229,
        -0.71275540119949839786,
        -3.6557624747481860784,
        -2.3481633060334564518,
        1.5,
        1.25,
        0.5,
    };
    double s_ddot[7], s_ddot_batch[77];
    chasles_pose_acceleration_linear(e, phi[0], t, t_dot, s_ddot);
    chasles_pose_acceleration_linear_batch(11, e, 0, phi, 0, t, 0, t_dot, 0, s_ddot_batch, 7);
    compare("chasles_pose_acceleration_linear, vector 1: s_ddot", 7, s_ddot, s_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_acceleration_linear, vector 1, first of a batch: s_ddot", 7, s_ddot_batch, s_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_acceleration_linear, vector 1, last: s_ddot", 7, s_ddot_batch + 70, s_ddot_expected, 8.0 * DBL_EPSILON);
}

static void pose_acceleration_linear_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double t[6] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25};
    const double t_dot[6] = {1.5, 1.25, 0.5, -0.75, 2.0, -1.5};
    const double s_ddot_expected[7] = {
        2.7460889592389168215,
        -3.6286759227388671148,
        -2.2967420961928289614,
        -0.91365103022683399227,
        -0.75,
        2.0,
        -1.5,
    };
    double s_ddot[7], s_ddot_batch[77];
    chasles_pose_acceleration_linear(e, phi[0], t, t_dot, s_ddot);
    chasles_pose_acceleration_linear_batch(11, e, 0, phi, 0, t, 0, t_dot, 0, s_ddot_batch, 7);
    compare("chasles_pose_acceleration_linear, vector 2: s_ddot", 7, s_ddot, s_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_acceleration_linear, vector 2, first of a batch: s_ddot", 7, s_ddot_batch, s_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_acceleration_linear, vector 2, last: s_ddot", 7, s_ddot_batch + 70, s_ddot_expected, 8.0 * DBL_EPSILON);
}

static void pose_acceleration_linear_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float t[6] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f};
    const float t_dot[6] = {-0.5f, 0.75f, -1.25f, 1.5f, 1.25f, 0.5f};
    const double s_ddot_expected[7] = {
        -0.0099074417040513519229,
        -0.71275540119949839786,
        -3.6557624747481860784,
        -2.3481633060334564518,
        1.5,
        1.25,
        0.5,
    };
    float s_ddot[7], s_ddot_batch[77];
    chasles_pose_acceleration_linearf(e, phi[0], t, t_dot, s_ddot);
    chasles_pose_acceleration_linear_batchf(11, e, 0, phi, 0, t, 0, t_dot, 0, s_ddot_batch, 7);
    comparef("chasles_pose_acceleration_linearf, vector 1: s_ddot", 7, s_ddot, s_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_acceleration_linearf, vector 1, first of a batch: s_ddot", 7, s_ddot_batch, s_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_acceleration_linearf, vector 1, last: s_ddot", 7, s_ddot_batch + 70, s_ddot_expected, 8.0 * FLT_EPSILON);
}

static void pose_acceleration_linear_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float t[6] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f};
    const float t_dot[6] = {1.5f, 1.25f, 0.5f, -0.75f, 2.0f, -1.5f};
    const double s_ddot_expected[7] = {
        2.7460889592389168215,
        -3.6286759227388671148,
        -2.2967420961928289614,
        -0.91365103022683399227,
        -0.75,
        2.0,
        -1.5,
    };
    float s_ddot[7], s_ddot_batch[77];
    chasles_pose_acceleration_linearf(e, phi[0], t, t_dot, s_ddot);
    chasles_pose_acceleration_linear_batchf(11, e, 0, phi, 0, t, 0, t_dot, 0, s_ddot_batch, 7);
    comparef("chasles_pose_acceleration_linearf, vector 2: s_ddot", 7, s_ddot, s_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_acceleration_linearf, vector 2, first of a batch: s_ddot", 7, s_ddot_batch, s_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_acceleration_linearf, vector 2, last: s_ddot", 7, s_ddot_batch + 70, s_ddot_expected, 8.0 * FLT_EPSILON);
}

static void pose_acceleration_euler_rodrigues_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double t[6] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75};
    const double t_dot[6] = {-0.5, 0.75, -1.25, 1.5, 1.25, 0.5};
    const double s_ddot_expected[7] = {
        -0.047324316751494215677,
        -0.1895646542290582298,
        -1.1468020919693916707,
        -0.82941568491959974987,
        1.5,
        1.25,
        0.5,
    };
    double s_ddot[7], s_ddot_batch[77];
    chasles_pose_acceleration_euler_rodrigues(e, phi[0], t, t_dot, s_ddot);
    chasles_pose_acceleration_euler_rodrigues_batch(11, e, 0, phi, 0, t, 0, t_dot, 0, s_ddot_batch, 7);
    compare("chasles_pose_acceleration_euler_rodrigues, vector 1: s_ddot", 7, s_ddot, s_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_acceleration_euler_rodrigues, vector 1, first of a batch: s_ddot", 7, s_ddot_batch, s_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_acceleration_euler_rodrigues, vector 1, last: s_ddot", 7, s_ddot_batch + 70, s_ddot_expected, 8.0 * DBL_EPSILON);
}

static void pose_acceleration_euler_rodrigues_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double t[6] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25};
    const double t_dot[6] = {1.5, 1.25, 0.5, -0.75, 2.0, -1.5};
    const double s_ddot_expected[7] = {
        0.69974157408386856538,
        -0.8456296312185171391,
        -0.39084378903790038731,
        -1.2098770397748532366,
        -0.75,
        2.0,
        -1.5,
    };
    double s_ddot[7], s_ddot_batch[77];
    chasles_pose_acceleration_euler_rodrigues(e, phi[0], t, t_dot, s_ddot);
    chasles_pose_acceleration_euler_rodrigues_batch(11, e, 0, phi, 0, t, 0, t_dot, 0, s_ddot_batch, 7);
    compare("chasles_pose_acceleration_euler_rodrigues, vector 2: s_ddot", 7, s_ddot, s_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_acceleration_euler_rodrigues, vector 2, first of a batch: s_ddot", 7, s_ddot_batch, s_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_pose_acceleration_euler_rodrigues, vector 2, last: s_ddot", 7, s_ddot_batch + 70, s_ddot_expected, 8.0 * DBL_EPSILON);
}

static void pose_acceleration_euler_rodrigues_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float t[6] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f};
    const float t_dot[6] = {-0.5f, 0.75f, -1.25f, 1.5f, 1.25f, 0.5f};
    const double s_ddot_expected[7] = {
        -0.047324316751494215677,
        -0.1895646542290582298,
        -1.1468020919693916707,
        -0.82941568491959974987,
        1.5,
        1.25,
        0.5,
    };
    float s_ddot[7], s_ddot_batch[77];
    chasles_pose_acceleration_euler_rodriguesf(e, phi[0], t, t_dot, s_ddot);
    chasles_pose_acceleration_euler_rodrigues_batchf(11, e, 0, phi, 0, t, 0, t_dot, 0, s_ddot_batch, 7);
    comparef("chasles_pose_acceleration_euler_rodriguesf, vector 1: s_ddot", 7, s_ddot, s_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_acceleration_euler_rodriguesf, vector 1, first of a batch: s_ddot", 7, s_ddot_batch, s_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_acceleration_euler_rodriguesf, vector 1, last: s_ddot", 7, s_ddot_batch + 70, s_ddot_expected, 8.0 * FLT_EPSILON);
}

static void pose_acceleration_euler_rodrigues_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float t[6] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f};
    const float t_dot[6] = {1.5f, 1.25f, 0.5f, -0.75f, 2.0f, -1.5f};
    const double s_ddot_expected[7] = {
        0.69974157408386856538,
        -0.8456296312185171391,
        -0.39084378903790038731,
        -1.2098770397748532366,
        -0.75,
        2.0,
        -1.5,
    };
    float s_ddot[7], s_ddot_batch[77];
    chasles_pose_acceleration_euler_rodriguesf(e, phi[0], t, t_dot, s_ddot);
    chasles_pose_acceleration_euler_rodrigues_batchf(11, e, 0, phi, 0, t, 0, t_dot, 0, s_ddot_batch, 7);
    comparef("chasles_pose_acceleration_euler_rodriguesf, vector 2: s_ddot", 7, s_ddot, s_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_acceleration_euler_rodriguesf, vector 2, first of a batch: s_ddot", 7, s_ddot_batch, s_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_pose_acceleration_euler_rodriguesf, vector 2, last: s_ddot", 7, s_ddot_batch + 70, s_ddot_expected, 8.0 * FLT_EPSILON);
}

static void twist_rate_from_pose_natural_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double s_dot[7] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75, -0.5};
    const double s_ddot[7] = {0.75, -1.25, 1.5, 1.25, 0.5, -0.75, 2.0};
    const double t_dot_expected[6] = {
        -1.2125520082322831478,
        1.6013325265113209212,
        -1.4864164506872924606,
        0.5,
        -0.75,
        2.0,
    };
    double t_dot[6], t_dot_batch[66];
    chasles_twist_rate_from_pose_natural(e, phi[0], s_dot, s_ddot, t_dot);
    chasles_twist_rate_from_pose_natural_batch(11, e, 0, phi, 0, s_dot, 0, s_ddot, 0, t_dot_batch, 6);
    compare("chasles_twist_rate_from_pose_natural, vector 1: t_dot", 6, t_dot, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_rate_from_pose_natural, vector 1, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_rate_from_pose_natural, vector 1, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * DBL_EPSILON);
}

static void twist_rate_from_pose_natural_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double s_dot[7] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25, 1.5};
    const double s_ddot[7] = {1.25, 0.5, -0.75, 2.0, -1.5, 0.25, 1.75};
    const double t_dot_expected[6] = {
        -0.015664561344240420494,
        3.5433923606237850503,
        -1.0641385576224252361,
        -1.5,
        0.25,
        1.75,
    };
    double t_dot[6], t_dot_batch[66];
    chasles_twist_rate_from_pose_natural(e, phi[0], s_dot, s_ddot, t_dot);
    chasles_twist_rate_from_pose_natural_batch(11, e, 0, phi, 0, s_dot, 0, s_ddot, 0, t_dot_batch, 6);
    compare("chasles_twist_rate_from_pose_natural, vector 2: t_dot", 6, t_dot, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_rate_from_pose_natural, vector 2, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_rate_from_pose_natural, vector 2, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * DBL_EPSILON);
}

static void twist_rate_from_pose_natural_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float s_dot[7] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f, -0.5f};
    const float s_ddot[7] = {0.75f, -1.25f, 1.5f, 1.25f, 0.5f, -0.75f, 2.0f};
    const double t_dot_expected[6] = {
        -1.2125520082322831478,
        1.6013325265113209212,
        -1.4864164506872924606,
        0.5,
        -0.75,
        2.0,
    };
    float t_dot[6], t_dot_batch[66];
    chasles_twist_rate_from_pose_naturalf(e, phi[0], s_dot, s_ddot, t_dot);
    chasles_twist_rate_from_pose_natural_batchf(11, e, 0, phi, 0, s_dot, 0, s_ddot, 0, t_dot_batch, 6);
    comparef("chasles_twist_rate_from_pose_naturalf, vector 1: t_dot", 6, t_dot, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_rate_from_pose_naturalf, vector 1, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_rate_from_pose_naturalf, vector 1, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * FLT_EPSILON);
}

static void twist_rate_from_pose_natural_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float s_dot[7] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f, 1.5f};
    const float s_ddot[7] = {1.25f, 0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f};
    const double t_dot_expected[6] = {
        -0.015664561344240420494,
        3.5433923606237850503,
        -1.0641385576224252361,
        -1.5,
        0.25,
        1.75,
    };
    float t_dot[6], t_dot_batch[66];
    chasles_twist_rate_from_pose_naturalf(e, phi[0], s_dot, s_ddot, t_dot);
    chasles_twist_rate_from_pose_natural_batchf(11, e, 0, phi, 0, s_dot, 0, s_ddot, 0, t_dot_batch, 6);
    comparef("chasles_twist_rate_from_pose_naturalf, vector 2: t_dot", 6, t_dot, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_rate_from_pose_naturalf, vector 2, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_rate_from_pose_naturalf, vector 2, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * FLT_EPSILON);
}

static void twist_rate_from_pose_linear_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double s_dot[7] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75, -0.5};
    const double s_ddot[7] = {0.75, -1.25, 1.5, 1.25, 0.5, -0.75, 2.0};
    const double t_dot_expected[6] = {
        4.262135544077629043,
        -2.1580177675712927531,
        2.8610387407137106217,
        0.5,
        -0.75,
        2.0,
    };
    double t_dot[6], t_dot_batch[66];
    chasles_twist_rate_from_pose_linear(e, phi[0], s_dot, s_ddot, t_dot);
    chasles_twist_rate_from_pose_linear_batch(11, e, 0, phi, 0, s_dot, 0, s_ddot, 0, t_dot_batch, 6);
    compare("chasles_twist_rate_from_pose_linear, vector 1: t_dot", 6, t_dot, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_rate_from_pose_linear, vector 1, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_rate_from_pose_linear, vector 1, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * DBL_EPSILON);
}

static void twist_rate_from_pose_linear_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double s_dot[7] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25, 1.5};
    const double s_ddot[7] = {1.25, 0.5, -0.75, 2.0, -1.5, 0.25, 1.75};
    const double t_dot_expected[6] = {
        -0.22469361085857432376,
        -0.79774574993978117783,
        -1.1773915902740737554,
        -1.5,
        0.25,
        1.75,
    };
    double t_dot[6], t_dot_batch[66];
    chasles_twist_rate_from_pose_linear(e, phi[0], s_dot, s_ddot, t_dot);
    chasles_twist_rate_from_pose_linear_batch(11, e, 0, phi, 0, s_dot, 0, s_ddot, 0, t_dot_batch, 6);
    compare("chasles_twist_rate_from_pose_linear, vector 2: t_dot", 6, t_dot, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_rate_from_pose_linear, vector 2, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_rate_from_pose_linear, vector 2, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * DBL_EPSILON);
}

static void twist_rate_from_pose_linear_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float s_dot[7] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f, -0.5f};
    const float s_ddot[7] = {0.75f, -1.25f, 1.5f, 1.25f, 0.5f, -0.75f, 2.0f};
    const double t_dot_expected[6] = {
        4.262135544077629043,
        -2.1580177675712927531,
        2.8610387407137106217,
        0.5,
        -0.75,
        2.0,
    };
    float t_dot[6], t_dot_batch[66];
    chasles_twist_rate_from_pose_linearf(e, phi[0], s_dot, s_ddot, t_dot);
    chasles_twist_rate_from_pose_linear_batchf(11, e, 0, phi, 0, s_dot, 0, s_ddot, 0, t_dot_batch, 6);
    comparef("chasles_twist_rate_from_pose_linearf, vector 1: t_dot", 6, t_dot, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_rate_from_pose_linearf, vector 1, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_rate_from_pose_linearf, vector 1, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * FLT_EPSILON);
}

static void twist_rate_from_pose_linear_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float s_dot[7] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f, 1.5f};
    const float s_ddot[7] = {1.25f, 0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f};
    const double t_dot_expected[6] = {
        -0.22469361085857432376,
        -0.79774574993978117783,
        -1.1773915902740737554,
        -1.5,
        0.25,
        1.75,
    };
    float t_dot[6], t_dot_batch[66];
    chasles_twist_rate_from_pose_linearf(e, phi[0], s_dot, s_ddot, t_dot);
    chasles_twist_rate_from_pose_linear_batchf(11, e, 0, phi, 0, s_dot, 0, s_ddot, 0, t_dot_batch, 6);
    comparef("chasles_twist_rate_from_pose_linearf, vector 2: t_dot", 6, t_dot, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_rate_from_pose_linearf, vector 2, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_rate_from_pose_linearf, vector 2, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * FLT_EPSILON);
}

static void twist_rate_from_pose_euler_rodrigues_vector_1(void)
{
    const double e[3] = {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const double phi[1] = {1.25};
    const double s_dot[7] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75, -0.5};
    const double s_ddot[7] = {0.75, -1.25, 1.5, 1.25, 0.5, -0.75, 2.0};
    const double t_dot_expected[6] = {
        2.8742202859224696252,
        -3.0025699203304816801,
        0.38504890322403616475,
        0.5,
        -0.75,
        2.0,
    };
    double t_dot[6], t_dot_batch[66];
    chasles_twist_rate_from_pose_euler_rodrigues(e, phi[0], s_dot, s_ddot, t_dot);
    chasles_twist_rate_from_pose_euler_rodrigues_batch(
        11,
        e, 0,
        phi, 0,
        s_dot, 0,
        s_ddot, 0,
        t_dot_batch, 6);
    compare("chasles_twist_rate_from_pose_euler_rodrigues, vector 1: t_dot", 6, t_dot, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_rate_from_pose_euler_rodrigues, vector 1, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_rate_from_pose_euler_rodrigues, vector 1, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * DBL_EPSILON);
}

static void twist_rate_from_pose_euler_rodrigues_vector_2(void)
{
    const double e[3] = {0.0, 0.6, 0.8};
    const double phi[1] = {2.0};
    const double s_dot[7] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25, 1.5};
    const double s_ddot[7] = {1.25, 0.5, -0.75, 2.0, -1.5, 0.25, 1.75};
    const double t_dot_expected[6] = {
        -0.079744909503074767807,
        0.20371391194498111474,
        -4.7653670873993231574,
        -1.5,
        0.25,
        1.75,
    };
    double t_dot[6], t_dot_batch[66];
    chasles_twist_rate_from_pose_euler_rodrigues(e, phi[0], s_dot, s_ddot, t_dot);
    chasles_twist_rate_from_pose_euler_rodrigues_batch(
        11,
        e, 0,
        phi, 0,
        s_dot, 0,
        s_ddot, 0,
        t_dot_batch, 6);
    compare("chasles_twist_rate_from_pose_euler_rodrigues, vector 2: t_dot", 6, t_dot, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_rate_from_pose_euler_rodrigues, vector 2, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_twist_rate_from_pose_euler_rodrigues, vector 2, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * DBL_EPSILON);
}

static void twist_rate_from_pose_euler_rodrigues_vector_1f(void)
{
    const float e[3] = {1.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f};
    const float phi[1] = {1.25f};
    const float s_dot[7] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f, -0.5f};
    const float s_ddot[7] = {0.75f, -1.25f, 1.5f, 1.25f, 0.5f, -0.75f, 2.0f};
    const double t_dot_expected[6] = {
        2.8742202859224696252,
        -3.0025699203304816801,
        0.38504890322403616475,
        0.5,
        -0.75,
        2.0,
    };
    float t_dot[6], t_dot_batch[66];
    chasles_twist_rate_from_pose_euler_rodriguesf(e, phi[0], s_dot, s_ddot, t_dot);
    chasles_twist_rate_from_pose_euler_rodrigues_batchf(
        11,
        e, 0,
        phi, 0,
        s_dot, 0,
        s_ddot, 0,
        t_dot_batch, 6);
    comparef("chasles_twist_rate_from_pose_euler_rodriguesf, vector 1: t_dot", 6, t_dot, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_rate_from_pose_euler_rodriguesf, vector 1, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_rate_from_pose_euler_rodriguesf, vector 1, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * FLT_EPSILON);
}

static void twist_rate_from_pose_euler_rodrigues_vector_2f(void)
{
    const float e[3] = {0.0f, 0.6f, 0.8f};
    const float phi[1] = {2.0f};
    const float s_dot[7] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f, 1.5f};
    const float s_ddot[7] = {1.25f, 0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f};
    const double t_dot_expected[6] = {
        -0.079744909503074767807,
        0.20371391194498111474,
        -4.7653670873993231574,
        -1.5,
        0.25,
        1.75,
    };
    float t_dot[6], t_dot_batch[66];
    chasles_twist_rate_from_pose_euler_rodriguesf(e, phi[0], s_dot, s_ddot, t_dot);
    chasles_twist_rate_from_pose_euler_rodrigues_batchf(
        11,
        e, 0,
        phi, 0,
        s_dot, 0,
        s_ddot, 0,
        t_dot_batch, 6);
    comparef("chasles_twist_rate_from_pose_euler_rodriguesf, vector 2: t_dot", 6, t_dot, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_rate_from_pose_euler_rodriguesf, vector 2, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_twist_rate_from_pose_euler_rodriguesf, vector 2, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * FLT_EPSILON);
}

static void moving_frame_velocity_vector_1(void)
{
    const double o_dot[3] = {1.25, 0.5, -0.75};
    const double Q[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double omega[3] = {2.0, -1.5, 0.25};
    const double rho[3] = {1.75, -0.5, 0.75};
    const double rho_dot[3] = {-1.25, 1.5, 1.25};
    const double p_dot_expected[3] = {-2.1, -0.7375, 4.875};
    double p_dot[3], p_dot_batch[33];
    chasles_moving_frame_velocity(o_dot, Q, omega, rho, rho_dot, p_dot);
    chasles_moving_frame_velocity_batch(
        11,
        o_dot, 0,
        Q, 0,
        omega, 0,
        rho, 0,
        rho_dot, 0,
        p_dot_batch, 3);
    compare("chasles_moving_frame_velocity, vector 1: p_dot", 3, p_dot, p_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_moving_frame_velocity, vector 1, first of a batch: p_dot", 3, p_dot_batch, p_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_moving_frame_velocity, vector 1, last: p_dot", 3, p_dot_batch + 30, p_dot_expected, 8.0 * DBL_EPSILON);
}

static void moving_frame_velocity_vector_2(void)
{
    const double o_dot[3] = {2.0, -1.5, 0.25};
    const double Q[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double omega[3] = {1.75, -0.5, 0.75};
    const double rho[3] = {-1.25, 1.5, 1.25};
    const double rho_dot[3] = {0.5, -0.75, 2.0};
    const double p_dot_expected[3] = {
        2.9791666666666666667,
        -6.6458333333333333333,
        0.22916666666666666667,
    };
    double p_dot[3], p_dot_batch[33];
    chasles_moving_frame_velocity(o_dot, Q, omega, rho, rho_dot, p_dot);
    chasles_moving_frame_velocity_batch(
        11,
        o_dot, 0,
        Q, 0,
        omega, 0,
        rho, 0,
        rho_dot, 0,
        p_dot_batch, 3);
    compare("chasles_moving_frame_velocity, vector 2: p_dot", 3, p_dot, p_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_moving_frame_velocity, vector 2, first of a batch: p_dot", 3, p_dot_batch, p_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_moving_frame_velocity, vector 2, last: p_dot", 3, p_dot_batch + 30, p_dot_expected, 8.0 * DBL_EPSILON);
}

static void moving_frame_velocity_vector_1f(void)
{
    const float o_dot[3] = {1.25f, 0.5f, -0.75f};
    const float Q[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const float rho[3] = {1.75f, -0.5f, 0.75f};
    const float rho_dot[3] = {-1.25f, 1.5f, 1.25f};
    const double p_dot_expected[3] = {-2.1, -0.7375, 4.875};
    float p_dot[3], p_dot_batch[33];
    chasles_moving_frame_velocityf(o_dot, Q, omega, rho, rho_dot, p_dot);
    chasles_moving_frame_velocity_batchf(
        11,
        o_dot, 0,
        Q, 0,
        omega, 0,
        rho, 0,
        rho_dot, 0,
        p_dot_batch, 3);
    comparef("chasles_moving_frame_velocityf, vector 1: p_dot", 3, p_dot, p_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_moving_frame_velocityf, vector 1, first of a batch: p_dot", 3, p_dot_batch, p_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_moving_frame_velocityf, vector 1, last: p_dot", 3, p_dot_batch + 30, p_dot_expected, 8.0 * FLT_EPSILON);
}

static void moving_frame_velocity_vector_2f(void)
{
    const float o_dot[3] = {2.0f, -1.5f, 0.25f};
    const float Q[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const float omega[3] = {1.75f, -0.5f, 0.75f};
    const float rho[3] = {-1.25f, 1.5f, 1.25f};
    const float rho_dot[3] = {0.5f, -0.75f, 2.0f};
    const double p_dot_expected[3] = {
        2.9791666666666666667,
        -6.6458333333333333333,
        0.22916666666666666667,
    };
    float p_dot[3], p_dot_batch[33];
    chasles_moving_frame_velocityf(o_dot, Q, omega, rho, rho_dot, p_dot);
    chasles_moving_frame_velocity_batchf(
        11,
        o_dot, 0,
        Q, 0,
        omega, 0,
        rho, 0,
        rho_dot, 0,
        p_dot_batch, 3);
    comparef("chasles_moving_frame_velocityf, vector 2: p_dot", 3, p_dot, p_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_moving_frame_velocityf, vector 2, first of a batch: p_dot", 3, p_dot_batch, p_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_moving_frame_velocityf, vector 2, last: p_dot", 3, p_dot_batch + 30, p_dot_expected, 8.0 * FLT_EPSILON);
}

static void moving_frame_acceleration_vector_1(void)
{
    const double o_ddot[3] = {1.25, 0.5, -0.75};
    const double Q[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double omega[3] = {2.0, -1.5, 0.25};
    const double omega_dot[3] = {1.75, -0.5, 0.75};
    const double rho[3] = {-1.25, 1.5, 1.25};
    const double rho_dot[3] = {0.5, -0.75, 2.0};
    const double rho_ddot[3] = {-1.5, 0.25, 1.75};
    const double p_ddot_expected[3] = {-0.940625, -5.9625, -6.4};
    double p_ddot[3], p_ddot_batch[33];
    chasles_moving_frame_acceleration(o_ddot, Q, omega, omega_dot, rho, rho_dot, rho_ddot, p_ddot);
    chasles_moving_frame_acceleration_batch(
        11,
        o_ddot, 0,
        Q, 0,
        omega, 0,
        omega_dot, 0,
        rho, 0,
        rho_dot, 0,
        rho_ddot, 0,
        p_ddot_batch, 3);
    compare("chasles_moving_frame_acceleration, vector 1: p_ddot", 3, p_ddot, p_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_moving_frame_acceleration, vector 1, first of a batch: p_ddot", 3, p_ddot_batch, p_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_moving_frame_acceleration, vector 1, last: p_ddot", 3, p_ddot_batch + 30, p_ddot_expected, 8.0 * DBL_EPSILON);
}

static void moving_frame_acceleration_vector_2(void)
{
    const double o_ddot[3] = {2.0, -1.5, 0.25};
    const double Q[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double omega[3] = {1.75, -0.5, 0.75};
    const double omega_dot[3] = {-1.25, 1.5, 1.25};
    const double rho[3] = {0.5, -0.75, 2.0};
    const double rho_dot[3] = {-1.5, 0.25, 1.75};
    const double rho_ddot[3] = {-0.5, 0.75, -1.25};
    const double p_ddot_expected[3] = {
        2.9635416666666666667,
        -2.8854166666666666667,
        -6.0052083333333333333,
    };
    double p_ddot[3], p_ddot_batch[33];
    chasles_moving_frame_acceleration(o_ddot, Q, omega, omega_dot, rho, rho_dot, rho_ddot, p_ddot);
    chasles_moving_frame_acceleration_batch(
        11,
        o_ddot, 0,
        Q, 0,
        omega, 0,
        omega_dot, 0,
        rho, 0,
        rho_dot, 0,
        rho_ddot, 0,
        p_ddot_batch, 3);
    compare("chasles_moving_frame_acceleration, vector 2: p_ddot", 3, p_ddot, p_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_moving_frame_acceleration, vector 2, first of a batch: p_ddot", 3, p_ddot_batch, p_ddot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_moving_frame_acceleration, vector 2, last: p_ddot", 3, p_ddot_batch + 30, p_ddot_expected, 8.0 * DBL_EPSILON);
}

static void moving_frame_acceleration_vector_1f(void)
{
    const float o_ddot[3] = {1.25f, 0.5f, -0.75f};
    const float Q[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const float omega_dot[3] = {1.75f, -0.5f, 0.75f};
    const float rho[3] = {-1.25f, 1.5f, 1.25f};
    const float rho_dot[3] = {0.5f, -0.75f, 2.0f};
    const float rho_ddot[3] = {-1.5f, 0.25f, 1.75f};
    const double p_ddot_expected[3] = {-0.940625, -5.9625, -6.4};
    float p_ddot[3], p_ddot_batch[33];
    chasles_moving_frame_accelerationf(o_ddot, Q, omega, omega_dot, rho, rho_dot, rho_ddot, p_ddot);
    chasles_moving_frame_acceleration_batchf(
        11,
        o_ddot, 0,
        Q, 0,
        omega, 0,
        omega_dot, 0,
        rho, 0,
        rho_dot, 0,
        rho_ddot, 0,
        p_ddot_batch, 3);
    comparef("chasles_moving_frame_accelerationf, vector 1: p_ddot", 3, p_ddot, p_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_moving_frame_accelerationf, vector 1, first of a batch: p_ddot", 3, p_ddot_batch, p_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_moving_frame_accelerationf, vector 1, last: p_ddot", 3, p_ddot_batch + 30, p_ddot_expected, 8.0 * FLT_EPSILON);
}

static void moving_frame_acceleration_vector_2f(void)
{
    const float o_ddot[3] = {2.0f, -1.5f, 0.25f};
    const float Q[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const float omega[3] = {1.75f, -0.5f, 0.75f};
    const float omega_dot[3] = {-1.25f, 1.5f, 1.25f};
    const float rho[3] = {0.5f, -0.75f, 2.0f};
    const float rho_dot[3] = {-1.5f, 0.25f, 1.75f};
    const float rho_ddot[3] = {-0.5f, 0.75f, -1.25f};
    const double p_ddot_expected[3] = {
        2.9635416666666666667,
        -2.8854166666666666667,
        -6.0052083333333333333,
    };
    float p_ddot[3], p_ddot_batch[33];
    chasles_moving_frame_accelerationf(o_ddot, Q, omega, omega_dot, rho, rho_dot, rho_ddot, p_ddot);
    chasles_moving_frame_acceleration_batchf(
        11,
        o_ddot, 0,
        Q, 0,
        omega, 0,
        omega_dot, 0,
        rho, 0,
        rho_dot, 0,
        rho_ddot, 0,
        p_ddot_batch, 3);
    comparef("chasles_moving_frame_accelerationf, vector 2: p_ddot", 3, p_ddot, p_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_moving_frame_accelerationf, vector 2, first of a batch: p_ddot", 3, p_ddot_batch, p_ddot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_moving_frame_accelerationf, vector 2, last: p_ddot", 3, p_ddot_batch + 30, p_ddot_expected, 8.0 * FLT_EPSILON);
}

static void wrench_axis_vector_1(void)
{
    const double f[3] = {1.25, 0.5, -0.75};
    const double n_A[3] = {2.0, -1.5, 0.25};
    const double a[3] = {1.75, -0.5, 0.75};
    const double axis_expected[6] = {
        0.81110710565381269082,
        0.32444284226152507633,
        -0.48666426339228761449,
        0.76414827322122353504,
        0.27321502506233690638,
        1.4557238054102638293,
    };
    double axis[6], axis_batch[66];
    const double pitch_expected[1] = {0.65789473684210526316};
    double pitch[1], pitch_batch[11];
    chasles_wrench_axis(f, n_A, a, axis, pitch);
    chasles_wrench_axis_batch(11, f, 0, n_A, 0, a, 0, axis_batch, 6, pitch_batch, 1);
    compare("chasles_wrench_axis, vector 1: axis", 6, axis, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 1, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 1, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 1: pitch", 1, pitch, pitch_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 1, first of a batch: pitch", 1, pitch_batch, pitch_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 1, last: pitch", 1, pitch_batch + 10, pitch_expected, 8.0 * DBL_EPSILON);
}

static void wrench_axis_vector_2(void)
{
    const double f[3] = {2.0, -1.5, 0.25};
    const double n_A[3] = {1.75, -0.5, 0.75};
    const double a[3] = {-1.25, 1.5, 1.25};
    const double axis_expected[6] = {
        0.79602975216799130853,
        -0.5970223141259934814,
        0.099503719020998913567,
        1.0324742330099689249,
        1.3400983544387502196,
        -0.21920373744725008187,
    };
    double axis[6], axis_batch[66];
    const double pitch_expected[1] = {0.7029702970297029703};
    double pitch[1], pitch_batch[11];
    chasles_wrench_axis(f, n_A, a, axis, pitch);
    chasles_wrench_axis_batch(11, f, 0, n_A, 0, a, 0, axis_batch, 6, pitch_batch, 1);
    compare("chasles_wrench_axis, vector 2: axis", 6, axis, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 2, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 2, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 2: pitch", 1, pitch, pitch_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 2, first of a batch: pitch", 1, pitch_batch, pitch_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 2, last: pitch", 1, pitch_batch + 10, pitch_expected, 8.0 * DBL_EPSILON);
}

static void wrench_axis_vector_3(void)
{
    const double f[3] = {0.0, 0.0, 0.0};
    const double n_A[3] = {0.0, 0.0, 0.0};
    const double a[3] = {0.0, 0.0, 0.0};
    const double axis_expected[6] = {NAN, NAN, NAN, NAN, NAN, NAN};
    double axis[6], axis_batch[66];
    const double pitch_expected[1] = {NAN};
    double pitch[1], pitch_batch[11];
    chasles_wrench_axis(f, n_A, a, axis, pitch);
    chasles_wrench_axis_batch(11, f, 0, n_A, 0, a, 0, axis_batch, 6, pitch_batch, 1);
    compare("chasles_wrench_axis, vector 3: axis", 6, axis, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 3, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 3, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 3: pitch", 1, pitch, pitch_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 3, first of a batch: pitch", 1, pitch_batch, pitch_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_axis, vector 3, last: pitch", 1, pitch_batch + 10, pitch_expected, 8.0 * DBL_EPSILON);
}

static void wrench_axis_vector_1f(void)
{
    const float f[3] = {1.25f, 0.5f, -0.75f};
    const float n_A[3] = {2.0f, -1.5f, 0.25f};
    const float a[3] = {1.75f, -0.5f, 0.75f};
    const double axis_expected[6] = {
        0.81110710565381269082,
        0.32444284226152507633,
        -0.48666426339228761449,
        0.76414827322122353504,
        0.27321502506233690638,
        1.4557238054102638293,
    };
    float axis[6], axis_batch[66];
    const double pitch_expected[1] = {0.65789473684210526316};
    float pitch[1], pitch_batch[11];
    chasles_wrench_axisf(f, n_A, a, axis, pitch);
    chasles_wrench_axis_batchf(11, f, 0, n_A, 0, a, 0, axis_batch, 6, pitch_batch, 1);
    comparef("chasles_wrench_axisf, vector 1: axis", 6, axis, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 1, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 1, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 1: pitch", 1, pitch, pitch_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 1, first of a batch: pitch", 1, pitch_batch, pitch_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 1, last: pitch", 1, pitch_batch + 10, pitch_expected, 8.0 * FLT_EPSILON);
}

static void wrench_axis_vector_2f(void)
{
    const float f[3] = {2.0f, -1.5f, 0.25f};
    const float n_A[3] = {1.75f, -0.5f, 0.75f};
    const float a[3] = {-1.25f, 1.5f, 1.25f};
    const double axis_expected[6] = {
        0.79602975216799130853,
        -0.5970223141259934814,
        0.099503719020998913567,
        1.0324742330099689249,
        1.3400983544387502196,
        -0.21920373744725008187,
    };
    float axis[6], axis_batch[66];
    const double pitch_expected[1] = {0.7029702970297029703};
    float pitch[1], pitch_batch[11];
    chasles_wrench_axisf(f, n_A, a, axis, pitch);
    chasles_wrench_axis_batchf(11, f, 0, n_A, 0, a, 0, axis_batch, 6, pitch_batch, 1);
    comparef("chasles_wrench_axisf, vector 2: axis", 6, axis, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 2, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 2, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 2: pitch", 1, pitch, pitch_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 2, first of a batch: pitch", 1, pitch_batch, pitch_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 2, last: pitch", 1, pitch_batch + 10, pitch_expected, 8.0 * FLT_EPSILON);
}

static void wrench_axis_vector_3f(void)
{
    const float f[3] = {0.0f, 0.0f, 0.0f};
    const float n_A[3] = {0.0f, 0.0f, 0.0f};
    const float a[3] = {0.0f, 0.0f, 0.0f};
    const double axis_expected[6] = {NAN, NAN, NAN, NAN, NAN, NAN};
    float axis[6], axis_batch[66];
    const double pitch_expected[1] = {NAN};
    float pitch[1], pitch_batch[11];
    chasles_wrench_axisf(f, n_A, a, axis, pitch);
    chasles_wrench_axis_batchf(11, f, 0, n_A, 0, a, 0, axis_batch, 6, pitch_batch, 1);
    comparef("chasles_wrench_axisf, vector 3: axis", 6, axis, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 3, first of a batch: axis", 6, axis_batch, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 3, last: axis", 6, axis_batch + 60, axis_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 3: pitch", 1, pitch, pitch_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 3, first of a batch: pitch", 1, pitch_batch, pitch_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_axisf, vector 3, last: pitch", 1, pitch_batch + 10, pitch_expected, 8.0 * FLT_EPSILON);
}

static void power_vector_1(void)
{
    const double t[6] = {1.25, 0.5, -0.75, 2.0, -1.5, 0.25};
    const double w[6] = {1.75, -0.5, 0.75, -1.25, 1.5, 1.25};
    const double Pi_expected[1] = {-3.0625};
    double Pi[1], Pi_batch[11];
    chasles_power(t, w, Pi);
    chasles_power_batch(11, t, 0, w, 0, Pi_batch, 1);
    compare("chasles_power, vector 1: Pi", 1, Pi, Pi_expected, 8.0 * DBL_EPSILON);
    compare("chasles_power, vector 1, first of a batch: Pi", 1, Pi_batch, Pi_expected, 8.0 * DBL_EPSILON);
    compare("chasles_power, vector 1, last: Pi", 1, Pi_batch + 10, Pi_expected, 8.0 * DBL_EPSILON);
}

static void power_vector_2(void)
{
    const double t[6] = {2.0, -1.5, 0.25, 1.75, -0.5, 0.75};
    const double w[6] = {-1.25, 1.5, 1.25, 0.5, -0.75, 2.0};
    const double Pi_expected[1] = {-1.6875};
    double Pi[1], Pi_batch[11];
    chasles_power(t, w, Pi);
    chasles_power_batch(11, t, 0, w, 0, Pi_batch, 1);
    compare("chasles_power, vector 2: Pi", 1, Pi, Pi_expected, 8.0 * DBL_EPSILON);
    compare("chasles_power, vector 2, first of a batch: Pi", 1, Pi_batch, Pi_expected, 8.0 * DBL_EPSILON);
    compare("chasles_power, vector 2, last: Pi", 1, Pi_batch + 10, Pi_expected, 8.0 * DBL_EPSILON);
}

static void power_vector_1f(void)
{
    const float t[6] = {1.25f, 0.5f, -0.75f, 2.0f, -1.5f, 0.25f};
    const float w[6] = {1.75f, -0.5f, 0.75f, -1.25f, 1.5f, 1.25f};
    const double Pi_expected[1] = {-3.0625};
    float Pi[1], Pi_batch[11];
    chasles_powerf(t, w, Pi);
    chasles_power_batchf(11, t, 0, w, 0, Pi_batch, 1);
    comparef("chasles_powerf, vector 1: Pi", 1, Pi, Pi_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_powerf, vector 1, first of a batch: Pi", 1, Pi_batch, Pi_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_powerf, vector 1, last: Pi", 1, Pi_batch + 10, Pi_expected, 8.0 * FLT_EPSILON);
}

static void power_vector_2f(void)
{
    const float t[6] = {2.0f, -1.5f, 0.25f, 1.75f, -0.5f, 0.75f};
    const float w[6] = {-1.25f, 1.5f, 1.25f, 0.5f, -0.75f, 2.0f};
    const double Pi_expected[1] = {-1.6875};
    float Pi[1], Pi_batch[11];
    chasles_powerf(t, w, Pi);
    chasles_power_batchf(11, t, 0, w, 0, Pi_batch, 1);
    comparef("chasles_powerf, vector 2: Pi", 1, Pi, Pi_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_powerf, vector 2, first of a batch: Pi", 1, Pi_batch, Pi_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_powerf, vector 2, last: Pi", 1, Pi_batch + 10, Pi_expected, 8.0 * FLT_EPSILON);
}

static void reciprocal_product_vector_1(void)
{
    const double s_w[6] = {1.25, 0.5, -0.75, 2.0, -1.5, 0.25};
    const double s_t[6] = {1.75, -0.5, 0.75, -1.25, 1.5, 1.25};
    const double product_expected[1] = {2.6875};
    double product[1], product_batch[11];
    chasles_reciprocal_product(s_w, s_t, product);
    chasles_reciprocal_product_batch(11, s_w, 0, s_t, 0, product_batch, 1);
    compare("chasles_reciprocal_product, vector 1: product", 1, product, product_expected, 8.0 * DBL_EPSILON);
    compare("chasles_reciprocal_product, vector 1, first of a batch: product", 1, product_batch, product_expected, 8.0 * DBL_EPSILON);
    compare("chasles_reciprocal_product, vector 1, last: product", 1, product_batch + 10, product_expected, 8.0 * DBL_EPSILON);
}

static void reciprocal_product_vector_2(void)
{
    const double s_w[6] = {2.0, -1.5, 0.25, 1.75, -0.5, 0.75};
    const double s_t[6] = {-1.25, 1.5, 1.25, 0.5, -0.75, 2.0};
    const double product_expected[1] = {0.625};
    double product[1], product_batch[11];
    chasles_reciprocal_product(s_w, s_t, product);
    chasles_reciprocal_product_batch(11, s_w, 0, s_t, 0, product_batch, 1);
    compare("chasles_reciprocal_product, vector 2: product", 1, product, product_expected, 8.0 * DBL_EPSILON);
    compare("chasles_reciprocal_product, vector 2, first of a batch: product", 1, product_batch, product_expected, 8.0 * DBL_EPSILON);
    compare("chasles_reciprocal_product, vector 2, last: product", 1, product_batch + 10, product_expected, 8.0 * DBL_EPSILON);
}

static void reciprocal_product_vector_1f(void)
{
    const float s_w[6] = {1.25f, 0.5f, -0.75f, 2.0f, -1.5f, 0.25f};
    const float s_t[6] = {1.75f, -0.5f, 0.75f, -1.25f, 1.5f, 1.25f};
    const double product_expected[1] = {2.6875};
    float product[1], product_batch[11];
    chasles_reciprocal_productf(s_w, s_t, product);
    chasles_reciprocal_product_batchf(11, s_w, 0, s_t, 0, product_batch, 1);
    comparef("chasles_reciprocal_productf, vector 1: product", 1, product, product_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_reciprocal_productf, vector 1, first of a batch: product", 1, product_batch, product_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_reciprocal_productf, vector 1, last: product", 1, product_batch + 10, product_expected, 8.0 * FLT_EPSILON);
}

static void reciprocal_product_vector_2f(void)
{
    const float s_w[6] = {2.0f, -1.5f, 0.25f, 1.75f, -0.5f, 0.75f};
    const float s_t[6] = {-1.25f, 1.5f, 1.25f, 0.5f, -0.75f, 2.0f};
    const double product_expected[1] = {0.625};
    float product[1], product_batch[11];
    chasles_reciprocal_productf(s_w, s_t, product);
    chasles_reciprocal_product_batchf(11, s_w, 0, s_t, 0, product_batch, 1);
    comparef("chasles_reciprocal_productf, vector 2: product", 1, product, product_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_reciprocal_productf, vector 2, first of a batch: product", 1, product_batch, product_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_reciprocal_productf, vector 2, last: product", 1, product_batch + 10, product_expected, 8.0 * FLT_EPSILON);
}

static void wrench_transfer_vector_1(void)
{
    const double w_A[6] = {1.25, 0.5, -0.75, 2.0, -1.5, 0.25};
    const double a[3] = {1.75, -0.5, 0.75};
    const double p[3] = {-1.25, 1.5, 1.25};
    const double w_P_expected[6] = {0.0, -1.25, -1.25, 2.0, -1.5, 0.25};
    double w_P[6], w_P_batch[66];
    chasles_wrench_transfer(w_A, a, p, w_P);
    chasles_wrench_transfer_batch(11, w_A, 0, a, 0, p, 0, w_P_batch, 6);
    compare("chasles_wrench_transfer, vector 1: w_P", 6, w_P, w_P_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_transfer, vector 1, first of a batch: w_P", 6, w_P_batch, w_P_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_transfer, vector 1, last: w_P", 6, w_P_batch + 60, w_P_expected, 8.0 * DBL_EPSILON);
}

static void wrench_transfer_vector_2(void)
{
    const double w_A[6] = {2.0, -1.5, 0.25, 1.75, -0.5, 0.75};
    const double a[3] = {-1.25, 1.5, 1.25};
    const double p[3] = {0.5, -0.75, 2.0};
    const double w_P_expected[6] = {3.3125, -1.5, -2.8125, 1.75, -0.5, 0.75};
    double w_P[6], w_P_batch[66];
    chasles_wrench_transfer(w_A, a, p, w_P);
    chasles_wrench_transfer_batch(11, w_A, 0, a, 0, p, 0, w_P_batch, 6);
    compare("chasles_wrench_transfer, vector 2: w_P", 6, w_P, w_P_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_transfer, vector 2, first of a batch: w_P", 6, w_P_batch, w_P_expected, 8.0 * DBL_EPSILON);
    compare("chasles_wrench_transfer, vector 2, last: w_P", 6, w_P_batch + 60, w_P_expected, 8.0 * DBL_EPSILON);
}

static void wrench_transfer_vector_1f(void)
{
    const float w_A[6] = {1.25f, 0.5f, -0.75f, 2.0f, -1.5f, 0.25f};
    const float a[3] = {1.75f, -0.5f, 0.75f};
    const float p[3] = {-1.25f, 1.5f, 1.25f};
    const double w_P_expected[6] = {0.0, -1.25, -1.25, 2.0, -1.5, 0.25};
    float w_P[6], w_P_batch[66];
    chasles_wrench_transferf(w_A, a, p, w_P);
    chasles_wrench_transfer_batchf(11, w_A, 0, a, 0, p, 0, w_P_batch, 6);
    comparef("chasles_wrench_transferf, vector 1: w_P", 6, w_P, w_P_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_transferf, vector 1, first of a batch: w_P", 6, w_P_batch, w_P_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_transferf, vector 1, last: w_P", 6, w_P_batch + 60, w_P_expected, 8.0 * FLT_EPSILON);
}

static void wrench_transfer_vector_2f(void)
{
    const float w_A[6] = {2.0f, -1.5f, 0.25f, 1.75f, -0.5f, 0.75f};
    const float a[3] = {-1.25f, 1.5f, 1.25f};
    const float p[3] = {0.5f, -0.75f, 2.0f};
    const double w_P_expected[6] = {3.3125, -1.5, -2.8125, 1.75, -0.5, 0.75};
    float w_P[6], w_P_batch[66];
    chasles_wrench_transferf(w_A, a, p, w_P);
    chasles_wrench_transfer_batchf(11, w_A, 0, a, 0, p, 0, w_P_batch, 6);
    comparef("chasles_wrench_transferf, vector 2: w_P", 6, w_P, w_P_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_transferf, vector 2, first of a batch: w_P", 6, w_P_batch, w_P_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_wrench_transferf, vector 2, last: w_P", 6, w_P_batch + 60, w_P_expected, 8.0 * FLT_EPSILON);
}

static void inertia_about_point_vector_1(void)
{
    const double I_C[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double m[1] = {1.25};
    const double c[3] = {0.5, -0.75, 2.0};
    const double a[3] = {-1.5, 0.25, 1.75};
    const double I_A_expected[9] = {
        1.9947916666666666667,
        2.1666666666666666667,
        0.041666666666666666667,
        3.1666666666666666667,
        5.7447916666666666667,
        -0.020833333333333333333,
        -0.95833333333333333333,
        0.97916666666666666667,
        6.9166666666666666667,
    };
    double I_A[9], I_A_batch[99];
    chasles_inertia_about_point(I_C, m[0], c, a, I_A);
    chasles_inertia_about_point_batch(11, I_C, 0, m, 0, c, 0, a, 0, I_A_batch, 9);
    compare("chasles_inertia_about_point, vector 1: I_A", 9, I_A, I_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_about_point, vector 1, first of a batch: I_A", 9, I_A_batch, I_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_about_point, vector 1, last: I_A", 9, I_A_batch + 90, I_A_expected, 8.0 * DBL_EPSILON);
}

static void inertia_about_point_vector_2(void)
{
    const double I_C[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double m[1] = {2.0};
    const double c[3] = {-1.5, 0.25, 1.75};
    const double a[3] = {-0.5, 0.75, -1.25};
    const double I_A_expected[9] = {19.1, -1.8, 6.0, -0.2, 20.6, 3.0, 6.0, 3.0, 3.5};
    double I_A[9], I_A_batch[99];
    chasles_inertia_about_point(I_C, m[0], c, a, I_A);
    chasles_inertia_about_point_batch(11, I_C, 0, m, 0, c, 0, a, 0, I_A_batch, 9);
    compare("chasles_inertia_about_point, vector 2: I_A", 9, I_A, I_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_about_point, vector 2, first of a batch: I_A", 9, I_A_batch, I_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_about_point, vector 2, last: I_A", 9, I_A_batch + 90, I_A_expected, 8.0 * DBL_EPSILON);
}

static void inertia_about_point_vector_1f(void)
{
    const float I_C[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const float m[1] = {1.25f};
    const float c[3] = {0.5f, -0.75f, 2.0f};
    const float a[3] = {-1.5f, 0.25f, 1.75f};
    const double I_A_expected[9] = {
        1.9947916666666666667,
        2.1666666666666666667,
        0.041666666666666666667,
        3.1666666666666666667,
        5.7447916666666666667,
        -0.020833333333333333333,
        -0.95833333333333333333,
        0.97916666666666666667,
        6.9166666666666666667,
    };
    float I_A[9], I_A_batch[99];
    chasles_inertia_about_pointf(I_C, m[0], c, a, I_A);
    chasles_inertia_about_point_batchf(11, I_C, 0, m, 0, c, 0, a, 0, I_A_batch, 9);
    comparef("chasles_inertia_about_pointf, vector 1: I_A", 9, I_A, I_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_about_pointf, vector 1, first of a batch: I_A", 9, I_A_batch, I_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_about_pointf, vector 1, last: I_A", 9, I_A_batch + 90, I_A_expected, 8.0 * FLT_EPSILON);
}

static void inertia_about_point_vector_2f(void)
{
    const float I_C[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const float m[1] = {2.0f};
    const float c[3] = {-1.5f, 0.25f, 1.75f};
    const float a[3] = {-0.5f, 0.75f, -1.25f};
    const double I_A_expected[9] = {19.1, -1.8, 6.0, -0.2, 20.6, 3.0, 6.0, 3.0, 3.5};
    float I_A[9], I_A_batch[99];
    chasles_inertia_about_pointf(I_C, m[0], c, a, I_A);
    chasles_inertia_about_point_batchf(11, I_C, 0, m, 0, c, 0, a, 0, I_A_batch, 9);
    comparef("chasles_inertia_about_pointf, vector 2: I_A", 9, I_A, I_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_about_pointf, vector 2, first of a batch: I_A", 9, I_A_batch, I_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_about_pointf, vector 2, last: I_A", 9, I_A_batch + 90, I_A_expected, 8.0 * FLT_EPSILON);
}

static void inertia_about_point_sym6_vector_1(void)
{
    const double I_C[6] = {1.25, 0.5, -0.75, 2.0, -1.5, 0.25};
    const double m[1] = {1.75};
    const double c[3] = {-0.5, 0.75, -1.25};
    const double a[3] = {1.5, 1.25, 0.5};
    const double I_A_expected[6] = {7.046875, -1.25, -6.875, 14.359375, -3.03125, 7.6875};
    double I_A[6], I_A_batch[66];
    chasles_inertia_about_point_sym6(I_C, m[0], c, a, I_A);
    chasles_inertia_about_point_sym6_batch(11, I_C, 0, m, 0, c, 0, a, 0, I_A_batch, 6);
    compare("chasles_inertia_about_point_sym6, vector 1: I_A", 6, I_A, I_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_about_point_sym6, vector 1, first of a batch: I_A", 6, I_A_batch, I_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_about_point_sym6, vector 1, last: I_A", 6, I_A_batch + 60, I_A_expected, 8.0 * DBL_EPSILON);
}

static void inertia_about_point_sym6_vector_2(void)
{
    const double I_C[6] = {2.0, -1.5, 0.25, 1.75, -0.5, 0.75};
    const double m[1] = {-1.25};
    const double c[3] = {1.5, 1.25, 0.5};
    const double a[3] = {-0.75, 2.0, -1.5};
    const double I_A_expected[6] = {-3.703125, -3.609375, 5.875, -9.578125, -2.375, -6.28125};
    double I_A[6], I_A_batch[66];
    chasles_inertia_about_point_sym6(I_C, m[0], c, a, I_A);
    chasles_inertia_about_point_sym6_batch(11, I_C, 0, m, 0, c, 0, a, 0, I_A_batch, 6);
    compare("chasles_inertia_about_point_sym6, vector 2: I_A", 6, I_A, I_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_about_point_sym6, vector 2, first of a batch: I_A", 6, I_A_batch, I_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_about_point_sym6, vector 2, last: I_A", 6, I_A_batch + 60, I_A_expected, 8.0 * DBL_EPSILON);
}

static void inertia_about_point_sym6_vector_1f(void)
{
    const float I_C[6] = {1.25f, 0.5f, -0.75f, 2.0f, -1.5f, 0.25f};
    const float m[1] = {1.75f};
    const float c[3] = {-0.5f, 0.75f, -1.25f};
    const float a[3] = {1.5f, 1.25f, 0.5f};
    const double I_A_expected[6] = {7.046875, -1.25, -6.875, 14.359375, -3.03125, 7.6875};
    float I_A[6], I_A_batch[66];
    chasles_inertia_about_point_sym6f(I_C, m[0], c, a, I_A);
    chasles_inertia_about_point_sym6_batchf(11, I_C, 0, m, 0, c, 0, a, 0, I_A_batch, 6);
    comparef("chasles_inertia_about_point_sym6f, vector 1: I_A", 6, I_A, I_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_about_point_sym6f, vector 1, first of a batch: I_A", 6, I_A_batch, I_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_about_point_sym6f, vector 1, last: I_A", 6, I_A_batch + 60, I_A_expected, 8.0 * FLT_EPSILON);
}

static void inertia_about_point_sym6_vector_2f(void)
{
    const float I_C[6] = {2.0f, -1.5f, 0.25f, 1.75f, -0.5f, 0.75f};
    const float m[1] = {-1.25f};
    const float c[3] = {1.5f, 1.25f, 0.5f};
    const float a[3] = {-0.75f, 2.0f, -1.5f};
    const double I_A_expected[6] = {-3.703125, -3.609375, 5.875, -9.578125, -2.375, -6.28125};
    float I_A[6], I_A_batch[66];
    chasles_inertia_about_point_sym6f(I_C, m[0], c, a, I_A);
    chasles_inertia_about_point_sym6_batchf(11, I_C, 0, m, 0, c, 0, a, 0, I_A_batch, 6);
    comparef("chasles_inertia_about_point_sym6f, vector 2: I_A", 6, I_A, I_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_about_point_sym6f, vector 2, first of a batch: I_A", 6, I_A_batch, I_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_about_point_sym6f, vector 2, last: I_A", 6, I_A_batch + 60, I_A_expected, 8.0 * FLT_EPSILON);
}

static void momentum_screw_vector_1(void)
{
    const double I_C[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double m[1] = {1.25};
    const double t[6] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75};
    const double mu_expected[6] = {
        1.9166666666666666667,
        -0.83333333333333333333,
        0.66666666666666666667,
        -1.875,
        0.3125,
        2.1875,
    };
    double mu[6], mu_batch[66];
    chasles_momentum_screw(I_C, m[0], t, mu);
    chasles_momentum_screw_batch(11, I_C, 0, m, 0, t, 0, mu_batch, 6);
    compare("chasles_momentum_screw, vector 1: mu", 6, mu, mu_expected, 8.0 * DBL_EPSILON);
    compare("chasles_momentum_screw, vector 1, first of a batch: mu", 6, mu_batch, mu_expected, 8.0 * DBL_EPSILON);
    compare("chasles_momentum_screw, vector 1, last: mu", 6, mu_batch + 60, mu_expected, 8.0 * DBL_EPSILON);
}

static void momentum_screw_vector_2(void)
{
    const double I_C[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double m[1] = {2.0};
    const double t[6] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25};
    const double mu_expected[6] = {-1.1, -1.05, 1.75, -1.0, 1.5, -2.5};
    double mu[6], mu_batch[66];
    chasles_momentum_screw(I_C, m[0], t, mu);
    chasles_momentum_screw_batch(11, I_C, 0, m, 0, t, 0, mu_batch, 6);
    compare("chasles_momentum_screw, vector 2: mu", 6, mu, mu_expected, 8.0 * DBL_EPSILON);
    compare("chasles_momentum_screw, vector 2, first of a batch: mu", 6, mu_batch, mu_expected, 8.0 * DBL_EPSILON);
    compare("chasles_momentum_screw, vector 2, last: mu", 6, mu_batch + 60, mu_expected, 8.0 * DBL_EPSILON);
}

static void momentum_screw_vector_1f(void)
{
    const float I_C[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const float m[1] = {1.25f};
    const float t[6] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f};
    const double mu_expected[6] = {
        1.9166666666666666667,
        -0.83333333333333333333,
        0.66666666666666666667,
        -1.875,
        0.3125,
        2.1875,
    };
    float mu[6], mu_batch[66];
    chasles_momentum_screwf(I_C, m[0], t, mu);
    chasles_momentum_screw_batchf(11, I_C, 0, m, 0, t, 0, mu_batch, 6);
    comparef("chasles_momentum_screwf, vector 1: mu", 6, mu, mu_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_momentum_screwf, vector 1, first of a batch: mu", 6, mu_batch, mu_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_momentum_screwf, vector 1, last: mu", 6, mu_batch + 60, mu_expected, 8.0 * FLT_EPSILON);
}

static void momentum_screw_vector_2f(void)
{
    const float I_C[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const float m[1] = {2.0f};
    const float t[6] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f};
    const double mu_expected[6] = {-1.1, -1.05, 1.75, -1.0, 1.5, -2.5};
    float mu[6], mu_batch[66];
    chasles_momentum_screwf(I_C, m[0], t, mu);
    chasles_momentum_screw_batchf(11, I_C, 0, m, 0, t, 0, mu_batch, 6);
    comparef("chasles_momentum_screwf, vector 2: mu", 6, mu, mu_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_momentum_screwf, vector 2, first of a batch: mu", 6, mu_batch, mu_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_momentum_screwf, vector 2, last: mu", 6, mu_batch + 60, mu_expected, 8.0 * FLT_EPSILON);
}

static void momentum_screw_sym6_vector_1(void)
{
    const double I_C[6] = {1.25, 0.5, -0.75, 2.0, -1.5, 0.25};
    const double m[1] = {1.75};
    const double t[6] = {-0.5, 0.75, -1.25, 1.5, 1.25, 0.5};
    const double mu_expected[6] = {0.6875, 3.125, -1.0625, 2.625, 2.1875, 0.875};
    double mu[6], mu_batch[66];
    chasles_momentum_screw_sym6(I_C, m[0], t, mu);
    chasles_momentum_screw_sym6_batch(11, I_C, 0, m, 0, t, 0, mu_batch, 6);
    compare("chasles_momentum_screw_sym6, vector 1: mu", 6, mu, mu_expected, 8.0 * DBL_EPSILON);
    compare("chasles_momentum_screw_sym6, vector 1, first of a batch: mu", 6, mu_batch, mu_expected, 8.0 * DBL_EPSILON);
    compare("chasles_momentum_screw_sym6, vector 1, last: mu", 6, mu_batch + 60, mu_expected, 8.0 * DBL_EPSILON);
}

static void momentum_screw_sym6_vector_2(void)
{
    const double I_C[6] = {2.0, -1.5, 0.25, 1.75, -0.5, 0.75};
    const double m[1] = {-1.25};
    const double t[6] = {1.5, 1.25, 0.5, -0.75, 2.0, -1.5};
    const double mu_expected[6] = {1.25, -0.3125, 0.125, 0.9375, -2.5, 1.875};
    double mu[6], mu_batch[66];
    chasles_momentum_screw_sym6(I_C, m[0], t, mu);
    chasles_momentum_screw_sym6_batch(11, I_C, 0, m, 0, t, 0, mu_batch, 6);
    compare("chasles_momentum_screw_sym6, vector 2: mu", 6, mu, mu_expected, 8.0 * DBL_EPSILON);
    compare("chasles_momentum_screw_sym6, vector 2, first of a batch: mu", 6, mu_batch, mu_expected, 8.0 * DBL_EPSILON);
    compare("chasles_momentum_screw_sym6, vector 2, last: mu", 6, mu_batch + 60, mu_expected, 8.0 * DBL_EPSILON);
}

static void momentum_screw_sym6_vector_1f(void)
{
    const float I_C[6] = {1.25f, 0.5f, -0.75f, 2.0f, -1.5f, 0.25f};
    const float m[1] = {1.75f};
    const float t[6] = {-0.5f, 0.75f, -1.25f, 1.5f, 1.25f, 0.5f};
    const double mu_expected[6] = {0.6875, 3.125, -1.0625, 2.625, 2.1875, 0.875};
    float mu[6], mu_batch[66];
    chasles_momentum_screw_sym6f(I_C, m[0], t, mu);
    chasles_momentum_screw_sym6_batchf(11, I_C, 0, m, 0, t, 0, mu_batch, 6);
    comparef("chasles_momentum_screw_sym6f, vector 1: mu", 6, mu, mu_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_momentum_screw_sym6f, vector 1, first of a batch: mu", 6, mu_batch, mu_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_momentum_screw_sym6f, vector 1, last: mu", 6, mu_batch + 60, mu_expected, 8.0 * FLT_EPSILON);
}

static void momentum_screw_sym6_vector_2f(void)
{
    const float I_C[6] = {2.0f, -1.5f, 0.25f, 1.75f, -0.5f, 0.75f};
    const float m[1] = {-1.25f};
    const float t[6] = {1.5f, 1.25f, 0.5f, -0.75f, 2.0f, -1.5f};
    const double mu_expected[6] = {1.25, -0.3125, 0.125, 0.9375, -2.5, 1.875};
    float mu[6], mu_batch[66];
    chasles_momentum_screw_sym6f(I_C, m[0], t, mu);
    chasles_momentum_screw_sym6_batchf(11, I_C, 0, m, 0, t, 0, mu_batch, 6);
    comparef("chasles_momentum_screw_sym6f, vector 2: mu", 6, mu, mu_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_momentum_screw_sym6f, vector 2, first of a batch: mu", 6, mu_batch, mu_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_momentum_screw_sym6f, vector 2, last: mu", 6, mu_batch + 60, mu_expected, 8.0 * FLT_EPSILON);
}

static void kinetic_energy_vector_1(void)
{
    const double I_C[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double m[1] = {1.25};
    const double t[6] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75};
    const double T_expected[1] = {4.8177083333333333333};
    double T[1], T_batch[11];
    chasles_kinetic_energy(I_C, m[0], t, T);
    chasles_kinetic_energy_batch(11, I_C, 0, m, 0, t, 0, T_batch, 1);
    compare("chasles_kinetic_energy, vector 1: T", 1, T, T_expected, 8.0 * DBL_EPSILON);
    compare("chasles_kinetic_energy, vector 1, first of a batch: T", 1, T_batch, T_expected, 8.0 * DBL_EPSILON);
    compare("chasles_kinetic_energy, vector 1, last: T", 1, T_batch + 10, T_expected, 8.0 * DBL_EPSILON);
}

static void kinetic_energy_vector_2(void)
{
    const double I_C[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double m[1] = {2.0};
    const double t[6] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25};
    const double T_expected[1] = {4.6};
    double T[1], T_batch[11];
    chasles_kinetic_energy(I_C, m[0], t, T);
    chasles_kinetic_energy_batch(11, I_C, 0, m, 0, t, 0, T_batch, 1);
    compare("chasles_kinetic_energy, vector 2: T", 1, T, T_expected, 8.0 * DBL_EPSILON);
    compare("chasles_kinetic_energy, vector 2, first of a batch: T", 1, T_batch, T_expected, 8.0 * DBL_EPSILON);
    compare("chasles_kinetic_energy, vector 2, last: T", 1, T_batch + 10, T_expected, 8.0 * DBL_EPSILON);
}

static void kinetic_energy_vector_1f(void)
{
    const float I_C[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const float m[1] = {1.25f};
    const float t[6] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f};
    const double T_expected[1] = {4.8177083333333333333};
    float T[1], T_batch[11];
    chasles_kinetic_energyf(I_C, m[0], t, T);
    chasles_kinetic_energy_batchf(11, I_C, 0, m, 0, t, 0, T_batch, 1);
    comparef("chasles_kinetic_energyf, vector 1: T", 1, T, T_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_kinetic_energyf, vector 1, first of a batch: T", 1, T_batch, T_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_kinetic_energyf, vector 1, last: T", 1, T_batch + 10, T_expected, 8.0 * FLT_EPSILON);
}

static void kinetic_energy_vector_2f(void)
{
    const float I_C[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const float m[1] = {2.0f};
    const float t[6] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f};
    const double T_expected[1] = {4.6};
    float T[1], T_batch[11];
    chasles_kinetic_energyf(I_C, m[0], t, T);
    chasles_kinetic_energy_batchf(11, I_C, 0, m, 0, t, 0, T_batch, 1);
    comparef("chasles_kinetic_energyf, vector 2: T", 1, T, T_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_kinetic_energyf, vector 2, first of a batch: T", 1, T_batch, T_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_kinetic_energyf, vector 2, last: T", 1, T_batch + 10, T_expected, 8.0 * FLT_EPSILON);
}

static void kinetic_energy_sym6_vector_1(void)
{
    const double I_C[6] = {1.25, 0.5, -0.75, 2.0, -1.5, 0.25};
    const double m[1] = {1.75};
    const double t[6] = {-0.5, 0.75, -1.25, 1.5, 1.25, 0.5};
    const double T_expected[1] = {5.21875};
    double T[1], T_batch[11];
    chasles_kinetic_energy_sym6(I_C, m[0], t, T);
    chasles_kinetic_energy_sym6_batch(11, I_C, 0, m, 0, t, 0, T_batch, 1);
    compare("chasles_kinetic_energy_sym6, vector 1: T", 1, T, T_expected, 8.0 * DBL_EPSILON);
    compare("chasles_kinetic_energy_sym6, vector 1, first of a batch: T", 1, T_batch, T_expected, 8.0 * DBL_EPSILON);
    compare("chasles_kinetic_energy_sym6, vector 1, last: T", 1, T_batch + 10, T_expected, 8.0 * DBL_EPSILON);
}

static void kinetic_energy_sym6_vector_2(void)
{
    const double I_C[6] = {2.0, -1.5, 0.25, 1.75, -0.5, 0.75};
    const double m[1] = {-1.25};
    const double t[6] = {1.5, 1.25, 0.5, -0.75, 2.0, -1.5};
    const double T_expected[1] = {-3.484375};
    double T[1], T_batch[11];
    chasles_kinetic_energy_sym6(I_C, m[0], t, T);
    chasles_kinetic_energy_sym6_batch(11, I_C, 0, m, 0, t, 0, T_batch, 1);
    compare("chasles_kinetic_energy_sym6, vector 2: T", 1, T, T_expected, 8.0 * DBL_EPSILON);
    compare("chasles_kinetic_energy_sym6, vector 2, first of a batch: T", 1, T_batch, T_expected, 8.0 * DBL_EPSILON);
    compare("chasles_kinetic_energy_sym6, vector 2, last: T", 1, T_batch + 10, T_expected, 8.0 * DBL_EPSILON);
}

static void kinetic_energy_sym6_vector_1f(void)
{
    const float I_C[6] = {1.25f, 0.5f, -0.75f, 2.0f, -1.5f, 0.25f};
    const float m[1] = {1.75f};
    const float t[6] = {-0.5f, 0.75f, -1.25f, 1.5f, 1.25f, 0.5f};
    const double T_expected[1] = {5.21875};
    float T[1], T_batch[11];
    chasles_kinetic_energy_sym6f(I_C, m[0], t, T);
    chasles_kinetic_energy_sym6_batchf(11, I_C, 0, m, 0, t, 0, T_batch, 1);
    comparef("chasles_kinetic_energy_sym6f, vector 1: T", 1, T, T_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_kinetic_energy_sym6f, vector 1, first of a batch: T", 1, T_batch, T_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_kinetic_energy_sym6f, vector 1, last: T", 1, T_batch + 10, T_expected, 8.0 * FLT_EPSILON);
}

static void kinetic_energy_sym6_vector_2f(void)
{
    const float I_C[6] = {2.0f, -1.5f, 0.25f, 1.75f, -0.5f, 0.75f};
    const float m[1] = {-1.25f};
    const float t[6] = {1.5f, 1.25f, 0.5f, -0.75f, 2.0f, -1.5f};
    const double T_expected[1] = {-3.484375};
    float T[1], T_batch[11];
    chasles_kinetic_energy_sym6f(I_C, m[0], t, T);
    chasles_kinetic_energy_sym6_batchf(11, I_C, 0, m, 0, t, 0, T_batch, 1);
    comparef("chasles_kinetic_energy_sym6f, vector 2: T", 1, T, T_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_kinetic_energy_sym6f, vector 2, first of a batch: T", 1, T_batch, T_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_kinetic_energy_sym6f, vector 2, last: T", 1, T_batch + 10, T_expected, 8.0 * FLT_EPSILON);
}

static void newton_euler_wrench_vector_1(void)
{
    const double I_C[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double m[1] = {1.25};
    const double t[6] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75};
    const double t_dot[6] = {-0.5, 0.75, -1.25, 1.5, 1.25, 0.5};
    const double w_expected[6] = {
        -0.25,
        4.0833333333333333333,
        0.85416666666666666667,
        1.875,
        1.5625,
        0.625,
    };
    double w[6], w_batch[66];
    chasles_newton_euler_wrench(I_C, m[0], t, t_dot, w);
    chasles_newton_euler_wrench_batch(11, I_C, 0, m, 0, t, 0, t_dot, 0, w_batch, 6);
    compare("chasles_newton_euler_wrench, vector 1: w", 6, w, w_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_wrench, vector 1, first of a batch: w", 6, w_batch, w_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_wrench, vector 1, last: w", 6, w_batch + 60, w_expected, 8.0 * DBL_EPSILON);
}

static void newton_euler_wrench_vector_2(void)
{
    const double I_C[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double m[1] = {2.0};
    const double t[6] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25};
    const double t_dot[6] = {1.5, 1.25, 0.5, -0.75, 2.0, -1.5};
    const double w_expected[6] = {2.175, 2.65, 2.35, -1.5, 4.0, -3.0};
    double w[6], w_batch[66];
    chasles_newton_euler_wrench(I_C, m[0], t, t_dot, w);
    chasles_newton_euler_wrench_batch(11, I_C, 0, m, 0, t, 0, t_dot, 0, w_batch, 6);
    compare("chasles_newton_euler_wrench, vector 2: w", 6, w, w_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_wrench, vector 2, first of a batch: w", 6, w_batch, w_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_wrench, vector 2, last: w", 6, w_batch + 60, w_expected, 8.0 * DBL_EPSILON);
}

static void newton_euler_wrench_vector_1f(void)
{
    const float I_C[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const float m[1] = {1.25f};
    const float t[6] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f};
    const float t_dot[6] = {-0.5f, 0.75f, -1.25f, 1.5f, 1.25f, 0.5f};
    const double w_expected[6] = {
        -0.25,
        4.0833333333333333333,
        0.85416666666666666667,
        1.875,
        1.5625,
        0.625,
    };
    float w[6], w_batch[66];
    chasles_newton_euler_wrenchf(I_C, m[0], t, t_dot, w);
    chasles_newton_euler_wrench_batchf(11, I_C, 0, m, 0, t, 0, t_dot, 0, w_batch, 6);
    comparef("chasles_newton_euler_wrenchf, vector 1: w", 6, w, w_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_wrenchf, vector 1, first of a batch: w", 6, w_batch, w_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_wrenchf, vector 1, last: w", 6, w_batch + 60, w_expected, 8.0 * FLT_EPSILON);
}

static void newton_euler_wrench_vector_2f(void)
{
    const float I_C[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const float m[1] = {2.0f};
    const float t[6] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f};
    const float t_dot[6] = {1.5f, 1.25f, 0.5f, -0.75f, 2.0f, -1.5f};
    const double w_expected[6] = {2.175, 2.65, 2.35, -1.5, 4.0, -3.0};
    float w[6], w_batch[66];
    chasles_newton_euler_wrenchf(I_C, m[0], t, t_dot, w);
    chasles_newton_euler_wrench_batchf(11, I_C, 0, m, 0, t, 0, t_dot, 0, w_batch, 6);
    comparef("chasles_newton_euler_wrenchf, vector 2: w", 6, w, w_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_wrenchf, vector 2, first of a batch: w", 6, w_batch, w_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_wrenchf, vector 2, last: w", 6, w_batch + 60, w_expected, 8.0 * FLT_EPSILON);
}

static void newton_euler_wrench_sym6_vector_1(void)
{
    const double I_C[6] = {1.25, 0.5, -0.75, 2.0, -1.5, 0.25};
    const double m[1] = {1.75};
    const double t[6] = {-0.5, 0.75, -1.25, 1.5, 1.25, 0.5};
    const double t_dot[6] = {-0.75, 2.0, -1.5, 0.25, 1.75, -0.5};
    const double w_expected[6] = {4.296875, 4.484375, -4.890625, 0.4375, 3.0625, -0.875};
    double w[6], w_batch[66];
    chasles_newton_euler_wrench_sym6(I_C, m[0], t, t_dot, w);
    chasles_newton_euler_wrench_sym6_batch(11, I_C, 0, m, 0, t, 0, t_dot, 0, w_batch, 6);
    compare("chasles_newton_euler_wrench_sym6, vector 1: w", 6, w, w_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_wrench_sym6, vector 1, first of a batch: w", 6, w_batch, w_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_wrench_sym6, vector 1, last: w", 6, w_batch + 60, w_expected, 8.0 * DBL_EPSILON);
}

static void newton_euler_wrench_sym6_vector_2(void)
{
    const double I_C[6] = {2.0, -1.5, 0.25, 1.75, -0.5, 0.75};
    const double m[1] = {-1.25};
    const double t[6] = {1.5, 1.25, 0.5, -0.75, 2.0, -1.5};
    const double t_dot[6] = {0.25, 1.75, -0.5, 0.75, -1.25, 1.5};
    const double w_expected[6] = {-1.9375, 3.375, -3.21875, -0.9375, 1.5625, -1.875};
    double w[6], w_batch[66];
    chasles_newton_euler_wrench_sym6(I_C, m[0], t, t_dot, w);
    chasles_newton_euler_wrench_sym6_batch(11, I_C, 0, m, 0, t, 0, t_dot, 0, w_batch, 6);
    compare("chasles_newton_euler_wrench_sym6, vector 2: w", 6, w, w_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_wrench_sym6, vector 2, first of a batch: w", 6, w_batch, w_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_wrench_sym6, vector 2, last: w", 6, w_batch + 60, w_expected, 8.0 * DBL_EPSILON);
}

static void newton_euler_wrench_sym6_vector_1f(void)
{
    const float I_C[6] = {1.25f, 0.5f, -0.75f, 2.0f, -1.5f, 0.25f};
    const float m[1] = {1.75f};
    const float t[6] = {-0.5f, 0.75f, -1.25f, 1.5f, 1.25f, 0.5f};
    const float t_dot[6] = {-0.75f, 2.0f, -1.5f, 0.25f, 1.75f, -0.5f};
    const double w_expected[6] = {4.296875, 4.484375, -4.890625, 0.4375, 3.0625, -0.875};
    float w[6], w_batch[66];
    chasles_newton_euler_wrench_sym6f(I_C, m[0], t, t_dot, w);
    chasles_newton_euler_wrench_sym6_batchf(11, I_C, 0, m, 0, t, 0, t_dot, 0, w_batch, 6);
    comparef("chasles_newton_euler_wrench_sym6f, vector 1: w", 6, w, w_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_wrench_sym6f, vector 1, first of a batch: w", 6, w_batch, w_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_wrench_sym6f, vector 1, last: w", 6, w_batch + 60, w_expected, 8.0 * FLT_EPSILON);
}

static void newton_euler_wrench_sym6_vector_2f(void)
{
    const float I_C[6] = {2.0f, -1.5f, 0.25f, 1.75f, -0.5f, 0.75f};
    const float m[1] = {-1.25f};
    const float t[6] = {1.5f, 1.25f, 0.5f, -0.75f, 2.0f, -1.5f};
    const float t_dot[6] = {0.25f, 1.75f, -0.5f, 0.75f, -1.25f, 1.5f};
    const double w_expected[6] = {-1.9375, 3.375, -3.21875, -0.9375, 1.5625, -1.875};
    float w[6], w_batch[66];
    chasles_newton_euler_wrench_sym6f(I_C, m[0], t, t_dot, w);
    chasles_newton_euler_wrench_sym6_batchf(11, I_C, 0, m, 0, t, 0, t_dot, 0, w_batch, 6);
    comparef("chasles_newton_euler_wrench_sym6f, vector 2: w", 6, w, w_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_wrench_sym6f, vector 2, first of a batch: w", 6, w_batch, w_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_wrench_sym6f, vector 2, last: w", 6, w_batch + 60, w_expected, 8.0 * FLT_EPSILON);
}

static void newton_euler_twist_rate_vector_1(void)
{
    const double I_C[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double m[1] = {1.25};
    const double t[6] = {0.5, -0.75, 2.0, -1.5, 0.25, 1.75};
    const double w[6] = {-0.5, 0.75, -1.25, 1.5, 1.25, 0.5};
    const double t_dot_expected[6] = {
        -2.1875,
        -2.7916666666666666667,
        -1.7083333333333333333,
        1.2,
        1.0,
        0.4,
    };
    double t_dot[6], t_dot_batch[66];
    chasles_newton_euler_twist_rate(I_C, m[0], t, w, t_dot);
    chasles_newton_euler_twist_rate_batch(11, I_C, 0, m, 0, t, 0, w, 0, t_dot_batch, 6);
    compare("chasles_newton_euler_twist_rate, vector 1: t_dot", 6, t_dot, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_twist_rate, vector 1, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_twist_rate, vector 1, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * DBL_EPSILON);
}

static void newton_euler_twist_rate_vector_2(void)
{
    const double I_C[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double m[1] = {2.0};
    const double t[6] = {-1.5, 0.25, 1.75, -0.5, 0.75, -1.25};
    const double w[6] = {1.5, 1.25, 0.5, -0.75, 2.0, -1.5};
    const double t_dot_expected[6] = {-0.025, 0.95, -1.35, -0.375, 1.0, -0.75};
    double t_dot[6], t_dot_batch[66];
    chasles_newton_euler_twist_rate(I_C, m[0], t, w, t_dot);
    chasles_newton_euler_twist_rate_batch(11, I_C, 0, m, 0, t, 0, w, 0, t_dot_batch, 6);
    compare("chasles_newton_euler_twist_rate, vector 2: t_dot", 6, t_dot, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_twist_rate, vector 2, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_twist_rate, vector 2, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * DBL_EPSILON);
}

static void newton_euler_twist_rate_vector_3(void)
{
    const double I_C[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double m[1] = {0.0};
    const double t[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const double w[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const double t_dot_expected[6] = {0.0, 0.0, 0.0, NAN, NAN, NAN};
    double t_dot[6], t_dot_batch[66];
    chasles_newton_euler_twist_rate(I_C, m[0], t, w, t_dot);
    chasles_newton_euler_twist_rate_batch(11, I_C, 0, m, 0, t, 0, w, 0, t_dot_batch, 6);
    compare("chasles_newton_euler_twist_rate, vector 3: t_dot", 6, t_dot, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_twist_rate, vector 3, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_twist_rate, vector 3, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * DBL_EPSILON);
}

static void newton_euler_twist_rate_vector_1f(void)
{
    const float I_C[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const float m[1] = {1.25f};
    const float t[6] = {0.5f, -0.75f, 2.0f, -1.5f, 0.25f, 1.75f};
    const float w[6] = {-0.5f, 0.75f, -1.25f, 1.5f, 1.25f, 0.5f};
    const double t_dot_expected[6] = {
        -2.1875,
        -2.7916666666666666667,
        -1.7083333333333333333,
        1.2,
        1.0,
        0.4,
    };
    float t_dot[6], t_dot_batch[66];
    chasles_newton_euler_twist_ratef(I_C, m[0], t, w, t_dot);
    chasles_newton_euler_twist_rate_batchf(11, I_C, 0, m, 0, t, 0, w, 0, t_dot_batch, 6);
    comparef("chasles_newton_euler_twist_ratef, vector 1: t_dot", 6, t_dot, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_twist_ratef, vector 1, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_twist_ratef, vector 1, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * FLT_EPSILON);
}

static void newton_euler_twist_rate_vector_2f(void)
{
    const float I_C[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const float m[1] = {2.0f};
    const float t[6] = {-1.5f, 0.25f, 1.75f, -0.5f, 0.75f, -1.25f};
    const float w[6] = {1.5f, 1.25f, 0.5f, -0.75f, 2.0f, -1.5f};
    const double t_dot_expected[6] = {-0.025, 0.95, -1.35, -0.375, 1.0, -0.75};
    float t_dot[6], t_dot_batch[66];
    chasles_newton_euler_twist_ratef(I_C, m[0], t, w, t_dot);
    chasles_newton_euler_twist_rate_batchf(11, I_C, 0, m, 0, t, 0, w, 0, t_dot_batch, 6);
    comparef("chasles_newton_euler_twist_ratef, vector 2: t_dot", 6, t_dot, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_twist_ratef, vector 2, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_twist_ratef, vector 2, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * FLT_EPSILON);
}

static void newton_euler_twist_rate_vector_3f(void)
{
    const float I_C[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const float m[1] = {0.0f};
    const float t[6] = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
    const float w[6] = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
    const double t_dot_expected[6] = {0.0, 0.0, 0.0, NAN, NAN, NAN};
    float t_dot[6], t_dot_batch[66];
    chasles_newton_euler_twist_ratef(I_C, m[0], t, w, t_dot);
    chasles_newton_euler_twist_rate_batchf(11, I_C, 0, m, 0, t, 0, w, 0, t_dot_batch, 6);
    comparef("chasles_newton_euler_twist_ratef, vector 3: t_dot", 6, t_dot, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_twist_ratef, vector 3, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_twist_ratef, vector 3, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * FLT_EPSILON);
}

static void newton_euler_twist_rate_sym6_vector_1(void)
{
    const double I_C[6] = {1.25, 0.5, -0.75, 2.0, -1.5, 0.25};
    const double m[1] = {1.75};
    const double t[6] = {-0.5, 0.75, -1.25, 1.5, 1.25, 0.5};
    const double w[6] = {-0.75, 2.0, -1.5, 0.25, 1.75, -0.5};
    const double t_dot_expected[6] = {
        -4.7013888888888888889,
        1.7065972222222222222,
        -1.5520833333333333333,
        0.14285714285714285714,
        1.0,
        -0.28571428571428571429,
    };
    double t_dot[6], t_dot_batch[66];
    chasles_newton_euler_twist_rate_sym6(I_C, m[0], t, w, t_dot);
    chasles_newton_euler_twist_rate_sym6_batch(11, I_C, 0, m, 0, t, 0, w, 0, t_dot_batch, 6);
    compare("chasles_newton_euler_twist_rate_sym6, vector 1: t_dot", 6, t_dot, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_twist_rate_sym6, vector 1, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_twist_rate_sym6, vector 1, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * DBL_EPSILON);
}

static void newton_euler_twist_rate_sym6_vector_2(void)
{
    const double I_C[6] = {2.0, -1.5, 0.25, 1.75, -0.5, 0.75};
    const double m[1] = {-1.25};
    const double t[6] = {1.5, 1.25, 0.5, -0.75, 2.0, -1.5};
    const double w[6] = {0.25, 1.75, -0.5, 0.75, -1.25, 1.5};
    const double t_dot_expected[6] = {
        2.4527777777777777778,
        3.9555555555555555556,
        3.8611111111111111111,
        -0.6,
        1.0,
        -1.2,
    };
    double t_dot[6], t_dot_batch[66];
    chasles_newton_euler_twist_rate_sym6(I_C, m[0], t, w, t_dot);
    chasles_newton_euler_twist_rate_sym6_batch(11, I_C, 0, m, 0, t, 0, w, 0, t_dot_batch, 6);
    compare("chasles_newton_euler_twist_rate_sym6, vector 2: t_dot", 6, t_dot, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_twist_rate_sym6, vector 2, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_twist_rate_sym6, vector 2, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * DBL_EPSILON);
}

static void newton_euler_twist_rate_sym6_vector_3(void)
{
    const double I_C[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const double m[1] = {0.0};
    const double t[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const double w[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const double t_dot_expected[6] = {NAN, NAN, NAN, NAN, NAN, NAN};
    double t_dot[6], t_dot_batch[66];
    chasles_newton_euler_twist_rate_sym6(I_C, m[0], t, w, t_dot);
    chasles_newton_euler_twist_rate_sym6_batch(11, I_C, 0, m, 0, t, 0, w, 0, t_dot_batch, 6);
    compare("chasles_newton_euler_twist_rate_sym6, vector 3: t_dot", 6, t_dot, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_twist_rate_sym6, vector 3, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_newton_euler_twist_rate_sym6, vector 3, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * DBL_EPSILON);
}

static void newton_euler_twist_rate_sym6_vector_1f(void)
{
    const float I_C[6] = {1.25f, 0.5f, -0.75f, 2.0f, -1.5f, 0.25f};
    const float m[1] = {1.75f};
    const float t[6] = {-0.5f, 0.75f, -1.25f, 1.5f, 1.25f, 0.5f};
    const float w[6] = {-0.75f, 2.0f, -1.5f, 0.25f, 1.75f, -0.5f};
    const double t_dot_expected[6] = {
        -4.7013888888888888889,
        1.7065972222222222222,
        -1.5520833333333333333,
        0.14285714285714285714,
        1.0,
        -0.28571428571428571429,
    };
    float t_dot[6], t_dot_batch[66];
    chasles_newton_euler_twist_rate_sym6f(I_C, m[0], t, w, t_dot);
    chasles_newton_euler_twist_rate_sym6_batchf(11, I_C, 0, m, 0, t, 0, w, 0, t_dot_batch, 6);
    comparef("chasles_newton_euler_twist_rate_sym6f, vector 1: t_dot", 6, t_dot, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_twist_rate_sym6f, vector 1, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_twist_rate_sym6f, vector 1, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * FLT_EPSILON);
}

static void newton_euler_twist_rate_sym6_vector_2f(void)
{
    const float I_C[6] = {2.0f, -1.5f, 0.25f, 1.75f, -0.5f, 0.75f};
    const float m[1] = {-1.25f};
    const float t[6] = {1.5f, 1.25f, 0.5f, -0.75f, 2.0f, -1.5f};
    const float w[6] = {0.25f, 1.75f, -0.5f, 0.75f, -1.25f, 1.5f};
    const double t_dot_expected[6] = {
        2.4527777777777777778,
        3.9555555555555555556,
        3.8611111111111111111,
        -0.6,
        1.0,
        -1.2,
    };
    float t_dot[6], t_dot_batch[66];
    chasles_newton_euler_twist_rate_sym6f(I_C, m[0], t, w, t_dot);
    chasles_newton_euler_twist_rate_sym6_batchf(11, I_C, 0, m, 0, t, 0, w, 0, t_dot_batch, 6);
    comparef("chasles_newton_euler_twist_rate_sym6f, vector 2: t_dot", 6, t_dot, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_twist_rate_sym6f, vector 2, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_twist_rate_sym6f, vector 2, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * FLT_EPSILON);
}

static void newton_euler_twist_rate_sym6_vector_3f(void)
{
    const float I_C[6] = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
    const float m[1] = {0.0f};
    const float t[6] = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
    const float w[6] = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
    const double t_dot_expected[6] = {NAN, NAN, NAN, NAN, NAN, NAN};
    float t_dot[6], t_dot_batch[66];
    chasles_newton_euler_twist_rate_sym6f(I_C, m[0], t, w, t_dot);
    chasles_newton_euler_twist_rate_sym6_batchf(11, I_C, 0, m, 0, t, 0, w, 0, t_dot_batch, 6);
    comparef("chasles_newton_euler_twist_rate_sym6f, vector 3: t_dot", 6, t_dot, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_twist_rate_sym6f, vector 3, first of a batch: t_dot", 6, t_dot_batch, t_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_newton_euler_twist_rate_sym6f, vector 3, last: t_dot", 6, t_dot_batch + 60, t_dot_expected, 8.0 * FLT_EPSILON);
}

static void inertia_dyad_vector_1(void)
{
    const double I_C[9] = {
        2.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 3.0,
        2.0 / 3.0,
        2.0 / 3.0,
    };
    const double m[1] = {1.25};
    const double c[3] = {0.5, -0.75, 2.0};
    const double a[3] = {-1.5, 0.25, 1.75};
    const double M_A_expected[36] = {
        1.9947916666666666667,
        2.1666666666666666667,
        0.041666666666666666667,
        0.0,
        -0.3125,
        -1.25,
        3.1666666666666666667,
        5.7447916666666666667,
        -0.020833333333333333333,
        0.3125,
        0.0,
        -2.5,
        -0.95833333333333333333,
        0.97916666666666666667,
        6.9166666666666666667,
        1.25,
        2.5,
        0.0,
        0.0,
        0.3125,
        1.25,
        1.25,
        0.0,
        0.0,
        -0.3125,
        0.0,
        2.5,
        0.0,
        1.25,
        0.0,
        -1.25,
        -2.5,
        0.0,
        0.0,
        0.0,
        1.25,
    };
    double M_A[36], M_A_batch[396];
    chasles_inertia_dyad(I_C, m[0], c, a, M_A);
    chasles_inertia_dyad_batch(11, I_C, 0, m, 0, c, 0, a, 0, M_A_batch, 36);
    compare("chasles_inertia_dyad, vector 1: M_A", 36, M_A, M_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_dyad, vector 1, first of a batch: M_A", 36, M_A_batch, M_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_dyad, vector 1, last: M_A", 36, M_A_batch + 360, M_A_expected, 8.0 * DBL_EPSILON);
}

static void inertia_dyad_vector_2(void)
{
    const double I_C[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    const double m[1] = {2.0};
    const double c[3] = {-1.5, 0.25, 1.75};
    const double a[3] = {-0.5, 0.75, -1.25};
    const double M_A_expected[36] = {
        19.1,
        -1.8,
        6.0,
        0.0,
        -6.0,
        -1.0,
        -0.2,
        20.6,
        3.0,
        6.0,
        0.0,
        2.0,
        6.0,
        3.0,
        3.5,
        1.0,
        -2.0,
        0.0,
        0.0,
        6.0,
        1.0,
        2.0,
        0.0,
        0.0,
        -6.0,
        0.0,
        -2.0,
        0.0,
        2.0,
        0.0,
        -1.0,
        2.0,
        0.0,
        0.0,
        0.0,
        2.0,
    };
    double M_A[36], M_A_batch[396];
    chasles_inertia_dyad(I_C, m[0], c, a, M_A);
    chasles_inertia_dyad_batch(11, I_C, 0, m, 0, c, 0, a, 0, M_A_batch, 36);
    compare("chasles_inertia_dyad, vector 2: M_A", 36, M_A, M_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_dyad, vector 2, first of a batch: M_A", 36, M_A_batch, M_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_dyad, vector 2, last: M_A", 36, M_A_batch + 360, M_A_expected, 8.0 * DBL_EPSILON);
}

static void inertia_dyad_vector_1f(void)
{
    const float I_C[9] = {
        2.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
        -1.0f / 3.0f,
        -1.0f / 3.0f,
        2.0f / 3.0f,
        2.0f / 3.0f,
    };
    const float m[1] = {1.25f};
    const float c[3] = {0.5f, -0.75f, 2.0f};
    const float a[3] = {-1.5f, 0.25f, 1.75f};
    const double M_A_expected[36] = {
        1.9947916666666666667,
        2.1666666666666666667,
        0.041666666666666666667,
        0.0,
        -0.3125,
        -1.25,
        3.1666666666666666667,
        5.7447916666666666667,
        -0.020833333333333333333,
        0.3125,
        0.0,
        -2.5,
        -0.95833333333333333333,
        0.97916666666666666667,
        6.9166666666666666667,
        1.25,
        2.5,
        0.0,
        0.0,
        0.3125,
        1.25,
        1.25,
        0.0,
        0.0,
        -0.3125,
        0.0,
        2.5,
        0.0,
        1.25,
        0.0,
        -1.25,
        -2.5,
        0.0,
        0.0,
        0.0,
        1.25,
    };
    float M_A[36], M_A_batch[396];
    chasles_inertia_dyadf(I_C, m[0], c, a, M_A);
    chasles_inertia_dyad_batchf(11, I_C, 0, m, 0, c, 0, a, 0, M_A_batch, 36);
    comparef("chasles_inertia_dyadf, vector 1: M_A", 36, M_A, M_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_dyadf, vector 1, first of a batch: M_A", 36, M_A_batch, M_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_dyadf, vector 1, last: M_A", 36, M_A_batch + 360, M_A_expected, 8.0 * FLT_EPSILON);
}

static void inertia_dyad_vector_2f(void)
{
    const float I_C[9] = {0.6f, -0.8f, 0.0f, 0.8f, 0.6f, 0.0f, 0.0f, 0.0f, 1.0f};
    const float m[1] = {2.0f};
    const float c[3] = {-1.5f, 0.25f, 1.75f};
    const float a[3] = {-0.5f, 0.75f, -1.25f};
    const double M_A_expected[36] = {
        19.1,
        -1.8,
        6.0,
        0.0,
        -6.0,
        -1.0,
        -0.2,
        20.6,
        3.0,
        6.0,
        0.0,
        2.0,
        6.0,
        3.0,
        3.5,
        1.0,
        -2.0,
        0.0,
        0.0,
        6.0,
        1.0,
        2.0,
        0.0,
        0.0,
        -6.0,
        0.0,
        -2.0,
        0.0,
        2.0,
        0.0,
        -1.0,
        2.0,
        0.0,
        0.0,
        0.0,
        2.0,
    };
    float M_A[36], M_A_batch[396];
    chasles_inertia_dyadf(I_C, m[0], c, a, M_A);
    chasles_inertia_dyad_batchf(11, I_C, 0, m, 0, c, 0, a, 0, M_A_batch, 36);
    comparef("chasles_inertia_dyadf, vector 2: M_A", 36, M_A, M_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_dyadf, vector 2, first of a batch: M_A", 36, M_A_batch, M_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_dyadf, vector 2, last: M_A", 36, M_A_batch + 360, M_A_expected, 8.0 * FLT_EPSILON);
}

static void inertia_dyad_sym6_vector_1(void)
{
    const double I_C[6] = {1.25, 0.5, -0.75, 2.0, -1.5, 0.25};
    const double m[1] = {1.75};
    const double c[3] = {-0.5, 0.75, -1.25};
    const double a[3] = {1.5, 1.25, 0.5};
    const double M_A_expected[36] = {
        7.046875,
        -1.25,
        -6.875,
        0.0,
        3.0625,
        -0.875,
        -1.25,
        14.359375,
        -3.03125,
        -3.0625,
        0.0,
        3.5,
        -6.875,
        -3.03125,
        7.6875,
        0.875,
        -3.5,
        0.0,
        0.0,
        -3.0625,
        0.875,
        1.75,
        0.0,
        0.0,
        3.0625,
        0.0,
        -3.5,
        0.0,
        1.75,
        0.0,
        -0.875,
        3.5,
        0.0,
        0.0,
        0.0,
        1.75,
    };
    double M_A[36], M_A_batch[396];
    chasles_inertia_dyad_sym6(I_C, m[0], c, a, M_A);
    chasles_inertia_dyad_sym6_batch(11, I_C, 0, m, 0, c, 0, a, 0, M_A_batch, 36);
    compare("chasles_inertia_dyad_sym6, vector 1: M_A", 36, M_A, M_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_dyad_sym6, vector 1, first of a batch: M_A", 36, M_A_batch, M_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_dyad_sym6, vector 1, last: M_A", 36, M_A_batch + 360, M_A_expected, 8.0 * DBL_EPSILON);
}

static void inertia_dyad_sym6_vector_2(void)
{
    const double I_C[6] = {2.0, -1.5, 0.25, 1.75, -0.5, 0.75};
    const double m[1] = {-1.25};
    const double c[3] = {1.5, 1.25, 0.5};
    const double a[3] = {-0.75, 2.0, -1.5};
    const double M_A_expected[36] = {
        -3.703125,
        -3.609375,
        5.875,
        0.0,
        2.5,
        0.9375,
        -3.609375,
        -9.578125,
        -2.375,
        -2.5,
        0.0,
        2.8125,
        5.875,
        -2.375,
        -6.28125,
        -0.9375,
        -2.8125,
        0.0,
        0.0,
        -2.5,
        -0.9375,
        -1.25,
        0.0,
        0.0,
        2.5,
        0.0,
        -2.8125,
        0.0,
        -1.25,
        0.0,
        0.9375,
        2.8125,
        0.0,
        0.0,
        0.0,
        -1.25,
    };
    double M_A[36], M_A_batch[396];
    chasles_inertia_dyad_sym6(I_C, m[0], c, a, M_A);
    chasles_inertia_dyad_sym6_batch(11, I_C, 0, m, 0, c, 0, a, 0, M_A_batch, 36);
    compare("chasles_inertia_dyad_sym6, vector 2: M_A", 36, M_A, M_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_dyad_sym6, vector 2, first of a batch: M_A", 36, M_A_batch, M_A_expected, 8.0 * DBL_EPSILON);
    compare("chasles_inertia_dyad_sym6, vector 2, last: M_A", 36, M_A_batch + 360, M_A_expected, 8.0 * DBL_EPSILON);
}

static void inertia_dyad_sym6_vector_1f(void)
{
    const float I_C[6] = {1.25f, 0.5f, -0.75f, 2.0f, -1.5f, 0.25f};
    const float m[1] = {1.75f};
    const float c[3] = {-0.5f, 0.75f, -1.25f};
    const float a[3] = {1.5f, 1.25f, 0.5f};
    const double M_A_expected[36] = {
        7.046875,
        -1.25,
        -6.875,
        0.0,
        3.0625,
        -0.875,
        -1.25,
        14.359375,
        -3.03125,
        -3.0625,
        0.0,
        3.5,
        -6.875,
        -3.03125,
        7.6875,
        0.875,
        -3.5,
        0.0,
        0.0,
        -3.0625,
        0.875,
        1.75,
        0.0,
        0.0,
        3.0625,
        0.0,
        -3.5,
        0.0,
        1.75,
        0.0,
        -0.875,
        3.5,
        0.0,
        0.0,
        0.0,
        1.75,
    };
    float M_A[36], M_A_batch[396];
    chasles_inertia_dyad_sym6f(I_C, m[0], c, a, M_A);
    chasles_inertia_dyad_sym6_batchf(11, I_C, 0, m, 0, c, 0, a, 0, M_A_batch, 36);
    comparef("chasles_inertia_dyad_sym6f, vector 1: M_A", 36, M_A, M_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_dyad_sym6f, vector 1, first of a batch: M_A", 36, M_A_batch, M_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_dyad_sym6f, vector 1, last: M_A", 36, M_A_batch + 360, M_A_expected, 8.0 * FLT_EPSILON);
}

static void inertia_dyad_sym6_vector_2f(void)
{
    const float I_C[6] = {2.0f, -1.5f, 0.25f, 1.75f, -0.5f, 0.75f};
    const float m[1] = {-1.25f};
    const float c[3] = {1.5f, 1.25f, 0.5f};
    const float a[3] = {-0.75f, 2.0f, -1.5f};
    const double M_A_expected[36] = {
        -3.703125,
        -3.609375,
        5.875,
        0.0,
        2.5,
        0.9375,
        -3.609375,
        -9.578125,
        -2.375,
        -2.5,
        0.0,
        2.8125,
        5.875,
        -2.375,
        -6.28125,
        -0.9375,
        -2.8125,
        0.0,
        0.0,
        -2.5,
        -0.9375,
        -1.25,
        0.0,
        0.0,
        2.5,
        0.0,
        -2.8125,
        0.0,
        -1.25,
        0.0,
        0.9375,
        2.8125,
        0.0,
        0.0,
        0.0,
        -1.25,
    };
    float M_A[36], M_A_batch[396];
    chasles_inertia_dyad_sym6f(I_C, m[0], c, a, M_A);
    chasles_inertia_dyad_sym6_batchf(11, I_C, 0, m, 0, c, 0, a, 0, M_A_batch, 36);
    comparef("chasles_inertia_dyad_sym6f, vector 2: M_A", 36, M_A, M_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_dyad_sym6f, vector 2, first of a batch: M_A", 36, M_A_batch, M_A_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_inertia_dyad_sym6f, vector 2, last: M_A", 36, M_A_batch + 360, M_A_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_xyx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double Q_expected[9] = {
        0.87758256189037271612,
        -0.32679502965768805935,
        0.35079033005053164238,
        0.45496746226165648835,
        0.7983950426084577951,
        -0.39442358476823751035,
        -0.151173593425301366,
        0.50573744623991374325,
        0.84933867221598477972,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_xyx(angles, Q);
    chasles_rotation_from_euler_xyx_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_xyx, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xyx, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xyx, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_xyx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double Q_expected[9] = {
        0.070737201667702910088,
        -0.24678420902238037792,
        -0.96648528311476155654,
        -0.90701962459058452691,
        -0.41912314771007518991,
        0.040634808491656591945,
        -0.4151043831469114242,
        0.87374672602007303051,
        -0.25348571924553381714,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_xyx(angles, Q);
    chasles_rotation_from_euler_xyx_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_xyx, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xyx, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xyx, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_xyx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double Q_expected[9] = {
        0.87758256189037271612,
        -0.32679502965768805935,
        0.35079033005053164238,
        0.45496746226165648835,
        0.7983950426084577951,
        -0.39442358476823751035,
        -0.151173593425301366,
        0.50573744623991374325,
        0.84933867221598477972,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_xyxf(angles, Q);
    chasles_rotation_from_euler_xyx_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_xyxf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xyxf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xyxf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_xyx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double Q_expected[9] = {
        0.070737201667702910088,
        -0.24678420902238037792,
        -0.96648528311476155654,
        -0.90701962459058452691,
        -0.41912314771007518991,
        0.040634808491656591945,
        -0.4151043831469114242,
        0.87374672602007303051,
        -0.25348571924553381714,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_xyxf(angles, Q);
    chasles_rotation_from_euler_xyx_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_xyxf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xyxf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xyxf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_xyx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_expected[9] = {
        1.0,
        0.0,
        0.87758256189037271612,
        0.0,
        0.31532236239526866545,
        0.45496746226165648835,
        0.0,
        0.94898461935558621435,
        -0.151173593425301366,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_xyx(angles, W);
    chasles_euler_rate_matrix_xyx_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_xyx, vector 1: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xyx, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xyx, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_xyx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_expected[9] = {
        1.0,
        0.0,
        0.070737201667702910088,
        0.0,
        -0.416146836547142387,
        -0.90701962459058452691,
        0.0,
        0.9092974268256816954,
        -0.4151043831469114242,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_xyx(angles, W);
    chasles_euler_rate_matrix_xyx_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_xyx, vector 2: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xyx, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xyx, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_xyx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_expected[9] = {
        1.0,
        0.0,
        0.87758256189037271612,
        0.0,
        0.31532236239526866545,
        0.45496746226165648835,
        0.0,
        0.94898461935558621435,
        -0.151173593425301366,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_xyxf(angles, W);
    chasles_euler_rate_matrix_xyx_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_xyxf, vector 1: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xyxf, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xyxf, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_xyx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_expected[9] = {
        1.0,
        0.0,
        0.070737201667702910088,
        0.0,
        -0.416146836547142387,
        -0.90701962459058452691,
        0.0,
        0.9092974268256816954,
        -0.4151043831469114242,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_xyxf(angles, W);
    chasles_euler_rate_matrix_xyx_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_xyxf, vector 2: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xyxf, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xyxf, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_xyx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_body_expected[9] = {
        0.87758256189037271612,
        0.0,
        1.0,
        -0.32679502965768805935,
        0.73168886887382088631,
        0.0,
        0.35079033005053164238,
        0.68163876002333416673,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xyx(angles, W_body);
    chasles_euler_rate_matrix_body_xyx_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_xyx, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xyx, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xyx, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_xyx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_body_expected[9] = {
        0.070737201667702910088,
        0.0,
        1.0,
        -0.24678420902238037792,
        0.96891242171064478414,
        0.0,
        -0.96648528311476155654,
        -0.2474039592545229296,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xyx(angles, W_body);
    chasles_euler_rate_matrix_body_xyx_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_xyx, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xyx, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xyx, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_xyx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_body_expected[9] = {
        0.87758256189037271612,
        0.0,
        1.0,
        -0.32679502965768805935,
        0.73168886887382088631,
        0.0,
        0.35079033005053164238,
        0.68163876002333416673,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xyxf(angles, W_body);
    chasles_euler_rate_matrix_body_xyx_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_xyxf, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xyxf, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xyxf, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_xyx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_body_expected[9] = {
        0.070737201667702910088,
        0.0,
        1.0,
        -0.24678420902238037792,
        0.96891242171064478414,
        0.0,
        -0.96648528311476155654,
        -0.2474039592545229296,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xyxf(angles, W_body);
    chasles_euler_rate_matrix_body_xyx_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_xyxf, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xyxf, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xyxf, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_xyx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double omega[3] = {2.0, -1.5, 0.25};
    const double theta_dot_expected[3] = {
        4.749955468923023983,
        -0.23573738875400644458,
        -3.133557557250718693,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xyx(angles, omega, theta_dot);
    chasles_euler_rates_xyx_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_xyx, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xyx, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xyx, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_xyx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double omega[3] = {1.75, -0.5, 0.75};
    const double theta_dot_expected[3] = {
        1.7398918983665136074,
        0.89004648839283246505,
        0.14289654375883425947,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xyx(angles, omega, theta_dot);
    chasles_euler_rates_xyx_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_xyx, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xyx, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xyx, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_xyx_vector_3(void)
{
    const double angles[3] = {0.0, 0.0, 0.0};
    const double omega[3] = {0.0, 0.0, 0.0};
    const double theta_dot_expected[3] = {NAN, 0.0, NAN};
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xyx(angles, omega, theta_dot);
    chasles_euler_rates_xyx_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_xyx, vector 3: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xyx, vector 3, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xyx, vector 3, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_xyx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const double theta_dot_expected[3] = {
        4.749955468923023983,
        -0.23573738875400644458,
        -3.133557557250718693,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xyxf(angles, omega, theta_dot);
    chasles_euler_rates_xyx_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_xyxf, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xyxf, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xyxf, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_xyx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const float omega[3] = {1.75f, -0.5f, 0.75f};
    const double theta_dot_expected[3] = {
        1.7398918983665136074,
        0.89004648839283246505,
        0.14289654375883425947,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xyxf(angles, omega, theta_dot);
    chasles_euler_rates_xyx_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_xyxf, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xyxf, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xyxf, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_xyx_vector_3f(void)
{
    const float angles[3] = {0.0f, 0.0f, 0.0f};
    const float omega[3] = {0.0f, 0.0f, 0.0f};
    const double theta_dot_expected[3] = {NAN, 0.0, NAN};
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xyxf(angles, omega, theta_dot);
    chasles_euler_rates_xyx_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_xyxf, vector 3: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xyxf, vector 3, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xyxf, vector 3, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_xyz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double Q_expected[9] = {
        0.6421173920529567248,
        0.59819428930505457197,
        0.47942553860420300027,
        0.11795868372588487932,
        0.54084131949861377544,
        -0.83281235344863553273,
        -0.757476734795707194,
        0.59131570194424826225,
        0.27672140661216439796,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_xyz(angles, Q);
    chasles_rotation_from_euler_xyz_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_xyz, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xyz, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xyz, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_xyz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double Q_expected[9] = {
        0.068538153372888287532,
        -0.017500663759175342192,
        -0.99749498660405443094,
        -0.98177895599415098176,
        -0.17880959294085393151,
        -0.064321155457291576076,
        -0.17723600960095381218,
        0.98372803977538141873,
        -0.029437062700211810791,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_xyz(angles, Q);
    chasles_rotation_from_euler_xyz_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_xyz, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xyz, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xyz, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_xyz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double Q_expected[9] = {
        0.6421173920529567248,
        0.59819428930505457197,
        0.47942553860420300027,
        0.11795868372588487932,
        0.54084131949861377544,
        -0.83281235344863553273,
        -0.757476734795707194,
        0.59131570194424826225,
        0.27672140661216439796,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_xyzf(angles, Q);
    chasles_rotation_from_euler_xyz_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_xyzf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xyzf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xyzf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_xyz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double Q_expected[9] = {
        0.068538153372888287532,
        -0.017500663759175342192,
        -0.99749498660405443094,
        -0.98177895599415098176,
        -0.17880959294085393151,
        -0.064321155457291576076,
        -0.17723600960095381218,
        0.98372803977538141873,
        -0.029437062700211810791,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_xyzf(angles, Q);
    chasles_rotation_from_euler_xyz_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_xyzf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xyzf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xyzf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_xyz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_expected[9] = {
        1.0,
        0.0,
        0.47942553860420300027,
        0.0,
        0.31532236239526866545,
        -0.83281235344863553273,
        0.0,
        0.94898461935558621435,
        0.27672140661216439796,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_xyz(angles, W);
    chasles_euler_rate_matrix_xyz_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_xyz, vector 1: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xyz, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xyz, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_xyz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_expected[9] = {
        1.0,
        0.0,
        -0.99749498660405443094,
        0.0,
        -0.416146836547142387,
        -0.064321155457291576076,
        0.0,
        0.9092974268256816954,
        -0.029437062700211810791,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_xyz(angles, W);
    chasles_euler_rate_matrix_xyz_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_xyz, vector 2: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xyz, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xyz, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_xyz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_expected[9] = {
        1.0,
        0.0,
        0.47942553860420300027,
        0.0,
        0.31532236239526866545,
        -0.83281235344863553273,
        0.0,
        0.94898461935558621435,
        0.27672140661216439796,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_xyzf(angles, W);
    chasles_euler_rate_matrix_xyz_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_xyzf, vector 1: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xyzf, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xyzf, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_xyz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_expected[9] = {
        1.0,
        0.0,
        -0.99749498660405443094,
        0.0,
        -0.416146836547142387,
        -0.064321155457291576076,
        0.0,
        0.9092974268256816954,
        -0.029437062700211810791,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_xyzf(angles, W);
    chasles_euler_rate_matrix_xyz_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_xyzf, vector 2: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xyzf, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xyzf, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_xyz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_body_expected[9] = {
        0.6421173920529567248,
        -0.68163876002333416673,
        0.0,
        0.59819428930505457197,
        0.73168886887382088631,
        0.0,
        0.47942553860420300027,
        0.0,
        1.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xyz(angles, W_body);
    chasles_euler_rate_matrix_body_xyz_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_xyz, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xyz, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xyz, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_xyz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_body_expected[9] = {
        0.068538153372888287532,
        0.2474039592545229296,
        0.0,
        -0.017500663759175342192,
        0.96891242171064478414,
        0.0,
        -0.99749498660405443094,
        0.0,
        1.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xyz(angles, W_body);
    chasles_euler_rate_matrix_body_xyz_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_xyz, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xyz, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xyz, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_xyz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_body_expected[9] = {
        0.6421173920529567248,
        -0.68163876002333416673,
        0.0,
        0.59819428930505457197,
        0.73168886887382088631,
        0.0,
        0.47942553860420300027,
        0.0,
        1.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xyzf(angles, W_body);
    chasles_euler_rate_matrix_body_xyz_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_xyzf, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xyzf, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xyzf, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_xyz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_body_expected[9] = {
        0.068538153372888287532,
        0.2474039592545229296,
        0.0,
        -0.017500663759175342192,
        0.96891242171064478414,
        0.0,
        -0.99749498660405443094,
        0.0,
        1.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xyzf(angles, W_body);
    chasles_euler_rate_matrix_body_xyz_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_xyzf, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xyzf, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xyzf, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_xyz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double omega[3] = {2.0, -1.5, 0.25};
    const double theta_dot_expected[3] = {
        1.1792856615138818611,
        -0.23573738875400644458,
        1.7118702955948937586,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xyz(angles, omega, theta_dot);
    chasles_euler_rates_xyz_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_xyz, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xyz, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xyz, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_xyz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double omega[3] = {1.75, -0.5, 0.75};
    const double theta_dot_expected[3] = {
        3.759996459897080318,
        0.89004648839283246505,
        2.0150441725427218909,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xyz(angles, omega, theta_dot);
    chasles_euler_rates_xyz_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_xyz, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xyz, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xyz, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_xyz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const double theta_dot_expected[3] = {
        1.1792856615138818611,
        -0.23573738875400644458,
        1.7118702955948937586,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xyzf(angles, omega, theta_dot);
    chasles_euler_rates_xyz_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_xyzf, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xyzf, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xyzf, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_xyz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const float omega[3] = {1.75f, -0.5f, 0.75f};
    const double theta_dot_expected[3] = {
        3.759996459897080318,
        0.89004648839283246505,
        2.0150441725427218909,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xyzf(angles, omega, theta_dot);
    chasles_euler_rates_xyz_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_xyzf, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xyzf, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xyzf, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_xzx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double Q_expected[9] = {
        0.87758256189037271612,
        -0.35079033005053164238,
        -0.32679502965768805935,
        0.151173593425301366,
        0.84933867221598477972,
        -0.50573744623991374325,
        0.45496746226165648835,
        0.39442358476823751035,
        0.7983950426084577951,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_xzx(angles, Q);
    chasles_rotation_from_euler_xzx_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_xzx, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xzx, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xzx, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_xzx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double Q_expected[9] = {
        0.070737201667702910088,
        0.96648528311476155654,
        -0.24678420902238037792,
        0.4151043831469114242,
        -0.25348571924553381714,
        -0.87374672602007303051,
        -0.90701962459058452691,
        -0.040634808491656591945,
        -0.41912314771007518991,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_xzx(angles, Q);
    chasles_rotation_from_euler_xzx_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_xzx, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xzx, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xzx, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_xzx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double Q_expected[9] = {
        0.87758256189037271612,
        -0.35079033005053164238,
        -0.32679502965768805935,
        0.151173593425301366,
        0.84933867221598477972,
        -0.50573744623991374325,
        0.45496746226165648835,
        0.39442358476823751035,
        0.7983950426084577951,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_xzxf(angles, Q);
    chasles_rotation_from_euler_xzx_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_xzxf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xzxf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xzxf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_xzx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double Q_expected[9] = {
        0.070737201667702910088,
        0.96648528311476155654,
        -0.24678420902238037792,
        0.4151043831469114242,
        -0.25348571924553381714,
        -0.87374672602007303051,
        -0.90701962459058452691,
        -0.040634808491656591945,
        -0.41912314771007518991,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_xzxf(angles, Q);
    chasles_rotation_from_euler_xzx_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_xzxf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xzxf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xzxf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_xzx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_expected[9] = {
        1.0,
        0.0,
        0.87758256189037271612,
        0.0,
        -0.94898461935558621435,
        0.151173593425301366,
        0.0,
        0.31532236239526866545,
        0.45496746226165648835,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_xzx(angles, W);
    chasles_euler_rate_matrix_xzx_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_xzx, vector 1: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xzx, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xzx, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_xzx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_expected[9] = {
        1.0,
        0.0,
        0.070737201667702910088,
        0.0,
        -0.9092974268256816954,
        0.4151043831469114242,
        0.0,
        -0.416146836547142387,
        -0.90701962459058452691,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_xzx(angles, W);
    chasles_euler_rate_matrix_xzx_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_xzx, vector 2: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xzx, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xzx, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_xzx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_expected[9] = {
        1.0,
        0.0,
        0.87758256189037271612,
        0.0,
        -0.94898461935558621435,
        0.151173593425301366,
        0.0,
        0.31532236239526866545,
        0.45496746226165648835,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_xzxf(angles, W);
    chasles_euler_rate_matrix_xzx_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_xzxf, vector 1: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xzxf, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xzxf, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_xzx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_expected[9] = {
        1.0,
        0.0,
        0.070737201667702910088,
        0.0,
        -0.9092974268256816954,
        0.4151043831469114242,
        0.0,
        -0.416146836547142387,
        -0.90701962459058452691,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_xzxf(angles, W);
    chasles_euler_rate_matrix_xzx_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_xzxf, vector 2: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xzxf, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xzxf, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_xzx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_body_expected[9] = {
        0.87758256189037271612,
        0.0,
        1.0,
        -0.35079033005053164238,
        -0.68163876002333416673,
        0.0,
        -0.32679502965768805935,
        0.73168886887382088631,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xzx(angles, W_body);
    chasles_euler_rate_matrix_body_xzx_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_xzx, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xzx, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xzx, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_xzx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_body_expected[9] = {
        0.070737201667702910088,
        0.0,
        1.0,
        0.96648528311476155654,
        0.2474039592545229296,
        0.0,
        -0.24678420902238037792,
        0.96891242171064478414,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xzx(angles, W_body);
    chasles_euler_rate_matrix_body_xzx_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_xzx, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xzx, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xzx, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_xzx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_body_expected[9] = {
        0.87758256189037271612,
        0.0,
        1.0,
        -0.35079033005053164238,
        -0.68163876002333416673,
        0.0,
        -0.32679502965768805935,
        0.73168886887382088631,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xzxf(angles, W_body);
    chasles_euler_rate_matrix_body_xzx_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_xzxf, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xzxf, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xzxf, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_xzx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_body_expected[9] = {
        0.070737201667702910088,
        0.0,
        1.0,
        0.96648528311476155654,
        0.2474039592545229296,
        0.0,
        -0.24678420902238037792,
        0.96891242171064478414,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xzxf(angles, W_body);
    chasles_euler_rate_matrix_body_xzx_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_xzxf, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xzxf, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xzxf, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_xzx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double omega[3] = {2.0, -1.5, 0.25};
    const double theta_dot_expected[3] = {
        2.4315143956627638414,
        1.5023075196321964879,
        -0.49170803341084215572,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xzx(angles, omega, theta_dot);
    chasles_euler_rates_xzx_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_xzx, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xzx, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xzx, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_xzx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double omega[3] = {1.75, -0.5, 0.75};
    const double theta_dot_expected[3] = {
        1.8131175081465002742,
        0.14253858600248405745,
        -0.89228166591891597849,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xzx(angles, omega, theta_dot);
    chasles_euler_rates_xzx_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_xzx, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xzx, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xzx, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_xzx_vector_3(void)
{
    const double angles[3] = {0.0, 0.0, 0.0};
    const double omega[3] = {0.0, 0.0, 0.0};
    const double theta_dot_expected[3] = {NAN, 0.0, NAN};
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xzx(angles, omega, theta_dot);
    chasles_euler_rates_xzx_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_xzx, vector 3: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xzx, vector 3, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xzx, vector 3, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_xzx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const double theta_dot_expected[3] = {
        2.4315143956627638414,
        1.5023075196321964879,
        -0.49170803341084215572,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xzxf(angles, omega, theta_dot);
    chasles_euler_rates_xzx_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_xzxf, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xzxf, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xzxf, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_xzx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const float omega[3] = {1.75f, -0.5f, 0.75f};
    const double theta_dot_expected[3] = {
        1.8131175081465002742,
        0.14253858600248405745,
        -0.89228166591891597849,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xzxf(angles, omega, theta_dot);
    chasles_euler_rates_xzx_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_xzxf, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xzxf, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xzxf, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_xzx_vector_3f(void)
{
    const float angles[3] = {0.0f, 0.0f, 0.0f};
    const float omega[3] = {0.0f, 0.0f, 0.0f};
    const double theta_dot_expected[3] = {NAN, 0.0, NAN};
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xzxf(angles, omega, theta_dot);
    chasles_euler_rates_xzx_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_xzxf, vector 3: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xzxf, vector 3, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xzxf, vector 3, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_xzy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double Q_expected[9] = {
        0.6421173920529567248,
        -0.47942553860420300027,
        -0.59819428930505457197,
        -0.53625266364180790912,
        0.27672140661216439796,
        -0.79740726348563643342,
        0.54783057194736357444,
        0.83281235344863553273,
        -0.079405594155383446326,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_xzy(angles, Q);
    chasles_rotation_from_euler_xzy_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_xzy, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xzy, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xzy, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_xzy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double Q_expected[9] = {
        0.068538153372888287532,
        0.99749498660405443094,
        0.017500663759175342192,
        0.62716357667420081072,
        -0.029437062700211810791,
        -0.77833110398647672142,
        -0.77586620600813532444,
        0.064321155457291576076,
        -0.62761008543137724778,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_xzy(angles, Q);
    chasles_rotation_from_euler_xzy_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_xzy, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xzy, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_xzy, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_xzy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double Q_expected[9] = {
        0.6421173920529567248,
        -0.47942553860420300027,
        -0.59819428930505457197,
        -0.53625266364180790912,
        0.27672140661216439796,
        -0.79740726348563643342,
        0.54783057194736357444,
        0.83281235344863553273,
        -0.079405594155383446326,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_xzyf(angles, Q);
    chasles_rotation_from_euler_xzy_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_xzyf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xzyf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xzyf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_xzy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double Q_expected[9] = {
        0.068538153372888287532,
        0.99749498660405443094,
        0.017500663759175342192,
        0.62716357667420081072,
        -0.029437062700211810791,
        -0.77833110398647672142,
        -0.77586620600813532444,
        0.064321155457291576076,
        -0.62761008543137724778,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_xzyf(angles, Q);
    chasles_rotation_from_euler_xzy_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_xzyf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xzyf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_xzyf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_xzy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_expected[9] = {
        1.0,
        0.0,
        -0.47942553860420300027,
        0.0,
        -0.94898461935558621435,
        0.27672140661216439796,
        0.0,
        0.31532236239526866545,
        0.83281235344863553273,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_xzy(angles, W);
    chasles_euler_rate_matrix_xzy_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_xzy, vector 1: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xzy, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xzy, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_xzy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_expected[9] = {
        1.0,
        0.0,
        0.99749498660405443094,
        0.0,
        -0.9092974268256816954,
        -0.029437062700211810791,
        0.0,
        -0.416146836547142387,
        0.064321155457291576076,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_xzy(angles, W);
    chasles_euler_rate_matrix_xzy_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_xzy, vector 2: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xzy, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_xzy, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_xzy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_expected[9] = {
        1.0,
        0.0,
        -0.47942553860420300027,
        0.0,
        -0.94898461935558621435,
        0.27672140661216439796,
        0.0,
        0.31532236239526866545,
        0.83281235344863553273,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_xzyf(angles, W);
    chasles_euler_rate_matrix_xzy_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_xzyf, vector 1: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xzyf, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xzyf, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_xzy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_expected[9] = {
        1.0,
        0.0,
        0.99749498660405443094,
        0.0,
        -0.9092974268256816954,
        -0.029437062700211810791,
        0.0,
        -0.416146836547142387,
        0.064321155457291576076,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_xzyf(angles, W);
    chasles_euler_rate_matrix_xzy_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_xzyf, vector 2: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xzyf, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_xzyf, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_xzy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_body_expected[9] = {
        0.6421173920529567248,
        0.68163876002333416673,
        0.0,
        -0.47942553860420300027,
        0.0,
        1.0,
        -0.59819428930505457197,
        0.73168886887382088631,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xzy(angles, W_body);
    chasles_euler_rate_matrix_body_xzy_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_xzy, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xzy, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xzy, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_xzy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_body_expected[9] = {
        0.068538153372888287532,
        -0.2474039592545229296,
        0.0,
        0.99749498660405443094,
        0.0,
        1.0,
        0.017500663759175342192,
        0.96891242171064478414,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xzy(angles, W_body);
    chasles_euler_rate_matrix_body_xzy_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_xzy, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xzy, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_xzy, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_xzy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_body_expected[9] = {
        0.6421173920529567248,
        0.68163876002333416673,
        0.0,
        -0.47942553860420300027,
        0.0,
        1.0,
        -0.59819428930505457197,
        0.73168886887382088631,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xzyf(angles, W_body);
    chasles_euler_rate_matrix_body_xzy_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_xzyf, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xzyf, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xzyf, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_xzy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_body_expected[9] = {
        0.068538153372888287532,
        -0.2474039592545229296,
        0.0,
        0.99749498660405443094,
        0.0,
        1.0,
        0.017500663759175342192,
        0.96891242171064478414,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_xzyf(angles, W_body);
    chasles_euler_rate_matrix_body_xzy_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_xzyf, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xzyf, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_xzyf, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_xzy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double omega[3] = {2.0, -1.5, 0.25};
    const double theta_dot_expected[3] = {
        1.8712160775744126984,
        1.5023075196321964879,
        -0.26862132292853680314,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xzy(angles, omega, theta_dot);
    chasles_euler_rates_xzy_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_xzy, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xzy, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xzy, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_xzy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double omega[3] = {1.75, -0.5, 0.75};
    const double theta_dot_expected[3] = {
        -10.800919305332829932,
        0.14253858600248405745,
        12.582438482284613925,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xzy(angles, omega, theta_dot);
    chasles_euler_rates_xzy_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_xzy, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xzy, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_xzy, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_xzy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const double theta_dot_expected[3] = {
        1.8712160775744126984,
        1.5023075196321964879,
        -0.26862132292853680314,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xzyf(angles, omega, theta_dot);
    chasles_euler_rates_xzy_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_xzyf, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xzyf, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xzyf, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_xzy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const float omega[3] = {1.75f, -0.5f, 0.75f};
    const double theta_dot_expected[3] = {
        -10.800919305332829932,
        0.14253858600248405745,
        12.582438482284613925,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_xzyf(angles, omega, theta_dot);
    chasles_euler_rates_xzy_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_xzyf, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xzyf, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_xzyf, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_yxy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double Q_expected[9] = {
        0.7983950426084577951,
        0.45496746226165648835,
        0.39442358476823751035,
        -0.32679502965768805935,
        0.87758256189037271612,
        -0.35079033005053164238,
        -0.50573744623991374325,
        0.151173593425301366,
        0.84933867221598477972,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_yxy(angles, Q);
    chasles_rotation_from_euler_yxy_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_yxy, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yxy, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yxy, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_yxy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double Q_expected[9] = {
        -0.41912314771007518991,
        -0.90701962459058452691,
        -0.040634808491656591945,
        -0.24678420902238037792,
        0.070737201667702910088,
        0.96648528311476155654,
        -0.87374672602007303051,
        0.4151043831469114242,
        -0.25348571924553381714,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_yxy(angles, Q);
    chasles_rotation_from_euler_yxy_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_yxy, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yxy, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yxy, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_yxy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double Q_expected[9] = {
        0.7983950426084577951,
        0.45496746226165648835,
        0.39442358476823751035,
        -0.32679502965768805935,
        0.87758256189037271612,
        -0.35079033005053164238,
        -0.50573744623991374325,
        0.151173593425301366,
        0.84933867221598477972,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_yxyf(angles, Q);
    chasles_rotation_from_euler_yxy_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_yxyf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yxyf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yxyf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_yxy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double Q_expected[9] = {
        -0.41912314771007518991,
        -0.90701962459058452691,
        -0.040634808491656591945,
        -0.24678420902238037792,
        0.070737201667702910088,
        0.96648528311476155654,
        -0.87374672602007303051,
        0.4151043831469114242,
        -0.25348571924553381714,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_yxyf(angles, Q);
    chasles_rotation_from_euler_yxy_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_yxyf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yxyf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yxyf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_yxy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_expected[9] = {
        0.0,
        0.31532236239526866545,
        0.45496746226165648835,
        1.0,
        0.0,
        0.87758256189037271612,
        0.0,
        -0.94898461935558621435,
        0.151173593425301366,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_yxy(angles, W);
    chasles_euler_rate_matrix_yxy_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_yxy, vector 1: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yxy, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yxy, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_yxy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_expected[9] = {
        0.0,
        -0.416146836547142387,
        -0.90701962459058452691,
        1.0,
        0.0,
        0.070737201667702910088,
        0.0,
        -0.9092974268256816954,
        0.4151043831469114242,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_yxy(angles, W);
    chasles_euler_rate_matrix_yxy_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_yxy, vector 2: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yxy, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yxy, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_yxy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_expected[9] = {
        0.0,
        0.31532236239526866545,
        0.45496746226165648835,
        1.0,
        0.0,
        0.87758256189037271612,
        0.0,
        -0.94898461935558621435,
        0.151173593425301366,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_yxyf(angles, W);
    chasles_euler_rate_matrix_yxy_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_yxyf, vector 1: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yxyf, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yxyf, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_yxy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_expected[9] = {
        0.0,
        -0.416146836547142387,
        -0.90701962459058452691,
        1.0,
        0.0,
        0.070737201667702910088,
        0.0,
        -0.9092974268256816954,
        0.4151043831469114242,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_yxyf(angles, W);
    chasles_euler_rate_matrix_yxy_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_yxyf, vector 2: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yxyf, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yxyf, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_yxy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_body_expected[9] = {
        -0.32679502965768805935,
        0.73168886887382088631,
        0.0,
        0.87758256189037271612,
        0.0,
        1.0,
        -0.35079033005053164238,
        -0.68163876002333416673,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yxy(angles, W_body);
    chasles_euler_rate_matrix_body_yxy_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_yxy, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yxy, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yxy, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_yxy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_body_expected[9] = {
        -0.24678420902238037792,
        0.96891242171064478414,
        0.0,
        0.070737201667702910088,
        0.0,
        1.0,
        0.96648528311476155654,
        0.2474039592545229296,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yxy(angles, W_body);
    chasles_euler_rate_matrix_body_yxy_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_yxy, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yxy, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yxy, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_yxy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_body_expected[9] = {
        -0.32679502965768805935,
        0.73168886887382088631,
        0.0,
        0.87758256189037271612,
        0.0,
        1.0,
        -0.35079033005053164238,
        -0.68163876002333416673,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yxyf(angles, W_body);
    chasles_euler_rate_matrix_body_yxy_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_yxyf, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yxyf, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yxyf, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_yxy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_body_expected[9] = {
        -0.24678420902238037792,
        0.96891242171064478414,
        0.0,
        0.070737201667702910088,
        0.0,
        1.0,
        0.96648528311476155654,
        0.2474039592545229296,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yxyf(angles, W_body);
    chasles_euler_rate_matrix_body_yxy_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_yxyf, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yxyf, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yxyf, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_yxy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double omega[3] = {2.0, -1.5, 0.25};
    const double theta_dot_expected[3] = {
        -5.1185078158352066888,
        0.39339856995164077731,
        4.1232676821206359904,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yxy(angles, omega, theta_dot);
    chasles_euler_rates_yxy_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_yxy, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yxy, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yxy, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_yxy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double omega[3] = {1.75, -0.5, 0.75};
    const double theta_dot_expected[3] = {
        -0.40928854155633145044,
        -1.4102300340767604488,
        -1.2823727304028405881,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yxy(angles, omega, theta_dot);
    chasles_euler_rates_yxy_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_yxy, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yxy, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yxy, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_yxy_vector_3(void)
{
    const double angles[3] = {0.0, 0.0, 0.0};
    const double omega[3] = {0.0, 0.0, 0.0};
    const double theta_dot_expected[3] = {NAN, 0.0, NAN};
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yxy(angles, omega, theta_dot);
    chasles_euler_rates_yxy_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_yxy, vector 3: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yxy, vector 3, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yxy, vector 3, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_yxy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const double theta_dot_expected[3] = {
        -5.1185078158352066888,
        0.39339856995164077731,
        4.1232676821206359904,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yxyf(angles, omega, theta_dot);
    chasles_euler_rates_yxy_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_yxyf, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yxyf, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yxyf, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_yxy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const float omega[3] = {1.75f, -0.5f, 0.75f};
    const double theta_dot_expected[3] = {
        -0.40928854155633145044,
        -1.4102300340767604488,
        -1.2823727304028405881,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yxyf(angles, omega, theta_dot);
    chasles_euler_rates_yxy_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_yxyf, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yxyf, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yxyf, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_yxy_vector_3f(void)
{
    const float angles[3] = {0.0f, 0.0f, 0.0f};
    const float omega[3] = {0.0f, 0.0f, 0.0f};
    const double theta_dot_expected[3] = {NAN, 0.0, NAN};
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yxyf(angles, omega, theta_dot);
    chasles_euler_rates_yxy_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_yxyf, vector 3: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yxyf, vector 3, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yxyf, vector 3, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_yxz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double Q_expected[9] = {
        -0.079405594155383446326,
        0.54783057194736357444,
        0.83281235344863553273,
        -0.59819428930505457197,
        0.6421173920529567248,
        -0.47942553860420300027,
        -0.79740726348563643342,
        -0.53625266364180790912,
        0.27672140661216439796,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_yxz(angles, Q);
    chasles_rotation_from_euler_yxz_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_yxz, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yxz, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yxz, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_yxz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double Q_expected[9] = {
        -0.62761008543137724778,
        -0.77586620600813532444,
        0.064321155457291576076,
        0.017500663759175342192,
        0.068538153372888287532,
        0.99749498660405443094,
        -0.77833110398647672142,
        0.62716357667420081072,
        -0.029437062700211810791,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_yxz(angles, Q);
    chasles_rotation_from_euler_yxz_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_yxz, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yxz, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yxz, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_yxz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double Q_expected[9] = {
        -0.079405594155383446326,
        0.54783057194736357444,
        0.83281235344863553273,
        -0.59819428930505457197,
        0.6421173920529567248,
        -0.47942553860420300027,
        -0.79740726348563643342,
        -0.53625266364180790912,
        0.27672140661216439796,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_yxzf(angles, Q);
    chasles_rotation_from_euler_yxz_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_yxzf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yxzf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yxzf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_yxz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double Q_expected[9] = {
        -0.62761008543137724778,
        -0.77586620600813532444,
        0.064321155457291576076,
        0.017500663759175342192,
        0.068538153372888287532,
        0.99749498660405443094,
        -0.77833110398647672142,
        0.62716357667420081072,
        -0.029437062700211810791,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_yxzf(angles, Q);
    chasles_rotation_from_euler_yxz_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_yxzf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yxzf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yxzf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_yxz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_expected[9] = {
        0.0,
        0.31532236239526866545,
        0.83281235344863553273,
        1.0,
        0.0,
        -0.47942553860420300027,
        0.0,
        -0.94898461935558621435,
        0.27672140661216439796,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_yxz(angles, W);
    chasles_euler_rate_matrix_yxz_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_yxz, vector 1: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yxz, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yxz, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_yxz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_expected[9] = {
        0.0,
        -0.416146836547142387,
        0.064321155457291576076,
        1.0,
        0.0,
        0.99749498660405443094,
        0.0,
        -0.9092974268256816954,
        -0.029437062700211810791,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_yxz(angles, W);
    chasles_euler_rate_matrix_yxz_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_yxz, vector 2: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yxz, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yxz, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_yxz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_expected[9] = {
        0.0,
        0.31532236239526866545,
        0.83281235344863553273,
        1.0,
        0.0,
        -0.47942553860420300027,
        0.0,
        -0.94898461935558621435,
        0.27672140661216439796,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_yxzf(angles, W);
    chasles_euler_rate_matrix_yxz_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_yxzf, vector 1: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yxzf, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yxzf, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_yxz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_expected[9] = {
        0.0,
        -0.416146836547142387,
        0.064321155457291576076,
        1.0,
        0.0,
        0.99749498660405443094,
        0.0,
        -0.9092974268256816954,
        -0.029437062700211810791,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_yxzf(angles, W);
    chasles_euler_rate_matrix_yxz_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_yxzf, vector 2: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yxzf, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yxzf, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_yxz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_body_expected[9] = {
        -0.59819428930505457197,
        0.73168886887382088631,
        0.0,
        0.6421173920529567248,
        0.68163876002333416673,
        0.0,
        -0.47942553860420300027,
        0.0,
        1.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yxz(angles, W_body);
    chasles_euler_rate_matrix_body_yxz_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_yxz, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yxz, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yxz, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_yxz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_body_expected[9] = {
        0.017500663759175342192,
        0.96891242171064478414,
        0.0,
        0.068538153372888287532,
        -0.2474039592545229296,
        0.0,
        0.99749498660405443094,
        0.0,
        1.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yxz(angles, W_body);
    chasles_euler_rate_matrix_body_yxz_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_yxz, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yxz, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yxz, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_yxz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_body_expected[9] = {
        -0.59819428930505457197,
        0.73168886887382088631,
        0.0,
        0.6421173920529567248,
        0.68163876002333416673,
        0.0,
        -0.47942553860420300027,
        0.0,
        1.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yxzf(angles, W_body);
    chasles_euler_rate_matrix_body_yxz_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_yxzf, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yxzf, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yxzf, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_yxz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_body_expected[9] = {
        0.017500663759175342192,
        0.96891242171064478414,
        0.0,
        0.068538153372888287532,
        -0.2474039592545229296,
        0.0,
        0.99749498660405443094,
        0.0,
        1.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yxzf(angles, W_body);
    chasles_euler_rate_matrix_body_yxz_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_yxzf, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yxzf, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yxzf, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_yxz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double omega[3] = {2.0, -1.5, 0.25};
    const double theta_dot_expected[3] = {
        -0.42006933132517258908,
        0.39339856995164077731,
        2.2525514010349383936,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yxz(angles, omega, theta_dot);
    chasles_euler_rates_yxz_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_yxz, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yxz, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yxz, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_yxz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double omega[3] = {1.75, -0.5, 0.75};
    const double theta_dot_expected[3] = {
        -18.537977550586561254,
        -1.4102300340767604488,
        18.083276400211677874,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yxz(angles, omega, theta_dot);
    chasles_euler_rates_yxz_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_yxz, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yxz, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yxz, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_yxz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const double theta_dot_expected[3] = {
        -0.42006933132517258908,
        0.39339856995164077731,
        2.2525514010349383936,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yxzf(angles, omega, theta_dot);
    chasles_euler_rates_yxz_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_yxzf, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yxzf, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yxzf, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_yxz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const float omega[3] = {1.75f, -0.5f, 0.75f};
    const double theta_dot_expected[3] = {
        -18.537977550586561254,
        -1.4102300340767604488,
        18.083276400211677874,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yxzf(angles, omega, theta_dot);
    chasles_euler_rates_yxz_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_yxzf, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yxzf, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yxzf, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_yzx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double Q_expected[9] = {
        0.27672140661216439796,
        -0.757476734795707194,
        0.59131570194424826225,
        0.47942553860420300027,
        0.6421173920529567248,
        0.59819428930505457197,
        -0.83281235344863553273,
        0.11795868372588487932,
        0.54084131949861377544,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_yzx(angles, Q);
    chasles_rotation_from_euler_yzx_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_yzx, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yzx, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yzx, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_yzx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double Q_expected[9] = {
        -0.029437062700211810791,
        -0.17723600960095381218,
        0.98372803977538141873,
        -0.99749498660405443094,
        0.068538153372888287532,
        -0.017500663759175342192,
        -0.064321155457291576076,
        -0.98177895599415098176,
        -0.17880959294085393151,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_yzx(angles, Q);
    chasles_rotation_from_euler_yzx_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_yzx, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yzx, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yzx, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_yzx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double Q_expected[9] = {
        0.27672140661216439796,
        -0.757476734795707194,
        0.59131570194424826225,
        0.47942553860420300027,
        0.6421173920529567248,
        0.59819428930505457197,
        -0.83281235344863553273,
        0.11795868372588487932,
        0.54084131949861377544,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_yzxf(angles, Q);
    chasles_rotation_from_euler_yzx_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_yzxf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yzxf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yzxf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_yzx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double Q_expected[9] = {
        -0.029437062700211810791,
        -0.17723600960095381218,
        0.98372803977538141873,
        -0.99749498660405443094,
        0.068538153372888287532,
        -0.017500663759175342192,
        -0.064321155457291576076,
        -0.98177895599415098176,
        -0.17880959294085393151,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_yzxf(angles, Q);
    chasles_rotation_from_euler_yzx_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_yzxf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yzxf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yzxf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_yzx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_expected[9] = {
        0.0,
        0.94898461935558621435,
        0.27672140661216439796,
        1.0,
        0.0,
        0.47942553860420300027,
        0.0,
        0.31532236239526866545,
        -0.83281235344863553273,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_yzx(angles, W);
    chasles_euler_rate_matrix_yzx_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_yzx, vector 1: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yzx, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yzx, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_yzx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_expected[9] = {
        0.0,
        0.9092974268256816954,
        -0.029437062700211810791,
        1.0,
        0.0,
        -0.99749498660405443094,
        0.0,
        -0.416146836547142387,
        -0.064321155457291576076,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_yzx(angles, W);
    chasles_euler_rate_matrix_yzx_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_yzx, vector 2: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yzx, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yzx, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_yzx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_expected[9] = {
        0.0,
        0.94898461935558621435,
        0.27672140661216439796,
        1.0,
        0.0,
        0.47942553860420300027,
        0.0,
        0.31532236239526866545,
        -0.83281235344863553273,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_yzxf(angles, W);
    chasles_euler_rate_matrix_yzx_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_yzxf, vector 1: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yzxf, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yzxf, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_yzx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_expected[9] = {
        0.0,
        0.9092974268256816954,
        -0.029437062700211810791,
        1.0,
        0.0,
        -0.99749498660405443094,
        0.0,
        -0.416146836547142387,
        -0.064321155457291576076,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_yzxf(angles, W);
    chasles_euler_rate_matrix_yzx_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_yzxf, vector 2: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yzxf, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yzxf, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_yzx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_body_expected[9] = {
        0.47942553860420300027,
        0.0,
        1.0,
        0.6421173920529567248,
        -0.68163876002333416673,
        0.0,
        0.59819428930505457197,
        0.73168886887382088631,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yzx(angles, W_body);
    chasles_euler_rate_matrix_body_yzx_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_yzx, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yzx, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yzx, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_yzx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_body_expected[9] = {
        -0.99749498660405443094,
        0.0,
        1.0,
        0.068538153372888287532,
        0.2474039592545229296,
        0.0,
        -0.017500663759175342192,
        0.96891242171064478414,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yzx(angles, W_body);
    chasles_euler_rate_matrix_body_yzx_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_yzx, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yzx, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yzx, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_yzx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_body_expected[9] = {
        0.47942553860420300027,
        0.0,
        1.0,
        0.6421173920529567248,
        -0.68163876002333416673,
        0.0,
        0.59819428930505457197,
        0.73168886887382088631,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yzxf(angles, W_body);
    chasles_euler_rate_matrix_body_yzx_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_yzxf, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yzxf, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yzxf, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_yzx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_body_expected[9] = {
        -0.99749498660405443094,
        0.0,
        1.0,
        0.068538153372888287532,
        0.2474039592545229296,
        0.0,
        -0.017500663759175342192,
        0.96891242171064478414,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yzxf(angles, W_body);
    chasles_euler_rate_matrix_body_yzx_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_yzxf, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yzxf, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yzxf, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_yzx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double omega[3] = {2.0, -1.5, 0.25};
    const double theta_dot_expected[3] = {
        -1.7149146182655679475,
        1.9767998293099895951,
        0.44827528147805651003,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yzx(angles, omega, theta_dot);
    chasles_euler_rates_yzx_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_yzx, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yzx, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yzx, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_yzx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double omega[3] = {1.75, -0.5, 0.75};
    const double theta_dot_expected[3] = {
        -20.38624593263068336,
        1.2791603695345861767,
        -19.936186346492714762,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yzx(angles, omega, theta_dot);
    chasles_euler_rates_yzx_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_yzx, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yzx, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yzx, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_yzx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const double theta_dot_expected[3] = {
        -1.7149146182655679475,
        1.9767998293099895951,
        0.44827528147805651003,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yzxf(angles, omega, theta_dot);
    chasles_euler_rates_yzx_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_yzxf, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yzxf, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yzxf, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_yzx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const float omega[3] = {1.75f, -0.5f, 0.75f};
    const double theta_dot_expected[3] = {
        -20.38624593263068336,
        1.2791603695345861767,
        -19.936186346492714762,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yzxf(angles, omega, theta_dot);
    chasles_euler_rates_yzx_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_yzxf, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yzxf, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yzxf, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_yzy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double Q_expected[9] = {
        0.84933867221598477972,
        -0.151173593425301366,
        0.50573744623991374325,
        0.35079033005053164238,
        0.87758256189037271612,
        -0.32679502965768805935,
        -0.39442358476823751035,
        0.45496746226165648835,
        0.7983950426084577951,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_yzy(angles, Q);
    chasles_rotation_from_euler_yzy_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_yzy, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yzy, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yzy, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_yzy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double Q_expected[9] = {
        -0.25348571924553381714,
        -0.4151043831469114242,
        0.87374672602007303051,
        -0.96648528311476155654,
        0.070737201667702910088,
        -0.24678420902238037792,
        0.040634808491656591945,
        -0.90701962459058452691,
        -0.41912314771007518991,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_yzy(angles, Q);
    chasles_rotation_from_euler_yzy_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_yzy, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yzy, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_yzy, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_yzy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double Q_expected[9] = {
        0.84933867221598477972,
        -0.151173593425301366,
        0.50573744623991374325,
        0.35079033005053164238,
        0.87758256189037271612,
        -0.32679502965768805935,
        -0.39442358476823751035,
        0.45496746226165648835,
        0.7983950426084577951,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_yzyf(angles, Q);
    chasles_rotation_from_euler_yzy_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_yzyf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yzyf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yzyf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_yzy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double Q_expected[9] = {
        -0.25348571924553381714,
        -0.4151043831469114242,
        0.87374672602007303051,
        -0.96648528311476155654,
        0.070737201667702910088,
        -0.24678420902238037792,
        0.040634808491656591945,
        -0.90701962459058452691,
        -0.41912314771007518991,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_yzyf(angles, Q);
    chasles_rotation_from_euler_yzy_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_yzyf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yzyf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_yzyf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_yzy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_expected[9] = {
        0.0,
        0.94898461935558621435,
        -0.151173593425301366,
        1.0,
        0.0,
        0.87758256189037271612,
        0.0,
        0.31532236239526866545,
        0.45496746226165648835,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_yzy(angles, W);
    chasles_euler_rate_matrix_yzy_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_yzy, vector 1: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yzy, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yzy, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_yzy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_expected[9] = {
        0.0,
        0.9092974268256816954,
        -0.4151043831469114242,
        1.0,
        0.0,
        0.070737201667702910088,
        0.0,
        -0.416146836547142387,
        -0.90701962459058452691,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_yzy(angles, W);
    chasles_euler_rate_matrix_yzy_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_yzy, vector 2: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yzy, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_yzy, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_yzy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_expected[9] = {
        0.0,
        0.94898461935558621435,
        -0.151173593425301366,
        1.0,
        0.0,
        0.87758256189037271612,
        0.0,
        0.31532236239526866545,
        0.45496746226165648835,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_yzyf(angles, W);
    chasles_euler_rate_matrix_yzy_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_yzyf, vector 1: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yzyf, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yzyf, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_yzy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_expected[9] = {
        0.0,
        0.9092974268256816954,
        -0.4151043831469114242,
        1.0,
        0.0,
        0.070737201667702910088,
        0.0,
        -0.416146836547142387,
        -0.90701962459058452691,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_yzyf(angles, W);
    chasles_euler_rate_matrix_yzy_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_yzyf, vector 2: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yzyf, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_yzyf, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_yzy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_body_expected[9] = {
        0.35079033005053164238,
        0.68163876002333416673,
        0.0,
        0.87758256189037271612,
        0.0,
        1.0,
        -0.32679502965768805935,
        0.73168886887382088631,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yzy(angles, W_body);
    chasles_euler_rate_matrix_body_yzy_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_yzy, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yzy, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yzy, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_yzy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_body_expected[9] = {
        -0.96648528311476155654,
        -0.2474039592545229296,
        0.0,
        0.070737201667702910088,
        0.0,
        1.0,
        -0.24678420902238037792,
        0.96891242171064478414,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yzy(angles, W_body);
    chasles_euler_rate_matrix_body_yzy_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_yzy, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yzy, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_yzy, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_yzy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_body_expected[9] = {
        0.35079033005053164238,
        0.68163876002333416673,
        0.0,
        0.87758256189037271612,
        0.0,
        1.0,
        -0.32679502965768805935,
        0.73168886887382088631,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yzyf(angles, W_body);
    chasles_euler_rate_matrix_body_yzy_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_yzyf, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yzyf, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yzyf, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_yzy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_body_expected[9] = {
        -0.96648528311476155654,
        -0.2474039592545229296,
        0.0,
        0.070737201667702910088,
        0.0,
        1.0,
        -0.24678420902238037792,
        0.96891242171064478414,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_yzyf(angles, W_body);
    chasles_euler_rate_matrix_body_yzy_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_yzyf, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yzyf, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_yzyf, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_yzy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double omega[3] = {2.0, -1.5, 0.25};
    const double theta_dot_expected[3] = {
        -0.77988874796428442714,
        1.9767998293099895951,
        -0.82056239869277575719,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yzy(angles, omega, theta_dot);
    chasles_euler_rates_yzy_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_yzy, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yzy, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yzy, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_yzy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double omega[3] = {1.75, -0.5, 0.75};
    const double theta_dot_expected[3] = {
        -0.39999375670252227558,
        1.2791603695345861767,
        -1.4137715507501964318,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yzy(angles, omega, theta_dot);
    chasles_euler_rates_yzy_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_yzy, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yzy, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yzy, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_yzy_vector_3(void)
{
    const double angles[3] = {0.0, 0.0, 0.0};
    const double omega[3] = {0.0, 0.0, 0.0};
    const double theta_dot_expected[3] = {NAN, 0.0, NAN};
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yzy(angles, omega, theta_dot);
    chasles_euler_rates_yzy_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_yzy, vector 3: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yzy, vector 3, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_yzy, vector 3, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_yzy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const double theta_dot_expected[3] = {
        -0.77988874796428442714,
        1.9767998293099895951,
        -0.82056239869277575719,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yzyf(angles, omega, theta_dot);
    chasles_euler_rates_yzy_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_yzyf, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yzyf, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yzyf, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_yzy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const float omega[3] = {1.75f, -0.5f, 0.75f};
    const double theta_dot_expected[3] = {
        -0.39999375670252227558,
        1.2791603695345861767,
        -1.4137715507501964318,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yzyf(angles, omega, theta_dot);
    chasles_euler_rates_yzy_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_yzyf, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yzyf, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yzyf, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_yzy_vector_3f(void)
{
    const float angles[3] = {0.0f, 0.0f, 0.0f};
    const float omega[3] = {0.0f, 0.0f, 0.0f};
    const double theta_dot_expected[3] = {NAN, 0.0, NAN};
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_yzyf(angles, omega, theta_dot);
    chasles_euler_rates_yzy_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_yzyf, vector 3: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yzyf, vector 3, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_yzyf, vector 3, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_zxy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double Q_expected[9] = {
        0.54084131949861377544,
        -0.83281235344863553273,
        0.11795868372588487932,
        0.59131570194424826225,
        0.27672140661216439796,
        -0.757476734795707194,
        0.59819428930505457197,
        0.47942553860420300027,
        0.6421173920529567248,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_zxy(angles, Q);
    chasles_rotation_from_euler_zxy_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_zxy, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zxy, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zxy, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_zxy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double Q_expected[9] = {
        -0.17880959294085393151,
        -0.064321155457291576076,
        -0.98177895599415098176,
        0.98372803977538141873,
        -0.029437062700211810791,
        -0.17723600960095381218,
        -0.017500663759175342192,
        -0.99749498660405443094,
        0.068538153372888287532,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_zxy(angles, Q);
    chasles_rotation_from_euler_zxy_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_zxy, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zxy, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zxy, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_zxy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double Q_expected[9] = {
        0.54084131949861377544,
        -0.83281235344863553273,
        0.11795868372588487932,
        0.59131570194424826225,
        0.27672140661216439796,
        -0.757476734795707194,
        0.59819428930505457197,
        0.47942553860420300027,
        0.6421173920529567248,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_zxyf(angles, Q);
    chasles_rotation_from_euler_zxy_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_zxyf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zxyf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zxyf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_zxy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double Q_expected[9] = {
        -0.17880959294085393151,
        -0.064321155457291576076,
        -0.98177895599415098176,
        0.98372803977538141873,
        -0.029437062700211810791,
        -0.17723600960095381218,
        -0.017500663759175342192,
        -0.99749498660405443094,
        0.068538153372888287532,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_zxyf(angles, Q);
    chasles_rotation_from_euler_zxy_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_zxyf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zxyf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zxyf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_zxy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_expected[9] = {
        0.0,
        0.31532236239526866545,
        -0.83281235344863553273,
        0.0,
        0.94898461935558621435,
        0.27672140661216439796,
        1.0,
        0.0,
        0.47942553860420300027,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_zxy(angles, W);
    chasles_euler_rate_matrix_zxy_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_zxy, vector 1: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zxy, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zxy, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_zxy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_expected[9] = {
        0.0,
        -0.416146836547142387,
        -0.064321155457291576076,
        0.0,
        0.9092974268256816954,
        -0.029437062700211810791,
        1.0,
        0.0,
        -0.99749498660405443094,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_zxy(angles, W);
    chasles_euler_rate_matrix_zxy_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_zxy, vector 2: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zxy, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zxy, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_zxy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_expected[9] = {
        0.0,
        0.31532236239526866545,
        -0.83281235344863553273,
        0.0,
        0.94898461935558621435,
        0.27672140661216439796,
        1.0,
        0.0,
        0.47942553860420300027,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_zxyf(angles, W);
    chasles_euler_rate_matrix_zxy_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_zxyf, vector 1: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zxyf, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zxyf, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_zxy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_expected[9] = {
        0.0,
        -0.416146836547142387,
        -0.064321155457291576076,
        0.0,
        0.9092974268256816954,
        -0.029437062700211810791,
        1.0,
        0.0,
        -0.99749498660405443094,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_zxyf(angles, W);
    chasles_euler_rate_matrix_zxy_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_zxyf, vector 2: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zxyf, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zxyf, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_zxy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_body_expected[9] = {
        0.59819428930505457197,
        0.73168886887382088631,
        0.0,
        0.47942553860420300027,
        0.0,
        1.0,
        0.6421173920529567248,
        -0.68163876002333416673,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zxy(angles, W_body);
    chasles_euler_rate_matrix_body_zxy_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_zxy, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zxy, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zxy, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_zxy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_body_expected[9] = {
        -0.017500663759175342192,
        0.96891242171064478414,
        0.0,
        -0.99749498660405443094,
        0.0,
        1.0,
        0.068538153372888287532,
        0.2474039592545229296,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zxy(angles, W_body);
    chasles_euler_rate_matrix_body_zxy_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_zxy, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zxy, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zxy, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_zxy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_body_expected[9] = {
        0.59819428930505457197,
        0.73168886887382088631,
        0.0,
        0.47942553860420300027,
        0.0,
        1.0,
        0.6421173920529567248,
        -0.68163876002333416673,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zxyf(angles, W_body);
    chasles_euler_rate_matrix_body_zxy_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_zxyf, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zxyf, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zxyf, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_zxy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_body_expected[9] = {
        -0.017500663759175342192,
        0.96891242171064478414,
        0.0,
        -0.99749498660405443094,
        0.0,
        1.0,
        0.068538153372888287532,
        0.2474039592545229296,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zxyf(angles, W_body);
    chasles_euler_rate_matrix_body_zxy_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_zxyf, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zxyf, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zxyf, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_zxy_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double omega[3] = {2.0, -1.5, 0.25};
    const double theta_dot_expected[3] = {
        1.5452574082747790256,
        -0.79283220424284199063,
        -2.7016862974087376608,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zxy(angles, omega, theta_dot);
    chasles_euler_rates_zxy_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_zxy, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zxy, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zxy, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_zxy_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double omega[3] = {1.75, -0.5, 0.75};
    const double theta_dot_expected[3] = {
        -18.755042876046131939,
        -1.1829056773703400249,
        -19.554025973053298042,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zxy(angles, omega, theta_dot);
    chasles_euler_rates_zxy_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_zxy, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zxy, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zxy, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_zxy_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const double theta_dot_expected[3] = {
        1.5452574082747790256,
        -0.79283220424284199063,
        -2.7016862974087376608,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zxyf(angles, omega, theta_dot);
    chasles_euler_rates_zxy_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_zxyf, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zxyf, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zxyf, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_zxy_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const float omega[3] = {1.75f, -0.5f, 0.75f};
    const double theta_dot_expected[3] = {
        -18.755042876046131939,
        -1.1829056773703400249,
        -19.554025973053298042,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zxyf(angles, omega, theta_dot);
    chasles_euler_rates_zxy_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_zxyf, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zxyf, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zxyf, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_zxz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double Q_expected[9] = {
        0.7983950426084577951,
        -0.39442358476823751035,
        0.45496746226165648835,
        0.50573744623991374325,
        0.84933867221598477972,
        -0.151173593425301366,
        -0.32679502965768805935,
        0.35079033005053164238,
        0.87758256189037271612,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_zxz(angles, Q);
    chasles_rotation_from_euler_zxz_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_zxz, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zxz, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zxz, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_zxz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double Q_expected[9] = {
        -0.41912314771007518991,
        0.040634808491656591945,
        -0.90701962459058452691,
        0.87374672602007303051,
        -0.25348571924553381714,
        -0.4151043831469114242,
        -0.24678420902238037792,
        -0.96648528311476155654,
        0.070737201667702910088,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_zxz(angles, Q);
    chasles_rotation_from_euler_zxz_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_zxz, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zxz, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zxz, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_zxz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double Q_expected[9] = {
        0.7983950426084577951,
        -0.39442358476823751035,
        0.45496746226165648835,
        0.50573744623991374325,
        0.84933867221598477972,
        -0.151173593425301366,
        -0.32679502965768805935,
        0.35079033005053164238,
        0.87758256189037271612,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_zxzf(angles, Q);
    chasles_rotation_from_euler_zxz_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_zxzf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zxzf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zxzf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_zxz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double Q_expected[9] = {
        -0.41912314771007518991,
        0.040634808491656591945,
        -0.90701962459058452691,
        0.87374672602007303051,
        -0.25348571924553381714,
        -0.4151043831469114242,
        -0.24678420902238037792,
        -0.96648528311476155654,
        0.070737201667702910088,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_zxzf(angles, Q);
    chasles_rotation_from_euler_zxz_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_zxzf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zxzf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zxzf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_zxz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_expected[9] = {
        0.0,
        0.31532236239526866545,
        0.45496746226165648835,
        0.0,
        0.94898461935558621435,
        -0.151173593425301366,
        1.0,
        0.0,
        0.87758256189037271612,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_zxz(angles, W);
    chasles_euler_rate_matrix_zxz_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_zxz, vector 1: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zxz, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zxz, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_zxz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_expected[9] = {
        0.0,
        -0.416146836547142387,
        -0.90701962459058452691,
        0.0,
        0.9092974268256816954,
        -0.4151043831469114242,
        1.0,
        0.0,
        0.070737201667702910088,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_zxz(angles, W);
    chasles_euler_rate_matrix_zxz_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_zxz, vector 2: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zxz, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zxz, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_zxz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_expected[9] = {
        0.0,
        0.31532236239526866545,
        0.45496746226165648835,
        0.0,
        0.94898461935558621435,
        -0.151173593425301366,
        1.0,
        0.0,
        0.87758256189037271612,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_zxzf(angles, W);
    chasles_euler_rate_matrix_zxz_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_zxzf, vector 1: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zxzf, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zxzf, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_zxz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_expected[9] = {
        0.0,
        -0.416146836547142387,
        -0.90701962459058452691,
        0.0,
        0.9092974268256816954,
        -0.4151043831469114242,
        1.0,
        0.0,
        0.070737201667702910088,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_zxzf(angles, W);
    chasles_euler_rate_matrix_zxz_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_zxzf, vector 2: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zxzf, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zxzf, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_zxz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_body_expected[9] = {
        -0.32679502965768805935,
        0.73168886887382088631,
        0.0,
        0.35079033005053164238,
        0.68163876002333416673,
        0.0,
        0.87758256189037271612,
        0.0,
        1.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zxz(angles, W_body);
    chasles_euler_rate_matrix_body_zxz_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_zxz, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zxz, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zxz, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_zxz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_body_expected[9] = {
        -0.24678420902238037792,
        0.96891242171064478414,
        0.0,
        -0.96648528311476155654,
        -0.2474039592545229296,
        0.0,
        0.070737201667702910088,
        0.0,
        1.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zxz(angles, W_body);
    chasles_euler_rate_matrix_body_zxz_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_zxz, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zxz, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zxz, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_zxz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_body_expected[9] = {
        -0.32679502965768805935,
        0.73168886887382088631,
        0.0,
        0.35079033005053164238,
        0.68163876002333416673,
        0.0,
        0.87758256189037271612,
        0.0,
        1.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zxzf(angles, W_body);
    chasles_euler_rate_matrix_body_zxz_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_zxzf, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zxzf, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zxzf, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_zxz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_body_expected[9] = {
        -0.24678420902238037792,
        0.96891242171064478414,
        0.0,
        -0.96648528311476155654,
        -0.2474039592545229296,
        0.0,
        0.070737201667702910088,
        0.0,
        1.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zxzf(angles, W_body);
    chasles_euler_rate_matrix_body_zxz_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_zxzf, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zxzf, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zxzf, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_zxz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double omega[3] = {2.0, -1.5, 0.25};
    const double theta_dot_expected[3] = {
        -4.0899999567675860174,
        -0.79283220424284199063,
        4.9454035953254699941,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zxz(angles, omega, theta_dot);
    chasles_euler_rates_zxz_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_zxz, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zxz, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zxz, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_zxz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double omega[3] = {1.75, -0.5, 0.75};
    const double theta_dot_expected[3] = {
        0.8480892054738640396,
        -1.1829056773703400249,
        -1.3866707073690966787,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zxz(angles, omega, theta_dot);
    chasles_euler_rates_zxz_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_zxz, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zxz, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zxz, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_zxz_vector_3(void)
{
    const double angles[3] = {0.0, 0.0, 0.0};
    const double omega[3] = {0.0, 0.0, 0.0};
    const double theta_dot_expected[3] = {NAN, 0.0, NAN};
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zxz(angles, omega, theta_dot);
    chasles_euler_rates_zxz_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_zxz, vector 3: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zxz, vector 3, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zxz, vector 3, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_zxz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const double theta_dot_expected[3] = {
        -4.0899999567675860174,
        -0.79283220424284199063,
        4.9454035953254699941,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zxzf(angles, omega, theta_dot);
    chasles_euler_rates_zxz_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_zxzf, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zxzf, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zxzf, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_zxz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const float omega[3] = {1.75f, -0.5f, 0.75f};
    const double theta_dot_expected[3] = {
        0.8480892054738640396,
        -1.1829056773703400249,
        -1.3866707073690966787,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zxzf(angles, omega, theta_dot);
    chasles_euler_rates_zxz_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_zxzf, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zxzf, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zxzf, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_zxz_vector_3f(void)
{
    const float angles[3] = {0.0f, 0.0f, 0.0f};
    const float omega[3] = {0.0f, 0.0f, 0.0f};
    const double theta_dot_expected[3] = {NAN, 0.0, NAN};
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zxzf(angles, omega, theta_dot);
    chasles_euler_rates_zxz_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_zxzf, vector 3: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zxzf, vector 3, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zxzf, vector 3, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_zyx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double Q_expected[9] = {
        0.27672140661216439796,
        -0.79740726348563643342,
        -0.53625266364180790912,
        0.83281235344863553273,
        -0.079405594155383446326,
        0.54783057194736357444,
        -0.47942553860420300027,
        -0.59819428930505457197,
        0.6421173920529567248,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_zyx(angles, Q);
    chasles_rotation_from_euler_zyx_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_zyx, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zyx, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zyx, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_zyx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double Q_expected[9] = {
        -0.029437062700211810791,
        -0.77833110398647672142,
        0.62716357667420081072,
        0.064321155457291576076,
        -0.62761008543137724778,
        -0.77586620600813532444,
        0.99749498660405443094,
        0.017500663759175342192,
        0.068538153372888287532,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_zyx(angles, Q);
    chasles_rotation_from_euler_zyx_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_zyx, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zyx, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zyx, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_zyx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double Q_expected[9] = {
        0.27672140661216439796,
        -0.79740726348563643342,
        -0.53625266364180790912,
        0.83281235344863553273,
        -0.079405594155383446326,
        0.54783057194736357444,
        -0.47942553860420300027,
        -0.59819428930505457197,
        0.6421173920529567248,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_zyxf(angles, Q);
    chasles_rotation_from_euler_zyx_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_zyxf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zyxf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zyxf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_zyx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double Q_expected[9] = {
        -0.029437062700211810791,
        -0.77833110398647672142,
        0.62716357667420081072,
        0.064321155457291576076,
        -0.62761008543137724778,
        -0.77586620600813532444,
        0.99749498660405443094,
        0.017500663759175342192,
        0.068538153372888287532,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_zyxf(angles, Q);
    chasles_rotation_from_euler_zyx_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_zyxf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zyxf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zyxf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_zyx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_expected[9] = {
        0.0,
        -0.94898461935558621435,
        0.27672140661216439796,
        0.0,
        0.31532236239526866545,
        0.83281235344863553273,
        1.0,
        0.0,
        -0.47942553860420300027,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_zyx(angles, W);
    chasles_euler_rate_matrix_zyx_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_zyx, vector 1: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zyx, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zyx, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_zyx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_expected[9] = {
        0.0,
        -0.9092974268256816954,
        -0.029437062700211810791,
        0.0,
        -0.416146836547142387,
        0.064321155457291576076,
        1.0,
        0.0,
        0.99749498660405443094,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_zyx(angles, W);
    chasles_euler_rate_matrix_zyx_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_zyx, vector 2: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zyx, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zyx, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_zyx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_expected[9] = {
        0.0,
        -0.94898461935558621435,
        0.27672140661216439796,
        0.0,
        0.31532236239526866545,
        0.83281235344863553273,
        1.0,
        0.0,
        -0.47942553860420300027,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_zyxf(angles, W);
    chasles_euler_rate_matrix_zyx_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_zyxf, vector 1: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zyxf, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zyxf, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_zyx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_expected[9] = {
        0.0,
        -0.9092974268256816954,
        -0.029437062700211810791,
        0.0,
        -0.416146836547142387,
        0.064321155457291576076,
        1.0,
        0.0,
        0.99749498660405443094,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_zyxf(angles, W);
    chasles_euler_rate_matrix_zyx_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_zyxf, vector 2: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zyxf, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zyxf, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_zyx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_body_expected[9] = {
        -0.47942553860420300027,
        0.0,
        1.0,
        -0.59819428930505457197,
        0.73168886887382088631,
        0.0,
        0.6421173920529567248,
        0.68163876002333416673,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zyx(angles, W_body);
    chasles_euler_rate_matrix_body_zyx_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_zyx, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zyx, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zyx, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_zyx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_body_expected[9] = {
        0.99749498660405443094,
        0.0,
        1.0,
        0.017500663759175342192,
        0.96891242171064478414,
        0.0,
        0.068538153372888287532,
        -0.2474039592545229296,
        0.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zyx(angles, W_body);
    chasles_euler_rate_matrix_body_zyx_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_zyx, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zyx, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zyx, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_zyx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_body_expected[9] = {
        -0.47942553860420300027,
        0.0,
        1.0,
        -0.59819428930505457197,
        0.73168886887382088631,
        0.0,
        0.6421173920529567248,
        0.68163876002333416673,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zyxf(angles, W_body);
    chasles_euler_rate_matrix_body_zyx_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_zyxf, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zyxf, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zyxf, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_zyx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_body_expected[9] = {
        0.99749498660405443094,
        0.0,
        1.0,
        0.017500663759175342192,
        0.96891242171064478414,
        0.0,
        0.068538153372888287532,
        -0.2474039592545229296,
        0.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zyxf(angles, W_body);
    chasles_euler_rate_matrix_body_zyx_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_zyxf, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zyxf, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zyxf, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_zyx_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double omega[3] = {2.0, -1.5, 0.25};
    const double theta_dot_expected[3] = {
        -0.18312620720620523246,
        -2.3709527823040754269,
        -0.90342748212205507757,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zyx(angles, omega, theta_dot);
    chasles_euler_rates_zyx_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_zyx, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zyx, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zyx, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_zyx_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double omega[3] = {1.75, -0.5, 0.75};
    const double theta_dot_expected[3] = {
        17.430649714492787172,
        -1.3831970786713717734,
        -16.722539900958923566,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zyx(angles, omega, theta_dot);
    chasles_euler_rates_zyx_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_zyx, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zyx, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zyx, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_zyx_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const double theta_dot_expected[3] = {
        -0.18312620720620523246,
        -2.3709527823040754269,
        -0.90342748212205507757,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zyxf(angles, omega, theta_dot);
    chasles_euler_rates_zyx_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_zyxf, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zyxf, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zyxf, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_zyx_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const float omega[3] = {1.75f, -0.5f, 0.75f};
    const double theta_dot_expected[3] = {
        17.430649714492787172,
        -1.3831970786713717734,
        -16.722539900958923566,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zyxf(angles, omega, theta_dot);
    chasles_euler_rates_zyx_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_zyxf, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zyxf, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zyxf, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_zyz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double Q_expected[9] = {
        0.84933867221598477972,
        -0.50573744623991374325,
        0.151173593425301366,
        0.39442358476823751035,
        0.7983950426084577951,
        0.45496746226165648835,
        -0.35079033005053164238,
        -0.32679502965768805935,
        0.87758256189037271612,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_zyz(angles, Q);
    chasles_rotation_from_euler_zyz_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_zyz, vector 1: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zyz, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zyz, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_zyz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double Q_expected[9] = {
        -0.25348571924553381714,
        -0.87374672602007303051,
        0.4151043831469114242,
        -0.040634808491656591945,
        -0.41912314771007518991,
        -0.90701962459058452691,
        0.96648528311476155654,
        -0.24678420902238037792,
        0.070737201667702910088,
    };
    double Q[9], Q_batch[99];
    chasles_rotation_from_euler_zyz(angles, Q);
    chasles_rotation_from_euler_zyz_batch(11, angles, 0, Q_batch, 9);
    compare("chasles_rotation_from_euler_zyz, vector 2: Q", 9, Q, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zyz, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * DBL_EPSILON);
    compare("chasles_rotation_from_euler_zyz, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * DBL_EPSILON);
}

static void rotation_from_euler_zyz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double Q_expected[9] = {
        0.84933867221598477972,
        -0.50573744623991374325,
        0.151173593425301366,
        0.39442358476823751035,
        0.7983950426084577951,
        0.45496746226165648835,
        -0.35079033005053164238,
        -0.32679502965768805935,
        0.87758256189037271612,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_zyzf(angles, Q);
    chasles_rotation_from_euler_zyz_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_zyzf, vector 1: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zyzf, vector 1, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zyzf, vector 1, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void rotation_from_euler_zyz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double Q_expected[9] = {
        -0.25348571924553381714,
        -0.87374672602007303051,
        0.4151043831469114242,
        -0.040634808491656591945,
        -0.41912314771007518991,
        -0.90701962459058452691,
        0.96648528311476155654,
        -0.24678420902238037792,
        0.070737201667702910088,
    };
    float Q[9], Q_batch[99];
    chasles_rotation_from_euler_zyzf(angles, Q);
    chasles_rotation_from_euler_zyz_batchf(11, angles, 0, Q_batch, 9);
    comparef("chasles_rotation_from_euler_zyzf, vector 2: Q", 9, Q, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zyzf, vector 2, first of a batch: Q", 9, Q_batch, Q_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_rotation_from_euler_zyzf, vector 2, last: Q", 9, Q_batch + 90, Q_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_zyz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_expected[9] = {
        0.0,
        -0.94898461935558621435,
        0.151173593425301366,
        0.0,
        0.31532236239526866545,
        0.45496746226165648835,
        1.0,
        0.0,
        0.87758256189037271612,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_zyz(angles, W);
    chasles_euler_rate_matrix_zyz_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_zyz, vector 1: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zyz, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zyz, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_zyz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_expected[9] = {
        0.0,
        -0.9092974268256816954,
        0.4151043831469114242,
        0.0,
        -0.416146836547142387,
        -0.90701962459058452691,
        1.0,
        0.0,
        0.070737201667702910088,
    };
    double W[9], W_batch[99];
    chasles_euler_rate_matrix_zyz(angles, W);
    chasles_euler_rate_matrix_zyz_batch(11, angles, 0, W_batch, 9);
    compare("chasles_euler_rate_matrix_zyz, vector 2: W", 9, W, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zyz, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_zyz, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_zyz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_expected[9] = {
        0.0,
        -0.94898461935558621435,
        0.151173593425301366,
        0.0,
        0.31532236239526866545,
        0.45496746226165648835,
        1.0,
        0.0,
        0.87758256189037271612,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_zyzf(angles, W);
    chasles_euler_rate_matrix_zyz_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_zyzf, vector 1: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zyzf, vector 1, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zyzf, vector 1, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_zyz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_expected[9] = {
        0.0,
        -0.9092974268256816954,
        0.4151043831469114242,
        0.0,
        -0.416146836547142387,
        -0.90701962459058452691,
        1.0,
        0.0,
        0.070737201667702910088,
    };
    float W[9], W_batch[99];
    chasles_euler_rate_matrix_zyzf(angles, W);
    chasles_euler_rate_matrix_zyz_batchf(11, angles, 0, W_batch, 9);
    comparef("chasles_euler_rate_matrix_zyzf, vector 2: W", 9, W, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zyzf, vector 2, first of a batch: W", 9, W_batch, W_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_zyzf, vector 2, last: W", 9, W_batch + 90, W_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_zyz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double W_body_expected[9] = {
        -0.35079033005053164238,
        -0.68163876002333416673,
        0.0,
        -0.32679502965768805935,
        0.73168886887382088631,
        0.0,
        0.87758256189037271612,
        0.0,
        1.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zyz(angles, W_body);
    chasles_euler_rate_matrix_body_zyz_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_zyz, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zyz, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zyz, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_zyz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double W_body_expected[9] = {
        0.96648528311476155654,
        0.2474039592545229296,
        0.0,
        -0.24678420902238037792,
        0.96891242171064478414,
        0.0,
        0.070737201667702910088,
        0.0,
        1.0,
    };
    double W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zyz(angles, W_body);
    chasles_euler_rate_matrix_body_zyz_batch(11, angles, 0, W_body_batch, 9);
    compare("chasles_euler_rate_matrix_body_zyz, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zyz, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rate_matrix_body_zyz, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * DBL_EPSILON);
}

static void euler_rate_matrix_body_zyz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const double W_body_expected[9] = {
        -0.35079033005053164238,
        -0.68163876002333416673,
        0.0,
        -0.32679502965768805935,
        0.73168886887382088631,
        0.0,
        0.87758256189037271612,
        0.0,
        1.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zyzf(angles, W_body);
    chasles_euler_rate_matrix_body_zyz_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_zyzf, vector 1: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zyzf, vector 1, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zyzf, vector 1, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rate_matrix_body_zyz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const double W_body_expected[9] = {
        0.96648528311476155654,
        0.2474039592545229296,
        0.0,
        -0.24678420902238037792,
        0.96891242171064478414,
        0.0,
        0.070737201667702910088,
        0.0,
        1.0,
    };
    float W_body[9], W_body_batch[99];
    chasles_euler_rate_matrix_body_zyzf(angles, W_body);
    chasles_euler_rate_matrix_body_zyz_batchf(11, angles, 0, W_body_batch, 9);
    comparef("chasles_euler_rate_matrix_body_zyzf, vector 2: W_body", 9, W_body, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zyzf, vector 2, first of a batch: W_body", 9, W_body_batch, W_body_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rate_matrix_body_zyzf, vector 2, last: W_body", 9, W_body_batch + 90, W_body_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_zyz_vector_1(void)
{
    const double angles[3] = {1.25, 0.5, -0.75};
    const double omega[3] = {2.0, -1.5, 0.25};
    const double theta_dot_expected[3] = {
        1.7012696152447411916,
        -2.3709527823040754269,
        -1.6537129134820174863,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zyz(angles, omega, theta_dot);
    chasles_euler_rates_zyz_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_zyz, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zyz, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zyz, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_zyz_vector_2(void)
{
    const double angles[3] = {2.0, -1.5, 0.25};
    const double omega[3] = {1.75, -0.5, 0.75};
    const double theta_dot_expected[3] = {
        0.66611442806455870696,
        -1.3831970786713717734,
        1.1858763134213951661,
    };
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zyz(angles, omega, theta_dot);
    chasles_euler_rates_zyz_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_zyz, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zyz, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zyz, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_zyz_vector_3(void)
{
    const double angles[3] = {0.0, 0.0, 0.0};
    const double omega[3] = {0.0, 0.0, 0.0};
    const double theta_dot_expected[3] = {NAN, 0.0, NAN};
    double theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zyz(angles, omega, theta_dot);
    chasles_euler_rates_zyz_batch(11, angles, 0, omega, 0, theta_dot_batch, 3);
    compare("chasles_euler_rates_zyz, vector 3: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zyz, vector 3, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * DBL_EPSILON);
    compare("chasles_euler_rates_zyz, vector 3, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * DBL_EPSILON);
}

static void euler_rates_zyz_vector_1f(void)
{
    const float angles[3] = {1.25f, 0.5f, -0.75f};
    const float omega[3] = {2.0f, -1.5f, 0.25f};
    const double theta_dot_expected[3] = {
        1.7012696152447411916,
        -2.3709527823040754269,
        -1.6537129134820174863,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zyzf(angles, omega, theta_dot);
    chasles_euler_rates_zyz_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_zyzf, vector 1: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zyzf, vector 1, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zyzf, vector 1, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_zyz_vector_2f(void)
{
    const float angles[3] = {2.0f, -1.5f, 0.25f};
    const float omega[3] = {1.75f, -0.5f, 0.75f};
    const double theta_dot_expected[3] = {
        0.66611442806455870696,
        -1.3831970786713717734,
        1.1858763134213951661,
    };
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zyzf(angles, omega, theta_dot);
    chasles_euler_rates_zyz_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_zyzf, vector 2: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zyzf, vector 2, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zyzf, vector 2, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

static void euler_rates_zyz_vector_3f(void)
{
    const float angles[3] = {0.0f, 0.0f, 0.0f};
    const float omega[3] = {0.0f, 0.0f, 0.0f};
    const double theta_dot_expected[3] = {NAN, 0.0, NAN};
    float theta_dot[3], theta_dot_batch[33];
    chasles_euler_rates_zyzf(angles, omega, theta_dot);
    chasles_euler_rates_zyz_batchf(11, angles, 0, omega, 0, theta_dot_batch, 3);
    comparef("chasles_euler_rates_zyzf, vector 3: theta_dot", 3, theta_dot, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zyzf, vector 3, first of a batch: theta_dot", 3, theta_dot_batch, theta_dot_expected, 8.0 * FLT_EPSILON);
    comparef("chasles_euler_rates_zyzf, vector 3, last: theta_dot", 3, theta_dot_batch + 30, theta_dot_expected, 8.0 * FLT_EPSILON);
}

int main(void)
{
    (void)compare;
    (void)comparef;
    cross_product_matrix_vector_1();
    cross_product_matrix_vector_2();
    cross_product_matrix_vector_1f();
    cross_product_matrix_vector_2f();
    rotation_from_axis_angle_vector_1();
    rotation_from_axis_angle_vector_2();
    rotation_from_axis_angle_vector_1f();
    rotation_from_axis_angle_vector_2f();
    point_after_displacement_vector_1();
    point_after_displacement_vector_2();
    point_after_displacement_vector_1f();
    point_after_displacement_vector_2f();
    pitch_of_motion_vector_1();
    pitch_of_motion_vector_2();
    pitch_of_motion_vector_3();
    pitch_of_motion_vector_1f();
    pitch_of_motion_vector_2f();
    pitch_of_motion_vector_3f();
    normal_matrix_inverse_vector_1();
    normal_matrix_inverse_vector_2();
    normal_matrix_inverse_vector_3();
    normal_matrix_inverse_vector_1f();
    normal_matrix_inverse_vector_2f();
    normal_matrix_inverse_vector_3f();
    screw_axis_point_vector_1();
    screw_axis_point_vector_2();
    screw_axis_point_vector_3();
    screw_axis_point_vector_1f();
    screw_axis_point_vector_2f();
    screw_axis_point_vector_3f();
    plucker_line_vector_1();
    plucker_line_vector_2();
    plucker_line_vector_3();
    plucker_line_vector_1f();
    plucker_line_vector_2f();
    plucker_line_vector_3f();
    plucker_transfer_vector_1();
    plucker_transfer_vector_2();
    plucker_transfer_vector_1f();
    plucker_transfer_vector_2f();
    rotation_in_triad_axes_vector_1();
    rotation_in_triad_axes_vector_2();
    rotation_in_triad_axes_vector_1f();
    rotation_in_triad_axes_vector_2f();
    rotation_from_triads_vector_1();
    rotation_from_triads_vector_2();
    rotation_from_triads_vector_1f();
    rotation_from_triads_vector_2f();
    axial_vector_vector_1();
    axial_vector_vector_2();
    axial_vector_vector_1f();
    axial_vector_vector_2f();
    velocity_of_point_vector_1();
    velocity_of_point_vector_2();
    velocity_of_point_vector_1f();
    velocity_of_point_vector_2f();
    instant_screw_point_vector_1();
    instant_screw_point_vector_2();
    instant_screw_point_vector_3();
    instant_screw_point_vector_1f();
    instant_screw_point_vector_2f();
    instant_screw_point_vector_3f();
    natural_rate_matrix_vector_1();
    natural_rate_matrix_vector_2();
    natural_rate_matrix_vector_3();
    natural_rate_matrix_vector_1f();
    natural_rate_matrix_vector_2f();
    natural_rate_matrix_vector_3f();
    linear_rate_matrix_vector_1();
    linear_rate_matrix_vector_2();
    linear_rate_matrix_vector_1f();
    linear_rate_matrix_vector_2f();
    euler_rodrigues_rate_matrix_vector_1();
    euler_rodrigues_rate_matrix_vector_2();
    euler_rodrigues_rate_matrix_vector_1f();
    euler_rodrigues_rate_matrix_vector_2f();
    rotation_from_linear_invariants_vector_1();
    rotation_from_linear_invariants_vector_2();
    rotation_from_linear_invariants_vector_1f();
    rotation_from_linear_invariants_vector_2f();
    rotation_from_euler_rodrigues_vector_1();
    rotation_from_euler_rodrigues_vector_2();
    rotation_from_euler_rodrigues_vector_1f();
    rotation_from_euler_rodrigues_vector_2f();
    linear_invariants_vector_1();
    linear_invariants_vector_2();
    linear_invariants_vector_1f();
    linear_invariants_vector_2f();
    natural_invariants_vector_1();
    natural_invariants_vector_2();
    natural_invariants_vector_1f();
    natural_invariants_vector_2f();
    euler_rodrigues_parameters_vector_1();
    euler_rodrigues_parameters_vector_2();
    euler_rodrigues_parameters_vector_1f();
    euler_rodrigues_parameters_vector_2f();
    screw_of_motion_vector_1();
    screw_of_motion_vector_2();
    screw_of_motion_vector_1f();
    screw_of_motion_vector_2f();
    instant_screw_vector_1();
    instant_screw_vector_2();
    instant_screw_vector_3();
    instant_screw_vector_1f();
    instant_screw_vector_2f();
    instant_screw_vector_3f();
    natural_velocity_matrix_vector_1();
    natural_velocity_matrix_vector_2();
    natural_velocity_matrix_vector_1f();
    natural_velocity_matrix_vector_2f();
    linear_velocity_matrix_vector_1();
    linear_velocity_matrix_vector_2();
    linear_velocity_matrix_vector_1f();
    linear_velocity_matrix_vector_2f();
    euler_rodrigues_velocity_matrix_vector_1();
    euler_rodrigues_velocity_matrix_vector_2();
    euler_rodrigues_velocity_matrix_vector_1f();
    euler_rodrigues_velocity_matrix_vector_2f();
    pose_rate_natural_vector_1();
    pose_rate_natural_vector_2();
    pose_rate_natural_vector_3();
    pose_rate_natural_vector_1f();
    pose_rate_natural_vector_2f();
    pose_rate_natural_vector_3f();
    pose_rate_linear_vector_1();
    pose_rate_linear_vector_2();
    pose_rate_linear_vector_1f();
    pose_rate_linear_vector_2f();
    pose_rate_euler_rodrigues_vector_1();
    pose_rate_euler_rodrigues_vector_2();
    pose_rate_euler_rodrigues_vector_1f();
    pose_rate_euler_rodrigues_vector_2f();
    twist_from_pose_rate_natural_vector_1();
    twist_from_pose_rate_natural_vector_2();
    twist_from_pose_rate_natural_vector_1f();
    twist_from_pose_rate_natural_vector_2f();
    twist_from_pose_rate_linear_vector_1();
    twist_from_pose_rate_linear_vector_2();
    twist_from_pose_rate_linear_vector_1f();
    twist_from_pose_rate_linear_vector_2f();
    twist_from_pose_rate_euler_rodrigues_vector_1();
    twist_from_pose_rate_euler_rodrigues_vector_2();
    twist_from_pose_rate_euler_rodrigues_vector_1f();
    twist_from_pose_rate_euler_rodrigues_vector_2f();
    twist_transfer_vector_1();
    twist_transfer_vector_2();
    twist_transfer_vector_1f();
    twist_transfer_vector_2f();
    angular_acceleration_matrix_vector_1();
    angular_acceleration_matrix_vector_2();
    angular_acceleration_matrix_vector_1f();
    angular_acceleration_matrix_vector_2f();
    acceleration_of_point_vector_1();
    acceleration_of_point_vector_2();
    acceleration_of_point_vector_1f();
    acceleration_of_point_vector_2f();
    natural_rate_matrix_dot_vector_1();
    natural_rate_matrix_dot_vector_2();
    natural_rate_matrix_dot_vector_3();
    natural_rate_matrix_dot_vector_1f();
    natural_rate_matrix_dot_vector_2f();
    natural_rate_matrix_dot_vector_3f();
    linear_rate_matrix_dot_vector_1();
    linear_rate_matrix_dot_vector_2();
    linear_rate_matrix_dot_vector_1f();
    linear_rate_matrix_dot_vector_2f();
    euler_rodrigues_rate_matrix_dot_vector_1();
    euler_rodrigues_rate_matrix_dot_vector_2();
    euler_rodrigues_rate_matrix_dot_vector_1f();
    euler_rodrigues_rate_matrix_dot_vector_2f();
    natural_velocity_matrix_dot_vector_1();
    natural_velocity_matrix_dot_vector_2();
    natural_velocity_matrix_dot_vector_3();
    natural_velocity_matrix_dot_vector_1f();
    natural_velocity_matrix_dot_vector_2f();
    natural_velocity_matrix_dot_vector_3f();
    linear_velocity_matrix_dot_vector_1();
    linear_velocity_matrix_dot_vector_2();
    linear_velocity_matrix_dot_vector_1f();
    linear_velocity_matrix_dot_vector_2f();
    euler_rodrigues_velocity_matrix_dot_vector_1();
    euler_rodrigues_velocity_matrix_dot_vector_2();
    euler_rodrigues_velocity_matrix_dot_vector_1f();
    euler_rodrigues_velocity_matrix_dot_vector_2f();
    pose_acceleration_natural_vector_1();
    pose_acceleration_natural_vector_2();
    pose_acceleration_natural_vector_3();
    pose_acceleration_natural_vector_1f();
    pose_acceleration_natural_vector_2f();
    pose_acceleration_natural_vector_3f();
    pose_acceleration_linear_vector_1();
    pose_acceleration_linear_vector_2();
    pose_acceleration_linear_vector_1f();
    pose_acceleration_linear_vector_2f();
    pose_acceleration_euler_rodrigues_vector_1();
    pose_acceleration_euler_rodrigues_vector_2();
    pose_acceleration_euler_rodrigues_vector_1f();
    pose_acceleration_euler_rodrigues_vector_2f();
    twist_rate_from_pose_natural_vector_1();
    twist_rate_from_pose_natural_vector_2();
    twist_rate_from_pose_natural_vector_1f();
    twist_rate_from_pose_natural_vector_2f();
    twist_rate_from_pose_linear_vector_1();
    twist_rate_from_pose_linear_vector_2();
    twist_rate_from_pose_linear_vector_1f();
    twist_rate_from_pose_linear_vector_2f();
    twist_rate_from_pose_euler_rodrigues_vector_1();
    twist_rate_from_pose_euler_rodrigues_vector_2();
    twist_rate_from_pose_euler_rodrigues_vector_1f();
    twist_rate_from_pose_euler_rodrigues_vector_2f();
    moving_frame_velocity_vector_1();
    moving_frame_velocity_vector_2();
    moving_frame_velocity_vector_1f();
    moving_frame_velocity_vector_2f();
    moving_frame_acceleration_vector_1();
    moving_frame_acceleration_vector_2();
    moving_frame_acceleration_vector_1f();
    moving_frame_acceleration_vector_2f();
    wrench_axis_vector_1();
    wrench_axis_vector_2();
    wrench_axis_vector_3();
    wrench_axis_vector_1f();
    wrench_axis_vector_2f();
    wrench_axis_vector_3f();
    power_vector_1();
    power_vector_2();
    power_vector_1f();
    power_vector_2f();
    reciprocal_product_vector_1();
    reciprocal_product_vector_2();
    reciprocal_product_vector_1f();
    reciprocal_product_vector_2f();
    wrench_transfer_vector_1();
    wrench_transfer_vector_2();
    wrench_transfer_vector_1f();
    wrench_transfer_vector_2f();
    inertia_about_point_vector_1();
    inertia_about_point_vector_2();
    inertia_about_point_vector_1f();
    inertia_about_point_vector_2f();
    inertia_about_point_sym6_vector_1();
    inertia_about_point_sym6_vector_2();
    inertia_about_point_sym6_vector_1f();
    inertia_about_point_sym6_vector_2f();
    momentum_screw_vector_1();
    momentum_screw_vector_2();
    momentum_screw_vector_1f();
    momentum_screw_vector_2f();
    momentum_screw_sym6_vector_1();
    momentum_screw_sym6_vector_2();
    momentum_screw_sym6_vector_1f();
    momentum_screw_sym6_vector_2f();
    kinetic_energy_vector_1();
    kinetic_energy_vector_2();
    kinetic_energy_vector_1f();
    kinetic_energy_vector_2f();
    kinetic_energy_sym6_vector_1();
    kinetic_energy_sym6_vector_2();
    kinetic_energy_sym6_vector_1f();
    kinetic_energy_sym6_vector_2f();
    newton_euler_wrench_vector_1();
    newton_euler_wrench_vector_2();
    newton_euler_wrench_vector_1f();
    newton_euler_wrench_vector_2f();
    newton_euler_wrench_sym6_vector_1();
    newton_euler_wrench_sym6_vector_2();
    newton_euler_wrench_sym6_vector_1f();
    newton_euler_wrench_sym6_vector_2f();
    newton_euler_twist_rate_vector_1();
    newton_euler_twist_rate_vector_2();
    newton_euler_twist_rate_vector_3();
    newton_euler_twist_rate_vector_1f();
    newton_euler_twist_rate_vector_2f();
    newton_euler_twist_rate_vector_3f();
    newton_euler_twist_rate_sym6_vector_1();
    newton_euler_twist_rate_sym6_vector_2();
    newton_euler_twist_rate_sym6_vector_3();
    newton_euler_twist_rate_sym6_vector_1f();
    newton_euler_twist_rate_sym6_vector_2f();
    newton_euler_twist_rate_sym6_vector_3f();
    inertia_dyad_vector_1();
    inertia_dyad_vector_2();
    inertia_dyad_vector_1f();
    inertia_dyad_vector_2f();
    inertia_dyad_sym6_vector_1();
    inertia_dyad_sym6_vector_2();
    inertia_dyad_sym6_vector_1f();
    inertia_dyad_sym6_vector_2f();
    rotation_from_euler_xyx_vector_1();
    rotation_from_euler_xyx_vector_2();
    rotation_from_euler_xyx_vector_1f();
    rotation_from_euler_xyx_vector_2f();
    euler_rate_matrix_xyx_vector_1();
    euler_rate_matrix_xyx_vector_2();
    euler_rate_matrix_xyx_vector_1f();
    euler_rate_matrix_xyx_vector_2f();
    euler_rate_matrix_body_xyx_vector_1();
    euler_rate_matrix_body_xyx_vector_2();
    euler_rate_matrix_body_xyx_vector_1f();
    euler_rate_matrix_body_xyx_vector_2f();
    euler_rates_xyx_vector_1();
    euler_rates_xyx_vector_2();
    euler_rates_xyx_vector_3();
    euler_rates_xyx_vector_1f();
    euler_rates_xyx_vector_2f();
    euler_rates_xyx_vector_3f();
    rotation_from_euler_xyz_vector_1();
    rotation_from_euler_xyz_vector_2();
    rotation_from_euler_xyz_vector_1f();
    rotation_from_euler_xyz_vector_2f();
    euler_rate_matrix_xyz_vector_1();
    euler_rate_matrix_xyz_vector_2();
    euler_rate_matrix_xyz_vector_1f();
    euler_rate_matrix_xyz_vector_2f();
    euler_rate_matrix_body_xyz_vector_1();
    euler_rate_matrix_body_xyz_vector_2();
    euler_rate_matrix_body_xyz_vector_1f();
    euler_rate_matrix_body_xyz_vector_2f();
    euler_rates_xyz_vector_1();
    euler_rates_xyz_vector_2();
    euler_rates_xyz_vector_1f();
    euler_rates_xyz_vector_2f();
    rotation_from_euler_xzx_vector_1();
    rotation_from_euler_xzx_vector_2();
    rotation_from_euler_xzx_vector_1f();
    rotation_from_euler_xzx_vector_2f();
    euler_rate_matrix_xzx_vector_1();
    euler_rate_matrix_xzx_vector_2();
    euler_rate_matrix_xzx_vector_1f();
    euler_rate_matrix_xzx_vector_2f();
    euler_rate_matrix_body_xzx_vector_1();
    euler_rate_matrix_body_xzx_vector_2();
    euler_rate_matrix_body_xzx_vector_1f();
    euler_rate_matrix_body_xzx_vector_2f();
    euler_rates_xzx_vector_1();
    euler_rates_xzx_vector_2();
    euler_rates_xzx_vector_3();
    euler_rates_xzx_vector_1f();
    euler_rates_xzx_vector_2f();
    euler_rates_xzx_vector_3f();
    rotation_from_euler_xzy_vector_1();
    rotation_from_euler_xzy_vector_2();
    rotation_from_euler_xzy_vector_1f();
    rotation_from_euler_xzy_vector_2f();
    euler_rate_matrix_xzy_vector_1();
    euler_rate_matrix_xzy_vector_2();
    euler_rate_matrix_xzy_vector_1f();
    euler_rate_matrix_xzy_vector_2f();
    euler_rate_matrix_body_xzy_vector_1();
    euler_rate_matrix_body_xzy_vector_2();
    euler_rate_matrix_body_xzy_vector_1f();
    euler_rate_matrix_body_xzy_vector_2f();
    euler_rates_xzy_vector_1();
    euler_rates_xzy_vector_2();
    euler_rates_xzy_vector_1f();
    euler_rates_xzy_vector_2f();
    rotation_from_euler_yxy_vector_1();
    rotation_from_euler_yxy_vector_2();
    rotation_from_euler_yxy_vector_1f();
    rotation_from_euler_yxy_vector_2f();
    euler_rate_matrix_yxy_vector_1();
    euler_rate_matrix_yxy_vector_2();
    euler_rate_matrix_yxy_vector_1f();
    euler_rate_matrix_yxy_vector_2f();
    euler_rate_matrix_body_yxy_vector_1();
    euler_rate_matrix_body_yxy_vector_2();
    euler_rate_matrix_body_yxy_vector_1f();
    euler_rate_matrix_body_yxy_vector_2f();
    euler_rates_yxy_vector_1();
    euler_rates_yxy_vector_2();
    euler_rates_yxy_vector_3();
    euler_rates_yxy_vector_1f();
    euler_rates_yxy_vector_2f();
    euler_rates_yxy_vector_3f();
    rotation_from_euler_yxz_vector_1();
    rotation_from_euler_yxz_vector_2();
    rotation_from_euler_yxz_vector_1f();
    rotation_from_euler_yxz_vector_2f();
    euler_rate_matrix_yxz_vector_1();
    euler_rate_matrix_yxz_vector_2();
    euler_rate_matrix_yxz_vector_1f();
    euler_rate_matrix_yxz_vector_2f();
    euler_rate_matrix_body_yxz_vector_1();
    euler_rate_matrix_body_yxz_vector_2();
    euler_rate_matrix_body_yxz_vector_1f();
    euler_rate_matrix_body_yxz_vector_2f();
    euler_rates_yxz_vector_1();
    euler_rates_yxz_vector_2();
    euler_rates_yxz_vector_1f();
    euler_rates_yxz_vector_2f();
    rotation_from_euler_yzx_vector_1();
    rotation_from_euler_yzx_vector_2();
    rotation_from_euler_yzx_vector_1f();
    rotation_from_euler_yzx_vector_2f();
    euler_rate_matrix_yzx_vector_1();
    euler_rate_matrix_yzx_vector_2();
    euler_rate_matrix_yzx_vector_1f();
    euler_rate_matrix_yzx_vector_2f();
    euler_rate_matrix_body_yzx_vector_1();
    euler_rate_matrix_body_yzx_vector_2();
    euler_rate_matrix_body_yzx_vector_1f();
    euler_rate_matrix_body_yzx_vector_2f();
    euler_rates_yzx_vector_1();
    euler_rates_yzx_vector_2();
    euler_rates_yzx_vector_1f();
    euler_rates_yzx_vector_2f();
    rotation_from_euler_yzy_vector_1();
    rotation_from_euler_yzy_vector_2();
    rotation_from_euler_yzy_vector_1f();
    rotation_from_euler_yzy_vector_2f();
    euler_rate_matrix_yzy_vector_1();
    euler_rate_matrix_yzy_vector_2();
    euler_rate_matrix_yzy_vector_1f();
    euler_rate_matrix_yzy_vector_2f();
    euler_rate_matrix_body_yzy_vector_1();
    euler_rate_matrix_body_yzy_vector_2();
    euler_rate_matrix_body_yzy_vector_1f();
    euler_rate_matrix_body_yzy_vector_2f();
    euler_rates_yzy_vector_1();
    euler_rates_yzy_vector_2();
    euler_rates_yzy_vector_3();
    euler_rates_yzy_vector_1f();
    euler_rates_yzy_vector_2f();
    euler_rates_yzy_vector_3f();
    rotation_from_euler_zxy_vector_1();
    rotation_from_euler_zxy_vector_2();
    rotation_from_euler_zxy_vector_1f();
    rotation_from_euler_zxy_vector_2f();
    euler_rate_matrix_zxy_vector_1();
    euler_rate_matrix_zxy_vector_2();
    euler_rate_matrix_zxy_vector_1f();
    euler_rate_matrix_zxy_vector_2f();
    euler_rate_matrix_body_zxy_vector_1();
    euler_rate_matrix_body_zxy_vector_2();
    euler_rate_matrix_body_zxy_vector_1f();
    euler_rate_matrix_body_zxy_vector_2f();
    euler_rates_zxy_vector_1();
    euler_rates_zxy_vector_2();
    euler_rates_zxy_vector_1f();
    euler_rates_zxy_vector_2f();
    rotation_from_euler_zxz_vector_1();
    rotation_from_euler_zxz_vector_2();
    rotation_from_euler_zxz_vector_1f();
    rotation_from_euler_zxz_vector_2f();
    euler_rate_matrix_zxz_vector_1();
    euler_rate_matrix_zxz_vector_2();
    euler_rate_matrix_zxz_vector_1f();
    euler_rate_matrix_zxz_vector_2f();
    euler_rate_matrix_body_zxz_vector_1();
    euler_rate_matrix_body_zxz_vector_2();
    euler_rate_matrix_body_zxz_vector_1f();
    euler_rate_matrix_body_zxz_vector_2f();
    euler_rates_zxz_vector_1();
    euler_rates_zxz_vector_2();
    euler_rates_zxz_vector_3();
    euler_rates_zxz_vector_1f();
    euler_rates_zxz_vector_2f();
    euler_rates_zxz_vector_3f();
    rotation_from_euler_zyx_vector_1();
    rotation_from_euler_zyx_vector_2();
    rotation_from_euler_zyx_vector_1f();
    rotation_from_euler_zyx_vector_2f();
    euler_rate_matrix_zyx_vector_1();
    euler_rate_matrix_zyx_vector_2();
    euler_rate_matrix_zyx_vector_1f();
    euler_rate_matrix_zyx_vector_2f();
    euler_rate_matrix_body_zyx_vector_1();
    euler_rate_matrix_body_zyx_vector_2();
    euler_rate_matrix_body_zyx_vector_1f();
    euler_rate_matrix_body_zyx_vector_2f();
    euler_rates_zyx_vector_1();
    euler_rates_zyx_vector_2();
    euler_rates_zyx_vector_1f();
    euler_rates_zyx_vector_2f();
    rotation_from_euler_zyz_vector_1();
    rotation_from_euler_zyz_vector_2();
    rotation_from_euler_zyz_vector_1f();
    rotation_from_euler_zyz_vector_2f();
    euler_rate_matrix_zyz_vector_1();
    euler_rate_matrix_zyz_vector_2();
    euler_rate_matrix_zyz_vector_1f();
    euler_rate_matrix_zyz_vector_2f();
    euler_rate_matrix_body_zyz_vector_1();
    euler_rate_matrix_body_zyz_vector_2();
    euler_rate_matrix_body_zyz_vector_1f();
    euler_rate_matrix_body_zyz_vector_2f();
    euler_rates_zyz_vector_1();
    euler_rates_zyz_vector_2();
    euler_rates_zyz_vector_3();
    euler_rates_zyz_vector_1f();
    euler_rates_zyz_vector_2f();
    euler_rates_zyz_vector_3f();
    printf("%d passed, %d failed\n", passed, failed);
    return passed > 0 && failed == 0 ? 0 : 1;
}
