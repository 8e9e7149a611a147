/* Rigid-body kernels emitted from checked equations. Made by `chasles emit`; not to be edited by hand.
 *
 * C99; needs <math.h> alone. Nothing is allocated, no state is kept, errno is not used.
 * A 3 x 3 matrix is 9 numbers, row by row. Angles are in radians, units are SI. A twist holds the angular part
 * first, a wrench the moment first.
 *
 * Scalars are passed by value, arrays by address, outputs last. All results are computed before any is stored, so
 * that an output may share storage with any input. What a function assumes of its inputs is not tested.
 *
 * NAMEf is NAME in single precision. NAME_batch and NAME_batchf compute `count` items, one after the other: item i
 * of x is at x + i * x_step, the step in numbers, negative ones and 0 (the same item each time) included. Outputs of
 * an item must not lie over inputs of a later one.
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
 *   derivation  sha256 3bb8a8fd474c059361c5ae7723890c819183529bb7e76fe026eab3cdd03133fd
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
 *   derivation  sha256 718b46e158071b0e8c0dfad7c9d62e35cfda18b9e1e5b352c23d0b196e545440
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
 *   expects     Q is a rotation
 *   operations  21: 9 add, 3 subtract, 9 multiply
 *   derivation  sha256 e64cf405ca27a59ae4dba57aa45f63f61552677dd356e49c7554622691f7c536
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
 *   derivation  sha256 608f8e0b5c013b248e286c77597896f6fd34f1056e0cae176c0fffd5faf1f7e9
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
 *   derivation  sha256 de9dbdb464264fe2190e4545ce33ac1b9c2a37029a835382eb8d8b8d64b77997
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
 *   derivation  sha256 b4190f47c4e271ccf9f3cb7fff7644b755a419d9433a3d4b5e45e29ee2c24f0d
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
 *   derivation  sha256 82e7d2177f917dad0cc77578e3870137f26237efa6ecc37d77167d348f24892e
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
 *   derivation  sha256 d481e426032bffd4ad14a6ad5faec5b738471821083e120c2e85c360da015f46
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
 *   expects     triad is a rotation
 *               triad' is a rotation
 *   operations  45: 18 add, 27 multiply
 *   derivation  sha256 37884df5c1bb0988ddff944acb988e27fc619a7e538a026682fcc0b6c146645c
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
 *   expects     triad is a rotation
 *               triad' is a rotation
 *   operations  45: 18 add, 27 multiply
 *   derivation  sha256 20bfc4be7482a03cac2887f4c4003cd47cd58752cd4f74993b4c1f541b5fe56f
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
 * (3.45) The angular velocity: the axial vector of the angular-velocity matrix.
 *   given       Omega[9]: angular-velocity matrix
 *   returns     omega[3]: angular velocity
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 3 subtract, 3 multiply
 *   derivation  sha256 d765a199b942ea590d183fd31195f0769f5bc7877fca8cb48e9315ab75efe03a
 */
void chasles_axial_vector(const double Omega[9], double omega[3]);
void chasles_axial_vectorf(const float Omega[9], float omega[3]);
void chasles_axial_vector_batch(
    size_t count,
    const double *Omega, ptrdiff_t Omega_step,
    double *omega, ptrdiff_t omega_step);
