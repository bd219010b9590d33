(* The derivative of a function relative to an interval, one-sided at its ends; the mean value inequality. *)
Require Import Reals Lra Lia.
From Libration Require Import Sums.
Open Scope R_scope.

(* g has the derivative l at t, as a function on [s, u] *)
Definition deriv_on (s u : R) (g : R -> R) (t l : R) : Prop :=
  forall eps, 0 < eps -> exists d, 0 < d /\
    forall x, s <= x <= u -> Rabs (x - t) < d -> Rabs (g x - g t - l * (x - t)) <= eps * Rabs (x - t).

Definition cont_on (s u : R) (g : R -> R) (t : R) : Prop :=
  forall eps, 0 < eps -> exists d, 0 < d /\
    forall x, s <= x <= u -> Rabs (x - t) < d -> Rabs (g x - g t) < eps.

(* From x < Rmin a b: x < a and x < b. *)
Ltac split_min H :=
  match type of H with _ < Rmin ?a ?b =>
    let H1 := fresh in let H2 := fresh in
    assert (H1 := Rlt_le_trans _ _ _ H (Rmin_l a b)); assert (H2 := Rlt_le_trans _ _ _ H (Rmin_r a b)) end.

Lemma Rabs_le_both a b : Rabs a <= b <-> - b <= a <= b.
Proof.
  split; [|apply Rabs_le]. intros H. assert (A := Rle_abs a). assert (B := Rle_abs (- a)).
  rewrite Rabs_Ropp in B. lra.
Qed.

Lemma deriv_cont s u g t l : deriv_on s u g t l -> cont_on s u g t.
Proof.
  intros H eps He. destruct (H 1 Rlt_0_1) as (d & Hd & H1).
  set (K := 1 + Rabs l). assert (HK : 0 < K) by (unfold K; generalize (Rabs_pos l); lra).
  exists (Rmin d (eps / K)). split.
  { apply Rmin_pos; auto. apply Rdiv_lt_0_compat; auto. }
  intros x Hx Hd'. split_min Hd'. specialize (H1 x Hx H0).
  replace (g x - g t) with ((g x - g t - l * (x - t)) + l * (x - t)) by ring.
  eapply Rle_lt_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
  assert (H4 : K * Rabs (x - t) < eps).
  { apply Rmult_lt_compat_l with (r := K) in H2; auto.
    replace (K * (eps / K)) with eps in H2 by (field; lra). exact H2. }
  unfold K in H4. lra.
Qed.

Lemma deriv_eq s u g t l m : l = m -> deriv_on s u g t l -> deriv_on s u g t m.
Proof. intros ->; auto. Qed.

(* Functions that agree on the interval have the same derivative. *)
Lemma deriv_ext s u g h t l : s <= t <= u -> (forall x, s <= x <= u -> g x = h x) ->
  deriv_on s u g t l -> deriv_on s u h t l.
Proof.
  intros Ht E H eps He. destruct (H eps He) as (d & Hd & H1). exists d; split; auto.
  intros x Hx Hd'. rewrite <- !E by auto. auto.
Qed.

Lemma cont_ext s u g h t : s <= t <= u -> (forall x, s <= x <= u -> g x = h x) ->
  cont_on s u g t -> cont_on s u h t.
Proof.
  intros Ht E H eps He. destruct (H eps He) as (d & Hd & H1). exists d; split; auto.
  intros x Hx Hd'. rewrite <- !E by auto. auto.
Qed.

Lemma deriv_sub_interval s u a b g t l : s <= a -> b <= u -> deriv_on s u g t l -> deriv_on a b g t l.
Proof.
  intros Ha Hb H e He. destruct (H e He) as (d & Hd & H1). exists d; split; auto.
  intros x Hx. apply H1. lra.
Qed.

Lemma deriv_const s u c t : deriv_on s u (fun _ => c) t 0.
Proof.
  intros eps He. exists 1. split; [lra|]. intros x _ _.
  replace (c - c - 0 * (x - t)) with 0 by ring. rewrite Rabs_R0.
  apply Rmult_le_pos; [lra | apply Rabs_pos].
Qed.

Lemma deriv_id s u t : deriv_on s u (fun x => x) t 1.
Proof.
  intros eps He. exists 1. split; [lra|]. intros x _ _.
  replace (x - t - 1 * (x - t)) with 0 by ring. rewrite Rabs_R0.
  apply Rmult_le_pos; [lra | apply Rabs_pos].
Qed.

Lemma deriv_plus s u g h t l m : deriv_on s u g t l -> deriv_on s u h t m ->
  deriv_on s u (fun x => g x + h x) t (l + m).
