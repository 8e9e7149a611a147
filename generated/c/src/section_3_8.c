/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The kernels of section_3_8. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"
#include "loops.h"

static const chasles_shape chasles_inertia_about_point_loop_shapes[] = {
    {2, 3, 3},
    {0, 1, 1},
    {1, 1, 3},
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_inertia_about_point_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_inertia_about_point_loop_shapes,
    CHASLES_BLOCKS(chasles_inertia_about_point_block),
};

static const chasles_shape chasles_inertia_about_point_loopf_shapes[] = {
    {2, 3, 3},
    {0, 1, 1},
    {1, 1, 3},
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_inertia_about_point_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_inertia_about_point_loopf_shapes,
    CHASLES_BLOCKS(chasles_inertia_about_point_blockf),
};

static const chasles_shape chasles_inertia_about_point_sym6_loop_shapes[] = {
    {1, 1, 6},
    {0, 1, 1},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
};
const chasles_loop chasles_inertia_about_point_sym6_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_inertia_about_point_sym6_loop_shapes,
    CHASLES_BLOCKS(chasles_inertia_about_point_sym6_block),
};

static const chasles_shape chasles_inertia_about_point_sym6_loopf_shapes[] = {
    {1, 1, 6},
    {0, 1, 1},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
};
const chasles_loop chasles_inertia_about_point_sym6_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_inertia_about_point_sym6_loopf_shapes,
    CHASLES_BLOCKS(chasles_inertia_about_point_sym6_blockf),
};

static const chasles_shape chasles_momentum_screw_loop_shapes[] = {
    {2, 3, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
};
const chasles_loop chasles_momentum_screw_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_momentum_screw_loop_shapes,
    CHASLES_BLOCKS(chasles_momentum_screw_block),
};

static const chasles_shape chasles_momentum_screw_loopf_shapes[] = {
    {2, 3, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
};
const chasles_loop chasles_momentum_screw_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_momentum_screw_loopf_shapes,
    CHASLES_BLOCKS(chasles_momentum_screw_blockf),
};

static const chasles_shape chasles_momentum_screw_sym6_loop_shapes[] = {
    {1, 1, 6},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
};
const chasles_loop chasles_momentum_screw_sym6_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_momentum_screw_sym6_loop_shapes,
    CHASLES_BLOCKS(chasles_momentum_screw_sym6_block),
};

static const chasles_shape chasles_momentum_screw_sym6_loopf_shapes[] = {
    {1, 1, 6},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
};
const chasles_loop chasles_momentum_screw_sym6_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_momentum_screw_sym6_loopf_shapes,
    CHASLES_BLOCKS(chasles_momentum_screw_sym6_blockf),
};

static const chasles_shape chasles_kinetic_energy_loop_shapes[] = {
    {2, 3, 3},
    {0, 1, 1},
    {1, 1, 6},
    {0, 1, 1},
};
const chasles_loop chasles_kinetic_energy_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_kinetic_energy_loop_shapes,
    CHASLES_BLOCKS(chasles_kinetic_energy_block),
};

static const chasles_shape chasles_kinetic_energy_loopf_shapes[] = {
    {2, 3, 3},
    {0, 1, 1},
    {1, 1, 6},
    {0, 1, 1},
};
const chasles_loop chasles_kinetic_energy_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_kinetic_energy_loopf_shapes,
    CHASLES_BLOCKS(chasles_kinetic_energy_blockf),
};

static const chasles_shape chasles_kinetic_energy_sym6_loop_shapes[] = {
    {1, 1, 6},
    {0, 1, 1},
    {1, 1, 6},
    {0, 1, 1},
};
const chasles_loop chasles_kinetic_energy_sym6_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_kinetic_energy_sym6_loop_shapes,
    CHASLES_BLOCKS(chasles_kinetic_energy_sym6_block),
};

static const chasles_shape chasles_kinetic_energy_sym6_loopf_shapes[] = {
    {1, 1, 6},
    {0, 1, 1},
    {1, 1, 6},
    {0, 1, 1},
};
const chasles_loop chasles_kinetic_energy_sym6_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_kinetic_energy_sym6_loopf_shapes,
    CHASLES_BLOCKS(chasles_kinetic_energy_sym6_blockf),
};

static const chasles_shape chasles_newton_euler_wrench_loop_shapes[] = {
    {2, 3, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
    {1, 1, 6},
};
const chasles_loop chasles_newton_euler_wrench_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_newton_euler_wrench_loop_shapes,
    CHASLES_BLOCKS(chasles_newton_euler_wrench_block),
};

static const chasles_shape chasles_newton_euler_wrench_loopf_shapes[] = {
    {2, 3, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
    {1, 1, 6},
};
const chasles_loop chasles_newton_euler_wrench_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_newton_euler_wrench_loopf_shapes,
    CHASLES_BLOCKS(chasles_newton_euler_wrench_blockf),
};

static const chasles_shape chasles_newton_euler_wrench_sym6_loop_shapes[] = {
    {1, 1, 6},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
    {1, 1, 6},
};
const chasles_loop chasles_newton_euler_wrench_sym6_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_newton_euler_wrench_sym6_loop_shapes,
    CHASLES_BLOCKS(chasles_newton_euler_wrench_sym6_block),
};

static const chasles_shape chasles_newton_euler_wrench_sym6_loopf_shapes[] = {
    {1, 1, 6},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
    {1, 1, 6},
};
const chasles_loop chasles_newton_euler_wrench_sym6_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_newton_euler_wrench_sym6_loopf_shapes,
    CHASLES_BLOCKS(chasles_newton_euler_wrench_sym6_blockf),
};

static const chasles_shape chasles_newton_euler_twist_rate_loop_shapes[] = {
    {2, 3, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
    {1, 1, 6},
};
const chasles_loop chasles_newton_euler_twist_rate_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_newton_euler_twist_rate_loop_shapes,
    CHASLES_BLOCKS(chasles_newton_euler_twist_rate_block),
};

static const chasles_shape chasles_newton_euler_twist_rate_loopf_shapes[] = {
    {2, 3, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
    {1, 1, 6},
};
const chasles_loop chasles_newton_euler_twist_rate_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_newton_euler_twist_rate_loopf_shapes,
    CHASLES_BLOCKS(chasles_newton_euler_twist_rate_blockf),
};

static const chasles_shape chasles_newton_euler_twist_rate_sym6_loop_shapes[] = {
    {1, 1, 6},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
    {1, 1, 6},
};
const chasles_loop chasles_newton_euler_twist_rate_sym6_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_newton_euler_twist_rate_sym6_loop_shapes,
    CHASLES_BLOCKS(chasles_newton_euler_twist_rate_sym6_block),
};

static const chasles_shape chasles_newton_euler_twist_rate_sym6_loopf_shapes[] = {
    {1, 1, 6},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 6},
    {1, 1, 6},
};
const chasles_loop chasles_newton_euler_twist_rate_sym6_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_newton_euler_twist_rate_sym6_loopf_shapes,
    CHASLES_BLOCKS(chasles_newton_euler_twist_rate_sym6_blockf),
};

static const chasles_shape chasles_inertia_dyad_loop_shapes[] = {
    {2, 3, 3},
    {0, 1, 1},
    {1, 1, 3},
    {1, 1, 3},
    {2, 6, 6},
};
const chasles_loop chasles_inertia_dyad_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_inertia_dyad_loop_shapes,
    CHASLES_BLOCKS(chasles_inertia_dyad_block),
};

static const chasles_shape chasles_inertia_dyad_loopf_shapes[] = {
    {2, 3, 3},
    {0, 1, 1},
    {1, 1, 3},
    {1, 1, 3},
    {2, 6, 6},
};
const chasles_loop chasles_inertia_dyad_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_inertia_dyad_loopf_shapes,
    CHASLES_BLOCKS(chasles_inertia_dyad_blockf),
};

static const chasles_shape chasles_inertia_dyad_sym6_loop_shapes[] = {
    {1, 1, 6},
    {0, 1, 1},
    {1, 1, 3},
    {1, 1, 3},
    {2, 6, 6},
};
const chasles_loop chasles_inertia_dyad_sym6_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_inertia_dyad_sym6_loop_shapes,
    CHASLES_BLOCKS(chasles_inertia_dyad_sym6_block),
};

static const chasles_shape chasles_inertia_dyad_sym6_loopf_shapes[] = {
    {1, 1, 6},
    {0, 1, 1},
    {1, 1, 3},
    {1, 1, 3},
    {2, 6, 6},
};
const chasles_loop chasles_inertia_dyad_sym6_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    4, 5, chasles_inertia_dyad_sym6_loopf_shapes,
    CHASLES_BLOCKS(chasles_inertia_dyad_sym6_blockf),
};

#if !(CHASLES_VECTORS && defined(CHASLES_BLOCKS_ALONE))

