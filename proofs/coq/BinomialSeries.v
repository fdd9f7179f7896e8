(** * The binomial series

    (1 - x)^(-a) = sum (a)_n x^n/n! for |x| < 1: the sum y has (1 - x) y' = a y. For a >= 0 the coefficients are not
    negative, for -1 <= a <= 0 only the first is positive: so what the absolute values of the terms sum up to is known,
    and with it the norm of (1 - v)^(-a) for a power series v of norm q < 1. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus PowerSeriesNorm NormLimit.
Open Scope R_scope.

Definition rising_term (a : R) (n : nat) : R := rising a n / INR (fact n).

Lemma rising_term_next a n : INR (S n) * rising_term a (S n) = (a + INR n) * rising_term a n.
Proof.
unfold rising_term. rewrite fact_simpl, mult_INR. cbn [rising]. field.
split; [apply INR_fact_neq_0|apply not_0_INR; lia].
Qed.

Lemma rising_term_first a : rising_term a 0 = 1.
Proof. unfold rising_term. simpl. field. Qed.

Lemma rising_term_nonneg a n : 0 <= a -> 0 <= rising_term a n.
Proof.
intros Ha. apply Rmult_le_pos; [|apply Rlt_le, Rinv_0_lt_compat, lt_0_INR, lt_O_fact].
induction n as [|n IH]; simpl. lra. apply Rmult_le_pos; auto. generalize (pos_INR n). lra.
Qed.

Lemma rising_term_nonpos a n : -1 <= a <= 0 -> rising_term a (S n) <= 0.
Proof.
intros Ha. assert (P : 0 < INR (S n)) by (apply lt_0_INR; lia).
induction n as [|n IH].
- assert (E := rising_term_next a 0). rewrite rising_term_first in E. simpl in E |- *. lra.
- assert (E := rising_term_next a (S n)). assert (P1 : 0 < INR (S n)) by (apply lt_0_INR; lia). specialize (IH P1).
  assert (P2 : 1 <= INR (S n)) by (apply (le_INR 1); lia).
  apply Rmult_le_reg_l with (INR (S (S n))); auto. rewrite E. nra.
Qed.

Lemma rising_term_bounded a r : 0 < r < 1 -> exists M, forall n, Rabs (rising_term a n) * r ^ n <= M.
Proof.
intros Hr. destruct (nfloor_ex (Rabs a / (1 - r))) as (n0 & _ & H0).
{ apply Rmult_le_pos. apply Rabs_pos. apply Rlt_le, Rinv_0_lt_compat; lra. }
set (term := fun n => Rabs (rising_term a n) * r ^ n).
assert (P : forall n, 0 <= term n) by (intros; apply Rmult_le_pos; [apply Rabs_pos|apply pow_le; lra]).
assert (B : forall n, (n <= S n0)%nat -> term n <= sum_first term (S (S n0))).
{ intros n Hn. replace (S (S n0)) with (S n + (S n0 - n))%nat by lia.
  apply Rle_trans with (sum_first term (S n)); [|apply sum_first_grow, P].
  simpl. assert (H := sum_first_nonneg term n P). lra. }
exists (sum_first term (S (S n0))). intros n. change (term n <= sum_first term (S (S n0))).
destruct (le_lt_dec n (S n0)) as [Hn|Hn]; [apply B, Hn|].
replace n with (S n0 + (n - S n0))%nat by lia. generalize (n - S n0)%nat as k. intros k.
eapply Rle_trans; [|apply (B (S n0)); lia].
induction k as [|k IH]; [rewrite Nat.add_0_r; lra|].
rewrite Nat.add_succ_r. eapply Rle_trans; [|exact IH].
set (m := (S n0 + k)%nat). unfold term.
assert (Pm : 0 < INR (S m)) by (apply lt_0_INR; lia).
assert (E : Rabs (rising_term a (S m)) = Rabs (rising_term a m) * (Rabs (a + INR m) / INR (S m))).
{ replace (rising_term a (S m)) with (rising_term a m * ((a + INR m) / INR (S m))).
  - rewrite Rabs_mult. f_equal. unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ INR (S m))); auto.
    apply Rlt_le, Rinv_0_lt_compat, Pm.
  - assert (H := rising_term_next a m). apply Rmult_eq_reg_l with (INR (S m)); [|lra]. rewrite H. field. lra. }
