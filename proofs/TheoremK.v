(* Theorem K: a tube in a moving frame, for any field whose linear part is known with bounds of its change. *)
Require Import Reals Lra Lia Arith.
From Libration Require Import Sums Matrices Derivative Exit Blocks.
Open Scope R_scope.

(* The coordinates c = W (y - p) in a differentiable frame V with the inverse W. Nothing is assumed of the derivative of
   W; its entries are bounded. *)
Section Frame.
Variables (n : nat) (s u K : R).
Variables (w dw : nat -> R -> R) (V dV W : nat -> nat -> R -> R).
Definition at_time (M : nat -> nat -> R -> R) (t : R) : matrix := fun i j => M i j t.
Hypothesis Hw : forall i t, (i < n)%nat -> s <= t <= u -> deriv_on s u (w i) t (dw i t).
Hypothesis HV : forall i j t, (i < n)%nat -> (j < n)%nat -> s <= t <= u -> deriv_on s u (V i j) t (dV i j t).
Hypothesis HWV : forall t, s <= t <= u -> is_one n (prod n (at_time W t) (at_time V t)).
Hypothesis HK : forall i j t, (i < n)%nat -> (j < n)%nat -> s <= t <= u -> Rabs (W i j t) <= K.

Definition coordinate (j : nat) (t : R) : R := Sum n (fun k => W j k t * w k t).

Lemma frame_of_coordinates i t : (i < n)%nat -> s <= t <= u -> Sum n (fun j => V i j t * coordinate j t) = w i t.
Proof.
  intros Hi Ht. assert (VW := left_inverse_right _ _ _ (HWV t Ht)).
  rewrite <- (apply_one n _ (fun k => w k t) i VW Hi), apply_prod. reflexivity.
Qed.

Lemma coordinate_frozen j t x : (j < n)%nat -> s <= t <= u -> s <= x <= u ->
  Sum n (fun k => W j k t * (w k x - Sum n (fun l => (V k l x - V k l t) * coordinate l x))) = coordinate j x.
Proof.
  intros Hj Ht Hx.
  rewrite <- (apply_one n _ (fun l => coordinate l x) j (HWV t Ht) Hj), apply_prod.
  apply Sum_ext. intros k Hk. unfold at_time at 1. f_equal. rewrite <- (frame_of_coordinates k x Hk Hx), <- Sum_minus.
  apply Sum_ext. intros; unfold at_time; ring.
Qed.

Lemma coordinate_bounded j t : (j < n)%nat -> s <= t <= u ->
  exists B d, 0 < d /\ forall x, s <= x <= u -> Rabs (x - t) < d -> Rabs (coordinate j x) <= B.
Proof.
  intros Hj Ht.
  destruct (common_distance n (fun k d => forall x, s <= x <= u -> Rabs (x - t) < d -> Rabs (w k x) <= Rabs (w k t) + 1))
    as (d & Hd & H).
  - intros k d d' _ H Hle x Hx Hxd. apply H; auto; lra.
  - intros k Hk. destruct (deriv_cont _ _ _ _ _ (Hw k t Hk Ht) 1 Rlt_0_1) as (d & Hd & H). exists d; split; auto.
    intros x Hx Hxd. specialize (H x Hx Hxd). replace (w k x) with (w k t + (w k x - w k t)) by ring.
    eapply Rle_trans; [apply Rabs_triang | lra].
  - exists (Sum n (fun k => K * (Rabs (w k t) + 1))), d. split; auto. intros x Hx Hxd.
    unfold coordinate. apply Sum_abs_mul; intros; auto.
Qed.

Lemma frame_change k l t : (k < n)%nat -> (l < n)%nat -> s <= t <= u ->
  deriv_on s u (fun x => V k l x - V k l t) t (dV k l t).
Proof.
  intros. apply deriv_eq with (dV k l t - 0); [ring|]. apply deriv_minus; auto using deriv_const.
Qed.

