(** * The theorems

    Each statement of [Statement.v], [StatementModels.v], [StatementCompliant.v], [StatementFlight.v],
    [StatementStep.v], [StatementApproach.v], [StatementPassage.v], [StatementCertificate.v], [StatementChecker.v],
    [StatementForce.v] and [StatementRun.v] is proved here under its own name, from the files named for the steps. *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Calculus TruncatedIntegral GammaFunction LaplaceIntegral WellPosed ImproperIntegral
  EnvelopingSeries Family SignsAtZero SignPattern PositiveZeros CountLaw IntegerPolynomials PolynomialSum Ends
  RecurrenceTail FoldAndHinge ContinuityInBeta ZeroCurves ZerosAtInteger CompliantKernel CompliantIntegral
  CompliantSlow CompliantMechanism CompliantUnique InitialValueProblem CompliantMotion CompliantForward CompliantZeros
  CompliantLimit CompliantCases CompliantOpen CompliantSlowMotion CompliantFlight CompliantSlowFlight CompliantTouchDown
  CompliantOneFlight
  CompliantLateCone CompliantStable CompliantEveryState LeftExpansion CompliantMonotone CompliantThreshold EnvelopingLow
  GammaMultiplication EntireForm DifferentiableInBeta ZeroSlopes DerivativeTail CompliantDeviation EtaSeries
  ExponentPowers CompliantSeries CompliantPolynomial CompliantCorrection CompliantPower CompliantLaw CompliantUpper
  CompliantCritical CertificateWalk CertificateFamily CertificatePieces CertificateForce CertificateSlow
  BudanFourier BudanTails GammaEntire ThetaEntire AnalyticZeros CheckerSound CheckerCounts CheckerRuns DipSound.
From GSpot Require CompliantGrowth CompliantGrowthSet BoxModel RoundedStep CarriedModel SignOnBox StatementStep
  ValidatedStep Events StatementApproach Capture SignOfC1 NegativeC1 StatementPassage PassageEquations PassageNorm
  PassageForce PassageDrift StatementForce ForceRuns StatementRun RunRuns Majorant FinitePart SaddleRemainder
  PositiveSeries.
From GSpot Require Import Statement StatementModels StatementCompliant StatementFlight StatementCertificate
  StatementChecker.
Import ListNotations.
Open Scope R_scope.

(** ** The definitions are right *)

Theorem gamma_is_euler : Statement.gamma_is_euler.
Proof. exact Gamma_correct. Qed.

Theorem gamma_equation : Statement.gamma_equation.
Proof. exact Gamma_rec. Qed.

Theorem gamma_unique : Statement.gamma_unique.
Proof. exact Gamma_unique. Qed.

Theorem recip_gamma : Statement.recip_gamma.
Proof. exact reciprocal_gamma. Qed.

Theorem gauss_multiplication : Statement.gauss_multiplication.
Proof. exact EntireForm.gauss_multiplication. Qed.

Theorem theta_exists : Statement.theta_exists.
Proof. exact Theta_exists. Qed.

Theorem theta_unique : Statement.theta_unique.
Proof. exact Theta_unique. Qed.

Theorem theta_asymptotics : Statement.theta_asymptotics.
Proof. exact Theta_asymptotics. Qed.

(** ** Integral, identities, series *)

Theorem laplace_integral : Statement.laplace_integral.
Proof. exact Theta_representation. Qed.

Theorem sign_of_derivatives : Statement.sign_of_derivatives.
Proof. exact Theta_sign. Qed.

Theorem derivative_identity : Statement.derivative_identity.
Proof. exact Theta_derive. Qed.

Theorem three_term_recurrence : Statement.three_term_recurrence.
Proof. exact Theta_recurrence. Qed.

Theorem taylor_series : Statement.taylor_series.
Proof.
intros b theta H. exists (coef b (theta 0) (Derive theta 0) (Derive_n theta 2 0)).
refine (conj eq_refl (conj eq_refl (conj _ (conj _ _)))).
- change (2 * (Derive_n theta 2 0 / 2) = Derive_n theta 2 0). field.
- intros k. replace (k + 3)%nat with (S (S (S k))) by lia. rewrite coef_rec.
  assert (Hk := pos_INR k). field. lra.
- intros t. rewrite (Theta_series b theta H t). apply PSeries_correct, CV_radius_inside.
  rewrite coef_radius. exact I.
Qed.

Theorem signs_at_zero : Statement.signs_at_zero.
Proof.
intros m n b theta Hb H. destruct (Theta_signs_0 m n b theta Hb H) as [A B]. rewrite sg_mod in A. exact (conj A B).
Qed.

Theorem enveloping_series : Statement.enveloping_series.
Proof. exact Theta_neg_series. Qed.

Theorem enveloping_series_low : Statement.enveloping_series_low.
Proof. intros b theta n N x Hb HT. exact (EnvelopingLow.enveloping_series_low b theta Hb HT n N x). Qed.

Theorem gamma_sign : Statement.gamma_sign.
Proof. exact Gamma_sign. Qed.

Theorem left_end : Statement.left_end.
Proof. exact Ends.left_end. Qed.

Theorem right_end : Statement.right_end.
Proof. intros b theta n Hb H. exact (scaled_right b theta Hb H n). Qed.

Theorem left_end_explicit : Statement.left_end_explicit.
Proof. exact EnvelopingLow.left_end_explicit. Qed.

Theorem tail_without_zero : Statement.tail_without_zero.
Proof. exact Ends.tail_without_zero. Qed.

Theorem tail_with_one_zero : Statement.tail_with_one_zero.
Proof. exact Ends.tail_with_one_zero. Qed.

Theorem list_with_multiplicity : Statement.list_with_multiplicity.
Proof. exact BudanTails.list_with_multiplicity. Qed.

Theorem budan_fourier : Statement.budan_fourier.
Proof. exact BudanFourier.budan_fourier. Qed.

Theorem tail_zeros : Statement.tail_zeros.
Proof. exact BudanTails.tail_zeros. Qed.

Theorem tail_few_zeros : Statement.tail_few_zeros.
Proof. exact BudanTails.tail_few_zeros. Qed.

Theorem recurrence_tail : StatementModels.recurrence_tail.
Proof. intros b t0 s B c I N Hs HB Hb Hc a q Hq. exact (RecurrenceTail.recurrence_tail b t0 s B c I Hs HB Hb Hc Hq N).
Qed.

Theorem derivative_tail : StatementModels.derivative_tail.
Proof. intros b X B c d K N HX HB Hb HK Hc v y q Hq.
exact (DerivativeTail.derivative_tail b X B c d HX HB Hb Hc K N HK Hq). Qed.

Theorem majorant : StatementModels.majorant.
Proof. exact Majorant.majorant. Qed.

(** ** Impact without collision at leading order *)

Theorem IWC : Statement.IWC.
Proof. exact LaplaceIntegral.IWC. Qed.

Theorem IWC_all_derivatives : Statement.IWC_all_derivatives.
Proof. exact IWC_all. Qed.

(** ** The number of zeros *)

Theorem count_law : Statement.count_law.
Proof.
intros m b theta Hb H.
destruct (CountLaw.count_law m b theta Hb H) as (l & El & Sl & Zl & Dl).
exists l. exact (conj (conj Sl Zl) (conj El Dl)).
Qed.

Theorem count_law_with_signs : Statement.count_law_with_signs.
Proof.
intros m b theta Hb H.
destruct (count_law_full m b theta Hb H) as (ln & lp & En & Ep & _ & Hn & Hp & Hs & Hz & Hd & Hf & _).
exists ln, lp. exact (conj (conj Hs Hz) (conj En (conj Hn (conj Ep (conj Hp (conj Hf Hd)))))).
Qed.

Theorem interlacing : Statement.interlacing.
Proof.
intros n b theta theta1 Hn. destruct n as [|m]; [lia|]. exact (CountLaw.interlacing m b theta theta1).
Qed.

(** The zeros of the named function [Th b] are those of any Theta. *)
Lemma zeros_of_Th b theta l : is_Theta b theta -> zeros_of (Derive theta) l -> zeros_of (Derive (Th b)) l.
Proof.
intros H [Sl Zl]. split; auto. intros t. rewrite <- Zl.
rewrite (Derive_ext (Th b) theta). reflexivity. intros s. symmetry. apply (Th_is b theta H).
Qed.

Theorem zeros_continuous : Statement.zeros_continuous.
Proof.
intros m b0 theta0 l0 eps Hb H0 Z0 He.
destruct (ZeroCurves.zeros_continuous m b0 l0 eps Hb (zeros_of_Th b0 theta0 l0 H0 Z0) He) as (delta & Hd & H).
exists delta. split; auto. intros b theta l Hbb HT Zl. apply (H b l Hbb), (zeros_of_Th b theta l HT Zl).
Qed.

Theorem differentiable_in_beta : Statement.differentiable_in_beta.
Proof.
intros b t Theta Hb HT.
assert (E : forall y u, not_nat y -> Theta y u = Th y u) by (intros y u Hy; apply Th_is, HT, Hy).
assert (EL : forall y u, not_nat y -> locally y (fun b => Theta b u = Th b u)).
{ intros y u Hy. eapply filter_imp; [|apply (not_nat_open y Hy)]. intros x Hx. apply E, Hx. }
split.
- apply (ex_derive_ext_loc (fun b => Th b t)); [|apply Th_ex_derive, Hb].
  eapply filter_imp; [|apply (EL b t Hb)]. intros x Hx. symmetry. exact Hx.
- apply (joint_ext_loc Th_slope (fun t b => Derive (fun b => Theta b t) b)); [|apply Th_slope_joint, Hb].
  eapply filter_imp; [|apply (not_nat_open b Hb)]. intros y Hy u. unfold Th_slope. symmetry.
  apply Derive_ext_loc, EL, Hy.
Qed.

Theorem zeros_differentiable : Statement.zeros_differentiable.
Proof.
intros m i Theta l Hi H z b Hb.
assert (Hl : forall b, INR m < b < INR m + 1 -> zero_list b (l b)).
{ intros y Hy. destruct (H y Hy) as [HT Zl]. exact (zeros_of_Th y (Theta y) (l y) HT Zl). }
assert (D := z_derive m i l Hi Hl b Hb). split; [|exact (z_slope_continuous m i l Hi Hl b Hb)].
assert (E2 : Derive_n (Theta b) 2 (z b) = Derive_n (Th b) 2 (z b)).
{ apply Derive_n_ext. intros s. apply (Th_is b (Theta b)), H, Hb. }
assert (E1 : Derive (fun b' => Derive (Theta b') (z b)) b = slope_in_b (z b) b).
{ rewrite (Derive_ext_loc _ (fun b' => Derive (Th b') (z b))).
  - apply is_derive_unique, slope_in_b_derive, (cell_is_not_nat m b Hb).
  - eapply filter_imp; [|apply (cell_open m b Hb)]. intros y Hy. apply Derive_ext. intros s.
    apply (Th_is y (Theta y)), H, Hy. }