/*
 * (3.133a) Steiner's theorem: the moment of inertia with respect to A from that at the center of mass.
 *   given       I_C[9]: moment of inertia at the center of mass
 *               m: mass
 *               c[3]: position of the center of mass
 *               a[3]: position of the landmark point A
 *   returns     I_A[9]: moment of inertia with respect to A
 *   verdict     holds under
 *   assumes     m > 0
 *   expects     I_C is symmetric
 *   operations  24: 6 add, 9 subtract, 9 multiply
 *   error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 4d7619030bc619e84b4607eaec8efd339cf9160ce49e3d74dfaae1e4b7730c87
 */
void chasles_inertia_about_point(
    const double I_C[9],
    double m,
    const double c[3],
    const double a[3],
    double I_A[9])
{
    const double t1 = a[0] - c[0];
    const double t2 = a[1] - c[1];
    const double t3 = a[2] - c[2];
    const double t4 = m * t2;
    const double t5 = m * t3;
    const double t6 = t1 * (m * t1);
    const double t7 = t1 * t4;
    const double t8 = t1 * t5;
    const double t9 = t2 * t4;
    const double t10 = t2 * t5;
    const double t11 = t3 * t5;
    const double I_A0 = I_C[0] + (t9 + t11);
    const double I_A1 = I_C[1] - t7;
    const double I_A2 = I_C[2] - t8;
    const double I_A3 = I_C[3] - t7;
    const double I_A4 = I_C[4] + (t6 + t11);
    const double I_A5 = I_C[5] - t10;
    const double I_A6 = I_C[6] - t8;
    const double I_A7 = I_C[7] - t10;
    const double I_A8 = I_C[8] + (t6 + t9);
    I_A[0] = I_A0;
    I_A[1] = I_A1;
    I_A[2] = I_A2;
    I_A[3] = I_A3;
    I_A[4] = I_A4;
    I_A[5] = I_A5;
    I_A[6] = I_A6;
    I_A[7] = I_A7;
    I_A[8] = I_A8;
}

/*
 * (3.133a) chasles_inertia_about_point in single precision.
 *   verdict: holds under; assumes m > 0
 *   24 operations; derivation sha256 4d7619030bc619e84b4607eaec8efd339cf9160ce49e3d74dfaae1e4b7730c87
 */
void chasles_inertia_about_pointf(
    const float I_C[9],
    float m,
    const float c[3],
    const float a[3],
    float I_A[9])
{
    const float t1 = a[0] - c[0];
    const float t2 = a[1] - c[1];
    const float t3 = a[2] - c[2];
    const float t4 = m * t2;
    const float t5 = m * t3;
    const float t6 = t1 * (m * t1);
    const float t7 = t1 * t4;
    const float t8 = t1 * t5;
    const float t9 = t2 * t4;
    const float t10 = t2 * t5;
    const float t11 = t3 * t5;
    const float I_A0 = I_C[0] + (t9 + t11);
    const float I_A1 = I_C[1] - t7;
    const float I_A2 = I_C[2] - t8;
    const float I_A3 = I_C[3] - t7;
    const float I_A4 = I_C[4] + (t6 + t11);
    const float I_A5 = I_C[5] - t10;
    const float I_A6 = I_C[6] - t8;
    const float I_A7 = I_C[7] - t10;
    const float I_A8 = I_C[8] + (t6 + t9);
    I_A[0] = I_A0;
    I_A[1] = I_A1;
    I_A[2] = I_A2;
    I_A[3] = I_A3;
    I_A[4] = I_A4;
    I_A[5] = I_A5;
    I_A[6] = I_A6;
    I_A[7] = I_A7;
    I_A[8] = I_A8;
}

/*
 * (3.133a) chasles_inertia_about_point for a batch.
 *   verdict: holds under; assumes m > 0
 *   24 operations; derivation sha256 4d7619030bc619e84b4607eaec8efd339cf9160ce49e3d74dfaae1e4b7730c87
 */
void chasles_inertia_about_point_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *c, ptrdiff_t c_step,
    const double *a, ptrdiff_t a_step,
    double *I_A, ptrdiff_t I_A_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)c, (char *)a, (char *)I_A};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        c_step * size,
        a_step * size,
        I_A_step * size};
    const chasles_loop *loop = &chasles_inertia_about_point_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.133a) chasles_inertia_about_pointf for a batch.
 *   verdict: holds under; assumes m > 0
 *   24 operations; derivation sha256 4d7619030bc619e84b4607eaec8efd339cf9160ce49e3d74dfaae1e4b7730c87
 */
void chasles_inertia_about_point_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *c, ptrdiff_t c_step,
    const float *a, ptrdiff_t a_step,
    float *I_A, ptrdiff_t I_A_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)c, (char *)a, (char *)I_A};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        c_step * size,
        a_step * size,
        I_A_step * size};
    const chasles_loop *loop = &chasles_inertia_about_point_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.133a) Steiner's theorem: the moment of inertia with respect to A from that at the center of mass.
 *   given       I_C[6]: moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,
 *                 zz)
 *               m: mass
 *               c[3]: position of the center of mass
 *               a[3]: position of the landmark point A
 *   returns     I_A[6]: moment of inertia with respect to A, symmetric, as (xx, xy, xz, yy, yz, zz)
 *   verdict     holds under
 *   assumes     m > 0
 *   expects     I_C is symmetric
 *   operations  21: 6 add, 6 subtract, 9 multiply
 *   error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 4d7619030bc619e84b4607eaec8efd339cf9160ce49e3d74dfaae1e4b7730c87
 */
void chasles_inertia_about_point_sym6(
    const double I_C[6],
    double m,
    const double c[3],
    const double a[3],
    double I_A[6])
{
    const double t1 = a[0] - c[0];
    const double t2 = a[1] - c[1];
    const double t3 = a[2] - c[2];
    const double t4 = m * t2;
    const double t5 = m * t3;
    const double t6 = t1 * (m * t1);
    const double t7 = t2 * t4;
    const double t8 = t3 * t5;
    const double I_A0 = I_C[0] + (t7 + t8);
    const double I_A1 = I_C[1] - t1 * t4;
    const double I_A2 = I_C[2] - t1 * t5;
    const double I_A3 = I_C[3] + (t6 + t8);
    const double I_A4 = I_C[4] - t2 * t5;
    const double I_A5 = I_C[5] + (t6 + t7);
    I_A[0] = I_A0;
    I_A[1] = I_A1;
    I_A[2] = I_A2;
    I_A[3] = I_A3;
    I_A[4] = I_A4;
    I_A[5] = I_A5;
}

/*
 * (3.133a) chasles_inertia_about_point_sym6 in single precision.
 *   verdict: holds under; assumes m > 0
 *   21 operations; derivation sha256 4d7619030bc619e84b4607eaec8efd339cf9160ce49e3d74dfaae1e4b7730c87
 */
void chasles_inertia_about_point_sym6f(
    const float I_C[6],
    float m,
    const float c[3],
    const float a[3],
    float I_A[6])
{
    const float t1 = a[0] - c[0];
    const float t2 = a[1] - c[1];
    const float t3 = a[2] - c[2];
    const float t4 = m * t2;
    const float t5 = m * t3;
    const float t6 = t1 * (m * t1);
    const float t7 = t2 * t4;
    const float t8 = t3 * t5;
    const float I_A0 = I_C[0] + (t7 + t8);
    const float I_A1 = I_C[1] - t1 * t4;
    const float I_A2 = I_C[2] - t1 * t5;
    const float I_A3 = I_C[3] + (t6 + t8);
    const float I_A4 = I_C[4] - t2 * t5;
    const float I_A5 = I_C[5] + (t6 + t7);
    I_A[0] = I_A0;
    I_A[1] = I_A1;
    I_A[2] = I_A2;
    I_A[3] = I_A3;
    I_A[4] = I_A4;
    I_A[5] = I_A5;
}

/*
 * (3.133a) chasles_inertia_about_point_sym6 for a batch.
 *   verdict: holds under; assumes m > 0
 *   21 operations; derivation sha256 4d7619030bc619e84b4607eaec8efd339cf9160ce49e3d74dfaae1e4b7730c87
 */
void chasles_inertia_about_point_sym6_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *c, ptrdiff_t c_step,
    const double *a, ptrdiff_t a_step,
    double *I_A, ptrdiff_t I_A_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)c, (char *)a, (char *)I_A};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        c_step * size,
        a_step * size,
        I_A_step * size};
    const chasles_loop *loop = &chasles_inertia_about_point_sym6_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.133a) chasles_inertia_about_point_sym6f for a batch.
 *   verdict: holds under; assumes m > 0
 *   21 operations; derivation sha256 4d7619030bc619e84b4607eaec8efd339cf9160ce49e3d74dfaae1e4b7730c87
 */
