(* Chebyshev polynomials, and polynomials as lists of integers in the form of certificates:
   a_0, a_1, ... is a_0 + sum over j > 0 of 2 a_j T_j(x). With x = (z + 1/z)/2 it is the sum of a_|j| z^j, and products
   are products of polynomials in z. *)
Require Import Reals Lra Lia ZArith List.
From Bignums Require Import BigZ.
From Libration Require Import Sums Derivative Dyadic.
Import ListNotations.
Open Scope R_scope.

(* t k = 2 T_k, and w k = U_(k - 1): (z^k - z^-k)/(z - 1/z) *)
Fixpoint t (k : nat) (x : R) : R :=
  match k with O => 2 | S k' => match k' with O => 2 * x | S k'' => 2 * x * t k' x - t k'' x end end.
Fixpoint w (k : nat) (x : R) : R :=
  match k with O => 0 | S k' => match k' with O => 1 | S k'' => 2 * x * w k' x - w k'' x end end.

Lemma t_step k x : t (S (S k)) x = 2 * x * t (S k) x - t k x. Proof. reflexivity. Qed.
Lemma w_step k x : w (S (S k)) x = 2 * x * w (S k) x - w k x. Proof. reflexivity. Qed.

Lemma t_of_w k x : w (S (S k)) x - w k x = t (S k) x.
Proof.
  cut (w (S (S k)) x - w k x = t (S k) x /\ w (S (S (S k))) x - w (S k) x = t (S (S k)) x); [tauto|].
  induction k as [|k [IH1 IH2]]; [simpl; split; ring|]. split; auto.
  rewrite (w_step (S (S k))), (t_step (S k)), <- IH2, <- IH1, (w_step k). ring.
Qed.

Lemma t_product i j x : (j <= i)%nat -> t i x * t j x = t (i + j) x + t (i - j) x.
Proof.
  revert i. cut (forall i, ((j <= i)%nat -> t i x * t j x = t (i + j) x + t (i - j) x) /\
    ((S j <= i)%nat -> t i x * t (S j) x = t (i + S j) x + t (i - S j) x)); [intros H i; apply H|].
  induction j as [|j IH]; intros i.
  - rewrite Nat.add_0_r, Nat.sub_0_r. split; intros Hi; [simpl; ring|].
    destruct i as [|i]; [lia|]. replace (S i + 1)%nat with (S (S i)) by lia. replace (S i - 1)%nat with i by lia.
    rewrite t_step. simpl (t 1 x). ring.
  - split; intros Hi; [apply IH; auto|].
    destruct (IH i) as [I1 I2]. specialize (I1 ltac:(lia)). specialize (I2 ltac:(lia)).
    rewrite t_step. replace (t i x * (2 * x * t (S j) x - t j x)) with (2 * x * (t i x * t (S j) x) - t i x * t j x) by ring.
    rewrite I1, I2. replace (i + S (S j))%nat with (S (S (i + j))) by lia. replace (i + S j)%nat with (S (i + j)) by lia.
    rewrite t_step. replace (i - j)%nat with (S (S (i - S (S j)))) by lia. replace (i - S j)%nat with (S (i - S (S j))) by lia.
    rewrite t_step. ring.
Qed.

(* |T_k| <= 1, from T_k^2 + (1 - x^2) U_(k-1)^2 = 1 *)
Lemma pell k x :
  t k x * t k x / 4 + (1 - x * x) * (w k x * w k x) = 1 /\
  t k x * t (S k) x / 4 + (1 - x * x) * (w k x * w (S k) x) = x /\
  t (S k) x * t (S k) x / 4 + (1 - x * x) * (w (S k) x * w (S k) x) = 1.
