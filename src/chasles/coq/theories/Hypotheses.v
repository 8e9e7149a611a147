(* SPDX-License-Identifier: BSD-3-Clause *)
(* What is assumed, by name: of vectors and matrices, of what moves, of integrals over a body. *)
From Chasles Require Export Words.

Definition unit_vector {m} (v : M m 1) : Prop := dot v v = 1.
Definition perpendicular {m} (u v : M m 1) : Prop := dot u v = 0.
Definition symmetric {n} (A : M n n) : Prop := A = transpose A.
Definition definite {n} (A : M n n) : Prop := A = transpose A /\ forall x : M n 1, x <> zero n 1 -> 0 < dot x (A * x).
Definition rotation (Q : M 3 3) : Prop := (transpose Q * Q)%M = one 3 /\ det Q = 1.
Definition orthonormal (u v w : M 3 1) : Prop := rotation (beside u (beside v w)).
Definition half_turn (Q : M 3 3) : Prop :=
  Q = transpose Q /\ trace Q = -1 /\ cofactor (Q + one 3) = zero 3 3.

(* What moves is a function of time. It is looked at during T, an open set of instants: a neighbourhood, or all time. *)
Definition during (T : R -> Prop) (P : R -> Prop) : Prop := forall t, T t -> P t.
Definition rate (T : R -> Prop) {m n} (f f_dot : R -> M m n) : Prop :=
  forall t, T t -> forall i j, derivable_pt_lim (fun s => entry (f s) i j) t (entry (f_dot t) i j).
Definition scalar_rate (T : R -> Prop) (f f_dot : R -> R) : Prop := forall t, T t -> derivable_pt_lim f t (f_dot t).

(* A body has elements, whatever they are, and an integral over them is a linear functional. *)
Definition linear {B : Type} (integral : (B -> R) -> R) : Prop :=
  (forall f g, integral (fun b => f b + g b) = integral f + integral g) /\
  (forall k f, integral (fun b => k * f b) = k * integral f).
Definition integrated {B : Type} (integral : (B -> R) -> R) {m n} (f : B -> M m n) : M m n :=
  matrix m n (fun i j => integral (fun b => entry (f b) i j)).
Definition positive_integral {B : Type} (integral : (B -> R) -> R) : Prop :=
  forall f, (forall b, 0 <= f b) -> 0 <= integral f.
(* The one assumption of analysis: the rate of an integral is the integral of the rate. *)
Definition differentiable_under {B : Type} (integral : (B -> R) -> R) : Prop :=
  forall (f g : B -> R -> R) t, (forall b, derivable_pt_lim (f b) t (g b t)) ->
  derivable_pt_lim (fun s => integral (fun b => f b s)) t (integral (fun b => g b t)).

(* What theorems say. *)
Definition least {A : Type} (f : A -> R) (value : R) (place : A) : Prop := f place = value /\ forall x, value <= f x.