void chasles_axial_vector_batchf(
    size_t count,
    const float *Omega, ptrdiff_t Omega_step,
    float *omega, ptrdiff_t omega_step);

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
 *   derivation  sha256 cf40ff55774289ffed0ea82bbef45f19d34034b7096ffa7bea3f6664852180bb
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
 *   derivation  sha256 4f369fc6b5b07e9f94adfd732820a7de33f7054f23aece128a3349badcc576c3
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
 *   derivation  sha256 e1fc88a281166d37c4f13a0f1c98c1109a22a36e707ca35c74db140722b40712
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
 *   derivation  sha256 b7ab95a60e442ca39ebc9aa95a991d12a881db386cc9141fe5cf492c3075fee7
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
 *   derivation  sha256 17761ec312807cb6e198cbca110c91735f2e6c31f7d446942864ba3607190db0
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
 *   expects     |[q, q_0]| = 1
 *               1 + q_0 != 0
 *   operations  20: 7 add, 3 subtract, 9 multiply, 1 divide
 *   derivation  sha256 2fa7ad4fc6b8551a66ecf4ae0dcef7f683204ee4a7508c44cff97a90cf66edae
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
 *   expects     |[q, q_0]| = 1
 *   operations  29: 8 add, 4 subtract, 17 multiply
 *   derivation  sha256 2c3e1cfe8648bfbd86be147e00c4d94b0f95d070a78440d91f72e1992881fe27
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
 *   expects     Q is a rotation
 *   operations  10: 2 add, 4 subtract, 4 multiply
 *   derivation  sha256 14dfe57d89d33f7df4edddb11ba2240a90e01a0500293b07fdf9dbc9ba2f6fb4
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
 *   derivation  sha256 ebef68658de75058803abc99b987c49de9d1cb40a8a48992731943208a493cc1
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
 *   derivation  sha256 e342588bb3d3cb6097f1e419f205ef19d1f2da08fb839c41c34e6fd10d09d80a
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
 *   derivation  sha256 084045f80fb5246b6238e7a7964fcbca354b318c91fb4317affa411197007d32
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
 *   derivation  sha256 4fe4990c20975f24a3853d958dd8358f87b465f41f874d5033241d675c5c169b
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
 *   derivation  sha256 e83271b1008e0a8f79d951be0e922c03ff1db20bdf750dbd6823385c500dc4c0
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
 *   derivation  sha256 cfd5d2173b7e9659e301600a82f009ed771ccc410ef77dba7a6e29d1ff28db3f
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
 *   derivation  sha256 c271922e4bf373d339f79acd80f1f8cdd9c0d1d59ac7927436759b3c12c04d1a
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
 *   derivation  sha256 dcbbb2b61efdaf721dfc7a104de1bd3d217748ef1f564a60f95b5b59803febc8
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
 *   derivation  sha256 6f8f544dfe25801a8cb5315ee1d4690f7aef531c2cec0f67579cd6dbf46babbc
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
 *   derivation  sha256 dcad7fffd71f9da8ea8e7d2f88d0a989c7470248b615cbe54fe551d5c478f61e
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
 *   derivation  sha256 d581dc5bc798824b683b05121d6dd260d18c19f6b7353538315f5b6c6bf92579
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
 *   derivation  sha256 e9c4a95fb7b14ae8202171f87e6361bf659e70f2db17e9b36cb22ab1acd1ed10
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
 *   derivation  sha256 90de85bcba11eac11b4ed809bfaf0d169cebcae8ca5cd1e30ed22eb15c13fba9
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
 *   derivation  sha256 5c4f6e062e6b8c38ce36f63f5fb668f9229e0c96f46adff13f6f7b13049adab3
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
 *   derivation  sha256 0e6556537babaf679455ecf0a190fc9de1d90f4bc255ca668323680aba303433
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
 *   derivation  sha256 d9ddd8533127be1cfc0b4bc8bbcabfd00ecb0946f736b10b2dd00249bd4711c3
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
 *   expects     Q is a rotation
 *   operations  45: 18 add, 3 subtract, 24 multiply
 *   derivation  sha256 e4658ce140cc5589b5edbce8d06cca3658bb144cdbd17bfb7de1c86c04599d69
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
 *   expects     Q is a rotation
 *   operations  96: 30 add, 12 subtract, 54 multiply
 *   derivation  sha256 4c87c44acdc20c6c06b25bfd500c83d4ac2025ff7689f669b54c4f0e048d98a2
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
 *   derivation  sha256 202f4b902dd00275fba8ef8414c228a0b5c26afdff0a7af1bce653c7734c0abd
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
 *   derivation  sha256 617dde215c7374cf883e5eee1c553ba9ac4be615aefadba268d99e0e6ea0d471
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
 *   derivation  sha256 ff89a0890a6cc023ff107ee9855d7c2d1ece4959f3b60c0975fbab9854bfa4ae
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
 *   derivation  sha256 1aa9230b677002dd380c437470136d192f3980131abe2874f2f060fe645f158d
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
 *   expects     I_C is symmetric
 *   operations  30: 5 add, 12 subtract, 13 multiply
 *   derivation  sha256 a4bcf979f78da4a884e3373c8facc5d578200165bff4389fa5501d7b3122d970
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
 *   operations  27: 5 add, 9 subtract, 13 multiply
 *   derivation  sha256 a4bcf979f78da4a884e3373c8facc5d578200165bff4389fa5501d7b3122d970
 */
void chasles_inertia_about_point_sym6(
    const double I_C[6],
    double m,
    const double c[3],
    const double a[3],
    double I_A[6]);
void chasles_inertia_about_point_sym6f(
    const float I_C[6],
    float m,
    const float c[3],
    const float a[3],
    float I_A[6]);
void chasles_inertia_about_point_sym6_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *c, ptrdiff_t c_step,
    const double *a, ptrdiff_t a_step,
    double *I_A, ptrdiff_t I_A_step);
