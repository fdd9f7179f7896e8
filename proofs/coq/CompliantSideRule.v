(** * The compliant model: the exact side rule for every state

    A motion in contact with p = a1 t is, in T = t/eps, a solution of the equation of the deviation; so its force less
    the mean is K times that of the slow motion with C = 1, up to O(e^(gt)) for every g > 0 ([CompliantSplit]), while
    the slow motion's outgrows every exponential with the sign of Gamma(-beta). *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral Family CompliantKernel
  CompliantIntegral CompliantSlow
  CompliantMechanism CompliantCone CompliantContact CompliantForward CompliantSlowMotion CompliantExcess
    CompliantDichotomy CompliantSplit.
Open Scope R_scope.

(** ** From a splitting to the sides *)

Lemma exponential_wins A a g M : 0 < a -> exists T, 0 <= T /\ forall t, T <= t -> A * exp (g * t) + M <= a * exp
  ((Rabs g + 1) * t).
Proof.
intros Ha. set (S := (Rabs A + Rabs M) / a).
assert (HS : 0 <= S) by (unfold S; apply Rmult_le_pos; [generalize (Rabs_pos A) (Rabs_pos M); lra|apply Rlt_le,
  Rinv_0_lt_compat, Ha]).
exists S. split; auto. intros t Ht. set (G := Rabs g). assert (HG : 0 <= G) by apply Rabs_pos.
assert (HGt : 0 <= G * t) by (apply Rmult_le_pos; lra).
replace (exp ((G + 1) * t)) with (exp (G * t) * exp t) by (rewrite <- exp_plus; f_equal; ring).
assert (E1 : 1 <= exp (G * t)) by (rewrite <- exp_0; apply exp_le; lra).
assert (E2 : exp (g * t) <= exp (G * t)) by (apply exp_le, Rmult_le_compat_r; [lra|apply Rle_abs]).
assert (E3 := exp_ineq1_le t). assert (E4 := exp_pos (g * t)).
assert (A1 : A * exp (g * t) <= Rabs A * exp (G * t)).
{ apply Rle_trans with (Rabs A * exp (g * t)); [apply Rmult_le_compat_r; [lra|apply Rle_abs]|apply Rmult_le_compat_l;
    [apply Rabs_pos|lra]]. }
assert (A2 : M <= Rabs M * exp (G * t)).
{ apply Rle_trans with (Rabs M * 1); [generalize (Rle_abs M); lra|apply Rmult_le_compat_l; [apply Rabs_pos|lra]]. }
assert (A3 : Rabs A + Rabs M <= a * exp t).
{ replace (Rabs A + Rabs M) with (a * S) by (unfold S; field; lra). apply Rmult_le_compat_l; lra. }
assert (A4 : (Rabs A + Rabs M) * exp (G * t) <= a * exp t * exp (G * t)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Section Sides.
Variables (K Gam : R) (f s : R -> R).
Hypothesis HGam : Gam <> 0.
Hypothesis Split : forall g, 0 < g -> exists A T, forall t, T <= t -> Rabs (f t - K * s t) <= A * exp (g * t).
Hypothesis Grow : forall g, 0 <= g -> exists c T, 0 < c /\ forall t, T <= t -> c * exp (g * t) <= Gam * s t.

Lemma side_limit : is_lim (fun t => f t / s t) p_infty K.
Proof.
apply is_lim_spec. intros r. destruct (Split 1 ltac:(lra)) as (A & T1 & HA).
destruct (Grow 2 ltac:(lra)) as (c & T2 & Hc & HG).
assert (HaG : 0 < Rabs Gam) by (apply Rabs_pos_lt; auto).
assert (Ha : 0 < r * c / Rabs Gam).
{ apply Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat; [apply cond_pos|auto]. }
destruct (exponential_wins A (r * c / Rabs Gam / 2) 1 0 ltac:(lra)) as (T3 & HT3 & H3).
exists (Rmax (Rmax T1 T2) T3). intros t Ht.
assert (M1 := Rmax_l (Rmax T1 T2) T3). assert (M2 := Rmax_r (Rmax T1 T2) T3). assert (M3 := Rmax_l T1 T2).
assert (M4 := Rmax_r T1 T2).
specialize (HA t ltac:(lra)). specialize (HG t ltac:(lra)). specialize (H3 t ltac:(lra)). rewrite Rabs_R1 in H3.
replace (1 + 1) with 2 in H3 by ring.
set (E := exp (2 * t)) in *. assert (HE : 0 < E) by apply exp_pos.
assert (HcE : 0 < c * E) by (apply Rmult_lt_0_compat; auto).
assert (Hs : s t <> 0) by (intros E0; rewrite E0 in HG; lra).
assert (Hs2 : c * E <= Rabs Gam * Rabs (s t)) by (rewrite <- Rabs_mult; eapply Rle_trans; [exact HG|apply Rle_abs]).
assert (Hs3 : 0 < Rabs (s t)) by (apply Rabs_pos_lt; auto).
replace (f t / s t - K) with ((f t - K * s t) * / s t) by (field; auto). rewrite Rabs_mult, Rabs_inv.
apply Rmult_lt_reg_r with (Rabs (s t)); auto. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
eapply Rle_lt_trans; [exact HA|]. rewrite Rplus_0_r in H3. eapply Rle_lt_trans; [exact H3|].
assert (B : r * c / Rabs Gam * E <= r * Rabs (s t)).
{ replace (r * c / Rabs Gam * E) with (r / Rabs Gam * (c * E)) by (field; lra).
  replace (r * Rabs (s t)) with (r / Rabs Gam * (Rabs Gam * Rabs (s t))) by (field; lra).
  apply Rmult_le_compat_l; [|exact Hs2]. apply Rlt_le, Rdiv_lt_0_compat; [apply cond_pos|auto]. }
assert (0 < r * c / Rabs Gam * E) by (apply Rmult_lt_0_compat; auto). lra.
Qed.

Lemma side_above : 0 < K * Gam -> forall g, exists T, forall t, T <= t -> exp (g * t) <= f t.
Proof.
intros HK g. set (G := Rabs g + 1). assert (HG0 : 1 <= G) by (unfold G; generalize (Rabs_pos g); lra).
destruct (Split G ltac:(lra)) as (A & T1 & HA). destruct (Grow (G + 1) ltac:(lra)) as (c & T2 & Hc & HG).
set (q := K / Gam). assert (Hq : 0 < q).
{ unfold q. replace (K / Gam) with (K * Gam * (/ Gam) ^ 2) by (field; auto). apply Rmult_lt_0_compat; auto.
  apply pow2_gt_0, Rinv_neq_0_compat, HGam. }
destruct (exponential_wins (A + 1) (q * c) G 0 ltac:(apply Rmult_lt_0_compat; auto)) as (T3 & HT3 & H3).
exists (Rmax (Rmax T1 T2) T3). intros t Ht.
assert (M1 := Rmax_l (Rmax T1 T2) T3). assert (M2 := Rmax_r (Rmax T1 T2) T3). assert (M3 := Rmax_l T1 T2).
assert (M4 := Rmax_r T1 T2).
specialize (HA t ltac:(lra)). specialize (HG t ltac:(lra)). specialize (H3 t ltac:(lra)).
rewrite (Rabs_pos_eq G), Rplus_0_r in H3 by lra. apply Rabs_le_between in HA.
assert (B : q * (c * exp ((G + 1) * t)) <= q * (Gam * s t)) by (apply Rmult_le_compat_l; lra).
replace (q * (Gam * s t)) with (K * s t) in B by (unfold q; field; auto).
assert (D : exp (g * t) <= exp (G * t)).
{ apply exp_le, Rmult_le_compat_r; [lra|]. unfold G. generalize (Rle_abs g). lra. } lra.
Qed.

End Sides.

(** ** Motions *)
Section Mechanism.
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

Definition splits (p b y v z : R -> R) (K : R) : Prop := forall g, 0 < g -> exists A T, forall t, T <= t ->
  Rabs (deviation a1 a2 a3 p b t - K * fs 0%nat (t / eps)) <= A * exp (g * t) /\
  Rabs (- a3 * eps * excess a1 a2 a3 eps y z t - K * fs 1%nat (t / eps)) <= A * exp (g * t) /\
  Rabs (- a3 * eps ^ 2 * excess1 eps y v z t - K * fs 2%nat (t / eps)) <= A * exp (g * t) /\
  Rabs (- a3 * eps ^ 3 * excess2 eps p b y v z t - K * fs 3%nat (t / eps)) <= A * exp (g * t).

Section Motion.
Variables (t0 : R) (p b y v z : R -> R).
Hypothesis H : forall t, t0 <= t -> p t = a1 * t /\ model_at a1 a2 a3 eps linear_force p b y v z t.

Let x0 (T : R) : R := 1 * deviation a1 a2 a3 p b (eps * T).
Let x1 (T : R) : R := - a3 * eps * excess a1 a2 a3 eps y z (eps * T).
Let x2 (T : R) : R := - a3 * eps ^ 2 * excess1 eps y v z (eps * T).
Let x3 (T : R) : R := - a3 * eps ^ 3 * excess2 eps p b y v z (eps * T).

Lemma motion_chain : forward_chain (- a1 * eps) (a3 / a1) (t0 / eps) x0 x1 x2 x3.
Proof.
intros T HT. assert (Ht : t0 <= eps * T).
{ replace t0 with (eps * (t0 / eps)) by (field; lra). apply Rmult_le_compat_l; lra. }
destruct (H _ Ht) as (Ep & Hm).
destruct (excess_derive a1 a2 a3 eps Ha13 He p b y v z _ Hm) as (D0 & D1 & D2 & D3). rewrite Ep in D3.
refine (conj _ (conj _ (conj _ _))).
- apply (is_derive_val _ _ _ _ (scale_derive eps _ _ 1 T D0)). unfold x1. ring.
- apply (is_derive_val _ _ _ _ (scale_derive eps _ _ (- a3 * eps) T D1)). unfold x2. ring.
- apply (is_derive_val _ _ _ _ (scale_derive eps _ _ (- a3 * eps ^ 2) T D2)). unfold x3. ring.
- apply (is_derive_val _ _ _ _ (scale_derive eps _ _ (- a3 * eps ^ 3) T D3)). unfold x0, x1, x2, x3. field.
  repeat split; lra.
Qed.

(** K with the remainders, in t *)
Lemma motion_split : exists K, splits p b y v z K.
Proof.
destruct (split_every_rate (- a1 * eps) (a3 / a1) Hee Hb _ _ _ _ _ motion_chain) as (K & HK). exists K. intros g Hg.
destruct (HK (g * eps) ltac:(apply Rmult_lt_0_compat; lra)) as (A & T & HA). exists A, (eps * T). intros t Ht.
assert (HT : T <= t / eps).
{ apply Rmult_le_reg_l with eps; auto. replace (eps * (t / eps)) with t by (field; lra). exact Ht. }
specialize (HA _ HT). unfold x0, x1, x2, x3 in HA. replace (eps * (t / eps)) with t in HA by (field; lra).
replace (g * eps * (t / eps)) with (g * t) in HA by (field; lra). rewrite Rmult_1_l in HA. exact HA.
Qed.

End Motion.

Lemma slow_grows n g : 0 <= g -> exists c T, 0 < c /\ forall t, T <= t -> c * exp (g * t) <= fs n (t / eps).
Proof.
intros Hg. destruct (slow_exponential (- a1 * eps) (a3 / a1) Hee Hb n (g * eps) ltac:(apply Rmult_le_pos; lra))
  as (c & T & Hc & _ & HF).
exists c, (eps * T). split; auto. intros t Ht.
assert (HT : T <= t / eps).
{ apply Rmult_le_reg_l with eps; auto. replace (eps * (t / eps)) with t by (field; lra). exact Ht. }
specialize (HF _ HT). replace (g * eps * (t / eps)) with (g * t) in HF by (field; lra). exact HF.
Qed.

Lemma slow_excess P B Y V Z : slow_motion a1 a2 a3 eps 1 P B Y V Z ->
  forall t, Gam * force_excess a1 a2 a3 eps (Y t) (Z t) = fs 1%nat (t / eps) / (- a3 * eps).
Proof.
intros HS t. assert (E := slow_force a1 a2 a3 eps Hpar 1 P B Y V Z HS t). unfold linear_force in E. unfold force_excess.
rewrite E.
unfold sol_l, fs, slow_derivative.
change (Derive_n (Fe (- a1 * eps) (a3 / a1)) 1 (t / eps)) with (Derive (Fe (- a1 * eps) (a3 / a1)) (t / eps)).
fold Gam. field. repeat split; lra.
Qed.

Section Rule.
Variables (P B Y V Z p b y v z : R -> R).
Hypothesis HS : slow_motion a1 a2 a3 eps 1 P B Y V Z.
Let slow (t : R) : R := force_excess a1 a2 a3 eps (Y t) (Z t).
Let f (t : R) : R := force_excess a1 a2 a3 eps (y t) (z t).

Lemma gam_neq : Gam <> 0.
Proof. exact (not_nat_Gamma (a3 / a1) Hb). Qed.

Lemma slow_outgrows g : 0 <= g -> exists c T, 0 < c /\ forall t, T <= t -> c * exp (g * t) <= Gam * slow t.
Proof.
intros Hg. destruct (slow_grows 1 g Hg) as (c & T & Hc & HF). assert (Hk : 0 < / (- a3 * eps)) by (apply k_pos; auto).
exists (c * / (- a3 * eps)), T. split; [apply Rmult_lt_0_compat; auto|]. intros t Ht. unfold slow.
rewrite (slow_excess P B Y V Z HS t).
replace (c * / (- a3 * eps) * exp (g * t)) with (c * exp (g * t) * / (- a3 * eps)) by ring.
apply Rmult_le_compat_r; [lra|auto].
Qed.

Theorem sides_of_splitting K0 : splits p b y v z K0 ->
  is_lim (fun t => f t / slow t) p_infty (K0 * Gam) /\
  (0 < K0 * Gam * Gam -> forall g, exists T, forall t, T <= t -> exp (g * t) <= f t) /\
  (K0 * Gam * Gam < 0 -> forall g, exists T, forall t, T <= t -> f t <= - exp (g * t)).
Proof.
intros HK. assert (HG := gam_neq). assert (Hk : 0 < / (- a3 * eps)) by (apply k_pos; auto).
assert (HSp : forall g, 0 < g -> exists A T, forall t, T <= t -> Rabs (f t - K0 * Gam * slow t) <= A * exp (g * t)).
{ intros g Hg. destruct (HK g Hg) as (A & T & HA). exists (/ (- a3 * eps) * A), T. intros t Ht.
  destruct (HA t Ht) as (_ & A1 & _).
  assert (E := slow_excess P B Y V Z HS t). fold (slow t) in E.
  replace (f t - K0 * Gam * slow t) with (/ (- a3 * eps) * (- a3 * eps * excess a1 a2 a3 eps y z t - K0 * fs 1%nat
    (t / eps))).
  2: { rewrite (Rmult_assoc K0), E. unfold excess. fold (f t). field. split; lra. }
  rewrite Rabs_mult, (Rabs_pos_eq (/ (- a3 * eps))), (Rmult_assoc (/ (- a3 * eps)) A) by lra.
  apply Rmult_le_compat_l; lra. }
refine (conj _ (conj _ _)).
- apply (side_limit _ Gam f slow HG HSp slow_outgrows).
- intros Hp. apply (side_above _ Gam f slow HG HSp slow_outgrows Hp).
- intros Hn g. destruct (side_above (- (K0 * Gam)) Gam (fun t => - f t) slow HG) with (g := g) as (T & HT).
  + intros h Hh. destruct (HSp h Hh) as (A & T & HA). exists A, T. intros t Ht. specialize (HA t Ht).
    replace (- f t - - (K0 * Gam) * slow t) with (- (f t - K0 * Gam * slow t)) by ring. rewrite Rabs_Ropp. exact HA.
  + exact slow_outgrows.
  + replace (- (K0 * Gam) * Gam) with (- (K0 * Gam * Gam)) by ring. apply Ropp_0_gt_lt_contravar. exact Hn.
  + exists T. intros t Ht. specialize (HT t Ht). lra.
Qed.

End Rule.
End Mechanism.
