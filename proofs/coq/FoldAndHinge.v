(** * Folds and hinges

    proofs/fold.md. A strictly convex function that is negative at 0 and positive at the ends has exactly two zeros,
    both simple; if it vanishes at 0 with its slope it is positive elsewhere. At b = n = 2 mod 3 P_n has a double zero
    at 0; F increases with b. The hinge: a monotone function on one side of 0 with a known sign at 0. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus WellPosed Family SignsAtZero IntegerPolynomials PolynomialSum.
Open Scope R_scope.

Section Convex.
Variables (f f1 f2 : R -> R) (t1 t2 : R).
Hypothesis D0 : forall t, is_derive f t (f1 t).
Hypothesis D1 : forall t, is_derive f1 t (f2 t).
Hypothesis H12 : t1 < 0 < t2.
Hypothesis Hconvex : forall t, t1 <= t <= t2 -> 0 < f2 t.

Lemma slope_increases x y : t1 <= x -> x < y -> y <= t2 -> f1 x < f1 y.
Proof.
intros Hx Hxy Hy. destruct (mvt_open _ _ x y Hxy (fun s _ => D1 s)) as (c & Hc & E).
assert (H := Hconvex c ltac:(lra)). assert (0 < f2 c * (y - x)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma between x y : x < y -> exists c, x < c < y /\ f y - f x = f1 c * (y - x).
Proof. intros Hxy. exact (mvt_open _ _ x y Hxy (fun s _ => D0 s)). Qed.

Lemma convex_double_zero : f 0 = 0 -> f1 0 = 0 -> forall t, t1 <= t <= t2 -> t <> 0 -> 0 < f t.
Proof.
intros E0 E1 t Ht Hne. destruct (Rtotal_order t 0) as [H|[H|H]]; [|contradiction|].
- destruct (between t 0 H) as (c & Hc & E). assert (A := slope_increases c 0 ltac:(lra) ltac:(lra) ltac:(lra)).
  assert (0 < - f1 c * (0 - t)) by (apply Rmult_lt_0_compat; lra). lra.
- destruct (between 0 t H) as (c & Hc & E). assert (A := slope_increases 0 c ltac:(lra) ltac:(lra) ltac:(lra)).
  assert (0 < f1 c * (t - 0)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma convex_two_zeros : f 0 < 0 -> 0 < f t1 -> 0 < f t2 ->
  exists x y, t1 < x < 0 /\ 0 < y < t2 /\ f x = 0 /\ f y = 0 /\ f1 x < 0 /\ 0 < f1 y /\
    forall t, t1 <= t <= t2 -> f t = 0 -> t = x \/ t = y.
Proof.
intros F0 F1 F2. assert (Hc := derive_continuity _ _ D0).
destruct (IVT_cor f t1 0 Hc ltac:(lra)) as (x & Hx & Ex). { assert (0 < f t1 * - f 0) by (apply Rmult_lt_0_compat; lra).
lra. }
destruct (IVT_cor f 0 t2 Hc ltac:(lra)) as (y & Hy & Ey). { assert (0 < - f 0 * f t2) by (apply Rmult_lt_0_compat; lra).
lra. }
assert (X : t1 < x < 0).
{ split; [destruct (Rle_lt_or_eq_dec _ _ (proj1 Hx)) as [H|H]|destruct (Rle_lt_or_eq_dec _ _ (proj2 Hx)) as [H|H]];
    auto;
  exfalso; [rewrite H in F1|rewrite H in Ex]; lra. }
assert (Y : 0 < y < t2).
{ split; [destruct (Rle_lt_or_eq_dec _ _ (proj1 Hy)) as [H|H]|destruct (Rle_lt_or_eq_dec _ _ (proj2 Hy)) as [H|H]];
    auto;
  exfalso; [rewrite <- H in Ey|rewrite H in Ey]; lra. }
assert (SX : f1 x < 0).
{ destruct (between x 0 (proj2 X)) as (c & C & E). assert (A := slope_increases x c ltac:(lra) ltac:(lra) ltac:(lra)).
  apply Rnot_le_lt. intros Hp. assert (0 <= f1 c * (0 - x)) by (apply Rmult_le_pos; lra). lra. }
assert (SY : 0 < f1 y).
{ destruct (between 0 y (proj1 Y)) as (c & C & E). assert (A := slope_increases c y ltac:(lra) ltac:(lra) ltac:(lra)).
  apply Rnot_le_lt. intros Hp. assert (0 <= - f1 c * (y - 0)) by (apply Rmult_le_pos; lra). lra. }
exists x, y. refine (conj X (conj Y (conj Ex (conj Ey (conj SX (conj SY _)))))).
intros t Ht Et. destruct (Rtotal_order t x) as [A|[A|A]]; [exfalso|left; auto|].
- destruct (between t x A) as (c & C & E). assert (G := slope_increases c x ltac:(lra) ltac:(lra) ltac:(lra)).
  assert (0 < - f1 c * (x - t)) by (apply Rmult_lt_0_compat; lra). lra.
- destruct (Rtotal_order t y) as [K|[K|K]]; [exfalso|right; auto|exfalso].
  + destruct (between x t A) as (c & C & E). destruct (between t y K) as (d & G & E').
    assert (L := slope_increases c d ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (Z1 : f1 c = 0) by (destruct (Rmult_integral (f1 c) (t - x)); lra).
    assert (Z2 : f1 d = 0) by (destruct (Rmult_integral (f1 d) (y - t)); lra). lra.
  + destruct (between y t K) as (c & C & E). assert (G := slope_increases y c ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (0 < f1 c * (t - y)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

End Convex.

Theorem fold (n : nat) (t1 t2 lo hi : R) (F : R -> R -> R) : (n mod 3 = 2)%nat -> t1 < 0 < t2 ->
  lo <= INR n <= hi ->
  (forall b, lo <= b <= hi -> b <> INR n -> is_Theta b (F b)) -> (forall t, F (INR n) t = Poly n t) ->
  (forall t b, t1 <= t <= t2 -> lo <= b <= hi -> 0 < Derive_n (F b) 2 t) ->
  (forall t b b', t1 <= t <= t2 -> lo <= b -> b < b' -> b' <= hi -> F b t < F b' t) ->
  (forall b, lo <= b <= hi -> 0 < F b t1 /\ 0 < F b t2) ->
  forall b, lo <= b <= hi ->
    (b < INR n -> exists x y, t1 < x < 0 /\ 0 < y < t2 /\ F b x = 0 /\ F b y = 0 /\ Derive (F b) x < 0 /\
       0 < Derive (F b) y /\ forall t, t1 <= t <= t2 -> F b t = 0 -> t = x \/ t = y) /\
    (b = INR n -> forall t, t1 <= t <= t2 -> (F b t = 0 <-> t = 0)) /\
    (INR n < b -> forall t, t1 <= t <= t2 -> 0 < F b t).
Proof.
intros Hn H12 Hin HT HP Hc Hm He b Hb.
assert (EP : forall t, F (INR n) t = Pn n t) by (intros t; rewrite HP; apply Poly_Pn).
assert (HM := Pn_mult_0 n). rewrite Hn in HM. destruct HM as (Z0 & Z1 & _).
assert (DP : forall t, t1 <= t <= t2 -> t <> 0 -> 0 < Pn n t).
{ apply (convex_double_zero (Pn n) (Pn1 n) (Pn2 n) t1 t2 (Pn_derive' n) (Pn_chain1 n) H12); auto.
  intros t Ht. rewrite <- Pn_Derive2. rewrite <- (Derive_n_ext _ _ 2 t EP). apply Hc; auto. }
assert (P0 : forall t, t1 <= t <= t2 -> 0 <= Pn n t).
{ intros t Ht. destruct (Req_dec t 0) as [->|Hne]; [lra|]. apply Rlt_le, DP; auto. }
refine (conj _ (conj _ _)).
- intros Hlt. destruct (is_Theta_elim b (F b) (HT b Hb ltac:(lra))) as (D0 & D1 & _).
  apply (convex_two_zeros (F b) (Derive (F b)) (Derive_n (F b) 2) t1 t2 D0 D1 H12).
  + intros t Ht. apply Hc; auto.
  + assert (A := Hm 0 b (INR n) ltac:(lra) ltac:(lra) Hlt ltac:(lra)). rewrite EP, Z0 in A. exact A.
  + apply He, Hb.
  + apply He, Hb.
- intros -> t Ht. rewrite EP. split; [|intros ->; exact Z0].
  intros E. destruct (Req_dec t 0) as [H|H]; auto. assert (A := DP t Ht H). lra.
- intros Hgt t Ht. assert (A := Hm t (INR n) b Ht ltac:(lra) Hgt ltac:(lra)). rewrite EP in A.
  assert (B := P0 t Ht). lra.
Qed.

(** The hinge: to the left of 0 if -s f' > 0, to the right if s f' > 0. *)
Theorem hinge (f : R -> R) (s t1 t2 : R) : t1 <= 0 <= t2 -> (forall t, ex_derive f t) -> 0 <= s * f 0 ->
  ((forall t, t1 <= t <= 0 -> 0 < - (s * Derive f t)) -> forall t, t1 <= t < 0 -> 0 < s * f t) /\
  ((forall t, 0 <= t <= t2 -> 0 < s * Derive f t) -> forall t, 0 < t <= t2 -> 0 < s * f t).
Proof.
intros H12 Hf H0.
assert (D : forall t, is_derive f t (Derive f t)) by (intros t; apply Derive_correct, Hf).
split; intros Hs t Ht.
- destruct (mvt_open _ _ t 0 (proj2 Ht) (fun u _ => D u)) as (c & C & E). specialize (Hs c ltac:(lra)).
  assert (0 < - (s * Derive f c) * (0 - t)) by (apply Rmult_lt_0_compat; lra).
  assert (s * f 0 - s * f t = s * Derive f c * (0 - t)) by (rewrite <- Rmult_minus_distr_l, E; ring). lra.
- destruct (mvt_open _ _ 0 t (proj1 Ht) (fun u _ => D u)) as (c & C & E). specialize (Hs c ltac:(lra)).
  assert (0 < s * Derive f c * (t - 0)) by (apply Rmult_lt_0_compat; lra).
  assert (s * f t - s * f 0 = s * Derive f c * (t - 0)) by (rewrite <- Rmult_minus_distr_l, E; ring). lra.
Qed.
