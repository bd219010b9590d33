(* A step whose conditions hold: every solution that begins in the set stays in the tube. *)
Require Import Reals Lra Lia ZArith List Bool.
From Bignums Require Import BigZ.
From Libration Require Import Sums Matrices Derivative Exit Blocks TheoremK Dyadic Chebyshev Polynomial Norms Field Step.
Import ListNotations.
Open Scope R_scope.

Lemma pnorm_nonneg P : 0 <= real (pnorm P).
Proof. eapply Rle_trans; [apply Rabs_pos | apply (pnorm_ok P 0); lra]. Qed.

Lemma prod_le n A B B' i j : (forall k, (k < n)%nat -> 0 <= A i k) -> (forall k, (k < n)%nat -> B k j <= B' k j) ->
  prod n A B i j <= prod n A B' i j.
Proof. intros HA HB. apply Sum_le. intros k Hk. apply Rmult_le_compat_l; auto. Qed.

Lemma finite_choice n (P : nat -> (nat -> R) -> Prop) : (forall k, (k < n)%nat -> exists E, P k E) ->
  exists M : nat -> nat -> R, forall k, (k < n)%nat -> P k (M k).
Proof.
  induction n as [|n IH]; intros H; [exists (fun _ _ => 0); intros; lia|].
  destruct IH as (M & HM); [intros; apply H; lia|]. destruct (H n) as (E & HE); [lia|].
  exists (fun k => if Nat.eqb k n then E else M k). intros k Hk.
  destruct (Nat.eqb_spec k n) as [-> |]; auto. apply HM; lia.
Qed.

