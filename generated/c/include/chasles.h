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
 *   derivation  sha256 1dcc0e58f219711b3c3f86b749f8c10b4db63734a02b20de3d9c405c9765483d
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
 *   derivation  sha256 dd485fc9fc55c9da723bbd623b2225ec82c9e8dbfe322dbf4dfe768c7d30e93a
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
 *   derivation  sha256 8dec2f77245ea565b5836a20411e5ad44d44cd04431c5873936f452f27a3d0d8
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
 *   derivation  sha256 9fa70ee61f0b9bb672e1d252a785256ee0efa914ad0cd98e0f8b625148dc2526
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
 *   operations  17: 3 add, 1 subtract, 11 multiply, 1 divide, 1 sine
 *   derivation  sha256 1a335cc68a85257903e9024003c40a39af04dc468b703619f454e7c6495b1c9c
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
 *   made of     an offered form, proved equal to the statement
 *   operations  39: 5 add, 12 subtract, 19 multiply, 1 divide, 1 sine, 1 cosine
 *   derivation  sha256 fd931c592a794abc154e30cb8754cc954c9fa9f827a0928a1e82185b1b2a8b81
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
 *   derivation  sha256 32c3975b5a0a9106d94e083a43fadc2be5fbb7bda4c600d797436f2a818ba4e5
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
 *   derivation  sha256 6d53a1bee79a6a2a63aafa29de9b2815a5d19f7d96ef743e8fd201bd98bf5faf
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
 *   derivation  sha256 a313dee3a60fe53c64ee29561afa9e0c70338ba74cee754e191c28c83bf76b8b
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
 *   derivation  sha256 f83fa1168a58e1ad3de64ee9e12106ddba140b95a4dbcc601f4d839fc18a8c59
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
 *   derivation  sha256 eef426f5d7859632880c7bcf2a415552347ee2d2214c68480bc7e54584caa69a
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
 *   derivation  sha256 69100a7f8d1911cfd9ed2c547c34eeace5ec9862641c5fd2ca3d352c7d28fbce
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
 *   operations  26: 6 add, 3 subtract, 14 multiply, 1 divide, 1 sine, 1 cosine
 *   derivation  sha256 ae8848864c3fe36678c44ede0fea89f8af655c143bdb95acf6bb13cd98cc80e0
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
 *   operations  30: 4 add, 7 subtract, 17 multiply, 1 sine, 1 cosine
 *   derivation  sha256 dc969a2458fb1ccbe6cf9ba4bd5c14c48137796a5e63b6fdffe960bc3f43a806
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
 *   derivation  sha256 6c847b4baa2596c76e6ab0bd3e04d8ba67a999fd27b87b011fca1a1dab6d4147
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
 *   derivation  sha256 ea28f0fa942d584b259525e962097be1354ff910cf1b14cdaa065f0e8a7de393
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
 *   derivation  sha256 99a4cba6f6c99cb900d6e9c9d4e2ef7a5715571273dafc564f29ffd0f7b85f0c
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
 *   derivation  sha256 36a144798681f302cdd381b0fc0940a897d02a61242017e7c9f898db6791c1be
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
 *   operations  53: 21 add, 6 subtract, 18 multiply, 5 divide, 2 square root, 1 arctangent2
 *   derivation  sha256 f6db87ef99fe37db2f0d351213905d1725fdcbd16df90dfcc90d2309919696bc
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
 *   derivation  sha256 a67e13328e4829418ed30de028f2dc8c77a4a793125037bcb24b15ce06ed4e8d
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
 *   made of     an offered form, proved equal to the statement
 *   operations  101: 29 add, 18 subtract, 45 multiply, 6 divide, 2 square root, 1 arctangent2
 *   derivation  sha256 5be5bc60ede989c44ecefe4964d4e3944980162a66d38ce9b77bc14e52d347b9
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
 *   made of     an offered form, proved equal to the statement
 *   operations  38: 7 add, 6 subtract, 18 multiply, 6 divide, 1 square root
 *   derivation  sha256 dcfbe1b42ac109be9bb08df3887a890056a782dca2f6125b033caba6bcc91f78
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
 *   derivation  sha256 8f59c5ef77909eadf927c6b687cd3bab0b77e8cdc9373e233171e72268eed1b1
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
 *   operations  7: 4 multiply, 1 divide, 1 sine, 1 cosine
 *   derivation  sha256 89a180463935f0c42617efa0988e0354bd46d74d20a13999139be0c69246d5f3
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
 *   derivation  sha256 2f21b7ee20e1702180f136497178c100314ca7d0df136dd2feb59d1f89a6b375
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
 *   operations  34: 5 add, 6 subtract, 20 multiply, 1 divide, 1 sine, 1 cosine
 *   derivation  sha256 03378dde89c3aaac2473eda92712bf10969b44e2791c52441961929bbc3faff7
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
 *   operations  44: 5 add, 10 subtract, 27 multiply, 1 sine, 1 cosine
 *   derivation  sha256 485b60f5c3aeac6ce1e8f47296c4e310a527f2526b4ca7577ff63944281afba0
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
 *   derivation  sha256 339dc61f9ddbbce6d47832bfa5f83511f919dfb2680d41f08f397cc5f5818873
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
 *   derivation  sha256 a734862884a894688cc48e122cf5f84242a09356a3b59996da7ceca338c88bee
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
 *   operations  25: 3 add, 6 subtract, 13 multiply, 1 divide, 1 sine, 1 cosine
 *   derivation  sha256 2198ea1ef9b2a1092af274c28947c46ea9dcee1755b4d2bfeb21915eae15ec77
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
 *   derivation  sha256 706de516b3cc18711578a88117494ee18e5fa90ed73390c6b7020956353b1361
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
 *   derivation  sha256 3219ddd73c3c590a6566e28a84076f81cbaba27a5a84b161382d2076d953c075
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
 *   derivation  sha256 5052f47f7af7362fc9f1cf608959b53ca94e5f5f25d07beebb01e47a3cc3a950
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
 *   derivation  sha256 509ca9167167321c3bf15892dea6aa573b67b0b686ac57a5125297033e3c4c92
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
 * text 3.5 f The rate of N by axis, angle and angular velocity: (3.96a).
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               omega[3]: angular velocity
 *   returns     N_dot[12]: time derivative of: natural invariants' rates from the angular velocity
 *   verdict     holds under
 *   assumes     |e| = 1
 *               phi != 0
 *   made of     an offered form, proved equal to the statement
 *   operations  70: 15 add, 12 subtract, 40 multiply, 1 divide, 1 sine, 1 cosine
 *   derivation  sha256 3c115a1d3fcae54bbeeab575bcfe37896272cabbcd5299367347e94d05505538
 */
