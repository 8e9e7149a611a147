/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The kernels of section_3_4_2. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"
#include "loops.h"

static const chasles_shape chasles_natural_rate_matrix_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 4, 3},
};
const chasles_loop chasles_natural_rate_matrix_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_natural_rate_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_natural_rate_matrix_block),
};

static const chasles_shape chasles_natural_rate_matrix_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 4, 3},
};
const chasles_loop chasles_natural_rate_matrix_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_natural_rate_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_natural_rate_matrix_blockf),
};

static const chasles_shape chasles_linear_rate_matrix_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 4, 3},
};
const chasles_loop chasles_linear_rate_matrix_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_linear_rate_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_linear_rate_matrix_block),
};

static const chasles_shape chasles_linear_rate_matrix_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 4, 3},
};
const chasles_loop chasles_linear_rate_matrix_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_linear_rate_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_linear_rate_matrix_blockf),
};

static const chasles_shape chasles_euler_rodrigues_rate_matrix_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 4, 3},
};
const chasles_loop chasles_euler_rodrigues_rate_matrix_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rodrigues_rate_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_rate_matrix_block),
};

static const chasles_shape chasles_euler_rodrigues_rate_matrix_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 4, 3},
};
const chasles_loop chasles_euler_rodrigues_rate_matrix_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rodrigues_rate_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_rate_matrix_blockf),
};

static const chasles_shape chasles_rotation_from_linear_invariants_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 3},
};
const chasles_loop chasles_rotation_from_linear_invariants_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_rotation_from_linear_invariants_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_linear_invariants_block),
};

static const chasles_shape chasles_rotation_from_linear_invariants_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 3},
};
const chasles_loop chasles_rotation_from_linear_invariants_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_rotation_from_linear_invariants_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_linear_invariants_blockf),
};

static const chasles_shape chasles_rotation_from_euler_rodrigues_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 3},
};
const chasles_loop chasles_rotation_from_euler_rodrigues_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_rotation_from_euler_rodrigues_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_rodrigues_block),
};

static const chasles_shape chasles_rotation_from_euler_rodrigues_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 3},
};
const chasles_loop chasles_rotation_from_euler_rodrigues_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    2, 3, chasles_rotation_from_euler_rodrigues_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_rodrigues_blockf),
};

static const chasles_shape chasles_linear_invariants_loop_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {0, 1, 1},
};
const chasles_loop chasles_linear_invariants_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    1, 3, chasles_linear_invariants_loop_shapes,
    CHASLES_BLOCKS(chasles_linear_invariants_block),
};

static const chasles_shape chasles_linear_invariants_loopf_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {0, 1, 1},
};
const chasles_loop chasles_linear_invariants_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    1, 3, chasles_linear_invariants_loopf_shapes,
    CHASLES_BLOCKS(chasles_linear_invariants_blockf),
};

static const chasles_shape chasles_natural_invariants_loop_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {0, 1, 1},
};
const chasles_loop chasles_natural_invariants_loop = {
    sizeof(double), 1, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    1, 3, chasles_natural_invariants_loop_shapes,
    CHASLES_BLOCKS(chasles_natural_invariants_block),
};

static const chasles_shape chasles_natural_invariants_loopf_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {0, 1, 1},
};
const chasles_loop chasles_natural_invariants_loopf = {
    sizeof(float), 1, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    1, 3, chasles_natural_invariants_loopf_shapes,
    CHASLES_BLOCKS(chasles_natural_invariants_blockf),
};

static const chasles_shape chasles_euler_rodrigues_parameters_loop_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {0, 1, 1},
};
const chasles_loop chasles_euler_rodrigues_parameters_loop = {
    sizeof(double), 1, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    1, 3, chasles_euler_rodrigues_parameters_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_parameters_block),
};

static const chasles_shape chasles_euler_rodrigues_parameters_loopf_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {0, 1, 1},
};
const chasles_loop chasles_euler_rodrigues_parameters_loopf = {
    sizeof(float), 1, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    1, 3, chasles_euler_rodrigues_parameters_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_parameters_blockf),
};

static const chasles_shape chasles_screw_of_motion_loop_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
    {0, 1, 1},
    {0, 1, 1},
};
const chasles_loop chasles_screw_of_motion_loop = {
    sizeof(double), 1, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 6, chasles_screw_of_motion_loop_shapes,
    CHASLES_BLOCKS(chasles_screw_of_motion_block),
};

static const chasles_shape chasles_screw_of_motion_loopf_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
    {0, 1, 1},
    {0, 1, 1},
};
const chasles_loop chasles_screw_of_motion_loopf = {
    sizeof(float), 1, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 6, chasles_screw_of_motion_loopf_shapes,
    CHASLES_BLOCKS(chasles_screw_of_motion_blockf),
};

static const chasles_shape chasles_instant_screw_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
    {0, 1, 1},
};
const chasles_loop chasles_instant_screw_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 5, chasles_instant_screw_loop_shapes,
    CHASLES_BLOCKS(chasles_instant_screw_block),
};

static const chasles_shape chasles_instant_screw_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
    {0, 1, 1},
};
const chasles_loop chasles_instant_screw_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 5, chasles_instant_screw_loopf_shapes,
    CHASLES_BLOCKS(chasles_instant_screw_blockf),
};

static const chasles_shape chasles_natural_velocity_matrix_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 4},
};
const chasles_loop chasles_natural_velocity_matrix_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_natural_velocity_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_natural_velocity_matrix_block),
};

static const chasles_shape chasles_natural_velocity_matrix_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 4},
};
const chasles_loop chasles_natural_velocity_matrix_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_natural_velocity_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_natural_velocity_matrix_blockf),
};

static const chasles_shape chasles_linear_velocity_matrix_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 4},
};
const chasles_loop chasles_linear_velocity_matrix_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_linear_velocity_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_linear_velocity_matrix_block),
};

static const chasles_shape chasles_linear_velocity_matrix_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 4},
};
const chasles_loop chasles_linear_velocity_matrix_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_linear_velocity_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_linear_velocity_matrix_blockf),
};

static const chasles_shape chasles_euler_rodrigues_velocity_matrix_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 4},
};
const chasles_loop chasles_euler_rodrigues_velocity_matrix_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rodrigues_velocity_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_velocity_matrix_block),
};

static const chasles_shape chasles_euler_rodrigues_velocity_matrix_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 4},
};
const chasles_loop chasles_euler_rodrigues_velocity_matrix_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rodrigues_velocity_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_velocity_matrix_blockf),
};

static const chasles_shape chasles_pose_rate_natural_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_rate_natural_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_pose_rate_natural_loop_shapes,
    CHASLES_BLOCKS(chasles_pose_rate_natural_block),
};

static const chasles_shape chasles_pose_rate_natural_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_rate_natural_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_pose_rate_natural_loopf_shapes,
    CHASLES_BLOCKS(chasles_pose_rate_natural_blockf),
};

static const chasles_shape chasles_pose_rate_linear_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_rate_linear_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_pose_rate_linear_loop_shapes,
    CHASLES_BLOCKS(chasles_pose_rate_linear_block),
};

static const chasles_shape chasles_pose_rate_linear_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_rate_linear_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_pose_rate_linear_loopf_shapes,
    CHASLES_BLOCKS(chasles_pose_rate_linear_blockf),
};

static const chasles_shape chasles_pose_rate_euler_rodrigues_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_rate_euler_rodrigues_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_pose_rate_euler_rodrigues_loop_shapes,
    CHASLES_BLOCKS(chasles_pose_rate_euler_rodrigues_block),
};

static const chasles_shape chasles_pose_rate_euler_rodrigues_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_rate_euler_rodrigues_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_pose_rate_euler_rodrigues_loopf_shapes,
    CHASLES_BLOCKS(chasles_pose_rate_euler_rodrigues_blockf),
};

static const chasles_shape chasles_twist_from_pose_rate_natural_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_from_pose_rate_natural_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_twist_from_pose_rate_natural_loop_shapes,
    CHASLES_BLOCKS(chasles_twist_from_pose_rate_natural_block),
};

static const chasles_shape chasles_twist_from_pose_rate_natural_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_from_pose_rate_natural_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_twist_from_pose_rate_natural_loopf_shapes,
    CHASLES_BLOCKS(chasles_twist_from_pose_rate_natural_blockf),
};

static const chasles_shape chasles_twist_from_pose_rate_linear_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_from_pose_rate_linear_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_twist_from_pose_rate_linear_loop_shapes,
    CHASLES_BLOCKS(chasles_twist_from_pose_rate_linear_block),
};

static const chasles_shape chasles_twist_from_pose_rate_linear_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_from_pose_rate_linear_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_twist_from_pose_rate_linear_loopf_shapes,
    CHASLES_BLOCKS(chasles_twist_from_pose_rate_linear_blockf),
};

static const chasles_shape chasles_twist_from_pose_rate_euler_rodrigues_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_from_pose_rate_euler_rodrigues_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_twist_from_pose_rate_euler_rodrigues_loop_shapes,
    CHASLES_BLOCKS(chasles_twist_from_pose_rate_euler_rodrigues_block),
};

static const chasles_shape chasles_twist_from_pose_rate_euler_rodrigues_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_from_pose_rate_euler_rodrigues_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    3, 4, chasles_twist_from_pose_rate_euler_rodrigues_loopf_shapes,
    CHASLES_BLOCKS(chasles_twist_from_pose_rate_euler_rodrigues_blockf),
};

static const chasles_shape chasles_twist_transfer_loop_shapes[] = {
    {1, 1, 6},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
};
const chasles_loop chasles_twist_transfer_loop = {
    sizeof(double), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_twist_transfer_loop_shapes,
    CHASLES_BLOCKS(chasles_twist_transfer_block),
};

static const chasles_shape chasles_twist_transfer_loopf_shapes[] = {
    {1, 1, 6},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
};
const chasles_loop chasles_twist_transfer_loopf = {
    sizeof(float), 0, CHASLES_LONG_BLOCK, CHASLES_GAPS,
    3, 4, chasles_twist_transfer_loopf_shapes,
    CHASLES_BLOCKS(chasles_twist_transfer_blockf),
};

#if !(CHASLES_VECTORS && defined(CHASLES_BLOCKS_ALONE))

/*
 * (3.76b) The matrix of the natural invariants' rates.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *   returns     N[12]: natural invariants' rates from the angular velocity
 *   verdict     defined
 *   assumes     |e| = 1
 *               phi != 0
 *   operations  26: 6 add, 3 subtract, 14 multiply, 1 divide, 1 sine, 1 cosine
 *   error bound 6.0 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 ae8848864c3fe36678c44ede0fea89f8af655c143bdb95acf6bb13cd98cc80e0
 */
void chasles_natural_rate_matrix(const double e[3], double phi, double N[12])
{
    const double N9 = e[0];
    const double N10 = e[1];
    const double N11 = e[2];
    const double half_N9 = 0.5 * N9;
    const double half_N10 = 0.5 * N10;
    const double half_N11 = 0.5 * N11;
    const double half_phi = 0.5 * phi;
    const double sin_half_phi = sin(half_phi);
    const double t1 = 0.5 * ((sin_half_phi == 0.0 ? 0.0 : cos(half_phi)) / sin_half_phi);
    const double t2 = N10 * t1;
    const double t3 = N11 * t1;
    const double t4 = N9 * (N9 * t1);
    const double t5 = N9 * t2;
    const double t6 = N9 * t3;
    const double t7 = N10 * t2;
    const double t8 = N10 * t3;
    const double t9 = N11 * t3;
    const double N0 = t7 + t9;
    const double N4 = t4 + t9;
    const double N8 = t4 + t7;
    const double N1 = half_N11 - t5;
    const double N2 = -(half_N10 + t6);
    const double N3 = -(half_N11 + t5);
    const double N5 = half_N9 - t8;
    const double N6 = half_N10 - t6;
    const double N7 = -(half_N9 + t8);
    N[0] = N0;
    N[1] = N1;
    N[2] = N2;
    N[3] = N3;
    N[4] = N4;
    N[5] = N5;
    N[6] = N6;
    N[7] = N7;
    N[8] = N8;
    N[9] = N9;
    N[10] = N10;
    N[11] = N11;
}

/*
 * (3.76b) chasles_natural_rate_matrix in single precision.
 *   verdict: defined; assumes |e| = 1, phi != 0
 *   26 operations; derivation sha256 ae8848864c3fe36678c44ede0fea89f8af655c143bdb95acf6bb13cd98cc80e0
 */
void chasles_natural_rate_matrixf(const float e[3], float phi, float N[12])
{
    const float N9 = e[0];
    const float N10 = e[1];
    const float N11 = e[2];
    const float half_N9 = 0.5f * N9;
    const float half_N10 = 0.5f * N10;
    const float half_N11 = 0.5f * N11;
    const float half_phi = 0.5f * phi;
    const float sin_half_phi = sinf(half_phi);
    const float t1 = 0.5f * ((sin_half_phi == 0.0f ? 0.0f : cosf(half_phi)) / sin_half_phi);
    const float t2 = N10 * t1;
    const float t3 = N11 * t1;
    const float t4 = N9 * (N9 * t1);
    const float t5 = N9 * t2;
    const float t6 = N9 * t3;
    const float t7 = N10 * t2;
    const float t8 = N10 * t3;
    const float t9 = N11 * t3;
    const float N0 = t7 + t9;
    const float N4 = t4 + t9;
    const float N8 = t4 + t7;
    const float N1 = half_N11 - t5;
    const float N2 = -(half_N10 + t6);
    const float N3 = -(half_N11 + t5);
    const float N5 = half_N9 - t8;
    const float N6 = half_N10 - t6;
    const float N7 = -(half_N9 + t8);
    N[0] = N0;
    N[1] = N1;
    N[2] = N2;
    N[3] = N3;
    N[4] = N4;
    N[5] = N5;
    N[6] = N6;
    N[7] = N7;
    N[8] = N8;
    N[9] = N9;
    N[10] = N10;
    N[11] = N11;
}

/*
 * (3.76b) chasles_natural_rate_matrix for a batch.
 *   verdict: defined; assumes |e| = 1, phi != 0
 *   26 operations; derivation sha256 ae8848864c3fe36678c44ede0fea89f8af655c143bdb95acf6bb13cd98cc80e0
 */
void chasles_natural_rate_matrix_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *N, ptrdiff_t N_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)N};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, N_step * size};
    const chasles_loop *loop = &chasles_natural_rate_matrix_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.76b) chasles_natural_rate_matrixf for a batch.
 *   verdict: defined; assumes |e| = 1, phi != 0
 *   26 operations; derivation sha256 ae8848864c3fe36678c44ede0fea89f8af655c143bdb95acf6bb13cd98cc80e0
 */
