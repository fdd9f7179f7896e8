(** * 1/Gamma is an entire function

    At every centre x0 its power series has bounded norm on every radius ([entire]). With Y(h) = Gamma(x0) - x0^-h
    Gamma(x0 + h) = int (1 - (u/x0)^h) u^(x0-1) e^-u du, the norm of Y on the radius N/2 is at most int (e^(N|y|/2) - 1)
    u^(x0-1) e^-u du, y = ln(u/x0), and e^(N|y|/2) - 1 <= 1/4 + e^(Ny) + e^(-Ny) - 2. So it is at most (1/4 - 2 + 10/9 +
    10/9) Gamma(x0) < Gamma(x0)/2 for x0 >= 10 N^2: mean values of (u/x0)^(+-N), which are products. Hence 1/Gamma(x0 +
    h) = x0^-h/(Gamma(x0) - Y(h)) is a series on that radius; downwards by 1/Gamma(x) = x/Gamma(x + 1). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus TruncatedIntegral TruncationLimit GammaFunction ImproperIntegral
  GammaMultiplication EntireForm
  PowerSeriesNorm NormLimit.
Open Scope R_scope.

Definition entire (f : R -> R) : Prop := forall b r, 0 < r -> exists M, norm_at_most r M (fun h => f (b + h)).

Lemma norm_drop_constant r M f : 0 < r -> norm_at_most r M f -> norm_at_most r (M - Rabs (f 0)) (fun x => f x - f 0).
Proof.
intros Hr (a & Ha & Hf).
assert (a0 : a 0%nat = f 0).
{ assert (E := Hf 0 ltac:(rewrite Rabs_R0; lra)). apply is_pseries_unique in E. rewrite PSeries_0 in E. exact E. }
exists (fun n => match n with O => 0 | S _ => a n end).
assert (E : forall (u : nat -> R) N, sum_first (fun n => match n with O => 0 | S _ => u n end) (S N) = sum_first u (S N)
  - u 0%nat).
{ intros u. induction N as [|N IH]. simpl. ring.
  change (sum_first ?v (S (S N))) with (sum_first v (S N) + v (S N)). rewrite IH. simpl. ring. }
split.
- intros [|N].
  + simpl. assert (H := Ha 1%nat). simpl in H. rewrite <- a0. lra.
  + rewrite (sum_first_ext _ (fun n => match n with O => 0 | S _ => Rabs (a n) * r ^ n end)).
    * rewrite (E (fun n => Rabs (a n) * r ^ n)). rewrite a0. specialize (Ha (S N)). simpl pow at 2. lra.
    * intros [|n]; auto. rewrite Rabs_R0. ring.
- intros x Hx. assert (L := proj1 (is_pseries_sum_first _ _ _) (Hf x Hx)). apply is_pseries_sum_first.
  apply is_lim_seq_incr_1. apply is_lim_seq_incr_1 in L.
  apply (is_lim_seq_ext (fun N => sum_first (fun n => a n * x ^ n) (S N) - f 0)).
  + intros N. rewrite (sum_first_ext (fun n => match n with O => 0 | S _ => a n end * x ^ n) (fun n => match n with O =>
      0 | S _ => a n * x ^ n end)).
    * rewrite (E (fun n => a n * x ^ n)). rewrite a0. simpl pow at 3. ring.
    * intros [|n]; auto. ring.
  + apply is_lim_seq_minus'; auto. apply is_lim_seq_const.
Qed.

(** ** Far to the right *)

Section Right.
Variables (N : nat) (x0 : R).
Hypothesis HN : (1 <= N)%nat.
Hypothesis Hx0 : 10 * INR N ^ 2 <= x0.

Let r := INR N / 2.
Let y u := ln u - ln x0.

Lemma one_le_N : 1 <= INR N.
Proof. exact (le_INR 1 N HN). Qed.

Lemma centre_large : 10 * INR N <= x0 /\ 10 <= x0 /\ 0 < r < x0.
Proof. assert (H := one_le_N). unfold r. repeat split; nra. Qed.

Lemma weight_bound a : exp (Rabs a / 2) - 1 <= 1 / 4 + (exp a + exp (- a) - 2).
Proof.
set (b := Rabs a / 2). assert (Hb : 0 <= b) by (unfold b; generalize (Rabs_pos a); lra).
assert (E : exp a + exp (- a) = exp b * exp b + exp (- b) * exp (- b)).
{ rewrite <- !exp_plus. unfold b, Rabs. destruct Rcase_abs.
  - rewrite Rplus_comm. f_equal; f_equal; lra.
  - f_equal; f_equal; lra. }
rewrite E. assert (P : exp b * exp (- b) = 1) by (rewrite <- exp_plus; replace (b + - b) with 0 by ring; apply exp_0).
assert (H1 := exp_ineq1_le b). assert (H2 := exp_pos (- b)). set (p := exp b) in *. set (q := exp (- b)) in *.
assert (Q : q <= 1) by nra.
assert (X : p * p + q * q - 2 = (p - q) * (p - q)). { replace 2 with (2 * (p * q)) by (rewrite P; ring). ring. }
rewrite X. assert ((p - 1) * (p - 1) <= (p - q) * (p - q)) by (apply Rmult_le_compat; lra).
assert (S := pow2_ge_0 (p - 1 - 1 / 2)). lra.
Qed.

Lemma bernoulli q n : 0 <= q <= 1 -> 1 - INR n * q <= (1 - q) ^ n.
Proof.
intros Hq. induction n as [|n IH]. simpl; lra.
rewrite S_INR. simpl. assert (P := pos_INR n). assert (0 <= (1 - q) ^ n) by (apply pow_le; lra). nra.
Qed.

Lemma rising_between z n : 0 < z -> z ^ n <= rising z n <= (z + INR n) ^ n.
Proof.
intros Hz. induction n as [|n IH]. simpl; lra.
cbn [rising]. rewrite S_INR. assert (P := pos_INR n). assert (0 < z ^ n) by (apply pow_lt, Hz). split.
- simpl. nra.
- apply Rle_trans with ((z + INR n) ^ n * (z + INR n)). apply Rmult_le_compat_r; lra.
  simpl. rewrite Rmult_comm. apply Rmult_le_compat; try lra. apply pow_incr. lra.
Qed.

Let q := INR N / x0.

Lemma quotient_small : 0 < q <= 1 / 10 /\ 9 / 10 <= (1 - q) ^ N.
Proof.
assert (H := one_le_N). destruct centre_large as (H1 & H2 & _).
assert (Q : 0 < q <= 1 / 10).
{ unfold q. split. apply Rdiv_lt_0_compat; lra. apply Rmult_le_reg_r with x0; [lra|].
  replace (INR N / x0 * x0) with (INR N) by (field; lra). lra. }
split; auto. apply Rle_trans with (1 - INR N * q). 2: apply bernoulli; lra.
assert (INR N * q <= 1 / 10); [|lra]. unfold q.
apply Rmult_le_reg_r with x0; [lra|]. replace (INR N * (INR N / x0) * x0) with (INR N ^ 2) by (field; lra). lra.
Qed.

Lemma mean_up : Gamma (x0 + INR N) / x0 ^ N <= 10 / 9 * Gamma x0.
Proof.
destruct quotient_small as [Hq HB]. destruct centre_large as (H1 & H2 & _).
assert (G := Gamma_pos x0 ltac:(lra)). assert (P : 0 < x0 ^ N) by (apply pow_lt; lra).
rewrite Gamma_rising. 2: { intros k Hk. assert (K := pos_INR k). lra. }
apply Rmult_le_reg_r with (x0 ^ N); auto.
replace (rising x0 N * Gamma x0 / x0 ^ N * x0 ^ N) with (rising x0 N * Gamma x0) by (field; lra).
replace (10 / 9 * Gamma x0 * x0 ^ N) with (10 / 9 * x0 ^ N * Gamma x0) by ring. apply Rmult_le_compat_r; [lra|].
eapply Rle_trans; [apply rising_between; lra|].
replace (x0 + INR N) with (x0 * (1 + q)) by (unfold q; field; lra). rewrite Rpow_mult_distr, Rmult_comm.
apply Rmult_le_compat_r; [lra|].
assert (B : (1 + q) ^ N * (1 - q) ^ N <= 1).
{ rewrite <- Rpow_mult_distr. apply Rle_trans with (1 ^ N); [|rewrite pow1; lra]. apply pow_incr.
  assert (Hqq := Rle_0_sqr q). unfold Rsqr in Hqq. split; [apply Rmult_le_pos; lra|lra]. }
assert (A : 0 < (1 + q) ^ N) by (apply pow_lt; lra).
assert ((1 + q) ^ N * (9 / 10) <= (1 + q) ^ N * (1 - q) ^ N) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Lemma mean_down : x0 ^ N * Gamma (x0 - INR N) <= 10 / 9 * Gamma x0.
Proof.
destruct quotient_small as [Hq HB]. destruct centre_large as (H1 & H2 & _). assert (H := one_le_N).
assert (G := Gamma_pos (x0 - INR N) ltac:(lra)). assert (P : 0 < x0 ^ N) by (apply pow_lt; lra).
replace (Gamma x0) with (Gamma (x0 - INR N + INR N)) by (f_equal; ring).
rewrite Gamma_rising. 2: { intros k Hk. assert (K := pos_INR k). lra. }
rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [lra|].
destruct (rising_between (x0 - INR N) N ltac:(lra)) as [R1 _].
assert (E : (x0 - INR N) ^ N = x0 ^ N * (1 - q) ^ N). { rewrite <- Rpow_mult_distr. f_equal. unfold q. field. lra. }
rewrite E in R1. assert (x0 ^ N * (9 / 10) <= x0 ^ N * (1 - q) ^ N) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Let m u := (1 / 4 - 2 + exp (INR N * y u) + exp (- (INR N * y u))) * gamma_integrand x0 u.

Lemma shifted_integrand e u : exp (e * y u) * gamma_integrand x0 u = exp (- (e * ln x0)) * gamma_integrand (x0 + e) u.
Proof.
unfold gamma_integrand, Rpower, y. replace (x0 + e - 1) with (e + (x0 - 1)) by ring.
rewrite <- !Rmult_assoc, <- !exp_plus. f_equal. f_equal. ring.
Qed.

Lemma is_gamma x : 0 < x -> is_RInt_gen (gamma_integrand x) (at_right 0) (Rbar_locally p_infty) (Gamma x).
Proof. exact (Gamma_is x). Qed.

Let Y h := Gamma x0 - exp (- (h * ln x0)) * Gamma (x0 + h).

Lemma Y_norm : norm_at_most r (Gamma x0 / 2) Y.
Proof.
destruct centre_large as (H1 & H2 & Hr). assert (H := one_le_N).
assert (EN : exp (INR N * ln x0) = x0 ^ N) by (apply (Rpower_pow N x0); lra).
assert (PN : 0 < x0 ^ N) by (apply pow_lt; lra). assert (G := Gamma_pos x0 ltac:(lra)).
apply (norm_weaken r ((1 / 4 - 2) * Gamma x0 + (exp (- (INR N * ln x0)) * Gamma (x0 + INR N) + exp (- (- INR N * ln x0))
  * Gamma (x0 + - INR N)))).
{ assert (U := mean_up). assert (D := mean_down). unfold Rdiv at 1 in U. rewrite <- EN, <- exp_Ropp in U.
  rewrite <- EN in D.
  replace (- (- INR N * ln x0)) with (INR N * ln x0) by ring. unfold Rminus in D. lra. }
apply (norm_improper r (fun u h => gamma_integrand x0 u * (1 - exp (y u * h))) m); try lra.
- intros u. assert (P := gamma_integrand_pos x0 u).
  apply (norm_weaken r (Rabs (gamma_integrand x0 u) * (Rabs (-1) * (exp (Rabs (y u) * r) - Rabs (exp (y u * 0)))))).
  + replace (Rabs (-1)) with 1 by (rewrite Rabs_left; lra).
    rewrite Rmult_0_r, exp_0, Rabs_R1, Rmult_1_l, (Rabs_pos_eq (gamma_integrand x0 u)) by lra.
    unfold m. rewrite Rmult_comm. apply Rmult_le_compat_r; [lra|].
    assert (W := weight_bound (INR N * y u)). rewrite Rabs_mult, (Rabs_pos_eq (INR N)) in W by lra.
    replace (INR N * Rabs (y u) / 2) with (Rabs (y u) * r) in W by (unfold r; field). lra.
  + apply (norm_scal r _ (gamma_integrand x0 u) (fun h => 1 - exp (y u * h))).
    apply (norm_ext r _ (fun h => -1 * (exp (y u * h) - exp (y u * 0)))).
    { intros h _. rewrite Rmult_0_r, exp_0. ring. }
    apply norm_scal. apply (norm_drop_constant r _ (fun h => exp (y u * h))); [lra|]. apply norm_exp. lra.
- intros u Hu. apply (continuous_mult (fun u => 1 / 4 - 2 + exp (INR N * y u) + exp (- (INR N * y u)))
    (gamma_integrand x0)).
  + apply (ex_derive_continuous (fun u => 1 / 4 - 2 + exp (INR N * y u) + exp (- (INR N * y u)))). unfold y.
    auto_derive. auto.
  + apply continuous_gamma_integrand, Hu.
- intros h u _ Hu. apply (continuous_mult (gamma_integrand x0) (fun u => 1 - exp (y u * h))).
  + apply continuous_gamma_integrand, Hu.
  + apply (ex_derive_continuous (fun u => 1 - exp (y u * h))). unfold y. auto_derive. auto.
- assert (A0 := is_gamma x0 ltac:(lra)). apply (is_RInt_gen_scal _ (1 / 4 - 2)) in A0.
  assert (A1 := is_gamma (x0 + INR N) ltac:(lra)). apply (is_RInt_gen_scal _ (exp (- (INR N * ln x0)))) in A1.
  assert (A2 := is_gamma (x0 + - INR N) ltac:(lra)). apply (is_RInt_gen_scal _ (exp (- (- INR N * ln x0)))) in A2.
  assert (A := is_RInt_gen_plus _ _ _ _ A0 (is_RInt_gen_plus _ _ _ _ A1 A2)).
  eapply improper_ext; [|exact A]. intros u Hu. unfold plus, scal; simpl; unfold mult; simpl.
  rewrite <- !shifted_integrand. unfold m. replace (- (INR N * y u)) with (- INR N * y u) by ring. ring.
- intros h Hh. apply Rabs_def2 in Hh.
  assert (A0 := is_gamma x0 ltac:(lra)). assert (A1 := is_gamma (x0 + h) ltac:(lra)).
  apply (is_RInt_gen_scal _ (exp (- (h * ln x0)))) in A1.
  assert (A := is_RInt_gen_minus _ _ _ _ A0 A1).
  eapply improper_ext; [|exact A]. intros u Hu. unfold minus, plus, opp, scal; simpl; unfold mult; simpl.
  rewrite <- shifted_integrand. replace (y u * h) with (h * y u) by ring. ring.
Qed.

Lemma recip_norm_right : exists M, norm_at_most r M (fun h => recip_Gamma (x0 + h)).
Proof.
destruct centre_large as (H1 & H2 & Hr). assert (G := Gamma_pos x0 ltac:(lra)).
assert (A : norm_at_most r (1 / 2) (fun h => / Gamma x0 * Y h)).
{ apply (norm_weaken r (Rabs (/ Gamma x0) * (Gamma x0 / 2))).
  - rewrite Rabs_pos_eq by (apply Rlt_le, Rinv_0_lt_compat, G). right. field. lra.
  - apply norm_scal, Y_norm. }
apply norm_geometric in A; try lra.
assert (B := norm_exp r (- ln x0) ltac:(lra)).
assert (C := norm_scal _ _ (/ Gamma x0) _ (norm_mult r _ _ _ _ ltac:(lra) B A)).
eexists. eapply norm_ext; [|exact C].
intros h Hh. apply Rabs_def2 in Hh. rewrite recip_pos by lra. assert (G' := Gamma_pos (x0 + h) ltac:(lra)).
unfold Y. replace (- (h * ln x0)) with (- ln x0 * h) by ring. assert (P := exp_pos (- ln x0 * h)).
replace (1 - / Gamma x0 * (Gamma x0 - exp (- ln x0 * h) * Gamma (x0 + h)))
  with (exp (- ln x0 * h) * Gamma (x0 + h) / Gamma x0) by (field; lra).
field. repeat split; lra.
Qed.
End Right.

(** ** The algebra of entire functions *)

Lemma entire_ext f g : (forall x, f x = g x) -> entire f -> entire g.
Proof. intros E H b r Hr. destruct (H b r Hr) as [M HM]. exists M. eapply norm_ext; [|exact HM]. intros; apply E. Qed.

Lemma entire_const c : entire (fun _ => c).
Proof. intros b r Hr. exists (Rabs c). apply norm_const. Qed.

Lemma entire_mult f g : entire f -> entire g -> entire (fun x => f x * g x).
Proof.
intros Hf Hg b r Hr. destruct (Hf b r Hr) as [M HM]. destruct (Hg b r Hr) as [K HK].
exists (M * K). apply (norm_mult r _ _ (fun h => f (b + h)) (fun h => g (b + h))); auto.
Qed.

Lemma norm_affine r b c : 0 < r -> norm_at_most r (Rabs b + Rabs c * r) (fun h => b + c * h).
Proof. intros Hr. apply norm_plus; auto. apply norm_const. apply norm_scal, norm_id, Hr. Qed.

(** A change of the variable x -> p + c x, |c| <= 1. *)
Lemma entire_affine f p c : Rabs c <= 1 -> entire f -> entire (fun x => f (p + c * x)).
Proof.
intros Hc H b r Hr. destruct (H (p + c * b) r Hr) as [M HM]. exists M.
apply (norm_ext r _ (fun h => f (p + c * b + c * h))). { intros h _. f_equal. ring. }
apply (norm_contract r M (fun h => f (p + c * b + h))); auto.
Qed.

Lemma entire_exp c : entire (fun x => exp (c * x)).
Proof.
intros b r Hr. eexists. apply (norm_ext r _ (fun h => exp (c * b) * exp (c * h))).
{ intros h _. rewrite <- exp_plus. f_equal. ring. }
apply norm_scal, norm_exp, Hr.
Qed.

Theorem recip_Gamma_entire : entire recip_Gamma.
Proof.
intros x r Hr. destruct (nfloor_ex (2 * r) ltac:(lra)) as [n [_ Hn]].
set (N := S n). assert (HN : r <= INR N / 2) by (unfold N; rewrite S_INR; lra).
assert (H1 : (1 <= N)%nat) by (unfold N; lia).
cut (exists M, norm_at_most (INR N / 2) M (fun h => recip_Gamma (x + h))).
{ intros [M HM]. exists M. eapply norm_smaller; [|exact HM]. lra. }
clear Hr HN. clearbody N. assert (P : 0 < INR N / 2) by (assert (H := le_INR 1 N H1); simpl in H; lra). revert x.
assert (S : forall k x, 10 * INR N ^ 2 <= x + INR k -> exists M, norm_at_most (INR N / 2) M (fun h =>
  recip_Gamma (x + h))).
{ induction k as [|k IH]; intros x Hx.
  - apply recip_norm_right; auto. simpl in Hx. lra.
  - destruct (IH (x + 1)) as [M HM]. { rewrite S_INR in Hx. lra. }
    eexists. apply (norm_ext _ _ (fun h => (x + 1 * h) * recip_Gamma (x + 1 + h))).
    { intros h _. rewrite (recip_rec (x + h)). replace (x + h + 1) with (x + 1 + h) by ring. ring. }
    apply norm_mult; auto. apply norm_affine, P. exact HM. }
intros x. destruct (nfloor_ex (Rabs (10 * INR N ^ 2 - x)) (Rabs_pos _)) as [k [_ Hk]].
apply (S (Datatypes.S k)). rewrite S_INR. assert (A := Rle_abs (10 * INR N ^ 2 - x)). lra.
Qed.

Lemma entire_series_at_0 f : entire f -> exists a : nat -> R, forall x, is_pseries a x (f x).
Proof.
intros H. exists (taylor f). intros x. assert (Hx : 0 < Rabs x + 1) by (generalize (Rabs_pos x); lra).
destruct (H 0 _ Hx) as [M HM]. apply (taylor_coefficients (Rabs x + 1) M); auto; [|lra].
apply (norm_ext _ _ (fun h => f (0 + h))); auto. intros h _. f_equal. ring.
Qed.

Theorem recip_gamma_entire : exists a : nat -> R, forall x, is_pseries a x (recip_Gamma x).
Proof. apply entire_series_at_0, recip_Gamma_entire. Qed.