void chasles_inertia_about_point_sym6_batchf(
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
 *   expects     I_C is symmetric
 *               m > 0
 *   operations  18: 6 add, 12 multiply
 *   derivation  sha256 cddae1b98dff52f00d26c14d98c872c387bd5cede0f73b8f98489dc5f9efeecd
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
 *   derivation  sha256 cddae1b98dff52f00d26c14d98c872c387bd5cede0f73b8f98489dc5f9efeecd
 */
void chasles_momentum_screw_sym6(const double I_C[6], double m, const double t[6], double mu[6]);
void chasles_momentum_screw_sym6f(const float I_C[6], float m, const float t[6], float mu[6]);
void chasles_momentum_screw_sym6_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    double *mu, ptrdiff_t mu_step);
void chasles_momentum_screw_sym6_batchf(
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
 *   expects     I_C is symmetric
 *               m > 0
 *   operations  35: 11 add, 24 multiply
 *   derivation  sha256 f49e224f601b161052d8996395e4fdf354c8312c20c463face54e8559308b723
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
 *   derivation  sha256 f49e224f601b161052d8996395e4fdf354c8312c20c463face54e8559308b723
 */
void chasles_kinetic_energy_sym6(const double I_C[6], double m, const double t[6], double *T);
void chasles_kinetic_energy_sym6f(const float I_C[6], float m, const float t[6], float *T);
void chasles_kinetic_energy_sym6_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    double *T, ptrdiff_t T_step);
void chasles_kinetic_energy_sym6_batchf(
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
 *   expects     I_C is symmetric
 *               m > 0
 *   operations  45: 15 add, 3 subtract, 27 multiply
 *   derivation  sha256 d30122d4b44da4f27cb2cb2c143b22ab476174f2b785f6c60ce809f87eee2a40
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
 *   derivation  sha256 d30122d4b44da4f27cb2cb2c143b22ab476174f2b785f6c60ce809f87eee2a40
 */
void chasles_newton_euler_wrench_sym6(
    const double I_C[6],
    double m,
    const double t[6],
    const double t_dot[6],
    double w[6]);
void chasles_newton_euler_wrench_sym6f(
    const float I_C[6],
    float m,
    const float t[6],
    const float t_dot[6],
    float w[6]);
void chasles_newton_euler_wrench_sym6_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    const double *t_dot, ptrdiff_t t_dot_step,
    double *w, ptrdiff_t w_step);
void chasles_newton_euler_wrench_sym6_batchf(
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
 *   expects     I_C is positive-definite
 *   operations  82: 14 add, 15 subtract, 51 multiply, 2 divide
 *   derivation  sha256 2cb7962adfae416ea5704e645be5e45af62a45195755dcdb0db8240bfbd95e34
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
 *   operations  73: 14 add, 12 subtract, 45 multiply, 2 divide
 *   derivation  sha256 2cb7962adfae416ea5704e645be5e45af62a45195755dcdb0db8240bfbd95e34
 */
void chasles_newton_euler_twist_rate_sym6(
    const double I_C[6],
    double m,
    const double t[6],
    const double w[6],
    double t_dot[6]);
void chasles_newton_euler_twist_rate_sym6f(
    const float I_C[6],
    float m,
    const float t[6],
    const float w[6],
    float t_dot[6]);
void chasles_newton_euler_twist_rate_sym6_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *t, ptrdiff_t t_step,
    const double *w, ptrdiff_t w_step,
    double *t_dot, ptrdiff_t t_dot_step);
void chasles_newton_euler_twist_rate_sym6_batchf(
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
 *   expects     I_C is symmetric
 *               m > 0
 *   operations  30: 6 add, 9 subtract, 15 multiply
 *   derivation  sha256 a5bd251535f48b198cf4a48c134786e54eacca65f02a00b3451cfcb8e99e18ac
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
 *   operations  27: 6 add, 6 subtract, 15 multiply
 *   derivation  sha256 a5bd251535f48b198cf4a48c134786e54eacca65f02a00b3451cfcb8e99e18ac
 */
void chasles_inertia_dyad_sym6(
    const double I_C[6],
    double m,
    const double c[3],
    const double a[3],
    double M_A[36]);
void chasles_inertia_dyad_sym6f(
    const float I_C[6],
    float m,
    const float c[3],
    const float a[3],
    float M_A[36]);
void chasles_inertia_dyad_sym6_batch(
    size_t count,
    const double *I_C, ptrdiff_t I_C_step,
    const double *m, ptrdiff_t m_step,
    const double *c, ptrdiff_t c_step,
    const double *a, ptrdiff_t a_step,
    double *M_A, ptrdiff_t M_A_step);
void chasles_inertia_dyad_sym6_batchf(
    size_t count,
    const float *I_C, ptrdiff_t I_C_step,
    const float *m, ptrdiff_t m_step,
    const float *c, ptrdiff_t c_step,
    const float *a, ptrdiff_t a_step,
    float *M_A, ptrdiff_t M_A_step);

/*
 * Ex 3.10 The rotation by Euler angles about x, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 43389048581969403bd2d6881878959cb85868b92c6fcb159fa1904f458463b3
 */
void chasles_rotation_from_euler_xyx(const double angles[3], double Q[9]);
void chasles_rotation_from_euler_xyxf(const float angles[3], float Q[9]);
void chasles_rotation_from_euler_xyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_euler_xyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step);

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 08ee56a4cd7efde3734db4d7abe798d5c7f0ce23d4b1520ed9cabad29aebcf61
 */
