(** * The compliant model: the flight after the lift-off of a slow motion

    On a slow motion z grows less than e^(-t/eps) at t -> -oo, and z e^(t/eps) does not increase in contact: so z <= 0
    when contact ends ([slow_z_nonpositive]). For 1 < beta < 2 and a2 < 0 the motion of the mechanism therefore has
    exactly one flight, and a touch-down ([slow_flight]). *)

From Coq Require Import Reals Psatz Lra Lia.
From Coquelicot Require Import Coquelicot.
From GSpot Require Import Statement StatementCompliant Calculus GammaFunction LaplaceIntegral Family CompliantKernel
  CompliantSlow CompliantMechanism
  CompliantCone CompliantUnique CompliantDependence CompliantMotion CompliantSlowMotion CompliantFlight.
Open Scope R_scope.

Section Moderate.
Variable eps : R.
Hypothesis Heps : 0 < eps.

(** Growth of at most e^(-t/(4 eps)) at t -> -oo. *)
Definition moderate (f : R -> R) : Prop := exists A T, 0 <= A /\ forall t, t <= T ->
  Rabs (f t) <= A * exp (- t / (4 * eps)).

Lemma moderate_ext f g : (forall t, f t = g t) -> moderate f -> moderate g.
Proof. intros E (A & T & HA & H). exists A, T. split; auto. intros t Ht. rewrite <- E. auto. Qed.

Lemma moderate_plus f g : moderate f -> moderate g -> moderate (fun t => f t + g t).
Proof.
intros (A & T & HA & H) (B & T' & HB & H'). exists (A + B), (Rmin T T'). split. lra. intros t Ht.
assert (M1 := Rmin_l T T'). assert (M2 := Rmin_r T T').
eapply Rle_trans. apply Rabs_triang. specialize (H t ltac:(lra)). specialize (H' t ltac:(lra)). lra.
Qed.

Lemma moderate_scal k f : moderate f -> moderate (fun t => k * f t).
Proof.
intros (A & T & HA & H). exists (Rabs k * A), T. split. apply Rmult_le_pos; auto using Rabs_pos.
intros t Ht. rewrite Rabs_mult, Rmult_assoc. apply Rmult_le_compat_l; auto using Rabs_pos.
Qed.

Lemma moderate_product f : (exists A T, forall t, t <= T -> Rabs (f t) <= A * exp (- t / (8 * eps))) ->
  moderate f /\ moderate (fun t => t * f t).
Proof.
intros (A & T & H).
assert (HE : forall t, t <= 0 -> 1 <= exp (- t / (8 * eps)) /\ - t / (8 * eps) <= exp (- t / (8 * eps)) /\
  exp (- t / (4 * eps)) = exp (- t / (8 * eps)) * exp (- t / (8 * eps))).
{ intros t Ht. assert (0 <= - t / (8 * eps)) by (apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; lra]).
  generalize (exp_ineq1_le (- t / (8 * eps))). intros. rewrite <- exp_plus. repeat split; try lra. f_equal. field.
  lra. }
assert (HA : forall t, t <= Rmin T 0 -> Rabs (f t) <= Rabs A * exp (- t / (8 * eps))).
{ intros t Ht. assert (M1 := Rmin_l T 0). eapply Rle_trans. apply H. lra.
  apply Rmult_le_compat_r. apply Rlt_le, exp_pos. apply Rle_abs. }
assert (A0 := Rabs_pos A). assert (M2 := Rmin_r T 0).
split.
- exists (Rabs A), (Rmin T 0). split; auto. intros t Ht. destruct (HE t ltac:(lra)) as (E1 & _ & ->).
  specialize (HA t Ht). set (X := exp (- t / (8 * eps))) in *.
  assert (0 <= Rabs A * (X * (X - 1))) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]). lra.
