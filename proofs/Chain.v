(* Steps one after the other: joints, values at times, and bounds of the solution. *)
Require Import Reals Lra Lia ZArith List Bool.
From Bignums Require Import BigZ.
From Libration Require Import Sums Matrices Derivative Exit Blocks TheoremK Dyadic Chebyshev Polynomial Norms Field Step StepProof.
Import ListNotations.
Open Scope R_scope.

Lemma real_minus_one : real minus_one = -1.
Proof. unfold minus_one. rewrite real_opp, real_one. ring. Qed.

(* A state in a set is in the tube of the next step. *)
Lemma joint_sound n Q F s old (v : nat -> R) :
  let z := deviation n s in let q := row_sum n z in let r := up (inverse_candidate (sub one q)) in
  let N := inverse_bound n z r in
  shape_ok n Q F s = true -> frame_ok q r = true -> joint_ok n s N old = true ->
  in_states n old v -> in_step n s (-1) v.
Proof.
  intros z q r N Hs Hf Hj (c & Hc & Hsq).
  set (U := fun i j => peval (pmget (coframe s) i j) (-1)). set (V := fun i j => peval (pmget (frame s) i j) (-1)).
  assert (Hone : -1 <= -1 <= 1) by lra.
  assert (Zok := fun i j => z_ok n s (-1) i j Hone). destruct (q_ok n s Hf) as [Q1 Q2].
  destruct (inverse n (prod n U V) (near_one_injective n (prod n U V) _ _ _ Zok (z_rows n s) Q1 Q2)) as (X & SX & XS).
  assert (Xb : forall i j, (i < n)%nat -> (j < n)%nat -> Rabs (X i j) <= real (mget N i j)).
  { intros i j Hi Hj'. eapply Rle_trans; [|apply N_ok; auto].
    replace (X i j) with (delta i j + (X i j - delta i j)) by ring. eapply Rle_trans; [apply Rabs_triang|].
    apply Rplus_le_compat; [unfold delta; destruct Nat.eqb; rewrite ?Rabs_R1, ?Rabs_R0; lra|].
    apply (near_one_inverse n (prod n U V) _ _ _ Zok (z_rows n s) Q1 Q2); auto. }
  assert (VW : is_one n (prod n V (prod n X U))).
  { apply left_inverse_right. intros i j Hi Hj'. rewrite prod_assoc. apply XS; auto. }
  unfold joint_ok in Hj. cbv zeta in Hj. rewrite !andb_true_iff in Hj. destruct Hj as [[Hb Hz] Hj].
  set (gap := fun i => real (vget (centre old) i) - peval (pget (curve s) i) (-1)).
  set (axis := fun i j => real (mget (axes old) i j)).
  set (cn := apply n (prod n X U) (fun i => v i - peval (pget (curve s) i) (-1))).
  exists cn. split.
  { intros i Hi. change (Sum n (fun j => peval (pmget (frame s) i j) (-1) * cn j)) with (apply n V cn i).
    unfold cn. rewrite <- apply_prod, apply_one by auto. ring. }
  intros b Hbm.
  replace (radius s b (-1)) with (real (vget (first s) b)) by (unfold radius; field).
  assert (J := all_ok _ _ Hj b Hbm). cbv beta in J. apply leb_ok in J. rewrite real_add, real_sum in J.
  set (turned := product n N _) in J. set (moved := image n N _) in J.
  assert (UF : forall i j, (i < n)%nat -> (j < n)%nat -> Rabs (prod n X (prod n U axis) i j) <= real (mget turned i j)).
  { intros i j Hi Hj'. unfold turned. eapply Rle_trans; [|apply product_ok; auto].
    apply Sum_abs_mul; intros k Hk; [apply Xb; auto|].
    rewrite mget_grid by auto. eapply Rle_trans; [|apply up_ok]. rewrite real_abs, real_sum. right. f_equal.
    apply Sum_ext. intros l Hl. rewrite real_mul, mget_grid, pvalue_ok, real_minus_one by auto. reflexivity. }
  assert (Ug : forall i, (i < n)%nat -> Rabs (apply n X (apply n U gap) i) <= real (vget moved i)).
  { intros i Hi. unfold moved. eapply Rle_trans; [|apply image_ok; auto].
    apply Sum_abs_mul; intros k Hk; [apply Xb; auto|].
    rewrite vget_table by auto. eapply Rle_trans; [|apply up_ok]. rewrite real_abs, real_sum. right. f_equal.
    apply Sum_ext. intros l Hl. rewrite real_mul, mget_grid, vget_table, real_sub, !pvalue_ok, real_minus_one by auto. reflexivity. }
  set (first_b := real (vget (first s) b)) in *.
  set (FR := Sum (group_count old) (fun d =>
    real (matrix_norm n (block_of (blocks s)) (block_of (groups old)) b d (mget turned)) * real (vget (sizes old) d))).
  set (g := real (vector_norm n (block_of (blocks s)) b (vget moved))).
  assert (J' : FR + g <= first_b).
  { eapply Rle_trans; [right | exact J]. unfold FR, g. f_equal. apply Sum_ext. intros. rewrite real_mul. reflexivity. }
  assert (FR0 : 0 <= FR).
  { apply Sum_nonneg. intros d Hd. apply Rmult_le_pos; [apply matrix_norm_ok|].
    assert (P := all_ok _ _ Hz d Hd). cbv beta in P. apply leb_ok in P. rewrite real_zero in P. exact P. }
  destruct (vector_norm_ok n (block_of (blocks s)) b (vget moved)) as [g0 G].
  assert (Tri := block_triangle n (group_count old) (block_of (groups old))).
  apply Rle_trans with ((FR + g) * (FR + g)); [|apply Rmult_le_compat; unfold g in *; lra].
  apply Tri with (G := prod n X (prod n U axis)) (c := c) (g := apply n X (apply n U gap)); auto.
  - intros i Hi. apply Nat.ltb_lt. apply (all_ok _ _ Hb i Hi).
  - intros i Hi. unfold cn. rewrite apply_prod.
    change (Sum n (fun j => prod n X (prod n U axis) i j * c j)) with (apply n (prod n X (prod n U axis)) c i).
    rewrite apply_prod. unfold apply at 1 3 5. rewrite <- Sum_plus. apply Sum_ext. intros k Hk.
    rewrite <- Rmult_plus_distr_l. f_equal. rewrite apply_prod. unfold apply at 1 2 4. rewrite <- Sum_plus.
    apply Sum_ext. intros l Hl. rewrite <- Rmult_plus_distr_l. f_equal. rewrite (Hc l Hl). unfold apply, gap, axis. ring.
  - intros d Hd. destruct (matrix_norm_ok n (block_of (blocks s)) (block_of (groups old)) b d (mget turned)) as [P1 P2].
    split; [exact P1|]. eapply Rle_trans; [apply frobenius_le; exact UF | exact P2].
  - intros d Hd. assert (P := all_ok _ _ Hz d Hd). cbv beta in P. apply leb_ok in P. rewrite real_zero in P. split; auto.
  - eapply Rle_trans; [apply square_le; exact Ug | exact G].
Qed.

(* A step with the values that are claimed in it: low/unit <= y_index(numerator/denominator) <= high/unit. The time
   is within a blur of a dyadic number of [-1, 1]. *)
Record claim := Claim { numerator : Z; denominator : Z; index : nat; low : Z; high : Z; unit : Z }.
Definition item := (step * list (num * claim))%type.

Section Chain.
Variables (n : nat) (Q : Z) (F : list expr).

Definition end_of (s : step) : states :=
  States (table n (fun i => pvalue (pget (curve s) i) one)) (grid n n (fun i j => pvalue (pmget (frame s) i j) one))
    (blocks s) (block_count s) (last s).
Definition next_begin (begin : num) (s : step) : num := add begin (scale (half s) 1).

Definition blur : num := (BigZ.one, (-500)%Z).
Definition blurred (P : poly) (x : num) : num := add (abs (pvalue P x)) (mul (pnorm (pderiv P)) blur).
Definition row_reach (s : step) (x : num) (i : nat) : num :=
  nsum (block_count s) (fun b => mul
    (vector_norm n (block_of (blocks s)) b (fun j => blurred (pmget (frame s) i j) x))
    (add (scale (add (mul (vget (first s) b) (sub one x)) (mul (vget (last s) b) (add one x))) (-1))
         (mul (add (vget (first s) b) (vget (last s) b)) blur))).
Definition claim_ok (begin : num) (s : step) (a : num * claim) : bool :=
  let (x, c) := a in let P := pget (curve s) (index c) in
  let v := pvalue P x in let r := up (add (row_reach s x (index c)) (mul (pnorm (pderiv P)) blur)) in
  let d := num_of_Z (denominator c) in let t := num_of_Z (numerator c) in
  let miss := sub (mul d (add begin (mul (half s) (add one x)))) t in
  leb minus_one x && leb x one && Nat.ltb (index c) n && Z.ltb 0 (denominator c) && Z.ltb 0 (unit c) &&
  leb (mul d begin) t && leb t (mul d (add begin (scale (half s) 1))) && leb (abs miss) (mul (mul d (half s)) blur) &&
  leb (num_of_Z (low c)) (mul (num_of_Z (unit c)) (sub v r)) && leb (mul (num_of_Z (unit c)) (add v r)) (num_of_Z (high c)).

Fixpoint chain_ok (begin : num) (old : states) (items : list item) : bool :=
  match items with
  | [] => true
  | (s, claims) :: rest => step_ok n Q F begin s old && forallb (claim_ok begin s) claims &&
      chain_ok (next_begin begin s) (end_of s) rest
  end.
Fixpoint duration (items : list item) : R :=
  match items with [] => 0 | (s, _) :: rest => 2 * real (half s) + duration rest end.
Definition all_claims (items : list item) : list claim := flat_map (fun a => map snd (snd a)) items.

(* y solves the equations on [a, e] *)
Definition solution (a e : R) (y : nat -> R -> R) : Prop :=
  forall i t, (i < n)%nat -> a <= t <= e -> deriv_on a e (y i) t (eval t (fun j => y j t) (right F i) / IZR Q).

(* The state v at the time t is in the tube of every step that contains this time. *)
Fixpoint in_chain (begin : R) (items : list item) (t : R) (v : nat -> R) : Prop :=
  match items with
  | [] => True
  | (s, _) :: rest =>
      (begin <= t <= begin + 2 * real (half s) -> in_step n s ((t - begin) / real (half s) - 1) v) /\
      in_chain (begin + 2 * real (half s)) rest t v
  end.

Lemma step_ok_parts begin s old : step_ok n Q F begin s old = true ->
  (forall v, in_states n old v -> in_step n s (-1) v) /\ 0 < real (half s) /\ 0 < IZR Q /\
  (forall i, (i < n)%nat -> below n (right F i) = true) /\
  forall e y, real begin <= e -> e <= real begin + 2 * real (half s) -> solution (real begin) e y ->
    in_step n s (-1) (fun i => y i (real begin)) ->
    forall t, real begin <= t <= e -> in_step n s ((t - real begin) / real (half s) - 1) (fun i => y i t).
Proof.
  unfold step_ok. cbv zeta. rewrite !andb_true_iff. intros [[[H1 H2] H3] H4]. repeat split.
  - intros v. apply (joint_sound n Q F s old v H1 H2 H3).
  - eapply h_pos; eauto.
  - eapply k_pos; eauto.
  - eapply right_below; eauto.
  - intros e y He1 He2 Hy. exact (step_sound_inside n Q F begin s H1 H2 H4 e y He1 He2 Hy).
Qed.

Lemma next_begin_ok begin s : real (next_begin begin s) = real begin + 2 * real (half s).
Proof. unfold next_begin. rewrite real_add, real_scale. replace (pow2 1) with 2 by (unfold pow2; simpl; ring). ring. Qed.

Lemma end_of_ok s v : in_step n s 1 v -> in_states n (end_of s) v.
Proof.
  intros (c & Hc & Hsq). exists c. unfold end_of; simpl. split.
  - intros i Hi. rewrite (Hc i Hi), vget_table, pvalue_ok, real_one by auto. f_equal.
    apply Sum_ext. intros j Hj. rewrite mget_grid, pvalue_ok, real_one by auto. reflexivity.
  - intros b Hb. specialize (Hsq b Hb). replace (radius s b 1) with (real (vget (last s) b)) in Hsq by (unfold radius; field).
    exact Hsq.
Qed.

Lemma duration_pos items : forall begin old, chain_ok begin old items = true -> 0 <= duration items.
Proof.
  induction items as [|[s claims] rest IH]; intros begin old H; simpl in *; [lra|].
  rewrite !andb_true_iff in H. destruct H as [[H1 _] H2]. specialize (IH _ _ H2).
  destruct (step_ok_parts _ _ _ H1) as (_ & P & _). lra.
Qed.

(* A solution on [T0, e] that is in the set at the beginning of the chain is in the tubes as long as it lasts. *)
Theorem chain_sound T0 e y : solution T0 e y -> forall items begin old, chain_ok begin old items = true ->
  T0 <= real begin -> in_states n old (fun i => y i (real begin)) ->
  forall t, real begin <= t <= e -> in_chain (real begin) items t (fun i => y i t).
Proof.
  intros Hy items. induction items as [|[s claims] rest IH]; intros begin old H HT0 Hin t Ht; simpl; [exact I|].
  cbn [chain_ok] in H. rewrite !andb_true_iff in H. destruct H as [[H1 _] H2].
  destruct (step_ok_parts _ _ _ H1) as (Hj & Hp & _ & _ & Hs). set (h := real (half s)) in *.
  set (e1 := Rmin e (real begin + 2 * h)).
  assert (E1 : e1 <= e) by apply Rmin_l. assert (E2 : e1 <= real begin + 2 * h) by apply Rmin_r.
  assert (E3 : real begin <= e1) by (unfold e1; apply Rmin_glb; lra).
  assert (Part : solution (real begin) e1 y).
  { intros i v Hi Hv. apply deriv_sub_interval with T0 e; try lra. apply Hy; auto; lra. }
  specialize (Hs e1 y E3 E2 Part (Hj _ Hin)). split.
  - intros Ht2. apply Hs. split; [lra|]. unfold e1. apply Rmin_glb; lra.
  - replace (real begin + 2 * h) with (real (next_begin begin s)) by apply next_begin_ok.
    destruct (Rle_or_lt (real begin + 2 * h) t) as [Hle | Hlt].
    + apply (IH (next_begin begin s) (end_of s)); auto; rewrite ?next_begin_ok; fold h; try lra.
      apply end_of_ok. assert (Ee : e1 = real begin + 2 * h) by (unfold e1; apply Rmin_right; lra).
      specialize (Hs (real begin + 2 * h) ltac:(lra)).
      replace ((real begin + 2 * h - real begin) / h - 1) with 1 in Hs by (field; lra). exact Hs.
    + (* the later steps do not contain t *)
      assert (Later : forall items b old, chain_ok b old items = true -> t < real b -> in_chain (real b) items t (fun i => y i t)).
      { clear. induction items as [|[s claims] rest IH]; intros b old H Hb; simpl; [exact I|].
        cbn [chain_ok] in H. rewrite !andb_true_iff in H. destruct H as [[H1 _] H2].
        destruct (step_ok_parts _ _ _ H1) as (_ & Hp & _). split; [lra|].
        rewrite <- next_begin_ok. apply (IH _ _ H2). rewrite next_begin_ok. lra. }
      apply (Later rest _ _ H2). rewrite next_begin_ok. fold h. lra.
Qed.

(* Bounds next to a number x of a step. *)
Lemma blurred_ok P x y : -1 <= real x <= 1 -> -1 <= y <= 1 -> Rabs (y - real x) <= real blur ->
  Rabs (peval P y - peval P (real x)) <= real (pnorm (pderiv P)) * real blur.
Proof.
  intros Hx Hy Hd. assert (Pn := pnorm_nonneg (pderiv P)).
  apply Rle_trans with (real (pnorm (pderiv P)) * Rabs (y - real x)); [|apply Rmult_le_compat_l; auto].
  apply (mean_value (-1) 1 (peval P) (peval (pderiv P))); auto.
  - intros v _. apply peval_deriv.
  - intros v Hv _. apply pnorm_ok; auto.
Qed.

Lemma row_reach_ok s x y v i : (forall j, (j < n)%nat -> (block_of (blocks s) j < block_count s)%nat) ->
  (forall b, (b < block_count s)%nat -> 0 <= real (vget (first s) b) /\ 0 <= real (vget (last s) b)) ->
  -1 <= real x <= 1 -> -1 <= y <= 1 -> Rabs (y - real x) <= real blur -> (i < n)%nat -> in_step n s y v ->
  Rabs (v i - real (pvalue (pget (curve s) i) x)) <= real (row_reach s x i) + real (pnorm (pderiv (pget (curve s) i))) * real blur.
Proof.
  intros Hb Hr Hx Hy Hd Hi (c & Hc & Hsq). rewrite (Hc i Hi), pvalue_ok.
  set (P := pget (curve s) i). set (W := Sum n (fun j => peval (pmget (frame s) i j) y * c j)).
  replace (peval P y + W - peval P (real x)) with (W + (peval P y - peval P (real x))) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; [|apply blurred_ok; auto].
  unfold W, row_reach. rewrite real_sum.
  rewrite (Sum_ext _ (fun b => real (mul _ _))
    (fun b => real (vector_norm n (block_of (blocks s)) b (fun j => blurred (pmget (frame s) i j) x))
    * (radius s b (real x) + (real (vget (first s) b) + real (vget (last s) b)) * real blur))).
  2:{ intros b Hb'. rewrite real_mul, real_add, real_scale, real_add, !real_mul, real_sub, !real_add, real_one. f_equal. unfold radius.
      replace (pow2 (-1)) with (/ 2) by (unfold pow2; simpl; field). field. }
  apply (row_bound n (block_count s) (block_of (blocks s)) Hb); intros b Hb'.
  - destruct (vector_norm_ok n (block_of (blocks s)) b (fun j => blurred (pmget (frame s) i j) x)) as [P1 P2]. split; [exact P1|].
    eapply Rle_trans; [apply square_le|exact P2]. intros j Hj. unfold blurred. rewrite real_add, real_abs, real_mul, pvalue_ok.
    replace (peval (pmget (frame s) i j) y)
      with (peval (pmget (frame s) i j) (real x) + (peval (pmget (frame s) i j) y - peval (pmget (frame s) i j) (real x))) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_l, blurred_ok; auto.
  - destruct (Hr b Hb') as [R0 R1]. set (r0 := real (vget (first s) b)) in *. set (r1 := real (vget (last s) b)) in *.
    apply Rabs_le_both in Hd.
    assert (Rx : 0 <= radius s b y).
    { unfold radius. fold r0 r1. assert (0 <= r0 * (1 - y)) by (apply Rmult_le_pos; lra).
      assert (0 <= r1 * (1 + y)) by (apply Rmult_le_pos; lra). lra. }
    assert (Le : radius s b y <= radius s b (real x) + (r0 + r1) * real blur).
    { unfold radius. fold r0 r1. assert (r0 * (real x - y) <= r0 * real blur) by (apply Rmult_le_compat_l; lra).
      assert (r1 * (y - real x) <= r1 * real blur) by (apply Rmult_le_compat_l; lra).
      assert (0 <= r0 * real blur) by (apply Rmult_le_pos; lra). assert (0 <= r1 * real blur) by (apply Rmult_le_pos; lra). lra. }
    split; [lra|]. eapply Rle_trans; [apply (Hsq b Hb')|]. apply Rmult_le_compat; lra.
Qed.

Definition claim_time (c : claim) : R := IZR (numerator c) / IZR (denominator c).
Definition claim_holds (c : claim) (v : R) : Prop := IZR (low c) / IZR (unit c) <= v <= IZR (high c) / IZR (unit c).

Lemma step_ok_shape begin s old : step_ok n Q F begin s old = true -> shape_ok n Q F s = true.
Proof. unfold step_ok. cbv zeta. rewrite !andb_true_iff. tauto. Qed.

Lemma claim_sound begin s old x c v : step_ok n Q F begin s old = true -> claim_ok begin s (x, c) = true ->
  (real begin <= claim_time c <= real begin + 2 * real (half s) ->
     in_step n s ((claim_time c - real begin) / real (half s) - 1) v) ->
  claim_holds c (v (index c)).
Proof.
  intros Hs Hc Hin. assert (Sh := step_ok_shape _ _ _ Hs).
  destruct (step_ok_parts _ _ _ Hs) as (_ & Hp & _). set (h := real (half s)) in *.
  unfold claim_ok in Hc. rewrite !andb_true_iff in Hc. destruct Hc as [[[[[[[[[H1 H2] H3] H4] H5] Ha] Hb] H6] H7] H8].
  apply leb_ok in H1, H2, Ha, Hb, H6, H7, H8. apply Nat.ltb_lt in H3. apply Z.ltb_lt, IZR_lt in H4, H5.
  rewrite real_minus_one in H1. rewrite real_one in H2.
  rewrite real_abs, real_sub, !real_mul, real_add, real_mul, real_add, real_one, !real_num_of_Z in H6. fold h in H6.
  rewrite real_mul, !real_num_of_Z in Ha. rewrite real_mul, !real_num_of_Z, real_add, real_scale in Hb.
  replace (pow2 1) with 2 in Hb by (unfold pow2; simpl; ring). fold h in Hb.
  set (d := IZR (denominator c)) in *. set (y := (claim_time c - real begin) / h - 1) in *.
  assert (Et : d * claim_time c = IZR (numerator c)) by (unfold claim_time; fold d; field; lra).
  assert (Ey : real begin + h * (1 + y) = claim_time c) by (unfold y; field; lra).
  rewrite <- Et in Ha, Hb, H6.
  assert (T1 : real begin <= claim_time c) by (apply Rmult_le_reg_l with d; auto).
  assert (T2 : claim_time c <= real begin + 2 * h) by (apply Rmult_le_reg_l with d; auto; lra).
  assert (Y : -1 <= y <= 1) by (split; apply Rmult_le_reg_l with h; auto; lra).
  assert (D : Rabs (y - real x) <= real blur).
  { apply Rmult_le_reg_l with (d * h); [apply Rmult_lt_0_compat; auto|]. eapply Rle_trans; [right | exact H6].
    rewrite <- Ey. replace (d * (real begin + h * (1 + real x)) - d * (real begin + h * (1 + y))) with (- (d * h * (y - real x))) by ring.
    rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq (d * h)); [reflexivity | left; apply Rmult_lt_0_compat; auto]. }
  specialize (Hin (conj T1 T2)).
  assert (R := row_reach_ok s x y v (index c) (block_below n Q F s Sh) (radii_nonneg n Q F s Sh) (conj H1 H2) Y D H3 Hin).
  rewrite real_mul, real_num_of_Z, real_num_of_Z, real_sub in H7. rewrite real_mul, real_num_of_Z, real_num_of_Z, real_add in H8.
  assert (Up := up_ok (add (row_reach s x (index c)) (mul (pnorm (pderiv (pget (curve s) (index c)))) blur))).
  rewrite real_add, real_mul in Up.
  set (p := real (pvalue _ _)) in *. set (r := real (up _)) in *. apply Rabs_le_both in R. unfold claim_holds.
  split; apply Rmult_le_reg_l with (IZR (unit c)); auto.
  - replace (IZR (unit c) * (IZR (low c) / IZR (unit c))) with (IZR (low c)) by (field; lra).
    eapply Rle_trans; [exact H7|]. apply Rmult_le_compat_l; lra.
  - replace (IZR (unit c) * (IZR (high c) / IZR (unit c))) with (IZR (high c)) by (field; lra).
    eapply Rle_trans; [|exact H8]. apply Rmult_le_compat_l; lra.
Qed.

Theorem claims_sound y items : forall begin old, chain_ok begin old items = true ->
  (forall c, In c (all_claims items) -> in_chain (real begin) items (claim_time c) (fun i => y i (claim_time c))) ->
  forall c, In c (all_claims items) -> claim_holds c (y (index c) (claim_time c)).
Proof.
  induction items as [|[s claims] rest IH]; intros begin old H Hin c Hc; [destruct Hc|].
  cbn [chain_ok] in H. rewrite !andb_true_iff in H. destruct H as [[H1 Hcl] H2].
  unfold all_claims in Hc. cbn [flat_map snd] in Hc. apply in_app_or in Hc as [Hc | Hc].
  - apply in_map_iff in Hc as ([x c'] & E & Hx). simpl in E. subst c'.
    assert (Hin' := Hin c ltac:(apply in_or_app; left; apply in_map_iff; exists (x, c); auto)). destruct Hin' as [P _].
    rewrite forallb_forall in Hcl. apply (claim_sound begin s old x c (fun i => y i (claim_time c)) H1); auto.
  - apply (IH _ _ H2); auto. intros c' Hc'. rewrite next_begin_ok.
    apply (Hin c' ltac:(apply in_or_app; right; auto)).
Qed.

(* One bound for all unknowns on the whole chain. *)
Definition step_bound (s : step) : R :=
  Sum n (fun i => real (pnorm (pget (curve s) i)) + real (vget (reach n s (magnitudes n (frame s))) i)).
Fixpoint chain_bound (items : list item) : R :=
  match items with [] => 0 | (s, _) :: rest => Rmax (step_bound s) (chain_bound rest) end.

Lemma step_bound_ok begin s old x v i : step_ok n Q F begin s old = true -> -1 <= x <= 1 -> in_step n s x v ->
  (i < n)%nat -> Rabs (v i) <= step_bound s.
Proof.
  intros Hs Hx (c & Hc & Hsq) Hi. assert (Sh := step_ok_shape _ _ _ Hs).
  assert (Tp : 0 < real tiny) by (unfold real, tiny; cbn [fst snd]; rewrite int_one, Rmult_1_l; apply pow2_pos).
  assert (R : forall i, (i < n)%nat ->
    Rabs (Sum n (fun j => peval (pmget (frame s) i j) x * c j)) <= real (vget (reach n s (magnitudes n (frame s))) i)).
  { apply (reach_ok n Q F s Sh x c Hx). intros b Hb. eapply Rle_trans; [apply (Hsq b Hb)|].
    assert (P := radius_nonneg n Q F s Sh b x Hb Hx). apply Rmult_le_compat; lra. }
  apply Rle_trans with (real (pnorm (pget (curve s) i)) + real (vget (reach n s (magnitudes n (frame s))) i)).
  - rewrite (Hc i Hi). eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; auto using pnorm_ok.
  - apply (Sum_term_le n i (fun i => real (pnorm (pget (curve s) i)) + real (vget (reach n s (magnitudes n (frame s))) i))); auto.
    intros j Hj. assert (P := pnorm_nonneg (pget (curve s) j)). assert (R0 := R j Hj).
    assert (P2 := Rabs_pos (Sum n (fun l => peval (pmget (frame s) j l) x * c l))). lra.
Qed.

Lemma chain_bound_ok items : forall begin old t v i, chain_ok begin old items = true -> in_chain (real begin) items t v ->
  real begin <= t <= real begin + duration items -> items <> [] -> (i < n)%nat -> Rabs (v i) <= chain_bound items.
Proof.
  induction items as [|[s claims] rest IH]; intros begin old t v i H Hin Ht Hne Hi; [contradiction|].
  cbn [chain_ok] in H. rewrite !andb_true_iff in H. destruct H as [[H1 _] H2]. destruct Hin as [Hin Hrest].
  destruct (step_ok_parts _ _ _ H1) as (_ & Hp & _). cbn [chain_bound duration] in *.
  destruct (Rle_or_lt t (real begin + 2 * real (half s))) as [Hle | Hgt].
  - eapply Rle_trans; [|apply Rmax_l]. set (x := (t - real begin) / real (half s) - 1) in *.
    apply (step_bound_ok begin s old x v i H1); auto; [|apply Hin; lra].
    assert (Ex : real (half s) * x = t - real begin - real (half s)) by (unfold x; field; lra).
    split; apply Rmult_le_reg_l with (real (half s)); auto; lra.
  - eapply Rle_trans; [|apply Rmax_r]. rewrite <- next_begin_ok in Hrest.
    apply (IH (next_begin begin s) (end_of s) t v i H2 Hrest); auto; [rewrite next_begin_ok; lra|].
    intros ->. simpl in Ht. lra.
Qed.
End Chain.
