(* SPDX-License-Identifier: BSD-3-Clause *)
(* Steps of proofs about points: what satisfies all that a statement assumes, and refutes it or shows that it speaks of
   something. Nothing here has to be believed. *)
From Chasles Require Export Bodies.

Lemma differ (a b x y : R) : a = b -> a = x -> b = y -> x <> y -> False.
Proof. intros E <- <- N. exact (N E). Qed.
Lemma positive_as (x a : R) : 0 < x -> a = x -> 0 < a.
Proof. intros H ->; exact H. Qed.

(* Numbers are compared; pi is known to lie between 0 and 4. *)
Lemma PI_bounds : 0 < PI <= 4.
Proof. split; [exact PI_RGT_0 | exact PI_4]. Qed.
Ltac compared := pose proof PI_bounds; solve [lra | intro; lra | rewrite ?pow_1; lra | rewrite ?pow_1; intro; lra | nra | intro; nra].
Ltac computed := words; entries; first [reflexivity | reckon | lra | field; repeat split; first [not_zero_alone | compared]].

(* Angles with a given cosine and sine, as large as one likes; quarter turns. *)
Lemma later (n : nat) x : cos (x + 2 * INR n * PI) = cos x /\ sin (x + 2 * INR n * PI) = sin x.
Proof. split; [apply cos_period | apply sin_period]. Qed.
Lemma beyond y : exists n : nat, y < INR n.
Proof.
  exists (Z.to_nat (Z.max 0 (up y))). rewrite INR_IZR_INZ, Z2Nat.id by apply Z.le_max_l.
  apply Rlt_le_trans with (1 := proj1 (archimed y)). apply IZR_le, Z.le_max_r.
Qed.
Lemma angle_of c s : c * c + s * s = 1 -> exists x, cos x = c /\ sin x = s.
Proof.
  intro H. destruct (IVT_cor (fun x => cos x - c) 0 PI) as (x & B & Z).
  - apply continuity_minus; [exact continuity_cos | apply continuity_const; intros ? ?; reflexivity].
  - generalize PI_RGT_0. lra.
  - rewrite cos_0, cos_PI. nra.
  - assert (C : cos x = c) by lra. assert (S : sin x ^ 2 = s ^ 2) by (generalize (sin2_cos2 x); rewrite C; unfold Rsqr; nra).
    assert (P : 0 <= sin x) by (apply sin_ge_0; lra). destruct (Rle_dec 0 s) as [Q|Q].
    + exists x. split; [exact C|]. apply Rsqr_inj; [exact P | exact Q | unfold Rsqr; nra].
    + exists (- x). rewrite cos_neg, sin_neg. split; [exact C|]. cut (sin x = - s); [intros ->; ring|].
      apply Rsqr_inj; [exact P | lra | unfold Rsqr; nra].
Qed.
Lemma angle_with k c s low : 0 < k -> c * c + s * s = 1 -> exists x, cos (k * x) = c /\ sin (k * x) = s /\ low < x.
Proof.
  intros K H. destruct (angle_of c s H) as (x & C & S). destruct (beyond ((k * low - x) / (2 * PI))) as [n L].
  exists ((x + 2 * INR n * PI) / k). replace (k * ((x + 2 * INR n * PI) / k)) with (x + 2 * INR n * PI) by (field; lra).
  destruct (later n x) as [-> ->]. split; [exact C|]. split; [exact S|].
  apply (Rmult_lt_reg_l k); [exact K|]. replace (k * ((x + 2 * INR n * PI) / k)) with (x + 2 * INR n * PI) by (field; lra).
  apply (Rmult_lt_compat_r (2 * PI)) in L; [|generalize PI_RGT_0; lra].
  replace ((k * low - x) / (2 * PI) * (2 * PI)) with (k * low - x) in L by (field; apply PI_neq0). lra.
Qed.
Lemma norm_is {m} (v : M m 1) r : 0 <= r -> dot v v = r * r -> norm v = r.
Proof. intros P E. unfold norm. rewrite E. apply sqrt_square, P. Qed.

(* Positive-definite matrices, by their leading minors. *)
Lemma definite_by_minors (A : M 3 3) : A = transpose A ->
  0 < entry A 0 0 -> 0 < entry A 0 0 * entry A 1 1 - entry A 0 1 * entry A 0 1 -> 0 < det A -> definite A.
