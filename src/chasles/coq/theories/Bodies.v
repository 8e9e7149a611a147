(* SPDX-License-Identifier: BSD-3-Clause *)
(* Steps of proofs about integrals over a body. *)
From Chasles Require Export Motion.

Lemma in_elements {B : Type} {m n} (f : B -> M m n) :
  exists g : B -> nat -> nat -> R, f = fun b => matrix m n (g b).
Proof.
  exists (fun b => entry (f b)). extensionality b. apply same_entries. intros i j. rewrite entry_matrix.
  apply entry_inside.
Qed.
(* An integral that is a sum of multiples of others, which differ from them in spelling only. *)
Ltac spelled_out integral := cbv beta;
  repeat match goal with |- context [integral ?f] => is_var f; change (integral f) with (integral (fun b => f b)) end.