Proof.
  induction k as [|k (I1 & I2 & I3)]; [simpl; repeat split; field|]. split; [exact I3|].
  rewrite t_step, w_step.
  set (a := t k x) in *. set (b := t (S k) x) in *. set (c := w k x) in *. set (d := w (S k) x) in *. split.
  - transitivity (2 * x * (b * b / 4 + (1 - x * x) * (d * d)) - (a * b / 4 + (1 - x * x) * (c * d))); [field|].
    rewrite I3, I2. ring.
  - transitivity (4 * (x * x) * (b * b / 4 + (1 - x * x) * (d * d)) - 4 * x * (a * b / 4 + (1 - x * x) * (c * d))
      + (a * a / 4 + (1 - x * x) * (c * c))); [field|].
    rewrite I3, I2, I1. ring.
Qed.

Lemma t_bound k x : -1 <= x <= 1 -> Rabs (t k x) <= 2.
Proof.
  intros Hx. destruct (pell k x) as [P _].
  assert (0 <= (1 - x * x) * (w k x * w k x)) by (apply Rmult_le_pos; [nra | apply Rle_0_sqr]).
  apply Rabs_le. split; nra.
Qed.

Lemma t_deriv s u k x : deriv_on s u (t k) x (2 * INR k * w k x).
Proof.
  cut (deriv_on s u (t k) x (2 * INR k * w k x) /\ deriv_on s u (t (S k)) x (2 * INR (S k) * w (S k) x)); [tauto|].
  induction k as [|k [I1 I2]].
  - split.
    + apply deriv_eq with 0; [simpl; ring | apply deriv_const].
    + apply deriv_eq with (2 * 1); [simpl; ring|]. apply (deriv_scal s u (fun x => x)), deriv_id.
  - split; [exact I2|].
    apply deriv_eq with ((2 * 1) * t (S k) x + 2 * x * (2 * INR (S k) * w (S k) x) - 2 * INR k * w k x).
    + assert (E := t_of_w k x). rewrite w_step in E |- *. rewrite <- E, !S_INR. ring.
    + apply (deriv_minus s u (fun x => 2 * x * t (S k) x) (t k)); auto.
      apply (deriv_mult s u (fun x => 2 * x) (t (S k))); auto. apply (deriv_scal s u (fun x => x)), deriv_id.
Qed.

(* The sum of a_j t_(k + j), and the polynomial of a list. *)
Fixpoint tail (k : nat) (a : list int) (x : R) : R :=
  match a with [] => 0 | c :: q => real_of_int c * t k x + tail (S k) q x end.
Definition cheb (a : list int) (x : R) : R :=
  match a with [] => 0 | c :: q => real_of_int c + tail 1 q x end.

Fixpoint ladd (a b : list int) : list int :=
  match a, b with [], _ => b | _, [] => a | x :: a', y :: b' => BigZ.add x y :: ladd a' b' end.
Definition lmap_mul (c : int) (a : list int) : list int := map (BigZ.mul c) a.
Definition lopp (a : list int) : list int := map BigZ.opp a.
Definition lshift (a : list int) (k : Z) : list int := if (k =? 0)%Z then a else map (fun c => shift c k) a.

Lemma tail_add a x : forall b k, tail k (ladd a b) x = tail k a x + tail k b x.
Proof. induction a as [|c a IH]; intros [|d b] k; simpl; rewrite ?IH, ?int_add; ring. Qed.
Lemma tail_mul c a x : forall k, tail k (lmap_mul c a) x = real_of_int c * tail k a x.
Proof. induction a as [|d a IH]; intros k; simpl; [ring|]. fold (lmap_mul c a). rewrite IH, int_mul; ring. Qed.
Lemma tail_opp a x : forall k, tail k (lopp a) x = - tail k a x.
Proof. induction a as [|d a IH]; intros k; simpl; [ring|]. fold (lopp a). rewrite IH, int_opp; ring. Qed.
Lemma tail_shift a x e : (0 <= e)%Z -> forall k, tail k (map (fun c => shift c e) a) x = tail k a x * pow2 e.
Proof. intros He. induction a as [|d a IH]; intros k; simpl; [ring|]. rewrite IH, int_shift by auto; ring. Qed.

