(* SPDX-License-Identifier: BSD-3-Clause *)
(* Steps of proofs about what moves: rates by the rules of differentiation, word by word. *)
From Chasles Require Export Steps.

Definition rate_at {m n} (f : R -> M m n) (t : R) (d : M m n) : Prop :=
  forall i j, derivable_pt_lim (fun s => entry (f s) i j) t (entry d i j).

(* Rates of numbers. *)
Lemma D_same f t a b : derivable_pt_lim f t a -> a = b -> derivable_pt_lim f t b.
Proof. intros H <-; exact H. Qed.
Lemma D_constant k t : derivable_pt_lim (fun _ => k) t 0.
Proof. exact (derivable_pt_lim_const k t). Qed.
Lemma D_identity t : derivable_pt_lim (fun s => s) t 1.
Proof. exact (derivable_pt_lim_id t). Qed.
Lemma D_plus f g t a b :
  derivable_pt_lim f t a -> derivable_pt_lim g t b -> derivable_pt_lim (fun s => f s + g s) t (a + b).
Proof. exact (derivable_pt_lim_plus f g t a b). Qed.
Lemma D_minus f g t a b :
  derivable_pt_lim f t a -> derivable_pt_lim g t b -> derivable_pt_lim (fun s => f s - g s) t (a - b).
Proof. exact (derivable_pt_lim_minus f g t a b). Qed.
Lemma D_opposite f t a : derivable_pt_lim f t a -> derivable_pt_lim (fun s => - f s) t (- a).
Proof. exact (derivable_pt_lim_opp f t a). Qed.
Lemma D_times f g t a b :
  derivable_pt_lim f t a -> derivable_pt_lim g t b -> derivable_pt_lim (fun s => f s * g s) t (a * g t + f t * b).
Proof. exact (derivable_pt_lim_mult f g t a b). Qed.
Lemma D_over f g t a b : g t <> 0 -> derivable_pt_lim f t a -> derivable_pt_lim g t b ->
  derivable_pt_lim (fun s => f s / g s) t ((a * g t - b * f t) / (g t * g t)).
Proof. intros N F G. exact (derivable_pt_lim_div f g t a b F G N). Qed.
Lemma D_power f t a n : derivable_pt_lim f t a -> derivable_pt_lim (fun s => f s ^ n) t (INR n * f t ^ pred n * a).
Proof. intro H. exact (derivable_pt_lim_comp f (fun y => y ^ n) t a _ H (derivable_pt_lim_pow _ n)). Qed.
Lemma D_half f t a : derivable_pt_lim f t a -> derivable_pt_lim (fun s => f s / 2) t (a / 2).
Proof.
  intro H. eapply D_same; [apply (D_over f (fun _ => 2) t a 0); [lra | exact H | apply D_constant] | field].
Qed.
Lemma D_sin f t a : derivable_pt_lim f t a -> derivable_pt_lim (fun s => sin (f s)) t (cos (f t) * a).
Proof. intro H. exact (derivable_pt_lim_comp f sin t a _ H (derivable_pt_lim_sin _)). Qed.
Lemma D_cos f t a : derivable_pt_lim f t a -> derivable_pt_lim (fun s => cos (f s)) t (- sin (f t) * a).
Proof. intro H. exact (derivable_pt_lim_comp f cos t a _ H (derivable_pt_lim_cos _)). Qed.
Lemma D_exp f t a : derivable_pt_lim f t a -> derivable_pt_lim (fun s => exp (f s)) t (exp (f t) * a).
Proof. intro H. exact (derivable_pt_lim_comp f exp t a _ H (derivable_pt_lim_exp _)). Qed.
Lemma D_sum n (f : R -> nat -> R) d t :
  (forall i, derivable_pt_lim (fun s => f s i) t (d i)) -> derivable_pt_lim (fun s => sum n (f s)) t (sum n d).
Proof.
  revert f d. induction n as [|n IH]; intros f d H; [exact (D_constant 0 t)|].
  destruct n as [|n]; [apply H|].
  change (derivable_pt_lim (fun s => f s O + sum (S n) (fun i => f s (S i))) t (d O + sum (S n) (fun i => d (S i)))).
  apply D_plus; [apply H | apply (IH (fun s i => f s (S i))); intro i; apply H].