void chasles_inertia_about_point_sym6_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *c, ptrdiff_t c_step,
    const float *a, ptrdiff_t a_step,
    float *I_A, ptrdiff_t I_A_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)c, (char *)a, (char *)I_A};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        c_step * size,
        a_step * size,
        I_A_step * size};
    const chasles_loop *loop = &chasles_inertia_about_point_sym6_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.142) The momentum screw by inertia dyad and twist.
 *   given       I_C[9]: moment of inertia at the center of mass
 *               m: mass
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *   returns     mu[6]: [I_C omega; m c_dot]
 *   verdict     holds
 *   assumes     nothing
 *   expects     I_C is symmetric
 *               m > 0
 *   operations  18: 6 add, 12 multiply
 *   error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 6db3e3a77ef9af159d0c096ec679c53626cff81d41ccfbcc2a4db4833ae93473
 */
void chasles_momentum_screw(const double I_C[9], double m, const double t[6], double mu[6])
{
    const double mu0 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
    const double mu1 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
    const double mu2 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
    const double mu3 = m * t[3];
    const double mu4 = m * t[4];
    const double mu5 = m * t[5];
    mu[0] = mu0;
    mu[1] = mu1;
    mu[2] = mu2;
    mu[3] = mu3;
    mu[4] = mu4;
    mu[5] = mu5;
}

/*
 * (3.142) chasles_momentum_screw in single precision.
 *   verdict: holds; assumes nothing
 *   18 operations; derivation sha256 6db3e3a77ef9af159d0c096ec679c53626cff81d41ccfbcc2a4db4833ae93473
 */
void chasles_momentum_screwf(const float I_C[9], float m, const float t[6], float mu[6])
{
    const float mu0 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
    const float mu1 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
    const float mu2 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
    const float mu3 = m * t[3];
    const float mu4 = m * t[4];
    const float mu5 = m * t[5];
    mu[0] = mu0;
    mu[1] = mu1;
    mu[2] = mu2;
    mu[3] = mu3;
    mu[4] = mu4;
    mu[5] = mu5;
}

/*
 * (3.142) chasles_momentum_screw for a batch.
 *   verdict: holds; assumes nothing
 *   18 operations; derivation sha256 6db3e3a77ef9af159d0c096ec679c53626cff81d41ccfbcc2a4db4833ae93473
 */
void chasles_momentum_screw_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    double *mu, ptrdiff_t mu_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)mu};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {I_C_step * size, m_step * size, t_step * size, mu_step * size};
    const chasles_loop *loop = &chasles_momentum_screw_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.142) chasles_momentum_screwf for a batch.
 *   verdict: holds; assumes nothing
 *   18 operations; derivation sha256 6db3e3a77ef9af159d0c096ec679c53626cff81d41ccfbcc2a4db4833ae93473
 */
void chasles_momentum_screw_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *t, ptrdiff_t t_step,
    float *mu, ptrdiff_t mu_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)mu};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {I_C_step * size, m_step * size, t_step * size, mu_step * size};
    const chasles_loop *loop = &chasles_momentum_screw_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.142) The momentum screw by inertia dyad and twist.
 *   given       I_C[6]: moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,
 *                 zz)
 *               m: mass
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *   returns     mu[6]: [I_C omega; m c_dot]
 *   verdict     holds
 *   assumes     nothing
 *   expects     I_C is symmetric
 *               m > 0
 *   operations  18: 6 add, 12 multiply
 *   error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 6db3e3a77ef9af159d0c096ec679c53626cff81d41ccfbcc2a4db4833ae93473
 */
void chasles_momentum_screw_sym6(const double I_C[6], double m, const double t[6], double mu[6])
{
    const double mu0 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
    const double mu1 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
    const double mu2 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
    const double mu3 = m * t[3];
    const double mu4 = m * t[4];
    const double mu5 = m * t[5];
    mu[0] = mu0;
    mu[1] = mu1;
    mu[2] = mu2;
    mu[3] = mu3;
    mu[4] = mu4;
    mu[5] = mu5;
}

/*
 * (3.142) chasles_momentum_screw_sym6 in single precision.
 *   verdict: holds; assumes nothing
 *   18 operations; derivation sha256 6db3e3a77ef9af159d0c096ec679c53626cff81d41ccfbcc2a4db4833ae93473
 */
void chasles_momentum_screw_sym6f(const float I_C[6], float m, const float t[6], float mu[6])
{
    const float mu0 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
    const float mu1 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
    const float mu2 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
    const float mu3 = m * t[3];
    const float mu4 = m * t[4];
    const float mu5 = m * t[5];
    mu[0] = mu0;
    mu[1] = mu1;
    mu[2] = mu2;
    mu[3] = mu3;
    mu[4] = mu4;
    mu[5] = mu5;
}

/*
 * (3.142) chasles_momentum_screw_sym6 for a batch.
 *   verdict: holds; assumes nothing
 *   18 operations; derivation sha256 6db3e3a77ef9af159d0c096ec679c53626cff81d41ccfbcc2a4db4833ae93473
 */
void chasles_momentum_screw_sym6_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    double *mu, ptrdiff_t mu_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)mu};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {I_C_step * size, m_step * size, t_step * size, mu_step * size};
    const chasles_loop *loop = &chasles_momentum_screw_sym6_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.142) chasles_momentum_screw_sym6f for a batch.
 *   verdict: holds; assumes nothing
 *   18 operations; derivation sha256 6db3e3a77ef9af159d0c096ec679c53626cff81d41ccfbcc2a4db4833ae93473
 */
void chasles_momentum_screw_sym6_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *t, ptrdiff_t t_step,
    float *mu, ptrdiff_t mu_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)mu};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {I_C_step * size, m_step * size, t_step * size, mu_step * size};
    const chasles_loop *loop = &chasles_momentum_screw_sym6_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.145) The kinetic energy as a quadratic form of the twist.
 *   given       I_C[9]: moment of inertia at the center of mass
 *               m: mass
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *   returns     T: kinetic energy
 *   verdict     holds
 *   assumes     nothing
 *   expects     I_C is symmetric
 *               m > 0
 *   operations  35: 11 add, 24 multiply
 *   error bound 9.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 69297c38ebd3f2599e0000c019f576151ae0e8d563b8a02661f982c45230000e
 */
void chasles_kinetic_energy(const double I_C[9], double m, const double t[6], double *T)
{
    const double t1 = (I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]) * (0.5 * t[0]);
    const double t2 = t1 + (I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]) * (0.5 * t[1]);
    const double t3 = t2 + (I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2]) * (0.5 * t[2]);
    const double t4 = t3 + m * t[3] * (0.5 * t[3]) + m * t[4] * (0.5 * t[4]);
    const double T_value = t4 + m * t[5] * (0.5 * t[5]);
    *T = T_value;
}

/*
 * (3.145) chasles_kinetic_energy in single precision.
 *   verdict: holds; assumes nothing
 *   35 operations; derivation sha256 69297c38ebd3f2599e0000c019f576151ae0e8d563b8a02661f982c45230000e
 */
void chasles_kinetic_energyf(const float I_C[9], float m, const float t[6], float *T)
{
    const float t1 = (I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]) * (0.5f * t[0]);
    const float t2 = t1 + (I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]) * (0.5f * t[1]);
    const float t3 = t2 + (I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2]) * (0.5f * t[2]);
    const float t4 = t3 + m * t[3] * (0.5f * t[3]) + m * t[4] * (0.5f * t[4]);
    const float T_value = t4 + m * t[5] * (0.5f * t[5]);
    *T = T_value;
}

/*
 * (3.145) chasles_kinetic_energy for a batch.
 *   verdict: holds; assumes nothing
 *   35 operations; derivation sha256 69297c38ebd3f2599e0000c019f576151ae0e8d563b8a02661f982c45230000e
 */
void chasles_kinetic_energy_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    double *T, ptrdiff_t T_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)T};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {I_C_step * size, m_step * size, t_step * size, T_step * size};
    const chasles_loop *loop = &chasles_kinetic_energy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.145) chasles_kinetic_energyf for a batch.
 *   verdict: holds; assumes nothing
 *   35 operations; derivation sha256 69297c38ebd3f2599e0000c019f576151ae0e8d563b8a02661f982c45230000e
 */
void chasles_kinetic_energy_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *t, ptrdiff_t t_step,
    float *T, ptrdiff_t T_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)T};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {I_C_step * size, m_step * size, t_step * size, T_step * size};
    const chasles_loop *loop = &chasles_kinetic_energy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.145) The kinetic energy as a quadratic form of the twist.
 *   given       I_C[6]: moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,
 *                 zz)
 *               m: mass
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *   returns     T: kinetic energy
 *   verdict     holds
 *   assumes     nothing
 *   expects     I_C is symmetric
 *               m > 0
 *   operations  35: 11 add, 24 multiply
 *   error bound 9.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 69297c38ebd3f2599e0000c019f576151ae0e8d563b8a02661f982c45230000e
 */
