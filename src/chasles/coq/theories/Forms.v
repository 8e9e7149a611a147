(* SPDX-License-Identifier: BSD-3-Clause *)
(* Steps from the equations of a theorem to what it says. Nothing here has to be believed. *)
From Chasles Require Export Points.

Lemma sum_of_zeros n f : (forall i, f i = 0) -> sum n f = 0.
Proof.
  revert f. induction n as [|n IH]; intros f Z; [reflexivity|]. destruct n as [|n]; [apply Z|].
  change (f O + sum (S n) (fun i => f (S i)) = 0). rewrite Z, (IH (fun i => f (S i)) (fun i => Z (S i))). ring.
Qed.
Lemma entry_zero m n i j : entry (zero m n) i j = 0.
Proof. unfold zero. rewrite entry_matrix. destruct (Nat.ltb i m), (Nat.ltb j n); reflexivity. Qed.
Lemma times_zero {m n p} (A : M m n) : (A * zero n p)%M = zero m p.
Proof.
  apply same_entries. intros i j. rewrite entry_zero. unfold times. rewrite entry_matrix.
  destruct (Nat.ltb i m), (Nat.ltb j p); try reflexivity. apply sum_of_zeros. intro k. rewrite entry_zero. ring.
Qed.
Lemma scale_zero {m n} k : (k *: zero m n)%M = zero m n.
Proof.
  apply same_entries. intros i j. rewrite entry_zero. unfold scale. rewrite entry_matrix, entry_zero.
  destruct (Nat.ltb i m), (Nat.ltb j n); ring.
Qed.
Lemma dot_zero m : dot (zero m 1) (zero m 1) = 0.
Proof. unfold dot. apply sum_of_zeros. intro i. rewrite entry_zero. ring. Qed.
Ltac multiple_of_zero := rewrite ?times_zero, ?scale_zero, ?Rmult_0_r; reflexivity.

(* What is never negative by its spelling, and what vanishes with it. *)
Lemma sum_below n f g : (forall i, Nat.ltb i n = true -> f i = g i) -> sum n f = sum n g.
Proof.
  revert f g. induction n as [|n IH]; intros f g E; [reflexivity|]. destruct n as [|n]; [apply E; reflexivity|].
  change (f O + sum (S n) (fun i => f (S i)) = g O + sum (S n) (fun i => g (S i))).
  rewrite (E O eq_refl), (IH _ (fun i => g (S i)) (fun i I => E (S i) I)). reflexivity.
Qed.
Lemma sum_of_squares_vanishing n f : sum n (fun i => f i * f i) = 0 -> forall i, Nat.ltb i n = true -> f i = 0.
Proof.
  revert f. induction n as [|n IH]; intros f Z i I; [discriminate|].
  destruct n as [|n].
  - destruct i as [|i]; [|destruct i; discriminate]. destruct (Rmult_integral _ _ Z); assumption.
  - change (f O * f O + sum (S n) (fun k => f (S k) * f (S k)) = 0) in Z.
    assert (0 <= sum (S n) (fun k => f (S k) * f (S k))).
    { apply sum_not_negative. intro. apply Rle_0_sqr. }
    pose proof (Rle_0_sqr (f O)) as F. unfold Rsqr in F.
    destruct i as [|i]; [|apply (IH (fun k => f (S k)) ltac:(lra) i I)].
    destruct (Rmult_integral (f O) (f O) ltac:(lra)); assumption.
Qed.
Lemma dot_vanishing {m} (v : M m 1) : dot v v = 0 -> v = zero m 1.
Proof.
  intro Z. apply same_entries. intros i j. rewrite entry_zero, entry_inside.
  destruct (Nat.ltb i m) eqn:I; [|reflexivity]. destruct j as [|j]; [|reflexivity].
  exact (sum_of_squares_vanishing m (fun i => entry v i 0) Z i I).
Qed.
Lemma norm_vanishing {m} (v : M m 1) : norm v = 0 -> v = zero m 1.
Proof. intro Z. apply dot_vanishing, sqrt_eq_0; [apply dot_not_negative | exact Z]. Qed.
Lemma definite_form {n} (A : M n n) x : definite A -> the (x^T * A * x)%M = dot x (A * x).
Proof.
  intros [S _]. unfold the, dot, times. rewrite entry_matrix. cbn [Nat.ltb Nat.leb].
  apply sum_below. intros i I. rewrite !entry_matrix, I. cbn [Nat.ltb Nat.leb]. rewrite Rmult_comm. f_equal.
  apply sum_below. intros j J. unfold transpose. rewrite entry_matrix, J. cbn [Nat.ltb Nat.leb]. rewrite S at 1.
  unfold transpose. rewrite entry_matrix, J, I. ring.
Qed.
Lemma definite_not_negative {n} (A : M n n) x : definite A -> 0 <= the (x^T * A * x)%M.
Proof.
  intro D. rewrite (definite_form A x D). destruct (Req_dec (dot x x) 0) as [Z|N].
  - rewrite (dot_vanishing x Z), times_zero, dot_zero. apply Rle_refl.
  - apply Rlt_le, D. intros ->. apply N, dot_zero.
Qed.
Lemma definite_vanishing {n} (A : M n n) x : definite A -> the (x^T * A * x)%M = 0 -> x = zero n 1.
Proof.
  intros D Z. apply dot_vanishing. destruct (Req_dec (dot x x) 0) as [E|N]; [exact E|].
  rewrite (definite_form A x D) in Z. destruct D as [_ P].
  assert (K : x <> zero n 1) by (intros ->; apply N, dot_zero). apply P in K. rewrite Z in K. elim (Rlt_irrefl 0 K).