Qed.
Lemma D_the (f : R -> M 1 1) t d : rate_at f t d -> derivable_pt_lim (fun s => the (f s)) t (the d).
Proof. intro H. apply H. Qed.
Lemma sum_of_both n f g : sum n f + sum n g = sum n (fun i => f i + g i).
Proof.
  revert f g. induction n as [|n IH]; intros f g; [simpl; ring|]. destruct n as [|n]; [reflexivity|].
  change (f O + sum (S n) (fun i => f (S i)) + (g O + sum (S n) (fun i => g (S i))) =
    f O + g O + sum (S n) (fun i => f (S i) + g (S i))). rewrite <- IH. ring.
Qed.
Lemma D_dot {m} (u v : R -> M m 1) t a b :
  rate_at u t a -> rate_at v t b -> derivable_pt_lim (fun s => dot (u s) (v s)) t (dot a (v t) + dot (u t) b).
Proof.
  intros U V. replace (dot a (v t) + dot (u t) b)
    with (sum m (fun i => entry a i 0 * entry (v t) i 0 + entry (u t) i 0 * entry b i 0)).
  - apply (D_sum m (fun s i => entry (u s) i 0 * entry (v s) i 0)). intro i. apply D_times; [apply U | apply V].
  - symmetry. apply sum_of_both.
Qed.
Lemma D_trace {n} (f : R -> M n n) t d : rate_at f t d -> derivable_pt_lim (fun s => trace (f s)) t (trace d).
Proof. intro H. apply (D_sum n (fun s i => entry (f s) i i)). intro i. apply H. Qed.
Lemma D_square_of_norm {m} (v : R -> M m 1) t d :
  rate_at v t d -> derivable_pt_lim (fun s => norm (v s) ^ 2) t (dot d (v t) + dot (v t) d).
Proof.
  intro V. replace (fun s => norm (v s) ^ 2) with (fun s => dot (v s) (v s)); [apply D_dot; exact V|].
  extensionality s. symmetry. apply norm_square.
Qed.
Lemma D_norm {m} (v : R -> M m 1) t d : norm (v t) <> 0 -> rate_at v t d ->
  derivable_pt_lim (fun s => norm (v s)) t (dot (v t) d / norm (v t)).
Proof.
  intros N V. assert (P : 0 < dot (v t) (v t)).
  { destruct (dot_not_negative (v t)) as [P|Z]; [exact P|]. exfalso. apply N. unfold norm. rewrite <- Z. apply sqrt_0. }
  eapply D_same; [exact (derivable_pt_lim_comp _ sqrt t _ _ (D_dot v v t d d V V) (derivable_pt_lim_sqrt _ P))|].
  replace (dot d (v t)) with (dot (v t) d); [unfold norm in *; field; exact N|].
  unfold dot. f_equal. extensionality i. ring.
Qed.

(* Rates of matrices. *)
Lemma rate_matrix m n (F : R -> nat -> nat -> R) D t :
  (forall i j, derivable_pt_lim (fun s => F s i j) t (D i j)) -> rate_at (fun s => matrix m n (F s)) t (matrix m n D).
Proof.
  intros H i j. rewrite entry_matrix.
  replace (fun s => entry (matrix m n (F s)) i j)
    with (fun s => if Nat.ltb i m then if Nat.ltb j n then F s i j else 0 else 0)
    by (extensionality s; symmetry; apply entry_matrix).
  destruct (Nat.ltb i m); [destruct (Nat.ltb j n)|]; first [apply H | apply D_constant].
Qed.
Lemma rate_constant {m n} (A : M m n) t : rate_at (fun _ => A) t (zero m n).
Proof. intros i j. unfold zero. rewrite entry_matrix. destruct (Nat.ltb i m), (Nat.ltb j n); apply D_constant. Qed.
Lemma rate_plus {m n} (f g : R -> M m n) t a b :
  rate_at f t a -> rate_at g t b -> rate_at (fun s => f s + g s)%M t (a + b)%M.
Proof. intros F G. apply rate_matrix. intros. apply D_plus; [apply F | apply G]. Qed.
Lemma rate_minus {m n} (f g : R -> M m n) t a b :
  rate_at f t a -> rate_at g t b -> rate_at (fun s => f s - g s)%M t (a - b)%M.
