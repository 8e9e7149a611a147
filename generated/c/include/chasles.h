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
 *   error bound exact, for all inputs
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
 *   error bound 6.1 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
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
 *   expects     Q is a rotation
 *   operations  21: 9 add, 3 subtract, 9 multiply
 *   error bound 5.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 af99d11eca408718e24cab7a00a1fd908df2c4445259caf108fa6366c29b6560
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
 *   error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 a00b650de0c575f7c9b2294f993cd4d248ffaaa64b28a7f2d4581cd5c90cdf7f
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
 *   error bound 8.4 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine within 0.8 ulp
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
 *   error bound 9.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
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
 *   operations  24: 2 add, 6 subtract, 9 multiply, 6 divide, 1 square root
 *   error bound 9.51 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
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
 *   error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
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
 *   expects     triad is a rotation
 *               triad' is a rotation
 *   operations  45: 18 add, 27 multiply
 *   error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 17b2c6690d171cd369c93be59a7a8c3b70bc0108c48d7358142e2312ebf805ee
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
 *   error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 0c12a1c3d699670fac6168e45da2070083d35015f2bd6eac4cd2f1464da2b780
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
 *   error bound 1.01 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 8c4348a6af61531ef5e1d340b707a886d5ae17216e0e81a5fdda49099e70eece
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
 *   error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 b5acf63f8b2ae232595725548e5ba32264be6bf6d52d501066130e78c9ed0486
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
 * (3.70) The point of the instant screw axis nearest the origin, with vector products.
 *   given       omega[3]: angular velocity
 *               a_dot[3]: time derivative of: position of the landmark point A
 *               a[3]: position of the landmark point A
 *   returns     p_0_prime[3]: position of the point of the instant screw axis nearest the origin
 *   verdict     holds under
 *   assumes     omega != 0
 *   operations  35: 2 add, 9 subtract, 15 multiply, 9 divide
 *   error bound 13.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 8add5ae098bd1648bf2231d712391a8ce89357247f8df1a150855707c8b25192
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
 *   error bound 6.0 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
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
 *   error bound 5.2 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
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
 *   error bound 2.61 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
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
 *   expects     |[q, q_0]| = 1
 *               1 + q_0 != 0
 *   operations  20: 7 add, 3 subtract, 9 multiply, 1 divide
 *   error bound 5.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 19e234a754a5568e2a2452e2008c17414b949e07381e92256366ba6cc7d976bb
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
 *   error bound 5.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 767311161fbd53fb1cb19724605fdf117b3445cf5f7cf313ccc6ecbf4a40f8c5
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
 *   error bound q: 1.01 u of itself, for all inputs
 *               q_0: 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 dd83557748f8a3babd3f50468d387276f7ffb668b7fc29c093a7976e71eaabef
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
 *               phi != 0
 *   operations  63: 23 add, 7 subtract, 22 multiply, 8 divide, 2 square root, 1 arctangent2
 *   error bound e: 13.16 u of itself, for every rotation Q, beside the case that is taken
 *               phi: 26.99 u of itself, for every rotation Q, beside the case that is taken; u =
 *                 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, arctangent within 1
 *                 ulp
 *   derivation  sha256 167078e6ba9dff78870c0f0ddc85370ad11a1b0b824ddf316c3c9f19bd756081
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
 *   operations  50: 21 add, 7 subtract, 17 multiply, 4 divide, 1 square root
 *   error bound q: 11.66 u of itself, for every rotation Q, beside the case that is taken
 *               q_0: 9.34 u of itself, for every rotation Q, beside the case that is taken; u = 2^-53,
 *                 in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 acb16a335b8480158c7d6e339e4c3de8c51cf3bffd9594c8aa4b639840b77580
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
 *   derivation  sha256 b75d13b9d08f2ed9d5e5662876d264ac1f58472af4d4679a5aab80381c630eaf
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
 *   error bound 2.3 u of the largest entry, for every unit e and every phi; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
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
 *   error bound 5.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
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
 *   error bound 2.61 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
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
 *   error bound 11.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 e2dfaa3aa3fac1f79b45222f3204af5a75f395308f6b3f9290346729c641eaf1
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
 *   error bound 9.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 30ffb709cd3b1987574a6cb20949774164c18855b55a74fc172537bd3a7138a3
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
 *   error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 4e8860fe94d4e257f6a09561ef25e7c999ddca2a00337fe8774fc0c2b9433a22
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
 *   error bound 2.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 600ac9c19e353f65970adc87c2c9e1aba7f40174fd2c1780126b444caebb2a29
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
 *   error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 52077d75d24e72b9e016304332b02aeb13ece6765a6f5dff5b9cb8261bc6ae26
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
 *   error bound 20.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 c61d5578f7455d9deb930e9132cffeae9f18b18b83cb0ba9b49a6c83cd285a96
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
 *   error bound 10.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 e58c3cd056fca600a3d8fabc77cc08383708b30fcd3f10997c5760ad3d813719
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
 *   error bound 5.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 cbbc7c4a0ec6ff7289faa80a566dfa4879a785dc3e1fcb665d781015958b3b92
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
 *   error bound 11.21 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 71e01d77b3ea46f745a9336a2825937c48ecfb5c8f22e156a02b1d41218c2c74
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
 *   error bound 16.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 b5286c2c91a7b4cfdc8d341b90ed08a2a37fc92a9f25530860458e82f6eaacf3
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
 *   error bound 5.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 c80e798e741899e2d32fd6b3e16a5b786d0f82ee47987a537c4755eed1b60850
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
 *   error bound 25.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 d4b56350899a19bcc149b55d1279747465f4ffc9ff92ea858cdd2e564e99ca62
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
 *   error bound 12.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 1588dcded7d741e99e263e63960b704faab031996a2d165fbbe2b322357ed2e9
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
 *   error bound 7.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 0f21a42c6c8b20a3978874f3add6fcde6371416fd40cc41c5da50d8f4cd6babd
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
 *   error bound 8.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 46142537f8f2d352235601f0fe20d7417a8415c4299de5fde88c9772c1d5b072
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
 *   error bound 16.41 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 e60a5e59bbc9bfff80fda29a99e2165c18777756e0d5ef482d146ef9b36646a2
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
 *   error bound 6.61 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 8f9dc9af1023fade3eb622411945883078b1f62098c7b9178f68aed0ef63d94d
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
 *   expects     Q is a rotation
 *   operations  45: 18 add, 3 subtract, 24 multiply
 *   error bound 7.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 b4941bd3b3f57c83b14de8fd13a10f996bcfeb8ee7bfc4215c85ab50fb9b8b33
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
 *   made of     an offered form, proved equal to the statement
 *   operations  87: 30 add, 9 subtract, 48 multiply
 *   error bound 10.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 985f244a1c015e00a6d544a9a346e7446722d3d1972e549159bc1a6a90456d40
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
 *   operations  45: 7 add, 6 subtract, 18 multiply, 13 divide, 1 square root
 *   error bound axis: 21.51 u of the sum of its terms' sizes, for all inputs
 *               pitch: 14.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single
 *                 precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
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
 *   error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
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
 *   error bound 6.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
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
 *   error bound 4.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
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
 *   error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 6db3e3a77ef9af159d0c096ec679c53626cff81d41ccfbcc2a4db4833ae93473
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
 *   error bound 3.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 6db3e3a77ef9af159d0c096ec679c53626cff81d41ccfbcc2a4db4833ae93473
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
 *   error bound 9.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 69297c38ebd3f2599e0000c019f576151ae0e8d563b8a02661f982c45230000e
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
 *   error bound 9.01 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA
 *   derivation  sha256 69297c38ebd3f2599e0000c019f576151ae0e8d563b8a02661f982c45230000e
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
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 49974e148b9969b7a23a303df375f906766eda03e5d7416d35c36a35c77fea06
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 15ec222e6a4c0d4af15dcf0f4f9d944364836080f80ed845b4661afb074e1ca1
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 cd8589089d7d47765a04b183158736b0b971b8a8d922838283fa2c2975eb5d89
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
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 6b432c618a3b5cb7132a0a1625419f24b2800b22e52d8f8b5202e756b67ea148
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
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 f87af8285d9801669ca9041e726f9817a40f9c95ddf51a655b261236297c04af
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 1d2f362d906c9640bebb7713dd74f3809ce202cd977dff0cc4c827b77ce9d4d3
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 d605f1f844caa8fe73209313f2debbc7dad841db4b625533c1925d350b88b35f
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
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 379cc15712b3f593e6a56a0586d8cb970b2c344caf9eff56d13b4aa0f2bc0fcb
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
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 509556f6df445dd3c7fe5324e0ad671112ed8aaa27442b8973ddf4f722eb8d9b
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 063a79927c0f405045ca7f3a4600867811265ae8101b11b64e443152cd0965cf
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 5092f84c7bbb66afac08e51bc82a4ea4bdc4738a19463c52fc60c25d1976c154
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
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 d60392e777e2f94766ccb4868d6a376f4b8f702f6466c7841c3f0e7493778009
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
 *   error bound 5.3 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 6a4fd734359cc43f74679d358abf691bfd6612dbcd721aa9a209c64050a5d383
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 f4bf5edc3a0e9199cc30c83f6cab51d6bfce7ab2a3d75f59608b337bed74824b
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 34b232afb99ddc1be46962d797e1c08bda20904a656a165ee2fc2232e4beec57
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
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 47b386989c7014707637badfc0f665d8b17c2674e34c6dc85b34228d94dd802e
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
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 42de6926cd35f5c06da566065b065c8ba754cee65703557fa42410e42dde4a35
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 ab9e4f4d487ee038942cc83869848be5fa4c534a19c656164684f27e1b65ac10
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 2a86c48257dda6a27e84a7fb3b0817bd24bdff1a56c2bfeb6119d778d89bbab6
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
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 8c7b412f940aadc89ad8c5ce3785c5c0ca8dcbf9e58aac6572334181799e61e2
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
 *   error bound 5.3 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 aac4d38f938bc0f3b21fc5113a3e553f105a0b99bd2a46001cf5af56197be36a
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 f673622637ac9520cdbbfacd9038ad6a42d7de01d522fe1daa4e4ed5a188d584
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 a7f0e1639e85f122dde538fce97f31e9e4f583cf9ea5d074345d45245ff26ea8
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
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 bf11bed82696038fa225e27a75acb0d41b63af31adb0153ca5a712167c4d8284
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
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 73ccad1507926c77a4de1804d6ccee68b6eedcb0a87a5d797076c3aaa328556a
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 6bc14177fe8f581b737fd8108f75cca27c80f0c6043e24f8d305941c720fb93e
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 ba974c498d2395f78752b5b9af3bd25c9bc8814b82f34bc12080e7f58fc39384
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
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 404a3dd7a9f43dbf16ca707d83946fda23f95d1982dc848908ed679160d5cc5f
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
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 fc249fbe7ecf26a2cf23c7eb4a1ae340b6f6d6b71fd0a11c005275bed3b0541a
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 ba3b9e2e5d19a42bcccf4fe889ac0ad5e1476885d7d3f35174490738c07caa93
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 2906ed860e470e86a10fba075e603a757d21feeb996fd012d6a5c352f1f248cf
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
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 fbcf58ed5fb921bfdeae731af0d22be0b18c057d4ab3433941bb486f4f2ac07a
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
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 00df5b3e078a442b89ec92320b9be4d00f69c8c69b5377ceed30ce97167894d8
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 66b9e91ee2080f4af362adbd4cfbd2f6493f2d49f04e969606b8e5e66a892530
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 ee0e5dc36786ec147d7731e28a73445f4829a353e033fb0bdf99f16a9ae96d67
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
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 f15319cb143e29fdad80688ea5d83794cf5328509c5cd1fb52fa078f77b2a785
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
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 90292a7b1973bd54561384a1b0aca95f4b081c5031f08a71f5bf1eeb509996f8
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 d6bac485f18ebb57e7adb1eb90896adee410e33308c5db55212969aa010526ee
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 22c895ea0aa33cf27a73432cf9b7edd645045c890d81351055832ab2e86d2ae0
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
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 9730082636217a13ed6443b9376e26c825640305348e897e3b1e8d20d25ad893
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
 *   error bound 5.3 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 77eae5b015783de7dba57287593533e40a4bf6d57321c5d7151d36cf1a028acc
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 0adf0d7abfcbe1f817931814b81c15a9c846b1c73dcdb818878d86351c757b6d
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 6a7529b4dd785268409cc92077030a4cad8a64439e696ba9dfa305974e76a7df
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
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 f6fb3a6381c9037e8d1dbd8e1df9c051262d4c72bd9738451555e59c302f0f09
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
 *   error bound 5.4 u of the largest entry, for all angles; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 35a70c6c05dd2903cd2f50766b4e415a63eb2ffed2c6d3e412124e8647c7b716
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 2df872f3e6c29262a9a735f3e6450ce704e08a1b40b33a555d7636f417131edb
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
 *   error bound 4.21 u of itself, for all inputs; u = 2^-53, in single precision 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 0e8fa3809441be1ebd1a102ce8fc5b78357d823973bbc7bac7e1da5c7ce38790
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
 *   error bound 9.81 u of the sum of its terms' sizes, for all inputs; u = 2^-53, in single precision
 *                 2^-24
 *               supposed: every operation rounded to nearest, with or without FMA, sine and cosine
 *                 within 0.8 ulp
 *   derivation  sha256 c8e47ebca1883ce144424c202eb73e0d953be9339e55743f954ebc4ff9aaa9f5
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
