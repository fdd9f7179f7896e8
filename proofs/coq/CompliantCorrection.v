(** * The force against the force at leading order with the terms of P

    Theorem C at n + 1, at the scale eta = (- a1 eps/2)^(1/3) of the mechanism: the difference of the n-th derivatives
    of the force of a slow motion and of the corrected force is C_1 Gamma(-beta) times a positive number times what
    Theorem C leaves over. So on the side C_1 Gamma(-beta) > 0 signs of the corrected force on [t0, t1], and of its
    derivatives at t1, are signs of the force, and the tail lemma gives contact for ever. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral EnvelopingSeries Family
  Ends CompliantKernel CompliantIntegral
  CompliantSlow CompliantMechanism CompliantZeros CompliantSlowMotion LeftExpansion CompliantMonotone CompliantThreshold
    EtaSeries CompliantPolynomial.
Open Scope R_scope.

Section Corrected.
Variables (b : R) (theta : R -> R) (eta : R) (M : nat) (K : nat -> nat).
Hypothesis Hb : not_nat b.
Hypothesis HT : is_Theta b theta.

Lemma theta_is_derive n t : is_derive (Derive_n theta n) t (Derive_n theta (S n) t).
Proof.
assert (Hg := not_nat_Gamma b Hb).
apply (is_derive_ext (fun t => / Gamma (- b) * scaled b theta n t)).
{ intros u. change (/ Gamma (- b) * (Gamma (- b) * Derive_n theta n u) = Derive_n theta n u). field. exact Hg. }
eapply is_derive_val; [apply (is_derive_scal (scaled b theta n)), scaled_derive; auto|].
unfold scaled. match goal with |- ?a = ?d => change (@eq R a d) end. field. exact Hg.
Qed.

(** The derivative of order j of Theta + P *)
Definition corrected_derivative (j : nat) (t : R) : R := polynomial_series eta M K (fun i => Derive_n theta (j + i) t).

Lemma corrected_derive j t : is_derive (corrected_derivative j) t (corrected_derivative (S j) t).
Proof.
apply (sum_first_derive (fun m t => sum_first (fun k => series_coefficient k m * eta ^ k * Derive_n theta
  (j + (k + 3 * m)) t) (S (K m)))
  (fun m => sum_first (fun k => series_coefficient k m * eta ^ k * Derive_n theta (S j + (k + 3 * m)) t) (S (K m)))).
  intros m.
apply (sum_first_derive (fun k t => series_coefficient k m * eta ^ k * Derive_n theta (j + (k + 3 * m)) t)
  (fun k => series_coefficient k m * eta ^ k * Derive_n theta (S j + (k + 3 * m)) t)). intros k.
apply (is_derive_scal (Derive_n theta (j + (k + 3 * m)))), theta_is_derive.
Qed.

Lemma corrected_theta_0 t : corrected_theta eta M K theta t = corrected_derivative 0 t.
Proof.
unfold corrected_theta, corrected_derivative, polynomial_series.
rewrite (sum_first_head _ M), (sum_first_head _ (K 0%nat)).
rewrite (sum_first_zero (fun k => series_coefficient (S k) 0 * _ * _)).
- change (series_coefficient 0 0) with 1. simpl pow. change (Derive_n theta (0 + (0 + 3 * 0)) t) with (theta t).
  cbv zeta. 
  change (fun i => sum_first (fun k => series_coefficient k (S i) * eta ^ k * Derive_n theta (0 + (k + 3 * S i)) t)
    (S (K (S i))))
    with (fun i => sum_first (fun k => series_coefficient k (S i) * eta ^ k * Derive_n theta (k + 3 * S i) t)
      (S (K (S i)))). ring.
- intros k. rewrite coefficient_0. ring.
Qed.

Lemma excess_of_corrected n t : polynomial_excess M K b theta eta n t = scaled_J eta (- b - 1) n t - Gamma
  (- b) * corrected_derivative n t.
Proof.
unfold polynomial_excess, corrected_derivative, polynomial_series. f_equal. rewrite <- sum_first_scal.
apply sum_first_ext. intros m.
rewrite <- sum_first_scal. apply sum_first_ext. intros k. unfold scaled. ring.
Qed.
End Corrected.

Section Force.
Variables (a1 a2 a3 eps C1 : R) (theta P B Y V Z : R -> R) (M : nat) (K : nat -> nat).
Hypothesis Hpar : parameters a1 a3 eps.
Hypothesis HT : is_Theta (a3 / a1) theta.
Hypothesis HS : slow_motion a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) P B Y V Z.
Let H1 : a1 < 0 := proj1 Hpar.
Let H3 : a3 < 0 := proj1 (proj2 Hpar).
Let He : 0 < eps := proj1 (proj2 (proj2 Hpar)).
Let Hb : not_nat (a3 / a1) := proj2 (proj2 (proj2 Hpar)).
Let beta := a3 / a1.
Let G := Gamma (- beta).
Let eta := eta_of a1 eps.
Let Hn : 0 < eta := eta_of_pos a1 eps.
Let factor : R := Rpower eps beta / (- a3 * eps) * Rpower eta (1 - beta).
Let corrected := corrected_force a1 a2 a3 eps C1 M K theta.
Let force t := linear_force eps (Y t) (Z t).

