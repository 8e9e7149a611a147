/* Rigid-body kernels emitted from checked equations. Made by `chasles emit`; not to be edited by hand.
 *
 * C99; needs the standard library alone. Nothing is allocated, no state is kept, errno is not used.
 * A 3 x 3 matrix is 9 numbers, row by row. Angles are in radians, units are SI. A twist holds the angular part
 * first, a wrench the moment first.
 *
 * Scalars are passed by value, arrays by address, outputs last. All results are computed before any is stored, so
 * that an output may share storage with any input. What a function assumes of its inputs is not tested.
 *
 * NAMEf is NAME in single precision. NAME_batch and NAME_batchf compute `count` items: item i of x is at x + i * x_step,
 * the step in numbers, negative ones and 0 (the same item each time) included; between items nothing is read or
 * written. Outputs may lie over inputs of the same item and of earlier ones, not over those of later ones.
 *
 * Batches run on vector registers, with the best instructions that both the build and the machine have. An item's result
 * does not depend on its place in a batch, and it is bit for bit that of the function for one item, except for sines
 * and cosines, which a batch finds within 0.8 units in the last place. A batch leaves the floating-point state as it
 * was, but that FE_INVALID is raised where a result is NaN and no input of that item is.
 */
#ifndef CHASLES_H
#define CHASLES_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * (2.38) The cross-product matrix of v: multiplying by it is taking the vector product with v.
 *   given       v[3]: any vector
 *   returns     V[9]: cross-product matrix of a vector
 *   verdict     defined
 *   assumes     nothing
 *   operations  0
 *   derivation  sha256 0312c264dacf74dfcdb531a0b73d78f9f32811ece66c1d3463eee307878679e9
 */
void chasles_cross_product_matrix(const double v[3], double V[9]);
void chasles_cross_product_matrixf(const float v[3], float V[9]);
void chasles_cross_product_matrix_batch(
    size_t count,
    const double *v, ptrdiff_t v_step,
    double *V, ptrdiff_t V_step);
void chasles_cross_product_matrix_batchf(
    size_t count,
    const float *v, ptrdiff_t v_step,
    float *V, ptrdiff_t V_step);

/*
 * (2.49) The rotation about the axis e through the angle phi.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     |e| = 1
 *   operations  24: 6 add, 4 subtract, 12 multiply, 1 sine, 1 cosine
 *   derivation  sha256 c07116d01fd9f3eec8b45e4fed312a9f9b8324ab6b8b43de598c12d93744c18c
 */
void chasles_rotation_from_axis_angle(const double e[3], double phi, double Q[9]);
void chasles_rotation_from_axis_anglef(const float e[3], float phi, float Q[9]);
void chasles_rotation_from_axis_angle_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_axis_angle_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *Q, ptrdiff_t Q_step);

/*
 * (3.2) Where a point of the body lies after the displacement.
 *   given       Q[9]: rotation
 *               a[3]: position of the landmark point A
 *               a_prime[3]: position of A after the displacement
 *               p[3]: position of any point P
 *   returns     p_prime[3]: position of P after the displacement
 *   verdict     holds
 *   assumes     nothing
 *   operations  21: 9 add, 3 subtract, 9 multiply
 *   derivation  sha256 b77ed46db033f7eed0ae1124f68ad31f483b7d8664bffaa4de83c9fc5b24f2ac
 */
void chasles_point_after_displacement(
    const double Q[9],
    const double a[3],
    const double a_prime[3],
    const double p[3],
    double p_prime[3]);
void chasles_point_after_displacementf(
    const float Q[9],
    const float a[3],
    const float a_prime[3],
    const float p[3],
    float p_prime[3]);
void chasles_point_after_displacement_batch(
    size_t count,
    const double *Q, ptrdiff_t Q_step,
    const double *a, ptrdiff_t a_step,
    const double *a_prime, ptrdiff_t a_prime_step,
    const double *p, ptrdiff_t p_step,
    double *p_prime, ptrdiff_t p_prime_step);
void chasles_point_after_displacement_batchf(
    size_t count,
    const float *Q, ptrdiff_t Q_step,
    const float *a, ptrdiff_t a_step,
    const float *a_prime, ptrdiff_t a_prime_step,
    const float *p, ptrdiff_t p_step,
    float *p_prime, ptrdiff_t p_prime_step);

/*
 * (3.7) The pitch from the displacement of any point.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               d_P[3]: displacement of P
 *   returns     result: d0 / phi
 *   verdict     holds under
 *   assumes     phi != 0
 *               |e| = 1
 *   operations  6: 2 add, 3 multiply, 1 divide
 *   derivation  sha256 dd456a80abab27dec7bf7669b19bfc9e5e0a1d2b37fff41b4cf74a191918c756
 */
void chasles_pitch_of_motion(const double e[3], double phi, const double d_P[3], double *result);
void chasles_pitch_of_motionf(const float e[3], float phi, const float d_P[3], float *result);
void chasles_pitch_of_motion_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *d_P, ptrdiff_t d_P_step,
    double *result, ptrdiff_t result_step);
void chasles_pitch_of_motion_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *d_P, ptrdiff_t d_P_step,
    float *result, ptrdiff_t result_step);

/*
 * (3.16) The inverse of the matrix of the normal equations.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *   returns     result[9]: (A^T A)^-1
 *   verdict     holds under
 *   assumes     phi != 0
 *               |e| = 1
 *   operations  19: 3 add, 2 subtract, 11 multiply, 2 divide, 1 cosine
 *   derivation  sha256 5ac2e58cb954695fb22629ed1368ffe7e286efef15ae1ae9e6c4f136f03b4fc3
 */