Lemma form_ext n block block' b d M M' u c : (forall i j, (i < n)%nat -> (j < n)%nat -> M i j = M' i j) ->
  form n block block' b d M u c = form n block block' b d M' u c.
Proof.
  intros H. apply Sum_ext. intros i Hi. do 2 f_equal. apply Sum_ext. intros j Hj. rewrite H; auto.
Qed.

Lemma time_of_ok begin s x : peval (time_of begin s) x = real begin + real (half s) * (1 + x).
Proof.
  unfold time_of. rewrite peval_add, peval_const, real_add. unfold peval. cbn [fst snd cheb tail]. rewrite int_zero.
  assert (E : pow2 (snd (half s)) = pow2 (snd (half s) - 1) * 2).
  { rewrite (pow2_split (snd (half s) - 1) (snd (half s))), Rmult_comm. f_equal.
    replace (snd (half s) - (snd (half s) - 1))%Z with 1%Z by ring. unfold pow2; simpl; ring. }
  unfold real. rewrite E. simpl (t 1 x). ring.
Qed.

Section StepProof.
Variables (n : nat) (Q : Z) (F : list expr) (begin : num) (s : step) (old : states).
Let z := deviation n s.
Let q := row_sum n z.
Let r := up (inverse_candidate (sub one q)).
Let N := inverse_bound n z r.
Let V := magnitudes n (frame s).
Let U := magnitudes n (coframe s).
Let rho := reach n s V.
Let T := field_models n F begin s rho.
Let B := linear_part n Q s T.
Let B0 := magnitudes n B.
Let change := changes n s T.
Let full := product n N (sum_grid n B0 (product n U (product n change V))).
Let more := rest_grid n full B0.
Let dd := image n N (defect n Q s T).
Let D := table (block_count s) (fun b => vector_norm n (block_of (blocks s)) b (vget dd)).
Let A := rate_table n s B full more.
Hypothesis Hshape : shape_ok n Q F s = true.
Hypothesis Hframe : frame_ok q r = true.
Hypothesis Hjoint : joint_ok n s N old = true.
Hypothesis Hgrowth : growth_all Q s A D = true.

Let m := block_count s.
Let block := block_of (blocks s).
Let h := real (half s).
Let k := IZR Q.

Lemma h_pos : 0 < h.
Proof.
  unfold shape_ok in Hshape. rewrite !andb_true_iff in Hshape. destruct Hshape as [[[[H _] _] _] _].
  apply ltb_ok in H. rewrite real_zero in H. exact H.
Qed.
Lemma k_pos : 0 < k.
Proof.
  unfold shape_ok in Hshape. rewrite !andb_true_iff in Hshape. destruct Hshape as [[[[_ H] _] _] _].
  apply Z.ltb_lt in H. apply IZR_lt. exact H.
Qed.
Lemma right_below i : (i < n)%nat -> below n (right F i) = true.
Proof.
  unfold shape_ok in Hshape. rewrite !andb_true_iff in Hshape. destruct Hshape as [[[_ H] _] _]. apply (all_ok _ _ H).
Qed.
Lemma block_below i : (i < n)%nat -> (block i < m)%nat.
Proof.
  unfold shape_ok in Hshape. rewrite !andb_true_iff in Hshape. destruct Hshape as [[_ H] _]. intros Hi.
  apply Nat.ltb_lt. apply (all_ok _ _ H i Hi).
Qed.
Lemma radii_nonneg b : (b < m)%nat -> 0 <= real (vget (first s) b) /\ 0 <= real (vget (last s) b).
Proof.
  unfold shape_ok in Hshape. rewrite !andb_true_iff in Hshape. destruct Hshape as [_ H]. intros Hb.
  specialize (all_ok _ _ H b Hb) as P. apply andb_prop in P as [P1 P2]. apply leb_ok in P1, P2.
  rewrite real_zero in P1, P2. auto.
Qed.
Lemma radius_nonneg b x : (b < m)%nat -> -1 <= x <= 1 -> 0 <= radius s b x.
Proof.
  intros Hb Hx. destruct (radii_nonneg b Hb) as [P0 P1]. unfold radius.
  assert (0 <= real (vget (first s) b) * (1 - x)) by (apply Rmult_le_pos; lra).
  assert (0 <= real (vget (last s) b) * (1 + x)) by (apply Rmult_le_pos; lra). lra.
Qed.

(* Condition 1. *)
Lemma z_ok x i j : -1 <= x <= 1 -> (i < n)%nat -> (j < n)%nat ->
  Rabs (Sum n (fun l => peval (pmget (coframe s) i l) x * peval (pmget (frame s) l j) x) - delta i j) <= real (mget z i j).
Proof.
  intros Hx Hi Hj. unfold z, deviation. rewrite mget_grid by auto. eapply Rle_trans; [|apply pnorm_ok; exact Hx].
  right. f_equal. rewrite peval_sub, peval_sum. f_equal.
  - apply Sum_ext. intros. rewrite peval_mul. reflexivity.
  - unfold delta. destruct Nat.eqb; [rewrite peval_const, real_one | rewrite peval_zero]; reflexivity.
Qed.
Lemma z_nonneg i j : (i < n)%nat -> (j < n)%nat -> 0 <= real (mget z i j).
Proof. intros. unfold z, deviation. rewrite mget_grid by auto. apply pnorm_nonneg. Qed.
Lemma z_rows i : (i < n)%nat -> Sum n (fun j => real (mget z i j)) <= real q.
Proof.
  intros Hi. rewrite <- real_sum. apply (largest_of_ok n (fun i => nsum n (mget z i)) i). lia.
Qed.
Lemma q_ok : real q < 1 /\ 1 <= real r * (1 - real q).
Proof.
  unfold frame_ok in Hframe. apply andb_prop in Hframe as [H1 H2]. apply ltb_ok in H1. apply leb_ok in H2.
  rewrite real_one in H1, H2. rewrite real_mul, real_sub, real_one in H2. auto.
Qed.
Lemma N_ok i j : (i < n)%nat -> (j < n)%nat ->
  delta i j + less_one n (fun i j => real (mget z i j)) (real r) i j <= real (mget N i j).
Proof.
  intros Hi Hj. unfold N, inverse_bound. rewrite mget_grid by auto. eapply Rle_trans; [|apply up_ok].
  rewrite !real_add, real_mul, real_sum. right. unfold less_one. f_equal.
  - unfold delta. destruct Nat.eqb; [rewrite real_one | rewrite real_zero]; reflexivity.
  - do 2 f_equal. apply Sum_ext. intros. rewrite real_sum. apply Sum_ext. intros. rewrite real_mul. reflexivity.
Qed.
Lemma N_nonneg i j : (i < n)%nat -> (j < n)%nat -> 0 <= real (mget N i j).
Proof.
  intros Hi Hj. eapply Rle_trans; [|apply N_ok; auto]. unfold less_one.
  assert (0 <= real r). { destruct q_ok. apply Rnot_lt_le. intros Hr. assert (real r * (1 - real q) <= 0); [|lra].
    assert (0 <= (- real r) * (1 - real q)) by (apply Rmult_le_pos; lra). lra. }
  assert (0 <= delta i j) by (unfold delta; destruct Nat.eqb; lra).
  assert (0 <= Sum n (fun l => prod n (fun i j => real (mget z i j)) (fun i j => real (mget z i j)) i l) * real r).
  { apply Rmult_le_pos; auto. apply Sum_nonneg. intros. apply Sum_nonneg. intros. apply Rmult_le_pos; apply z_nonneg; auto. }
  assert (P := z_nonneg i j Hi Hj). lra.
Qed.

Lemma magnitudes_ok M x i j : -1 <= x <= 1 -> (i < n)%nat -> (j < n)%nat ->
  Rabs (peval (pmget M i j) x) <= real (mget (magnitudes n M) i j).
Proof. intros. unfold magnitudes. rewrite mget_grid by auto. apply pnorm_ok; auto. Qed.
Lemma magnitudes_nonneg M i j : (i < n)%nat -> (j < n)%nat -> 0 <= real (mget (magnitudes n M) i j).
Proof. intros. unfold magnitudes. rewrite mget_grid by auto. apply pnorm_nonneg. Qed.
Lemma product_ok X Y i j : (i < n)%nat -> (j < n)%nat ->
  prod n (fun i j => real (mget X i j)) (fun i j => real (mget Y i j)) i j <= real (mget (product n X Y) i j).
Proof.
  intros. unfold product. rewrite mget_grid by auto. eapply Rle_trans; [|apply up_ok]. rewrite real_sum. right.
  apply Sum_ext. intros. rewrite real_mul. reflexivity.
Qed.
Lemma image_ok X v i : (i < n)%nat ->
  apply n (fun i j => real (mget X i j)) (fun j => real (vget v j)) i <= real (vget (image n X v) i).
Proof.
  intros. unfold image. rewrite vget_table by auto. eapply Rle_trans; [|apply up_ok]. rewrite real_sum. right.
  apply Sum_ext. intros. rewrite real_mul. reflexivity.
Qed.

(* The reach of the tube, with a little more. *)
Lemma reach_ok x c : -1 <= x <= 1 ->
  (forall b, (b < m)%nat -> square n block b c <= (radius s b x + real tiny) * (radius s b x + real tiny)) ->
  forall i, (i < n)%nat -> Rabs (Sum n (fun j => peval (pmget (frame s) i j) x * c j)) <= real (vget rho i).
Proof.
  intros Hx Hc i Hi. unfold rho, reach. rewrite vget_table by auto. eapply Rle_trans; [|apply up_ok]. rewrite real_sum.
  rewrite (Sum_ext _ (fun i0 => real (mul _ _))
    (fun b => real (vector_norm n (block_of (blocks s)) b (mget V i)) * real (largest_radius s b)))
    by (intros; rewrite real_mul; reflexivity).
  assert (Tp : 0 < real tiny) by (unfold real, tiny; cbn [fst snd]; rewrite int_one, Rmult_1_l; apply pow2_pos).
  apply (row_bound n m block block_below); intros b Hb.
  - destruct (vector_norm_ok n block b (mget V i)) as [P1 P2]. split; [exact P1|].
    eapply Rle_trans; [apply square_le|exact P2]. intros j Hj. apply magnitudes_ok; auto.
  - destruct (radii_nonneg b Hb) as [R0 R1]. assert (Rx := radius_nonneg b x Hb Hx).
    assert (M0 := max_left (vget (first s) b) (vget (last s) b)). assert (M1 := max_right (vget (first s) b) (vget (last s) b)).
    assert (Le : radius s b x <= real (max (vget (first s) b) (vget (last s) b))).
    { unfold radius. set (M := real (max _ _)) in *.
      assert (real (vget (first s) b) * (1 - x) <= M * (1 - x)) by (apply Rmult_le_compat_r; lra).
      assert (real (vget (last s) b) * (1 + x) <= M * (1 + x)) by (apply Rmult_le_compat_r; lra). lra. }
    unfold largest_radius. rewrite real_add. split; [lra|].
    eapply Rle_trans; [apply (Hc b Hb)|]. apply Rmult_le_compat; lra.
Qed.

(* The field along the curve, in the time x/k: half times the right sides. *)
Definition f (i : nat) (tau : R) (v : nat -> R) : R := h * eval (real begin + h * (1 + k * tau)) v (right F i).
Definition p (i : nat) (tau : R) : R := peval (pget (curve s) i) (0 + k * tau).
Definition dp (i : nat) (tau : R) : R := k * peval (pderiv (pget (curve s) i)) (0 + k * tau).
Definition Vt (i j : nat) (tau : R) : R := peval (pmget (frame s) i j) (0 + k * tau).
Definition dVt (i j : nat) (tau : R) : R := k * peval (pderiv (pmget (frame s) i j)) (0 + k * tau).
Definition Ut (i j : nat) (tau : R) : R := peval (pmget (coframe s) i j) (0 + k * tau).
Definition Jt (i j : nat) (tau : R) : R := h * peval (pget (linear (mod_get T i)) j) (0 + k * tau).

Lemma mod_get_T i : (i < n)%nat -> mod_get T i = model_of n (time_of begin s) (curve s) rho (right F i).
Proof. intros Hi. unfold mod_get, T, field_models. rewrite table_nth by auto. reflexivity. Qed.

Lemma time_at tau : peval (time_of begin s) (0 + k * tau) = real begin + h * (1 + k * tau).
Proof. rewrite time_of_ok. unfold h. ring. Qed.

Lemma f_value i tau : (i < n)%nat -> -1 <= 0 + k * tau <= 1 ->
  f i tau (fun j => p j tau) = h * peval (value (mod_get T i)) (0 + k * tau).
Proof.
  intros Hi Hx. rewrite mod_get_T, model_value by (auto using right_below). unfold f. f_equal.
  rewrite time_at. reflexivity.
Qed.

Lemma f_linear tau w : -1 <= 0 + k * tau <= 1 -> (forall i, (i < n)%nat -> Rabs (w i) <= real (vget rho i)) ->
  exists E : matrix, (forall i j, (i < n)%nat -> (j < n)%nat -> Rabs (E i j) <= real (mget change i j)) /\
  forall i, (i < n)%nat -> f i tau (fun j => p j tau + w j) = f i tau (fun j => p j tau) + Sum n (fun j => (Jt i j tau + E i j) * w j).
Proof.
  intros Hx Hw.
  destruct (finite_choice n (fun i E => (forall j, (j < n)%nat -> Rabs (E j) <= real (mget change i j)) /\
    f i tau (fun j => p j tau + w j) = f i tau (fun j => p j tau) + Sum n (fun j => (Jt i j tau + E j) * w j))) as (M & HM).
  - intros i Hi.
    destruct (model_ok n (time_of begin s) (curve s) rho (0 + k * tau) w Hx Hw (right F i) (right_below i Hi)) as (E & HE & Ev).
    rewrite <- mod_get_T in HE, Ev by auto.
    exists (fun j => h * E j). split.
    + intros j Hj. unfold change, changes. rewrite mget_grid by auto. eapply Rle_trans; [|apply up_ok].
      rewrite real_mul, real_abs, Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos | auto].
    + rewrite f_value by auto. rewrite time_at in Ev. unfold f, p. rewrite Ev, Rmult_plus_distr_l, <- Sum_scal.
      f_equal. apply Sum_ext. intros j Hj. unfold Jt. ring.
  - exists M. split; intros; apply HM; auto.