void chasles_euler_rate_matrix_xyx(const double angles[3], double W[9]);
void chasles_euler_rate_matrix_xyxf(const float angles[3], float W[9]);
void chasles_euler_rate_matrix_xyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step);
void chasles_euler_rate_matrix_xyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step);

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 2351fd947a763557e546abca735235b8fd406c27b8f8367b9656771c149abe54
 */
void chasles_euler_rate_matrix_body_xyx(const double angles[3], double W_body[9]);
void chasles_euler_rate_matrix_body_xyxf(const float angles[3], float W_body[9]);
void chasles_euler_rate_matrix_body_xyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step);
void chasles_euler_rate_matrix_body_xyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step);

/*
 * Ex 3.10 The rates of Euler angles about x, y, x from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 e453c9ec715829e85f9601a1d0ec08462b05bd7dcf4ff68c0d823046a49f7b25
 */
void chasles_euler_rates_xyx(const double angles[3], const double omega[3], double theta_dot[3]);
void chasles_euler_rates_xyxf(const float angles[3], const float omega[3], float theta_dot[3]);
void chasles_euler_rates_xyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step);
void chasles_euler_rates_xyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step);

/*
 * Ex 3.10 The rotation by Euler angles about x, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 6705bbdc3cc819470adf698e905e15041cab2c79ee214c77c73b890ac65f41ce
 */
void chasles_rotation_from_euler_xyz(const double angles[3], double Q[9]);
void chasles_rotation_from_euler_xyzf(const float angles[3], float Q[9]);
void chasles_rotation_from_euler_xyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_euler_xyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step);

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 8b9592b89e483d6287bed3bb4d0027fafb382171a6999dd56d09507bbf0d590c
 */
void chasles_euler_rate_matrix_xyz(const double angles[3], double W[9]);
void chasles_euler_rate_matrix_xyzf(const float angles[3], float W[9]);
void chasles_euler_rate_matrix_xyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step);
void chasles_euler_rate_matrix_xyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step);

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 6edfea23479e92ef7d1e7e7d68bcd13ee371f2991c16353952f09f3c9d81ed3c
 */
void chasles_euler_rate_matrix_body_xyz(const double angles[3], double W_body[9]);
void chasles_euler_rate_matrix_body_xyzf(const float angles[3], float W_body[9]);
void chasles_euler_rate_matrix_body_xyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step);
void chasles_euler_rate_matrix_body_xyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step);

/*
 * Ex 3.10 The rates of Euler angles about x, y, z from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 bec42ab40a38f203a48f4e170dc0ad4fb0cb1c57041bf8abc87e9c159e906d1b
 */
void chasles_euler_rates_xyz(const double angles[3], const double omega[3], double theta_dot[3]);
void chasles_euler_rates_xyzf(const float angles[3], const float omega[3], float theta_dot[3]);
void chasles_euler_rates_xyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step);
void chasles_euler_rates_xyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step);

/*
 * Ex 3.10 The rotation by Euler angles about x, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 de3a851daae76ca498f976ed679390610caf046ca454d49669dab454cd2104d1
 */
void chasles_rotation_from_euler_xzx(const double angles[3], double Q[9]);
void chasles_rotation_from_euler_xzxf(const float angles[3], float Q[9]);
void chasles_rotation_from_euler_xzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_euler_xzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step);

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 545b1f6b179f88fad10dbd0fac8687f59350380469f6ca96bc437c08d8649800
 */
void chasles_euler_rate_matrix_xzx(const double angles[3], double W[9]);
void chasles_euler_rate_matrix_xzxf(const float angles[3], float W[9]);
void chasles_euler_rate_matrix_xzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step);
void chasles_euler_rate_matrix_xzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step);

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 4421d8d529350d6e5a4683c66c54675834e8b21d5b6680f974942482d20d7faa
 */