void chasles_natural_rate_matrix_dot(
    const double e[3],
    double phi,
    const double omega[3],
    double N_dot[12]);
void chasles_natural_rate_matrix_dotf(
    const float e[3],
    float phi,
    const float omega[3],
    float N_dot[12]);
void chasles_natural_rate_matrix_dot_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *omega, ptrdiff_t omega_step,
    double *N_dot, ptrdiff_t N_dot_step);
void chasles_natural_rate_matrix_dot_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *omega, ptrdiff_t omega_step,
    float *N_dot, ptrdiff_t N_dot_step);

/*
 * text 3.5 f The rate of L by axis, angle and angular velocity: (3.96b).
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               omega[3]: angular velocity
 *   returns     L_dot[12]: time derivative of: linear invariants' rates from the angular velocity
 *   verdict     holds under
 *   assumes     |e| = 1
 *   made of     an offered form, proved equal to the statement
 *   operations  73: 12 add, 16 subtract, 43 multiply, 1 sine, 1 cosine
 *   derivation  sha256 8aa28868af688e963d340ae3c868f70968a352340b527f20d951c42982b7af63
 */
void chasles_linear_rate_matrix_dot(
    const double e[3],
    double phi,
    const double omega[3],
    double L_dot[12]);
void chasles_linear_rate_matrix_dotf(
    const float e[3],
    float phi,
    const float omega[3],
    float L_dot[12]);
