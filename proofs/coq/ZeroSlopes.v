(** * The zeros are continuously differentiable in b

    The implicit function theorem for a zero z(b) that is known to be continuous: with F = dTheta/dtau, -F(z0, b) =
    F_t(xi, b) (z(b) - z0), xi between z0 and z(b); F_t is continuous in (t, b) and not 0 at a simple zero. So z' = -
    F_b/F_t, which is continuous in b, too. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus LaplaceIntegral WellPosed Family CountLaw ContinuityInBeta ZeroCurves
  PowerSeriesNorm NormLimit
  GammaEntire ThetaEntire DifferentiableInBeta.
Import ListNotations.
Open Scope R_scope.

Lemma quotient_close u v p D E eta : D <> 0 -> u * p = - v -> Rabs (v - E) < eta -> Rabs (p - D) < eta ->
  eta <= Rabs D / 2 ->
  Rabs (u - - E / D) <= 2 * eta * (Rabs D + Rabs E) / D ^ 2.
Proof.
intros HD Hu Hv Hp He. assert (AD : 0 < Rabs D) by (apply Rabs_pos_lt, HD).
assert (P : Rabs D / 2 <= Rabs p).
{ assert (T := Rabs_triang p (D - p)). replace (p + (D - p)) with D in T by ring. rewrite (Rabs_minus_sym D p) in T.
  lra. }
assert (Hp0 : p <> 0). { intros ->. rewrite Rabs_R0 in P. lra. }
replace (u - - E / D) with ((- (v - E) * D + E * (p - D)) * / (p * D)).
2: { replace v with (- (u * p)) by lra. field. auto. }
rewrite Rabs_mult, Rabs_inv, Rabs_mult.
assert (N : Rabs (- (v - E) * D + E * (p - D)) <= eta * (Rabs D + Rabs E)).
{ eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult, Rabs_Ropp.
  assert (Rabs (v - E) * Rabs D <= eta * Rabs D) by (apply Rmult_le_compat_r; lra).
  assert (Rabs E * Rabs (p - D) <= Rabs E * eta) by (apply Rmult_le_compat_l; [apply Rabs_pos|lra]). lra. }
assert (HE := Rabs_pos E). assert (D2 : D ^ 2 = Rabs D * Rabs D) by (rewrite <- (pow2_abs D); ring).
apply Rle_trans with (eta * (Rabs D + Rabs E) * / (Rabs D / 2 * Rabs D)).
- apply Rmult_le_compat; auto. apply Rabs_pos. apply Rlt_le, Rinv_0_lt_compat, Rmult_lt_0_compat; lra.
  apply Rinv_le_contravar. apply Rmult_lt_0_compat; lra. apply Rmult_le_compat_r; lra.
- right. rewrite D2. field. lra.
Qed.

Theorem implicit_derive (z : R -> R) (F Ft : R -> R -> R) (b0 Fb : R) :
  continuous z b0 -> locally b0 (fun b => F (z b) b = 0) ->
  locally b0 (fun b => forall t, is_derive (fun t => F t b) t (Ft t b)) ->
  is_derive (fun b => F (z b0) b) b0 Fb -> joint Ft (z b0) b0 -> Ft (z b0) b0 <> 0 ->
  is_derive z b0 (- Fb / Ft (z b0) b0).
Proof.
intros Cz H0 Dt Db Jt Hnz. set (z0 := z b0) in *. set (D := Ft z0 b0) in *.
assert (AD : 0 < Rabs D) by (apply Rabs_pos_lt, Hnz).
assert (F0 : F z0 b0 = 0). { destruct H0 as [d Hd]. apply Hd. apply ball_center. }
apply is_derive_Reals. intros eps Heps.
set (S := Rabs D + Rabs Fb + 1). assert (HS : 0 < S) by (unfold S; generalize (Rabs_pos Fb); lra).
assert (HD2 : 0 < D ^ 2) by (apply pow2_gt_0, Hnz).
set (eta := Rmin (Rabs D / 2) (eps * D ^ 2 / (2 * S))).
assert (He2 : 0 < eps * D ^ 2 / (2 * S)) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; auto|lra]).
assert (Heta : 0 < eta) by (apply Rmin_pos; lra).
assert (E1 : eta <= Rabs D / 2) by apply Rmin_l. assert (E2 : eta <= eps * D ^ 2 / (2 * S)) by apply Rmin_r.
unfold joint in Jt. apply filterlim_locally with (eps := mkposreal _ Heta) in Jt. destruct Jt as [d1 Hd1].
apply filterlim_locally with (eps := d1) in Cz.
apply is_derive_Reals in Db. destruct (Db eta Heta) as [d2 Hd2].
destruct (filter_and _ _ Cz (filter_and _ _ H0 Dt)) as [d3 Hd3].
assert (Hm : 0 < Rmin d1 (Rmin d2 d3)) by (repeat apply Rmin_pos; apply cond_pos).
exists (mkposreal _ Hm). intros h Hh Hhd. simpl in Hhd.
assert (A1 : Rabs h < d1) by (eapply Rlt_le_trans; [exact Hhd|apply Rmin_l]).
assert (A2 : Rabs h < d2) by (eapply Rlt_le_trans; [exact Hhd|eapply Rle_trans; [apply Rmin_r|apply Rmin_l]]).
assert (A3 : Rabs h < d3) by (eapply Rlt_le_trans; [exact Hhd|eapply Rle_trans; [apply Rmin_r|apply Rmin_r]]).
destruct (Hd3 (b0 + h)) as (Z1 & Z2 & Z3).
{ change (Rabs (b0 + h - b0) < d3). replace (b0 + h - b0) with h by ring. exact A3. }
change (Rabs (z (b0 + h) - z b0) < d1) in Z1. fold z0 in Z1 |- *.
specialize (Hd2 h Hh A2). rewrite F0, Rminus_0_r in Hd2.
set (b := b0 + h) in *.
(* the mean value theorem in t *)
assert (M : exists xi, Rabs (xi - z0) < d1 /\ (z b - z0) * Ft xi b = - F z0 b).
{ destruct (Rtotal_order z0 (z b)) as [H|[H|H]].
  - destruct (mvt_open (fun t => F t b) (fun t => Ft t b) z0 (z b) H (fun t _ => Z3 t)) as (c & Hc & E).
    exists c. split. rewrite Rabs_pos_eq in Z1 |- *; lra. rewrite Z2 in E. lra.
  - exists z0. split. unfold Rminus. rewrite Rplus_opp_r, Rabs_R0. apply cond_pos. rewrite H in *. rewrite Z2. ring.
  - destruct (mvt_open (fun t => F t b) (fun t => Ft t b) (z b) z0 H (fun t _ => Z3 t)) as (c & Hc & E).
    exists c. split. rewrite Rabs_left in Z1 |- *; lra. rewrite Z2 in E. lra. }