void chasles_normal_matrix_inverse(const double e[3], double phi, double result[9]);
void chasles_normal_matrix_inversef(const float e[3], float phi, float result[9]);
void chasles_normal_matrix_inverse_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *result, ptrdiff_t result_step);
void chasles_normal_matrix_inverse_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *result, ptrdiff_t result_step);

/*
 * (3.18) The point of the screw axis nearest the origin.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               a[3]: position of the landmark point A
 *               a_prime[3]: position of A after the displacement
 *   returns     p_0[3]: position of the point of the screw axis nearest the origin
 *   verdict     holds under
 *   assumes     phi != 0
 *               |e| = 1
 *   operations  64: 18 add, 10 subtract, 31 multiply, 3 divide, 1 sine, 1 cosine
 *   derivation  sha256 8ec72961c7242876eb3f39769aa85197309a72737bed03662c26f5d342deb5dd
 */
void chasles_screw_axis_point(
    const double e[3],
    double phi,
    const double a[3],
    const double a_prime[3],
    double p_0[3]);
void chasles_screw_axis_pointf(
    const float e[3],
    float phi,
    const float a[3],
    const float a_prime[3],
    float p_0[3]);
void chasles_screw_axis_point_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *a, ptrdiff_t a_step,
    const double *a_prime, ptrdiff_t a_prime_step,
    double *p_0, ptrdiff_t p_0_step);
void chasles_screw_axis_point_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *a, ptrdiff_t a_step,
    const float *a_prime, ptrdiff_t a_prime_step,
    float *p_0, ptrdiff_t p_0_step);

/*
 * (3.23) The Plücker array of a line: its direction and its moment.
 *   given       p_1[3]: position of point P_1
 *               p_2[3]: position of point P_2
 *   returns     kappa[6]: Pluecker array: direction and moment
 *   verdict     defined
 *   assumes     p_1 != p_2
 *   operations  21: 2 add, 6 subtract, 9 multiply, 3 divide, 1 square root
 *   derivation  sha256 5a85da491dcc75a6b181adfb1d68308f6f9082d82d41f48451dd972e32090871
 */
void chasles_plucker_line(const double p_1[3], const double p_2[3], double kappa[6]);
void chasles_plucker_linef(const float p_1[3], const float p_2[3], float kappa[6]);
void chasles_plucker_line_batch(
    size_t count,
    const double *p_1, ptrdiff_t p_1_step,
    const double *p_2, ptrdiff_t p_2_step,
    double *kappa, ptrdiff_t kappa_step);
void chasles_plucker_line_batchf(
    size_t count,
    const float *p_1, ptrdiff_t p_1_step,
    const float *p_2, ptrdiff_t p_2_step,
    float *kappa, ptrdiff_t kappa_step);

/*
 * (3.29a) The Plücker-coordinate transfer formula.
 *   given       kappa_A[6]: Pluecker array with the moment about A
 *               a[3]: position of the landmark point A
 *               b[3]: position of point B
 *   returns     kappa_B[6]: Pluecker array with the moment about B
 *   verdict     holds
 *   assumes     nothing
 *   operations  15: 3 add, 6 subtract, 6 multiply
 *   derivation  sha256 223828bdc4a9d4093c744a6ff52678a900ce93b81e0164b035948d0874cac985
 */
void chasles_plucker_transfer(
    const double kappa_A[6],
    const double a[3],
    const double b[3],
    double kappa_B[6]);
void chasles_plucker_transferf(
    const float kappa_A[6],
    const float a[3],
    const float b[3],
    float kappa_B[6]);
void chasles_plucker_transfer_batch(
    size_t count,
    const double *kappa_A, ptrdiff_t kappa_A_step,
    const double *a, ptrdiff_t a_step,
    const double *b, ptrdiff_t b_step,
    double *kappa_B, ptrdiff_t kappa_B_step);
void chasles_plucker_transfer_batchf(
    size_t count,
    const float *kappa_A, ptrdiff_t kappa_A_step,
    const float *a, ptrdiff_t a_step,
    const float *b, ptrdiff_t b_step,
    float *kappa_B, ptrdiff_t kappa_B_step);

/*
 * text 3.2.3 h The rotation in the axes of the triad, as a product of matrices.
 *   given       triad[9]: the triad as columns
 *               triad_prime[9]: the displaced triad as columns
 *   returns     Q[9]: components of the rotation in the axes of the triad
 *   verdict     holds
 *   assumes     nothing
 *   operations  45: 18 add, 27 multiply
 *   derivation  sha256 611a8f0b6c25dd9d15645ced341e936a7b46e306abd4c88ba7f151c73170f2b7
 */
