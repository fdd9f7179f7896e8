(** * t -> -oo: the enveloping series

    The partial sums of e^(-u) envelop it; under the integral they give the series of proofs/negative.md, for every
    derivative of order n > b, with its remainder. The leading term gives Theta(-x) ~ x^b for every b that is not 0, 1,
    2, ... *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncatedIntegral TruncationLimit GammaFunction LaplaceIntegral WellPosed
  ImproperIntegral.
Open Scope R_scope.

Definition exp_term (u : R) (k : nat) : R := (-1) ^ k * u ^ k / INR (fact k).

Lemma sum_first_exp_term_0 n : sum_first (exp_term 0) (S n) = 1.
Proof.
induction n as [|n IH].
- simpl. unfold exp_term; simpl. field.
- change (sum_first (exp_term 0) (S (S n))) with (sum_first (exp_term 0) (S n) + exp_term 0 (S n)).
  rewrite IH. unfold exp_term. rewrite pow_i by lia.
  unfold Rdiv. ring.
Qed.

Lemma sum_first_exp_term_derive n u : is_derive (fun u => sum_first (exp_term u) (S n)) u (- sum_first (exp_term u) n).
Proof.
induction n as [|n IH].
- simpl. apply (is_derive_ext (fun _ => 1)).
  { intros t. unfold exp_term; simpl. field. }
  rewrite Ropp_0. apply (is_derive_const 1).
- change (is_derive (fun u => sum_first (exp_term u) (S n) + exp_term u (S n)) u
    (- (sum_first (exp_term u) n + exp_term u n))).
  rewrite Ropp_plus_distr.
  apply (is_derive_plus (fun u => sum_first (exp_term u) (S n)) (fun u => exp_term u (S n))); auto.
  assert (Hf := INR_fact_neq_0 n). assert (Hs := not_0_INR (S n) ltac:(lia)).
  assert (E : INR (fact (S n)) = INR (S n) * INR (fact n)) by (rewrite <- mult_INR; reflexivity).
  apply (is_derive_ext (fun u => (-1) ^ S n / INR (fact (S n)) * u ^ S n)).
  { intros t. change ((-1) ^ S n / INR (fact (S n)) * t ^ S n = (-1) ^ S n * t ^ S n / INR (fact (S n))).
    unfold Rdiv; ring. }
  evar_last.
  apply (is_derive_scal (fun u => u ^ S n)).
  apply (is_derive_pow (fun u => u) (S n) u 1), (is_derive_id u).
  unfold exp_term. rewrite E. simpl pred. generalize dependent (INR (S n)). intros q Hq _.
  simpl pow. field. auto.
Qed.

(** f_n(u) = (-1)^n (e^-u - sum_{k<n} (-u)^k/k!) >= 0 for u >= 0 *)
Definition exp_rest (n : nat) (u : R) : R := (-1) ^ n * (exp (- u) - sum_first (exp_term u) n).

Lemma exp_rest_derive n u : is_derive (exp_rest (S n)) u (exp_rest n u).
Proof.
unfold exp_rest.
replace ((-1) ^ n * (exp (- u) - sum_first (exp_term u) n))
  with ((-1) ^ S n * (- exp (- u) - - sum_first (exp_term u) n)) by (simpl; ring).
apply (is_derive_scal (fun u => exp (- u) - sum_first (exp_term u) (S n))).
apply (is_derive_minus (fun u => exp (- u)) (fun u => sum_first (exp_term u) (S n))).
- auto_derive; auto; ring.
- apply sum_first_exp_term_derive.
Qed.

Lemma exp_rest_pos n u : 0 <= u -> 0 <= exp_rest n u.
Proof.
revert u; induction n as [|n IH]; intros u Hu.
- unfold exp_rest; simpl. generalize (exp_pos (- u)); lra.
- replace 0 with (exp_rest (S n) 0).
  2: { unfold exp_rest. rewrite sum_first_exp_term_0, Ropp_0, exp_0. ring. }
  apply Ropp_le_cancel.
  apply (decr_of_derive (fun u => - exp_rest (S n) u) (fun u => - exp_rest n u) 0 u Hu).
  + intros v _. apply (is_derive_opp (exp_rest (S n))), exp_rest_derive.
  + intros v Hv. specialize (IH v (proj1 Hv)). lra.
Qed.

Section Envelope.
Variables (c : R) (y : R -> R).
Hypothesis Hc : -1 < c.
Hypothesis Hy : Laplace c y.

Definition envelope_term (x : R) (k : nat) : R :=
  Gamma (c + 1 + 3 * INR k) * Rpower x (- (c + 1 + 3 * INR k)) / (3 ^ k * INR (fact k)).

Let kern (x r : R) : R := Rpower r c * exp (- (x * r)).

Lemma gen_term x k : 0 < x ->
  is_RInt_gen (fun r => kern x r * ((r ^ 3 / 3) ^ k / INR (fact k)))
    (at_right 0) (Rbar_locally p_infty) (envelope_term x k).
Proof.
intros Hx.
assert (Hk := pos_INR k).
assert (H := Gamma_scaled (c + 1 + 3 * INR k) x ltac:(lra) Hx).
apply (is_RInt_gen_scal _ (/ (3 ^ k * INR (fact k)))) in H.
assert (Hf := INR_fact_neq_0 k).
assert (H3 : 3 ^ k <> 0) by (apply pow_nonzero; lra).
replace (envelope_term x k) with (/ (3 ^ k * INR (fact k)) *
  (Rpower x (- (c + 1 + 3 * INR k)) * Gamma (c + 1 + 3 * INR k))) by (unfold envelope_term; field; auto).
eapply improper_ext; [|exact H].
intros r Hr. unfold kern.
change (/ (3 ^ k * INR (fact k)) * (Rpower r (c + 1 + 3 * INR k - 1) * exp (- (x * r)))
  = Rpower r c * exp (- (x * r)) * ((r ^ 3 / 3) ^ k / INR (fact k))).
replace (c + 1 + 3 * INR k - 1) with (c + 3 * INR k) by ring.
rewrite Rpower_plus.
replace (Rpower r (3 * INR k)) with ((r ^ 3) ^ k).
- unfold Rdiv at 2. rewrite Rpow_mult_distr, pow_inv. field. auto.
- rewrite <- Rpower_mult, Rpower_pow by (unfold Rpower; apply exp_pos).
  f_equal. rewrite <- (Rpower_pow 3 r) by auto. f_equal. simpl; ring.
Qed.

Lemma gen_psum x n : 0 < x ->
  is_RInt_gen (fun r => kern x r * sum_first (exp_term (r ^ 3 / 3)) n)
    (at_right 0) (Rbar_locally p_infty) (sum_first (fun k => (-1) ^ k * envelope_term x k) n).
Proof.
intros Hx; induction n as [|n IH].
- assert (H : is_RInt_gen (fun r => scal 0 (kern x r * ((r ^ 3 / 3) ^ 0 / INR (fact 0))))
    (at_right 0) (Rbar_locally p_infty) (0 * envelope_term x 0))
    by exact (is_RInt_gen_scal _ 0 _ (gen_term x 0 Hx)).
  rewrite Rmult_0_l in H. simpl sum_first.
  eapply improper_ext; [|exact H].
  intros r _. unfold scal; simpl; unfold mult; simpl. ring.
- simpl sum_first.
  assert (H := is_RInt_gen_scal _ ((-1) ^ n) _ (gen_term x n Hx)).
  assert (H2 := is_RInt_gen_plus _ _ _ _ IH H).
  eapply improper_ext; [|exact H2].
  intros r _. unfold exp_term, scal, plus; simpl; unfold mult; simpl. unfold Rdiv; ring.
Qed.

(** The enveloping series: the remainder after N terms has the sign of the first
    omitted term and is at most that term. *)
Theorem envelope x N : 0 < x ->
  0 <= (-1) ^ N * (y (- x) - sum_first (fun k => (-1) ^ k * envelope_term x k) N) <= envelope_term x N.
Proof.
intros Hx.
assert (Hrem : forall n, is_RInt_gen (fun r => kern x r * exp_rest n (r ^ 3 / 3))
  (at_right 0) (Rbar_locally p_infty)
  ((-1) ^ n * (y (- x) - sum_first (fun k => (-1) ^ k * envelope_term x k) n))).
{ intros n.
  assert (H := Laplace_representation c y Hc Hy (- x)).
  assert (H2 := is_RInt_gen_scal _ ((-1) ^ n) _ (is_RInt_gen_minus _ _ _ _ H (gen_psum x n Hx))).
  eapply improper_ext; [|exact H2].
  intros r _. unfold scal, minus, plus, opp; simpl; unfold mult; simpl.
  unfold exp_rest, kern.
  replace (r * - x - r * (r * (r * 1)) / 3) with (- (x * r) + - (r * (r * (r * 1)) / 3)) by ring.
  rewrite exp_plus. ring. }
assert (Hpos : forall n r, 0 < r -> 0 <= kern x r * exp_rest n (r ^ 3 / 3)).
{ intros n r Hr. apply Rmult_le_pos.
  - apply Rlt_le, Rmult_lt_0_compat; apply exp_pos.
  - apply exp_rest_pos. assert (0 < r ^ 3) by (apply pow_lt; auto). lra. }
split.
- apply (improper_pos _ _ (Hpos N) (Hrem N)).
- assert (H0 := improper_pos _ _ (Hpos (S N)) (Hrem (S N))).
  simpl in H0.
  assert (Hsq : (-1) ^ N * (-1) ^ N = 1).
  { rewrite <- Rpow_mult_distr. replace (-1 * -1) with 1 by ring. apply pow1. }
  set (P := sum_first (fun k => (-1) ^ k * envelope_term x k) N) in *.
  replace (-1 * (-1) ^ N * (y (- x) - (P + (-1) ^ N * envelope_term x N))) with
    ((-1) ^ N * (-1) ^ N * envelope_term x N - (-1) ^ N * (y (- x) - P)) in H0 by ring.
  rewrite Hsq in H0. lra.
Qed.

End Envelope.

(** Leading asymptotics of [Laplace c] functions, c not a negative integer. *)
Lemma Laplace_lim_aux n : forall c y, - 1 - INR n < c ->
  (forall k : nat, c + INR k <> -1) -> Laplace c y ->
  is_lim (fun x => y (- x) * Rpower x (c + 1)) p_infty (Gamma (c + 1)).
Proof.
assert (Hbase : forall c y, -1 < c -> Laplace c y ->
  is_lim (fun x => y (- x) * Rpower x (c + 1)) p_infty (Gamma (c + 1))).
{ intros c y Hc Hy.
  apply is_lim_spec. intros eps.
  assert (HG : 0 < Gamma (c + 1 + 3)) by (apply Gamma_pos; lra).
  set (K := Gamma (c + 1 + 3) / 3).
  assert (HK : 0 < K) by (unfold K; lra).
  exists (Rmax 1 (K / eps)). intros x Hx.
  assert (Hx1 : 1 < x) by (eapply Rle_lt_trans; [apply Rmax_l|exact Hx]).
  assert (Hx2 : K / eps < x) by (eapply Rle_lt_trans; [apply Rmax_r|exact Hx]).
  destruct (envelope c y Hc Hy x 1 ltac:(lra)) as [E1 E2].
  simpl in E1, E2. unfold envelope_term in E1, E2; simpl in E1, E2.
  replace (c + 1 + 3 * 0) with (c + 1) in * by ring.
  replace (c + 1 + 3 * 1) with (c + 1 + 3) in * by ring.
  set (X := Rpower x (c + 1)).
  assert (HX : 0 < X) by apply exp_pos.
  assert (E0 : Rpower x (- (c + 1)) * X = 1).
  { unfold X. rewrite <- Rpower_plus. replace (- (c + 1) + (c + 1)) with 0 by ring.
    apply Rpower_O; lra. }
  assert (E3 : Rpower x (- (c + 1 + 3)) * X = / x ^ 3).
  { unfold X. rewrite <- Rpower_plus. replace (- (c + 1 + 3) + (c + 1)) with (- INR 3) by (simpl; ring).
    rewrite Rpower_Ropp, Rpower_pow by lra. reflexivity. }
  apply (Rmult_le_compat_r X) in E1; [|lra].
  apply (Rmult_le_compat_r X) in E2; [|lra].
  set (G := Gamma (c + 1)) in *. set (Y := y (- x)) in *.
  set (R1 := Rpower x (- (c + 1))) in *. set (R4 := Rpower x (- (c + 1 + 3))) in *.
  replace (Gamma (c + 1 + 3) * R4 / (3 * 1 * 1) * X) with (K * (R4 * X)) in E2 by (unfold K; field).
  replace (-1 * 1 * (Y - (0 + 1 * (G * R1 / (1 * 1)))) * X) with (G * (R1 * X) - Y * X) in E1, E2 by field.
  rewrite E0 in E1, E2. rewrite E3 in E2.
  assert (Hsmall : K * / x ^ 3 < eps).
  { apply Rmult_lt_reg_r with (x ^ 3). apply pow_lt; lra.
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r by (apply pow_nonzero; lra).
    assert (He := cond_pos eps).
    assert (K < eps * x).
    { replace K with (eps * (K / eps)) by (field; lra). apply Rmult_lt_compat_l; auto. }
    assert (x <= x ^ 3).
    { simpl. assert (1 * 1 <= x * x) by (apply Rmult_le_compat; lra).
      assert (x * 1 <= x * (x * x)) by (apply Rmult_le_compat_l; lra). lra. }
    assert (eps * x <= eps * x ^ 3) by (apply Rmult_le_compat_l; lra). lra. }
  apply Rabs_def1; lra. }
induction n as [|n IH]; intros c y Hn Hk Hy.
- apply Hbase; auto. simpl in Hn; lra.
- rewrite S_INR in Hn.
  assert (K0 := Hk 0%nat). assert (K1 := Hk 1%nat). assert (K2 := Hk 2%nat). simpl in K0, K1, K2.
  assert (L1 := Laplace_derive_n c y 1 (fun k _ => Hk k) Hy).
  assert (L3 := Laplace_derive_n c y 3 (fun k _ => Hk k) Hy).
  assert (A1 : is_lim (fun x => Derive_n y 1 (- x) * Rpower x (c + INR 1 + 1)) p_infty
     (Gamma (c + INR 1 + 1))).
  { apply IH; auto. simpl; lra. intros k Hk'. apply (Hk (k + 1)%nat). rewrite plus_INR. lra. }
  assert (A3 : is_lim (fun x => Derive_n y 3 (- x) * Rpower x (c + INR 3 + 1)) p_infty
     (Gamma (c + INR 3 + 1))).
  { apply IH; auto. simpl; lra. intros k Hk'. apply (Hk (k + 3)%nat). rewrite plus_INR. lra. }
  assert (Hode : forall t, Derive_n y 3 t = t * Derive_n y 1 t + (c + 1) * y t).
  { destruct Hy as (y1 & y2 & D0 & D1 & D2 & _). intros t.
    assert (E1 : forall s, Derive y s = y1 s) by (intros; apply is_derive_unique, D0).
    assert (E2 : forall s, Derive_n y 2 s = y2 s).
    { intros s; simpl. rewrite (Derive_ext _ y1) by (intros; apply E1). apply is_derive_unique, D1. }
    change (Derive (Derive_n y 2) t = t * Derive y t + (c + 1) * y t).
    rewrite (Derive_ext _ y2) by (intros; apply E2). rewrite E1.
    apply is_derive_unique, D2. }
  apply (is_lim_ext_loc (fun x => / (c + 1) * (Derive_n y 3 (- x) * Rpower x (c + INR 3 + 1) * / x ^ 3
     + Derive_n y 1 (- x) * Rpower x (c + INR 1 + 1)))).
  { exists 1. intros x Hx. rewrite (Hode (- x)).
    assert (E1 : Rpower x (c + INR 1 + 1) = x * Rpower x (c + 1)).
    { rewrite <- Rpower_S by lra. f_equal; simpl; ring. }
    assert (E3 : Rpower x (c + INR 3 + 1) = x ^ 3 * Rpower x (c + 1)).
    { rewrite <- Rpower_pow, <- Rpower_plus by lra. f_equal; simpl; ring. }
    rewrite E1, E3. field. split; lra. }
  replace (Gamma (c + 1)) with (/ (c + 1) * (Gamma (c + INR 3 + 1) * 0 + Gamma (c + INR 1 + 1))).
  2: { replace (c + INR 1 + 1) with (c + 1 + 1) by (simpl; ring).
       rewrite (Gamma_rec (c + 1)) by lra. field. lra. }
  apply (is_lim_scal_l _ (/ (c + 1)) p_infty (Finite (Gamma (c + INR 3 + 1) * 0 + Gamma (c + INR 1 + 1)))).
  apply is_lim_plus'; auto.
  apply (is_lim_mult _ (fun x => / x ^ 3) p_infty (Gamma (c + INR 3 + 1)) 0); [exact A3| |exact I].
  apply is_lim_spec. intros eps. assert (He := cond_pos eps).
  exists (Rmax 1 (/ eps)). intros x Hx.
  assert (Hx1 : 1 < x) by (eapply Rle_lt_trans; [apply Rmax_l|exact Hx]).
  assert (Hx2 : / eps < x) by (eapply Rle_lt_trans; [apply Rmax_r|exact Hx]).
  assert (Hx3 : 0 < x ^ 3) by (apply pow_lt; lra).
  rewrite Rminus_0_r, Rabs_pos_eq by (apply Rlt_le, Rinv_0_lt_compat; auto).
  rewrite <- (Rinv_inv eps) by lra.
  apply Rinv_lt_contravar.
  + apply Rmult_lt_0_compat; auto. apply Rinv_0_lt_compat; auto.
  + apply Rlt_le_trans with x; auto.
    simpl. assert (1 * 1 <= x * x) by (apply Rmult_le_compat; lra).
    assert (x * 1 <= x * (x * x)) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(** The property by which the paper singles out Theta:
    Theta(tau, b) ~ (-tau)^b as tau -> -oo, for every real b not in {0,1,2,...}. *)
Theorem Theta_asymptotics (b : R) (theta : R -> R) :
  not_nat b -> is_Theta b theta ->
  is_lim (fun x => theta (- x) / Rpower x b) p_infty 1.
Proof.
intros Hb H.
assert (HL := Theta_Laplace b theta Hb H).
assert (Hg : Gamma (- b) <> 0).
{ apply Gamma_neq0. intros n Hn; apply (Hb n); lra. }
assert (Hex : exists n : nat, b < INR n).
{ destruct (Rle_lt_dec 0 b) as [H0|H0].
  - destruct (nfloor_ex b H0) as [n [_ Hn]]. exists (S n). rewrite S_INR; lra.
  - exists O; exact H0. }
destruct Hex as [n Hn].
assert (Hlim := Laplace_lim_aux n (- b - 1) _ ltac:(lra)
  ltac:(intros k Hk; apply (Hb k); lra) HL).
apply (is_lim_ext_loc (fun x => / Gamma (- b) * (Gamma (- b) * theta (- x) * Rpower x (- b - 1 + 1)))).
{ exists 1. intros x Hx. replace (- b - 1 + 1) with (- b) by ring.
  rewrite Rpower_Ropp. field. split; auto. apply Rgt_not_eq, exp_pos. }
assert (HH := is_lim_scal_l _ (/ Gamma (- b)) p_infty (Finite (Gamma (- b - 1 + 1))) Hlim).
simpl in HH.
assert (E : / Gamma (- b) * Gamma (- b - 1 + 1) = 1).
{ replace (- b - 1 + 1) with (- b) by ring. field; auto. }
rewrite E in HH. exact HH.
Qed.

(** k-th term: (n-b)_{3k} / (3^k k! x^{3k}) *)
Definition series_term (b : R) (n : nat) (x : R) (k : nat) : R :=
  rising (INR n - b) (3 * k) / (3 ^ k * INR (fact k) * x ^ (3 * k)).

Lemma sum_first_ext a a' n : (forall k, a k = a' k) -> sum_first a n = sum_first a' n.
Proof. intros E; induction n as [|n IH]; simpl; auto. rewrite IH, E; auto. Qed.

Lemma sum_first_scal q a n : sum_first (fun k => q * a k) n = q * sum_first a n.
Proof. induction n as [|n IH]; simpl. ring. rewrite IH; ring. Qed.

(** Theta^(n)(-x) = (-b)_n x^(b-n) [ sum_{k<N} (-1)^k series_term k + (-1)^N rho ], 0 <= rho <= series_term N *)
Theorem Theta_neg_series (b : R) (theta : R -> R) (n N : nat) (x : R) :
  not_nat b -> b < INR n -> is_Theta b theta -> 0 < x ->
  0 <= (-1) ^ N * (Derive_n theta n (- x) / (rising (- b) n * Rpower x (b - INR n))
        - sum_first (fun k => (-1) ^ k * series_term b n x k) N) <= series_term b n x N.
Proof.
intros Hb Hn H Hx.
assert (Hnp : forall k : nat, - b <> - INR k) by (intros k Hk; apply (Hb k); lra).
assert (Hg : Gamma (- b) <> 0) by (apply Gamma_neq0; auto).
assert (Hp := rising_neq0 (- b) n Hnp).
set (c := INR n - b - 1).
assert (HE := envelope c _ ltac:(unfold c; lra) (Theta_Laplace_n b theta n Hb H) x N Hx).
simpl in HE.
set (A := Gamma (- b + INR n)).
assert (EA : A = rising (- b) n * Gamma (- b)) by (apply Gamma_rising; auto).
assert (HA : 0 < A) by (apply Gamma_pos; lra).
set (X := Rpower x (b - INR n)). assert (HX : 0 < X) by apply exp_pos.
assert (Hq : 0 < A * X) by (apply Rmult_lt_0_compat; auto).
assert (ET : forall k, envelope_term c x k = A * X * series_term b n x k).
{ intros k. unfold envelope_term, series_term, A, X.
  replace (c + 1 + 3 * INR k) with ((INR n - b) + INR (3 * k))
    by (unfold c; rewrite mult_INR; simpl; ring).
  rewrite Gamma_rising.
  2: { intros j Hj. generalize (pos_INR j); lra. }
  replace (- (INR n - b + INR (3 * k))) with ((b - INR n) + - INR (3 * k)) by ring.
  rewrite Rpower_plus, Rpower_Ropp, Rpower_pow by auto.
  replace (- b + INR n) with (INR n - b) by ring.
  field. refine (conj _ (conj _ _)).
  - apply pow_nonzero; lra.
  - apply INR_fact_neq_0.
  - apply pow_nonzero; lra. }
rewrite ET in HE.
rewrite (sum_first_ext _ (fun k => A * X * ((-1) ^ k * series_term b n x k))) in HE
  by (intros k; rewrite ET; ring).
rewrite sum_first_scal in HE.
replace (Gamma (- b) * Derive_n theta n (- x)) with
  (A * X * (Derive_n theta n (- x) / (rising (- b) n * X))) in HE
  by (rewrite EA; field; split; auto; lra).
set (W := Derive_n theta n (- x) / (rising (- b) n * X)) in *.
set (P := sum_first (fun k => (-1) ^ k * series_term b n x k) N) in *.
replace ((-1) ^ N * (A * X * W - A * X * P)) with (A * X * ((-1) ^ N * (W - P))) in HE by ring.
destruct HE as [E1 E2]. split.
- apply Rmult_le_reg_l with (A * X); auto. lra.
- apply Rmult_le_reg_l with (A * X); auto.
Qed.

