(** * The compliant model: t -> -oo on the slow motions; Case I; the trivial solution as printed *)

From Coq Require Import Reals Psatz Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral Family CompliantKernel
  CompliantIntegral
  CompliantSlow CompliantMechanism CompliantContact CompliantForward.
Open Scope R_scope.

Section Cases.
Variables (a1 a2 a3 eps C : R).
Hypothesis Ha1 : a1 < 0.
Hypothesis Ha3 : a3 < 0.
Hypothesis Heps : 0 < eps.
Hypothesis Hbeta : not_nat (a3 / a1).

Lemma sol_l_family t : sol_l a1 a2 a3 eps C t =
  a2 / (a3 - a1) - C * (a3 / a1) / (- a3 * eps) * Fe (- a1 * eps) (a3 / a1 - 1) (t / eps).
Proof.
unfold sol_l. assert (Ha := a13 a1 a3 Ha1 Hbeta).
rewrite (is_derive_unique _ _ _ (Fe_derive (- a1 * eps) (He' a1 eps Ha1 Heps) (a3 / a1) (t / eps) Hbeta)).
field. repeat split; lra.
Qed.

Lemma Rpower_small q d : q < 0 -> 0 < d -> exists X, 1 <= X /\ forall x, X < x -> Rpower x q < d.
Proof.
intros Hq Hd. exists (Rmax 1 (exp (ln d / q))). split. apply Rmax_l.
intros x Hx.
assert (H1 : 1 < x) by (eapply Rle_lt_trans; [apply Rmax_l|exact Hx]).
assert (H2 : exp (ln d / q) < x) by (eapply Rle_lt_trans; [apply Rmax_r|exact Hx]).
unfold Rpower. rewrite <- (exp_ln d) by auto. apply exp_increasing.
assert (H3 : ln d / q < ln x).
{ rewrite <- (ln_exp (ln d / q)). apply ln_increasing; auto. apply exp_pos. }
replace (ln d) with (q * (ln d / q)) by (field; lra).
apply Rmult_lt_gt_compat_neg_l; auto.
Qed.

Lemma Fe_family_bounds : exists X, 1 <= X /\ forall x, X < x ->
  / 2 * Rpower x (a3 / a1 - 1) <= Fe (- a1 * eps) (a3 / a1 - 1) (- x) <= 2 * Rpower x (a3 / a1 - 1).
Proof.
assert (H := Fe_asymptotics (- a1 * eps) (He' a1 eps Ha1 Heps) (a3 / a1 - 1) (not_nat_pred _ Hbeta)).
apply is_lim_spec in H. destruct (H (mkposreal (1 / 2) ltac:(lra))) as [M HM]. simpl in HM.
exists (Rmax 1 M). split. apply Rmax_l. intros x Hx.
specialize (HM x ltac:(eapply Rle_lt_trans; [apply Rmax_r|exact Hx])).
set (X := Rpower x (a3 / a1 - 1)) in *. assert (HX : 0 < X) by apply exp_pos.
set (F := Fe (- a1 * eps) (a3 / a1 - 1) (- x)) in *.
apply Rabs_def2 in HM.
replace F with (F / X * X) by (field; lra). split; apply Rmult_le_compat_r; lra.
Qed.

(** 0 < beta < 1: as t -> -oo the force tends to its mean value. *)
Theorem force_left : a3 / a1 < 1 -> forall d, 0 < d -> exists T, forall t, t <= T ->
  Rabs (sol_l a1 a2 a3 eps C t - a2 / (a3 - a1)) < d.
Proof.
intros H1 d Hd.
set (k := Rabs (C * (a3 / a1) / (- a3 * eps))).
assert (Hk : 0 <= k) by apply Rabs_pos.
destruct Fe_family_bounds as (X1 & HX1 & HF).
destruct (Rpower_small (a3 / a1 - 1) (d / (2 * (k + 1))) ltac:(lra)) as (X2 & HX2 & HR).
{ apply Rdiv_lt_0_compat; lra. }
exists (- eps * (Rmax X1 X2 + 1)). intros t Ht.
assert (M1 := Rmax_l X1 X2). assert (M2 := Rmax_r X1 X2).
assert (Hx : Rmax X1 X2 < - (t / eps)).
{ apply Rmult_lt_reg_l with eps; auto. replace (eps * - (t / eps)) with (- t) by (field; lra). lra. }
specialize (HF (- (t / eps)) ltac:(lra)). specialize (HR (- (t / eps)) ltac:(lra)).
rewrite Ropp_involutive in HF.
rewrite sol_l_family.
set (F := Fe (- a1 * eps) (a3 / a1 - 1) (t / eps)) in *.
set (Y := Rpower (- (t / eps)) (a3 / a1 - 1)) in *. assert (HY : 0 < Y) by apply exp_pos.
replace (a2 / (a3 - a1) - C * (a3 / a1) / (- a3 * eps) * F - a2 / (a3 - a1)) with (- (C * (a3 / a1) / (- a3 * eps) * F))
  by ring.
rewrite Rabs_Ropp, Rabs_mult. fold k. rewrite (Rabs_pos_eq F) by lra.
apply Rle_lt_trans with ((k + 1) * (2 * Y)).
- apply Rmult_le_compat; lra.
- replace d with ((k + 1) * (2 * (d / (2 * (k + 1))))) by (field; lra).
  apply Rmult_lt_compat_l; lra.
Qed.

(** Case I (0 < beta < 1, a2 < 0), C < 0: the force changes sign exactly once, from negative to positive, and from
    that time on the slow solution solves the mechanism's equations with compl2; contact is never lost. *)
Theorem case_I : a3 / a1 < 1 -> a2 < 0 -> C < 0 -> exists t0,
  sol_l a1 a2 a3 eps C t0 = 0 /\ (forall t, t < t0 -> sol_l a1 a2 a3 eps C t < 0) /\
  (forall t, t0 < t -> 0 < sol_l a1 a2 a3 eps C t) /\
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force (sol_p a1) (sol_b a1 a2 a3 eps C) (sol_y a1 a2 a3 eps C)
     (sol_v a1 a3 eps C) (sol_z a1 a2 a3 eps C) t).
Proof.
intros H1 H2 HC. assert (HB := beta_pos a1 a3 Ha1 Ha3).
assert (Hd : 0 < a3 - a1).
{ assert (a3 / a1 * a1 = a3) by (field; lra). nra. }
assert (Hm : a2 / (a3 - a1) < 0).
{ assert (0 < - a2 / (a3 - a1)) by (apply Rdiv_lt_0_compat; lra). unfold Rdiv in *. lra. }
destruct (IWC_model a1 a2 a3 eps C Ha1 Ha3 Heps Hbeta (or_introl (conj H1 HC))) as (Hinc & Hinf & Hc).
destruct (force_left H1 (- (a2 / (a3 - a1))) ltac:(lra)) as (T & HT).
destruct (Hinf 1) as (T' & HT').
set (b := Rmax T' (T + 1)). assert (B1 : T' <= b) by apply Rmax_l. assert (B2 : T + 1 <= b) by apply Rmax_r.
assert (V1 := HT T (Rle_refl _)). apply Rabs_def2 in V1. assert (V2 := HT' b B1).
destruct (IVT_cor (sol_l a1 a2 a3 eps C) T b) as (t0 & Ht0 & E0).
{ apply sol_l_cont; auto. }
{ lra. }
{ nra. }
destruct (Hc t0 ltac:(lra)) as (P1 & P2).
exists t0. refine (conj E0 (conj _ (conj _ P2))).
- intros t Ht. rewrite <- E0. apply Hinc, Ht.
- intros t Ht. apply P1, Ht.
Qed.

End Cases.

(** The trivial solution as printed in the paper (modelSysDistZY: zbar = ybar/2 = - eps^2 a2/(a1 - a3)) has the wrong
    sign: with modelSysDistP, B, V it satisfies the contact equations at no time, unless a2 a3 = 0. *)
Theorem printed_trivial_wrong (a1 a2 a3 eps t : R) : 0 < eps -> a1 <> a3 -> a2 <> 0 -> a3 <> 0 ->
  ~ model_at a1 a2 a3 eps linear_force (fun t => a1 * t) (fun t => a2 / (a1 - a3) * a1 * t)
     (fun _ => 2 * (- eps ^ 2 * a2 / (a1 - a3))) (fun _ => 0) (fun _ => - eps ^ 2 * a2 / (a1 - a3)) t.
Proof.
intros He H13 H2 H3 (_ & D & _).
assert (D' : is_derive (fun t => a2 / (a1 - a3) * a1 * t) t (a2 / (a1 - a3) * a1)).
{ auto_derive; auto; ring. }
assert (E : a2 / (a1 - a3) * a1 = a2 - a3 * linear_force eps (2 * (- eps ^ 2 * a2 / (a1 - a3)))
  (- eps ^ 2 * a2 / (a1 - a3))).
{ transitivity (Derive (fun t => a2 / (a1 - a3) * a1 * t) t). symmetry; apply is_derive_unique; exact D'.
  apply is_derive_unique; exact D. }
replace (linear_force eps (2 * (- eps ^ 2 * a2 / (a1 - a3))) (- eps ^ 2 * a2 / (a1 - a3))) with (a2 / (a1 - a3)) in E
  by (unfold linear_force; field; split; lra).
set (q := a2 / (a1 - a3)) in *.
assert (Eq : a2 = q * (a1 - a3)) by (unfold q; field; lra).
assert (E2 : 2 * a2 * a3 = 0) by (rewrite Eq in *; nra).
apply Rmult_integral in E2. destruct E2 as [E2|E2]; lra.
Qed.