void chasles_natural_rate_matrix_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *N, ptrdiff_t N_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)N};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, N_step * size};
    const chasles_loop *loop = &chasles_natural_rate_matrix_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.76c) The matrix of the linear invariants' rates.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *   returns     L[12]: linear invariants' rates from the angular velocity
 *   verdict     defined
 *   assumes     |e| = 1
 *   operations  30: 4 add, 7 subtract, 17 multiply, 1 sine, 1 cosine
 *   error bound 5.2 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 dc969a2458fb1ccbe6cf9ba4bd5c14c48137796a5e63b6fdffe960bc3f43a806
 */
void chasles_linear_rate_matrix(const double e[3], double phi, double L[12])
{
    const double t1 = 0.5 * cos(phi);
    const double t2 = 0.5 - t1;
    const double t3 = e[0] * t2;
    const double t4 = e[1] * t2;
    const double t5 = e[1] * t3;
    const double t6 = e[2] * t3;
    const double t7 = e[2] * t4;
    const double t8 = 0.5 + t1;
    const double L0 = t8 - e[0] * t3;
    const double L4 = t8 - e[1] * t4;
    const double L8 = t8 - e[2] * (e[2] * t2);
    const double sin_phi = sin(phi);
    const double half_sin_phi = 0.5 * sin_phi;
    const double t9 = e[0] * half_sin_phi;
    const double t10 = e[1] * half_sin_phi;
    const double t11 = e[2] * half_sin_phi;
    const double L1 = t11 - t5;
    const double L2 = -(t6 + t10);
    const double L3 = -(t5 + t11);
    const double L5 = t9 - t7;
    const double L6 = t10 - t6;
    const double L7 = -(t7 + t9);
    const double L9 = -(e[0] * sin_phi);
    const double L10 = -(e[1] * sin_phi);
    const double L11 = -(e[2] * sin_phi);
    L[0] = L0;
    L[1] = L1;
    L[2] = L2;
    L[3] = L3;
    L[4] = L4;
    L[5] = L5;
    L[6] = L6;
    L[7] = L7;
    L[8] = L8;
    L[9] = L9;
    L[10] = L10;
    L[11] = L11;
}

/*
 * (3.76c) chasles_linear_rate_matrix in single precision.
 *   verdict: defined; assumes |e| = 1
 *   30 operations; derivation sha256 dc969a2458fb1ccbe6cf9ba4bd5c14c48137796a5e63b6fdffe960bc3f43a806
 */
void chasles_linear_rate_matrixf(const float e[3], float phi, float L[12])
{
    const float t1 = 0.5f * cosf(phi);
    const float t2 = 0.5f - t1;
    const float t3 = e[0] * t2;
    const float t4 = e[1] * t2;
    const float t5 = e[1] * t3;
    const float t6 = e[2] * t3;
    const float t7 = e[2] * t4;
    const float t8 = 0.5f + t1;
    const float L0 = t8 - e[0] * t3;
    const float L4 = t8 - e[1] * t4;
    const float L8 = t8 - e[2] * (e[2] * t2);
    const float sin_phi = sinf(phi);
    const float half_sin_phi = 0.5f * sin_phi;
    const float t9 = e[0] * half_sin_phi;
    const float t10 = e[1] * half_sin_phi;
    const float t11 = e[2] * half_sin_phi;
    const float L1 = t11 - t5;
    const float L2 = -(t6 + t10);
    const float L3 = -(t5 + t11);
    const float L5 = t9 - t7;
    const float L6 = t10 - t6;
    const float L7 = -(t7 + t9);
    const float L9 = -(e[0] * sin_phi);
    const float L10 = -(e[1] * sin_phi);
    const float L11 = -(e[2] * sin_phi);
    L[0] = L0;
    L[1] = L1;
    L[2] = L2;
    L[3] = L3;
    L[4] = L4;
    L[5] = L5;
    L[6] = L6;
    L[7] = L7;
    L[8] = L8;
    L[9] = L9;
    L[10] = L10;
    L[11] = L11;
}

/*
 * (3.76c) chasles_linear_rate_matrix for a batch.
 *   verdict: defined; assumes |e| = 1
 *   30 operations; derivation sha256 dc969a2458fb1ccbe6cf9ba4bd5c14c48137796a5e63b6fdffe960bc3f43a806
 */
void chasles_linear_rate_matrix_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *L, ptrdiff_t L_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)L};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, L_step * size};
    const chasles_loop *loop = &chasles_linear_rate_matrix_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.76c) chasles_linear_rate_matrixf for a batch.
 *   verdict: defined; assumes |e| = 1
 *   30 operations; derivation sha256 dc969a2458fb1ccbe6cf9ba4bd5c14c48137796a5e63b6fdffe960bc3f43a806
 */
void chasles_linear_rate_matrix_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *L, ptrdiff_t L_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)L};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, L_step * size};
    const chasles_loop *loop = &chasles_linear_rate_matrix_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.76d) The matrix of the Euler-Rodrigues parameters' rates.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *   returns     H[12]: Euler-Rodrigues parameters' rates from the angular velocity
 *   verdict     defined
 *   assumes     |e| = 1
 *   operations  8: 6 multiply, 1 sine, 1 cosine
 *   error bound 2.61 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 6c847b4baa2596c76e6ab0bd3e04d8ba67a999fd27b87b011fca1a1dab6d4147
 */
void chasles_euler_rodrigues_rate_matrix(const double e[3], double phi, double H[12])
{
    const double half_phi = 0.5 * phi;
    const double H0 = 0.5 * cos(half_phi);
    const double t1 = 0.5 * sin(half_phi);
    const double H5 = e[0] * t1;
    const double H7 = -H5;
    const double H6 = e[1] * t1;
    const double H2 = -H6;
    const double H1 = e[2] * t1;
    const double H3 = -H1;
    H[0] = H0;
    H[1] = H1;
    H[2] = H2;
    H[3] = H3;
    H[4] = H0;
    H[5] = H5;
    H[6] = H6;
    H[7] = H7;
    H[8] = H0;
    H[9] = H7;
    H[10] = H2;
    H[11] = H3;
}

/*
 * (3.76d) chasles_euler_rodrigues_rate_matrix in single precision.
 *   verdict: defined; assumes |e| = 1
 *   8 operations; derivation sha256 6c847b4baa2596c76e6ab0bd3e04d8ba67a999fd27b87b011fca1a1dab6d4147
 */
void chasles_euler_rodrigues_rate_matrixf(const float e[3], float phi, float H[12])
{
    const float half_phi = 0.5f * phi;
    const float H0 = 0.5f * cosf(half_phi);
    const float t1 = 0.5f * sinf(half_phi);
    const float H5 = e[0] * t1;
    const float H7 = -H5;
    const float H6 = e[1] * t1;
    const float H2 = -H6;
    const float H1 = e[2] * t1;
    const float H3 = -H1;
    H[0] = H0;
    H[1] = H1;
    H[2] = H2;
    H[3] = H3;
    H[4] = H0;
    H[5] = H5;
    H[6] = H6;
    H[7] = H7;
    H[8] = H0;
    H[9] = H7;
    H[10] = H2;
    H[11] = H3;
}

/*
 * (3.76d) chasles_euler_rodrigues_rate_matrix for a batch.
 *   verdict: defined; assumes |e| = 1
 *   8 operations; derivation sha256 6c847b4baa2596c76e6ab0bd3e04d8ba67a999fd27b87b011fca1a1dab6d4147
 */
void chasles_euler_rodrigues_rate_matrix_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *H, ptrdiff_t H_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)H};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, H_step * size};
    const chasles_loop *loop = &chasles_euler_rodrigues_rate_matrix_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.76d) chasles_euler_rodrigues_rate_matrixf for a batch.
 *   verdict: defined; assumes |e| = 1
 *   8 operations; derivation sha256 6c847b4baa2596c76e6ab0bd3e04d8ba67a999fd27b87b011fca1a1dab6d4147
 */
void chasles_euler_rodrigues_rate_matrix_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *H, ptrdiff_t H_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)H};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, H_step * size};
    const chasles_loop *loop = &chasles_euler_rodrigues_rate_matrix_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.4.2 f The rotation from its linear invariants.
 *   given       q[3]: vector part of four invariants of the rotation
 *               q_0: scalar part of four invariants of the rotation
 *   returns     Q[9]: rotation
 *   verdict     holds under
 *   assumes     phi != pi
 *   expects     |[q, q_0]| = 1
 *               1 + q_0 != 0
 *   operations  20: 7 add, 3 subtract, 9 multiply, 1 divide
 *   error bound 5.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 19e234a754a5568e2a2452e2008c17414b949e07381e92256366ba6cc7d976bb
 */
void chasles_rotation_from_linear_invariants(const double q[3], double q_0, double Q[9])
{
    const double t1 = 1.0 + q_0;
    const double t2 = (t1 == 0.0 ? 0.0 : 1.0) / t1;
    const double t3 = q[0] * t2;
    const double t4 = q[1] * t2;
    const double t5 = q[1] * t3;
    const double t6 = q[2] * t3;
    const double t7 = q[2] * t4;
    const double Q0 = q_0 + q[0] * t3;
    const double Q4 = q_0 + q[1] * t4;
    const double Q8 = q_0 + q[2] * (q[2] * t2);
    const double Q1 = t5 - q[2];
    const double Q2 = q[1] + t6;
    const double Q3 = q[2] + t5;
    const double Q5 = t7 - q[0];
    const double Q6 = t6 - q[1];
    const double Q7 = q[0] + t7;
    Q[0] = Q0;
    Q[1] = Q1;
    Q[2] = Q2;
    Q[3] = Q3;
    Q[4] = Q4;
    Q[5] = Q5;
    Q[6] = Q6;
    Q[7] = Q7;
    Q[8] = Q8;
}

/*
 * text 3.4.2 f chasles_rotation_from_linear_invariants in single precision.
 *   verdict: holds under; assumes phi != pi
 *   20 operations; derivation sha256 19e234a754a5568e2a2452e2008c17414b949e07381e92256366ba6cc7d976bb
 */
void chasles_rotation_from_linear_invariantsf(const float q[3], float q_0, float Q[9])
{
    const float t1 = 1.0f + q_0;
    const float t2 = (t1 == 0.0f ? 0.0f : 1.0f) / t1;
    const float t3 = q[0] * t2;
    const float t4 = q[1] * t2;
    const float t5 = q[1] * t3;
    const float t6 = q[2] * t3;
    const float t7 = q[2] * t4;
    const float Q0 = q_0 + q[0] * t3;
    const float Q4 = q_0 + q[1] * t4;
    const float Q8 = q_0 + q[2] * (q[2] * t2);
    const float Q1 = t5 - q[2];
    const float Q2 = q[1] + t6;
    const float Q3 = q[2] + t5;
    const float Q5 = t7 - q[0];
    const float Q6 = t6 - q[1];
    const float Q7 = q[0] + t7;
    Q[0] = Q0;
    Q[1] = Q1;
    Q[2] = Q2;
    Q[3] = Q3;
    Q[4] = Q4;
    Q[5] = Q5;
    Q[6] = Q6;
    Q[7] = Q7;
    Q[8] = Q8;
}

/*
 * text 3.4.2 f chasles_rotation_from_linear_invariants for a batch.
 *   verdict: holds under; assumes phi != pi
 *   20 operations; derivation sha256 19e234a754a5568e2a2452e2008c17414b949e07381e92256366ba6cc7d976bb
 */
