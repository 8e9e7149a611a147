(* SPDX-License-Identifier: BSD-3-Clause *)
(* Steps of proofs of identities between expressions. Nothing here has to be believed. *)
From Chasles Require Export Forms.

Lemma named (x : R) : exists v, v = x.
Proof. exists x. reflexivity. Qed.
Lemma root_of v s : v = sqrt s -> 0 <= s -> v ^ 2 - s = 0.
Proof. intros -> P. rewrite pow2_sqrt; [ring | exact P]. Qed.
Lemma size_of v x : v = Rabs x -> v ^ 2 - x ^ 2 = 0.
Proof. intros ->. rewrite pow2_abs. ring. Qed.
Lemma root_positive v s : v = sqrt s -> 0 <= v.
Proof. intros ->. apply sqrt_pos. Qed.
Lemma size_positive v x : v = Rabs x -> 0 <= v.
Proof. intros ->. apply Rabs_pos. Qed.
Lemma root_value v s a : v = sqrt s -> 0 <= a -> s = a ^ 2 -> v = a.
Proof. intros -> P ->. apply sqrt_pow2, P. Qed.
Lemma size_value v x a : v = Rabs x -> 0 <= a -> x ^ 2 = a ^ 2 -> v = a.
Proof. intros -> P E. apply (same_root _ _ (x ^ 2) (a ^ 2)); [apply Rabs_pos | exact P | apply (size_of _ x eq_refl) | ring | exact E]. Qed.
Lemma not_zero_square v s : v ^ 2 - s = 0 -> s <> 0 -> v <> 0.
Proof. intros H N ->. apply N. lra. Qed.
Lemma root_above v s : v = sqrt s -> 0 < s -> 0 < v.
Proof. intros -> P. apply sqrt_lt_R0, P. Qed.
Lemma size_above v x : v = Rabs x -> x <> 0 -> 0 < v.
Proof. intros -> N. apply Rabs_pos_lt, N. Qed.
Lemma log_over x y : 0 < x -> 0 < y -> ln (x / y) = ln x - ln y.
Proof. intros X Y. unfold Rdiv. rewrite ln_mult, ln_Rinv; [ring | exact Y | exact X | apply Rinv_0_lt_compat, Y]. Qed.
(* Of an angle a by its sine, cosine or tangent x, that is u, with the third side r. *)
Lemma third_side r s : 0 <= r -> r ^ 2 = s -> r = sqrt s.
Proof. intros P <-. symmetry. apply sqrt_pow2, P. Qed.
Lemma of_asin a u r x : a = asin u -> u = x -> 0 <= r -> r ^ 2 = 1 - x ^ 2 -> cos a = r /\ sin a = x.
Proof.
  intros -> -> P E. assert (B : -1 <= x <= 1) by nra. split; [|apply sin_asin, B].
  rewrite (cos_asin _ B), (third_side _ _ P E). f_equal. unfold Rsqr. ring.
Qed.
Lemma of_acos a u r x : a = acos u -> u = x -> 0 <= r -> r ^ 2 = 1 - x ^ 2 -> cos a = x /\ sin a = r.
Proof.
  intros -> -> P E. assert (B : -1 <= x <= 1) by nra. split; [apply cos_acos, B|].
  rewrite (sin_acos _ B), (third_side _ _ P E). f_equal. unfold Rsqr. ring.
Qed.
Lemma of_atan a u r x : a = atan u -> u = x -> 0 <= r -> r ^ 2 = x ^ 2 + 1 -> cos a = 1 / r /\ sin a = x / r.
Proof.
  intros -> -> P E. rewrite cos_atan, sin_atan, (third_side _ _ P E).
  replace (1 + x²) with (x ^ 2 + 1) by (unfold Rsqr; ring). split; reflexivity.
Qed.
Lemma of_atan2 a v u r y x :
  a = atan2 v u -> v = y -> u = x -> 0 <= r -> r ^ 2 = y ^ 2 + x ^ 2 -> r <> 0 -> cos a = x / r /\ sin a = y / r.
Proof.
  intros -> -> -> P E N. assert (0 < r) by lra. clear P N.
  assert (Q : x <> 0 -> exists q, 0 < q /\ q ^ 2 = (y / x) ^ 2 + 1 /\ (r = x * q \/ r = - (x * q))).
  { intro N. exists (r / Rabs x). assert (0 < Rabs x) by (apply Rabs_pos_lt, N). split; [apply Rdiv_lt_0_compat; lra|]. split.
    - unfold Rdiv. rewrite Rpow_mult_distr, E, pow_inv, pow2_abs. field. exact N.
    - unfold Rabs in *. destruct (Rcase_abs x); [right | left]; field; exact N. }
  unfold atan2. destruct (Rlt_dec 0 x); [|destruct (Rlt_dec x 0)].
  - destruct Q as (q & q_above & q_is & [r_is | r_is]); [lra | | nra].
    destruct (of_atan _ _ q (y / x) eq_refl eq_refl) as [-> ->]; [lra | exact q_is |]. rewrite r_is. split; field; lra.
  - destruct Q as (q & q_above & q_is & [r_is | r_is]); [lra | nra |].
    destruct (of_atan _ _ q (y / x) eq_refl eq_refl) as [c s]; [lra | exact q_is |].
    destruct (Rlt_dec y 0); [rewrite cos_minus, sin_minus | rewrite neg_cos, neg_sin];
      rewrite ?cos_PI, ?sin_PI, c, s, r_is; split; field; lra.
  - assert (x = 0) by lra. subst x. destruct (Rlt_dec 0 y); [|destruct (Rlt_dec y 0)].
    + rewrite cos_PI2, sin_PI2. assert (r = y) by nra. subst r. split; field; lra.
    + rewrite cos_neg, sin_neg, cos_PI2, sin_PI2. assert (r = - y) by nra. subst r. split; field; lra.
    + exfalso. nra.