void chasles_rotation_in_triad_axes(const double triad[9], const double triad_prime[9], double Q[9]);
void chasles_rotation_in_triad_axesf(const float triad[9], const float triad_prime[9], float Q[9]);
void chasles_rotation_in_triad_axes_batch(
    size_t count,
    const double *triad, ptrdiff_t triad_step,
    const double *triad_prime, ptrdiff_t triad_prime_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_in_triad_axes_batchf(
    size_t count,
    const float *triad, ptrdiff_t triad_step,
    const float *triad_prime, ptrdiff_t triad_prime_step,
    float *Q, ptrdiff_t Q_step);

/*
 * text 3.2.3 g The rotation that takes one triad into the other, in the frame in which both are given.
 *   given       triad[9]: the triad as columns
 *               triad_prime[9]: the displaced triad as columns
 *   returns     Q[9]: rotation
 *   verdict     holds under
 *   assumes     e_1, e_2, e_3 are orthonormal and right-handed
 *   operations  45: 18 add, 27 multiply
 *   derivation  sha256 d1a21d01da2012443d1a55e994887268f284c82c04bf89712cfcf42490ec03a4
 */
void chasles_rotation_from_triads(const double triad[9], const double triad_prime[9], double Q[9]);
void chasles_rotation_from_triadsf(const float triad[9], const float triad_prime[9], float Q[9]);
void chasles_rotation_from_triads_batch(
    size_t count,
    const double *triad, ptrdiff_t triad_step,
    const double *triad_prime, ptrdiff_t triad_prime_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_triads_batchf(
    size_t count,
    const float *triad, ptrdiff_t triad_step,
    const float *triad_prime, ptrdiff_t triad_prime_step,
    float *Q, ptrdiff_t Q_step);

/*
 * (3.50) The velocity of a point from that of the landmark.
 *   given       omega[3]: angular velocity
 *               a_dot[3]: time derivative of: position of the landmark point A
 *               a[3]: position of the landmark point A
 *               p[3]: position of any point P
 *   returns     p_dot[3]: time derivative of: position of any point P
 *   verdict     holds
 *   assumes     nothing
 *   operations  15: 3 add, 6 subtract, 6 multiply
 *   derivation  sha256 22f0f01d1a02abc18f9574c08e8b9b427316b62ad07d3f9771f98896bece91a1
 */
void chasles_velocity_of_point(
    const double omega[3],
    const double a_dot[3],
    const double a[3],
    const double p[3],
    double p_dot[3]);
void chasles_velocity_of_pointf(
    const float omega[3],
    const float a_dot[3],
    const float a[3],
    const float p[3],
    float p_dot[3]);
void chasles_velocity_of_point_batch(
    size_t count,
    const double *omega, ptrdiff_t omega_step,
    const double *a_dot, ptrdiff_t a_dot_step,
    const double *a, ptrdiff_t a_step,
    const double *p, ptrdiff_t p_step,
    double *p_dot, ptrdiff_t p_dot_step);
void chasles_velocity_of_point_batchf(
    size_t count,
    const float *omega, ptrdiff_t omega_step,
    const float *a_dot, ptrdiff_t a_dot_step,
    const float *a, ptrdiff_t a_step,
    const float *p, ptrdiff_t p_step,
    float *p_dot, ptrdiff_t p_dot_step);

/*
 * (3.70) The same with vector products.
 *   given       omega[3]: angular velocity
 *               a_dot[3]: time derivative of: position of the landmark point A
 *               a[3]: position of the landmark point A
 *   returns     p_0_prime[3]: position of the point of the instant screw axis nearest the origin
 *   verdict     holds under
 *   assumes     omega != 0
 *   operations  29: 2 add, 9 subtract, 15 multiply, 3 divide
 *   derivation  sha256 895661a438fba706f89d52a51bf6f4eb7433041efb58f67d2933e449bd8b4711
 */
void chasles_instant_screw_point(
    const double omega[3],
    const double a_dot[3],
    const double a[3],
    double p_0_prime[3]);
void chasles_instant_screw_pointf(
    const float omega[3],
    const float a_dot[3],
    const float a[3],
    float p_0_prime[3]);
void chasles_instant_screw_point_batch(
    size_t count,
    const double *omega, ptrdiff_t omega_step,
    const double *a_dot, ptrdiff_t a_dot_step,
    const double *a, ptrdiff_t a_step,
    double *p_0_prime, ptrdiff_t p_0_prime_step);
void chasles_instant_screw_point_batchf(
    size_t count,
    const float *omega, ptrdiff_t omega_step,
    const float *a_dot, ptrdiff_t a_dot_step,
    const float *a, ptrdiff_t a_step,
    float *p_0_prime, ptrdiff_t p_0_prime_step);

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
void chasles_natural_rate_matrix(const double e[3], double phi, double N[12]);
void chasles_natural_rate_matrixf(const float e[3], float phi, float N[12]);
void chasles_natural_rate_matrix_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *N, ptrdiff_t N_step);
void chasles_natural_rate_matrix_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *N, ptrdiff_t N_step);

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
void chasles_linear_rate_matrix(const double e[3], double phi, double L[12]);
void chasles_linear_rate_matrixf(const float e[3], float phi, float L[12]);
void chasles_linear_rate_matrix_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *L, ptrdiff_t L_step);
void chasles_linear_rate_matrix_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *L, ptrdiff_t L_step);

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
void chasles_euler_rodrigues_rate_matrix(const double e[3], double phi, double H[12]);
void chasles_euler_rodrigues_rate_matrixf(const float e[3], float phi, float H[12]);
void chasles_euler_rodrigues_rate_matrix_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *H, ptrdiff_t H_step);
void chasles_euler_rodrigues_rate_matrix_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *H, ptrdiff_t H_step);

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
void chasles_rotation_from_linear_invariants(const double q[3], double q_0, double Q[9]);
void chasles_rotation_from_linear_invariantsf(const float q[3], float q_0, float Q[9]);
void chasles_rotation_from_linear_invariants_batch(
    size_t count,
    const double *q, ptrdiff_t q_step,
    const double *q_0, ptrdiff_t q_0_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_linear_invariants_batchf(
    size_t count,
    const float *q, ptrdiff_t q_step,
    const float *q_0, ptrdiff_t q_0_step,
    float *Q, ptrdiff_t Q_step);

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
void chasles_rotation_from_euler_rodrigues(const double q[3], double q_0, double Q[9]);
void chasles_rotation_from_euler_rodriguesf(const float q[3], float q_0, float Q[9]);
void chasles_rotation_from_euler_rodrigues_batch(
    size_t count,
    const double *q, ptrdiff_t q_step,
    const double *q_0, ptrdiff_t q_0_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_euler_rodrigues_batchf(
    size_t count,
    const float *q, ptrdiff_t q_step,
    const float *q_0, ptrdiff_t q_0_step,
    float *Q, ptrdiff_t Q_step);

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
void chasles_linear_invariants(const double Q[9], double q[3], double *q_0);
void chasles_linear_invariantsf(const float Q[9], float q[3], float *q_0);
void chasles_linear_invariants_batch(
    size_t count,
    const double *Q, ptrdiff_t Q_step,
    double *q, ptrdiff_t q_step,
    double *q_0, ptrdiff_t q_0_step);
void chasles_linear_invariants_batchf(
    size_t count,
    const float *Q, ptrdiff_t Q_step,
    float *q, ptrdiff_t q_step,
    float *q_0, ptrdiff_t q_0_step);

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
void chasles_natural_invariants(const double Q[9], double e[3], double *phi);
void chasles_natural_invariantsf(const float Q[9], float e[3], float *phi);
void chasles_natural_invariants_batch(
    size_t count,
    const double *Q, ptrdiff_t Q_step,
    double *e, ptrdiff_t e_step,
    double *phi, ptrdiff_t phi_step);
void chasles_natural_invariants_batchf(
    size_t count,
    const float *Q, ptrdiff_t Q_step,
    float *e, ptrdiff_t e_step,
    float *phi, ptrdiff_t phi_step);

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
void chasles_euler_rodrigues_parameters(const double Q[9], double q[3], double *q_0);
void chasles_euler_rodrigues_parametersf(const float Q[9], float q[3], float *q_0);
void chasles_euler_rodrigues_parameters_batch(
    size_t count,
    const double *Q, ptrdiff_t Q_step,
    double *q, ptrdiff_t q_step,
    double *q_0, ptrdiff_t q_0_step);
void chasles_euler_rodrigues_parameters_batchf(
    size_t count,
    const float *Q, ptrdiff_t Q_step,
    float *q, ptrdiff_t q_step,
    float *q_0, ptrdiff_t q_0_step);

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
    double *phi);
void chasles_screw_of_motionf(
    const float Q[9],
    const float a[3],
    const float a_prime[3],
    float axis[6],
    float *d_0,
    float *phi);
void chasles_screw_of_motion_batch(
    size_t count,
    const double *Q, ptrdiff_t Q_step,
    const double *a, ptrdiff_t a_step,
    const double *a_prime, ptrdiff_t a_prime_step,
    double *axis, ptrdiff_t axis_step,
    double *d_0, ptrdiff_t d_0_step,
    double *phi, ptrdiff_t phi_step);
void chasles_screw_of_motion_batchf(
    size_t count,
    const float *Q, ptrdiff_t Q_step,
    const float *a, ptrdiff_t a_step,
    const float *a_prime, ptrdiff_t a_prime_step,
    float *axis, ptrdiff_t axis_step,
    float *d_0, ptrdiff_t d_0_step,
    float *phi, ptrdiff_t phi_step);

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
    double *pitch);