Qed.

Lemma defect_ok tau i : -1 <= 0 + k * tau <= 1 -> (i < n)%nat ->
  Rabs (Sum n (fun l => Ut i l tau * (f l tau (fun j => p j tau) - dp l tau))) <= real (vget (defect n Q s T) i).
Proof.
  intros Hx Hi. unfold defect. cbv zeta. rewrite vget_table by auto. eapply Rle_trans; [|apply pnorm_ok; exact Hx].
  right. f_equal. rewrite peval_sum. apply Sum_ext. intros l Hl. rewrite peval_mul. unfold Ut. f_equal.
  rewrite pget_table by auto. rewrite peval_sub, !peval_scale, f_value by auto. unfold dp, time_scale.
  rewrite real_num_of_Z. reflexivity.
Qed.

Lemma linear_ok tau i j : (i < n)%nat -> (j < n)%nat ->
  TheoremK.B0 n Vt dVt Ut Jt tau i j = peval (pmget B i j) (0 + k * tau).
Proof.
  intros Hi Hj. unfold TheoremK.B0, JVd, B, linear_part. cbv zeta. rewrite pmget_grid, peval_sum by auto.
  apply Sum_ext. intros l Hl. rewrite peval_mul. unfold Ut. f_equal. rewrite pmget_grid by auto.
  rewrite peval_sub, peval_sum, peval_scale. unfold time_scale. rewrite real_num_of_Z. unfold dVt. f_equal.
  apply Sum_ext. intros e He. rewrite peval_mul, peval_scale. reflexivity.