void chasles_kinetic_energy_sym6(const double I_C[6], double m, const double t[6], double *T)
{
    const double t1 = (I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]) * (0.5 * t[0]);
    const double t2 = t1 + (I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2]) * (0.5 * t[1]);
    const double t3 = t2 + (I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]) * (0.5 * t[2]);
    const double t4 = t3 + m * t[3] * (0.5 * t[3]) + m * t[4] * (0.5 * t[4]);
    const double T_value = t4 + m * t[5] * (0.5 * t[5]);
    *T = T_value;
}

/*
 * (3.145) chasles_kinetic_energy_sym6 in single precision.
 *   verdict: holds; assumes nothing
 *   35 operations; derivation sha256 69297c38ebd3f2599e0000c019f576151ae0e8d563b8a02661f982c45230000e
 */
void chasles_kinetic_energy_sym6f(const float I_C[6], float m, const float t[6], float *T)
{
    const float t1 = (I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2]) * (0.5f * t[0]);
    const float t2 = t1 + (I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2]) * (0.5f * t[1]);
    const float t3 = t2 + (I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2]) * (0.5f * t[2]);
    const float t4 = t3 + m * t[3] * (0.5f * t[3]) + m * t[4] * (0.5f * t[4]);
    const float T_value = t4 + m * t[5] * (0.5f * t[5]);
    *T = T_value;
}

/*
 * (3.145) chasles_kinetic_energy_sym6 for a batch.
 *   verdict: holds; assumes nothing
 *   35 operations; derivation sha256 69297c38ebd3f2599e0000c019f576151ae0e8d563b8a02661f982c45230000e
 */
void chasles_kinetic_energy_sym6_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    double *T, ptrdiff_t T_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)T};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {I_C_step * size, m_step * size, t_step * size, T_step * size};
    const chasles_loop *loop = &chasles_kinetic_energy_sym6_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.145) chasles_kinetic_energy_sym6f for a batch.
 *   verdict: holds; assumes nothing
 *   35 operations; derivation sha256 69297c38ebd3f2599e0000c019f576151ae0e8d563b8a02661f982c45230000e
 */
void chasles_kinetic_energy_sym6_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *t, ptrdiff_t t_step,
    float *T, ptrdiff_t T_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)T};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {I_C_step * size, m_step * size, t_step * size, T_step * size};
    const chasles_loop *loop = &chasles_kinetic_energy_sym6_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.8 v The wrench that moves the body: the Newton-Euler equations as they stand.
 *   given       I_C[9]: moment of inertia at the center of mass
 *               m: mass
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *               t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   returns     w[6]: wrench: moment, force
 *   verdict     holds
 *   assumes     nothing
 *   expects     I_C is symmetric
 *               m > 0
 *   operations  45: 15 add, 3 subtract, 27 multiply
 *   error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 4e831789b8f20b1f8ebea121e0d8d47b7074e8225c3fd379d0994cdf87959c79
 */
void chasles_newton_euler_wrench(
    const double I_C[9],
    double m,
    const double t[6],
    const double t_dot[6],
    double w[6])
{
    const double w3 = m * t_dot[3];
    const double w4 = m * t_dot[4];
    const double w5 = m * t_dot[5];
    const double t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
    const double t2 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
    const double t3 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
    const double t4 = I_C[0] * t_dot[0] + I_C[1] * t_dot[1] + I_C[2] * t_dot[2];
    const double w0 = t4 + (t[1] * t3 - t[2] * t2);
    const double t5 = I_C[3] * t_dot[0] + I_C[4] * t_dot[1] + I_C[5] * t_dot[2];
    const double w1 = t5 + (t[2] * t1 - t[0] * t3);
    const double t6 = I_C[6] * t_dot[0] + I_C[7] * t_dot[1] + I_C[8] * t_dot[2];
    const double w2 = t6 + (t[0] * t2 - t[1] * t1);
    w[0] = w0;
    w[1] = w1;
    w[2] = w2;
    w[3] = w3;
    w[4] = w4;
    w[5] = w5;
}

/*
 * text 3.8 v chasles_newton_euler_wrench in single precision.
 *   verdict: holds; assumes nothing
 *   45 operations; derivation sha256 4e831789b8f20b1f8ebea121e0d8d47b7074e8225c3fd379d0994cdf87959c79
 */
void chasles_newton_euler_wrenchf(
    const float I_C[9],
    float m,
    const float t[6],
    const float t_dot[6],
    float w[6])
{
    const float w3 = m * t_dot[3];
    const float w4 = m * t_dot[4];
    const float w5 = m * t_dot[5];
    const float t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
    const float t2 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
    const float t3 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
    const float t4 = I_C[0] * t_dot[0] + I_C[1] * t_dot[1] + I_C[2] * t_dot[2];
    const float w0 = t4 + (t[1] * t3 - t[2] * t2);
    const float t5 = I_C[3] * t_dot[0] + I_C[4] * t_dot[1] + I_C[5] * t_dot[2];
    const float w1 = t5 + (t[2] * t1 - t[0] * t3);
    const float t6 = I_C[6] * t_dot[0] + I_C[7] * t_dot[1] + I_C[8] * t_dot[2];
    const float w2 = t6 + (t[0] * t2 - t[1] * t1);
    w[0] = w0;
    w[1] = w1;
    w[2] = w2;
    w[3] = w3;
    w[4] = w4;
    w[5] = w5;
}

/*
 * text 3.8 v chasles_newton_euler_wrench for a batch.
 *   verdict: holds; assumes nothing
 *   45 operations; derivation sha256 4e831789b8f20b1f8ebea121e0d8d47b7074e8225c3fd379d0994cdf87959c79
 */
void chasles_newton_euler_wrench_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    const double *t_dot, ptrdiff_t t_dot_step,
    double *w, ptrdiff_t w_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)t_dot, (char *)w};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        t_step * size,
        t_dot_step * size,
        w_step * size};
    const chasles_loop *loop = &chasles_newton_euler_wrench_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.8 v chasles_newton_euler_wrenchf for a batch.
 *   verdict: holds; assumes nothing
 *   45 operations; derivation sha256 4e831789b8f20b1f8ebea121e0d8d47b7074e8225c3fd379d0994cdf87959c79
 */
void chasles_newton_euler_wrench_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *t, ptrdiff_t t_step,
    const float *t_dot, ptrdiff_t t_dot_step,
    float *w, ptrdiff_t w_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)t_dot, (char *)w};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        t_step * size,
        t_dot_step * size,
        w_step * size};
    const chasles_loop *loop = &chasles_newton_euler_wrench_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.8 v The wrench that moves the body: the Newton-Euler equations as they stand.
 *   given       I_C[6]: moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,
 *                 zz)
 *               m: mass
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *               t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   returns     w[6]: wrench: moment, force
 *   verdict     holds
 *   assumes     nothing
 *   expects     I_C is symmetric
 *               m > 0
 *   operations  45: 15 add, 3 subtract, 27 multiply
 *   error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 4e831789b8f20b1f8ebea121e0d8d47b7074e8225c3fd379d0994cdf87959c79
 */
void chasles_newton_euler_wrench_sym6(
    const double I_C[6],
    double m,
    const double t[6],
    const double t_dot[6],
    double w[6])
{
    const double w3 = m * t_dot[3];
    const double w4 = m * t_dot[4];
    const double w5 = m * t_dot[5];
    const double t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
    const double t2 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
    const double t3 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
    const double t4 = I_C[0] * t_dot[0] + I_C[1] * t_dot[1] + I_C[2] * t_dot[2];
    const double w0 = t4 + (t[1] * t3 - t[2] * t2);
    const double t5 = I_C[1] * t_dot[0] + I_C[3] * t_dot[1] + I_C[4] * t_dot[2];
    const double w1 = t5 + (t[2] * t1 - t[0] * t3);
    const double t6 = I_C[2] * t_dot[0] + I_C[4] * t_dot[1] + I_C[5] * t_dot[2];
    const double w2 = t6 + (t[0] * t2 - t[1] * t1);
    w[0] = w0;
    w[1] = w1;
    w[2] = w2;
    w[3] = w3;
    w[4] = w4;
    w[5] = w5;
}

/*
 * text 3.8 v chasles_newton_euler_wrench_sym6 in single precision.
 *   verdict: holds; assumes nothing
 *   45 operations; derivation sha256 4e831789b8f20b1f8ebea121e0d8d47b7074e8225c3fd379d0994cdf87959c79
 */