destruct M as (xi & Hxi & EM).
assert (P : Rabs (Ft xi b - D) < eta).
{ apply (Hd1 (xi, b)). split; [exact Hxi|]. change (Rabs (b - b0) < d1). unfold b. replace (b0 + h - b0) with h by ring.
  exact A1. }
assert (Q := quotient_close ((z b - z0) / h) (F z0 b / h) (Ft xi b) D Fb eta Hnz).
eapply Rle_lt_trans; [apply Q; auto|].
- replace ((z b - z0) / h * Ft xi b) with ((z b - z0) * Ft xi b / h) by (field; auto). rewrite EM. field. auto.
- apply Rle_lt_trans with (2 * (eps * D ^ 2 / (2 * S)) * (Rabs D + Rabs Fb) / D ^ 2).
  + unfold Rdiv at 1 2. apply Rmult_le_compat_r. apply Rlt_le, Rinv_0_lt_compat, HD2.
    apply Rmult_le_compat_r. generalize (Rabs_pos Fb); lra. fold (eps * D ^ 2 / (2 * S)). lra.
  + replace (2 * (eps * D ^ 2 / (2 * S)) * (Rabs D + Rabs Fb) / D ^ 2) with (eps * ((Rabs D + Rabs Fb) / S))
      by (field; lra).
    rewrite <- (Rmult_1_r eps) at 2. apply Rmult_lt_compat_l; auto.
    apply Rmult_lt_reg_r with S; auto. replace ((Rabs D + Rabs Fb) / S * S) with (Rabs D + Rabs Fb) by (field; lra).
    unfold S. lra.
Qed.

(** ** dTheta/dtau *)

Definition slope_in_b : R -> R -> R := family_sum (beta_derived (derived theta_coefficient)).

Lemma Derive_Th b t : not_nat b -> Derive (Th b) t = family_sum (derived theta_coefficient) t b.
Proof. intros Hb. apply Derive_family, Th_entire, Hb. Qed.

Lemma Derive2_Th b t : not_nat b -> Derive_n (Th b) 2 t = family_sum (derived (derived theta_coefficient)) t b.
Proof. intros Hb. apply Derive2_family, Th_entire, Hb. Qed.

Lemma slope_in_b_derive b t : not_nat b -> is_derive (fun b => Derive (Th b) t) b (slope_in_b t b).
Proof.
intros Hb. apply (is_derive_ext_loc (fun b => family_sum (derived theta_coefficient) t b)).
- eapply filter_imp; [|apply (not_nat_open b Hb)]. intros y Hy. symmetry. apply Derive_Th, Hy.
- apply family_beta_derive, derived_entire, theta_family_entire.
Qed.

Lemma slope_in_b_joint b t : joint slope_in_b t b.
Proof. apply family_joint, beta_derived_entire, derived_entire, theta_family_entire. Qed.