Lemma coordinate_cont j t : (j < n)%nat -> s <= t <= u -> cont_on s u (coordinate j) t.
Proof.
  intros Hj Ht. apply cont_ext with (2 := fun x Hx => coordinate_frozen j t x Hj Ht Hx); auto.
  apply cont_Sum. intros k Hk. apply cont_scal.
  assert (P : cont_on s u (fun x => w k x + -1 * Sum n (fun l => (V k l x - V k l t) * coordinate l x)) t).
  { apply cont_plus; [apply deriv_cont with (dw k t); auto|]. apply cont_scal, cont_Sum. intros l Hl.
    destruct (coordinate_bounded l t Hl Ht) as (B & d & Hd & HB).
    apply cont_vanishing with (g := fun x => V k l x - V k l t) (K := B) (d0 := d); auto; [ring|].
    apply deriv_cont with (dV k l t). apply frame_change; auto. }
  eapply cont_ext; [exact Ht | | exact P]. intros; simpl; ring.
Qed.

Lemma coordinate_deriv j t : (j < n)%nat -> s <= t <= u ->
  deriv_on s u (coordinate j) t (Sum n (fun k => W j k t * (dw k t - Sum n (fun l => dV k l t * coordinate l t)))).
Proof.
  intros Hj Ht. apply deriv_ext with (2 := fun x Hx => coordinate_frozen j t x Hj Ht Hx); auto.
  apply deriv_Sum. intros k Hk. apply deriv_scal, deriv_minus; auto.
  apply deriv_Sum. intros l Hl. apply deriv_vanishing with (g := fun x => V k l x - V k l t); [ring | |].
  - apply frame_change; auto.
  - apply coordinate_cont; auto.
Qed.
End Frame.

(* Theorem K. y is any solution of y' = f on [s, u]; p, V, U are an approximation, its frame, and a matrix with U V near 1. *)
Section TheoremK.
Variables (n m : nat) (block : nat -> nat) (s u : R).
Variables (y p dp : nat -> R -> R) (V dV U : nat -> nat -> R -> R) (f : nat -> R -> (nat -> R) -> R).
Hypothesis Hsu : s <= u.
Hypothesis Hblock : forall i, (i < n)%nat -> (block i < m)%nat.
Hypothesis Hy : forall i t, (i < n)%nat -> s <= t <= u -> deriv_on s u (y i) t (f i t (fun j => y j t)).
Hypothesis Hp : forall i t, (i < n)%nat -> s <= t <= u -> deriv_on s u (p i) t (dp i t).
Hypothesis HV : forall i j t, (i < n)%nat -> (j < n)%nat -> s <= t <= u -> deriv_on s u (V i j) t (dV i j t).
Hypothesis Hext : forall i t v v', (i < n)%nat -> (forall j, (j < n)%nat -> v j = v' j) -> f i t v = f i t v'.

(* z bounds U V - 1, and N bounds (U V)^-1. *)
Variables (z : matrix) (q rq : R).
Definition UV (t : R) : matrix := prod n (at_time U t) (at_time V t).
Hypothesis Hz : forall t i j, s <= t <= u -> (i < n)%nat -> (j < n)%nat -> Rabs (UV t i j - delta i j) <= z i j.
Hypothesis Hq : forall i, (i < n)%nat -> Sum n (z i) <= q.
Hypothesis Hq1 : q < 1.
Hypothesis Hrq : 1 <= rq * (1 - q).
Definition less_one (i j : nat) : R := z i j + Sum n (fun k => prod n z z i k) * rq.
Variable N : matrix.
Hypothesis HN : forall i j, (i < n)%nat -> (j < n)%nat -> delta i j + less_one i j <= N i j.

Definition X (t : R) : matrix :=
  match Rle_dec s t, Rle_dec t u with
  | left H1, left H2 =>
      proj1_sig (inverse n (UV t) (near_one_injective n (UV t) z q rq (fun i j => Hz t i j (conj H1 H2)) Hq Hq1 Hrq))
  | _, _ => delta
  end.
Definition W (i j : nat) (t : R) : R := prod n (X t) (at_time U t) i j.

Lemma X_inverse t : s <= t <= u -> is_one n (prod n (UV t) (X t)) /\ is_one n (prod n (X t) (UV t)).
Proof.
  intros Ht. unfold X. destruct (Rle_dec s t); [|lra]. destruct (Rle_dec t u); [|lra].
  destruct inverse as (B & HB). exact HB.
