(* Finite sums of reals, and maxima of finitely many. *)
Require Import Reals Lra Lia Arith.
Open Scope R_scope.

Lemma Rabs_minus_le a b : Rabs (a - b) <= Rabs a + Rabs b.
Proof. unfold Rminus. rewrite <- (Rabs_Ropp b). apply Rabs_triang. Qed.

(* f 0 + ... + f (n - 1) *)
Fixpoint Sum (n : nat) (f : nat -> R) : R :=
  match n with O => 0 | S k => Sum k f + f k end.

Lemma Sum_ext n f g : (forall i, (i < n)%nat -> f i = g i) -> Sum n f = Sum n g.
Proof. induction n; simpl; intros H; auto. rewrite IHn, H; auto. Qed.

Lemma Sum_le n f g : (forall i, (i < n)%nat -> f i <= g i) -> Sum n f <= Sum n g.
Proof.
  induction n; simpl; intros H; [lra|].
  assert (Sum n f <= Sum n g) by (apply IHn; intros; apply H; lia).
  assert (f n <= g n) by (apply H; lia). lra.
Qed.

Lemma Sum_plus n f g : Sum n (fun i => f i + g i) = Sum n f + Sum n g.
Proof. induction n; simpl; [ring|]. rewrite IHn; ring. Qed.

Lemma Sum_minus n f g : Sum n (fun i => f i - g i) = Sum n f - Sum n g.
Proof. induction n; simpl; [ring|]. rewrite IHn; ring. Qed.

Lemma Sum_scal n c f : Sum n (fun i => c * f i) = c * Sum n f.
Proof. induction n; simpl; [ring|]. rewrite IHn; ring. Qed.

Lemma Sum_scal_r n c f : Sum n (fun i => f i * c) = Sum n f * c.
Proof. induction n; simpl; [ring|]. rewrite IHn; ring. Qed.

Lemma Sum_zero n f : (forall i, (i < n)%nat -> f i = 0) -> Sum n f = 0.
Proof. induction n; simpl; intros H; auto. rewrite IHn, H; auto; ring. Qed.

Lemma Sum_swap n m f :
  Sum n (fun i => Sum m (fun j => f i j)) = Sum m (fun j => Sum n (fun i => f i j)).
Proof.
  induction n; simpl; [symmetry; apply Sum_zero; auto|]. rewrite IHn, <- Sum_plus. reflexivity.
Qed.

Lemma Sum_nonneg n f : (forall i, (i < n)%nat -> 0 <= f i) -> 0 <= Sum n f.
Proof. intros H. rewrite <- (Sum_zero n (fun _ => 0)) by auto. apply Sum_le; auto. Qed.

Lemma Sum_abs n f : Rabs (Sum n f) <= Sum n (fun i => Rabs (f i)).
Proof.
  induction n; simpl; [rewrite Rabs_R0; lra|].
  eapply Rle_trans; [apply Rabs_triang | lra].
Qed.

Lemma Sum_abs_mul n f g a b :
  (forall i, (i < n)%nat -> Rabs (f i) <= a i) -> (forall i, (i < n)%nat -> Rabs (g i) <= b i) ->
  Rabs (Sum n (fun i => f i * g i)) <= Sum n (fun i => a i * b i).
Proof.
  intros Hf Hg. eapply Rle_trans; [apply Sum_abs|]. apply Sum_le. intros i Hi.
  rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos.
Qed.

(* One term taken out. *)
Lemma Sum_pick n i f : (i < n)%nat ->
  Sum n f = f i + Sum n (fun j => if Nat.eqb j i then 0 else f j).
Proof.
  induction n; intros Hi; [lia|]. simpl.
  destruct (Nat.eq_dec i n) as [-> | Hne].
  - rewrite Nat.eqb_refl.
    rewrite (Sum_ext n (fun j => if Nat.eqb j n then 0 else f j) f); [ring|].
    intros j Hj. replace (Nat.eqb j n) with false; auto. symmetry; apply Nat.eqb_neq; lia.
  - rewrite IHn by lia. replace (Nat.eqb n i) with false by (symmetry; apply Nat.eqb_neq; lia). ring.
Qed.

Lemma Sum_term_le n i f : (i < n)%nat -> (forall j, (j < n)%nat -> 0 <= f j) -> f i <= Sum n f.
Proof.
  intros Hi H. rewrite (Sum_pick n i) by auto.
  assert (0 <= Sum n (fun j => if Nat.eqb j i then 0 else f j)); [|lra].
  apply Sum_nonneg. intros j Hj. destruct (Nat.eqb j i); [lra | auto].
Qed.

Definition delta (i j : nat) : R := if Nat.eqb i j then 1 else 0.

Lemma Sum_delta n i f : (i < n)%nat -> Sum n (fun j => delta i j * f j) = f i.
Proof.
  intros Hi. rewrite (Sum_pick n i) by auto. unfold delta. rewrite Nat.eqb_refl.
  rewrite Sum_zero; [ring|]. intros j _. rewrite (Nat.eqb_sym i j). destruct (Nat.eqb j i); ring.
Qed.

Lemma Sum_delta_r n i f : (i < n)%nat -> Sum n (fun j => f j * delta j i) = f i.
Proof.
  intros Hi. rewrite <- (Sum_delta n i f Hi). apply Sum_ext. intros j _.
  unfold delta. rewrite (Nat.eqb_sym j i). ring.
Qed.

(* The largest of n numbers that are not negative. *)
Lemma largest n f : (forall i, (i < n)%nat -> 0 <= f i) ->
  exists m, 0 <= m /\ (forall i, (i < n)%nat -> f i <= m) /\ (m = 0 \/ exists i, (i < n)%nat /\ m = f i).
Proof.
  induction n; intros H.
  - exists 0. repeat split; [lra | intros; lia | auto].
  - destruct IHn as (m & Hm & Hall & Hex); [intros; apply H; lia|].
    destruct (Rle_or_lt (f n) m) as [Hle | Hgt].
    + exists m. repeat split; auto.
      * intros i Hi. destruct (Nat.eq_dec i n) as [-> |]; auto. apply Hall; lia.
      * destruct Hex as [|(i & Hi & E)]; auto. right. exists i. split; auto.
    + exists (f n). repeat split; [apply H; lia | | right; exists n; auto].
      intros i Hi. destruct (Nat.eq_dec i n) as [-> |]; [lra|].
      assert (f i <= m) by (apply Hall; lia). lra.
Qed.

(* Finitely many statements that hold next to a point hold together. *)
Lemma common_distance n (P : nat -> R -> Prop) :
  (forall i d d', (i < n)%nat -> P i d -> d' <= d -> P i d') ->
  (forall i, (i < n)%nat -> exists d, 0 < d /\ P i d) ->
  exists d, 0 < d /\ forall i, (i < n)%nat -> P i d.
Proof.
  induction n; intros Hmon H.
  - exists 1. split; [lra | intros; lia].
  - destruct IHn as (d & Hd & HP).
    + intros i a b Hi. apply Hmon. lia.
    + intros; apply H; lia.
    + destruct (H n) as (d' & Hd' & HP'); [lia|].
      exists (Rmin d d'). split; [apply Rmin_pos; auto|].
      intros i Hi. destruct (Nat.eq_dec i n) as [-> | Hne].
      * apply Hmon with d'; auto. apply Rmin_r.
      * apply Hmon with d; auto; [apply HP; lia | apply Rmin_l].
Qed.
