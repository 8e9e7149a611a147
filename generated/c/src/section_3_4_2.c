/* The kernels of section_3_4_2. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "batches.h"
#include "chasles.h"

static const chasles_shape chasles_natural_rate_matrix_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 4, 3},
};
const chasles_loop chasles_natural_rate_matrix_loop = {
    sizeof(double), 0, 2, 3,
    chasles_natural_rate_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_natural_rate_matrix_block),
};

static const chasles_shape chasles_natural_rate_matrix_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 4, 3},
};
const chasles_loop chasles_natural_rate_matrix_loopf = {
    sizeof(float), 0, 2, 3,
    chasles_natural_rate_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_natural_rate_matrix_blockf),
};

static const chasles_shape chasles_linear_rate_matrix_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 4, 3},
};
const chasles_loop chasles_linear_rate_matrix_loop = {
    sizeof(double), 0, 2, 3,
    chasles_linear_rate_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_linear_rate_matrix_block),
};

static const chasles_shape chasles_linear_rate_matrix_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 4, 3},
};
const chasles_loop chasles_linear_rate_matrix_loopf = {
    sizeof(float), 0, 2, 3,
    chasles_linear_rate_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_linear_rate_matrix_blockf),
};

static const chasles_shape chasles_euler_rodrigues_rate_matrix_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 4, 3},
};
const chasles_loop chasles_euler_rodrigues_rate_matrix_loop = {
    sizeof(double), 0, 2, 3,
    chasles_euler_rodrigues_rate_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_rate_matrix_block),
};

static const chasles_shape chasles_euler_rodrigues_rate_matrix_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 4, 3},
};
const chasles_loop chasles_euler_rodrigues_rate_matrix_loopf = {
    sizeof(float), 0, 2, 3,
    chasles_euler_rodrigues_rate_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_rate_matrix_blockf),
};

static const chasles_shape chasles_rotation_from_linear_invariants_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 3},
};
const chasles_loop chasles_rotation_from_linear_invariants_loop = {
    sizeof(double), 0, 2, 3,
    chasles_rotation_from_linear_invariants_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_linear_invariants_block),
};

static const chasles_shape chasles_rotation_from_linear_invariants_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 3},
};
const chasles_loop chasles_rotation_from_linear_invariants_loopf = {
    sizeof(float), 0, 2, 3,
    chasles_rotation_from_linear_invariants_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_linear_invariants_blockf),
};

static const chasles_shape chasles_rotation_from_euler_rodrigues_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 3},
};
const chasles_loop chasles_rotation_from_euler_rodrigues_loop = {
    sizeof(double), 0, 2, 3,
    chasles_rotation_from_euler_rodrigues_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_rodrigues_block),
};

static const chasles_shape chasles_rotation_from_euler_rodrigues_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 3},
};
const chasles_loop chasles_rotation_from_euler_rodrigues_loopf = {
    sizeof(float), 0, 2, 3,
    chasles_rotation_from_euler_rodrigues_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_rodrigues_blockf),
};

static const chasles_shape chasles_linear_invariants_loop_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {0, 1, 1},
};
const chasles_loop chasles_linear_invariants_loop = {
    sizeof(double), 0, 1, 3,
    chasles_linear_invariants_loop_shapes,
    CHASLES_BLOCKS(chasles_linear_invariants_block),
};

static const chasles_shape chasles_linear_invariants_loopf_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {0, 1, 1},
};
const chasles_loop chasles_linear_invariants_loopf = {
    sizeof(float), 0, 1, 3,
    chasles_linear_invariants_loopf_shapes,
    CHASLES_BLOCKS(chasles_linear_invariants_blockf),
};

static const chasles_shape chasles_natural_invariants_loop_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {0, 1, 1},
};
const chasles_loop chasles_natural_invariants_loop = {
    sizeof(double), 0, 1, 3,
    chasles_natural_invariants_loop_shapes,
    CHASLES_BLOCKS(chasles_natural_invariants_block),
};

static const chasles_shape chasles_natural_invariants_loopf_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {0, 1, 1},
};
const chasles_loop chasles_natural_invariants_loopf = {
    sizeof(float), 0, 1, 3,
    chasles_natural_invariants_loopf_shapes,
    CHASLES_BLOCKS(chasles_natural_invariants_blockf),
};

static const chasles_shape chasles_euler_rodrigues_parameters_loop_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {0, 1, 1},
};
const chasles_loop chasles_euler_rodrigues_parameters_loop = {
    sizeof(double), 0, 1, 3,
    chasles_euler_rodrigues_parameters_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_parameters_block),
};

static const chasles_shape chasles_euler_rodrigues_parameters_loopf_shapes[] = {
    {2, 3, 3},
    {1, 1, 3},
    {0, 1, 1},
};
const chasles_loop chasles_euler_rodrigues_parameters_loopf = {
    sizeof(float), 0, 1, 3,
    chasles_euler_rodrigues_parameters_loopf_shapes,
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
    sizeof(double), 0, 3, 6,
    chasles_screw_of_motion_loop_shapes,
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
    sizeof(float), 0, 3, 6,
    chasles_screw_of_motion_loopf_shapes,
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
    sizeof(double), 0, 3, 5,
    chasles_instant_screw_loop_shapes,
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
    sizeof(float), 0, 3, 5,
    chasles_instant_screw_loopf_shapes,
    CHASLES_BLOCKS(chasles_instant_screw_blockf),
};

static const chasles_shape chasles_natural_velocity_matrix_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 4},
};
const chasles_loop chasles_natural_velocity_matrix_loop = {
    sizeof(double), 0, 2, 3,
    chasles_natural_velocity_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_natural_velocity_matrix_block),
};

static const chasles_shape chasles_natural_velocity_matrix_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 4},
};
const chasles_loop chasles_natural_velocity_matrix_loopf = {
    sizeof(float), 0, 2, 3,
    chasles_natural_velocity_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_natural_velocity_matrix_blockf),
};

static const chasles_shape chasles_linear_velocity_matrix_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 4},
};
const chasles_loop chasles_linear_velocity_matrix_loop = {
    sizeof(double), 0, 2, 3,
    chasles_linear_velocity_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_linear_velocity_matrix_block),
};

static const chasles_shape chasles_linear_velocity_matrix_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 4},
};
const chasles_loop chasles_linear_velocity_matrix_loopf = {
    sizeof(float), 0, 2, 3,
    chasles_linear_velocity_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_linear_velocity_matrix_blockf),
};

static const chasles_shape chasles_euler_rodrigues_velocity_matrix_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 4},
};
const chasles_loop chasles_euler_rodrigues_velocity_matrix_loop = {
    sizeof(double), 0, 2, 3,
    chasles_euler_rodrigues_velocity_matrix_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_velocity_matrix_block),
};

static const chasles_shape chasles_euler_rodrigues_velocity_matrix_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {2, 3, 4},
};
const chasles_loop chasles_euler_rodrigues_velocity_matrix_loopf = {
    sizeof(float), 0, 2, 3,
    chasles_euler_rodrigues_velocity_matrix_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rodrigues_velocity_matrix_blockf),
};

static const chasles_shape chasles_pose_rate_natural_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_rate_natural_loop = {
    sizeof(double), 0, 3, 4,
    chasles_pose_rate_natural_loop_shapes,
    CHASLES_BLOCKS(chasles_pose_rate_natural_block),
};

static const chasles_shape chasles_pose_rate_natural_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_rate_natural_loopf = {
    sizeof(float), 0, 3, 4,
    chasles_pose_rate_natural_loopf_shapes,
    CHASLES_BLOCKS(chasles_pose_rate_natural_blockf),
};

static const chasles_shape chasles_pose_rate_linear_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_rate_linear_loop = {
    sizeof(double), 0, 3, 4,
    chasles_pose_rate_linear_loop_shapes,
    CHASLES_BLOCKS(chasles_pose_rate_linear_block),
};

static const chasles_shape chasles_pose_rate_linear_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_rate_linear_loopf = {
    sizeof(float), 0, 3, 4,
    chasles_pose_rate_linear_loopf_shapes,
    CHASLES_BLOCKS(chasles_pose_rate_linear_blockf),
};

static const chasles_shape chasles_pose_rate_euler_rodrigues_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_rate_euler_rodrigues_loop = {
    sizeof(double), 0, 3, 4,
    chasles_pose_rate_euler_rodrigues_loop_shapes,
    CHASLES_BLOCKS(chasles_pose_rate_euler_rodrigues_block),
};

static const chasles_shape chasles_pose_rate_euler_rodrigues_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 6},
    {1, 1, 7},
};
const chasles_loop chasles_pose_rate_euler_rodrigues_loopf = {
    sizeof(float), 0, 3, 4,
    chasles_pose_rate_euler_rodrigues_loopf_shapes,
    CHASLES_BLOCKS(chasles_pose_rate_euler_rodrigues_blockf),
};

static const chasles_shape chasles_twist_from_pose_rate_natural_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_from_pose_rate_natural_loop = {
    sizeof(double), 0, 3, 4,
    chasles_twist_from_pose_rate_natural_loop_shapes,
    CHASLES_BLOCKS(chasles_twist_from_pose_rate_natural_block),
};

static const chasles_shape chasles_twist_from_pose_rate_natural_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_from_pose_rate_natural_loopf = {
    sizeof(float), 0, 3, 4,
    chasles_twist_from_pose_rate_natural_loopf_shapes,
    CHASLES_BLOCKS(chasles_twist_from_pose_rate_natural_blockf),
};

static const chasles_shape chasles_twist_from_pose_rate_linear_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_from_pose_rate_linear_loop = {
    sizeof(double), 0, 3, 4,
    chasles_twist_from_pose_rate_linear_loop_shapes,
    CHASLES_BLOCKS(chasles_twist_from_pose_rate_linear_block),
};

static const chasles_shape chasles_twist_from_pose_rate_linear_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_from_pose_rate_linear_loopf = {
    sizeof(float), 0, 3, 4,
    chasles_twist_from_pose_rate_linear_loopf_shapes,
    CHASLES_BLOCKS(chasles_twist_from_pose_rate_linear_blockf),
};

static const chasles_shape chasles_twist_from_pose_rate_euler_rodrigues_loop_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_from_pose_rate_euler_rodrigues_loop = {
    sizeof(double), 0, 3, 4,
    chasles_twist_from_pose_rate_euler_rodrigues_loop_shapes,
    CHASLES_BLOCKS(chasles_twist_from_pose_rate_euler_rodrigues_block),
};

static const chasles_shape chasles_twist_from_pose_rate_euler_rodrigues_loopf_shapes[] = {
    {1, 1, 3},
    {0, 1, 1},
    {1, 1, 7},
    {1, 1, 6},
};
const chasles_loop chasles_twist_from_pose_rate_euler_rodrigues_loopf = {
    sizeof(float), 0, 3, 4,
    chasles_twist_from_pose_rate_euler_rodrigues_loopf_shapes,
    CHASLES_BLOCKS(chasles_twist_from_pose_rate_euler_rodrigues_blockf),
};

static const chasles_shape chasles_twist_transfer_loop_shapes[] = {
    {1, 1, 6},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
};
const chasles_loop chasles_twist_transfer_loop = {
    sizeof(double), 0, 3, 4,
    chasles_twist_transfer_loop_shapes,
    CHASLES_BLOCKS(chasles_twist_transfer_block),
};

static const chasles_shape chasles_twist_transfer_loopf_shapes[] = {
    {1, 1, 6},
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 6},
};
const chasles_loop chasles_twist_transfer_loopf = {
    sizeof(float), 0, 3, 4,
    chasles_twist_transfer_loopf_shapes,
    CHASLES_BLOCKS(chasles_twist_transfer_blockf),
};

/*
 * (3.76b) The matrix of the natural invariants' rates.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *   returns     N[12]: natural invariants' rates from the angular velocity
 *   verdict     defined
 *   assumes     |e| = 1
 *               phi != 0
 *   operations  26: 3 add, 7 subtract, 13 multiply, 1 divide, 1 sine, 1 cosine
 *   derivation  sha256 d1afff56486caa901f40463bd6490da7f0e507ea7be252aa239136060941d58a
 */