Proof. intros F G. apply rate_matrix. intros. apply D_minus; [apply F | apply G]. Qed.
Lemma rate_opposite {m n} (f : R -> M m n) t a : rate_at f t a -> rate_at (fun s => - f s)%M t (- a)%M.
Proof. intro F. apply rate_matrix. intros. apply D_opposite, F. Qed.
Lemma rate_scale {m n} k (f : R -> M m n) t c a :
  derivable_pt_lim k t c -> rate_at f t a -> rate_at (fun s => k s *: f s)%M t (c *: f t + k t *: a)%M.
Proof.
  intros K F. replace (c *: f t + k t *: a)%M with (matrix m n (fun i j => c * entry (f t) i j + k t * entry a i j)).
  - apply rate_matrix. intros. apply D_times; [apply K | apply F].
  - apply same_entries. intros. unfold scale, plus. rewrite !entry_matrix. destruct (Nat.ltb i m), (Nat.ltb j n); ring.
Qed.
Lemma rate_over {m n} (f : R -> M m n) k t a c : k t <> 0 -> rate_at f t a -> derivable_pt_lim k t c ->
  rate_at (fun s => f s / k s)%M t ((k t *: a - c *: f t) / (k t * k t))%M.
Proof.
  intros N F K. replace ((k t *: a - c *: f t) / (k t * k t))%M
    with (matrix m n (fun i j => (entry a i j * k t - c * entry (f t) i j) / (k t * k t))).
  - apply rate_matrix. intros. apply D_over; [exact N | apply F | exact K].
  - apply same_entries. intros. unfold scale, minus, over. rewrite !entry_matrix.
    destruct (Nat.ltb i m), (Nat.ltb j n); field; exact N.
Qed.
Lemma rate_times {m n p} (f : R -> M m n) (g : R -> M n p) t a b :
  rate_at f t a -> rate_at g t b -> rate_at (fun s => f s * g s)%M t (a * g t + f t * b)%M.
Proof.
  intros F G. replace (a * g t + f t * b)%M with (matrix m p (fun i j =>
    sum n (fun k => entry a i k * entry (g t) k j + entry (f t) i k * entry b k j))).
  - apply rate_matrix. intros. apply (D_sum n (fun s k => entry (f s) i k * entry (g s) k j)). intro k.
    apply D_times; [apply F | apply G].
  - apply same_entries. intros. unfold times, plus. rewrite !entry_matrix.
    destruct (Nat.ltb i m), (Nat.ltb j p); try ring. symmetry. apply sum_of_both.
Qed.
Lemma rate_power {n} (f : R -> M n n) k t a b : rate_at (fun s => power (f s) (S k)) t b -> rate_at f t a ->
  rate_at (fun s => power (f s) (S (S k))) t (b * f t + power (f t) (S k) * a)%M.
Proof. exact (rate_times (fun s => power (f s) (S k)) f t b a). Qed.
Lemma rate_transpose {m n} (f : R -> M m n) t a : rate_at f t a -> rate_at (fun s => (f s)^T)%M t (a^T)%M.
Proof. intro F. apply rate_matrix. intros. apply F. Qed.
Lemma rate_below {m n p} (f : R -> M m p) (g : R -> M n p) t a b :
  rate_at f t a -> rate_at g t b -> rate_at (fun s => below (f s) (g s)) t (below a b).
Proof. intros F G. apply rate_matrix. intros. destruct (Nat.ltb i m); [apply F | apply G]. Qed.
Lemma rate_beside {m n p} (f : R -> M p m) (g : R -> M p n) t a b :
  rate_at f t a -> rate_at g t b -> rate_at (fun s => beside (f s) (g s)) t (beside a b).
Proof. intros F G. apply rate_matrix. intros. destruct (Nat.ltb j m); [apply F | apply G]. Qed.
Lemma rate_number f t a : derivable_pt_lim f t a -> rate_at (fun s => number (f s)) t (number a).
Proof. intro F. apply rate_matrix. intros. exact F. Qed.
Lemma rate_CPM (v : R -> M 3 1) t a : rate_at v t a -> rate_at (fun s => CPM (v s)) t (CPM a).
Proof.
  intro V. apply rate_matrix. intros i j.
  destruct i as [|[|[|i]]]; destruct j as [|[|[|j]]]; first [apply D_constant | apply D_opposite, V | apply V].