void chasles_newton_euler_wrench_sym6f(
    const float I_C[6],
    float m,
    const float t[6],
    const float t_dot[6],
    float w[6])
{
    const float w3 = m * t_dot[3];
    const float w4 = m * t_dot[4];
    const float w5 = m * t_dot[5];
    const float t1 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
    const float t2 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
    const float t3 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
    const float t4 = I_C[0] * t_dot[0] + I_C[1] * t_dot[1] + I_C[2] * t_dot[2];
    const float w0 = t4 + (t[1] * t3 - t[2] * t2);
    const float t5 = I_C[1] * t_dot[0] + I_C[3] * t_dot[1] + I_C[4] * t_dot[2];
    const float w1 = t5 + (t[2] * t1 - t[0] * t3);
    const float t6 = I_C[2] * t_dot[0] + I_C[4] * t_dot[1] + I_C[5] * t_dot[2];
    const float w2 = t6 + (t[0] * t2 - t[1] * t1);
    w[0] = w0;
    w[1] = w1;
    w[2] = w2;
    w[3] = w3;
    w[4] = w4;
    w[5] = w5;
}

/*
 * text 3.8 v chasles_newton_euler_wrench_sym6 for a batch.
 *   verdict: holds; assumes nothing
 *   45 operations; derivation sha256 4e831789b8f20b1f8ebea121e0d8d47b7074e8225c3fd379d0994cdf87959c79
 */
void chasles_newton_euler_wrench_sym6_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    const double *t_dot, ptrdiff_t t_dot_step,
    double *w, ptrdiff_t w_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)t_dot, (char *)w};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        t_step * size,
        t_dot_step * size,
        w_step * size};
    const chasles_loop *loop = &chasles_newton_euler_wrench_sym6_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.8 v chasles_newton_euler_wrench_sym6f for a batch.
 *   verdict: holds; assumes nothing
 *   45 operations; derivation sha256 4e831789b8f20b1f8ebea121e0d8d47b7074e8225c3fd379d0994cdf87959c79
 */
void chasles_newton_euler_wrench_sym6_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *t, ptrdiff_t t_step,
    const float *t_dot, ptrdiff_t t_dot_step,
    float *w, ptrdiff_t w_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)t_dot, (char *)w};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        t_step * size,
        t_dot_step * size,
        w_step * size};
    const chasles_loop *loop = &chasles_newton_euler_wrench_sym6_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.8 v The rate of the twist of a body on which a wrench acts: the Newton-Euler equations
 *   solved.
 *   given       I_C[9]: moment of inertia at the center of mass
 *               m: mass
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *               w[6]: wrench: moment, force
 *   returns     t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   verdict     holds under
 *   assumes     det(I_C) != 0
 *               m > 0
 *   expects     I_C is positive-definite
 *   operations  108: 16 add, 18 subtract, 60 multiply, 14 divide
 *   error bound 24.09 u of the sum of its terms' sizes, times the condition of its divisor, for all
 *                 inputs of which that is at most 4096; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 583b7af3455d4e7d41db43315abbed568d7671c8edafcef5b697d79c93e17ecb
 */
void chasles_newton_euler_twist_rate(
    const double I_C[9],
    double m,
    const double t[6],
    const double w[6],
    double t_dot[6])
{
    const double t1 = I_C[0] < 0.0 ? -I_C[0] : I_C[0];
    const double t2 = I_C[1] < 0.0 ? -I_C[1] : I_C[1];
    const double t3 = t1 < t2 ? t2 : t1;
    const double t4 = I_C[2] < 0.0 ? -I_C[2] : I_C[2];
    const double t5 = t3 < t4 ? t4 : t3;
    const double t6 = I_C[3] < 0.0 ? -I_C[3] : I_C[3];
    const double t7 = t5 < t6 ? t6 : t5;
    const double t8 = I_C[4] < 0.0 ? -I_C[4] : I_C[4];
    const double t9 = t7 < t8 ? t8 : t7;
    const double t10 = I_C[5] < 0.0 ? -I_C[5] : I_C[5];
    const double t11 = t9 < t10 ? t10 : t9;
    const double t12 = I_C[6] < 0.0 ? -I_C[6] : I_C[6];
    const double t13 = t11 < t12 ? t12 : t11;
    const double t14 = I_C[7] < 0.0 ? -I_C[7] : I_C[7];
    const double t15 = t13 < t14 ? t14 : t13;
    const double t16 = I_C[8] < 0.0 ? -I_C[8] : I_C[8];
    const double t17 = t15 < t16 ? t16 : t15;
    const double t18 = 0.0 == t17 ? 1.0 : t17;
    const double t19 = I_C[0] / t18;
    const double t20 = I_C[1] / t18;
    const double t21 = I_C[2] / t18;
    const double t22 = I_C[3] / t18;
    const double t23 = I_C[4] / t18;
    const double t24 = I_C[5] / t18;
    const double t25 = I_C[6] / t18;
    const double t26 = I_C[7] / t18;
    const double t27 = I_C[8] / t18;
    const double t28 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
    const double t29 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
    const double t30 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
    const double t31 = w[0] - (t[1] * t30 - t[2] * t29);
    const double t32 = w[1] - (t[2] * t28 - t[0] * t30);
    const double t33 = w[2] - (t[0] * t29 - t[1] * t28);
    const double t34 = t23 * t27 - t24 * t26;
    const double t35 = t24 * t25 - t22 * t27;
    const double t36 = t22 * t26 - t23 * t25;
    const double t37 = I_C[0] * (I_C[4] * I_C[8] - I_C[5] * I_C[7]);
    const double t38 = t37 + I_C[1] * (I_C[5] * I_C[6] - I_C[3] * I_C[8]);
    const int t39 = 0.0 == t38 + I_C[2] * (I_C[3] * I_C[7] - I_C[4] * I_C[6]);
    const double t40 = t39 ? 0.0 : t19 * t34 + t20 * t35 + t21 * t36;
    const double t41 = (t40 == 0.0 ? 0.0 : 1.0) / t40;
    const double t42 = t31 * t34 + t32 * (t21 * t26 - t20 * t27);
    const double t43 = t31 * t35 + t32 * (t19 * t27 - t21 * t25);
    const double t44 = t31 * t36 + t32 * (t20 * t25 - t19 * t26);
    const double t45 = (m == 0.0 ? 0.0 : 1.0) / m;
    const double t_dot3 = w[3] * t45;
    const double t_dot4 = w[4] * t45;
    const double t_dot5 = w[5] * t45;
    const double t_dot0 = t41 * (t42 + t33 * (t20 * t24 - t21 * t23)) / t18;
    const double t_dot1 = t41 * (t43 + t33 * (t21 * t22 - t19 * t24)) / t18;
    const double t_dot2 = t41 * (t44 + t33 * (t19 * t23 - t20 * t22)) / t18;
    t_dot[0] = t_dot0;
    t_dot[1] = t_dot1;
    t_dot[2] = t_dot2;
    t_dot[3] = t_dot3;
    t_dot[4] = t_dot4;
    t_dot[5] = t_dot5;
}

/*
 * text 3.8 v chasles_newton_euler_twist_rate in single precision.
 *   verdict: holds under; assumes det(I_C) != 0, m > 0
 *   108 operations; derivation sha256 583b7af3455d4e7d41db43315abbed568d7671c8edafcef5b697d79c93e17ecb
 */