Proof.
  intros Hg Hh eps He.
  destruct (Hg (eps / 2)) as (d1 & Hd1 & H1); [lra|].
  destruct (Hh (eps / 2)) as (d2 & Hd2 & H2); [lra|].
  exists (Rmin d1 d2); split; [apply Rmin_pos; auto|].
  intros x Hx Hd. split_min Hd.
  assert (A1 := H1 x Hx H). assert (A2 := H2 x Hx H0).
  replace (g x + h x - (g t + h t) - (l + m) * (x - t))
    with ((g x - g t - l * (x - t)) + (h x - h t - m * (x - t))) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.

Lemma deriv_scal s u g t l c : deriv_on s u g t l -> deriv_on s u (fun x => c * g x) t (c * l).
Proof.
  intros H eps He. set (K := 1 + Rabs c).
  assert (HK : 0 < K) by (unfold K; generalize (Rabs_pos c); lra).
  destruct (H (eps / K)) as (d & Hd & H1); [apply Rdiv_lt_0_compat; auto|].
  exists d; split; auto. intros x Hx Hd'. specialize (H1 x Hx Hd').
  replace (c * g x - c * g t - c * l * (x - t)) with (c * (g x - g t - l * (x - t))) by ring.
  rewrite Rabs_mult. apply Rle_trans with (K * (eps / K * Rabs (x - t))).
  - apply Rmult_le_compat; auto using Rabs_pos. unfold K; lra.
  - right; field; lra.
Qed.

Lemma deriv_minus s u g h t l m : deriv_on s u g t l -> deriv_on s u h t m ->
  deriv_on s u (fun x => g x - h x) t (l - m).
Proof.
  intros Hg Hh. apply deriv_eq with (l + -1 * m); [ring|].
  intros eps He. destruct (deriv_plus s u g (fun x => -1 * h x) t l (-1 * m) Hg (deriv_scal _ _ _ _ _ _ Hh) eps He)
    as (d & Hd & H). exists d; split; auto. intros x Hx Hd'.
  replace (g x - h x - (g t - h t) - (l + -1 * m) * (x - t))
    with (g x + -1 * h x - (g t + -1 * h t) - (l + -1 * m) * (x - t)) by ring. auto.
Qed.

(* The product of a function that is 0 at t with one that is only continuous there. *)
Lemma deriv_vanishing s u g h t l : g t = 0 -> deriv_on s u g t l -> cont_on s u h t ->
  deriv_on s u (fun x => g x * h x) t (l * h t).
Proof.
  intros Hz Hg Hh eps He.
  set (K := 1 + Rabs (h t)). assert (HK : 1 <= K) by (unfold K; generalize (Rabs_pos (h t)); lra).
  set (L := 1 + Rabs l). assert (HL : 1 <= L) by (unfold L; generalize (Rabs_pos l); lra).
  destruct (Hg (eps / (2 * K))) as (d1 & Hd1 & H1); [apply Rdiv_lt_0_compat; lra|].
  destruct (Hh (Rmin 1 (eps / (2 * L)))) as (d2 & Hd2 & H2).
  { apply Rmin_pos; [lra | apply Rdiv_lt_0_compat; lra]. }
  exists (Rmin d1 d2); split; [apply Rmin_pos; auto|].
  intros x Hx Hd. split_min Hd. specialize (H1 x Hx H). specialize (H2 x Hx H0). split_min H2.
  rewrite Hz, Rminus_0_r in H1. rewrite Hz, Rmult_0_l, Rminus_0_r.
  replace (g x * h x - l * h t * (x - t))
    with ((g x - l * (x - t)) * h x + (x - t) * (l * (h x - h t))) by ring.
  assert (D := Rabs_pos (x - t)).
  assert (Bh : Rabs (h x) <= K).
  { replace (h x) with (h t + (h x - h t)) by ring. eapply Rle_trans; [apply Rabs_triang|]. unfold K; lra. }
  assert (P1 : Rabs ((g x - l * (x - t)) * h x) <= eps / 2 * Rabs (x - t)).
  { rewrite Rabs_mult. apply Rle_trans with (eps / (2 * K) * Rabs (x - t) * K).
    - apply Rmult_le_compat; auto using Rabs_pos.
    - right; field; lra. }
  assert (P2 : Rabs ((x - t) * (l * (h x - h t))) <= Rabs (x - t) * (eps / 2)).
  { rewrite Rabs_mult. apply Rmult_le_compat_l; auto. rewrite Rabs_mult.
    apply Rle_trans with (L * (eps / (2 * L))).
    - apply Rmult_le_compat; auto using Rabs_pos; [unfold L; lra | lra].
    - right; field; lra. }
  eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.

Lemma deriv_mult s u g h t l m : deriv_on s u g t l -> deriv_on s u h t m ->
  deriv_on s u (fun x => g x * h x) t (l * h t + g t * m).
