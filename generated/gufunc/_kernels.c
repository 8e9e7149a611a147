/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* chasles._kernels: the C kernels as NumPy generalised ufuncs. Made by `chasles emit`; not to be edited by hand.
 *
 * NumPy broadcasts, checks core shapes, casts, buffers, keeps overlapping operands apart and releases the global lock
 * around each loop; the loop hands its batch, of any strides, to the C library.
 */
#include "kernels.h"

#include <stdlib.h>
#include <string.h>

#include <numpy/arrayobject.h>

const Kernel chasles_kernels[] = {
    {
        .name = "cross_product_matrix",
        .signature = "(3)->(3,3)",
        .doc =
            "cross_product_matrix(v, /, *, out=None)\n"
            "--\n"
            "\n"
            "(2.38) The cross-product matrix of v: multiplying by it is taking the vector product with v.\n"
            "  given       v (3): any vector\n"
            "  returns     V (3, 3): cross-product matrix of a vector\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  0\n"
            "  error bound exact, for all inputs\n"
            "  derivation  sha256 1dcc0e58f219711b3c3f86b749f8c10b4db63734a02b20de3d9c405c9765483d\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_cross_product_matrix_loopf, &chasles_cross_product_matrix_loop },
        .operands = { "v", "V" },
    },
    {
        .name = "rotation_from_axis_angle",
        .signature = "(3),()->(3,3)",
        .doc =
            "rotation_from_axis_angle(e, phi, /, *, out=None)\n"
            "--\n"
            "\n"
            "(2.49) The rotation about the axis e through the angle phi.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     defined\n"
            "  assumes     |e| = 1\n"
            "  operations  24: 6 add, 4 subtract, 12 multiply, 1 sine, 1 cosine\n"
            "  error bound 6.1 u of the largest entry, for every unit e and every phi; u = 2^-53, in single\n"
            "                precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 dd485fc9fc55c9da723bbd623b2225ec82c9e8dbfe322dbf4dfe768c7d30e93a\n"
            "  signature   (3),()->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_axis_angle_loopf, &chasles_rotation_from_axis_angle_loop },
        .operands = { "e", "phi", "Q" },
    },
    {
        .name = "point_after_displacement",
        .signature = "(3,3),(3),(3),(3)->(3)",
        .doc =
            "point_after_displacement(Q, a, a_prime, p, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.2) Where a point of the body lies after the displacement.\n"
            "  given       Q (3, 3): rotation\n"
            "              a (3): position of the landmark point A\n"
            "              a_prime (3): position of A after the displacement\n"
            "              p (3): position of any point P\n"
            "  returns     p_prime (3): position of P after the displacement\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  expects     Q is a rotation\n"
            "  operations  21: 9 add, 3 subtract, 9 multiply\n"
            "  error bound 5.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 af99d11eca408718e24cab7a00a1fd908df2c4445259caf108fa6366c29b6560\n"
            "  signature   (3,3),(3),(3),(3)->(3)\n"
            "",
        .loops = { &chasles_point_after_displacement_loopf, &chasles_point_after_displacement_loop },
        .operands = { "Q", "a", "a_prime", "p", "p_prime" },
    },
    {
        .name = "pitch_of_motion",
        .signature = "(3),(),(3)->()",
        .doc =
            "pitch_of_motion(e, phi, d_P, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.7) The pitch from the displacement of any point.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              d_P (3): displacement of P\n"
            "  returns     result: d0 / phi\n"
            "  verdict     holds under\n"
            "  assumes     phi != 0\n"
            "              |e| = 1\n"
            "  operations  6: 2 add, 3 multiply, 1 divide\n"
            "  error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 a00b650de0c575f7c9b2294f993cd4d248ffaaa64b28a7f2d4581cd5c90cdf7f\n"
            "  signature   (3),(),(3)->()\n"
            "",
        .loops = { &chasles_pitch_of_motion_loopf, &chasles_pitch_of_motion_loop },
        .operands = { "e", "phi", "d_P", "result" },
    },
    {
        .name = "normal_matrix_inverse",
        .signature = "(3),()->(3,3)",
        .doc =
            "normal_matrix_inverse(e, phi, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.16) The inverse of the matrix of the normal equations.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     result (3, 3): (A^T A)^-1\n"
            "  verdict     holds under\n"
            "  assumes     phi != 0\n"
            "              |e| = 1\n"
            "  operations  17: 3 add, 1 subtract, 11 multiply, 1 divide, 1 sine\n"
            "  error bound 8.4 u of the largest entry, for every unit e and every phi; u = 2^-53, in single\n"
            "                precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine within 0.8 ulp\n"
            "  derivation  sha256 1a335cc68a85257903e9024003c40a39af04dc468b703619f454e7c6495b1c9c\n"
            "  signature   (3),()->(3,3)\n"
            "",
        .loops = { &chasles_normal_matrix_inverse_loopf, &chasles_normal_matrix_inverse_loop },
        .operands = { "e", "phi", "result" },
    },
    {
        .name = "screw_axis_point",
        .signature = "(3),(),(3),(3)->(3)",
        .doc =
            "screw_axis_point(e, phi, a, a_prime, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.18) The point of the screw axis nearest the origin.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              a (3): position of the landmark point A\n"
            "              a_prime (3): position of A after the displacement\n"
            "  returns     p_0 (3): position of the point of the screw axis nearest the origin\n"
            "  verdict     holds under\n"
            "  assumes     phi != 0\n"
            "              |e| = 1\n"
            "  made of     an offered form, proved equal to the statement\n"
            "  operations  39: 5 add, 12 subtract, 19 multiply, 1 divide, 1 sine, 1 cosine\n"
            "  error bound 9.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 41aeb7a69bd4c902412187ac18c770eab3e24db7018b56881eddfad568648df0\n"
            "  signature   (3),(),(3),(3)->(3)\n"
            "",
        .loops = { &chasles_screw_axis_point_loopf, &chasles_screw_axis_point_loop },
        .operands = { "e", "phi", "a", "a_prime", "p_0" },
    },
    {
        .name = "plucker_line",
        .signature = "(3),(3)->(6)",
        .doc =
            "plucker_line(p_1, p_2, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.23) The Pl\303\274cker array of a line: its direction and its moment.\n"
            "  given       p_1 (3): position of point P_1\n"
            "              p_2 (3): position of point P_2\n"
            "  returns     kappa (6): Pluecker array: direction and moment\n"
            "  verdict     defined\n"
            "  assumes     p_1 != p_2\n"
            "  operations  24: 2 add, 6 subtract, 9 multiply, 6 divide, 1 square root\n"
            "  error bound 9.51 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 32c3975b5a0a9106d94e083a43fadc2be5fbb7bda4c600d797436f2a818ba4e5\n"
            "  signature   (3),(3)->(6)\n"
            "",
        .loops = { &chasles_plucker_line_loopf, &chasles_plucker_line_loop },
        .operands = { "p_1", "p_2", "kappa" },
    },
    {
        .name = "plucker_transfer",
        .signature = "(6),(3),(3)->(6)",
        .doc =
            "plucker_transfer(kappa_A, a, b, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.29a) The Pl\303\274cker-coordinate transfer formula.\n"
            "  given       kappa_A (6): Pluecker array with the moment about A\n"
            "              a (3): position of the landmark point A\n"
            "              b (3): position of point B\n"
            "  returns     kappa_B (6): Pluecker array with the moment about B\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  15: 3 add, 6 subtract, 6 multiply\n"
            "  error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 6d53a1bee79a6a2a63aafa29de9b2815a5d19f7d96ef743e8fd201bd98bf5faf\n"
            "  signature   (6),(3),(3)->(6)\n"
            "",
        .loops = { &chasles_plucker_transfer_loopf, &chasles_plucker_transfer_loop },
        .operands = { "kappa_A", "a", "b", "kappa_B" },
    },
    {
        .name = "rotation_in_triad_axes",
        .signature = "(3,3),(3,3)->(3,3)",
        .doc =
            "rotation_in_triad_axes(triad, triad_prime, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.2.3 h The rotation in the axes of the triad, as a product of matrices.\n"
            "  given       triad (3, 3): the triad as columns\n"
            "              triad_prime (3, 3): the displaced triad as columns\n"
            "  returns     Q (3, 3): components of the rotation in the axes of the triad\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  expects     triad is a rotation\n"
            "              triad' is a rotation\n"
            "  operations  45: 18 add, 27 multiply\n"
            "  error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 17b2c6690d171cd369c93be59a7a8c3b70bc0108c48d7358142e2312ebf805ee\n"
            "  signature   (3,3),(3,3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_in_triad_axes_loopf, &chasles_rotation_in_triad_axes_loop },
        .operands = { "triad", "triad_prime", "Q" },
    },
    {
        .name = "rotation_from_triads",
        .signature = "(3,3),(3,3)->(3,3)",
        .doc =
            "rotation_from_triads(triad, triad_prime, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.2.3 g The rotation that takes one triad into the other, in the frame in which both are given.\n"
            "  given       triad (3, 3): the triad as columns\n"
            "              triad_prime (3, 3): the displaced triad as columns\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     holds under\n"
            "  assumes     e_1, e_2, e_3 are orthonormal and right-handed\n"
            "  expects     triad is a rotation\n"
            "              triad' is a rotation\n"
            "  operations  45: 18 add, 27 multiply\n"
            "  error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 0c12a1c3d699670fac6168e45da2070083d35015f2bd6eac4cd2f1464da2b780\n"
            "  signature   (3,3),(3,3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_triads_loopf, &chasles_rotation_from_triads_loop },
        .operands = { "triad", "triad_prime", "Q" },
    },
    {
        .name = "axial_vector",
        .signature = "(3,3)->(3)",
        .doc =
            "axial_vector(Omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.45) The angular velocity: the axial vector of the angular-velocity matrix.\n"
            "  given       Omega (3, 3): angular-velocity matrix\n"
            "  returns     omega (3): angular velocity\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 3 subtract, 3 multiply\n"
            "  error bound 1.01 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 8c4348a6af61531ef5e1d340b707a886d5ae17216e0e81a5fdda49099e70eece\n"
            "  signature   (3,3)->(3)\n"
            "",
        .loops = { &chasles_axial_vector_loopf, &chasles_axial_vector_loop },
        .operands = { "Omega", "omega" },
    },
    {
        .name = "velocity_of_point",
        .signature = "(3),(3),(3),(3)->(3)",
        .doc =
            "velocity_of_point(omega, a_dot, a, p, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.50) The velocity of a point from that of the landmark.\n"
            "  given       omega (3): angular velocity\n"
            "              a_dot (3): time derivative of: position of the landmark point A\n"
            "              a (3): position of the landmark point A\n"
            "              p (3): position of any point P\n"
            "  returns     p_dot (3): time derivative of: position of any point P\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  15: 3 add, 6 subtract, 6 multiply\n"
            "  error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 b5acf63f8b2ae232595725548e5ba32264be6bf6d52d501066130e78c9ed0486\n"
            "  signature   (3),(3),(3),(3)->(3)\n"
            "",
        .loops = { &chasles_velocity_of_point_loopf, &chasles_velocity_of_point_loop },
        .operands = { "omega", "a_dot", "a", "p", "p_dot" },
    },
    {
        .name = "instant_screw_point",
        .signature = "(3),(3),(3)->(3)",
        .doc =
            "instant_screw_point(omega, a_dot, a, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.70) The point of the instant screw axis nearest the origin, with vector products.\n"
            "  given       omega (3): angular velocity\n"
            "              a_dot (3): time derivative of: position of the landmark point A\n"
            "              a (3): position of the landmark point A\n"
            "  returns     p_0_prime (3): position of the point of the instant screw axis nearest the origin\n"
            "  verdict     holds under\n"
            "  assumes     omega != 0\n"
            "  operations  35: 2 add, 9 subtract, 15 multiply, 9 divide\n"
            "  error bound 13.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 8add5ae098bd1648bf2231d712391a8ce89357247f8df1a150855707c8b25192\n"
            "  signature   (3),(3),(3)->(3)\n"
            "",
        .loops = { &chasles_instant_screw_point_loopf, &chasles_instant_screw_point_loop },
        .operands = { "omega", "a_dot", "a", "p_0_prime" },
    },
    {
        .name = "natural_rate_matrix",
        .signature = "(3),()->(4,3)",
        .doc =
            "natural_rate_matrix(e, phi, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.76b) The matrix of the natural invariants' rates.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     N (4, 3): natural invariants' rates from the angular velocity\n"
            "  verdict     defined\n"
            "  assumes     |e| = 1\n"
            "              phi != 0\n"
            "  operations  26: 6 add, 3 subtract, 14 multiply, 1 divide, 1 sine, 1 cosine\n"
            "  error bound 6.0 u of the largest entry, for every unit e and every phi; u = 2^-53, in single\n"
            "                precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 ae8848864c3fe36678c44ede0fea89f8af655c143bdb95acf6bb13cd98cc80e0\n"
            "  signature   (3),()->(4,3)\n"
            "",
        .loops = { &chasles_natural_rate_matrix_loopf, &chasles_natural_rate_matrix_loop },
        .operands = { "e", "phi", "N" },
    },
    {
        .name = "linear_rate_matrix",
        .signature = "(3),()->(4,3)",
        .doc =
            "linear_rate_matrix(e, phi, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.76c) The matrix of the linear invariants' rates.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     L (4, 3): linear invariants' rates from the angular velocity\n"
            "  verdict     defined\n"
            "  assumes     |e| = 1\n"
            "  operations  30: 4 add, 7 subtract, 17 multiply, 1 sine, 1 cosine\n"
            "  error bound 5.2 u of the largest entry, for every unit e and every phi; u = 2^-53, in single\n"
            "                precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 dc969a2458fb1ccbe6cf9ba4bd5c14c48137796a5e63b6fdffe960bc3f43a806\n"
            "  signature   (3),()->(4,3)\n"
            "",
        .loops = { &chasles_linear_rate_matrix_loopf, &chasles_linear_rate_matrix_loop },
        .operands = { "e", "phi", "L" },
    },
    {
        .name = "euler_rodrigues_rate_matrix",
        .signature = "(3),()->(4,3)",
        .doc =
            "euler_rodrigues_rate_matrix(e, phi, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.76d) The matrix of the Euler-Rodrigues parameters' rates.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     H (4, 3): Euler-Rodrigues parameters' rates from the angular velocity\n"
            "  verdict     defined\n"
            "  assumes     |e| = 1\n"
            "  operations  8: 6 multiply, 1 sine, 1 cosine\n"
            "  error bound 2.61 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 6c847b4baa2596c76e6ab0bd3e04d8ba67a999fd27b87b011fca1a1dab6d4147\n"
            "  signature   (3),()->(4,3)\n"
            "",
        .loops = { &chasles_euler_rodrigues_rate_matrix_loopf, &chasles_euler_rodrigues_rate_matrix_loop },
        .operands = { "e", "phi", "H" },
    },
    {
        .name = "rotation_from_linear_invariants",
        .signature = "(3),()->(3,3)",
        .doc =
            "rotation_from_linear_invariants(q, q_0, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.4.2 f The rotation from its linear invariants.\n"
            "  given       q (3): vector part of four invariants of the rotation\n"
            "              q_0: scalar part of four invariants of the rotation\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     holds under\n"
            "  assumes     phi != pi\n"
            "  expects     |[q, q_0]| = 1\n"
            "              1 + q_0 != 0\n"
            "  operations  20: 7 add, 3 subtract, 9 multiply, 1 divide\n"
            "  error bound 5.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 19e234a754a5568e2a2452e2008c17414b949e07381e92256366ba6cc7d976bb\n"
            "  signature   (3),()->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_linear_invariants_loopf, &chasles_rotation_from_linear_invariants_loop },
        .operands = { "q", "q_0", "Q" },
    },
    {
        .name = "rotation_from_euler_rodrigues",
        .signature = "(3),()->(3,3)",
        .doc =
            "rotation_from_euler_rodrigues(q, q_0, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.4.2 f The rotation from its Euler-Rodrigues parameters.\n"
            "  given       q (3): vector part of four invariants of the rotation\n"
            "              q_0: scalar part of four invariants of the rotation\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  expects     |[q, q_0]| = 1\n"
            "  operations  29: 8 add, 4 subtract, 17 multiply\n"
            "  error bound 5.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 767311161fbd53fb1cb19724605fdf117b3445cf5f7cf313ccc6ecbf4a40f8c5\n"
            "  signature   (3),()->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_euler_rodrigues_loopf, &chasles_rotation_from_euler_rodrigues_loop },
        .operands = { "q", "q_0", "Q" },
    },
    {
        .name = "linear_invariants",
        .signature = "(3,3)->(3),()",
        .doc =
            "linear_invariants(Q, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.4.2 g The linear invariants from the rotation.\n"
            "  given       Q (3, 3): rotation\n"
            "  returns     q (3): vector part of four invariants of the rotation\n"
            "              q_0: scalar part of four invariants of the rotation\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  expects     Q is a rotation\n"
            "  operations  10: 2 add, 4 subtract, 4 multiply\n"
            "  error bound q: 1.01 u of itself, for all inputs\n"
            "              q_0: 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single\n"
            "                precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 dd83557748f8a3babd3f50468d387276f7ffb668b7fc29c093a7976e71eaabef\n"
            "  signature   (3,3)->(3),()\n"
            "",
        .loops = { &chasles_linear_invariants_loopf, &chasles_linear_invariants_loop },
        .operands = { "Q", "q", "q_0" },
    },
    {
        .name = "natural_invariants",
        .signature = "(3,3)->(3),()",
        .doc =
            "natural_invariants(Q, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.4.2 h The natural invariants from the rotation.\n"
            "  given       Q (3, 3): rotation\n"
            "  returns     e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  verdict     holds under\n"
            "  assumes     Q is a rotation\n"
            "              phi != 0\n"
            "  operations  63: 23 add, 7 subtract, 22 multiply, 8 divide, 2 square root, 1 arctangent2\n"
            "  error bound e: 13.16 u of itself, for every rotation Q, beside the case that is taken\n"
            "              phi: 26.99 u of itself, for every rotation Q, beside the case that is taken; u =\n"
            "                2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, arctangent within 1\n"
            "                ulp\n"
            "  derivation  sha256 167078e6ba9dff78870c0f0ddc85370ad11a1b0b824ddf316c3c9f19bd756081\n"
            "  signature   (3,3)->(3),()\n"
            "",
        .loops = { &chasles_natural_invariants_loopf, &chasles_natural_invariants_loop },
        .operands = { "Q", "e", "phi" },
    },
    {
        .name = "euler_rodrigues_parameters",
        .signature = "(3,3)->(3),()",
        .doc =
            "euler_rodrigues_parameters(Q, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.4.2 i The Euler-Rodrigues parameters from the rotation.\n"
            "  given       Q (3, 3): rotation\n"
            "  returns     q (3): vector part of four invariants of the rotation\n"
            "              q_0: scalar part of four invariants of the rotation\n"
            "  verdict     holds under\n"
            "  assumes     Q is a rotation\n"
            "  operations  50: 21 add, 7 subtract, 17 multiply, 4 divide, 1 square root\n"
            "  error bound q: 11.66 u of itself, for every rotation Q, beside the case that is taken\n"
            "              q_0: 9.34 u of itself, for every rotation Q, beside the case that is taken; u = 2^-53,\n"
            "                in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 acb16a335b8480158c7d6e339e4c3de8c51cf3bffd9594c8aa4b639840b77580\n"
            "  signature   (3,3)->(3),()\n"
            "",
        .loops = { &chasles_euler_rodrigues_parameters_loopf, &chasles_euler_rodrigues_parameters_loop },
        .operands = { "Q", "q", "q_0" },
    },
    {
        .name = "screw_of_motion",
        .signature = "(3,3),(3),(3)->(6),(),()",
        .doc =
            "screw_of_motion(Q, a, a_prime, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.4.2 j The screw of a motion: Pl\303\274cker array of its axis, translation along it, angle.\n"
            "  given       Q (3, 3): rotation\n"
            "              a (3): position of the landmark point A\n"
            "              a_prime (3): position of A after the displacement\n"
            "  returns     axis (6): [e; p_0 x e]\n"
            "              d_0: e . (a' - a)\n"
            "              phi: angle of rotation\n"
            "  verdict     holds under\n"
            "  assumes     Q is a rotation\n"
            "              phi != 0\n"
            "  made of     an offered form, proved equal to the statement\n"
            "  operations  114: 31 add, 19 subtract, 49 multiply, 12 divide, 2 square root, 1 arctangent2\n"
            "  error bound axis: 59.30 u of the sum of its terms' sizes, for every rotation Q, beside the case\n"
            "                that is taken\n"
            "              d_0: 17.16 u of the sum of its terms' sizes, for every rotation Q, beside the case\n"
            "                that is taken\n"
            "              phi: 26.99 u of itself, for every rotation Q, beside the case that is taken; u =\n"
            "                2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, arctangent within 1\n"
            "                ulp\n"
            "  derivation  sha256 f4c88cd5f5da36a09188beb0fcfbf3a4571931b3f06ad9a253f46079ff8f69c5\n"
            "  signature   (3,3),(3),(3)->(6),(),()\n"
            "",
        .loops = { &chasles_screw_of_motion_loopf, &chasles_screw_of_motion_loop },
        .operands = { "Q", "a", "a_prime", "axis", "d_0", "phi" },
    },
    {
        .name = "instant_screw",
        .signature = "(3),(3),(3)->(6),()",
        .doc =
            "instant_screw(omega, a_dot, a, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.4.1 c The instant screw: Pl\303\274cker array of its axis, and pitch.\n"
            "  given       omega (3): angular velocity\n"
            "              a_dot (3): time derivative of: position of the landmark point A\n"
            "              a (3): position of the landmark point A\n"
            "  returns     axis (6): [e'; n']\n"
            "              pitch: pitch of the instant screw, in metres per radian\n"
            "  verdict     holds under\n"
            "  assumes     omega != 0\n"
            "  made of     an offered form, proved equal to the statement\n"
            "  operations  45: 7 add, 6 subtract, 18 multiply, 13 divide, 1 square root\n"
            "  error bound axis: 21.51 u of the sum of its terms' sizes, for all inputs\n"
            "              pitch: 14.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single\n"
            "                precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 08f61d1364f32cd980675c2c982387b0404b3c2069f72429195ad15600cd8055\n"
            "  signature   (3),(3),(3)->(6),()\n"
            "",
        .loops = { &chasles_instant_screw_loopf, &chasles_instant_screw_loop },
        .operands = { "omega", "a_dot", "a", "axis", "pitch" },
    },
    {
        .name = "natural_velocity_matrix",
        .signature = "(3),()->(3,4)",
        .doc =
            "natural_velocity_matrix(e, phi, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.77b) The matrix that gives the angular velocity from the natural invariants' rates.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     N_tilde (3, 4): angular velocity from the natural invariants' rates\n"
            "  verdict     ill-formed as printed, defined as read\n"
            "  assumes     |e| = 1\n"
            "  operations  6: 1 subtract, 3 multiply, 1 sine, 1 cosine\n"
            "  error bound 2.3 u of the largest entry, for every unit e and every phi; u = 2^-53, in single\n"
            "                precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 8f59c5ef77909eadf927c6b687cd3bab0b77e8cdc9373e233171e72268eed1b1\n"
            "  signature   (3),()->(3,4)\n"
            "",
        .loops = { &chasles_natural_velocity_matrix_loopf, &chasles_natural_velocity_matrix_loop },
        .operands = { "e", "phi", "N_tilde" },
    },
    {
        .name = "linear_velocity_matrix",
        .signature = "(3),()->(3,4)",
        .doc =
            "linear_velocity_matrix(e, phi, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.77c) The matrix that gives the angular velocity from the linear invariants' rates.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     L_tilde (3, 4): angular velocity from the linear invariants' rates\n"
            "  verdict     ill-formed as printed, defined as read\n"
            "  assumes     |e| = 1\n"
            "              phi != pi\n"
            "  operations  7: 4 multiply, 1 divide, 1 sine, 1 cosine\n"
            "  error bound 5.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 89a180463935f0c42617efa0988e0354bd46d74d20a13999139be0c69246d5f3\n"
            "  signature   (3),()->(3,4)\n"
            "",
        .loops = { &chasles_linear_velocity_matrix_loopf, &chasles_linear_velocity_matrix_loop },
        .operands = { "e", "phi", "L_tilde" },
    },
    {
        .name = "euler_rodrigues_velocity_matrix",
        .signature = "(3),()->(3,4)",
        .doc =
            "euler_rodrigues_velocity_matrix(e, phi, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.77d) The matrix that gives the angular velocity from the Euler-Rodrigues parameters' rates.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     H_tilde (3, 4): angular velocity from the Euler-Rodrigues parameters' rates\n"
            "  verdict     ill-formed as printed, defined as read\n"
            "  assumes     |e| = 1\n"
            "  operations  8: 6 multiply, 1 sine, 1 cosine\n"
            "  error bound 2.61 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 2f21b7ee20e1702180f136497178c100314ca7d0df136dd2feb59d1f89a6b375\n"
            "  signature   (3),()->(3,4)\n"
            "",
        .loops = { &chasles_euler_rodrigues_velocity_matrix_loopf, &chasles_euler_rodrigues_velocity_matrix_loop },
        .operands = { "e", "phi", "H_tilde" },
    },
    {
        .name = "pose_rate_natural",
        .signature = "(3),(),(6)->(7)",
        .doc =
            "pose_rate_natural(e, phi, t, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.78) The rate of the pose from the twist, with the natural invariants.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "  returns     s_dot (7): time derivative of: pose array\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "              phi != 0\n"
            "  operations  34: 5 add, 6 subtract, 20 multiply, 1 divide, 1 sine, 1 cosine\n"
            "  error bound 11.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 e2dfaa3aa3fac1f79b45222f3204af5a75f395308f6b3f9290346729c641eaf1\n"
            "  signature   (3),(),(6)->(7)\n"
            "",
        .loops = { &chasles_pose_rate_natural_loopf, &chasles_pose_rate_natural_loop },
        .operands = { "e", "phi", "t", "s_dot" },
    },
    {
        .name = "pose_rate_linear",
        .signature = "(3),(),(6)->(7)",
        .doc =
            "pose_rate_linear(e, phi, t, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.78) The rate of the pose from the twist, with the linear invariants.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "  returns     s_dot (7): time derivative of: pose array\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  operations  44: 5 add, 10 subtract, 27 multiply, 1 sine, 1 cosine\n"
            "  error bound 9.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 30ffb709cd3b1987574a6cb20949774164c18855b55a74fc172537bd3a7138a3\n"
            "  signature   (3),(),(6)->(7)\n"
            "",
        .loops = { &chasles_pose_rate_linear_loopf, &chasles_pose_rate_linear_loop },
        .operands = { "e", "phi", "t", "s_dot" },
    },
    {
        .name = "pose_rate_euler_rodrigues",
        .signature = "(3),(),(6)->(7)",
        .doc =
            "pose_rate_euler_rodrigues(e, phi, t, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.78) The rate of the pose from the twist, with the Euler-Rodrigues parameters.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "  returns     s_dot (7): time derivative of: pose array\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  operations  28: 5 add, 3 subtract, 18 multiply, 1 sine, 1 cosine\n"
            "  error bound 5.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 17b8436529f6b3c4a1aefcc8236971431106d820c1c98937a7defcd8b9830b55\n"
            "  signature   (3),(),(6)->(7)\n"
            "",
        .loops = { &chasles_pose_rate_euler_rodrigues_loopf, &chasles_pose_rate_euler_rodrigues_loop },
        .operands = { "e", "phi", "t", "s_dot" },
    },
    {
        .name = "twist_from_pose_rate_natural",
        .signature = "(3),(),(7)->(6)",
        .doc =
            "twist_from_pose_rate_natural(e, phi, s_dot, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.80a) The twist from the rate of the pose, with the natural invariants.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              s_dot (7): time derivative of: pose array\n"
            "  returns     t (6): twist: angular velocity, velocity of a landmark point\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  operations  27: 6 add, 4 subtract, 15 multiply, 1 sine, 1 cosine\n"
            "  error bound 7.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 c1c920878c5f917138095dea1943d4f0605d07dd2521a120e9e0a574400414d0\n"
            "  signature   (3),(),(7)->(6)\n"
            "",
        .loops = { &chasles_twist_from_pose_rate_natural_loopf, &chasles_twist_from_pose_rate_natural_loop },
        .operands = { "e", "phi", "s_dot", "t" },
    },
    {
        .name = "twist_from_pose_rate_linear",
        .signature = "(3),(),(7)->(6)",
        .doc =
            "twist_from_pose_rate_linear(e, phi, s_dot, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.80a) The twist from the rate of the pose, with the linear invariants.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              s_dot (7): time derivative of: pose array\n"
            "  returns     t (6): twist: angular velocity, velocity of a landmark point\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "              phi != pi\n"
            "  operations  25: 3 add, 6 subtract, 13 multiply, 1 divide, 1 sine, 1 cosine\n"
            "  error bound 9.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 649387c3a4635aed7b72ec7a0c9cd67fa1407b285288b83838890827853ca799\n"
            "  signature   (3),(),(7)->(6)\n"
            "",
        .loops = { &chasles_twist_from_pose_rate_linear_loopf, &chasles_twist_from_pose_rate_linear_loop },
        .operands = { "e", "phi", "s_dot", "t" },
    },
    {
        .name = "twist_from_pose_rate_euler_rodrigues",
        .signature = "(3),(),(7)->(6)",
        .doc =
            "twist_from_pose_rate_euler_rodrigues(e, phi, s_dot, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.80a) The twist from the rate of the pose, with the Euler-Rodrigues parameters.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              s_dot (7): time derivative of: pose array\n"
            "  returns     t (6): twist: angular velocity, velocity of a landmark point\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  operations  29: 3 add, 6 subtract, 18 multiply, 1 sine, 1 cosine\n"
            "  error bound 6.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 f7009c929bd74e6e8423e03290dcaa8570b236828a6884c7d6bd52463508ac87\n"
            "  signature   (3),(),(7)->(6)\n"
            "",
        .loops = { &chasles_twist_from_pose_rate_euler_rodrigues_loopf, &chasles_twist_from_pose_rate_euler_rodrigues_loop },
        .operands = { "e", "phi", "s_dot", "t" },
    },
    {
        .name = "twist_transfer",
        .signature = "(6),(3),(3)->(6)",
        .doc =
            "twist_transfer(t_A, a, p, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.83a) The twist-transfer formula.\n"
            "  given       t_A (6): twist at A\n"
            "              a (3): position of the landmark point A\n"
            "              p (3): position of any point P\n"
            "  returns     t_P (6): twist at P\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  15: 3 add, 6 subtract, 6 multiply\n"
            "  error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 4e8860fe94d4e257f6a09561ef25e7c999ddca2a00337fe8774fc0c2b9433a22\n"
            "  signature   (6),(3),(3)->(6)\n"
            "",
        .loops = { &chasles_twist_transfer_loopf, &chasles_twist_transfer_loop },
        .operands = { "t_A", "a", "p", "t_P" },
    },
    {
        .name = "angular_acceleration_matrix",
        .signature = "(3),(3)->(3,3)",
        .doc =
            "angular_acceleration_matrix(omega, omega_dot, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.86) The angular-acceleration matrix.\n"
            "  given       omega (3): angular velocity\n"
            "              omega_dot (3): time derivative of: angular velocity\n"
            "  returns     W (3, 3): angular-acceleration matrix\n"
            "  verdict     defined\n"
            "  assumes     Q is a rotation\n"
            "  operations  15: 6 add, 3 subtract, 6 multiply\n"
            "  error bound 2.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 600ac9c19e353f65970adc87c2c9e1aba7f40174fd2c1780126b444caebb2a29\n"
            "  signature   (3),(3)->(3,3)\n"
            "",
        .loops = { &chasles_angular_acceleration_matrix_loopf, &chasles_angular_acceleration_matrix_loop },
        .operands = { "omega", "omega_dot", "W" },
    },
    {
        .name = "acceleration_of_point",
        .signature = "(3),(3),(3),(3),(3)->(3)",
        .doc =
            "acceleration_of_point(omega, omega_dot, a_ddot, a, p, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.89) The acceleration of a point from that of the landmark, with vector products.\n"
            "  given       omega (3): angular velocity\n"
            "              omega_dot (3): time derivative of: angular velocity\n"
            "              a_ddot (3): second time derivative of: position of the landmark point A\n"
            "              a (3): position of the landmark point A\n"
            "              p (3): position of any point P\n"
            "  returns     p_ddot (3): second time derivative of: position of any point P\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  36: 6 add, 12 subtract, 18 multiply\n"
            "  error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 52077d75d24e72b9e016304332b02aeb13ece6765a6f5dff5b9cb8261bc6ae26\n"
            "  signature   (3),(3),(3),(3),(3)->(3)\n"
            "",
        .loops = { &chasles_acceleration_of_point_loopf, &chasles_acceleration_of_point_loop },
        .operands = { "omega", "omega_dot", "a_ddot", "a", "p", "p_ddot" },
    },
    {
        .name = "natural_rate_matrix_dot",
        .signature = "(3),(),(3)->(4,3)",
        .doc =
            "natural_rate_matrix_dot(e, phi, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.5 f The rate of N by axis, angle and angular velocity: (3.96a).\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              omega (3): angular velocity\n"
            "  returns     N_dot (4, 3): time derivative of: natural invariants' rates from the angular velocity\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "              phi != 0\n"
            "  made of     an offered form, proved equal to the statement\n"
            "  operations  70: 15 add, 12 subtract, 40 multiply, 1 divide, 1 sine, 1 cosine\n"
            "  error bound 20.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 956e7fbe93e1ea999fe3f7edebc581c8b10e077f4393b085160cc0c68988d2d5\n"
            "  signature   (3),(),(3)->(4,3)\n"
            "",
        .loops = { &chasles_natural_rate_matrix_dot_loopf, &chasles_natural_rate_matrix_dot_loop },
        .operands = { "e", "phi", "omega", "N_dot" },
    },
    {
        .name = "linear_rate_matrix_dot",
        .signature = "(3),(),(3)->(4,3)",
        .doc =
            "linear_rate_matrix_dot(e, phi, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.5 f The rate of L by axis, angle and angular velocity: (3.96b).\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              omega (3): angular velocity\n"
            "  returns     L_dot (4, 3): time derivative of: linear invariants' rates from the angular velocity\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  made of     an offered form, proved equal to the statement\n"
            "  operations  73: 12 add, 16 subtract, 43 multiply, 1 sine, 1 cosine\n"
            "  error bound 10.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 e58c3cd056fca600a3d8fabc77cc08383708b30fcd3f10997c5760ad3d813719\n"
            "  signature   (3),(),(3)->(4,3)\n"
            "",
        .loops = { &chasles_linear_rate_matrix_dot_loopf, &chasles_linear_rate_matrix_dot_loop },
        .operands = { "e", "phi", "omega", "L_dot" },
    },
    {
        .name = "euler_rodrigues_rate_matrix_dot",
        .signature = "(3),(),(3)->(4,3)",
        .doc =
            "euler_rodrigues_rate_matrix_dot(e, phi, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.5 f The rate of H by axis, angle and angular velocity: (3.96c).\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              omega (3): angular velocity\n"
            "  returns     H_dot (4, 3): time derivative of: Euler-Rodrigues parameters' rates from the angular\n"
            "                velocity\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  made of     an offered form, proved equal to the statement\n"
            "  operations  28: 2 add, 6 subtract, 18 multiply, 1 sine, 1 cosine\n"
            "  error bound 5.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 cbbc7c4a0ec6ff7289faa80a566dfa4879a785dc3e1fcb665d781015958b3b92\n"
            "  signature   (3),(),(3)->(4,3)\n"
            "",
        .loops = { &chasles_euler_rodrigues_rate_matrix_dot_loopf, &chasles_euler_rodrigues_rate_matrix_dot_loop },
        .operands = { "e", "phi", "omega", "H_dot" },
    },
    {
        .name = "natural_velocity_matrix_dot",
        .signature = "(3),(),(3)->(3,4)",
        .doc =
            "natural_velocity_matrix_dot(e, phi, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.5 g The rate of the left inverse of N by axis, angle and angular velocity: (3.97a).\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              omega (3): angular velocity\n"
            "  returns     N_tilde_dot (3, 4): time derivative of: angular velocity from the natural invariants'\n"
            "                rates\n"
            "  verdict     holds under\n"
            "  assumes     phi != 0\n"
            "              |e| = 1\n"
            "  operations  55: 8 add, 10 subtract, 34 multiply, 1 divide, 1 sine, 1 cosine\n"
            "  error bound 11.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 71e01d77b3ea46f745a9336a2825937c48ecfb5c8f22e156a02b1d41218c2c74\n"
            "  signature   (3),(),(3)->(3,4)\n"
            "",
        .loops = { &chasles_natural_velocity_matrix_dot_loopf, &chasles_natural_velocity_matrix_dot_loop },
        .operands = { "e", "phi", "omega", "N_tilde_dot" },
    },
    {
        .name = "linear_velocity_matrix_dot",
        .signature = "(3),(),(3)->(3,4)",
        .doc =
            "linear_velocity_matrix_dot(e, phi, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.5 g The rate of the left inverse of L by axis, angle and angular velocity: (3.97b).\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              omega (3): angular velocity\n"
            "  returns     L_tilde_dot (3, 4): time derivative of: angular velocity from the linear invariants'\n"
            "                rates\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "              phi != pi\n"
            "  operations  34: 5 add, 6 subtract, 20 multiply, 1 divide, 1 sine, 1 cosine\n"
            "  error bound 16.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 b5286c2c91a7b4cfdc8d341b90ed08a2a37fc92a9f25530860458e82f6eaacf3\n"
            "  signature   (3),(),(3)->(3,4)\n"
            "",
        .loops = { &chasles_linear_velocity_matrix_dot_loopf, &chasles_linear_velocity_matrix_dot_loop },
        .operands = { "e", "phi", "omega", "L_tilde_dot" },
    },
    {
        .name = "euler_rodrigues_velocity_matrix_dot",
        .signature = "(3),(),(3)->(3,4)",
        .doc =
            "euler_rodrigues_velocity_matrix_dot(e, phi, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.5 g The rate of the left inverse of H by axis, angle and angular velocity: (3.97c).\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              omega (3): angular velocity\n"
            "  returns     H_tilde_dot (3, 4): time derivative of: angular velocity from the Euler-Rodrigues\n"
            "                parameters' rates\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  operations  26: 2 add, 6 subtract, 16 multiply, 1 sine, 1 cosine\n"
            "  error bound 5.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 c80e798e741899e2d32fd6b3e16a5b786d0f82ee47987a537c4755eed1b60850\n"
            "  signature   (3),(),(3)->(3,4)\n"
            "",
        .loops = { &chasles_euler_rodrigues_velocity_matrix_dot_loopf, &chasles_euler_rodrigues_velocity_matrix_dot_loop },
        .operands = { "e", "phi", "omega", "H_tilde_dot" },
    },
    {
        .name = "pose_acceleration_natural",
        .signature = "(3),(),(6),(6)->(7)",
        .doc =
            "pose_acceleration_natural(e, phi, t, t_dot, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.5 h The second rate of the pose from the twist and its rate, with the natural invariants.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "              t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point\n"
            "  returns     s_ddot (7): second time derivative of: pose array\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "              phi != 0\n"
            "  made of     an offered form, proved equal to the statement\n"
            "  operations  96: 19 add, 19 subtract, 55 multiply, 1 divide, 1 sine, 1 cosine\n"
            "  error bound 25.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 4063df423497b2a63464c14082ba023d497a45f17209d99f956cc810ce8006b6\n"
            "  signature   (3),(),(6),(6)->(7)\n"
            "",
        .loops = { &chasles_pose_acceleration_natural_loopf, &chasles_pose_acceleration_natural_loop },
        .operands = { "e", "phi", "t", "t_dot", "s_ddot" },
    },
    {
        .name = "pose_acceleration_linear",
        .signature = "(3),(),(6),(6)->(7)",
        .doc =
            "pose_acceleration_linear(e, phi, t, t_dot, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.5 h The second rate of the pose from the twist and its rate, with the linear invariants.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "              t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point\n"
            "  returns     s_ddot (7): second time derivative of: pose array\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  made of     an offered form, proved equal to the statement\n"
            "  operations  76: 11 add, 18 subtract, 45 multiply, 1 sine, 1 cosine\n"
            "  error bound 12.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 1588dcded7d741e99e263e63960b704faab031996a2d165fbbe2b322357ed2e9\n"
            "  signature   (3),(),(6),(6)->(7)\n"
            "",
        .loops = { &chasles_pose_acceleration_linear_loopf, &chasles_pose_acceleration_linear_loop },
        .operands = { "e", "phi", "t", "t_dot", "s_ddot" },
    },
    {
        .name = "pose_acceleration_euler_rodrigues",
        .signature = "(3),(),(6),(6)->(7)",
        .doc =
            "pose_acceleration_euler_rodrigues(e, phi, t, t_dot, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.5 h The second rate of the pose from the twist and its rate, with the Euler-Rodrigues\n"
            "  parameters.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "              t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point\n"
            "  returns     s_ddot (7): second time derivative of: pose array\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  made of     an offered form, proved equal to the statement\n"
            "  operations  45: 5 add, 9 subtract, 29 multiply, 1 sine, 1 cosine\n"
            "  error bound 7.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 0f21a42c6c8b20a3978874f3add6fcde6371416fd40cc41c5da50d8f4cd6babd\n"
            "  signature   (3),(),(6),(6)->(7)\n"
            "",
        .loops = { &chasles_pose_acceleration_euler_rodrigues_loopf, &chasles_pose_acceleration_euler_rodrigues_loop },
        .operands = { "e", "phi", "t", "t_dot", "s_ddot" },
    },
    {
        .name = "twist_rate_from_pose_natural",
        .signature = "(3),(),(7),(7)->(6)",
        .doc =
            "twist_rate_from_pose_natural(e, phi, s_dot, s_ddot, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.5 i The rate of the twist from the rates of the pose, with the natural invariants.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              s_dot (7): time derivative of: pose array\n"
            "              s_ddot (7): second time derivative of: pose array\n"
            "  returns     t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  made of     an offered form, proved equal to the statement\n"
            "  operations  51: 13 add, 7 subtract, 29 multiply, 1 sine, 1 cosine\n"
            "  error bound 8.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 46142537f8f2d352235601f0fe20d7417a8415c4299de5fde88c9772c1d5b072\n"
            "  signature   (3),(),(7),(7)->(6)\n"
            "",
        .loops = { &chasles_twist_rate_from_pose_natural_loopf, &chasles_twist_rate_from_pose_natural_loop },
        .operands = { "e", "phi", "s_dot", "s_ddot", "t_dot" },
    },
    {
        .name = "twist_rate_from_pose_linear",
        .signature = "(3),(),(7),(7)->(6)",
        .doc =
            "twist_rate_from_pose_linear(e, phi, s_dot, s_ddot, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.5 i The rate of the twist from the rates of the pose, with the linear invariants.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              s_dot (7): time derivative of: pose array\n"
            "              s_ddot (7): second time derivative of: pose array\n"
            "  returns     t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "              phi != pi\n"
            "  made of     an offered form, proved equal to the statement\n"
            "  operations  52: 6 add, 15 subtract, 27 multiply, 2 divide, 1 sine, 1 cosine\n"
            "  error bound 16.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 e60a5e59bbc9bfff80fda29a99e2165c18777756e0d5ef482d146ef9b36646a2\n"
            "  signature   (3),(),(7),(7)->(6)\n"
            "",
        .loops = { &chasles_twist_rate_from_pose_linear_loopf, &chasles_twist_rate_from_pose_linear_loop },
        .operands = { "e", "phi", "s_dot", "s_ddot", "t_dot" },
    },
    {
        .name = "twist_rate_from_pose_euler_rodrigues",
        .signature = "(3),(),(7),(7)->(6)",
        .doc =
            "twist_rate_from_pose_euler_rodrigues(e, phi, s_dot, s_ddot, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.5 i The rate of the twist from the rates of the pose, with the Euler-Rodrigues parameters.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              s_dot (7): time derivative of: pose array\n"
            "              s_ddot (7): second time derivative of: pose array\n"
            "  returns     t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  made of     an offered form, proved equal to the statement\n"
            "  operations  29: 3 add, 6 subtract, 18 multiply, 1 sine, 1 cosine\n"
            "  error bound 6.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 8f9dc9af1023fade3eb622411945883078b1f62098c7b9178f68aed0ef63d94d\n"
            "  signature   (3),(),(7),(7)->(6)\n"
            "",
        .loops = { &chasles_twist_rate_from_pose_euler_rodrigues_loopf, &chasles_twist_rate_from_pose_euler_rodrigues_loop },
        .operands = { "e", "phi", "s_dot", "s_ddot", "t_dot" },
    },
    {
        .name = "moving_frame_velocity",
        .signature = "(3),(3,3),(3),(3),(3)->(3)",
        .doc =
            "moving_frame_velocity(o_dot, Q, omega, rho, rho_dot, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.103) The velocity of P in the fixed frame from that in the moving frame.\n"
            "  given       o_dot (3): time derivative of: position of the origin of the moving frame\n"
            "              Q (3, 3): rotation\n"
            "              omega (3): angular velocity\n"
            "              rho (3): position of P in the moving frame\n"
            "              rho_dot (3): time derivative of: position of P in the moving frame\n"
            "  returns     p_dot (3): time derivative of: position of any point P\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  expects     Q is a rotation\n"
            "  operations  45: 18 add, 3 subtract, 24 multiply\n"
            "  error bound 7.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 b4941bd3b3f57c83b14de8fd13a10f996bcfeb8ee7bfc4215c85ab50fb9b8b33\n"
            "  signature   (3),(3,3),(3),(3),(3)->(3)\n"
            "",
        .loops = { &chasles_moving_frame_velocity_loopf, &chasles_moving_frame_velocity_loop },
        .operands = { "o_dot", "Q", "omega", "rho", "rho_dot", "p_dot" },
    },
    {
        .name = "moving_frame_acceleration",
        .signature = "(3),(3,3),(3),(3),(3),(3),(3)->(3)",
        .doc =
            "moving_frame_acceleration(o_ddot, Q, omega, omega_dot, rho, rho_dot, rho_ddot, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.105) The acceleration of P in the fixed frame: as a point of the moving frame, Coriolis, and in\n"
            "  the moving frame.\n"
            "  given       o_ddot (3): second time derivative of: position of the origin of the moving frame\n"
            "              Q (3, 3): rotation\n"
            "              omega (3): angular velocity\n"
            "              omega_dot (3): time derivative of: angular velocity\n"
            "              rho (3): position of P in the moving frame\n"
            "              rho_dot (3): time derivative of: position of P in the moving frame\n"
            "              rho_ddot (3): second time derivative of: position of P in the moving frame\n"
            "  returns     p_ddot (3): second time derivative of: position of any point P\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  expects     Q is a rotation\n"
            "  made of     an offered form, proved equal to the statement\n"
            "  operations  87: 30 add, 9 subtract, 48 multiply\n"
            "  error bound 10.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 985f244a1c015e00a6d544a9a346e7446722d3d1972e549159bc1a6a90456d40\n"
            "  signature   (3),(3,3),(3),(3),(3),(3),(3)->(3)\n"
            "",
        .loops = { &chasles_moving_frame_acceleration_loopf, &chasles_moving_frame_acceleration_loop },
        .operands = { "o_ddot", "Q", "omega", "omega_dot", "rho", "rho_dot", "rho_ddot", "p_ddot" },
    },
    {
        .name = "wrench_axis",
        .signature = "(3),(3),(3)->(6),()",
        .doc =
            "wrench_axis(f, n_A, a, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.7 d The axis and the pitch of the wrench.\n"
            "  given       f (3): resultant force\n"
            "              n_A (3): resultant moment about A\n"
            "              a (3): position of the landmark point A\n"
            "  returns     axis (6): [e''; n'']\n"
            "              pitch: pitch of the wrench, in metres per radian\n"
            "  verdict     holds under\n"
            "  assumes     f != 0\n"
            "  made of     an offered form, proved equal to the statement\n"
            "  operations  45: 7 add, 6 subtract, 18 multiply, 13 divide, 1 square root\n"
            "  error bound axis: 21.51 u of the sum of its terms' sizes, for all inputs\n"
            "              pitch: 14.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single\n"
            "                precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 c78cfc23a3b398d6195b8dc68c79e9bdceefc46df0b8a9442885e124035211ef\n"
            "  signature   (3),(3),(3)->(6),()\n"
            "",
        .loops = { &chasles_wrench_axis_loopf, &chasles_wrench_axis_loop },
        .operands = { "f", "n_A", "a", "axis", "pitch" },
    },
    {
        .name = "power",
        .signature = "(6),(6)->()",
        .doc =
            "power(t, w, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.114) The power developed by a wrench on a body that moves with a twist at the same point.\n"
            "  given       t (6): twist: angular velocity, velocity of a landmark point\n"
            "              w (6): wrench: moment, force\n"
            "  returns     Pi: power developed by a wrench on a moving body\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  11: 5 add, 6 multiply\n"
            "  error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 580a9557b1b4b779955409e7506c76202ce3a1e9982d422e1491bf0bcad680ef\n"
            "  signature   (6),(6)->()\n"
            "",
        .loops = { &chasles_power_loopf, &chasles_power_loop },
        .operands = { "t", "w", "Pi" },
    },
    {
        .name = "reciprocal_product",
        .signature = "(6),(6)->()",
        .doc =
            "reciprocal_product(s_w, s_t, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.7 k The reciprocal product of two screws, in either order.\n"
            "  given       s_w (6): screw of a wrench\n"
            "              s_t (6): screw of a twist\n"
            "  returns     product: s_t^T Gamma s_w\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  11: 5 add, 6 multiply\n"
            "  error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 69eafb582289fe007146884f233005913bd49126222273503197968fd6ef8dd3\n"
            "  signature   (6),(6)->()\n"
            "",
        .loops = { &chasles_reciprocal_product_loopf, &chasles_reciprocal_product_loop },
        .operands = { "s_w", "s_t", "product" },
    },
    {
        .name = "wrench_transfer",
        .signature = "(6),(3),(3)->(6)",
        .doc =
            "wrench_transfer(w_A, a, p, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.119a) The wrench-transfer formula.\n"
            "  given       w_A (6): wrench at A\n"
            "              a (3): position of the landmark point A\n"
            "              p (3): position of any point P\n"
            "  returns     w_P (6): wrench at P\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  15: 3 add, 6 subtract, 6 multiply\n"
            "  error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 9cbbd4d64a694c0150c2c0a241ceaa9fe43fa91e335dce95c4c39681e8ecce3c\n"
            "  signature   (6),(3),(3)->(6)\n"
            "",
        .loops = { &chasles_wrench_transfer_loopf, &chasles_wrench_transfer_loop },
        .operands = { "w_A", "a", "p", "w_P" },
    },
    {
        .name = "inertia_about_point",
        .signature = "(3,3),(),(3),(3)->(3,3)",
        .doc =
            "inertia_about_point(I_C, m, c, a, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.133a) Steiner's theorem: the moment of inertia with respect to A from that at the center of mass.\n"
            "  given       I_C (3, 3): moment of inertia at the center of mass\n"
            "              m: mass\n"
            "              c (3): position of the center of mass\n"
            "              a (3): position of the landmark point A\n"
            "  returns     I_A (3, 3): moment of inertia with respect to A\n"
            "  verdict     holds under\n"
            "  assumes     m > 0\n"
            "  expects     I_C is symmetric\n"
            "  operations  24: 6 add, 9 subtract, 9 multiply\n"
            "  error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 4d7619030bc619e84b4607eaec8efd339cf9160ce49e3d74dfaae1e4b7730c87\n"
            "  signature   (3,3),(),(3),(3)->(3,3)\n"
            "",
        .loops = { &chasles_inertia_about_point_loopf, &chasles_inertia_about_point_loop },
        .operands = { "I_C", "m", "c", "a", "I_A" },
    },
    {
        .name = "inertia_about_point_sym6",
        .signature = "(6),(),(3),(3)->(6)",
        .doc =
            "inertia_about_point_sym6(I_C, m, c, a, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.133a) Steiner's theorem: the moment of inertia with respect to A from that at the center of mass.\n"
            "  given       I_C (6): moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,\n"
            "                zz)\n"
            "              m: mass\n"
            "              c (3): position of the center of mass\n"
            "              a (3): position of the landmark point A\n"
            "  returns     I_A (6): moment of inertia with respect to A, symmetric, as (xx, xy, xz, yy, yz, zz)\n"
            "  verdict     holds under\n"
            "  assumes     m > 0\n"
            "  expects     I_C is symmetric\n"
            "  operations  21: 6 add, 6 subtract, 9 multiply\n"
            "  error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 4d7619030bc619e84b4607eaec8efd339cf9160ce49e3d74dfaae1e4b7730c87\n"
            "  signature   (6),(),(3),(3)->(6)\n"
            "",
        .loops = { &chasles_inertia_about_point_sym6_loopf, &chasles_inertia_about_point_sym6_loop },
        .operands = { "I_C", "m", "c", "a", "I_A" },
    },
    {
        .name = "momentum_screw",
        .signature = "(3,3),(),(6)->(6)",
        .doc =
            "momentum_screw(I_C, m, t, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.142) The momentum screw by inertia dyad and twist.\n"
            "  given       I_C (3, 3): moment of inertia at the center of mass\n"
            "              m: mass\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "  returns     mu (6): [I_C omega; m c_dot]\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  expects     I_C is symmetric\n"
            "              m > 0\n"
            "  operations  18: 6 add, 12 multiply\n"
            "  error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 6db3e3a77ef9af159d0c096ec679c53626cff81d41ccfbcc2a4db4833ae93473\n"
            "  signature   (3,3),(),(6)->(6)\n"
            "",
        .loops = { &chasles_momentum_screw_loopf, &chasles_momentum_screw_loop },
        .operands = { "I_C", "m", "t", "mu" },
    },
    {
        .name = "momentum_screw_sym6",
        .signature = "(6),(),(6)->(6)",
        .doc =
            "momentum_screw_sym6(I_C, m, t, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.142) The momentum screw by inertia dyad and twist.\n"
            "  given       I_C (6): moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,\n"
            "                zz)\n"
            "              m: mass\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "  returns     mu (6): [I_C omega; m c_dot]\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  expects     I_C is symmetric\n"
            "              m > 0\n"
            "  operations  18: 6 add, 12 multiply\n"
            "  error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 6db3e3a77ef9af159d0c096ec679c53626cff81d41ccfbcc2a4db4833ae93473\n"
            "  signature   (6),(),(6)->(6)\n"
            "",
        .loops = { &chasles_momentum_screw_sym6_loopf, &chasles_momentum_screw_sym6_loop },
        .operands = { "I_C", "m", "t", "mu" },
    },
    {
        .name = "kinetic_energy",
        .signature = "(3,3),(),(6)->()",
        .doc =
            "kinetic_energy(I_C, m, t, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.145) The kinetic energy as a quadratic form of the twist.\n"
            "  given       I_C (3, 3): moment of inertia at the center of mass\n"
            "              m: mass\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "  returns     T: kinetic energy\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  expects     I_C is symmetric\n"
            "              m > 0\n"
            "  operations  35: 11 add, 24 multiply\n"
            "  error bound 9.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 69297c38ebd3f2599e0000c019f576151ae0e8d563b8a02661f982c45230000e\n"
            "  signature   (3,3),(),(6)->()\n"
            "",
        .loops = { &chasles_kinetic_energy_loopf, &chasles_kinetic_energy_loop },
        .operands = { "I_C", "m", "t", "T" },
    },
    {
        .name = "kinetic_energy_sym6",
        .signature = "(6),(),(6)->()",
        .doc =
            "kinetic_energy_sym6(I_C, m, t, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.145) The kinetic energy as a quadratic form of the twist.\n"
            "  given       I_C (6): moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,\n"
            "                zz)\n"
            "              m: mass\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "  returns     T: kinetic energy\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  expects     I_C is symmetric\n"
            "              m > 0\n"
            "  operations  35: 11 add, 24 multiply\n"
            "  error bound 9.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 69297c38ebd3f2599e0000c019f576151ae0e8d563b8a02661f982c45230000e\n"
            "  signature   (6),(),(6)->()\n"
            "",
        .loops = { &chasles_kinetic_energy_sym6_loopf, &chasles_kinetic_energy_sym6_loop },
        .operands = { "I_C", "m", "t", "T" },
    },
    {
        .name = "newton_euler_wrench",
        .signature = "(3,3),(),(6),(6)->(6)",
        .doc =
            "newton_euler_wrench(I_C, m, t, t_dot, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.8 v The wrench that moves the body: the Newton-Euler equations as they stand.\n"
            "  given       I_C (3, 3): moment of inertia at the center of mass\n"
            "              m: mass\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "              t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point\n"
            "  returns     w (6): wrench: moment, force\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  expects     I_C is symmetric\n"
            "              m > 0\n"
            "  operations  45: 15 add, 3 subtract, 27 multiply\n"
            "  error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 4e831789b8f20b1f8ebea121e0d8d47b7074e8225c3fd379d0994cdf87959c79\n"
            "  signature   (3,3),(),(6),(6)->(6)\n"
            "",
        .loops = { &chasles_newton_euler_wrench_loopf, &chasles_newton_euler_wrench_loop },
        .operands = { "I_C", "m", "t", "t_dot", "w" },
    },
    {
        .name = "newton_euler_wrench_sym6",
        .signature = "(6),(),(6),(6)->(6)",
        .doc =
            "newton_euler_wrench_sym6(I_C, m, t, t_dot, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.8 v The wrench that moves the body: the Newton-Euler equations as they stand.\n"
            "  given       I_C (6): moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,\n"
            "                zz)\n"
            "              m: mass\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "              t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point\n"
            "  returns     w (6): wrench: moment, force\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  expects     I_C is symmetric\n"
            "              m > 0\n"
            "  operations  45: 15 add, 3 subtract, 27 multiply\n"
            "  error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 4e831789b8f20b1f8ebea121e0d8d47b7074e8225c3fd379d0994cdf87959c79\n"
            "  signature   (6),(),(6),(6)->(6)\n"
            "",
        .loops = { &chasles_newton_euler_wrench_sym6_loopf, &chasles_newton_euler_wrench_sym6_loop },
        .operands = { "I_C", "m", "t", "t_dot", "w" },
    },
    {
        .name = "newton_euler_twist_rate",
        .signature = "(3,3),(),(6),(6)->(6)",
        .doc =
            "newton_euler_twist_rate(I_C, m, t, w, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.8 v The rate of the twist of a body on which a wrench acts: the Newton-Euler equations\n"
            "  solved.\n"
            "  given       I_C (3, 3): moment of inertia at the center of mass\n"
            "              m: mass\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "              w (6): wrench: moment, force\n"
            "  returns     t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point\n"
            "  verdict     holds under\n"
            "  assumes     det(I_C) != 0\n"
            "              m > 0\n"
            "  expects     I_C is positive-definite\n"
            "  operations  108: 16 add, 18 subtract, 60 multiply, 14 divide\n"
            "  error bound 24.09 u of the sum of its terms' sizes, times the condition of its divisor, for all\n"
            "                inputs of which that is at most 4096; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 583b7af3455d4e7d41db43315abbed568d7671c8edafcef5b697d79c93e17ecb\n"
            "  signature   (3,3),(),(6),(6)->(6)\n"
            "",
        .loops = { &chasles_newton_euler_twist_rate_loopf, &chasles_newton_euler_twist_rate_loop },
        .operands = { "I_C", "m", "t", "w", "t_dot" },
    },
    {
        .name = "newton_euler_twist_rate_sym6",
        .signature = "(6),(),(6),(6)->(6)",
        .doc =
            "newton_euler_twist_rate_sym6(I_C, m, t, w, /, *, out=None)\n"
            "--\n"
            "\n"
            "text 3.8 v The rate of the twist of a body on which a wrench acts: the Newton-Euler equations\n"
            "  solved.\n"
            "  given       I_C (6): moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,\n"
            "                zz)\n"
            "              m: mass\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "              w (6): wrench: moment, force\n"
            "  returns     t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point\n"
            "  verdict     holds under\n"
            "  assumes     det(I_C) != 0\n"
            "              m > 0\n"
            "  expects     I_C is positive-definite\n"
            "  operations  96: 16 add, 15 subtract, 54 multiply, 11 divide\n"
            "  error bound 24.09 u of the sum of its terms' sizes, times the condition of its divisor, for all\n"
            "                inputs of which that is at most 4096; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 583b7af3455d4e7d41db43315abbed568d7671c8edafcef5b697d79c93e17ecb\n"
            "  signature   (6),(),(6),(6)->(6)\n"
            "",
        .loops = { &chasles_newton_euler_twist_rate_sym6_loopf, &chasles_newton_euler_twist_rate_sym6_loop },
        .operands = { "I_C", "m", "t", "w", "t_dot" },
    },
    {
        .name = "inertia_dyad",
        .signature = "(3,3),(),(3),(3)->(6,6)",
        .doc =
            "inertia_dyad(I_C, m, c, a, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.147) The inertia dyad at A.\n"
            "  given       I_C (3, 3): moment of inertia at the center of mass\n"
            "              m: mass\n"
            "              c (3): position of the center of mass\n"
            "              a (3): position of the landmark point A\n"
            "  returns     M_A (6, 6): inertia dyad at A\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  expects     I_C is symmetric\n"
            "              m > 0\n"
            "  operations  24: 6 add, 9 subtract, 9 multiply\n"
            "  error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 13cba9d3a00039b66aa71e0b7c6844416aef2b889cadec353dae6a76e70a10a9\n"
            "  signature   (3,3),(),(3),(3)->(6,6)\n"
            "",
        .loops = { &chasles_inertia_dyad_loopf, &chasles_inertia_dyad_loop },
        .operands = { "I_C", "m", "c", "a", "M_A" },
    },
    {
        .name = "inertia_dyad_sym6",
        .signature = "(6),(),(3),(3)->(6,6)",
        .doc =
            "inertia_dyad_sym6(I_C, m, c, a, /, *, out=None)\n"
            "--\n"
            "\n"
            "(3.147) The inertia dyad at A.\n"
            "  given       I_C (6): moment of inertia at the center of mass, symmetric, as (xx, xy, xz, yy, yz,\n"
            "                zz)\n"
            "              m: mass\n"
            "              c (3): position of the center of mass\n"
            "              a (3): position of the landmark point A\n"
            "  returns     M_A (6, 6): inertia dyad at A\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  expects     I_C is symmetric\n"
            "              m > 0\n"
            "  operations  21: 6 add, 6 subtract, 9 multiply\n"
            "  error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA\n"
            "  derivation  sha256 13cba9d3a00039b66aa71e0b7c6844416aef2b889cadec353dae6a76e70a10a9\n"
            "  signature   (6),(),(3),(3)->(6,6)\n"
            "",
        .loops = { &chasles_inertia_dyad_sym6_loopf, &chasles_inertia_dyad_sym6_loop },
        .operands = { "I_C", "m", "c", "a", "M_A" },
    },
    {
        .name = "rotation_from_euler_xyx",
        .signature = "(3)->(3,3)",
        .doc =
            "rotation_from_euler_xyx(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rotation by Euler angles about x, y, x.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine\n"
            "  error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 49974e148b9969b7a23a303df375f906766eda03e5d7416d35c36a35c77fea06\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_euler_xyx_loopf, &chasles_rotation_from_euler_xyx_loop },
        .operands = { "angles", "Q" },
    },
    {
        .name = "euler_rate_matrix_xyx",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_xyx(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, y, x.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 15ec222e6a4c0d4af15dcf0f4f9d944364836080f80ed845b4661afb074e1ca1\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_xyx_loopf, &chasles_euler_rate_matrix_xyx_loop },
        .operands = { "angles", "W" },
    },
    {
        .name = "euler_rate_matrix_body_xyx",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_body_xyx(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, y, x.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W_body (3, 3): angular velocity in the body frame from those rates\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 cd8589089d7d47765a04b183158736b0b971b8a8d922838283fa2c2975eb5d89\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_body_xyx_loopf, &chasles_euler_rate_matrix_body_xyx_loop },
        .operands = { "angles", "W_body" },
    },
    {
        .name = "euler_rates_xyx",
        .signature = "(3),(3)->(3)",
        .doc =
            "euler_rates_xyx(angles, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rates of Euler angles about x, y, x from the angular velocity in the fixed frame.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "              omega (3): angular velocity\n"
            "  returns     theta_dot (3): rates of the Euler angles\n"
            "  verdict     holds under\n"
            "  assumes     sin(theta_2) != 0\n"
            "  operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine\n"
            "  error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 6b432c618a3b5cb7132a0a1625419f24b2800b22e52d8f8b5202e756b67ea148\n"
            "  signature   (3),(3)->(3)\n"
            "",
        .loops = { &chasles_euler_rates_xyx_loopf, &chasles_euler_rates_xyx_loop },
        .operands = { "angles", "omega", "theta_dot" },
    },
    {
        .name = "rotation_from_euler_xyz",
        .signature = "(3)->(3,3)",
        .doc =
            "rotation_from_euler_xyz(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rotation by Euler angles about x, y, z.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine\n"
            "  error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 f87af8285d9801669ca9041e726f9817a40f9c95ddf51a655b261236297c04af\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_euler_xyz_loopf, &chasles_rotation_from_euler_xyz_loop },
        .operands = { "angles", "Q" },
    },
    {
        .name = "euler_rate_matrix_xyz",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_xyz(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, y, z.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 1d2f362d906c9640bebb7713dd74f3809ce202cd977dff0cc4c827b77ce9d4d3\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_xyz_loopf, &chasles_euler_rate_matrix_xyz_loop },
        .operands = { "angles", "W" },
    },
    {
        .name = "euler_rate_matrix_body_xyz",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_body_xyz(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, y, z.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W_body (3, 3): angular velocity in the body frame from those rates\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 d605f1f844caa8fe73209313f2debbc7dad841db4b625533c1925d350b88b35f\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_body_xyz_loopf, &chasles_euler_rate_matrix_body_xyz_loop },
        .operands = { "angles", "W_body" },
    },
    {
        .name = "euler_rates_xyz",
        .signature = "(3),(3)->(3)",
        .doc =
            "euler_rates_xyz(angles, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rates of Euler angles about x, y, z from the angular velocity in the fixed frame.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "              omega (3): angular velocity\n"
            "  returns     theta_dot (3): rates of the Euler angles\n"
            "  verdict     holds under\n"
            "  assumes     cos(theta_2) != 0\n"
            "  operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine\n"
            "  error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 379cc15712b3f593e6a56a0586d8cb970b2c344caf9eff56d13b4aa0f2bc0fcb\n"
            "  signature   (3),(3)->(3)\n"
            "",
        .loops = { &chasles_euler_rates_xyz_loopf, &chasles_euler_rates_xyz_loop },
        .operands = { "angles", "omega", "theta_dot" },
    },
    {
        .name = "rotation_from_euler_xzx",
        .signature = "(3)->(3,3)",
        .doc =
            "rotation_from_euler_xzx(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rotation by Euler angles about x, z, x.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine\n"
            "  error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 509556f6df445dd3c7fe5324e0ad671112ed8aaa27442b8973ddf4f722eb8d9b\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_euler_xzx_loopf, &chasles_rotation_from_euler_xzx_loop },
        .operands = { "angles", "Q" },
    },
    {
        .name = "euler_rate_matrix_xzx",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_xzx(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, z, x.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 063a79927c0f405045ca7f3a4600867811265ae8101b11b64e443152cd0965cf\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_xzx_loopf, &chasles_euler_rate_matrix_xzx_loop },
        .operands = { "angles", "W" },
    },
    {
        .name = "euler_rate_matrix_body_xzx",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_body_xzx(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, z, x.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W_body (3, 3): angular velocity in the body frame from those rates\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 5092f84c7bbb66afac08e51bc82a4ea4bdc4738a19463c52fc60c25d1976c154\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_body_xzx_loopf, &chasles_euler_rate_matrix_body_xzx_loop },
        .operands = { "angles", "W_body" },
    },
    {
        .name = "euler_rates_xzx",
        .signature = "(3),(3)->(3)",
        .doc =
            "euler_rates_xzx(angles, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rates of Euler angles about x, z, x from the angular velocity in the fixed frame.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "              omega (3): angular velocity\n"
            "  returns     theta_dot (3): rates of the Euler angles\n"
            "  verdict     holds under\n"
            "  assumes     sin(theta_2) != 0\n"
            "  operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine\n"
            "  error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 d60392e777e2f94766ccb4868d6a376f4b8f702f6466c7841c3f0e7493778009\n"
            "  signature   (3),(3)->(3)\n"
            "",
        .loops = { &chasles_euler_rates_xzx_loopf, &chasles_euler_rates_xzx_loop },
        .operands = { "angles", "omega", "theta_dot" },
    },
    {
        .name = "rotation_from_euler_xzy",
        .signature = "(3)->(3,3)",
        .doc =
            "rotation_from_euler_xzy(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rotation by Euler angles about x, z, y.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine\n"
            "  error bound 5.3 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 6a4fd734359cc43f74679d358abf691bfd6612dbcd721aa9a209c64050a5d383\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_euler_xzy_loopf, &chasles_rotation_from_euler_xzy_loop },
        .operands = { "angles", "Q" },
    },
    {
        .name = "euler_rate_matrix_xzy",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_xzy(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, z, y.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 f4bf5edc3a0e9199cc30c83f6cab51d6bfce7ab2a3d75f59608b337bed74824b\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_xzy_loopf, &chasles_euler_rate_matrix_xzy_loop },
        .operands = { "angles", "W" },
    },
    {
        .name = "euler_rate_matrix_body_xzy",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_body_xzy(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, z, y.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W_body (3, 3): angular velocity in the body frame from those rates\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 34b232afb99ddc1be46962d797e1c08bda20904a656a165ee2fc2232e4beec57\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_body_xzy_loopf, &chasles_euler_rate_matrix_body_xzy_loop },
        .operands = { "angles", "W_body" },
    },
    {
        .name = "euler_rates_xzy",
        .signature = "(3),(3)->(3)",
        .doc =
            "euler_rates_xzy(angles, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rates of Euler angles about x, z, y from the angular velocity in the fixed frame.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "              omega (3): angular velocity\n"
            "  returns     theta_dot (3): rates of the Euler angles\n"
            "  verdict     holds under\n"
            "  assumes     cos(theta_2) != 0\n"
            "  operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine\n"
            "  error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 47b386989c7014707637badfc0f665d8b17c2674e34c6dc85b34228d94dd802e\n"
            "  signature   (3),(3)->(3)\n"
            "",
        .loops = { &chasles_euler_rates_xzy_loopf, &chasles_euler_rates_xzy_loop },
        .operands = { "angles", "omega", "theta_dot" },
    },
    {
        .name = "rotation_from_euler_yxy",
        .signature = "(3)->(3,3)",
        .doc =
            "rotation_from_euler_yxy(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rotation by Euler angles about y, x, y.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine\n"
            "  error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 42de6926cd35f5c06da566065b065c8ba754cee65703557fa42410e42dde4a35\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_euler_yxy_loopf, &chasles_rotation_from_euler_yxy_loop },
        .operands = { "angles", "Q" },
    },
    {
        .name = "euler_rate_matrix_yxy",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_yxy(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, x, y.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 ab9e4f4d487ee038942cc83869848be5fa4c534a19c656164684f27e1b65ac10\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_yxy_loopf, &chasles_euler_rate_matrix_yxy_loop },
        .operands = { "angles", "W" },
    },
    {
        .name = "euler_rate_matrix_body_yxy",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_body_yxy(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, x, y.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W_body (3, 3): angular velocity in the body frame from those rates\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 2a86c48257dda6a27e84a7fb3b0817bd24bdff1a56c2bfeb6119d778d89bbab6\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_body_yxy_loopf, &chasles_euler_rate_matrix_body_yxy_loop },
        .operands = { "angles", "W_body" },
    },
    {
        .name = "euler_rates_yxy",
        .signature = "(3),(3)->(3)",
        .doc =
            "euler_rates_yxy(angles, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rates of Euler angles about y, x, y from the angular velocity in the fixed frame.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "              omega (3): angular velocity\n"
            "  returns     theta_dot (3): rates of the Euler angles\n"
            "  verdict     holds under\n"
            "  assumes     sin(theta_2) != 0\n"
            "  operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine\n"
            "  error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 8c7b412f940aadc89ad8c5ce3785c5c0ca8dcbf9e58aac6572334181799e61e2\n"
            "  signature   (3),(3)->(3)\n"
            "",
        .loops = { &chasles_euler_rates_yxy_loopf, &chasles_euler_rates_yxy_loop },
        .operands = { "angles", "omega", "theta_dot" },
    },
    {
        .name = "rotation_from_euler_yxz",
        .signature = "(3)->(3,3)",
        .doc =
            "rotation_from_euler_yxz(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rotation by Euler angles about y, x, z.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine\n"
            "  error bound 5.3 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 aac4d38f938bc0f3b21fc5113a3e553f105a0b99bd2a46001cf5af56197be36a\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_euler_yxz_loopf, &chasles_rotation_from_euler_yxz_loop },
        .operands = { "angles", "Q" },
    },
    {
        .name = "euler_rate_matrix_yxz",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_yxz(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, x, z.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 f673622637ac9520cdbbfacd9038ad6a42d7de01d522fe1daa4e4ed5a188d584\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_yxz_loopf, &chasles_euler_rate_matrix_yxz_loop },
        .operands = { "angles", "W" },
    },
    {
        .name = "euler_rate_matrix_body_yxz",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_body_yxz(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, x, z.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W_body (3, 3): angular velocity in the body frame from those rates\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 a7f0e1639e85f122dde538fce97f31e9e4f583cf9ea5d074345d45245ff26ea8\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_body_yxz_loopf, &chasles_euler_rate_matrix_body_yxz_loop },
        .operands = { "angles", "W_body" },
    },
    {
        .name = "euler_rates_yxz",
        .signature = "(3),(3)->(3)",
        .doc =
            "euler_rates_yxz(angles, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rates of Euler angles about y, x, z from the angular velocity in the fixed frame.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "              omega (3): angular velocity\n"
            "  returns     theta_dot (3): rates of the Euler angles\n"
            "  verdict     holds under\n"
            "  assumes     cos(theta_2) != 0\n"
            "  operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine\n"
            "  error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 bf11bed82696038fa225e27a75acb0d41b63af31adb0153ca5a712167c4d8284\n"
            "  signature   (3),(3)->(3)\n"
            "",
        .loops = { &chasles_euler_rates_yxz_loopf, &chasles_euler_rates_yxz_loop },
        .operands = { "angles", "omega", "theta_dot" },
    },
    {
        .name = "rotation_from_euler_yzx",
        .signature = "(3)->(3,3)",
        .doc =
            "rotation_from_euler_yzx(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rotation by Euler angles about y, z, x.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine\n"
            "  error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 73ccad1507926c77a4de1804d6ccee68b6eedcb0a87a5d797076c3aaa328556a\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_euler_yzx_loopf, &chasles_rotation_from_euler_yzx_loop },
        .operands = { "angles", "Q" },
    },
    {
        .name = "euler_rate_matrix_yzx",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_yzx(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, z, x.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 6bc14177fe8f581b737fd8108f75cca27c80f0c6043e24f8d305941c720fb93e\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_yzx_loopf, &chasles_euler_rate_matrix_yzx_loop },
        .operands = { "angles", "W" },
    },
    {
        .name = "euler_rate_matrix_body_yzx",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_body_yzx(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, z, x.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W_body (3, 3): angular velocity in the body frame from those rates\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 ba974c498d2395f78752b5b9af3bd25c9bc8814b82f34bc12080e7f58fc39384\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_body_yzx_loopf, &chasles_euler_rate_matrix_body_yzx_loop },
        .operands = { "angles", "W_body" },
    },
    {
        .name = "euler_rates_yzx",
        .signature = "(3),(3)->(3)",
        .doc =
            "euler_rates_yzx(angles, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rates of Euler angles about y, z, x from the angular velocity in the fixed frame.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "              omega (3): angular velocity\n"
            "  returns     theta_dot (3): rates of the Euler angles\n"
            "  verdict     holds under\n"
            "  assumes     cos(theta_2) != 0\n"
            "  operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine\n"
            "  error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 404a3dd7a9f43dbf16ca707d83946fda23f95d1982dc848908ed679160d5cc5f\n"
            "  signature   (3),(3)->(3)\n"
            "",
        .loops = { &chasles_euler_rates_yzx_loopf, &chasles_euler_rates_yzx_loop },
        .operands = { "angles", "omega", "theta_dot" },
    },
    {
        .name = "rotation_from_euler_yzy",
        .signature = "(3)->(3,3)",
        .doc =
            "rotation_from_euler_yzy(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rotation by Euler angles about y, z, y.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine\n"
            "  error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 fc249fbe7ecf26a2cf23c7eb4a1ae340b6f6d6b71fd0a11c005275bed3b0541a\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_euler_yzy_loopf, &chasles_rotation_from_euler_yzy_loop },
        .operands = { "angles", "Q" },
    },
    {
        .name = "euler_rate_matrix_yzy",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_yzy(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, z, y.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 ba3b9e2e5d19a42bcccf4fe889ac0ad5e1476885d7d3f35174490738c07caa93\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_yzy_loopf, &chasles_euler_rate_matrix_yzy_loop },
        .operands = { "angles", "W" },
    },
    {
        .name = "euler_rate_matrix_body_yzy",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_body_yzy(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, z, y.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W_body (3, 3): angular velocity in the body frame from those rates\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 2906ed860e470e86a10fba075e603a757d21feeb996fd012d6a5c352f1f248cf\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_body_yzy_loopf, &chasles_euler_rate_matrix_body_yzy_loop },
        .operands = { "angles", "W_body" },
    },
    {
        .name = "euler_rates_yzy",
        .signature = "(3),(3)->(3)",
        .doc =
            "euler_rates_yzy(angles, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rates of Euler angles about y, z, y from the angular velocity in the fixed frame.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "              omega (3): angular velocity\n"
            "  returns     theta_dot (3): rates of the Euler angles\n"
            "  verdict     holds under\n"
            "  assumes     sin(theta_2) != 0\n"
            "  operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine\n"
            "  error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 fbcf58ed5fb921bfdeae731af0d22be0b18c057d4ab3433941bb486f4f2ac07a\n"
            "  signature   (3),(3)->(3)\n"
            "",
        .loops = { &chasles_euler_rates_yzy_loopf, &chasles_euler_rates_yzy_loop },
        .operands = { "angles", "omega", "theta_dot" },
    },
    {
        .name = "rotation_from_euler_zxy",
        .signature = "(3)->(3,3)",
        .doc =
            "rotation_from_euler_zxy(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rotation by Euler angles about z, x, y.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine\n"
            "  error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 00df5b3e078a442b89ec92320b9be4d00f69c8c69b5377ceed30ce97167894d8\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_euler_zxy_loopf, &chasles_rotation_from_euler_zxy_loop },
        .operands = { "angles", "Q" },
    },
    {
        .name = "euler_rate_matrix_zxy",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_zxy(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, x, y.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 66b9e91ee2080f4af362adbd4cfbd2f6493f2d49f04e969606b8e5e66a892530\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_zxy_loopf, &chasles_euler_rate_matrix_zxy_loop },
        .operands = { "angles", "W" },
    },
    {
        .name = "euler_rate_matrix_body_zxy",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_body_zxy(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, x, y.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W_body (3, 3): angular velocity in the body frame from those rates\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 ee0e5dc36786ec147d7731e28a73445f4829a353e033fb0bdf99f16a9ae96d67\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_body_zxy_loopf, &chasles_euler_rate_matrix_body_zxy_loop },
        .operands = { "angles", "W_body" },
    },
    {
        .name = "euler_rates_zxy",
        .signature = "(3),(3)->(3)",
        .doc =
            "euler_rates_zxy(angles, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rates of Euler angles about z, x, y from the angular velocity in the fixed frame.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "              omega (3): angular velocity\n"
            "  returns     theta_dot (3): rates of the Euler angles\n"
            "  verdict     holds under\n"
            "  assumes     cos(theta_2) != 0\n"
            "  operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine\n"
            "  error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 f15319cb143e29fdad80688ea5d83794cf5328509c5cd1fb52fa078f77b2a785\n"
            "  signature   (3),(3)->(3)\n"
            "",
        .loops = { &chasles_euler_rates_zxy_loopf, &chasles_euler_rates_zxy_loop },
        .operands = { "angles", "omega", "theta_dot" },
    },
    {
        .name = "rotation_from_euler_zxz",
        .signature = "(3)->(3,3)",
        .doc =
            "rotation_from_euler_zxz(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rotation by Euler angles about z, x, z.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine\n"
            "  error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 90292a7b1973bd54561384a1b0aca95f4b081c5031f08a71f5bf1eeb509996f8\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_euler_zxz_loopf, &chasles_rotation_from_euler_zxz_loop },
        .operands = { "angles", "Q" },
    },
    {
        .name = "euler_rate_matrix_zxz",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_zxz(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, x, z.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 d6bac485f18ebb57e7adb1eb90896adee410e33308c5db55212969aa010526ee\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_zxz_loopf, &chasles_euler_rate_matrix_zxz_loop },
        .operands = { "angles", "W" },
    },
    {
        .name = "euler_rate_matrix_body_zxz",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_body_zxz(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, x, z.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W_body (3, 3): angular velocity in the body frame from those rates\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 22c895ea0aa33cf27a73432cf9b7edd645045c890d81351055832ab2e86d2ae0\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_body_zxz_loopf, &chasles_euler_rate_matrix_body_zxz_loop },
        .operands = { "angles", "W_body" },
    },
    {
        .name = "euler_rates_zxz",
        .signature = "(3),(3)->(3)",
        .doc =
            "euler_rates_zxz(angles, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rates of Euler angles about z, x, z from the angular velocity in the fixed frame.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "              omega (3): angular velocity\n"
            "  returns     theta_dot (3): rates of the Euler angles\n"
            "  verdict     holds under\n"
            "  assumes     sin(theta_2) != 0\n"
            "  operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine\n"
            "  error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 9730082636217a13ed6443b9376e26c825640305348e897e3b1e8d20d25ad893\n"
            "  signature   (3),(3)->(3)\n"
            "",
        .loops = { &chasles_euler_rates_zxz_loopf, &chasles_euler_rates_zxz_loop },
        .operands = { "angles", "omega", "theta_dot" },
    },
    {
        .name = "rotation_from_euler_zyx",
        .signature = "(3)->(3,3)",
        .doc =
            "rotation_from_euler_zyx(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rotation by Euler angles about z, y, x.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine\n"
            "  error bound 5.3 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 77eae5b015783de7dba57287593533e40a4bf6d57321c5d7151d36cf1a028acc\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_euler_zyx_loopf, &chasles_rotation_from_euler_zyx_loop },
        .operands = { "angles", "Q" },
    },
    {
        .name = "euler_rate_matrix_zyx",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_zyx(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, y, x.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 0adf0d7abfcbe1f817931814b81c15a9c846b1c73dcdb818878d86351c757b6d\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_zyx_loopf, &chasles_euler_rate_matrix_zyx_loop },
        .operands = { "angles", "W" },
    },
    {
        .name = "euler_rate_matrix_body_zyx",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_body_zyx(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, y, x.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W_body (3, 3): angular velocity in the body frame from those rates\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 6a7529b4dd785268409cc92077030a4cad8a64439e696ba9dfa305974e76a7df\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_body_zyx_loopf, &chasles_euler_rate_matrix_body_zyx_loop },
        .operands = { "angles", "W_body" },
    },
    {
        .name = "euler_rates_zyx",
        .signature = "(3),(3)->(3)",
        .doc =
            "euler_rates_zyx(angles, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rates of Euler angles about z, y, x from the angular velocity in the fixed frame.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "              omega (3): angular velocity\n"
            "  returns     theta_dot (3): rates of the Euler angles\n"
            "  verdict     holds under\n"
            "  assumes     cos(theta_2) != 0\n"
            "  operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine\n"
            "  error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 f6fb3a6381c9037e8d1dbd8e1df9c051262d4c72bd9738451555e59c302f0f09\n"
            "  signature   (3),(3)->(3)\n"
            "",
        .loops = { &chasles_euler_rates_zyx_loopf, &chasles_euler_rates_zyx_loop },
        .operands = { "angles", "omega", "theta_dot" },
    },
    {
        .name = "rotation_from_euler_zyz",
        .signature = "(3)->(3,3)",
        .doc =
            "rotation_from_euler_zyz(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rotation by Euler angles about z, y, z.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine\n"
            "  error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 35a70c6c05dd2903cd2f50766b4e415a63eb2ffed2c6d3e412124e8647c7b716\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_euler_zyz_loopf, &chasles_rotation_from_euler_zyz_loop },
        .operands = { "angles", "Q" },
    },
    {
        .name = "euler_rate_matrix_zyz",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_zyz(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, y, z.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W (3, 3): angular velocity in the fixed frame from the rates of the Euler angles\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 2df872f3e6c29262a9a735f3e6450ce704e08a1b40b33a555d7636f417131edb\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_zyz_loopf, &chasles_euler_rate_matrix_zyz_loop },
        .operands = { "angles", "W" },
    },
    {
        .name = "euler_rate_matrix_body_zyz",
        .signature = "(3)->(3,3)",
        .doc =
            "euler_rate_matrix_body_zyz(angles, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, y, z.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "  returns     W_body (3, 3): angular velocity in the body frame from those rates\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  6: 2 multiply, 2 sine, 2 cosine\n"
            "  error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 0e8fa3809441be1ebd1a102ce8fc5b78357d823973bbc7bac7e1da5c7ce38790\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_euler_rate_matrix_body_zyz_loopf, &chasles_euler_rate_matrix_body_zyz_loop },
        .operands = { "angles", "W_body" },
    },
    {
        .name = "euler_rates_zyz",
        .signature = "(3),(3)->(3)",
        .doc =
            "euler_rates_zyz(angles, omega, /, *, out=None)\n"
            "--\n"
            "\n"
            "Ex 3.10 The rates of Euler angles about z, y, z from the angular velocity in the fixed frame.\n"
            "  given       angles (3): Euler angles, in the order of the turns\n"
            "              omega (3): angular velocity\n"
            "  returns     theta_dot (3): rates of the Euler angles\n"
            "  verdict     holds under\n"
            "  assumes     sin(theta_2) != 0\n"
            "  operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine\n"
            "  error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision\n"
            "                2^-24\n"
            "              supposed: every operation rounded to nearest, with or without FMA, sine and cosine\n"
            "                within 0.8 ulp\n"
            "  derivation  sha256 c8e47ebca1883ce144424c202eb73e0d953be9339e55743f954ebc4ff9aaa9f5\n"
            "  signature   (3),(3)->(3)\n"
            "",
        .loops = { &chasles_euler_rates_zyz_loopf, &chasles_euler_rates_zyz_loop },
        .operands = { "angles", "omega", "theta_dot" },
    },
    {.name = NULL},
};