Qed.
Lemma zero_times {m n p} (A : M n p) : (zero m n * A)%M = zero m p.
Proof.
  apply same_entries. intros i j. rewrite entry_zero. unfold times. rewrite entry_matrix.
  destruct (Nat.ltb i m), (Nat.ltb j p); try reflexivity. apply sum_of_zeros. intro k. rewrite entry_zero. ring.
Qed.
Lemma below_zero m n p : below (zero m p) (zero n p) = zero (m + n) p.
Proof.
  apply same_entries. intros i j. unfold below. rewrite entry_matrix, !entry_zero.
  destruct (Nat.ltb i (m + n)), (Nat.ltb j p), (Nat.ltb i m); reflexivity.
Qed.
Lemma number_zero : number 0 = zero 1 1.
Proof. reflexivity. Qed.
Lemma trace_zero n : trace (zero n n) = 0.
Proof. apply sum_of_zeros. intro i. apply entry_zero. Qed.
Lemma minus_itself {m n} (A : M m n) : (A - A)%M = zero m n.
Proof.
  apply same_entries. intros i j. rewrite entry_zero. unfold minus. rewrite entry_matrix.
  destruct (Nat.ltb i m), (Nat.ltb j n); ring.
Qed.
Lemma no_difference {m n} (A B : M m n) : A = B -> (A - B)%M = zero m n.
Proof. intros ->. apply minus_itself. Qed.
Lemma same_as {m n} (A B : M m n) : (A - B)%M = zero m n -> A = B.
Proof.
  intro Z. apply same_entries. intros i j. rewrite (entry_inside A), (entry_inside B).
  destruct (Nat.ltb i m) eqn:I; [destruct (Nat.ltb j n) eqn:J|]; try reflexivity.
  assert (E : entry (A - B) i j = 0) by (rewrite Z; apply entry_zero).
  unfold minus in E. rewrite entry_matrix, I, J in E. lra.
Qed.
Lemma trace_not_negative {m n} (A : M m n) : 0 <= trace (A^T * A)%M.
Proof.
  unfold trace, times, transpose. apply sum_not_negative. intro i. rewrite entry_matrix.
  destruct (Nat.ltb i n) eqn:I; [|apply Rle_refl]. apply sum_not_negative. intro k. rewrite entry_matrix, I.
  destruct (Nat.ltb k m) eqn:K; [apply Rle_0_sqr|]. rewrite Rmult_0_l. apply Rle_refl.
Qed.
Lemma vanishing_sum a b : 0 <= a -> 0 <= b -> a + b = 0 -> a = 0 /\ b = 0.
Proof. intros; lra. Qed.
Lemma vanishing_factor a b : 0 < a -> a * b = 0 -> b = 0.
Proof. intros P Z. destruct (Rmult_integral _ _ Z); [lra | assumption]. Qed.
Lemma vanishing_square a : a ^ 2 = 0 -> a = 0.
Proof. intro Z. apply Rsqr_0_uniq. unfold Rsqr. lra. Qed.

Ltac positive := lazymatch goal with
  | |- 0 < _ * _ => apply Rmult_lt_0_compat; positive
  | |- 0 < _ / _ => apply Rdiv_lt_0_compat; positive
  | |- _ => first [lra | solve [auto]]
  end.
Ltac not_negative := lazymatch goal with
  | |- 0 <= _ + _ => apply Rplus_le_le_0_compat; not_negative
  | |- 0 <= dot _ _ => apply dot_not_negative
  | |- 0 <= norm _ => apply norm_not_negative
  | |- 0 <= _ ^ 2 => apply pow2_ge_0
  | |- 0 <= trace _ => apply trace_not_negative
  | |- 0 <= the _ => apply definite_not_negative; auto
  | |- 0 <= _ * _ => apply Rmult_le_pos; not_negative
  | |- 0 <= _ / _ => apply Rle_mult_inv_pos; [not_negative | positive]
  | M : positive_integral ?integral |- 0 <= ?integral _ => apply M; intro; not_negative
  | |- _ => apply Rlt_le; positive
  end.
(* What is never negative vanishes: so does each of its terms, and what is squared in it. *)
Ltac vanishing Z := lazymatch type of Z with
  | _ + _ = 0 =>
      let Z' := fresh Z in apply vanishing_sum in Z; [destruct Z as [Z Z']; vanishing Z; vanishing Z' | not_negative ..]
  | ?a * _ = 0 => first
      [ apply (vanishing_factor a) in Z; [|positive]; vanishing Z
      | rewrite Rmult_comm in Z; apply vanishing_factor in Z; [|positive]; vanishing Z ]
  | _ / _ = 0 => unfold Rdiv in Z; rewrite Rmult_comm in Z; apply vanishing_factor in Z;
      [|apply Rinv_0_lt_compat; positive]; vanishing Z
  | _ ^ 2 = 0 => apply vanishing_square in Z; vanishing Z
  | norm _ = 0 => apply norm_vanishing in Z
  | dot ?v ?v = 0 => apply dot_vanishing in Z
  | the _ = 0 => apply definite_vanishing in Z; [|solve [auto]]
  | _ => idtac
  end.
Ltac terms_vanish Z := lazymatch type of Z with
  | _ + _ = 0 => let Z' := fresh Z in apply vanishing_sum in Z;
      [destruct Z as [Z Z']; terms_vanish Z | not_negative ..]
  | _ => idtac
  end; repeat split; try assumption.
Ltac all_zero := repeat match goal with
  | E : _ = zero _ _ |- _ => progress rewrite E
  | E : _ = 0 |- _ => progress rewrite E
  end; rewrite ?number_zero, ?below_zero.