Qed.
Lemma rate_cross (u v : R -> M 3 1) t a b :
  rate_at u t a -> rate_at v t b -> rate_at (fun s => cross (u s) (v s)) t (cross a (v t) + cross (u t) b)%M.
Proof. intros U V. apply (rate_times (fun s => CPM (u s))); [apply rate_CPM, U | exact V]. Qed.
Lemma rate_vect (f : R -> M 3 3) t a : rate_at f t a -> rate_at (fun s => vect (f s)) t (vect a).
Proof.
  intro F. apply (rate_matrix 3 1 (fun s i _ => match i with
    | 0%nat => (entry (f s) 2 1 - entry (f s) 1 2) / 2
    | 1%nat => (entry (f s) 0 2 - entry (f s) 2 0) / 2
    | _ => (entry (f s) 1 0 - entry (f s) 0 1) / 2 end)).
  intros [|[|i]] j; apply D_half, D_minus; apply F.
Qed.

(* Rates of integrals over a body, where these may be differentiated. *)
Lemma D_integral {B : Type} (integral : (B -> R) -> R) (f : R -> B -> R) (d : B -> R) t : differentiable_under integral ->
  (forall b, derivable_pt_lim (fun s => f s b) t (d b)) -> derivable_pt_lim (fun s => integral (f s)) t (integral d).
Proof. intros H D. exact (H (fun b s => f s b) (fun b _ => d b) t D). Qed.
Lemma rate_integrated {B : Type} (integral : (B -> R) -> R) {m n} (f : R -> B -> M m n) (d : B -> M m n) t :
  differentiable_under integral -> (forall b, rate_at (fun s => f s b) t (d b)) ->
  rate_at (fun s => integrated integral (f s)) t (integrated integral d).
Proof.
  intros H D. apply rate_matrix. intros i j. apply (D_integral integral (fun s b => entry (f s b) i j)); [exact H|].
  intro b. apply D.
Qed.

(* What holds during an open set of instants may be differentiated there. *)
Lemma D_near f g t a d : 0 < d -> (forall s, Rabs (s - t) < d -> f s = g s) ->
  derivable_pt_lim f t a -> derivable_pt_lim g t a.
Proof.
  intros P E H e Pe. destruct (H e Pe) as [c K].
  assert (Pm : 0 < Rmin c d) by (apply Rmin_pos; [apply cond_pos | exact P]).
  exists (mkposreal _ Pm). intros h N L. simpl in L. rewrite <- !E.
  - apply K; [exact N|]. apply Rlt_le_trans with (1 := L), Rmin_l.
  - replace (t - t) with 0 by ring. rewrite Rabs_R0. exact P.
  - replace (t + h - t) with h by ring. apply Rlt_le_trans with (1 := L), Rmin_r.
Qed.
Lemma D_during T f g t a : open_set T -> T t -> (forall s, T s -> f s = g s) ->
  derivable_pt_lim f t a -> derivable_pt_lim g t a.
Proof.
  intros O H E. destruct (O t H) as [d K]. apply (D_near f g t a d (cond_pos d)). intros s L. apply E, K. exact L.
Qed.
Lemma equal_rates T {m n} (f g : R -> M m n) t a b : open_set T -> T t -> (forall s, T s -> f s = g s) ->
  rate_at f t a -> rate_at g t b -> a = b.
Proof.
  intros O H E F G. apply same_entries. intros i j. refine (uniqueness_limite _ t _ _ _ (G i j)).
  apply (D_during T (fun s => entry (f s) i j)); [exact O | exact H | | apply F].
  intros s Hs. rewrite (E s Hs). reflexivity.
Qed.
Lemma equal_scalar_rates T (f g : R -> R) t a b : open_set T -> T t -> (forall s, T s -> f s = g s) ->
  derivable_pt_lim f t a -> derivable_pt_lim g t b -> a = b.
Proof. intros O H E F G. exact (uniqueness_limite g t a b (D_during T f g t a O H E F) G). Qed.