int chasles_level;

static const char *const levels[] = {"baseline", "x86-64-v3", "x86-64-v4"};

/* The types of a ufunc of n operands are the last n of the first and the first n of the second. */
static char types[2 * CHASLES_OPERANDS];

static void run(char **args, const npy_intp *dimensions, const npy_intp *steps, void *data)
{
    const chasles_loop *loop = data;
    const ptrdiff_t *moves = (const ptrdiff_t *)steps;
    chasles_run(loop, chasles_level, dimensions[0], args, moves, moves + loop->operands);
}

static PyUFuncGenericFunction runs[] = {run, run};

/* Sets the level: the best there is, or what the environment says; -1 with an exception set where it cannot be had. */
static int choose_level(void)
{
    const char *wanted = getenv("CHASLES_INSTRUCTIONS");
    const int best = chasles_best_level();
    if (wanted == NULL || *wanted == '\0') {
        chasles_level = best;
        return 0;
    }
    for (int level = 0; level <= best; level++) {
        if (strcmp(wanted, levels[level]) == 0) {
            chasles_level = level;
            return 0;
        }
    }
    PyErr_Format(
        PyExc_ImportError, "CHASLES_INSTRUCTIONS is '%s'; this build on this machine has %s%s%s%s%s", wanted, levels[0],
        best > 0 ? ", " : "", best > 0 ? levels[1] : "", best > 1 ? ", " : "", best > 1 ? levels[2] : "");
    return -1;
}