void chasles_rotation_from_linear_invariants_batch(
    size_t count,
    const double *q, ptrdiff_t q_step,
    const double *q_0, ptrdiff_t q_0_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)q, (char *)q_0, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {q_step * size, q_0_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_linear_invariants_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.4.2 f chasles_rotation_from_linear_invariantsf for a batch.
 *   verdict: holds under; assumes phi != pi
 *   20 operations; derivation sha256 19e234a754a5568e2a2452e2008c17414b949e07381e92256366ba6cc7d976bb
 */
void chasles_rotation_from_linear_invariants_batchf(
    size_t count,
    const float *q, ptrdiff_t q_step,
    const float *q_0, ptrdiff_t q_0_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)q, (char *)q_0, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {q_step * size, q_0_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_linear_invariants_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.4.2 f The rotation from its Euler-Rodrigues parameters.
 *   given       q[3]: vector part of four invariants of the rotation
 *               q_0: scalar part of four invariants of the rotation
 *   returns     Q[9]: rotation
 *   verdict     holds under
 *   assumes     |e| = 1
 *   expects     |[q, q_0]| = 1
 *   operations  29: 8 add, 4 subtract, 17 multiply
 *   error bound 5.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 767311161fbd53fb1cb19724605fdf117b3445cf5f7cf313ccc6ecbf4a40f8c5
 */
void chasles_rotation_from_euler_rodrigues(const double q[3], double q_0, double Q[9])
{
    const double t1 = q_0 * q_0 - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
    const double t2 = 2.0 * q_0;
    const double t3 = 2.0 * q[0];
    const double t4 = 2.0 * q[1];
    const double t5 = q[1] * t3;
    const double t6 = q[2] * t3;
    const double t7 = q[2] * t4;
    const double Q0 = t1 + q[0] * t3;
    const double Q4 = t1 + q[1] * t4;
    const double Q8 = t1 + q[2] * (2.0 * q[2]);
    const double t8 = q[0] * t2;
    const double t9 = q[1] * t2;
    const double t10 = q[2] * t2;
    const double Q1 = t5 - t10;
    const double Q2 = t6 + t9;
    const double Q3 = t5 + t10;
    const double Q5 = t7 - t8;
    const double Q6 = t6 - t9;
    const double Q7 = t7 + t8;
    Q[0] = Q0;
    Q[1] = Q1;
    Q[2] = Q2;
    Q[3] = Q3;
    Q[4] = Q4;
    Q[5] = Q5;
    Q[6] = Q6;
    Q[7] = Q7;
    Q[8] = Q8;
}

/*
 * text 3.4.2 f chasles_rotation_from_euler_rodrigues in single precision.
 *   verdict: holds under; assumes |e| = 1
 *   29 operations; derivation sha256 767311161fbd53fb1cb19724605fdf117b3445cf5f7cf313ccc6ecbf4a40f8c5
 */
void chasles_rotation_from_euler_rodriguesf(const float q[3], float q_0, float Q[9])
{
    const float t1 = q_0 * q_0 - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
    const float t2 = 2.0f * q_0;
    const float t3 = 2.0f * q[0];
    const float t4 = 2.0f * q[1];
    const float t5 = q[1] * t3;
    const float t6 = q[2] * t3;
    const float t7 = q[2] * t4;
    const float Q0 = t1 + q[0] * t3;
    const float Q4 = t1 + q[1] * t4;
    const float Q8 = t1 + q[2] * (2.0f * q[2]);
    const float t8 = q[0] * t2;
    const float t9 = q[1] * t2;
    const float t10 = q[2] * t2;
    const float Q1 = t5 - t10;
    const float Q2 = t6 + t9;
    const float Q3 = t5 + t10;
    const float Q5 = t7 - t8;
    const float Q6 = t6 - t9;
    const float Q7 = t7 + t8;
    Q[0] = Q0;
    Q[1] = Q1;
    Q[2] = Q2;
    Q[3] = Q3;
    Q[4] = Q4;
    Q[5] = Q5;
    Q[6] = Q6;
    Q[7] = Q7;
    Q[8] = Q8;
}

/*
 * text 3.4.2 f chasles_rotation_from_euler_rodrigues for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   29 operations; derivation sha256 767311161fbd53fb1cb19724605fdf117b3445cf5f7cf313ccc6ecbf4a40f8c5
 */
void chasles_rotation_from_euler_rodrigues_batch(
    size_t count,
    const double *q, ptrdiff_t q_step,
    const double *q_0, ptrdiff_t q_0_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)q, (char *)q_0, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {q_step * size, q_0_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_rodrigues_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.4.2 f chasles_rotation_from_euler_rodriguesf for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   29 operations; derivation sha256 767311161fbd53fb1cb19724605fdf117b3445cf5f7cf313ccc6ecbf4a40f8c5
 */
void chasles_rotation_from_euler_rodrigues_batchf(
    size_t count,
    const float *q, ptrdiff_t q_step,
    const float *q_0, ptrdiff_t q_0_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)q, (char *)q_0, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {q_step * size, q_0_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_rodrigues_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.4.2 g The linear invariants from the rotation.
 *   given       Q[9]: rotation
 *   returns     q[3]: vector part of four invariants of the rotation
 *               q_0: scalar part of four invariants of the rotation
 *   verdict     holds under
 *   assumes     |e| = 1
 *   expects     Q is a rotation
 *   operations  10: 2 add, 4 subtract, 4 multiply
 *   error bound q: 1.01 u of itself, for all inputs
 *               q_0: 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 dd83557748f8a3babd3f50468d387276f7ffb668b7fc29c093a7976e71eaabef
 */
void chasles_linear_invariants(const double Q[9], double q[3], double *q_0)
{
    const double q0 = 0.5 * (Q[7] - Q[5]);
    const double q1 = 0.5 * (Q[2] - Q[6]);
    const double q2 = 0.5 * (Q[3] - Q[1]);
    const double q_0_value = 0.5 * (Q[8] + (Q[0] + Q[4]) - 1.0);
    q[0] = q0;
    q[1] = q1;
    q[2] = q2;
    *q_0 = q_0_value;
}

/*
 * text 3.4.2 g chasles_linear_invariants in single precision.
 *   verdict: holds under; assumes |e| = 1
 *   10 operations; derivation sha256 dd83557748f8a3babd3f50468d387276f7ffb668b7fc29c093a7976e71eaabef
 */
void chasles_linear_invariantsf(const float Q[9], float q[3], float *q_0)
{
    const float q0 = 0.5f * (Q[7] - Q[5]);
    const float q1 = 0.5f * (Q[2] - Q[6]);
    const float q2 = 0.5f * (Q[3] - Q[1]);
    const float q_0_value = 0.5f * (Q[8] + (Q[0] + Q[4]) - 1.0f);
    q[0] = q0;
    q[1] = q1;
    q[2] = q2;
    *q_0 = q_0_value;
}

/*
 * text 3.4.2 g chasles_linear_invariants for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   10 operations; derivation sha256 dd83557748f8a3babd3f50468d387276f7ffb668b7fc29c093a7976e71eaabef
 */
void chasles_linear_invariants_batch(
    size_t count,
    const double *Q, ptrdiff_t Q_step,
    double *q, ptrdiff_t q_step,
    double *q_0, ptrdiff_t q_0_step)
{
    char *const at[] = {(char *)Q, (char *)q, (char *)q_0};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {Q_step * size, q_step * size, q_0_step * size};
    const chasles_loop *loop = &chasles_linear_invariants_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.4.2 g chasles_linear_invariantsf for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   10 operations; derivation sha256 dd83557748f8a3babd3f50468d387276f7ffb668b7fc29c093a7976e71eaabef
 */
void chasles_linear_invariants_batchf(
    size_t count,
    const float *Q, ptrdiff_t Q_step,
    float *q, ptrdiff_t q_step,
    float *q_0, ptrdiff_t q_0_step)
{
    char *const at[] = {(char *)Q, (char *)q, (char *)q_0};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {Q_step * size, q_step * size, q_0_step * size};
    const chasles_loop *loop = &chasles_linear_invariants_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.4.2 h The natural invariants from the rotation.
 *   given       Q[9]: rotation
 *   returns     e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *   verdict     holds under
 *   assumes     Q is a rotation
 *               phi != 0
 *   operations  63: 23 add, 7 subtract, 22 multiply, 8 divide, 2 square root, 1 arctangent2
 *   error bound e: 13.16 u of itself, for every rotation Q, beside the case that is taken
 *               phi: 26.99 u of itself, for every rotation Q, beside the case that is taken; u =
 *                 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, arctangent within 1
 *                 ulp
 *   derivation  sha256 167078e6ba9dff78870c0f0ddc85370ad11a1b0b824ddf316c3c9f19bd756081
 */
void chasles_natural_invariants(const double Q[9], double e[3], double *phi)
{
    const double t1 = Q[2] + Q[6];
    const double t2 = Q[5] + Q[7];
    const double t3 = Q[8] + (Q[0] + Q[4]);
    const double t4 = 1.0 + 2.0 * Q[8] - t3;
    const double t5 = t1 * t1;
    const double t6 = t2 * t2;
    const double t7 = Q[1] + Q[3];
    const double t8 = 1.0 + 2.0 * Q[4] - t3;
    const double t9 = t7 * t7;
    const double t10 = Q[7] - Q[5];
    const double t11 = Q[2] - Q[6];
    const double t12 = Q[3] - Q[1];
    const double t13 = t11 * t11;
    const double t14 = t6 + (t9 + t8 * t8) + t13;
    const double t15 = t12 * t12;
    const double t16 = t5 + t6 + t4 * t4 + t15;
    const int t17 = t14 < t16;
    const double t18 = t17 ? t1 : t7;
    const double t19 = t17 ? t2 : t8;
    const double t20 = t17 ? t4 : t2;
    const double t21 = 1.0 + 2.0 * Q[0] - t3;
    const double t22 = t10 * t10;
    const double t23 = t5 + (t9 + t21 * t21) + t22;
    const int t24 = t23 < t16;
    const int t25 = t23 < t14;
    const double t26 = t25 ? t18 : (t24 ? t18 : t21);
    const double t27 = t25 ? t19 : (t24 ? t19 : t7);
    const double t28 = t25 ? t20 : (t24 ? t20 : t1);
    const double t29 = 1.0 + t3;
    const double t30 = t15 + (t13 + t22) + t29 * t29;
    const int t31 = t30 < t16;
    const int t32 = t30 < t14;
    const int t33 = t30 < t23;
    const double t34 = t33 ? t26 : (t32 ? t26 : (t31 ? t26 : t10));
    const double t35 = t33 ? t27 : (t32 ? t27 : (t31 ? t27 : t11));
    const double t36 = t33 ? t28 : (t32 ? t28 : (t31 ? t28 : t12));
    const double t37 = t34 < 0.0 ? -t34 : t34;
    const double t38 = t35 < 0.0 ? -t35 : t35;
    const double t39 = t37 < t38 ? t38 : t37;
    const double t40 = t36 < 0.0 ? -t36 : t36;
    const double t41 = t39 < t40 ? t40 : t39;
    const double t42 = 0.0 == t41 ? 1.0 : t41;
    const double t43 = t34 / t42;
    const double t44 = t35 / t42;
    const double t45 = t36 / t42;
    const double t46 = t43 * t43 + t44 * t44 + t45 * t45;
    const double t47 = sqrt(t46);
    const int t48 = t46 == 0.0;
    const double t49 = (t48 ? 0.0 : t43) / t47;
    const double t50 = (t48 ? 0.0 : t44) / t47;
    const double t51 = (t48 ? 0.0 : t45) / t47;
    const double t52 = t17 ? t12 : t11;
    const double t53 = t17 ? t16 : t14;
    const double t54 = t25 ? t52 : (t24 ? t52 : t10);
    const double t55 = t25 ? t53 : (t24 ? t53 : t23);
    const double t56 = t33 ? t55 : (t32 ? t55 : (t31 ? t55 : t30));
    const double t57 = sqrt(t56);
    const int t58 = t56 == 0.0;
    const double t59 = (t58 ? 0.0 : (t33 ? t54 : (t32 ? t54 : (t31 ? t54 : t29)))) / t57;
    const double t60 = t50 < 0.0 ? -1.0 : (0.0 < t50 ? 1.0 : (t51 < 0.0 ? -1.0 : 1.0));
    const double t61 = 0.0 < t59 ? 1.0 : (t49 < 0.0 ? -1.0 : (0.0 < t49 ? 1.0 : t60));
    const double t62 = 0.0 == t30 - t30 ? (t59 < 0.0 ? -1.0 : t61) : NAN;
    const double e0 = t49 * t62;
    const double e1 = t50 * t62;
    const double e2 = t51 * t62;
    const double phi_value = 2.0 * atan2(t42 * ((t58 ? 0.0 : t47) / t57), t59 * t62);
    e[0] = e0;
    e[1] = e1;
    e[2] = e2;
    *phi = phi_value;
}

/*
 * text 3.4.2 h chasles_natural_invariants in single precision.
 *   verdict: holds under; assumes Q is a rotation, phi != 0
 *   63 operations; derivation sha256 167078e6ba9dff78870c0f0ddc85370ad11a1b0b824ddf316c3c9f19bd756081
 */
void chasles_natural_invariantsf(const float Q[9], float e[3], float *phi)
{
    const float t1 = Q[2] + Q[6];
    const float t2 = Q[5] + Q[7];
    const float t3 = Q[8] + (Q[0] + Q[4]);
    const float t4 = 1.0f + 2.0f * Q[8] - t3;
    const float t5 = t1 * t1;
    const float t6 = t2 * t2;
    const float t7 = Q[1] + Q[3];
    const float t8 = 1.0f + 2.0f * Q[4] - t3;
    const float t9 = t7 * t7;
    const float t10 = Q[7] - Q[5];
    const float t11 = Q[2] - Q[6];
    const float t12 = Q[3] - Q[1];
    const float t13 = t11 * t11;
    const float t14 = t6 + (t9 + t8 * t8) + t13;
    const float t15 = t12 * t12;
    const float t16 = t5 + t6 + t4 * t4 + t15;
    const int t17 = t14 < t16;
    const float t18 = t17 ? t1 : t7;
    const float t19 = t17 ? t2 : t8;
    const float t20 = t17 ? t4 : t2;
    const float t21 = 1.0f + 2.0f * Q[0] - t3;
    const float t22 = t10 * t10;
    const float t23 = t5 + (t9 + t21 * t21) + t22;
    const int t24 = t23 < t16;
    const int t25 = t23 < t14;
    const float t26 = t25 ? t18 : (t24 ? t18 : t21);
    const float t27 = t25 ? t19 : (t24 ? t19 : t7);
    const float t28 = t25 ? t20 : (t24 ? t20 : t1);
    const float t29 = 1.0f + t3;
    const float t30 = t15 + (t13 + t22) + t29 * t29;
    const int t31 = t30 < t16;
    const int t32 = t30 < t14;
    const int t33 = t30 < t23;
    const float t34 = t33 ? t26 : (t32 ? t26 : (t31 ? t26 : t10));
    const float t35 = t33 ? t27 : (t32 ? t27 : (t31 ? t27 : t11));
    const float t36 = t33 ? t28 : (t32 ? t28 : (t31 ? t28 : t12));
    const float t37 = t34 < 0.0f ? -t34 : t34;
    const float t38 = t35 < 0.0f ? -t35 : t35;
    const float t39 = t37 < t38 ? t38 : t37;
    const float t40 = t36 < 0.0f ? -t36 : t36;
    const float t41 = t39 < t40 ? t40 : t39;
    const float t42 = 0.0f == t41 ? 1.0f : t41;
    const float t43 = t34 / t42;
    const float t44 = t35 / t42;
    const float t45 = t36 / t42;
    const float t46 = t43 * t43 + t44 * t44 + t45 * t45;
    const float t47 = sqrtf(t46);
    const int t48 = t46 == 0.0f;
    const float t49 = (t48 ? 0.0f : t43) / t47;
    const float t50 = (t48 ? 0.0f : t44) / t47;
    const float t51 = (t48 ? 0.0f : t45) / t47;
    const float t52 = t17 ? t12 : t11;
    const float t53 = t17 ? t16 : t14;
    const float t54 = t25 ? t52 : (t24 ? t52 : t10);
    const float t55 = t25 ? t53 : (t24 ? t53 : t23);
    const float t56 = t33 ? t55 : (t32 ? t55 : (t31 ? t55 : t30));
    const float t57 = sqrtf(t56);
    const int t58 = t56 == 0.0f;
    const float t59 = (t58 ? 0.0f : (t33 ? t54 : (t32 ? t54 : (t31 ? t54 : t29)))) / t57;
    const float t60 = t50 < 0.0f ? -1.0f : (0.0f < t50 ? 1.0f : (t51 < 0.0f ? -1.0f : 1.0f));
    const float t61 = 0.0f < t59 ? 1.0f : (t49 < 0.0f ? -1.0f : (0.0f < t49 ? 1.0f : t60));
    const float t62 = 0.0f == t30 - t30 ? (t59 < 0.0f ? -1.0f : t61) : NAN;
    const float e0 = t49 * t62;
    const float e1 = t50 * t62;
    const float e2 = t51 * t62;
    const float phi_value = 2.0f * atan2f(t42 * ((t58 ? 0.0f : t47) / t57), t59 * t62);
    e[0] = e0;
    e[1] = e1;
    e[2] = e2;
    *phi = phi_value;
}

/*
 * text 3.4.2 h chasles_natural_invariants for a batch.
 *   verdict: holds under; assumes Q is a rotation, phi != 0
 *   63 operations; derivation sha256 167078e6ba9dff78870c0f0ddc85370ad11a1b0b824ddf316c3c9f19bd756081
 */
void chasles_natural_invariants_batch(
    size_t count,
    const double *Q, ptrdiff_t Q_step,
    double *e, ptrdiff_t e_step,
    double *phi, ptrdiff_t phi_step)
{
    char *const at[] = {(char *)Q, (char *)e, (char *)phi};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {Q_step * size, e_step * size, phi_step * size};
    const chasles_loop *loop = &chasles_natural_invariants_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.4.2 h chasles_natural_invariantsf for a batch.
 *   verdict: holds under; assumes Q is a rotation, phi != 0
 *   63 operations; derivation sha256 167078e6ba9dff78870c0f0ddc85370ad11a1b0b824ddf316c3c9f19bd756081
 */
void chasles_natural_invariants_batchf(
    size_t count,
    const float *Q, ptrdiff_t Q_step,
    float *e, ptrdiff_t e_step,
    float *phi, ptrdiff_t phi_step)
{
    char *const at[] = {(char *)Q, (char *)e, (char *)phi};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {Q_step * size, e_step * size, phi_step * size};
    const chasles_loop *loop = &chasles_natural_invariants_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.4.2 i The Euler-Rodrigues parameters from the rotation.
 *   given       Q[9]: rotation
 *   returns     q[3]: vector part of four invariants of the rotation
 *               q_0: scalar part of four invariants of the rotation
 *   verdict     holds under
 *   assumes     Q is a rotation
 *   operations  50: 21 add, 7 subtract, 17 multiply, 4 divide, 1 square root
 *   error bound q: 11.66 u of itself, for every rotation Q, beside the case that is taken
 *               q_0: 9.34 u of itself, for every rotation Q, beside the case that is taken; u = 2^-53,
 *                 in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 acb16a335b8480158c7d6e339e4c3de8c51cf3bffd9594c8aa4b639840b77580
 */
void chasles_euler_rodrigues_parameters(const double Q[9], double q[3], double *q_0)
{
    const double t1 = Q[2] + Q[6];
    const double t2 = Q[5] + Q[7];
    const double t3 = Q[8] + (Q[0] + Q[4]);
    const double t4 = 1.0 + 2.0 * Q[8] - t3;
    const double t5 = Q[7] - Q[5];
    const double t6 = Q[2] - Q[6];
    const double t7 = Q[3] - Q[1];
    const double t8 = t1 * t1;
    const double t9 = t2 * t2;
    const double t10 = t7 * t7;
    const double t11 = t8 + t9 + t4 * t4 + t10;
    const double t12 = Q[1] + Q[3];
    const double t13 = 1.0 + 2.0 * Q[4] - t3;
    const double t14 = t12 * t12;
    const double t15 = t6 * t6;
    const double t16 = t9 + (t14 + t13 * t13) + t15;
    const int t17 = t16 < t11;
    const double t18 = t17 ? t1 : t12;
    const double t19 = t17 ? t11 : t16;
    const double t20 = t17 ? t2 : t13;
    const double t21 = t17 ? t4 : t2;
    const double t22 = 1.0 + 2.0 * Q[0] - t3;
    const double t23 = t5 * t5;
    const double t24 = t8 + (t14 + t22 * t22) + t23;
    const int t25 = t24 < t11;
    const int t26 = t24 < t16;
    const double t27 = t26 ? t18 : (t25 ? t18 : t22);
    const double t28 = t26 ? t19 : (t25 ? t19 : t24);
    const double t29 = t26 ? t20 : (t25 ? t20 : t12);
    const double t30 = t26 ? t21 : (t25 ? t21 : t1);
    const double t31 = 1.0 + t3;
    const double t32 = t10 + (t15 + t23) + t31 * t31;
    const int t33 = t32 < t11;
    const int t34 = t32 < t16;
    const int t35 = t32 < t24;
    const double t36 = t35 ? t28 : (t34 ? t28 : (t33 ? t28 : t32));
    const double t37 = sqrt(t36);
    const int t38 = t36 == 0.0;
    const double t39 = (t38 ? 0.0 : (t35 ? t27 : (t34 ? t27 : (t33 ? t27 : t5)))) / t37;
    const double t40 = (t38 ? 0.0 : (t35 ? t29 : (t34 ? t29 : (t33 ? t29 : t6)))) / t37;
    const double t41 = (t38 ? 0.0 : (t35 ? t30 : (t34 ? t30 : (t33 ? t30 : t7)))) / t37;
    const double t42 = t17 ? t7 : t6;
    const double t43 = t26 ? t42 : (t25 ? t42 : t5);
    const double t44 = (t38 ? 0.0 : (t35 ? t43 : (t34 ? t43 : (t33 ? t43 : t31)))) / t37;
    const double t45 = t40 < 0.0 ? -1.0 : (0.0 < t40 ? 1.0 : (t41 < 0.0 ? -1.0 : 1.0));
    const double t46 = 0.0 < t44 ? 1.0 : (t39 < 0.0 ? -1.0 : (0.0 < t39 ? 1.0 : t45));
    const double t47 = 0.0 == t32 - t32 ? (t44 < 0.0 ? -1.0 : t46) : NAN;
    const double q0 = t39 * t47;
    const double q1 = t40 * t47;
    const double q2 = t41 * t47;
    const double q_0_value = t44 * t47;
    q[0] = q0;
    q[1] = q1;
    q[2] = q2;
    *q_0 = q_0_value;
}

/*
 * text 3.4.2 i chasles_euler_rodrigues_parameters in single precision.
 *   verdict: holds under; assumes Q is a rotation
 *   50 operations; derivation sha256 acb16a335b8480158c7d6e339e4c3de8c51cf3bffd9594c8aa4b639840b77580
 */
void chasles_euler_rodrigues_parametersf(const float Q[9], float q[3], float *q_0)
{
    const float t1 = Q[2] + Q[6];
    const float t2 = Q[5] + Q[7];
    const float t3 = Q[8] + (Q[0] + Q[4]);
    const float t4 = 1.0f + 2.0f * Q[8] - t3;
    const float t5 = Q[7] - Q[5];
    const float t6 = Q[2] - Q[6];
    const float t7 = Q[3] - Q[1];
    const float t8 = t1 * t1;
    const float t9 = t2 * t2;
    const float t10 = t7 * t7;
    const float t11 = t8 + t9 + t4 * t4 + t10;
    const float t12 = Q[1] + Q[3];
    const float t13 = 1.0f + 2.0f * Q[4] - t3;
    const float t14 = t12 * t12;
    const float t15 = t6 * t6;
    const float t16 = t9 + (t14 + t13 * t13) + t15;
    const int t17 = t16 < t11;
    const float t18 = t17 ? t1 : t12;
    const float t19 = t17 ? t11 : t16;
    const float t20 = t17 ? t2 : t13;
    const float t21 = t17 ? t4 : t2;
    const float t22 = 1.0f + 2.0f * Q[0] - t3;
    const float t23 = t5 * t5;
    const float t24 = t8 + (t14 + t22 * t22) + t23;
    const int t25 = t24 < t11;
    const int t26 = t24 < t16;
    const float t27 = t26 ? t18 : (t25 ? t18 : t22);
    const float t28 = t26 ? t19 : (t25 ? t19 : t24);
    const float t29 = t26 ? t20 : (t25 ? t20 : t12);
    const float t30 = t26 ? t21 : (t25 ? t21 : t1);
    const float t31 = 1.0f + t3;
    const float t32 = t10 + (t15 + t23) + t31 * t31;
    const int t33 = t32 < t11;
    const int t34 = t32 < t16;
    const int t35 = t32 < t24;
    const float t36 = t35 ? t28 : (t34 ? t28 : (t33 ? t28 : t32));
    const float t37 = sqrtf(t36);
    const int t38 = t36 == 0.0f;
    const float t39 = (t38 ? 0.0f : (t35 ? t27 : (t34 ? t27 : (t33 ? t27 : t5)))) / t37;
    const float t40 = (t38 ? 0.0f : (t35 ? t29 : (t34 ? t29 : (t33 ? t29 : t6)))) / t37;
    const float t41 = (t38 ? 0.0f : (t35 ? t30 : (t34 ? t30 : (t33 ? t30 : t7)))) / t37;
    const float t42 = t17 ? t7 : t6;
    const float t43 = t26 ? t42 : (t25 ? t42 : t5);
    const float t44 = (t38 ? 0.0f : (t35 ? t43 : (t34 ? t43 : (t33 ? t43 : t31)))) / t37;
    const float t45 = t40 < 0.0f ? -1.0f : (0.0f < t40 ? 1.0f : (t41 < 0.0f ? -1.0f : 1.0f));
    const float t46 = 0.0f < t44 ? 1.0f : (t39 < 0.0f ? -1.0f : (0.0f < t39 ? 1.0f : t45));
    const float t47 = 0.0f == t32 - t32 ? (t44 < 0.0f ? -1.0f : t46) : NAN;
    const float q0 = t39 * t47;
    const float q1 = t40 * t47;
    const float q2 = t41 * t47;
    const float q_0_value = t44 * t47;
    q[0] = q0;
    q[1] = q1;
    q[2] = q2;
    *q_0 = q_0_value;
}

/*
 * text 3.4.2 i chasles_euler_rodrigues_parameters for a batch.
 *   verdict: holds under; assumes Q is a rotation
 *   50 operations; derivation sha256 acb16a335b8480158c7d6e339e4c3de8c51cf3bffd9594c8aa4b639840b77580
 */
void chasles_euler_rodrigues_parameters_batch(
    size_t count,
    const double *Q, ptrdiff_t Q_step,
    double *q, ptrdiff_t q_step,
    double *q_0, ptrdiff_t q_0_step)
{
    char *const at[] = {(char *)Q, (char *)q, (char *)q_0};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {Q_step * size, q_step * size, q_0_step * size};
    const chasles_loop *loop = &chasles_euler_rodrigues_parameters_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.4.2 i chasles_euler_rodrigues_parametersf for a batch.
 *   verdict: holds under; assumes Q is a rotation
 *   50 operations; derivation sha256 acb16a335b8480158c7d6e339e4c3de8c51cf3bffd9594c8aa4b639840b77580
 */
void chasles_euler_rodrigues_parameters_batchf(
    size_t count,
    const float *Q, ptrdiff_t Q_step,
    float *q, ptrdiff_t q_step,
    float *q_0, ptrdiff_t q_0_step)
{
    char *const at[] = {(char *)Q, (char *)q, (char *)q_0};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {Q_step * size, q_step * size, q_0_step * size};
    const chasles_loop *loop = &chasles_euler_rodrigues_parameters_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.4.2 j The screw of a motion: Plücker array of its axis, translation along it, angle.
 *   given       Q[9]: rotation
 *               a[3]: position of the landmark point A
 *               a_prime[3]: position of A after the displacement
 *   returns     axis[6]: [e; p_0 x e]
 *               d_0: e . (a' - a)
 *               phi: angle of rotation
 *   verdict     holds under
 *   assumes     Q is a rotation
 *               phi != 0
 *   made of     an offered form, proved equal to the statement
 *   operations  114: 31 add, 19 subtract, 49 multiply, 12 divide, 2 square root, 1 arctangent2
 *   error bound axis: 59.30 u of the sum of its terms' sizes, for every rotation Q, beside the case
 *                 that is taken
 *               d_0: 17.16 u of the sum of its terms' sizes, for every rotation Q, beside the case
 *                 that is taken
 *               phi: 26.99 u of itself, for every rotation Q, beside the case that is taken; u =
 *                 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, arctangent within 1
 *                 ulp
 *   derivation  sha256 f4c88cd5f5da36a09188beb0fcfbf3a4571931b3f06ad9a253f46079ff8f69c5
 */
void chasles_screw_of_motion(
    const double Q[9],
    const double a[3],
    const double a_prime[3],
    double axis[6],
    double *d_0,
    double *phi)
{
    const double t1 = Q[2] + Q[6];
    const double t2 = Q[5] + Q[7];
    const double t3 = Q[8] + (Q[0] + Q[4]);
    const double t4 = 1.0 + 2.0 * Q[8] - t3;
    const double t5 = t1 * t1;
    const double t6 = t2 * t2;
    const double t7 = Q[1] + Q[3];
    const double t8 = 1.0 + 2.0 * Q[4] - t3;
    const double t9 = t7 * t7;
    const double t10 = Q[7] - Q[5];
    const double t11 = Q[2] - Q[6];
    const double t12 = Q[3] - Q[1];
    const double t13 = t11 * t11;
    const double t14 = t6 + (t9 + t8 * t8) + t13;
    const double t15 = t12 * t12;
    const double t16 = t5 + t6 + t4 * t4 + t15;
    const int t17 = t14 < t16;
    const double t18 = t17 ? t1 : t7;
    const double t19 = t17 ? t2 : t8;
    const double t20 = t17 ? t4 : t2;
    const double t21 = 1.0 + 2.0 * Q[0] - t3;
    const double t22 = t10 * t10;
    const double t23 = t5 + (t9 + t21 * t21) + t22;
    const int t24 = t23 < t16;
    const int t25 = t23 < t14;
    const double t26 = t25 ? t18 : (t24 ? t18 : t21);
    const double t27 = t25 ? t19 : (t24 ? t19 : t7);
    const double t28 = t25 ? t20 : (t24 ? t20 : t1);
    const double t29 = 1.0 + t3;
    const double t30 = t15 + (t13 + t22) + t29 * t29;
    const int t31 = t30 < t16;
    const int t32 = t30 < t14;
    const int t33 = t30 < t23;
    const double t34 = t33 ? t26 : (t32 ? t26 : (t31 ? t26 : t10));
    const double t35 = t33 ? t27 : (t32 ? t27 : (t31 ? t27 : t11));
    const double t36 = t33 ? t28 : (t32 ? t28 : (t31 ? t28 : t12));
    const double t37 = t34 < 0.0 ? -t34 : t34;
    const double t38 = t35 < 0.0 ? -t35 : t35;
    const double t39 = t37 < t38 ? t38 : t37;
    const double t40 = t36 < 0.0 ? -t36 : t36;
    const double t41 = t39 < t40 ? t40 : t39;
    const double t42 = 0.0 == t41 ? 1.0 : t41;
    const double t43 = t34 / t42;
    const double t44 = t35 / t42;
    const double t45 = t36 / t42;
    const double t46 = t43 * t43 + t44 * t44 + t45 * t45;
    const double t47 = sqrt(t46);
    const int t48 = t46 == 0.0;
    const double t49 = (t48 ? 0.0 : t43) / t47;
    const double t50 = (t48 ? 0.0 : t44) / t47;
    const double t51 = (t48 ? 0.0 : t45) / t47;
    const double t52 = t17 ? t12 : t11;
    const double t53 = t17 ? t16 : t14;
    const double t54 = t25 ? t52 : (t24 ? t52 : t10);
    const double t55 = t25 ? t53 : (t24 ? t53 : t23);
    const double t56 = t33 ? t55 : (t32 ? t55 : (t31 ? t55 : t30));
    const double t57 = sqrt(t56);
    const int t58 = t56 == 0.0;
    const double t59 = (t58 ? 0.0 : (t33 ? t54 : (t32 ? t54 : (t31 ? t54 : t29)))) / t57;
    const double t60 = (t58 ? 0.0 : t47) / t57;
    const double t61 = t50 < 0.0 ? -1.0 : (0.0 < t50 ? 1.0 : (t51 < 0.0 ? -1.0 : 1.0));
    const double t62 = 0.0 < t59 ? 1.0 : (t49 < 0.0 ? -1.0 : (0.0 < t49 ? 1.0 : t61));
    const double t63 = 0.0 == t30 - t30 ? (t59 < 0.0 ? -1.0 : t62) : NAN;
    const double axis0 = t49 * t63;
    const double axis1 = t50 * t63;
    const double axis2 = t51 * t63;
    const double t64 = a[0] + a_prime[0];
    const double t65 = a[1] + a_prime[1];
    const double t66 = a[2] + a_prime[2];
    const double t67 = a_prime[0] - a[0];
    const double t68 = a_prime[1] - a[1];
    const double t69 = a_prime[2] - a[2];
    const double t70 = axis1 * t69 - axis2 * t68;
    const double t71 = axis2 * t67 - axis0 * t69;
    const double t72 = axis0 * t68 - axis1 * t67;
    const double t73 = t59 * t63;
    const double t74 = (t60 == 0.0 ? 0.0 : t73) / t60;
    const double t75 = axis2 * t65 - axis1 * t66 + (axis2 * t71 - axis1 * t72) * t74 / t42;
    const double axis3 = 0.5 * t75;
    const double t76 = axis0 * t66 - axis2 * t64 + (axis0 * t72 - axis2 * t70) * t74 / t42;
    const double axis4 = 0.5 * t76;
    const double t77 = axis1 * t64 - axis0 * t65 + (axis1 * t70 - axis0 * t71) * t74 / t42;
    const double axis5 = 0.5 * t77;
    const double d_0_value = axis0 * t67 + axis1 * t68 + axis2 * t69;
    const double phi_value = 2.0 * atan2(t42 * t60, t73);
    axis[0] = axis0;
    axis[1] = axis1;
    axis[2] = axis2;
    axis[3] = axis3;
    axis[4] = axis4;
    axis[5] = axis5;
    *d_0 = d_0_value;
    *phi = phi_value;
}

/*
 * text 3.4.2 j chasles_screw_of_motion in single precision.
 *   verdict: holds under; assumes Q is a rotation, phi != 0
 *   114 operations; derivation sha256 f4c88cd5f5da36a09188beb0fcfbf3a4571931b3f06ad9a253f46079ff8f69c5
 */
void chasles_screw_of_motionf(
    const float Q[9],
    const float a[3],
    const float a_prime[3],
    float axis[6],
    float *d_0,
    float *phi)
{
    const float t1 = Q[2] + Q[6];
    const float t2 = Q[5] + Q[7];
    const float t3 = Q[8] + (Q[0] + Q[4]);
    const float t4 = 1.0f + 2.0f * Q[8] - t3;
    const float t5 = t1 * t1;
    const float t6 = t2 * t2;
    const float t7 = Q[1] + Q[3];
    const float t8 = 1.0f + 2.0f * Q[4] - t3;
    const float t9 = t7 * t7;
    const float t10 = Q[7] - Q[5];
    const float t11 = Q[2] - Q[6];
    const float t12 = Q[3] - Q[1];
    const float t13 = t11 * t11;
    const float t14 = t6 + (t9 + t8 * t8) + t13;
    const float t15 = t12 * t12;
    const float t16 = t5 + t6 + t4 * t4 + t15;
    const int t17 = t14 < t16;
    const float t18 = t17 ? t1 : t7;
    const float t19 = t17 ? t2 : t8;
    const float t20 = t17 ? t4 : t2;
    const float t21 = 1.0f + 2.0f * Q[0] - t3;
    const float t22 = t10 * t10;
    const float t23 = t5 + (t9 + t21 * t21) + t22;
    const int t24 = t23 < t16;
    const int t25 = t23 < t14;
    const float t26 = t25 ? t18 : (t24 ? t18 : t21);
    const float t27 = t25 ? t19 : (t24 ? t19 : t7);
    const float t28 = t25 ? t20 : (t24 ? t20 : t1);
    const float t29 = 1.0f + t3;
    const float t30 = t15 + (t13 + t22) + t29 * t29;
    const int t31 = t30 < t16;
    const int t32 = t30 < t14;
    const int t33 = t30 < t23;
    const float t34 = t33 ? t26 : (t32 ? t26 : (t31 ? t26 : t10));
    const float t35 = t33 ? t27 : (t32 ? t27 : (t31 ? t27 : t11));
    const float t36 = t33 ? t28 : (t32 ? t28 : (t31 ? t28 : t12));
    const float t37 = t34 < 0.0f ? -t34 : t34;
    const float t38 = t35 < 0.0f ? -t35 : t35;
    const float t39 = t37 < t38 ? t38 : t37;
    const float t40 = t36 < 0.0f ? -t36 : t36;
    const float t41 = t39 < t40 ? t40 : t39;
    const float t42 = 0.0f == t41 ? 1.0f : t41;
    const float t43 = t34 / t42;
    const float t44 = t35 / t42;
    const float t45 = t36 / t42;
    const float t46 = t43 * t43 + t44 * t44 + t45 * t45;
    const float t47 = sqrtf(t46);
    const int t48 = t46 == 0.0f;
    const float t49 = (t48 ? 0.0f : t43) / t47;
    const float t50 = (t48 ? 0.0f : t44) / t47;
    const float t51 = (t48 ? 0.0f : t45) / t47;
    const float t52 = t17 ? t12 : t11;
    const float t53 = t17 ? t16 : t14;
    const float t54 = t25 ? t52 : (t24 ? t52 : t10);
    const float t55 = t25 ? t53 : (t24 ? t53 : t23);
    const float t56 = t33 ? t55 : (t32 ? t55 : (t31 ? t55 : t30));
    const float t57 = sqrtf(t56);
    const int t58 = t56 == 0.0f;
    const float t59 = (t58 ? 0.0f : (t33 ? t54 : (t32 ? t54 : (t31 ? t54 : t29)))) / t57;
    const float t60 = (t58 ? 0.0f : t47) / t57;
    const float t61 = t50 < 0.0f ? -1.0f : (0.0f < t50 ? 1.0f : (t51 < 0.0f ? -1.0f : 1.0f));
    const float t62 = 0.0f < t59 ? 1.0f : (t49 < 0.0f ? -1.0f : (0.0f < t49 ? 1.0f : t61));
    const float t63 = 0.0f == t30 - t30 ? (t59 < 0.0f ? -1.0f : t62) : NAN;
    const float axis0 = t49 * t63;
    const float axis1 = t50 * t63;
    const float axis2 = t51 * t63;
    const float t64 = a[0] + a_prime[0];
    const float t65 = a[1] + a_prime[1];
    const float t66 = a[2] + a_prime[2];
    const float t67 = a_prime[0] - a[0];
    const float t68 = a_prime[1] - a[1];
    const float t69 = a_prime[2] - a[2];
    const float t70 = axis1 * t69 - axis2 * t68;
    const float t71 = axis2 * t67 - axis0 * t69;
    const float t72 = axis0 * t68 - axis1 * t67;
    const float t73 = t59 * t63;
    const float t74 = (t60 == 0.0f ? 0.0f : t73) / t60;
    const float t75 = axis2 * t65 - axis1 * t66 + (axis2 * t71 - axis1 * t72) * t74 / t42;
    const float axis3 = 0.5f * t75;
    const float t76 = axis0 * t66 - axis2 * t64 + (axis0 * t72 - axis2 * t70) * t74 / t42;
    const float axis4 = 0.5f * t76;
    const float t77 = axis1 * t64 - axis0 * t65 + (axis1 * t70 - axis0 * t71) * t74 / t42;
    const float axis5 = 0.5f * t77;
    const float d_0_value = axis0 * t67 + axis1 * t68 + axis2 * t69;
    const float phi_value = 2.0f * atan2f(t42 * t60, t73);
    axis[0] = axis0;
    axis[1] = axis1;
    axis[2] = axis2;
    axis[3] = axis3;
    axis[4] = axis4;
    axis[5] = axis5;
    *d_0 = d_0_value;
    *phi = phi_value;
}

/*
 * text 3.4.2 j chasles_screw_of_motion for a batch.
 *   verdict: holds under; assumes Q is a rotation, phi != 0
 *   114 operations; derivation sha256 f4c88cd5f5da36a09188beb0fcfbf3a4571931b3f06ad9a253f46079ff8f69c5
 */
void chasles_screw_of_motion_batch(
    size_t count,
    const double *Q, ptrdiff_t Q_step,
    const double *a, ptrdiff_t a_step,
    const double *a_prime, ptrdiff_t a_prime_step,
    double *axis, ptrdiff_t axis_step,
    double *d_0, ptrdiff_t d_0_step,
    double *phi, ptrdiff_t phi_step)
{
    char *const at[] = {(char *)Q, (char *)a, (char *)a_prime, (char *)axis, (char *)d_0, (char *)phi};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        Q_step * size,
        a_step * size,
        a_prime_step * size,
        axis_step * size,
        d_0_step * size,
        phi_step * size};
    const chasles_loop *loop = &chasles_screw_of_motion_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.4.2 j chasles_screw_of_motionf for a batch.
 *   verdict: holds under; assumes Q is a rotation, phi != 0
 *   114 operations; derivation sha256 f4c88cd5f5da36a09188beb0fcfbf3a4571931b3f06ad9a253f46079ff8f69c5
 */
void chasles_screw_of_motion_batchf(
    size_t count,
    const float *Q, ptrdiff_t Q_step,
    const float *a, ptrdiff_t a_step,
    const float *a_prime, ptrdiff_t a_prime_step,
    float *axis, ptrdiff_t axis_step,
    float *d_0, ptrdiff_t d_0_step,
    float *phi, ptrdiff_t phi_step)
{
    char *const at[] = {(char *)Q, (char *)a, (char *)a_prime, (char *)axis, (char *)d_0, (char *)phi};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        Q_step * size,
        a_step * size,
        a_prime_step * size,
        axis_step * size,
        d_0_step * size,
        phi_step * size};
    const chasles_loop *loop = &chasles_screw_of_motion_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.4.1 c The instant screw: Plücker array of its axis, and pitch.
 *   given       omega[3]: angular velocity
 *               a_dot[3]: time derivative of: position of the landmark point A
 *               a[3]: position of the landmark point A
 *   returns     axis[6]: [e'; n']
 *               pitch: pitch of the instant screw, in metres per radian
 *   verdict     holds under
 *   assumes     omega != 0
 *   made of     an offered form, proved equal to the statement
 *   operations  45: 7 add, 6 subtract, 18 multiply, 13 divide, 1 square root
 *   error bound axis: 21.51 u of the sum of its terms' sizes, for all inputs
 *               pitch: 14.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 08f61d1364f32cd980675c2c982387b0404b3c2069f72429195ad15600cd8055
 */
void chasles_instant_screw(
    const double omega[3],
    const double a_dot[3],
    const double a[3],
    double axis[6],
    double *pitch)
{
    const double t1 = omega[0] < 0.0 ? -omega[0] : omega[0];
    const double t2 = omega[1] < 0.0 ? -omega[1] : omega[1];
    const double t3 = t1 < t2 ? t2 : t1;
    const double t4 = omega[2] < 0.0 ? -omega[2] : omega[2];
    const double t5 = t3 < t4 ? t4 : t3;
    const double t6 = 0.0 == t5 ? 1.0 : t5;
    const double t7 = omega[0] / t6;
    const double t8 = omega[1] / t6;
    const double t9 = omega[2] / t6;
    const double t10 = t7 * t7 + t8 * t8 + t9 * t9;
    const double t11 = sqrt(t10);
    const int t12 = t10 == 0.0;
    const double axis0 = (t12 ? 0.0 : t7) / t11;
    const double axis1 = (t12 ? 0.0 : t8) / t11;
    const double axis2 = (t12 ? 0.0 : t9) / t11;
    const double t13 = (t12 ? 0.0 : a_dot[0]) / t11;
    const double t14 = (t12 ? 0.0 : a_dot[1]) / t11;
    const double t15 = (t12 ? 0.0 : a_dot[2]) / t11;
    const double t16 = a[0] + (axis1 * t15 - axis2 * t14) / t6;
    const double t17 = a[1] + (axis2 * t13 - axis0 * t15) / t6;
    const double t18 = a[2] + (axis0 * t14 - axis1 * t13) / t6;
    const double axis3 = axis2 * t17 - axis1 * t18;
    const double axis4 = axis0 * t18 - axis2 * t16;
    const double axis5 = axis1 * t16 - axis0 * t17;
    const double pitch_value = (axis0 * t13 + axis1 * t14 + axis2 * t15) / t6;
    axis[0] = axis0;
    axis[1] = axis1;
    axis[2] = axis2;
    axis[3] = axis3;
    axis[4] = axis4;
    axis[5] = axis5;
    *pitch = pitch_value;
}

/*
 * text 3.4.1 c chasles_instant_screw in single precision.
 *   verdict: holds under; assumes omega != 0
 *   45 operations; derivation sha256 08f61d1364f32cd980675c2c982387b0404b3c2069f72429195ad15600cd8055
 */
void chasles_instant_screwf(
    const float omega[3],
    const float a_dot[3],
    const float a[3],
    float axis[6],
    float *pitch)
{
    const float t1 = omega[0] < 0.0f ? -omega[0] : omega[0];
    const float t2 = omega[1] < 0.0f ? -omega[1] : omega[1];
    const float t3 = t1 < t2 ? t2 : t1;
    const float t4 = omega[2] < 0.0f ? -omega[2] : omega[2];
    const float t5 = t3 < t4 ? t4 : t3;
    const float t6 = 0.0f == t5 ? 1.0f : t5;
    const float t7 = omega[0] / t6;
    const float t8 = omega[1] / t6;
    const float t9 = omega[2] / t6;
    const float t10 = t7 * t7 + t8 * t8 + t9 * t9;
    const float t11 = sqrtf(t10);
    const int t12 = t10 == 0.0f;
    const float axis0 = (t12 ? 0.0f : t7) / t11;
    const float axis1 = (t12 ? 0.0f : t8) / t11;
    const float axis2 = (t12 ? 0.0f : t9) / t11;
    const float t13 = (t12 ? 0.0f : a_dot[0]) / t11;
    const float t14 = (t12 ? 0.0f : a_dot[1]) / t11;
    const float t15 = (t12 ? 0.0f : a_dot[2]) / t11;
    const float t16 = a[0] + (axis1 * t15 - axis2 * t14) / t6;
    const float t17 = a[1] + (axis2 * t13 - axis0 * t15) / t6;
    const float t18 = a[2] + (axis0 * t14 - axis1 * t13) / t6;
    const float axis3 = axis2 * t17 - axis1 * t18;
    const float axis4 = axis0 * t18 - axis2 * t16;
    const float axis5 = axis1 * t16 - axis0 * t17;
    const float pitch_value = (axis0 * t13 + axis1 * t14 + axis2 * t15) / t6;
    axis[0] = axis0;
    axis[1] = axis1;
    axis[2] = axis2;
    axis[3] = axis3;
    axis[4] = axis4;
    axis[5] = axis5;
    *pitch = pitch_value;
}

/*
 * text 3.4.1 c chasles_instant_screw for a batch.
 *   verdict: holds under; assumes omega != 0
 *   45 operations; derivation sha256 08f61d1364f32cd980675c2c982387b0404b3c2069f72429195ad15600cd8055
 */
void chasles_instant_screw_batch(
    size_t count,
    const double *omega, ptrdiff_t omega_step,
    const double *a_dot, ptrdiff_t a_dot_step,
    const double *a, ptrdiff_t a_step,
    double *axis, ptrdiff_t axis_step,
    double *pitch, ptrdiff_t pitch_step)
{
    char *const at[] = {(char *)omega, (char *)a_dot, (char *)a, (char *)axis, (char *)pitch};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {
        omega_step * size,
        a_dot_step * size,
        a_step * size,
        axis_step * size,
        pitch_step * size};
    const chasles_loop *loop = &chasles_instant_screw_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * text 3.4.1 c chasles_instant_screwf for a batch.
 *   verdict: holds under; assumes omega != 0
 *   45 operations; derivation sha256 08f61d1364f32cd980675c2c982387b0404b3c2069f72429195ad15600cd8055
 */
void chasles_instant_screw_batchf(
    size_t count,
    const float *omega, ptrdiff_t omega_step,
    const float *a_dot, ptrdiff_t a_dot_step,
    const float *a, ptrdiff_t a_step,
    float *axis, ptrdiff_t axis_step,
    float *pitch, ptrdiff_t pitch_step)
{
    char *const at[] = {(char *)omega, (char *)a_dot, (char *)a, (char *)axis, (char *)pitch};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {
        omega_step * size,
        a_dot_step * size,
        a_step * size,
        axis_step * size,
        pitch_step * size};
    const chasles_loop *loop = &chasles_instant_screw_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.77b) The matrix that gives the angular velocity from the natural invariants' rates.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *   returns     N_tilde[12]: angular velocity from the natural invariants' rates
 *   verdict     ill-formed as printed, defined as read
 *   assumes     |e| = 1
 *   operations  6: 1 subtract, 3 multiply, 1 sine, 1 cosine
 *   error bound 2.3 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 8f59c5ef77909eadf927c6b687cd3bab0b77e8cdc9373e233171e72268eed1b1
 */
void chasles_natural_velocity_matrix(const double e[3], double phi, double N_tilde[12])
{
    const double N_tilde3 = e[0];
    const double N_tilde7 = e[1];
    const double N_tilde11 = e[2];
    const double N_tilde0 = sin(phi);
    const double t1 = 1.0 - cos(phi);
    const double N_tilde9 = N_tilde3 * t1;
    const double N_tilde2 = N_tilde7 * t1;
    const double N_tilde4 = N_tilde11 * t1;
    const double N_tilde1 = -N_tilde4;
    const double N_tilde6 = -N_tilde9;
    const double N_tilde8 = -N_tilde2;
    N_tilde[0] = N_tilde0;
    N_tilde[1] = N_tilde1;
    N_tilde[2] = N_tilde2;
    N_tilde[3] = N_tilde3;
    N_tilde[4] = N_tilde4;
    N_tilde[5] = N_tilde0;
    N_tilde[6] = N_tilde6;
    N_tilde[7] = N_tilde7;
    N_tilde[8] = N_tilde8;
    N_tilde[9] = N_tilde9;
    N_tilde[10] = N_tilde0;
    N_tilde[11] = N_tilde11;
}

/*
 * (3.77b) chasles_natural_velocity_matrix in single precision.
 *   verdict: ill-formed as printed, defined as read; assumes |e| = 1
 *   6 operations; derivation sha256 8f59c5ef77909eadf927c6b687cd3bab0b77e8cdc9373e233171e72268eed1b1
 */
void chasles_natural_velocity_matrixf(const float e[3], float phi, float N_tilde[12])
{
    const float N_tilde3 = e[0];
    const float N_tilde7 = e[1];
    const float N_tilde11 = e[2];
    const float N_tilde0 = sinf(phi);
    const float t1 = 1.0f - cosf(phi);
    const float N_tilde9 = N_tilde3 * t1;
    const float N_tilde2 = N_tilde7 * t1;
    const float N_tilde4 = N_tilde11 * t1;
    const float N_tilde1 = -N_tilde4;
    const float N_tilde6 = -N_tilde9;
    const float N_tilde8 = -N_tilde2;
    N_tilde[0] = N_tilde0;
    N_tilde[1] = N_tilde1;
    N_tilde[2] = N_tilde2;
    N_tilde[3] = N_tilde3;
    N_tilde[4] = N_tilde4;
    N_tilde[5] = N_tilde0;
    N_tilde[6] = N_tilde6;
    N_tilde[7] = N_tilde7;
    N_tilde[8] = N_tilde8;
    N_tilde[9] = N_tilde9;
    N_tilde[10] = N_tilde0;
    N_tilde[11] = N_tilde11;
}

/*
 * (3.77b) chasles_natural_velocity_matrix for a batch.
 *   verdict: ill-formed as printed, defined as read; assumes |e| = 1
 *   6 operations; derivation sha256 8f59c5ef77909eadf927c6b687cd3bab0b77e8cdc9373e233171e72268eed1b1
 */
void chasles_natural_velocity_matrix_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *N_tilde, ptrdiff_t N_tilde_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)N_tilde};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, N_tilde_step * size};
    const chasles_loop *loop = &chasles_natural_velocity_matrix_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.77b) chasles_natural_velocity_matrixf for a batch.
 *   verdict: ill-formed as printed, defined as read; assumes |e| = 1
 *   6 operations; derivation sha256 8f59c5ef77909eadf927c6b687cd3bab0b77e8cdc9373e233171e72268eed1b1
 */
void chasles_natural_velocity_matrix_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *N_tilde, ptrdiff_t N_tilde_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)N_tilde};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, N_tilde_step * size};
    const chasles_loop *loop = &chasles_natural_velocity_matrix_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.77c) The matrix that gives the angular velocity from the linear invariants' rates.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *   returns     L_tilde[12]: angular velocity from the linear invariants' rates
 *   verdict     ill-formed as printed, defined as read
 *   assumes     |e| = 1
 *               phi != pi
 *   operations  7: 4 multiply, 1 divide, 1 sine, 1 cosine
 *   error bound 5.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 89a180463935f0c42617efa0988e0354bd46d74d20a13999139be0c69246d5f3
 */
void chasles_linear_velocity_matrix(const double e[3], double phi, double L_tilde[12])
{
    const double half_phi = 0.5 * phi;
    const double cos_half_phi = cos(half_phi);
    const double t1 = (cos_half_phi == 0.0 ? 0.0 : sin(half_phi)) / cos_half_phi;
    const double L_tilde9 = e[0] * t1;
    const double L_tilde2 = e[1] * t1;
    const double L_tilde4 = e[2] * t1;
    const double L_tilde1 = -L_tilde4;
    const double L_tilde3 = -L_tilde9;
    const double L_tilde7 = -L_tilde2;
    L_tilde[0] = 1.0;
    L_tilde[1] = L_tilde1;
    L_tilde[2] = L_tilde2;
    L_tilde[3] = L_tilde3;
    L_tilde[4] = L_tilde4;
    L_tilde[5] = 1.0;
    L_tilde[6] = L_tilde3;
    L_tilde[7] = L_tilde7;
    L_tilde[8] = L_tilde7;
    L_tilde[9] = L_tilde9;
    L_tilde[10] = 1.0;
    L_tilde[11] = L_tilde1;
}

/*
 * (3.77c) chasles_linear_velocity_matrix in single precision.
 *   verdict: ill-formed as printed, defined as read; assumes |e| = 1, phi != pi
 *   7 operations; derivation sha256 89a180463935f0c42617efa0988e0354bd46d74d20a13999139be0c69246d5f3
 */
void chasles_linear_velocity_matrixf(const float e[3], float phi, float L_tilde[12])
{
    const float half_phi = 0.5f * phi;
    const float cos_half_phi = cosf(half_phi);
    const float t1 = (cos_half_phi == 0.0f ? 0.0f : sinf(half_phi)) / cos_half_phi;
    const float L_tilde9 = e[0] * t1;
    const float L_tilde2 = e[1] * t1;
    const float L_tilde4 = e[2] * t1;
    const float L_tilde1 = -L_tilde4;
    const float L_tilde3 = -L_tilde9;
    const float L_tilde7 = -L_tilde2;
    L_tilde[0] = 1.0f;
    L_tilde[1] = L_tilde1;
    L_tilde[2] = L_tilde2;
    L_tilde[3] = L_tilde3;
    L_tilde[4] = L_tilde4;
    L_tilde[5] = 1.0f;
    L_tilde[6] = L_tilde3;
    L_tilde[7] = L_tilde7;
    L_tilde[8] = L_tilde7;
    L_tilde[9] = L_tilde9;
    L_tilde[10] = 1.0f;
    L_tilde[11] = L_tilde1;
}

/*
 * (3.77c) chasles_linear_velocity_matrix for a batch.
 *   verdict: ill-formed as printed, defined as read; assumes |e| = 1, phi != pi
 *   7 operations; derivation sha256 89a180463935f0c42617efa0988e0354bd46d74d20a13999139be0c69246d5f3
 */
void chasles_linear_velocity_matrix_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *L_tilde, ptrdiff_t L_tilde_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)L_tilde};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, L_tilde_step * size};
    const chasles_loop *loop = &chasles_linear_velocity_matrix_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.77c) chasles_linear_velocity_matrixf for a batch.
 *   verdict: ill-formed as printed, defined as read; assumes |e| = 1, phi != pi
 *   7 operations; derivation sha256 89a180463935f0c42617efa0988e0354bd46d74d20a13999139be0c69246d5f3
 */