Qed.

Lemma B0_ok tau i j : -1 <= 0 + k * tau <= 1 -> (i < n)%nat -> (j < n)%nat ->
  Rabs (TheoremK.B0 n Vt dVt Ut Jt tau i j) <= real (mget B0 i j).
Proof. intros. rewrite linear_ok by auto. apply magnitudes_ok; auto. Qed.

Lemma full_ok i j : (i < n)%nat -> (j < n)%nat ->
  let exact := prod n (fun i j => real (mget N i j)) (fun i j => real (mget B0 i j) +
    prod n (fun i j => real (mget U i j)) (prod n (fun i j => real (mget change i j)) (fun i j => real (mget V i j))) i j) i j in
  exact <= real (mget full i j) /\ exact - real (mget B0 i j) <= real (mget more i j).
Proof.
  intros Hi Hj exact. assert (H : exact <= real (mget full i j)).
  { eapply Rle_trans; [|apply product_ok; auto]. apply prod_le; intros l Hl; [apply N_nonneg; auto|].
    unfold sum_grid. rewrite mget_grid, real_add by auto. apply Rplus_le_compat_l.
    eapply Rle_trans; [|apply product_ok; auto]. apply prod_le; intros e He; [apply magnitudes_nonneg; auto | apply product_ok; auto]. }
  split; [exact H|]. unfold more, rest_grid. rewrite mget_grid, real_sub by auto. lra.