void chasles_instant_screwf(
    const float omega[3],
    const float a_dot[3],
    const float a[3],
    float axis[6],
    float *pitch);
void chasles_instant_screw_batch(
    size_t count,
    const double *omega, ptrdiff_t omega_step,
    const double *a_dot, ptrdiff_t a_dot_step,
    const double *a, ptrdiff_t a_step,
    double *axis, ptrdiff_t axis_step,
    double *pitch, ptrdiff_t pitch_step);
void chasles_instant_screw_batchf(
    size_t count,
    const float *omega, ptrdiff_t omega_step,
    const float *a_dot, ptrdiff_t a_dot_step,
    const float *a, ptrdiff_t a_step,
    float *axis, ptrdiff_t axis_step,
    float *pitch, ptrdiff_t pitch_step);

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
void chasles_natural_velocity_matrix(const double e[3], double phi, double N_tilde[12]);
void chasles_natural_velocity_matrixf(const float e[3], float phi, float N_tilde[12]);
void chasles_natural_velocity_matrix_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *N_tilde, ptrdiff_t N_tilde_step);
void chasles_natural_velocity_matrix_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *N_tilde, ptrdiff_t N_tilde_step);

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
void chasles_linear_velocity_matrix(const double e[3], double phi, double L_tilde[12]);
void chasles_linear_velocity_matrixf(const float e[3], float phi, float L_tilde[12]);
void chasles_linear_velocity_matrix_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *L_tilde, ptrdiff_t L_tilde_step);
void chasles_linear_velocity_matrix_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *L_tilde, ptrdiff_t L_tilde_step);

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
void chasles_euler_rodrigues_velocity_matrix(const double e[3], double phi, double H_tilde[12]);
void chasles_euler_rodrigues_velocity_matrixf(const float e[3], float phi, float H_tilde[12]);
void chasles_euler_rodrigues_velocity_matrix_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    double *H_tilde, ptrdiff_t H_tilde_step);
void chasles_euler_rodrigues_velocity_matrix_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    float *H_tilde, ptrdiff_t H_tilde_step);

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
void chasles_pose_rate_natural(const double e[3], double phi, const double t[6], double s_dot[7]);
void chasles_pose_rate_naturalf(const float e[3], float phi, const float t[6], float s_dot[7]);
void chasles_pose_rate_natural_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *t, ptrdiff_t t_step,
    double *s_dot, ptrdiff_t s_dot_step);
