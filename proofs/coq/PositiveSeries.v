(** * The asymptotic series for t -> +oo, to every order

    [saddle_remainder] with eta = rho = 1/2 and all n < n0 in A. E_1 is of the order lambda^(-N-1/2); all else has a
    factor e^(-q lambda), q >= 1/8, beside a power of lambda. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus GammaFunction PowerSeriesNorm IntegerPolynomials PolynomialSum BinomialSeries
  SaddleInverse FinitePart SaddleRemainder.
From GSpot Require Import Statement.
Import ListNotations.
Open Scope R_scope.

Lemma power_below_exp n y : 0 <= y -> y ^ n <= INR (fact n) * exp y.
Proof.
intros Hy. assert (P : forall k, 0 < / INR (fact k)) by (intros; apply Rinv_0_lt_compat, lt_0_INR, lt_O_fact).
assert (Sum := sum_at_most (fun k => / INR (fact k)) y (exp y) (S n) (fun k => Rlt_le _ _ (P k)) Hy (is_exp_Reals y)).
assert (N := sum_first_nonneg (fun k => / INR (fact k) * y ^ k) n
  (fun k => Rmult_le_pos _ _ (Rlt_le _ _ (P k)) (pow_le y k Hy))).
cbn [sum_first] in Sum. assert (F := lt_0_INR _ (lt_O_fact n)).
apply Rmult_le_reg_l with (/ INR (fact n)); [apply P|]. rewrite <- Rmult_assoc, Rinv_l, Rmult_1_l; lra.
Qed.

(** sqrt lambda e^(-lambda/8) is of every order. *)
Lemma exponentially_small lambda N : 1 <= lambda ->
  sqrt lambda * exp (- (lambda / 8)) <= 8 ^ S N * INR (fact (S N)) / lambda ^ N.
Proof.
intros Hl. assert (PN : 0 < lambda ^ N) by (apply pow_lt; lra).
assert (B := power_below_exp (S N) (lambda / 8) ltac:(lra)).
assert (Root : sqrt lambda <= lambda).
{ rewrite <- (sqrt_square lambda) at 2 by lra. apply sqrt_le_1_alt. nra. }
assert (E : exp (lambda / 8) * exp (- (lambda / 8)) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
assert (X := exp_pos (- (lambda / 8))). apply Rmult_le_reg_r with (lambda ^ N); auto.
replace (8 ^ S N * INR (fact (S N)) / lambda ^ N * lambda ^ N) with (8 ^ S N * INR (fact (S N))) by (field; lra).
apply Rle_trans with (lambda ^ S N * exp (- (lambda / 8))).
- simpl. rewrite (Rmult_comm _ (lambda ^ N)), <- Rmult_assoc, (Rmult_comm lambda). apply Rmult_le_compat_r; [lra|].
  apply Rmult_le_compat_l; lra.
- rewrite pow_quotient in B. apply (Rmult_le_compat_l (8 ^ S N)) in B; [|apply pow_le; lra].
  replace (8 ^ S N * (lambda ^ S N / 8 ^ S N)) with (lambda ^ S N) in B by (field; apply pow_nonzero; lra).
  apply Rle_trans with (8 ^ S N * (INR (fact (S N)) * exp (lambda / 8)) * exp (- (lambda / 8))).
  apply Rmult_le_compat_r; lra. right.
  replace (8 ^ S N * (INR (fact (S N)) * exp (lambda / 8)) * exp (- (lambda / 8)))
    with (8 ^ S N * INR (fact (S N)) * (exp (lambda / 8) * exp (- (lambda / 8)))) by ring. rewrite E. ring.
Qed.

Lemma near_bound t b x A : 0 < x -> Rabs (listed A (fun n => cubic_term t n / (INR n + - b) * Rpower x (INR n + - b)))
  <= listed A (fun n => Rabs (/ (INR n + - b))) * (Rpower x (- b) * exp (Rabs t * x + x ^ 3 / 3)).
Proof.
intros Hx. destruct (cubic_series t x Hx) as [HN _].
induction A as [|n A IH]; unfold listed in *; cbn [map fold_right]; [rewrite Rabs_R0; lra|].
eapply Rle_trans; [apply Rabs_triang|]. rewrite Rmult_plus_distr_r. apply Rplus_le_compat; auto.
assert (T := term_bound _ _ _ Hx HN n). assert (P : 0 < Rpower x (- b)) by apply exp_pos.
assert (Q : 0 < x ^ n) by (apply pow_lt, Hx).
rewrite Rpower_plus, Rpower_pow by exact Hx. unfold Rdiv. rewrite !Rabs_mult, (Rabs_pos_eq (x ^ n)), (Rabs_pos_eq
  (Rpower x (- b))) by lra.
replace (Rabs (cubic_term t n) * Rabs (/ (INR n + - b)) * (x ^ n * Rpower x (- b)))
  with (Rabs (/ (INR n + - b)) * (Rpower x (- b) * (Rabs (cubic_term t n) * x ^ n))) by ring.
apply Rmult_le_compat_l; [apply Rabs_pos|]. apply Rmult_le_compat_l; lra.
Qed.

Lemma error_bound b N m : exists C, 0 <= C /\ forall lambda, 1 <= lambda -> Rmax 0 (- b - 1) + 1 <= 2 * lambda
  * (1 / 2 * sqrt (1 - 1 / 2 / 3)) -> sqrt lambda * saddle_error b lambda (1 / 2) (1 / 2) N m <= C / lambda ^ N.
Proof.
set (sigma := 1 / 2 * sqrt (1 - 1 / 2 / 3)). set (p := Rmax 0 (- b - 1)).
assert (R0 : 0 < sqrt (1 - 1 / 2 / 3)) by (apply sqrt_lt_R0; lra).
assert (S2 : sigma ^ 2 = 5 / 24).
{ unfold sigma. rewrite Rpow_mult_distr, pow2_sqrt by lra. field. }
assert (S0 : 0 < sigma) by (unfold sigma; lra).
assert (S1 : sqrt (1 - 1 / 2 / 3) <= 1) by (rewrite <- sqrt_1 at 3; apply sqrt_le_1_alt; lra).
set (B := (1 + 1 / 2) ^ m * Rpower (1 - 1 / 2) (- b - 1 - INR m) * (2 - sqrt (1 - 1 / 2 / 3)) / (1 - 1 / 2 / 2)).
assert (PB : 0 < B).
{ unfold B. repeat apply Rmult_lt_0_compat; try (apply pow_lt; lra); try apply exp_pos; try lra. }
assert (PG : 0 < Gamma (INR N + 1 / 2)) by (apply Gamma_pos; generalize (pos_INR N); lra).
set (L := Rmax 1 (Rpower (1 / 2) (- b - 1))). assert (PL : 1 <= L) by apply Rmax_l.
set (D := 8 ^ S N * INR (fact (S N))).
assert (PD : 0 < D) by (apply Rmult_lt_0_compat; [apply pow_lt; lra|apply lt_0_INR, lt_O_fact]).
assert (PS : 0 < (5 / 24) ^ N) by (apply pow_lt; lra).
assert (PP := exp_pos (p * sigma)).
assert (P1 : 0 < B * Gamma (INR N + 1 / 2) / (5 / 24) ^ N).
{ apply Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat; auto. }
assert (P2 : 0 < 2 * B / sigma) by (apply Rdiv_lt_0_compat; lra).
assert (P3 : 0 <= (2 * B / sigma + exp (p * sigma) + L) * D) by (apply Rmult_le_pos; lra).
exists (B * Gamma (INR N + 1 / 2) / (5 / 24) ^ N + (2 * B / sigma + exp (p * sigma) + L) * D).
split; [lra|]. intros lambda Hl Hp.
unfold saddle_error. fold sigma p B L. rewrite S2.
assert (Q0 : 1 <= sqrt lambda) by (rewrite <- sqrt_1; apply sqrt_le_1_alt; lra).
assert (QQ : sqrt lambda * sqrt lambda = lambda) by (apply sqrt_sqrt; lra).
assert (PN : 0 < lambda ^ N) by (apply pow_lt; lra).
set (small := exp (- (lambda * (5 / 24)))).
assert (Sm : sqrt lambda * small <= D / lambda ^ N).
{ eapply Rle_trans; [|apply (exponentially_small lambda N Hl)]. apply Rmult_le_compat_l; [lra|]. apply exp_le. lra. }
assert (PSm : 0 < small) by apply exp_pos.
assert (E3 : exp (p * sigma - lambda * (5 / 24)) = exp (p * sigma) * small).
{ unfold small. rewrite <- exp_plus. f_equal. }
rewrite E3. set (K := 2 * lambda * sigma - p).
assert (PK : 1 <= K) by (unfold K; lra).
rewrite !Rmult_plus_distr_l.
replace ((B * Gamma (INR N + 1 / 2) / (5 / 24) ^ N + (2 * B / sigma + exp (p * sigma) + L) * D) / lambda ^ N)
  with (B * Gamma (INR N + 1 / 2) / (5 / 24) ^ N / lambda ^ N + 2 * B / sigma * (D / lambda ^ N)
    + exp (p * sigma) * (D / lambda ^ N) + L * (D / lambda ^ N)) by (field; repeat split; lra).
apply Rplus_le_compat; [apply Rplus_le_compat; [apply Rplus_le_compat|]|].
- right. rewrite Rpow_mult_distr. field. repeat split; lra.
- apply Rle_trans with (2 * B / sigma * (sqrt lambda * small)); [|apply Rmult_le_compat_l; lra].
  replace (sqrt lambda * (2 * B * small / (lambda * sigma))) with (2 * B / sigma * (sqrt lambda * small) * / lambda)
    by (field; lra).
  rewrite <- (Rmult_1_r (2 * B / sigma * (sqrt lambda * small))) at 2. apply Rmult_le_compat_l.
  + apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra].
  + rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
- apply Rle_trans with (exp (p * sigma) * (sqrt lambda * small)); [|apply Rmult_le_compat_l; lra].
  replace (sqrt lambda * (exp (p * sigma) * small / K)) with (exp (p * sigma) * (sqrt lambda * small) * / K)
    by (field; lra).
  rewrite <- (Rmult_1_r (exp (p * sigma) * (sqrt lambda * small))) at 2. apply Rmult_le_compat_l.
  + apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra].
  + rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
