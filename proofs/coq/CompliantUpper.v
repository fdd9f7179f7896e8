(** * The compliant model: an upper bound by Theta alone

    proofs/finite_epsilon_zeros.md, section 4 (f). Let 0 < eta <= eta0, 2 mu^3 <= 1, gamma = (1 - mu^3)/3. The weight of
    the slow solution is e^(-r^3/3 + h) with 0 <= h <= r^3/6 <= gamma r^3 and h <= eta r^4/8, so e^h - 1 <= h (e^(gamma
    r^3) - 1)/(gamma r^3) <= (eta0/(8 gamma)) r (e^(gamma r^3) - 1). The right side is the weight of (eta0/(8 gamma))
    (mu^(b-1) Theta'(tau/mu) - Theta'(tau)), the first part by r = mu rho. So the inequality holds where the integrals
    converge; all terms beyond the first of the expansion at -oo are O(x^(b-4)), so it goes down to n > b - 4 as in
    [LeftExpansion.v]. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral ImproperIntegral Family
  Ends CompliantKernel CompliantIntegral
  CompliantSlow LeftExpansion CompliantMonotone CompliantSeries.
Open Scope R_scope.

(** (e^x - 1)/x increases on x > 0. *)
Lemma exp_chord h y : 0 < h <= y -> y * (exp h - 1) <= h * (exp y - 1).
Proof.
intros H. assert (C := exp_convex (h / y) y 0). rewrite exp_0, Rmult_0_r, Rplus_0_r in C.
replace (h / y * y) with h in C by (field; lra).
assert (L : 0 <= h / y <= 1).
{ split. apply Rlt_le, Rdiv_lt_0_compat; lra. apply Rmult_le_reg_r with y; [lra|]. unfold Rdiv.
  rewrite Rmult_assoc, Rinv_l by lra. lra. }
specialize (C L). apply (Rmult_le_compat_l y) in C; [|lra].
replace (y * (h / y * exp y + (1 - h / y) * 1)) with (h * exp y + (y - h)) in C by (field; lra). lra.
Qed.

Section Upper.
Variables (eta0 mu : R).
Hypothesis Hmu : 0 < mu.
Hypothesis Hmu3 : 2 * mu ^ 3 <= 1.
Definition slope_weight : R := 3 * eta0 / (8 * (1 - mu ^ 3)).

Lemma weight_upper eta r : 0 < eta <= eta0 -> 0 < r ->
  exp (weight_exponent eta r) <= exp (- (r ^ 3 / 3))
    + slope_weight * (r * (exp (- (mu ^ 3 * r ^ 3 / 3)) - exp (- (r ^ 3 / 3)))).
Proof.
intros He Hr. destruct (weight_bounds eta r ltac:(lra) Hr) as (B1 & B2 & B3).
assert (R3 : 0 < r ^ 3) by (apply pow_lt, Hr).
set (g := weight_exponent eta r) in *. set (h := g + r ^ 3 / 3) in *. assert (M3 : 0 < mu ^ 3) by (apply pow_lt, Hmu).
set (m := mu ^ 3) in *. set (y := (1 - m) / 3 * r ^ 3).
assert (Hy : h <= y). { unfold y, h. assert (0 <= (1 / 2 - m) * r ^ 3) by (apply Rmult_le_pos; lra). lra. }
assert (Hh : 0 < h) by (unfold h; lra).
assert (C := exp_chord h y (conj Hh Hy)).
assert (E0 := exp_pos (- (r ^ 3 / 3))). set (E := exp (- (r ^ 3 / 3))) in *.
assert (Eg : exp g = E * exp h) by (unfold E; rewrite <- exp_plus; f_equal; unfold h; ring).
assert (Ey : exp (- (m * r ^ 3 / 3)) = E * exp y) by (unfold E; rewrite <- exp_plus; f_equal; unfold y; field).
rewrite Eg, Ey.
assert (Y : 0 < exp y - 1) by (assert (H := exp_ineq1 y ltac:(lra)); lra).
assert (Q : h <= eta0 * r ^ 4 / 8).
{ apply Rle_trans with (eta * r ^ 4 / 8); [lra|]. assert (0 < r ^ 4) by (apply pow_lt, Hr).
  assert (eta * r ^ 4 <= eta0 * r ^ 4) by (apply Rmult_le_compat_r; lra). lra. }
assert (Hy0 : 0 < y) by lra.
assert (F : exp h - 1 <= slope_weight * r * (exp y - 1)).
{ apply Rmult_le_reg_l with y; auto.
  replace (y * (slope_weight * r * (exp y - 1))) with (eta0 * r ^ 4 / 8 * (exp y - 1))
    by (unfold slope_weight, y; fold m; field; lra).
  apply Rle_trans with (h * (exp y - 1)); auto. apply Rmult_le_compat_r; lra. }
apply (Rmult_le_compat_l E) in F; [|lra].
replace (E + slope_weight * (r * (E * exp y - E))) with (E + E * (slope_weight * r * (exp y - 1))) by ring. lra.
Qed.

(** mu^(b-1) Theta'(tau/mu) and its derivatives. *)
Section Stretched.
Variables (s : R) (f : nat -> R -> R).
Hypothesis Hs : ok s.
Hypothesis Hf : family 0 s f.
Definition stretched (k : nat) (t : R) : R := Rpower mu (- (s + INR k + 2)) * f (S k) (t / mu).

Lemma stretched_derive k t : is_derive (stretched k) t (stretched (S k) t).
Proof.
unfold stretched. rewrite S_INR.
apply (is_derive_val _ _ (Rpower mu (- (s + INR k + 2)) * (/ mu * f (S (S k)) (t / mu)))).
- apply (is_derive_scal (fun t => f (S k) (t / mu))).
  apply (is_derive_comp (f (S k)) (fun t => t / mu) t (f (S (S k)) (t / mu)) (/ mu)). apply Hf. auto_derive; auto.
  field; lra.
- replace (- (s + INR k + 2)) with (1 + - (s + (INR k + 1) + 2)) by ring. rewrite Rpower_plus, Rpower_1 by auto. field.
  lra.
Qed.

(** Its first term at -oo is that of f (k + 1). *)
Lemma stretched_small k : small (s + INR k + 5) (fun x => stretched k (- x) - f (S k) (- x)).
Proof.
assert (L := family_left 0 s f Hs Hf (S k)). unfold left_rest in L. rewrite S_INR in L. set (q := s + INR k) in *.
replace (s + (INR k + 1)) with (q + 1) in L by (unfold q; ring).
replace (q + 1 + 1) with (q + 2) in L by ring. replace (q + 1 + 4) with (q + 5) in L by ring.
replace (q + 1 + 5) with (q + 6) in L by ring.
set (rest := fun x => f (S k) (- x) - (Gamma (q + 2) * Rpower x (- (q + 2)) - Gamma (q + 5) / 3 * Rpower x (- (q + 5))))
  in L.
assert (L5 : small (q + 5) rest).
{ apply (small_weaken _ 1). replace (q + 5 + INR 1) with (q + 6) by (simpl; ring). exact L. }
assert (M1 : 1 <= / mu).
{ apply Rmult_le_reg_l with mu; auto. rewrite Rinv_r, Rmult_1_r by lra.
  destruct (Rle_lt_dec mu 1) as [|H]; auto. assert (1 < mu ^ 3) by (apply Rlt_pow_R1; [auto|lia]). lra. }
assert (L5m : small (q + 5) (fun x => rest (x / mu))).
{ destruct L5 as [C HC]. exists (C * Rpower (/ mu) (- (q + 5))). intros x Hx.
  assert (Hxm : 1 <= x / mu) by (apply Rle_trans with (1 * 1); [lra|apply Rmult_le_compat; lra]).
  eapply Rle_trans; [apply HC, Hxm|]. unfold Rdiv. rewrite <- Rpower_mult_distr by (try apply Rinv_0_lt_compat; lra).
  right. ring. }
set (P := Rpower mu (- (q + 2))).
assert (S := small_plus _ _ _ (small_minus _ _ _ (small_scal _ P _ L5m) L5)
  (small_scal _ (Gamma (q + 5) / 3 - P * Rpower (/ mu) (- (q + 5)) * (Gamma (q + 5) / 3)) _ (small_power (q + 5)))).
eapply small_ext; [|exact S]. clear S. intros x Hx. cbv beta. unfold stretched, rest. fold q P.
replace (- x / mu) with (- (x / mu)) by (field; lra).
replace (Rpower (x / mu) (- (q + 5))) with (Rpower x (- (q + 5)) * Rpower (/ mu) (- (q + 5)))
  by (apply Rpower_mult_distr; try apply Rinv_0_lt_compat; lra).
replace (Rpower (x / mu) (- (q + 2))) with (Rpower x (- (q + 2)) * / P).
2: { unfold P. rewrite <- Rpower_Ropp. replace (- - (q + 2)) with (q + 2) by ring.
     replace (Rpower mu (q + 2)) with (Rpower (/ mu) (- (q + 2))).
     - apply Rpower_mult_distr; try apply Rinv_0_lt_compat; lra.
     - unfold Rpower. rewrite ln_Rinv by auto. f_equal. ring. }
field. apply Rgt_not_eq, exp_pos.
Qed.
End Stretched.

Variables (b : R) (theta : R -> R).
Hypothesis Hb : not_nat b.
Hypothesis HT : is_Theta b theta.
Let s : R := - b - 1.
Let f := scaled b theta.

Lemma stretched_integral k t : -1 < s + INR k ->
  is_RInt_gen (fun r => Rpower r (s + INR k + 1) * exp (- (mu ^ 3 * r ^ 3 / 3) + r * t)) (at_right 0)
    (Rbar_locally p_infty) (stretched s f k t).
Proof.
intros Hk. assert (K1 : -1 < s + INR (S k)) by (rewrite S_INR; lra).
assert (I := improper_scale _ mu _ Hmu (theta_integral b theta Hb HT (S k) (t / mu) K1)).
apply (is_RInt_gen_scal _ (Rpower mu (- (s + INR k + 2)))) in I.
eapply improper_ext; [|exact I]. intros r Hr.
change (Rpower mu (- (s + INR k + 2)) * (mu * (Rpower (mu * r) (- b - 1 + INR (S k)) * exp
  (- ((mu * r) ^ 3 / 3) + mu * r * (t / mu))))
  = Rpower r (s + INR k + 1) * exp (- (mu ^ 3 * r ^ 3 / 3) + r * t)).
rewrite S_INR. fold s. replace (s + (INR k + 1)) with (s + INR k + 1) by ring.
rewrite <- Rpower_mult_distr by auto.
replace (- ((mu * r) ^ 3 / 3) + mu * r * (t / mu)) with (- (mu ^ 3 * r ^ 3 / 3) + r * t) by (field; lra).
replace (- (s + INR k + 2)) with (- (1) + - (s + INR k + 1)) by ring.
rewrite Rpower_plus, !Rpower_Ropp, Rpower_1 by auto.
field. split; [apply Rgt_not_eq, exp_pos|lra].
Qed.

Theorem slow_upper_bound eta k t : 0 < eta <= eta0 -> -5 < s + INR k ->
  scaled_J eta s k t <= f k t + slope_weight * (stretched s f k t - f (S k) t).
Proof.
intros He. assert (Hs : ok s) by (apply ok_not_nat, Hb). assert (F := scaled_family b theta Hb HT). fold s f in F.
assert (J := scaled_J_family eta ltac:(lra) s Hs).
intros Hk. enough (0 <= slope_weight * (stretched s f k t - f (S k) t) - (scaled_J eta s k t - f k t)) by lra.
apply (chain_nonnegative s (-5) (fun k t => slope_weight * (stretched s f k t - f (S k) t)
  - (scaled_J eta s k t - f k t))); auto.
- intros j u. apply (is_derive_minus (fun t => slope_weight * (stretched s f j t - f (S j) t)) (fun t =>
    scaled_J eta s j t - f j t)).
  + apply (is_derive_scal (fun t => stretched s f j t - f (S j) t)).
    apply (is_derive_minus (stretched s f j) (f (S j))); [apply stretched_derive, F|apply F].
  + apply (is_derive_minus (scaled_J eta s j) (f j)); [apply J|apply F].
- intros j Hj. replace (s + INR j - -5) with (s + INR j + 5) by ring.
  apply (small_minus _ (fun x => slope_weight * (stretched s f j (- x) - f (S j) (- x)))).
  + apply small_scal, (stretched_small s f Hs F).
  + apply (difference_small s 0 eta f (scaled_J eta s) Hs F J).
- intros j u Hj. assert (J1 : -1 < s + INR (S j)) by (rewrite S_INR; lra).
  assert (P := is_RInt_gen_plus _ _ _ _ (theta_integral b theta Hb HT j u Hj)
    (is_RInt_gen_scal _ slope_weight _ (is_RInt_gen_minus _ _ _ _ (stretched_integral j u Hj)
      (theta_integral b theta Hb HT (S j) u J1)))).
  enough (scaled_J eta s j u <= f j u + slope_weight * (stretched s f j u - f (S j) u)) by lra.
  eapply improper_le; [|exact (scaled_J_integral eta ltac:(lra) s j u Hj)|exact P].
  intros r Hr.
  change (Rpower r (s + INR j) * exp (weight_exponent eta r + r * u) <= Rpower r (s + INR j) * exp
    (- (r ^ 3 / 3) + r * u) + slope_weight *
    (Rpower r (s + INR j + 1) * exp (- (mu ^ 3 * r ^ 3 / 3) + r * u) - Rpower r (s + INR (S j)) * exp
      (- (r ^ 3 / 3) + r * u))).
  rewrite S_INR. replace (s + (INR j + 1)) with (s + INR j + 1) by ring.
  rewrite (Rpower_split r (s + INR j + 1) 1 (s + INR j)) by (auto; simpl; ring). rewrite !exp_plus.
  assert (W := weight_upper eta r He Hr). set (Q := Rpower r (s + INR j)). assert (HQ : 0 < Q) by apply exp_pos.
  set (X := exp (r * u)). assert (HX : 0 < X) by apply exp_pos.
  assert (HQX : 0 < Q * X) by (apply Rmult_lt_0_compat; auto).
  apply (Rmult_le_compat_l (Q * X)) in W; [|lra]. simpl in W |- *. lra.
Qed.
End Upper.
