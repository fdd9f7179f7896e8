(** * The analytic implicit function theorem

    For F(t, b) = sum c_k(b) t^k of an entire family with F(t0, b0) = 0 and a = dF/dt(t0, b0) <> 0. The map Phi(x) = x -
    F(t0 + x, b0 + h)/a = - F(t0, b0 + h)/a + (1 - F_t(t0, b0 + h)/a) x - Q x^2/a takes the power series x(h) of norm at
    most rho on |h| < r into themselves ([iteration_norm]): the first two factors vanish at h = 0. For each h it is a
    contraction of [-rho, rho] ([contraction]), and F(t0 + ., b0 + h) has a zero there ([zero_exists]). So the iterates
    of 0 tend to the zero, and the zero is a power series of h, by [norm_limit]. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus PowerSeriesNorm NormLimit GammaEntire ThetaEntire.
Open Scope R_scope.

(** (t0 + x)^k = t0^k + k t0^(k-1) x + x^2 (second_quotient t0 x k). *)
Fixpoint second_quotient (t0 x : R) (k : nat) : R :=
  match k with
  | O => 0
  | S k => (t0 + x) * second_quotient t0 x k + INR k * t0 ^ pred k
  end.

Lemma second_quotient_correct t0 x k : (t0 + x) ^ k = t0 ^ k + INR k * t0 ^ pred k * x + x ^ 2 * second_quotient t0 x k.
Proof.
induction k as [|k IH]; [simpl; ring|].
change ((t0 + x) ^ S k) with ((t0 + x) * (t0 + x) ^ k). rewrite IH. cbn [second_quotient pred]. rewrite S_INR.
destruct k as [|k]; [simpl; ring|]. cbn [pred]. change (t0 ^ S (S k)) with (t0 * t0 ^ S k).
change (t0 ^ S k) with (t0 * t0 ^ k). ring.
Qed.

Lemma second_quotient_norm r t0 Y x k : 0 < r -> 1 <= Y -> Rabs t0 <= Y -> norm_at_most r Y (fun h => t0 + x h) ->
  norm_at_most r ((4 * Y) ^ k) (fun h => second_quotient t0 (x h) k).
Proof.
intros Hr HY Ht Hx. induction k as [|k IH].
- apply (norm_weaken r (Rabs 0)). rewrite Rabs_R0. simpl. lra. apply norm_const.
- cbn [second_quotient].
  apply (norm_weaken r (Y * (4 * Y) ^ k + Rabs (INR k * t0 ^ pred k))).
  + rewrite Rabs_mult, (Rabs_pos_eq (INR k)), <- RPow_abs by apply pos_INR.
    assert (P : 0 < (4 * Y) ^ k) by (apply pow_lt; lra).
    assert (B : INR k * Rabs t0 ^ pred k <= (4 * Y) ^ k).
    { destruct k as [|k]; [simpl; lra|]. cbn [pred].
      apply Rle_trans with (2 ^ S k * Y ^ S k).
      - apply Rmult_le_compat. apply pos_INR. apply pow_le, Rabs_pos. apply power_of_2.
        apply Rle_trans with (Y ^ k). apply pow_incr. split; [apply Rabs_pos|auto].
        simpl. assert (0 < Y ^ k) by (apply pow_lt; lra). nra.
      - rewrite <- Rpow_mult_distr. apply pow_incr. lra. }
    simpl. nra.
  + apply (norm_plus r _ _ (fun h => (t0 + x h) * second_quotient t0 (x h) k)); auto.
    apply (norm_mult r _ _ (fun h => t0 + x h)); auto. apply norm_const.
Qed.

Section Expansion.
Variable c : nat -> R -> R.
Hypothesis Hc : entire_family c.

Definition second_sum (t0 x b : R) : R := Series (fun k => c k b * second_quotient t0 x k).

(** F(t0 + x, b) = F(t0, b) + F_t(t0, b) x + Q x^2. *)
Lemma second_sum_norm t0 b0 r X : 0 < r -> 0 < X -> exists K, forall r' x, 0 < r' <= r -> norm_at_most r' X x ->
  norm_at_most r' K (fun h => second_sum t0 (x h) (b0 + h)) /\
  forall h, Rabs h < r' -> family_sum c (t0 + x h) (b0 + h)
    = family_sum c t0 (b0 + h) + family_sum (derived c) t0 (b0 + h) * x h + x h ^ 2 * second_sum t0 (x h) (b0 + h).
Proof.
intros Hr HX. set (Y := Rabs t0 + X + 1). assert (A := Rabs_pos t0).
destruct (Hc b0 r (8 * Y) Hr ltac:(unfold Y; lra)) as [M HM]. exists (M * 2). intros r' x Hr' Hx.
assert (HxY : norm_at_most r' Y (fun h => t0 + x h)).
{ apply (norm_weaken r' (Rabs t0 + X)). unfold Y; lra. apply norm_plus; auto; [apply norm_const|lra]. }
assert (T : forall k, norm_at_most r' (M * (1 / 2) ^ k) (fun h => c k (b0 + h) * second_quotient t0 (x h) k)).
{ intros k. apply (norm_weaken r' (M / (8 * Y) ^ k * (4 * Y) ^ k)).
  - right. replace (8 * Y) with (2 * (4 * Y)) by ring. rewrite (Rpow_mult_distr 2), pow_quotient, pow1. field.
    split; apply pow_nonzero; unfold Y; lra.
  - apply (norm_mult r' _ _ (fun h => c k (b0 + h)) (fun h => second_quotient t0 (x h) k)); try lra.
    apply (norm_smaller r); auto. apply second_quotient_norm; auto; unfold Y; lra. }
assert (Sum : forall h, Rabs h < r' ->
  is_lim_seq (fun N => sum_first (fun k => c k (b0 + h) * second_quotient t0 (x h) k) N)
    (second_sum t0 (x h) (b0 + h))).
{ intros h Hh. apply is_lim_seq_incr_1.
  apply (is_lim_seq_ext (sum_n (fun k => c k (b0 + h) * second_quotient t0 (x h) k))).
  { intros N. apply sum_first_sum_n. }
  apply (Series_correct (fun k => c k (b0 + h) * second_quotient t0 (x h) k)).
  apply (ex_series_le (V := R_CompleteNormedModule) _ (fun k => M * (1 / 2) ^ k)).
  - intros k. exact (norm_value r' _ _ h ltac:(lra) (T k) Hh).
  - apply (ex_series_scal (V := R_NormedModule) M (fun k => (1 / 2) ^ k)), ex_series_geom. rewrite Rabs_pos_eq; lra. }
split.
- apply (norm_series r' (fun k h => c k (b0 + h) * second_quotient t0 (x h) k) (fun k => M * (1 / 2) ^ k)); auto;
    try lra.
  intros N. rewrite sum_first_scal. apply Rmult_le_compat_l.
  + assert (V := norm_bound_nonneg _ _ _ (HM 0%nat)). simpl in V. lra.
  + assert (G := sum_geometric (1 / 2) N ltac:(lra)). replace (/ (1 - 1 / 2)) with 2 in G by field. exact G.
- intros h Hh. set (b := b0 + h) in *. set (y := x h) in *.
  assert (L0 := proj1 (is_pseries_sum_first _ _ _) (family_correct c (t0 + y) b Hc)).
  assert (L1 := proj1 (is_pseries_sum_first _ _ _) (family_correct c t0 b Hc)).
  assert (L2 := proj1 (is_pseries_sum_first _ _ _) (family_correct (derived c) t0 b (derived_entire c Hc))).
  assert (L3 := Sum h Hh). fold b y in L3.
  assert (D : is_lim_seq (fun N => sum_first (fun k => INR k * c k b * t0 ^ pred k) N) (family_sum (derived c) t0 b)).
  { apply is_lim_seq_incr_1. apply (is_lim_seq_ext (fun N => sum_first (fun k => derived c k b * t0 ^ k) N)); auto.
    induction n as [|n IH]. simpl. ring. cbn [sum_first] in *. rewrite IH. reflexivity. }
  assert (R := is_lim_seq_plus' _ _ _ _ (is_lim_seq_plus' _ _ _ _ L1 (is_lim_seq_mult' _ _ _ _ D (is_lim_seq_const y)))
    (is_lim_seq_mult' _ _ _ _ (is_lim_seq_const (y ^ 2)) L3)).
  assert (E : is_lim_seq (fun N => sum_first (fun k => c k b * (t0 + y) ^ k) N)
    (family_sum c t0 b + family_sum (derived c) t0 b * y + y ^ 2 * second_sum t0 y b)).
  { apply (is_lim_seq_ext (fun N => sum_first (fun k => c k b * t0 ^ k) N + sum_first (fun k =>
      INR k * c k b * t0 ^ pred k) N * y
      + y ^ 2 * sum_first (fun k => c k b * second_quotient t0 y k) N)); [|exact R].
    intros N. rewrite (sum_first_ext (fun k => c k b * (t0 + y) ^ k)
      (fun k => c k b * t0 ^ k + (y * (INR k * c k b * t0 ^ pred k) + y ^ 2 * (c k b * second_quotient t0 y k)))).
    - rewrite !sum_first_plus, !sum_first_scal. ring.
    - intros k. rewrite second_quotient_correct. ring. }
  apply is_lim_seq_unique in L0. apply is_lim_seq_unique in E. rewrite L0 in E. injection E as E. exact E.
Qed.
End Expansion.

Section Implicit.
Variables (c : nat -> R -> R) (t0 b0 : R).
Hypothesis Hc : entire_family c.
Hypothesis H0 : family_sum c t0 b0 = 0.
Let a := family_sum (derived c) t0 b0.
Hypothesis Ha : a <> 0.

Let F h y := family_sum c (t0 + y) (b0 + h).
Let Phi h y := y - F h y / a.

(** rho and r as the proof needs them. *)
Lemma good_radii : exists rho r, 0 < rho /\ 0 < r /\
  (forall x, norm_at_most r rho x -> norm_at_most r rho (fun h => Phi h (x h))) /\
  (forall h y, Rabs h < r -> Rabs y <= rho -> Rabs (1 - family_sum (derived c) (t0 + y) (b0 + h) / a) <= 1 / 2) /\
  (forall h, Rabs h < r -> Rabs (F h 0 / a) <= rho / 4).
Proof.
assert (Hc1 := derived_entire c Hc). assert (Hc2 := derived_entire _ Hc1).
destruct (second_sum_norm c Hc t0 b0 1 1 Rlt_0_1 Rlt_0_1) as [K HK].
destruct (family_norm c t0 b0 1 Hc Rlt_0_1) as [M0 HM0].
destruct (family_norm (derived c) t0 b0 1 Hc1 Rlt_0_1) as [M1 HM1].
destruct (family_substitute (derived (derived c)) b0 1 (Rabs t0 + 1) Hc2 Rlt_0_1 ltac:(generalize (Rabs_pos t0); lra))
  as [M2 HM2].
assert (Pa : 0 < / Rabs a) by (apply Rinv_0_lt_compat, Rabs_pos_lt, Ha).
assert (K0 : 0 <= K).
{ destruct (HK 1 (fun _ => 0) ltac:(lra)) as [V _]. apply (norm_weaken 1 (Rabs 0)). rewrite Rabs_R0; lra.
  apply norm_const.
  exact (norm_bound_nonneg _ _ _ V). }
assert (V0 := norm_bound_nonneg _ _ _ HM0). assert (V1 := norm_bound_nonneg _ _ _ HM1).
assert (N2 : forall h t, Rabs h < 1 -> Rabs t <= Rabs t0 + 1 -> Rabs (family_sum (derived (derived c)) t (b0 + h))
  <= M2).
{ intros h t Hh Ht. apply (norm_value 1 M2 (fun h => family_sum (derived (derived c)) t (b0 + h)) h Rlt_0_1); auto.
  apply (HM2 1 (fun _ => t)). lra. apply (norm_weaken 1 (Rabs t)); auto. apply norm_const. }
assert (V2 : 0 <= M2). { eapply Rle_trans; [apply Rabs_pos|apply (N2 0 t0)]. rewrite Rabs_R0; lra. lra. }
set (B := (K + M2) * / Rabs a). assert (HB : 0 <= B) by (unfold B; apply Rmult_le_pos; lra).
set (rho := / (4 * (B + 1))). assert (Hrho : 0 < rho) by (apply Rinv_0_lt_compat; lra).
assert (Erho : rho * B + rho = 1 / 4) by (unfold rho; field; lra).
assert (RB : rho * B <= 1 / 4 /\ rho <= 1 / 4). { assert (0 <= rho * B) by (apply Rmult_le_pos; lra). lra. }
assert (EB : rho * B = rho * K * / Rabs a + rho * M2 * / Rabs a) by (unfold B; ring).
assert (BK : 0 <= rho * K * / Rabs a) by (repeat apply Rmult_le_pos; lra).
assert (BM : 0 <= rho * M2 * / Rabs a) by (repeat apply Rmult_le_pos; lra).
set (C := M0 * / Rabs a + (M1 * / Rabs a + 1)).
assert (P0 : 0 <= M0 * / Rabs a) by (apply Rmult_le_pos; lra).
assert (P1 : 0 <= M1 * / Rabs a) by (apply Rmult_le_pos; lra).
set (r := rho / (4 * C)). assert (HC : 1 <= C) by (unfold C; lra).
assert (Hr : 0 < r) by (apply Rdiv_lt_0_compat; lra).
assert (ErC : r * C = rho / 4) by (unfold r; field; lra).
assert (Hr1 : r <= 1) by nra.
assert (R0 : M0 * / Rabs a * r <= rho / 4 /\ (M1 * / Rabs a + 1) * r <= 1 / 4).
{ assert (0 <= M0 * / Rabs a * r) by (apply Rmult_le_pos; lra).
  assert (0 <= (M1 * / Rabs a + 1) * r) by (apply Rmult_le_pos; lra).
  assert (E : r * C = M0 * / Rabs a * r + (M1 * / Rabs a + 1) * r) by (unfold C; ring). lra. }
assert (A0 : norm_at_most r (rho / 4) (fun h => - / a * family_sum c t0 (b0 + h))).
{ apply (norm_weaken r (Rabs (/ a) * M0 * (r / 1))). { rewrite Rabs_inv. unfold Rdiv at 1. rewrite Rinv_1. lra. }
  apply (norm_vanishing 1 r _ (fun h => - / a * family_sum c t0 (b0 + h))); auto.
  - rewrite Rplus_0_r, H0. ring.
  - rewrite <- (Rabs_Ropp (/ a)). apply norm_scal, HM0. }
assert (A1 : norm_at_most r (1 / 4) (fun h => 1 - family_sum (derived c) t0 (b0 + h) / a)).
{ apply (norm_weaken r ((1 + Rabs (/ a) * M1) * (r / 1))). { rewrite Rabs_inv. unfold Rdiv at 1. rewrite Rinv_1. lra. }
  apply (norm_vanishing 1 r _ (fun h => 1 - family_sum (derived c) t0 (b0 + h) / a)); auto.
  - rewrite Rplus_0_r. fold a. field. exact Ha.
  - apply (norm_ext 1 _ (fun h => 1 + - / a * family_sum (derived c) t0 (b0 + h))). { intros h _. unfold Rdiv. ring. }
    apply norm_plus; try lra. apply (norm_weaken 1 (Rabs 1)). rewrite Rabs_R1; lra. apply norm_const.
    rewrite <- (Rabs_Ropp (/ a)). apply norm_scal, HM1. }
exists rho, r. refine (conj Hrho (conj Hr (conj _ (conj _ _)))).
- intros x Hx. destruct (HK r x ltac:(lra)) as [HQ HE]. { apply (norm_weaken r rho); auto; lra. }
  apply (norm_ext r _ (fun h => - / a * family_sum c t0 (b0 + h)
    + ((1 - family_sum (derived c) t0 (b0 + h) / a) * x h + - / a * (x h ^ 2 * second_sum c t0 (x h) (b0 + h))))).
  { intros h Hh. unfold Phi, F. rewrite HE by auto. field. exact Ha. }
  apply (norm_weaken r (rho / 4 + (1 / 4 * rho + Rabs (- / a) * (rho ^ 2 * K)))).
  { rewrite Rabs_Ropp, Rabs_inv. replace (/ Rabs a * (rho ^ 2 * K)) with (rho * (rho * K * / Rabs a)) by ring. nra. }
  apply norm_plus; auto. apply norm_plus; auto.
  + apply (norm_mult r _ _ (fun h => 1 - family_sum (derived c) t0 (b0 + h) / a)); auto.
  + apply norm_scal. apply (norm_mult r _ _ (fun h => x h ^ 2)); auto. apply norm_pow; auto.
- intros h y Hh Hy. assert (Y := norm_value r _ _ h Hr A1 Hh). cbv beta in Y.
  assert (D : Rabs (family_sum (derived c) (t0 + y) (b0 + h) - family_sum (derived c) t0 (b0 + h)) <= M2 * Rabs y).
  { destruct (MVT_gen (fun t => family_sum (derived c) t (b0 + h)) t0 (t0 + y) (fun t =>
      family_sum (derived (derived c)) t (b0 + h))) as (xi & Hxi & E).
    - intros t _. apply family_derive, Hc1.
    - intros t _. apply derivable_continuous_pt. eexists. apply is_derive_Reals, family_derive, Hc1.
    - rewrite E, Rabs_mult. replace (t0 + y - t0) with y by ring. apply Rmult_le_compat_r. apply Rabs_pos. apply N2.
      lra.
      replace xi with (t0 + (xi - t0)) by ring. eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_l.
      assert (Hy' := proj1 (Rabs_le_between _ _) Hy). apply Rabs_le.
      revert Hxi. unfold Rmin, Rmax. destruct Rle_dec; lra. }
  replace (1 - family_sum (derived c) (t0 + y) (b0 + h) / a) with ((1 - family_sum (derived c) t0 (b0 + h) / a)
    + - / a * (family_sum (derived c) (t0 + y) (b0 + h) - family_sum (derived c) t0 (b0 + h))) by (field; exact Ha).
  eapply Rle_trans; [apply Rabs_triang|]. rewrite (Rabs_mult (- / a)), Rabs_Ropp, Rabs_inv.
  assert (/ Rabs a * Rabs (family_sum (derived c) (t0 + y) (b0 + h) - family_sum (derived c) t0 (b0 + h))
    <= rho * M2 * / Rabs a); [|lra].
  rewrite Rmult_comm. apply Rmult_le_compat_r; [lra|]. eapply Rle_trans; [exact D|]. rewrite Rmult_comm.
  apply Rmult_le_compat_r; auto.
- intros h Hh. assert (Y := norm_value r _ _ h Hr A0 Hh). cbv beta in Y. unfold F. rewrite Rplus_0_r.
  replace (family_sum c t0 (b0 + h) / a) with (- (- / a * family_sum c t0 (b0 + h))) by (field; exact Ha).
  rewrite Rabs_Ropp. exact Y.
Qed.

(** Plan: Phi h y = y - F h y/a halves distances ([good_radii]: its slope is at most 1/2). So F h has one zero in [-rho,
    rho]: one by the intermediate value theorem, no two since both would be fixed points of Phi h. The iterates of Phi h
    from 0 have norms at most rho and tend to it: so it is a power series in h with norm at most rho. *)
Theorem implicit_analytic : exists z rho r M, 0 < rho /\ 0 < r /\ norm_at_most r M z /\ z 0 = 0 /\
  forall h y, Rabs h < r -> Rabs y <= rho -> (family_sum c (t0 + y) (b0 + h) = 0 <-> y = z h).
Proof.
destruct good_radii as (rho & r & Hrho & Hr & HN & HD & HF).
assert (DP : forall h y, is_derive (Phi h) y (1 - family_sum (derived c) (t0 + y) (b0 + h) / a)).
{ intros h y. set (d := family_sum (derived c) (t0 + y) (b0 + h)).
  assert (DF : is_derive (F h) y d).
  { apply (is_derive_val _ _ (1 * d)); [|apply Rmult_1_l].
    apply (is_derive_comp (fun t => family_sum c t (b0 + h)) (fun y => t0 + y) y d 1). apply family_derive, Hc.
    auto_derive; auto; ring. }
  apply (is_derive_val _ _ (1 - / a * d)); [|unfold Rdiv; rewrite (Rmult_comm d); reflexivity].
  apply (is_derive_ext (fun y => y - / a * F h y)).
  { intros t. unfold Phi. match goal with |- ?u = ?v => change (@eq R u v) end. field. exact Ha. }
  apply (is_derive_minus (fun y => y) (fun y => / a * F h y)). apply (is_derive_id (K := R_AbsRing)).
  apply (is_derive_scal (F h)), DF. }
assert (L : forall h y w, Rabs h < r -> Rabs y <= rho -> Rabs w <= rho -> Rabs (Phi h w - Phi h y) <= / 2 * Rabs
  (w - y)).
{ intros h y w Hh Hy Hw.
  destruct (MVT_gen (Phi h) y w (fun y => 1 - family_sum (derived c) (t0 + y) (b0 + h) / a)) as (xi & Hxi & E).
  - intros t _. apply DP.
  - intros t _. apply derivable_continuous_pt. eexists. apply is_derive_Reals, DP.
  - rewrite E, Rabs_mult. apply Rmult_le_compat_r. apply Rabs_pos.
    assert (Hxi' : Rabs xi <= rho).
    { apply Rabs_le_between in Hy. apply Rabs_le_between in Hw. apply Rabs_le.
      revert Hxi. unfold Rmin, Rmax. destruct Rle_dec; lra. }
    assert (Q := HD h xi Hh Hxi'). lra. }
assert (Z : forall h, Rabs h < r -> exists y, Rabs y <= rho /\ F h y = 0).
{ intros h Hh.
  assert (Eq : Rabs (- rho) = rho) by (rewrite Rabs_Ropp; apply Rabs_pos_eq; lra).
  assert (Ep : Rabs rho = rho) by (apply Rabs_pos_eq; lra).
  assert (L1 := L h 0 rho Hh ltac:(rewrite Rabs_R0; lra) ltac:(lra)).
  assert (L2 := L h 0 (- rho) Hh ltac:(rewrite Rabs_R0; lra) ltac:(lra)).
  rewrite Rminus_0_r in L1, L2. rewrite Ep in L1. rewrite Eq in L2.
  assert (Y := HF h Hh). apply Rabs_le_between in Y. apply Rabs_le_between in L1. apply Rabs_le_between in L2.
  unfold Phi in L1, L2.
  destruct (IVT_gen (fun y => F h y / a) (- rho) rho 0) as (y & Hy & E).
  - apply derive_continuity with (fun y => 1 - (1 - family_sum (derived c) (t0 + y) (b0 + h) / a)). intros y.
    apply (is_derive_ext (fun y => y - Phi h y)).
    { intros t. unfold Phi. match goal with |- ?u = ?v => change (@eq R u v) end. ring. }
    apply (is_derive_minus (fun y => y) (Phi h)). apply (is_derive_id (K := R_AbsRing)). apply DP.
  - unfold Rmin, Rmax. destruct Rle_dec; lra.
  - exists y. split.
    + apply Rabs_le. revert Hy. unfold Rmin, Rmax. destruct Rle_dec; lra.
    + replace (F h y) with (F h y / a * a) by (field; exact Ha). rewrite E. ring. }
assert (Fix : forall h y, F h y = 0 <-> Phi h y = y).
{ intros h y. unfold Phi. split; intros E. rewrite E. field. exact Ha.
  replace (F h y) with (F h y / a * a) by (field; exact Ha). replace (F h y / a) with 0 by lra. ring. }
set (x := fun k : nat => Nat.iter k (fun x h => Phi h (x h)) (fun _ => 0)).
assert (Nx : forall k, norm_at_most r rho (x k)).
{ induction k as [|k IH]. apply (norm_weaken r (Rabs 0)). rewrite Rabs_R0; lra. apply norm_const. apply (HN (x k) IH). }
set (z := fun h => real (Lim_seq (fun k => x k h))).
assert (Hz : forall h y, Rabs h < r -> Rabs y <= rho -> F h y = 0 -> is_lim_seq (fun k => x k h) y).
{ intros h y Hh Hy E. apply Fix in E.
  assert (B : forall k, Rabs (x k h - y) <= rho * (/ 2) ^ k).
  { induction k as [|k IH].
    - simpl. rewrite Rmult_1_r. unfold Rminus. rewrite Rplus_0_l, Rabs_Ropp. exact Hy.
    - change (x (S k) h) with (Phi h (x k h)). rewrite <- E at 1. assert (V := norm_value r _ _ h Hr (Nx k) Hh).
      eapply Rle_trans; [apply L; auto|]. simpl. lra. }
  assert (G : is_lim_seq (fun k => rho * (/ 2) ^ k) 0).
  { replace (Finite 0) with (Rbar_mult rho 0) by (simpl; f_equal; ring).
    apply (is_lim_seq_scal_l _ rho 0), is_lim_seq_geom. rewrite Rabs_pos_eq; lra. }
  apply (is_lim_seq_le_le (fun k => y - rho * (/ 2) ^ k) _ (fun k => y + rho * (/ 2) ^ k)).
  - intros k. specialize (B k). apply Rabs_le_between in B. lra.
  - replace (Finite y) with (Finite (y - 0)) by (f_equal; ring). apply is_lim_seq_minus'; auto. apply is_lim_seq_const.
  - replace (Finite y) with (Finite (y + 0)) by (f_equal; ring). apply is_lim_seq_plus'; auto. apply is_lim_seq_const. }
assert (Uz : forall h y, Rabs h < r -> Rabs y <= rho -> F h y = 0 -> y = z h).
{ intros h y Hh Hy E. unfold z. rewrite (is_lim_seq_unique _ _ (Hz h y Hh Hy E)). reflexivity. }
exists z, rho, r, rho. refine (conj Hrho (conj Hr (conj _ (conj _ _)))).
- apply (norm_limit (Fl := eventually) x z (fun _ => rho) r rho Hr).
  + apply filter_forall, Nx.
  + apply tends_const.
  + intros h Hh. destruct (Z h Hh) as (y & Hy & E). rewrite <- (Uz h y Hh Hy E). apply (Hz h y Hh Hy E).
- symmetry. apply Uz; try (rewrite Rabs_R0; lra). unfold F. rewrite !Rplus_0_r. exact H0.
- intros h y Hh Hy. split; intros E. apply (Uz h y Hh Hy E).
  destruct (Z h Hh) as (w & Hw & Ew). rewrite E, <- (Uz h w Hh Hw Ew). exact Ew.
Qed.
End Implicit.