(* A rotation that moves has a spin: the axial vector of its rate times its transpose. *)
Definition spin (Q Q_dot : M 3 3) : M 3 1 := vect (Q_dot * Q^T).
Lemma skew_is_CPM (A : M 3 3) : (A + A^T)%M = zero 3 3 -> A = CPM (vect A).
Proof.
  in_entries A. intro H. words_in H. injection H as ? ? ? ? ? ? ? ? ?. words. entries; lra.
Qed.
Lemma transposed_product (A B : M 3 3) : ((A * B)^T = B^T * A^T)%M.
Proof. in_entries A. in_entries B. words. entries; ring. Qed.
Lemma transposed_twice (A : M 3 3) : (A^T^T)%M = A.
Proof. in_entries A. reflexivity. Qed.
Lemma rate_of_rotation T (Q Q_dot : R -> M 3 3) : open_set T -> (forall t, T t -> rotation (Q t)) -> rate T Q Q_dot ->
  forall t, T t -> Q_dot t = (CPM (spin (Q t) (Q_dot t)) * Q t)%M.
Proof.
  intros O H D t Ht. unfold spin. rewrite <- skew_is_CPM.
  - rewrite <- times_times. rewrite (proj1 (H t Ht)). symmetry. apply times_one.
  - rewrite transposed_product, transposed_twice.
    apply (equal_rates T (fun s => Q s * (Q s)^T)%M (fun _ => one 3) t); [exact O | exact Ht | | | apply rate_constant].
    + intros s Hs. apply rotation_times_transpose, H, Hs.
    + apply (rate_times Q (fun s => (Q s)^T)%M); [exact (D t Ht) | apply rate_transpose; exact (D t Ht)].
Qed.
Lemma rate_of_spin T (Q Q_dot Q_ddot : R -> M 3 3) : rate T Q Q_dot -> rate T Q_dot Q_ddot ->
  rate T (fun t => spin (Q t) (Q_dot t)) (fun t => vect (Q_ddot t * (Q t)^T + Q_dot t * (Q_dot t)^T)).
Proof.
  intros D E t Ht. apply rate_vect, (rate_times Q_dot (fun s => (Q s)^T)%M).
  - exact (E t Ht).
  - apply rate_transpose; exact (D t Ht).
Qed.

(* What is divided by is not zero because that is assumed, or because it is positive. *)
Ltac divisor := first
  [ solve [auto] | apply pow_nonzero; divisor | apply Rgt_not_eq; solve [auto]
  | repeat match goal with H : forall s, ?T s -> ?f s = _, K : ?T ?t |- context [?f ?t] => rewrite (H t K) end;
    match goal with H : forall s, ?T s -> _ <> 0, K : ?T _ |- _ => apply (not_zero_as _ _ (H _ K)); ring end
  | not_zero_alone ].
