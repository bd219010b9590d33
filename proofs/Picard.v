(* Local existence by Picard's iteration, whose iterates are polynomials: no integral is needed. The right sides are
   functions of the unknowns that turn polynomials into polynomials and have a bound and a Lipschitz constant in a box. *)
Require Import Reals Lra Lia List.
From Libration Require Import Sums Derivative Exit.
Import ListNotations.
Open Scope R_scope.

Fixpoint poly_value (P : list R) (x : R) : R := match P with [] => 0 | c :: Q => c + x * poly_value Q x end.
Fixpoint poly_slope (P : list R) (x : R) : R := match P with [] => 0 | c :: Q => poly_value Q x + x * poly_slope Q x end.
Lemma poly_deriv s u P x : deriv_on s u (poly_value P) x (poly_slope P x).
Proof.
  induction P as [|c Q IH]; simpl; [apply deriv_const|].
  apply deriv_eq with (0 + (1 * poly_value Q x + x * poly_slope Q x)); [ring|].
  apply (deriv_plus s u (fun _ => c) (fun x => x * poly_value Q x)); [apply deriv_const|].
  apply (deriv_mult s u (fun z => z)); [apply deriv_id | exact IH].
Qed.
Fixpoint poly_integral (k : R) (P : list R) : list R :=
  match P with [] => [] | a :: Q => a / k :: poly_integral (k + 1) Q end.
Lemma poly_integral_ok P x : forall k, 0 < k ->
  k * poly_value (poly_integral k P) x + x * poly_slope (poly_integral k P) x = poly_value P x.
Proof.
  induction P as [|a Q IH]; intros k Hk; simpl; [ring|]. rewrite <- (IH (k + 1)) by lra. field. lra.
Qed.

Section Picard.
Variables (n : nat) (f : nat -> (nat -> R) -> R) (c : nat -> R) (M L b eta : R).
Variable compose : (nat -> list R) -> nat -> list R.
Hypothesis Hcompose : forall ps i x, poly_value (compose ps i) x = f i (fun j => poly_value (ps j) x).
Definition box (v : nat -> R) := forall j, (j < n)%nat -> Rabs (v j - c j) <= b.
Hypothesis HM : forall v i, (i < n)%nat -> box v -> Rabs (f i v) <= M.
Hypothesis HL : forall v v' e i, (i < n)%nat -> box v -> box v' -> 0 <= e ->
  (forall j, (j < n)%nat -> Rabs (v j - v' j) <= e) -> Rabs (f i v - f i v') <= L * e.
Hypothesis HM0 : 0 <= M. Hypothesis HL0 : 0 <= L. Hypothesis Hb : 0 < b. Hypothesis Heta : 0 < eta.
Hypothesis HMe : M * eta <= b. Hypothesis HLe : L * eta <= 1 / 2.

Fixpoint iterate (k : nat) (i : nat) : list R :=
  match k with
  | O => [c i]
  | S k' => if Compare_dec.lt_dec i n then c i :: poly_integral 1 (compose (iterate k') i) else [c i]
  end.
Definition at_ k x := fun j => poly_value (iterate k j) x.

Lemma iterate_start k j : at_ k 0 j = c j.
Proof. unfold at_. destruct k; simpl; [ring|]. destruct Compare_dec.lt_dec; simpl; ring. Qed.
Lemma iterate_outside k j x : ~ (j < n)%nat -> at_ k x j = c j.
Proof. intros H. unfold at_. destruct k; simpl; [ring|]. destruct Compare_dec.lt_dec; [contradiction | simpl; ring]. Qed.
Lemma iterate_deriv k i x : (i < n)%nat -> deriv_on 0 eta (fun x => at_ (S k) x i) x (f i (at_ k x)).
Proof.
  intros Hi. unfold at_ at 1. cbn [iterate]. destruct Compare_dec.lt_dec; [|contradiction].
  apply deriv_eq with (poly_slope (c i :: poly_integral 1 (compose (iterate k) i)) x); [|apply poly_deriv].
  unfold at_. rewrite <- Hcompose, <- (poly_integral_ok _ x 1) by lra. simpl. ring.
