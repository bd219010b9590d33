(* First exit: finitely many functions of time that cannot become negative; a tube around 0 whose blocks are measured
   by the squares of their Euclidean norms; the mean value inequality. *)
Require Import Reals Lra Lia Arith.
From Libration Require Import Sums Derivative.
Open Scope R_scope.

(* A function that is positive, or 0 with a positive derivative, stays >= 0 for a while. *)
Lemma stays_nonneg s u g t l : deriv_on s u g t l -> 0 <= g t -> (g t = 0 -> 0 < l) ->
  exists d, 0 < d /\ forall x, s <= x <= u -> t <= x < t + d -> 0 <= g x.
Proof.
  intros H H0 H1. destruct (Rle_lt_or_eq_dec _ _ H0) as [Hp | Hz].
  - destruct (deriv_cont _ _ _ _ _ H (g t) Hp) as (d & Hd & Hc).
    exists d; split; auto. intros x Hx Ht.
    assert (A : Rabs (g x - g t) < g t) by (apply Hc; auto; rewrite Rabs_pos_eq; lra).
    apply Rabs_def2 in A. lra.
  - symmetry in Hz. specialize (H1 Hz). destruct (H l H1) as (d & Hd & Hc).
    exists d; split; auto. intros x Hx Ht.
    assert (A : Rabs (g x - g t - l * (x - t)) <= l * Rabs (x - t))
      by (apply Hc; auto; rewrite Rabs_pos_eq; lra).
    rewrite (Rabs_pos_eq (x - t)) in A by lra. rewrite Hz in A. apply Rabs_le_both in A. lra.
Qed.

Theorem no_exit (m : nat) (s u : R) (g dg : nat -> R -> R) : s <= u ->
  (forall k t, (k < m)%nat -> s <= t <= u -> deriv_on s u (g k) t (dg k t)) ->
  (forall k, (k < m)%nat -> 0 <= g k s) ->
  (forall t, s <= t < u -> (forall k, (k < m)%nat -> 0 <= g k t) ->
     forall k, (k < m)%nat -> g k t = 0 -> 0 < dg k t) ->
  forall t, s <= t <= u -> forall k, (k < m)%nat -> 0 <= g k t.
