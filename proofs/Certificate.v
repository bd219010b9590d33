(* Certificates: the theorem about all that a certificate whose conditions hold proves. *)
From Coq Require Export Reals ZArith List Lra Lia.
From Bignums Require Export BigZ.
From Libration Require Import Sums Exit Blocks Polynomial Norms StepProof Existence.
From Libration Require Export Derivative Dyadic Field Step Chain.
Export ListNotations.
Open Scope R_scope.

(* low/unit <= initial value <= high/unit *)
Record initial := Initial { initial_low : Z; initial_high : Z; initial_unit : Z }.
Definition exactly (a b : Z) : initial := Initial a a b.

(* The equations time_scale y_i' = right_i on [begin, final], both quotients of integers; the box of the initial values,
   and dyadic boxes that contain it; the steps. *)
Record certificate := Certificate {
  time_unit : Z; rights : list expr;
  begin_time : Z * Z; final_time : Z * Z; box : list initial;
  begin : num; box_centre : list num; box_size : list num; items : list item }.

Definition unknowns (c : certificate) : nat := length (rights c).
Definition quotient (a : Z * Z) : R := IZR (fst a) / IZR (snd a).
Definition initial_get (c : certificate) (i : nat) : initial := nth i (box c) (exactly 0 1).
Definition in_interval (b : initial) (v : R) : Prop :=
  IZR (initial_low b) / IZR (initial_unit b) <= v <= IZR (initial_high b) / IZR (initial_unit b).
Definition in_box (c : certificate) (v : nat -> R) : Prop :=
  forall i, (i < unknowns c)%nat -> in_interval (initial_get c i) (v i).

Definition start_states (c : certificate) : states :=
  let n := unknowns c in
  States (box_centre c) (grid n n (fun i j => if Nat.eqb i j then one else zero)) (seq 0 n) n (box_size c).

Definition initial_ok (c : certificate) (i : nat) : bool :=
  let b := initial_get c i in let u := num_of_Z (initial_unit b) in
  (0 <? initial_unit b)%Z &&
  leb (mul u (sub (vget (box_centre c) i) (vget (box_size c) i))) (num_of_Z (initial_low b)) &&
  leb (num_of_Z (initial_high b)) (mul u (add (vget (box_centre c) i) (vget (box_size c) i))).
Fixpoint end_time (b : num) (l : list item) : num :=
  match l with [] => b | (s, _) :: rest => end_time (next_begin b s) rest end.
Definition times_ok (c : certificate) : bool :=
  let (a, d) := begin_time c in let (f, g) := final_time c in
  (0 <? d)%Z && (0 <? g)%Z && (a * g <=? f * d)%Z &&
  leb (mul (num_of_Z d) (begin c)) (num_of_Z a) && leb (num_of_Z a) (mul (num_of_Z d) (begin c)) &&
  leb (num_of_Z f) (mul (num_of_Z g) (end_time (begin c) (items c))).
Definition claim_in_time (c : certificate) (k : claim) : bool :=
  let (a, d) := begin_time c in let (f, g) := final_time c in
  (0 <? denominator k)%Z && (a * denominator k <=? numerator k * d)%Z && (numerator k * g <=? f * denominator k)%Z.

Definition certificate_ok (c : certificate) : bool :=
  let n := unknowns c in
  negb (match items c with [] => true | _ => false end) && times_ok c && all n (initial_ok c) &&
  forallb (claim_in_time c) (all_claims (items c)) &&
  chain_ok n (time_unit c) (rights c) (begin c) (start_states c) (items c).

(* y solves the equations of the certificate on [a, e] *)
Definition solves (c : certificate) (a e : R) (y : nat -> R -> R) : Prop :=
  solution (unknowns c) (time_unit c) (rights c) a e y.

Lemma quotient_le a d f g : (0 < d)%Z -> (0 < g)%Z -> (a * g <= f * d)%Z -> quotient (a, d) <= quotient (f, g).
Proof.
  intros Hd Hg H. apply IZR_lt in Hd, Hg. apply IZR_le in H. rewrite !mult_IZR in H. unfold quotient; cbn [fst snd].
  apply Rmult_le_reg_l with (IZR d * IZR g); [apply Rmult_lt_0_compat; auto|].
  replace (IZR d * IZR g * (IZR a / IZR d)) with (IZR a * IZR g) by (field; lra).
  replace (IZR d * IZR g * (IZR f / IZR g)) with (IZR f * IZR d) by (field; lra). exact H.
Qed.

Section Sound.
Variable c : certificate.
Hypothesis Hc : certificate_ok c = true.
Let n := unknowns c.
Let T0 := quotient (begin_time c).
Let T := quotient (final_time c).

Lemma ok_parts : items c <> [] /\ times_ok c = true /\ (forall i, (i < n)%nat -> initial_ok c i = true) /\
  (forall k, In k (all_claims (items c)) -> claim_in_time c k = true) /\
  chain_ok n (time_unit c) (rights c) (begin c) (start_states c) (items c) = true.