void chasles_newton_euler_twist_ratef(
    const float I_C[9],
    float m,
    const float t[6],
    const float w[6],
    float t_dot[6])
{
    const float t1 = I_C[0] < 0.0f ? -I_C[0] : I_C[0];
    const float t2 = I_C[1] < 0.0f ? -I_C[1] : I_C[1];
    const float t3 = t1 < t2 ? t2 : t1;
    const float t4 = I_C[2] < 0.0f ? -I_C[2] : I_C[2];
    const float t5 = t3 < t4 ? t4 : t3;
    const float t6 = I_C[3] < 0.0f ? -I_C[3] : I_C[3];
    const float t7 = t5 < t6 ? t6 : t5;
    const float t8 = I_C[4] < 0.0f ? -I_C[4] : I_C[4];
    const float t9 = t7 < t8 ? t8 : t7;
    const float t10 = I_C[5] < 0.0f ? -I_C[5] : I_C[5];
    const float t11 = t9 < t10 ? t10 : t9;
    const float t12 = I_C[6] < 0.0f ? -I_C[6] : I_C[6];
    const float t13 = t11 < t12 ? t12 : t11;
    const float t14 = I_C[7] < 0.0f ? -I_C[7] : I_C[7];
    const float t15 = t13 < t14 ? t14 : t13;
    const float t16 = I_C[8] < 0.0f ? -I_C[8] : I_C[8];
    const float t17 = t15 < t16 ? t16 : t15;
    const float t18 = 0.0f == t17 ? 1.0f : t17;
    const float t19 = I_C[0] / t18;
    const float t20 = I_C[1] / t18;
    const float t21 = I_C[2] / t18;
    const float t22 = I_C[3] / t18;
    const float t23 = I_C[4] / t18;
    const float t24 = I_C[5] / t18;
    const float t25 = I_C[6] / t18;
    const float t26 = I_C[7] / t18;
    const float t27 = I_C[8] / t18;
    const float t28 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
    const float t29 = I_C[3] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
    const float t30 = I_C[6] * t[0] + I_C[7] * t[1] + I_C[8] * t[2];
    const float t31 = w[0] - (t[1] * t30 - t[2] * t29);
    const float t32 = w[1] - (t[2] * t28 - t[0] * t30);
    const float t33 = w[2] - (t[0] * t29 - t[1] * t28);
    const float t34 = t23 * t27 - t24 * t26;
    const float t35 = t24 * t25 - t22 * t27;
    const float t36 = t22 * t26 - t23 * t25;
    const float t37 = I_C[0] * (I_C[4] * I_C[8] - I_C[5] * I_C[7]);
    const float t38 = t37 + I_C[1] * (I_C[5] * I_C[6] - I_C[3] * I_C[8]);
    const int t39 = 0.0f == t38 + I_C[2] * (I_C[3] * I_C[7] - I_C[4] * I_C[6]);
    const float t40 = t39 ? 0.0f : t19 * t34 + t20 * t35 + t21 * t36;
    const float t41 = (t40 == 0.0f ? 0.0f : 1.0f) / t40;
    const float t42 = t31 * t34 + t32 * (t21 * t26 - t20 * t27);
    const float t43 = t31 * t35 + t32 * (t19 * t27 - t21 * t25);
    const float t44 = t31 * t36 + t32 * (t20 * t25 - t19 * t26);
    const float t45 = (m == 0.0f ? 0.0f : 1.0f) / m;
    const float t_dot3 = w[3] * t45;
    const float t_dot4 = w[4] * t45;
    const float t_dot5 = w[5] * t45;
    const float t_dot0 = t41 * (t42 + t33 * (t20 * t24 - t21 * t23)) / t18;
    const float t_dot1 = t41 * (t43 + t33 * (t21 * t22 - t19 * t24)) / t18;
    const float t_dot2 = t41 * (t44 + t33 * (t19 * t23 - t20 * t22)) / t18;
    t_dot[0] = t_dot0;
    t_dot[1] = t_dot1;
    t_dot[2] = t_dot2;
    t_dot[3] = t_dot3;
    t_dot[4] = t_dot4;
    t_dot[5] = t_dot5;
}

/*
 * text 3.8 v chasles_newton_euler_twist_rate for a batch.
 *   verdict: holds under; assumes det(I_C) != 0, m > 0
 *   108 operations; derivation sha256 583b7af3455d4e7d41db43315abbed568d7671c8edafcef5b697d79c93e17ecb
 */
void chasles_newton_euler_twist_rate_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    const double *w, ptrdiff_t w_step,
    double *t_dot, ptrdiff_t t_dot_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)w, (char *)t_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        t_step * size,
        w_step * size,
        t_dot_step * size};
    const chasles_loop *loop = &chasles_newton_euler_twist_rate_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.8 v chasles_newton_euler_twist_ratef for a batch.
 *   verdict: holds under; assumes det(I_C) != 0, m > 0
 *   108 operations; derivation sha256 583b7af3455d4e7d41db43315abbed568d7671c8edafcef5b697d79c93e17ecb
 */
void chasles_newton_euler_twist_rate_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *t, ptrdiff_t t_step,
    const float *w, ptrdiff_t w_step,
    float *t_dot, ptrdiff_t t_dot_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)w, (char *)t_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        t_step * size,
        w_step * size,
        t_dot_step * size};
    const chasles_loop *loop = &chasles_newton_euler_twist_rate_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.8 v The rate of the twist of a body on which a wrench acts: the Newton-Euler equations
 *   solved.
 *   given       I_C[6]: moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,
 *                 zz)
 *               m: mass
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *               w[6]: wrench: moment, force
 *   returns     t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   verdict     holds under
 *   assumes     det(I_C) != 0
 *               m > 0
 *   expects     I_C is positive-definite
 *   operations  96: 16 add, 15 subtract, 54 multiply, 11 divide
 *   error bound 24.09 u of the sum of its terms' sizes, times the condition of its divisor, for all
 *                 inputs of which that is at most 4096; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 583b7af3455d4e7d41db43315abbed568d7671c8edafcef5b697d79c93e17ecb
 */
void chasles_newton_euler_twist_rate_sym6(
    const double I_C[6],
    double m,
    const double t[6],
    const double w[6],
    double t_dot[6])
{
    const double t1 = I_C[0] < 0.0 ? -I_C[0] : I_C[0];
    const double t2 = I_C[1] < 0.0 ? -I_C[1] : I_C[1];
    const double t3 = t1 < t2 ? t2 : t1;
    const double t4 = I_C[2] < 0.0 ? -I_C[2] : I_C[2];
    const double t5 = t3 < t4 ? t4 : t3;
    const double t6 = I_C[3] < 0.0 ? -I_C[3] : I_C[3];
    const double t7 = t5 < t6 ? t6 : t5;
    const double t8 = I_C[4] < 0.0 ? -I_C[4] : I_C[4];
    const double t9 = t7 < t8 ? t8 : t7;
    const double t10 = I_C[5] < 0.0 ? -I_C[5] : I_C[5];
    const double t11 = t9 < t10 ? t10 : t9;
    const double t12 = 0.0 == t11 ? 1.0 : t11;
    const double t13 = I_C[0] / t12;
    const double t14 = I_C[1] / t12;
    const double t15 = I_C[2] / t12;
    const double t16 = I_C[3] / t12;
    const double t17 = I_C[4] / t12;
    const double t18 = I_C[5] / t12;
    const double t19 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
    const double t20 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
    const double t21 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
    const double t22 = w[0] - (t[1] * t21 - t[2] * t20);
    const double t23 = w[1] - (t[2] * t19 - t[0] * t21);
    const double t24 = w[2] - (t[0] * t20 - t[1] * t19);
    const double t25 = t16 * t18 - t17 * t17;
    const double t26 = t15 * t17 - t14 * t18;
    const double t27 = t14 * t17 - t15 * t16;
    const double t28 = t14 * t15 - t13 * t17;
    const double t29 = I_C[0] * (I_C[3] * I_C[5] - I_C[4] * I_C[4]);
    const double t30 = t29 + I_C[1] * (I_C[2] * I_C[4] - I_C[1] * I_C[5]);
    const int t31 = 0.0 == t30 + I_C[2] * (I_C[1] * I_C[4] - I_C[2] * I_C[3]);
    const double t32 = t31 ? 0.0 : t13 * t25 + t14 * t26 + t15 * t27;
    const double t33 = (t32 == 0.0 ? 0.0 : 1.0) / t32;
    const double t34 = (m == 0.0 ? 0.0 : 1.0) / m;
    const double t_dot3 = w[3] * t34;
    const double t_dot4 = w[4] * t34;
    const double t_dot5 = w[5] * t34;
    const double t_dot0 = t33 * (t22 * t25 + t23 * t26 + t24 * t27) / t12;
    const double t_dot1 = t33 * (t22 * t26 + t23 * (t13 * t18 - t15 * t15) + t24 * t28) / t12;
    const double t_dot2 = t33 * (t22 * t27 + t23 * t28 + t24 * (t13 * t16 - t14 * t14)) / t12;
    t_dot[0] = t_dot0;
    t_dot[1] = t_dot1;
    t_dot[2] = t_dot2;
    t_dot[3] = t_dot3;
    t_dot[4] = t_dot4;
    t_dot[5] = t_dot5;
}

/*
 * text 3.8 v chasles_newton_euler_twist_rate_sym6 in single precision.
 *   verdict: holds under; assumes det(I_C) != 0, m > 0
 *   96 operations; derivation sha256 583b7af3455d4e7d41db43315abbed568d7671c8edafcef5b697d79c93e17ecb
 */