Qed.

(* The growth of the radii. *)
Lemma growth_cases b : (b < m)%nat -> (forall d, (d < m)%nat -> is_some (aget A b d) = true) /\
  growth_ok Q s A (vget D) (first s) b = true /\ growth_ok Q s A (vget D) (last s) b = true.
Proof.
  intros Hb. assert (H := all_ok _ _ Hgrowth b Hb). rewrite !andb_true_iff in H. destruct H as [[H1 H2] H3].
  split; [exact (all_ok _ _ H1)|]. auto.
Qed.
Lemma aget_A b d : (b < m)%nat -> (d < m)%nat -> aget A b d = rates n s B full more b d.
Proof.
  intros Hb Hd. unfold aget, A, rate_table, grid. rewrite (table_nth (block_count s) _ b []) by auto.
  rewrite table_nth by auto. reflexivity.
Qed.
Definition Ar (b d : nat) : R := real (some (aget A b d)).
Definition Lr (b : nat) : R := real (some (rate n block (pmget B) b)).
Definition ndr (b : nat) : R := real (matrix_norm n block block b b (mget more)).
Lemma A_diagonal b : (b < m)%nat -> exists L, rate n block (pmget B) b = Some L /\ Ar b b = Lr b + ndr b.
Proof.
  intros Hb. destruct (growth_cases b Hb) as (H & _). specialize (H b Hb). unfold Ar, Lr, ndr.
  rewrite (aget_A b b Hb Hb) in H |- *. unfold rates in H |- *. rewrite Nat.eqb_refl in H |- *. cbv zeta in H |- *. fold block in H |- *.
  destruct (rate n block (pmget B) b) as [L|]; [|discriminate]. exists L. split; auto. simpl. rewrite real_add. reflexivity.