rewrite E. change (r ^ S m) with (r * r ^ m).
replace (Rabs (rising_term a m) * (Rabs (a + INR m) / INR (S m)) * (r * r ^ m))
  with (Rabs (rising_term a m) * r ^ m * (r * (Rabs (a + INR m) / INR (S m)))) by ring.
rewrite <- (Rmult_1_r (Rabs (rising_term a m) * r ^ m)) at 2. apply Rmult_le_compat_l; [apply (P m)|].
apply Rmult_le_reg_r with (INR (S m)); auto.
replace (r * (Rabs (a + INR m) / INR (S m)) * INR (S m)) with (r * Rabs (a + INR m)) by (field; lra).
assert (T := Rabs_triang a (INR m)). rewrite (Rabs_pos_eq (INR m)) in T by apply pos_INR.
assert (H1 : INR n0 + 1 <= INR m).
{ rewrite <- S_INR. apply le_INR. unfold m. lia. }
assert (H2 : Rabs a <= INR m * (1 - r)).
{ replace (Rabs a) with (Rabs a / (1 - r) * (1 - r)) by (field; lra). apply Rmult_le_compat_r; lra. }
rewrite S_INR. assert (r * Rabs (a + INR m) <= r * (Rabs a + INR m)) by (apply Rmult_le_compat_l; lra).
assert (r * Rabs a <= 1 * Rabs a) by (apply Rmult_le_compat_r; [apply Rabs_pos|lra]). lra.
Qed.

Lemma rising_term_radius a x : Rabs x < 1 -> Rbar_lt (Rabs x) (CV_radius (rising_term a)).
Proof.
intros Hx. set (r := (Rabs x + 1) / 2). assert (Ax := Rabs_pos x).
destruct (rising_term_bounded a r ltac:(unfold r; lra)) as [M HM].
apply Rbar_lt_le_trans with r; [simpl; unfold r; lra|].
apply (proj1 (CV_radius_bounded (rising_term a))). exists M. intros n.
rewrite Rabs_mult, (Rabs_pos_eq (r ^ n)) by (apply pow_le; unfold r; lra). apply HM.
Qed.

Lemma binomial_equation a x : Rabs x < 1 ->
  (1 - x) * PSeries (PS_derive (rising_term a)) x = a * PSeries (rising_term a) x.
Proof.
intros Hx. assert (R := rising_term_radius a x Hx).
assert (R1 : Rbar_lt (Rabs x) (CV_radius (PS_derive (rising_term a)))) by (rewrite CV_radius_derive; exact R).
set (d := PS_derive (rising_term a)) in *.
assert (S1 := PSeries_correct d x (CV_radius_inside _ _ R1)).
assert (S0 := PSeries_correct (rising_term a) x (CV_radius_inside _ _ R)).
assert (S2 := is_pseries_incr_1 (K := R_AbsRing) (V := R_NormedModule) d x _ S1).
assert (S3 := is_pseries_minus _ _ _ _ _ S1 S2).
assert (S4 := is_pseries_scal a _ x _ (Rmult_comm x a) S0).
apply (is_pseries_ext _ (PS_scal a (rising_term a))) in S3.
- apply is_pseries_unique in S3. apply is_pseries_unique in S4. rewrite S3 in S4.
  unfold scal, plus, opp in S4; simpl in S4; unfold mult in S4; simpl in S4. lra.
- intros [|n]; unfold PS_minus, PS_plus, PS_opp, PS_scal, PS_incr_1, d, PS_derive, plus, opp, scal, zero; simpl;
    unfold mult; simpl.
  + assert (E := rising_term_next a 0). simpl in E. lra.
  + assert (E := rising_term_next a (S n)). change (match n with O => 1 | S _ => INR n + 1 end) with (INR (S n)) in *.
    change (match n with O => 1 + 1 | S _ => INR n + 1 + 1 end) with (INR (S (S n))).
    replace (INR (S n) + 1) with (INR (S (S n))) by (rewrite !S_INR; ring). rewrite E. ring.
