(** * The compliant model: monotone in eta

    Theorem C of proofs/monotone.md. psi(x)/x^3 increases on x > 0, so the weight e^(psi(eta r)/(2 eta^3)) increases
    with eta, from e^(-r^3/3) at eta = 0: where the integrals converge, Gamma(-b) G^(n)(t; eta), G = eta^b F_b(t/eta),
    increases with eta. [LeftExpansion.v] carries this to every n > b - 4. In the same way Gamma(-b) (G^(n) - Theta^(n))
    <= (eta/8) Gamma(-b) G^(n+4). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus TruncatedIntegral TruncationLimit GammaFunction
  LaplaceIntegral
  ImproperIntegral Family Ends CompliantKernel CompliantIntegral CompliantSlow CompliantLimit LeftExpansion.
Open Scope R_scope.

(** ** psi(x)/x^3 increases *)

Lemma incr_of_derive (f df : R -> R) (a b : R) : a < b ->
  (forall x, a <= x <= b -> is_derive f x (df x)) -> (forall x, a < x < b -> 0 < df x) -> f a < f b.
Proof.
intros Hab D H. destruct (mvt_open f df a b Hab D) as (c & Hc & E).
specialize (H c Hc). assert (0 < df c * (b - a)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Definition psi_slope (x : R) : R := x * (- x ^ 2 * (x + 2) / (1 + x)) - 3 * psi x.

Lemma psi_slope_pos x : 0 < x -> 0 < psi_slope x.
Proof.
intros Hx. replace 0 with (psi_slope 0) by (unfold psi_slope; rewrite psi_0; field).
apply (incr_of_derive psi_slope (fun u => u ^ 3 / (1 + u) ^ 2)); auto.
- intros u Hu. unfold psi_slope, psi. auto_derive. repeat split; lra. field; lra.
- intros u Hu. apply Rdiv_lt_0_compat; apply pow_lt; lra.
Qed.

Lemma psi_cube_increasing x y : 0 < x < y -> psi x / x ^ 3 < psi y / y ^ 3.
Proof.
intros Hx. apply (incr_of_derive (fun u => psi u / u ^ 3) (fun u => psi_slope u / u ^ 4)); [lra| |].
- intros u Hu. unfold psi_slope, psi. auto_derive. repeat split; try lra. change (u ^ 3 <> 0).
  apply Rgt_not_eq, pow_lt; lra.
  field. lra.
- intros u Hu. apply Rdiv_lt_0_compat. apply psi_slope_pos; lra. apply pow_lt; lra.
Qed.

(** The exponent of the weight at the scale eta. *)
Definition weight_exponent (eta r : R) : R := psi (eta * r) / (2 * eta ^ 3).

Lemma weight_bounds eta r : 0 < eta -> 0 < r -> - (r ^ 3 / 3) < weight_exponent eta r /\
  weight_exponent eta r <= - (r ^ 3 / 6) /\ weight_exponent eta r + r ^ 3 / 3 <= eta * r ^ 4 / 8.
Proof.
intros He Hr. assert (Hx : 0 < eta * r) by (apply Rmult_lt_0_compat; auto).
assert (He3 : 0 < eta ^ 3) by (apply pow_lt; auto).
unfold weight_exponent.
refine (conj _ (conj _ _)); apply Rmult_lt_reg_r with (2 * eta ^ 3) || apply Rmult_le_reg_r with (2 * eta ^ 3); try lra.
- replace (psi (eta * r) / (2 * eta ^ 3) * (2 * eta ^ 3)) with (psi (eta * r)) by (field; lra).
  replace (- (r ^ 3 / 3) * (2 * eta ^ 3)) with (- (2 / 3) * (eta * r) ^ 3) by field.
  assert (H : psi (eta * r / 2) / (eta * r / 2) ^ 3 < psi (eta * r) / (eta * r) ^ 3)
    by (apply psi_cube_increasing; lra).
  destruct (psi_bounds (eta * r / 2) ltac:(lra)) as [Q _].
  assert (P2 : 0 < (eta * r / 2) ^ 3) by (apply pow_lt; lra). assert (P1 : 0 < (eta * r) ^ 3) by (apply pow_lt; lra).
  assert (L : - (2 / 3) <= psi (eta * r / 2) / (eta * r / 2) ^ 3).
  { apply Rmult_le_reg_r with ((eta * r / 2) ^ 3); auto.
    replace (psi (eta * r / 2) / (eta * r / 2) ^ 3 * (eta * r / 2) ^ 3) with (psi (eta * r / 2)) by (field; lra). lra. }
  apply Rlt_le_trans with (psi (eta * r) / (eta * r) ^ 3 * (eta * r) ^ 3).
  + apply Rmult_lt_compat_r; lra.
  + right. field. lra.
- replace (psi (eta * r) / (2 * eta ^ 3) * (2 * eta ^ 3)) with (psi (eta * r)) by (field; lra).
  replace (- (r ^ 3 / 6) * (2 * eta ^ 3)) with (- ((eta * r) ^ 3 / 3)) by field. apply psi_upper; lra.
- replace ((psi (eta * r) / (2 * eta ^ 3) + r ^ 3 / 3) * (2 * eta ^ 3)) with (psi (eta * r) + 2 * (eta * r) ^ 3 / 3)
    by (field; lra).
  replace (eta * r ^ 4 / 8 * (2 * eta ^ 3)) with ((eta * r) ^ 4 / 4) by field. apply psi_quartic; lra.
Qed.

Lemma weight_increasing eta eta' r : 0 < eta < eta' -> 0 < r -> weight_exponent eta r < weight_exponent eta' r.
Proof.
intros He Hr.
assert (H : forall u, 0 < u -> weight_exponent u r = r ^ 3 / 2 * (psi (u * r) / (u * r) ^ 3)).
{ intros u Hu. unfold weight_exponent. field. split; lra. }
rewrite !H by lra. apply Rmult_lt_compat_l. apply Rdiv_lt_0_compat; [apply pow_lt|]; lra.
apply psi_cube_increasing. split. apply Rmult_lt_0_compat; lra. apply Rmult_lt_compat_r; lra.
Qed.

(** 0 <= e^g - 1 + r^3/3 <= A r^4 + B r^6, as left_rest_integral asks. *)
Lemma weight_expansion g r A : 0 < r -> - (r ^ 3 / 3) <= g <= 0 -> g + r ^ 3 / 3 <= A * r ^ 4 ->
  0 <= exp g - 1 + r ^ 3 / 3 <= A * r ^ 4 + / 9 * r ^ 6.
Proof.
intros Hr Hg HA. assert (H1 := exp_ineq1_le g). assert (H2 := exp_ineq1_le (- g)).
assert (Hx := exp_pos g).
assert (E : exp g * exp (- g) = 1) by (rewrite <- exp_plus; replace (g + - g) with 0 by ring; apply exp_0).
assert (H3 : exp g * (1 + - g) <= 1) by (rewrite <- E; apply Rmult_le_compat_l; lra).
assert (H4 : exp g <= 1) by (rewrite <- exp_0; apply exp_le; lra).
(* e^g - 1 - g <= g (e^g - 1) <= g^2 *)
assert (H5 : exp g - 1 - g <= g ^ 2).
{ assert (- g * (1 - exp g) <= - g * - g) by (apply Rmult_le_compat_l; lra). simpl. lra. }
assert (H6 : g ^ 2 <= / 9 * r ^ 6).
{ replace (/ 9 * r ^ 6) with ((r ^ 3 / 3) * (r ^ 3 / 3)) by field. replace (g ^ 2) with (- g * - g) by ring.
  apply Rmult_le_compat; lra. }
split; lra.
Qed.

(** ** A strictly positive integrand *)

Lemma improper_positive (f : R -> R) l : (forall r, 0 < r -> 0 < f r) -> (forall r, 0 < r -> continuous f r) ->
  is_RInt_gen f (at_right 0) (Rbar_locally p_infty) l -> 0 < l.
Proof.
intros Hf Hc Hl.
assert (Hp : 0 < RInt f 1 2). { apply RInt_gt_0; try lra; intros; [apply Hf|apply Hc]; lra. }
eapply Rlt_le_trans; [exact Hp|]. apply Rnot_lt_le. intros Hlt.
assert (Hd : 0 < RInt f 1 2 - l) by lra.
assert (Ex : forall a d, 0 < a -> a <= d -> ex_RInt f a d).
{ intros a d Ha Hd'. apply (ex_RInt_continuous f). intros z Hz; rewrite Rmin_left in Hz by lra. apply Hc; lra. }
unfold is_RInt_gen in Hl.
rewrite (filterlimi_locally (F := filter_prod (at_right 0) (Rbar_locally p_infty))) in Hl.
destruct (filter_ex (F := trunc) _ (trunc_and _ _ trunc_basic (Hl (mkposreal _ Hd))))
  as [[a d] [[Ha Hd'] [z [Hz1 Hz2]]]]; simpl in *.
apply (is_RInt_unique (V := R_CompleteNormedModule)) in Hz1.
assert (N : forall a d, 0 < a -> a <= d -> 0 <= RInt f a d).
{ intros u v Hu Hv. apply RInt_ge_0; auto. intros. apply Rlt_le, Hf. lra. }
assert (E1 : RInt f a d = RInt f a 1 + (RInt f 1 2 + RInt f 2 d)).
{ rewrite <- (RInt_Chasles f a 1 d) by (apply Ex; lra). rewrite <- (RInt_Chasles f 1 2 d) by (apply Ex; lra).
  reflexivity. }
assert (N1 := N a 1 ltac:(lra) ltac:(lra)). assert (N2 := N 2 d ltac:(lra) ltac:(lra)).
assert (Hz : RInt f a d - l < RInt f 1 2 - l).
{ rewrite Hz1. apply Rabs_def2 in Hz2; unfold minus, plus, opp in Hz2; simpl in Hz2. lra. }
lra.
Qed.

Lemma improper_lt (f g : R -> R) lf lg : (forall r, 0 < r -> f r < g r) ->
  (forall r, 0 < r -> continuous f r) -> (forall r, 0 < r -> continuous g r) ->
  is_RInt_gen f (at_right 0) (Rbar_locally p_infty) lf -> is_RInt_gen g (at_right 0) (Rbar_locally p_infty) lg ->
    lf < lg.
Proof.
intros H Cf Cg Hf Hg.
assert (D := is_RInt_gen_minus _ _ _ _ Hg Hf).
apply improper_positive in D.
- unfold minus, plus, opp in D; simpl in D. lra.
- intros r Hr. specialize (H r Hr). unfold minus, plus, opp; simpl. lra.
- intros r Hr. apply (continuous_minus g f); auto.
Qed.

(** ** The two families *)

Definition scaled_J (eta s : R) (k : nat) (t : R) : R :=
  Rpower eta (- (s + INR k + 1)) * Je (2 * eta ^ 3) (s + INR k) (t / eta).

Section Scaled.
Variable eta : R.
Hypothesis He : 0 < eta.

Lemma two_cube : 0 < 2 * eta ^ 3.
Proof. generalize (pow_lt eta 3 He); lra. Qed.

Lemma scaled_J_integral s k t : -1 < s + INR k ->
  is_RInt_gen (fun r => Rpower r (s + INR k) * exp (weight_exponent eta r + r * t))
    (at_right 0) (Rbar_locally p_infty) (scaled_J eta s k t).
Proof.
intros Hs. unfold scaled_J. set (q := s + INR k) in *. rewrite (Je_Ie _ two_cube) by auto.
assert (A := improper_scale _ eta _ He (proj1 (Ie_aux (2 * eta ^ 3) q (t / eta) two_cube Hs))).
apply (is_RInt_gen_scal _ (Rpower eta (- (q + 1)))) in A.
eapply improper_ext; [|exact A]. intros r Hr.
change (Rpower eta
  (- (q + 1)) * (eta * (Rpower (eta * r) q * exp (psi (eta * r) / (2 * eta ^ 3) + eta * r * (t / eta))))
  = Rpower r q * exp (weight_exponent eta r + r * t)).
rewrite <- Rpower_mult_distr by auto.
replace (eta * r * (t / eta)) with (r * t) by (field; lra).
fold (weight_exponent eta r). set (X := exp _).
replace (Rpower eta (- (q + 1)) * (eta * (Rpower eta q * Rpower r q * X)))
  with ((Rpower eta (- (q + 1)) * (eta * Rpower eta q)) * (Rpower r q * X)) by ring.
rewrite <- Rpower_S by auto. rewrite <- Rpower_plus.
replace (- (q + 1) + (q + 1)) with 0 by ring. rewrite Rpower_O by auto. ring.
Qed.

Lemma scaled_J_continuous q t r : 0 < r -> continuous (fun r => Rpower r q * exp (weight_exponent eta r + r * t)) r.
Proof.
intros Hr. apply (ex_derive_continuous (fun r => Rpower r q * exp (weight_exponent eta r + r * t)) r).
unfold weight_exponent, psi, Rpower. assert (0 < eta * r) by (apply Rmult_lt_0_compat; auto). auto_derive.
repeat split; lra.
Qed.

Lemma scaled_J_family s : ok s -> family eta s (scaled_J eta s).
Proof.
intros Hs. refine (conj _ (conj _ _)).
- intros k t. assert (D := Je_derive (2 * eta ^ 3) two_cube (s + INR k) (t / eta) (ok_plus s k Hs)).
  apply (is_derive_val _ _ (Rpower eta (- (s + INR k + 1)) * (/ eta * Je (2 * eta ^ 3) (s + INR k + 1) (t / eta)))).
  + apply (is_derive_scal (fun t => Je (2 * eta ^ 3) (s + INR k) (t / eta))).
    apply (is_derive_comp (Je (2 * eta ^ 3) (s + INR k)) (fun t => t / eta) t (Je (2 * eta ^ 3) (s + INR k + 1)
      (t / eta)) (/ eta)).
    exact D. auto_derive; auto. field; lra.
  + unfold scaled_J. rewrite S_INR. replace (s + (INR k + 1)) with (s + INR k + 1) by ring.
    replace (- (s + INR k + 1)) with (1 + - (s + INR k + 1 + 1)) by ring. rewrite Rpower_plus, Rpower_1 by auto.
    field. lra.
- intros k t q.
  assert (R := Je_recurrence (2 * eta ^ 3) two_cube q (t / eta) (ok_plus s k Hs)).
  unfold scaled_J. rewrite !plus_INR. simpl (INR 1). simpl (INR 2). simpl (INR 3). simpl (INR 4).
  replace (s + (INR k + 1)) with (q + 1) by (unfold q; ring).
  replace (s + (INR k + (1 + 1))) with (q + 2) by (unfold q; ring).
  replace (s + (INR k + (1 + 1 + 1))) with (q + 3) by (unfold q; ring).
  replace (s + (INR k + (1 + 1 + 1 + 1))) with (q + 4) by (unfold q; ring). fold q.
  set (Y := Rpower eta (- (q + 5))).
  rewrite (Rpower_split eta (- (q + 1)) 4 (- (q + 5))) by (auto; simpl; ring).
  replace (q + 1 + 1) with (q + 2) by ring. replace (q + 2 + 1) with (q + 3) by ring.
  replace (q + 3 + 1) with (q + 4) by ring. replace (q + 4 + 1) with (q + 5) by ring.
  rewrite (Rpower_split eta (- (q + 2)) 3 (- (q + 5))) by (auto; simpl; ring).
  rewrite (Rpower_split eta (- (q + 3)) 2 (- (q + 5))) by (auto; simpl; ring).
  rewrite (Rpower_split eta (- (q + 4)) 1 (- (q + 5))) by (auto; simpl; ring).
  fold Y. apply (Rmult_eq_compat_l (eta ^ 4 * Y)) in R. rewrite Rmult_0_r in R. rewrite <- R. field. lra.
- intros k Hk. apply (left_rest_integral (s + INR k) _ (weight_exponent eta) (eta / 8) (/ 9) Hk).
  + intros x Hx. apply scaled_J_integral, Hk.
  + intros r Hr. destruct (weight_bounds eta r He Hr) as (B1 & B2 & B3).
    assert (0 < r ^ 3) by (apply pow_lt, Hr). apply weight_expansion; lra.
Qed.
End Scaled.

Lemma scaled_family b theta : not_nat b -> is_Theta b theta -> family 0 (- b - 1) (scaled b theta).
Proof.
intros Hb HT. refine (conj (scaled_derive b theta Hb HT) (conj _ _)).
- intros k t q.
  destruct (Theta_Laplace_n b theta k Hb HT) as (y1 & y2 & D0 & D1 & D2 & _).
  assert (E1 : forall u, y1 u = scaled b theta (S k) u).
  { intros u. rewrite <- (is_derive_unique _ _ _ (D0 u)). apply is_derive_unique, scaled_derive; auto. }
  assert (E2 : forall u, y2 u = scaled b theta (S (S k)) u).
  { intros u. rewrite <- (is_derive_unique _ _ _ (D1 u)). rewrite (Derive_ext _ _ u E1).
    apply is_derive_unique, scaled_derive; auto. }
  assert (E3 : scaled b theta (S (S (S k))) t = t * y1 t + (INR k - b - 1 + 1) * scaled b theta k t).
  { assert (E := is_derive_unique _ _ _ (D2 t)). rewrite (Derive_ext _ _ t E2) in E.
    rewrite (is_derive_unique _ _ _ (scaled_derive b theta Hb HT (S (S k)) t)) in E. exact E. }
  rewrite E1 in E3.
  replace (k + 1)%nat with (S k) by lia. replace (k + 3)%nat with (S (S (S k))) by lia. rewrite E3. unfold q. field.
- intros k Hk. apply (left_rest_integral (- b - 1 + INR k) _ (fun r => - (r ^ 3 / 3)) 0 (/ 9) Hk).
  + intros x Hx. assert (H := Theta_representation b theta k Hb ltac:(lra) HT (- x)).
    eapply improper_ext; [|exact H]. intros r Hr. simpl.
    replace (INR k - b - 1) with (- b - 1 + INR k) by ring. f_equal. f_equal. unfold Rminus; ring.
  + intros r Hr. assert (0 < r ^ 3) by (apply pow_lt, Hr). apply weight_expansion; lra.
Qed.

(** ** Theorem C *)

(** Gamma(-b) eta^(b-n) F^(n)(t/eta) is the member n of the family. *)
Lemma scaled_slow b n eta t : 0 < eta -> not_nat b ->
  Gamma (- b) * (Rpower eta (b - INR n) * Derive_n (Fe (2 * eta ^ 3) b) n (t / eta)) = scaled_J eta (- b - 1) n t.
Proof.
intros He Hb. unfold scaled_J.
replace (Gamma (- b) * (Rpower eta (b - INR n) * Derive_n (Fe (2 * eta ^ 3) b) n (t / eta)))
  with (Rpower eta (b - INR n) * (Gamma (- b) * Derive_n (Fe (2 * eta ^ 3) b) n (t / eta))) by ring.
rewrite (Fe_derive_n _ (two_cube eta He) b n _ Hb).
replace (- (- b - 1 + INR n + 1)) with (b - INR n) by ring. replace (- b - 1 + INR n) with (INR n - b - 1) by ring.
reflexivity.
Qed.

Theorem monotone_in_eta b n eta eta' t : not_nat b -> b < INR n + 4 -> 0 < eta < eta' ->
  scaled_J eta (- b - 1) n t < scaled_J eta' (- b - 1) n t.
Proof.
intros Hb Hn He.
apply (family_order (- b - 1) eta eta' (scaled_J eta (- b - 1)) (scaled_J eta' (- b - 1)) (ok_not_nat b Hb)
  (scaled_J_family eta ltac:(lra) _ (ok_not_nat b Hb)) (scaled_J_family eta' ltac:(lra) _ (ok_not_nat b Hb))); [|lra].
intros k u Hk.
eapply improper_lt; [| | |apply scaled_J_integral; [lra|exact Hk]|apply scaled_J_integral; [lra|exact Hk]].
- intros r Hr. apply Rmult_lt_compat_l. apply exp_pos. apply exp_increasing.
  assert (H := weight_increasing eta eta' r He Hr). lra.
- intros r Hr. apply (scaled_J_continuous eta); lra.
- intros r Hr. apply (scaled_J_continuous eta'); lra.
Qed.

Theorem above_leading_order b n eta theta t : not_nat b -> b < INR n + 4 -> 0 < eta -> is_Theta b theta ->
  scaled b theta n t < scaled_J eta (- b - 1) n t <= scaled b theta n t + eta / 8 * scaled_J eta (- b - 1) (n + 4) t.
Proof.
intros Hb Hn He HT.
assert (F0 := scaled_family b theta Hb HT). assert (F1 := scaled_J_family eta He _ (ok_not_nat b Hb)).
assert (I0 : forall k u, -1 < - b - 1 + INR k ->
  is_RInt_gen (fun r => Rpower r (- b - 1 + INR k) * exp (- (r ^ 3 / 3) + r * u)) (at_right 0) (Rbar_locally p_infty)
    (scaled b theta k u)).
{ intros k u Hk. assert (H := Theta_representation b theta k Hb ltac:(lra) HT u).
  eapply improper_ext; [|exact H]. intros r Hr. simpl.
  replace (INR k - b - 1) with (- b - 1 + INR k) by ring. f_equal. f_equal. unfold Rminus; ring. }
split.
- apply (family_order (- b - 1) 0 eta (scaled b theta) (scaled_J eta (- b - 1)) (ok_not_nat b Hb) F0 F1); [|lra].
  intros k u Hk.
  eapply improper_lt; [| | |apply I0, Hk|apply scaled_J_integral; [exact He|exact Hk]].
  + intros r Hr. apply Rmult_lt_compat_l. apply exp_pos. apply exp_increasing.
    assert (H := weight_bounds eta r He Hr). lra.
  + intros r Hr. apply (ex_derive_continuous (fun r => Rpower r (- b - 1 + INR k) * exp (- (r ^ 3 / 3) + r * u)) r).
    unfold Rpower. auto_derive; auto.
  + intros r Hr. apply (scaled_J_continuous eta He); auto.
- apply (family_upper (- b - 1) 0 eta (scaled b theta) (scaled_J eta (- b - 1)) (ok_not_nat b Hb) F0 F1); [|lra].
  intros k u Hk.
  assert (A4 : -1 < - b - 1 + INR (k + 4)) by (rewrite plus_INR; simpl; lra).
  assert (P := is_RInt_gen_plus _ _ _ _ (I0 k u Hk) (is_RInt_gen_scal _ (eta / 8) _ (scaled_J_integral eta He (- b - 1)
    (k + 4) u A4))).
  eapply improper_le; [|exact (scaled_J_integral eta He (- b - 1) k u Hk)|exact P].
  intros r Hr. unfold plus, scal; simpl; unfold mult; simpl.
  rewrite (Rpower_split r (- b - 1 + INR (k + 4)) 4 (- b - 1 + INR k)) by (auto; rewrite plus_INR; simpl; ring).
  rewrite !exp_plus.
  set (Q := Rpower r (- b - 1 + INR k)). assert (HQ : 0 < Q) by apply exp_pos.
  set (X := exp (r * u)). assert (HX : 0 < X) by apply exp_pos.
  set (g := weight_exponent eta r). destruct (weight_bounds eta r He Hr) as (B1 & B2 & B3). fold g in B1, B2, B3.
  assert (C2 : exp g - exp (- (r ^ 3 / 3)) <= (g + r ^ 3 / 3) * exp g).
  { assert (H := exp_ineq1_le (- (g + r ^ 3 / 3))).
    assert (E : exp g * exp (- (g + r ^ 3 / 3)) = exp (- (r ^ 3 / 3))) by (rewrite <- exp_plus; f_equal; ring).
    assert (HA := exp_pos g).
    assert (exp g * (1 + - (g + r ^ 3 / 3)) <= exp g * exp (- (g + r ^ 3 / 3))) by (apply Rmult_le_compat_l; lra).
    lra. }
  assert (C3 : (g + r ^ 3 / 3) * exp g <= eta * r ^ 4 / 8 * exp g)
    by (apply Rmult_le_compat_r; [apply Rlt_le, exp_pos|lra]).
  assert (HPX : 0 < Q * X) by (apply Rmult_lt_0_compat; auto).
  assert (C4 : Q * X * (exp g - exp (- (r ^ 3 / 3))) <= Q * X * (eta * r ^ 4 / 8 * exp g))
    by (apply Rmult_le_compat_l; lra).
  simpl in *. lra.
Qed.
