(* SPDX-License-Identifier: BSD-3-Clause *)
(* Steps of proofs. No statement mentions anything of this file, and nothing here has to be believed. *)
From Coq Require Export Lra FunctionalExtensionality.
From Chasles Require Export Hypotheses Reckon.

(* Words are opened into sums of products of entries. *)
Ltac words := lazy beta iota zeta delta
  [M row listed at_place sum matrix entry plus minus opposite scale over times transpose one zero power below beside
   number the dot vector CPM cross vect trace signed past determinant det cofactor integrated unit_vector
   perpendicular symmetric fst snd Nat.eqb Nat.ltb Nat.leb Nat.add Nat.sub Nat.even INR Nat.pred].
Ltac words_in H := cbv beta iota zeta delta
  [M row listed at_place sum matrix entry plus minus opposite scale over times transpose one zero power below beside
   number the dot vector CPM cross vect trace signed past determinant det cofactor integrated unit_vector
   perpendicular symmetric fst snd Nat.eqb Nat.ltb Nat.leb Nat.add Nat.sub Nat.even INR Nat.pred] in H.
Lemma same_pair {S T} (a c : S) (b d : T) : a = c -> b = d -> (a, b) = (c, d).
Proof. congruence. Qed.
Ltac entries := repeat match goal with |- (_, _) = (_, _) => apply same_pair | |- tt = tt => reflexivity end.

(* Entries of what is made from entries; matrices with the same entries are the same. *)
Lemma at_place_listed {T} (x : T) n f i : at_place x i (listed n f) = if Nat.ltb i n then f i else x.
Proof.
  revert f i. induction n as [|n IH]; intros f i; [reflexivity|]. destruct i as [|i]; [reflexivity|].
  change (at_place x i (listed n (fun k => f (S k))) = if Nat.ltb i n then f (S i) else x).
  apply (IH (fun k => f (S k))).
Qed.
Lemma entry_matrix m n f i j : entry (matrix m n f) i j = if Nat.ltb i m then if Nat.ltb j n then f i j else 0 else 0.
Proof.
  unfold entry, matrix. rewrite at_place_listed. destruct (Nat.ltb i m); rewrite at_place_listed; [reflexivity|].
  destruct (Nat.ltb j n); reflexivity.
Qed.
Lemma same_rows {T} (x : T) n (u v : row T n) : (forall i, at_place x i u = at_place x i v) -> u = v.
Proof.
  revert u v. induction n as [|n IH]; intros u v H; destruct u as [], v as []; [reflexivity|]. f_equal.
  - exact (H O).
  - apply IH. intro i. exact (H (S i)).
Qed.
Lemma same_entries {m n} (A B : M m n) : (forall i j, entry A i j = entry B i j) -> A = B.
Proof.
  intro H. apply (same_rows (listed n (fun _ => 0))). intro i. apply (same_rows 0). intro j. exact (H i j).
Qed.
Lemma entry_inside {m n} (A : M m n) i j :
  entry A i j = if Nat.ltb i m then if Nat.ltb j n then entry A i j else 0 else 0.
Proof.
  assert (L : forall (T : Type) (x : T) n (r : row T n) i, at_place x i r = if Nat.ltb i n then at_place x i r else x).
  { clear. intros T x n. induction n as [|n IH]; intros r i; [reflexivity|]. destruct i as [|i]; [reflexivity|].
    apply (IH (snd r) i). }
  unfold entry. rewrite (L _ _ _ A i) at 1. destruct (Nat.ltb i m); [apply L|]. rewrite at_place_listed.
  destruct (Nat.ltb j n); reflexivity.
Qed.
(* Entries are compared one at a time: so no more than one has to be written out. *)
Fixpoint all (n : nat) (P : nat -> Prop) : Prop :=
  match n with O => True | S O => P O | S k => P O /\ all k (fun i => P (S i)) end.
Lemma all_below n P i : all n P -> Nat.ltb i n = true -> P i.
Proof.
  revert P i. induction n as [|n IH]; intros P i H L; [discriminate|].
  destruct n as [|n]; [destruct i as [|[|i]]; [exact H | discriminate | discriminate]|].
  destruct i as [|i]; [apply H|]. apply (IH (fun i => P (S i)) i (proj2 H) L).
Qed.
Lemma by_entries {m n} (A B : M m n) : all m (fun i => all n (fun j => entry A i j = entry B i j)) -> A = B.
Proof.
  intro H. apply same_entries. intros i j. rewrite (entry_inside A), (entry_inside B).
  destruct (Nat.ltb i m) eqn:I; [destruct (Nat.ltb j n) eqn:J|]; try reflexivity.
  exact (all_below n _ j (all_below m _ i H I) J).
Qed.
Ltac each_entry := apply by_entries; cbv beta iota delta [all]; repeat apply conj.