Qed.

Lemma X_less_one t i j : s <= t <= u -> (i < n)%nat -> (j < n)%nat -> Rabs (X t i j - delta i j) <= less_one i j.
Proof.
  intros Ht Hi Hj. apply (near_one_inverse n (UV t) z q rq (fun i j => Hz t i j Ht) Hq Hq1 Hrq); auto.
  apply X_inverse; auto.
Qed.

Lemma X_bound t i j : s <= t <= u -> (i < n)%nat -> (j < n)%nat -> Rabs (X t i j) <= N i j.
Proof.
  intros Ht Hi Hj. replace (X t i j) with (delta i j + (X t i j - delta i j)) by ring.
  eapply Rle_trans; [|apply HN; auto]. eapply Rle_trans; [apply Rabs_triang|].
  apply Rplus_le_compat; [|apply X_less_one; auto].
  unfold delta. destruct Nat.eqb; rewrite ?Rabs_R1, ?Rabs_R0; lra.
Qed.

Lemma W_inverse t : s <= t <= u -> is_one n (prod n (at_time W t) (at_time V t)).
Proof.
  intros Ht i j Hi Hj. change (prod n (at_time W t) (at_time V t) i j) with (prod n (prod n (X t) (at_time U t)) (at_time V t) i j).
  rewrite prod_assoc. apply (X_inverse t Ht); auto.
Qed.