void chasles_euler_rate_matrix_body_xzx(const double angles[3], double W_body[9]);
void chasles_euler_rate_matrix_body_xzxf(const float angles[3], float W_body[9]);
void chasles_euler_rate_matrix_body_xzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step);
void chasles_euler_rate_matrix_body_xzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step);

/*
 * Ex 3.10 The rates of Euler angles about x, z, x from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 0ccb549820c0ab21158582ccb0f8286408599eb24bab35fd4a60461f59ffafd6
 */
void chasles_euler_rates_xzx(const double angles[3], const double omega[3], double theta_dot[3]);
void chasles_euler_rates_xzxf(const float angles[3], const float omega[3], float theta_dot[3]);
void chasles_euler_rates_xzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step);
void chasles_euler_rates_xzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step);

/*
 * Ex 3.10 The rotation by Euler angles about x, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 528f8a3eb6e52746d86a5138d675ae8293cc6c7de4f1c00ba3c4b692ba51c455
 */
void chasles_rotation_from_euler_xzy(const double angles[3], double Q[9]);
void chasles_rotation_from_euler_xzyf(const float angles[3], float Q[9]);
void chasles_rotation_from_euler_xzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_euler_xzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step);

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about x, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 4ccd841cb0d6e568bdae1a01686f08fa60121be46d720f48317ac76ca58343f3
 */
void chasles_euler_rate_matrix_xzy(const double angles[3], double W[9]);
void chasles_euler_rate_matrix_xzyf(const float angles[3], float W[9]);
void chasles_euler_rate_matrix_xzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step);
void chasles_euler_rate_matrix_xzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step);

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about x, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 140a985ea02031261c7a92a5cae173ebafe88054961990673ef5a69b4c1c784c
 */
void chasles_euler_rate_matrix_body_xzy(const double angles[3], double W_body[9]);
void chasles_euler_rate_matrix_body_xzyf(const float angles[3], float W_body[9]);
void chasles_euler_rate_matrix_body_xzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step);
void chasles_euler_rate_matrix_body_xzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step);

/*
 * Ex 3.10 The rates of Euler angles about x, z, y from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 087e3bef0a80b53adecd8dbfc1ca485d856b9ab12bf0597224ad01bffe84d48d
 */
void chasles_euler_rates_xzy(const double angles[3], const double omega[3], double theta_dot[3]);
void chasles_euler_rates_xzyf(const float angles[3], const float omega[3], float theta_dot[3]);
void chasles_euler_rates_xzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step);
void chasles_euler_rates_xzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step);

/*
 * Ex 3.10 The rotation by Euler angles about y, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 4639340b4c5a19e5e71818440a5e25a7dc695042caa389d57e5938578f329204
 */
void chasles_rotation_from_euler_yxy(const double angles[3], double Q[9]);
void chasles_rotation_from_euler_yxyf(const float angles[3], float Q[9]);
void chasles_rotation_from_euler_yxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_euler_yxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step);

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 4cbc84e4cff896b34c5c2f02307a9c69b503d7a3a6aa2154b90b95c513c1bbce
 */
void chasles_euler_rate_matrix_yxy(const double angles[3], double W[9]);
void chasles_euler_rate_matrix_yxyf(const float angles[3], float W[9]);
void chasles_euler_rate_matrix_yxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step);
void chasles_euler_rate_matrix_yxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step);

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 a91079d1f94bff7ab0a579982ea7cd90304a0348ae48792ba5271dddfcbf7035
 */
void chasles_euler_rate_matrix_body_yxy(const double angles[3], double W_body[9]);
void chasles_euler_rate_matrix_body_yxyf(const float angles[3], float W_body[9]);
void chasles_euler_rate_matrix_body_yxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step);
void chasles_euler_rate_matrix_body_yxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step);

/*
 * Ex 3.10 The rates of Euler angles about y, x, y from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 57f9fa9a9312c200080117d0f7819b233fa81817547398adafd4ca1378e12c37
 */
void chasles_euler_rates_yxy(const double angles[3], const double omega[3], double theta_dot[3]);
void chasles_euler_rates_yxyf(const float angles[3], const float omega[3], float theta_dot[3]);
void chasles_euler_rates_yxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step);
void chasles_euler_rates_yxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step);

/*
 * Ex 3.10 The rotation by Euler angles about y, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 7826edee42401859a8ff2260131eccd87584d6b7fc0ad058baafa9ef41dddf6d
 */