/* Adds the ufunc to the module and its name to `names`; -1 with an exception set where that fails. */
static int add(PyObject *module, PyObject *names, const Kernel *kernel)
{
    const chasles_loop *loop = kernel->loops[0];
    const char *end_of_call = "\n--\n\n", *doc = strstr(kernel->doc, end_of_call) + strlen(end_of_call);
    PyObject *ufunc = PyUFunc_FromFuncAndDataAndSignature(
        runs, (void **)kernel->loops, types + CHASLES_OPERANDS - loop->operands, 2, loop->inputs,
        loop->operands - loop->inputs, PyUFunc_None, kernel->name, doc, 0, kernel->signature);
    PyObject *name = PyUnicode_FromString(kernel->name);
    int status = -1;
    if (ufunc != NULL && name != NULL && PyModule_AddObjectRef(module, kernel->name, ufunc) == 0) {
        status = PyList_Append(names, name);
    }
    Py_XDECREF(ufunc);
    Py_XDECREF(name);
    return status;
}

static int fill(PyObject *module)
{
    if (PyArray_ImportNumPyAPI() < 0 || PyUFunc_ImportUFuncAPI() < 0 || choose_level() < 0) {
        return -1;
    }
    memset(types, NPY_FLOAT, CHASLES_OPERANDS);
    memset(types + CHASLES_OPERANDS, NPY_DOUBLE, CHASLES_OPERANDS);
    PyObject *names = PyList_New(0);
    PyObject *light = chasles_light_functions();
    int status = names == NULL || light == NULL ? -1 : 0;
    for (const Kernel *kernel = chasles_kernels; status == 0 && kernel->name != NULL; kernel++) {
        status = add(module, names, kernel);
    }
    if (status == 0) {
        status = PyModule_AddObjectRef(module, "__all__", names);
    }
    if (status == 0) {
        status = PyModule_AddObjectRef(module, "one", light);
    }
    if (status == 0) {
        status = PyModule_AddStringConstant(module, "instructions", levels[chasles_level]);
    }
    Py_XDECREF(names);
    Py_XDECREF(light);
    return status;
}