void chasles_pose_rate_natural_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *t, ptrdiff_t t_step,
    float *s_dot, ptrdiff_t s_dot_step);

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
void chasles_pose_rate_linear(const double e[3], double phi, const double t[6], double s_dot[7]);
void chasles_pose_rate_linearf(const float e[3], float phi, const float t[6], float s_dot[7]);
void chasles_pose_rate_linear_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *t, ptrdiff_t t_step,
    double *s_dot, ptrdiff_t s_dot_step);
void chasles_pose_rate_linear_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *t, ptrdiff_t t_step,
    float *s_dot, ptrdiff_t s_dot_step);

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
    double s_dot[7]);
void chasles_pose_rate_euler_rodriguesf(
    const float e[3],
    float phi,
    const float t[6],
    float s_dot[7]);
void chasles_pose_rate_euler_rodrigues_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *t, ptrdiff_t t_step,
    double *s_dot, ptrdiff_t s_dot_step);
void chasles_pose_rate_euler_rodrigues_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *t, ptrdiff_t t_step,
    float *s_dot, ptrdiff_t s_dot_step);

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
    double t[6]);
void chasles_twist_from_pose_rate_naturalf(
    const float e[3],
    float phi,
    const float s_dot[7],
    float t[6]);
void chasles_twist_from_pose_rate_natural_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *s_dot, ptrdiff_t s_dot_step,
    double *t, ptrdiff_t t_step);
void chasles_twist_from_pose_rate_natural_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *s_dot, ptrdiff_t s_dot_step,
    float *t, ptrdiff_t t_step);

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
    double t[6]);
void chasles_twist_from_pose_rate_linearf(
    const float e[3],
    float phi,
    const float s_dot[7],
    float t[6]);
void chasles_twist_from_pose_rate_linear_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *s_dot, ptrdiff_t s_dot_step,
    double *t, ptrdiff_t t_step);
void chasles_twist_from_pose_rate_linear_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *s_dot, ptrdiff_t s_dot_step,
    float *t, ptrdiff_t t_step);

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
    double t[6]);
void chasles_twist_from_pose_rate_euler_rodriguesf(
    const float e[3],
    float phi,
    const float s_dot[7],
    float t[6]);
void chasles_twist_from_pose_rate_euler_rodrigues_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *s_dot, ptrdiff_t s_dot_step,
    double *t, ptrdiff_t t_step);
void chasles_twist_from_pose_rate_euler_rodrigues_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *s_dot, ptrdiff_t s_dot_step,
    float *t, ptrdiff_t t_step);

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
    double t_P[6]);
void chasles_twist_transferf(const float t_A[6], const float a[3], const float p[3], float t_P[6]);
void chasles_twist_transfer_batch(
    size_t count,
    const double *t_A, ptrdiff_t t_A_step,
    const double *a, ptrdiff_t a_step,
    const double *p, ptrdiff_t p_step,
    double *t_P, ptrdiff_t t_P_step);
void chasles_twist_transfer_batchf(
    size_t count,
    const float *t_A, ptrdiff_t t_A_step,
    const float *a, ptrdiff_t a_step,
    const float *p, ptrdiff_t p_step,
    float *t_P, ptrdiff_t t_P_step);

/*
 * (3.86) The angular-acceleration matrix.
 *   given       omega[3]: angular velocity
 *               omega_dot[3]: time derivative of: angular velocity
 *   returns     W[9]: angular-acceleration matrix
 *   verdict     defined
 *   assumes     Q is a rotation
 *   operations  15: 6 add, 3 subtract, 6 multiply
 *   derivation  sha256 9353bb16e90ad45c91a0cb2ecc494d929aa7746b83fe6af49af9df200dbbb47d
 */
void chasles_angular_acceleration_matrix(
    const double omega[3],
    const double omega_dot[3],
    double W[9]);
void chasles_angular_acceleration_matrixf(
    const float omega[3],
    const float omega_dot[3],
    float W[9]);
void chasles_angular_acceleration_matrix_batch(
    size_t count,
    const double *omega, ptrdiff_t omega_step,
    const double *omega_dot, ptrdiff_t omega_dot_step,
    double *W, ptrdiff_t W_step);
void chasles_angular_acceleration_matrix_batchf(
    size_t count,
    const float *omega, ptrdiff_t omega_step,
    const float *omega_dot, ptrdiff_t omega_dot_step,
    float *W, ptrdiff_t W_step);

/*
 * (3.89) The acceleration of a point from that of the landmark, with vector products.
 *   given       omega[3]: angular velocity
 *               omega_dot[3]: time derivative of: angular velocity
 *               a_ddot[3]: second time derivative of: position of the landmark point A
 *               a[3]: position of the landmark point A
 *               p[3]: position of any point P
 *   returns     p_ddot[3]: second time derivative of: position of any point P
 *   verdict     holds
 *   assumes     nothing
 *   operations  36: 6 add, 12 subtract, 18 multiply
 *   derivation  sha256 d86e77df283994951e7f23ec5c1e412135f31c7e3539b9cb228bb538b4e39021
 */
void chasles_acceleration_of_point(
    const double omega[3],
    const double omega_dot[3],
    const double a_ddot[3],
    const double a[3],
    const double p[3],
    double p_ddot[3]);
