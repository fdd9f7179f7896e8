(** * The compliant model: eps -> 0

    -(rho eta)^3 2/3 <= psi(rho eta) <= -(rho eta)^3/3 and psi(r) + 2 r^3/3 <= r^4/4 give the distance of the slow
    solution from Theta with an explicit error of known sign. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncatedIntegral TruncationLimit GammaFunction LaplaceIntegral
  ImproperIntegral Family CompliantKernel CompliantIntegral CompliantSlow.
Open Scope R_scope.

(** two-sided bounds on psi with the cubic term *)
Lemma psi_upper r : 0 <= r -> psi r <= - (r ^ 3 / 3).
Proof.
intros Hr.
assert (D : forall x, 0 <= x -> is_derive psi x (- x ^ 2 * (x + 2) / (1 + x))).
{ intros x Hx. unfold psi. auto_derive. lra. field; lra. }
assert (H : psi r + r ^ 3 / 3 <= psi 0 + 0 ^ 3 / 3).
{ apply (decr_of_derive (fun x => psi x + x ^ 3 / 3) (fun x => - x ^ 2 * (x + 2) / (1 + x) + x ^ 2) 0 r Hr).
  - intros x Hx. apply (is_derive_plus psi (fun x => x ^ 3 / 3)). apply D; lra. auto_derive; auto; field.
  - intros x Hx. replace (- x ^ 2 * (x + 2) / (1 + x) + x ^ 2) with (- (x ^ 2 / (1 + x))) by (field; lra).
    assert (0 <= x ^ 2 / (1 + x)).
    { apply Rmult_le_pos. apply pow2_ge_0. apply Rlt_le, Rinv_0_lt_compat; lra. }
    lra. }
rewrite psi_0 in H. simpl in *; lra.
Qed.

Lemma psi_quartic r : 0 <= r -> psi r + 2 * r ^ 3 / 3 <= r ^ 4 / 4.
Proof.
intros Hr.
assert (D : forall x, 0 <= x -> is_derive psi x (- x ^ 2 * (x + 2) / (1 + x))).
{ intros x Hx. unfold psi. auto_derive. lra. field; lra. }
assert (H : psi r + 2 * r ^ 3 / 3 - r ^ 4 / 4 <= psi 0 + 2 * 0 ^ 3 / 3 - 0 ^ 4 / 4).
{ apply (decr_of_derive (fun x => psi x + 2 * x ^ 3 / 3 - x ^ 4 / 4)
    (fun x => - x ^ 2 * (x + 2) / (1 + x) + 2 * x ^ 2 - x ^ 3) 0 r Hr).
  - intros x Hx. apply (is_derive_minus (fun x => psi x + 2 * x ^ 3 / 3) (fun x => x ^ 4 / 4)).
    apply (is_derive_plus psi (fun x => 2 * x ^ 3 / 3)). apply D; lra.
    auto_derive; auto; field. auto_derive; auto; field.
  - intros x Hx. replace (- x ^ 2 * (x + 2) / (1 + x) + 2 * x ^ 2 - x ^ 3) with (- (x ^ 4 / (1 + x))) by (field; lra).
    assert (0 <= x ^ 4 / (1 + x)).
    { apply Rmult_le_pos. apply pow_le; lra. apply Rlt_le, Rinv_0_lt_compat; lra. }
    lra. }
rewrite psi_0 in H. simpl in *; lra.
Qed.

(** the weight of the remainder *)
Definition Wk (q t r : R) : R := Rpower r q * exp (r * t - r ^ 3 / 6).

Definition W (q t : R) : R := RInt_gen (Wk q t) (at_right 0) (Rbar_locally p_infty).

Lemma W_correct q t : -1 < q -> is_RInt_gen (Wk q t) (at_right 0) (Rbar_locally p_infty) (W q t).
Proof.
intros Hq.
set (a := Rabs t + 2).
assert (Ha : 2 <= a) by (unfold a; generalize (Rabs_pos t); lra).
assert (Hb : forall r, 0 < r -> Wk q t r <= exp (a ^ 3 / 3) * gamma_integrand (q + 1) r).
{ intros r Hr. unfold Wk, gamma_integrand. replace (q + 1 - 1) with q by ring.
  replace (exp (a ^ 3 / 3) * (Rpower r q * exp (- r))) with (Rpower r q * (exp (a ^ 3 / 3) * exp (- r))) by ring.
  apply Rmult_le_compat_l. apply Rlt_le, exp_pos.
  rewrite <- exp_plus. apply exp_le.
  assert (H1 : 0 <= (r - a) ^ 2 * (r + 2 * a)) by (apply Rmult_le_pos; [apply pow2_ge_0|lra]).
  assert (H2 : t + 1 <= a ^ 2 / 2).
  { assert (Ht := Rle_abs t). assert (Ht2 := Rabs_pos t). unfold a. nra. }
  assert (H3 : r * (t + 1) <= r * (a ^ 2 / 2)) by (apply Rmult_le_compat_l; lra).
  assert (H4 : (r - a) ^ 2 * (r + 2 * a) = r ^ 3 - 3 * (a ^ 2 * r) + 2 * a ^ 3) by ring.
  lra. }
assert (Hcont : forall r, 0 < r -> continuous (Wk q t) r).
{ intros r Hr. apply (ex_derive_continuous (Wk q t) r). unfold Wk, Rpower. auto_derive; auto. }
destruct (ex_RInt_gen_bounded (Wk q t)
  (exp (a ^ 3 / 3) * (exp ((q + 1 + 1) * ln (q + 1 + 1) - (q + 1)) / (q + 1)))) as [l [Hl _]]; auto.
- intros. apply Rlt_le. unfold Wk, Rpower. apply Rmult_lt_0_compat; apply exp_pos.
- intros c d Hc Hd.
  apply Rle_trans with (RInt (fun r => exp (a ^ 3 / 3) * gamma_integrand (q + 1) r) c d).
  + apply RInt_le; auto.
    * apply (ex_RInt_continuous (Wk q t)). intros z Hz; rewrite Rmin_left in Hz by lra. apply Hcont; lra.
    * apply (ex_RInt_scal (gamma_integrand (q + 1))), ex_RInt_gamma_integrand; auto.
    * intros x Hx. apply Hb; lra.
  + rewrite (RInt_scal (gamma_integrand (q + 1))) by (apply ex_RInt_gamma_integrand; auto).
    apply Rmult_le_compat_l. apply Rlt_le, exp_pos.
    apply RInt_gamma_integrand_bound; auto; lra.
- assert (H : W q t = l) by (apply (is_RInt_gen_unique (V := R_CompleteNormedModule) _ l); exact Hl).
  rewrite H. exact Hl.
Qed.

Lemma ke_limit eta s t r : 0 < eta -> 0 < r ->
  0 <= Rpower r s * exp (psi (eta * r) / (2 * eta ^ 3) + r * t) - kernel s t r <= eta / 8 * Wk (s + 4) t r.
Proof.
intros He Hr. unfold kernel, Wk.
replace (s + 4) with (s + 1 + 1 + 1 + 1) by ring. rewrite !Rpower_S by auto.
set (P := Rpower r s). assert (HP : 0 < P) by apply exp_pos.
assert (Hx : 0 < eta * r) by (apply Rmult_lt_0_compat; auto).
assert (He3 : 0 < eta ^ 3) by (apply pow_lt; auto).
set (A := psi (eta * r) / (2 * eta ^ 3)).
assert (B1 : - (r ^ 3 / 3) <= A).
{ apply Rmult_le_reg_r with (2 * eta ^ 3). lra. unfold A.
  replace (psi (eta * r) / (2 * eta ^ 3) * (2 * eta ^ 3)) with (psi (eta * r)) by (field; lra).
  destruct (psi_bounds (eta * r) ltac:(lra)) as [Q _].
  replace (- (r ^ 3 / 3) * (2 * eta ^ 3)) with (- (2 * (eta * r) ^ 3 / 3)) by field. exact Q. }
assert (B2 : A <= - (r ^ 3 / 6)).
{ apply Rmult_le_reg_r with (2 * eta ^ 3). lra. unfold A.
  replace (psi (eta * r) / (2 * eta ^ 3) * (2 * eta ^ 3)) with (psi (eta * r)) by (field; lra).
  replace (- (r ^ 3 / 6) * (2 * eta ^ 3)) with (- ((eta * r) ^ 3 / 3)) by field. apply psi_upper; lra. }
assert (B3 : A + r ^ 3 / 3 <= eta * r ^ 4 / 8).
{ apply Rmult_le_reg_r with (2 * eta ^ 3). lra. unfold A.
  replace ((psi (eta * r) / (2 * eta ^ 3) + r ^ 3 / 3) * (2 * eta ^ 3)) with (psi (eta * r) + 2 * (eta * r) ^ 3 / 3)
    by (field; lra).
  replace (eta * r ^ 4 / 8 * (2 * eta ^ 3)) with ((eta * r) ^ 4 / 4) by field. apply psi_quartic; lra. }
replace (r * t - r ^ 3 / 3) with (- (r ^ 3 / 3) + r * t) by ring.
replace (r * t - r ^ 3 / 6) with (- (r ^ 3 / 6) + r * t) by ring.
rewrite !exp_plus.
set (X := exp (r * t)). assert (HX : 0 < X) by apply exp_pos.
assert (C1 : exp (- (r ^ 3 / 3)) <= exp A) by (apply exp_le; auto).
(* e^A - e^B <= (A - B) e^A <= (A - B) e^(-r^3/6) *)
assert (C2 : exp A - exp (- (r ^ 3 / 3)) <= (A + r ^ 3 / 3) * exp A).
{ assert (H := exp_ineq1_le (- (A + r ^ 3 / 3))).
  assert (E : exp A * exp (- (A + r ^ 3 / 3)) = exp (- (r ^ 3 / 3))) by (rewrite <- exp_plus; f_equal; ring).
  assert (HA := exp_pos A).
  assert (exp A * (1 + - (A + r ^ 3 / 3)) <= exp A * exp (- (A + r ^ 3 / 3))) by (apply Rmult_le_compat_l; lra).
  lra. }
assert (C3 : exp A <= exp (- (r ^ 3 / 6))) by (apply exp_le; auto).
assert (C4 : (A + r ^ 3 / 3) * exp A <= eta * r ^ 4 / 8 * exp (- (r ^ 3 / 6))).
{ apply Rmult_le_compat; try lra. apply Rlt_le, exp_pos. }
assert (HPX : 0 < P * X) by (apply Rmult_lt_0_compat; auto).
replace (P * (exp A * X) - P * (exp (- (r ^ 3 / 3)) * X)) with (P * X * (exp A - exp (- (r ^ 3 / 3)))) by ring.
replace (eta / 8 * (r * (r * (r * (r * P))) * (exp (- (r ^ 3 / 6)) * X)))
  with (P * X * (eta * r ^ 4 / 8 * exp (- (r ^ 3 / 6)))) by field.
split.
- apply Rmult_le_pos; lra.
- apply Rmult_le_compat_l; lra.
Qed.

Theorem Ie_limit (eta s t l : R) : 0 < eta -> -1 < s ->
  is_RInt_gen (kernel s t) (at_right 0) (Rbar_locally p_infty) l ->
  0 <= Rpower eta (- (s + 1)) * Ie (2 * eta ^ 3) s (t / eta) - l <= eta / 8 * W (s + 4) t.
Proof.
intros He Hs Hl.
assert (He2 : 0 < 2 * eta ^ 3) by (generalize (pow_lt eta 3 He); lra).
assert (A := improper_scale _ eta _ He (proj1 (Ie_aux (2 * eta ^ 3) s (t / eta) He2 Hs))).
apply (is_RInt_gen_scal _ (Rpower eta (- (s + 1)))) in A.
assert (A' : is_RInt_gen (fun r => Rpower r s * exp (psi (eta * r) / (2 * eta ^ 3) + r * t))
   (at_right 0) (Rbar_locally p_infty) (Rpower eta (- (s + 1)) * Ie (2 * eta ^ 3) s (t / eta))).
{ eapply improper_ext; [|exact A]. intros r Hr.
  change (Rpower eta
    (- (s + 1)) * (eta * (Rpower (eta * r) s * exp (psi (eta * r) / (2 * eta ^ 3) + eta * r * (t / eta))))
    = Rpower r s * exp (psi (eta * r) / (2 * eta ^ 3) + r * t)).
  rewrite <- Rpower_mult_distr by auto.
  replace (eta * r * (t / eta)) with (r * t) by (field; lra).
  replace (Rpower eta (- (s + 1)) * (eta * (Rpower eta s * Rpower r s * exp (psi (eta * r) / (2 * eta ^ 3) + r * t))))
    with ((Rpower eta (- (s + 1)) * (eta * Rpower eta s)) * (Rpower r s * exp (psi (eta * r) / (2 * eta ^ 3) + r * t)))
      by ring.
  rewrite <- Rpower_S by auto. rewrite <- Rpower_plus.
  replace (- (s + 1) + (s + 1)) with 0 by ring. rewrite Rpower_O by auto. ring. }
assert (B := is_RInt_gen_minus _ _ _ _ A' Hl).
assert (A3 := W_correct (s + 4) t ltac:(lra)).
apply (is_RInt_gen_scal _ (eta / 8)) in A3.
assert (B2 := is_RInt_gen_minus _ _ _ _ A3 B).
apply improper_pos in B.
2: { intros r Hr. exact (proj1 (ke_limit eta s t r He Hr)). }
apply improper_pos in B2.
2: { intros r Hr. assert (H := proj2 (ke_limit eta s t r He Hr)).
     unfold scal, minus, plus, opp; simpl; unfold mult; simpl. simpl in H. lra. }
unfold scal, minus, plus, opp in B, B2; simpl in B, B2; unfold mult in B, B2; simpl in B, B2.
simpl. lra.
Qed.

(** The compliant slow solution against Theta, n > b: an explicit remainder of known sign. *)
Theorem Fe_limit b n eta t theta : not_nat b -> b < INR n -> is_Theta b theta -> 0 < eta ->
  0 <= Gamma (- b) * (Rpower eta (b - INR n) * Derive_n (Fe (2 * eta ^ 3) b) n (t / eta) - Derive_n theta n t)
    <= eta / 8 * W (INR n - b + 3) t.
Proof.
intros Hb Hn HT He.
assert (He2 : 0 < 2 * eta ^ 3) by (generalize (pow_lt eta 3 He); lra).
assert (HR := Theta_representation b theta n Hb Hn HT t).
assert (H := Ie_limit eta (INR n - b - 1) t _ He ltac:(lra) HR).
replace (INR n - b - 1 + 4) with (INR n - b + 3) in H by ring.
replace (- (INR n - b - 1 + 1)) with (b - INR n) in H by ring.
rewrite <- (Je_Ie (2 * eta ^ 3) He2) in H by lra.
rewrite <- (Fe_derive_n (2 * eta ^ 3) He2 b n (t / eta) Hb) in H.
replace (Gamma (- b) * (Rpower eta (b - INR n) * Derive_n (Fe (2 * eta ^ 3) b) n (t / eta) - Derive_n theta n t))
  with (Rpower eta (b - INR n) * (Gamma (- b) * Derive_n (Fe (2 * eta ^ 3) b) n (t / eta)) - Gamma
    (- b) * Derive_n theta n t) by ring.
exact H.
Qed.
