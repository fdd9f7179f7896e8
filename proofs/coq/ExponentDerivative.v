(** * Derivative in the exponent

    w >= 0 on r > 0, G(c) = int r^c w dr for c > -1. Then A(c) = int r^c ln(r) w dr converges (ln r + r^-d/d >= 0), G' = A, and A is Lipschitz near c:
    with y = ln r, |e^(hy) - 1 - hy| <= h^2 y^2 e^|hy|, |e^(hy) - 1| |y| <= |h| y^2 e^|hy|, and y^2 e^(d|y|) <= (4/d^2) (r^(2d) + r^(-2d)).
    For w = e^(rt - r^3/3) both are Lipschitz in t, too; so they are continuous in (t, c). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncatedIntegral TruncationLimit GammaFunction ImproperIntegral CompliantKernel
  CompliantMonotone.
Open Scope R_scope.

(** ** Exponentials of |ln r| *)

Lemma exp_abs d y : 0 <= d -> exp (d * Rabs y) <= exp (d * y) + exp (- d * y).
Proof.
intros Hd. assert (P1 := exp_pos (d * y)). assert (P2 := exp_pos (- d * y)).
unfold Rabs. destruct Rcase_abs; [replace (d * - y) with (- d * y) by ring|]; lra.
Qed.

Lemma abs_le_exp d y : 0 < d -> Rabs y <= exp (d * Rabs y) / d.
Proof.
intros Hd. apply Rmult_le_reg_l with d; auto. replace (d * (exp (d * Rabs y) / d)) with (exp (d * Rabs y)) by (field; lra).
assert (H := exp_ineq1_le (d * Rabs y)). lra.
Qed.

Lemma square_le_exp d y : 0 < d -> y ^ 2 <= 4 / d ^ 2 * exp (d * Rabs y).
Proof.
intros Hd. set (x := d * Rabs y / 2). assert (Hx : 0 <= x).
{ unfold x. assert (A := Rabs_pos y). assert (0 <= d * Rabs y) by (apply Rmult_le_pos; lra). lra. }
assert (E : exp (d * Rabs y) = exp x * exp x) by (rewrite <- exp_plus; f_equal; unfold x; field).
assert (H := exp_ineq1_le x). assert (H2 : x * x <= exp x * exp x) by (apply Rmult_le_compat; lra).
rewrite E. replace (y ^ 2) with (4 / d ^ 2 * (x * x)).
- apply Rmult_le_compat_l; auto. apply Rlt_le, Rdiv_lt_0_compat. lra. apply pow_lt, Hd.
- unfold x. replace (4 / d ^ 2 * (d * Rabs y / 2 * (d * Rabs y / 2))) with (Rabs y ^ 2) by (field; lra).
  rewrite <- (pow2_abs y). reflexivity.
Qed.

Lemma exp_minus_1 x : Rabs (exp x - 1) <= Rabs x * exp (Rabs x).
Proof.
assert (H1 := exp_ineq1_le x). assert (H2 := exp_ineq1_le (- x)). assert (P := exp_pos x).
assert (E : exp x * exp (- x) = 1) by (rewrite <- exp_plus; replace (x + - x) with 0 by ring; apply exp_0).
destruct (Rle_lt_dec 0 x) as [H|H].
- rewrite (Rabs_pos_eq x) by auto. rewrite Rabs_pos_eq by lra.
  assert (exp x * (1 + - x) <= exp x * exp (- x)) by (apply Rmult_le_compat_l; lra). lra.
- rewrite (Rabs_left x) by auto. assert (exp x < 1) by (rewrite <- exp_0; apply exp_increasing, H).
  rewrite Rabs_left by lra.
  assert (- x * 1 <= - x * exp (- x)) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(** ** Partial integrals of a nonnegative function *)
Lemma improper_partial (f : R -> R) l a d : (forall r, 0 < r -> 0 <= f r) -> (forall r, 0 < r -> continuous f r) ->
  is_RInt_gen f (at_right 0) (Rbar_locally p_infty) l -> 0 < a -> a <= d -> RInt f a d <= l.
Proof.
intros Hf Hc Hl Ha Had. apply Rnot_lt_le. intros Hlt.
assert (Hd : 0 < RInt f a d - l) by lra.
assert (Ex : forall u v, 0 < u -> u <= v -> ex_RInt f u v).
{ intros u v Hu Hv. apply (ex_RInt_continuous f). intros z Hz; rewrite Rmin_left in Hz by lra. apply Hc; lra. }
unfold is_RInt_gen in Hl.
rewrite (filterlimi_locally (F := filter_prod (at_right 0) (Rbar_locally p_infty))) in Hl.
destruct (filter_ex (F := trunc) _ (trunc_and _ _ (trunc_smaller a d Ha) (Hl (mkposreal _ Hd))))
  as [[u v] [[Hu Hv] [z [Hz1 Hz2]]]]; simpl in *.
apply (is_RInt_unique (V := R_CompleteNormedModule)) in Hz1.
assert (N : forall u v, 0 < u -> u <= v -> 0 <= RInt f u v).
{ intros x y Hx Hy. apply RInt_ge_0; auto. intros. apply Hf. lra. }
assert (E1 : RInt f u v = RInt f u a + (RInt f a d + RInt f d v)).
{ rewrite <- (RInt_Chasles f u a v) by (apply Ex; lra). rewrite <- (RInt_Chasles f a d v) by (apply Ex; lra). reflexivity. }
assert (N1 := N u a ltac:(lra) ltac:(lra)). assert (N2 := N d v ltac:(lra) ltac:(lra)).
assert (Hz : RInt f u v - l < RInt f a d - l).
{ rewrite Hz1. apply Rabs_def2 in Hz2; unfold minus, plus, opp in Hz2; simpl in Hz2. lra. }
lra.
Qed.

Lemma improper_abs (f g : R -> R) lf lg : (forall r, 0 < r -> Rabs (f r) <= g r) ->
  is_RInt_gen f (at_right 0) (Rbar_locally p_infty) lf -> is_RInt_gen g (at_right 0) (Rbar_locally p_infty) lg -> Rabs lf <= lg.
Proof.
intros H Hf Hg. apply Rabs_le. split.
- assert (P := is_RInt_gen_scal _ (-1) _ Hg).
  assert (K : forall r, 0 < r -> scal (-1) (g r) <= f r).
  { intros r Hr. unfold scal; simpl; unfold mult; simpl. assert (A := H r Hr). apply Rabs_le_between in A. lra. }
  assert (L := improper_le _ _ _ _ K P Hf). unfold scal in L; simpl in L; unfold mult in L; simpl in L. lra.
- apply (improper_le f g); auto. intros r Hr. eapply Rle_trans; [apply Rle_abs|auto].
Qed.

Section Exponent.
Variables (w G : R -> R).
Hypothesis Hw : forall r, 0 < r -> 0 <= w r.
Hypothesis Cw : forall r, 0 < r -> continuous w r.
Hypothesis HG : forall c, -1 < c -> is_RInt_gen (fun r => Rpower r c * w r) (at_right 0) (Rbar_locally p_infty) (G c).

Definition log_integral (c : R) : R := RInt_gen (fun r => Rpower r c * ln r * w r) (at_right 0) (Rbar_locally p_infty).

Lemma continuous_power c r : 0 < r -> continuous (fun r => Rpower r c * w r) r.
Proof.
intros Hr. apply (continuous_mult (fun r => Rpower r c) w); auto.
apply (ex_derive_continuous (fun r => Rpower r c)). unfold Rpower. auto_derive; auto.
Qed.

Lemma power_nonneg c r : 0 < r -> 0 <= Rpower r c * w r.
Proof. intros Hr. apply Rmult_le_pos; auto. apply Rlt_le, exp_pos. Qed.

(** A positive part of ln r: ln r + r^-d/d. *)
Lemma ex_log_integral c : -1 < c -> is_RInt_gen (fun r => Rpower r c * ln r * w r) (at_right 0) (Rbar_locally p_infty) (log_integral c).
Proof.
intros Hc. set (d := (c + 1) / 2). assert (Hd : 0 < d) by (unfold d; lra). assert (Hcd : -1 < c - d) by (unfold d; lra).
set (f := fun r => Rpower r c * (ln r + Rpower r (- d) / d) * w r).
assert (Hlog : forall r, 0 < r -> 0 <= ln r + Rpower r (- d) / d).
{ intros r Hr. unfold Rpower. assert (H := exp_ineq1_le (- d * ln r)).
  apply Rmult_le_reg_l with d; auto. replace (d * (ln r + exp (- d * ln r) / d)) with (d * ln r + exp (- d * ln r)) by (field; lra). lra. }
assert (Ef : forall r, 0 < r -> f r = Rpower r c * ln r * w r + / d * (Rpower r (c - d) * w r)).
{ intros r Hr. unfold f. unfold Rminus. rewrite Rpower_plus. field. lra. }
assert (Cf : forall r, 0 < r -> continuous f r).
{ intros r Hr. apply (continuous_mult (fun r => Rpower r c * (ln r + Rpower r (- d) / d)) w); auto.
  apply (ex_derive_continuous (fun r => Rpower r c * (ln r + Rpower r (- d) / d))). unfold Rpower. auto_derive. auto. }
assert (Nf : forall r, 0 < r -> 0 <= f r).
{ intros r Hr. unfold f. apply Rmult_le_pos; auto. apply Rmult_le_pos; auto. apply Rlt_le, exp_pos. }
destruct (ex_RInt_gen_bounded f (G (c + 1) + / d * G (c - d)) Nf Cf) as [l [Hl _]].
{ intros a e Ha Hae.
  assert (X1 : ex_RInt (fun r => Rpower r (c + 1) * w r) a e).
  { apply (ex_RInt_continuous (fun r => Rpower r (c + 1) * w r)). intros z Hz; rewrite Rmin_left in Hz by lra. apply continuous_power; lra. }
  assert (X2 : ex_RInt (fun r => Rpower r (c - d) * w r) a e).
  { apply (ex_RInt_continuous (fun r => Rpower r (c - d) * w r)). intros z Hz; rewrite Rmin_left in Hz by lra. apply continuous_power; lra. }
  assert (X3 : ex_RInt (fun r => / d * (Rpower r (c - d) * w r)) a e) by (apply (ex_RInt_scal (fun r => Rpower r (c - d) * w r)); exact X2).
  apply Rle_trans with (RInt (fun r => Rpower r (c + 1) * w r + / d * (Rpower r (c - d) * w r)) a e).
  - apply RInt_le; auto.
    + apply (ex_RInt_continuous f). intros z Hz; rewrite Rmin_left in Hz by lra. apply Cf; lra.
    + apply (ex_RInt_plus (fun r => Rpower r (c + 1) * w r) (fun r => / d * (Rpower r (c - d) * w r))); auto.
    + intros r Hr. rewrite Ef by lra. apply Rplus_le_compat_r. apply Rmult_le_compat_r; [apply Hw; lra|].
      rewrite Rpower_plus, Rpower_1 by lra. apply Rmult_le_compat_l. apply Rlt_le, exp_pos.
      assert (H := ln_le_sub1 r ltac:(lra)). lra.
  - rewrite (RInt_plus (fun r => Rpower r (c + 1) * w r) (fun r => / d * (Rpower r (c - d) * w r))) by auto.
    rewrite (RInt_scal (fun r => Rpower r (c - d) * w r)) by auto.
    apply Rplus_le_compat.
    + apply (improper_partial (fun r => Rpower r (c + 1) * w r)); auto; try lra.
      intros; apply power_nonneg; auto. intros; apply continuous_power; auto. apply HG; lra.
    + apply Rmult_le_compat_l. apply Rlt_le, Rinv_0_lt_compat, Hd.
      apply (improper_partial (fun r => Rpower r (c - d) * w r)); auto; try lra.
      intros; apply power_nonneg; auto. intros; apply continuous_power; auto. }
assert (H := is_RInt_gen_minus _ _ _ _ Hl (is_RInt_gen_scal _ (/ d) _ (HG (c - d) Hcd))).
assert (H' : is_RInt_gen (fun r => Rpower r c * ln r * w r) (at_right 0) (Rbar_locally p_infty) (minus l (scal (/ d) (G (c - d))))).
{ eapply improper_ext; [|exact H]. intros r Hr. unfold minus, plus, opp, scal; simpl; unfold mult; simpl. rewrite Ef by auto. ring. }
unfold log_integral. rewrite (is_RInt_gen_unique (V := R_CompleteNormedModule) _ _ H'). exact H'.
Qed.

Lemma log_bound_pointwise c d r : 0 < d -> 0 < r -> Rabs (Rpower r c * ln r * w r) <= / d * (Rpower r (c + d) * w r + Rpower r (c - d) * w r).
Proof.
intros Hd Hr. assert (W := Hw r Hr).
rewrite !Rabs_mult, (Rabs_pos_eq (w r)), (Rabs_pos_eq (Rpower r c)) by (auto; apply Rlt_le, exp_pos).
unfold Rminus. rewrite !Rpower_plus.
assert (H1 := abs_le_exp d (ln r) Hd). assert (H2 := exp_abs d (ln r) ltac:(lra)).
set (P := Rpower r c). assert (HP : 0 < P) by apply exp_pos. fold (Rpower r d) (Rpower r (- d)) in H2.
replace (/ d * (P * Rpower r d * w r + P * Rpower r (- d) * w r)) with (P * ((Rpower r d + Rpower r (- d)) / d) * w r) by (field; lra).
apply Rmult_le_compat_r; auto. apply Rmult_le_compat_l; [lra|].
eapply Rle_trans; [exact H1|]. apply Rmult_le_compat_r; auto. apply Rlt_le, Rinv_0_lt_compat, Hd.
Qed.

Lemma log_integral_bound c d : 0 < d -> -1 < c - d -> Rabs (log_integral c) <= / d * (G (c + d) + G (c - d)).
Proof.
intros Hd Hc.
assert (P1 := HG (c + d) ltac:(lra)). assert (P2 := HG (c - d) Hc). assert (P := is_RInt_gen_plus _ _ _ _ P1 P2). apply (is_RInt_gen_scal _ (/ d)) in P.
apply (improper_abs _ _ _ _ (fun r Hr => log_bound_pointwise c d r Hd Hr) (ex_log_integral c ltac:(lra)) P).
Qed.

(** The two bounds for a change of the exponent. *)
Lemma second_order_pointwise c d h r : 0 < d -> Rabs h <= d -> 0 < r ->
  Rabs (Rpower r (c + h) * w r - Rpower r c * w r - h * (Rpower r c * ln r * w r))
    <= h ^ 2 * (4 / d ^ 2 * (Rpower r (c + 2 * d) * w r + Rpower r (c - 2 * d) * w r)) /\
  Rabs (Rpower r (c + h) * ln r * w r - Rpower r c * ln r * w r)
    <= Rabs h * (4 / d ^ 2 * (Rpower r (c + 2 * d) * w r + Rpower r (c - 2 * d) * w r)).
Proof.
intros Hd Hh Hr. assert (W := Hw r Hr).
replace (c - 2 * d) with (c + - (2 * d)) by ring. rewrite !Rpower_plus.
set (P := Rpower r c). assert (HP : 0 < P) by apply exp_pos. set (y := ln r).
assert (EH : Rpower r h = exp (h * y)) by reflexivity. rewrite EH.
assert (S : y ^ 2 * exp (Rabs (h * y)) <= 4 / d ^ 2 * (Rpower r (2 * d) + Rpower r (- (2 * d)))).
{ apply Rle_trans with (4 / d ^ 2 * exp (d * Rabs y) * exp (d * Rabs y)).
  - apply Rmult_le_compat. apply pow2_ge_0. apply Rlt_le, exp_pos. apply square_le_exp, Hd.
    apply exp_le. rewrite Rabs_mult. apply Rmult_le_compat_r; auto. apply Rabs_pos.
  - rewrite Rmult_assoc, <- exp_plus. apply Rmult_le_compat_l. apply Rlt_le, Rdiv_lt_0_compat; [lra|apply pow_lt, Hd].
    replace (d * Rabs y + d * Rabs y) with (2 * d * Rabs y) by ring.
    assert (E := exp_abs (2 * d) y ltac:(lra)). unfold Rpower. fold y. replace (- (2 * d) * y) with (- (2 * d) * y) by ring. exact E. }
set (B := 4 / d ^ 2 * (Rpower r (2 * d) + Rpower r (- (2 * d)))) in *.
replace (4 / d ^ 2 * (P * Rpower r (2 * d) * w r + P * Rpower r (- (2 * d)) * w r)) with (P * w r * B) by (unfold B; ring).
assert (PW : 0 <= P * w r) by (apply Rmult_le_pos; lra).
assert (E := exp_2nd (h * y)). assert (F := exp_minus_1 (h * y)).
split.
- replace (P * exp (h * y) * w r - P * w r - h * (P * y * w r)) with (P * w r * (exp (h * y) - 1 - h * y)) by ring.
  replace (h ^ 2 * (P * w r * B)) with (P * w r * (h ^ 2 * B)) by ring.
  rewrite Rabs_mult, (Rabs_pos_eq (P * w r)), (Rabs_pos_eq (exp (h * y) - 1 - h * y)) by lra.
  apply Rmult_le_compat_l; [exact PW|].
  eapply Rle_trans; [apply E|]. replace ((h * y) ^ 2 * exp (Rabs (h * y))) with (h ^ 2 * (y ^ 2 * exp (Rabs (h * y)))) by ring.
  apply Rmult_le_compat_l; auto. apply pow2_ge_0.
- replace (P * exp (h * y) * y * w r - P * y * w r) with (P * w r * (y * (exp (h * y) - 1))) by ring.
  replace (Rabs h * (P * w r * B)) with (P * w r * (Rabs h * B)) by ring.
  rewrite Rabs_mult, (Rabs_pos_eq (P * w r)), Rabs_mult by lra.
  apply Rmult_le_compat_l; [exact PW|].
  apply Rle_trans with (Rabs y * (Rabs (h * y) * exp (Rabs (h * y)))).
  + apply Rmult_le_compat_l; auto. apply Rabs_pos.
  + replace (Rabs y * (Rabs (h * y) * exp (Rabs (h * y)))) with (Rabs h * (y ^ 2 * exp (Rabs (h * y)))).
    * apply Rmult_le_compat_l; auto. apply Rabs_pos.
    * rewrite (Rabs_mult h y) at 2. rewrite <- (pow2_abs y). ring.
Qed.

Lemma exponent_change c d h : 0 < d -> -1 < c - 2 * d -> Rabs h <= d ->
  Rabs (G (c + h) - G c - h * log_integral c) <= h ^ 2 * (4 / d ^ 2 * (G (c + 2 * d) + G (c - 2 * d))) /\
  Rabs (log_integral (c + h) - log_integral c) <= Rabs h * (4 / d ^ 2 * (G (c + 2 * d) + G (c - 2 * d))).
Proof.
intros Hd Hc Hh.
assert (Hh' : - d <= h <= d) by (apply Rabs_le_between; auto).
assert (P1 := HG (c + 2 * d) ltac:(lra)). assert (P2 := HG (c - 2 * d) Hc). assert (B := is_RInt_gen_plus _ _ _ _ P1 P2). apply (is_RInt_gen_scal _ (4 / d ^ 2)) in B.
assert (L0 := ex_log_integral c ltac:(lra)). assert (L1 := ex_log_integral (c + h) ltac:(lra)).
assert (G0 := HG c ltac:(lra)). assert (G1 := HG (c + h) ltac:(lra)). assert (L2 := L0). apply (is_RInt_gen_scal _ h) in L2.
assert (D := is_RInt_gen_minus _ _ _ _ (is_RInt_gen_minus _ _ _ _ G1 G0) L2).
assert (D' := is_RInt_gen_minus _ _ _ _ L1 L0).
assert (B2 := B). apply (is_RInt_gen_scal _ (h ^ 2)) in B2. assert (B1 := B). apply (is_RInt_gen_scal _ (Rabs h)) in B1.
split.
- exact (improper_abs _ _ _ _ (fun r Hr => proj1 (second_order_pointwise c d h r Hd Hh Hr)) D B2).
- exact (improper_abs _ _ _ _ (fun r Hr => proj2 (second_order_pointwise c d h r Hd Hh Hr)) D' B1).
Qed.

Theorem exponent_derive c : -1 < c -> is_derive G c (log_integral c).
Proof.
intros Hc. set (d := (c + 1) / 4). assert (Hd : 0 < d) by (unfold d; lra).
set (K := 4 / d ^ 2 * (G (c + 2 * d) + G (c - 2 * d))).
assert (H : forall h, Rabs h <= d -> Rabs (G (c + h) - G c - h * log_integral c) <= h ^ 2 * K).
{ intros h Hh. apply (exponent_change c d h Hd ltac:(unfold d; lra) Hh). }
assert (HK : 0 <= K).
{ specialize (H d ltac:(rewrite Rabs_pos_eq; lra)). assert (A := Rabs_pos (G (c + d) - G c - d * log_integral c)).
  assert (0 < d ^ 2) by (apply pow_lt, Hd). apply Rnot_lt_le. intros HK.
  assert (d ^ 2 * K < 0) by (rewrite <- (Rmult_0_r (d ^ 2)); apply Rmult_lt_compat_l; auto). lra. }
apply is_derive_Reals. intros eps Heps.
assert (Hm : 0 < Rmin d (eps / (K + 1))) by (apply Rmin_pos; auto; apply Rdiv_lt_0_compat; lra).
exists (mkposreal _ Hm). intros h Hh Hhd. simpl in Hhd.
assert (H1 : Rabs h < d) by (eapply Rlt_le_trans; [exact Hhd|apply Rmin_l]).
assert (H2 : Rabs h < eps / (K + 1)) by (eapply Rlt_le_trans; [exact Hhd|apply Rmin_r]).
specialize (H h ltac:(lra)).
replace ((G (c + h) - G c) / h - log_integral c) with ((G (c + h) - G c - h * log_integral c) * / h) by (field; auto).
rewrite Rabs_mult, Rabs_inv. assert (Hp : 0 < Rabs h) by (apply Rabs_pos_lt; auto).
apply Rmult_lt_reg_r with (Rabs h); auto. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
rewrite <- (pow2_abs h) in H. eapply Rle_lt_trans; [exact H|].
assert (A : Rabs h * (K + 1) < eps).
{ replace eps with (eps / (K + 1) * (K + 1)) by (field; lra). apply Rmult_lt_compat_r; lra. }
replace (Rabs h ^ 2 * K) with (Rabs h * (Rabs h * K)) by ring. rewrite (Rmult_comm eps). apply Rmult_lt_compat_l; auto. lra.
Qed.

Theorem log_integral_continuous c : -1 < c -> continuous log_integral c.
Proof.
intros Hc. set (d := (c + 1) / 4). assert (Hd : 0 < d) by (unfold d; lra).
set (K := 4 / d ^ 2 * (G (c + 2 * d) + G (c - 2 * d))).
assert (H : forall h, Rabs h <= d -> Rabs (log_integral (c + h) - log_integral c) <= Rabs h * K).
{ intros h Hh. apply (exponent_change c d h Hd ltac:(unfold d; lra) Hh). }
apply filterlim_locally. intros eps. assert (He := cond_pos eps).
assert (HK := Rabs_pos K).
assert (Hm : 0 < Rmin d (eps / (Rabs K + 1))) by (apply Rmin_pos; auto; apply Rdiv_lt_0_compat; lra).
exists (mkposreal _ Hm).
enough (Main : forall x : R, Rabs (x - c) < Rmin d (eps / (Rabs K + 1)) -> Rabs (log_integral x - log_integral c) < eps) by exact Main.
intros x Hx.
assert (H1 : Rabs (x - c) < d) by (eapply Rlt_le_trans; [exact Hx|apply Rmin_l]).
assert (H2 : Rabs (x - c) < eps / (Rabs K + 1)) by (eapply Rlt_le_trans; [exact Hx|apply Rmin_r]).
specialize (H (x - c) ltac:(lra)). replace (c + (x - c)) with x in H by ring.
eapply Rle_lt_trans; [exact H|].
apply Rle_lt_trans with (Rabs (x - c) * (Rabs K + 1)).
- apply Rmult_le_compat_l. apply Rabs_pos. assert (A := Rle_abs K). lra.
- replace (pos eps) with (eps / (Rabs K + 1) * (Rabs K + 1)) by (field; lra). apply Rmult_lt_compat_r; lra.
Qed.

End Exponent.
