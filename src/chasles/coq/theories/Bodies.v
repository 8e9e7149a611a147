(* SPDX-License-Identifier: BSD-3-Clause *)
(* Steps of proofs about integrals over a body. *)
From Chasles Require Export Motion.

Lemma in_elements {B : Type} {m n} (f : B -> M m n) :
  exists g : B -> nat -> nat -> R, f = fun b => matrix m n (g b).
Proof.
  exists (fun b => entry (f b)). extensionality b. apply same_entries. intros i j. rewrite entry_matrix.
  assert (K : forall i j, entry (f b) i j = if Nat.ltb i m then if Nat.ltb j n then entry (f b) i j else 0 else 0).
  { clear. intros i j. generalize (f b). clear. intro A. unfold entry.
    assert (L : forall (T : Type) (x : T) n (r : row T n) i, at_place x i r = if Nat.ltb i n then at_place x i r else x).
    { clear. intros T x n. induction n as [|n IH]; intros r i; [reflexivity|]. destruct i as [|i]; [reflexivity|].
      apply (IH (snd r) i). }
    rewrite (L _ _ _ A i) at 1. destruct (Nat.ltb i m); [apply L|]. rewrite at_place_listed.
    destruct (Nat.ltb j n); reflexivity. }
  apply K.
Qed.
(* An integral that is a sum of multiples of others, which differ from them in spelling only. *)
Ltac spelled_out integral := cbv beta;
  repeat match goal with |- context [integral ?f] => is_var f; change (integral f) with (integral (fun b => f b)) end.