void chasles_linear_velocity_matrix_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *L_tilde, ptrdiff_t L_tilde_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)L_tilde};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, L_tilde_step * size};
    const chasles_loop *loop = &chasles_linear_velocity_matrix_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.77d) The matrix that gives the angular velocity from the Euler-Rodrigues parameters' rates.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *   returns     H_tilde[12]: angular velocity from the Euler-Rodrigues parameters' rates
 *   verdict     ill-formed as printed, defined as read
 *   assumes     |e| = 1
 *   operations  8: 6 multiply, 1 sine, 1 cosine
 *   error bound 2.61 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 2f21b7ee20e1702180f136497178c100314ca7d0df136dd2feb59d1f89a6b375
 */
void chasles_euler_rodrigues_velocity_matrix(const double e[3], double phi, double H_tilde[12])
{
    const double half_phi = 0.5 * phi;
    const double H_tilde0 = 2.0 * cos(half_phi);
    const double t1 = 2.0 * sin(half_phi);
    const double H_tilde9 = e[0] * t1;
    const double H_tilde2 = e[1] * t1;
    const double H_tilde4 = e[2] * t1;
    const double H_tilde1 = -H_tilde4;
    const double H_tilde3 = -H_tilde9;
    const double H_tilde7 = -H_tilde2;
    H_tilde[0] = H_tilde0;
    H_tilde[1] = H_tilde1;
    H_tilde[2] = H_tilde2;
    H_tilde[3] = H_tilde3;
    H_tilde[4] = H_tilde4;
    H_tilde[5] = H_tilde0;
    H_tilde[6] = H_tilde3;
    H_tilde[7] = H_tilde7;
    H_tilde[8] = H_tilde7;
    H_tilde[9] = H_tilde9;
    H_tilde[10] = H_tilde0;
    H_tilde[11] = H_tilde1;
}