void chasles_rotation_from_euler_yxz(const double angles[3], double Q[9]);
void chasles_rotation_from_euler_yxzf(const float angles[3], float Q[9]);
void chasles_rotation_from_euler_yxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_euler_yxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step);

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 07480db4ffa6cc7d6437a7e2665ee04918a7abb314a91e8b1902406359365ea3
 */
void chasles_euler_rate_matrix_yxz(const double angles[3], double W[9]);
void chasles_euler_rate_matrix_yxzf(const float angles[3], float W[9]);
void chasles_euler_rate_matrix_yxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step);
void chasles_euler_rate_matrix_yxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step);

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 8fcfcba93190fa9fe68f95cec90b57f0b7c5ef19ebaeb913da577bffd1d751aa
 */
void chasles_euler_rate_matrix_body_yxz(const double angles[3], double W_body[9]);
void chasles_euler_rate_matrix_body_yxzf(const float angles[3], float W_body[9]);
void chasles_euler_rate_matrix_body_yxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step);
void chasles_euler_rate_matrix_body_yxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step);

/*
 * Ex 3.10 The rates of Euler angles about y, x, z from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 2212d1def76d12a0d532fa8d15c98f725dc91b310425411666552c46e23e6bcc
 */
void chasles_euler_rates_yxz(const double angles[3], const double omega[3], double theta_dot[3]);
void chasles_euler_rates_yxzf(const float angles[3], const float omega[3], float theta_dot[3]);
void chasles_euler_rates_yxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step);
void chasles_euler_rates_yxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step);

/*
 * Ex 3.10 The rotation by Euler angles about y, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 ef5522efe35a5dbb6eb545a7113286a6df3ac2d9603f138c97acd6f4fc1ccdc9
 */
void chasles_rotation_from_euler_yzx(const double angles[3], double Q[9]);
void chasles_rotation_from_euler_yzxf(const float angles[3], float Q[9]);
void chasles_rotation_from_euler_yzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_euler_yzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step);

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 f21a6f4f704b91ac82727b870a55688276de0a91bfef95348ddb665cf0053bbe
 */
void chasles_euler_rate_matrix_yzx(const double angles[3], double W[9]);
void chasles_euler_rate_matrix_yzxf(const float angles[3], float W[9]);
void chasles_euler_rate_matrix_yzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step);
void chasles_euler_rate_matrix_yzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step);

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, z, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 8002c5ad3e9637706ec1f0995aff426cd6d3c93bbb9c6b05f736a8f04dc13a53
 */
void chasles_euler_rate_matrix_body_yzx(const double angles[3], double W_body[9]);
void chasles_euler_rate_matrix_body_yzxf(const float angles[3], float W_body[9]);
void chasles_euler_rate_matrix_body_yzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step);
void chasles_euler_rate_matrix_body_yzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step);

/*
 * Ex 3.10 The rates of Euler angles about y, z, x from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 d1003d9548b999def53c21a3d1f187a414f4fc0f945b05b72a7c6fbfb5c7a47d
 */
void chasles_euler_rates_yzx(const double angles[3], const double omega[3], double theta_dot[3]);
void chasles_euler_rates_yzxf(const float angles[3], const float omega[3], float theta_dot[3]);
void chasles_euler_rates_yzx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step);
void chasles_euler_rates_yzx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step);

/*
 * Ex 3.10 The rotation by Euler angles about y, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 9b151d27de4ffca05409badf5b12a98224dd3d563317e41d406695d5ac82d8fe
 */
void chasles_rotation_from_euler_yzy(const double angles[3], double Q[9]);
void chasles_rotation_from_euler_yzyf(const float angles[3], float Q[9]);
void chasles_rotation_from_euler_yzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_euler_yzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step);

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about y, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 2f9bfcf1cf1510c9d532f8993939787ce7f9c20c82877a4ff2da46a70393d647
 */
void chasles_euler_rate_matrix_yzy(const double angles[3], double W[9]);
void chasles_euler_rate_matrix_yzyf(const float angles[3], float W[9]);
void chasles_euler_rate_matrix_yzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step);
void chasles_euler_rate_matrix_yzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step);

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about y, z, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 5762f9bb88e3585fbcf0a24320f2bff2cde801a395480e2e0590be6aaf815133
 */
void chasles_euler_rate_matrix_body_yzy(const double angles[3], double W_body[9]);
void chasles_euler_rate_matrix_body_yzyf(const float angles[3], float W_body[9]);
void chasles_euler_rate_matrix_body_yzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step);
void chasles_euler_rate_matrix_body_yzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step);

/*
 * Ex 3.10 The rates of Euler angles about y, z, y from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 b6355f58c7c3fa95bc6d061430c73cc2a10d5ac79a707165aff3d890f9581dba
 */