void chasles_newton_euler_twist_rate_sym6f(
    const float I_C[6],
    float m,
    const float t[6],
    const float w[6],
    float t_dot[6])
{
    const float t1 = I_C[0] < 0.0f ? -I_C[0] : I_C[0];
    const float t2 = I_C[1] < 0.0f ? -I_C[1] : I_C[1];
    const float t3 = t1 < t2 ? t2 : t1;
    const float t4 = I_C[2] < 0.0f ? -I_C[2] : I_C[2];
    const float t5 = t3 < t4 ? t4 : t3;
    const float t6 = I_C[3] < 0.0f ? -I_C[3] : I_C[3];
    const float t7 = t5 < t6 ? t6 : t5;
    const float t8 = I_C[4] < 0.0f ? -I_C[4] : I_C[4];
    const float t9 = t7 < t8 ? t8 : t7;
    const float t10 = I_C[5] < 0.0f ? -I_C[5] : I_C[5];
    const float t11 = t9 < t10 ? t10 : t9;
    const float t12 = 0.0f == t11 ? 1.0f : t11;
    const float t13 = I_C[0] / t12;
    const float t14 = I_C[1] / t12;
    const float t15 = I_C[2] / t12;
    const float t16 = I_C[3] / t12;
    const float t17 = I_C[4] / t12;
    const float t18 = I_C[5] / t12;
    const float t19 = I_C[0] * t[0] + I_C[1] * t[1] + I_C[2] * t[2];
    const float t20 = I_C[1] * t[0] + I_C[3] * t[1] + I_C[4] * t[2];
    const float t21 = I_C[2] * t[0] + I_C[4] * t[1] + I_C[5] * t[2];
    const float t22 = w[0] - (t[1] * t21 - t[2] * t20);
    const float t23 = w[1] - (t[2] * t19 - t[0] * t21);
    const float t24 = w[2] - (t[0] * t20 - t[1] * t19);
    const float t25 = t16 * t18 - t17 * t17;
    const float t26 = t15 * t17 - t14 * t18;
    const float t27 = t14 * t17 - t15 * t16;
    const float t28 = t14 * t15 - t13 * t17;
    const float t29 = I_C[0] * (I_C[3] * I_C[5] - I_C[4] * I_C[4]);
    const float t30 = t29 + I_C[1] * (I_C[2] * I_C[4] - I_C[1] * I_C[5]);
    const int t31 = 0.0f == t30 + I_C[2] * (I_C[1] * I_C[4] - I_C[2] * I_C[3]);
    const float t32 = t31 ? 0.0f : t13 * t25 + t14 * t26 + t15 * t27;
    const float t33 = (t32 == 0.0f ? 0.0f : 1.0f) / t32;
    const float t34 = (m == 0.0f ? 0.0f : 1.0f) / m;
    const float t_dot3 = w[3] * t34;
    const float t_dot4 = w[4] * t34;
    const float t_dot5 = w[5] * t34;
    const float t_dot0 = t33 * (t22 * t25 + t23 * t26 + t24 * t27) / t12;
    const float t_dot1 = t33 * (t22 * t26 + t23 * (t13 * t18 - t15 * t15) + t24 * t28) / t12;
    const float t_dot2 = t33 * (t22 * t27 + t23 * t28 + t24 * (t13 * t16 - t14 * t14)) / t12;
    t_dot[0] = t_dot0;
    t_dot[1] = t_dot1;
    t_dot[2] = t_dot2;
    t_dot[3] = t_dot3;
    t_dot[4] = t_dot4;
    t_dot[5] = t_dot5;
}

/*
 * text 3.8 v chasles_newton_euler_twist_rate_sym6 for a batch.
 *   verdict: holds under; assumes det(I_C) != 0, m > 0
 *   96 operations; derivation sha256 583b7af3455d4e7d41db43315abbed568d7671c8edafcef5b697d79c93e17ecb
 */
void chasles_newton_euler_twist_rate_sym6_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    const double *w, ptrdiff_t w_step,
    double *t_dot, ptrdiff_t t_dot_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)w, (char *)t_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        t_step * size,
        w_step * size,
        t_dot_step * size};
    const chasles_loop *loop = &chasles_newton_euler_twist_rate_sym6_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.8 v chasles_newton_euler_twist_rate_sym6f for a batch.
 *   verdict: holds under; assumes det(I_C) != 0, m > 0
 *   96 operations; derivation sha256 583b7af3455d4e7d41db43315abbed568d7671c8edafcef5b697d79c93e17ecb
 */
void chasles_newton_euler_twist_rate_sym6_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *t, ptrdiff_t t_step,
    const float *w, ptrdiff_t w_step,
    float *t_dot, ptrdiff_t t_dot_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)t, (char *)w, (char *)t_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        t_step * size,
        w_step * size,
        t_dot_step * size};
    const chasles_loop *loop = &chasles_newton_euler_twist_rate_sym6_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.147) The inertia dyad at A.
 *   given       I_C[9]: moment of inertia at the center of mass
 *               m: mass
 *               c[3]: position of the center of mass
 *               a[3]: position of the landmark point A
 *   returns     M_A[36]: inertia dyad at A
 *   verdict     holds
 *   assumes     nothing
 *   expects     I_C is symmetric
 *               m > 0
 *   operations  24: 6 add, 9 subtract, 9 multiply
 *   error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 13cba9d3a00039b66aa71e0b7c6844416aef2b889cadec353dae6a76e70a10a9
 */
void chasles_inertia_dyad(
    const double I_C[9],
    double m,
    const double c[3],
    const double a[3],
    double M_A[36])
{
    const double M_A21 = m;
    const double t1 = a[0] - c[0];
    const double t2 = a[1] - c[1];
    const double t3 = a[2] - c[2];
    const double M_A11 = M_A21 * t1;
    const double M_A16 = -M_A11;
    const double M_A15 = M_A21 * t2;
    const double M_A5 = -M_A15;
    const double M_A4 = M_A21 * t3;
    const double M_A9 = -M_A4;
    const double t4 = t1 * M_A11;
    const double t5 = t1 * M_A15;
    const double t6 = t1 * M_A4;
    const double t7 = t2 * M_A15;
    const double t8 = t2 * M_A4;
    const double t9 = t3 * M_A4;
    const double M_A0 = I_C[0] + (t7 + t9);
    const double M_A1 = I_C[1] - t5;
    const double M_A2 = I_C[2] - t6;
    const double M_A6 = I_C[3] - t5;
    const double M_A7 = I_C[4] + (t4 + t9);
    const double M_A8 = I_C[5] - t8;
    const double M_A12 = I_C[6] - t6;
    const double M_A13 = I_C[7] - t8;
    const double M_A14 = I_C[8] + (t4 + t7);
    M_A[0] = M_A0;
    M_A[1] = M_A1;
    M_A[2] = M_A2;
    M_A[3] = 0.0;
    M_A[4] = M_A4;
    M_A[5] = M_A5;
    M_A[6] = M_A6;
    M_A[7] = M_A7;
    M_A[8] = M_A8;
    M_A[9] = M_A9;
    M_A[10] = 0.0;
    M_A[11] = M_A11;
    M_A[12] = M_A12;
    M_A[13] = M_A13;
    M_A[14] = M_A14;
    M_A[15] = M_A15;
    M_A[16] = M_A16;
    M_A[17] = 0.0;
    M_A[18] = 0.0;
    M_A[19] = M_A9;
    M_A[20] = M_A15;
    M_A[21] = M_A21;
    M_A[22] = 0.0;
    M_A[23] = 0.0;
    M_A[24] = M_A4;
    M_A[25] = 0.0;
    M_A[26] = M_A16;
    M_A[27] = 0.0;
    M_A[28] = M_A21;
    M_A[29] = 0.0;
    M_A[30] = M_A5;
    M_A[31] = M_A11;
    M_A[32] = 0.0;
    M_A[33] = 0.0;
    M_A[34] = 0.0;
    M_A[35] = M_A21;
}

/*
 * (3.147) chasles_inertia_dyad in single precision.
 *   verdict: holds; assumes nothing
 *   24 operations; derivation sha256 13cba9d3a00039b66aa71e0b7c6844416aef2b889cadec353dae6a76e70a10a9
 */
void chasles_inertia_dyadf(
    const float I_C[9],
    float m,
    const float c[3],
    const float a[3],
    float M_A[36])
{
    const float M_A21 = m;
    const float t1 = a[0] - c[0];
    const float t2 = a[1] - c[1];
    const float t3 = a[2] - c[2];
    const float M_A11 = M_A21 * t1;
    const float M_A16 = -M_A11;
    const float M_A15 = M_A21 * t2;
    const float M_A5 = -M_A15;
    const float M_A4 = M_A21 * t3;
    const float M_A9 = -M_A4;
    const float t4 = t1 * M_A11;
    const float t5 = t1 * M_A15;
    const float t6 = t1 * M_A4;
    const float t7 = t2 * M_A15;
    const float t8 = t2 * M_A4;
    const float t9 = t3 * M_A4;
    const float M_A0 = I_C[0] + (t7 + t9);
    const float M_A1 = I_C[1] - t5;
    const float M_A2 = I_C[2] - t6;
    const float M_A6 = I_C[3] - t5;
    const float M_A7 = I_C[4] + (t4 + t9);
    const float M_A8 = I_C[5] - t8;
    const float M_A12 = I_C[6] - t6;
    const float M_A13 = I_C[7] - t8;
    const float M_A14 = I_C[8] + (t4 + t7);
    M_A[0] = M_A0;
    M_A[1] = M_A1;
    M_A[2] = M_A2;
    M_A[3] = 0.0f;
    M_A[4] = M_A4;
    M_A[5] = M_A5;
    M_A[6] = M_A6;
    M_A[7] = M_A7;
    M_A[8] = M_A8;
    M_A[9] = M_A9;
    M_A[10] = 0.0f;
    M_A[11] = M_A11;
    M_A[12] = M_A12;
    M_A[13] = M_A13;
    M_A[14] = M_A14;
    M_A[15] = M_A15;
    M_A[16] = M_A16;
    M_A[17] = 0.0f;
    M_A[18] = 0.0f;
    M_A[19] = M_A9;
    M_A[20] = M_A15;
    M_A[21] = M_A21;
    M_A[22] = 0.0f;
    M_A[23] = 0.0f;
    M_A[24] = M_A4;
    M_A[25] = 0.0f;
    M_A[26] = M_A16;
    M_A[27] = 0.0f;
    M_A[28] = M_A21;
    M_A[29] = 0.0f;
    M_A[30] = M_A5;
    M_A[31] = M_A11;
    M_A[32] = 0.0f;
    M_A[33] = 0.0f;
    M_A[34] = 0.0f;
    M_A[35] = M_A21;
}