void chasles_acceleration_of_pointf(
    const float omega[3],
    const float omega_dot[3],
    const float a_ddot[3],
    const float a[3],
    const float p[3],
    float p_ddot[3]);
void chasles_acceleration_of_point_batch(
    size_t count,
    const double *omega, ptrdiff_t omega_step,
    const double *omega_dot, ptrdiff_t omega_dot_step,
    const double *a_ddot, ptrdiff_t a_ddot_step,
    const double *a, ptrdiff_t a_step,
    const double *p, ptrdiff_t p_step,
    double *p_ddot, ptrdiff_t p_ddot_step);
void chasles_acceleration_of_point_batchf(
    size_t count,
    const float *omega, ptrdiff_t omega_step,
    const float *omega_dot, ptrdiff_t omega_dot_step,
    const float *a_ddot, ptrdiff_t a_ddot_step,
    const float *a, ptrdiff_t a_step,
    const float *p, ptrdiff_t p_step,
    float *p_ddot, ptrdiff_t p_ddot_step);

/*
 * (3.103) The velocity of P in the fixed frame from that in the moving frame.
 *   given       o_dot[3]: time derivative of: position of the origin of the moving frame
 *               Q[9]: rotation
 *               omega[3]: angular velocity
 *               rho[3]: position of P in the moving frame
 *               rho_dot[3]: time derivative of: position of P in the moving frame
 *   returns     p_dot[3]: time derivative of: position of any point P
 *   verdict     holds
 *   assumes     nothing
 *   operations  45: 18 add, 3 subtract, 24 multiply
 *   derivation  sha256 7250d2e1f78a2d6f1161bc2db7ddeb5dc0c6fc84979f0eaa84197fdb6599dd36
 */
void chasles_moving_frame_velocity(
    const double o_dot[3],
    const double Q[9],
    const double omega[3],
    const double rho[3],
    const double rho_dot[3],
    double p_dot[3]);
void chasles_moving_frame_velocityf(
    const float o_dot[3],
    const float Q[9],
    const float omega[3],
    const float rho[3],
    const float rho_dot[3],
    float p_dot[3]);
void chasles_moving_frame_velocity_batch(
    size_t count,
    const double *o_dot, ptrdiff_t o_dot_step,
    const double *Q, ptrdiff_t Q_step,
    const double *omega, ptrdiff_t omega_step,
    const double *rho, ptrdiff_t rho_step,
    const double *rho_dot, ptrdiff_t rho_dot_step,
    double *p_dot, ptrdiff_t p_dot_step);
void chasles_moving_frame_velocity_batchf(
    size_t count,
    const float *o_dot, ptrdiff_t o_dot_step,
    const float *Q, ptrdiff_t Q_step,
    const float *omega, ptrdiff_t omega_step,
    const float *rho, ptrdiff_t rho_step,
    const float *rho_dot, ptrdiff_t rho_dot_step,
    float *p_dot, ptrdiff_t p_dot_step);

/*
 * (3.105) The acceleration of P in the fixed frame: as a point of the moving frame, Coriolis, and in
 *   the moving frame.
 *   given       o_ddot[3]: second time derivative of: position of the origin of the moving frame
 *               Q[9]: rotation
 *               omega[3]: angular velocity
 *               omega_dot[3]: time derivative of: angular velocity
 *               rho[3]: position of P in the moving frame
 *               rho_dot[3]: time derivative of: position of P in the moving frame
 *               rho_ddot[3]: second time derivative of: position of P in the moving frame
 *   returns     p_ddot[3]: second time derivative of: position of any point P
 *   verdict     holds
 *   assumes     nothing
 *   operations  96: 30 add, 12 subtract, 54 multiply
 *   derivation  sha256 fbd2b527f0f93f4cf924de6668a33e19726d1caade279c11a0d657fe9ec4e961
 */
void chasles_moving_frame_acceleration(
    const double o_ddot[3],
    const double Q[9],
    const double omega[3],
    const double omega_dot[3],
    const double rho[3],
    const double rho_dot[3],
    const double rho_ddot[3],
    double p_ddot[3]);
void chasles_moving_frame_accelerationf(
    const float o_ddot[3],
    const float Q[9],
    const float omega[3],
    const float omega_dot[3],
    const float rho[3],
    const float rho_dot[3],
    const float rho_ddot[3],
    float p_ddot[3]);
void chasles_moving_frame_acceleration_batch(
    size_t count,
    const double *o_ddot, ptrdiff_t o_ddot_step,
    const double *Q, ptrdiff_t Q_step,
    const double *omega, ptrdiff_t omega_step,
    const double *omega_dot, ptrdiff_t omega_dot_step,
    const double *rho, ptrdiff_t rho_step,
    const double *rho_dot, ptrdiff_t rho_dot_step,
    const double *rho_ddot, ptrdiff_t rho_ddot_step,
    double *p_ddot, ptrdiff_t p_ddot_step);
void chasles_moving_frame_acceleration_batchf(
    size_t count,
    const float *o_ddot, ptrdiff_t o_ddot_step,
    const float *Q, ptrdiff_t Q_step,
    const float *omega, ptrdiff_t omega_step,
    const float *omega_dot, ptrdiff_t omega_dot_step,
    const float *rho, ptrdiff_t rho_step,
    const float *rho_dot, ptrdiff_t rho_dot_step,
    const float *rho_ddot, ptrdiff_t rho_ddot_step,
    float *p_ddot, ptrdiff_t p_ddot_step);