Proof.
  destruct A as [[a [b [c []]]] [[b' [d [e []]]] [[c' [e' [f []]]] []]]]. intro S. pose proof S as S'. words_in S'.
  injection S' as S1 S2 S3 S4 S5 S6. replace b' with b in * by congruence. replace c' with c in * by congruence.
  replace e' with e in * by congruence. clear S1 S2 S3 S4 S5 S6. words. intros P1 P2 P3. split; [exact S|].
  intros [[x []] [[y []] [[z []] []]]] N. words.
  set (D := a * d - b * b) in *. set (E := a * e - b * c). set (X := a * x + b * y + c * z). set (Y := D * y + E * z).
  assert (Z : a * D * (x * (a * x + (b * y + c * z)) + (y * (b * x + (d * y + e * z)) + z * (c * x + (e * y + f * z))))
    = D * X * X + Y * Y + a * (a * (d * f - e * e) + (- (b * (b * f - e * c)) + c * (b * e - d * c))) * z * z)
    by (unfold X, Y, E, D; ring).
  assert (Q : 0 < D * X * X + Y * Y + a * (a * (d * f - e * e) + (- (b * (b * f - e * c)) + c * (b * e - d * c))) * z * z).
  { set (K := a * (d * f - e * e) + (- (b * (b * f - e * c)) + c * (b * e - d * c))).
    assert (P4 : 0 < a * K) by (apply Rmult_lt_0_compat; [exact P1 | unfold K; lra]). clearbody K.
    pose proof (Rle_0_sqr X) as X0. pose proof (Rle_0_sqr Y) as Y0. pose proof (Rle_0_sqr z) as Z0. unfold Rsqr in X0, Y0, Z0.
    pose proof (Rmult_le_pos _ _ (Rlt_le _ _ P2) X0).
    destruct (Req_dec z 0) as [->|Nz]; [destruct (Req_dec y 0) as [->|Ny]|].
    - assert (Nx : x <> 0) by (intro; subst; apply N; reflexivity).
      pose proof (Rlt_0_sqr _ (Rmult_integral_contrapositive_currified _ _ (Rgt_not_eq _ _ P1) Nx)) as X1.
      replace (Rsqr (a * x)) with (X * X) in X1 by (unfold X, Rsqr; ring). nra.
    - pose proof (Rlt_0_sqr _ (Rmult_integral_contrapositive_currified _ _ (Rgt_not_eq _ _ P2) Ny)) as Y1.
      replace (Rsqr (D * y)) with (Y * Y) in Y1 by (unfold Y, Rsqr; ring). lra.
    - pose proof (Rmult_lt_0_compat _ _ P4 (Rlt_0_sqr _ Nz)) as Z1. unfold Rsqr in Z1. lra. }
  apply (Rmult_lt_reg_l (a * D)); [nra|]. rewrite Rmult_0_r, Z. exact Q.
Qed.

(* What is at rest. *)
Lemma open_all : open_set (fun _ : R => True).
Proof. intros t _. exists (mkposreal 1 Rlt_0_1). intros x _. exact I. Qed.
Lemma rest {m n} T (A : M m n) : rate T (fun _ => A) (fun _ => zero m n).
Proof. intros t _. apply rate_constant. Qed.
Lemma scalar_rest T k : scalar_rate T (fun _ => k) (fun _ => 0).
Proof. intros t _. apply D_constant. Qed.

(* What moves by polynomials in time, while all that is not zero, or positive, is so. *)
Lemma near_value (f : R -> R) t : (exists d, derivable_pt_lim f t d) -> forall e, 0 < e ->
  exists d : posreal, forall x, Rabs (x - t) < d -> Rabs (f x - f t) < e.
Proof.
  intros [d D] e P. assert (C : continuity_pt f t) by (apply derivable_continuous_pt; exists d; exact D).
  destruct (C e P) as (a & A & K). exists (mkposreal a A). intros x X. destruct (Req_dec x t) as [->|N].
  - replace (f t - f t) with 0 by ring. rewrite Rabs_R0. exact P.
  - apply K. split; [split; [exact Logic.I | intro; apply N; congruence] | exact X].
Qed.
Lemma open_both (P Q : R -> Prop) : open_set P -> open_set Q -> open_set (fun t => P t /\ Q t).
Proof.
  intros OP OQ t [p q]. destruct (OP t p) as [a A], (OQ t q) as [b B].
  exists (mkposreal _ (Rmin_pos _ _ (cond_pos a) (cond_pos b))). intros x X. unfold disc in X. simpl in X. split.
  - apply A, (Rlt_le_trans _ _ _ X), Rmin_l.
  - apply B, (Rlt_le_trans _ _ _ X), Rmin_r.
Qed.
Lemma open_positive (f : R -> R) : (forall t, exists d, derivable_pt_lim f t d) -> open_set (fun t => f t > 0).
Proof.
  intros D t P. destruct (near_value f t (D t) (f t) P) as [d K]. exists d. intros x X.
  destruct (Rabs_def2 _ _ (K x X)). lra.
Qed.
Lemma open_nonzero (f : R -> R) : (forall t, exists d, derivable_pt_lim f t d) -> open_set (fun t => f t <> 0).
Proof.
  intros D t P. destruct (near_value f t (D t) (Rabs (f t)) (Rabs_pos_lt _ P)) as [d K]. exists d. intros x X Z.
  specialize (K x X). rewrite Z in K. replace (0 - f t) with (- f t) in K by ring. rewrite Rabs_Ropp in K. lra.
Qed.