Lemma factor_pos : 0 < factor.
Proof.
unfold factor. apply Rmult_lt_0_compat; [|apply exp_pos]. apply Rdiv_lt_0_compat; [apply exp_pos|].
apply Rmult_lt_0_compat; lra.
Qed.

Definition corrected_force_derivative (k : nat) (t : R) : R :=
  match k with O => a2 / (a3 - a1) | S _ => 0 end
    + factor * C1 * (eta / eps) ^ k * corrected_derivative theta eta M K (S k) (eta * (t / eps)).

Lemma corrected_force_derive k t : is_derive (corrected_force_derivative k) t (corrected_force_derivative (S k) t).
Proof.
unfold corrected_force_derivative. set (c := match k with O => a2 / (a3 - a1) | S _ => 0 end).
set (q := factor * C1 * (eta / eps) ^ k).
apply (is_derive_val _ _ (0 + q * (eta / eps * corrected_derivative theta eta M K (S (S k)) (eta * (t / eps)))));
  [|unfold q; simpl pow; ring].
apply (is_derive_plus (fun _ => c) (fun t => q * corrected_derivative theta eta M K (S k) (eta * (t / eps)))).
apply (is_derive_const c).
apply (is_derive_scal (fun t => corrected_derivative theta eta M K (S k) (eta * (t / eps)))).
apply (is_derive_comp (corrected_derivative theta eta M K (S k)) (fun t => eta * (t / eps))).
- apply (corrected_derive beta); auto.
- auto_derive; auto. field. lra.
Qed.

Lemma corrected_force_0 t : corrected t = corrected_force_derivative 0 t.
Proof.
unfold corrected, corrected_force, leading_force, corrected_force_derivative.
change (Rpower (- a1 / 2) (1 / 3) * Rpower eps (1 / 3)) with eta. rewrite <- (eta_of_time a1 eps He t). fold eta.
rewrite (Derive_ext _ (corrected_derivative theta eta M K 0)) by (intros; apply corrected_theta_0).
rewrite (is_derive_unique _ _ _ (corrected_derive beta theta eta M K Hb HT 0 (eta * (t / eps)))).
assert (E := eta_of_factor a1 eps He C1 a3 beta ltac:(lra)). fold eta in E. fold beta.
set (D := corrected_derivative theta eta M K 1 (eta * (t / eps))).
replace (factor * C1 * (eta / eps) ^ 0) with (C1 * Rpower eps beta / (- a3 * eps) * Rpower eta (1 - beta))
  by (unfold factor; simpl pow; field; lra).
rewrite E. ring.
Qed.

Lemma corrected_force_derive_n n t : Derive_n corrected n t = corrected_force_derivative n t.
Proof.
rewrite (Derive_n_ext _ (corrected_force_derivative 0)) by apply corrected_force_0.
revert t. induction n as [|n IH]; intros t; [reflexivity|].
change (Derive (Derive_n (corrected_force_derivative 0) n) t = corrected_force_derivative (S n) t).
rewrite (Derive_ext _ (corrected_force_derivative n)) by exact IH. apply is_derive_unique, corrected_force_derive.
Qed.

Lemma force_derivative n t : Derive_n force n t
  = match n with O => a2 / (a3 - a1) | S _ => 0 end + factor * C1 * (eta / eps) ^ n * (scaled_J eta (- beta - 1) (S n)
    (eta * (t / eps)) / G).
Proof.
unfold force. rewrite (slow_force_derive a1 a2 a3 eps Hpar _ P B Y V Z HS n t).
assert (Hg : G <> 0) by (apply not_nat_Gamma, Hb).
rewrite <- (scaled_slow beta (S n) eta (eta * (t / eps)) Hn Hb). fold G.
replace (2 * eta ^ 3) with (- a1 * eps) by (symmetry; exact (eta_of_cube a1 eps H1 He)).
replace (eta * (t / eps) / eta) with (t / eps) by (field; split; lra).
set (F := Derive_n (Fe (- a1 * eps) beta) (S n) (t / eps)).
assert (X : dl a1 a2 a3 eps (C1 * Rpower eps (a3 / a1)) n t = match n with O => a2 / (a3 - a1) | S _ =>
  0 end + C1 * Rpower eps beta / (- a3) * F / eps ^ S n).
{ unfold dl, F, beta, sol_l. set (mean := a2 / (a3 - a1)). destruct n as [|n].
  - change (Derive_n (Fe (- a1 * eps) (a3 / a1)) 1 (t / eps)) with (Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps)).
    simpl pow. set (b := a3 / a1). field. split; lra.
  - unfold hb. set (b := a3 / a1). assert (eps ^ S (S n) <> 0) by (apply pow_nonzero; lra). field. split; auto; lra. }