Lemma cheb_add a b x : cheb (ladd a b) x = cheb a x + cheb b x.
Proof. destruct a as [|c a], b as [|d b]; simpl; rewrite ?tail_add, ?int_add; ring. Qed.
Lemma cheb_mul c a x : cheb (lmap_mul c a) x = real_of_int c * cheb a x.
Proof. destruct a as [|d a]; simpl; [ring|]. fold (lmap_mul c a). rewrite tail_mul, int_mul; ring. Qed.
Lemma cheb_opp a x : cheb (lopp a) x = - cheb a x.
Proof. destruct a as [|d a]; simpl; [ring|]. fold (lopp a). rewrite tail_opp, int_opp; ring. Qed.
Lemma cheb_shift a x e : (0 <= e)%Z -> cheb (lshift a e) x = cheb a x * pow2 e.
Proof.
  intros He. unfold lshift. destruct (Z.eqb_spec e 0) as [-> |]; [unfold pow2; simpl; ring|].
  destruct a as [|d a]; simpl; [ring|]. rewrite tail_shift, int_shift by auto; ring.
Qed.

(* Products: for the coefficients of i + j and of |i - j|, one list each. *)
Fixpoint products (a b : list int) : list int * list int :=
  match a, b with
  | x :: a', y :: b' =>
      let (sums, differences) := products a' b' in
      let head := BigZ.mul x y :: ladd (lmap_mul x b') (lmap_mul y a') in
      (ladd head (BigZ.zero :: BigZ.zero :: sums), ladd head differences)
  | _, _ => ([], [])
  end.
Definition lmul (a b : list int) : list int :=
  match a, b with
  | x :: a', y :: b' =>
      let (sums, differences) := products a' b' in
      let head := BigZ.mul x y :: ladd (lmap_mul x b') (lmap_mul y a') in
      ladd (ladd head (BigZ.zero :: BigZ.zero :: sums))
        (match differences with [] => [] | d :: q => BigZ.add d d :: q end)
  | _, _ => []
  end.

Lemma t_tail i b x : forall k, t i x * tail (i + k) b x = tail (i + i + k) b x + tail k b x.
Proof.
  induction b as [|c b IH]; intros k; simpl; [ring|].
  specialize (IH (S k)). replace (i + S k)%nat with (S (i + k)) in IH by lia.
  replace (i + i + S k)%nat with (S (i + i + k)) in IH by lia.
  assert (P := t_product (i + k) i x ltac:(lia)).
  replace (i + k + i)%nat with (i + i + k)%nat in P by lia. replace (i + k - i)%nat with k in P by lia.
  rewrite Rmult_plus_distr_l, IH. replace (t i x * (real_of_int c * t (i + k) x)) with (real_of_int c * (t (i + k) x * t i x)) by ring.
  rewrite P. ring.
Qed.

Lemma products_ok a x : forall b i, tail i a x * tail i b x =
  tail (i + i) (fst (products a b)) x + tail 0 (snd (products a b)) x.
Proof.
  induction a as [|c a IH]; intros [|d b] i; try (simpl; ring).
  cbn [products]. specialize (IH b (S i)). destruct (products a b) as [sums differences]. cbn [fst snd] in *.
  replace (S i + S i)%nat with (S (S (i + i))) in IH by lia.
  rewrite !tail_add. cbn [tail]. rewrite !tail_add, !tail_mul, int_mul, int_zero.
  assert (Pa := t_tail i a x 1). assert (Pb := t_tail i b x 1).
  replace (i + 1)%nat with (S i) in Pa, Pb by lia. replace (i + i + 1)%nat with (S (i + i)) in Pa, Pb by lia.
  assert (Pt := t_product i i x (le_n i)). rewrite Nat.sub_diag in Pt.
  set (P := real_of_int c) in *. set (Q := real_of_int d) in *.
  replace ((P * t i x + tail (S i) a x) * (Q * t i x + tail (S i) b x)) with
    (P * Q * (t i x * t i x) + P * (t i x * tail (S i) b x) + Q * (t i x * tail (S i) a x) + tail (S i) a x * tail (S i) b x) by ring.
  rewrite Pt, Pa, Pb, IH. ring.
