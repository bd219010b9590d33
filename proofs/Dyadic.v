(* Dyadic numbers: a mantissa among the big integers of Bignums, which are lists of machine words, and an exponent. *)
Require Import Reals Lra Lia ZArith.
From Bignums Require Import BigZ.
Open Scope Z_scope.

Definition int := BigZ.t.
Definition real_of_int (a : int) : R := IZR (BigZ.to_Z a).

Lemma int_add a b : real_of_int (BigZ.add a b) = (real_of_int a + real_of_int b)%R.
Proof. unfold real_of_int. rewrite BigZ.spec_add. apply plus_IZR. Qed.
Lemma int_sub a b : real_of_int (BigZ.sub a b) = (real_of_int a - real_of_int b)%R.
Proof. unfold real_of_int. rewrite BigZ.spec_sub. apply minus_IZR. Qed.
Lemma int_mul a b : real_of_int (BigZ.mul a b) = (real_of_int a * real_of_int b)%R.
Proof. unfold real_of_int. rewrite BigZ.spec_mul. apply mult_IZR. Qed.
Lemma int_opp a : real_of_int (BigZ.opp a) = (- real_of_int a)%R.
Proof. unfold real_of_int. rewrite BigZ.spec_opp. apply opp_IZR. Qed.
Lemma int_abs a : real_of_int (BigZ.abs a) = Rabs (real_of_int a).
Proof. unfold real_of_int. rewrite BigZ.spec_abs. apply abs_IZR. Qed.
Lemma int_zero : real_of_int BigZ.zero = 0%R.
Proof. unfold real_of_int. rewrite BigZ.spec_0. reflexivity. Qed.
Lemma int_one : real_of_int BigZ.one = 1%R.
Proof. unfold real_of_int. rewrite BigZ.spec_1. reflexivity. Qed.
Lemma int_of_Z k : real_of_int (BigZ.of_Z k) = IZR k.
Proof. unfold real_of_int. rewrite BigZ.spec_of_Z. reflexivity. Qed.

(* 2^e for any integer e *)
Definition pow2 (e : Z) : R := powerRZ 2 e.
Lemma two_nonzero : 2%R <> 0%R. Proof. lra. Qed.
Lemma pow2_pos e : (0 < pow2 e)%R. Proof. apply powerRZ_lt; lra. Qed.
Lemma pow2_add e f : pow2 (e + f) = (pow2 e * pow2 f)%R. Proof. apply powerRZ_add, two_nonzero. Qed.
Lemma pow2_Z k : 0 <= k -> IZR (2 ^ k) = pow2 k.
Proof.
  intros Hk. unfold pow2. rewrite <- (Z2Nat.id k) by auto. rewrite <- pow_powerRZ, pow_IZR. reflexivity.
Qed.
Lemma pow2_split e f : pow2 f = (pow2 (f - e) * pow2 e)%R.
Proof. rewrite <- pow2_add. f_equal. ring. Qed.

Definition shift (a : int) (k : Z) : int := if k =? 0 then a else BigZ.shiftl a (BigZ.of_Z k).
Lemma int_shift a k : 0 <= k -> real_of_int (shift a k) = (real_of_int a * pow2 k)%R.
Proof.
  intros Hk. unfold shift. destruct (Z.eqb_spec k 0) as [-> |]; [unfold pow2; simpl; ring|].
  unfold real_of_int. rewrite BigZ.spec_shiftl, BigZ.spec_of_Z, Z.shiftl_mul_pow2, mult_IZR, pow2_Z by auto. reflexivity.
Qed.

Definition num := (int * Z)%type.
Definition real (a : num) : R := (real_of_int (fst a) * pow2 (snd a))%R.

Definition zero : num := (BigZ.zero, 0).
Definition one : num := (BigZ.one, 0).
Definition num_of_Z (k : Z) : num := (BigZ.of_Z k, 0).
Definition is_zero (a : num) : bool := BigZ.eqb (fst a) BigZ.zero.
Definition add (a b : num) : num :=
  if is_zero a then b else if is_zero b then a else
  let (x, e) := a in let (y, f) := b in
  if e <=? f then (BigZ.add x (shift y (f - e)), e) else (BigZ.add (shift x (e - f)) y, f).
Definition mul (a b : num) : num := (BigZ.mul (fst a) (fst b), snd a + snd b).
Definition opp (a : num) : num := (BigZ.opp (fst a), snd a).
Definition sub (a b : num) : num := add a (opp b).
Definition abs (a : num) : num := (BigZ.abs (fst a), snd a).
Definition scale (a : num) (k : Z) : num := (fst a, snd a + k).
Definition leb (a b : num) : bool := BigZ.leb BigZ.zero (fst (sub b a)).
Definition ltb (a b : num) : bool := BigZ.ltb BigZ.zero (fst (sub b a)).
Definition max (a b : num) : num := if leb a b then b else a.

(* Bounds are rounded up to so many bits. *)
Definition bits : Z := 128.
Definition up (a : num) : num :=
  let k := BigZ.to_Z (BigZ.log2 (BigZ.abs (fst a))) - bits in
  if 0 <? k then (BigZ.add (BigZ.shiftr (fst a) (BigZ.of_Z k)) BigZ.one, snd a + k) else a.

Global Arguments add : simpl never.
Global Arguments mul : simpl never.
Global Arguments sub : simpl never.
Global Arguments opp : simpl never.
Global Arguments abs : simpl never.
Global Arguments up : simpl never.

Open Scope R_scope.

