/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* Kernels emitted from checked equations. Made by `chasles emit`; not to be edited by hand.
 *
 * C99; needs the standard library alone. Nothing is allocated, no state is kept, errno is not used.
 * Each kernel has a line: its equation, its inputs -> its results, and the file in which its contract stands.
 * A matrix is its numbers, row by row; angles are in radians.
 * Units are SI. 3 x 3 matrices act on columns from the left. Twists hold the angular part first and wrenches the
 * moment first. Euler angles come in the order of the turns, each about an axis as the turns before have left it.
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

/* (2.38) v[3] -> V[9]; src/section_3_2.c */
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

/* (2.49) e[3], phi -> Q[9]; src/section_3_2.c */
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

/* (3.2) Q[9], a[3], a_prime[3], p[3] -> p_prime[3]; src/section_3_2.c */
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

/* (3.7) e[3], phi, d_P[3] -> result; src/section_3_2.c */
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

/* (3.16) e[3], phi -> result[9]; src/section_3_2_1.c */
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

/* (3.18) e[3], phi, a[3], a_prime[3] -> p_0[3]; src/section_3_2_1.c */
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

/* (3.23) p_1[3], p_2[3] -> kappa[6]; src/section_3_2_2.c */
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

/* (3.29a) kappa_A[6], a[3], b[3] -> kappa_B[6]; src/section_3_2_2.c */
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

/* text 3.2.3 h triad[9], triad_prime[9] -> Q[9]; src/section_3_2_3.c */
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

/* text 3.2.3 g triad[9], triad_prime[9] -> Q[9]; src/section_3_2_3.c */
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

/* (3.45) Omega[9] -> omega[3]; src/section_3_3.c */
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

/* (3.50) omega[3], a_dot[3], a[3], p[3] -> p_dot[3]; src/section_3_4.c */
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

/* (3.70) omega[3], a_dot[3], a[3] -> p_0_prime[3]; src/section_3_4_1.c */
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

/* (3.76b) e[3], phi -> N[12]; src/section_3_4_2.c */
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

/* (3.76c) e[3], phi -> L[12]; src/section_3_4_2.c */
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

/* (3.76d) e[3], phi -> H[12]; src/section_3_4_2.c */
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

/* text 3.4.2 f q[3], q_0 -> Q[9]; src/section_3_4_2.c */
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

/* text 3.4.2 f q[3], q_0 -> Q[9]; src/section_3_4_2.c */
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

/* text 3.4.2 g Q[9] -> q[3], q_0; src/section_3_4_2.c */
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

/* text 3.4.2 h Q[9] -> e[3], phi; src/section_3_4_2.c */
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

/* text 3.4.2 i Q[9] -> q[3], q_0; src/section_3_4_2.c */
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

/* text 3.4.2 j Q[9], a[3], a_prime[3] -> axis[6], d_0, phi; src/section_3_4_2.c */
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

/* text 3.4.1 c omega[3], a_dot[3], a[3] -> axis[6], pitch; src/section_3_4_2.c */
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

/* (3.77b) e[3], phi -> N_tilde[12]; src/section_3_4_2.c */
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

/* (3.77c) e[3], phi -> L_tilde[12]; src/section_3_4_2.c */
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

/* (3.77d) e[3], phi -> H_tilde[12]; src/section_3_4_2.c */
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

/* (3.78) e[3], phi, t[6] -> s_dot[7]; src/section_3_4_2.c */
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

/* (3.78) e[3], phi, t[6] -> s_dot[7]; src/section_3_4_2.c */
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

/* (3.78) e[3], phi, t[6] -> s_dot[7]; src/section_3_4_2.c */
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

/* (3.80a) e[3], phi, s_dot[7] -> t[6]; src/section_3_4_2.c */
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

/* (3.80a) e[3], phi, s_dot[7] -> t[6]; src/section_3_4_2.c */
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

/* (3.80a) e[3], phi, s_dot[7] -> t[6]; src/section_3_4_2.c */
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

/* (3.83a) t_A[6], a[3], p[3] -> t_P[6]; src/section_3_4_2.c */
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

/* (3.86) omega[3], omega_dot[3] -> W[9]; src/section_3_5.c */
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

/* (3.89) omega[3], omega_dot[3], a_ddot[3], a[3], p[3] -> p_ddot[3]; src/section_3_5.c */
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

/* text 3.5 f e[3], phi, omega[3] -> N_dot[12]; src/section_3_5.c */
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