Qed.
Lemma iterate_box k : forall x, 0 <= x <= eta -> box (at_ k x).
Proof.
  induction k as [|k IH]; intros x Hx j Hj.
  - unfold at_; simpl. replace (c j + x * 0 - c j) with 0 by ring. rewrite Rabs_R0; lra.
  - rewrite <- (iterate_start (S k) j). eapply Rle_trans.
    + apply (mean_value 0 eta (fun x => at_ (S k) x j) (fun z => f j (at_ k z)) M x 0); auto; try lra.
      intros z Hz. apply iterate_deriv; auto.
    + rewrite Rminus_0_r, Rabs_pos_eq by lra. apply Rle_trans with (M * eta); auto. apply Rmult_le_compat_l; lra.
Qed.
Lemma half_pow_pos k : 0 <= b * (1 / 2) ^ k.
Proof. apply Rmult_le_pos; [lra | apply pow_le; lra]. Qed.
Lemma iterates_near k : forall x, 0 <= x <= eta -> forall j, (j < n)%nat ->
  Rabs (at_ (S k) x j - at_ k x j) <= b * (1 / 2) ^ k.
Proof.
  induction k as [|k IH]; intros x Hx j Hj.
  - assert (B := iterate_box 1 x Hx j Hj). replace (at_ 0 x j) with (c j) by (unfold at_; simpl; ring).
    simpl ((1 / 2) ^ 0). lra.
  - set (g := fun z => at_ (S (S k)) z j - at_ (S k) z j).
    assert (E : g 0 = 0) by (unfold g; rewrite !iterate_start; ring).
    change (Rabs (g x) <= b * (1 / 2) ^ S k). replace (g x) with (g x - g 0) by lra.
    assert (W := half_pow_pos k). eapply Rle_trans.
    + apply (mean_value 0 eta g (fun z => f j (at_ (S k) z) - f j (at_ k z)) (L * (b * (1 / 2) ^ k)) x 0); try lra.
      * apply Rmult_le_pos; auto.
      * intros z Hz. unfold g. apply (deriv_minus 0 eta (fun z => at_ (S (S k)) z j)); apply iterate_deriv; auto.
      * intros z Hz _. apply HL; auto using iterate_box.
    + rewrite Rminus_0_r, Rabs_pos_eq by lra.
      replace (b * (1 / 2) ^ S k) with (b * (1 / 2) ^ k * (1 / 2)) by (simpl; ring).
      replace (L * (b * (1 / 2) ^ k) * x) with (b * (1 / 2) ^ k * (L * x)) by ring.
      apply Rmult_le_compat_l; auto. apply Rle_trans with (L * eta); auto. apply Rmult_le_compat_l; lra.
Qed.
Definition gap (k : nat) : R := 2 * b * (1 / 2) ^ k.
Lemma gap_step k : gap (S k) = gap k / 2. Proof. unfold gap; simpl; field. Qed.
Lemma gap_pos k : 0 <= gap k. Proof. unfold gap. assert (P := half_pow_pos k). lra. Qed.
Lemma iterates_cauchy k m : forall x, 0 <= x <= eta -> forall j, (j < n)%nat ->
  Rabs (at_ (k + m) x j - at_ k x j) <= gap k - gap (k + m).
