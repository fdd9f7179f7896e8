(** * Continuity in b, and b -> n

    Off the integers Theta is the sum of an entire family, which is continuous in b everywhere ([ThetaEntire.v]); at b =
    n that sum is P_n(t). So Theta(t, b) -> P_n(t) as b -> n. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus WellPosed Family IntegerPolynomials PolynomialSum EntireForm
  PowerSeriesNorm NormLimit GammaEntire ThetaEntire.
Open Scope R_scope.

(** next to every real number, that number excepted, there are no natural numbers *)
Lemma near_not_nat (b : R) : Rbar_locally' b not_nat.
Proof.
assert (Hex : exists d, 0 < d /\ forall k : nat, INR k <> b -> d <= Rabs (INR k - b)).
{ destruct (Rlt_le_dec b 0) as [H|H].
  - exists (- b). split; [lra|]. intros k _. rewrite Rabs_pos_eq; generalize (pos_INR k); lra.
  - destruct (nfloor_ex b H) as [n [H1 H2]].
    destruct (Rle_lt_or_eq_dec _ _ H1) as [Hn|Hn].
    + exists (Rmin (b - INR n) (INR n + 1 - b)). split; [apply Rmin_pos; lra|]. intros k _.
      destruct (le_lt_dec k n) as [Hk|Hk].
      * apply le_INR in Hk. eapply Rle_trans; [apply Rmin_l|]. rewrite Rabs_left1; lra.
      * assert (Hk2 : INR (S n) <= INR k) by (apply le_INR; lia). rewrite S_INR in Hk2.
        eapply Rle_trans; [apply Rmin_r|]. rewrite Rabs_pos_eq; lra.
    + exists 1. split; [lra|]. intros k Hk. rewrite <- Hn in *.
      destruct (lt_eq_lt_dec k n) as [[Hkn|Hkn]|Hkn].
      * assert (Hk2 : INR (S k) <= INR n) by (apply le_INR; lia). rewrite S_INR in Hk2. rewrite Rabs_left1; lra.
      * subst k; congruence.
      * assert (Hk2 : INR (S n) <= INR k) by (apply le_INR; lia). rewrite S_INR in Hk2. rewrite Rabs_pos_eq; lra. }
destruct Hex as (d & Hd & Hk).
exists (mkposreal _ Hd). intros y Hy Hne k ->. specialize (Hk k Hne).
unfold ball in Hy; simpl in Hy; unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy.
unfold Rminus in Hk. lra.
Qed.

Lemma not_nat_open b : not_nat b -> locally b not_nat.
Proof.
intros Hb. destruct (near_not_nat b) as [d Hd]. exists d. intros y Hy. destruct (Req_dec y b) as [->|Hn]; auto.
Qed.

Lemma Th_entire b : not_nat b -> is_Theta_entire b (Th b).
Proof. intros Hb. apply entire_initial_values; auto. apply Th_correct. Qed.

Lemma Th_family b t : not_nat b -> Th b t = family_sum theta_coefficient t b.
Proof. intros Hb. exact (entire_series b (Th b) (Th_entire b Hb) t). Qed.

Lemma norm_continuous r M f : 0 < r -> norm_at_most r M f -> continuous f 0.
Proof.
intros Hr (a & Ha & Hf). apply (continuous_ext_loc _ (PSeries a)).
- exists (mkposreal r Hr). intros y Hy. change (Rabs (y - 0) < r) in Hy. rewrite Rminus_0_r in Hy.
  apply is_pseries_unique, Hf, Hy.
- apply (ex_derive_continuous (PSeries a)). eexists. apply is_derive_PSeries, (radius_at_least a r M Hr Ha).
  rewrite Rabs_R0. exact Hr.
Qed.

Lemma entire_continuous f b : entire f -> continuous f b.
Proof.
intros H. destruct (H b 1 Rlt_0_1) as [M HM]. apply (continuous_ext (fun x => f (b + (x - b)))).
- intros x. f_equal. apply Rplus_minus.
- apply (continuous_comp (fun x => x - b) (fun h => f (b + h))).
  + apply (ex_derive_continuous (fun x => x - b)). auto_derive; auto.
  + unfold Rminus. rewrite Rplus_opp_r. apply (norm_continuous 1 M _ Rlt_0_1 HM).
Qed.

Lemma Th_lim (b t : R) : is_lim (fun b => Th b t) b (family_sum theta_coefficient t b).
Proof.
apply (is_lim_ext_loc (fun b => family_sum theta_coefficient t b)).
- eapply filter_imp; [|apply (near_not_nat b)]. intros y Hy. symmetry. apply Th_family, Hy.
- apply (is_lim_continuity (family_sum theta_coefficient t)), continuity_pt_filterlim, entire_continuous,
    sum_in_beta_entire.
Qed.

Theorem Th_lim_not_nat (b t : R) : not_nat b -> is_lim (fun b => Th b t) b (Th b t).
Proof. intros Hb. rewrite (Th_family b t Hb). apply Th_lim. Qed.

Theorem Th_lim_integer (n : nat) : forall t, is_lim (fun b => Th b t) (INR n) (Pn n t).
Proof.
intros t. rewrite <- Poly_Pn, (entire_series (INR n) (Poly n)); [apply Th_lim|].
apply (proj2 (entire_initial_values (INR n) (Poly n)) n eq_refl). reflexivity.
Qed.
