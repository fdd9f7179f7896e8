(** * Theta is an entire function of t and b

    The initial values of the entire form are entire in b ([recip_Gamma_entire]). So is every Taylor coefficient c_k in
    t, by its recurrence; and on |b - b0| < r its norm is at most the k-th coefficient of the recurrence for - |b0| - r,
    which is below M/R^k for every R ([entire_family]). Hence a double power series in (t, b) that converges everywhere;
    and t may be replaced by a power series in b ([family_substitute]). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus GammaFunction WellPosed Gronwall SignsAtZero EntireForm PowerSeriesNorm
  NormLimit GammaEntire.
Open Scope R_scope.

(** ** Families of coefficients *)

(** sum c_k(b) t^k, with the norm of c_k at most M/R^k for every R, on every disc of b. *)
Definition entire_family (c : nat -> R -> R) : Prop := forall b r R, 0 < r -> 0 < R ->
  exists M, forall k, norm_at_most r (M / R ^ k) (fun h => c k (b + h)).

Definition family_sum (c : nat -> R -> R) (t b : R) : R := PSeries (fun k => c k b) t.

Lemma family_radius c b : entire_family c -> CV_radius (fun k => c k b) = p_infty.
Proof.
intros H.
assert (B : forall R, 0 < R -> Rbar_le R (CV_radius (fun k => c k b))).
{ intros R HR. destruct (H b 1 R Rlt_0_1 HR) as [M HM].
  apply (proj1 (CV_radius_bounded (fun k => c k b))). exists M. intros k.
  assert (P : 0 < R ^ k) by (apply pow_lt, HR).
  assert (V := norm_value 1 _ _ 0 Rlt_0_1 (HM k) ltac:(rewrite Rabs_R0; lra)). simpl in V. rewrite Rplus_0_r in V.
  rewrite Rabs_mult, (Rabs_pos_eq (R ^ k)) by lra. replace M with (M / R ^ k * R ^ k) by (field; lra).
  apply Rmult_le_compat_r; [lra|exact V]. }
destruct (CV_radius (fun k => c k b)) as [x| |]; auto.
- assert (X := B (Rabs x + 1) ltac:(generalize (Rabs_pos x); lra)). simpl in X. assert (A := Rle_abs x). lra.
- exfalso. apply (B 1 Rlt_0_1).
Qed.

Lemma family_correct c t b : entire_family c -> is_pseries (fun k => c k b) t (family_sum c t b).
Proof. intros H. apply PSeries_correct, CV_radius_inside. rewrite family_radius; auto. exact I. Qed.

Lemma family_substitute c b r X : entire_family c -> 0 < r -> 0 < X -> exists M, forall r' x, 0 < r' <= r ->
  norm_at_most r' X x ->
  norm_at_most r' M (fun h => family_sum c (x h) (b + h)).
Proof.
intros H Hr HX. destruct (H b r (2 * X) Hr ltac:(lra)) as [M HM]. exists (M * 2). intros r' x Hr' Hx.
apply (norm_series r' (fun k h => c k (b + h) * x h ^ k) (fun k => M / (2 * X) ^ k * X ^ k) _ _ ltac:(lra)).
- intros k. apply (norm_mult r' _ _ (fun h => c k (b + h)) (fun h => x h ^ k)); try lra.
  apply (norm_smaller r); auto. apply norm_pow; auto; lra.
- intros N. rewrite (sum_first_ext _ (fun k => M * (1 / 2) ^ k)).
  + rewrite sum_first_scal. apply Rmult_le_compat_l.
    * assert (V := norm_bound_nonneg _ _ _ (HM 0%nat)). simpl in V. lra.
    * assert (G := sum_geometric (1 / 2) N ltac:(lra)). replace (/ (1 - 1 / 2)) with 2 in G by field. exact G.
  + intros k. rewrite Rpow_mult_distr, pow_quotient, pow1. field. split; apply pow_nonzero; lra.
- intros h _. apply is_pseries_sum_first, family_correct, H.
Qed.

Lemma family_norm c t b r : entire_family c -> 0 < r -> exists M, norm_at_most r M (fun h => family_sum c t (b + h)).
Proof.
intros H Hr. assert (A := Rabs_pos t). destruct (family_substitute c b r (Rabs t + 1) H Hr ltac:(lra)) as [M HM].
exists M. apply (HM r (fun _ => t)). lra. apply (norm_weaken r (Rabs t)). lra. apply norm_const.
Qed.

(** The derivative in t. *)
Definition derived (c : nat -> R -> R) (k : nat) (b : R) : R := INR (S k) * c (S k) b.

Lemma family_derive c t b : entire_family c -> is_derive (fun t => family_sum c t b) t (family_sum (derived c) t b).
Proof. intros H. apply (is_derive_PSeries (fun k => c k b)). rewrite family_radius; auto. exact I. Qed.

Lemma power_of_2 n : INR n <= 2 ^ n.
Proof. induction n as [|n IH]. simpl; lra. rewrite S_INR. simpl. assert (1 <= 2 ^ n) by (apply pow_R1_Rle; lra). lra.
Qed.

Lemma derived_entire c : entire_family c -> entire_family (derived c).
Proof.
intros H b r R Hr HR. destruct (H b r (2 * R) Hr ltac:(lra)) as [M HM]. exists (M / R). intros k.
assert (M0 : 0 <= M). { assert (V := norm_bound_nonneg _ _ _ (HM 0%nat)). simpl in V. lra. }
apply (norm_weaken r (Rabs (INR (S k)) * (M / (2 * R) ^ S k))).
- rewrite Rabs_pos_eq by apply pos_INR.
  assert (P2 : 0 < 2 ^ S k) by (apply pow_lt; lra). assert (PR : 0 < R ^ k) by (apply pow_lt, HR).
  rewrite Rpow_mult_distr. change (R ^ S k) with (R * R ^ k).
  replace (INR (S k) * (M / (2 ^ S k * (R * R ^ k)))) with (INR (S k) * / 2 ^ S k * (M / R / R ^ k)) by (field; lra).
  assert (Q : INR (S k) * / 2 ^ S k <= 1).
  { apply Rmult_le_reg_r with (2 ^ S k); auto. rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_1_l by lra.
    apply power_of_2. }
  rewrite <- (Rmult_1_l (M / R / R ^ k)) at 2. apply Rmult_le_compat_r; auto.
  unfold Rdiv. apply Rmult_le_pos; [apply Rmult_le_pos; auto|]; apply Rlt_le, Rinv_0_lt_compat; auto.
- apply (norm_scal r _ (INR (S k)) (fun h => c (S k) (b + h))), HM.
Qed.

(** ** Theta *)

Lemma entire_shifted_power c x : entire (fun b => c * Rpower 3 (2 * b / 3 - 1 / 2 + x)).
Proof.
apply (entire_ext (fun b => c * Rpower 3 (- 1 / 2 + x) * exp (2 / 3 * ln 3 * b))).
- intros b. unfold Rpower. rewrite Rmult_assoc, <- exp_plus. do 2 f_equal. field.
- apply (entire_mult (fun _ => c * Rpower 3 (- 1 / 2 + x))). apply entire_const. apply entire_exp.
Qed.

Lemma entire_recip_thirds p : entire (fun b => recip_Gamma ((p - b) / 3)).
Proof.
apply (entire_ext (fun b => recip_Gamma (p / 3 + -1 / 3 * b))).
- intros b. f_equal. field.
- apply entire_affine. rewrite Rabs_left; lra. exact recip_Gamma_entire.
Qed.

Lemma initial_entire : entire E0 /\ entire E1 /\ entire E2.
Proof.
assert (R0 : entire (fun b => recip_Gamma (- b / 3))).
{ apply (entire_ext (fun b => recip_Gamma ((0 - b) / 3))). intros b. f_equal. field. apply entire_recip_thirds. }
assert (R1 := entire_recip_thirds 1). assert (R2 := entire_recip_thirds 2).
repeat split.
- apply (entire_ext (fun b => 2 * PI * Rpower 3 (2 * b / 3 - 1 / 2 + 0) * recip_Gamma ((1 - b) / 3) * recip_Gamma
    ((2 - b) / 3))).
  + intros b. unfold E0. rewrite Rplus_0_r. reflexivity.
  + apply (entire_mult (fun b => 2 * PI * Rpower 3 (2 * b / 3 - 1 / 2 + 0) * recip_Gamma ((1 - b) / 3))); auto.
    apply (entire_mult (fun b => 2 * PI * Rpower 3 (2 * b / 3 - 1 / 2 + 0))); auto. apply entire_shifted_power.
- apply (entire_mult (fun b => 2 * PI * Rpower 3 (2 * b / 3 - 1 / 2 + 1 / 3) * recip_Gamma (- b / 3))); auto.
  apply (entire_mult (fun b => 2 * PI * Rpower 3 (2 * b / 3 - 1 / 2 + 1 / 3))); auto. apply entire_shifted_power.
- apply (entire_mult (fun b => 2 * PI * Rpower 3 (2 * b / 3 - 1 / 2 + 2 / 3) * recip_Gamma (- b / 3))); auto.
  apply (entire_mult (fun b => 2 * PI * Rpower 3 (2 * b / 3 - 1 / 2 + 2 / 3))); auto. apply entire_shifted_power.
Qed.

Definition theta_coefficient (k : nat) (b : R) : R := coef b (E0 b) (E1 b) (E2 b) k.

Lemma coefficient_norm b r m0 m1 m2 : 0 < r -> norm_at_most r m0 (fun h => E0 (b + h)) ->
  norm_at_most r m1 (fun h => E1 (b + h)) ->
  norm_at_most r m2 (fun h => E2 (b + h)) -> forall k, norm_at_most r (coef (- (Rabs b + r)) m0 m1 m2 k) (fun h =>
    theta_coefficient k (b + h)).
Proof.
intros Hr H0 H1 H2. induction k as [| | |k IH] using nat_ind3; try assumption.
- apply (norm_ext r _ (fun h => / 2 * E2 (b + h))). { intros h _. unfold theta_coefficient. simpl. field. }
  simpl. apply (norm_weaken r (Rabs (/ 2) * m2)). rewrite Rabs_pos_eq by lra. lra. apply norm_scal, H2.
- assert (Hk := pos_INR k). rewrite coef_rec.
  set (D := (INR k + 1) * (INR k + 2) * (INR k + 3)).
  assert (HD : 0 < D) by (unfold D; repeat apply Rmult_lt_0_compat; lra).
  apply (norm_ext r _ (fun h => / D * (((INR k - b) + -1 * h) * theta_coefficient k (b + h)))).
  { intros h _. unfold theta_coefficient. rewrite coef_rec. fold D. field. lra. }
  apply (norm_weaken r (Rabs (/ D) * ((Rabs (INR k - b) + Rabs (-1) * r) * coef (- (Rabs b + r)) m0 m1 m2 k))).
  + replace (Rabs (-1)) with 1 by (rewrite Rabs_left; lra).
    rewrite (Rabs_pos_eq (/ D)) by (apply Rlt_le, Rinv_0_lt_compat, HD).
    replace ((INR k - - (Rabs b + r)) / D * coef (- (Rabs b + r)) m0 m1 m2 k)
      with (/ D * ((INR k + Rabs b + r) * coef (- (Rabs b + r)) m0 m1 m2 k)) by (field; lra).
    apply Rmult_le_compat_l. apply Rlt_le, Rinv_0_lt_compat, HD.
    apply Rmult_le_compat_r. exact (norm_bound_nonneg _ _ _ IH).
    assert (T := Rabs_triang (INR k) (- b)). rewrite Rabs_Ropp, (Rabs_pos_eq (INR k)) in T by lra. unfold Rminus. lra.
  + apply norm_scal. apply (norm_mult r _ _ (fun h => INR k - b + -1 * h)); auto. apply norm_affine, Hr.
Qed.

Lemma theta_family_entire : entire_family theta_coefficient.
Proof.
intros b r R Hr HR. destruct initial_entire as (I0 & I1 & I2).
destruct (I0 b r Hr) as [m0 H0]. destruct (I1 b r Hr) as [m1 H1]. destruct (I2 b r Hr) as [m2 H2].
destruct (coef_bounded (- (Rabs b + r)) m0 m1 m2 R) as [B HB]. exists B. intros k.
apply (norm_weaken r (coef (- (Rabs b + r)) m0 m1 m2 k)); [|apply coefficient_norm; auto].
assert (P : 0 < R ^ k) by (apply pow_lt, HR). apply Rmult_le_reg_r with (R ^ k); auto.
replace (B / R ^ k * R ^ k) with B by (field; lra). eapply Rle_trans; [apply Rle_abs|apply HB].
Qed.

Lemma entire_series b theta : is_Theta_entire b theta -> forall t, theta t = family_sum theta_coefficient t b.
Proof.
intros H t. destruct (entire_chain b theta H) as (D0 & D1 & D2 & J0 & J1 & J2).
set (c := coef b (E0 b) (E1 b) (E2 b)).
destruct (s_init b (E0 b) (E1 b) (E2 b)) as (S0 & S1 & S2).
assert (G := gronwall_u0 (fun t => theta t - PSeries c t) (fun t => Derive theta t - PSeries (PS_derive c) t)
  (fun t => Derive_n theta 2 t - PSeries (PS_derive (PS_derive c)) t) (fun _ => 0) (- b) (Rabs t) 0 (Rabs_pos t)).
assert (H' : (theta t - PSeries c t) ^ 2 <= 0).
{ eapply Rle_trans. apply G.
  - intros s. apply (is_derive_minus theta (PSeries c)); auto. apply s_derive0.
  - intros s. apply (is_derive_minus (Derive theta) (PSeries (PS_derive c))); auto. apply s_derive1.
  - intros s. replace (s * (Derive theta s - PSeries (PS_derive c) s) + - b * (theta s - PSeries c s) + 0)
      with ((s * Derive theta s - b * theta s) - (s * PSeries (PS_derive c) s - b * PSeries c s)) by ring.
    apply (is_derive_minus (Derive_n theta 2) (PSeries (PS_derive (PS_derive c)))); auto. apply s_derive2.
  - intros; rewrite Rabs_R0; apply Rle_refl.
  - apply Rle_refl.
  - fold c in S0, S1, S2. rewrite S0, S1, S2, J0, J1, J2. right. unfold Rminus. rewrite !Rplus_opp_r. ring. }
assert (A := pow2_ge_0 (theta t - PSeries c t)). change (theta t = PSeries c t). nra.
Qed.

Lemma Derive_family b theta : is_Theta_entire b theta -> forall t,
  Derive theta t = family_sum (derived theta_coefficient) t b.
Proof.
intros H t. rewrite (Derive_ext theta (fun t => family_sum theta_coefficient t b)) by (apply entire_series, H).
apply is_derive_unique, family_derive, theta_family_entire.
Qed.

Lemma Derive2_family b theta : is_Theta_entire b theta -> forall t, Derive_n theta 2 t = family_sum
  (derived (derived theta_coefficient)) t b.
Proof.
intros H t. simpl.
rewrite (Derive_ext _ (fun t => family_sum (derived theta_coefficient) t b)) by (apply Derive_family, H).
apply is_derive_unique, family_derive, derived_entire, theta_family_entire.
Qed.

Theorem entire_in_both : exists a : nat -> nat -> R,
  (forall r, exists M, forall j k, Rabs (a j k) * r ^ (j + k) <= M) /\
  forall b theta t, is_Theta_entire b theta -> is_pseries (fun j => PSeries (a j) b) t (theta t).
Proof.
exists (fun j => taylor (theta_coefficient j)).
assert (T : forall r, 0 < r -> exists M, forall j, norm_at_most r (M / r ^ j) (theta_coefficient j)).
{ intros r Hr. destruct (theta_family_entire 0 r r Hr Hr) as [M HM]. exists M. intros j.
  apply (norm_ext r _ (fun h => theta_coefficient j (0 + h))); auto. intros h _. f_equal. ring. }
split.
- intros r. set (s := Rabs r + 1). assert (Hs : 0 < s) by (unfold s; generalize (Rabs_pos r); lra).
  destruct (T s Hs) as [M HM]. exists M. intros j k. assert (P : 0 < s ^ j) by (apply pow_lt, Hs).
  destruct (taylor_coefficients s _ _ Hs (HM j)) as [HB _]. assert (B := term_bound _ s _ Hs HB k).
  apply Rle_trans with (Rabs (taylor (theta_coefficient j) k) * s ^ (j + k)).
  + apply Rmult_le_compat_l. apply Rabs_pos. eapply Rle_trans; [apply Rle_abs|]. rewrite <- RPow_abs. apply pow_incr.
    unfold s. generalize (Rabs_pos r). lra.
  + rewrite pow_add. replace (Rabs (taylor (theta_coefficient j) k) * (s ^ j * s ^ k))
      with (Rabs (taylor (theta_coefficient j) k) * s ^ k * s ^ j) by ring.
    replace M with (M / s ^ j * s ^ j) by (field; lra). apply Rmult_le_compat_r; [lra|exact B].
- intros b theta t H. rewrite (entire_series b theta H t).
  apply (is_pseries_ext (fun j => theta_coefficient j b)); [|apply family_correct, theta_family_entire].
  intros j. assert (Hb : 0 < Rabs b + 1) by (generalize (Rabs_pos b); lra). destruct (T _ Hb) as [M HM].
  destruct (taylor_coefficients _ _ _ Hb (HM j)) as [_ HS]. symmetry. apply is_pseries_unique, HS. lra.
Qed.

Lemma sum_in_beta_entire t : entire (family_sum theta_coefficient t).
Proof. intros b r Hr. apply family_norm; auto. exact theta_family_entire. Qed.

Theorem entire_in_beta t : exists a : nat -> R, forall b theta, is_Theta_entire b theta -> is_pseries a b (theta t).
Proof.
destruct (entire_series_at_0 _ (sum_in_beta_entire t)) as [a Ha]. exists a. intros b theta H.
rewrite (entire_series b theta H t). apply Ha.
Qed.

(** The entire form has a solution for every b. *)
Lemma entire_exists b : exists theta, is_Theta_entire b theta.
Proof.
destruct (Classical_Prop.classic (not_nat b)) as [H|H].
- destruct (Theta_exists b) as [theta Ht]. exists theta. apply entire_initial_values; auto.
- apply Classical_Pred_Type.not_all_ex_not in H. destruct H as [n H]. apply Classical_Prop.NNPP in H.
  exists (Poly n). apply (proj2 (entire_initial_values b (Poly n)) n H). reflexivity.
Qed.
