(** * C1 < 0 for beta < 1: Theorem A4 of proofs/approach.md, without the size

    lambda' = (alpha3 - alpha1) lambda - alpha2 >= (d - A/lambda(0)) lambda, so lambda grows exponentially
    ([force_grows]). The rate of V = ln(- b) - beta ln p is alpha3 - beta alpha1 - alpha2/lambda: it falls
    exponentially, as the states tend to the G-spot so ([spot_fast]). So V has a limit, and b/p^beta = - e^V a negative
    one. *)

From Coq Require Import Reals Psatz Lra Lia List.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus LogarithmicNorm SmoothFunctions Capture SignOfC1 StatementStep StatementApproach.
Open Scope R_scope.

Lemma quotient_derive (q z : R -> R) (q' z' k s : R) : is_derive q s q' -> is_derive z s z' -> q s <> 0 ->
  is_derive (fun s => - z s / q s * exp (- (k * s))) s
    (((- z' * q s + z s * q') / (q s * q s) - k * (- z s / q s)) * exp (- (k * s))).
Proof.
intros D1 D2 N. auto_derive. { repeat split; auto; eexists; eassumption. }
assert (E1 : Derive (fun s => q s) s = q') by exact (is_derive_unique _ _ _ D1).
assert (E2 : Derive (fun s => z s) s = z') by exact (is_derive_unique _ _ _ D2). rewrite E1, E2. field. auto.
Qed.

Section Below.
Variables (I : Type) (all : list I) (F G : I -> (I -> R) -> R) (F' G' : I -> I -> (I -> R) -> R).
Variables (p b : (I -> R) -> R) (p' b' : I -> (I -> R) -> R) (alpha1 alpha2 alpha3 : (I -> R) -> R).
Variables (d1 d3 : I -> (I -> R) -> R) (first last low high : I -> R) (a1 a3 A2 p1 b1 : R) (f g start : I -> R).
Variables (xi : I -> R -> R) (spot : I -> R) (time : R -> R) (d A : R).
Hypothesis Hall : forall i, In i all.
Hypothesis HC : slip_functions all F G F' G' p b p' b' alpha1 alpha2 alpha3 low high.
Hypothesis HN : neighbourhood_checked F G alpha1 alpha2 alpha3 first last low high a1 a3 A2 p1 b1 f g.
Hypothesis HA : arrival F G p b low high a1 a3 A2 p1 b1 f g start xi spot time.
Hypothesis Hd1 : smooth_on all alpha1 d1 low high.
Hypothesis Hd3 : smooth_on all alpha3 d3 low high.
Hypothesis Hp0 : 0 < p start <= p1.
Hypothesis Hb0 : - b1 <= b start < 0.
Hypothesis HA0 : 0 <= A.
Hypothesis Halpha : forall xi, in_box low high xi -> d <= alpha3 xi - alpha1 xi /\ alpha2 xi <= A.
Let lam0 := - b start / p start.
Hypothesis Hfar : A < d * lam0.

Let P s := p (state xi s).
Let B s := b (state xi s).
Let lam s := - B s / P s.
Let al1 s := alpha1 (state xi s).
Let al2 s := alpha2 (state xi s).
Let al3 s := alpha3 (state xi s).
Let inN := inside_N I F G p b low high a1 a3 A2 p1 b1 f g start xi spot time HA.
Let Ppos := P_positive I F G p b low high a1 a3 A2 p1 b1 f g start xi spot time HA.
Let moving := motion I F G p b low high a1 a3 A2 p1 b1 f g start xi spot time HA.

Lemma P_goes s : 0 <= s -> is_derive P s (al1 s * P s).
Proof.
intros Hs. apply (P_rate I all F G F' G' p b p' b' alpha1 alpha2 alpha3 low high Hall HC s); try lra.
- intros i t Ht. apply moving, Ht.
- intros t Ht. apply inN, Ht.
Qed.

Lemma B_goes s : 0 <= s -> is_derive B s (al2 s * P s + al3 s * B s).
Proof.
intros Hs. apply (B_rate I all F G F' G' p b p' b' alpha1 alpha2 alpha3 low high Hall HC s); try lra.
- intros i t Ht. apply moving, Ht.
- intros t Ht. apply inN, Ht.
Qed.

Lemma lam0_pos : 0 < lam0.
Proof. apply Rdiv_lt_0_compat; lra. Qed.

Lemma force_at_least s : 0 <= s -> B s < 0 /\ lam0 <= lam s.
Proof.
intros Hs. assert (Pp := Ppos s Hs). assert (L0 := lam0_pos).
assert (FP := force_positive I all F G F' G' p b p' b' alpha1 alpha2 alpha3 low high p1 b1 Hall HC start Hp0
  Hb0 s xi (starts _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HA) (fun i t H => moving i t (proj1 H))
  (fun t H => inN t (proj1 H)) lam0).
destruct FP with (s := s) as [N Q]; try lra.
- right. unfold lam0. field. lra.
- intros v Hv. destruct (Halpha v Hv). nra.
- split; [exact N|]. fold (P s) (B s) in Q. unfold lam. apply Rmult_le_reg_r with (P s); [exact Pp|].
  replace (- B s / P s * P s) with (- B s) by (field; apply Rgt_not_eq, Pp). exact Q.
Qed.

Let k := d - A / lam0.

Lemma k_pos : 0 < k.
Proof.
assert (L0 := lam0_pos). unfold k. apply Rmult_lt_reg_r with lam0; auto.
replace ((d - A / lam0) * lam0) with (d * lam0 - A) by (field; lra). lra.
Qed.

Lemma force_grows s : 0 <= s -> lam0 * exp (k * s) <= lam s.
Proof.
intros Hs. assert (L0 := lam0_pos). assert (E := exp_pos (k * s)).
assert (D : - (- B s / P s * exp (- (k * s))) <= - (- B 0 / P 0 * exp (- (k * 0)))).
{ apply (decr_of_derive (fun s => - (- B s / P s * exp (- (k * s)))) (fun s =>
    - (((- (al2 s * P s + al3 s * B s) * P s + B s * (al1 s * P s)) / (P s * P s) - k * (- B s / P s))
      * exp (- (k * s)))) 0 s Hs).
  - intros r Hr. apply (is_derive_opp (fun s => - B s / P s * exp (- (k * s)))), quotient_derive.
    apply P_goes. lra. apply B_goes. lra. apply Rgt_not_eq, Ppos. lra.
  - intros r Hr. assert (Pp := Ppos r ltac:(lra)). change (0 < P r) in Pp.
    destruct (force_at_least r ltac:(lra)) as [_ L1]. destruct (Halpha _ (inN r ltac:(lra))) as [H1 H2].
    fold (al1 r) (al3 r) in H1. fold (al2 r) in H2.
    replace ((- (al2 r * P r + al3 r * B r) * P r + B r * (al1 r * P r)) / (P r * P r) - k * (- B r / P r))
      with ((al3 r - al1 r) * lam r - al2 r - k * lam r) by (unfold lam; field; lra).
    assert (Q : A <= A / lam0 * lam r).
    { apply Rle_trans with (A / lam0 * lam0); [right; field; lra|]. apply Rmult_le_compat_l; auto.
      apply Rmult_le_pos; [auto|apply Rlt_le, Rinv_0_lt_compat, L0]. }
    assert (0 <= (al3 r - al1 r) * lam r - al2 r - k * lam r) by (unfold k; nra).
    assert (E' := exp_pos (- (k * r))). nra. }
rewrite Rmult_0_r, Ropp_0, exp_0, Rmult_1_r, exp_Ropp in D.
unfold B at 2, P at 2 in D. rewrite (state_0 I start xi (starts _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HA)) in D.
fold lam0 (lam s) in D. apply Rmult_le_reg_r with (/ exp (k * s)). apply Rinv_0_lt_compat, E.
rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra. lra.
Qed.

(** p, |b| and all distances from the G-spot fall like e^(- m s/2), m = min(a1, a3). *)
Let m := Rmin a1 a3.

Lemma spot_fast : exists c, 0 <= c /\ forall s i, 0 <= s -> Rabs (xi i s - spot i) <= c * exp (- (m / 2 * s)).
Proof.
destruct (sizes I F G alpha1 alpha2 alpha3 first last low high a1 a3 A2 p1 b1 f g HN) as [A20 FG].
assert (A1 := a1_positive _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN).
assert (A3 := a3_positive _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN).
assert (I1 := Rinv_0_lt_compat _ A1). assert (I3 := Rinv_0_lt_compat _ A3).
set (C := B 0 ^ 2 + (A2 ^ 2 / (a1 * a3) + 1) * P 0 ^ 2).
assert (Fall : forall s, 0 <= s -> (P s ^ 2 + B s ^ 2) * exp (m * s) <= C).
{ intros s Hs. apply (both_fall I all F G F' G' p b p' b' alpha1 alpha2 alpha3 first last low high a1 a3 A2 p1 b1 f g
    Hall HC HN s xi (fun i t H => moving i t (proj1 H)) (fun t H => inN t (proj1 H)) s). lra. }
assert (C0 : 0 <= C).
{ specialize (Fall 0 (Rle_refl 0)). rewrite Rmult_0_r, exp_0 in Fall.
  generalize (pow2_ge_0 (P 0)) (pow2_ge_0 (B 0)). lra. }
set (r := sqrt C). assert (r0 : 0 <= r) by apply sqrt_pos. assert (rr : r * r = C) by (apply sqrt_sqrt; auto).
assert (Both : forall s, 0 <= s -> P s <= r * exp (- (m / 2 * s)) /\ Rabs (B s) <= r * exp (- (m / 2 * s))).
{ intros s Hs. specialize (Fall s Hs). set (e := exp (- (m / 2 * s))). assert (e0 : 0 < e) by apply exp_pos.
  assert (ee : e * e * exp (m * s) = 1).
  { unfold e. rewrite <- !exp_plus. replace (- (m / 2 * s) + - (m / 2 * s) + m * s) with 0 by field. apply exp_0. }
  assert (W : P s ^ 2 + B s ^ 2 <= (r * e) * (r * e)).
  { replace (r * e * (r * e)) with (C * (e * e)) by (rewrite <- rr; ring).
    replace (P s ^ 2 + B s ^ 2) with ((P s ^ 2 + B s ^ 2) * (e * e * exp (m * s))) by (rewrite ee; ring).
    replace ((P s ^ 2 + B s ^ 2) * (e * e * exp (m * s))) with ((P s ^ 2 + B s ^ 2) * exp (m * s) * (e * e)) by ring.
    apply Rmult_le_compat_r; [|exact Fall]. apply Rmult_le_pos; lra. }
  assert (re : 0 <= r * e) by (apply Rmult_le_pos; lra).
  assert (BB : Rabs (B s) * Rabs (B s) = B s ^ 2).
  { rewrite <- Rabs_mult, Rabs_pos_eq; [ring|apply Rle_0_sqr]. }
  generalize (pow2_ge_0 (P s)) (pow2_ge_0 (B s)). intros.
  split; apply Rsqr_incr_0_var; unfold Rsqr; lra. }
set (each i := f i / a1 + g i * ((1 + A2 / a1) / a3)).
assert (E0 : forall i, 0 <= each i).
{ intros i. destruct (FG i) as [Hf Hg]. unfold each, Rdiv. assert (0 <= A2 * / a1) by (apply Rmult_le_pos; lra).
  apply Rplus_le_le_0_compat; repeat apply Rmult_le_pos; lra. }
exists (total all each * r). split. { apply Rmult_le_pos; [apply total_nonneg, E0|exact r0]. }
intros s i Hs. destruct (Both s Hs) as [BP BB]. destruct (FG i) as [Hf Hg]. set (e := exp (- (m / 2 * s))) in *.
assert (re : 0 <= r * e) by (apply Rmult_le_pos; [lra|apply Rlt_le, exp_pos]).
eapply Rle_trans; [apply (nearer _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HA s i Hs)|]. fold (P s) (B s).
apply Rle_trans with (reach a1 a3 A2 (r * e) (r * e) (f i) (g i)).
{ apply reach_le; auto. rewrite (Rabs_pos_eq (r * e)); auto. }
unfold reach. rewrite Rabs_pos_eq by auto.
replace (f i * (r * e / a1) + g i * ((r * e + A2 * (r * e / a1)) / a3)) with (each i * (r * e))
  by (unfold each; field; lra).
rewrite Rmult_assoc. apply Rmult_le_compat_r; auto. apply total_term; auto.
Qed.

Let beta := alpha3 spot / alpha1 spot.
Let V s := ln (- B s) + - beta * ln (P s).

Lemma V_limit_below : exists l : R, is_lim V p_infty l.
Proof.
assert (SN : in_box low high spot) by apply (at_the_spot _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HA).
destruct (on_the_box _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN _ SN) as (S1 & _).
assert (A1 := a1_positive _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN).
assert (A3 := a3_positive _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN).
assert (S3 : alpha3 spot = beta * alpha1 spot) by (unfold beta; field; lra).
destruct (sizes I F G alpha1 alpha2 alpha3 first last low high a1 a3 A2 p1 b1 f g HN) as [A20 _].
destruct (smooth_lipschitz I all low high Hall alpha1 d1 Hd1) as (K1 & K10 & H1).
destruct (smooth_lipschitz I all low high Hall alpha3 d3 Hd3) as (K3 & K30 & H3).
destruct spot_fast as (c & c0 & Hc). assert (L0 := lam0_pos). assert (k0 := k_pos).
set (K := K3 + Rabs beta * K1). assert (K0 : 0 <= K).
{ unfold K. assert (0 <= Rabs beta * K1) by (apply Rmult_le_pos; [apply Rabs_pos|auto]). lra. }
assert (m0 : 0 < m) by (apply Rmin_pos; auto). set (q := Rmin (m / 2) k).
assert (q0 : 0 < q) by (apply Rmin_pos; lra). assert (Q1 : q <= m / 2) by apply Rmin_l.
assert (Q2 : q <= k) by apply Rmin_r.
assert (Al : 0 <= A2 / lam0) by (apply Rmult_le_pos; [auto|apply Rlt_le, Rinv_0_lt_compat, L0]).
assert (Kc : 0 <= K * c) by (apply Rmult_le_pos; auto).
apply (limit_of_decaying V (fun s => al3 s - beta * al1 s - al2 s / lam s) (K * c + A2 / lam0) q); auto; [lra| |].
- intros s Hs. assert (Pp := Ppos s Hs). change (0 < P s) in Pp. destruct (force_at_least s Hs) as [Bn _].
  eapply is_derive_val.
  + apply (ln_derive (fun s => - B s) P); [apply (is_derive_opp B), B_goes, Hs|apply P_goes, Hs|lra|exact Pp].
  + unfold opp; simpl. unfold lam. field. lra.
- intros s Hs. assert (Pp := Ppos s Hs). assert (U := force_grows s Hs). assert (E := exp_pos (k * s)).
  assert (Zp : 0 < lam0 * exp (k * s)) by (apply Rmult_lt_0_compat; auto).
  assert (Es : forall n, q <= n -> exp (- (n * s)) <= exp (- (q * s))).
  { intros n Hle. apply exp_le. assert (q * s <= n * s) by (apply Rmult_le_compat_r; lra). lra. }
  assert (T1 : Rabs (al3 s - beta * al1 s) <= K * c * exp (- (q * s))).
  { replace (al3 s - beta * al1 s) with ((al3 s - alpha3 spot) + - (beta * (al1 s - alpha1 spot))) by lra.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp, Rabs_mult.
    assert (N : forall j, Rabs (state xi s j - spot j) <= c * exp (- (m / 2 * s))) by (intros j; apply Hc, Hs).
    specialize (H1 _ _ _ (inN s Hs) SN N). specialize (H3 _ _ _ (inN s Hs) SN N).
    fold (al1 s) in H1. fold (al3 s) in H3.
    apply Rle_trans with (K * (c * exp (- (m / 2 * s)))).
    - unfold K. assert (Rabs beta * Rabs (al1 s - alpha1 spot) <= Rabs beta * (K1 * (c * exp (- (m / 2 * s)))))
        by (apply Rmult_le_compat_l; [apply Rabs_pos|auto]). lra.
    - rewrite <- Rmult_assoc. apply Rmult_le_compat_l; auto. }
  assert (T2 : Rabs (al2 s / lam s) <= A2 / lam0 * exp (- (q * s))).
  { destruct (on_the_box _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HN _ (inN s Hs)) as (_ & _ & B2 & _). fold (al2 s) in B2.
    unfold Rdiv at 1. rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq (lam s)) by lra.
    apply Rle_trans with (A2 * / (lam0 * exp (k * s))).
    - apply Rmult_le_compat; [apply Rabs_pos|apply Rlt_le, Rinv_0_lt_compat; lra|exact B2|].
      apply Rinv_le_contravar; auto.
    - replace (A2 * / (lam0 * exp (k * s))) with (A2 / lam0 * exp (- (k * s))) by (rewrite exp_Ropp; field; lra).
      apply Rmult_le_compat_l; auto. }
  unfold Rminus at 1. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra.
Qed.

Theorem negative_limit : exists C1, C1_below_one alpha1 alpha3 p b xi spot C1 /\ C1 < 0.
Proof.
destruct V_limit_below as (l & Hl). set (c := Rpower (- alpha1 spot) beta). assert (cp : 0 < c) by apply exp_pos.
exists (c * (-1 * exp l)). split.
- unfold C1_below_one. fold beta c. apply (is_lim_ext_loc (fun s => c * (-1 * exp (V s)))).
  + exists 0. intros s Hs. assert (s0 : 0 <= s) by lra. assert (Pp := Ppos s s0). change (0 < P s) in Pp.
    destruct (force_at_least s s0) as [Bn _]. f_equal. fold (P s) (B s). unfold V.
    rewrite exp_plus, exp_ln by lra. replace (- beta * ln (P s)) with (- (beta * ln (P s))) by ring.
    rewrite exp_Ropp. fold (Rpower (P s) beta). field. apply Rgt_not_eq, exp_pos.
  + apply (is_lim_scal_l (fun s => -1 * exp (V s)) c p_infty (-1 * exp l)).
    apply (is_lim_scal_l (fun s => exp (V s)) (-1) p_infty (exp l)).
    apply (is_lim_comp_continuous V exp p_infty l Hl). apply (ex_derive_continuous exp). auto_derive; auto.
- assert (E := exp_pos l). nra.
Qed.

End Below.
