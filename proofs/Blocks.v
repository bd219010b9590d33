(* Vectors whose entries belong to blocks; Euclidean norms of blocks by their squares; bounds of quadratic forms. *)
Require Import Reals Lra Lia Arith.
From Libration Require Import Sums.
Open Scope R_scope.

Lemma abs_le_of_square x y : 0 <= y -> x * x <= y * y -> Rabs x <= y.
Proof. intros Hy H. apply Rabs_le. split; nra. Qed.

Lemma cauchy n f g :
  Sum n (fun i => f i * g i) * Sum n (fun i => f i * g i) <= Sum n (fun i => f i * f i) * Sum n (fun i => g i * g i).
Proof.
  induction n as [|n IH]; simpl; [lra|].
  set (P := Sum n (fun i => f i * g i)) in *. set (F := Sum n (fun i => f i * f i)) in *.
  set (G := Sum n (fun i => g i * g i)) in *. set (a := f n). set (b := g n).
  assert (HF : 0 <= F) by (apply Sum_nonneg; intros; apply Rle_0_sqr).
  assert (HG : 0 <= G) by (apply Sum_nonneg; intros; apply Rle_0_sqr).
  assert (Q : 0 <= F * (b * b) + G * (a * a)).
  { assert (0 <= F * (b * b)) by (apply Rmult_le_pos; auto; apply Rle_0_sqr).
    assert (0 <= G * (a * a)) by (apply Rmult_le_pos; auto; apply Rle_0_sqr). lra. }
  assert (Cross : Rabs (2 * P * (a * b)) <= F * (b * b) + G * (a * a)).
  { apply abs_le_of_square; auto.
    assert (S1 : P * P * (a * b * (a * b)) <= F * G * (a * b * (a * b))) by (apply Rmult_le_compat_r; auto; apply Rle_0_sqr).
    assert (S2 := Rle_0_sqr (F * (b * b) - G * (a * a))). unfold Rsqr in S2. lra. }
  apply Rle_trans with (2 := Req_le _ _ (eq_refl)).
  assert (A := Rle_abs (2 * P * (a * b))). lra.
Qed.

Section Blocks.
Variables (n m : nat) (block : nat -> nat).

(* 1 for the entries of block b *)
Definition member (b i : nat) : R := if Nat.eqb (block i) b then 1 else 0.
Definition square (b : nat) (c : nat -> R) : R := Sum n (fun i => member b i * (c i * c i)).
(* the square of the Frobenius norm of a block *)
Definition frobenius (b d : nat) (M : nat -> nat -> R) : R :=
  Sum n (fun i => member b i * Sum n (fun j => member d j * (M i j * M i j))).
Definition form (b d : nat) (M : nat -> nat -> R) (c : nat -> R) : R :=
  Sum n (fun i => member b i * (c i * Sum n (fun j => member d j * (M i j * c j)))).

Lemma member_idem b i : member b i * member b i = member b i.
Proof. unfold member. destruct Nat.eqb; ring. Qed.
Lemma member_nonneg b i : 0 <= member b i.
Proof. unfold member. destruct Nat.eqb; lra. Qed.
Lemma square_nonneg b c : 0 <= square b c.
Proof. apply Sum_nonneg. intros. apply Rmult_le_pos; [apply member_nonneg | apply Rle_0_sqr]. Qed.

Lemma block_cauchy b f g :
  Sum n (fun i => member b i * (f i * g i)) * Sum n (fun i => member b i * (f i * g i)) <= square b f * square b g.
Proof.
  assert (E : forall h k, Sum n (fun i => member b i * (h i * k i)) = Sum n (fun i => member b i * h i * (member b i * k i))).
  { intros. apply Sum_ext. intros. rewrite <- (member_idem b i) at 1. ring. }
  unfold square. rewrite !E. apply cauchy.
Qed.

(* <f_b, g_b> <= r R for |f_b| <= r, |g_b| <= R *)
Lemma block_product b f g r R : 0 <= r -> 0 <= R -> square b f <= r * r -> square b g <= R * R ->
  Rabs (Sum n (fun i => member b i * (f i * g i))) <= r * R.
Proof.
  intros Hr HR Hf Hg. apply abs_le_of_square; [apply Rmult_le_pos; auto|].
  eapply Rle_trans; [apply block_cauchy|].
  replace (r * R * (r * R)) with (r * r * (R * R)) by ring.
  apply Rmult_le_compat; auto using square_nonneg.
Qed.

Lemma form_bound b d M c r R N : 0 <= r -> 0 <= R -> 0 <= N -> square b c <= r * r -> square d c <= R * R ->
  frobenius b d M <= N * N -> Rabs (form b d M c) <= r * (N * R).
