(* sin, cos and exp of solutions: their equations, which determine them, and their values at fractions from certificates. *)
Require Import Reals Lra Lia ZArith List.
From Libration Require Import Sums Derivative Exit Field Step Chain Certificate.
Import ListNotations.
Open Scope R_scope.

(* The derivative of an expression of functions with the derivatives d. *)
Fixpoint slope (t : R) (y d : nat -> R) (e : expr) : R :=
  match e with
  | Const _ => 0
  | Time => 1
  | Unknown i => d i
  | Plus a b => slope t y d a + slope t y d b
  | Times a b => slope t y d a * eval t y b + eval t y a * slope t y d b
  end.
Lemma eval_deriv n a b y d t e : below n e = true -> (forall i, (i < n)%nat -> deriv_on a b (y i) t (d i)) ->
  deriv_on a b (fun s => eval s (fun j => y j s) e) t (slope t (fun j => y j t) d e).
Proof.
  intros He Hy. induction e as [k | | i | e1 IH1 e2 IH2 | e1 IH1 e2 IH2]; simpl in *.
  - apply deriv_const.
  - apply deriv_id.
  - apply Hy. apply Nat.ltb_lt; auto.
  - apply Bool.andb_true_iff in He as [H1 H2]. apply deriv_plus; auto.
  - apply Bool.andb_true_iff in He as [H1 H2]. apply (deriv_mult a b (fun s => eval s (fun j => y j s) e1)); auto.
Qed.

Lemma deriv_sin a b u t l : deriv_on a b u t l -> deriv_on a b (fun s => sin (u s)) t (cos (u t) * l).
Proof. intros H. apply deriv_chain; [exact H | apply derivable_pt_lim_sin]. Qed.
Lemma deriv_cos a b u t l : deriv_on a b u t l -> deriv_on a b (fun s => cos (u s)) t (- sin (u t) * l).
Proof. intros H. apply deriv_chain; [exact H | apply derivable_pt_lim_cos]. Qed.
Lemma deriv_exp a b u t l : deriv_on a b u t l -> deriv_on a b (fun s => exp (u s)) t (exp (u t) * l).
Proof. intros H. apply deriv_chain; [exact H | apply derivable_pt_lim_exp]. Qed.

(* The equations of added unknowns have these functions as their only solutions. *)
Lemma sin_cos_unique a b u du s c : a <= b -> (forall t, a <= t <= b -> deriv_on a b u t (du t)) ->
  (forall t, a <= t <= b -> deriv_on a b s t (c t * du t)) -> (forall t, a <= t <= b -> deriv_on a b c t (- s t * du t)) ->
  s a = sin (u a) -> c a = cos (u a) -> forall t, a <= t <= b -> s t = sin (u t) /\ c t = cos (u t).
Proof.
  intros Hab Hu Hs Hc S0 C0 t Ht.
  set (p := fun t => s t - sin (u t)). set (q := fun t => c t - cos (u t)).
  assert (K := constant_of_deriv_zero a b (fun t => p t * p t + q t * q t)). cbv beta in K.
  assert (Zero : p t * p t + q t * q t = 0).
  { rewrite (fun H => K H t Ht); [unfold p, q; rewrite S0, C0; ring|]. intros z Hz.
    assert (P : deriv_on a b p z (c z * du z - cos (u z) * du z)) by (apply deriv_minus; auto using deriv_sin).
    assert (Q : deriv_on a b q z (- s z * du z - - sin (u z) * du z)) by (apply deriv_minus; auto using deriv_cos).
    eapply deriv_eq; [|apply deriv_plus; [exact (deriv_mult a b p p z _ _ P P) | exact (deriv_mult a b q q z _ _ Q Q)]].
    unfold p, q. ring. }
  assert (A := Rle_0_sqr (p t)). assert (B := Rle_0_sqr (q t)). unfold Rsqr in A, B.
  assert (Ep : p t * p t = 0) by lra. assert (Eq : q t * q t = 0) by lra.
  apply Rmult_integral in Ep, Eq. unfold p, q in Ep, Eq. lra.
Qed.

(* The same, with u found from its derivative. *)
Lemma sin_cos_at a b {u du} (Hu : forall t, a <= t <= b -> deriv_on a b u t (du t)) s c : a <= b ->
  (forall t, a <= t <= b -> deriv_on a b s t (c t * du t)) -> (forall t, a <= t <= b -> deriv_on a b c t (- s t * du t)) ->
  s a = sin (u a) -> c a = cos (u a) -> forall t, a <= t <= b -> s t = sin (u t) /\ c t = cos (u t).
