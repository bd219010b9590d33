(* One step of a certificate: its conditions as a computation, and what they prove. *)
Require Import Reals Lra Lia ZArith List Bool.
From Bignums Require Import BigZ.
From Libration Require Import Sums Matrices Derivative Exit Blocks TheoremK Dyadic Chebyshev Polynomial Norms Field.
Import ListNotations.
Open Scope R_scope.

(* A set of states: centre + frame c with |c_b| <= radius_b. *)
Record states := States { centre : list num; axes : list (list num); groups : list nat; group_count : nat; sizes : list num }.

(* A step of the length 2 half; on it t = begin + half (1 + x) with x in [-1, 1]. The tube: curve + frame c. *)
Record step := Step { half : num; curve : list poly; frame : list (list poly); coframe : list (list poly);
  blocks : list nat; block_count : nat; first : list num; last : list num }.

Definition block_of (l : list nat) (i : nat) : nat := nth i l O.
Definition radius (s : step) (b : nat) (x : R) : R :=
  (real (vget (first s) b) * (1 - x) + real (vget (last s) b) * (1 + x)) / 2.

Section Conditions.
Variables (n : nat) (scale_of_time : Z) (rights : list expr).

(* The equations: scale_of_time y_i' = the i-th expression. *)
Definition right (i : nat) : expr := nth i rights (Const 0).

Definition in_states (s : states) (v : nat -> R) : Prop := exists c,
  (forall i, (i < n)%nat -> v i = real (vget (centre s) i) + Sum n (fun j => real (mget (axes s) i j) * c j)) /\
  forall b, (b < group_count s)%nat ->
    square n (block_of (groups s)) b c <= real (vget (sizes s) b) * real (vget (sizes s) b).
Definition in_step (s : step) (x : R) (v : nat -> R) : Prop := exists c,
  (forall i, (i < n)%nat -> v i = peval (pget (curve s) i) x + Sum n (fun j => peval (pmget (frame s) i j) x * c j)) /\
  forall b, (b < block_count s)%nat -> square n (block_of (blocks s)) b c <= radius s b x * radius s b x.

Definition product (A B : list (list num)) : list (list num) :=
  grid n n (fun i j => up (nsum n (fun k => mul (mget A i k) (mget B k j)))).
Definition image (A : list (list num)) (v : list num) : list num :=
  table n (fun i => up (nsum n (fun k => mul (mget A i k) (vget v k)))).
Definition magnitudes (P : list (list poly)) : list (list num) := grid n n (fun i j => pnorm (pmget P i j)).

(* 1: the frame. *)
Definition deviation (s : step) : list (list num) :=
  grid n n (fun i j => pnorm (psub (psum n (fun k => pmul (pmget (coframe s) i k) (pmget (frame s) k j)))
    (if Nat.eqb i j then pconst one else pzero))).
Definition row_sum (z : list (list num)) : num := largest_of n (fun i => nsum n (mget z i)).
Definition inverse_bound (z : list (list num)) (r : num) : list (list num) :=
  grid n n (fun i j => up (add (if Nat.eqb i j then one else zero)
    (add (mget z i j) (mul (nsum n (fun k => nsum n (fun l => mul (mget z i l) (mget z l k)))) r)))).

(* 2: the set in which the step begins. *)
Definition minus_one : num := opp one.
Definition joint_ok (s : step) (N : list (list num)) (old : states) : bool :=
  let U := grid n n (fun i j => pvalue (pmget (coframe s) i j) minus_one) in
  let gap := table n (fun i => sub (vget (centre old) i) (pvalue (pget (curve s) i) minus_one)) in
  let turned := product N (grid n n (fun i j => up (abs (nsum n (fun k => mul (mget U i k) (mget (axes old) k j)))))) in
  let moved := image N (table n (fun i => up (abs (nsum n (fun k => mul (mget U i k) (vget gap k)))))) in
  all n (fun i => Nat.ltb (block_of (groups old) i) (group_count old)) &&
  all (group_count old) (fun d => leb zero (vget (sizes old) d)) &&
  all (block_count s) (fun b => leb
    (add (nsum (group_count old) (fun d =>
        mul (matrix_norm n (block_of (blocks s)) (block_of (groups old)) b d (mget turned)) (vget (sizes old) d)))
      (vector_norm n (block_of (blocks s)) b (vget moved)))
    (vget (first s) b)).

(* 3: the defect, times V^-1. The field is half times the right sides, and everything is multiplied by scale_of_time. *)
Definition time_of (begin : num) (s : step) : poly := padd (pconst (add begin (half s))) ([BigZ.zero; fst (half s)], (snd (half s) - 1)%Z).
Definition tiny : num := (BigZ.one, (-1000)%Z).
Definition largest_radius (s : step) (b : nat) : num := add (max (vget (first s) b) (vget (last s) b)) tiny.
Definition reach (s : step) (V : list (list num)) : list num :=
  table n (fun i => up (nsum (block_count s) (fun b => mul (vector_norm n (block_of (blocks s)) b (mget V i)) (largest_radius s b)))).
Definition field_models (begin : num) (s : step) (rho : list num) : list model :=
  table n (fun i => model_of n (time_of begin s) (curve s) rho (right i)).
Definition mod_get (T : list model) (i : nat) : model := nth i T (Model pzero [] []).
Definition time_scale : num := num_of_Z scale_of_time.
Definition defect (s : step) (T : list model) : list num :=
  let e := table n (fun k => psub (pscale (half s) (value (mod_get T k))) (pscale time_scale (pderiv (pget (curve s) k)))) in
  table n (fun i => pnorm (psum n (fun k => pmul (pmget (coframe s) i k) (pget e k)))).

(* 4: the linear part, in the frame. *)
Definition linear_part (s : step) (T : list model) : list (list poly) :=
  let H := grid n n (fun k j => psub
    (psum n (fun l => pmul (pscale (half s) (pget (linear (mod_get T k)) l)) (pmget (frame s) l j)))
    (pscale time_scale (pderiv (pmget (frame s) k j)))) in
  grid n n (fun i j => psum n (fun k => pmul (pmget (coframe s) i k) (pmget H k j))).
Definition changes (s : step) (T : list model) : list (list num) :=
  grid n n (fun k l => up (mul (abs (half s)) (vget (change (mod_get T k)) l))).
Definition sum_grid (A B : list (list num)) : list (list num) := grid n n (fun i j => add (mget A i j) (mget B i j)).
Definition rest_grid (A B : list (list num)) : list (list num) := grid n n (fun i j => sub (mget A i j) (mget B i j)).

(* 5 and 6: the growth of the radii. *)
Definition rates (s : step) (B : list (list poly)) (full more : list (list num)) (b d : nat) : option num :=
  let block := block_of (blocks s) in
  if Nat.eqb b d then
    match rate n block (pmget B) b with
    | Some L => Some (add L (matrix_norm n block block b b (mget more)))
    | None => None
    end
  else Some (matrix_norm n block block b d (mget full)).
Definition rate_table (s : step) (B : list (list poly)) (full more : list (list num)) : list (list (option num)) :=
  grid (block_count s) (block_count s) (rates s B full more).
Definition some (a : option num) : num := match a with Some x => x | None => zero end.
Definition is_some (a : option num) : bool := match a with Some _ => true | None => false end.
Definition aget (A : list (list (option num))) (b d : nat) : option num := nth d (nth b A []) None.
Definition growth_ok (s : step) (A : list (list (option num))) (D : nat -> num) (r : list num) (b : nat) : bool :=
  leb (scale (add (nsum (block_count s) (fun d => mul (some (aget A b d)) (vget r d))) (D b)) 1)
    (mul time_scale (sub (vget (last s) b) (vget (first s) b))).

Definition shape_ok (s : step) : bool :=
  ltb zero (half s) && Z.ltb 0 scale_of_time && all n (fun i => below n (right i)) &&
  all n (fun i => Nat.ltb (block_of (blocks s) i) (block_count s)) &&
  all (block_count s) (fun b => leb zero (vget (first s) b) && leb zero (vget (last s) b)).
Definition growth_all (s : step) (A : list (list (option num))) (D : list num) : bool :=
  all (block_count s) (fun b => all (block_count s) (fun d => is_some (aget A b d)) &&
    growth_ok s A (vget D) (first s) b && growth_ok s A (vget D) (last s) b).
Definition frame_ok (q r : num) : bool := ltb q one && leb one (mul r (sub one q)).

Definition step_ok (begin : num) (s : step) (old : states) : bool :=
  let z := deviation s in
  let q := row_sum z in let r := up (inverse_candidate (sub one q)) in
  let N := inverse_bound z r in
  let V := magnitudes (frame s) in let U := magnitudes (coframe s) in
  let T := field_models begin s (reach s V) in
  let B := linear_part s T in let B0 := magnitudes B in
  let full := product N (sum_grid B0 (product U (product (changes s T) V))) in
  let dd := image N (defect s T) in
  let D := table (block_count s) (fun b => vector_norm n (block_of (blocks s)) b (vget dd)) in
  shape_ok s && frame_ok q r && joint_ok s N old && growth_all s (rate_table s B full (rest_grid full B0)) D.
End Conditions.