/*
 * (3.77d) chasles_euler_rodrigues_velocity_matrix in single precision.
 *   verdict: ill-formed as printed, defined as read; assumes |e| = 1
 *   8 operations; derivation sha256 2f21b7ee20e1702180f136497178c100314ca7d0df136dd2feb59d1f89a6b375
 */
void chasles_euler_rodrigues_velocity_matrixf(const float e[3], float phi, float H_tilde[12])
{
    const float half_phi = 0.5f * phi;
    const float H_tilde0 = 2.0f * cosf(half_phi);
    const float t1 = 2.0f * sinf(half_phi);
    const float H_tilde9 = e[0] * t1;
    const float H_tilde2 = e[1] * t1;
    const float H_tilde4 = e[2] * t1;
    const float H_tilde1 = -H_tilde4;
    const float H_tilde3 = -H_tilde9;
    const float H_tilde7 = -H_tilde2;
    H_tilde[0] = H_tilde0;
    H_tilde[1] = H_tilde1;
    H_tilde[2] = H_tilde2;
    H_tilde[3] = H_tilde3;
    H_tilde[4] = H_tilde4;
    H_tilde[5] = H_tilde0;
    H_tilde[6] = H_tilde3;
    H_tilde[7] = H_tilde7;
    H_tilde[8] = H_tilde7;
    H_tilde[9] = H_tilde9;
    H_tilde[10] = H_tilde0;
    H_tilde[11] = H_tilde1;
}

