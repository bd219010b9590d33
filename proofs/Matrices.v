(* Square matrices of reals as functions of two indices: products, and an inverse of a matrix near one. *)
Require Import Reals Lra Lia Arith.
From Libration Require Import Sums.
Open Scope R_scope.

Definition matrix := nat -> nat -> R.
Definition prod (n : nat) (A B : matrix) : matrix := fun i j => Sum n (fun k => A i k * B k j).
Definition apply (n : nat) (A : matrix) (v : nat -> R) : nat -> R := fun i => Sum n (fun k => A i k * v k).
Definition is_one (n : nat) (A : matrix) : Prop :=
  forall i j, (i < n)%nat -> (j < n)%nat -> A i j = delta i j.

Lemma apply_prod n A B v i : apply n (prod n A B) v i = apply n A (apply n B v) i.
Proof.
  unfold apply, prod.
  rewrite (Sum_ext n _ (fun k => Sum n (fun l => A i l * B l k * v k))) by (intros; rewrite Sum_scal_r; auto).
  rewrite Sum_swap. apply Sum_ext. intros l _. rewrite <- Sum_scal. apply Sum_ext. intros; ring.
Qed.

Lemma prod_assoc n A B C i j : prod n (prod n A B) C i j = prod n A (prod n B C) i j.
Proof. exact (apply_prod n A B (fun k => C k j) i). Qed.

Lemma apply_one n A v i : is_one n A -> (i < n)%nat -> apply n A v i = v i.
Proof.
  intros H Hi. unfold apply. rewrite (Sum_ext n _ (fun k => delta i k * v k)) by (intros; rewrite H; auto).
  apply Sum_delta; auto.
Qed.

Lemma apply_ext n A v w i : (forall j, (j < n)%nat -> v j = w j) -> apply n A v i = apply n A w i.
Proof. intros H. apply Sum_ext. intros. rewrite H; auto. Qed.

