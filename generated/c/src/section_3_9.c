/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* The kernels of section_3_9. Made by `chasles emit`; not to be edited by hand. */

#include <math.h>
#include <stddef.h>

#include "chasles.h"
#include "loops.h"

static const chasles_shape chasles_rotation_from_euler_xyx_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_xyx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_xyx_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_xyx_block),
};

static const chasles_shape chasles_rotation_from_euler_xyx_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_xyx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_xyx_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_xyx_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_xyx_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_xyx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_xyx_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_xyx_block),
};

static const chasles_shape chasles_euler_rate_matrix_xyx_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_xyx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_xyx_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_xyx_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_body_xyx_loop_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_xyx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_xyx_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_xyx_block),
};

static const chasles_shape chasles_euler_rate_matrix_body_xyx_loopf_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_xyx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_xyx_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_xyx_blockf),
};

static const chasles_shape chasles_euler_rates_xyx_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_xyx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_xyx_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_xyx_block),
};

static const chasles_shape chasles_euler_rates_xyx_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_xyx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_xyx_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_xyx_blockf),
};

static const chasles_shape chasles_rotation_from_euler_xyz_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_xyz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_xyz_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_xyz_block),
};

static const chasles_shape chasles_rotation_from_euler_xyz_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_xyz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_xyz_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_xyz_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_xyz_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_xyz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_xyz_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_xyz_block),
};

static const chasles_shape chasles_euler_rate_matrix_xyz_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_xyz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_xyz_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_xyz_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_body_xyz_loop_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_xyz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_xyz_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_xyz_block),
};

static const chasles_shape chasles_euler_rate_matrix_body_xyz_loopf_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_xyz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_xyz_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_xyz_blockf),
};

static const chasles_shape chasles_euler_rates_xyz_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_xyz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_xyz_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_xyz_block),
};

static const chasles_shape chasles_euler_rates_xyz_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_xyz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_xyz_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_xyz_blockf),
};

static const chasles_shape chasles_rotation_from_euler_xzx_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_xzx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_xzx_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_xzx_block),
};

static const chasles_shape chasles_rotation_from_euler_xzx_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_xzx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_xzx_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_xzx_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_xzx_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_xzx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_xzx_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_xzx_block),
};

static const chasles_shape chasles_euler_rate_matrix_xzx_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_xzx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_xzx_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_xzx_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_body_xzx_loop_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_xzx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_xzx_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_xzx_block),
};

static const chasles_shape chasles_euler_rate_matrix_body_xzx_loopf_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_xzx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_xzx_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_xzx_blockf),
};

static const chasles_shape chasles_euler_rates_xzx_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_xzx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_xzx_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_xzx_block),
};

static const chasles_shape chasles_euler_rates_xzx_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_xzx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_xzx_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_xzx_blockf),
};

static const chasles_shape chasles_rotation_from_euler_xzy_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_xzy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_xzy_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_xzy_block),
};

static const chasles_shape chasles_rotation_from_euler_xzy_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_xzy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_xzy_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_xzy_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_xzy_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_xzy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_xzy_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_xzy_block),
};

static const chasles_shape chasles_euler_rate_matrix_xzy_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_xzy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_xzy_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_xzy_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_body_xzy_loop_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_xzy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_xzy_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_xzy_block),
};

static const chasles_shape chasles_euler_rate_matrix_body_xzy_loopf_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_xzy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_xzy_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_xzy_blockf),
};

static const chasles_shape chasles_euler_rates_xzy_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_xzy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_xzy_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_xzy_block),
};

static const chasles_shape chasles_euler_rates_xzy_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_xzy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_xzy_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_xzy_blockf),
};

static const chasles_shape chasles_rotation_from_euler_yxy_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_yxy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_yxy_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_yxy_block),
};

static const chasles_shape chasles_rotation_from_euler_yxy_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_yxy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_yxy_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_yxy_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_yxy_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_yxy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_yxy_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_yxy_block),
};

static const chasles_shape chasles_euler_rate_matrix_yxy_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_yxy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_yxy_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_yxy_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_body_yxy_loop_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_yxy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_yxy_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_yxy_block),
};

static const chasles_shape chasles_euler_rate_matrix_body_yxy_loopf_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_yxy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_yxy_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_yxy_blockf),
};

static const chasles_shape chasles_euler_rates_yxy_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_yxy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_yxy_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_yxy_block),
};

static const chasles_shape chasles_euler_rates_yxy_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_yxy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_yxy_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_yxy_blockf),
};

static const chasles_shape chasles_rotation_from_euler_yxz_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_yxz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_yxz_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_yxz_block),
};

static const chasles_shape chasles_rotation_from_euler_yxz_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_yxz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_yxz_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_yxz_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_yxz_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_yxz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_yxz_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_yxz_block),
};

static const chasles_shape chasles_euler_rate_matrix_yxz_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_yxz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_yxz_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_yxz_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_body_yxz_loop_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_yxz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_yxz_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_yxz_block),
};

static const chasles_shape chasles_euler_rate_matrix_body_yxz_loopf_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_yxz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_yxz_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_yxz_blockf),
};

static const chasles_shape chasles_euler_rates_yxz_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_yxz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_yxz_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_yxz_block),
};

static const chasles_shape chasles_euler_rates_yxz_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_yxz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_yxz_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_yxz_blockf),
};

static const chasles_shape chasles_rotation_from_euler_yzx_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_yzx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_yzx_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_yzx_block),
};

static const chasles_shape chasles_rotation_from_euler_yzx_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_yzx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_yzx_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_yzx_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_yzx_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_yzx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_yzx_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_yzx_block),
};

static const chasles_shape chasles_euler_rate_matrix_yzx_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_yzx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_yzx_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_yzx_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_body_yzx_loop_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_yzx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_yzx_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_yzx_block),
};

static const chasles_shape chasles_euler_rate_matrix_body_yzx_loopf_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_yzx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_yzx_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_yzx_blockf),
};

static const chasles_shape chasles_euler_rates_yzx_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_yzx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_yzx_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_yzx_block),
};

static const chasles_shape chasles_euler_rates_yzx_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_yzx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_yzx_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_yzx_blockf),
};

static const chasles_shape chasles_rotation_from_euler_yzy_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_yzy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_yzy_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_yzy_block),
};

static const chasles_shape chasles_rotation_from_euler_yzy_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_yzy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_yzy_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_yzy_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_yzy_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_yzy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_yzy_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_yzy_block),
};

static const chasles_shape chasles_euler_rate_matrix_yzy_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_yzy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_yzy_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_yzy_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_body_yzy_loop_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_yzy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_yzy_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_yzy_block),
};

static const chasles_shape chasles_euler_rate_matrix_body_yzy_loopf_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_yzy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_yzy_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_yzy_blockf),
};

static const chasles_shape chasles_euler_rates_yzy_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_yzy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_yzy_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_yzy_block),
};

static const chasles_shape chasles_euler_rates_yzy_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_yzy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_yzy_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_yzy_blockf),
};

static const chasles_shape chasles_rotation_from_euler_zxy_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_zxy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_zxy_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_zxy_block),
};

static const chasles_shape chasles_rotation_from_euler_zxy_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_zxy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_zxy_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_zxy_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_zxy_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_zxy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_zxy_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_zxy_block),
};

static const chasles_shape chasles_euler_rate_matrix_zxy_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_zxy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_zxy_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_zxy_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_body_zxy_loop_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_zxy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_zxy_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_zxy_block),
};

static const chasles_shape chasles_euler_rate_matrix_body_zxy_loopf_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_zxy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_zxy_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_zxy_blockf),
};

static const chasles_shape chasles_euler_rates_zxy_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_zxy_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_zxy_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_zxy_block),
};

static const chasles_shape chasles_euler_rates_zxy_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_zxy_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_zxy_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_zxy_blockf),
};

static const chasles_shape chasles_rotation_from_euler_zxz_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_zxz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_zxz_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_zxz_block),
};

static const chasles_shape chasles_rotation_from_euler_zxz_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_zxz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_zxz_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_zxz_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_zxz_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_zxz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_zxz_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_zxz_block),
};

static const chasles_shape chasles_euler_rate_matrix_zxz_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_zxz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_zxz_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_zxz_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_body_zxz_loop_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_zxz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_zxz_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_zxz_block),
};

static const chasles_shape chasles_euler_rate_matrix_body_zxz_loopf_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_zxz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_zxz_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_zxz_blockf),
};

static const chasles_shape chasles_euler_rates_zxz_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_zxz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_zxz_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_zxz_block),
};

static const chasles_shape chasles_euler_rates_zxz_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_zxz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_zxz_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_zxz_blockf),
};

static const chasles_shape chasles_rotation_from_euler_zyx_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_zyx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_zyx_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_zyx_block),
};

static const chasles_shape chasles_rotation_from_euler_zyx_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_zyx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_zyx_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_zyx_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_zyx_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_zyx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_zyx_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_zyx_block),
};

static const chasles_shape chasles_euler_rate_matrix_zyx_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_zyx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_zyx_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_zyx_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_body_zyx_loop_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_zyx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_zyx_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_zyx_block),
};

static const chasles_shape chasles_euler_rate_matrix_body_zyx_loopf_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_zyx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_zyx_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_zyx_blockf),
};

static const chasles_shape chasles_euler_rates_zyx_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_zyx_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_zyx_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_zyx_block),
};

static const chasles_shape chasles_euler_rates_zyx_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_zyx_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_zyx_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_zyx_blockf),
};

static const chasles_shape chasles_rotation_from_euler_zyz_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_zyz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_zyz_loop_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_zyz_block),
};

static const chasles_shape chasles_rotation_from_euler_zyz_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_rotation_from_euler_zyz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_rotation_from_euler_zyz_loopf_shapes,
    CHASLES_BLOCKS(chasles_rotation_from_euler_zyz_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_zyz_loop_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_zyz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_zyz_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_zyz_block),
};

static const chasles_shape chasles_euler_rate_matrix_zyz_loopf_shapes[] = {{1, 1, 3}, {2, 3, 3}};
const chasles_loop chasles_euler_rate_matrix_zyz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_zyz_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_zyz_blockf),
};

static const chasles_shape chasles_euler_rate_matrix_body_zyz_loop_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_zyz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_zyz_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_zyz_block),
};

