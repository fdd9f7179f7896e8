(** * The compliant model: Theorem C with any polynomial part

    proofs/monotone.md, section 3. P holds, for m = 1, ..., M, the terms k <= K_m of h^m/m!, K_m - m odd. e^h - P is the
    sum of what [ExponentPowers.v] leaves of h^m/m!, which is >= 0 and does not decrease with eta, and of e^h less its
    terms h^m/m!, m <= M, which increases strictly from 0. So where the integrals converge Gamma(-b) (G - P)^(n) is
    positive and increases with eta. As t -> -oo it differs from the excess of [CompliantSeries.v] with a large N by
    terms of order >= q only, where q <= 4 (M + 1) and q <= K_m + 1 + 3m: it is O(x^-(n-b+q)), and the inequality goes
    down to n > b - q. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral ImproperIntegral
  EnvelopingSeries Family Ends CompliantKernel CompliantIntegral
  CompliantSlow LeftExpansion CompliantMonotone EtaSeries ExponentPowers CompliantSeries.
Open Scope R_scope.

Definition polynomial_series (eta : R) (M : nat) (K : nat -> nat) (x : nat -> R) : R :=
  sum_first (fun m => sum_first (fun k => series_coefficient k m * eta ^ k * x (k + 3 * m)%nat) (S (K m))) (S M).

(** ** Sums over the parts of a square *)

Lemma sum_first_swap (a : nat -> nat -> R) n p :
  sum_first (fun k => sum_first (fun m => a k m) p) n = sum_first (fun m => sum_first (fun k => a k m) n) p.
Proof.
induction n as [|n IH]; simpl.
- symmetry. apply sum_first_zero. reflexivity.
- rewrite IH, <- sum_first_plus. reflexivity.
Qed.

Lemma sum_first_split a n p : sum_first a (n + p) = sum_first a n + sum_first (fun i => a (n + i)%nat) p.
Proof.
induction p as [|p IH]. rewrite Nat.add_0_r. simpl. ring.
replace (n + S p)%nat with (S (n + p)) by lia. simpl. rewrite IH. ring.
Qed.

Lemma sum_first_cut a n p : (n <= p)%nat -> sum_first a p = sum_first a n + sum_first (fun i => a (n + i)%nat) (p - n).
Proof. intros H. rewrite <- sum_first_split. f_equal. lia. Qed.

(** The square k, m < N holds the part k < N and P; what is left over of it. *)
Lemma series_difference eta N M K x : (M < N)%nat -> (forall m, (m <= M)%nat -> (K m < N)%nat) ->
  eta_series eta N x - polynomial_series eta M K x
    = sum_first (fun m => sum_first (fun i => series_coefficient (S (K m) + i) m * eta ^ (S (K m) + i) * x
      (S (K m) + i + 3 * m)%nat) (N - S (K m))) (S M)
      + sum_first (fun j => sum_first (fun k => series_coefficient k (S M + j) * eta ^ k * x (k + 3 * (S M + j))%nat) N)
          (N - S M).
Proof.
intros HM HK.
assert (E : eta_series eta N x = sum_first (fun m =>
  sum_first (fun k => series_coefficient k m * eta ^ k * x (k + 3 * m)%nat) N) N).
{ rewrite <- (sum_first_swap (fun k m => series_coefficient k m * eta ^ k * x (k + 3 * m)%nat)).
  apply sum_first_ext_below. intros k Hk. 
  rewrite (sum_first_cut _ (S k) N) by lia. rewrite (sum_first_zero (fun i => series_coefficient k (S k + i) * _ * _)).
  - rewrite <- sum_first_scal, Rplus_0_r. apply sum_first_ext. intros m. ring.
  - intros i. rewrite coefficient_beyond by lia. ring. }
rewrite E, (sum_first_cut _ (S M) N) by lia. unfold polynomial_series.
set (far := sum_first _ (N - S M)).
enough (D : sum_first (fun m => sum_first (fun k => series_coefficient k m * eta ^ k * x (k + 3 * m)%nat) N) (S M)
  = sum_first (fun m => sum_first (fun k => series_coefficient k m * eta ^ k * x (k + 3 * m)%nat) (S (K m))) (S M)
    + sum_first (fun m => sum_first (fun i => series_coefficient (S (K m) + i) m * eta ^ (S (K m) + i) * x
        (S (K m) + i + 3 * m)%nat) (N - S (K m))) (S M)) by lra.
rewrite <- sum_first_plus. apply sum_first_ext_below. intros m Hm. specialize (HK m ltac:(lia)).
apply sum_first_cut. lia.
Qed.

Lemma below_all (K : nat -> nat) M : exists N, forall m, (m <= M)%nat -> (K m < N)%nat.
Proof.
induction M as [|M [N HN]].
- exists (S (K 0%nat)). intros m Hm. replace m with 0%nat by lia. lia.
- exists (Nat.max N (S (K (S M)))). intros m Hm. destruct (Nat.eq_dec m (S M)) as [->|Hne]; [lia|].
  specialize (HN m ltac:(lia)). lia.
Qed.

(** The least order q with b < n + q *)
Lemma least_order (d : R) : exists q : nat, d < INR q /\ forall a : nat, d < INR a -> (q <= a)%nat.
Proof.
destruct (archimed d) as [H1 H2]. exists (Z.to_nat (up d)). split.
- assert (H : (up d <= Z.of_nat (Z.to_nat (up d)))%Z) by lia. apply IZR_le in H. rewrite <- INR_IZR_INZ in H. lra.
- intros a Ha. rewrite INR_IZR_INZ in Ha.
  assert (H : IZR (up d) < IZR (Z.of_nat a + 1)) by (rewrite plus_IZR; lra). apply lt_IZR in H. lia.
Qed.

(** ** The weight *)
Section Weight.
Variables (M : nat) (K : nat -> nat).
Hypothesis HK : forall m, (1 <= m <= M)%nat -> Nat.Odd (K m - m).

Definition weight_excess (eta r : R) : R := exp (exponent eta r) - polynomial_series eta M K (fun i => r ^ i).

Lemma exponent_scale eta r : 0 < eta -> exponent eta r = unit_exponent (eta * r) / eta ^ 3.
Proof. intros He. unfold unit_exponent, exponent, weight_exponent. rewrite Rmult_1_l, pow1. field. lra. Qed.

Lemma weight_parts eta r : 0 < eta -> 0 < r -> weight_excess eta r
  = exp_beyond (S M) (exponent eta r) + sum_first (fun m =>
    r ^ (3 * m) * (power_rest m (S (K m)) (eta * r) / (eta * r) ^ (3 * m))) (S M).
Proof.
intros He Hr. unfold weight_excess, exp_beyond, polynomial_series.
enough (E : forall m, r ^ (3 * m) * (power_rest m (S (K m)) (eta * r) / (eta * r) ^ (3 * m))
  = exponent eta r ^ m / INR (fact m) + -1 * sum_first (fun k => series_coefficient k m * eta ^ k * r ^ (k + 3 * m))
    (S (K m))).
{ rewrite (sum_first_ext _ _ (S M) E), sum_first_plus, sum_first_scal. ring. }
intros m. rewrite exponent_scale by auto. unfold power_rest, partial_power.
rewrite (sum_first_ext (fun k => series_coefficient k m * (eta * r) ^ (k + 3 * m))
  (fun k => eta ^ (3 * m) * (series_coefficient k m * eta ^ k * r ^ (k + 3 * m)))) by (intros k;
    rewrite Rpow_mult_distr, (pow_add eta); ring).
rewrite sum_first_scal. unfold Rdiv. rewrite (Rpow_mult_distr (unit_exponent _)), pow_inv, <- pow_mult, Rpow_mult_distr.
assert (P1 : eta ^ (3 * m) <> 0) by (apply pow_nonzero; lra).
assert (P2 : r ^ (3 * m) <> 0) by (apply pow_nonzero; lra).
field. repeat split; auto. apply INR_fact_neq_0.
Qed.

(** Each part is >= 0 and does not decrease. *)
Lemma part_index m : (1 <= m <= M)%nat -> exists i, S (K m) = (m + i)%nat /\ (-1) ^ i = 1.
Proof.
intros Hm. destruct (HK m Hm) as [j Hj]. exists (2 * S j)%nat. split; [lia|]. rewrite pow_mult.
replace ((-1) ^ 2) with 1 by ring. apply pow1.
Qed.

Lemma part_nonnegative m x : (m <= M)%nat -> 0 < x -> 0 <= power_rest m (S (K m)) x.
Proof.
intros Hm Hx. destruct m as [|m]; [rewrite power_rest_0; lra|]. destruct (part_index (S m) ltac:(lia)) as (i & -> & Ei).
assert (A := power_rest_sign (S m) i x ltac:(lra)). rewrite Ei in A. lra.
Qed.

Lemma part_increases m x y : (m <= M)%nat -> 0 < x < y -> power_rest m (S (K m)) x / x ^ (3 * m) <= power_rest m
  (S (K m)) y / y ^ (3 * m).
Proof.
intros Hm Hx. destruct m as [|m]; [rewrite !power_rest_0; unfold Rdiv; lra|].
destruct (part_index (S m) ltac:(lia)) as (i & -> & Ei).
assert (A := power_rest_increases (S m) i x y Hx). rewrite Ei in A. lra.
Qed.

Lemma sum_first_le_below a d n : (forall k, (k < n)%nat -> a k <= d k) -> sum_first a n <= sum_first d n.
Proof. intros H. induction n as [|n IH]; simpl; [lra|]. apply Rplus_le_compat; [apply IH; intros; apply H|apply H]; lia.
Qed.

Lemma weight_excess_positive eta r : 0 < eta -> 0 < r -> 0 < weight_excess eta r.
Proof.
intros He Hr. rewrite weight_parts by auto. apply Rplus_lt_le_0_compat.
- apply exp_beyond_positive, exponent_bounds; auto.
- replace 0 with (sum_first (fun _ => 0) (S M)) by (apply sum_first_zero; reflexivity).
  apply sum_first_le_below. intros m Hm. assert (X : 0 < eta * r) by (apply Rmult_lt_0_compat; auto).
  apply Rmult_le_pos; [apply pow_le; lra|]. apply Rmult_le_pos; [apply part_nonnegative; auto; lia|].
  apply Rlt_le, Rinv_0_lt_compat, pow_lt, X.
Qed.

Lemma weight_excess_increases eta eta' r : 0 < eta < eta' -> 0 < r -> weight_excess eta r < weight_excess eta' r.
Proof.
intros He Hr. rewrite !weight_parts by lra. apply Rplus_lt_le_compat.
- apply exp_beyond_increases. assert (A := weight_increasing eta eta' r He Hr).
  destruct (exponent_bounds eta r ltac:(lra) Hr).
  unfold exponent in *. lra.
- apply sum_first_le_below. intros m Hm. apply Rmult_le_compat_l; [apply pow_le; lra|]. apply part_increases; [lia|].
  split; [apply Rmult_lt_0_compat; lra|apply Rmult_lt_compat_r; lra].
Qed.

Lemma weight_excess_ex_derive eta r : 0 < eta -> 0 < r -> ex_derive (weight_excess eta) r.
Proof.
intros He Hr. apply (ex_derive_minus (fun r => exp (exponent eta r)) (fun r => polynomial_series eta M K (fun i =>
  r ^ i))).
- apply (ex_derive_comp exp (exponent eta)). eexists. apply is_derive_exp. eexists. apply exponent_derive; lra.
- eexists. apply (sum_first_derive (fun m r => sum_first (fun k => series_coefficient k m * eta ^ k * r ^ (k + 3 * m))
    (S (K m)))
    (fun m => sum_first (fun k => series_coefficient k m * eta ^ k * power_derive r (k + 3 * m)) (S (K m)))). intros m.
  apply (sum_first_derive (fun k r => series_coefficient k m * eta ^ k * r ^ (k + 3 * m)) (fun k =>
    series_coefficient k m * eta ^ k * power_derive r (k + 3 * m))).
  intros k. apply (is_derive_scal (fun r => r ^ (k + 3 * m))), power_is_derive.
Qed.

(** ** The excess *)
Variables (b : R) (theta : R -> R).
Hypothesis Hb : not_nat b.
Hypothesis HT : is_Theta b theta.
Let s : R := - b - 1.
Let f := scaled b theta.

Definition polynomial_excess (eta : R) (k : nat) (t : R) : R := scaled_J eta s k t - polynomial_series eta M K (fun i =>
  f (k + i)%nat t).

Lemma polynomial_excess_derive eta k t : 0 < eta -> is_derive (polynomial_excess eta k) t
  (polynomial_excess eta (S k) t).
Proof.
intros He. apply (is_derive_minus (scaled_J eta s k) (fun t => polynomial_series eta M K (fun i => f (k + i)%nat t))).
- apply (scaled_J_family eta He s (ok_not_nat b Hb)).
- apply (sum_first_derive (fun m t => sum_first (fun j => series_coefficient j m * eta ^ j * f (k + (j + 3 * m))%nat t)
    (S (K m)))
    (fun m => sum_first (fun j => series_coefficient j m * eta ^ j * f (S k + (j + 3 * m))%nat t) (S (K m)))). intros m.
  apply (sum_first_derive (fun j t => series_coefficient j m * eta ^ j * f (k + (j + 3 * m))%nat t)
    (fun j => series_coefficient j m * eta ^ j * f (S k + (j + 3 * m))%nat t)). intros j.
  apply (is_derive_scal (f (k + (j + 3 * m))%nat)). apply (scaled_derive b theta Hb HT).
Qed.

Lemma polynomial_excess_integral eta k t : 0 < eta -> -1 < s + INR k ->
  is_RInt_gen (fun r => measure b k t r * weight_excess eta r) (at_right 0) (Rbar_locally p_infty)
    (polynomial_excess eta k t).
Proof.
intros He Hk.
assert (I := is_RInt_gen_minus _ _ _ _ (slow_integral_measure b eta He k t Hk) (sum_first_integral
  (fun m r => sum_first (fun j => series_coefficient j m * eta ^ j * (measure b k t r * r ^ (j + 3 * m))) (S (K m)))
  (fun m => sum_first (fun j => series_coefficient j m * eta ^ j * f (k + (j + 3 * m))%nat t) (S (K m))) (S M)
  (fun m => sum_first_integral (fun j r => series_coefficient j m * eta ^ j * (measure b k t r * r ^ (j + 3 * m)))
    (fun j => series_coefficient j m * eta ^ j * f (k + (j + 3 * m))%nat t) (S (K m))
    (fun j => is_RInt_gen_scal _ (series_coefficient j m * eta ^ j) _ (theta_moment b theta Hb HT k (j + 3 * m)
      t Hk))))).
eapply improper_ext; [|exact I]. intros r _. unfold minus, plus, opp; cbn [Hierarchy.opp Hierarchy.plus].
change (measure b k t r * exp (exponent eta r)
  + - sum_first (fun m => sum_first (fun j => series_coefficient j m * eta ^ j * (measure b k t r * r ^ (j + 3 * m)))
        (S (K m))) (S M)
  = measure b k t r * weight_excess eta r).
unfold weight_excess, polynomial_series. rewrite Rmult_minus_distr_l, <- sum_first_scal. unfold Rminus. do 2 f_equal.
apply sum_first_ext. intros m.
rewrite <- sum_first_scal. apply sum_first_ext. intros j. ring.
Qed.

Lemma polynomial_excess_continuous eta k t r : 0 < eta -> 0 < r ->
  continuous (fun r => measure b k t r * weight_excess eta r) r.
Proof.
intros He Hr. apply (ex_derive_continuous (fun r => measure b k t r * weight_excess eta r) r).
apply (ex_derive_mult (measure b k t) (weight_excess eta)); [|apply weight_excess_ex_derive; auto].
unfold measure, Rpower. auto_derive. auto.
Qed.

Section Order.
Variable q : nat.
Hypothesis Hq4 : (q <= 4 * S M)%nat.
Hypothesis HqK : forall m, (1 <= m <= M)%nat -> (q <= K m + 1 + 3 * m)%nat.

Lemma polynomial_excess_small eta k : 0 < eta -> small (s + INR k + INR q + 1) (fun x => polynomial_excess eta k (- x)).
Proof.
intros He. destruct (below_all K M) as [N0 HN0]. set (N := (N0 + S M + q)%nat).
assert (X := series_excess_small b theta eta Hb HT He N ltac:(unfold N; lia) k). fold s in X.
assert (X' : small (s + INR k + INR q + 1) (fun x => series_excess b theta eta N k (- x))).
{ apply (small_weaken _ (N - q + 3)).
  replace (s + INR k + INR q + 1 + INR (N - q + 3)) with (s + INR k + INR N + 4); [exact X|].
  rewrite plus_INR, minus_INR by (unfold N; lia). simpl (INR 3). ring. }
assert (T : forall c i, c = 0 \/ (q <= i)%nat -> small (s + INR k + INR q + 1) (fun x => c * f (k + i)%nat (- x))).
{ intros c i [->|Hi].
  - exists 0. intros x _. rewrite Rmult_0_l, Rabs_R0. lra.
  - apply small_scal, (small_weaken _ (i - q)).
    replace (s + INR k + INR q + 1 + INR (i - q)) with (s + INR k + INR i + 1).
    apply (theta_small b theta Hb HT). rewrite minus_INR by auto. ring. }
refine (small_ext _ _ _ _ (small_plus _ _ _ X' (small_plus _
  (fun x => sum_first (fun m => sum_first (fun i => series_coefficient (S (K m) + i) m * eta ^ (S (K m) + i) * f
    (k + (S (K m) + i + 3 * m))%nat (- x)) (N - S (K m))) (S M))
  (fun x => sum_first (fun j => sum_first (fun i => series_coefficient i (S M + j) * eta ^ i * f
    (k + (i + 3 * (S M + j)))%nat (- x)) N) (N - S M)) _ _))).
- intros x _. cbv beta. assert (D := series_difference eta N M K (fun i => f (k + i)%nat (- x)) ltac:(unfold N; lia)
    ltac:(intros m Hm; specialize (HN0 m Hm); unfold N; lia)). cbv beta in D. unfold series_excess, polynomial_excess.
    fold s f. lra.
- apply (sum_first_small _ (fun m x => sum_first (fun i => series_coefficient (S (K m) + i) m * eta ^ (S (K m) + i) * f
    (k + (S (K m) + i + 3 * m))%nat (- x)) (N - S (K m)))).
  intros m Hm. apply (sum_first_small _ (fun i x => series_coefficient (S (K m) + i) m * eta ^ (S (K m) + i) * f
    (k + (S (K m) + i + 3 * m))%nat (- x))).
  intros i _. apply T. destruct m as [|m]; [left; rewrite Nat.add_succ_l, coefficient_0; ring|right].
  specialize (HqK (S m) ltac:(lia)). lia.
- apply (sum_first_small _ (fun j x => sum_first (fun i => series_coefficient i (S M + j) * eta ^ i * f
    (k + (i + 3 * (S M + j)))%nat (- x)) N)).
  intros j _. apply (sum_first_small _ (fun i x => series_coefficient i (S M + j) * eta ^ i * f
    (k + (i + 3 * (S M + j)))%nat (- x))).
  intros i _. apply T.
  destruct (le_lt_dec (S M + j) i) as [Hi|Hi]; [right; lia|left; rewrite coefficient_beyond by exact Hi; ring].
Qed.
End Order.

Section Result.
Variable n : nat.
Hypothesis H4 : b < INR n + 4 * INR (S M).
Hypothesis HKn : forall m, (1 <= m <= M)%nat -> b < INR n + INR (K m) + 1 + 3 * INR m.

Lemma order_exists : exists q : nat, - (INR q + 1) < s + INR n /\ (q <= 4 * S M)%nat /\ (forall m, (1 <= m <= M)%nat ->
  (q <= K m + 1 + 3 * m)%nat).
Proof.
destruct (least_order (b - INR n)) as (q & Hq & Hl). exists q. refine (conj _ (conj _ _)).
- unfold s. lra.
- apply Hl. rewrite mult_INR. simpl (INR 4). lra.
- intros m Hm. apply Hl. specialize (HKn m Hm). rewrite !plus_INR, mult_INR. simpl (INR 1). simpl (INR 3). lra.
Qed.

Theorem polynomial_excess_positive eta t : 0 < eta -> 0 < polynomial_excess eta n t.
Proof.
intros He. destruct order_exists as (q & Hq & Hq4 & HqK).
apply (chain_positive s (- (INR q + 1)) (polynomial_excess eta)); auto.
- intros k u. apply polynomial_excess_derive, He.
- intros k _. replace (s + INR k - - (INR q + 1)) with (s + INR k + INR q + 1) by ring.
  apply polynomial_excess_small; auto.
- intros k u Hk. eapply improper_positive; [| |exact (polynomial_excess_integral eta k u He Hk)].
  + intros r Hr. apply Rmult_lt_0_compat; [apply measure_pos|apply weight_excess_positive; auto].
  + intros r Hr. apply polynomial_excess_continuous; auto.
Qed.

Theorem polynomial_excess_increases eta eta' t : 0 < eta < eta' -> polynomial_excess eta n t
  < polynomial_excess eta' n t.
Proof.
intros He. destruct order_exists as (q & Hq & Hq4 & HqK).
enough (0 < polynomial_excess eta' n t - polynomial_excess eta n t) by lra.
apply (chain_positive s (- (INR q + 1)) (fun k t => polynomial_excess eta' k t - polynomial_excess eta k t)); auto.
- intros k u. apply (is_derive_minus (polynomial_excess eta' k) (polynomial_excess eta k));
    apply polynomial_excess_derive; lra.
- intros k _. replace (s + INR k - - (INR q + 1)) with (s + INR k + INR q + 1) by ring.
  apply (small_minus _ (fun x => polynomial_excess eta' k (- x)) (fun x => polynomial_excess eta k (- x)));
    apply polynomial_excess_small; auto; lra.
- intros k u Hk. enough (polynomial_excess eta k u < polynomial_excess eta' k u) by lra.
  eapply improper_lt; [| | |apply polynomial_excess_integral; [lra|exact Hk]|apply polynomial_excess_integral;
    [lra|exact Hk]].
  + intros r Hr. apply Rmult_lt_compat_l; [apply measure_pos|apply weight_excess_increases; auto].
  + intros r Hr. apply polynomial_excess_continuous; lra.
  + intros r Hr. apply polynomial_excess_continuous; lra.
Qed.
End Result.
End Weight.
