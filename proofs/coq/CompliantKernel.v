(** * The compliant model: the kernel

    I_s(T) = int_0^oo r^s e^(psi(r)/e + rT) dr, psi(r) = r - r^2/2 - r^3/3 - ln(1 + r), s > -1 ([Ie e s T]): it
    converges and is positive; I_s' = I_(s+1), since |e^(rh) - 1 - rh| <= (rh)^2 e^r for |h| <= 1; the moment
    recurrence, from the total derivative of r^(s+1) (1 + r) e^(psi/e + rT). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncatedIntegral TruncationLimit GammaFunction LaplaceIntegral
  ImproperIntegral.
Open Scope R_scope.

Definition psi (r : R) : R := r - r ^ 2 / 2 - r ^ 3 / 3 - ln (1 + r).

Definition ke (e s t r : R) : R := Rpower r s * exp (psi r / e + r * t).

Definition Ie (e s t : R) : R := RInt_gen (ke e s t) (at_right 0) (Rbar_locally p_infty).

Lemma psi_derive r : 0 < r -> is_derive psi r (- r ^ 2 * (r + 2) / (1 + r)).
Proof.
intros Hr. unfold psi. auto_derive. lra. field; lra.
Qed.

Lemma psi_0 : psi 0 = 0.
Proof. unfold psi. rewrite Rplus_0_r, ln_1. field. Qed.

Lemma psi_le r : 0 < r -> psi r <= r - r ^ 2 / 2.
Proof.
intros Hr. unfold psi.
assert (0 < ln (1 + r)) by (rewrite <- ln_1; apply ln_increasing; lra).
assert (0 < r ^ 3) by (apply pow_lt; lra). lra.
Qed.

(** psi is squeezed: - 2 r^3 / 3 <= psi <= 0 *)
Lemma psi_bounds r : 0 <= r -> - (2 * r ^ 3 / 3) <= psi r <= 0.
Proof.
intros Hr.
assert (D : forall x, 0 <= x -> is_derive psi x (- x ^ 2 * (x + 2) / (1 + x))).
{ intros x Hx. unfold psi. auto_derive. lra. field; lra. }
split.
- assert (H : - (psi r + 2 * r ^ 3 / 3) <= - (psi 0 + 2 * 0 ^ 3 / 3)).
  { apply (decr_of_derive (fun x => - (psi x + 2 * x ^ 3 / 3))
      (fun x => - (- x ^ 2 * (x + 2) / (1 + x) + 2 * x ^ 2)) 0 r Hr).
    - intros x Hx. apply (is_derive_opp (fun x => psi x + 2 * x ^ 3 / 3)).
      apply (is_derive_plus psi (fun x => 2 * x ^ 3 / 3)). apply D; lra.
      auto_derive; auto; field.
    - intros x Hx.
      replace (- (- x ^ 2 * (x + 2) / (1 + x) + 2 * x ^ 2)) with (- (x ^ 3 / (1 + x))) by (field; lra).
      assert (0 <= x ^ 3 / (1 + x)).
      { apply Rmult_le_pos. apply pow_le; lra. apply Rlt_le, Rinv_0_lt_compat; lra. }
      lra. }
  rewrite psi_0 in H. simpl in *; lra.
- rewrite <- psi_0.
  apply (decr_of_derive psi (fun x => - x ^ 2 * (x + 2) / (1 + x)) 0 r Hr).
  + intros x Hx; apply D; lra.
  + intros x Hx.
    replace (- x ^ 2 * (x + 2) / (1 + x)) with (- (x ^ 2 * (x + 2) / (1 + x))) by (field; lra).
    assert (0 <= x ^ 2 * (x + 2) / (1 + x)).
    { apply Rmult_le_pos. apply Rmult_le_pos. apply pow_le; lra. lra. apply Rlt_le, Rinv_0_lt_compat; lra. }
    lra.
Qed.

Definition Kb (e t : R) : R := (1 + e * (t + 1)) ^ 2 / (2 * e).

Lemma expo_bound e t r : 0 < e -> 0 < r -> psi r / e + r * t <= Kb e t - r.
Proof.
intros He Hr.
assert (H := psi_le r Hr).
apply Rmult_le_reg_l with e; auto.
unfold Kb.
replace (e * (psi r / e + r * t)) with (psi r + e * (r * t)) by (field; lra).
replace (e * ((1 + e * (t + 1)) ^ 2 / (2 * e) - r)) with ((1 + e * (t + 1)) ^ 2 / 2 - e * r) by (field; lra).
assert (0 <= (1 + e * (t + 1) - r) ^ 2) by apply pow2_ge_0.
nra.
Qed.

Lemma ke_pos e s t r : 0 < ke e s t r.
Proof. unfold ke, Rpower; apply Rmult_lt_0_compat; apply exp_pos. Qed.

Lemma continuous_ke e s t r : 0 < r -> continuous (ke e s t) r.
Proof.
intros Hr. apply (ex_derive_continuous (ke e s t) r).
unfold ke, psi, Rpower. auto_derive. repeat split; lra.
Qed.

Lemma ke_le e s t r : 0 < e -> 0 < r -> ke e s t r <= exp (Kb e t) * gamma_integrand (s + 1) r.
Proof.
intros He Hr. unfold ke, gamma_integrand.
replace (s + 1 - 1) with s by ring.
replace (exp (Kb e t) * (Rpower r s * exp (- r))) with (Rpower r s * exp (Kb e t - r))
  by (unfold Rminus; rewrite exp_plus; ring).
apply Rmult_le_compat_l. apply Rlt_le, exp_pos.
apply exp_le, expo_bound; auto.
Qed.

Lemma ex_RInt_ke e s t a d : 0 < a -> a <= d -> ex_RInt (ke e s t) a d.
Proof.
intros Ha Hd. apply (ex_RInt_continuous (ke e s t)).
intros z Hz; rewrite Rmin_left in Hz by lra. apply continuous_ke; lra.
Qed.

Lemma Ie_aux e s t : 0 < e -> -1 < s ->
  is_RInt_gen (ke e s t) (at_right 0) (Rbar_locally p_infty) (Ie e s t) /\ 0 < Ie e s t.
Proof.
intros He Hs.
set (B := exp (Kb e t) * (exp ((s + 1 + 1) * ln (s + 1 + 1) - (s + 1)) / (s + 1))).
destruct (ex_RInt_gen_bounded (ke e s t) B) as [l [Hl Hle]].
- intros; apply Rlt_le, ke_pos.
- intros; apply continuous_ke; auto.
- intros a d Ha Hd.
  apply Rle_trans with (RInt (fun r => exp (Kb e t) * gamma_integrand (s + 1) r) a d).
  + apply RInt_le; auto. apply ex_RInt_ke; auto.
    apply (ex_RInt_scal (gamma_integrand (s + 1))), ex_RInt_gamma_integrand; auto.
    intros x Hx. apply ke_le; lra.
  + rewrite (RInt_scal (gamma_integrand (s + 1))) by (apply ex_RInt_gamma_integrand; auto).
    unfold B. apply Rmult_le_compat_l. apply Rlt_le, exp_pos.
    apply RInt_gamma_integrand_bound; auto; lra.
- assert (H : Ie e s t = l).
  { apply (is_RInt_gen_unique (V := R_CompleteNormedModule) _ l). exact Hl. }
  rewrite H. split; auto.
  eapply Rlt_le_trans; [|apply (Hle 1 2); lra].
  apply RInt_gt_0; try lra. intros; apply ke_pos.
  intros; apply continuous_ke; lra.
Qed.

Theorem Ie_correct e s t : 0 < e -> -1 < s ->
  is_RInt_gen (fun r => Rpower r s * exp (psi r / e + r * t))
    (at_right 0) (Rbar_locally p_infty) (Ie e s t).
Proof. intros He Hs. exact (proj1 (Ie_aux e s t He Hs)). Qed.

Theorem Ie_pos e s t : 0 < e -> -1 < s -> 0 < Ie e s t.
Proof. intros He Hs. exact (proj2 (Ie_aux e s t He Hs)). Qed.

(** ** Differentiation in t: by a pointwise second-order estimate *)

Lemma exp_2nd x : 0 <= exp x - 1 - x <= x ^ 2 * exp (Rabs x).
Proof.
assert (H1 := exp_ineq1_le x). split. lra.
assert (H2 := exp_ineq1_le (- x)).
assert (Hx := exp_pos x).
assert (H3 : exp x - 1 <= x * exp x).
{ assert (E : exp x * exp (- x) = 1) by (rewrite <- exp_plus; replace (x + - x) with 0 by ring; apply exp_0).
  assert (exp x * (1 + - x) <= exp x * exp (- x)) by (apply Rmult_le_compat_l; lra). lra. }
destruct (Rle_lt_dec 0 x) as [H0|H0].
- rewrite Rabs_pos_eq by auto.
  assert (x * x <= x * (exp x - 1)) by (apply Rmult_le_compat_l; lra).
  assert (exp x - 1 - x <= x * exp x - x) by lra.
  assert (x * (exp x - 1) <= x * (x * exp x)) by (apply Rmult_le_compat_l; lra).
  simpl. lra.
- rewrite Rabs_left by auto.
  assert (1 <= exp (- x)) by lra.
  assert (0 <= x ^ 2) by apply pow2_ge_0.
  assert (x ^ 2 * 1 <= x ^ 2 * exp (- x)) by (apply Rmult_le_compat_l; lra).
  assert ((- x) * (1 - exp x) <= (- x) * (- x)) by (apply Rmult_le_compat_l; lra).
  simpl in *; lra.
Qed.

Lemma Rpower_SS s r : 0 < r -> Rpower r (s + 2) = r ^ 2 * Rpower r s.
Proof.
intros Hr. replace (s + 2) with (s + 1 + 1) by ring. rewrite !Rpower_S by auto. ring.
Qed.

Lemma ke_diff e s t h r : 0 < r -> Rabs h <= 1 ->
  0 <= ke e s (t + h) r - ke e s t r - h * ke e (s + 1) t r <= h ^ 2 * ke e (s + 2) (t + 1) r.
Proof.
intros Hr Hh. unfold ke. rewrite Rpower_S, Rpower_SS by auto.
set (P := Rpower r s). assert (HP : 0 < P) by apply exp_pos.
replace (psi r / e + r * (t + h)) with (psi r / e + r * t + r * h) by ring.
replace (psi r / e + r * (t + 1)) with (psi r / e + r * t + r) by ring.
rewrite !(exp_plus (psi r / e + r * t)).
set (X := exp (psi r / e + r * t)). assert (HX : 0 < X) by apply exp_pos.
replace (P * (X * exp (r * h)) - P * X - h * (r * P * X)) with (P * X * (exp (r * h) - 1 - r * h)) by ring.
replace (h ^ 2 * (r ^ 2 * P * (X * exp r))) with (P * X * ((r * h) ^ 2 * exp r)) by ring.
assert (HPX : 0 < P * X) by (apply Rmult_lt_0_compat; auto).
destruct (exp_2nd (r * h)) as [E1 E2].
split.
- apply Rmult_le_pos; lra.
- apply Rmult_le_compat_l. lra. eapply Rle_trans; [exact E2|].
  apply Rmult_le_compat_l. apply pow2_ge_0.
  apply exp_le. rewrite Rabs_mult, (Rabs_pos_eq r) by lra.
  rewrite <- (Rmult_1_r r) at 2. apply Rmult_le_compat_l; lra.
Qed.

Theorem Ie_derive e s t : 0 < e -> -1 < s -> is_derive (Ie e s) t (Ie e (s + 1) t).
Proof.
intros He Hs.
apply derive_of_quadratic with (Ie e (s + 2) (t + 1)).
intros h Hh.
assert (A0 := proj1 (Ie_aux e s t He Hs)).
assert (A1 := proj1 (Ie_aux e s (t + h) He Hs)).
assert (A2 := proj1 (Ie_aux e (s + 1) t He ltac:(lra))).
assert (A3 := proj1 (Ie_aux e (s + 2) (t + 1) He ltac:(lra))).
assert (B := is_RInt_gen_minus _ _ _ _ (is_RInt_gen_minus _ _ _ _ A1 A0) (is_RInt_gen_scal _ h _ A2)).
assert (B2 := is_RInt_gen_minus _ _ _ _ (is_RInt_gen_scal _ (h ^ 2) _ A3) B).
apply improper_pos in B.
2: { intros r Hr. exact (proj1 (ke_diff e s t h r Hr Hh)). }
apply improper_pos in B2.
2: { intros r Hr. assert (H := proj2 (ke_diff e s t h r Hr Hh)).
     unfold scal, minus, plus, opp; simpl; unfold mult; simpl. simpl in H. lra. }
unfold scal, minus, plus, opp in B, B2; simpl in B, B2; unfold mult in B, B2; simpl in B, B2.
rewrite Rabs_pos_eq; simpl; lra.
Qed.

(** ** The moment recurrence *)

Lemma Rpower_exp_bound q r : 0 < q -> 0 < r -> Rpower r q * exp (- r) <= exp (q * ln q - q).
Proof.
intros Hq Hr. unfold Rpower. rewrite <- exp_plus. apply exp_le.
assert (H : ln (r / q) <= r / q - 1) by (apply ln_le_sub1, Rdiv_lt_0_compat; auto).
unfold Rdiv in H at 1. rewrite ln_mult, ln_Rinv in H; auto.
2: apply Rinv_0_lt_compat; auto.
apply (Rmult_le_compat_l q) in H; [|lra].
replace (q * (r / q - 1)) with (r - q) in H by (field; lra). lra.
Qed.

Definition We (e s t r : R) : R := ke e (s + 1) t r + ke e (s + 2) t r.

Definition we (e s t r : R) : R :=
  (s + 1) * ke e s t r + (s + 2 + t) * ke e (s + 1) t r + t * ke e (s + 2) t r
  - 2 / e * ke e (s + 3) t r - 1 / e * ke e (s + 4) t r.

Lemma We_derive e s t r : 0 < e -> 0 < r -> is_derive (We e s t) r (we e s t r).
Proof.
intros He Hr.
apply (is_derive_ext_loc (fun r => Rpower r (s + 1) * ((1 + r) * exp (psi r / e + r * t)))).
{ exists (mkposreal r Hr). intros y Hy.
  assert (Hy0 : 0 < y). { apply Rabs_def2 in Hy. unfold minus, plus, opp in Hy; simpl in Hy. lra. }
  unfold We, ke. replace (s + 2) with (s + 1 + 1) by ring. rewrite (Rpower_S (s + 1)) by exact Hy0.
  change (Rpower y (s + 1) * ((1 + y) * exp (psi y / e + y * t)) =
   Rpower y (s + 1) * exp (psi y / e + y * t) + y * Rpower y (s + 1) * exp (psi y / e + y * t)). ring. }
evar_last.
- apply (is_derive_mult_R (fun r => Rpower r (s + 1)) (fun r => (1 + r) * exp (psi r / e + r * t)) r
    ((s + 1) * Rpower r s)
    (1 * exp (psi r / e + r * t) + (1 + r) * ((- r ^ 2 * (r + 2) / (1 + r) / e + t) * exp (psi r / e + r * t)))).
  + unfold Rpower. auto_derive; auto.
    replace (exp ((s + 1) * ln r)) with (r * exp (s * ln r)).
    field; lra.
    fold (Rpower r s) (Rpower r (s + 1)). rewrite Rpower_S by auto; ring.
  + apply (is_derive_mult_R (fun r => 1 + r) (fun r => exp (psi r / e + r * t))).
    auto_derive; auto; ring.
    evar_last.
    apply (is_derive_comp exp (fun r => psi r / e + r * t) r
      (exp (psi r / e + r * t)) (- r ^ 2 * (r + 2) / (1 + r) / e + t)).
    apply is_derive_exp.
    apply (is_derive_plus (fun r => psi r / e) (fun r => r * t)).
    apply (is_derive_ext (fun r => / e * psi r)).
    { intros u. change (/ e * psi u = psi u / e). unfold Rdiv; ring. }
    replace (- r ^ 2 * (r + 2) / (1 + r) / e) with (/ e * (- r ^ 2 * (r + 2) / (1 + r))) by (field; lra).
    apply (is_derive_scal psi), psi_derive, Hr.
    auto_derive; auto; ring.
    reflexivity.
- unfold we, ke.
  replace (s + 4) with (s + 1 + 1 + 1 + 1) by ring.
  replace (s + 3) with (s + 1 + 1 + 1) by ring.
  replace (s + 2) with (s + 1 + 1) at 2 by ring.
  rewrite !(Rpower_S _ r Hr). field. lra.
Qed.

Lemma We_small e s t eta : 0 < e -> -1 < s -> 0 < eta ->
  trunc (fun ad => We e s t (fst ad) <= eta /\ We e s t (snd ad) <= eta).
Proof.
intros He Hs Heta.
set (E := exp (Kb e t)). assert (HE : 0 < E) by apply exp_pos.
apply filter_and.
- set (eta' := eta / (2 * E * exp (/ 3))).
  assert (He3 := exp_pos (/ 3)).
  assert (He' : 0 < eta') by (apply Rdiv_lt_0_compat; auto; nra).
  apply (trunc_left (fun a => We e s t a <= eta)).
  generalize (filter_and _ _ (at_right_lt 1 Rlt_0_1)
    (kernel_small_left (s + 1) 0 eta' ltac:(lra) (Rle_refl 0) He')).
  apply filter_imp. intros a [[Ha Ha1] H].
  specialize (H 0 ltac:(rewrite Rabs_R0; lra)).
  unfold kernel in H. unfold We, ke.
  replace (s + 2) with (s + 1 + 1) by ring. rewrite (Rpower_S (s + 1)) by exact Ha.
  set (P := Rpower a (s + 1)) in *. assert (HP : 0 < P) by apply exp_pos.
  assert (HX : exp (psi a / e + a * t) <= E) by (apply exp_le; generalize (expo_bound e t a He Ha); lra).
  assert (HX0 := exp_pos (psi a / e + a * t)).
  set (X := exp (psi a / e + a * t)) in *.
  assert (Hex : 1 <= exp (a * 0 - a ^ 3 / 3) * exp (/ 3)).
  { rewrite <- exp_plus, <- exp_0. apply exp_le.
    assert (0 < a ^ 2) by (apply pow_lt; lra).
    assert (a ^ 2 <= 1) by nra. assert (a ^ 3 <= 1) by (simpl in *; nra). lra. }
  assert (HPle : P <= eta' * exp (/ 3)).
  { apply Rle_trans with (P * (exp (a * 0 - a ^ 3 / 3) * exp (/ 3))).
    - rewrite <- (Rmult_1_r P) at 1. apply Rmult_le_compat_l; lra.
    - rewrite <- Rmult_assoc. apply Rmult_le_compat_r; lra. }
  replace eta with (2 * (eta' * exp (/ 3) * E)) by (unfold eta'; field; lra).
  assert (P * X <= eta' * exp (/ 3) * E) by (apply Rmult_le_compat; lra).
  assert (0 < P * X) by (apply Rmult_lt_0_compat; auto). nra.
- apply (trunc_right (fun d => We e s t d <= eta)).
  set (A1 := exp ((s + 2) * ln (s + 2) - (s + 2))).
  set (A2 := exp ((s + 3) * ln (s + 3) - (s + 3))).
  assert (HA1 : 0 < A1) by apply exp_pos. assert (HA2 : 0 < A2) by apply exp_pos.
  exists (Rmax 1 (E * (A1 + A2) / eta)). intros d Hd.
  assert (Hd1 : 1 < d) by (eapply Rle_lt_trans; [apply Rmax_l|exact Hd]).
  assert (Hd2 : E * (A1 + A2) / eta < d) by (eapply Rle_lt_trans; [apply Rmax_r|exact Hd]).
  assert (Hk : forall q, 0 < q -> d * ke e (q - 1) t d <= E * exp (q * ln q - q)).
  { intros q Hq.
    replace (d * ke e (q - 1) t d) with (Rpower d q * exp (psi d / e + d * t)).
    2: { unfold ke. replace q with (q - 1 + 1) at 1 by ring. rewrite Rpower_S by lra. ring. }
    apply Rle_trans with (Rpower d q * (E * exp (- d))).
    - apply Rmult_le_compat_l. apply Rlt_le, exp_pos.
      unfold E. rewrite <- exp_plus. apply exp_le. generalize (expo_bound e t d He); lra.
    - replace (Rpower d q * (E * exp (- d))) with (E * (Rpower d q * exp (- d))) by ring.
      apply Rmult_le_compat_l. lra. apply Rpower_exp_bound; lra. }
  assert (B1 := Hk (s + 2) ltac:(lra)). assert (B2 := Hk (s + 3) ltac:(lra)).
  replace (s + 2 - 1) with (s + 1) in B1 by ring. replace (s + 3 - 1) with (s + 2) in B2 by ring.
  fold A1 in B1. fold A2 in B2.
  unfold We. apply Rmult_le_reg_l with d. lra.
  assert (E * (A1 + A2) < d * eta).
  { replace (E * (A1 + A2)) with (E * (A1 + A2) / eta * eta) by (field; lra). apply Rmult_lt_compat_r; auto. }
  lra.
Qed.

Theorem Ie_recurrence e s t : 0 < e -> -1 < s ->
  (s + 1) * Ie e s t + (s + 2 + t) * Ie e (s + 1) t + t * Ie e (s + 2) t
   - 2 / e * Ie e (s + 3) t - 1 / e * Ie e (s + 4) t = 0.
Proof.
intros He Hs.
assert (A0 := proj1 (Ie_aux e s t He Hs)).
assert (A1 := proj1 (Ie_aux e (s + 1) t He ltac:(lra))).
assert (A2 := proj1 (Ie_aux e (s + 2) t He ltac:(lra))).
assert (A3 := proj1 (Ie_aux e (s + 3) t He ltac:(lra))).
assert (A4 := proj1 (Ie_aux e (s + 4) t He ltac:(lra))).
assert (B := is_RInt_gen_minus _ _ _ _ (is_RInt_gen_minus _ _ _ _
  (is_RInt_gen_plus _ _ _ _ (is_RInt_gen_plus _ _ _ _ (is_RInt_gen_scal _ (s + 1) _ A0)
   (is_RInt_gen_scal _ (s + 2 + t) _ A1)) (is_RInt_gen_scal _ t _ A2))
   (is_RInt_gen_scal _ (2 / e) _ A3)) (is_RInt_gen_scal _ (1 / e) _ A4)).
unfold scal, minus, plus, opp in B; simpl in B; unfold mult in B; simpl in B.
set (l := (s + 1) * Ie e s t + (s + 2 + t) * Ie e (s + 1) t + t * Ie e (s + 2) t
   + - (2 / e * Ie e (s + 3) t) + - (1 / e * Ie e (s + 4) t)) in B.
assert (Hl : is_RInt_gen (we e s t) (at_right 0) (Rbar_locally p_infty) l).
{ eapply improper_ext; [|exact B]. intros r Hr. unfold we. ring. }
replace ((s + 1) * Ie e s t + (s + 2 + t) * Ie e (s + 1) t + t * Ie e (s + 2) t
   - 2 / e * Ie e (s + 3) t - 1 / e * Ie e (s + 4) t) with l by (unfold l; ring).
clearbody l. clear A0 A1 A2 A3 A4 B.
destruct (Req_dec l 0) as [H0|H0]; auto. exfalso.
assert (Heta : 0 < Rabs l / 4) by (generalize (Rabs_pos_lt l H0); lra).
unfold is_RInt_gen in Hl.
rewrite (filterlimi_locally (F := filter_prod (at_right 0) (Rbar_locally p_infty))) in Hl.
destruct (filter_ex (F := trunc) _ (trunc_and _ _ trunc_basic (trunc_and _ _
   (We_small e s t _ He Hs Heta) (Hl (mkposreal _ Heta)))))
  as [[a d] [[Ha Hd] [[H1 H2] [z [Hz1 Hz2]]]]]; simpl in *.
assert (Hw : is_RInt (we e s t) a d (We e s t d - We e s t a)).
{ assert (Hmin : Rmin a d = a) by (apply Rmin_left; lra).
  apply (is_RInt_derive (We e s t)).
  - intros r Hr; rewrite Hmin in Hr. apply We_derive; lra.
  - intros r Hr; rewrite Hmin in Hr.
    apply (ex_derive_continuous (we e s t) r).
    unfold we, ke, psi, Rpower. auto_derive. repeat split; lra. }
apply (is_RInt_unique (V := R_CompleteNormedModule)) in Hz1.
apply (is_RInt_unique (V := R_CompleteNormedModule)) in Hw.
rewrite Hz1 in Hw. rewrite Hw in Hz2.
assert (P1 : 0 < We e s t a) by (generalize (ke_pos e (s + 1) t a) (ke_pos e (s + 2) t a); unfold We; lra).
assert (P2 : 0 < We e s t d) by (generalize (ke_pos e (s + 1) t d) (ke_pos e (s + 2) t d); unfold We; lra).
apply Rabs_def2 in Hz2; unfold minus, plus, opp in Hz2; simpl in Hz2.
revert H1 H2 Hz2. unfold Rabs; destruct Rcase_abs; lra.
Qed.
