(** * The compliant model: the series in eta on Theta, with its remainder (Theorem B)

    proofs/epsilon_series.md. Let E_k = Gamma(-b) (G - P)^(k), P the part of the series below eta^N. Where the integrals
    converge (k > b) the bound is that of [series_remainder] under the integral. For smaller k: the moment recurrence of
    G, applied to E, leaves over only - eta^N sum c_(N,m) (N + 3m) Gamma(-b) Theta^(k+N+3m) ([series_operator]), hence
    E_k(-x) = O(x^-(k-b+N+3)) for every k, from its own bound where the integrals converge downwards. So (bound) - E and
    (bound) + E tend to 0 as t -> -oo for k > b - N - 3, and are >= 0 as their derivatives are. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral ImproperIntegral
  EnvelopingSeries Family Ends CompliantKernel CompliantIntegral
  CompliantSlow LeftExpansion CompliantMonotone EtaSeries.
Open Scope R_scope.

Section Series.
Variables (b : R) (theta : R -> R) (eta : R).
Hypothesis Hb : not_nat b.
Hypothesis HT : is_Theta b theta.
Hypothesis He : 0 < eta.
Let s : R := - b - 1.
Let f := scaled b theta.
Let g := scaled_J eta s.

Let Hs : ok s := ok_not_nat b Hb.
Let Hf : family 0 s f := scaled_family b theta Hb HT.
Let Hg : family eta s g := scaled_J_family eta He s Hs.

Lemma theta_integral k t : -1 < s + INR k ->
  is_RInt_gen (fun r => Rpower r (s + INR k) * exp (- (r ^ 3 / 3) + r * t)) (at_right 0) (Rbar_locally p_infty)
    (scaled b theta k t).
Proof.
intros Hk. unfold s in Hk. assert (H := Theta_representation b theta k Hb ltac:(lra) HT t).
eapply improper_ext; [|exact H]. intros r Hr. simpl.
replace (INR k - b - 1) with (s + INR k) by (unfold s; ring). f_equal. f_equal. unfold Rminus; ring.
Qed.

(** The measure r^(s+k) e^(-r^3/3 + rt) dr: each x_i times it, x_i = r^i or r^i e^h, is a member of a family. *)
Definition measure (k : nat) (t r : R) : R := Rpower r (s + INR k) * exp (- (r ^ 3 / 3) + r * t).

Lemma measure_pos k t r : 0 < measure k t r.
Proof. apply Rmult_lt_0_compat; apply exp_pos. Qed.

Lemma index_valid k i : -1 < s + INR k -> -1 < s + INR (k + i).
Proof. intros H. rewrite plus_INR. assert (A := pos_INR i). lra. Qed.

Lemma theta_moment k i t : -1 < s + INR k ->
  is_RInt_gen (fun r => measure k t r * r ^ i) (at_right 0) (Rbar_locally p_infty) (f (k + i)%nat t).
Proof.
intros Hk. eapply improper_ext; [|exact (theta_integral (k + i) t (index_valid k i Hk))]. intros r Hr. unfold measure.
cbv beta.
rewrite (Rpower_split r (s + INR (k + i)) i (s + INR k)) by (auto; rewrite plus_INR; ring). ring.
Qed.

Lemma slow_moment k i t : -1 < s + INR k ->
  is_RInt_gen (fun r => measure k t r * (r ^ i * exp (exponent eta r))) (at_right 0) (Rbar_locally p_infty)
    (g (k + i)%nat t).
Proof.
intros Hk. eapply improper_ext; [|exact (scaled_J_integral eta He s (k + i) t (index_valid k i Hk))]. intros r Hr.
unfold measure. cbv beta.
rewrite (Rpower_split r (s + INR (k + i)) i (s + INR k)) by (auto; rewrite plus_INR; ring).
replace (weight_exponent eta r + r * t) with (- (r ^ 3 / 3) + r * t + exponent eta r) by (unfold exponent; ring).
rewrite !exp_plus. ring.
Qed.

Lemma slow_integral_measure k t : -1 < s + INR k ->
  is_RInt_gen (fun r => measure k t r * exp (exponent eta r)) (at_right 0) (Rbar_locally p_infty) (g k t).
Proof.
intros Hk. assert (H := slow_moment k 0 t Hk). rewrite Nat.add_0_r in H. eapply improper_ext; [|exact H]. intros r _.
simpl. ring.
Qed.

Lemma theta_small k i : small (s + INR k + INR i + 1) (fun x => f (k + i)%nat (- x)).
Proof. replace (s + INR k + INR i + 1) with (s + INR (k + i) + 1) by (rewrite plus_INR; ring).
apply (left_small s 0 f Hs Hf). Qed.

Lemma slow_small k i : small (s + INR k + INR i + 1) (fun x => g (k + i)%nat (- x)).
Proof. replace (s + INR k + INR i + 1) with (s + INR (k + i) + 1) by (rewrite plus_INR; ring).
apply (left_small s eta g Hs Hg). Qed.

Section Order.
Variable N : nat.
Hypothesis HN : (1 <= N)%nat.

Definition series_excess (k : nat) (t : R) : R := g k t - eta_series eta N (fun i => f (k + i)%nat t).
Definition series_bound (k : nat) (t : R) : R := remainder_bound eta N (fun i => g (k + i)%nat t).
Let E := series_excess.
Let B := series_bound.

Lemma excess_derive k t : is_derive (E k) t (E (S k) t).
Proof.
apply (is_derive_minus (g k) (fun t => eta_series eta N (fun i => f (k + i)%nat t))). apply Hg.
apply (series_derive eta N (fun i => f (k + i)%nat)). intros i. apply Hf.
Qed.

Lemma bound_derive k t : is_derive (B k) t (B (S k) t).
Proof.
apply (is_derive_scal (fun t => sum_first (fun m => Rabs (series_coefficient N m) * g (k + (N + 3 * m))%nat t) (S N))).
apply (sum_first_derive (fun m t => Rabs (series_coefficient N m) * g (k + (N + 3 * m))%nat t)
  (fun m => Rabs (series_coefficient N m) * g (S k + (N + 3 * m))%nat t)).
intros m. apply (is_derive_scal (g (k + (N + 3 * m))%nat)). apply Hg.
Qed.

(** Where the integrals converge *)
Lemma excess_within_bound k t : -1 < s + INR k -> Rabs (E k t) <= B k t.
Proof.
intros Hk.
assert (IB : is_RInt_gen (fun r => measure k t r * remainder_bound eta N (fun i => r ^ i * exp (exponent eta r)))
  (at_right 0) (Rbar_locally p_infty) (B k t)).
{ assert (I := is_RInt_gen_scal _ (eta ^ N) _ (sum_first_integral
    (fun m r => Rabs (series_coefficient N m) * (measure k t r * (r ^ (N + 3 * m) * exp (exponent eta r))))
    (fun m => Rabs (series_coefficient N m) * g (k + (N + 3 * m))%nat t) (S N)
    (fun m => is_RInt_gen_scal _ (Rabs (series_coefficient N m)) _ (slow_moment k (N + 3 * m) t Hk)))).
  eapply improper_ext; [|exact I]. intros r _. unfold scal; simpl; unfold mult; simpl. unfold remainder_bound.
  change (eta ^ N * sum_first (fun m =>
    Rabs (series_coefficient N m) * (measure k t r * (r ^ (N + 3 * m) * exp (exponent eta r)))) (S N)
    = measure k t r * (eta ^ N * sum_first (fun m =>
      Rabs (series_coefficient N m) * (r ^ (N + 3 * m) * exp (exponent eta r))) (S N))).
  rewrite <- Rmult_assoc, (Rmult_comm (measure k t r)), Rmult_assoc, <- (sum_first_scal (measure k t r)). f_equal.
  apply sum_first_ext. intros m. ring. }
assert (IE : is_RInt_gen (fun r => measure k t r * (exp (exponent eta r) - eta_series eta N (fun i => r ^ i)))
  (at_right 0) (Rbar_locally p_infty) (E k t)).
{ assert (I := is_RInt_gen_minus _ _ _ _ (slow_integral_measure k t Hk) (sum_first_integral
    (fun j r => eta ^ j * sum_first (fun m => series_coefficient j m * (measure k t r * r ^ (j + 3 * m))) (S j))
    (fun j => eta ^ j * sum_first (fun m => series_coefficient j m * f (k + (j + 3 * m))%nat t) (S j)) N
    (fun j => is_RInt_gen_scal _ (eta ^ j) _ (sum_first_integral
      (fun m r => series_coefficient j m * (measure k t r * r ^ (j + 3 * m))) (fun m =>
        series_coefficient j m * f (k + (j + 3 * m))%nat t) (S j)
      (fun m => is_RInt_gen_scal _ (series_coefficient j m) _ (theta_moment k (j + 3 * m) t Hk)))))).
  eapply improper_ext; [|exact I]. intros r _. unfold minus, plus, opp; simpl.
  change (measure k t r * exp (exponent eta r) + - eta_series eta N (fun i => measure k t r * r ^ i)
    = measure k t r * (exp (exponent eta r) - eta_series eta N (fun i => r ^ i))).
  rewrite (series_scal eta N (measure k t r) (fun i => r ^ i)). ring. }
assert (W := fun r Hr => series_remainder eta N r HN He Hr).
apply Rabs_le. split.
- assert (I := is_RInt_gen_plus _ _ _ _ IB IE). apply improper_pos in I. unfold plus in I; simpl in I. lra.
  intros r Hr. unfold plus; simpl. rewrite <- Rmult_plus_distr_l. apply Rmult_le_pos. apply Rlt_le, measure_pos.
  specialize (W r Hr). apply Rabs_le_between in W. lra.
- eapply improper_le; [|exact IE|exact IB]. intros r Hr. apply Rmult_le_compat_l. apply Rlt_le, measure_pos.
  specialize (W r Hr). apply Rabs_le_between in W. lra.
Qed.

(** Towards t -> -oo *)
Lemma bound_small k : small (s + INR k + INR N + 4) (fun x => B k (- x)).
Proof.
apply (small_scal _ (eta ^ N) (fun x => sum_first (fun m => Rabs (series_coefficient N m) * g (k + (N + 3 * m))%nat
  (- x)) (S N))).
apply (sum_first_small _ (fun m x => Rabs (series_coefficient N m) * g (k + (N + 3 * m))%nat (- x))). intros m _.
destruct m as [|m].
- destruct N as [|N']; [lia|]. exists 0. intros x _. rewrite coefficient_0, Rabs_R0, Rmult_0_l, Rabs_R0. lra.
- apply small_scal. apply (small_weaken _ (3 * m)).
  replace (s + INR k + INR N + 4 + INR (3 * m)) with (s + INR k + INR (N + 3 * S m) + 1).
  apply slow_small. rewrite plus_INR, !mult_INR, (S_INR m). simpl (INR 3). ring.
Qed.

(** The moment recurrence and what it leaves over *)
Lemma excess_recurrence k t : let q := s + INR k in
  (q + 1) * E k t = - ((q + 2) * eta + t) * E (k + 1)%nat t - t * eta * E (k + 2)%nat t + E (k + 3)%nat t + eta / 2 * E
    (k + 4)%nat t
    - eta ^ N * sum_first (fun m => series_coefficient N m * (INR (N + 3 * m) * f (k + (N + 3 * m))%nat t)) (S N).
Proof.
intros q. assert (Hf' := Hf). destruct Hf' as (_ & Rf & _). assert (Hg' := Hg). destruct Hg' as (_ & Rg & _).
assert (G := Rg k t). cbv zeta in G. fold q in G.
assert (O := series_operator eta N (fun i => f (k + i)%nat t)).
set (rest := eta ^ N * sum_first _ (S N)) in O |- *.
assert (F : eta_series eta N (operator eta (fun i => f (k + i)%nat t))
  = - (q + 1) * eta_series eta N (fun i => f (k + i)%nat t) + - ((q + 2) * eta + t) * eta_series eta N (fun i =>
    f (k + 1 + i)%nat t)
    + - (t * eta) * eta_series eta N (fun i => f (k + 2 + i)%nat t) + 1 * eta_series eta N (fun i =>
          f (k + 3 + i)%nat t)
    + eta / 2 * eta_series eta N (fun i => f (k + 4 + i)%nat t)).
{ rewrite <- !series_scal, <- !series_plus. apply series_ext. intros i. unfold operator.
  assert (R0 := Rf (k + i)%nat t). assert (R1 := Rf (k + 1 + i)%nat t). cbv zeta in R0, R1.
  replace (s + INR (k + i)) with (q + INR i) in R0 by (unfold q; rewrite plus_INR; ring).
  replace (s + INR (k + 1 + i)) with (q + INR i + 1) in R1 by (unfold q; rewrite !plus_INR; simpl; ring).
  replace (k + (i + 1))%nat with (k + i + 1)%nat by lia. replace (k + (i + 4))%nat with (k + i + 4)%nat by lia.
  replace (k + 2 + i)%nat with (k + i + 2)%nat by lia. replace (k + 3 + i)%nat with (k + i + 3)%nat by lia.
  replace (k + 4 + i)%nat with (k + i + 4)%nat by lia.
  replace (k + 1 + i + 1)%nat with (k + i + 2)%nat in R1 by lia.
  replace (k + 1 + i + 3)%nat with (k + i + 4)%nat in R1 by lia.
  replace (k + 1 + i)%nat with (k + i + 1)%nat in R1 |- * by lia.
  apply (Rmult_eq_compat_l eta) in R1. lra. }
rewrite F in O. unfold E, series_excess. lra.
Qed.

Lemma series_excess_small k : small (s + INR k + INR N + 4) (fun x => E k (- x)).
Proof.
assert (H : forall n k, -1 < s + INR k + INR n -> small (s + INR k + INR N + 4) (fun x => E k (- x))).
{ induction n as [|n IH]; intros j Hj.
  - simpl in Hj. destruct (bound_small j) as [C H]. exists C. intros x Hx. specialize (H x Hx).
    assert (A := excess_within_bound j (- x) ltac:(lra)). assert (A' := Rle_abs (B j (- x))). lra.
  - rewrite S_INR in Hj. set (Q := s + INR j + INR N + 4).
    assert (L : forall i, (1 <= i)%nat -> small (Q + INR i) (fun x => E (j + i)%nat (- x))).
    { intros i Hi. replace (Q + INR i) with (s + INR (j + i) + INR N + 4) by (unfold Q; rewrite plus_INR; ring).
      apply IH. rewrite plus_INR. apply (le_INR 1) in Hi. simpl in Hi. lra. }
    assert (E1 := L 1%nat (le_n _)). assert (E2 := L 2%nat ltac:(lia)).
    assert (E3 := small_weaken _ _ _ (L 3%nat ltac:(lia))).
    assert (E4 := small_weaken _ _ _ (L 4%nat ltac:(lia))).
    assert (X1 := small_mult _ 1 _ E1). assert (W1 := small_weaken _ _ _ E1).
    assert (X2 : small Q (fun x => x ^ 1 * E (j + 2)%nat (- x))).
    { apply small_mult. apply (small_weaken _ 1). replace (Q + INR 1 + INR 1) with (Q + INR 2) by (simpl; ring).
      exact E2. }
    assert (Rest : small Q (fun x =>
      sum_first (fun m => series_coefficient N m * (INR (N + 3 * m) * f (j + (N + 3 * m))%nat (- x))) (S N))).
    { apply (sum_first_small _ (fun m x => series_coefficient N m * (INR (N + 3 * m) * f (j + (N + 3 * m))%nat (- x)))).
      intros m _.
      destruct m as [|m].
      - destruct N as [|N']; [lia|]. exists 0. intros x _. rewrite coefficient_0, Rmult_0_l, Rabs_R0. lra.
      - apply small_scal, small_scal. apply (small_weaken _ (3 * m)). unfold Q.
        replace (s + INR j + INR N + 4 + INR (3 * m)) with (s + INR j + INR (N + 3 * S m) + 1).
        apply theta_small. rewrite plus_INR, !mult_INR, (S_INR m). simpl (INR 3). ring. }
    set (q := s + INR j) in *. assert (Nq : q + 1 <> 0) by (intros Z; apply (ok_plus s j Hs 0%nat); simpl; fold q; lra).
    assert (S := small_scal _ (/ (q + 1)) _ (small_plus _ _ _
      (small_plus _ _ _ (small_plus _ _ _ (small_scal _ (- ((q + 2) * eta)) _ W1) X1)
        (small_plus _ _ _ (small_scal _ eta _ X2)
        (small_plus _ _ _ E3 (small_scal _ (eta / 2) _ E4))))
      (small_scal _ (- eta ^ N) _ Rest))).
    eapply small_ext; [|exact S]. intros x Hx. cbv beta.
    assert (R := excess_recurrence j (- x)). cbv zeta in R. fold q in R.
    apply (Rmult_eq_reg_l (q + 1)); auto. rewrite R, <- Rmult_assoc, Rinv_r by auto. simpl (x ^ 1). ring. }
destruct (ex_valid (s + INR k)) as [n Hn]. apply (H n k Hn).
Qed.

Theorem series_with_remainder n t : b < INR n + INR N + 3 -> Rabs (E n t) <= B n t.
Proof.
intros Hn. assert (Hn' : - (INR N + 4) < s + INR n) by (unfold s; lra).
assert (L : 0 <= B n t - E n t).
{ apply (chain_nonnegative s (- (INR N + 4)) (fun k t => B k t - E k t)); auto.
  - intros k u. apply (is_derive_minus (B k) (E k)); [apply bound_derive|apply excess_derive].
  - intros k _. replace (s + INR k - - (INR N + 4)) with (s + INR k + INR N + 4) by ring.
    apply (small_minus _ (fun x => B k (- x)) (fun x => E k (- x))); [apply bound_small|apply series_excess_small].
  - intros k u Hk. assert (A := excess_within_bound k u Hk). assert (A' := Rle_abs (E k u)). lra. }
assert (U : 0 <= B n t + E n t).
{ apply (chain_nonnegative s (- (INR N + 4)) (fun k t => B k t + E k t)); auto.
  - intros k u. apply (is_derive_plus (B k) (E k)); [apply bound_derive|apply excess_derive].
  - intros k _. replace (s + INR k - - (INR N + 4)) with (s + INR k + INR N + 4) by ring.
    apply (small_plus _ (fun x => B k (- x)) (fun x => E k (- x))); [apply bound_small|apply series_excess_small].
  - intros k u Hk. assert (A := excess_within_bound k u Hk). assert (A' := Rle_abs (- E k u)). rewrite Rabs_Ropp in A'.
    lra. }
apply Rabs_le. lra.
Qed.
End Order.
End Series.