Proof.
  unfold certificate_ok in Hc. cbv zeta in Hc. rewrite !Bool.andb_true_iff in Hc.
  destruct Hc as [[[[H1 H2] H3] H4] H5]. repeat split; auto.
  - intros E. rewrite E in H1. discriminate.
  - apply (all_ok _ _ H3).
  - rewrite forallb_forall in H4. exact H4.
Qed.

Lemma end_time_ok l : forall b, real (end_time b l) = real b + duration l.
Proof. induction l as [|[s k] l IH]; intros b; simpl; [ring|]. rewrite IH, next_begin_ok. ring. Qed.

Lemma times : T0 = real (begin c) /\ T0 <= T /\ T <= T0 + duration (items c).
Proof.
  destruct ok_parts as (_ & Ht & _). unfold times_ok in Ht. unfold T0, T.
  destruct (begin_time c) as [a d], (final_time c) as [f g]. rewrite !Bool.andb_true_iff in Ht.
  destruct Ht as [[[[[Hd Hg] Hle] H1] H2] H3]. apply Z.ltb_lt in Hd, Hg. apply Z.leb_le in Hle.
  assert (Q := quotient_le a d f g Hd Hg Hle). apply leb_ok in H1, H2, H3.
  rewrite real_mul, !real_num_of_Z in H1, H2, H3. rewrite end_time_ok in H3. apply IZR_lt in Hd, Hg.
  assert (E : quotient (a, d) = real (begin c)).
  { unfold quotient; cbn [fst snd]. apply Rmult_eq_reg_l with (IZR d); [|lra]. field_simplify; lra. }
  repeat split; auto. rewrite E. unfold quotient; cbn [fst snd].
  apply Rmult_le_reg_l with (IZR g); auto. field_simplify; lra.
Qed.

Lemma box_in_states v : in_box c v -> in_states n (start_states c) v.
Proof.
  intros Hv. destruct ok_parts as (_ & _ & Hi & _).
  exists (fun i => v i - real (vget (box_centre c) i)). unfold start_states; cbv zeta; simpl. fold n. split.
  - intros i Hin.
    rewrite (Sum_ext n _ (fun j => delta i j * (v j - real (vget (box_centre c) j)))).
    + rewrite Sum_delta by auto. ring.
    + intros j Hj. rewrite mget_grid by auto. unfold delta. destruct Nat.eqb; rewrite ?real_one, ?real_zero; reflexivity.
  - intros b Hb. unfold square.
    rewrite (Sum_ext n _ (fun i => delta b i * ((v i - real (vget (box_centre c) i)) * (v i - real (vget (box_centre c) i))))).
    2:{ intros i Hin. unfold member, block_of. rewrite seq_nth by auto. simpl. unfold delta. rewrite (Nat.eqb_sym i b). reflexivity. }
    rewrite Sum_delta by auto.
    assert (Ib := Hi b Hb). assert (Vb := Hv b Hb). unfold initial_ok, in_interval in *. cbv zeta in Ib.
    rewrite !Bool.andb_true_iff in Ib. destruct Ib as [[Hu H1] H2]. apply Z.ltb_lt, IZR_lt in Hu. apply leb_ok in H1, H2.
    rewrite real_mul, !real_num_of_Z, real_sub in H1. rewrite real_mul, !real_num_of_Z, real_add in H2.
    set (u := IZR (initial_unit (initial_get c b))) in *.
    set (m := real (vget (box_centre c) b)) in *. set (r := real (vget (box_size c) b)) in *.
    assert (L1 : m - r <= IZR (initial_low (initial_get c b)) / u).
    { apply Rmult_le_reg_l with u; auto. replace (u * (_ / u)) with (IZR (initial_low (initial_get c b))) by (field; lra). exact H1. }
    assert (L2 : IZR (initial_high (initial_get c b)) / u <= m + r).
    { apply Rmult_le_reg_l with u; auto. replace (u * (_ / u)) with (IZR (initial_high (initial_get c b))) by (field; lra). exact H2. }
    assert (A : Rabs (v b - m) <= r) by (apply Rabs_le; lra).
    rewrite <- (abs_square (v b - m)). apply Rmult_le_compat; auto using Rabs_pos.
Qed.

Lemma bounded e y : T0 <= e <= T -> solves c T0 e y -> in_box c (fun i => y i T0) ->
  forall i t, (i < n)%nat -> T0 <= t <= e -> Rabs (y i t) <= chain_bound n (items c).