(* The rules, applied until none is left; the rates of functions of time are among what is known. *)
Ltac rates := lazymatch goal with
  | |- rate_at (fun s => _ + _)%M _ _ => apply rate_plus; rates
  | |- rate_at (fun s => _ - _)%M _ _ => apply rate_minus; rates
  | |- rate_at (fun s => - _)%M _ _ => apply rate_opposite; rates
  | |- rate_at (fun s => _ *: _)%M _ _ => apply rate_scale; rates
  | |- rate_at (fun s => _ / _)%M _ _ => apply rate_over; [cbv beta; divisor | rates | rates]
  | |- rate_at (fun s => _ * _)%M _ _ => apply rate_times; rates
  | |- rate_at (fun s => power _ 1) _ _ => unfold power; rates
  | |- rate_at (fun s => power _ (S (S _))) _ _ => apply rate_power; rates
  | |- rate_at (fun s => transpose _) _ _ => apply rate_transpose; rates
  | |- rate_at (fun s => @below ?m ?n ?p _ _) _ _ => refine (@rate_below m n p _ _ _ _ _ _ _); rates
  | |- rate_at (fun s => @beside ?m ?n ?p _ _) _ _ => refine (@rate_beside m n p _ _ _ _ _ _ _); rates
  | |- rate_at (fun s => number _) _ _ => apply rate_number; rates
  | |- rate_at (fun s => CPM _) _ _ => apply rate_CPM; rates
  | |- rate_at (fun s => cross _ _) _ _ => apply rate_cross; rates
  | |- rate_at (fun s => vect _) _ _ => apply rate_vect; rates
  | H : rate ?T ?f _, K : ?T ?t |- rate_at (fun s => ?f s) ?t _ => exact (H t K)
  | H : rate ?T ?f _, K : ?T ?t |- rate_at ?f ?t _ => exact (H t K)
  | H : forall b, rate ?T (fun u => ?f u b) _, K : ?T ?t |- rate_at (fun s => ?f s ?b) ?t _ => exact (H b t K)
  | H : differentiable_under ?I |- rate_at (fun s => integrated ?I _) _ _ =>
      refine (rate_integrated I _ _ _ H _); intro; rates
  | |- rate_at (fun s => ?A) _ _ => apply rate_constant
  | H : scalar_rate ?T ?f _, K : ?T ?t |- derivable_pt_lim (fun s => ?f s) ?t _ => exact (H t K)
  | H : scalar_rate ?T ?f _, K : ?T ?t |- derivable_pt_lim ?f ?t _ => exact (H t K)
  | |- derivable_pt_lim (fun s => _ + _) _ _ => apply D_plus; rates
  | |- derivable_pt_lim (fun s => _ - _) _ _ => apply D_minus; rates
  | |- derivable_pt_lim (fun s => _ * _) _ _ => apply D_times; rates
  | |- derivable_pt_lim (fun s => _ / _) _ _ => apply D_over; [cbv beta; divisor | rates | rates]
  | |- derivable_pt_lim (fun s => - _) _ _ => apply D_opposite; rates
  | |- derivable_pt_lim (fun s => norm _ ^ 2) _ _ => apply D_square_of_norm; rates
  | |- derivable_pt_lim (fun s => _ ^ _) _ _ => apply D_power; rates
  | |- derivable_pt_lim (fun s => sin _) _ _ => apply D_sin; rates
  | |- derivable_pt_lim (fun s => cos _) _ _ => apply D_cos; rates
  | |- derivable_pt_lim (fun s => exp _) _ _ => apply D_exp; rates
  | |- derivable_pt_lim (fun s => dot _ _) _ _ => apply D_dot; rates
  | |- derivable_pt_lim (fun s => trace _) _ _ => apply D_trace; rates
  | |- derivable_pt_lim (fun s => norm _) _ _ => apply D_norm; [cbv beta; divisor | rates]
  | |- derivable_pt_lim (fun s => the _) _ _ => apply D_the; rates
  | H : forall b, scalar_rate ?T (fun u => ?f u b) _, K : ?T ?t |- derivable_pt_lim (fun s => ?f s ?b) ?t _ =>
      exact (H b t K)
  | H : differentiable_under ?I |- derivable_pt_lim (fun s => ?I _) _ _ =>
      refine (D_integral I _ _ _ H _); intro; rates
  | |- derivable_pt_lim (fun s => s) _ _ => apply D_identity
  | |- derivable_pt_lim (?f ?k) ?t ?d => change (derivable_pt_lim (fun s => f k s) t d); rates
  | |- derivable_pt_lim (fun s => ?c) _ _ => apply D_constant
  end.
Lemma spin_of_rotation T (Q Q_dot : R -> M 3 3) : open_set T -> (forall t, T t -> rotation (Q t)) -> rate T Q Q_dot ->
  exists w : R -> M 3 1, forall t, T t -> Q_dot t = (CPM (w t) * Q t)%M.
Proof. intros O H D. exists (fun t => spin (Q t) (Q_dot t)). apply (rate_of_rotation T Q Q_dot O H D). Qed.
Lemma spin_of_rotation_moves T (Q Q_dot Q_ddot : R -> M 3 3) :
  open_set T -> (forall t, T t -> rotation (Q t)) -> rate T Q Q_dot -> rate T Q_dot Q_ddot ->
  exists w w_dot : R -> M 3 1, rate T w w_dot /\ forall t, T t -> Q_dot t = (CPM (w t) * Q t)%M.
Proof.
  intros O H D E. exists (fun t => spin (Q t) (Q_dot t)), (fun t => vect (Q_ddot t * (Q t)^T + Q_dot t * (Q_dot t)^T)).
  split; [apply (rate_of_spin T Q Q_dot Q_ddot D E) | apply (rate_of_rotation T Q Q_dot O H D)].
Qed.
