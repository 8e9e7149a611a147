(* SPDX-License-Identifier: BSD-3-Clause *)
(* Equations between sums, products and quotients of numbers, decided by computation: both sides are polynomials with
   integer coefficients over powers of what is not zero. Nothing here has to be believed. *)
From Coq Require Import Ring_polynom Ring_theory BinList List.
From Coq Require Import Lia.
From Coq Require Export Reals Lra.
From Ltac2 Require Ltac2.
Open Scope R_scope.

Inductive expr := Var (p : positive) | Cst (z : Z) | Add (a b : expr) | Sub (a b : expr) | Mul (a b : expr)
  | Opp (a : expr) | Div (a b : expr) | Inv (a : expr) | Pow (a : expr) (n : nat).
Fixpoint eval (l : list R) (e : expr) : R := match e with
  | Var p => BinList.nth 0 p l | Cst z => IZR z | Add a b => eval l a + eval l b | Sub a b => eval l a - eval l b
  | Mul a b => eval l a * eval l b | Opp a => - eval l a | Div a b => eval l a / eval l b | Inv a => / eval l a
  | Pow a n => eval l a ^ n end.

Definition poly := Pol Z.
Definition padd : poly -> poly -> poly := Padd 0%Z Z.add Zeq_bool.
Definition pmul : poly -> poly -> poly := Pmul 0%Z 1%Z Z.add Z.mul Zeq_bool.
Definition popp : poly -> poly := Popp Z.opp.
Definition pscale (p : poly) (z : Z) : poly := PmulC 0%Z 1%Z Z.mul Zeq_bool p z.
Definition pval (l : list R) (p : poly) : R := Pphi 0 Rplus Rmult IZR l p.
Fixpoint ppow (p : poly) (n : nat) : poly := match n with O => Pc 1%Z | S O => p | S n => pmul p (ppow p n) end.
Definition peq : poly -> poly -> bool := Peq Zeq_bool.
Local Notation ring_facts := (Rth_ARth (Eqsth R) (Eq_ext Rplus Rmult Ropp) RTheory).
Section Values.
Context (l : list R).
Lemma pval_add p q : pval l (padd p q) = pval l p + pval l q.
Proof. apply (Padd_ok (Eqsth R) (Eq_ext Rplus Rmult Ropp) ring_facts R_rm). Qed.
Lemma pval_mul p q : pval l (pmul p q) = pval l p * pval l q.
Proof. apply (Pmul_ok (Eqsth R) (Eq_ext Rplus Rmult Ropp) ring_facts R_rm). Qed.
Lemma pval_opp p : pval l (popp p) = - pval l p.
Proof. apply (Popp_ok (Eqsth R) (Eq_ext Rplus Rmult Ropp) ring_facts R_rm). Qed.
Lemma pval_scale p z : pval l (pscale p z) = pval l p * IZR z.
Proof. apply (PmulC_ok (Eqsth R) (Eq_ext Rplus Rmult Ropp) ring_facts R_rm). Qed.
Lemma pval_equal p q : peq p q = true -> pval l p = pval l q.
Proof. intro H. apply (Peq_ok (Eqsth R) (Eq_ext Rplus Rmult Ropp) R_rm p q H). Qed.
Lemma pval_variable p : pval l (mk_X 0%Z 1%Z p) = BinList.nth 0 p l.
Proof. symmetry. apply (mkX_ok (Eqsth R) (Eq_ext Rplus Rmult Ropp) ring_facts R_rm). Qed.
Lemma pval_pow p n : pval l (ppow p n) = pval l p ^ n.
Proof.
  induction n as [|[|n] IH]; [reflexivity | simpl; ring |].
  change (pval l (pmul p (ppow p (S n))) = pval l p * pval l p ^ S n). rewrite pval_mul, IH. reflexivity.
Qed.