- apply Rle_trans with (L * (sqrt lambda * small)); [right; ring|apply Rmult_le_compat_l; lra].
Qed.

(** Plan: A holds all n < n0, so that |n - b| >= 1/2 beyond. The remainder (X), the terms of A (NB) and E_5 all are K
    times a function of lambda (EK); divided by the leading term, E_1 to E_4 are at most C/lambda^N ([error_bound]), and
    the others W sqrt lambda e^(-lambda/8). *)
Theorem positive_series : Statement.positive_series.
Proof.
intros b theta N Hb Htheta.
destruct (nfloor_ex (Rabs b + 1)) as (m & _ & Hm). { generalize (Rabs_pos b); lra. }
set (n0 := S (S m)). set (A := seq 0 n0).
assert (Hfar : forall n, ~ In n A -> 1 / 2 <= Rabs (INR n - b)).
{ intros n Hn. assert (Hn' : (n0 <= n)%nat) by (apply Nat.nlt_ge; intros H; apply Hn, in_seq; lia).
  apply le_INR in Hn'. unfold n0 in Hn'. rewrite !S_INR in Hn'. generalize (Rle_abs b) (Rle_abs (INR n - b)). lra. }
assert (Hm' : - b - 1 <= INR (S m)) by (rewrite S_INR; generalize (Rle_abs (- b)); rewrite Rabs_Ropp; lra).
destruct (error_bound b N (S m)) as (C & HC & HE).
set (sigma := 1 / 2 * sqrt (1 - 1 / 2 / 3)) in HE. set (p := Rmax 0 (- b - 1)) in HE.
assert (S0 : 0 < sigma) by (apply Rmult_lt_0_compat; [lra|apply sqrt_lt_R0; lra]).
set (D := 8 ^ S N * INR (fact (S N))).
set (W := (2 + listed A (fun n => Rabs (/ (INR n + - b)))) * Rpower (1 / 2) (- b)).
exists ((C + W * D) / sqrt PI), (Rmax 1 (Rmax (INR (2 * N) / sigma ^ 2) ((p + 1) / (2 * sigma)))).
intros t HT lambda.
assert (T1 := Rmax_l 1 (Rmax (INR (2 * N) / sigma ^ 2) ((p + 1) / (2 * sigma)))).
assert (T2 := Rmax_r 1 (Rmax (INR (2 * N) / sigma ^ 2) ((p + 1) / (2 * sigma)))).
assert (T3 := Rmax_l (INR (2 * N) / sigma ^ 2) ((p + 1) / (2 * sigma))).
assert (T4 := Rmax_r (INR (2 * N) / sigma ^ 2) ((p + 1) / (2 * sigma))).
assert (Q1 : 1 <= sqrt t) by (rewrite <- sqrt_1; apply sqrt_le_1_alt; lra).
assert (QQ : sqrt t * sqrt t = t) by (apply sqrt_sqrt; lra).
assert (Hl : t <= lambda) by (unfold lambda; nra).
assert (PSg : 0 < sigma ^ 2) by (apply pow_lt, S0).
assert (H1 : INR (2 * N) <= lambda * sigma ^ 2).
{ replace (INR (2 * N)) with (INR (2 * N) / sigma ^ 2 * sigma ^ 2) by (field; lra). apply Rmult_le_compat_r; lra. }
assert (H2 : p + 1 <= 2 * lambda * sigma).
{ replace (p + 1) with ((p + 1) / (2 * sigma) * (2 * sigma)) by (field; lra).
  replace (2 * lambda * sigma) with (lambda * (2 * sigma)) by ring. apply Rmult_le_compat_r; lra. }
assert (X := SaddleRemainder.saddle_remainder b theta t (1 / 2) (1 / 2) N (S m) A Hb Htheta ltac:(lra) ltac:(lra)
  ltac:(lra) Hm' (seq_NoDup n0 0) Hfar H1 ltac:(fold lambda sigma p; lra)). cbv zeta in X. fold lambda in X.
set (K := Rpower t (- b / 2) * exp (2 * lambda / 3)) in *. set (x := 1 / 2 * sqrt t) in *.
assert (PK : 0 < K) by (apply Rmult_lt_0_compat; apply exp_pos).
set (G := Gamma (- b) * theta t) in *. set (Sum := sum_first (fun k => saddle_coefficient b k / lambda ^ k) N) in *.
assert (Near : fold_right Rplus 0 (map (fun n => (-1) ^ n * Poly n t / INR (fact n) / (INR n - b)
  * Rpower x (INR n - b)) A) = listed A (fun n => cubic_term t n / (INR n + - b) * Rpower x (INR n + - b))).
{ unfold listed. f_equal. apply map_ext. intros n. unfold cubic_term. rewrite Poly_Pn. reflexivity. }
rewrite Near in X. set (near := listed A _) in X.
assert (Hx : 0 < x) by (unfold x; lra).
assert (NB := near_bound t b x A Hx). fold near in NB.
assert (E5 : Rabs t * x + x ^ 3 / 3 = lambda * (1 / 2 + (1 / 2) ^ 3 / 3)).
{ rewrite Rabs_pos_eq by lra. unfold x, lambda.
  replace ((1 / 2 * sqrt t) ^ 3) with ((1 / 2) ^ 3 * (sqrt t * sqrt t * sqrt t)) by ring. rewrite QQ. field. }
rewrite E5 in NB.
assert (EK : Rpower x (- b) * exp (lambda * (1 / 2 + (1 / 2) ^ 3 / 3))
  = K * (Rpower (1 / 2) (- b) * exp (- (lambda / 8)))).
{ unfold K, x. rewrite <- Rpower_mult_distr by lra.
  replace (Rpower (sqrt t) (- b)) with (Rpower t (- b / 2)).
  2: { rewrite <- (Rpower_sqrt t), Rpower_mult by lra. f_equal. field. }
  replace (lambda * (1 / 2 + (1 / 2) ^ 3 / 3)) with (2 * lambda / 3 + - (lambda / 8)) by field.
  rewrite exp_plus. ring. }
rewrite Rmult_assoc, EK in X. rewrite EK in NB.
assert (SL : 0 < sqrt lambda) by (apply sqrt_lt_R0; lra). assert (SP : 0 < sqrt PI) by (apply sqrt_lt_R0, PI_RGT_0).
replace (G / (K * (sqrt PI / sqrt lambda)) - Sum)
  with ((G - K * (sqrt PI / sqrt lambda * Sum)) * (sqrt lambda / sqrt PI / K)) by (field; repeat split; lra).
assert (P0 : 0 < sqrt lambda / sqrt PI / K) by (repeat apply Rdiv_lt_0_compat; lra).
rewrite Rabs_mult, (Rabs_pos_eq _ (Rlt_le _ _ P0)).
set (w := Rpower (1 / 2) (- b)) in *. set (small := exp (- (lambda / 8))) in *.
set (err := saddle_error b lambda (1 / 2) (1 / 2) N (S m)) in *.
assert (Y : Rabs (G - K * (sqrt PI / sqrt lambda * Sum)) <= K * (err + W * small)).
{ replace (G - K * (sqrt PI / sqrt lambda * Sum)) with ((G - near - K * (sqrt PI / sqrt lambda * Sum)) + near) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. unfold W. lra. }
apply Rle_trans with (K * (err + W * small) * (sqrt lambda / sqrt PI / K)). apply Rmult_le_compat_r; lra.
assert (Em := exponentially_small lambda N ltac:(lra)). fold D small in Em.
specialize (HE lambda ltac:(lra) H2). fold err in HE.
assert (PW : 0 <= W).
{ unfold W. apply Rmult_le_pos; [|apply Rlt_le, exp_pos].
  assert (0 <= listed A (fun n => Rabs (/ (INR n + - b)))); [|lra].
  generalize A. induction A0 as [|n l IH]; unfold listed in *; cbn [map fold_right]. lra.
  generalize (Rabs_pos (/ (INR n + - b))). lra. }
assert (PN : 0 < lambda ^ N) by (apply pow_lt; lra).
replace (K * (err + W * small) * (sqrt lambda / sqrt PI / K))
  with ((sqrt lambda * err + W * (sqrt lambda * small)) * / sqrt PI) by (field; lra).
replace ((C + W * D) / sqrt PI / lambda ^ N) with ((C / lambda ^ N + W * (D / lambda ^ N)) * / sqrt PI) by (field; lra).
apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, SP|]. apply Rplus_le_compat; auto.
apply Rmult_le_compat_l; auto.
Qed.
