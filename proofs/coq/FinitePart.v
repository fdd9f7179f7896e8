(** * Theta by Hadamard's finite part, for every real b that is no integer

    Gamma(-b) Theta^(k)(t) = sum p_n x^(n+k-b)/(n+k-b) + int_x^oo r^(k-b-1) e^(rt - r^3/3) dr for every x > 0, where
    e^(rt - r^3/3) = sum p_n r^n. For k > b it is the Laplace integral: the sum has the integrand as its derivative.
    Both parts obey the differential equation up to boundary terms, which cancel: so the formula for k + 1 and k + 3
    gives it for k ([finite_part_down]), and it holds for k = 0. No continuation in b is needed. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncatedIntegral TruncationLimit GammaFunction LaplaceIntegral
  PowerSeriesNorm NormLimit IntegerPolynomials PolynomialSum BinomialSeries.
Import ListNotations.
Open Scope R_scope.

(** ** The coefficients of e^(rt - r^3/3) *)

Lemma norm_exp_of r q v : 0 < r -> 0 <= q -> norm_at_most r q v -> norm_at_most r (exp q) (fun x => exp (v x)).
Proof.
intros Hr Hq Hv.
assert (P : forall n, 0 < / INR (fact n)) by (intros; apply Rinv_0_lt_compat, lt_0_INR, lt_O_fact).
apply (norm_series r (fun j x => / INR (fact j) * v x ^ j) (fun j => / INR (fact j) * q ^ j)); auto.
- intros j. rewrite <- (Rabs_pos_eq (/ INR (fact j))) at 1 by apply Rlt_le, P. apply norm_scal, norm_pow; auto.
- intros N. apply (sum_at_most (fun j => / INR (fact j))); auto. intros; apply Rlt_le, P. apply is_exp_Reals.
- intros x Hx. apply is_pseries_sum_first, is_exp_Reals.
Qed.

Definition cubic_exp (t x : R) : R := exp (x * t - x ^ 3 / 3).

Definition cubic_term (t : R) (n : nat) : R := (-1) ^ n * Pn n t / INR (fact n).

Lemma cubic_term_next t n : INR (S (S (S n))) * cubic_term t (S (S (S n)))
  = t * cubic_term t (S (S n)) - cubic_term t n.
Proof.
unfold cubic_term. rewrite Pn_rec, !fact_simpl, !mult_INR. assert (F := INR_fact_neq_0 n). rewrite !S_INR.
assert (P := pos_INR n). simpl pow. field. repeat split; auto; lra.
Qed.

Section Exponential.
Variable t : R.

Lemma cubic_norm r : 0 < r -> norm_at_most r (exp (Rabs t * r + r ^ 3 / 3)) (cubic_exp t).
Proof.
intros Hr. assert (P : 0 <= r ^ 3) by (apply pow_le; lra). assert (A := Rabs_pos t).
apply norm_exp_of; auto. { assert (0 <= Rabs t * r) by (apply Rmult_le_pos; lra). lra. }
apply (norm_ext r _ (fun x => t * x + - / 3 * x ^ 3)). { intros x _. field. }
apply norm_plus; auto. apply norm_scal, norm_id, Hr.
apply (norm_weaken r (Rabs (- / 3) * r ^ 3)). rewrite Rabs_left; lra. apply norm_scal, norm_pow, norm_id; auto.
Qed.

Lemma cubic_derive x : is_derive (cubic_exp t) x ((t - x ^ 2) * cubic_exp t x).
Proof.
unfold cubic_exp. apply (is_derive_val _ _ ((t - x ^ 2) * exp (x * t - x ^ 3 / 3))); auto.
evar_last. apply (is_derive_comp exp (fun x => x * t - x ^ 3 / 3) x (exp (x * t - x ^ 3 / 3)) (t - x ^ 2)).
apply is_derive_exp. auto_derive; auto; field. reflexivity.
Qed.

(** The coefficients of the power series are the [cubic_term]s: both have the recurrence of (t - x^2) e^(xt - x^3/3). *)
Lemma cubic_coefficients r (a : nat -> R) : 0 < r -> (forall x, Rabs x < r -> is_pseries a x (cubic_exp t x)) ->
  Rbar_lt 0 (CV_radius a) -> (forall x, Rabs x < r -> Rbar_lt (Rabs x) (CV_radius a)) -> forall n, a n = cubic_term t n.
Proof.
intros Hr Ha R0 RR.
assert (A0 : a 0%nat = 1).
{ assert (E := Ha 0 ltac:(rewrite Rabs_R0; lra)). apply is_pseries_unique in E. rewrite PSeries_0 in E.
  rewrite E. unfold cubic_exp. replace (0 * t - 0 ^ 3 / 3) with 0 by field. apply exp_0. }
assert (Rec : forall n, PS_derive a n = PS_minus (PS_scal t a) (PS_incr_1 (PS_incr_1 a)) n).
{ intros n. apply PSeries_ext_recip.
  - rewrite CV_radius_derive. exact R0.
  - apply Rbar_lt_le_trans with (CV_radius a); auto.
    change (PS_minus ?u ?v) with (PS_plus u (PS_opp v)).
    eapply Rbar_le_trans; [|apply CV_radius_plus]. rewrite CV_radius_opp, !CV_radius_incr_1.
    destruct (Req_dec t 0) as [->|Ht].
    + apply Rbar_min_case; [|apply Rbar_le_refl].
      rewrite (CV_radius_ext (PS_scal 0 a) (fun _ => 0)) by (intros i; apply Rmult_0_l). rewrite CV_radius_const_0.
      destruct (CV_radius a); simpl; auto.
    + rewrite CV_radius_scal by exact Ht. apply Rbar_min_case; apply Rbar_le_refl.
  - exists (mkposreal r Hr). intros x Hx. change (Rabs (x - 0) < r) in Hx. rewrite Rminus_0_r in Hx.
    assert (S := Ha x Hx).
    rewrite <- Derive_PSeries by (apply RR, Hx).
    rewrite (Derive_ext_loc (PSeries a) (cubic_exp t)).
    + rewrite (is_derive_unique _ _ _ (cubic_derive x)). symmetry. apply is_pseries_unique.
      assert (I1 := is_pseries_incr_1 (K := R_AbsRing) (V := R_NormedModule) _ _ _ S).
      assert (I2 := is_pseries_incr_1 (K := R_AbsRing) (V := R_NormedModule) _ _ _ I1).
      assert (I3 := is_pseries_minus _ _ _ _ _ (is_pseries_scal t a x _ (Rmult_comm x t) S) I2).
      replace ((t - x ^ 2) * cubic_exp t x) with
        (plus (scal t (cubic_exp t x)) (opp (scal x (scal x (cubic_exp t x))))); [exact I3|].
      unfold plus, opp, scal; simpl; unfold mult; simpl. ring.
    + assert (Hd : 0 < r - Rabs x) by lra. exists (mkposreal _ Hd). intros y Hy.
      change (Rabs (y - x) < r - Rabs x) in Hy. apply is_pseries_unique, Ha.
      change (Rabs y < r). assert (T := Rabs_triang_inv y x). lra. }
assert (A1 : a 1%nat = t).
{ assert (E := Rec 0%nat). unfold PS_derive, PS_minus, PS_plus, PS_opp, PS_scal, PS_incr_1, plus, opp, scal, zero in E.
  simpl in E. unfold mult in E; simpl in E. rewrite A0 in E. lra. }
assert (A2 : 2 * a 2%nat = t * t).
{ assert (E := Rec 1%nat). unfold PS_derive, PS_minus, PS_plus, PS_opp, PS_scal, PS_incr_1, plus, opp, scal, zero in E.
  simpl in E. unfold mult in E; simpl in E. rewrite A1 in E. lra. }
assert (A3 : forall n, INR (S (S (S n))) * a (S (S (S n))) = t * a (S (S n)) - a n).
{ intros n. assert (E := Rec (S (S n))). unfold PS_derive, PS_minus, PS_plus, PS_opp, PS_scal, PS_incr_1 in E.
  unfold Rminus. exact E. }
enough (H : forall n, a n = cubic_term t n /\ a (S n) = cubic_term t (S n) /\ a (S (S n)) = cubic_term t (S (S n)))
  by (intros n; apply H).
induction n as [|n (I1 & I2 & I3)].
- unfold cubic_term. simpl. repeat split; lra.
- refine (conj I2 (conj I3 _)). assert (P : 0 < INR (S (S (S n)))) by (apply lt_0_INR; lia).
  apply Rmult_eq_reg_l with (INR (S (S (S n)))); [|lra]. rewrite A3, cubic_term_next, I1, I3. reflexivity.
Qed.

Theorem cubic_series r : 0 < r ->
  (forall N, sum_first (fun n => Rabs (cubic_term t n) * r ^ n) N <= exp (Rabs t * r + r ^ 3 / 3)) /\
  forall x, Rabs x < r -> is_pseries (cubic_term t) x (cubic_exp t x).
Proof.
intros Hr. destruct (cubic_norm r Hr) as (a & Ha & Hf).
assert (RR : forall x, Rabs x < r -> Rbar_lt (Rabs x) (CV_radius a)).
{ intros x Hx. apply (radius_at_least a r _ Hr Ha), Hx. }
assert (E : forall n, a n = cubic_term t n).
{ apply (cubic_coefficients r); auto. rewrite <- Rabs_R0. apply RR. rewrite Rabs_R0. exact Hr. }
split.
- intros N. rewrite (sum_first_ext _ (fun n => Rabs (a n) * r ^ n)); auto. intros n. rewrite E. reflexivity.
- intros x Hx. apply (is_pseries_ext a); auto.
Qed.

(** ** The sum p_n x^(n+e)/(n+e) *)

Definition part_term (e : R) (n : nat) : R := cubic_term t n / (INR n + e).

Definition finite_part (e x : R) : R := Rpower x e * PSeries (part_term e) x.

Lemma divisors_bounded e : (forall n, INR n + e <> 0) -> exists D, 0 <= D /\ forall n, Rabs (/ (INR n + e)) <= D.
Proof.
intros He. destruct (nfloor_ex (Rabs e + 1)) as (n0 & _ & H0). { generalize (Rabs_pos e); lra. }
set (u := fun n => Rabs (/ (INR n + e))). assert (P : forall n, 0 <= u n) by (intros; apply Rabs_pos).
exists (1 + sum_first u (S (S n0))). assert (Q := sum_first_nonneg u (S (S n0)) P). split; [lra|].
intros n. change (u n <= 1 + sum_first u (S (S n0))). destruct (le_lt_dec n (S n0)) as [Hn|Hn].
- replace (S (S n0)) with (S n + (S n0 - n))%nat by lia. assert (G := sum_first_grow u (S n) (S n0 - n) P).
  cbn [sum_first] in G. assert (Q' := sum_first_nonneg u n P). lra.
- assert (L : INR n0 + 1 <= INR n) by (rewrite <- S_INR; apply le_INR; lia).
  assert (B : 1 <= INR n + e). { generalize (Rle_abs (- e)). rewrite Rabs_Ropp. lra. }
  assert (/ (INR n + e) <= / 1) by (apply Rinv_le_contravar; lra).
  assert (E : u n = / (INR n + e)) by (apply Rabs_pos_eq, Rlt_le, Rinv_0_lt_compat; lra). lra.
Qed.

Lemma part_norm e r : (forall n, INR n + e <> 0) -> 0 < r -> exists M, 0 <= M /\
  forall N, sum_first (fun n => Rabs (part_term e n) * r ^ n) N <= M.
Proof.
intros He Hr. destruct (divisors_bounded e He) as (D & HD & HB). destruct (cubic_series r Hr) as [HN _].
exists (D * exp (Rabs t * r + r ^ 3 / 3)). split. apply Rmult_le_pos; auto. apply Rlt_le, exp_pos.
intros N. eapply Rle_trans; [|apply Rmult_le_compat_l; [exact HD|apply (HN N)]].
rewrite <- sum_first_scal. apply sum_first_le. intros n. unfold part_term, Rdiv. rewrite Rabs_mult.
assert (P := pow_le r n ltac:(lra)). assert (Q := Rabs_pos (cubic_term t n)).
replace (Rabs (cubic_term t n) * Rabs (/ (INR n + e)) * r ^ n)
  with (Rabs (/ (INR n + e)) * (Rabs (cubic_term t n) * r ^ n)) by ring.
apply Rmult_le_compat_r; auto. apply Rmult_le_pos; auto.
Qed.

Lemma part_radius e x : (forall n, INR n + e <> 0) -> Rbar_lt (Rabs x) (CV_radius (part_term e)).
Proof.
intros He. assert (A := Rabs_pos x). destruct (part_norm e (Rabs x + 1) He ltac:(lra)) as (M & _ & HM).
apply (radius_at_least _ (Rabs x + 1) M); try lra. exact HM.
Qed.

Lemma part_series e x : (forall n, INR n + e <> 0) -> is_pseries (part_term e) x (PSeries (part_term e) x).
Proof. intros He. apply PSeries_correct, CV_radius_inside, part_radius, He. Qed.

Lemma exp_series x : is_pseries (cubic_term t) x (cubic_exp t x).
Proof. assert (A := Rabs_pos x). apply (cubic_series (Rabs x + 1)); lra. Qed.

(** Its derivative is the integrand. *)
Lemma finite_part_derive e x : (forall n, INR n + e <> 0) -> 0 < x ->
  is_derive (finite_part e) x (kernel (e - 1) t x).
Proof.
intros He Hx. unfold finite_part. set (Q := PSeries (part_term e)). set (Q' := PSeries (PS_derive (part_term e)) x).
assert (E : e * Q x + x * Q' = cubic_exp t x).
{ assert (S0 := part_series e x He).
  assert (S1 := PSeries_correct (PS_derive (part_term e)) x
    (CV_radius_inside _ _ ltac:(rewrite CV_radius_derive; apply part_radius, He))).
  assert (S2 := is_pseries_incr_1 (K := R_AbsRing) (V := R_NormedModule) _ _ _ S1).
  assert (S3 := is_pseries_plus _ _ _ _ _ (is_pseries_scal e _ x _ (Rmult_comm x e) S0) S2).
  apply (is_pseries_ext _ (cubic_term t)) in S3.
  - apply is_pseries_unique in S3. assert (S4 := exp_series x). apply is_pseries_unique in S4. rewrite S3 in S4.
    exact S4.
  - intros [|n]; unfold PS_plus, PS_scal, PS_incr_1, PS_derive, part_term, plus, scal, zero; simpl; unfold mult; simpl.
    + assert (H := He 0%nat). simpl in H. rewrite Rplus_0_l in H. field. exact H.
    + assert (H := He (S n)). change (match n with O => 1 | S _ => INR n + 1 end) with (INR (S n)). field. exact H. }
apply (is_derive_val _ _ (e * (Rpower x e / x) * Q x + Rpower x e * Q')).
- apply (is_derive_mult_R (fun x => Rpower x e) Q).
  + unfold Rpower. auto_derive; auto. unfold Rdiv. ring.
  + apply is_derive_PSeries, part_radius, He.
- unfold kernel. fold (cubic_exp t x). rewrite <- E.
  assert (R : Rpower x e = x * Rpower x (e - 1)) by (rewrite <- Rpower_S by exact Hx; f_equal; ring).
  rewrite R. field. lra.
Qed.

Lemma part_integral e x y : (forall n, INR n + e <> 0) -> 0 < x -> x <= y ->
  M (e - 1) x y t = finite_part e y - finite_part e x.
Proof.
intros He Hx Hy. unfold M. apply (is_RInt_unique (V := R_CompleteNormedModule)).
apply (is_RInt_derive (finite_part e) (kernel (e - 1) t)); intros z Hz; rewrite Rmin_left in Hz by lra.
- apply finite_part_derive; auto; lra.
- apply continuous_kernel. lra.
Qed.

(** For e > 0 it vanishes at 0. *)
Lemma finite_part_small e eps : 0 < e -> 0 < eps -> exists d, 0 < d /\ forall x, 0 < x < d ->
  Rabs (finite_part e x) < eps.
Proof.
intros He Heps. assert (Hn : forall n, INR n + e <> 0) by (intros n; generalize (pos_INR n); lra).
destruct (part_norm e 1 Hn Rlt_0_1) as (B & HB & HM).
assert (Hq : 0 < eps / (B + 1)) by (apply Rdiv_lt_0_compat; lra).
exists (Rmin 1 (Rpower (eps / (B + 1)) (/ e))). split. { apply Rmin_pos. lra. apply exp_pos. }
intros x Hx. assert (X1 := Rmin_l 1 (Rpower (eps / (B + 1)) (/ e))).
assert (X2 := Rmin_r 1 (Rpower (eps / (B + 1)) (/ e))).
assert (Ax : Rabs x = x) by (apply Rabs_pos_eq; lra).
assert (V := series_tail (part_term e) 1 B Rlt_0_1 HM x _ 0 ltac:(lra) (part_series e x Hn)). simpl in V.
rewrite Rminus_0_r, Rmult_1_r in V. unfold finite_part.
assert (P : 0 < Rpower x e) by apply exp_pos.
rewrite Rabs_mult, (Rabs_pos_eq (Rpower x e)) by lra.
assert (S : Rpower x e < eps / (B + 1)).
{ replace (eps / (B + 1)) with (Rpower (Rpower (eps / (B + 1)) (/ e)) e).
  - unfold Rpower at 1 2. apply exp_increasing, Rmult_lt_compat_l; auto. apply ln_increasing; lra.
  - rewrite Rpower_mult, Rinv_l, Rpower_1; lra. }
apply Rle_lt_trans with (Rpower x e * B). apply Rmult_le_compat_l; lra.
apply Rle_lt_trans with (Rpower x e * (B + 1)). apply Rmult_le_compat_l; lra.
apply Rlt_le_trans with (eps / (B + 1) * (B + 1)). apply Rmult_lt_compat_r; lra. right. field. lra.
Qed.

(** The differential equation of the sum, up to a boundary term. *)
Lemma finite_part_equation e x : (forall n, INR n + e <> 0) -> (forall n, INR n + (e + 1) <> 0) ->
  (forall n, INR n + (e + 3) <> 0) -> 0 < x ->
  e * finite_part e x = finite_part (e + 3) x - t * finite_part (e + 1) x + kernel e t x.
Proof.
intros H0 H1 H3 Hx.
assert (S0 := part_series e x H0). assert (S1 := part_series (e + 1) x H1). assert (S3 := part_series (e + 3) x H3).
set (Q0 := PSeries (part_term e) x) in *. set (Q1 := PSeries (part_term (e + 1)) x) in *.
set (Q3 := PSeries (part_term (e + 3)) x) in *.
assert (E : e * Q0 + t * (x * Q1) - x * (x * (x * Q3)) = cubic_exp t x).
{ assert (I1 := is_pseries_incr_1 (K := R_AbsRing) (V := R_NormedModule) _ _ _ S1).
  assert (I3 := is_pseries_incr_1 (K := R_AbsRing) (V := R_NormedModule) _ _ _ S3).
  apply (is_pseries_incr_1 (K := R_AbsRing) (V := R_NormedModule)) in I3.
  apply (is_pseries_incr_1 (K := R_AbsRing) (V := R_NormedModule)) in I3.
  assert (J := is_pseries_minus _ _ _ _ _ (is_pseries_plus _ _ _ _ _ (is_pseries_scal e _ x _ (Rmult_comm x e) S0)
    (is_pseries_scal t _ x _ (Rmult_comm x t) I1)) I3).
  apply (is_pseries_ext _ (cubic_term t)) in J.
  - apply is_pseries_unique in J. assert (S4 := exp_series x). apply is_pseries_unique in S4. rewrite J in S4.
    exact S4.
  - intros n. unfold PS_minus, PS_plus, PS_opp, PS_scal, PS_incr_1, part_term.
    destruct n as [|[|[|n]]]; unfold plus, scal, opp, zero; simpl; unfold mult; simpl.
    + assert (D0 := H0 0%nat). simpl in D0. rewrite Rplus_0_l in D0. field. exact D0.
    + assert (D0 := H0 1%nat). simpl in D0. unfold cubic_term; simpl. field. repeat split; intros K; apply D0; lra.
    + assert (D0 := H0 2%nat). simpl in D0. unfold cubic_term; simpl. field. repeat split; intros K; apply D0; lra.
    + assert (D0 := H0 (S (S (S n)))). assert (D1 := H1 (S (S n))). assert (D3 := H3 n).
      assert (N := cubic_term_next t n). rewrite !S_INR in *.
      change (e * (cubic_term t (S (S (S n))) / (INR (S (S (S n))) + e))
        + t * (cubic_term t (S (S n)) / (INR (S (S n)) + (e + 1))) + - (cubic_term t n / (INR n + (e + 3)))
        = cubic_term t (S (S (S n)))).
      rewrite !S_INR in *.
      replace (INR n + 1 + 1 + (e + 1)) with (INR n + (e + 3)) by ring.
      replace (INR n + 1 + 1 + 1 + e) with (INR n + (e + 3)) by ring.
      apply Rmult_eq_reg_r with (INR n + (e + 3)); auto.
      match goal with |- ?l = _ => replace l with (e * cubic_term t (S (S (S n))) + (t * cubic_term t (S (S n))
        - cubic_term t n)) by (field; exact D3) end.
      rewrite <- N. ring. }
unfold finite_part. fold Q0 Q1 Q3. unfold kernel. fold (cubic_exp t x). rewrite <- E.
replace (e + 3) with (e + 1 + 1 + 1) by ring. rewrite !(Rpower_S _ x Hx). ring.
Qed.
End Exponential.

(** ** Theta *)

Lemma kernel_vanishes s t : is_lim (kernel s t) p_infty 0.
Proof.
apply is_lim_spec. intros eps. assert (He := cond_pos eps).
destruct (kernel_small_right (Rmax s 1) (Rabs t) (eps / 2)) as [m Hm].
{ eapply Rlt_le_trans; [apply Rlt_0_1|apply Rmax_r]. } { apply Rabs_pos. } { lra. }
exists (Rmax 1 m). intros r Hr. assert (R1 := Rmax_l 1 m). assert (R2 := Rmax_r 1 m).
specialize (Hm r ltac:(lra) t (Rle_refl _)). rewrite Rminus_0_r, Rabs_pos_eq by (apply Rlt_le, kernel_pos).
apply Rle_lt_trans with (kernel (Rmax s 1) t r); [|lra]. unfold kernel.
apply Rmult_le_compat_r; [apply Rlt_le, exp_pos|].
apply Rle_Rpower. lra. apply Rmax_l.
Qed.

Section Theta.
Variables (b : R) (theta : R -> R).
Hypothesis Hb : not_nat b.
Hypothesis Htheta : is_Theta b theta.

Let G k t := Gamma (- b) * Derive_n theta k t.

Lemma derivative_equation k t : G (k + 3) t = t * G (k + 1) t + (INR k - b) * G k t.
Proof.
destruct (Theta_Laplace_n b theta k Hb Htheta) as (y1 & y2 & D0 & D1 & D2 & _).
set (y := fun t => Gamma (- b) * Derive_n theta k t) in *.
assert (E : forall j s, Derive_n y j s = G (k + j) s).
{ intros j s. unfold y, G. rewrite Derive_n_scal_l, Derive_n_comp, Nat.add_comm. reflexivity. }
assert (E1 : forall s, Derive_n y 1 s = y1 s) by (intros s; apply (is_derive_unique y), D0).
assert (E2 : forall s, Derive_n y 2 s = y2 s).
{ intros s. change (Derive (Derive_n y 1) s = y2 s). rewrite (Derive_ext _ y1) by exact E1.
  apply is_derive_unique, D1. }
rewrite <- !E. change (Derive (Derive_n y 2) t = t * Derive_n y 1 t + (INR k - b) * G k t).
rewrite (Derive_ext _ y2) by exact E2. rewrite (is_derive_unique _ _ _ (D2 t)), E1. unfold y, G. ring.
Qed.

Lemma no_zero_divisor k n : INR n + (INR k - b) <> 0.
Proof. intros H. apply (Hb (n + k)%nat). rewrite plus_INR. lra. Qed.

Definition finite_part_holds (k : nat) (t x : R) : Prop :=
  is_lim (fun T => M (INR k - b - 1) x T t) p_infty (G k t - finite_part t (INR k - b) x).

(** k > b: the Laplace integral, from which the part over (0, x) is taken away. *)
Lemma finite_part_base k t x : b < INR k -> 0 < x -> finite_part_holds k t x.
Proof.
intros Hk Hx. unfold finite_part_holds.
assert (L := Theta_representation b theta k Hb Hk Htheta t). fold (G k t) in L.
unfold is_RInt_gen in L.
rewrite (filterlimi_locally (F := filter_prod (at_right 0) (Rbar_locally p_infty))) in L.
apply is_lim_spec. intros eps. assert (He := cond_pos eps). assert (He2 : 0 < eps / 2) by lra.
destruct (L (mkposreal _ He2)) as [Q S [e HQ] [m HS] HQS].
destruct (finite_part_small t (INR k - b) (eps / 2) ltac:(lra) He2) as (d & Hd & Hs).
exists (Rmax x m). intros T HT. assert (T1 := Rmax_l x m). assert (T2 := Rmax_r x m). assert (Pe := cond_pos e).
set (a := Rmin (x / 2) (Rmin (e / 2) (d / 2))).
assert (A1 : a <= x / 2) by apply Rmin_l. assert (A2 : a <= Rmin (e / 2) (d / 2)) by apply Rmin_r.
assert (A3 := Rmin_l (e / 2) (d / 2)). assert (A4 := Rmin_r (e / 2) (d / 2)).
assert (A0 : 0 < a) by (repeat apply Rmin_pos; lra).
destruct (HQS a T) as [z [Hz1 Hz2]].
- apply HQ; auto. change (Rabs (a - 0) < e). rewrite Rminus_0_r, Rabs_pos_eq; lra.
- apply HS. lra.
- cbn [fst snd] in Hz1. change (is_RInt (kernel (INR k - b - 1) t) a T z) in Hz1.
  apply (is_RInt_unique (V := R_CompleteNormedModule)) in Hz1.
  change (Rabs (z - G k t) < eps / 2) in Hz2. specialize (Hs a ltac:(lra)).
  assert (X1 : a <= x) by lra. assert (X2 : x <= T) by lra.
  assert (C := RInt_Chasles (kernel (INR k - b - 1) t) a x T (ex_RInt_kernel _ _ _ _ A0 X1)
    (ex_RInt_kernel _ _ _ _ Hx X2)).
  assert (I := part_integral t (INR k - b) a x (no_zero_divisor k) A0 ltac:(lra)). unfold M in I |- *.
  change (RInt (kernel (INR k - b - 1) t) a x + RInt (kernel (INR k - b - 1) t) x T
    = RInt (kernel (INR k - b - 1) t) a T) in C.
  rewrite Hz1, I in C. apply Rabs_def2 in Hz2. apply Rabs_def2 in Hs. apply Rabs_def1; lra.
Qed.

Lemma finite_part_down k t x : 0 < x -> finite_part_holds (k + 1) t x -> finite_part_holds (k + 3) t x ->
  finite_part_holds k t x.
Proof.
intros Hx H1 H3. unfold finite_part_holds in *. set (e := INR k - b) in *.
assert (He : e <> 0). { intros E. apply (Hb k). unfold e in E. lra. }
rewrite !plus_INR in H1, H3. simpl (INR 1) in H1. simpl (INR 3) in H3.
replace (INR k + 1 - b) with (e + 1) in H1 by (unfold e; ring).
replace (INR k + (1 + 1 + 1) - b) with (e + 3) in H3 by (unfold e; ring).
assert (E := derivative_equation k t). fold e in E.
assert (F := finite_part_equation t e x (no_zero_divisor k)
  ltac:(intros n H; apply (no_zero_divisor (k + 1) n); unfold e in H; rewrite plus_INR; simpl; lra)
  ltac:(intros n H; apply (no_zero_divisor (k + 3) n); unfold e in H; rewrite plus_INR; simpl; lra) Hx).
apply (is_lim_ext_loc (fun T => / e * (M (e + 3 - 1) x T t - t * M (e + 1 - 1) x T t - (kernel e t x - kernel e t T)))).
{ exists x. intros T HT. assert (O := M_ode (e - 1) x T t Hx ltac:(lra)).
  replace (e - 1 + 3) with (e + 3 - 1) in O by ring. replace (e - 1 + 1) with e in O by ring.
  replace (e + 1 - 1) with e by ring. rewrite O. field. exact He. }
replace (G k t - finite_part t e x) with (/ e * ((G (k + 3) t - finite_part t (e + 3) x)
  - t * (G (k + 1) t - finite_part t (e + 1) x) - (kernel e t x - 0))).
2: { rewrite E. replace (finite_part t (e + 3) x)
       with (e * finite_part t e x + t * finite_part t (e + 1) x - kernel e t x) by lra. field. exact He. }
apply (is_lim_scal_l _ (/ e) p_infty (Finite _)).
apply is_lim_minus'. apply is_lim_minus'. exact H3. apply (is_lim_scal_l _ t p_infty (Finite _)). exact H1.
apply is_lim_minus'. apply is_lim_const. apply kernel_vanishes.
Qed.

Theorem theta_finite_part k t x : 0 < x -> finite_part_holds k t x.
Proof.
intros Hx.
assert (Hex : exists K : nat, b < INR K).
{ destruct (Rle_lt_dec 0 b) as [H0|H0]; [|exists O; exact H0].
  destruct (nfloor_ex b H0) as [n [_ Hn]]. exists (S n). rewrite S_INR; lra. }
destruct Hex as [K HK].
assert (H : forall d k, (K <= k + d)%nat -> finite_part_holds k t x).
{ induction d as [|d IH]; intros j Hj.
  - apply finite_part_base; auto. apply Rlt_le_trans with (INR K); auto. apply le_INR. lia.
  - apply finite_part_down; auto; apply IH; lia. }
apply (H K). lia.
Qed.
End Theta.

Theorem finite_part_integral : Statement.finite_part_integral.
Proof.
intros b theta k t x Hb Htheta Hx term.
assert (E : forall n, part_term t (INR k - b) n = term n).
{ intros n. unfold part_term, cubic_term, term. rewrite Poly_Pn. reflexivity. }
assert (Hn := no_zero_divisor b Hb k). split.
- eexists. apply (is_pseries_ext (part_term t (INR k - b))); [exact E|]. apply part_series, Hn.
- rewrite <- (PSeries_ext _ _ x E). exact (theta_finite_part b theta Hb Htheta k t x Hx).
Qed.

(** ** All terms but some *)

Definition listed (A : list nat) (f : nat -> R) : R := fold_right Rplus 0 (map f A).

Lemma without_one (a : nat -> R) x s i : is_pseries a x s ->
  is_pseries (fun n => if Nat.eq_dec n i then 0 else a n) x (s - a i * x ^ i).
Proof.
intros H. apply is_pseries_sum_first in H. apply is_pseries_sum_first.
apply (is_lim_seq_ext_loc (fun N => sum_first (fun n => a n * x ^ n) N - a i * x ^ i)).
- exists (S i). intros N HN. replace N with (S i + (N - S i))%nat by lia. generalize (N - S i)%nat as j.
  induction j as [|j IH].
  + rewrite Nat.add_0_r. cbn [sum_first]. destruct (Nat.eq_dec i i) as [_|C]; [|congruence].
    assert (E : forall m, (m <= i)%nat -> sum_first (fun n => (if Nat.eq_dec n i then 0 else a n) * x ^ n) m
      = sum_first (fun n => a n * x ^ n) m).
    { induction m as [|m IHm]; intros Hm; cbn [sum_first]; [reflexivity|]. rewrite IHm by lia.
      destruct (Nat.eq_dec m i); [lia|reflexivity]. }
    rewrite E by lia. ring.
  + rewrite Nat.add_succ_r. cbn [sum_first]. rewrite <- IH. destruct (Nat.eq_dec (S i + j) i); [lia|]. ring.
- apply is_lim_seq_minus'; auto. apply is_lim_seq_const.
Qed.

Lemma without_listed (a : nat -> R) x s A : NoDup A -> is_pseries a x s ->
  is_pseries (fun n => if in_dec Nat.eq_dec n A then 0 else a n) x (s - listed A (fun n => a n * x ^ n)).
Proof.
induction A as [|i A IH]; intros HA H.
- unfold listed. simpl. rewrite Rminus_0_r. exact H.
- inversion HA as [|? ? Hi HA']; subst. specialize (IH HA' H). apply (without_one _ _ _ i) in IH.
  unfold listed in *. cbn [map fold_right].
  destruct (in_dec Nat.eq_dec i A) as [C|_]; [contradiction|].
  replace (s - (a i * x ^ i + fold_right Rplus 0 (map (fun n => a n * x ^ n) A)))
    with (s - fold_right Rplus 0 (map (fun n => a n * x ^ n) A) - a i * x ^ i) by ring.
  apply (is_pseries_ext (fun n => if Nat.eq_dec n i then 0 else if in_dec Nat.eq_dec n A then 0 else a n)); auto.
  intros n. destruct (in_dec Nat.eq_dec n (i :: A)) as [I2|I2], (Nat.eq_dec n i) as [Hn|Hn],
    (in_dec Nat.eq_dec n A) as [I1|I1]; try reflexivity; exfalso; simpl in I2; intuition congruence.
Qed.

(** E_5: what the other terms sum up to. *)
Theorem finite_part_rest t e x A : 0 < x -> NoDup A -> (forall n, INR n + e <> 0) ->
  (forall n, ~ In n A -> 1 / 2 <= Rabs (INR n + e)) ->
  Rabs (finite_part t e x - listed A (fun n => cubic_term t n / (INR n + e) * Rpower x (INR n + e)))
    <= 2 * Rpower x e * exp (Rabs t * x + x ^ 3 / 3).
Proof.
intros Hx HA He Hfar. destruct (cubic_series t x Hx) as [HN _].
assert (S := without_listed (part_term t e) x _ A HA (part_series t e x He)).
set (q := fun n => if in_dec Nat.eq_dec n A then 0 else part_term t e n) in *.
assert (B : forall N, sum_first (fun n => Rabs (q n) * x ^ n) N <= 2 * exp (Rabs t * x + x ^ 3 / 3)).
{ intros N. eapply Rle_trans; [|apply Rmult_le_compat_l; [|apply (HN N)]; lra].
  rewrite <- sum_first_scal. apply sum_first_le. intros n. assert (P := pow_le x n ltac:(lra)).
  assert (C := Rabs_pos (cubic_term t n)). unfold q. destruct (in_dec Nat.eq_dec n A) as [I|I].
  - rewrite Rabs_R0, Rmult_0_l. apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; auto.
  - unfold part_term, Rdiv. rewrite Rabs_mult, Rabs_inv, <- Rmult_assoc. apply Rmult_le_compat_r; auto.
    rewrite (Rmult_comm 2). apply Rmult_le_compat_l; auto. specialize (Hfar n I).
    apply Rle_trans with (/ (1 / 2)); [apply Rinv_le_contravar; lra|lra]. }
assert (Ax : Rabs x <= x) by (rewrite Rabs_pos_eq; lra).
assert (T := series_tail q x _ Hx B x _ 0 Ax S). cbn [sum_first pow] in T. rewrite Rminus_0_r, Rmult_1_r in T.
assert (E : listed A (fun n => cubic_term t n / (INR n + e) * Rpower x (INR n + e))
  = Rpower x e * listed A (fun n => part_term t e n * x ^ n)).
{ clear - Hx. unfold listed. induction A as [|i A IH]; cbn [map fold_right]. ring. rewrite IH, Rmult_plus_distr_l.
  f_equal.
  unfold part_term. rewrite Rpower_plus, Rpower_pow by exact Hx. unfold Rdiv. ring. }
rewrite E. unfold finite_part. rewrite <- Rmult_minus_distr_l, Rabs_mult.
rewrite (Rabs_pos_eq (Rpower x e)) by apply Rlt_le, exp_pos.
rewrite (Rmult_comm 2), Rmult_assoc. apply Rmult_le_compat_l; [apply Rlt_le, exp_pos|exact T].
Qed.