Proof.
  intros Hg Hh.
  assert (P : deriv_on s u (fun x => (g x - g t) * h x) t (l * h t)).
  { apply deriv_vanishing with (g := fun x => g x - g t); [ring | | apply deriv_cont with m; exact Hh].
    apply deriv_eq with (l - 0); [ring|]. apply deriv_minus; auto using deriv_const. }
  intros eps He. destruct (deriv_plus s u _ _ t _ _ P (deriv_scal s u h t m (g t) Hh) eps He) as (d & Hd & H).
  exists d; split; auto. intros x Hx Hd'.
  replace (g x * h x - g t * h t) with ((g x - g t) * h x + g t * h x - ((g t - g t) * h t + g t * h t)) by ring.
  auto.
Qed.

Lemma deriv_Sum s u n g t l : (forall i, (i < n)%nat -> deriv_on s u (g i) t (l i)) ->
  deriv_on s u (fun x => Sum n (fun i => g i x)) t (Sum n l).
Proof.
  induction n; simpl; intros H; [apply deriv_const|]. apply deriv_plus; auto.
Qed.

(* A bounded factor times one that tends to 0. *)
Lemma cont_vanishing s u g h t K d0 : 0 < d0 -> g t = 0 -> cont_on s u g t ->
  (forall x, s <= x <= u -> Rabs (x - t) < d0 -> Rabs (h x) <= K) ->
  cont_on s u (fun x => g x * h x) t.
Proof.
  intros Hd0 Hz Hg HK eps He. set (L := 1 + Rabs K).
  assert (HL : 1 <= L) by (unfold L; generalize (Rabs_pos K); lra).
  destruct (Hg (eps / L)) as (d & Hd & H); [apply Rdiv_lt_0_compat; lra|].
  exists (Rmin d d0); split; [apply Rmin_pos; auto|]. intros x Hx Hxd. split_min Hxd.
  specialize (H x Hx H0). specialize (HK x Hx H1). rewrite Hz, Rminus_0_r in H.
  rewrite Hz, Rmult_0_l, Rminus_0_r, Rabs_mult.
  apply Rle_lt_trans with (Rabs (g x) * L).
  - apply Rmult_le_compat_l; [apply Rabs_pos|]. unfold L. generalize (Rle_abs K); lra.
  - apply Rmult_lt_compat_r with (r := L) in H; [|lra].
    replace (eps / L * L) with eps in H by (field; lra). exact H.
Qed.

Lemma cont_plus s u g h t : cont_on s u g t -> cont_on s u h t -> cont_on s u (fun x => g x + h x) t.
Proof.
  intros Hg Hh eps He.
  destruct (Hg (eps / 2)) as (d1 & Hd1 & H1); [lra|].
  destruct (Hh (eps / 2)) as (d2 & Hd2 & H2); [lra|].
  exists (Rmin d1 d2); split; [apply Rmin_pos; auto|].
  intros x Hx Hd. split_min Hd. specialize (H1 x Hx H). specialize (H2 x Hx H0).
  replace (g x + h x - (g t + h t)) with ((g x - g t) + (h x - h t)) by ring.
  eapply Rle_lt_trans; [apply Rabs_triang | lra].
Qed.

Lemma cont_scal s u g t c : cont_on s u g t -> cont_on s u (fun x => c * g x) t.
Proof.
  intros H eps He. set (L := 1 + Rabs c). assert (HL : 1 <= L) by (unfold L; generalize (Rabs_pos c); lra).
  destruct (H (eps / L)) as (d & Hd & H1); [apply Rdiv_lt_0_compat; lra|].
  exists d; split; auto. intros x Hx Hd'. specialize (H1 x Hx Hd').
  replace (c * g x - c * g t) with (c * (g x - g t)) by ring. rewrite Rabs_mult.
  apply Rle_lt_trans with (L * Rabs (g x - g t)).
  - apply Rmult_le_compat_r; [apply Rabs_pos | unfold L; lra].
  - apply Rmult_lt_compat_l with (r := L) in H1; [|lra].
    replace (L * (eps / L)) with eps in H1 by (field; lra). exact H1.
Qed.

Lemma cont_Sum s u n g t : (forall i, (i < n)%nat -> cont_on s u (g i) t) ->
  cont_on s u (fun x => Sum n (fun i => g i x)) t.
Proof.
  induction n; simpl; intros H.
  - intros eps He. exists 1. split; [lra|]. intros. rewrite Rminus_0_r, Rabs_R0. auto.
  - apply cont_plus; auto.
Qed.

(* A change of time, t = c + k x with k > 0. *)
Lemma deriv_affine s u g c k x l : 0 < k -> deriv_on (c + k * s) (c + k * u) g (c + k * x) l ->
  deriv_on s u (fun z => g (c + k * z)) x (k * l).
