(* Right-hand sides of equations: expressions in the time and the unknowns with integer constants; their linear part along a
   curve, with bounds of its change; and what the existence of solutions needs of them. *)
Require Import Reals Lra Lia ZArith List Bool.
From Libration Require Import Sums Derivative Dyadic Chebyshev Polynomial.
Import ListNotations.
Open Scope R_scope.

Inductive expr :=
  | Const (k : Z) | Time | Unknown (i : nat) | Plus (a b : expr) | Times (a b : expr).

Fixpoint eval (t : R) (y : nat -> R) (e : expr) : R :=
  match e with
  | Const k => IZR k
  | Time => t
  | Unknown i => y i
  | Plus a b => eval t y a + eval t y b
  | Times a b => eval t y a * eval t y b
  end.
Fixpoint below (n : nat) (e : expr) : bool :=
  match e with Const _ | Time => true | Unknown i => Nat.ltb i n | Plus a b | Times a b => below n a && below n b end.

Lemma eval_ext n t y z e : below n e = true -> (forall j, (j < n)%nat -> y j = z j) -> eval t y e = eval t z e.
Proof.
  induction e; simpl; intros Hb H; auto.
  - apply H. apply Nat.ltb_lt; auto.
  - apply andb_prop in Hb as [H1 H2]. rewrite IHe1, IHe2; auto.
  - apply andb_prop in Hb as [H1 H2]. rewrite IHe1, IHe2; auto.
Qed.

(* e(p + w) = value + sum over j of (linear_j + E_j) w_j with |E_j| <= change_j, while |w_j| <= rho_j *)
Record model := Model { value : poly; linear : list poly; change : list num }.
Section Models.
Variables (n : nat) (time : poly) (p : list poly) (rho : list num).

(* a bound of sum over j of (linear_j + E_j) w_j *)
Definition spread (A : model) : num :=
  up (nsum n (fun j => mul (add (pnorm (pget (linear A) j)) (vget (change A) j)) (vget rho j))).

Fixpoint model_of (e : expr) : model :=
  match e with
  | Const k => Model (pconst (num_of_Z k)) [] []
  | Time => Model time [] []
  | Unknown i => Model (pget p i) (table n (fun j => if Nat.eqb j i then pconst one else pzero)) []
  | Plus a b => let A := model_of a in let B := model_of b in
      Model (padd (value A) (value B)) (table n (fun j => padd (pget (linear A) j) (pget (linear B) j)))
        (table n (fun j => add (vget (change A) j) (vget (change B) j)))
  | Times a b => let A := model_of a in let B := model_of b in
      let s := spread B in let va := pnorm (value A) in let vb := pnorm (value B) in
      Model (pmul (value A) (value B))
        (table n (fun j => padd (pmul (value A) (pget (linear B) j)) (pmul (value B) (pget (linear A) j))))
        (table n (fun j => up (add (add (mul va (vget (change B) j)) (mul vb (vget (change A) j)))
                                   (mul (add (pnorm (pget (linear A) j)) (vget (change A) j)) s))))
  end.

Variables (x : R) (w : nat -> R).
Hypothesis Hx : -1 <= x <= 1.
Hypothesis Hw : forall j, (j < n)%nat -> Rabs (w j) <= real (vget rho j).

Definition models (A : model) (f : R) : Prop := exists E : nat -> R,
  (forall j, (j < n)%nat -> Rabs (E j) <= real (vget (change A) j)) /\
  f = peval (value A) x + Sum n (fun j => (peval (pget (linear A) j) x + E j) * w j).

Lemma pget_nil j : pget [] j = pzero. Proof. destruct j; reflexivity. Qed.
Lemma vget_nil j : vget [] j = zero. Proof. destruct j; reflexivity. Qed.

Lemma spread_ok A E : (forall j, (j < n)%nat -> Rabs (E j) <= real (vget (change A) j)) ->
  Rabs (Sum n (fun j => (peval (pget (linear A) j) x + E j) * w j)) <= real (spread A).
Proof.
  intros HE. unfold spread. eapply Rle_trans; [|apply up_ok]. rewrite real_sum.
  rewrite (Sum_ext n (fun i => real (mul _ _)) (fun j => (real (pnorm (pget (linear A) j)) + real (vget (change A) j)) * real (vget rho j)))
    by (intros; rewrite real_mul, real_add; reflexivity).
  apply Sum_abs_mul; auto. intros j Hj. eapply Rle_trans; [apply Rabs_triang|].
  apply Rplus_le_compat; auto. apply pnorm_ok; auto.
Qed.

