(* Bounds of norms and of eigenvalues, computed with dyadic numbers. *)
Require Import Reals Lra Lia ZArith List Bool.
From Bignums Require Import BigZ.
From Libration Require Import Sums Derivative Exit Blocks Dyadic Chebyshev Polynomial.
Import ListNotations.
Open Scope R_scope.

Definition root_up (a : num) : num :=
  let r := root_candidate a in if leb zero r && leb a (mul r r) then r else max a one.

Lemma root_up_ok a : 0 <= real (root_up a) /\ real a <= real (root_up a) * real (root_up a).
Proof.
  unfold root_up. destruct (leb zero _ && leb a _) eqn:E.
  - apply andb_prop in E as [E1 E2]. apply leb_ok in E1, E2. rewrite real_zero in E1. rewrite real_mul in E2. auto.
  - assert (A := max_left a one). assert (B := max_right a one). rewrite real_one in B. split; nra.
Qed.

(* The entries of a block. *)
Definition members (n : nat) (block : nat -> nat) (b : nat) : list nat := filter (fun i => Nat.eqb (block i) b) (seq 0 n).
Fixpoint total (l : list R) : R := match l with [] => 0 | a :: q => a + total q end.

Lemma total_app k l : total (k ++ l) = total k + total l.
Proof. induction k as [|a k IH]; simpl; [ring|]. rewrite IH. ring. Qed.

Lemma Sum_members_list n block b f : Sum n (fun i => member block b i * f i) = total (map f (members n block b)).
Proof.
  unfold members, member. induction n as [|n IH]; [reflexivity|].
  rewrite seq_S, filter_app, map_app, total_app, <- IH. simpl. destruct (Nat.eqb (block n) b); simpl; ring.
Qed.

Fixpoint squares (l : list num) : num := match l with [] => zero | a :: q => add (mul a a) (squares q) end.
Definition norm_up (l : list num) : num :=
  match l with [] => zero | [a] => abs a | _ => up (root_up (up (squares l))) end.

Lemma squares_ok l : real (squares l) = total (map (fun a => real a * real a) l).
Proof. induction l as [|a l IH]; simpl; [apply real_zero|]. rewrite real_add, real_mul, IH. reflexivity. Qed.

Lemma norm_up_ok l : 0 <= real (norm_up l) /\ total (map (fun a => real a * real a) l) <= real (norm_up l) * real (norm_up l).
Proof.
  rewrite <- squares_ok. destruct l as [|a [|b l]].
  - simpl. rewrite real_zero. lra.
  - simpl. rewrite real_abs, real_add, real_mul, real_zero, abs_square. split; [apply Rabs_pos | lra].
  - unfold norm_up. set (s := squares _). destruct (root_up_ok (up s)) as [A B]. assert (C := up_ok s).
    assert (D := up_ok (root_up (up s))). split; [lra|].
    apply Rle_trans with (real (root_up (up s)) * real (root_up (up s))); [lra|]. apply Rmult_le_compat; lra.
Qed.

