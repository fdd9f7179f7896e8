(** * Theta for t -> +oo: the saddle point with an explicit remainder

    The finite part at x = rho sqrt t, with r = sqrt t (1 + u) in the integral: rt - r^3/3 = lambda (2/3 - s^2), lambda
    = t^(3/2), so the integral is t^(-b/2) e^(2 lambda/3) times the one of [saddle_integral]. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus TruncatedIntegral TruncationLimit GammaFunction PowerSeriesNorm
  IntegerPolynomials PolynomialSum BinomialSeries SaddleInverse SaddleCoefficients SaddleIntegral FinitePart
  GaussianIntegral.
From GSpot Require Import Statement.
Import ListNotations.
Open Scope R_scope.

Lemma limit_within (f : R -> R) (l c E : R) : is_lim f p_infty l -> (exists T, forall t, T <= t -> Rabs (f t - c)
  <= E) ->
  Rabs (l - c) <= E.
Proof.
intros Hf (T & HT). apply le_epsilon. intros eps He. apply is_lim_spec in Hf.
destruct (Hf (mkposreal eps He)) as [m Hm]. set (t := Rmax T (m + 1)).
assert (T1 : T <= t) by apply Rmax_l. assert (T2 : m + 1 <= t) by apply Rmax_r.
specialize (Hm t ltac:(lra)). specialize (HT t T1). simpl in Hm. rewrite Rabs_minus_sym in Hm.
replace (l - c) with ((l - f t) + (f t - c)) by ring. eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.

Section Remainder.
Variables (b t : R).
Hypothesis Ht : 0 < t.
Let lambda := t * sqrt t.
Let K := Rpower t (- b / 2) * exp (2 * lambda / 3).

Lemma root_t : 0 < sqrt t /\ sqrt t * sqrt t = t.
Proof. split. apply sqrt_lt_R0, Ht. apply sqrt_sqrt. lra. Qed.

Lemma lambda_pos : 0 < lambda.
Proof. apply Rmult_lt_0_compat; [exact Ht|apply root_t]. Qed.

(** r = sqrt t (1 + u) *)
Lemma saddle_substitution rho T : 0 < rho -> rho * sqrt t <= T ->
  M (- b - 1) (rho * sqrt t) T t = K * RInt (saddle_integrand lambda (- b - 1)) (-1 + rho) (T / sqrt t - 1).
Proof.
intros Hr HT. destruct root_t as [R0 R1].
assert (HT' : rho <= T / sqrt t).
{ apply Rmult_le_reg_r with (sqrt t); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r; lra. }
assert (P : 0 < rho * sqrt t) by (apply Rmult_lt_0_compat; auto).
assert (I := RInt_correct _ _ _ (ex_RInt_kernel (- b - 1) t (rho * sqrt t) T P HT)).
replace (rho * sqrt t) with (sqrt t * (-1 + rho) + sqrt t) in I at 1 by ring.
replace T with (sqrt t * (T / sqrt t - 1) + sqrt t) in I at 1 by (field; lra).
apply (is_RInt_comp_lin (kernel (- b - 1) t) (sqrt t) (sqrt t) (-1 + rho) (T / sqrt t - 1)) in I.
apply (is_RInt_unique (V := R_CompleteNormedModule)) in I. unfold M. rewrite <- I.
apply (is_RInt_unique (V := R_CompleteNormedModule)).
apply (is_RInt_ext (fun u => scal K (saddle_integrand lambda (- b - 1) u))).
- intros u Hu. rewrite Rmin_left in Hu by lra.
  change (K * (Rpower (1 + u) (- b - 1) * exp (- (lambda * saddle u ^ 2)))
    = sqrt t * (Rpower (sqrt t * u + sqrt t) (- b - 1) * exp ((sqrt t * u + sqrt t) * t - (sqrt t * u
      + sqrt t) ^ 3 / 3))).
  replace (sqrt t * u + sqrt t) with (sqrt t * (1 + u)) by ring.
  rewrite <- Rpower_mult_distr by lra. rewrite saddle_square by lra.
  assert (E1 : sqrt t * (Rpower (sqrt t) (- b - 1)) = Rpower t (- b / 2)).
  { rewrite <- Rpower_S by auto. rewrite <- (Rpower_sqrt t) at 1 by auto. rewrite Rpower_mult. f_equal. field. }
  assert (E2 : exp (sqrt t * (1 + u) * t - (sqrt t * (1 + u)) ^ 3 / 3)
    = exp (2 * lambda / 3) * exp (- (lambda * (u ^ 2 + u ^ 3 / 3)))).
  { rewrite <- exp_plus. f_equal. unfold lambda.
    replace ((sqrt t * (1 + u)) ^ 3) with (sqrt t * sqrt t * sqrt t * (1 + u) ^ 3) by ring. rewrite R1. field. }
  rewrite E2. unfold K. rewrite <- E1. ring.
- apply (is_RInt_scal (saddle_integrand lambda (- b - 1)) _ _ K).
  apply (RInt_correct (saddle_integrand lambda (- b - 1))), integrand_ex; lra.
Qed.
End Remainder.

(** The coefficients. *)
Lemma saddle_coefficient_lagrange b k :
  rising (1 / 2) k * lagrange_coefficient (- b - 1) (2 * k) = saddle_coefficient b k.
Proof.
unfold saddle_coefficient, lagrange_coefficient, PS_mult. f_equal. rewrite sum_first_sum_f.
replace (INR (2 * k + 1) / 2) with (INR k + 1 / 2) by (rewrite plus_INR, mult_INR; simpl; field).
replace (- (- b - 1)) with (b + 1) by ring.
assert (E : forall n, (n <= S (2 * k))%nat -> sum_first (fun j => scaled_term (INR k + 1 / 2) (- / 3) j
  * scaled_term (b + 1) (-1) (2 * k - j)) n = sum_first (fun j => rising (b + 1) (2 * k - j) / INR (fact (2 * k - j))
    * (rising (INR k + 1 / 2) j / (3 ^ j * INR (fact j)))) n); [|apply E; lia].
induction n as [|n IH]; intros Hn; cbn [sum_first]; [reflexivity|]. rewrite IH by lia. f_equal.
unfold scaled_term, rising_term.
assert (S : (- / 3) ^ n * (-1) ^ (2 * k - n) = / 3 ^ n).
{ replace (- / 3) with (-1 * / 3) by ring. rewrite Rpow_mult_distr, pow_inv.
  replace ((-1) ^ n * / 3 ^ n * (-1) ^ (2 * k - n)) with ((-1) ^ n * (-1) ^ (2 * k - n) * / 3 ^ n) by ring.
  rewrite <- pow_add. replace (n + (2 * k - n))%nat with (2 * k)%nat by lia.
  rewrite pow_mult. replace ((-1) ^ 2) with 1 by ring. rewrite pow1. ring. }
match goal with |- ?l = _ => replace l with (rising (b + 1) (2 * k - n) / INR (fact (2 * k - n))
  * (rising (INR k + 1 / 2) n / INR (fact n)) * ((- / 3) ^ n * (-1) ^ (2 * k - n))) by ring end.
rewrite S. field. repeat split; try apply INR_fact_neq_0. apply pow_nonzero; lra.
Qed.

Lemma gauss_whole_power lambda k : 0 < lambda ->
  gauss_whole lambda k = Gamma (INR k + 1 / 2) / lambda ^ k / sqrt lambda.
Proof.
intros Hl. unfold gauss_whole. rewrite Rpower_Ropp, Rpower_plus, Rpower_pow by exact Hl.
replace (1 / 2) with (/ 2) by field. rewrite Rpower_sqrt by exact Hl. field.
split; [apply pow_nonzero; lra|apply Rgt_not_eq, sqrt_lt_R0, Hl].
Qed.

Lemma Gamma_half_shift k : Gamma (INR k + 1 / 2) = rising (1 / 2) k * Gamma (1 / 2).
Proof.
rewrite Rplus_comm. apply Gamma_rising. intros n. generalize (pos_INR n). lra.
Qed.

Lemma main_sum b lambda (a : nat -> R) N : 0 < lambda -> (forall n, a n = lagrange_coefficient (- b - 1) n) ->
  sum_first (fun k => a (2 * k)%nat * gauss_whole lambda k) N
    = sqrt PI / sqrt lambda * sum_first (fun k => saddle_coefficient b k / lambda ^ k) N.
Proof.
intros Hl Ha. rewrite <- sum_first_scal. apply sum_first_ext. intros k.
rewrite Ha, gauss_whole_power, Gamma_half_shift, Gamma_half, <- saddle_coefficient_lagrange by exact Hl.
field. split; [apply pow_nonzero; lra|apply Rgt_not_eq, sqrt_lt_R0, Hl].
Qed.

(** The whole error of [saddle_integral] in the words of the statement. *)
Lemma error_sum b lambda eta rho N m : 0 < lambda -> 0 < eta < 1 ->
  let sigma := saddle_radius eta in let B := saddle_bound eta (- b - 1) m in let p := Rmax 0 (- b - 1) in
  B / sigma ^ (2 * N) * gauss_whole lambda N + 2 * B * exp (- (lambda * sigma ^ 2)) / (lambda * sigma)
    + exp (p * sigma - lambda * sigma ^ 2) / (2 * lambda * sigma - p)
    + Rmax 1 (Rpower rho (- b - 1)) * exp (- (lambda * sigma ^ 2)) = saddle_error b lambda eta rho N m.
Proof.
intros Hl He sigma B p. assert (P := radius_pos eta He). unfold saddle_error. fold (saddle_radius eta).
fold (saddle_bound eta (- b - 1) m). fold sigma B p. do 3 f_equal.
rewrite gauss_whole_power, Rpow_mult_distr, <- pow_mult by exact Hl. field.
repeat split; try (apply pow_nonzero; unfold sigma; lra). apply Rgt_not_eq, sqrt_lt_R0, Hl.
Qed.

Theorem saddle_remainder : Statement.saddle_remainder.
Proof.
intros b theta t eta rho N m A Hb Htheta Ht Heta Hrho Hm HA Hfar lambda sigma HN Hp near K.
destruct (root_t t Ht) as [R0 R1]. assert (Hl := lambda_pos t Ht). fold lambda in Hl.
set (x := rho * sqrt t). assert (Hx : 0 < x) by (apply Rmult_lt_0_compat; lra).
assert (He : forall n, INR n + - b <> 0) by (intros n H; apply (Hb n); lra).
(* the finite part *)
assert (L := theta_finite_part b theta Hb Htheta 0 t x Hx). unfold finite_part_holds in L. simpl in L.
replace (0 - b - 1) with (- b - 1) in L by ring. replace (0 - b) with (- b) in L by ring.
assert (F := finite_part_rest t (- b) x A Hx HA He Hfar).
(* the integral *)
destruct (saddle_series eta Heta (- b - 1) m Hm) as (a & Ha & Hs).
assert (Hlag := lagrange eta (- b - 1) _ a Heta Ha Hs).
assert (I : forall T, x + sqrt t * (1 + eta) <= T ->
  Rabs (M (- b - 1) x T t - K * (sqrt PI / sqrt lambda * sum_first (fun k => saddle_coefficient b k / lambda ^ k) N))
    <= K * saddle_error b lambda eta rho N m).
{ intros T HT. assert (PK : 0 < K) by (apply Rmult_lt_0_compat; apply exp_pos).
  assert (P2 : 0 < sqrt t * (1 + eta)) by (apply Rmult_lt_0_compat; lra).
  unfold x. rewrite (saddle_substitution b t Ht rho T) by (fold x; lra). fold lambda K.
  rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq K) by lra. apply Rmult_le_compat_l; [lra|].
  rewrite <- (main_sum b lambda a N Hl Hlag), <- error_sum by auto.
  apply (saddle_integral eta rho lambda (- b - 1) _ N a Heta Hrho Hl HN Hp Ha Hs).
  apply Rmult_le_reg_r with (sqrt t); auto. unfold Rdiv.
  rewrite Rmult_minus_distr_r, Rmult_assoc, Rinv_l by lra. lra. }
assert (J := limit_within _ _ _ _ L (ex_intro _ _ I)).
(* together *)
assert (E5 : exp (Rabs t * x + x ^ 3 / 3) = exp (lambda * (rho + rho ^ 3 / 3))).
{ f_equal. rewrite Rabs_pos_eq by lra. unfold x, lambda.
  replace ((rho * sqrt t) ^ 3) with (rho ^ 3 * (sqrt t * sqrt t * sqrt t)) by ring. rewrite R1. field. }
rewrite E5 in F.
assert (E : fold_right Rplus 0 (map near A) = listed A (fun n => cubic_term t n / (INR n + - b) * Rpower x (INR n
  + - b))).
{ unfold listed. f_equal. apply map_ext. intros n. unfold near, cubic_term. rewrite Poly_Pn. reflexivity. }
rewrite E. fold x in J |- *.
match goal with |- Rabs (?g - ?l - ?s) <= _ => match type of J with Rabs (?g' - ?f - _) <= _ =>
  replace (g - l - s) with ((g' - f - s) + (f - l)) by ring end end.
eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; auto.
Qed.
