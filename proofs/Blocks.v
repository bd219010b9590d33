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

(* 1 for the entries of block b. Rows and columns of a matrix may have different blocks. *)
Definition member (block : nat -> nat) (b i : nat) : R := if Nat.eqb (block i) b then 1 else 0.
Definition square (n : nat) (block : nat -> nat) (b : nat) (c : nat -> R) : R :=
  Sum n (fun i => member block b i * (c i * c i)).
(* the square of the Frobenius norm of a block *)
Definition frobenius (n : nat) (block block' : nat -> nat) (b d : nat) (M : nat -> nat -> R) : R :=
  Sum n (fun i => member block b i * Sum n (fun j => member block' d j * (M i j * M i j))).
Definition form (n : nat) (block block' : nat -> nat) (b d : nat) (M : nat -> nat -> R) (u c : nat -> R) : R :=
  Sum n (fun i => member block b i * (u i * Sum n (fun j => member block' d j * (M i j * c j)))).

Lemma member_idem block b i : member block b i * member block b i = member block b i.
Proof. unfold member. destruct Nat.eqb; ring. Qed.
Lemma member_nonneg block b i : 0 <= member block b i.
Proof. unfold member. destruct Nat.eqb; lra. Qed.
Lemma square_nonneg n block b c : 0 <= square n block b c.
Proof. apply Sum_nonneg. intros. apply Rmult_le_pos; [apply member_nonneg | apply Rle_0_sqr]. Qed.

Lemma abs_square x : Rabs x * Rabs x = x * x.
Proof. rewrite <- Rabs_mult. apply Rabs_pos_eq, Rle_0_sqr. Qed.

Lemma square_le n block b f g : (forall i, (i < n)%nat -> Rabs (f i) <= g i) -> square n block b f <= square n block b g.
Proof.
  intros H. apply Sum_le. intros i Hi. apply Rmult_le_compat_l; [apply member_nonneg|].
  rewrite <- (abs_square (f i)). apply Rmult_le_compat; auto using Rabs_pos.
Qed.

Lemma frobenius_le n block block' b d M C : (forall i j, (i < n)%nat -> (j < n)%nat -> Rabs (M i j) <= C i j) ->
  frobenius n block block' b d M <= frobenius n block block' b d C.
Proof.
  intros H. apply Sum_le. intros i Hi. apply Rmult_le_compat_l; [apply member_nonneg|].
  apply (square_le n block' d (M i) (C i)). auto.
Qed.

Lemma block_cauchy n block b f g :
  Sum n (fun i => member block b i * (f i * g i)) * Sum n (fun i => member block b i * (f i * g i))
  <= square n block b f * square n block b g.
Proof.
  assert (E : forall h k, Sum n (fun i => member block b i * (h i * k i))
    = Sum n (fun i => member block b i * h i * (member block b i * k i))).
  { intros. apply Sum_ext. intros. rewrite <- (member_idem block b i) at 1. ring. }
  unfold square. rewrite !E. apply cauchy.
Qed.

(* <f_b, g_b> <= r s for |f_b| <= r, |g_b| <= s *)
Lemma block_product n block b f g r s : 0 <= r -> 0 <= s ->
  square n block b f <= r * r -> square n block b g <= s * s ->
  Rabs (Sum n (fun i => member block b i * (f i * g i))) <= r * s.
Proof.
  intros Hr Hs Hf Hg. apply abs_le_of_square; [apply Rmult_le_pos; auto|].
  eapply Rle_trans; [apply block_cauchy|].
  replace (r * s * (r * s)) with (r * r * (s * s)) by ring.
  apply Rmult_le_compat; auto using square_nonneg.
Qed.

(* <u_b, M_bd c_d> <= r (N s) for |u_b| <= r, |c_d| <= s and the norm N of M_bd *)
Lemma form_bound n block block' b d M u c r s N : 0 <= r -> 0 <= s -> 0 <= N ->
  square n block b u <= r * r -> square n block' d c <= s * s -> frobenius n block block' b d M <= N * N ->
  Rabs (form n block block' b d M u c) <= r * (N * s).
Proof.
  intros Hr Hs HN Hb Hd HF. unfold form.
  apply (block_product n block b u (fun i => Sum n (fun j => member block' d j * (M i j * c j)))); auto;
    [apply Rmult_le_pos; auto|].
  apply Rle_trans with (Sum n (fun i => member block b i * Sum n (fun j => member block' d j * (M i j * M i j)) * (s * s))).
  - apply Sum_le. intros i Hi. rewrite Rmult_assoc. apply Rmult_le_compat_l; [apply member_nonneg|].
    eapply Rle_trans; [apply block_cauchy|]. apply Rmult_le_compat_l; auto. apply (square_nonneg n block' d (M i)).
  - rewrite Sum_scal_r. replace (N * s * (N * s)) with (N * N * (s * s)) by ring.
    apply Rmult_le_compat_r; auto. apply Rle_0_sqr.
Qed.

Lemma form_plus n block block' b d M N u c :
  form n block block' b d (fun i j => M i j + N i j) u c = form n block block' b d M u c + form n block block' b d N u c.
Proof.
  unfold form. rewrite <- Sum_plus. apply Sum_ext. intros i _.
  rewrite (Sum_ext n _ (fun j => member block' d j * (M i j * c j) + member block' d j * (N i j * c j))) by (intros; ring).
  rewrite Sum_plus. ring.
Qed.

(* Sums over all entries as sums over the m blocks. *)
Section Total.
Variables (n m : nat) (block : nat -> nat).
Hypothesis below : forall i, (i < n)%nat -> (block i < m)%nat.

Lemma Sum_members f : Sum n f = Sum m (fun b => Sum n (fun i => member block b i * f i)).
Proof.
  rewrite Sum_swap. apply Sum_ext. intros i Hi.
  rewrite (Sum_ext m _ (fun b => delta (block i) b * f i)) by (intros; reflexivity).
  rewrite Sum_scal_r.
  rewrite (Sum_ext m _ (fun b => delta (block i) b * 1)) by (intros; ring).
  rewrite Sum_delta by auto. ring.
Qed.

Lemma form_total block' b M u c :
  Sum n (fun i => member block' b i * (u i * Sum n (fun j => M i j * c j))) = Sum m (fun d => form n block' block b d M u c).
Proof.
  unfold form. rewrite Sum_swap. apply Sum_ext. intros i Hi.
  rewrite Sum_scal. f_equal. rewrite Sum_scal. f_equal. apply Sum_members.
Qed.

(* |sum of v_i c_i| <= sum over the blocks of the product of the norms *)
Lemma row_bound v c nv r : (forall b, (b < m)%nat -> 0 <= nv b /\ square n block b v <= nv b * nv b) ->
  (forall b, (b < m)%nat -> 0 <= r b /\ square n block b c <= r b * r b) ->
  Rabs (Sum n (fun i => v i * c i)) <= Sum m (fun b => nv b * r b).
Proof.
  intros Hv Hc. rewrite Sum_members. eapply Rle_trans; [apply Sum_abs|]. apply Sum_le. intros b Hb.
  destruct (Hv b Hb), (Hc b Hb). apply block_product; auto.
Qed.

(* The norm of a block of G c + g. *)
Lemma block_triangle block' b v G c g F r k :
  (forall i, (i < n)%nat -> v i = Sum n (fun j => G i j * c j) + g i) ->
  (forall d, (d < m)%nat -> 0 <= F d /\ frobenius n block' block b d G <= F d * F d) ->
  (forall d, (d < m)%nat -> 0 <= r d /\ square n block d c <= r d * r d) ->
  0 <= k -> square n block' b g <= k * k ->
  square n block' b v <= (Sum m (fun d => F d * r d) + k) * (Sum m (fun d => F d * r d) + k).
Proof.
  intros Hv HF Hr Hk Hg. set (S := Sum m (fun d => F d * r d) + k).
  assert (HS : 0 <= Sum m (fun d => F d * r d)).
  { apply Sum_nonneg. intros d Hd. apply Rmult_le_pos; [apply HF | apply Hr]; auto. }
  set (x := sqrt (square n block' b v)).
  assert (Hx : 0 <= x) by apply sqrt_pos.
  assert (Exx : x * x = square n block' b v) by (apply sqrt_sqrt, square_nonneg).
  assert (L : x * x <= x * S).
  { rewrite Exx at 1. unfold square.
    rewrite (Sum_ext n _ (fun i => member block' b i * (v i * Sum n (fun j => G i j * c j)) + member block' b i * (v i * g i)))
      by (intros i Hi; rewrite (Hv i Hi) at 2; ring).
    rewrite Sum_plus, form_total. unfold S. rewrite Rmult_plus_distr_l. apply Rplus_le_compat.
    - rewrite <- Sum_scal. apply Sum_le. intros d Hd. eapply Rle_trans; [apply Rle_abs|].
      destruct (HF d Hd), (Hr d Hd). apply form_bound; auto. rewrite Exx. apply Rle_refl.
    - eapply Rle_trans; [apply Rle_abs|]. apply block_product; auto. rewrite Exx. apply Rle_refl. }
  rewrite <- Exx. destruct (Rle_lt_or_eq_dec 0 x Hx) as [Hp | <-].
  - assert (x <= S) by (apply Rmult_le_reg_l with x; auto). apply Rmult_le_compat; auto.
  - rewrite Rmult_0_l. apply Rle_0_sqr.
Qed.
End Total.