Lemma real_zero : real zero = 0. Proof. unfold real, zero; simpl. rewrite int_zero. ring. Qed.
Lemma real_one : real one = 1. Proof. unfold real, one, pow2; simpl. rewrite int_one. ring. Qed.
Lemma real_num_of_Z k : real (num_of_Z k) = IZR k.
Proof. unfold real, num_of_Z, pow2; simpl. rewrite int_of_Z. ring. Qed.
Lemma is_zero_ok a : is_zero a = true -> real a = 0.
Proof.
  unfold is_zero, real, real_of_int. rewrite BigZ.spec_eqb, BigZ.spec_0. intros H. apply Z.eqb_eq in H. rewrite H. ring.
Qed.
Lemma real_add a b : real (add a b) = real a + real b.
Proof.
  unfold add. destruct (is_zero a) eqn:Ea; [rewrite (is_zero_ok a Ea); ring|].
  destruct (is_zero b) eqn:Eb; [rewrite (is_zero_ok b Eb); ring|].
  destruct a as [x e], b as [y f]. unfold real.
  destruct (Z.leb_spec e f); simpl; rewrite int_add, int_shift by lia.
  - rewrite (pow2_split e f). ring.
  - rewrite (pow2_split f e). ring.
Qed.
Lemma real_mul a b : real (mul a b) = real a * real b.
Proof. unfold real, mul; cbn [fst snd]. rewrite int_mul, pow2_add. ring. Qed.
Lemma real_opp a : real (opp a) = - real a.
Proof. unfold real, opp; simpl. rewrite int_opp. ring. Qed.
Lemma real_sub a b : real (sub a b) = real a - real b.
Proof. unfold sub. rewrite real_add, real_opp. ring. Qed.
Lemma real_abs a : real (abs a) = Rabs (real a).
Proof.
  unfold real, abs; simpl. rewrite int_abs, Rabs_mult. rewrite (Rabs_pos_eq (pow2 _)); [ring | left; apply pow2_pos].
Qed.
Lemma real_scale a k : real (scale a k) = real a * pow2 k.
Proof. unfold real, scale; simpl. rewrite pow2_add. ring. Qed.
Lemma real_sign a : real a = IZR (BigZ.to_Z (fst a)) * pow2 (snd a). Proof. reflexivity. Qed.
Lemma leb_ok a b : leb a b = true -> real a <= real b.
Proof.
  unfold leb. rewrite BigZ.spec_leb, BigZ.spec_0. intros H. apply Z.leb_le, IZR_le in H.
  assert (E := real_sub b a). rewrite real_sign in E. assert (P := pow2_pos (snd (sub b a))).
  assert (0 <= IZR (BigZ.to_Z (fst (sub b a))) * pow2 (snd (sub b a))) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma leb_false a b : leb a b = false -> real b <= real a.
Proof.
  unfold leb. rewrite BigZ.spec_leb, BigZ.spec_0. intros H. apply Z.leb_gt, IZR_lt in H.
  assert (E := real_sub b a). rewrite real_sign in E. assert (P := pow2_pos (snd (sub b a))).
  assert (0 <= - IZR (BigZ.to_Z (fst (sub b a))) * pow2 (snd (sub b a))) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma ltb_ok a b : ltb a b = true -> real a < real b.
Proof.
  unfold ltb. rewrite BigZ.spec_ltb, BigZ.spec_0. intros H. apply Z.ltb_lt, IZR_lt in H.
  assert (E := real_sub b a). rewrite real_sign in E. assert (P := pow2_pos (snd (sub b a))).
  assert (0 < IZR (BigZ.to_Z (fst (sub b a))) * pow2 (snd (sub b a))) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma max_left a b : real a <= real (max a b).
Proof. unfold max. destruct (leb a b) eqn:E; [apply leb_ok; auto | lra]. Qed.
Lemma max_right a b : real b <= real (max a b).
Proof. unfold max. destruct (leb a b) eqn:E; [lra | apply leb_false; auto]. Qed.
Lemma up_ok a : real a <= real (up a).
Proof.
  unfold up. destruct (Z.ltb_spec 0 (BigZ.to_Z (BigZ.log2 (BigZ.abs (fst a))) - bits)) as [H|]; [|lra].
  set (k := (_ - bits)%Z) in *. unfold real; simpl.
  rewrite int_add, int_one. rewrite pow2_add, <- Rmult_assoc, (Rmult_comm (_ * _)), <- Rmult_assoc.
  apply Rmult_le_compat_r; [left; apply pow2_pos|].
  unfold real_of_int. rewrite BigZ.spec_shiftr, BigZ.spec_of_Z, Z.shiftr_div_pow2 by lia.
  set (v := BigZ.to_Z (fst a)). rewrite <- pow2_Z, <- plus_IZR, <- mult_IZR by lia. apply IZR_le.
  assert (0 < 2 ^ k)%Z by (apply Z.pow_pos_nonneg; lia).
  assert (D := Z.div_mod v (2 ^ k)). assert (M := Z.mod_pos_bound v (2 ^ k)). nia.
Qed.

(* An upper bound of the square root. Nothing is known of the candidate: its square is compared. *)
Definition root_candidate (a : num) : num :=
  let e := (snd a - (if Z.even (snd a) then 0 else 1))%Z in
  let extra := 128%Z in
  (BigZ.add (BigZ.sqrt (shift (fst a) (snd a - e + 2 * extra))) BigZ.one, (e / 2 - extra)%Z).

(* 1/a rounded, for 0 < a; to be compared, too *)
Definition inverse_candidate (a : num) : num :=
  (BigZ.add (BigZ.div (shift BigZ.one 512) (fst a)) BigZ.one, (- 512 - snd a)%Z).