rewrite E1, E2. exact D.
Qed.

(** ** Integer beta *)

Theorem entire_initial_values : Statement.entire_initial_values.
Proof. exact EntireForm.entire_initial_values. Qed.

Theorem integer_limit : Statement.integer_limit.
Proof.
intros n Theta HT t. rewrite Poly_Pn.
apply (is_lim_ext_loc (fun b => Th b t)); [|apply Th_lim_integer].
eapply filter_imp; [|apply (near_not_nat (INR n))]. intros b Hb. symmetry. apply (Th_is b (Theta b) (HT b Hb)).
Qed.

Theorem continuity_in_beta : Statement.continuity_in_beta.
Proof.
intros b Theta Hb HT t. rewrite (Th_is b (Theta b) (HT b Hb)).
apply (is_lim_ext_loc (fun b => Th b t)); [|apply Th_lim_not_nat, Hb].
eapply filter_imp; [|apply (near_not_nat b)]. intros y Hy. symmetry. apply (Th_is y (Theta y) (HT y Hy)).
Qed.

(** dP_(k+1)/dt = -(k + 1) P_k, with all derivatives. *)
Lemma Poly_derive_n k n t : Derive_n (Poly (S k)) (S n) t = - INR (S k) * Derive_n (Pn k) n t.
Proof.
rewrite <- (Derive_n_scal_l (Pn k) n (- INR (S k)) t).
rewrite (Derive_n_ext (Poly (S k)) (Pn (S k))) by apply Poly_Pn.
replace (S n) with (n + 1)%nat by lia. rewrite <- (Derive_n_comp (Pn (S k)) n 1).
apply Derive_n_ext. intros s. apply is_derive_unique, Pn_derive.
Qed.

Theorem count_law_integer : Statement.count_law_integer.
Proof.
intros n Hn. destruct n as [|k]; [lia|]. replace (S k - 1)%nat with k by lia.
destruct (Pn_zeros k) as (l & El & Sl & Hp & Hz & Hd & Hm).
assert (HS : - INR (S k) <> 0) by (apply Ropp_neq_0_compat, not_0_INR; lia).
assert (NZ : forall x, x <> 0 -> - INR (S k) * x <> 0).
{ intros x Hx. apply Rmult_integral_contrapositive_currified; auto. }
assert (E1 : forall t, Derive (Poly (S k)) t = - INR (S k) * Pn k t) by (intros t; exact (Poly_derive_n k 0 t)).
exists l. refine (conj El (conj Sl (conj Hp (conj _ (conj _ _))))).
- intros t. rewrite E1, <- Hz. split; [|intros ->; ring].
  intros E. apply Rmult_integral in E. destruct E as [E|E]; auto. contradiction.