Proof.
  intros Hk H eps He.
  destruct (H (eps / k)) as (d & Hd & H1); [apply Rdiv_lt_0_compat; auto|].
  exists (d / k); split; [apply Rdiv_lt_0_compat; auto|].
  intros z Hz Hd'. assert (E : c + k * z - (c + k * x) = k * (z - x)) by ring.
  specialize (H1 (c + k * z)). rewrite E in H1. rewrite Rabs_mult, (Rabs_pos_eq k) in H1 by lra.
  replace (k * l * (z - x)) with (l * (k * (z - x))) by ring.
  replace (eps * Rabs (z - x)) with (eps / k * (k * Rabs (z - x))) by (field; lra).
  apply H1.
  - split; apply Rplus_le_compat_l, Rmult_le_compat_l; lra.
  - apply Rmult_lt_compat_l with (r := k) in Hd'; auto.
    replace (k * (d / k)) with d in Hd' by (field; lra). exact Hd'.
Qed.

(* The derivative of Coq's library, which has two sides, is one on every interval. *)
Lemma deriv_of_lim s u g t l : derivable_pt_lim g t l -> deriv_on s u g t l.
Proof.
  intros H eps He. destruct (H eps He) as (d & Hd). exists d; split; [apply cond_pos|].
  intros x _ Hx. destruct (Req_dec x t) as [-> | Hne].
  - replace (g t - g t - l * (t - t)) with 0 by ring. rewrite Rabs_R0.
    apply Rmult_le_pos; [lra | apply Rabs_pos].
  - assert (Hh : x - t <> 0) by lra. specialize (Hd (x - t) Hh Hx).
    replace (t + (x - t)) with x in Hd by ring.
    replace (g x - g t - l * (x - t)) with (((g x - g t) / (x - t) - l) * (x - t)) by (field; auto).
    rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos | lra].
Qed.

(* The chain rule with a function of Coq's library outside. *)
Lemma deriv_chain s u f g t l m : deriv_on s u g t l -> derivable_pt_lim f (g t) m ->
  deriv_on s u (fun x => f (g x)) t (m * l).
Proof.
  intros Hg Hf eps He.
  set (K := 1 + Rabs l). assert (HK : 1 <= K) by (unfold K; generalize (Rabs_pos l); lra).
  set (M := 1 + Rabs m). assert (HM : 1 <= M) by (unfold M; generalize (Rabs_pos m); lra).
  destruct (deriv_of_lim (g t - 1) (g t + 1) f (g t) m Hf (eps / (2 * K))) as (d1 & Hd1 & H1);
    [apply Rdiv_lt_0_compat; lra|].
  destruct (Hg (Rmin 1 (eps / (2 * M)))) as (d2 & Hd2 & H2).
  { apply Rmin_pos; [lra | apply Rdiv_lt_0_compat; lra]. }
  destruct (deriv_cont _ _ _ _ _ Hg (Rmin 1 d1)) as (d3 & Hd3 & H3); [apply Rmin_pos; lra|].
  exists (Rmin d2 d3); split; [apply Rmin_pos; auto|].
  intros x Hx Hd. split_min Hd. specialize (H2 x Hx H). specialize (H3 x Hx H0). split_min H3.
  assert (N := Rabs_pos (x - t)).
  assert (H2a : Rabs (g x - g t - l * (x - t)) <= 1 * Rabs (x - t)).
  { eapply Rle_trans; [exact H2|]. apply Rmult_le_compat_r; auto. apply Rmin_l. }
  assert (H2b : Rabs (g x - g t - l * (x - t)) <= eps / (2 * M) * Rabs (x - t)).
  { eapply Rle_trans; [exact H2|]. apply Rmult_le_compat_r; auto. apply Rmin_r. }
  assert (G : Rabs (g x - g t) <= K * Rabs (x - t)).
  { replace (g x - g t) with ((g x - g t - l * (x - t)) + l * (x - t)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult. unfold K. lra. }
  assert (R1 : g t - 1 <= g x <= g t + 1) by (apply Rabs_def2 in H4; lra).
  specialize (H1 (g x) R1 H5).
  replace (f (g x) - f (g t) - m * l * (x - t))
    with ((f (g x) - f (g t) - m * (g x - g t)) + m * (g x - g t - l * (x - t))) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
  assert (P1 : eps / (2 * K) * Rabs (g x - g t) <= eps / 2 * Rabs (x - t)).
  { apply Rle_trans with (eps / (2 * K) * (K * Rabs (x - t))).
    - apply Rmult_le_compat_l; auto. left; apply Rdiv_lt_0_compat; lra.
    - right; field; lra. }
  assert (P2 : Rabs m * Rabs (g x - g t - l * (x - t)) <= eps / 2 * Rabs (x - t)).
  { apply Rle_trans with (M * (eps / (2 * M) * Rabs (x - t))).
    - apply Rmult_le_compat; auto using Rabs_pos. unfold M; lra.
    - right; field; lra. }
  lra.
Qed.