Qed.
Lemma A_off b d : (b < m)%nat -> (d < m)%nat -> b <> d -> Ar b d = real (matrix_norm n block block b d (mget full)).
Proof.
  intros Hb Hd Hne. unfold Ar. rewrite aget_A by auto. unfold rates. apply Nat.eqb_neq in Hne. rewrite Hne. reflexivity.
Qed.

Lemma growth_at_end rr b : growth_ok Q s A (vget D) rr b = true ->
  2 * (Sum m (fun d => Ar b d * real (vget rr d)) + real (vget D b)) <= k * (real (vget (last s) b) - real (vget (first s) b)).
Proof.
  unfold growth_ok. intros H. apply leb_ok in H. rewrite real_scale, real_add, real_mul, real_sub, real_sum in H.
  unfold time_scale in H. rewrite real_num_of_Z in H. replace (pow2 1) with 2 in H by (unfold pow2; simpl; ring).
  rewrite Rmult_comm. eapply Rle_trans; [right | exact H]. do 2 f_equal. apply Sum_ext. intros. rewrite real_mul. reflexivity.
Qed.
Lemma growth_between b x : (b < m)%nat -> -1 <= x <= 1 ->
  Sum m (fun d => Ar b d * radius s d x) + real (vget D b) <= k * ((real (vget (last s) b) - real (vget (first s) b)) / 2).
Proof.
  intros Hb Hx. destruct (growth_cases b Hb) as (_ & G0 & G1). apply growth_at_end in G0, G1.
  replace (Sum m (fun d => Ar b d * radius s d x)) with
    (Sum m (fun d => Ar b d * real (vget (first s) d)) * ((1 - x) / 2) + Sum m (fun d => Ar b d * real (vget (last s) d)) * ((1 + x) / 2)).
  2:{ rewrite <- !Sum_scal_r, <- Sum_plus. apply Sum_ext. intros. unfold radius. field. }
  set (X0 := Sum m (fun d => Ar b d * real (vget (first s) d))) in *.
  set (X1 := Sum m (fun d => Ar b d * real (vget (last s) d))) in *.
  set (G := k * (real (vget (last s) b) - real (vget (first s) b))) in *.
  replace (k * ((real (vget (last s) b) - real (vget (first s) b)) / 2)) with (G / 2) by (unfold G; field).
  assert (P0 : (X0 + real (vget D b)) * ((1 - x) / 2) <= G / 2 * ((1 - x) / 2)) by (apply Rmult_le_compat_r; lra).
  assert (P1 : (X1 + real (vget D b)) * ((1 + x) / 2) <= G / 2 * ((1 + x) / 2)) by (apply Rmult_le_compat_r; lra).
  lra.
Qed.
Lemma D_ok b : (b < m)%nat -> 0 <= real (vget D b) /\ square n block b (fun i => real (vget dd i)) <= real (vget D b) * real (vget D b).
Proof. intros Hb. unfold D. rewrite vget_table by auto. apply vector_norm_ok. Qed.