void chasles_euler_rates_yzy(const double angles[3], const double omega[3], double theta_dot[3]);
void chasles_euler_rates_yzyf(const float angles[3], const float omega[3], float theta_dot[3]);
void chasles_euler_rates_yzy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step);
void chasles_euler_rates_yzy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step);

/*
 * Ex 3.10 The rotation by Euler angles about z, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 b9f5bd8cb933973ed7cbd4c1597c7beb8def73e0322a6320eafff859e529e1b7
 */
void chasles_rotation_from_euler_zxy(const double angles[3], double Q[9]);
void chasles_rotation_from_euler_zxyf(const float angles[3], float Q[9]);
void chasles_rotation_from_euler_zxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_euler_zxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step);

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 df727c18be22cfac4c3a09b0f1e97010c957f2a06bb7dac8fad89bc630cdfc72
 */
void chasles_euler_rate_matrix_zxy(const double angles[3], double W[9]);
void chasles_euler_rate_matrix_zxyf(const float angles[3], float W[9]);
void chasles_euler_rate_matrix_zxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step);
void chasles_euler_rate_matrix_zxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step);

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, x, y.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 f450ca1b0eb3ccc517bdc3221e8a1e2c9cc8e3d8de87bd14b8f038e09efa7cd4
 */
void chasles_euler_rate_matrix_body_zxy(const double angles[3], double W_body[9]);
void chasles_euler_rate_matrix_body_zxyf(const float angles[3], float W_body[9]);
void chasles_euler_rate_matrix_body_zxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step);
void chasles_euler_rate_matrix_body_zxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step);

/*
 * Ex 3.10 The rates of Euler angles about z, x, y from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 b6247cfe1605afb09834132d0089f65feb63196135176c18e66aaecefde6ff2d
 */
void chasles_euler_rates_zxy(const double angles[3], const double omega[3], double theta_dot[3]);
void chasles_euler_rates_zxyf(const float angles[3], const float omega[3], float theta_dot[3]);
void chasles_euler_rates_zxy_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step);
void chasles_euler_rates_zxy_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step);

/*
 * Ex 3.10 The rotation by Euler angles about z, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 ec42254a14e2150cfdfa3e489c58c9f29abfb1adb674fbfc9db9de4062ab509b
 */
void chasles_rotation_from_euler_zxz(const double angles[3], double Q[9]);
void chasles_rotation_from_euler_zxzf(const float angles[3], float Q[9]);
void chasles_rotation_from_euler_zxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_euler_zxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step);

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 596864b48f2083e275fa86c7bd645c22321a7dca6c8a229e42796d251888e8f2
 */
void chasles_euler_rate_matrix_zxz(const double angles[3], double W[9]);
void chasles_euler_rate_matrix_zxzf(const float angles[3], float W[9]);
void chasles_euler_rate_matrix_zxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step);
void chasles_euler_rate_matrix_zxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step);

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, x, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 d69ea9f6ef6685b83332ef5a90dbdd6051040c10577814f685fcfbda54e5aeaf
 */
void chasles_euler_rate_matrix_body_zxz(const double angles[3], double W_body[9]);
void chasles_euler_rate_matrix_body_zxzf(const float angles[3], float W_body[9]);
void chasles_euler_rate_matrix_body_zxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step);
void chasles_euler_rate_matrix_body_zxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step);

/*
 * Ex 3.10 The rates of Euler angles about z, x, z from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 69c02425a879b8837aea25c6a1189c081b2a0c50eda10e5718e89bbd6988fd02
 */
void chasles_euler_rates_zxz(const double angles[3], const double omega[3], double theta_dot[3]);
void chasles_euler_rates_zxzf(const float angles[3], const float omega[3], float theta_dot[3]);
void chasles_euler_rates_zxz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step);
void chasles_euler_rates_zxz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step);

/*
 * Ex 3.10 The rotation by Euler angles about z, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 600331d1bf931f72e5c669d33f112d1205b8fe035f57e62c807299776dba5386
 */
void chasles_rotation_from_euler_zyx(const double angles[3], double Q[9]);
void chasles_rotation_from_euler_zyxf(const float angles[3], float Q[9]);
void chasles_rotation_from_euler_zyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_euler_zyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step);

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 801dcac4871c313d8f88d5611a62e3fdfff1565d6bb1568273ad0ea2a965d1e5
 */
void chasles_euler_rate_matrix_zyx(const double angles[3], double W[9]);
void chasles_euler_rate_matrix_zyxf(const float angles[3], float W[9]);
void chasles_euler_rate_matrix_zyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step);
void chasles_euler_rate_matrix_zyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step);

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, y, x.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 d820b0c990936bb7c922ad28e0b083d260059e6b0d74c52dcd91087315dfc602
 */