/*
 * (3.147) chasles_inertia_dyad for a batch.
 *   verdict: holds; assumes nothing
 *   24 operations; derivation sha256 13cba9d3a00039b66aa71e0b7c6844416aef2b889cadec353dae6a76e70a10a9
 */
void chasles_inertia_dyad_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *c, ptrdiff_t c_step,
    const double *a, ptrdiff_t a_step,
    double *M_A, ptrdiff_t M_A_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)c, (char *)a, (char *)M_A};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        c_step * size,
        a_step * size,
        M_A_step * size};
    const chasles_loop *loop = &chasles_inertia_dyad_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.147) chasles_inertia_dyadf for a batch.
 *   verdict: holds; assumes nothing
 *   24 operations; derivation sha256 13cba9d3a00039b66aa71e0b7c6844416aef2b889cadec353dae6a76e70a10a9
 */
void chasles_inertia_dyad_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *c, ptrdiff_t c_step,
    const float *a, ptrdiff_t a_step,
    float *M_A, ptrdiff_t M_A_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)c, (char *)a, (char *)M_A};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        c_step * size,
        a_step * size,
        M_A_step * size};
    const chasles_loop *loop = &chasles_inertia_dyad_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.147) The inertia dyad at A.
 *   given       I_C[6]: moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,
 *                 zz)
 *               m: mass
 *               c[3]: position of the center of mass
 *               a[3]: position of the landmark point A
 *   returns     M_A[36]: inertia dyad at A
 *   verdict     holds
 *   assumes     nothing
 *   expects     I_C is symmetric
 *               m > 0
 *   operations  21: 6 add, 6 subtract, 9 multiply
 *   error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 13cba9d3a00039b66aa71e0b7c6844416aef2b889cadec353dae6a76e70a10a9
 */
void chasles_inertia_dyad_sym6(
    const double I_C[6],
    double m,
    const double c[3],
    const double a[3],
    double M_A[36])
{
    const double M_A21 = m;
    const double t1 = a[0] - c[0];
    const double t2 = a[1] - c[1];
    const double t3 = a[2] - c[2];
    const double M_A11 = M_A21 * t1;
    const double M_A16 = -M_A11;
    const double M_A15 = M_A21 * t2;
    const double M_A5 = -M_A15;
    const double M_A4 = M_A21 * t3;
    const double M_A9 = -M_A4;
    const double t4 = t1 * M_A11;
    const double t5 = t2 * M_A15;
    const double t6 = t3 * M_A4;
    const double M_A0 = I_C[0] + (t5 + t6);
    const double M_A1 = I_C[1] - t1 * M_A15;
    const double M_A2 = I_C[2] - t1 * M_A4;
    const double M_A7 = I_C[3] + (t4 + t6);
    const double M_A8 = I_C[4] - t2 * M_A4;
    const double M_A14 = I_C[5] + (t4 + t5);
    M_A[0] = M_A0;
    M_A[1] = M_A1;
    M_A[2] = M_A2;
    M_A[3] = 0.0;
    M_A[4] = M_A4;
    M_A[5] = M_A5;
    M_A[6] = M_A1;
    M_A[7] = M_A7;
    M_A[8] = M_A8;
    M_A[9] = M_A9;
    M_A[10] = 0.0;
    M_A[11] = M_A11;
    M_A[12] = M_A2;
    M_A[13] = M_A8;
    M_A[14] = M_A14;
    M_A[15] = M_A15;
    M_A[16] = M_A16;
    M_A[17] = 0.0;
    M_A[18] = 0.0;
    M_A[19] = M_A9;
    M_A[20] = M_A15;
    M_A[21] = M_A21;
    M_A[22] = 0.0;
    M_A[23] = 0.0;
    M_A[24] = M_A4;
    M_A[25] = 0.0;
    M_A[26] = M_A16;
    M_A[27] = 0.0;
    M_A[28] = M_A21;
    M_A[29] = 0.0;
    M_A[30] = M_A5;
    M_A[31] = M_A11;
    M_A[32] = 0.0;
    M_A[33] = 0.0;
    M_A[34] = 0.0;
    M_A[35] = M_A21;
}

/*
 * (3.147) chasles_inertia_dyad_sym6 in single precision.
 *   verdict: holds; assumes nothing
 *   21 operations; derivation sha256 13cba9d3a00039b66aa71e0b7c6844416aef2b889cadec353dae6a76e70a10a9
 */
void chasles_inertia_dyad_sym6f(
    const float I_C[6],
    float m,
    const float c[3],
    const float a[3],
    float M_A[36])
{
    const float M_A21 = m;
    const float t1 = a[0] - c[0];
    const float t2 = a[1] - c[1];
    const float t3 = a[2] - c[2];
    const float M_A11 = M_A21 * t1;
    const float M_A16 = -M_A11;
    const float M_A15 = M_A21 * t2;
    const float M_A5 = -M_A15;
    const float M_A4 = M_A21 * t3;
    const float M_A9 = -M_A4;
    const float t4 = t1 * M_A11;
    const float t5 = t2 * M_A15;
    const float t6 = t3 * M_A4;
    const float M_A0 = I_C[0] + (t5 + t6);
    const float M_A1 = I_C[1] - t1 * M_A15;
    const float M_A2 = I_C[2] - t1 * M_A4;
    const float M_A7 = I_C[3] + (t4 + t6);
    const float M_A8 = I_C[4] - t2 * M_A4;
    const float M_A14 = I_C[5] + (t4 + t5);
    M_A[0] = M_A0;
    M_A[1] = M_A1;
    M_A[2] = M_A2;
    M_A[3] = 0.0f;
    M_A[4] = M_A4;
    M_A[5] = M_A5;
    M_A[6] = M_A1;
    M_A[7] = M_A7;
    M_A[8] = M_A8;
    M_A[9] = M_A9;
    M_A[10] = 0.0f;
    M_A[11] = M_A11;
    M_A[12] = M_A2;
    M_A[13] = M_A8;
    M_A[14] = M_A14;
    M_A[15] = M_A15;
    M_A[16] = M_A16;
    M_A[17] = 0.0f;
    M_A[18] = 0.0f;
    M_A[19] = M_A9;
    M_A[20] = M_A15;
    M_A[21] = M_A21;
    M_A[22] = 0.0f;
    M_A[23] = 0.0f;
    M_A[24] = M_A4;
    M_A[25] = 0.0f;
    M_A[26] = M_A16;
    M_A[27] = 0.0f;
    M_A[28] = M_A21;
    M_A[29] = 0.0f;
    M_A[30] = M_A5;
    M_A[31] = M_A11;
    M_A[32] = 0.0f;
    M_A[33] = 0.0f;
    M_A[34] = 0.0f;
    M_A[35] = M_A21;
}

/*
 * (3.147) chasles_inertia_dyad_sym6 for a batch.
 *   verdict: holds; assumes nothing
 *   21 operations; derivation sha256 13cba9d3a00039b66aa71e0b7c6844416aef2b889cadec353dae6a76e70a10a9
 */
void chasles_inertia_dyad_sym6_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *c, ptrdiff_t c_step,
    const double *a, ptrdiff_t a_step,
    double *M_A, ptrdiff_t M_A_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)c, (char *)a, (char *)M_A};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        c_step * size,
        a_step * size,
        M_A_step * size};
    const chasles_loop *loop = &chasles_inertia_dyad_sym6_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.147) chasles_inertia_dyad_sym6f for a batch.
 *   verdict: holds; assumes nothing
 *   21 operations; derivation sha256 13cba9d3a00039b66aa71e0b7c6844416aef2b889cadec353dae6a76e70a10a9
 */
void chasles_inertia_dyad_sym6_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *c, ptrdiff_t c_step,
    const float *a, ptrdiff_t a_step,
    float *M_A, ptrdiff_t M_A_step)
{
    char *const at[] = {(char *)I_C, (char *)m, (char *)c, (char *)a, (char *)M_A};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        I_C_step * size,
        m_step * size,
        c_step * size,
        a_step * size,
        M_A_step * size};
    const chasles_loop *loop = &chasles_inertia_dyad_sym6_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

#endif