static PyModuleDef_Slot slots[] = {
    {Py_mod_exec, (void *)fill},
#ifdef Py_GIL_DISABLED
    {Py_mod_gil, Py_MOD_GIL_NOT_USED},
#endif
    {0, NULL},
};

static PyMethodDef methods[] = {
    {"make_ufunc", chasles_make_ufunc, METH_VARARGS,
     "make_ufunc(name, doc, signature, inputs, outputs, loop, data, data_of_double)\n\n"
     "The ufunc of the inner loop at the address `loop`, called with the one address for float32 and with the other for\n"
     "float64. What lies there must outlive the ufunc."},
    {"make_light", chasles_make_light, METH_VARARGS,
     "make_light(name, doc, operands, run, data, data_of_double)\n\n"
     "A function like those of `one`, of what the function at the address `run` computes, called with the one address\n"
     "for float32 and with the other for float64. What lies there must outlive it; `doc` begins as theirs do."},
    {NULL, NULL, 0, NULL},
};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT,
    .m_name = "_kernels",
    .m_doc = "Rigid-body kernels as generalised ufuncs. Made by `chasles emit`.",
    .m_methods = methods,
    .m_slots = slots,
};

PyMODINIT_FUNC PyInit__kernels(void)
{
    return PyModuleDef_Init(&definition);
}
