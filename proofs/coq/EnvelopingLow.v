(** * The enveloping series for every derivative, and for Theta itself

    For n > b the rest after N terms lies between 0 and the next term ([EnvelopingSeries.v]). Let a = n - b be any
    number, a + 3N > 0. The rest for n is O(x^-(a+3N)): by the recurrence it is (x rest(n + 1, N) - rest(n + 3, N -
    1))/a, since the terms satisfy the same relation exactly. Its derivative along t = -x is the rest for n + 1, and it
    tends to 0 as t -> -oo; so it is >= 0, and in the same way at most the next term. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus GammaFunction LaplaceIntegral ImproperIntegral EnvelopingSeries Family Ends
  CompliantIntegral LeftExpansion CompliantMonotone.
Open Scope R_scope.

(** Gamma(a + 3j) x^-(a + 3j)/(3^j j!) *)
Definition left_term (a : R) (j : nat) (x : R) : R :=
  Gamma (a + 3 * INR j) * Rpower x (- (a + 3 * INR j)) / (3 ^ j * INR (fact j)).

Definition left_sum (a : R) (N : nat) (x : R) : R := sum_first (fun j => (-1) ^ j * left_term a j x) N.

Lemma denominator_neq0 j : 3 ^ j * INR (fact j) <> 0.
Proof. apply Rmult_integral_contrapositive_currified. apply pow_nonzero; lra. apply INR_fact_neq_0. Qed.

(** The terms satisfy the recurrence. *)
Lemma left_term_step a j x : 0 < x -> a + 3 * INR j <> 0 -> x * left_term (a + 1) j x
  = (a + 3 * INR j) * left_term a j x.
Proof.
intros Hx Ha. unfold left_term. replace (a + 1 + 3 * INR j) with (a + 3 * INR j + 1) by ring. rewrite Gamma_rec by auto.
rewrite (Rpower_split x (- (a + 3 * INR j)) 1 (- (a + 3 * INR j + 1))) by (auto; simpl; ring).
assert (D := denominator_neq0 j). field.
split; [apply INR_fact_neq_0|apply pow_nonzero; lra].
Qed.

Lemma left_term_next a j x : left_term (a + 3) j x = 3 * INR (S j) * left_term a (S j) x.
Proof.
unfold left_term. replace (a + 3 + 3 * INR j) with (a + 3 * INR (S j)) by (rewrite S_INR; ring).
rewrite fact_simpl, mult_INR. simpl (3 ^ S j). assert (H : INR (S j) <> 0) by (apply not_0_INR; lia).
field. repeat split; auto. apply INR_fact_neq_0. apply pow_nonzero; lra.
Qed.

Lemma left_sum_step a N x : 0 < x -> (forall j : nat, a + 3 * INR j <> 0) ->
  a * left_sum a (S N) x = x * left_sum (a + 1) (S N) x + left_sum (a + 3) N x.
Proof.
intros Hx Ha. unfold left_sum. induction N as [|N IH].
- simpl. assert (H := left_term_step a 0 x Hx (Ha 0%nat)). simpl in H. lra.
- change (sum_first (fun j => (-1) ^ j * left_term a j x) (S (S N)))
    with (sum_first (fun j => (-1) ^ j * left_term a j x) (S N) + (-1) ^ S N * left_term a (S N) x).
  change (sum_first (fun j => (-1) ^ j * left_term (a + 1) j x) (S (S N)))
    with (sum_first (fun j => (-1) ^ j * left_term (a + 1) j x) (S N) + (-1) ^ S N * left_term (a + 1) (S N) x).
  change (sum_first (fun j => (-1) ^ j * left_term (a + 3) j x) (S N))
    with (sum_first (fun j => (-1) ^ j * left_term (a + 3) j x) N + (-1) ^ N * left_term (a + 3) N x).
  assert (H := left_term_step a (S N) x Hx (Ha (S N))). assert (H2 := left_term_next a N x).
  rewrite !Rmult_plus_distr_l, IH.
  replace (x * ((-1) ^ S N * left_term (a + 1) (S N) x)) with ((-1) ^ S N * (x * left_term (a + 1) (S N) x)) by ring.
  rewrite H, H2. simpl ((-1) ^ S N). ring.
Qed.

Lemma left_term_small a N : small (a + 3 * INR N) (left_term a N).
Proof.
apply (small_ext _ (fun x => Gamma (a + 3 * INR N) / (3 ^ N * INR (fact N)) * Rpower x (- (a + 3 * INR N)))).
- intros x _. unfold left_term. assert (D := denominator_neq0 N). unfold Rdiv. ring.
- apply small_scal, small_power.
Qed.

Lemma left_term_derive a j t : t < 0 -> a + 3 * INR j <> 0 ->
  is_derive (fun t => left_term a j (- t)) t (left_term (a + 1) j (- t)).
Proof.
intros Ht Ha. unfold left_term. replace (a + 1 + 3 * INR j) with (a + 3 * INR j + 1) by ring. rewrite Gamma_rec by auto.
set (q := a + 3 * INR j) in *. set (D := 3 ^ j * INR (fact j)). assert (HD : D <> 0) by apply denominator_neq0.
unfold Rpower. auto_derive. lra.
replace (- (q + 1) * ln (- t)) with (- q * ln (- t) + - ln (- t)) by ring.
rewrite exp_plus, (exp_Ropp (ln (- t))), exp_ln by lra.
field. split; auto. lra.
Qed.

(** A chain on t < 0: nonnegative from some index on, tending to 0. *)
Lemma nonnegative_from_left_half (f df : R -> R) q : (forall t, t < 0 -> is_derive f t (df t)) ->
  (forall t, t < 0 -> 0 <= df t) ->
  0 < q -> small q (fun x => f (- x)) -> forall t, t < 0 -> 0 <= f t.
Proof.
intros D Hp Hq Hs t Ht. apply Rnot_lt_le. intros Hlt.
destruct (small_lim q _ Hq Hs (- f t) ltac:(lra)) as (M & HM & H).
set (x := Rmax M (1 - t)). assert (X1 : M <= x) by apply Rmax_l. assert (X2 : 1 - t <= x) by apply Rmax_r.
specialize (H x X1).
destruct (mvt_open f df (- x) t ltac:(lra)) as (c & Hc & E).
{ intros s Hs'. apply D. lra. }
assert (0 <= df c * (t - - x)) by (apply Rmult_le_pos; [apply Hp; lra|lra]).
apply Rabs_def2 in H. lra.
Qed.

Lemma chain_half (a : R) (f : nat -> R -> R) : (forall k t, t < 0 -> is_derive (f k) t (f (S k) t)) ->
  (forall k, 0 < a + INR k -> small (a + INR k) (fun x => f k (- x))) ->
  (exists m : nat, forall k t, (m <= k)%nat -> t < 0 -> 0 <= f k t) -> forall k t, 0 < a + INR k -> t < 0 -> 0 <= f k t.
Proof.
intros D Hs [m Hm].
assert (H : forall n k t, 0 < a + INR k -> (m <= k + n)%nat -> t < 0 -> 0 <= f k t).
{ induction n as [|n IH]; intros k t Hk Hn Ht.
  - apply Hm; auto. lia.
  - apply (nonnegative_from_left_half (f k) (f (S k)) (a + INR k)); auto.
    intros u Hu. apply IH; auto. rewrite S_INR; lra. lia. }
intros k t Hk Ht. apply (H m k t Hk); auto. lia.
Qed.

Section Low.
Variables (b : R) (theta : R -> R).
Hypothesis Hb : not_nat b.
Hypothesis HT : is_Theta b theta.

Definition left_remainder (N k : nat) (x : R) : R := (-1) ^ N * (scaled b theta k (- x) - left_sum (INR k - b) N x).

Lemma index_neq0 k j : INR k - b + 3 * INR j <> 0.
Proof. intros E. apply (Hb (k + 3 * j)%nat). rewrite plus_INR, mult_INR. simpl. lra. Qed.

Lemma remainder_high N k x : b < INR k -> 0 < x -> 0 <= left_remainder N k x <= left_term (INR k - b) N x.
Proof.
intros Hk Hx. assert (H := envelope (INR k - b - 1) _ ltac:(lra) (Theta_Laplace_n b theta k Hb HT) x N Hx).
assert (E : forall j, envelope_term (INR k - b - 1) x j = left_term (INR k - b) j x).
{ intros j. unfold envelope_term, left_term.
  replace (INR k - b - 1 + 1 + 3 * INR j) with (INR k - b + 3 * INR j) by ring. reflexivity. }
rewrite E in H. rewrite (sum_first_ext _ (fun j => (-1) ^ j * left_term (INR k - b) j x)) in H
  by (intros; rewrite E; reflexivity).
exact H.
Qed.

Lemma scaled_step k x : (INR k - b) * scaled b theta k (- x) = x * scaled b theta (S k) (- x) + scaled b theta
  (S (S (S k))) (- x).
Proof.
destruct (scaled_family b theta Hb HT) as (_ & R & _). assert (H := R k (- x)). simpl in H.
replace (k + 1)%nat with (S k) in H by lia. replace (k + 3)%nat with (S (S (S k))) in H by lia. lra.
Qed.

Lemma remainder_step N k x : 0 < x ->
  left_remainder (S N) k x = / (INR k - b) * (x * left_remainder (S N) (S k) x - left_remainder N (S (S (S k))) x).
Proof.
intros Hx. assert (A := scaled_step k x).
assert (B := left_sum_step (INR k - b) N x Hx (index_neq0 k)).
assert (N0 := index_neq0 k 0). simpl in N0.
unfold left_remainder. rewrite !S_INR.
replace (INR k + 1 - b) with (INR k - b + 1) by ring. replace (INR k + 1 + 1 + 1 - b) with (INR k - b + 3) by ring.
match goal with |- _ = / ?a * ?y => apply (Rmult_eq_reg_l a); [replace (a * (/ a * y)) with y by (field; lra)|lra] end.
replace ((INR k - b) * ((-1) ^ S N * (scaled b theta k (- x) - left_sum (INR k - b) (S N) x)))
  with ((-1) ^ S N * ((INR k - b) * scaled b theta k (- x) - (INR k - b) * left_sum (INR k - b) (S N) x)) by ring.
rewrite A, B. simpl ((-1) ^ S N). ring.
Qed.

Lemma remainder_step_0 k x : left_remainder 0 k x = / (INR k - b) * (x * left_remainder 0 (S k) x + left_remainder 0
  (S (S (S k))) x).
Proof.
assert (A := scaled_step k x). assert (N0 := index_neq0 k 0). simpl in N0.
unfold left_remainder, left_sum. simpl sum_first. simpl pow.
match goal with |- _ = / ?a * ?y => apply (Rmult_eq_reg_l a); [replace (a * (/ a * y)) with y by (field; lra)|lra] end.
lra.
Qed.

Lemma remainder_small N k : small (INR k - b + 3 * INR N) (left_remainder N k).
Proof.
assert (High : forall N k, b < INR k -> small (INR k - b + 3 * INR N) (left_remainder N k)).
{ intros N' k' Hk. destruct (left_term_small (INR k' - b) N') as [C HC]. exists C. intros x Hx.
  destruct (remainder_high N' k' x Hk ltac:(lra)) as [H1 H2]. specialize (HC x Hx).
  rewrite Rabs_pos_eq by auto. eapply Rle_trans; [exact H2|]. eapply Rle_trans; [apply Rle_abs|exact HC]. }
assert (H : forall n N k, b < INR k + INR n -> small (INR k - b + 3 * INR N) (left_remainder N k)).
{ induction n as [|n IH]; intros N' k' Hk.
  - apply High. simpl in Hk. lra.
  - rewrite S_INR in Hk.
    assert (S1 : small (INR k' - b + 3 * INR N') (fun x => x ^ 1 * left_remainder N' (S k') x)).
    { apply small_mult.
      replace (INR k' - b + 3 * INR N' + INR 1) with (INR (S k') - b + 3 * INR N') by (rewrite S_INR; simpl; ring).
      apply IH. rewrite S_INR. lra. }
    destruct N' as [|N'].
    + assert (S3 : small (INR k' - b + 3 * INR 0) (left_remainder 0 (S (S (S k'))))).
      { apply (small_weaken _ 3). replace (INR k' - b + 3 * INR 0 + INR 3) with (INR (S (S (S k'))) - b + 3 * INR 0)
          by (rewrite !S_INR; simpl; ring).
        apply IH. rewrite !S_INR. lra. }
      eapply small_ext; [|exact (small_scal _ (/ (INR k' - b)) _ (small_plus _ _ _ S1 S3))].
      intros x _. rewrite (remainder_step_0 k' x), pow_1. reflexivity.
    + assert (S3 : small (INR k' - b + 3 * INR (S N')) (left_remainder N' (S (S (S k'))))).
      { replace (INR k' - b + 3 * INR (S N')) with (INR (S (S (S k'))) - b + 3 * INR N') by (rewrite !S_INR; ring).
        apply IH. rewrite !S_INR. lra. }
      eapply small_ext; [|exact (small_scal _ (/ (INR k' - b)) _ (small_minus _ _ _ S1 S3))].
      intros x Hx. rewrite (remainder_step N' k' x), pow_1 by lra. reflexivity. }
destruct (nfloor_ex (Rabs b) (Rabs_pos b)) as [n [_ Hn]].
apply (H (S n) N k). rewrite S_INR. assert (P := pos_INR k). assert (A := Rle_abs b). lra.
Qed.

Lemma left_sum_derive a N t : t < 0 -> (forall j : nat, a + 3 * INR j <> 0) ->
  is_derive (fun t => left_sum a N (- t)) t (left_sum (a + 1) N (- t)).
Proof.
intros Ht Ha. unfold left_sum. induction N as [|N IH].
- simpl. apply (is_derive_const 0).
- simpl. apply (is_derive_plus (fun t => sum_first (fun j => (-1) ^ j * left_term a j (- t)) N) (fun t =>
    (-1) ^ N * left_term a N (- t))).
  exact IH. apply (is_derive_scal (fun t => left_term a N (- t))). apply left_term_derive; auto.
Qed.

Lemma remainder_derive N k t : t < 0 -> is_derive (fun t => left_remainder N k (- t)) t (left_remainder N (S k) (- t)).
Proof.
intros Ht. unfold left_remainder. rewrite S_INR. replace (INR k + 1 - b) with (INR k - b + 1) by ring.
apply (is_derive_scal (fun t => scaled b theta k (- - t) - left_sum (INR k - b) N (- t))).
apply (is_derive_minus (fun t => scaled b theta k (- - t)) (fun t => left_sum (INR k - b) N (- t))).
- apply (is_derive_ext (scaled b theta k)). { intros u. rewrite Ropp_involutive. reflexivity. }
  rewrite Ropp_involutive. apply scaled_derive; auto.
- apply left_sum_derive; auto. apply index_neq0.
Qed.

Lemma high_index : exists m : nat, forall k : nat, (m <= k)%nat -> b < INR k.
Proof.
destruct (nfloor_ex (Rabs b) (Rabs_pos b)) as [n [_ Hn]]. exists (S n). intros k Hk.
apply le_INR in Hk. rewrite S_INR in Hk. assert (A := Rle_abs b). lra.
Qed.

Theorem remainder_bounds N k x : 0 < INR k - b + 3 * INR N -> 0 < x -> 0 <= left_remainder N k x <= left_term
  (INR k - b) N x.
Proof.
intros Hk Hx. destruct high_index as [m Hm]. split.
- assert (H := chain_half (- b + 3 * INR N) (fun k t => left_remainder N k (- t))).
  rewrite <- (Ropp_involutive x). apply H; try lra.
  + intros j t Ht. apply remainder_derive, Ht.
  + intros j Hj. apply (small_ext _ (left_remainder N j)). { intros y _. rewrite Ropp_involutive. reflexivity. }
    replace (- b + 3 * INR N + INR j) with (INR j - b + 3 * INR N) by ring. apply remainder_small.
  + exists m. intros j t Hj Ht. apply remainder_high. apply Hm, Hj. lra.
- assert (H := chain_half (- b + 3 * INR N) (fun k t => left_term (INR k - b) N (- t) - left_remainder N k (- t))).
  enough (0 <= left_term (INR k - b) N (- - x) - left_remainder N k (- - x)) by (rewrite Ropp_involutive in *; lra).
  apply H; try lra.
  + intros j t Ht. rewrite S_INR. replace (INR j + 1 - b) with (INR j - b + 1) by ring.
    apply (is_derive_minus (fun t => left_term (INR j - b) N (- t)) (fun t => left_remainder N j (- t))).
    * apply left_term_derive; auto. apply index_neq0.
    * apply remainder_derive, Ht.
  + intros j Hj. apply (small_ext _ (fun x => left_term (INR j - b) N x - left_remainder N j x)).
    { intros y _. rewrite Ropp_involutive. reflexivity. }
    replace (- b + 3 * INR N + INR j) with (INR j - b + 3 * INR N) by ring. apply small_minus. apply left_term_small.
    apply remainder_small.
  + exists m. intros j t Hj Ht. assert (A := remainder_high N j (- t) (Hm j Hj) ltac:(lra)). lra.
Qed.

(** In the form of the statement. *)
Theorem enveloping_series_low n N x : 0 < x -> b < INR n + 3 * INR N ->
  let term k := rising (INR n - b) (3 * k) / (3 ^ k * INR (fact k) * x ^ (3 * k)) in
  let quotient := Derive_n theta n (- x) / (rising (- b) n * Rpower x (b - INR n)) in
  0 <= (-1) ^ N * (quotient - sum_first (fun k => (-1) ^ k * term k) N) / term N <= 1.
Proof.
intros Hx HN term quotient.
assert (H := remainder_bounds N n x ltac:(lra) Hx).
assert (Hnp : forall k : nat, - b <> - INR k) by (intros k Hk; apply (Hb k); lra).
assert (Hna : forall k : nat, INR n - b <> - INR k).
{ intros k Hk. apply (Hb (n + k)%nat). rewrite plus_INR. lra. }
assert (Hg : Gamma (- b) <> 0) by (apply Gamma_neq0; auto).
assert (Hp := rising_neq0 (- b) n Hnp).
set (A := Gamma (INR n - b)). assert (HA : A <> 0) by (apply Gamma_neq0, Hna).
assert (EA : A = rising (- b) n * Gamma (- b)).
{ unfold A. replace (INR n - b) with (- b + INR n) by ring. apply Gamma_rising; auto. }
set (X := Rpower x (b - INR n)). assert (HX : 0 < X) by apply exp_pos.
assert (ET : forall k, left_term (INR n - b) k x = A * X * term k).
{ intros k. unfold left_term, term, A, X.
  replace (INR n - b + 3 * INR k) with (INR n - b + INR (3 * k)) by (rewrite mult_INR; simpl; ring).
  rewrite Gamma_rising by exact Hna.
  replace (- (INR n - b + INR (3 * k))) with ((b - INR n) + - INR (3 * k)) by ring.
  rewrite Rpower_plus, Rpower_Ropp, Rpower_pow by auto.
  field. refine (conj _ (conj _ _)).
  - apply pow_nonzero; lra.
  - apply INR_fact_neq_0.
  - apply pow_nonzero; lra. }
assert (EP : 0 < left_term (INR n - b) N x).
{ unfold left_term. apply Rdiv_lt_0_compat.
  - apply Rmult_lt_0_compat; [apply Gamma_pos; lra|apply exp_pos].
  - apply Rmult_lt_0_compat. apply pow_lt; lra. apply INR_fact_lt_0. }
unfold left_remainder, left_sum in H.
rewrite (sum_first_ext _ (fun k => A * X * ((-1) ^ k * term k))) in H by (intros k; rewrite ET; ring).
rewrite sum_first_scal in H.
replace (scaled b theta n (- x)) with (A * X * quotient) in H.
2: { unfold scaled, quotient. fold X. rewrite EA. field. split; [lra|auto]. }
set (P := sum_first (fun k => (-1) ^ k * term k) N) in *.
rewrite ET in H, EP. set (T := A * X * term N) in *.
assert (Ht : term N <> 0). { intros E. unfold T in EP. rewrite E in EP. lra. }
replace ((-1) ^ N * (quotient - P) / term N) with ((-1) ^ N * (A * X * quotient - A * X * P) / T).
2: { unfold T. field. repeat split; auto; lra. }
split.
- apply Rmult_le_pos. apply H. apply Rlt_le, Rinv_0_lt_compat, EP.
- apply Rmult_le_reg_r with T; auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
End Low.

(** ** An explicit left end *)

Lemma rising_sign x n : (forall i, (i < n)%nat -> x + INR i < 0) -> 0 < (-1) ^ n * rising x n.
Proof.
induction n as [|n IH]; intros H.
- simpl. lra.
- simpl. assert (A := IH (fun i Hi => H i (Nat.lt_lt_succ_r _ _ Hi))). assert (B := H n (Nat.lt_succ_diag_r n)).
  replace (-1 * (-1) ^ n * (rising x n * (x + INR n))) with ((-1) ^ n * rising x n * - (x + INR n)) by ring.
  apply Rmult_lt_0_compat; lra.
Qed.

Lemma minus_one_cube k : (-1) ^ (3 * k) = (-1) ^ k.
Proof. rewrite pow_mult. f_equal. ring. Qed.

(** n < b < n + 1, N = floor(n/3) + 1: Theta > 0 on (-oo, -x] if x^(3N) 3^N N! exceeds the product of the |b - i|, i <
    3N. *)
Theorem left_end_explicit (n : nat) b theta x : INR n < b < INR n + 1 -> is_Theta b theta -> 0 < x ->
  let N := S (n / 3) in Rabs (rising (- b) (3 * N)) < x ^ (3 * N) * 3 ^ N * INR (fact N) -> forall t, t <= - x ->
    0 < theta t.
Proof.
intros Hbn HT Hx N HN t Ht.
assert (Hb : not_nat b) by (apply (cell_not_nat (S n)); unfold cell; rewrite S_INR; lra).
set (y := - t). assert (Hy : x <= y) by (unfold y; lra).
assert (HD := Nat.div_mod n 3 ltac:(lia)). assert (HM := Nat.mod_upper_bound n 3 ltac:(lia)).
assert (HN3 : b < INR 0 + 3 * INR N).
{ assert (A : (n + 1 <= 3 * N)%nat) by (unfold N; lia). apply le_INR in A. rewrite plus_INR, mult_INR in A.
  simpl (INR 1) in A. simpl (INR 3) in A. change (INR 0) with 0. lra. }
assert (E := enveloping_series_low b theta Hb HT 0 N y ltac:(lra) HN3).
cbv zeta in E. simpl (rising (- b) 0) in E. rewrite Rmult_1_l in E.
replace (INR 0 - b) with (- b) in E by (simpl; ring). replace (b - INR 0) with b in E by (simpl; ring).
change (Derive_n theta 0 (- y)) with (theta (- y)) in E. replace (- y) with t in E by (unfold y; ring).
set (term := fun k => rising (- b) (3 * k) / (3 ^ k * INR (fact k) * y ^ (3 * k))) in *.
set (X := Rpower y b) in *. assert (HX : 0 < X) by apply exp_pos.
assert (Hden : forall k, 0 < 3 ^ k * INR (fact k) * y ^ (3 * k)).
{ intros k. apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]. apply pow_lt; lra. apply INR_fact_lt_0.
  apply pow_lt; lra. }
assert (Hpos : forall k, (k < N)%nat -> 0 < (-1) ^ k * term k).
{ intros k Hk. unfold term. unfold Rdiv. rewrite <- Rmult_assoc.
  apply Rmult_lt_0_compat; [|apply Rinv_0_lt_compat, Hden].
  rewrite <- minus_one_cube. apply rising_sign. intros i Hi.
  assert (A : (i + 1 <= n)%nat) by (unfold N in Hk; lia). apply le_INR in A. rewrite plus_INR in A. simpl in A. lra. }
assert (Hsum : forall M, (1 <= M <= N)%nat -> 1 <= sum_first (fun k => (-1) ^ k * term k) M).
{ induction M as [|M IH]; [lia|]. intros HMN. destruct M as [|M].
  - simpl. unfold term. simpl. lra.
  - change (1 <= sum_first (fun k => (-1) ^ k * term k) (S M) + (-1) ^ S M * term (S M)).
    assert (A := IH ltac:(lia)). assert (B := Hpos (S M) ltac:(lia)). lra. }
assert (S1 := Hsum N ltac:(unfold N; lia)). set (P := sum_first (fun k => (-1) ^ k * term k) N) in *.
assert (HTm : Rabs (term N) < 1).
{ unfold term, Rdiv. rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq _ (Rlt_le _ _ (Hden N))).
  apply Rmult_lt_reg_r with (3 ^ N * INR (fact N) * y ^ (3 * N)); auto.
  rewrite Rmult_assoc, Rinv_l by (apply Rgt_not_eq, Hden).
  rewrite Rmult_1_r, Rmult_1_l. eapply Rlt_le_trans; [exact HN|].
  replace (x ^ (3 * N) * 3 ^ N * INR (fact N)) with (3 ^ N * INR (fact N) * x ^ (3 * N)) by ring.
  apply Rmult_le_compat_l. apply Rlt_le, Rmult_lt_0_compat. apply pow_lt; lra. apply INR_fact_lt_0.
  apply pow_incr; lra. }
assert (Hnz : term N <> 0).
{ unfold term. apply Rmult_integral_contrapositive_currified. apply rising_neq0. intros k Hk; apply (Hb k); lra.
  apply Rinv_neq_0_compat, Rgt_not_eq, Hden. }
set (q := theta t / X) in *.
assert (Hq : Rabs (q - P) <= Rabs (term N)).
{ set (r := (-1) ^ N * (q - P) / term N) in *.
  assert (A : Rabs (q - P) = Rabs r * Rabs (term N)).
  { rewrite <- Rabs_mult. replace (r * term N) with ((-1) ^ N * (q - P)) by (unfold r; field; auto).
    rewrite Rabs_mult, <- RPow_abs. replace (Rabs (-1)) with 1 by (rewrite Rabs_left; lra). rewrite pow1. ring. }
  rewrite A, Rabs_pos_eq by apply E. rewrite <- (Rmult_1_l (Rabs (term N))) at 2.
  apply Rmult_le_compat_r. apply Rabs_pos. apply E. }
assert (Hq0 : 0 < q). { assert (A := Rle_abs (- (q - P))). rewrite Rabs_Ropp in A. lra. }
replace (theta t) with (q * X) by (unfold q; field; lra). apply Rmult_lt_0_compat; auto.
Qed.