/* text 3.5 f e[3], phi, omega[3] -> L_dot[12]; src/section_3_5.c */
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

/* text 3.5 f e[3], phi, omega[3] -> H_dot[12]; src/section_3_5.c */
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

/* text 3.5 g e[3], phi, omega[3] -> N_tilde_dot[12]; src/section_3_5.c */
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

/* text 3.5 g e[3], phi, omega[3] -> L_tilde_dot[12]; src/section_3_5.c */
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

/* text 3.5 g e[3], phi, omega[3] -> H_tilde_dot[12]; src/section_3_5.c */
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

/* text 3.5 h e[3], phi, t[6], t_dot[6] -> s_ddot[7]; src/section_3_5.c */
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

/* text 3.5 h e[3], phi, t[6], t_dot[6] -> s_ddot[7]; src/section_3_5.c */
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

/* text 3.5 h e[3], phi, t[6], t_dot[6] -> s_ddot[7]; src/section_3_5.c */
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

/* text 3.5 i e[3], phi, s_dot[7], s_ddot[7] -> t_dot[6]; src/section_3_5.c */
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

/* text 3.5 i e[3], phi, s_dot[7], s_ddot[7] -> t_dot[6]; src/section_3_5.c */
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

/* text 3.5 i e[3], phi, s_dot[7], s_ddot[7] -> t_dot[6]; src/section_3_5.c */
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

/* (3.103) o_dot[3], Q[9], omega[3], rho[3], rho_dot[3] -> p_dot[3]; src/section_3_6.c */
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

/* (3.105) o_ddot[3], Q[9], omega[3], omega_dot[3], rho[3], rho_dot[3], rho_ddot[3] -> p_ddot[3]; src/section_3_6.c */
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

/* text 3.7 d f[3], n_A[3], a[3] -> axis[6], pitch; src/section_3_7.c */
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

/* (3.114) t[6], w[6] -> Pi; src/section_3_7.c */
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

/* text 3.7 k s_w[6], s_t[6] -> product; src/section_3_7.c */
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

/* (3.119a) w_A[6], a[3], p[3] -> w_P[6]; src/section_3_7.c */
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

/* (3.133a) I_C[9], m, c[3], a[3] -> I_A[9]; src/section_3_8.c */
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

/* (3.133a) I_C[6], m, c[3], a[3] -> I_A[6]; src/section_3_8.c */
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

/* (3.142) I_C[9], m, t[6] -> mu[6]; src/section_3_8.c */
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

/* (3.142) I_C[6], m, t[6] -> mu[6]; src/section_3_8.c */
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

/* (3.145) I_C[9], m, t[6] -> T; src/section_3_8.c */
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

/* (3.145) I_C[6], m, t[6] -> T; src/section_3_8.c */
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

/* text 3.8 v I_C[9], m, t[6], t_dot[6] -> w[6]; src/section_3_8.c */
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

/* text 3.8 v I_C[6], m, t[6], t_dot[6] -> w[6]; src/section_3_8.c */
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

/* text 3.8 v I_C[9], m, t[6], w[6] -> t_dot[6]; src/section_3_8.c */
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

/* text 3.8 v I_C[6], m, t[6], w[6] -> t_dot[6]; src/section_3_8.c */
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

/* (3.147) I_C[9], m, c[3], a[3] -> M_A[36]; src/section_3_8.c */
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

/* (3.147) I_C[6], m, c[3], a[3] -> M_A[36]; src/section_3_8.c */
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

/* Ex 3.10 angles[3] -> Q[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W_body[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3], omega[3] -> theta_dot[3]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> Q[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W_body[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3], omega[3] -> theta_dot[3]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> Q[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W_body[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3], omega[3] -> theta_dot[3]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> Q[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W_body[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3], omega[3] -> theta_dot[3]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> Q[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W_body[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3], omega[3] -> theta_dot[3]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> Q[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W_body[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3], omega[3] -> theta_dot[3]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> Q[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W_body[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3], omega[3] -> theta_dot[3]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> Q[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W_body[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3], omega[3] -> theta_dot[3]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> Q[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W_body[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3], omega[3] -> theta_dot[3]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> Q[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W_body[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3], omega[3] -> theta_dot[3]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> Q[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W_body[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3], omega[3] -> theta_dot[3]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> Q[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3] -> W_body[9]; src/section_3_9.c */
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

/* Ex 3.10 angles[3], omega[3] -> theta_dot[3]; src/section_3_9.c */
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
