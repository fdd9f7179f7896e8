(** * The series of e^h in eta, and its remainder

    The weight of the compliant model is e^(-r^3/3) e^h with (1 + eta r) h' = eta r^3/2, ' = d/dr, h(0) = 0. Hence the
    coefficients c_(k,m) of e^h = sum eta^k c_(k,m) r^(k+3m) have the recurrence of two terms of [series_coefficient].
    Let P be the part k < N, q its next term: then (1 + eta r)(P' - h' P) = - eta^N q' exactly, so (e^-h (e^h - P))' =
    e^-h eta^N q'/(1 + eta r) is at most eta^N sum |c_(N,m)| (N + 3m) r^(N+3m-1), and |e^h - P| <= eta^N sum |c_(N,m)|
    r^(N+3m) e^h. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus ImproperIntegral EnvelopingSeries CompliantKernel
  LeftExpansion CompliantMonotone.
Open Scope R_scope.

Definition eta_series (eta : R) (N : nat) (x : nat -> R) : R :=
  sum_first (fun k => eta ^ k * sum_first (fun m => series_coefficient k m * x (k + 3 * m)%nat) (S k)) N.

(** ** Sums *)

Lemma sum_first_plus a d n : sum_first (fun k => a k + d k) n = sum_first a n + sum_first d n.
Proof. induction n as [|n IH]; simpl; [ring|rewrite IH; ring]. Qed.

Lemma sum_first_head a n : sum_first a (S n) = a 0%nat + sum_first (fun k => a (S k)) n.
Proof. induction n as [|n IH]; [simpl; ring|]. change (sum_first a (S (S n))) with (sum_first a (S n) + a (S n)).
rewrite IH. simpl. ring. Qed.

Lemma sum_first_ext_below a d n : (forall k, (k < n)%nat -> a k = d k) -> sum_first a n = sum_first d n.
Proof. induction n as [|n IH]; intros H; simpl; auto. rewrite IH, H by auto. reflexivity. Qed.

Lemma sum_first_abs a n : Rabs (sum_first a n) <= sum_first (fun k => Rabs (a k)) n.
Proof. induction n as [|n IH]; simpl. rewrite Rabs_R0; lra. eapply Rle_trans; [apply Rabs_triang|lra]. Qed.

Lemma sum_first_nonnegative a n : (forall k, 0 <= a k) -> 0 <= sum_first a n.
Proof. intros H. induction n as [|n IH]; simpl. lra. assert (A := H n). lra. Qed.

Lemma sum_first_derive (a : nat -> R -> R) (d : nat -> R) n t : (forall k, is_derive (a k) t (d k)) ->
  is_derive (fun t => sum_first (fun k => a k t) n) t (sum_first d n).
Proof.
intros H. induction n as [|n IH]; simpl. apply (is_derive_const 0).
apply (is_derive_plus (fun t => sum_first (fun k => a k t) n) (a n)); auto.
Qed.

Lemma sum_first_integral (a : nat -> R -> R) (l : nat -> R) n :
  (forall k, is_RInt_gen (a k) (at_right 0) (Rbar_locally p_infty) (l k)) ->
  is_RInt_gen (fun r => sum_first (fun k => a k r) n) (at_right 0) (Rbar_locally p_infty) (sum_first l n).
Proof.
intros H. induction n as [|n IH].
- assert (Z := is_RInt_gen_scal _ 0 _ (H 0%nat)). simpl.
  replace 0 with (scal 0 (l 0%nat)) at 2 by (unfold scal; simpl; unfold mult; simpl; ring).
  eapply improper_ext; [|exact Z]. intros r _. unfold scal; simpl; unfold mult; simpl. ring.
- exact (is_RInt_gen_plus _ _ _ _ IH (H n)).
Qed.

Lemma sum_first_small q (a : nat -> R -> R) n : (forall k, (k < n)%nat -> small q (a k)) ->
  small q (fun x => sum_first (fun k => a k x) n).
Proof.
intros H. induction n as [|n IH]; simpl.
- exists 0. intros x _. rewrite Rabs_R0. lra.
- apply small_plus; [apply IH; intros; apply H; lia|apply H; lia].
Qed.

(** ** The coefficients *)

Lemma coefficient_0 k : series_coefficient (S k) 0 = 0.
Proof. reflexivity. Qed.

Lemma coefficient_next k m : (INR (S k) + 3 * INR (S m)) * series_coefficient (S k) (S m)
  = series_coefficient k m / 2 - (INR k + 3 * INR (S m)) * series_coefficient k (S m).
Proof.
change (series_coefficient (S k) (S m)) with
  ((series_coefficient k m / 2 - (INR k + 3 * INR (S m)) * series_coefficient k (S m)) / (INR (S k) + 3 * INR (S m))).
field. assert (0 < INR (S k)) by (apply lt_0_INR; lia). assert (0 < INR (S m)) by (apply lt_0_INR; lia). lra.
Qed.

Lemma coefficient_beyond k : forall m, (k < m)%nat -> series_coefficient k m = 0.
Proof.
induction k as [|k IH]; intros [|m] Hm; try lia; [reflexivity|].
change (series_coefficient (S k) (S m)) with
  ((series_coefficient k m / 2 - (INR k + 3 * INR (S m)) * series_coefficient k (S m)) / (INR (S k) + 3 * INR (S m))).
rewrite !IH by lia. unfold Rdiv. ring.
Qed.

Lemma coefficient_sign k : forall m, 0 <= (-1) ^ (k + m) * series_coefficient k m.
Proof.
induction k as [|k IH]; intros [|m]; try (simpl; lra).
assert (P : 0 < INR (S k) + 3 * INR (S m)).
{ assert (0 < INR (S k)) by (apply lt_0_INR; lia). assert (0 < INR (S m)) by (apply lt_0_INR; lia). lra. }
apply (Rmult_le_reg_l (INR (S k) + 3 * INR (S m))); auto. rewrite Rmult_0_r.
replace ((INR (S k) + 3 * INR (S m)) * ((-1) ^ (S k + S m) * series_coefficient (S k) (S m)))
  with ((-1) ^ (S k + S m) * ((INR (S k) + 3 * INR (S m)) * series_coefficient (S k) (S m))) by ring.
rewrite coefficient_next.
assert (A := IH m). assert (B := IH (S m)). assert (Q := pos_INR k). assert (Q' := pos_INR (S m)).
replace ((-1) ^ (S k + S m)) with ((-1) ^ (k + m)) by (replace (S k + S m)%nat with (S (S (k + m))) by lia; simpl;
  ring).
replace ((-1) ^ (k + S m)) with (- (-1) ^ (k + m)) in B by (replace (k + S m)%nat with (S (k + m)) by lia; simpl; ring).
assert (C : 0 <= (INR k + 3 * INR (S m)) * (- (-1) ^ (k + m) * series_coefficient k (S m)))
  by (apply Rmult_le_pos; lra). lra.
Qed.

Arguments series_coefficient : simpl never.

(** ** What the part k < N leaves over, with any numbers x_i in place of r^i *)

Definition operator (eta : R) (x : nat -> R) (i : nat) : R := INR i * (x i + eta * x (i + 1)%nat) - eta / 2 * x
  (i + 4)%nat.

Lemma eta_series_next eta N x : eta_series eta (S N) x
  = eta_series eta N x + eta ^ N * sum_first (fun m => series_coefficient N m * x (N + 3 * m)%nat) (S N).
Proof. reflexivity. Qed.

Lemma series_operator eta N x : eta_series eta N (operator eta x)
  = - (eta ^ N * sum_first (fun m => series_coefficient N m * (INR (N + 3 * m) * x (N + 3 * m)%nat)) (S N)).
Proof.
induction N as [|N IH].
- unfold eta_series. simpl. ring.
- rewrite eta_series_next, IH. clear IH.
  rewrite (sum_first_head _ (S N)), coefficient_0.
  set (u := fun m => INR (N + 3 * m) * series_coefficient N m * x (N + 3 * m + 1)%nat).
  assert (U : sum_first u (S N) = sum_first (fun m => u (S m)) (S N)).
  { assert (A := sum_first_head u (S N)). simpl (sum_first u (S (S N))) in A.
    assert (U0 : u 0%nat = 0).
    { unfold u. destruct N as [|N]; [simpl; ring|rewrite coefficient_0; ring]. }
    assert (U1 : u (S N) = 0) by (unfold u; rewrite coefficient_beyond by lia; ring). simpl in A |- *. lra. }
  set (d := fun m => INR (S N + 3 * S m) * series_coefficient (S N) (S m) * x (S N + 3 * S m)%nat).
  assert (E1 : sum_first (fun m => series_coefficient N m * operator eta x (N + 3 * m)) (S N)
    = sum_first (fun m => series_coefficient N m * (INR (N + 3 * m) * x (N + 3 * m)%nat)) (S N)
      + eta * (sum_first u (S N) + - / 2 * sum_first (fun m => series_coefficient N m * x (N + 3 * m + 4)%nat) (S N))).
  { rewrite <- (sum_first_scal (- / 2)), <- sum_first_plus, <- sum_first_scal, <- sum_first_plus. apply sum_first_ext.
    intros m. unfold operator, u. field. }
  assert (E2 : sum_first (fun m => series_coefficient (S N) (S m) * (INR (S N + 3 * S m) * x (S N + 3 * S m)%nat)) (S N)
    = - sum_first (fun m => u (S m)) (S N) + / 2 * sum_first (fun m => series_coefficient N m * x (N + 3 * m + 4)%nat)
      (S N)).
  { replace (- sum_first (fun m => u (S m)) (S N)) with (-1 * sum_first (fun m => u (S m)) (S N)) by ring.
    rewrite <- !sum_first_scal, <- sum_first_plus. apply sum_first_ext. intros m. unfold u.
    replace (S N + 3 * S m)%nat with (N + 3 * m + 4)%nat by lia.
    replace (N + 3 * S m + 1)%nat with (N + 3 * m + 4)%nat by lia.
    assert (C := coefficient_next N m).
    replace (INR (N + 3 * m + 4)) with (INR (S N) + 3 * INR (S m)) by (rewrite !S_INR, !plus_INR, mult_INR; simpl;
      ring).
    replace (INR (N + 3 * S m)) with (INR N + 3 * INR (S m)) by (rewrite plus_INR, mult_INR; simpl; ring).
    transitivity ((INR (S N) + 3 * INR (S m)) * series_coefficient (S N) (S m) * x (N + 3 * m + 4)%nat); [ring|].
    rewrite C. field. }
  rewrite E1, E2, U. simpl pow. ring.
Qed.

(** ** Derivatives and values at 0 *)

Definition power_derive (r : R) (i : nat) : R := INR i * r ^ pred i.

Lemma power_is_derive r i : is_derive (fun r => r ^ i) r (power_derive r i).
Proof. unfold power_derive. auto_derive; auto. ring. Qed.

Lemma times_power_derive r i : r * power_derive r i = INR i * r ^ i.
Proof. unfold power_derive. destruct i as [|i]; simpl; ring. Qed.

Lemma series_derive eta N (x : nat -> R -> R) (d : nat -> R) t : (forall i, is_derive (x i) t (d i)) ->
  is_derive (fun t => eta_series eta N (fun i => x i t)) t (eta_series eta N d).
Proof.
intros H. unfold eta_series.
apply (sum_first_derive (fun k t => eta ^ k * sum_first (fun m => series_coefficient k m * x (k + 3 * m)%nat t) (S k))
  (fun k => eta ^ k * sum_first (fun m => series_coefficient k m * d (k + 3 * m)%nat) (S k))). intros k.
apply (is_derive_scal (fun t => sum_first (fun m => series_coefficient k m * x (k + 3 * m)%nat t) (S k))).
apply (sum_first_derive (fun m t => series_coefficient k m * x (k + 3 * m)%nat t) (fun m =>
  series_coefficient k m * d (k + 3 * m)%nat)).
intros m. apply (is_derive_scal (x (k + 3 * m)%nat)), H.
Qed.

Lemma series_ext eta N x y : (forall i, x i = y i) -> eta_series eta N x = eta_series eta N y.
Proof. intros H. apply sum_first_ext. intros k. f_equal. apply sum_first_ext. intros m. rewrite H. reflexivity. Qed.

Lemma series_scal eta N q x : eta_series eta N (fun i => q * x i) = q * eta_series eta N x.
Proof.
unfold eta_series. rewrite <- sum_first_scal. apply sum_first_ext. intros k.
rewrite (sum_first_ext _ (fun m => q * (series_coefficient k m * x (k + 3 * m)%nat))) by (intros; ring).
rewrite sum_first_scal. ring.
Qed.

Lemma series_plus eta N x y : eta_series eta N (fun i => x i + y i) = eta_series eta N x + eta_series eta N y.
Proof.
unfold eta_series. rewrite <- sum_first_plus. apply sum_first_ext. intros k.
rewrite <- Rmult_plus_distr_l, <- sum_first_plus. f_equal.
apply sum_first_ext. intros; ring.
Qed.

Lemma sum_first_zero a n : (forall k, a k = 0) -> sum_first a n = 0.
Proof. intros H. induction n as [|n IH]; simpl; [reflexivity|rewrite IH, H; ring]. Qed.

Lemma series_at_0 eta N : eta_series eta (S N) (fun i => 0 ^ i) = 1.
Proof.
unfold eta_series. rewrite sum_first_head, (sum_first_zero (fun k => eta ^ S k * _)).
- unfold series_coefficient. simpl. ring.
- intros k. rewrite sum_first_zero; [ring|]. intros m. simpl pow. ring.
Qed.

(** ** The remainder *)

Lemma nonnegative_of_derive (f df : R -> R) (a b : R) : a <= b -> (forall x, a <= x <= b -> is_derive f x (df x)) ->
  (forall x, a < x < b -> 0 <= df x) -> 0 <= f a -> 0 <= f b.
Proof.
intros Hab D H H0. destruct (Rle_lt_or_eq_dec _ _ Hab) as [Hl|<-]; auto.
destruct (mvt_open f df a b Hl D) as (c & Hc & E). specialize (H c Hc).
assert (0 <= df c * (b - a)) by (apply Rmult_le_pos; lra). lra.
Qed.

Definition exponent (eta r : R) : R := weight_exponent eta r + r ^ 3 / 3.

Lemma exponent_derive eta r : 0 < eta -> 0 <= r -> is_derive (exponent eta) r (eta * r ^ 3 / (2 * (1 + eta * r))).
Proof.
intros He Hr. assert (0 <= eta * r) by (apply Rmult_le_pos; lra).
unfold exponent, weight_exponent, psi. auto_derive. repeat split; lra. field. split; lra.
Qed.

Lemma exponent_0 eta : 0 < eta -> exponent eta 0 = 0.
Proof. intros He. unfold exponent, weight_exponent. rewrite Rmult_0_r, psi_0. field. lra. Qed.

Lemma exponent_bounds eta r : 0 < eta -> 0 < r -> 0 < exponent eta r <= eta * r ^ 4 / 8.
Proof. intros He Hr. destruct (weight_bounds eta r He Hr) as (B1 & B2 & B3). unfold exponent. lra. Qed.

Definition remainder_bound (eta : R) (N : nat) (x : nat -> R) : R :=
  eta ^ N * sum_first (fun m => Rabs (series_coefficient N m) * x (N + 3 * m)%nat) (S N).

(** Plan: f = 1 - e^(-h) P, P the partial sum, h the exponent, is 0 at 0. By [series_operator] nearly all terms of f'
    cancel: |f'| is at most the derivative of the bound S0 (B). So |f| <= S0 up to r, and e^h f is what is to be
    bounded. *)
Theorem series_remainder eta N r : (1 <= N)%nat -> 0 < eta -> 0 < r ->
  Rabs (exp (exponent eta r) - eta_series eta N (fun i => r ^ i)) <= remainder_bound eta N (fun i =>
    r ^ i * exp (exponent eta r)).
Proof.
intros HN He Hr.
set (P := fun r => eta_series eta N (fun i => r ^ i)). set (S0 := fun r => remainder_bound eta N (fun i => r ^ i)).
set (P' := fun r => eta_series eta N (power_derive r)). set (S' := fun r => remainder_bound eta N (power_derive r)).
assert (DP : forall x, is_derive P x (P' x)) by (intros x; apply series_derive; intros i; apply power_is_derive).
assert (DS : forall x, is_derive S0 x (S' x)).
{ intros x. apply (is_derive_scal (fun x => sum_first (fun m => Rabs (series_coefficient N m) * x ^ (N + 3 * m))
    (S N))).
  apply (sum_first_derive (fun m x => Rabs (series_coefficient N m) * x ^ (N + 3 * m)) (fun m =>
    Rabs (series_coefficient N m) * power_derive x (N + 3 * m))).
  intros m. apply (is_derive_scal (fun x => x ^ (N + 3 * m))), power_is_derive. }
set (f := fun x => 1 - exp (- exponent eta x) * P x).
set (f' := fun x => exp (- exponent eta x) * (eta * x ^ 3 / (2 * (1 + eta * x)) * P x - P' x)).
assert (Df : forall x, 0 <= x -> is_derive f x (f' x)).
{ intros x Hx. assert (DE := exponent_derive eta x He Hx). set (d := eta * x ^ 3 / (2 * (1 + eta * x))) in *.
  apply (is_derive_val _ _ (0 - (- d * exp (- exponent eta x) * P x + exp (- exponent eta x) * P' x)));
    [|unfold f'; fold d; ring].
  apply (is_derive_minus (fun _ => 1) (fun x => exp (- exponent eta x) * P x)). apply (is_derive_const 1).
  apply (is_derive_mult_R (fun x => exp (- exponent eta x)) P); [|apply DP].
  apply (is_derive_comp exp (fun x => - exponent eta x)). apply is_derive_exp.
  apply (is_derive_opp (exponent eta)), DE. }
assert (B : forall x, 0 < x -> Rabs (f' x) <= S' x).
{ intros x Hx. assert (X : 0 < eta * x) by (apply Rmult_lt_0_compat; auto).
  assert (O := series_operator eta N (fun i => x ^ i)).
  assert (EO : eta_series eta N (operator eta (fun i => x ^ i)) = x * (1 + eta * x) * P' x + - (eta * x ^ 4 / 2) * P x).
  { unfold P, P'. rewrite <- !series_scal, <- series_plus. apply series_ext. intros i. unfold operator.
    rewrite Rmult_assoc, (Rmult_comm (1 + eta * x)), <- Rmult_assoc, times_power_derive, !pow_add. simpl. field. }
  rewrite EO in O. clear EO.
  assert (F : x * (eta * x ^ 3 / (2 * (1 + eta * x)) * P x - P' x)
    = / (1 + eta * x) * (eta ^ N * sum_first (fun m => series_coefficient N m * (INR (N + 3 * m) * x ^ (N + 3 * m)))
      (S N))).
  { apply (Rmult_eq_reg_l (1 + eta * x)); [|lra].
    rewrite <- Rmult_assoc, <- (Rmult_assoc (1 + eta * x) (/ _)), Rinv_r, Rmult_1_l by lra.
    replace ((1 + eta * x) * x * (eta * x ^ 3 / (2 * (1 + eta * x)) * P x - P' x))
      with (- (x * (1 + eta * x) * P' x + - (eta * x ^ 4 / 2) * P x)) by (field; lra). rewrite O. ring. }
  assert (T : Rabs (eta ^ N * sum_first (fun m => series_coefficient N m * (INR (N + 3 * m) * x ^ (N + 3 * m))) (S N))
    <= x * S' x).
  { unfold S', remainder_bound. rewrite Rabs_mult, (Rabs_pos_eq (eta ^ N)) by (apply pow_le; lra).
    rewrite <- Rmult_assoc, (Rmult_comm x), Rmult_assoc. apply Rmult_le_compat_l; [apply pow_le; lra|].
    eapply Rle_trans; [apply sum_first_abs|]. rewrite <- sum_first_scal. right. apply sum_first_ext. intros m.
    rewrite Rabs_mult, (Rabs_pos_eq (INR _ * _)) by (apply Rmult_le_pos; [apply pos_INR|apply pow_le; lra]).
    rewrite <- times_power_derive. ring. }
  apply (Rmult_le_reg_l x); auto.
  assert (E1 : exp (- exponent eta x) <= 1) by (rewrite <- exp_0; apply exp_le; destruct (exponent_bounds eta x He Hx);
    lra).
  assert (E0 := exp_pos (- exponent eta x)).
  assert (I : 0 < / (1 + eta * x) <= 1). { split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1 at 2.
  apply Rinv_le_contravar; lra. }
  unfold f'. rewrite Rabs_mult, (Rabs_pos_eq (exp _)) by lra.
  set (w := eta * x ^ 3 / (2 * (1 + eta * x)) * P x - P' x) in *.
  assert (W : x * Rabs w <= x * S' x).
  { rewrite <- (Rabs_pos_eq x) at 1 by lra. rewrite <- Rabs_mult, F, Rabs_mult, (Rabs_pos_eq (/ _)) by lra.
    eapply Rle_trans; [|exact T]. rewrite <- (Rmult_1_l (Rabs _)) at 2. apply Rmult_le_compat_r; [apply Rabs_pos|lra]. }
  eapply Rle_trans; [|exact W].
  replace (x * (exp (- exponent eta x) * Rabs w)) with (exp (- exponent eta x) * (x * Rabs w)) by ring.
  rewrite <- (Rmult_1_l (x * Rabs w)) at 2. apply Rmult_le_compat_r; [|exact E1].
  apply Rmult_le_pos; [lra|apply Rabs_pos]. }
assert (f0 : f 0 = 0).
{ unfold f, P. rewrite exponent_0, Ropp_0, exp_0 by auto. destruct N as [|N]; [lia|]. rewrite series_at_0. ring. }
assert (S00 : 0 <= S0 0).
{ apply Rmult_le_pos. apply pow_le; lra. apply sum_first_nonnegative. intros m. apply Rmult_le_pos. apply Rabs_pos.
  apply pow_le; lra. }
assert (R1 : 0 <= S0 r - f r).
{ apply (nonnegative_of_derive (fun x => S0 x - f x) (fun x => S' x - f' x) 0 r); [lra| | |lra].
  - intros x Hx. apply (is_derive_minus S0 f); auto. apply Df; lra.
  - intros x Hx. assert (A := B x ltac:(lra)). assert (A' := Rle_abs (f' x)). lra. }
assert (R2 : 0 <= S0 r + f r).
{ apply (nonnegative_of_derive (fun x => S0 x + f x) (fun x => S' x + f' x) 0 r); [lra| | |lra].
  - intros x Hx. apply (is_derive_plus S0 f); auto. apply Df; lra.
  - intros x Hx. assert (A := B x ltac:(lra)). assert (A' := Rle_abs (- f' x)). rewrite Rabs_Ropp in A'. lra. }
assert (Ex := exp_pos (exponent eta r)).
replace (exp (exponent eta r) - eta_series eta N (fun i => r ^ i)) with (exp (exponent eta r) * f r).
2: { unfold f, P. rewrite Rmult_minus_distr_l, <- Rmult_assoc, <- exp_plus.
     replace (exponent eta r + - exponent eta r) with 0 by ring. rewrite exp_0. ring. }
replace (remainder_bound eta N (fun i => r ^ i * exp (exponent eta r))) with (exp (exponent eta r) * S0 r).
2: { unfold S0, remainder_bound. rewrite <- Rmult_assoc, (Rmult_comm (exp _)), Rmult_assoc, <- sum_first_scal. f_equal.
     apply sum_first_ext. intros; ring. }
rewrite Rabs_mult, (Rabs_pos_eq (exp _)) by lra. apply Rmult_le_compat_l; [lra|]. apply Rabs_le. lra.
Qed.