/*
 * text 3.7 d The axis and the pitch of the wrench.
 *   given       f[3]: resultant force
 *               n_A[3]: resultant moment about A
 *               a[3]: position of the landmark point A
 *   returns     axis[6]: [e''; n'']
 *               pitch: pitch of the wrench, in metres per radian
 *   verdict     holds under
 *   assumes     f != 0
 *   operations  49: 4 add, 12 subtract, 27 multiply, 5 divide, 1 square root
 *   derivation  sha256 b1179904e05c970df60da3f9b180c2bce98c765bdb6795544ff955fce9c3d5bd
 */
void chasles_wrench_axis(
    const double f[3],
    const double n_A[3],
    const double a[3],
    double axis[6],
    double *pitch);
void chasles_wrench_axisf(
    const float f[3],
    const float n_A[3],
    const float a[3],
    float axis[6],
    float *pitch);
void chasles_wrench_axis_batch(
    size_t count,
    const double *f, ptrdiff_t f_step,
    const double *n_A, ptrdiff_t n_A_step,
    const double *a, ptrdiff_t a_step,
    double *axis, ptrdiff_t axis_step,
    double *pitch, ptrdiff_t pitch_step);
void chasles_wrench_axis_batchf(
    size_t count,
    const float *f, ptrdiff_t f_step,
    const float *n_A, ptrdiff_t n_A_step,
    const float *a, ptrdiff_t a_step,
    float *axis, ptrdiff_t axis_step,
    float *pitch, ptrdiff_t pitch_step);

/*
 * (3.114) The power developed by a wrench on a body that moves with a twist at the same point.
 *   given       t[6]: twist: angular velocity, velocity of a landmark point
 *               w[6]: wrench: moment, force
 *   returns     Pi: power developed by a wrench on a moving body
 *   verdict     holds
 *   assumes     nothing
 *   operations  11: 5 add, 6 multiply
 *   derivation  sha256 f08018ccded03ad1a1392a205f144588142ee91077c0ed0b4f636ec1d31e4312
 */
void chasles_power(const double t[6], const double w[6], double *Pi);
void chasles_powerf(const float t[6], const float w[6], float *Pi);
void chasles_power_batch(
    size_t count,
    const double *t, ptrdiff_t t_step,
    const double *w, ptrdiff_t w_step,
    double *Pi, ptrdiff_t Pi_step);
void chasles_power_batchf(
    size_t count,
    const float *t, ptrdiff_t t_step,
    const float *w, ptrdiff_t w_step,
    float *Pi, ptrdiff_t Pi_step);

/*
 * text 3.7 k The reciprocal product of two screws, in either order.
 *   given       s_w[6]: screw of a wrench
 *               s_t[6]: screw of a twist
 *   returns     product: s_t^T Gamma s_w
 *   verdict     holds
 *   assumes     nothing
 *   operations  11: 5 add, 6 multiply
 *   derivation  sha256 b087dfb5c9785b14414c4d9ab347a0bbefd48c42f8ad121de5653c94dd3546ee
 */
void chasles_reciprocal_product(const double s_w[6], const double s_t[6], double *product);
void chasles_reciprocal_productf(const float s_w[6], const float s_t[6], float *product);
void chasles_reciprocal_product_batch(
    size_t count,
    const double *s_w, ptrdiff_t s_w_step,
    const double *s_t, ptrdiff_t s_t_step,
    double *product, ptrdiff_t product_step);
void chasles_reciprocal_product_batchf(
    size_t count,
    const float *s_w, ptrdiff_t s_w_step,
    const float *s_t, ptrdiff_t s_t_step,
    float *product, ptrdiff_t product_step);

/*
 * (3.119a) The wrench-transfer formula.
 *   given       w_A[6]: wrench at A
 *               a[3]: position of the landmark point A
 *               p[3]: position of any point P
 *   returns     w_P[6]: wrench at P
 *   verdict     holds
 *   assumes     nothing
 *   operations  15: 3 add, 6 subtract, 6 multiply
 *   derivation  sha256 9e54b67526c12869cc182865d5846fded980a863cc3a11fe5be4e32dc500f446
 */
void chasles_wrench_transfer(
    const double w_A[6],
    const double a[3],
    const double p[3],
    double w_P[6]);
void chasles_wrench_transferf(const float w_A[6], const float a[3], const float p[3], float w_P[6]);
void chasles_wrench_transfer_batch(
    size_t count,
    const double *w_A, ptrdiff_t w_A_step,
    const double *a, ptrdiff_t a_step,
    const double *p, ptrdiff_t p_step,
    double *w_P, ptrdiff_t w_P_step);
void chasles_wrench_transfer_batchf(
    size_t count,
    const float *w_A, ptrdiff_t w_A_step,
    const float *a, ptrdiff_t a_step,
    const float *p, ptrdiff_t p_step,
    float *w_P, ptrdiff_t w_P_step);

/*
 * (3.133a) Steiner's theorem: the moment of inertia with respect to A from that at the center of mass.
 *   given       I_C[9]: moment of inertia at the center of mass
 *               m: mass
 *               c[3]: position of the center of mass
 *               a[3]: position of the landmark point A
 *   returns     I_A[9]: moment of inertia with respect to A
 *   verdict     holds under
 *   assumes     m > 0
 *   operations  30: 5 add, 12 subtract, 13 multiply
 *   derivation  sha256 35b7fb1caca5be1d4c908923193605bd9233355cd78eb729d55678f7bb61145f
 */