void chasles_linear_rate_matrix_dot_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *omega, ptrdiff_t omega_step,
    double *L_dot, ptrdiff_t L_dot_step);
void chasles_linear_rate_matrix_dot_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *omega, ptrdiff_t omega_step,
    float *L_dot, ptrdiff_t L_dot_step);

/*
 * text 3.5 f The rate of H by axis, angle and angular velocity: (3.96c).
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               omega[3]: angular velocity
 *   returns     H_dot[12]: time derivative of: Euler-Rodrigues parameters' rates from the angular
 *                 velocity
 *   verdict     holds under
 *   assumes     |e| = 1
 *   made of     an offered form, proved equal to the statement
 *   operations  28: 2 add, 6 subtract, 18 multiply, 1 sine, 1 cosine
 *   derivation  sha256 754b683d0e2c92139871e4f82c5c3d339de7416b6c42edbdf4946260dad2de76
 */
void chasles_euler_rodrigues_rate_matrix_dot(
    const double e[3],
    double phi,
    const double omega[3],
    double H_dot[12]);
void chasles_euler_rodrigues_rate_matrix_dotf(
    const float e[3],
    float phi,
    const float omega[3],
    float H_dot[12]);
void chasles_euler_rodrigues_rate_matrix_dot_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *omega, ptrdiff_t omega_step,
    double *H_dot, ptrdiff_t H_dot_step);
void chasles_euler_rodrigues_rate_matrix_dot_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *omega, ptrdiff_t omega_step,
    float *H_dot, ptrdiff_t H_dot_step);

/*
 * text 3.5 g The rate of the left inverse of N by axis, angle and angular velocity: (3.97a).
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               omega[3]: angular velocity
 *   returns     N_tilde_dot[12]: time derivative of: angular velocity from the natural invariants'
 *                 rates
 *   verdict     holds under
 *   assumes     phi != 0
 *               |e| = 1
 *   operations  55: 8 add, 10 subtract, 34 multiply, 1 divide, 1 sine, 1 cosine
 *   derivation  sha256 19863f6f4160a8a634f70ca7c440674c168657bfb296c6deeee12a25d278e40e
 */
void chasles_natural_velocity_matrix_dot(
    const double e[3],
    double phi,
    const double omega[3],
    double N_tilde_dot[12]);
void chasles_natural_velocity_matrix_dotf(
    const float e[3],
    float phi,
    const float omega[3],
    float N_tilde_dot[12]);
void chasles_natural_velocity_matrix_dot_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *omega, ptrdiff_t omega_step,
    double *N_tilde_dot, ptrdiff_t N_tilde_dot_step);
void chasles_natural_velocity_matrix_dot_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *omega, ptrdiff_t omega_step,
    float *N_tilde_dot, ptrdiff_t N_tilde_dot_step);

/*
 * text 3.5 g The rate of the left inverse of L by axis, angle and angular velocity: (3.97b).
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               omega[3]: angular velocity
 *   returns     L_tilde_dot[12]: time derivative of: angular velocity from the linear invariants'
 *                 rates
 *   verdict     holds under
 *   assumes     |e| = 1
 *               phi != pi
 *   operations  34: 5 add, 6 subtract, 20 multiply, 1 divide, 1 sine, 1 cosine
 *   derivation  sha256 82b6df6fa971c168909dbaa81a29fa88437d6ba2ce84ee1f248bae95ba5de0d5
 */
void chasles_linear_velocity_matrix_dot(
    const double e[3],
    double phi,
    const double omega[3],
    double L_tilde_dot[12]);
void chasles_linear_velocity_matrix_dotf(
    const float e[3],
    float phi,
    const float omega[3],
    float L_tilde_dot[12]);
void chasles_linear_velocity_matrix_dot_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *omega, ptrdiff_t omega_step,
    double *L_tilde_dot, ptrdiff_t L_tilde_dot_step);
void chasles_linear_velocity_matrix_dot_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *omega, ptrdiff_t omega_step,
    float *L_tilde_dot, ptrdiff_t L_tilde_dot_step);