Proof.
  induction m as [|m IH]; intros x Hx j Hj.
  - rewrite Nat.add_0_r. replace (at_ k x j - at_ k x j) with 0 by ring. rewrite Rabs_R0. lra.
  - rewrite Nat.add_succ_r.
    replace (at_ (S (k + m)) x j - at_ k x j) with ((at_ (S (k + m)) x j - at_ (k + m) x j) + (at_ (k + m) x j - at_ k x j)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. assert (A := iterates_near (k + m) x Hx j Hj). assert (B := IH x Hx j Hj).
    rewrite gap_step. unfold gap in *. lra.
Qed.
Lemma gap_small e : 0 < e -> exists k, forall m, (k <= m)%nat -> gap m < e.
Proof.
  intros He. destruct (pow_lt_1_zero (1 / 2)) with (y := e / (2 * b)) as (k & Hk).
  - rewrite Rabs_pos_eq; lra.
  - apply Rdiv_lt_0_compat; lra.
  - exists k. intros m Hm. specialize (Hk m Hm). rewrite Rabs_pos_eq in Hk by (apply pow_le; lra).
    apply Rmult_lt_compat_l with (r := 2 * b) in Hk; [|lra].
    replace (2 * b * (e / (2 * b))) with e in Hk by (field; lra). exact Hk.
Qed.

Lemma limit j x : {l | 0 <= x <= eta -> Un_cv (fun k => at_ k x j) l}.
Proof.
  destruct (Rle_dec 0 x) as [H1|]; [|exists 0; intros; lra].
  destruct (Rle_dec x eta) as [H2|]; [|exists 0; intros; lra].
  destruct (Compare_dec.lt_dec j n) as [Hj|Hj].
  - destruct (R_complete (fun k => at_ k x j)) as (l & Hl); [|exists l; auto].
    intros e He. destruct (gap_small (e / 2)) as (k & Hk); [lra|]. exists k. intros p q Hp Hq. unfold R_dist.
    assert (A : forall m, (m >= k)%nat -> Rabs (at_ m x j - at_ k x j) < e / 2).
    { intros m Hm. replace m with (k + (m - k))%nat by lia. eapply Rle_lt_trans; [apply iterates_cauchy; auto|].
      assert (P := gap_pos (k + (m - k))). specialize (Hk k (le_n _)). lra. }
    assert (Ap := A p Hp). assert (Aq := A q Hq).
    replace (at_ p x j - at_ q x j) with ((at_ p x j - at_ k x j) - (at_ q x j - at_ k x j)) by ring.
    eapply Rle_lt_trans; [apply Rabs_minus_le | lra].
  - exists (c j). intros _ e He. exists 0%nat. intros k _. rewrite iterate_outside by auto.
    unfold R_dist. replace (c j - c j) with 0 by ring. rewrite Rabs_R0. auto.
Qed.
Definition picard (j : nat) (x : R) : R := proj1_sig (limit j x).
Lemma picard_limit j x : 0 <= x <= eta -> Un_cv (fun k => at_ k x j) (picard j x).
Proof. intros Hx. unfold picard. destruct (limit j x); simpl; auto. Qed.
Lemma picard_near j x k : 0 <= x <= eta -> (j < n)%nat -> Rabs (picard j x - at_ k x j) <= gap k.
Proof.
  intros Hx Hj. apply le_epsilon. intros e He. destruct (picard_limit j x Hx e He) as (N & HN).
  specialize (HN (k + N)%nat ltac:(lia)). unfold R_dist in HN.
  assert (A := iterates_cauchy k N x Hx j Hj). assert (P := gap_pos (k + N)).
  replace (picard j x - at_ k x j) with ((at_ (k + N) x j - at_ k x j) - (at_ (k + N) x j - picard j x)) by ring.
  eapply Rle_trans; [apply Rabs_minus_le | lra].
Qed.
Lemma picard_box x : 0 <= x <= eta -> box (fun j => picard j x).
Proof.
  intros Hx j Hj. apply le_epsilon. intros e He. destruct (gap_small e He) as (k & Hk). specialize (Hk k (le_n _)).
  assert (A := picard_near j x k Hx Hj). assert (B := iterate_box k x Hx j Hj).
  replace (picard j x - c j) with ((picard j x - at_ k x j) + (at_ k x j - c j)) by ring.
  eapply Rle_trans; [apply Rabs_triang | lra].
Qed.
Lemma iterate_lipschitz k z t j : (j < n)%nat -> 0 <= z <= eta -> 0 <= t <= eta ->
  Rabs (at_ k z j - at_ k t j) <= M * Rabs (z - t).
Proof.
  intros Hj Hz Ht. destruct k as [|k].
  - unfold at_; simpl. replace (c j + z * 0 - (c j + t * 0)) with 0 by ring. rewrite Rabs_R0.
    apply Rmult_le_pos; auto using Rabs_pos.
  - apply (mean_value 0 eta (fun x => at_ (S k) x j) (fun v => f j (at_ k v)) M z t); auto.
    + intros v Hv. apply iterate_deriv; auto.
    + intros v Hv _. apply HM; auto using iterate_box.
Qed.

(* The difference quotient is within L M |x - t| of the right side. *)
Lemma picard_quotient i t x : (i < n)%nat -> 0 <= t <= eta -> 0 <= x <= eta ->
  let a := f i (fun j => picard j t) in let d := Rabs (x - t) in
  Rabs (picard i x - picard i t - a * (x - t)) <= L * M * d * d.
Proof.
  intros Hi Ht Hx a d. assert (Hd : 0 <= d) by apply Rabs_pos.
  assert (HMd : 0 <= M * d) by (apply Rmult_le_pos; auto).
  apply le_epsilon. intros e He. set (K := L * d + 2).
  assert (HK : 0 < K) by (unfold K; assert (0 <= L * d) by (apply Rmult_le_pos; auto); lra).
  destruct (gap_small (e / K)) as (k & Hk); [apply Rdiv_lt_0_compat; auto|]. specialize (Hk k (le_n _)).
  assert (Hg := gap_pos k).
  assert (A : Rabs ((at_ (S k) x i - a * x) - (at_ (S k) t i - a * t)) <= L * (M * d + gap k) * d).
  { apply (mean_value 0 eta (fun z => at_ (S k) z i - a * z) (fun z => f i (at_ k z) - a * 1) (L * (M * d + gap k)) x t); auto.
    - apply Rmult_le_pos; lra.
    - intros z Hz. apply (deriv_minus 0 eta (fun z => at_ (S k) z i) (fun z => a * z));
        [apply iterate_deriv; auto | apply deriv_scal, deriv_id].
    - intros z Hz Hzt. rewrite Rmult_1_r. unfold a. apply HL; auto using iterate_box, picard_box; [lra|].
      intros j Hj. replace (at_ k z j - picard j t) with ((at_ k z j - at_ k t j) - (picard j t - at_ k t j)) by ring.
      eapply Rle_trans; [apply Rabs_minus_le|]. apply Rplus_le_compat; [|apply picard_near; auto].
      eapply Rle_trans; [apply iterate_lipschitz; auto | apply Rmult_le_compat_l; auto]. }
  assert (N1 := picard_near i x (S k) Hx Hi). assert (N2 := picard_near i t (S k) Ht Hi). rewrite gap_step in N1, N2.
  replace (picard i x - picard i t - a * (x - t)) with
    ((picard i x - at_ (S k) x i) + ((at_ (S k) x i - a * x - (at_ (S k) t i - a * t)) - (picard i t - at_ (S k) t i))) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. eapply Rle_trans; [apply Rplus_le_compat_l, Rabs_minus_le|].
  assert (B : gap k * K <= e).
  { left. apply Rmult_lt_compat_r with (r := K) in Hk; auto.
    replace (e / K * K) with e in Hk by (field; lra). exact Hk. }
  unfold K in B. rewrite Rmult_plus_distr_l in B.
  replace (L * (M * d + gap k) * d) with (L * M * d * d + gap k * (L * d)) in A by ring. lra.
Qed.

Theorem local_existence : (forall i t, (i < n)%nat -> 0 <= t <= eta ->
    deriv_on 0 eta (picard i) t (f i (fun j => picard j t))) /\ (forall j, picard j 0 = c j).
Proof.
  split.
  - intros i t Hi Ht e He. assert (HLM : 0 <= L * M) by (apply Rmult_le_pos; auto).
    exists (e / (L * M + 1)). split; [apply Rdiv_lt_0_compat; lra|].
    intros x Hx Hd. assert (Q := picard_quotient i t x Hi Ht Hx). cbv zeta in Q.
    assert (HD := Rabs_pos (x - t)). eapply Rle_trans; [exact Q|]. apply Rmult_le_compat_r; auto.
    apply Rle_trans with ((L * M + 1) * Rabs (x - t)); [lra|].
    left. apply Rmult_lt_compat_l with (r := L * M + 1) in Hd; [|lra].
    replace ((L * M + 1) * (e / (L * M + 1))) with e in Hd by (field; lra). exact Hd.
  - intros j. apply (UL_sequence (fun k => at_ k 0 j)); [apply picard_limit; lra|].
    intros e He. exists 0%nat. intros k _. rewrite iterate_start. unfold R_dist.
    replace (c j - c j) with 0 by ring. rewrite Rabs_R0; auto.
Qed.
End Picard.
