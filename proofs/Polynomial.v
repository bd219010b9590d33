(* Polynomials with dyadic coefficients: a list of integers, and one exponent. Tables of them. *)
Require Import Reals Lra Lia ZArith List Bool.
From Bignums Require Import BigZ.
From Libration Require Import Sums Derivative Dyadic Chebyshev.
Import ListNotations.
Open Scope R_scope.

Definition poly := (list int * Z)%type.
Definition peval (P : poly) (x : R) : R := cheb (fst P) x * pow2 (snd P).

Definition pzero : poly := ([], 0%Z).
Definition pconst (a : num) : poly := ([fst a], snd a).
Definition padd (P Q : poly) : poly :=
  match P, Q with
  | ([], _), _ => Q
  | _, ([], _) => P
  | (a, e), (b, f) => if (e <=? f)%Z then (ladd a (lshift b (f - e)), e) else (ladd (lshift a (e - f)) b, f)
  end.
Definition pscale (c : num) (P : poly) : poly := (lmap_mul (fst c) (fst P), (snd c + snd P)%Z).
Definition psub (P Q : poly) : poly := padd P (lopp (fst Q), snd Q).
Definition pmul (P Q : poly) : poly := (lmul (fst P) (fst Q), (snd P + snd Q)%Z).
Definition pderiv (P : poly) : poly := (lderiv (fst P), snd P).
Definition pnorm (P : poly) : num := up (lnorm (fst P), snd P).
Definition pvalue (P : poly) (x : num) : num := scale (lvalue (fst P) x) (snd P).
Fixpoint psum (n : nat) (f : nat -> poly) : poly := match n with O => pzero | S k => padd (psum k f) (f k) end.

Global Arguments padd : simpl never.
Global Arguments pmul : simpl never.
Global Arguments psub : simpl never.
Global Arguments pscale : simpl never.

Lemma peval_zero x : peval pzero x = 0. Proof. unfold peval; simpl. ring. Qed.
Lemma peval_const a x : peval (pconst a) x = real a. Proof. unfold peval, real; simpl. ring. Qed.
Lemma peval_add P Q x : peval (padd P Q) x = peval P x + peval Q x.
Proof.
  destruct P as [[|a P] e], Q as [[|b Q] f]; try (unfold peval; simpl; ring).
  unfold padd, peval. destruct (Z.leb_spec e f); cbn [fst snd]; rewrite cheb_add, cheb_shift by lia.
  - rewrite (pow2_split e f). ring.
  - rewrite (pow2_split f e). ring.
Qed.
Lemma peval_scale c P x : peval (pscale c P) x = real c * peval P x.
Proof. unfold peval, pscale, real; simpl. rewrite cheb_mul, pow2_add. ring. Qed.
Lemma peval_sub P Q x : peval (psub P Q) x = peval P x - peval Q x.
Proof. unfold psub. rewrite peval_add. unfold peval; simpl. rewrite cheb_opp. ring. Qed.
Lemma peval_mul P Q x : peval (pmul P Q) x = peval P x * peval Q x.
Proof. unfold peval, pmul; simpl. rewrite cheb_product, pow2_add. ring. Qed.
Lemma peval_deriv s u P x : deriv_on s u (peval P) x (peval (pderiv P) x).
Proof.
  unfold peval, pderiv; simpl. apply deriv_eq with (cheb (lderiv (fst P)) x * pow2 (snd P) + cheb (fst P) x * 0); [ring|].
  apply (deriv_mult s u (cheb (fst P)) (fun _ => pow2 (snd P))); [apply cheb_deriv | apply deriv_const].
Qed.
Lemma pnorm_ok P x : -1 <= x <= 1 -> Rabs (peval P x) <= real (pnorm P).
Proof.
  intros Hx. unfold pnorm. eapply Rle_trans; [|apply up_ok]. unfold peval, real; simpl.
  rewrite Rabs_mult, (Rabs_pos_eq (pow2 _)) by (left; apply pow2_pos).
  apply Rmult_le_compat_r; [left; apply pow2_pos | apply lnorm_ok; auto].
Qed.
Lemma pvalue_ok P x : real (pvalue P x) = peval P (real x).
Proof. unfold pvalue, peval. rewrite real_scale, lvalue_ok. reflexivity. Qed.
Lemma peval_sum n f x : peval (psum n f) x = Sum n (fun i => peval (f i) x).
Proof. induction n; simpl; [apply peval_zero|]. rewrite peval_add, IHn. reflexivity. Qed.

(* An upper bound on [-1, 1]: the largest of the values in the middles of equal parts plus the change within a part. *)
Definition parts : nat := 8.
Definition middle (k : nat) : num := (BigZ.of_Z (2 * Z.of_nat k - 7), (-3)%Z).
Definition above_on (P : poly) (k : nat) : num := up (add (pvalue P (middle k)) (scale (pnorm (pderiv P)) (-3))).

Definition table {A} (n : nat) (f : nat -> A) : list A := map f (seq 0 n).
Lemma table_nth {A} n (f : nat -> A) i d : (i < n)%nat -> nth i (table n f) d = f i.
Proof.
  intros Hi. unfold table. rewrite nth_indep with (d' := f O) by (rewrite map_length, seq_length; auto).
  rewrite map_nth, seq_nth by auto. reflexivity.
Qed.
Definition all (n : nat) (f : nat -> bool) : bool := forallb f (seq 0 n).
Lemma all_ok n f : all n f = true -> forall i, (i < n)%nat -> f i = true.
Proof. unfold all. rewrite forallb_forall. intros H i Hi. apply H, in_seq. lia. Qed.

Definition vget (v : list num) (i : nat) : num := nth i v zero.
Definition pget (v : list poly) (i : nat) : poly := nth i v pzero.
Definition mget (M : list (list num)) (i j : nat) : num := nth j (nth i M []) zero.
Definition pmget (M : list (list poly)) (i j : nat) : poly := nth j (nth i M []) pzero.
Definition grid {A} (n m : nat) (f : nat -> nat -> A) : list (list A) := table n (fun i => table m (f i)).

Lemma vget_table n f i : (i < n)%nat -> vget (table n f) i = f i. Proof. intros; apply table_nth; auto. Qed.
Lemma pget_table n f i : (i < n)%nat -> pget (table n f) i = f i. Proof. intros; apply table_nth; auto. Qed.
Lemma mget_grid n m f i j : (i < n)%nat -> (j < m)%nat -> mget (grid n m f) i j = f i j.
Proof. intros. unfold mget, grid. rewrite (table_nth n _ i) by auto. apply table_nth; auto. Qed.
Lemma pmget_grid n m f i j : (i < n)%nat -> (j < m)%nat -> pmget (grid n m f) i j = f i j.
Proof. intros. unfold pmget, grid. rewrite (table_nth n _ i) by auto. apply table_nth; auto. Qed.

Fixpoint nsum (n : nat) (f : nat -> num) : num := match n with O => zero | S k => add (nsum k f) (f k) end.
Lemma real_sum n f : real (nsum n f) = Sum n (fun i => real (f i)).
Proof. induction n; simpl; [apply real_zero|]. rewrite real_add, IHn. reflexivity. Qed.