/*
 * text 3.5 g The rate of the left inverse of H by axis, angle and angular velocity: (3.97c).
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               omega[3]: angular velocity
 *   returns     H_tilde_dot[12]: time derivative of: angular velocity from the Euler-Rodrigues
 *                 parameters' rates
 *   verdict     holds under
 *   assumes     |e| = 1
 *   operations  26: 2 add, 6 subtract, 16 multiply, 1 sine, 1 cosine
 *   derivation  sha256 e8802d7a5c9744a250dd64db89ff7dd1c3937e06faa82b3162d9751ea1bee3a6
 */
void chasles_euler_rodrigues_velocity_matrix_dot(
    const double e[3],
    double phi,
    const double omega[3],
    double H_tilde_dot[12]);
void chasles_euler_rodrigues_velocity_matrix_dotf(
    const float e[3],
    float phi,
    const float omega[3],
    float H_tilde_dot[12]);
void chasles_euler_rodrigues_velocity_matrix_dot_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *omega, ptrdiff_t omega_step,
    double *H_tilde_dot, ptrdiff_t H_tilde_dot_step);
void chasles_euler_rodrigues_velocity_matrix_dot_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *omega, ptrdiff_t omega_step,
    float *H_tilde_dot, ptrdiff_t H_tilde_dot_step);

/*
 * text 3.5 h The second rate of the pose from the twist and its rate, with the natural invariants.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *               t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   returns     s_ddot[7]: second time derivative of: pose array
 *   verdict     holds under
 *   assumes     |e| = 1
 *               phi != 0
 *   made of     an offered form, proved equal to the statement
 *   operations  96: 19 add, 19 subtract, 55 multiply, 1 divide, 1 sine, 1 cosine
 *   derivation  sha256 4016aa7db0685f76cc1354a5be5d4f3b9174d394e8a51db1ae7b8c4d7a4506f9
 */
void chasles_pose_acceleration_natural(
    const double e[3],
    double phi,
    const double t[6],
    const double t_dot[6],
    double s_ddot[7]);
void chasles_pose_acceleration_naturalf(
    const float e[3],
    float phi,
    const float t[6],
    const float t_dot[6],
    float s_ddot[7]);
void chasles_pose_acceleration_natural_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *t, ptrdiff_t t_step,
    const double *t_dot, ptrdiff_t t_dot_step,
    double *s_ddot, ptrdiff_t s_ddot_step);
void chasles_pose_acceleration_natural_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *t, ptrdiff_t t_step,
    const float *t_dot, ptrdiff_t t_dot_step,
    float *s_ddot, ptrdiff_t s_ddot_step);

/*
 * text 3.5 h The second rate of the pose from the twist and its rate, with the linear invariants.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *               t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   returns     s_ddot[7]: second time derivative of: pose array
 *   verdict     holds under
 *   assumes     |e| = 1
 *   made of     an offered form, proved equal to the statement
 *   operations  76: 11 add, 18 subtract, 45 multiply, 1 sine, 1 cosine
 *   derivation  sha256 1dd18f23ecf1f6c4aaa22aa811368a7d8f941d39537bcce402e9eec8c90c8c98
 */
void chasles_pose_acceleration_linear(
    const double e[3],
    double phi,
    const double t[6],
    const double t_dot[6],
    double s_ddot[7]);
void chasles_pose_acceleration_linearf(
    const float e[3],
    float phi,
    const float t[6],
    const float t_dot[6],
    float s_ddot[7]);
void chasles_pose_acceleration_linear_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *t, ptrdiff_t t_step,
    const double *t_dot, ptrdiff_t t_dot_step,
    double *s_ddot, ptrdiff_t s_ddot_step);
void chasles_pose_acceleration_linear_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *t, ptrdiff_t t_step,
    const float *t_dot, ptrdiff_t t_dot_step,
    float *s_ddot, ptrdiff_t s_ddot_step);

