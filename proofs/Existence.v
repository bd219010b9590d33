(* A solution that cannot leave a bounded set exists on the whole interval; and it is the only one. *)
Require Import Reals Lra Lia ZArith List Bool.
From Libration Require Import Sums Derivative Exit Picard Field Step Chain.
Import ListNotations.
Open Scope R_scope.

(* Two functions that meet at m. *)
Lemma glue y1 y2 d1 d2 a m b : a <= m <= b -> y1 m = y2 m -> d1 m = d2 m ->
  (forall t, a <= t <= m -> deriv_on a m y1 t (d1 t)) -> (forall t, m <= t <= b -> deriv_on m b y2 t (d2 t)) ->
  forall t, a <= t <= b ->
    deriv_on a b (fun x => if Rle_dec x m then y1 x else y2 x) t (if Rle_dec t m then d1 t else d2 t).
Proof.
  intros Hm Ey Ed H1 H2 t Ht e He.
  destruct (Rtotal_order t m) as [Hl | [-> | Hg]].
  - destruct (H1 t ltac:(lra) e He) as (d & Hd & H). exists (Rmin d (m - t)). split; [apply Rmin_pos; lra|].
    intros x Hx Hdx. split_min Hdx. apply Rabs_def2 in H3.
    destruct (Rle_dec x m); [|lra]. destruct (Rle_dec t m); [|lra]. apply H; auto; lra.
  - destruct (H1 m ltac:(lra) e He) as (d & Hd & H). destruct (H2 m ltac:(lra) e He) as (d' & Hd' & H').
    exists (Rmin d d'). split; [apply Rmin_pos; auto|]. intros x Hx Hdx. split_min Hdx.
    destruct (Rle_dec m m); [|lra]. destruct (Rle_dec x m); [apply H; auto; lra|].
    rewrite Ey, Ed. apply H'; auto; lra.
  - destruct (H2 t ltac:(lra) e He) as (d & Hd & H). exists (Rmin d (t - m)). split; [apply Rmin_pos; lra|].
    intros x Hx Hdx. split_min Hdx. apply Rabs_def2 in H3.
    destruct (Rle_dec x m); [lra|]. destruct (Rle_dec t m); [lra|]. apply H; auto; lra.
Qed.

(* Expressions of polynomials are polynomials; the time is the unknown number n. *)
Fixpoint poly_add (P Q : list R) : list R :=
  match P, Q with [], _ => Q | _, [] => P | a :: P', b :: Q' => (a + b) :: poly_add P' Q' end.
Fixpoint poly_mul (P Q : list R) : list R :=
  match P with [] => [] | a :: P' => poly_add (map (Rmult a) Q) (0 :: poly_mul P' Q) end.
Lemma poly_add_ok P : forall Q x, poly_value (poly_add P Q) x = poly_value P x + poly_value Q x.
Proof. induction P as [|a P IH]; intros [|b Q] x; simpl; rewrite ?IH; ring. Qed.
Lemma poly_scale_ok a Q x : poly_value (map (Rmult a) Q) x = a * poly_value Q x.
Proof. induction Q; simpl; [ring | rewrite IHQ; ring]. Qed.
Lemma poly_mul_ok P Q x : poly_value (poly_mul P Q) x = poly_value P x * poly_value Q x.
Proof. induction P as [|a P IH]; simpl; [ring|]. rewrite poly_add_ok, poly_scale_ok. simpl. rewrite IH. ring. Qed.

Section Existence.
Variables (n : nat) (Q : Z) (F : list expr).
Hypothesis HF : forall i, (i < n)%nat -> below n (right F i) = true.
Hypothesis HQ : 0 < IZR Q.

Fixpoint expr_poly (ps : nat -> list R) (e : expr) : list R :=
  match e with
  | Const k => [IZR k]
  | Time => ps n
  | Unknown i => ps i
  | Plus a b => poly_add (expr_poly ps a) (expr_poly ps b)
  | Times a b => poly_mul (expr_poly ps a) (expr_poly ps b)
  end.
Lemma expr_poly_ok ps e x : poly_value (expr_poly ps e) x = eval (poly_value (ps n) x) (fun j => poly_value (ps j) x) e.
Proof. induction e; simpl; rewrite ?poly_add_ok, ?poly_mul_ok, ?IHe1, ?IHe2; auto; ring. Qed.

(* The system with the time as one more unknown. *)
Definition extended (i : nat) (v : nat -> R) : R :=
  if Nat.eqb i n then 1 else / IZR Q * eval (v n) v (right F i).
Definition compose (ps : nat -> list R) (i : nat) : list R :=
  if Nat.eqb i n then [1] else map (Rmult (/ IZR Q)) (expr_poly ps (right F i)).
Lemma compose_ok ps i x : poly_value (compose ps i) x = extended i (fun j => poly_value (ps j) x).
Proof.
  unfold compose, extended. destruct Nat.eqb; [simpl; ring|]. rewrite poly_scale_ok, expr_poly_ok. reflexivity.
Qed.

Definition within (B : R) (v : nat -> R) : Prop := forall j, (j <= n)%nat -> Rabs (v j) <= B.
Definition regular (B M L : R) (g : (nat -> R) -> R) : Prop := 0 <= M /\ 0 <= L /\
  (forall v, within B v -> Rabs (g v) <= M) /\
  (forall v v' d, within B v -> within B v' -> 0 <= d -> (forall j, (j <= n)%nat -> Rabs (v j - v' j) <= d) ->
     Rabs (g v - g v') <= L * d).

Lemma regular_unknown B i : 0 <= B -> (i <= n)%nat -> regular B B 1 (fun v => v i).
Proof. intros HB Hi. repeat split; auto; try lra. intros. rewrite Rmult_1_l. auto. Qed.
Lemma regular_const B k : regular B (Rabs k) 0 (fun _ => k).
Proof.
  repeat split; try apply Rabs_pos; try lra; intros; [lra|].
  replace (k - k) with 0 by ring. rewrite Rabs_R0. lra.
Qed.
Lemma regular_plus B M L M' L' g g' : regular B M L g -> regular B M' L' g' ->
  regular B (M + M') (L + L') (fun v => g v + g' v).
Proof.
  intros (P1 & P2 & P3 & P4) (Q1 & Q2 & Q3 & Q4). repeat split; try lra.
  - intros v H. eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; auto.
  - intros v v' d H H' Hd Hv. replace (g v + g' v - (g v' + g' v')) with ((g v - g v') + (g' v - g' v')) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rmult_plus_distr_r. apply Rplus_le_compat; auto.
Qed.
Lemma regular_times B M L M' L' g g' : regular B M L g -> regular B M' L' g' ->
  regular B (M * M') (M * L' + M' * L) (fun v => g v * g' v).
Proof.
  intros (P1 & P2 & P3 & P4) (Q1 & Q2 & Q3 & Q4). repeat split.
  - apply Rmult_le_pos; auto.
  - assert (0 <= M * L') by (apply Rmult_le_pos; auto). assert (0 <= M' * L) by (apply Rmult_le_pos; auto). lra.
  - intros v H. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos.
  - intros v v' d H H' Hd Hv.
    replace (g v * g' v - g v' * g' v') with (g v * (g' v - g' v') + g' v' * (g v - g v')) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
    replace ((M * L' + M' * L) * d) with (M * (L' * d) + M' * (L * d)) by ring.
    apply Rplus_le_compat; apply Rmult_le_compat; auto using Rabs_pos.
Qed.
Lemma regular_expr B e : 0 <= B -> below n e = true -> exists M L, regular B M L (fun v => eval (v n) v e).
Proof.
  intros HB. induction e as [k | | i | a IHa b IHb | a IHa b IHb]; simpl; intros Hv.
  - exists (Rabs (IZR k)), 0. apply regular_const.
  - exists B, 1. apply regular_unknown; auto.
  - exists B, 1. apply Nat.ltb_lt in Hv. apply regular_unknown; auto. lia.
  - apply andb_prop in Hv as [Ha Hb]. destruct (IHa Ha) as (M & L & P). destruct (IHb Hb) as (M' & L' & P').
    exists (M + M'), (L + L'). apply (regular_plus B M L M' L' _ _ P P').
  - apply andb_prop in Hv as [Ha Hb]. destruct (IHa Ha) as (M & L & P). destruct (IHb Hb) as (M' & L' & P').
    exists (M * M'), (M * L' + M' * L). apply (regular_times B M L M' L' _ _ P P').
Qed.
Lemma regular_weaken B M L M' L' g : M <= M' -> L <= L' -> regular B M L g -> regular B M' L' g.
Proof.
  intros HM HL (P1 & P2 & P3 & P4). repeat split; try lra.
  - intros v H. specialize (P3 v H). lra.
  - intros v v' d H H' Hd Hv. specialize (P4 v v' d H H' Hd Hv). assert (L * d <= L' * d) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma regular_extended B : 0 <= B -> exists M L, forall i, (i <= n)%nat -> regular B M L (extended i).
Proof.
  intros HB.
  assert (One : forall i, (i <= n)%nat -> exists M L, regular B M L (extended i)).
  { intros i Hi. unfold extended. destruct (Nat.eqb_spec i n) as [-> | Hne].
    - exists (Rabs 1), 0. apply (regular_const B 1).
    - destruct (regular_expr B (right F i) HB (HF i ltac:(lia))) as (M & L & P).
      exists (Rabs (/ IZR Q) * M), (Rabs (/ IZR Q) * L + M * 0).
      apply (regular_times B _ _ _ _ (fun _ => / IZR Q) _ (regular_const B (/ IZR Q)) P). }
  assert (Some_ : forall k, (k <= S n)%nat -> exists M L, forall i, (i < k)%nat -> regular B M L (extended i)).
  { induction k as [|k IH]; intros Hk; [exists 0, 0; intros; lia|].
    destruct IH as (M & L & P); [lia|]. destruct (One k) as (M' & L' & P'); [lia|].
    exists (Rmax M M'), (Rmax L L'). intros i Hi. destruct (Nat.eq_dec i k) as [-> |].
    - apply regular_weaken with M' L'; auto using Rmax_r.
    - apply regular_weaken with M L; auto using Rmax_l. apply P; lia. }
  destruct (Some_ (S n) (le_n _)) as (M & L & P). exists M, L. intros i Hi. apply P; lia.
Qed.

(* A solution from a state within B exists for a time that depends on B alone. *)
Lemma local_solution B : 0 <= B -> exists eta, 0 < eta /\ forall a v, Rabs a <= B -> (forall i, (i < n)%nat -> Rabs (v i) <= B) ->
  exists y, solution n Q F a (a + eta) y /\ forall i, (i < n)%nat -> y i a = v i.
Proof.
  intros HB. destruct (regular_extended (B + 1) ltac:(lra)) as (M & L & HR).
  assert (HM : 0 <= M) by apply (HR 0%nat ltac:(lia)). assert (HL : 0 <= L) by apply (HR 0%nat ltac:(lia)).
  set (eta := Rmin (1 / (M + 1)) (1 / (2 * (L + 1)))).
  assert (He : 0 < eta) by (apply Rmin_pos; apply Rdiv_lt_0_compat; lra).
  assert (HMe : M * eta <= 1).
  { apply Rle_trans with (M * (1 / (M + 1))); [apply Rmult_le_compat_l; [auto | apply Rmin_l]|].
    apply Rmult_le_reg_r with (M + 1); [lra|]. field_simplify; lra. }
  assert (HLe : L * eta <= 1 / 2).
  { apply Rle_trans with (L * (1 / (2 * (L + 1)))); [apply Rmult_le_compat_l; [auto | apply Rmin_r]|].
    apply Rmult_le_reg_r with (L + 1); [lra|]. field_simplify; lra. }
  exists eta. split; auto. intros a v Ha Hv.
  set (c := fun j => if Nat.eqb j n then a else v j).
  assert (Hc : forall j, (j < S n)%nat -> Rabs (c j) <= B).
  { intros j Hj. unfold c. destruct (Nat.eqb_spec j n); auto. apply Hv; lia. }
  assert (Hbox : forall w, box (S n) c 1 w -> within (B + 1) w).
  { intros w Hw j Hj. replace (w j) with (c j + (w j - c j)) by ring. eapply Rle_trans; [apply Rabs_triang|].
    specialize (Hw j ltac:(lia)). specialize (Hc j ltac:(lia)). lra. }
  assert (HMf : forall w i, (i < S n)%nat -> box (S n) c 1 w -> Rabs (extended i w) <= M).
  { intros w i Hi Hw. apply (HR i ltac:(lia)); auto. }
  assert (HLf : forall w w' e i, (i < S n)%nat -> box (S n) c 1 w -> box (S n) c 1 w' -> 0 <= e ->
    (forall j, (j < S n)%nat -> Rabs (w j - w' j) <= e) -> Rabs (extended i w - extended i w') <= L * e).
  { intros w w' e i Hi Hw Hw' He0 Hd. apply (HR i ltac:(lia)); auto. intros; apply Hd; lia. }
  destruct (local_existence (S n) extended c M L 1 eta compose compose_ok HMf HLf HM HL Rlt_0_1 He HMe HLe) as [E1 E2].
  set (Y := picard (S n) extended c M L 1 eta compose compose_ok HMf HLf HM HL Rlt_0_1 He HMe HLe) in *.
  assert (Clock : forall x, 0 <= x <= eta -> Y n x = a + x).
  { intros x Hx. assert (K := constant_of_deriv_zero 0 eta (fun x => Y n x - x)).
    assert (E0 : Y n 0 = a) by (rewrite E2; unfold c; rewrite Nat.eqb_refl; reflexivity).
    specialize (K ltac:(intros t Ht; apply deriv_eq with (1 - 1); [ring|]; apply deriv_minus; [|apply deriv_id];
      assert (D := E1 n t ltac:(lia) Ht); unfold extended in D; rewrite Nat.eqb_refl in D; exact D) x Hx). lra. }
  exists (fun i t => Y i (- a + 1 * t)). split.
  - intros i t Hi Ht.
    apply deriv_eq with (1 * extended i (fun j => Y j (- a + 1 * t))).
    + unfold extended. replace (Nat.eqb i n) with false by (symmetry; apply Nat.eqb_neq; lia).
      rewrite Clock by lra. replace (a + (- a + 1 * t)) with t by ring. field. lra.
    + apply deriv_affine with (g := Y i) (c := - a) (k := 1); [lra|].
      apply deriv_sub_interval with 0 eta; try lra. apply E1; [lia | lra].
  - intros i Hi. replace (- a + 1 * a) with 0 by ring. rewrite E2. unfold c.
    replace (Nat.eqb i n) with false; auto. symmetry; apply Nat.eqb_neq; lia.
Qed.

(* If every solution on a part [a, e] of [a, b] is bounded by B, there is one on [a, b]. *)
Theorem existence a b v B : a <= b -> 0 <= B ->
  (forall e y, a <= e <= b -> solution n Q F a e y -> (forall i, (i < n)%nat -> y i a = v i) ->
     forall i, (i < n)%nat -> Rabs (y i e) <= B) ->
  exists y, solution n Q F a b y /\ forall i, (i < n)%nat -> y i a = v i.
Proof.
  intros Hab HB Bound. set (B' := Rmax B (Rmax (Rabs a) (Rabs b))).
  assert (BB : B <= B') by apply Rmax_l.
  assert (Bt : forall t, a <= t <= b -> Rabs t <= B').
  { intros t Ht. assert (A1 : Rmax (Rabs a) (Rabs b) <= B') by apply Rmax_r.
    assert (A2 := Rmax_l (Rabs a) (Rabs b)). assert (A3 := Rmax_r (Rabs a) (Rabs b)).
    assert (A4 := Rle_abs b). assert (A5 := Rle_abs (- a)). rewrite Rabs_Ropp in A5. apply Rabs_le. lra. }
  destruct (local_solution B' ltac:(lra)) as (eta & He & Local).
  assert (Claim : forall k, exists y, solution n Q F a (Rmin (a + INR k * eta) b) y /\ forall i, (i < n)%nat -> y i a = v i).
  { induction k as [|k (y1 & Hs1 & Hi1)].
    - exists (fun j _ => v j). split; auto. intros i t Hi Ht e Hee. simpl in Ht.
      assert (Rmin (a + 0 * eta) b <= a + 0 * eta) by apply Rmin_l.
      exists 1. split; [lra|]. intros x Hx _. simpl in Hx. replace x with t by lra.
      match goal with |- Rabs ?g <= _ => replace g with 0 by ring end. rewrite Rabs_R0.
      apply Rmult_le_pos; [lra | apply Rabs_pos].
    - set (m := Rmin (a + INR k * eta) b) in *. set (m' := Rmin (a + INR (S k) * eta) b).
      assert (Kp : 0 <= INR k * eta) by (apply Rmult_le_pos; [apply pos_INR | lra]).
      assert (B1 : a <= m) by (unfold m; apply Rmin_glb; lra). assert (B2 : m <= b) by apply Rmin_r.
      assert (B3 : m <= m' /\ m' <= m + eta).
      { unfold m, m'. rewrite S_INR. unfold Rmin. repeat destruct Rle_dec; lra. }
      destruct (Local m (fun i => y1 i m)) as (y2 & Hs2 & Hi2); [apply Bt; lra | |].
      { intros i Hi. apply (Rle_trans _ B); [apply (Bound m y1); auto | exact BB]. }
      assert (Ej : forall j, (j < n)%nat -> y1 j m = y2 j m) by (intros; rewrite Hi2; auto).
      exists (fun j t => if Rle_dec t m then y1 j t else y2 j t). split.
      + intros i t Hi Ht.
        assert (G := glue (y1 i) (y2 i) (fun t => eval t (fun j => y1 j t) (right F i) / IZR Q)
          (fun t => eval t (fun j => y2 j t) (right F i) / IZR Q) a m m' ltac:(lra) (Ej i Hi)).
        assert (Ed : eval m (fun j => y1 j m) (right F i) / IZR Q = eval m (fun j => y2 j m) (right F i) / IZR Q)
          by (f_equal; apply eval_ext with n; auto).
        specialize (G Ed (fun t Ht => Hs1 i t Hi Ht)).
        specialize (G (fun t Ht => deriv_sub_interval m (m + eta) m m' (y2 i) t _ (Rle_refl m) (proj2 B3)
          (Hs2 i t Hi ltac:(lra))) t Ht).
        eapply deriv_eq; [|exact G]. destruct (Rle_dec t m); reflexivity.
      + intros i Hi. destruct (Rle_dec a m); [auto | lra]. }
  destruct (archimed ((b - a) / eta)) as [A1 _].
  assert (Hr : 0 <= (b - a) / eta) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; auto]).
  destruct (Claim (Z.to_nat (up ((b - a) / eta)))) as (y & Hs & Hi). exists y. split; auto.
  rewrite Rmin_right in Hs; auto.
  rewrite INR_IZR_INZ, Z2Nat.id by (apply le_IZR; lra).
  apply Rmult_gt_compat_r with (r := eta) in A1; auto.
  replace ((b - a) / eta * eta) with (b - a) in A1 by (field; lra). lra.
Qed.

(* Two solutions that begin together stay together, while both are bounded. *)
Theorem uniqueness a b B y1 y2 : a <= b -> solution n Q F a b y1 -> solution n Q F a b y2 ->
  (forall i t, (i < n)%nat -> a <= t <= b -> Rabs (y1 i t) <= B /\ Rabs (y2 i t) <= B) ->
  (forall i, (i < n)%nat -> y1 i a = y2 i a) ->
  forall i t, (i < n)%nat -> a <= t <= b -> y1 i t = y2 i t.
Proof.
  intros Hab H1 H2 HB H0.
  set (B' := Rmax (Rabs B) (Rmax (Rabs a) (Rabs b))).
  assert (BB : Rabs B <= B') by apply Rmax_l. assert (P0 := Rabs_pos B).
  assert (Bt : forall t, a <= t <= b -> Rabs t <= B').
  { intros t Ht. assert (A1 : Rmax (Rabs a) (Rabs b) <= B') by apply Rmax_r.
    assert (A2 := Rmax_l (Rabs a) (Rabs b)). assert (A3 := Rmax_r (Rabs a) (Rabs b)).
    assert (A4 := Rle_abs b). assert (A5 := Rle_abs (- a)). rewrite Rabs_Ropp in A5. apply Rabs_le. lra. }
  destruct (regular_extended B' ltac:(lra)) as (M & L & HR).
  assert (HL : 0 <= L) by apply (HR 0%nat ltac:(lia)).
  set (q := fun i t => (y1 i t - y2 i t) * (y1 i t - y2 i t)).
  set (d := fun i t => eval t (fun j => y1 j t) (right F i) / IZR Q - eval t (fun j => y2 j t) (right F i) / IZR Q).
  assert (Lip : forall t x, a <= t <= b -> 0 <= x -> (forall j, (j < n)%nat -> Rabs (y1 j t - y2 j t) <= x) ->
    forall i, (i < n)%nat -> Rabs (d i t) <= L * x).
  { intros t x Ht Hx Hd i Hi.
    set (e1 := fun j => if Nat.eqb j n then t else y1 j t). set (e2 := fun j => if Nat.eqb j n then t else y2 j t).
    assert (W : forall y, (forall j, (j < n)%nat -> Rabs (y j t) <= B) -> within B' (fun j => if Nat.eqb j n then t else y j t)).
    { intros y Hy j Hj. destruct (Nat.eqb_spec j n); [apply Bt; auto|].
      assert (Rabs (y j t) <= B) by (apply Hy; lia). assert (E := Rle_abs B). lra. }
    assert (E : forall y, extended i (fun j => if Nat.eqb j n then t else y j t) = eval t (fun j => y j t) (right F i) / IZR Q).
    { intros y. unfold extended. replace (Nat.eqb i n) with false by (symmetry; apply Nat.eqb_neq; lia).
      rewrite Nat.eqb_refl, Rmult_comm. unfold Rdiv. f_equal. apply eval_ext with n; auto. intros j Hj.
      replace (Nat.eqb j n) with false; auto. symmetry; apply Nat.eqb_neq; lia. }
    unfold d. rewrite <- !E. apply (HR i ltac:(lia)); auto.
    - apply W. intros; apply HB; auto.
    - apply W. intros; apply HB; auto.
    - intros j Hj. destruct (Nat.eqb_spec j n); [replace (t - t) with 0 by ring; rewrite Rabs_R0; auto | apply Hd; lia]. }
  assert (Zero : forall t, a <= t <= b -> forall i, (i < n)%nat -> q i t <= 0 * 0).
  { (* all unknowns together are one block: its square is the sum of squares, its rate n L *)
    set (qq := fun (_ : nat) t => Sum n (fun i => q i t)).
    assert (Tube := tube_of_growth 1 qq (fun _ t => Sum n (fun i => d i t * (y1 i t - y2 i t) + (y1 i t - y2 i t) * d i t))
      (fun _ _ => 0) (fun _ _ => 0) (fun _ _ => INR n * L) (fun _ => 0) b 1 Rlt_0_1 (INR n * L + 1)).
    assert (NL : 0 <= INR n * L) by (apply Rmult_le_pos; [apply pos_INR | auto]).
    intros t Ht i Hi. apply Rle_trans with (qq 0%nat t).
    { apply (Sum_term_le n i (fun i => q i t)); auto. intros; apply Rle_0_sqr. }
    apply Tube with (s := a) (t := t); auto; try lra.
    - intros c Hc. simpl. rewrite Rabs_pos_eq; lra.
    - intros z r Hz Hr c Hc Hq0. replace c with 0%nat in * by lia. destruct (Hr 0%nat ltac:(lia)) as [R0 _].
      set (rr := r 0%nat) in *.
      assert (Dj : forall j, (j < n)%nat -> Rabs (y1 j z - y2 j z) <= rr).
      { intros j Hj. apply Blocks.abs_le_of_square; [lra|]. rewrite <- Hq0.
        apply (Sum_term_le n j (fun i => q i z)); auto. intros; apply Rle_0_sqr. }
      apply Rle_trans with (Sum n (fun _ => 2 * (L * rr * rr))).
      + apply Sum_le. intros j Hj. assert (Lj := Lip z rr ltac:(lra) ltac:(lra) Dj j Hj).
        assert (P : Rabs (d j z * (y1 j z - y2 j z)) <= L * rr * rr)
          by (rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos).
        assert (P' := Rle_abs (d j z * (y1 j z - y2 j z))). lra.
      + assert (Sc : forall k x, Sum k (fun _ => x) = INR k * x).
        { induction k as [|k IH]; intros x; [simpl; ring|]. cbn [Sum]. rewrite IH, S_INR. ring. }
        rewrite Sc. right. cbn [Sum]. fold rr. ring.
    - intros z Hz c Hc. simpl. lra.
    - intros c z Hc Hz. apply deriv_Sum. intros j Hj.
      assert (Dd : deriv_on a b (fun t => y1 j t - y2 j t) z (d j z)) by (apply deriv_minus; [apply H1 | apply H2]; auto).
      exact (deriv_mult a b _ _ z _ _ Dd Dd).
    - intros; apply deriv_const.
    - intros c Hc. unfold qq. rewrite Sum_zero; [lra|]. intros j Hj. unfold q. rewrite (H0 j Hj). ring.
    - intros; lra. }
  intros i t Hi Ht. specialize (Zero t Ht i Hi). rewrite Rmult_0_l in Zero. unfold q in Zero.
  assert (N := Rle_0_sqr (y1 i t - y2 i t)). unfold Rsqr in N.
  assert (E : (y1 i t - y2 i t) * (y1 i t - y2 i t) = 0) by lra. apply Rmult_integral in E. lra.
Qed.
End Existence.