(* What follows from polynomials that vanish: the difference, times what is not zero, is a combination of them. *)
Lemma by_parts (a b x : R) : x = 0 -> a - b = x -> a = b.
Proof. intros; lra. Qed.
Lemma by_multiple (d a b x : R) : d <> 0 -> x = 0 -> d * (a - b) = x -> a = b.
Proof. intros Hd Hx H. rewrite Hx in H. destruct (Rmult_integral _ _ H); [contradiction | lra]. Qed.
Lemma zero_product q g : g = 0 -> q * g = 0.
Proof. intros ->; ring. Qed.
Lemma zero_sum a b : a = 0 -> b = 0 -> a + b = 0.
Proof. intros -> ->; ring. Qed.
Ltac vanish := repeat apply zero_sum; try (apply zero_product; assumption); try reflexivity.
Lemma equal_entries {m n} (d : R) (A B : M m n) i j (g : R) : A = B -> g = d * (entry A i j - entry B i j) -> g = 0.
Proof. intros -> ->; ring. Qed.
Lemma equal_numbers (d a b g : R) : a = b -> g = d * (a - b) -> g = 0.
Proof. intros -> ->; ring. Qed.

(* What is not zero. *)
Lemma not_zero_as (a b : R) : a <> 0 -> b = a -> b <> 0.
Proof. intros H ->; exact H. Qed.
Lemma not_zero_product (a b : R) : a <> 0 -> b <> 0 -> a * b <> 0.
Proof. intros. apply Rmult_integral_contrapositive_currified; assumption. Qed.
Lemma not_zero_factor (a b k : R) : a <> 0 -> a = k * b -> b <> 0.
Proof. intros H E Z. apply H. rewrite E, Z. ring. Qed.
Lemma one_and_squares (a b c : R) : 1 + (a ^ 2 + b ^ 2 + c ^ 2) <> 0.
Proof. generalize (pow2_ge_0 a), (pow2_ge_0 b), (pow2_ge_0 c). lra. Qed.
Ltac not_zero_alone := first
  [ assumption | lra | apply one_and_squares
  | apply pow_nonzero; not_zero_alone
  | apply not_zero_product; not_zero_alone
  | match goal with K : ?a <> 0 |- ?b <> 0 => first
      [ apply (not_zero_factor a b 1 K); ring | apply (not_zero_factor a b (-1) K); ring
      | apply (not_zero_factor a b 2 K); ring | apply (not_zero_factor a b (-2) K); ring
      | apply (not_zero_factor a b (1/2) K); field | apply (not_zero_factor a b (-1/2) K); field
      | apply (not_zero_factor a b 4 K); ring ] end ].
Ltac not_zero := repeat split; not_zero_alone.

(* Angles and lengths. *)
Lemma circle x : cos x ^ 2 + sin x ^ 2 - 1 = 0.
Proof. generalize (sin2_cos2 x). unfold Rsqr. intro H. rewrite <- H. ring. Qed.
Lemma cos_half x : cos x = cos (x / 2) * cos (x / 2) - sin (x / 2) * sin (x / 2).
Proof. replace x with (x / 2 + x / 2) at 1 by field. apply cos_plus. Qed.
Lemma sin_half x : sin x = 2 * (sin (x / 2) * cos (x / 2)).
Proof. replace x with (x / 2 + x / 2) at 1 by field. rewrite sin_plus. ring. Qed.
Ltac turned := first
  [ reckon
  | match goal with |- cos ?x = _ => rewrite (cos_half x); ring | |- sin ?x = _ => rewrite (sin_half x); reckon end
  | repeat first
      [ rewrite cos_plus | rewrite sin_plus | rewrite cos_minus | rewrite sin_minus | rewrite cos_neg | rewrite sin_neg
      | rewrite cos_PI2 | rewrite sin_PI2 | rewrite cos_PI | rewrite sin_PI | rewrite cos_2a | rewrite sin_2a ]; reckon ].
Ltac turned_by total := lazymatch goal with
  | |- cos _ = _ => transitivity (cos total); [f_equal; lra | turned]
  | |- sin _ = _ => transitivity (sin total); [f_equal; lra | turned]
  end.
Lemma sum_not_negative n f : (forall i, 0 <= f i) -> 0 <= sum n f.
Proof.
  revert f. induction n as [|n IH]; intros f F; [apply Rle_refl|]. destruct n as [|n]; [apply F|].
  change (0 <= f O + sum (S n) (fun i => f (S i))).
  apply Rplus_le_le_0_compat; [apply F | apply IH; intro; apply F].