Qed.
Lemma by_square a b : (a - b) ^ 2 = 0 -> a = b.
Proof. intro E. apply Rminus_diag_uniq, Rsqr_0_uniq. unfold Rsqr. rewrite <- E. ring. Qed.
Lemma by_squares a b : 0 <= a -> 0 <= b -> a ^ 2 = b ^ 2 -> a = b.
Proof. intros P Q E. apply Rsqr_inj; [exact P | exact Q | unfold Rsqr; lra]. Qed.
Lemma of_square w a : 0 < w -> w * a ^ 2 = 0 -> a = 0.
Proof. intros P E. apply Rsqr_0_uniq. unfold Rsqr. nra. Qed.
Ltac nonnegative := first
  [ assumption | lra | apply Rlt_le; assumption | apply Rlt_le, exp_pos | apply Rmult_le_pos; nonnegative | apply Rplus_le_le_0_compat; nonnegative
  | apply Rle_mult_inv_pos; [nonnegative | above] | apply pow_le; nonnegative | apply pow2_ge_0 | nra
  | match goal with |- 0 <= ?a => match goal with H : 0 <= ?b |- _ => replace a with b by reckon; exact H end end
  | apply Rlt_le; above ]
with above := first
  [ assumption | lra | apply exp_pos | apply Rmult_lt_0_compat; above | apply Rinv_0_lt_compat; above
  | apply Rdiv_lt_0_compat; above | apply Rplus_lt_le_0_compat; [above | nonnegative]
  | apply Rplus_le_lt_0_compat; [nonnegative | above] | apply pow_lt; above
  | match goal with K : ?v = sqrt _ |- 0 < ?v => apply (root_above _ _ K); above end
  | match goal with K : ?v = Rabs _ |- 0 < ?v => apply (size_above _ _ K); assumption end
  | match goal with |- 0 < ?a => match goal with H : 0 < ?b |- _ => replace a with b by reckon; exact H end end
  | rewrite <- ln_1; apply ln_increasing; lra | apply Rlt_Rminus; rewrite <- exp_0; apply exp_increasing; lra ].
Ltac not_zero_known := first
  [ assumption | apply Rgt_not_eq; above | intro; lra | apply pow_nonzero; not_zero_known
  | apply not_zero_product; not_zero_known
  | match goal with K : ?a <> 0 |- ?b <> 0 => apply (not_zero_as _ _ K); reckon end ].
Lemma cos_quarter : cos (PI / 4) = sqrt 2 / 2.
Proof.
  rewrite cos_PI4. apply (Rmult_eq_reg_l (sqrt 2)); [|apply sqrt2_neq_0]. generalize sqrt2_neq_0. intro N.
  field_simplify; [|exact N]. rewrite pow2_sqrt; lra.
Qed.
Lemma sin_quarter : sin (PI / 4) = sqrt 2 / 2.
Proof. rewrite sin_cos_PI4. apply cos_quarter. Qed.
Ltac at_parts_of_pi := first
  [ rewrite cos_PI2 | rewrite sin_PI2 | rewrite cos_quarter | rewrite sin_quarter | rewrite cos_PI3 | rewrite sin_PI3
  | rewrite cos_PI6 | rewrite sin_PI6 ].
Ltac apart := repeat match goal with H : ?a <> ?b |- _ => destruct (Rdichotomy _ _ H); clear H end.
Ltac by_cases := unfold sign, Rabs, Rmax, Rmin in *;
  repeat match goal with |- context [if ?c then _ else _] => destruct c end;
  repeat match goal with H : context [if ?c then _ else _] |- _ => destruct c end;
  repeat match goal with H : ~ 0 < ?x, K : ~ ?x < 0 |- _ => assert (x = 0) by lra; replace x with 0 by lra; clear H K end;
  first [ lra | reckon | exfalso; lra | contradiction | apart; lra | nra | field; nra ].
(* What is claimed of two numbers or more, by an equation that says the same. *)
Lemma at_most_by l r a b : l = r -> 0 <= l -> b - a = r -> a <= b.
Proof. intros E P D. lra. Qed.
Ltac as_claimed H := unfold sign in H;
  repeat match type of H with context [if ?c then _ else _] => destruct c end;
  first
  [ exfalso; lra | refine (at_most_by _ _ _ _ H _ _); [first [apply Rabs_pos | nonnegative] | first [ring | reckon]]
  | lra | above | nonnegative | nra | intuition lra ].
