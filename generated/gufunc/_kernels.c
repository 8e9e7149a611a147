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
            "(2.38) The cross-product matrix of v: multiplying by it is taking the vector product with v.\n"
            "  given       v (3): any vector\n"
            "  returns     V (3, 3): cross-product matrix of a vector\n"
            "  verdict     defined\n"
            "  assumes     nothing\n"
            "  operations  0\n"
            "  derivation  sha256 0312c264dacf74dfcdb531a0b73d78f9f32811ece66c1d3463eee307878679e9\n"
            "  signature   (3)->(3,3)\n"
            "",
        .loops = { &chasles_cross_product_matrix_loopf, &chasles_cross_product_matrix_loop },
        .operands = { "v", "V" },
    },
    {
        .name = "rotation_from_axis_angle",
        .signature = "(3),()->(3,3)",
        .doc =
            "(2.49) The rotation about the axis e through the angle phi.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     defined\n"
            "  assumes     |e| = 1\n"
            "  operations  24: 6 add, 4 subtract, 12 multiply, 1 sine, 1 cosine\n"
            "  derivation  sha256 c07116d01fd9f3eec8b45e4fed312a9f9b8324ab6b8b43de598c12d93744c18c\n"
            "  signature   (3),()->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_axis_angle_loopf, &chasles_rotation_from_axis_angle_loop },
        .operands = { "e", "phi", "Q" },
    },
    {
        .name = "point_after_displacement",
        .signature = "(3,3),(3),(3),(3)->(3)",
        .doc =
            "(3.2) Where a point of the body lies after the displacement.\n"
            "  given       Q (3, 3): rotation\n"
            "              a (3): position of the landmark point A\n"
            "              a_prime (3): position of A after the displacement\n"
            "              p (3): position of any point P\n"
            "  returns     p_prime (3): position of P after the displacement\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  21: 9 add, 3 subtract, 9 multiply\n"
            "  derivation  sha256 b77ed46db033f7eed0ae1124f68ad31f483b7d8664bffaa4de83c9fc5b24f2ac\n"
            "  signature   (3,3),(3),(3),(3)->(3)\n"
            "",
        .loops = { &chasles_point_after_displacement_loopf, &chasles_point_after_displacement_loop },
        .operands = { "Q", "a", "a_prime", "p", "p_prime" },
    },
    {
        .name = "pitch_of_motion",
        .signature = "(3),(),(3)->()",
        .doc =
            "(3.7) The pitch from the displacement of any point.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              d_P (3): displacement of P\n"
            "  returns     result: d0 / phi\n"
            "  verdict     holds under\n"
            "  assumes     phi != 0\n"
            "              |e| = 1\n"
            "  operations  6: 2 add, 3 multiply, 1 divide\n"
            "  derivation  sha256 dd456a80abab27dec7bf7669b19bfc9e5e0a1d2b37fff41b4cf74a191918c756\n"
            "  signature   (3),(),(3)->()\n"
            "",
        .loops = { &chasles_pitch_of_motion_loopf, &chasles_pitch_of_motion_loop },
        .operands = { "e", "phi", "d_P", "result" },
    },
    {
        .name = "normal_matrix_inverse",
        .signature = "(3),()->(3,3)",
        .doc =
            "(3.16) The inverse of the matrix of the normal equations.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     result (3, 3): (A^T A)^-1\n"
            "  verdict     holds under\n"
            "  assumes     phi != 0\n"
            "              |e| = 1\n"
            "  operations  19: 3 add, 2 subtract, 11 multiply, 2 divide, 1 cosine\n"
            "  derivation  sha256 5ac2e58cb954695fb22629ed1368ffe7e286efef15ae1ae9e6c4f136f03b4fc3\n"
            "  signature   (3),()->(3,3)\n"
            "",
        .loops = { &chasles_normal_matrix_inverse_loopf, &chasles_normal_matrix_inverse_loop },
        .operands = { "e", "phi", "result" },
    },
    {
        .name = "screw_axis_point",
        .signature = "(3),(),(3),(3)->(3)",
        .doc =
            "(3.18) The point of the screw axis nearest the origin.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              a (3): position of the landmark point A\n"
            "              a_prime (3): position of A after the displacement\n"
            "  returns     p_0 (3): position of the point of the screw axis nearest the origin\n"
            "  verdict     holds under\n"
            "  assumes     phi != 0\n"
            "              |e| = 1\n"
            "  operations  64: 18 add, 10 subtract, 31 multiply, 3 divide, 1 sine, 1 cosine\n"
            "  derivation  sha256 8ec72961c7242876eb3f39769aa85197309a72737bed03662c26f5d342deb5dd\n"
            "  signature   (3),(),(3),(3)->(3)\n"
            "",
        .loops = { &chasles_screw_axis_point_loopf, &chasles_screw_axis_point_loop },
        .operands = { "e", "phi", "a", "a_prime", "p_0" },
    },
    {
        .name = "plucker_line",
        .signature = "(3),(3)->(6)",
        .doc =
            "(3.23) The Pl\303\274cker array of a line: its direction and its moment.\n"
            "  given       p_1 (3): position of point P_1\n"
            "              p_2 (3): position of point P_2\n"
            "  returns     kappa (6): Pluecker array: direction and moment\n"
            "  verdict     defined\n"
            "  assumes     p_1 != p_2\n"
            "  operations  21: 2 add, 6 subtract, 9 multiply, 3 divide, 1 square root\n"
            "  derivation  sha256 5a85da491dcc75a6b181adfb1d68308f6f9082d82d41f48451dd972e32090871\n"
            "  signature   (3),(3)->(6)\n"
            "",
        .loops = { &chasles_plucker_line_loopf, &chasles_plucker_line_loop },
        .operands = { "p_1", "p_2", "kappa" },
    },
    {
        .name = "plucker_transfer",
        .signature = "(6),(3),(3)->(6)",
        .doc =
            "(3.29a) The Pl\303\274cker-coordinate transfer formula.\n"
            "  given       kappa_A (6): Pluecker array with the moment about A\n"
            "              a (3): position of the landmark point A\n"
            "              b (3): position of point B\n"
            "  returns     kappa_B (6): Pluecker array with the moment about B\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  15: 3 add, 6 subtract, 6 multiply\n"
            "  derivation  sha256 223828bdc4a9d4093c744a6ff52678a900ce93b81e0164b035948d0874cac985\n"
            "  signature   (6),(3),(3)->(6)\n"
            "",
        .loops = { &chasles_plucker_transfer_loopf, &chasles_plucker_transfer_loop },
        .operands = { "kappa_A", "a", "b", "kappa_B" },
    },
    {
        .name = "rotation_in_triad_axes",
        .signature = "(3,3),(3,3)->(3,3)",
        .doc =
            "text 3.2.3 h The rotation in the axes of the triad, as a product of matrices.\n"
            "  given       triad (3, 3): the triad as columns\n"
            "              triad_prime (3, 3): the displaced triad as columns\n"
            "  returns     Q (3, 3): components of the rotation in the axes of the triad\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  45: 18 add, 27 multiply\n"
            "  derivation  sha256 611a8f0b6c25dd9d15645ced341e936a7b46e306abd4c88ba7f151c73170f2b7\n"
            "  signature   (3,3),(3,3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_in_triad_axes_loopf, &chasles_rotation_in_triad_axes_loop },
        .operands = { "triad", "triad_prime", "Q" },
    },
    {
        .name = "rotation_from_triads",
        .signature = "(3,3),(3,3)->(3,3)",
        .doc =
            "text 3.2.3 g The rotation that takes one triad into the other, in the frame in which both are given.\n"
            "  given       triad (3, 3): the triad as columns\n"
            "              triad_prime (3, 3): the displaced triad as columns\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     holds under\n"
            "  assumes     e_1, e_2, e_3 are orthonormal and right-handed\n"
            "  operations  45: 18 add, 27 multiply\n"
            "  derivation  sha256 d1a21d01da2012443d1a55e994887268f284c82c04bf89712cfcf42490ec03a4\n"
            "  signature   (3,3),(3,3)->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_triads_loopf, &chasles_rotation_from_triads_loop },
        .operands = { "triad", "triad_prime", "Q" },
    },
    {
        .name = "velocity_of_point",
        .signature = "(3),(3),(3),(3)->(3)",
        .doc =
            "(3.50) The velocity of a point from that of the landmark.\n"
            "  given       omega (3): angular velocity\n"
            "              a_dot (3): time derivative of: position of the landmark point A\n"
            "              a (3): position of the landmark point A\n"
            "              p (3): position of any point P\n"
            "  returns     p_dot (3): time derivative of: position of any point P\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  15: 3 add, 6 subtract, 6 multiply\n"
            "  derivation  sha256 22f0f01d1a02abc18f9574c08e8b9b427316b62ad07d3f9771f98896bece91a1\n"
            "  signature   (3),(3),(3),(3)->(3)\n"
            "",
        .loops = { &chasles_velocity_of_point_loopf, &chasles_velocity_of_point_loop },
        .operands = { "omega", "a_dot", "a", "p", "p_dot" },
    },
    {
        .name = "instant_screw_point",
        .signature = "(3),(3),(3)->(3)",
        .doc =
            "(3.70) The same with vector products.\n"
            "  given       omega (3): angular velocity\n"
            "              a_dot (3): time derivative of: position of the landmark point A\n"
            "              a (3): position of the landmark point A\n"
            "  returns     p_0_prime (3): position of the point of the instant screw axis nearest the origin\n"
            "  verdict     holds under\n"
            "  assumes     omega != 0\n"
            "  operations  29: 2 add, 9 subtract, 15 multiply, 3 divide\n"
            "  derivation  sha256 895661a438fba706f89d52a51bf6f4eb7433041efb58f67d2933e449bd8b4711\n"
            "  signature   (3),(3),(3)->(3)\n"
            "",
        .loops = { &chasles_instant_screw_point_loopf, &chasles_instant_screw_point_loop },
        .operands = { "omega", "a_dot", "a", "p_0_prime" },
    },
    {
        .name = "natural_rate_matrix",
        .signature = "(3),()->(4,3)",
        .doc =
            "(3.76b) The matrix of the natural invariants' rates.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     N (4, 3): natural invariants' rates from the angular velocity\n"
            "  verdict     defined\n"
            "  assumes     |e| = 1\n"
            "              phi != 0\n"
            "  operations  26: 3 add, 7 subtract, 13 multiply, 1 divide, 1 sine, 1 cosine\n"
            "  derivation  sha256 d1afff56486caa901f40463bd6490da7f0e507ea7be252aa239136060941d58a\n"
            "  signature   (3),()->(4,3)\n"
            "",
        .loops = { &chasles_natural_rate_matrix_loopf, &chasles_natural_rate_matrix_loop },
        .operands = { "e", "phi", "N" },
    },
    {
        .name = "linear_rate_matrix",
        .signature = "(3),()->(4,3)",
        .doc =
            "(3.76c) The matrix of the linear invariants' rates.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     L (4, 3): linear invariants' rates from the angular velocity\n"
            "  verdict     defined\n"
            "  assumes     |e| = 1\n"
            "  operations  39: 6 add, 8 subtract, 23 multiply, 1 sine, 1 cosine\n"
            "  derivation  sha256 3932af0d951f36376775451ce3a1ee43e73ece9dbe47180b18d5645998d83d28\n"
            "  signature   (3),()->(4,3)\n"
            "",
        .loops = { &chasles_linear_rate_matrix_loopf, &chasles_linear_rate_matrix_loop },
        .operands = { "e", "phi", "L" },
    },
    {
        .name = "euler_rodrigues_rate_matrix",
        .signature = "(3),()->(4,3)",
        .doc =
            "(3.76d) The matrix of the Euler-Rodrigues parameters' rates.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     H (4, 3): Euler-Rodrigues parameters' rates from the angular velocity\n"
            "  verdict     defined\n"
            "  assumes     |e| = 1\n"
            "  operations  8: 6 multiply, 1 sine, 1 cosine\n"
            "  derivation  sha256 3a735e68dbe0a8f64cc814f18a0e5c5ed23fe697bfaae80247e65c806f072dee\n"
            "  signature   (3),()->(4,3)\n"
            "",
        .loops = { &chasles_euler_rodrigues_rate_matrix_loopf, &chasles_euler_rodrigues_rate_matrix_loop },
        .operands = { "e", "phi", "H" },
    },
    {
        .name = "rotation_from_linear_invariants",
        .signature = "(3),()->(3,3)",
        .doc =
            "text 3.4.2 f The rotation from its linear invariants.\n"
            "  given       q (3): vector part of four invariants of the rotation\n"
            "              q_0: scalar part of four invariants of the rotation\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     holds under\n"
            "  assumes     phi != pi\n"
            "  operations  20: 7 add, 3 subtract, 9 multiply, 1 divide\n"
            "  derivation  sha256 6c875acb2742adb076485e3b75a69754af3515e24d15f1d3ff9dfbcee252fa0e\n"
            "  signature   (3),()->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_linear_invariants_loopf, &chasles_rotation_from_linear_invariants_loop },
        .operands = { "q", "q_0", "Q" },
    },
    {
        .name = "rotation_from_euler_rodrigues",
        .signature = "(3),()->(3,3)",
        .doc =
            "text 3.4.2 f The rotation from its Euler-Rodrigues parameters.\n"
            "  given       q (3): vector part of four invariants of the rotation\n"
            "              q_0: scalar part of four invariants of the rotation\n"
            "  returns     Q (3, 3): rotation\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  operations  29: 8 add, 4 subtract, 17 multiply\n"
            "  derivation  sha256 935e22e6e2702e8b1869ebd21a1a148db28b5400c4d4ba7831d8fae8467c7712\n"
            "  signature   (3),()->(3,3)\n"
            "",
        .loops = { &chasles_rotation_from_euler_rodrigues_loopf, &chasles_rotation_from_euler_rodrigues_loop },
        .operands = { "q", "q_0", "Q" },
    },
    {
        .name = "linear_invariants",
        .signature = "(3,3)->(3),()",
        .doc =
            "text 3.4.2 g The linear invariants from the rotation.\n"
            "  given       Q (3, 3): rotation\n"
            "  returns     q (3): vector part of four invariants of the rotation\n"
            "              q_0: scalar part of four invariants of the rotation\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  operations  10: 2 add, 4 subtract, 4 multiply\n"
            "  derivation  sha256 33d342698b1bbb0ed8e2b1fc28a50f559e7edf4004942693b00b69e15c4fa640\n"
            "  signature   (3,3)->(3),()\n"
            "",
        .loops = { &chasles_linear_invariants_loopf, &chasles_linear_invariants_loop },
        .operands = { "Q", "q", "q_0" },
    },
    {
        .name = "natural_invariants",
        .signature = "(3,3)->(3),()",
        .doc =
            "text 3.4.2 h The natural invariants from the rotation.\n"
            "  given       Q (3, 3): rotation\n"
            "  returns     e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  verdict     holds under\n"
            "  assumes     Q is a rotation\n"
            "  operations  67: 21 add, 10 subtract, 25 multiply, 5 divide, 5 square root, 1 arctangent2\n"
            "  derivation  sha256 693fae184fbad785f6c958322a55a428d4d2cf957b5b1ec9d427d14171059dc1\n"
            "  signature   (3,3)->(3),()\n"
            "",
        .loops = { &chasles_natural_invariants_loopf, &chasles_natural_invariants_loop },
        .operands = { "Q", "e", "phi" },
    },
    {
        .name = "euler_rodrigues_parameters",
        .signature = "(3,3)->(3),()",
        .doc =
            "text 3.4.2 i The Euler-Rodrigues parameters from the rotation.\n"
            "  given       Q (3, 3): rotation\n"
            "  returns     q (3): vector part of four invariants of the rotation\n"
            "              q_0: scalar part of four invariants of the rotation\n"
            "  verdict     holds under\n"
            "  assumes     Q is a rotation\n"
            "  operations  49: 21 add, 6 subtract, 17 multiply, 4 divide, 1 square root\n"
            "  derivation  sha256 c66522bc1222984921739ab7850dccccbf8fbbe1d8486421a7f4d56f7e8f0ed6\n"
            "  signature   (3,3)->(3),()\n"
            "",
        .loops = { &chasles_euler_rodrigues_parameters_loopf, &chasles_euler_rodrigues_parameters_loop },
        .operands = { "Q", "q", "q_0" },
    },
    {
        .name = "screw_of_motion",
        .signature = "(3,3),(3),(3)->(6),(),()",
        .doc =
            "text 3.4.2 j The screw of a motion: Pl\303\274cker array of its axis, translation along it, angle.\n"
            "  given       Q (3, 3): rotation\n"
            "              a (3): position of the landmark point A\n"
            "              a_prime (3): position of A after the displacement\n"
            "  returns     axis (6): [e; p_0 x e]\n"
            "              d_0: e . (a' - a)\n"
            "              phi: angle of rotation\n"
            "  verdict     holds under\n"
            "  assumes     Q is a rotation\n"
            "  operations  125: 35 add, 23 subtract, 53 multiply, 8 divide, 5 square root, 1 arctangent2\n"
            "  derivation  sha256 a921b326d86915c9921f28097282bb77dc3c75a0d6f0e7c5e31e928ffc828a06\n"
            "  signature   (3,3),(3),(3)->(6),(),()\n"
            "",
        .loops = { &chasles_screw_of_motion_loopf, &chasles_screw_of_motion_loop },
        .operands = { "Q", "a", "a_prime", "axis", "d_0", "phi" },
    },
    {
        .name = "instant_screw",
        .signature = "(3),(3),(3)->(6),()",
        .doc =
            "text 3.4.1 c The instant screw: Pl\303\274cker array of its axis, and pitch.\n"
            "  given       omega (3): angular velocity\n"
            "              a_dot (3): time derivative of: position of the landmark point A\n"
            "              a (3): position of the landmark point A\n"
            "  returns     axis (6): [e'; n']\n"
            "              pitch: pitch of the instant screw, in metres per radian\n"
            "  verdict     holds under\n"
            "  assumes     omega != 0\n"
            "  operations  48: 4 add, 12 subtract, 24 multiply, 7 divide, 1 square root\n"
            "  derivation  sha256 8db7e09eddaec370ad0459ae8e80d7446e066a7c7a50b64d1e58a04d14bf3409\n"
            "  signature   (3),(3),(3)->(6),()\n"
            "",
        .loops = { &chasles_instant_screw_loopf, &chasles_instant_screw_loop },
        .operands = { "omega", "a_dot", "a", "axis", "pitch" },
    },
    {
        .name = "natural_velocity_matrix",
        .signature = "(3),()->(3,4)",
        .doc =
            "(3.77b) The matrix that gives the angular velocity from the natural invariants' rates.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     N_tilde (3, 4): angular velocity from the natural invariants' rates\n"
            "  verdict     ill-formed as printed, defined as read\n"
            "  assumes     |e| = 1\n"
            "  operations  6: 1 subtract, 3 multiply, 1 sine, 1 cosine\n"
            "  derivation  sha256 4f53ceafce1dca350cbdb1d07bdf8034bfa4606e93e39373e34ca9e8e55d7ef2\n"
            "  signature   (3),()->(3,4)\n"
            "",
        .loops = { &chasles_natural_velocity_matrix_loopf, &chasles_natural_velocity_matrix_loop },
        .operands = { "e", "phi", "N_tilde" },
    },
    {
        .name = "linear_velocity_matrix",
        .signature = "(3),()->(3,4)",
        .doc =
            "(3.77c) The matrix that gives the angular velocity from the linear invariants' rates.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     L_tilde (3, 4): angular velocity from the linear invariants' rates\n"
            "  verdict     ill-formed as printed, defined as read\n"
            "  assumes     |e| = 1\n"
            "              phi != pi\n"
            "  operations  7: 1 add, 3 multiply, 1 divide, 1 sine, 1 cosine\n"
            "  derivation  sha256 e678fa61f2ca614341b1b520d453177cbb36d5adbe5d7bfc71cf23d916da1626\n"
            "  signature   (3),()->(3,4)\n"
            "",
        .loops = { &chasles_linear_velocity_matrix_loopf, &chasles_linear_velocity_matrix_loop },
        .operands = { "e", "phi", "L_tilde" },
    },
    {
        .name = "euler_rodrigues_velocity_matrix",
        .signature = "(3),()->(3,4)",
        .doc =
            "(3.77d) The matrix that gives the angular velocity from the Euler-Rodrigues parameters' rates.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "  returns     H_tilde (3, 4): angular velocity from the Euler-Rodrigues parameters' rates\n"
            "  verdict     ill-formed as printed, defined as read\n"
            "  assumes     |e| = 1\n"
            "  operations  8: 6 multiply, 1 sine, 1 cosine\n"
            "  derivation  sha256 49057ffb7954605c353481ff3155b854e23f59cd6c3eb25c530b76ce9a72408e\n"
            "  signature   (3),()->(3,4)\n"
            "",
        .loops = { &chasles_euler_rodrigues_velocity_matrix_loopf, &chasles_euler_rodrigues_velocity_matrix_loop },
        .operands = { "e", "phi", "H_tilde" },
    },
    {
        .name = "pose_rate_natural",
        .signature = "(3),(),(6)->(7)",
        .doc =
            "(3.78) The rate of the pose from the twist, with the natural invariants.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "  returns     s_dot (7): time derivative of: pose array\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "              phi != 0\n"
            "  operations  35: 2 add, 10 subtract, 20 multiply, 1 divide, 1 sine, 1 cosine\n"
            "  derivation  sha256 a45c42e2bfaa929db67370adbe054106e4220311d7cb3f6156f04276d0320465\n"
            "  signature   (3),(),(6)->(7)\n"
            "",
        .loops = { &chasles_pose_rate_natural_loopf, &chasles_pose_rate_natural_loop },
        .operands = { "e", "phi", "t", "s_dot" },
    },
    {
        .name = "pose_rate_linear",
        .signature = "(3),(),(6)->(7)",
        .doc =
            "(3.78) The rate of the pose from the twist, with the linear invariants.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "  returns     s_dot (7): time derivative of: pose array\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  operations  53: 7 add, 11 subtract, 33 multiply, 1 sine, 1 cosine\n"
            "  derivation  sha256 4cb4ee584c4c8eabc8772f8942b039808bd844366959cb05e5013b108a6a13b3\n"
            "  signature   (3),(),(6)->(7)\n"
            "",
        .loops = { &chasles_pose_rate_linear_loopf, &chasles_pose_rate_linear_loop },
        .operands = { "e", "phi", "t", "s_dot" },
    },
    {
        .name = "pose_rate_euler_rodrigues",
        .signature = "(3),(),(6)->(7)",
        .doc =
            "(3.78) The rate of the pose from the twist, with the Euler-Rodrigues parameters.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "  returns     s_dot (7): time derivative of: pose array\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  operations  28: 5 add, 3 subtract, 18 multiply, 1 sine, 1 cosine\n"
            "  derivation  sha256 ccca2d15e0eec02319f6d43a1e14916d4dc7aee6853dc302880ff46b704da961\n"
            "  signature   (3),(),(6)->(7)\n"
            "",
        .loops = { &chasles_pose_rate_euler_rodrigues_loopf, &chasles_pose_rate_euler_rodrigues_loop },
        .operands = { "e", "phi", "t", "s_dot" },
    },
    {
        .name = "twist_from_pose_rate_natural",
        .signature = "(3),(),(7)->(6)",
        .doc =
            "(3.80a) The twist from the rate of the pose, with the natural invariants.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              s_dot (7): time derivative of: pose array\n"
            "  returns     t (6): twist: angular velocity, velocity of a landmark point\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  operations  27: 6 add, 4 subtract, 15 multiply, 1 sine, 1 cosine\n"
            "  derivation  sha256 e7ecc39745f5c7fe863f4574b3d7db66237826b5cd6ef5ba62078dc2f87eb979\n"
            "  signature   (3),(),(7)->(6)\n"
            "",
        .loops = { &chasles_twist_from_pose_rate_natural_loopf, &chasles_twist_from_pose_rate_natural_loop },
        .operands = { "e", "phi", "s_dot", "t" },
    },
    {
        .name = "twist_from_pose_rate_linear",
        .signature = "(3),(),(7)->(6)",
        .doc =
            "(3.80a) The twist from the rate of the pose, with the linear invariants.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              s_dot (7): time derivative of: pose array\n"
            "  returns     t (6): twist: angular velocity, velocity of a landmark point\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "              phi != pi\n"
            "  operations  25: 4 add, 6 subtract, 12 multiply, 1 divide, 1 sine, 1 cosine\n"
            "  derivation  sha256 fa1304d2c5d6753e7d389022ed11c42daecd4c9ae21809318a87cd32029de36f\n"
            "  signature   (3),(),(7)->(6)\n"
            "",
        .loops = { &chasles_twist_from_pose_rate_linear_loopf, &chasles_twist_from_pose_rate_linear_loop },
        .operands = { "e", "phi", "s_dot", "t" },
    },
    {
        .name = "twist_from_pose_rate_euler_rodrigues",
        .signature = "(3),(),(7)->(6)",
        .doc =
            "(3.80a) The twist from the rate of the pose, with the Euler-Rodrigues parameters.\n"
            "  given       e (3): unit vector along the axis of rotation, or along a line\n"
            "              phi: angle of rotation\n"
            "              s_dot (7): time derivative of: pose array\n"
            "  returns     t (6): twist: angular velocity, velocity of a landmark point\n"
            "  verdict     holds under\n"
            "  assumes     |e| = 1\n"
            "  operations  29: 3 add, 6 subtract, 18 multiply, 1 sine, 1 cosine\n"
            "  derivation  sha256 e7f95cb1e1f8858232fa295001c353462018829181e53800500336674a222548\n"
            "  signature   (3),(),(7)->(6)\n"
            "",
        .loops = { &chasles_twist_from_pose_rate_euler_rodrigues_loopf, &chasles_twist_from_pose_rate_euler_rodrigues_loop },
        .operands = { "e", "phi", "s_dot", "t" },
    },
    {
        .name = "twist_transfer",
        .signature = "(6),(3),(3)->(6)",
        .doc =
            "(3.83a) The twist-transfer formula.\n"
            "  given       t_A (6): twist at A\n"
            "              a (3): position of the landmark point A\n"
            "              p (3): position of any point P\n"
            "  returns     t_P (6): twist at P\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  15: 3 add, 6 subtract, 6 multiply\n"
            "  derivation  sha256 967e7d1cf62d3815299774946eb2642eb91e46a3429c284829933f4e75e4e219\n"
            "  signature   (6),(3),(3)->(6)\n"
            "",
        .loops = { &chasles_twist_transfer_loopf, &chasles_twist_transfer_loop },
        .operands = { "t_A", "a", "p", "t_P" },
    },
    {
        .name = "angular_acceleration_matrix",
        .signature = "(3),(3)->(3,3)",
        .doc =
            "(3.86) The angular-acceleration matrix.\n"
            "  given       omega (3): angular velocity\n"
            "              omega_dot (3): time derivative of: angular velocity\n"
            "  returns     W (3, 3): angular-acceleration matrix\n"
            "  verdict     defined\n"
            "  assumes     Q is a rotation\n"
            "  operations  15: 6 add, 3 subtract, 6 multiply\n"
            "  derivation  sha256 9353bb16e90ad45c91a0cb2ecc494d929aa7746b83fe6af49af9df200dbbb47d\n"
            "  signature   (3),(3)->(3,3)\n"
            "",
        .loops = { &chasles_angular_acceleration_matrix_loopf, &chasles_angular_acceleration_matrix_loop },
        .operands = { "omega", "omega_dot", "W" },
    },
    {
        .name = "acceleration_of_point",
        .signature = "(3),(3),(3),(3),(3)->(3)",
        .doc =
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
            "  derivation  sha256 d86e77df283994951e7f23ec5c1e412135f31c7e3539b9cb228bb538b4e39021\n"
            "  signature   (3),(3),(3),(3),(3)->(3)\n"
            "",
        .loops = { &chasles_acceleration_of_point_loopf, &chasles_acceleration_of_point_loop },
        .operands = { "omega", "omega_dot", "a_ddot", "a", "p", "p_ddot" },
    },
    {
        .name = "moving_frame_velocity",
        .signature = "(3),(3,3),(3),(3),(3)->(3)",
        .doc =
            "(3.103) The velocity of P in the fixed frame from that in the moving frame.\n"
            "  given       o_dot (3): time derivative of: position of the origin of the moving frame\n"
            "              Q (3, 3): rotation\n"
            "              omega (3): angular velocity\n"
            "              rho (3): position of P in the moving frame\n"
            "              rho_dot (3): time derivative of: position of P in the moving frame\n"
            "  returns     p_dot (3): time derivative of: position of any point P\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  45: 18 add, 3 subtract, 24 multiply\n"
            "  derivation  sha256 7250d2e1f78a2d6f1161bc2db7ddeb5dc0c6fc84979f0eaa84197fdb6599dd36\n"
            "  signature   (3),(3,3),(3),(3),(3)->(3)\n"
            "",
        .loops = { &chasles_moving_frame_velocity_loopf, &chasles_moving_frame_velocity_loop },
        .operands = { "o_dot", "Q", "omega", "rho", "rho_dot", "p_dot" },
    },
    {
        .name = "moving_frame_acceleration",
        .signature = "(3),(3,3),(3),(3),(3),(3),(3)->(3)",
        .doc =
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
            "  operations  96: 30 add, 12 subtract, 54 multiply\n"
            "  derivation  sha256 fbd2b527f0f93f4cf924de6668a33e19726d1caade279c11a0d657fe9ec4e961\n"
            "  signature   (3),(3,3),(3),(3),(3),(3),(3)->(3)\n"
            "",
        .loops = { &chasles_moving_frame_acceleration_loopf, &chasles_moving_frame_acceleration_loop },
        .operands = { "o_ddot", "Q", "omega", "omega_dot", "rho", "rho_dot", "rho_ddot", "p_ddot" },
    },
    {
        .name = "wrench_axis",
        .signature = "(3),(3),(3)->(6),()",
        .doc =
            "text 3.7 d The axis and the pitch of the wrench.\n"
            "  given       f (3): resultant force\n"
            "              n_A (3): resultant moment about A\n"
            "              a (3): position of the landmark point A\n"
            "  returns     axis (6): [e''; n'']\n"
            "              pitch: pitch of the wrench, in metres per radian\n"
            "  verdict     holds under\n"
            "  assumes     f != 0\n"
            "  operations  49: 4 add, 12 subtract, 27 multiply, 5 divide, 1 square root\n"
            "  derivation  sha256 b1179904e05c970df60da3f9b180c2bce98c765bdb6795544ff955fce9c3d5bd\n"
            "  signature   (3),(3),(3)->(6),()\n"
            "",
        .loops = { &chasles_wrench_axis_loopf, &chasles_wrench_axis_loop },
        .operands = { "f", "n_A", "a", "axis", "pitch" },
    },
    {
        .name = "power",
        .signature = "(6),(6)->()",
        .doc =
            "(3.114) The power developed by a wrench on a body that moves with a twist at the same point.\n"
            "  given       t (6): twist: angular velocity, velocity of a landmark point\n"
            "              w (6): wrench: moment, force\n"
            "  returns     Pi: power developed by a wrench on a moving body\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  11: 5 add, 6 multiply\n"
            "  derivation  sha256 f08018ccded03ad1a1392a205f144588142ee91077c0ed0b4f636ec1d31e4312\n"
            "  signature   (6),(6)->()\n"
            "",
        .loops = { &chasles_power_loopf, &chasles_power_loop },
        .operands = { "t", "w", "Pi" },
    },
    {
        .name = "reciprocal_product",
        .signature = "(6),(6)->()",
        .doc =
            "text 3.7 k The reciprocal product of two screws, in either order.\n"
            "  given       s_w (6): screw of a wrench\n"
            "              s_t (6): screw of a twist\n"
            "  returns     product: s_t^T Gamma s_w\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  11: 5 add, 6 multiply\n"
            "  derivation  sha256 b087dfb5c9785b14414c4d9ab347a0bbefd48c42f8ad121de5653c94dd3546ee\n"
            "  signature   (6),(6)->()\n"
            "",
        .loops = { &chasles_reciprocal_product_loopf, &chasles_reciprocal_product_loop },
        .operands = { "s_w", "s_t", "product" },
    },
    {
        .name = "wrench_transfer",
        .signature = "(6),(3),(3)->(6)",
        .doc =
            "(3.119a) The wrench-transfer formula.\n"
            "  given       w_A (6): wrench at A\n"
            "              a (3): position of the landmark point A\n"
            "              p (3): position of any point P\n"
            "  returns     w_P (6): wrench at P\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  15: 3 add, 6 subtract, 6 multiply\n"
            "  derivation  sha256 9e54b67526c12869cc182865d5846fded980a863cc3a11fe5be4e32dc500f446\n"
            "  signature   (6),(3),(3)->(6)\n"
            "",
        .loops = { &chasles_wrench_transfer_loopf, &chasles_wrench_transfer_loop },
        .operands = { "w_A", "a", "p", "w_P" },
    },
    {
        .name = "inertia_about_point",
        .signature = "(3,3),(),(3),(3)->(3,3)",
        .doc =
            "(3.133a) Steiner's theorem: the moment of inertia with respect to A from that at the center of mass.\n"
            "  given       I_C (3, 3): moment of inertia at the center of mass\n"
            "              m: mass\n"
            "              c (3): position of the center of mass\n"
            "              a (3): position of the landmark point A\n"
            "  returns     I_A (3, 3): moment of inertia with respect to A\n"
            "  verdict     holds under\n"
            "  assumes     m > 0\n"
            "  operations  30: 5 add, 12 subtract, 13 multiply\n"
            "  derivation  sha256 35b7fb1caca5be1d4c908923193605bd9233355cd78eb729d55678f7bb61145f\n"
            "  signature   (3,3),(),(3),(3)->(3,3)\n"
            "",
        .loops = { &chasles_inertia_about_point_loopf, &chasles_inertia_about_point_loop },
        .operands = { "I_C", "m", "c", "a", "I_A" },
    },
    {
        .name = "momentum_screw",
        .signature = "(3,3),(),(6)->(6)",
        .doc =
            "(3.142) The momentum screw by inertia dyad and twist.\n"
            "  given       I_C (3, 3): moment of inertia at the center of mass\n"
            "              m: mass\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "  returns     mu (6): [I_C omega; m c_dot]\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  18: 6 add, 12 multiply\n"
            "  derivation  sha256 3f711409ddb1418e7a90bc97272fe9f055b83f10c9675ffa2beb8cf349541833\n"
            "  signature   (3,3),(),(6)->(6)\n"
            "",
        .loops = { &chasles_momentum_screw_loopf, &chasles_momentum_screw_loop },
        .operands = { "I_C", "m", "t", "mu" },
    },
    {
        .name = "kinetic_energy",
        .signature = "(3,3),(),(6)->()",
        .doc =
            "(3.145) The kinetic energy as a quadratic form of the twist.\n"
            "  given       I_C (3, 3): moment of inertia at the center of mass\n"
            "              m: mass\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "  returns     T: kinetic energy\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  35: 11 add, 24 multiply\n"
            "  derivation  sha256 bb5b9837baefa1606d49c0ac94dfc858eb46861f13739a02b972bfbdf0f95c37\n"
            "  signature   (3,3),(),(6)->()\n"
            "",
        .loops = { &chasles_kinetic_energy_loopf, &chasles_kinetic_energy_loop },
        .operands = { "I_C", "m", "t", "T" },
    },
    {
        .name = "newton_euler_wrench",
        .signature = "(3,3),(),(6),(6)->(6)",
        .doc =
            "text 3.8 v The wrench that moves the body: the Newton-Euler equations as they stand.\n"
            "  given       I_C (3, 3): moment of inertia at the center of mass\n"
            "              m: mass\n"
            "              t (6): twist: angular velocity, velocity of a landmark point\n"
            "              t_dot (6): time derivative of: twist: angular velocity, velocity of a landmark point\n"
            "  returns     w (6): wrench: moment, force\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  45: 15 add, 3 subtract, 27 multiply\n"
            "  derivation  sha256 cb1ef1c6a16cfa01894e6560676a00c850af7c3f6cce96e6448ca7f9626feaa7\n"
            "  signature   (3,3),(),(6),(6)->(6)\n"
            "",
        .loops = { &chasles_newton_euler_wrench_loopf, &chasles_newton_euler_wrench_loop },
        .operands = { "I_C", "m", "t", "t_dot", "w" },
    },
    {
        .name = "newton_euler_twist_rate",
        .signature = "(3,3),(),(6),(6)->(6)",
        .doc =
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
            "  operations  82: 14 add, 15 subtract, 51 multiply, 2 divide\n"
            "  derivation  sha256 64f80e87d5737068b3f0b9f4706feef6b9ff4e2cb5ab381a10697a6701ce84b5\n"
            "  signature   (3,3),(),(6),(6)->(6)\n"
            "",
        .loops = { &chasles_newton_euler_twist_rate_loopf, &chasles_newton_euler_twist_rate_loop },
        .operands = { "I_C", "m", "t", "w", "t_dot" },
    },
    {
        .name = "inertia_dyad",
        .signature = "(3,3),(),(3),(3)->(6,6)",
        .doc =
            "(3.147) The inertia dyad at A.\n"
            "  given       I_C (3, 3): moment of inertia at the center of mass\n"
            "              m: mass\n"
            "              c (3): position of the center of mass\n"
            "              a (3): position of the landmark point A\n"
            "  returns     M_A (6, 6): inertia dyad at A\n"
            "  verdict     holds\n"
            "  assumes     nothing\n"
            "  operations  30: 6 add, 9 subtract, 15 multiply\n"
            "  derivation  sha256 4bbf8c1406c8bc4f002bf283f170f926299c74c690fe95dd78dfef337d376991\n"
            "  signature   (3,3),(),(3),(3)->(6,6)\n"
            "",
        .loops = { &chasles_inertia_dyad_loopf, &chasles_inertia_dyad_loop },
        .operands = { "I_C", "m", "c", "a", "M_A" },
    },
    {.name = NULL},
};

int chasles_level;

static const char *const levels[] = {"baseline", "x86-64-v3"};

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
        PyExc_ImportError, "CHASLES_INSTRUCTIONS is '%s'; this build on this machine has %s%s%s", wanted, levels[0],
        best > 0 ? ", " : "", best > 0 ? levels[1] : "");
    return -1;
}

/* Adds the ufunc to the module and its name to `names`; -1 with an exception set where that fails. */
static int add(PyObject *module, PyObject *names, const Kernel *kernel)
{
    const chasles_loop *loop = kernel->loops[0];
    PyObject *ufunc = PyUFunc_FromFuncAndDataAndSignature(
        runs, (void **)kernel->loops, types + CHASLES_OPERANDS - loop->operands, 2, loop->inputs,
        loop->operands - loop->inputs, PyUFunc_None, kernel->name, kernel->doc, 0, kernel->signature);
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

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT,
    .m_name = "_kernels",
    .m_doc = "Rigid-body kernels as generalised ufuncs. Made by `chasles emit`.",
    .m_slots = slots,
};

PyMODINIT_FUNC PyInit__kernels(void)
{
    return PyModuleDef_Init(&definition);
}