Qed.

Lemma cheb_product a b x : cheb (lmul a b) x = cheb a x * cheb b x.
Proof.
  destruct a as [|c a], b as [|d b]; try (simpl; ring).
  unfold lmul. assert (P := products_ok a x b 1). destruct (products a b) as [sums differences]. cbn [fst snd] in P.
  rewrite !cheb_add. cbn [cheb tail]. rewrite !tail_add, !tail_mul, int_mul, int_zero.
  replace (cheb (match differences with [] => [] | d :: q => BigZ.add d d :: q end) x) with (tail 0 differences x).
  2:{ destruct differences as [|e q]; simpl; [ring|]. rewrite int_add. ring. }
  simpl (1 + 1)%nat in P.
  replace ((real_of_int c + tail 1 a x) * (real_of_int d + tail 1 b x)) with
    (real_of_int c * real_of_int d + real_of_int c * tail 1 b x + real_of_int d * tail 1 a x + tail 1 a x * tail 1 b x) by ring.
  rewrite P. ring.
Qed.

(* The derivative: d_(j - 1) = d_(j + 1) + 2 j a_j; the list that begins with d_(k - 1), from a_k, ... *)
Fixpoint lderiv_from (k : Z) (a : list int) : list int :=
  match a with
  | [] => []
  | c :: q => let d := lderiv_from (k + 1) q in
      BigZ.add (BigZ.mul (BigZ.of_Z (2 * k)) c) (nth 1 d BigZ.zero) :: d
  end.
Definition lderiv (a : list int) : list int := match a with [] => [] | _ :: q => lderiv_from 1 q end.

Fixpoint deriv_tail (k : nat) (a : list int) (x : R) : R :=
  match a with [] => 0 | c :: q => real_of_int c * (2 * INR k * w k x) + deriv_tail (S k) q x end.
Lemma tail_deriv s u a x : forall k, deriv_on s u (tail k a) x (deriv_tail k a x).
Proof.
  induction a as [|c a IH]; intros k; simpl; [apply deriv_const|].
  apply deriv_plus; auto. apply deriv_scal, t_deriv.
Qed.
Lemma lderiv_from_ok a x : forall k, deriv_tail k a x =
  match lderiv_from (Z.of_nat k) a with
  | [] => 0
  | d :: l => real_of_int d * w k x +
      match l with [] => 0 | d' :: l' => real_of_int d' * w (S k) x + tail (S k) l' x end
  end.