- exists (Rabs A * (8 * eps)), (Rmin T 0). split. apply Rmult_le_pos; lra. intros t Ht.
  destruct (HE t ltac:(lra)) as (E1 & E2 & ->).
  specialize (HA t Ht). set (X := exp (- t / (8 * eps))) in *. rewrite Rabs_mult, (Rabs_left1 t) by lra.
  assert (E3 : - t <= 8 * eps * X).
  { replace (- t) with (8 * eps * (- t / (8 * eps))) by (field; lra). apply Rmult_le_compat_l; lra. }
  replace (Rabs A * (8 * eps) * (X * X)) with (8 * eps * X * (Rabs A * X)) by ring.
  apply Rmult_le_compat; auto using Rabs_pos. lra.
Qed.

(** z' <= - z/eps up to t1, and z is moderate: z(t1) <= 0. *)
Lemma nonpositive_from_left (z force : R -> R) t1 : moderate z ->
  (forall t, t <= t1 -> is_derive (fun s => eps * z s) t (- z t - eps ^ 2 * force t)) ->
    (forall t, t <= t1 -> 0 <= force t) -> z t1 <= 0.
Proof.
intros (A & T & HA & H) D Hf. apply Rnot_lt_le. intros Hpos.
set (c := z t1 * exp (t1 / eps)). assert (Hc : 0 < c) by (apply Rmult_lt_0_compat; [auto|apply exp_pos]).
set (t := Rmin (Rmin T t1) (- (4 * eps / 3) * (A / c))).
assert (T1 : t <= Rmin T t1) by apply Rmin_l. assert (T2 : t <= - (4 * eps / 3) * (A / c)) by apply Rmin_r.
assert (T3 := Rmin_l T t1). assert (T4 := Rmin_r T t1).
assert (W := z_weighted eps t t1 z force Heps ltac:(lra) (fun s Hs => D s (proj2 Hs)) (fun s Hs => Hf s (proj2 Hs))).
fold c in W.
specialize (H t ltac:(lra)). assert (Hz := Rle_abs (z t)).
set (x := - (3 * t / (4 * eps))).
assert (Ex : exp (- t / (4 * eps)) * exp (t / eps) * exp x = 1).
{ rewrite <- !exp_plus. replace (- t / (4 * eps) + t / eps + x) with 0 by (unfold x; field; lra). apply exp_0. }
assert (Hx : A / c <= x).
{ unfold x. apply Rmult_le_reg_l with (4 * eps / 3). lra.
  replace (4 * eps / 3 * - (3 * t / (4 * eps))) with (- t) by (field; lra). lra. }
assert (X1 := exp_ineq1_le x).
assert (B : c <= A * exp (- t / (4 * eps)) * exp (t / eps)).
{ eapply Rle_trans. exact W. apply Rmult_le_compat_r. apply Rlt_le, exp_pos. lra. }
assert (B' : c * exp x <= A).
{ apply (Rmult_le_compat_r (exp x)) in B; [|apply Rlt_le, exp_pos].
  replace (A * exp (- t / (4 * eps)) * exp (t / eps) * exp x) with (A * (exp (- t / (4 * eps)) * exp (t / eps) * exp x))
    in B by ring.
  rewrite Ex in B. lra. }
assert (B2 : c * (1 + x) <= c * exp x) by (apply Rmult_le_compat_l; lra).
assert (B3 : c * (A / c) <= c * x) by (apply Rmult_le_compat_l; lra).
replace (c * (A / c)) with A in B3 by (field; lra). lra.
Qed.

End Moderate.

Section SlowFlight.
Variables (a1 a2 a3 eps C : R).
Hypothesis Hpar : parameters a1 a3 eps.
Let H1 := par1 a1 a3 eps Hpar.
Let H3 := par3 a1 a3 eps Hpar.
Let He := par_eps a1 a3 eps Hpar.
Let Hb := par_beta a1 a3 eps Hpar.
Variables P B Y V Z : R -> R.
Hypothesis HS : slow_motion a1 a2 a3 eps C P B Y V Z.

Lemma hb_moderate n : moderate eps (hb a1 a3 eps C n) /\ moderate eps (fun t => t * hb a1 a3 eps C n t).
Proof.
apply moderate_product; auto.
destruct (Fe_small (- a1 * eps) (a3 / a1) (He' a1 eps H1 He) Hb n) as (A & T & H).
assert (Hn : 0 < eps ^ n) by (apply pow_lt, He).
exists (Rabs (C / eps ^ n) * A), (eps * T). intros t Ht. unfold hb.
replace (C * Derive_n (Fe (- a1 * eps) (a3 / a1)) n (t / eps) / eps ^ n)
  with (C / eps ^ n * Derive_n (Fe (- a1 * eps) (a3 / a1)) n (t / eps)) by (field; lra).
rewrite Rabs_mult, Rmult_assoc. apply Rmult_le_compat_l. apply Rabs_pos.
replace (- t / (8 * eps)) with (- (t / eps) / 8) by (field; lra). apply H.
apply Rmult_le_reg_l with eps; auto. replace (eps * (t / eps)) with t by (field; lra). exact Ht.
Qed.

Lemma slow_z_moderate : moderate eps Z.
Proof.
set (h := hb a1 a3 eps C).
apply (moderate_ext eps (fun t => eps ^ 2 * a2 / (a1 - a3) * 1
  + (eps ^ 2 * h 0%nat t + (- (eps ^ 2 * a1 / a3) * (t * h 1%nat t)
  + (eps ^ 2 / a3 * h 1%nat t + (- (eps ^ 3 / a3) * h 2%nat t + - (eps ^ 4 / a3) * h 3%nat t)))))).
- intros t. destruct (slow_motion_is_sol a1 a2 a3 eps Hpar C P B Y V Z HS t) as (_ & _ & _ & _ & -> & _).
  unfold sol_z, rec_z. fold h. assert (A13 := a13 a1 a3 H1 Hb). field. split; lra.
- repeat apply moderate_plus; apply moderate_scal; try apply hb_moderate.
  exists 1, 0. split. lra. intros t Ht. rewrite Rabs_R1, Rmult_1_l.
  assert (0 <= - t / (4 * eps)) by (apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; lra]).
  generalize (exp_ineq1_le (- t / (4 * eps))). lra.
Qed.

Theorem slow_z_nonpositive t1 : (forall t, t <= t1 -> Y t <= Z t) -> Z t1 <= 0.
Proof.
intros H. apply (nonpositive_from_left eps He Z (fun t => linear_force eps (Y t) (Z t)) t1 slow_z_moderate).
- intros t _. destruct HS as (_ & Hm & _). apply (Hm t).
- intros t Ht. unfold linear_force. specialize (H t Ht). apply Rmult_le_pos. lra.
  apply Rlt_le, Rinv_0_lt_compat, pow_lt, He.
Qed.

(** At lift-off the gap increases at a positive rate: the force has a slope other than 0. *)
Lemma slow_lift_off_rate t1 : 1 < a3 / a1 < 2 -> C < 0 -> Y t1 = Z t1 -> 0 < V t1 + Z t1 / eps.
Proof.
intros Hbeta HC E.
destruct (sol_l_slope a1 a3 eps C H1 H3 He Hb t1 (proj2 Hbeta)) as (q & Hq & Eq).
assert (D := sol_l_derive a1 a2 a3 eps C H1 H3 He Hb t1). rewrite Eq in D.
assert (HG : 0 < Gamma (- (a3 / a1))) by (apply Gamma_12; lra).
destruct HS as (_ & Hm & _). destruct (Hm t1) as (_ & _ & Dy & _ & Dz).
assert (E0 : linear_force eps (Y t1) (Z t1) = 0) by (unfold linear_force; rewrite E; field; lra).
rewrite E0 in Dz. apply (z_derive eps He) in Dz.
assert (D' : is_derive (sol_l a1 a2 a3 eps C) t1 (/ eps ^ 2 * (/ eps * (- Z t1 - eps ^ 2 * 0) - V t1))).
{ apply (is_derive_ext (fun t => / eps ^ 2 * (Z t - Y t))).
  - intros t. rewrite <- (slow_force a1 a2 a3 eps Hpar C P B Y V Z HS t). unfold linear_force, Rdiv.
    match goal with |- ?x = ?y => change (@eq R x y) end. ring.
  - apply (is_derive_scal (fun t => Z t - Y t)). apply (is_derive_minus Z Y); auto. }
assert (EE : q * (C * Gamma (- (a3 / a1))) = / eps ^ 2 * (/ eps * (- Z t1 - eps ^ 2 * 0) - V t1)).
{ rewrite <- (is_derive_unique _ _ _ D). apply is_derive_unique, D'. }
assert (N : 0 < eps ^ 2 * (q * (- C * Gamma (- (a3 / a1))))).
{ apply Rmult_lt_0_compat. apply pow_lt, He. apply Rmult_lt_0_compat; auto. apply Rmult_lt_0_compat; lra. }
replace (eps ^ 2 * (q * (- C * Gamma (- (a3 / a1))))) with (- (eps ^ 2 * (q * (C * Gamma (- (a3 / a1)))))) in N by ring.
rewrite EE in N. replace (V t1 + Z t1 / eps) with (- (eps ^ 2 * (/ eps ^ 2 * (/ eps * (- Z t1 - eps ^ 2 * 0) - V t1))))
  by (field; lra).
exact N.
Qed.

Theorem slow_flight t0 p b y v z : 1 < a3 / a1 < 2 -> C < 0 -> a2 < 0 -> Y t0 < Z t0 ->
  (forall t, t0 <= t -> model_at a1 a2 a3 eps contact_force p b y v z t) ->
  p t0 = P t0 -> b t0 = B t0 -> y t0 = Y t0 -> v t0 = V t0 -> z t0 = Z t0 ->
  exists t1 t2 d, t0 < t1 < t2 /\ 0 < d /\ (forall t, t0 <= t < t1 -> y t < z t) /\ y t1 = z t1 /\
    0 < v t1 + z t1 / eps /\ z t1 <= 0 /\
    (forall t, t1 < t < t2 -> z t < y t) /\ y t2 = z t2 /\ v t2 + z t2 / eps < 0 /\
      (forall t, t2 < t < t2 + d -> y t < z t).
Proof.
intros Hbeta HC H2 Hyz Hm Ep Eb Ey Ev Ez.
destruct (lift_off_compliant a1 a2 a3 eps Hpar C P B Y V Z HS t0) as (_ & t1 & H01 & E1 & Hbefore & _).
{ right. split; auto. lra. } { exact Hyz. }
assert (Hle : forall t, t <= t1 -> Y t <= Z t).
{ intros t Ht. destruct (Rle_lt_or_eq_dec _ _ Ht) as [Hl|E]. apply Rlt_le, Hbefore, Hl. rewrite E. lra. }
assert (HM : forall t, t0 <= t <= t1 -> model_at a1 a2 a3 eps contact_force P B Y V Z t).
{ intros t Ht. destruct HS as (_ & HM & _). specialize (HM t). unfold model_at in *.
  rewrite contact_force_in_contact; auto. unfold linear_force. specialize (Hle t (proj2 Ht)).
  apply Rmult_le_pos. lra. apply Rlt_le, Rinv_0_lt_compat, pow_lt, He. }
assert (U := forward_unique a1 a2 a3 eps He p b y v z P B Y V Z t0 t1 (fun s Hs => Hm s (proj1 Hs)) HM Ep Eb Ey Ev Ez).
destruct (U t1 ltac:(lra)) as (_ & _ & Fy & Fv & Fz).
assert (Hz : z t1 <= 0) by (rewrite Fz; apply slow_z_nonpositive, Hle).
assert (Hup : 0 < v t1 + z t1 / eps) by (rewrite Fv, Fz; apply slow_lift_off_rate; auto).
assert (Et : y t1 = z t1) by congruence.
destruct (flight_ends a1 a2 a3 eps He p b y v z t1 (fun t Ht => Hm t ltac:(lra)) Et Hup Hz (or_introl H2))
  as (t2 & d & H12 & Hd & Hfly & E2 & Hdown & Hafter & _).
exists t1, t2, d.
refine (conj (conj H01 H12)
  (conj Hd (conj _ (conj Et (conj Hup (conj Hz (conj Hfly (conj E2 (conj Hdown Hafter))))))))).
intros t Ht. destruct (U t ltac:(lra)) as (_ & _ & -> & _ & ->). apply Hbefore. lra.
Qed.

End SlowFlight.