Proof.
  intros Hsu HD H0 HB.
  set (E := fun t => s <= t <= u /\ forall x, s <= x <= t -> forall k, (k < m)%nat -> 0 <= g k x).
  assert (Es : E s).
  { split; [lra|]. intros x Hx k Hk. replace x with s by lra. auto. }
  destruct (completeness E) as (tau & Hub & Hlub).
  { exists u. intros x [Hx _]; lra. }
  { exists s; exact Es. }
  assert (Hs : s <= tau) by (apply Hub, Es).
  assert (Hu : tau <= u) by (apply Hlub; intros x [Hx _]; lra).
  assert (Good : forall x, s <= x < tau -> forall k, (k < m)%nat -> 0 <= g k x).
  { intros x Hx k Hk. destruct (Rle_or_lt 0 (g k x)) as [|Hn]; auto. exfalso.
    assert (tau <= x); [|lra]. apply Hlub. intros z [Hz1 Hz2].
    destruct (Rle_or_lt z x); auto. assert (0 <= g k x) by (apply Hz2; auto; lra). lra. }
  assert (GoodTau : forall k, (k < m)%nat -> 0 <= g k tau).
  { intros k Hk. destruct (Rle_lt_or_eq_dec _ _ Hs) as [Hlt | <-]; auto.
    destruct (Rle_or_lt 0 (g k tau)) as [|Hn]; auto. exfalso.
    destruct (deriv_cont _ _ _ _ _ (HD k tau Hk (conj Hs Hu)) (- g k tau)) as (d & Hd & Hc); [lra|].
    set (x := Rmax s (tau - d / 2)).
    assert (s <= x) by apply Rmax_l. assert (tau - d / 2 <= x) by apply Rmax_r.
    assert (x < tau) by (unfold x; apply Rmax_lub_lt; lra).
    assert (A1 : Rabs (g k x - g k tau) < - g k tau).
    { apply Hc; [lra|]. rewrite Rabs_left; lra. }
    apply Rabs_def2 in A1. assert (0 <= g k x) by (apply Good; auto; lra). lra. }
  assert (Etau : E tau).
  { split; [lra|]. intros x Hx k Hk. destruct (Req_dec x tau) as [-> |]; auto. apply Good; auto; lra. }
  destruct (Rle_lt_or_eq_dec _ _ Hu) as [Hlt | ->]; [exfalso | intros; apply Etau; auto].
  destruct (common_distance m (fun k d => forall x, s <= x <= u -> tau <= x < tau + d -> 0 <= g k x)) as (d & Hd & Hc).
  { intros k d d' Hk H Hle x Hx Hxd. apply H; auto. lra. }
  { intros k Hk. apply (stays_nonneg s u (g k) tau (dg k tau)); auto. }
  set (z := Rmin u (tau + d / 2)).
  assert (z <= u) by apply Rmin_l. assert (z <= tau + d / 2) by apply Rmin_r.
  assert (tau < z) by (unfold z; apply Rmin_glb_lt; lra).
  assert (z <= tau); [|lra]. apply Hub. split; [lra|].
  intros x Hx k Hk. destruct (Rle_or_lt x tau); [apply Etau; auto; lra|]. apply (Hc k Hk); lra.
Qed.

(* Tubes. q_b is the square of the norm of block b, r_b its radius. Next to the tube, within eps0, q_b grows at most
   as 2 rho_b (sum over c of A_bc rho_c + D_b) where rho_b is the norm; and the radii grow as fast. *)
Section Tube.
Variables (m : nat) (q dq r dr : nat -> R -> R) (A : nat -> nat -> R) (D : nat -> R) (u eps0 : R).
Hypothesis Heps : 0 < eps0.

Definition growth s := forall t (rho : nat -> R), s <= t < u ->
  (forall c, (c < m)%nat -> 0 <= rho c <= r c t + eps0 /\ q c t <= rho c * rho c) ->
  forall b, (b < m)%nat -> q b t = rho b * rho b ->
  dq b t <= 2 * rho b * (Sum m (fun c => A b c * rho c) + D b).
Definition radii_grow s := forall t, s <= t < u -> forall b, (b < m)%nat ->
  0 <= r b t /\ Sum m (fun c => A b c * r c t) + D b <= dr b t.

Variable K : R.
Hypothesis HK : forall b, (b < m)%nat -> Sum m (fun c => Rabs (A b c)) <= K.
Hypothesis HK0 : 0 < K.

Lemma rates_below b f x : (b < m)%nat -> 0 <= x -> (forall c, (c < m)%nat -> 0 <= f c <= x) ->
  Sum m (fun c => A b c * f c) <= K * x.
Proof.
  intros Hb Hx Hf. apply Rle_trans with (Sum m (fun c => Rabs (A b c) * x)).
  - apply Sum_le. intros c Hc. specialize (Hf c Hc). assert (P := Rle_abs (A b c)).
    apply Rle_trans with (Rabs (A b c) * f c).
    + apply Rmult_le_compat_r; lra.
    + apply Rmult_le_compat_l; [apply Rabs_pos | lra].
  - rewrite Sum_scal_r. apply Rmult_le_compat_r; auto.
Qed.

(* A tube wider by eta (1 + 2 K (t - s)), on a short interval. *)
Lemma wider_tube s v eta : s <= v -> v <= u -> 4 * K * (v - s) <= 1 -> 0 < eta -> 2 * eta <= eps0 ->
  growth s -> radii_grow s ->
  (forall b t, (b < m)%nat -> s <= t <= v -> deriv_on s v (q b) t (dq b t)) ->
  (forall b t, (b < m)%nat -> s <= t <= v -> deriv_on s v (r b) t (dr b t)) ->
  (forall b, (b < m)%nat -> q b s <= r b s * r b s) -> (forall b, (b < m)%nat -> 0 <= r b s) ->
  forall t, s <= t <= v -> forall b, (b < m)%nat ->
  q b t <= (r b t + eta * (1 + 4 * K * (t - s))) * (r b t + eta * (1 + 4 * K * (t - s))).
Proof.
  intros Hsv Hvu Hshort Heta Hsmall HG HR Hq Hr H0 Hr0.
  set (phi := fun t => eta * (1 + 4 * K * (t - s))).
  set (rho := fun b t => r b t + phi t).
  assert (Dphi : forall t, deriv_on s v phi t (eta * (4 * K))).
  { intros t. unfold phi. apply deriv_scal. apply deriv_eq with (0 + 4 * K * (1 - 0)); [ring|].
    apply deriv_plus; [apply deriv_const|]. apply deriv_scal, deriv_minus; auto using deriv_id, deriv_const. }
  assert (Drho : forall b t, (b < m)%nat -> s <= t <= v -> deriv_on s v (rho b) t (dr b t + eta * (4 * K))).
  { intros. apply deriv_plus; auto. }
  assert (Bphi : forall t, s <= t <= v -> eta <= phi t <= 2 * eta).
  { intros t Ht. unfold phi. assert (0 <= 4 * K * (t - s) <= 1).
    { split; [apply Rmult_le_pos; lra|]. apply Rle_trans with (4 * K * (v - s)); auto. apply Rmult_le_compat_l; lra. }
    split.
    - rewrite <- (Rmult_1_r eta) at 1. apply Rmult_le_compat_l; lra.
    - replace (2 * eta) with (eta * 2) by ring. apply Rmult_le_compat_l; lra. }
  assert (Main : forall t, s <= t <= v -> forall b, (b < m)%nat -> 0 <= rho b t * rho b t - q b t).
  { apply (no_exit m s v (fun b t => rho b t * rho b t - q b t)
      (fun b t => (dr b t + eta * (4 * K)) * rho b t + rho b t * (dr b t + eta * (4 * K)) - dq b t)); auto.
    - intros b t Hb Ht. apply deriv_minus; auto. apply deriv_mult; auto.
    - intros b Hb. specialize (H0 b Hb). specialize (Hr0 b Hb). assert (P := Bphi s ltac:(lra)).
      assert (r b s * r b s <= rho b s * rho b s) by (apply Rmult_le_compat; unfold rho; lra). lra.
    - intros t Ht Hall b Hb Hz. assert (P := Bphi t ltac:(lra)).
      destruct (HR t ltac:(lra) b Hb) as [Rb Gr].
      assert (Gq : dq b t <= 2 * rho b t * (Sum m (fun c => A b c * rho c t) + D b)).
      { apply (HG t (fun c => rho c t)); auto; [lra | | lra]. intros c Hc. specialize (Hall c Hc).
        destruct (HR t ltac:(lra) c Hc) as [Rc _]. split; [unfold rho; lra | lra]. }
      assert (S1 : Sum m (fun c => A b c * rho c t) = Sum m (fun c => A b c * r c t) + Sum m (fun c => A b c * phi t)).
      { rewrite <- Sum_plus. apply Sum_ext. intros; unfold rho; ring. }
      assert (S2 : Sum m (fun c => A b c * phi t) <= K * (2 * eta)).
      { apply Rle_trans with (K * phi t); [apply rates_below; auto; intros; lra | apply Rmult_le_compat_l; lra]. }
      assert (Pos : 0 < rho b t) by (unfold rho; lra).
      assert (Lt : Sum m (fun c => A b c * rho c t) + D b < dr b t + eta * (4 * K)).
      { assert (0 < K * eta) by (apply Rmult_lt_0_compat; auto). lra. }
      apply Rmult_lt_compat_l with (r := 2 * rho b t) in Lt; [|lra].
      replace ((dr b t + eta * (4 * K)) * rho b t + rho b t * (dr b t + eta * (4 * K)))
        with (2 * rho b t * (dr b t + eta * (4 * K))) by ring. lra. }
  intros t Ht b Hb. specialize (Main t Ht b Hb). unfold rho, phi in Main. lra.
Qed.

Lemma short_tube s v : s <= v -> v <= u -> 4 * K * (v - s) <= 1 ->
  growth s -> radii_grow s ->
  (forall b t, (b < m)%nat -> s <= t <= v -> deriv_on s v (q b) t (dq b t)) ->
  (forall b t, (b < m)%nat -> s <= t <= v -> deriv_on s v (r b) t (dr b t)) ->
  (forall b, (b < m)%nat -> q b s <= r b s * r b s) -> (forall b t, (b < m)%nat -> s <= t <= v -> 0 <= r b t) ->
  forall t, s <= t <= v -> forall b, (b < m)%nat -> q b t <= r b t * r b t.
Proof.
  intros Hsv Hvu Hshort HG HR Hq Hr H0 Hr0 t Ht b Hb. apply le_epsilon. intros e He.
  assert (Rb := Hr0 b t Hb Ht). set (M := 4 * r b t + 4).
  set (eta := Rmin (Rmin 1 (eps0 / 2)) (e / M)).
  assert (He1 : 0 < eta) by (repeat apply Rmin_pos; try lra; apply Rdiv_lt_0_compat; unfold M; lra).
  assert (E1 : eta <= Rmin 1 (eps0 / 2)) by apply Rmin_l. assert (E2 : eta <= e / M) by apply Rmin_r.
  assert (E3 : Rmin 1 (eps0 / 2) <= 1) by apply Rmin_l. assert (E4 : Rmin 1 (eps0 / 2) <= eps0 / 2) by apply Rmin_r.
  assert (W := wider_tube s v eta Hsv Hvu Hshort He1 ltac:(lra) HG HR Hq Hr H0 (fun b Hb => Hr0 b s Hb ltac:(lra)) t Ht b Hb).
  set (p := eta * (1 + 4 * K * (t - s))) in *.
  assert (Hp : 0 <= p <= 2 * eta).
  { assert (0 <= 4 * K * (t - s) <= 1).
    { split; [apply Rmult_le_pos; lra|]. apply Rle_trans with (4 * K * (v - s)); auto. apply Rmult_le_compat_l; lra. }
    unfold p. split; [apply Rmult_le_pos; lra|].
    replace (2 * eta) with (eta * 2) by ring. apply Rmult_le_compat_l; lra. }
  assert (ME : eta * M <= e).
  { apply Rmult_le_compat_r with (r := M) in E2; [|unfold M; lra]. replace (e / M * M) with e in E2 by (field; unfold M; lra). exact E2. }
  unfold M in ME.
  assert (p * (2 * r b t + p) <= 2 * eta * (2 * r b t + 2)) by (apply Rmult_le_compat; lra).
  lra.
Qed.

Theorem tube_of_growth s : s <= u -> growth s -> radii_grow s ->
  (forall b t, (b < m)%nat -> s <= t <= u -> deriv_on s u (q b) t (dq b t)) ->
  (forall b t, (b < m)%nat -> s <= t <= u -> deriv_on s u (r b) t (dr b t)) ->
  (forall b, (b < m)%nat -> q b s <= r b s * r b s) -> (forall b t, (b < m)%nat -> s <= t <= u -> 0 <= r b t) ->
  forall t, s <= t <= u -> forall b, (b < m)%nat -> q b t <= r b t * r b t.
Proof.
  intros Hsu HG HR Hq Hr H0 Hr0. set (L := / (4 * K)).
  assert (HL : 0 < L) by (apply Rinv_0_lt_compat; lra).
  assert (Claim : forall k t, s <= t <= u -> t <= s + INR k * L -> forall b, (b < m)%nat -> q b t <= r b t * r b t).
  { induction k as [|k IH]; intros t Ht Htk b Hb.
    - simpl in Htk. replace t with s by lra. auto.
    - destruct (Rle_or_lt t (s + INR k * L)) as [Hle | Hgt]; [apply IH; auto|].
      set (s' := s + INR k * L) in *. assert (Hs' : s <= s').
      { unfold s'. assert (0 <= INR k * L) by (apply Rmult_le_pos; [apply pos_INR | lra]). lra. }
      rewrite S_INR in Htk.
      apply (short_tube s' t); auto; try lra.
      + apply Rle_trans with (4 * K * L); [apply Rmult_le_compat_l; unfold s'; lra | unfold L; right; field; lra].
      + intros z rho Hz. apply HG. lra.
      + intros z Hz. apply HR. lra.
      + intros c z Hc Hz. apply deriv_sub_interval with s u; try lra. apply Hq; auto; lra.
      + intros c z Hc Hz. apply deriv_sub_interval with s u; try lra. apply Hr; auto; lra.
      + intros c Hc. apply IH; auto; lra.
      + intros c z Hc Hz. apply Hr0; auto; lra. }
  intros t Ht. destruct (archimed ((u - s) / L)) as [A1 _].
  assert (Hup : 0 <= (u - s) / L) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; auto]).
  apply (Claim (Z.to_nat (up ((u - s) / L)))); auto.
  rewrite INR_IZR_INZ, Z2Nat.id by (apply le_IZR; lra).
  apply Rmult_gt_compat_r with (r := L) in A1; auto.
  replace ((u - s) / L * L) with (u - s) in A1 by (field; lra). lra.
Qed.
End Tube.

(* The mean value inequality, forwards and in both directions. *)
Lemma mean_value_forward a b g dg C : a <= b -> 0 <= C ->
  (forall t, a <= t <= b -> deriv_on a b g t (dg t)) -> (forall t, a <= t <= b -> Rabs (dg t) <= C) ->
  Rabs (g b - g a) <= C * (b - a).
Proof.
  intros Hab HC HD HB. apply le_epsilon. intros e He. set (k := e / (b - a + 1)).
  assert (Hk : 0 < k) by (apply Rdiv_lt_0_compat; lra).
  assert (One : forall sg, sg = 1 \/ sg = -1 -> sg * (g b - g a) <= (C + k) * (b - a)).
  { intros sg Hsg.
    assert (N := no_exit 1 a b (fun _ t => (C + k) * (t - a) - sg * (g t - g a)) (fun _ t => (C + k) * (1 - 0) - sg * (dg t - 0)) Hab).
    assert (0 <= (C + k) * (b - a) - sg * (g b - g a)); [|lra].
    apply N with (k := 0%nat); try lia; try lra.
    - intros _ t _ Ht. apply deriv_minus; apply deriv_scal, deriv_minus; auto using deriv_id, deriv_const.
    - intros _ _. replace (g a - g a) with 0 by ring. replace (a - a) with 0 by ring. lra.
    - intros t Ht _ _ _ _. assert (B := HB t ltac:(lra)). apply Rabs_le_both in B. destruct Hsg as [-> | ->]; lra. }
  assert (k * (b - a) <= e).
  { replace e with (k * (b - a + 1)) by (unfold k; field; lra). apply Rmult_le_compat_l; lra. }
  assert (P1 := One 1 (or_introl eq_refl)). assert (P2 := One (-1) (or_intror eq_refl)). apply Rabs_le. lra.
Qed.

Lemma mean_value s u g dg C x t : 0 <= C -> s <= x <= u -> s <= t <= u ->
  (forall z, s <= z <= u -> deriv_on s u g z (dg z)) ->
  (forall z, s <= z <= u -> Rabs (z - t) <= Rabs (x - t) -> Rabs (dg z) <= C) ->
  Rabs (g x - g t) <= C * Rabs (x - t).
Proof.
  intros HC Hx Ht HD HB. destruct (Rle_or_lt t x) as [H | H].
  - rewrite (Rabs_pos_eq (x - t)) in * by lra. apply mean_value_forward with dg; auto.
    + intros z Hz. apply deriv_sub_interval with s u; try lra. apply HD; lra.
    + intros z Hz. apply HB; [lra|]. rewrite Rabs_pos_eq; lra.
  - rewrite (Rabs_left (x - t)) in * by lra. rewrite <- Rabs_Ropp.
    replace (- (g x - g t)) with (g t - g x) by ring. replace (- (x - t)) with (t - x) by ring.
    apply mean_value_forward with dg; auto; try lra.
    + intros z Hz. apply deriv_sub_interval with s u; try lra. apply HD; lra.
    + intros z Hz. apply HB; [lra|]. rewrite Rabs_left1; lra.
Qed.

(* A function with the derivative 0 is constant. *)
Lemma constant_of_deriv_zero s u g : (forall t, s <= t <= u -> deriv_on s u g t 0) ->
  forall t, s <= t <= u -> g t = g s.
Proof.
  intros H t Ht. assert (B := mean_value s u g (fun _ => 0) 0 t s ltac:(lra) Ht ltac:(lra) H).
  rewrite Rmult_0_l in B. assert (P := Rabs_pos (g t - g s)).
  assert (Rabs (g t - g s) <= 0) by (apply B; intros; rewrite Rabs_R0; lra).
  destruct (Req_dec (g t - g s) 0) as [|Hne]; [lra|]. apply Rabs_pos_lt in Hne. lra.
Qed.