Proof.
  induction a as [|c a IH]; intros k; [reflexivity|]. cbn [deriv_tail lderiv_from]. rewrite (IH (S k)).
  replace (Z.of_nat (S k)) with (Z.of_nat k + 1)%Z by lia.
  destruct (lderiv_from (Z.of_nat k + 1) a) as [|d [|d' l]]; cbn [nth]; rewrite int_add, int_mul, int_of_Z, ?int_zero;
    rewrite mult_IZR, <- INR_IZR_INZ; [ring | simpl; ring |].
  cbn [tail]. assert (E := t_of_w k x). rewrite <- E. ring.
Qed.

Lemma cheb_deriv s u a x : deriv_on s u (cheb a) x (cheb (lderiv a) x).
Proof.
  destruct a as [|c q]; [simpl; apply deriv_const|].
  apply deriv_eq with (0 + deriv_tail 1 q x).
  - rewrite lderiv_from_ok. unfold lderiv. change (Z.of_nat 1) with 1%Z.
    destruct (lderiv_from 1 q) as [|d [|d' l]]; simpl; ring.
  - apply (deriv_plus s u (fun _ => real_of_int c)); [apply deriv_const | apply tail_deriv].
Qed.

(* Bounds on [-1, 1]. *)
Fixpoint lsum_abs (a : list int) : int :=
  match a with [] => BigZ.zero | c :: q => BigZ.add (BigZ.abs c) (lsum_abs q) end.
Definition twice (a : int) : int := BigZ.add a a.
Definition lnorm (a : list int) : int :=
  match a with [] => BigZ.zero | c :: q => BigZ.add (BigZ.abs c) (twice (lsum_abs q)) end.
Definition lupper (a : list int) : int :=
  match a with [] => BigZ.zero | c :: q => BigZ.add c (twice (lsum_abs q)) end.

Lemma tail_bound a x : -1 <= x <= 1 -> forall k, Rabs (tail k a x) <= 2 * real_of_int (lsum_abs a).
Proof.
  intros Hx. induction a as [|c a IH]; intros k; cbn [tail lsum_abs]; [rewrite int_zero, Rabs_R0; lra|].
  rewrite int_add, int_abs. eapply Rle_trans; [apply Rabs_triang|]. specialize (IH (S k)).
  rewrite Rabs_mult. assert (B := t_bound k x Hx).
  assert (Rabs (real_of_int c) * Rabs (t k x) <= Rabs (real_of_int c) * 2) by (apply Rmult_le_compat_l; auto; apply Rabs_pos). lra.
Qed.
Lemma lnorm_ok a x : -1 <= x <= 1 -> Rabs (cheb a x) <= real_of_int (lnorm a).
Proof.
  intros Hx. destruct a as [|c a]; cbn [cheb lnorm lupper]; [rewrite int_zero, Rabs_R0; lra|].
  unfold twice. rewrite !int_add, int_abs. eapply Rle_trans; [apply Rabs_triang|].
  assert (B := tail_bound a x Hx 1). lra.
Qed.
Lemma lupper_ok a x : -1 <= x <= 1 -> cheb a x <= real_of_int (lupper a).
Proof.
  intros Hx. destruct a as [|c a]; cbn [cheb lnorm lupper]; [rewrite int_zero; lra|].
  unfold twice. rewrite !int_add. assert (B := tail_bound a x Hx 1). apply Rabs_le_both in B. lra.
Qed.

(* Values by Clenshaw's recurrence, at a dyadic number. *)
Fixpoint clenshaw (a : list int) (x : num) : num * num :=
  match a with
  | [] => (zero, zero)
  | c :: q => let (b1, b2) := clenshaw q x in (add (c, 0%Z) (sub (scale (mul x b1) 1) b2), b1)
  end.
Definition lvalue (a : list int) (x : num) : num :=
  match a with
  | [] => zero
  | c :: q => let (b1, b2) := clenshaw q x in add (c, 0%Z) (scale (sub (mul x b1) b2) 1)
  end.
Lemma clenshaw_ok a x : forall k, tail (S k) a (real x) =
  real (fst (clenshaw a x)) * t (S k) (real x) - real (snd (clenshaw a x)) * t k (real x).
Proof.
  induction a as [|c a IH]; intros k; cbn [tail clenshaw]; [cbn [fst snd]; rewrite real_zero; ring|].
  rewrite (IH (S k)). destruct (clenshaw a x) as [b1 b2]. cbn [fst snd].
  rewrite real_add, real_sub, real_scale, real_mul, t_step.
  replace (real (c, 0%Z)) with (real_of_int c) by (unfold real, pow2; simpl; ring).
  replace (pow2 1) with 2 by (unfold pow2; simpl; ring). ring.
Qed.
Lemma lvalue_ok a x : real (lvalue a x) = cheb a (real x).
Proof.
  destruct a as [|c a]; simpl; [apply real_zero|]. rewrite (clenshaw_ok a x 0).
  destruct (clenshaw a x) as [b1 b2]. cbn [fst snd].
  rewrite real_add, real_scale, real_sub, real_mul.
  replace (real (c, 0%Z)) with (real_of_int c) by (unfold real, pow2; simpl; ring).
  replace (pow2 1) with 2 by (unfold pow2; simpl; ring). simpl. ring.
Qed.
