(** * The saddle: the coefficients in closed form (Lagrange's inversion formula)

    Let (1 + u)^c = s'(u) sum a_m s(u)^m, s = u psi(u), psi = sqrt(1 + u/3). Divided by psi^(n+1) it says (1 + u)^c
    psi^(-n-1) = sum_(m <= n) a_m u^m (1 + u/2) psi^(-j-2), j = n - m, up to what is O(u^(n+1)). The coefficient of u^n
    in the m-th term is a_m times that of u^j in (1 + u/2) (1 + u/3)^(-j/2-1), which is 0 for j > 0 ([residue]): so a_n
    is the coefficient of u^n on the left. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus PowerSeriesNorm NormLimit BinomialSeries SaddleInverse.
Open Scope R_scope.

(** ** A power series that is O(u^(n+1)) has no coefficient up to the n-th *)

Lemma radius_of_values (b : nat -> R) (h : R -> R) r : 0 < r -> (forall u, Rabs u < r -> is_pseries b u (h u)) ->
  Rbar_lt 0 (CV_radius b).
Proof.
intros Hr Hb. apply Rbar_lt_le_trans with (r / 2); [simpl; lra|]. apply Rbar_not_lt_le. intros H.
assert (A : Rabs (r / 2) = r / 2) by (apply Rabs_pos_eq; lra).
apply (CV_disk_outside b (r / 2)). rewrite A. exact H.
assert (S := Hb (r / 2) ltac:(lra)). apply is_pseries_R in S.
apply (is_lim_seq_ext (fun n => b n * (r / 2) ^ n)). intros; reflexivity.
apply (ex_series_lim_0 (fun n => b n * (r / 2) ^ n)). eexists. exact S.
Qed.

Lemma small_at_0 (f : R -> R) C n r : 0 < r -> continuity_pt f 0 ->
  (forall u, 0 < u < r -> Rabs (f u) <= C * u ^ S n) -> f 0 = 0.
Proof.
intros Hr Hc Hf. apply Rabs_eq_0. apply Rle_antisym; [|apply Rabs_pos]. apply le_epsilon. intros eps He.
rewrite Rplus_0_l. destruct (Hc (eps / 2) ltac:(lra)) as (d & Hd & Hd'). unfold dist in Hd'; simpl in Hd'.
assert (PC : 0 < Rabs C + 1) by (generalize (Rabs_pos C); lra).
set (u := Rmin (Rmin (d / 2) (r / 2)) (Rmin 1 (eps / 2 / (Rabs C + 1)))).
assert (H1 : u <= Rmin (d / 2) (r / 2)) by apply Rmin_l.
assert (H2 : u <= Rmin 1 (eps / 2 / (Rabs C + 1))) by apply Rmin_r.
assert (D1 := Rmin_l (d / 2) (r / 2)). assert (D2 := Rmin_r (d / 2) (r / 2)).
assert (D3 := Rmin_l 1 (eps / 2 / (Rabs C + 1))). assert (D4 := Rmin_r 1 (eps / 2 / (Rabs C + 1))).
assert (Hu : 0 < u). { repeat apply Rmin_pos; try lra. apply Rdiv_lt_0_compat; lra. }
specialize (Hf u ltac:(lra)).
specialize (Hd' u). assert (Q : R_dist (f u) (f 0) < eps / 2).
{ apply Hd'. split. split; [exact I|lra]. unfold R_dist. rewrite Rminus_0_r, Rabs_pos_eq; lra. }
unfold R_dist in Q. rewrite Rabs_minus_sym in Q.
assert (T := Rabs_triang (f 0 - f u) (f u)). replace (f 0 - f u + f u) with (f 0) in T by ring.
assert (B : C * u ^ S n <= (Rabs C + 1) * u).
{ simpl. assert (P0 := pow_le u n ltac:(lra)). assert (P1 : u ^ n <= 1) by (rewrite <- (pow1 n); apply pow_incr; lra).
  apply Rle_trans with (Rabs C * (u * u ^ n)).
  - apply Rmult_le_compat_r. apply Rmult_le_pos; lra. apply Rle_abs.
  - apply Rmult_le_compat. apply Rabs_pos. apply Rmult_le_pos; lra. lra.
    assert (u * u ^ n <= u * 1) by (apply Rmult_le_compat_l; lra). lra. }
assert (E : (Rabs C + 1) * (eps / 2 / (Rabs C + 1)) = eps / 2) by (field; lra).
assert ((Rabs C + 1) * u <= (Rabs C + 1) * (eps / 2 / (Rabs C + 1))) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Lemma small_series n : forall (b : nat -> R) C r, 0 < r -> Rbar_lt 0 (CV_radius b) ->
  (forall u, 0 < u < r -> Rabs (PSeries b u) <= C * u ^ S n) -> b n = 0.
Proof.
induction n as [|n IH]; intros b C r Hr Hb Hh.
all: assert (E : b 0%nat = 0) by (rewrite <- PSeries_0; refine (small_at_0 (PSeries b) C _ r Hr _ Hh);
  apply PSeries_continuity; rewrite Rabs_R0; exact Hb).
- exact E.
- apply (IH (PS_decr_1 b) C r Hr). rewrite CV_radius_decr_1. exact Hb.
  intros u Hu. specialize (Hh u Hu). rewrite (PSeries_decr_1_aux b u E), Rabs_mult, Rabs_pos_eq in Hh by lra.
  apply Rmult_le_reg_l with u; [lra|]. eapply Rle_trans; [exact Hh|]. right. simpl. ring.
Qed.

(** ** The series in u *)

(** (1 - q u)^(-a) *)
Definition scaled_term (a q : R) (n : nat) : R := rising_term a n * q ^ n.

Lemma scaled_series a q u : Rabs (q * u) < 1 -> is_pseries (scaled_term a q) u (Rpower (1 - q * u) (- a)).
Proof.
intros H. apply is_pseries_sum_first.
apply (is_lim_seq_ext (fun N => sum_first (fun n => rising_term a n * (q * u) ^ n) N)).
- intros N. apply sum_first_ext. intros n. unfold scaled_term. rewrite Rpow_mult_distr. ring.
- apply is_pseries_sum_first, binomial_series, H.
Qed.

Lemma root_power u n : -3 < u -> Rpower (1 - - / 3 * u) (- (INR n / 2)) = / sqrt (1 + u / 3) ^ n.
Proof.
intros Hu. replace (1 - - / 3 * u) with (1 + u / 3) by field. rewrite Rpower_Ropp. f_equal.
rewrite <- Rpower_pow by (apply root_pos, Hu). rewrite <- Rpower_sqrt by lra. rewrite Rpower_mult. f_equal. field.
Qed.

(** (1 + u/2) psi^(-j-2); its j-th coefficient is 0 unless j = 0. *)
Definition residue_term (j : nat) : nat -> R :=
  let h := scaled_term (INR (j + 2) / 2) (- / 3) in PS_plus h (PS_scal (/ 2) (PS_incr_1 h)).

Lemma residue_series j u : Rabs u < 1 -> is_pseries (residue_term j) u ((1 + u / 2) / sqrt (1 + u / 3) ^ (j + 2)).
Proof.
intros Hu. assert (Hu' := proj1 (Rabs_lt_between _ _) Hu).
assert (S := scaled_series (INR (j + 2) / 2) (- / 3) u ltac:(rewrite Rabs_mult, Rabs_left; lra)).
rewrite root_power in S by lra.
assert (S1 := is_pseries_incr_1 (K := R_AbsRing) (V := R_NormedModule) _ _ _ S).
assert (S2 := is_pseries_scal (/ 2) _ u _ (Rmult_comm u (/ 2)) S1).
assert (T := is_pseries_plus _ _ _ _ _ S S2).
replace ((1 + u / 2) / sqrt (1 + u / 3) ^ (j + 2)) with
  (plus (/ sqrt (1 + u / 3) ^ (j + 2)) (scal (/ 2) (scal u (/ sqrt (1 + u / 3) ^ (j + 2))))); [exact T|].
unfold plus, scal; simpl; unfold mult; simpl. unfold Rdiv. ring.
Qed.

Lemma residue j : residue_term j j = match j with O => 1 | _ => 0 end.
Proof.
unfold residue_term, PS_plus, PS_scal, PS_incr_1, plus, scal, scaled_term; simpl; unfold mult; simpl.
destruct j as [|j]; [rewrite rising_term_first; unfold zero; simpl; ring|].
set (a := INR (S j + 2) / 2).
assert (P : 0 < INR (S j)) by (apply lt_0_INR; lia).
assert (E := rising_term_next a j).
assert (A : a + INR j = 3 / 2 * INR (S j)). { unfold a. rewrite plus_INR, S_INR. simpl (INR 2). field. }
rewrite A in E. assert (E' : rising_term a (S j) = 3 / 2 * rising_term a j).
{ apply Rmult_eq_reg_l with (INR (S j)); [|lra]. rewrite E. ring. }
rewrite E'. simpl pow. field.
Qed.

Lemma finite_sum_series (b : nat -> nat -> R) (h : nat -> R) u N : (forall m, (m < N)%nat
  -> is_pseries (b m) u (h m)) ->
  is_pseries (fun i => sum_first (fun m => b m i) N) u (sum_first h N).
Proof.
induction N as [|N IH]; intros H.
- apply is_pseries_sum_first. apply (is_lim_seq_ext (fun _ => 0)); [|apply is_lim_seq_const].
  simpl. intros K. induction K as [|K IHK]; simpl. reflexivity. rewrite <- IHK. ring.
- simpl. apply (is_pseries_plus (fun i => sum_first (fun m => b m i) N) (b N)).
  apply IH. intros m Hm. apply H. lia. apply H. lia.
Qed.

Lemma sum_one (a : nat -> R) (w : nat -> R) n : (forall m, (m < n)%nat -> w m = 0) -> w n = 1 ->
  sum_first (fun m => a m * w m) (S n) = a n.
Proof.
intros H0 H1. cbn [sum_first]. rewrite H1.
assert (Z : forall K, (K <= n)%nat -> sum_first (fun m => a m * w m) K = 0).
{ induction K as [|K IH]; intros HK; simpl. reflexivity. rewrite IH, H0 by lia. ring. }
rewrite Z by lia. ring.
Qed.

(** ** The theorem *)

Definition lagrange_coefficient (c : R) (n : nat) : R :=
  PS_mult (scaled_term (INR (n + 1) / 2) (- / 3)) (scaled_term (- c) (-1)) n.

Section Coefficients.
Variables (eta c M : R) (a : nat -> R).
Hypothesis Heta : 0 < eta < 1.
Hypothesis Ha : forall N, sum_first (fun n => Rabs (a n) * saddle_radius eta ^ n) N <= M.
Hypothesis Hs : forall u, - eta <= u <= eta -> Rabs (saddle u) < saddle_radius eta ->
  is_pseries a (saddle u) (Rpower (1 + u) c / saddle_slope u).

Lemma saddle_small u : 0 <= u <= eta -> saddle u <= 2 * u.
Proof.
intros Hu. unfold saddle. rewrite Rmult_comm. apply Rmult_le_compat_r; [lra|].
rewrite <- (sqrt_square 2) by lra. apply sqrt_le_1_alt. lra.
Qed.

Lemma near_0 : exists r, 0 < r <= eta /\ forall u, Rabs u < r -> Rabs (saddle u) < saddle_radius eta.
Proof.
assert (P := radius_pos eta Heta). assert (C := saddle_continuous 0 ltac:(lra)).
destruct (C _ P) as (d & Hd & H). exists (Rmin d eta). split.
- split. apply Rmin_pos; lra. apply Rmin_r.
- intros u Hu. assert (Hu' : Rabs u < d) by (eapply Rlt_le_trans; [exact Hu|apply Rmin_l]).
  destruct (Req_dec u 0) as [->|Hn]. unfold saddle. rewrite Rmult_0_l, Rabs_R0. exact P.
  specialize (H u). unfold dist in H; simpl in H; unfold R_dist in H. rewrite Rminus_0_r in H.
  assert (E : saddle 0 = 0) by (unfold saddle; ring). rewrite E, Rminus_0_r in H. apply H. split; auto.
  split; [exact I|auto].
Qed.

(** Plan: the left side less the terms m <= n is a power series b (Sb). It is the rest of the series times a bounded
    factor (E), so O(u^(n+1)), and its n-th coefficient is 0 (Z); that coefficient is the one of the left side less a_n,
    by [residue] (G). *)
Theorem lagrange n : a n = lagrange_coefficient c n.
Proof.
destruct near_0 as (r & Hr & Hnear). assert (PR := radius_pos eta Heta).
set (g := fun m => PS_incr_n (residue_term (n - m)) m).
set (b := PS_minus (PS_mult (scaled_term (INR (n + 1) / 2) (- / 3)) (scaled_term (- c) (-1)))
  (fun i => sum_first (fun m => a m * g m i) (S n))).
set (left := fun u => / sqrt (1 + u / 3) ^ (n + 1) * Rpower (1 + u) c).
set (part := fun u m => u ^ m * ((1 + u / 2) / sqrt (1 + u / 3) ^ (n - m + 2))).
assert (Sb : forall u, Rabs u < r -> is_pseries b u (left u - sum_first (fun m => a m * part u m) (S n))).
{ intros u Hu. assert (Hu' := proj1 (Rabs_lt_between _ _) Hu).
  apply (is_pseries_minus _ (fun i => sum_first (fun m => a m * g m i) (S n))).
  - assert (B1 : Rabs (- / 3 * u) < 1) by (rewrite Rabs_mult, Rabs_left; lra).
    assert (B2 : Rabs (-1 * u) < 1) by (rewrite Rabs_mult, Rabs_left; lra).
    assert (RR : forall a q, Rabs q <= 1 -> Rbar_lt (Rabs u) (CV_radius (scaled_term a q))).
    { intros a' q Hq. destruct (rising_term_bounded a' ((1 + Rabs u) / 2)) as [B HB].
      { generalize (Rabs_pos u); lra. }
      apply Rbar_lt_le_trans with ((1 + Rabs u) / 2); [simpl; lra|].
      apply (proj1 (CV_radius_bounded (scaled_term a' q))). exists B. intros i. unfold scaled_term.
      rewrite !Rabs_mult, <- RPow_abs, (Rabs_pos_eq (((1 + Rabs u) / 2) ^ i))
        by (apply pow_le; generalize (Rabs_pos u); lra).
      eapply Rle_trans; [|apply HB]. apply Rmult_le_compat_r. apply pow_le; generalize (Rabs_pos u); lra.
      rewrite <- (Rmult_1_r (Rabs (rising_term a' i))) at 2. apply Rmult_le_compat_l. apply Rabs_pos.
      rewrite <- (pow1 i). apply pow_incr. split; [apply Rabs_pos|auto]. }
    unfold left. rewrite <- root_power by lra.
    replace (Rpower (1 + u) c) with (Rpower (1 - -1 * u) (- - c)).
    2: { rewrite Ropp_involutive. f_equal. ring. }
    apply is_pseries_mult. apply scaled_series, B1. apply scaled_series, B2.
    apply RR. rewrite Rabs_left; lra. apply RR. rewrite Rabs_left; lra.
  - apply (finite_sum_series (fun m i => a m * g m i) (fun m => a m * part u m)). intros m Hm.
    apply (is_pseries_scal (a m) (g m) u (part u m) (Rmult_comm u (a m))).
    unfold part. rewrite <- pow_n_pow. unfold g.
    apply (is_pseries_incr_n (K := R_AbsRing) (V := R_NormedModule)). apply residue_series. lra. }
assert (E : forall u, Rabs u < r -> left u - sum_first (fun m => a m * part u m) (S n) = (1 + u / 2)
  / sqrt (1 + u / 3) ^ (n + 2)
  * (Rpower (1 + u) c / saddle_slope u - sum_first (fun m => a m * saddle u ^ m) (S n))).
{ intros u Hu. apply Rabs_lt_between in Hu. assert (P := root_pos u ltac:(lra)).
  rewrite Rmult_minus_distr_l. unfold Rminus. f_equal.
  - unfold left, saddle_slope. replace (n + 2)%nat with (S (n + 1)) by lia. simpl pow. field.
    repeat split; try lra. apply pow_nonzero. lra.
  - f_equal. rewrite <- sum_first_scal.
    assert (X : forall K, (K <= S n)%nat -> sum_first (fun m => a m * part u m) K = sum_first (fun m =>
      (1 + u / 2) / sqrt (1 + u / 3) ^ (n + 2) * (a m * saddle u ^ m)) K); [|apply X; lia].
    induction K as [|K IH]; intros HK; simpl; [reflexivity|]. rewrite IH by lia. f_equal. unfold part, saddle.
    rewrite Rpow_mult_distr. replace (n + 2)%nat with (K + (n - K + 2))%nat by lia. rewrite (pow_add _ K). field.
    split; apply pow_nonzero; lra. }
assert (Z : b n = 0).
{ apply (small_series n b (3 / 2 / sqrt (2 / 3) ^ (n + 2) * (M * (2 / saddle_radius eta) ^ S n)) r); try lra.
  - apply (radius_of_values b _ r (proj1 Hr) Sb).
  - intros u Hu. assert (Au : Rabs u = u) by (apply Rabs_pos_eq; lra).
    rewrite (is_pseries_unique b u _ (Sb u ltac:(lra))), E by lra.
    assert (P := root_pos u ltac:(lra)). assert (Q0 : 0 < sqrt (2 / 3)) by (apply sqrt_lt_R0; lra).
    assert (Q1 : sqrt (2 / 3) <= sqrt (1 + u / 3)) by (apply sqrt_le_1_alt; lra).
    assert (NN := norm_nonneg a (saddle_radius eta) M Ha).
    assert (T := series_tail a (saddle_radius eta) M PR Ha (saddle u) _ (S n) ltac:(apply Rlt_le, Hnear; lra)
      (Hs u ltac:(lra) (Hnear u ltac:(lra)))).
    rewrite Rabs_mult, Rabs_pos_eq by (apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat, pow_lt, P]).
    rewrite Rmult_assoc. apply Rmult_le_compat; try apply Rabs_pos.
    + apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat, pow_lt, P].
    + apply Rmult_le_compat; try lra. apply Rlt_le, Rinv_0_lt_compat, pow_lt, P.
      apply Rinv_le_contravar. apply pow_lt, Q0. apply pow_incr. lra.
    + eapply Rle_trans; [exact T|]. rewrite Rmult_assoc. apply Rmult_le_compat_l; auto.
      rewrite <- Rpow_mult_distr. apply pow_incr. split.
      * apply Rmult_le_pos. apply Rabs_pos. apply Rlt_le, Rinv_0_lt_compat, PR.
      * unfold Rdiv. rewrite Rmult_assoc, (Rmult_comm _ u), <- Rmult_assoc. apply Rmult_le_compat_r.
        apply Rlt_le, Rinv_0_lt_compat, PR. assert (S0 := saddle_above u ltac:(lra)).
        rewrite Rabs_pos_eq by lra. apply saddle_small. lra. }
unfold b, PS_minus, PS_plus, PS_opp, plus, opp in Z. simpl in Z.
change (sum_first (fun m => a m * g m n) n + a n * g n n) with (sum_first (fun m => a m * g m n) (S n)) in Z.
assert (G : forall m, (m <= n)%nat -> g m n = residue_term (n - m) (n - m)).
{ intros m Hm. unfold g. rewrite PS_incr_n_simplify. destruct (le_lt_dec m n); [reflexivity|lia]. }
rewrite (sum_one a (fun m => g m n) n) in Z.
- unfold lagrange_coefficient. lra.
- intros m Hm. rewrite G, residue by lia. destruct (n - m)%nat eqn:D; [lia|reflexivity].
- rewrite G, residue, Nat.sub_diag by lia. reflexivity.
Qed.
End Coefficients.