/*
 * (3.77d) chasles_euler_rodrigues_velocity_matrix for a batch.
 *   verdict: ill-formed as printed, defined as read; assumes |e| = 1
 *   8 operations; derivation sha256 2f21b7ee20e1702180f136497178c100314ca7d0df136dd2feb59d1f89a6b375
 */
void chasles_euler_rodrigues_velocity_matrix_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *H_tilde, ptrdiff_t H_tilde_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)H_tilde};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, H_tilde_step * size};
    const chasles_loop *loop = &chasles_euler_rodrigues_velocity_matrix_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.77d) chasles_euler_rodrigues_velocity_matrixf for a batch.
 *   verdict: ill-formed as printed, defined as read; assumes |e| = 1
 *   8 operations; derivation sha256 2f21b7ee20e1702180f136497178c100314ca7d0df136dd2feb59d1f89a6b375
 */
void chasles_euler_rodrigues_velocity_matrix_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *H_tilde, ptrdiff_t H_tilde_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)H_tilde};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, H_tilde_step * size};
    const chasles_loop *loop = &chasles_euler_rodrigues_velocity_matrix_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.78) The rate of the pose from the twist, with the natural invariants.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *   returns     s_dot[7]: time derivative of: pose array
 *   verdict     holds under
 *   assumes     |e| = 1
 *               phi != 0
 *   operations  34: 5 add, 6 subtract, 20 multiply, 1 divide, 1 sine, 1 cosine
 *   error bound 11.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 e2dfaa3aa3fac1f79b45222f3204af5a75f395308f6b3f9290346729c641eaf1
 */