rewrite X. f_equal. unfold factor.
replace (beta - INR (S n)) with (- (1 - beta) + - INR n) by (rewrite S_INR; ring).
rewrite Rpower_plus, !Rpower_Ropp, Rpower_pow by auto.
assert (Q : (eta / eps) ^ n = eta ^ n * / eps ^ n) by (unfold Rdiv; rewrite Rpow_mult_distr, pow_inv; reflexivity).
rewrite Q. simpl pow.
assert (Rpower eta (1 - beta) <> 0) by (apply Rgt_not_eq, exp_pos). assert (eta ^ n <> 0) by (apply pow_nonzero; lra).
assert (eps ^ n <> 0) by (apply pow_nonzero; lra).
field. repeat split; auto; lra.
Qed.

Theorem force_above_corrected_force n t : enough_terms beta n M K ->
  (0 < C1 * G -> Derive_n corrected n t < Derive_n force n t) /\
    (C1 * G < 0 -> Derive_n force n t < Derive_n corrected n t).
Proof.
intros [E1 E2].
assert (Hg : G <> 0) by (apply not_nat_Gamma, Hb).
assert (X : 0 < polynomial_excess M K beta theta eta (S n) (eta * (t / eps))).
{ apply polynomial_excess_positive; auto.
  - intros m Hm. apply E2, Hm.
  - rewrite !S_INR. lra.
  - intros m Hm. destruct (E2 m Hm) as [_ A]. rewrite S_INR. lra. }
rewrite excess_of_corrected in X. fold G in X.
assert (D : Derive_n force n t - Derive_n corrected n t = C1 * G * (factor * (eta / eps) ^ n * (/ G) ^ 2
  * (scaled_J eta (- beta - 1) (S n) (eta * (t / eps)) - G * corrected_derivative theta eta M K (S n)
      (eta * (t / eps))))).
{ rewrite force_derivative, corrected_force_derive_n. unfold corrected_force_derivative.
  set (c := match n with O => a2 / (a3 - a1) | S _ => 0 end). set (w := (eta / eps) ^ n). field. exact Hg. }
assert (Q : 0 < factor * (eta / eps) ^ n * (/ G) ^ 2
  * (scaled_J eta (- beta - 1) (S n) (eta * (t / eps)) - G * corrected_derivative theta eta M K (S n)
      (eta * (t / eps)))).
{ apply Rmult_lt_0_compat; auto. apply Rmult_lt_0_compat; [|apply pow2_gt_0, Rinv_neq_0_compat, Hg].
  apply Rmult_lt_0_compat; [apply factor_pos|]. apply pow_lt, Rdiv_lt_0_compat; auto. }
set (q := factor * _ * _ * _) in D, Q. split; intros HC.
- assert (0 < C1 * G * q) by (apply Rmult_lt_0_compat; auto). lra.
- assert (0 < - (C1 * G) * q) by (apply Rmult_lt_0_compat; auto; lra). lra.
Qed.

(** More derivatives need no more terms. *)
Lemma enough_terms_more n : enough_terms beta 0 M K -> enough_terms beta n M K.
Proof.
intros [E1 E2]. assert (A := pos_INR n). simpl in E1. split; [lra|]. intros m Hm. destruct (E2 m Hm) as [O E].
simpl (INR 0) in E. split; [exact O|lra].
Qed.

Theorem IWC_by_corrected_force n t0 t1 p b y v z : beta < INR n + 2 -> enough_terms beta 0 M K -> 0 < C1 * G ->
  t0 <= t1 ->
  (forall t, t0 <= t <= t1 -> 0 <= corrected t) -> (forall k, (k <= n)%nat -> 0 <= Derive_n corrected k t1) ->
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  p t0 = P t0 -> b t0 = B t0 -> y t0 = Y t0 -> v t0 = V t0 -> z t0 = Z t0 ->
  (forall t, t0 <= t -> y t < z t) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).
Proof.
intros Hbeta HE HC H01 Hc Hd.
apply (contact_kept a1 a2 a3 eps C1 P B Y V Z Hpar HS t0 HC).
intros t Ht. destruct (Rle_lt_dec t t1) as [Hl|Hl].
- assert (A := proj1 (force_above_corrected_force 0 t HE) HC). simpl in A. specialize (Hc t ltac:(lra)).
  unfold force in A. lra.
- apply linear_force_pos; auto. apply (contact_tail a1 a2 a3 eps Hpar _ P B Y V Z HS n t1); auto.
  + rewrite plus_INR. simpl (INR 2). fold beta. lra.
  + fold beta G. replace (C1 * Rpower eps beta * G) with (Rpower eps beta * (C1 * G)) by ring.
    apply Rmult_lt_0_compat; auto. apply exp_pos.
  + intros k Hk. assert (A := proj1 (force_above_corrected_force k t1 (enough_terms_more k HE)) HC).
    specialize (Hd k Hk). unfold force in A. lra.
Qed.
End Force.
