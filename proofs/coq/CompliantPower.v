(** * The compliant model: the slow solution left of 0

    proofs/finite_epsilon_zeros.md, section 4 (a): for b < 3 and T < 0, Gamma(-b) (F_b(T) - (-T)^b) < 0. Where the
    integrals converge that is e^psi < 1; the difference is O((-T)^(b-3)) at T -> -oo, so the inequality comes from its
    derivatives as in [LeftExpansion.v], whatever b < 3 is. The difference decreases in - T: hence Gamma(-b) F_b(0) < 0
    for 0 < b < 3. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus GammaFunction ImproperIntegral Family CompliantKernel CompliantIntegral
  CompliantSlow
  LeftExpansion CompliantMonotone CompliantThreshold.
Open Scope R_scope.

(** ** Left of 0: below the power *)
Lemma power_derive u x : 0 < x -> is_derive (fun x => Rpower x u) x (u * Rpower x (u - 1)).
Proof.
intros Hx. unfold Rpower at 1. auto_derive; auto.
replace (u - 1) with (u + - (1)) by ring. rewrite Rpower_plus, Rpower_Ropp, Rpower_1 by auto. unfold Rpower. field. lra.
Qed.

Lemma positive_before_infinity (f df : R -> R) q : (forall x, 0 < x -> is_derive f x (- df x)) ->
  (forall x, 0 < x -> 0 < df x) ->
  0 < q -> small q f -> forall x, 0 < x -> 0 < f x.
Proof.
intros D Hp Hq Hs x Hx. apply Rnot_le_lt. intros Hle.
assert (Dec : forall u v, 0 < u -> u < v -> f v < f u).
{ intros u v Hu Huv. destruct (mvt_open f (fun x => - df x) u v Huv (fun t Ht => D t ltac:(lra))) as (c & Hc & E).
  assert (0 < df c * (v - u)) by (apply Rmult_lt_0_compat; [apply Hp|]; lra). lra. }
assert (H1 := Dec x (x + 1) Hx ltac:(lra)).
destruct (small_lim q f Hq Hs (- f (x + 1)) ltac:(lra)) as (M & HM & H).
assert (X1 := Rmax_l M (x + 2)). assert (X2 := Rmax_r M (x + 2)).
specialize (H (Rmax M (x + 2)) X1). assert (H2 := Dec (x + 1) (Rmax M (x + 2)) ltac:(lra) ltac:(lra)).
apply Rabs_def2 in H. lra.
Qed.

Section Left.
Variables (eta s : R).
Hypothesis He : 0 < eta.
Hypothesis Hs : ok s.

(** What the power is above the member k of the family, at t = - x. *)
Definition gap (k : nat) (x : R) : R := Gamma (s + INR k + 1) * Rpower x (- (s + INR k + 1)) - scaled_J eta s k (- x).

Lemma gap_derive k x : 0 < x -> is_derive (gap k) x (- gap (S k) x).
Proof.
intros Hx. unfold gap. rewrite S_INR. set (q := s + INR k).
replace (s + (INR k + 1) + 1) with (q + 1 + 1) by (unfold q; ring).
assert (Nq : q + 1 <> 0) by (apply ok_neq, ok_plus, Hs).
rewrite (Gamma_step (q + 1) (q + 1 + 1)) by auto.
apply (is_derive_val _ _ (Gamma (q + 1) * (- (q + 1) * Rpower x (- (q + 1 + 1))) - (- scaled_J eta s (S k) (- x))));
  [|ring].
apply (is_derive_minus (fun x => Gamma (q + 1) * Rpower x (- (q + 1))) (fun x => scaled_J eta s k (- x))).
- apply (is_derive_scal (fun x => Rpower x (- (q + 1)))).
  replace (- (q + 1 + 1)) with (- (q + 1) - 1) by ring. apply power_derive, Hx.
- apply (is_derive_val _ _ (-1 * scaled_J eta s (S k) (- x))); [|ring].
  apply (is_derive_comp (scaled_J eta s k) Ropp x (scaled_J eta s (S k) (- x)) (-1)).
  apply (scaled_J_family eta He s Hs). auto_derive; auto.
Qed.

Lemma gap_small k : small (s + INR k + 4) (gap k).
Proof.
assert (L := family_left eta s (scaled_J eta s) Hs (scaled_J_family eta He s Hs) k). unfold left_rest in L.
set (q := s + INR k) in *.
assert (L1 : small (q + 4) (fun x => -1 * (scaled_J eta s k (- x) -
  (Gamma (q + 1) * Rpower x (- (q + 1)) - Gamma (q + 4) / 3 * Rpower x (- (q + 4)))))).
{ apply small_scal, (small_weaken _ 1). replace (q + 4 + INR 1) with (q + 5) by (simpl; ring). exact L. }
eapply small_ext; [|exact (small_plus _ _ _ L1 (small_scal _ (Gamma (q + 4) / 3) _ (small_power (q + 4))))].
intros x _. unfold gap. fold q. simpl. ring.
Qed.

(** Where the integral converges: e^(weight) < 1. *)
Lemma gap_positive_high k x : -1 < s + INR k -> 0 < x -> 0 < gap k x.
Proof.
intros Hk Hx. unfold gap. set (q := s + INR k) in *.
enough (scaled_J eta s k (- x) < Rpower x (- (q + 1)) * Gamma (q + 1)) by lra.
eapply improper_lt; [| | |apply scaled_J_integral; auto|apply Gamma_scaled; auto; lra].
- intros r Hr. fold q. replace (q + 1 - 1) with q by ring. apply Rmult_lt_compat_l; [apply exp_pos|].
  apply exp_increasing.
  destruct (weight_bounds eta r He Hr) as (_ & B & _). assert (0 < r ^ 3) by (apply pow_lt, Hr). lra.
- intros r Hr. apply (scaled_J_continuous eta He); auto.
- intros r Hr. apply (ex_derive_continuous (fun r => Rpower r (q + 1 - 1) * exp (- (x * r))) r).
  unfold Rpower. auto_derive; auto.
Qed.

Lemma gap_positive k x : -4 < s + INR k -> 0 < x -> 0 < gap k x.
Proof.
assert (H : forall n k x, -4 < s + INR k -> -1 < s + INR k + INR n -> 0 < x -> 0 < gap k x).
{ induction n as [|n IH]; intros j y Hj Hn Hy.
  - apply gap_positive_high; auto. simpl in Hn. lra.
  - rewrite S_INR in Hn. apply (positive_before_infinity (gap j) (gap (S j)) (s + INR j + 4)); auto using gap_derive,
      gap_small; [|lra].
    intros u Hu. apply IH; rewrite ?S_INR; lra. }
intros Hk. destruct (ex_valid (s + INR k)) as [n Hn]. apply (H n k x Hk Hn).
Qed.

Theorem below_power k x : -4 < s + INR k -> 0 < x -> scaled_J eta s k (- x) < Gamma (s + INR k + 1) * Rpower x
  (- (s + INR k + 1)).
Proof. intros Hk Hx. assert (H := gap_positive k x Hk Hx). unfold gap in H. lra. Qed.

(** At 0, where the power is 0: the gap decreases in x. *)
Theorem negative_at_0 k : -4 < s + INR k < -1 -> scaled_J eta s k 0 < 0.
Proof.
intros Hk. set (q := s + INR k) in *. set (d := gap k 1).
assert (Hd : 0 < d) by (apply gap_positive; fold q; lra).
set (A := Rabs (Gamma (q + 1)) + 1). assert (HA : 0 < A) by (unfold A; generalize (Rabs_pos (Gamma (q + 1))); lra).
(* x0 < 1 with A x0^-(q+1) <= d/2 *)
set (u := - (q + 1)). assert (Hu : 0 < u) by (unfold u; lra).
set (x0 := Rmin (/ 2) (Rpower (d / 2 / A) (/ u))).
assert (HdA : 0 < d / 2 / A) by (apply Rdiv_lt_0_compat; lra).
assert (Hx0 : 0 < x0) by (apply Rmin_glb_lt; [lra|apply exp_pos]).
assert (Hx1 : x0 <= / 2) by apply Rmin_l.
assert (Bound : forall x, 0 < x <= x0 -> scaled_J eta s k (- x) <= - (d / 2)).
{ intros x Hx.
  assert (G : d < gap k x).
  { destruct (mvt_open (gap k) (fun x => - gap (S k) x) x 1 ltac:(lra)) as (c & Hc & E).
    { intros t Ht. apply gap_derive. lra. }
    assert (P : 0 < gap (S k) c) by (apply gap_positive; rewrite ?S_INR; unfold q in Hk; lra).
    assert (0 < gap (S k) c * (1 - x)) by (apply Rmult_lt_0_compat; lra). fold d in E. lra. }
  unfold gap in G. fold q in G. fold u in G.
  assert (P0 : 0 < Rpower x u) by apply exp_pos.
  assert (P1 : Rpower x u <= d / 2 / A).
  { apply Rle_trans with (Rpower (Rpower (d / 2 / A) (/ u)) u).
    - apply Rle_Rpower_l; [lra|]. split; [lra|]. apply Rle_trans with x0; [lra|apply Rmin_r].
    - rewrite Rpower_mult, Rinv_l, Rpower_1 by lra. lra. }
  assert (P2 : A * Rpower x u <= d / 2).
  { apply (Rmult_le_compat_l A) in P1; [|lra]. replace (A * (d / 2 / A)) with (d / 2) in P1 by (field; lra). exact P1. }
  assert (P3 : Gamma (q + 1) * Rpower x u <= A * Rpower x u).
  { apply Rmult_le_compat_r; [lra|]. unfold A. generalize (Rle_abs (Gamma (q + 1))). lra. }
  lra. }
assert (D : ex_derive (fun t => - scaled_J eta s k t) 0).
{ exists (- scaled_J eta s (S k) 0). apply (is_derive_opp (scaled_J eta s k)). apply (scaled_J_family eta He s Hs). }
assert (C := closed_ge (fun t => - scaled_J eta s k t) (- x0) 0 (d / 2) ltac:(lra) D).
assert (d / 2 <= - scaled_J eta s k 0); [apply C|lra].
intros t Ht. assert (B := Bound (- t) ltac:(lra)). rewrite Ropp_involutive in B. lra.
Qed.
End Left.

(** ** The slow solution *)
Section Slow.
Variable e : R.
Hypothesis He : 0 < e.
Let eta := Rpower (e / 2) (1 / 3).

Lemma eta_positive : 0 < eta. Proof. apply exp_pos. Qed.

Lemma eta_cube : 2 * eta ^ 3 = e.
Proof. unfold eta. rewrite Rpower_third by lra. field. Qed.

Lemma Fe_scaled b t : not_nat b -> Gamma (- b) * Fe e b t = Rpower eta (- b) * scaled_J eta (- b - 1) 0 (eta * t).
Proof.
intros Hb. assert (H := scaled_slow b 0 eta (eta * t) eta_positive Hb). rewrite eta_cube in H. simpl Derive_n in H.
replace (eta * t / eta) with t in H by (field; apply Rgt_not_eq, eta_positive).
rewrite <- H. replace (b - INR 0) with b by (simpl; ring). rewrite Rpower_Ropp. field. apply Rgt_not_eq, exp_pos.
Qed.

Theorem slow_below_power b x : not_nat b -> b < 3 -> 0 < x -> Gamma (- b) * (Fe e b (- x) - Rpower x b) < 0.
Proof.
intros Hb H3 Hx. assert (Hn := eta_positive).
rewrite Rmult_minus_distr_l, Fe_scaled by auto.
assert (B := below_power eta (- b - 1) Hn (ok_not_nat b Hb) 0 (eta * x) ltac:(simpl; lra) ltac:(apply Rmult_lt_0_compat;
  auto)).
replace (- b - 1 + INR 0 + 1) with (- b) in B by (simpl; ring). rewrite Ropp_involutive in B.
replace (eta * - x) with (- (eta * x)) by ring.
apply (Rmult_lt_compat_l (Rpower eta (- b))) in B; [|apply exp_pos].
rewrite <- Rpower_mult_distr, Rpower_Ropp in B by auto.
replace (/ Rpower eta b * (Gamma (- b) * (Rpower eta b * Rpower x b))) with (Gamma (- b) * Rpower x b) in B
  by (field; apply Rgt_not_eq, exp_pos).
rewrite Rpower_Ropp. lra.
Qed.

Theorem slow_at_0 b : not_nat b -> 0 < b < 3 -> Gamma (- b) * Fe e b 0 < 0.
Proof.
intros Hb H3. rewrite Fe_scaled, Rmult_0_r by auto.
assert (N := negative_at_0 eta (- b - 1) eta_positive (ok_not_nat b Hb) 0 ltac:(simpl; lra)).
assert (P : 0 < Rpower eta (- b)) by apply exp_pos.
assert (0 < Rpower eta (- b) * - scaled_J eta (- b - 1) 0 0) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
End Slow.