Proof.
  intros He Hy Hb i t Hi Ht. destruct ok_parts as (Hne & _ & _ & _ & Hch). destruct times as (E0 & E1 & E2).
  assert (P := chain_sound n (time_unit c) (rights c) T0 e y Hy (items c) (begin c) (start_states c) Hch).
  rewrite <- E0 in P. specialize (P (Rle_refl _) (box_in_states _ Hb) t Ht).
  apply (chain_bound_ok n (time_unit c) (rights c) (items c) (begin c) (start_states c) t (fun i => y i t) i Hch); auto;
    rewrite <- E0; [exact P | lra].
Qed.

Lemma sensible : (forall i, (i < n)%nat -> below n (right (rights c) i) = true) /\ 0 < IZR (time_unit c).
Proof.
  destruct ok_parts as (Hne & _ & _ & _ & Hch). destruct (items c) as [|[s k] l]; [contradiction|].
  cbn [chain_ok] in Hch. rewrite !Bool.andb_true_iff in Hch. destruct Hch as [[H _] _].
  destruct (step_ok_parts _ _ _ _ _ _ H) as (_ & _ & P & Q & _). auto.
Qed.

(* There is a solution from each initial value in the box, *)
Theorem certified_existence v : in_box c v -> exists y, solves c T0 T y /\ forall i, (i < n)%nat -> y i T0 = v i.
Proof.
  intros Hv. destruct times as (_ & Hle & _). destruct sensible as [HF HQ].
  apply (existence n (time_unit c) (rights c) HF HQ T0 T v (Rmax 0 (chain_bound n (items c)))); [exact Hle | apply Rmax_l|].
  intros e y He Hy H0 i Hi. eapply Rle_trans; [|apply Rmax_r].
  apply (bounded e y He Hy); auto; [|lra]. intros j Hj. rewrite (H0 j Hj). apply Hv; auto.
Qed.

(* only one, *)
Theorem certified_uniqueness y1 y2 : solves c T0 T y1 -> solves c T0 T y2 -> in_box c (fun i => y1 i T0) ->
  (forall i, (i < n)%nat -> y1 i T0 = y2 i T0) -> forall i t, (i < n)%nat -> T0 <= t <= T -> y1 i t = y2 i t.
Proof.
  intros H1 H2 Hb H0. destruct times as (_ & Hle & _). destruct sensible as [HF HQ].
  assert (Hb2 : in_box c (fun i => y2 i T0)) by (intros j Hj; rewrite <- H0 by auto; apply Hb; auto).
  apply (uniqueness n (time_unit c) (rights c) HF T0 T (chain_bound n (items c)) y1 y2 Hle H1 H2); auto.
  intros i t Hi Ht. split; [apply (bounded T y1) | apply (bounded T y2)]; auto; lra.
Qed.

(* and its values are in the claimed intervals. *)
Theorem certified_values y : solves c T0 T y -> in_box c (fun i => y i T0) ->
  forall k, In k (all_claims (items c)) -> claim_holds k (y (index k) (claim_time k)).
Proof.
  intros Hy Hb. destruct ok_parts as (_ & _ & _ & Hk & Hch). destruct times as (E0 & _ & _).
  apply (claims_sound n (time_unit c) (rights c) y (items c) (begin c) (start_states c) Hch).
  intros k Hin. apply (chain_sound n (time_unit c) (rights c) T0 T y Hy (items c) (begin c) (start_states c) Hch); rewrite <- E0.
  - apply Rle_refl.
  - apply box_in_states, Hb.
  - specialize (Hk k Hin). unfold claim_in_time in Hk. unfold T0, T.
    assert (Ht : times_ok c = true) by apply ok_parts. unfold times_ok in Ht.
    destruct (begin_time c) as [a d], (final_time c) as [f g]. rewrite !Bool.andb_true_iff in Hk. rewrite !Bool.andb_true_iff in Ht.
    destruct Hk as [[H1 H2] H3]. destruct Ht as [[[[[Hd Hg] _] _] _] _].
    apply Z.ltb_lt in H1, Hd, Hg. apply Z.leb_le in H2, H3. split.
    + apply (quotient_le a d (numerator k) (denominator k)); auto.
    + apply (quotient_le (numerator k) (denominator k) f g); auto.
Qed.
End Sound.

(* For the statements of examples: unknowns by their numbers. *)
Definition functions (l : list (R -> R)) (i : nat) : R -> R := nth i l (fun _ => 0).

(* The k-th claim of a list, with its time as a statement writes it. *)
Lemma claim_of l (y : nat -> R -> R) : (forall k, In k l -> claim_holds k (y (index k) (claim_time k))) ->
  forall i, (i < length l)%nat -> let k := nth i l (Claim 0 1 0 0 0 1) in
  forall t, claim_time k = t -> claim_holds k (y (index k) t).
Proof. intros H i Hi k t <-. apply H, nth_In, Hi. Qed.

(* The parts of a conjunction, and nothing else. *)
Ltac conjuncts := lazymatch goal with |- _ /\ _ => split; [conjuncts | conjuncts] | |- _ => idtac end.
