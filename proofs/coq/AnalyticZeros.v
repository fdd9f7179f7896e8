(** * The zeros of dTheta/dtau are analytic in b

    dTheta/dtau is the sum of an entire family, so through each of its simple zeros passes one analytic curve of zeros
    ([zero_curve]), at integers too (in the entire form). Inside a cell the i-th zero is simple and continuous in b;
    near b0 it is on that curve ([zeros_analytic]). *)

From Coq Require Import Reals Psatz Lra Lia ZArith List Sorted.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement Calculus WellPosed Family CountLaw ContinuityInBeta ZeroCurves DifferentiableInBeta
  ZeroSlopes EntireForm PowerSeriesNorm NormLimit
  GammaEntire ThetaEntire AnalyticImplicit.
Import ListNotations.
Open Scope R_scope.

Lemma norm_analytic r M f x0 : 0 < r -> norm_at_most r M (fun h => f (x0 + h)) -> analytic_at f x0.
Proof.
intros Hr (a & _ & Ha). exists a, r. split; auto. intros x Hx. assert (E := Ha (x - x0) Hx).
replace (x0 + (x - x0)) with x in E by ring. exact E.
Qed.

Lemma analytic_ext_loc f g x0 : locally x0 (fun x => f x = g x) -> analytic_at f x0 -> analytic_at g x0.
Proof.
intros [d Hd] (a & r & Hr & Ha). assert (P := cond_pos d). exists a, (Rmin r d). split. apply Rmin_pos; auto.
intros x Hx. assert (A1 := Rmin_l r d). assert (A2 := Rmin_r r d). rewrite <- Hd by (change (Rabs (x - x0) < d); lra).
apply Ha. lra.
Qed.

Theorem analytic_in_beta b t (Theta : R -> R -> R) : not_nat b -> (forall b, not_nat b -> is_Theta b (Theta b)) ->
  analytic_at (fun b => Theta b t) b.
Proof.
intros Hb H. apply (analytic_ext_loc (family_sum theta_coefficient t)).
- eapply filter_imp; [|apply (not_nat_open b Hb)]. intros y Hy. symmetry.
  apply entire_series, entire_initial_values; auto.
- destruct (sum_in_beta_entire t b 1 Rlt_0_1) as [M HM]. apply (norm_analytic 1 M); auto. exact Rlt_0_1.
Qed.

Theorem zero_curve (Theta : R -> R -> R) t0 b0 : (forall b, is_Theta_entire b (Theta b)) -> Derive (Theta b0) t0 = 0 ->
  Derive_n (Theta b0) 2 t0 <> 0 ->
  exists z eps, 0 < eps /\ analytic_at z b0 /\ z b0 = t0 /\
    forall b t, Rabs (b - b0) < eps -> Rabs (t - t0) < eps -> (Derive (Theta b) t = 0 <-> t = z b).
Proof.
intros HT Z S. rewrite (Derive_family b0 _ (HT b0)) in Z. rewrite (Derive2_family b0 _ (HT b0)) in S.
destruct (implicit_analytic (derived theta_coefficient) t0 b0 (derived_entire _ theta_family_entire) Z S)
  as (z & rho & r & M & Hrho & Hr & Nz & z0 & Hz).
exists (fun b => t0 + z (b - b0)), (Rmin rho r). refine (conj _ (conj _ (conj _ _))).
- apply Rmin_pos; auto.
- apply (norm_analytic r (Rabs t0 + M)); auto. apply (norm_ext r _ (fun h => t0 + z h)).
  + intros h _. do 2 f_equal. ring.
  + apply norm_plus; auto. apply norm_const.
- replace (b0 - b0) with 0 by ring. rewrite z0. ring.
- intros b t Hb Ht. assert (A1 := Rmin_l rho r). assert (A2 := Rmin_r rho r).
  rewrite (Derive_family b _ (HT b)). assert (E := Hz (b - b0) (t - t0) ltac:(lra) ltac:(lra)).
  replace (t0 + (t - t0)) with t in E by ring. replace (b0 + (b - b0)) with b in E by ring. rewrite E.
  split; intros; lra.
Qed.

(** The entire form as one function of b. *)
Definition entire_Theta (b t : R) : R := family_sum theta_coefficient t b.

Lemma entire_Theta_correct b : is_Theta_entire b (entire_Theta b).
Proof.
destruct (entire_exists b) as [theta H]. assert (E := entire_series b theta H).
destruct H as (Hex & Hode & I0 & I1 & I2). assert (D : forall n t, Derive_n (entire_Theta b) n t = Derive_n theta n t).
{ intros n t. apply Derive_n_ext. intros s. symmetry. apply E. }
unfold is_Theta_entire. rewrite <- I0, <- I1, <- I2. refine (conj _ (conj _ (conj _ (conj _ _)))).
- intros k t Hk. specialize (Hex k t Hk). apply (ex_derive_n_ext theta); auto.
- intros t. assert (D1 : Derive (entire_Theta b) t = Derive theta t) by exact (D 1%nat t).
  rewrite D, D1, <- (Hode t), (E t). reflexivity.
- symmetry. apply E.
- apply (D 1%nat).
- apply D.
Qed.

Theorem zeros_analytic (m i : nat) (l : R -> list R) : (i < m mod 3 + m / 3)%nat ->
  (forall b, INR m < b < INR m + 1 -> zero_list b (l b)) ->
  forall b, INR m < b < INR m + 1 -> analytic_at (fun b => nth i (l b) 0) b.
Proof.
intros Hi Hl b0 Hb.
assert (ET : forall b, INR m < b < INR m + 1 -> forall t, Th b t = entire_Theta b t).
{ intros b Hb' t. assert (N := cell_is_not_nat m b Hb').
  exact (Th_family b t N). }
assert (Z := z_zero m i l Hi Hl b0 Hb). assert (S := z_simple m i l Hi Hl b0 Hb).
rewrite (Derive_ext _ _ _ (ET b0 Hb)) in Z. rewrite (Derive_n_ext _ _ 2 _ (ET b0 Hb)) in S.
destruct (zero_curve entire_Theta _ b0 entire_Theta_correct Z S) as (z & eps & He & Az & _ & Hz).
apply (analytic_ext_loc z); auto.
assert (C := z_continuous m i l Hi Hl b0 Hb). apply filterlim_locally with (eps := mkposreal eps He) in C.
assert (B : locally b0 (fun b => Rabs (b - b0) < eps)) by (exists (mkposreal eps He); intros y Hy; exact Hy).
eapply filter_imp; [|exact (filter_and _ _ C (filter_and _ _ B (cell_open m b0 Hb)))].
intros b (H1 & H2 & H3). symmetry. apply (Hz b _ H2 H1). rewrite <- (Derive_ext _ _ _ (ET b H3)).
apply (z_zero m i l Hi Hl b H3).
Qed.