Qed.
Lemma dot_not_negative {m} (v : M m 1) : 0 <= dot v v.
Proof. apply sum_not_negative. intro i. apply Rle_0_sqr. Qed.
Lemma norm_squared {m} (v : M m 1) : norm v ^ 2 - dot v v = 0.
Proof. unfold norm. rewrite pow2_sqrt; [ring | apply dot_not_negative]. Qed.
Lemma norm_not_negative {m} (v : M m 1) : 0 <= norm v.
Proof. apply sqrt_pos. Qed.

(* A rotation equals its cofactor matrix, and its transpose is its inverse on both sides. *)
Ltac in_entries A := destruct A as [[? [? [? []]]] [[? [? [? []]]] [[? [? [? []]]] []]]].
Lemma times_times (A B C : M 3 3) : (A * (B * C) = A * B * C)%M.
Proof. in_entries A. in_entries B. in_entries C. words. entries; ring. Qed.
Lemma one_times (A : M 3 3) : (one 3 * A)%M = A.
Proof. in_entries A. words. entries; ring. Qed.
Lemma times_one (A : M 3 3) : (A * one 3)%M = A.
Proof. in_entries A. words. entries; ring. Qed.
Lemma cofactor_times_transpose (A : M 3 3) : (cofactor A * A^T)%M = (det A *: one 3)%M.
Proof. in_entries A. words. entries; ring. Qed.
Lemma one_fold (A : M 3 3) : (1 *: A)%M = A.
Proof. in_entries A. words. entries; ring. Qed.
Lemma rotation_is_its_cofactor Q : rotation Q -> Q = cofactor Q.
Proof.
  intros [E D]. rewrite <- (times_one (cofactor Q)), <- E, times_times, cofactor_times_transpose, D, one_fold.
  symmetry. apply one_times.
Qed.
Lemma rotation_times_transpose Q : rotation Q -> (Q * Q^T)%M = one 3.
Proof.
  intro H. rewrite (rotation_is_its_cofactor Q H) at 1. rewrite cofactor_times_transpose. destruct H as [_ ->].
  apply one_fold.
Qed.
Lemma rotation_quadrics Q : rotation Q -> (Q^T * Q)%M = one 3 /\ (Q * Q^T)%M = one 3 /\ Q = cofactor Q.
Proof.
  intro H. split; [apply H|]. split; [apply rotation_times_transpose | apply rotation_is_its_cofactor]; exact H.
Qed.

(* A positive-definite matrix has a determinant that is not zero. *)
Lemma not_zero_vector (x y z : R) : z <> 0 \/ y <> 0 \/ x <> 0 -> vector x y z <> zero 3 1.
Proof. intros H Z. words_in Z. injection Z as -> -> ->. destruct H as [H|[H|H]]; exact (H eq_refl). Qed.
Lemma positive_factor (x y : R) : 0 < x -> 0 < x * y -> 0 < y.
Proof. intros; nra. Qed.
Lemma definite_determinant (A : M 3 3) : definite A -> 0 < det A.
Proof.
  destruct A as [[a [b [c []]]] [[b' [d [e []]]] [[c' [e' [f []]]] []]]].
  intros [S P]. words_in S. injection S as S1 S2 S3 S4 S5 S6.
  replace b' with b in * by congruence. replace c' with c in * by congruence. replace e' with e in * by congruence.
  pose proof (fun H => P (vector 1 0 0) (not_zero_vector _ _ _ H)) as P1.
  pose proof (fun H => P (vector (- b) a 0) (not_zero_vector _ _ _ H)) as P2.
  pose proof (fun H => P (vector (b * e - c * d) (c * b - a * e) (a * d - b * b)) (not_zero_vector _ _ _ H)) as P3.
  clear P. words_in P1. words_in P2. words_in P3. words.
  assert (A0 : 0 < a) by (eapply Rlt_le_trans; [apply P1; lra | apply Req_le; ring]).
  assert (D0 : 0 < a * d - b * b).
  { apply (positive_factor a); [exact A0|]. eapply Rlt_le_trans; [apply P2; lra | apply Req_le; ring]. }
  apply (positive_factor (a * d - b * b)); [exact D0|].
  eapply Rlt_le_trans; [apply P3; lra | apply Req_le; ring].
Qed.

(* Lengths. *)
Lemma norm_square {m} (v : M m 1) : norm v ^ 2 = dot v v.
Proof. apply Rminus_diag_uniq, norm_squared. Qed.
Lemma norm_fourth {m} (v : M m 1) : norm v ^ 4 = dot v v ^ 2.
Proof. rewrite <- norm_square. ring. Qed.
Lemma same_root (a b p q : R) : 0 <= a -> 0 <= b -> a ^ 2 - p = 0 -> b ^ 2 - q = 0 -> p = q -> a = b.
Proof. intros Ha Hb Ea Eb E. apply Rsqr_inj; [exact Ha | exact Hb | unfold Rsqr; lra]. Qed.