/*
 * text 3.5 h The second rate of the pose from the twist and its rate, with the Euler-Rodrigues
 *   parameters.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               t[6]: twist: angular velocity, velocity of a landmark point
 *               t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   returns     s_ddot[7]: second time derivative of: pose array
 *   verdict     holds under
 *   assumes     |e| = 1
 *   made of     an offered form, proved equal to the statement
 *   operations  45: 5 add, 9 subtract, 29 multiply, 1 sine, 1 cosine
 *   derivation  sha256 497bd118c4697ff0a2f2e013238e12a04e5f21de44b395acac0f75da80c399ad
 */
void chasles_pose_acceleration_euler_rodrigues(
    const double e[3],
    double phi,
    const double t[6],
    const double t_dot[6],
    double s_ddot[7]);
void chasles_pose_acceleration_euler_rodriguesf(
    const float e[3],
    float phi,
    const float t[6],
    const float t_dot[6],
    float s_ddot[7]);
void chasles_pose_acceleration_euler_rodrigues_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *t, ptrdiff_t t_step,
    const double *t_dot, ptrdiff_t t_dot_step,
    double *s_ddot, ptrdiff_t s_ddot_step);
void chasles_pose_acceleration_euler_rodrigues_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *t, ptrdiff_t t_step,
    const float *t_dot, ptrdiff_t t_dot_step,
    float *s_ddot, ptrdiff_t s_ddot_step);

/*
 * text 3.5 i The rate of the twist from the rates of the pose, with the natural invariants.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               s_dot[7]: time derivative of: pose array
 *               s_ddot[7]: second time derivative of: pose array
 *   returns     t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   verdict     holds under
 *   assumes     |e| = 1
 *   made of     an offered form, proved equal to the statement
 *   operations  51: 13 add, 7 subtract, 29 multiply, 1 sine, 1 cosine
 *   derivation  sha256 1ee4878567ced9e9e5f5c92ed6f91c761e86aebce629b32afb3bc79b0d919718
 */
void chasles_twist_rate_from_pose_natural(
    const double e[3],
    double phi,
    const double s_dot[7],
    const double s_ddot[7],
    double t_dot[6]);
void chasles_twist_rate_from_pose_naturalf(
    const float e[3],
    float phi,
    const float s_dot[7],
    const float s_ddot[7],
    float t_dot[6]);
void chasles_twist_rate_from_pose_natural_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *s_dot, ptrdiff_t s_dot_step,
    const double *s_ddot, ptrdiff_t s_ddot_step,
    double *t_dot, ptrdiff_t t_dot_step);
void chasles_twist_rate_from_pose_natural_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *s_dot, ptrdiff_t s_dot_step,
    const float *s_ddot, ptrdiff_t s_ddot_step,
    float *t_dot, ptrdiff_t t_dot_step);

/*
 * text 3.5 i The rate of the twist from the rates of the pose, with the linear invariants.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               s_dot[7]: time derivative of: pose array
 *               s_ddot[7]: second time derivative of: pose array
 *   returns     t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   verdict     holds under
 *   assumes     |e| = 1
 *               phi != pi
 *   made of     an offered form, proved equal to the statement
 *   operations  52: 6 add, 15 subtract, 27 multiply, 2 divide, 1 sine, 1 cosine
 *   derivation  sha256 b36cfa7a7e7a476dc9e80fa81df2e264c9919aab5b9778cafa13b132b29f2bb3
 */
void chasles_twist_rate_from_pose_linear(
    const double e[3],
    double phi,
    const double s_dot[7],
    const double s_ddot[7],
    double t_dot[6]);
void chasles_twist_rate_from_pose_linearf(
    const float e[3],
    float phi,
    const float s_dot[7],
    const float s_ddot[7],
    float t_dot[6]);
void chasles_twist_rate_from_pose_linear_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *s_dot, ptrdiff_t s_dot_step,
    const double *s_ddot, ptrdiff_t s_ddot_step,
    double *t_dot, ptrdiff_t t_dot_step);
void chasles_twist_rate_from_pose_linear_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *s_dot, ptrdiff_t s_dot_step,
    const float *s_ddot, ptrdiff_t s_ddot_step,
    float *t_dot, ptrdiff_t t_dot_step);