Lemma models_constant P f : f = peval P x -> models (Model P [] []) f.
Proof.
  intros ->. exists (fun _ => 0). split; simpl.
  - intros j _. rewrite vget_nil, real_zero, Rabs_R0. lra.
  - rewrite Sum_zero; [ring|]. intros j _. rewrite pget_nil, peval_zero. ring.
Qed.

Lemma models_plus a b f g : models (model_of a) f -> models (model_of b) g -> models (model_of (Plus a b)) (f + g).
Proof.
  intros (Ea & Ha & ->) (Eb & Hb & ->). exists (fun j => Ea j + Eb j). simpl. split.
  - intros j Hj. rewrite vget_table, real_add by auto. eapply Rle_trans; [apply Rabs_triang|].
    apply Rplus_le_compat; auto.
  - rewrite peval_add.
    rewrite (Sum_ext n (fun j => (peval (pget (table n _) j) x + (Ea j + Eb j)) * w j)
      (fun j => (peval (pget (linear (model_of a)) j) x + Ea j) * w j + (peval (pget (linear (model_of b)) j) x + Eb j) * w j)).
    + rewrite Sum_plus. ring.
    + intros j Hj. rewrite pget_table, peval_add by auto. ring.
Qed.

Lemma models_times a b f g : models (model_of a) f -> models (model_of b) g -> models (model_of (Times a b)) (f * g).
Proof.
  intros (Ea & Ha & ->) (Eb & Hb & ->). simpl. set (A := model_of a) in *. set (B := model_of b) in *.
  set (sb := Sum n (fun j => (peval (pget (linear B) j) x + Eb j) * w j)).
  assert (Hsb : Rabs sb <= real (spread B)) by (apply spread_ok; auto).
  exists (fun j => peval (value A) x * Eb j + peval (value B) x * Ea j + (peval (pget (linear A) j) x + Ea j) * sb). simpl. split.
  - intros j Hj. rewrite vget_table by auto. eapply Rle_trans; [|apply up_ok].
    rewrite !real_add, !real_mul, real_add.
    assert (P : forall u v c d, Rabs u <= c -> Rabs v <= d -> Rabs (u * v) <= c * d)
      by (intros; rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos).
    eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat.
    + eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; apply P; auto using pnorm_ok.
    + apply P; auto. eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; auto using pnorm_ok.
  - rewrite peval_mul.
    rewrite (Sum_ext n (fun j => (peval (pget (table n _) j) x + _) * w j)
      (fun j => peval (value A) x * ((peval (pget (linear B) j) x + Eb j) * w j)
        + peval (value B) x * ((peval (pget (linear A) j) x + Ea j) * w j)
        + (peval (pget (linear A) j) x + Ea j) * w j * sb)).
    + rewrite !Sum_plus, !Sum_scal, Sum_scal_r. fold sb. ring.
    + intros j Hj. rewrite pget_table by auto. cbv beta. rewrite peval_add, !peval_mul. ring.
Qed.

Lemma model_ok e : below n e = true ->
  models (model_of e) (eval (peval time x) (fun j => peval (pget p j) x + w j) e).
Proof.
  induction e as [k | | i | a IHa b IHb | a IHa b IHb]; intros Hb.
  - apply models_constant. rewrite peval_const, real_num_of_Z. reflexivity.
  - apply models_constant. reflexivity.
  - apply Nat.ltb_lt in Hb. exists (fun _ => 0). simpl. split.
    + intros j _. rewrite vget_nil, real_zero, Rabs_R0. lra.
    + f_equal. rewrite <- (Sum_delta n i w Hb). apply Sum_ext. intros j Hj.
      rewrite pget_table by auto. unfold delta. rewrite (Nat.eqb_sym i j).
      destruct (Nat.eqb j i); [rewrite peval_const, real_one | rewrite peval_zero]; ring.
  - apply andb_prop in Hb as [H1 H2]. apply models_plus; auto.
  - apply andb_prop in Hb as [H1 H2]. apply models_times; auto.
Qed.
Lemma model_value e : below n e = true -> peval (value (model_of e)) x = eval (peval time x) (fun j => peval (pget p j) x) e.
Proof.
  induction e as [k | | i | a IHa b IHb | a IHa b IHb]; simpl; intros Hb; auto.
  - rewrite peval_const, real_num_of_Z. reflexivity.
  - apply andb_prop in Hb as [H1 H2]. rewrite peval_add, IHa, IHb; auto.
  - apply andb_prop in Hb as [H1 H2]. rewrite peval_mul, IHa, IHb; auto.
Qed.
End Models.