(* Theorem K, in the time tau. *)
Lemma tube_in_tau u y : -1 <= k * u <= 1 -> - / k <= u ->
  (forall i tau, (i < n)%nat -> - / k <= tau <= u -> deriv_on (- / k) u (y i) tau (f i tau (fun j => y j tau))) ->
  in_step n s (-1) (fun i => y i (- / k)) -> forall tau, - / k <= tau <= u -> in_step n s (0 + k * tau) (fun i => y i tau).
Proof.
  intros Hu Hle Hy Hin tau Htau. assert (Kp := k_pos).
  assert (Ks : k * - / k = -1) by (field; lra).
  assert (Range : forall v, - / k <= v <= u -> -1 <= 0 + k * v <= 1).
  { intros v Hv. assert (k * - / k <= k * v) by (apply Rmult_le_compat_l; lra).
    assert (k * v <= k * u) by (apply Rmult_le_compat_l; lra). lra. }
  assert (Pd : forall P v, - / k <= v <= u -> deriv_on (- / k) u (fun v => peval P (0 + k * v)) v (k * peval (pderiv P) (0 + k * v))).
  { intros P v Hv. apply (deriv_affine (- / k) u (peval P) 0 k v); auto. apply peval_deriv. }
  assert (Result := theorem_K n m block (- / k) u y p dp Vt dVt Ut f Hle block_below Hy).
  specialize (Result (fun i v _ Hv => Pd (pget (curve s) i) v Hv)).
  specialize (Result (fun i j v _ _ Hv => Pd (pmget (frame s) i j) v Hv)).
  assert (Hext : forall i v a b, (i < n)%nat -> (forall j, (j < n)%nat -> a j = b j) -> f i v a = f i v b).
  { intros. unfold f. f_equal. apply eval_ext with n; auto using right_below. }
  specialize (Result Hext (fun i j => real (mget z i j)) (real q) (real r)).
  specialize (Result (fun v i j Hv => z_ok (0 + k * v) i j (Range v Hv)) z_rows (proj1 q_ok) (proj2 q_ok)).
  specialize (Result (fun i j => real (mget N i j)) N_ok).
  specialize (Result (fun i j => real (mget U i j)) (fun i j => real (mget V i j))
    (fun i j => real (mget B0 i j)) (fun i j => real (mget change i j))).
  specialize (Result Jt (fun i => real (vget (defect n Q s T) i)) (fun i => real (vget rho i))).
  specialize (Result (fun i j => real (mget full i j)) (fun i j => real (mget more i j)) (fun i => real (vget dd i)) full_ok).
  specialize (Result (fun v i j Hv => magnitudes_ok (coframe s) (0 + k * v) i j (Range v Hv))).
  specialize (Result (fun v i j Hv => magnitudes_ok (frame s) (0 + k * v) i j (Range v Hv))).
  specialize (Result (fun v i j Hv => B0_ok v i j (Range v Hv))).
  specialize (Result (fun v i Hv => defect_ok v i (Range v Hv)) (fun i Hi => image_ok N (defect n Q s T) i Hi)).
  specialize (Result (fun v w Hv => f_linear v w (Range v Hv))).
  specialize (Result Ar Lr ndr (fun b => real (vget D b)) (fun b v => radius s b (0 + k * v))
    (fun b _ => k * ((real (vget (last s) b) - real (vget (first s) b)) / 2)) (real tiny)).
  destruct Result with (t := tau) as (c & Hc1 & Hc2); auto.
  - intros v b c Hv Hb. destruct (A_diagonal b Hb) as (L & HL & _). unfold Lr. rewrite HL.
    rewrite (form_ext n block block b b _ (fun i j => peval (pmget B i j) (0 + k * v))) by (intros; apply linear_ok; auto).
    apply rate_ok; auto.
  - intros b Hb. apply matrix_norm_ok.
  - intros b d Hb Hd Hne. rewrite A_off by auto. apply matrix_norm_ok.
  - intros b Hb. destruct (A_diagonal b Hb) as (L & _ & E). exact E.
  - intros b Hb. apply D_ok; auto.
  - unfold real, tiny; cbn [fst snd]. rewrite int_one, Rmult_1_l. apply pow2_pos.
  - intros b v Hb Hv. split; [apply radius_nonneg; auto|].
    apply deriv_eq with (k * ((real (vget (last s) b) - real (vget (first s) b)) / 2)); [reflexivity|].
    apply (deriv_affine (- / k) u (radius s b) 0 k v); auto.
    set (R0 := real (vget (first s) b)). set (R1 := real (vget (last s) b)).
    apply deriv_ext with (g := fun x => (R0 + R1) / 2 + (R1 - R0) / 2 * x).
    + split; apply Rplus_le_compat_l, Rmult_le_compat_l; lra.
    + intros; unfold radius; fold R0 R1; field.
    + apply deriv_eq with (0 + (R1 - R0) / 2 * 1); [ring|]. apply deriv_plus; [apply deriv_const | apply deriv_scal, deriv_id].
  - intros b v Hb Hv. apply growth_between; auto.
  - intros v c Hv Hc. apply reach_ok; auto.
  - destruct Hin as (c & Hc1 & Hc2). exists c. unfold p, Vt. rewrite Ks. replace (0 + -1) with (-1) by ring. auto.
  - exists c. auto.
