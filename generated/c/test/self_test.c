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
    momentum_screw_vector_1();
    momentum_screw_vector_2();
    momentum_screw_vector_1f();
    momentum_screw_vector_2f();
    kinetic_energy_vector_1();
    kinetic_energy_vector_2();
    kinetic_energy_vector_1f();
    kinetic_energy_vector_2f();
    newton_euler_wrench_vector_1();
    newton_euler_wrench_vector_2();
    newton_euler_wrench_vector_1f();
    newton_euler_wrench_vector_2f();
    newton_euler_twist_rate_vector_1();
    newton_euler_twist_rate_vector_2();
    newton_euler_twist_rate_vector_3();
    newton_euler_twist_rate_vector_1f();
    newton_euler_twist_rate_vector_2f();
    newton_euler_twist_rate_vector_3f();
    inertia_dyad_vector_1();
    inertia_dyad_vector_2();
    inertia_dyad_vector_1f();
    inertia_dyad_vector_2f();
    printf("%d passed, %d failed\n", passed, failed);
    return passed > 0 && failed == 0 ? 0 : 1;
}