Lemma prod_ext n A B A' B' i j : (forall k, (k < n)%nat -> A i k = A' i k) ->
  (forall k, (k < n)%nat -> B k j = B' k j) -> prod n A B i j = prod n A' B' i j.
Proof. intros H H'. apply Sum_ext. intros. rewrite H, H'; auto. Qed.

(* m equations in m + 1 unknowns have a solution that is not 0 *)
Lemma underdetermined m : forall A : matrix, {c : nat -> R |
  (exists j, (j <= m)%nat /\ c j <> 0) /\ forall i, (i < m)%nat -> Sum (S m) (fun j => A i j * c j) = 0}.
Proof.
  induction m as [|m IH]; intros A.
  - exists (fun _ => 1). split; [exists 0%nat; split; [lia | lra] | intros; lia].
  - assert (Pivot : {k | (k < S m)%nat /\ A k (S m) <> 0} + {forall k, (k < S m)%nat -> A k (S m) = 0}).
    { clear. induction (S m) as [|p IHp] in |- * at 1 3.
      - right. intros; lia.
      - destruct IHp as [(k & Hk & H) | H]; [left; exists k; auto|].
        destruct (Req_EM_T (A p (S m)) 0) as [E | E]; [|left; exists p; auto].
        right. intros k Hk. destruct (Nat.eq_dec k p) as [-> |]; auto. apply H; lia. }
    destruct Pivot as [(k & Hk & Hp) | Hz].
    + set (row := fun i => if (i <? k)%nat then i else S i).
      set (A' := fun i j => A (row i) j - A (row i) (S m) / A k (S m) * A k j).
      destruct (IH A') as (c & Hnz & Hs).
      set (last := - Sum (S m) (fun j => A k j * c j) / A k (S m)).
      exists (fun j => if (j =? S m)%nat then last else c j). split.
      { destruct Hnz as (j0 & Hj0 & Hc). exists j0. split; [lia|].
        replace (j0 =? S m)%nat with false; auto. symmetry; apply Nat.eqb_neq; lia. }
      intros i Hi. cbn [Sum]. rewrite Nat.eqb_refl.
      assert (Hcut : forall r, Sum (S m) (fun j => A r j * (if (j =? S m)%nat then last else c j))
        = Sum (S m) (fun j => A r j * c j)).
      { intros r. apply Sum_ext. intros j Hj. replace (j =? S m)%nat with false; auto. symmetry; apply Nat.eqb_neq; lia. }
      specialize (Hcut i). cbn [Sum] in Hcut. rewrite Hcut. clear Hcut.
      change (Sum m (fun j => A i j * c j) + A i m * c m) with (Sum (S m) (fun j => A i j * c j)).
      destruct (Nat.eq_dec i k) as [-> | Hne]; [unfold last; field; auto|].
      assert (Ex : exists i', (i' < m)%nat /\ row i' = i).
      { unfold row. destruct (Nat.lt_ge_cases i k) as [Hl | Hg].
        - exists i. replace (i <? k)%nat with true by (symmetry; apply Nat.ltb_lt; auto). split; [lia | auto].
        - exists (i - 1)%nat. replace (i - 1 <? k)%nat with false by (symmetry; apply Nat.ltb_ge; lia). split; lia. }
      destruct Ex as (i' & Hi' & Ei). specialize (Hs i' Hi').
      unfold A' in Hs. rewrite Ei in Hs.
      rewrite (Sum_ext (S m) _ (fun j => A i j * c j - A i (S m) / A k (S m) * (A k j * c j))) in Hs
        by (intros; ring).
      rewrite Sum_minus, Sum_scal in Hs.
      transitivity (Sum (S m) (fun j => A i j * c j) - A i (S m) / A k (S m) * Sum (S m) (fun j => A k j * c j));
        [unfold last; field; auto | exact Hs].
    + exists (fun j => if (j =? S m)%nat then 1 else 0). split.
      { exists (S m). rewrite Nat.eqb_refl. split; [lia | lra]. }
      intros i Hi. apply Sum_zero. intros j Hj.
      destruct (Nat.eqb_spec j (S m)) as [-> |]; [rewrite Hz by auto|]; ring.
Qed.

Definition injective (n : nat) (A : matrix) : Prop :=
  forall c, (forall i, (i < n)%nat -> apply n A c i = 0) -> forall j, (j < n)%nat -> c j = 0.

Lemma solve n A b : injective n A -> {c : nat -> R | forall i, (i < n)%nat -> apply n A c i = b i}.
Proof.
  intros Hinj.
  destruct (underdetermined n (fun i j => if (j =? n)%nat then - b i else A i j)) as (c & Hex & Hc).
  assert (Eq : forall i, (i < n)%nat -> apply n A c i = c n * b i).
  { intros i Hi. specialize (Hc i Hi). cbn [Sum] in Hc. rewrite Nat.eqb_refl in Hc.
    rewrite (Sum_ext n _ (fun j => A i j * c j)) in Hc.
    - unfold apply. lra.
    - intros j Hj. replace (j =? n)%nat with false; auto. symmetry; apply Nat.eqb_neq; lia. }
  assert (Hn : c n <> 0).
  { intros E. destruct Hex as (j & Hj & Hcj). apply Hcj.
    destruct (Nat.eq_dec j n) as [-> |]; auto. apply Hinj; [|lia].
    intros i Hi. rewrite Eq, E by auto. ring. }
  exists (fun j => c j / c n). intros i Hi. specialize (Eq i Hi). unfold apply in *.
  rewrite (Sum_ext n _ (fun k => A i k * c k * / c n)) by (intros; unfold Rdiv; ring).
  rewrite Sum_scal_r, Eq. field; auto.
Qed.

(* An injective square matrix has an inverse on both sides. *)
Lemma inverse n A : injective n A -> {B | is_one n (prod n A B) /\ is_one n (prod n B A)}.
Proof.
  intros Hinj.
  set (B := fun i j => proj1_sig (solve n A (fun k => delta k j) Hinj) i).
  assert (AB : is_one n (prod n A B)).
  { intros i j Hi Hj. unfold prod, B. destruct (solve n A (fun k => delta k j) Hinj) as (c & Hc). simpl. apply Hc; auto. }
  exists B. split; auto. intros i j Hi Hj.
  apply Rminus_diag_uniq.
  apply (Hinj (fun k => prod n B A k j - delta k j)); auto.
  intros l Hl. unfold apply.
  rewrite (Sum_ext n _ (fun k => A l k * prod n B A k j - A l k * delta k j)) by (intros; ring).
  rewrite Sum_minus, Sum_delta_r by auto.
  change (Sum n (fun k => A l k * prod n B A k j)) with (prod n A (prod n B A) l j).
  rewrite <- prod_assoc.
  change (prod n (prod n A B) A l j) with (apply n (prod n A B) (fun k => A k j) l).
  rewrite apply_one by auto. ring.
Qed.

Lemma left_inverse_injective n A B : is_one n (prod n A B) -> injective n B.
Proof.
  intros H c Hc j Hj. rewrite <- (apply_one n (prod n A B) c j H Hj), apply_prod.
  apply Sum_zero. intros k Hk. rewrite Hc by auto. ring.
Qed.

Lemma left_inverse_right n A B : is_one n (prod n A B) -> is_one n (prod n B A).
Proof.
  intros H. destruct (inverse n B (left_inverse_injective n A B H)) as (C & BC & _).
  assert (E : forall i j, (i < n)%nat -> (j < n)%nat -> A i j = C i j).
  { intros i j Hi Hj. transitivity (prod n A (prod n B C) i j).
    - unfold prod at 1. rewrite (Sum_ext n _ (fun k => A i k * delta k j)) by (intros; rewrite BC; auto).
      symmetry. apply Sum_delta_r; auto.
    - rewrite <- prod_assoc. apply (apply_one n (prod n A B) (fun k => C k j)); auto. }
  intros i j Hi Hj. rewrite <- BC by auto. apply prod_ext; auto.
Qed.

(* A matrix near one: S = 1 + Z with row sums of |Z| at most q < 1. *)
Section NearOne.
Variables (n : nat) (S : matrix) (z : matrix) (q r : R).
Hypothesis Hz : forall i j, (i < n)%nat -> (j < n)%nat -> Rabs (S i j - delta i j) <= z i j.
Hypothesis Hq : forall i, (i < n)%nat -> Sum n (z i) <= q.
Hypothesis Hq1 : q < 1.
Hypothesis Hr : 1 <= r * (1 - q).

Lemma near_one_bound c b : (forall i, (i < n)%nat -> Rabs (apply n S c i) <= b) -> 0 <= b ->
  forall i, (i < n)%nat -> Rabs (c i) <= r * b.
Proof.
  intros Hb Hb0. destruct (largest n (fun i => Rabs (c i))) as (m & Hm & Hall & Hex); [intros; apply Rabs_pos|].
  assert (Hr0 : 0 < r) by (apply Rmult_lt_reg_r with (1 - q); lra).
  assert (Hmb : m <= r * b).
  { destruct Hex as [-> | (i & Hi & E)]; [apply Rmult_le_pos; lra|].
    assert (B : Rabs (c i) <= b + q * m).
    { replace (c i) with (apply n S c i - Sum n (fun k => (S i k - delta i k) * c k)).
      2:{ unfold apply. rewrite (Sum_ext n (fun k => (S i k - delta i k) * c k) (fun k => S i k * c k - delta i k * c k))
            by (intros; ring). rewrite Sum_minus, Sum_delta by auto. ring. }
      eapply Rle_trans; [apply Rabs_minus_le|]. apply Rplus_le_compat; auto.
      eapply Rle_trans; [apply Sum_abs_mul with (a := z i) (b := fun _ => m); auto|].
      rewrite (Sum_scal_r n m (z i)). apply Rmult_le_compat_r; auto. }
    rewrite <- E in B.
    assert (m * (1 - q) <= b) by lra.
    apply Rle_trans with (r * (m * (1 - q))).
    - replace (r * (m * (1 - q))) with (m * (r * (1 - q))) by ring.
      rewrite <- (Rmult_1_r m) at 1. apply Rmult_le_compat_l; auto.
    - apply Rmult_le_compat_l; lra. }
  intros i Hi. specialize (Hall i Hi). lra.
Qed.

Lemma near_one_injective : injective n S.
Proof.
  intros c Hc j Hj. assert (B := near_one_bound c 0).
  assert (Rabs (c j) <= r * 0).
  { apply B; auto; [|lra]. intros i Hi. rewrite Hc, Rabs_R0 by auto. lra. }
  rewrite Rmult_0_r in H. assert (P := Rabs_pos (c j)).
  destruct (Req_dec (c j) 0) as [|Hne]; auto. apply Rabs_pos_lt in Hne. lra.
Qed.

(* |S^-1 - 1| <= z + (row sums of z^2) r, entry by entry *)
Lemma near_one_inverse X : is_one n (prod n S X) -> forall i j, (i < n)%nat -> (j < n)%nat ->
  Rabs (X i j - delta i j) <= z i j + Sum n (fun k => prod n z z i k) * r.
Proof.
  intros HX i j Hi Hj.
  set (Z := fun i j => S i j - delta i j).
  assert (Ent : forall k l, (k < n)%nat -> (l < n)%nat -> Rabs (X k l) <= r).
  { intros k l Hk Hl. rewrite <- (Rmult_1_r r). apply (near_one_bound (fun k => X k l)); auto; [|lra].
    intros p Hp. change (apply n S (fun k => X k l) p) with (prod n S X p l). rewrite HX by auto.
    unfold delta. destruct Nat.eqb; [rewrite Rabs_R1 | rewrite Rabs_R0]; lra. }
  assert (E1 : forall k, (k < n)%nat -> X k j = delta k j - apply n Z (fun l => X l j) k).
  { intros k Hk. rewrite <- (HX k j Hk Hj). unfold prod, apply, Z.
    rewrite (Sum_ext n (fun l => (S k l - delta k l) * X l j) (fun l => S k l * X l j - delta k l * X l j)) by (intros; ring).
    rewrite Sum_minus, Sum_delta by auto. ring. }
  assert (E2 : X i j - delta i j = - Z i j + apply n (prod n Z Z) (fun l => X l j) i).
  { rewrite apply_prod. rewrite (E1 i Hi). unfold apply at 1.
    rewrite (Sum_ext n _ (fun l => Z i l * delta l j - Z i l * apply n Z (fun p => X p j) l)).
    - rewrite Sum_minus, Sum_delta_r by auto. unfold apply at 2. ring.
    - intros l Hl. rewrite (E1 l Hl) at 1. ring. }
  rewrite E2. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. apply Rplus_le_compat; [apply Hz; auto|].
  rewrite <- Sum_scal_r. unfold apply.
  apply (Sum_abs_mul n (prod n Z Z i) (fun l => X l j) (prod n z z i) (fun _ => r)); auto.
  intros k Hk. unfold prod at 1. apply Sum_abs_mul; unfold Z; auto.
Qed.
End NearOne.
