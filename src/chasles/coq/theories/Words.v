(* SPDX-License-Identifier: BSD-3-Clause *)
(* What do the words mean? Matrices of real numbers with their sizes in their types: what does not fit together is no
   statement. An m x n matrix is m rows of n entries; rows and columns are counted from 0 here. *)
From Coq Require Export Reals.
Open Scope R_scope.

Fixpoint row (T : Type) (n : nat) : Type := match n with O => unit | S k => (T * row T k)%type end.
Definition M (m n : nat) : Type := row (row R n) m.

Fixpoint listed {T} (n : nat) (f : nat -> T) : row T n :=
  match n with O => tt | S k => (f O, listed k (fun i => f (S i))) end.
Fixpoint at_place {T} (otherwise : T) {n} (i : nat) : row T n -> T :=
  match n with
  | O => fun _ => otherwise
  | S k => fun r => match i with O => fst r | S j => at_place otherwise j (snd r) end
  end.
Fixpoint sum (n : nat) (f : nat -> R) : R :=
  match n with O => 0 | S O => f O | S k => f O + sum k (fun i => f (S i)) end.

Definition matrix (m n : nat) (f : nat -> nat -> R) : M m n := listed m (fun i => listed n (f i)).
Definition entry {m n} (A : M m n) (i j : nat) : R := at_place 0 j (at_place (listed n (fun _ => 0)) i A).

Definition plus {m n} (A B : M m n) : M m n := matrix m n (fun i j => entry A i j + entry B i j).
Definition minus {m n} (A B : M m n) : M m n := matrix m n (fun i j => entry A i j - entry B i j).
Definition opposite {m n} (A : M m n) : M m n := matrix m n (fun i j => - entry A i j).
Definition scale {m n} (k : R) (A : M m n) : M m n := matrix m n (fun i j => k * entry A i j).
Definition over {m n} (A : M m n) (k : R) : M m n := matrix m n (fun i j => entry A i j / k).
Definition times {m n p} (A : M m n) (B : M n p) : M m p :=
  matrix m p (fun i j => sum n (fun k => entry A i k * entry B k j)).
Definition transpose {m n} (A : M m n) : M n m := matrix n m (fun i j => entry A j i).
Definition one (n : nat) : M n n := matrix n n (fun i j => if Nat.eqb i j then 1 else 0).
Definition zero (m n : nat) : M m n := matrix m n (fun _ _ => 0).
Fixpoint power {n} (A : M n n) (k : nat) : M n n :=
  match k with O => one n | S O => A | S j => times (power A j) A end.

(* Blocks: one below the other, one beside the other; a number as a 1 x 1 matrix, and back. *)
Definition below {m n p} (A : M m p) (B : M n p) : M (m + n) p :=
  matrix (m + n) p (fun i j => if Nat.ltb i m then entry A i j else entry B (i - m) j).
Definition beside {m n p} (A : M p m) (B : M p n) : M p (m + n) :=
  matrix p (m + n) (fun i j => if Nat.ltb j m then entry A i j else entry B i (j - m)).
Definition number (x : R) : M 1 1 := matrix 1 1 (fun _ _ => x).
Definition the (A : M 1 1) : R := entry A 0 0.

Definition sign (x : R) : R := if Rlt_dec 0 x then 1 else if Rlt_dec x 0 then -1 else 0.
Definition atan2 (y x : R) : R :=
  if Rlt_dec 0 x then atan (y / x)
  else if Rlt_dec x 0 then if Rlt_dec y 0 then atan (y / x) - PI else atan (y / x) + PI
  else if Rlt_dec 0 y then PI / 2 else if Rlt_dec y 0 then - (PI / 2) else 0.
Definition dot {m} (u v : M m 1) : R := sum m (fun i => entry u i 0 * entry v i 0).
Definition norm {m} (v : M m 1) : R := sqrt (dot v v).
Definition vector (x y z : R) : M 3 1 :=
  matrix 3 1 (fun i _ => match i with O => x | S O => y | _ => z end).
Definition CPM (v : M 3 1) : M 3 3 := matrix 3 3 (fun i j =>
  match i, j with
  | 0, 1 => - entry v 2 0 | 0, 2 => entry v 1 0 | 1, 2 => - entry v 0 0
  | 1, 0 => entry v 2 0 | 2, 0 => - entry v 1 0 | 2, 1 => entry v 0 0
  | _, _ => 0
  end).
Definition cross (u v : M 3 1) : M 3 1 := times (CPM u) v.
Definition vect (A : M 3 3) : M 3 1 :=
  vector ((entry A 2 1 - entry A 1 2) / 2) ((entry A 0 2 - entry A 2 0) / 2) ((entry A 1 0 - entry A 0 1) / 2).
Definition trace {n} (A : M n n) : R := sum n (fun i => entry A i i).

(* Determinants by expansion along the first row; the cofactor of an entry is what it is multiplied by there. *)
Definition signed (k : nat) (x : R) : R := if Nat.even k then x else - x.
Definition past (i k : nat) : nat := if Nat.ltb k i then k else S k.
Fixpoint determinant (n : nat) (f : nat -> nat -> R) : R :=
  match n with
  | O => 1
  | S O => f O O
  | S k => sum n (fun j => signed j (f O j * determinant k (fun a b => f (S a) (past j b))))
  end.
Definition det {n} (A : M n n) : R := determinant n (entry A).
Definition cofactor {n} (A : M n n) : M n n := matrix n n (fun i j =>
  signed (i + j) (determinant (n - 1) (fun a b => entry A (past i a) (past j b)))).

Declare Scope matrix_scope.
Delimit Scope matrix_scope with M.
Bind Scope matrix_scope with M.
Infix "+" := plus : matrix_scope.
Infix "-" := minus : matrix_scope.
Infix "*" := times : matrix_scope.
Notation "- A" := (opposite A) : matrix_scope.
Notation "k *: A" := (scale k%R A) (at level 40, left associativity) : matrix_scope.
Notation "A / k" := (over A k%R) : matrix_scope.
Notation "A ^T" := (transpose A) (at level 1, format "A ^T") : matrix_scope.
Notation "A ^ k" := (power A k%nat) : matrix_scope.
Arguments entry {m n} A%M (i j)%nat.
Arguments scale {m n} k%R A%M.
Arguments over {m n} A%M k%R.
Arguments times {m n p} (A B)%M.
Arguments transpose {m n} A%M.
Arguments below {m n p} (A B)%M.
Arguments beside {m n p} (A B)%M.
Arguments number x%R.
Arguments the A%M.
Arguments dot {m} (u v)%M.
Arguments norm {m} v%M.
Arguments CPM v%M.
Arguments cross (u v)%M.
Arguments vect A%M.
Arguments trace {n} A%M.
Arguments det {n} A%M.
Arguments cofactor {n} A%M.