void chasles_inertia_about_point(
    const double I_C[9],
    double m,
    const double c[3],
    const double a[3],
    double I_A[9]);
void chasles_inertia_about_pointf(
    const float I_C[9],
    float m,
    const float c[3],
    const float a[3],
    float I_A[9]);
void chasles_inertia_about_point_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *c, ptrdiff_t c_step,
    const double *a, ptrdiff_t a_step,
    double *I_A, ptrdiff_t I_A_step);
void chasles_inertia_about_point_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *c, ptrdiff_t c_step,
    const float *a, ptrdiff_t a_step,
    float *I_A, ptrdiff_t I_A_step);

/*
 * (3.142) The momentum screw by inertia dyad and twist.
 *   given       I_C[9]: moment of inertia at the center of mass
 *               m: mass
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *   returns     mu[6]: [I_C omega; m c_dot]
 *   verdict     holds
 *   assumes     nothing
 *   operations  18: 6 add, 12 multiply
 *   derivation  sha256 3f711409ddb1418e7a90bc97272fe9f055b83f10c9675ffa2beb8cf349541833
 */
void chasles_momentum_screw(const double I_C[9], double m, const double t[6], double mu[6]);
void chasles_momentum_screwf(const float I_C[9], float m, const float t[6], float mu[6]);
void chasles_momentum_screw_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    double *mu, ptrdiff_t mu_step);
void chasles_momentum_screw_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *t, ptrdiff_t t_step,
    float *mu, ptrdiff_t mu_step);

/*
 * (3.145) The kinetic energy as a quadratic form of the twist.
 *   given       I_C[9]: moment of inertia at the center of mass
 *               m: mass
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *   returns     T: kinetic energy
 *   verdict     holds
 *   assumes     nothing
 *   operations  35: 11 add, 24 multiply
 *   derivation  sha256 bb5b9837baefa1606d49c0ac94dfc858eb46861f13739a02b972bfbdf0f95c37
 */
void chasles_kinetic_energy(const double I_C[9], double m, const double t[6], double *T);
void chasles_kinetic_energyf(const float I_C[9], float m, const float t[6], float *T);
void chasles_kinetic_energy_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    double *T, ptrdiff_t T_step);
void chasles_kinetic_energy_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *t, ptrdiff_t t_step,
    float *T, ptrdiff_t T_step);

/*
 * text 3.8 v The wrench that moves the body: the Newton-Euler equations as they stand.
 *   given       I_C[9]: moment of inertia at the center of mass
 *               m: mass
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *               t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   returns     w[6]: wrench: moment, force
 *   verdict     holds
 *   assumes     nothing
 *   operations  45: 15 add, 3 subtract, 27 multiply
 *   derivation  sha256 cb1ef1c6a16cfa01894e6560676a00c850af7c3f6cce96e6448ca7f9626feaa7
 */
void chasles_newton_euler_wrench(
    const double I_C[9],
    double m,
    const double t[6],
    const double t_dot[6],
    double w[6]);
void chasles_newton_euler_wrenchf(
    const float I_C[9],
    float m,
    const float t[6],
    const float t_dot[6],
    float w[6]);
void chasles_newton_euler_wrench_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    const double *t_dot, ptrdiff_t t_dot_step,
    double *w, ptrdiff_t w_step);
void chasles_newton_euler_wrench_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *t, ptrdiff_t t_step,
    const float *t_dot, ptrdiff_t t_dot_step,
    float *w, ptrdiff_t w_step);

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
 *   operations  82: 14 add, 15 subtract, 51 multiply, 2 divide
 *   derivation  sha256 64f80e87d5737068b3f0b9f4706feef6b9ff4e2cb5ab381a10697a6701ce84b5
 */
void chasles_newton_euler_twist_rate(
    const double I_C[9],
    double m,
    const double t[6],
    const double w[6],
    double t_dot[6]);
void chasles_newton_euler_twist_ratef(
    const float I_C[9],
    float m,
    const float t[6],
    const float w[6],
    float t_dot[6]);
void chasles_newton_euler_twist_rate_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    const double *w, ptrdiff_t w_step,
    double *t_dot, ptrdiff_t t_dot_step);
void chasles_newton_euler_twist_rate_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *t, ptrdiff_t t_step,
    const float *w, ptrdiff_t w_step,
    float *t_dot, ptrdiff_t t_dot_step);

/*
 * (3.147) The inertia dyad at A.
 *   given       I_C[9]: moment of inertia at the center of mass
 *               m: mass
 *               c[3]: position of the center of mass
 *               a[3]: position of the landmark point A
 *   returns     M_A[36]: inertia dyad at A
 *   verdict     holds
 *   assumes     nothing
 *   operations  30: 6 add, 9 subtract, 15 multiply
 *   derivation  sha256 4bbf8c1406c8bc4f002bf283f170f926299c74c690fe95dd78dfef337d376991
 */
void chasles_inertia_dyad(
    const double I_C[9],
    double m,
    const double c[3],
    const double a[3],
    double M_A[36]);
void chasles_inertia_dyadf(
    const float I_C[9],
    float m,
    const float c[3],
    const float a[3],
    float M_A[36]);
void chasles_inertia_dyad_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *c, ptrdiff_t c_step,
    const double *a, ptrdiff_t a_step,
    double *M_A, ptrdiff_t M_A_step);
void chasles_inertia_dyad_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *c, ptrdiff_t c_step,
    const float *a, ptrdiff_t a_step,
    float *M_A, ptrdiff_t M_A_step);

#ifdef __cplusplus
}
#endif

#endif