Section BlockNorms.
Variables (n : nat) (block block' : nat -> nat).
Definition vector_norm (b : nat) (v : nat -> num) : num := norm_up (map v (members n block b)).
Definition matrix_norm (b d : nat) (M : nat -> nat -> num) : num :=
  norm_up (flat_map (fun i => map (M i) (members n block' d)) (members n block b)).

Lemma vector_norm_ok b v : 0 <= real (vector_norm b v) /\
  square n block b (fun i => real (v i)) <= real (vector_norm b v) * real (vector_norm b v).
Proof.
  unfold vector_norm, square. rewrite Sum_members_list. destruct (norm_up_ok (map v (members n block b))) as [A B].
  rewrite map_map in B. auto.
Qed.
Lemma matrix_norm_ok b d M : 0 <= real (matrix_norm b d M) /\
  frobenius n block block' b d (fun i j => real (M i j)) <= real (matrix_norm b d M) * real (matrix_norm b d M).
Proof.
  unfold matrix_norm, frobenius. rewrite Sum_members_list.
  destruct (norm_up_ok (flat_map (fun i => map (M i) (members n block' d)) (members n block b))) as [A B].
  split; [exact A|]. eapply Rle_trans; [right | exact B].
  generalize (members n block b). induction l as [|i l IH]; simpl; [reflexivity|].
  rewrite map_app, total_app, Sum_members_list, map_map, IH. reflexivity.
Qed.
End BlockNorms.

(* An upper bound of a polynomial on each of the equal parts of [-1, 1]. *)
Lemma in_a_part x : -1 <= x <= 1 -> exists k, (k < parts)%nat /\ Rabs (x - real (middle k)) <= 1 / 8.
Proof.
  intros Hx.
  assert (M : forall k, real (middle k) = (2 * INR k - 7) / 8).
  { intros k. unfold middle, real. cbn [fst snd]. rewrite int_of_Z, minus_IZR, mult_IZR, <- INR_IZR_INZ.
    unfold pow2. simpl. field. }
  assert (P : forall k, Rabs (x - (2 * INR k - 7) / 8) <= 1 / 8 -> (k < parts)%nat ->
    exists k, (k < parts)%nat /\ Rabs (x - real (middle k)) <= 1 / 8).
  { intros k H Hk. exists k. rewrite M. auto. }
  unfold parts in *.
  destruct (Rle_or_lt x (-6/8)); [apply (P 0%nat); [apply Rabs_le; simpl; lra | lia]|].
  destruct (Rle_or_lt x (-4/8)); [apply (P 1%nat); [apply Rabs_le; simpl; lra | lia]|].
  destruct (Rle_or_lt x (-2/8)); [apply (P 2%nat); [apply Rabs_le; simpl; lra | lia]|].
  destruct (Rle_or_lt x 0); [apply (P 3%nat); [apply Rabs_le; simpl; lra | lia]|].
  destruct (Rle_or_lt x (2/8)); [apply (P 4%nat); [apply Rabs_le; simpl; lra | lia]|].
  destruct (Rle_or_lt x (4/8)); [apply (P 5%nat); [apply Rabs_le; simpl; lra | lia]|].
  destruct (Rle_or_lt x (6/8)); [apply (P 6%nat); [apply Rabs_le; simpl; lra | lia]|].
  apply (P 7%nat); [apply Rabs_le; simpl; lra | lia].
Qed.

Lemma above_on_ok P k x : (k < parts)%nat -> -1 <= x <= 1 -> Rabs (x - real (middle k)) <= 1 / 8 ->
  peval P x <= real (above_on P k).
Proof.
  intros Hk Hx Hd. unfold above_on. eapply Rle_trans; [|apply up_ok].
  rewrite real_add, real_scale, pvalue_ok.
  assert (Hm : -1 <= real (middle k) <= 1).
  { unfold middle, real. cbn [fst snd]. rewrite int_of_Z, minus_IZR, mult_IZR, <- INR_IZR_INZ.
    unfold parts in Hk. assert (INR k <= 7) by (replace 7 with (INR 7) by (simpl; ring); apply le_INR; lia).
    assert (0 <= INR k) by apply pos_INR. unfold pow2. simpl. lra. }
  assert (B := pnorm_ok (pderiv P)).
  assert (Mv := mean_value (-1) 1 (peval P) (peval (pderiv P)) (real (pnorm (pderiv P))) x (real (middle k))).
  assert (Pos : 0 <= real (pnorm (pderiv P))) by (eapply Rle_trans; [apply Rabs_pos | apply (B x Hx)]).
  specialize (Mv Pos Hx Hm (fun z _ => peval_deriv (-1) 1 P z) (fun z Hz _ => B z Hz)).
  apply Rabs_le_both in Mv.
  assert (real (pnorm (pderiv P)) * Rabs (x - real (middle k)) <= real (pnorm (pderiv P)) * (1 / 8))
    by (apply Rmult_le_compat_l; auto).
  replace (pow2 (-3)) with (1 / 8) by (unfold pow2; simpl; field). lra.
Qed.

Fixpoint largest_of (n : nat) (f : nat -> num) : num := match n with O => f O | S k => max (largest_of k f) (f n) end.
Lemma largest_of_ok n f k : (k <= n)%nat -> real (f k) <= real (largest_of n f).
Proof.
  induction n as [|n IH]; intros Hk; [replace k with O by lia; apply Rle_refl|].
  cbn [largest_of]. destruct (Nat.eq_dec k (S n)) as [-> |]; [apply max_right|].
  eapply Rle_trans; [apply IH; lia | apply max_left].
Qed.

Definition above (P : poly) : num :=
  let a := largest_of 7 (above_on P) in let b := pnorm P in if leb a b then a else b.
Lemma above_ok P x : -1 <= x <= 1 -> peval P x <= real (above P).
Proof.
  intros Hx. unfold above. destruct leb.
  - destruct (in_a_part x Hx) as (k & Hk & Hd). eapply Rle_trans; [apply above_on_ok; eauto|].
    apply largest_of_ok. unfold parts in Hk. lia.
  - assert (B := pnorm_ok P x Hx). apply Rabs_le_both in B. lra.
Qed.

(* The largest eigenvalue of the symmetric matrix with the diagonal a, d and the sum m of the other two entries. *)
Definition eigenvalue_on (a d m : poly) (k : nat) : num :=
  let x := above_on a k in let y := above_on d k in
  let z := max (above_on m k) (above_on (psub pzero m) k) in
  up (scale (add (add x y) (root_up (up (add (mul (sub x y) (sub x y)) (mul z z))))) (-1)).
Definition eigenvalue (a d m : poly) : num := largest_of 7 (eigenvalue_on a d m).

Lemma eigenvalue_bound a d m x y z s u v : a <= x -> d <= y -> Rabs m <= z -> 0 <= s ->
  (x - y) * (x - y) + z * z <= s * s -> a * (u * u) + m * (u * v) + d * (v * v) <= (x + y + s) / 2 * (u * u + v * v).
Proof.
  intros Ha Hd Hm Hs Hq. set (L := (x + y + s) / 2).
  assert (Hz : 0 <= z) by (eapply Rle_trans; [apply Rabs_pos | exact Hm]).
  assert (A1 : Rabs (x - y) <= s) by (apply abs_le_of_square; auto; assert (P := Rle_0_sqr z); unfold Rsqr in P; lra).
  apply Rabs_le_both in A1.
  assert (Lx : 0 <= L - x) by (unfold L; lra). assert (Ly : 0 <= L - y) by (unfold L; lra).
  assert (Pr : z * z <= 4 * ((L - x) * (L - y))).
  { replace (4 * ((L - x) * (L - y))) with (s * s - (x - y) * (x - y)) by (unfold L; field). lra. }
  assert (Cross : Rabs (z * (u * v)) <= (L - x) * (u * u) + (L - y) * (v * v)).
  { assert (U := Rle_0_sqr u). assert (V := Rle_0_sqr v). unfold Rsqr in U, V.
    apply abs_le_of_square.
    - assert (0 <= (L - x) * (u * u)) by (apply Rmult_le_pos; auto). assert (0 <= (L - y) * (v * v)) by (apply Rmult_le_pos; auto). lra.
    - assert (S1 : z * z * (u * v * (u * v)) <= 4 * ((L - x) * (L - y)) * (u * v * (u * v)))
        by (apply Rmult_le_compat_r; auto; apply Rle_0_sqr).
      assert (S2 := Rle_0_sqr ((L - x) * (u * u) - (L - y) * (v * v))). unfold Rsqr in S2. lra. }
  assert (M : m * (u * v) <= Rabs (z * (u * v))).
  { eapply Rle_trans; [apply Rle_abs|]. rewrite !Rabs_mult, (Rabs_pos_eq z) by auto.
    apply Rmult_le_compat_r; auto. rewrite <- Rabs_mult. apply Rabs_pos. }
  assert (Au : a * (u * u) <= x * (u * u)) by (apply Rmult_le_compat_r; auto; apply Rle_0_sqr).
  assert (Dv : d * (v * v) <= y * (v * v)) by (apply Rmult_le_compat_r; auto; apply Rle_0_sqr). lra.
Qed.

Lemma eigenvalue_ok a d m x u v : -1 <= x <= 1 ->
  peval a x * (u * u) + peval m x * (u * v) + peval d x * (v * v) <= real (eigenvalue a d m) * (u * u + v * v).
Proof.
  intros Hx. destruct (in_a_part x Hx) as (k & Hk & Hd).
  assert (Sq : 0 <= u * u + v * v) by (assert (U := Rle_0_sqr u); assert (V := Rle_0_sqr v); unfold Rsqr in *; lra).
  apply Rle_trans with (real (eigenvalue_on a d m k) * (u * u + v * v)).
  2:{ apply Rmult_le_compat_r; auto. apply largest_of_ok. unfold parts in Hk. lia. }
  unfold eigenvalue_on. cbv zeta. set (z := max (above_on m k) (above_on (psub pzero m) k)). set (s := root_up _).
  eapply Rle_trans; [|apply Rmult_le_compat_r; [exact Sq | apply up_ok]].
  rewrite real_scale, !real_add. replace (pow2 (-1)) with (/ 2) by (unfold pow2; simpl; field).
  destruct (root_up_ok (up (add (mul (sub (above_on a k) (above_on d k)) (sub (above_on a k) (above_on d k))) (mul z z)))) as [A B].
  fold s in A, B.
  apply (eigenvalue_bound _ _ _ (real (above_on a k)) (real (above_on d k)) (real z) (real s)); auto using above_on_ok.
  - assert (M1 := above_on_ok m k x Hk Hx Hd). assert (M2 := above_on_ok (psub pzero m) k x Hk Hx Hd).
    rewrite peval_sub, peval_zero in M2. assert (Z1 := max_left (above_on m k) (above_on (psub pzero m) k)).
    assert (Z2 := max_right (above_on m k) (above_on (psub pzero m) k)). fold z in Z1, Z2. apply Rabs_le. lra.
  - eapply Rle_trans; [|exact B]. eapply Rle_trans; [|apply up_ok]. rewrite real_add, !real_mul, !real_sub. lra.
Qed.

(* The rate of block b of a matrix of polynomials: 1 or 2 columns. *)
Definition rate (n : nat) (block : nat -> nat) (B : nat -> nat -> poly) (b : nat) : option num :=
  match members n block b with
  | [i] => Some (above (B i i))
  | [i; j] => Some (eigenvalue (B i i) (B j j) (padd (B i j) (B j i)))
  | _ => None
  end.
Lemma rate_ok n block B b L x c : rate n block B b = Some L -> -1 <= x <= 1 ->
  form n block block b b (fun i j => peval (B i j) x) c c <= real L * square n block b c.
Proof.
  intros HL Hx. unfold form, square. rewrite !Sum_members_list.
  rewrite (map_ext (fun i => c i * Sum n (fun j => member block b j * (peval (B i j) x * c j)))
    (fun i => c i * total (map (fun j => peval (B i j) x * c j) (members n block b))))
    by (intros; rewrite Sum_members_list; reflexivity).
  unfold rate in HL. destruct (members n block b) as [|i [|j [|k l]]]; try discriminate; injection HL as <-; simpl.
  - assert (A := above_ok (B i i) x Hx).
    assert (peval (B i i) x * (c i * c i) <= real (above (B i i)) * (c i * c i)) by (apply Rmult_le_compat_r; auto; apply Rle_0_sqr). lra.
  - assert (E := eigenvalue_ok (B i i) (B j j) (padd (B i j) (B j i)) x (c i) (c j) Hx). rewrite peval_add in E. lra.
Qed.