Qed.

(* The same in the time of the equations, on [a, e], a part of the step. *)
Theorem step_sound_inside e y : real begin <= e -> e <= real begin + 2 * h ->
  (forall i t, (i < n)%nat -> real begin <= t <= e ->
     deriv_on (real begin) e (y i) t (eval t (fun j => y j t) (right F i) / k)) ->
  in_step n s (-1) (fun i => y i (real begin)) ->
  forall t, real begin <= t <= e -> in_step n s ((t - real begin) / h - 1) (fun i => y i t).
Proof.
  intros He1 He2 Hy Hin t Ht. assert (Hp := h_pos). assert (Kp := k_pos). set (a := real begin) in *.
  set (u := ((e - a) / h - 1) / k). set (g := h * k).
  assert (Gp : 0 < g) by (apply Rmult_lt_0_compat; auto).
  assert (Eu : a + h + g * u = e) by (unfold g, u; field; lra).
  assert (Es : a + h + g * - / k = a) by (unfold g; field; lra).
  assert (Ku : k * u = (e - a) / h - 1) by (unfold u; field; lra).
  assert (Ratio : 0 <= (e - a) / h <= 2).
  { split; [apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; auto]|].
    apply Rmult_le_reg_r with h; auto. replace ((e - a) / h * h) with (e - a) by (field; lra). lra. }
  set (tau := ((t - a) / h - 1) / k).
  assert (Et : a + h + g * tau = t) by (unfold g, tau; field; lra).
  assert (Htau : - / k <= tau <= u).
  { split; apply Rmult_le_reg_l with g; auto; lra. }
  replace ((t - a) / h - 1) with (0 + k * tau) by (unfold tau; field; lra).
  assert (Q1 := tube_in_tau u (fun i v => y i (a + h + g * v))). cbv beta in Q1. rewrite <- Et.
  apply (Q1 ltac:(lra)); auto.
  - apply Rmult_le_reg_l with g; auto; lra.
  - intros i v Hi Hv. apply deriv_eq with (g * (eval (a + h + g * v) (fun j => y j (a + h + g * v)) (right F i) / k)).
    + unfold f, g. fold a. replace (a + h * (1 + k * v)) with (a + h + h * k * v) by ring. field. lra.
    + apply deriv_affine with (g := y i) (c := a + h) (k := g); auto. rewrite Es, Eu. apply Hy; auto.
      assert (g * - / k <= g * v) by (apply Rmult_le_compat_l; lra).
      assert (g * v <= g * u) by (apply Rmult_le_compat_l; lra). lra.
  - rewrite Es. exact Hin.
Qed.
End StepProof.