void chasles_pose_rate_natural(const double e[3], double phi, const double t[6], double s_dot[7])
{
    const double s_dot4 = t[3];
    const double s_dot5 = t[4];
    const double s_dot6 = t[5];
    const double s_dot3 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
    const double half_phi = 0.5 * phi;
    const double sin_half_phi = sin(half_phi);
    const double t1 = 0.5 * ((sin_half_phi == 0.0 ? 0.0 : cos(half_phi)) / sin_half_phi);
    const double s_dot0 = -(0.5 * (e[1] * t[2] - e[2] * t[1]) + (e[0] * s_dot3 - t[0]) * t1);
    const double s_dot1 = -(0.5 * (e[2] * t[0] - e[0] * t[2]) + (e[1] * s_dot3 - t[1]) * t1);
    const double s_dot2 = -(0.5 * (e[0] * t[1] - e[1] * t[0]) + (e[2] * s_dot3 - t[2]) * t1);
    s_dot[0] = s_dot0;
    s_dot[1] = s_dot1;
    s_dot[2] = s_dot2;
    s_dot[3] = s_dot3;
    s_dot[4] = s_dot4;
    s_dot[5] = s_dot5;
    s_dot[6] = s_dot6;
}

/*
 * (3.78) chasles_pose_rate_natural in single precision.
 *   verdict: holds under; assumes |e| = 1, phi != 0
 *   34 operations; derivation sha256 e2dfaa3aa3fac1f79b45222f3204af5a75f395308f6b3f9290346729c641eaf1
 */
void chasles_pose_rate_naturalf(const float e[3], float phi, const float t[6], float s_dot[7])
{
    const float s_dot4 = t[3];
    const float s_dot5 = t[4];
    const float s_dot6 = t[5];
    const float s_dot3 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
    const float half_phi = 0.5f * phi;
    const float sin_half_phi = sinf(half_phi);
    const float t1 = 0.5f * ((sin_half_phi == 0.0f ? 0.0f : cosf(half_phi)) / sin_half_phi);
    const float s_dot0 = -(0.5f * (e[1] * t[2] - e[2] * t[1]) + (e[0] * s_dot3 - t[0]) * t1);
    const float s_dot1 = -(0.5f * (e[2] * t[0] - e[0] * t[2]) + (e[1] * s_dot3 - t[1]) * t1);
    const float s_dot2 = -(0.5f * (e[0] * t[1] - e[1] * t[0]) + (e[2] * s_dot3 - t[2]) * t1);
    s_dot[0] = s_dot0;
    s_dot[1] = s_dot1;
    s_dot[2] = s_dot2;
    s_dot[3] = s_dot3;
    s_dot[4] = s_dot4;
    s_dot[5] = s_dot5;
    s_dot[6] = s_dot6;
}

/*
 * (3.78) chasles_pose_rate_natural for a batch.
 *   verdict: holds under; assumes |e| = 1, phi != 0
 *   34 operations; derivation sha256 e2dfaa3aa3fac1f79b45222f3204af5a75f395308f6b3f9290346729c641eaf1
 */
void chasles_pose_rate_natural_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *t, ptrdiff_t t_step,
    double *s_dot, ptrdiff_t s_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)t, (char *)s_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, t_step * size, s_dot_step * size};
    const chasles_loop *loop = &chasles_pose_rate_natural_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.78) chasles_pose_rate_naturalf for a batch.
 *   verdict: holds under; assumes |e| = 1, phi != 0
 *   34 operations; derivation sha256 e2dfaa3aa3fac1f79b45222f3204af5a75f395308f6b3f9290346729c641eaf1
 */
void chasles_pose_rate_natural_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *t, ptrdiff_t t_step,
    float *s_dot, ptrdiff_t s_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)t, (char *)s_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, t_step * size, s_dot_step * size};
    const chasles_loop *loop = &chasles_pose_rate_natural_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.78) The rate of the pose from the twist, with the linear invariants.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *   returns     s_dot[7]: time derivative of: pose array
 *   verdict     holds under
 *   assumes     |e| = 1
 *   operations  44: 5 add, 10 subtract, 27 multiply, 1 sine, 1 cosine
 *   error bound 9.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 30ffb709cd3b1987574a6cb20949774164c18855b55a74fc172537bd3a7138a3
 */
void chasles_pose_rate_linear(const double e[3], double phi, const double t[6], double s_dot[7])
{
    const double s_dot4 = t[3];
    const double s_dot5 = t[4];
    const double s_dot6 = t[5];
    const double t1 = 0.5 * cos(phi);
    const double t2 = 0.5 + t1;
    const double t3 = (e[0] * t[0] + e[1] * t[1] + e[2] * t[2]) * (0.5 - t1);
    const double sin_phi = sin(phi);
    const double half_sin_phi = 0.5 * sin_phi;
    const double s_dot0 = t[0] * t2 - e[0] * t3 - (e[1] * t[2] - e[2] * t[1]) * half_sin_phi;
    const double s_dot1 = t[1] * t2 - e[1] * t3 - (e[2] * t[0] - e[0] * t[2]) * half_sin_phi;
    const double s_dot2 = t[2] * t2 - e[2] * t3 - (e[0] * t[1] - e[1] * t[0]) * half_sin_phi;
    const double t4 = t[0] * (e[0] * sin_phi) + t[1] * (e[1] * sin_phi);
    const double s_dot3 = -(t4 + t[2] * (e[2] * sin_phi));
    s_dot[0] = s_dot0;
    s_dot[1] = s_dot1;
    s_dot[2] = s_dot2;
    s_dot[3] = s_dot3;
    s_dot[4] = s_dot4;
    s_dot[5] = s_dot5;
    s_dot[6] = s_dot6;
}

/*
 * (3.78) chasles_pose_rate_linear in single precision.
 *   verdict: holds under; assumes |e| = 1
 *   44 operations; derivation sha256 30ffb709cd3b1987574a6cb20949774164c18855b55a74fc172537bd3a7138a3
 */
void chasles_pose_rate_linearf(const float e[3], float phi, const float t[6], float s_dot[7])
{
    const float s_dot4 = t[3];
    const float s_dot5 = t[4];
    const float s_dot6 = t[5];
    const float t1 = 0.5f * cosf(phi);
    const float t2 = 0.5f + t1;
    const float t3 = (e[0] * t[0] + e[1] * t[1] + e[2] * t[2]) * (0.5f - t1);
    const float sin_phi = sinf(phi);
    const float half_sin_phi = 0.5f * sin_phi;
    const float s_dot0 = t[0] * t2 - e[0] * t3 - (e[1] * t[2] - e[2] * t[1]) * half_sin_phi;
    const float s_dot1 = t[1] * t2 - e[1] * t3 - (e[2] * t[0] - e[0] * t[2]) * half_sin_phi;
    const float s_dot2 = t[2] * t2 - e[2] * t3 - (e[0] * t[1] - e[1] * t[0]) * half_sin_phi;
    const float t4 = t[0] * (e[0] * sin_phi) + t[1] * (e[1] * sin_phi);
    const float s_dot3 = -(t4 + t[2] * (e[2] * sin_phi));
    s_dot[0] = s_dot0;
    s_dot[1] = s_dot1;
    s_dot[2] = s_dot2;
    s_dot[3] = s_dot3;
    s_dot[4] = s_dot4;
    s_dot[5] = s_dot5;
    s_dot[6] = s_dot6;
}

/*
 * (3.78) chasles_pose_rate_linear for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   44 operations; derivation sha256 30ffb709cd3b1987574a6cb20949774164c18855b55a74fc172537bd3a7138a3
 */
void chasles_pose_rate_linear_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *t, ptrdiff_t t_step,
    double *s_dot, ptrdiff_t s_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)t, (char *)s_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, t_step * size, s_dot_step * size};
    const chasles_loop *loop = &chasles_pose_rate_linear_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.78) chasles_pose_rate_linearf for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   44 operations; derivation sha256 30ffb709cd3b1987574a6cb20949774164c18855b55a74fc172537bd3a7138a3
 */
void chasles_pose_rate_linear_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *t, ptrdiff_t t_step,
    float *s_dot, ptrdiff_t s_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)t, (char *)s_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, t_step * size, s_dot_step * size};
    const chasles_loop *loop = &chasles_pose_rate_linear_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.78) The rate of the pose from the twist, with the Euler-Rodrigues parameters.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *   returns     s_dot[7]: time derivative of: pose array
 *   verdict     holds under
 *   assumes     |e| = 1
 *   operations  28: 5 add, 3 subtract, 18 multiply, 1 sine, 1 cosine
 *   error bound 5.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 17b8436529f6b3c4a1aefcc8236971431106d820c1c98937a7defcd8b9830b55
 */
void chasles_pose_rate_euler_rodrigues(
    const double e[3],
    double phi,
    const double t[6],
    double s_dot[7])
{
    const double s_dot4 = t[3];
    const double s_dot5 = t[4];
    const double s_dot6 = t[5];
    const double half_phi = 0.5 * phi;
    const double t1 = 0.5 * cos(half_phi);
    const double t2 = 0.5 * sin(half_phi);
    const double t3 = e[0] * t2;
    const double t4 = e[1] * t2;
    const double t5 = e[2] * t2;
    const double s_dot0 = t[0] * t1 + t[1] * t5 - t[2] * t4;
    const double s_dot1 = t[1] * t1 - t[0] * t5 + t[2] * t3;
    const double s_dot2 = t[0] * t4 - t[1] * t3 + t[2] * t1;
    const double s_dot3 = -(t[0] * t3 + t[1] * t4 + t[2] * t5);
    s_dot[0] = s_dot0;
    s_dot[1] = s_dot1;
    s_dot[2] = s_dot2;
    s_dot[3] = s_dot3;
    s_dot[4] = s_dot4;
    s_dot[5] = s_dot5;
    s_dot[6] = s_dot6;
}

/*
 * (3.78) chasles_pose_rate_euler_rodrigues in single precision.
 *   verdict: holds under; assumes |e| = 1
 *   28 operations; derivation sha256 17b8436529f6b3c4a1aefcc8236971431106d820c1c98937a7defcd8b9830b55
 */
void chasles_pose_rate_euler_rodriguesf(
    const float e[3],
    float phi,
    const float t[6],
    float s_dot[7])
{
    const float s_dot4 = t[3];
    const float s_dot5 = t[4];
    const float s_dot6 = t[5];
    const float half_phi = 0.5f * phi;
    const float t1 = 0.5f * cosf(half_phi);
    const float t2 = 0.5f * sinf(half_phi);
    const float t3 = e[0] * t2;
    const float t4 = e[1] * t2;
    const float t5 = e[2] * t2;
    const float s_dot0 = t[0] * t1 + t[1] * t5 - t[2] * t4;
    const float s_dot1 = t[1] * t1 - t[0] * t5 + t[2] * t3;
    const float s_dot2 = t[0] * t4 - t[1] * t3 + t[2] * t1;
    const float s_dot3 = -(t[0] * t3 + t[1] * t4 + t[2] * t5);
    s_dot[0] = s_dot0;
    s_dot[1] = s_dot1;
    s_dot[2] = s_dot2;
    s_dot[3] = s_dot3;
    s_dot[4] = s_dot4;
    s_dot[5] = s_dot5;
    s_dot[6] = s_dot6;
}

/*
 * (3.78) chasles_pose_rate_euler_rodrigues for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   28 operations; derivation sha256 17b8436529f6b3c4a1aefcc8236971431106d820c1c98937a7defcd8b9830b55
 */
void chasles_pose_rate_euler_rodrigues_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *t, ptrdiff_t t_step,
    double *s_dot, ptrdiff_t s_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)t, (char *)s_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, t_step * size, s_dot_step * size};
    const chasles_loop *loop = &chasles_pose_rate_euler_rodrigues_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.78) chasles_pose_rate_euler_rodriguesf for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   28 operations; derivation sha256 17b8436529f6b3c4a1aefcc8236971431106d820c1c98937a7defcd8b9830b55
 */
void chasles_pose_rate_euler_rodrigues_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *t, ptrdiff_t t_step,
    float *s_dot, ptrdiff_t s_dot_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)t, (char *)s_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, t_step * size, s_dot_step * size};
    const chasles_loop *loop = &chasles_pose_rate_euler_rodrigues_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.80a) The twist from the rate of the pose, with the natural invariants.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               s_dot[7]: time derivative of: pose array
 *   returns     t[6]: twist: angular velocity, velocity of a landmark point
 *   verdict     holds under
 *   assumes     |e| = 1
 *   operations  27: 6 add, 4 subtract, 15 multiply, 1 sine, 1 cosine
 *   error bound 7.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 c1c920878c5f917138095dea1943d4f0605d07dd2521a120e9e0a574400414d0
 */
void chasles_twist_from_pose_rate_natural(
    const double e[3],
    double phi,
    const double s_dot[7],
    double t[6])
{
    const double t3 = s_dot[4];
    const double t4 = s_dot[5];
    const double t5 = s_dot[6];
    const double sin_phi = sin(phi);
    const double t6 = 1.0 - cos(phi);
    const double t7 = s_dot[0] * sin_phi + t6 * (e[1] * s_dot[2] - e[2] * s_dot[1]);
    const double t0 = t7 + e[0] * s_dot[3];
    const double t8 = s_dot[1] * sin_phi + t6 * (e[2] * s_dot[0] - e[0] * s_dot[2]);
    const double t1 = t8 + e[1] * s_dot[3];
    const double t9 = s_dot[2] * sin_phi + t6 * (e[0] * s_dot[1] - e[1] * s_dot[0]);
    const double t2 = t9 + e[2] * s_dot[3];
    t[0] = t0;
    t[1] = t1;
    t[2] = t2;
    t[3] = t3;
    t[4] = t4;
    t[5] = t5;
}