static const chasles_shape chasles_euler_rate_matrix_body_zyz_loopf_shapes[] = {
    {1, 1, 3},
    {2, 3, 3},
};
const chasles_loop chasles_euler_rate_matrix_body_zyz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    1, 2, chasles_euler_rate_matrix_body_zyz_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rate_matrix_body_zyz_blockf),
};

static const chasles_shape chasles_euler_rates_zyz_loop_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_zyz_loop = {
    sizeof(double), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_zyz_loop_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_zyz_block),
};

static const chasles_shape chasles_euler_rates_zyz_loopf_shapes[] = {
    {1, 1, 3},
    {1, 1, 3},
    {1, 1, 3},
};
const chasles_loop chasles_euler_rates_zyz_loopf = {
    sizeof(float), 0, CHASLES_BLOCK, CHASLES_GAPS,
    2, 3, chasles_euler_rates_zyz_loopf_shapes,
    CHASLES_BLOCKS(chasles_euler_rates_zyz_blockf),
};

#if !(CHASLES_VECTORS && defined(CHASLES_BLOCKS_ALONE))

/*
 * Ex 3.10 The rotation by Euler angles about x, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 49974e148b9969b7a23a303df375f906766eda03e5d7416d35c36a35c77fea06
 */
void chasles_rotation_from_euler_xyx(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double Q0 = cos(angles[1]);
    const double t3 = sin(angles[1]);
    const double Q3 = t2 * t3;
    const double t4 = t2 * Q0;
    const double Q6 = -(t1 * t3);
    const double t5 = t1 * Q0;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q1 = t3 * t7;
    const double Q2 = t3 * t6;
    const double Q4 = t1 * t6 - t4 * t7;
    const double Q5 = -(t1 * t7 + t4 * t6);
    const double Q7 = t2 * t6 + t5 * t7;
    const double Q8 = t5 * t6 - t2 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_xyx in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 49974e148b9969b7a23a303df375f906766eda03e5d7416d35c36a35c77fea06
 */
void chasles_rotation_from_euler_xyxf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float Q0 = cosf(angles[1]);
    const float t3 = sinf(angles[1]);
    const float Q3 = t2 * t3;
    const float t4 = t2 * Q0;
    const float Q6 = -(t1 * t3);
    const float t5 = t1 * Q0;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q1 = t3 * t7;
    const float Q2 = t3 * t6;
    const float Q4 = t1 * t6 - t4 * t7;
    const float Q5 = -(t1 * t7 + t4 * t6);
    const float Q7 = t2 * t6 + t5 * t7;
    const float Q8 = t5 * t6 - t2 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_xyx for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 49974e148b9969b7a23a303df375f906766eda03e5d7416d35c36a35c77fea06
 */
void chasles_rotation_from_euler_xyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_xyx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_rotation_from_euler_xyxf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 49974e148b9969b7a23a303df375f906766eda03e5d7416d35c36a35c77fea06
 */
void chasles_rotation_from_euler_xyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_xyx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 15ec222e6a4c0d4af15dcf0f4f9d944364836080f80ed845b4661afb074e1ca1
 */
void chasles_euler_rate_matrix_xyx(const double angles[3], double W[9])
{
    const double W4 = cos(angles[0]);
    const double W7 = sin(angles[0]);
    const double W2 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W5 = W7 * t1;
    const double W8 = -(W4 * t1);
    W[0] = 1.0;
    W[1] = 0.0;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xyx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 15ec222e6a4c0d4af15dcf0f4f9d944364836080f80ed845b4661afb074e1ca1
 */
void chasles_euler_rate_matrix_xyxf(const float angles[3], float W[9])
{
    const float W4 = cosf(angles[0]);
    const float W7 = sinf(angles[0]);
    const float W2 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W5 = W7 * t1;
    const float W8 = -(W4 * t1);
    W[0] = 1.0f;
    W[1] = 0.0f;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xyx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 15ec222e6a4c0d4af15dcf0f4f9d944364836080f80ed845b4661afb074e1ca1
 */
void chasles_euler_rate_matrix_xyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_xyx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xyxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 15ec222e6a4c0d4af15dcf0f4f9d944364836080f80ed845b4661afb074e1ca1
 */
void chasles_euler_rate_matrix_xyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_xyx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 cd8589089d7d47765a04b183158736b0b971b8a8d922838283fa2c2975eb5d89
 */
void chasles_euler_rate_matrix_body_xyx(const double angles[3], double W_body[9])
{
    const double W_body0 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W_body4 = cos(angles[2]);
    const double t2 = sin(angles[2]);
    const double W_body3 = t1 * t2;
    const double W_body7 = -t2;
    const double W_body6 = t1 * W_body4;
    W_body[0] = W_body0;
    W_body[1] = 0.0;
    W_body[2] = 1.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xyx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 cd8589089d7d47765a04b183158736b0b971b8a8d922838283fa2c2975eb5d89
 */
void chasles_euler_rate_matrix_body_xyxf(const float angles[3], float W_body[9])
{
    const float W_body0 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W_body4 = cosf(angles[2]);
    const float t2 = sinf(angles[2]);
    const float W_body3 = t1 * t2;
    const float W_body7 = -t2;
    const float W_body6 = t1 * W_body4;
    W_body[0] = W_body0;
    W_body[1] = 0.0f;
    W_body[2] = 1.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xyx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 cd8589089d7d47765a04b183158736b0b971b8a8d922838283fa2c2975eb5d89
 */
void chasles_euler_rate_matrix_body_xyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_xyx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xyxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 cd8589089d7d47765a04b183158736b0b971b8a8d922838283fa2c2975eb5d89
 */
void chasles_euler_rate_matrix_body_xyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_xyx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rates of Euler angles about x, y, x from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 6b432c618a3b5cb7132a0a1625419f24b2800b22e52d8f8b5202e756b67ea148
 */
void chasles_euler_rates_xyx(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[1] * t2 - omega[2] * t1) / t3;
    const double theta_dot0 = omega[0] - cos(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[1] * t1 + omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xyx in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 6b432c618a3b5cb7132a0a1625419f24b2800b22e52d8f8b5202e756b67ea148
 */
void chasles_euler_rates_xyxf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[1] * t2 - omega[2] * t1) / t3;
    const float theta_dot0 = omega[0] - cosf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[1] * t1 + omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xyx for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 6b432c618a3b5cb7132a0a1625419f24b2800b22e52d8f8b5202e756b67ea148
 */
void chasles_euler_rates_xyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_xyx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rates_xyxf for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 6b432c618a3b5cb7132a0a1625419f24b2800b22e52d8f8b5202e756b67ea148
 */
void chasles_euler_rates_xyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_xyx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rotation by Euler angles about x, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 f87af8285d9801669ca9041e726f9817a40f9c95ddf51a655b261236297c04af
 */
void chasles_rotation_from_euler_xyz(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double Q2 = sin(angles[1]);
    const double t4 = t2 * Q2;
    const double Q5 = -(t2 * t3);
    const double t5 = t1 * Q2;
    const double Q8 = t1 * t3;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q0 = t3 * t6;
    const double Q1 = -(t3 * t7);
    const double Q3 = t4 * t6 + t1 * t7;
    const double Q4 = t1 * t6 - t4 * t7;
    const double Q6 = t2 * t7 - t5 * t6;
    const double Q7 = t5 * t7 + t2 * t6;
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
 * Ex 3.10 chasles_rotation_from_euler_xyz in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 f87af8285d9801669ca9041e726f9817a40f9c95ddf51a655b261236297c04af
 */
void chasles_rotation_from_euler_xyzf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float Q2 = sinf(angles[1]);
    const float t4 = t2 * Q2;
    const float Q5 = -(t2 * t3);
    const float t5 = t1 * Q2;
    const float Q8 = t1 * t3;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q0 = t3 * t6;
    const float Q1 = -(t3 * t7);
    const float Q3 = t4 * t6 + t1 * t7;
    const float Q4 = t1 * t6 - t4 * t7;
    const float Q6 = t2 * t7 - t5 * t6;
    const float Q7 = t5 * t7 + t2 * t6;
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
 * Ex 3.10 chasles_rotation_from_euler_xyz for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 f87af8285d9801669ca9041e726f9817a40f9c95ddf51a655b261236297c04af
 */
void chasles_rotation_from_euler_xyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_xyz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_rotation_from_euler_xyzf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 f87af8285d9801669ca9041e726f9817a40f9c95ddf51a655b261236297c04af
 */
void chasles_rotation_from_euler_xyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_xyz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 1d2f362d906c9640bebb7713dd74f3809ce202cd977dff0cc4c827b77ce9d4d3
 */
void chasles_euler_rate_matrix_xyz(const double angles[3], double W[9])
{
    const double W4 = cos(angles[0]);
    const double W7 = sin(angles[0]);
    const double t1 = cos(angles[1]);
    const double W2 = sin(angles[1]);
    const double W5 = -(W7 * t1);
    const double W8 = W4 * t1;
    W[0] = 1.0;
    W[1] = 0.0;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xyz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 1d2f362d906c9640bebb7713dd74f3809ce202cd977dff0cc4c827b77ce9d4d3
 */
void chasles_euler_rate_matrix_xyzf(const float angles[3], float W[9])
{
    const float W4 = cosf(angles[0]);
    const float W7 = sinf(angles[0]);
    const float t1 = cosf(angles[1]);
    const float W2 = sinf(angles[1]);
    const float W5 = -(W7 * t1);
    const float W8 = W4 * t1;
    W[0] = 1.0f;
    W[1] = 0.0f;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xyz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 1d2f362d906c9640bebb7713dd74f3809ce202cd977dff0cc4c827b77ce9d4d3
 */
void chasles_euler_rate_matrix_xyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_xyz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xyzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 1d2f362d906c9640bebb7713dd74f3809ce202cd977dff0cc4c827b77ce9d4d3
 */
void chasles_euler_rate_matrix_xyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_xyz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 d605f1f844caa8fe73209313f2debbc7dad841db4b625533c1925d350b88b35f
 */
void chasles_euler_rate_matrix_body_xyz(const double angles[3], double W_body[9])
{
    const double t1 = cos(angles[1]);
    const double W_body6 = sin(angles[1]);
    const double W_body4 = cos(angles[2]);
    const double W_body0 = t1 * W_body4;
    const double W_body1 = sin(angles[2]);
    const double W_body3 = -(t1 * W_body1);
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = 0.0;
    W_body[8] = 1.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xyz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 d605f1f844caa8fe73209313f2debbc7dad841db4b625533c1925d350b88b35f
 */
void chasles_euler_rate_matrix_body_xyzf(const float angles[3], float W_body[9])
{
    const float t1 = cosf(angles[1]);
    const float W_body6 = sinf(angles[1]);
    const float W_body4 = cosf(angles[2]);
    const float W_body0 = t1 * W_body4;
    const float W_body1 = sinf(angles[2]);
    const float W_body3 = -(t1 * W_body1);
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = 0.0f;
    W_body[8] = 1.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xyz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 d605f1f844caa8fe73209313f2debbc7dad841db4b625533c1925d350b88b35f
 */
void chasles_euler_rate_matrix_body_xyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_xyz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xyzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 d605f1f844caa8fe73209313f2debbc7dad841db4b625533c1925d350b88b35f
 */
void chasles_euler_rate_matrix_body_xyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_xyz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rates of Euler angles about x, y, z from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 379cc15712b3f593e6a56a0586d8cb970b2c344caf9eff56d13b4aa0f2bc0fcb
 */
void chasles_euler_rates_xyz(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[2] * t1 - omega[1] * t2) / t3;
    const double theta_dot0 = omega[0] - sin(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[1] * t1 + omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xyz in single precision.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 379cc15712b3f593e6a56a0586d8cb970b2c344caf9eff56d13b4aa0f2bc0fcb
 */
void chasles_euler_rates_xyzf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[2] * t1 - omega[1] * t2) / t3;
    const float theta_dot0 = omega[0] - sinf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[1] * t1 + omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xyz for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 379cc15712b3f593e6a56a0586d8cb970b2c344caf9eff56d13b4aa0f2bc0fcb
 */
void chasles_euler_rates_xyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_xyz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rates_xyzf for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 379cc15712b3f593e6a56a0586d8cb970b2c344caf9eff56d13b4aa0f2bc0fcb
 */
void chasles_euler_rates_xyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_xyz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rotation by Euler angles about x, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 509556f6df445dd3c7fe5324e0ad671112ed8aaa27442b8973ddf4f722eb8d9b
 */
void chasles_rotation_from_euler_xzx(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double Q0 = cos(angles[1]);
    const double t3 = sin(angles[1]);
    const double Q3 = t1 * t3;
    const double t4 = t1 * Q0;
    const double Q6 = t2 * t3;
    const double t5 = t2 * Q0;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q1 = -(t3 * t6);
    const double Q2 = t3 * t7;
    const double Q4 = t4 * t6 - t2 * t7;
    const double Q5 = -(t4 * t7 + t2 * t6);
    const double Q7 = t5 * t6 + t1 * t7;
    const double Q8 = t1 * t6 - t5 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_xzx in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 509556f6df445dd3c7fe5324e0ad671112ed8aaa27442b8973ddf4f722eb8d9b
 */
void chasles_rotation_from_euler_xzxf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float Q0 = cosf(angles[1]);
    const float t3 = sinf(angles[1]);
    const float Q3 = t1 * t3;
    const float t4 = t1 * Q0;
    const float Q6 = t2 * t3;
    const float t5 = t2 * Q0;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q1 = -(t3 * t6);
    const float Q2 = t3 * t7;
    const float Q4 = t4 * t6 - t2 * t7;
    const float Q5 = -(t4 * t7 + t2 * t6);
    const float Q7 = t5 * t6 + t1 * t7;
    const float Q8 = t1 * t6 - t5 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_xzx for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 509556f6df445dd3c7fe5324e0ad671112ed8aaa27442b8973ddf4f722eb8d9b
 */
void chasles_rotation_from_euler_xzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_xzx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_rotation_from_euler_xzxf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 509556f6df445dd3c7fe5324e0ad671112ed8aaa27442b8973ddf4f722eb8d9b
 */
void chasles_rotation_from_euler_xzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_xzx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 063a79927c0f405045ca7f3a4600867811265ae8101b11b64e443152cd0965cf
 */
void chasles_euler_rate_matrix_xzx(const double angles[3], double W[9])
{
    const double W7 = cos(angles[0]);
    const double t1 = sin(angles[0]);
    const double W4 = -t1;
    const double W2 = cos(angles[1]);
    const double t2 = sin(angles[1]);
    const double W5 = W7 * t2;
    const double W8 = t1 * t2;
    W[0] = 1.0;
    W[1] = 0.0;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xzx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 063a79927c0f405045ca7f3a4600867811265ae8101b11b64e443152cd0965cf
 */
void chasles_euler_rate_matrix_xzxf(const float angles[3], float W[9])
{
    const float W7 = cosf(angles[0]);
    const float t1 = sinf(angles[0]);
    const float W4 = -t1;
    const float W2 = cosf(angles[1]);
    const float t2 = sinf(angles[1]);
    const float W5 = W7 * t2;
    const float W8 = t1 * t2;
    W[0] = 1.0f;
    W[1] = 0.0f;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xzx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 063a79927c0f405045ca7f3a4600867811265ae8101b11b64e443152cd0965cf
 */
void chasles_euler_rate_matrix_xzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_xzx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xzxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 063a79927c0f405045ca7f3a4600867811265ae8101b11b64e443152cd0965cf
 */
void chasles_euler_rate_matrix_xzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_xzx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 5092f84c7bbb66afac08e51bc82a4ea4bdc4738a19463c52fc60c25d1976c154
 */
void chasles_euler_rate_matrix_body_xzx(const double angles[3], double W_body[9])
{
    const double W_body0 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W_body7 = cos(angles[2]);
    const double W_body3 = -(t1 * W_body7);
    const double W_body4 = sin(angles[2]);
    const double W_body6 = t1 * W_body4;
    W_body[0] = W_body0;
    W_body[1] = 0.0;
    W_body[2] = 1.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xzx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 5092f84c7bbb66afac08e51bc82a4ea4bdc4738a19463c52fc60c25d1976c154
 */
void chasles_euler_rate_matrix_body_xzxf(const float angles[3], float W_body[9])
{
    const float W_body0 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W_body7 = cosf(angles[2]);
    const float W_body3 = -(t1 * W_body7);
    const float W_body4 = sinf(angles[2]);
    const float W_body6 = t1 * W_body4;
    W_body[0] = W_body0;
    W_body[1] = 0.0f;
    W_body[2] = 1.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xzx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 5092f84c7bbb66afac08e51bc82a4ea4bdc4738a19463c52fc60c25d1976c154
 */
void chasles_euler_rate_matrix_body_xzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_xzx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xzxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 5092f84c7bbb66afac08e51bc82a4ea4bdc4738a19463c52fc60c25d1976c154
 */
void chasles_euler_rate_matrix_body_xzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_xzx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rates of Euler angles about x, z, x from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 d60392e777e2f94766ccb4868d6a376f4b8f702f6466c7841c3f0e7493778009
 */
void chasles_euler_rates_xzx(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[1] * t1 + omega[2] * t2) / t3;
    const double theta_dot0 = omega[0] - cos(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[2] * t1 - omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xzx in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 d60392e777e2f94766ccb4868d6a376f4b8f702f6466c7841c3f0e7493778009
 */
void chasles_euler_rates_xzxf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[1] * t1 + omega[2] * t2) / t3;
    const float theta_dot0 = omega[0] - cosf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[2] * t1 - omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xzx for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 d60392e777e2f94766ccb4868d6a376f4b8f702f6466c7841c3f0e7493778009
 */
void chasles_euler_rates_xzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_xzx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rates_xzxf for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 d60392e777e2f94766ccb4868d6a376f4b8f702f6466c7841c3f0e7493778009
 */
void chasles_euler_rates_xzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_xzx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rotation by Euler angles about x, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   error bound 5.3 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 6a4fd734359cc43f74679d358abf691bfd6612dbcd721aa9a209c64050a5d383
 */
void chasles_rotation_from_euler_xzy(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double t4 = sin(angles[1]);
    const double Q1 = -t4;
    const double t5 = t1 * t4;
    const double Q4 = t1 * t3;
    const double t6 = t2 * t4;
    const double Q7 = t2 * t3;
    const double t7 = cos(angles[2]);
    const double t8 = sin(angles[2]);
    const double Q0 = t3 * t7;
    const double Q2 = t3 * t8;
    const double Q3 = t5 * t7 + t2 * t8;
    const double Q5 = t5 * t8 - t2 * t7;
    const double Q6 = t6 * t7 - t1 * t8;
    const double Q8 = t6 * t8 + t1 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_xzy in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 6a4fd734359cc43f74679d358abf691bfd6612dbcd721aa9a209c64050a5d383
 */
void chasles_rotation_from_euler_xzyf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float t4 = sinf(angles[1]);
    const float Q1 = -t4;
    const float t5 = t1 * t4;
    const float Q4 = t1 * t3;
    const float t6 = t2 * t4;
    const float Q7 = t2 * t3;
    const float t7 = cosf(angles[2]);
    const float t8 = sinf(angles[2]);
    const float Q0 = t3 * t7;
    const float Q2 = t3 * t8;
    const float Q3 = t5 * t7 + t2 * t8;
    const float Q5 = t5 * t8 - t2 * t7;
    const float Q6 = t6 * t7 - t1 * t8;
    const float Q8 = t6 * t8 + t1 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_xzy for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 6a4fd734359cc43f74679d358abf691bfd6612dbcd721aa9a209c64050a5d383
 */
void chasles_rotation_from_euler_xzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_xzy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_rotation_from_euler_xzyf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 6a4fd734359cc43f74679d358abf691bfd6612dbcd721aa9a209c64050a5d383
 */
void chasles_rotation_from_euler_xzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_xzy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 f4bf5edc3a0e9199cc30c83f6cab51d6bfce7ab2a3d75f59608b337bed74824b
 */
void chasles_euler_rate_matrix_xzy(const double angles[3], double W[9])
{
    const double W7 = cos(angles[0]);
    const double t1 = sin(angles[0]);
    const double W4 = -t1;
    const double t2 = cos(angles[1]);
    const double W2 = -sin(angles[1]);
    const double W5 = W7 * t2;
    const double W8 = t1 * t2;
    W[0] = 1.0;
    W[1] = 0.0;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xzy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 f4bf5edc3a0e9199cc30c83f6cab51d6bfce7ab2a3d75f59608b337bed74824b
 */
void chasles_euler_rate_matrix_xzyf(const float angles[3], float W[9])
{
    const float W7 = cosf(angles[0]);
    const float t1 = sinf(angles[0]);
    const float W4 = -t1;
    const float t2 = cosf(angles[1]);
    const float W2 = -sinf(angles[1]);
    const float W5 = W7 * t2;
    const float W8 = t1 * t2;
    W[0] = 1.0f;
    W[1] = 0.0f;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xzy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 f4bf5edc3a0e9199cc30c83f6cab51d6bfce7ab2a3d75f59608b337bed74824b
 */
void chasles_euler_rate_matrix_xzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_xzy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_xzyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 f4bf5edc3a0e9199cc30c83f6cab51d6bfce7ab2a3d75f59608b337bed74824b
 */
void chasles_euler_rate_matrix_xzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_xzy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 34b232afb99ddc1be46962d797e1c08bda20904a656a165ee2fc2232e4beec57
 */
void chasles_euler_rate_matrix_body_xzy(const double angles[3], double W_body[9])
{
    const double t1 = cos(angles[1]);
    const double W_body3 = -sin(angles[1]);
    const double W_body7 = cos(angles[2]);
    const double W_body0 = t1 * W_body7;
    const double t2 = sin(angles[2]);
    const double W_body1 = -t2;
    const double W_body6 = t1 * t2;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = 0.0;
    W_body[5] = 1.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xzy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 34b232afb99ddc1be46962d797e1c08bda20904a656a165ee2fc2232e4beec57
 */
void chasles_euler_rate_matrix_body_xzyf(const float angles[3], float W_body[9])
{
    const float t1 = cosf(angles[1]);
    const float W_body3 = -sinf(angles[1]);
    const float W_body7 = cosf(angles[2]);
    const float W_body0 = t1 * W_body7;
    const float t2 = sinf(angles[2]);
    const float W_body1 = -t2;
    const float W_body6 = t1 * t2;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = 0.0f;
    W_body[5] = 1.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xzy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 34b232afb99ddc1be46962d797e1c08bda20904a656a165ee2fc2232e4beec57
 */
void chasles_euler_rate_matrix_body_xzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_xzy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_xzyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 34b232afb99ddc1be46962d797e1c08bda20904a656a165ee2fc2232e4beec57
 */
void chasles_euler_rate_matrix_body_xzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_xzy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rates of Euler angles about x, z, y from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 47b386989c7014707637badfc0f665d8b17c2674e34c6dc85b34228d94dd802e
 */
void chasles_euler_rates_xzy(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[1] * t1 + omega[2] * t2) / t3;
    const double theta_dot0 = omega[0] + sin(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[2] * t1 - omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xzy in single precision.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 47b386989c7014707637badfc0f665d8b17c2674e34c6dc85b34228d94dd802e
 */
void chasles_euler_rates_xzyf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[1] * t1 + omega[2] * t2) / t3;
    const float theta_dot0 = omega[0] + sinf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[2] * t1 - omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_xzy for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 47b386989c7014707637badfc0f665d8b17c2674e34c6dc85b34228d94dd802e
 */
void chasles_euler_rates_xzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_xzy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rates_xzyf for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 47b386989c7014707637badfc0f665d8b17c2674e34c6dc85b34228d94dd802e
 */
void chasles_euler_rates_xzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_xzy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rotation by Euler angles about y, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 42de6926cd35f5c06da566065b065c8ba754cee65703557fa42410e42dde4a35
 */
void chasles_rotation_from_euler_yxy(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double Q4 = cos(angles[1]);
    const double t3 = sin(angles[1]);
    const double Q1 = t2 * t3;
    const double t4 = t2 * Q4;
    const double Q7 = t1 * t3;
    const double t5 = t1 * Q4;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q0 = t1 * t6 - t4 * t7;
    const double Q2 = t1 * t7 + t4 * t6;
    const double Q3 = t3 * t7;
    const double Q5 = -(t3 * t6);
    const double Q6 = -(t2 * t6 + t5 * t7);
    const double Q8 = t5 * t6 - t2 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yxy in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 42de6926cd35f5c06da566065b065c8ba754cee65703557fa42410e42dde4a35
 */
void chasles_rotation_from_euler_yxyf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float Q4 = cosf(angles[1]);
    const float t3 = sinf(angles[1]);
    const float Q1 = t2 * t3;
    const float t4 = t2 * Q4;
    const float Q7 = t1 * t3;
    const float t5 = t1 * Q4;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q0 = t1 * t6 - t4 * t7;
    const float Q2 = t1 * t7 + t4 * t6;
    const float Q3 = t3 * t7;
    const float Q5 = -(t3 * t6);
    const float Q6 = -(t2 * t6 + t5 * t7);
    const float Q8 = t5 * t6 - t2 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yxy for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 42de6926cd35f5c06da566065b065c8ba754cee65703557fa42410e42dde4a35
 */
void chasles_rotation_from_euler_yxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_yxy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_rotation_from_euler_yxyf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 42de6926cd35f5c06da566065b065c8ba754cee65703557fa42410e42dde4a35
 */
void chasles_rotation_from_euler_yxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_yxy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 ab9e4f4d487ee038942cc83869848be5fa4c534a19c656164684f27e1b65ac10
 */
void chasles_euler_rate_matrix_yxy(const double angles[3], double W[9])
{
    const double W1 = cos(angles[0]);
    const double t1 = sin(angles[0]);
    const double W7 = -t1;
    const double W5 = cos(angles[1]);
    const double t2 = sin(angles[1]);
    const double W2 = t1 * t2;
    const double W8 = W1 * t2;
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0;
    W[4] = 0.0;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yxy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 ab9e4f4d487ee038942cc83869848be5fa4c534a19c656164684f27e1b65ac10
 */
void chasles_euler_rate_matrix_yxyf(const float angles[3], float W[9])
{
    const float W1 = cosf(angles[0]);
    const float t1 = sinf(angles[0]);
    const float W7 = -t1;
    const float W5 = cosf(angles[1]);
    const float t2 = sinf(angles[1]);
    const float W2 = t1 * t2;
    const float W8 = W1 * t2;
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0f;
    W[4] = 0.0f;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yxy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 ab9e4f4d487ee038942cc83869848be5fa4c534a19c656164684f27e1b65ac10
 */
void chasles_euler_rate_matrix_yxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_yxy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yxyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 ab9e4f4d487ee038942cc83869848be5fa4c534a19c656164684f27e1b65ac10
 */
void chasles_euler_rate_matrix_yxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_yxy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 2a86c48257dda6a27e84a7fb3b0817bd24bdff1a56c2bfeb6119d778d89bbab6
 */
void chasles_euler_rate_matrix_body_yxy(const double angles[3], double W_body[9])
{
    const double W_body3 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W_body1 = cos(angles[2]);
    const double W_body7 = sin(angles[2]);
    const double W_body0 = t1 * W_body7;
    const double W_body6 = -(t1 * W_body1);
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = 0.0;
    W_body[5] = 1.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yxy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2a86c48257dda6a27e84a7fb3b0817bd24bdff1a56c2bfeb6119d778d89bbab6
 */
void chasles_euler_rate_matrix_body_yxyf(const float angles[3], float W_body[9])
{
    const float W_body3 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W_body1 = cosf(angles[2]);
    const float W_body7 = sinf(angles[2]);
    const float W_body0 = t1 * W_body7;
    const float W_body6 = -(t1 * W_body1);
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = 0.0f;
    W_body[5] = 1.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yxy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2a86c48257dda6a27e84a7fb3b0817bd24bdff1a56c2bfeb6119d778d89bbab6
 */
void chasles_euler_rate_matrix_body_yxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_yxy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yxyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2a86c48257dda6a27e84a7fb3b0817bd24bdff1a56c2bfeb6119d778d89bbab6
 */
void chasles_euler_rate_matrix_body_yxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_yxy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rates of Euler angles about y, x, y from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 8c7b412f940aadc89ad8c5ce3785c5c0ca8dcbf9e58aac6572334181799e61e2
 */
void chasles_euler_rates_yxy(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[0] * t2 + omega[2] * t1) / t3;
    const double theta_dot0 = omega[1] - cos(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[0] * t1 - omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yxy in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 8c7b412f940aadc89ad8c5ce3785c5c0ca8dcbf9e58aac6572334181799e61e2
 */
void chasles_euler_rates_yxyf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[0] * t2 + omega[2] * t1) / t3;
    const float theta_dot0 = omega[1] - cosf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[0] * t1 - omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yxy for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 8c7b412f940aadc89ad8c5ce3785c5c0ca8dcbf9e58aac6572334181799e61e2
 */
void chasles_euler_rates_yxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_yxy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rates_yxyf for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 8c7b412f940aadc89ad8c5ce3785c5c0ca8dcbf9e58aac6572334181799e61e2
 */
void chasles_euler_rates_yxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_yxy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rotation by Euler angles about y, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   error bound 5.3 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 aac4d38f938bc0f3b21fc5113a3e553f105a0b99bd2a46001cf5af56197be36a
 */
void chasles_rotation_from_euler_yxz(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double t4 = sin(angles[1]);
    const double Q5 = -t4;
    const double t5 = t2 * t4;
    const double Q2 = t2 * t3;
    const double t6 = t1 * t4;
    const double Q8 = t1 * t3;
    const double t7 = cos(angles[2]);
    const double t8 = sin(angles[2]);
    const double Q0 = t1 * t7 + t5 * t8;
    const double Q1 = t5 * t7 - t1 * t8;
    const double Q3 = t3 * t8;
    const double Q4 = t3 * t7;
    const double Q6 = t6 * t8 - t2 * t7;
    const double Q7 = t2 * t8 + t6 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yxz in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 aac4d38f938bc0f3b21fc5113a3e553f105a0b99bd2a46001cf5af56197be36a
 */
void chasles_rotation_from_euler_yxzf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float t4 = sinf(angles[1]);
    const float Q5 = -t4;
    const float t5 = t2 * t4;
    const float Q2 = t2 * t3;
    const float t6 = t1 * t4;
    const float Q8 = t1 * t3;
    const float t7 = cosf(angles[2]);
    const float t8 = sinf(angles[2]);
    const float Q0 = t1 * t7 + t5 * t8;
    const float Q1 = t5 * t7 - t1 * t8;
    const float Q3 = t3 * t8;
    const float Q4 = t3 * t7;
    const float Q6 = t6 * t8 - t2 * t7;
    const float Q7 = t2 * t8 + t6 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yxz for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 aac4d38f938bc0f3b21fc5113a3e553f105a0b99bd2a46001cf5af56197be36a
 */
void chasles_rotation_from_euler_yxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_yxz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_rotation_from_euler_yxzf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 aac4d38f938bc0f3b21fc5113a3e553f105a0b99bd2a46001cf5af56197be36a
 */
void chasles_rotation_from_euler_yxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_yxz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 f673622637ac9520cdbbfacd9038ad6a42d7de01d522fe1daa4e4ed5a188d584
 */
void chasles_euler_rate_matrix_yxz(const double angles[3], double W[9])
{
    const double W1 = cos(angles[0]);
    const double t1 = sin(angles[0]);
    const double W7 = -t1;
    const double t2 = cos(angles[1]);
    const double W5 = -sin(angles[1]);
    const double W2 = t1 * t2;
    const double W8 = W1 * t2;
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0;
    W[4] = 0.0;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yxz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 f673622637ac9520cdbbfacd9038ad6a42d7de01d522fe1daa4e4ed5a188d584
 */
void chasles_euler_rate_matrix_yxzf(const float angles[3], float W[9])
{
    const float W1 = cosf(angles[0]);
    const float t1 = sinf(angles[0]);
    const float W7 = -t1;
    const float t2 = cosf(angles[1]);
    const float W5 = -sinf(angles[1]);
    const float W2 = t1 * t2;
    const float W8 = W1 * t2;
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0f;
    W[4] = 0.0f;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yxz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 f673622637ac9520cdbbfacd9038ad6a42d7de01d522fe1daa4e4ed5a188d584
 */
void chasles_euler_rate_matrix_yxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_yxz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yxzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 f673622637ac9520cdbbfacd9038ad6a42d7de01d522fe1daa4e4ed5a188d584
 */
void chasles_euler_rate_matrix_yxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_yxz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 a7f0e1639e85f122dde538fce97f31e9e4f583cf9ea5d074345d45245ff26ea8
 */
void chasles_euler_rate_matrix_body_yxz(const double angles[3], double W_body[9])
{
    const double t1 = cos(angles[1]);
    const double W_body6 = -sin(angles[1]);
    const double W_body1 = cos(angles[2]);
    const double t2 = sin(angles[2]);
    const double W_body0 = t1 * t2;
    const double W_body4 = -t2;
    const double W_body3 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = 0.0;
    W_body[8] = 1.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yxz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 a7f0e1639e85f122dde538fce97f31e9e4f583cf9ea5d074345d45245ff26ea8
 */
void chasles_euler_rate_matrix_body_yxzf(const float angles[3], float W_body[9])
{
    const float t1 = cosf(angles[1]);
    const float W_body6 = -sinf(angles[1]);
    const float W_body1 = cosf(angles[2]);
    const float t2 = sinf(angles[2]);
    const float W_body0 = t1 * t2;
    const float W_body4 = -t2;
    const float W_body3 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = 0.0f;
    W_body[8] = 1.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yxz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 a7f0e1639e85f122dde538fce97f31e9e4f583cf9ea5d074345d45245ff26ea8
 */
void chasles_euler_rate_matrix_body_yxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_yxz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yxzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 a7f0e1639e85f122dde538fce97f31e9e4f583cf9ea5d074345d45245ff26ea8
 */
void chasles_euler_rate_matrix_body_yxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_yxz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rates of Euler angles about y, x, z from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 bf11bed82696038fa225e27a75acb0d41b63af31adb0153ca5a712167c4d8284
 */
void chasles_euler_rates_yxz(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[0] * t2 + omega[2] * t1) / t3;
    const double theta_dot0 = omega[1] + sin(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[0] * t1 - omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yxz in single precision.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 bf11bed82696038fa225e27a75acb0d41b63af31adb0153ca5a712167c4d8284
 */
void chasles_euler_rates_yxzf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[0] * t2 + omega[2] * t1) / t3;
    const float theta_dot0 = omega[1] + sinf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[0] * t1 - omega[2] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yxz for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 bf11bed82696038fa225e27a75acb0d41b63af31adb0153ca5a712167c4d8284
 */
void chasles_euler_rates_yxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_yxz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rates_yxzf for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 bf11bed82696038fa225e27a75acb0d41b63af31adb0153ca5a712167c4d8284
 */
void chasles_euler_rates_yxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_yxz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rotation by Euler angles about y, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 73ccad1507926c77a4de1804d6ccee68b6eedcb0a87a5d797076c3aaa328556a
 */
void chasles_rotation_from_euler_yzx(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double Q3 = sin(angles[1]);
    const double Q0 = t1 * t3;
    const double t4 = t1 * Q3;
    const double Q6 = -(t2 * t3);
    const double t5 = t2 * Q3;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q1 = t2 * t7 - t4 * t6;
    const double Q2 = t4 * t7 + t2 * t6;
    const double Q4 = t3 * t6;
    const double Q5 = -(t3 * t7);
    const double Q7 = t5 * t6 + t1 * t7;
    const double Q8 = t1 * t6 - t5 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yzx in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 73ccad1507926c77a4de1804d6ccee68b6eedcb0a87a5d797076c3aaa328556a
 */
void chasles_rotation_from_euler_yzxf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float Q3 = sinf(angles[1]);
    const float Q0 = t1 * t3;
    const float t4 = t1 * Q3;
    const float Q6 = -(t2 * t3);
    const float t5 = t2 * Q3;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q1 = t2 * t7 - t4 * t6;
    const float Q2 = t4 * t7 + t2 * t6;
    const float Q4 = t3 * t6;
    const float Q5 = -(t3 * t7);
    const float Q7 = t5 * t6 + t1 * t7;
    const float Q8 = t1 * t6 - t5 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yzx for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 73ccad1507926c77a4de1804d6ccee68b6eedcb0a87a5d797076c3aaa328556a
 */
void chasles_rotation_from_euler_yzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_yzx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_rotation_from_euler_yzxf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 73ccad1507926c77a4de1804d6ccee68b6eedcb0a87a5d797076c3aaa328556a
 */
void chasles_rotation_from_euler_yzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_yzx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 6bc14177fe8f581b737fd8108f75cca27c80f0c6043e24f8d305941c720fb93e
 */
void chasles_euler_rate_matrix_yzx(const double angles[3], double W[9])
{
    const double W7 = cos(angles[0]);
    const double W1 = sin(angles[0]);
    const double t1 = cos(angles[1]);
    const double W5 = sin(angles[1]);
    const double W2 = W7 * t1;
    const double W8 = -(W1 * t1);
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0;
    W[4] = 0.0;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yzx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 6bc14177fe8f581b737fd8108f75cca27c80f0c6043e24f8d305941c720fb93e
 */
void chasles_euler_rate_matrix_yzxf(const float angles[3], float W[9])
{
    const float W7 = cosf(angles[0]);
    const float W1 = sinf(angles[0]);
    const float t1 = cosf(angles[1]);
    const float W5 = sinf(angles[1]);
    const float W2 = W7 * t1;
    const float W8 = -(W1 * t1);
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0f;
    W[4] = 0.0f;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yzx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 6bc14177fe8f581b737fd8108f75cca27c80f0c6043e24f8d305941c720fb93e
 */
void chasles_euler_rate_matrix_yzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_yzx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yzxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 6bc14177fe8f581b737fd8108f75cca27c80f0c6043e24f8d305941c720fb93e
 */
void chasles_euler_rate_matrix_yzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_yzx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 ba974c498d2395f78752b5b9af3bd25c9bc8814b82f34bc12080e7f58fc39384
 */
void chasles_euler_rate_matrix_body_yzx(const double angles[3], double W_body[9])
{
    const double t1 = cos(angles[1]);
    const double W_body0 = sin(angles[1]);
    const double W_body7 = cos(angles[2]);
    const double W_body3 = t1 * W_body7;
    const double W_body4 = sin(angles[2]);
    const double W_body6 = -(t1 * W_body4);
    W_body[0] = W_body0;
    W_body[1] = 0.0;
    W_body[2] = 1.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yzx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 ba974c498d2395f78752b5b9af3bd25c9bc8814b82f34bc12080e7f58fc39384
 */
void chasles_euler_rate_matrix_body_yzxf(const float angles[3], float W_body[9])
{
    const float t1 = cosf(angles[1]);
    const float W_body0 = sinf(angles[1]);
    const float W_body7 = cosf(angles[2]);
    const float W_body3 = t1 * W_body7;
    const float W_body4 = sinf(angles[2]);
    const float W_body6 = -(t1 * W_body4);
    W_body[0] = W_body0;
    W_body[1] = 0.0f;
    W_body[2] = 1.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yzx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 ba974c498d2395f78752b5b9af3bd25c9bc8814b82f34bc12080e7f58fc39384
 */
void chasles_euler_rate_matrix_body_yzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_yzx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yzxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 ba974c498d2395f78752b5b9af3bd25c9bc8814b82f34bc12080e7f58fc39384
 */
void chasles_euler_rate_matrix_body_yzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_yzx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rates of Euler angles about y, z, x from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 404a3dd7a9f43dbf16ca707d83946fda23f95d1982dc848908ed679160d5cc5f
 */
void chasles_euler_rates_yzx(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[0] * t1 - omega[2] * t2) / t3;
    const double theta_dot0 = omega[1] - sin(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[0] * t2 + omega[2] * t1;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yzx in single precision.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 404a3dd7a9f43dbf16ca707d83946fda23f95d1982dc848908ed679160d5cc5f
 */
void chasles_euler_rates_yzxf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[0] * t1 - omega[2] * t2) / t3;
    const float theta_dot0 = omega[1] - sinf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[0] * t2 + omega[2] * t1;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yzx for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 404a3dd7a9f43dbf16ca707d83946fda23f95d1982dc848908ed679160d5cc5f
 */
void chasles_euler_rates_yzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_yzx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rates_yzxf for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 404a3dd7a9f43dbf16ca707d83946fda23f95d1982dc848908ed679160d5cc5f
 */
void chasles_euler_rates_yzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_yzx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rotation by Euler angles about y, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 fc249fbe7ecf26a2cf23c7eb4a1ae340b6f6d6b71fd0a11c005275bed3b0541a
 */
void chasles_rotation_from_euler_yzy(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double Q4 = cos(angles[1]);
    const double t3 = sin(angles[1]);
    const double t4 = t1 * Q4;
    const double Q1 = -(t1 * t3);
    const double t5 = t2 * Q4;
    const double Q7 = t2 * t3;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q0 = t4 * t6 - t2 * t7;
    const double Q2 = t4 * t7 + t2 * t6;
    const double Q3 = t3 * t6;
    const double Q5 = t3 * t7;
    const double Q6 = -(t5 * t6 + t1 * t7);
    const double Q8 = t1 * t6 - t5 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yzy in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 fc249fbe7ecf26a2cf23c7eb4a1ae340b6f6d6b71fd0a11c005275bed3b0541a
 */
void chasles_rotation_from_euler_yzyf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float Q4 = cosf(angles[1]);
    const float t3 = sinf(angles[1]);
    const float t4 = t1 * Q4;
    const float Q1 = -(t1 * t3);
    const float t5 = t2 * Q4;
    const float Q7 = t2 * t3;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q0 = t4 * t6 - t2 * t7;
    const float Q2 = t4 * t7 + t2 * t6;
    const float Q3 = t3 * t6;
    const float Q5 = t3 * t7;
    const float Q6 = -(t5 * t6 + t1 * t7);
    const float Q8 = t1 * t6 - t5 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_yzy for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 fc249fbe7ecf26a2cf23c7eb4a1ae340b6f6d6b71fd0a11c005275bed3b0541a
 */
void chasles_rotation_from_euler_yzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_yzy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_rotation_from_euler_yzyf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 fc249fbe7ecf26a2cf23c7eb4a1ae340b6f6d6b71fd0a11c005275bed3b0541a
 */
void chasles_rotation_from_euler_yzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_yzy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 ba3b9e2e5d19a42bcccf4fe889ac0ad5e1476885d7d3f35174490738c07caa93
 */
void chasles_euler_rate_matrix_yzy(const double angles[3], double W[9])
{
    const double W7 = cos(angles[0]);
    const double W1 = sin(angles[0]);
    const double W5 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W2 = -(W7 * t1);
    const double W8 = W1 * t1;
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0;
    W[4] = 0.0;
    W[5] = W5;
    W[6] = 0.0;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yzy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 ba3b9e2e5d19a42bcccf4fe889ac0ad5e1476885d7d3f35174490738c07caa93
 */
void chasles_euler_rate_matrix_yzyf(const float angles[3], float W[9])
{
    const float W7 = cosf(angles[0]);
    const float W1 = sinf(angles[0]);
    const float W5 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W2 = -(W7 * t1);
    const float W8 = W1 * t1;
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 1.0f;
    W[4] = 0.0f;
    W[5] = W5;
    W[6] = 0.0f;
    W[7] = W7;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yzy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 ba3b9e2e5d19a42bcccf4fe889ac0ad5e1476885d7d3f35174490738c07caa93
 */
void chasles_euler_rate_matrix_yzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_yzy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_yzyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 ba3b9e2e5d19a42bcccf4fe889ac0ad5e1476885d7d3f35174490738c07caa93
 */
void chasles_euler_rate_matrix_yzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_yzy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 2906ed860e470e86a10fba075e603a757d21feeb996fd012d6a5c352f1f248cf
 */
void chasles_euler_rate_matrix_body_yzy(const double angles[3], double W_body[9])
{
    const double W_body3 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W_body7 = cos(angles[2]);
    const double W_body0 = t1 * W_body7;
    const double t2 = sin(angles[2]);
    const double W_body1 = -t2;
    const double W_body6 = t1 * t2;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = 0.0;
    W_body[5] = 1.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yzy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2906ed860e470e86a10fba075e603a757d21feeb996fd012d6a5c352f1f248cf
 */
void chasles_euler_rate_matrix_body_yzyf(const float angles[3], float W_body[9])
{
    const float W_body3 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W_body7 = cosf(angles[2]);
    const float W_body0 = t1 * W_body7;
    const float t2 = sinf(angles[2]);
    const float W_body1 = -t2;
    const float W_body6 = t1 * t2;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = 0.0f;
    W_body[5] = 1.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yzy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2906ed860e470e86a10fba075e603a757d21feeb996fd012d6a5c352f1f248cf
 */
void chasles_euler_rate_matrix_body_yzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_yzy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_yzyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2906ed860e470e86a10fba075e603a757d21feeb996fd012d6a5c352f1f248cf
 */
void chasles_euler_rate_matrix_body_yzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_yzy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rates of Euler angles about y, z, y from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 fbcf58ed5fb921bfdeae731af0d22be0b18c057d4ab3433941bb486f4f2ac07a
 */
void chasles_euler_rates_yzy(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[2] * t2 - omega[0] * t1) / t3;
    const double theta_dot0 = omega[1] - cos(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[0] * t2 + omega[2] * t1;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yzy in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 fbcf58ed5fb921bfdeae731af0d22be0b18c057d4ab3433941bb486f4f2ac07a
 */
void chasles_euler_rates_yzyf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[2] * t2 - omega[0] * t1) / t3;
    const float theta_dot0 = omega[1] - cosf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[0] * t2 + omega[2] * t1;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_yzy for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 fbcf58ed5fb921bfdeae731af0d22be0b18c057d4ab3433941bb486f4f2ac07a
 */
void chasles_euler_rates_yzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_yzy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rates_yzyf for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 fbcf58ed5fb921bfdeae731af0d22be0b18c057d4ab3433941bb486f4f2ac07a
 */
void chasles_euler_rates_yzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_yzy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rotation by Euler angles about z, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 00df5b3e078a442b89ec92320b9be4d00f69c8c69b5377ceed30ce97167894d8
 */
void chasles_rotation_from_euler_zxy(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double Q7 = sin(angles[1]);
    const double Q1 = -(t2 * t3);
    const double t4 = t2 * Q7;
    const double Q4 = t1 * t3;
    const double t5 = t1 * Q7;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q0 = t1 * t6 - t4 * t7;
    const double Q2 = t1 * t7 + t4 * t6;
    const double Q3 = t2 * t6 + t5 * t7;
    const double Q5 = t2 * t7 - t5 * t6;
    const double Q6 = -(t3 * t7);
    const double Q8 = t3 * t6;
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
 * Ex 3.10 chasles_rotation_from_euler_zxy in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 00df5b3e078a442b89ec92320b9be4d00f69c8c69b5377ceed30ce97167894d8
 */
void chasles_rotation_from_euler_zxyf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float Q7 = sinf(angles[1]);
    const float Q1 = -(t2 * t3);
    const float t4 = t2 * Q7;
    const float Q4 = t1 * t3;
    const float t5 = t1 * Q7;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q0 = t1 * t6 - t4 * t7;
    const float Q2 = t1 * t7 + t4 * t6;
    const float Q3 = t2 * t6 + t5 * t7;
    const float Q5 = t2 * t7 - t5 * t6;
    const float Q6 = -(t3 * t7);
    const float Q8 = t3 * t6;
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
 * Ex 3.10 chasles_rotation_from_euler_zxy for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 00df5b3e078a442b89ec92320b9be4d00f69c8c69b5377ceed30ce97167894d8
 */
void chasles_rotation_from_euler_zxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_zxy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_rotation_from_euler_zxyf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 00df5b3e078a442b89ec92320b9be4d00f69c8c69b5377ceed30ce97167894d8
 */
void chasles_rotation_from_euler_zxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_zxy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 66b9e91ee2080f4af362adbd4cfbd2f6493f2d49f04e969606b8e5e66a892530
 */
void chasles_euler_rate_matrix_zxy(const double angles[3], double W[9])
{
    const double W1 = cos(angles[0]);
    const double W4 = sin(angles[0]);
    const double t1 = cos(angles[1]);
    const double W8 = sin(angles[1]);
    const double W2 = -(W4 * t1);
    const double W5 = W1 * t1;
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0;
    W[7] = 0.0;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zxy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 66b9e91ee2080f4af362adbd4cfbd2f6493f2d49f04e969606b8e5e66a892530
 */
void chasles_euler_rate_matrix_zxyf(const float angles[3], float W[9])
{
    const float W1 = cosf(angles[0]);
    const float W4 = sinf(angles[0]);
    const float t1 = cosf(angles[1]);
    const float W8 = sinf(angles[1]);
    const float W2 = -(W4 * t1);
    const float W5 = W1 * t1;
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0f;
    W[7] = 0.0f;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zxy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 66b9e91ee2080f4af362adbd4cfbd2f6493f2d49f04e969606b8e5e66a892530
 */
void chasles_euler_rate_matrix_zxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_zxy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zxyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 66b9e91ee2080f4af362adbd4cfbd2f6493f2d49f04e969606b8e5e66a892530
 */
void chasles_euler_rate_matrix_zxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_zxy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 ee0e5dc36786ec147d7731e28a73445f4829a353e033fb0bdf99f16a9ae96d67
 */
void chasles_euler_rate_matrix_body_zxy(const double angles[3], double W_body[9])
{
    const double t1 = cos(angles[1]);
    const double W_body3 = sin(angles[1]);
    const double W_body1 = cos(angles[2]);
    const double W_body7 = sin(angles[2]);
    const double W_body0 = -(t1 * W_body7);
    const double W_body6 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = 0.0;
    W_body[5] = 1.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zxy in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 ee0e5dc36786ec147d7731e28a73445f4829a353e033fb0bdf99f16a9ae96d67
 */
void chasles_euler_rate_matrix_body_zxyf(const float angles[3], float W_body[9])
{
    const float t1 = cosf(angles[1]);
    const float W_body3 = sinf(angles[1]);
    const float W_body1 = cosf(angles[2]);
    const float W_body7 = sinf(angles[2]);
    const float W_body0 = -(t1 * W_body7);
    const float W_body6 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = 0.0f;
    W_body[5] = 1.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zxy for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 ee0e5dc36786ec147d7731e28a73445f4829a353e033fb0bdf99f16a9ae96d67
 */
void chasles_euler_rate_matrix_body_zxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_zxy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zxyf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 ee0e5dc36786ec147d7731e28a73445f4829a353e033fb0bdf99f16a9ae96d67
 */
void chasles_euler_rate_matrix_body_zxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_zxy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rates of Euler angles about z, x, y from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 f15319cb143e29fdad80688ea5d83794cf5328509c5cd1fb52fa078f77b2a785
 */
void chasles_euler_rates_zxy(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[1] * t1 - omega[0] * t2) / t3;
    const double theta_dot0 = omega[2] - sin(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[0] * t1 + omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zxy in single precision.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 f15319cb143e29fdad80688ea5d83794cf5328509c5cd1fb52fa078f77b2a785
 */
void chasles_euler_rates_zxyf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[1] * t1 - omega[0] * t2) / t3;
    const float theta_dot0 = omega[2] - sinf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[0] * t1 + omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zxy for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 f15319cb143e29fdad80688ea5d83794cf5328509c5cd1fb52fa078f77b2a785
 */
void chasles_euler_rates_zxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_zxy_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rates_zxyf for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 f15319cb143e29fdad80688ea5d83794cf5328509c5cd1fb52fa078f77b2a785
 */
void chasles_euler_rates_zxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_zxy_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rotation by Euler angles about z, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 90292a7b1973bd54561384a1b0aca95f4b081c5031f08a71f5bf1eeb509996f8
 */
void chasles_rotation_from_euler_zxz(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double Q8 = cos(angles[1]);
    const double t3 = sin(angles[1]);
    const double t4 = t2 * Q8;
    const double Q2 = t2 * t3;
    const double t5 = t1 * Q8;
    const double Q5 = -(t1 * t3);
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q0 = t1 * t6 - t4 * t7;
    const double Q1 = -(t1 * t7 + t4 * t6);
    const double Q3 = t2 * t6 + t5 * t7;
    const double Q4 = t5 * t6 - t2 * t7;
    const double Q6 = t3 * t7;
    const double Q7 = t3 * t6;
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
 * Ex 3.10 chasles_rotation_from_euler_zxz in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 90292a7b1973bd54561384a1b0aca95f4b081c5031f08a71f5bf1eeb509996f8
 */
void chasles_rotation_from_euler_zxzf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float Q8 = cosf(angles[1]);
    const float t3 = sinf(angles[1]);
    const float t4 = t2 * Q8;
    const float Q2 = t2 * t3;
    const float t5 = t1 * Q8;
    const float Q5 = -(t1 * t3);
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q0 = t1 * t6 - t4 * t7;
    const float Q1 = -(t1 * t7 + t4 * t6);
    const float Q3 = t2 * t6 + t5 * t7;
    const float Q4 = t5 * t6 - t2 * t7;
    const float Q6 = t3 * t7;
    const float Q7 = t3 * t6;
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
 * Ex 3.10 chasles_rotation_from_euler_zxz for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 90292a7b1973bd54561384a1b0aca95f4b081c5031f08a71f5bf1eeb509996f8
 */
void chasles_rotation_from_euler_zxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_zxz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_rotation_from_euler_zxzf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 90292a7b1973bd54561384a1b0aca95f4b081c5031f08a71f5bf1eeb509996f8
 */
void chasles_rotation_from_euler_zxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_zxz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 d6bac485f18ebb57e7adb1eb90896adee410e33308c5db55212969aa010526ee
 */
void chasles_euler_rate_matrix_zxz(const double angles[3], double W[9])
{
    const double W1 = cos(angles[0]);
    const double W4 = sin(angles[0]);
    const double W8 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W2 = W4 * t1;
    const double W5 = -(W1 * t1);
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0;
    W[7] = 0.0;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zxz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 d6bac485f18ebb57e7adb1eb90896adee410e33308c5db55212969aa010526ee
 */
void chasles_euler_rate_matrix_zxzf(const float angles[3], float W[9])
{
    const float W1 = cosf(angles[0]);
    const float W4 = sinf(angles[0]);
    const float W8 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W2 = W4 * t1;
    const float W5 = -(W1 * t1);
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0f;
    W[7] = 0.0f;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zxz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 d6bac485f18ebb57e7adb1eb90896adee410e33308c5db55212969aa010526ee
 */
void chasles_euler_rate_matrix_zxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_zxz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zxzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 d6bac485f18ebb57e7adb1eb90896adee410e33308c5db55212969aa010526ee
 */
void chasles_euler_rate_matrix_zxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_zxz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 22c895ea0aa33cf27a73432cf9b7edd645045c890d81351055832ab2e86d2ae0
 */
void chasles_euler_rate_matrix_body_zxz(const double angles[3], double W_body[9])
{
    const double W_body6 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W_body1 = cos(angles[2]);
    const double t2 = sin(angles[2]);
    const double W_body0 = t1 * t2;
    const double W_body4 = -t2;
    const double W_body3 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = 0.0;
    W_body[8] = 1.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zxz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 22c895ea0aa33cf27a73432cf9b7edd645045c890d81351055832ab2e86d2ae0
 */
void chasles_euler_rate_matrix_body_zxzf(const float angles[3], float W_body[9])
{
    const float W_body6 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W_body1 = cosf(angles[2]);
    const float t2 = sinf(angles[2]);
    const float W_body0 = t1 * t2;
    const float W_body4 = -t2;
    const float W_body3 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = 0.0f;
    W_body[8] = 1.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zxz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 22c895ea0aa33cf27a73432cf9b7edd645045c890d81351055832ab2e86d2ae0
 */
void chasles_euler_rate_matrix_body_zxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_zxz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zxzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 22c895ea0aa33cf27a73432cf9b7edd645045c890d81351055832ab2e86d2ae0
 */
void chasles_euler_rate_matrix_body_zxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_zxz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rates of Euler angles about z, x, z from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 9730082636217a13ed6443b9376e26c825640305348e897e3b1e8d20d25ad893
 */
void chasles_euler_rates_zxz(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[0] * t2 - omega[1] * t1) / t3;
    const double theta_dot0 = omega[2] - cos(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[0] * t1 + omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zxz in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 9730082636217a13ed6443b9376e26c825640305348e897e3b1e8d20d25ad893
 */
void chasles_euler_rates_zxzf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[0] * t2 - omega[1] * t1) / t3;
    const float theta_dot0 = omega[2] - cosf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[0] * t1 + omega[1] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zxz for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 9730082636217a13ed6443b9376e26c825640305348e897e3b1e8d20d25ad893
 */
void chasles_euler_rates_zxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_zxz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rates_zxzf for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 9730082636217a13ed6443b9376e26c825640305348e897e3b1e8d20d25ad893
 */
void chasles_euler_rates_zxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_zxz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rotation by Euler angles about z, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   error bound 5.3 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 77eae5b015783de7dba57287593533e40a4bf6d57321c5d7151d36cf1a028acc
 */
void chasles_rotation_from_euler_zyx(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double t4 = sin(angles[1]);
    const double Q6 = -t4;
    const double Q0 = t1 * t3;
    const double t5 = t1 * t4;
    const double Q3 = t2 * t3;
    const double t6 = t2 * t4;
    const double t7 = cos(angles[2]);
    const double t8 = sin(angles[2]);
    const double Q1 = t5 * t8 - t2 * t7;
    const double Q2 = t2 * t8 + t5 * t7;
    const double Q4 = t1 * t7 + t6 * t8;
    const double Q5 = t6 * t7 - t1 * t8;
    const double Q7 = t3 * t8;
    const double Q8 = t3 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_zyx in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 77eae5b015783de7dba57287593533e40a4bf6d57321c5d7151d36cf1a028acc
 */
void chasles_rotation_from_euler_zyxf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float t4 = sinf(angles[1]);
    const float Q6 = -t4;
    const float Q0 = t1 * t3;
    const float t5 = t1 * t4;
    const float Q3 = t2 * t3;
    const float t6 = t2 * t4;
    const float t7 = cosf(angles[2]);
    const float t8 = sinf(angles[2]);
    const float Q1 = t5 * t8 - t2 * t7;
    const float Q2 = t2 * t8 + t5 * t7;
    const float Q4 = t1 * t7 + t6 * t8;
    const float Q5 = t6 * t7 - t1 * t8;
    const float Q7 = t3 * t8;
    const float Q8 = t3 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_zyx for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 77eae5b015783de7dba57287593533e40a4bf6d57321c5d7151d36cf1a028acc
 */
void chasles_rotation_from_euler_zyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_zyx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_rotation_from_euler_zyxf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 77eae5b015783de7dba57287593533e40a4bf6d57321c5d7151d36cf1a028acc
 */
void chasles_rotation_from_euler_zyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_zyx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 0adf0d7abfcbe1f817931814b81c15a9c846b1c73dcdb818878d86351c757b6d
 */
void chasles_euler_rate_matrix_zyx(const double angles[3], double W[9])
{
    const double W4 = cos(angles[0]);
    const double t1 = sin(angles[0]);
    const double W1 = -t1;
    const double t2 = cos(angles[1]);
    const double W8 = -sin(angles[1]);
    const double W2 = W4 * t2;
    const double W5 = t1 * t2;
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0;
    W[7] = 0.0;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zyx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 0adf0d7abfcbe1f817931814b81c15a9c846b1c73dcdb818878d86351c757b6d
 */
void chasles_euler_rate_matrix_zyxf(const float angles[3], float W[9])
{
    const float W4 = cosf(angles[0]);
    const float t1 = sinf(angles[0]);
    const float W1 = -t1;
    const float t2 = cosf(angles[1]);
    const float W8 = -sinf(angles[1]);
    const float W2 = W4 * t2;
    const float W5 = t1 * t2;
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0f;
    W[7] = 0.0f;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zyx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 0adf0d7abfcbe1f817931814b81c15a9c846b1c73dcdb818878d86351c757b6d
 */
void chasles_euler_rate_matrix_zyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_zyx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zyxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 0adf0d7abfcbe1f817931814b81c15a9c846b1c73dcdb818878d86351c757b6d
 */
void chasles_euler_rate_matrix_zyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_zyx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 6a7529b4dd785268409cc92077030a4cad8a64439e696ba9dfa305974e76a7df
 */
void chasles_euler_rate_matrix_body_zyx(const double angles[3], double W_body[9])
{
    const double t1 = cos(angles[1]);
    const double W_body0 = -sin(angles[1]);
    const double W_body4 = cos(angles[2]);
    const double t2 = sin(angles[2]);
    const double W_body3 = t1 * t2;
    const double W_body7 = -t2;
    const double W_body6 = t1 * W_body4;
    W_body[0] = W_body0;
    W_body[1] = 0.0;
    W_body[2] = 1.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zyx in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 6a7529b4dd785268409cc92077030a4cad8a64439e696ba9dfa305974e76a7df
 */
void chasles_euler_rate_matrix_body_zyxf(const float angles[3], float W_body[9])
{
    const float t1 = cosf(angles[1]);
    const float W_body0 = -sinf(angles[1]);
    const float W_body4 = cosf(angles[2]);
    const float t2 = sinf(angles[2]);
    const float W_body3 = t1 * t2;
    const float W_body7 = -t2;
    const float W_body6 = t1 * W_body4;
    W_body[0] = W_body0;
    W_body[1] = 0.0f;
    W_body[2] = 1.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = W_body7;
    W_body[8] = 0.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zyx for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 6a7529b4dd785268409cc92077030a4cad8a64439e696ba9dfa305974e76a7df
 */
void chasles_euler_rate_matrix_body_zyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_zyx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zyxf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 6a7529b4dd785268409cc92077030a4cad8a64439e696ba9dfa305974e76a7df
 */
void chasles_euler_rate_matrix_body_zyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_zyx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rates of Euler angles about z, y, x from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 f6fb3a6381c9037e8d1dbd8e1df9c051262d4c72bd9738451555e59c302f0f09
 */
void chasles_euler_rates_zyx(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = cos(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[0] * t1 + omega[1] * t2) / t3;
    const double theta_dot0 = omega[2] + sin(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[1] * t1 - omega[0] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zyx in single precision.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 f6fb3a6381c9037e8d1dbd8e1df9c051262d4c72bd9738451555e59c302f0f09
 */
void chasles_euler_rates_zyxf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = cosf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[0] * t1 + omega[1] * t2) / t3;
    const float theta_dot0 = omega[2] + sinf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[1] * t1 - omega[0] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zyx for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 f6fb3a6381c9037e8d1dbd8e1df9c051262d4c72bd9738451555e59c302f0f09
 */
void chasles_euler_rates_zyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_zyx_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rates_zyxf for a batch.
 *   verdict: holds under; assumes cos(theta_2) != 0
 *   13 operations; derivation sha256 f6fb3a6381c9037e8d1dbd8e1df9c051262d4c72bd9738451555e59c302f0f09
 */
void chasles_euler_rates_zyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_zyx_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rotation by Euler angles about z, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 35a70c6c05dd2903cd2f50766b4e415a63eb2ffed2c6d3e412124e8647c7b716
 */
void chasles_rotation_from_euler_zyz(const double angles[3], double Q[9])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double Q8 = cos(angles[1]);
    const double t3 = sin(angles[1]);
    const double t4 = t1 * Q8;
    const double Q2 = t1 * t3;
    const double t5 = t2 * Q8;
    const double Q5 = t2 * t3;
    const double t6 = cos(angles[2]);
    const double t7 = sin(angles[2]);
    const double Q0 = t4 * t6 - t2 * t7;
    const double Q1 = -(t4 * t7 + t2 * t6);
    const double Q3 = t5 * t6 + t1 * t7;
    const double Q4 = t1 * t6 - t5 * t7;
    const double Q6 = -(t3 * t6);
    const double Q7 = t3 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_zyz in single precision.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 35a70c6c05dd2903cd2f50766b4e415a63eb2ffed2c6d3e412124e8647c7b716
 */
void chasles_rotation_from_euler_zyzf(const float angles[3], float Q[9])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float Q8 = cosf(angles[1]);
    const float t3 = sinf(angles[1]);
    const float t4 = t1 * Q8;
    const float Q2 = t1 * t3;
    const float t5 = t2 * Q8;
    const float Q5 = t2 * t3;
    const float t6 = cosf(angles[2]);
    const float t7 = sinf(angles[2]);
    const float Q0 = t4 * t6 - t2 * t7;
    const float Q1 = -(t4 * t7 + t2 * t6);
    const float Q3 = t5 * t6 + t1 * t7;
    const float Q4 = t1 * t6 - t5 * t7;
    const float Q6 = -(t3 * t6);
    const float Q7 = t3 * t7;
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
 * Ex 3.10 chasles_rotation_from_euler_zyz for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 35a70c6c05dd2903cd2f50766b4e415a63eb2ffed2c6d3e412124e8647c7b716
 */
void chasles_rotation_from_euler_zyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_zyz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_rotation_from_euler_zyzf for a batch.
 *   verdict: defined; assumes nothing
 *   24 operations; derivation sha256 35a70c6c05dd2903cd2f50766b4e415a63eb2ffed2c6d3e412124e8647c7b716
 */
void chasles_rotation_from_euler_zyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step)
{
    char *const at[] = {(char *)angles, (char *)Q};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, Q_step * size};
    const chasles_loop *loop = &chasles_rotation_from_euler_zyz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 2df872f3e6c29262a9a735f3e6450ce704e08a1b40b33a555d7636f417131edb
 */
void chasles_euler_rate_matrix_zyz(const double angles[3], double W[9])
{
    const double W4 = cos(angles[0]);
    const double t1 = sin(angles[0]);
    const double W1 = -t1;
    const double W8 = cos(angles[1]);
    const double t2 = sin(angles[1]);
    const double W2 = W4 * t2;
    const double W5 = t1 * t2;
    W[0] = 0.0;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0;
    W[7] = 0.0;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zyz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2df872f3e6c29262a9a735f3e6450ce704e08a1b40b33a555d7636f417131edb
 */
void chasles_euler_rate_matrix_zyzf(const float angles[3], float W[9])
{
    const float W4 = cosf(angles[0]);
    const float t1 = sinf(angles[0]);
    const float W1 = -t1;
    const float W8 = cosf(angles[1]);
    const float t2 = sinf(angles[1]);
    const float W2 = W4 * t2;
    const float W5 = t1 * t2;
    W[0] = 0.0f;
    W[1] = W1;
    W[2] = W2;
    W[3] = 0.0f;
    W[4] = W4;
    W[5] = W5;
    W[6] = 1.0f;
    W[7] = 0.0f;
    W[8] = W8;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zyz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2df872f3e6c29262a9a735f3e6450ce704e08a1b40b33a555d7636f417131edb
 */
void chasles_euler_rate_matrix_zyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_zyz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_zyzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 2df872f3e6c29262a9a735f3e6450ce704e08a1b40b33a555d7636f417131edb
 */
void chasles_euler_rate_matrix_zyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step)
{
    char *const at[] = {(char *)angles, (char *)W};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_zyz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 0e8fa3809441be1ebd1a102ce8fc5b78357d823973bbc7bac7e1da5c7ce38790
 */
void chasles_euler_rate_matrix_body_zyz(const double angles[3], double W_body[9])
{
    const double W_body6 = cos(angles[1]);
    const double t1 = sin(angles[1]);
    const double W_body4 = cos(angles[2]);
    const double W_body0 = -(t1 * W_body4);
    const double W_body1 = sin(angles[2]);
    const double W_body3 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0;
    W_body[6] = W_body6;
    W_body[7] = 0.0;
    W_body[8] = 1.0;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zyz in single precision.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 0e8fa3809441be1ebd1a102ce8fc5b78357d823973bbc7bac7e1da5c7ce38790
 */
void chasles_euler_rate_matrix_body_zyzf(const float angles[3], float W_body[9])
{
    const float W_body6 = cosf(angles[1]);
    const float t1 = sinf(angles[1]);
    const float W_body4 = cosf(angles[2]);
    const float W_body0 = -(t1 * W_body4);
    const float W_body1 = sinf(angles[2]);
    const float W_body3 = t1 * W_body1;
    W_body[0] = W_body0;
    W_body[1] = W_body1;
    W_body[2] = 0.0f;
    W_body[3] = W_body3;
    W_body[4] = W_body4;
    W_body[5] = 0.0f;
    W_body[6] = W_body6;
    W_body[7] = 0.0f;
    W_body[8] = 1.0f;
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zyz for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 0e8fa3809441be1ebd1a102ce8fc5b78357d823973bbc7bac7e1da5c7ce38790
 */
void chasles_euler_rate_matrix_body_zyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_zyz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rate_matrix_body_zyzf for a batch.
 *   verdict: defined; assumes nothing
 *   6 operations; derivation sha256 0e8fa3809441be1ebd1a102ce8fc5b78357d823973bbc7bac7e1da5c7ce38790
 */
void chasles_euler_rate_matrix_body_zyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step)
{
    char *const at[] = {(char *)angles, (char *)W_body};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, W_body_step * size};
    const chasles_loop *loop = &chasles_euler_rate_matrix_body_zyz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 The rates of Euler angles about z, y, z from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 c8e47ebca1883ce144424c202eb73e0d953be9339e55743f954ebc4ff9aaa9f5
 */
void chasles_euler_rates_zyz(const double angles[3], const double omega[3], double theta_dot[3])
{
    const double t1 = cos(angles[0]);
    const double t2 = sin(angles[0]);
    const double t3 = sin(angles[1]);
    const double theta_dot2 = (t3 == 0.0 ? 0.0 : omega[0] * t1 + omega[1] * t2) / t3;
    const double theta_dot0 = omega[2] - cos(angles[1]) * theta_dot2;
    const double theta_dot1 = omega[1] * t1 - omega[0] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zyz in single precision.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 c8e47ebca1883ce144424c202eb73e0d953be9339e55743f954ebc4ff9aaa9f5
 */
void chasles_euler_rates_zyzf(const float angles[3], const float omega[3], float theta_dot[3])
{
    const float t1 = cosf(angles[0]);
    const float t2 = sinf(angles[0]);
    const float t3 = sinf(angles[1]);
    const float theta_dot2 = (t3 == 0.0f ? 0.0f : omega[0] * t1 + omega[1] * t2) / t3;
    const float theta_dot0 = omega[2] - cosf(angles[1]) * theta_dot2;
    const float theta_dot1 = omega[1] * t1 - omega[0] * t2;
    theta_dot[0] = theta_dot0;
    theta_dot[1] = theta_dot1;
    theta_dot[2] = theta_dot2;
}

/*
 * Ex 3.10 chasles_euler_rates_zyz for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 c8e47ebca1883ce144424c202eb73e0d953be9339e55743f954ebc4ff9aaa9f5
 */
void chasles_euler_rates_zyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(double);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_zyz_loop;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

/*
 * Ex 3.10 chasles_euler_rates_zyzf for a batch.
 *   verdict: holds under; assumes sin(theta_2) != 0
 *   13 operations; derivation sha256 c8e47ebca1883ce144424c202eb73e0d953be9339e55743f954ebc4ff9aaa9f5
 */
void chasles_euler_rates_zyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step)
{
    char *const at[] = {(char *)angles, (char *)omega, (char *)theta_dot};
    const ptrdiff_t size = (ptrdiff_t)sizeof(float);
    const ptrdiff_t moves[] = {angles_step * size, omega_step * size, theta_dot_step * size};
    const chasles_loop *loop = &chasles_euler_rates_zyz_loopf;
    chasles_run(loop, chasles_best_level(), (ptrdiff_t)count, at, moves, NULL);
}

#endif