(* A quotient: a polynomial over a number and over powers of the factors that are not zero. *)
Definition quotient : Type := poly * positive * list nat.
Context (factors : list poly).
Fixpoint product (fs : list poly) (e : list nat) : R :=
  match fs with nil => 1 | f :: fs => pval l f ^ List.hd O e * product fs (tl e) end.
Fixpoint lacking (fs : list poly) (e e' : list nat) : poly := match fs with nil => Pc 1%Z
  | f :: fs => let n := (List.hd O e' - List.hd O e)%nat in
    if Nat.eqb n 0 then lacking fs (tl e) (tl e') else pmul (ppow f n) (lacking fs (tl e) (tl e')) end.
Fixpoint highest (fs : list poly) (e e' : list nat) : list nat := match fs with nil => nil
  | f :: fs => Nat.max (List.hd O e) (List.hd O e') :: highest fs (tl e) (tl e') end.
Fixpoint together (fs : list poly) (e e' : list nat) : list nat := match fs with nil => nil
  | f :: fs => (List.hd O e + List.hd O e')%nat :: together fs (tl e) (tl e') end.
Definition qval (q : quotient) : R := let '(p, d, e) := q in pval l p / (IZR (Zpos d) * product factors e).
Fixpoint all_nonzero (fs : list poly) : Prop := match fs with nil => True | f :: fs => pval l f <> 0 /\ all_nonzero fs end.
Context (nonzero : all_nonzero factors).

Lemma product_nonzero fs e : all_nonzero fs -> product fs e <> 0.
Proof.
  revert e. induction fs as [|f fs IH]; intros e H; simpl; [lra|]. destruct H as [F H].
  apply Rmult_integral_contrapositive_currified; [apply pow_nonzero, F | apply IH, H].
Qed.
Lemma lacking_is fs e e' : product fs e * pval l (lacking fs e e') = product fs (highest fs e e').
Proof.
  revert e e'. induction fs as [|f fs IH]; intros e e'; simpl; [change (pval l (Pc 1%Z)) with 1; ring|].
  rewrite <- IH. replace (Nat.max (List.hd O e) (List.hd O e'))
    with (List.hd O e + (List.hd O e' - List.hd O e))%nat by lia. rewrite pow_add.
  destruct (Nat.eqb_spec (List.hd O e' - List.hd O e) 0) as [->|_]; [|rewrite pval_mul, pval_pow]; simpl; ring.
Qed.
Lemma highest_same fs e e' : highest fs e e' = highest fs e' e.
Proof. revert e e'. induction fs; intros; simpl; [reflexivity|]. rewrite Nat.max_comm. f_equal. apply IHfs. Qed.
Lemma together_is fs e e' : product fs (together fs e e') = product fs e * product fs e'.
Proof. revert e e'. induction fs; intros; simpl; [ring|]. rewrite IHfs, pow_add. ring. Qed.
Lemma positive_nonzero d : IZR (Zpos d) <> 0.
Proof. apply not_0_IZR. discriminate. Qed.

Definition qadd (a b : quotient) : quotient := let '(p, d, e) := a in let '(q, c, f) := b in
  let p' := pmul p (lacking factors e f) in let q' := pmul q (lacking factors f e) in
  if Pos.eqb d c then (padd p' q', d, highest factors e f)
  else let '(_, (d', c')) := Pos.ggcd d c in
    (padd (pscale p' (Zpos c')) (pscale q' (Zpos d')), (d * c')%positive, highest factors e f).
Definition qmul (a b : quotient) : quotient := let '(p, d, e) := a in let '(q, c, f) := b in
  (pmul p q, (d * c)%positive, together factors e f).
Definition qopp (a : quotient) : quotient := let '(p, d, e) := a in (popp p, d, e).
Fixpoint qpow (a : quotient) (n : nat) : quotient :=
  match n with O => (Pc 1%Z, xH, nil) | S O => a | S n => qmul a (qpow a n) end.
Lemma qval_add a b : qval (qadd a b) = qval a + qval b.
Proof.
  destruct a as [[p d] e], b as [[q c] f]. unfold qadd.
  pose proof (lacking_is factors e f) as E. pose proof (lacking_is factors f e) as F. rewrite highest_same in F.
  pose proof (product_nonzero factors e nonzero) as Ne. pose proof (product_nonzero factors f nonzero) as Nf.
  pose proof (product_nonzero factors (highest factors e f) nonzero) as Nh.
  assert (Ze : pval l (lacking factors e f) = product factors (highest factors e f) / product factors e)
    by (rewrite <- E; field; exact Ne).
  assert (Zf : pval l (lacking factors f e) = product factors (highest factors e f) / product factors f)
    by (rewrite <- F; field; exact Nf).
  pose proof (positive_nonzero d) as Nd. pose proof (positive_nonzero c) as Nc.
  destruct (Pos.eqb_spec d c) as [<-|_].
  - simpl. rewrite pval_add, !pval_mul, Ze, Zf. field. auto.
  - pose proof (Pos.ggcd_correct_divisors d c) as G. destruct (Pos.ggcd d c) as [g [d' c']]. destruct G as [G1 G2].
    assert (D : IZR (Zpos d) = IZR (Zpos g) * IZR (Zpos d')) by (rewrite <- mult_IZR; f_equal; rewrite G1; reflexivity).
    assert (C : IZR (Zpos c) = IZR (Zpos g) * IZR (Zpos c')) by (rewrite <- mult_IZR; f_equal; rewrite G2; reflexivity).
    simpl. rewrite pval_add, !pval_scale, !pval_mul, Ze, Zf, Pos2Z.inj_mul, mult_IZR, D, C.
    pose proof (positive_nonzero d'). pose proof (positive_nonzero c'). pose proof (positive_nonzero g). field. auto 10.
Qed.
Lemma qval_mul a b : qval (qmul a b) = qval a * qval b.
Proof.
  destruct a as [[p d] e], b as [[q c] f]. simpl. rewrite pval_mul, together_is, Pos2Z.inj_mul, mult_IZR.
  pose proof (positive_nonzero d). pose proof (positive_nonzero c).
  pose proof (product_nonzero factors e nonzero). pose proof (product_nonzero factors f nonzero). field. auto.
Qed.
Lemma qval_opp a : qval (qopp a) = - qval a.
Proof.
  destruct a as [[p d] e]. simpl. rewrite pval_opp. pose proof (positive_nonzero d).
  pose proof (product_nonzero factors e nonzero). field. auto.
Qed.
Lemma product_of_none fs : product fs nil = 1.
Proof. induction fs as [|f fs IH]; simpl; [reflexivity|]. rewrite IH. ring. Qed.
Lemma qval_poly p : qval (p, xH, nil) = pval l p.
Proof. simpl. rewrite product_of_none. field. Qed.
Lemma qval_pow a n : qval (qpow a n) = qval a ^ n.
Proof.
  induction n as [|[|n] IH]; [apply (qval_poly (Pc 1%Z)) | simpl; ring |].
  change (qval (qmul a (qpow a (S n))) = qval a * qval a ^ S n). rewrite qval_mul, IH. reflexivity.
Qed.

(* One over a quotient, of which the polynomial is a number, or a number times one of the factors. *)
Fixpoint leading (p : poly) : Z := match p with Pc c => c | Pinj _ p => leading p | PX p _ _ => leading p end.
Definition over_number (q : poly) (z : Z) (e : list nat) : option quotient := match z with
  | Z0 => None | Zpos d => Some (q, d, e) | Zneg d => Some (popp q, d, e) end.
Lemma over_number_is q z e r : over_number q z e = Some r -> z <> 0%Z /\ qval r = pval l q / (IZR z * product factors e).
Proof.
  pose proof (product_nonzero factors e nonzero) as N.
  destruct z as [|d|d]; [discriminate | | ]; intros [= <-]; (split; [discriminate|]); simpl.
  - reflexivity.
  - rewrite pval_opp. pose proof (positive_nonzero d). change (IZR (Zneg d)) with (- IZR (Zpos d)). field. auto.
Qed.
Fixpoint unit_of (n : nat) : list nat := match n with O => 1%nat :: nil | S n => O :: unit_of n end.
Fixpoint among (fs : list poly) (n : nat) (p : poly) : option (nat * Z * Z) := match fs with nil => None
  | f :: fs => if peq (pscale p (leading f)) (pscale f (leading p)) then Some (n, leading f, leading p)
    else among fs (S n) p end.
Fixpoint nth_factor (fs : list poly) (n : nat) : R :=
  match fs, n with nil, _ => 1 | f :: _, O => pval l f | _ :: fs, S n => nth_factor fs n end.
Lemma product_of_unit fs n : product fs (unit_of n) = nth_factor fs n.
Proof.
  revert n. induction fs as [|f fs IH]; intros [|n]; simpl; try reflexivity.
  - rewrite product_of_none. ring.
  - rewrite IH. ring.
Qed.
Lemma among_is fs k n p a b : among fs k p = Some (n, a, b) ->
  (k <= n)%nat /\ pval l p * IZR a = nth_factor fs (n - k) * IZR b.
Proof.
  revert k. induction fs as [|f fs IH]; intros k; simpl; [discriminate|].
  destruct (peq _ _) eqn:E.
  - intros [= <- <- <-]. rewrite Nat.sub_diag. split; [lia|]. rewrite <- !pval_scale. apply pval_equal, E.
  - intro H. destruct (IH _ H) as [L K]. split; [lia|]. replace (n - k)%nat with (S (n - S k)) by lia. exact K.
Qed.
Definition qinverse (a : quotient) : option quotient := let '(p, d, e) := a in
  let top := pscale (lacking factors nil e) (Zpos d) in
  match p with
  | Pc c => over_number top c nil
  | _ => match among factors O p with
    | Some (n, f, c) => if Z.eqb f 0 then None else over_number (pscale top f) c (unit_of n)
    | None => None end end.
Lemma lacking_all fs e : pval l (lacking fs nil e) = product fs e.
Proof.
  revert e. induction fs as [|f fs IH]; intros e; simpl; [reflexivity|]. rewrite Nat.sub_0_r, <- IH.
  destruct (Nat.eqb_spec (List.hd O e) 0) as [->|_]; [simpl; ring | rewrite pval_mul, pval_pow; reflexivity].
Qed.
Lemma qinverse_is a r : qinverse a = Some r -> qval a * qval r = 1.
Proof.
  destruct a as [[p d] e]. unfold qinverse. set (top := pscale (lacking factors nil e) (Zpos d)).
  assert (T : pval l top = product factors e * IZR (Zpos d)) by (unfold top; rewrite pval_scale, lacking_all; reflexivity).
  pose proof (positive_nonzero d) as Nd. pose proof (product_nonzero factors e nonzero) as Ne.
  assert (K : forall n f c, among factors 0 p = Some (n, f, c) ->
    (if Z.eqb f 0 then None else over_number (pscale top f) c (unit_of n)) = Some r -> qval (p, d, e) * qval r = 1).
  { intros n f c E. destruct (Z.eqb_spec f 0) as [|Nf]; [discriminate|]. intro H. apply over_number_is in H.
    destruct H as [Nc ->]. apply among_is in E. destruct E as [_ E]. rewrite Nat.sub_0_r, <- product_of_unit in E.
    pose proof (product_nonzero factors (unit_of n) nonzero) as Nu. rewrite pval_scale, T. simpl.
    apply not_0_IZR in Nf. apply not_0_IZR in Nc.
    replace (pval l p) with (product factors (unit_of n) * IZR c / IZR f) by (rewrite <- E; field; exact Nf).
    field. auto 10. }
  destruct p as [c|j p|p i q].
  - intro H. apply over_number_is in H. destruct H as [Nc ->]. apply not_0_IZR in Nc. rewrite T, product_of_none. simpl.
    change (pval l (Pc c)) with (IZR c). field. auto.
  - destruct (among factors 0 (Pinj j p)) as [[[n f] c]|] eqn:E; [|discriminate]. apply K. reflexivity.
  - destruct (among factors 0 (PX p i q)) as [[[n f] c]|] eqn:E; [|discriminate]. apply K. reflexivity.
Qed.

Definition both (f : quotient -> quotient -> quotient) (a b : option quotient) : option quotient :=
  match a, b with Some a, Some b => Some (f a b) | _, _ => None end.
Definition one_of (a : option quotient) (f : quotient -> quotient) : option quotient :=
  match a with Some a => Some (f a) | None => None end.
Fixpoint reckoned (e : expr) (inverse : bool) : option quotient :=
  let value := fun _ : unit => match e with
    | Var p => Some (mk_X 0%Z 1%Z p, xH, nil)
    | Cst z => Some (Pc z, xH, nil)
    | Add a b => both qadd (reckoned a false) (reckoned b false)
    | Sub a b => both (fun a b => qadd a (qopp b)) (reckoned a false) (reckoned b false)
    | Mul a b => both qmul (reckoned a false) (reckoned b false)
    | Opp a => one_of (reckoned a false) qopp
    | Div a b => both qmul (reckoned a false) (reckoned b true)
    | Inv a => reckoned a true
    | Pow a n => one_of (reckoned a false) (fun a => qpow a n)
    end in
  if inverse then
    match match e with
    | Mul a b => both qmul (reckoned a true) (reckoned b true)
    | Opp a => one_of (reckoned a true) qopp
    | Pow a n => one_of (reckoned a true) (fun a => qpow a n)
    | _ => None end with
    | Some q => Some q
    | None => match value tt with Some q => qinverse q | None => None end end
  else value tt.
Lemma both_is f a b r : both f a b = Some r -> exists x y, a = Some x /\ b = Some y /\ r = f x y.
Proof. destruct a as [a|], b as [b|]; try discriminate. intros [= <-]. eauto. Qed.
Lemma one_of_is a f r : one_of a f = Some r -> exists x, a = Some x /\ r = f x.
Proof. destruct a; [|discriminate]. intros [= <-]. eauto. Qed.
Lemma one_over x y : x * y = 1 -> / x = y.
Proof.
  intro H. assert (N : x <> 0) by (intros ->; lra). apply (Rmult_eq_reg_l x); [|exact N]. rewrite H. apply Rinv_r, N.
Qed.
Definition of_parts (e : expr) : option quotient := match e with
  | Mul a b => both qmul (reckoned a true) (reckoned b true)
  | Opp a => one_of (reckoned a true) qopp
  | Pow a n => one_of (reckoned a true) (fun a => qpow a n)
  | _ => None end.
Lemma reckoned_inverse e : reckoned e true = match of_parts e with
  | Some q => Some q | None => match reckoned e false with Some q => qinverse q | None => None end end.
Proof. destruct e; reflexivity. Qed.
Definition is_reckoned (e : expr) : Prop := (forall r, reckoned e false = Some r -> eval l e = qval r) /\
  (forall r, reckoned e true = Some r -> eval l e * qval r = 1).
Lemma with_inverse e : (forall r, reckoned e false = Some r -> eval l e = qval r) ->
  (forall r, of_parts e = Some r -> eval l e * qval r = 1) -> is_reckoned e.
Proof.
  intros V P. split; [exact V|]. intro r. rewrite reckoned_inverse.
  destruct (of_parts e) as [q|]; [apply P|]. destruct (reckoned e false) as [q|]; [|discriminate].
  intro H. rewrite (V q eq_refl). apply qinverse_is, H.
Qed.
Ltac parts H := first [apply both_is in H; destruct H as (? & ? & ? & ? & ->)
  | apply one_of_is in H; destruct H as (? & ? & ->)].
Lemma reckoned_is e : is_reckoned e.
Proof.
  induction e as [p|z|a [A A'] b [B B']|a [A A'] b [B B']|a [A A'] b [B B']|a [A A']|a [A A'] b [B B']|a [A A']|a [A A'] n];
    apply with_inverse; intros r H; try discriminate H; simpl in H; try parts H;
    repeat match goal with K : forall r, reckoned ?e ?b = _ -> _, L : reckoned ?e ?b = _ |- _ => apply K in L end;
    rewrite ?qval_mul, ?qval_add, ?qval_opp, ?qval_pow; simpl.
  1, 2: injection H as <-; rewrite qval_poly; first [reflexivity | symmetry; apply pval_variable].
  all: try (unfold Rminus, Rdiv; repeat match goal with L : _ * _ = 1 |- _ => apply one_over in L end; congruence).
  - transitivity ((eval l a * qval x) * (eval l b * qval x0)); [ring|]. rewrite H, H0. ring.
  - rewrite <- H. ring.
  - rewrite <- Rpow_mult_distr, H. apply pow1.
Qed.
End Values.

(* Two sides are equal where the polynomial of their difference is zero. *)
Fixpoint factors_of (es : list expr) : list poly := match es with nil => nil
  | e :: es => match reckoned nil e false with Some (p, _, _) => p :: factors_of es | None => factors_of es end end.
Fixpoint nonzero (l : list R) (es : list expr) : Prop :=
  match es with nil => True | e :: es => eval l e <> 0 /\ nonzero l es end.
Lemma nonzero_none l : nonzero l nil.
Proof. exact Logic.I. Qed.
Lemma nonzero_more l e es : eval l e <> 0 -> nonzero l es -> nonzero l (e :: es).
Proof. split; assumption. Qed.
Definition equal (es : list expr) (a b : expr) : bool :=
  match reckoned (factors_of es) (Sub a b) false with Some (p, _, _) => peq p (Pc 0%Z) | None => false end.
Lemma factors_of_nonzero l es : nonzero l es -> all_nonzero l (factors_of es).
Proof.
  induction es as [|e es IH]; simpl; [trivial|]. intros [N H]. destruct (reckoned nil e false) as [[[p d] f]|] eqn:E;
    [|apply IH, H]. split; [|apply IH, H]. intro Z. apply N. apply (reckoned_is l nil Logic.I) in E. rewrite E. simpl. rewrite Z.
  unfold Rdiv. ring.
Qed.
Lemma equal_is l es a b : nonzero l es -> equal es a b = true -> eval l a = eval l b.
Proof.
  intros N. unfold equal. destruct (reckoned _ _ _) as [[[p d] e]|] eqn:E; [|discriminate]. intro Z.
  apply (reckoned_is l _ (factors_of_nonzero l es N)) in E. apply (pval_equal l) in Z. simpl in E, Z.
  apply Rminus_diag_uniq. rewrite E, Z. unfold Rdiv. change (pval l (Pc 0%Z)) with 0. ring.
Qed.

(* What an expression is made of is read by a program; Coq's kernel compares what it has read with the expression. *)
Import Ltac2.Ltac2.
Set Default Proof Mode "Classic".
Ltac2 Type found := { mutable known : (constr * constr) list; mutable atoms : constr list; mutable count : int;
  mutable divides : bool }.
Ltac2 applied (f : constr) (args : constr list) :=
  Constr.Unsafe.make (Constr.Unsafe.App f (Array.of_list args)).
Ltac2 rec positive_of (n : int) :=
  if Int.equal n 1 then 'xH
  else applied (if Int.equal (Int.mod n 2) 0 then 'xO else 'xI) [positive_of (Int.div n 2)].
Ltac2 rec looked_up (x : constr) (known : (constr * constr) list) := match known with
  | [] => None
  | pair :: others => let (y, v) := pair in if Constr.equal x y then Some v else looked_up x others
  end.
Ltac2 reader (found : found) :=
  let plus := 'Rplus in let minus := 'Rminus in let times := 'Rmult in let over := 'Rdiv in let opposite := 'Ropp in
  let inverse := 'Rinv in let power := 'pow in let integer := 'IZR in
  let add := 'Add in let sub := 'Sub in let mul := 'Mul in let div := 'Div in let opp := 'Opp in let inv := 'Inv in
  let pow := 'Pow in let cst := 'Cst in let var := 'Var in
  let atom x := match looked_up x (found.(known)) with
    | Some v => v
    | None =>
      let n := Int.add (found.(count)) 1 in
      let v := applied var [positive_of n] in
      found.(count) := n; found.(known) := (x, v) :: found.(known); found.(atoms) := x :: found.(atoms); v
    end in
  let rec read x := match Constr.Unsafe.kind x with
    | Constr.Unsafe.App f args =>
      let two c := applied c [read (Array.get args 0); read (Array.get args 1)] in
      if Constr.equal f times then two mul
      else if Constr.equal f plus then two add
      else if Constr.equal f minus then two sub
      else if Constr.equal f power then applied pow [read (Array.get args 0); Array.get args 1]
      else if Constr.equal f integer then applied cst [Array.get args 0]
      else if Constr.equal f opposite then applied opp [read (Array.get args 0)]
      else if Constr.equal f over then (found.(divides) := true; two div)
      else if Constr.equal f inverse then (found.(divides) := true; applied inv [read (Array.get args 0)])
      else atom x
    | _ => atom x
    end in
  read.
Ltac2 listed (kind : constr) (items : constr list) :=
  let cons := '@cons in
  List.fold_right (fun x rest => applied cons [kind; x; rest]) (applied '@nil [kind]) items.
Ltac2 not_zero_here () :=
  List.flat_map (fun h => let (name, _, kind) := h in match! kind with
    | ?x <> 0 => [(x, Control.hyp name)]
    | ?x = 0 -> False => [(x, Control.hyp name)]
    | _ => [] end) (Control.hyps ()).
Ltac2 rec not_zero_all (l : constr) (here : (constr * constr) list) := match here with
  | [] => applied 'nonzero_none [l]
  | pair :: others =>
    let (x, h) := pair in
    applied 'nonzero_more
      [l; x; listed 'expr (List.map (fun p => let (x, _) := p in x) others); h; not_zero_all l others]
  end.
(* What is not `tried` first is computed by the kernel alone, and an error is told of at Qed. *)
Ltac2 computed_equal (tried : bool) :=
  lazy_match! goal with
  | [ |- @eq R ?a ?b ] =>
    let found := { known := []; atoms := []; count := 0; divides := false } in
    let read := reader found in
    let a' := read a in
    let b' := read b in
    let here := if found.(divides) then not_zero_here () else [] in
    let here := List.map (fun p => let (x, h) := p in (read x, h)) here in
    let factors := listed 'expr (List.map (fun p => let (x, _) := p in x) here) in
    let l := listed 'R (List.rev (found.(atoms))) in
    let claim := applied 'equal [factors; a'; b'] in
    let fits := if tried then Constr.equal (Std.eval_vm None claim) 'true else true in
    if fits then match Constr.Unsafe.kind '(eq_refl true <: true = true) with
      | Constr.Unsafe.Cast proof vm _ =>
        let shown := Constr.Unsafe.make (Constr.Unsafe.Cast proof vm (applied '(@eq) ['bool; claim; 'true])) in
        Std.exact_no_check (applied 'equal_is [l; factors; a'; b'; not_zero_all l here; shown])
      | _ => Control.zero (Tactic_failure None)
      end
    else Control.zero (Tactic_failure None)
  end.
Ltac reckon := ltac2:(computed_equal true).
Ltac identity := ltac2:(computed_equal false).