Lemma Derive2_joint b t : not_nat b -> joint (fun t b => Derive_n (Th b) 2 t) t b.
Proof.
intros Hb. apply (joint_ext_loc (family_sum (derived (derived theta_coefficient)))).
- eapply filter_imp; [|apply (not_nat_open b Hb)]. intros y Hy u. symmetry. apply Derive2_Th, Hy.
- apply family_joint, derived_entire, derived_entire, theta_family_entire.
Qed.

(** ** The zeros in a cell *)
Section Cell.
Variables (m i : nat) (l : R -> list R).
Hypothesis Hi : (i < m mod 3 + m / 3)%nat.
Hypothesis Hl : forall b, INR m < b < INR m + 1 -> zero_list b (l b).

Let z (b : R) : R := nth i (l b) 0.

Lemma cell_open b : INR m < b < INR m + 1 -> locally b (fun b => INR m < b < INR m + 1).
Proof. intros Hb. apply filter_and; [apply locally_above|apply locally_below]; lra. Qed.

Lemma cell_is_not_nat b : INR m < b < INR m + 1 -> not_nat b.
Proof. intros Hb. apply (cell_not_nat (S m)). unfold cell. rewrite S_INR. lra. Qed.

Lemma l_length b : INR m < b < INR m + 1 -> length (l b) = (m mod 3 + m / 3)%nat.
Proof.
intros Hb. destruct (zero_list_exists m b Hb) as (l' & Z & E). rewrite (zero_list_unique b (l b) l' (Hl b Hb) Z).
exact E.
Qed.

Lemma z_zero b : INR m < b < INR m + 1 -> Derive (Th b) (z b) = 0.
Proof. intros Hb. apply (Hl b Hb). apply nth_In. rewrite (l_length b Hb). exact Hi. Qed.

Lemma z_simple b : INR m < b < INR m + 1 -> Derive_n (Th b) 2 (z b) <> 0.
Proof.
intros Hb. destruct (CountLaw.count_law m b (Th b) Hb (Th_correct b)) as (l' & E & S & Z & D).
apply D. apply Z. apply z_zero, Hb.
Qed.

Lemma z_continuous b : INR m < b < INR m + 1 -> continuous z b.
Proof.
intros Hb. apply filterlim_locally. intros eps.
destruct (ZeroCurves.zeros_continuous m b (l b) eps Hb (Hl b Hb) (cond_pos eps)) as (delta & Hd & H).
destruct (cell_open b Hb) as [d Hcell].
assert (Hm : 0 < Rmin delta d) by (apply Rmin_pos; auto; apply cond_pos).
exists (mkposreal _ Hm). intros y Hy. change (Rabs (y - b) < Rmin delta d) in Hy.
assert (A1 := Rmin_l delta d). assert (A2 := Rmin_r delta d).
assert (Hy' : INR m < y < INR m + 1). { apply Hcell. change (Rabs (y - b) < d). lra. }
destruct (H y (l y) ltac:(lra) (Hl y Hy')) as [_ N].
change (Rabs (z y - z b) < eps). apply N. rewrite (l_length b Hb). exact Hi.
Qed.

Theorem z_derive b : INR m < b < INR m + 1 -> is_derive z b (- slope_in_b (z b) b / Derive_n (Th b) 2 (z b)).
Proof.
intros Hb. assert (Hn := cell_is_not_nat b Hb).
apply (implicit_derive z (fun t b => Derive (Th b) t) (fun t b => Derive_n (Th b) 2 t) b (slope_in_b (z b) b)).
- apply z_continuous, Hb.
- eapply filter_imp; [|apply (cell_open b Hb)]. intros y Hy. apply z_zero, Hy.
- eapply filter_imp; [|apply (cell_open b Hb)]. intros y Hy t.
  destruct (is_Theta_elim y (Th y) (Th_correct y)) as (_ & D1 & _). exact (D1 t).
- apply slope_in_b_derive, Hn.
- apply Derive2_joint, Hn.
- apply z_simple, Hb.
Qed.

Theorem z_slope_continuous b : INR m < b < INR m + 1 -> continuous (Derive z) b.
Proof.
intros Hb. assert (Hn := cell_is_not_nat b Hb).
apply (continuous_ext_loc _ (fun b => -1 * slope_in_b (z b) b * / Derive_n (Th b) 2 (z b))).
{ eapply filter_imp; [|apply (cell_open b Hb)]. intros y Hy. symmetry.
  rewrite (is_derive_unique _ _ _ (z_derive y Hy)). unfold Rdiv.
  match goal with |- ?u = ?v => change (@eq R u v) end. ring. }
assert (Cz := z_continuous b Hb).
apply (continuous_mult (fun b => -1 * slope_in_b (z b) b) (fun b => / Derive_n (Th b) 2 (z b))).
- apply (continuous_mult (fun _ => -1) (fun b => slope_in_b (z b) b)). apply continuous_const.
  apply (joint_along slope_in_b z b Cz), slope_in_b_joint.
- apply continuous_Rinv_comp; [|apply z_simple, Hb].
  apply (joint_along (fun t b => Derive_n (Th b) 2 t) z b Cz), Derive2_joint, Hn.
Qed.
End Cell.