void chasles_natural_rate_matrix(const double e[3], double phi, double N[12])
{
    const double N9 = e[0];
    const double N10 = e[1];
    const double N11 = e[2];
    const double t1 = 2.0 * (1.0 - cos(phi));
    const double t2 = (t1 == 0.0 ? 0.0 : sin(phi)) / t1;
    const double t3 = N9 * t2;
    const double t4 = N10 * t2;
    const double t5 = N10 * t3;
    const double t6 = N11 * t3;
    const double t7 = N11 * t4;
    const double N0 = t2 - N9 * t3;
    const double N4 = t2 - N10 * t4;
    const double N8 = t2 - N11 * (N11 * t2);
    const double half_N9 = 0.5 * N9;
    const double half_N10 = 0.5 * N10;
    const double half_N11 = 0.5 * N11;
    const double N1 = half_N11 - t5;
    const double N2 = -(t6 + half_N10);
    const double N3 = -(t5 + half_N11);
    const double N5 = half_N9 - t7;
    const double N6 = half_N10 - t6;
    const double N7 = -(t7 + half_N9);
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
 *   26 operations; derivation sha256 d1afff56486caa901f40463bd6490da7f0e507ea7be252aa239136060941d58a
 */
void chasles_natural_rate_matrixf(const float e[3], float phi, float N[12])
{
    const float N9 = e[0];
    const float N10 = e[1];
    const float N11 = e[2];
    const float t1 = 2.0f * (1.0f - cosf(phi));
    const float t2 = (t1 == 0.0f ? 0.0f : sinf(phi)) / t1;
    const float t3 = N9 * t2;
    const float t4 = N10 * t2;
    const float t5 = N10 * t3;
    const float t6 = N11 * t3;
    const float t7 = N11 * t4;
    const float N0 = t2 - N9 * t3;
    const float N4 = t2 - N10 * t4;
    const float N8 = t2 - N11 * (N11 * t2);
    const float half_N9 = 0.5f * N9;
    const float half_N10 = 0.5f * N10;
    const float half_N11 = 0.5f * N11;
    const float N1 = half_N11 - t5;
    const float N2 = -(t6 + half_N10);
    const float N3 = -(t5 + half_N11);
    const float N5 = half_N9 - t7;
    const float N6 = half_N10 - t6;
    const float N7 = -(t7 + half_N9);
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
 *   26 operations; derivation sha256 d1afff56486caa901f40463bd6490da7f0e507ea7be252aa239136060941d58a
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
 *   26 operations; derivation sha256 d1afff56486caa901f40463bd6490da7f0e507ea7be252aa239136060941d58a
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
 *   operations  39: 6 add, 8 subtract, 23 multiply, 1 sine, 1 cosine
 *   derivation  sha256 3932af0d951f36376775451ce3a1ee43e73ece9dbe47180b18d5645998d83d28
 */
void chasles_linear_rate_matrix(const double e[3], double phi, double L[12])
{
    const double cos_phi = cos(phi);
    const double t1 = 1.0 - cos_phi;
    const double sin_phi = sin(phi);
    const double t2 = t1 * (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) + 3.0 * cos_phi - cos_phi;
    const double half_t2 = 0.5 * t2;
    const double half_t1 = 0.5 * t1;
    const double half_sin_phi = 0.5 * sin_phi;
    const double t3 = e[0] * half_t1;
    const double t4 = e[1] * half_t1;
    const double t5 = e[1] * t3;
    const double t6 = e[2] * t3;
    const double t7 = e[2] * t4;
    const double L0 = half_t2 - e[0] * t3;
    const double L4 = half_t2 - e[1] * t4;
    const double L8 = half_t2 - e[2] * (e[2] * half_t1);
    const double t8 = e[0] * half_sin_phi;
    const double t9 = e[1] * half_sin_phi;
    const double t10 = e[2] * half_sin_phi;
    const double L1 = t10 - t5;
    const double L2 = -(t6 + t9);
    const double L3 = -(t5 + t10);
    const double L5 = t8 - t7;
    const double L6 = t9 - t6;
    const double L7 = -(t7 + t8);
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
 *   39 operations; derivation sha256 3932af0d951f36376775451ce3a1ee43e73ece9dbe47180b18d5645998d83d28
 */
void chasles_linear_rate_matrixf(const float e[3], float phi, float L[12])
{
    const float cos_phi = cosf(phi);
    const float t1 = 1.0f - cos_phi;
    const float sin_phi = sinf(phi);
    const float t2 = t1 * (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) + 3.0f * cos_phi;
    const float t3 = 0.5f * (t2 - cos_phi);
    const float half_t1 = 0.5f * t1;
    const float half_sin_phi = 0.5f * sin_phi;
    const float t4 = e[0] * half_t1;
    const float t5 = e[1] * half_t1;
    const float t6 = e[1] * t4;
    const float t7 = e[2] * t4;
    const float t8 = e[2] * t5;
    const float L0 = t3 - e[0] * t4;
    const float L4 = t3 - e[1] * t5;
    const float L8 = t3 - e[2] * (e[2] * half_t1);
    const float t9 = e[0] * half_sin_phi;
    const float t10 = e[1] * half_sin_phi;
    const float t11 = e[2] * half_sin_phi;
    const float L1 = t11 - t6;
    const float L2 = -(t7 + t10);
    const float L3 = -(t6 + t11);
    const float L5 = t9 - t8;
    const float L6 = t10 - t7;
    const float L7 = -(t8 + t9);
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
 *   39 operations; derivation sha256 3932af0d951f36376775451ce3a1ee43e73ece9dbe47180b18d5645998d83d28
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
 *   39 operations; derivation sha256 3932af0d951f36376775451ce3a1ee43e73ece9dbe47180b18d5645998d83d28
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
 *   derivation  sha256 3a735e68dbe0a8f64cc814f18a0e5c5ed23fe697bfaae80247e65c806f072dee
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
 *   8 operations; derivation sha256 3a735e68dbe0a8f64cc814f18a0e5c5ed23fe697bfaae80247e65c806f072dee
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
 *   8 operations; derivation sha256 3a735e68dbe0a8f64cc814f18a0e5c5ed23fe697bfaae80247e65c806f072dee
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
 *   8 operations; derivation sha256 3a735e68dbe0a8f64cc814f18a0e5c5ed23fe697bfaae80247e65c806f072dee
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
 *   operations  20: 7 add, 3 subtract, 9 multiply, 1 divide
 *   derivation  sha256 6c875acb2742adb076485e3b75a69754af3515e24d15f1d3ff9dfbcee252fa0e
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
 *   20 operations; derivation sha256 6c875acb2742adb076485e3b75a69754af3515e24d15f1d3ff9dfbcee252fa0e
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
 *   20 operations; derivation sha256 6c875acb2742adb076485e3b75a69754af3515e24d15f1d3ff9dfbcee252fa0e
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
 *   20 operations; derivation sha256 6c875acb2742adb076485e3b75a69754af3515e24d15f1d3ff9dfbcee252fa0e
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
 *   operations  29: 8 add, 4 subtract, 17 multiply
 *   derivation  sha256 935e22e6e2702e8b1869ebd21a1a148db28b5400c4d4ba7831d8fae8467c7712
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
 *   29 operations; derivation sha256 935e22e6e2702e8b1869ebd21a1a148db28b5400c4d4ba7831d8fae8467c7712
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
 *   29 operations; derivation sha256 935e22e6e2702e8b1869ebd21a1a148db28b5400c4d4ba7831d8fae8467c7712
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
 *   29 operations; derivation sha256 935e22e6e2702e8b1869ebd21a1a148db28b5400c4d4ba7831d8fae8467c7712
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
 *   operations  10: 2 add, 4 subtract, 4 multiply
 *   derivation  sha256 33d342698b1bbb0ed8e2b1fc28a50f559e7edf4004942693b00b69e15c4fa640
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
 *   10 operations; derivation sha256 33d342698b1bbb0ed8e2b1fc28a50f559e7edf4004942693b00b69e15c4fa640
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
 *   10 operations; derivation sha256 33d342698b1bbb0ed8e2b1fc28a50f559e7edf4004942693b00b69e15c4fa640
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
 *   10 operations; derivation sha256 33d342698b1bbb0ed8e2b1fc28a50f559e7edf4004942693b00b69e15c4fa640
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
 *   operations  67: 21 add, 10 subtract, 25 multiply, 5 divide, 5 square root, 1 arctangent2
 *   derivation  sha256 693fae184fbad785f6c958322a55a428d4d2cf957b5b1ec9d427d14171059dc1
 */
void chasles_natural_invariants(const double Q[9], double e[3], double *phi)
{
    const double t1 = Q[2] + Q[6];
    const double t2 = Q[5] + Q[7];
    const double t3 = Q[8] + (Q[0] + Q[4]);
    const double t4 = 1.0 + 2.0 * Q[8] - t3;
    const double t5 = t1 * t1;
    const double t6 = t2 * t2;
    const double t7 = t5 + t6 + t4 * t4;
    const double t8 = Q[1] + Q[3];
    const double t9 = 1.0 + 2.0 * Q[4] - t3;
    const double t10 = t8 * t8;
    const double t11 = t6 + (t10 + t9 * t9);
    const double t12 = Q[7] - Q[5];
    const double t13 = Q[2] - Q[6];
    const double t14 = Q[3] - Q[1];
    const double t15 = t13 * t13;
    const double t16 = t11 + t15;
    const double t17 = t14 * t14;
    const double t18 = t7 + t17;
    const int t19 = t16 < t18;
    const double t20 = t19 ? t1 : t8;
    const double t21 = t19 ? t7 : t11;
    const double t22 = t19 ? t2 : t9;
    const double t23 = t19 ? t4 : t2;
    const double t24 = 1.0 + 2.0 * Q[0] - t3;
    const double t25 = t5 + (t10 + t24 * t24);
    const double t26 = t12 * t12;
    const double t27 = t25 + t26;
    const int t28 = t27 < t18;
    const int t29 = t27 < t16;
    const double t30 = t29 ? t20 : (t28 ? t20 : t24);
    const double t31 = t29 ? t21 : (t28 ? t21 : t25);
    const double t32 = t29 ? t22 : (t28 ? t22 : t8);
    const double t33 = t29 ? t23 : (t28 ? t23 : t1);
    const double t34 = t17 + (t15 + t26);
    const double t35 = 1.0 + t3;
    const double t36 = t35 * t35;
    const double t37 = t34 + t36;
    const int t38 = t37 < t18;
    const int t39 = t37 < t16;
    const int t40 = t37 < t27;
    const double t41 = t40 ? t31 : (t39 ? t31 : (t38 ? t31 : t34));
    const double t42 = sqrt(t41);
    const int t43 = t41 == 0.0;
    const double t44 = (t43 ? 0.0 : (t40 ? t30 : (t39 ? t30 : (t38 ? t30 : t12)))) / t42;
    const double t45 = (t43 ? 0.0 : (t40 ? t32 : (t39 ? t32 : (t38 ? t32 : t13)))) / t42;
    const double t46 = (t43 ? 0.0 : (t40 ? t33 : (t39 ? t33 : (t38 ? t33 : t14)))) / t42;
    const double t47 = t19 ? t17 - t7 : t15 - t11;
    const double t48 = t19 ? t18 : t16;
    const double t49 = t29 ? t47 : (t28 ? t47 : t26 - t25);
    const double t50 = t29 ? t48 : (t28 ? t48 : t27);
    const double t51 = t40 ? t50 : (t39 ? t50 : (t38 ? t50 : t37));
    const int t52 = t51 == 0.0;
    const double t53 = t19 ? sqrt(t7) * (2.0 * t14) : sqrt(t11) * (2.0 * t13);
    const double t54 = t29 ? t53 : (t28 ? t53 : sqrt(t25) * (2.0 * t12));
    const double t55 = t40 ? t54 : (t39 ? t54 : (t38 ? t54 : sqrt(t34) * (2.0 * t35)));
    const double t56 = (t52 ? 0.0 : t55) / t51;
    const double t57 = t45 < 0.0 ? -1.0 : (0.0 < t45 ? 1.0 : (t46 < 0.0 ? -1.0 : 1.0));
    const double t58 = 0.0 < t56 ? 1.0 : (t44 < 0.0 ? -1.0 : (0.0 < t44 ? 1.0 : t57));
    const double t59 = t56 < 0.0 ? -1.0 : t58;
    const double e0 = t44 * t59;
    const double e1 = t45 * t59;
    const double e2 = t46 * t59;
    const double t60 = (t52 ? 0.0 : (t40 ? t49 : (t39 ? t49 : (t38 ? t49 : t36 - t34)))) / t51;
    const double phi_value = atan2(t56 * t59, t60);
    e[0] = e0;
    e[1] = e1;
    e[2] = e2;
    *phi = phi_value;
}

/*
 * text 3.4.2 h chasles_natural_invariants in single precision.
 *   verdict: holds under; assumes Q is a rotation
 *   67 operations; derivation sha256 693fae184fbad785f6c958322a55a428d4d2cf957b5b1ec9d427d14171059dc1
 */
void chasles_natural_invariantsf(const float Q[9], float e[3], float *phi)
{
    const float t1 = Q[2] + Q[6];
    const float t2 = Q[5] + Q[7];
    const float t3 = Q[8] + (Q[0] + Q[4]);
    const float t4 = 1.0f + 2.0f * Q[8] - t3;
    const float t5 = t1 * t1;
    const float t6 = t2 * t2;
    const float t7 = t5 + t6 + t4 * t4;
    const float t8 = Q[1] + Q[3];
    const float t9 = 1.0f + 2.0f * Q[4] - t3;
    const float t10 = t8 * t8;
    const float t11 = t6 + (t10 + t9 * t9);
    const float t12 = Q[7] - Q[5];
    const float t13 = Q[2] - Q[6];
    const float t14 = Q[3] - Q[1];
    const float t15 = t13 * t13;
    const float t16 = t11 + t15;
    const float t17 = t14 * t14;
    const float t18 = t7 + t17;
    const int t19 = t16 < t18;
    const float t20 = t19 ? t1 : t8;
    const float t21 = t19 ? t7 : t11;
    const float t22 = t19 ? t2 : t9;
    const float t23 = t19 ? t4 : t2;
    const float t24 = 1.0f + 2.0f * Q[0] - t3;
    const float t25 = t5 + (t10 + t24 * t24);
    const float t26 = t12 * t12;
    const float t27 = t25 + t26;
    const int t28 = t27 < t18;
    const int t29 = t27 < t16;
    const float t30 = t29 ? t20 : (t28 ? t20 : t24);
    const float t31 = t29 ? t21 : (t28 ? t21 : t25);
    const float t32 = t29 ? t22 : (t28 ? t22 : t8);
    const float t33 = t29 ? t23 : (t28 ? t23 : t1);
    const float t34 = t17 + (t15 + t26);
    const float t35 = 1.0f + t3;
    const float t36 = t35 * t35;
    const float t37 = t34 + t36;
    const int t38 = t37 < t18;
    const int t39 = t37 < t16;
    const int t40 = t37 < t27;
    const float t41 = t40 ? t31 : (t39 ? t31 : (t38 ? t31 : t34));
    const float t42 = sqrtf(t41);
    const int t43 = t41 == 0.0f;
    const float t44 = (t43 ? 0.0f : (t40 ? t30 : (t39 ? t30 : (t38 ? t30 : t12)))) / t42;
    const float t45 = (t43 ? 0.0f : (t40 ? t32 : (t39 ? t32 : (t38 ? t32 : t13)))) / t42;
    const float t46 = (t43 ? 0.0f : (t40 ? t33 : (t39 ? t33 : (t38 ? t33 : t14)))) / t42;
    const float t47 = t19 ? t17 - t7 : t15 - t11;
    const float t48 = t19 ? t18 : t16;
    const float t49 = t29 ? t47 : (t28 ? t47 : t26 - t25);
    const float t50 = t29 ? t48 : (t28 ? t48 : t27);
    const float t51 = t40 ? t50 : (t39 ? t50 : (t38 ? t50 : t37));
    const int t52 = t51 == 0.0f;
    const float t53 = t19 ? sqrtf(t7) * (2.0f * t14) : sqrtf(t11) * (2.0f * t13);
    const float t54 = t29 ? t53 : (t28 ? t53 : sqrtf(t25) * (2.0f * t12));
    const float t55 = t40 ? t54 : (t39 ? t54 : (t38 ? t54 : sqrtf(t34) * (2.0f * t35)));
    const float t56 = (t52 ? 0.0f : t55) / t51;
    const float t57 = t45 < 0.0f ? -1.0f : (0.0f < t45 ? 1.0f : (t46 < 0.0f ? -1.0f : 1.0f));
    const float t58 = 0.0f < t56 ? 1.0f : (t44 < 0.0f ? -1.0f : (0.0f < t44 ? 1.0f : t57));
    const float t59 = t56 < 0.0f ? -1.0f : t58;
    const float e0 = t44 * t59;
    const float e1 = t45 * t59;
    const float e2 = t46 * t59;
    const float t60 = (t52 ? 0.0f : (t40 ? t49 : (t39 ? t49 : (t38 ? t49 : t36 - t34)))) / t51;
    const float phi_value = atan2f(t56 * t59, t60);
    e[0] = e0;
    e[1] = e1;
    e[2] = e2;
    *phi = phi_value;
}

/*
 * text 3.4.2 h chasles_natural_invariants for a batch.
 *   verdict: holds under; assumes Q is a rotation
 *   67 operations; derivation sha256 693fae184fbad785f6c958322a55a428d4d2cf957b5b1ec9d427d14171059dc1
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
 *   verdict: holds under; assumes Q is a rotation
 *   67 operations; derivation sha256 693fae184fbad785f6c958322a55a428d4d2cf957b5b1ec9d427d14171059dc1
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
 *   operations  49: 21 add, 6 subtract, 17 multiply, 4 divide, 1 square root
 *   derivation  sha256 c66522bc1222984921739ab7850dccccbf8fbbe1d8486421a7f4d56f7e8f0ed6
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
    const double t47 = t44 < 0.0 ? -1.0 : t46;
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
 *   49 operations; derivation sha256 c66522bc1222984921739ab7850dccccbf8fbbe1d8486421a7f4d56f7e8f0ed6
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
    const float t47 = t44 < 0.0f ? -1.0f : t46;
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
 *   49 operations; derivation sha256 c66522bc1222984921739ab7850dccccbf8fbbe1d8486421a7f4d56f7e8f0ed6
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
 *   49 operations; derivation sha256 c66522bc1222984921739ab7850dccccbf8fbbe1d8486421a7f4d56f7e8f0ed6
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
 *   operations  125: 35 add, 23 subtract, 53 multiply, 8 divide, 5 square root, 1 arctangent2
 *   derivation  sha256 a921b326d86915c9921f28097282bb77dc3c75a0d6f0e7c5e31e928ffc828a06
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
    const double t7 = t5 + t6 + t4 * t4;
    const double t8 = Q[1] + Q[3];
    const double t9 = 1.0 + 2.0 * Q[4] - t3;
    const double t10 = t8 * t8;
    const double t11 = t6 + (t10 + t9 * t9);
    const double t12 = Q[7] - Q[5];
    const double t13 = Q[2] - Q[6];
    const double t14 = Q[3] - Q[1];
    const double t15 = t13 * t13;
    const double t16 = t11 + t15;
    const double t17 = t14 * t14;
    const double t18 = t7 + t17;
    const int t19 = t16 < t18;
    const double t20 = t19 ? t1 : t8;
    const double t21 = t19 ? t7 : t11;
    const double t22 = t19 ? t2 : t9;
    const double t23 = t19 ? t4 : t2;
    const double t24 = 1.0 + 2.0 * Q[0] - t3;
    const double t25 = t5 + (t10 + t24 * t24);
    const double t26 = t12 * t12;
    const double t27 = t25 + t26;
    const int t28 = t27 < t18;
    const int t29 = t27 < t16;
    const double t30 = t29 ? t20 : (t28 ? t20 : t24);
    const double t31 = t29 ? t21 : (t28 ? t21 : t25);
    const double t32 = t29 ? t22 : (t28 ? t22 : t8);
    const double t33 = t29 ? t23 : (t28 ? t23 : t1);
    const double t34 = t17 + (t15 + t26);
    const double t35 = 1.0 + t3;
    const double t36 = t35 * t35;
    const double t37 = t34 + t36;
    const int t38 = t37 < t18;
    const int t39 = t37 < t16;
    const int t40 = t37 < t27;
    const double t41 = t40 ? t31 : (t39 ? t31 : (t38 ? t31 : t34));
    const double t42 = sqrt(t41);
    const int t43 = t41 == 0.0;
    const double t44 = (t43 ? 0.0 : (t40 ? t30 : (t39 ? t30 : (t38 ? t30 : t12)))) / t42;
    const double t45 = (t43 ? 0.0 : (t40 ? t32 : (t39 ? t32 : (t38 ? t32 : t13)))) / t42;
    const double t46 = (t43 ? 0.0 : (t40 ? t33 : (t39 ? t33 : (t38 ? t33 : t14)))) / t42;
    const double t47 = t19 ? t17 - t7 : t15 - t11;
    const double t48 = t19 ? t18 : t16;
    const double t49 = t29 ? t47 : (t28 ? t47 : t26 - t25);
    const double t50 = t29 ? t48 : (t28 ? t48 : t27);
    const double t51 = t40 ? t50 : (t39 ? t50 : (t38 ? t50 : t37));
    const int t52 = t51 == 0.0;
    const double t53 = (t52 ? 0.0 : (t40 ? t49 : (t39 ? t49 : (t38 ? t49 : t36 - t34)))) / t51;
    const double t54 = t19 ? sqrt(t7) * (2.0 * t14) : sqrt(t11) * (2.0 * t13);
    const double t55 = t29 ? t54 : (t28 ? t54 : sqrt(t25) * (2.0 * t12));
    const double t56 = t40 ? t55 : (t39 ? t55 : (t38 ? t55 : sqrt(t34) * (2.0 * t35)));
    const double t57 = (t52 ? 0.0 : t56) / t51;
    const double t58 = t45 < 0.0 ? -1.0 : (0.0 < t45 ? 1.0 : (t46 < 0.0 ? -1.0 : 1.0));
    const double t59 = 0.0 < t57 ? 1.0 : (t44 < 0.0 ? -1.0 : (0.0 < t44 ? 1.0 : t58));
    const double t60 = t57 < 0.0 ? -1.0 : t59;
    const double axis0 = t44 * t60;
    const double axis1 = t45 * t60;
    const double axis2 = t46 * t60;
    const double t61 = 2.0 * (1.0 - t53);
    const double t62 = Q[0] * a[0] + Q[1] * a[1] + Q[2] * a[2] - a_prime[0];
    const double t63 = Q[3] * a[0] + Q[4] * a[1] + Q[5] * a[2] - a_prime[1];
    const double t64 = Q[6] * a[0] + Q[7] * a[1] + Q[8] * a[2] - a_prime[2];
    const int t65 = t61 == 0.0;
    const double t66 = (t65 ? 0.0 : Q[0] * t62 + Q[3] * t63 + Q[6] * t64 - t62) / t61;
    const double t67 = (t65 ? 0.0 : Q[1] * t62 + Q[4] * t63 + Q[7] * t64 - t63) / t61;
    const double t68 = (t65 ? 0.0 : Q[2] * t62 + Q[5] * t63 + Q[8] * t64 - t64) / t61;
    const double axis3 = axis2 * t67 - axis1 * t68;
    const double axis4 = axis0 * t68 - axis2 * t66;
    const double axis5 = axis1 * t66 - axis0 * t67;
    const double t69 = axis0 * (a_prime[0] - a[0]) + axis1 * (a_prime[1] - a[1]);
    const double d_0_value = t69 + axis2 * (a_prime[2] - a[2]);
    const double phi_value = atan2(t57 * t60, t53);
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
 *   verdict: holds under; assumes Q is a rotation
 *   125 operations; derivation sha256 a921b326d86915c9921f28097282bb77dc3c75a0d6f0e7c5e31e928ffc828a06
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
    const float t7 = t5 + t6 + t4 * t4;
    const float t8 = Q[1] + Q[3];
    const float t9 = 1.0f + 2.0f * Q[4] - t3;
    const float t10 = t8 * t8;
    const float t11 = t6 + (t10 + t9 * t9);
    const float t12 = Q[7] - Q[5];
    const float t13 = Q[2] - Q[6];
    const float t14 = Q[3] - Q[1];
    const float t15 = t13 * t13;
    const float t16 = t11 + t15;
    const float t17 = t14 * t14;
    const float t18 = t7 + t17;
    const int t19 = t16 < t18;
    const float t20 = t19 ? t1 : t8;
    const float t21 = t19 ? t7 : t11;
    const float t22 = t19 ? t2 : t9;
    const float t23 = t19 ? t4 : t2;
    const float t24 = 1.0f + 2.0f * Q[0] - t3;
    const float t25 = t5 + (t10 + t24 * t24);
    const float t26 = t12 * t12;
    const float t27 = t25 + t26;
    const int t28 = t27 < t18;
    const int t29 = t27 < t16;
    const float t30 = t29 ? t20 : (t28 ? t20 : t24);
    const float t31 = t29 ? t21 : (t28 ? t21 : t25);
    const float t32 = t29 ? t22 : (t28 ? t22 : t8);
    const float t33 = t29 ? t23 : (t28 ? t23 : t1);
    const float t34 = t17 + (t15 + t26);
    const float t35 = 1.0f + t3;
    const float t36 = t35 * t35;
    const float t37 = t34 + t36;
    const int t38 = t37 < t18;
    const int t39 = t37 < t16;
    const int t40 = t37 < t27;
    const float t41 = t40 ? t31 : (t39 ? t31 : (t38 ? t31 : t34));
    const float t42 = sqrtf(t41);
    const int t43 = t41 == 0.0f;
    const float t44 = (t43 ? 0.0f : (t40 ? t30 : (t39 ? t30 : (t38 ? t30 : t12)))) / t42;
    const float t45 = (t43 ? 0.0f : (t40 ? t32 : (t39 ? t32 : (t38 ? t32 : t13)))) / t42;
    const float t46 = (t43 ? 0.0f : (t40 ? t33 : (t39 ? t33 : (t38 ? t33 : t14)))) / t42;
    const float t47 = t19 ? t17 - t7 : t15 - t11;
    const float t48 = t19 ? t18 : t16;
    const float t49 = t29 ? t47 : (t28 ? t47 : t26 - t25);
    const float t50 = t29 ? t48 : (t28 ? t48 : t27);
    const float t51 = t40 ? t50 : (t39 ? t50 : (t38 ? t50 : t37));
    const int t52 = t51 == 0.0f;
    const float t53 = (t52 ? 0.0f : (t40 ? t49 : (t39 ? t49 : (t38 ? t49 : t36 - t34)))) / t51;
    const float t54 = t19 ? sqrtf(t7) * (2.0f * t14) : sqrtf(t11) * (2.0f * t13);
    const float t55 = t29 ? t54 : (t28 ? t54 : sqrtf(t25) * (2.0f * t12));
    const float t56 = t40 ? t55 : (t39 ? t55 : (t38 ? t55 : sqrtf(t34) * (2.0f * t35)));
    const float t57 = (t52 ? 0.0f : t56) / t51;
    const float t58 = t45 < 0.0f ? -1.0f : (0.0f < t45 ? 1.0f : (t46 < 0.0f ? -1.0f : 1.0f));
    const float t59 = 0.0f < t57 ? 1.0f : (t44 < 0.0f ? -1.0f : (0.0f < t44 ? 1.0f : t58));
    const float t60 = t57 < 0.0f ? -1.0f : t59;
    const float axis0 = t44 * t60;
    const float axis1 = t45 * t60;
    const float axis2 = t46 * t60;
    const float t61 = 2.0f * (1.0f - t53);
    const float t62 = Q[0] * a[0] + Q[1] * a[1] + Q[2] * a[2] - a_prime[0];
    const float t63 = Q[3] * a[0] + Q[4] * a[1] + Q[5] * a[2] - a_prime[1];
    const float t64 = Q[6] * a[0] + Q[7] * a[1] + Q[8] * a[2] - a_prime[2];
    const int t65 = t61 == 0.0f;
    const float t66 = (t65 ? 0.0f : Q[0] * t62 + Q[3] * t63 + Q[6] * t64 - t62) / t61;
    const float t67 = (t65 ? 0.0f : Q[1] * t62 + Q[4] * t63 + Q[7] * t64 - t63) / t61;
    const float t68 = (t65 ? 0.0f : Q[2] * t62 + Q[5] * t63 + Q[8] * t64 - t64) / t61;
    const float axis3 = axis2 * t67 - axis1 * t68;
    const float axis4 = axis0 * t68 - axis2 * t66;
    const float axis5 = axis1 * t66 - axis0 * t67;
    const float t69 = axis0 * (a_prime[0] - a[0]) + axis1 * (a_prime[1] - a[1]);
    const float d_0_value = t69 + axis2 * (a_prime[2] - a[2]);
    const float phi_value = atan2f(t57 * t60, t53);
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
 *   verdict: holds under; assumes Q is a rotation
 *   125 operations; derivation sha256 a921b326d86915c9921f28097282bb77dc3c75a0d6f0e7c5e31e928ffc828a06
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
 *   verdict: holds under; assumes Q is a rotation
 *   125 operations; derivation sha256 a921b326d86915c9921f28097282bb77dc3c75a0d6f0e7c5e31e928ffc828a06
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
 *   operations  48: 4 add, 12 subtract, 24 multiply, 7 divide, 1 square root
 *   derivation  sha256 8db7e09eddaec370ad0459ae8e80d7446e066a7c7a50b64d1e58a04d14bf3409
 */
void chasles_instant_screw(
    const double omega[3],
    const double a_dot[3],
    const double a[3],
    double axis[6],
    double *pitch)
{
    const double t1 = omega[0] * omega[0] + omega[1] * omega[1] + omega[2] * omega[2];
    const double t2 = sqrt(t1);
    const int t3 = t1 == 0.0;
    const double axis0 = (t3 ? 0.0 : omega[0]) / t2;
    const double axis1 = (t3 ? 0.0 : omega[1]) / t2;
    const double axis2 = (t3 ? 0.0 : omega[2]) / t2;
    const double t4 = a_dot[0] - (omega[1] * a[2] - omega[2] * a[1]);
    const double t5 = a_dot[1] - (omega[2] * a[0] - omega[0] * a[2]);
    const double t6 = a_dot[2] - (omega[0] * a[1] - omega[1] * a[0]);
    const double t7 = (t3 ? 0.0 : omega[1] * t6 - omega[2] * t5) / t1;
    const double t8 = (t3 ? 0.0 : omega[2] * t4 - omega[0] * t6) / t1;
    const double t9 = (t3 ? 0.0 : omega[0] * t5 - omega[1] * t4) / t1;
    const double axis3 = axis2 * t8 - axis1 * t9;
    const double axis4 = axis0 * t9 - axis2 * t7;
    const double axis5 = axis1 * t7 - axis0 * t8;
    const double t10 = omega[0] * a_dot[0] + omega[1] * a_dot[1] + omega[2] * a_dot[2];
    const double pitch_value = (t3 ? 0.0 : t10) / t1;
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
 *   48 operations; derivation sha256 8db7e09eddaec370ad0459ae8e80d7446e066a7c7a50b64d1e58a04d14bf3409
 */
void chasles_instant_screwf(
    const float omega[3],
    const float a_dot[3],
    const float a[3],
    float axis[6],
    float *pitch)
{
    const float t1 = omega[0] * omega[0] + omega[1] * omega[1] + omega[2] * omega[2];
    const float t2 = sqrtf(t1);
    const int t3 = t1 == 0.0f;
    const float axis0 = (t3 ? 0.0f : omega[0]) / t2;
    const float axis1 = (t3 ? 0.0f : omega[1]) / t2;
    const float axis2 = (t3 ? 0.0f : omega[2]) / t2;
    const float t4 = a_dot[0] - (omega[1] * a[2] - omega[2] * a[1]);
    const float t5 = a_dot[1] - (omega[2] * a[0] - omega[0] * a[2]);
    const float t6 = a_dot[2] - (omega[0] * a[1] - omega[1] * a[0]);
    const float t7 = (t3 ? 0.0f : omega[1] * t6 - omega[2] * t5) / t1;
    const float t8 = (t3 ? 0.0f : omega[2] * t4 - omega[0] * t6) / t1;
    const float t9 = (t3 ? 0.0f : omega[0] * t5 - omega[1] * t4) / t1;
    const float axis3 = axis2 * t8 - axis1 * t9;
    const float axis4 = axis0 * t9 - axis2 * t7;
    const float axis5 = axis1 * t7 - axis0 * t8;
    const float t10 = omega[0] * a_dot[0] + omega[1] * a_dot[1] + omega[2] * a_dot[2];
    const float pitch_value = (t3 ? 0.0f : t10) / t1;
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
 *   48 operations; derivation sha256 8db7e09eddaec370ad0459ae8e80d7446e066a7c7a50b64d1e58a04d14bf3409
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
 *   48 operations; derivation sha256 8db7e09eddaec370ad0459ae8e80d7446e066a7c7a50b64d1e58a04d14bf3409
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
 *   derivation  sha256 4f53ceafce1dca350cbdb1d07bdf8034bfa4606e93e39373e34ca9e8e55d7ef2
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
 *   6 operations; derivation sha256 4f53ceafce1dca350cbdb1d07bdf8034bfa4606e93e39373e34ca9e8e55d7ef2
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
 *   6 operations; derivation sha256 4f53ceafce1dca350cbdb1d07bdf8034bfa4606e93e39373e34ca9e8e55d7ef2
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
 *   6 operations; derivation sha256 4f53ceafce1dca350cbdb1d07bdf8034bfa4606e93e39373e34ca9e8e55d7ef2
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
 *   operations  7: 1 add, 3 multiply, 1 divide, 1 sine, 1 cosine
 *   derivation  sha256 e678fa61f2ca614341b1b520d453177cbb36d5adbe5d7bfc71cf23d916da1626
 */
void chasles_linear_velocity_matrix(const double e[3], double phi, double L_tilde[12])
{
    const double t1 = 1.0 + cos(phi);
    const double t2 = (t1 == 0.0 ? 0.0 : sin(phi)) / t1;
    const double L_tilde9 = e[0] * t2;
    const double L_tilde2 = e[1] * t2;
    const double L_tilde4 = e[2] * t2;
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
 *   7 operations; derivation sha256 e678fa61f2ca614341b1b520d453177cbb36d5adbe5d7bfc71cf23d916da1626
 */
void chasles_linear_velocity_matrixf(const float e[3], float phi, float L_tilde[12])
{
    const float t1 = 1.0f + cosf(phi);
    const float t2 = (t1 == 0.0f ? 0.0f : sinf(phi)) / t1;
    const float L_tilde9 = e[0] * t2;
    const float L_tilde2 = e[1] * t2;
    const float L_tilde4 = e[2] * t2;
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
 *   7 operations; derivation sha256 e678fa61f2ca614341b1b520d453177cbb36d5adbe5d7bfc71cf23d916da1626
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
 *   7 operations; derivation sha256 e678fa61f2ca614341b1b520d453177cbb36d5adbe5d7bfc71cf23d916da1626
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
 *   derivation  sha256 49057ffb7954605c353481ff3155b854e23f59cd6c3eb25c530b76ce9a72408e
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
 *   8 operations; derivation sha256 49057ffb7954605c353481ff3155b854e23f59cd6c3eb25c530b76ce9a72408e
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
 *   8 operations; derivation sha256 49057ffb7954605c353481ff3155b854e23f59cd6c3eb25c530b76ce9a72408e
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
 *   8 operations; derivation sha256 49057ffb7954605c353481ff3155b854e23f59cd6c3eb25c530b76ce9a72408e
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
 *   operations  35: 2 add, 10 subtract, 20 multiply, 1 divide, 1 sine, 1 cosine
 *   derivation  sha256 a45c42e2bfaa929db67370adbe054106e4220311d7cb3f6156f04276d0320465
 */
void chasles_pose_rate_natural(const double e[3], double phi, const double t[6], double s_dot[7])
{
    const double s_dot4 = t[3];
    const double s_dot5 = t[4];
    const double s_dot6 = t[5];
    const double t1 = 2.0 * (1.0 - cos(phi));
    const double t2 = (t1 == 0.0 ? 0.0 : sin(phi)) / t1;
    const double s_dot3 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
    const double t3 = t2 * s_dot3;
    const double s_dot0 = t[0] * t2 - e[0] * t3 - 0.5 * (e[1] * t[2] - e[2] * t[1]);
    const double s_dot1 = t[1] * t2 - e[1] * t3 - 0.5 * (e[2] * t[0] - e[0] * t[2]);
    const double s_dot2 = t[2] * t2 - e[2] * t3 - 0.5 * (e[0] * t[1] - e[1] * t[0]);
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
 *   35 operations; derivation sha256 a45c42e2bfaa929db67370adbe054106e4220311d7cb3f6156f04276d0320465
 */
void chasles_pose_rate_naturalf(const float e[3], float phi, const float t[6], float s_dot[7])
{
    const float s_dot4 = t[3];
    const float s_dot5 = t[4];
    const float s_dot6 = t[5];
    const float t1 = 2.0f * (1.0f - cosf(phi));
    const float t2 = (t1 == 0.0f ? 0.0f : sinf(phi)) / t1;
    const float s_dot3 = e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
    const float t3 = t2 * s_dot3;
    const float s_dot0 = t[0] * t2 - e[0] * t3 - 0.5f * (e[1] * t[2] - e[2] * t[1]);
    const float s_dot1 = t[1] * t2 - e[1] * t3 - 0.5f * (e[2] * t[0] - e[0] * t[2]);
    const float s_dot2 = t[2] * t2 - e[2] * t3 - 0.5f * (e[0] * t[1] - e[1] * t[0]);
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
 *   35 operations; derivation sha256 a45c42e2bfaa929db67370adbe054106e4220311d7cb3f6156f04276d0320465
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
 *   35 operations; derivation sha256 a45c42e2bfaa929db67370adbe054106e4220311d7cb3f6156f04276d0320465
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
 *   operations  53: 7 add, 11 subtract, 33 multiply, 1 sine, 1 cosine
 *   derivation  sha256 4cb4ee584c4c8eabc8772f8942b039808bd844366959cb05e5013b108a6a13b3
 */
void chasles_pose_rate_linear(const double e[3], double phi, const double t[6], double s_dot[7])
{
    const double s_dot4 = t[3];
    const double s_dot5 = t[4];
    const double s_dot6 = t[5];
    const double cos_phi = cos(phi);
    const double t1 = 1.0 - cos_phi;
    const double sin_phi = sin(phi);
    const double t2 = t1 * (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) + 3.0 * cos_phi - cos_phi;
    const double half_t2 = 0.5 * t2;
    const double half_sin_phi = 0.5 * sin_phi;
    const double t3 = 0.5 * t1 * (e[0] * t[0] + e[1] * t[1] + e[2] * t[2]);
    const double s_dot0 = t[0] * half_t2 - e[0] * t3 - half_sin_phi * (e[1] * t[2] - e[2] * t[1]);
    const double s_dot1 = t[1] * half_t2 - e[1] * t3 - half_sin_phi * (e[2] * t[0] - e[0] * t[2]);
    const double s_dot2 = t[2] * half_t2 - e[2] * t3 - half_sin_phi * (e[0] * t[1] - e[1] * t[0]);
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
 *   53 operations; derivation sha256 4cb4ee584c4c8eabc8772f8942b039808bd844366959cb05e5013b108a6a13b3
 */
void chasles_pose_rate_linearf(const float e[3], float phi, const float t[6], float s_dot[7])
{
    const float s_dot4 = t[3];
    const float s_dot5 = t[4];
    const float s_dot6 = t[5];
    const float cos_phi = cosf(phi);
    const float t1 = 1.0f - cos_phi;
    const float sin_phi = sinf(phi);
    const float t2 = t1 * (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) + 3.0f * cos_phi;
    const float t3 = 0.5f * (t2 - cos_phi);
    const float half_sin_phi = 0.5f * sin_phi;
    const float t4 = 0.5f * t1 * (e[0] * t[0] + e[1] * t[1] + e[2] * t[2]);
    const float s_dot0 = t[0] * t3 - e[0] * t4 - half_sin_phi * (e[1] * t[2] - e[2] * t[1]);
    const float s_dot1 = t[1] * t3 - e[1] * t4 - half_sin_phi * (e[2] * t[0] - e[0] * t[2]);
    const float s_dot2 = t[2] * t3 - e[2] * t4 - half_sin_phi * (e[0] * t[1] - e[1] * t[0]);
    const float t5 = t[0] * (e[0] * sin_phi) + t[1] * (e[1] * sin_phi);
    const float s_dot3 = -(t5 + t[2] * (e[2] * sin_phi));
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
 *   53 operations; derivation sha256 4cb4ee584c4c8eabc8772f8942b039808bd844366959cb05e5013b108a6a13b3
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
 *   53 operations; derivation sha256 4cb4ee584c4c8eabc8772f8942b039808bd844366959cb05e5013b108a6a13b3
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
 *   derivation  sha256 ccca2d15e0eec02319f6d43a1e14916d4dc7aee6853dc302880ff46b704da961
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
 *   28 operations; derivation sha256 ccca2d15e0eec02319f6d43a1e14916d4dc7aee6853dc302880ff46b704da961
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
 *   28 operations; derivation sha256 ccca2d15e0eec02319f6d43a1e14916d4dc7aee6853dc302880ff46b704da961
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
 *   28 operations; derivation sha256 ccca2d15e0eec02319f6d43a1e14916d4dc7aee6853dc302880ff46b704da961
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
 *   derivation  sha256 e7ecc39745f5c7fe863f4574b3d7db66237826b5cd6ef5ba62078dc2f87eb979
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
 *   27 operations; derivation sha256 e7ecc39745f5c7fe863f4574b3d7db66237826b5cd6ef5ba62078dc2f87eb979
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
 *   27 operations; derivation sha256 e7ecc39745f5c7fe863f4574b3d7db66237826b5cd6ef5ba62078dc2f87eb979
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
 *   27 operations; derivation sha256 e7ecc39745f5c7fe863f4574b3d7db66237826b5cd6ef5ba62078dc2f87eb979
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
 *   operations  25: 4 add, 6 subtract, 12 multiply, 1 divide, 1 sine, 1 cosine
 *   derivation  sha256 fa1304d2c5d6753e7d389022ed11c42daecd4c9ae21809318a87cd32029de36f
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
    const double t6 = 1.0 + cos(phi);
    const double t7 = (t6 == 0.0 ? 0.0 : sin(phi)) / t6;
    const double t8 = e[0] * t7;
    const double t9 = e[1] * t7;
    const double t10 = e[2] * t7;
    const double t0 = s_dot[0] - s_dot[1] * t10 + s_dot[2] * t9 - s_dot[3] * t8;
    const double t1 = s_dot[1] + s_dot[0] * t10 - s_dot[2] * t8 - s_dot[3] * t9;
    const double t2 = s_dot[2] + (s_dot[1] * t8 - s_dot[0] * t9) - s_dot[3] * t10;
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
 *   25 operations; derivation sha256 fa1304d2c5d6753e7d389022ed11c42daecd4c9ae21809318a87cd32029de36f
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
    const float t6 = 1.0f + cosf(phi);
    const float t7 = (t6 == 0.0f ? 0.0f : sinf(phi)) / t6;
    const float t8 = e[0] * t7;
    const float t9 = e[1] * t7;
    const float t10 = e[2] * t7;
    const float t0 = s_dot[0] - s_dot[1] * t10 + s_dot[2] * t9 - s_dot[3] * t8;
    const float t1 = s_dot[1] + s_dot[0] * t10 - s_dot[2] * t8 - s_dot[3] * t9;
    const float t2 = s_dot[2] + (s_dot[1] * t8 - s_dot[0] * t9) - s_dot[3] * t10;
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
 *   25 operations; derivation sha256 fa1304d2c5d6753e7d389022ed11c42daecd4c9ae21809318a87cd32029de36f
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
 *   25 operations; derivation sha256 fa1304d2c5d6753e7d389022ed11c42daecd4c9ae21809318a87cd32029de36f
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
 *   derivation  sha256 e7f95cb1e1f8858232fa295001c353462018829181e53800500336674a222548
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
 *   29 operations; derivation sha256 e7f95cb1e1f8858232fa295001c353462018829181e53800500336674a222548
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
 *   29 operations; derivation sha256 e7f95cb1e1f8858232fa295001c353462018829181e53800500336674a222548
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
 *   29 operations; derivation sha256 e7f95cb1e1f8858232fa295001c353462018829181e53800500336674a222548
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
 *   derivation  sha256 967e7d1cf62d3815299774946eb2642eb91e46a3429c284829933f4e75e4e219
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
 *   15 operations; derivation sha256 967e7d1cf62d3815299774946eb2642eb91e46a3429c284829933f4e75e4e219
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
 *   15 operations; derivation sha256 967e7d1cf62d3815299774946eb2642eb91e46a3429c284829933f4e75e4e219
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
 *   15 operations; derivation sha256 967e7d1cf62d3815299774946eb2642eb91e46a3429c284829933f4e75e4e219
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
