(** * The compliant model: what the side rule says of every state

    The number K of a motion is that of [CompliantSideRule]: it is C on slow motions; it is linear, because motions in
    contact are determined by their state; contact that lasts for ever has K Gamma(-beta) >= 0; with K Gamma(-beta) > 0
    the motion comes into the cone of [CompliantLateCone], so it is stable. *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral Family CompliantKernel
  CompliantIntegral CompliantSlow
  CompliantMechanism CompliantSlowMotion CompliantExcess CompliantDominance CompliantLateCone CompliantStable
    CompliantDichotomy CompliantSplit CompliantSideRule.
Open Scope R_scope.

Section Every.
Variables (a1 a2 a3 eps : R).
Hypothesis Hpar : parameters a1 a3 eps.
Let Ha1 := par1 a1 a3 eps Hpar.
Let Ha3 := par3 a1 a3 eps Hpar.
Let He := par_eps a1 a3 eps Hpar.
Let Hb := par_beta a1 a3 eps Hpar.
Let Ha13 := a13 a1 a3 Ha1 Hb.
Let Hee := He' a1 eps Ha1 He.
Let Gam := Gamma (- (a3 / a1)).
Let fs := slow_derivative (- a1 * eps) (a3 / a1).

Definition contact_from (t0 : R) (p b y v z : R -> R) : Prop :=
  forall t, t0 <= t -> p t = a1 * t /\ model_at a1 a2 a3 eps linear_force p b y v z t.

Lemma one_number y z K L : side_number a1 a2 a3 eps y z K -> side_number a1 a2 a3 eps y z L -> K = L.
Proof.
intros HK HL. assert (S := slow_motion_sol a1 a2 a3 eps Hpar 1).
specialize (HK _ _ _ _ _ S). specialize (HL _ _ _ _ _ S).
apply is_lim_unique in HK. apply is_lim_unique in HL. rewrite HK in HL. injection HL. auto.
Qed.

Theorem number_exists t0 p b y v z : contact_from t0 p b y v z -> exists K0, splits a1 a2 a3 eps p b y v z K0 /\
  side_number a1 a2 a3 eps y z (K0 * Gam) /\
  (0 < K0 * Gam * Gam -> forall g, exists T, forall t, T <= t -> exp (g * t) <= excess a1 a2 a3 eps y z t) /\
  (K0 * Gam * Gam < 0 -> forall g, exists T, forall t, T <= t -> excess a1 a2 a3 eps y z t <= - exp (g * t)).
Proof.
intros H. destruct (motion_split a1 a2 a3 eps Hpar t0 p b y v z H) as (K0 & HK). exists K0.
assert (Same : forall P B Y V Z, slow_motion a1 a2 a3 eps 1 P B Y V Z ->
  is_lim (fun t => force_excess a1 a2 a3 eps (y t) (z t) / force_excess a1 a2 a3 eps (Y t) (Z t)) p_infty (K0 * Gam) /\
  (0 < K0 * Gam * Gam -> forall g, exists T, forall t, T <= t -> exp (g * t) <= excess a1 a2 a3 eps y z t) /\
  (K0 * Gam * Gam < 0 -> forall g, exists T, forall t, T <= t -> excess a1 a2 a3 eps y z t <= - exp (g * t))).
{ intros P B Y V Z HS. exact (sides_of_splitting a1 a2 a3 eps Hpar P B Y V Z p b y v z HS K0 HK). }
refine (conj HK (conj _ _)).
- intros P B Y V Z HS. apply (Same _ _ _ _ _ HS).
- apply (Same _ _ _ _ _ (slow_motion_sol a1 a2 a3 eps Hpar 1)).
Qed.

Theorem every_state_rule t0 p b y v z : contact_from t0 p b y v z -> exists K, side_number a1 a2 a3 eps y z K /\
  (0 < K * Gam -> forall g, exists T, forall t, T <= t -> exp (g * t) <= force_excess a1 a2 a3 eps (y t) (z t)) /\
  (K * Gam < 0 -> forall g, exists T, forall t, T <= t -> force_excess a1 a2 a3 eps (y t) (z t) <= - exp (g * t)) /\
  (K = 0 -> forall g, 0 < g -> exists A T, forall t, T <= t -> Rabs (force_excess a1 a2 a3 eps (y t) (z t)) <= A * exp
    (g * t)).
Proof.
intros H. destruct (number_exists t0 p b y v z H) as (K0 & HK & HN & Hup & Hdown).
exists (K0 * Gam). refine (conj HN (conj Hup (conj Hdown _))). intros E g Hg.
assert (HG := not_nat_Gamma (a3 / a1) Hb : Gam <> 0).
assert (E0 : K0 = 0) by (apply Rmult_integral in E; destruct E; [auto|contradiction]).
destruct (HK g Hg) as (A & T & HA). exists (/ (- a3 * eps) * A), T. intros t Ht. destruct (HA t Ht) as (_ & A1 & _).
rewrite E0, Rmult_0_l, Rminus_0_r in A1. assert (Hk : 0 < / (- a3 * eps)) by (apply k_pos; auto).
replace (force_excess a1 a2 a3 eps (y t) (z t)) with (/ (- a3 * eps) * (- a3 * eps * excess a1 a2 a3 eps y z t))
  by (unfold excess; field; lra).
rewrite Rabs_mult, (Rabs_pos_eq (/ (- a3 * eps))), (Rmult_assoc (/ (- a3 * eps)) A) by lra.
apply Rmult_le_compat_l; lra.
Qed.

(** On slow motions K = C. *)
Theorem slow_number C p b y v z : slow_motion a1 a2 a3 eps C p b y v z -> side_number a1 a2 a3 eps y z C.
Proof.
intros HS P B Y V Z HS1. destruct (slow_outgrows a1 a2 a3 eps Hpar P B Y V Z HS1 0 (Rle_refl 0)) as (c & T & Hc & HF).
apply (is_lim_ext_loc (fun _ => C)); [|apply is_lim_const]. exists T. intros t Ht. specialize (HF t ltac:(lra)).
rewrite Rmult_0_l, exp_0, Rmult_1_r in HF.
assert (E : force_excess a1 a2 a3 eps (y t) (z t) = C * force_excess a1 a2 a3 eps (Y t) (Z t)).
{ assert (E1 := slow_force a1 a2 a3 eps Hpar C p b y v z HS t).
  assert (E2 := slow_force a1 a2 a3 eps Hpar 1 P B Y V Z HS1 t).
  unfold linear_force in E1, E2. unfold force_excess. rewrite E1, E2. unfold sol_l. field. repeat split; lra. }
assert (force_excess a1 a2 a3 eps (Y t) (Z t) <> 0) by (intros E0; rewrite E0 in HF; lra).
rewrite E. field. auto.
Qed.

(** A contact that lasts for ever. *)
Theorem lasting t0 K p b y v z : (forall t, t0 <= t -> p t = a1 * t /\
  model_at a1 a2 a3 eps contact_force p b y v z t /\ y t < z t) ->
  side_number a1 a2 a3 eps y z K -> 0 <= K * Gam.
Proof.
intros H HK. apply Rnot_lt_le. intros Hn.
assert (Hl : contact_from t0 p b y v z).
{ intros t Ht. destruct (H t Ht) as (A & B & C). split; auto. apply in_contact; auto. }
destruct (every_state_rule t0 p b y v z Hl) as (L & HL & _ & Hdown & _). rewrite <- (one_number y z K L HK HL) in Hdown.
set (M := Rabs (a2 / (a3 - a1))). destruct (Hdown Hn 1) as (T & HT). set (t := Rmax t0 (Rmax T M)).
assert (M1 := Rmax_l t0 (Rmax T M)). assert (M2 := Rmax_r t0 (Rmax T M)). assert (M3 := Rmax_l T M).
assert (M4 := Rmax_r T M). fold t in M1, M2.
specialize (HT t ltac:(lra)). destruct (H t M1) as (_ & _ & Hc). rewrite Rmult_1_l in HT. assert (Ex := exp_ineq1_le t).
assert (Hf : 0 < (z t - y t) / eps ^ 2) by (apply Rdiv_lt_0_compat; [lra|apply pow_lt, He]).
assert (HM := Rle_abs (a2 / (a3 - a1))). fold M in HM. unfold force_excess in HT. lra.
Qed.

(** With K Gamma(-beta) > 0 the motion comes into the cone. *)
Lemma into_cone p b y v z K0 : splits a1 a2 a3 eps p b y v z K0 -> 0 < K0 ->
  exists T, forall t, T <= t -> late_cone a1 a2 a3 eps (p t) (b t) (y t) (v t) (z t).
Proof.
intros HK Hp. destruct (HK 1 ltac:(lra)) as (A & T0 & HA).
destruct (slow_grows a1 a3 eps Hpar 0 2 ltac:(lra)) as (c & T1 & Hc & HF).
destruct (exponential_wins (4 * A) (K0 * c) 1 1 ltac:(apply Rmult_lt_0_compat; auto)) as (T2 & HT2 & HE).
destruct (Fe_ratio _ Hee (a3 / a1) 0 2 Hb ltac:(lra)) as (S1 & HS1 & F1).
destruct (Fe_ratio _ Hee (a3 / a1) 1 2 Hb ltac:(lra)) as (S2 & HS2 & F2).
destruct (Fe_ratio _ Hee (a3 / a1) 2 4 Hb ltac:(lra)) as (S3 & HS3 & F3).
assert (N : 0 <= eps * (S1 + S2 + S3)) by (apply Rmult_le_pos; lra).
exists (Rmax (Rmax T0 T1) (Rmax T2 (eps * (S1 + S2 + S3)))). intros t Ht.
assert (M1 := Rmax_l (Rmax T0 T1) (Rmax T2 (eps * (S1 + S2 + S3)))).
assert (M2 := Rmax_r (Rmax T0 T1) (Rmax T2 (eps * (S1 + S2 + S3)))).
assert (M3 := Rmax_l T0 T1). assert (M4 := Rmax_r T0 T1). assert (M5 := Rmax_l T2 (eps * (S1 + S2 + S3))).
assert (M6 := Rmax_r T2 (eps * (S1 + S2 + S3))).
assert (HT : S1 + S2 + S3 <= t / eps).
{ apply Rmult_le_reg_l with eps; auto. replace (eps * (t / eps)) with t by (field; lra). lra. }
specialize (HA t ltac:(lra)). specialize (HF t ltac:(lra)). specialize (HE t ltac:(lra)). rewrite Rabs_R1 in HE.
replace (1 + 1) with 2 in HE by ring.
specialize (F1 (t / eps) ltac:(lra)). specialize (F2 (t / eps) ltac:(lra)). specialize (F3 (t / eps) ltac:(lra)).
change (2 * fs 0%nat (t / eps) < fs 1%nat (t / eps)) in F1. change (2 * fs 1%nat (t / eps) < fs 2%nat (t / eps)) in F2.
change (4 * fs 2%nat (t / eps) < fs 3%nat (t / eps)) in F3. change (c * exp (2 * t) <= fs 0%nat (t / eps)) in HF.
change (Rabs (deviation a1 a2 a3 p b t - K0 * fs 0%nat (t / eps)) <= A * exp (1 * t) /\
  Rabs (- a3 * eps * excess a1 a2 a3 eps y z t - K0 * fs 1%nat (t / eps)) <= A * exp (1 * t) /\
  Rabs (- a3 * eps ^ 2 * excess1 eps y v z t - K0 * fs 2%nat (t / eps)) <= A * exp (1 * t) /\
  Rabs (- a3 * eps ^ 3 * excess2 eps p b y v z t - K0 * fs 3%nat (t / eps)) <= A * exp (1 * t)) in HA.
destruct HA as (A0 & A1 & A2 & A3).
set (f0 := fs 0%nat (t / eps)) in *. set (f1 := fs 1%nat (t / eps)) in *. set (f2 := fs 2%nat (t / eps)) in *.
set (f3 := fs 3%nat (t / eps)) in *.
set (R := A * exp (1 * t)) in *. assert (HR : 4 * R + 1 <= K0 * f0).
{ apply Rle_trans with (K0 * (c * exp (2 * t))); [unfold R; lra|apply Rmult_le_compat_l; lra]. }
assert (HR0 : 0 <= R) by (eapply Rle_trans; [apply Rabs_pos|exact A0]).
assert (P1 : 0 < K0 * (f1 - 2 * f0)) by (apply Rmult_lt_0_compat; lra).
assert (P2 : 0 < K0 * (f2 - 2 * f1)) by (apply Rmult_lt_0_compat; lra).
assert (P3 : 0 < K0 * (f3 - 4 * f2)) by (apply Rmult_lt_0_compat; lra).
apply Rabs_le_between in A0, A1, A2, A3. assert (Hk : 0 < - a3 * eps) by nra.
unfold late_cone. cbv zeta. change (force_excess a1 a2 a3 eps (y t) (z t)) with (excess a1 a2 a3 eps y z t).
change (force_excess1 eps (y t) (v t) (z t)) with (excess1 eps y v z t).
change (force_excess2 eps (p t) (b t) (y t) (v t) (z t)) with (excess2 eps p b y v z t).
change (b t - a2 / (a1 - a3) * p t) with (deviation a1 a2 a3 p b t).
set (E0 := excess a1 a2 a3 eps y z t) in *. set (E1 := excess1 eps y v z t) in *.
set (E2 := excess2 eps p b y v z t) in *.
refine (conj _ (conj _ (conj _ _))); [lra|lra| |]; apply Rmult_lt_reg_l with (- a3 * eps); auto.
- replace (- a3 * eps * (eps * E1)) with (- a3 * eps ^ 2 * E1) by ring. lra.
- replace (- a3 * eps * (eps * E1 + 2 * E0)) with (- a3 * eps ^ 2 * E1 + 2 * (- a3 * eps * E0)) by ring.
  replace (- a3 * eps * (eps ^ 2 * E2)) with (- a3 * eps ^ 3 * E2) by ring. lra.
Qed.

Theorem stable_every K t0 P B Y V Z : (forall t, t0 <= t -> P t = a1 * t /\
  model_at a1 a2 a3 eps contact_force P B Y V Z t /\ Y t < Z t) ->
  side_number a1 a2 a3 eps Y Z K -> 0 < K * Gam ->
  exists delta, 0 < delta /\ forall p b y v z, (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  Rabs (p t0 - P t0) < delta -> Rabs (b t0 - B t0) < delta -> Rabs (y t0 - Y t0) < delta ->
  Rabs (v t0 - V t0) < delta -> Rabs (z t0 - Z t0) < delta ->
  (forall t, t0 <= t -> y t < z t) /\
  (forall M, exists T, forall t, T <= t -> M <= contact_force eps (y t) (z t)) /\
  (forall M, exists T, forall t, T <= t -> y t <= M).
Proof.
intros H HK Hp.
assert (Hl : contact_from t0 P B Y V Z).
{ intros t Ht. destruct (H t Ht) as (A & A' & A''). split; auto. apply in_contact; auto. }
destruct (number_exists t0 P B Y V Z Hl) as (K0 & HS & HN & _). rewrite (one_number Y Z K _ HK HN) in Hp.
assert (HG := not_nat_Gamma (a3 / a1) Hb : Gam <> 0).
assert (HK0 : 0 < K0).
{ replace K0 with (K0 * Gam * Gam * (/ Gam) ^ 2) by (field; auto). apply Rmult_lt_0_compat; auto.
  apply pow2_gt_0, Rinv_neq_0_compat, HG. }
apply (stable a1 a2 a3 eps t0 P B Y V Z Ha1 Ha3 Ha13 He); try (intros t Ht; apply (H t Ht)).
exact (into_cone P B Y V Z K0 HS HK0).
Qed.

(** K is linear in the state. *)
Theorem number_linear t0 k k' K K' p b y v z p' b' y' v' z' p'' b'' y'' v'' z'' :
  contact_from t0 p b y v z -> contact_from t0 p' b' y' v' z' -> contact_from t0 p'' b'' y'' v'' z'' ->
  let B := a2 / (a1 - a3) * (a1 * t0) in let Z := eps ^ 2 * a2 / (a1 - a3) in let Y := 2 * Z in
  b'' t0 - B = k * (b t0 - B) + k' * (b' t0 - B) -> y'' t0 - Y = k * (y t0 - Y) + k' * (y' t0 - Y) ->
  v'' t0 = k * v t0 + k' * v' t0 -> z'' t0 - Z = k * (z t0 - Z) + k' * (z' t0 - Z) ->
  side_number a1 a2 a3 eps y z K -> side_number a1 a2 a3 eps y' z' K' -> side_number a1 a2 a3 eps y'' z''
    (k * K + k' * K').
Proof.
intros H H' H'' B Z Y Eb Ey Ev Ez HK HK'.
assert (Sum : forall t, t0 <= t -> excess a1 a2 a3 eps y'' z'' t = k * excess a1 a2 a3 eps y z t
  + k' * excess a1 a2 a3 eps y' z' t).
{ intros t Ht.
  assert (Ch := forward_combination _ _ _ k k' _ _ _ _ _ _ _ _ _ _ _ _ (motion_chain a1 a2 a3 eps Hpar t0 p b y v z H)
    (motion_chain a1 a2 a3 eps Hpar t0 p' b' y' v' z' H') (motion_chain a1 a2 a3 eps Hpar t0 p'' b'' y'' v'' z'' H'')).
  cbv beta in Ch.
  assert (Et : eps * (t0 / eps) = t0) by (field; lra).
  assert (Ep : p t0 = a1 * t0) by (apply (H t0); lra). assert (Ep' : p' t0 = a1 * t0) by (apply (H' t0); lra).
  assert (Ep'' : p'' t0 = a1 * t0) by (apply (H'' t0); lra).
  assert (Fb : b'' t0 = B + k * (b t0 - B) + k' * (b' t0 - B)) by lra.
  assert (Fy : y'' t0 = Y + k * (y t0 - Y) + k' * (y' t0 - Y)) by lra.
  assert (Fz : z'' t0 = Z + k * (z t0 - Z) + k' * (z' t0 - Z)) by lra.
  assert (Z0 := forward_zero _ _ Hee (t0 / eps) _ _ _ _ Ch). cbv beta in Z0. rewrite Et in Z0.
  assert (Ht' : t0 / eps <= t / eps) by (apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, He|exact Ht]).
  assert (R := Z0
    ltac:(unfold deviation; rewrite Ep, Ep', Ep'', Fb; unfold B; field; lra)
    ltac:(unfold excess, force_excess; rewrite Fy, Fz; unfold Y, Z; field; repeat split; lra)
    ltac:(unfold excess1, force_excess1; rewrite Fy, Fz, Ev; unfold Y, Z; field; repeat split; lra)
    ltac:(unfold excess2, force_excess2; rewrite Ep, Ep', Ep'', Fb, Fy, Fz, Ev; unfold B, Y, Z; field; repeat split;
      lra) (t / eps) Ht').
  replace (eps * (t / eps)) with t in R by (field; lra).
  apply Rmult_eq_reg_l with (- a3 * eps); [lra|]. nra. }
intros P Bs Ys V Zs HS. specialize (HK _ _ _ _ _ HS). specialize (HK' _ _ _ _ _ HS).
apply (is_lim_ext_loc (fun t => k * (force_excess a1 a2 a3 eps (y t) (z t) / force_excess a1 a2 a3 eps (Ys t) (Zs t))
  + k' * (force_excess a1 a2 a3 eps (y' t) (z' t) / force_excess a1 a2 a3 eps (Ys t) (Zs t)))).
- exists t0. intros t Ht. assert (S := Sum t ltac:(lra)). unfold excess in S. rewrite S. unfold Rdiv. ring.
- apply is_lim_plus'. apply (is_lim_scal_l _ k p_infty K HK). apply (is_lim_scal_l _ k' p_infty K' HK').
Qed.

End Every.