/*
 * (3.80a) chasles_twist_from_pose_rate_natural in single precision.
 *   verdict: holds under; assumes |e| = 1
 *   27 operations; derivation sha256 c1c920878c5f917138095dea1943d4f0605d07dd2521a120e9e0a574400414d0
 */
void chasles_twist_from_pose_rate_naturalf(
    const float e[3],
    float phi,
    const float s_dot[7],
    float t[6])
{
    const float t3 = s_dot[4];
    const float t4 = s_dot[5];
    const float t5 = s_dot[6];
    const float sin_phi = sinf(phi);
    const float t6 = 1.0f - cosf(phi);
    const float t7 = s_dot[0] * sin_phi + t6 * (e[1] * s_dot[2] - e[2] * s_dot[1]);
    const float t0 = t7 + e[0] * s_dot[3];
    const float t8 = s_dot[1] * sin_phi + t6 * (e[2] * s_dot[0] - e[0] * s_dot[2]);
    const float t1 = t8 + e[1] * s_dot[3];
    const float t9 = s_dot[2] * sin_phi + t6 * (e[0] * s_dot[1] - e[1] * s_dot[0]);
    const float t2 = t9 + e[2] * s_dot[3];
    t[0] = t0;
    t[1] = t1;
    t[2] = t2;
    t[3] = t3;
    t[4] = t4;
    t[5] = t5;
}

/*
 * (3.80a) chasles_twist_from_pose_rate_natural for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   27 operations; derivation sha256 c1c920878c5f917138095dea1943d4f0605d07dd2521a120e9e0a574400414d0
 */
void chasles_twist_from_pose_rate_natural_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *s_dot, ptrdiff_t s_dot_step,
    double *t, ptrdiff_t t_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)s_dot, (char *)t};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, s_dot_step * size, t_step * size};
    const chasles_loop *loop = &chasles_twist_from_pose_rate_natural_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.80a) chasles_twist_from_pose_rate_naturalf for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   27 operations; derivation sha256 c1c920878c5f917138095dea1943d4f0605d07dd2521a120e9e0a574400414d0
 */
void chasles_twist_from_pose_rate_natural_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *s_dot, ptrdiff_t s_dot_step,
    float *t, ptrdiff_t t_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)s_dot, (char *)t};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, s_dot_step * size, t_step * size};
    const chasles_loop *loop = &chasles_twist_from_pose_rate_natural_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.80a) The twist from the rate of the pose, with the linear invariants.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               s_dot[7]: time derivative of: pose array
 *   returns     t[6]: twist: angular velocity, velocity of a landmark point
 *   verdict     holds under
 *   assumes     |e| = 1
 *               phi != pi
 *   operations  25: 3 add, 6 subtract, 13 multiply, 1 divide, 1 sine, 1 cosine
 *   error bound 9.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 649387c3a4635aed7b72ec7a0c9cd67fa1407b285288b83838890827853ca799
 */
void chasles_twist_from_pose_rate_linear(
    const double e[3],
    double phi,
    const double s_dot[7],
    double t[6])
{
    const double t3 = s_dot[4];
    const double t4 = s_dot[5];
    const double t5 = s_dot[6];
    const double half_phi = 0.5 * phi;
    const double cos_half_phi = cos(half_phi);
    const double t6 = (cos_half_phi == 0.0 ? 0.0 : sin(half_phi)) / cos_half_phi;
    const double t7 = e[0] * t6;
    const double t8 = e[1] * t6;
    const double t9 = e[2] * t6;
    const double t0 = s_dot[0] - s_dot[1] * t9 + s_dot[2] * t8 - s_dot[3] * t7;
    const double t1 = s_dot[1] + s_dot[0] * t9 - s_dot[2] * t7 - s_dot[3] * t8;
    const double t2 = s_dot[2] + (s_dot[1] * t7 - s_dot[0] * t8) - s_dot[3] * t9;
    t[0] = t0;
    t[1] = t1;
    t[2] = t2;
    t[3] = t3;
    t[4] = t4;
    t[5] = t5;
}

/*
 * (3.80a) chasles_twist_from_pose_rate_linear in single precision.
 *   verdict: holds under; assumes |e| = 1, phi != pi
 *   25 operations; derivation sha256 649387c3a4635aed7b72ec7a0c9cd67fa1407b285288b83838890827853ca799
 */
void chasles_twist_from_pose_rate_linearf(
    const float e[3],
    float phi,
    const float s_dot[7],
    float t[6])
{
    const float t3 = s_dot[4];
    const float t4 = s_dot[5];
    const float t5 = s_dot[6];
    const float half_phi = 0.5f * phi;
    const float cos_half_phi = cosf(half_phi);
    const float t6 = (cos_half_phi == 0.0f ? 0.0f : sinf(half_phi)) / cos_half_phi;
    const float t7 = e[0] * t6;
    const float t8 = e[1] * t6;
    const float t9 = e[2] * t6;
    const float t0 = s_dot[0] - s_dot[1] * t9 + s_dot[2] * t8 - s_dot[3] * t7;
    const float t1 = s_dot[1] + s_dot[0] * t9 - s_dot[2] * t7 - s_dot[3] * t8;
    const float t2 = s_dot[2] + (s_dot[1] * t7 - s_dot[0] * t8) - s_dot[3] * t9;
    t[0] = t0;
    t[1] = t1;
    t[2] = t2;
    t[3] = t3;
    t[4] = t4;
    t[5] = t5;
}

/*
 * (3.80a) chasles_twist_from_pose_rate_linear for a batch.
 *   verdict: holds under; assumes |e| = 1, phi != pi
 *   25 operations; derivation sha256 649387c3a4635aed7b72ec7a0c9cd67fa1407b285288b83838890827853ca799
 */
void chasles_twist_from_pose_rate_linear_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *s_dot, ptrdiff_t s_dot_step,
    double *t, ptrdiff_t t_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)s_dot, (char *)t};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, s_dot_step * size, t_step * size};
    const chasles_loop *loop = &chasles_twist_from_pose_rate_linear_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.80a) chasles_twist_from_pose_rate_linearf for a batch.
 *   verdict: holds under; assumes |e| = 1, phi != pi
 *   25 operations; derivation sha256 649387c3a4635aed7b72ec7a0c9cd67fa1407b285288b83838890827853ca799
 */
void chasles_twist_from_pose_rate_linear_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *s_dot, ptrdiff_t s_dot_step,
    float *t, ptrdiff_t t_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)s_dot, (char *)t};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, s_dot_step * size, t_step * size};
    const chasles_loop *loop = &chasles_twist_from_pose_rate_linear_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.80a) The twist from the rate of the pose, with the Euler-Rodrigues parameters.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               s_dot[7]: time derivative of: pose array
 *   returns     t[6]: twist: angular velocity, velocity of a landmark point
 *   verdict     holds under
 *   assumes     |e| = 1
 *   operations  29: 3 add, 6 subtract, 18 multiply, 1 sine, 1 cosine
 *   error bound 6.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 f7009c929bd74e6e8423e03290dcaa8570b236828a6884c7d6bd52463508ac87
 */
void chasles_twist_from_pose_rate_euler_rodrigues(
    const double e[3],
    double phi,
    const double s_dot[7],
    double t[6])
{
    const double t3 = s_dot[4];
    const double t4 = s_dot[5];
    const double t5 = s_dot[6];
    const double half_phi = 0.5 * phi;
    const double t6 = 2.0 * cos(half_phi);
    const double t7 = 2.0 * sin(half_phi);
    const double t8 = e[0] * t7;
    const double t9 = e[1] * t7;
    const double t10 = e[2] * t7;
    const double t0 = s_dot[0] * t6 - s_dot[1] * t10 + s_dot[2] * t9 - s_dot[3] * t8;
    const double t1 = s_dot[0] * t10 + s_dot[1] * t6 - s_dot[2] * t8 - s_dot[3] * t9;
    const double t2 = s_dot[1] * t8 - s_dot[0] * t9 + s_dot[2] * t6 - s_dot[3] * t10;
    t[0] = t0;
    t[1] = t1;
    t[2] = t2;
    t[3] = t3;
    t[4] = t4;
    t[5] = t5;
}

/*
 * (3.80a) chasles_twist_from_pose_rate_euler_rodrigues in single precision.
 *   verdict: holds under; assumes |e| = 1
 *   29 operations; derivation sha256 f7009c929bd74e6e8423e03290dcaa8570b236828a6884c7d6bd52463508ac87
 */
void chasles_twist_from_pose_rate_euler_rodriguesf(
    const float e[3],
    float phi,
    const float s_dot[7],
    float t[6])
{
    const float t3 = s_dot[4];
    const float t4 = s_dot[5];
    const float t5 = s_dot[6];
    const float half_phi = 0.5f * phi;
    const float t6 = 2.0f * cosf(half_phi);
    const float t7 = 2.0f * sinf(half_phi);
    const float t8 = e[0] * t7;
    const float t9 = e[1] * t7;
    const float t10 = e[2] * t7;
    const float t0 = s_dot[0] * t6 - s_dot[1] * t10 + s_dot[2] * t9 - s_dot[3] * t8;
    const float t1 = s_dot[0] * t10 + s_dot[1] * t6 - s_dot[2] * t8 - s_dot[3] * t9;
    const float t2 = s_dot[1] * t8 - s_dot[0] * t9 + s_dot[2] * t6 - s_dot[3] * t10;
    t[0] = t0;
    t[1] = t1;
    t[2] = t2;
    t[3] = t3;
    t[4] = t4;
    t[5] = t5;
}

/*
 * (3.80a) chasles_twist_from_pose_rate_euler_rodrigues for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   29 operations; derivation sha256 f7009c929bd74e6e8423e03290dcaa8570b236828a6884c7d6bd52463508ac87
 */
void chasles_twist_from_pose_rate_euler_rodrigues_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *s_dot, ptrdiff_t s_dot_step,
    double *t, ptrdiff_t t_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)s_dot, (char *)t};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, s_dot_step * size, t_step * size};
    const chasles_loop *loop = &chasles_twist_from_pose_rate_euler_rodrigues_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.80a) chasles_twist_from_pose_rate_euler_rodriguesf for a batch.
 *   verdict: holds under; assumes |e| = 1
 *   29 operations; derivation sha256 f7009c929bd74e6e8423e03290dcaa8570b236828a6884c7d6bd52463508ac87
 */
void chasles_twist_from_pose_rate_euler_rodrigues_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *s_dot, ptrdiff_t s_dot_step,
    float *t, ptrdiff_t t_step)
{
    char *const at[] = {(char *)e, (char *)phi, (char *)s_dot, (char *)t};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {e_step * size, phi_step * size, s_dot_step * size, t_step * size};
    const chasles_loop *loop = &chasles_twist_from_pose_rate_euler_rodrigues_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.83a) The twist-transfer formula.
 *   given       t_A[6]: twist at A
 *               a[3]: position of the landmark point A
 *               p[3]: position of any point P
 *   returns     t_P[6]: twist at P
 *   verdict     holds
 *   assumes     nothing
 *   operations  15: 3 add, 6 subtract, 6 multiply
 *   error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 4e8860fe94d4e257f6a09561ef25e7c999ddca2a00337fe8774fc0c2b9433a22
 */
void chasles_twist_transfer(
    const double t_A[6],
    const double a[3],
    const double p[3],
    double t_P[6])
{
    const double t_P0 = t_A[0];
    const double t_P1 = t_A[1];
    const double t_P2 = t_A[2];
    const double t1 = a[0] - p[0];
    const double t2 = a[1] - p[1];
    const double t3 = a[2] - p[2];
    const double t_P3 = t_A[3] + (t_P2 * t2 - t_P1 * t3);
    const double t_P4 = t_A[4] + (t_P0 * t3 - t_P2 * t1);
    const double t_P5 = t_A[5] + (t_P1 * t1 - t_P0 * t2);
    t_P[0] = t_P0;
    t_P[1] = t_P1;
    t_P[2] = t_P2;
    t_P[3] = t_P3;
    t_P[4] = t_P4;
    t_P[5] = t_P5;
}

/*
 * (3.83a) chasles_twist_transfer in single precision.
 *   verdict: holds; assumes nothing
 *   15 operations; derivation sha256 4e8860fe94d4e257f6a09561ef25e7c999ddca2a00337fe8774fc0c2b9433a22
 */
void chasles_twist_transferf(const float t_A[6], const float a[3], const float p[3], float t_P[6])
{
    const float t_P0 = t_A[0];
    const float t_P1 = t_A[1];
    const float t_P2 = t_A[2];
    const float t1 = a[0] - p[0];
    const float t2 = a[1] - p[1];
    const float t3 = a[2] - p[2];
    const float t_P3 = t_A[3] + (t_P2 * t2 - t_P1 * t3);
    const float t_P4 = t_A[4] + (t_P0 * t3 - t_P2 * t1);
    const float t_P5 = t_A[5] + (t_P1 * t1 - t_P0 * t2);
    t_P[0] = t_P0;
    t_P[1] = t_P1;
    t_P[2] = t_P2;
    t_P[3] = t_P3;
    t_P[4] = t_P4;
    t_P[5] = t_P5;
}

/*
 * (3.83a) chasles_twist_transfer for a batch.
 *   verdict: holds; assumes nothing
 *   15 operations; derivation sha256 4e8860fe94d4e257f6a09561ef25e7c999ddca2a00337fe8774fc0c2b9433a22
 */
void chasles_twist_transfer_batch(
    size_t count,
    const double *t_A, ptrdiff_t t_A_step,
    const double *a, ptrdiff_t a_step,
    const double *p, ptrdiff_t p_step,
    double *t_P, ptrdiff_t t_P_step)
{
    char *const at[] = {(char *)t_A, (char *)a, (char *)p, (char *)t_P};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {t_A_step * size, a_step * size, p_step * size, t_P_step * size};
    const chasles_loop *loop = &chasles_twist_transfer_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * (3.83a) chasles_twist_transferf for a batch.
 *   verdict: holds; assumes nothing
 *   15 operations; derivation sha256 4e8860fe94d4e257f6a09561ef25e7c999ddca2a00337fe8774fc0c2b9433a22
 */
void chasles_twist_transfer_batchf(
    size_t count,
    const float *t_A, ptrdiff_t t_A_step,
    const float *a, ptrdiff_t a_step,
    const float *p, ptrdiff_t p_step,
    float *t_P, ptrdiff_t t_P_step)
{
    char *const at[] = {(char *)t_A, (char *)a, (char *)p, (char *)t_P};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {t_A_step * size, a_step * size, p_step * size, t_P_step * size};
    const chasles_loop *loop = &chasles_twist_transfer_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

#endif