/*
 * text 3.5 i The rate of the twist from the rates of the pose, with the Euler-Rodrigues parameters.
 *   given       e[3]: unit vector along the axis of rotation, or along a line
 *               phi: angle of rotation
 *               s_dot[7]: time derivative of: pose array
 *               s_ddot[7]: second time derivative of: pose array
 *   returns     t_dot[6]: time derivative of: twist: angular velocity, velocity of a landmark point
 *   verdict     holds under
 *   assumes     |e| = 1
 *   made of     an offered form, proved equal to the statement
 *   operations  29: 3 add, 6 subtract, 18 multiply, 1 sine, 1 cosine
 *   derivation  sha256 a538b1cabd960fd935777104bc5e045b226a0649cbc788f00cc07c8ee401013c
 */
void chasles_twist_rate_from_pose_euler_rodrigues(
    const double e[3],
    double phi,
    const double s_dot[7],
    const double s_ddot[7],
    double t_dot[6]);
void chasles_twist_rate_from_pose_euler_rodriguesf(
    const float e[3],
    float phi,
    const float s_dot[7],
    const float s_ddot[7],
    float t_dot[6]);
void chasles_twist_rate_from_pose_euler_rodrigues_batch(
    size_t count,
    const double *e, ptrdiff_t e_step,
    const double *phi, ptrdiff_t phi_step,
    const double *s_dot, ptrdiff_t s_dot_step,
    const double *s_ddot, ptrdiff_t s_ddot_step,
    double *t_dot, ptrdiff_t t_dot_step);
void chasles_twist_rate_from_pose_euler_rodrigues_batchf(
    size_t count,
    const float *e, ptrdiff_t e_step,
    const float *phi, ptrdiff_t phi_step,
    const float *s_dot, ptrdiff_t s_dot_step,
    const float *s_ddot, ptrdiff_t s_ddot_step,
    float *t_dot, ptrdiff_t t_dot_step);

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
 *   derivation  sha256 da9e7c4331821e757d302e254d79b3fee81482b88d26f706b39478d1aa475204
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
 *   made of     an offered form, proved equal to the statement
 *   operations  87: 30 add, 9 subtract, 48 multiply
 *   derivation  sha256 51d23e357b694311f35e12a90fa88b735e9f687f6627b8c6348ec8c96d4e42e5
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
 *   made of     an offered form, proved equal to the statement
 *   operations  38: 7 add, 6 subtract, 18 multiply, 6 divide, 1 square root
 *   derivation  sha256 c78cfc23a3b398d6195b8dc68c79e9bdceefc46df0b8a9442885e124035211ef
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
 *   derivation  sha256 580a9557b1b4b779955409e7506c76202ce3a1e9982d422e1491bf0bcad680ef
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
 *   derivation  sha256 69eafb582289fe007146884f233005913bd49126222273503197968fd6ef8dd3
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
 *   derivation  sha256 9cbbd4d64a694c0150c2c0a241ceaa9fe43fa91e335dce95c4c39681e8ecce3c
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
 *   operations  24: 6 add, 9 subtract, 9 multiply
 *   derivation  sha256 aba83f2bd3e1166b795e47c43b448bc59b7660cf5111023a5f72b29e4ca2087d
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
 *   derivation  sha256 710d57383413bed6baf901762b3882a8ecf77afb22a27bf8365ff0c92c4546d6
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
 *   derivation  sha256 4b9e9fcfb9d3f04a872f3404b762a9c889a518c95015ce9a8c1ae5aaa464aa59
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
 *   derivation  sha256 d7b89fc9d9f1d1f6e7c4726a8c6b262312af5cbe7c335bfef62828b9f7874101
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
 *   derivation  sha256 0081ef2d815df5f9b649473f8486474536d4b3b5431fee899b9a96105cb8def7
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
 *   operations  24: 6 add, 9 subtract, 9 multiply
 *   derivation  sha256 1c4bb601cd0998fc0bfe9b387910f33fab442c97036ac86000fc8d66e444e923
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