- intros t Ht. rewrite (Poly_derive_n k 1 t). apply NZ, Hd, Ht.
- rewrite E1, (Poly_derive_n k 1 0), (Poly_derive_n k 2 0). change (Derive_n (Pn k) 1 0) with (Derive (Pn k) 0).
  destruct (k mod 3)%nat as [|[|j]].
  + apply NZ, Hm.
  + destruct Hm as [-> Hm]. split; [ring|apply NZ, Hm].
  + destruct Hm as (-> & -> & Hm). repeat split; try ring. apply NZ, Hm.
Qed.

Theorem zeros_at_integer : Statement.zeros_at_integer.
Proof.
intros k c eps T Sc Hc He.
destruct (at_integer_derive k c eps T Sc) as (delta & Hd & H); auto.
{ intros t. rewrite <- Hc. rewrite (Derive_ext (Poly (S k)) (Pn (S k))) by apply Poly_Pn. reflexivity. }
exists delta. split; auto. intros b theta l HT Zl.
destruct (H b l (zeros_of_Th b theta l HT Zl)) as [HL HR].
split; intros Hb.
- destruct (HL Hb) as (lo & xs & E & [E1 E2] & M). exists lo, xs. exact (conj E (conj E1 (conj E2 M))).
- destruct (HR Hb) as (lo & xs & z & E & [E1 E2] & Hz & M). exists lo, xs, z.
  exact (conj E (conj Hz (conj E1 (conj E2 M)))).
Qed.

Theorem left_end_integer : Statement.left_end_integer.
Proof. exact Ends.left_end_integer. Qed.

Theorem fold : Statement.fold.
Proof. exact FoldAndHinge.fold. Qed.

Theorem hinge : Statement.hinge.
Proof. exact FoldAndHinge.hinge. Qed.