Proof. intros Hab. exact (sin_cos_unique a b u du s c Hab Hu). Qed.

Lemma exp_unique a b u du w : a <= b -> (forall t, a <= t <= b -> deriv_on a b u t (du t)) ->
  (forall t, a <= t <= b -> deriv_on a b w t (w t * du t)) -> w a = exp (u a) -> forall t, a <= t <= b -> w t = exp (u t).
Proof.
  intros Hab Hu Hw W0 t Ht.
  assert (K := constant_of_deriv_zero a b (fun t => w t * exp (-1 * u t))). cbv beta in K.
  assert (One : w t * exp (-1 * u t) = 1).
  { rewrite (fun H => K H t Ht).
    - rewrite W0, <- exp_plus. replace (u a + -1 * u a) with 0 by ring. apply exp_0.
    - intros z Hz. assert (N : deriv_on a b (fun s => -1 * u s) z (-1 * du z)) by (apply deriv_scal; auto).
      eapply deriv_eq; [|exact (deriv_mult a b w (fun s => exp (-1 * u s)) z _ _ (Hw z Hz) (deriv_exp a b _ z _ N))]. cbv beta. ring. }
  apply Rmult_eq_reg_r with (exp (-1 * u t)); [|assert (P := exp_pos (-1 * u t)); lra].
  rewrite One, <- exp_plus. replace (u t + -1 * u t) with 0 by ring. symmetry; apply exp_0.
Qed.

(* Values at fractions: certificates of s' = c, c' = -s and of w' = w or w' = -w from 0. *)
Definition circle : list expr := [Unknown 1; Times (Const (-1)) (Unknown 0)].
Lemma circle_values c k : certificate_ok c = true -> rights c = circle -> time_unit c = 1%Z -> begin_time c = (0%Z, 1%Z) ->
  box c = [exactly 0 1; exactly 1 1] -> In k (all_claims (items c)) ->
  claim_holds k (functions [sin; cos] (index k) (claim_time k)).
Proof.
  intros Hok Hr Hu Hb Hbox Hk. assert (V := certified_values c Hok (functions [sin; cos])).
  assert (En : unknowns c = 2%nat) by (unfold unknowns; rewrite Hr; reflexivity).
  apply V; auto.
  - intros i t Hi Ht. rewrite En in Hi. rewrite Hr, Hu.
    destruct i as [|[|i]]; [| | exfalso; lia]; unfold right, functions; simpl.
    + eapply deriv_eq; [|apply deriv_of_lim, derivable_pt_lim_sin]. field.
    + eapply deriv_eq; [|apply deriv_of_lim, derivable_pt_lim_cos]. field.
  - intros i Hi. rewrite En in Hi. rewrite Hb. unfold initial_get. rewrite Hbox.
    replace (quotient (0, 1)%Z) with 0 by (unfold quotient; simpl; field).
    destruct i as [|[|i]]; [| | exfalso; lia]; unfold in_interval, functions; simpl; rewrite ?sin_0, ?cos_0; lra.
Qed.

Lemma exponential_values c k s : s = 1%Z \/ s = (-1)%Z -> certificate_ok c = true ->
  rights c = [Times (Const s) (Unknown 0)] -> time_unit c = 1%Z -> begin_time c = (0%Z, 1%Z) ->
  box c = [exactly 1 1] -> In k (all_claims (items c)) -> index k = 0%nat ->
  claim_holds k (exp (IZR s * claim_time k)).
Proof.
  intros Hs Hok Hr Hu Hb Hbox Hk Hindex. assert (V := certified_values c Hok (functions [fun t => exp (IZR s * t)])).
  assert (En : unknowns c = 1%nat) by (unfold unknowns; rewrite Hr; reflexivity).
  assert (R : claim_holds k (functions [fun t => exp (IZR s * t)] (index k) (claim_time k))).
  { apply V; auto.
    - intros i t Hi Ht. rewrite En in Hi. rewrite Hr, Hu.
      destruct i as [|i]; [| exfalso; lia]; unfold right, functions; simpl.
      eapply deriv_eq; [|apply deriv_exp; apply (deriv_scal _ _ (fun t => t)), deriv_id]. field.
    - intros i Hi. rewrite En in Hi. rewrite Hb. unfold initial_get. rewrite Hbox.
      replace (quotient (0, 1)%Z) with 0 by (unfold quotient; simpl; field).
      destruct i as [|i]; [| exfalso; lia]; unfold in_interval, functions; simpl. rewrite Rmult_0_r, exp_0. lra. }
  rewrite Hindex in R. exact R.
Qed.