(* Bounds on the step. *)
Variables (Ub Vb B0b Eb : matrix) (J : nat -> nat -> R -> R) (du rho : nat -> R).
Definition JVd (t : R) : matrix := fun k j => Sum n (fun l => J k l t * V l j t) - dV k j t.
Definition B0 (t : R) : matrix := fun i j => Sum n (fun k => U i k t * JVd t k j).
(* bounds of V^-1 (f_y V - V'), and of its distance from B0 *)
Variables (full more : matrix) (dd : nat -> R).
Let exact : matrix := prod n N (fun i j => B0b i j + prod n Ub (prod n Eb Vb) i j).
Hypothesis Hfull : forall i j, (i < n)%nat -> (j < n)%nat -> exact i j <= full i j /\ exact i j - B0b i j <= more i j.
Hypothesis HUb : forall t i j, s <= t <= u -> (i < n)%nat -> (j < n)%nat -> Rabs (U i j t) <= Ub i j.
Hypothesis HVb : forall t i j, s <= t <= u -> (i < n)%nat -> (j < n)%nat -> Rabs (V i j t) <= Vb i j.
Hypothesis HB0 : forall t i j, s <= t <= u -> (i < n)%nat -> (j < n)%nat -> Rabs (B0 t i j) <= B0b i j.
Hypothesis Hdu : forall t i, s <= t <= u -> (i < n)%nat ->
  Rabs (Sum n (fun k => U i k t * (f k t (fun j => p j t) - dp k t))) <= du i.
Hypothesis Hdd : forall i, (i < n)%nat -> apply n N du i <= dd i.
Hypothesis Hlinear : forall t w, s <= t <= u -> (forall i, (i < n)%nat -> Rabs (w i) <= rho i) ->
  exists E : matrix, (forall i j, (i < n)%nat -> (j < n)%nat -> Rabs (E i j) <= Eb i j) /\
  forall i, (i < n)%nat -> f i t (fun j => p j t + w j) = f i t (fun j => p j t) + Sum n (fun j => (J i j t + E i j) * w j).

(* The rates of the blocks, and the radii. *)
Variables (A : nat -> nat -> R) (L nd D : nat -> R) (r dr : nat -> R -> R) (eps0 : R).
Hypothesis HL : forall t b c, s <= t <= u -> (b < m)%nat -> form n block block b b (B0 t) c c <= L b * square n block b c.
Hypothesis Hnd : forall b, (b < m)%nat -> 0 <= nd b /\ frobenius n block block b b more <= nd b * nd b.
Hypothesis Hoff : forall b d, (b < m)%nat -> (d < m)%nat -> b <> d -> 0 <= A b d /\ frobenius n block block b d full <= A b d * A b d.
Hypothesis Hdiag : forall b, (b < m)%nat -> A b b = L b + nd b.
Hypothesis HD : forall b, (b < m)%nat -> 0 <= D b /\ square n block b dd <= D b * D b.
Hypothesis Heps : 0 < eps0.
Hypothesis Hr : forall b t, (b < m)%nat -> s <= t <= u -> 0 <= r b t /\ deriv_on s u (r b) t (dr b t).
Hypothesis Hgrow : forall b t, (b < m)%nat -> s <= t <= u -> Sum m (fun c => A b c * r c t) + D b <= dr b t.
Hypothesis Hrho : forall t c, s <= t <= u ->
  (forall b, (b < m)%nat -> square n block b c <= (r b t + eps0) * (r b t + eps0)) ->
  forall i, (i < n)%nat -> Rabs (Sum n (fun j => V i j t * c j)) <= rho i.

Definition in_tube (t : R) (v : nat -> R) : Prop := exists c,
  (forall i, (i < n)%nat -> v i = p i t + Sum n (fun j => V i j t * c j)) /\
  forall b, (b < m)%nat -> square n block b c <= r b t * r b t.

Let w i t := y i t - p i t.
Let dw i t := f i t (fun j => y j t) - dp i t.
Let c := coordinate n w W.

Lemma w_deriv i t : (i < n)%nat -> s <= t <= u -> deriv_on s u (w i) t (dw i t).
Proof. intros. apply deriv_minus; auto. Qed.

Lemma W_bounded : exists K, forall i j t, (i < n)%nat -> (j < n)%nat -> s <= t <= u -> Rabs (W i j t) <= K.
Proof.
  exists (Sum n (fun i => Sum n (fun j => prod n (fun i j => Rabs (N i j)) (fun i j => Rabs (Ub i j)) i j))).
  assert (Pos : forall i j, 0 <= prod n (fun i j => Rabs (N i j)) (fun i j => Rabs (Ub i j)) i j).
  { intros. apply Sum_nonneg. intros. apply Rmult_le_pos; apply Rabs_pos. }
  intros i j t Hi Hj Ht.
  apply Rle_trans with (prod n (fun i j => Rabs (N i j)) (fun i j => Rabs (Ub i j)) i j).
  - unfold W, prod, at_time. apply (Sum_abs_mul n (X t i) (fun k => U k j t)); intros.
    + eapply Rle_trans; [apply X_bound; auto | apply Rle_abs].
    + eapply Rle_trans; [apply HUb; auto | apply Rle_abs].
  - eapply Rle_trans; [|apply (Sum_term_le n i); auto].
    + apply (Sum_term_le n j (fun j => prod n _ _ i j)); auto.
    + intros. apply Sum_nonneg. auto.
Qed.

(* The right side of the equation of c. *)
Let dc j t := Sum n (fun k => W j k t * (dw k t - Sum n (fun l => dV k l t * c l t))).

Lemma c_deriv j t : (j < n)%nat -> s <= t <= u -> deriv_on s u (c j) t (dc j t).
Proof.
  destruct W_bounded as (K & HK). intros Hj Ht.
  apply (coordinate_deriv n s u K w dw V dV W); auto using w_deriv, W_inverse.
Qed.

Lemma c_frame i t : (i < n)%nat -> s <= t <= u -> Sum n (fun j => V i j t * c j t) = w i t.
Proof. apply (frame_of_coordinates n s u w V W); auto using W_inverse. Qed.

(* W times a vector, and W times a matrix, through U. *)
Lemma W_apply t v j : Sum n (fun k => W j k t * v k) = apply n (X t) (apply n (at_time U t) v) j.
Proof. exact (apply_prod n (X t) (at_time U t) v j). Qed.

Lemma c_linear t : s <= t <= u -> (forall i, (i < n)%nat -> Rabs (w i t) <= rho i) ->
  exists M d, (forall i j, (i < n)%nat -> (j < n)%nat -> Rabs (M i j - B0 t i j) <= more i j /\ Rabs (M i j) <= full i j) /\
  (forall i, (i < n)%nat -> Rabs (d i) <= dd i) /\
  forall j, (j < n)%nat -> dc j t = Sum n (fun i => M j i * c i t) + d j.
Proof.
  intros Ht Hw. destruct (Hlinear t (fun i => w i t) Ht Hw) as (E & HE & Hf).
  set (UEV := prod n (at_time U t) (prod n E (at_time V t))).
  assert (HUEV : forall i j, (i < n)%nat -> (j < n)%nat -> Rabs (UEV i j) <= prod n Ub (prod n Eb Vb) i j).
  { intros i j Hi Hj. apply (Sum_abs_mul n (at_time U t i) (fun k => prod n E (at_time V t) k j) (Ub i) (fun k => prod n Eb Vb k j));
      intros k Hk; [apply HUb; auto|].
    apply (Sum_abs_mul n (E k) (fun l => at_time V t l j) (Eb k) (fun l => Vb l j)); intros; [apply HE | apply HVb]; auto. }
  exists (prod n (X t) (fun i j => B0 t i j + UEV i j)),
    (fun i => apply n (X t) (apply n (at_time U t) (fun k => f k t (fun j => p j t) - dp k t)) i).
  split; [|split].
  - intros i j Hi Hj. split.
    + replace (prod n (X t) (fun i j => B0 t i j + UEV i j) i j - B0 t i j)
        with (Sum n (fun k => (X t i k - delta i k) * B0 t k j) + prod n (X t) UEV i j).
      2:{ unfold prod at 1 2. rewrite (Sum_ext n (fun k => (X t i k - delta i k) * B0 t k j)
            (fun k => X t i k * B0 t k j - delta i k * B0 t k j)) by (intros; ring).
          rewrite Sum_minus, (Sum_delta n i (fun k => B0 t k j)) by auto.
          rewrite (Sum_ext n (fun k => X t i k * (B0 t k j + UEV k j)) (fun k => X t i k * B0 t k j + X t i k * UEV k j))
            by (intros; ring). rewrite Sum_plus. ring. }
      eapply Rle_trans; [|apply (Hfull i j Hi Hj)].
      replace (exact i j - B0b i j) with (Sum n (fun k => (N i k - delta i k) * B0b k j) + prod n N (prod n Ub (prod n Eb Vb)) i j).
      2:{ unfold exact. unfold prod at 1 4.
          rewrite (Sum_ext n (fun k => N i k * (B0b k j + prod n Ub (prod n Eb Vb) k j))
            (fun k => (delta i k * B0b k j + (N i k - delta i k) * B0b k j) + N i k * prod n Ub (prod n Eb Vb) k j))
            by (intros; ring).
          rewrite !Sum_plus, (Sum_delta n i (fun k => B0b k j)) by auto. ring. }
      eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat.
      * apply Sum_abs_mul; intros k Hk; [|apply HB0; auto].
        eapply Rle_trans; [apply X_less_one; auto|]. specialize (HN i k Hi Hk). lra.
      * apply Sum_abs_mul; intros; [apply X_bound | apply HUEV]; auto.
    + eapply Rle_trans; [|apply (Hfull i j Hi Hj)].
      apply Sum_abs_mul; intros k Hk; [apply X_bound; auto|].
      eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; [apply HB0 | apply HUEV]; auto.
  - intros i Hi. eapply Rle_trans; [|apply (Hdd i Hi)]. apply Sum_abs_mul; intros; [apply X_bound | apply Hdu]; auto.
  - intros j Hj. unfold dc.
    assert (R1 : forall k, (k < n)%nat -> dw k t - Sum n (fun l => dV k l t * c l t) =
       (f k t (fun j => p j t) - dp k t)
       + (apply n (JVd t) (fun l => c l t) k
          + apply n (prod n E (at_time V t)) (fun l => c l t) k)).
    { intros k Hk. unfold dw.
      rewrite (Hext k t (fun j => y j t) (fun j => p j t + w j t)) by (auto; intros; unfold w; ring).
      rewrite (Hf k Hk). unfold Rminus at 1.
      assert (S1 : apply n (JVd t) (fun l => c l t) k
         = Sum n (fun i => J k i t * w i t) - Sum n (fun l => dV k l t * c l t)).
      { unfold apply, JVd. rewrite (Sum_ext n _ (fun l => Sum n (fun i => J k i t * V i l t) * c l t - dV k l t * c l t)) by (intros; ring).
        rewrite Sum_minus. f_equal.
        change (Sum n (fun l => Sum n (fun i => J k i t * V i l t) * c l t))
          with (apply n (prod n (at_time J t) (at_time V t)) (fun l => c l t) k).
        rewrite apply_prod. apply Sum_ext. intros i Hi. unfold at_time at 1. f_equal. apply (c_frame i t Hi Ht). }
      assert (S2 : apply n (prod n E (at_time V t)) (fun l => c l t) k = Sum n (fun i => E k i * w i t)).
      { rewrite apply_prod. apply Sum_ext. intros i Hi. f_equal. apply (c_frame i t Hi Ht). }
      rewrite S1, S2, (Sum_ext n (fun j => (J k j t + E k j) * w j t) (fun j => J k j t * w j t + E k j * w j t)) by (intros; ring).
      rewrite Sum_plus. ring. }
    rewrite (Sum_ext n _ (fun k => W j k t * (f k t (fun j => p j t) - dp k t) +
       W j k t * (apply n (JVd t) (fun l => c l t) k
          + apply n (prod n E (at_time V t)) (fun l => c l t) k))).
    2:{ intros k Hk. rewrite (R1 k Hk). ring. }
    rewrite Sum_plus, Rplus_comm, !W_apply. f_equal.
    change (Sum n (fun i => prod n (X t) (fun i j => B0 t i j + UEV i j) j i * c i t))
      with (apply n (prod n (X t) (fun i j => B0 t i j + UEV i j)) (fun i => c i t) j).
    rewrite apply_prod. apply apply_ext. intros i Hi.
    transitivity (apply n (at_time U t) (apply n (JVd t) (fun l => c l t)) i
      + apply n (at_time U t) (apply n (prod n E (at_time V t)) (fun l => c l t)) i).
    { unfold apply at 1 4 6. rewrite <- Sum_plus. apply Sum_ext; intros; ring. }
    rewrite <- !apply_prod. unfold apply. rewrite <- Sum_plus. apply Sum_ext. intros l Hl.
    rewrite <- Rmult_plus_distr_r. reflexivity.
Qed.

Let qb b t := square n block b (fun j => c j t).
Let dqb b t := 2 * Sum n (fun i => member block b i * (c i t * dc i t)).

Lemma qb_deriv b t : s <= t <= u -> deriv_on s u (qb b) t (dqb b t).
Proof.
  intros Ht. unfold qb, square, dqb. rewrite <- Sum_scal. apply deriv_Sum. intros i Hi.
  apply deriv_eq with (member block b i * (dc i t * c i t + c i t * dc i t)); [ring|].
  apply deriv_scal, deriv_mult; apply c_deriv; auto.
Qed.

Lemma qb_growth : growth m qb dqb r A D u eps0 s.
Proof.
  intros t rh Ht HR b Hb Hq0. assert (Ht' : s <= t <= u) by lra.
  assert (Hw : forall i, (i < n)%nat -> Rabs (w i t) <= rho i).
  { intros i Hi. rewrite <- (c_frame i t Hi Ht'). apply (Hrho t (fun j => c j t) Ht'); auto.
    intros d Hd. destruct (HR d Hd) as [P1 P2]. eapply Rle_trans; [exact P2|]. apply Rmult_le_compat; lra. }
  destruct (c_linear t Ht' Hw) as (M & d & HM & Hd & Hdc).
  destruct (HR b Hb) as [[Rb _] Qb]. unfold dqb.
  rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|].
  rewrite (Sum_ext n _ (fun i => member block b i * (c i t * Sum n (fun j => M i j * c j t)) + member block b i * (c i t * d i)))
    by (intros i Hi; rewrite (Hdc i Hi); ring).
  rewrite Sum_plus, (form_total n m block Hblock block b M (fun i => c i t) (fun i => c i t)), Rmult_plus_distr_l. apply Rplus_le_compat.
  - rewrite <- Sum_scal. apply Sum_le. intros e He. destruct (HR e He) as [[Re _] Qe].
    destruct (Nat.eq_dec b e) as [<- | Hne].
    + rewrite (Hdiag b Hb).
      assert (E : form n block block b b M (fun i => c i t) (fun i => c i t)
         = form n block block b b (B0 t) (fun i => c i t) (fun i => c i t)
         + form n block block b b (fun i j => M i j - B0 t i j) (fun i => c i t) (fun i => c i t)).
      { rewrite <- form_plus. unfold form. apply Sum_ext. intros i Hi. do 2 f_equal. apply Sum_ext. intros. ring. }
      rewrite E. assert (P1 := HL t b (fun i => c i t) Ht' Hb). fold (qb b t) in P1. rewrite Hq0 in P1.
      destruct (Hnd b Hb) as [Nd Fr].
      assert (P2 : Rabs (form n block block b b (fun i j => M i j - B0 t i j) (fun i => c i t) (fun i => c i t)) <= rh b * (nd b * rh b)).
      { apply form_bound; auto. eapply Rle_trans; [apply frobenius_le with (C := more); intros; apply HM; auto | exact Fr]. }
      assert (P3 := Rle_abs (form n block block b b (fun i j => M i j - B0 t i j) (fun i => c i t) (fun i => c i t))).
      rewrite Rmult_plus_distr_r, Rmult_plus_distr_l. lra.
    + destruct (Hoff b e Hb He Hne) as [Na Fr]. eapply Rle_trans; [apply Rle_abs|].
      apply form_bound; auto. eapply Rle_trans; [apply frobenius_le with (C := full); intros; apply HM; auto | exact Fr].
  - destruct (HD b Hb) as [Db Sq]. eapply Rle_trans; [apply Rle_abs|].
    apply block_product; auto. eapply Rle_trans; [apply square_le with (g := dd); exact Hd | exact Sq].
Qed.

Theorem theorem_K : in_tube s (fun i => y i s) -> forall t, s <= t <= u -> in_tube t (fun i => y i t).
Proof.
  intros (c0 & Hc0 & Hsq) t Ht.
  exists (fun j => c j t). split.
  { intros i Hi. rewrite (c_frame i t Hi Ht). unfold w. ring. }
  assert (KA : exists K, 0 < K /\ forall b, (b < m)%nat -> Sum m (fun c => Rabs (A b c)) <= K).
  { exists (Sum m (fun b => Sum m (fun c => Rabs (A b c))) + 1).
    assert (P : forall b, 0 <= Sum m (fun c => Rabs (A b c))) by (intros; apply Sum_nonneg; intros; apply Rabs_pos).
    split; [assert (0 <= Sum m (fun b => Sum m (fun c => Rabs (A b c)))) by (apply Sum_nonneg; auto); lra|].
    intros b Hb. assert (T := Sum_term_le m b (fun b => Sum m (fun c => Rabs (A b c))) Hb (fun b _ => P b)). simpl in T. lra. }
  destruct KA as (K & HK0 & HK).
  intros b Hb. apply (tube_of_growth m qb dqb r dr A D u eps0 Heps K HK HK0 s); auto.
  - apply qb_growth.
  - intros z0 Hz0 d Hd. assert (Hz0' : s <= z0 <= u) by lra. split; [apply Hr | apply Hgrow]; auto.
  - intros; apply qb_deriv; auto.
  - intros; apply Hr; auto.
  - intros d Hd. eapply Rle_trans; [right | exact (Hsq d Hd)]. unfold qb, square. apply Sum_ext. intros i Hi.
    assert (Hs : s <= s <= u) by lra.
    assert (Ec : c i s = c0 i).
    { rewrite <- (apply_one n _ c0 i (W_inverse s Hs) Hi), apply_prod. unfold c, coordinate. apply Sum_ext.
      intros k Hk. unfold at_time at 1. f_equal. unfold w. rewrite (Hc0 k Hk). unfold apply, at_time. ring. }
    rewrite Ec. reflexivity.
  - intros; apply Hr; auto.
Qed.
End TheoremK.