void chasles_euler_rate_matrix_body_zyx(const double angles[3], double W_body[9]);
void chasles_euler_rate_matrix_body_zyxf(const float angles[3], float W_body[9]);
void chasles_euler_rate_matrix_body_zyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step);
void chasles_euler_rate_matrix_body_zyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step);

/*
 * Ex 3.10 The rates of Euler angles about z, y, x from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     cos(theta_2) != 0
 *   operations  13: 2 add, 1 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 621952a0c32884add034832a91f740d3acb5c4d2939cdeff3c489ff41833c3c9
 */
void chasles_euler_rates_zyx(const double angles[3], const double omega[3], double theta_dot[3]);
void chasles_euler_rates_zyxf(const float angles[3], const float omega[3], float theta_dot[3]);
void chasles_euler_rates_zyx_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step);
void chasles_euler_rates_zyx_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step);

/*
 * Ex 3.10 The rotation by Euler angles about z, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     Q[9]: rotation
 *   verdict     defined
 *   assumes     nothing
 *   operations  24: 2 add, 2 subtract, 14 multiply, 3 sine, 3 cosine
 *   derivation  sha256 20ec1abc97e092ce5bad87ed0387a034bad0867c0b77b86a3b952f003423a08c
 */
void chasles_rotation_from_euler_zyz(const double angles[3], double Q[9]);
void chasles_rotation_from_euler_zyzf(const float angles[3], float Q[9]);
void chasles_rotation_from_euler_zyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *Q, ptrdiff_t Q_step);
void chasles_rotation_from_euler_zyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *Q, ptrdiff_t Q_step);

/*
 * Ex 3.10 The angular velocity, in the fixed frame, from the rates of Euler angles about z, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W[9]: angular velocity in the fixed frame from the rates of the Euler angles
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 f418037614354fc95575c5aec827f9f49fc347c491c4170e0c6ec842a5a94a3b
 */
void chasles_euler_rate_matrix_zyz(const double angles[3], double W[9]);
void chasles_euler_rate_matrix_zyzf(const float angles[3], float W[9]);
void chasles_euler_rate_matrix_zyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W, ptrdiff_t W_step);
void chasles_euler_rate_matrix_zyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W, ptrdiff_t W_step);

/*
 * Ex 3.10 The angular velocity, in the body frame, from the rates of Euler angles about z, y, z.
 *   given       angles[3]: Euler angles, in the order of the turns
 *   returns     W_body[9]: angular velocity in the body frame from those rates
 *   verdict     defined
 *   assumes     nothing
 *   operations  6: 2 multiply, 2 sine, 2 cosine
 *   derivation  sha256 3ef03099d7065afdf2c43a90443a389d8fd659ce4ef8f0db395cc2d6f5b9a4cf
 */
void chasles_euler_rate_matrix_body_zyz(const double angles[3], double W_body[9]);
void chasles_euler_rate_matrix_body_zyzf(const float angles[3], float W_body[9]);
void chasles_euler_rate_matrix_body_zyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    double *W_body, ptrdiff_t W_body_step);
void chasles_euler_rate_matrix_body_zyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    float *W_body, ptrdiff_t W_body_step);

/*
 * Ex 3.10 The rates of Euler angles about z, y, z from the angular velocity in the fixed frame.
 *   given       angles[3]: Euler angles, in the order of the turns
 *               omega[3]: angular velocity
 *   returns     theta_dot[3]: rates of the Euler angles
 *   verdict     holds under
 *   assumes     sin(theta_2) != 0
 *   operations  13: 1 add, 2 subtract, 5 multiply, 1 divide, 2 sine, 2 cosine
 *   derivation  sha256 b611c82c8754e1d16d209c861db78e54b286288315a5f5818e43a985e2b73890
 */
void chasles_euler_rates_zyz(const double angles[3], const double omega[3], double theta_dot[3]);
void chasles_euler_rates_zyzf(const float angles[3], const float omega[3], float theta_dot[3]);
void chasles_euler_rates_zyz_batch(
    size_t count,
    const double *angles, ptrdiff_t angles_step,
    const double *omega, ptrdiff_t omega_step,
    double *theta_dot, ptrdiff_t theta_dot_step);
void chasles_euler_rates_zyz_batchf(
    size_t count,
    const float *angles, ptrdiff_t angles_step,
    const float *omega, ptrdiff_t omega_step,
    float *theta_dot, ptrdiff_t theta_dot_step);

#ifdef __cplusplus
}
#endif

#endif