Qed.

Lemma power_derive (a x : R) : x < 1 -> is_derive (fun x => Rpower (1 - x) a) x (- a * (Rpower (1 - x) a / (1 - x))).
Proof.
intros Hx. unfold Rpower. auto_derive. lra. unfold Rdiv. replace (1 + - x) with (1 - x) by ring. ring.
Qed.

Theorem binomial_series a x : Rabs x < 1 -> is_pseries (rising_term a) x (Rpower (1 - x) (- a)).
Proof.
intros Hx. assert (R := rising_term_radius a).
set (g := fun x => PSeries (rising_term a) x * Rpower (1 - x) a).
assert (D : forall t, Rabs t < 1 -> is_derive g t 0).
{ intros t Ht. assert (Ht' := proj1 (Rabs_lt_between _ _) Ht).
  apply (is_derive_val _ _ (PSeries (PS_derive (rising_term a)) t * Rpower (1 - t) a
    + PSeries (rising_term a) t * (- a * (Rpower (1 - t) a / (1 - t))))).
  - apply (is_derive_mult_R (PSeries (rising_term a)) (fun x => Rpower (1 - x) a)).
    apply is_derive_PSeries, R, Ht. apply power_derive. lra.
  - assert (E := binomial_equation a t Ht).
    replace (PSeries (rising_term a) t * (- a * (Rpower (1 - t) a / (1 - t))))
      with (- (a * PSeries (rising_term a) t) * (Rpower (1 - t) a / (1 - t))) by ring.
    rewrite <- E. field. lra. }
assert (E : g x = 1).
{ replace 1 with (g 0).
  2: { unfold g. rewrite PSeries_0, rising_term_first, Rminus_0_r. unfold Rpower. rewrite ln_1, Rmult_0_r, exp_0.
  ring. }
  assert (Hx' := proj1 (Rabs_lt_between _ _) Hx).
  destruct (MVT_gen g 0 x (fun _ => 0)) as (c & Hc & E).
  - intros t Ht. apply D. apply Rabs_lt_between. revert Ht. unfold Rmin, Rmax. destruct Rle_dec; lra.
  - intros t Ht. apply continuity_pt_filterlim, (ex_derive_continuous g t). exists 0. apply D.
    apply Rabs_lt_between. revert Ht. unfold Rmin, Rmax. destruct Rle_dec; lra.
  - lra. }
replace (Rpower (1 - x) (- a)) with (PSeries (rising_term a) x).
- apply PSeries_correct, CV_radius_inside, R, Hx.
- rewrite Rpower_Ropp. unfold g in E. assert (P : 0 < Rpower (1 - x) a) by apply exp_pos.
  apply Rmult_eq_reg_r with (Rpower (1 - x) a); [|lra]. rewrite E. field. lra.
Qed.

(** ** Sums of absolute values *)

Lemma sum_at_most (b : nat -> R) x s N : (forall n, 0 <= b n) -> 0 <= x -> is_pseries b x s ->
  sum_first (fun n => b n * x ^ n) N <= s.
Proof.
intros Hb Hx H. apply is_pseries_sum_first in H.
apply (is_lim_seq_incr_compare _ _ H). intros n. simpl.
assert (0 <= b n * x ^ n) by (apply Rmult_le_pos; [auto|apply pow_le, Hx]). lra.
Qed.

Lemma sum_of_powers a q N : 0 <= a -> 0 <= q < 1 ->
  sum_first (fun n => Rabs (rising_term a n) * q ^ n) N <= Rpower (1 - q) (- a).
Proof.
intros Ha Hq. rewrite (sum_first_ext _ (fun n => rising_term a n * q ^ n)).
- apply sum_at_most; try lra. intros; apply rising_term_nonneg, Ha. apply binomial_series. rewrite Rabs_pos_eq; lra.
- intros n. rewrite Rabs_pos_eq; auto. apply rising_term_nonneg, Ha.
Qed.

Lemma sum_of_roots a q N : -1 <= a <= 0 -> 0 <= q < 1 ->
  sum_first (fun n => Rabs (rising_term a n) * q ^ n) N <= 2 - Rpower (1 - q) (- a).
Proof.
intros Ha Hq.
assert (A : forall n, Rabs (rising_term a n) * q ^ n = (if n then 2 else 0) + - (rising_term a n * q ^ n)).
{ intros [|n]. rewrite rising_term_first, Rabs_R1. simpl. lra.
  rewrite Rabs_left1 by (apply rising_term_nonpos, Ha). ring. }
rewrite (sum_first_ext _ _ _ A), sum_first_plus.
assert (S0 : forall K, sum_first (fun n : nat => if n then 2 else 0) (S K) = 2).
{ induction K as [|K IH]. simpl. ring. change (sum_first ?u (S (S K))) with (sum_first u (S K) + u (S K)).
  rewrite IH. simpl. ring. }
assert (B := proj1 (is_pseries_sum_first _ _ _) (binomial_series a q ltac:(rewrite Rabs_pos_eq; lra))).
apply is_lim_seq_opp in B. change (Rbar_opp (Rpower (1 - q) (- a))) with (Finite (- Rpower (1 - q) (- a))) in B.
assert (L := is_lim_seq_plus' _ _ _ _ (is_lim_seq_const 2) B).
assert (Inc : forall K, 2 + - sum_first (fun n => rising_term a n * q ^ n) (S K)
  <= 2 + - Rpower (1 - q) (- a)).
{ intros K. apply is_lim_seq_incr_1 in L.
  refine (is_lim_seq_incr_compare _ _ L _ K). intros n. cbn [sum_first].
  assert (rising_term a (S n) * q ^ S n <= 0); [|lra].
  assert (T := rising_term_nonpos a n Ha). assert (P := pow_le q (S n) (proj1 Hq)). nra. }
assert (Neg : forall K, sum_first (fun n => - (rising_term a n * q ^ n)) K
  = - sum_first (fun n => rising_term a n * q ^ n) K).
{ induction K as [|K IH]; simpl. ring. rewrite IH. ring. }
rewrite Neg. destruct N as [|N].
- specialize (Inc 0%nat). simpl in Inc |- *. rewrite rising_term_first in Inc. lra.
- rewrite S0. specialize (Inc N). lra.
Qed.

(** ** The norm of (1 - v)^(-a) *)

Lemma norm_binomial r q a B v : 0 < r -> 0 <= q < 1 ->
  (forall N, sum_first (fun n => Rabs (rising_term a n) * q ^ n) N <= B) -> norm_at_most r q v ->
  norm_at_most r B (fun s => Rpower (1 - v s) (- a)).
Proof.
intros Hr Hq HB Hv.
apply (norm_series r (fun j s => rising_term a j * v s ^ j) (fun j => Rabs (rising_term a j) * q ^ j)); auto.
- intros j. apply norm_scal, norm_pow; auto.
- intros s Hs. apply is_pseries_sum_first, binomial_series.
  apply Rle_lt_trans with q; [|lra]. apply (norm_value r q v s); auto.
Qed.

Lemma norm_negative_power r q a v : 0 < r -> 0 <= q < 1 -> 0 <= a -> norm_at_most r q v ->
  norm_at_most r (Rpower (1 - q) (- a)) (fun s => Rpower (1 - v s) (- a)).
Proof. intros Hr Hq Ha. apply norm_binomial; auto. intros N. apply sum_of_powers; auto. Qed.

Lemma norm_root r q v : 0 < r -> 0 <= q < 1 -> norm_at_most r q v ->
  norm_at_most r (2 - sqrt (1 - q)) (fun s => sqrt (1 - v s)).
Proof.
intros Hr Hq Hv.
assert (E : forall x, 0 < x -> sqrt x = Rpower x (- - / 2)) by (intros x Hx; rewrite Ropp_involutive, Rpower_sqrt;
  auto).
apply (norm_ext r _ (fun s => Rpower (1 - v s) (- - / 2))).
{ intros s Hs. symmetry. apply E. assert (V := norm_value r q v s Hr Hv Hs). apply Rabs_le_between in V. lra. }
rewrite E by lra. apply (norm_binomial r q (- / 2)); auto. intros N. apply sum_of_roots; lra.
Qed.