Proof.
  intros Hr HR HN Hb Hd HF. unfold form.
  apply (block_product b c (fun i => Sum n (fun j => member d j * (M i j * c j)))); auto; [apply Rmult_le_pos; auto|].
  apply Rle_trans with (Sum n (fun i => member b i * Sum n (fun j => member d j * (M i j * M i j)) * (R * R))).
  - apply Sum_le. intros i Hi. rewrite Rmult_assoc. apply Rmult_le_compat_l; [apply member_nonneg|].
    eapply Rle_trans; [apply block_cauchy|]. apply Rmult_le_compat_l; auto. apply (square_nonneg d (M i)).
  - rewrite Sum_scal_r. replace (N * R * (N * R)) with (N * N * (R * R)) by ring.
    apply Rmult_le_compat_r; auto. apply Rle_0_sqr.
Qed.

Lemma frobenius_le b d M C : (forall i j, (i < n)%nat -> (j < n)%nat -> Rabs (M i j) <= C i j) ->
  frobenius b d M <= frobenius b d C.
Proof.
  intros H. apply Sum_le. intros i Hi. apply Rmult_le_compat_l; [apply member_nonneg|].
  apply Sum_le. intros j Hj. apply Rmult_le_compat_l; [apply member_nonneg|].
  specialize (H i j Hi Hj). assert (P := Rabs_pos (M i j)).
  replace (M i j * M i j) with (Rabs (M i j) * Rabs (M i j)) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
  apply Rmult_le_compat; auto.
Qed.

Lemma square_le b f g : (forall i, (i < n)%nat -> Rabs (f i) <= g i) -> square b f <= square b g.
Proof.
  intros H. apply Sum_le. intros i Hi. apply Rmult_le_compat_l; [apply member_nonneg|].
  specialize (H i Hi). assert (P := Rabs_pos (f i)).
  replace (f i * f i) with (Rabs (f i) * Rabs (f i)) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
  apply Rmult_le_compat; auto.
Qed.

Lemma form_plus b d M N c : form b d (fun i j => M i j + N i j) c = form b d M c + form b d N c.
Proof.
  unfold form. rewrite <- Sum_plus. apply Sum_ext. intros i _.
  rewrite (Sum_ext n _ (fun j => member d j * (M i j * c j) + member d j * (N i j * c j))) by (intros; ring).
  rewrite Sum_plus. ring.
Qed.

Hypothesis block_below : forall i, (i < n)%nat -> (block i < m)%nat.

Lemma Sum_members f : Sum n f = Sum m (fun b => Sum n (fun i => member b i * f i)).
Proof.
  rewrite Sum_swap. apply Sum_ext. intros i Hi.
  rewrite (Sum_ext m _ (fun b => delta (block i) b * f i)) by (intros; reflexivity).
  rewrite Sum_scal_r.
  rewrite (Sum_ext m _ (fun b => delta (block i) b * 1)) by (intros; ring).
  rewrite Sum_delta by auto. ring.
Qed.

Lemma form_total b M c :
  Sum n (fun i => member b i * (c i * Sum n (fun j => M i j * c j))) = Sum m (fun d => form b d M c).
Proof.
  unfold form. rewrite Sum_swap. apply Sum_ext. intros i Hi.
  rewrite Sum_scal. f_equal. rewrite Sum_scal. f_equal. apply Sum_members.
Qed.

(* |sum of v_i c_i| <= sum over the blocks of the product of the norms *)
Lemma row_bound v c nv r : (forall b, (b < m)%nat -> 0 <= nv b /\ square b v <= nv b * nv b) ->
  (forall b, (b < m)%nat -> 0 <= r b /\ square b c <= r b * r b) ->
  Rabs (Sum n (fun i => v i * c i)) <= Sum m (fun b => nv b * r b).
Proof.
  intros Hv Hc. rewrite Sum_members. eapply Rle_trans; [apply Sum_abs|]. apply Sum_le. intros b Hb.
  destruct (Hv b Hb), (Hc b Hb). apply block_product; auto.
Qed.

(* Every entry is at most the norm of its block. *)
Lemma entry_bound c r i : (i < n)%nat -> 0 <= r -> square (block i) c <= r * r -> Rabs (c i) <= r.
Proof.
  intros Hi Hr H. apply abs_le_of_square; auto. eapply Rle_trans; [|exact H].
  unfold square. apply Rle_trans with (member (block i) i * (c i * c i)).
  - unfold member. rewrite Nat.eqb_refl. lra.
  - apply (Sum_term_le n i (fun i0 => member (block i) i0 * (c i0 * c i0))); auto. intros.
    apply Rmult_le_pos; [apply member_nonneg | apply Rle_0_sqr].
Qed.
End Blocks.