(** ** Hadamard's finite part; t -> +oo *)

Theorem finite_part_integral : Statement.finite_part_integral.
Proof. exact FinitePart.finite_part_integral. Qed.

Theorem saddle_remainder : Statement.saddle_remainder.
Proof. exact SaddleRemainder.saddle_remainder. Qed.

Theorem positive_series : Statement.positive_series.
Proof. exact PositiveSeries.positive_series. Qed.

(** ** Power series in beta *)

Theorem recip_gamma_entire : Statement.recip_gamma_entire.
Proof. exact GammaEntire.recip_gamma_entire. Qed.

Theorem entire_in_beta : Statement.entire_in_beta.
Proof. exact ThetaEntire.entire_in_beta. Qed.

Theorem entire_in_both : Statement.entire_in_both.
Proof. exact ThetaEntire.entire_in_both. Qed.

Theorem analytic_in_beta : Statement.analytic_in_beta.
Proof. intros b t Theta Hb H. exact (AnalyticZeros.analytic_in_beta b t Theta Hb H). Qed.

Theorem zero_curve : Statement.zero_curve.
Proof. exact AnalyticZeros.zero_curve. Qed.

Theorem zeros_analytic : Statement.zeros_analytic.
Proof.
intros m i Theta l Hi H. apply (AnalyticZeros.zeros_analytic m i l Hi).
intros b Hb. destruct (H b Hb) as [HT Zl]. exact (zeros_of_Th b (Theta b) (l b) HT Zl).
Qed.

(** ** Taylor models on boxes *)

Theorem box_remainder : StatementModels.box_remainder.
Proof. exact BoxModel.box_remainder. Qed.

Theorem box_model : StatementModels.box_model.
Proof. exact BoxModel.box_model. Qed.

(** ** Models carried from one point to the next *)

Theorem solution_with_values : StatementModels.solution_with_values.
Proof. exact CarriedModel.solution_with_values. Qed.

Theorem rounded_step : StatementModels.rounded_step.
Proof. exact RoundedStep.rounded_step. Qed.

Theorem three_tails : StatementModels.three_tails.
Proof.
intros b t0 s B c n d N Hs HB Hb Hd Hn Hc q Hq. exact (CarriedModel.three_tails b t0 s B c n d N Hs HB Hb Hd Hn Hc Hq).
Qed.

Theorem moved_series : StatementModels.moved_series.
Proof.
intros b t0 s B f n d p e S w u delta H Hs HB Hb Hd Hn q Hq Hu.
exact (CarriedModel.moved_series b t0 s B f n d p e S w u delta H Hs HB Hb Hd Hn Hq Hu).
Qed.

Theorem carried_errors : StatementModels.carried_errors.
Proof. exact CarriedModel.carried_errors. Qed.

Theorem box_value : StatementModels.box_value.
Proof.
intros b t0 s B f n d m e u eta H Hs HB Hb Hd Hn q Hq Hu He.
exact (SignOnBox.box_value b t0 s B f n d m e u eta H Hs HB Hb Hd Hn Hq Hu He).
Qed.

(** ** The compliant model *)

Theorem motion_exists : StatementCompliant.motion_exists.
Proof.
intros force a1 a2 a3 eps t0 p0 b0 y0 v0 z0 Hf He. apply (CompliantMotion.motion_exists a1 a2 a3 eps He force).
destruct Hf as [-> | ->]; [apply contact_lipschitz|apply linear_lipschitz]; exact He.
Qed.

Theorem motion_unique : StatementCompliant.motion_unique.
Proof.
intros force a1 a2 a3 eps lo t0 hi p b y v z p' b' y' v' z' Hf He H0 H H' Ep Eb Ey Ev Ez t Ht.
assert (L : lipschitz_force (force eps)) by (destruct Hf as [-> | ->]; [apply contact_lipschitz|apply linear_lipschitz];
  exact He).
apply (CompliantMotion.motion_unique a1 a2 a3 eps He force L) with (t0 := t0); auto;
  intros s Hs; [apply H|apply H']; revert Hs; unfold segment, Rmin, Rmax; destruct Rle_dec; lra.
Qed.

Theorem slow_motion_exists : StatementCompliant.slow_motion_exists.
Proof. intros a1 a2 a3 eps C Hp. do 5 eexists. apply (slow_motion_sol a1 a2 a3 eps Hp C). Qed.

Theorem slow_motion_unique : StatementCompliant.slow_motion_unique.
Proof.
intros a1 a2 a3 eps C p b y v z p' b' y' v' z' Hp.
exact (CompliantSlowMotion.slow_motion_unique a1 a2 a3 eps Hp C p b y v z p' b' y' v' z').
Qed.

Theorem slow_motions_are_all : StatementCompliant.slow_motions_are_all.
Proof. intros a1 a2 a3 eps p b y v z Hp. exact (CompliantSlowMotion.slow_motions_are_all a1 a2 a3 eps Hp p b y v z).
Qed.

Theorem deviation_recover : StatementCompliant.deviation_recover.
Proof. exact CompliantDeviation.deviation_recover. Qed.

Theorem side_rule : StatementCompliant.side_rule.
Proof. intros a1 a2 a3 eps C p b y v z Hp. exact (CompliantSlowMotion.side_rule a1 a2 a3 eps Hp C p b y v z). Qed.

Theorem force_deviation : StatementCompliant.force_deviation.
Proof. intros a1 a2 a3 eps C p b y v z Hp HS.
exact (CompliantSlowMotion.force_deviation a1 a2 a3 eps Hp C p b y v z HS). Qed.

Theorem IWC_compliant : StatementCompliant.IWC_compliant.
Proof.
intros a1 a2 a3 eps C t0 P B Y V Z p b y v z Hp HC HS.
exact (CompliantSlowMotion.IWC_compliant a1 a2 a3 eps Hp C P B Y V Z HS t0 p b y v z HC).
Qed.

Theorem IWC_motion_exists : StatementCompliant.IWC_motion_exists.
Proof.
intros a1 a2 a3 eps C t0 P B Y V Z Hp HC HS.
exact (CompliantSlowMotion.IWC_motion a1 a2 a3 eps Hp C P B Y V Z HS t0 HC).
Qed.

Theorem lift_off_compliant : StatementCompliant.lift_off_compliant.
Proof.
intros a1 a2 a3 eps C t0 p b y v z Hp HC HS.
exact (CompliantSlowMotion.lift_off_compliant a1 a2 a3 eps Hp C p b y v z HS t0 HC).
Qed.

Theorem case_I : StatementCompliant.case_I.
Proof.
intros a1 a2 a3 eps C p b y v z Hp H1 H2 HC HS. exact (slow_case_I a1 a2 a3 eps Hp C p b y v z HS H1 H2 HC).
Qed.

Theorem case_II : StatementCompliant.case_II.
Proof.
intros a1 a2 a3 eps t1 p b y v z (H1 & H3 & He & Hb).
exact (CompliantForward.case_II a1 a2 a3 eps H1 H3 He Hb t1 p b y v z).
Qed.

Theorem leading_side_rule : StatementCompliant.leading_side_rule.
Proof. exact CompliantThreshold.leading_side_rule. Qed.

Theorem force_above_leading_order : StatementCompliant.force_above_leading_order.
Proof.
intros a1 a2 a3 eps C1 theta p b y v z t Hp H5 HT HS.
exact (CompliantThreshold.force_above_leading_order a1 a2 a3 eps C1 theta p b y v z Hp HT HS t H5).
Qed.

Theorem leading_force_positive : StatementCompliant.leading_force_positive.
Proof. exact CompliantThreshold.leading_force_positive. Qed.

Theorem IWC_below_threshold : StatementCompliant.IWC_below_threshold.
Proof.
intros a1 a2 a3 eps C1 theta m tau0 t0 P B Y V Z p b y v z Hp Hb H2 HC HT Hm Hl Hs HS Ht.
exact (CompliantThreshold.IWC_below_threshold a1 a2 a3 eps C1 theta P B Y V Z Hp HT HS m tau0 t0 Hb H2 HC Hm Hl Hs Ht p
  b y v z).
Qed.

Theorem least_value_exists : StatementCompliant.least_value_exists.
Proof. exact CompliantThreshold.least_value_exists. Qed.

Theorem IWC_open : StatementCompliant.IWC_open.
Proof.
intros a1 a2 a3 eps t0 p b y v z H1 H13 He Ht0 Hp Hm Hc D0 D1 D2 D3.
assert (HP : Pos a1 a2 a3 eps b y v z t0).
{ assert (Ep := Hp t0 (Rle_refl t0)). rewrite Ep in D2, D3. exact (conj Hc (conj D0 (conj D1 (conj D2 D3)))). }
split.
- intros t Ht. apply (CompliantOpen.IWC_open a1 a2 a3 eps H1 H13 He p b y v z t0 Ht0 Hp Hm HP t Ht).
- exact (IWC_open_force a1 a2 a3 eps H1 H13 He p b y v z t0 Ht0 Hp Hm HP).
Qed.

Theorem open_set_holds_slow_motions : StatementCompliant.open_set_holds_slow_motions.
Proof. intros a1 a2 a3 eps C t p b y v z Hp H13 HC HS. exact (slow_in_open_set a1 a2 a3 eps Hp C p b y v z HS t H13 HC).
Qed.

Theorem IWC_late : StatementCompliant.IWC_late.
Proof. exact late_IWC. Qed.

Theorem late_cone_holds_slow_motions : StatementCompliant.late_cone_holds_slow_motions.
Proof. intros a1 a2 a3 eps C p b y v z Hp HC HS. exact (slow_comes_into_cone a1 a2 a3 eps C p b y v z Hp HC HS). Qed.

Theorem IWC_stable : StatementCompliant.IWC_stable.
Proof. intros a1 a2 a3 eps C t0 P B Y V Z Hp HC HS Hc. exact (stable_slow a1 a2 a3 eps C t0 P B Y V Z Hp HC HS Hc). Qed.

Theorem side_rule_every_state : StatementCompliant.side_rule_every_state.
Proof. intros a1 a2 a3 eps t0 p b y v z Hp H. exact (every_state_rule a1 a2 a3 eps Hp t0 p b y v z H). Qed.

Theorem side_number_slow : StatementCompliant.side_number_slow.
Proof. intros a1 a2 a3 eps C p b y v z Hp. exact (slow_number a1 a2 a3 eps Hp C p b y v z). Qed.

Theorem side_number_linear : StatementCompliant.side_number_linear.
Proof.
intros a1 a2 a3 eps t0 k k' K K' p b y v z p' b' y' v' z' p'' b'' y'' v'' z'' Hp.
exact (number_linear a1 a2 a3 eps Hp t0 k k' K K' p b y v z p' b' y' v' z' p'' b'' y'' v'' z'').
Qed.

Theorem lasting_contact : StatementCompliant.lasting_contact.
Proof. intros a1 a2 a3 eps t0 K p b y v z Hp. exact (lasting a1 a2 a3 eps Hp t0 K p b y v z). Qed.

Theorem IWC_stable_every_state : StatementCompliant.IWC_stable_every_state.
Proof. intros a1 a2 a3 eps K t0 P B Y V Z Hp. exact (stable_every a1 a2 a3 eps Hp K t0 P B Y V Z). Qed.

Theorem contact_tail : StatementCompliant.contact_tail.
Proof. intros a1 a2 a3 eps C n t0 p b y v z Hp HS.
exact (CompliantSlowMotion.contact_tail a1 a2 a3 eps Hp C p b y v z HS n t0). Qed.

Theorem force_zeros : StatementCompliant.force_zeros.
Proof. intros a1 a2 a3 eps C n l p b y v z Hp HS. exact (slow_force_zeros a1 a2 a3 eps Hp C p b y v z HS n l). Qed.

Theorem printed_trivial_is_wrong : StatementCompliant.printed_trivial_is_wrong.
Proof. exact printed_trivial_wrong. Qed.

Theorem corrected_trivial : StatementCompliant.corrected_trivial.
Proof.
intros a1 a2 a3 eps t He H13.
assert (E : linear_force eps (2 * (eps ^ 2 * a2 / (a1 - a3))) (eps ^ 2 * a2 / (a1 - a3)) = - a2 / (a1 - a3)).
{ unfold linear_force. field. split; lra. }
unfold model_at. rewrite E.
refine (conj _ (conj _ (conj _ (conj _ _)))).
- auto_derive; auto; ring.
- auto_derive; auto. field. lra.
- apply (is_derive_const (2 * (eps ^ 2 * a2 / (a1 - a3)))).
- replace (a2 / (a1 - a3) * a1 * t + a1 * t * (- a2 / (a1 - a3))) with 0 by (field; lra). apply (is_derive_const 0).
- replace (- (eps ^ 2 * a2 / (a1 - a3)) - eps ^ 2 * (- a2 / (a1 - a3))) with 0 by (field; lra).
  apply (is_derive_const (eps * (eps ^ 2 * a2 / (a1 - a3)))).
Qed.

(** ** The deviation in the time T *)

Theorem slow_exists : StatementCompliant.slow_exists.
Proof. intros e b He Hb. exists (Fe e b). exact (conj (Fe_ode e He b Hb) (Fe_asymptotics e He b Hb)). Qed.

(** Any slow solution is the named one. *)
Lemma is_slow_Fe e b F : 0 < e -> not_nat b -> is_slow e b F -> forall t, F t = Fe e b t.
Proof. intros He Hb [H L]. exact (slow_characterized e b He Hb F H L). Qed.

Theorem slow_unique : StatementCompliant.slow_unique.
Proof. intros e b F G He Hb HF HG t. rewrite (is_slow_Fe e b F), (is_slow_Fe e b G); auto. Qed.

Theorem slow_integral : StatementCompliant.slow_integral.
Proof.
intros e b n F He Hb Hn HF t. rewrite (Derive_n_ext F (Fe e b)) by (apply is_slow_Fe; auto).
exact (Fe_representation e He b n Hb Hn t).
Qed.

Theorem IWC_every_eps : StatementCompliant.IWC_every_eps.
Proof.
intros e b F He Hb HF n t Hn. rewrite (Derive_n_ext F (Fe e b)) by (apply is_slow_Fe; auto using not_nat_01).
exact (IWC_eps e He b Hb n t Hn).
Qed.

Theorem slow_zeros : StatementCompliant.slow_zeros.
Proof.
intros e b n F l He Hb Hn HF HS H0. apply (Fe_zeros e b n l He Hb Hn HS).
intros t Ht. rewrite <- (is_slow_Fe e b F); auto.
Qed.

Theorem slow_tail_zeros : StatementCompliant.slow_tail_zeros.
Proof.
intros e n b F T He Hb HF. apply (BudanTails.slow_tail_zeros e); auto.
apply is_slow_Fe; auto. exact (interval_not_nat n b Hb).
Qed.

Theorem leading_order_limit : StatementCompliant.leading_order_limit.
Proof.
intros b n eta theta F t w Hb Hn He HT HF Hw.
assert (He2 : 0 < 2 * eta ^ 3) by (generalize (pow_lt eta 3 He); lra).
rewrite (Derive_n_ext F (Fe (2 * eta ^ 3) b)) by (apply is_slow_Fe; auto).
assert (E : W (INR n - b + 3) t = w).
{ apply (is_RInt_gen_unique (V := R_CompleteNormedModule) _ w). exact Hw. }
rewrite <- E. exact (Fe_limit b n eta t theta Hb Hn HT He).
Qed.

Theorem monotone_in_eta : StatementCompliant.monotone_in_eta.
Proof.
intros b n eta eta' F F' t Hb Hn He HF HF'.
assert (H := CompliantMonotone.monotone_in_eta b n eta eta' t Hb Hn He).
rewrite <- !scaled_slow in H by (auto; lra).
rewrite (Derive_n_ext F (Fe (2 * eta ^ 3) b)) by (apply is_slow_Fe; auto; apply two_cube; lra).
rewrite (Derive_n_ext F' (Fe (2 * eta' ^ 3) b)) by (apply is_slow_Fe; auto; apply two_cube; lra). exact H.
Qed.

Theorem above_leading_order : StatementCompliant.above_leading_order.
Proof.
intros b n eta theta F t Hb Hn He HT HF G.
assert (H := CompliantMonotone.above_leading_order b n eta theta t Hb Hn He HT).
assert (E : forall k, Gamma (- b) * G k = scaled_J eta (- b - 1) k t).
{ intros k. unfold G. rewrite (Derive_n_ext F (Fe (2 * eta ^ 3) b)) by (apply is_slow_Fe; auto; apply two_cube; lra).
  apply scaled_slow; auto. }
rewrite Rmult_minus_distr_l, !E. unfold scaled in H. lra.
Qed.

Theorem weight_series : StatementCompliant.weight_series.
Proof.
intros N eta r HN He Hr x weight order. assert (H := series_remainder eta N r HN He Hr).
change (Rabs (weight - sum_first order N) <= remainder_bound eta N (fun i => r ^ i * weight)) in H.
eapply Rle_trans; [exact H|]. right. unfold remainder_bound.
rewrite Rmult_assoc, (Rmult_comm (sum_first _ _)), <- (sum_first_scal weight). f_equal.
apply sum_first_ext. intros m. ring.
Qed.

(** Gamma(-b) eta^(b-n) F^(n)(t/eta) for any slow solution F. *)
Lemma scaled_is_slow b n eta F t : 0 < eta -> not_nat b -> is_slow (2 * eta ^ 3) b F ->
  Gamma (- b) * (Rpower eta (b - INR n) * Derive_n F n (t / eta)) = scaled_J eta (- b - 1) n t.
Proof.
intros He Hb HF. rewrite (Derive_n_ext F (Fe (2 * eta ^ 3) b)) by (apply is_slow_Fe; auto; apply two_cube; lra).
apply scaled_slow; auto.
Qed.

Theorem series_in_eta : StatementCompliant.series_in_eta.
Proof.
intros b n N eta theta F t Hb HN Hn He HT HF G order.
assert (H := series_with_remainder b theta eta Hb HT He N HN n t Hn).
assert (E : forall k, Gamma (- b) * G k = scaled_J eta (- b - 1) k t) by (intros k; apply scaled_is_slow; auto).
rewrite Rmult_minus_distr_l, E, <- sum_first_scal.
replace (sum_first (fun k => Gamma (- b) * order k) N) with (eta_series eta N (fun i => scaled b theta (n + i) t)).
2: { apply sum_first_ext. intros k. unfold order.
     rewrite <- Rmult_assoc, (Rmult_comm (Gamma _)), Rmult_assoc, <- (sum_first_scal (Gamma _)). f_equal.
     apply sum_first_ext. intros m. unfold scaled. rewrite <- (Nat.add_assoc n). ring. }
eapply Rle_trans; [exact H|]. right. unfold series_bound, remainder_bound. f_equal.
apply sum_first_ext. intros m. rewrite E, <- Nat.add_assoc. reflexivity.
Qed.

Theorem monotone_beyond_polynomial : StatementCompliant.monotone_beyond_polynomial.
Proof.
intros b n M K eta eta' theta F F' t Hb He H4 HK HT HF HF' part ex.
assert (E : forall e G, 0 < e -> is_slow (2 * e ^ 3) b G -> ex e G = polynomial_excess M K b theta e n t).
{ intros e G He0 HG. unfold ex, polynomial_excess, polynomial_series.
  rewrite <- (scaled_is_slow b n e G t He0 Hb HG), sum_first_head.
  rewrite (sum_first_head _ (K 0%nat)), (sum_first_zero (fun k => series_coefficient (S k) 0 * _ * _)).
  2: { intros k. rewrite coefficient_0. ring. }
  rewrite (sum_first_ext (fun i => sum_first (fun k => series_coefficient k (S i) * e ^ k * scaled b theta
    (n + (k + 3 * S i)) t) (S (K (S i))))
    (fun i => Gamma (- b) * part e (S i)) M), sum_first_scal.
  2: { intros i. unfold part. rewrite <- sum_first_scal. apply sum_first_ext. intros k.
       unfold scaled. replace (n + k + 3 * S i)%nat with (n + (k + 3 * S i))%nat by lia. ring. }
  change (series_coefficient 0 0) with 1. replace (n + (0 + 3 * 0))%nat with n by lia. unfold scaled. simpl pow. ring. }
rewrite (E eta F), (E eta' F') by (auto; lra).
assert (H4' : b < INR n + 4 * INR (S M)) by (rewrite S_INR; lra).
split; [apply polynomial_excess_positive|apply polynomial_excess_increases]; auto; try lra; intros m Hm; apply HK, Hm.
Qed.

Theorem monotone_next_order : StatementCompliant.monotone_next_order.
Proof.
intros b n eta eta' theta F F' t Hb Hn He HT HF HF' ex.
assert (H := monotone_beyond_polynomial b n 1%nat (fun _ => 2%nat) eta eta' theta F F' t Hb He ltac:(simpl; lra)
  ltac:(intros m Hm; replace m with 1%nat by lia; split; [exists 0%nat; reflexivity|simpl; lra]) HT HF HF').
  cbv zeta in H.
assert (E : forall e G, Gamma (- b) * (Rpower e (b - INR n) * Derive_n G n (t / e) - Derive_n theta n t
  - sum_first (fun i => sum_first (fun k => series_coefficient k (S i) * e ^ k * Derive_n theta (n + k + 3 * S i) t) 3)
      1) = ex e G).
{ intros e G. unfold ex. cbn [sum_first Nat.mul Nat.add]. replace (n + 1 + 3)%nat with (n + 4)%nat by lia.
  replace (n + 2 + 3)%nat with (n + 5)%nat by lia.
  unfold series_coefficient. simpl (INR _). simpl pow. field. }
rewrite <- (E eta F), <- (E eta' F'). exact H.
Qed.

Theorem force_above_corrected_force : StatementCompliant.force_above_corrected_force.
Proof.
intros a1 a2 a3 eps C1 M K theta p b y v z n t Hp HE HT HS force corrected.
exact (CompliantCorrection.force_above_corrected_force a1 a2 a3 eps C1 theta p b y v z M K Hp HT HS n t HE).
Qed.

Theorem IWC_by_corrected_force : StatementCompliant.IWC_by_corrected_force.
Proof.
intros a1 a2 a3 eps C1 M K theta n t0 t1 P B Y V Z p b y v z Hp Hn HE HC HT HS.
exact (CompliantCorrection.IWC_by_corrected_force a1 a2 a3 eps C1 theta P B Y V Z M K Hp HT HS n t0 t1 p b y v z Hn HE
  HC).
Qed.

(** ** Theorem D *)

Lemma simple_zeros_ext (f g : R -> R) l : (forall t, f t = g t) -> simple_zeros g l -> simple_zeros f l.
Proof.
intros E ((S & Z) & N). split; [split|]; auto.
- intros t. rewrite E. apply Z.
- intros t Ht. rewrite (Derive_ext f g t E). apply N, Ht.
Qed.

Theorem slow_below_power : StatementCompliant.slow_below_power.
Proof.
intros e b F x He Hb H3 HF Hx. rewrite (is_slow_Fe e b F) by auto.
assert (H := CompliantPower.slow_below_power e He b x Hb H3 Hx). lra.
Qed.

Theorem slow_law : StatementCompliant.slow_law.
Proof.
intros e b F He HF.
assert (Z : forall (m : nat) l, INR m < b < INR m + 1 -> line_pattern (Fe e b) (slope e b) 1 l -> simple_zeros F l).
{ intros m l Hm P. destruct (Gamma_cell m b Hm) as [Hb _].
  apply (simple_zeros_ext F (Fe e b)); [apply is_slow_Fe; auto|].
  apply (pattern_simple _ (slope e b) 1); auto. intros t. apply slow_derive; auto. }
refine (conj _ (conj _ _)); intros H.
- destruct (zeros_0 e He b H) as (t & Ht & P). exists t. split; [exact Ht|]. apply (Z 0%nat); [simpl; lra|exact P].
- destruct (zeros_1 e He b H) as (s & t & Ht & P). exists s, t. split; [exact Ht|].
  apply (Z 1%nat); [simpl; lra|exact P].
- destruct (zeros_2 e He b H) as (t & Ht & P). exists t. split; [exact Ht|]. apply (Z 2%nat); [simpl; lra|exact P].
Qed.

Theorem force_law : StatementCompliant.force_law.
Proof. intros a1 a2 a3 eps C p b y v z Hp HS HC. exact (CompliantLaw.force_law a1 a2 a3 eps C p b y v z Hp HS HC). Qed.

Lemma zeros_of_ext (f g : R -> R) l : (forall t, f t = g t) -> zeros_of g l -> zeros_of f l.
Proof. intros E (S & Z). split; auto. intros t. rewrite E. apply Z. Qed.

Theorem slow_valley : StatementCompliant.slow_valley.
Proof.
intros e b F He H34 HF. assert (Hb := proj1 (Gamma_cell 3 b ltac:(simpl; lra))).
assert (E := is_slow_Fe e b F He Hb HF).
destruct (CompliantCritical.slow_valley b H34 e He) as (m & Hm & L & U & Left & Right & Neg & Touch & Pos).
exists m. rewrite E. refine (conj Hm (conj _ (conj _ (conj _ (conj _ (conj _ (conj _ _))))))).
- intros s t Hst Ht. rewrite !E. auto.
- intros s t Hs Hst. rewrite !E. auto.
- apply (is_lim_ext (Fe e b)); auto.
- apply (is_lim_ext (Fe e b)); auto.
- intros N. destruct (Neg N) as (s & t & Hst & Z). exists s, t. split; auto. exact (simple_zeros_ext F _ _ E Z).
- intros Em. destruct (Touch Em) as [Z D]. split; [exact (zeros_of_ext F _ _ E Z)|].
  rewrite (Derive_n_ext F (Fe e b)) by exact E. exact D.
- intros P t. rewrite E. auto.
Qed.

Theorem critical_eps : StatementCompliant.critical_eps.
Proof.
intros b H34. assert (Hb := proj1 (Gamma_cell 3 b ltac:(simpl; lra))).
destruct (CompliantCritical.critical_eps b H34) as (ec & Hec & H).
exists ec. split; auto. intros e F He HF. assert (E := is_slow_Fe e b F He Hb HF).
destruct (H e He) as (Two & One & None).
refine (conj _ (conj _ _)).
- intros Hlt. destruct (Two Hlt) as (s & t & Hst & Z). exists s, t. split; auto. exact (simple_zeros_ext F _ _ E Z).
- intros Eq. destruct (One Eq) as (t & Z & D1 & D2). exists t. split; [exact (zeros_of_ext F _ _ E Z)|].
  rewrite (Derive_ext F (Fe e b)), (Derive_n_ext F (Fe e b)) by exact E. auto.
- intros Hlt t. rewrite E. auto.
Qed.

Theorem force_critical_eps : StatementCompliant.force_critical_eps.
Proof. exact CompliantCritical.force_critical_eps. Qed.

Theorem slow_upper_bound : StatementCompliant.slow_upper_bound.
Proof.
intros b eta eta0 mu theta F t Hb H4 He Hmu Hmu3 HT HF.
assert (H := CompliantUpper.slow_upper_bound eta0 mu Hmu Hmu3 b theta Hb HT eta 0 t He ltac:(simpl; lra)).
rewrite <- (scaled_slow b 0 eta t) in H by (auto; lra). unfold stretched, scaled, slope_weight in H.
replace (- (- b - 1 + INR 0 + 2)) with (b - 1) in H by (simpl; ring). replace (b - INR 0) with b in H by (simpl; ring).
cbn [Derive_n] in H.
change (Derive (fun x => theta x)) with (Derive theta) in H.
rewrite (is_slow_Fe (2 * eta ^ 3) b F) by (auto; apply two_cube; lra). lra.
Qed.

(** ** Flights *)

Theorem z_stays_nonpositive : StatementFlight.z_stays_nonpositive.
Proof.
intros a1 a2 a3 eps t0 p b y v z He Hm Hz t Ht.
exact (CompliantFlight.z_stays_nonpositive a1 a2 a3 eps p b y v z t0 t He Hm Hz Ht).
Qed.

Theorem flight_ends : StatementFlight.flight_ends.
Proof.
intros a1 a2 a3 eps t0 p b y v z He Hm (E0 & Hup) Hz H2.
destruct (CompliantFlight.flight_ends a1 a2 a3 eps He p b y v z t0 Hm E0 Hup Hz H2)
  as (t1 & d & H01 & Hd & Hfly & E1 & Hdown & Hafter & F).
exists t1. refine (conj H01 (conj Hfly (conj _ (conj E1 (conj Hdown (ex_intro _ d (conj Hd Hafter))))))).
intros t Ht. destruct (F t Ht) as (Fb & Fy & Fv & Fz). exact (conj Fb (conj Fv (conj Fy Fz))).
Qed.

Theorem flight_never_ends : StatementFlight.flight_never_ends.
Proof.
intros a1 a2 a3 eps t0 p b y v z He Hm (E0 & Hup) Hz H2 Hb t Ht.
destruct (CompliantFlight.flight_never_ends a1 a2 a3 eps He p b y v z t0 Hm E0 Hup Hz H2 Hb t Ht)
  as (N & Fb & Fy & Fv & Fz).
exact (conj N (conj Fb (conj Fv (conj Fy Fz)))).
Qed.

Theorem flight_persists : StatementFlight.flight_persists.
Proof.
intros a1 a2 a3 eps t0 p b y v z He Hm (E0 & Hup) Hz H2 Hb.
exact (CompliantFlight.flight_persists a1 a2 a3 eps He p b y v z t0 Hm E0 Hup Hz H2 Hb).
Qed.

Theorem slow_flight : StatementFlight.slow_flight.
Proof.
intros a1 a2 a3 eps C t0 P B Y V Z p b y v z Hp Hbeta HC H2 HS Hyz Hm Ep Eb Ey Ev Ez.
destruct (CompliantSlowFlight.slow_flight a1 a2 a3 eps C Hp P B Y V Z HS t0 p b y v z Hbeta HC H2 Hyz Hm Ep Eb Ey Ev Ez)
  as (t1 & t2 & d & H12 & Hd & Hc & E1 & Hup & Hz & Hfly & E2 & Hdown & Hafter).
exists t1, t2. exact
  (conj H12 (conj Hc
    (conj (conj E1 Hup) (conj Hz (conj Hfly (conj E2 (conj Hdown (ex_intro _ d (conj Hd Hafter))))))))).
Qed.

(** ** Contacts that last for ever *)

Theorem growth_below_one : StatementFlight.growth_below_one.
Proof.
intros a1 a2 a3 eps t0 p b y v z H1 H13 H2 He Hm Hp Hyz Hv HG HD.
apply (CompliantGrowth.contact_lasts a1 a2 a3 eps t0 p b y v z He Hm). intros P B Y V Z Hlin HP HB HY HV HZ.
apply (CompliantGrowth.below_one a1 a2 a3 eps He P B Y V Z Hlin H1 t0 H13 H2).
- unfold CompliantGrowth.q. lra.
- unfold CompliantGrowth.L, linear_force. rewrite HY, HZ. apply Rmult_le_pos. lra.
  apply Rlt_le, Rinv_0_lt_compat, pow_lt, He.
- unfold CompliantGrowth.W. rewrite HV. apply Rmult_le_pos. lra. apply Rlt_le, Rinv_0_lt_compat, He.
- unfold CompliantGrowth.G. rewrite HP, HB, HY, HZ. exact HG.
- unfold CompliantGrowth.D. rewrite HY, HV, HZ. exact HD.
Qed.

Theorem growth_above_one : StatementFlight.growth_above_one.
Proof.
intros a1 a2 a3 eps a t0 p b y v z H1 H31 H2 He Ha Hm lambda G D Hq HL Hv HG HaL HS HD.
assert (HK : 0 <= CompliantGrowth.kappa a1 a3 eps) by (unfold CompliantGrowth.kappa; apply Rmult_le_pos; lra).
apply (CompliantGrowth.contact_lasts a1 a2 a3 eps t0 p b y v z He Hm). intros P B Y V Z Hlin HP HB HY HV HZ.
apply (CompliantGrowthSet.growth_set a1 a2 a3 eps He P B Y V Z Hlin H1 H2 HK a Ha t0).
- unfold CompliantGrowth.q, CompliantGrowthSet.enough, CompliantGrowth.kappa. rewrite HP. exact Hq.
- assert (HW : 0 <= - v t0 / eps) by (apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat, He]).
  unfold CompliantGrowth.S, CompliantGrowth.L, CompliantGrowth.W, CompliantGrowth.G, CompliantGrowth.D.
  rewrite HP, HB, HY, HV, HZ. fold lambda G D. repeat split; assumption.
Qed.

Theorem late_touch_down_below_one : StatementFlight.late_touch_down_below_one.
Proof.
intros a1 a2 a3 eps t0 t1 p b y v z H1 H13 H2 He Hm Hlift Hz Hf Hu Hp.
apply (CompliantGrowth.contact_lasts a1 a2 a3 eps t1 p b y v z He). { intros t Ht. apply Hm. destruct Hf. lra. }
intros P B Y V Z Hlin HP HB HY HV HZ.
apply (late_below_one a1 a2 a3 eps t0 t1 p b y v z H1 H2 He Hm Hlift Hz Hf P B Y V Z Hlin HP HB HY HV HZ H13); auto.
apply Rmult_le_reg_r with eps; auto. replace ((t1 - t0) / eps * eps) with (t1 - t0) by (field; lra). exact Hu.
Qed.

Theorem late_touch_down : StatementFlight.late_touch_down.
Proof.
intros a1 a2 a3 eps t0 t1 p b y v z H1 H31 H2 He Hm Hlift Hz Hf u kappa Hu Hp Hq.
apply (CompliantGrowth.contact_lasts a1 a2 a3 eps t1 p b y v z He). { intros t Ht. apply Hm. destruct Hf. lra. }
intros P B Y V Z Hlin HP HB HY HV HZ.
exact (late_above_one a1 a2 a3 eps t0 t1 p b y v z H1 H2 He Hm Hlift Hz Hf P B Y V Z Hlin HP HB HY HV HZ H31 Hu Hp Hq).
Qed.

Theorem one_flight_from_state : StatementFlight.one_flight_from_state.
Proof. exact (CompliantOneFlight.one_flight_of flight_ends late_touch_down). Qed.

(** ** Validated steps *)

Theorem validated_step : StatementStep.validated_step.
Proof. exact ValidatedStep.step_solution. Qed.

Theorem validated_set : StatementStep.validated_set.
Proof. exact ValidatedStep.set_of_solutions. Qed.

Theorem no_event : StatementStep.no_event.
Proof. exact Events.no_event. Qed.

Theorem one_event : StatementStep.one_event.
Proof. exact Events.one_event. Qed.

Theorem first_event : StatementStep.first_event.
Proof. exact Events.first_event. Qed.

(** ** Slip reaches a G-spot *)

Theorem capture : StatementApproach.capture.
Proof. exact Capture.captured. Qed.

Theorem sign_of_C1 : StatementApproach.sign_of_C1.
Proof. exact SignOfC1.sign_of_the_limit. Qed.

Theorem negative_C1 : StatementApproach.negative_C1.
Proof. exact NegativeC1.negative_limit. Qed.

(** ** From a state to a G-spot, for all eps at once *)

Theorem good_coordinates : StatementPassage.good_coordinates.
Proof. exact PassageEquations.good_coordinates. Qed.

Theorem coordinates_determine : StatementPassage.coordinates_determine.
Proof. exact PassageEquations.coordinates_determine. Qed.

Theorem deviation_moves : StatementPassage.deviation_moves.
Proof. exact PassageEquations.deviation_moves. Qed.

Theorem shares : StatementPassage.shares.
Proof. exact PassageNorm.shares. Qed.

Theorem deviation_grows : StatementPassage.deviation_grows.
Proof. exact PassageNorm.deviation_grows. Qed.

Theorem ratio_grows : StatementPassage.ratio_grows.
Proof. exact PassageNorm.ratio_grows. Qed.

Theorem drift_of_C1 : StatementPassage.drift_of_C1.
Proof. exact PassageNorm.drift_of_C1. Qed.

Theorem passage : StatementPassage.passage.
Proof. exact PassageForce.passage. Qed.

Theorem passage_drift : StatementPassage.passage_drift.
Proof. exact PassageDrift.passage_drift. Qed.

Theorem start_ratio : StatementPassage.start_ratio.
Proof. exact PassageNorm.start_ratio. Qed.

(** ** Certificates *)

Theorem sign_certificate : StatementCertificate.sign_certificate.
Proof. exact CertificatePieces.sign_certificate. Qed.

Theorem zeros_certificate : StatementCertificate.zeros_certificate.
Proof. exact CertificatePieces.zeros_certificate. Qed.

Theorem brackets_certificate : StatementCertificate.brackets_certificate.
Proof. exact CertificatePieces.brackets_certificate. Qed.

Theorem force_certificate : StatementCertificate.force_certificate.
Proof. exact CertificateForce.force_certificate. Qed.

Theorem lift_off_certificate : StatementCertificate.lift_off_certificate.
Proof. exact CertificateForce.lift_off_certificate. Qed.

(** ** The checker in Coq *)

Theorem certificate_checker : StatementChecker.certificate_checker.
Proof. exact accepted_is_true. Qed.

Theorem count_checker : StatementChecker.count_checker.
Proof. exact counted_is_true. Qed.

Theorem iwc_0_1_checked : StatementChecker.iwc_0_1_checked.
Proof. exact CheckerRuns.iwc_0_1_checked. Qed.

Theorem zeros_1_2_checked : StatementChecker.zeros_1_2_checked.
Proof. exact CheckerRuns.zeros_1_2_checked. Qed.

Theorem force_checker : StatementForce.force_checker.
Proof. exact force_accepted_is_true. Qed.

Theorem force_5_2_checked : StatementForce.force_5_2_checked.
Proof. exact ForceRuns.force_5_2_checked. Qed.

Theorem lift_off_5_2_checked : StatementForce.lift_off_5_2_checked.
Proof. exact ForceRuns.lift_off_5_2_checked. Qed.

Theorem zeros_4_5_checked : StatementForce.zeros_4_5_checked.
Proof. exact ForceRuns.zeros_4_5_checked. Qed.

Theorem run_checker : StatementRun.run_checker.
Proof. exact RunRuns.accepted_run_is_true. Qed.

Theorem run_fig_varsim1_checked : StatementRun.run_fig_varsim1_checked.
Proof. exact RunRuns.run_fig_varsim1_checked. Qed.

Theorem slow_zeros_certificate : StatementCertificate.slow_zeros_certificate.
Proof. exact CertificateSlow.slow_zeros_certificate. Qed.
