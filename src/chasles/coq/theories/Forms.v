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
Ltac sum_of_squares := lazymatch goal with
  | |- 0 <= _ + _ => apply Rplus_le_le_0_compat; sum_of_squares
  | |- _ => apply dot_not_negative
  end.
